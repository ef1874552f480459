/* tmodes, built from f0312ced11d0d7c8; BSD-3-Clause */
/* three
The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
/* uplot
The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
/* ml-matrix
The MIT License (MIT)

Copyright (c) 2014 Michaël Zasso

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
/* is-any-array
The MIT License (MIT)

Copyright (c) 2018 cheminfo

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
/* ml-array-rescale
MIT License

Copyright (c) 2017 mljs

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
/* ml-array-max
MIT License

Copyright (c) 2017 ml.js

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
/* ml-array-min
MIT License

Copyright (c) 2017 mljs

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
"use strict";(()=>{function lt(r,t={},...e){let n=document.createElement(r);for(let[i,s]of Object.entries(t))i==="text"?n.textContent=String(s):s!==void 0&&s!==!1&&n.setAttribute(i,s===!0?"":s);return n.append(...e.filter(i=>i!==null)),n}function Tn(r,t,e={}){let n=lt("button",{type:"button",text:r,...e});return n.addEventListener("click",t),n}function Rn(r,t){r.textContent!==t&&(r.textContent=t)}function lc(r,t,e=2){let n="http://www.w3.org/2000/svg",i=document.createElementNS(n,"svg"),s=document.createElementNS(n,"line"),o={x1:0,y1:5,x2:26,y2:5,"stroke-width":e,"stroke-dasharray":t.join(" ")};for(let[a,l]of Object.entries(o))s.setAttribute(a,String(l));s.style.stroke=r;for(let[a,l]of Object.entries({width:26,height:10,"aria-hidden":"true"}))i.setAttribute(a,String(l));return i.append(s),i}var tg=0;function qr(r){return tg+=1,`tm-${r}-${tg}`}function Po(r,t,e){let n=URL.createObjectURL(new Blob([r],{type:e}));lt("a",{href:n,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}var Bb="TMPK";function eg(r){if(new TextDecoder().decode(r.subarray(0,4))!==Bb)throw new Error("these bytes are no data of tmodes");let e=new DataView(r.buffer,r.byteOffset,r.byteLength).getUint32(4,!0),n=JSON.parse(new TextDecoder().decode(r.subarray(8,8+e))),i=8*Math.ceil((8+e)/8),s=n.arrays.map(o=>zb(r,i,o));return cc(n.page,s)}function zb(r,t,e){let n=e.shape.reduce((o,a)=>o*a,1),i=Number(e.dtype[1]),s=r.slice(t+e.offset,t+e.offset+n*i).buffer;return e.dtype==="f8"?{data:new Float64Array(s),shape:e.shape}:e.dtype==="d4"?{data:Gb(new Uint8Array(s),n,e),shape:e.shape}:e.dtype==="i4"?{data:new Int32Array(s),shape:e.shape}:e.dtype==="u1"?{data:new Uint8Array(s),shape:e.shape}:{data:Vb(new Uint8Array(s),n,e),shape:e.shape}}function Vb(r,t,{shape:e,scale:n=1,start:i=0}){let s=t/(e[0]||1)||1,o=new Int16Array(t);for(let a=0;a<t;a++)o[a]=(r[a]|r[t+a]<<8)+(a>=s?o[a-s]:0);return Float32Array.from(o,a=>i+n*a)}function Gb(r,t,{shape:e}){let n=t/(e[0]||1)||1,i=new Uint32Array(t);for(let s=0;s<t;s++){let o=r[s]|r[t+s]<<8|r[2*t+s]<<16|r[3*t+s]<<24;i[s]=o+(s>=n?i[s-n]:0)}return new Float32Array(i.buffer)}function cc(r,t){if(Array.isArray(r))return r.map(n=>cc(n,t));if(r===null||typeof r!="object")return r;let e=Object.entries(r);return e.length===1&&e[0][0]==="$array"?t[e[0][1]]:e.length===1&&e[0][0]==="$sum"?Hb(cc(e[0][1],t)):Object.fromEntries(e.map(([n,i])=>[n,cc(i,t)]))}function Hb([r,t]){return{data:Float32Array.from(r.data,(e,n)=>e+t.data[n]),shape:r.shape}}async function ng(r){let t=Uint8Array.from(atob(r.trim()),n=>n.charCodeAt(0)),e=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(e).arrayBuffer())}function ig(r){let t=new Set,e=0,n=0,i=()=>t.forEach(l=>l(a)),s={time:0,duration:r,playing:!1},o=l=>{let c=Math.min(.25,(l-n)/1e3);n=l,s.time+=c*a.speed,s.time>=s.duration&&(s.time=0),i(),s.playing&&(e=requestAnimationFrame(o))},a={get time(){return s.time},get duration(){return s.duration},get playing(){return s.playing},speed:1,seek(l){s.time=Math.min(Math.max(l,0),s.duration),i()},play(){s.playing||(s.playing=!0,n=performance.now(),e=requestAnimationFrame(o),i())},pause(){s.playing=!1,cancelAnimationFrame(e),i()},toggle(){s.playing?a.pause():a.play()},setDuration(l){s.duration=l,a.seek(s.time)},subscribe(l){return t.add(l),()=>t.delete(l)}};return a}var Wb=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],qb=["m","rad","s"],Xb=["Hz","%","rad/s"],$b="⁰¹²³⁴⁵⁶⁷⁸⁹";function Ff(r){let t=r.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(t)?"":t}function Ze(r,t=4){return r===0?"0":String(Number(r.toPrecision(t)))}function rg(r){if(r===0)return"0";let[t,e]=r.toExponential(1).split("e"),n=[...String(Number(e))].map(i=>i==="-"?"⁻":$b[Number(i)]).join("");return`${t} × 10${n}`}function Nf(r,t){let e=Ff(r);if(!e||Xb.includes(r)||!(t>0))return{factor:1,name:e};let n=qb.includes(r.split("/")[0]),i=Wb.find(([s,o])=>t>=s&&(o>=1||!n));return i?{factor:i[1],name:i[2]+e}:{factor:1,name:e}}function qn(r,t){if(r===null||!Number.isFinite(r))return"–";let e=Math.abs(r),{factor:n,name:i}=Nf(t,e);return`${e>0&&(n===1?e<.001:e<1e-11)?rg(r):Ze(r*n)} ${i}`.trimEnd()}function ui(r){let t=Math.abs(r);return t!==0&&(t<.001||t>=1e6)?rg(r):Ze(r)}function sg(r,t,e,n){let[i,s]=n??e.span??[r[0],r[r.length-1]],o=1e-9*Math.max(1,Math.abs(s)),a=Yb(r,Array.from(r.keys()).filter(m=>r[m]>=i-o&&r[m]<=s+o)),l=Float64Array.from(a,m=>t[m]),c=l.length;if(c<4)return{x:new Float64Array,y:new Float64Array};let u=(r[a[c-1]]-r[a[0]])/(c-1),h=jb(l),f=2**Math.ceil(Math.log2(4*c)),d=new Float64Array(f),p=new Float64Array(f);d.set(l),Zb(d,p);let y=e.at.data[e.at.data.length-1],g=Math.min(f/2,Math.floor(y*f*u)+1);return{x:Float64Array.from({length:g},(m,x)=>x/(f*u)),y:Float64Array.from({length:g},(m,x)=>2*Math.hypot(d[x],p[x])/h)}}function Yb(r,t){if(t.length<3)return t;let e=i=>r[t[i]]-r[t[i-1]];return Math.abs(e(t.length-1)/e(1)-1)>1e-6?t.slice(0,-1):t}function jb(r){let t=r.length,e=(t-1)/2,n=r.reduce((a,l)=>a+l,0)/t,i=t*(t*t-1)/12,s=r.reduce((a,l,c)=>a+(c-e)*l,0)/i,o=0;for(let a=0;a<t;a+=1){let l=.5-.5*Math.cos(2*Math.PI*a/t);r[a]=l*(r[a]-n-s*(a-e)),o+=l}return o}function Zb(r,t){let e=r.length;for(let i=1,s=0;i<e;i+=1){let o=e>>1;for(;s&o;o>>=1)s^=o;s^=o,i<s&&([r[i],r[s]]=[r[s],r[i]],[t[i],t[s]]=[t[s],t[i]])}let n=Kb(e);for(let i=2;i<=e;i*=2)Jb(r,t,i,n)}var Io=new Float64Array;function Kb(r){if(Io.length===r)return Io;Io=new Float64Array(r);for(let t=0;t<r/2;t+=1)Io[2*t]=Math.cos(2*Math.PI*t/r),Io[2*t+1]=-Math.sin(2*Math.PI*t/r);return Io}function Jb(r,t,e,n){let i=e/2,s=2*r.length/e;for(let o=0;o<r.length;o+=e)for(let a=0;a<i;a+=1){let l=o+a,c=l+i,u=n[s*a],h=n[s*a+1],f=r[c]*u-t[c]*h,d=r[c]*h+t[c]*u;r[c]=r[l]-f,t[c]=t[l]-d,r[l]+=f,t[l]+=d}}function lg(r){let t=new Map;return r.runs.forEach((e,n)=>e.charts.forEach(i=>{let s=t.get(i.id);s?s.runs.push({run:n,name:e.name,chart:i}):t.set(i.id,{chart:i,runs:[{run:n,name:e.name,chart:i}],compared:r.runs.length>1})})),[...t.values()]}function Df(r,t){let e=r.runs.flatMap(({run:s,name:o,chart:a})=>a.curves.map(l=>({run:s,runName:o,label:l.label,role:l.role,x:a.at.data,y:l.values.data,shown:l.shown&&(r.runs.length<2||Qb(l,a)),ghost:t!==null&&s===0})));if(t===null)return e;let n=r.runs.find(({run:s})=>s===0),i=(n?.chart.curves??[]).flatMap(s=>tw(s,n.chart,n.name,t));return[...e,...i]}function Qb(r,t){return r.role==="real"&&r.label===t.curves[0].label}function tw(r,t,e,n){let i=ew(r,n);if(i===null)return[];let s={run:0,runName:e,label:r.label,role:r.role,shown:r.shown,ghost:!1};if(t.abscissa==="time")return[{...s,x:n.times,y:i}];let o=null,a=()=>o??=sg(n.times,i,t,n.span);return[Object.defineProperties(s,{x:{get:()=>a().x},y:{get:()=>a().y}})]}function cg(r,t,e){return r.chart.group==="spectrum"&&t.vibration!==e.vibration?!1:r.runs.flatMap(({chart:i})=>i.curves.flatMap(({source:s})=>s?[s.variable,s.less?.variable??s.variable]:[])).every(i=>t.series[i]===e.series[i])}function ew(r,t){let e=r.source;if(e===null)return null;let n=og(t,e.variable,e.index),i=e.less?og(t,e.less.variable,e.less.index):null;if(n===null||e.less&&i===null)return null;for(let s=0;s<n.length;s+=1)n[s]=e.factor*(n[s]-(i?i[s]:0));return n}function og(r,t,e){let n=r.series[t];if(n===void 0)return null;let i=n.shape.slice(1).reduce((o,a)=>o*a,1);if(e>=i)return null;let s=new Float64Array(n.shape[0]);for(let o=0;o<s.length;o+=1)s[o]=n.data[o*i+e];return s}function uc(r,t){let e=[...new Set(r.map(i=>i.x))],n=e.every(i=>ug(i,e[0]))?e[0]:nw(e);return[n,...r.map(i=>iw(i,n,t))]}function ug(r,t){if(r===t)return!0;if(r.length!==t.length)return!1;for(let e=0;e<r.length;e+=1)if(Math.abs(r[e]-t[e])>1e-6*Math.abs(t[e]))return!1;return!0}function nw(r){let t=r.flatMap(e=>Array.from(e)).sort((e,n)=>e-n);return t.filter((e,n)=>n===0||e>t[n-1])}function iw(r,t,e){let n=o=>e?o===0?null:Math.abs(o):o;if(t===r.x||ug(t,r.x))return e?Array.from(r.y,n):r.y;let s=new Array(t.length).fill(null);for(let o=0,a=0;o<r.x.length;o+=1){for(;a<t.length&&t[a]<r.x[o];)a+=1;a<t.length&&(s[a]=n(r.y[o]))}return s}function hg(r,t){let{x:e,y:n}=r,i=e.length-1;if(i<0||t<e[0]-1e-9||t>e[i]+1e-6*Math.abs(e[i])+1e-9)return null;let s=0,o=i;for(;o-s>1;){let a=s+o>>1;e[a]<=t?s=a:o=a}return o===s||t>=e[o]?n[o]:n[s]+(n[o]-n[s])*(t-e[s])/(e[o]-e[s])}var ag=new WeakMap;function hc(r){let t=ag.get(r);if(t)return t;let[e,n]=[1/0,-1/0];for(let s=0;s<r.length;s+=1){let o=r[s];Number.isFinite(o)&&(o<e&&(e=o),o>n&&(n=o))}let i=e<=n?[e,n]:[0,0];return ag.set(r,i),i}function Uf(r,t,e){let n=e.filter(i=>!i.ghost).map(i=>{let[s,o]=hc(i.y);return`${i.label} ${i.role}, from ${ui(s)} to ${ui(o)} ${t}`.trim()});return`${r.title}: ${n.join("; ")||"no curve is shown"}.`}function Of(r){return r.runs.map(t=>t.chart).reduce((t,e)=>fc(e)<fc(t)?e:t)}function fc(r){return r.at.data.length/r.samples}function fg(r){let[t,e]=[r.at.data.length,r.samples].map(n=>n.toLocaleString("en"));return`Drawn by ${t} of ${e} samples; every extreme is kept.`}function dg(r,t,e){let[n,...i]=uc(r,!1),s=new Set(r.map(l=>l.run)).size>1,o=r.map(l=>`${[s?l.runName:"",l.label,l.role,l.ghost?"original":""].filter(Boolean).join(" ")} [${e||"-"}]`),a=Array.from(n,(l,c)=>[l,...i.map(u=>u[c]??"")].map(rw).join(","));return`${[t,...o].map(sw).join(",")}
${a.join(`
`)}
`}function rw(r){return typeof r=="string"?r:String(Number(r.toPrecision(9)))}function sw(r){return`"${(/^[=+\-@\t\r]/.test(r)?`'${r}`:r).replaceAll('"','""')}"`}function kf(r,t){return r.group==="spectrum"&&typeof t?.vibration=="object"?t.vibration.marks:null}function pg(r,t){let e=Math.max(0,...t.map(n=>n.x[n.x.length-1]??0));return r.filter(({at:n})=>n<=e)}var mg=["--blue","--red","--green","--violet","--ochre","--sky"],ow={real:"--blue",reference:"--red",rigid:"--quiet",stationary:"--green",oscillatory:"--violet",limit:"--quiet",other:"--ochre"},gg={real:[],reference:[6,3],rigid:[2,3],stationary:[9,2,2,2],oscillatory:[2,2],limit:[1,3],other:[10,3]},yg=[[],[7,2],[6,2,2,2],[2,2],[9,2,2,2,2,2],[12,4]],vg={real:"real",reference:"reference",rigid:"rigid",stationary:"stationary part",oscillatory:"oscillatory part",limit:"limit",other:"other"};function ka(r,t,e,n){if(!e)return{property:ow[r],dash:gg[r]};let i=n>1?gg[r]:yg[t%yg.length];return{property:mg[t%mg.length],dash:i}}var Bf=new Map,xg=null,_g=!1;function Ar(r){xg??=matchMedia("(prefers-color-scheme: dark)");let t=xg.matches&&!document.documentElement.classList.contains("printing");t!==_g&&Bf.clear(),_g=t;let e=Bf.get(r)??getComputedStyle(document.documentElement).getPropertyValue(r).trim();return Bf.set(r,e),e||"#808080"}function bg(r,t,e){let n=r.filter(d=>!d.ghost),i=[d=>String(d.run),d=>d.label,d=>d.role],s=i.map(d=>[...new Set(n.map(d))]),o=i.map((d,p)=>new Set(s[p].filter(y=>!n.some(g=>g.shown&&d(g)===y)))),a=t?0:s[1].length>1?1:2,l=s[2].length,c=d=>{let p=a===0&&s[1].length>1&&l===1?s[1].length:l,y=a===0?d.run:s[a].indexOf(i[a](d)),g=ka(d.role,y,a<2,p);return a===0&&l===1?{...g,dash:ka("real",s[1].indexOf(d.label),!0,1).dash}:g},u=lt("div",{class:"legend"}),h=new Map;i.forEach((d,p)=>{if(s[p].length<2&&p!==a)return;let y=lt("div",{class:"legend-row",role:"group","aria-label":["Runs","Curves","Parts"][p]});for(let g of s[p]){let m=n.find(x=>d(x)===g);m&&y.append(f(m,g,p))}u.append(y)});function f(d,p,y){let g=y===0?d.runName:y===2&&l>1?vg[d.role]:d.label,m=y===a?c(d):{property:"--quiet",dash:y===2?c(d).dash:[]},x=lc(`var(${m.property})`,y===a&&a<2&&l>1?[]:m.dash),w=lt("span",{class:"value"}),_=lt("button",{type:"button",class:"toggle","aria-pressed":String(!o[y].has(p))},x,lt("span",{text:g}),w);return y===a&&h.set(p,w),_.addEventListener("click",()=>{o[y].delete(p)||o[y].add(p),_.setAttribute("aria-pressed",String(!o[y].has(p))),e()}),_}return{element:u,look:c,renew(d){n=d.filter(p=>!p.ghost)},shows:d=>i.every((p,y)=>!o[y].has(p(d))),tell(d){for(let[p,y]of h){let g=n.find(x=>i[a](x)===p&&i.every((w,_)=>!o[_].has(w(x)))),m=g?d(g):null;Rn(y,m===null?"":ui(m).replace("-","−"))}}}}var aw="uplot",lw="u-hz",cw="u-vt",uw="u-title",hw="u-wrap",fw="u-under",dw="u-over",pw="u-axis",qs="u-off",mw="u-select",gw="u-cursor-x",yw="u-cursor-y",xw="u-cursor-pt",_w="u-legend",vw="u-live",bw="u-inline",ww="u-series",Mw="u-marker",wg="u-label",Sw="u-value",za="width",Va="height";var Mg="bottom",Lo="left",zf="right",id="#000",Sg=id+"0",Vf="mousemove",Ag="mousedown",Gf="mouseup",Eg="mouseenter",Tg="mouseleave",Rg="dblclick",Aw="resize",Ew="scroll",Cg="change",yc="dppxchange",rd="--",Bo=typeof window<"u",$f=Bo?document:null,No=Bo?window:null,Tw=Bo?navigator:null,Ae,dc;function Yf(){let r=devicePixelRatio;Ae!=r&&(Ae=r,dc&&Zf(Cg,dc,Yf),dc=matchMedia(`(min-resolution: ${Ae-.001}dppx) and (max-resolution: ${Ae+.001}dppx)`),Xs(Cg,dc,Yf),No.dispatchEvent(new CustomEvent(yc)))}function Ai(r,t){if(t!=null){let e=r.classList;!e.contains(t)&&e.add(t)}}function jf(r,t){let e=r.classList;e.contains(t)&&e.remove(t)}function Ke(r,t,e){r.style[t]=e+"px"}function ir(r,t,e,n){let i=$f.createElement(r);return t!=null&&Ai(i,t),e?.insertBefore(i,n),i}function Gi(r,t){return ir("div",r,t)}var Pg=new WeakMap;function Er(r,t,e,n,i){let s="translate("+t+"px,"+e+"px)",o=Pg.get(r);s!=o&&(r.style.transform=s,Pg.set(r,s),t<0||e<0||t>n||e>i?Ai(r,qs):jf(r,qs))}var Ig=new WeakMap;function Lg(r,t,e){let n=t+e,i=Ig.get(r);n!=i&&(Ig.set(r,n),r.style.background=t,r.style.borderColor=e)}var Fg=new WeakMap;function Ng(r,t,e,n){let i=t+""+e,s=Fg.get(r);i!=s&&(Fg.set(r,i),r.style.height=e+"px",r.style.width=t+"px",r.style.marginLeft=n?-t/2+"px":0,r.style.marginTop=n?-e/2+"px":0)}var sd={passive:!0},Rw={...sd,capture:!0};function Xs(r,t,e,n){t.addEventListener(r,e,n?Rw:sd)}function Zf(r,t,e,n){t.removeEventListener(r,e,sd)}Bo&&Yf();function rr(r,t,e,n){let i;e=e||0,n=n||t.length-1;let s=n<=2147483647;for(;n-e>1;)i=s?e+n>>1:Ei((e+n)/2),t[i]<r?e=i:n=i;return r-t[e]<=t[n]-r?e:n}function l0(r){return(e,n,i)=>{let s=-1,o=-1;for(let a=n;a<=i;a++)if(r(e[a])){s=a;break}for(let a=i;a>=n;a--)if(r(e[a])){o=a;break}return[s,o]}}var c0=r=>r!=null,u0=r=>r!=null&&r>0,vc=l0(c0),Cw=l0(u0);function Pw(r,t,e,n=0,i=!1){let s=i?Cw:vc,o=i?u0:c0;[t,e]=s(r,t,e);let a=r[t],l=r[t];if(t>-1)if(n==1)a=r[t],l=r[e];else if(n==-1)a=r[e],l=r[t];else for(let c=t;c<=e;c++){let u=r[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??ze,l??-ze]}function bc(r,t,e,n){let i=Og(r),s=Og(t);r==t&&(i==-1?(r*=e,t/=e):(r/=e,t*=e));let o=e==10?Xr:h0,a=i==1?Ei:Hi,l=s==1?Hi:Ei,c=a(o(Pn(r))),u=l(o(Pn(t))),h=Do(e,c),f=Do(e,u);return e==10&&(c<0&&(h=Ve(h,-c)),u<0&&(f=Ve(f,-u))),n||e==2?(r=h*i,t=f*s):(r=m0(r,h),t=wc(t,f)),[r,t]}function od(r,t,e,n){let i=bc(r,t,e,n);return r==0&&(i[0]=0),t==0&&(i[1]=0),i}var ad=.1,Dg={mode:3,pad:ad},Ha={pad:0,soft:null,mode:0},Iw={min:Ha,max:Ha};function xc(r,t,e,n){return Mc(e)?Ug(r,t,e):(Ha.pad=e,Ha.soft=n?0:null,Ha.mode=n?3:0,Ug(r,t,Iw))}function Me(r,t){return r??t}function Lw(r,t,e){for(t=Me(t,0),e=Me(e,r.length-1);t<=e;){if(r[t]!=null)return!0;t++}return!1}function Ug(r,t,e){let n=e.min,i=e.max,s=Me(n.pad,0),o=Me(i.pad,0),a=Me(n.hard,-ze),l=Me(i.hard,ze),c=Me(n.soft,ze),u=Me(i.soft,-ze),h=Me(n.mode,0),f=Me(i.mode,0),d=t-r,p=Xr(d),y=hi(Pn(r),Pn(t)),g=Xr(y),m=Pn(g-p);(d<1e-24||m>10)&&(d=0,(r==0||t==0)&&(d=1e-24,h==2&&c!=ze&&(s=0),f==2&&u!=-ze&&(o=0)));let x=d||y||1e3,w=Xr(x),_=Do(10,Ei(w)),E=x*(d==0?r==0?.1:1:s),S=Ve(m0(r-E,_/10),24),v=r>=c&&(h==1||h==3&&S<=c||h==2&&S>=c)?c:ze,b=hi(a,S<v&&r>=v?v:sr(v,S)),N=x*(d==0?t==0?.1:1:o),C=Ve(wc(t+N,_/10),24),I=t<=u&&(f==1||f==3&&C>=u||f==2&&C<=u)?u:-ze,U=sr(l,C>I&&t<=I?I:hi(I,C));return b==U&&b==0&&(U=100),[b,U]}var Fw=new Intl.NumberFormat(Bo?Tw.language:"en-US"),ld=r=>Fw.format(r),Ti=Math,gc=Ti.PI,Pn=Ti.abs,Ei=Ti.floor,Cn=Ti.round,Hi=Ti.ceil,sr=Ti.min,hi=Ti.max,Do=Ti.pow,Og=Ti.sign,Xr=Ti.log10,h0=Ti.log2,Nw=(r,t=1)=>Ti.sinh(r)*t,Hf=(r,t=1)=>Ti.asinh(r/t),ze=1/0;function kg(r){return(Xr((r^r>>31)-(r>>31))|0)+1}function Kf(r,t,e){return sr(hi(r,t),e)}function f0(r){return typeof r=="function"}function xe(r){return f0(r)?r:()=>r}var Dw=()=>{},d0=r=>r,p0=(r,t)=>t,Uw=r=>null,Bg=r=>!0,zg=(r,t)=>r==t,Ow=/\.\d*?(?=9{6,}|0{6,})/gm,$s=r=>{if(y0(r)||ms.has(r))return r;let t=`${r}`,e=t.match(Ow);if(e==null)return r;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[i,s]=t.split("e");return+`${$s(i)}e${s}`}return Ve(r,n)};function Hs(r,t){return $s(Ve($s(r/t))*t)}function wc(r,t){return $s(Hi($s(r/t))*t)}function m0(r,t){return $s(Ei($s(r/t))*t)}function Ve(r,t=0){if(y0(r))return r;let e=10**t,n=r*e*(1+Number.EPSILON);return Cn(n)/e}var ms=new Map;function g0(r){return((""+r).split(".")[1]||"").length}function qa(r,t,e,n){let i=[],s=n.map(g0);for(let o=t;o<e;o++){let a=Pn(o),l=Ve(Do(r,o),a);for(let c=0;c<n.length;c++){let u=r==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=r==10?u:Ve(u,h);i.push(f),ms.set(f,h)}}return i}var Wa={},cd=[],Uo=[null,null],ps=Array.isArray,y0=Number.isInteger,kw=r=>r===void 0;function Vg(r){return typeof r=="string"}function Mc(r){let t=!1;if(r!=null){let e=r.constructor;t=e==null||e==Object}return t}function Bw(r){return r!=null&&typeof r=="object"}var zw=Object.getPrototypeOf(Uint8Array),x0="__proto__";function Oo(r,t=Mc){let e;if(ps(r)){let n=r.find(i=>i!=null);if(ps(n)||t(n)){e=Array(r.length);for(let i=0;i<r.length;i++)e[i]=Oo(r[i],t)}else e=r.slice()}else if(r instanceof zw)e=r.slice();else if(t(r)){e={};for(let n in r)n!=x0&&(e[n]=Oo(r[n],t))}else e=r;return e}function bn(r){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let i in n)i!=x0&&(Mc(r[i])?bn(r[i],Oo(n[i])):r[i]=Oo(n[i]))}return r}var Vw=0,Gw=1,Hw=2;function Ww(r,t,e){for(let n=0,i,s=-1;n<t.length;n++){let o=t[n];if(o>s){for(i=o-1;i>=0&&r[i]==null;)r[i--]=null;for(i=o+1;i<e&&r[i]==null;)r[s=i++]=null}}}function qw(r,t){if(Yw(r)){let o=r[0].slice();for(let a=1;a<r.length;a++)o.push(...r[a].slice(1));return jw(o[0])||(o=$w(o)),o}let e=new Set;for(let o=0;o<r.length;o++){let l=r[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],i=n[0].length,s=new Map;for(let o=0;o<i;o++)s.set(n[0][o],o);for(let o=0;o<r.length;o++){let a=r[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(i).fill(void 0),f=t?t[o][c]:Gw,d=[];for(let p=0;p<u.length;p++){let y=u[p],g=s.get(l[p]);y===null?f!=Vw&&(h[g]=y,f==Hw&&d.push(g)):h[g]=y}Ww(h,d,i),n.push(h)}}return n}var Xw=typeof queueMicrotask>"u"?r=>Promise.resolve().then(r):queueMicrotask;function $w(r){let t=r[0],e=t.length,n=Array(e);for(let s=0;s<n.length;s++)n[s]=s;n.sort((s,o)=>t[s]-t[o]);let i=[];for(let s=0;s<r.length;s++){let o=r[s],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];i.push(a)}return i}function Yw(r){let t=r[0][0],e=t.length;for(let n=1;n<r.length;n++){let i=r[n][0];if(i.length!=e)return!1;if(i!=t){for(let s=0;s<e;s++)if(i[s]!=t[s])return!1}}return!0}function jw(r,t=100){let e=r.length;if(e<=1)return!0;let n=0,i=e-1;for(;n<=i&&r[n]==null;)n++;for(;i>=n&&r[i]==null;)i--;if(i<=n)return!0;let s=hi(1,Ei((i-n+1)/t));for(let o=r[n],a=n+s;a<=i;a+=s){let l=r[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var _0=["January","February","March","April","May","June","July","August","September","October","November","December"],v0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function b0(r){return r.slice(0,3)}var Zw=v0.map(b0),Kw=_0.map(b0),Jw={MMMM:_0,MMM:Kw,WWWW:v0,WWW:Zw};function Ba(r){return(r<10?"0":"")+r}function Qw(r){return(r<10?"00":r<100?"0":"")+r}var t1={YYYY:r=>r.getFullYear(),YY:r=>(r.getFullYear()+"").slice(2),MMMM:(r,t)=>t.MMMM[r.getMonth()],MMM:(r,t)=>t.MMM[r.getMonth()],MM:r=>Ba(r.getMonth()+1),M:r=>r.getMonth()+1,DD:r=>Ba(r.getDate()),D:r=>r.getDate(),WWWW:(r,t)=>t.WWWW[r.getDay()],WWW:(r,t)=>t.WWW[r.getDay()],HH:r=>Ba(r.getHours()),H:r=>r.getHours(),h:r=>{let t=r.getHours();return t==0?12:t>12?t-12:t},AA:r=>r.getHours()>=12?"PM":"AM",aa:r=>r.getHours()>=12?"pm":"am",a:r=>r.getHours()>=12?"p":"a",mm:r=>Ba(r.getMinutes()),m:r=>r.getMinutes(),ss:r=>Ba(r.getSeconds()),s:r=>r.getSeconds(),fff:r=>Qw(r.getMilliseconds())};function ud(r,t){t=t||Jw;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,i;for(;i=n.exec(r);)e.push(i[0][0]=="{"?t1[i[1]]:i[0]);return s=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](s,t);return o}}var e1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function n1(r,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+r+r.getTimezoneOffset()*6e4):t==e1?e=r:(e=new Date(r.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(r.getMilliseconds())),e}var w0=r=>r%1==0,_c=[1,2,2.5,5],i1=qa(10,-32,0,_c),M0=qa(10,0,32,_c),r1=M0.filter(w0),Ws=i1.concat(M0),hd=`
`,S0="{YYYY}",Gg=hd+S0,A0="{M}/{D}",Ga=hd+A0,pc=Ga+"/{YY}",E0="{aa}",s1="{h}:{mm}",Fo=s1+E0,Hg=hd+Fo,Wg=":{ss}",Te=null;function T0(r){let t=r*1e3,e=t*60,n=e*60,i=n*24,s=i*30,o=i*365,l=(r==1?qa(10,0,3,_c).filter(w0):qa(10,-3,0,_c)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,i,i*2,i*3,i*4,i*5,i*6,i*7,i*8,i*9,i*10,i*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,S0,Te,Te,Te,Te,Te,Te,1],[i*28,"{MMM}",Gg,Te,Te,Te,Te,Te,1],[i,A0,Gg,Te,Te,Te,Te,Te,1],[n,"{h}"+E0,pc,Te,Ga,Te,Te,Te,1],[e,Fo,pc,Te,Ga,Te,Te,Te,1],[t,Wg,pc+" "+Fo,Te,Ga+" "+Fo,Te,Hg,Te,1],[r,Wg+".{fff}",pc+" "+Fo,Te,Ga+" "+Fo,Te,Hg,Te,1]];function u(h){return(f,d,p,y,g,m)=>{let x=[],w=g>=o,_=g>=s&&g<o,E=h(p),S=Ve(E*r,3),v=Wf(E.getFullYear(),w?0:E.getMonth(),_||w?1:E.getDate()),b=Ve(v*r,3);if(_||w){let N=_?g/s:0,C=w?g/o:0,I=S==b?S:Ve(Wf(v.getFullYear()+C,v.getMonth()+N,1)*r,3),U=new Date(Cn(I/r)),B=U.getFullYear(),F=U.getMonth();for(let V=0;I<=y;V++){let q=Wf(B+C*V,F+N*V,1),G=q-h(Ve(q*r,3));I=Ve((+q+G)*r,3),I<=y&&x.push(I)}}else{let N=g>=i?i:g,C=Ei(p)-Ei(S),I=b+C+wc(S-b,N);x.push(I);let U=h(I),B=U.getHours()+U.getMinutes()/e+U.getSeconds()/n,F=g/n,V=f.axes[d]._space,q=m/V;for(;I=Ve(I+g,r==1?0:3),!(I>y);)if(F>1){let G=Ei(Ve(B+F,6))%24,j=h(I).getHours()-G;j>1&&(j=-1),I-=j*n,B=(B+F)%24;let tt=x[x.length-1];Ve((I-tt)/g,3)*q>=.7&&x.push(I)}else x.push(I)}return x}}return[l,c,u]}var[o1,a1,l1]=T0(1),[c1,u1,h1]=T0(.001);qa(2,-53,53,[1]);function qg(r,t){return r.map(e=>e.map((n,i)=>i==0||i==8||n==null?n:t(i==1||e[8]==0?n:e[1]+n)))}function Xg(r,t){return(e,n,i,s,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,f,d;return n.map(p=>{let y=r(p),g=y.getFullYear(),m=y.getMonth(),x=y.getDate(),w=y.getHours(),_=y.getMinutes(),E=y.getSeconds(),S=g!=l&&a[2]||m!=c&&a[3]||x!=u&&a[4]||w!=h&&a[5]||_!=f&&a[6]||E!=d&&a[7]||a[1];return l=g,c=m,u=x,h=w,f=_,d=E,S(y)})}}function f1(r,t){let e=ud(t);return(n,i,s,o,a)=>i.map(l=>e(r(l)))}function Wf(r,t,e){return new Date(r,t,e)}function $g(r,t){return t(r)}var d1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Yg(r,t){return(e,n,i,s)=>s==null?rd:t(r(n))}function p1(r,t){let e=r.series[t];return e.width?e.stroke(r,t):e.points.width?e.points.stroke(r,t):null}function m1(r,t){return r.series[t].fill(r,t)}var g1={show:!0,live:!0,isolate:!1,mount:Dw,markers:{show:!0,width:2,stroke:p1,fill:m1,dash:"solid"},idx:null,idxs:null,values:[]};function y1(r,t){let e=r.cursor.points,n=Gi(),i=e.size(r,t);Ke(n,za,i),Ke(n,Va,i);let s=i/-2;Ke(n,"marginLeft",s),Ke(n,"marginTop",s);let o=e.width(r,t,i);return o&&Ke(n,"borderWidth",o),n}function x1(r,t){let e=r.series[t].points;return e._fill||e._stroke}function _1(r,t){let e=r.series[t].points;return e._stroke||e._fill}function v1(r,t){return r.series[t].points.size}var qf=[0,0];function b1(r,t,e){return qf[0]=t,qf[1]=e,qf}function mc(r,t,e,n=!0){return i=>{i.button==0&&(!n||i.target==t)&&e(i)}}function Xf(r,t,e,n=!0){return i=>{(!n||i.target==t)&&e(i)}}var w1={show:!0,x:!0,y:!0,lock:!1,move:b1,points:{one:!1,show:y1,size:v1,width:0,stroke:_1,fill:x1},bind:{mousedown:mc,mouseup:mc,click:mc,dblclick:mc,mousemove:Xf,mouseleave:Xf,mouseenter:Xf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(r,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(r,t,e,n,i)=>n-i,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},R0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},fd=bn({},R0,{filter:p0}),C0=bn({},fd,{size:10}),P0=bn({},R0,{show:!1}),dd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',I0="bold "+dd,L0=1.5,jg={show:!0,scale:"x",stroke:id,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:I0,side:2,grid:fd,ticks:C0,border:P0,font:dd,lineGap:L0,rotate:0},M1="Value",S1="Time",Zg={show:!0,scale:"x",auto:!1,sorted:1,min:ze,max:-ze,idxs:[]};function A1(r,t,e,n,i){return t.map(s=>s==null?"":ld(s))}function E1(r,t,e,n,i,s,o){let a=[],l=ms.get(i)||0;e=o?e:Ve(wc(e,i),l);for(let c=e;c<=n;c=Ve(c+i,l))a.push(Object.is(c,-0)?0:c);return a}function Jf(r,t,e,n,i,s,o){let a=[],l=r.scales[r.axes[t].scale].log,c=l==10?Xr:h0,u=Ei(c(e));i=Do(l,u),l==10&&(i=Ws[rr(i,Ws)]);let h=e,f=i*l;l==10&&(f=Ws[rr(f,Ws)]);do a.push(h),h=h+i,l==10&&!ms.has(h)&&(h=Ve(h,ms.get(i))),h>=f&&(i=h,f=i*l,l==10&&(f=Ws[rr(f,Ws)]));while(h<=n);return a}function T1(r,t,e,n,i,s,o){let l=r.scales[r.axes[t].scale].asinh,c=n>l?Jf(r,t,hi(l,e),n,i):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?Jf(r,t,hi(l,-n),-e,i):[l]).reverse().map(f=>-f).concat(u,c)}var F0=/./,R1=/[12357]/,C1=/[125]/,Kg=/1/,Qf=(r,t,e,n)=>r.map((i,s)=>t==4&&i==0||s%n==0&&e.test(i.toExponential()[i<0?1:0])?i:null);function P1(r,t,e,n,i){let s=r.axes[e],o=s.scale,a=r.scales[o],l=r.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?F0:l(7,o)-u>=c?R1:l(5,o)-u>=c?C1:Kg;if(h==Kg){let f=Pn(l(1,o)-u);if(f<c)return Qf(t.slice().reverse(),a.distr,h,Hi(c/f)).reverse()}return Qf(t,a.distr,h,1)}function I1(r,t,e,n,i){let s=r.axes[e],o=s.scale,a=s._space,l=r.valToPos,c=Pn(l(1,o)-l(2,o));return c<a?Qf(t.slice().reverse(),3,F0,Hi(a/c)).reverse():t}function L1(r,t,e,n){return n==null?rd:t==null?"":ld(t)}var Jg={show:!0,scale:"y",stroke:id,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:I0,side:3,grid:fd,ticks:C0,border:P0,font:dd,lineGap:L0,rotate:0};function F1(r,t){let e=3+(r||1)*2;return Ve(e*t,3)}function N1(r,t){let{scale:e,idxs:n}=r.series[0],i=r._data[0],s=r.valToPos(i[n[0]],e,!0),o=r.valToPos(i[n[1]],e,!0),a=Pn(o-s),l=r.series[t],c=a/(l.points.space*Ae);return n[1]-n[0]<=c}var Qg={scale:null,auto:!0,sorted:0,min:ze,max:-ze},N0=(r,t,e,n,i)=>i,t0={show:!0,auto:!0,sorted:0,gaps:N0,alpha:1,facets:[bn({},Qg,{scale:"x"}),bn({},Qg,{scale:"y"})]},e0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:N0,alpha:1,points:{show:N1,filter:null},values:null,min:ze,max:-ze,idxs:[],path:null,clip:null};function D1(r,t,e,n,i){return e/10}var D0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},U1=bn({},D0,{time:!1,ori:1}),n0={};function U0(r,t){let e=n0[r];return e||(e={key:r,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(i=>i!=n)},pub(n,i,s,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=i&&e.plots[u].pub(n,i,s,o,a,l,c)}},r!=null&&(n0[r]=e)),e}var ko=1,td=2;function Ys(r,t,e){let n=r.mode,i=r.series[t],s=n==2?r._data[t]:r._data,o=r.scales,a=r.bbox,l=s[0],c=n==2?s[1]:s[t],u=n==2?o[i.facets[0].scale]:o[r.series[0].scale],h=n==2?o[i.facets[1].scale]:o[i.scale],f=a.left,d=a.top,p=a.width,y=a.height,g=r.valToPosH,m=r.valToPosV;return u.ori==0?e(i,l,c,u,h,g,m,f,d,p,y,Ac,zo,Tc,k0,z0):e(i,l,c,u,h,m,g,d,f,y,p,Ec,Vo,gd,B0,V0)}function pd(r,t){let e=0,n=0,i=Me(r.bands,cd);for(let s=0;s<i.length;s++){let o=i[s];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function O1(r,t,e,n,i){let s=r.mode,o=r.series[t],a=s==2?o.facets[1].scale:o.scale,l=r.scales[a];return i==-1?l.min:i==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function $r(r,t,e,n,i,s){return Ys(r,t,(o,a,l,c,u,h,f,d,p,y,g)=>{let m=o.pxRound,x=c.dir*(c.ori==0?1:-1),w=c.ori==0?zo:Vo,_,E;x==1?(_=e,E=n):(_=n,E=e);let S=m(h(a[_],c,y,d)),v=m(f(l[_],u,g,p)),b=m(h(a[E],c,y,d)),N=m(f(s==1?u.max:u.min,u,g,p)),C=new Path2D(i);return w(C,b,N),w(C,S,N),w(C,S,v),C})}function Sc(r,t,e,n,i,s){let o=null;if(r.length>0){o=new Path2D;let a=t==0?Tc:gd,l=e;for(let h=0;h<r.length;h++){let f=r[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+s),l=f[1]}}let c=e+i-l,u=10;c>0&&a(o,l,n-u/2,c,n+s+u)}return o}function k1(r,t,e){let n=r[r.length-1];n&&n[0]==t?n[1]=e:r.push([t,e])}function md(r,t,e,n,i,s,o){let a=[],l=r.length;for(let c=i==1?e:n;c>=e&&c<=n;c+=i)if(t[c]===null){let h=c,f=c;if(i==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=s(r[h]),p=f==h?d:s(r[f]),y=h-i;d=o<=0&&y>=0&&y<l?s(r[y]):d;let m=f+i;p=o>=0&&m>=0&&m<l?s(r[m]):p,p>=d&&a.push([d,p])}return a}function i0(r){return r==0?d0:r==1?Cn:t=>Hs(t,r)}function O0(r){let t=r==0?Ac:Ec,e=r==0?(i,s,o,a,l,c)=>{i.arcTo(s,o,a,l,c)}:(i,s,o,a,l,c)=>{i.arcTo(o,s,l,a,c)},n=r==0?(i,s,o,a,l)=>{i.rect(s,o,a,l)}:(i,s,o,a,l)=>{i.rect(o,s,l,a)};return(i,s,o,a,l,c=0,u=0)=>{c==0&&u==0?n(i,s,o,a,l):(c=sr(c,a/2,l/2),u=sr(u,a/2,l/2),t(i,s+c,o),e(i,s+a,o,s+a,o+l,c),e(i,s+a,o+l,s,o+l,u),e(i,s,o+l,s,o,u),e(i,s,o,s+a,o,c),i.closePath())}}var Ac=(r,t,e)=>{r.moveTo(t,e)},Ec=(r,t,e)=>{r.moveTo(e,t)},zo=(r,t,e)=>{r.lineTo(t,e)},Vo=(r,t,e)=>{r.lineTo(e,t)},Tc=O0(0),gd=O0(1),k0=(r,t,e,n,i,s)=>{r.arc(t,e,n,i,s)},B0=(r,t,e,n,i,s)=>{r.arc(e,t,n,i,s)},z0=(r,t,e,n,i,s,o)=>{r.bezierCurveTo(t,e,n,i,s,o)},V0=(r,t,e,n,i,s,o)=>{r.bezierCurveTo(e,t,i,n,o,s)};function G0(r){return(t,e,n,i,s)=>Ys(t,e,(o,a,l,c,u,h,f,d,p,y,g)=>{let{pxRound:m,points:x}=o,w,_;c.ori==0?(w=Ac,_=k0):(w=Ec,_=B0);let E=Ve(x.width*Ae,3),S=(x.size-x.width)/2*Ae,v=Ve(S*2,3),b=new Path2D,N=new Path2D,{left:C,top:I,width:U,height:B}=t.bbox;Tc(N,C-v,I-v,U+v*2,B+v*2);let F=V=>{if(l[V]!=null){let q=m(h(a[V],c,y,d)),G=m(f(l[V],u,g,p));w(b,q+S,G),_(b,q,G,S,0,gc*2)}};if(s)s.forEach(F);else for(let V=n;V<=i;V++)F(V);return{stroke:E>0?b:null,fill:b,clip:N,flags:ko|td}})}function H0(r){return(t,e,n,i,s,o)=>{n!=i&&(s!=n&&o!=n&&r(t,e,n),s!=i&&o!=i&&r(t,e,i),r(t,e,o))}}var B1=H0(zo),z1=H0(Vo);function W0(r){let t=Me(r?.alignGaps,0);return(e,n,i,s)=>Ys(e,n,(o,a,l,c,u,h,f,d,p,y,g)=>{[i,s]=vc(l,i,s);let m=o.pxRound,x=B=>m(h(B,c,y,d)),w=B=>m(f(B,u,g,p)),_,E;c.ori==0?(_=zo,E=B1):(_=Vo,E=z1);let S=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ko},b=v.stroke,N=!1;if(s-i>=y*4){let B=ct=>e.posToVal(ct,c.key,!0),F=null,V=null,q,G,rt,$=x(a[S==1?i:s]),j=x(a[i]),tt=x(a[s]),ut=B(S==1?j+1:tt-1);for(let ct=S==1?i:s;ct>=i&&ct<=s;ct+=S){let J=a[ct],yt=(S==1?J<ut:J>ut)?$:x(J),Mt=l[ct];yt==$?Mt!=null?(G=Mt,F==null?(_(b,yt,w(G)),q=F=V=G):G<F?F=G:G>V&&(V=G)):Mt===null&&(N=!0):(F!=null&&E(b,$,w(F),w(V),w(q),w(G)),Mt!=null?(G=Mt,_(b,yt,w(G)),F=V=q=G):(F=V=null,Mt===null&&(N=!0)),$=yt,ut=B($+S))}F!=null&&F!=V&&rt!=$&&E(b,$,w(F),w(V),w(q),w(G))}else for(let B=S==1?i:s;B>=i&&B<=s;B+=S){let F=l[B];F===null?N=!0:F!=null&&_(b,x(a[B]),w(F))}let[I,U]=pd(e,n);if(o.fill!=null||I!=0){let B=v.fill=new Path2D(b),F=o.fillTo(e,n,o.min,o.max,I),V=w(F),q=x(a[i]),G=x(a[s]);S==-1&&([G,q]=[q,G]),_(B,G,V),_(B,q,V)}if(!o.spanGaps){let B=[];N&&B.push(...md(a,l,i,s,S,x,t)),v.gaps=B=o.gaps(e,n,i,s,B),v.clip=Sc(B,c.ori,d,p,y,g)}return U!=0&&(v.band=U==2?[$r(e,n,i,s,b,-1),$r(e,n,i,s,b,1)]:$r(e,n,i,s,b,U)),v})}function V1(r){let t=Me(r.align,1),e=Me(r.ascDesc,!1),n=Me(r.alignGaps,0),i=Me(r.extend,!1);return(s,o,a,l)=>Ys(s,o,(c,u,h,f,d,p,y,g,m,x,w)=>{[a,l]=vc(h,a,l);let _=c.pxRound,{left:E,width:S}=s.bbox,v=j=>_(p(j,f,x,g)),b=j=>_(y(j,d,w,m)),N=f.ori==0?zo:Vo,C={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ko},I=C.stroke,U=f.dir*(f.ori==0?1:-1),B=b(h[U==1?a:l]),F=v(u[U==1?a:l]),V=F,q=F;i&&t==-1&&(q=E,N(I,q,B)),N(I,F,B);for(let j=U==1?a:l;j>=a&&j<=l;j+=U){let tt=h[j];if(tt==null)continue;let ut=v(u[j]),ct=b(tt);t==1?N(I,ut,B):N(I,V,ct),N(I,ut,ct),B=ct,V=ut}let G=V;i&&t==1&&(G=E+S,N(I,G,B));let[rt,$]=pd(s,o);if(c.fill!=null||rt!=0){let j=C.fill=new Path2D(I),tt=c.fillTo(s,o,c.min,c.max,rt),ut=b(tt);N(j,G,ut),N(j,q,ut)}if(!c.spanGaps){let j=[];j.push(...md(u,h,a,l,U,v,n));let tt=c.width*Ae/2,ut=e||t==1?tt:-tt,ct=e||t==-1?-tt:tt;j.forEach(J=>{J[0]+=ut,J[1]+=ct}),C.gaps=j=c.gaps(s,o,a,l,j),C.clip=Sc(j,f.ori,g,m,x,w)}return $!=0&&(C.band=$==2?[$r(s,o,a,l,I,-1),$r(s,o,a,l,I,1)]:$r(s,o,a,l,I,$)),C})}function r0(r,t,e,n,i,s,o=ze){if(r.length>1){let a=null;for(let l=0,c=1/0;l<r.length;l++)if(t[l]!==void 0){if(a!=null){let u=Pn(r[l]-r[a]);u<c&&(c=u,o=Pn(e(r[l],n,i,s)-e(r[a],n,i,s)))}a=l}}return o}function G1(r){r=r||Wa;let t=Me(r.size,[.6,ze,1]),e=r.align||0,n=r.gap||0,i=r.radius;i=i==null?[0,0]:typeof i=="number"?[i,0]:i;let s=xe(i),o=1-t[0],a=Me(t[1],ze),l=Me(t[2],1),c=Me(r.disp,Wa),u=Me(r.each,d=>{}),{fill:h,stroke:f}=c;return(d,p,y,g)=>Ys(d,p,(m,x,w,_,E,S,v,b,N,C,I)=>{let U=m.pxRound,B=e,F=n*Ae,V=a*Ae,q=l*Ae,G,rt;_.ori==0?[G,rt]=s(d,p):[rt,G]=s(d,p);let $=_.dir*(_.ori==0?1:-1),j=_.ori==0?Tc:gd,tt=_.ori==0?u:(Pt,Kt,le,At,Be,Gt,jt)=>{u(Pt,Kt,le,Be,At,jt,Gt)},ut=Me(d.bands,cd).find(Pt=>Pt.series[0]==p),ct=ut!=null?ut.dir:0,J=m.fillTo(d,p,m.min,m.max,ct),gt=U(v(J,E,I,N)),yt,Mt,xt,zt=C,te=U(m.width*Ae),dt=!1,Wt=null,qt=null,Yt=null,ve=null;h!=null&&(te==0||f!=null)&&(dt=!0,Wt=h.values(d,p,y,g),qt=new Map,new Set(Wt).forEach(Pt=>{Pt!=null&&qt.set(Pt,new Path2D)}),te>0&&(Yt=f.values(d,p,y,g),ve=new Map,new Set(Yt).forEach(Pt=>{Pt!=null&&ve.set(Pt,new Path2D)})));let{x0:Ue,size:mn}=c;if(Ue!=null&&mn!=null){B=1,x=Ue.values(d,p,y,g),Ue.unit==2&&(x=x.map(le=>d.posToVal(b+le*C,_.key,!0)));let Pt=mn.values(d,p,y,g);mn.unit==2?Mt=Pt[0]*C:Mt=S(Pt[0],_,C,b)-S(0,_,C,b),zt=r0(x,w,S,_,C,b,zt),xt=zt-Mt+F}else zt=r0(x,w,S,_,C,b,zt),xt=zt*o+F,Mt=zt-xt;xt<1&&(xt=0),te>=Mt/2&&(te=0),xt<5&&(U=d0);let Oe=xt>0,Nn=zt-xt-(Oe?te:0);Mt=U(Kf(Nn,q,V)),yt=(B==0?Mt/2:B==$?0:Mt)-B*$*((B==0?F/2:0)+(Oe?te/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},An=dt?null:new Path2D,rn=null;if(ut!=null)rn=d.data[ut.series[1]];else{let{y0:Pt,y1:Kt}=c;Pt!=null&&Kt!=null&&(w=Kt.values(d,p,y,g),rn=Pt.values(d,p,y,g))}let gn=G*Mt,k=rt*Mt;for(let Pt=$==1?y:g;Pt>=y&&Pt<=g;Pt+=$){let Kt=w[Pt];if(Kt==null)continue;if(rn!=null){let X=rn[Pt]??0;if(Kt-X==0)continue;gt=v(X,E,I,N)}let le=_.distr!=2||c!=null?x[Pt]:Pt,At=S(le,_,C,b),Be=v(Me(Kt,J),E,I,N),Gt=U(At-yt),jt=U(hi(Be,gt)),P=U(sr(Be,gt)),A=jt-P;if(Kt!=null){let X=Kt<0?k:gn,ft=Kt<0?gn:k;dt?(te>0&&Yt[Pt]!=null&&j(ve.get(Yt[Pt]),Gt,P+Ei(te/2),Mt,hi(0,A-te),X,ft),Wt[Pt]!=null&&j(qt.get(Wt[Pt]),Gt,P+Ei(te/2),Mt,hi(0,A-te),X,ft)):j(An,Gt,P+Ei(te/2),Mt,hi(0,A-te),X,ft),tt(d,p,Pt,Gt-te/2,P,Mt+te,A)}}return te>0?be.stroke=dt?ve:An:dt||(be._fill=m.width==0?m._fill:m._stroke??m._fill,be.width=0),be.fill=dt?qt:An,be})}function H1(r,t){let e=Me(t?.alignGaps,0);return(n,i,s,o)=>Ys(n,i,(a,l,c,u,h,f,d,p,y,g,m)=>{[s,o]=vc(c,s,o);let x=a.pxRound,w=G=>x(f(G,u,g,p)),_=G=>x(d(G,h,m,y)),E,S,v;u.ori==0?(E=Ac,v=zo,S=z0):(E=Ec,v=Vo,S=V0);let b=u.dir*(u.ori==0?1:-1),N=w(l[b==1?s:o]),C=N,I=[],U=[];for(let G=b==1?s:o;G>=s&&G<=o;G+=b)if(c[G]!=null){let $=l[G],j=w($);I.push(C=j),U.push(_(c[G]))}let B={stroke:r(I,U,E,v,S,x),fill:null,clip:null,band:null,gaps:null,flags:ko},F=B.stroke,[V,q]=pd(n,i);if(a.fill!=null||V!=0){let G=B.fill=new Path2D(F),rt=a.fillTo(n,i,a.min,a.max,V),$=_(rt);v(G,C,$),v(G,N,$)}if(!a.spanGaps){let G=[];G.push(...md(l,c,s,o,b,w,e)),B.gaps=G=a.gaps(n,i,s,o,G),B.clip=Sc(G,u.ori,p,y,g,m)}return q!=0&&(B.band=q==2?[$r(n,i,s,o,F,-1),$r(n,i,s,o,F,1)]:$r(n,i,s,o,F,q)),B})}function W1(r){return H1(q1,r)}function q1(r,t,e,n,i,s){let o=r.length;if(o<2)return null;let a=new Path2D;if(e(a,r[0],t[0]),o==2)n(a,r[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=r[f+1]-r[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)i(a,r[f]+h[f]/3,t[f]+l[f]*h[f]/3,r[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,r[f+1],t[f+1])}return a}var ed=new Set;function s0(){for(let r of ed)r.syncRect(!0)}Bo&&(Xs(Aw,No,s0),Xs(Ew,No,s0,!0),Xs(yc,No,()=>{wn.pxRatio=Ae}));var X1=W0(),$1=G0();function o0(r,t,e,n){return(n?[r[0],r[1]].concat(r.slice(2)):[r[0]].concat(r.slice(1))).map((s,o)=>nd(s,o,t,e))}function Y1(r,t){return r.map((e,n)=>n==0?{}:bn({},t,e))}function nd(r,t,e,n){return bn({},t==0?e:n,r)}function q0(r,t,e){return t==null?Uo:[t,e]}var j1=q0;function Z1(r,t,e){return t==null?Uo:xc(t,e,ad,!0)}function X0(r,t,e,n){return t==null?Uo:bc(t,e,r.scales[n].log,!1)}var K1=X0;function $0(r,t,e,n){return t==null?Uo:od(t,e,r.scales[n].log,!1)}var J1=$0;function Q1(r,t,e,n,i){let s=hi(kg(r),kg(t)),o=t-r,a=rr(i/n*o,e);do{let l=e[a],c=n*l/o;if(c>=i&&s+(l<5?ms.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function a0(r){let t,e;return r=r.replace(/(\d+)px/,(n,i)=>(t=Cn((e=+i)*Ae))+"px"),[r,t,e]}function tM(r){r.show&&[r.font,r.labelFont].forEach(t=>{let e=Ve(t[2]*Ae,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function wn(r,t,e){let n={mode:Me(r.mode,1)},i=n.mode;function s(M,T,L,D){let W=T.valToPct(M);return D+L*(T.dir==-1?1-W:W)}function o(M,T,L,D){let W=T.valToPct(M);return D+L*(T.dir==-1?W:1-W)}function a(M,T,L,D){return T.ori==0?s(M,T,L,D):o(M,T,L,D)}n.valToPosH=s,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Gi(aw);if(r.id!=null&&(c.id=r.id),Ai(c,r.class),r.title){let M=Gi(uw,c);M.textContent=r.title}let u=ir("canvas"),h=n.ctx=u.getContext("2d"),f=Gi(hw,c);Xs("click",f,M=>{M.target===p&&($e!=Ao||Qe!=Eo)&&Wn.click(n,M)},!0);let d=n.under=Gi(fw,f);f.appendChild(u);let p=n.over=Gi(dw,f);r=Oo(r);let y=+Me(r.pxAlign,1),g=i0(y);(r.plugins||[]).forEach(M=>{M.opts&&(r=M.opts(n,r)||r)});let m=r.ms||.001,x=n.series=i==1?o0(r.series||[],Zg,e0,!1):Y1(r.series||[null],t0),w=n.axes=o0(r.axes||[],jg,Jg,!0),_=n.scales={},E=n.bands=r.bands||[];E.forEach(M=>{M.fill=xe(M.fill||null),M.dir=Me(M.dir,-1)});let S=i==2?x[1].facets[0].scale:x[0].scale,v={axes:Hr,series:me},b=(r.drawOrder||["axes","series"]).map(M=>v[M]);function N(M){let T=M.distr==3?L=>Xr(L>0?L:M.clamp(n,L,M.min,M.max,M.key)):M.distr==4?L=>Hf(L,M.asinh):M.distr==100?L=>M.fwd(L):L=>L;return L=>{let D=T(L),{_min:W,_max:K}=M,at=K-W;return(D-W)/at}}function C(M){let T=_[M];if(T==null){let L=(r.scales||Wa)[M]||Wa;if(L.from!=null){C(L.from);let D=bn({},_[L.from],L,{key:M});D.valToPct=N(D),_[M]=D}else{T=_[M]=bn({},M==S?D0:U1,L),T.key=M;let D=T.time,W=T.range,K=ps(W);if((M!=S||i==2&&!D)&&(K&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Dg:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Dg:{mode:1,hard:W[1],soft:W[1]}},K=!1),!K&&Mc(W))){let at=W;W=(pt,wt,Nt)=>wt==null?Uo:xc(wt,Nt,at)}T.range=xe(W||(D?j1:M==S?T.distr==3?K1:T.distr==4?J1:q0:T.distr==3?X0:T.distr==4?$0:Z1)),T.auto=xe(K?!1:T.auto),T.clamp=xe(T.clamp||D1),T._min=T._max=null,T.valToPct=N(T)}}}C("x"),C("y"),i==1&&x.forEach(M=>{C(M.scale)}),w.forEach(M=>{C(M.scale)});for(let M in r.scales)C(M);let I=_[S],U=I.distr,B,F;I.ori==0?(Ai(c,lw),B=s,F=o):(Ai(c,cw),B=o,F=s);let V={};for(let M in _){let T=_[M];(T.min!=null||T.max!=null)&&(V[M]={min:T.min,max:T.max},T.min=T.max=null)}let q=r.tzDate||(M=>new Date(Cn(M/m))),G=r.fmtDate||ud,rt=m==1?l1(q):h1(q),$=Xg(q,qg(m==1?a1:u1,G)),j=Yg(q,$g(d1,G)),tt=[],ut=n.legend=bn({},g1,r.legend),ct=n.cursor=bn({},w1,{drag:{y:i==2}},r.cursor),J=ut.show,gt=ct.show,yt=ut.markers;ut.idxs=tt,yt.width=xe(yt.width),yt.dash=xe(yt.dash),yt.stroke=xe(yt.stroke),yt.fill=xe(yt.fill);let Mt,xt,zt,te=[],dt=[],Wt,qt=!1,Yt={};if(ut.live){let M=x[1]?x[1].values:null;qt=M!=null,Wt=qt?M(n,1,0):{_:0};for(let T in Wt)Yt[T]=rd}if(J)if(Mt=ir("table",_w,c),zt=ir("tbody",null,Mt),ut.mount(n,Mt),qt){xt=ir("thead",null,Mt,zt);let M=ir("tr",null,xt);ir("th",null,M);for(var ve in Wt)ir("th",wg,M).textContent=ve}else Ai(Mt,bw),ut.live&&Ai(Mt,vw);let Ue={show:!0},mn={show:!1};function Oe(M,T){if(T==0&&(qt||!ut.live||i==2))return Uo;let L=[],D=ir("tr",ww,zt,zt.childNodes[T]);Ai(D,M.class),M.show||Ai(D,qs);let W=ir("th",null,D);if(yt.show){let pt=Gi(Mw,W);if(T>0){let wt=yt.width(n,T);wt&&(pt.style.border=wt+"px "+yt.dash(n,T)+" "+yt.stroke(n,T)),pt.style.background=yt.fill(n,T)}}let K=Gi(wg,W);M.label instanceof HTMLElement?K.appendChild(M.label):K.textContent=M.label,T>0&&(yt.show||(K.style.color=M.width>0?yt.stroke(n,T):yt.fill(n,T)),be("click",W,pt=>{if(ct._lock)return;ee(pt);let wt=x.indexOf(M);if((pt.ctrlKey||pt.metaKey)!=ut.isolate){let Nt=x.some((Dt,Ot)=>Ot>0&&Ot!=wt&&Dt.show);x.forEach((Dt,Ot)=>{Ot>0&&br(Ot,Nt?Ot==wt?Ue:mn:Ue,!0,vn.setSeries)})}else br(wt,{show:!M.show},!0,vn.setSeries)},!1),ne&&be(Eg,W,pt=>{ct._lock||(ee(pt),br(x.indexOf(M),Ro,!0,vn.setSeries))},!1));for(var at in Wt){let pt=ir("td",Sw,D);pt.textContent="--",L.push(pt)}return[D,L]}let Nn=new Map;function be(M,T,L,D=!0){let W=Nn.get(T)||{},K=ct.bind[M](n,T,L,D);K&&(Xs(M,T,W[M]=K),Nn.set(T,W))}function An(M,T,L){let D=Nn.get(T)||{};for(let W in D)(M==null||W==M)&&(Zf(W,T,D[W]),delete D[W]);M==null&&Nn.delete(T)}let rn=0,gn=0,k=0,Pt=0,Kt=0,le=0,At=Kt,Be=le,Gt=k,jt=Pt,P=0,A=0,X=0,ft=0;n.bbox={};let ot=!1,vt=!1,bt=!1,et=!1,it=!1,mt=!1;function O(M,T,L){(L||M!=n.width||T!=n.height)&&st(M,T),fe(!1),bt=!0,vt=!0,Qn()}function st(M,T){n.width=rn=k=M,n.height=gn=Pt=T,Kt=le=0,St(),Ht();let L=n.bbox;P=L.left=Hs(Kt*Ae,.5),A=L.top=Hs(le*Ae,.5),X=L.width=Hs(k*Ae,.5),ft=L.height=Hs(Pt*Ae,.5)}let nt=3;function Et(){let M=!1,T=0;for(;!M;){T++;let L=wo(T),D=vr(T);M=T==nt||L&&D,M||(st(n.width,n.height),vt=!0)}}function _t({width:M,height:T}){O(M,T)}n.setSize=_t;function St(){let M=!1,T=!1,L=!1,D=!1;w.forEach((W,K)=>{if(W.show&&W._show){let{side:at,_size:pt}=W,wt=at%2,Nt=W.label!=null?W.labelSize:0,Dt=pt+Nt;Dt>0&&(wt?(k-=Dt,at==3?(Kt+=Dt,D=!0):L=!0):(Pt-=Dt,at==0?(le+=Dt,M=!0):T=!0))}}),xr[0]=M,xr[1]=L,xr[2]=T,xr[3]=D,k-=tr[1]+tr[3],Kt+=tr[3],Pt-=tr[2]+tr[0],le+=tr[0]}function Ht(){let M=Kt+k,T=le+Pt,L=Kt,D=le;function W(K,at){switch(K){case 1:return M+=at,M-at;case 2:return T+=at,T-at;case 3:return L-=at,L+at;case 0:return D-=at,D+at}}w.forEach((K,at)=>{if(K.show&&K._show){let pt=K.side;K._pos=W(pt,K._size),K.label!=null&&(K._lpos=W(pt,K.labelSize))}})}if(ct.dataIdx==null){let M=ct.hover,T=M.skip=new Set(M.skip??[]);T.add(void 0);let L=M.prox=xe(M.prox),D=M.bias??=0;ct.dataIdx=(W,K,at,pt)=>{if(K==0)return at;let wt=at,Nt=L(W,K,at,pt)??ze,Dt=Nt>=0&&Nt<ze,Ot=I.ori==0?k:Pt,ae=ct.left,Se=t[0],we=t[K];if(T.has(we[at])){wt=null;let ge=null,Qt=null,Xt;if(D==0||D==-1)for(Xt=at;ge==null&&Xt-- >0;)T.has(we[Xt])||(ge=Xt);if(D==0||D==1)for(Xt=at;Qt==null&&Xt++<we.length;)T.has(we[Xt])||(Qt=Xt);if(ge!=null||Qt!=null)if(Dt){let je=ge==null?-1/0:B(Se[ge],I,Ot,0),an=Qt==null?1/0:B(Se[Qt],I,Ot,0),kn=ae-je,ke=an-ae;kn<=ke?kn<=Nt&&(wt=ge):ke<=Nt&&(wt=Qt)}else wt=Qt==null?ge:ge==null?Qt:at-ge<=Qt-at?ge:Qt}else Dt&&Pn(ae-B(Se[at],I,Ot,0))>Nt&&(wt=null);return wt}}let ee=M=>{ct.event=M};ct.idxs=tt,ct._lock=!1;let ht=ct.points;ht.show=xe(ht.show),ht.size=xe(ht.size),ht.stroke=xe(ht.stroke),ht.width=xe(ht.width),ht.fill=xe(ht.fill);let kt=n.focus=bn({},r.focus||{alpha:.3},ct.focus),ne=kt.prox>=0,Ct=ne&&ht.one,he=[],Xe=[],si=[];function Pa(M,T){let L=ht.show(n,T);if(L instanceof HTMLElement)return Ai(L,xw),Ai(L,M.class),Er(L,-10,-10,k,Pt),p.insertBefore(L,he[T]),L}function _o(M,T){if(i==1||T>0){let L=i==1&&_[M.scale].time,D=M.value;M.value=L?Vg(D)?Yg(q,$g(D,G)):D||j:D||L1,M.label=M.label||(L?S1:M1)}if(Ct||T>0){M.width=M.width==null?1:M.width,M.paths=M.paths||X1||Uw,M.fillTo=xe(M.fillTo||O1),M.pxAlign=+Me(M.pxAlign,y),M.pxRound=i0(M.pxAlign),M.stroke=xe(M.stroke||null),M.fill=xe(M.fill||null),M._stroke=M._fill=M._paths=M._focus=null;let L=F1(hi(1,M.width),1),D=M.points=bn({},{size:L,width:hi(1,L*.2),stroke:M.stroke,space:L*2,paths:$1,_stroke:null,_fill:null},M.points);D.show=xe(D.show),D.filter=xe(D.filter),D.fill=xe(D.fill),D.stroke=xe(D.stroke),D.paths=xe(D.paths),D.pxAlign=M.pxAlign}if(J){let L=Oe(M,T);te.splice(T,0,L[0]),dt.splice(T,0,L[1]),ut.values.push(null)}if(gt){tt.splice(T,0,null);let L=null;Ct?T==0&&(L=Pa(M,T)):T>0&&(L=Pa(M,T)),he.splice(T,0,L),Xe.splice(T,0,0),si.splice(T,0,0)}On("addSeries",T)}function Mf(M,T){T=T??x.length,M=i==1?nd(M,T,Zg,e0):nd(M,T,{},t0),x.splice(T,0,M),_o(x[T],T)}n.addSeries=Mf;function rc(M){if(x.splice(M,1),J){ut.values.splice(M,1),dt.splice(M,1);let T=te.splice(M,1)[0];An(null,T.firstChild),T.remove()}gt&&(tt.splice(M,1),he.splice(M,1)[0].remove(),Xe.splice(M,1),si.splice(M,1)),On("delSeries",M)}n.delSeries=rc;let xr=[!1,!1,!1,!1];function zr(M,T){if(M._show=M.show,M.show){let L=M.side%2,D=_[M.scale];D==null&&(M.scale=L?x[1].scale:S,D=_[M.scale]);let W=D.time;M.size=xe(M.size),M.space=xe(M.space),M.rotate=xe(M.rotate),ps(M.incrs)&&M.incrs.forEach(at=>{!ms.has(at)&&ms.set(at,g0(at))}),M.incrs=xe(M.incrs||(D.distr==2?r1:W?m==1?o1:c1:Ws)),M.splits=xe(M.splits||(W&&D.distr==1?rt:D.distr==3?Jf:D.distr==4?T1:E1)),M.stroke=xe(M.stroke),M.grid.stroke=xe(M.grid.stroke),M.ticks.stroke=xe(M.ticks.stroke),M.border.stroke=xe(M.border.stroke);let K=M.values;M.values=ps(K)&&!ps(K[0])?xe(K):W?ps(K)?Xg(q,qg(K,G)):Vg(K)?f1(q,K):K||$:K||A1,M.filter=xe(M.filter||(D.distr>=3&&D.log==10?P1:D.distr==3&&D.log==2?I1:p0)),M.font=a0(M.font),M.labelFont=a0(M.labelFont),M._size=M.size(n,null,T,0),M._space=M._rotate=M._incrs=M._found=M._splits=M._values=null,M._size>0&&(xr[T]=!0,M._el=Gi(pw,f))}}function Vr(M,T,L,D){let[W,K,at,pt]=L,wt=T%2,Nt=0;return wt==0&&(pt||K)&&(Nt=T==0&&!W||T==2&&!at?Cn(jg.size/3):0),wt==1&&(W||at)&&(Nt=T==1&&!K||T==3&&!pt?Cn(Jg.size/2):0),Nt}let Ia=n.padding=(r.padding||[Vr,Vr,Vr,Vr]).map(M=>xe(Me(M,Vr))),tr=n._padding=Ia.map((M,T)=>M(n,T,xr,0)),sn,fn=null,dn=null,_r=i==1?x[0].idxs:null,bi=null,ls=!1;function La(M,T){if(t=M??[],n.data=n._data=t,i==2){sn=0;for(let L=1;L<x.length;L++)sn+=t[L][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),bi=t[0],sn=bi.length;let L=t;if(U==2){L=t.slice();let D=L[0]=Array(sn);for(let W=0;W<sn;W++)D[W]=W}n._data=t=L}if(fe(!0),On("setData"),U==2&&(bt=!0),T!==!1){let L=I;L.auto(n,ls)?Fa():hs(S,L.min,L.max),et=et||ct.left>=0,mt=!0,Qn()}}n.setData=La;function Fa(){ls=!0;let M,T;i==1&&(sn>0?(fn=_r[0]=0,dn=_r[1]=sn-1,M=t[0][fn],T=t[0][dn],U==2?(M=fn,T=dn):M==T&&(U==3?[M,T]=bc(M,M,I.log,!1):U==4?[M,T]=od(M,M,I.log,!1):I.time?T=M+Cn(86400/m):[M,T]=xc(M,T,ad,!0))):(fn=_r[0]=M=null,dn=_r[1]=T=null)),hs(S,M,T)}let vo,cs,bo,R,H,Q,Y,Z,Tt,Lt;function Rt(M,T,L,D,W,K){M??=Sg,L??=cd,D??="butt",W??=Sg,K??="round",M!=vo&&(h.strokeStyle=vo=M),W!=cs&&(h.fillStyle=cs=W),T!=bo&&(h.lineWidth=bo=T),K!=H&&(h.lineJoin=H=K),D!=Q&&(h.lineCap=Q=D),L!=R&&h.setLineDash(R=L)}function Ft(M,T,L,D){T!=cs&&(h.fillStyle=cs=T),M!=Y&&(h.font=Y=M),L!=Z&&(h.textAlign=Z=L),D!=Tt&&(h.textBaseline=Tt=D)}function Vt(M,T,L,D,W=0){if(D.length>0&&M.auto(n,ls)&&(T==null||T.min==null)){let K=Me(fn,0),at=Me(dn,D.length-1),pt=L.min==null?Pw(D,K,at,W,M.distr==3):[L.min,L.max];M.min=sr(M.min,L.min=pt[0]),M.max=hi(M.max,L.max=pt[1])}}let re={min:null,max:null};function pe(){for(let D in _){let W=_[D];V[D]==null&&(W.min==null||V[S]!=null&&W.auto(n,ls))&&(V[D]=re)}for(let D in _){let W=_[D];V[D]==null&&W.from!=null&&V[W.from]!=null&&(V[D]=re)}V[S]!=null&&fe(!0);let M={};for(let D in V){let W=V[D];if(W!=null){let K=M[D]=Oo(_[D],Bw);if(W.min!=null)bn(K,W);else if(D!=S||i==2)if(sn==0&&K.from==null){let at=K.range(n,null,null,D);K.min=at[0],K.max=at[1]}else K.min=ze,K.max=-ze}}if(sn>0){x.forEach((D,W)=>{if(i==1){let K=D.scale,at=V[K];if(at==null)return;let pt=M[K];if(W==0){let wt=pt.range(n,pt.min,pt.max,K);pt.min=wt[0],pt.max=wt[1],fn=rr(pt.min,t[0]),dn=rr(pt.max,t[0]),dn-fn>1&&(t[0][fn]<pt.min&&fn++,t[0][dn]>pt.max&&dn--),D.min=bi[fn],D.max=bi[dn]}else D.show&&D.auto&&Vt(pt,at,D,t[W],D.sorted);D.idxs[0]=fn,D.idxs[1]=dn}else if(W>0&&D.show&&D.auto){let[K,at]=D.facets,pt=K.scale,wt=at.scale,[Nt,Dt]=t[W],Ot=M[pt],ae=M[wt];Ot!=null&&Vt(Ot,V[pt],K,Nt,K.sorted),ae!=null&&Vt(ae,V[wt],at,Dt,at.sorted),D.min=at.min,D.max=at.max}});for(let D in M){let W=M[D],K=V[D];if(W.from==null&&(K==null||K.min==null)){let at=W.range(n,W.min==ze?null:W.min,W.max==-ze?null:W.max,D);W.min=at[0],W.max=at[1]}}}for(let D in M){let W=M[D];if(W.from!=null){let K=M[W.from];if(K.min==null)W.min=W.max=null;else{let at=W.range(n,K.min,K.max,D);W.min=at[0],W.max=at[1]}}}let T={},L=!1;for(let D in M){let W=M[D],K=_[D];if(K.min!=W.min||K.max!=W.max){K.min=W.min,K.max=W.max;let at=K.distr;K._min=at==3?Xr(K.min):at==4?Hf(K.min,K.asinh):at==100?K.fwd(K.min):K.min,K._max=at==3?Xr(K.max):at==4?Hf(K.max,K.asinh):at==100?K.fwd(K.max):K.max,T[D]=L=!0}}if(L){x.forEach((D,W)=>{i==2?W>0&&T.y&&(D._paths=null):T[D.scale]&&(D._paths=null)});for(let D in T)bt=!0,On("setScale",D);gt&&ct.left>=0&&(et=mt=!0)}for(let D in V)V[D]=null}function Bt(M){let T=Kf(fn-1,0,sn-1),L=Kf(dn+1,0,sn-1);for(;M[T]==null&&T>0;)T--;for(;M[L]==null&&L<sn-1;)L++;return[T,L]}function me(){if(sn>0){let M=x.some(T=>T._focus)&&Lt!=kt.alpha;M&&(h.globalAlpha=Lt=kt.alpha),x.forEach((T,L)=>{if(L>0&&T.show&&(en(L,!1),en(L,!0),T._paths==null)){let D=Lt;Lt!=T.alpha&&(h.globalAlpha=Lt=T.alpha);let W=i==2?[0,t[L][0].length-1]:Bt(t[L]);T._paths=T.paths(n,L,W[0],W[1]),Lt!=D&&(h.globalAlpha=Lt=D)}}),x.forEach((T,L)=>{if(L>0&&T.show){let D=Lt;Lt!=T.alpha&&(h.globalAlpha=Lt=T.alpha),T._paths!=null&&Ie(L,!1);{let W=T._paths!=null?T._paths.gaps:null,K=T.points.show(n,L,fn,dn,W),at=T.points.filter(n,L,K,W);(K||at)&&(T.points._paths=T.points.paths(n,L,fn,dn,at),Ie(L,!0))}Lt!=D&&(h.globalAlpha=Lt=D),On("drawSeries",L)}}),M&&(h.globalAlpha=Lt=1)}}function en(M,T){let L=T?x[M].points:x[M];L._stroke=L.stroke(n,M),L._fill=L.fill(n,M)}function Ie(M,T){let L=T?x[M].points:x[M],{stroke:D,fill:W,clip:K,flags:at,_stroke:pt=L._stroke,_fill:wt=L._fill,_width:Nt=L.width}=L._paths;Nt=Ve(Nt*Ae,3);let Dt=null,Ot=Nt%2/2;T&&wt==null&&(wt=Nt>0?"#fff":pt);let ae=L.pxAlign==1&&Ot>0;if(ae&&h.translate(Ot,Ot),!T){let Se=P-Nt/2,we=A-Nt/2,ge=X+Nt,Qt=ft+Nt;Dt=new Path2D,Dt.rect(Se,we,ge,Qt)}T?Ut(pt,Nt,L.dash,L.cap,wt,D,W,at,K):Le(M,pt,Nt,L.dash,L.cap,wt,D,W,at,Dt,K),ae&&h.translate(-Ot,-Ot)}function Le(M,T,L,D,W,K,at,pt,wt,Nt,Dt){let Ot=!1;wt!=0&&E.forEach((ae,Se)=>{if(ae.series[0]==M){let we=x[ae.series[1]],ge=t[ae.series[1]],Qt=(we._paths||Wa).band;ps(Qt)&&(Qt=ae.dir==1?Qt[0]:Qt[1]);let Xt,je=null;we.show&&Qt&&Lw(ge,fn,dn)?(je=ae.fill(n,Se)||K,Xt=we._paths.clip):Qt=null,Ut(T,L,D,W,je,at,pt,wt,Nt,Dt,Xt,Qt),Ot=!0}}),Ot||Ut(T,L,D,W,K,at,pt,wt,Nt,Dt)}let En=ko|td;function Ut(M,T,L,D,W,K,at,pt,wt,Nt,Dt,Ot){Rt(M,T,L,D,W),(wt||Nt||Ot)&&(h.save(),wt&&h.clip(wt),Nt&&h.clip(Nt)),Ot?(pt&En)==En?(h.clip(Ot),Dt&&h.clip(Dt),ye(W,at),yn(M,K,T)):pt&td?(ye(W,at),h.clip(Ot),yn(M,K,T)):pt&ko&&(h.save(),h.clip(Ot),Dt&&h.clip(Dt),ye(W,at),h.restore(),yn(M,K,T)):(ye(W,at),yn(M,K,T)),(wt||Nt||Ot)&&h.restore()}function yn(M,T,L){L>0&&(T instanceof Map?T.forEach((D,W)=>{h.strokeStyle=vo=W,h.stroke(D)}):T!=null&&M&&h.stroke(T))}function ye(M,T){T instanceof Map?T.forEach((L,D)=>{h.fillStyle=cs=D,h.fill(L)}):T!=null&&M&&h.fill(T)}function Gr(M,T,L,D){let W=w[M],K;if(D<=0)K=[0,0];else{let at=W._space=W.space(n,M,T,L,D),pt=W._incrs=W.incrs(n,M,T,L,D,at);K=Q1(T,L,pt,D,at)}return W._found=K}function xn(M,T,L,D,W,K,at,pt,wt,Nt){let Dt=at%2/2;y==1&&h.translate(Dt,Dt),Rt(pt,at,wt,Nt,pt),h.beginPath();let Ot,ae,Se,we,ge=W+(D==0||D==3?-K:K);L==0?(ae=W,we=ge):(Ot=W,Se=ge);for(let Qt=0;Qt<M.length;Qt++)T[Qt]!=null&&(L==0?Ot=Se=M[Qt]:ae=we=M[Qt],h.moveTo(Ot,ae),h.lineTo(Se,we));h.stroke(),y==1&&h.translate(-Dt,-Dt)}function wo(M){let T=!0;return w.forEach((L,D)=>{if(!L.show)return;let W=_[L.scale];if(W.min==null){L._show&&(T=!1,L._show=!1,fe(!1));return}else L._show||(T=!1,L._show=!0,fe(!1));let K=L.side,at=K%2,{min:pt,max:wt}=W,[Nt,Dt]=Gr(D,pt,wt,at==0?k:Pt);if(Dt==0)return;let Ot=W.distr==2,ae=L._splits=L.splits(n,D,pt,wt,Nt,Dt,Ot),Se=W.distr==2?ae.map(Xt=>bi[Xt]):ae,we=W.distr==2?bi[ae[1]]-bi[ae[0]]:Nt,ge=L._values=L.values(n,L.filter(n,Se,D,Dt,we),D,Dt,we);L._rotate=K==2?L.rotate(n,ge,D,Dt):0;let Qt=L._size;L._size=Hi(L.size(n,ge,D,M)),Qt!=null&&L._size!=Qt&&(T=!1)}),T}function vr(M){let T=!0;return Ia.forEach((L,D)=>{let W=L(n,D,xr,M);W!=tr[D]&&(T=!1),tr[D]=W}),T}function Hr(){for(let M=0;M<w.length;M++){let T=w[M];if(!T.show||!T._show)continue;let L=T.side,D=L%2,W,K,at=T.stroke(n,M),pt=L==0||L==3?-1:1,[wt,Nt]=T._found;if(T.label!=null){let li=T.labelGap*pt,Si=Cn((T._lpos+li)*Ae);Ft(T.labelFont[0],at,"center",L==2?"top":Mg),h.save(),D==1?(W=K=0,h.translate(Si,Cn(A+ft/2)),h.rotate((L==3?-gc:gc)/2)):(W=Cn(P+X/2),K=Si);let Gs=f0(T.label)?T.label(n,M,wt,Nt):T.label;h.fillText(Gs,W,K),h.restore()}if(Nt==0)continue;let Dt=_[T.scale],Ot=D==0?X:ft,ae=D==0?P:A,Se=T._splits,we=Dt.distr==2?Se.map(li=>bi[li]):Se,ge=Dt.distr==2?bi[Se[1]]-bi[Se[0]]:wt,Qt=T.ticks,Xt=T.border,je=Qt.show?Qt.size:0,an=Cn(je*Ae),kn=Cn((T.alignTo==2?T._size-je-T.gap:T.gap)*Ae),ke=T._rotate*-gc/180,ln=g(T._pos*Ae),wi=(an+kn)*pt,ai=ln+wi;K=D==0?ai:0,W=D==1?ai:0;let zi=T.font[0],er=T.align==1?Lo:T.align==2?zf:ke>0?Lo:ke<0?zf:D==0?"center":L==3?zf:Lo,Mr=ke||D==1?"middle":L==2?"top":Mg;Ft(zi,at,er,Mr);let Mi=T.font[1]*T.lineGap,Vi=Se.map(li=>g(a(li,Dt,Ot,ae))),nr=T._values;for(let li=0;li<nr.length;li++){let Si=nr[li];if(Si!=null){D==0?W=Vi[li]:K=Vi[li],Si=""+Si;let Gs=Si.indexOf(`
`)==-1?[Si]:Si.split(/\n/gm);for(let ci=0;ci<Gs.length;ci++){let Qm=Gs[ci];ke?(h.save(),h.translate(W,K+ci*Mi),h.rotate(ke),h.fillText(Qm,0,0),h.restore()):h.fillText(Qm,W,K+ci*Mi)}}}Qt.show&&xn(Vi,Qt.filter(n,we,M,Nt,ge),D,L,ln,an,Ve(Qt.width*Ae,3),Qt.stroke(n,M),Qt.dash,Qt.cap);let Sr=T.grid;Sr.show&&xn(Vi,Sr.filter(n,we,M,Nt,ge),D,D==0?2:1,D==0?A:P,D==0?ft:X,Ve(Sr.width*Ae,3),Sr.stroke(n,M),Sr.dash,Sr.cap),Xt.show&&xn([ln],[1],D==0?1:0,D==0?1:2,D==1?A:P,D==1?ft:X,Ve(Xt.width*Ae,3),Xt.stroke(n,M),Xt.dash,Xt.cap)}On("drawAxes")}function fe(M){x.forEach((T,L)=>{L>0&&(T._paths=null,M&&(i==1?(T.min=null,T.max=null):T.facets.forEach(D=>{D.min=null,D.max=null})))})}let on=!1,oi=!1,Fe=[];function _n(){oi=!1;for(let M=0;M<Fe.length;M++)On(...Fe[M]);Fe.length=0}function Qn(){on||(Xw(Dm),on=!0)}function sc(M,T=!1){on=!0,oi=T,M(n),Dm(),T&&Fe.length>0&&queueMicrotask(_n)}n.batch=sc;function Dm(){if(ot&&(pe(),ot=!1),bt&&(Et(),bt=!1),vt){if(Ke(d,Lo,Kt),Ke(d,"top",le),Ke(d,za,k),Ke(d,Va,Pt),Ke(p,Lo,Kt),Ke(p,"top",le),Ke(p,za,k),Ke(p,Va,Pt),Ke(f,za,rn),Ke(f,Va,gn),u.width=Cn(rn*Ae),u.height=Cn(gn*Ae),w.forEach(({_el:M,_show:T,_size:L,_pos:D,side:W})=>{if(M!=null)if(T){let K=W===3||W===0?L:0,at=W%2==1;Ke(M,at?"left":"top",D-K),Ke(M,at?"width":"height",L),Ke(M,at?"top":"left",at?le:Kt),Ke(M,at?"height":"width",at?Pt:k),jf(M,qs)}else Ai(M,qs)}),vo=cs=bo=H=Q=Y=Z=Tt=R=null,Lt=1,Ua(!0),Kt!=At||le!=Be||k!=Gt||Pt!=jt){fe(!1);let M=k/Gt,T=Pt/jt;if(gt&&!et&&ct.left>=0){ct.left*=M,ct.top*=T,Mo&&Er(Mo,Cn(ct.left),0,k,Pt),So&&Er(So,0,Cn(ct.top),k,Pt);for(let L=0;L<he.length;L++){let D=he[L];D!=null&&(Xe[L]*=M,si[L]*=T,Er(D,Hi(Xe[L]),Hi(si[L]),k,Pt))}}if(Ye.show&&!it&&Ye.left>=0&&Ye.width>0){Ye.left*=M,Ye.width*=M,Ye.top*=T,Ye.height*=T;for(let L in Cf)Ke(To,L,Ye[L])}At=Kt,Be=le,Gt=k,jt=Pt}On("setSize"),vt=!1}rn>0&&gn>0&&(h.clearRect(0,0,u.width,u.height),On("drawClear"),b.forEach(M=>M()),On("draw")),Ye.show&&it&&(oc(Ye),it=!1),gt&&et&&(Vs(null,!0,!1),et=!1),ut.show&&ut.live&&mt&&(Tf(),mt=!1),l||(l=!0,n.status=1,On("ready")),ls=!1,on=!1}n.redraw=(M,T)=>{bt=T||!1,M!==!1?hs(S,I.min,I.max):Qn()};function Sf(M,T){let L=_[M];if(L.from==null){if(sn==0){let D=L.range(n,T.min,T.max,M);T.min=D[0],T.max=D[1]}if(T.min>T.max){let D=T.min;T.min=T.max,T.max=D}if(sn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;M==S&&L.distr==2&&sn>0&&(T.min=rr(T.min,t[0]),T.max=rr(T.max,t[0]),T.min==T.max&&T.max++),V[M]=T,ot=!0,Qn()}}n.setScale=Sf;let Af,Ef,Mo,So,Um,Om,Ao,Eo,km,Bm,$e,Qe,us=!1,Wn=ct.drag,Dn=Wn.x,Un=Wn.y;gt&&(ct.x&&(Af=Gi(gw,p)),ct.y&&(Ef=Gi(yw,p)),I.ori==0?(Mo=Af,So=Ef):(Mo=Ef,So=Af),$e=ct.left,Qe=ct.top);let Ye=n.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},r.select),To=Ye.show?Gi(mw,Ye.over?p:d):null;function oc(M,T){if(Ye.show){for(let L in M)Ye[L]=M[L],L in Cf&&Ke(To,L,M[L]);T!==!1&&On("setSelect")}}n.setSelect=oc;function Tb(M){if(x[M].show)J&&jf(te[M],qs);else if(J&&Ai(te[M],qs),gt){let L=Ct?he[0]:he[M];L!=null&&Er(L,-10,-10,k,Pt)}}function hs(M,T,L){Sf(M,{min:T,max:L})}function br(M,T,L,D){T.focus!=null&&Lb(M),T.show!=null&&x.forEach((W,K)=>{K>0&&(M==K||M==null)&&(W.show=T.show,Tb(K),i==2?(hs(W.facets[0].scale,null,null),hs(W.facets[1].scale,null,null)):hs(W.scale,null,null),Qn())}),L!==!1&&On("setSeries",M,T),D&&Oa("setSeries",n,M,T)}n.setSeries=br;function Rb(M,T){bn(E[M],T)}function Cb(M,T){M.fill=xe(M.fill||null),M.dir=Me(M.dir,-1),T=T??E.length,E.splice(T,0,M)}function Pb(M){M==null?E.length=0:E.splice(M,1)}n.addBand=Cb,n.setBand=Rb,n.delBand=Pb;function Ib(M,T){x[M].alpha=T,gt&&he[M]!=null&&(he[M].style.opacity=T),J&&te[M]&&(te[M].style.opacity=T)}let Wr,fs,zs,Ro={focus:!0};function Lb(M){if(M!=zs){let T=M==null,L=kt.alpha!=1;x.forEach((D,W)=>{if(i==1||W>0){let K=T||W==0||W==M;D._focus=T?null:K,L&&Ib(W,K?1:kt.alpha)}}),zs=M,L&&Qn()}}J&&ne&&be(Tg,Mt,M=>{ct._lock||(ee(M),zs!=null&&br(null,Ro,!0,vn.setSeries))});function wr(M,T,L){let D=_[T];L&&(M=M/Ae-(D.ori==1?le:Kt));let W=k;D.ori==1&&(W=Pt,M=W-M),D.dir==-1&&(M=W-M);let K=D._min,at=D._max,pt=M/W,wt=K+(at-K)*pt,Nt=D.distr;return Nt==3?Do(10,wt):Nt==4?Nw(wt,D.asinh):Nt==100?D.bwd(wt):wt}function Fb(M,T){let L=wr(M,S,T);return rr(L,t[0],fn,dn)}n.valToIdx=M=>rr(M,t[0]),n.posToIdx=Fb,n.posToVal=wr,n.valToPos=(M,T,L)=>_[T].ori==0?s(M,_[T],L?X:k,L?P:0):o(M,_[T],L?ft:Pt,L?A:0),n.setCursor=(M,T,L)=>{$e=M.left,Qe=M.top,Vs(null,T,L)};function zm(M,T){Ke(To,Lo,Ye.left=M),Ke(To,za,Ye.width=T)}function Vm(M,T){Ke(To,"top",Ye.top=M),Ke(To,Va,Ye.height=T)}let Na=I.ori==0?zm:Vm,Da=I.ori==1?zm:Vm;function Nb(){if(J&&ut.live)for(let M=i==2?1:0;M<x.length;M++){if(M==0&&qt)continue;let T=ut.values[M],L=0;for(let D in T)dt[M][L++].firstChild.nodeValue=T[D]}}function Tf(M,T){if(M!=null&&(M.idxs?M.idxs.forEach((L,D)=>{tt[D]=L}):kw(M.idx)||tt.fill(M.idx),ut.idx=tt[0]),J&&ut.live){for(let L=0;L<x.length;L++)(L>0||i==1&&!qt)&&Db(L,tt[L]);Nb()}mt=!1,T!==!1&&On("setLegend")}n.setLegend=Tf;function Db(M,T){let L=x[M],D=M==0&&U==2?bi:t[M],W;qt?W=L.values(n,M,T)??Yt:(W=L.value(n,T==null?null:D[T],M,T),W=W==null?Yt:{_:W}),ut.values[M]=W}function Vs(M,T,L){km=$e,Bm=Qe,[$e,Qe]=ct.move(n,$e,Qe),ct.left=$e,ct.top=Qe,gt&&(Mo&&Er(Mo,Cn($e),0,k,Pt),So&&Er(So,0,Cn(Qe),k,Pt));let D,W=fn>dn;Wr=ze,fs=null;let K=I.ori==0?k:Pt,at=I.ori==1?k:Pt;if($e<0||sn==0||W){D=ct.idx=null;for(let pt=0;pt<x.length;pt++){let wt=he[pt];wt!=null&&Er(wt,-10,-10,k,Pt)}ne&&br(null,Ro,!0,M==null&&vn.setSeries),ut.live&&(tt.fill(D),mt=!0)}else{let pt,wt,Nt;i==1&&(pt=I.ori==0?$e:Qe,wt=wr(pt,S),D=ct.idx=rr(wt,t[0],fn,dn),Nt=B(t[0][D],I,K,0));let Dt=-10,Ot=-10,ae=0,Se=0,we=!0,ge="",Qt="";for(let Xt=i==2?1:0;Xt<x.length;Xt++){let je=x[Xt],an=tt[Xt],kn=an==null?null:i==1?t[Xt][an]:t[Xt][1][an],ke=ct.dataIdx(n,Xt,D,wt),ln=ke==null?null:i==1?t[Xt][ke]:t[Xt][1][ke];if(mt=mt||ln!=kn||ke!=an,tt[Xt]=ke,Xt>0&&je.show){let wi=ke==null?-10:ke==D?Nt:B(i==1?t[0][ke]:t[Xt][0][ke],I,K,0),ai=ln==null?-10:F(ln,i==1?_[je.scale]:_[je.facets[1].scale],at,0);if(ne&&ln!=null){let zi=I.ori==1?$e:Qe,er=Pn(kt.dist(n,Xt,ke,ai,zi));if(er<Wr){let Mr=kt.bias;if(Mr!=0){let Mi=wr(zi,je.scale),Vi=ln>=0?1:-1,nr=Mi>=0?1:-1;nr==Vi&&(nr==1?Mr==1?ln>=Mi:ln<=Mi:Mr==1?ln<=Mi:ln>=Mi)&&(Wr=er,fs=Xt)}else Wr=er,fs=Xt}}if(mt||Ct){let zi,er;I.ori==0?(zi=wi,er=ai):(zi=ai,er=wi);let Mr,Mi,Vi,nr,Sr,li,Si=!0,Gs=ht.bbox;if(Gs!=null){Si=!1;let ci=Gs(n,Xt);Vi=ci.left,nr=ci.top,Mr=ci.width,Mi=ci.height}else Vi=zi,nr=er,Mr=Mi=ht.size(n,Xt);if(li=ht.fill(n,Xt),Sr=ht.stroke(n,Xt),Ct)Xt==fs&&Wr<=kt.prox&&(Dt=Vi,Ot=nr,ae=Mr,Se=Mi,we=Si,ge=li,Qt=Sr);else{let ci=he[Xt];ci!=null&&(Xe[Xt]=Vi,si[Xt]=nr,Ng(ci,Mr,Mi,Si),Lg(ci,li,Sr),Er(ci,Hi(Vi),Hi(nr),k,Pt))}}}}if(Ct){let Xt=kt.prox,je=zs==null?Wr<=Xt:Wr>Xt||fs!=zs;if(mt||je){let an=he[0];an!=null&&(Xe[0]=Dt,si[0]=Ot,Ng(an,ae,Se,we),Lg(an,ge,Qt),Er(an,Hi(Dt),Hi(Ot),k,Pt))}}}if(Ye.show&&us)if(M!=null){let[pt,wt]=vn.scales,[Nt,Dt]=vn.match,[Ot,ae]=M.cursor.sync.scales,Se=M.cursor.drag;if(Dn=Se._x,Un=Se._y,Dn||Un){let{left:we,top:ge,width:Qt,height:Xt}=M.select,je=M.scales[Ot].ori,an=M.posToVal,kn,ke,ln,wi,ai,zi=pt!=null&&Nt(pt,Ot),er=wt!=null&&Dt(wt,ae);zi&&Dn?(je==0?(kn=we,ke=Qt):(kn=ge,ke=Xt),ln=_[pt],wi=B(an(kn,Ot),ln,K,0),ai=B(an(kn+ke,Ot),ln,K,0),Na(sr(wi,ai),Pn(ai-wi))):Na(0,K),er&&Un?(je==1?(kn=we,ke=Qt):(kn=ge,ke=Xt),ln=_[wt],wi=F(an(kn,ae),ln,at,0),ai=F(an(kn+ke,ae),ln,at,0),Da(sr(wi,ai),Pn(ai-wi))):Da(0,at)}else Pf()}else{let pt=Pn(km-Um),wt=Pn(Bm-Om);if(I.ori==1){let ae=pt;pt=wt,wt=ae}Dn=Wn.x&&pt>=Wn.dist,Un=Wn.y&&wt>=Wn.dist;let Nt=Wn.uni;Nt!=null?Dn&&Un&&(Dn=pt>=Nt,Un=wt>=Nt,!Dn&&!Un&&(wt>pt?Un=!0:Dn=!0)):Wn.x&&Wn.y&&(Dn||Un)&&(Dn=Un=!0);let Dt,Ot;Dn&&(I.ori==0?(Dt=Ao,Ot=$e):(Dt=Eo,Ot=Qe),Na(sr(Dt,Ot),Pn(Ot-Dt)),Un||Da(0,at)),Un&&(I.ori==1?(Dt=Ao,Ot=$e):(Dt=Eo,Ot=Qe),Da(sr(Dt,Ot),Pn(Ot-Dt)),Dn||Na(0,K)),!Dn&&!Un&&(Na(0,0),Da(0,0))}if(Wn._x=Dn,Wn._y=Un,M==null){if(L){if(Jm!=null){let[pt,wt]=vn.scales;vn.values[0]=pt!=null?wr(I.ori==0?$e:Qe,pt):null,vn.values[1]=wt!=null?wr(I.ori==1?$e:Qe,wt):null}Oa(Vf,n,$e,Qe,k,Pt,D)}if(ne){let pt=L&&vn.setSeries,wt=kt.prox;zs==null?Wr<=wt&&br(fs,Ro,!0,pt):Wr>wt?br(null,Ro,!0,pt):fs!=zs&&br(fs,Ro,!0,pt)}}mt&&(ut.idx=D,Tf()),T!==!1&&On("setCursor")}let ds=null;Object.defineProperty(n,"rect",{get(){return ds==null&&Ua(!1),ds}});function Ua(M=!1){M?ds=null:(ds=p.getBoundingClientRect(),On("syncRect",ds))}function Gm(M,T,L,D,W,K,at){ct._lock||us&&M!=null&&M.movementX==0&&M.movementY==0||(Rf(M,T,L,D,W,K,at,!1,M!=null),M!=null?Vs(null,!0,!0):Vs(T,!0,!1))}function Rf(M,T,L,D,W,K,at,pt,wt){if(ds==null&&Ua(!1),ee(M),M!=null)L=M.clientX-ds.left,D=M.clientY-ds.top;else{if(L<0||D<0){$e=-10,Qe=-10;return}let[Nt,Dt]=vn.scales,Ot=T.cursor.sync,[ae,Se]=Ot.values,[we,ge]=Ot.scales,[Qt,Xt]=vn.match,je=T.axes[0].side%2==1,an=I.ori==0?k:Pt,kn=I.ori==1?k:Pt,ke=je?K:W,ln=je?W:K,wi=je?D:L,ai=je?L:D;if(we!=null?L=Qt(Nt,we)?a(ae,_[Nt],an,0):-10:L=an*(wi/ke),ge!=null?D=Xt(Dt,ge)?a(Se,_[Dt],kn,0):-10:D=kn*(ai/ln),I.ori==1){let zi=L;L=D,D=zi}}wt&&(T==null||T.cursor.event.type==Vf)&&((L<=1||L>=k-1)&&(L=Hs(L,k)),(D<=1||D>=Pt-1)&&(D=Hs(D,Pt))),pt?(Um=L,Om=D,[Ao,Eo]=ct.move(n,L,D)):($e=L,Qe=D)}let Cf={width:0,height:0,left:0,top:0};function Pf(){oc(Cf,!1)}let Hm,Wm,qm,Xm;function $m(M,T,L,D,W,K,at){us=!0,Dn=Un=Wn._x=Wn._y=!1,Rf(M,T,L,D,W,K,at,!0,!1),M!=null&&(be(Gf,$f,Ym,!1),Oa(Ag,n,Ao,Eo,k,Pt,null));let{left:pt,top:wt,width:Nt,height:Dt}=Ye;Hm=pt,Wm=wt,qm=Nt,Xm=Dt}function Ym(M,T,L,D,W,K,at){us=Wn._x=Wn._y=!1,Rf(M,T,L,D,W,K,at,!1,!0);let{left:pt,top:wt,width:Nt,height:Dt}=Ye,Ot=Nt>0||Dt>0,ae=Hm!=pt||Wm!=wt||qm!=Nt||Xm!=Dt;if(Ot&&ae&&oc(Ye),Wn.setScale&&Ot&&ae){let Se=pt,we=Nt,ge=wt,Qt=Dt;if(I.ori==1&&(Se=wt,we=Dt,ge=pt,Qt=Nt),Dn&&hs(S,wr(Se,S),wr(Se+we,S)),Un)for(let Xt in _){let je=_[Xt];Xt!=S&&je.from==null&&je.min!=ze&&hs(Xt,wr(ge+Qt,Xt),wr(ge,Xt))}Pf()}else ct.lock&&(ct._lock=!ct._lock,Vs(T,!0,M!=null));M!=null&&(An(Gf,$f),Oa(Gf,n,$e,Qe,k,Pt,null))}function Ub(M,T,L,D,W,K,at){if(ct._lock)return;ee(M);let pt=us;if(us){let wt=!0,Nt=!0,Dt=10,Ot,ae;I.ori==0?(Ot=Dn,ae=Un):(Ot=Un,ae=Dn),Ot&&ae&&(wt=$e<=Dt||$e>=k-Dt,Nt=Qe<=Dt||Qe>=Pt-Dt),Ot&&wt&&($e=$e<Ao?0:k),ae&&Nt&&(Qe=Qe<Eo?0:Pt),Vs(null,!0,!0),us=!1}$e=-10,Qe=-10,tt.fill(null),Vs(null,!0,!0),pt&&(us=pt)}function jm(M,T,L,D,W,K,at){ct._lock||(ee(M),Fa(),Pf(),M!=null&&Oa(Rg,n,$e,Qe,k,Pt,null))}function Zm(){w.forEach(tM),O(n.width,n.height,!0)}Xs(yc,No,Zm);let Co={};Co.mousedown=$m,Co.mousemove=Gm,Co.mouseup=Ym,Co.dblclick=jm,Co.setSeries=(M,T,L,D)=>{let W=vn.match[2];L=W(n,T,L),L!=-1&&br(L,D,!0,!1)},gt&&(be(Ag,p,$m),be(Vf,p,Gm),be(Eg,p,M=>{ee(M),Ua(!1)}),be(Tg,p,Ub),be(Rg,p,jm),ed.add(n),n.syncRect=Ua);let ac=n.hooks=r.hooks||{};function On(M,T,L){oi?Fe.push([M,T,L]):M in ac&&ac[M].forEach(D=>{D.call(null,n,T,L)})}(r.plugins||[]).forEach(M=>{for(let T in M.hooks)ac[T]=(ac[T]||[]).concat(M.hooks[T])});let Km=(M,T,L)=>L,vn=bn({key:null,setSeries:!1,filters:{pub:Bg,sub:Bg},scales:[S,x[1]?x[1].scale:null],match:[zg,zg,Km],values:[null,null]},ct.sync);vn.match.length==2&&vn.match.push(Km),ct.sync=vn;let Jm=vn.key,If=U0(Jm);function Oa(M,T,L,D,W,K,at){vn.filters.pub(M,T,L,D,W,K,at)&&If.pub(M,T,L,D,W,K,at)}If.sub(n);function Ob(M,T,L,D,W,K,at){vn.filters.sub(M,T,L,D,W,K,at)&&Co[M](null,T,L,D,W,K,at)}n.pub=Ob;function kb(){If.unsub(n),ed.delete(n),Nn.clear(),Zf(yc,No,Zm),c.remove(),Mt?.remove(),On("destroy")}n.destroy=kb;function Lf(){On("init",r,t),La(t||r.data,!1),V[S]?Sf(S,V[S]):Fa(),it=Ye.show&&(Ye.width>0||Ye.height>0),et=mt=!0,O(r.width,r.height)}return x.forEach(_o),w.forEach(zr),e?e instanceof HTMLElement?(e.appendChild(c),Lf()):e(n,Lf):Lf(),n}wn.assign=bn;wn.fmtNum=ld;wn.rangeNum=xc;wn.rangeLog=bc;wn.rangeAsinh=od;wn.orient=Ys;wn.pxRatio=Ae;wn.join=qw;wn.fmtDate=ud,wn.tzDate=n1;wn.sync=U0;{wn.addGap=k1,wn.clipGaps=Sc;let r=wn.paths={points:G0};r.linear=W0,r.stepped=V1,r.bars=G1,r.spline=W1}var Y0="12px system-ui, sans-serif",j0=2;function Z0(r,t,e,n){let i={stroke:()=>Ar("--grid"),width:1},s={stroke:()=>Ar("--quiet"),font:Y0,grid:i,ticks:{...i,size:4}},o={width:Math.max(r.clientWidth,120),height:n.height,legend:{show:!1},padding:[10,14,0,0],scales:{x:{time:!1},y:n.log?{distr:3,range:(l,c,u)=>nM(c,u,n.decades)}:{range:(l,c,u)=>eM(c,u)}},axes:[{...s,label:n.abscissa,labelSize:18,labelFont:Y0,size:30,values:(l,c)=>c.map(ui)},{...s,size:(l,c)=>16+7*Math.max(2,...(c??[]).map(u=>u.length)),values:(l,c)=>c.map(u=>u===null?"":n.log?iM(u):ui(u))}],series:[{},...e.map(l=>({stroke:()=>Ar(l.property),width:l.width,dash:l.dash,alpha:l.ghost?.35:1,spanGaps:!0,points:{show:!1}}))],cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!0,dist:j0},bind:{mousedown:(l,c,u)=>h=>h.shiftKey?u(h):null,dblclick:()=>()=>(n.zoomed(null),null)}},hooks:{setSelect:[l=>rM(l,n)],setCursor:[l=>n.hovered(l.cursor.left===void 0||l.cursor.left<0?null:l.posToVal(l.cursor.left,"x"))],draw:[l=>oM(l,n.marks)]}},a=new wn(o,t,r);return sM(a,n),a}function eM(r,t){if(r===null||t===null||!Number.isFinite(r)||!Number.isFinite(t))return[0,1];let e=Math.max(Math.abs(r),Math.abs(t)),n=e>1e-9?.05*e:.05;if(t-r<=1e-9*e||e<=1e-12)return[(r+t)/2-n,(r+t)/2+n];let i=.07*(t-r);return[r-i,t+i]}function nM(r,t,e){if(r===null||t===null||!(t>0))return[.1,1];let n=Math.max(r>0?r:t,t*10**-e);return[10**Math.floor(Math.log10(n)+1e-9),t*1.6]}function iM(r){let t=Math.log10(r);return Math.abs(t-Math.round(t))>1e-6?"":ui(r).replace(/^1\u00a0×\u00a0|^1\.0\u00a0×\u00a0/,"")}function rM(r,t){r.select.width<j0||(t.zoomed([r.posToVal(r.select.left,"x"),r.posToVal(r.select.left+r.select.width,"x")]),r.setSelect({left:0,top:0,width:0,height:0},!1))}function sM(r,t){let e=r.over,n=i=>t.chosen(r.posToVal(i.clientX-e.getBoundingClientRect().left,"x"));e.addEventListener("pointerdown",i=>{i.shiftKey||i.button!==0||(e.setPointerCapture(i.pointerId),n(i))}),e.addEventListener("pointermove",i=>{e.hasPointerCapture(i.pointerId)&&n(i)})}function oM(r,t){let{ctx:e,bbox:n}=r,i=wn.pxRatio,s=-1/0;e.save(),e.strokeStyle=e.fillStyle=Ar("--quiet"),e.font=`${11*i}px system-ui, sans-serif`,e.setLineDash([3*i,3*i]);for(let{at:o}of t){let a=r.valToPos(o,"x",!0);if(a<n.left||a>n.left+n.width)continue;e.beginPath(),e.moveTo(a,n.top),e.lineTo(a,n.top+n.height),e.stroke();let l=`${ui(Number(o.toPrecision(3)))} Hz`;a>s&&a+e.measureText(l).width<n.left+n.width&&(e.fillText(l,a+3*i,n.top+11*i),s=a+e.measureText(l).width+8*i)}e.restore()}var K0={spectrum:5,other:6},aM=190,lM=1e-9,cM=100;function J0(r,t,e){let{chart:n}=r,i=n.abscissa==="time",s=qr("chart"),o=n.unit==="–"?"":n.unit,a=n.log==="first",l=null,c=!0,u=Df(r,null),h=n.marks,f=0,d=null,p=null,y=null,g=!1,m=!0,x="",w=0,_=0,E=0,S=lt("div",{class:"plot-area",role:"img"}),v=lt("span",{class:"readout"}),b=Tn("log",()=>q(!a),{class:"tool","aria-pressed":String(a),title:"Logarithmic ordinate, of the size of the values",hidden:n.log==="no"}),N=Tn("reset zoom",()=>e.set(null),{class:"tool",hidden:!0}),C=lt("div",{class:"tools"},N,b,Tn("CSV",yt,{class:"tool",title:"Save the data of this chart as CSV"})),I=lt("h4",{id:s,text:n.title},lt("span",{class:"unit",text:o?` [${o}]`:""})),U=lt("p",{class:"note",hidden:!i||fc(Of(r))>=1,text:fg(Of(r))}),B=lt("p",{class:"note",hidden:!0,text:"The marked frequencies are of the run as it was."}),F=bg(u,r.compared,G),V=lt("figure",{class:"chart","aria-labelledby":s,"data-chart":n.id},lt("figcaption",{},I,v,C),S,F.element,U,B);function q(dt){a=dt,b.setAttribute("aria-pressed",String(dt)),G()}function G(){m=!0,g&&$()}function rt(){if(c)return u;c=!0,u=Df(r,l);let dt=kf(n,l);return h=dt?pg(dt,u):n.marks,F.renew(u),u}function $(){if(!m||f===0)return;m=!1;let dt=rt().filter(ve=>F.shows(ve)),Wt=dt.map(ve=>({...F.look(ve),width:ve.ghost?1:ve.role==="real"?1.6:1.3,ghost:ve.ghost})),qt=uc(dt,a);_=Math.max(0,...dt.map(ve=>Math.max(...hc(ve.y).map(Math.abs))));let Yt=JSON.stringify([Wt,h,a,f,w]);d&&Yt===x?d.setData(qt):j(qt,Wt),x=Yt,S.setAttribute("aria-label",Uf(n,o,dt)),i&&tt(e.range),J()}function j(dt,Wt){d?.destroy(),y=null,d=Z0(S,dt,Wt,{log:a,decades:n.group==="spectrum"?K0.spectrum:K0.other,height:aM,marks:h,abscissa:i?"time [s]":"frequency [Hz]",zoomed:qt=>i?e.set(qt):tt(qt),hovered:qt=>{y=qt,J()},chosen:qt=>{i&&t.seek(qt)}}),p=i?lt("div",{class:"time-line"}):null,p&&d.over.append(p)}function tt(dt){let Wt=d?.data[0];if(N.hidden=dt===null,!d||!Wt?.length)return;let[qt,Yt]=dt??[Wt[0],Wt[Wt.length-1]];Yt>qt&&d.setScale("x",{min:qt,max:Yt}),queueMicrotask(ut)}function ut(){if(!d||!p)return;let dt=d.valToPos(t.time,"x"),Wt=d.valToPos(d.scales.x.max??0,"x"),qt=dt>=-.5&&dt<=Wt+.5;p.style.display=qt?"":"none",p.style.transform=`translateX(${dt}px)`}function ct(){ut(),(!t.playing||performance.now()-E>cM)&&J()}function J(){E=performance.now();let dt=y??(i?t.time:null);Rn(v,y===null?"":i?`at ${y.toFixed(3)} s`:`at ${qn(y,"Hz")}`),F.tell(Wt=>dt===null?null:gt(hg(Wt,dt)))}function gt(dt){return dt!==null&&Math.abs(dt)<lM*_&&!a?0:dt}function yt(){Po(dg(rt().filter(dt=>F.shows(dt)),i?"time [s]":"frequency [Hz]",o),`${n.id}.csv`,"text/csv")}let Mt=new IntersectionObserver(dt=>{g=dt.some(Wt=>Wt.isIntersecting),g&&$(),g&&J()},{rootMargin:"120px"}),xt=new ResizeObserver(()=>{f=S.clientWidth,g&&f>0&&G()}),zt=()=>{w+=1,m=!0,$()};addEventListener("beforeprint",zt),addEventListener("afterprint",zt),Mt.observe(V),S.setAttribute("aria-label",Uf(n,o,u.filter(dt=>F.shows(dt)))),xt.observe(S);let te=[t.subscribe(()=>{g&&i&&ct()}),e.subscribe(()=>i&&tt(e.range))];return{element:V,id:n.id,show(dt){l=dt,c=!1,B.hidden=dt===null||kf(n,dt)!==null||n.marks.length===0,G()},recolour(){w+=1,G()},dispose(){removeEventListener("beforeprint",zt),removeEventListener("afterprint",zt),Mt.disconnect(),xt.disconnect(),te.forEach(dt=>dt()),d?.destroy()}}}function Q0(){let r=new Set,t={range:null};return{get range(){return t.range},set(e){e===t.range||e&&t.range&&e.every((i,s)=>i===t.range?.[s])||(t.range=e,r.forEach(i=>i()))},subscribe(e){return r.add(e),()=>r.delete(e)}}}var ty={overview:"Overview",tip:"Tip",contact:"Contact",deformations:"Deformations",motors:"Motors",energy:"Energy",spectrum:"Spectrum",all:"All"};function ny(r,t,e){let n=lg(t),i=Q0(),s=lt("div",{class:"chart-grid",id:"tm-charts",role:"tabpanel",tabindex:"0"}),o=lt("div",{class:"tabs",role:"tablist","aria-label":"Charts"}),a=lt("p",{class:"note hint",text:"Click or drag: choose the time. Shift and drag: zoom, double click: back."}),l=Object.keys(ty).filter(y=>ey(n,y).length>0),c=[],u=[],h=null;for(let y of l){let g=Tn(ty[y],()=>f(y),{role:"tab",id:`tm-tab-${y}`,"aria-controls":"tm-charts","data-group":y});o.append(g)}o.addEventListener("keydown",y=>{let g={ArrowRight:1,ArrowLeft:-1}[y.key],m=l.findIndex(x=>`tm-tab-${x}`===y.target.id);g===void 0||m<0||(y.preventDefault(),y.stopPropagation(),f(l[(m+g+l.length)%l.length]),o.querySelector("[aria-selected=true]")?.focus())});function f(y){u.forEach(g=>g.dispose()),c=ey(n,y),u=c.map(g=>J0(g,e,i)),h&&u.forEach(g=>g.show(h));for(let g of o.querySelectorAll("button")){let m=g.dataset.group===y;g.setAttribute("aria-selected",String(m)),g.tabIndex=m?0:-1}s.setAttribute("aria-labelledby",`tm-tab-${y}`),s.replaceChildren(...u.map(g=>g.element))}let d=matchMedia("(prefers-color-scheme: dark)"),p=()=>u.forEach(y=>y.recolour());return d.addEventListener("change",p),r.append(lt("div",{class:"tab-bar"},o,a),s),f("overview"),{show(y){let g=h;h=y,u.forEach((m,x)=>{(!y||!g||!cg(c[x],g,y))&&m.show(y)})},dispose(){d.removeEventListener("change",p),u.forEach(y=>y.dispose()),r.replaceChildren()}}}function ey(r,t){return t==="all"?r:t!=="overview"?r.filter(({chart:e})=>e.group===t):r.filter(({chart:e},n)=>r.findIndex(i=>i.chart.group===e.group)===n)}var iy='"use strict";(()=>{var Kn=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],Qn=["m","rad","s"],Jn=["Hz","%","rad/s"],Xn="⁰¹²³⁴⁵⁶⁷⁸⁹";function Zn(s){let r=s.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(r)?"":r}function it(s,r=4){return s===0?"0":String(Number(s.toPrecision(r)))}function Vn(s){if(s===0)return"0";let[r,e]=s.toExponential(1).split("e"),t=[...String(Number(e))].map(n=>n==="-"?"⁻":Xn[Number(n)]).join("");return`${r} × 10${t}`}function Hn(s,r){let e=Zn(s);if(!e||Jn.includes(s)||!(r>0))return{factor:1,name:e};let t=Qn.includes(s.split("/")[0]),n=Kn.find(([o,i])=>r>=o&&(i>=1||!t));return n?{factor:n[1],name:n[2]+e}:{factor:1,name:e}}function ht(s,r){if(s===null||!Number.isFinite(s))return"–";let e=Math.abs(s),{factor:t,name:n}=Hn(r,e);return`${e>0&&(t===1?e<.001:e<1e-11)?Vn(s):it(s*t)} ${n}`.trimEnd()}function Xe(s){let{settings:r,status:e}=s,{statuses:t,limits:n}=s.layout,o=`t = ${it(s.time,6)} s`;if(e===t.finished)return["finished",`reached the end, t = ${it(r.duration,6)} s`];if(e===t.running)return["stopped",`stopped at ${o} of ${it(r.duration,6)} s: integration.max_steps = ${r.maxSteps} is used up`];if(e===t.chattering){let i=`more than ${n.most_events} times within ${n.event_time} s`;return["chattering",`stopped at ${o}: the contact set in or ended ${i}; give the surface damping, or a lower stiffness`]}return to(s,o)}function to({layout:s,status:r,lastStep:e,rates:t},n){let{statuses:o,coordinates:i,limits:a}=s,u=i.length,l=Array.from(t().subarray(u,2*u),d=>Number.isFinite(d)?Math.abs(d):1/0),c=l.indexOf(Math.max(...l)),h=l[c]<a.bound?r===o.not_converged?"not_converged":r===o.step_too_small?"step_too_small":"diverged":"diverged",g=`its acceleration is ${it(l[c],3)} rad/s^2`,m=h.replaceAll("_"," ");return[h,`${m} at ${n} in coordinate ${i[c]}: ${g}; its last step was of ${it(e,3)} s`]}var et=class extends Error{name="EngineError"};function It(s,r,e){if(!Object.hasOwn(s,r))throw new et(`${e}: got ${r}; expected one of ${Object.keys(s).join(", ")}`);return s[r]}function gt(s,r,e){if(r!==e)throw new et(`${s}: got ${r} numbers; expected ${e}`)}var eo=["rk4","midpoint"],ro=500,he=class{constructor(r,e){this.engine=r;this.spec=e;let t=It(r.layout.loops,e.loop,"loop");gt(`${e.loop}: parameters`,e.parameters.length,t.parameters),gt(`${e.loop}: state`,e.state.length,t.size),gt(`${e.loop}: rows`,e.rows.length,(e.knots.length-1)*t.row),this.method=t.method,this.memory=new Float64Array(r.layout.cells.length),this.state=e.state.slice(),this.slope=new Float64Array(t.size),this.sums=new Float64Array(t.size),this.states=new Float64Array(e.times.length*t.size),this.sumsAtSamples=new Float64Array(e.times.length*t.size),this.states.set(e.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;sums;sumsAtSamples;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(r){return this.memory[this.engine.layout.cells.indexOf(r)]}put(r){for(let[e,t]of Object.entries(r))this.memory[this.engine.layout.cells.indexOf(e)]=t}advance(r){let{layout:e}=this.engine,{settings:t,knots:n,rows:o,times:i,parameters:a}=this.spec,u=Math.max(1,Math.min(r,t.maxSteps-this.tried)),l={step:t.step,rtol:t.relativeTolerance,atol:t.absoluteTolerance,chunk:u,bound:e.limits.bound,watch:0,most_events:e.limits.most_events,event_time:e.limits.event_time,looks:0},c=this.cell("sample"),f=m=>({into:m,range:()=>[c*this.state.length,this.cell("sample")*this.state.length]}),h=m=>({into:m,given:!0}),g={memory:h(this.memory),y:h(this.state),k1:h(this.slope),p:a,knots:n,rows:o,times:i,out:f(this.states),options:Float64Array.from(e.options,m=>l[m]),errors:h(this.sums),errors_out:f(this.sumsAtSamples),seen:new Float64Array(1),segments:n.length-1,samples:i.length};this.engine.call(e.loops[this.spec.loop].export,e.arguments.map(m=>g[m]))}result(){let r=this.cell("sample"),e=this.state.length,[t,n]=Xe({layout:this.engine.layout,settings:this.spec.settings,status:this.cell("status"),time:this.time,lastStep:this.cell("h"),rates:()=>this.rates()});return{status:t,message:n,times:this.spec.times.slice(0,r),states:this.states.slice(0,r*e),errors:this.sumsAtSamples.slice(0,r*e),statistics:this.statistics()}}statistics(){let[r,e,t]=[this.cell("steps"),this.cell("smallest"),this.time],n=r?t/r:null,o={steps:r,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:n,smallest_step_s:e>0?e:n};return eo.includes(this.method)&&(o.step=this.cell("h")),this.cell("passes")&&(o.passes=this.cell("passes")),this.cell("events")&&(o.contact_changes=this.cell("events")),o}rates(){let{loop:r,parameters:e,rows:t}=this.spec,{row:n}=this.engine.layout.loops[r],o=Math.min(this.cell("segment"),t.length/n-1),i={time:Float64Array.of(this.time),state:this.state,row:t.slice(o*n,(o+1)*n),step:new Float64Array(1)};return this.engine.sample(`${r.slice(0,r.lastIndexOf("."))}.rate`,e,i,1).rate}},dt=class extends et{name="Cancelled"};async function Ze(s,r,e={}){let t=new he(s,r),n=1e3*(e.piece??.05),o=ro,i=performance.now();for(;t.running;){let a=performance.now();t.advance(o);let u=performance.now();if(o=Math.max(1,Math.floor(o*Math.min(4,n/Math.max(u-a,.001)))),!(u-i<n)){if(e.progress?.(t.time/r.settings.duration),await new Promise(l=>setTimeout(l,0)),e.cancelled?.())throw new dt(`the run was given up at t = ${it(t.time,6)} s`);i=performance.now()}}return t.result()}function Ve(s,r){if(!r)return s;let e=(t,n)=>Object.fromEntries(Object.entries(t).filter(([o,i])=>n[o]!==i));return{...e(s,r),series:e(s.series,r.series)}}function Nt(s,r=new Set){if(ArrayBuffer.isView(s))s.buffer instanceof ArrayBuffer&&r.add(s.buffer);else if(s!==null&&typeof s=="object")for(let e of Object.values(s))Nt(e,r);return[...r]}var He=1,no=65536,oo={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},Wt=class s{constructor(r,e,t,n){this.layout=r;this.functions=e;this.memory=t;this.free=n}layout;functions;memory;free;outputs=new Float64Array;static async open(r,e){if(e.format!==He)throw new et(`layout: got format ${e.format}; expected ${He}`);let{instance:t}=await so(r,e),{memory:n,heap_base:o,...i}=t.exports,a=o.value;return new s(e,i,n,a)}sample(r,e,t,n){let o=It(this.layout.samples,r,"function");gt(`${r}: parameters`,e.length,o.parameters);let i=o.kind==="program"?this.program(o,e,t,n):this.schedule(o,e,[t],n);return me(o.outputs,i,n,1)}slopes(r,e,t,n,o){let i=It(this.layout.samples,r,"function");if(i.kind!=="slopes")throw new et(`${r}: got a function without derivatives; expected one with them`);gt(`${r}: parameters`,e.length,i.parameters);let a=Object.fromEntries(Object.entries(i.inputs).map(([c,f])=>[c,new Float64Array(f)])),u=this.schedule(i,e,[t,{...a,...n}],o),l=Lt(i.outputs);return{values:me(i.outputs,u,o,2),slopes:me(i.outputs,u.subarray(l),o,2)}}call(r,e){let t=e.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(t.reduce((a,u)=>a+(u?.byteLength??0),this.free));let n=new Float64Array(this.memory.buffer),o=this.free,i=e.map((a,u)=>{if(typeof a=="number")return BigInt(a);let l=o;return(a instanceof Float64Array||a.given)&&n.set(t[u],l/8),o+=t[u].byteLength,l});this.functions[r](...i),e.forEach((a,u)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[l,c]=a.range?.()??[0,a.into.length],f=i[u]/8;a.into.set(n.subarray(f+l,f+c),l)})}program(r,e,t,n){let o=Object.entries(r.inputs).map(([a,u])=>tr(a,u,t[a],n)),i=this.room(n*Lt(r.outputs));return this.call(r.export,[n,e,...o,{into:i}]),i}schedule(r,e,t,n){let o=io(r.inputs,t,n),i=this.room(n*t.length*Lt(r.outputs)),a=new Float64Array(r.workspace);return this.call(r.export,[n,0,e,a,o,{into:i}]),i}room(r){return this.outputs.length<r&&(this.outputs=new Float64Array(r)),this.outputs.subarray(0,r)}reserve(r){let e=r-this.memory.buffer.byteLength;if(!(e<=0))try{this.memory.grow(Math.ceil(e/no))}catch{throw new et(`memory: got no room for ${(r/1e6).toFixed(0)} MB; expected a browser that has it. Mend: ask for fewer samples`)}}};async function so(s,r){try{return await WebAssembly.instantiate(s,{env:oo})}catch(e){let t=r.simd?", with vectors (SIMD)":"";throw new et(`WebAssembly: got ${String(e)}; expected a browser that allows it${t}`)}}function Lt(s){return Object.values(s).reduce((r,e)=>r+e,0)}function tr(s,r,e,t){if(e===void 0)throw new et(`${s}: got nothing; expected ${r} numbers for each sample`);if(e.length===t*r)return e;gt(s,e.length,r);let n=new Float64Array(t*r);return pe(e,0,0,n,r,0,r,t),n}function io(s,r,e){let t=Lt(s),n=new Float64Array(e*r.length*t);return r.forEach((o,i)=>{let a=i*t;for(let[u,l]of Object.entries(s)){let c=tr(u,l,o[u],e);pe(c,l,0,n,r.length*t,a,l,e),a+=l}}),n}function me(s,r,e,t){let n=t*Lt(s),o={},i=0;for(let[a,u]of Object.entries(s)){let l=new Float64Array(e*u);pe(r,n,i,l,u,0,u,e),o[a]=l,i+=u}return o}function pe(s,r,e,t,n,o,i,a){for(let u=0;u<a;u++){let l=u*r+e,c=u*n+o;for(let f=0;f<i;f++)t[c+f]=s[l+f]}}var Dt=class{last=null;async of(r,e){if(this.last&&ao(this.last.blocks,r))return this.last.made;this.last=null;let t=await e();return this.last={blocks:r,made:t},t}};function ao(s,r){return Object.entries(s).every(([e,t])=>t.length===r[e].length&&t.every((n,o)=>n===r[e][o]))}function ge(s,r){return{knots:s,coefficients:r,signals:1,degree:r.length/(s.length-1)-1}}function de(s,r){let e=s.degree+1,t=s.knots.length-1,n=0;for(;n<t&&s.knots[n]<r;)n+=1;let o=s.knots[t],i=[...s.knots.subarray(0,n)],a=[...s.coefficients.subarray(0,n*e)];return r>o&&(i.push(o),a.push(er(s,t-1,0,o),...new Array(s.degree).fill(0))),ge(Float64Array.from([...i,r]),Float64Array.from(a))}function er(s,r,e,t){let n=s.degree+1,o=(r*s.signals+e)*n,i=t-s.knots[r],a=0;for(let u=s.degree;u>=0;u-=1)a=a*i+s.coefficients[o+u];return a}function ye(s,r){let[e,t]=[0,s.length-1];for(;t-e>1;){let n=e+t>>1;s[n]<=r?e=n:t=n}return e}function Et(s,r,e){return er(s,ye(s.knots,e),r,e)}function rr(s){return or(s,Array.from({length:s.knots.length-1},(r,e)=>e))}function nr(s,r){return or(s,Array.from(r,e=>ye(s.knots,e)))}function or(s,r){let e=s.signals*(s.degree+1),t=new Float64Array(r.length*(e+1));return r.forEach((n,o)=>{t[o*(e+1)]=s.knots[n],t.set(s.coefficients.subarray(n*e,(n+1)*e),o*(e+1)+1)}),t}function sr(s){if(!s.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let r=Math.max(...s.map(i=>i.knots[i.knots.length-1])),e=s.map(i=>i.knots[i.knots.length-1]<r?de(i,r):i),t=lo(e.flatMap(i=>[...i.knots])),n=Math.max(...e.map(i=>i.degree)),o=new Float64Array((t.length-1)*s.length*(n+1));return e.forEach((i,a)=>{for(let u=0;u<t.length-1;u+=1){let l=(u*s.length+a)*(n+1);uo(i,t,u,o.subarray(l,l+n+1))}}),{knots:t,coefficients:o,signals:s.length,degree:n}}function lo(s){let r=[...new Set(s)].sort((n,o)=>n-o),e=r[r.length-1]-r[0],t=r.filter((n,o)=>o===0||n-r[o-1]>1e-12*e);return t[t.length-1]=r[r.length-1],Float64Array.from(t)}function uo(s,r,e,t){let n=ye(s.knots,(r[e]+r[e+1])/2),o=r[e]-s.knots[n],i=Math.abs(o)<=1e-12*(r[r.length-1]-r[0])?0:o;for(let a=0;a<=s.degree;a+=1){let u=s.coefficients[n*(s.degree+1)+a],l=1;for(let c=a;c>=0;c-=1)t[c]+=l*u*Math.pow(i,a-c),l=l*c/(a-c+1)}}var $=6;function kt({follower:s,signal:r},e,t,n,o,i){let a=r<0?1:Et(t,r,n);return(s?co(o,i,e):e).map(u=>a*u)}function co(s,r,e){return e.map((t,n)=>{let[o,i]=[r+3*(n%3),n<3?0:3];return s[o]*e[i]+s[o+1]*e[i+1]+s[o+2]*e[i+2]})}function Gt(s,r){let e=r.length;for(let t=0;t<e;t+=1){let n=t;for(let i=t+1;i<e;i+=1)Math.abs(s[i*e+t])>Math.abs(s[n*e+t])&&(n=i);let o=Math.abs(s[n*e+t]);if(!(o>0)||o===1/0)return!1;n!==t&&fo(s,r,t,n);for(let i=t+1;i<e;i+=1){let a=s[i*e+t]/s[t*e+t];if(a!==0){for(let u=t+1;u<e;u+=1)s[i*e+u]-=a*s[t*e+u];r[i]-=a*r[t]}}}for(let t=e-1;t>=0;t-=1){for(let n=t+1;n<e;n+=1)r[t]-=s[t*e+n]*r[n];r[t]/=s[t*e+t]}return!0}function fo(s,r,e,t){let n=r.length;for(let i=0;i<n;i+=1){let a=s[e*n+i];s[e*n+i]=s[t*n+i],s[t*n+i]=a}let o=r[e];r[e]=r[t],r[t]=o}function Ut(s,r){let e=new Float64Array(r*r);for(let t=0;t<r;t+=1)for(let n=t;n<r;n+=1){let o=s[n*r+t];for(let i=0;i<t;i+=1)o-=e[n*r+i]*e[t*r+i];if(n===t&&!(o>0))return null;e[n*r+t]=n===t?Math.sqrt(o):o/e[t*r+t]}return e}function ar(s,r,e,t){for(let n=0;n<e;n+=1){for(let o=0;o<n;o+=1)ur(r,n,o,s[n*e+o],t);for(let o=0;o<t;o+=1)r[n*t+o]/=s[n*e+n]}}function we(s,r,e,t){for(let n=e-1;n>=0;n-=1){for(let o=n+1;o<e;o+=1)ur(r,n,o,s[o*e+n],t);for(let o=0;o<t;o+=1)r[n*t+o]/=s[n*e+n]}}function ur(s,r,e,t,n){for(let o=0;o<n;o+=1)s[r*n+o]-=t*s[e*n+o]}function Yt(s,r,e){let t=r.slice();ar(s,t,e,e);let n=lr(t,e);return ar(s,n,e,e),lr(n,e)}function lr(s,r){return s.map((e,t)=>s[t%r*r+Math.floor(t/r)])}function U(s,r,e,t,n,o=!1){let i=new Float64Array(e*n);for(let a=0;a<e;a+=1)for(let u=0;u<t;u+=1){let l=o?s[u*e+a]:s[a*t+u];if(l)for(let c=0;c<n;c+=1)i[a*n+c]+=l*r[u*n+c]}return i}function cr(s,r){let e=Float64Array.from({length:r*r},(t,n)=>n%(r+1)?0:1);for(let t=0;t<r;t+=1){let n=t;for(let a=t+1;a<r;a+=1)Math.abs(s[a*r+t])>Math.abs(s[n*r+t])&&(n=a);let o=Math.abs(s[n*r+t]);if(!(o>0)||o===1/0)return null;for(let a of[s,e])if(n!==t){let u=a.slice(t*r,(t+1)*r);a.copyWithin(t*r,n*r,(n+1)*r),a.set(u,n*r)}let i=s[t*r+t];for(let a=0;a<r;a+=1)s[t*r+a]/=i,e[t*r+a]/=i;for(let a=0;a<r;a+=1){let u=s[a*r+t];if(!(a===t||u===0)){for(let l=t;l<r;l+=1)s[a*r+l]-=u*s[t*r+l];for(let l=0;l<r;l+=1)e[a*r+l]-=u*e[t*r+l]}}}return e}var Kt=24;function fr(s,r,e,t,n,o){let i=t.length/Kt,a={wrenches:new Float64Array($*i),mass:new Float64Array(o*o),damping:new Float64Array(o*o),stiffness:new Float64Array(o*o)},u=(l,c)=>Float64Array.from({length:3*o},(f,h)=>n[(h%o*i+l)*Kt+c+Math.floor(h/o)]);return s.loads.forEach((l,c)=>{let{point:f,follower:h}=l,g=r.loads.subarray($*c,$*(c+1)),m=kt(l,g,e,0,t,Kt*f);if(xt(a.wrenches.subarray($*f,$*(f+1)),m,1),!h)return;let d=u(f,21);for(let[y,p]of[[u(f,18),0],[d,3]])xt(a.stiffness,U(y,U(ho(m.subarray(p,p+3)),d,3,3,o),o,3,o,!0),1)}),s.touch&&po(mo(s.touch,r.surface),r.touch,t,u(s.touch.point,18),a,o),a}function xt(s,r,e){for(let t=0;t<r.length;t+=1)s[t]+=e*r[t]}function ho([s,r,e]){return Float64Array.of(0,-e,r,e,0,-s,-r,s,0)}function mo(s,r){let[e,t,n,o]=r;if(s.radius)return{...s,axis:[e,t,n],radius:o};let[i,a,u]=s.axis;return{...s,distance:-(i*e+a*t+u*n)}}function po(s,r,e,t,n,o){let[i,a,u,l]=r,c=Kt*s.point+9,{gap:f,normal:h,curvature:g}=go(s,e.subarray(c,c+3)),m=l-u*f;if(!s.bilateral&&!(f<=0&&m>0))return;for(let p=0;p<3;p+=1)n.wrenches[$*s.point+p]+=m*h[p];let d=U(h,t,1,3,o),y=U(d,d,o,1,o);xt(n.mass,y,i),xt(n.damping,y,a),xt(n.stiffness,y,u),xt(n.stiffness,U(t,U(g,t,3,3,o),o,3,o,!0),-m)}function go(s,r){let e=u=>u[0]*r[0]+u[1]*r[1]+u[2]*r[2];if(!s.radius)return{gap:e(s.axis)+s.distance,normal:Float64Array.from(s.axis),curvature:new Float64Array(9)};let t=r.map((u,l)=>u-s.axis[l]),n=Math.hypot(...t)||1e-300,o=s.inside?-1:1,i=t.map(u=>u/n),a=Float64Array.from({length:9},(u,l)=>o*((l%4?0:1)-i[Math.floor(l/3)]*i[l%3])/n);return{gap:o*(n-s.radius),normal:i.map(u=>o*u),curvature:a}}function hr(s,r){let e=Array.from(s.frames.data).filter(t=>t<r);return e[e.length-1]!==r-1&&e.push(r-1),e}function B(s){return s.data instanceof Float64Array?s.data:Float64Array.from(s.data)}function yo(s,r,e){let t=s.knobs.map(o=>o.start),n=s.knobs.map(o=>o.factor);return s.sliders.forEach((o,i)=>{o.real?n[o.knob]=r[i]:t[o.knob]=r[i]}),e==="reference"?t:s.knobs.map((o,i)=>{let a=n[i];return a===null||o.factor===null?t[i]:o.together?o.factor?t[i]*(a/o.factor):t[i]:t[i]*a})}function jt(s,r,e){let t=s.runs[e],n=wo(t,yo(s,r,e)),o={};for(let[i,a]of Object.entries(t.places)){let u=a.shape.reduce((l,c)=>l*c,1);o[i]=n.slice(a.start,a.start+u)}return o}function wo(s,r){let e=B(s.base).slice(),t=s.powers.map(u=>mr(u,(l,c)=>Math.pow(r[l]/s.variables[l].start,c))),n=s.powers.map(u=>mr(u,(l,c)=>bo(s.variables[l],c,r[l]))),{products:o,terms:i,coefficients:a}=s;for(let u=0;u<o.data.length;u+=2)e[o.data[u]]*=t[o.data[u+1]];for(let u=0;u<i.data.length;u+=2)e[i.data[u]]+=a.data[u/2]*n[i.data[u+1]];return e}function mr(s,r){return s.reduce((e,[t,n])=>e*r(t,n),1)}function bo(s,r,e){let t=Math.pow(s.start,r);return(Math.pow(e,r)-t)/(Math.pow(s.far,r)-t)}var Fo=40,Ao=1e-12,Mo=.5,pr=1e-6,vo=.5,So=.001,Ro=1/128;function Eo(s,r,e,t,n,o){let[i,a,u]=[t.length+1,e.length,r.rotors.length],l=new Float64Array(i*a);for(let h=0;h<i;h+=1)l.set(e,h*a),h&&(l[h*a+t[h-1]]+=pr);let c={time:new Float64Array(1),state:l,row:r.rest_row,step:new Float64Array(1)},{rate:f}=s.sample("rest.rate",r.rest,c,i);for(let h=0;h<t.length;h+=1){o[h]=f[u+t[h]];for(let g=0;g<t.length;g+=1)n[h*t.length+g]=(f[(g+1)*a+u+t[h]]-o[h])/pr}}function ko(s,r,e,t){let n=s.layout.held,o=t.length,i=Array.from({length:o},(g,m)=>m).filter(g=>!n.includes(g)),a=new Float64Array(r.restSize);a.set(t);let u=new Float64Array(i.length**2),l=new Float64Array(i.length),c=1/0,[f,h]=[0,0];for(let g=0;g<Fo&&i.length;g+=1){if(Eo(s,e,a,i,u,l),!Gt(u,l))return null;let m=be(a,i,l);if(!Number.isFinite(m)||(g===0?f=m:h+=m,f>So&&h>vo*f))return null;if(Fe(m,c))return a.slice(0,o);c=m}return i.length?null:a.slice(0,o)}function be(s,r,e){let t=e.reduce((o,i)=>Math.max(o,Math.abs(i)),0),n=Math.min(1,Mo/t);for(let o=0;o<r.length;o+=1)s[r[o]]-=n*e[o];return t}function Fe(s,r){return s<Ao||s<1e-9&&s>=r/2}function Ae(s,r,e,t,n){let o=s.sliders.map(c=>c.value),i=c=>c===1?r:r.map((f,h)=>o[h]+(f-o[h])*c),[a,u,l]=[0,1,t];for(;a<1;){let c=Math.min(1,a+u),f=n(i(c),l);if(f)[a,u,l]=[c,2*u,f];else if(u>Ro)u/=2;else throw new Error(`${e}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`)}return l}function gr(s,r,e,t,n){let o=r.runs[t],i=B(o.start).slice(),[a,u]=[o.state.q[0],o.state.v[0]];if(r.atRest){let l=(f,h)=>ko(s,r,jt(r.map,f,t),h),c=Ae(r,e,t,i.slice(...o.state.q),l);for(let f=0;f<c.length;f+=1)o.info.includes(f)||(i[a+f]=c[f])}for(let[l,c]of o.exact){i[a+l]=Et(n,c,0);let f=n.degree;i[u+l]=f?n.coefficients[c*(f+1)+1]:0}return i}var xo=40,Tt=.001;function Qt(s,r,e,t){let{samples:n}=s.layout;return s.sample("loaded"in n?"loaded":"inertia",r.chain,e,t).forces}function jo(s,r,e,t,n){let o=n.length,i=new Float64Array(o),a=Float64Array.from({length:o*o},(F,A)=>A%(o+1)?0:1),u=B(r.base),l=s.sample("inertia",e.chain,{q:n,v:i,a,base:u},o),{points:c}=s.sample("inertia",e.chain,{q:n,v:i,a:i,base:u},1),f=fr(r,e,t,c,l.points,o),h=f.mass;for(let F=0;F<o;F+=1){for(let A=0;A<o;A+=1)h[F*o+A]+=(l.forces[F*o+A]+l.forces[A*o+F])/2;h[F*o+F]+=e.rotors[F]}let g=e.chain.slice();for(let F of r.modes.dry)g[F]=0;let m=s.slopes("elastic.slopes",g,{q:n,v:i,base:u},{q:a},o),d=s.slopes("elastic.slopes",g,{q:n,v:i,base:u},{v:a},o).slopes.forces,y=Io(s,r,e,n,f.wrenches),p=F=>F.map((A,R)=>F[R%o*o+Math.floor(R/o)]),w=p(m.slopes.forces),b=Qt(s,e,{q:n,v:i,a:i,base:B(r.modes.weight),wrenches:f.wrenches},1);return{mass:h,elastic:w,residual:b.map((F,A)=>F+m.values.forces[A]),damping:p(d).map((F,A)=>F+f.damping[A]),stiffness:w.map((F,A)=>F+y[A]+f.stiffness[A])}}function dr(s,r,e,t,n){let{free:o}=r.modes,[i,a,u]=[n.slice(),n.length,o.length],[l,c]=[1/0,!u];for(let f=0;f<xo;f+=1){let h=jo(s,r,e,t,i);if(c)return{rest:i,linear:h};let g=Float64Array.from({length:u*u},(y,p)=>h.stiffness[o[Math.floor(p/u)]*a+o[p%u]]),m=Float64Array.from(o,y=>h.residual[y]);if(!Gt(g,m))return null;let d=be(i,o,m);if(!Number.isFinite(d))return null;c=Fe(d,l),l=d}return null}function Io(s,r,e,t,n){let o=t.length,i=[Tt,-Tt,2*Tt,-2*Tt],a=new Float64Array(i.length*o*o);i.forEach((f,h)=>{for(let g=0;g<o;g+=1)a.set(t,(h*o+g)*o),a[(h*o+g)*o+g]+=f});let u=new Float64Array(o),l=Qt(s,e,{q:a,v:u,a:u,base:B(r.modes.weight),wrenches:n},i.length*o),c=(f,h,g)=>l[(f*o+g)*o+h];return Float64Array.from({length:o*o},(f,h)=>{let[g,m]=[Math.floor(h/o),h%o];return(8*(c(0,g,m)-c(1,g,m))-(c(2,g,m)-c(3,g,m)))/(12*Tt)})}function Y(s,r,e){let t=s.length/r,n=new Float64Array(t*e.length);for(let o=0;o<t;o+=1)for(let i=0;i<e.length;i+=1)n[o*e.length+i]=s[o*r+e[i]];return n}function at(s,r){return Array.from({length:r-s},(e,t)=>s+t)}function mt(s,r,e){let t=new Float64Array(e.length*r);for(let n=0;n<e.length;n+=1)for(let o=0;o<r;o+=1)t[n*r+o]=s[e[n]*r+o];return t}function Jt(s,r){return s.map((e,t)=>e-r[t])}function yt(s,r){let e=new Float64Array(s.length/r);for(let t=0;t<e.length;t+=1){let n=0;for(let o=0;o<r;o+=1)n+=s[t*r+o]**2;e[t]=Math.sqrt(n)}return e}function yr(s,r,e,t){let n=s.length/e,o=r.length/e,i=new Float64Array(e),a=0;for(let u=0;u<e;u+=1){let l=0;for(let c=0;c<n;c+=1)l+=s[u*n+c];u===0&&(a=l),i[u]=l-a;for(let c=0;c<o;c+=1)i[u]+=(c<t?-1:1)*r[u*o+c]}return i}function Ft(s){let r=0;for(let e=1;e<s.length;e+=1)Math.abs(s[e])>Math.abs(s[r])&&(r=e);return r}function j(s,r,...e){return{data:s,shape:[r,...e]}}var Xt=24;function wt(s,r,e){let[t,n]=s.matrix.shape,o=new Float64Array(e*t);for(let i=0;i<e;i+=1)for(let a=0;a<t;a+=1){let u=s.constant.data[a];for(let l=0;l<n;l+=1)u+=s.matrix.data[a*n+l]*r[i*n+l];o[i*t+a]=u}return o}function wr(s,r,{pose:e,surface:t},n,o,i,a){let u=w=>mt(n[w].data,n[w].shape.slice(1).reduce((b,F)=>b*F,1),i),l=i.length,c=Zt(s,r,e,u("q"),l),f=w=>Zt(s,r,e,w,l).line,h=w=>f(wt(r.straight,w,l)),g=h(u("q")),m=w=>({data:u(w),shape:[l,...n[w].shape.slice(1)]}),d="q_reference"in n,y=c.line.shape.slice(0,3),p=c.line.data.map((w,b)=>w-g.data[b]);return{times:{data:mt(o,1,i),shape:[l]},line:c.line,rigid:g,roots:c.roots,reference:d?f(u("q_reference")):null,referenceRigid:d?h(u("q_reference")):null,colours:[...a,{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:yt(p,3),shape:y}}],tip:m("tip"),tipReference:d?m("tip_reference"):null,contact:r.contactPoint<0?null:{force:m("contact_force"),at:Lo(r,n,i),surface:No(r,t)}}}function No({surface:s},r){let e=[r[0],r[1],r[2]];return s?.kind==="plane"?{...s,position:e}:s?{...s,center:e,radius:r[3]}:void 0}function Lo(s,r,e){let t=r.position.shape[1],n=mt(r.position.data,3*t,e),o=new Float64Array(3*e.length);for(let i=0;i<e.length;i+=1)for(let a=0;a<3;a+=1)o[3*i+a]=n[3*(i*t+s.contactPoint)+a];return{data:o,shape:[e.length,3]}}function Zt(s,r,e,t,n){let o=new Float64Array(t.length/n),{points:i}=s.sample("pose",e,{q:t,v:o,a:o,base:B(r.base)},n),[a,u]=[r.links.length,r.stations.data.length],l=i.length/n/Xt,c=new Float64Array(n*a*u*3),f=new Float64Array(n*a*4);for(let h=0;h<n;h+=1)r.links.forEach((g,m)=>{let d=i.subarray((h*l+g.point)*Xt,(h*l+g.point+1)*Xt);f.set(Bo(d),(h*a+m)*4),h&&To(f,(h*a+m)*4,4*a);for(let y=0;y<u;y+=1){let p=((h*a+m)*u+y)*3,w=(h*l+g.point+y)*Xt+9;for(let b=0;b<3;b+=1)c[p+b]=g.bends?i[w+b]:Oo(d,B(g.end),b,r.stations.data[y])}});return{line:{data:c,shape:[n,a,u,3]},roots:{data:f,shape:[n,a,4]}}}function To(s,r,e){let t=0;for(let n=r;n<r+4;n+=1)t+=s[n]*s[n-e];if(t<0)for(let n=r;n<r+4;n+=1)s[n]*=-1}function Oo(s,r,e,t){return s[9+e]+t*(s[3*e]*r[0]+s[3*e+1]*r[1]+s[3*e+2]*r[2])}function Bo(s){let r=s[0]+s[4]+s[8];if(r>0){let t=2*Math.sqrt(1+r);return[(s[7]-s[5])/t,(s[2]-s[6])/t,(s[3]-s[1])/t,t/4]}if(s[0]>s[4]&&s[0]>s[8]){let t=2*Math.sqrt(1+s[0]-s[4]-s[8]);return[t/4,(s[1]+s[3])/t,(s[2]+s[6])/t,(s[7]-s[5])/t]}if(s[4]>s[8]){let t=2*Math.sqrt(1+s[4]-s[0]-s[8]);return[(s[1]+s[3])/t,t/4,(s[5]+s[7])/t,(s[2]-s[6])/t]}let e=2*Math.sqrt(1+s[8]-s[0]-s[4]);return[(s[2]+s[6])/e,(s[5]+s[7])/e,e/4,(s[3]-s[1])/e]}var qo=Object.prototype.toString;function z(s){let r=qo.call(s);return r.endsWith("Array]")&&!r.includes("Big")}function Me(s,r={}){if(!z(s))throw new TypeError("input must be an array");if(s.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:t=s.length}=r;if(e<0||e>=s.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(t<=e||t>s.length||!Number.isInteger(t))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let n=s[e];for(let o=e+1;o<t;o++)s[o]>n&&(n=s[o]);return n}function ve(s,r={}){if(!z(s))throw new TypeError("input must be an array");if(s.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:t=s.length}=r;if(e<0||e>=s.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(t<=e||t>s.length||!Number.isInteger(t))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let n=s[e];for(let o=e+1;o<t;o++)s[o]<n&&(n=s[o]);return n}function Vt(s,r={}){if(z(s)){if(s.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let e;if(r.output!==void 0){if(!z(r.output))throw new TypeError("output option must be an array if specified");e=r.output}else e=new Array(s.length);let t=ve(s),n=Me(s);if(t===n)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:o=r.autoMinMax?t:0,max:i=r.autoMinMax?n:1}=r;if(o>=i)throw new RangeError("min option must be smaller than max option");let a=(i-o)/(n-t);for(let u=0;u<s.length;u++)e[u]=(s[u]-t)*a+o;return e}var Ht=" ".repeat(2),Fr=" ".repeat(4);function Ar(){return Se(this)}function Se(s,r={}){let{maxRows:e=15,maxColumns:t=10,maxNumSize:n=8,padMinus:o="auto"}=r;return`${s.constructor.name} {\n${Ht}[\n${Fr}${$o(s,e,t,n,o)}\n${Ht}]\n${Ht}rows: ${s.rows}\n${Ht}columns: ${s.columns}\n}`}function $o(s,r,e,t,n){let{rows:o,columns:i}=s,a=Math.min(o,r),u=Math.min(i,e),l=[];if(n==="auto"){n=!1;t:for(let c=0;c<a;c++)for(let f=0;f<u;f++)if(s.get(c,f)<0){n=!0;break t}}for(let c=0;c<a;c++){let f=[];for(let h=0;h<u;h++)f.push(Po(s.get(c,h),t,n));l.push(`${f.join(" ")}`)}return u!==i&&(l[l.length-1]+=` ... ${i-e} more columns`),a!==o&&l.push(`... ${o-r} more rows`),l.join(`\n${Fr}`)}function Po(s,r,e){return(s>=0&&e?` ${br(s,r-1)}`:br(s,r)).padEnd(r)}function br(s,r){let e=s.toString();if(e.length<=r)return e;let t=s.toFixed(r);if(t.length>r&&(t=s.toFixed(Math.max(0,r-(t.length-r)))),t.length<=r&&!t.startsWith("0.000")&&!t.startsWith("-0.000"))return t;let n=s.toExponential(r);return n.length>r&&(n=s.toExponential(Math.max(0,r-(n.length-r)))),n.slice(0)}function Mr(s,r){s.prototype.add=function(t){return typeof t=="number"?this.addS(t):this.addM(t)},s.prototype.addS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)+t);return this},s.prototype.addM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)+t.get(n,o));return this},s.add=function(t,n){return new r(t).add(n)},s.prototype.sub=function(t){return typeof t=="number"?this.subS(t):this.subM(t)},s.prototype.subS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)-t);return this},s.prototype.subM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)-t.get(n,o));return this},s.sub=function(t,n){return new r(t).sub(n)},s.prototype.subtract=s.prototype.sub,s.prototype.subtractS=s.prototype.subS,s.prototype.subtractM=s.prototype.subM,s.subtract=s.sub,s.prototype.mul=function(t){return typeof t=="number"?this.mulS(t):this.mulM(t)},s.prototype.mulS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)*t);return this},s.prototype.mulM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)*t.get(n,o));return this},s.mul=function(t,n){return new r(t).mul(n)},s.prototype.multiply=s.prototype.mul,s.prototype.multiplyS=s.prototype.mulS,s.prototype.multiplyM=s.prototype.mulM,s.multiply=s.mul,s.prototype.div=function(t){return typeof t=="number"?this.divS(t):this.divM(t)},s.prototype.divS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)/t);return this},s.prototype.divM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)/t.get(n,o));return this},s.div=function(t,n){return new r(t).div(n)},s.prototype.divide=s.prototype.div,s.prototype.divideS=s.prototype.divS,s.prototype.divideM=s.prototype.divM,s.divide=s.div,s.prototype.mod=function(t){return typeof t=="number"?this.modS(t):this.modM(t)},s.prototype.modS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)%t);return this},s.prototype.modM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)%t.get(n,o));return this},s.mod=function(t,n){return new r(t).mod(n)},s.prototype.modulus=s.prototype.mod,s.prototype.modulusS=s.prototype.modS,s.prototype.modulusM=s.prototype.modM,s.modulus=s.mod,s.prototype.and=function(t){return typeof t=="number"?this.andS(t):this.andM(t)},s.prototype.andS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)&t);return this},s.prototype.andM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)&t.get(n,o));return this},s.and=function(t,n){return new r(t).and(n)},s.prototype.or=function(t){return typeof t=="number"?this.orS(t):this.orM(t)},s.prototype.orS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)|t);return this},s.prototype.orM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)|t.get(n,o));return this},s.or=function(t,n){return new r(t).or(n)},s.prototype.xor=function(t){return typeof t=="number"?this.xorS(t):this.xorM(t)},s.prototype.xorS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)^t);return this},s.prototype.xorM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)^t.get(n,o));return this},s.xor=function(t,n){return new r(t).xor(n)},s.prototype.leftShift=function(t){return typeof t=="number"?this.leftShiftS(t):this.leftShiftM(t)},s.prototype.leftShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)<<t);return this},s.prototype.leftShiftM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)<<t.get(n,o));return this},s.leftShift=function(t,n){return new r(t).leftShift(n)},s.prototype.signPropagatingRightShift=function(t){return typeof t=="number"?this.signPropagatingRightShiftS(t):this.signPropagatingRightShiftM(t)},s.prototype.signPropagatingRightShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>t);return this},s.prototype.signPropagatingRightShiftM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>t.get(n,o));return this},s.signPropagatingRightShift=function(t,n){return new r(t).signPropagatingRightShift(n)},s.prototype.rightShift=function(t){return typeof t=="number"?this.rightShiftS(t):this.rightShiftM(t)},s.prototype.rightShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>>t);return this},s.prototype.rightShiftM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>>t.get(n,o));return this},s.rightShift=function(t,n){return new r(t).rightShift(n)},s.prototype.zeroFillRightShift=s.prototype.rightShift,s.prototype.zeroFillRightShiftS=s.prototype.rightShiftS,s.prototype.zeroFillRightShiftM=s.prototype.rightShiftM,s.zeroFillRightShift=s.rightShift,s.prototype.not=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,~this.get(t,n));return this},s.not=function(t){return new r(t).not()},s.prototype.abs=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.abs(this.get(t,n)));return this},s.abs=function(t){return new r(t).abs()},s.prototype.acos=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.acos(this.get(t,n)));return this},s.acos=function(t){return new r(t).acos()},s.prototype.acosh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.acosh(this.get(t,n)));return this},s.acosh=function(t){return new r(t).acosh()},s.prototype.asin=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.asin(this.get(t,n)));return this},s.asin=function(t){return new r(t).asin()},s.prototype.asinh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.asinh(this.get(t,n)));return this},s.asinh=function(t){return new r(t).asinh()},s.prototype.atan=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.atan(this.get(t,n)));return this},s.atan=function(t){return new r(t).atan()},s.prototype.atanh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.atanh(this.get(t,n)));return this},s.atanh=function(t){return new r(t).atanh()},s.prototype.cbrt=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cbrt(this.get(t,n)));return this},s.cbrt=function(t){return new r(t).cbrt()},s.prototype.ceil=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.ceil(this.get(t,n)));return this},s.ceil=function(t){return new r(t).ceil()},s.prototype.clz32=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.clz32(this.get(t,n)));return this},s.clz32=function(t){return new r(t).clz32()},s.prototype.cos=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cos(this.get(t,n)));return this},s.cos=function(t){return new r(t).cos()},s.prototype.cosh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cosh(this.get(t,n)));return this},s.cosh=function(t){return new r(t).cosh()},s.prototype.exp=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.exp(this.get(t,n)));return this},s.exp=function(t){return new r(t).exp()},s.prototype.expm1=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.expm1(this.get(t,n)));return this},s.expm1=function(t){return new r(t).expm1()},s.prototype.floor=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.floor(this.get(t,n)));return this},s.floor=function(t){return new r(t).floor()},s.prototype.fround=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.fround(this.get(t,n)));return this},s.fround=function(t){return new r(t).fround()},s.prototype.log=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log(this.get(t,n)));return this},s.log=function(t){return new r(t).log()},s.prototype.log1p=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log1p(this.get(t,n)));return this},s.log1p=function(t){return new r(t).log1p()},s.prototype.log10=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log10(this.get(t,n)));return this},s.log10=function(t){return new r(t).log10()},s.prototype.log2=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log2(this.get(t,n)));return this},s.log2=function(t){return new r(t).log2()},s.prototype.round=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.round(this.get(t,n)));return this},s.round=function(t){return new r(t).round()},s.prototype.sign=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sign(this.get(t,n)));return this},s.sign=function(t){return new r(t).sign()},s.prototype.sin=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sin(this.get(t,n)));return this},s.sin=function(t){return new r(t).sin()},s.prototype.sinh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sinh(this.get(t,n)));return this},s.sinh=function(t){return new r(t).sinh()},s.prototype.sqrt=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sqrt(this.get(t,n)));return this},s.sqrt=function(t){return new r(t).sqrt()},s.prototype.tan=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.tan(this.get(t,n)));return this},s.tan=function(t){return new r(t).tan()},s.prototype.tanh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.tanh(this.get(t,n)));return this},s.tanh=function(t){return new r(t).tanh()},s.prototype.trunc=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.trunc(this.get(t,n)));return this},s.trunc=function(t){return new r(t).trunc()},s.pow=function(t,n){return new r(t).pow(n)},s.prototype.pow=function(t){return typeof t=="number"?this.powS(t):this.powM(t)},s.prototype.powS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)**t);return this},s.prototype.powM=function(t){if(t=r.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)**t.get(n,o));return this}}function rt(s,r,e){let t=e?s.rows:s.rows-1;if(r<0||r>t)throw new RangeError("Row index out of range")}function nt(s,r,e){let t=e?s.columns:s.columns-1;if(r<0||r>t)throw new RangeError("Column index out of range")}function At(s,r){if(r.to1DArray&&(r=r.to1DArray()),r.length!==s.columns)throw new RangeError("vector size must be the same as the number of columns");return r}function Mt(s,r){if(r.to1DArray&&(r=r.to1DArray()),r.length!==s.rows)throw new RangeError("vector size must be the same as the number of rows");return r}function vr(s,r){if(!z(r))throw new TypeError("row indices must be an array");for(let e=0;e<r.length;e++)if(r[e]<0||r[e]>=s.rows)throw new RangeError("row indices are out of range")}function Sr(s,r){if(!z(r))throw new TypeError("column indices must be an array");for(let e=0;e<r.length;e++)if(r[e]<0||r[e]>=s.columns)throw new RangeError("column indices are out of range")}function Re(s,r,e,t,n){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(te("startRow",r),te("endRow",e),te("startColumn",t),te("endColumn",n),r>e||t>n||r<0||r>=s.rows||e<0||e>=s.rows||t<0||t>=s.columns||n<0||n>=s.columns)throw new RangeError("Submatrix indices are out of range")}function Ot(s,r=0){let e=[];for(let t=0;t<s;t++)e.push(r);return e}function te(s,r){if(typeof r!="number")throw new TypeError(`${s} must be a number`)}function vt(s){if(s.isEmpty())throw new Error("Empty matrix has no elements to index")}function Rr(s){let r=Ot(s.rows);for(let e=0;e<s.rows;++e)for(let t=0;t<s.columns;++t)r[e]+=s.get(e,t);return r}function Er(s){let r=Ot(s.columns);for(let e=0;e<s.rows;++e)for(let t=0;t<s.columns;++t)r[t]+=s.get(e,t);return r}function kr(s){let r=0;for(let e=0;e<s.rows;e++)for(let t=0;t<s.columns;t++)r+=s.get(e,t);return r}function xr(s){let r=Ot(s.rows,1);for(let e=0;e<s.rows;++e)for(let t=0;t<s.columns;++t)r[e]*=s.get(e,t);return r}function jr(s){let r=Ot(s.columns,1);for(let e=0;e<s.rows;++e)for(let t=0;t<s.columns;++t)r[t]*=s.get(e,t);return r}function Ir(s){let r=1;for(let e=0;e<s.rows;e++)for(let t=0;t<s.columns;t++)r*=s.get(e,t);return r}function Nr(s,r,e){let t=s.rows,n=s.columns,o=[];for(let i=0;i<t;i++){let a=0,u=0,l=0;for(let c=0;c<n;c++)l=s.get(i,c)-e[i],a+=l,u+=l*l;r?o.push((u-a*a/n)/(n-1)):o.push((u-a*a/n)/n)}return o}function Lr(s,r,e){let t=s.rows,n=s.columns,o=[];for(let i=0;i<n;i++){let a=0,u=0,l=0;for(let c=0;c<t;c++)l=s.get(c,i)-e[i],a+=l,u+=l*l;r?o.push((u-a*a/t)/(t-1)):o.push((u-a*a/t)/t)}return o}function Tr(s,r,e){let t=s.rows,n=s.columns,o=t*n,i=0,a=0,u=0;for(let l=0;l<t;l++)for(let c=0;c<n;c++)u=s.get(l,c)-e,i+=u,a+=u*u;return r?(a-i*i/o)/(o-1):(a-i*i/o)/o}function Or(s,r){for(let e=0;e<s.rows;e++)for(let t=0;t<s.columns;t++)s.set(e,t,s.get(e,t)-r[e])}function Br(s,r){for(let e=0;e<s.rows;e++)for(let t=0;t<s.columns;t++)s.set(e,t,s.get(e,t)-r[t])}function qr(s,r){for(let e=0;e<s.rows;e++)for(let t=0;t<s.columns;t++)s.set(e,t,s.get(e,t)-r)}function $r(s){let r=[];for(let e=0;e<s.rows;e++){let t=0;for(let n=0;n<s.columns;n++)t+=s.get(e,n)**2/(s.columns-1);r.push(Math.sqrt(t))}return r}function Pr(s,r){for(let e=0;e<s.rows;e++)for(let t=0;t<s.columns;t++)s.set(e,t,s.get(e,t)/r[e])}function _r(s){let r=[];for(let e=0;e<s.columns;e++){let t=0;for(let n=0;n<s.rows;n++)t+=s.get(n,e)**2/(s.rows-1);r.push(Math.sqrt(t))}return r}function zr(s,r){for(let e=0;e<s.rows;e++)for(let t=0;t<s.columns;t++)s.set(e,t,s.get(e,t)/r[t])}function Cr(s){let r=s.size-1,e=0;for(let t=0;t<s.columns;t++)for(let n=0;n<s.rows;n++)e+=s.get(n,t)**2/r;return Math.sqrt(e)}function Wr(s,r){for(let e=0;e<s.rows;e++)for(let t=0;t<s.columns;t++)s.set(e,t,s.get(e,t)/r)}var T=class s{static from1DArray(r,e,t){if(r*e!==t.length)throw new RangeError("data length does not match given dimensions");let o=new M(r,e);for(let i=0;i<r;i++)for(let a=0;a<e;a++)o.set(i,a,t[i*e+a]);return o}static rowVector(r){let e=new M(1,r.length);for(let t=0;t<r.length;t++)e.set(0,t,r[t]);return e}static columnVector(r){let e=new M(r.length,1);for(let t=0;t<r.length;t++)e.set(t,0,r[t]);return e}static zeros(r,e){return new M(r,e)}static ones(r,e){return new M(r,e).fill(1)}static rand(r,e,t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{random:n=Math.random}=t,o=new M(r,e);for(let i=0;i<r;i++)for(let a=0;a<e;a++)o.set(i,a,n());return o}static randInt(r,e,t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:n=0,max:o=1e3,random:i=Math.random}=t;if(!Number.isInteger(n))throw new TypeError("min must be an integer");if(!Number.isInteger(o))throw new TypeError("max must be an integer");if(n>=o)throw new RangeError("min must be smaller than max");let a=o-n,u=new M(r,e);for(let l=0;l<r;l++)for(let c=0;c<e;c++){let f=n+Math.round(i()*a);u.set(l,c,f)}return u}static eye(r,e,t){e===void 0&&(e=r),t===void 0&&(t=1);let n=Math.min(r,e),o=this.zeros(r,e);for(let i=0;i<n;i++)o.set(i,i,t);return o}static diag(r,e,t){let n=r.length;e===void 0&&(e=n),t===void 0&&(t=e);let o=Math.min(n,e,t),i=this.zeros(e,t);for(let a=0;a<o;a++)i.set(a,a,r[a]);return i}static min(r,e){r=this.checkMatrix(r),e=this.checkMatrix(e);let t=r.rows,n=r.columns,o=new M(t,n);for(let i=0;i<t;i++)for(let a=0;a<n;a++)o.set(i,a,Math.min(r.get(i,a),e.get(i,a)));return o}static max(r,e){r=this.checkMatrix(r),e=this.checkMatrix(e);let t=r.rows,n=r.columns,o=new this(t,n);for(let i=0;i<t;i++)for(let a=0;a<n;a++)o.set(i,a,Math.max(r.get(i,a),e.get(i,a)));return o}static checkMatrix(r){return s.isMatrix(r)?r:new M(r)}static isMatrix(r){return r!=null&&r.klass==="Matrix"}get size(){return this.rows*this.columns}apply(r){if(typeof r!="function")throw new TypeError("callback must be a function");for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)r.call(this,e,t);return this}applyAlongAxis(r,e){if(typeof r!="function")throw new TypeError("callback must be a function");let t=[];switch(e){case"row":{for(let n=0;n<this.rows;n++)t.push(r.call(this,this.getRow(n),n));break}case"column":{for(let n=0;n<this.columns;n++)t.push(r.call(this,this.getColumn(n),n));break}default:throw new Error(`invalid option: ${e}`)}return t}to1DArray(){let r=[];for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)r.push(this.get(e,t));return r}to2DArray(){let r=[];for(let e=0;e<this.rows;e++){r.push([]);for(let t=0;t<this.columns;t++)r[e].push(this.get(e,t))}return r}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let r=0;r<this.rows;r++)for(let e=0;e<=r;e++)if(this.get(r,e)!==this.get(e,r))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let r=0;r<this.rows;r++)if(this.get(r,r)!==0)return!1;return!0}isEchelonForm(){let r=0,e=0,t=-1,n=!0,o=!1;for(;r<this.rows&&n;){for(e=0,o=!1;e<this.columns&&o===!1;)this.get(r,e)===0?e++:this.get(r,e)===1&&e>t?(o=!0,t=e):(n=!1,o=!0);r++}return n}isReducedEchelonForm(){let r=0,e=0,t=-1,n=!0,o=!1;for(;r<this.rows&&n;){for(e=0,o=!1;e<this.columns&&o===!1;)this.get(r,e)===0?e++:this.get(r,e)===1&&e>t?(o=!0,t=e):(n=!1,o=!0);for(let i=e+1;i<this.rows;i++)this.get(r,i)!==0&&(n=!1);r++}return n}echelonForm(){let r=this.clone(),e=0,t=0;for(;e<r.rows&&t<r.columns;){let n=e;for(let o=e;o<r.rows;o++)r.get(o,t)>r.get(n,t)&&(n=o);if(r.get(n,t)===0)t++;else{r.swapRows(e,n);let o=r.get(e,t);for(let i=t;i<r.columns;i++)r.set(e,i,r.get(e,i)/o);for(let i=e+1;i<r.rows;i++){let a=r.get(i,t)/r.get(e,t);r.set(i,t,0);for(let u=t+1;u<r.columns;u++)r.set(i,u,r.get(i,u)-r.get(e,u)*a)}e++,t++}}return r}reducedEchelonForm(){let r=this.echelonForm(),e=r.columns,t=r.rows,n=t-1;for(;n>=0;)if(r.maxRow(n)===0)n--;else{let o=0,i=!1;for(;o<t&&i===!1;)r.get(n,o)===1?i=!0:o++;for(let a=0;a<n;a++){let u=r.get(a,o);for(let l=o;l<e;l++){let c=r.get(a,l)-u*r.get(n,l);r.set(a,l,c)}}n--}return r}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(r={}){if(typeof r!="object")throw new TypeError("options must be an object");let{rows:e=1,columns:t=1}=r;if(!Number.isInteger(e)||e<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(t)||t<=0)throw new TypeError("columns must be a positive integer");let n=new M(this.rows*e,this.columns*t);for(let o=0;o<e;o++)for(let i=0;i<t;i++)n.setSubMatrix(this,this.rows*o,this.columns*i);return n}fill(r){for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,r);return this}neg(){return this.mulS(-1)}getRow(r){rt(this,r);let e=[];for(let t=0;t<this.columns;t++)e.push(this.get(r,t));return e}getRowVector(r){return M.rowVector(this.getRow(r))}setRow(r,e){rt(this,r),e=At(this,e);for(let t=0;t<this.columns;t++)this.set(r,t,e[t]);return this}swapRows(r,e){rt(this,r),rt(this,e);for(let t=0;t<this.columns;t++){let n=this.get(r,t);this.set(r,t,this.get(e,t)),this.set(e,t,n)}return this}getColumn(r){nt(this,r);let e=[];for(let t=0;t<this.rows;t++)e.push(this.get(t,r));return e}getColumnVector(r){return M.columnVector(this.getColumn(r))}setColumn(r,e){nt(this,r),e=Mt(this,e);for(let t=0;t<this.rows;t++)this.set(t,r,e[t]);return this}swapColumns(r,e){nt(this,r),nt(this,e);for(let t=0;t<this.rows;t++){let n=this.get(t,r);this.set(t,r,this.get(t,e)),this.set(t,e,n)}return this}addRowVector(r){r=At(this,r);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)+r[t]);return this}subRowVector(r){r=At(this,r);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)-r[t]);return this}mulRowVector(r){r=At(this,r);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)*r[t]);return this}divRowVector(r){r=At(this,r);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)/r[t]);return this}addColumnVector(r){r=Mt(this,r);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)+r[e]);return this}subColumnVector(r){r=Mt(this,r);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)-r[e]);return this}mulColumnVector(r){r=Mt(this,r);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)*r[e]);return this}divColumnVector(r){r=Mt(this,r);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)/r[e]);return this}mulRow(r,e){rt(this,r);for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)*e);return this}mulColumn(r,e){nt(this,r);for(let t=0;t<this.rows;t++)this.set(t,r,this.get(t,r)*e);return this}max(r){if(this.isEmpty())return NaN;switch(r){case"row":{let e=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>e[t]&&(e[t]=this.get(t,n));return e}case"column":{let e=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>e[n]&&(e[n]=this.get(t,n));return e}case void 0:{let e=this.get(0,0);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>e&&(e=this.get(t,n));return e}default:throw new Error(`invalid option: ${r}`)}}maxIndex(){vt(this);let r=this.get(0,0),e=[0,0];for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>r&&(r=this.get(t,n),e[0]=t,e[1]=n);return e}min(r){if(this.isEmpty())return NaN;switch(r){case"row":{let e=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<e[t]&&(e[t]=this.get(t,n));return e}case"column":{let e=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<e[n]&&(e[n]=this.get(t,n));return e}case void 0:{let e=this.get(0,0);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<e&&(e=this.get(t,n));return e}default:throw new Error(`invalid option: ${r}`)}}minIndex(){vt(this);let r=this.get(0,0),e=[0,0];for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<r&&(r=this.get(t,n),e[0]=t,e[1]=n);return e}maxRow(r){if(rt(this,r),this.isEmpty())return NaN;let e=this.get(r,0);for(let t=1;t<this.columns;t++)this.get(r,t)>e&&(e=this.get(r,t));return e}maxRowIndex(r){rt(this,r),vt(this);let e=this.get(r,0),t=[r,0];for(let n=1;n<this.columns;n++)this.get(r,n)>e&&(e=this.get(r,n),t[1]=n);return t}minRow(r){if(rt(this,r),this.isEmpty())return NaN;let e=this.get(r,0);for(let t=1;t<this.columns;t++)this.get(r,t)<e&&(e=this.get(r,t));return e}minRowIndex(r){rt(this,r),vt(this);let e=this.get(r,0),t=[r,0];for(let n=1;n<this.columns;n++)this.get(r,n)<e&&(e=this.get(r,n),t[1]=n);return t}maxColumn(r){if(nt(this,r),this.isEmpty())return NaN;let e=this.get(0,r);for(let t=1;t<this.rows;t++)this.get(t,r)>e&&(e=this.get(t,r));return e}maxColumnIndex(r){nt(this,r),vt(this);let e=this.get(0,r),t=[0,r];for(let n=1;n<this.rows;n++)this.get(n,r)>e&&(e=this.get(n,r),t[0]=n);return t}minColumn(r){if(nt(this,r),this.isEmpty())return NaN;let e=this.get(0,r);for(let t=1;t<this.rows;t++)this.get(t,r)<e&&(e=this.get(t,r));return e}minColumnIndex(r){nt(this,r),vt(this);let e=this.get(0,r),t=[0,r];for(let n=1;n<this.rows;n++)this.get(n,r)<e&&(e=this.get(n,r),t[0]=n);return t}diag(){let r=Math.min(this.rows,this.columns),e=[];for(let t=0;t<r;t++)e.push(this.get(t,t));return e}norm(r="frobenius"){switch(r){case"max":return M.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${r}`)}}cumulativeSum(){let r=0;for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)r+=this.get(e,t),this.set(e,t,r);return this}dot(r){s.isMatrix(r)&&(r=r.to1DArray());let e=this.to1DArray();if(e.length!==r.length)throw new RangeError("vectors do not have the same size");let t=0;for(let n=0;n<e.length;n++)t+=e[n]*r[n];return t}mmul(r){r=M.checkMatrix(r);let e=this.rows,t=this.columns,n=r.columns,o=new M(e,n),i=new Float64Array(t);for(let a=0;a<n;a++){for(let u=0;u<t;u++)i[u]=r.get(u,a);for(let u=0;u<e;u++){let l=0;for(let c=0;c<t;c++)l+=this.get(u,c)*i[c];o.set(u,a,l)}}return o}gram(){let r=this.rows,e=this.columns,t=new Float64Array(e*e);for(let o=0;o<r;o++)for(let i=0;i<e;i++){let a=this.get(o,i);if(a===0)continue;let u=i*e;for(let l=i;l<e;l++)t[u+l]+=a*this.get(o,l)}let n=new M(e,e);for(let o=0;o<e;o++){let i=o*e;for(let a=o;a<e;a++){let u=t[i+a];n.set(o,a,u),n.set(a,o,u)}}return n}transposeMultiply(r){if(r=M.checkMatrix(r),this.rows!==r.rows)throw new RangeError("the number of rows of the two matrices must be equal");let e=this.columns,t=r.columns,n=new M(e,t),o=new Float64Array(t);for(let i=0;i<this.rows;i++){for(let a=0;a<t;a++)o[a]=r.get(i,a);for(let a=0;a<e;a++){let u=this.get(i,a);if(u===0)continue;let l=n.data[a];for(let c=0;c<t;c++)l[c]+=u*o[c]}}return n}mmulByTranspose(r){let e=this.rows,t=this.columns;if(r!==void 0&&r.length!==t)throw new RangeError("scale must have one value per column");let n=new M(e,e),o=new Float64Array(t);for(let i=0;i<e;i++){if(r===void 0)for(let a=0;a<t;a++)o[a]=this.get(i,a);else for(let a=0;a<t;a++)o[a]=r[a]*this.get(i,a);for(let a=i;a<e;a++){let u=0;for(let l=0;l<t;l++)u+=this.get(a,l)*o[l];n.set(a,i,u),n.set(i,a,u)}}return n}mpow(r){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(r)||r<0)throw new RangeError("Exponent must be a non-negative integer");let e=M.eye(this.rows),t=this;for(let n=r;n>=1;n/=2)(n&1)!==0&&(e=e.mmul(t)),t=t.mmul(t);return e}strassen2x2(r){r=M.checkMatrix(r);let e=new M(2,2),t=this.get(0,0),n=r.get(0,0),o=this.get(0,1),i=r.get(0,1),a=this.get(1,0),u=r.get(1,0),l=this.get(1,1),c=r.get(1,1),f=(t+l)*(n+c),h=(a+l)*n,g=t*(i-c),m=l*(u-n),d=(t+o)*c,y=(a-t)*(n+i),p=(o-l)*(u+c),w=f+m-d+p,b=g+d,F=h+m,A=f-h+g+y;return e.set(0,0,w),e.set(0,1,b),e.set(1,0,F),e.set(1,1,A),e}strassen3x3(r){r=M.checkMatrix(r);let e=new M(3,3),t=this.get(0,0),n=this.get(0,1),o=this.get(0,2),i=this.get(1,0),a=this.get(1,1),u=this.get(1,2),l=this.get(2,0),c=this.get(2,1),f=this.get(2,2),h=r.get(0,0),g=r.get(0,1),m=r.get(0,2),d=r.get(1,0),y=r.get(1,1),p=r.get(1,2),w=r.get(2,0),b=r.get(2,1),F=r.get(2,2),A=(t+n+o-i-a-c-f)*y,R=(t-i)*(-g+y),E=a*(-h+g+d-y-p-w+F),v=(-t+i+a)*(h-g+y),k=(i+a)*(-h+g),N=t*h,q=(-t+l+c)*(h-m+p),P=(-t+l)*(m-p),_=(l+c)*(-h+m),ct=(t+n+o-a-u-l-c)*p,W=c*(-h+m+d-y-p-w+b),K=(-o+c+f)*(y+w-b),Ct=(o-f)*(y-b),ft=o*w,Rt=(c+f)*(-w+b),Q=(-o+a+u)*(p+w-F),Qe=(o-u)*(p-F),Je=(a+u)*(-w+F),Tn=n*d,On=u*b,Bn=i*m,qn=l*g,$n=f*F,Pn=N+ft+Tn,_n=A+v+k+N+K+ft+Rt,zn=N+q+_+ct+ft+Q+Je,Cn=R+E+v+N+ft+Q+Qe,Wn=R+v+k+N+On,Dn=ft+Q+Qe+Je+Bn,Gn=N+q+P+W+K+Ct+ft,Un=K+Ct+ft+Rt+qn,Yn=N+q+P+_+$n;return e.set(0,0,Pn),e.set(0,1,_n),e.set(0,2,zn),e.set(1,0,Cn),e.set(1,1,Wn),e.set(1,2,Dn),e.set(2,0,Gn),e.set(2,1,Un),e.set(2,2,Yn),e}mmulStrassen(r){r=M.checkMatrix(r);let e=this.clone(),t=e.rows,n=e.columns,o=r.rows,i=r.columns;n!==o&&console.warn(`Multiplying ${t} x ${n} and ${o} x ${i} matrix: dimensions do not match.`);function a(f,h,g){let m=f.rows,d=f.columns;if(m===h&&d===g)return f;{let y=s.zeros(h,g);return y=y.setSubMatrix(f,0,0),y}}let u=Math.max(t,o),l=Math.max(n,i);e=a(e,u,l),r=a(r,u,l);function c(f,h,g,m){if(g<=512||m<=512)return f.mmul(h);g%2===1&&m%2===1?(f=a(f,g+1,m+1),h=a(h,g+1,m+1)):g%2===1?(f=a(f,g+1,m),h=a(h,g+1,m)):m%2===1&&(f=a(f,g,m+1),h=a(h,g,m+1));let d=parseInt(f.rows/2,10),y=parseInt(f.columns/2,10),p=f.subMatrix(0,d-1,0,y-1),w=h.subMatrix(0,d-1,0,y-1),b=f.subMatrix(0,d-1,y,f.columns-1),F=h.subMatrix(0,d-1,y,h.columns-1),A=f.subMatrix(d,f.rows-1,0,y-1),R=h.subMatrix(d,h.rows-1,0,y-1),E=f.subMatrix(d,f.rows-1,y,f.columns-1),v=h.subMatrix(d,h.rows-1,y,h.columns-1),k=c(s.add(p,E),s.add(w,v),d,y),N=c(s.add(A,E),w,d,y),q=c(p,s.sub(F,v),d,y),P=c(E,s.sub(R,w),d,y),_=c(s.add(p,b),v,d,y),ct=c(s.sub(A,p),s.add(w,F),d,y),W=c(s.sub(b,E),s.add(R,v),d,y),K=s.add(k,P);K.sub(_),K.add(W);let Ct=s.add(q,_),ft=s.add(N,P),Rt=s.sub(k,N);Rt.add(q),Rt.add(ct);let Q=s.zeros(2*K.rows,2*K.columns);return Q=Q.setSubMatrix(K,0,0),Q=Q.setSubMatrix(Ct,K.rows,0),Q=Q.setSubMatrix(ft,0,K.columns),Q=Q.setSubMatrix(Rt,K.rows,K.columns),Q.subMatrix(0,g-1,0,m-1)}return c(e,r,u,l)}scaleRows(r={}){if(typeof r!="object")throw new TypeError("options must be an object");let{min:e=0,max:t=1}=r;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(t))throw new TypeError("max must be a number");if(e>=t)throw new RangeError("min must be smaller than max");let n=new M(this.rows,this.columns);for(let o=0;o<this.rows;o++){let i=this.getRow(o);i.length>0&&Vt(i,{min:e,max:t,output:i}),n.setRow(o,i)}return n}scaleColumns(r={}){if(typeof r!="object")throw new TypeError("options must be an object");let{min:e=0,max:t=1}=r;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(t))throw new TypeError("max must be a number");if(e>=t)throw new RangeError("min must be smaller than max");let n=new M(this.rows,this.columns);for(let o=0;o<this.columns;o++){let i=this.getColumn(o);i.length&&Vt(i,{min:e,max:t,output:i}),n.setColumn(o,i)}return n}flipRows(){let r=Math.ceil(this.columns/2);for(let e=0;e<this.rows;e++)for(let t=0;t<r;t++){let n=this.get(e,t),o=this.get(e,this.columns-1-t);this.set(e,t,o),this.set(e,this.columns-1-t,n)}return this}flipColumns(){let r=Math.ceil(this.rows/2);for(let e=0;e<this.columns;e++)for(let t=0;t<r;t++){let n=this.get(t,e),o=this.get(this.rows-1-t,e);this.set(t,e,o),this.set(this.rows-1-t,e,n)}return this}kroneckerProduct(r){r=M.checkMatrix(r);let e=this.rows,t=this.columns,n=r.rows,o=r.columns,i=new M(e*n,t*o);for(let a=0;a<e;a++)for(let u=0;u<t;u++)for(let l=0;l<n;l++)for(let c=0;c<o;c++)i.set(n*a+l,o*u+c,this.get(a,u)*r.get(l,c));return i}kroneckerSum(r){if(r=M.checkMatrix(r),!this.isSquare()||!r.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let e=this.rows,t=r.rows,n=this.kroneckerProduct(M.eye(t,t)),o=M.eye(e,e).kroneckerProduct(r);return n.add(o)}transpose(){let r=new M(this.columns,this.rows);for(let e=0;e<this.rows;e++)for(let t=0;t<this.columns;t++)r.set(t,e,this.get(e,t));return r}sortRows(r=Dr){for(let e=0;e<this.rows;e++)this.setRow(e,this.getRow(e).sort(r));return this}sortColumns(r=Dr){for(let e=0;e<this.columns;e++)this.setColumn(e,this.getColumn(e).sort(r));return this}subMatrix(r,e,t,n){Re(this,r,e,t,n);let o=new M(e-r+1,n-t+1);for(let i=r;i<=e;i++)for(let a=t;a<=n;a++)o.set(i-r,a-t,this.get(i,a));return o}subMatrixRow(r,e,t){if(e===void 0&&(e=0),t===void 0&&(t=this.columns-1),e>t||e<0||e>=this.columns||t<0||t>=this.columns)throw new RangeError("Argument out of range");let n=new M(r.length,t-e+1);for(let o=0;o<r.length;o++)for(let i=e;i<=t;i++){if(r[o]<0||r[o]>=this.rows)throw new RangeError(`Row index out of range: ${r[o]}`);n.set(o,i-e,this.get(r[o],i))}return n}subMatrixColumn(r,e,t){if(e===void 0&&(e=0),t===void 0&&(t=this.rows-1),e>t||e<0||e>=this.rows||t<0||t>=this.rows)throw new RangeError("Argument out of range");let n=new M(t-e+1,r.length);for(let o=0;o<r.length;o++)for(let i=e;i<=t;i++){if(r[o]<0||r[o]>=this.columns)throw new RangeError(`Column index out of range: ${r[o]}`);n.set(i-e,o,this.get(i,r[o]))}return n}setSubMatrix(r,e,t){if(r=M.checkMatrix(r),r.isEmpty())return this;let n=e+r.rows-1,o=t+r.columns-1;Re(this,e,n,t,o);for(let i=0;i<r.rows;i++)for(let a=0;a<r.columns;a++)this.set(e+i,t+a,r.get(i,a));return this}concat(r,e="row"){switch(r=M.checkMatrix(r),e){case"row":{if(this.columns!==r.columns)throw new RangeError("both matrices must have the same number of columns");let t=new M(this.rows+r.rows,this.columns);return t.setSubMatrix(this,0,0),t.setSubMatrix(r,this.rows,0),t}case"column":{if(this.rows!==r.rows)throw new RangeError("both matrices must have the same number of rows");let t=new M(this.rows,this.columns+r.columns);return t.setSubMatrix(this,0,0),t.setSubMatrix(r,0,this.columns),t}default:throw new Error(`invalid option: ${e}`)}}selection(r,e){vr(this,r),Sr(this,e);let t=new M(r.length,e.length);for(let n=0;n<r.length;n++){let o=r[n];for(let i=0;i<e.length;i++){let a=e[i];t.set(n,i,this.get(o,a))}}return t}trace(){let r=Math.min(this.rows,this.columns),e=0;for(let t=0;t<r;t++)e+=this.get(t,t);return e}clone(){return this.constructor.copy(this,new M(this.rows,this.columns))}static copy(r,e){for(let[t,n,o]of r.entries())e.set(t,n,o);return e}sum(r){switch(r){case"row":return Rr(this);case"column":return Er(this);case void 0:return kr(this);default:throw new Error(`invalid option: ${r}`)}}product(r){switch(r){case"row":return xr(this);case"column":return jr(this);case void 0:return Ir(this);default:throw new Error(`invalid option: ${r}`)}}mean(r){let e=this.sum(r);switch(r){case"row":{for(let t=0;t<this.rows;t++)e[t]/=this.columns;return e}case"column":{for(let t=0;t<this.columns;t++)e[t]/=this.rows;return e}case void 0:return e/this.size;default:throw new Error(`invalid option: ${r}`)}}variance(r,e={}){if(typeof r=="object"&&(e=r,r=void 0),typeof e!="object")throw new TypeError("options must be an object");let{unbiased:t=!0,mean:n=this.mean(r)}=e;if(typeof t!="boolean")throw new TypeError("unbiased must be a boolean");switch(r){case"row":{if(!z(n))throw new TypeError("mean must be an array");return Nr(this,t,n)}case"column":{if(!z(n))throw new TypeError("mean must be an array");return Lr(this,t,n)}case void 0:{if(typeof n!="number")throw new TypeError("mean must be a number");return Tr(this,t,n)}default:throw new Error(`invalid option: ${r}`)}}standardDeviation(r,e){typeof r=="object"&&(e=r,r=void 0);let t=this.variance(r,e);if(r===void 0)return Math.sqrt(t);for(let n=0;n<t.length;n++)t[n]=Math.sqrt(t[n]);return t}center(r,e={}){if(typeof r=="object"&&(e=r,r=void 0),typeof e!="object")throw new TypeError("options must be an object");let{center:t=this.mean(r)}=e;switch(r){case"row":{if(!z(t))throw new TypeError("center must be an array");return Or(this,t),this}case"column":{if(!z(t))throw new TypeError("center must be an array");return Br(this,t),this}case void 0:{if(typeof t!="number")throw new TypeError("center must be a number");return qr(this,t),this}default:throw new Error(`invalid option: ${r}`)}}scale(r,e={}){if(typeof r=="object"&&(e=r,r=void 0),typeof e!="object")throw new TypeError("options must be an object");let t=e.scale;switch(r){case"row":{if(t===void 0)t=$r(this);else if(!z(t))throw new TypeError("scale must be an array");return Pr(this,t),this}case"column":{if(t===void 0)t=_r(this);else if(!z(t))throw new TypeError("scale must be an array");return zr(this,t),this}case void 0:{if(t===void 0)t=Cr(this);else if(typeof t!="number")throw new TypeError("scale must be a number");return Wr(this,t),this}default:throw new Error(`invalid option: ${r}`)}}toString(r){return Se(this,r)}[Symbol.iterator](){return this.entries()}*entries(){for(let r=0;r<this.rows;r++)for(let e=0;e<this.columns;e++)yield[r,e,this.get(r,e)]}*values(){for(let r=0;r<this.rows;r++)for(let e=0;e<this.columns;e++)yield this.get(r,e)}};T.prototype.klass="Matrix";typeof Symbol<"u"&&(T.prototype[Symbol.for("nodejs.util.inspect.custom")]=Ar);function Dr(s,r){return s-r}function _o(s){return s.every(r=>typeof r=="number")}T.random=T.rand;T.randomInt=T.randInt;T.diagonal=T.diag;T.prototype.diagonal=T.prototype.diag;T.identity=T.eye;T.prototype.negate=T.prototype.neg;T.prototype.tensorProduct=T.prototype.kroneckerProduct;var M=class s extends T{data;#t(r,e){if(this.data=[],Number.isInteger(e)&&e>=0)for(let t=0;t<r;t++)this.data.push(new Float64Array(e));else throw new TypeError("nColumns must be a positive integer");this.rows=r,this.columns=e}constructor(r,e){if(super(),s.isMatrix(r))this.#t(r.rows,r.columns),s.copy(r,this);else if(Number.isInteger(r)&&r>=0)this.#t(r,e);else if(z(r)){let t=r;if(r=t.length,e=r?t[0].length:0,typeof e!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let n=0;n<r;n++){if(t[n].length!==e)throw new RangeError("Inconsistent array dimensions");if(!_o(t[n]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(t[n]))}this.rows=r,this.columns=e}else throw new TypeError("First argument must be a positive number or an array")}set(r,e,t){return this.data[r][e]=t,this}get(r,e){return this.data[r][e]}removeRow(r){return rt(this,r),this.data.splice(r,1),this.rows-=1,this}addRow(r,e){return e===void 0&&(e=r,r=this.rows),rt(this,r,!0),e=Float64Array.from(At(this,e)),this.data.splice(r,0,e),this.rows+=1,this}removeColumn(r){nt(this,r);for(let e=0;e<this.rows;e++){let t=new Float64Array(this.columns-1);for(let n=0;n<r;n++)t[n]=this.data[e][n];for(let n=r+1;n<this.columns;n++)t[n-1]=this.data[e][n];this.data[e]=t}return this.columns-=1,this}addColumn(r,e){typeof e>"u"&&(e=r,r=this.columns),nt(this,r,!0),e=Mt(this,e);for(let t=0;t<this.rows;t++){let n=new Float64Array(this.columns+1),o=0;for(;o<r;o++)n[o]=this.data[t][o];for(n[o++]=e[t];o<this.columns+1;o++)n[o]=this.data[t][o-1];this.data[t]=n}return this.columns+=1,this}};Mr(T,M);var Bt=class extends T{constructor(r){super(),this.data=r,this.rows=r.length,this.columns=r[0].length}set(r,e,t){return this.data[r][e]=t,this}get(r,e){return this.data[r][e]}};function Gr(s){let r=s.data,e=s.rows;for(let t=0;t<e;t++){let n=r[t];for(let o=t+1;o<e;o++){let i=n[o];n[o]=r[o][t],r[o][t]=i}}return s}function Ee(s,r){let e=0;return Math.abs(s)>Math.abs(r)?(e=r/s,Math.abs(s)*Math.sqrt(1+e*e)):r!==0?(e=s/r,Math.abs(r)*Math.sqrt(1+e*e)):0}var bt=class{constructor(r,e={}){let{assumeSymmetric:t=!1}=e;if(r=Bt.checkMatrix(r),!r.isSquare())throw new Error("Matrix is not a square matrix");if(r.isEmpty())throw new Error("Matrix must be non-empty");let n=r.columns,o=new M(n,n),i=new Float64Array(n),a=new Float64Array(n),u=r,l,c,f=!1;if(t?f=!0:f=r.isSymmetric(),f){for(l=0;l<n;l++)for(c=0;c<n;c++)o.set(c,l,u.get(l,c));zo(n,a,i,o),Co(n,a,i,o),Gr(o)}else{let h=new M(n,n),g=new Float64Array(n);for(c=0;c<n;c++)for(l=0;l<n;l++)h.set(l,c,u.get(l,c));Wo(n,h,g,o),Do(n,a,i,o,h)}this.n=n,this.e=a,this.d=i,this.V=o}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let r=this.n,e=this.e,t=this.d,n=new M(r,r),o,i;for(o=0;o<r;o++){for(i=0;i<r;i++)n.set(o,i,0);n.set(o,o,t[o]),e[o]>0?n.set(o,o+1,e[o]):e[o]<0&&n.set(o,o-1,e[o])}return n}};function zo(s,r,e,t){let n,o,i,a,u,l,c,f;for(u=0;u<s;u++)e[u]=t.get(u,s-1);for(a=s-1;a>0;a--){for(f=0,i=0,l=0;l<a;l++)f=f+Math.abs(e[l]);if(f===0)for(r[a]=e[a-1],u=0;u<a;u++)e[u]=t.get(u,a-1),t.set(u,a,0),t.set(a,u,0);else{for(l=0;l<a;l++)e[l]/=f,i+=e[l]*e[l];for(n=e[a-1],o=Math.sqrt(i),n>0&&(o=-o),r[a]=f*o,i=i-n*o,e[a-1]=n-o,u=0;u<a;u++)r[u]=0;for(u=0;u<a;u++){for(n=e[u],t.set(a,u,n),o=r[u]+t.get(u,u)*n,l=u+1;l<=a-1;l++)o+=t.get(u,l)*e[l],r[l]+=t.get(u,l)*n;r[u]=o}for(n=0,u=0;u<a;u++)r[u]/=i,n+=r[u]*e[u];for(c=n/(i+i),u=0;u<a;u++)r[u]-=c*e[u];for(u=0;u<a;u++){for(n=e[u],o=r[u],l=u;l<=a-1;l++)t.set(u,l,t.get(u,l)-(n*r[l]+o*e[l]));e[u]=t.get(u,a-1),t.set(u,a,0)}}e[a]=i}for(a=0;a<s-1;a++){if(t.set(a,s-1,t.get(a,a)),t.set(a,a,1),i=e[a+1],i!==0){for(l=0;l<=a;l++)e[l]=t.get(a+1,l)/i;for(u=0;u<=a;u++){for(o=0,l=0;l<=a;l++)o+=t.get(a+1,l)*t.get(u,l);for(l=0;l<=a;l++)t.set(u,l,t.get(u,l)-o*e[l])}}for(l=0;l<=a;l++)t.set(a+1,l,0)}for(u=0;u<s;u++)e[u]=t.get(u,s-1),t.set(u,s-1,0);t.set(s-1,s-1,1),r[0]=0}function Co(s,r,e,t){let n,o,i,a,u,l,c,f,h,g,m,d,y,p,w,b,F;for(i=1;i<s;i++)r[i-1]=r[i];r[s-1]=0;let A=0,R=0,E=Number.EPSILON;for(l=0;l<s;l++){for(R=Math.max(R,Math.abs(e[l])+Math.abs(r[l])),c=l;c<s&&!(Math.abs(r[c])<=E*R);)c++;if(c>l){F=0;do{for(F=F+1,n=e[l],f=(e[l+1]-n)/(2*r[l]),h=Ee(f,1),f<0&&(h=-h),e[l]=r[l]/(f+h),e[l+1]=r[l]*(f+h),g=e[l+1],o=n-e[l],i=l+2;i<s;i++)e[i]-=o;for(A=A+o,f=e[c],m=1,d=m,y=m,p=r[l+1],w=0,b=0,i=c-1;i>=l;i--)for(y=d,d=m,b=w,n=m*r[i],o=m*f,h=Ee(f,r[i]),r[i+1]=w*h,w=r[i]/h,m=f/h,f=m*e[i]-w*n,e[i+1]=o+w*(m*n+w*e[i]),u=0;u<s;u++)o=t.get(i+1,u),t.set(i+1,u,w*t.get(i,u)+m*o),t.set(i,u,m*t.get(i,u)-w*o);f=-w*b*y*p*r[l]/g,r[l]=w*f,e[l]=m*f}while(Math.abs(r[l])>E*R)}e[l]=e[l]+A,r[l]=0}for(i=0;i<s-1;i++){for(u=i,f=e[i],a=i+1;a<s;a++)e[a]<f&&(u=a,f=e[a]);if(u!==i)for(e[u]=e[i],e[i]=f,a=0;a<s;a++)f=t.get(i,a),t.set(i,a,t.get(u,a)),t.set(u,a,f)}}function Wo(s,r,e,t){let n=0,o=s-1,i,a,u,l,c,f,h;for(f=n+1;f<=o-1;f++){for(h=0,l=f;l<=o;l++)h=h+Math.abs(r.get(l,f-1));if(h!==0){for(u=0,l=o;l>=f;l--)e[l]=r.get(l,f-1)/h,u+=e[l]*e[l];for(a=Math.sqrt(u),e[f]>0&&(a=-a),u=u-e[f]*a,e[f]=e[f]-a,c=f;c<s;c++){for(i=0,l=o;l>=f;l--)i+=e[l]*r.get(l,c);for(i=i/u,l=f;l<=o;l++)r.set(l,c,r.get(l,c)-i*e[l])}for(l=0;l<=o;l++){for(i=0,c=o;c>=f;c--)i+=e[c]*r.get(l,c);for(i=i/u,c=f;c<=o;c++)r.set(l,c,r.get(l,c)-i*e[c])}e[f]=h*e[f],r.set(f,f-1,h*a)}}for(l=0;l<s;l++)for(c=0;c<s;c++)t.set(l,c,l===c?1:0);for(f=o-1;f>=n+1;f--)if(r.get(f,f-1)!==0){for(l=f+1;l<=o;l++)e[l]=r.get(l,f-1);for(c=f;c<=o;c++){for(a=0,l=f;l<=o;l++)a+=e[l]*t.get(l,c);for(a=a/e[f]/r.get(f,f-1),l=f;l<=o;l++)t.set(l,c,t.get(l,c)+a*e[l])}}}function Do(s,r,e,t,n){let o=s-1,i=0,a=s-1,u=Number.EPSILON,l=0,c=0,f=0,h=0,g=0,m=0,d=0,y=0,p,w,b,F,A,R,E,v,k,N,q,P,_,ct,W;for(p=0;p<s;p++)for((p<i||p>a)&&(e[p]=n.get(p,p),r[p]=0),w=Math.max(p-1,0);w<s;w++)c=c+Math.abs(n.get(p,w));for(;o>=i;){for(F=o;F>i&&(m=Math.abs(n.get(F-1,F-1))+Math.abs(n.get(F,F)),m===0&&(m=c),!(Math.abs(n.get(F,F-1))<u*m));)F--;if(F===o)n.set(o,o,n.get(o,o)+l),e[o]=n.get(o,o),r[o]=0,o--,y=0;else if(F===o-1){if(E=n.get(o,o-1)*n.get(o-1,o),f=(n.get(o-1,o-1)-n.get(o,o))/2,h=f*f+E,d=Math.sqrt(Math.abs(h)),n.set(o,o,n.get(o,o)+l),n.set(o-1,o-1,n.get(o-1,o-1)+l),v=n.get(o,o),h>=0){for(d=f>=0?f+d:f-d,e[o-1]=v+d,e[o]=e[o-1],d!==0&&(e[o]=v-E/d),r[o-1]=0,r[o]=0,v=n.get(o,o-1),m=Math.abs(v)+Math.abs(d),f=v/m,h=d/m,g=Math.sqrt(f*f+h*h),f=f/g,h=h/g,w=o-1;w<s;w++)d=n.get(o-1,w),n.set(o-1,w,h*d+f*n.get(o,w)),n.set(o,w,h*n.get(o,w)-f*d);for(p=0;p<=o;p++)d=n.get(p,o-1),n.set(p,o-1,h*d+f*n.get(p,o)),n.set(p,o,h*n.get(p,o)-f*d);for(p=i;p<=a;p++)d=t.get(p,o-1),t.set(p,o-1,h*d+f*t.get(p,o)),t.set(p,o,h*t.get(p,o)-f*d)}else e[o-1]=v+f,e[o]=v+f,r[o-1]=d,r[o]=-d;o=o-2,y=0}else{if(v=n.get(o,o),k=0,E=0,F<o&&(k=n.get(o-1,o-1),E=n.get(o,o-1)*n.get(o-1,o)),y===10){for(l+=v,p=i;p<=o;p++)n.set(p,p,n.get(p,p)-v);m=Math.abs(n.get(o,o-1))+Math.abs(n.get(o-1,o-2)),v=k=.75*m,E=-.4375*m*m}if(y===30&&(m=(k-v)/2,m=m*m+E,m>0)){for(m=Math.sqrt(m),k<v&&(m=-m),m=v-E/((k-v)/2+m),p=i;p<=o;p++)n.set(p,p,n.get(p,p)-m);l+=m,v=k=E=.964}for(y=y+1,A=o-2;A>=F&&(d=n.get(A,A),g=v-d,m=k-d,f=(g*m-E)/n.get(A+1,A)+n.get(A,A+1),h=n.get(A+1,A+1)-d-g-m,g=n.get(A+2,A+1),m=Math.abs(f)+Math.abs(h)+Math.abs(g),f=f/m,h=h/m,g=g/m,!(A===F||Math.abs(n.get(A,A-1))*(Math.abs(h)+Math.abs(g))<u*(Math.abs(f)*(Math.abs(n.get(A-1,A-1))+Math.abs(d)+Math.abs(n.get(A+1,A+1))))));)A--;for(p=A+2;p<=o;p++)n.set(p,p-2,0),p>A+2&&n.set(p,p-3,0);for(b=A;b<=o-1&&(ct=b!==o-1,b!==A&&(f=n.get(b,b-1),h=n.get(b+1,b-1),g=ct?n.get(b+2,b-1):0,v=Math.abs(f)+Math.abs(h)+Math.abs(g),v!==0&&(f=f/v,h=h/v,g=g/v)),v!==0);b++)if(m=Math.sqrt(f*f+h*h+g*g),f<0&&(m=-m),m!==0){for(b!==A?n.set(b,b-1,-m*v):F!==A&&n.set(b,b-1,-n.get(b,b-1)),f=f+m,v=f/m,k=h/m,d=g/m,h=h/f,g=g/f,w=b;w<s;w++)f=n.get(b,w)+h*n.get(b+1,w),ct&&(f=f+g*n.get(b+2,w),n.set(b+2,w,n.get(b+2,w)-f*d)),n.set(b,w,n.get(b,w)-f*v),n.set(b+1,w,n.get(b+1,w)-f*k);for(p=0;p<=Math.min(o,b+3);p++)f=v*n.get(p,b)+k*n.get(p,b+1),ct&&(f=f+d*n.get(p,b+2),n.set(p,b+2,n.get(p,b+2)-f*g)),n.set(p,b,n.get(p,b)-f),n.set(p,b+1,n.get(p,b+1)-f*h);for(p=i;p<=a;p++)f=v*t.get(p,b)+k*t.get(p,b+1),ct&&(f=f+d*t.get(p,b+2),t.set(p,b+2,t.get(p,b+2)-f*g)),t.set(p,b,t.get(p,b)-f),t.set(p,b+1,t.get(p,b+1)-f*h)}}}if(c!==0){for(o=s-1;o>=0;o--)if(f=e[o],h=r[o],h===0)for(F=o,n.set(o,o,1),p=o-1;p>=0;p--){for(E=n.get(p,p)-f,g=0,w=F;w<=o;w++)g=g+n.get(p,w)*n.get(w,o);if(r[p]<0)d=E,m=g;else if(F=p,r[p]===0?n.set(p,o,E!==0?-g/E:-g/(u*c)):(v=n.get(p,p+1),k=n.get(p+1,p),h=(e[p]-f)*(e[p]-f)+r[p]*r[p],R=(v*m-d*g)/h,n.set(p,o,R),n.set(p+1,o,Math.abs(v)>Math.abs(d)?(-g-E*R)/v:(-m-k*R)/d)),R=Math.abs(n.get(p,o)),u*R*R>1)for(w=p;w<=o;w++)n.set(w,o,n.get(w,o)/R)}else if(h<0)for(F=o-1,Math.abs(n.get(o,o-1))>Math.abs(n.get(o-1,o))?(n.set(o-1,o-1,h/n.get(o,o-1)),n.set(o-1,o,-(n.get(o,o)-f)/n.get(o,o-1))):(W=ee(0,-n.get(o-1,o),n.get(o-1,o-1)-f,h),n.set(o-1,o-1,W[0]),n.set(o-1,o,W[1])),n.set(o,o-1,0),n.set(o,o,1),p=o-2;p>=0;p--){for(N=0,q=0,w=F;w<=o;w++)N=N+n.get(p,w)*n.get(w,o-1),q=q+n.get(p,w)*n.get(w,o);if(E=n.get(p,p)-f,r[p]<0)d=E,g=N,m=q;else if(F=p,r[p]===0?(W=ee(-N,-q,E,h),n.set(p,o-1,W[0]),n.set(p,o,W[1])):(v=n.get(p,p+1),k=n.get(p+1,p),P=(e[p]-f)*(e[p]-f)+r[p]*r[p]-h*h,_=(e[p]-f)*2*h,P===0&&_===0&&(P=u*c*(Math.abs(E)+Math.abs(h)+Math.abs(v)+Math.abs(k)+Math.abs(d))),W=ee(v*g-d*N+h*q,v*m-d*q-h*N,P,_),n.set(p,o-1,W[0]),n.set(p,o,W[1]),Math.abs(v)>Math.abs(d)+Math.abs(h)?(n.set(p+1,o-1,(-N-E*n.get(p,o-1)+h*n.get(p,o))/v),n.set(p+1,o,(-q-E*n.get(p,o)-h*n.get(p,o-1))/v)):(W=ee(-g-k*n.get(p,o-1),-m-k*n.get(p,o),d,h),n.set(p+1,o-1,W[0]),n.set(p+1,o,W[1]))),R=Math.max(Math.abs(n.get(p,o-1)),Math.abs(n.get(p,o))),u*R*R>1)for(w=p;w<=o;w++)n.set(w,o-1,n.get(w,o-1)/R),n.set(w,o,n.get(w,o)/R)}for(p=0;p<s;p++)if(p<i||p>a)for(w=p;w<s;w++)t.set(p,w,n.get(p,w));for(w=s-1;w>=i;w--)for(p=i;p<=a;p++){for(d=0,b=i;b<=Math.min(w,a);b++)d=d+t.get(p,b)*n.get(b,w);t.set(p,w,d)}}}function ee(s,r,e,t){let n,o;return Math.abs(e)>Math.abs(t)?(n=t/e,o=e+n*t,[(s+n*r)/o,(r-n*s)/o]):(n=e/t,o=t+n*e,[(n*s+r)/o,(n*r-s)/o])}var Go=1e-9,Uo=1e-13,Yo=1e-6;function Ur(s,r,e){let t=Ut(s,e);if(!t)throw new Error("mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate");let[n,o]=[0,0];for(let f=0;f<e;f+=1)for(let h=0;h<e;h+=1)n=Math.max(n,Math.abs(r[f*e+h]-r[h*e+f])),o=Math.max(o,Math.abs(r[f*e+h]));if(n>Go*o)return{...xe(t,ke(Yt(t,r,e),e,!1),e),symmetric:!1};let i=r.map((f,h)=>(f+r[h%e*e+Math.floor(h/e)])/2),a=Ut(i,e),u=a&&ke(Yt(a,s,e),e,!0),l=u?Math.max(...u.re):0;if(!a||!u||Math.min(...u.re)<=0||1/l<=Uo*e/Math.min(...u.re))return{...xe(t,ke(Yt(t,i,e),e,!0),e),symmetric:!0};let c=xe(a,{re:u.re.map(f=>1/f),vectors:u.vectors},e);return{squares:c.squares,shapes:c.shapes.map((f,h)=>f*Math.sqrt(c.squares[h%e])),symmetric:!0}}function ke(s,r,e){let t=e?s.map((l,c)=>(l+s[c%r*r+Math.floor(c/r)])/2):s,n=new bt(M.from1DArray(r,r,t),{assumeSymmetric:e}),{realEigenvalues:o,imaginaryEigenvalues:i,eigenvectorMatrix:a}=n,u=Float64Array.from(a.to1DArray());if(!e){for(let l=1;l<r;l+=1)if(i[l]<0)for(let c=0;c<r;c+=1)u[c*r+l]=u[c*r+l-1]}for(let l=0;l<r;l+=1){let c=Math.hypot(...Array.from({length:r},(f,h)=>u[h*r+l]));for(let f=0;f<r;f+=1)u[f*r+l]/=c}return{re:Float64Array.from(o),vectors:u}}function xe(s,{re:r,vectors:e},t){let n=Array.from(r.keys()).sort((i,a)=>r[i]-r[a]),o=new Float64Array(t*t);return n.forEach((i,a)=>{for(let u=0;u<t;u+=1)o[u*t+a]=e[u*t+i]}),we(s,o,t,t),{squares:Float64Array.from(n,i=>r[i]),shapes:o}}function Yr(s,r,e,t,n){let o=n.symmetric?n.shapes:Qo(s,t),i=d=>U(o,U(d,o,t,t,t),t,t,t,!0),[a,u]=[i(e),i(r)];if(n.symmetric)for(let d=0;d<t*t;d+=1)a[d]=d%(t+1)?0:n.squares[d/(t+1)];let l=Array.from({length:t},(d,y)=>Math.sqrt(Math.abs(a[y*(t+1)]))),c=Yo*Math.max(...l)||1,f=l.map(d=>Math.max(d,c)),h=M.zeros(2*t,2*t);for(let d=0;d<t;d+=1){h.set(d,t+d,f[d]);for(let y=0;y<t;y+=1)h.set(t+d,y,-a[d*t+y]/f[y]),h.set(t+d,t+y,-u[d*t+y])}let g=new bt(h,{assumeSymmetric:!1}),m={re:Float64Array.from(g.realEigenvalues),im:Float64Array.from(g.imaginaryEigenvalues)};return{count:2*t,values:m,shapes:Ko(g.eigenvectorMatrix,m.im,o,f,t)}}function Ko(s,r,e,t,n){let o={re:new Float64Array(2*n*n),im:new Float64Array(2*n*n)};for(let i=0;i<2*n;i+=1)for(let a=0;a<n;a+=1)o.re[2*n*a+i]=s.get(a,r[i]<0?i-1:i)/t[a],o.im[2*n*a+i]=(r[i]>0?s.get(a,i+1):r[i]<0?-s.get(a,i):0)/t[a];return{re:U(e,o.re,n,n,2*n),im:U(e,o.im,n,n,2*n)}}function Qo(s,r){let e=Float64Array.from({length:r*r},(t,n)=>n%(r+1)?0:1);return we(Ut(s,r),e,r,r),e}var Kr=.05,Jo=8,Xo=["settling","vibration.residual"];function D(s,r=3){return it(s,r)}function je(s,r){if(s.length<2)return r[0];let e=0;for(let t=1;t<s.length;t+=1)e+=(r[t]+r[t-1])/2*(s[t]-s[t-1]);return e/(s[s.length-1]-s[0])}function Qr(s,r,e){let t={},n=r.deviation?.data;if(n){let o=Ft(n),i=n[n.length-1];t["deviation.max"]={value:n[o],note:`at ${D(s[o])} s; ${ht(i,"m")} at the end of the run`},t["deviation.rms"]={value:Math.sqrt(je(s,n.map(a=>a*a))),note:"over the run"},t.settling=Zo(s,n,e)}return t["vibration.residual"]=Ho(s,r,e),t}function Zo(s,r,e){let t=l=>({value:null,note:`not seen: ${l}`});if(e===null)return t("what moves the robot changes up to the end of the run");let n=s[s.length-1];if(n<=e*(1+1e-9)){let l=`the run ends at ${D(n,6)} s, the move at ${D(e,6)} s`;return t(`${l}: simulate longer to see it settle`)}let{value:o,limit:i,strayed:a}=Vo(s,r,e);if(a!==n)return{value:o,note:i};let u=`${D(r[r.length-1])} m`;return t(`the deviation is still ${u} when the run ends at ${D(n,6)} s`)}function Vo(s,r,e){let t=Kr*r[Ft(r)],n=e;for(let o=0;o<s.length;o+=1)s[o]>e&&r[o]>t&&(n=s[o]);return{value:n-e,limit:`until the tip stays within ${ht(t,"m")}, ${100*Kr} % of its largest deviation`,strayed:n}}function Jr(s){let r={};for(let[e,{value:t,note:n}]of Object.entries(s))Xo.includes(e)?r[e]={value:null,note:"the run broke off"}:r[e]={value:t,note:`until it broke off: ${n}`};return r}function Ho(s,r,e){if(e===null)return{value:null,note:"what moves the robot changes up to the end of the run"};let t=s.findIndex(u=>u>e*(1+1e-9));if(t<0||s.length-t<Jo)return{value:null,note:"the run ends with the move"};let n=r.tip_reference?.data,o=r.tip.data.map((u,l)=>u-(n?n[l]:0)).subarray(3*t),i=[0,1,2].map(u=>o.reduce((l,c,f)=>f%3===u?l+c:l,0)/(o.length/3)),a=yt(o.map((u,l)=>u-i[l%3]),3);return{value:a[Ft(a)],note:`about its mean place, from ${D(s[t])} s on`}}function Xr(s,r){if(!s.energy||!s.energy_balance)return{};let{energy:e,work:t}=s,n=e.shape[1],o=Math.max(e.data.reduce((u,l,c)=>Math.max(u,Math.abs(l-e.data[c%n])),0),t.data.reduce((u,l)=>Math.max(u,Math.abs(l)),0)),i=Math.abs(s.energy_balance.data[Ft(s.energy_balance.data.subarray(0,r))]),a=o?`worst residual, ${ht(i,"J")}, over ${ht(o,"J")} moved`:"nothing moved";return{"energy.residual":{value:o?i/o:null,note:a}}}var ts=8,Ie=1e-5,es=Math.SQRT1_2,rs=1e-9;function Zr(s,r,e){let t=Object.entries(s).flatMap(([a,u])=>u.filter(l=>l.frequency>0).slice(0,ts).map(l=>[a,l])),n=os(t,r,e),i=(s.controlled?.length?s.controlled:s.locked??[]).flatMap(a=>a.rings&&a.damping<es?[{at:a.rings,label:a.element}]:[]);return{vibration:{modes:n,marks:i.sort((a,u)=>a.at-u.at)},facts:ns(s)}}function ns({controlled:s,locked:r}){if(!s)return{};let e=i=>i.reduce((a,u)=>u&&(a===null||u<a)?u:a,null),t=e(s.map(i=>i.rings)),n=e((r??[]).map(i=>i.frequency)),o=t===null?"no vibration under control":n===null?"":`${D(n,4)} Hz with the motors locked`;return{"frequency.first":{value:t,note:o}}}function os(s,r,e){let t=r.length,n=new Float64Array((1+4*s.length)*t);n.set(r),s.forEach(([,{re:c,im:f}],h)=>{let g=c.reduce((m,d,y)=>Math.max(m,Math.hypot(d,f[y])),0);for(let m=0;m<t;m+=1){let[d,y]=[Ie*c[m]/g,Ie*f[m]/g];[d,y,-d,-y].forEach((p,w)=>{n[(1+4*h+w)*t+m]=r[m]+p})}});let{data:o,shape:i}=e(n,1+4*s.length),a=o.length/(1+4*s.length),u=c=>Float64Array.from({length:a},(f,h)=>(o[c*a+h]-o[(c+2)*a+h])/(2*Ie)),l=c=>({data:Float32Array.from(c),shape:i.slice(1)});return s.map(([c,f],h)=>{let[g,m]=ss(u(1+4*h),u(2+4*h));return{case:c,frequency:f.frequency,damping:f.damping,livesIn:f.element,rest:l(o.subarray(0,a)),real:l(g),imaginary:l(m)}})}function ss(s,r){let[e,t]=[0,0];for(let l=0;l<s.length;l+=3){let c=Math.hypot(...s.subarray(l,l+3),...r.subarray(l,l+3));c>t&&([e,t]=[l,c])}if(!t)return[s,r];let n=[0,1,2].map(l=>Math.hypot(s[e+l],r[e+l])),o=e+n.indexOf(Math.max(...n)),i=Math.hypot(s[o],r[o])*t,[a,u]=[s[o]/i,-r[o]/i];return[s.map((l,c)=>a*l-u*r[c]),s.map((l,c)=>u*l+a*r[c])]}function Vr(s,r){let[e,t]=[s.values.re[r],s.values.im[r]],n=Math.hypot(e,t);return{size:n,rings:t>rs*n?t/(2*Math.PI):null,damping:n?-e/n:0}}function Hr(s,r,e,t,n){let o=i=>Float64Array.from({length:e},(a,u)=>{let l=0;for(let c=0;c<t;c+=1)l+=n(u,c)*i[c*s.count+r];return l});return{re:o(s.shapes.re),im:o(s.shapes.im)}}function tn(s,r,e,t){let{count:n,shapes:o}=r,i=y=>p=>{if(!t)return y(p);let w=0;for(let b=0;b<e;b+=1)w+=t[p*e+b]*y(b);return w},a=(y,p)=>{let w=0;for(let b=0;b<e;b+=1)w+=y(b)*p(b);return w},u=Ne(s.shapes,e,e),[l,c]=[Ne(o.re,e,n),Ne(o.im,e,n)],f=u.map(y=>Float64Array.from({length:e},(p,w)=>i(b=>y[b])(w))),h=y=>a(p=>y[p],i(p=>y[p])),[g,m]=[u.map(y=>Math.sqrt(h(y))),l.map((y,p)=>Math.sqrt(h(y)+h(c[p])))],d=new Float64Array(e*n);for(let y=0;y<e;y+=1)for(let p=0;p<n;p+=1){let[w,b]=[l,c].map(F=>a(A=>f[y][A],A=>F[p][A]));d[y*n+p]=Math.hypot(w,b)/(g[y]*m[p])}return d}function Ne(s,r,e){return Array.from({length:e},(t,n)=>Float64Array.from({length:r},(o,i)=>s[i*e+n]))}function is({values:s,count:r}){let e=Array.from({length:r},(t,n)=>Math.hypot(s.re[n],s.im[n]));return{rings:e.map((t,n)=>s.im[n]>1e-9*t),stands:e.map((t,n)=>Math.abs(s.im[n])<=1e-9*t)}}function en(s,r,e){let{count:t,values:n}=r,{rings:o,stands:i}=is(r),a=new Float64Array(t);Array.from({length:t},(l,c)=>c).sort((l,c)=>n.re[c]-n.re[l]).forEach((l,c)=>{a[l]=c});let u=Float64Array.from(s,(l,c)=>{let f=c%t;return!o[f]&&!i[f]?100:a[f]/(10*t)-l*l-(o[f]?10:0)});return as(u,e,t)}function as(s,r,e){let[t,n]=[new Float64Array(r+1),new Float64Array(e+1)],o=new Int32Array(e+1);for(let a=1;a<=r;a+=1){let u=new Float64Array(e+1).fill(1/0),l=new Int32Array(e+1),c=new Uint8Array(e+1);o[0]=a;let f=0;for(;o[f];){c[f]=1;let[h,g]=[1/0,0];for(let m=1;m<=e;m+=1){if(c[m])continue;let d=s[(o[f]-1)*e+m-1]-t[o[f]]-n[m];d<u[m]&&(u[m]=d,l[m]=f),u[m]<h&&(h=u[m],g=m)}for(let m=0;m<=e;m+=1)c[m]?(t[o[m]]+=h,n[m]-=h):u[m]-=h;f=g}for(;f;f=l[f])o[f]=o[l[f]]}let i=new Array(r).fill(-1);for(let a=1;a<=e;a+=1)o[a]&&(i[o[a]-1]=a-1);return i}var ls=1e-13,us=1e-13,cs="whole arm, free",fs="whole arm, in its weight and loads";function rn(s,r,e,t,n){if(!r.modes)return{vibration:r.noModes,facts:{}};try{let{rest:o,linear:i}=hs(s,r,e,n),a=Object.fromEntries(r.modes.cases.map(({name:u,moving:l})=>[u,ms(r,t,i,u,l)]));return Zr(a,o,(u,l)=>Zt(s,r,t.pose,u,l).line)}catch(o){return{vibration:o instanceof Error?o.message:String(o),facts:{}}}}function hs(s,r,e,t){let n=null;return Ae(r,e,"real",B(r.modes.rest),(o,i)=>(n=dr(s,r,jt(r.map,o,"real"),t,i),n&&n.rest)),n}function ms(s,r,e,t,n){let o=Math.sqrt(e.mass.length),i=n.length;if(!i)return[];let a=y=>Float64Array.from({length:i*i},(p,w)=>y[n[Math.floor(w/i)]*o+n[w%i]]),[u,l,c]=[a(e.mass),a(e.damping),a(e.stiffness)],f=t==="controlled";f&&s.modes.servos.forEach(({coordinate:y},p)=>{let w=n.indexOf(y)*(i+1);c[w]+=r.servos[2*p],l[w]+=r.servos[2*p+1]});let h=Ur(u,c,i),g=Yr(u,l,c,i,h),m=en(tn(h,g,i,u),g,i),d=us*i*h.squares.reduce((y,p)=>Math.max(y,Math.abs(p)),0);return Array.from({length:i},(y,p)=>{let w=new Float64Array(o);n.forEach((P,_)=>{w[P]=h.shapes[_*i+p]});let b=ps(s,r,e.elastic,w,f),F=Hr(g,m[p],o,i,(P,_)=>n[_]===P?1:0),A=h.squares[p],R=b.reduce((P,{energy:_})=>P+_,0);if(Math.abs(A)<=d&&R<=d)return{frequency:0,rings:null,damping:0,element:cs,...F};let{size:E,rings:v,damping:k}=Vr(g,m[p]),N=(f&&v?E:Math.sqrt(Math.max(A,0)))/(2*Math.PI),q=b.reduce((P,_)=>_.energy>P.energy?_:P,b[0]);return{frequency:N,rings:v,damping:Math.abs(k)>ls?k:0,element:R>d&&q?q.element:fs,...F}})}function ps(s,r,e,t,n){let o=t.length,i=c=>{let f=0;for(let h=0;h<o;h+=1)f+=e[c*o+h]*t[h];return f},{springs:a,servos:u}=s.modes,l=a.map(({element:c,rows:f,gear:h})=>{if(!h)return{element:c,energy:f.reduce((m,d)=>m+t[d]*i(d),0)};let g=e[f[0]*(o+1)];return{element:c,energy:g?i(f[0])**2/g:0}});return n?[...l,...u.map(({coordinate:c,element:f},h)=>({element:f,energy:r.servos[2*h]*t[c]**2}))]:l}var nn=1e-6,gs=1e-11,on=.5,Le=40,ds=.1,sn=24;async function an(s,r,e,t,n,o,i){let{free:a,gross:u}=r.split;if(!a.length)return{};let l=n.length,c=o.q.shape[1],f=p=>wt({matrix:u,constant:{data:new Float64Array(c),shape:[c]}},o[p].data,l),h=ys(r,e,t,n,o),g={engine:s,blocks:e,free:a,size:c,places:h.length/l,weight:B(r.split.weight),q:o.q.data.slice(),rates:f("v"),gains:f("a"),wrenches:h},m=o.deformation.data,d=null;for(let p=0;p<l;p+=sn){let w=Array.from({length:Math.min(sn,l-p)},(b,F)=>p+F);if(p&&ws(g,m,wt(r.deflections,g.q.subarray((p-1)*c,p*c),1),w),d=bs(g,o.q.data,w,d),!d)return{};await i()}let y=wt(r.deflections,g.q,l);return{deformation_stationary:j(y,l,a.length),deformation_oscillatory:j(Jt(m,y),l,a.length)}}function ys(s,r,e,t,n){let o=n.position.shape[1],i=new Float64Array(t.length*o*$);return t.forEach((a,u)=>{if(s.loads.forEach((l,c)=>{let f=u*o+l.point,h=r.loads.subarray($*c,$*(c+1)),g=kt(l,h,e,a,n.rotation.data,9*f);for(let m=0;m<$;m+=1)i[$*f+m]+=g[m]}),!(s.contactPoint<0))for(let l=0;l<3;l+=1)i[$*(u*o+s.contactPoint)+l]-=n.contact_force.data[3*u+l]}),i}function ws(s,r,e,t){let n=s.free.length;for(let o of t)s.free.forEach((i,a)=>{s.q[o*s.size+i]+=e[a]-r[o*n+a]})}function Be(s,r,e){let{engine:t,blocks:n,free:o,size:i}=s,a={q:r,v:mt(s.rates,i,e),a:mt(s.gains,i,e),base:s.weight,wrenches:mt(s.wrenches,s.places,e)},u=Qt(t,n,a,e.length),l=t.sample("elastic",n.chain,a,e.length).forces;return Float64Array.from({length:e.length*o.length},(c,f)=>{let h=Math.floor(f/o.length)*i+o[f%o.length];return u[h]+l[h]})}function Oe(s,r,e){let{free:t,size:n}=s,o=t.length,i=new Float64Array((o+1)*n);for(let u=0;u<=o;u+=1)i.set(r,u*n);t.forEach((u,l)=>{i[l*n+u]+=nn});let a=Be(s,i,new Array(o+1).fill(e));return cr(Float64Array.from({length:o*o},(u,l)=>(a[l%o*o+Math.floor(l/o)]-a[o*o+Math.floor(l/o)])/nn),o)}function bs(s,r,e,t){let n=u=>s.q.subarray(u*s.size,(u+1)*s.size),o=u=>Oe(s,n(u[u.length>>1]),u[u.length>>1]),i=t??o(e);if(!i)return null;let a=Te(s,e,i,Le);a.length&&(i=o(a)??i),a=Te(s,a,i,Le);for(let u of a){let[l,c]=[Le,[u]];for(;c.length&&l;l-=1){let f=Oe(s,n(u),u);c=f?Te(s,c,f,3):c}c.length&&Fs(s,r,u)}return i}function Te(s,r,e,t){let{free:n,size:o,q:i}=s,a=n.length,u=[],l=new Map,c=r;for(let f=0;f<t&&c.length;f+=1){let h=Be(s,mt(i,o,c),c);c=c.filter((g,m)=>{let d=U(e,h.subarray(m*a,(m+1)*a),a,a,1),y=d.reduce((b,F)=>Math.max(b,Math.abs(F)),0),p=y>on?on/y:1;if(!Number.isFinite(y))return u.push(g)&&!1;if(n.forEach((b,F)=>{i[g*o+b]-=p*d[F]}),y<gs)return!1;let w=y>ds*(l.get(g)??1/0);return l.set(g,y),w?u.push(g)&&!1:!0})}return[...u,...c]}function Fs(s,r,e){let t=r.slice(e*s.size,(e+1)*s.size),n=Oe(s,t,e);if(s.q.set(t,e*s.size),!n)return;let o=s.free.length,i=U(n,Be(s,t,[e]),o,o,1);s.free.forEach((a,u)=>{s.q[e*s.size+a]-=i[u]})}var As=50;async function ln(s,r,e,t,n,o){let i=performance.now(),a=async(f=!1)=>{if(!(!f&&performance.now()-i<As)){if(await new Promise(h=>setTimeout(h,0)),o.cancelled?.())throw new dt("a newer run began");i=performance.now()}};await a(!0);let{vibration:u,facts:l}=rn(s,r,e,n.blocks,n.schedule);await a(!0);let c=await an(s,r,n.blocks,n.schedule,t.times,t.series,a);return{...t,vibration:u,facts:{...t.facts,...l},series:{...t.series,...c}}}function un(s,r,e,t){let n={...Qr(r,e,t),...Xr(e,r.length)},o=s.deformations.flatMap((l,c)=>l.endsWith(".gear")?[c]:[]),i=o.filter(l=>s.turning.includes(s.deformations[l].replace(/\\.gear$/,""))),a=i.length?i:o;if(a.length){let l=Y(e.deformation.data,s.deformations.length,a),c=Ft(l),f=s.deformations[a[c%a.length]].replace(/\\.gear$/,""),h=a.length<o.length?" (of the gears that turn)":"";n["gear.max"]={value:Math.abs(l[c]),note:`${f}, at ${D(r[Math.floor(c/a.length)])} s${h}`}}let u=e.contact_force_normal?.data;if(u){let[l,c]=[u.reduce((f,h)=>Math.min(f,h)),u.reduce((f,h)=>Math.max(f,h))];n["contact.mean"]={value:je(r,u),note:`from ${D(l,4)} to ${D(c,4)} N`}}return n}function cn(s,{strengths:r,places:e,kept:t},n){let o=[s.every>1?`one sample in ${s.every}`:"",t>e.data.length?`${e.data.length} places along each link`:""],i=o.some(Boolean)?` (looked at: ${o.filter(Boolean).join(", ")})`:"",a=h=>s.links.flatMap(({largest:g})=>g[h]??[]),u=(h,g)=>{let m=qe(g,({value:y})=>y),d=m&&h!=="deflection.max"?` at s = ${D(m.s,2)}`:"";return m?{[h]:{value:m.value,note:`${m.link}${d}, at ${D(n[m.sample])} s${i}`}}:{}},l=qe(a("stress").filter(({link:h})=>h in r),({link:h,value:g})=>g/r[h]),c=l?r[l.link]:1,f=l&&`of ${ht(c,"Pa")}, ${l.link}; margin ${D(100*(1-l.value/c))} %${i}`;return{...u("deflection.max",a("deflection")),...u("moment.max",a("moment")),...u("stress.max",a("stress")),...l&&f?{"stress.share":{value:100*l.value/c,note:f}}:{}}}function fn(s,r){let e=qe(s.flatMap(t=>Ms(t,r)),({share:t})=>t);return e?{"limits.share":{value:100*e.share,note:e.note}}:{}}function Ms({joint:s,coordinate:r,drive:e,unit:t,effortUnit:n,speed:o,effort:i,range:a},u){let l=(f,h,g=0)=>Y(u[f].data,u[f].shape[1],[h]).reduce((m,d)=>Math.max(m,Math.abs(d-g)),0),c=(f,h,g,m)=>({share:f/h,note:`${g} of ${s}: ${ht(f,m)} of ${ht(h,m)}`});return[...o?[c(l("v",r),o,"speed",`${t}/s`)]:[],...i&&e>=0?[c(l("effort",e),i,"effort",n)]:[],...a?[{share:l("q",r,a[0])/a[1],note:`range of ${s}, from its middle`}]:[]]}function qe(s,r){return s.reduce((e,t)=>e===null||r(t)>r(e)?t:e,null)}var re=["y","z"],vs=[{id:"deflection",of:"deflection",label:"Deflection",unit:"m",planes:re},{id:"slope",of:"slope",label:"Slope",unit:"rad",planes:re},{id:"moment",of:"moment",label:"Moment",unit:"N m",planes:["torsion",...re]},{id:"shear_force",of:"shear",label:"Shear force",unit:"N",planes:re}];function hn(s,r,e){if(!r.length)return null;let t=s.stations.data,[n,o]=[r.length,t.length],i=Float64Array.from({length:n*o},(a,u)=>r[Math.floor(u/o)].length*t[u%o]);return{links:r.map(a=>a.name),places:{data:i,shape:[n,o]},quantities:vs.map(({id:a,of:u,label:l,unit:c,planes:f})=>{let h=new Float64Array(e*n*o*f.length);return r.forEach((g,m)=>pn(g[u],h,e,m,n,o*f.length)),{id:a,label:l,unit:c,planes:[...f],values:{data:h,shape:[e,n,o,f.length]}}})}}function mn(s,r,e){let[t,n]=[s.links.length,s.stations.data.length],o=(u,l,c,f)=>{let h=new Float64Array(e*t*n);return s.links.forEach((g,m)=>{let d=g.bends?r.find(p=>p.name===g.name):void 0,y=d&&f(d);y&&pn(y,h,e,m,t,n)}),{id:u,label:l,unit:c,values:{data:h,shape:[e,t,n]}}};if(!r.length)return[];let a=[o("bending_moment","Bending moment","N m",({moment:u})=>Float64Array.from({length:e*n},(l,c)=>Math.sqrt(u[3*c+1]**2+u[3*c+2]**2))),o("torsion","Torsional moment","N m",({moment:u})=>Float64Array.from({length:e*n},(l,c)=>Math.abs(u[3*c]))),o("deflection","Deflection from the root\'s tangent","m",({deflection:u})=>yt(u,2))];return r.some(u=>u.stress)?[...a,o("stress","Largest stress (von Mises)","Pa",({stress:u})=>u&&u.mises),o("strain","Largest strain","1",({stress:u})=>u&&u.strain)]:a}function pn(s,r,e,t,n,o){for(let i=0;i<e;i+=1)r.set(s.subarray(i*o,(i+1)*o),(i*n+t)*o)}function x(s,r,e,t,n,o,i=1){let a=e[t+1]*n[o+2]-e[t+2]*n[o+1],u=e[t+2]*n[o]-e[t]*n[o+2],l=e[t]*n[o+1]-e[t+1]*n[o];s[r]+=i*a,s[r+1]+=i*u,s[r+2]+=i*l}function L(s,r,e,t,n=1){s[r]+=n*e[t],s[r+1]+=n*e[t+1],s[r+2]+=n*e[t+2]}function J(s,r,e,t,n=3){for(let o=0;o<n;o+=1)s[r+o]=e[t+o]}function ot(s,r,e,t,n,o,i=1){s[r]+=i*(e[t]*n[o]+e[t+1]*n[o+1]+e[t+2]*n[o+2]),s[r+1]+=i*(e[t+3]*n[o]+e[t+4]*n[o+1]+e[t+5]*n[o+2]),s[r+2]+=i*(e[t+6]*n[o]+e[t+7]*n[o+1]+e[t+8]*n[o+2])}function X(s,r,e,t,n){return s[r+e]*t[n]+s[r+3+e]*t[n+1]+s[r+6+e]*t[n+2]}function $e(s,r,e,t,n,o){for(let i=0;i<3;i+=1)for(let a=0;a<3;a+=1)s[r+3*i+a]=e[t+3*i]*n[o+a]+e[t+3*i+1]*n[o+3+a]+e[t+3*i+2]*n[o+6+a]}function gn(s,r,e,t,n){let[o,i]=[Math.cos(n),Math.sin(n)],[a,u,l]=[e[t],e[t+1],e[t+2]];s[r]=a*a+o*(1-a*a),s[r+1]=(1-o)*a*u-i*l,s[r+2]=(1-o)*a*l+i*u,s[r+3]=(1-o)*a*u+i*l,s[r+4]=u*u+o*(1-u*u),s[r+5]=(1-o)*u*l-i*a,s[r+6]=(1-o)*a*l-i*u,s[r+7]=(1-o)*u*l+i*a,s[r+8]=l*l+o*(1-l*l)}var O=21,[I,C,V,Z]=[9,12,15,18],G=new Float64Array(24),[ne,oe,qt,Pe]=[0,3,6,9];function yn(s,r,e,t,n,o,i,a){let[u,l,c]=a;G.fill(0,0,Pe),$e(s,r,e,t,o,i),ot(G,ne,e,t,o,i+9),ot(G,qt,s,r,o,i+12),L(G,oe,G,qt,l),J(s,r+I,e,t+I,O-I),n==="revolute"?(gn(G,Pe,o,i+12,u),J(dn,0,s,r,9),$e(s,r,dn,0,G,Pe),L(s,r+V,G,qt,c),x(s,r+V,e,t+C,G,oe),L(s,r+C,G,oe)):n==="prismatic"&&(L(G,ne,G,qt,u),x(s,r+Z,e,t+C,G,oe,2),L(s,r+Z,G,qt,c)),L(s,r+I,G,ne),$t(s,r+Z,e,t,G,ne)}var dn=new Float64Array(9),_e=new Float64Array(3);function $t(s,r,e,t,n,o){x(s,r,e,t+V,n,o),_e.fill(0),x(_e,0,e,t+C,n,o),x(s,r,e,t+C,_e,0)}var lt=new Float64Array(9),se=new Float64Array(3);function ze(s,r,e,t,n,o){t<0||(lt.fill(0),ot(lt,0,n,o,e,t+1),L(lt,3,n,o+Z,e[t]),$t(lt,3,n,o,lt,0),L(s,r,lt,3,-1),x(s,r+3,lt,0,n,o+Z,-1),wn(s,r+3,e,t+4,n,o,V),lt.fill(0,6),wn(lt,6,e,t+4,n,o,C),x(s,r+3,n,o+C,lt,6))}function wn(s,r,e,t,n,o,i){let a=X(n,o,0,n,o+i),u=X(n,o,1,n,o+i),l=X(n,o,2,n,o+i);se[0]=e[t]*a+e[t+3]*u+e[t+4]*l,se[1]=e[t+3]*a+e[t+1]*u+e[t+5]*l,se[2]=e[t+4]*a+e[t+5]*u+e[t+2]*l,ot(s,r,n,o,se,0,-1)}var bn=3,ce=class{constructor(r,e){this.info=r;this.numbers=e;this.frames=new Float64Array((r.edges+1)*O),[this.points,this.gains,this.line,this.moved]=Array.from({length:4},()=>new Float64Array(r.points*3)),this.turns=r.directions.length}info;numbers;frames;points;gains;line;moved;sums=new Float64Array(18);turns;march(r,e,t){let{info:n,frames:o}=this;J(o,0,e,t,O);for(let i=0;i<n.edges;i+=1)this.sum(r,n.march+i*(2*this.turns+bn),!0),An(o,(i+1)*O,o,i*O,this.sums,n.terms,!0);this.tangents(r),this.weighted(this.points,n.toPoints,this.line),this.weighted(this.gains,n.toPoints,this.moved);for(let i=0;i<n.points;i+=1)L(this.gains,3*i,o,Z);for(let i=0;i<=n.stations.length;i+=1){let a=O*(i<n.stations.length?n.stations[i].edge:n.edges);J(o,a+I,o,I),J(o,a+Z,o,Z),this.along(o,a+I,n.toEnds+i*n.points,this.line),this.along(o,a+Z,n.toEnds+i*n.points,this.moved)}}place(r,e,t){let{info:n}=this;this.sum(r,n.reach+e*(2*this.turns+bn),!1),An(t,0,this.frames,n.before[e]*O,this.sums,n.terms,!1),t.fill(0,I,I+3),this.along(t,I,n.toPlaces+e*n.points,this.line)}sum(r,e,t){let{sums:n,numbers:o,turns:i}=this,{q:a,v:u,a:l,start:c}=r,f=c+this.info.first;n.fill(0);for(let h=0;h<i;h+=1){let g=this.info.directions[h],m=o[e+h],d=o[e+i+h];n[g]+=m*a[f+h],n[3+g]+=d*a[f+h],t&&(n[6+g]+=m*u[f+h],n[9+g]+=d*u[f+h],n[12+g]+=m*l[f+h],n[15+g]+=d*l[f+h])}for(let h=0;h<3;h+=1)n[h]+=o[e+2*i+h]}tangents({q:r,v:e,a:t,start:n}){let{info:o,frames:i,numbers:a,line:u,moved:l}=this,c=n+o.first+this.turns;l.fill(0);for(let f=0;f<o.points;f+=1){let h=1,g=0,m=0;for(let y=0;y<o.stretches;y+=1){let p=a[o.stretch+f*o.stretches+y];h+=p*r[c+y],g+=p*e[c+y],m+=p*t[c+y]}let d=o.pointEdges[f]*O;for(let y=0;y<3;y+=1)ie[y]=i[d+3*y];for(let y=0;y<3;y+=1)u[3*f+y]=h*ie[y];$t(l,3*f,i,d,u,3*f),x(l,3*f,i,d+C,ie,0,2*g),L(l,3*f,ie,0,m)}}weighted(r,e,t){r.fill(0);for(let n=0;n<this.info.points;n+=1)this.along(r,3*n,e+n*this.info.points,t)}along(r,e,t,n){let{numbers:o}=this,i=0,a=0,u=0;for(let l=0;l<this.info.points;l+=1){let c=o[t+l];i+=c*n[3*l],a+=c*n[3*l+1],u+=c*n[3*l+2]}r[e]+=i,r[e+1]+=a,r[e+2]+=u}},ie=new Float64Array(3),S=new Float64Array(54),[st,pt,Pt,ae,le,ue,Ce,We,De]=[0,3,6,9,12,15,24,33,42],Fn=new Map;function An(s,r,e,t,n,o,i){S.fill(0),L(S,st,n,0),x(S,st,n,0,n,3);let a=S[st]**2+S[st+1]**2+S[st+2]**2,{values:u,slopes:l}=Ss(o),c=_t(u[0],a),f=_t(u[1],a),h=_t(u[2],a);for(let m=0;m<9;m+=3)x(S,ue+m,e,t+m,S,st);for(let m=0;m<9;m+=3)x(S,Ce+m,S,ue+m,S,st);for(let m=0;m<9;m+=1)s[r+m]=e[t+m]+c*S[ue+m]+f*S[Ce+m];if(!i)return;for(let m=0;m<9;m+=1)S[We+m]=e[t+m]+f*S[ue+m]+h*S[Ce+m];L(S,pt,n,6),x(S,pt,n,6,n,3),x(S,pt,n,0,n,9),L(S,Pt,n,12),x(S,Pt,n,12,n,3),x(S,Pt,n,0,n,15),x(S,Pt,n,6,n,9,2),ot(S,De,S,We,S,pt),x(S,ae,S,st,S,pt);let g=2*(S[st]*S[pt]+S[st+1]*S[pt+1]+S[st+2]*S[pt+2]);L(S,le,S,ae,g*_t(l[0],a)),x(S,le,S,st,S,ae,g*_t(l[1],a)),x(S,le,S,pt,S,ae,h),J(s,r+V,e,t+V),x(s,r+V,e,t+C,S,De),ot(s,r+V,e,t,S,le),ot(s,r+V,S,We,S,Pt),J(s,r+C,e,t+C),L(s,r+C,S,De)}function Ss(s){let r=Fn.get(s);if(r)return r;let e=o=>Array.from({length:o},(i,a)=>a+1).reduce((i,a)=>i*a,1),t=Array.from({length:s},(o,i)=>s-1-i),n={values:[1,2,3].map(o=>Float64Array.from(t,i=>(-1)**i/e(2*i+o))),slopes:[2,3].map(o=>Float64Array.from(t.slice(0,-1),i=>i*(-1)**i/e(2*i+o)))};return Fn.set(s,n),n}function _t(s,r){let e=0;for(let t=0;t<s.length;t+=1)e=e*r+s[t];return e}var tt=6,Rs=I+3,fe=class{constructor(r,e,t,n,o){this.nodes=r;this.points=e;this.numbers=t;this.base=n;this.places=o;this.frames=new Float64Array(2*r.length*O),this.hung=new Float64Array(r.length*tt),this.beams=r.map(({beam:a})=>a&&new ce(a,t)),this.carried=r.map(({beam:a})=>a&&ks(o));let i=Math.max(0,...r.map(({beam:a})=>a?.points??0));this.pairs=new Float64Array(3*i*(i+1)/2),this.spins=new Float64Array(9*i)}nodes;points;numbers;base;places;carried;frames;hung;beams;section=new Float64Array(Rs);load=new Float64Array(tt);pairs;spins;find(r,e){let{nodes:t,frames:n,base:o}=this;t.forEach(({parent:i,kind:a,angle:u,joint:l},c)=>{let f=u<0?Es:[r.q,r.v,r.a].map(d=>d[r.start+u]),[h,g]=i<0?[o,0]:[n,this.tip(i)];yn(n,this.root(c),h,g,a,this.numbers,l,f),this.beams[c]?.march(r,n,this.root(c));let m=this.beams[c];m?J(n,this.tip(c),m.frames,m.info.edges*O,O):J(n,this.tip(c),n,this.root(c),O)}),this.hung.fill(0);for(let i=t.length-1;i>=0;i-=1)this.balanced(i,r,e)}root(r){return r*O}tip(r){return(this.nodes.length+r)*O}balanced(r,e,t){let{frames:n,hung:o,load:i}=this,a=this.beams[r],u=this.root(r);ze(o,r*tt,this.numbers,this.nodes[r].tip,n,this.tip(r)),this.pushed(o,r*tt,r,-1,n,this.tip(r),t),a?this.along(r,a,this.carried[r],e,t):J(i,0,o,r*tt,tt);let l=this.nodes[r].parent;l>=0&&Ue(o,l*tt,i,0,n,u+I,n,this.tip(l)+I)}pushed(r,e,t,n,o,i,a){this.points.forEach((u,l)=>{if(!(u.node!==t||u.station!==n)){H.fill(0,0,3),ot(H,0,o,i,this.numbers,u.offset);for(let c=0;c<tt;c+=1)r[e+c]+=a[l*tt+c];x(r,e+3,H,0,a,l*tt)}})}along(r,e,t,n,o){let{frames:i,hung:a,load:u,section:l}=this,c=this.root(r),f=e.info.stations.map((h,g)=>{let m=new Float64Array(tt);return ze(m,0,this.numbers,h.body,e.frames,h.edge*O),this.pushed(m,0,r,g,e.frames,h.edge*O,o),m});this.spread(e);for(let h=this.places-1;h>=0;h-=1){e.place(n,h,l),xs(t,h,i,c,l),L(l,I,i,c+I),u.fill(0),Ue(u,0,a,r*tt,i,this.tip(r)+I,l,I),e.info.stations.forEach(({edge:g,last:m},d)=>{h<=m&&Ue(u,0,f[d],0,e.frames,g*O+I,l,I)}),this.outboard(e,h,u,i,c);for(let g=0;g<3;g+=1)t.moment[3*h+g]=X(l,0,g,u,3);for(let g=0;g<2;g+=1)t.shear[2*h+g]=X(l,0,g+1,u,0);t.axial[h]=X(l,0,0,u,0)}}spread({info:r,points:e,gains:t,frames:n}){let{pairs:o,spins:i}=this;o.fill(0);let a=0;for(let u=0;u<r.points;u+=1)for(let l=u;l<r.points;l+=1,a+=3)x(o,a,e,3*u,t,3*l,-1),l>u&&x(o,a,e,3*l,t,3*u,-1);i.fill(0,0,3*r.rotary*r.points);for(let u=0;u<r.rotary;u+=1)for(let l=0;l<r.points;l+=1){let c=r.pointEdges[l]*O;for(let h=0;h<3;h+=1)H[h]=n[c+3*h+u];let f=3*(u*r.points+l);x(i,f,n,c+C,H,0,X(n,c,u,n,c+C)),L(i,f,H,0,X(n,c,u,n,c+V))}}outboard({info:r,gains:e},t,n,o,i){let{numbers:a,pairs:u,spins:l,section:c}=this,f=r.points;H.fill(0,0,6),Ge(H,0,e,a,r.outboard+t*f,f,-1),L(H,3,c,I),L(H,3,o,i+I,-1),L(n,0,H,0),x(n,3,H,3,H,0,-1);let h=f*(f+1)/2;Ge(n,3,u,a,r.levers+t*h,h,1),Ge(n,3,l,a,r.turning+t*r.rotary*f,r.rotary*f,-1)}},Es=[0,0,0],H=new Float64Array(9),zt=new Float64Array(6);function ks(s){let[r,e,t,n,o]=[2,2,3,2,1].map(i=>new Float64Array(i*s));return{deflection:r,slope:e,moment:t,shear:n,axial:o}}function Ge(s,r,e,t,n,o,i){let a=0,u=0,l=0;for(let c=0;c<o;c+=1){let f=t[n+c];a+=f*e[3*c],u+=f*e[3*c+1],l+=f*e[3*c+2]}s[r]+=i*a,s[r+1]+=i*u,s[r+2]+=i*l}function Ue(s,r,e,t,n,o,i,a){for(let u=0;u<tt;u+=1)s[r+u]+=e[t+u];for(let u=0;u<3;u+=1)zt[u]=n[o+u]-i[a+u];x(s,r+3,zt,0,e,t)}function xs({deflection:s,slope:r},e,t,n,o){for(let a=0;a<3;a+=1)zt[a]=o[3*a];let i=X(t,n,0,zt,0);for(let a=0;a<2;a+=1)s[2*e+a]=X(t,n,a+1,o,I),r[2*e+a]=Math.atan2(X(t,n,a+1,zt,0),i)}function Mn(s,r,e){let[t,n,o,i]=s.subarray(r,r+4),[a,u,l,c]=[0,1,2,3].map(d=>s.subarray(r+4+d*e,r+4+(d+1)*e)),f=(d,y)=>Math.abs(d-y)<=1e-9*Math.abs(y),h=o===i&&n>0&&c.every((d,y)=>f(d/n,(a[y]+u[y])/t)),g=h?o:Math.min(2*Math.min(o,i),Math.hypot(o,i)),m=(d,y)=>y.map(p=>p>0?d/p:0);return{young:t,ring:h,perMomentY:m(i,a),perMomentZ:m(o,u),perForce:m(1,l),perTorsion:m(n*g,c)}}function vn({young:s,ring:r,perMomentY:e,perMomentZ:t,perForce:n,perTorsion:o},{moment:i,axial:a},u){for(let l=0;l<a.length;l+=1){let[c,f]=[Math.abs(i[3*l+1])*e[l],Math.abs(i[3*l+2])*t[l]];u.strain[l]=(r?Math.sqrt(c*c+f*f):c+f)+Math.abs(a[l])*n[l];let[h,g]=[s*u.strain[l],Math.abs(i[3*l])*o[l]];u.mises[l]=Math.sqrt(h*h+3*g*g)}}var js=4e5;function Sn(s,r,e,t,n,o){let{carried:i}=s,a=B(i.places),u=new fe(i.nodes,i.points,r,Is(s),a.length),l=i.nodes.flatMap((m,d)=>m.beam?[Ns(m,u.carried[d],r,a.length,o.length*i.shown.data.length)]:[]),c=Math.max(1,Math.ceil(t.length*l.length*a.length/js)),f=new Float64Array($*i.points.length),h=e.q.shape[1],g=0;for(let m=0;l.length>0&&m<t.length;m+=1){let d=o[g]===m;if(!(!d&&m%c)){Ls(s,r,e,n,t[m],m,f),u.find({q:e.q.data,v:e.v.data,a:e.a.data,start:m*h},f);for(let y of l)y.fibre&&y.stress&&vn(y.fibre,y.carried,y.stress),Ts(y,a,m),d&&Os(y,g,i.shown.data);d&&(g+=1)}}return{links:l.map(m=>m.info),every:c}}function Is({base:s,gravity:r}){let e=new Float64Array(O);e.set(Array.from(s.data).slice(9,18)),e.set(Array.from(s.data).slice(18,21),I);for(let t=0;t<3;t+=1)e[Z+t]=-r.data[t];return e}function Ns(s,r,e,t,n){let o=s.beam,i=o.stress<0?null:Mn(e,o.stress,t),a=h=>i?{strain:new Float64Array(h),mises:new Float64Array(h)}:null,[u,l]=[2*n,3*n],f={...{deflection:new Float64Array(u),slope:new Float64Array(u),moment:new Float64Array(l),shear:new Float64Array(u),axial:new Float64Array(n)},name:s.name,length:e[o.length],stress:a(n),largest:{deflection:null,moment:null,stress:null}};return{carried:r,fibre:i,stress:a(t),info:f}}function Ls({carried:s},r,e,t,n,o,i){i.fill(0);for(let a of s.loads){let u=r.subarray(a.wrench,a.wrench+$),l=o*e.rotation.shape[1]+s.points[a.place].point,c=kt(a,u,t,n,e.rotation.data,9*l);for(let f=0;f<$;f+=1)i[$*a.place+f]+=c[f]}if(s.touched>=0)for(let a=0;a<3;a+=1)i[$*s.touched+a]-=e.contact_force.data[3*o+a]}function Ts({carried:s,stress:r,info:e},t,n){let o=t.length-1;Ye(e,"deflection",Math.sqrt(s.deflection[2*o]**2+s.deflection[2*o+1]**2),t[o],n);for(let i=0;i<=o;i+=1)Ye(e,"moment",Math.sqrt(s.moment[3*i+1]**2+s.moment[3*i+2]**2),t[i],n),r&&Ye(e,"stress",r.mises[i],t[i],n)}function Ye({name:s,largest:r},e,t,n,o){let i=r[e];(!i||t>i.value)&&(r[e]={link:s,value:t,s:n,sample:o})}function Os({carried:s,stress:r,info:e},t,n){let o=n.length,i=(a,u,l)=>{for(let c=0;c<o;c+=1)for(let f=0;f<l;f+=1)u[(t*o+c)*l+f]=a[n[c]*l+f]};i(s.deflection,e.deflection,2),i(s.slope,e.slope,2),i(s.moment,e.moment,3),i(s.shear,e.shear,2),i(s.axial,e.axial,1),!(!r||!e.stress)&&(i(r.strain,e.stress.strain,1),i(r.mises,e.stress.mises,1))}async function Rn(s,r,e,t,n,o){let{settings:i}=r,a=r.runs[t],u=at(0,a.signals).map(f=>de(ge(n[`knots.${f}`],n[`coefficients.${f}`]),i.duration)),l=sr(u);u.length||(l.knots[1]=i.duration);let c=await Ze(s,{loop:`${t}.${i.method}`,parameters:n.parameters,knots:l.knots,rows:rr(l),state:gr(s,r,e,t,l),times:B(r.times),settings:i},o);return{name:t,info:a,blocks:n,schedule:l,run:c}}var ut=24;function En(s,r,e,t){let n=e.run.times.subarray(0,t),o=e.run.states.subarray(0,t*(e.run.states.length/e.run.times.length)),i=nr(e.schedule,n),a={time:n,state:o,row:i,step:new Float64Array(1)},u=s.sample(`${e.name}.observe`,e.blocks.parameters,a,t),{q:l,v:c,a:f}=u,h=B(r.base),{chain:g,rotors:m}=e.blocks,{points:d}=s.sample("inertia",g,{q:l,v:c,a:f,base:h},t),y=new Float64Array(m.length),p=s.sample("inertia",g,{q:l,v:y,a:c,base:h},t),w=s.sample("elastic",g,{q:l,v:c,base:h},t).energies;return{model:u,points:d,energy:Bs(r,c,m,p,w,t)}}function Bs(s,r,e,t,n,o){let i=e.length,a=n.length/o,u=new Float64Array(4*o);for(let l=0;l<o;l+=1){for(let c=0;c<i;c+=1){let f=r[l*i+c];u[4*l]+=(t.forces[l*i+c]+e[c]*f)*f/2}for(let c=0;c<3;c+=1)u[4*l+1]-=t.moment[3*l+c]*s.gravity.data[c];for(let c=0;c<a;c+=1)u[4*l+2+c%2]+=n[l*a+c]}return u}function kn(s,r,{model:e,points:t,energy:n},o){let i=e.q.length/o,a=e.gear.length/o,u=t.length/o/ut,l=r.run.states.length/r.run.times.length,c=Y(r.run.states.subarray(0,o*l),l,at(...r.info.state.works)),f=y=>j(Y(e.drives,4*a,at(0,a).map(p=>4*p+y)),o,a),h=y=>Y(t,u*ut,at(0,u).flatMap(p=>at(0,3).map(w=>p*ut+y+w))),g=Y(t,u*ut,at(0,u).flatMap(y=>at(y*ut,y*ut+9))),m={q:j(e.q,o,i),v:j(e.v,o,i),a:j(e.a,o,i),deformation:j(wt(s.deflections,e.q,o),o,s.deformations.length),position:j(h(9),o,u,3),velocity:j(h(12),o,u,3),acceleration:j(h(18),o,u,3),rotation:j(g,o,u,3,3),tip:j(Y(t,u*ut,[9,10,11]),o,3),tip_velocity:j(Y(t,u*ut,[12,13,14]),o,3),energy:j(n,o,4),work:j(c,o,c.length/o),energy_balance:j(yr(n,c,o,3),o)};if(a&&Object.assign(m,{wanted:f(3),effort:f(0),gear_torque:j(e.gear,o,a)}),a&&s.electric&&Object.assign(m,{voltage:f(1),current:f(2)}),s.contactPoint<0)return m;let d=y=>Y(e.contact,6,y);return{...m,contact_force:j(d([0,1,2]),o,3),contact_force_normal:j(d([3]),o),penetration:j(d([4]),o)}}function xn(s,r,e,t){let n=e.model.q.length/t,o=e.points.length/t/ut,[i,a]=[r,e].map(({points:l})=>Y(l,o*ut,[9,10,11])),u={q_reference:j(e.model.q,t,n),v_reference:j(e.model.v,t,n),deformation_reference:j(wt(s.deflections,e.model.q,t),t,s.deformations.length),gear_torque_reference:j(e.model.gear,t,e.model.gear.length/t),tip_reference:j(a,t,3),deviation:j(yt(Jt(i,a),3),t)};return s.contactPoint>=0&&(u.contact_force_normal_reference=j(Y(e.model.contact,6,[3]),t)),u}var qs=32;async function jn(s,r,e,t,n,o=()=>{}){let i=performance.now(),a=r.runs.reference?["reference","real"]:["real"],u=[];for(let[R,E]of a.entries()){let v={...t,progress:q=>t.progress?.((R+q)/a.length)},k=jt(r.map,e,E),N=()=>Rn(s,r,e,E,k,v);u.push(await(E==="reference"?n.of(k,N):N()))}let l=u[u.length-1];o(l);let c=(performance.now()-i)/1e3,f=Math.min(...u.map(R=>R.run.times.length)),[h,g]=[l,...u.slice(0,-1)].map(R=>En(s,r,R,f)),m=l.run.times.subarray(0,f),d={...kn(r,l,h,f),...g?xn(r,h,g,f):{}},y=hr(r,f),p=Ps(l.schedule),w=u.find(R=>R.run.status!=="finished"),b=Sn(r,l.blocks.carried,d,m,l.schedule,y),F={...un(r,m,d,p),...cn(b,r.carried,m),...fn(r.carried.limits,d)},A=mn(r,b.links,y.length);return{status:w?w.run.status:"finished",message:w?`${w===l?"actual robot":"reference"}: ${w.run.message}`:l.run.message,seconds:c,times:m,series:d,scene:wr(s,r,l.blocks,d,m,y,A),line:hn(r,b.links,y.length),span:$s(m,p),facts:w?Jr(F):F}}function $s(s,r){let e=s[s.length-1],t=r===null?-1:s.findIndex(n=>n>=r*(1+1e-9));return[t>=0&&s.length-t>=qs?s[t]:s[0],e]}function Ps(s){let r=s.knots.length-1,e=s.degree+1;for(let t=r-1;t>=0;t-=1)for(let n=0;n<s.signals;n+=1){let o=s.coefficients.subarray((t*s.signals+n)*e,(t*s.signals+n+1)*e),i=s.knots[t+1]-s.knots[t],a=Math.max(...at(0,r).map(c=>Math.abs(s.coefficients[(c*s.signals+n)*e])),1e-12);if(o.some((c,f)=>f>0&&Math.abs(c)*i**f>1e-9*a))return t===r-1?null:s.knots[t+1];let l=t&&Et(s,n,s.knots[t]-1e-9*i);if(t&&Math.abs(o[0]-l)>1e-6*a)return s.knots[t]}return 0}async function In(s){let r=await Wt.open(s.module.data,s.layout),e=new Dt;return{async run(t,n,o=()=>{}){let i=null,a=await jn(r,s,t,n,e,u=>{i=u});return o(a,[a.times,a.series,i]),ln(r,s,t,a,i,n)}}}var St=self,Ke=null,Ln=-1,Nn=Promise.resolve();St.onmessage=({data:s})=>{if(s.kind==="open"){In(s.bundle).then(t=>{Ke=t,St.postMessage({kind:"ready"})},t=>St.postMessage({kind:"failed",message:String(t)}));return}let{id:r,values:e}=s;Ln=r,Nn=Nn.then(()=>_s(r,e))};async function _s(s,r){let e=()=>s!==Ln;try{if(!Ke)throw new Error("the live model is not open");if(await new Promise(a=>setTimeout(a,0)),e())throw new dt("a newer run began");let t={cancelled:e,progress:a=>St.postMessage({kind:"progress",id:s,share:a})},n=null,o=await Ke.run(r,t,(a,u)=>{n=a;let l=new Set(Nt(u));St.postMessage({kind:"early",id:s,run:a},Nt(a).filter(c=>!l.has(c)))}),i=Ve(o,n);St.postMessage({kind:"done",id:s,run:i},Nt(i))}catch(t){let n=t instanceof Error?t.message:String(t);St.postMessage({kind:"error",id:s,cancelled:t instanceof dt,message:n})}}})();\n';function ry(r){let{settings:t,status:e}=r,{statuses:n,limits:i}=r.layout,s=`t = ${Ze(r.time,6)} s`;if(e===n.finished)return["finished",`reached the end, t = ${Ze(t.duration,6)} s`];if(e===n.running)return["stopped",`stopped at ${s} of ${Ze(t.duration,6)} s: integration.max_steps = ${t.maxSteps} is used up`];if(e===n.chattering){let o=`more than ${i.most_events} times within ${i.event_time} s`;return["chattering",`stopped at ${s}: the contact set in or ended ${o}; give the surface damping, or a lower stiffness`]}return hM(r,s)}function hM({layout:r,status:t,lastStep:e,rates:n},i){let{statuses:s,coordinates:o,limits:a}=r,l=o.length,c=Array.from(n().subarray(l,2*l),y=>Number.isFinite(y)?Math.abs(y):1/0),u=c.indexOf(Math.max(...c)),f=c[u]<a.bound?t===s.not_converged?"not_converged":t===s.step_too_small?"step_too_small":"diverged":"diverged",d=`its acceleration is ${Ze(c[u],3)} rad/s^2`,p=f.replaceAll("_"," ");return[f,`${p} at ${i} in coordinate ${o[u]}: ${d}; its last step was of ${Ze(e,3)} s`]}var Wi=class extends Error{name="EngineError"};function Xa(r,t,e){if(!Object.hasOwn(r,t))throw new Wi(`${e}: got ${t}; expected one of ${Object.keys(r).join(", ")}`);return r[t]}function gs(r,t,e){if(t!==e)throw new Wi(`${r}: got ${t} numbers; expected ${e}`)}var fM=["rk4","midpoint"],dM=500,yd=class{constructor(t,e){this.engine=t;this.spec=e;let n=Xa(t.layout.loops,e.loop,"loop");gs(`${e.loop}: parameters`,e.parameters.length,n.parameters),gs(`${e.loop}: state`,e.state.length,n.size),gs(`${e.loop}: rows`,e.rows.length,(e.knots.length-1)*n.row),this.method=n.method,this.memory=new Float64Array(t.layout.cells.length),this.state=e.state.slice(),this.slope=new Float64Array(n.size),this.sums=new Float64Array(n.size),this.states=new Float64Array(e.times.length*n.size),this.sumsAtSamples=new Float64Array(e.times.length*n.size),this.states.set(e.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;sums;sumsAtSamples;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(t){return this.memory[this.engine.layout.cells.indexOf(t)]}put(t){for(let[e,n]of Object.entries(t))this.memory[this.engine.layout.cells.indexOf(e)]=n}advance(t){let{layout:e}=this.engine,{settings:n,knots:i,rows:s,times:o,parameters:a}=this.spec,l=Math.max(1,Math.min(t,n.maxSteps-this.tried)),c={step:n.step,rtol:n.relativeTolerance,atol:n.absoluteTolerance,chunk:l,bound:e.limits.bound,watch:0,most_events:e.limits.most_events,event_time:e.limits.event_time,looks:0},u=this.cell("sample"),h=p=>({into:p,range:()=>[u*this.state.length,this.cell("sample")*this.state.length]}),f=p=>({into:p,given:!0}),d={memory:f(this.memory),y:f(this.state),k1:f(this.slope),p:a,knots:i,rows:s,times:o,out:h(this.states),options:Float64Array.from(e.options,p=>c[p]),errors:f(this.sums),errors_out:h(this.sumsAtSamples),seen:new Float64Array(1),segments:i.length-1,samples:o.length};this.engine.call(e.loops[this.spec.loop].export,e.arguments.map(p=>d[p]))}result(){let t=this.cell("sample"),e=this.state.length,[n,i]=ry({layout:this.engine.layout,settings:this.spec.settings,status:this.cell("status"),time:this.time,lastStep:this.cell("h"),rates:()=>this.rates()});return{status:n,message:i,times:this.spec.times.slice(0,t),states:this.states.slice(0,t*e),errors:this.sumsAtSamples.slice(0,t*e),statistics:this.statistics()}}statistics(){let[t,e,n]=[this.cell("steps"),this.cell("smallest"),this.time],i=t?n/t:null,s={steps:t,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:i,smallest_step_s:e>0?e:i};return fM.includes(this.method)&&(s.step=this.cell("h")),this.cell("passes")&&(s.passes=this.cell("passes")),this.cell("events")&&(s.contact_changes=this.cell("events")),s}rates(){let{loop:t,parameters:e,rows:n}=this.spec,{row:i}=this.engine.layout.loops[t],s=Math.min(this.cell("segment"),n.length/i-1),o={time:Float64Array.of(this.time),state:this.state,row:n.slice(s*i,(s+1)*i),step:new Float64Array(1)};return this.engine.sample(`${t.slice(0,t.lastIndexOf("."))}.rate`,e,o,1).rate}},js=class extends Wi{name="Cancelled"};async function sy(r,t,e={}){let n=new yd(r,t),i=1e3*(e.piece??.05),s=dM,o=performance.now();for(;n.running;){let a=performance.now();n.advance(s);let l=performance.now();if(s=Math.max(1,Math.floor(s*Math.min(4,i/Math.max(l-a,.001)))),!(l-o<i)){if(e.progress?.(n.time/t.settings.duration),await new Promise(c=>setTimeout(c,0)),e.cancelled?.())throw new js(`the run was given up at t = ${Ze(n.time,6)} s`);o=performance.now()}}return n.result()}function oy(r,t){return{...r,...t,series:{...r?.series,...t.series}}}var ay=1,pM=65536,mM={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},Rc=class r{constructor(t,e,n,i){this.layout=t;this.functions=e;this.memory=n;this.free=i}layout;functions;memory;free;outputs=new Float64Array;static async open(t,e){if(e.format!==ay)throw new Wi(`layout: got format ${e.format}; expected ${ay}`);let{instance:n}=await gM(t,e),{memory:i,heap_base:s,...o}=n.exports,a=s.value;return new r(e,o,i,a)}sample(t,e,n,i){let s=Xa(this.layout.samples,t,"function");gs(`${t}: parameters`,e.length,s.parameters);let o=s.kind==="program"?this.program(s,e,n,i):this.schedule(s,e,[n],i);return xd(s.outputs,o,i,1)}slopes(t,e,n,i,s){let o=Xa(this.layout.samples,t,"function");if(o.kind!=="slopes")throw new Wi(`${t}: got a function without derivatives; expected one with them`);gs(`${t}: parameters`,e.length,o.parameters);let a=Object.fromEntries(Object.entries(o.inputs).map(([u,h])=>[u,new Float64Array(h)])),l=this.schedule(o,e,[n,{...a,...i}],s),c=$a(o.outputs);return{values:xd(o.outputs,l,s,2),slopes:xd(o.outputs,l.subarray(c),s,2)}}call(t,e){let n=e.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(n.reduce((a,l)=>a+(l?.byteLength??0),this.free));let i=new Float64Array(this.memory.buffer),s=this.free,o=e.map((a,l)=>{if(typeof a=="number")return BigInt(a);let c=s;return(a instanceof Float64Array||a.given)&&i.set(n[l],c/8),s+=n[l].byteLength,c});this.functions[t](...o),e.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[c,u]=a.range?.()??[0,a.into.length],h=o[l]/8;a.into.set(i.subarray(h+c,h+u),c)})}program(t,e,n,i){let s=Object.entries(t.inputs).map(([a,l])=>ly(a,l,n[a],i)),o=this.room(i*$a(t.outputs));return this.call(t.export,[i,e,...s,{into:o}]),o}schedule(t,e,n,i){let s=yM(t.inputs,n,i),o=this.room(i*n.length*$a(t.outputs)),a=new Float64Array(t.workspace);return this.call(t.export,[i,0,e,a,s,{into:o}]),o}room(t){return this.outputs.length<t&&(this.outputs=new Float64Array(t)),this.outputs.subarray(0,t)}reserve(t){let e=t-this.memory.buffer.byteLength;if(!(e<=0))try{this.memory.grow(Math.ceil(e/pM))}catch{throw new Wi(`memory: got no room for ${(t/1e6).toFixed(0)} MB; expected a browser that has it. Mend: ask for fewer samples`)}}};async function gM(r,t){try{return await WebAssembly.instantiate(r,{env:mM})}catch(e){let n=t.simd?", with vectors (SIMD)":"";throw new Wi(`WebAssembly: got ${String(e)}; expected a browser that allows it${n}`)}}function $a(r){return Object.values(r).reduce((t,e)=>t+e,0)}function ly(r,t,e,n){if(e===void 0)throw new Wi(`${r}: got nothing; expected ${t} numbers for each sample`);if(e.length===n*t)return e;gs(r,e.length,t);let i=new Float64Array(n*t);return _d(e,0,0,i,t,0,t,n),i}function yM(r,t,e){let n=$a(r),i=new Float64Array(e*t.length*n);return t.forEach((s,o)=>{let a=o*n;for(let[l,c]of Object.entries(r)){let u=ly(l,c,s[l],e);_d(u,c,0,i,t.length*n,a,c,e),a+=c}}),i}function xd(r,t,e,n){let i=n*$a(r),s={},o=0;for(let[a,l]of Object.entries(r)){let c=new Float64Array(e*l);_d(t,i,o,c,l,0,l,e),s[a]=c,o+=l}return s}function _d(r,t,e,n,i,s,o,a){for(let l=0;l<a;l++){let c=l*t+e,u=l*i+s;for(let h=0;h<o;h++)n[u+h]=r[c+h]}}var Cc=class{last=null;async of(t,e){if(this.last&&xM(this.last.blocks,t))return this.last.made;this.last=null;let n=await e();return this.last={blocks:t,made:n},n}};function xM(r,t){return Object.entries(r).every(([e,n])=>n.length===t[e].length&&n.every((i,s)=>i===t[e][s]))}function vd(r,t){return{knots:r,coefficients:t,signals:1,degree:t.length/(r.length-1)-1}}function bd(r,t){let e=r.degree+1,n=r.knots.length-1,i=0;for(;i<n&&r.knots[i]<t;)i+=1;let s=r.knots[n],o=[...r.knots.subarray(0,i)],a=[...r.coefficients.subarray(0,i*e)];return t>s&&(o.push(s),a.push(cy(r,n-1,0,s),...new Array(r.degree).fill(0))),vd(Float64Array.from([...o,t]),Float64Array.from(a))}function cy(r,t,e,n){let i=r.degree+1,s=(t*r.signals+e)*i,o=n-r.knots[t],a=0;for(let l=r.degree;l>=0;l-=1)a=a*o+r.coefficients[s+l];return a}function wd(r,t){let[e,n]=[0,r.length-1];for(;n-e>1;){let i=e+n>>1;r[i]<=t?e=i:n=i}return e}function Go(r,t,e){return cy(r,wd(r.knots,e),t,e)}function uy(r){return fy(r,Array.from({length:r.knots.length-1},(t,e)=>e))}function hy(r,t){return fy(r,Array.from(t,e=>wd(r.knots,e)))}function fy(r,t){let e=r.signals*(r.degree+1),n=new Float64Array(t.length*(e+1));return t.forEach((i,s)=>{n[s*(e+1)]=r.knots[i],n.set(r.coefficients.subarray(i*e,(i+1)*e),s*(e+1)+1)}),n}function dy(r){if(!r.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let t=Math.max(...r.map(o=>o.knots[o.knots.length-1])),e=r.map(o=>o.knots[o.knots.length-1]<t?bd(o,t):o),n=_M(e.flatMap(o=>[...o.knots])),i=Math.max(...e.map(o=>o.degree)),s=new Float64Array((n.length-1)*r.length*(i+1));return e.forEach((o,a)=>{for(let l=0;l<n.length-1;l+=1){let c=(l*r.length+a)*(i+1);vM(o,n,l,s.subarray(c,c+i+1))}}),{knots:n,coefficients:s,signals:r.length,degree:i}}function _M(r){let t=[...new Set(r)].sort((i,s)=>i-s),e=t[t.length-1]-t[0],n=t.filter((i,s)=>s===0||i-t[s-1]>1e-12*e);return n[n.length-1]=t[t.length-1],Float64Array.from(n)}function vM(r,t,e,n){let i=wd(r.knots,(t[e]+t[e+1])/2),s=t[e]-r.knots[i],o=Math.abs(s)<=1e-12*(t[t.length-1]-t[0])?0:s;for(let a=0;a<=r.degree;a+=1){let l=r.coefficients[i*(r.degree+1)+a],c=1;for(let u=a;u>=0;u-=1)n[u]+=c*l*Math.pow(o,a-u),c=c*u/(a-u+1)}}var Mn=6;function Ho({follower:r,signal:t},e,n,i,s,o){let a=t<0?1:Go(n,t,i);return(r?bM(s,o,e):e).map(l=>a*l)}function bM(r,t,e){return e.map((n,i)=>{let[s,o]=[t+3*(i%3),i<3?0:3];return r[s]*e[o]+r[s+1]*e[o+1]+r[s+2]*e[o+2]})}function Pc(r,t){let e=t.length;for(let n=0;n<e;n+=1){let i=n;for(let o=n+1;o<e;o+=1)Math.abs(r[o*e+n])>Math.abs(r[i*e+n])&&(i=o);let s=Math.abs(r[i*e+n]);if(!(s>0)||s===1/0)return!1;i!==n&&wM(r,t,n,i);for(let o=n+1;o<e;o+=1){let a=r[o*e+n]/r[n*e+n];if(a!==0){for(let l=n+1;l<e;l+=1)r[o*e+l]-=a*r[n*e+l];t[o]-=a*t[n]}}}for(let n=e-1;n>=0;n-=1){for(let i=n+1;i<e;i+=1)t[n]-=r[n*e+i]*t[i];t[n]/=r[n*e+n]}return!0}function wM(r,t,e,n){let i=t.length;for(let o=0;o<i;o+=1){let a=r[e*i+o];r[e*i+o]=r[n*i+o],r[n*i+o]=a}let s=t[e];t[e]=t[n],t[n]=s}function Ic(r,t){let e=new Float64Array(t*t);for(let n=0;n<t;n+=1)for(let i=n;i<t;i+=1){let s=r[i*t+n];for(let o=0;o<n;o+=1)s-=e[i*t+o]*e[n*t+o];if(i===n&&!(s>0))return null;e[i*t+n]=i===n?Math.sqrt(s):s/e[n*t+n]}return e}function my(r,t,e,n){for(let i=0;i<e;i+=1){for(let s=0;s<i;s+=1)yy(t,i,s,r[i*e+s],n);for(let s=0;s<n;s+=1)t[i*n+s]/=r[i*e+i]}}function Md(r,t,e,n){for(let i=e-1;i>=0;i-=1){for(let s=i+1;s<e;s+=1)yy(t,i,s,r[s*e+i],n);for(let s=0;s<n;s+=1)t[i*n+s]/=r[i*e+i]}}function yy(r,t,e,n,i){for(let s=0;s<i;s+=1)r[t*i+s]-=n*r[e*i+s]}function Lc(r,t,e){let n=t.slice();my(r,n,e,e);let i=gy(n,e);return my(r,i,e,e),gy(i,e)}function gy(r,t){return r.map((e,n)=>r[n%t*t+Math.floor(n/t)])}function fi(r,t,e,n,i,s=!1){let o=new Float64Array(e*i);for(let a=0;a<e;a+=1)for(let l=0;l<n;l+=1){let c=s?r[l*e+a]:r[a*n+l];if(c)for(let u=0;u<i;u+=1)o[a*i+u]+=c*t[l*i+u]}return o}function xy(r,t){let e=Float64Array.from({length:t*t},(n,i)=>i%(t+1)?0:1);for(let n=0;n<t;n+=1){let i=n;for(let a=n+1;a<t;a+=1)Math.abs(r[a*t+n])>Math.abs(r[i*t+n])&&(i=a);let s=Math.abs(r[i*t+n]);if(!(s>0)||s===1/0)return null;for(let a of[r,e])if(i!==n){let l=a.slice(n*t,(n+1)*t);a.copyWithin(n*t,i*t,(i+1)*t),a.set(l,i*t)}let o=r[n*t+n];for(let a=0;a<t;a+=1)r[n*t+a]/=o,e[n*t+a]/=o;for(let a=0;a<t;a+=1){let l=r[a*t+n];if(!(a===n||l===0)){for(let c=n;c<t;c+=1)r[a*t+c]-=l*r[n*t+c];for(let c=0;c<t;c+=1)e[a*t+c]-=l*e[n*t+c]}}}return e}var Fc=24;function _y(r,t,e,n,i,s){let o=n.length/Fc,a={wrenches:new Float64Array(Mn*o),mass:new Float64Array(s*s),damping:new Float64Array(s*s),stiffness:new Float64Array(s*s)},l=(c,u)=>Float64Array.from({length:3*s},(h,f)=>i[(f%s*o+c)*Fc+u+Math.floor(f/s)]);return r.loads.forEach((c,u)=>{let{point:h,follower:f}=c,d=t.loads.subarray(Mn*u,Mn*(u+1)),p=Ho(c,d,e,0,n,Fc*h);if(Wo(a.wrenches.subarray(Mn*h,Mn*(h+1)),p,1),!f)return;let y=l(h,21);for(let[g,m]of[[l(h,18),0],[y,3]])Wo(a.stiffness,fi(g,fi(MM(p.subarray(m,m+3)),y,3,3,s),s,3,s,!0),1)}),r.touch&&AM(SM(r.touch,t.surface),t.touch,n,l(r.touch.point,18),a,s),a}function Wo(r,t,e){for(let n=0;n<t.length;n+=1)r[n]+=e*t[n]}function MM([r,t,e]){return Float64Array.of(0,-e,t,e,0,-r,-t,r,0)}function SM(r,t){let[e,n,i,s]=t;if(r.radius)return{...r,axis:[e,n,i],radius:s};let[o,a,l]=r.axis;return{...r,distance:-(o*e+a*n+l*i)}}function AM(r,t,e,n,i,s){let[o,a,l,c]=t,u=Fc*r.point+9,{gap:h,normal:f,curvature:d}=EM(r,e.subarray(u,u+3)),p=c-l*h;if(!r.bilateral&&!(h<=0&&p>0))return;for(let m=0;m<3;m+=1)i.wrenches[Mn*r.point+m]+=p*f[m];let y=fi(f,n,1,3,s),g=fi(y,y,s,1,s);Wo(i.mass,g,o),Wo(i.damping,g,a),Wo(i.stiffness,g,l),Wo(i.stiffness,fi(n,fi(d,n,3,3,s),s,3,s,!0),-p)}function EM(r,t){let e=l=>l[0]*t[0]+l[1]*t[1]+l[2]*t[2];if(!r.radius)return{gap:e(r.axis)+r.distance,normal:Float64Array.from(r.axis),curvature:new Float64Array(9)};let n=t.map((l,c)=>l-r.axis[c]),i=Math.hypot(...n)||1e-300,s=r.inside?-1:1,o=n.map(l=>l/i),a=Float64Array.from({length:9},(l,c)=>s*((c%4?0:1)-o[Math.floor(c/3)]*o[c%3])/i);return{gap:s*(i-r.radius),normal:o.map(l=>s*l),curvature:a}}function vy(r,t){let e=Array.from(r.frames.data).filter(n=>n<t);return e[e.length-1]!==t-1&&e.push(t-1),e}function pn(r){return r.data instanceof Float64Array?r.data:Float64Array.from(r.data)}function TM(r,t,e){let n=r.knobs.map(s=>s.start),i=r.knobs.map(s=>s.factor);return r.sliders.forEach((s,o)=>{s.real?i[s.knob]=t[o]:n[s.knob]=t[o]}),e==="reference"?n:r.knobs.map((s,o)=>{let a=i[o];return a===null||s.factor===null?n[o]:s.together?s.factor?n[o]*(a/s.factor):n[o]:n[o]*a})}function qo(r,t,e){let n=r.runs[e],i=RM(n,TM(r,t,e)),s={};for(let[o,a]of Object.entries(n.places)){let l=a.shape.reduce((c,u)=>c*u,1);s[o]=i.slice(a.start,a.start+l)}return s}function RM(r,t){let e=pn(r.base).slice(),n=r.powers.map(l=>by(l,(c,u)=>Math.pow(t[c]/r.variables[c].start,u))),i=r.powers.map(l=>by(l,(c,u)=>CM(r.variables[c],u,t[c]))),{products:s,terms:o,coefficients:a}=r;for(let l=0;l<s.data.length;l+=2)e[s.data[l]]*=n[s.data[l+1]];for(let l=0;l<o.data.length;l+=2)e[o.data[l]]+=a.data[l/2]*i[o.data[l+1]];return e}function by(r,t){return r.reduce((e,[n,i])=>e*t(n,i),1)}function CM(r,t,e){let n=Math.pow(r.start,t);return(Math.pow(e,t)-n)/(Math.pow(r.far,t)-n)}var PM=40,IM=1e-12,LM=.5,wy=1e-6,FM=.5,NM=.001,DM=1/128;function UM(r,t,e,n,i,s){let[o,a,l]=[n.length+1,e.length,t.rotors.length],c=new Float64Array(o*a);for(let f=0;f<o;f+=1)c.set(e,f*a),f&&(c[f*a+n[f-1]]+=wy);let u={time:new Float64Array(1),state:c,row:t.rest_row,step:new Float64Array(1)},{rate:h}=r.sample("rest.rate",t.rest,u,o);for(let f=0;f<n.length;f+=1){s[f]=h[l+n[f]];for(let d=0;d<n.length;d+=1)i[f*n.length+d]=(h[(d+1)*a+l+n[f]]-s[f])/wy}}function OM(r,t,e,n){let i=r.layout.held,s=n.length,o=Array.from({length:s},(d,p)=>p).filter(d=>!i.includes(d)),a=new Float64Array(t.restSize);a.set(n);let l=new Float64Array(o.length**2),c=new Float64Array(o.length),u=1/0,[h,f]=[0,0];for(let d=0;d<PM&&o.length;d+=1){if(UM(r,e,a,o,l,c),!Pc(l,c))return null;let p=Sd(a,o,c);if(!Number.isFinite(p)||(d===0?h=p:f+=p,h>NM&&f>FM*h))return null;if(Ad(p,u))return a.slice(0,s);u=p}return o.length?null:a.slice(0,s)}function Sd(r,t,e){let n=e.reduce((s,o)=>Math.max(s,Math.abs(o)),0),i=Math.min(1,LM/n);for(let s=0;s<t.length;s+=1)r[t[s]]-=i*e[s];return n}function Ad(r,t){return r<IM||r<1e-9&&r>=t/2}function Ed(r,t,e,n,i){let s=r.sliders.map(u=>u.value),o=u=>u===1?t:t.map((h,f)=>s[f]+(h-s[f])*u),[a,l,c]=[0,1,n];for(;a<1;){let u=Math.min(1,a+l),h=i(o(u),c);if(h)[a,l,c]=[u,2*l,h];else if(l>DM)l/=2;else throw new Error(`${e}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`)}return c}function My(r,t,e,n,i){let s=t.runs[n],o=pn(s.start).slice(),[a,l]=[s.state.q[0],s.state.v[0]];if(t.atRest){let c=(h,f)=>OM(r,t,qo(t.map,h,n),f),u=Ed(t,e,n,o.slice(...s.state.q),c);for(let h=0;h<u.length;h+=1)s.info.includes(h)||(o[a+h]=u[h])}for(let[c,u]of s.exact){o[a+c]=Go(i,u,0);let h=i.degree;o[l+c]=h?i.coefficients[u*(h+1)+1]:0}return o}var kM=40,Ya=.001;function Nc(r,t,e,n){let{samples:i}=r.layout;return r.sample("loaded"in i?"loaded":"inertia",t.chain,e,n).forces}function BM(r,t,e,n,i){let s=i.length,o=new Float64Array(s),a=Float64Array.from({length:s*s},(_,E)=>E%(s+1)?0:1),l=pn(t.base),c=r.sample("inertia",e.chain,{q:i,v:o,a,base:l},s),{points:u}=r.sample("inertia",e.chain,{q:i,v:o,a:o,base:l},1),h=_y(t,e,n,u,c.points,s),f=h.mass;for(let _=0;_<s;_+=1){for(let E=0;E<s;E+=1)f[_*s+E]+=(c.forces[_*s+E]+c.forces[E*s+_])/2;f[_*s+_]+=e.rotors[_]}let d=e.chain.slice();for(let _ of t.modes.dry)d[_]=0;let p=r.slopes("elastic.slopes",d,{q:i,v:o,base:l},{q:a},s),y=r.slopes("elastic.slopes",d,{q:i,v:o,base:l},{v:a},s).slopes.forces,g=zM(r,t,e,i,h.wrenches),m=_=>_.map((E,S)=>_[S%s*s+Math.floor(S/s)]),x=m(p.slopes.forces),w=Nc(r,e,{q:i,v:o,a:o,base:pn(t.modes.weight),wrenches:h.wrenches},1);return{mass:f,elastic:x,residual:w.map((_,E)=>_+p.values.forces[E]),damping:m(y).map((_,E)=>_+h.damping[E]),stiffness:x.map((_,E)=>_+g[E]+h.stiffness[E])}}function Sy(r,t,e,n,i){let{free:s}=t.modes,[o,a,l]=[i.slice(),i.length,s.length],[c,u]=[1/0,!l];for(let h=0;h<kM;h+=1){let f=BM(r,t,e,n,o);if(u)return{rest:o,linear:f};let d=Float64Array.from({length:l*l},(g,m)=>f.stiffness[s[Math.floor(m/l)]*a+s[m%l]]),p=Float64Array.from(s,g=>f.residual[g]);if(!Pc(d,p))return null;let y=Sd(o,s,p);if(!Number.isFinite(y))return null;u=Ad(y,c),c=y}return null}function zM(r,t,e,n,i){let s=n.length,o=[Ya,-Ya,2*Ya,-2*Ya],a=new Float64Array(o.length*s*s);o.forEach((h,f)=>{for(let d=0;d<s;d+=1)a.set(n,(f*s+d)*s),a[(f*s+d)*s+d]+=h});let l=new Float64Array(s),c=Nc(r,e,{q:a,v:l,a:l,base:pn(t.modes.weight),wrenches:i},o.length*s),u=(h,f,d)=>c[(h*s+d)*s+f];return Float64Array.from({length:s*s},(h,f)=>{let[d,p]=[Math.floor(f/s),f%s];return(8*(u(0,d,p)-u(1,d,p))-(u(2,d,p)-u(3,d,p)))/(12*Ya)})}function yi(r,t,e){let n=r.length/t,i=new Float64Array(n*e.length);for(let s=0;s<n;s+=1)for(let o=0;o<e.length;o+=1)i[s*e.length+o]=r[s*t+e[o]];return i}function or(r,t){return Array.from({length:t-r},(e,n)=>r+n)}function Yr(r,t,e){let n=new Float64Array(e.length*t);for(let i=0;i<e.length;i+=1)for(let s=0;s<t;s+=1)n[i*t+s]=r[e[i]*t+s];return n}function Dc(r,t){return r.map((e,n)=>e-t[n])}function ys(r,t){let e=new Float64Array(r.length/t);for(let n=0;n<e.length;n+=1){let i=0;for(let s=0;s<t;s+=1)i+=r[n*t+s]**2;e[n]=Math.sqrt(i)}return e}function Ay(r,t,e,n){let i=r.length/e,s=t.length/e,o=new Float64Array(e),a=0;for(let l=0;l<e;l+=1){let c=0;for(let u=0;u<i;u+=1)c+=r[l*i+u];l===0&&(a=c),o[l]=c-a;for(let u=0;u<s;u+=1)o[l]+=(u<n?-1:1)*t[l*s+u]}return o}function Zs(r){let t=0;for(let e=1;e<r.length;e+=1)Math.abs(r[e])>Math.abs(r[t])&&(t=e);return t}function Ne(r,t,...e){return{data:r,shape:[t,...e]}}var Uc=24;function xs(r,t,e){let[n,i]=r.matrix.shape,s=new Float64Array(e*n);for(let o=0;o<e;o+=1)for(let a=0;a<n;a+=1){let l=r.constant.data[a];for(let c=0;c<i;c+=1)l+=r.matrix.data[a*i+c]*t[o*i+c];s[o*n+a]=l}return s}function Ey(r,t,{pose:e,surface:n},i,s,o,a){let l=x=>Yr(i[x].data,i[x].shape.slice(1).reduce((w,_)=>w*_,1),o),c=o.length,u=Oc(r,t,e,l("q"),c),h=x=>Oc(r,t,e,x,c).line,f=x=>h(xs(t.straight,x,c)),d=f(l("q")),p=x=>({data:l(x),shape:[c,...i[x].shape.slice(1)]}),y="q_reference"in i,g=u.line.shape.slice(0,3),m=u.line.data.map((x,w)=>x-d.data[w]);return{times:{data:Yr(s,1,o),shape:[c]},line:u.line,rigid:d,roots:u.roots,reference:y?h(l("q_reference")):null,referenceRigid:y?f(l("q_reference")):null,colours:[...a,{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:ys(m,3),shape:g}}],tip:p("tip"),tipReference:y?p("tip_reference"):null,contact:t.contactPoint<0?null:{force:p("contact_force"),at:GM(t,i,o),surface:VM(t,n)}}}function VM({surface:r},t){let e=[t[0],t[1],t[2]];return r?.kind==="plane"?{...r,position:e}:r?{...r,center:e,radius:t[3]}:void 0}function GM(r,t,e){let n=t.position.shape[1],i=Yr(t.position.data,3*n,e),s=new Float64Array(3*e.length);for(let o=0;o<e.length;o+=1)for(let a=0;a<3;a+=1)s[3*o+a]=i[3*(o*n+r.contactPoint)+a];return{data:s,shape:[e.length,3]}}function Oc(r,t,e,n,i){let s=new Float64Array(n.length/i),{points:o}=r.sample("pose",e,{q:n,v:s,a:s,base:pn(t.base)},i),[a,l]=[t.links.length,t.stations.data.length],c=o.length/i/Uc,u=new Float64Array(i*a*l*3),h=new Float64Array(i*a*4);for(let f=0;f<i;f+=1)t.links.forEach((d,p)=>{let y=o.subarray((f*c+d.point)*Uc,(f*c+d.point+1)*Uc);h.set(qM(y),(f*a+p)*4),f&&HM(h,(f*a+p)*4,4*a);for(let g=0;g<l;g+=1){let m=((f*a+p)*l+g)*3,x=(f*c+d.point+g)*Uc+9;for(let w=0;w<3;w+=1)u[m+w]=d.bends?o[x+w]:WM(y,pn(d.end),w,t.stations.data[g])}});return{line:{data:u,shape:[i,a,l,3]},roots:{data:h,shape:[i,a,4]}}}function HM(r,t,e){let n=0;for(let i=t;i<t+4;i+=1)n+=r[i]*r[i-e];if(n<0)for(let i=t;i<t+4;i+=1)r[i]*=-1}function WM(r,t,e,n){return r[9+e]+n*(r[3*e]*t[0]+r[3*e+1]*t[1]+r[3*e+2]*t[2])}function qM(r){let t=r[0]+r[4]+r[8];if(t>0){let n=2*Math.sqrt(1+t);return[(r[7]-r[5])/n,(r[2]-r[6])/n,(r[3]-r[1])/n,n/4]}if(r[0]>r[4]&&r[0]>r[8]){let n=2*Math.sqrt(1+r[0]-r[4]-r[8]);return[n/4,(r[1]+r[3])/n,(r[2]+r[6])/n,(r[7]-r[5])/n]}if(r[4]>r[8]){let n=2*Math.sqrt(1+r[4]-r[0]-r[8]);return[(r[1]+r[3])/n,n/4,(r[5]+r[7])/n,(r[2]-r[6])/n]}let e=2*Math.sqrt(1+r[8]-r[0]-r[4]);return[(r[2]+r[6])/e,(r[5]+r[7])/e,e/4,(r[3]-r[1])/e]}var XM=Object.prototype.toString;function Bn(r){let t=XM.call(r);return t.endsWith("Array]")&&!t.includes("Big")}function Td(r,t={}){if(!Bn(r))throw new TypeError("input must be an array");if(r.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=r.length}=t;if(e<0||e>=r.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>r.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let i=r[e];for(let s=e+1;s<n;s++)r[s]>i&&(i=r[s]);return i}function Rd(r,t={}){if(!Bn(r))throw new TypeError("input must be an array");if(r.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=r.length}=t;if(e<0||e>=r.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>r.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let i=r[e];for(let s=e+1;s<n;s++)r[s]<i&&(i=r[s]);return i}function kc(r,t={}){if(Bn(r)){if(r.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let e;if(t.output!==void 0){if(!Bn(t.output))throw new TypeError("output option must be an array if specified");e=t.output}else e=new Array(r.length);let n=Rd(r),i=Td(r);if(n===i)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:s=t.autoMinMax?n:0,max:o=t.autoMinMax?i:1}=t;if(s>=o)throw new RangeError("min option must be smaller than max option");let a=(o-s)/(i-n);for(let l=0;l<r.length;l++)e[l]=(r[l]-n)*a+s;return e}var Bc=" ".repeat(2),Ry=" ".repeat(4);function Cy(){return Cd(this)}function Cd(r,t={}){let{maxRows:e=15,maxColumns:n=10,maxNumSize:i=8,padMinus:s="auto"}=t;return`${r.constructor.name} {
${Bc}[
${Ry}${$M(r,e,n,i,s)}
${Bc}]
${Bc}rows: ${r.rows}
${Bc}columns: ${r.columns}
}`}function $M(r,t,e,n,i){let{rows:s,columns:o}=r,a=Math.min(s,t),l=Math.min(o,e),c=[];if(i==="auto"){i=!1;t:for(let u=0;u<a;u++)for(let h=0;h<l;h++)if(r.get(u,h)<0){i=!0;break t}}for(let u=0;u<a;u++){let h=[];for(let f=0;f<l;f++)h.push(YM(r.get(u,f),n,i));c.push(`${h.join(" ")}`)}return l!==o&&(c[c.length-1]+=` ... ${o-e} more columns`),a!==s&&c.push(`... ${s-t} more rows`),c.join(`
${Ry}`)}function YM(r,t,e){return(r>=0&&e?` ${Ty(r,t-1)}`:Ty(r,t)).padEnd(t)}function Ty(r,t){let e=r.toString();if(e.length<=t)return e;let n=r.toFixed(t);if(n.length>t&&(n=r.toFixed(Math.max(0,t-(n.length-t)))),n.length<=t&&!n.startsWith("0.000")&&!n.startsWith("-0.000"))return n;let i=r.toExponential(t);return i.length>t&&(i=r.toExponential(Math.max(0,t-(i.length-t)))),i.slice(0)}function Py(r,t){r.prototype.add=function(n){return typeof n=="number"?this.addS(n):this.addM(n)},r.prototype.addS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)+n);return this},r.prototype.addM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)+n.get(i,s));return this},r.add=function(n,i){return new t(n).add(i)},r.prototype.sub=function(n){return typeof n=="number"?this.subS(n):this.subM(n)},r.prototype.subS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)-n);return this},r.prototype.subM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)-n.get(i,s));return this},r.sub=function(n,i){return new t(n).sub(i)},r.prototype.subtract=r.prototype.sub,r.prototype.subtractS=r.prototype.subS,r.prototype.subtractM=r.prototype.subM,r.subtract=r.sub,r.prototype.mul=function(n){return typeof n=="number"?this.mulS(n):this.mulM(n)},r.prototype.mulS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)*n);return this},r.prototype.mulM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)*n.get(i,s));return this},r.mul=function(n,i){return new t(n).mul(i)},r.prototype.multiply=r.prototype.mul,r.prototype.multiplyS=r.prototype.mulS,r.prototype.multiplyM=r.prototype.mulM,r.multiply=r.mul,r.prototype.div=function(n){return typeof n=="number"?this.divS(n):this.divM(n)},r.prototype.divS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)/n);return this},r.prototype.divM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)/n.get(i,s));return this},r.div=function(n,i){return new t(n).div(i)},r.prototype.divide=r.prototype.div,r.prototype.divideS=r.prototype.divS,r.prototype.divideM=r.prototype.divM,r.divide=r.div,r.prototype.mod=function(n){return typeof n=="number"?this.modS(n):this.modM(n)},r.prototype.modS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)%n);return this},r.prototype.modM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)%n.get(i,s));return this},r.mod=function(n,i){return new t(n).mod(i)},r.prototype.modulus=r.prototype.mod,r.prototype.modulusS=r.prototype.modS,r.prototype.modulusM=r.prototype.modM,r.modulus=r.mod,r.prototype.and=function(n){return typeof n=="number"?this.andS(n):this.andM(n)},r.prototype.andS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)&n);return this},r.prototype.andM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)&n.get(i,s));return this},r.and=function(n,i){return new t(n).and(i)},r.prototype.or=function(n){return typeof n=="number"?this.orS(n):this.orM(n)},r.prototype.orS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)|n);return this},r.prototype.orM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)|n.get(i,s));return this},r.or=function(n,i){return new t(n).or(i)},r.prototype.xor=function(n){return typeof n=="number"?this.xorS(n):this.xorM(n)},r.prototype.xorS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)^n);return this},r.prototype.xorM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)^n.get(i,s));return this},r.xor=function(n,i){return new t(n).xor(i)},r.prototype.leftShift=function(n){return typeof n=="number"?this.leftShiftS(n):this.leftShiftM(n)},r.prototype.leftShiftS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)<<n);return this},r.prototype.leftShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)<<n.get(i,s));return this},r.leftShift=function(n,i){return new t(n).leftShift(i)},r.prototype.signPropagatingRightShift=function(n){return typeof n=="number"?this.signPropagatingRightShiftS(n):this.signPropagatingRightShiftM(n)},r.prototype.signPropagatingRightShiftS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)>>n);return this},r.prototype.signPropagatingRightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)>>n.get(i,s));return this},r.signPropagatingRightShift=function(n,i){return new t(n).signPropagatingRightShift(i)},r.prototype.rightShift=function(n){return typeof n=="number"?this.rightShiftS(n):this.rightShiftM(n)},r.prototype.rightShiftS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)>>>n);return this},r.prototype.rightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)>>>n.get(i,s));return this},r.rightShift=function(n,i){return new t(n).rightShift(i)},r.prototype.zeroFillRightShift=r.prototype.rightShift,r.prototype.zeroFillRightShiftS=r.prototype.rightShiftS,r.prototype.zeroFillRightShiftM=r.prototype.rightShiftM,r.zeroFillRightShift=r.rightShift,r.prototype.not=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,~this.get(n,i));return this},r.not=function(n){return new t(n).not()},r.prototype.abs=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.abs(this.get(n,i)));return this},r.abs=function(n){return new t(n).abs()},r.prototype.acos=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.acos(this.get(n,i)));return this},r.acos=function(n){return new t(n).acos()},r.prototype.acosh=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.acosh(this.get(n,i)));return this},r.acosh=function(n){return new t(n).acosh()},r.prototype.asin=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.asin(this.get(n,i)));return this},r.asin=function(n){return new t(n).asin()},r.prototype.asinh=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.asinh(this.get(n,i)));return this},r.asinh=function(n){return new t(n).asinh()},r.prototype.atan=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.atan(this.get(n,i)));return this},r.atan=function(n){return new t(n).atan()},r.prototype.atanh=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.atanh(this.get(n,i)));return this},r.atanh=function(n){return new t(n).atanh()},r.prototype.cbrt=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.cbrt(this.get(n,i)));return this},r.cbrt=function(n){return new t(n).cbrt()},r.prototype.ceil=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.ceil(this.get(n,i)));return this},r.ceil=function(n){return new t(n).ceil()},r.prototype.clz32=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.clz32(this.get(n,i)));return this},r.clz32=function(n){return new t(n).clz32()},r.prototype.cos=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.cos(this.get(n,i)));return this},r.cos=function(n){return new t(n).cos()},r.prototype.cosh=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.cosh(this.get(n,i)));return this},r.cosh=function(n){return new t(n).cosh()},r.prototype.exp=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.exp(this.get(n,i)));return this},r.exp=function(n){return new t(n).exp()},r.prototype.expm1=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.expm1(this.get(n,i)));return this},r.expm1=function(n){return new t(n).expm1()},r.prototype.floor=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.floor(this.get(n,i)));return this},r.floor=function(n){return new t(n).floor()},r.prototype.fround=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.fround(this.get(n,i)));return this},r.fround=function(n){return new t(n).fround()},r.prototype.log=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.log(this.get(n,i)));return this},r.log=function(n){return new t(n).log()},r.prototype.log1p=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.log1p(this.get(n,i)));return this},r.log1p=function(n){return new t(n).log1p()},r.prototype.log10=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.log10(this.get(n,i)));return this},r.log10=function(n){return new t(n).log10()},r.prototype.log2=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.log2(this.get(n,i)));return this},r.log2=function(n){return new t(n).log2()},r.prototype.round=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.round(this.get(n,i)));return this},r.round=function(n){return new t(n).round()},r.prototype.sign=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.sign(this.get(n,i)));return this},r.sign=function(n){return new t(n).sign()},r.prototype.sin=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.sin(this.get(n,i)));return this},r.sin=function(n){return new t(n).sin()},r.prototype.sinh=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.sinh(this.get(n,i)));return this},r.sinh=function(n){return new t(n).sinh()},r.prototype.sqrt=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.sqrt(this.get(n,i)));return this},r.sqrt=function(n){return new t(n).sqrt()},r.prototype.tan=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.tan(this.get(n,i)));return this},r.tan=function(n){return new t(n).tan()},r.prototype.tanh=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.tanh(this.get(n,i)));return this},r.tanh=function(n){return new t(n).tanh()},r.prototype.trunc=function(){for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.set(n,i,Math.trunc(this.get(n,i)));return this},r.trunc=function(n){return new t(n).trunc()},r.pow=function(n,i){return new t(n).pow(i)},r.prototype.pow=function(n){return typeof n=="number"?this.powS(n):this.powM(n)},r.prototype.powS=function(n){for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)**n);return this},r.prototype.powM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let i=0;i<this.rows;i++)for(let s=0;s<this.columns;s++)this.set(i,s,this.get(i,s)**n.get(i,s));return this}}function qi(r,t,e){let n=e?r.rows:r.rows-1;if(t<0||t>n)throw new RangeError("Row index out of range")}function Xi(r,t,e){let n=e?r.columns:r.columns-1;if(t<0||t>n)throw new RangeError("Column index out of range")}function Ks(r,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==r.columns)throw new RangeError("vector size must be the same as the number of columns");return t}function Js(r,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==r.rows)throw new RangeError("vector size must be the same as the number of rows");return t}function Iy(r,t){if(!Bn(t))throw new TypeError("row indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=r.rows)throw new RangeError("row indices are out of range")}function Ly(r,t){if(!Bn(t))throw new TypeError("column indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=r.columns)throw new RangeError("column indices are out of range")}function Pd(r,t,e,n,i){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(zc("startRow",t),zc("endRow",e),zc("startColumn",n),zc("endColumn",i),t>e||n>i||t<0||t>=r.rows||e<0||e>=r.rows||n<0||n>=r.columns||i<0||i>=r.columns)throw new RangeError("Submatrix indices are out of range")}function ja(r,t=0){let e=[];for(let n=0;n<r;n++)e.push(t);return e}function zc(r,t){if(typeof t!="number")throw new TypeError(`${r} must be a number`)}function Qs(r){if(r.isEmpty())throw new Error("Empty matrix has no elements to index")}function Fy(r){let t=ja(r.rows);for(let e=0;e<r.rows;++e)for(let n=0;n<r.columns;++n)t[e]+=r.get(e,n);return t}function Ny(r){let t=ja(r.columns);for(let e=0;e<r.rows;++e)for(let n=0;n<r.columns;++n)t[n]+=r.get(e,n);return t}function Dy(r){let t=0;for(let e=0;e<r.rows;e++)for(let n=0;n<r.columns;n++)t+=r.get(e,n);return t}function Uy(r){let t=ja(r.rows,1);for(let e=0;e<r.rows;++e)for(let n=0;n<r.columns;++n)t[e]*=r.get(e,n);return t}function Oy(r){let t=ja(r.columns,1);for(let e=0;e<r.rows;++e)for(let n=0;n<r.columns;++n)t[n]*=r.get(e,n);return t}function ky(r){let t=1;for(let e=0;e<r.rows;e++)for(let n=0;n<r.columns;n++)t*=r.get(e,n);return t}function By(r,t,e){let n=r.rows,i=r.columns,s=[];for(let o=0;o<n;o++){let a=0,l=0,c=0;for(let u=0;u<i;u++)c=r.get(o,u)-e[o],a+=c,l+=c*c;t?s.push((l-a*a/i)/(i-1)):s.push((l-a*a/i)/i)}return s}function zy(r,t,e){let n=r.rows,i=r.columns,s=[];for(let o=0;o<i;o++){let a=0,l=0,c=0;for(let u=0;u<n;u++)c=r.get(u,o)-e[o],a+=c,l+=c*c;t?s.push((l-a*a/n)/(n-1)):s.push((l-a*a/n)/n)}return s}function Vy(r,t,e){let n=r.rows,i=r.columns,s=n*i,o=0,a=0,l=0;for(let c=0;c<n;c++)for(let u=0;u<i;u++)l=r.get(c,u)-e,o+=l,a+=l*l;return t?(a-o*o/s)/(s-1):(a-o*o/s)/s}function Gy(r,t){for(let e=0;e<r.rows;e++)for(let n=0;n<r.columns;n++)r.set(e,n,r.get(e,n)-t[e])}function Hy(r,t){for(let e=0;e<r.rows;e++)for(let n=0;n<r.columns;n++)r.set(e,n,r.get(e,n)-t[n])}function Wy(r,t){for(let e=0;e<r.rows;e++)for(let n=0;n<r.columns;n++)r.set(e,n,r.get(e,n)-t)}function qy(r){let t=[];for(let e=0;e<r.rows;e++){let n=0;for(let i=0;i<r.columns;i++)n+=r.get(e,i)**2/(r.columns-1);t.push(Math.sqrt(n))}return t}function Xy(r,t){for(let e=0;e<r.rows;e++)for(let n=0;n<r.columns;n++)r.set(e,n,r.get(e,n)/t[e])}function $y(r){let t=[];for(let e=0;e<r.columns;e++){let n=0;for(let i=0;i<r.rows;i++)n+=r.get(i,e)**2/(r.rows-1);t.push(Math.sqrt(n))}return t}function Yy(r,t){for(let e=0;e<r.rows;e++)for(let n=0;n<r.columns;n++)r.set(e,n,r.get(e,n)/t[n])}function jy(r){let t=r.size-1,e=0;for(let n=0;n<r.columns;n++)for(let i=0;i<r.rows;i++)e+=r.get(i,n)**2/t;return Math.sqrt(e)}function Zy(r,t){for(let e=0;e<r.rows;e++)for(let n=0;n<r.columns;n++)r.set(e,n,r.get(e,n)/t)}var nn=class r{static from1DArray(t,e,n){if(t*e!==n.length)throw new RangeError("data length does not match given dimensions");let s=new $t(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)s.set(o,a,n[o*e+a]);return s}static rowVector(t){let e=new $t(1,t.length);for(let n=0;n<t.length;n++)e.set(0,n,t[n]);return e}static columnVector(t){let e=new $t(t.length,1);for(let n=0;n<t.length;n++)e.set(n,0,t[n]);return e}static zeros(t,e){return new $t(t,e)}static ones(t,e){return new $t(t,e).fill(1)}static rand(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{random:i=Math.random}=n,s=new $t(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)s.set(o,a,i());return s}static randInt(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{min:i=0,max:s=1e3,random:o=Math.random}=n;if(!Number.isInteger(i))throw new TypeError("min must be an integer");if(!Number.isInteger(s))throw new TypeError("max must be an integer");if(i>=s)throw new RangeError("min must be smaller than max");let a=s-i,l=new $t(t,e);for(let c=0;c<t;c++)for(let u=0;u<e;u++){let h=i+Math.round(o()*a);l.set(c,u,h)}return l}static eye(t,e,n){e===void 0&&(e=t),n===void 0&&(n=1);let i=Math.min(t,e),s=this.zeros(t,e);for(let o=0;o<i;o++)s.set(o,o,n);return s}static diag(t,e,n){let i=t.length;e===void 0&&(e=i),n===void 0&&(n=e);let s=Math.min(i,e,n),o=this.zeros(e,n);for(let a=0;a<s;a++)o.set(a,a,t[a]);return o}static min(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,i=t.columns,s=new $t(n,i);for(let o=0;o<n;o++)for(let a=0;a<i;a++)s.set(o,a,Math.min(t.get(o,a),e.get(o,a)));return s}static max(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,i=t.columns,s=new this(n,i);for(let o=0;o<n;o++)for(let a=0;a<i;a++)s.set(o,a,Math.max(t.get(o,a),e.get(o,a)));return s}static checkMatrix(t){return r.isMatrix(t)?t:new $t(t)}static isMatrix(t){return t!=null&&t.klass==="Matrix"}get size(){return this.rows*this.columns}apply(t){if(typeof t!="function")throw new TypeError("callback must be a function");for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.call(this,e,n);return this}applyAlongAxis(t,e){if(typeof t!="function")throw new TypeError("callback must be a function");let n=[];switch(e){case"row":{for(let i=0;i<this.rows;i++)n.push(t.call(this,this.getRow(i),i));break}case"column":{for(let i=0;i<this.columns;i++)n.push(t.call(this,this.getColumn(i),i));break}default:throw new Error(`invalid option: ${e}`)}return n}to1DArray(){let t=[];for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.push(this.get(e,n));return t}to2DArray(){let t=[];for(let e=0;e<this.rows;e++){t.push([]);for(let n=0;n<this.columns;n++)t[e].push(this.get(e,n))}return t}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let t=0;t<this.rows;t++)for(let e=0;e<=t;e++)if(this.get(t,e)!==this.get(e,t))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let t=0;t<this.rows;t++)if(this.get(t,t)!==0)return!1;return!0}isEchelonForm(){let t=0,e=0,n=-1,i=!0,s=!1;for(;t<this.rows&&i;){for(e=0,s=!1;e<this.columns&&s===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(s=!0,n=e):(i=!1,s=!0);t++}return i}isReducedEchelonForm(){let t=0,e=0,n=-1,i=!0,s=!1;for(;t<this.rows&&i;){for(e=0,s=!1;e<this.columns&&s===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(s=!0,n=e):(i=!1,s=!0);for(let o=e+1;o<this.rows;o++)this.get(t,o)!==0&&(i=!1);t++}return i}echelonForm(){let t=this.clone(),e=0,n=0;for(;e<t.rows&&n<t.columns;){let i=e;for(let s=e;s<t.rows;s++)t.get(s,n)>t.get(i,n)&&(i=s);if(t.get(i,n)===0)n++;else{t.swapRows(e,i);let s=t.get(e,n);for(let o=n;o<t.columns;o++)t.set(e,o,t.get(e,o)/s);for(let o=e+1;o<t.rows;o++){let a=t.get(o,n)/t.get(e,n);t.set(o,n,0);for(let l=n+1;l<t.columns;l++)t.set(o,l,t.get(o,l)-t.get(e,l)*a)}e++,n++}}return t}reducedEchelonForm(){let t=this.echelonForm(),e=t.columns,n=t.rows,i=n-1;for(;i>=0;)if(t.maxRow(i)===0)i--;else{let s=0,o=!1;for(;s<n&&o===!1;)t.get(i,s)===1?o=!0:s++;for(let a=0;a<i;a++){let l=t.get(a,s);for(let c=s;c<e;c++){let u=t.get(a,c)-l*t.get(i,c);t.set(a,c,u)}}i--}return t}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{rows:e=1,columns:n=1}=t;if(!Number.isInteger(e)||e<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(n)||n<=0)throw new TypeError("columns must be a positive integer");let i=new $t(this.rows*e,this.columns*n);for(let s=0;s<e;s++)for(let o=0;o<n;o++)i.setSubMatrix(this,this.rows*s,this.columns*o);return i}fill(t){for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,t);return this}neg(){return this.mulS(-1)}getRow(t){qi(this,t);let e=[];for(let n=0;n<this.columns;n++)e.push(this.get(t,n));return e}getRowVector(t){return $t.rowVector(this.getRow(t))}setRow(t,e){qi(this,t),e=Ks(this,e);for(let n=0;n<this.columns;n++)this.set(t,n,e[n]);return this}swapRows(t,e){qi(this,t),qi(this,e);for(let n=0;n<this.columns;n++){let i=this.get(t,n);this.set(t,n,this.get(e,n)),this.set(e,n,i)}return this}getColumn(t){Xi(this,t);let e=[];for(let n=0;n<this.rows;n++)e.push(this.get(n,t));return e}getColumnVector(t){return $t.columnVector(this.getColumn(t))}setColumn(t,e){Xi(this,t),e=Js(this,e);for(let n=0;n<this.rows;n++)this.set(n,t,e[n]);return this}swapColumns(t,e){Xi(this,t),Xi(this,e);for(let n=0;n<this.rows;n++){let i=this.get(n,t);this.set(n,t,this.get(n,e)),this.set(n,e,i)}return this}addRowVector(t){t=Ks(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[n]);return this}subRowVector(t){t=Ks(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[n]);return this}mulRowVector(t){t=Ks(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[n]);return this}divRowVector(t){t=Ks(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[n]);return this}addColumnVector(t){t=Js(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[e]);return this}subColumnVector(t){t=Js(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[e]);return this}mulColumnVector(t){t=Js(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[e]);return this}divColumnVector(t){t=Js(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[e]);return this}mulRow(t,e){qi(this,t);for(let n=0;n<this.columns;n++)this.set(t,n,this.get(t,n)*e);return this}mulColumn(t,e){Xi(this,t);for(let n=0;n<this.rows;n++)this.set(n,t,this.get(n,t)*e);return this}max(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.get(n,i)>e[n]&&(e[n]=this.get(n,i));return e}case"column":{let e=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.get(n,i)>e[i]&&(e[i]=this.get(n,i));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.get(n,i)>e&&(e=this.get(n,i));return e}default:throw new Error(`invalid option: ${t}`)}}maxIndex(){Qs(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.get(n,i)>t&&(t=this.get(n,i),e[0]=n,e[1]=i);return e}min(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.get(n,i)<e[n]&&(e[n]=this.get(n,i));return e}case"column":{let e=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.get(n,i)<e[i]&&(e[i]=this.get(n,i));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.get(n,i)<e&&(e=this.get(n,i));return e}default:throw new Error(`invalid option: ${t}`)}}minIndex(){Qs(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let i=0;i<this.columns;i++)this.get(n,i)<t&&(t=this.get(n,i),e[0]=n,e[1]=i);return e}maxRow(t){if(qi(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)>e&&(e=this.get(t,n));return e}maxRowIndex(t){qi(this,t),Qs(this);let e=this.get(t,0),n=[t,0];for(let i=1;i<this.columns;i++)this.get(t,i)>e&&(e=this.get(t,i),n[1]=i);return n}minRow(t){if(qi(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)<e&&(e=this.get(t,n));return e}minRowIndex(t){qi(this,t),Qs(this);let e=this.get(t,0),n=[t,0];for(let i=1;i<this.columns;i++)this.get(t,i)<e&&(e=this.get(t,i),n[1]=i);return n}maxColumn(t){if(Xi(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)>e&&(e=this.get(n,t));return e}maxColumnIndex(t){Xi(this,t),Qs(this);let e=this.get(0,t),n=[0,t];for(let i=1;i<this.rows;i++)this.get(i,t)>e&&(e=this.get(i,t),n[0]=i);return n}minColumn(t){if(Xi(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)<e&&(e=this.get(n,t));return e}minColumnIndex(t){Xi(this,t),Qs(this);let e=this.get(0,t),n=[0,t];for(let i=1;i<this.rows;i++)this.get(i,t)<e&&(e=this.get(i,t),n[0]=i);return n}diag(){let t=Math.min(this.rows,this.columns),e=[];for(let n=0;n<t;n++)e.push(this.get(n,n));return e}norm(t="frobenius"){switch(t){case"max":return $t.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${t}`)}}cumulativeSum(){let t=0;for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t+=this.get(e,n),this.set(e,n,t);return this}dot(t){r.isMatrix(t)&&(t=t.to1DArray());let e=this.to1DArray();if(e.length!==t.length)throw new RangeError("vectors do not have the same size");let n=0;for(let i=0;i<e.length;i++)n+=e[i]*t[i];return n}mmul(t){t=$t.checkMatrix(t);let e=this.rows,n=this.columns,i=t.columns,s=new $t(e,i),o=new Float64Array(n);for(let a=0;a<i;a++){for(let l=0;l<n;l++)o[l]=t.get(l,a);for(let l=0;l<e;l++){let c=0;for(let u=0;u<n;u++)c+=this.get(l,u)*o[u];s.set(l,a,c)}}return s}gram(){let t=this.rows,e=this.columns,n=new Float64Array(e*e);for(let s=0;s<t;s++)for(let o=0;o<e;o++){let a=this.get(s,o);if(a===0)continue;let l=o*e;for(let c=o;c<e;c++)n[l+c]+=a*this.get(s,c)}let i=new $t(e,e);for(let s=0;s<e;s++){let o=s*e;for(let a=s;a<e;a++){let l=n[o+a];i.set(s,a,l),i.set(a,s,l)}}return i}transposeMultiply(t){if(t=$t.checkMatrix(t),this.rows!==t.rows)throw new RangeError("the number of rows of the two matrices must be equal");let e=this.columns,n=t.columns,i=new $t(e,n),s=new Float64Array(n);for(let o=0;o<this.rows;o++){for(let a=0;a<n;a++)s[a]=t.get(o,a);for(let a=0;a<e;a++){let l=this.get(o,a);if(l===0)continue;let c=i.data[a];for(let u=0;u<n;u++)c[u]+=l*s[u]}}return i}mmulByTranspose(t){let e=this.rows,n=this.columns;if(t!==void 0&&t.length!==n)throw new RangeError("scale must have one value per column");let i=new $t(e,e),s=new Float64Array(n);for(let o=0;o<e;o++){if(t===void 0)for(let a=0;a<n;a++)s[a]=this.get(o,a);else for(let a=0;a<n;a++)s[a]=t[a]*this.get(o,a);for(let a=o;a<e;a++){let l=0;for(let c=0;c<n;c++)l+=this.get(a,c)*s[c];i.set(a,o,l),i.set(o,a,l)}}return i}mpow(t){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(t)||t<0)throw new RangeError("Exponent must be a non-negative integer");let e=$t.eye(this.rows),n=this;for(let i=t;i>=1;i/=2)(i&1)!==0&&(e=e.mmul(n)),n=n.mmul(n);return e}strassen2x2(t){t=$t.checkMatrix(t);let e=new $t(2,2),n=this.get(0,0),i=t.get(0,0),s=this.get(0,1),o=t.get(0,1),a=this.get(1,0),l=t.get(1,0),c=this.get(1,1),u=t.get(1,1),h=(n+c)*(i+u),f=(a+c)*i,d=n*(o-u),p=c*(l-i),y=(n+s)*u,g=(a-n)*(i+o),m=(s-c)*(l+u),x=h+p-y+m,w=d+y,_=f+p,E=h-f+d+g;return e.set(0,0,x),e.set(0,1,w),e.set(1,0,_),e.set(1,1,E),e}strassen3x3(t){t=$t.checkMatrix(t);let e=new $t(3,3),n=this.get(0,0),i=this.get(0,1),s=this.get(0,2),o=this.get(1,0),a=this.get(1,1),l=this.get(1,2),c=this.get(2,0),u=this.get(2,1),h=this.get(2,2),f=t.get(0,0),d=t.get(0,1),p=t.get(0,2),y=t.get(1,0),g=t.get(1,1),m=t.get(1,2),x=t.get(2,0),w=t.get(2,1),_=t.get(2,2),E=(n+i+s-o-a-u-h)*g,S=(n-o)*(-d+g),v=a*(-f+d+y-g-m-x+_),b=(-n+o+a)*(f-d+g),N=(o+a)*(-f+d),C=n*f,I=(-n+c+u)*(f-p+m),U=(-n+c)*(p-m),B=(c+u)*(-f+p),F=(n+i+s-a-l-c-u)*m,V=u*(-f+p+y-g-m-x+w),q=(-s+u+h)*(g+x-w),G=(s-h)*(g-w),rt=s*x,$=(u+h)*(-x+w),j=(-s+a+l)*(m+x-_),tt=(s-l)*(m-_),ut=(a+l)*(-x+_),ct=i*y,J=l*w,gt=o*p,yt=c*d,Mt=h*_,xt=C+rt+ct,zt=E+b+N+C+q+rt+$,te=C+I+B+F+rt+j+ut,dt=S+v+b+C+rt+j+tt,Wt=S+b+N+C+J,qt=rt+j+tt+ut+gt,Yt=C+I+U+V+q+G+rt,ve=q+G+rt+$+yt,Ue=C+I+U+B+Mt;return e.set(0,0,xt),e.set(0,1,zt),e.set(0,2,te),e.set(1,0,dt),e.set(1,1,Wt),e.set(1,2,qt),e.set(2,0,Yt),e.set(2,1,ve),e.set(2,2,Ue),e}mmulStrassen(t){t=$t.checkMatrix(t);let e=this.clone(),n=e.rows,i=e.columns,s=t.rows,o=t.columns;i!==s&&console.warn(`Multiplying ${n} x ${i} and ${s} x ${o} matrix: dimensions do not match.`);function a(h,f,d){let p=h.rows,y=h.columns;if(p===f&&y===d)return h;{let g=r.zeros(f,d);return g=g.setSubMatrix(h,0,0),g}}let l=Math.max(n,s),c=Math.max(i,o);e=a(e,l,c),t=a(t,l,c);function u(h,f,d,p){if(d<=512||p<=512)return h.mmul(f);d%2===1&&p%2===1?(h=a(h,d+1,p+1),f=a(f,d+1,p+1)):d%2===1?(h=a(h,d+1,p),f=a(f,d+1,p)):p%2===1&&(h=a(h,d,p+1),f=a(f,d,p+1));let y=parseInt(h.rows/2,10),g=parseInt(h.columns/2,10),m=h.subMatrix(0,y-1,0,g-1),x=f.subMatrix(0,y-1,0,g-1),w=h.subMatrix(0,y-1,g,h.columns-1),_=f.subMatrix(0,y-1,g,f.columns-1),E=h.subMatrix(y,h.rows-1,0,g-1),S=f.subMatrix(y,f.rows-1,0,g-1),v=h.subMatrix(y,h.rows-1,g,h.columns-1),b=f.subMatrix(y,f.rows-1,g,f.columns-1),N=u(r.add(m,v),r.add(x,b),y,g),C=u(r.add(E,v),x,y,g),I=u(m,r.sub(_,b),y,g),U=u(v,r.sub(S,x),y,g),B=u(r.add(m,w),b,y,g),F=u(r.sub(E,m),r.add(x,_),y,g),V=u(r.sub(w,v),r.add(S,b),y,g),q=r.add(N,U);q.sub(B),q.add(V);let G=r.add(I,B),rt=r.add(C,U),$=r.sub(N,C);$.add(I),$.add(F);let j=r.zeros(2*q.rows,2*q.columns);return j=j.setSubMatrix(q,0,0),j=j.setSubMatrix(G,q.rows,0),j=j.setSubMatrix(rt,0,q.columns),j=j.setSubMatrix($,q.rows,q.columns),j.subMatrix(0,d-1,0,p-1)}return u(e,t,l,c)}scaleRows(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let i=new $t(this.rows,this.columns);for(let s=0;s<this.rows;s++){let o=this.getRow(s);o.length>0&&kc(o,{min:e,max:n,output:o}),i.setRow(s,o)}return i}scaleColumns(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let i=new $t(this.rows,this.columns);for(let s=0;s<this.columns;s++){let o=this.getColumn(s);o.length&&kc(o,{min:e,max:n,output:o}),i.setColumn(s,o)}return i}flipRows(){let t=Math.ceil(this.columns/2);for(let e=0;e<this.rows;e++)for(let n=0;n<t;n++){let i=this.get(e,n),s=this.get(e,this.columns-1-n);this.set(e,n,s),this.set(e,this.columns-1-n,i)}return this}flipColumns(){let t=Math.ceil(this.rows/2);for(let e=0;e<this.columns;e++)for(let n=0;n<t;n++){let i=this.get(n,e),s=this.get(this.rows-1-n,e);this.set(n,e,s),this.set(this.rows-1-n,e,i)}return this}kroneckerProduct(t){t=$t.checkMatrix(t);let e=this.rows,n=this.columns,i=t.rows,s=t.columns,o=new $t(e*i,n*s);for(let a=0;a<e;a++)for(let l=0;l<n;l++)for(let c=0;c<i;c++)for(let u=0;u<s;u++)o.set(i*a+c,s*l+u,this.get(a,l)*t.get(c,u));return o}kroneckerSum(t){if(t=$t.checkMatrix(t),!this.isSquare()||!t.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let e=this.rows,n=t.rows,i=this.kroneckerProduct($t.eye(n,n)),s=$t.eye(e,e).kroneckerProduct(t);return i.add(s)}transpose(){let t=new $t(this.columns,this.rows);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.set(n,e,this.get(e,n));return t}sortRows(t=Ky){for(let e=0;e<this.rows;e++)this.setRow(e,this.getRow(e).sort(t));return this}sortColumns(t=Ky){for(let e=0;e<this.columns;e++)this.setColumn(e,this.getColumn(e).sort(t));return this}subMatrix(t,e,n,i){Pd(this,t,e,n,i);let s=new $t(e-t+1,i-n+1);for(let o=t;o<=e;o++)for(let a=n;a<=i;a++)s.set(o-t,a-n,this.get(o,a));return s}subMatrixRow(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.columns-1),e>n||e<0||e>=this.columns||n<0||n>=this.columns)throw new RangeError("Argument out of range");let i=new $t(t.length,n-e+1);for(let s=0;s<t.length;s++)for(let o=e;o<=n;o++){if(t[s]<0||t[s]>=this.rows)throw new RangeError(`Row index out of range: ${t[s]}`);i.set(s,o-e,this.get(t[s],o))}return i}subMatrixColumn(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.rows-1),e>n||e<0||e>=this.rows||n<0||n>=this.rows)throw new RangeError("Argument out of range");let i=new $t(n-e+1,t.length);for(let s=0;s<t.length;s++)for(let o=e;o<=n;o++){if(t[s]<0||t[s]>=this.columns)throw new RangeError(`Column index out of range: ${t[s]}`);i.set(o-e,s,this.get(o,t[s]))}return i}setSubMatrix(t,e,n){if(t=$t.checkMatrix(t),t.isEmpty())return this;let i=e+t.rows-1,s=n+t.columns-1;Pd(this,e,i,n,s);for(let o=0;o<t.rows;o++)for(let a=0;a<t.columns;a++)this.set(e+o,n+a,t.get(o,a));return this}concat(t,e="row"){switch(t=$t.checkMatrix(t),e){case"row":{if(this.columns!==t.columns)throw new RangeError("both matrices must have the same number of columns");let n=new $t(this.rows+t.rows,this.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,this.rows,0),n}case"column":{if(this.rows!==t.rows)throw new RangeError("both matrices must have the same number of rows");let n=new $t(this.rows,this.columns+t.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,0,this.columns),n}default:throw new Error(`invalid option: ${e}`)}}selection(t,e){Iy(this,t),Ly(this,e);let n=new $t(t.length,e.length);for(let i=0;i<t.length;i++){let s=t[i];for(let o=0;o<e.length;o++){let a=e[o];n.set(i,o,this.get(s,a))}}return n}trace(){let t=Math.min(this.rows,this.columns),e=0;for(let n=0;n<t;n++)e+=this.get(n,n);return e}clone(){return this.constructor.copy(this,new $t(this.rows,this.columns))}static copy(t,e){for(let[n,i,s]of t.entries())e.set(n,i,s);return e}sum(t){switch(t){case"row":return Fy(this);case"column":return Ny(this);case void 0:return Dy(this);default:throw new Error(`invalid option: ${t}`)}}product(t){switch(t){case"row":return Uy(this);case"column":return Oy(this);case void 0:return ky(this);default:throw new Error(`invalid option: ${t}`)}}mean(t){let e=this.sum(t);switch(t){case"row":{for(let n=0;n<this.rows;n++)e[n]/=this.columns;return e}case"column":{for(let n=0;n<this.columns;n++)e[n]/=this.rows;return e}case void 0:return e/this.size;default:throw new Error(`invalid option: ${t}`)}}variance(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{unbiased:n=!0,mean:i=this.mean(t)}=e;if(typeof n!="boolean")throw new TypeError("unbiased must be a boolean");switch(t){case"row":{if(!Bn(i))throw new TypeError("mean must be an array");return By(this,n,i)}case"column":{if(!Bn(i))throw new TypeError("mean must be an array");return zy(this,n,i)}case void 0:{if(typeof i!="number")throw new TypeError("mean must be a number");return Vy(this,n,i)}default:throw new Error(`invalid option: ${t}`)}}standardDeviation(t,e){typeof t=="object"&&(e=t,t=void 0);let n=this.variance(t,e);if(t===void 0)return Math.sqrt(n);for(let i=0;i<n.length;i++)n[i]=Math.sqrt(n[i]);return n}center(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{center:n=this.mean(t)}=e;switch(t){case"row":{if(!Bn(n))throw new TypeError("center must be an array");return Gy(this,n),this}case"column":{if(!Bn(n))throw new TypeError("center must be an array");return Hy(this,n),this}case void 0:{if(typeof n!="number")throw new TypeError("center must be a number");return Wy(this,n),this}default:throw new Error(`invalid option: ${t}`)}}scale(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let n=e.scale;switch(t){case"row":{if(n===void 0)n=qy(this);else if(!Bn(n))throw new TypeError("scale must be an array");return Xy(this,n),this}case"column":{if(n===void 0)n=$y(this);else if(!Bn(n))throw new TypeError("scale must be an array");return Yy(this,n),this}case void 0:{if(n===void 0)n=jy(this);else if(typeof n!="number")throw new TypeError("scale must be a number");return Zy(this,n),this}default:throw new Error(`invalid option: ${t}`)}}toString(t){return Cd(this,t)}[Symbol.iterator](){return this.entries()}*entries(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield[t,e,this.get(t,e)]}*values(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield this.get(t,e)}};nn.prototype.klass="Matrix";typeof Symbol<"u"&&(nn.prototype[Symbol.for("nodejs.util.inspect.custom")]=Cy);function Ky(r,t){return r-t}function jM(r){return r.every(t=>typeof t=="number")}nn.random=nn.rand;nn.randomInt=nn.randInt;nn.diagonal=nn.diag;nn.prototype.diagonal=nn.prototype.diag;nn.identity=nn.eye;nn.prototype.negate=nn.prototype.neg;nn.prototype.tensorProduct=nn.prototype.kroneckerProduct;var $t=class r extends nn{data;#t(t,e){if(this.data=[],Number.isInteger(e)&&e>=0)for(let n=0;n<t;n++)this.data.push(new Float64Array(e));else throw new TypeError("nColumns must be a positive integer");this.rows=t,this.columns=e}constructor(t,e){if(super(),r.isMatrix(t))this.#t(t.rows,t.columns),r.copy(t,this);else if(Number.isInteger(t)&&t>=0)this.#t(t,e);else if(Bn(t)){let n=t;if(t=n.length,e=t?n[0].length:0,typeof e!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let i=0;i<t;i++){if(n[i].length!==e)throw new RangeError("Inconsistent array dimensions");if(!jM(n[i]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(n[i]))}this.rows=t,this.columns=e}else throw new TypeError("First argument must be a positive number or an array")}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}removeRow(t){return qi(this,t),this.data.splice(t,1),this.rows-=1,this}addRow(t,e){return e===void 0&&(e=t,t=this.rows),qi(this,t,!0),e=Float64Array.from(Ks(this,e)),this.data.splice(t,0,e),this.rows+=1,this}removeColumn(t){Xi(this,t);for(let e=0;e<this.rows;e++){let n=new Float64Array(this.columns-1);for(let i=0;i<t;i++)n[i]=this.data[e][i];for(let i=t+1;i<this.columns;i++)n[i-1]=this.data[e][i];this.data[e]=n}return this.columns-=1,this}addColumn(t,e){typeof e>"u"&&(e=t,t=this.columns),Xi(this,t,!0),e=Js(this,e);for(let n=0;n<this.rows;n++){let i=new Float64Array(this.columns+1),s=0;for(;s<t;s++)i[s]=this.data[n][s];for(i[s++]=e[n];s<this.columns+1;s++)i[s]=this.data[n][s-1];this.data[n]=i}return this.columns+=1,this}};Py(nn,$t);var Za=class extends nn{constructor(t){super(),this.data=t,this.rows=t.length,this.columns=t[0].length}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}};function Jy(r){let t=r.data,e=r.rows;for(let n=0;n<e;n++){let i=t[n];for(let s=n+1;s<e;s++){let o=i[s];i[s]=t[s][n],t[s][n]=o}}return r}function Id(r,t){let e=0;return Math.abs(r)>Math.abs(t)?(e=t/r,Math.abs(r)*Math.sqrt(1+e*e)):t!==0?(e=r/t,Math.abs(t)*Math.sqrt(1+e*e)):0}var _s=class{constructor(t,e={}){let{assumeSymmetric:n=!1}=e;if(t=Za.checkMatrix(t),!t.isSquare())throw new Error("Matrix is not a square matrix");if(t.isEmpty())throw new Error("Matrix must be non-empty");let i=t.columns,s=new $t(i,i),o=new Float64Array(i),a=new Float64Array(i),l=t,c,u,h=!1;if(n?h=!0:h=t.isSymmetric(),h){for(c=0;c<i;c++)for(u=0;u<i;u++)s.set(u,c,l.get(c,u));ZM(i,a,o,s),KM(i,a,o,s),Jy(s)}else{let f=new $t(i,i),d=new Float64Array(i);for(u=0;u<i;u++)for(c=0;c<i;c++)f.set(c,u,l.get(c,u));JM(i,f,d,s),QM(i,a,o,s,f)}this.n=i,this.e=a,this.d=o,this.V=s}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let t=this.n,e=this.e,n=this.d,i=new $t(t,t),s,o;for(s=0;s<t;s++){for(o=0;o<t;o++)i.set(s,o,0);i.set(s,s,n[s]),e[s]>0?i.set(s,s+1,e[s]):e[s]<0&&i.set(s,s-1,e[s])}return i}};function ZM(r,t,e,n){let i,s,o,a,l,c,u,h;for(l=0;l<r;l++)e[l]=n.get(l,r-1);for(a=r-1;a>0;a--){for(h=0,o=0,c=0;c<a;c++)h=h+Math.abs(e[c]);if(h===0)for(t[a]=e[a-1],l=0;l<a;l++)e[l]=n.get(l,a-1),n.set(l,a,0),n.set(a,l,0);else{for(c=0;c<a;c++)e[c]/=h,o+=e[c]*e[c];for(i=e[a-1],s=Math.sqrt(o),i>0&&(s=-s),t[a]=h*s,o=o-i*s,e[a-1]=i-s,l=0;l<a;l++)t[l]=0;for(l=0;l<a;l++){for(i=e[l],n.set(a,l,i),s=t[l]+n.get(l,l)*i,c=l+1;c<=a-1;c++)s+=n.get(l,c)*e[c],t[c]+=n.get(l,c)*i;t[l]=s}for(i=0,l=0;l<a;l++)t[l]/=o,i+=t[l]*e[l];for(u=i/(o+o),l=0;l<a;l++)t[l]-=u*e[l];for(l=0;l<a;l++){for(i=e[l],s=t[l],c=l;c<=a-1;c++)n.set(l,c,n.get(l,c)-(i*t[c]+s*e[c]));e[l]=n.get(l,a-1),n.set(l,a,0)}}e[a]=o}for(a=0;a<r-1;a++){if(n.set(a,r-1,n.get(a,a)),n.set(a,a,1),o=e[a+1],o!==0){for(c=0;c<=a;c++)e[c]=n.get(a+1,c)/o;for(l=0;l<=a;l++){for(s=0,c=0;c<=a;c++)s+=n.get(a+1,c)*n.get(l,c);for(c=0;c<=a;c++)n.set(l,c,n.get(l,c)-s*e[c])}}for(c=0;c<=a;c++)n.set(a+1,c,0)}for(l=0;l<r;l++)e[l]=n.get(l,r-1),n.set(l,r-1,0);n.set(r-1,r-1,1),t[0]=0}function KM(r,t,e,n){let i,s,o,a,l,c,u,h,f,d,p,y,g,m,x,w,_;for(o=1;o<r;o++)t[o-1]=t[o];t[r-1]=0;let E=0,S=0,v=Number.EPSILON;for(c=0;c<r;c++){for(S=Math.max(S,Math.abs(e[c])+Math.abs(t[c])),u=c;u<r&&!(Math.abs(t[u])<=v*S);)u++;if(u>c){_=0;do{for(_=_+1,i=e[c],h=(e[c+1]-i)/(2*t[c]),f=Id(h,1),h<0&&(f=-f),e[c]=t[c]/(h+f),e[c+1]=t[c]*(h+f),d=e[c+1],s=i-e[c],o=c+2;o<r;o++)e[o]-=s;for(E=E+s,h=e[u],p=1,y=p,g=p,m=t[c+1],x=0,w=0,o=u-1;o>=c;o--)for(g=y,y=p,w=x,i=p*t[o],s=p*h,f=Id(h,t[o]),t[o+1]=x*f,x=t[o]/f,p=h/f,h=p*e[o]-x*i,e[o+1]=s+x*(p*i+x*e[o]),l=0;l<r;l++)s=n.get(o+1,l),n.set(o+1,l,x*n.get(o,l)+p*s),n.set(o,l,p*n.get(o,l)-x*s);h=-x*w*g*m*t[c]/d,t[c]=x*h,e[c]=p*h}while(Math.abs(t[c])>v*S)}e[c]=e[c]+E,t[c]=0}for(o=0;o<r-1;o++){for(l=o,h=e[o],a=o+1;a<r;a++)e[a]<h&&(l=a,h=e[a]);if(l!==o)for(e[l]=e[o],e[o]=h,a=0;a<r;a++)h=n.get(o,a),n.set(o,a,n.get(l,a)),n.set(l,a,h)}}function JM(r,t,e,n){let i=0,s=r-1,o,a,l,c,u,h,f;for(h=i+1;h<=s-1;h++){for(f=0,c=h;c<=s;c++)f=f+Math.abs(t.get(c,h-1));if(f!==0){for(l=0,c=s;c>=h;c--)e[c]=t.get(c,h-1)/f,l+=e[c]*e[c];for(a=Math.sqrt(l),e[h]>0&&(a=-a),l=l-e[h]*a,e[h]=e[h]-a,u=h;u<r;u++){for(o=0,c=s;c>=h;c--)o+=e[c]*t.get(c,u);for(o=o/l,c=h;c<=s;c++)t.set(c,u,t.get(c,u)-o*e[c])}for(c=0;c<=s;c++){for(o=0,u=s;u>=h;u--)o+=e[u]*t.get(c,u);for(o=o/l,u=h;u<=s;u++)t.set(c,u,t.get(c,u)-o*e[u])}e[h]=f*e[h],t.set(h,h-1,f*a)}}for(c=0;c<r;c++)for(u=0;u<r;u++)n.set(c,u,c===u?1:0);for(h=s-1;h>=i+1;h--)if(t.get(h,h-1)!==0){for(c=h+1;c<=s;c++)e[c]=t.get(c,h-1);for(u=h;u<=s;u++){for(a=0,c=h;c<=s;c++)a+=e[c]*n.get(c,u);for(a=a/e[h]/t.get(h,h-1),c=h;c<=s;c++)n.set(c,u,n.get(c,u)+a*e[c])}}}function QM(r,t,e,n,i){let s=r-1,o=0,a=r-1,l=Number.EPSILON,c=0,u=0,h=0,f=0,d=0,p=0,y=0,g=0,m,x,w,_,E,S,v,b,N,C,I,U,B,F,V;for(m=0;m<r;m++)for((m<o||m>a)&&(e[m]=i.get(m,m),t[m]=0),x=Math.max(m-1,0);x<r;x++)u=u+Math.abs(i.get(m,x));for(;s>=o;){for(_=s;_>o&&(p=Math.abs(i.get(_-1,_-1))+Math.abs(i.get(_,_)),p===0&&(p=u),!(Math.abs(i.get(_,_-1))<l*p));)_--;if(_===s)i.set(s,s,i.get(s,s)+c),e[s]=i.get(s,s),t[s]=0,s--,g=0;else if(_===s-1){if(v=i.get(s,s-1)*i.get(s-1,s),h=(i.get(s-1,s-1)-i.get(s,s))/2,f=h*h+v,y=Math.sqrt(Math.abs(f)),i.set(s,s,i.get(s,s)+c),i.set(s-1,s-1,i.get(s-1,s-1)+c),b=i.get(s,s),f>=0){for(y=h>=0?h+y:h-y,e[s-1]=b+y,e[s]=e[s-1],y!==0&&(e[s]=b-v/y),t[s-1]=0,t[s]=0,b=i.get(s,s-1),p=Math.abs(b)+Math.abs(y),h=b/p,f=y/p,d=Math.sqrt(h*h+f*f),h=h/d,f=f/d,x=s-1;x<r;x++)y=i.get(s-1,x),i.set(s-1,x,f*y+h*i.get(s,x)),i.set(s,x,f*i.get(s,x)-h*y);for(m=0;m<=s;m++)y=i.get(m,s-1),i.set(m,s-1,f*y+h*i.get(m,s)),i.set(m,s,f*i.get(m,s)-h*y);for(m=o;m<=a;m++)y=n.get(m,s-1),n.set(m,s-1,f*y+h*n.get(m,s)),n.set(m,s,f*n.get(m,s)-h*y)}else e[s-1]=b+h,e[s]=b+h,t[s-1]=y,t[s]=-y;s=s-2,g=0}else{if(b=i.get(s,s),N=0,v=0,_<s&&(N=i.get(s-1,s-1),v=i.get(s,s-1)*i.get(s-1,s)),g===10){for(c+=b,m=o;m<=s;m++)i.set(m,m,i.get(m,m)-b);p=Math.abs(i.get(s,s-1))+Math.abs(i.get(s-1,s-2)),b=N=.75*p,v=-.4375*p*p}if(g===30&&(p=(N-b)/2,p=p*p+v,p>0)){for(p=Math.sqrt(p),N<b&&(p=-p),p=b-v/((N-b)/2+p),m=o;m<=s;m++)i.set(m,m,i.get(m,m)-p);c+=p,b=N=v=.964}for(g=g+1,E=s-2;E>=_&&(y=i.get(E,E),d=b-y,p=N-y,h=(d*p-v)/i.get(E+1,E)+i.get(E,E+1),f=i.get(E+1,E+1)-y-d-p,d=i.get(E+2,E+1),p=Math.abs(h)+Math.abs(f)+Math.abs(d),h=h/p,f=f/p,d=d/p,!(E===_||Math.abs(i.get(E,E-1))*(Math.abs(f)+Math.abs(d))<l*(Math.abs(h)*(Math.abs(i.get(E-1,E-1))+Math.abs(y)+Math.abs(i.get(E+1,E+1))))));)E--;for(m=E+2;m<=s;m++)i.set(m,m-2,0),m>E+2&&i.set(m,m-3,0);for(w=E;w<=s-1&&(F=w!==s-1,w!==E&&(h=i.get(w,w-1),f=i.get(w+1,w-1),d=F?i.get(w+2,w-1):0,b=Math.abs(h)+Math.abs(f)+Math.abs(d),b!==0&&(h=h/b,f=f/b,d=d/b)),b!==0);w++)if(p=Math.sqrt(h*h+f*f+d*d),h<0&&(p=-p),p!==0){for(w!==E?i.set(w,w-1,-p*b):_!==E&&i.set(w,w-1,-i.get(w,w-1)),h=h+p,b=h/p,N=f/p,y=d/p,f=f/h,d=d/h,x=w;x<r;x++)h=i.get(w,x)+f*i.get(w+1,x),F&&(h=h+d*i.get(w+2,x),i.set(w+2,x,i.get(w+2,x)-h*y)),i.set(w,x,i.get(w,x)-h*b),i.set(w+1,x,i.get(w+1,x)-h*N);for(m=0;m<=Math.min(s,w+3);m++)h=b*i.get(m,w)+N*i.get(m,w+1),F&&(h=h+y*i.get(m,w+2),i.set(m,w+2,i.get(m,w+2)-h*d)),i.set(m,w,i.get(m,w)-h),i.set(m,w+1,i.get(m,w+1)-h*f);for(m=o;m<=a;m++)h=b*n.get(m,w)+N*n.get(m,w+1),F&&(h=h+y*n.get(m,w+2),n.set(m,w+2,n.get(m,w+2)-h*d)),n.set(m,w,n.get(m,w)-h),n.set(m,w+1,n.get(m,w+1)-h*f)}}}if(u!==0){for(s=r-1;s>=0;s--)if(h=e[s],f=t[s],f===0)for(_=s,i.set(s,s,1),m=s-1;m>=0;m--){for(v=i.get(m,m)-h,d=0,x=_;x<=s;x++)d=d+i.get(m,x)*i.get(x,s);if(t[m]<0)y=v,p=d;else if(_=m,t[m]===0?i.set(m,s,v!==0?-d/v:-d/(l*u)):(b=i.get(m,m+1),N=i.get(m+1,m),f=(e[m]-h)*(e[m]-h)+t[m]*t[m],S=(b*p-y*d)/f,i.set(m,s,S),i.set(m+1,s,Math.abs(b)>Math.abs(y)?(-d-v*S)/b:(-p-N*S)/y)),S=Math.abs(i.get(m,s)),l*S*S>1)for(x=m;x<=s;x++)i.set(x,s,i.get(x,s)/S)}else if(f<0)for(_=s-1,Math.abs(i.get(s,s-1))>Math.abs(i.get(s-1,s))?(i.set(s-1,s-1,f/i.get(s,s-1)),i.set(s-1,s,-(i.get(s,s)-h)/i.get(s,s-1))):(V=Vc(0,-i.get(s-1,s),i.get(s-1,s-1)-h,f),i.set(s-1,s-1,V[0]),i.set(s-1,s,V[1])),i.set(s,s-1,0),i.set(s,s,1),m=s-2;m>=0;m--){for(C=0,I=0,x=_;x<=s;x++)C=C+i.get(m,x)*i.get(x,s-1),I=I+i.get(m,x)*i.get(x,s);if(v=i.get(m,m)-h,t[m]<0)y=v,d=C,p=I;else if(_=m,t[m]===0?(V=Vc(-C,-I,v,f),i.set(m,s-1,V[0]),i.set(m,s,V[1])):(b=i.get(m,m+1),N=i.get(m+1,m),U=(e[m]-h)*(e[m]-h)+t[m]*t[m]-f*f,B=(e[m]-h)*2*f,U===0&&B===0&&(U=l*u*(Math.abs(v)+Math.abs(f)+Math.abs(b)+Math.abs(N)+Math.abs(y))),V=Vc(b*d-y*C+f*I,b*p-y*I-f*C,U,B),i.set(m,s-1,V[0]),i.set(m,s,V[1]),Math.abs(b)>Math.abs(y)+Math.abs(f)?(i.set(m+1,s-1,(-C-v*i.get(m,s-1)+f*i.get(m,s))/b),i.set(m+1,s,(-I-v*i.get(m,s)-f*i.get(m,s-1))/b)):(V=Vc(-d-N*i.get(m,s-1),-p-N*i.get(m,s),y,f),i.set(m+1,s-1,V[0]),i.set(m+1,s,V[1]))),S=Math.max(Math.abs(i.get(m,s-1)),Math.abs(i.get(m,s))),l*S*S>1)for(x=m;x<=s;x++)i.set(x,s-1,i.get(x,s-1)/S),i.set(x,s,i.get(x,s)/S)}for(m=0;m<r;m++)if(m<o||m>a)for(x=m;x<r;x++)n.set(m,x,i.get(m,x));for(x=r-1;x>=o;x--)for(m=o;m<=a;m++){for(y=0,w=o;w<=Math.min(x,a);w++)y=y+n.get(m,w)*i.get(w,x);n.set(m,x,y)}}}function Vc(r,t,e,n){let i,s;return Math.abs(e)>Math.abs(n)?(i=n/e,s=e+i*n,[(r+i*t)/s,(t-i*r)/s]):(i=e/n,s=n+i*e,[(i*r+t)/s,(i*t-r)/s])}var tS=1e-9,eS=1e-13,nS=1e-6;function Qy(r,t,e){let n=Ic(r,e);if(!n)throw new Error("mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate");let[i,s]=[0,0];for(let h=0;h<e;h+=1)for(let f=0;f<e;f+=1)i=Math.max(i,Math.abs(t[h*e+f]-t[f*e+h])),s=Math.max(s,Math.abs(t[h*e+f]));if(i>tS*s)return{...Fd(n,Ld(Lc(n,t,e),e,!1),e),symmetric:!1};let o=t.map((h,f)=>(h+t[f%e*e+Math.floor(f/e)])/2),a=Ic(o,e),l=a&&Ld(Lc(a,r,e),e,!0),c=l?Math.max(...l.re):0;if(!a||!l||Math.min(...l.re)<=0||1/c<=eS*e/Math.min(...l.re))return{...Fd(n,Ld(Lc(n,o,e),e,!0),e),symmetric:!0};let u=Fd(a,{re:l.re.map(h=>1/h),vectors:l.vectors},e);return{squares:u.squares,shapes:u.shapes.map((h,f)=>h*Math.sqrt(u.squares[f%e])),symmetric:!0}}function Ld(r,t,e){let n=e?r.map((c,u)=>(c+r[u%t*t+Math.floor(u/t)])/2):r,i=new _s($t.from1DArray(t,t,n),{assumeSymmetric:e}),{realEigenvalues:s,imaginaryEigenvalues:o,eigenvectorMatrix:a}=i,l=Float64Array.from(a.to1DArray());if(!e){for(let c=1;c<t;c+=1)if(o[c]<0)for(let u=0;u<t;u+=1)l[u*t+c]=l[u*t+c-1]}for(let c=0;c<t;c+=1){let u=Math.hypot(...Array.from({length:t},(h,f)=>l[f*t+c]));for(let h=0;h<t;h+=1)l[h*t+c]/=u}return{re:Float64Array.from(s),vectors:l}}function Fd(r,{re:t,vectors:e},n){let i=Array.from(t.keys()).sort((o,a)=>t[o]-t[a]),s=new Float64Array(n*n);return i.forEach((o,a)=>{for(let l=0;l<n;l+=1)s[l*n+a]=e[l*n+o]}),Md(r,s,n,n),{squares:Float64Array.from(i,o=>t[o]),shapes:s}}function tx(r,t,e,n,i){let s=i.symmetric?i.shapes:rS(r,n),o=y=>fi(s,fi(y,s,n,n,n),n,n,n,!0),[a,l]=[o(e),o(t)];if(i.symmetric)for(let y=0;y<n*n;y+=1)a[y]=y%(n+1)?0:i.squares[y/(n+1)];let c=Array.from({length:n},(y,g)=>Math.sqrt(Math.abs(a[g*(n+1)]))),u=nS*Math.max(...c)||1,h=c.map(y=>Math.max(y,u)),f=$t.zeros(2*n,2*n);for(let y=0;y<n;y+=1){f.set(y,n+y,h[y]);for(let g=0;g<n;g+=1)f.set(n+y,g,-a[y*n+g]/h[g]),f.set(n+y,n+g,-l[y*n+g])}let d=new _s(f,{assumeSymmetric:!1}),p={re:Float64Array.from(d.realEigenvalues),im:Float64Array.from(d.imaginaryEigenvalues)};return{count:2*n,values:p,shapes:iS(d.eigenvectorMatrix,p.im,s,h,n)}}function iS(r,t,e,n,i){let s={re:new Float64Array(2*i*i),im:new Float64Array(2*i*i)};for(let o=0;o<2*i;o+=1)for(let a=0;a<i;a+=1)s.re[2*i*a+o]=r.get(a,t[o]<0?o-1:o)/n[a],s.im[2*i*a+o]=(t[o]>0?r.get(a,o+1):t[o]<0?-r.get(a,o):0)/n[a];return{re:fi(e,s.re,i,i,2*i),im:fi(e,s.im,i,i,2*i)}}function rS(r,t){let e=Float64Array.from({length:t*t},(n,i)=>i%(t+1)?0:1);return Md(Ic(r,t),e,t,t),e}var ex=.05,sS=8,oS=["settling","vibration.residual"];function ti(r,t=3){return Ze(r,t)}function Nd(r,t){if(r.length<2)return t[0];let e=0;for(let n=1;n<r.length;n+=1)e+=(t[n]+t[n-1])/2*(r[n]-r[n-1]);return e/(r[r.length-1]-r[0])}function nx(r,t,e){let n={},i=t.deviation?.data;if(i){let s=Zs(i),o=i[i.length-1];n["deviation.max"]={value:i[s],note:`at ${ti(r[s])} s; ${qn(o,"m")} at the end of the run`},n["deviation.rms"]={value:Math.sqrt(Nd(r,i.map(a=>a*a))),note:"over the run"},n.settling=aS(r,i,e)}return n["vibration.residual"]=cS(r,t,e),n}function aS(r,t,e){let n=c=>({value:null,note:`not seen: ${c}`});if(e===null)return n("what moves the robot changes up to the end of the run");let i=r[r.length-1];if(i<=e*(1+1e-9)){let c=`the run ends at ${ti(i,6)} s, the move at ${ti(e,6)} s`;return n(`${c}: simulate longer to see it settle`)}let{value:s,limit:o,strayed:a}=lS(r,t,e);if(a!==i)return{value:s,note:o};let l=`${ti(t[t.length-1])} m`;return n(`the deviation is still ${l} when the run ends at ${ti(i,6)} s`)}function lS(r,t,e){let n=ex*t[Zs(t)],i=e;for(let s=0;s<r.length;s+=1)r[s]>e&&t[s]>n&&(i=r[s]);return{value:i-e,limit:`until the tip stays within ${qn(n,"m")}, ${100*ex} % of its largest deviation`,strayed:i}}function ix(r){let t={};for(let[e,{value:n,note:i}]of Object.entries(r))oS.includes(e)?t[e]={value:null,note:"the run broke off"}:t[e]={value:n,note:`until it broke off: ${i}`};return t}function cS(r,t,e){if(e===null)return{value:null,note:"what moves the robot changes up to the end of the run"};let n=r.findIndex(l=>l>e*(1+1e-9));if(n<0||r.length-n<sS)return{value:null,note:"the run ends with the move"};let i=t.tip_reference?.data,s=t.tip.data.map((l,c)=>l-(i?i[c]:0)).subarray(3*n),o=[0,1,2].map(l=>s.reduce((c,u,h)=>h%3===l?c+u:c,0)/(s.length/3)),a=ys(s.map((l,c)=>l-o[c%3]),3);return{value:a[Zs(a)],note:`about its mean place, from ${ti(r[n])} s on`}}function rx(r,t){if(!r.energy||!r.energy_balance)return{};let{energy:e,work:n}=r,i=e.shape[1],s=Math.max(e.data.reduce((l,c,u)=>Math.max(l,Math.abs(c-e.data[u%i])),0),n.data.reduce((l,c)=>Math.max(l,Math.abs(c)),0)),o=Math.abs(r.energy_balance.data[Zs(r.energy_balance.data.subarray(0,t))]),a=s?`worst residual, ${qn(o,"J")}, over ${qn(s,"J")} moved`:"nothing moved";return{"energy.residual":{value:s?o/s:null,note:a}}}var uS=8,Dd=1e-5,hS=Math.SQRT1_2,fS=1e-9;function sx(r,t,e){let n=Object.entries(r).flatMap(([a,l])=>l.filter(c=>c.frequency>0).slice(0,uS).map(c=>[a,c])),i=pS(n,t,e),o=(r.controlled?.length?r.controlled:r.locked??[]).flatMap(a=>a.rings&&a.damping<hS?[{at:a.rings,label:a.element}]:[]);return{vibration:{modes:i,marks:o.sort((a,l)=>a.at-l.at)},facts:dS(r)}}function dS({controlled:r,locked:t}){if(!r)return{};let e=o=>o.reduce((a,l)=>l&&(a===null||l<a)?l:a,null),n=e(r.map(o=>o.rings)),i=e((t??[]).map(o=>o.frequency)),s=n===null?"no vibration under control":i===null?"":`${ti(i,4)} Hz with the motors locked`;return{"frequency.first":{value:n,note:s}}}function pS(r,t,e){let n=t.length,i=new Float64Array((1+4*r.length)*n);i.set(t),r.forEach(([,{re:u,im:h}],f)=>{let d=u.reduce((p,y,g)=>Math.max(p,Math.hypot(y,h[g])),0);for(let p=0;p<n;p+=1){let[y,g]=[Dd*u[p]/d,Dd*h[p]/d];[y,g,-y,-g].forEach((m,x)=>{i[(1+4*f+x)*n+p]=t[p]+m})}});let{data:s,shape:o}=e(i,1+4*r.length),a=s.length/(1+4*r.length),l=u=>Float64Array.from({length:a},(h,f)=>(s[u*a+f]-s[(u+2)*a+f])/(2*Dd)),c=u=>({data:Float32Array.from(u),shape:o.slice(1)});return r.map(([u,h],f)=>{let[d,p]=mS(l(1+4*f),l(2+4*f));return{case:u,frequency:h.frequency,damping:h.damping,livesIn:h.element,rest:c(s.subarray(0,a)),real:c(d),imaginary:c(p)}})}function mS(r,t){let[e,n]=[0,0];for(let c=0;c<r.length;c+=3){let u=Math.hypot(...r.subarray(c,c+3),...t.subarray(c,c+3));u>n&&([e,n]=[c,u])}if(!n)return[r,t];let i=[0,1,2].map(c=>Math.hypot(r[e+c],t[e+c])),s=e+i.indexOf(Math.max(...i)),o=Math.hypot(r[s],t[s])*n,[a,l]=[r[s]/o,-t[s]/o];return[r.map((c,u)=>a*c-l*t[u]),r.map((c,u)=>l*c+a*t[u])]}function ox(r,t){let[e,n]=[r.values.re[t],r.values.im[t]],i=Math.hypot(e,n);return{size:i,rings:n>fS*i?n/(2*Math.PI):null,damping:i?-e/i:0}}function ax(r,t,e,n,i){let s=o=>Float64Array.from({length:e},(a,l)=>{let c=0;for(let u=0;u<n;u+=1)c+=i(l,u)*o[u*r.count+t];return c});return{re:s(r.shapes.re),im:s(r.shapes.im)}}function lx(r,t,e,n){let{count:i,shapes:s}=t,o=g=>m=>{if(!n)return g(m);let x=0;for(let w=0;w<e;w+=1)x+=n[m*e+w]*g(w);return x},a=(g,m)=>{let x=0;for(let w=0;w<e;w+=1)x+=g(w)*m(w);return x},l=Ud(r.shapes,e,e),[c,u]=[Ud(s.re,e,i),Ud(s.im,e,i)],h=l.map(g=>Float64Array.from({length:e},(m,x)=>o(w=>g[w])(x))),f=g=>a(m=>g[m],o(m=>g[m])),[d,p]=[l.map(g=>Math.sqrt(f(g))),c.map((g,m)=>Math.sqrt(f(g)+f(u[m])))],y=new Float64Array(e*i);for(let g=0;g<e;g+=1)for(let m=0;m<i;m+=1){let[x,w]=[c,u].map(_=>a(E=>h[g][E],E=>_[m][E]));y[g*i+m]=Math.hypot(x,w)/(d[g]*p[m])}return y}function Ud(r,t,e){return Array.from({length:e},(n,i)=>Float64Array.from({length:t},(s,o)=>r[o*e+i]))}function gS({values:r,count:t}){let e=Array.from({length:t},(n,i)=>Math.hypot(r.re[i],r.im[i]));return{rings:e.map((n,i)=>r.im[i]>1e-9*n),stands:e.map((n,i)=>Math.abs(r.im[i])<=1e-9*n)}}function cx(r,t,e){let{count:n,values:i}=t,{rings:s,stands:o}=gS(t),a=new Float64Array(n);Array.from({length:n},(c,u)=>u).sort((c,u)=>i.re[u]-i.re[c]).forEach((c,u)=>{a[c]=u});let l=Float64Array.from(r,(c,u)=>{let h=u%n;return!s[h]&&!o[h]?100:a[h]/(10*n)-c*c-(s[h]?10:0)});return yS(l,e,n)}function yS(r,t,e){let[n,i]=[new Float64Array(t+1),new Float64Array(e+1)],s=new Int32Array(e+1);for(let a=1;a<=t;a+=1){let l=new Float64Array(e+1).fill(1/0),c=new Int32Array(e+1),u=new Uint8Array(e+1);s[0]=a;let h=0;for(;s[h];){u[h]=1;let[f,d]=[1/0,0];for(let p=1;p<=e;p+=1){if(u[p])continue;let y=r[(s[h]-1)*e+p-1]-n[s[h]]-i[p];y<l[p]&&(l[p]=y,c[p]=h),l[p]<f&&(f=l[p],d=p)}for(let p=0;p<=e;p+=1)u[p]?(n[s[p]]+=f,i[p]-=f):l[p]-=f;h=d}for(;h;h=c[h])s[h]=s[c[h]]}let o=new Array(t).fill(-1);for(let a=1;a<=e;a+=1)s[a]&&(o[s[a]-1]=a-1);return o}var xS=1e-13,_S=1e-13,vS="whole arm, free",bS="whole arm, in its weight and loads";function ux(r,t,e,n,i){if(!t.modes)return{vibration:t.noModes,facts:{}};try{let{rest:s,linear:o}=wS(r,t,e,i),a=Object.fromEntries(t.modes.cases.map(({name:l,moving:c})=>[l,MS(t,n,o,l,c)]));return sx(a,s,(l,c)=>Oc(r,t,n.pose,l,c).line)}catch(s){return{vibration:s instanceof Error?s.message:String(s),facts:{}}}}function wS(r,t,e,n){let i=null;return Ed(t,e,"real",pn(t.modes.rest),(s,o)=>(i=Sy(r,t,qo(t.map,s,"real"),n,o),i&&i.rest)),i}function MS(r,t,e,n,i){let s=Math.sqrt(e.mass.length),o=i.length;if(!o)return[];let a=g=>Float64Array.from({length:o*o},(m,x)=>g[i[Math.floor(x/o)]*s+i[x%o]]),[l,c,u]=[a(e.mass),a(e.damping),a(e.stiffness)],h=n==="controlled";h&&r.modes.servos.forEach(({coordinate:g},m)=>{let x=i.indexOf(g)*(o+1);u[x]+=t.servos[2*m],c[x]+=t.servos[2*m+1]});let f=Qy(l,u,o),d=tx(l,c,u,o,f),p=cx(lx(f,d,o,l),d,o),y=_S*o*f.squares.reduce((g,m)=>Math.max(g,Math.abs(m)),0);return Array.from({length:o},(g,m)=>{let x=new Float64Array(s);i.forEach((U,B)=>{x[U]=f.shapes[B*o+m]});let w=SS(r,t,e.elastic,x,h),_=ax(d,p[m],s,o,(U,B)=>i[B]===U?1:0),E=f.squares[m],S=w.reduce((U,{energy:B})=>U+B,0);if(Math.abs(E)<=y&&S<=y)return{frequency:0,rings:null,damping:0,element:vS,..._};let{size:v,rings:b,damping:N}=ox(d,p[m]),C=(h&&b?v:Math.sqrt(Math.max(E,0)))/(2*Math.PI),I=w.reduce((U,B)=>B.energy>U.energy?B:U,w[0]);return{frequency:C,rings:b,damping:Math.abs(N)>xS?N:0,element:S>y&&I?I.element:bS,..._}})}function SS(r,t,e,n,i){let s=n.length,o=u=>{let h=0;for(let f=0;f<s;f+=1)h+=e[u*s+f]*n[f];return h},{springs:a,servos:l}=r.modes,c=a.map(({element:u,rows:h,gear:f})=>{if(!f)return{element:u,energy:h.reduce((p,y)=>p+n[y]*o(y),0)};let d=e[h[0]*(s+1)];return{element:u,energy:d?o(h[0])**2/d:0}});return i?[...c,...l.map(({coordinate:u,element:h},f)=>({element:h,energy:t.servos[2*f]*n[u]**2}))]:c}var hx=1e-6,AS=1e-11,fx=.5,Od=40,ES=.1,dx=24;async function px(r,t,e,n,i,s,o){let{free:a,gross:l}=t.split;if(!a.length)return{};let c=i.length,u=s.q.shape[1],h=m=>xs({matrix:l,constant:{data:new Float64Array(u),shape:[u]}},s[m].data,c),f=TS(t,e,n,i,s),d={engine:r,blocks:e,free:a,size:u,places:f.length/c,weight:pn(t.split.weight),q:s.q.data.slice(),rates:h("v"),gains:h("a"),wrenches:f},p=s.deformation.data,y=null;for(let m=0;m<c;m+=dx){let x=Array.from({length:Math.min(dx,c-m)},(w,_)=>m+_);if(m&&RS(d,p,xs(t.deflections,d.q.subarray((m-1)*u,m*u),1),x),y=CS(d,s.q.data,x,y),!y)return{};await o()}let g=xs(t.deflections,d.q,c);return{deformation_stationary:Ne(g,c,a.length),deformation_oscillatory:Ne(Dc(p,g),c,a.length)}}function TS(r,t,e,n,i){let s=i.position.shape[1],o=new Float64Array(n.length*s*Mn);return n.forEach((a,l)=>{if(r.loads.forEach((c,u)=>{let h=l*s+c.point,f=t.loads.subarray(Mn*u,Mn*(u+1)),d=Ho(c,f,e,a,i.rotation.data,9*h);for(let p=0;p<Mn;p+=1)o[Mn*h+p]+=d[p]}),!(r.contactPoint<0))for(let c=0;c<3;c+=1)o[Mn*(l*s+r.contactPoint)+c]-=i.contact_force.data[3*l+c]}),o}function RS(r,t,e,n){let i=r.free.length;for(let s of n)r.free.forEach((o,a)=>{r.q[s*r.size+o]+=e[a]-t[s*i+a]})}function zd(r,t,e){let{engine:n,blocks:i,free:s,size:o}=r,a={q:t,v:Yr(r.rates,o,e),a:Yr(r.gains,o,e),base:r.weight,wrenches:Yr(r.wrenches,r.places,e)},l=Nc(n,i,a,e.length),c=n.sample("elastic",i.chain,a,e.length).forces;return Float64Array.from({length:e.length*s.length},(u,h)=>{let f=Math.floor(h/s.length)*o+s[h%s.length];return l[f]+c[f]})}function Bd(r,t,e){let{free:n,size:i}=r,s=n.length,o=new Float64Array((s+1)*i);for(let l=0;l<=s;l+=1)o.set(t,l*i);n.forEach((l,c)=>{o[c*i+l]+=hx});let a=zd(r,o,new Array(s+1).fill(e));return xy(Float64Array.from({length:s*s},(l,c)=>(a[c%s*s+Math.floor(c/s)]-a[s*s+Math.floor(c/s)])/hx),s)}function CS(r,t,e,n){let i=l=>r.q.subarray(l*r.size,(l+1)*r.size),s=l=>Bd(r,i(l[l.length>>1]),l[l.length>>1]),o=n??s(e);if(!o)return null;let a=kd(r,e,o,Od);a.length&&(o=s(a)??o),a=kd(r,a,o,Od);for(let l of a){let[c,u]=[Od,[l]];for(;u.length&&c;c-=1){let h=Bd(r,i(l),l);u=h?kd(r,u,h,3):u}u.length&&PS(r,t,l)}return o}function kd(r,t,e,n){let{free:i,size:s,q:o}=r,a=i.length,l=[],c=new Map,u=t;for(let h=0;h<n&&u.length;h+=1){let f=zd(r,Yr(o,s,u),u);u=u.filter((d,p)=>{let y=fi(e,f.subarray(p*a,(p+1)*a),a,a,1),g=y.reduce((w,_)=>Math.max(w,Math.abs(_)),0),m=g>fx?fx/g:1;if(!Number.isFinite(g))return l.push(d)&&!1;if(i.forEach((w,_)=>{o[d*s+w]-=m*y[_]}),g<AS)return!1;let x=g>ES*(c.get(d)??1/0);return c.set(d,g),x?l.push(d)&&!1:!0})}return[...l,...u]}function PS(r,t,e){let n=t.slice(e*r.size,(e+1)*r.size),i=Bd(r,n,e);if(r.q.set(n,e*r.size),!i)return;let s=r.free.length,o=fi(i,zd(r,n,[e]),s,s,1);r.free.forEach((a,l)=>{r.q[e*r.size+a]-=o[l]})}var IS=50;async function mx(r,t,e,n,i,s){let o=performance.now(),a=async(h=!1)=>{if(!(!h&&performance.now()-o<IS)){if(await new Promise(f=>setTimeout(f,0)),s.cancelled?.())throw new js("a newer run began");o=performance.now()}};await a(!0);let{vibration:l,facts:c}=ux(r,t,e,i.blocks,i.schedule);await a(!0);let u=await px(r,t,i.blocks,i.schedule,n.times,n.series,a);return{...n,vibration:l,facts:{...n.facts,...c},series:{...n.series,...u}}}function gx(r,t,e,n){let i={...nx(t,e,n),...rx(e,t.length)},s=r.deformations.flatMap((c,u)=>c.endsWith(".gear")?[u]:[]),o=s.filter(c=>r.turning.includes(r.deformations[c].replace(/\.gear$/,""))),a=o.length?o:s;if(a.length){let c=yi(e.deformation.data,r.deformations.length,a),u=Zs(c),h=r.deformations[a[u%a.length]].replace(/\.gear$/,""),f=a.length<s.length?" (of the gears that turn)":"";i["gear.max"]={value:Math.abs(c[u]),note:`${h}, at ${ti(t[Math.floor(u/a.length)])} s${f}`}}let l=e.contact_force_normal?.data;if(l){let[c,u]=[l.reduce((h,f)=>Math.min(h,f)),l.reduce((h,f)=>Math.max(h,f))];i["contact.mean"]={value:Nd(t,l),note:`from ${ti(c,4)} to ${ti(u,4)} N`}}return i}function yx(r,{strengths:t,places:e,kept:n},i){let s=[r.every>1?`one sample in ${r.every}`:"",n>e.data.length?`${e.data.length} places along each link`:""],o=s.some(Boolean)?` (looked at: ${s.filter(Boolean).join(", ")})`:"",a=f=>r.links.flatMap(({largest:d})=>d[f]??[]),l=(f,d)=>{let p=Vd(d,({value:g})=>g),y=p&&f!=="deflection.max"?` at s = ${ti(p.s,2)}`:"";return p?{[f]:{value:p.value,note:`${p.link}${y}, at ${ti(i[p.sample])} s${o}`}}:{}},c=Vd(a("stress").filter(({link:f})=>f in t),({link:f,value:d})=>d/t[f]),u=c?t[c.link]:1,h=c&&`of ${qn(u,"Pa")}, ${c.link}; margin ${ti(100*(1-c.value/u))} %${o}`;return{...l("deflection.max",a("deflection")),...l("moment.max",a("moment")),...l("stress.max",a("stress")),...c&&h?{"stress.share":{value:100*c.value/u,note:h}}:{}}}function xx(r,t){let e=Vd(r.flatMap(n=>LS(n,t)),({share:n})=>n);return e?{"limits.share":{value:100*e.share,note:e.note}}:{}}function LS({joint:r,coordinate:t,drive:e,unit:n,effortUnit:i,speed:s,effort:o,range:a},l){let c=(h,f,d=0)=>yi(l[h].data,l[h].shape[1],[f]).reduce((p,y)=>Math.max(p,Math.abs(y-d)),0),u=(h,f,d,p)=>({share:h/f,note:`${d} of ${r}: ${qn(h,p)} of ${qn(f,p)}`});return[...s?[u(c("v",t),s,"speed",`${n}/s`)]:[],...o&&e>=0?[u(c("effort",e),o,"effort",i)]:[],...a?[{share:c("q",t,a[0])/a[1],note:`range of ${r}, from its middle`}]:[]]}function Vd(r,t){return r.reduce((e,n)=>e===null||t(n)>t(e)?n:e,null)}var Gc=["y","z"],FS=[{id:"deflection",of:"deflection",label:"Deflection",unit:"m",planes:Gc},{id:"slope",of:"slope",label:"Slope",unit:"rad",planes:Gc},{id:"moment",of:"moment",label:"Moment",unit:"N m",planes:["torsion",...Gc]},{id:"shear_force",of:"shear",label:"Shear force",unit:"N",planes:Gc}];function _x(r,t,e){if(!t.length)return null;let n=r.stations.data,[i,s]=[t.length,n.length],o=Float64Array.from({length:i*s},(a,l)=>t[Math.floor(l/s)].length*n[l%s]);return{links:t.map(a=>a.name),places:{data:o,shape:[i,s]},quantities:FS.map(({id:a,of:l,label:c,unit:u,planes:h})=>{let f=new Float64Array(e*i*s*h.length);return t.forEach((d,p)=>bx(d[l],f,e,p,i,s*h.length)),{id:a,label:c,unit:u,planes:[...h],values:{data:f,shape:[e,i,s,h.length]}}})}}function vx(r,t,e){let[n,i]=[r.links.length,r.stations.data.length],s=(l,c,u,h)=>{let f=new Float64Array(e*n*i);return r.links.forEach((d,p)=>{let y=d.bends?t.find(m=>m.name===d.name):void 0,g=y&&h(y);g&&bx(g,f,e,p,n,i)}),{id:l,label:c,unit:u,values:{data:f,shape:[e,n,i]}}};if(!t.length)return[];let a=[s("bending_moment","Bending moment","N m",({moment:l})=>Float64Array.from({length:e*i},(c,u)=>Math.sqrt(l[3*u+1]**2+l[3*u+2]**2))),s("torsion","Torsional moment","N m",({moment:l})=>Float64Array.from({length:e*i},(c,u)=>Math.abs(l[3*u]))),s("deflection","Deflection from the root's tangent","m",({deflection:l})=>ys(l,2))];return t.some(l=>l.stress)?[...a,s("stress","Largest stress (von Mises)","Pa",({stress:l})=>l&&l.mises),s("strain","Largest strain","1",({stress:l})=>l&&l.strain)]:a}function bx(r,t,e,n,i,s){for(let o=0;o<e;o+=1)t.set(r.subarray(o*s,(o+1)*s),(o*i+n)*s)}function Re(r,t,e,n,i,s,o=1){let a=e[n+1]*i[s+2]-e[n+2]*i[s+1],l=e[n+2]*i[s]-e[n]*i[s+2],c=e[n]*i[s+1]-e[n+1]*i[s];r[t]+=o*a,r[t+1]+=o*l,r[t+2]+=o*c}function tn(r,t,e,n,i=1){r[t]+=i*e[n],r[t+1]+=i*e[n+1],r[t+2]+=i*e[n+2]}function Ri(r,t,e,n,i=3){for(let s=0;s<i;s+=1)r[t+s]=e[n+s]}function $i(r,t,e,n,i,s,o=1){r[t]+=o*(e[n]*i[s]+e[n+1]*i[s+1]+e[n+2]*i[s+2]),r[t+1]+=o*(e[n+3]*i[s]+e[n+4]*i[s+1]+e[n+5]*i[s+2]),r[t+2]+=o*(e[n+6]*i[s]+e[n+7]*i[s+1]+e[n+8]*i[s+2])}function Ci(r,t,e,n,i){return r[t+e]*n[i]+r[t+3+e]*n[i+1]+r[t+6+e]*n[i+2]}function Gd(r,t,e,n,i,s){for(let o=0;o<3;o+=1)for(let a=0;a<3;a+=1)r[t+3*o+a]=e[n+3*o]*i[s+a]+e[n+3*o+1]*i[s+3+a]+e[n+3*o+2]*i[s+6+a]}function wx(r,t,e,n,i){let[s,o]=[Math.cos(i),Math.sin(i)],[a,l,c]=[e[n],e[n+1],e[n+2]];r[t]=a*a+s*(1-a*a),r[t+1]=(1-s)*a*l-o*c,r[t+2]=(1-s)*a*c+o*l,r[t+3]=(1-s)*a*l+o*c,r[t+4]=l*l+s*(1-l*l),r[t+5]=(1-s)*l*c-o*a,r[t+6]=(1-s)*a*c-o*l,r[t+7]=(1-s)*l*c+o*a,r[t+8]=c*c+s*(1-c*c)}var cn=21,[qe,Xn,Ii,Pi]=[9,12,15,18],ei=new Float64Array(24),[Hc,Wc,Ka,Hd]=[0,3,6,9];function Sx(r,t,e,n,i,s,o,a){let[l,c,u]=a;ei.fill(0,0,Hd),Gd(r,t,e,n,s,o),$i(ei,Hc,e,n,s,o+9),$i(ei,Ka,r,t,s,o+12),tn(ei,Wc,ei,Ka,c),Ri(r,t+qe,e,n+qe,cn-qe),i==="revolute"?(wx(ei,Hd,s,o+12,l),Ri(Mx,0,r,t,9),Gd(r,t,Mx,0,ei,Hd),tn(r,t+Ii,ei,Ka,u),Re(r,t+Ii,e,n+Xn,ei,Wc),tn(r,t+Xn,ei,Wc)):i==="prismatic"&&(tn(ei,Hc,ei,Ka,l),Re(r,t+Pi,e,n+Xn,ei,Wc,2),tn(r,t+Pi,ei,Ka,u)),tn(r,t+qe,ei,Hc),Ja(r,t+Pi,e,n,ei,Hc)}var Mx=new Float64Array(9),Wd=new Float64Array(3);function Ja(r,t,e,n,i,s){Re(r,t,e,n+Ii,i,s),Wd.fill(0),Re(Wd,0,e,n+Xn,i,s),Re(r,t,e,n+Xn,Wd,0)}var Tr=new Float64Array(9),qc=new Float64Array(3);function qd(r,t,e,n,i,s){n<0||(Tr.fill(0),$i(Tr,0,i,s,e,n+1),tn(Tr,3,i,s+Pi,e[n]),Ja(Tr,3,i,s,Tr,0),tn(r,t,Tr,3,-1),Re(r,t+3,Tr,0,i,s+Pi,-1),Ax(r,t+3,e,n+4,i,s,Ii),Tr.fill(0,6),Ax(Tr,6,e,n+4,i,s,Xn),Re(r,t+3,i,s+Xn,Tr,6))}function Ax(r,t,e,n,i,s,o){let a=Ci(i,s,0,i,s+o),l=Ci(i,s,1,i,s+o),c=Ci(i,s,2,i,s+o);qc[0]=e[n]*a+e[n+3]*l+e[n+4]*c,qc[1]=e[n+3]*a+e[n+1]*l+e[n+5]*c,qc[2]=e[n+4]*a+e[n+5]*l+e[n+2]*c,$i(r,t,i,s,qc,0,-1)}var Ex=3,Zc=class{constructor(t,e){this.info=t;this.numbers=e;this.frames=new Float64Array((t.edges+1)*cn),[this.points,this.gains,this.line,this.moved]=Array.from({length:4},()=>new Float64Array(t.points*3)),this.turns=t.directions.length}info;numbers;frames;points;gains;line;moved;sums=new Float64Array(18);turns;march(t,e,n){let{info:i,frames:s}=this;Ri(s,0,e,n,cn);for(let o=0;o<i.edges;o+=1)this.sum(t,i.march+o*(2*this.turns+Ex),!0),Rx(s,(o+1)*cn,s,o*cn,this.sums,i.terms,!0);this.tangents(t),this.weighted(this.points,i.toPoints,this.line),this.weighted(this.gains,i.toPoints,this.moved);for(let o=0;o<i.points;o+=1)tn(this.gains,3*o,s,Pi);for(let o=0;o<=i.stations.length;o+=1){let a=cn*(o<i.stations.length?i.stations[o].edge:i.edges);Ri(s,a+qe,s,qe),Ri(s,a+Pi,s,Pi),this.along(s,a+qe,i.toEnds+o*i.points,this.line),this.along(s,a+Pi,i.toEnds+o*i.points,this.moved)}}place(t,e,n){let{info:i}=this;this.sum(t,i.reach+e*(2*this.turns+Ex),!1),Rx(n,0,this.frames,i.before[e]*cn,this.sums,i.terms,!1),n.fill(0,qe,qe+3),this.along(n,qe,i.toPlaces+e*i.points,this.line)}sum(t,e,n){let{sums:i,numbers:s,turns:o}=this,{q:a,v:l,a:c,start:u}=t,h=u+this.info.first;i.fill(0);for(let f=0;f<o;f+=1){let d=this.info.directions[f],p=s[e+f],y=s[e+o+f];i[d]+=p*a[h+f],i[3+d]+=y*a[h+f],n&&(i[6+d]+=p*l[h+f],i[9+d]+=y*l[h+f],i[12+d]+=p*c[h+f],i[15+d]+=y*c[h+f])}for(let f=0;f<3;f+=1)i[f]+=s[e+2*o+f]}tangents({q:t,v:e,a:n,start:i}){let{info:s,frames:o,numbers:a,line:l,moved:c}=this,u=i+s.first+this.turns;c.fill(0);for(let h=0;h<s.points;h+=1){let f=1,d=0,p=0;for(let g=0;g<s.stretches;g+=1){let m=a[s.stretch+h*s.stretches+g];f+=m*t[u+g],d+=m*e[u+g],p+=m*n[u+g]}let y=s.pointEdges[h]*cn;for(let g=0;g<3;g+=1)Xc[g]=o[y+3*g];for(let g=0;g<3;g+=1)l[3*h+g]=f*Xc[g];Ja(c,3*h,o,y,l,3*h),Re(c,3*h,o,y+Xn,Xc,0,2*d),tn(c,3*h,Xc,0,p)}}weighted(t,e,n){t.fill(0);for(let i=0;i<this.info.points;i+=1)this.along(t,3*i,e+i*this.info.points,n)}along(t,e,n,i){let{numbers:s}=this,o=0,a=0,l=0;for(let c=0;c<this.info.points;c+=1){let u=s[n+c];o+=u*i[3*c],a+=u*i[3*c+1],l+=u*i[3*c+2]}t[e]+=o,t[e+1]+=a,t[e+2]+=l}},Xc=new Float64Array(3),ie=new Float64Array(54),[Yi,jr,Qa,$c,Yc,jc,Xd,$d,Yd]=[0,3,6,9,12,15,24,33,42],Tx=new Map;function Rx(r,t,e,n,i,s,o){ie.fill(0),tn(ie,Yi,i,0),Re(ie,Yi,i,0,i,3);let a=ie[Yi]**2+ie[Yi+1]**2+ie[Yi+2]**2,{values:l,slopes:c}=NS(s),u=tl(l[0],a),h=tl(l[1],a),f=tl(l[2],a);for(let p=0;p<9;p+=3)Re(ie,jc+p,e,n+p,ie,Yi);for(let p=0;p<9;p+=3)Re(ie,Xd+p,ie,jc+p,ie,Yi);for(let p=0;p<9;p+=1)r[t+p]=e[n+p]+u*ie[jc+p]+h*ie[Xd+p];if(!o)return;for(let p=0;p<9;p+=1)ie[$d+p]=e[n+p]+h*ie[jc+p]+f*ie[Xd+p];tn(ie,jr,i,6),Re(ie,jr,i,6,i,3),Re(ie,jr,i,0,i,9),tn(ie,Qa,i,12),Re(ie,Qa,i,12,i,3),Re(ie,Qa,i,0,i,15),Re(ie,Qa,i,6,i,9,2),$i(ie,Yd,ie,$d,ie,jr),Re(ie,$c,ie,Yi,ie,jr);let d=2*(ie[Yi]*ie[jr]+ie[Yi+1]*ie[jr+1]+ie[Yi+2]*ie[jr+2]);tn(ie,Yc,ie,$c,d*tl(c[0],a)),Re(ie,Yc,ie,Yi,ie,$c,d*tl(c[1],a)),Re(ie,Yc,ie,jr,ie,$c,f),Ri(r,t+Ii,e,n+Ii),Re(r,t+Ii,e,n+Xn,ie,Yd),$i(r,t+Ii,e,n,ie,Yc),$i(r,t+Ii,ie,$d,ie,Qa),Ri(r,t+Xn,e,n+Xn),tn(r,t+Xn,ie,Yd)}function NS(r){let t=Tx.get(r);if(t)return t;let e=s=>Array.from({length:s},(o,a)=>a+1).reduce((o,a)=>o*a,1),n=Array.from({length:r},(s,o)=>r-1-o),i={values:[1,2,3].map(s=>Float64Array.from(n,o=>(-1)**o/e(2*o+s))),slopes:[2,3].map(s=>Float64Array.from(n.slice(0,-1),o=>o*(-1)**o/e(2*o+s)))};return Tx.set(r,i),i}function tl(r,t){let e=0;for(let n=0;n<r.length;n+=1)e=e*t+r[n];return e}var Fi=6,DS=qe+3,Kc=class{constructor(t,e,n,i,s){this.nodes=t;this.points=e;this.numbers=n;this.base=i;this.places=s;this.frames=new Float64Array(2*t.length*cn),this.hung=new Float64Array(t.length*Fi),this.beams=t.map(({beam:a})=>a&&new Zc(a,n)),this.carried=t.map(({beam:a})=>a&&OS(s));let o=Math.max(0,...t.map(({beam:a})=>a?.points??0));this.pairs=new Float64Array(3*o*(o+1)/2),this.spins=new Float64Array(9*o)}nodes;points;numbers;base;places;carried;frames;hung;beams;section=new Float64Array(DS);load=new Float64Array(Fi);pairs;spins;find(t,e){let{nodes:n,frames:i,base:s}=this;n.forEach(({parent:o,kind:a,angle:l,joint:c},u)=>{let h=l<0?US:[t.q,t.v,t.a].map(y=>y[t.start+l]),[f,d]=o<0?[s,0]:[i,this.tip(o)];Sx(i,this.root(u),f,d,a,this.numbers,c,h),this.beams[u]?.march(t,i,this.root(u));let p=this.beams[u];p?Ri(i,this.tip(u),p.frames,p.info.edges*cn,cn):Ri(i,this.tip(u),i,this.root(u),cn)}),this.hung.fill(0);for(let o=n.length-1;o>=0;o-=1)this.balanced(o,t,e)}root(t){return t*cn}tip(t){return(this.nodes.length+t)*cn}balanced(t,e,n){let{frames:i,hung:s,load:o}=this,a=this.beams[t],l=this.root(t);qd(s,t*Fi,this.numbers,this.nodes[t].tip,i,this.tip(t)),this.pushed(s,t*Fi,t,-1,i,this.tip(t),n),a?this.along(t,a,this.carried[t],e,n):Ri(o,0,s,t*Fi,Fi);let c=this.nodes[t].parent;c>=0&&Zd(s,c*Fi,o,0,i,l+qe,i,this.tip(c)+qe)}pushed(t,e,n,i,s,o,a){this.points.forEach((l,c)=>{if(!(l.node!==n||l.station!==i)){Li.fill(0,0,3),$i(Li,0,s,o,this.numbers,l.offset);for(let u=0;u<Fi;u+=1)t[e+u]+=a[c*Fi+u];Re(t,e+3,Li,0,a,c*Fi)}})}along(t,e,n,i,s){let{frames:o,hung:a,load:l,section:c}=this,u=this.root(t),h=e.info.stations.map((f,d)=>{let p=new Float64Array(Fi);return qd(p,0,this.numbers,f.body,e.frames,f.edge*cn),this.pushed(p,0,t,d,e.frames,f.edge*cn,s),p});this.spread(e);for(let f=this.places-1;f>=0;f-=1){e.place(i,f,c),kS(n,f,o,u,c),tn(c,qe,o,u+qe),l.fill(0),Zd(l,0,a,t*Fi,o,this.tip(t)+qe,c,qe),e.info.stations.forEach(({edge:d,last:p},y)=>{f<=p&&Zd(l,0,h[y],0,e.frames,d*cn+qe,c,qe)}),this.outboard(e,f,l,o,u);for(let d=0;d<3;d+=1)n.moment[3*f+d]=Ci(c,0,d,l,3);for(let d=0;d<2;d+=1)n.shear[2*f+d]=Ci(c,0,d+1,l,0);n.axial[f]=Ci(c,0,0,l,0)}}spread({info:t,points:e,gains:n,frames:i}){let{pairs:s,spins:o}=this;s.fill(0);let a=0;for(let l=0;l<t.points;l+=1)for(let c=l;c<t.points;c+=1,a+=3)Re(s,a,e,3*l,n,3*c,-1),c>l&&Re(s,a,e,3*c,n,3*l,-1);o.fill(0,0,3*t.rotary*t.points);for(let l=0;l<t.rotary;l+=1)for(let c=0;c<t.points;c+=1){let u=t.pointEdges[c]*cn;for(let f=0;f<3;f+=1)Li[f]=i[u+3*f+l];let h=3*(l*t.points+c);Re(o,h,i,u+Xn,Li,0,Ci(i,u,l,i,u+Xn)),tn(o,h,Li,0,Ci(i,u,l,i,u+Ii))}}outboard({info:t,gains:e},n,i,s,o){let{numbers:a,pairs:l,spins:c,section:u}=this,h=t.points;Li.fill(0,0,6),jd(Li,0,e,a,t.outboard+n*h,h,-1),tn(Li,3,u,qe),tn(Li,3,s,o+qe,-1),tn(i,0,Li,0),Re(i,3,Li,3,Li,0,-1);let f=h*(h+1)/2;jd(i,3,l,a,t.levers+n*f,f,1),jd(i,3,c,a,t.turning+n*t.rotary*h,t.rotary*h,-1)}},US=[0,0,0],Li=new Float64Array(9),el=new Float64Array(6);function OS(r){let[t,e,n,i,s]=[2,2,3,2,1].map(o=>new Float64Array(o*r));return{deflection:t,slope:e,moment:n,shear:i,axial:s}}function jd(r,t,e,n,i,s,o){let a=0,l=0,c=0;for(let u=0;u<s;u+=1){let h=n[i+u];a+=h*e[3*u],l+=h*e[3*u+1],c+=h*e[3*u+2]}r[t]+=o*a,r[t+1]+=o*l,r[t+2]+=o*c}function Zd(r,t,e,n,i,s,o,a){for(let l=0;l<Fi;l+=1)r[t+l]+=e[n+l];for(let l=0;l<3;l+=1)el[l]=i[s+l]-o[a+l];Re(r,t+3,el,0,e,n)}function kS({deflection:r,slope:t},e,n,i,s){for(let a=0;a<3;a+=1)el[a]=s[3*a];let o=Ci(n,i,0,el,0);for(let a=0;a<2;a+=1)r[2*e+a]=Ci(n,i,a+1,s,qe),t[2*e+a]=Math.atan2(Ci(n,i,a+1,el,0),o)}function Cx(r,t,e){let[n,i,s,o]=r.subarray(t,t+4),[a,l,c,u]=[0,1,2,3].map(y=>r.subarray(t+4+y*e,t+4+(y+1)*e)),h=(y,g)=>Math.abs(y-g)<=1e-9*Math.abs(g),f=s===o&&i>0&&u.every((y,g)=>h(y/i,(a[g]+l[g])/n)),d=f?s:Math.min(2*Math.min(s,o),Math.hypot(s,o)),p=(y,g)=>g.map(m=>m>0?y/m:0);return{young:n,ring:f,perMomentY:p(o,a),perMomentZ:p(s,l),perForce:p(1,c),perTorsion:p(i*d,u)}}function Px({young:r,ring:t,perMomentY:e,perMomentZ:n,perForce:i,perTorsion:s},{moment:o,axial:a},l){for(let c=0;c<a.length;c+=1){let[u,h]=[Math.abs(o[3*c+1])*e[c],Math.abs(o[3*c+2])*n[c]];l.strain[c]=(t?Math.sqrt(u*u+h*h):u+h)+Math.abs(a[c])*i[c];let[f,d]=[r*l.strain[c],Math.abs(o[3*c])*s[c]];l.mises[c]=Math.sqrt(f*f+3*d*d)}}var BS=4e5;function Ix(r,t,e,n,i,s){let{carried:o}=r,a=pn(o.places),l=new Kc(o.nodes,o.points,t,zS(r),a.length),c=o.nodes.flatMap((p,y)=>p.beam?[VS(p,l.carried[y],t,a.length,s.length*o.shown.data.length)]:[]),u=Math.max(1,Math.ceil(n.length*c.length*a.length/BS)),h=new Float64Array(Mn*o.points.length),f=e.q.shape[1],d=0;for(let p=0;c.length>0&&p<n.length;p+=1){let y=s[d]===p;if(!(!y&&p%u)){GS(r,t,e,i,n[p],p,h),l.find({q:e.q.data,v:e.v.data,a:e.a.data,start:p*f},h);for(let g of c)g.fibre&&g.stress&&Px(g.fibre,g.carried,g.stress),HS(g,a,p),y&&WS(g,d,o.shown.data);y&&(d+=1)}}return{links:c.map(p=>p.info),every:u}}function zS({base:r,gravity:t}){let e=new Float64Array(cn);e.set(Array.from(r.data).slice(9,18)),e.set(Array.from(r.data).slice(18,21),qe);for(let n=0;n<3;n+=1)e[Pi+n]=-t.data[n];return e}function VS(r,t,e,n,i){let s=r.beam,o=s.stress<0?null:Cx(e,s.stress,n),a=f=>o?{strain:new Float64Array(f),mises:new Float64Array(f)}:null,[l,c]=[2*i,3*i],h={...{deflection:new Float64Array(l),slope:new Float64Array(l),moment:new Float64Array(c),shear:new Float64Array(l),axial:new Float64Array(i)},name:r.name,length:e[s.length],stress:a(i),largest:{deflection:null,moment:null,stress:null}};return{carried:t,fibre:o,stress:a(n),info:h}}function GS({carried:r},t,e,n,i,s,o){o.fill(0);for(let a of r.loads){let l=t.subarray(a.wrench,a.wrench+Mn),c=s*e.rotation.shape[1]+r.points[a.place].point,u=Ho(a,l,n,i,e.rotation.data,9*c);for(let h=0;h<Mn;h+=1)o[Mn*a.place+h]+=u[h]}if(r.touched>=0)for(let a=0;a<3;a+=1)o[Mn*r.touched+a]-=e.contact_force.data[3*s+a]}function HS({carried:r,stress:t,info:e},n,i){let s=n.length-1;Kd(e,"deflection",Math.sqrt(r.deflection[2*s]**2+r.deflection[2*s+1]**2),n[s],i);for(let o=0;o<=s;o+=1)Kd(e,"moment",Math.sqrt(r.moment[3*o+1]**2+r.moment[3*o+2]**2),n[o],i),t&&Kd(e,"stress",t.mises[o],n[o],i)}function Kd({name:r,largest:t},e,n,i,s){let o=t[e];(!o||n>o.value)&&(t[e]={link:r,value:n,s:i,sample:s})}function WS({carried:r,stress:t,info:e},n,i){let s=i.length,o=(a,l,c)=>{for(let u=0;u<s;u+=1)for(let h=0;h<c;h+=1)l[(n*s+u)*c+h]=a[i[u]*c+h]};o(r.deflection,e.deflection,2),o(r.slope,e.slope,2),o(r.moment,e.moment,3),o(r.shear,e.shear,2),o(r.axial,e.axial,1),!(!t||!e.stress)&&(o(t.strain,e.stress.strain,1),o(t.mises,e.stress.mises,1))}async function Lx(r,t,e,n,i,s){let{settings:o}=t,a=t.runs[n],l=or(0,a.signals).map(h=>bd(vd(i[`knots.${h}`],i[`coefficients.${h}`]),o.duration)),c=dy(l);l.length||(c.knots[1]=o.duration);let u=await sy(r,{loop:`${n}.${o.method}`,parameters:i.parameters,knots:c.knots,rows:uy(c),state:My(r,t,e,n,c),times:pn(t.times),settings:o},s);return{name:n,info:a,blocks:i,schedule:c,run:u}}var Rr=24;function Fx(r,t,e,n){let i=e.run.times.subarray(0,n),s=e.run.states.subarray(0,n*(e.run.states.length/e.run.times.length)),o=hy(e.schedule,i),a={time:i,state:s,row:o,step:new Float64Array(1)},l=r.sample(`${e.name}.observe`,e.blocks.parameters,a,n),{q:c,v:u,a:h}=l,f=pn(t.base),{chain:d,rotors:p}=e.blocks,{points:y}=r.sample("inertia",d,{q:c,v:u,a:h,base:f},n),g=new Float64Array(p.length),m=r.sample("inertia",d,{q:c,v:g,a:u,base:f},n),x=r.sample("elastic",d,{q:c,v:u,base:f},n).energies;return{model:l,points:y,energy:qS(t,u,p,m,x,n)}}function qS(r,t,e,n,i,s){let o=e.length,a=i.length/s,l=new Float64Array(4*s);for(let c=0;c<s;c+=1){for(let u=0;u<o;u+=1){let h=t[c*o+u];l[4*c]+=(n.forces[c*o+u]+e[u]*h)*h/2}for(let u=0;u<3;u+=1)l[4*c+1]-=n.moment[3*c+u]*r.gravity.data[u];for(let u=0;u<a;u+=1)l[4*c+2+u%2]+=i[c*a+u]}return l}function Nx(r,t,{model:e,points:n,energy:i},s){let o=e.q.length/s,a=e.gear.length/s,l=n.length/s/Rr,c=t.run.states.length/t.run.times.length,u=yi(t.run.states.subarray(0,s*c),c,or(...t.info.state.works)),h=g=>Ne(yi(e.drives,4*a,or(0,a).map(m=>4*m+g)),s,a),f=g=>yi(n,l*Rr,or(0,l).flatMap(m=>or(0,3).map(x=>m*Rr+g+x))),d=yi(n,l*Rr,or(0,l).flatMap(g=>or(g*Rr,g*Rr+9))),p={q:Ne(e.q,s,o),v:Ne(e.v,s,o),a:Ne(e.a,s,o),deformation:Ne(xs(r.deflections,e.q,s),s,r.deformations.length),position:Ne(f(9),s,l,3),velocity:Ne(f(12),s,l,3),acceleration:Ne(f(18),s,l,3),rotation:Ne(d,s,l,3,3),tip:Ne(yi(n,l*Rr,[9,10,11]),s,3),tip_velocity:Ne(yi(n,l*Rr,[12,13,14]),s,3),energy:Ne(i,s,4),work:Ne(u,s,u.length/s),energy_balance:Ne(Ay(i,u,s,3),s)};if(a&&Object.assign(p,{wanted:h(3),effort:h(0),gear_torque:Ne(e.gear,s,a)}),a&&r.electric&&Object.assign(p,{voltage:h(1),current:h(2)}),r.contactPoint<0)return p;let y=g=>yi(e.contact,6,g);return{...p,contact_force:Ne(y([0,1,2]),s,3),contact_force_normal:Ne(y([3]),s),penetration:Ne(y([4]),s)}}function Dx(r,t,e,n){let i=e.model.q.length/n,s=e.points.length/n/Rr,[o,a]=[t,e].map(({points:c})=>yi(c,s*Rr,[9,10,11])),l={q_reference:Ne(e.model.q,n,i),v_reference:Ne(e.model.v,n,i),deformation_reference:Ne(xs(r.deflections,e.model.q,n),n,r.deformations.length),gear_torque_reference:Ne(e.model.gear,n,e.model.gear.length/n),tip_reference:Ne(a,n,3),deviation:Ne(ys(Dc(o,a),3),n)};return r.contactPoint>=0&&(l.contact_force_normal_reference=Ne(yi(e.model.contact,6,[3]),n)),l}var XS=32;async function Ux(r,t,e,n,i,s=()=>{}){let o=performance.now(),a=t.runs.reference?["reference","real"]:["real"],l=[];for(let[S,v]of a.entries()){let b={...n,progress:I=>n.progress?.((S+I)/a.length)},N=qo(t.map,e,v),C=()=>Lx(r,t,e,v,N,b);l.push(await(v==="reference"?i.of(N,C):C()))}let c=l[l.length-1];s(c);let u=(performance.now()-o)/1e3,h=Math.min(...l.map(S=>S.run.times.length)),[f,d]=[c,...l.slice(0,-1)].map(S=>Fx(r,t,S,h)),p=c.run.times.subarray(0,h),y={...Nx(t,c,f,h),...d?Dx(t,f,d,h):{}},g=vy(t,h),m=YS(c.schedule),x=l.find(S=>S.run.status!=="finished"),w=Ix(t,c.blocks.carried,y,p,c.schedule,g),_={...gx(t,p,y,m),...yx(w,t.carried,p),...xx(t.carried.limits,y)},E=vx(t,w.links,g.length);return{status:x?x.run.status:"finished",message:x?`${x===c?"actual robot":"reference"}: ${x.run.message}`:c.run.message,seconds:u,times:p,series:y,scene:Ey(r,t,c.blocks,y,p,g,E),line:_x(t,w.links,g.length),span:$S(p,m),facts:x?ix(_):_}}function $S(r,t){let e=r[r.length-1],n=t===null?-1:r.findIndex(i=>i>=t*(1+1e-9));return[n>=0&&r.length-n>=XS?r[n]:r[0],e]}function YS(r){let t=r.knots.length-1,e=r.degree+1;for(let n=t-1;n>=0;n-=1)for(let i=0;i<r.signals;i+=1){let s=r.coefficients.subarray((n*r.signals+i)*e,(n*r.signals+i+1)*e),o=r.knots[n+1]-r.knots[n],a=Math.max(...or(0,t).map(u=>Math.abs(r.coefficients[(u*r.signals+i)*e])),1e-12);if(s.some((u,h)=>h>0&&Math.abs(u)*o**h>1e-9*a))return n===t-1?null:r.knots[n+1];let c=n&&Go(r,i,r.knots[n]-1e-9*o);if(n&&Math.abs(s[0]-c)>1e-6*a)return r.knots[n]}return 0}async function Ox(r){let t=await Rc.open(r.module.data,r.layout),e=new Cc;return{async run(n,i,s=()=>{}){let o=null,a=await Ux(t,r,n,i,e,l=>{o=l});return s(a,[a.times,a.series,o]),mx(t,r,n,a,o,i)}}}function kx(r,t){let e=r.map(i=>typeof i=="object"&&"parts"in i&&jS(i.optional,t)),n=r.some((i,s)=>e[s]&&typeof i=="object"&&"optional"in i&&i.optional>=0);return r.map((i,s)=>typeof i=="string"?i:"header"in i?n?i.header:"":e[s]?i.parts.map(o=>typeof o=="string"?o:ZS(o,t)).join(""):"").join("")}function jS(r,t){return r<0||t[r]!==1}function ZS(r,t){let e=t[r.slider];return KS(r.base===null?e:r.base*e)}function KS(r){let[t,e]=String(r).split("e"),n=t.includes(".")?t:`${t}.0`;return e===void 0?n:`${n}e${e}`}var Xo=class extends Error{name="Superseded"};async function Bx(r){let t=r,e=await QS(t)??await JS(t),n=i=>{if(i.length!==t.sliders.length||!i.every(Number.isFinite))throw new Error(`values: got ${i.length}; expected ${t.sliders.length} finite numbers, one of each slider`)};return{sliders:t.sliders,async run(i,s=()=>{},o=()=>{}){return n(i),e.run(i,s,o)},sheet(i){return n(i),kx(t.sheet,i)},close:()=>e.close()}}async function JS(r){let t=await Ox(r),e=0,n=Promise.resolve();return{async run(i,s,o){let a=e+=1,l=()=>a!==e,c=n.then(()=>{if(l())throw new Xo("a newer run began");return t.run(i,{cancelled:l,progress:s},o)});n=c.catch(()=>{});try{return await c}catch(u){throw u instanceof js?new Xo(u.message):u}},close:()=>e+=1}}async function QS(r){if(typeof Worker>"u"||typeof document>"u")return null;let t=URL.createObjectURL(new Blob([iy],{type:"text/javascript"}));try{let e=new Worker(t);if(await tA(e,r))return eA(e);e.terminate()}catch{}finally{URL.revokeObjectURL(t)}return null}function tA(r,t){return new Promise(e=>{r.onmessage=({data:n})=>e(n.kind==="ready"),r.onerror=()=>e(!1),r.postMessage({kind:"open",bundle:t})})}function eA(r){let t=0,e=null,n=null,i=s=>{n?.reject(s),n=null};return r.onerror=s=>i(new Error(s.message)),r.onmessage=({data:s})=>{!("id"in s)||s.id!==t||!n||(s.kind==="progress"?n.progress(s.share):s.kind==="early"?n.early(e=s.run):s.kind==="error"?i(new Error(s.message)):s.kind==="done"&&(n.resolve(oy(e,s.run)),n=null))},{run(s,o,a){return i(new Xo("a newer run began")),t+=1,e=null,r.postMessage({kind:"run",id:t,values:s}),new Promise((l,c)=>n={resolve:l,reject:c,progress:o,early:a})},close(){i(new Xo("the live model was closed")),r.terminate()}}}function $o(r){return r!==null&&r.vibration===void 0}function Jc(r){let t=0;return{begin(){t||=window.setTimeout(r,300)},end(){clearTimeout(t),t=0}}}function zx(r,t){let e=[];r.append(t.runs.length>1?rA(t,e):nA(t.runs[0].facts,e));let n=null,i=Jc(()=>e.forEach(o=>o(n,!0))),s=o=>{n=o,$o(o)?i.begin():i.end(),e.forEach(a=>a(o,!1))};return s(null),{show:s}}function nA(r,t){return lt("dl",{class:"facts"},...r.map(e=>{let n=lt("strong"),i=lt("span",{class:"was"}),s=lt("dd",{class:"note"}),o=!1;return t.push((a,l)=>{let c=a?.facts[e.id];if(!c&&$o(a)){l&&Rn(i,o?"of the setting before":"of the original run"),l&&(i.hidden=!1);return}o=c!==void 0;let u=c?`${iA(e,c.value)} was ${qn(e.value,e.unit)}`:"of the original run";Rn(n,qn(c?c.value:e.value,e.unit)),Rn(i,a?u:""),Rn(s,(c?c.note:e.note)||""),i.hidden=a===null||c!==void 0&&c.value===null&&e.value===null,s.hidden=s.textContent===""}),lt("div",{"data-fact":e.id},lt("dt",{text:e.name}),lt("dd",{},n,i),s)}))}function iA(r,t){if(t===null||r.value===null||r.value===0)return"";let e=100*(t-r.value)/Math.abs(r.value);if(Math.abs(e)<.05)return"";let n=Math.abs(e)>=1e3?"1000 % and more":`${Number(Math.abs(e).toPrecision(2))} %`;return`${e>0?"+":"−"}${n},`}function rA(r,t){let e=new Map;for(let o of r.runs.flatMap(a=>a.facts))e.has(o.id)||e.set(o.id,o);let n=lt("tr",{},lt("td",{}),...r.runs.map(o=>lt("th",{scope:"col",text:o.name}))),i=[...e.values()].map(o=>lt("tr",{"data-fact":o.id},lt("th",{scope:"row",text:o.name}),...r.runs.map((a,l)=>{let c=lt("td",{class:"number"}),u=a.facts.find(h=>h.id===o.id);return t.push(h=>{let f=l===0?h?.facts[o.id]:void 0;l===0&&!f&&$o(h)||(Rn(c,qn(f?f.value:u?.value??null,u?.unit??o.unit)),c.title=(f??u)?.note??"")}),c}))),s=lt("table",{},lt("thead",{},n),lt("tbody",{},...i));return lt("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Numbers of the runs"},s)}var Gx=150,Vx="12px system-ui, sans-serif";function Hx(r,t,e){let n=t.runs[0].line,i=t.runs[0].scene.times.data,s=[],o=!1,a=!1,l="",c=lt("div",{class:"line-grid"}),u=lt("p",{class:"note"});r.append(u,c);function h(){a=!1;let w=n===null?"":sA(n);w===l?s.forEach((_,E)=>_.take(n.quantities[E])):f(),l=w,d()}function f(){s.forEach(({plot:w})=>w.destroy()),c.replaceChildren(),s=n===null?[]:n.quantities.map(w=>lA(c,n,w))}function d(){if(n===null||a||!o)return;let w=aA(i,e.time);u.textContent=`${n.links.join(", ")}: along the links from root to tip, at ${Ze(i[w],4)} s. The scales are those of the whole run.`;let _=Wx(n);for(let{plot:E,quantity:S,factor:v}of s){let b=S.planes.map((N,C)=>oA(n,S.values,w,C,S.planes.length,v));E.setData([_,...b])}}let p=matchMedia("(prefers-color-scheme: dark)"),y=()=>s.forEach(({plot:w})=>w.redraw());p.addEventListener("change",y);let g=new ResizeObserver(()=>s.forEach(({plot:w})=>{let _=w.root.parentElement?.clientWidth??0;_>0&&_!==w.width&&w.setSize({width:_,height:Gx})}));g.observe(c);let m=new IntersectionObserver(w=>{o=w.some(_=>_.isIntersecting),o&&a?h():d()});m.observe(r);let x=e.subscribe(d);return h(),{show(w){n=w?w.line:t.runs[0].line,i=w?w.scene.times.data:t.runs[0].scene.times.data,a=!0,o&&h()},dispose(){x(),g.disconnect(),m.disconnect(),p.removeEventListener("change",y),s.forEach(({plot:w})=>w.destroy()),r.replaceChildren()}}}function sA(r){let{links:t,places:e,quantities:n}=r;return JSON.stringify([t,Array.from(e.data),n.map(({id:i,label:s,unit:o,planes:a})=>[i,s,o,a])])}function Wx(r){let t=r.places.shape[1],e=[],n=0;for(let i=0;i<r.links.length;i+=1){for(let s=0;s<t;s+=1)e.push(n+r.places.data[i*t+s]+(s===0&&i>0?1e-9:0));n=e[e.length-1]}return e}function oA(r,t,e,n,i,s){let o=r.links.length*r.places.shape[1],a=e*o*i;return Array.from({length:o},(l,c)=>s*t.data[a+c*i+n])}function aA(r,t){let e=0,n=r.length-1;for(;n-e>1;){let i=e+n>>1;r[i]<=t?e=i:n=i}return Math.abs(r[n]-t)<Math.abs(r[e]-t)?n:e}function lA(r,t,e){let n=[0,1],i=e.planes.map((g,m)=>ka("real",m,!0,1)),s=lt("div",{class:"plot-area",role:"img"}),o=lt("span",{class:"unit"}),a=lt("div",{class:"legend"},...e.planes.map((g,m)=>lt("span",{class:"key"},lc(`var(${i[m].property})`,i[m].dash),lt("span",{text:g})))),l=lt("h4",{text:e.label},o);r.append(lt("figure",{class:"chart"},lt("figcaption",{},l,a),s));let c={stroke:()=>Ar("--grid"),width:1},u={stroke:()=>Ar("--quiet"),font:Vx,grid:c,ticks:{...c,size:4}},h=Wx(t),f=t.links.slice(1).map((g,m)=>h[(m+1)*t.places.shape[1]]),p={plot:new wn({width:Math.max(s.clientWidth,120),height:Gx,legend:{show:!1},padding:[8,14,0,0],cursor:{show:!1},scales:{x:{time:!1},y:{range:()=>n}},axes:[{...u,label:"along the links [m]",labelSize:18,labelFont:Vx,size:30,values:(g,m)=>m.map(ui)},{...u,size:(g,m)=>16+7*Math.max(2,...(m??[]).map(x=>x.length)),values:(g,m)=>m.map(ui)}],series:[{},...i.map(g=>({stroke:()=>Ar(g.property),dash:g.dash,width:1.6,points:{show:!1}}))],hooks:{draw:[g=>cA(g,f)]}},[h,...i.map(()=>h.map(()=>0))],s),quantity:e,factor:1,take:y};function y(g){let[m,x]=[0,0];for(let E of g.values.data)E<m&&(m=E),E>x&&(x=E);let w=Nf(g.unit,Math.max(-m,x)),_=.06*(x-m)||1;n=[(m-_)*w.factor,(x+_)*w.factor],[p.quantity,p.factor]=[g,w.factor],Rn(o,` [${w.name||"–"}]`),s.setAttribute("aria-label",`${g.label} along the links, between ${ui(m*w.factor)} and ${ui(x*w.factor)} ${w.name}`)}return y(e),p}function cA(r,t){let{ctx:e,bbox:n}=r;e.save(),e.strokeStyle=Ar("--quiet"),e.setLineDash([3,3]);for(let i of t){let s=r.valToPos(i,"x",!0);e.beginPath(),e.moveTo(s,n.top),e.lineTo(s,n.top+n.height),e.stroke()}e.restore()}function Xx(r){let t=["Frequency [Hz]","Damping [%]","Lives in",""].map(a=>lt(a?"th":"td",a?{scope:"col",text:a}:{})),e=lt("tbody"),n=lt("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Modes"},lt("table",{},lt("thead",{},lt("tr",{},...t)),e)),i=[],s=a=>(i[Math.min(a,i.length-1)]?.button??n).focus();function o(a){for(;i.length<a;){let u=uA(r);i.push(u),e.append(u.element)}let l=i.splice(a),c=l.some(u=>u.button===document.activeElement);for(let u of l)u.element.remove();c&&s(a)}return{element:n,tell(a,l,c){o(a.length),a.forEach((u,h)=>i[h].tell(u,l&&l[h],u===c))},focus:s}}function uA(r){let t=null,[e,n,i]=[qx(),qx(),lt("td")],s=Tn("",()=>t&&r(t));return{element:lt("tr",{},e.element,n.element,i,lt("td",{},s)),button:s,tell(o,a,l){t=o;let c=f=>a===null?"":a?f(a):"–",u=f=>Ze(100*f.damping,3);e.tell(Ze(o.frequency),c(f=>Ze(f.frequency))),n.tell(u(o),c(u)),Rn(i,o.livesIn),Rn(s,l?"stop":"show"),s.setAttribute("aria-pressed",String(l));let h=l?"Stop showing the mode":`Show the mode of ${Ze(o.frequency)} Hz in 3D`;s.setAttribute("aria-label",h)}}}function qx(){let[r,t]=[lt("span"),lt("span",{class:"was",hidden:!0})];return{element:lt("td",{class:"number"},r,t),tell(e,n){Rn(r,e),t.hidden=!n||n===e,Rn(t,t.hidden?"":`was ${n}`)}}}var hA={controlled:"under control",locked:"motors held",free:"motors free"},fA=.12;function Jd(r,t,e,n){let i=t.runs[0].modes,s=[...new Set(i.map(b=>b.case))],o=i,a=null,l=fA,c=Xx(b=>g(b===a?null:b)),u=qr("case"),h=lt("select",{id:u},...s.map(b=>lt("option",{value:b,text:hA[b]??b})));h.addEventListener("change",()=>_(h.value));let f=lt("input",{type:"range",min:"0.02",max:"0.3",step:"0.01",value:String(l),id:qr("size")});f.addEventListener("input",()=>{l=Number(f.value),a&&e.showMode(a,l)});let d=Tn("back to the motion",()=>{let b=w(a);g(null),c.focus(b)},{hidden:!0}),p=lt("p",{class:"note",hidden:!0,role:"status"}),y=Jc(()=>{E(`These are the modes of the ${o===i?"run as it was":"setting before"}; the new ones are being found.`)});function g(b){b&&n.pause(),m(b)}function m(b){a=b,e.showMode(b,l),d.hidden=b===null,_(h.value)}let x=(b,N)=>b.filter(C=>C.case===N),w=b=>b?x(o,b.case).indexOf(b):-1;function _(b){c.tell(x(o,b),o===i?null:x(i,b),a)}function E(b){Rn(p,b),p.hidden=!b}let S=lt("div",{class:"bar"},lt("label",{for:u,text:"Modes"}),h,lt("label",{for:f.id,text:"amplitude"}),f,d);r.append(S,p,c.element),_(s[0]??"");let v=n.subscribe(b=>{b.playing&&a&&g(null)});return{show(b){if($o(b))return y.begin();y.end();let N=b?.vibration,C=w(a);o=typeof N=="object"?N.modes:i,E(N===void 0?"":dA(N));let I=a&&(x(o,a.case)[C]??null);a&&I!==a?m(I):_(h.value)},dispose(){v(),y.end(),r.replaceChildren()}}}function dA(r){return typeof r=="string"?`These are the modes of the run as it was: ${r}.`:"About the rest with the changed numbers; under each number what it was."}function $x(r,t){for(let e of t.runs){if(!e.sheet)continue;let n=t.runs.length>1?`Save the YAML of ${e.name}`:"Save the YAML of this run";r.append(Tn(n,()=>Po(e.sheet,`${Qd(e.name)}.yaml`,"application/yaml"),{class:"save-yaml"}))}}function Qd(r){return r.replace(/[^\p{L}\p{N}._-]+/gu,"_").replace(/^[._]+/,"").slice(0,80)||"run"}var tp=1e3;function Yx(r,t){let e=qr("slider"),n=Ff(r.unit),i=lt("input",{type:"range",id:e,min:"0",max:String(tp),step:"1"}),s=lt("input",{type:"number","aria-label":`${r.label}${n?`, in ${n}`:""}`,step:"any",min:String(r.min),max:String(r.max)}),o=Tn("↺",u,{class:"tool","aria-label":`${r.label}: back to ${Ze(r.value,6)} ${n}`,title:"back to the run's own"}),a=r.value;function l(d=!1){i.value=String(Math.round(tp*pA(r,a))),i.setAttribute("aria-valuetext",`${Ze(a,5)} ${n}`),d||(s.value=String(Number(a.toPrecision(6)))),o.disabled=a===r.value,f.classList.toggle("changed",a!==r.value)}function c(d,p=!1){let y=Math.min(Math.max(d,r.min),r.max);if(y===a)return l(p);a=y,l(p),t()}function u(){c(r.value),i.focus()}i.addEventListener("input",()=>c(Number(Ze(mA(r,Number(i.value)/tp),4)))),s.addEventListener("input",()=>{s.value!==""&&Number.isFinite(s.valueAsNumber)&&c(s.valueAsNumber,!0)}),s.addEventListener("change",()=>l());let h=lt("label",{for:e},lt("span",{text:r.label}),lt("i",{text:r.symbol?` ${r.symbol}`:""})),f=lt("div",{class:"slider","data-path":r.path},h,lt("div",{class:"slider-row"},i,s,lt("span",{class:"unit",text:n}),o));return l(),{element:f,slider:r,get value(){return a},set value(d){a=d,l()}}}function pA(r,t){let{min:e,max:n}=r;return n<=e?0:r.log&&e>0?Math.log(t/e)/Math.log(n/e):(t-e)/(n-e)}function mA(r,t){let{min:e,max:n}=r;return r.log&&e>0?e*(n/e)**t:e+t*(n-e)}var jx=300;function Zx(r,t,e){let n=lt("p",{class:"note",role:"status","aria-live":"polite",text:"starts …"}),i=lt("progress",{max:"1",value:"0",hidden:!0,"aria-label":"Progress of the simulation"}),s=Tn("reset all",()=>{_(null),a[0]?.element.querySelector("input")?.focus()},{disabled:!0}),o=Tn("Save YAML",()=>l&&Po(l.sheet(g()),`${e.fileName}.yaml`,"application/yaml"),{disabled:!0}),a=t.sliders.map(b=>Yx(b,x)),l=null,c=!1,u=0,h=0,f=0,d=!1,p=0,y=!1,g=()=>a.map(b=>b.value),m=()=>a.every(b=>b.value===b.slider.value);function x(){s.disabled=m(),!d||m()?E():h||(h=requestAnimationFrame(w))}function w(){d&&!y&&performance.now()-p<jx?h=requestAnimationFrame(w):E()}function _(b){a.forEach((N,C)=>{N.value=b?b[C]:N.slider.value}),x()}async function E(){if(cancelAnimationFrame(h),h=0,!l)return;let b=u+=1;if(m()){v(),e.show(null),n.textContent="The run as it was.",n.classList.remove("warned"),l.run(g()).catch(()=>{});return}[d,p,y]=[!0,performance.now(),!1],f||(f=window.setTimeout(()=>{i.hidden=!1},jx));try{let N=C=>{b===u&&(i.value=C)};S(await l.run(g(),N,C=>S(C,b)),b)&&v()}catch(N){if(b!==u||c||N instanceof Error&&N.name==="Superseded")return;v(),e.show(null);let C=(N instanceof Error?N.message:String(N)).replace(/\.$/,"");n.textContent=`This could not be simulated: ${C}; shown is the run as it was.`,n.classList.add("warned")}}function S(b,N){if(N!==u||c)return!1;y=!0,e.show(b);let C=b.status==="finished"?"Simulated":`${b.status}: ${b.message}; simulated`;return n.textContent=`${C} in ${qn(b.seconds,"s")}; the run as it was is pale.`,n.classList.toggle("warned",b.status!=="finished"),!0}function v(){d=!1,clearTimeout(f),f=0,i.hidden=!0,i.value=0}return r.append(lt("div",{class:"bar"},lt("h3",{text:"What if"}),s,o),n,i,...gA(a),...yA(t)),e.open(t).then(b=>{if(c)return b.close();l=b,o.disabled=!1,n.textContent="Move a slider to run the simulation again in this page.",m()||x()},b=>{let N=b instanceof Error?b.message:String(b);n.textContent=`Nothing can be changed here, the robot's equations could not be started: ${N}`,a.forEach(C=>C.element.remove()),s.remove()}),{dispose(){c=!0,cancelAnimationFrame(h),v(),l?.close(),r.replaceChildren()}}}function gA(r){return[...new Set(r.map(e=>e.slider.group))].map(e=>lt("fieldset",{},lt("legend",{text:e}),...r.filter(n=>n.slider.group===e).map(n=>n.element)))}function yA(r){let t=r.settings,e=Array.isArray(r.leftOut)?r.leftOut:[];return[...typeof t?.note=="string"&&t.note?[t.note]:[],...e.length?[`Not offered: ${e.map(({path:i,reason:s})=>`${String(i)} (${String(s)})`).join("; ")}.`]:[]].map(i=>lt("p",{class:"note",text:i}))}var xA=[.05,.1,.2,.5,1,2],Qc=1e3,Kx=1/200;function Jx(r,t){let e=Tn("",()=>t.toggle(),{class:"play"}),n=lt("input",{type:"range",min:"0",max:String(Qc),step:"1","aria-label":"Time",class:"scrub"}),[i,s]=[lt("span"),lt("span")],o=lt("output",{class:"time","aria-live":"off"},i,document.createTextNode(" "),s),a=qr("speed"),l=lt("select",{id:a},...xA.map(d=>lt("option",{value:String(d),text:`${d}×`,selected:d===t.speed})));n.addEventListener("input",()=>t.seek(Number(n.value)/Qc*t.duration)),l.addEventListener("change",()=>{t.speed=Number(l.value)});let c=Math.max(3,Math.ceil(-Math.log10(t.duration||1))+3),u=()=>{let d=t.duration>0?t.time/t.duration:0;(document.activeElement!==n||Number(n.value)!==Math.round(d*Qc))&&(n.value=String(Math.round(d*Qc))),n.setAttribute("aria-valuetext",`${t.time.toFixed(c)} s`),i.textContent=`${t.time.toFixed(c)} s`,s.textContent=`of ${Ze(t.duration)} s`;let p=t.playing?"Pause":"Play";e.getAttribute("aria-label")!==p&&(e.setAttribute("aria-label",p),e.title=`${p} (space)`,e.textContent=t.playing?"❚❚":"▶")},h=d=>{if(d.defaultPrevented||d.ctrlKey||d.metaKey||d.altKey||_A(d))return;let y={" ":()=>t.toggle(),ArrowRight:()=>t.seek(t.time+(d.shiftKey?10:1)*Kx*t.duration),ArrowLeft:()=>t.seek(t.time-(d.shiftKey?10:1)*Kx*t.duration)}[d.key];y&&(d.preventDefault(),y())};document.addEventListener("keydown",h),r.append(e,n,o,lt("label",{for:a,text:"speed"}),l);let f=t.subscribe(u);return u(),{dispose(){f(),document.removeEventListener("keydown",h),r.replaceChildren()}}}function _A(r){let t=r.target;return t instanceof HTMLElement?t.isContentEditable||t.closest("input, select, textarea, canvas, [role=tablist]")?!0:r.key===" "?t.closest("button, a, summary")!==null:t.closest(".scroll")!==null:!1}var Fs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ns={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},P_=0,Pp=1,I_=2;var lo=1,L_=2,va=3,Ds=0,mi=1,Qi=2,co=0,ba=1,Ip=2,Lp=3,Fp=4,F_=5;var uo=100,N_=101,D_=102,U_=103,O_=104,k_=200,B_=201,z_=202,V_=203,Np=204,Dp=205,G_=206,H_=207,W_=208,q_=209,X_=210,$_=211,Y_=212,j_=213,Z_=214,Au=0,Eu=1,Tu=2,ua=3,Ru=4,Cu=5,Pu=6,Iu=7,rh=0,K_=1,J_=2,Fr=0,Up=1,Op=2,kp=3,Bp=4,zp=5,Vp=6,Gp=7;var Hp=300,ho=301,wa=302,sh=303,oh=304,Lu=1e3,Pr=1001,Fu=1002,Gn=1003,Q_=1004;var Bl=1005;var pi=1006,ah=1007;var rs=1008;var _i=1009,Wp=1010,qp=1011,Ma=1012,lh=1013,dr=1014,pr=1015,mr=1016,ch=1017,uh=1018,fo=1020,Xp=35902,$p=35899,Yp=1021,jp=1022,gr=1023,ns=1026,ss=1027,Zp=1028,hh=1029,Us=1030,fh=1031;var dh=1033,zl=33776,Vl=33777,Gl=33778,Hl=33779,ph=35840,mh=35841,gh=35842,yh=35843,xh=36196,_h=37492,vh=37496,bh=37488,wh=37489,Wl=37490,Mh=37491,Sh=37808,Ah=37809,Eh=37810,Th=37811,Rh=37812,Ch=37813,Ph=37814,Ih=37815,Lh=37816,Fh=37817,Nh=37818,Dh=37819,Uh=37820,Oh=37821,kh=36492,Bh=36494,zh=36495,Vh=36283,Gh=36284,ql=36285,Hh=36286;var ul=2300,Nu=2301,Mu=2302,Mp=2303,Sp=2400,Ap=2401,Ep=2402;var tv=3200;var Xl=0,ev=1,os="",Ui="srgb",hl="srgb-linear",fl="linear",Ce="srgb";var Su=7680;var nv=519,iv=512,rv=513,sv=514,Kp=515,ov=516,av=517,Jp=518,Qp=519,tm=35044,em=35048;var nm="300 es",Zi=2e3,ha=2001;function vA(r){for(let t=r.length-1;t>=0;--t)if(r[t]>=65535)return!0;return!1}function bA(r){return ArrayBuffer.isView(r)&&!(r instanceof DataView)}function dl(r){return document.createElementNS("http://www.w3.org/1999/xhtml",r)}function lv(){let r=dl("canvas");return r.style.display="block",r}var Qx={},fa=null;function pl(...r){let t="THREE."+r.shift();fa?fa("log",t,...r):console.log(t,...r)}function cv(r){let t=r[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=r[1];e&&e.isStackTrace?r[0]+=" "+e.getLocation():r[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return r}function Zt(...r){r=cv(r);let t="THREE."+r.shift();if(fa)fa("warn",t,...r);else{let e=r[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...r)}}function se(...r){r=cv(r);let t="THREE."+r.shift();if(fa)fa("error",t,...r);else{let e=r[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...r)}}function al(...r){let t=r.join(" ");t in Qx||(Qx[t]=!0,Zt(...r))}function uv(r,t,e){return new Promise(function(n,i){function s(){switch(r.clientWaitSync(t,r.SYNC_FLUSH_COMMANDS_BIT,0)){case r.WAIT_FAILED:i();break;case r.TIMEOUT_EXPIRED:setTimeout(s,e);break;default:n()}}setTimeout(s,e)})}var hv={[Au]:Au,[Tu]:Pu,[Ru]:Ru,[ua]:Cu,[Eu]:Eu,[Pu]:Tu,[Iu]:Iu,[Cu]:ua},ur=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let i=n[t];if(i!==void 0){let s=i.indexOf(e);s!==-1&&i.splice(s,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let i=n.slice(0);for(let s=0,o=i.length;s<o;s++)i[s].call(this,t);t.target=null}}},ni=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],t_=1234567,ll=Math.PI/180,da=180/Math.PI;function Os(){let r=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(ni[r&255]+ni[r>>8&255]+ni[r>>16&255]+ni[r>>24&255]+"-"+ni[t&255]+ni[t>>8&255]+"-"+ni[t>>16&15|64]+ni[t>>24&255]+"-"+ni[e&63|128]+ni[e>>8&255]+"-"+ni[e>>16&255]+ni[e>>24&255]+ni[n&255]+ni[n>>8&255]+ni[n>>16&255]+ni[n>>24&255]).toLowerCase()}function ce(r,t,e){return Math.max(t,Math.min(e,r))}function im(r,t){return(r%t+t)%t}function wA(r,t,e,n,i){return n+(r-t)*(i-n)/(e-t)}function MA(r,t,e){return r!==t?(e-r)/(t-r):0}function cl(r,t,e){return(1-e)*r+e*t}function SA(r,t,e,n){return cl(r,t,1-Math.exp(-e*n))}function AA(r,t=1){return t-Math.abs(im(r,t*2)-t)}function EA(r,t,e){return r<=t?0:r>=e?1:(r=(r-t)/(e-t),r*r*(3-2*r))}function TA(r,t,e){return r<=t?0:r>=e?1:(r=(r-t)/(e-t),r*r*r*(r*(r*6-15)+10))}function RA(r,t){return r+Math.floor(Math.random()*(t-r+1))}function CA(r,t){return r+Math.random()*(t-r)}function PA(r){return r*(.5-Math.random())}function IA(r){r!==void 0&&(t_=r);let t=t_+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function LA(r){return r*ll}function FA(r){return r*da}function NA(r){return r>0&&Number.isInteger(r)&&2**Math.round(Math.log2(r))===r}function DA(r){return Math.pow(2,Math.ceil(Math.log(r)/Math.LN2))}function rm(r){return Math.pow(2,Math.floor(Math.log(r)/Math.LN2))}function UA(r,t,e,n,i){let s=Math.cos,o=Math.sin,a=s(e/2),l=o(e/2),c=s((t+n)/2),u=o((t+n)/2),h=s((t-n)/2),f=o((t-n)/2),d=s((n-t)/2),p=o((n-t)/2);switch(i){case"XYX":r.set(a*u,l*h,l*f,a*c);break;case"YZY":r.set(l*f,a*u,l*h,a*c);break;case"ZXZ":r.set(l*h,l*f,a*u,a*c);break;case"XZX":r.set(a*u,l*p,l*d,a*c);break;case"YXY":r.set(l*d,a*u,l*p,a*c);break;case"ZYZ":r.set(l*p,l*d,a*u,a*c);break;default:Zt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+i)}}function Wh(r){switch(r.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function sm(r,t){if(t.constructor===Float32Array)return r;let e=Wh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(r/e,-1)}function om(r,t){if(t.constructor===Float32Array)return r;let e=Wh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(r*e)}var yr={DEG2RAD:ll,RAD2DEG:da,generateUUID:Os,clamp:ce,euclideanModulo:im,mapLinear:wA,inverseLerp:MA,lerp:cl,damp:SA,pingpong:AA,smoothstep:EA,smootherstep:TA,randInt:RA,randFloat:CA,randFloatSpread:PA,seededRandom:IA,degToRad:LA,radToDeg:FA,isPowerOfTwo:NA,ceilPowerOfTwo:DA,floorPowerOfTwo:rm,setQuaternionFromProperEuler:UA,normalize:om,denormalize:sm},Jt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,i=t.elements;return this.x=i[0]*e+i[3]*n+i[6],this.y=i[1]*e+i[4]*n+i[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ce(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),i=Math.sin(e),s=this.x-t.x,o=this.y-t.y;return this.x=s*n-o*i+t.x,this.y=s*i+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Hn=class{constructor(t=0,e=0,n=0,i=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=i}static slerpFlat(t,e,n,i,s,o,a){let l=n[i+0],c=n[i+1],u=n[i+2],h=n[i+3],f=s[o+0],d=s[o+1],p=s[o+2],y=s[o+3];if(h!==y||l!==f||c!==d||u!==p){let g=l*f+c*d+u*p+h*y;g<0&&(f=-f,d=-d,p=-p,y=-y,g=-g);let m=1-a;if(g<.9995){let x=Math.acos(g),w=Math.sin(x);m=Math.sin(m*x)/w,a=Math.sin(a*x)/w,l=l*m+f*a,c=c*m+d*a,u=u*m+p*a,h=h*m+y*a}else{l=l*m+f*a,c=c*m+d*a,u=u*m+p*a,h=h*m+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,i,s,o){let a=n[i],l=n[i+1],c=n[i+2],u=n[i+3],h=s[o],f=s[o+1],d=s[o+2],p=s[o+3];return t[e]=a*p+u*h+l*d-c*f,t[e+1]=l*p+u*f+c*h-a*d,t[e+2]=c*p+u*d+a*f-l*h,t[e+3]=u*p-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,i){return this._x=t,this._y=e,this._z=n,this._w=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,i=t._y,s=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(i/2),h=a(s/2),f=l(n/2),d=l(i/2),p=l(s/2);switch(o){case"XYZ":this._x=f*u*h+c*d*p,this._y=c*d*h-f*u*p,this._z=c*u*p+f*d*h,this._w=c*u*h-f*d*p;break;case"YXZ":this._x=f*u*h+c*d*p,this._y=c*d*h-f*u*p,this._z=c*u*p-f*d*h,this._w=c*u*h+f*d*p;break;case"ZXY":this._x=f*u*h-c*d*p,this._y=c*d*h+f*u*p,this._z=c*u*p+f*d*h,this._w=c*u*h-f*d*p;break;case"ZYX":this._x=f*u*h-c*d*p,this._y=c*d*h+f*u*p,this._z=c*u*p-f*d*h,this._w=c*u*h+f*d*p;break;case"YZX":this._x=f*u*h+c*d*p,this._y=c*d*h+f*u*p,this._z=c*u*p-f*d*h,this._w=c*u*h-f*d*p;break;case"XZY":this._x=f*u*h-c*d*p,this._y=c*d*h-f*u*p,this._z=c*u*p+f*d*h,this._w=c*u*h+f*d*p;break;default:Zt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,i=Math.sin(n);return this._x=t.x*i,this._y=t.y*i,this._z=t.z*i,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],i=e[4],s=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(s-c)*d,this._z=(o-i)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(i+o)/d,this._z=(s+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-n-h);this._w=(s-c)/d,this._x=(i+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-i)/d,this._x=(s+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ce(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let i=Math.min(1,e/n);return this.slerp(t,i),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,i=t._y,s=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+i*c-s*l,this._y=i*u+o*l+s*a-n*c,this._z=s*u+o*c+n*l-i*a,this._w=o*u-n*a-i*l-s*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,i=t._y,s=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,i=-i,s=-s,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+n*e,this._y=this._y*l+i*e,this._z=this._z*l+s*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+i*e,this._z=this._z*l+s*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),i=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(i*Math.sin(t),i*Math.cos(t),s*Math.sin(e),s*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(e_.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(e_.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,i=this.z,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6]*i,this.y=s[1]*e+s[4]*n+s[7]*i,this.z=s[2]*e+s[5]*n+s[8]*i,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,s=t.elements,o=1/(s[3]*e+s[7]*n+s[11]*i+s[15]);return this.x=(s[0]*e+s[4]*n+s[8]*i+s[12])*o,this.y=(s[1]*e+s[5]*n+s[9]*i+s[13])*o,this.z=(s[2]*e+s[6]*n+s[10]*i+s[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,i=this.z,s=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*i-a*n),u=2*(a*e-s*i),h=2*(s*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-s*h,this.z=i+l*h+s*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,i=this.z,s=t.elements;return this.x=s[0]*e+s[4]*n+s[8]*i,this.y=s[1]*e+s[5]*n+s[9]*i,this.z=s[2]*e+s[6]*n+s[10]*i,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,i=t.y,s=t.z,o=e.x,a=e.y,l=e.z;return this.x=i*l-s*a,this.y=s*o-n*l,this.z=n*a-i*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return ep.copy(this).projectOnVector(t),this.sub(ep)}reflect(t){return this.sub(ep.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ce(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,i=this.z-t.z;return e*e+n*n+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let i=Math.sin(e)*t;return this.x=i*Math.sin(n),this.y=Math.cos(e)*t,this.z=i*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),i=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=i,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ep=new z,e_=new Hn,oe=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,i,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,i,s,o,a,l,c)}set(t,e,n,i,s,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=i,u[2]=a,u[3]=e,u[4]=s,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,s=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],p=n[8],y=i[0],g=i[3],m=i[6],x=i[1],w=i[4],_=i[7],E=i[2],S=i[5],v=i[8];return s[0]=o*y+a*x+l*E,s[3]=o*g+a*w+l*S,s[6]=o*m+a*_+l*v,s[1]=c*y+u*x+h*E,s[4]=c*g+u*w+h*S,s[7]=c*m+u*_+h*v,s[2]=f*y+d*x+p*E,s[5]=f*g+d*w+p*S,s[8]=f*m+d*_+p*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*s*u+n*a*l+i*s*c-i*o*l}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*s,d=c*s-o*l,p=e*h+n*f+i*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=h*y,t[1]=(i*c-u*n)*y,t[2]=(a*n-i*o)*y,t[3]=f*y,t[4]=(u*e-i*l)*y,t[5]=(i*s-a*e)*y,t[6]=d*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*s)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,i,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-i*c,i*l,-i*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return al("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(np.makeScale(t,e)),this}rotate(t){return al("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(np.makeRotation(-t)),this}translate(t,e){return al("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(np.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<9;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},np=new oe,n_=new oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),i_=new oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function OA(){let r={enabled:!0,workingColorSpace:hl,spaces:{},convert:function(i,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Ce&&(i.r=es(i.r),i.g=es(i.g),i.b=es(i.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(i.applyMatrix3(this.spaces[s].toXYZ),i.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ce&&(i.r=ca(i.r),i.g=ca(i.g),i.b=ca(i.b))),i},workingToColorSpace:function(i,s){return this.convert(i,this.workingColorSpace,s)},colorSpaceToWorking:function(i,s){return this.convert(i,s,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===os?fl:this.spaces[i].transfer},getToneMappingMode:function(i){return this.spaces[i].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(i,s=this.workingColorSpace){return i.fromArray(this.spaces[s].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,s,o){return i.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return r.define({[hl]:{primaries:t,whitePoint:n,transfer:fl,toXYZ:n_,fromXYZ:i_,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ui},outputColorSpaceConfig:{drawingBufferColorSpace:Ui}},[Ui]:{primaries:t,whitePoint:n,transfer:Ce,toXYZ:n_,fromXYZ:i_,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ui}}}),r}var _e=OA();function es(r){return r<.04045?r*.0773993808:Math.pow(r*.9478672986+.0521327014,2.4)}function ca(r){return r<.0031308?r*12.92:1.055*Math.pow(r,.41666)-.055}var Yo,Du=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Yo===void 0&&(Yo=dl("canvas")),Yo.width=t.width,Yo.height=t.height;let i=Yo.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),n=Yo}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=dl("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let i=n.getImageData(0,0,t.width,t.height),s=i.data;for(let o=0;o<s.length;o++)s[o]=es(s[o]/255)*255;return n.putImageData(i,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(es(e[n]/255)*255):e[n]=es(e[n]);return{data:e,width:t.width,height:t.height}}else return Zt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},kA=0,pa=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:kA++}),this.uuid=Os(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},i=this.data;if(i!==null){let s;if(Array.isArray(i)){s=[];for(let o=0,a=i.length;o<a;o++)i[o].isDataTexture?s.push(ip(i[o].image)):s.push(ip(i[o]))}else s=ip(i);n.url=s}return e||(t.images[this.uuid]=n),n}};function ip(r){return typeof HTMLImageElement<"u"&&r instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&r instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&r instanceof ImageBitmap?Du.getDataURL(r):r.data?{data:Array.from(r.data),width:r.width,height:r.height,type:r.data.constructor.name}:(Zt("Texture: Unable to serialize Texture."),{})}var BA=0,rp=new z,xi=class r extends ur{constructor(t=r.DEFAULT_IMAGE,e=r.DEFAULT_MAPPING,n=Pr,i=Pr,s=pi,o=rs,a=gr,l=_i,c=r.DEFAULT_ANISOTROPY,u=os){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:BA++}),this.uuid=Os(),this.name="",this.source=new pa(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=i,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Jt(0,0),this.repeat=new Jt(1,1),this.center=new Jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new oe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(rp).x}get height(){return this.source.getSize(rp).y}get depth(){return this.source.getSize(rp).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Zt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){Zt(`Texture.setValues(): property '${e}' does not exist.`);continue}i&&n&&i.isVector2&&n.isVector2||i&&n&&i.isVector3&&n.isVector3||i&&n&&i.isMatrix3&&n.isMatrix3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Hp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Lu:t.x=t.x-Math.floor(t.x);break;case Pr:t.x=t.x<0?0:1;break;case Fu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Lu:t.y=t.y-Math.floor(t.y);break;case Pr:t.y=t.y<0?0:1;break;case Fu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};xi.DEFAULT_IMAGE=null;xi.DEFAULT_MAPPING=Hp;xi.DEFAULT_ANISOTROPY=1;var Pe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,i=1){this.x=t,this.y=e,this.z=n,this.w=i}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,i){return this.x=t,this.y=e,this.z=n,this.w=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,s=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*i+o[12]*s,this.y=o[1]*e+o[5]*n+o[9]*i+o[13]*s,this.z=o[2]*e+o[6]*n+o[10]*i+o[14]*s,this.w=o[3]*e+o[7]*n+o[11]*i+o[15]*s,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,i,s,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],p=l[9],y=l[2],g=l[6],m=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(p+g)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,_=(d+1)/2,E=(m+1)/2,S=(u+f)/4,v=(h+y)/4,b=(p+g)/4;return w>_&&w>E?w<.01?(n=0,i=.707106781,s=.707106781):(n=Math.sqrt(w),i=S/n,s=v/n):_>E?_<.01?(n=.707106781,i=0,s=.707106781):(i=Math.sqrt(_),n=S/i,s=b/i):E<.01?(n=.707106781,i=.707106781,s=0):(s=Math.sqrt(E),n=v/s,i=b/s),this.set(n,i,s,e),this}let x=Math.sqrt((g-p)*(g-p)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(g-p)/x,this.y=(h-y)/x,this.z=(f-u)/x,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this.w=ce(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this.w=ce(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Uu=class extends ur{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:pi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Pe(0,0,t,e),this.scissorTest=!1,this.viewport=new Pe(0,0,t,e),this.textures=[];let i=n.count;for(let s=0;s<i;s++)this.textures[s]=new xi({width:t,height:e,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:pi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let i=0,s=this.textures.length;i<s;i++)this.textures[i].image.width=t,this.textures[i].image.height=e,this.textures[i].image.depth=n,this.textures[i].isData3DTexture!==!0&&(this.textures[i].isArrayTexture=this.textures[i].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let i=Object.assign({},t.textures[e].image);this.textures[e].source=new pa(i)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ki=class extends Uu{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ml=class extends xi{constructor(t=null,e=1,n=1,i=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:i},this.magFilter=Gn,this.minFilter=Gn,this.wrapR=Pr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ou=class extends xi{constructor(t=null,e=1,n=1,i=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:i},this.magFilter=Gn,this.minFilter=Gn,this.wrapR=Pr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ge=class r{static{this.prototype.isMatrix4=!0}constructor(t,e,n,i,s,o,a,l,c,u,h,f,d,p,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,i,s,o,a,l,c,u,h,f,d,p,y,g)}set(t,e,n,i,s,o,a,l,c,u,h,f,d,p,y,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=i,m[1]=s,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=f,m[3]=d,m[7]=p,m[11]=y,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new r().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,i=1/jo.setFromMatrixColumn(t,0).length(),s=1/jo.setFromMatrixColumn(t,1).length(),o=1/jo.setFromMatrixColumn(t,2).length();return e[0]=n[0]*i,e[1]=n[1]*i,e[2]=n[2]*i,e[3]=0,e[4]=n[4]*s,e[5]=n[5]*s,e[6]=n[6]*s,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,i=t.y,s=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(i),c=Math.sin(i),u=Math.cos(s),h=Math.sin(s);if(t.order==="XYZ"){let f=o*u,d=o*h,p=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+p*c,e[5]=f-y*c,e[9]=-a*l,e[2]=y-f*c,e[6]=p+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,d=l*h,p=c*u,y=c*h;e[0]=f+y*a,e[4]=p*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-p,e[6]=y+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*u,d=l*h,p=c*u,y=c*h;e[0]=f-y*a,e[4]=-o*h,e[8]=p+d*a,e[1]=d+p*a,e[5]=o*u,e[9]=y-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,d=o*h,p=a*u,y=a*h;e[0]=l*u,e[4]=p*c-d,e[8]=f*c+y,e[1]=l*h,e[5]=y*c+f,e[9]=d*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,p=a*l,y=a*c;e[0]=l*u,e[4]=y-f*h,e[8]=p*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+p,e[10]=f-y*h}else if(t.order==="XZY"){let f=o*l,d=o*c,p=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+y,e[5]=o*u,e[9]=d*h-p,e[2]=p*h-d,e[6]=a*u,e[10]=y*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(zA,t,VA)}lookAt(t,e,n){let i=this.elements;return Ni.subVectors(t,e),Ni.lengthSq()===0&&(Ni.z=1),Ni.normalize(),vs.crossVectors(n,Ni),vs.lengthSq()===0&&(Math.abs(n.z)===1?Ni.x+=1e-4:Ni.z+=1e-4,Ni.normalize(),vs.crossVectors(n,Ni)),vs.normalize(),tu.crossVectors(Ni,vs),i[0]=vs.x,i[4]=tu.x,i[8]=Ni.x,i[1]=vs.y,i[5]=tu.y,i[9]=Ni.y,i[2]=vs.z,i[6]=tu.z,i[10]=Ni.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,s=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],p=n[2],y=n[6],g=n[10],m=n[14],x=n[3],w=n[7],_=n[11],E=n[15],S=i[0],v=i[4],b=i[8],N=i[12],C=i[1],I=i[5],U=i[9],B=i[13],F=i[2],V=i[6],q=i[10],G=i[14],rt=i[3],$=i[7],j=i[11],tt=i[15];return s[0]=o*S+a*C+l*F+c*rt,s[4]=o*v+a*I+l*V+c*$,s[8]=o*b+a*U+l*q+c*j,s[12]=o*N+a*B+l*G+c*tt,s[1]=u*S+h*C+f*F+d*rt,s[5]=u*v+h*I+f*V+d*$,s[9]=u*b+h*U+f*q+d*j,s[13]=u*N+h*B+f*G+d*tt,s[2]=p*S+y*C+g*F+m*rt,s[6]=p*v+y*I+g*V+m*$,s[10]=p*b+y*U+g*q+m*j,s[14]=p*N+y*B+g*G+m*tt,s[3]=x*S+w*C+_*F+E*rt,s[7]=x*v+w*I+_*V+E*$,s[11]=x*b+w*U+_*q+E*j,s[15]=x*N+w*B+_*G+E*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],i=t[8],s=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],p=t[3],y=t[7],g=t[11],m=t[15],x=l*d-c*f,w=a*d-c*h,_=a*f-l*h,E=o*d-c*u,S=o*f-l*u,v=o*h-a*u;return e*(y*x-g*w+m*_)-n*(p*x-g*E+m*S)+i*(p*w-y*E+m*v)-s*(p*_-y*S+g*v)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],i=t[8],s=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-n*(s*u-a*l)+i*(s*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let i=this.elements;return t.isVector3?(i[12]=t.x,i[13]=t.y,i[14]=t.z):(i[12]=t,i[13]=e,i[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],p=t[12],y=t[13],g=t[14],m=t[15],x=e*a-n*o,w=e*l-i*o,_=e*c-s*o,E=n*l-i*a,S=n*c-s*a,v=i*c-s*l,b=u*y-h*p,N=u*g-f*p,C=u*m-d*p,I=h*g-f*y,U=h*m-d*y,B=f*m-d*g,F=x*B-w*U+_*I+E*C-S*N+v*b;if(F===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/F;return t[0]=(a*B-l*U+c*I)*V,t[1]=(i*U-n*B-s*I)*V,t[2]=(y*v-g*S+m*E)*V,t[3]=(f*S-h*v-d*E)*V,t[4]=(l*C-o*B-c*N)*V,t[5]=(e*B-i*C+s*N)*V,t[6]=(g*_-p*v-m*w)*V,t[7]=(u*v-f*_+d*w)*V,t[8]=(o*U-a*C+c*b)*V,t[9]=(n*C-e*U-s*b)*V,t[10]=(p*S-y*_+m*x)*V,t[11]=(h*_-u*S-d*x)*V,t[12]=(a*N-o*I-l*b)*V,t[13]=(e*I-n*N+i*b)*V,t[14]=(y*w-p*E-g*x)*V,t[15]=(u*E-h*w+f*x)*V,this}scale(t){let e=this.elements,n=t.x,i=t.y,s=t.z;return e[0]*=n,e[4]*=i,e[8]*=s,e[1]*=n,e[5]*=i,e[9]*=s,e[2]*=n,e[6]*=i,e[10]*=s,e[3]*=n,e[7]*=i,e[11]*=s,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],i=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,i))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),i=Math.sin(e),s=1-n,o=t.x,a=t.y,l=t.z,c=s*o,u=s*a;return this.set(c*o+n,c*a-i*l,c*l+i*a,0,c*a+i*l,u*a+n,u*l-i*o,0,c*l-i*a,u*l+i*o,s*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,i,s,o){return this.set(1,n,s,0,t,1,o,0,e,i,1,0,0,0,0,1),this}compose(t,e,n){let i=this.elements,s=e._x,o=e._y,a=e._z,l=e._w,c=s+s,u=o+o,h=a+a,f=s*c,d=s*u,p=s*h,y=o*u,g=o*h,m=a*h,x=l*c,w=l*u,_=l*h,E=n.x,S=n.y,v=n.z;return i[0]=(1-(y+m))*E,i[1]=(d+_)*E,i[2]=(p-w)*E,i[3]=0,i[4]=(d-_)*S,i[5]=(1-(f+m))*S,i[6]=(g+x)*S,i[7]=0,i[8]=(p+w)*v,i[9]=(g-x)*v,i[10]=(1-(f+y))*v,i[11]=0,i[12]=t.x,i[13]=t.y,i[14]=t.z,i[15]=1,this}decompose(t,e,n){let i=this.elements;t.x=i[12],t.y=i[13],t.z=i[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),e.identity(),this;let o=jo.set(i[0],i[1],i[2]).length(),a=jo.set(i[4],i[5],i[6]).length(),l=jo.set(i[8],i[9],i[10]).length();s<0&&(o=-o),ar.copy(this);let c=1/o,u=1/a,h=1/l;return ar.elements[0]*=c,ar.elements[1]*=c,ar.elements[2]*=c,ar.elements[4]*=u,ar.elements[5]*=u,ar.elements[6]*=u,ar.elements[8]*=h,ar.elements[9]*=h,ar.elements[10]*=h,e.setFromRotationMatrix(ar),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,i,s,o,a=Zi,l=!1){let c=this.elements,u=2*s/(e-t),h=2*s/(n-i),f=(e+t)/(e-t),d=(n+i)/(n-i),p,y;if(l)p=s/(o-s),y=o*s/(o-s);else if(a===Zi)p=-(o+s)/(o-s),y=-2*o*s/(o-s);else if(a===ha)p=-o/(o-s),y=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,i,s,o,a=Zi,l=!1){let c=this.elements,u=2/(e-t),h=2/(n-i),f=-(e+t)/(e-t),d=-(n+i)/(n-i),p,y;if(l)p=1/(o-s),y=o/(o-s);else if(a===Zi)p=-2/(o-s),y=-(o+s)/(o-s);else if(a===ha)p=-1/(o-s),y=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<16;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},jo=new z,ar=new Ge,zA=new z(0,0,0),VA=new z(1,1,1),vs=new z,tu=new z,Ni=new z,r_=new Ge,s_=new Hn,Ir=class r{constructor(t=0,e=0,n=0,i=r.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=i}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,i=this._order){return this._x=t,this._y=e,this._z=n,this._order=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let i=t.elements,s=i[0],o=i[4],a=i[8],l=i[1],c=i[5],u=i[9],h=i[2],f=i[6],d=i[10];switch(e){case"XYZ":this._y=Math.asin(ce(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ce(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(ce(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-ce(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ce(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ce(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Zt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return r_.makeRotationFromQuaternion(t),this.setFromRotationMatrix(r_,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return s_.setFromEuler(this),this.setFromQuaternion(s_,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ir.DEFAULT_ORDER="XYZ";var gl=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},GA=0,o_=new z,Zo=new Hn,Zr=new Ge,eu=new z,nl=new z,HA=new z,WA=new Hn,a_=new z(1,0,0),l_=new z(0,1,0),c_=new z(0,0,1),u_={type:"added"},qA={type:"removed"},Ko={type:"childadded",child:null},sp={type:"childremoved",child:null},Yn=class r extends ur{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:GA++}),this.uuid=Os(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=r.DEFAULT_UP.clone();let t=new z,e=new Ir,n=new Hn,i=new z(1,1,1);function s(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:i},modelViewMatrix:{value:new Ge},normalMatrix:{value:new oe}}),this.matrix=new Ge,this.matrixWorld=new Ge,this.matrixAutoUpdate=r.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=r.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new gl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Zo.setFromAxisAngle(t,e),this.quaternion.multiply(Zo),this}rotateOnWorldAxis(t,e){return Zo.setFromAxisAngle(t,e),this.quaternion.premultiply(Zo),this}rotateX(t){return this.rotateOnAxis(a_,t)}rotateY(t){return this.rotateOnAxis(l_,t)}rotateZ(t){return this.rotateOnAxis(c_,t)}translateOnAxis(t,e){return o_.copy(t).applyQuaternion(this.quaternion),this.position.add(o_.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(a_,t)}translateY(t){return this.translateOnAxis(l_,t)}translateZ(t){return this.translateOnAxis(c_,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Zr.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?eu.copy(t):eu.set(t,e,n);let i=this.parent;this.updateWorldMatrix(!0,!1),nl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Zr.lookAt(nl,eu,this.up):Zr.lookAt(eu,nl,this.up),this.quaternion.setFromRotationMatrix(Zr),i&&(Zr.extractRotation(i.matrixWorld),Zo.setFromRotationMatrix(Zr),this.quaternion.premultiply(Zo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(se("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(u_),Ko.child=t,this.dispatchEvent(Ko),Ko.child=null):se("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(qA),sp.child=t,this.dispatchEvent(sp),sp.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Zr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Zr.multiply(t.parent.matrixWorld)),t.applyMatrix4(Zr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(u_),Ko.child=t,this.dispatchEvent(Ko),Ko.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,i=this.children.length;n<i;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let i=this.children;for(let s=0,o=i.length;s<o;s++)i[s].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(nl,t,HA),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(nl,WA,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,i=t.z,s=this.matrix.elements;s[12]+=e-s[0]*e-s[4]*n-s[8]*i,s[13]+=n-s[1]*e-s[5]*n-s[9]*i,s[14]+=i-s[2]*e-s[6]*n-s[10]*i}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let i={};i.uuid=this.uuid,i.type=this.type,i.name=this.name,i.castShadow=this.castShadow,i.receiveShadow=this.receiveShadow,i.visible=this.visible,i.frustumCulled=this.frustumCulled,i.renderOrder=this.renderOrder,i.static=this.static,i.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(i.userData=this.userData),i.layers=this.layers.mask,i.matrix=this.matrix.toArray(),i.up=this.up.toArray(),this.pivot!==null&&(i.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(i.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(i.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(i.type="InstancedMesh",i.count=this.count,i.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(i.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(i.type="BatchedMesh",i.perObjectFrustumCulled=this.perObjectFrustumCulled,i.sortObjects=this.sortObjects,i.drawRanges=this._drawRanges,i.reservedRanges=this._reservedRanges,i.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),i.instanceInfo=this._instanceInfo.map(a=>({...a})),i.availableInstanceIds=this._availableInstanceIds.slice(),i.availableGeometryIds=this._availableGeometryIds.slice(),i.nextIndexStart=this._nextIndexStart,i.nextVertexStart=this._nextVertexStart,i.geometryCount=this._geometryCount,i.maxInstanceCount=this._maxInstanceCount,i.maxVertexCount=this._maxVertexCount,i.maxIndexCount=this._maxIndexCount,i.geometryInitialized=this._geometryInitialized,i.matricesTexture=this._matricesTexture.toJSON(t),i.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(i.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(i.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(i.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?i.background=this.background.toJSON():this.background.isTexture&&(i.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(i.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){i.geometry=s(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(t.shapes,h)}else s(t.shapes,l)}}if(this.isSkinnedMesh&&(i.bindMode=this.bindMode,i.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(t.skeletons,this.skeleton),i.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(t.materials,this.material[l]));i.material=a}else i.material=s(t.materials,this.material);if(this.children.length>0){i.children=[];for(let a=0;a<this.children.length;a++)i.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){i.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];i.animations.push(s(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),p.length>0&&(n.nodes=p)}return n.object=i,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let i=t.children[n];this.add(i.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Yn.DEFAULT_UP=new z(0,1,0);Yn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Yn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Vn=class extends Yn{constructor(){super(),this.isGroup=!0,this.type="Group"}},XA={type:"move"},ma=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Vn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Vn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Vn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let i=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let g=e.getJointPose(y,n),m=this._getHandJoint(c,y);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,p=.005;c.inputState.pinching&&f>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(s=e.getPose(t.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(i=e.getPose(t.targetRaySpace,n),i===null&&s!==null&&(i=s),i!==null&&(a.matrix.fromArray(i.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,i.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(i.linearVelocity)):a.hasLinearVelocity=!1,i.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(i.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(XA)))}return a!==null&&(a.visible=i!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Vn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},fv={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},bs={h:0,s:0,l:0},nu={h:0,s:0,l:0};function op(r,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?r+(t-r)*6*e:e<1/2?t:e<2/3?r+(t-r)*6*(2/3-e):r}var ue=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let i=t;i&&i.isColor?this.copy(i):typeof i=="number"?this.setHex(i):typeof i=="string"&&this.setStyle(i)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ui){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,n,i=_e.workingColorSpace){return this.r=t,this.g=e,this.b=n,_e.colorSpaceToWorking(this,i),this}setHSL(t,e,n,i=_e.workingColorSpace){if(t=im(t,1),e=ce(e,0,1),n=ce(n,0,1),e===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+e):n+e-n*e,o=2*n-s;this.r=op(o,s,t+1/3),this.g=op(o,s,t),this.b=op(o,s,t-1/3)}return _e.colorSpaceToWorking(this,i),this}setStyle(t,e=Ui){function n(s){s!==void 0&&parseFloat(s)<1&&Zt("Color: Alpha component of "+t+" will be ignored.")}let i;if(i=/^(\w+)\(([^\)]*)\)/.exec(t)){let s,o=i[1],a=i[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,e);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,e);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,e);break;default:Zt("Color: Unknown color model "+t)}}else if(i=/^\#([A-Fa-f\d]+)$/.exec(t)){let s=i[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(s,16),e);Zt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ui){let n=fv[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Zt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=es(t.r),this.g=es(t.g),this.b=es(t.b),this}copyLinearToSRGB(t){return this.r=ca(t.r),this.g=ca(t.g),this.b=ca(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ui){return _e.workingToColorSpace(ii.copy(this),t),Math.round(ce(ii.r*255,0,255))*65536+Math.round(ce(ii.g*255,0,255))*256+Math.round(ce(ii.b*255,0,255))}getHexString(t=Ui){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace(ii.copy(this),e);let n=ii.r,i=ii.g,s=ii.b,o=Math.max(n,i,s),a=Math.min(n,i,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(i-s)/h+(i<s?6:0);break;case i:l=(s-n)/h+2;break;case s:l=(n-i)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=_e.workingColorSpace){return _e.workingToColorSpace(ii.copy(this),e),t.r=ii.r,t.g=ii.g,t.b=ii.b,t}getStyle(t=Ui){_e.workingToColorSpace(ii.copy(this),t);let e=ii.r,n=ii.g,i=ii.b;return t!==Ui?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${i.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(i*255)})`}offsetHSL(t,e,n){return this.getHSL(bs),this.setHSL(bs.h+t,bs.s+e,bs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(bs),t.getHSL(nu);let n=cl(bs.h,nu.h,e),i=cl(bs.s,nu.s,e),s=cl(bs.l,nu.l,e);return this.setHSL(n,i,s),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,i=this.b,s=t.elements;return this.r=s[0]*e+s[3]*n+s[6]*i,this.g=s[1]*e+s[4]*n+s[7]*i,this.b=s[2]*e+s[5]*n+s[8]*i,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ii=new ue;ue.NAMES=fv;var yl=class extends Yn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ir,this.environmentIntensity=1,this.environmentRotation=new Ir,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},lr=new z,Kr=new z,ap=new z,Jr=new z,Jo=new z,Qo=new z,h_=new z,lp=new z,cp=new z,up=new z,hp=new Pe,fp=new Pe,dp=new Pe,As=class r{constructor(t=new z,e=new z,n=new z){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,i){i.subVectors(n,e),lr.subVectors(t,e),i.cross(lr);let s=i.lengthSq();return s>0?i.multiplyScalar(1/Math.sqrt(s)):i.set(0,0,0)}static getBarycoord(t,e,n,i,s){lr.subVectors(i,e),Kr.subVectors(n,e),ap.subVectors(t,e);let o=lr.dot(lr),a=lr.dot(Kr),l=lr.dot(ap),c=Kr.dot(Kr),u=Kr.dot(ap),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,p=(o*u-a*l)*f;return s.set(1-d-p,p,d)}static containsPoint(t,e,n,i){return this.getBarycoord(t,e,n,i,Jr)===null?!1:Jr.x>=0&&Jr.y>=0&&Jr.x+Jr.y<=1}static getInterpolation(t,e,n,i,s,o,a,l){return this.getBarycoord(t,e,n,i,Jr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Jr.x),l.addScaledVector(o,Jr.y),l.addScaledVector(a,Jr.z),l)}static getInterpolatedAttribute(t,e,n,i,s,o){return hp.setScalar(0),fp.setScalar(0),dp.setScalar(0),hp.fromBufferAttribute(t,e),fp.fromBufferAttribute(t,n),dp.fromBufferAttribute(t,i),o.setScalar(0),o.addScaledVector(hp,s.x),o.addScaledVector(fp,s.y),o.addScaledVector(dp,s.z),o}static isFrontFacing(t,e,n,i){return lr.subVectors(n,e),Kr.subVectors(t,e),lr.cross(Kr).dot(i)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,i){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[i]),this}setFromAttributeAndIndices(t,e,n,i){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,i),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return lr.subVectors(this.c,this.b),Kr.subVectors(this.a,this.b),lr.cross(Kr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return r.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return r.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,i,s){return r.getInterpolation(t,this.a,this.b,this.c,e,n,i,s)}containsPoint(t){return r.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return r.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,i=this.b,s=this.c,o,a;Jo.subVectors(i,n),Qo.subVectors(s,n),lp.subVectors(t,n);let l=Jo.dot(lp),c=Qo.dot(lp);if(l<=0&&c<=0)return e.copy(n);cp.subVectors(t,i);let u=Jo.dot(cp),h=Qo.dot(cp);if(u>=0&&h<=u)return e.copy(i);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(n).addScaledVector(Jo,o);up.subVectors(t,s);let d=Jo.dot(up),p=Qo.dot(up);if(p>=0&&d<=p)return e.copy(s);let y=d*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(Qo,a);let g=u*p-d*h;if(g<=0&&h-u>=0&&d-p>=0)return h_.subVectors(s,i),a=(h-u)/(h-u+(d-p)),e.copy(i).addScaledVector(h_,a);let m=1/(g+y+f);return o=y*m,a=f*m,e.copy(n).addScaledVector(Jo,o).addScaledVector(Qo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},jn=class{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(cr.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(cr.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=cr.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let s=n.getAttribute("position");if(e===!0&&s!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,cr):cr.fromBufferAttribute(s,o),cr.applyMatrix4(t.matrixWorld),this.expandByPoint(cr);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),iu.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),iu.copy(n.boundingBox)),iu.applyMatrix4(t.matrixWorld),this.union(iu)}let i=t.children;for(let s=0,o=i.length;s<o;s++)this.expandByObject(i[s],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,cr),cr.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(il),ru.subVectors(this.max,il),ta.subVectors(t.a,il),ea.subVectors(t.b,il),na.subVectors(t.c,il),ws.subVectors(ea,ta),Ms.subVectors(na,ea),to.subVectors(ta,na);let e=[0,-ws.z,ws.y,0,-Ms.z,Ms.y,0,-to.z,to.y,ws.z,0,-ws.x,Ms.z,0,-Ms.x,to.z,0,-to.x,-ws.y,ws.x,0,-Ms.y,Ms.x,0,-to.y,to.x,0];return!pp(e,ta,ea,na,ru)||(e=[1,0,0,0,1,0,0,0,1],!pp(e,ta,ea,na,ru))?!1:(su.crossVectors(ws,Ms),e=[su.x,su.y,su.z],pp(e,ta,ea,na,ru))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,cr).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(cr).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Qr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Qr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Qr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Qr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Qr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Qr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Qr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Qr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Qr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Qr=[new z,new z,new z,new z,new z,new z,new z,new z],cr=new z,iu=new jn,ta=new z,ea=new z,na=new z,ws=new z,Ms=new z,to=new z,il=new z,ru=new z,su=new z,eo=new z;function pp(r,t,e,n,i){for(let s=0,o=r.length-3;s<=o;s+=3){eo.fromArray(r,s);let a=i.x*Math.abs(eo.x)+i.y*Math.abs(eo.y)+i.z*Math.abs(eo.z),l=t.dot(eo),c=e.dot(eo),u=n.dot(eo);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Sn=new z,ou=new Jt,$A=0,un=class extends ur{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:$A++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=tm,this.updateRanges=[],this.gpuType=pr,this.version=0,this._normalizationScale=t!==void 0?Wh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let i=0,s=this.itemSize;i<s;i++)this.array[t+i]=e.array[n+i];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)ou.fromBufferAttribute(this,e),ou.applyMatrix3(t),this.setXY(e,ou.x,ou.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Sn.fromBufferAttribute(this,e),Sn.applyMatrix3(t),this.setXYZ(e,Sn.x,Sn.y,Sn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Sn.fromBufferAttribute(this,e),Sn.applyMatrix4(t),this.setXYZ(e,Sn.x,Sn.y,Sn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Sn.fromBufferAttribute(this,e),Sn.applyNormalMatrix(t),this.setXYZ(e,Sn.x,Sn.y,Sn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Sn.fromBufferAttribute(this,e),Sn.transformDirection(t),this.setXYZ(e,Sn.x,Sn.y,Sn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this}setXYZW(t,e,n,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this.array[t+3]=s,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):sm(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):om(t,this.array)}};var xl=class extends un{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var _l=class extends un{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var He=class extends un{constructor(t,e,n){super(new Float32Array(t),e,n)}},YA=new jn,rl=new z,mp=new z,hr=class{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):YA.setFromPoints(t).getCenter(n);let i=0;for(let s=0,o=t.length;s<o;s++)i=Math.max(i,n.distanceToSquared(t[s]));return this.radius=Math.sqrt(i),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;rl.subVectors(t,this.center);let e=rl.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),i=(n-this.radius)*.5;this.center.addScaledVector(rl,i/n),this.radius+=i}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(mp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(rl.copy(t.center).add(mp)),this.expandByPoint(rl.copy(t.center).sub(mp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},jA=0,ji=new Ge,gp=new Yn,ia=new z,Di=new jn,sl=new jn,zn=new z,hn=class r extends ur{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:jA++}),this.uuid=Os(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(vA(t)?_l:xl)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new oe().getNormalMatrix(t);n.applyNormalMatrix(s),n.needsUpdate=!0}let i=this.attributes.tangent;return i!==void 0&&(i.transformDirection(t),i.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return ji.makeRotationFromQuaternion(t),this.applyMatrix4(ji),this}rotateX(t){return ji.makeRotationX(t),this.applyMatrix4(ji),this}rotateY(t){return ji.makeRotationY(t),this.applyMatrix4(ji),this}rotateZ(t){return ji.makeRotationZ(t),this.applyMatrix4(ji),this}translate(t,e,n){return ji.makeTranslation(t,e,n),this.applyMatrix4(ji),this}scale(t,e,n){return ji.makeScale(t,e,n),this.applyMatrix4(ji),this}lookAt(t){return gp.lookAt(t),gp.updateMatrix(),this.applyMatrix4(gp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ia).negate(),this.translate(ia.x,ia.y,ia.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let i=0,s=t.length;i<s;i++){let o=t[i];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new He(n,3))}else{let n=Math.min(t.length,e.count);for(let i=0;i<n;i++){let s=t[i];e.setXYZ(i,s.x,s.y,s.z||0)}t.length>e.count&&Zt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new jn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,i=e.length;n<i;n++){let s=e[n];Di.setFromBufferAttribute(s),this.morphTargetsRelative?(zn.addVectors(this.boundingBox.min,Di.min),this.boundingBox.expandByPoint(zn),zn.addVectors(this.boundingBox.max,Di.max),this.boundingBox.expandByPoint(zn)):(this.boundingBox.expandByPoint(Di.min),this.boundingBox.expandByPoint(Di.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&se('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new hr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){let n=this.boundingSphere.center;if(Di.setFromBufferAttribute(t),e)for(let s=0,o=e.length;s<o;s++){let a=e[s];sl.setFromBufferAttribute(a),this.morphTargetsRelative?(zn.addVectors(Di.min,sl.min),Di.expandByPoint(zn),zn.addVectors(Di.max,sl.max),Di.expandByPoint(zn)):(Di.expandByPoint(sl.min),Di.expandByPoint(sl.max))}Di.getCenter(n);let i=0;for(let s=0,o=t.count;s<o;s++)zn.fromBufferAttribute(t,s),i=Math.max(i,n.distanceToSquared(zn));if(e)for(let s=0,o=e.length;s<o;s++){let a=e[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)zn.fromBufferAttribute(a,c),l&&(ia.fromBufferAttribute(t,c),zn.add(ia)),i=Math.max(i,n.distanceToSquared(zn))}this.boundingSphere.radius=Math.sqrt(i),isNaN(this.boundingSphere.radius)&&se('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){se("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,i=e.normal,s=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new un(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let N=0;N<n.count;N++)a[N]=new z,l[N]=new z;let u=new z,h=new z,f=new z,d=new Jt,p=new Jt,y=new Jt,g=new z,m=new z;function x(N,C,I){c[N]=c[C]=c[I]=1,u.fromBufferAttribute(n,N),h.fromBufferAttribute(n,C),f.fromBufferAttribute(n,I),d.fromBufferAttribute(s,N),p.fromBufferAttribute(s,C),y.fromBufferAttribute(s,I),h.sub(u),f.sub(u),p.sub(d),y.sub(d);let U=1/(p.x*y.y-y.x*p.y);isFinite(U)&&(g.copy(h).multiplyScalar(y.y).addScaledVector(f,-p.y).multiplyScalar(U),m.copy(f).multiplyScalar(p.x).addScaledVector(h,-y.x).multiplyScalar(U),a[N].add(g),a[C].add(g),a[I].add(g),l[N].add(m),l[C].add(m),l[I].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let N=0,C=w.length;N<C;++N){let I=w[N],U=I.start,B=I.count;for(let F=U,V=U+B;F<V;F+=3)x(t.getX(F+0),t.getX(F+1),t.getX(F+2))}let _=new z,E=new z,S=new z,v=new z;function b(N){S.fromBufferAttribute(i,N),v.copy(S);let C=a[N];_.copy(C),_.sub(S.multiplyScalar(S.dot(C))).normalize(),E.crossVectors(v,C);let U=E.dot(l[N])<0?-1:1;o.setXYZW(N,_.x,_.y,_.z,U)}for(let N=0,C=n.count;N<C;++N)c[N]&&b(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new un(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let i=new z,s=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(t)for(let f=0,d=t.count;f<d;f+=3){let p=t.getX(f+0),y=t.getX(f+1),g=t.getX(f+2);i.fromBufferAttribute(e,p),s.fromBufferAttribute(e,y),o.fromBufferAttribute(e,g),u.subVectors(o,s),h.subVectors(i,s),u.cross(h),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)i.fromBufferAttribute(e,f+0),s.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,s),h.subVectors(i,s),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)zn.fromBufferAttribute(t,e),zn.normalize(),t.setXYZ(e,zn.x,zn.y,zn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,p=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let m=0;m<u;m++)f[p++]=c[d++]}return new un(f,u,h)}if(this.index===null)return Zt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new r,n=this.index.array,i=this.attributes;for(let a in i){let l=i[a],c=t(l,n);e.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let i={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(i[l]=u,s=!0)}s&&(t.data.morphAttributes=i,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let i=t.attributes;for(let c in i){let u=i[c];this.setAttribute(c,u.clone(e))}let s=t.morphAttributes;for(let c in s){let u=[],h=s[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},vl=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=tm,this.updateRanges=[],this.version=0,this.uuid=Os()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let i=0,s=this.stride;i<s;i++)this.array[t+i]=e.array[n+i];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=f_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),i=new this.constructor(n,this.stride);return i.setUsage(this.usage),i}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=f_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function f_(r){return r.buffer._uuid===void 0&&(r.buffer._uuid=Os()),r.byteOffset===0&&r.byteLength===r.buffer.byteLength?r.buffer._uuid:r.buffer._uuid+":"+r.byteOffset+":"+r.byteLength}var di=new z,Ki=class r{constructor(t,e,n,i=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=i,this._normalizationScale=t!==void 0?Wh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)di.fromBufferAttribute(this,e),di.applyMatrix4(t),this.setXYZ(e,di.x,di.y,di.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)di.fromBufferAttribute(this,e),di.applyNormalMatrix(t),this.setXYZ(e,di.x,di.y,di.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)di.fromBufferAttribute(this,e),di.transformDirection(t),this.setXYZ(e,di.x,di.y,di.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=i,this}setXYZW(t,e,n,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=i,this.data.array[t+3]=s,this}clone(t){if(t===void 0){pl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let i=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)e.push(this.data.array[i+s])}return new un(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new r(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){pl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let i=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)e.push(this.data.array[i+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):sm(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):om(t,this.data.array)}},yp=new z,ZA=new z,KA=new oe,Oi=class{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,i){return this.normal.set(t,e,n),this.constant=i,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let i=yp.subVectors(n,e).cross(ZA.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(i,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let i=t.delta(yp),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/s;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(i,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||KA.getNormalMatrix(t),i=this.coplanarPoint(yp).applyMatrix4(t),s=this.normal.applyMatrix3(n).normalize();return this.constant=-i.dot(s),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},JA=0,fr=class extends ur{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:JA++}),this.uuid=Os(),this.name="",this.type="Material",this.blending=ba,this.side=Ds,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Np,this.blendDst=Dp,this.blendEquation=uo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ue(0,0,0),this.blendAlpha=0,this.depthFunc=ua,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=nv,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Su,this.stencilZFail=Su,this.stencilZPass=Su,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Zt(`Material: parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){Zt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}i&&i.isColor?i.set(n):i&&i.isVector2&&n&&n.isVector2||i&&i.isEuler&&n&&n.isEuler||i&&i.isVector3&&n&&n.isVector3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function i(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(e){let s=i(t.textures),o=i(t.images);s.length>0&&(n.textures=s),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ue().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Oi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Jt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let i=e.length;n=new Array(i);for(let s=0;s!==i;++s)n[s]=e[s].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ts=new z,xp=new z,au=new z,lu=new z,ro=class{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ts)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ts.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ts.copy(this.origin).addScaledVector(this.direction,e),ts.distanceToSquared(t))}distanceSqToSegment(t,e,n,i){xp.copy(t).add(e).multiplyScalar(.5),au.copy(e).sub(t).normalize(),lu.copy(this.origin).sub(xp);let s=t.distanceTo(e)*.5,o=-this.direction.dot(au),a=lu.dot(this.direction),l=-lu.dot(au),c=lu.lengthSq(),u=Math.abs(1-o*o),h,f,d,p;if(u>0)if(h=o*l-a,f=o*a-l,p=s*u,h>=0)if(f>=-p)if(f<=p){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-p?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c):f<=p?(h=0,f=Math.min(Math.max(-s,-l),s),d=f*(f+2*l)+c):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),i&&i.copy(xp).addScaledVector(au,f),d}intersectSphere(t,e){if(t.radius<0)return null;ts.subVectors(t.center,this.origin);let n=ts.dot(this.direction),i=ts.dot(ts)-n*n,s=t.radius*t.radius;if(i>s)return null;let o=Math.sqrt(s-i),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,i,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,i=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,i=(t.min.x-f.x)*c),u>=0?(s=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(s=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||s>i||((s>n||isNaN(n))&&(n=s),(o<i||isNaN(i))&&(i=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>i)||((a>n||n!==n)&&(n=a),(l<i||i!==i)&&(i=l),i<0)?null:this.at(n>=0?n:i,e)}intersectsBox(t){return this.intersectBox(t,ts)!==null}intersectTriangle(t,e,n,i,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,f=t.y-o.y,d=t.z-o.z,p=e.x-o.x,y=e.y-o.y,g=e.z-o.z,m=n.x-o.x,x=n.y-o.y,w=n.z-o.z,_=Math.abs(l),E=Math.abs(c),S=Math.abs(u),v,b,N,C,I,U,B,F,V,q,G,rt;if(_>=E&&_>=S?(N=l,U=h,V=p,rt=m,l>=0?(v=c,b=u,C=f,I=d,B=y,F=g,q=x,G=w):(v=u,b=c,C=d,I=f,B=g,F=y,q=w,G=x)):E>=S?(N=c,U=f,V=y,rt=x,c>=0?(v=u,b=l,C=d,I=h,B=g,F=p,q=w,G=m):(v=l,b=u,C=h,I=d,B=p,F=g,q=m,G=w)):(N=u,U=d,V=g,rt=w,u>=0?(v=l,b=c,C=h,I=f,B=p,F=y,q=m,G=x):(v=c,b=l,C=f,I=h,B=y,F=p,q=x,G=m)),N===0)return null;let $=v/N,j=b/N,tt=1/N,ut=C-$*U,ct=I-j*U,J=B-$*V,gt=F-j*V,yt=q-$*rt,Mt=G-j*rt,xt=yt*gt-Mt*J,zt=ut*Mt-ct*yt,te=J*ct-gt*ut;if(i){if(xt<0||zt<0||te<0)return null}else if((xt<0||zt<0||te<0)&&(xt>0||zt>0||te>0))return null;let dt=xt+zt+te;if(dt===0)return null;let Wt=tt*(xt*U+zt*V+te*rt);return(dt>0?Wt<0:Wt>0)?null:this.at(Wt/dt,s)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ga=class extends fr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ir,this.combine=rh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},d_=new Ge,no=new ro,cu=new hr,p_=new z,uu=new z,hu=new z,fu=new z,_p=new z,du=new z,m_=new z,pu=new z,We=class extends Yn{constructor(t=new hn,e=new ga){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let i=e[n[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=i.length;s<o;s++){let a=i[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(t,e){let n=this.geometry,i=n.attributes.position,s=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(i,t);let a=this.morphTargetInfluences;if(s&&a){du.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(_p.fromBufferAttribute(h,t),o?du.addScaledVector(_p,u):du.addScaledVector(_p.sub(e),u))}e.add(du)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,i=this.material,s=this.matrixWorld;i!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),cu.copy(n.boundingSphere),cu.applyMatrix4(s),no.copy(t.ray).recast(t.near),!(cu.containsPoint(no.origin)===!1&&(no.intersectSphere(cu,p_)===null||no.origin.distanceToSquared(p_)>(t.far-t.near)**2))&&(d_.copy(s).invert(),no.copy(t.ray).applyMatrix4(d_),!(n.boundingBox!==null&&no.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,no)))}_computeIntersections(t,e,n){let i,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=f.length;p<y;p++){let g=f[p],m=o[g.materialIndex],x=Math.max(g.start,d.start),w=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let _=x,E=w;_<E;_+=3){let S=a.getX(_),v=a.getX(_+1),b=a.getX(_+2);i=mu(this,m,t,n,c,u,h,S,v,b),i&&(i.faceIndex=Math.floor(_/3),i.face.materialIndex=g.materialIndex,e.push(i))}}else{let p=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let g=p,m=y;g<m;g+=3){let x=a.getX(g),w=a.getX(g+1),_=a.getX(g+2);i=mu(this,o,t,n,c,u,h,x,w,_),i&&(i.faceIndex=Math.floor(g/3),e.push(i))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=f.length;p<y;p++){let g=f[p],m=o[g.materialIndex],x=Math.max(g.start,d.start),w=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let _=x,E=w;_<E;_+=3){let S=_,v=_+1,b=_+2;i=mu(this,m,t,n,c,u,h,S,v,b),i&&(i.faceIndex=Math.floor(_/3),i.face.materialIndex=g.materialIndex,e.push(i))}}else{let p=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let g=p,m=y;g<m;g+=3){let x=g,w=g+1,_=g+2;i=mu(this,o,t,n,c,u,h,x,w,_),i&&(i.faceIndex=Math.floor(g/3),e.push(i))}}}};function QA(r,t,e,n,i,s,o,a){let l;if(t.side===mi?l=n.intersectTriangle(o,s,i,!0,a):l=n.intersectTriangle(i,s,o,t.side===Ds,a),l===null)return null;pu.copy(a),pu.applyMatrix4(r.matrixWorld);let c=e.ray.origin.distanceTo(pu);return c<e.near||c>e.far?null:{distance:c,point:pu.clone(),object:r}}function mu(r,t,e,n,i,s,o,a,l,c){r.getVertexPosition(a,uu),r.getVertexPosition(l,hu),r.getVertexPosition(c,fu);let u=QA(r,t,e,n,uu,hu,fu,m_);if(u){let h=new z;As.getBarycoord(m_,uu,hu,fu,h),i&&(u.uv=As.getInterpolatedAttribute(i,a,l,c,h,new Jt)),s&&(u.uv1=As.getInterpolatedAttribute(s,a,l,c,h,new Jt)),o&&(u.normal=As.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new z,materialIndex:0};As.getNormal(uu,hu,fu,f.normal),u.face=f,u.barycoord=h}return u}var ku=class extends xi{constructor(t=null,e=1,n=1,i,s,o,a,l,c=Gn,u=Gn,h,f){super(null,o,a,l,c,u,i,s,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var io=new hr,tE=new Jt(.5,.5),gu=new z,Es=class{constructor(t=new Oi,e=new Oi,n=new Oi,i=new Oi,s=new Oi,o=new Oi){this.planes=[t,e,n,i,s,o]}set(t,e,n,i,s,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(i),a[4].copy(s),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Zi,n=!1){let i=this.planes,s=t.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],f=s[6],d=s[7],p=s[8],y=s[9],g=s[10],m=s[11],x=s[12],w=s[13],_=s[14],E=s[15];if(i[0].setComponents(c-o,d-u,m-p,E-x).normalize(),i[1].setComponents(c+o,d+u,m+p,E+x).normalize(),i[2].setComponents(c+a,d+h,m+y,E+w).normalize(),i[3].setComponents(c-a,d-h,m-y,E-w).normalize(),n)i[4].setComponents(l,f,g,_).normalize(),i[5].setComponents(c-l,d-f,m-g,E-_).normalize();else if(i[4].setComponents(c-l,d-f,m-g,E-_).normalize(),e===Zi)i[5].setComponents(c+l,d+f,m+g,E+_).normalize();else if(e===ha)i[5].setComponents(l,f,g,_).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),io.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),io.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(io)}intersectsSprite(t){io.center.set(0,0,0);let e=tE.distanceTo(t.center);return io.radius=.7071067811865476+e,io.applyMatrix4(t.matrixWorld),this.intersectsSphere(io)}intersectsSphere(t){let e=this.planes,n=t.center,i=-t.radius;for(let s=0;s<6;s++)if(e[s].distanceToPoint(n)<i)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let i=e[n];if(gu.x=i.normal.x>0?t.max.x:t.min.x,gu.y=i.normal.y>0?t.max.y:t.min.y,gu.z=i.normal.z>0?t.max.z:t.min.z,i.distanceToPoint(gu)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},g_=new Ge,Bu=class r{constructor(){this.coordinateSystem=Zi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let i=0;i<e.length;i++){let s=e[i];g_.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[i]===void 0&&(n[i]=new Es),n[i].setFromProjectionMatrix(g_,s.coordinateSystem,s.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let i=0;i<t._count;i++)e[i]===void 0&&(e[i]=new Es),e[i].copy(n[i]);return this._count=t._count,this}clone(){return new r().copy(this)}};var ya=class extends fr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ue(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},zu=new z,Vu=new z,y_=new Ge,ol=new ro,yu=new hr,vp=new z,x_=new z,xa=class extends Yn{constructor(t=new hn,e=new ya){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let i=1,s=e.count;i<s;i++)zu.fromBufferAttribute(e,i-1),Vu.fromBufferAttribute(e,i),n[i]=n[i-1],n[i]+=zu.distanceTo(Vu);t.setAttribute("lineDistance",new He(n,1))}else Zt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,i=this.matrixWorld,s=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),yu.copy(n.boundingSphere),yu.applyMatrix4(i),yu.radius+=s,t.ray.intersectsSphere(yu)===!1)return;y_.copy(i).invert(),ol.copy(t.ray).applyMatrix4(y_);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=d,g=p-1;y<g;y+=c){let m=u.getX(y),x=u.getX(y+1),w=xu(this,t,ol,l,m,x,y);w&&e.push(w)}if(this.isLineLoop){let y=u.getX(p-1),g=u.getX(d),m=xu(this,t,ol,l,y,g,p-1);m&&e.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let y=d,g=p-1;y<g;y+=c){let m=xu(this,t,ol,l,y,y+1,y);m&&e.push(m)}if(this.isLineLoop){let y=xu(this,t,ol,l,p-1,d,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let i=e[n[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=i.length;s<o;s++){let a=i[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function xu(r,t,e,n,i,s,o){let a=r.geometry.attributes.position;if(zu.fromBufferAttribute(a,i),Vu.fromBufferAttribute(a,s),e.distanceSqToSegment(zu,Vu,vp,x_)>n)return;vp.applyMatrix4(r.matrixWorld);let c=t.ray.origin.distanceTo(vp);if(!(c<t.near||c>t.far))return{distance:c,point:x_.clone().applyMatrix4(r.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:r}}var __=new z,v_=new z,Gu=class extends xa{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let i=0,s=e.count;i<s;i+=2)__.fromBufferAttribute(e,i),v_.fromBufferAttribute(e,i+1),n[i]=i===0?0:n[i-1],n[i+1]=n[i]+__.distanceTo(v_);t.setAttribute("lineDistance",new He(n,1))}else Zt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var bl=class extends xi{constructor(t=[],e=ho,n,i,s,o,a,l,c,u){super(t,e,n,i,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var is=class extends xi{constructor(t,e,n=dr,i,s,o,a=Gn,l=Gn,c,u=ns,h=1){if(u!==ns&&u!==ss)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,i,s,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new pa(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},wl=class extends is{constructor(t,e=dr,n=ho,i,s,o=Gn,a=Gn,l,c=ns){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,n,i,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ml=class extends xi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ts=class r extends hn{constructor(t=1,e=1,n=1,i=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:i,heightSegments:s,depthSegments:o};let a=this;i=Math.floor(i),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;p("z","y","x",-1,-1,n,e,t,o,s,0),p("z","y","x",1,-1,n,e,-t,o,s,1),p("x","z","y",1,1,t,n,e,i,o,2),p("x","z","y",1,-1,t,n,-e,i,o,3),p("x","y","z",1,-1,t,e,n,i,s,4),p("x","y","z",-1,-1,t,e,-n,i,s,5),this.setIndex(l),this.setAttribute("position",new He(c,3)),this.setAttribute("normal",new He(u,3)),this.setAttribute("uv",new He(h,2));function p(y,g,m,x,w,_,E,S,v,b,N){let C=_/v,I=E/b,U=_/2,B=E/2,F=S/2,V=v+1,q=b+1,G=0,rt=0,$=new z;for(let j=0;j<q;j++){let tt=j*I-B;for(let ut=0;ut<V;ut++){let ct=ut*C-U;$[y]=ct*x,$[g]=tt*w,$[m]=F,c.push($.x,$.y,$.z),$[y]=0,$[g]=0,$[m]=S>0?1:-1,u.push($.x,$.y,$.z),h.push(ut/v),h.push(1-j/b),G+=1}}for(let j=0;j<b;j++)for(let tt=0;tt<v;tt++){let ut=f+tt+V*j,ct=f+tt+V*(j+1),J=f+(tt+1)+V*(j+1),gt=f+(tt+1)+V*j;l.push(ut,ct,gt),l.push(ct,J,gt),rt+=6}a.addGroup(d,rt,N),d+=rt,f+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new r(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Lr=class r extends hn{constructor(t=1,e=1,n=1,i=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:i,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;i=Math.floor(i),s=Math.floor(s);let u=[],h=[],f=[],d=[],p=0,y=[],g=n/2,m=0;x(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new He(h,3)),this.setAttribute("normal",new He(f,3)),this.setAttribute("uv",new He(d,2));function x(){let _=new z,E=new z,S=0,v=(e-t)/n;for(let b=0;b<=s;b++){let N=[],C=b/s,I=C*(e-t)+t;for(let U=0;U<=i;U++){let B=U/i,F=B*l+a,V=Math.sin(F),q=Math.cos(F);E.x=I*V,E.y=-C*n+g,E.z=I*q,h.push(E.x,E.y,E.z),_.set(V,v,q).normalize(),f.push(_.x,_.y,_.z),d.push(B,1-C),N.push(p++)}y.push(N)}for(let b=0;b<i;b++)for(let N=0;N<s;N++){let C=y[N][b],I=y[N+1][b],U=y[N+1][b+1],B=y[N][b+1];(t>0||N!==0)&&(u.push(C,I,B),S+=3),(e>0||N!==s-1)&&(u.push(I,U,B),S+=3)}c.addGroup(m,S,0),m+=S}function w(_){let E=p,S=new Jt,v=new z,b=0,N=_===!0?t:e,C=_===!0?1:-1;for(let U=1;U<=i;U++)h.push(0,g*C,0),f.push(0,C,0),d.push(.5,.5),p++;let I=p;for(let U=0;U<=i;U++){let F=U/i*l+a,V=Math.cos(F),q=Math.sin(F);v.x=N*q,v.y=g*C,v.z=N*V,h.push(v.x,v.y,v.z),f.push(0,C,0),S.x=V*.5+.5,S.y=q*.5*C+.5,d.push(S.x,S.y),p++}for(let U=0;U<i;U++){let B=E+U,F=I+U;_===!0?u.push(F,F+1,B):u.push(F+1,F,B),b+=3}c.addGroup(m,b,_===!0?1:2),m+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new r(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Sl=class r extends Lr{constructor(t=1,e=1,n=32,i=1,s=!1,o=0,a=Math.PI*2){super(0,t,e,n,i,s,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:i,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(t){return new r(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var so=class r extends hn{constructor(t=1,e=1,n=1,i=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:i};let s=t/2,o=e/2,a=Math.floor(n),l=Math.floor(i),c=a+1,u=l+1,h=t/a,f=e/l,d=[],p=[],y=[],g=[];for(let m=0;m<u;m++){let x=m*f-o;for(let w=0;w<c;w++){let _=w*h-s;p.push(_,-x,0),y.push(0,0,1),g.push(w/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let w=x+c*m,_=x+c*(m+1),E=x+1+c*(m+1),S=x+1+c*m;d.push(w,_,S),d.push(_,E,S)}this.setIndex(d),this.setAttribute("position",new He(p,3)),this.setAttribute("normal",new He(y,3)),this.setAttribute("uv",new He(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new r(t.width,t.height,t.widthSegments,t.heightSegments)}};var Al=class r extends hn{constructor(t=1,e=32,n=16,i=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:i,phiLength:s,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new z,f=new z,d=[],p=[],y=[],g=[];for(let m=0;m<=n;m++){let x=[],w=m/n,_=o+w*a,E=t*Math.cos(_),S=Math.sqrt(t*t-E*E),v=0;m===0&&o===0?v=.5/e:m===n&&l===Math.PI&&(v=-.5/e);for(let b=0;b<=e;b++){let N=b/e,C=i+N*s;h.x=-S*Math.cos(C),h.y=E,h.z=S*Math.sin(C),p.push(h.x,h.y,h.z),f.copy(h).normalize(),y.push(f.x,f.y,f.z),g.push(N+v,1-w),x.push(c++)}u.push(x)}for(let m=0;m<n;m++)for(let x=0;x<e;x++){let w=u[m][x+1],_=u[m][x],E=u[m+1][x],S=u[m+1][x+1];(m!==0||o>0)&&d.push(w,_,S),(m!==n-1||l<Math.PI)&&d.push(_,E,S)}this.setIndex(d),this.setAttribute("position",new He(p,3)),this.setAttribute("normal",new He(y,3)),this.setAttribute("uv",new He(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new r(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var El=class extends hn{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,i=new z,s=new z;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,d=h.count;for(let p=f,y=f+d;p<y;p+=3)for(let g=0;g<3;g++){let m=a.getX(p+g),x=a.getX(p+(g+1)%3);i.fromBufferAttribute(o,m),s.fromBufferAttribute(o,x),b_(i,s,n)===!0&&(e.push(i.x,i.y,i.z),e.push(s.x,s.y,s.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;i.fromBufferAttribute(o,u),s.fromBufferAttribute(o,h),b_(i,s,n)===!0&&(e.push(i.x,i.y,i.z),e.push(s.x,s.y,s.z))}}this.setAttribute("position",new He(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function b_(r,t,e){let n=`${r.x},${r.y},${r.z}-${t.x},${t.y},${t.z}`,i=`${t.x},${t.y},${t.z}-${r.x},${r.y},${r.z}`;return e.has(n)===!0||e.has(i)===!0?!1:(e.add(n),e.add(i),!0)}var Tl=class extends fr{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new ue(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function po(r){let t={};for(let e in r){t[e]={};for(let n in r[e]){let i=r[e][n];if(w_(i))i.isRenderTargetTexture?(Zt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=i.clone();else if(Array.isArray(i))if(w_(i[0])){let s=[];for(let o=0,a=i.length;o<a;o++)s[o]=i[o].clone();t[e][n]=s}else t[e][n]=i.slice();else t[e][n]=i}}return t}function ri(r){let t={};for(let e=0;e<r.length;e++){let n=po(r[e]);for(let i in n)t[i]=n[i]}return t}function w_(r){return r&&(r.isColor||r.isMatrix3||r.isMatrix4||r.isVector2||r.isVector3||r.isVector4||r.isTexture||r.isQuaternion)}function eE(r){let t=[];for(let e=0;e<r.length;e++)t.push(r[e].clone());return t}function am(r){let t=r.getRenderTarget();return t===null?r.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var $l={clone:po,merge:ri},nE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,iE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ji=class extends fr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=nE,this.fragmentShader=iE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=po(t.uniforms),this.uniformsGroups=eE(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let i in this.uniforms){let o=this.uniforms[i].value;o&&o.isTexture?e.uniforms[i]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[i]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[i]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[i]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[i]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[i]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[i]={type:"m4",value:o.toArray()}:e.uniforms[i]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let i in this.extensions)this.extensions[i]===!0&&(n[i]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let i=t.uniforms[n];switch(this.uniforms[n]={},i.type){case"t":this.uniforms[n].value=e[i.value]||null;break;case"c":this.uniforms[n].value=new ue().setHex(i.value);break;case"v2":this.uniforms[n].value=new Jt().fromArray(i.value);break;case"v3":this.uniforms[n].value=new z().fromArray(i.value);break;case"v4":this.uniforms[n].value=new Pe().fromArray(i.value);break;case"m3":this.uniforms[n].value=new oe().fromArray(i.value);break;case"m4":this.uniforms[n].value=new Ge().fromArray(i.value);break;default:this.uniforms[n].value=i.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Hu=class extends Ji{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Rl=class extends fr{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ue(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Xl,this.normalScale=new Jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ir,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var oo=class extends fr{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Xl,this.normalScale=new Jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ir,this.combine=rh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Wu=class extends fr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=tv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},qu=class extends fr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var Cl=class extends ya{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function ra(r,t){return!r||r.constructor===t?r:typeof t.BYTES_PER_ELEMENT=="number"?new t(r):Array.prototype.slice.call(r)}function _u(r){return r!==void 0&&r.inTangents!==void 0&&r.outTangents!==void 0}var Rs=class{constructor(t,e,n,i){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=i!==void 0?i:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,i=e[n],s=e[n-1];t:{e:{let o;n:{i:if(!(t<i)){for(let a=n+2;;){if(i===void 0){if(t<s)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(s=i,i=e[++n],t<i)break e}o=e.length;break n}if(!(t>=s)){let a=e[1];t<a&&(n=2,s=a);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(i=s,s=e[--n-1],t>=s)break e}o=n,n=0;break n}break t}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(i=e[n],s=e[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,i)}return this.interpolate_(n,s,t,i)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,i=this.valueSize,s=t*i;for(let o=0;o!==i;++o)e[o]=n[s+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Xu=class extends Rs{constructor(t,e,n,i){super(t,e,n,i),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Sp,endingEnd:Sp}}intervalChanged_(t,e,n){let i=this.parameterPositions,s=t-2,o=t+1,a=i[s],l=i[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ap:s=t,a=2*e-n;break;case Ep:s=i.length-2,a=e+i[s]-i[s+1];break;default:s=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Ap:o=t,l=2*n-e;break;case Ep:o=1,l=n+i[1]-i[0];break;default:o=t-1,l=e}let c=(n-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(t,e,n,i){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,p=(n-e)/(i-e),y=p*p,g=y*p,m=-f*g+2*f*y-f*p,x=(1+f)*g+(-1.5-2*f)*y+(-.5+f)*p+1,w=(-1-d)*g+(1.5+d)*y+.5*p,_=d*g-d*y;for(let E=0;E!==a;++E)s[E]=m*o[u+E]+x*o[c+E]+w*o[l+E]+_*o[h+E];return s}},$u=class extends Rs{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(n-e)/(i-e),h=1-u;for(let f=0;f!==a;++f)s[f]=o[c+f]*h+o[l+f]*u;return s}},Yu=class extends Rs{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t){return this.copySampleValue_(t-1)}},ju=class extends Rs{interpolate_(t,e,n,i){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(n-e)/(i-e),y=1-p;for(let g=0;g!==a;++g)s[g]=o[c+g]*y+o[l+g]*p;return s}let f=a*2,d=t-1;for(let p=0;p!==a;++p){let y=o[c+p],g=o[l+p],m=d*f+p*2,x=h[m],w=h[m+1],_=t*f+p*2,E=u[_],S=u[_+1],v=sE(n,e,x,E,i);s[p]=dv(v,y,w,S,g)}return s}};function dv(r,t,e,n,i){let s=1-r;return s*s*s*t+3*s*s*r*e+3*s*r*r*n+r*r*r*i}function rE(r,t,e,n,i){let s=1-r;return 3*s*s*(e-t)+6*s*r*(n-e)+3*r*r*(i-n)}function sE(r,t,e,n,i){let s=(r-t)/(i-t);for(let o=0;o<8;o++){let a=dv(s,t,e,n,i)-r;if(Math.abs(a)<1e-10)break;let l=rE(s,t,e,n,i);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var Bi=class{constructor(t,e,n,i){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ra(e,this.TimeBufferType),this.values=ra(n,this.ValueBufferType),this.setInterpolation(i||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:ra(t.times,Array),values:ra(t.values,Array)};let i=t.getInterpolation();i!==t.DefaultInterpolation&&(n.interpolation=i),_u(t.settings)&&(n.settings={inTangents:ra(t.settings.inTangents,Array),outTangents:ra(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Yu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new $u(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Xu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new ju(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ul:e=this.InterpolantFactoryMethodDiscrete;break;case Nu:e=this.InterpolantFactoryMethodLinear;break;case Mu:e=this.InterpolantFactoryMethodSmooth;break;case Mp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Zt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ul;case this.InterpolantFactoryMethodLinear:return Nu;case this.InterpolantFactoryMethodSmooth:return Mu;case this.InterpolantFactoryMethodBezier:return Mp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]+=t;_u(this.settings)&&(M_(this.settings.inTangents,t),M_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]*=t;_u(this.settings)&&(S_(this.settings.inTangents,t),S_(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,i=n.length,s=0,o=i-1;for(;s!==i&&n[s]<t;)++s;for(;o!==-1&&n[o]>e;)--o;if(++o,s!==0||o!==i){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(se("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,i=this.values,s=n.length;s===0&&(se("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==s;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){se("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){se("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(i!==void 0&&bA(i))for(let a=0,l=i.length;a!==l;++a){let c=i[a];if(isNaN(c)){se("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),i=this.getInterpolation()===Mu,s=t.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(i)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let p=0;p!==n;++p){let y=e[h+p];if(y!==e[f+p]||y!==e[d+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[h+d]}++o}}if(s>0){t[o]=t[s];for(let a=s*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,i=new n(this.name,t,e);return i.createInterpolant=this.createInterpolant,_u(this.settings)&&(i.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),i}};function M_(r,t){for(let e=0,n=r.length;e!==n;e+=2)r[e]+=t}function S_(r,t){for(let e=0,n=r.length;e!==n;e+=2)r[e]*=t}Bi.prototype.ValueTypeName="";Bi.prototype.TimeBufferType=Float32Array;Bi.prototype.ValueBufferType=Float32Array;Bi.prototype.DefaultInterpolation=Nu;var Cs=class extends Bi{constructor(t,e,n){super(t,e,n)}};Cs.prototype.ValueTypeName="bool";Cs.prototype.ValueBufferType=Array;Cs.prototype.DefaultInterpolation=ul;Cs.prototype.InterpolantFactoryMethodLinear=void 0;Cs.prototype.InterpolantFactoryMethodSmooth=void 0;var Zu=class extends Bi{constructor(t,e,n,i){super(t,e,n,i)}};Zu.prototype.ValueTypeName="color";var Ku=class extends Bi{constructor(t,e,n,i){super(t,e,n,i)}};Ku.prototype.ValueTypeName="number";var Ju=class extends Rs{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(i-e),c=t*a;for(let u=c+a;c!==u;c+=4)Hn.slerpFlat(s,0,o,c-a,o,c,l);return s}},Pl=class extends Bi{constructor(t,e,n,i){super(t,e,n,i)}InterpolantFactoryMethodLinear(t){return new Ju(this.times,this.values,this.getValueSize(),t)}};Pl.prototype.ValueTypeName="quaternion";Pl.prototype.InterpolantFactoryMethodSmooth=void 0;var Ps=class extends Bi{constructor(t,e,n){super(t,e,n)}};Ps.prototype.ValueTypeName="string";Ps.prototype.ValueBufferType=Array;Ps.prototype.DefaultInterpolation=ul;Ps.prototype.InterpolantFactoryMethodLinear=void 0;Ps.prototype.InterpolantFactoryMethodSmooth=void 0;var Qu=class extends Bi{constructor(t,e,n,i){super(t,e,n,i)}};Qu.prototype.ValueTypeName="vector";var th=class{constructor(t,e,n){let i=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,s===!1&&i.onStart!==void 0&&i.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,i.onProgress!==void 0&&i.onProgress(u,o,a),o===a&&(s=!1,i.onLoad!==void 0&&i.onLoad())},this.itemError=function(u){i.onError!==void 0&&i.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],p=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},pv=new th,eh=class{constructor(t){this.manager=t!==void 0?t:pv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(i,s){n.load(t,i,e,s)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};eh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Il=class extends Yn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ue(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ll=class extends Il{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Yn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ue(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},bp=new Ge,A_=new z,E_=new z,nh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Jt(512,512),this.mapType=_i,this.map=null,this.mapPass=null,this.matrix=new Ge,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Es,this._frameExtents=new Jt(1,1),this._viewportCount=1,this._viewports=[new Pe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;A_.setFromMatrixPosition(t.matrixWorld),e.position.copy(A_),E_.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(E_),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,i){bp.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(bp,t.coordinateSystem,t.reversedDepth);let s=this._frameExtents,o=i?i.z/s.x:1,a=i?i.w/s.y:1,l=i?i.x/s.x:0,c=i?i.y/s.y:0;t.coordinateSystem===ha||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(bp)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},vu=new z,bu=new Hn,Cr=new z,Fl=class extends Yn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ge,this.projectionMatrix=new Ge,this.projectionMatrixInverse=new Ge,this.coordinateSystem=Zi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(vu,bu,Cr),Cr.x===1&&Cr.y===1&&Cr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(vu,bu,Cr.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(vu,bu,Cr),Cr.x===1&&Cr.y===1&&Cr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(vu,bu,Cr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ss=new z,T_=new Jt,R_=new Jt,$n=class extends Fl{constructor(t=50,e=1,n=.1,i=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=i,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=da*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ll*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return da*2*Math.atan(Math.tan(ll*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ss.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ss.x,Ss.y).multiplyScalar(-t/Ss.z),Ss.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ss.x,Ss.y).multiplyScalar(-t/Ss.z)}getViewSize(t,e){return this.getViewBounds(t,T_,R_),e.subVectors(R_,T_)}setViewOffset(t,e,n,i,s,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=i,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ll*.5*this.fov)/this.zoom,n=2*e,i=this.aspect*n,s=-.5*i,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*i/l,e-=o.offsetY*n/c,i*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(s+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+i,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Nl=class extends Fl{constructor(t=-1,e=1,n=1,i=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=i,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,i,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=i,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,i=(this.top+this.bottom)/2,s=n-t,o=n+t,a=i+e,l=i-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Tp=class extends nh{constructor(){super(new Nl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Dl=class extends Il{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Yn.DEFAULT_UP),this.updateMatrix(),this.target=new Yn,this.shadow=new Tp}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Ul=class extends hn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var sa=-90,oa=1,_a=class extends Yn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let i=new $n(sa,oa,t,e);i.layers=this.layers,this.add(i);let s=new $n(sa,oa,t,e);s.layers=this.layers,this.add(s);let o=new $n(sa,oa,t,e);o.layers=this.layers,this.add(o);let a=new $n(sa,oa,t,e);a.layers=this.layers,this.add(a);let l=new $n(sa,oa,t,e);l.layers=this.layers,this.add(l);let c=new $n(sa,oa,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,i,s,o,a,l]=e;for(let c of e)this.remove(c);if(t===Zi)n.up.set(0,1,0),n.lookAt(1,0,0),i.up.set(0,1,0),i.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ha)n.up.set(0,-1,0),n.lookAt(-1,0,0),i.up.set(0,-1,0),i.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:i}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,i),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,s),t.setRenderTarget(n,1,i),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,i),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,i),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,i),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,i),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},ih=class extends $n{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var lm="\\[\\]\\.:\\/",oE=new RegExp("["+lm+"]","g"),cm="[^"+lm+"]",aE="[^"+lm.replace("\\.","")+"]",lE=/((?:WC+[\/:])*)/.source.replace("WC",cm),cE=/(WCOD+)?/.source.replace("WCOD",aE),uE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",cm),hE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",cm),fE=new RegExp("^"+lE+cE+uE+hE+"$"),dE=["material","materials","bones","map"],Rp=class{constructor(t,e,n){let i=n||Je.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,i)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,i=this._bindings[n];i!==void 0&&i.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let i=this._targetGroup.nCachedObjects_,s=n.length;i!==s;++i)n[i].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Je=class r{constructor(t,e,n){this.path=e,this.parsedPath=n||r.parseTrackName(e),this.node=r.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new r.Composite(t,e,n):new r(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(oE,"")}static parseTrackName(t){let e=fE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},i=n.nodeName&&n.nodeName.lastIndexOf(".");if(i!==void 0&&i!==-1){let s=n.nodeName.substring(i+1);dE.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,i),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},i=n(t.children);if(i)return i}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)t[e++]=n[i]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,i=e.propertyName,s=e.propertyIndex;if(t||(t=r.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Zt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){se("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){se("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){se("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){se("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){se("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[i];if(o===void 0){let c=e.nodeName;se("PropertyBinding: Trying to update property for track: "+c+"."+i+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(i==="morphTargetInfluences"){if(!t.geometry){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[s]!==void 0&&(s=t.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=i;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Je.Composite=Rp;Je.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Je.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Je.prototype.GetterByBindingType=[Je.prototype._getValue_direct,Je.prototype._getValue_array,Je.prototype._getValue_arrayElement,Je.prototype._getValue_toArray];Je.prototype.SetterByBindingTypeAndVersioning=[[Je.prototype._setValue_direct,Je.prototype._setValue_direct_setNeedsUpdate,Je.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_array,Je.prototype._setValue_array_setNeedsUpdate,Je.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_arrayElement,Je.prototype._setValue_arrayElement_setNeedsUpdate,Je.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_fromArray,Je.prototype._setValue_fromArray_setNeedsUpdate,Je.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var hN=new Float32Array(1);var Is=class extends vl{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var Ls=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ce(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ce(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Cp=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,i){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,i)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,i){let s=this.elements;return s[0]=t,s[2]=e,s[1]=n,s[3]=i,this}};var C_=new z,wu=new z,aa=new z,la=new z,wp=new z,pE=new z,mE=new z,Ol=class{constructor(t=new z,e=new z){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){C_.subVectors(t,this.start),wu.subVectors(this.end,this.start);let n=wu.dot(wu);if(n===0)return 0;let s=wu.dot(C_)/n;return e&&(s=ce(s,0,1)),s}closestPointToPoint(t,e,n){let i=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(i).add(this.start)}distanceSqToLine3(t,e=pE,n=mE){let i=10000000000000001e-32,s,o,a=this.start,l=t.start,c=this.end,u=t.end;aa.subVectors(c,a),la.subVectors(u,l),wp.subVectors(a,l);let h=aa.dot(aa),f=la.dot(la),d=la.dot(wp);if(h<=i&&f<=i)return e.copy(a),n.copy(l),e.distanceToSquared(n);if(h<=i)s=0,o=d/f,o=ce(o,0,1);else{let p=aa.dot(wp);if(f<=i)o=0,s=ce(-p/h,0,1);else{let y=aa.dot(la),g=h*f-y*y;g!==0?s=ce((y*d-p*f)/g,0,1):s=0,o=(y*s+d)/f,o<0?(o=0,s=ce(-p/h,0,1)):o>1&&(o=1,s=ce((y-p)/h,0,1))}}return e.copy(a).addScaledVector(aa,s),n.copy(l).addScaledVector(la,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var ao=class extends Gu{constructor(t=10,e=10,n=4473924,i=8947848){n=new ue(n),i=new ue(i);let s=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,p=-a;f<=e;f++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let y=f===s?n:i;y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3}let u=new hn;u.setAttribute("position",new He(l,3)),u.setAttribute("color",new He(c,3));let h=new ya({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var kl=class extends ur{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function um(r,t,e,n){let i=gE(n);switch(e){case Yp:return r*t;case Zp:return r*t/i.components*i.byteLength;case hh:return r*t/i.components*i.byteLength;case Us:return r*t*2/i.components*i.byteLength;case fh:return r*t*2/i.components*i.byteLength;case jp:return r*t*3/i.components*i.byteLength;case gr:return r*t*4/i.components*i.byteLength;case dh:return r*t*4/i.components*i.byteLength;case zl:case Vl:return Math.floor((r+3)/4)*Math.floor((t+3)/4)*8;case Gl:case Hl:return Math.floor((r+3)/4)*Math.floor((t+3)/4)*16;case mh:case yh:return Math.max(r,16)*Math.max(t,8)/4;case ph:case gh:return Math.max(r,8)*Math.max(t,8)/2;case xh:case _h:case bh:case wh:return Math.floor((r+3)/4)*Math.floor((t+3)/4)*8;case vh:case Wl:case Mh:return Math.floor((r+3)/4)*Math.floor((t+3)/4)*16;case Sh:return Math.floor((r+3)/4)*Math.floor((t+3)/4)*16;case Ah:return Math.floor((r+4)/5)*Math.floor((t+3)/4)*16;case Eh:return Math.floor((r+4)/5)*Math.floor((t+4)/5)*16;case Th:return Math.floor((r+5)/6)*Math.floor((t+4)/5)*16;case Rh:return Math.floor((r+5)/6)*Math.floor((t+5)/6)*16;case Ch:return Math.floor((r+7)/8)*Math.floor((t+4)/5)*16;case Ph:return Math.floor((r+7)/8)*Math.floor((t+5)/6)*16;case Ih:return Math.floor((r+7)/8)*Math.floor((t+7)/8)*16;case Lh:return Math.floor((r+9)/10)*Math.floor((t+4)/5)*16;case Fh:return Math.floor((r+9)/10)*Math.floor((t+5)/6)*16;case Nh:return Math.floor((r+9)/10)*Math.floor((t+7)/8)*16;case Dh:return Math.floor((r+9)/10)*Math.floor((t+9)/10)*16;case Uh:return Math.floor((r+11)/12)*Math.floor((t+9)/10)*16;case Oh:return Math.floor((r+11)/12)*Math.floor((t+11)/12)*16;case kh:case Bh:case zh:return Math.ceil(r/4)*Math.ceil(t/4)*16;case Vh:case Gh:return Math.ceil(r/4)*Math.ceil(t/4)*8;case ql:case Hh:return Math.ceil(r/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function gE(r){switch(r){case _i:case Wp:return{byteLength:1,components:1};case Ma:case qp:case mr:return{byteLength:2,components:1};case ch:case uh:return{byteLength:2,components:4};case dr:case lh:case pr:return{byteLength:4,components:1};case Xp:case $p:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${r}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Zt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Uv(){let r=null,t=!1,e=null,n=null;function i(s,o){n=r.requestAnimationFrame(i),e(s,o)}return{start:function(){t!==!0&&e!==null&&r!==null&&(n=r.requestAnimationFrame(i),t=!0)},stop:function(){r!==null&&r.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(s){e=s},setContext:function(s){r=s}}}function wE(r){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=r.createBuffer();r.bindBuffer(l,f),r.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=r.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=r.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=r.HALF_FLOAT:d=r.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=r.SHORT;else if(c instanceof Uint32Array)d=r.UNSIGNED_INT;else if(c instanceof Int32Array)d=r.INT;else if(c instanceof Int8Array)d=r.BYTE;else if(c instanceof Uint8Array)d=r.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=r.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(r.bindBuffer(c,a),h.length===0)r.bufferSubData(c,0,u);else{h.sort((d,p)=>d.start-p.start);let f=0;for(let d=1;d<h.length;d++){let p=h[f],y=h[d];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,p=h.length;d<p;d++){let y=h[d];r.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function i(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(r.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:i,remove:s,update:o}}var ME=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,SE=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,AE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,EE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,TE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,RE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,CE=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,PE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,IE=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,LE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,FE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,NE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,DE=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,UE=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,OE=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,kE=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,BE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,zE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,VE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,GE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,HE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,WE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,qE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,XE=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,$E=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,YE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,jE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ZE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,KE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,JE="gl_FragColor = linearToOutputTexel( gl_FragColor );",QE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,tT=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,eT=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,nT=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,iT=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,rT=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,sT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,oT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,aT=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,lT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,cT=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,uT=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,hT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,fT=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,dT=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,pT=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,mT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,gT=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,yT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,xT=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,_T=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,vT=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,bT=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,wT=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,MT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,ST=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,AT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ET=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,TT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,RT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,CT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,PT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,IT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,LT=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,FT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,NT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,DT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,UT=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,OT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kT=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,BT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,zT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,VT=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,GT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,HT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,WT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,qT=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,XT=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,$T=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,YT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,jT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,ZT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,KT=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,JT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,QT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,tR=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,eR=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,nR=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,iR=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,rR=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,sR=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,oR=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,aR=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,lR=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,cR=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,uR=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,hR=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,fR=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,dR=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,pR=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,mR=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,gR=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,yR=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,xR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,_R=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,vR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,bR=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,wR=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,MR=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,AR=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ER=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,TR=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RR=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,CR=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,PR=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,IR=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,LR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,FR=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,NR=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,DR=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,UR=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,OR=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kR=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,BR=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zR=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,VR=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,GR=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,HR=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,WR=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,qR=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XR=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,$R=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,YR=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jR=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ZR=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,KR=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,JR=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,QR=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,tC=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,eC=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,de={alphahash_fragment:ME,alphahash_pars_fragment:SE,alphamap_fragment:AE,alphamap_pars_fragment:EE,alphatest_fragment:TE,alphatest_pars_fragment:RE,aomap_fragment:CE,aomap_pars_fragment:PE,batching_pars_vertex:IE,batching_vertex:LE,begin_vertex:FE,beginnormal_vertex:NE,bsdfs:DE,iridescence_fragment:UE,bumpmap_pars_fragment:OE,clipping_planes_fragment:kE,clipping_planes_pars_fragment:BE,clipping_planes_pars_vertex:zE,clipping_planes_vertex:VE,color_fragment:GE,color_pars_fragment:HE,color_pars_vertex:WE,color_vertex:qE,common:XE,defaultnormal_vertex:$E,displacementmap_pars_vertex:YE,displacementmap_vertex:jE,emissivemap_fragment:ZE,emissivemap_pars_fragment:KE,colorspace_fragment:JE,colorspace_pars_fragment:QE,envmap_fragment:tT,envmap_common_pars_fragment:eT,envmap_pars_fragment:nT,envmap_pars_vertex:iT,envmap_physical_pars_fragment:pT,envmap_vertex:rT,fog_vertex:sT,fog_pars_vertex:oT,fog_fragment:aT,fog_pars_fragment:lT,gradientmap_pars_fragment:cT,lightmap_pars_fragment:uT,lights_lambert_fragment:hT,lights_lambert_pars_fragment:fT,lights_pars_begin:dT,lights_toon_fragment:mT,lights_toon_pars_fragment:gT,lights_phong_fragment:yT,lights_phong_pars_fragment:xT,lights_physical_fragment:_T,lights_physical_pars_fragment:vT,lights_fragment_begin:bT,lights_fragment_maps:wT,lights_fragment_end:MT,lightprobes_pars_fragment:ST,logdepthbuf_fragment:AT,logdepthbuf_pars_fragment:ET,logdepthbuf_pars_vertex:TT,logdepthbuf_vertex:RT,map_fragment:CT,map_pars_fragment:PT,map_particle_fragment:IT,map_particle_pars_fragment:LT,metalnessmap_fragment:FT,metalnessmap_pars_fragment:NT,morphinstance_vertex:DT,morphcolor_vertex:UT,morphnormal_vertex:OT,morphtarget_pars_vertex:kT,morphtarget_vertex:BT,normal_fragment_begin:zT,normal_fragment_maps:VT,normal_pars_fragment:GT,normal_pars_vertex:HT,normal_vertex:WT,normalmap_pars_fragment:qT,clearcoat_normal_fragment_begin:XT,clearcoat_normal_fragment_maps:$T,clearcoat_pars_fragment:YT,iridescence_pars_fragment:jT,opaque_fragment:ZT,packing:KT,premultiplied_alpha_fragment:JT,project_vertex:QT,dithering_fragment:tR,dithering_pars_fragment:eR,roughnessmap_fragment:nR,roughnessmap_pars_fragment:iR,shadowmap_pars_fragment:rR,shadowmap_pars_vertex:sR,shadowmap_vertex:oR,shadowmask_pars_fragment:aR,skinbase_vertex:lR,skinning_pars_vertex:cR,skinning_vertex:uR,skinnormal_vertex:hR,specularmap_fragment:fR,specularmap_pars_fragment:dR,tonemapping_fragment:pR,tonemapping_pars_fragment:mR,transmission_fragment:gR,transmission_pars_fragment:yR,uv_pars_fragment:xR,uv_pars_vertex:_R,uv_vertex:vR,worldpos_vertex:bR,background_vert:wR,background_frag:MR,backgroundCube_vert:SR,backgroundCube_frag:AR,cube_vert:ER,cube_frag:TR,depth_vert:RR,depth_frag:CR,distance_vert:PR,distance_frag:IR,equirect_vert:LR,equirect_frag:FR,linedashed_vert:NR,linedashed_frag:DR,meshbasic_vert:UR,meshbasic_frag:OR,meshlambert_vert:kR,meshlambert_frag:BR,meshmatcap_vert:zR,meshmatcap_frag:VR,meshnormal_vert:GR,meshnormal_frag:HR,meshphong_vert:WR,meshphong_frag:qR,meshphysical_vert:XR,meshphysical_frag:$R,meshtoon_vert:YR,meshtoon_frag:jR,points_vert:ZR,points_frag:KR,shadow_vert:JR,shadow_frag:QR,sprite_vert:tC,sprite_frag:eC},It={common:{diffuse:{value:new ue(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new oe}},envmap:{envMap:{value:null},envMapRotation:{value:new oe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new oe},normalScale:{value:new Jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ue(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ue(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0},uvTransform:{value:new oe}},sprite:{diffuse:{value:new ue(16777215)},opacity:{value:1},center:{value:new Jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}}},gi={basic:{uniforms:ri([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.fog]),vertexShader:de.meshbasic_vert,fragmentShader:de.meshbasic_frag},lambert:{uniforms:ri([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new ue(0)},envMapIntensity:{value:1}}]),vertexShader:de.meshlambert_vert,fragmentShader:de.meshlambert_frag},phong:{uniforms:ri([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new ue(0)},specular:{value:new ue(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:de.meshphong_vert,fragmentShader:de.meshphong_frag},standard:{uniforms:ri([It.common,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.roughnessmap,It.metalnessmap,It.fog,It.lights,{emissive:{value:new ue(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag},toon:{uniforms:ri([It.common,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.gradientmap,It.fog,It.lights,{emissive:{value:new ue(0)}}]),vertexShader:de.meshtoon_vert,fragmentShader:de.meshtoon_frag},matcap:{uniforms:ri([It.common,It.bumpmap,It.normalmap,It.displacementmap,It.fog,{matcap:{value:null}}]),vertexShader:de.meshmatcap_vert,fragmentShader:de.meshmatcap_frag},points:{uniforms:ri([It.points,It.fog]),vertexShader:de.points_vert,fragmentShader:de.points_frag},dashed:{uniforms:ri([It.common,It.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:de.linedashed_vert,fragmentShader:de.linedashed_frag},depth:{uniforms:ri([It.common,It.displacementmap]),vertexShader:de.depth_vert,fragmentShader:de.depth_frag},normal:{uniforms:ri([It.common,It.bumpmap,It.normalmap,It.displacementmap,{opacity:{value:1}}]),vertexShader:de.meshnormal_vert,fragmentShader:de.meshnormal_frag},sprite:{uniforms:ri([It.sprite,It.fog]),vertexShader:de.sprite_vert,fragmentShader:de.sprite_frag},background:{uniforms:{uvTransform:{value:new oe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:de.background_vert,fragmentShader:de.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new oe}},vertexShader:de.backgroundCube_vert,fragmentShader:de.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:de.cube_vert,fragmentShader:de.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:de.equirect_vert,fragmentShader:de.equirect_frag},distance:{uniforms:ri([It.common,It.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:de.distance_vert,fragmentShader:de.distance_frag},shadow:{uniforms:ri([It.lights,It.fog,{color:{value:new ue(0)},opacity:{value:1}}]),vertexShader:de.shadow_vert,fragmentShader:de.shadow_frag}};gi.physical={uniforms:ri([gi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new oe},clearcoatNormalScale:{value:new Jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new oe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new oe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new oe},sheen:{value:0},sheenColor:{value:new ue(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new oe},transmissionSamplerSize:{value:new Jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new oe},attenuationDistance:{value:0},attenuationColor:{value:new ue(0)},specularColor:{value:new ue(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new oe},anisotropyVector:{value:new Jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new oe}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag};var qh={r:0,b:0,g:0},nC=new Ge,Ov=new oe;Ov.set(-1,0,0,0,1,0,0,0,1);function iC(r,t,e,n,i,s){let o=new ue(0),a=i===!0?0:1,l,c,u=null,h=0,f=null;function d(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){let _=x.backgroundBlurriness>0;w=t.get(w,_)}return w}function p(x){let w=!1,_=d(x);_===null?g(o,a):_&&_.isColor&&(g(_,1),w=!0);let E=r.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,s):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,s),(r.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),r.clear(r.autoClearColor,r.autoClearDepth,r.autoClearStencil))}function y(x,w){let _=d(w);_&&_.isCubeTexture?(c===void 0&&(c=new We(new Ts(1,1,1),new Ji({name:"BackgroundCubeMaterial",uniforms:po(gi.backgroundCube.uniforms),vertexShader:gi.backgroundCube.vertexShader,fragmentShader:gi.backgroundCube.fragmentShader,side:mi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,S,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=_,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(nC.makeRotationFromEuler(w.backgroundRotation)).transpose(),_.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ov),c.material.toneMapped=_e.getTransfer(_.colorSpace)!==Ce,(u!==_||h!==_.version||f!==r.toneMapping)&&(c.material.needsUpdate=!0,u=_,h=_.version,f=r.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):_&&_.isTexture&&(l===void 0&&(l=new We(new so(2,2),new Ji({name:"BackgroundMaterial",uniforms:po(gi.background.uniforms),vertexShader:gi.background.vertexShader,fragmentShader:gi.background.fragmentShader,side:Ds,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=_,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=_e.getTransfer(_.colorSpace)!==Ce,_.matrixAutoUpdate===!0&&_.updateMatrix(),l.material.uniforms.uvTransform.value.copy(_.matrix),(u!==_||h!==_.version||f!==r.toneMapping)&&(l.material.needsUpdate=!0,u=_,h=_.version,f=r.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,w){x.getRGB(qh,am(r)),e.buffers.color.setClear(qh.r,qh.g,qh.b,w,s)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,w=1){o.set(x),a=w,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:p,addToRenderList:y,dispose:m}}function rC(r,t){let e=r.getParameter(r.MAX_VERTEX_ATTRIBS),n={},i=f(null),s=i,o=!1;function a(I,U,B,F,V){let q=!1,G=h(I,F,B,U);s!==G&&(s=G,c(s.object)),q=d(I,F,B,V),q&&p(I,F,B,V),V!==null&&t.update(V,r.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,_(I,U,B,F),V!==null&&r.bindBuffer(r.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return r.createVertexArray()}function c(I){return r.bindVertexArray(I)}function u(I){return r.deleteVertexArray(I)}function h(I,U,B,F){let V=F.wireframe===!0,q=n[U.id];q===void 0&&(q={},n[U.id]=q);let G=I.isInstancedMesh===!0?I.id:0,rt=q[G];rt===void 0&&(rt={},q[G]=rt);let $=rt[B.id];$===void 0&&($={},rt[B.id]=$);let j=$[V];return j===void 0&&(j=f(l()),$[V]=j),j}function f(I){let U=[],B=[],F=[];for(let V=0;V<e;V++)U[V]=0,B[V]=0,F[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:B,attributeDivisors:F,object:I,attributes:{},index:null}}function d(I,U,B,F){let V=s.attributes,q=U.attributes,G=0,rt=B.getAttributes();for(let $ in rt)if(rt[$].location>=0){let tt=V[$],ut=q[$];if(ut===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(ut=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(ut=I.instanceColor)),tt===void 0||tt.attribute!==ut||ut&&tt.data!==ut.data)return!0;G++}return s.attributesNum!==G||s.index!==F}function p(I,U,B,F){let V={},q=U.attributes,G=0,rt=B.getAttributes();for(let $ in rt)if(rt[$].location>=0){let tt=q[$];tt===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(tt=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(tt=I.instanceColor));let ut={};ut.attribute=tt,tt&&tt.data&&(ut.data=tt.data),V[$]=ut,G++}s.attributes=V,s.attributesNum=G,s.index=F}function y(){let I=s.newAttributes;for(let U=0,B=I.length;U<B;U++)I[U]=0}function g(I){m(I,0)}function m(I,U){let B=s.newAttributes,F=s.enabledAttributes,V=s.attributeDivisors;B[I]=1,F[I]===0&&(r.enableVertexAttribArray(I),F[I]=1),V[I]!==U&&(r.vertexAttribDivisor(I,U),V[I]=U)}function x(){let I=s.newAttributes,U=s.enabledAttributes;for(let B=0,F=U.length;B<F;B++)U[B]!==I[B]&&(r.disableVertexAttribArray(B),U[B]=0)}function w(I,U,B,F,V,q,G){G===!0?r.vertexAttribIPointer(I,U,B,V,q):r.vertexAttribPointer(I,U,B,F,V,q)}function _(I,U,B,F){y();let V=F.attributes,q=B.getAttributes(),G=U.defaultAttributeValues;for(let rt in q){let $=q[rt];if($.location>=0){let j=V[rt];if(j===void 0&&(rt==="instanceMatrix"&&I.instanceMatrix&&(j=I.instanceMatrix),rt==="instanceColor"&&I.instanceColor&&(j=I.instanceColor)),j!==void 0){let tt=j.normalized,ut=j.itemSize,ct=t.get(j);if(ct===void 0)continue;let J=ct.buffer,gt=ct.type,yt=ct.bytesPerElement,Mt=gt===r.INT||gt===r.UNSIGNED_INT||j.gpuType===lh;if(j.isInterleavedBufferAttribute){let xt=j.data,zt=xt.isInterleavedBuffer===!0?xt.stride:xt.itemSize,te=j.offset;if(xt.isInstancedInterleavedBuffer||xt.isInstancedBufferAttribute){for(let dt=0;dt<$.locationSize;dt++)m($.location+dt,xt.meshPerAttribute);I.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=xt.meshPerAttribute*xt.count)}else for(let dt=0;dt<$.locationSize;dt++)g($.location+dt);r.bindBuffer(r.ARRAY_BUFFER,J);for(let dt=0;dt<$.locationSize;dt++)w($.location+dt,ut/$.locationSize,gt,tt,zt*yt,(te+ut/$.locationSize*dt)*yt,Mt)}else{if(j.isInstancedBufferAttribute){for(let xt=0;xt<$.locationSize;xt++)m($.location+xt,j.meshPerAttribute);I.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let xt=0;xt<$.locationSize;xt++)g($.location+xt);r.bindBuffer(r.ARRAY_BUFFER,J);for(let xt=0;xt<$.locationSize;xt++)w($.location+xt,ut/$.locationSize,gt,tt,ut*yt,ut/$.locationSize*xt*yt,Mt)}}else if(G!==void 0){let tt=G[rt];if(tt!==void 0)switch(tt.length){case 2:r.vertexAttrib2fv($.location,tt);break;case 3:r.vertexAttrib3fv($.location,tt);break;case 4:r.vertexAttrib4fv($.location,tt);break;default:r.vertexAttrib1fv($.location,tt)}}}}x()}function E(){N();for(let I in n){let U=n[I];for(let B in U){let F=U[B];for(let V in F){let q=F[V];for(let G in q)u(q[G].object),delete q[G];delete F[V]}}delete n[I]}}function S(I){if(n[I.id]===void 0)return;let U=n[I.id];for(let B in U){let F=U[B];for(let V in F){let q=F[V];for(let G in q)u(q[G].object),delete q[G];delete F[V]}}delete n[I.id]}function v(I){for(let U in n){let B=n[U];for(let F in B){let V=B[F];if(V[I.id]===void 0)continue;let q=V[I.id];for(let G in q)u(q[G].object),delete q[G];delete V[I.id]}}}function b(I){for(let U in n){let B=n[U],F=I.isInstancedMesh===!0?I.id:0,V=B[F];if(V!==void 0){for(let q in V){let G=V[q];for(let rt in G)u(G[rt].object),delete G[rt];delete V[q]}delete B[F],Object.keys(B).length===0&&delete n[U]}}}function N(){C(),o=!0,s!==i&&(s=i,c(s.object))}function C(){i.geometry=null,i.program=null,i.wireframe=!1}return{setup:a,reset:N,resetDefaultState:C,dispose:E,releaseStatesOfGeometry:S,releaseStatesOfObject:b,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:g,disableUnusedAttributes:x}}function sC(r,t,e){let n;function i(l){n=l}function s(l,c){r.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,u){u!==0&&(r.drawArraysInstanced(n,l,c,u),e.update(c,n,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];e.update(f,n,1)}this.setMode=i,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function oC(r,t,e,n){let i;function s(){if(i!==void 0)return i;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");i=r.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else i=0;return i}function o(v){return!(v!==gr&&n.convert(v)!==r.getParameter(r.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let b=v===mr&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==_i&&v!==pr&&!b&&n.convert(v)!==r.getParameter(r.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(r.getShaderPrecisionFormat(r.VERTEX_SHADER,r.HIGH_FLOAT).precision>0&&r.getShaderPrecisionFormat(r.FRAGMENT_SHADER,r.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&r.getShaderPrecisionFormat(r.VERTEX_SHADER,r.MEDIUM_FLOAT).precision>0&&r.getShaderPrecisionFormat(r.FRAGMENT_SHADER,r.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Zt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&Zt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&Zt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=r.getParameter(r.MAX_TEXTURE_IMAGE_UNITS),p=r.getParameter(r.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=r.getParameter(r.MAX_TEXTURE_SIZE),g=r.getParameter(r.MAX_CUBE_MAP_TEXTURE_SIZE),m=r.getParameter(r.MAX_VERTEX_ATTRIBS),x=r.getParameter(r.MAX_VERTEX_UNIFORM_VECTORS),w=r.getParameter(r.MAX_VARYING_VECTORS),_=r.getParameter(r.MAX_FRAGMENT_UNIFORM_VECTORS),E=r.getParameter(r.MAX_SAMPLES),S=r.getParameter(r.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:_,maxSamples:E,samples:S}}function aC(r){let t=this,e=null,n=0,i=!1,s=!1,o=new Oi,a=new oe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||i;return i=f,n=h.length,d},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){let p=h.clippingPlanes,y=h.clipIntersection,g=h.clipShadows,m=r.get(h);if(!i||p===null||p.length===0||s&&!g)s?u(null):c();else{let x=s?0:n,w=x*4,_=m.clippingState||null;l.value=_,_=u(p,f,w,d);for(let E=0;E!==w;++E)_[E]=e[E];m.clippingState=_,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,d,p){let y=h!==null?h.length:0,g=null;if(y!==0){if(g=l.value,p!==!0||g===null){let m=d+y*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<m)&&(g=new Float32Array(m));for(let w=0,_=d;w!==y;++w,_+=4)o.copy(h[w]).applyMatrix4(x,a),o.normal.toArray(g,_),g[_+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,g}}var Zl=class extends ki{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},i=[n,n,n,n,n,n];this.texture=new bl(i),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},i=new Ts(5,5,5),s=new Ji({name:"CubemapFromEquirect",uniforms:po(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:mi,blending:co});s.uniforms.tEquirect.value=e;let o=new We(i,s),a=e.minFilter;return e.minFilter===rs&&(e.minFilter=pi),new _a(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,i=!0){let s=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,i);t.setRenderTarget(s)}},mv=256,lC=3,cC=20,kv=256,Bv=16,uC=3,hC=new z,fC=new ue,$h=class r{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new _a(1,10,null),this._boxMesh=new We(new Ts(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,i=100,s={}){let{size:o=256,position:a=hC}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(fC));let g=new _a(n,i,u);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=p,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=xv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=yv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(mv,rm(t))}_fromTexture(t,e){t.mapping===ho||t.mapping===wa?this._setSize(t.image.length===0?mv:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=gv(t,!1,!1),n=Math.log2(t)-lC;for(let i=0;i<=n;i++)e.texture.mipmaps.push({width:t>>i,height:t>>i});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=gv(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let i=this._boxMesh,s=this._cubeCamera;i.material=n,s.renderTarget=t,s.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),s.update(this._renderer,i),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===ho||t.mapping===wa?(this._cubemapMaterial===null&&(this._cubemapMaterial=xv()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=yv()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=dC(),this._integrationMaterial=pC());let e=this._cubeSize,n=t.texture.mipmaps.length-1,i=this._ggxMaterial.uniforms;i.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(e/Bv);for(let o=0;o<=n;o++){let a=r.lodToRoughness(o,n);if(o>n-uC)s.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(kv*Math.pow(a,4)))+.5:0;i.roughness.value=a,i.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=mC());let n=this._blurMaterial,i=n.uniforms,s=this._sourceTarget;i.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,i.envMap.value=s.texture,this._renderCube(t,0,n),i.envMap.value=t.texture,this._renderCube(s,0,n)}};function gv(r,t,e){return new Zl(r,{minFilter:rs,generateMipmaps:t,type:mr,colorSpace:hl,depthBuffer:e})}function Kl(r,t,e){return new Ji({name:r,uniforms:t,vertexShader:de.cube_vert,fragmentShader:e,side:mi,blending:co,depthTest:!1,depthWrite:!1})}function dC(){return Kl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${kv}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function pC(){return Kl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Bv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function mC(){return Kl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${cC}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function yv(){return Kl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function xv(){return Kl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function gC(r){let t=new WeakMap,e=new WeakMap,n=null;function i(f,d=!1){return f==null?null:d?o(f):s(f)}function s(f){if(f&&f.isTexture){let d=f.mapping;if(d===sh||d===oh)if(t.has(f)){let p=t.get(f).texture;return a(p,f.mapping)}else{let p=f.image;if(p&&p.height>0){let y=new Zl(p.height);return y.fromEquirectangularTexture(r,f),t.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,p=d===sh||d===oh,y=d===ho||d===wa;if(p||y){let g=e.get(f),m=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return n===null&&(n=new $h(r)),g=p?n.fromEquirectangular(f,g):n.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),g.texture;if(g!==void 0)return g.texture;{let x=f.image;return p&&x&&x.height>0||y&&x&&l(x)?(n===null&&(n=new $h(r)),g=p?n.fromEquirectangular(f):n.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===sh?f.mapping=ho:d===oh&&(f.mapping=wa),f}function l(f){let d=0,p=6;for(let y=0;y<p;y++)f[y]!==void 0&&d++;return d===p}function c(f){let d=f.target;d.removeEventListener("dispose",c);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:i,dispose:h}}function yC(r){let t={};function e(n){if(t[n]!==void 0)return t[n];let i=r.getExtension(n);return t[n]=i,i}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let i=e(n);return i===null&&al("WebGLRenderer: "+n+" extension not supported."),i}}}function xC(r,t,e,n){let i={},s=new WeakMap,o=new FinalizationRegistry(p=>delete i[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete i[p.id],o.unregister(p);let y=s.get(p);y&&(t.remove(y),s.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,y){return i[y.id]!==void 0||(y.addEventListener("dispose",a),i[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(p){let y=p.attributes;for(let g in y)t.update(y[g],r.ARRAY_BUFFER)}function h(p){let y=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let x=y!==null?y.array.length:g.array.length/3-1,w=g.count>=65535?_l:xl,_=new w(Math.ceil(x/3)*6,1),E=_.array;if(y!==null){let v=y.array;m=y.version;for(let b=0,N=0;b<x;b+=3){let C=v[b+0],I=v[b+1],U=v[b+2];E[N++]=C,E[N++]=I,E[N++]=I,E[N++]=U,E[N++]=U,E[N++]=C}}else{m=g.version;for(let v=0,b=0;v<x;v+=3){let N=v+0,C=v+1,I=v+2;E[b++]=N,E[b++]=C,E[b++]=C,E[b++]=I,E[b++]=I,E[b++]=N}}_.version=m;let S=s.get(p);S&&t.remove(S),s.set(p,_)}function f(p){let y=s.get(p);if(y){let g=p.index;g!==null&&y.version<g.version&&h(p)}else h(p);return s.get(p)}function d(){for(let p in i){let y=i[p].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function _C(r,t,e){let n;function i(h){n=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,f){r.drawElements(n,f,s,h*o),e.update(f,n,1)}function c(h,f,d){d!==0&&(r.drawElementsInstanced(n,f,s,h*o,d),e.update(f,n,d))}function u(h,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,s,h,0,d);let y=0;for(let g=0;g<d;g++)y+=f[g];e.update(y,n,1)}this.setMode=i,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function vC(r){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,o,a){switch(e.calls++,o){case r.TRIANGLES:e.triangles+=a*(s/3);break;case r.LINES:e.lines+=a*(s/2);break;case r.LINE_STRIP:e.lines+=a*(s-1);break;case r.LINE_LOOP:e.lines+=a*s;break;case r.POINTS:e.points+=a*s;break;default:se("WebGLInfo: Unknown draw mode:",o);break}}function i(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:i,update:n}}function bC(r,t,e){let n=new WeakMap,i=new Pe;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let N=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",N)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],w=0;d===!0&&(w=1),p===!0&&(w=2),y===!0&&(w=3);let _=a.attributes.position.count*w,E=1;_>t.maxTextureSize&&(E=Math.ceil(_/t.maxTextureSize),_=t.maxTextureSize);let S=new Float32Array(_*E*4*h),v=new ml(S,_,E,h);v.type=pr,v.needsUpdate=!0;let b=w*4;for(let C=0;C<h;C++){let I=g[C],U=m[C],B=x[C],F=_*E*4*C;for(let V=0;V<I.count;V++){let q=V*b;d===!0&&(i.fromBufferAttribute(I,V),S[F+q+0]=i.x,S[F+q+1]=i.y,S[F+q+2]=i.z,S[F+q+3]=0),p===!0&&(i.fromBufferAttribute(U,V),S[F+q+4]=i.x,S[F+q+5]=i.y,S[F+q+6]=i.z,S[F+q+7]=0),y===!0&&(i.fromBufferAttribute(B,V),S[F+q+8]=i.x,S[F+q+9]=i.y,S[F+q+10]=i.z,S[F+q+11]=B.itemSize===4?i.w:1)}}f={count:h,texture:v,size:new Jt(_,E)},n.set(a,f),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(r,"morphTexture",o.morphTexture,e);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(r,"morphTargetBaseInfluence",p),l.getUniforms().setValue(r,"morphTargetInfluences",c)}l.getUniforms().setValue(r,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(r,"morphTargetsTextureSize",f.size)}return{update:s}}function wC(r,t,e,n,i){let s=new WeakMap;function o(c){let u=i.render.frame,h=c.geometry,f=t.get(c,h);if(s.get(f)!==u&&(t.update(f),s.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(e.update(c.instanceMatrix,r.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,r.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;s.get(d)!==u&&(d.update(),s.set(d,u))}return f}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var MC={[Up]:"LINEAR_TONE_MAPPING",[Op]:"REINHARD_TONE_MAPPING",[kp]:"CINEON_TONE_MAPPING",[Bp]:"ACES_FILMIC_TONE_MAPPING",[Vp]:"AGX_TONE_MAPPING",[Gp]:"NEUTRAL_TONE_MAPPING",[zp]:"CUSTOM_TONE_MAPPING"};function SC(r,t,e,n,i,s){let o=new ki(t,e,{type:r,depthBuffer:i,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new hn;u.setAttribute("position",new He([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new He([0,2,0,0,2,0],2));let h=new Hu({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new We(u,h),d=new Nl(-1,1,1,-1,0,1),p=null,y=null,g=!1,m,x=null,w=[],_=!1;this.setSize=function(E,S){o.setSize(E,S),a!==null&&a.setSize(E,S),l!==null&&l.setSize(E,S);for(let v=0;v<w.length;v++){let b=w[v];b.setSize&&b.setSize(E,S)}},this.setEffects=function(E){w=E,_=w.length>0&&w[0].isRenderPass===!0;let S=o.width,v=o.height;w.length>0&&a===null&&(a=new ki(S,v,{type:mr,depthBuffer:!1,stencilBuffer:!1}),l=new ki(S,v,{type:mr,depthBuffer:!1,stencilBuffer:!1}));let b=i===!0&&w.some(N=>N.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new is(S,v),s===!0&&(c.format=ss,c.type=fo)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let N=0;N<w.length;N++){let C=w[N];C.setSize&&C.setSize(S,v),b&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(E,S){if(g||E.toneMapping===Fr&&w.length===0)return!1;if(x=S,S!==null){let v=S.width,b=S.height;(o.width!==v||o.height!==b)&&this.setSize(v,b)}return _===!1&&E.setRenderTarget(o),m=E.toneMapping,E.toneMapping=Fr,!0},this.hasRenderPass=function(){return _},this.end=function(E,S){E.toneMapping=m,g=!0;let v=o,b=a;for(let N=0;N<w.length;N++){let C=w[N];C.enabled!==!1&&(C.render(E,b,v,S),C.needsSwap!==!1&&(v=b,b=b===a?l:a))}if(p!==E.outputColorSpace||y!==E.toneMapping){p=E.outputColorSpace,y=E.toneMapping,h.defines={},_e.getTransfer(p)===Ce&&(h.defines.SRGB_TRANSFER="");let N=MC[y];N&&(h.defines[N]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=v.texture,E.setRenderTarget(x),E.render(f,d),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var zv=new xi,Vv=new is(1,1),Gv=new wl(1),Hv=new ml,Wv=new Ou,qv=new bl,_v=[],vv=[],bv=new Float32Array(16),wv=new Float32Array(9),Mv=new Float32Array(4);function Aa(r,t,e){let n=r[0];if(n<=0||n>0)return r;let i=t*e,s=_v[i];if(s===void 0&&(s=new Float32Array(i),_v[i]=s),t!==0){n.toArray(s,0);for(let o=1,a=0;o!==t;++o)a+=e,r[o].toArray(s,a)}return s}function In(r,t){if(r.length!==t.length)return!1;for(let e=0,n=r.length;e<n;e++)if(r[e]!==t[e])return!1;return!0}function Ln(r,t){for(let e=0,n=t.length;e<n;e++)r[e]=t[e]}function jh(r,t){let e=vv[t];e===void 0&&(e=new Int32Array(t),vv[t]=e);for(let n=0;n!==t;++n)e[n]=r.allocateTextureUnit();return e}function AC(r,t){let e=this.cache;e[0]!==t&&(r.uniform1f(this.addr,t),e[0]=t)}function EC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(r.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(In(e,t))return;r.uniform2fv(this.addr,t),Ln(e,t)}}function TC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(r.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(r.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(In(e,t))return;r.uniform3fv(this.addr,t),Ln(e,t)}}function RC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(r.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(In(e,t))return;r.uniform4fv(this.addr,t),Ln(e,t)}}function CC(r,t){let e=this.cache,n=t.elements;if(n===void 0){if(In(e,t))return;r.uniformMatrix2fv(this.addr,!1,t),Ln(e,t)}else{if(In(e,n))return;Mv.set(n),r.uniformMatrix2fv(this.addr,!1,Mv),Ln(e,n)}}function PC(r,t){let e=this.cache,n=t.elements;if(n===void 0){if(In(e,t))return;r.uniformMatrix3fv(this.addr,!1,t),Ln(e,t)}else{if(In(e,n))return;wv.set(n),r.uniformMatrix3fv(this.addr,!1,wv),Ln(e,n)}}function IC(r,t){let e=this.cache,n=t.elements;if(n===void 0){if(In(e,t))return;r.uniformMatrix4fv(this.addr,!1,t),Ln(e,t)}else{if(In(e,n))return;bv.set(n),r.uniformMatrix4fv(this.addr,!1,bv),Ln(e,n)}}function LC(r,t){let e=this.cache;e[0]!==t&&(r.uniform1i(this.addr,t),e[0]=t)}function FC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(r.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(In(e,t))return;r.uniform2iv(this.addr,t),Ln(e,t)}}function NC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(r.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(In(e,t))return;r.uniform3iv(this.addr,t),Ln(e,t)}}function DC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(r.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(In(e,t))return;r.uniform4iv(this.addr,t),Ln(e,t)}}function UC(r,t){let e=this.cache;e[0]!==t&&(r.uniform1ui(this.addr,t),e[0]=t)}function OC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(r.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(In(e,t))return;r.uniform2uiv(this.addr,t),Ln(e,t)}}function kC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(r.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(In(e,t))return;r.uniform3uiv(this.addr,t),Ln(e,t)}}function BC(r,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(r.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(In(e,t))return;r.uniform4uiv(this.addr,t),Ln(e,t)}}function Zh(r){return r.version===0&&(r.compareFunction=Qp,r.needsUpdate=!0),r}function zC(r,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(r.uniform1i(this.addr,i),n[0]=i);let s;this.type===r.SAMPLER_2D_SHADOW?s=Zh(Vv):s=zv,e.setTexture2D(t||s,i)}function VC(r,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(r.uniform1i(this.addr,i),n[0]=i),e.setTexture3D(t||Wv,i)}function GC(r,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(r.uniform1i(this.addr,i),n[0]=i);let s;this.type===r.SAMPLER_CUBE_SHADOW?s=Zh(Gv):s=qv,e.setTextureCube(t||s,i)}function HC(r,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(r.uniform1i(this.addr,i),n[0]=i),e.setTexture2DArray(t||Hv,i)}function WC(r){switch(r){case 5126:return AC;case 35664:return EC;case 35665:return TC;case 35666:return RC;case 35674:return CC;case 35675:return PC;case 35676:return IC;case 5124:case 35670:return LC;case 35667:case 35671:return FC;case 35668:case 35672:return NC;case 35669:case 35673:return DC;case 5125:return UC;case 36294:return OC;case 36295:return kC;case 36296:return BC;case 35678:case 36198:case 36298:case 36306:case 35682:return zC;case 35679:case 36299:case 36307:return VC;case 35680:case 36300:case 36308:case 36293:return GC;case 36289:case 36303:case 36311:case 36292:return HC}}function qC(r,t){r.uniform1fv(this.addr,t)}function XC(r,t){let e=Aa(t,this.size,2);r.uniform2fv(this.addr,e)}function $C(r,t){let e=Aa(t,this.size,3);r.uniform3fv(this.addr,e)}function YC(r,t){let e=Aa(t,this.size,4);r.uniform4fv(this.addr,e)}function jC(r,t){let e=Aa(t,this.size,4);r.uniformMatrix2fv(this.addr,!1,e)}function ZC(r,t){let e=Aa(t,this.size,9);r.uniformMatrix3fv(this.addr,!1,e)}function KC(r,t){let e=Aa(t,this.size,16);r.uniformMatrix4fv(this.addr,!1,e)}function JC(r,t){r.uniform1iv(this.addr,t)}function QC(r,t){r.uniform2iv(this.addr,t)}function t2(r,t){r.uniform3iv(this.addr,t)}function e2(r,t){r.uniform4iv(this.addr,t)}function n2(r,t){r.uniform1uiv(this.addr,t)}function i2(r,t){r.uniform2uiv(this.addr,t)}function r2(r,t){r.uniform3uiv(this.addr,t)}function s2(r,t){r.uniform4uiv(this.addr,t)}function o2(r,t,e){let n=this.cache,i=t.length,s=jh(e,i);In(n,s)||(r.uniform1iv(this.addr,s),Ln(n,s));let o;this.type===r.SAMPLER_2D_SHADOW?o=Zh(Vv):o=zv;for(let a=0;a!==i;++a)e.setTexture2D(t[a]||o,s[a])}function a2(r,t,e){let n=this.cache,i=t.length,s=jh(e,i);In(n,s)||(r.uniform1iv(this.addr,s),Ln(n,s));for(let o=0;o!==i;++o)e.setTexture3D(t[o]||Wv,s[o])}function l2(r,t,e){let n=this.cache,i=t.length,s=jh(e,i);In(n,s)||(r.uniform1iv(this.addr,s),Ln(n,s));let o;this.type===r.SAMPLER_CUBE_SHADOW?o=Zh(Gv):o=qv;for(let a=0;a!==i;++a)e.setTextureCube(t[a]||o,s[a])}function c2(r,t,e){let n=this.cache,i=t.length,s=jh(e,i);In(n,s)||(r.uniform1iv(this.addr,s),Ln(n,s));for(let o=0;o!==i;++o)e.setTexture2DArray(t[o]||Hv,s[o])}function u2(r){switch(r){case 5126:return qC;case 35664:return XC;case 35665:return $C;case 35666:return YC;case 35674:return jC;case 35675:return ZC;case 35676:return KC;case 5124:case 35670:return JC;case 35667:case 35671:return QC;case 35668:case 35672:return t2;case 35669:case 35673:return e2;case 5125:return n2;case 36294:return i2;case 36295:return r2;case 36296:return s2;case 35678:case 36198:case 36298:case 36306:case 35682:return o2;case 35679:case 36299:case 36307:return a2;case 35680:case 36300:case 36308:case 36293:return l2;case 36289:case 36303:case 36311:case 36292:return c2}}var dm=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=WC(e.type)}},pm=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=u2(e.type)}},mm=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let i=this.seq;for(let s=0,o=i.length;s!==o;++s){let a=i[s];a.setValue(t,e[a.id],n)}}},hm=/(\w+)(\])?(\[|\.)?/g;function Sv(r,t){r.seq.push(t),r.map[t.id]=t}function h2(r,t,e){let n=r.name,i=n.length;for(hm.lastIndex=0;;){let s=hm.exec(n),o=hm.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===i){Sv(e,c===void 0?new dm(a,r,t):new pm(a,r,t));break}else{let h=e.map[a];h===void 0&&(h=new mm(a),Sv(e,h)),e=h}}}var Sa=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);h2(a,l,this)}let i=[],s=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?i.push(o):s.push(o);i.length>0&&(this.seq=i.concat(s))}setValue(t,e,n,i){let s=this.map[e];s!==void 0&&s.setValue(t,n,i)}setOptional(t,e,n){let i=e[n];i!==void 0&&this.setValue(t,n,i)}static upload(t,e,n,i){for(let s=0,o=e.length;s!==o;++s){let a=e[s],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,i)}}static seqWithValue(t,e){let n=[];for(let i=0,s=t.length;i!==s;++i){let o=t[i];o.id in e&&n.push(o)}return n}};function Av(r,t,e){let n=r.createShader(t);return r.shaderSource(n,e),r.compileShader(n),n}var f2=37297,d2=0;function p2(r,t){let e=r.split(`
`),n=[],i=Math.max(t-6,0),s=Math.min(t+6,e.length);for(let o=i;o<s;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Ev=new oe;function m2(r){_e._getMatrix(Ev,_e.workingColorSpace,r);let t=`mat3( ${Ev.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(r)){case fl:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return Zt("WebGLProgram: Unsupported color space: ",r),[t,"LinearTransferOETF"]}}function Tv(r,t,e){let n=r.getShaderParameter(t,r.COMPILE_STATUS),s=(r.getShaderInfoLog(t)||"").trim();if(n&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+s+`

`+p2(r.getShaderSource(t),a)}else return s}function g2(r,t){let e=m2(t);return[`vec4 ${r}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var y2={[Up]:"Linear",[Op]:"Reinhard",[kp]:"Cineon",[Bp]:"ACESFilmic",[Vp]:"AgX",[Gp]:"Neutral",[zp]:"Custom"};function x2(r,t){let e=y2[t];return e===void 0?(Zt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+r+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+r+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Xh=new z;function _2(){_e.getLuminanceCoefficients(Xh);let r=Xh.x.toFixed(4),t=Xh.y.toFixed(4),e=Xh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${r}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function v2(r){return[r.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",r.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(jl).join(`
`)}function b2(r){let t=[];for(let e in r){let n=r[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function w2(r,t){let e={},n=r.getProgramParameter(t,r.ACTIVE_ATTRIBUTES);for(let i=0;i<n;i++){let s=r.getActiveAttrib(t,i),o=s.name,a=1;s.type===r.FLOAT_MAT2&&(a=2),s.type===r.FLOAT_MAT3&&(a=3),s.type===r.FLOAT_MAT4&&(a=4),e[o]={type:s.type,location:r.getAttribLocation(t,o),locationSize:a}}return e}function jl(r){return r!==""}function Rv(r,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return r.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Cv(r,t){return r.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var M2=/^[ \t]*#include +<([\w\d./]+)>/gm;function gm(r){return r.replace(M2,S2)}function S2(r,t){let e=de[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return gm(e)}var A2=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Pv(r){return r.replace(A2,E2)}function E2(r,t,e,n){let i="";for(let s=parseInt(t);s<parseInt(e);s++)i+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return i}function Iv(r){let t=`precision ${r.precision} float;
	precision ${r.precision} int;
	precision ${r.precision} sampler2D;
	precision ${r.precision} samplerCube;
	precision ${r.precision} sampler3D;
	precision ${r.precision} sampler2DArray;
	precision ${r.precision} sampler2DShadow;
	precision ${r.precision} samplerCubeShadow;
	precision ${r.precision} sampler2DArrayShadow;
	precision ${r.precision} isampler2D;
	precision ${r.precision} isampler3D;
	precision ${r.precision} isamplerCube;
	precision ${r.precision} isampler2DArray;
	precision ${r.precision} usampler2D;
	precision ${r.precision} usampler3D;
	precision ${r.precision} usamplerCube;
	precision ${r.precision} usampler2DArray;
	`;return r.precision==="highp"?t+=`
#define HIGH_PRECISION`:r.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:r.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var T2={[lo]:"SHADOWMAP_TYPE_PCF",[va]:"SHADOWMAP_TYPE_VSM"};function R2(r){return T2[r.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var C2={[wa]:"ENVMAP_MODE_REFRACTION"};function P2(r){return r.envMap===!1?"ENVMAP_MODE_REFLECTION":C2[r.envMapMode]||"ENVMAP_MODE_REFLECTION"}var I2={[rh]:"ENVMAP_BLENDING_MULTIPLY",[K_]:"ENVMAP_BLENDING_MIX",[J_]:"ENVMAP_BLENDING_ADD"};function L2(r){return r.envMap===!1?"ENVMAP_BLENDING_NONE":I2[r.combine]||"ENVMAP_BLENDING_NONE"}function F2(r,t,e,n){let i=r.getContext(),s=e.defines,o=e.vertexShader,a=e.fragmentShader,l=R2(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=P2(e),h=L2(e),f=v2(e),d=b2(s),p=i.createProgram(),y,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(jl).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(jl).join(`
`),g.length>0&&(g+=`
`)):(y=[Iv(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(jl).join(`
`),g=[Iv(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Fr?"#define TONE_MAPPING":"",e.toneMapping!==Fr?de.tonemapping_pars_fragment:"",e.toneMapping!==Fr?x2("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",de.colorspace_pars_fragment,g2("linearToOutputTexel",e.outputColorSpace),_2(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(jl).join(`
`)),o=gm(o),o=Rv(o,e),o=Cv(o,e),a=gm(a),a=Rv(a,e),a=Cv(a,e),o=Pv(o),a=Pv(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",e.glslVersion===nm?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===nm?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=m+y+o,w=m+g+a,_=Av(i,i.VERTEX_SHADER,x),E=Av(i,i.FRAGMENT_SHADER,w);i.attachShader(p,_),i.attachShader(p,E),e.index0AttributeName!==void 0?i.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&i.bindAttribLocation(p,0,"position"),i.linkProgram(p);function S(C){if(r.debug.checkShaderErrors){let I=i.getProgramInfoLog(p)||"",U=i.getShaderInfoLog(_)||"",B=i.getShaderInfoLog(E)||"",F=I.trim(),V=U.trim(),q=B.trim(),G=!0,rt=!0;if(i.getProgramParameter(p,i.LINK_STATUS)===!1)if(G=!1,typeof r.debug.onShaderError=="function")r.debug.onShaderError(i,p,_,E);else{let $=Tv(i,_,"vertex"),j=Tv(i,E,"fragment");se("WebGLProgram: Shader Error "+i.getError()+" - VALIDATE_STATUS "+i.getProgramParameter(p,i.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+F+`
`+$+`
`+j)}else F!==""?Zt("WebGLProgram: Program Info Log:",F):(V===""||q==="")&&(rt=!1);rt&&(C.diagnostics={runnable:G,programLog:F,vertexShader:{log:V,prefix:y},fragmentShader:{log:q,prefix:g}})}i.deleteShader(_),i.deleteShader(E),v=new Sa(i,p),b=w2(i,p)}let v;this.getUniforms=function(){return v===void 0&&S(this),v};let b;this.getAttributes=function(){return b===void 0&&S(this),b};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=i.getProgramParameter(p,f2)),N},this.destroy=function(){n.releaseStatesOfProgram(this),i.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=d2++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=_,this.fragmentShader=E,this}var N2=0,ym=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let i=this._getShaderCacheForMaterial(t);return i.has(e)===!1&&(i.add(e),e.usedTimes++),i.has(n)===!1&&(i.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new xm(t),e.set(t,n)),n}},xm=class{constructor(t){this.id=N2++,this.code=t,this.usedTimes=0}};function D2(r){return r===Us||r===Wl||r===ql}function U2(r,t,e,n,i,s){let o=new gl,a=new ym,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,b,N,C,I,U){let B=C.fog,F=I.geometry,V=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?C.environment:null,q=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=t.get(v.envMap||V,q),rt=f[v.type],$=n.precision;v.precision!==null&&($=n.getMaxPrecision(v.precision),$!==v.precision&&Zt("WebGLProgram.getParameters:",v.precision,"not supported, using",$,"instead."));let j=F.morphAttributes.position||F.morphAttributes.normal||F.morphAttributes.color,tt=j!==void 0?j.length:0,ut=0;F.morphAttributes.position!==void 0&&(ut=1),F.morphAttributes.normal!==void 0&&(ut=2),F.morphAttributes.color!==void 0&&(ut=3);let ct,J,gt,yt;if(rt){let Ct=gi[rt];ct=Ct.vertexShader,J=Ct.fragmentShader}else{ct=v.vertexShader,J=v.fragmentShader;let Ct=a.getVertexShaderStage(v),he=a.getFragmentShaderStage(v);a.update(v,Ct,he),gt=Ct.id,yt=he.id}let Mt=r.getRenderTarget(),xt=r.state.buffers.depth.getReversed(),zt=I.isInstancedMesh===!0,te=I.isBatchedMesh===!0,dt=!!v.map,Wt=!!v.matcap,qt=!!G,Yt=qt&&G.isPMREMTexture===!0,ve=!!v.aoMap,Ue=!!v.lightMap,mn=!!v.bumpMap&&v.wireframe===!1,Oe=!!v.normalMap,Nn=!!v.displacementMap,be=!!v.emissiveMap,An=!!v.metalnessMap,rn=!!v.roughnessMap,gn=v.anisotropy>0,k=v.clearcoat>0,Pt=v.diffuseRoughness>0,Kt=v.dispersion>0,le=v.retroreflectivity>0,At=v.iridescence>0,Be=v.sheen>0,Gt=v.transmission>0,jt=gn&&!!v.anisotropyMap,P=k&&!!v.clearcoatMap,A=k&&!!v.clearcoatNormalMap,X=k&&!!v.clearcoatRoughnessMap,ft=Pt&&!!v.diffuseRoughnessMap,ot=At&&!!v.iridescenceMap,vt=At&&!!v.iridescenceThicknessMap,bt=Be&&!!v.sheenColorMap,et=Be&&!!v.sheenRoughnessMap,it=!!v.specularMap,mt=!!v.specularColorMap,O=!!v.specularIntensityMap,st=Gt&&!!v.transmissionMap,nt=Gt&&!!v.thicknessMap,Et=!!v.gradientMap,_t=!!v.alphaMap,St=v.alphaTest>0,Ht=!!v.alphaHash,ee=!!v.extensions,ht=Fr;v.toneMapped&&(Mt===null||Mt.isXRRenderTarget===!0)&&(ht=r.toneMapping);let kt=Yt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,ne={shaderID:rt,shaderType:v.type,shaderName:v.name,vertexShader:ct,fragmentShader:J,defines:v.defines,customVertexShaderID:gt,customFragmentShaderID:yt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:$,batching:te,batchingColor:te&&I._colorsTexture!==null,instancing:zt,instancingColor:zt&&I.instanceColor!==null,instancingMorph:zt&&I.morphTexture!==null,outputColorSpace:Mt===null?r.outputColorSpace:Mt.isXRRenderTarget===!0?Mt.texture.colorSpace:_e.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:dt,matcap:Wt,envMap:qt,envMapMode:qt&&G.mapping,envMapPMREM:Yt,envMapMaxLod:Yt?kt.length-1:null,envMapSize:Yt?kt[0].width:null,aoMap:ve,lightMap:Ue,bumpMap:mn,normalMap:Oe,displacementMap:Nn,emissiveMap:be,normalMapObjectSpace:Oe&&v.normalMapType===ev,normalMapTangentSpace:Oe&&v.normalMapType===Xl,packedNormalMap:Oe&&v.normalMapType===Xl&&D2(v.normalMap.format),metalnessMap:An,roughnessMap:rn,anisotropy:gn,anisotropyMap:jt,clearcoat:k,clearcoatMap:P,clearcoatNormalMap:A,clearcoatRoughnessMap:X,diffuseRoughness:Pt,diffuseRoughnessMap:ft,dispersion:Kt,retroreflection:le,iridescence:At,iridescenceMap:ot,iridescenceThicknessMap:vt,sheen:Be,sheenColorMap:bt,sheenRoughnessMap:et,specularMap:it,specularColorMap:mt,specularIntensityMap:O,transmission:Gt,transmissionMap:st,thicknessMap:nt,gradientMap:Et,opaque:v.transparent===!1&&v.blending===ba&&v.alphaToCoverage===!1,alphaMap:_t,alphaTest:St,alphaHash:Ht,combine:v.combine,mapUv:dt&&d(v.map.channel),aoMapUv:ve&&d(v.aoMap.channel),lightMapUv:Ue&&d(v.lightMap.channel),bumpMapUv:mn&&d(v.bumpMap.channel),normalMapUv:Oe&&d(v.normalMap.channel),displacementMapUv:Nn&&d(v.displacementMap.channel),emissiveMapUv:be&&d(v.emissiveMap.channel),metalnessMapUv:An&&d(v.metalnessMap.channel),roughnessMapUv:rn&&d(v.roughnessMap.channel),anisotropyMapUv:jt&&d(v.anisotropyMap.channel),clearcoatMapUv:P&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:A&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:bt&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:et&&d(v.sheenRoughnessMap.channel),specularMapUv:it&&d(v.specularMap.channel),specularColorMapUv:mt&&d(v.specularColorMap.channel),specularIntensityMapUv:O&&d(v.specularIntensityMap.channel),transmissionMapUv:st&&d(v.transmissionMap.channel),thicknessMapUv:nt&&d(v.thicknessMap.channel),alphaMapUv:_t&&d(v.alphaMap.channel),vertexTangents:!!F.attributes.tangent&&(Oe||gn),vertexNormals:!!F.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!F.attributes.color&&F.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!F.attributes.uv&&(dt||_t),fog:!!B,useFog:v.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||F.attributes.normal===void 0&&Oe===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:xt,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:F.attributes.position!==void 0,morphTargets:F.morphAttributes.position!==void 0,morphNormals:F.morphAttributes.normal!==void 0,morphColors:F.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:ut,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:U.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:v.dithering,shadowMapEnabled:r.shadowMap.enabled&&N.length>0,shadowMapType:r.shadowMap.type,toneMapping:ht,decodeVideoTexture:dt&&v.map.isVideoTexture===!0&&_e.getTransfer(v.map.colorSpace)===Ce,decodeVideoTextureEmissive:be&&v.emissiveMap.isVideoTexture===!0&&_e.getTransfer(v.emissiveMap.colorSpace)===Ce,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Qi,flipSided:v.side===mi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:ee&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&v.extensions.multiDraw===!0||te)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return ne.vertexUv1s=l.has(1),ne.vertexUv2s=l.has(2),ne.vertexUv3s=l.has(3),l.clear(),ne}function y(v){let b=[];if(v.shaderID?b.push(v.shaderID):(b.push(v.customVertexShaderID),b.push(v.customFragmentShaderID)),v.defines!==void 0)for(let N in v.defines)b.push(N),b.push(v.defines[N]);return v.isRawShaderMaterial===!1&&(g(b,v),m(b,v),b.push(r.outputColorSpace)),b.push(v.customProgramCacheKey),b.join()}function g(v,b){v.push(b.precision),v.push(b.outputColorSpace),v.push(b.envMapMode),v.push(b.envMapPMREM),v.push(b.envMapMaxLod),v.push(b.envMapSize),v.push(b.mapUv),v.push(b.alphaMapUv),v.push(b.lightMapUv),v.push(b.aoMapUv),v.push(b.bumpMapUv),v.push(b.normalMapUv),v.push(b.displacementMapUv),v.push(b.emissiveMapUv),v.push(b.metalnessMapUv),v.push(b.roughnessMapUv),v.push(b.anisotropyMapUv),v.push(b.clearcoatMapUv),v.push(b.clearcoatNormalMapUv),v.push(b.clearcoatRoughnessMapUv),v.push(b.diffuseRoughnessMapUv),v.push(b.iridescenceMapUv),v.push(b.iridescenceThicknessMapUv),v.push(b.sheenColorMapUv),v.push(b.sheenRoughnessMapUv),v.push(b.specularMapUv),v.push(b.specularColorMapUv),v.push(b.specularIntensityMapUv),v.push(b.transmissionMapUv),v.push(b.thicknessMapUv),v.push(b.combine),v.push(b.fogExp2),v.push(b.sizeAttenuation),v.push(b.morphTargetsCount),v.push(b.numSunLights),v.push(b.numDirLights),v.push(b.numPointLights),v.push(b.numSpotLights),v.push(b.numSpotLightMaps),v.push(b.numHemiLights),v.push(b.numRectAreaLights),v.push(b.numSunLightShadows),v.push(b.numDirLightShadows),v.push(b.numPointLightShadows),v.push(b.numSpotLightShadows),v.push(b.numSpotLightShadowsWithMaps),v.push(b.numLightProbes),v.push(b.numLightProbeGrids),v.push(b.shadowMapType),v.push(b.toneMapping),v.push(b.numClippingPlanes),v.push(b.numClipIntersection),v.push(b.depthPacking)}function m(v,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function x(v){let b=f[v.type],N;if(b){let C=gi[b];N=$l.clone(C.uniforms)}else N=v.uniforms;return N}function w(v,b){let N=u.get(b);return N!==void 0?++N.usedTimes:(N=new F2(r,b,v,i),c.push(N),u.set(b,N)),N}function _(v){if(--v.usedTimes===0){let b=c.indexOf(v);c[b]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function E(v){a.remove(v)}function S(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:x,acquireProgram:w,releaseProgram:_,releaseShaderCache:E,programs:c,dispose:S}}function O2(){let r=new WeakMap;function t(o){return r.has(o)}function e(o){let a=r.get(o);return a===void 0&&(a={},r.set(o,a)),a}function n(o){r.delete(o)}function i(o,a,l){r.get(o)[a]=l}function s(){r=new WeakMap}return{has:t,get:e,remove:n,update:i,dispose:s}}function k2(r,t){return r.groupOrder!==t.groupOrder?r.groupOrder-t.groupOrder:r.renderOrder!==t.renderOrder?r.renderOrder-t.renderOrder:r.material.id!==t.material.id?r.material.id-t.material.id:r.materialVariant!==t.materialVariant?r.materialVariant-t.materialVariant:r.z!==t.z?r.z-t.z:r.id-t.id}function Lv(r,t){return r.groupOrder!==t.groupOrder?r.groupOrder-t.groupOrder:r.renderOrder!==t.renderOrder?r.renderOrder-t.renderOrder:r.z!==t.z?t.z-r.z:r.id-t.id}function Fv(){let r=[],t=0,e=[],n=[],i=[];function s(){t=0,e.length=0,n.length=0,i.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,p,y,g,m){let x=r[t];return x===void 0?(x={id:f.id,object:f,geometry:d,material:p,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:g,group:m},r[t]=x):(x.id=f.id,x.object=f,x.geometry=d,x.material=p,x.materialVariant=o(f),x.groupOrder=y,x.renderOrder=f.renderOrder,x.z=g,x.group=m),t++,x}function l(f,d,p,y,g,m,x){x.reversedDepth===!0&&(g=-g);let w=a(f,d,p,y,g,m);p.transmission>0?n.push(w):p.transparent===!0?i.push(w):e.push(w)}function c(f,d,p,y,g,m){let x=a(f,d,p,y,g,m);p.transmission>0?n.unshift(x):p.transparent===!0?i.unshift(x):e.unshift(x)}function u(f,d){e.length>1&&e.sort(f||k2),n.length>1&&n.sort(d||Lv),i.length>1&&i.sort(d||Lv)}function h(){for(let f=t,d=r.length;f<d;f++){let p=r[f];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:i,init:s,push:l,unshift:c,finish:h,sort:u}}function B2(){let r=new WeakMap;function t(n,i){let s=r.get(n),o;return s===void 0?(o=new Fv,r.set(n,[o])):i>=s.length?(o=new Fv,s.push(o)):o=s[i],o}function e(){r=new WeakMap}return{get:t,dispose:e}}function z2(){let r={};return{get:function(t){if(r[t.id]!==void 0)return r[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new z,color:new ue};break;case"SpotLight":e={position:new z,direction:new z,color:new ue,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new ue,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new ue,groundColor:new ue};break;case"RectAreaLight":e={color:new ue,position:new z,halfWidth:new z,halfHeight:new z};break}return r[t.id]=e,e}}}function V2(){let r={};return{get:function(t){if(r[t.id]!==void 0)return r[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return r[t.id]=e,e}}}var G2=0;function H2(r,t){return(t.castShadow?2:0)-(r.castShadow?2:0)+(t.map?1:0)-(r.map?1:0)}function W2(r){let t=new z2,e=V2(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new z);let i=new z,s=new Ge,o=new Ge;function a(c){let u=0,h=0,f=0;for(let U=0;U<9;U++)n.probe[U].set(0,0,0);let d=0,p=0,y=0,g=0,m=0,x=0,w=0,_=0,E=0,S=0,v=0,b=0,N=0,C=0;c.sort(H2);for(let U=0,B=c.length;U<B;U++){let F=c[U],V=F.color,q=F.intensity,G=F.distance,rt=null;if(F.shadow&&F.shadow.map&&(F.shadow.map.texture.format===Us?rt=F.shadow.map.texture:rt=F.shadow.map.depthTexture||F.shadow.map.texture),F.isAmbientLight)u+=V.r*q,h+=V.g*q,f+=V.b*q;else if(F.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(F.sh.coefficients[$],q);C++}else if(F.isSunLight){let $=t.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let j=F.shadow,tt=e.get(F);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[p]=tt,n.sunShadowMap[p]=rt;let ut=j.getViewportCount();for(let ct=0;ct<ut;ct++)n.sunShadowMatrix[y+ct]=j.getMatrix(ct),n.sunShadowCascade[y+ct]=j._cascadeData[ct];y+=ut,p++}n.sun[d]=$,d++}else if(F.isDirectionalLight){let $=t.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let j=F.shadow,tt=e.get(F);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,n.directionalShadow[g]=tt,n.directionalShadowMap[g]=rt,n.directionalShadowMatrix[g]=F.shadow.matrix,E++}n.directional[g]=$,g++}else if(F.isSpotLight){let $=t.get(F);$.position.setFromMatrixPosition(F.matrixWorld),$.color.copy(V).multiplyScalar(q),$.distance=G,$.coneCos=Math.cos(F.angle),$.penumbraCos=Math.cos(F.angle*(1-F.penumbra)),$.decay=F.decay,n.spot[x]=$;let j=F.shadow;if(F.map&&(n.spotLightMap[b]=F.map,b++,j.updateMatrices(F),F.castShadow&&N++),n.spotLightMatrix[x]=j.matrix,F.castShadow){let tt=e.get(F);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,n.spotShadow[x]=tt,n.spotShadowMap[x]=rt,v++}x++}else if(F.isRectAreaLight){let $=t.get(F);$.color.copy(V).multiplyScalar(q),$.halfWidth.set(F.width*.5,0,0),$.halfHeight.set(0,F.height*.5,0),n.rectArea[w]=$,w++}else if(F.isPointLight){let $=t.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),$.distance=F.distance,$.decay=F.decay,F.castShadow){let j=F.shadow,tt=e.get(F);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,tt.shadowCameraNear=j.camera.near,tt.shadowCameraFar=j.camera.far,n.pointShadow[m]=tt,n.pointShadowMap[m]=rt,n.pointShadowMatrix[m]=F.shadow.matrix,S++}n.point[m]=$,m++}else if(F.isHemisphereLight){let $=t.get(F);$.skyColor.copy(F.color).multiplyScalar(q),$.groundColor.copy(F.groundColor).multiplyScalar(q),n.hemi[_]=$,_++}}w>0&&(r.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=It.LTC_FLOAT_1,n.rectAreaLTC2=It.LTC_FLOAT_2):(n.rectAreaLTC1=It.LTC_HALF_1,n.rectAreaLTC2=It.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let I=n.hash;(I.sunLength!==d||I.directionalLength!==g||I.pointLength!==m||I.spotLength!==x||I.rectAreaLength!==w||I.hemiLength!==_||I.numSunShadows!==p||I.numDirectionalShadows!==E||I.numPointShadows!==S||I.numSpotShadows!==v||I.numSpotMaps!==b||I.numLightProbes!==C)&&(n.sun.length=d,n.directional.length=g,n.spot.length=x,n.rectArea.length=w,n.point.length=m,n.hemi.length=_,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.directionalShadowMatrix.length=E,n.pointShadow.length=S,n.pointShadowMap.length=S,n.pointShadowMatrix.length=S,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+b-N,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=C,I.sunLength=d,I.directionalLength=g,I.pointLength=m,I.spotLength=x,I.rectAreaLength=w,I.hemiLength=_,I.numSunShadows=p,I.numDirectionalShadows=E,I.numPointShadows=S,I.numSpotShadows=v,I.numSpotMaps=b,I.numLightProbes=C,n.version=G2++)}function l(c,u){let h=0,f=0,d=0,p=0,y=0,g=0,m=u.matrixWorldInverse;for(let x=0,w=c.length;x<w;x++){let _=c[x];if(_.isSunLight){let E=n.sun[h];E.direction.setFromMatrixPosition(_.matrixWorld),E.direction.transformDirection(m),h++}else if(_.isDirectionalLight){let E=n.directional[f];E.direction.setFromMatrixPosition(_.matrixWorld),i.setFromMatrixPosition(_.target.matrixWorld),E.direction.sub(i),E.direction.transformDirection(m),f++}else if(_.isSpotLight){let E=n.spot[p];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(m),E.direction.setFromMatrixPosition(_.matrixWorld),i.setFromMatrixPosition(_.target.matrixWorld),E.direction.sub(i),E.direction.transformDirection(m),p++}else if(_.isRectAreaLight){let E=n.rectArea[y];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(m),o.identity(),s.copy(_.matrixWorld),s.premultiply(m),o.extractRotation(s),E.halfWidth.set(_.width*.5,0,0),E.halfHeight.set(0,_.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),y++}else if(_.isPointLight){let E=n.point[d];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(m),d++}else if(_.isHemisphereLight){let E=n.hemi[g];E.direction.setFromMatrixPosition(_.matrixWorld),E.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function Nv(r){let t=new W2(r),e=[],n=[],i=[];function s(h){u.camera=h,e.length=0,n.length=0,i.length=0}function o(h){h.isLightProbeGrid?i.push(h):e.push(h)}function a(h){n.push(h)}function l(){t.setup(e),i.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:n,lightProbeGridArray:i,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function q2(r){let t=new WeakMap;function e(i,s=0){let o=t.get(i),a;return o===void 0?(a=new Nv(r),t.set(i,[a])):s>=o.length?(a=new Nv(r),o.push(a)):a=o[s],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var X2=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$2=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Y2=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],j2=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],Dv=new Ge,Yl=new z,fm=new z;function Z2(r,t,e){let n=new Es,i=new Jt,s=new Jt,o=new Pe,a=new Wu,l=new qu,c={},u=e.maxTextureSize,h={[Ds]:mi,[mi]:Ds,[Qi]:Qi},f=new Ji({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Jt},radius:{value:4}},vertexShader:X2,fragmentShader:$2}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let p=new hn;p.setAttribute("position",new un(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new We(p,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=lo;let m=this.type;this.render=function(S,v,b){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||S.length===0)return;this.type===L_&&(Zt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=lo);let N=r.getRenderTarget(),C=r.getActiveCubeFace(),I=r.getActiveMipmapLevel(),U=r.state;U.setBlending(co),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let B=m!==this.type;B&&v.traverse(function(F){F.material&&(Array.isArray(F.material)?F.material.forEach(V=>V.needsUpdate=!0):F.material.needsUpdate=!0)});for(let F=0,V=S.length;F<V;F++){let q=S[F],G=q.shadow;if(G===void 0){Zt("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;i.copy(G.mapSize);let rt=G.getFrameExtents();i.multiply(rt),s.copy(G.mapSize),(i.x>u||i.y>u)&&(i.x>u&&(s.x=Math.floor(u/rt.x),i.x=s.x*rt.x,G.mapSize.x=s.x),i.y>u&&(s.y=Math.floor(u/rt.y),i.y=s.y*rt.y,G.mapSize.y=s.y));let $=r.state.buffers.depth.getReversed();if(G.camera._reversedDepth=$,G.map===null||B===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===va){if(q.isPointLight){Zt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new ki(i.x,i.y,{format:Us,type:mr,minFilter:pi,magFilter:pi,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new is(i.x,i.y,pr),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=ns,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Gn,G.map.depthTexture.magFilter=Gn}else q.isPointLight?(G.map=new Zl(i.x),G.map.depthTexture=new wl(i.x,dr)):(G.map=new ki(i.x,i.y),G.map.depthTexture=new is(i.x,i.y,dr)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=ns,this.type===lo?(G.map.depthTexture.compareFunction=$?Jp:Kp,G.map.depthTexture.minFilter=pi,G.map.depthTexture.magFilter=pi):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Gn,G.map.depthTexture.magFilter=Gn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==i.x||G.map.height!==i.y)&&G.map.setSize(i.x,i.y);let j=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,b);let tt=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:b.layers;for(let ut=0;ut<j;ut++){let ct=G.getCamera(ut);if(q.isPointLight){let J=G.camera,gt=G.matrix,yt=q.distance||J.far;yt!==J.far&&(J.far=yt,J.updateProjectionMatrix()),Yl.setFromMatrixPosition(q.matrixWorld),J.position.copy(Yl),fm.copy(J.position),fm.add(Y2[ut]),J.up.copy(j2[ut]),J.lookAt(fm),J.updateMatrixWorld(),gt.makeTranslation(-Yl.x,-Yl.y,-Yl.z),Dv.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Dv,J.coordinateSystem,J.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)r.setRenderTarget(G.map,ut),r.clear();else{ut===0&&(r.setRenderTarget(G.map),r.clear());let J=G.getViewport(ut);o.set(s.x*J.x,s.y*J.y,s.x*J.z,s.y*J.w),U.viewport(o)}n=G.getFrustum(ut),_(v,b,ct,q,tt,this.type)}G.isPointLightShadow!==!0&&this.type===va&&x(G,b),G.needsUpdate=!1}m=this.type,g.needsUpdate=!1,r.setRenderTarget(N,C,I)};function x(S,v){let b=t.update(y);f.defines.VSM_SAMPLES!==S.blurSamples&&(f.defines.VSM_SAMPLES=S.blurSamples,d.defines.VSM_SAMPLES=S.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),S.mapPass===null?S.mapPass=new ki(i.x,i.y,{format:Us,type:mr}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),f.uniforms.shadow_pass.value=S.map.depthTexture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,r.setRenderTarget(S.mapPass),r.clear(),r.renderBufferDirect(v,null,b,f,y,null),d.uniforms.shadow_pass.value=S.mapPass.texture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,r.setRenderTarget(S.map),r.clear(),r.renderBufferDirect(v,null,b,d,y,null)}function w(S,v,b,N){let C=null,I=b.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(I!==void 0)C=I;else if(C=b.isPointLight===!0?l:a,r.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let U=C.uuid,B=v.uuid,F=c[U];F===void 0&&(F={},c[U]=F);let V=F[B];V===void 0&&(V=C.clone(),F[B]=V,v.addEventListener("dispose",E)),C=V}if(C.visible=v.visible,C.wireframe=v.wireframe,N===va?C.side=v.shadowSide!==null?v.shadowSide:v.side:C.side=v.shadowSide!==null?v.shadowSide:h[v.side],C.alphaMap=v.alphaMap,C.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,C.map=v.map,C.clipShadows=v.clipShadows,C.clippingPlanes=v.clippingPlanes,C.clipIntersection=v.clipIntersection,C.displacementMap=v.displacementMap,C.displacementScale=v.displacementScale,C.displacementBias=v.displacementBias,C.wireframeLinewidth=v.wireframeLinewidth,C.linewidth=v.linewidth,b.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let U=r.properties.get(C);U.light=b}return C}function _(S,v,b,N,C,I){if(S.visible===!1)return;if(S.layers.test(C)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&I===va)&&(!S.frustumCulled||S.intersectsFrustum(n))){S.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,S.matrixWorld);let F=t.update(S),V=S.material;if(Array.isArray(V)){let q=F.groups;for(let G=0,rt=q.length;G<rt;G++){let $=q[G],j=V[$.materialIndex];if(j&&j.visible){let tt=w(S,j,N,I);S.onBeforeShadow(r,S,v,b,F,tt,$),r.renderBufferDirect(b,null,F,tt,S,$),S.onAfterShadow(r,S,v,b,F,tt,$)}}}else if(V.visible){let q=w(S,V,N,I);S.onBeforeShadow(r,S,v,b,F,q,null),r.renderBufferDirect(b,null,F,q,S,null),S.onAfterShadow(r,S,v,b,F,q,null)}}let B=S.children;for(let F=0,V=B.length;F<V;F++)_(B[F],v,b,N,C,I)}function E(S){S.target.removeEventListener("dispose",E);for(let b in c){let N=c[b],C=S.target.uuid;C in N&&(N[C].dispose(),delete N[C])}}}function K2(r,t){function e(){let O=!1,st=new Pe,nt=null,Et=new Pe(0,0,0,0);return{setMask:function(_t){nt!==_t&&!O&&(r.colorMask(_t,_t,_t,_t),nt=_t)},setLocked:function(_t){O=_t},setClear:function(_t,St,Ht,ee,ht){ht===!0&&(_t*=ee,St*=ee,Ht*=ee),st.set(_t,St,Ht,ee),Et.equals(st)===!1&&(r.clearColor(_t,St,Ht,ee),Et.copy(st))},reset:function(){O=!1,nt=null,Et.set(-1,0,0,0)}}}function n(){let O=!1,st=!1,nt=null,Et=null,_t=null;return{setReversed:function(St){if(st!==St){let Ht=t.get("EXT_clip_control");St?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),st=St;let ee=_t;_t=null,this.setClear(ee)}},getReversed:function(){return st},setTest:function(St){St?xt(r.DEPTH_TEST):zt(r.DEPTH_TEST)},setMask:function(St){nt!==St&&!O&&(r.depthMask(St),nt=St)},setFunc:function(St){if(st&&(St=hv[St]),Et!==St){switch(St){case Au:r.depthFunc(r.NEVER);break;case Eu:r.depthFunc(r.ALWAYS);break;case Tu:r.depthFunc(r.LESS);break;case ua:r.depthFunc(r.LEQUAL);break;case Ru:r.depthFunc(r.EQUAL);break;case Cu:r.depthFunc(r.GEQUAL);break;case Pu:r.depthFunc(r.GREATER);break;case Iu:r.depthFunc(r.NOTEQUAL);break;default:r.depthFunc(r.LEQUAL)}Et=St}},setLocked:function(St){O=St},setClear:function(St){_t!==St&&(_t=St,st&&(St=1-St),r.clearDepth(St))},reset:function(){O=!1,nt=null,Et=null,_t=null,st=!1}}}function i(){let O=!1,st=null,nt=null,Et=null,_t=null,St=null,Ht=null,ee=null,ht=null;return{setTest:function(kt){O||(kt?xt(r.STENCIL_TEST):zt(r.STENCIL_TEST))},setMask:function(kt){st!==kt&&!O&&(r.stencilMask(kt),st=kt)},setFunc:function(kt,ne,Ct){(nt!==kt||Et!==ne||_t!==Ct)&&(r.stencilFunc(kt,ne,Ct),nt=kt,Et=ne,_t=Ct)},setOp:function(kt,ne,Ct){(St!==kt||Ht!==ne||ee!==Ct)&&(r.stencilOp(kt,ne,Ct),St=kt,Ht=ne,ee=Ct)},setLocked:function(kt){O=kt},setClear:function(kt){ht!==kt&&(r.clearStencil(kt),ht=kt)},reset:function(){O=!1,st=null,nt=null,Et=null,_t=null,St=null,Ht=null,ee=null,ht=null}}}let s=new e,o=new n,a=new i,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,p=[],y=null,g=!1,m=null,x=null,w=null,_=null,E=null,S=null,v=null,b=new ue(0,0,0),N=0,C=!1,I=null,U=null,B=null,F=null,V=null,q=r.getParameter(r.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,rt=0,$=r.getParameter(r.VERSION);$.indexOf("WebGL")!==-1?(rt=parseFloat(/^WebGL (\d)/.exec($)[1]),G=rt>=1):$.indexOf("OpenGL ES")!==-1&&(rt=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),G=rt>=2);let j=null,tt={},ut=r.getParameter(r.SCISSOR_BOX),ct=r.getParameter(r.VIEWPORT),J=new Pe().fromArray(ut),gt=new Pe().fromArray(ct);function yt(O,st,nt,Et){let _t=new Uint8Array(4),St=r.createTexture();r.bindTexture(O,St),r.texParameteri(O,r.TEXTURE_MIN_FILTER,r.NEAREST),r.texParameteri(O,r.TEXTURE_MAG_FILTER,r.NEAREST);for(let Ht=0;Ht<nt;Ht++)O===r.TEXTURE_3D||O===r.TEXTURE_2D_ARRAY?r.texImage3D(st,0,r.RGBA,1,1,Et,0,r.RGBA,r.UNSIGNED_BYTE,_t):r.texImage2D(st+Ht,0,r.RGBA,1,1,0,r.RGBA,r.UNSIGNED_BYTE,_t);return St}let Mt={};Mt[r.TEXTURE_2D]=yt(r.TEXTURE_2D,r.TEXTURE_2D,1),Mt[r.TEXTURE_CUBE_MAP]=yt(r.TEXTURE_CUBE_MAP,r.TEXTURE_CUBE_MAP_POSITIVE_X,6),Mt[r.TEXTURE_2D_ARRAY]=yt(r.TEXTURE_2D_ARRAY,r.TEXTURE_2D_ARRAY,1,1),Mt[r.TEXTURE_3D]=yt(r.TEXTURE_3D,r.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xt(r.DEPTH_TEST),o.setFunc(ua),mn(!1),Oe(Pp),xt(r.CULL_FACE),ve(co);function xt(O){u[O]!==!0&&(r.enable(O),u[O]=!0)}function zt(O){u[O]!==!1&&(r.disable(O),u[O]=!1)}function te(O,st){return f[O]!==st?(r.bindFramebuffer(O,st),f[O]=st,O===r.DRAW_FRAMEBUFFER&&(f[r.FRAMEBUFFER]=st),O===r.FRAMEBUFFER&&(f[r.DRAW_FRAMEBUFFER]=st),!0):!1}function dt(O,st){let nt=p,Et=!1;if(O){nt=d.get(st),nt===void 0&&(nt=[],d.set(st,nt));let _t=O.textures;if(nt.length!==_t.length||nt[0]!==r.COLOR_ATTACHMENT0){for(let St=0,Ht=_t.length;St<Ht;St++)nt[St]=r.COLOR_ATTACHMENT0+St;nt.length=_t.length,Et=!0}}else nt[0]!==r.BACK&&(nt[0]=r.BACK,Et=!0);Et&&r.drawBuffers(nt)}function Wt(O){return y!==O?(r.useProgram(O),y=O,!0):!1}let qt={[uo]:r.FUNC_ADD,[N_]:r.FUNC_SUBTRACT,[D_]:r.FUNC_REVERSE_SUBTRACT};qt[U_]=r.MIN,qt[O_]=r.MAX;let Yt={[k_]:r.ZERO,[B_]:r.ONE,[z_]:r.SRC_COLOR,[Np]:r.SRC_ALPHA,[X_]:r.SRC_ALPHA_SATURATE,[W_]:r.DST_COLOR,[G_]:r.DST_ALPHA,[V_]:r.ONE_MINUS_SRC_COLOR,[Dp]:r.ONE_MINUS_SRC_ALPHA,[q_]:r.ONE_MINUS_DST_COLOR,[H_]:r.ONE_MINUS_DST_ALPHA,[$_]:r.CONSTANT_COLOR,[Y_]:r.ONE_MINUS_CONSTANT_COLOR,[j_]:r.CONSTANT_ALPHA,[Z_]:r.ONE_MINUS_CONSTANT_ALPHA};function ve(O,st,nt,Et,_t,St,Ht,ee,ht,kt){if(O===co){g===!0&&(zt(r.BLEND),g=!1);return}if(g===!1&&(xt(r.BLEND),g=!0),O!==F_){if(O!==m||kt!==C){if((x!==uo||E!==uo)&&(r.blendEquation(r.FUNC_ADD),x=uo,E=uo),kt)switch(O){case ba:r.blendFuncSeparate(r.ONE,r.ONE_MINUS_SRC_ALPHA,r.ONE,r.ONE_MINUS_SRC_ALPHA);break;case Ip:r.blendFunc(r.ONE,r.ONE);break;case Lp:r.blendFuncSeparate(r.ZERO,r.ONE_MINUS_SRC_COLOR,r.ZERO,r.ONE);break;case Fp:r.blendFuncSeparate(r.DST_COLOR,r.ONE_MINUS_SRC_ALPHA,r.ZERO,r.ONE);break;default:se("WebGLState: Invalid blending: ",O);break}else switch(O){case ba:r.blendFuncSeparate(r.SRC_ALPHA,r.ONE_MINUS_SRC_ALPHA,r.ONE,r.ONE_MINUS_SRC_ALPHA);break;case Ip:r.blendFuncSeparate(r.SRC_ALPHA,r.ONE,r.ONE,r.ONE);break;case Lp:se("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Fp:se("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:se("WebGLState: Invalid blending: ",O);break}w=null,_=null,S=null,v=null,b.set(0,0,0),N=0,m=O,C=kt}return}_t=_t||st,St=St||nt,Ht=Ht||Et,(st!==x||_t!==E)&&(r.blendEquationSeparate(qt[st],qt[_t]),x=st,E=_t),(nt!==w||Et!==_||St!==S||Ht!==v)&&(r.blendFuncSeparate(Yt[nt],Yt[Et],Yt[St],Yt[Ht]),w=nt,_=Et,S=St,v=Ht),(ee.equals(b)===!1||ht!==N)&&(r.blendColor(ee.r,ee.g,ee.b,ht),b.copy(ee),N=ht),m=O,C=!1}function Ue(O,st){O.side===Qi?zt(r.CULL_FACE):xt(r.CULL_FACE);let nt=O.side===mi;st&&(nt=!nt),mn(nt),O.blending===ba&&O.transparent===!1?ve(co):ve(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),s.setMask(O.colorWrite);let Et=O.stencilWrite;a.setTest(Et),Et&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),be(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?xt(r.SAMPLE_ALPHA_TO_COVERAGE):zt(r.SAMPLE_ALPHA_TO_COVERAGE)}function mn(O){I!==O&&(O?r.frontFace(r.CW):r.frontFace(r.CCW),I=O)}function Oe(O){O!==P_?(xt(r.CULL_FACE),O!==U&&(O===Pp?r.cullFace(r.BACK):O===I_?r.cullFace(r.FRONT):r.cullFace(r.FRONT_AND_BACK))):zt(r.CULL_FACE),U=O}function Nn(O){O!==B&&(G&&r.lineWidth(O),B=O)}function be(O,st,nt){O?(xt(r.POLYGON_OFFSET_FILL),(F!==st||V!==nt)&&(F=st,V=nt,o.getReversed()&&(st=-st,nt=-nt),r.polygonOffset(st,nt))):zt(r.POLYGON_OFFSET_FILL)}function An(O){O?xt(r.SCISSOR_TEST):zt(r.SCISSOR_TEST)}function rn(O){O===void 0&&(O=r.TEXTURE0+q-1),j!==O&&(r.activeTexture(O),j=O)}function gn(O,st,nt){nt===void 0&&(j===null?nt=r.TEXTURE0+q-1:nt=j);let Et=tt[nt];Et===void 0&&(Et={type:void 0,texture:void 0},tt[nt]=Et),(Et.type!==O||Et.texture!==st)&&(j!==nt&&(r.activeTexture(nt),j=nt),r.bindTexture(O,st||Mt[O]),Et.type=O,Et.texture=st)}function k(){let O=tt[j];O!==void 0&&O.type!==void 0&&(r.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Pt(){try{r.compressedTexImage2D(...arguments)}catch(O){se("WebGLState:",O)}}function Kt(){try{r.compressedTexImage3D(...arguments)}catch(O){se("WebGLState:",O)}}function le(){try{r.texSubImage2D(...arguments)}catch(O){se("WebGLState:",O)}}function At(){try{r.texSubImage3D(...arguments)}catch(O){se("WebGLState:",O)}}function Be(){try{r.compressedTexSubImage2D(...arguments)}catch(O){se("WebGLState:",O)}}function Gt(){try{r.compressedTexSubImage3D(...arguments)}catch(O){se("WebGLState:",O)}}function jt(){try{r.texStorage2D(...arguments)}catch(O){se("WebGLState:",O)}}function P(){try{r.texStorage3D(...arguments)}catch(O){se("WebGLState:",O)}}function A(){try{r.texImage2D(...arguments)}catch(O){se("WebGLState:",O)}}function X(){try{r.texImage3D(...arguments)}catch(O){se("WebGLState:",O)}}function ft(O){return h[O]!==void 0?h[O]:r.getParameter(O)}function ot(O,st){h[O]!==st&&(r.pixelStorei(O,st),h[O]=st)}function vt(O){J.equals(O)===!1&&(r.scissor(O.x,O.y,O.z,O.w),J.copy(O))}function bt(O){gt.equals(O)===!1&&(r.viewport(O.x,O.y,O.z,O.w),gt.copy(O))}function et(O,st){let nt=c.get(st);nt===void 0&&(nt=new WeakMap,c.set(st,nt));let Et=nt.get(O);Et===void 0&&(Et=r.getUniformBlockIndex(st,O.name),r.uniformBlockBinding(st,Et,Et),nt.set(O,Et))}function it(O,st,nt){let _t=c.get(st).get(O);l[_t]!==nt&&(r.bindBufferBase(r.UNIFORM_BUFFER,_t,nt),l[_t]=nt)}function mt(){r.disable(r.BLEND),r.disable(r.CULL_FACE),r.disable(r.DEPTH_TEST),r.disable(r.POLYGON_OFFSET_FILL),r.disable(r.SCISSOR_TEST),r.disable(r.STENCIL_TEST),r.disable(r.SAMPLE_ALPHA_TO_COVERAGE),r.blendEquation(r.FUNC_ADD),r.blendFunc(r.ONE,r.ZERO),r.blendFuncSeparate(r.ONE,r.ZERO,r.ONE,r.ZERO),r.blendColor(0,0,0,0),r.colorMask(!0,!0,!0,!0),r.clearColor(0,0,0,0),r.depthMask(!0),r.depthFunc(r.LESS),o.setReversed(!1),r.clearDepth(1),r.stencilMask(4294967295),r.stencilFunc(r.ALWAYS,0,4294967295),r.stencilOp(r.KEEP,r.KEEP,r.KEEP),r.clearStencil(0),r.cullFace(r.BACK),r.frontFace(r.CCW),r.polygonOffset(0,0),r.activeTexture(r.TEXTURE0),r.bindFramebuffer(r.FRAMEBUFFER,null),r.bindFramebuffer(r.DRAW_FRAMEBUFFER,null),r.bindFramebuffer(r.READ_FRAMEBUFFER,null),r.useProgram(null),r.lineWidth(1),r.scissor(0,0,r.canvas.width,r.canvas.height),r.viewport(0,0,r.canvas.width,r.canvas.height),r.pixelStorei(r.PACK_ALIGNMENT,4),r.pixelStorei(r.UNPACK_ALIGNMENT,4),r.pixelStorei(r.UNPACK_FLIP_Y_WEBGL,!1),r.pixelStorei(r.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),r.pixelStorei(r.UNPACK_COLORSPACE_CONVERSION_WEBGL,r.BROWSER_DEFAULT_WEBGL),r.pixelStorei(r.PACK_ROW_LENGTH,0),r.pixelStorei(r.PACK_SKIP_PIXELS,0),r.pixelStorei(r.PACK_SKIP_ROWS,0),r.pixelStorei(r.UNPACK_ROW_LENGTH,0),r.pixelStorei(r.UNPACK_IMAGE_HEIGHT,0),r.pixelStorei(r.UNPACK_SKIP_PIXELS,0),r.pixelStorei(r.UNPACK_SKIP_ROWS,0),r.pixelStorei(r.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,tt={},f={},l={},d=new WeakMap,p=[],y=null,g=!1,m=null,x=null,w=null,_=null,E=null,S=null,v=null,b=new ue(0,0,0),N=0,C=!1,I=null,U=null,B=null,F=null,V=null,J.set(0,0,r.canvas.width,r.canvas.height),gt.set(0,0,r.canvas.width,r.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:xt,disable:zt,bindFramebuffer:te,drawBuffers:dt,useProgram:Wt,setBlending:ve,setMaterial:Ue,setFlipSided:mn,setCullFace:Oe,setLineWidth:Nn,setPolygonOffset:be,setScissorTest:An,activeTexture:rn,bindTexture:gn,unbindTexture:k,compressedTexImage2D:Pt,compressedTexImage3D:Kt,texImage2D:A,texImage3D:X,pixelStorei:ot,getParameter:ft,updateUBOMapping:et,uniformBlockBinding:it,texStorage2D:jt,texStorage3D:P,texSubImage2D:le,texSubImage3D:At,compressedTexSubImage2D:Be,compressedTexSubImage3D:Gt,scissor:vt,viewport:bt,reset:mt}}function J2(r,t,e,n,i,s,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Jt,u=new WeakMap,h=new Set,f,d=new WeakMap,p=new Set,y=new FinalizationRegistry(P=>p.delete(P)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,A){return g?new OffscreenCanvas(P,A):dl("canvas")}function x(P,A,X){let ft=1,ot=jt(P);if((ot.width>X||ot.height>X)&&(ft=X/Math.max(ot.width,ot.height)),ft<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let vt=Math.floor(ft*ot.width),bt=Math.floor(ft*ot.height);f===void 0&&(f=m(vt,bt));let et=A?m(vt,bt):f;return et.width=vt,et.height=bt,et.getContext("2d").drawImage(P,0,0,vt,bt),Zt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+vt+"x"+bt+")."),et}else return"data"in P&&Zt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),P;return P}function w(P){return P.generateMipmaps}function _(P){r.generateMipmap(P)}function E(P){return P.isWebGLCubeRenderTarget?r.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?r.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?r.TEXTURE_2D_ARRAY:r.TEXTURE_2D}function S(P,A,X,ft,ot,vt=!1){if(P!==null){if(r[P]!==void 0)return r[P];Zt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let bt;ft&&(bt=t.get("EXT_texture_norm16"),bt||Zt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=A;if(A===r.RED&&(X===r.FLOAT&&(et=r.R32F),X===r.HALF_FLOAT&&(et=r.R16F),X===r.UNSIGNED_BYTE&&(et=r.R8),X===r.UNSIGNED_SHORT&&bt&&(et=bt.R16_EXT),X===r.SHORT&&bt&&(et=bt.R16_SNORM_EXT)),A===r.RED_INTEGER&&(X===r.UNSIGNED_BYTE&&(et=r.R8UI),X===r.UNSIGNED_SHORT&&(et=r.R16UI),X===r.UNSIGNED_INT&&(et=r.R32UI),X===r.BYTE&&(et=r.R8I),X===r.SHORT&&(et=r.R16I),X===r.INT&&(et=r.R32I)),A===r.RG&&(X===r.FLOAT&&(et=r.RG32F),X===r.HALF_FLOAT&&(et=r.RG16F),X===r.UNSIGNED_BYTE&&(et=r.RG8),X===r.UNSIGNED_SHORT&&bt&&(et=bt.RG16_EXT),X===r.SHORT&&bt&&(et=bt.RG16_SNORM_EXT)),A===r.RG_INTEGER&&(X===r.UNSIGNED_BYTE&&(et=r.RG8UI),X===r.UNSIGNED_SHORT&&(et=r.RG16UI),X===r.UNSIGNED_INT&&(et=r.RG32UI),X===r.BYTE&&(et=r.RG8I),X===r.SHORT&&(et=r.RG16I),X===r.INT&&(et=r.RG32I)),A===r.RGB_INTEGER&&(X===r.UNSIGNED_BYTE&&(et=r.RGB8UI),X===r.UNSIGNED_SHORT&&(et=r.RGB16UI),X===r.UNSIGNED_INT&&(et=r.RGB32UI),X===r.BYTE&&(et=r.RGB8I),X===r.SHORT&&(et=r.RGB16I),X===r.INT&&(et=r.RGB32I)),A===r.RGBA_INTEGER&&(X===r.UNSIGNED_BYTE&&(et=r.RGBA8UI),X===r.UNSIGNED_SHORT&&(et=r.RGBA16UI),X===r.UNSIGNED_INT&&(et=r.RGBA32UI),X===r.BYTE&&(et=r.RGBA8I),X===r.SHORT&&(et=r.RGBA16I),X===r.INT&&(et=r.RGBA32I)),A===r.RGB&&(X===r.UNSIGNED_SHORT&&bt&&(et=bt.RGB16_EXT),X===r.SHORT&&bt&&(et=bt.RGB16_SNORM_EXT),X===r.UNSIGNED_INT_5_9_9_9_REV&&(et=r.RGB9_E5),X===r.UNSIGNED_INT_10F_11F_11F_REV&&(et=r.R11F_G11F_B10F)),A===r.RGBA){let it=vt?fl:_e.getTransfer(ot);X===r.FLOAT&&(et=r.RGBA32F),X===r.HALF_FLOAT&&(et=r.RGBA16F),X===r.UNSIGNED_BYTE&&(et=it===Ce?r.SRGB8_ALPHA8:r.RGBA8),X===r.UNSIGNED_SHORT&&bt&&(et=bt.RGBA16_EXT),X===r.SHORT&&bt&&(et=bt.RGBA16_SNORM_EXT),X===r.UNSIGNED_SHORT_4_4_4_4&&(et=r.RGBA4),X===r.UNSIGNED_SHORT_5_5_5_1&&(et=r.RGB5_A1)}return(et===r.R16F||et===r.R32F||et===r.RG16F||et===r.RG32F||et===r.RGBA16F||et===r.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function v(P,A){let X;return P?A===null||A===dr||A===fo?X=r.DEPTH24_STENCIL8:A===pr?X=r.DEPTH32F_STENCIL8:A===Ma&&(X=r.DEPTH24_STENCIL8,Zt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):A===null||A===dr||A===fo?X=r.DEPTH_COMPONENT24:A===pr?X=r.DEPTH_COMPONENT32F:A===Ma&&(X=r.DEPTH_COMPONENT16),X}function b(P,A){return w(P)===!0||P.isFramebufferTexture&&P.minFilter!==Gn&&P.minFilter!==pi?Math.log2(Math.max(A.width,A.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?A.mipmaps.length:1}function N(P){let A=new WeakRef(P);n.get(P).__ref=A,p.add(A),y.register(P,A,A)}function C(P){let A=n.get(P).__ref;A!==void 0&&(p.delete(A),y.unregister(A))}function I(P){B(P.target)}function U(P){F(P.target)}function B(P){P.removeEventListener("dispose",I),C(P),q(P),P.isVideoTexture&&u.delete(P),P.isHTMLTexture&&h.delete(P)}function F(P){P.removeEventListener("dispose",U),C(P),rt(P)}function V(){for(let P of p){let A=P.deref();A!==void 0&&(A.isRenderTarget===!0?F(A):B(A))}p.clear(),h.clear()}function q(P){let A=n.get(P);if(A.__webglInit===void 0)return;let X=P.source,ft=d.get(X);if(ft){let ot=ft[A.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&G(P),Object.keys(ft).length===0&&d.delete(X)}n.remove(P)}function G(P){let A=n.get(P);r.deleteTexture(A.__webglTexture);let X=P.source,ft=d.get(X);delete ft[A.__cacheKey],o.memory.textures--}function rt(P){let A=n.get(P);A.__depthDisposeCallback&&A.__depthDisposeCallback();let X=P.depthTexture;if(X&&X.renderTarget===P&&B(X),P.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(A.__webglFramebuffer[ot]))for(let vt=0;vt<A.__webglFramebuffer[ot].length;vt++)r.deleteFramebuffer(A.__webglFramebuffer[ot][vt]);else r.deleteFramebuffer(A.__webglFramebuffer[ot]);A.__webglDepthbuffer&&r.deleteRenderbuffer(A.__webglDepthbuffer[ot])}else{if(Array.isArray(A.__webglFramebuffer))for(let ot=0;ot<A.__webglFramebuffer.length;ot++)r.deleteFramebuffer(A.__webglFramebuffer[ot]);else r.deleteFramebuffer(A.__webglFramebuffer);if(A.__webglDepthbuffer&&r.deleteRenderbuffer(A.__webglDepthbuffer),A.__webglMultisampledFramebuffer&&r.deleteFramebuffer(A.__webglMultisampledFramebuffer),A.__webglColorRenderbuffer)for(let ot=0;ot<A.__webglColorRenderbuffer.length;ot++)A.__webglColorRenderbuffer[ot]&&r.deleteRenderbuffer(A.__webglColorRenderbuffer[ot]);A.__webglDepthRenderbuffer&&r.deleteRenderbuffer(A.__webglDepthRenderbuffer)}let ft=P.textures;for(let ot=0,vt=ft.length;ot<vt;ot++){let bt=n.get(ft[ot]);bt.__webglTexture&&(r.deleteTexture(bt.__webglTexture),o.memory.textures--),n.remove(ft[ot])}n.remove(P)}let $=0;function j(){$=0}function tt(){return $}function ut(P){$=P}function ct(){let P=$;return P>=i.maxTextures&&Zt("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+i.maxTextures),$+=1,P}function J(P){let A=[];return A.push(P.wrapS),A.push(P.wrapT),A.push(P.wrapR||0),A.push(P.magFilter),A.push(P.minFilter),A.push(P.anisotropy),A.push(P.internalFormat),A.push(P.format),A.push(P.type),A.push(P.generateMipmaps),A.push(P.mipmapsAutoUpdate),A.push(P.premultiplyAlpha),A.push(P.flipY),A.push(P.unpackAlignment),A.push(P.colorSpace),A.join()}function gt(P,A){let X=n.get(P);if(P.isVideoTexture&&Be(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&X.__version!==P.version){let ft=P.image;if(ft===null)Zt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)Zt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ue(X,P,A);return}}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(r.TEXTURE_2D,X.__webglTexture,r.TEXTURE0+A)}function yt(P,A){let X=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Ue(X,P,A);return}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(r.TEXTURE_2D_ARRAY,X.__webglTexture,r.TEXTURE0+A)}function Mt(P,A){let X=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Ue(X,P,A);return}e.bindTexture(r.TEXTURE_3D,X.__webglTexture,r.TEXTURE0+A)}function xt(P,A){let X=n.get(P);if(P.version>0&&X.__version!==P.version){mn(X,P,A);return}e.bindTexture(r.TEXTURE_CUBE_MAP,X.__webglTexture,r.TEXTURE0+A)}let zt={[Lu]:r.REPEAT,[Pr]:r.CLAMP_TO_EDGE,[Fu]:r.MIRRORED_REPEAT},te={[Gn]:r.NEAREST,[Q_]:r.NEAREST_MIPMAP_NEAREST,[Bl]:r.NEAREST_MIPMAP_LINEAR,[pi]:r.LINEAR,[ah]:r.LINEAR_MIPMAP_NEAREST,[rs]:r.LINEAR_MIPMAP_LINEAR},dt={[iv]:r.NEVER,[Qp]:r.ALWAYS,[rv]:r.LESS,[Kp]:r.LEQUAL,[sv]:r.EQUAL,[Jp]:r.GEQUAL,[ov]:r.GREATER,[av]:r.NOTEQUAL};function Wt(P,A){if(A.type===pr&&t.has("OES_texture_float_linear")===!1&&(A.magFilter===pi||A.magFilter===ah||A.magFilter===Bl||A.magFilter===rs||A.minFilter===pi||A.minFilter===ah||A.minFilter===Bl||A.minFilter===rs)&&Zt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),r.texParameteri(P,r.TEXTURE_WRAP_S,zt[A.wrapS]),r.texParameteri(P,r.TEXTURE_WRAP_T,zt[A.wrapT]),(P===r.TEXTURE_3D||P===r.TEXTURE_2D_ARRAY)&&r.texParameteri(P,r.TEXTURE_WRAP_R,zt[A.wrapR]),r.texParameteri(P,r.TEXTURE_MAG_FILTER,te[A.magFilter]),r.texParameteri(P,r.TEXTURE_MIN_FILTER,te[A.minFilter]),A.compareFunction&&(r.texParameteri(P,r.TEXTURE_COMPARE_MODE,r.COMPARE_REF_TO_TEXTURE),r.texParameteri(P,r.TEXTURE_COMPARE_FUNC,dt[A.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(A.magFilter===Gn||A.minFilter!==Bl&&A.minFilter!==rs||A.type===pr&&t.has("OES_texture_float_linear")===!1)return;if(A.anisotropy>1||n.get(A).__currentAnisotropy){let X=t.get("EXT_texture_filter_anisotropic");r.texParameterf(P,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(A.anisotropy,i.getMaxAnisotropy())),n.get(A).__currentAnisotropy=A.anisotropy}}}function qt(P,A){let X=!1;P.__webglInit===void 0&&(P.__webglInit=!0,A.addEventListener("dispose",I),N(A));let ft=A.source,ot=d.get(ft);ot===void 0&&(ot={},d.set(ft,ot));let vt=J(A);if(vt!==P.__cacheKey){ot[vt]===void 0&&(ot[vt]={texture:r.createTexture(),usedTimes:0},o.memory.textures++,X=!0),ot[vt].usedTimes++;let bt=ot[P.__cacheKey];bt!==void 0&&(ot[P.__cacheKey].usedTimes--,bt.usedTimes===0&&G(A)),P.__cacheKey=vt,P.__webglTexture=ot[vt].texture}return X}function Yt(P,A,X){return Math.floor(Math.floor(P/X)/A)}function ve(P,A,X,ft){let vt=P.updateRanges;if(vt.length===0)e.texSubImage2D(r.TEXTURE_2D,0,0,0,A.width,A.height,X,ft,A.data);else{vt.sort((O,st)=>O.start-st.start);let bt=0;for(let O=1;O<vt.length;O++){let st=vt[bt],nt=vt[O],Et=st.start+st.count,_t=Yt(nt.start,A.width,4),St=Yt(st.start,A.width,4);nt.start<=Et+1&&_t===St&&Yt(nt.start+nt.count-1,A.width,4)===_t?st.count=Math.max(st.count,nt.start+nt.count-st.start):(++bt,vt[bt]=nt)}vt.length=bt+1;let et=e.getParameter(r.UNPACK_ROW_LENGTH),it=e.getParameter(r.UNPACK_SKIP_PIXELS),mt=e.getParameter(r.UNPACK_SKIP_ROWS);e.pixelStorei(r.UNPACK_ROW_LENGTH,A.width);for(let O=0,st=vt.length;O<st;O++){let nt=vt[O],Et=Math.floor(nt.start/4),_t=Math.ceil(nt.count/4),St=Et%A.width,Ht=Math.floor(Et/A.width),ee=_t,ht=1;e.pixelStorei(r.UNPACK_SKIP_PIXELS,St),e.pixelStorei(r.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(r.TEXTURE_2D,0,St,Ht,ee,ht,X,ft,A.data)}P.clearUpdateRanges(),e.pixelStorei(r.UNPACK_ROW_LENGTH,et),e.pixelStorei(r.UNPACK_SKIP_PIXELS,it),e.pixelStorei(r.UNPACK_SKIP_ROWS,mt)}}function Ue(P,A,X){let ft=r.TEXTURE_2D;(A.isDataArrayTexture||A.isCompressedArrayTexture)&&(ft=r.TEXTURE_2D_ARRAY),A.isData3DTexture&&(ft=r.TEXTURE_3D);let ot=qt(P,A),vt=A.source;e.bindTexture(ft,P.__webglTexture,r.TEXTURE0+X);let bt=n.get(vt);if(vt.version!==bt.__version||ot===!0){if(e.activeTexture(r.TEXTURE0+X),(typeof ImageBitmap<"u"&&A.image instanceof ImageBitmap)===!1){let ht=_e.getPrimaries(_e.workingColorSpace),kt=A.colorSpace===os?null:_e.getPrimaries(A.colorSpace),ne=A.colorSpace===os||ht===kt?r.NONE:r.BROWSER_DEFAULT_WEBGL;e.pixelStorei(r.UNPACK_FLIP_Y_WEBGL,A.flipY),e.pixelStorei(r.UNPACK_PREMULTIPLY_ALPHA_WEBGL,A.premultiplyAlpha),e.pixelStorei(r.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne)}e.pixelStorei(r.UNPACK_ALIGNMENT,A.unpackAlignment);let it=x(A.image,!1,i.maxTextureSize);it=Gt(A,it);let mt=s.convert(A.format,A.colorSpace),O=s.convert(A.type),st=S(A.internalFormat,mt,O,A.normalized,A.colorSpace,A.isVideoTexture);Wt(ft,A);let nt,Et=A.mipmaps,_t=A.isVideoTexture!==!0,St=bt.__version===void 0||ot===!0,Ht=vt.dataReady,ee=b(A,it);if(A.isDepthTexture)st=v(A.format===ss,A.type),St&&(_t?e.texStorage2D(r.TEXTURE_2D,1,st,it.width,it.height):e.texImage2D(r.TEXTURE_2D,0,st,it.width,it.height,0,mt,O,null));else if(A.isDataTexture)if(Et.length>0){_t&&St&&e.texStorage2D(r.TEXTURE_2D,ee,st,Et[0].width,Et[0].height);for(let ht=0,kt=Et.length;ht<kt;ht++)nt=Et[ht],_t?Ht&&e.texSubImage2D(r.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,O,nt.data):e.texImage2D(r.TEXTURE_2D,ht,st,nt.width,nt.height,0,mt,O,nt.data);A.generateMipmaps=!1}else _t?(St&&e.texStorage2D(r.TEXTURE_2D,ee,st,it.width,it.height),Ht&&ve(A,it,mt,O)):e.texImage2D(r.TEXTURE_2D,0,st,it.width,it.height,0,mt,O,it.data);else if(A.isCompressedTexture)if(A.isCompressedArrayTexture){_t&&St&&e.texStorage3D(r.TEXTURE_2D_ARRAY,ee,st,Et[0].width,Et[0].height,it.depth);for(let ht=0,kt=Et.length;ht<kt;ht++)if(nt=Et[ht],A.format!==gr)if(mt!==null)if(_t){if(Ht)if(A.layerUpdates.size>0){let ne=um(nt.width,nt.height,A.format,A.type);for(let Ct of A.layerUpdates){let he=nt.data.subarray(Ct*ne/nt.data.BYTES_PER_ELEMENT,(Ct+1)*ne/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(r.TEXTURE_2D_ARRAY,ht,0,0,Ct,nt.width,nt.height,1,mt,he)}}else e.compressedTexSubImage3D(r.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,it.depth,mt,nt.data)}else e.compressedTexImage3D(r.TEXTURE_2D_ARRAY,ht,st,nt.width,nt.height,it.depth,0,nt.data,0,0);else Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Ht&&e.texSubImage3D(r.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,it.depth,mt,O,nt.data):e.texImage3D(r.TEXTURE_2D_ARRAY,ht,st,nt.width,nt.height,it.depth,0,mt,O,nt.data);A.layerUpdates.size>0&&A.clearLayerUpdates()}else{_t&&St&&e.texStorage2D(r.TEXTURE_2D,ee,st,Et[0].width,Et[0].height);for(let ht=0,kt=Et.length;ht<kt;ht++)nt=Et[ht],A.format!==gr?mt!==null?_t?Ht&&e.compressedTexSubImage2D(r.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(r.TEXTURE_2D,ht,st,nt.width,nt.height,0,nt.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Ht&&e.texSubImage2D(r.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,O,nt.data):e.texImage2D(r.TEXTURE_2D,ht,st,nt.width,nt.height,0,mt,O,nt.data)}else if(A.isDataArrayTexture)if(_t){if(St&&e.texStorage3D(r.TEXTURE_2D_ARRAY,ee,st,it.width,it.height,it.depth),Ht)if(A.layerUpdates.size>0){let ht=um(it.width,it.height,A.format,A.type);for(let kt of A.layerUpdates){let ne=it.data.subarray(kt*ht/it.data.BYTES_PER_ELEMENT,(kt+1)*ht/it.data.BYTES_PER_ELEMENT);e.texSubImage3D(r.TEXTURE_2D_ARRAY,0,0,0,kt,it.width,it.height,1,mt,O,ne)}A.clearLayerUpdates()}else e.texSubImage3D(r.TEXTURE_2D_ARRAY,0,0,0,0,it.width,it.height,it.depth,mt,O,it.data)}else e.texImage3D(r.TEXTURE_2D_ARRAY,0,st,it.width,it.height,it.depth,0,mt,O,it.data);else if(A.isData3DTexture)_t?(St&&e.texStorage3D(r.TEXTURE_3D,ee,st,it.width,it.height,it.depth),Ht&&e.texSubImage3D(r.TEXTURE_3D,0,0,0,0,it.width,it.height,it.depth,mt,O,it.data)):e.texImage3D(r.TEXTURE_3D,0,st,it.width,it.height,it.depth,0,mt,O,it.data);else if(A.isFramebufferTexture){if(St)if(_t)e.texStorage2D(r.TEXTURE_2D,ee,st,it.width,it.height);else{let ht=it.width,kt=it.height;for(let ne=0;ne<ee;ne++)e.texImage2D(r.TEXTURE_2D,ne,st,ht,kt,0,mt,O,null),ht>>=1,kt>>=1}}else if(A.isHTMLTexture){if("texElementImage2D"in r){let ht=r.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),it.parentNode!==ht){ht.appendChild(it),h.add(A),ht.onpaint=kt=>{let ne=kt.changedElements;for(let Ct of h)ne.includes(Ct.image)&&(Ct.needsUpdate=!0)},ht.requestPaint();return}if(r.texElementImage2D.length===3)r.texElementImage2D(r.TEXTURE_2D,r.RGBA8,it);else{let ne=r.RGBA,Ct=r.RGBA,he=r.UNSIGNED_BYTE;r.texElementImage2D(r.TEXTURE_2D,0,ne,Ct,he,it)}r.texParameteri(r.TEXTURE_2D,r.TEXTURE_MIN_FILTER,r.LINEAR),r.texParameteri(r.TEXTURE_2D,r.TEXTURE_WRAP_S,r.CLAMP_TO_EDGE),r.texParameteri(r.TEXTURE_2D,r.TEXTURE_WRAP_T,r.CLAMP_TO_EDGE)}}else if(Et.length>0){if(_t&&St){let ht=jt(Et[0]);e.texStorage2D(r.TEXTURE_2D,ee,st,ht.width,ht.height)}for(let ht=0,kt=Et.length;ht<kt;ht++)nt=Et[ht],_t?Ht&&e.texSubImage2D(r.TEXTURE_2D,ht,0,0,mt,O,nt):e.texImage2D(r.TEXTURE_2D,ht,st,mt,O,nt);A.generateMipmaps=!1}else if(_t){if(St){let ht=jt(it);e.texStorage2D(r.TEXTURE_2D,ee,st,ht.width,ht.height)}Ht&&e.texSubImage2D(r.TEXTURE_2D,0,0,0,mt,O,it)}else e.texImage2D(r.TEXTURE_2D,0,st,mt,O,it);w(A)&&A.mipmapsAutoUpdate===!0&&_(ft),bt.__version=vt.version,A.onUpdate&&A.onUpdate(A)}P.__version=A.version}function mn(P,A,X){if(A.image.length!==6)return;let ft=qt(P,A),ot=A.source;e.bindTexture(r.TEXTURE_CUBE_MAP,P.__webglTexture,r.TEXTURE0+X);let vt=n.get(ot);if(ot.version!==vt.__version||ft===!0){e.activeTexture(r.TEXTURE0+X);let bt=_e.getPrimaries(_e.workingColorSpace),et=A.colorSpace===os?null:_e.getPrimaries(A.colorSpace),it=A.colorSpace===os||bt===et?r.NONE:r.BROWSER_DEFAULT_WEBGL;e.pixelStorei(r.UNPACK_FLIP_Y_WEBGL,A.flipY),e.pixelStorei(r.UNPACK_PREMULTIPLY_ALPHA_WEBGL,A.premultiplyAlpha),e.pixelStorei(r.UNPACK_ALIGNMENT,A.unpackAlignment),e.pixelStorei(r.UNPACK_COLORSPACE_CONVERSION_WEBGL,it);let mt=A.isCompressedTexture||A.image[0].isCompressedTexture,O=A.image[0]&&A.image[0].isDataTexture,st=[];for(let Ct=0;Ct<6;Ct++)!mt&&!O?st[Ct]=x(A.image[Ct],!0,i.maxCubemapSize):st[Ct]=O?A.image[Ct].image:A.image[Ct],st[Ct]=Gt(A,st[Ct]);let nt=st[0],Et=s.convert(A.format,A.colorSpace),_t=s.convert(A.type),St=S(A.internalFormat,Et,_t,A.normalized,A.colorSpace),Ht=A.isVideoTexture!==!0,ee=vt.__version===void 0||ft===!0,ht=ot.dataReady,kt=b(A,nt);Wt(r.TEXTURE_CUBE_MAP,A);let ne;if(A.isDepthTexture){if(St=v(A.format===ss,A.type),ee)if(Ht)e.texStorage2D(r.TEXTURE_CUBE_MAP,1,St,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,nt.width,nt.height,0,Et,_t,null)}else if(mt){Ht&&ee&&e.texStorage2D(r.TEXTURE_CUBE_MAP,kt,St,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){ne=st[Ct].mipmaps;for(let he=0;he<ne.length;he++){let Xe=ne[he];A.format!==gr?Et!==null?Ht?ht&&e.compressedTexSubImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,he,0,0,Xe.width,Xe.height,Et,Xe.data):e.compressedTexImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,he,St,Xe.width,Xe.height,0,Xe.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?ht&&e.texSubImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,he,0,0,Xe.width,Xe.height,Et,_t,Xe.data):e.texImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,he,St,Xe.width,Xe.height,0,Et,_t,Xe.data)}}}else{if(ne=A.mipmaps,Ht&&ee){ne.length>0&&kt++;let Ct=jt(st[0]);e.texStorage2D(r.TEXTURE_CUBE_MAP,kt,St,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(O){Ht?ht&&e.texSubImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,st[Ct].width,st[Ct].height,Et,_t,st[Ct].data):e.texImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,st[Ct].width,st[Ct].height,0,Et,_t,st[Ct].data);for(let he=0;he<ne.length;he++){let si=ne[he].image[Ct].image;Ht?ht&&e.texSubImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,he+1,0,0,si.width,si.height,Et,_t,si.data):e.texImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,he+1,St,si.width,si.height,0,Et,_t,si.data)}}else{Ht?ht&&e.texSubImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,_t,st[Ct]):e.texImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,Et,_t,st[Ct]);for(let he=0;he<ne.length;he++){let Xe=ne[he];Ht?ht&&e.texSubImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,he+1,0,0,Et,_t,Xe.image[Ct]):e.texImage2D(r.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,he+1,St,Et,_t,Xe.image[Ct])}}}w(A)&&A.mipmapsAutoUpdate===!0&&_(r.TEXTURE_CUBE_MAP),vt.__version=ot.version,A.onUpdate&&A.onUpdate(A)}P.__version=A.version}function Oe(P,A,X,ft,ot,vt){let bt=s.convert(X.format,X.colorSpace),et=s.convert(X.type),it=S(X.internalFormat,bt,et,X.normalized,X.colorSpace),mt=n.get(A),O=n.get(X);if(O.__renderTarget=A,!mt.__hasExternalTextures){let st=Math.max(1,A.width>>vt),nt=Math.max(1,A.height>>vt);ot===r.TEXTURE_3D||ot===r.TEXTURE_2D_ARRAY?e.texImage3D(ot,vt,it,st,nt,A.depth,0,bt,et,null):e.texImage2D(ot,vt,it,st,nt,0,bt,et,null)}e.bindFramebuffer(r.FRAMEBUFFER,P),At(A)?a.framebufferTexture2DMultisampleEXT(r.FRAMEBUFFER,ft,ot,O.__webglTexture,0,le(A)):(ot===r.TEXTURE_2D||ot>=r.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=r.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&r.framebufferTexture2D(r.FRAMEBUFFER,ft,ot,O.__webglTexture,vt),e.bindFramebuffer(r.FRAMEBUFFER,null)}function Nn(P,A,X){if(r.bindRenderbuffer(r.RENDERBUFFER,P),A.depthBuffer){let ft=A.depthTexture,ot=ft&&ft.isDepthTexture?ft.type:null,vt=v(A.stencilBuffer,ot),bt=A.stencilBuffer?r.DEPTH_STENCIL_ATTACHMENT:r.DEPTH_ATTACHMENT;At(A)?a.renderbufferStorageMultisampleEXT(r.RENDERBUFFER,le(A),vt,A.width,A.height):X?r.renderbufferStorageMultisample(r.RENDERBUFFER,le(A),vt,A.width,A.height):r.renderbufferStorage(r.RENDERBUFFER,vt,A.width,A.height),r.framebufferRenderbuffer(r.FRAMEBUFFER,bt,r.RENDERBUFFER,P)}else{let ft=A.textures;for(let ot=0;ot<ft.length;ot++){let vt=ft[ot],bt=s.convert(vt.format,vt.colorSpace),et=s.convert(vt.type),it=S(vt.internalFormat,bt,et,vt.normalized,vt.colorSpace);At(A)?a.renderbufferStorageMultisampleEXT(r.RENDERBUFFER,le(A),it,A.width,A.height):X?r.renderbufferStorageMultisample(r.RENDERBUFFER,le(A),it,A.width,A.height):r.renderbufferStorage(r.RENDERBUFFER,it,A.width,A.height)}}r.bindRenderbuffer(r.RENDERBUFFER,null)}function be(P,A,X){let ft=A.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(r.FRAMEBUFFER,P),!(A.depthTexture&&A.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=n.get(A.depthTexture);ot.__renderTarget=A;let vt=ft?A.depthTexture.image[0]:A.depthTexture.image;(!ot.__webglTexture||vt.width!==A.width||vt.height!==A.height)&&(vt.width=A.width,vt.height=A.height,A.depthTexture.needsUpdate=!0),ft?xt(A.depthTexture,0):gt(A.depthTexture,0);let bt=ot.__webglTexture,et=le(A),it=ft?r.TEXTURE_CUBE_MAP_POSITIVE_X+X:r.TEXTURE_2D,mt=A.depthTexture.format===ss?r.DEPTH_STENCIL_ATTACHMENT:r.DEPTH_ATTACHMENT;if(A.depthTexture.format===ns)At(A)?a.framebufferTexture2DMultisampleEXT(r.FRAMEBUFFER,mt,it,bt,0,et):r.framebufferTexture2D(r.FRAMEBUFFER,mt,it,bt,0);else if(A.depthTexture.format===ss)At(A)?a.framebufferTexture2DMultisampleEXT(r.FRAMEBUFFER,mt,it,bt,0,et):r.framebufferTexture2D(r.FRAMEBUFFER,mt,it,bt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function An(P){let A=n.get(P),X=P.isWebGLCubeRenderTarget===!0;if(A.__boundDepthTexture!==P.depthTexture){let ft=P.depthTexture;if(A.__depthDisposeCallback&&A.__depthDisposeCallback(),ft){let ot=()=>{delete A.__boundDepthTexture,delete A.__depthDisposeCallback,ft.removeEventListener("dispose",ot)};ft.addEventListener("dispose",ot),A.__depthDisposeCallback=ot}A.__boundDepthTexture=ft}if(P.depthTexture&&!A.__autoAllocateDepthBuffer)if(X)for(let ft=0;ft<6;ft++)be(A.__webglFramebuffer[ft],P,ft);else P.texture.mipmaps.length>0?be(A.__webglFramebuffer[0],P,0):be(A.__webglFramebuffer,P,0);else if(X){A.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(r.FRAMEBUFFER,A.__webglFramebuffer[ft]),A.__webglDepthbuffer[ft]===void 0)A.__webglDepthbuffer[ft]=r.createRenderbuffer(),Nn(A.__webglDepthbuffer[ft],P,!1);else{let ot=P.stencilBuffer?r.DEPTH_STENCIL_ATTACHMENT:r.DEPTH_ATTACHMENT,vt=A.__webglDepthbuffer[ft];r.bindRenderbuffer(r.RENDERBUFFER,vt),r.framebufferRenderbuffer(r.FRAMEBUFFER,ot,r.RENDERBUFFER,vt)}}else if(P.texture.mipmaps.length>0?e.bindFramebuffer(r.FRAMEBUFFER,A.__webglFramebuffer[0]):e.bindFramebuffer(r.FRAMEBUFFER,A.__webglFramebuffer),A.__webglDepthbuffer===void 0)A.__webglDepthbuffer=r.createRenderbuffer(),Nn(A.__webglDepthbuffer,P,!1);else{let ot=P.stencilBuffer?r.DEPTH_STENCIL_ATTACHMENT:r.DEPTH_ATTACHMENT,vt=A.__webglDepthbuffer;r.bindRenderbuffer(r.RENDERBUFFER,vt),r.framebufferRenderbuffer(r.FRAMEBUFFER,ot,r.RENDERBUFFER,vt)}e.bindFramebuffer(r.FRAMEBUFFER,null)}function rn(P,A,X){let ft=n.get(P);A!==void 0&&Oe(ft.__webglFramebuffer,P,P.texture,r.COLOR_ATTACHMENT0,r.TEXTURE_2D,0),X!==void 0&&An(P)}function gn(P){let A=P.texture,X=n.get(P),ft=n.get(A);P.addEventListener("dispose",U),N(P);let ot=P.textures,vt=P.isWebGLCubeRenderTarget===!0,bt=ot.length>1;if(bt||(ft.__webglTexture===void 0&&(ft.__webglTexture=r.createTexture()),ft.__version=A.version,o.memory.textures++),vt){X.__webglFramebuffer=[];for(let et=0;et<6;et++)if(A.mipmaps.length>0){X.__webglFramebuffer[et]=[];for(let it=0;it<A.mipmaps.length;it++)X.__webglFramebuffer[et][it]=r.createFramebuffer()}else X.__webglFramebuffer[et]=r.createFramebuffer()}else{if(A.mipmaps.length>0){X.__webglFramebuffer=[];for(let et=0;et<A.mipmaps.length;et++)X.__webglFramebuffer[et]=r.createFramebuffer()}else X.__webglFramebuffer=r.createFramebuffer();if(bt)for(let et=0,it=ot.length;et<it;et++){let mt=n.get(ot[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=r.createTexture(),o.memory.textures++)}if(P.samples>0&&At(P)===!1){X.__webglMultisampledFramebuffer=r.createFramebuffer(),X.__webglColorRenderbuffer=[],e.bindFramebuffer(r.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let it=ot[et];X.__webglColorRenderbuffer[et]=r.createRenderbuffer(),r.bindRenderbuffer(r.RENDERBUFFER,X.__webglColorRenderbuffer[et]);let mt=s.convert(it.format,it.colorSpace),O=s.convert(it.type),st=S(it.internalFormat,mt,O,it.normalized,it.colorSpace,P.isXRRenderTarget===!0),nt=le(P);r.renderbufferStorageMultisample(r.RENDERBUFFER,nt,st,P.width,P.height),r.framebufferRenderbuffer(r.FRAMEBUFFER,r.COLOR_ATTACHMENT0+et,r.RENDERBUFFER,X.__webglColorRenderbuffer[et])}r.bindRenderbuffer(r.RENDERBUFFER,null),P.depthBuffer&&(X.__webglDepthRenderbuffer=r.createRenderbuffer(),Nn(X.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(r.FRAMEBUFFER,null)}}if(vt){e.bindTexture(r.TEXTURE_CUBE_MAP,ft.__webglTexture),Wt(r.TEXTURE_CUBE_MAP,A);for(let et=0;et<6;et++)if(A.mipmaps.length>0)for(let it=0;it<A.mipmaps.length;it++)Oe(X.__webglFramebuffer[et][it],P,A,r.COLOR_ATTACHMENT0,r.TEXTURE_CUBE_MAP_POSITIVE_X+et,it);else Oe(X.__webglFramebuffer[et],P,A,r.COLOR_ATTACHMENT0,r.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);w(A)?_(r.TEXTURE_CUBE_MAP):A.mipmaps.length>0&&r.texParameteri(r.TEXTURE_CUBE_MAP,r.TEXTURE_MAX_LEVEL,A.mipmaps.length-1),e.unbindTexture()}else if(bt){for(let et=0,it=ot.length;et<it;et++){let mt=ot[et],O=n.get(mt),st=r.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(st=P.isWebGL3DRenderTarget?r.TEXTURE_3D:r.TEXTURE_2D_ARRAY),e.bindTexture(st,O.__webglTexture),Wt(st,mt),Oe(X.__webglFramebuffer,P,mt,r.COLOR_ATTACHMENT0+et,st,0),w(mt)&&_(st)}e.unbindTexture()}else{let et=r.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(et=P.isWebGL3DRenderTarget?r.TEXTURE_3D:r.TEXTURE_2D_ARRAY),e.bindTexture(et,ft.__webglTexture),Wt(et,A),A.mipmaps.length>0)for(let it=0;it<A.mipmaps.length;it++)Oe(X.__webglFramebuffer[it],P,A,r.COLOR_ATTACHMENT0,et,it);else Oe(X.__webglFramebuffer,P,A,r.COLOR_ATTACHMENT0,et,0);w(A)?_(et):A.mipmaps.length>0&&r.texParameteri(et,r.TEXTURE_MAX_LEVEL,A.mipmaps.length-1),e.unbindTexture()}P.depthBuffer&&An(P)}function k(P){let A=P.textures;for(let X=0,ft=A.length;X<ft;X++){let ot=A[X];if(w(ot)&&ot.mipmapsAutoUpdate===!0){let vt=E(P),bt=n.get(ot).__webglTexture;e.bindTexture(vt,bt),_(vt),e.unbindTexture()}}}let Pt=[];function Kt(P){if(P.samples>0){if(At(P)===!1){let A=P.textures,X=P.width,ft=P.height,ot=r.COLOR_BUFFER_BIT,vt=P.stencilBuffer?r.DEPTH_STENCIL_ATTACHMENT:r.DEPTH_ATTACHMENT,bt=n.get(P),et=A.length>1;if(et)for(let mt=0;mt<A.length;mt++)e.bindFramebuffer(r.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),r.framebufferRenderbuffer(r.FRAMEBUFFER,r.COLOR_ATTACHMENT0+mt,r.RENDERBUFFER,null),e.bindFramebuffer(r.FRAMEBUFFER,bt.__webglFramebuffer),r.framebufferTexture2D(r.DRAW_FRAMEBUFFER,r.COLOR_ATTACHMENT0+mt,r.TEXTURE_2D,null,0);e.bindFramebuffer(r.READ_FRAMEBUFFER,bt.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?e.bindFramebuffer(r.DRAW_FRAMEBUFFER,bt.__webglFramebuffer[0]):e.bindFramebuffer(r.DRAW_FRAMEBUFFER,bt.__webglFramebuffer);for(let mt=0;mt<A.length;mt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ot|=r.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ot|=r.STENCIL_BUFFER_BIT)),et){r.framebufferRenderbuffer(r.READ_FRAMEBUFFER,r.COLOR_ATTACHMENT0,r.RENDERBUFFER,bt.__webglColorRenderbuffer[mt]);let O=n.get(A[mt]).__webglTexture;r.framebufferTexture2D(r.DRAW_FRAMEBUFFER,r.COLOR_ATTACHMENT0,r.TEXTURE_2D,O,0)}r.blitFramebuffer(0,0,X,ft,0,0,X,ft,ot,r.NEAREST),l===!0&&(Pt.length=0,Pt.push(r.COLOR_ATTACHMENT0+mt),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Pt.push(vt),r.invalidateFramebuffer(r.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(r.READ_FRAMEBUFFER,null),e.bindFramebuffer(r.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<A.length;mt++){e.bindFramebuffer(r.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),r.framebufferRenderbuffer(r.FRAMEBUFFER,r.COLOR_ATTACHMENT0+mt,r.RENDERBUFFER,bt.__webglColorRenderbuffer[mt]);let O=n.get(A[mt]).__webglTexture;e.bindFramebuffer(r.FRAMEBUFFER,bt.__webglFramebuffer),r.framebufferTexture2D(r.DRAW_FRAMEBUFFER,r.COLOR_ATTACHMENT0+mt,r.TEXTURE_2D,O,0)}e.bindFramebuffer(r.DRAW_FRAMEBUFFER,bt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let A=P.stencilBuffer?r.DEPTH_STENCIL_ATTACHMENT:r.DEPTH_ATTACHMENT;r.invalidateFramebuffer(r.DRAW_FRAMEBUFFER,[A])}}}function le(P){return Math.min(i.maxSamples,P.samples)}function At(P){let A=n.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&A.__useRenderToTexture!==!1}function Be(P){let A=o.render.frame;u.get(P)!==A&&(u.set(P,A),P.update())}function Gt(P,A){let X=P.colorSpace,ft=P.format,ot=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||X!==hl&&X!==os&&(_e.getTransfer(X)===Ce?(ft!==gr||ot!==_i)&&Zt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):se("WebGLTextures: Unsupported texture color space:",X)),A}function jt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=ct,this.resetTextureUnits=j,this.getTextureUnits=tt,this.setTextureUnits=ut,this.setTexture2D=gt,this.setTexture2DArray=yt,this.setTexture3D=Mt,this.setTextureCube=xt,this.rebindTextures=rn,this.setupRenderTarget=gn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Kt,this.setupDepthRenderbuffer=An,this.setupFrameBufferTexture=Oe,this.useMultisampledRTT=At,this.dispose=V}function Q2(r,t){function e(n,i=os){let s,o=_e.getTransfer(i);if(n===_i)return r.UNSIGNED_BYTE;if(n===ch)return r.UNSIGNED_SHORT_4_4_4_4;if(n===uh)return r.UNSIGNED_SHORT_5_5_5_1;if(n===Xp)return r.UNSIGNED_INT_5_9_9_9_REV;if(n===$p)return r.UNSIGNED_INT_10F_11F_11F_REV;if(n===Wp)return r.BYTE;if(n===qp)return r.SHORT;if(n===Ma)return r.UNSIGNED_SHORT;if(n===lh)return r.INT;if(n===dr)return r.UNSIGNED_INT;if(n===pr)return r.FLOAT;if(n===mr)return r.HALF_FLOAT;if(n===Yp)return r.ALPHA;if(n===jp)return r.RGB;if(n===gr)return r.RGBA;if(n===ns)return r.DEPTH_COMPONENT;if(n===ss)return r.DEPTH_STENCIL;if(n===Zp)return r.RED;if(n===hh)return r.RED_INTEGER;if(n===Us)return r.RG;if(n===fh)return r.RG_INTEGER;if(n===dh)return r.RGBA_INTEGER;if(n===zl||n===Vl||n===Gl||n===Hl)if(o===Ce)if(s=t.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===zl)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Vl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Gl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Hl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=t.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===zl)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Vl)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Gl)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Hl)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===ph||n===mh||n===gh||n===yh)if(s=t.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===ph)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===mh)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===gh)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===yh)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===xh||n===_h||n===vh||n===bh||n===wh||n===Wl||n===Mh)if(s=t.get("WEBGL_compressed_texture_etc"),s!==null){if(n===xh||n===_h)return o===Ce?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===vh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===bh)return s.COMPRESSED_R11_EAC;if(n===wh)return s.COMPRESSED_SIGNED_R11_EAC;if(n===Wl)return s.COMPRESSED_RG11_EAC;if(n===Mh)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Sh||n===Ah||n===Eh||n===Th||n===Rh||n===Ch||n===Ph||n===Ih||n===Lh||n===Fh||n===Nh||n===Dh||n===Uh||n===Oh)if(s=t.get("WEBGL_compressed_texture_astc"),s!==null){if(n===Sh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Ah)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Eh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Th)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Rh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ch)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ph)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ih)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Lh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Fh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Nh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Dh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Uh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Oh)return o===Ce?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===kh||n===Bh||n===zh)if(s=t.get("EXT_texture_compression_bptc"),s!==null){if(n===kh)return o===Ce?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Bh)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===zh)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Vh||n===Gh||n===ql||n===Hh)if(s=t.get("EXT_texture_compression_rgtc"),s!==null){if(n===Vh)return s.COMPRESSED_RED_RGTC1_EXT;if(n===Gh)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ql)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Hh)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===fo?r.UNSIGNED_INT_24_8:r[n]!==void 0?r[n]:null}return{convert:e}}var t3=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,e3=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,_m=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Ml(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Ji({vertexShader:t3,fragmentShader:e3,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new We(new so(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},vm=class extends ur{constructor(t,e){super();let n=this,i=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,p=null,y=typeof XRWebGLBinding<"u",g=new _m,m={},x=e.getContextAttributes(),w=null,_=null,E=[],S=[],v=new Jt,b=null,N=null,C=new $n;C.viewport=new Pe;let I=new $n;I.viewport=new Pe;let U=[C,I],B=new ih,F=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let gt=E[J];return gt===void 0&&(gt=new ma,E[J]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(J){let gt=E[J];return gt===void 0&&(gt=new ma,E[J]=gt),gt.getGripSpace()},this.getHand=function(J){let gt=E[J];return gt===void 0&&(gt=new ma,E[J]=gt),gt.getHandSpace()};function q(J){let gt=S.indexOf(J.inputSource);if(gt===-1)return;let yt=E[gt];yt!==void 0&&(yt.update(J.inputSource,J.frame,c||o),yt.dispatchEvent({type:J.type,data:J.inputSource}))}function G(){i.removeEventListener("select",q),i.removeEventListener("selectstart",q),i.removeEventListener("selectend",q),i.removeEventListener("squeeze",q),i.removeEventListener("squeezestart",q),i.removeEventListener("squeezeend",q),i.removeEventListener("end",G),i.removeEventListener("inputsourceschange",rt);for(let J=0;J<E.length;J++){let gt=S[J];gt!==null&&(S[J]=null,E[J].disconnect(gt))}F=null,V=null,g.reset();for(let J in m)delete m[J];if(t.setRenderTarget(w),d=null,f=null,h=null,i=null,_=null,ct.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(v.width,v.height,!1),N!==null){let J=N.camera;J.fov=N.fov,J.zoom=N.zoom,J.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){s=J,n.isPresenting===!0&&Zt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){a=J,n.isPresenting===!0&&Zt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(J){c=J},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(i,e)),h},this.getFrame=function(){return p},this.getSession=function(){return i},this.setSession=async function(J){if(i=J,i!==null){if(w=t.getRenderTarget(),i.addEventListener("select",q),i.addEventListener("selectstart",q),i.addEventListener("selectend",q),i.addEventListener("squeeze",q),i.addEventListener("squeezestart",q),i.addEventListener("squeezeend",q),i.addEventListener("end",G),i.addEventListener("inputsourceschange",rt),x.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,Mt=null,xt=null;x.depth&&(xt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=x.stencil?ss:ns,Mt=x.stencil?fo:dr);let zt={colorFormat:e.RGBA8,depthFormat:xt,scaleFactor:s};h=this.getBinding(),f=h.createProjectionLayer(zt),i.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),_=new ki(f.textureWidth,f.textureHeight,{format:gr,type:_i,depthTexture:new is(f.textureWidth,f.textureHeight,Mt,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let yt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(i,e,yt),i.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),_=new ki(d.framebufferWidth,d.framebufferHeight,{format:gr,type:_i,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await i.requestReferenceSpace(a),ct.setContext(i),ct.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(i!==null)return i.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function rt(J){for(let gt=0;gt<J.removed.length;gt++){let yt=J.removed[gt],Mt=S.indexOf(yt);Mt>=0&&(S[Mt]=null,E[Mt].disconnect(yt))}for(let gt=0;gt<J.added.length;gt++){let yt=J.added[gt],Mt=S.indexOf(yt);if(Mt===-1){for(let zt=0;zt<E.length;zt++)if(zt>=S.length){S.push(yt),Mt=zt;break}else if(S[zt]===null){S[zt]=yt,Mt=zt;break}if(Mt===-1)break}let xt=E[Mt];xt&&xt.connect(yt)}}function $(J,gt){gt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(gt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(i===null)return;let gt=J.near,yt=J.far;g.texture!==null&&(g.depthNear>0&&(gt=g.depthNear),g.depthFar>0&&(yt=g.depthFar)),B.near=I.near=C.near=gt,B.far=I.far=C.far=yt,(F!==B.near||V!==B.far)&&(i.updateRenderState({depthNear:B.near,depthFar:B.far}),F=B.near,V=B.far),B.layers.mask=J.layers.mask|6,C.layers.mask=B.layers.mask&-5,I.layers.mask=B.layers.mask&-3;let Mt=J.parent,xt=B.cameras;$(B,Mt);for(let zt=0;zt<xt.length;zt++)$(xt[zt],Mt);B.projectionMatrix.copy(C.projectionMatrix),B.projectionMatrixInverse.copy(C.projectionMatrixInverse),N===null&&J.isPerspectiveCamera&&(N={camera:J,fov:J.fov,zoom:J.zoom}),j(J,B,Mt)};function j(J,gt,yt){yt===null?J.matrix.copy(gt.matrixWorld):(J.matrix.copy(yt.matrixWorld),J.matrix.invert(),J.matrix.multiply(gt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(gt.projectionMatrix),J.projectionMatrixInverse.copy(gt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=da*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(J){l=J,f!==null&&(f.fixedFoveation=J),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=J)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function(J){return m[J]};let tt=null;function ut(J,gt){if(u=gt.getViewerPose(c||o),p=gt,u!==null){let yt=u.views;d!==null&&(t.setRenderTargetFramebuffer(_,d.framebuffer),t.setRenderTarget(_));let Mt=!1;yt.length!==B.cameras.length&&(B.cameras.length=0,Mt=!0);for(let dt=0;dt<yt.length;dt++){let Wt=yt[dt],qt=null;if(d!==null)qt=d.getViewport(Wt);else{let ve=h.getViewSubImage(f,Wt);qt=ve.viewport,dt===0&&(t.setRenderTargetTextures(_,ve.colorTexture,ve.depthStencilTexture),t.setRenderTarget(_))}let Yt=U[dt];Yt===void 0&&(Yt=new $n,Yt.layers.enable(dt),Yt.viewport=new Pe,U[dt]=Yt),Yt.matrix.fromArray(Wt.transform.matrix),Yt.matrix.decompose(Yt.position,Yt.quaternion,Yt.scale),Yt.projectionMatrix.fromArray(Wt.projectionMatrix),Yt.projectionMatrixInverse.copy(Yt.projectionMatrix).invert(),Yt.viewport.set(qt.x,qt.y,qt.width,qt.height),dt===0&&(B.matrix.copy(Yt.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Mt===!0&&B.cameras.push(Yt)}let xt=i.enabledFeatures;if(xt&&xt.includes("depth-sensing")&&i.depthUsage=="gpu-optimized"&&y){h=n.getBinding();let dt=h.getDepthInformation(yt[0]);dt&&dt.isValid&&dt.texture&&g.init(dt,i.renderState)}if(xt&&xt.includes("camera-access")&&y){t.state.unbindTexture(),h=n.getBinding();for(let dt=0;dt<yt.length;dt++){let Wt=yt[dt].camera;if(Wt){let qt=m[Wt];qt||(qt=new Ml,m[Wt]=qt);let Yt=h.getCameraImage(Wt);qt.sourceTexture=Yt}}}}for(let yt=0;yt<E.length;yt++){let Mt=S[yt],xt=E[yt];Mt!==null&&xt!==void 0&&xt.update(Mt,gt,c||o)}tt&&tt(J,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),p=null}let ct=new Uv;ct.setAnimationLoop(ut),this.setAnimationLoop=function(J){tt=J},this.dispose=function(){}}},n3=new Ge,Xv=new oe;Xv.set(-1,0,0,0,1,0,0,0,1);function i3(r,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,am(r)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function i(g,m,x,w,_){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?s(g,m):m.isMeshLambertMaterial?(s(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(s(g,m),h(g,m)):m.isMeshPhongMaterial?(s(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(s(g,m),f(g,m),m.isMeshPhysicalMaterial&&d(g,m,_)):m.isMeshMatcapMaterial?(s(g,m),p(g,m)):m.isMeshDepthMaterial?s(g,m):m.isMeshDistanceMaterial?(s(g,m),y(g,m)):m.isMeshNormalMaterial?s(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,x,w):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function s(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===mi&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===mi&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let x=t.get(m),w=x.envMap,_=x.envMapRotation;w&&(g.envMap.value=w,g.envMapRotation.value.setFromMatrix4(n3.makeRotationFromEuler(_)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Xv),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,x,w){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*x,g.scale.value=w*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function f(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,x){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===mi&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function y(g,m){let x=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:i}}function r3(r,t,e,n){let i={},s={};function o(x,w){let _=w.program;n.uniformBlockBinding(x,_,i[x.id])}function a(x,w){let _=i[x.id];_===void 0&&(p(x),_=l(x),i[x.id]=_,x.addEventListener("dispose",g));let E=w.program;n.updateUBOMapping(x,E);let S=t.render.frame;s[x.id]!==S&&(c(x),s[x.id]=S)}function l(x){let w=r.createBuffer(),_=x.__size,E=x.usage;return r.bindBuffer(r.UNIFORM_BUFFER,w),r.bufferData(r.UNIFORM_BUFFER,_,E),r.bindBuffer(r.UNIFORM_BUFFER,null),w}function c(x){let w=i[x.id],_=x.uniforms,E=x.__cache;r.bindBuffer(r.UNIFORM_BUFFER,w);for(let S=0,v=_.length;S<v;S++){let b=_[S];if(Array.isArray(b))for(let N=0,C=b.length;N<C;N++)u(b[N],S,N,E);else u(b,S,0,E)}r.bindBuffer(r.UNIFORM_BUFFER,null)}function u(x,w,_,E){if(f(x,w,_,E)===!0){let S=x.__offset,v=x.value;if(Array.isArray(v)){let b=0;for(let N=0;N<v.length;N++){let C=v[N],I=y(C,!0);h(C,x.__data,b),b+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(v,x.__data,0);r.bufferSubData(r.UNIFORM_BUFFER,S,x.__data)}}function h(x,w,_){typeof x=="number"||typeof x=="boolean"?w[_]=x:x.isMatrix3?(w[_]=x.elements[0],w[_+1]=x.elements[1],w[_+2]=x.elements[2],w[_+3]=0,w[_+4]=x.elements[3],w[_+5]=x.elements[4],w[_+6]=x.elements[5],w[_+7]=0,w[_+8]=x.elements[6],w[_+9]=x.elements[7],w[_+10]=x.elements[8],w[_+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-_),_):x.toArray(w,_)}function f(x,w,_,E){let S=x.value,v=w+"_"+_;if(Array.isArray(S)){E[v]===void 0&&(E[v]=[]);let b=E[v],N=!1;for(let C=0;C<S.length;C++)d(S[C],b,C)===!0&&(N=!0);return N}return d(S,E,v)}function d(x,w,_){if(w[_]===void 0)return typeof x=="number"||typeof x=="boolean"?w[_]=x:ArrayBuffer.isView(x)?w[_]=x.slice():w[_]=x.clone(),!0;{let E=w[_];if(typeof x=="number"||typeof x=="boolean"){if(E!==x)return w[_]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(E.equals(x)===!1)return E.copy(x),!0}}return!1}function p(x){let w=x.uniforms,_=0,E=16;for(let v=0,b=w.length;v<b;v++){let N=Array.isArray(w[v])?w[v]:[w[v]];for(let C=0,I=N.length;C<I;C++){let U=N[C],B=Array.isArray(U.value)?U.value:[U.value],F=Array.isArray(w[v])||Array.isArray(U.value),V=_;for(let G=0,rt=B.length;G<rt;G++){let $=B[G],j=y($,F),tt=_%E,ut=tt%j.boundary,ct=tt+ut;_+=ut,ct!==0&&E-ct<j.storage&&(_+=E-ct),G===0&&(V=_),_+=j.storage}let q=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new q((_-V)/Float32Array.BYTES_PER_ELEMENT),U.__offset=V}}let S=_%E;return S>0&&(_+=E-S),x.__size=_,x.__cache={},this}function y(x,w){let _={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(_.boundary=4,_.storage=4):x.isVector2?(_.boundary=8,_.storage=8):x.isVector3||x.isColor?(_.boundary=16,_.storage=12):x.isVector4?(_.boundary=16,_.storage=16):x.isMatrix3?(_.boundary=16,_.storage=48):x.isMatrix4?(_.boundary=16,_.storage=64):x.isTexture?Zt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(_.boundary=16,_.storage=x.byteLength):Zt("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(_.boundary=16,_.storage=Math.ceil(_.storage/16)*16),_}function g(x){let w=x.target;w.removeEventListener("dispose",g),r.deleteBuffer(i[w.id]),delete i[w.id],delete s[w.id]}function m(){for(let x in i)r.deleteBuffer(i[x]);i={},s={}}return{bind:o,update:a,dispose:m}}var s3=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Nr=null;function o3(){return Nr===null&&(Nr=new ku(s3,16,16,Us,mr),Nr.name="DFG_LUT",Nr.minFilter=pi,Nr.magFilter=pi,Nr.wrapS=Pr,Nr.wrapT=Pr,Nr.generateMipmaps=!1,Nr.needsUpdate=!0),Nr}var Yh=class{constructor(t={}){let{canvas:e=lv(),context:n=null,depth:i=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=_i}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let y=d,g=new Set([dh,fh,hh]),m=new Set([_i,dr,Ma,fo,ch,uh]),x=new Uint32Array(4),w=new Int32Array(4),_={textures:[],min:[],max:[],resolution:[]},E=null,S=null,v=[],b=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Fr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,I=!1,U=null,B=null,F=null,V=null;this._outputColorSpace=Ui;let q=0,G=0,rt=null,$=-1,j=null,tt=new Pe,ut=new Pe,ct=null,J=new ue(0),gt=0,yt=e.width,Mt=e.height,xt=1,zt=null,te=null,dt=new Pe(0,0,yt,Mt),Wt=new Pe(0,0,yt,Mt),qt=!1,Yt=new Es,ve=new Bu,Ue=!1,mn=!1,Oe=new Ge,Nn=new z,be=new Pe,An={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},rn=!1;function gn(){return rt===null?xt:1}let k=n;function Pt(R,H){return e.getContext(R,H)}let Kt,le,At,Be,Gt,jt,P,A,X,ft,ot,vt,bt,et,it,mt,O,st,nt,Et,_t,St,Ht;try{let R={alpha:!0,depth:i,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ne,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),k===null){let H="webgl2";if(k=Pt(H,R),k===null)throw Pt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ee()}catch(R){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),se("WebGLRenderer: "+R.message),R}function ee(){Kt=new yC(k),Kt.init(),_t=new Q2(k,Kt),le=new oC(k,Kt,t,_t),At=new K2(k,Kt),le.reversedDepthBuffer&&f&&At.buffers.depth.setReversed(!0),B=k.createFramebuffer(),F=k.createFramebuffer(),V=k.createFramebuffer(),Be=new vC(k),Gt=new O2,jt=new J2(k,Kt,At,Gt,le,_t,Be),P=new gC(C),A=new wE(k),St=new rC(k,A),X=new xC(k,A,Be,St),ft=new wC(k,X,A,St,Be),st=new bC(k,le,jt),it=new aC(Gt),ot=new U2(C,P,Kt,le,St,it),vt=new i3(C,Gt),bt=new B2,et=new q2(Kt),O=new iC(C,P,At,ft,p,l),mt=new Z2(C,ft,le),Ht=new r3(k,Be,le,At),nt=new sC(k,Kt,Be),Et=new _C(k,Kt,Be),Be.programs=ot.programs,C.capabilities=le,C.extensions=Kt,C.properties=Gt,C.renderLists=bt,C.shadowMap=mt,C.state=At,C.info=Be}y!==_i&&(N=new SC(y,e.width,e.height,a,i,s));let ht=new vm(C,k);this.xr=ht,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=Kt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Kt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return xt},this.setPixelRatio=function(R){R!==void 0&&(xt=R,this.setSize(yt,Mt,!1))},this.getSize=function(R){return R.set(yt,Mt)},this.setSize=function(R,H,Q=!0){if(ht.isPresenting){Zt("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=R,Mt=H,e.width=Math.floor(R*xt),e.height=Math.floor(H*xt),Q===!0&&(e.style.width=R+"px",e.style.height=H+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(yt*xt,Mt*xt).floor()},this.setDrawingBufferSize=function(R,H,Q){yt=R,Mt=H,xt=Q,e.width=Math.floor(R*Q),e.height=Math.floor(H*Q),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(y===_i){se("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Zt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(tt)},this.getViewport=function(R){return R.copy(dt)},this.setViewport=function(R,H,Q,Y){R.isVector4?dt.set(R.x,R.y,R.z,R.w):dt.set(R,H,Q,Y),At.viewport(tt.copy(dt).multiplyScalar(gn()).round())},this.getScissor=function(R){return R.copy(Wt)},this.setScissor=function(R,H,Q,Y){R.isVector4?Wt.set(R.x,R.y,R.z,R.w):Wt.set(R,H,Q,Y),At.scissor(ut.copy(Wt).multiplyScalar(gn()).round())},this.getScissorTest=function(){return qt},this.setScissorTest=function(R){At.setScissorTest(qt=R)},this.setOpaqueSort=function(R){zt=R},this.setTransparentSort=function(R){te=R},this.getClearColor=function(R){return R.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,Q=!0){let Y=0;if(R){let Z=!1;if(rt!==null){let Tt=rt.texture.format;Z=g.has(Tt)}if(Z){let Tt=rt.texture.type,Lt=m.has(Tt),Rt=O.getClearColor(),Ft=O.getClearAlpha(),Vt=Rt.r,re=Rt.g,pe=Rt.b;Lt?(x[0]=Vt,x[1]=re,x[2]=pe,x[3]=Ft,k.clearBufferuiv(k.COLOR,0,x)):(w[0]=Vt,w[1]=re,w[2]=pe,w[3]=Ft,k.clearBufferiv(k.COLOR,0,w))}else Y|=k.COLOR_BUFFER_BIT}H&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),U=R},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),O.dispose(),bt.dispose(),et.dispose(),jt.dispose(),Gt.dispose(),P.dispose(),ft.dispose(),X.dispose(),St.dispose(),Ht.dispose(),ot.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",rc),ht.removeEventListener("sessionend",xr),zr.stop()};function kt(R){R.preventDefault(),pl("WebGLRenderer: Context Lost."),I=!0}function ne(){pl("WebGLRenderer: Context Restored."),I=!1;let R=Be.autoReset,H=mt.enabled,Q=mt.autoUpdate,Y=mt.needsUpdate,Z=mt.type;ee(),Be.autoReset=R,mt.enabled=H,mt.autoUpdate=Q,mt.needsUpdate=Y,mt.type=Z}function Ct(R){se("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function he(R){let H=R.target;H.removeEventListener("dispose",he),Xe(H)}function Xe(R){si(R),Gt.remove(R)}function si(R){let H=Gt.get(R).programs;H!==void 0&&(H.forEach(function(Q){ot.releaseProgram(Q)}),R.isShaderMaterial&&ot.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,Q,Y,Z,Tt){H===null&&(H=An);let Lt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Rt=Fa(R,H,Q,Y,Z);At.setMaterial(Y,Lt);let Ft=Q.index,Vt=1;if(Y.wireframe===!0){if(Ft=X.getWireframeAttribute(Q),Ft===void 0)return;Vt=2}let re=Q.drawRange,pe=Q.attributes.position,Bt=re.start*Vt,me=(re.start+re.count)*Vt;Tt!==null&&(Bt=Math.max(Bt,Tt.start*Vt),me=Math.min(me,(Tt.start+Tt.count)*Vt)),Ft!==null?(Bt=Math.max(Bt,0),me=Math.min(me,Ft.count)):pe!=null&&(Bt=Math.max(Bt,0),me=Math.min(me,pe.count));let en=me-Bt;if(en<0||en===1/0)return;St.setup(Z,Y,Rt,Q,Ft);let Ie,Le=nt;if(Ft!==null&&(Ie=A.get(Ft),Le=Et,Le.setIndex(Ie)),Z.isMesh)Y.wireframe===!0?(At.setLineWidth(Y.wireframeLinewidth*gn()),Le.setMode(k.LINES)):Le.setMode(k.TRIANGLES);else if(Z.isLine){let En=Y.linewidth;En===void 0&&(En=1),At.setLineWidth(En*gn()),Z.isLineSegments?Le.setMode(k.LINES):Z.isLineLoop?Le.setMode(k.LINE_LOOP):Le.setMode(k.LINE_STRIP)}else Z.isPoints?Le.setMode(k.POINTS):Z.isSprite&&Le.setMode(k.TRIANGLES);if(Z.isBatchedMesh)if(Kt.get("WEBGL_multi_draw"))Le.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let En=Z._multiDrawStarts,Ut=Z._multiDrawCounts,yn=Z._multiDrawCount,ye=Ft?A.get(Ft).bytesPerElement:1,Gr=Gt.get(Y).currentProgram.getUniforms();for(let xn=0;xn<yn;xn++)Gr.setValue(k,"_gl_DrawID",xn),Le.render(En[xn]/ye,Ut[xn])}else if(Z.isInstancedMesh)Le.renderInstances(Bt,en,Z.count);else if(Q.isInstancedBufferGeometry){let En=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ut=Math.min(Q.instanceCount,En);Le.renderInstances(Bt,en,Ut)}else Le.render(Bt,en)};function Pa(R,H,Q,Y){U!==null&&R.isNodeMaterial&&U.setObject(Y,R),Ue===!0&&it.setState(R,Q,!1),R.transparent===!0&&R.side===Qi&&R.forceSinglePass===!1?(R.side=mi,R.needsUpdate=!0,_r(R,H,Y),R.side=Ds,R.needsUpdate=!0,_r(R,H,Y),R.side=Qi):_r(R,H,Y)}this.compile=function(R,H,Q=null){Q===null&&(Q=R),U!==null&&U.renderStart(R,H,Q),S=et.get(Q),S.init(H),b.push(S),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(S.pushLight(Z),Z.castShadow&&S.pushShadow(Z))}),R!==Q&&R.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(S.pushLight(Z),Z.castShadow&&S.pushShadow(Z))}),S.setupLights(),U!==null&&U.updateLights(S.state.lightsArray),mn=this.localClippingEnabled,Ue=it.init(this.clippingPlanes,mn),Ue===!0&&it.setGlobalState(this.clippingPlanes,H),U!==null&&mt.render(S.state.shadowsArray,Q,H);let Y=new Set;return R.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Tt=Z.material;if(Tt)if(Array.isArray(Tt))for(let Lt=0;Lt<Tt.length;Lt++){let Rt=Tt[Lt];Pa(Rt,Q,H,Z),Y.add(Rt)}else Pa(Tt,Q,H,Z),Y.add(Tt)}),S=b.pop(),U!==null&&U.renderEnd(),Y},this.compileAsync=function(R,H,Q=null){let Y=this.compile(R,H,Q);return new Promise(Z=>{function Tt(){if(Y.forEach(function(Lt){let Ft=Gt.get(Lt).currentProgram;(Ft===void 0||Ft.isReady())&&Y.delete(Lt)}),Y.size===0){Z(R);return}setTimeout(Tt,10)}Kt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let _o=null;function Mf(R){_o&&_o(R)}function rc(){zr.stop()}function xr(){zr.start()}let zr=new Uv;zr.setAnimationLoop(Mf),typeof self<"u"&&zr.setContext(self),this.setAnimationLoop=function(R){_o=R,ht.setAnimationLoop(R),R===null?zr.stop():zr.start()},ht.addEventListener("sessionstart",rc),ht.addEventListener("sessionend",xr),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){se("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;U!==null&&U.renderStart(R,H);let Q=ht.enabled===!0&&ht.isPresenting===!0,Y=N!==null&&(rt===null||Q)&&N.begin(C,rt);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(H),H=ht.getCamera()),R.isScene===!0&&R.onBeforeRender(C,R,H,rt),S=et.get(R,b.length),S.init(H),S.state.textureUnits=jt.getTextureUnits(),b.push(S),Oe.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?ve.setFromArrayCamera(H):Yt.setFromProjectionMatrix(Oe,Zi,H.reversedDepth),mn=this.localClippingEnabled,Ue=it.init(this.clippingPlanes,mn),E=bt.get(R,v.length),E.init(),v.push(E),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Lt=C.xr.getDepthSensingMesh();Lt!==null&&Vr(Lt,H,-1/0,C.sortObjects)}Vr(R,H,0,C.sortObjects),E.finish(),U!==null&&U.updateLights(S.state.lightsArray),C.sortObjects===!0&&E.sort(zt,te),rn=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,rn&&O.addToRenderList(E,R),this.info.autoReset===!0&&this.info.reset(),Ue===!0&&it.beginShadows();let Z=S.state.shadowsArray;if(mt.render(Z,R,H),Ue===!0&&it.endShadows(),(Y&&N.hasRenderPass())===!1){let Lt=E.opaque,Rt=E.transmissive;if(S.setupLights(),H.isArrayCamera){let Ft=H.cameras;if(Rt.length>0)for(let Vt=0,re=Ft.length;Vt<re;Vt++){let pe=Ft[Vt];tr(Lt,Rt,R,pe)}rn&&O.render(R);for(let Vt=0,re=Ft.length;Vt<re;Vt++){let pe=Ft[Vt];Ia(E,R,pe,pe.viewport)}}else Rt.length>0&&tr(Lt,Rt,R,H),rn&&O.render(R),Ia(E,R,H)}rt!==null&&G===0&&(jt.updateMultisampleRenderTarget(rt),jt.updateRenderTargetMipmap(rt)),Y&&N.end(C),R.isScene===!0&&R.onAfterRender(C,R,H),St.resetDefaultState(),$=-1,j=null,b.pop(),b.length>0?(S=b[b.length-1],jt.setTextureUnits(S.state.textureUnits),Ue===!0&&it.setGlobalState(C.clippingPlanes,S.state.camera)):S=null,v.pop(),v.length>0?E=v[v.length-1]:E=null,U!==null&&U.renderEnd()};function Vr(R,H,Q,Y){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)Q=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)S.pushLight(R),R.castShadow&&S.pushShadow(R);else if(R.isSprite){let Lt=H.isArrayCamera?ve:Yt;if(!R.frustumCulled||R.intersectsFrustum(Lt)){Y&&be.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Oe);let Rt=ft.update(R),Ft=R.material;Ft.visible&&E.push(R,Rt,Ft,Q,be.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Lt=H.isArrayCamera?ve:Yt;if(!R.frustumCulled||R.intersectsFrustum(Lt)){let Rt=ft.update(R),Ft=R.material;if(Y&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),be.copy(R.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),be.copy(Rt.boundingSphere.center)),be.applyMatrix4(R.matrixWorld).applyMatrix4(Oe)),Array.isArray(Ft)){let Vt=Rt.groups;for(let re=0,pe=Vt.length;re<pe;re++){let Bt=Vt[re],me=Ft[Bt.materialIndex];me&&me.visible&&E.push(R,Rt,me,Q,be.z,Bt,H)}}else Ft.visible&&E.push(R,Rt,Ft,Q,be.z,null,H)}}}let Tt=R.children;for(let Lt=0,Rt=Tt.length;Lt<Rt;Lt++)Vr(Tt[Lt],H,Q,Y)}function Ia(R,H,Q,Y){let{opaque:Z,transmissive:Tt,transparent:Lt}=R;S.setupLightsView(Q),Ue===!0&&it.setGlobalState(C.clippingPlanes,Q),Y&&At.viewport(tt.copy(Y)),Z.length>0&&sn(Z,H,Q),Tt.length>0&&sn(Tt,H,Q),Lt.length>0&&sn(Lt,H,Q),At.buffers.depth.setTest(!0),At.buffers.depth.setMask(!0),At.buffers.color.setMask(!0),At.setPolygonOffset(!1)}function tr(R,H,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[Y.id]===void 0){let Bt=Kt.has("EXT_color_buffer_half_float")||Kt.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[Y.id]=new ki(1,1,{generateMipmaps:!0,type:Bt?mr:_i,minFilter:rs,samples:Math.max(4,le.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_e.workingColorSpace})}let Tt=S.state.transmissionRenderTarget[Y.id],Lt=Y.viewport||tt;Tt.setSize(Lt.z*C.transmissionResolutionScale,Lt.w*C.transmissionResolutionScale);let Rt=C.getRenderTarget(),Ft=C.getActiveCubeFace(),Vt=C.getActiveMipmapLevel();C.setRenderTarget(Tt),C.getClearColor(J),gt=C.getClearAlpha(),gt<1&&C.setClearColor(16777215,.5),C.clear(),rn&&O.render(Q);let re=C.toneMapping;C.toneMapping=Fr;let pe=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),S.setupLightsView(Y),Ue===!0&&it.setGlobalState(C.clippingPlanes,Y),sn(R,Q,Y),jt.updateMultisampleRenderTarget(Tt),jt.updateRenderTargetMipmap(Tt),Kt.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let me=0,en=H.length;me<en;me++){let Ie=H[me],{object:Le,geometry:En,material:Ut,group:yn}=Ie;if(Ut.side===Qi&&Le.layers.test(Y.layers)){let ye=Ut.side;Ut.side=mi,Ut.needsUpdate=!0,fn(Le,Q,Y,En,Ut,yn),Ut.side=ye,Ut.needsUpdate=!0,Bt=!0}}Bt===!0&&(jt.updateMultisampleRenderTarget(Tt),jt.updateRenderTargetMipmap(Tt))}C.setRenderTarget(Rt,Ft,Vt),C.setClearColor(J,gt),pe!==void 0&&(Y.viewport=pe),C.toneMapping=re}function sn(R,H,Q){let Y=H.isScene===!0?H.overrideMaterial:null;for(let Z=0,Tt=R.length;Z<Tt;Z++){let Lt=R[Z],{object:Rt,geometry:Ft,group:Vt}=Lt,re=Lt.material;re.allowOverride===!0&&Y!==null&&(re=Y),Rt.layers.test(Q.layers)&&fn(Rt,H,Q,Ft,re,Vt)}}function fn(R,H,Q,Y,Z,Tt){U!==null&&Z.isNodeMaterial&&U.setObject(R,Z),R.onBeforeRender(C,H,Q,Y,Z,Tt),R.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Z.onBeforeRender(C,H,Q,Y,R,Tt),Z.transparent===!0&&Z.side===Qi&&Z.forceSinglePass===!1?(Z.side=mi,Z.needsUpdate=!0,C.renderBufferDirect(Q,H,Y,Z,R,Tt),Z.side=Ds,Z.needsUpdate=!0,C.renderBufferDirect(Q,H,Y,Z,R,Tt),Z.side=Qi):C.renderBufferDirect(Q,H,Y,Z,R,Tt),R.onAfterRender(C,H,Q,Y,Z,Tt)}function dn(R){let H=0;for(let Q of R)Q.texture!==null&&H++;return H}function _r(R,H,Q){H.isScene!==!0&&(H=An);let Y=Gt.get(R),Z=S.state.lights,Tt=S.state.shadowsArray,Lt=Z.state.version,Rt=ot.getParameters(R,Z.state,Tt,H,Q,S.state.lightProbeGridArray),Ft=ot.getProgramCacheKey(Rt),Vt=Y.programs;Y.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,Y.fog=H.fog;let re=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Y.envMap=P.get(R.envMap||Y.environment,re),Y.envMapRotation=Y.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,Vt===void 0&&(R.addEventListener("dispose",he),Vt=new Map,Y.programs=Vt,Y.programVariants=new Map);let pe=Vt.get(Ft);if(pe!==void 0){if(Y.currentProgram===pe&&Y.lightsStateVersion===Lt)return La(R,Rt),pe}else Rt.uniforms=ot.getUniforms(R),U!==null&&R.isNodeMaterial&&U.build(R,Q,Rt),R.onBeforeCompile(Rt,C),pe=ot.acquireProgram(Rt,Ft),Vt.set(Ft,pe),Y.uniforms=Rt.uniforms;let Bt=Y.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Bt.clippingPlanes=it.uniform),La(R,Rt),Y.needsLights=cs(R),Y.lightsStateVersion=Lt,Y.needsLights&&(Bt.ambientLightColor.value=Z.state.ambient,Bt.lightProbe.value=Z.state.probe,Bt.sunLights.value=Z.state.sun,Bt.sunLightShadows.value=Z.state.sunShadow,Bt.directionalLights.value=Z.state.directional,Bt.directionalLightShadows.value=Z.state.directionalShadow,Bt.spotLights.value=Z.state.spot,Bt.spotLightShadows.value=Z.state.spotShadow,Bt.rectAreaLights.value=Z.state.rectArea,Bt.ltc_1.value=Z.state.rectAreaLTC1,Bt.ltc_2.value=Z.state.rectAreaLTC2,Bt.pointLights.value=Z.state.point,Bt.pointLightShadows.value=Z.state.pointShadow,Bt.hemisphereLights.value=Z.state.hemi,Bt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Bt.sunShadowCascade.value=Z.state.sunShadowCascade,Bt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Bt.spotLightMatrix.value=Z.state.spotLightMatrix,Bt.spotLightMap.value=Z.state.spotLightMap,Bt.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=dn(S.state.lightProbeGridArray),Y.currentProgram=pe,Y.uniformsList=null,pe}function bi(R,H,Q,Y,Z){let Tt=Gt.get(R),Lt=Tt.currentProgram.id+","+Y+","+Z,Rt=Tt.programVariants.get(Lt);return Rt===void 0?(Rt=_r(R,H,Q),Tt.programVariants.set(Lt,Rt)):(Tt.currentProgram=Rt,Tt.uniformsList=null,Tt.outputColorSpace=Y,Tt.toneMapping=Z),Rt}function ls(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=Sa.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function La(R,H){let Q=Gt.get(R);Q.outputColorSpace=H.outputColorSpace,Q.batching=H.batching,Q.batchingColor=H.batchingColor,Q.instancing=H.instancing,Q.instancingColor=H.instancingColor,Q.instancingMorph=H.instancingMorph,Q.skinning=H.skinning,Q.morphTargets=H.morphTargets,Q.morphNormals=H.morphNormals,Q.morphColors=H.morphColors,Q.morphTargetsCount=H.morphTargetsCount,Q.numClippingPlanes=H.numClippingPlanes,Q.numIntersection=H.numClipIntersection,Q.vertexAlphas=H.vertexAlphas,Q.vertexTangents=H.vertexTangents,Q.toneMapping=H.toneMapping}function Fa(R,H,Q,Y,Z){H.isScene!==!0&&(H=An),jt.resetTextureUnits();let Tt=H.fog,Lt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?H.environment:null,Rt=rt===null?C.outputColorSpace:rt.isXRRenderTarget===!0?rt.texture.colorSpace:_e.workingColorSpace,Ft=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Vt=P.get(Y.envMap||Lt,Ft),re=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,pe=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Bt=!!Q.morphAttributes.position,me=!!Q.morphAttributes.normal,en=!!Q.morphAttributes.color,Ie=Fr;Y.toneMapped&&(rt===null||rt.isXRRenderTarget===!0)&&(Ie=C.toneMapping);let Le=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,En=Le!==void 0?Le.length:0,Ut=Gt.get(Y),yn=S.state.lights;if(Ue===!0&&(mn===!0||R!==j)){let Fe=R===j&&Y.id===$;it.setState(Y,R,Fe)}let ye=!1,Gr=!1;Y.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==yn.state.version||Z.isBatchedMesh&&Ut.batching===!1||!Z.isBatchedMesh&&Ut.batching===!0||Z.isBatchedMesh&&Ut.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ut.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ut.instancing===!1||!Z.isInstancedMesh&&Ut.instancing===!0||Z.isSkinnedMesh&&Ut.skinning===!1||!Z.isSkinnedMesh&&Ut.skinning===!0||Z.isInstancedMesh&&Ut.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ut.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ut.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ut.instancingMorph===!1&&Z.morphTexture!==null||Ut.envMap!==Vt||Y.fog===!0&&Ut.fog!==Tt||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==it.numPlanes||Ut.numIntersection!==it.numIntersection)||Ut.vertexAlphas!==re||Ut.vertexTangents!==pe||Ut.morphTargets!==Bt||Ut.morphNormals!==me||Ut.morphColors!==en||Ut.morphTargetsCount!==En||Ut.numLightProbeGrids!==dn(S.state.lightProbeGridArray)?ye=!0:(Ut.outputColorSpace!==Rt||Ut.toneMapping!==Ie)&&(Gr=!0):(ye=!0,Ut.__version=Y.version);let xn=Ut.currentProgram;(ye===!0||Gr===!0)&&(xn=Gr===!0?bi(Y,H,Z,Rt,Ie):_r(Y,H,Z),U&&Y.isNodeMaterial&&U.onUpdateProgram(Y,xn,Ut));let wo=!1,vr=!1,Hr=!1,fe=xn.getUniforms(),on=Ut.uniforms;if(At.useProgram(xn.program)&&(wo=!0,vr=!0,Hr=!0),Y.id!==$&&($=Y.id,vr=!0),wo||j!==R){At.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),fe.setValue(k,"projectionMatrix",R.projectionMatrix),fe.setValue(k,"viewMatrix",R.matrixWorldInverse);let _n=fe.map.cameraPosition;_n!==void 0&&_n.setValue(k,Nn.setFromMatrixPosition(R.matrixWorld)),le.logarithmicDepthBuffer&&fe.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&fe.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),j!==R&&(j=R,vr=!0,Hr=!0)}if(Ut.needsLights&&(yn.state.sunShadowMap.length>0&&fe.setValue(k,"sunShadowMap",yn.state.sunShadowMap,jt),yn.state.directionalShadowMap.length>0&&fe.setValue(k,"directionalShadowMap",yn.state.directionalShadowMap,jt),yn.state.spotShadowMap.length>0&&fe.setValue(k,"spotShadowMap",yn.state.spotShadowMap,jt),yn.state.pointShadowMap.length>0&&fe.setValue(k,"pointShadowMap",yn.state.pointShadowMap,jt)),Z.isSkinnedMesh){fe.setOptional(k,Z,"bindMatrix"),fe.setOptional(k,Z,"bindMatrixInverse");let Fe=Z.skeleton;Fe&&(Fe.boneTexture===null&&Fe.computeBoneTexture(),fe.setValue(k,"boneTexture",Fe.boneTexture,jt))}Z.isBatchedMesh&&(fe.setOptional(k,Z,"batchingTexture"),fe.setValue(k,"batchingTexture",Z._matricesTexture,jt),fe.setOptional(k,Z,"batchingIdTexture"),fe.setValue(k,"batchingIdTexture",Z._indirectTexture,jt),fe.setOptional(k,Z,"batchingColorTexture"),Z._colorsTexture!==null&&fe.setValue(k,"batchingColorTexture",Z._colorsTexture,jt));let oi=Q.morphAttributes;if((oi.position!==void 0||oi.normal!==void 0||oi.color!==void 0)&&st.update(Z,Q,xn),(vr||Ut.receiveShadow!==Z.receiveShadow)&&(Ut.receiveShadow=Z.receiveShadow,fe.setValue(k,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&H.environment!==null&&(on.envMapIntensity.value=H.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=o3()),vr){if(fe.setValue(k,"toneMappingExposure",C.toneMappingExposure),Ut.needsLights&&vo(on,Hr),Tt&&Y.fog===!0&&vt.refreshFogUniforms(on,Tt),vt.refreshMaterialUniforms(on,Y,xt,Mt,S.state.transmissionRenderTarget[R.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Fe=_,_n=0;for(let Qn of S.state.lightProbeGridArray)Qn.texture!==null&&(Fe.textures[_n]=Qn.texture,Fe.min[_n]=Qn.boundingBox.min,Fe.max[_n]=Qn.boundingBox.max,Fe.resolution[_n]=Qn.resolution,_n++);for(let Qn in Fe)Fe[Qn].length=_n;on.probesSH.value=Fe.textures,on.probesMin.value=Fe.min,on.probesMax.value=Fe.max,on.probesResolution.value=Fe.resolution}Sa.upload(k,ls(Ut),on,jt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Sa.upload(k,ls(Ut),on,jt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&fe.setValue(k,"center",Z.center),fe.setValue(k,"modelViewMatrix",Z.modelViewMatrix),fe.setValue(k,"normalMatrix",Z.normalMatrix),fe.setValue(k,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Fe=Y.uniformsGroups;for(let _n=0,Qn=Fe.length;_n<Qn;_n++){let sc=Fe[_n];Ht.update(sc,xn),Ht.bind(sc,xn)}}return xn}function vo(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function cs(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return rt},this.setRenderTargetTextures=function(R,H,Q){let Y=Gt.get(R);Y.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Gt.get(R.texture).__webglTexture=H,Gt.get(R.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let Q=Gt.get(R);Q.__webglFramebuffer=H,Q.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,Q=0){rt=R,q=H,G=Q;let Y=null,Z=!1,Tt=!1;if(R){let Rt=Gt.get(R);if(Rt.__useDefaultFramebuffer!==void 0){At.bindFramebuffer(k.FRAMEBUFFER,Rt.__webglFramebuffer),tt.copy(R.viewport),ut.copy(R.scissor),ct=R.scissorTest,At.viewport(tt),At.scissor(ut),At.setScissorTest(ct),$=-1;return}else if(Rt.__webglFramebuffer===void 0)jt.setupRenderTarget(R);else if(Rt.__hasExternalTextures)jt.rebindTextures(R,Gt.get(R.texture).__webglTexture,Gt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let re=R.depthTexture;if(Rt.__boundDepthTexture!==re){if(re!==null&&Gt.has(re)&&(R.width!==re.image.width||R.height!==re.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");jt.setupDepthRenderbuffer(R)}}let Ft=R.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(Tt=!0);let Vt=Gt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Vt[H])?Y=Vt[H][Q]:Y=Vt[H],Z=!0):R.samples>0&&jt.useMultisampledRTT(R)===!1?Y=Gt.get(R).__webglMultisampledFramebuffer:Array.isArray(Vt)?Y=Vt[Q]:Y=Vt,tt.copy(R.viewport),ut.copy(R.scissor),ct=R.scissorTest}else tt.copy(dt).multiplyScalar(xt).floor(),ut.copy(Wt).multiplyScalar(xt).floor(),ct=qt;if(Q!==0&&(Y=B),At.bindFramebuffer(k.FRAMEBUFFER,Y)&&At.drawBuffers(R,Y),At.viewport(tt),At.scissor(ut),At.setScissorTest(ct),Z){let Rt=Gt.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+H,Rt.__webglTexture,Q)}else if(Tt){let Rt=H;for(let Ft=0;Ft<R.textures.length;Ft++){let Vt=Gt.get(R.textures[Ft]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ft,Vt.__webglTexture,Q,Rt)}}else if(R!==null&&Q!==0){let Rt=Gt.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Rt.__webglTexture,Q)}$=-1};function bo(R){let H=Gt.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=le.textureFormatReadable(R.format),H.__typeReadable=le.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,Q,Y,Z,Tt,Lt,Rt=0){if(!(R&&R.isWebGLRenderTarget)){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Gt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Lt!==void 0&&(Ft=Ft[Lt],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){At.bindFramebuffer(k.FRAMEBUFFER,Ft);try{let Vt=R.textures[Rt],re=Vt.format,pe=Vt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Bt=bo(Vt);if(Bt.__formatReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-Y&&Q>=0&&Q<=R.height-Z&&k.readPixels(H,Q,Y,Z,_t.convert(re),_t.convert(pe),Tt)}finally{let Vt=rt!==null?Gt.get(rt).__webglFramebuffer:null;At.bindFramebuffer(k.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(R,H,Q,Y,Z,Tt,Lt,Rt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Gt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Lt!==void 0&&(Ft=Ft[Lt],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(H>=0&&H<=R.width-Y&&Q>=0&&Q<=R.height-Z){At.bindFramebuffer(k.FRAMEBUFFER,Ft);let Vt=R.textures[Rt],re=Vt.format,pe=Vt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Bt=bo(Vt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let me=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,me),k.bufferData(k.PIXEL_PACK_BUFFER,Tt.byteLength,k.STREAM_READ),k.readPixels(H,Q,Y,Z,_t.convert(re),_t.convert(pe),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let en=rt!==null?Gt.get(rt).__webglFramebuffer:null;At.bindFramebuffer(k.FRAMEBUFFER,en);let Ie=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await uv(k,Ie,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,me),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Tt),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(me),k.deleteSync(Ie),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,Q=0){let Y=Math.pow(2,-Q),Z=Math.floor(R.image.width*Y),Tt=Math.floor(R.image.height*Y),Lt=H!==null?H.x:0,Rt=H!==null?H.y:0;jt.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,Lt,Rt,Z,Tt),At.unbindTexture()},this.copyTextureToTexture=function(R,H,Q=null,Y=null,Z=0,Tt=0){let Lt,Rt,Ft,Vt,re,pe,Bt,me,en,Ie=R.isCompressedTexture?R.mipmaps[Tt]:R.image;if(Q!==null)Lt=Q.max.x-Q.min.x,Rt=Q.max.y-Q.min.y,Ft=Q.isBox3?Q.max.z-Q.min.z:1,Vt=Q.min.x,re=Q.min.y,pe=Q.isBox3?Q.min.z:0;else{let fe=Math.pow(2,-Z);Lt=Math.floor(Ie.width*fe),Rt=Math.floor(Ie.height*fe),R.isDataArrayTexture?Ft=Ie.depth:R.isData3DTexture?Ft=Math.floor(Ie.depth*fe):Ft=1,Vt=0,re=0,pe=0}Y!==null?(Bt=Y.x,me=Y.y,en=Y.z):(Bt=0,me=0,en=0);let Le=_t.convert(H.format),En=_t.convert(H.type),Ut;H.isData3DTexture?(jt.setTexture3D(H,0),Ut=k.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(jt.setTexture2DArray(H,0),Ut=k.TEXTURE_2D_ARRAY):(jt.setTexture2D(H,0),Ut=k.TEXTURE_2D),At.activeTexture(k.TEXTURE0),At.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,H.flipY),At.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),At.pixelStorei(k.UNPACK_ALIGNMENT,H.unpackAlignment);let yn=At.getParameter(k.UNPACK_ROW_LENGTH),ye=At.getParameter(k.UNPACK_IMAGE_HEIGHT),Gr=At.getParameter(k.UNPACK_SKIP_PIXELS),xn=At.getParameter(k.UNPACK_SKIP_ROWS),wo=At.getParameter(k.UNPACK_SKIP_IMAGES);At.pixelStorei(k.UNPACK_ROW_LENGTH,Ie.width),At.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ie.height),At.pixelStorei(k.UNPACK_SKIP_PIXELS,Vt),At.pixelStorei(k.UNPACK_SKIP_ROWS,re),At.pixelStorei(k.UNPACK_SKIP_IMAGES,pe);let vr=R.isDataArrayTexture||R.isData3DTexture,Hr=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let fe=Gt.get(R),on=Gt.get(H),oi=Gt.get(fe.__renderTarget),Fe=Gt.get(on.__renderTarget);At.bindFramebuffer(k.READ_FRAMEBUFFER,oi.__webglFramebuffer),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let _n=0;_n<Ft;_n++)vr&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gt.get(R).__webglTexture,Z,pe+_n),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gt.get(H).__webglTexture,Tt,en+_n)),k.blitFramebuffer(Vt,re,Vt+Lt,re+Rt,Bt,me,Bt+Lt,me+Rt,k.DEPTH_BUFFER_BIT,k.NEAREST);At.bindFramebuffer(k.READ_FRAMEBUFFER,null),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Z!==0||R.isRenderTargetTexture||Gt.has(R)){let fe=Gt.get(R),on=Gt.get(H);At.bindFramebuffer(k.READ_FRAMEBUFFER,F),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,V);for(let oi=0;oi<Ft;oi++)vr?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,fe.__webglTexture,Z,pe+oi):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,fe.__webglTexture,Z),Hr?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,on.__webglTexture,Tt,en+oi):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,on.__webglTexture,Tt),Z!==0?k.blitFramebuffer(Vt,re,Vt+Lt,re+Rt,Bt,me,Bt+Lt,me+Rt,k.COLOR_BUFFER_BIT,k.NEAREST):Hr?k.copyTexSubImage3D(Ut,Tt,Bt,me,en+oi,Vt,re,Lt,Rt):k.copyTexSubImage2D(Ut,Tt,Bt,me,Vt,re,Lt,Rt);At.bindFramebuffer(k.READ_FRAMEBUFFER,null),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Hr?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(Ut,Tt,Bt,me,en,Lt,Rt,Ft,Le,En,Ie.data):H.isCompressedArrayTexture?k.compressedTexSubImage3D(Ut,Tt,Bt,me,en,Lt,Rt,Ft,Le,Ie.data):k.texSubImage3D(Ut,Tt,Bt,me,en,Lt,Rt,Ft,Le,En,Ie):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,me,Lt,Rt,Le,En,Ie.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Tt,Bt,me,Ie.width,Ie.height,Le,Ie.data):k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,me,Lt,Rt,Le,En,Ie);At.pixelStorei(k.UNPACK_ROW_LENGTH,yn),At.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ye),At.pixelStorei(k.UNPACK_SKIP_PIXELS,Gr),At.pixelStorei(k.UNPACK_SKIP_ROWS,xn),At.pixelStorei(k.UNPACK_SKIP_IMAGES,wo),Tt===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&k.generateMipmap(Ut),At.unbindTexture()},this.initRenderTarget=function(R){Gt.get(R).__webglFramebuffer===void 0&&jt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?jt.setTextureCube(R,0):R.isData3DTexture?jt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?jt.setTexture2DArray(R,0):jt.setTexture2D(R,0),At.unbindTexture()},this.resetState=function(){q=0,G=0,rt=null,At.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Zi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};var $v={type:"change"},wm={type:"start"},jv={type:"end"},Kh=new ro,Yv=new Oi,a3=Math.cos(70*yr.DEG2RAD),Fn=new z,vi=2*Math.PI,Ee={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},bm=1e-6,Jh=class extends kl{constructor(t,e=null){super(t,e),this.state=Ee.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Fs.ROTATE,MIDDLE:Fs.DOLLY,RIGHT:Fs.PAN},this.touches={ONE:Ns.ROTATE,TWO:Ns.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Hn,this._lastTargetPosition=new z,this._quat=new Hn().setFromUnitVectors(t.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ls,this._sphericalDelta=new Ls,this._scale=1,this._panOffset=new z,this._rotateStart=new Jt,this._rotateEnd=new Jt,this._rotateDelta=new Jt,this._panStart=new Jt,this._panEnd=new Jt,this._panDelta=new Jt,this._dollyStart=new Jt,this._dollyEnd=new Jt,this._dollyDelta=new Jt,this._dollyDirection=new z,this._mouse=new Jt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=c3.bind(this),this._onPointerDown=l3.bind(this),this._onPointerUp=u3.bind(this),this._onContextMenu=y3.bind(this),this._onMouseWheel=d3.bind(this),this._onKeyDown=p3.bind(this),this._onTouchStart=m3.bind(this),this._onTouchMove=g3.bind(this),this._onMouseDown=h3.bind(this),this._onMouseMove=f3.bind(this),this._interceptControlDown=x3.bind(this),this._interceptControlUp=_3.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ee.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent($v),this.update(),this.state=Ee.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Fn.copy(e).sub(this.target),Fn.applyQuaternion(this._quat),this._spherical.setFromVector3(Fn),this.autoRotate&&this.state===Ee.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,i=this.maxAzimuthAngle;isFinite(n)&&isFinite(i)&&(n<-Math.PI?n+=vi:n>Math.PI&&(n-=vi),i<-Math.PI?i+=vi:i>Math.PI&&(i-=vi),n<=i?this._spherical.theta=Math.max(n,Math.min(i,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+i)/2?Math.max(n,this._spherical.theta):Math.min(i,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let s=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),s=o!=this._spherical.radius}if(Fn.setFromSpherical(this._spherical),Fn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Fn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Fn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),s=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),s=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Fn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Kh.origin.copy(this.object.position),Kh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Kh.direction))<a3?this.object.lookAt(this.target):(Yv.setFromNormalAndCoplanarPoint(this.object.up,this.target),Kh.intersectPlane(Yv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),s=!0)}return this._scale=1,this._performCursorZoom=!1,s||this._lastPosition.distanceToSquared(this.object.position)>bm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>bm||this._lastTargetPosition.distanceToSquared(this.target)>bm?(this.dispatchEvent($v),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?vi/60*this.autoRotateSpeed*t:vi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Fn.setFromMatrixColumn(e,0),Fn.multiplyScalar(-t),this._panOffset.add(Fn)}_panUp(t,e){this.screenSpacePanning===!0?Fn.setFromMatrixColumn(e,1):(Fn.setFromMatrixColumn(e,0),Fn.crossVectors(this.object.up,Fn)),Fn.multiplyScalar(t),this._panOffset.add(Fn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let i=this.object.position;Fn.copy(i).sub(this.target);let s=Fn.length();s*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*s/n.clientHeight,this.object.matrix),this._panUp(2*e*s/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),i=t-n.left,s=e-n.top,o=n.width,a=n.height;this._mouse.x=i/o*2-1,this._mouse.y=-(s/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(vi*this._rotateDelta.x/e.clientHeight),this._rotateUp(vi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(vi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-vi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(vi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-vi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),i=.5*(t.pageY+e.y);this._rotateStart.set(n,i)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),i=.5*(t.pageY+e.y);this._panStart.set(n,i)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,i=t.pageY-e.y,s=Math.sqrt(n*n+i*i);this._dollyStart.set(0,s)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),i=.5*(t.pageX+n.x),s=.5*(t.pageY+n.y);this._rotateEnd.set(i,s)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(vi*this._rotateDelta.x/e.clientHeight),this._rotateUp(vi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),i=.5*(t.pageY+e.y);this._panEnd.set(n,i)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,i=t.pageY-e.y,s=Math.sqrt(n*n+i*i);this._dollyEnd.set(0,s),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Jt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function l3(r){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(r.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(r)&&(this._addPointer(r),r.pointerType==="touch"?this._onTouchStart(r):this._onMouseDown(r),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function c3(r){this.enabled!==!1&&(r.pointerType==="touch"?this._onTouchMove(r):this._onMouseMove(r))}function u3(r){switch(this._removePointer(r),this._pointers.length){case 0:this.domElement.releasePointerCapture(r.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(jv),this.state=Ee.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function h3(r){let t;switch(r.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Fs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(r),this.state=Ee.DOLLY;break;case Fs.ROTATE:if(r.ctrlKey||r.metaKey||r.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(r),this.state=Ee.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(r),this.state=Ee.ROTATE}break;case Fs.PAN:if(r.ctrlKey||r.metaKey||r.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(r),this.state=Ee.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(r),this.state=Ee.PAN}break;default:this.state=Ee.NONE}this.state!==Ee.NONE&&this.dispatchEvent(wm)}function f3(r){switch(this.state){case Ee.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(r);break;case Ee.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(r);break;case Ee.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(r);break}}function d3(r){this.enabled===!1||this.enableZoom===!1||this.state!==Ee.NONE||(r.preventDefault(),this.dispatchEvent(wm),this._handleMouseWheel(this._customWheelEvent(r)),this.dispatchEvent(jv))}function p3(r){this.enabled!==!1&&this._handleKeyDown(r)}function m3(r){switch(this._trackPointer(r),this._pointers.length){case 1:switch(this.touches.ONE){case Ns.ROTATE:if(this.enableRotate===!1){this.state=Ee.NONE;break}this._handleTouchStartRotate(r),this.state=Ee.TOUCH_ROTATE;break;case Ns.PAN:if(this.enablePan===!1){this.state=Ee.NONE;break}this._handleTouchStartPan(r),this.state=Ee.TOUCH_PAN;break;default:this.state=Ee.NONE}break;case 2:switch(this.touches.TWO){case Ns.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(r),this.state=Ee.TOUCH_DOLLY_PAN;break;case Ns.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(r),this.state=Ee.TOUCH_DOLLY_ROTATE;break;default:this.state=Ee.NONE}break;default:this.state=Ee.NONE}this.state!==Ee.NONE&&this.dispatchEvent(wm)}function g3(r){switch(this._trackPointer(r),this.state){case Ee.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(r),this.update();break;case Ee.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(r),this.update();break;case Ee.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(r),this.update();break;case Ee.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(r),this.update();break;default:this.state=Ee.NONE}}function y3(r){this.enabled!==!1&&r.preventDefault()}function x3(r){r.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function _3(r){r.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Zv=["iso","front","side","top","tip"],v3={iso:[.62,-1,.55],front:[1,0,.08],side:[0,-1,.08],top:[0,-.001,1],tip:[.62,-1,.4]},b3=.35,Qh=class{constructor(t,e,n,i){this.camera=t;this.canvas=e;this.reach=n;this.changed=i;this.controls=new Jh(t,e),this.controls.minDistance=.05*n,this.controls.maxDistance=40*n,this.controls.enableZoom=!1,this.controls.addEventListener("change",i),e.addEventListener("keydown",this.key),e.addEventListener("focus",this.zoomable),e.addEventListener("blur",this.zoomable)}camera;canvas;reach;changed;view="iso";box=new jn;controls;start=new z;end=new z;targetStart=new z;targetEnd=new z;offset=new z;spherical=new Ls;began=0;gliding=0;show(t,e,n){this.view=t;let i=this.offset.set(...v3[t]).normalize(),s=t==="tip";s?this.targetEnd.fromArray(e):this.box.getCenter(this.targetEnd);let o=s?.55*this.reach:this.fitting(i,this.targetEnd);if(this.end.copy(this.targetEnd).addScaledVector(i,o),cancelAnimationFrame(this.gliding),!n)return this.place(1);this.start.copy(this.camera.position),this.targetStart.copy(this.controls.target),this.began=performance.now(),this.step(this.began)}take(t){this.view=t.view,this.camera.position.copy(t.camera.position),this.controls.target.copy(t.controls.target),this.controls.update()}follow(t){this.view==="tip"&&(this.offset.copy(this.camera.position).sub(this.controls.target),this.controls.target.fromArray(t),this.camera.position.copy(this.controls.target).add(this.offset),this.camera.lookAt(this.controls.target))}dispose(){cancelAnimationFrame(this.gliding),this.controls.dispose(),this.canvas.removeEventListener("keydown",this.key),this.canvas.removeEventListener("focus",this.zoomable),this.canvas.removeEventListener("blur",this.zoomable)}zoomable=t=>{this.controls.enableZoom=t.type==="focus"};key=t=>{if(t.ctrlKey||t.metaKey||t.altKey)return;let e=yr.degToRad(5),i={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[t.key];if(i&&t.shiftKey)this.pan(.04*i[0],-.04*i[1]);else if(i)this.turn(e*i[0],e*i[1],1);else if(t.key==="+"||t.key==="=")this.turn(0,0,1/1.15);else if(t.key==="-")this.turn(0,0,1.15);else return;t.preventDefault(),t.stopPropagation()};turn(t,e,n){let{camera:i,controls:s,offset:o,spherical:a}=this;o.copy(i.position).sub(s.target),a.setFromCartesianCoords(o.y,o.z,o.x),a.theta+=t,a.phi=yr.clamp(a.phi+e,.001,Math.PI-.001),a.radius=yr.clamp(a.radius*n,s.minDistance,s.maxDistance),o.setFromSpherical(a),i.position.set(o.z,o.x,o.y).add(s.target),s.update(),this.changed()}pan(t,e){let{camera:n,controls:i,offset:s}=this,o=n.position.distanceTo(i.target);for(let[a,l]of[[0,t],[1,e]])s.setFromMatrixColumn(n.matrix,a).multiplyScalar(l*o),n.position.add(s),i.target.add(s);i.update(),this.changed()}fitting(t,e){let{camera:n,box:i}=this,s=Math.tan(yr.degToRad(n.fov/2)),o=new z().crossVectors(n.up,t).normalize(),a=new z().crossVectors(t,o),l=new z,c=.3*this.reach;for(let u=0;u<8;u++){l.set(u&1?i.max.x:i.min.x,u&2?i.max.y:i.min.y,u&4?i.max.z:i.min.z).sub(e);let h=l.dot(t);c=Math.max(c,Math.abs(l.dot(o))/(s*n.aspect)+h,Math.abs(l.dot(a))/s+h)}return 1.18*c}step=t=>{let e=Math.min(1,Math.max(0,(t-this.began)/1e3/b3));this.place(e*e*(3-2*e)),e<1&&(this.gliding=requestAnimationFrame(this.step))};place(t){this.camera.position.lerpVectors(t<1?this.start:this.end,this.end,t),this.controls.target.lerpVectors(t<1?this.targetStart:this.targetEnd,this.targetEnd,t),this.controls.update(),this.changed()}};var Kv=[["reference","Reference (ghost)"],["rigid","Rigid plan (ghost)"],["traces","Paths of the tips"],["force","Contact force"],["surface","Surface"],["floor","Floor"],["apart","Side by side"]];var M3={iso:"Oblique",front:"Front",side:"Side",top:"Top",tip:"Tip (follows)"},Jv=100;function De(r,t={},...e){let n=document.createElement(r);return Object.assign(n,t),n.append(...e),n}function tb(r,t,e,n,i,s){let o=De("div",{className:"scene-bar",role:"toolbar",ariaLabel:"The robot in space"}),a=Mm("Colour",t,r.colour,u=>{r.colour=u,s.changed()});o.append(De("label",{},Qv("Colour"),a)),n&&o.append(S3(r,s));let l=Mm("View",Zv.map(u=>[u,M3[u]]),"iso",u=>s.look(u));o.append(De("label",{},Qv("View"),l));let c=De("button",{type:"button",ariaLabel:"Reset view"},"Reset");return c.addEventListener("click",()=>s.look(l.value)),o.append(c,E3(r,e,i,s)),o}function S3(r,t){let e=De("input",{type:"range",min:"0",max:String(Jv),step:"1",value:"0",ariaLabel:"Deformation"}),n=De("output",{},"×1");return e.dataset.scene="factor",e.addEventListener("input",()=>{r.factor=A3(200**(Number(e.value)/Jv)),n.textContent=e.ariaValueText=`×${r.factor}`,t.changed()}),e.title="How many times the displacement of each robot from itself without elasticity is enlarged; double click: to scale",e.addEventListener("dblclick",()=>{e.value="0",e.dispatchEvent(new Event("input"))}),De("label",{className:"scene-factor-row"},"Deformation",e,n)}function Qv(r){return De("span",{className:"scene-name"},r)}function A3(r){return r<10?Math.round(10*r)/10:Math.round(r)}function E3(r,t,e,n){let i=De("div",{className:"scene-more"});for(let[o,a]of Kv){if(!t.includes(o))continue;let l=De("input",{type:"checkbox",checked:r[o]});l.dataset.scene=o,l.addEventListener("change",()=>{r[o]=l.checked,n.changed(),o==="apart"&&n.look("iso")}),i.append(De("label",{},l,a))}e&&i.append(De("label",{},"Quality",T3(r,n)));let s=De("details",{},De("summary",{},"Show"),i);return s.addEventListener("keydown",o=>{o.key==="Escape"&&(s.open=!1,s.querySelector("summary")?.focus())}),s}function T3(r,t){return Mm("Quality",[["auto","automatic"],["low","low"],["high","high"],["lines","lines alone"]],r.quality,n=>{r.quality=n,t.quality()})}function Mm(r,t,e,n){let i=De("select",{ariaLabel:r},...t.map(([s,o])=>De("option",{value:s,textContent:o})));return i.value=e,i.addEventListener("change",()=>n(i.value)),i}var R3={m:[[1e-4,1e6,"µm"],[.5,1e3,"mm"]],Pa:[[1e3,1,"Pa"],[1e6,.001,"kPa"],[1/0,1e-6,"MPa"]],rad:[[.1,1e3,"mrad"]],"N m":[[.1,1e3,"mN m"],[1e4,1,"N m"],[1/0,.001,"kN m"]],N:[[.1,1e3,"mN"],[1e4,1,"N"],[1/0,.001,"kN"]],1:[[.01,1e6,"µm/m"],[1/0,100,"%"]]};function tf(r,t){let e=(R3[r]??[]).find(([n])=>Math.abs(t)<n);return e===void 0||t===0?{factor:1,name:r==="1"?"":r}:{factor:e[1],name:e[2]}}function Dr(r){if(!Number.isFinite(r))return"–";let t=Math.abs(r);if(t!==0&&(t>=1e5||t<.001))return r.toExponential(2).replace("-","−");let e=t===0?0:Math.max(0,2-Math.floor(Math.log10(t)));return String(Number(r.toFixed(e))).replace("-","−")}function Jl(r){let t=10**Math.floor(Math.log10(r));return t*(r>=5*t?5:r>=2*t?2:1)}function eb(r){let t=new jn,e=new z,n=.001,i=0;for(let{scene:l}of r.runs){for(let c of[l.line,l.tip])for(let u=0;u+2<c.data.length;u+=3)t.expandByPoint(e.fromArray(c.data,u));n=Math.max(n,C3(l.line.data,l.line.shape));for(let c of l.links)c.section?.sizes.data.forEach(u=>i=Math.max(i,u))}t.isEmpty()&&t.expandByPoint(e.set(0,0,0));let s=Math.max(n,t.getSize(e).length()/2),o=Math.min(Math.max(i,.012*n),.022*n),a=P3(t,r,n);for(let{scene:l}of r.runs)l.line.data.length&&t.expandByPoint(e.fromArray(l.line.data).setZ(a));return{box:t,reach:n,cell:Jl(s/5),usual:o,least:.006*n,floor:a}}function C3(r,[,t,e]){let n=0;for(let i=0;i<t;i++)for(let s=1;s<e;s++){let o=3*(i*e+s);n+=Math.hypot(r[o]-r[o-3],r[o+1]-r[o-2],r[o+2]-r[o-1])}return n}function P3(r,t,e){let n=t.runs[0]?.scene.line.data[2]??0,i=r.max.z-r.min.z>.2*e&&n<e;if(r.min.z>=-.001*e&&i)return 0;let s=Jl(.1*e);return Math.floor((Math.min(r.min.z,n)-.12*e)/s)*s}var nb=new jn,ef=new z,Ea=class extends Ul{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new He(t,3)),this.setAttribute("uv",new He(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new Is(e,6,1);return this.setAttribute("instanceStart",new Ki(n,3,0)),this.setAttribute("instanceEnd",new Ki(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new Is(e,6,1);return this.setAttribute("instanceColorStart",new Ki(n,3,0)),this.setAttribute("instanceColorEnd",new Ki(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new El(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new jn);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),nb.setFromBufferAttribute(e),this.boundingBox.union(nb))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new hr),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let i=0;for(let s=0,o=t.count;s<o;s++)ef.fromBufferAttribute(t,s),i=Math.max(i,n.distanceToSquared(ef)),ef.fromBufferAttribute(e,s),i=Math.max(i,n.distanceToSquared(ef));this.boundingSphere.radius=Math.sqrt(i),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};It.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Jt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};gi.line={uniforms:$l.merge([It.common,It.fog,It.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var ks=class extends Ji{constructor(t){super({type:"LineMaterial",uniforms:$l.clone(gi.line.uniforms),vertexShader:gi.line.vertexShader,fragmentShader:gi.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Sm=new Pe,ib=new z,rb=new z,Zn=new Pe,Kn=new Pe,Ur=new Pe,Am=new z,Em=new Ge,Jn=new Ol,sb=new z,nf=new jn,rf=new hr,Or=new Pe,kr,mo;function ob(r,t,e){return Or.set(0,0,-t,1).applyMatrix4(r.projectionMatrix),Or.multiplyScalar(1/Or.w),Or.x=mo/e.width,Or.y=mo/e.height,Or.applyMatrix4(r.projectionMatrixInverse),Or.multiplyScalar(1/Or.w),Math.abs(Math.max(Or.x,Or.y))}function I3(r,t){let e=r.matrixWorld,n=r.geometry,i=n.attributes.instanceStart,s=n.attributes.instanceEnd,o=Math.min(n.instanceCount,i.count);for(let a=0,l=o;a<l;a++){Jn.start.fromBufferAttribute(i,a),Jn.end.fromBufferAttribute(s,a),Jn.applyMatrix4(e);let c=new z,u=new z;kr.distanceSqToSegment(Jn.start,Jn.end,u,c),u.distanceTo(c)<mo*.5&&t.push({point:u,pointOnLine:c,distance:kr.origin.distanceTo(u),object:r,face:null,faceIndex:a,uv:null,uv1:null})}}function L3(r,t,e){let n=t.projectionMatrix,s=r.material.resolution,o=r.matrixWorld,a=r.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-t.near;kr.at(1,Ur),Ur.w=1,Ur.applyMatrix4(t.matrixWorldInverse),Ur.applyMatrix4(n),Ur.multiplyScalar(1/Ur.w),Ur.x*=s.x/2,Ur.y*=s.y/2,Ur.z=0,Am.copy(Ur),Em.multiplyMatrices(t.matrixWorldInverse,o);for(let f=0,d=u;f<d;f++){if(Zn.fromBufferAttribute(l,f),Kn.fromBufferAttribute(c,f),Zn.w=1,Kn.w=1,Zn.applyMatrix4(Em),Kn.applyMatrix4(Em),Zn.z>h&&Kn.z>h)continue;if(Zn.z>h){let w=Zn.z-Kn.z,_=(Zn.z-h)/w;Zn.lerp(Kn,_)}else if(Kn.z>h){let w=Kn.z-Zn.z,_=(Kn.z-h)/w;Kn.lerp(Zn,_)}Zn.applyMatrix4(n),Kn.applyMatrix4(n),Zn.multiplyScalar(1/Zn.w),Kn.multiplyScalar(1/Kn.w),Zn.x*=s.x/2,Zn.y*=s.y/2,Kn.x*=s.x/2,Kn.y*=s.y/2,Jn.start.copy(Zn),Jn.start.z=0,Jn.end.copy(Kn),Jn.end.z=0;let y=Jn.closestPointToPointParameter(Am,!0);Jn.at(y,sb);let g=yr.lerp(Zn.z,Kn.z,y),m=g>=-1&&g<=1,x=Am.distanceTo(sb)<mo*.5;if(m&&x){Jn.start.fromBufferAttribute(l,f),Jn.end.fromBufferAttribute(c,f),Jn.start.applyMatrix4(o),Jn.end.applyMatrix4(o);let w=new z,_=new z;kr.distanceSqToSegment(Jn.start,Jn.end,_,w),e.push({point:_,pointOnLine:w,distance:kr.origin.distanceTo(_),object:r,face:null,faceIndex:f,uv:null,uv1:null})}}}var sf=class extends We{constructor(t=new Ea,e=new ks({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,i=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)ib.fromBufferAttribute(e,o),rb.fromBufferAttribute(n,o),i[a]=a===0?0:i[a-1],i[a+1]=i[a]+ib.distanceTo(rb);let s=new Is(i,2,1);return t.setAttribute("instanceDistanceStart",new Ki(s,1,0)),t.setAttribute("instanceDistanceEnd",new Ki(s,1,1)),this}raycast(t,e){let n=this.material.worldUnits,i=t.camera;if(i===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let s=t.params.Line2!==void 0&&t.params.Line2.threshold||0;kr=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;mo=l.linewidth+s,a.boundingSphere===null&&a.computeBoundingSphere(),rf.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=mo*.5;else{let h=Math.max(i.near,rf.distanceToPoint(kr.origin));c=ob(i,h,l.resolution)}if(rf.radius+=c,kr.intersectsSphere(rf)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),nf.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=mo*.5;else{let h=Math.max(i.near,nf.distanceToPoint(kr.origin));u=ob(i,h,l.resolution)}nf.expandByScalar(u),kr.intersectsBox(nf)!==!1&&(n?I3(this,e):L3(this,i,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(Sm),this.material.uniforms.resolution.value.set(Sm.z,Sm.w))}};var go=class extends Ea{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,n=new Float32Array(2*e);for(let i=0;i<e;i+=3)n[2*i]=t[i],n[2*i+1]=t[i+1],n[2*i+2]=t[i+2],n[2*i+3]=t[i+3],n[2*i+4]=t[i+4],n[2*i+5]=t[i+5];return super.setPositions(n),this}setColors(t){let e=t.length-3,n=new Float32Array(2*e);for(let i=0;i<e;i+=3)n[2*i]=t[i],n[2*i+1]=t[i+1],n[2*i+2]=t[i+2],n[2*i+3]=t[i+3],n[2*i+4]=t[i+4],n[2*i+5]=t[i+5];return super.setColors(n),this}setFromPoints(t){let e=t.length-1,n=new Float32Array(6*e);for(let i=0;i<e;i++)n[6*i]=t[i].x,n[6*i+1]=t[i].y,n[6*i+2]=t[i].z||0,n[6*i+3]=t[i+1].x,n[6*i+4]=t[i+1].y,n[6*i+5]=t[i+1].z||0;return super.setPositions(n),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var of=class extends sf{constructor(t=new go,e=new ks({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var lb=new z(0,1,0),af=class{group=new Vn;past;rest;length=0;constructor(t,e,n){this.past=new of(new go,new ks({color:e,linewidth:2.5}));let i=new Cl({color:e,transparent:!0,opacity:.7,dashSize:n,gapSize:n});this.rest=new xa(new hn,i),this.past.frustumCulled=this.rest.frustumCulled=!1,this.group.add(this.past,this.rest),this.lay(t)}lay(t){this.length=t.length/3,this.rest.geometry.dispose(),this.past.geometry.dispose(),this.past.geometry=new go;let e=new Float32Array(this.length);for(let n=1;n<e.length;n++)e[n]=e[n-1]+Math.hypot(t[3*n]-t[3*n-3],t[3*n+1]-t[3*n-2],t[3*n+2]-t[3*n-1]);this.rest.geometry.setAttribute("position",new un(t,3)),this.rest.geometry.setAttribute("lineDistance",new un(e,1)),this.past.visible=this.length>1,this.past.visible&&this.past.geometry.setPositions(t)}seek(t){this.past.geometry.instanceCount=Math.min(t,this.length-1),this.rest.geometry.setDrawRange(t,this.length-t)}dispose(){[this.past.geometry,this.past.material,this.rest.geometry,this.rest.material].forEach(t=>t.dispose()),this.group.removeFromParent()}},lf=class{constructor(t,e,n){this.wide=e;this.scale=n;let i=new ga({color:t}),s=new Lr(e,e,1,12).translate(0,.5,0),o=new Sl(2.6*e,6*e,16).translate(0,-3*e,0);[this.shaft,this.head]=[new We(s,i),new We(o,i)],this.parts=[i,s,o],this.group.add(this.shaft,this.head)}wide;scale;group=new Vn;shaft;head;parts;way=new z;turn=new Hn;point(t,e){let n=this.way.fromArray(t).length(),i=n*this.scale;this.group.visible=i>.5*this.wide,this.group.visible&&(this.group.position.fromArray(e),this.group.quaternion.copy(this.turn.setFromUnitVectors(lb,this.way.divideScalar(n))),this.shaft.scale.set(1,Math.max(i-5*this.wide,1e-6),1),this.head.position.y=i)}dispose(){this.parts.forEach(t=>t.dispose()),this.group.removeFromParent()}};function cb(r,t,e,n){let i=new oo({color:n,transparent:!0,opacity:.28,side:Qi,depthWrite:!1});return new We(Tm(r,t,e),i)}var Ql=24;function Tm(r,t,e){let n=[];for(let u=0;u+2<t.length;u+=3)n.push(new z(t[u],t[u+1],t[u+2]));let[i,s,o]=F3(r,n,e),a=n.map(s),[l,c]=[0,1].map(u=>{let h=a.map(f=>f[u]);return[h.reduce((f,d)=>Math.min(f,d),1/0)-o[u],h.reduce((f,d)=>Math.max(f,d),-1/0)+o[u]]});return N3(i,l,c)}function F3(r,t,e){if(r.kind==="plane"){let f=new z(...r.position),[d,p]=ab(new z(...r.normal).normalize());return[(g,m)=>f.clone().addScaledVector(d,g).addScaledVector(p,m),g=>[g.clone().sub(f).dot(d),g.clone().sub(f).dot(p)],[3*e,3*e]]}let n=new z(...r.center),i=r.kind==="cylinder"?new z(...r.axis).normalize():new z(0,0,1),s=t.reduce((f,d)=>f.add(d),new z).divideScalar(Math.max(t.length,1)).sub(n),o=s.addScaledVector(i,-s.dot(i));o.length()<1e-6*r.radius&&o.copy(ab(i)[0]),o.normalize();let a=new z().crossVectors(i,o),{radius:l}=r,c=r.kind==="ball";return[(f,d)=>{let p=c?l*Math.cos(d):l;return n.clone().addScaledVector(o,p*Math.cos(f)).addScaledVector(a,p*Math.sin(f)).addScaledVector(i,c?l*Math.sin(d):d)},f=>{let d=f.clone().sub(n),p=d.dot(i);return[Math.atan2(d.dot(a),d.dot(o)),c?Math.asin(Math.max(-1,Math.min(1,p/(d.length()||1)))):p]},[e/l,c?e/l:e]]}function ab(r){let t=new z().crossVectors(Math.abs(r.z)<.9?new z(0,0,1):lb,r).normalize();return[t,new z().crossVectors(r,t)]}function N3(r,t,e,n=Ql){let i=[],s=[];for(let a=0;a<=n;a++)for(let l=0;l<=n;l++){i.push(...r(t[0]+(t[1]-t[0])*a/n,e[0]+(e[1]-e[0])*l/n).toArray());let c=a*(n+1)+l;a<n&&l<n&&s.push(c,c+1,c+n+1,c+1,c+n+2,c+n+1)}let o=new hn;return o.setAttribute("position",new un(Float32Array.from(i),3)),o.setIndex(s),o.computeVertexNormals(),o}var as=4;function ub(r,t,e){let{cell:n,reach:i,floor:s}=t,o=n*Math.ceil(1.6*i/n),{context:a}=r;for(let l of[!1,!0]){a.beginPath();for(let c=-o;c<=o+n/2;c+=n)Math.abs(c)<n/2===l&&(r.piece([c,-o,s],0,[c,o,s],0,!0),r.piece([-o,c,s],0,[o,c,s],0,!0));r.stroke(l?e.gridStrong:e.grid,1)}}function hb(r,t,e,n){let i=t.length/3;r.path(t,0,Math.min(e+1,i)),r.stroke(n,2.5),r.context.setLineDash([4,4]),r.path(t,3*e,i-e),r.stroke(n,1.2,.8,"butt"),r.context.setLineDash([])}function fb(r,t,e,n,i){let s=[0,1,2].map(y=>e[y]+n*t[y]),[o,a]=[r.at(e,0),r.at(s,0)];if(o===null||a===null)return;let[l,c]=[a[0]-o[0],a[1]-o[1]],u=Math.hypot(l,c);if(u<3)return;let h=Math.min(12,.5*u),[f,d]=[l/u,c/u],p=[a[0]-h*f,a[1]-h*d];r.context.beginPath(),r.context.moveTo(...o),r.context.lineTo(...p),r.stroke(i,4,1,"butt"),r.fill([a,[p[0]-.45*h*d,p[1]+.45*h*f],[p[0]+.45*h*d,p[1]-.45*h*f]],i)}var cf=class{constructor(t,e,n){this.color=n;let i=Tm(t.surface,t.at.data,.12*e.reach);this.places=Float32Array.from(i.getAttribute("position").array)}color;places;draw(t){for(let e=0;e<Ql;e+=as)for(let n=0;n<Ql;n+=as)this.square(t,e,n)}square(t,e,n){let i=(o,a)=>t.at(this.places,3*((e+o)*(Ql+1)+n+a)),s=[];for(let o=0;o<4*as;o++){let[a,l]=[Math.floor(o/as),o%as],[c,u]=[[0,l],[l,as],[as,as-l],[as-l,0]][a],h=i(c,u);if(h===null)return;s.push(h)}t.fill(s,this.color,.16),t.context.closePath(),t.stroke(this.color,1,.35)}};var uf=class{constructor(t){this.camera=t;let e=this.canvas.getContext("2d");if(e===null)throw new Error("This browser draws on no canvas.");this.context=e,e.lineJoin="round"}camera;canvas=document.createElement("canvas");context;aside=0;width=1;height=1;view=new Float64Array(16);from=new Float64Array(3);to=new Float64Array(3);focal=1;near=.001;resize(t,e){if(t<1||e<1)return;let n=Math.min(Math.max(window.devicePixelRatio,1),2);[this.width,this.height]=[t,e],[this.canvas.width,this.canvas.height]=[Math.round(n*t),Math.round(n*e)],this.camera.aspect=t/e,this.camera.updateProjectionMatrix()}begin(t){let{camera:e,canvas:n,context:i}=this;e.updateMatrixWorld(),this.view.set(e.matrixWorldInverse.elements),this.focal=this.height/2/Math.tan(e.fov*Math.PI/360),this.near=.001*t,i.setTransform(n.width/this.width,0,0,n.height/this.height,0,0),i.clearRect(0,0,this.width,this.height),i.lineJoin="round"}depth(t,e){return-this.seen(2,t,e)}perMeter(t){return this.focal/Math.max(t,this.near)}at(t,e){let n=this.depth(t,e);return n<this.near?null:this.pixel(this.seen(0,t,e),this.seen(1,t,e),n)}path(t,e,n){this.context.beginPath();for(let i=1;i<n;i++)this.piece(t,e+3*i-3,t,e+3*i,i===1)}piece(t,e,n,i,s){let{from:o,to:a,near:l,context:c}=this;for(let f=0;f<3;f++)[o[f],a[f]]=[this.seen(f,t,e),this.seen(f,n,i)];let[u,h]=[-o[2]<l,-a[2]<l];if(!(u&&h)){if(u||h){let f=(-l-o[2])/(a[2]-o[2]),d=u?o:a;for(let p=0;p<3;p++)d[p]=this.seen(p,t,e)+f*(this.seen(p,n,i)-this.seen(p,t,e))}(s||u)&&c.moveTo(...this.pixel(o[0],o[1],-o[2])),c.lineTo(...this.pixel(a[0],a[1],-a[2]))}}stroke(t,e,n=1,i="round"){let{context:s}=this;s.globalAlpha=n,s.strokeStyle=t,s.lineWidth=e,s.lineCap=i,s.stroke(),s.globalAlpha=1}dot(t,e,n,i,s,o=2){let a=this.at(t,e);if(a===null)return;let l=Math.max(n*this.perMeter(this.depth(t,e)),o);this.context.beginPath(),this.context.arc(...a,l,0,2*Math.PI),this.context.fillStyle=i,this.context.fill(),this.stroke(s,1)}fill(t,e,n=1){let{context:i}=this;i.beginPath(),t.forEach(s=>i.lineTo(...s)),i.closePath(),i.globalAlpha=n,i.fillStyle=e,i.fill(),i.globalAlpha=1}pixel(t,e,n){let i=this.focal/n;return[this.width/2+i*t,this.height/2-i*e]}seen(t,e,n){let{view:i}=this;return i[t]*e[n]+i[4+t]*(e[n+1]+this.aside)+i[8+t]*e[n+2]+i[12+t]}};var D3={runs:["#0072b2","#d55e00","#00875f","#a2488f","#8c6a00","#2a7fb8"],link:"#9aa5b1",joint:"#4a5562",gear:"#c76a00",base:"#39434e",payload:"#2b333c",grid:"#c3cad1",gridStrong:"#8e99a4",surface:"#009e73",force:"#b3261e",reference:"#d55e00",rigid:"#6b7681",before:"#7a4ea3",real:"#0072b2",sky:"#ffffff",ground:"#b9c0c8"},U3={runs:["#4fb0ea","#ff8f45","#3ecf9b","#e08acb","#d9b13a","#9fd3f5"],link:"#8b96a3",joint:"#a9b4c0",gear:"#e69f00",base:"#6d7986",payload:"#cfd6dd",grid:"#39424c",gridStrong:"#5c6874",surface:"#2fbf95",force:"#ff7b70",reference:"#ff8c42",rigid:"#a3adb7",before:"#c79be8",real:"#56b4e9",sky:"#ffffff",ground:"#5a6570"};function db(r){return r?U3:D3}var pb="440154 481a6c 472f7d 414487 39568c 31688e 2a788e 23888e 1f988b 22a884 35b779 54c568 7ad151 a5db36 d2e21b fde725",tc=256,Br=O3();function O3(){let r=pb.split(" ").map(e=>[0,2,4].map(n=>parseInt(e.slice(n,n+2),16)/255)),t=new Float32Array(3*tc);for(let e=0;e<tc;e++){let n=e/(tc-1)*(r.length-1),i=Math.min(Math.floor(n),r.length-2);for(let s=0;s<3;s++)t[3*e+s]=r[i][s]+(n-i)*(r[i+1][s]-r[i][s])}return t}function Ta(r){return 3*Math.max(0,Math.min(tc-1,Math.round(r*(tc-1))))}function mb(){return`linear-gradient(to top, ${pb.split(" ").map(r=>`#${r}`).join(", ")})`}function gb(r,t=Math.PI/3){let e=r.index?r.toNonIndexed():r,n=e.attributes.position,i=n.count,s;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)s=n.array;else{s=new Float64Array(i*3);for(let _=0;_<i;_++)s[3*_+0]=n.getX(_),s[3*_+1]=n.getY(_),s[3*_+2]=n.getZ(_)}let o=Math.cos(t),a=(1+1e-10)*100,l=i/3,c=new Float64Array(l*3);for(let _=0;_<l;_++){let E=9*_,S=s[E+0],v=s[E+1],b=s[E+2],N=s[E+3],C=s[E+4],I=s[E+5],U=s[E+6],B=s[E+7],F=s[E+8],V=U-N,q=B-C,G=F-I,rt=S-N,$=v-C,j=b-I,tt=q*j-G*$,ut=G*rt-V*j,ct=V*$-q*rt,J=1/(Math.sqrt(tt*tt+ut*ut+ct*ct)||1);c[3*_+0]=tt*J,c[3*_+1]=ut*J,c[3*_+2]=ct*J}let u=new Int32Array(i),h=new Float64Array(i*3),f=1;for(;f<i*2;)f<<=1;let d=f-1,p=new Int32Array(f),y=0;for(let _=0;_<i;_++){let E=3*_,S=Math.trunc(s[E+0]*a),v=Math.trunc(s[E+1]*a),b=Math.trunc(s[E+2]*a),N=(Math.imul(S,73856093)^Math.imul(v,19349663)^Math.imul(b,83492791))&d;for(;;){let C=p[N];if(C===0){let U=3*y;h[U+0]=S,h[U+1]=v,h[U+2]=b,p[N]=y+1,u[_]=y++;break}let I=3*(C-1);if(h[I+0]===S&&h[I+1]===v&&h[I+2]===b){u[_]=C-1;break}N=N+1&d}}let g=new Int32Array(y+1);for(let _=0;_<i;_++)g[u[_]+1]++;for(let _=0;_<y;_++)g[_+1]+=g[_];let m=new Int32Array(i),x=g.slice(0,y);for(let _=0;_<l;_++){let E=3*_;m[x[u[E+0]]++]=_,m[x[u[E+1]]++]=_,m[x[u[E+2]]++]=_}let w=new Float32Array(i*3);for(let _=0;_<l;_++){let E=3*_,S=c[E+0],v=c[E+1],b=c[E+2];for(let N=0;N<3;N++){let C=E+N,I=u[C],U=0,B=0,F=0;for(let q=g[I],G=g[I+1];q<G;q++){let rt=3*m[q],$=c[rt+0],j=c[rt+1],tt=c[rt+2];S*$+v*j+b*tt>o&&(U+=$,B+=j,F+=tt)}let V=1/(Math.sqrt(U*U+B*B+F*F)||1);w[3*C+0]=U*V,w[3*C+1]=B*V,w[3*C+2]=F*V}}return e.setAttribute("normal",new un(w,3,!1)),e}var yb=[[1,1],[-1,1],[-1,-1],[1,-1]];function k3(r){let t=new Float32Array(2*(r+1));for(let e=0;e<=r;e++)t[2*e]=Math.cos(2*Math.PI*e/r),t[2*e+1]=Math.sin(2*Math.PI*e/r);return{points:t,normals:t}}function B3(){let r=[],t=[];return yb.forEach((e,n)=>{let i=yb[(n+1)%4];r.push(...e,...i);for(let s=0;s<2;s++)t.push((e[0]+i[0])/2,(e[1]+i[1])/2)}),{points:Float32Array.from(r),normals:Float32Array.from(t)}}var hf=class{constructor(t,e,n){this.stations=t;this.section=e;this.outline=e.shape==="round"?k3(n):B3(),this.around=this.outline.points.length/2;let i=(t+2)*this.around;[this.position,this.normal,this.colour]=[0,1,2].map(()=>new Float32Array(3*i)),this.colour.fill(1),["position","normal","color"].forEach((s,o)=>{let a=new un([this.position,this.normal,this.colour][o],3);this.geometry.setAttribute(s,a.setUsage(em))}),this.geometry.setIndex(this.faces())}stations;section;geometry=new hn;outline;around;position;normal;colour;axes=new Float32Array(9);shape(t,e,n,i){let{stations:s,axes:o}=this;Rm(o,n,i);for(let a=0;a<s;a++){let l=e+3*Math.max(a-1,0),c=e+3*Math.min(a+1,s-1);Cm(o,t[c]-t[l],t[c+1]-t[l+1],t[c+2]-t[l+2]),this.ring(a,a,t,e+3*a,0),a===0&&this.ring(s,a,t,e,-1),a===s-1&&this.ring(s+1,a,t,e+3*a,1)}this.geometry.attributes.position.needsUpdate=!0,this.geometry.attributes.normal.needsUpdate=!0}paint(t,e,n,i){let{around:s,colour:o,stations:a}=this,l=i>n?i-n:1;for(let c=0;c<a+2;c++){let u=c<a?c:c===a?0:a-1,h=Ta((t[e+u]-n)/l);for(let f=3*c*s;f<3*(c+1)*s;f+=3)o[f]=Br[h],o[f+1]=Br[h+1],o[f+2]=Br[h+2]}this.geometry.attributes.color.needsUpdate=!0}dispose(){this.geometry.dispose()}ring(t,e,n,i,s){let{axes:o,around:a,position:l,normal:c,section:u,outline:h}=this,f=u.sizes[2*e],d=u.sizes[2*e+1];for(let p=0;p<a;p++){let y=f*h.points[2*p],g=d*h.points[2*p+1],m=h.normals[2*p],x=h.normals[2*p+1];for(let w=0;w<3;w++){let _=3*(t*a+p)+w;l[_]=n[i+w]+y*o[3+w]+g*o[6+w],c[_]=s===0?m*o[3+w]+x*o[6+w]:s*o[w]}}}faces(){let{around:t,stations:e}=this,n=[];for(let i=0;i<e-1;i++)for(let s=0;s<t-1;s++){let o=i*t+s;n.push(o,o+t,o+1,o+1,o+t,o+t+1)}for(let i=1;i<t-1;i++){let s=e*t,o=s+t;n.push(s,s+i,s+i+1,o,o+i+1,o+i)}for(let i=0;i<n.length;i+=3)[n[i+1],n[i+2]]=[n[i+2],n[i+1]];return n}};function Rm(r,t,e){let n=t[e],i=t[e+1],s=t[e+2],o=t[e+3];r[0]=1-2*(i*i+s*s),r[1]=2*(n*i+s*o),r[2]=2*(n*s-i*o),r[3]=2*(n*i-s*o),r[4]=1-2*(n*n+s*s),r[5]=2*(i*s+n*o),r[6]=2*(n*s+i*o),r[7]=2*(i*s-n*o),r[8]=1-2*(n*n+i*i)}function Cm(r,t,e,n){let i=Math.hypot(t,e,n);if(i===0)return;let s=t/i,o=e/i,a=n/i,l=r[1]*a-r[2]*o,c=r[2]*s-r[0]*a,u=r[0]*o-r[1]*s,h=1+r[0]*s+r[1]*o+r[2]*a,f=h>1e-9?1/h:0;for(let d=3;d<9;d+=3){let p=c*r[d+2]-u*r[d+1],y=u*r[d]-l*r[d+2],g=l*r[d+1]-c*r[d];r[d]+=p+f*(c*g-u*y),r[d+1]+=y+f*(u*p-l*g),r[d+2]+=g+f*(l*y-c*p)}r[0]=s,r[1]=o,r[2]=a}var xb=new z(0,1,0),z3=.6,yo=class{constructor(t,e,n,i){this.look=n;this.widths=i;let s=this.material(n.link,!1),o=n.painted==="none"?s:this.material("#ffffff",!0),a=new Set(t.meshes.map(c=>c.link));if(this.sweeps=t.links.map((c,u)=>{if(u>=e.links||!c.bends&&a.has(u))return null;let h=new hf(e.stations,Im(c,e.stations,i),n.fine?24:10);return this.add(new We(h.geometry,c.bends||n.painted==="all"?o:s)),h}),t.meshes.filter(({link:c})=>c<e.links).forEach(c=>this.surface(c,t.links)),n.opacity<1)return;t.joints.filter(({link:c})=>c<e.links).forEach(c=>this.housing(c,t.links[c.link],a.has(c.link))),t.links.slice(0,e.links).forEach((c,u)=>this.holder(c,u,e,a));let l=new Al((a.size>0?.5:1.5)*i.usual,24,16);this.payload=this.add(new We(this.kept(l),this.material(n.payload,!1)))}look;widths;group=new Vn;sweeps;placed=[];tinted=[];rods=[];pedestals=[];payload=null;trash=[];from=new z;to=new z;quaternion=new Hn;update(t,e,n,i){let{stations:s,roots:o,values:a}=t,l=3*s;this.sweeps.forEach((c,u)=>{c?.shape(e,u*l,o,4*u),this.look.painted!=="none"&&c?.paint(a,u*s,n,i)});for(let{object:c,link:u,turn:h}of this.placed)u<0||(c.position.fromArray(e,u*l),c.quaternion.fromArray(o,4*u),h&&c.quaternion.multiply(h));for(let{material:c,link:u}of this.tinted){let h=Ta((a[(u+1)*s-1]-n)/(i-n||1));c.color.setRGB(Br[h],Br[h+1],Br[h+2])}for(let c of this.rods)this.between(c.object,e,c.place,c.link*l);for(let{object:c,link:u}of this.pedestals)this.stand(c,e,u*l);this.payload?.position.copy(this.from.fromArray(t.tip))}dispose(){this.sweeps.forEach(t=>t?.dispose()),this.trash.forEach(t=>t.dispose()),this.group.removeFromParent()}material(t,e){let{opacity:n,fine:i}=this.look,s={polygonOffset:n<1,polygonOffsetFactor:2,polygonOffsetUnits:2},o={transparent:n<1,opacity:n,depthWrite:n>=1,...s},a={color:t,vertexColors:e,...o};return this.kept(i?new Rl({...a,roughness:.5,metalness:.1}):new oo(a))}kept(t){return this.trash.push(t),t}add(t){return t.frustumCulled=!1,t.castShadow=t.receiveShadow=this.look.opacity>=1,this.group.add(t),t}housing(t,e,n){if(e===void 0||n||t.kind==="fixed")return;let i=1.5*this.widths.usual,s=t.kind==="revolute"?new Lr(i,i,2.2*i,this.look.fine?32:14):new Ts(2*i,2.2*i,2*i),o=this.add(new We(this.kept(s),this.material(t.elastic?this.look.gear:this.look.joint,!1))),a=new z(...t.axis).normalize();this.placed.push({object:o,link:t.link,turn:new Hn().setFromUnitVectors(xb,a)})}surface(t,e){if(e[t.link]?.bends)return;let n=new hn;n.setAttribute("position",new un(Float32Array.from(t.vertices.data),3)),n.setIndex(new un(Uint32Array.from(t.faces.data),1));let i=this.kept(gb(n,z3)),s=this.material(this.look.opacity<1?this.look.link:t.colour,!1);this.placed.push({object:this.add(new We(i,s)),link:t.link,turn:null}),this.look.painted==="all"&&t.link>=0&&this.tinted.push({material:s,link:t.link})}holder(t,e,n,i){if(t.parent<0){if(i.has(-1)||i.has(e))return;let c=new Lr(1.8*this.widths.usual,3*this.widths.usual,1,32);this.pedestals.push({object:this.add(new We(this.kept(c),this.material(this.look.base,!1))),link:e});return}let{place:s,away:o}=Pm(n,t.parent,e);if(o<.5*this.widths.usual||i.has(e)&&i.has(t.parent))return;let a=new Lr(.8*this.widths.usual,.8*this.widths.usual,1,16),l=this.add(new We(this.kept(a),this.material(this.look.link,!1)));this.rods.push({object:l,link:e,parent:t.parent,place:s})}between(t,e,n,i){this.from.fromArray(e,n),this.to.fromArray(e,i).sub(this.from);let s=this.to.length();t.position.copy(this.from).addScaledVector(this.to,.5),t.scale.set(1,Math.max(s,1e-9),1),s>0&&t.quaternion.copy(this.quaternion.setFromUnitVectors(xb,this.to.divideScalar(s)))}stand(t,e,n){let i=Math.max(e[n+2]-this.widths.floor,1e-4);t.position.set(e[n],e[n+1],this.widths.floor+i/2),t.scale.set(1,i,1),t.rotation.set(Math.PI/2,0,0)}};function Pm({arrays:r,stations:t},e,n){let{data:i}=r.line,s=3*t*n,o={place:0,away:1/0};for(let a=0;a<t;a++){let l=3*(t*e+a),c=Math.hypot(i[l]-i[s],i[l+1]-i[s+1],i[l+2]-i[s+2]);c<o.away&&(o={place:l,away:c})}return o}function Im(r,t,e){let n=new Float32Array(2*t).fill(e.usual);if(r.section===null)return{shape:"round",sizes:n};let i=r.section.sizes,s=i.shape[0]-1;for(let o=0;o<t;o++)for(let a=0;a<2;a++){let l=Math.round(o/Math.max(t-1,1)*s);n[2*o+a]=Math.max(i.data[2*l+a],e.least)}return{shape:r.section.shape,sizes:n}}var V3=.6,xo=class{constructor(t,e,n){this.body=t;this.motion=e;this.widths=n;this.sections=t.links.slice(0,e.links).map(i=>Im(i,e.stations,n)),t.links.slice(0,e.links).forEach(({parent:i},s)=>{if(i<0)return;let{place:o,away:a}=Pm(e,i,s);a>=.5*n.usual&&this.rods.push({link:s,place:o})})}body;motion;widths;sections;rods=[];axes=new Float32Array(9);pair=new Float32Array(6);draw(t,e,n,i,s){let{motion:o,widths:a}=this,l=3*o.stations,c=this.body.links.slice(0,o.links).flatMap((h,f)=>[{depth:this.far(t,e,f),draw:()=>this.link(t,e,f,h,n,i,s)},...h.parent<0?[{depth:t.depth(e,f*l)+a.usual,draw:()=>this.stand(t,e,f*l,n)}]:[]]);c.push(...this.rods.map(({link:h,place:f})=>this.rod(t,e,h*l,f,n)));for(let{link:h,kind:f,elastic:d}of this.body.joints){if(h>=o.links||f==="fixed")continue;let p=()=>t.dot(e,h*l,1.5*a.usual,d?n.gear:n.joint,n.base);c.push({depth:t.depth(e,h*l)-2*a.usual,draw:p})}let u=()=>t.dot(o.tip,0,1.5*a.usual,n.payload,n.base);c.push({depth:t.depth(o.tip,0)-2*a.usual,draw:u}),c.sort((h,f)=>f.depth-h.depth).forEach(h=>h.draw())}ghost(t,e,n,i){let{motion:s,sections:o}=this,{stations:a}=s;for(let l=0;l<s.links;l++){let c=3*a*l,u=Math.max(...o[l].sizes);t.path(e,c,a),t.stroke(n,Math.max(1.6*u*t.perMeter(t.depth(e,c)),2),i)}}link(t,e,n,i,s,o,a){let{motion:l}=this,{stations:c,values:u}=l,h=3*c*n,f=s.painted==="all"||s.painted==="bending"&&i.bends,d=this.seenWidths(t,e,n,a);for(let g=1;g<c;g++)t.path(e,h+3*g-3,2),t.stroke(s.base,d[g]+2,1,g===1||g===c-1?"round":"butt");let p=o.low,y=o.high-p||1;for(let g=1;g<c;g++){let m=(u[n*c+g-1]+u[n*c+g])/2;this.stretch(t,e,h+3*g),t.stroke(f?H3((m-p)/y):s.link,d[g],1,"butt")}}stretch(t,e,n){let{pair:i}=this,s=Math.hypot(e[n]-e[n-3],e[n+1]-e[n-2],e[n+2]-e[n-1]),o=s>0?V3/t.perMeter(t.depth(e,n))/s:0;for(let a=0;a<3;a++){let l=o*(e[n+a]-e[n-3+a]);i[a]=e[n-3+a]-l,i[3+a]=e[n+a]+l}t.path(i,0,2)}seenWidths(t,e,n,i){let{axes:s,motion:o}=this,{stations:a,roots:l}=o,{shape:c,sizes:u}=this.sections[n],h=new Float32Array(a);Rm(s,l,4*n);for(let f=1;f<a;f++){let d=3*(a*n+f);Cm(s,e[d]-e[d-3],e[d+1]-e[d-2],e[d+2]-e[d-1]);let[p,y,g]=G3(s,i.x-e[d],i.y-e[d+1]-t.aside,i.z-e[d+2]),m=u[2*f]*Math.abs(p*s[3]+y*s[4]+g*s[5]),x=u[2*f+1]*Math.abs(p*s[6]+y*s[7]+g*s[8]),w=c==="round"?Math.hypot(m,x):m+x;h[f]=Math.max(2*Math.max(w,this.widths.least)*t.perMeter(t.depth(e,d)),2.5)}return h}far(t,e,n){let{stations:i}=this.motion;return t.depth(e,3*(i*n+(i>>1)))}rod(t,e,n,i,s){let o=t.depth(e,n)+this.widths.usual;return{depth:o,draw:()=>{t.context.beginPath(),t.piece(e,i,e,n,!0),t.stroke(s.base,1.6*this.widths.usual*t.perMeter(o)+2),t.stroke(s.link,1.6*this.widths.usual*t.perMeter(o))}}}stand(t,e,n,i){let{usual:s,floor:o}=this.widths,a=[e[n],e[n+1],o],[l,c]=[t.at(e,n),t.at(a,0)];if(l===null||c===null)return;let[u,h]=[1.8*s*t.perMeter(t.depth(e,n)),3*s*t.perMeter(t.depth(a,0))],f=Math.hypot(c[0]-l[0],c[1]-l[1]);if(f>1){let[d,p]=[(c[1]-l[1])/f,(l[0]-c[0])/f],y=(g,m)=>[g[0]+m*d,g[1]+m*p];t.fill([y(l,u),y(c,h),y(c,-h),y(l,-u)],i.base)}t.dot(e,n,1.8*s,i.base,i.base)}};function G3(r,t,e,n){let i=[r[1]*n-r[2]*e,r[2]*t-r[0]*n,r[0]*e-r[1]*t],s=Math.hypot(...i)||1;return[i[0]/s,i[1]/s,i[2]/s]}function H3(r){let t=Ta(r);return`rgb(${[0,1,2].map(e=>Math.round(255*Br[t+e])).join(" ")})`}function ff(r,t,e,n){for(let i=0;4*i<r.length&&n>1;i++){let s=3*n*i,o=t[s+3]-t[s],a=t[s+4]-t[s+1],l=t[s+5]-t[s+2],c=e[s+3]-e[s],u=e[s+4]-e[s+1],h=e[s+5]-e[s+2],f=Math.hypot(o,a,l)*Math.hypot(c,u,h);f>0&&W3(r,4*i,a*h-l*u,l*c-o*h,o*u-a*c,f+o*c+a*u+l*h)}}function W3(r,t,e,n,i,s){let o=Math.hypot(e,n,i,s);if(o===0)return;let a=r[t]/o,l=r[t+1]/o,c=r[t+2]/o,u=r[t+3]/o;r[t]=s*a+e*u+n*c-i*l,r[t+1]=s*l-e*c+n*u+i*a,r[t+2]=s*c+e*l-n*a+i*u,r[t+3]=s*u-e*a-n*l-i*c}var Bs=class{constructor(t){this.arrays=t;[this.frames,this.links,this.stations]=t.line.shape;let e=this.links*this.stations*3;this.line=new Float32Array(e),this.once=new Float32Array(e),this.planned=new Float32Array(e),this.rigid=t.rigid?new Float32Array(e):null,this.reference=t.reference?new Float32Array(e):null,this.roots=new Float32Array(this.links*4),this.values=new Float32Array(this.links*this.stations),this.tipPlace=this.nearestEnd()}arrays;links;stations;frames;line;rigid;reference;roots;values;tip=new Float32Array(3);tipReference=new Float32Array(3);force=new Float32Array(3);at=new Float32Array(3);frame=0;share=0;tipPlace;once;planned;seek(t,e,n){this.find(t);let{arrays:i}=this;this.mix(this.line,i.line),this.rigid&&i.rigid&&this.mix(this.rigid,i.rigid),this.reference&&i.reference&&this.mix(this.reference,i.reference),this.turn(),this.mix(this.tip,i.tip),i.tipReference&&this.mix(this.tipReference,i.tipReference),i.contact&&(this.mix(this.force,i.contact.force),this.mix(this.at,i.contact.at)),n&&this.mix(this.values,n),!(e===1||!this.rigid)&&(i.referenceRigid&&this.mix(this.planned,i.referenceRigid),this.enlarge(e,this.rigid,i.referenceRigid?this.planned:this.rigid))}path(t,e){let{arrays:n,frames:i}=this,s=t?n.tipReference:n.tip,o=t?n.reference:n.line,a=t&&n.referenceRigid||n.rigid;if(s===null)return null;let l=Float32Array.from(s.data);if(!a||!o||this.links===0)return l;let c=this.links*this.stations*3;for(let u=0;u<i;u++)for(let h=0;h<3;h++){let f=u*c+this.tipPlace+h;l[3*u+h]+=(e-1)*(o.data[f]-a.data[f])}return l}find(t){let e=this.arrays.times.data,n=0,i=this.frames-1;for(;i-n>1;){let o=n+i>>1;e[o]<=t?n=o:i=o}this.frame=n;let s=i>n?e[i]-e[n]:0;this.share=s>0?Math.min(1,Math.max(0,(t-e[n])/s)):0}mix(t,e){let n=t.length,i=this.frame*n,s=Math.min(this.frame+1,this.frames-1)*n,{data:o}=e;for(let a=0;a<n;a++){let l=o[i+a];t[a]=l+this.share*(o[s+a]-l)}}turn(){let{roots:t}=this;this.mix(t,this.arrays.roots);for(let e=0;e<t.length;e+=4){let n=Math.hypot(t[e],t[e+1],t[e+2],t[e+3])||1;for(let i=0;i<4;i++)t[e+i]/=n}}enlarge(t,e,n){let{line:i,reference:s,tipPlace:o}=this;for(let a=0;a<3&&this.links>0;a++){let l=(t-1)*(i[o+a]-e[o+a]);this.tip[a]+=l,this.at[a]+=l,s&&(this.tipReference[a]+=(t-1)*(s[o+a]-n[o+a]))}this.once.set(i);for(let a=0;a<i.length;a++)i[a]=e[a]+t*(i[a]-e[a]),s&&(s[a]=n[a]+t*(s[a]-n[a]));ff(this.roots,this.once,i,this.stations)}nearestEnd(){let{line:t,tip:e}=this.arrays,n=0,i=1/0;for(let s=0;s<this.links;s++){let o=(s*this.stations+this.stations-1)*3,a=Math.hypot(...[0,1,2].map(l=>t.data[o+l]-e.data[l]));a<=i&&([n,i]=[o,a])}return n}};var pf=1.6,ec=class{constructor(t,e,n){this.mode=t;this.size=n;let[i,s]=t.rest.shape,o={data:t.rest.data,shape:[1,i,s,3]},a={data:e.roots.data.slice(0,4*i),shape:[1,i,4]},l=t.rest.data.slice(3*(i*s-1),3*i*s);this.motion=new Bs({times:{data:Float64Array.of(0),shape:[1]},line:o,rigid:o,reference:null,roots:a,tip:{data:l,shape:[1,3]},tipReference:null,colours:[],contact:null}),this.motion.seek(0,1,null),this.roots=this.motion.roots.slice()}mode;size;motion;roots;swing(t){let{mode:e,motion:n,size:i}=this,s=i*Math.cos(t),o=i*Math.sin(t),{line:a,values:l}=n;for(let c=0;c<l.length;c++){let u=0;for(let h=3*c;h<3*c+3;h++){let f=s*e.real.data[h]-o*e.imaginary.data[h];a[h]=e.rest.data[h]+f,u+=f*f}l[c]=Math.sqrt(u)/i}for(let c=0;c<3;c++)n.tip[c]=a[a.length-3+c];n.roots.set(this.roots),ff(n.roots,e.rest.data,a,n.stations)}},df=class{group=new Vn;swinging;robot;rest;constructor(t,e,n,i){let{colours:s,extent:o,fine:a}=i;this.swinging=new ec(t,e,n*o.reach);let{motion:l}=this.swinging,{link:c,joint:u,gear:h,base:f,payload:d,rigid:p}=s,y={link:c,joint:u,gear:h,base:f,payload:d,opacity:1,painted:"all",fine:a},g={...y,link:p,opacity:.35,painted:"none"};this.robot=new yo(e,l,y,o),this.rest=new yo(e,l,g,{...o,usual:.8*o.usual}),this.group.add(this.robot.group,this.rest.group),this.rest.update(l,l.line,0,1)}swing(t){let{motion:e}=this.swinging;this.swinging.swing(t),this.robot.update(e,e.line,0,1)}dispose(){this.robot.dispose(),this.rest.dispose(),this.group.removeFromParent()}};var Ra=class{constructor(t,e,n,i){this.run=t;this.index=e;this.alone=n;this.own=i;this.motion=new Bs(t.scene)}run;index;alone;own;motion;showsSurface=!0;aside=0;before=null;get colour(){return this.alone?this.own.real:this.own.runs[this.index%this.own.runs.length]}get referenceColour(){return this.alone?this.own.reference:this.own.rigid}get changed(){return this.before!==null}replace(t){let{scene:e}=this.run,n=new Bs(t??e);this.before=t===null?null:this.before??new Bs(e),this.motion=n}seek(t,e){let{motion:n}=this,i=n.arrays.colours.find(({id:s})=>s===e.colour)?.values??null;n.seek(t,e.factor,i),this.before?.seek(t,e.factor,null)}widen(t,e){let{arrays:n,links:i,stations:s}=this.motion,o=n.colours.find(l=>l.id===t)?.values.data,a=this.run.scene.links.map(l=>l.bends||nc(t)==="all");if(o!==void 0)for(let l=0;l<o.length;l++)a[Math.floor(l/s)%i]&&(o[l]<e.low&&(e.low=o[l]),o[l]>e.high&&(e.high=o[l]))}};function nc(r){return r==="run"?"none":r==="displacement"?"all":"bending"}var q3=10;function mf(r,t){let e=0;for(let{scene:n}of r){let i=n.contact?.force.data??[];for(let s=0;s+2<i.length;s+=3)e=Math.max(e,Math.hypot(i[s],i[s+1],i[s+2]))}return r.every(({scene:n})=>n.contact===null)?0:Jl(.35*t/(e||q3))}var Ca=class{constructor(t,e,n,i){this.canvas=t;this.runs=n;this.given=i;let{page:s,extent:o,ask:a}=i;this.scale=mf(s.runs,o.reach),this.cameras=new Qh(e,t,o.reach,a),t.tabIndex=0,t.setAttribute("role","img");let l="Arrow keys turn the view, with Shift they move it, + and - zoom.";t.setAttribute("aria-label",`The robot in space: ${s.runs.map(({name:c})=>c).join(", ")}. ${l}`),t.title=`Drag to turn, right button to move, click and wheel to zoom. ${l}`}canvas;runs;given;cameras;scale;range={low:0,high:1};shown=null;replace(t,e){this.runs[t]?.replace(e)}showMode(t,e){this.shown=t}refresh(){let{runs:t}=this,{settings:e,extent:n}=this.given,i={low:1/0,high:-1/0};t.forEach(c=>c.widen(e.colour,i)),this.range=i.low<=i.high?i:{low:0,high:0};let{box:s,reach:o}=n,a=e.apart?Math.max(.4*o,s.max.y-s.min.y+.15*o):0,l=t.map(({run:c})=>JSON.stringify(c.scene.contact?.surface));t.forEach((c,u)=>{c.aside=(u-(t.length-1)/2)*a,c.showsSurface=e.apart||l.indexOf(l[u])===u}),this.cameras.box.copy(s).expandByVector(new z(0,(t.length-1)/2*a,0))}look(t,e){this.cameras.show(t,this.runs[0].motion.tip,e)}takeView(t){this.cameras.take(t.cameras)}tell(t){let{settings:e,extent:n}=this.given,{shown:i}=this,s=this.runs.flatMap(({run:a})=>a.scene.colours).find(({id:a})=>a===e.colour);t.list(i?this.modeEntries(i):this.entries(),!i&&this.forceShown()),i?t.range({label:"Displacement, share of the largest",unit:"",low:0,high:1}):t.range(s?{label:s.label,unit:s.unit,...this.range}:null),t.enlarged(e.factor===1||i?"":`Deformation × ${e.factor}`);let o=n.floor===0?"":`, at z = ${Dr(n.floor)} m`;t.flat(""),t.floor(e.floor?`Grid ${Dr(n.cell)} m${o}${this.thick()}`:"")}words(){if(!this.forceShown())return"";let t=n=>Dr(Math.hypot(...n));return`Contact force ${this.runs.filter(({run:n})=>n.scene.contact).map(({motion:n})=>`${t(n.force)} N`).join(", ")} (arrow: ${Dr(.1/this.scale)} N per 0.1 m)`}dispose(){this.cameras.dispose(),this.canvas.remove()}forceShown(){return this.given.settings.force&&this.scale>0}entries(){let{runs:t}=this,{settings:e,colours:n}=this.given,i=t.length===1,s=[];i?e.traces&&s.push({colour:n.real,label:"Path of the tip"}):s.push(...t.map(l=>({colour:l.colour,label:l.run.name})));let o=l=>e[l]&&t.some(({run:c})=>c.scene[l]),a=e.traces&&t.some(({run:l})=>l.scene.tipReference);return o("reference")?s.push({colour:t[0].referenceColour,label:"Reference"}):a&&s.push({colour:t[0].referenceColour,label:"Path of the reference"}),o("rigid")&&s.push({colour:n.rigid,label:"Without any elasticity"}),t.some(({changed:l})=>l)&&s.push({colour:n.before,label:"The run as it was"}),s}modeEntries(t){let e=`damping ${Dr(100*t.damping)} %`,n=`motors ${t.case}; slowed, not to scale`,i=`Mode ${Dr(t.frequency)} Hz, ${e}, ${t.livesIn}; ${n}`;return[{colour:this.given.colours.rigid,label:"At rest"},{colour:"transparent",label:i}]}thick(){let{least:t}=this.given.extent,e=this.runs.flatMap(({run:s})=>s.scene.links.map(({section:o})=>o)),n=e.some(s=>s&&Math.min(...s.sizes.data)<t),i=tf("m",2*t);return n?`; links are drawn at least ${Dr(2*t*i.factor)} ${i.name} thick`:e.some(s=>s?.guessed)?"; thickness of links by their stiffness and mass":""}};var gf=.42,Lm=class extends Ra{constructor(e,n,i,s,o){super(e,n,i,s);this.colours=s;this.extent=o;this.robot=new xo(e.scene,this.motion,o),this.surface=this.touched()}colours;extent;robot;was=null;surface;paths=[];traced=0;replace(e){super.replace(e),this.robot=new xo(this.run.scene,this.motion,this.extent),this.was=this.before&&new xo(this.run.scene,this.before,this.extent),this.surface=this.touched(),this.traced=0}touched(){let{contact:e}=this.run.scene;if(e===null)return null;let{surface:n,at:i}={...e,...this.motion.arrays.contact};return new cf({surface:n??e.surface,at:i},this.extent,this.colours.surface)}draw({pen:e,camera:n,scale:i,colours:s},o,a,l){let{motion:c,before:u}=this;e.aside=this.aside,this.seek(o,a),this.trace(a.factor),a.surface&&this.showsSurface&&this.surface?.draw(e),this.was&&u&&this.was.ghost(e,u.line,s.before,gf),a.rigid&&c.rigid&&this.robot.ghost(e,c.rigid,s.rigid,gf),a.reference&&c.reference&&this.robot.ghost(e,c.reference,this.referenceColour,gf),a.traces&&this.paths.forEach(({path:h,color:f})=>hb(e,h,c.frame,f)),this.robot.draw(e,c.line,this.look(a),l,n.position),a.force&&c.arrays.contact&&fb(e,c.force,c.at,i,s.force),e.aside=0}look(e){let n=nc(e.colour);return{..._b(this.colours,this.alone?null:this.colour,n==="none"?this.colour:this.colours.link),painted:n}}trace(e){if(e===this.traced)return;this.traced=e;let[n,i]=[this.motion.path(!1,e),this.motion.path(!0,e)];this.paths=[],i&&this.paths.push({path:i,color:this.referenceColour}),n&&this.paths.push({path:n,color:this.colour})}};function _b({joint:r,gear:t,base:e,payload:n},i,s){return{link:s,joint:i??r,gear:i??t,base:e,payload:i??n,opacity:1,painted:"all",fine:!1}}var yf=class extends Ca{constructor(e,n){let{page:i,extent:s,colours:o}=e,a=new $n(32,1,.01*s.reach,100*s.reach);a.up.set(0,0,1);let l=new uf(a);super(l.canvas,a,i.runs.map((c,u)=>new Lm(c,u,i.runs.length===1,o,s)),e);this.wanted=n;this.sheet={pen:l,camera:a,extent:s,colours:o,scale:this.scale},this.refresh()}wanted;sheet;mode=null;draw(e,n){let{sheet:i,runs:s}=this,{settings:o,extent:a,colours:l}=this.given;this.mode||this.cameras.follow(s[0].motion.tip),i.pen.begin(a.reach),o.floor&&ub(i.pen,a,l),this.mode?this.swing(2*Math.PI*n/pf):this.sorted().forEach(c=>c.draw(i,e,o,this.range))}showMode(e,n){super.showMode(e,n);let{scene:i}=this.runs[0].run,s=e&&new ec(e,i,n*this.given.extent.reach);this.mode=s&&{swinging:s,robot:new xo(i,s.motion,this.given.extent)}}resize(e,n){this.sheet.pen.resize(e,n)}tell(e){super.tell(e);let i=this.runs.some(({run:s})=>s.scene.meshes.length>0)?"; the surfaces of the parts (meshes) are left out":"";e.flat(`Drawn in lines${this.wanted?"":", without WebGL"}${i}`)}sorted(){let{pen:e}=this.sheet,n=i=>e.depth([0,i.aside,0],0);return[...this.runs].sort((i,s)=>n(s)-n(i))}swing(e){if(!this.mode)return;let{swinging:n,robot:i}=this.mode,{pen:s,camera:o,colours:a}=this.sheet;i.ghost(s,Float32Array.from(n.motion.arrays.line.data),a.rigid,gf),n.swing(e),i.draw(s,n.motion.line,_b(a,null,a.link),{low:0,high:1},o.position)}};var vb=5,xf=class{legend=ic("scene-legend");scale=ic("scene-scale");factor=ic("scene-factor");grid=ic("scene-grid");way=ic("scene-flat");live=De("span");shown="";constructor(t){let e=De("div",{className:"scene-below"},this.way,this.grid);t.append(this.legend,this.scale,De("div",{className:"scene-foot"},e,this.factor))}list(t,e){this.legend.replaceChildren(...t.map(({colour:n,label:i})=>De("span",{},bb(n),i))),e&&this.legend.append(this.live),this.legend.hidden=t.length===0&&!e}tell(t){t!==this.shown&&(this.shown=t,this.live.textContent=t)}range(t){if(this.scale.hidden=t===null,t===null)return;let e=tf(t.unit,t.high),n=Math.abs(t.low)<1e-6*Math.abs(t.high)?0:t.low,i=Array.from({length:vb},(l,c)=>t.high+(n-t.high)*c/(vb-1)),s=bb(mb()),o=e.name.replaceAll(" "," "),a=De("b",{},o?`${t.label} [${o}]`:t.label);this.scale.replaceChildren(a,De("ol",{},...i.map(l=>De("li",{},Dr(e.factor*l)))),s)}enlarged(t){this.factor.hidden=t==="",this.factor.textContent=t}flat(t){this.way.hidden=t==="",this.way.textContent=t}floor(t){this.grid.hidden=t==="",this.grid.textContent=t}};function ic(r){return De("div",{className:`scene-note ${r}`,hidden:!0})}function bb(r){let t=De("i",{ariaHidden:"true"});return t.style.background=r,t}function Fm(){let r=document.createElement("canvas").getContext("webgl2");if(r===null)return null;let t=r.getExtension("WEBGL_debug_renderer_info"),e=String(r.getParameter(t?t.UNMASKED_RENDERER_WEBGL:r.RENDERER));return r.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)?"low":"high"}var _f=class{constructor(t,e){this.quality=t;this.extent=e;let n=t==="high";this.renderer=new Yh({canvas:this.canvas,antialias:n,alpha:!0,powerPreference:"low-power"}),this.renderer.setPixelRatio(n?Math.min(window.devicePixelRatio,2):.75*Math.min(window.devicePixelRatio,1)),this.renderer.shadowMap.enabled=n,this.renderer.shadowMap.type=lo,this.camera.up.set(0,0,1),this.camera.near=.01*e.reach,this.camera.far=100*e.reach,this.scene.add(this.floor)}quality;extent;canvas=document.createElement("canvas");scene=new yl;camera=new $n(32,1,.01,100);renderer;floor=new Vn;light=new Dl("#ffffff",2.2);dress(t){let{extent:e,light:n}=this;this.undress();let i=e.cell*2*Math.ceil(1.6*e.reach/e.cell),s=new ao(i,Math.round(i/e.cell),t.gridStrong,t.grid);s.rotation.x=Math.PI/2,s.position.z=e.floor,this.floor.add(s,new Ll(t.sky,t.ground,1.6),n,n.target);let o=e.box.getCenter(n.target.position);n.position.set(o.x-.6*e.reach,o.y-1.1*e.reach,o.z+2.2*e.reach),this.quality==="high"&&this.shadows(i)}get floorShown(){return this.floor.children[0]?.visible??!1}set floorShown(t){this.floor.children.forEach(e=>{(e instanceof ao||e instanceof We)&&(e.visible=t)})}resize(t,e){t<1||e<1||(this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix())}draw(){this.renderer.render(this.scene,this.camera)}dispose(){this.undress(),this.light.dispose(),this.renderer.dispose(),this.renderer.getContext().isContextLost()||this.renderer.forceContextLoss(),this.canvas.remove()}shadows(t){let{light:e,extent:n}=this;e.castShadow=!0,e.shadow.mapSize.set(2048,2048),e.shadow.normalBias=.2*n.usual;let{camera:i}=e.shadow;i.left=i.bottom=-1.4*n.reach,i.right=i.top=1.4*n.reach,i.near=.1*n.reach,i.far=6*n.reach;let s=new We(new so(t,t),new Tl({opacity:.22,depthWrite:!1}));s.position.z=n.floor,s.receiveShadow=!0,this.floor.add(s)}undress(){for(let t of[...this.floor.children])t instanceof ao?t.dispose():t instanceof We&&(t.geometry.dispose(),t.material.dispose());this.floor.clear()}};var X3=`
.scene { --ink: #1d2329; --soft: #4d5863; --chip: rgba(255, 255, 255, 0.82); --line: #c6ccd3; --field: #ffffff;
  --sky: #f4f7fa; --earth: #e3e8ed; --strong: #005a8f;
  container-type: inline-size; display: flex; flex-direction: column; min-width: 0; min-height: 0; height: 100%;
  color: var(--ink);
  font: 13px/1.35 system-ui, sans-serif; }
@media (prefers-color-scheme: dark) { .scene { --ink: #e8ecf0; --soft: #b3bdc7; --chip: rgba(20, 25, 31, 0.8);
  --line: #46515c; --field: #1b2127; --sky: #1b222a; --earth: #12171d; --strong: #7cc4f2; } }
.scene-bar { display: flex; flex-wrap: wrap; align-items: center; gap: 4px 12px; padding: 6px 8px; }
.scene-bar label { display: inline-flex; align-items: center; gap: 6px; white-space: nowrap; }
.scene-bar select, .scene-bar button, .scene-bar summary { font: inherit; color: inherit; background: var(--field);
  border: 1px solid var(--line); border-radius: 5px; padding: 3px 8px; min-height: 28px; cursor: pointer; }
.scene-bar select { max-width: 12.5em; text-overflow: ellipsis; }
.scene-bar summary { list-style: none; display: inline-flex; align-items: center; }
.scene-bar summary::after { content: " ▾"; white-space: pre; }
.scene-bar input[type=range] { width: 104px; accent-color: var(--strong); }
.scene-bar output { min-width: 2.6em; font-variant-numeric: tabular-nums; }
.scene :focus-visible { outline: 2px solid var(--strong); outline-offset: 1px; }
.scene details { position: relative; }
.scene-more { position: absolute; z-index: 3; top: calc(100% + 4px); right: 0; display: grid; gap: 4px;
  padding: 8px 10px; background: var(--field); border: 1px solid var(--line); border-radius: 6px;
  box-shadow: 0 4px 14px rgba(0, 0, 0, 0.2); }
.scene-view { position: relative; flex: 1 1 auto; min-height: 220px; overflow: hidden; border-radius: 6px;
  background: linear-gradient(var(--sky), var(--earth)); }
.scene-view canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; touch-action: none; }
.scene-note { position: absolute; pointer-events: none; background: var(--chip); border-radius: 5px; padding: 4px 8px; }
.scene-note[hidden] { display: none; }
.scene-legend { top: 8px; left: 8px; display: grid; gap: 2px; max-width: 46%; }
.scene-legend span { display: flex; align-items: center; gap: 6px; }
.scene-legend i { flex: none; width: 16px; height: 8px; border-radius: 2px; }
.scene-scale { top: 8px; right: 8px; display: grid; grid-template-columns: auto 12px; gap: 4px 6px; max-width: 40%; }
.scene-scale b { grid-column: 1 / 3; font-weight: 600; text-align: right; max-width: 15em; }
.scene-scale ol { list-style: none; margin: 0; padding: 0; display: flex; flex-direction: column;
  justify-content: space-between;
  height: 110px; text-align: right; font-variant-numeric: tabular-nums; line-height: 1; }
.scene-scale i { border-radius: 2px; }
.scene-foot { position: absolute; inset: auto 8px 8px; display: flex; align-items: flex-end; gap: 8px;
  pointer-events: none; }
.scene-foot .scene-note { position: static; }
.scene-below { display: flex; flex-direction: column; align-items: flex-start; gap: 4px; min-width: 0;
  color: var(--soft); }
.scene-factor { flex: none; margin-left: auto; font-weight: 600; }
.scene-message { position: absolute; inset: 0; display: grid; place-content: center; padding: 2em; text-align: center; }
@container (max-width: 760px) {
  .scene-bar { gap: 4px 8px; }
  .scene-bar label { gap: 4px; }
  .scene-bar select { max-width: 11.5em; padding: 3px 4px; }
  .scene-bar .scene-name { display: none; }
}
@container (max-width: 520px) {
  .scene-bar { padding: 4px 6px; gap: 4px 6px; }
  .scene-bar select { flex: 1 1 5em; min-width: 0; }
  .scene-bar label:has(> select) { flex: 1 1 5em; min-width: 0; }
  .scene-bar > details { order: 1; }
  .scene-bar > .scene-factor-row { order: 2; flex: 1 1 60%; }
  .scene-bar > button { order: 3; }
  .scene-bar input[type=range] { flex: 1 1 64px; min-width: 64px; }
  .scene-view { min-height: 300px; }
  .scene-note { font-size: 11px; padding: 2px 5px; }
  .scene-legend { max-width: 58%; }
  .scene-legend i { width: 10px; }
  .scene-scale b { max-width: 9em; }
  .scene-scale ol { height: 64px; }
  .scene-scale li:nth-child(even) { display: none; }
}
@media (pointer: coarse), (max-width: 40rem) {
  .scene-bar select, .scene-bar button, .scene-bar summary { min-height: 40px; min-width: 40px; }
  .scene-more label { min-height: 40px; }
  .scene-more input { width: 20px; height: 20px; }
}
@media print { .scene-bar { display: none; } }
`,vf=null;function wb(){vf===null&&(vf=new CSSStyleSheet,vf.replaceSync(X3),document.adoptedStyleSheets=[...document.adoptedStyleSheets,vf])}var bf=class extends Ra{constructor(e,n,i,s){super(e,n,i,s.colours);this.shared=s}shared;group=new Vn;robot;look;ghosts=new Map;traces=[];arrow=null;surface=null;built="";traced="";replace(e){let n=String(this.motion.arrays.line.shape.slice(1));super.replace(e),String(this.motion.arrays.line.shape.slice(1))!==n&&(this.built=""),this.traced="",this.built!==""&&this.placeSurface()}update(e,n,i){let{motion:s}=this;this.build(n),this.seek(e,n),this.robot.update(s,s.line,i.low,i.high),this.haunt("reference",s,n.reference?s.reference:null),this.haunt("rigid",s,n.rigid?s.rigid:null),this.haunt("before",this.before??s,this.before?.line??null),this.draw(n)}dispose(){this.clear(),this.group.removeFromParent()}build(e){let n=nc(e.colour);if(n===this.built)return;this.clear(),this.built=n;let{scene:i}=this.run,{extent:s,colours:o,fine:a}=this.shared,l=n==="none"?this.colour:o.link,c=this.alone?o.joint:this.colour,u={link:l,joint:c,gear:this.alone?o.gear:c,base:o.base,payload:c,opacity:1,painted:n,fine:a};this.robot=this.added(i,this.motion,u,1),this.look=u,i.contact&&(this.arrow=new lf(o.force,.006*s.reach,this.shared.scale),this.group.add(this.arrow.group),this.placeSurface())}placeSurface(){let{contact:e}=this.run.scene;if(!e)return;let{extent:n,colours:i}=this.shared,{surface:s,at:o}={...e,...this.motion.arrays.contact};this.dropSurface(),this.surface=cb(s??e.surface,o.data,.12*n.reach,i.surface),this.group.add(this.surface)}dropSurface(){this.surface&&(this.surface.geometry.dispose(),this.surface.material.dispose(),this.surface.removeFromParent(),this.surface=null)}haunt(e,n,i){let s=this.ghosts.get(e);if(s&&(s.group.visible=i!==null),i===null)return;(s??this.ghost(e,n)).update(n,i,0,1)}ghost(e,n){let{colours:i}=this.shared,s={reference:this.referenceColour,rigid:i.rigid,before:i.before}[e],o=this.added(this.run.scene,n,{...this.look,link:s,opacity:.42,painted:"none"},.85);return this.ghosts.set(e,o),o}added(e,n,i,s){let{extent:o}=this.shared,a={usual:s*o.usual,least:s*o.least,floor:o.floor},l=new yo(s<1?$3(e,s):e,n,i,a);return this.group.add(l.group),l}draw(e){this.trace(e);for(let{trace:n,reference:i}of this.traces)n.group.visible=e.traces&&(!i||this.motion.arrays.tipReference!==null),n.seek(this.motion.frame);this.surface&&(this.surface.visible=e.surface&&this.showsSurface),this.arrow&&(this.arrow.point(this.motion.force,this.motion.at),this.arrow.group.visible&&=e.force&&this.motion.arrays.contact!==null)}trace(e){let n=`${e.factor}`;if(n===this.traced)return;let i=this.traces.length===0;this.traced=n;for(let s of[!1,!0]){let o=this.motion.path(s,e.factor),a=this.traces.find(l=>l.reference===s);if(o!==null){if(a)a.trace.lay(o);else if(i){let l=s?this.referenceColour:this.colour,c=new af(o,l,.012*this.shared.extent.reach);this.traces.push({trace:c,reference:s}),this.group.add(c.group)}}}}clear(){this.robot?.dispose(),this.ghosts.forEach(e=>e.dispose()),this.traces.forEach(({trace:e})=>e.dispose()),this.arrow?.dispose(),this.dropSurface(),this.ghosts.clear(),this.traces=[],this.traced=this.built=""}};function $3(r,t){let e=r.links.map(n=>{if(n.section===null)return n;let{data:i,shape:s}=n.section.sizes;return{...n,section:{...n.section,sizes:{data:Float32Array.from(i,o=>t*o),shape:s}}}});return{...r,links:e}}var wf=class extends Ca{stage;shared;mode=null;constructor(t,e){let{page:n,extent:i,colours:s}=t,o=new _f(e,i),a={extent:i,colours:s,fine:e==="high",scale:mf(n.runs,i.reach)},l=n.runs.map((c,u)=>new bf(c,u,n.runs.length===1,a));super(o.canvas,o.camera,l,t),this.stage=o,this.shared=a,o.dress(s),l.forEach(({group:c})=>o.scene.add(c)),this.refresh()}draw(t,e){let{settings:n}=this.given;this.mode?this.mode.swing(2*Math.PI*e/pf):this.runs.forEach(i=>i.update(t,n,this.range)),this.mode||this.cameras.follow(this.runs[0].motion.tip),this.stage.draw()}showMode(t,e){super.showMode(t,e),this.mode?.dispose(),this.mode=t&&new df(t,this.runs[0].run.scene,e,this.shared),this.mode&&this.stage.scene.add(this.mode.group),this.runs.forEach(({group:n})=>n.visible=t===null)}refresh(){super.refresh(),this.runs.forEach(({group:t,aside:e})=>t.position.set(0,e,0)),this.stage.floorShown=this.given.settings.floor}resize(t,e){this.stage.resize(t,e)}dispose(){this.mode?.dispose(),this.runs.forEach(t=>t.dispose()),super.dispose(),this.stage.dispose()}};var Y3=2e3;function Mb(r,t,e){wb();let n=De("div",{className:"scene"}),i=De("div",{className:"scene-view"});return r.append(n),new Nm(n,i,t,e,Fm())}var Nm=class{constructor(t,e,n,i,s){this.frame=t;this.view=e;this.page=n;this.clock=i;this.best=s;let{runs:o}=n,a=o.length>1;this.settings={colour:a?"run":o[0].scene.colours[0]?.id??"run",factor:1,reference:!a,rigid:!1,traces:!0,force:!0,surface:!0,floor:!0,apart:!1,quality:"auto"},this.replaced=o.map(()=>null),this.extent=eb(n),this.notes=new xf(e),t.append(this.controls(),e),this.world=this.made(),this.ends.push(i.subscribe(this.ask));let l=new ResizeObserver(()=>this.resize());l.observe(e),this.dark.addEventListener("change",this.remake),this.ends.push(()=>l.disconnect(),()=>this.dark.removeEventListener("change",this.remake)),this.resize(),this.refresh(),this.world.look("iso",!1)}frame;view;page;clock;best;settings;notes;replaced;ends=[];dark=window.matchMedia("(prefers-color-scheme: dark)");still=window.matchMedia("(prefers-reduced-motion: reduce)");extent;world;waiting=0;mode=null;asked=0;replace(t,e){this.replaced[t]=e,this.world.replace(t,e),this.refresh()}showMode(t,e){this.mode=t===null?null:{mode:t,amplitude:e},this.world.showMode(t,e),this.refresh()}resize(){this.world.resize(this.view.clientWidth,this.view.clientHeight),this.ask()}dispose(){cancelAnimationFrame(this.asked),window.clearTimeout(this.waiting),this.ends.forEach(t=>t()),this.world.canvas.removeEventListener("webglcontextlost",this.lost),this.world.dispose(),this.frame.remove()}controls(){let{runs:t}=this.page,n=[...new Map(t.flatMap(({scene:a})=>a.colours.map(({id:l,label:c})=>[l,c]))),["run",t.length>1?"each robot its own":"none"]],i=a=>t.some(({scene:l})=>a(l)),o=[["reference",i(a=>a.reference)],["rigid",i(a=>a.rigid)],["traces",!0],["force",i(a=>a.contact)],["surface",i(a=>a.contact)],["floor",!0],["apart",t.length>1]].filter(([,a])=>a).map(([a])=>a);return tb(this.settings,n,o,i(a=>a.rigid),this.best!==null,{changed:()=>this.refresh(),look:a=>this.world.look(a,!this.still.matches),quality:()=>{this.best??=Fm(),this.remake()}})}made(){let{page:t,extent:e,settings:n,ask:i}=this,s={page:t,extent:e,colours:db(this.dark.matches),settings:n,ask:i},{quality:o}=n,a=o==="lines"?null:this.best&&(o==="auto"?this.best:o),l=(a&&j3(s,a))??new yf(s,o==="lines");return l.canvas.addEventListener("webglcontextlost",this.lost),l.canvas.addEventListener("webglcontextrestored",this.found),this.view.prepend(l.canvas),l}lost=t=>{t.target===this.world.canvas&&(window.clearTimeout(this.waiting),this.waiting=window.setTimeout(()=>{this.best=null,this.remake()},Y3))};found=()=>{window.clearTimeout(this.waiting),this.ask()};remake=()=>{let t=this.world;this.world=this.made(),this.world.takeView(t),t.dispose(),this.replaced.forEach((e,n)=>e&&this.world.replace(n,e)),this.mode&&this.world.showMode(this.mode.mode,this.mode.amplitude),this.resize(),this.refresh()};refresh(){this.world.refresh(),this.world.tell(this.notes),this.ask()}ask=()=>{this.asked===0&&(this.asked=requestAnimationFrame(this.draw))};draw=t=>{this.asked=0,this.world.draw(this.clock.time,this.still.matches?0:t/1e3),this.notes.tell(this.world.words()),this.mode&&!this.still.matches&&this.ask()}};function j3(r,t){try{return new wf(r,t)}catch{return null}}function Ab(r,t){let e=Math.max(...t.runs.map(S=>S.duration)),n=ig(e),i=lt("div",{class:"scene"}),s=lt("div",{class:"facts-panel",role:"region",tabindex:"0","aria-label":"Numbers that matter"}),o=lt("div",{class:"sliders-panel",role:"region",tabindex:"0","aria-label":"Settings"}),a=lt("div",{class:"side"},o,s),l=lt("div",{class:"transport",role:"group","aria-label":"Time"}),c=lt("section",{class:"charts","aria-label":"Charts"}),u=t.runs.length>1?` of ${t.runs[0].name}`:"",h=Sb(`Elastic line${u}`,t.runs[0].line!==null),f=Sb(`Modes of vibration${u}`,t.runs[0].modes.length>0),d=lt("div",{class:"bar files"});r.classList.add("app"),r.append(lt("div",{class:"stage"},i,a),l,c,lt("div",{class:"lower"},h.element,f.element),d);let p=Mb(i,t,n),y=[p,Jx(l,n)],g=zx(s,t),m=ny(c,t,n),x=t.runs[0].line?Hx(h.body,t,n):null,w=t.runs[0].modes.length?Jd(f.body,t,p,n):null;$x(d,t),l.hidden=c.hidden=t.runs.every(S=>S.charts.length===0);let _=null;function E(S){n.setDuration(Math.max(S?S.times[S.times.length-1]:0,e)),S?.scene!==_?.scene&&(p.replace(0,S&&S.scene),x?.show(S)),m.show(S),g.show(S),w?.show(S),_=S}return t.live?y.push(Zx(o,t.live,{open:Bx,show:E,fileName:`${Qd(t.runs[0].name)}_changed`})):t.notLive&&o.append(lt("p",{class:"note",text:`Nothing can be changed in this page: ${t.notLive}.`})),{clock:n,side:o,scene:p,show:E,showModes(S){w?.dispose(),f.body.replaceChildren(),f.element.hidden=S.length===0;let[v,...b]=t.runs;w=S.length?Jd(f.body,{...t,runs:[{...v,modes:S},...b]},p,n):null},dispose(){n.pause(),w?.dispose(),[...y,m,...x?[x]:[]].forEach(S=>S.dispose()),r.replaceChildren()}}}function Sb(r,t){let e=lt("div",{});return{element:lt("section",{class:"panel",hidden:!t,"aria-label":r},lt("h3",{text:r}),e),body:e}}function Eb(r){let t=document.documentElement,e=[];addEventListener("beforeprint",()=>{t.classList.add("printing");let n=[...document.querySelectorAll(r)].filter(i=>!i.open);for(let i of n)i.open=!0;e=[...e,...n]}),addEventListener("afterprint",()=>{t.classList.remove("printing");for(let n of e)n.open=!1;e=[]})}async function Z3(){let r=document.getElementById("tmodes-data"),t=document.getElementById("tmodes-app");if(!(r===null||t===null))try{let e=eg(await ng(r.textContent??""));Ab(t,e),document.documentElement.classList.add("running")}catch(e){let n=e instanceof Error?e.message:String(e);t.replaceChildren(lt("p",{class:"status warning",role:"alert",text:`The interactive part of this page could not start: ${n}. The whole report without it follows.`}))}}Eb("details");Z3();})();
