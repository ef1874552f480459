/* tmodes, built from ae71048c9872ea3b; BSD-3-Clause */
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
"use strict";(()=>{function lt(i,t={},...e){let n=document.createElement(i);for(let[r,s]of Object.entries(t))r==="text"?n.textContent=String(s):s!==void 0&&s!==!1&&n.setAttribute(r,s===!0?"":s);return n.append(...e.filter(r=>r!==null)),n}function bn(i,t,e={}){let n=lt("button",{type:"button",text:i,...e});return n.addEventListener("click",t),n}function wn(i,t){i.textContent!==t&&(i.textContent=t)}function zl(i,t,e=2){let n="http://www.w3.org/2000/svg",r=document.createElementNS(n,"svg"),s=document.createElementNS(n,"line"),o={x1:0,y1:5,x2:26,y2:5,"stroke-width":e,"stroke-dasharray":t.join(" ")};for(let[a,l]of Object.entries(o))s.setAttribute(a,String(l));s.style.stroke=i;for(let[a,l]of Object.entries({width:26,height:10,"aria-hidden":"true"}))r.setAttribute(a,String(l));return r.append(s),r}var _m=0;function Pr(i){return _m+=1,`tm-${i}-${_m}`}function uo(i,t,e){let n=URL.createObjectURL(new Blob([i],{type:e}));lt("a",{href:n,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}var Jv="TMPK";function vm(i){if(new TextDecoder().decode(i.subarray(0,4))!==Jv)throw new Error("these bytes are no data of tmodes");let e=new DataView(i.buffer,i.byteOffset,i.byteLength).getUint32(4,!0),n=JSON.parse(new TextDecoder().decode(i.subarray(8,8+e))),r=8*Math.ceil((8+e)/8),s=n.arrays.map(o=>Kv(i,r,o));return Vl(n.page,s)}function Kv(i,t,e){let n=e.shape.reduce((o,a)=>o*a,1),r=Number(e.dtype[1]),s=i.slice(t+e.offset,t+e.offset+n*r).buffer;return e.dtype==="f8"?{data:new Float64Array(s),shape:e.shape}:e.dtype==="d4"?{data:tb(new Uint8Array(s),n,e),shape:e.shape}:e.dtype==="i4"?{data:new Int32Array(s),shape:e.shape}:e.dtype==="u1"?{data:new Uint8Array(s),shape:e.shape}:{data:Qv(new Uint8Array(s),n,e),shape:e.shape}}function Qv(i,t,{shape:e,scale:n=1,start:r=0}){let s=t/(e[0]||1)||1,o=new Int16Array(t);for(let a=0;a<t;a++)o[a]=(i[a]|i[t+a]<<8)+(a>=s?o[a-s]:0);return Float32Array.from(o,a=>r+n*a)}function tb(i,t,{shape:e}){let n=t/(e[0]||1)||1,r=new Uint32Array(t);for(let s=0;s<t;s++){let o=i[s]|i[t+s]<<8|i[2*t+s]<<16|i[3*t+s]<<24;r[s]=o+(s>=n?r[s-n]:0)}return new Float32Array(r.buffer)}function Vl(i,t){if(Array.isArray(i))return i.map(n=>Vl(n,t));if(i===null||typeof i!="object")return i;let e=Object.entries(i);return e.length===1&&e[0][0]==="$array"?t[e[0][1]]:e.length===1&&e[0][0]==="$sum"?eb(Vl(e[0][1],t)):Object.fromEntries(e.map(([n,r])=>[n,Vl(r,t)]))}function eb([i,t]){return{data:Float32Array.from(i.data,(e,n)=>e+t.data[n]),shape:i.shape}}async function bm(i){let t=Uint8Array.from(atob(i.trim()),n=>n.charCodeAt(0)),e=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(e).arrayBuffer())}function wm(i){let t=new Set,e=0,n=0,r=()=>t.forEach(l=>l(a)),s={time:0,duration:i,playing:!1},o=l=>{let c=Math.min(.25,(l-n)/1e3);n=l,s.time+=c*a.speed,s.time>=s.duration&&(s.time=0),r(),s.playing&&(e=requestAnimationFrame(o))},a={get time(){return s.time},get duration(){return s.duration},get playing(){return s.playing},speed:1,seek(l){s.time=Math.min(Math.max(l,0),s.duration),r()},play(){s.playing||(s.playing=!0,n=performance.now(),e=requestAnimationFrame(o),r())},pause(){s.playing=!1,cancelAnimationFrame(e),r()},toggle(){s.playing?a.pause():a.play()},setDuration(l){s.duration=l,a.seek(s.time)},subscribe(l){return t.add(l),()=>t.delete(l)}};return a}var nb=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],ib=["m","rad","s"],rb=["Hz","%","rad/s"],sb="⁰¹²³⁴⁵⁶⁷⁸⁹";function rf(i){let t=i.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(t)?"":t}function $e(i,t=4){return i===0?"0":String(Number(i.toPrecision(t)))}function Mm(i){if(i===0)return"0";let[t,e]=i.toExponential(1).split("e"),n=[...String(Number(e))].map(r=>r==="-"?"⁻":sb[Number(r)]).join("");return`${t} × 10${n}`}function ba(i,t){let e=rf(i);if(!e||rb.includes(i)||!(t>0))return{factor:1,name:e};let n=ib.includes(i.split("/")[0]),r=nb.find(([s,o])=>t>=s&&(o>=1||!n));return r?{factor:r[1],name:r[2]+e}:{factor:1,name:e}}function $n(i,t){if(i===null||!Number.isFinite(i))return"–";let e=Math.abs(i),{factor:n,name:r}=ba(t,e);return`${e>0&&(n===1?e<.001:e<1e-11)?Mm(i):$e(i*n)} ${r}`.trimEnd()}function ni(i){let t=Math.abs(i);return t!==0&&(t<.001||t>=1e6)?Mm(i):$e(i)}var Sm=["--blue","--red","--green","--violet","--ochre","--sky"],ob={real:"--blue",reference:"--red",rigid:"--quiet",stationary:"--green",oscillatory:"--violet",limit:"--quiet",other:"--ochre"},Am={real:[],reference:[6,3],rigid:[2,3],stationary:[9,2,2,2],oscillatory:[2,2],limit:[1,3],other:[10,3]},Em=[[],[7,2],[6,2,2,2],[2,2],[9,2,2,2,2,2],[12,4]],ho={real:"actual",reference:"nominal",rigid:"rigid",stationary:"quasi-static part",oscillatory:"oscillatory part",limit:"limit",other:"other"};function wa(i,t,e,n){if(!e)return{property:ob[i],dash:Am[i]};let r=n>1?Am[i]:Em[t%Em.length];return{property:Sm[t%Sm.length],dash:r}}var sf=new Map,Tm=null,Rm=!1;function Ci(i){Tm??=matchMedia("(prefers-color-scheme: dark)");let t=Tm.matches&&!document.documentElement.classList.contains("printing");t!==Rm&&sf.clear(),Rm=t;let e=sf.get(i)??getComputedStyle(document.documentElement).getPropertyValue(i).trim();return sf.set(i,e),e||"#808080"}function Cm(i,t,e,n){let[r,s]=n??e.span??[i[0],i[i.length-1]],o=1e-9*Math.max(1,Math.abs(s)),a=ab(i,Array.from(i.keys()).filter(p=>i[p]>=r-o&&i[p]<=s+o)),l=Float64Array.from(a,p=>t[p]),c=l.length;if(c<4)return{x:new Float64Array,y:new Float64Array};let u=(i[a[c-1]]-i[a[0]])/(c-1),h=lb(l),f=2**Math.ceil(Math.log2(4*c)),d=new Float64Array(f),m=new Float64Array(f);d.set(l),cb(d,m);let y=e.at.data[e.at.data.length-1],g=Math.min(f/2,Math.floor(y*f*u)+1);return{x:Float64Array.from({length:g},(p,x)=>x/(f*u)),y:Float64Array.from({length:g},(p,x)=>2*Math.hypot(d[x],m[x])/h)}}function ab(i,t){if(t.length<3)return t;let e=r=>i[t[r]]-i[t[r-1]];return Math.abs(e(t.length-1)/e(1)-1)>1e-6?t.slice(0,-1):t}function lb(i){let t=i.length,e=(t-1)/2,n=i.reduce((a,l)=>a+l,0)/t,r=t*(t*t-1)/12,s=i.reduce((a,l,c)=>a+(c-e)*l,0)/r,o=0;for(let a=0;a<t;a+=1){let l=.5-.5*Math.cos(2*Math.PI*a/t);i[a]=l*(i[a]-n-s*(a-e)),o+=l}return o}function cb(i,t){let e=i.length;for(let r=1,s=0;r<e;r+=1){let o=e>>1;for(;s&o;o>>=1)s^=o;s^=o,r<s&&([i[r],i[s]]=[i[s],i[r]],[t[r],t[s]]=[t[s],t[r]])}let n=ub(e);for(let r=2;r<=e;r*=2)hb(i,t,r,n)}var fo=new Float64Array;function ub(i){if(fo.length===i)return fo;fo=new Float64Array(i);for(let t=0;t<i/2;t+=1)fo[2*t]=Math.cos(2*Math.PI*t/i),fo[2*t+1]=-Math.sin(2*Math.PI*t/i);return fo}function hb(i,t,e,n){let r=e/2,s=2*i.length/e;for(let o=0;o<i.length;o+=e)for(let a=0;a<r;a+=1){let l=o+a,c=l+r,u=n[s*a],h=n[s*a+1],f=i[c]*u-t[c]*h,d=i[c]*h+t[c]*u;i[c]=i[l]-f,t[c]=t[l]-d,i[l]+=f,t[l]+=d}}function Lm(i){let t=new Map;return i.runs.forEach((e,n)=>e.charts.forEach(r=>{let s=t.get(r.id);s?s.runs.push({run:n,name:e.name,chart:r}):t.set(r.id,{chart:r,runs:[{run:n,name:e.name,chart:r}],compared:i.runs.length>1})})),[...t.values()]}function of(i,t){let e=i.runs.flatMap(({run:s,name:o,chart:a})=>a.curves.map(l=>({run:s,runName:o,label:l.label,role:l.role,x:a.at.data,y:l.values.data,shown:l.shown&&(i.runs.length<2||fb(l,a)),ghost:t!==null&&s===0})));if(t===null)return e;let n=i.runs.find(({run:s})=>s===0),r=(n?.chart.curves??[]).flatMap(s=>db(s,n.chart,n.name,t));return[...e,...r]}function fb(i,t){return i.role==="real"&&i.label===t.curves[0].label}function db(i,t,e,n){let r=pb(i,n);if(r===null)return[];let s={run:0,runName:e,label:i.label,role:i.role,shown:i.shown,ghost:!1};if(t.abscissa==="time")return[{...s,x:n.times,y:r}];let o=null,a=()=>o??=Cm(n.times,r,t,n.span);return[Object.defineProperties(s,{x:{get:()=>a().x},y:{get:()=>a().y}})]}function Fm(i,t,e){return i.chart.group==="spectrum"&&t.vibration!==e.vibration?!1:i.runs.flatMap(({chart:r})=>r.curves.flatMap(({source:s})=>s?[s.variable,s.less?.variable??s.variable]:[])).every(r=>t.series[r]===e.series[r])}function pb(i,t){let e=i.source;if(e===null)return null;let n=Pm(t,e.variable,e.index),r=e.less?Pm(t,e.less.variable,e.less.index):null;if(n===null||e.less&&r===null)return null;for(let s=0;s<n.length;s+=1)n[s]=e.factor*(n[s]-(r?r[s]:0));return n}function Pm(i,t,e){let n=i.series[t];if(n===void 0)return null;let r=n.shape.slice(1).reduce((o,a)=>o*a,1);if(e>=r)return null;let s=new Float64Array(n.shape[0]);for(let o=0;o<s.length;o+=1)s[o]=n.data[o*r+e];return s}function Gl(i,t){let e=[...new Set(i.map(r=>r.x))],n=e.every(r=>Nm(r,e[0]))?e[0]:mb(e);return[n,...i.map(r=>gb(r,n,t))]}function Nm(i,t){if(i===t)return!0;if(i.length!==t.length)return!1;for(let e=0;e<i.length;e+=1)if(Math.abs(i[e]-t[e])>1e-6*Math.abs(t[e]))return!1;return!0}function mb(i){let t=i.flatMap(e=>Array.from(e)).sort((e,n)=>e-n);return t.filter((e,n)=>n===0||e>t[n-1])}function gb(i,t,e){let n=o=>e?o===0?null:Math.abs(o):o;if(t===i.x||Nm(t,i.x))return e?Array.from(i.y,n):i.y;let s=new Array(t.length).fill(null);for(let o=0,a=0;o<i.x.length;o+=1){for(;a<t.length&&t[a]<i.x[o];)a+=1;a<t.length&&(s[a]=n(i.y[o]))}return s}function Dm(i,t){let{x:e,y:n}=i,r=e.length-1;if(r<0||t<e[0]-1e-9||t>e[r]+1e-6*Math.abs(e[r])+1e-9)return null;let s=0,o=r;for(;o-s>1;){let a=s+o>>1;e[a]<=t?s=a:o=a}return o===s||t>=e[o]?n[o]:n[s]+(n[o]-n[s])*(t-e[s])/(e[o]-e[s])}var Im=new WeakMap;function Hl(i){let t=Im.get(i);if(t)return t;let[e,n]=[1/0,-1/0];for(let s=0;s<i.length;s+=1){let o=i[s];Number.isFinite(o)&&(o<e&&(e=o),o>n&&(n=o))}let r=e<=n?[e,n]:[0,0];return Im.set(i,r),r}function af(i,t,e){let n=e.filter(r=>!r.ghost).map(r=>{let[s,o]=Hl(r.y);return`${r.label} ${ho[r.role]}, from ${ni(s)} to ${ni(o)} ${t}`.trim()});return`${i.title}: ${n.join("; ")||"no curve is shown"}.`}function lf(i){return i.runs.map(t=>t.chart).reduce((t,e)=>Wl(e)<Wl(t)?e:t)}function Wl(i){return i.at.data.length/i.samples}function Om(i){let[t,e]=[i.at.data.length,i.samples].map(n=>n.toLocaleString("en"));return`Drawn by ${t} of ${e} samples; every extreme is kept.`}function Um(i,t,e){let[n,...r]=Gl(i,!1),s=new Set(i.map(l=>l.run)).size>1,o=i.map(l=>`${[s?l.runName:"",l.label,ho[l.role],l.ghost?"original":""].filter(Boolean).join(" ")} [${e||"-"}]`),a=Array.from(n,(l,c)=>[l,...r.map(u=>u[c]??"")].map(yb).join(","));return`${[t,...o].map(xb).join(",")}
${a.join(`
`)}
`}function yb(i){return typeof i=="string"?i:String(Number(i.toPrecision(9)))}function xb(i){return`"${(/^[=+\-@\t\r]/.test(i)?`'${i}`:i).replaceAll('"','""')}"`}function cf(i,t){return i.group!=="spectrum"||i.id==="spectrum_tip_nominal"?null:typeof t?.vibration=="object"?t.vibration.marks:null}function km(i,t){let e=Math.max(0,...t.map(n=>n.x[n.x.length-1]??0));return i.filter(({at:n})=>n<=e)}function Bm(i,t,e){let n=i.filter(d=>!d.ghost),r=[d=>String(d.run),d=>d.label,d=>d.role],s=r.map(d=>[...new Set(n.map(d))]),o=r.map((d,m)=>new Set(s[m].filter(y=>!n.some(g=>g.shown&&d(g)===y)))),a=t?0:s[1].length>1?1:2,l=s[2].length,c=d=>{let m=a===0&&s[1].length>1&&l===1?s[1].length:l,y=a===0?d.run:s[a].indexOf(r[a](d)),g=wa(d.role,y,a<2,m);return a===0&&l===1?{...g,dash:wa("real",s[1].indexOf(d.label),!0,1).dash}:g},u=lt("div",{class:"legend"}),h=new Map;r.forEach((d,m)=>{if(s[m].length<2&&m!==a)return;let y=lt("div",{class:"legend-row",role:"group","aria-label":["Runs","Curves","Parts"][m]});for(let g of s[m]){let p=n.find(x=>d(x)===g);p&&y.append(f(p,g,m))}u.append(y)});function f(d,m,y){let g=y===0?d.runName:y===2&&l>1?ho[d.role]:d.label,p=y===a?c(d):{property:"--quiet",dash:y===2?c(d).dash:[]},x=zl(`var(${p.property})`,y===a&&a<2&&l>1?[]:p.dash),b=lt("span",{class:"value"}),v=lt("button",{type:"button",class:"toggle","aria-pressed":String(!o[y].has(m))},x,lt("span",{text:g}),b);return y===a&&h.set(m,b),v.addEventListener("click",()=>{o[y].delete(m)||o[y].add(m),v.setAttribute("aria-pressed",String(!o[y].has(m))),e()}),v}return{element:u,look:c,renew(d){n=d.filter(m=>!m.ghost)},shows:d=>r.every((m,y)=>!o[y].has(m(d))),tell(d){for(let[m,y]of h){let g=n.find(x=>r[a](x)===m&&r.every((b,v)=>!o[v].has(b(x)))),p=g?d(g):null;wn(y,p===null?"":ni(p).replace("-","−"))}}}}var _b="uplot",vb="u-hz",bb="u-vt",wb="u-title",Mb="u-wrap",Sb="u-under",Ab="u-over",Eb="u-axis",Ts="u-off",Tb="u-select",Rb="u-cursor-x",Cb="u-cursor-y",Pb="u-cursor-pt",Ib="u-legend",Lb="u-live",Fb="u-inline",Nb="u-series",Db="u-marker",zm="u-label",Ob="u-value",Sa="width",Aa="height";var Vm="bottom",po="left",uf="right",Tf="#000",Gm=Tf+"0",hf="mousemove",Hm="mousedown",ff="mouseup",Wm="mouseenter",qm="mouseleave",Xm="dblclick",Ub="resize",kb="scroll",$m="change",jl="dppxchange",Rf="--",bo=typeof window<"u",yf=bo?document:null,go=bo?window:null,Bb=bo?navigator:null,Se,ql;function xf(){let i=devicePixelRatio;Se!=i&&(Se=i,ql&&vf($m,ql,xf),ql=matchMedia(`(min-resolution: ${Se-.001}dppx) and (max-resolution: ${Se+.001}dppx)`),Rs($m,ql,xf),go.dispatchEvent(new CustomEvent(jl)))}function gi(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function _f(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ye(i,t,e){i.style[t]=e+"px"}function Wi(i,t,e,n){let r=yf.createElement(i);return t!=null&&gi(r,t),e?.insertBefore(r,n),r}function Pi(i,t){return Wi("div",i,t)}var Ym=new WeakMap;function dr(i,t,e,n,r){let s="translate("+t+"px,"+e+"px)",o=Ym.get(i);s!=o&&(i.style.transform=s,Ym.set(i,s),t<0||e<0||t>n||e>r?gi(i,Ts):_f(i,Ts))}var jm=new WeakMap;function Zm(i,t,e){let n=t+e,r=jm.get(i);n!=r&&(jm.set(i,n),i.style.background=t,i.style.borderColor=e)}var Jm=new WeakMap;function Km(i,t,e,n){let r=t+""+e,s=Jm.get(i);r!=s&&(Jm.set(i,r),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Cf={passive:!0},zb={...Cf,capture:!0};function Rs(i,t,e,n){t.addEventListener(i,e,n?zb:Cf)}function vf(i,t,e,n){t.removeEventListener(i,e,Cf)}bo&&xf();function qi(i,t,e,n){let r;e=e||0,n=n||t.length-1;let s=n<=2147483647;for(;n-e>1;)r=s?e+n>>1:yi((e+n)/2),t[r]<i?e=r:n=r;return i-t[e]<=t[n]-i?e:n}function Eg(i){return(e,n,r)=>{let s=-1,o=-1;for(let a=n;a<=r;a++)if(i(e[a])){s=a;break}for(let a=r;a>=n;a--)if(i(e[a])){o=a;break}return[s,o]}}var Tg=i=>i!=null,Rg=i=>i!=null&&i>0,Kl=Eg(Tg),Vb=Eg(Rg);function Gb(i,t,e,n=0,r=!1){let s=r?Vb:Kl,o=r?Rg:Tg;[t,e]=s(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??ke,l??-ke]}function Ql(i,t,e,n){let r=eg(i),s=eg(t);i==t&&(r==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Ir:Cg,a=r==1?yi:Ii,l=s==1?Ii:yi,c=a(o(Sn(i))),u=l(o(Sn(t))),h=yo(e,c),f=yo(e,u);return e==10&&(c<0&&(h=Be(h,-c)),u<0&&(f=Be(f,-u))),n||e==2?(i=h*r,t=f*s):(i=Fg(i,h),t=tc(t,f)),[i,t]}function Pf(i,t,e,n){let r=Ql(i,t,e,n);return i==0&&(r[0]=0),t==0&&(r[1]=0),r}var If=.1,Qm={mode:3,pad:If},Ta={pad:0,soft:null,mode:0},Hb={min:Ta,max:Ta};function Zl(i,t,e,n){return ec(e)?tg(i,t,e):(Ta.pad=e,Ta.soft=n?0:null,Ta.mode=n?3:0,tg(i,t,Hb))}function we(i,t){return i??t}function Wb(i,t,e){for(t=we(t,0),e=we(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function tg(i,t,e){let n=e.min,r=e.max,s=we(n.pad,0),o=we(r.pad,0),a=we(n.hard,-ke),l=we(r.hard,ke),c=we(n.soft,ke),u=we(r.soft,-ke),h=we(n.mode,0),f=we(r.mode,0),d=t-i,m=Ir(d),y=ii(Sn(i),Sn(t)),g=Ir(y),p=Sn(g-m);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,h==2&&c!=ke&&(s=0),f==2&&u!=-ke&&(o=0)));let x=d||y||1e3,b=Ir(x),v=yo(10,yi(b)),A=x*(d==0?i==0?.1:1:s),S=Be(Fg(i-A,v/10),24),_=i>=c&&(h==1||h==3&&S<=c||h==2&&S>=c)?c:ke,w=ii(a,S<_&&i>=_?_:Xi(_,S)),N=x*(d==0?t==0?.1:1:o),C=Be(tc(t+N,v/10),24),P=t<=u&&(f==1||f==3&&C>=u||f==2&&C<=u)?u:-ke,O=Xi(l,C>P&&t<=P?P:ii(P,C));return w==O&&w==0&&(O=100),[w,O]}var qb=new Intl.NumberFormat(bo?Bb.language:"en-US"),Lf=i=>qb.format(i),xi=Math,Yl=xi.PI,Sn=xi.abs,yi=xi.floor,Mn=xi.round,Ii=xi.ceil,Xi=xi.min,ii=xi.max,yo=xi.pow,eg=xi.sign,Ir=xi.log10,Cg=xi.log2,Xb=(i,t=1)=>xi.sinh(i)*t,df=(i,t=1)=>xi.asinh(i/t),ke=1/0;function ng(i){return(Ir((i^i>>31)-(i>>31))|0)+1}function bf(i,t,e){return Xi(ii(i,t),e)}function Pg(i){return typeof i=="function"}function ye(i){return Pg(i)?i:()=>i}var $b=()=>{},Ig=i=>i,Lg=(i,t)=>t,Yb=i=>null,ig=i=>!0,rg=(i,t)=>i==t,jb=/\.\d*?(?=9{6,}|0{6,})/gm,Cs=i=>{if(Dg(i)||Qr.has(i))return i;let t=`${i}`,e=t.match(jb);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[r,s]=t.split("e");return+`${Cs(r)}e${s}`}return Be(i,n)};function As(i,t){return Cs(Be(Cs(i/t))*t)}function tc(i,t){return Cs(Ii(Cs(i/t))*t)}function Fg(i,t){return Cs(yi(Cs(i/t))*t)}function Be(i,t=0){if(Dg(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Mn(n)/e}var Qr=new Map;function Ng(i){return((""+i).split(".")[1]||"").length}function Ca(i,t,e,n){let r=[],s=n.map(Ng);for(let o=t;o<e;o++){let a=Sn(o),l=Be(yo(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=i==10?u:Be(u,h);r.push(f),Qr.set(f,h)}}return r}var Ra={},Ff=[],xo=[null,null],Kr=Array.isArray,Dg=Number.isInteger,Zb=i=>i===void 0;function sg(i){return typeof i=="string"}function ec(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Jb(i){return i!=null&&typeof i=="object"}var Kb=Object.getPrototypeOf(Uint8Array),Og="__proto__";function _o(i,t=ec){let e;if(Kr(i)){let n=i.find(r=>r!=null);if(Kr(n)||t(n)){e=Array(i.length);for(let r=0;r<i.length;r++)e[r]=_o(i[r],t)}else e=i.slice()}else if(i instanceof Kb)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Og&&(e[n]=_o(i[n],t))}else e=i;return e}function gn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let r in n)r!=Og&&(ec(i[r])?gn(i[r],_o(n[r])):i[r]=_o(n[r]))}return i}var Qb=0,tw=1,ew=2;function nw(i,t,e){for(let n=0,r,s=-1;n<t.length;n++){let o=t[n];if(o>s){for(r=o-1;r>=0&&i[r]==null;)i[r--]=null;for(r=o+1;r<e&&i[r]==null;)i[s=r++]=null}}}function iw(i,t){if(ow(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return aw(o[0])||(o=sw(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],r=n[0].length,s=new Map;for(let o=0;o<r;o++)s.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(r).fill(void 0),f=t?t[o][c]:tw,d=[];for(let m=0;m<u.length;m++){let y=u[m],g=s.get(l[m]);y===null?f!=Qb&&(h[g]=y,f==ew&&d.push(g)):h[g]=y}nw(h,d,r),n.push(h)}}return n}var rw=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function sw(i){let t=i[0],e=t.length,n=Array(e);for(let s=0;s<n.length;s++)n[s]=s;n.sort((s,o)=>t[s]-t[o]);let r=[];for(let s=0;s<i.length;s++){let o=i[s],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];r.push(a)}return r}function ow(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let r=i[n][0];if(r.length!=e)return!1;if(r!=t){for(let s=0;s<e;s++)if(r[s]!=t[s])return!1}}return!0}function aw(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,r=e-1;for(;n<=r&&i[n]==null;)n++;for(;r>=n&&i[r]==null;)r--;if(r<=n)return!0;let s=ii(1,yi((r-n+1)/t));for(let o=i[n],a=n+s;a<=r;a+=s){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Ug=["January","February","March","April","May","June","July","August","September","October","November","December"],kg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Bg(i){return i.slice(0,3)}var lw=kg.map(Bg),cw=Ug.map(Bg),uw={MMMM:Ug,MMM:cw,WWWW:kg,WWW:lw};function Ma(i){return(i<10?"0":"")+i}function hw(i){return(i<10?"00":i<100?"0":"")+i}var fw={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Ma(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ma(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Ma(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ma(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ma(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>hw(i.getMilliseconds())};function Nf(i,t){t=t||uw;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=n.exec(i);)e.push(r[0][0]=="{"?fw[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](s,t);return o}}var dw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function pw(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==dw?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var zg=i=>i%1==0,Jl=[1,2,2.5,5],mw=Ca(10,-32,0,Jl),Vg=Ca(10,0,32,Jl),gw=Vg.filter(zg),Es=mw.concat(Vg),Df=`
`,Gg="{YYYY}",og=Df+Gg,Hg="{M}/{D}",Ea=Df+Hg,Xl=Ea+"/{YY}",Wg="{aa}",yw="{h}:{mm}",mo=yw+Wg,ag=Df+mo,lg=":{ss}",Te=null;function qg(i){let t=i*1e3,e=t*60,n=e*60,r=n*24,s=r*30,o=r*365,l=(i==1?Ca(10,0,3,Jl).filter(zg):Ca(10,-3,0,Jl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Gg,Te,Te,Te,Te,Te,Te,1],[r*28,"{MMM}",og,Te,Te,Te,Te,Te,1],[r,Hg,og,Te,Te,Te,Te,Te,1],[n,"{h}"+Wg,Xl,Te,Ea,Te,Te,Te,1],[e,mo,Xl,Te,Ea,Te,Te,Te,1],[t,lg,Xl+" "+mo,Te,Ea+" "+mo,Te,ag,Te,1],[i,lg+".{fff}",Xl+" "+mo,Te,Ea+" "+mo,Te,ag,Te,1]];function u(h){return(f,d,m,y,g,p)=>{let x=[],b=g>=o,v=g>=s&&g<o,A=h(m),S=Be(A*i,3),_=pf(A.getFullYear(),b?0:A.getMonth(),v||b?1:A.getDate()),w=Be(_*i,3);if(v||b){let N=v?g/s:0,C=b?g/o:0,P=S==w?S:Be(pf(_.getFullYear()+C,_.getMonth()+N,1)*i,3),O=new Date(Mn(P/i)),B=O.getFullYear(),F=O.getMonth();for(let V=0;P<=y;V++){let q=pf(B+C*V,F+N*V,1),G=q-h(Be(q*i,3));P=Be((+q+G)*i,3),P<=y&&x.push(P)}}else{let N=g>=r?r:g,C=yi(m)-yi(S),P=w+C+tc(S-w,N);x.push(P);let O=h(P),B=O.getHours()+O.getMinutes()/e+O.getSeconds()/n,F=g/n,V=f.axes[d]._space,q=p/V;for(;P=Be(P+g,i==1?0:3),!(P>y);)if(F>1){let G=yi(Be(B+F,6))%24,j=h(P).getHours()-G;j>1&&(j=-1),P-=j*n,B=(B+F)%24;let tt=x[x.length-1];Be((P-tt)/g,3)*q>=.7&&x.push(P)}else x.push(P)}return x}}return[l,c,u]}var[xw,_w,vw]=qg(1),[bw,ww,Mw]=qg(.001);Ca(2,-53,53,[1]);function cg(i,t){return i.map(e=>e.map((n,r)=>r==0||r==8||n==null?n:t(r==1||e[8]==0?n:e[1]+n)))}function ug(i,t){return(e,n,r,s,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,h,f,d;return n.map(m=>{let y=i(m),g=y.getFullYear(),p=y.getMonth(),x=y.getDate(),b=y.getHours(),v=y.getMinutes(),A=y.getSeconds(),S=g!=l&&a[2]||p!=c&&a[3]||x!=u&&a[4]||b!=h&&a[5]||v!=f&&a[6]||A!=d&&a[7]||a[1];return l=g,c=p,u=x,h=b,f=v,d=A,S(y)})}}function Sw(i,t){let e=Nf(t);return(n,r,s,o,a)=>r.map(l=>e(i(l)))}function pf(i,t,e){return new Date(i,t,e)}function hg(i,t){return t(i)}var Aw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function fg(i,t){return(e,n,r,s)=>s==null?Rf:t(i(n))}function Ew(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Tw(i,t){return i.series[t].fill(i,t)}var Rw={show:!0,live:!0,isolate:!1,mount:$b,markers:{show:!0,width:2,stroke:Ew,fill:Tw,dash:"solid"},idx:null,idxs:null,values:[]};function Cw(i,t){let e=i.cursor.points,n=Pi(),r=e.size(i,t);Ye(n,Sa,r),Ye(n,Aa,r);let s=r/-2;Ye(n,"marginLeft",s),Ye(n,"marginTop",s);let o=e.width(i,t,r);return o&&Ye(n,"borderWidth",o),n}function Pw(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Iw(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Lw(i,t){return i.series[t].points.size}var mf=[0,0];function Fw(i,t,e){return mf[0]=t,mf[1]=e,mf}function $l(i,t,e,n=!0){return r=>{r.button==0&&(!n||r.target==t)&&e(r)}}function gf(i,t,e,n=!0){return r=>{(!n||r.target==t)&&e(r)}}var Nw={show:!0,x:!0,y:!0,lock:!1,move:Fw,points:{one:!1,show:Cw,size:Lw,width:0,stroke:Iw,fill:Pw},bind:{mousedown:$l,mouseup:$l,click:$l,dblclick:$l,mousemove:gf,mouseleave:gf,mouseenter:gf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,r)=>n-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Xg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Of=gn({},Xg,{filter:Lg}),$g=gn({},Of,{size:10}),Yg=gn({},Xg,{show:!1}),Uf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',jg="bold "+Uf,Zg=1.5,dg={show:!0,scale:"x",stroke:Tf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jg,side:2,grid:Of,ticks:$g,border:Yg,font:Uf,lineGap:Zg,rotate:0},Dw="Value",Ow="Time",pg={show:!0,scale:"x",auto:!1,sorted:1,min:ke,max:-ke,idxs:[]};function Uw(i,t,e,n,r){return t.map(s=>s==null?"":Lf(s))}function kw(i,t,e,n,r,s,o){let a=[],l=Qr.get(r)||0;e=o?e:Be(tc(e,r),l);for(let c=e;c<=n;c=Be(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function wf(i,t,e,n,r,s,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Ir:Cg,u=yi(c(e));r=yo(l,u),l==10&&(r=Es[qi(r,Es)]);let h=e,f=r*l;l==10&&(f=Es[qi(f,Es)]);do a.push(h),h=h+r,l==10&&!Qr.has(h)&&(h=Be(h,Qr.get(r))),h>=f&&(r=h,f=r*l,l==10&&(f=Es[qi(f,Es)]));while(h<=n);return a}function Bw(i,t,e,n,r,s,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?wf(i,t,ii(l,e),n,r):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?wf(i,t,ii(l,-n),-e,r):[l]).reverse().map(f=>-f).concat(u,c)}var Jg=/./,zw=/[12357]/,Vw=/[125]/,mg=/1/,Mf=(i,t,e,n)=>i.map((r,s)=>t==4&&r==0||s%n==0&&e.test(r.toExponential()[r<0?1:0])?r:null);function Gw(i,t,e,n,r){let s=i.axes[e],o=s.scale,a=i.scales[o],l=i.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?Jg:l(7,o)-u>=c?zw:l(5,o)-u>=c?Vw:mg;if(h==mg){let f=Sn(l(1,o)-u);if(f<c)return Mf(t.slice().reverse(),a.distr,h,Ii(c/f)).reverse()}return Mf(t,a.distr,h,1)}function Hw(i,t,e,n,r){let s=i.axes[e],o=s.scale,a=s._space,l=i.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?Mf(t.slice().reverse(),3,Jg,Ii(a/c)).reverse():t}function Ww(i,t,e,n){return n==null?Rf:t==null?"":Lf(t)}var gg={show:!0,scale:"y",stroke:Tf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jg,side:3,grid:Of,ticks:$g,border:Yg,font:Uf,lineGap:Zg,rotate:0};function qw(i,t){let e=3+(i||1)*2;return Be(e*t,3)}function Xw(i,t){let{scale:e,idxs:n}=i.series[0],r=i._data[0],s=i.valToPos(r[n[0]],e,!0),o=i.valToPos(r[n[1]],e,!0),a=Sn(o-s),l=i.series[t],c=a/(l.points.space*Se);return n[1]-n[0]<=c}var yg={scale:null,auto:!0,sorted:0,min:ke,max:-ke},Kg=(i,t,e,n,r)=>r,xg={show:!0,auto:!0,sorted:0,gaps:Kg,alpha:1,facets:[gn({},yg,{scale:"x"}),gn({},yg,{scale:"y"})]},_g={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Kg,alpha:1,points:{show:Xw,filter:null},values:null,min:ke,max:-ke,idxs:[],path:null,clip:null};function $w(i,t,e,n,r){return e/10}var Qg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Yw=gn({},Qg,{time:!1,ori:1}),vg={};function t0(i,t){let e=vg[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(r=>r!=n)},pub(n,r,s,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=r&&e.plots[u].pub(n,r,s,o,a,l,c)}},i!=null&&(vg[i]=e)),e}var vo=1,Sf=2;function Ps(i,t,e){let n=i.mode,r=i.series[t],s=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=s[0],c=n==2?s[1]:s[t],u=n==2?o[r.facets[0].scale]:o[i.series[0].scale],h=n==2?o[r.facets[1].scale]:o[r.scale],f=a.left,d=a.top,m=a.width,y=a.height,g=i.valToPosH,p=i.valToPosV;return u.ori==0?e(r,l,c,u,h,g,p,f,d,m,y,ic,wo,sc,n0,r0):e(r,l,c,u,h,p,g,d,f,y,m,rc,Mo,zf,i0,s0)}function kf(i,t){let e=0,n=0,r=we(i.bands,Ff);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function jw(i,t,e,n,r){let s=i.mode,o=i.series[t],a=s==2?o.facets[1].scale:o.scale,l=i.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Lr(i,t,e,n,r,s){return Ps(i,t,(o,a,l,c,u,h,f,d,m,y,g)=>{let p=o.pxRound,x=c.dir*(c.ori==0?1:-1),b=c.ori==0?wo:Mo,v,A;x==1?(v=e,A=n):(v=n,A=e);let S=p(h(a[v],c,y,d)),_=p(f(l[v],u,g,m)),w=p(h(a[A],c,y,d)),N=p(f(s==1?u.max:u.min,u,g,m)),C=new Path2D(r);return b(C,w,N),b(C,S,N),b(C,S,_),C})}function nc(i,t,e,n,r,s){let o=null;if(i.length>0){o=new Path2D;let a=t==0?sc:zf,l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+s),l=f[1]}}let c=e+r-l,u=10;c>0&&a(o,l,n-u/2,c,n+s+u)}return o}function Zw(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Bf(i,t,e,n,r,s,o){let a=[],l=i.length;for(let c=r==1?e:n;c>=e&&c<=n;c+=r)if(t[c]===null){let h=c,f=c;if(r==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=s(i[h]),m=f==h?d:s(i[f]),y=h-r;d=o<=0&&y>=0&&y<l?s(i[y]):d;let p=f+r;m=o>=0&&p>=0&&p<l?s(i[p]):m,m>=d&&a.push([d,m])}return a}function bg(i){return i==0?Ig:i==1?Mn:t=>As(t,i)}function e0(i){let t=i==0?ic:rc,e=i==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},n=i==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?n(r,s,o,a,l):(c=Xi(c,a/2,l/2),u=Xi(u,a/2,l/2),t(r,s+c,o),e(r,s+a,o,s+a,o+l,c),e(r,s+a,o+l,s,o+l,u),e(r,s,o+l,s,o,u),e(r,s,o,s+a,o,c),r.closePath())}}var ic=(i,t,e)=>{i.moveTo(t,e)},rc=(i,t,e)=>{i.moveTo(e,t)},wo=(i,t,e)=>{i.lineTo(t,e)},Mo=(i,t,e)=>{i.lineTo(e,t)},sc=e0(0),zf=e0(1),n0=(i,t,e,n,r,s)=>{i.arc(t,e,n,r,s)},i0=(i,t,e,n,r,s)=>{i.arc(e,t,n,r,s)},r0=(i,t,e,n,r,s,o)=>{i.bezierCurveTo(t,e,n,r,s,o)},s0=(i,t,e,n,r,s,o)=>{i.bezierCurveTo(e,t,r,n,o,s)};function o0(i){return(t,e,n,r,s)=>Ps(t,e,(o,a,l,c,u,h,f,d,m,y,g)=>{let{pxRound:p,points:x}=o,b,v;c.ori==0?(b=ic,v=n0):(b=rc,v=i0);let A=Be(x.width*Se,3),S=(x.size-x.width)/2*Se,_=Be(S*2,3),w=new Path2D,N=new Path2D,{left:C,top:P,width:O,height:B}=t.bbox;sc(N,C-_,P-_,O+_*2,B+_*2);let F=V=>{if(l[V]!=null){let q=p(h(a[V],c,y,d)),G=p(f(l[V],u,g,m));b(w,q+S,G),v(w,q,G,S,0,Yl*2)}};if(s)s.forEach(F);else for(let V=n;V<=r;V++)F(V);return{stroke:A>0?w:null,fill:w,clip:N,flags:vo|Sf}})}function a0(i){return(t,e,n,r,s,o)=>{n!=r&&(s!=n&&o!=n&&i(t,e,n),s!=r&&o!=r&&i(t,e,r),i(t,e,o))}}var Jw=a0(wo),Kw=a0(Mo);function l0(i){let t=we(i?.alignGaps,0);return(e,n,r,s)=>Ps(e,n,(o,a,l,c,u,h,f,d,m,y,g)=>{[r,s]=Kl(l,r,s);let p=o.pxRound,x=B=>p(h(B,c,y,d)),b=B=>p(f(B,u,g,m)),v,A;c.ori==0?(v=wo,A=Jw):(v=Mo,A=Kw);let S=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:vo},w=_.stroke,N=!1;if(s-r>=y*4){let B=ct=>e.posToVal(ct,c.key,!0),F=null,V=null,q,G,rt,$=x(a[S==1?r:s]),j=x(a[r]),tt=x(a[s]),ut=B(S==1?j+1:tt-1);for(let ct=S==1?r:s;ct>=r&&ct<=s;ct+=S){let K=a[ct],yt=(S==1?K<ut:K>ut)?$:x(K),Mt=l[ct];yt==$?Mt!=null?(G=Mt,F==null?(v(w,yt,b(G)),q=F=V=G):G<F?F=G:G>V&&(V=G)):Mt===null&&(N=!0):(F!=null&&A(w,$,b(F),b(V),b(q),b(G)),Mt!=null?(G=Mt,v(w,yt,b(G)),F=V=q=G):(F=V=null,Mt===null&&(N=!0)),$=yt,ut=B($+S))}F!=null&&F!=V&&rt!=$&&A(w,$,b(F),b(V),b(q),b(G))}else for(let B=S==1?r:s;B>=r&&B<=s;B+=S){let F=l[B];F===null?N=!0:F!=null&&v(w,x(a[B]),b(F))}let[P,O]=kf(e,n);if(o.fill!=null||P!=0){let B=_.fill=new Path2D(w),F=o.fillTo(e,n,o.min,o.max,P),V=b(F),q=x(a[r]),G=x(a[s]);S==-1&&([G,q]=[q,G]),v(B,G,V),v(B,q,V)}if(!o.spanGaps){let B=[];N&&B.push(...Bf(a,l,r,s,S,x,t)),_.gaps=B=o.gaps(e,n,r,s,B),_.clip=nc(B,c.ori,d,m,y,g)}return O!=0&&(_.band=O==2?[Lr(e,n,r,s,w,-1),Lr(e,n,r,s,w,1)]:Lr(e,n,r,s,w,O)),_})}function Qw(i){let t=we(i.align,1),e=we(i.ascDesc,!1),n=we(i.alignGaps,0),r=we(i.extend,!1);return(s,o,a,l)=>Ps(s,o,(c,u,h,f,d,m,y,g,p,x,b)=>{[a,l]=Kl(h,a,l);let v=c.pxRound,{left:A,width:S}=s.bbox,_=j=>v(m(j,f,x,g)),w=j=>v(y(j,d,b,p)),N=f.ori==0?wo:Mo,C={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:vo},P=C.stroke,O=f.dir*(f.ori==0?1:-1),B=w(h[O==1?a:l]),F=_(u[O==1?a:l]),V=F,q=F;r&&t==-1&&(q=A,N(P,q,B)),N(P,F,B);for(let j=O==1?a:l;j>=a&&j<=l;j+=O){let tt=h[j];if(tt==null)continue;let ut=_(u[j]),ct=w(tt);t==1?N(P,ut,B):N(P,V,ct),N(P,ut,ct),B=ct,V=ut}let G=V;r&&t==1&&(G=A+S,N(P,G,B));let[rt,$]=kf(s,o);if(c.fill!=null||rt!=0){let j=C.fill=new Path2D(P),tt=c.fillTo(s,o,c.min,c.max,rt),ut=w(tt);N(j,G,ut),N(j,q,ut)}if(!c.spanGaps){let j=[];j.push(...Bf(u,h,a,l,O,_,n));let tt=c.width*Se/2,ut=e||t==1?tt:-tt,ct=e||t==-1?-tt:tt;j.forEach(K=>{K[0]+=ut,K[1]+=ct}),C.gaps=j=c.gaps(s,o,a,l,j),C.clip=nc(j,f.ori,g,p,x,b)}return $!=0&&(C.band=$==2?[Lr(s,o,a,l,P,-1),Lr(s,o,a,l,P,1)]:Lr(s,o,a,l,P,$)),C})}function wg(i,t,e,n,r,s,o=ke){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=Sn(i[l]-i[a]);u<c&&(c=u,o=Sn(e(i[l],n,r,s)-e(i[a],n,r,s)))}a=l}}return o}function tM(i){i=i||Ra;let t=we(i.size,[.6,ke,1]),e=i.align||0,n=i.gap||0,r=i.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=ye(r),o=1-t[0],a=we(t[1],ke),l=we(t[2],1),c=we(i.disp,Ra),u=we(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,m,y,g)=>Ps(d,m,(p,x,b,v,A,S,_,w,N,C,P)=>{let O=p.pxRound,B=e,F=n*Se,V=a*Se,q=l*Se,G,rt;v.ori==0?[G,rt]=s(d,m):[rt,G]=s(d,m);let $=v.dir*(v.ori==0?1:-1),j=v.ori==0?sc:zf,tt=v.ori==0?u:(Pt,Jt,ae,At,Ue,Gt,jt)=>{u(Pt,Jt,ae,Ue,At,jt,Gt)},ut=we(d.bands,Ff).find(Pt=>Pt.series[0]==m),ct=ut!=null?ut.dir:0,K=p.fillTo(d,m,p.min,p.max,ct),gt=O(_(K,A,P,N)),yt,Mt,xt,zt=C,te=O(p.width*Se),dt=!1,Wt=null,qt=null,Yt=null,_e=null;h!=null&&(te==0||f!=null)&&(dt=!0,Wt=h.values(d,m,y,g),qt=new Map,new Set(Wt).forEach(Pt=>{Pt!=null&&qt.set(Pt,new Path2D)}),te>0&&(Yt=f.values(d,m,y,g),_e=new Map,new Set(Yt).forEach(Pt=>{Pt!=null&&_e.set(Pt,new Path2D)})));let{x0:Ne,size:un}=c;if(Ne!=null&&un!=null){B=1,x=Ne.values(d,m,y,g),Ne.unit==2&&(x=x.map(ae=>d.posToVal(w+ae*C,v.key,!0)));let Pt=un.values(d,m,y,g);un.unit==2?Mt=Pt[0]*C:Mt=S(Pt[0],v,C,w)-S(0,v,C,w),zt=wg(x,b,S,v,C,w,zt),xt=zt-Mt+F}else zt=wg(x,b,S,v,C,w,zt),xt=zt*o+F,Mt=zt-xt;xt<1&&(xt=0),te>=Mt/2&&(te=0),xt<5&&(O=Ig);let De=xt>0,Cn=zt-xt-(De?te:0);Mt=O(bf(Cn,q,V)),yt=(B==0?Mt/2:B==$?0:Mt)-B*$*((B==0?F/2:0)+(De?te/2:0));let ve={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},_n=dt?null:new Path2D,Qe=null;if(ut!=null)Qe=d.data[ut.series[1]];else{let{y0:Pt,y1:Jt}=c;Pt!=null&&Jt!=null&&(b=Jt.values(d,m,y,g),Qe=Pt.values(d,m,y,g))}let hn=G*Mt,k=rt*Mt;for(let Pt=$==1?y:g;Pt>=y&&Pt<=g;Pt+=$){let Jt=b[Pt];if(Jt==null)continue;if(Qe!=null){let X=Qe[Pt]??0;if(Jt-X==0)continue;gt=_(X,A,P,N)}let ae=v.distr!=2||c!=null?x[Pt]:Pt,At=S(ae,v,C,w),Ue=_(we(Jt,K),A,P,N),Gt=O(At-yt),jt=O(ii(Ue,gt)),I=O(Xi(Ue,gt)),E=jt-I;if(Jt!=null){let X=Jt<0?k:hn,ft=Jt<0?hn:k;dt?(te>0&&Yt[Pt]!=null&&j(_e.get(Yt[Pt]),Gt,I+yi(te/2),Mt,ii(0,E-te),X,ft),Wt[Pt]!=null&&j(qt.get(Wt[Pt]),Gt,I+yi(te/2),Mt,ii(0,E-te),X,ft)):j(_n,Gt,I+yi(te/2),Mt,ii(0,E-te),X,ft),tt(d,m,Pt,Gt-te/2,I,Mt+te,E)}}return te>0?ve.stroke=dt?_e:_n:dt||(ve._fill=p.width==0?p._fill:p._stroke??p._fill,ve.width=0),ve.fill=dt?qt:_n,ve})}function eM(i,t){let e=we(t?.alignGaps,0);return(n,r,s,o)=>Ps(n,r,(a,l,c,u,h,f,d,m,y,g,p)=>{[s,o]=Kl(c,s,o);let x=a.pxRound,b=G=>x(f(G,u,g,m)),v=G=>x(d(G,h,p,y)),A,S,_;u.ori==0?(A=ic,_=wo,S=r0):(A=rc,_=Mo,S=s0);let w=u.dir*(u.ori==0?1:-1),N=b(l[w==1?s:o]),C=N,P=[],O=[];for(let G=w==1?s:o;G>=s&&G<=o;G+=w)if(c[G]!=null){let $=l[G],j=b($);P.push(C=j),O.push(v(c[G]))}let B={stroke:i(P,O,A,_,S,x),fill:null,clip:null,band:null,gaps:null,flags:vo},F=B.stroke,[V,q]=kf(n,r);if(a.fill!=null||V!=0){let G=B.fill=new Path2D(F),rt=a.fillTo(n,r,a.min,a.max,V),$=v(rt);_(G,C,$),_(G,N,$)}if(!a.spanGaps){let G=[];G.push(...Bf(l,c,s,o,w,b,e)),B.gaps=G=a.gaps(n,r,s,o,G),B.clip=nc(G,u.ori,m,y,g,p)}return q!=0&&(B.band=q==2?[Lr(n,r,s,o,F,-1),Lr(n,r,s,o,F,1)]:Lr(n,r,s,o,F,q)),B})}function nM(i){return eM(iM,i)}function iM(i,t,e,n,r,s){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}return a}var Af=new Set;function Mg(){for(let i of Af)i.syncRect(!0)}bo&&(Rs(Ub,go,Mg),Rs(kb,go,Mg,!0),Rs(jl,go,()=>{yn.pxRatio=Se}));var rM=l0(),sM=o0();function Sg(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((s,o)=>Ef(s,o,t,e))}function oM(i,t){return i.map((e,n)=>n==0?{}:gn({},t,e))}function Ef(i,t,e,n){return gn({},t==0?e:n,i)}function c0(i,t,e){return t==null?xo:[t,e]}var aM=c0;function lM(i,t,e){return t==null?xo:Zl(t,e,If,!0)}function u0(i,t,e,n){return t==null?xo:Ql(t,e,i.scales[n].log,!1)}var cM=u0;function h0(i,t,e,n){return t==null?xo:Pf(t,e,i.scales[n].log,!1)}var uM=h0;function hM(i,t,e,n,r){let s=ii(ng(i),ng(t)),o=t-i,a=qi(r/n*o,e);do{let l=e[a],c=n*l/o;if(c>=r&&s+(l<5?Qr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Ag(i){let t,e;return i=i.replace(/(\d+)px/,(n,r)=>(t=Mn((e=+r)*Se))+"px"),[i,t,e]}function fM(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Be(t[2]*Se,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function yn(i,t,e){let n={mode:we(i.mode,1)},r=n.mode;function s(M,T,L,D){let W=T.valToPct(M);return D+L*(T.dir==-1?1-W:W)}function o(M,T,L,D){let W=T.valToPct(M);return D+L*(T.dir==-1?W:1-W)}function a(M,T,L,D){return T.ori==0?s(M,T,L,D):o(M,T,L,D)}n.valToPosH=s,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Pi(_b);if(i.id!=null&&(c.id=i.id),gi(c,i.class),i.title){let M=Pi(wb,c);M.textContent=i.title}let u=Wi("canvas"),h=n.ctx=u.getContext("2d"),f=Pi(Mb,c);Rs("click",f,M=>{M.target===m&&(We!=so||Ze!=oo)&&Bn.click(n,M)},!0);let d=n.under=Pi(Sb,f);f.appendChild(u);let m=n.over=Pi(Ab,f);i=_o(i);let y=+we(i.pxAlign,1),g=bg(y);(i.plugins||[]).forEach(M=>{M.opts&&(i=M.opts(n,i)||i)});let p=i.ms||.001,x=n.series=r==1?Sg(i.series||[],pg,_g,!1):oM(i.series||[null],xg),b=n.axes=Sg(i.axes||[],dg,gg,!0),v=n.scales={},A=n.bands=i.bands||[];A.forEach(M=>{M.fill=ye(M.fill||null),M.dir=we(M.dir,-1)});let S=r==2?x[1].facets[0].scale:x[0].scale,_={axes:Rr,series:pe},w=(i.drawOrder||["axes","series"]).map(M=>_[M]);function N(M){let T=M.distr==3?L=>Ir(L>0?L:M.clamp(n,L,M.min,M.max,M.key)):M.distr==4?L=>df(L,M.asinh):M.distr==100?L=>M.fwd(L):L=>L;return L=>{let D=T(L),{_min:W,_max:J}=M,at=J-W;return(D-W)/at}}function C(M){let T=v[M];if(T==null){let L=(i.scales||Ra)[M]||Ra;if(L.from!=null){C(L.from);let D=gn({},v[L.from],L,{key:M});D.valToPct=N(D),v[M]=D}else{T=v[M]=gn({},M==S?Qg:Yw,L),T.key=M;let D=T.time,W=T.range,J=Kr(W);if((M!=S||r==2&&!D)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Qm:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Qm:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&ec(W))){let at=W;W=(pt,wt,Nt)=>wt==null?xo:Zl(wt,Nt,at)}T.range=ye(W||(D?aM:M==S?T.distr==3?cM:T.distr==4?uM:c0:T.distr==3?u0:T.distr==4?h0:lM)),T.auto=ye(J?!1:T.auto),T.clamp=ye(T.clamp||$w),T._min=T._max=null,T.valToPct=N(T)}}}C("x"),C("y"),r==1&&x.forEach(M=>{C(M.scale)}),b.forEach(M=>{C(M.scale)});for(let M in i.scales)C(M);let P=v[S],O=P.distr,B,F;P.ori==0?(gi(c,vb),B=s,F=o):(gi(c,bb),B=o,F=s);let V={};for(let M in v){let T=v[M];(T.min!=null||T.max!=null)&&(V[M]={min:T.min,max:T.max},T.min=T.max=null)}let q=i.tzDate||(M=>new Date(Mn(M/p))),G=i.fmtDate||Nf,rt=p==1?vw(q):Mw(q),$=ug(q,cg(p==1?_w:ww,G)),j=fg(q,hg(Aw,G)),tt=[],ut=n.legend=gn({},Rw,i.legend),ct=n.cursor=gn({},Nw,{drag:{y:r==2}},i.cursor),K=ut.show,gt=ct.show,yt=ut.markers;ut.idxs=tt,yt.width=ye(yt.width),yt.dash=ye(yt.dash),yt.stroke=ye(yt.stroke),yt.fill=ye(yt.fill);let Mt,xt,zt,te=[],dt=[],Wt,qt=!1,Yt={};if(ut.live){let M=x[1]?x[1].values:null;qt=M!=null,Wt=qt?M(n,1,0):{_:0};for(let T in Wt)Yt[T]=Rf}if(K)if(Mt=Wi("table",Ib,c),zt=Wi("tbody",null,Mt),ut.mount(n,Mt),qt){xt=Wi("thead",null,Mt,zt);let M=Wi("tr",null,xt);Wi("th",null,M);for(var _e in Wt)Wi("th",zm,M).textContent=_e}else gi(Mt,Fb),ut.live&&gi(Mt,Lb);let Ne={show:!0},un={show:!1};function De(M,T){if(T==0&&(qt||!ut.live||r==2))return xo;let L=[],D=Wi("tr",Nb,zt,zt.childNodes[T]);gi(D,M.class),M.show||gi(D,Ts);let W=Wi("th",null,D);if(yt.show){let pt=Pi(Db,W);if(T>0){let wt=yt.width(n,T);wt&&(pt.style.border=wt+"px "+yt.dash(n,T)+" "+yt.stroke(n,T)),pt.style.background=yt.fill(n,T)}}let J=Pi(zm,W);M.label instanceof HTMLElement?J.appendChild(M.label):J.textContent=M.label,T>0&&(yt.show||(J.style.color=M.width>0?yt.stroke(n,T):yt.fill(n,T)),ve("click",W,pt=>{if(ct._lock)return;ee(pt);let wt=x.indexOf(M);if((pt.ctrlKey||pt.metaKey)!=ut.isolate){let Nt=x.some((Dt,Ut)=>Ut>0&&Ut!=wt&&Dt.show);x.forEach((Dt,Ut)=>{Ut>0&&cr(Ut,Nt?Ut==wt?Ne:un:Ne,!0,mn.setSeries)})}else cr(wt,{show:!M.show},!0,mn.setSeries)},!1),ne&&ve(Wm,W,pt=>{ct._lock||(ee(pt),cr(x.indexOf(M),lo,!0,mn.setSeries))},!1));for(var at in Wt){let pt=Wi("td",Ob,D);pt.textContent="--",L.push(pt)}return[D,L]}let Cn=new Map;function ve(M,T,L,D=!0){let W=Cn.get(T)||{},J=ct.bind[M](n,T,L,D);J&&(Rs(M,T,W[M]=J),Cn.set(T,W))}function _n(M,T,L){let D=Cn.get(T)||{};for(let W in D)(M==null||W==M)&&(vf(W,T,D[W]),delete D[W]);M==null&&Cn.delete(T)}let Qe=0,hn=0,k=0,Pt=0,Jt=0,ae=0,At=Jt,Ue=ae,Gt=k,jt=Pt,I=0,E=0,X=0,ft=0;n.bbox={};let ot=!1,vt=!1,bt=!1,et=!1,it=!1,mt=!1;function U(M,T,L){(L||M!=n.width||T!=n.height)&&st(M,T),he(!1),bt=!0,vt=!0,Xn()}function st(M,T){n.width=Qe=k=M,n.height=hn=Pt=T,Jt=ae=0,St(),Ht();let L=n.bbox;I=L.left=As(Jt*Se,.5),E=L.top=As(ae*Se,.5),X=L.width=As(k*Se,.5),ft=L.height=As(Pt*Se,.5)}let nt=3;function Et(){let M=!1,T=0;for(;!M;){T++;let L=no(T),D=lr(T);M=T==nt||L&&D,M||(st(n.width,n.height),vt=!0)}}function _t({width:M,height:T}){U(M,T)}n.setSize=_t;function St(){let M=!1,T=!1,L=!1,D=!1;b.forEach((W,J)=>{if(W.show&&W._show){let{side:at,_size:pt}=W,wt=at%2,Nt=W.label!=null?W.labelSize:0,Dt=pt+Nt;Dt>0&&(wt?(k-=Dt,at==3?(Jt+=Dt,D=!0):L=!0):(Pt-=Dt,at==0?(ae+=Dt,M=!0):T=!0))}}),or[0]=M,or[1]=L,or[2]=T,or[3]=D,k-=Vi[1]+Vi[3],Jt+=Vi[3],Pt-=Vi[2]+Vi[0],ae+=Vi[0]}function Ht(){let M=Jt+k,T=ae+Pt,L=Jt,D=ae;function W(J,at){switch(J){case 1:return M+=at,M-at;case 2:return T+=at,T-at;case 3:return L-=at,L+at;case 0:return D-=at,D+at}}b.forEach((J,at)=>{if(J.show&&J._show){let pt=J.side;J._pos=W(pt,J._size),J.label!=null&&(J._lpos=W(pt,J.labelSize))}})}if(ct.dataIdx==null){let M=ct.hover,T=M.skip=new Set(M.skip??[]);T.add(void 0);let L=M.prox=ye(M.prox),D=M.bias??=0;ct.dataIdx=(W,J,at,pt)=>{if(J==0)return at;let wt=at,Nt=L(W,J,at,pt)??ke,Dt=Nt>=0&&Nt<ke,Ut=P.ori==0?k:Pt,oe=ct.left,Me=t[0],be=t[J];if(T.has(be[at])){wt=null;let me=null,Qt=null,Xt;if(D==0||D==-1)for(Xt=at;me==null&&Xt-- >0;)T.has(be[Xt])||(me=Xt);if(D==0||D==1)for(Xt=at;Qt==null&&Xt++<be.length;)T.has(be[Xt])||(Qt=Xt);if(me!=null||Qt!=null)if(Dt){let Xe=me==null?-1/0:B(Me[me],P,Ut,0),nn=Qt==null?1/0:B(Me[Qt],P,Ut,0),Fn=oe-Xe,Oe=nn-oe;Fn<=Oe?Fn<=Nt&&(wt=me):Oe<=Nt&&(wt=Qt)}else wt=Qt==null?me:me==null?Qt:at-me<=Qt-at?me:Qt}else Dt&&Sn(oe-B(Me[at],P,Ut,0))>Nt&&(wt=null);return wt}}let ee=M=>{ct.event=M};ct.idxs=tt,ct._lock=!1;let ht=ct.points;ht.show=ye(ht.show),ht.size=ye(ht.size),ht.stroke=ye(ht.stroke),ht.width=ye(ht.width),ht.fill=ye(ht.fill);let kt=n.focus=gn({},i.focus||{alpha:.3},ct.focus),ne=kt.prox>=0,Ct=ne&&ht.one,ue=[],He=[],Jn=[];function da(M,T){let L=ht.show(n,T);if(L instanceof HTMLElement)return gi(L,Pb),gi(L,M.class),dr(L,-10,-10,k,Pt),m.insertBefore(L,ue[T]),L}function Qs(M,T){if(r==1||T>0){let L=r==1&&v[M.scale].time,D=M.value;M.value=L?sg(D)?fg(q,hg(D,G)):D||j:D||Ww,M.label=M.label||(L?Ow:Dw)}if(Ct||T>0){M.width=M.width==null?1:M.width,M.paths=M.paths||rM||Yb,M.fillTo=ye(M.fillTo||jw),M.pxAlign=+we(M.pxAlign,y),M.pxRound=bg(M.pxAlign),M.stroke=ye(M.stroke||null),M.fill=ye(M.fill||null),M._stroke=M._fill=M._paths=M._focus=null;let L=qw(ii(1,M.width),1),D=M.points=gn({},{size:L,width:ii(1,L*.2),stroke:M.stroke,space:L*2,paths:sM,_stroke:null,_fill:null},M.points);D.show=ye(D.show),D.filter=ye(D.filter),D.fill=ye(D.fill),D.stroke=ye(D.stroke),D.paths=ye(D.paths),D.pxAlign=M.pxAlign}if(K){let L=De(M,T);te.splice(T,0,L[0]),dt.splice(T,0,L[1]),ut.values.push(null)}if(gt){tt.splice(T,0,null);let L=null;Ct?T==0&&(L=da(M,T)):T>0&&(L=da(M,T)),ue.splice(T,0,L),He.splice(T,0,0),Jn.splice(T,0,0)}Ln("addSeries",T)}function $h(M,T){T=T??x.length,M=r==1?Ef(M,T,pg,_g):Ef(M,T,{},xg),x.splice(T,0,M),Qs(x[T],T)}n.addSeries=$h;function Ol(M){if(x.splice(M,1),K){ut.values.splice(M,1),dt.splice(M,1);let T=te.splice(M,1)[0];_n(null,T.firstChild),T.remove()}gt&&(tt.splice(M,1),ue.splice(M,1)[0].remove(),He.splice(M,1),Jn.splice(M,1)),Ln("delSeries",M)}n.delSeries=Ol;let or=[!1,!1,!1,!1];function Ar(M,T){if(M._show=M.show,M.show){let L=M.side%2,D=v[M.scale];D==null&&(M.scale=L?x[1].scale:S,D=v[M.scale]);let W=D.time;M.size=ye(M.size),M.space=ye(M.space),M.rotate=ye(M.rotate),Kr(M.incrs)&&M.incrs.forEach(at=>{!Qr.has(at)&&Qr.set(at,Ng(at))}),M.incrs=ye(M.incrs||(D.distr==2?gw:W?p==1?xw:bw:Es)),M.splits=ye(M.splits||(W&&D.distr==1?rt:D.distr==3?wf:D.distr==4?Bw:kw)),M.stroke=ye(M.stroke),M.grid.stroke=ye(M.grid.stroke),M.ticks.stroke=ye(M.ticks.stroke),M.border.stroke=ye(M.border.stroke);let J=M.values;M.values=Kr(J)&&!Kr(J[0])?ye(J):W?Kr(J)?ug(q,cg(J,G)):sg(J)?Sw(q,J):J||$:J||Uw,M.filter=ye(M.filter||(D.distr>=3&&D.log==10?Gw:D.distr==3&&D.log==2?Hw:Lg)),M.font=Ag(M.font),M.labelFont=Ag(M.labelFont),M._size=M.size(n,null,T,0),M._space=M._rotate=M._incrs=M._found=M._splits=M._values=null,M._size>0&&(or[T]=!0,M._el=Pi(Eb,f))}}function Er(M,T,L,D){let[W,J,at,pt]=L,wt=T%2,Nt=0;return wt==0&&(pt||J)&&(Nt=T==0&&!W||T==2&&!at?Mn(dg.size/3):0),wt==1&&(W||at)&&(Nt=T==1&&!J||T==3&&!pt?Mn(gg.size/2):0),Nt}let pa=n.padding=(i.padding||[Er,Er,Er,Er]).map(M=>ye(we(M,Er))),Vi=n._padding=pa.map((M,T)=>M(n,T,or,0)),tn,ln=null,cn=null,ar=r==1?x[0].idxs:null,fi=null,Xr=!1;function ma(M,T){if(t=M??[],n.data=n._data=t,r==2){tn=0;for(let L=1;L<x.length;L++)tn+=t[L][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),fi=t[0],tn=fi.length;let L=t;if(O==2){L=t.slice();let D=L[0]=Array(tn);for(let W=0;W<tn;W++)D[W]=W}n._data=t=L}if(he(!0),Ln("setData"),O==2&&(bt=!0),T!==!1){let L=P;L.auto(n,Xr)?ga():jr(S,L.min,L.max),et=et||ct.left>=0,mt=!0,Xn()}}n.setData=ma;function ga(){Xr=!0;let M,T;r==1&&(tn>0?(ln=ar[0]=0,cn=ar[1]=tn-1,M=t[0][ln],T=t[0][cn],O==2?(M=ln,T=cn):M==T&&(O==3?[M,T]=Ql(M,M,P.log,!1):O==4?[M,T]=Pf(M,M,P.log,!1):P.time?T=M+Mn(86400/p):[M,T]=Zl(M,T,If,!0))):(ln=ar[0]=M=null,cn=ar[1]=T=null)),jr(S,M,T)}let to,$r,eo,R,H,Q,Y,Z,Tt,Lt;function Rt(M,T,L,D,W,J){M??=Gm,L??=Ff,D??="butt",W??=Gm,J??="round",M!=to&&(h.strokeStyle=to=M),W!=$r&&(h.fillStyle=$r=W),T!=eo&&(h.lineWidth=eo=T),J!=H&&(h.lineJoin=H=J),D!=Q&&(h.lineCap=Q=D),L!=R&&h.setLineDash(R=L)}function Ft(M,T,L,D){T!=$r&&(h.fillStyle=$r=T),M!=Y&&(h.font=Y=M),L!=Z&&(h.textAlign=Z=L),D!=Tt&&(h.textBaseline=Tt=D)}function Vt(M,T,L,D,W=0){if(D.length>0&&M.auto(n,Xr)&&(T==null||T.min==null)){let J=we(ln,0),at=we(cn,D.length-1),pt=L.min==null?Gb(D,J,at,W,M.distr==3):[L.min,L.max];M.min=Xi(M.min,L.min=pt[0]),M.max=ii(M.max,L.max=pt[1])}}let ie={min:null,max:null};function de(){for(let D in v){let W=v[D];V[D]==null&&(W.min==null||V[S]!=null&&W.auto(n,Xr))&&(V[D]=ie)}for(let D in v){let W=v[D];V[D]==null&&W.from!=null&&V[W.from]!=null&&(V[D]=ie)}V[S]!=null&&he(!0);let M={};for(let D in V){let W=V[D];if(W!=null){let J=M[D]=_o(v[D],Jb);if(W.min!=null)gn(J,W);else if(D!=S||r==2)if(tn==0&&J.from==null){let at=J.range(n,null,null,D);J.min=at[0],J.max=at[1]}else J.min=ke,J.max=-ke}}if(tn>0){x.forEach((D,W)=>{if(r==1){let J=D.scale,at=V[J];if(at==null)return;let pt=M[J];if(W==0){let wt=pt.range(n,pt.min,pt.max,J);pt.min=wt[0],pt.max=wt[1],ln=qi(pt.min,t[0]),cn=qi(pt.max,t[0]),cn-ln>1&&(t[0][ln]<pt.min&&ln++,t[0][cn]>pt.max&&cn--),D.min=fi[ln],D.max=fi[cn]}else D.show&&D.auto&&Vt(pt,at,D,t[W],D.sorted);D.idxs[0]=ln,D.idxs[1]=cn}else if(W>0&&D.show&&D.auto){let[J,at]=D.facets,pt=J.scale,wt=at.scale,[Nt,Dt]=t[W],Ut=M[pt],oe=M[wt];Ut!=null&&Vt(Ut,V[pt],J,Nt,J.sorted),oe!=null&&Vt(oe,V[wt],at,Dt,at.sorted),D.min=at.min,D.max=at.max}});for(let D in M){let W=M[D],J=V[D];if(W.from==null&&(J==null||J.min==null)){let at=W.range(n,W.min==ke?null:W.min,W.max==-ke?null:W.max,D);W.min=at[0],W.max=at[1]}}}for(let D in M){let W=M[D];if(W.from!=null){let J=M[W.from];if(J.min==null)W.min=W.max=null;else{let at=W.range(n,J.min,J.max,D);W.min=at[0],W.max=at[1]}}}let T={},L=!1;for(let D in M){let W=M[D],J=v[D];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let at=J.distr;J._min=at==3?Ir(J.min):at==4?df(J.min,J.asinh):at==100?J.fwd(J.min):J.min,J._max=at==3?Ir(J.max):at==4?df(J.max,J.asinh):at==100?J.fwd(J.max):J.max,T[D]=L=!0}}if(L){x.forEach((D,W)=>{r==2?W>0&&T.y&&(D._paths=null):T[D.scale]&&(D._paths=null)});for(let D in T)bt=!0,Ln("setScale",D);gt&&ct.left>=0&&(et=mt=!0)}for(let D in V)V[D]=null}function Bt(M){let T=bf(ln-1,0,tn-1),L=bf(cn+1,0,tn-1);for(;M[T]==null&&T>0;)T--;for(;M[L]==null&&L<tn-1;)L++;return[T,L]}function pe(){if(tn>0){let M=x.some(T=>T._focus)&&Lt!=kt.alpha;M&&(h.globalAlpha=Lt=kt.alpha),x.forEach((T,L)=>{if(L>0&&T.show&&(Je(L,!1),Je(L,!0),T._paths==null)){let D=Lt;Lt!=T.alpha&&(h.globalAlpha=Lt=T.alpha);let W=r==2?[0,t[L][0].length-1]:Bt(t[L]);T._paths=T.paths(n,L,W[0],W[1]),Lt!=D&&(h.globalAlpha=Lt=D)}}),x.forEach((T,L)=>{if(L>0&&T.show){let D=Lt;Lt!=T.alpha&&(h.globalAlpha=Lt=T.alpha),T._paths!=null&&Pe(L,!1);{let W=T._paths!=null?T._paths.gaps:null,J=T.points.show(n,L,ln,cn,W),at=T.points.filter(n,L,J,W);(J||at)&&(T.points._paths=T.points.paths(n,L,ln,cn,at),Pe(L,!0))}Lt!=D&&(h.globalAlpha=Lt=D),Ln("drawSeries",L)}}),M&&(h.globalAlpha=Lt=1)}}function Je(M,T){let L=T?x[M].points:x[M];L._stroke=L.stroke(n,M),L._fill=L.fill(n,M)}function Pe(M,T){let L=T?x[M].points:x[M],{stroke:D,fill:W,clip:J,flags:at,_stroke:pt=L._stroke,_fill:wt=L._fill,_width:Nt=L.width}=L._paths;Nt=Be(Nt*Se,3);let Dt=null,Ut=Nt%2/2;T&&wt==null&&(wt=Nt>0?"#fff":pt);let oe=L.pxAlign==1&&Ut>0;if(oe&&h.translate(Ut,Ut),!T){let Me=I-Nt/2,be=E-Nt/2,me=X+Nt,Qt=ft+Nt;Dt=new Path2D,Dt.rect(Me,be,me,Qt)}T?Ot(pt,Nt,L.dash,L.cap,wt,D,W,at,J):Ie(M,pt,Nt,L.dash,L.cap,wt,D,W,at,Dt,J),oe&&h.translate(-Ut,-Ut)}function Ie(M,T,L,D,W,J,at,pt,wt,Nt,Dt){let Ut=!1;wt!=0&&A.forEach((oe,Me)=>{if(oe.series[0]==M){let be=x[oe.series[1]],me=t[oe.series[1]],Qt=(be._paths||Ra).band;Kr(Qt)&&(Qt=oe.dir==1?Qt[0]:Qt[1]);let Xt,Xe=null;be.show&&Qt&&Wb(me,ln,cn)?(Xe=oe.fill(n,Me)||J,Xt=be._paths.clip):Qt=null,Ot(T,L,D,W,Xe,at,pt,wt,Nt,Dt,Xt,Qt),Ut=!0}}),Ut||Ot(T,L,D,W,J,at,pt,wt,Nt,Dt)}let vn=vo|Sf;function Ot(M,T,L,D,W,J,at,pt,wt,Nt,Dt,Ut){Rt(M,T,L,D,W),(wt||Nt||Ut)&&(h.save(),wt&&h.clip(wt),Nt&&h.clip(Nt)),Ut?(pt&vn)==vn?(h.clip(Ut),Dt&&h.clip(Dt),ge(W,at),fn(M,J,T)):pt&Sf?(ge(W,at),h.clip(Ut),fn(M,J,T)):pt&vo&&(h.save(),h.clip(Ut),Dt&&h.clip(Dt),ge(W,at),h.restore(),fn(M,J,T)):(ge(W,at),fn(M,J,T)),(wt||Nt||Ut)&&h.restore()}function fn(M,T,L){L>0&&(T instanceof Map?T.forEach((D,W)=>{h.strokeStyle=to=W,h.stroke(D)}):T!=null&&M&&h.stroke(T))}function ge(M,T){T instanceof Map?T.forEach((L,D)=>{h.fillStyle=$r=D,h.fill(L)}):T!=null&&M&&h.fill(T)}function Tr(M,T,L,D){let W=b[M],J;if(D<=0)J=[0,0];else{let at=W._space=W.space(n,M,T,L,D),pt=W._incrs=W.incrs(n,M,T,L,D,at);J=hM(T,L,pt,D,at)}return W._found=J}function dn(M,T,L,D,W,J,at,pt,wt,Nt){let Dt=at%2/2;y==1&&h.translate(Dt,Dt),Rt(pt,at,wt,Nt,pt),h.beginPath();let Ut,oe,Me,be,me=W+(D==0||D==3?-J:J);L==0?(oe=W,be=me):(Ut=W,Me=me);for(let Qt=0;Qt<M.length;Qt++)T[Qt]!=null&&(L==0?Ut=Me=M[Qt]:oe=be=M[Qt],h.moveTo(Ut,oe),h.lineTo(Me,be));h.stroke(),y==1&&h.translate(-Dt,-Dt)}function no(M){let T=!0;return b.forEach((L,D)=>{if(!L.show)return;let W=v[L.scale];if(W.min==null){L._show&&(T=!1,L._show=!1,he(!1));return}else L._show||(T=!1,L._show=!0,he(!1));let J=L.side,at=J%2,{min:pt,max:wt}=W,[Nt,Dt]=Tr(D,pt,wt,at==0?k:Pt);if(Dt==0)return;let Ut=W.distr==2,oe=L._splits=L.splits(n,D,pt,wt,Nt,Dt,Ut),Me=W.distr==2?oe.map(Xt=>fi[Xt]):oe,be=W.distr==2?fi[oe[1]]-fi[oe[0]]:Nt,me=L._values=L.values(n,L.filter(n,Me,D,Dt,be),D,Dt,be);L._rotate=J==2?L.rotate(n,me,D,Dt):0;let Qt=L._size;L._size=Ii(L.size(n,me,D,M)),Qt!=null&&L._size!=Qt&&(T=!1)}),T}function lr(M){let T=!0;return pa.forEach((L,D)=>{let W=L(n,D,or,M);W!=Vi[D]&&(T=!1),Vi[D]=W}),T}function Rr(){for(let M=0;M<b.length;M++){let T=b[M];if(!T.show||!T._show)continue;let L=T.side,D=L%2,W,J,at=T.stroke(n,M),pt=L==0||L==3?-1:1,[wt,Nt]=T._found;if(T.label!=null){let ti=T.labelGap*pt,mi=Mn((T._lpos+ti)*Se);Ft(T.labelFont[0],at,"center",L==2?"top":Vm),h.save(),D==1?(W=J=0,h.translate(mi,Mn(E+ft/2)),h.rotate((L==3?-Yl:Yl)/2)):(W=Mn(I+X/2),J=mi);let Ss=Pg(T.label)?T.label(n,M,wt,Nt):T.label;h.fillText(Ss,W,J),h.restore()}if(Nt==0)continue;let Dt=v[T.scale],Ut=D==0?X:ft,oe=D==0?I:E,Me=T._splits,be=Dt.distr==2?Me.map(ti=>fi[ti]):Me,me=Dt.distr==2?fi[Me[1]]-fi[Me[0]]:wt,Qt=T.ticks,Xt=T.border,Xe=Qt.show?Qt.size:0,nn=Mn(Xe*Se),Fn=Mn((T.alignTo==2?T._size-Xe-T.gap:T.gap)*Se),Oe=T._rotate*-Yl/180,rn=g(T._pos*Se),di=(nn+Fn)*pt,Qn=rn+di;J=D==0?Qn:0,W=D==1?Qn:0;let Ti=T.font[0],Gi=T.align==1?po:T.align==2?uf:Oe>0?po:Oe<0?uf:D==0?"center":L==3?uf:po,hr=Oe||D==1?"middle":L==2?"top":Vm;Ft(Ti,at,Gi,hr);let pi=T.font[1]*T.lineGap,Ri=Me.map(ti=>g(a(ti,Dt,Ut,oe))),Hi=T._values;for(let ti=0;ti<Hi.length;ti++){let mi=Hi[ti];if(mi!=null){D==0?W=Ri[ti]:J=Ri[ti],mi=""+mi;let Ss=mi.indexOf(`
`)==-1?[mi]:mi.split(/\n/gm);for(let ei=0;ei<Ss.length;ei++){let xm=Ss[ei];Oe?(h.save(),h.translate(W,J+ei*pi),h.rotate(Oe),h.fillText(xm,0,0),h.restore()):h.fillText(xm,W,J+ei*pi)}}}Qt.show&&dn(Ri,Qt.filter(n,be,M,Nt,me),D,L,rn,nn,Be(Qt.width*Se,3),Qt.stroke(n,M),Qt.dash,Qt.cap);let fr=T.grid;fr.show&&dn(Ri,fr.filter(n,be,M,Nt,me),D,D==0?2:1,D==0?E:I,D==0?ft:X,Be(fr.width*Se,3),fr.stroke(n,M),fr.dash,fr.cap),Xt.show&&dn([rn],[1],D==0?1:0,D==0?1:2,D==1?E:I,D==1?ft:X,Be(Xt.width*Se,3),Xt.stroke(n,M),Xt.dash,Xt.cap)}Ln("drawAxes")}function he(M){x.forEach((T,L)=>{L>0&&(T._paths=null,M&&(r==1?(T.min=null,T.max=null):T.facets.forEach(D=>{D.min=null,D.max=null})))})}let en=!1,Kn=!1,Le=[];function pn(){Kn=!1;for(let M=0;M<Le.length;M++)Ln(...Le[M]);Le.length=0}function Xn(){en||(rw(tm),en=!0)}function Ul(M,T=!1){en=!0,Kn=T,M(n),tm(),T&&Le.length>0&&queueMicrotask(pn)}n.batch=Ul;function tm(){if(ot&&(de(),ot=!1),bt&&(Et(),bt=!1),vt){if(Ye(d,po,Jt),Ye(d,"top",ae),Ye(d,Sa,k),Ye(d,Aa,Pt),Ye(m,po,Jt),Ye(m,"top",ae),Ye(m,Sa,k),Ye(m,Aa,Pt),Ye(f,Sa,Qe),Ye(f,Aa,hn),u.width=Mn(Qe*Se),u.height=Mn(hn*Se),b.forEach(({_el:M,_show:T,_size:L,_pos:D,side:W})=>{if(M!=null)if(T){let J=W===3||W===0?L:0,at=W%2==1;Ye(M,at?"left":"top",D-J),Ye(M,at?"width":"height",L),Ye(M,at?"top":"left",at?ae:Jt),Ye(M,at?"height":"width",at?Pt:k),_f(M,Ts)}else gi(M,Ts)}),to=$r=eo=H=Q=Y=Z=Tt=R=null,Lt=1,_a(!0),Jt!=At||ae!=Ue||k!=Gt||Pt!=jt){he(!1);let M=k/Gt,T=Pt/jt;if(gt&&!et&&ct.left>=0){ct.left*=M,ct.top*=T,io&&dr(io,Mn(ct.left),0,k,Pt),ro&&dr(ro,0,Mn(ct.top),k,Pt);for(let L=0;L<ue.length;L++){let D=ue[L];D!=null&&(He[L]*=M,Jn[L]*=T,dr(D,Ii(He[L]),Ii(Jn[L]),k,Pt))}}if(qe.show&&!it&&qe.left>=0&&qe.width>0){qe.left*=M,qe.width*=M,qe.top*=T,qe.height*=T;for(let L in Qh)Ye(ao,L,qe[L])}At=Jt,Ue=ae,Gt=k,jt=Pt}Ln("setSize"),vt=!1}Qe>0&&hn>0&&(h.clearRect(0,0,u.width,u.height),Ln("drawClear"),w.forEach(M=>M()),Ln("draw")),qe.show&&it&&(kl(qe),it=!1),gt&&et&&(Ms(null,!0,!1),et=!1),ut.show&&ut.live&&mt&&(Jh(),mt=!1),l||(l=!0,n.status=1,Ln("ready")),Xr=!1,en=!1}n.redraw=(M,T)=>{bt=T||!1,M!==!1?jr(S,P.min,P.max):Xn()};function Yh(M,T){let L=v[M];if(L.from==null){if(tn==0){let D=L.range(n,T.min,T.max,M);T.min=D[0],T.max=D[1]}if(T.min>T.max){let D=T.min;T.min=T.max,T.max=D}if(tn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;M==S&&L.distr==2&&tn>0&&(T.min=qi(T.min,t[0]),T.max=qi(T.max,t[0]),T.min==T.max&&T.max++),V[M]=T,ot=!0,Xn()}}n.setScale=Yh;let jh,Zh,io,ro,em,nm,so,oo,im,rm,We,Ze,Yr=!1,Bn=ct.drag,Pn=Bn.x,In=Bn.y;gt&&(ct.x&&(jh=Pi(Rb,m)),ct.y&&(Zh=Pi(Cb,m)),P.ori==0?(io=jh,ro=Zh):(io=Zh,ro=jh),We=ct.left,Ze=ct.top);let qe=n.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),ao=qe.show?Pi(Tb,qe.over?m:d):null;function kl(M,T){if(qe.show){for(let L in M)qe[L]=M[L],L in Qh&&Ye(ao,L,M[L]);T!==!1&&Ln("setSelect")}}n.setSelect=kl;function Bv(M){if(x[M].show)K&&_f(te[M],Ts);else if(K&&gi(te[M],Ts),gt){let L=Ct?ue[0]:ue[M];L!=null&&dr(L,-10,-10,k,Pt)}}function jr(M,T,L){Yh(M,{min:T,max:L})}function cr(M,T,L,D){T.focus!=null&&Wv(M),T.show!=null&&x.forEach((W,J)=>{J>0&&(M==J||M==null)&&(W.show=T.show,Bv(J),r==2?(jr(W.facets[0].scale,null,null),jr(W.facets[1].scale,null,null)):jr(W.scale,null,null),Xn())}),L!==!1&&Ln("setSeries",M,T),D&&va("setSeries",n,M,T)}n.setSeries=cr;function zv(M,T){gn(A[M],T)}function Vv(M,T){M.fill=ye(M.fill||null),M.dir=we(M.dir,-1),T=T??A.length,A.splice(T,0,M)}function Gv(M){M==null?A.length=0:A.splice(M,1)}n.addBand=Vv,n.setBand=zv,n.delBand=Gv;function Hv(M,T){x[M].alpha=T,gt&&ue[M]!=null&&(ue[M].style.opacity=T),K&&te[M]&&(te[M].style.opacity=T)}let Cr,Zr,ws,lo={focus:!0};function Wv(M){if(M!=ws){let T=M==null,L=kt.alpha!=1;x.forEach((D,W)=>{if(r==1||W>0){let J=T||W==0||W==M;D._focus=T?null:J,L&&Hv(W,J?1:kt.alpha)}}),ws=M,L&&Xn()}}K&&ne&&ve(qm,Mt,M=>{ct._lock||(ee(M),ws!=null&&cr(null,lo,!0,mn.setSeries))});function ur(M,T,L){let D=v[T];L&&(M=M/Se-(D.ori==1?ae:Jt));let W=k;D.ori==1&&(W=Pt,M=W-M),D.dir==-1&&(M=W-M);let J=D._min,at=D._max,pt=M/W,wt=J+(at-J)*pt,Nt=D.distr;return Nt==3?yo(10,wt):Nt==4?Xb(wt,D.asinh):Nt==100?D.bwd(wt):wt}function qv(M,T){let L=ur(M,S,T);return qi(L,t[0],ln,cn)}n.valToIdx=M=>qi(M,t[0]),n.posToIdx=qv,n.posToVal=ur,n.valToPos=(M,T,L)=>v[T].ori==0?s(M,v[T],L?X:k,L?I:0):o(M,v[T],L?ft:Pt,L?E:0),n.setCursor=(M,T,L)=>{We=M.left,Ze=M.top,Ms(null,T,L)};function sm(M,T){Ye(ao,po,qe.left=M),Ye(ao,Sa,qe.width=T)}function om(M,T){Ye(ao,"top",qe.top=M),Ye(ao,Aa,qe.height=T)}let ya=P.ori==0?sm:om,xa=P.ori==1?sm:om;function Xv(){if(K&&ut.live)for(let M=r==2?1:0;M<x.length;M++){if(M==0&&qt)continue;let T=ut.values[M],L=0;for(let D in T)dt[M][L++].firstChild.nodeValue=T[D]}}function Jh(M,T){if(M!=null&&(M.idxs?M.idxs.forEach((L,D)=>{tt[D]=L}):Zb(M.idx)||tt.fill(M.idx),ut.idx=tt[0]),K&&ut.live){for(let L=0;L<x.length;L++)(L>0||r==1&&!qt)&&$v(L,tt[L]);Xv()}mt=!1,T!==!1&&Ln("setLegend")}n.setLegend=Jh;function $v(M,T){let L=x[M],D=M==0&&O==2?fi:t[M],W;qt?W=L.values(n,M,T)??Yt:(W=L.value(n,T==null?null:D[T],M,T),W=W==null?Yt:{_:W}),ut.values[M]=W}function Ms(M,T,L){im=We,rm=Ze,[We,Ze]=ct.move(n,We,Ze),ct.left=We,ct.top=Ze,gt&&(io&&dr(io,Mn(We),0,k,Pt),ro&&dr(ro,0,Mn(Ze),k,Pt));let D,W=ln>cn;Cr=ke,Zr=null;let J=P.ori==0?k:Pt,at=P.ori==1?k:Pt;if(We<0||tn==0||W){D=ct.idx=null;for(let pt=0;pt<x.length;pt++){let wt=ue[pt];wt!=null&&dr(wt,-10,-10,k,Pt)}ne&&cr(null,lo,!0,M==null&&mn.setSeries),ut.live&&(tt.fill(D),mt=!0)}else{let pt,wt,Nt;r==1&&(pt=P.ori==0?We:Ze,wt=ur(pt,S),D=ct.idx=qi(wt,t[0],ln,cn),Nt=B(t[0][D],P,J,0));let Dt=-10,Ut=-10,oe=0,Me=0,be=!0,me="",Qt="";for(let Xt=r==2?1:0;Xt<x.length;Xt++){let Xe=x[Xt],nn=tt[Xt],Fn=nn==null?null:r==1?t[Xt][nn]:t[Xt][1][nn],Oe=ct.dataIdx(n,Xt,D,wt),rn=Oe==null?null:r==1?t[Xt][Oe]:t[Xt][1][Oe];if(mt=mt||rn!=Fn||Oe!=nn,tt[Xt]=Oe,Xt>0&&Xe.show){let di=Oe==null?-10:Oe==D?Nt:B(r==1?t[0][Oe]:t[Xt][0][Oe],P,J,0),Qn=rn==null?-10:F(rn,r==1?v[Xe.scale]:v[Xe.facets[1].scale],at,0);if(ne&&rn!=null){let Ti=P.ori==1?We:Ze,Gi=Sn(kt.dist(n,Xt,Oe,Qn,Ti));if(Gi<Cr){let hr=kt.bias;if(hr!=0){let pi=ur(Ti,Xe.scale),Ri=rn>=0?1:-1,Hi=pi>=0?1:-1;Hi==Ri&&(Hi==1?hr==1?rn>=pi:rn<=pi:hr==1?rn<=pi:rn>=pi)&&(Cr=Gi,Zr=Xt)}else Cr=Gi,Zr=Xt}}if(mt||Ct){let Ti,Gi;P.ori==0?(Ti=di,Gi=Qn):(Ti=Qn,Gi=di);let hr,pi,Ri,Hi,fr,ti,mi=!0,Ss=ht.bbox;if(Ss!=null){mi=!1;let ei=Ss(n,Xt);Ri=ei.left,Hi=ei.top,hr=ei.width,pi=ei.height}else Ri=Ti,Hi=Gi,hr=pi=ht.size(n,Xt);if(ti=ht.fill(n,Xt),fr=ht.stroke(n,Xt),Ct)Xt==Zr&&Cr<=kt.prox&&(Dt=Ri,Ut=Hi,oe=hr,Me=pi,be=mi,me=ti,Qt=fr);else{let ei=ue[Xt];ei!=null&&(He[Xt]=Ri,Jn[Xt]=Hi,Km(ei,hr,pi,mi),Zm(ei,ti,fr),dr(ei,Ii(Ri),Ii(Hi),k,Pt))}}}}if(Ct){let Xt=kt.prox,Xe=ws==null?Cr<=Xt:Cr>Xt||Zr!=ws;if(mt||Xe){let nn=ue[0];nn!=null&&(He[0]=Dt,Jn[0]=Ut,Km(nn,oe,Me,be),Zm(nn,me,Qt),dr(nn,Ii(Dt),Ii(Ut),k,Pt))}}}if(qe.show&&Yr)if(M!=null){let[pt,wt]=mn.scales,[Nt,Dt]=mn.match,[Ut,oe]=M.cursor.sync.scales,Me=M.cursor.drag;if(Pn=Me._x,In=Me._y,Pn||In){let{left:be,top:me,width:Qt,height:Xt}=M.select,Xe=M.scales[Ut].ori,nn=M.posToVal,Fn,Oe,rn,di,Qn,Ti=pt!=null&&Nt(pt,Ut),Gi=wt!=null&&Dt(wt,oe);Ti&&Pn?(Xe==0?(Fn=be,Oe=Qt):(Fn=me,Oe=Xt),rn=v[pt],di=B(nn(Fn,Ut),rn,J,0),Qn=B(nn(Fn+Oe,Ut),rn,J,0),ya(Xi(di,Qn),Sn(Qn-di))):ya(0,J),Gi&&In?(Xe==1?(Fn=be,Oe=Qt):(Fn=me,Oe=Xt),rn=v[wt],di=F(nn(Fn,oe),rn,at,0),Qn=F(nn(Fn+Oe,oe),rn,at,0),xa(Xi(di,Qn),Sn(Qn-di))):xa(0,at)}else tf()}else{let pt=Sn(im-em),wt=Sn(rm-nm);if(P.ori==1){let oe=pt;pt=wt,wt=oe}Pn=Bn.x&&pt>=Bn.dist,In=Bn.y&&wt>=Bn.dist;let Nt=Bn.uni;Nt!=null?Pn&&In&&(Pn=pt>=Nt,In=wt>=Nt,!Pn&&!In&&(wt>pt?In=!0:Pn=!0)):Bn.x&&Bn.y&&(Pn||In)&&(Pn=In=!0);let Dt,Ut;Pn&&(P.ori==0?(Dt=so,Ut=We):(Dt=oo,Ut=Ze),ya(Xi(Dt,Ut),Sn(Ut-Dt)),In||xa(0,at)),In&&(P.ori==1?(Dt=so,Ut=We):(Dt=oo,Ut=Ze),xa(Xi(Dt,Ut),Sn(Ut-Dt)),Pn||ya(0,J)),!Pn&&!In&&(ya(0,0),xa(0,0))}if(Bn._x=Pn,Bn._y=In,M==null){if(L){if(ym!=null){let[pt,wt]=mn.scales;mn.values[0]=pt!=null?ur(P.ori==0?We:Ze,pt):null,mn.values[1]=wt!=null?ur(P.ori==1?We:Ze,wt):null}va(hf,n,We,Ze,k,Pt,D)}if(ne){let pt=L&&mn.setSeries,wt=kt.prox;ws==null?Cr<=wt&&cr(Zr,lo,!0,pt):Cr>wt?cr(null,lo,!0,pt):Zr!=ws&&cr(Zr,lo,!0,pt)}}mt&&(ut.idx=D,Jh()),T!==!1&&Ln("setCursor")}let Jr=null;Object.defineProperty(n,"rect",{get(){return Jr==null&&_a(!1),Jr}});function _a(M=!1){M?Jr=null:(Jr=m.getBoundingClientRect(),Ln("syncRect",Jr))}function am(M,T,L,D,W,J,at){ct._lock||Yr&&M!=null&&M.movementX==0&&M.movementY==0||(Kh(M,T,L,D,W,J,at,!1,M!=null),M!=null?Ms(null,!0,!0):Ms(T,!0,!1))}function Kh(M,T,L,D,W,J,at,pt,wt){if(Jr==null&&_a(!1),ee(M),M!=null)L=M.clientX-Jr.left,D=M.clientY-Jr.top;else{if(L<0||D<0){We=-10,Ze=-10;return}let[Nt,Dt]=mn.scales,Ut=T.cursor.sync,[oe,Me]=Ut.values,[be,me]=Ut.scales,[Qt,Xt]=mn.match,Xe=T.axes[0].side%2==1,nn=P.ori==0?k:Pt,Fn=P.ori==1?k:Pt,Oe=Xe?J:W,rn=Xe?W:J,di=Xe?D:L,Qn=Xe?L:D;if(be!=null?L=Qt(Nt,be)?a(oe,v[Nt],nn,0):-10:L=nn*(di/Oe),me!=null?D=Xt(Dt,me)?a(Me,v[Dt],Fn,0):-10:D=Fn*(Qn/rn),P.ori==1){let Ti=L;L=D,D=Ti}}wt&&(T==null||T.cursor.event.type==hf)&&((L<=1||L>=k-1)&&(L=As(L,k)),(D<=1||D>=Pt-1)&&(D=As(D,Pt))),pt?(em=L,nm=D,[so,oo]=ct.move(n,L,D)):(We=L,Ze=D)}let Qh={width:0,height:0,left:0,top:0};function tf(){kl(Qh,!1)}let lm,cm,um,hm;function fm(M,T,L,D,W,J,at){Yr=!0,Pn=In=Bn._x=Bn._y=!1,Kh(M,T,L,D,W,J,at,!0,!1),M!=null&&(ve(ff,yf,dm,!1),va(Hm,n,so,oo,k,Pt,null));let{left:pt,top:wt,width:Nt,height:Dt}=qe;lm=pt,cm=wt,um=Nt,hm=Dt}function dm(M,T,L,D,W,J,at){Yr=Bn._x=Bn._y=!1,Kh(M,T,L,D,W,J,at,!1,!0);let{left:pt,top:wt,width:Nt,height:Dt}=qe,Ut=Nt>0||Dt>0,oe=lm!=pt||cm!=wt||um!=Nt||hm!=Dt;if(Ut&&oe&&kl(qe),Bn.setScale&&Ut&&oe){let Me=pt,be=Nt,me=wt,Qt=Dt;if(P.ori==1&&(Me=wt,be=Dt,me=pt,Qt=Nt),Pn&&jr(S,ur(Me,S),ur(Me+be,S)),In)for(let Xt in v){let Xe=v[Xt];Xt!=S&&Xe.from==null&&Xe.min!=ke&&jr(Xt,ur(me+Qt,Xt),ur(me,Xt))}tf()}else ct.lock&&(ct._lock=!ct._lock,Ms(T,!0,M!=null));M!=null&&(_n(ff,yf),va(ff,n,We,Ze,k,Pt,null))}function Yv(M,T,L,D,W,J,at){if(ct._lock)return;ee(M);let pt=Yr;if(Yr){let wt=!0,Nt=!0,Dt=10,Ut,oe;P.ori==0?(Ut=Pn,oe=In):(Ut=In,oe=Pn),Ut&&oe&&(wt=We<=Dt||We>=k-Dt,Nt=Ze<=Dt||Ze>=Pt-Dt),Ut&&wt&&(We=We<so?0:k),oe&&Nt&&(Ze=Ze<oo?0:Pt),Ms(null,!0,!0),Yr=!1}We=-10,Ze=-10,tt.fill(null),Ms(null,!0,!0),pt&&(Yr=pt)}function pm(M,T,L,D,W,J,at){ct._lock||(ee(M),ga(),tf(),M!=null&&va(Xm,n,We,Ze,k,Pt,null))}function mm(){b.forEach(fM),U(n.width,n.height,!0)}Rs(jl,go,mm);let co={};co.mousedown=fm,co.mousemove=am,co.mouseup=dm,co.dblclick=pm,co.setSeries=(M,T,L,D)=>{let W=mn.match[2];L=W(n,T,L),L!=-1&&cr(L,D,!0,!1)},gt&&(ve(Hm,m,fm),ve(hf,m,am),ve(Wm,m,M=>{ee(M),_a(!1)}),ve(qm,m,Yv),ve(Xm,m,pm),Af.add(n),n.syncRect=_a);let Bl=n.hooks=i.hooks||{};function Ln(M,T,L){Kn?Le.push([M,T,L]):M in Bl&&Bl[M].forEach(D=>{D.call(null,n,T,L)})}(i.plugins||[]).forEach(M=>{for(let T in M.hooks)Bl[T]=(Bl[T]||[]).concat(M.hooks[T])});let gm=(M,T,L)=>L,mn=gn({key:null,setSeries:!1,filters:{pub:ig,sub:ig},scales:[S,x[1]?x[1].scale:null],match:[rg,rg,gm],values:[null,null]},ct.sync);mn.match.length==2&&mn.match.push(gm),ct.sync=mn;let ym=mn.key,ef=t0(ym);function va(M,T,L,D,W,J,at){mn.filters.pub(M,T,L,D,W,J,at)&&ef.pub(M,T,L,D,W,J,at)}ef.sub(n);function jv(M,T,L,D,W,J,at){mn.filters.sub(M,T,L,D,W,J,at)&&co[M](null,T,L,D,W,J,at)}n.pub=jv;function Zv(){ef.unsub(n),Af.delete(n),Cn.clear(),vf(jl,go,mm),c.remove(),Mt?.remove(),Ln("destroy")}n.destroy=Zv;function nf(){Ln("init",i,t),ma(t||i.data,!1),V[S]?Yh(S,V[S]):ga(),it=qe.show&&(qe.width>0||qe.height>0),et=mt=!0,U(i.width,i.height)}return x.forEach(Qs),b.forEach(Ar),e?e instanceof HTMLElement?(e.appendChild(c),nf()):e(n,nf):nf(),n}yn.assign=gn;yn.fmtNum=Lf;yn.rangeNum=Zl;yn.rangeLog=Ql;yn.rangeAsinh=Pf;yn.orient=Ps;yn.pxRatio=Se;yn.join=iw;yn.fmtDate=Nf,yn.tzDate=pw;yn.sync=t0;{yn.addGap=Zw,yn.clipGaps=nc;let i=yn.paths={points:o0};i.linear=l0,i.stepped=Qw,i.bars=tM,i.spline=nM}var f0="12px system-ui, sans-serif",d0=2;function p0(i,t,e,n){let r={stroke:()=>Ci("--grid"),width:1},s={stroke:()=>Ci("--quiet"),font:f0,grid:r,ticks:{...r,size:4}},o={width:Math.max(i.clientWidth,120),height:n.height,legend:{show:!1},padding:[10,14,0,0],scales:{x:{time:!1},y:n.log?{distr:3,range:(l,c,u)=>pM(c,u,n.decades)}:{range:(l,c,u)=>dM(c,u)}},axes:[{...s,label:n.abscissa,labelSize:18,labelFont:f0,size:30,values:(l,c)=>c.map(ni)},{...s,size:(l,c)=>16+7*Math.max(2,...(c??[]).map(u=>u.length)),values:(l,c)=>c.map(u=>u===null?"":n.log?mM(u):ni(u))}],series:[{},...e.map(l=>({stroke:()=>Ci(l.property),width:l.width,dash:l.dash,alpha:l.ghost?.35:1,spanGaps:!0,points:{show:!1}}))],cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!0,dist:d0},bind:{mousedown:(l,c,u)=>h=>h.shiftKey?u(h):null,dblclick:()=>()=>(n.zoomed(null),null)}},hooks:{setSelect:[l=>gM(l,n)],setCursor:[l=>n.hovered(l.cursor.left===void 0||l.cursor.left<0?null:l.posToVal(l.cursor.left,"x"))],draw:[l=>xM(l,n.marks)]}},a=new yn(o,t,i);return yM(a,n),a}function dM(i,t){if(i===null||t===null||!Number.isFinite(i)||!Number.isFinite(t))return[0,1];let e=Math.max(Math.abs(i),Math.abs(t)),n=e>1e-9?.05*e:.05;if(t-i<=1e-9*e||e<=1e-12)return[(i+t)/2-n,(i+t)/2+n];let r=.07*(t-i);return[i-r,t+r]}function pM(i,t,e){if(i===null||t===null||!(t>0))return[.1,1];let n=Math.max(i>0?i:t,t*10**-e);return[10**Math.floor(Math.log10(n)+1e-9),t*1.6]}function mM(i){let t=Math.log10(i);return Math.abs(t-Math.round(t))>1e-6?"":ni(i).replace(/^1\u00a0×\u00a0|^1\.0\u00a0×\u00a0/,"")}function gM(i,t){i.select.width<d0||(t.zoomed([i.posToVal(i.select.left,"x"),i.posToVal(i.select.left+i.select.width,"x")]),i.setSelect({left:0,top:0,width:0,height:0},!1))}function yM(i,t){let e=i.over,n=r=>t.chosen(i.posToVal(r.clientX-e.getBoundingClientRect().left,"x"));e.addEventListener("pointerdown",r=>{r.shiftKey||r.button!==0||(e.setPointerCapture(r.pointerId),n(r))}),e.addEventListener("pointermove",r=>{e.hasPointerCapture(r.pointerId)&&n(r)})}function xM(i,t){let{ctx:e,bbox:n}=i,r=yn.pxRatio,s=-1/0;e.save(),e.fillStyle=Ci("--quiet"),e.font=`${11*r}px system-ui, sans-serif`,e.lineJoin="round";for(let{at:o}of t){let a=i.valToPos(o,"x",!0);if(a<n.left||a>n.left+n.width)continue;[e.strokeStyle,e.lineWidth]=[Ci("--quiet"),r],e.setLineDash([3*r,3*r]),e.beginPath(),e.moveTo(a,n.top),e.lineTo(a,n.top+n.height),e.stroke(),[e.strokeStyle,e.lineWidth]=[Ci("--panel"),4*r],e.setLineDash([]);let l=`${ni(Number(o.toPrecision(3)))} Hz`;if(a>s&&a+e.measureText(l).width<n.left+n.width){let c=[l,a+3*r,n.top+11*r];e.strokeText(...c),e.fillText(...c),s=a+e.measureText(l).width+8*r}}e.restore()}var m0={spectrum:5,other:6},_M=190,vM=1e-9,bM=100;function g0(i,t,e){let{chart:n}=i,r=n.abscissa==="time",s=Pr("chart"),o=n.unit==="–"?"":n.unit,a=n.log==="first",l=null,c=!0,u=of(i,null),h=n.marks,f=0,d=null,m=null,y=null,g=!1,p=!0,x="",b=0,v=0,A=0,S=lt("div",{class:"plot-area",role:"img"}),_=lt("span",{class:"readout"}),w=bn("log",()=>q(!a),{class:"tool","aria-pressed":String(a),title:"Logarithmic ordinate, of the size of the values",hidden:n.log==="no"}),N=bn("reset zoom",()=>e.set(null),{class:"tool",hidden:!0}),C=lt("div",{class:"tools"},N,w,bn("CSV",yt,{class:"tool",title:"Save the data of this chart as CSV"})),P=lt("h4",{id:s,text:n.title},lt("span",{class:"unit",text:o?` [${o}]`:""})),O=lt("p",{class:"note",hidden:!r||Wl(lf(i))>=1,text:Om(lf(i))}),B=lt("p",{class:"note",hidden:!0,text:"The marked frequencies are of the run as it was."}),F=Bm(u,i.compared,G),V=lt("figure",{class:"chart","aria-labelledby":s,"data-chart":n.id},lt("figcaption",{},P,_,C),S,F.element,O,B);function q(dt){a=dt,w.setAttribute("aria-pressed",String(dt)),G()}function G(){p=!0,g&&$()}function rt(){if(c)return u;c=!0,u=of(i,l);let dt=cf(n,l);return h=dt?km(dt,u):n.marks,F.renew(u),u}function $(){if(!p||f===0)return;p=!1;let dt=rt().filter(_e=>F.shows(_e)),Wt=dt.map(_e=>({...F.look(_e),width:_e.ghost?1:_e.role==="real"?1.6:1.3,ghost:_e.ghost})),qt=Gl(dt,a);v=Math.max(0,...dt.map(_e=>Math.max(...Hl(_e.y).map(Math.abs))));let Yt=JSON.stringify([Wt,h,a,f,b]);d&&Yt===x?d.setData(qt):j(qt,Wt),x=Yt,S.setAttribute("aria-label",af(n,o,dt)),r&&tt(e.range),K()}function j(dt,Wt){d?.destroy(),y=null,d=p0(S,dt,Wt,{log:a,decades:n.group==="spectrum"?m0.spectrum:m0.other,height:_M,marks:h,abscissa:r?"time [s]":"frequency [Hz]",zoomed:qt=>r?e.set(qt):tt(qt),hovered:qt=>{y=qt,K()},chosen:qt=>{r&&t.seek(qt)}}),m=r?lt("div",{class:"time-line"}):null,m&&d.over.append(m)}function tt(dt){let Wt=d?.data[0];if(N.hidden=dt===null,!d||!Wt?.length)return;let[qt,Yt]=dt??[Wt[0],Wt[Wt.length-1]];Yt>qt&&d.setScale("x",{min:qt,max:Yt}),queueMicrotask(ut)}function ut(){if(!d||!m)return;let dt=d.valToPos(t.time,"x"),Wt=d.valToPos(d.scales.x.max??0,"x"),qt=dt>=-.5&&dt<=Wt+.5;m.style.display=qt?"":"none",m.style.transform=`translateX(${dt}px)`}function ct(){ut(),(!t.playing||performance.now()-A>bM)&&K()}function K(){A=performance.now();let dt=y??(r?t.time:null);wn(_,y===null?"":r?`at ${y.toFixed(3)} s`:`at ${$n(y,"Hz")}`),F.tell(Wt=>dt===null?null:gt(Dm(Wt,dt)))}function gt(dt){return dt!==null&&Math.abs(dt)<vM*v&&!a?0:dt}function yt(){uo(Um(rt().filter(dt=>F.shows(dt)),r?"time [s]":"frequency [Hz]",o),`${n.id}.csv`,"text/csv")}let Mt=new IntersectionObserver(dt=>{g=dt.some(Wt=>Wt.isIntersecting),g&&$(),g&&K()},{rootMargin:"120px"}),xt=new ResizeObserver(()=>{f=S.clientWidth,g&&f>0&&G()}),zt=()=>{b+=1,p=!0,$()};addEventListener("beforeprint",zt),addEventListener("afterprint",zt),Mt.observe(V),S.setAttribute("aria-label",af(n,o,u.filter(dt=>F.shows(dt)))),xt.observe(S);let te=[t.subscribe(()=>{g&&r&&ct()}),e.subscribe(()=>r&&tt(e.range))];return{element:V,id:n.id,show(dt){l=dt,c=!1,B.hidden=dt===null||cf(n,dt)!==null||n.marks.length===0,G()},recolour(){b+=1,G()},dispose(){removeEventListener("beforeprint",zt),removeEventListener("afterprint",zt),Mt.disconnect(),xt.disconnect(),te.forEach(dt=>dt()),d?.destroy()}}}function y0(){let i=new Set,t={range:null};return{get range(){return t.range},set(e){e===t.range||e&&t.range&&e.every((r,s)=>r===t.range?.[s])||(t.range=e,i.forEach(r=>r()))},subscribe(e){return i.add(e),()=>i.delete(e)}}}var x0={overview:"Overview",tip:"Tip",contact:"Contact",deformations:"Deformations",motors:"Motors",energy:"Energy",spectrum:"Spectrum",all:"All"};function v0(i,t,e){let n=Lm(t),r=y0(),s=lt("div",{class:"chart-grid",id:"tm-charts",role:"tabpanel",tabindex:"0"}),o=lt("div",{class:"tabs",role:"tablist","aria-label":"Charts"}),a=lt("p",{class:"note hint",text:"Click or drag: choose the time. Shift and drag: zoom, double click: back."}),l=Object.keys(x0).filter(y=>_0(n,y).length>0),c=[],u=[],h=null;for(let y of l){let g=bn(x0[y],()=>f(y),{role:"tab",id:`tm-tab-${y}`,"aria-controls":"tm-charts","data-group":y});o.append(g)}o.addEventListener("keydown",y=>{let g={ArrowRight:1,ArrowLeft:-1}[y.key],p=l.findIndex(x=>`tm-tab-${x}`===y.target.id);g===void 0||p<0||(y.preventDefault(),y.stopPropagation(),f(l[(p+g+l.length)%l.length]),o.querySelector("[aria-selected=true]")?.focus())});function f(y){u.forEach(g=>g.dispose()),c=_0(n,y),u=c.map(g=>g0(g,e,r)),h&&u.forEach(g=>g.show(h));for(let g of o.querySelectorAll("button")){let p=g.dataset.group===y;g.setAttribute("aria-selected",String(p)),g.tabIndex=p?0:-1}s.setAttribute("aria-labelledby",`tm-tab-${y}`),s.replaceChildren(...u.map(g=>g.element))}let d=matchMedia("(prefers-color-scheme: dark)"),m=()=>u.forEach(y=>y.recolour());return d.addEventListener("change",m),i.append(lt("div",{class:"tab-bar"},o,a),s),f("overview"),{show(y){let g=h;h=y,u.forEach((p,x)=>{(!y||!g||!Fm(c[x],g,y))&&p.show(y)})},dispose(){d.removeEventListener("change",m),u.forEach(y=>y.dispose()),i.replaceChildren()}}}function _0(i,t){return t==="all"?i:t!=="overview"?i.filter(({chart:e})=>e.group===t):i.filter(({chart:e},n)=>i.findIndex(r=>r.chart.group===e.group)===n)}var b0='"use strict";(()=>{var on=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],sn=["m","rad","s"],an=["Hz","%","rad/s"],ln="⁰¹²³⁴⁵⁶⁷⁸⁹";function un(s){let e=s.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(e)?"":e}function Q(s,e=4){return s===0?"0":String(Number(s.toPrecision(e)))}function cn(s){if(s===0)return"0";let[e,r]=s.toExponential(1).split("e"),t=[...String(Number(r))].map(n=>n==="-"?"⁻":ln[Number(n)]).join("");return`${e} × 10${t}`}function fn(s,e){let r=un(s);if(!r||an.includes(s)||!(e>0))return{factor:1,name:r};let t=sn.includes(s.split("/")[0]),n=on.find(([o,i])=>e>=o&&(i>=1||!t));return n?{factor:n[1],name:n[2]+r}:{factor:1,name:r}}function V(s,e){if(s===null||!Number.isFinite(s))return"–";let r=Math.abs(s),{factor:t,name:n}=fn(e,r);return`${r>0&&(t===1?r<.001:r<1e-11)?cn(s):Q(s*t)} ${n}`.trimEnd()}function pe(s){let{settings:e,status:r}=s,{statuses:t,limits:n}=s.layout,o=`t = ${Q(s.time,6)} s`;if(r===t.finished)return["finished",`completed at t = ${Q(e.duration,6)} s`];if(r===t.running)return["stopped",`stopped at ${o} of ${Q(e.duration,6)} s: integration.max_steps = ${e.maxSteps} is used up`];if(r===t.chattering){let i=`more than ${n.most_events} times within ${n.event_time} s`;return["chattering",`stopped at ${o}: the contact started or ended ${i}; give the surface damping, or a lower stiffness`]}return mn(s,o)}function mn({layout:s,status:e,lastStep:r,rates:t},n){let{statuses:o,coordinates:i,limits:a}=s,l=i.length,u=Array.from(t().subarray(l,2*l),d=>Number.isFinite(d)?Math.abs(d):1/0),f=u.indexOf(Math.max(...u)),m=u[f]<a.bound?e===o.not_converged?"not_converged":e===o.step_too_small?"step_too_small":"diverged":"diverged",g=`its acceleration is ${Q(u[f],3)} rad/s^2`,p=m.replaceAll("_"," ");return[m,`${p} at ${n} in coordinate ${i[f]}: ${g}; its last step was of ${Q(r,3)} s`]}var W=class extends Error{name="EngineError"};function ft(s,e,r){if(!Object.hasOwn(s,e))throw new W(`${r}: got ${e}; expected one of ${Object.keys(s).join(", ")}`);return s[e]}function H(s,e,r){if(e!==r)throw new W(`${s}: got ${e} numbers; expected ${r}`)}var hn=["rk4","midpoint"],pn=500,Tt=class{constructor(e,r){this.engine=e;this.spec=r;let t=ft(e.layout.loops,r.loop,"loop");H(`${r.loop}: parameters`,r.parameters.length,t.parameters),H(`${r.loop}: state`,r.state.length,t.size),H(`${r.loop}: rows`,r.rows.length,(r.knots.length-1)*t.row),this.method=t.method,this.memory=new Float64Array(e.layout.cells.length),this.state=r.state.slice(),this.slope=new Float64Array(t.size),this.states=new Float64Array(r.times.length*t.size),this.states.set(r.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(e){return this.memory[this.engine.layout.cells.indexOf(e)]}put(e){for(let[r,t]of Object.entries(e))this.memory[this.engine.layout.cells.indexOf(r)]=t}advance(e){let{layout:r}=this.engine,{settings:t,knots:n,rows:o,times:i,parameters:a}=this.spec,l=Math.max(1,Math.min(e,t.maxSteps-this.tried)),u={step:t.step,rtol:t.relativeTolerance,atol:t.absoluteTolerance,chunk:l,bound:r.limits.bound,watch:0,most_events:r.limits.most_events,event_time:r.limits.event_time,looks:0},f=this.cell("sample"),c=p=>({into:p,range:()=>[f*this.state.length,this.cell("sample")*this.state.length]}),m=p=>({into:p,given:!0}),g={memory:m(this.memory),y:m(this.state),k1:m(this.slope),p:a,knots:n,rows:o,times:i,out:c(this.states),options:Float64Array.from(r.options,p=>u[p]),seen:new Float64Array(1),segments:n.length-1,samples:i.length};this.engine.call(r.loops[this.spec.loop].export,r.arguments.map(p=>g[p]))}result(){let e=this.cell("sample"),r=this.state.length,[t,n]=pe({layout:this.engine.layout,settings:this.spec.settings,status:this.cell("status"),time:this.time,lastStep:this.cell("h"),rates:()=>this.rates()});return{status:t,message:n,times:this.spec.times.slice(0,e),states:this.states.slice(0,e*r),statistics:this.statistics()}}statistics(){let[e,r,t]=[this.cell("steps"),this.cell("smallest"),this.time],n=e?t/e:null,o={steps:e,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:n,smallest_step_s:r>0?r:n};return hn.includes(this.method)&&(o.step=this.cell("h")),this.cell("passes")&&(o.passes=this.cell("passes")),this.cell("events")&&(o.contact_changes=this.cell("events")),o}rates(){let{loop:e,parameters:r,rows:t}=this.spec,{row:n}=this.engine.layout.loops[e],o=Math.min(this.cell("segment"),t.length/n-1),i={time:Float64Array.of(this.time),state:this.state,row:t.slice(o*n,(o+1)*n),step:new Float64Array(1)};return this.engine.sample(`${e.slice(0,e.lastIndexOf("."))}.rate`,r,i,1).rate}},tt=class extends W{name="Cancelled"};async function ge(s,e,r={}){let t=new Tt(s,e),n=1e3*(r.piece??.05),o=pn,i=performance.now();for(;t.running;){let a=performance.now();t.advance(o);let l=performance.now();if(o=Math.max(1,Math.floor(o*Math.min(4,n/Math.max(l-a,.001)))),!(l-i<n)){if(r.progress?.(t.time/e.settings.duration),await new Promise(u=>setTimeout(u,0)),r.cancelled?.())throw new tt(`the run was given up at t = ${Q(t.time,6)} s`);i=performance.now()}}return t.result()}function de(s,e){if(!e)return s;let r=(t,n)=>Object.fromEntries(Object.entries(t).filter(([o,i])=>n[o]!==i));return{...r(s,e),series:r(s.series,e.series)}}function mt(s,e=new Set){if(ArrayBuffer.isView(s))s.buffer instanceof ArrayBuffer&&e.add(s.buffer);else if(s!==null&&typeof s=="object")for(let r of Object.values(s))mt(r,e);return[...e]}var ye=1,gn=65536,dn={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},wt=class s{constructor(e,r,t,n){this.layout=e;this.functions=r;this.memory=t;this.free=n}layout;functions;memory;free;outputs=new Float64Array;static async open(e,r){if(r.format!==ye)throw new W(`layout: got format ${r.format}; expected ${ye}`);let{instance:t}=await yn(e,r),{memory:n,heap_base:o,...i}=t.exports,a=o.value;return new s(r,i,n,a)}sample(e,r,t,n){let o=ft(this.layout.samples,e,"function");H(`${e}: parameters`,r.length,o.parameters);let i=this.schedule(o,r,[t],n);return qt(o.outputs,i,n,1)}slopes(e,r,t,n,o){let i=ft(this.layout.samples,e,"function");if(i.kind!=="slopes")throw new W(`${e}: got a function without derivatives; expected one with them`);H(`${e}: parameters`,r.length,i.parameters);let a=Object.fromEntries(Object.entries(i.inputs).map(([f,c])=>[f,new Float64Array(c)])),l=this.schedule(i,r,[t,{...a,...n}],o),u=bt(i.outputs);return{values:qt(i.outputs,l,o,2),slopes:qt(i.outputs,l.subarray(u),o,2)}}call(e,r){let t=r.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(t.reduce((a,l)=>a+(l?.byteLength??0),this.free));let n=new Float64Array(this.memory.buffer),o=this.free,i=r.map((a,l)=>{if(typeof a=="number")return BigInt(a);let u=o;return(a instanceof Float64Array||a.given)&&n.set(t[l],u/8),o+=t[l].byteLength,u});this.functions[e](...i),r.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[u,f]=a.range?.()??[0,a.into.length],c=i[l]/8;a.into.set(n.subarray(c+u,c+f),u)})}schedule(e,r,t,n){let o=bn(e.inputs,t,n),i=this.room(n*t.length*bt(e.outputs)),a=new Float64Array(e.workspace);return this.call(e.export,[n,0,r,a,o,{into:i}]),i}room(e){return this.outputs.length<e&&(this.outputs=new Float64Array(e)),this.outputs.subarray(0,e)}reserve(e){let r=e-this.memory.buffer.byteLength;if(!(r<=0))try{this.memory.grow(Math.ceil(r/gn))}catch{throw new W(`memory: got no room for ${(e/1e6).toFixed(0)} MB; expected a browser that has it. Hint: ask for fewer samples`)}}};async function yn(s,e){try{return await WebAssembly.instantiate(s,{env:dn})}catch(r){let t=e.simd?", with vectors (SIMD)":"";throw new W(`WebAssembly: got ${String(r)}; expected a browser that allows it${t}`)}}function bt(s){return Object.values(s).reduce((e,r)=>e+r,0)}function wn(s,e,r,t){if(r===void 0)throw new W(`${s}: got nothing; expected ${e} numbers for each sample`);if(r.length===t*e)return r;H(s,r.length,e);let n=new Float64Array(t*e);return $t(r,0,0,n,e,0,e,t),n}function bn(s,e,r){let t=bt(s),n=new Float64Array(r*e.length*t);return e.forEach((o,i)=>{let a=i*t;for(let[l,u]of Object.entries(s)){let f=wn(l,u,o[l],r);$t(f,u,0,n,e.length*t,a,u,r),a+=u}}),n}function qt(s,e,r,t){let n=t*bt(s),o={},i=0;for(let[a,l]of Object.entries(s)){let u=new Float64Array(r*l);$t(e,n,i,u,l,0,l,r),o[a]=u,i+=l}return o}function $t(s,e,r,t,n,o,i,a){for(let l=0;l<a;l++){let u=l*e+r,f=l*n+o;for(let c=0;c<i;c++)t[f+c]=s[u+c]}}var Ft=class{last=null;async of(e,r){if(this.last&&Fn(this.last.blocks,e))return this.last.made;this.last=null;let t=await r();return this.last={blocks:e,made:t},t}};function Fn(s,e){return Object.entries(s).every(([r,t])=>t.length===e[r].length&&t.every((n,o)=>n===e[r][o]))}function _t(s,e){return{knots:s,coefficients:e,signals:1,degree:e.length/(s.length-1)-1}}function Pt(s,e){let r=s.degree+1,t=s.knots.length-1,n=0;for(;n<t&&s.knots[n]<e;)n+=1;let o=s.knots[t],i=[...s.knots.subarray(0,n)],a=[...s.coefficients.subarray(0,n*r)];return e>o&&(i.push(o),a.push(zt(s,t-1,0,o),...new Array(s.degree).fill(0))),_t(Float64Array.from([...i,e]),Float64Array.from(a))}function zt(s,e,r,t){let n=s.degree+1,o=(e*s.signals+r)*n,i=t-s.knots[e],a=0;for(let l=s.degree;l>=0;l-=1)a=a*i+s.coefficients[o+l];return a}function Ct(s,e){let[r,t]=[0,s.length-1];for(;t-r>1;){let n=r+t>>1;s[n]<=e?r=n:t=n}return r}function at(s,e,r){return zt(s,Ct(s.knots,r),e,r)}function we(s){return be(s,Array.from({length:s.knots.length-1},(e,r)=>r))}function At(s,e){return be(s,Array.from(e,r=>Ct(s.knots,r)))}function be(s,e){let r=s.signals*(s.degree+1),t=new Float64Array(e.length*(r+1));return e.forEach((n,o)=>{t[o*(r+1)]=s.knots[n],t.set(s.coefficients.subarray(n*r,(n+1)*r),o*(r+1)+1)}),t}function Fe(s){if(!s.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let e=Math.max(...s.map(i=>i.knots[i.knots.length-1])),r=s.map(i=>i.knots[i.knots.length-1]<e?Pt(i,e):i),t=An(r.flatMap(i=>[...i.knots])),n=Math.max(...r.map(i=>i.degree)),o=new Float64Array((t.length-1)*s.length*(n+1));return r.forEach((i,a)=>{for(let l=0;l<t.length-1;l+=1){let u=(l*s.length+a)*(n+1);Mn(i,t,l,o.subarray(u,u+n+1))}}),{knots:t,coefficients:o,signals:s.length,degree:n}}function An(s){let e=[...new Set(s)].sort((n,o)=>n-o),r=e[e.length-1]-e[0],t=e.filter((n,o)=>o===0||n-e[o-1]>1e-12*r);return t[t.length-1]=e[e.length-1],Float64Array.from(t)}function Mn(s,e,r,t){let n=Ct(s.knots,(e[r]+e[r+1])/2),o=e[r]-s.knots[n],i=Math.abs(o)<=1e-12*(e[e.length-1]-e[0])?0:o;for(let a=0;a<=s.degree;a+=1){let l=s.coefficients[n*(s.degree+1)+a],u=1;for(let f=a;f>=0;f-=1)t[f]+=u*l*Math.pow(i,a-f),u=u*f/(a-f+1)}}var Sn=1e-9,vn=1e-6;function Ae(s){let e=s.map(En);return e.includes(null)?null:Math.max(0,...e)}function En(s){let{knots:e,coefficients:r,degree:t}=s,n=e.length-1,o=t+1,i=l=>r[l*o],a=Array.from({length:n},(l,u)=>Math.abs(i(u))).reduce((l,u)=>Math.max(l,u),1e-12);for(let l=n-1;l>=0;l-=1){let u=e[l+1]-e[l];for(let f=1;f<o;f+=1)if(!(Math.abs(r[l*o+f])*u**f<=Sn*a))return l===n-1?null:e[l+1];if(l&&Math.abs(i(l)-zt(s,l-1,0,e[l]))>vn*a)return e[l]}return 0}var z=6;function Wt({follower:s,signal:e},r,t,n,o,i){let a=e<0?1:at(t,e,n);return(s?kn(o,i,r):r).map(l=>a*l)}function kn(s,e,r){return r.map((t,n)=>{let[o,i]=[e+3*(n%3),n<3?0:3];return s[o]*r[i]+s[o+1]*r[i+1]+s[o+2]*r[i+2]})}function Mt(s,e,r,t,n){let o=n.position.shape[1],i=new Float64Array(t.length*o*z);return t.forEach((a,l)=>{if(s.loads.forEach((u,f)=>{let c=l*o+u.point,m=e.loads.subarray(z*f,z*(f+1)),g=Wt(u,m,r,a,n.rotation.data,9*c);for(let p=0;p<z;p+=1)i[z*c+p]+=g[p]}),!(s.contactPoint<0))for(let u=0;u<3;u+=1)i[z*(l*o+s.contactPoint)+u]-=n.contact_force.data[3*l+u]}),i}function St(s,e){let r=e.length;for(let t=0;t<r;t+=1){let n=t;for(let i=t+1;i<r;i+=1)Math.abs(s[i*r+t])>Math.abs(s[n*r+t])&&(n=i);let o=Math.abs(s[n*r+t]);if(!(o>0)||o===1/0)return!1;n!==t&&xn(s,e,t,n);for(let i=t+1;i<r;i+=1){let a=s[i*r+t]/s[t*r+t];if(a!==0){for(let l=t+1;l<r;l+=1)s[i*r+l]-=a*s[t*r+l];e[i]-=a*e[t]}}}for(let t=r-1;t>=0;t-=1){for(let n=t+1;n<r;n+=1)e[t]-=s[t*r+n]*e[n];e[t]/=s[t*r+t]}return!0}function xn(s,e,r,t){let n=e.length;for(let i=0;i<n;i+=1){let a=s[r*n+i];s[r*n+i]=s[t*n+i],s[t*n+i]=a}let o=e[r];e[r]=e[t],e[t]=o}function vt(s,e){let r=new Float64Array(e*e);for(let t=0;t<e;t+=1)for(let n=t;n<e;n+=1){let o=s[n*e+t];for(let i=0;i<t;i+=1)o-=r[n*e+i]*r[t*e+i];if(n===t&&!(o>0))return null;r[n*e+t]=n===t?Math.sqrt(o):o/r[t*e+t]}return r}function Se(s,e,r,t){for(let n=0;n<r;n+=1){for(let o=0;o<n;o+=1)Ee(e,n,o,s[n*r+o],t);for(let o=0;o<t;o+=1)e[n*t+o]/=s[n*r+n]}}function Dt(s,e,r,t){for(let n=r-1;n>=0;n-=1){for(let o=n+1;o<r;o+=1)Ee(e,n,o,s[o*r+n],t);for(let o=0;o<t;o+=1)e[n*t+o]/=s[n*r+n]}}function Ee(s,e,r,t,n){for(let o=0;o<n;o+=1)s[e*n+o]-=t*s[r*n+o]}function Et(s,e,r){let t=e.slice();Se(s,t,r,r);let n=ve(t,r);return Se(s,n,r,r),ve(n,r)}function ve(s,e){return s.map((r,t)=>s[t%e*e+Math.floor(t/e)])}function $(s,e,r,t,n,o=!1){let i=new Float64Array(r*n);for(let a=0;a<r;a+=1)for(let l=0;l<t;l+=1){let u=o?s[l*r+a]:s[a*t+l];if(u)for(let f=0;f<n;f+=1)i[a*n+f]+=u*e[l*n+f]}return i}function ke(s,e){let r=Float64Array.from({length:e*e},(t,n)=>n%(e+1)?0:1);for(let t=0;t<e;t+=1){let n=t;for(let a=t+1;a<e;a+=1)Math.abs(s[a*e+t])>Math.abs(s[n*e+t])&&(n=a);let o=Math.abs(s[n*e+t]);if(!(o>0)||o===1/0)return null;for(let a of[s,r])if(n!==t){let l=a.slice(t*e,(t+1)*e);a.copyWithin(t*e,n*e,(n+1)*e),a.set(l,n*e)}let i=s[t*e+t];for(let a=0;a<e;a+=1)s[t*e+a]/=i,r[t*e+a]/=i;for(let a=0;a<e;a+=1){let l=s[a*e+t];if(!(a===t||l===0)){for(let u=t;u<e;u+=1)s[a*e+u]-=l*s[t*e+u];for(let u=0;u<e;u+=1)r[a*e+u]-=l*r[t*e+u]}}}return r}var kt=24;function xe(s,e,r,t,n,o,i=0){let a=t.length/kt,l={wrenches:new Float64Array(z*a),mass:new Float64Array(o*o),damping:new Float64Array(o*o),stiffness:new Float64Array(o*o)},u=(f,c)=>Float64Array.from({length:3*o},(m,g)=>n[(g%o*a+f)*kt+c+Math.floor(g/o)]);return s.loads.forEach((f,c)=>{let{point:m,follower:g}=f,p=e.loads.subarray(z*c,z*(c+1)),d=Wt(f,p,r,i,t,kt*m);if(lt(l.wrenches.subarray(z*m,z*(m+1)),d,1),!g)return;let w=u(m,21);for(let[h,y]of[[u(m,18),0],[w,3]])lt(l.stiffness,$(h,$(Rn(d.subarray(y,y+3)),w,3,3,o),o,3,o,!0),1)}),s.touch&&Ln(jn(s.touch,e.surface),e.touch,t,u(s.touch.point,18),l,o),l}function lt(s,e,r){for(let t=0;t<e.length;t+=1)s[t]+=r*e[t]}function Rn([s,e,r]){return Float64Array.of(0,-r,e,r,0,-s,-e,s,0)}function jn(s,e){let[r,t,n,o]=e;if(s.radius)return{...s,axis:[r,t,n],radius:o};let[i,a,l]=s.axis;return{...s,distance:-(i*r+a*t+l*n)}}function Ln(s,e,r,t,n,o){let[i,a,l,u]=e,f=kt*s.point+9,{gap:c,normal:m,curvature:g}=In(s,r.subarray(f,f+3)),p=u-l*c;if(!s.bilateral&&!(c<=0&&p>0))return;for(let h=0;h<3;h+=1)n.wrenches[z*s.point+h]+=p*m[h];let d=$(m,t,1,3,o),w=$(d,d,o,1,o);lt(n.mass,w,i),lt(n.damping,w,a),lt(n.stiffness,w,l),lt(n.stiffness,$(t,$(g,t,3,3,o),o,3,o,!0),-p)}function In(s,e){let r=l=>l[0]*e[0]+l[1]*e[1]+l[2]*e[2];if(!s.radius)return{gap:r(s.axis)+s.distance,normal:Float64Array.from(s.axis),curvature:new Float64Array(9)};let t=e.map((l,u)=>l-s.axis[u]),n=Math.hypot(...t)||1e-300,o=s.inside?-1:1,i=t.map(l=>l/n),a=Float64Array.from({length:9},(l,u)=>o*((u%4?0:1)-i[Math.floor(u/3)]*i[u%3])/n);return{gap:o*(n-s.radius),normal:i.map(l=>o*l),curvature:a}}function Re(s,e){let r=Array.from(s.frames.data).filter(t=>t<e);return r[r.length-1]!==e-1&&r.push(e-1),r}function L(s){return s.data instanceof Float64Array?s.data:Float64Array.from(s.data)}function On(s,e,r){let t=s.knobs.map(o=>o.start),n=s.knobs.map(o=>o.factor);return s.sliders.forEach((o,i)=>{o.real?n[o.knob]=e[i]:t[o.knob]=e[i]}),r==="reference"?t:s.knobs.map((o,i)=>{let a=n[i];return a===null||o.factor===null?t[i]:o.together?o.factor?t[i]*(a/o.factor):t[i]:t[i]*a})}function ut(s,e,r){let t=s.runs[r],n=Bn(t,On(s,e,r)),o={};for(let[i,a]of Object.entries(t.places)){let l=a.shape.reduce((u,f)=>u*f,1);o[i]=n.slice(a.start,a.start+l)}return o}function Bn(s,e){let r=L(s.base).slice(),t=s.powers.map(l=>je(l,(u,f)=>Math.pow(e[u]/s.variables[u].start,f))),n=s.powers.map(l=>je(l,(u,f)=>Nn(s.variables[u],f,e[u]))),{products:o,terms:i,coefficients:a}=s;for(let l=0;l<o.data.length;l+=2)r[o.data[l]]*=t[o.data[l+1]];for(let l=0;l<i.data.length;l+=2)r[i.data[l]]+=a.data[l/2]*n[i.data[l+1]];return r}function je(s,e){return s.reduce((r,[t,n])=>r*e(t,n),1)}function Nn(s,e,r){let t=Math.pow(s.start,e);return(Math.pow(r,e)-t)/(Math.pow(s.far,e)-t)}var Tn=40,qn=1e-12,$n=.5,Le=1e-6,_n=.5,Pn=.001,zn=1/128;function Cn(s,e,r,t,n,o){let[i,a,l]=[t.length+1,r.length,e.rotors.length],u=new Float64Array(i*a);for(let m=0;m<i;m+=1)u.set(r,m*a),m&&(u[m*a+t[m-1]]+=Le);let f={time:new Float64Array(1),state:u,row:e.rest_row,step:new Float64Array(1)},{rate:c}=s.sample("rest.rate",e.rest,f,i);for(let m=0;m<t.length;m+=1){o[m]=c[l+t[m]];for(let g=0;g<t.length;g+=1)n[m*t.length+g]=(c[(g+1)*a+l+t[m]]-o[m])/Le}}function Wn(s,e,r,t){let n=s.layout.held,o=t.length,i=Array.from({length:o},(g,p)=>p).filter(g=>!n.includes(g)),a=new Float64Array(e.restSize);a.set(t);let l=new Float64Array(i.length**2),u=new Float64Array(i.length),f=1/0,[c,m]=[0,0];for(let g=0;g<Tn&&i.length;g+=1){if(Cn(s,r,a,i,l,u),!St(l,u))return null;let p=Ut(a,i,u);if(!Number.isFinite(p)||(g===0?c=p:m+=p,c>Pn&&m>_n*c))return null;if(Gt(p,f))return a.slice(0,o);f=p}return i.length?null:a.slice(0,o)}function Ut(s,e,r){let t=r.reduce((o,i)=>Math.max(o,Math.abs(i)),0),n=Math.min(1,$n/t);for(let o=0;o<e.length;o+=1)s[e[o]]-=n*r[o];return t}function Gt(s,e){return s<qn||s<1e-9&&s>=e/2}function Qt(s,e,r,t,n){let o=s.sliders.map(f=>f.value),i=f=>f===1?e:e.map((c,m)=>o[m]+(c-o[m])*f),[a,l,u]=[0,1,t];for(;a<1;){let f=Math.min(1,a+l),c=n(i(f),u);if(c)[a,l,u]=[f,2*l,c];else if(l>zn)l/=2;else throw new Error(`${r}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`)}return u}function Ie(s,e,r,t,n){let o=e.runs[t],i=L(o.start).slice(),[a,l]=[o.state.q[0],o.state.v[0]];if(e.atRest){let u=(c,m)=>Wn(s,e,ut(e.map,c,t),m),f=Qt(e,r,t,i.slice(...o.state.q),u);for(let c=0;c<f.length;c+=1)o.info.includes(c)||(i[a+c]=f[c])}for(let[u,f]of o.exact){i[a+u]=at(n,f,0);let c=n.degree;i[l+u]=c?n.coefficients[f*(c+1)+1]:0}return i}var Dn=40,ht=.001;function xt(s,e,r,t){let{samples:n}=s.layout;return s.sample("loaded"in n?"loaded":"inertia",e.chain,r,t).forces}function Un(s,e,r,t,n,o=0){let i=n.length,a=new Float64Array(i),l=Float64Array.from({length:i*i},(F,v)=>v%(i+1)?0:1),u=L(e.base),f=s.sample("inertia",r.chain,{q:n,v:a,a:l,base:u},i),{points:c}=s.sample("inertia",r.chain,{q:n,v:a,a,base:u},1),m=xe(e,r,t,c,f.points,i,o),g=m.mass;for(let F=0;F<i;F+=1){for(let v=0;v<i;v+=1)g[F*i+v]+=(f.forces[F*i+v]+f.forces[v*i+F])/2;g[F*i+F]+=r.rotors[F]}let p=r.chain.slice();for(let F of e.modes.dry)p[F]=0;let d=s.slopes("elastic.slopes",p,{q:n,v:a,base:u},{q:l},i),w=s.slopes("elastic.slopes",p,{q:n,v:a,base:u},{v:l},i).slopes.forces,h=Gn(s,e,r,n,m.wrenches),y=F=>F.map((v,E)=>F[E%i*i+Math.floor(E/i)]),b=y(d.slopes.forces),M=xt(s,r,{q:n,v:a,a,base:L(e.modes.weight),wrenches:m.wrenches},1);return{mass:g,elastic:b,residual:M.map((F,v)=>F+d.values.forces[v]),damping:y(w).map((F,v)=>F+m.damping[v]),stiffness:b.map((F,v)=>F+h[v]+m.stiffness[v])}}function Oe(s,e,r,t,n,o=0){let{free:i}=e.modes,[a,l,u]=[n.slice(),n.length,i.length],[f,c]=[1/0,!u];for(let m=0;m<Dn;m+=1){let g=Un(s,e,r,t,a,o);if(c)return{rest:a,linear:g};let p=Float64Array.from({length:u*u},(h,y)=>g.stiffness[i[Math.floor(y/u)]*l+i[y%u]]),d=Float64Array.from(i,h=>g.residual[h]);if(!St(p,d))return null;let w=Ut(a,i,d);if(!Number.isFinite(w))return null;c=Gt(w,f),f=w}return null}function Gn(s,e,r,t,n){let o=t.length,i=[ht,-ht,2*ht,-2*ht],a=new Float64Array(i.length*o*o);i.forEach((c,m)=>{for(let g=0;g<o;g+=1)a.set(t,(m*o+g)*o),a[(m*o+g)*o+g]+=c});let l=new Float64Array(o),u=xt(s,r,{q:a,v:l,a:l,base:L(e.modes.weight),wrenches:n},i.length*o),f=(c,m,g)=>u[(c*o+g)*o+m];return Float64Array.from({length:o*o},(c,m)=>{let[g,p]=[Math.floor(m/o),m%o];return(8*(f(0,g,p)-f(1,g,p))-(f(2,g,p)-f(3,g,p)))/(12*ht)})}function B(s,e,r){let t=s.length/e,n=new Float64Array(t*r.length);for(let o=0;o<t;o+=1)for(let i=0;i<r.length;i+=1)n[o*r.length+i]=s[o*e+r[i]];return n}function D(s,e){return Array.from({length:e-s},(r,t)=>s+t)}function K(s,e,r){let t=new Float64Array(r.length*e);for(let n=0;n<r.length;n+=1)for(let o=0;o<e;o+=1)t[n*e+o]=s[r[n]*e+o];return t}function Rt(s,e){return s.map((r,t)=>r-e[t])}function ct(s,e){let r=new Float64Array(s.length/e);for(let t=0;t<r.length;t+=1){let n=0;for(let o=0;o<e;o+=1)n+=s[t*e+o]**2;r[t]=Math.sqrt(n)}return r}function Be(s,e,r,t){let n=s.length/r,o=e.length/r,i=new Float64Array(r),a=0;for(let l=0;l<r;l+=1){let u=0;for(let f=0;f<n;f+=1)u+=s[l*n+f];l===0&&(a=u),i[l]=u-a;for(let f=0;f<o;f+=1)i[l]+=(f<t?-1:1)*e[l*o+f]}return i}function pt(s){let e=0;for(let r=1;r<s.length;r+=1)Math.abs(s[r])>Math.abs(s[e])&&(e=r);return e}function k(s,e,...r){return{data:s,shape:[e,...r]}}var Qn=4e5,Kn=5e5;function Ne(s,e,r,t,n,o,i){let{places:a,lines:l,shown:u}=e.carried,f=a.data.length,c=l.map((y,b)=>Yn(y,r.lengths[b],i.length*u.data.length)),m=Math.max(1,Math.ceil(n.length*l.length*f/Qn));if(!l.length)return{links:c,every:m};let g=new Map(i.map((y,b)=>[y,b])),p=Array.from(n.keys()).filter(y=>y%m===0||g.has(y)),d={q:t.q.data,v:t.v.data,a:t.a.data};"wrenches"in s.layout.samples.line.inputs&&(d.wrenches=Mt(e,r,o,n,t));let w=Object.entries(d).map(([y,b])=>[y,K(b,b.length/n.length,p)]),h={...Object.fromEntries(w),base:L(e.split.weight)};return Yt(s,r,h,p.length,(y,b,M)=>{let F=g.get(p[M]);l.forEach((v,E)=>{let A=Jt(y[v.name],b,e,v);Jn(c[E],v,A,a.data,p[M]),F!==void 0&&Xn(c[E],v,A,F,u.data)})}),{links:c,every:m}}function Yt(s,e,r,t,n){let{inputs:o,outputs:i}=s.layout.samples.line,a=Math.max(1,Math.floor(Kn/Object.values(i).reduce((l,u)=>l+u,1)));for(let l=0;l<t;l+=a){let u=Math.min(a,t-l),f={};for(let[m,g]of Object.entries(o)){let p=r[m]??new Float64Array(g);f[m]=p.length===g?p:p.subarray(l*g,(l+u)*g)}let c=s.sample("line",e.line,f,u);for(let m=0;m<u;m+=1)n(c,m,l+m)}}function Jt(s,e,r,t){let n=t?r.carried.places.data.length*t.width:15;return s.subarray(e*n,(e+1)*n)}function Yn({name:s,at:e},r,t){let n=o=>new Float64Array(o*t);return{name:s,length:r,deflection:n(2),slope:n(2),moment:n(3),shear:n(2),axial:n(1),stress:e.mises_stress?{strain:n(1),mises:n(1)}:null,largest:{deflection:null,moment:null,stress:null}}}function Jn(s,{width:e,at:r},t,n,o){let i=n.length-1,a=i*e+r.deflection[0];Kt(s,"deflection",Math.sqrt(t[a]**2+t[a+1]**2),n[i],o);for(let l=0;l<=i;l+=1){let u=l*e+r.moment[0];Kt(s,"moment",Math.sqrt(t[u+1]**2+t[u+2]**2),n[l],o),s.stress&&Kt(s,"stress",t[l*e+r.mises_stress[0]],n[l],o)}}function Kt({name:s,largest:e},r,t,n,o){let i=e[r];(!i||t>i.value)&&(e[r]={link:s,value:t,s:n,sample:o})}function Xn(s,{width:e,at:r},t,n,o){let i=(a,l)=>{let[u,f]=r[a],c=f-u;for(let m=0;m<o.length;m+=1)for(let g=0;g<c;g+=1)l[(n*o.length+m)*c+g]=t[o[m]*e+u+g]};for(let a of["deflection","slope","moment","shear","axial"])i(a,s[a]);s.stress&&(i("strain",s.stress.strain),i("mises_stress",s.stress.mises))}function Z(s,e,r){let[t,n]=s.matrix.shape,o=new Float64Array(r*t);for(let i=0;i<r;i+=1)for(let a=0;a<t;a+=1){let l=s.constant.data[a];for(let u=0;u<n;u+=1)l+=s.matrix.data[a*n+u]*e[i*n+u];o[i*t+a]=l}return o}function Te(s,e,r,t,n,o,i){let a=h=>K(t[h].data,t[h].shape.slice(1).reduce((y,b)=>y*b,1),o),l=o.length,u=jt(s,e,r,a("q"),l),f=h=>jt(s,e,r,h,l).line,c=h=>f(Z(e.straight,h,l)),m=c(a("q")),g=h=>({data:a(h),shape:[l,...t[h].shape.slice(1)]}),p="q_nominal"in t,d=u.line.shape.slice(0,3),w=u.line.data.map((h,y)=>h-m.data[y]);return{times:{data:K(n,1,o),shape:[l]},line:u.line,rigid:m,roots:u.roots,reference:p?f(a("q_nominal")):null,referenceRigid:p?c(a("q_nominal")):null,colours:[...i,{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:ct(w,3),shape:d}}],tip:g("tip"),tipReference:p?g("tip_nominal"):null,contact:e.contactPoint<0?null:{force:g("contact_force"),at:Vn(e,t,o),surface:Zn(e,r.surface)}}}function Zn({surface:s},e){let r=[e[0],e[1],e[2]];return s?.kind==="plane"?{...s,position:r}:s?{...s,center:r,radius:e[3]}:void 0}function Vn(s,e,r){let t=e.position.shape[1],n=K(e.position.data,3*t,r),o=new Float64Array(3*r.length);for(let i=0;i<r.length;i+=1)for(let a=0;a<3;a+=1)o[3*i+a]=n[3*(i*t+s.contactPoint)+a];return{data:o,shape:[r.length,3]}}function jt(s,e,r,t,n){let[o,i]=[e.links.length,e.stations.data.length],a=new Float64Array(t.length/n),l=new Float64Array(n*o*i*3),u=new Float64Array(n*o*4),f=e.links.map(({name:c})=>e.carried.lines.find(m=>m.name===c)??null);return Yt(s,r,{q:t,v:a,a,base:L(e.base)},n,(c,m,g)=>{e.links.forEach(({name:p},d)=>{let w=f[d],h=(g*o+d)*4,y=Jt(c[p],m,e,w);u.set(to(w?y.subarray(w.at.rotation[0]):y),h),g&&Hn(u,h,4*o);for(let b=0;b<i;b+=1){let M=((g*o+d)*i+b)*3;for(let F=0;F<3;F+=1)l[M+F]=w?y[e.carried.shown.data[b]*w.width+w.at.position[0]+F]:y[9+F]+e.stations.data[b]*(y[12+F]-y[9+F])}})}),{line:{data:l,shape:[n,o,i,3]},roots:{data:u,shape:[n,o,4]}}}function Hn(s,e,r){let t=0;for(let n=e;n<e+4;n+=1)t+=s[n]*s[n-r];if(t<0)for(let n=e;n<e+4;n+=1)s[n]*=-1}function to(s){let e=s[0]+s[4]+s[8];if(e>0){let t=2*Math.sqrt(1+e);return[(s[7]-s[5])/t,(s[2]-s[6])/t,(s[3]-s[1])/t,t/4]}if(s[0]>s[4]&&s[0]>s[8]){let t=2*Math.sqrt(1+s[0]-s[4]-s[8]);return[t/4,(s[1]+s[3])/t,(s[2]+s[6])/t,(s[7]-s[5])/t]}if(s[4]>s[8]){let t=2*Math.sqrt(1+s[4]-s[0]-s[8]);return[(s[1]+s[3])/t,t/4,(s[5]+s[7])/t,(s[2]-s[6])/t]}let r=2*Math.sqrt(1+s[8]-s[0]-s[4]);return[(s[2]+s[6])/r,(s[5]+s[7])/r,r/4,(s[3]-s[1])/r]}var eo=Object.prototype.toString;function T(s){let e=eo.call(s);return e.endsWith("Array]")&&!e.includes("Big")}function Xt(s,e={}){if(!T(s))throw new TypeError("input must be an array");if(s.length===0)throw new TypeError("input must not be empty");let{fromIndex:r=0,toIndex:t=s.length}=e;if(r<0||r>=s.length||!Number.isInteger(r))throw new Error("fromIndex must be a positive integer smaller than length");if(t<=r||t>s.length||!Number.isInteger(t))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let n=s[r];for(let o=r+1;o<t;o++)s[o]>n&&(n=s[o]);return n}function Zt(s,e={}){if(!T(s))throw new TypeError("input must be an array");if(s.length===0)throw new TypeError("input must not be empty");let{fromIndex:r=0,toIndex:t=s.length}=e;if(r<0||r>=s.length||!Number.isInteger(r))throw new Error("fromIndex must be a positive integer smaller than length");if(t<=r||t>s.length||!Number.isInteger(t))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let n=s[r];for(let o=r+1;o<t;o++)s[o]<n&&(n=s[o]);return n}function Lt(s,e={}){if(T(s)){if(s.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let r;if(e.output!==void 0){if(!T(e.output))throw new TypeError("output option must be an array if specified");r=e.output}else r=new Array(s.length);let t=Zt(s),n=Xt(s);if(t===n)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:o=e.autoMinMax?t:0,max:i=e.autoMinMax?n:1}=e;if(o>=i)throw new RangeError("min option must be smaller than max option");let a=(i-o)/(n-t);for(let l=0;l<s.length;l++)r[l]=(s[l]-t)*a+o;return r}var It=" ".repeat(2),$e=" ".repeat(4);function _e(){return Vt(this)}function Vt(s,e={}){let{maxRows:r=15,maxColumns:t=10,maxNumSize:n=8,padMinus:o="auto"}=e;return`${s.constructor.name} {\n${It}[\n${$e}${ro(s,r,t,n,o)}\n${It}]\n${It}rows: ${s.rows}\n${It}columns: ${s.columns}\n}`}function ro(s,e,r,t,n){let{rows:o,columns:i}=s,a=Math.min(o,e),l=Math.min(i,r),u=[];if(n==="auto"){n=!1;t:for(let f=0;f<a;f++)for(let c=0;c<l;c++)if(s.get(f,c)<0){n=!0;break t}}for(let f=0;f<a;f++){let c=[];for(let m=0;m<l;m++)c.push(no(s.get(f,m),t,n));u.push(`${c.join(" ")}`)}return l!==i&&(u[u.length-1]+=` ... ${i-r} more columns`),a!==o&&u.push(`... ${o-e} more rows`),u.join(`\n${$e}`)}function no(s,e,r){return(s>=0&&r?` ${qe(s,e-1)}`:qe(s,e)).padEnd(e)}function qe(s,e){let r=s.toString();if(r.length<=e)return r;let t=s.toFixed(e);if(t.length>e&&(t=s.toFixed(Math.max(0,e-(t.length-e)))),t.length<=e&&!t.startsWith("0.000")&&!t.startsWith("-0.000"))return t;let n=s.toExponential(e);return n.length>e&&(n=s.toExponential(Math.max(0,e-(n.length-e)))),n.slice(0)}function Pe(s,e){s.prototype.add=function(t){return typeof t=="number"?this.addS(t):this.addM(t)},s.prototype.addS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)+t);return this},s.prototype.addM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)+t.get(n,o));return this},s.add=function(t,n){return new e(t).add(n)},s.prototype.sub=function(t){return typeof t=="number"?this.subS(t):this.subM(t)},s.prototype.subS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)-t);return this},s.prototype.subM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)-t.get(n,o));return this},s.sub=function(t,n){return new e(t).sub(n)},s.prototype.subtract=s.prototype.sub,s.prototype.subtractS=s.prototype.subS,s.prototype.subtractM=s.prototype.subM,s.subtract=s.sub,s.prototype.mul=function(t){return typeof t=="number"?this.mulS(t):this.mulM(t)},s.prototype.mulS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)*t);return this},s.prototype.mulM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)*t.get(n,o));return this},s.mul=function(t,n){return new e(t).mul(n)},s.prototype.multiply=s.prototype.mul,s.prototype.multiplyS=s.prototype.mulS,s.prototype.multiplyM=s.prototype.mulM,s.multiply=s.mul,s.prototype.div=function(t){return typeof t=="number"?this.divS(t):this.divM(t)},s.prototype.divS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)/t);return this},s.prototype.divM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)/t.get(n,o));return this},s.div=function(t,n){return new e(t).div(n)},s.prototype.divide=s.prototype.div,s.prototype.divideS=s.prototype.divS,s.prototype.divideM=s.prototype.divM,s.divide=s.div,s.prototype.mod=function(t){return typeof t=="number"?this.modS(t):this.modM(t)},s.prototype.modS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)%t);return this},s.prototype.modM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)%t.get(n,o));return this},s.mod=function(t,n){return new e(t).mod(n)},s.prototype.modulus=s.prototype.mod,s.prototype.modulusS=s.prototype.modS,s.prototype.modulusM=s.prototype.modM,s.modulus=s.mod,s.prototype.and=function(t){return typeof t=="number"?this.andS(t):this.andM(t)},s.prototype.andS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)&t);return this},s.prototype.andM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)&t.get(n,o));return this},s.and=function(t,n){return new e(t).and(n)},s.prototype.or=function(t){return typeof t=="number"?this.orS(t):this.orM(t)},s.prototype.orS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)|t);return this},s.prototype.orM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)|t.get(n,o));return this},s.or=function(t,n){return new e(t).or(n)},s.prototype.xor=function(t){return typeof t=="number"?this.xorS(t):this.xorM(t)},s.prototype.xorS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)^t);return this},s.prototype.xorM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)^t.get(n,o));return this},s.xor=function(t,n){return new e(t).xor(n)},s.prototype.leftShift=function(t){return typeof t=="number"?this.leftShiftS(t):this.leftShiftM(t)},s.prototype.leftShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)<<t);return this},s.prototype.leftShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)<<t.get(n,o));return this},s.leftShift=function(t,n){return new e(t).leftShift(n)},s.prototype.signPropagatingRightShift=function(t){return typeof t=="number"?this.signPropagatingRightShiftS(t):this.signPropagatingRightShiftM(t)},s.prototype.signPropagatingRightShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>t);return this},s.prototype.signPropagatingRightShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>t.get(n,o));return this},s.signPropagatingRightShift=function(t,n){return new e(t).signPropagatingRightShift(n)},s.prototype.rightShift=function(t){return typeof t=="number"?this.rightShiftS(t):this.rightShiftM(t)},s.prototype.rightShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>>t);return this},s.prototype.rightShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>>t.get(n,o));return this},s.rightShift=function(t,n){return new e(t).rightShift(n)},s.prototype.zeroFillRightShift=s.prototype.rightShift,s.prototype.zeroFillRightShiftS=s.prototype.rightShiftS,s.prototype.zeroFillRightShiftM=s.prototype.rightShiftM,s.zeroFillRightShift=s.rightShift,s.prototype.not=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,~this.get(t,n));return this},s.not=function(t){return new e(t).not()},s.prototype.abs=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.abs(this.get(t,n)));return this},s.abs=function(t){return new e(t).abs()},s.prototype.acos=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.acos(this.get(t,n)));return this},s.acos=function(t){return new e(t).acos()},s.prototype.acosh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.acosh(this.get(t,n)));return this},s.acosh=function(t){return new e(t).acosh()},s.prototype.asin=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.asin(this.get(t,n)));return this},s.asin=function(t){return new e(t).asin()},s.prototype.asinh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.asinh(this.get(t,n)));return this},s.asinh=function(t){return new e(t).asinh()},s.prototype.atan=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.atan(this.get(t,n)));return this},s.atan=function(t){return new e(t).atan()},s.prototype.atanh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.atanh(this.get(t,n)));return this},s.atanh=function(t){return new e(t).atanh()},s.prototype.cbrt=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cbrt(this.get(t,n)));return this},s.cbrt=function(t){return new e(t).cbrt()},s.prototype.ceil=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.ceil(this.get(t,n)));return this},s.ceil=function(t){return new e(t).ceil()},s.prototype.clz32=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.clz32(this.get(t,n)));return this},s.clz32=function(t){return new e(t).clz32()},s.prototype.cos=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cos(this.get(t,n)));return this},s.cos=function(t){return new e(t).cos()},s.prototype.cosh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cosh(this.get(t,n)));return this},s.cosh=function(t){return new e(t).cosh()},s.prototype.exp=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.exp(this.get(t,n)));return this},s.exp=function(t){return new e(t).exp()},s.prototype.expm1=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.expm1(this.get(t,n)));return this},s.expm1=function(t){return new e(t).expm1()},s.prototype.floor=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.floor(this.get(t,n)));return this},s.floor=function(t){return new e(t).floor()},s.prototype.fround=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.fround(this.get(t,n)));return this},s.fround=function(t){return new e(t).fround()},s.prototype.log=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log(this.get(t,n)));return this},s.log=function(t){return new e(t).log()},s.prototype.log1p=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log1p(this.get(t,n)));return this},s.log1p=function(t){return new e(t).log1p()},s.prototype.log10=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log10(this.get(t,n)));return this},s.log10=function(t){return new e(t).log10()},s.prototype.log2=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log2(this.get(t,n)));return this},s.log2=function(t){return new e(t).log2()},s.prototype.round=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.round(this.get(t,n)));return this},s.round=function(t){return new e(t).round()},s.prototype.sign=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sign(this.get(t,n)));return this},s.sign=function(t){return new e(t).sign()},s.prototype.sin=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sin(this.get(t,n)));return this},s.sin=function(t){return new e(t).sin()},s.prototype.sinh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sinh(this.get(t,n)));return this},s.sinh=function(t){return new e(t).sinh()},s.prototype.sqrt=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sqrt(this.get(t,n)));return this},s.sqrt=function(t){return new e(t).sqrt()},s.prototype.tan=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.tan(this.get(t,n)));return this},s.tan=function(t){return new e(t).tan()},s.prototype.tanh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.tanh(this.get(t,n)));return this},s.tanh=function(t){return new e(t).tanh()},s.prototype.trunc=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.trunc(this.get(t,n)));return this},s.trunc=function(t){return new e(t).trunc()},s.pow=function(t,n){return new e(t).pow(n)},s.prototype.pow=function(t){return typeof t=="number"?this.powS(t):this.powM(t)},s.prototype.powS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)**t);return this},s.prototype.powM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)**t.get(n,o));return this}}function U(s,e,r){let t=r?s.rows:s.rows-1;if(e<0||e>t)throw new RangeError("Row index out of range")}function G(s,e,r){let t=r?s.columns:s.columns-1;if(e<0||e>t)throw new RangeError("Column index out of range")}function rt(s,e){if(e.to1DArray&&(e=e.to1DArray()),e.length!==s.columns)throw new RangeError("vector size must be the same as the number of columns");return e}function nt(s,e){if(e.to1DArray&&(e=e.to1DArray()),e.length!==s.rows)throw new RangeError("vector size must be the same as the number of rows");return e}function ze(s,e){if(!T(e))throw new TypeError("row indices must be an array");for(let r=0;r<e.length;r++)if(e[r]<0||e[r]>=s.rows)throw new RangeError("row indices are out of range")}function Ce(s,e){if(!T(e))throw new TypeError("column indices must be an array");for(let r=0;r<e.length;r++)if(e[r]<0||e[r]>=s.columns)throw new RangeError("column indices are out of range")}function Ht(s,e,r,t,n){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(Ot("startRow",e),Ot("endRow",r),Ot("startColumn",t),Ot("endColumn",n),e>r||t>n||e<0||e>=s.rows||r<0||r>=s.rows||t<0||t>=s.columns||n<0||n>=s.columns)throw new RangeError("Submatrix indices are out of range")}function gt(s,e=0){let r=[];for(let t=0;t<s;t++)r.push(e);return r}function Ot(s,e){if(typeof e!="number")throw new TypeError(`${s} must be a number`)}function ot(s){if(s.isEmpty())throw new Error("Empty matrix has no elements to index")}function We(s){let e=gt(s.rows);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[r]+=s.get(r,t);return e}function De(s){let e=gt(s.columns);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[t]+=s.get(r,t);return e}function Ue(s){let e=0;for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)e+=s.get(r,t);return e}function Ge(s){let e=gt(s.rows,1);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[r]*=s.get(r,t);return e}function Qe(s){let e=gt(s.columns,1);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[t]*=s.get(r,t);return e}function Ke(s){let e=1;for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)e*=s.get(r,t);return e}function Ye(s,e,r){let t=s.rows,n=s.columns,o=[];for(let i=0;i<t;i++){let a=0,l=0,u=0;for(let f=0;f<n;f++)u=s.get(i,f)-r[i],a+=u,l+=u*u;e?o.push((l-a*a/n)/(n-1)):o.push((l-a*a/n)/n)}return o}function Je(s,e,r){let t=s.rows,n=s.columns,o=[];for(let i=0;i<n;i++){let a=0,l=0,u=0;for(let f=0;f<t;f++)u=s.get(f,i)-r[i],a+=u,l+=u*u;e?o.push((l-a*a/t)/(t-1)):o.push((l-a*a/t)/t)}return o}function Xe(s,e,r){let t=s.rows,n=s.columns,o=t*n,i=0,a=0,l=0;for(let u=0;u<t;u++)for(let f=0;f<n;f++)l=s.get(u,f)-r,i+=l,a+=l*l;return e?(a-i*i/o)/(o-1):(a-i*i/o)/o}function Ze(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e[r])}function Ve(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e[t])}function He(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e)}function tr(s){let e=[];for(let r=0;r<s.rows;r++){let t=0;for(let n=0;n<s.columns;n++)t+=s.get(r,n)**2/(s.columns-1);e.push(Math.sqrt(t))}return e}function er(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e[r])}function rr(s){let e=[];for(let r=0;r<s.columns;r++){let t=0;for(let n=0;n<s.rows;n++)t+=s.get(n,r)**2/(s.rows-1);e.push(Math.sqrt(t))}return e}function nr(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e[t])}function or(s){let e=s.size-1,r=0;for(let t=0;t<s.columns;t++)for(let n=0;n<s.rows;n++)r+=s.get(n,t)**2/e;return Math.sqrt(r)}function sr(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e)}var j=class s{static from1DArray(e,r,t){if(e*r!==t.length)throw new RangeError("data length does not match given dimensions");let o=new S(e,r);for(let i=0;i<e;i++)for(let a=0;a<r;a++)o.set(i,a,t[i*r+a]);return o}static rowVector(e){let r=new S(1,e.length);for(let t=0;t<e.length;t++)r.set(0,t,e[t]);return r}static columnVector(e){let r=new S(e.length,1);for(let t=0;t<e.length;t++)r.set(t,0,e[t]);return r}static zeros(e,r){return new S(e,r)}static ones(e,r){return new S(e,r).fill(1)}static rand(e,r,t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{random:n=Math.random}=t,o=new S(e,r);for(let i=0;i<e;i++)for(let a=0;a<r;a++)o.set(i,a,n());return o}static randInt(e,r,t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:n=0,max:o=1e3,random:i=Math.random}=t;if(!Number.isInteger(n))throw new TypeError("min must be an integer");if(!Number.isInteger(o))throw new TypeError("max must be an integer");if(n>=o)throw new RangeError("min must be smaller than max");let a=o-n,l=new S(e,r);for(let u=0;u<e;u++)for(let f=0;f<r;f++){let c=n+Math.round(i()*a);l.set(u,f,c)}return l}static eye(e,r,t){r===void 0&&(r=e),t===void 0&&(t=1);let n=Math.min(e,r),o=this.zeros(e,r);for(let i=0;i<n;i++)o.set(i,i,t);return o}static diag(e,r,t){let n=e.length;r===void 0&&(r=n),t===void 0&&(t=r);let o=Math.min(n,r,t),i=this.zeros(r,t);for(let a=0;a<o;a++)i.set(a,a,e[a]);return i}static min(e,r){e=this.checkMatrix(e),r=this.checkMatrix(r);let t=e.rows,n=e.columns,o=new S(t,n);for(let i=0;i<t;i++)for(let a=0;a<n;a++)o.set(i,a,Math.min(e.get(i,a),r.get(i,a)));return o}static max(e,r){e=this.checkMatrix(e),r=this.checkMatrix(r);let t=e.rows,n=e.columns,o=new this(t,n);for(let i=0;i<t;i++)for(let a=0;a<n;a++)o.set(i,a,Math.max(e.get(i,a),r.get(i,a)));return o}static checkMatrix(e){return s.isMatrix(e)?e:new S(e)}static isMatrix(e){return e!=null&&e.klass==="Matrix"}get size(){return this.rows*this.columns}apply(e){if(typeof e!="function")throw new TypeError("callback must be a function");for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.call(this,r,t);return this}applyAlongAxis(e,r){if(typeof e!="function")throw new TypeError("callback must be a function");let t=[];switch(r){case"row":{for(let n=0;n<this.rows;n++)t.push(e.call(this,this.getRow(n),n));break}case"column":{for(let n=0;n<this.columns;n++)t.push(e.call(this,this.getColumn(n),n));break}default:throw new Error(`invalid option: ${r}`)}return t}to1DArray(){let e=[];for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.push(this.get(r,t));return e}to2DArray(){let e=[];for(let r=0;r<this.rows;r++){e.push([]);for(let t=0;t<this.columns;t++)e[r].push(this.get(r,t))}return e}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let e=0;e<this.rows;e++)for(let r=0;r<=e;r++)if(this.get(e,r)!==this.get(r,e))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let e=0;e<this.rows;e++)if(this.get(e,e)!==0)return!1;return!0}isEchelonForm(){let e=0,r=0,t=-1,n=!0,o=!1;for(;e<this.rows&&n;){for(r=0,o=!1;r<this.columns&&o===!1;)this.get(e,r)===0?r++:this.get(e,r)===1&&r>t?(o=!0,t=r):(n=!1,o=!0);e++}return n}isReducedEchelonForm(){let e=0,r=0,t=-1,n=!0,o=!1;for(;e<this.rows&&n;){for(r=0,o=!1;r<this.columns&&o===!1;)this.get(e,r)===0?r++:this.get(e,r)===1&&r>t?(o=!0,t=r):(n=!1,o=!0);for(let i=r+1;i<this.rows;i++)this.get(e,i)!==0&&(n=!1);e++}return n}echelonForm(){let e=this.clone(),r=0,t=0;for(;r<e.rows&&t<e.columns;){let n=r;for(let o=r;o<e.rows;o++)e.get(o,t)>e.get(n,t)&&(n=o);if(e.get(n,t)===0)t++;else{e.swapRows(r,n);let o=e.get(r,t);for(let i=t;i<e.columns;i++)e.set(r,i,e.get(r,i)/o);for(let i=r+1;i<e.rows;i++){let a=e.get(i,t)/e.get(r,t);e.set(i,t,0);for(let l=t+1;l<e.columns;l++)e.set(i,l,e.get(i,l)-e.get(r,l)*a)}r++,t++}}return e}reducedEchelonForm(){let e=this.echelonForm(),r=e.columns,t=e.rows,n=t-1;for(;n>=0;)if(e.maxRow(n)===0)n--;else{let o=0,i=!1;for(;o<t&&i===!1;)e.get(n,o)===1?i=!0:o++;for(let a=0;a<n;a++){let l=e.get(a,o);for(let u=o;u<r;u++){let f=e.get(a,u)-l*e.get(n,u);e.set(a,u,f)}}n--}return e}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{rows:r=1,columns:t=1}=e;if(!Number.isInteger(r)||r<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(t)||t<=0)throw new TypeError("columns must be a positive integer");let n=new S(this.rows*r,this.columns*t);for(let o=0;o<r;o++)for(let i=0;i<t;i++)n.setSubMatrix(this,this.rows*o,this.columns*i);return n}fill(e){for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,e);return this}neg(){return this.mulS(-1)}getRow(e){U(this,e);let r=[];for(let t=0;t<this.columns;t++)r.push(this.get(e,t));return r}getRowVector(e){return S.rowVector(this.getRow(e))}setRow(e,r){U(this,e),r=rt(this,r);for(let t=0;t<this.columns;t++)this.set(e,t,r[t]);return this}swapRows(e,r){U(this,e),U(this,r);for(let t=0;t<this.columns;t++){let n=this.get(e,t);this.set(e,t,this.get(r,t)),this.set(r,t,n)}return this}getColumn(e){G(this,e);let r=[];for(let t=0;t<this.rows;t++)r.push(this.get(t,e));return r}getColumnVector(e){return S.columnVector(this.getColumn(e))}setColumn(e,r){G(this,e),r=nt(this,r);for(let t=0;t<this.rows;t++)this.set(t,e,r[t]);return this}swapColumns(e,r){G(this,e),G(this,r);for(let t=0;t<this.rows;t++){let n=this.get(t,e);this.set(t,e,this.get(t,r)),this.set(t,r,n)}return this}addRowVector(e){e=rt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)+e[t]);return this}subRowVector(e){e=rt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)-e[t]);return this}mulRowVector(e){e=rt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)*e[t]);return this}divRowVector(e){e=rt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)/e[t]);return this}addColumnVector(e){e=nt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)+e[r]);return this}subColumnVector(e){e=nt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)-e[r]);return this}mulColumnVector(e){e=nt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)*e[r]);return this}divColumnVector(e){e=nt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)/e[r]);return this}mulRow(e,r){U(this,e);for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)*r);return this}mulColumn(e,r){G(this,e);for(let t=0;t<this.rows;t++)this.set(t,e,this.get(t,e)*r);return this}max(e){if(this.isEmpty())return NaN;switch(e){case"row":{let r=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>r[t]&&(r[t]=this.get(t,n));return r}case"column":{let r=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>r[n]&&(r[n]=this.get(t,n));return r}case void 0:{let r=this.get(0,0);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>r&&(r=this.get(t,n));return r}default:throw new Error(`invalid option: ${e}`)}}maxIndex(){ot(this);let e=this.get(0,0),r=[0,0];for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>e&&(e=this.get(t,n),r[0]=t,r[1]=n);return r}min(e){if(this.isEmpty())return NaN;switch(e){case"row":{let r=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<r[t]&&(r[t]=this.get(t,n));return r}case"column":{let r=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<r[n]&&(r[n]=this.get(t,n));return r}case void 0:{let r=this.get(0,0);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<r&&(r=this.get(t,n));return r}default:throw new Error(`invalid option: ${e}`)}}minIndex(){ot(this);let e=this.get(0,0),r=[0,0];for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<e&&(e=this.get(t,n),r[0]=t,r[1]=n);return r}maxRow(e){if(U(this,e),this.isEmpty())return NaN;let r=this.get(e,0);for(let t=1;t<this.columns;t++)this.get(e,t)>r&&(r=this.get(e,t));return r}maxRowIndex(e){U(this,e),ot(this);let r=this.get(e,0),t=[e,0];for(let n=1;n<this.columns;n++)this.get(e,n)>r&&(r=this.get(e,n),t[1]=n);return t}minRow(e){if(U(this,e),this.isEmpty())return NaN;let r=this.get(e,0);for(let t=1;t<this.columns;t++)this.get(e,t)<r&&(r=this.get(e,t));return r}minRowIndex(e){U(this,e),ot(this);let r=this.get(e,0),t=[e,0];for(let n=1;n<this.columns;n++)this.get(e,n)<r&&(r=this.get(e,n),t[1]=n);return t}maxColumn(e){if(G(this,e),this.isEmpty())return NaN;let r=this.get(0,e);for(let t=1;t<this.rows;t++)this.get(t,e)>r&&(r=this.get(t,e));return r}maxColumnIndex(e){G(this,e),ot(this);let r=this.get(0,e),t=[0,e];for(let n=1;n<this.rows;n++)this.get(n,e)>r&&(r=this.get(n,e),t[0]=n);return t}minColumn(e){if(G(this,e),this.isEmpty())return NaN;let r=this.get(0,e);for(let t=1;t<this.rows;t++)this.get(t,e)<r&&(r=this.get(t,e));return r}minColumnIndex(e){G(this,e),ot(this);let r=this.get(0,e),t=[0,e];for(let n=1;n<this.rows;n++)this.get(n,e)<r&&(r=this.get(n,e),t[0]=n);return t}diag(){let e=Math.min(this.rows,this.columns),r=[];for(let t=0;t<e;t++)r.push(this.get(t,t));return r}norm(e="frobenius"){switch(e){case"max":return S.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${e}`)}}cumulativeSum(){let e=0;for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e+=this.get(r,t),this.set(r,t,e);return this}dot(e){s.isMatrix(e)&&(e=e.to1DArray());let r=this.to1DArray();if(r.length!==e.length)throw new RangeError("vectors do not have the same size");let t=0;for(let n=0;n<r.length;n++)t+=r[n]*e[n];return t}mmul(e){e=S.checkMatrix(e);let r=this.rows,t=this.columns,n=e.columns,o=new S(r,n),i=new Float64Array(t);for(let a=0;a<n;a++){for(let l=0;l<t;l++)i[l]=e.get(l,a);for(let l=0;l<r;l++){let u=0;for(let f=0;f<t;f++)u+=this.get(l,f)*i[f];o.set(l,a,u)}}return o}gram(){let e=this.rows,r=this.columns,t=new Float64Array(r*r);for(let o=0;o<e;o++)for(let i=0;i<r;i++){let a=this.get(o,i);if(a===0)continue;let l=i*r;for(let u=i;u<r;u++)t[l+u]+=a*this.get(o,u)}let n=new S(r,r);for(let o=0;o<r;o++){let i=o*r;for(let a=o;a<r;a++){let l=t[i+a];n.set(o,a,l),n.set(a,o,l)}}return n}transposeMultiply(e){if(e=S.checkMatrix(e),this.rows!==e.rows)throw new RangeError("the number of rows of the two matrices must be equal");let r=this.columns,t=e.columns,n=new S(r,t),o=new Float64Array(t);for(let i=0;i<this.rows;i++){for(let a=0;a<t;a++)o[a]=e.get(i,a);for(let a=0;a<r;a++){let l=this.get(i,a);if(l===0)continue;let u=n.data[a];for(let f=0;f<t;f++)u[f]+=l*o[f]}}return n}mmulByTranspose(e){let r=this.rows,t=this.columns;if(e!==void 0&&e.length!==t)throw new RangeError("scale must have one value per column");let n=new S(r,r),o=new Float64Array(t);for(let i=0;i<r;i++){if(e===void 0)for(let a=0;a<t;a++)o[a]=this.get(i,a);else for(let a=0;a<t;a++)o[a]=e[a]*this.get(i,a);for(let a=i;a<r;a++){let l=0;for(let u=0;u<t;u++)l+=this.get(a,u)*o[u];n.set(a,i,l),n.set(i,a,l)}}return n}mpow(e){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(e)||e<0)throw new RangeError("Exponent must be a non-negative integer");let r=S.eye(this.rows),t=this;for(let n=e;n>=1;n/=2)(n&1)!==0&&(r=r.mmul(t)),t=t.mmul(t);return r}strassen2x2(e){e=S.checkMatrix(e);let r=new S(2,2),t=this.get(0,0),n=e.get(0,0),o=this.get(0,1),i=e.get(0,1),a=this.get(1,0),l=e.get(1,0),u=this.get(1,1),f=e.get(1,1),c=(t+u)*(n+f),m=(a+u)*n,g=t*(i-f),p=u*(l-n),d=(t+o)*f,w=(a-t)*(n+i),h=(o-u)*(l+f),y=c+p-d+h,b=g+d,M=m+p,F=c-m+g+w;return r.set(0,0,y),r.set(0,1,b),r.set(1,0,M),r.set(1,1,F),r}strassen3x3(e){e=S.checkMatrix(e);let r=new S(3,3),t=this.get(0,0),n=this.get(0,1),o=this.get(0,2),i=this.get(1,0),a=this.get(1,1),l=this.get(1,2),u=this.get(2,0),f=this.get(2,1),c=this.get(2,2),m=e.get(0,0),g=e.get(0,1),p=e.get(0,2),d=e.get(1,0),w=e.get(1,1),h=e.get(1,2),y=e.get(2,0),b=e.get(2,1),M=e.get(2,2),F=(t+n+o-i-a-f-c)*w,v=(t-i)*(-g+w),E=a*(-m+g+d-w-h-y+M),A=(-t+i+a)*(m-g+w),x=(i+a)*(-m+g),R=t*m,I=(-t+u+f)*(m-p+h),O=(-t+u)*(p-h),N=(u+f)*(-m+p),J=(t+n+o-a-l-u-f)*h,q=f*(-m+p+d-w-h-y+b),_=(-o+f+c)*(w+y-b),yt=(o-c)*(w-b),X=o*y,it=(f+c)*(-y+b),P=(-o+a+l)*(h+y-M),me=(o-l)*(h-M),he=(a+l)*(-y+M),Ur=n*d,Gr=l*b,Qr=i*p,Kr=u*g,Yr=c*M,Jr=R+X+Ur,Xr=F+A+x+R+_+X+it,Zr=R+I+N+J+X+P+he,Vr=v+E+A+R+X+P+me,Hr=v+A+x+R+Gr,tn=X+P+me+he+Qr,en=R+I+O+q+_+yt+X,rn=_+yt+X+it+Kr,nn=R+I+O+N+Yr;return r.set(0,0,Jr),r.set(0,1,Xr),r.set(0,2,Zr),r.set(1,0,Vr),r.set(1,1,Hr),r.set(1,2,tn),r.set(2,0,en),r.set(2,1,rn),r.set(2,2,nn),r}mmulStrassen(e){e=S.checkMatrix(e);let r=this.clone(),t=r.rows,n=r.columns,o=e.rows,i=e.columns;n!==o&&console.warn(`Multiplying ${t} x ${n} and ${o} x ${i} matrix: dimensions do not match.`);function a(c,m,g){let p=c.rows,d=c.columns;if(p===m&&d===g)return c;{let w=s.zeros(m,g);return w=w.setSubMatrix(c,0,0),w}}let l=Math.max(t,o),u=Math.max(n,i);r=a(r,l,u),e=a(e,l,u);function f(c,m,g,p){if(g<=512||p<=512)return c.mmul(m);g%2===1&&p%2===1?(c=a(c,g+1,p+1),m=a(m,g+1,p+1)):g%2===1?(c=a(c,g+1,p),m=a(m,g+1,p)):p%2===1&&(c=a(c,g,p+1),m=a(m,g,p+1));let d=parseInt(c.rows/2,10),w=parseInt(c.columns/2,10),h=c.subMatrix(0,d-1,0,w-1),y=m.subMatrix(0,d-1,0,w-1),b=c.subMatrix(0,d-1,w,c.columns-1),M=m.subMatrix(0,d-1,w,m.columns-1),F=c.subMatrix(d,c.rows-1,0,w-1),v=m.subMatrix(d,m.rows-1,0,w-1),E=c.subMatrix(d,c.rows-1,w,c.columns-1),A=m.subMatrix(d,m.rows-1,w,m.columns-1),x=f(s.add(h,E),s.add(y,A),d,w),R=f(s.add(F,E),y,d,w),I=f(h,s.sub(M,A),d,w),O=f(E,s.sub(v,y),d,w),N=f(s.add(h,b),A,d,w),J=f(s.sub(F,h),s.add(y,M),d,w),q=f(s.sub(b,E),s.add(v,A),d,w),_=s.add(x,O);_.sub(N),_.add(q);let yt=s.add(I,N),X=s.add(R,O),it=s.sub(x,R);it.add(I),it.add(J);let P=s.zeros(2*_.rows,2*_.columns);return P=P.setSubMatrix(_,0,0),P=P.setSubMatrix(yt,_.rows,0),P=P.setSubMatrix(X,0,_.columns),P=P.setSubMatrix(it,_.rows,_.columns),P.subMatrix(0,g-1,0,p-1)}return f(r,e,l,u)}scaleRows(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{min:r=0,max:t=1}=e;if(!Number.isFinite(r))throw new TypeError("min must be a number");if(!Number.isFinite(t))throw new TypeError("max must be a number");if(r>=t)throw new RangeError("min must be smaller than max");let n=new S(this.rows,this.columns);for(let o=0;o<this.rows;o++){let i=this.getRow(o);i.length>0&&Lt(i,{min:r,max:t,output:i}),n.setRow(o,i)}return n}scaleColumns(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{min:r=0,max:t=1}=e;if(!Number.isFinite(r))throw new TypeError("min must be a number");if(!Number.isFinite(t))throw new TypeError("max must be a number");if(r>=t)throw new RangeError("min must be smaller than max");let n=new S(this.rows,this.columns);for(let o=0;o<this.columns;o++){let i=this.getColumn(o);i.length&&Lt(i,{min:r,max:t,output:i}),n.setColumn(o,i)}return n}flipRows(){let e=Math.ceil(this.columns/2);for(let r=0;r<this.rows;r++)for(let t=0;t<e;t++){let n=this.get(r,t),o=this.get(r,this.columns-1-t);this.set(r,t,o),this.set(r,this.columns-1-t,n)}return this}flipColumns(){let e=Math.ceil(this.rows/2);for(let r=0;r<this.columns;r++)for(let t=0;t<e;t++){let n=this.get(t,r),o=this.get(this.rows-1-t,r);this.set(t,r,o),this.set(this.rows-1-t,r,n)}return this}kroneckerProduct(e){e=S.checkMatrix(e);let r=this.rows,t=this.columns,n=e.rows,o=e.columns,i=new S(r*n,t*o);for(let a=0;a<r;a++)for(let l=0;l<t;l++)for(let u=0;u<n;u++)for(let f=0;f<o;f++)i.set(n*a+u,o*l+f,this.get(a,l)*e.get(u,f));return i}kroneckerSum(e){if(e=S.checkMatrix(e),!this.isSquare()||!e.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let r=this.rows,t=e.rows,n=this.kroneckerProduct(S.eye(t,t)),o=S.eye(r,r).kroneckerProduct(e);return n.add(o)}transpose(){let e=new S(this.columns,this.rows);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.set(t,r,this.get(r,t));return e}sortRows(e=ir){for(let r=0;r<this.rows;r++)this.setRow(r,this.getRow(r).sort(e));return this}sortColumns(e=ir){for(let r=0;r<this.columns;r++)this.setColumn(r,this.getColumn(r).sort(e));return this}subMatrix(e,r,t,n){Ht(this,e,r,t,n);let o=new S(r-e+1,n-t+1);for(let i=e;i<=r;i++)for(let a=t;a<=n;a++)o.set(i-e,a-t,this.get(i,a));return o}subMatrixRow(e,r,t){if(r===void 0&&(r=0),t===void 0&&(t=this.columns-1),r>t||r<0||r>=this.columns||t<0||t>=this.columns)throw new RangeError("Argument out of range");let n=new S(e.length,t-r+1);for(let o=0;o<e.length;o++)for(let i=r;i<=t;i++){if(e[o]<0||e[o]>=this.rows)throw new RangeError(`Row index out of range: ${e[o]}`);n.set(o,i-r,this.get(e[o],i))}return n}subMatrixColumn(e,r,t){if(r===void 0&&(r=0),t===void 0&&(t=this.rows-1),r>t||r<0||r>=this.rows||t<0||t>=this.rows)throw new RangeError("Argument out of range");let n=new S(t-r+1,e.length);for(let o=0;o<e.length;o++)for(let i=r;i<=t;i++){if(e[o]<0||e[o]>=this.columns)throw new RangeError(`Column index out of range: ${e[o]}`);n.set(i-r,o,this.get(i,e[o]))}return n}setSubMatrix(e,r,t){if(e=S.checkMatrix(e),e.isEmpty())return this;let n=r+e.rows-1,o=t+e.columns-1;Ht(this,r,n,t,o);for(let i=0;i<e.rows;i++)for(let a=0;a<e.columns;a++)this.set(r+i,t+a,e.get(i,a));return this}concat(e,r="row"){switch(e=S.checkMatrix(e),r){case"row":{if(this.columns!==e.columns)throw new RangeError("both matrices must have the same number of columns");let t=new S(this.rows+e.rows,this.columns);return t.setSubMatrix(this,0,0),t.setSubMatrix(e,this.rows,0),t}case"column":{if(this.rows!==e.rows)throw new RangeError("both matrices must have the same number of rows");let t=new S(this.rows,this.columns+e.columns);return t.setSubMatrix(this,0,0),t.setSubMatrix(e,0,this.columns),t}default:throw new Error(`invalid option: ${r}`)}}selection(e,r){ze(this,e),Ce(this,r);let t=new S(e.length,r.length);for(let n=0;n<e.length;n++){let o=e[n];for(let i=0;i<r.length;i++){let a=r[i];t.set(n,i,this.get(o,a))}}return t}trace(){let e=Math.min(this.rows,this.columns),r=0;for(let t=0;t<e;t++)r+=this.get(t,t);return r}clone(){return this.constructor.copy(this,new S(this.rows,this.columns))}static copy(e,r){for(let[t,n,o]of e.entries())r.set(t,n,o);return r}sum(e){switch(e){case"row":return We(this);case"column":return De(this);case void 0:return Ue(this);default:throw new Error(`invalid option: ${e}`)}}product(e){switch(e){case"row":return Ge(this);case"column":return Qe(this);case void 0:return Ke(this);default:throw new Error(`invalid option: ${e}`)}}mean(e){let r=this.sum(e);switch(e){case"row":{for(let t=0;t<this.rows;t++)r[t]/=this.columns;return r}case"column":{for(let t=0;t<this.columns;t++)r[t]/=this.rows;return r}case void 0:return r/this.size;default:throw new Error(`invalid option: ${e}`)}}variance(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let{unbiased:t=!0,mean:n=this.mean(e)}=r;if(typeof t!="boolean")throw new TypeError("unbiased must be a boolean");switch(e){case"row":{if(!T(n))throw new TypeError("mean must be an array");return Ye(this,t,n)}case"column":{if(!T(n))throw new TypeError("mean must be an array");return Je(this,t,n)}case void 0:{if(typeof n!="number")throw new TypeError("mean must be a number");return Xe(this,t,n)}default:throw new Error(`invalid option: ${e}`)}}standardDeviation(e,r){typeof e=="object"&&(r=e,e=void 0);let t=this.variance(e,r);if(e===void 0)return Math.sqrt(t);for(let n=0;n<t.length;n++)t[n]=Math.sqrt(t[n]);return t}center(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let{center:t=this.mean(e)}=r;switch(e){case"row":{if(!T(t))throw new TypeError("center must be an array");return Ze(this,t),this}case"column":{if(!T(t))throw new TypeError("center must be an array");return Ve(this,t),this}case void 0:{if(typeof t!="number")throw new TypeError("center must be a number");return He(this,t),this}default:throw new Error(`invalid option: ${e}`)}}scale(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let t=r.scale;switch(e){case"row":{if(t===void 0)t=tr(this);else if(!T(t))throw new TypeError("scale must be an array");return er(this,t),this}case"column":{if(t===void 0)t=rr(this);else if(!T(t))throw new TypeError("scale must be an array");return nr(this,t),this}case void 0:{if(t===void 0)t=or(this);else if(typeof t!="number")throw new TypeError("scale must be a number");return sr(this,t),this}default:throw new Error(`invalid option: ${e}`)}}toString(e){return Vt(this,e)}[Symbol.iterator](){return this.entries()}*entries(){for(let e=0;e<this.rows;e++)for(let r=0;r<this.columns;r++)yield[e,r,this.get(e,r)]}*values(){for(let e=0;e<this.rows;e++)for(let r=0;r<this.columns;r++)yield this.get(e,r)}};j.prototype.klass="Matrix";typeof Symbol<"u"&&(j.prototype[Symbol.for("nodejs.util.inspect.custom")]=_e);function ir(s,e){return s-e}function oo(s){return s.every(e=>typeof e=="number")}j.random=j.rand;j.randomInt=j.randInt;j.diagonal=j.diag;j.prototype.diagonal=j.prototype.diag;j.identity=j.eye;j.prototype.negate=j.prototype.neg;j.prototype.tensorProduct=j.prototype.kroneckerProduct;var S=class s extends j{data;#t(e,r){if(this.data=[],Number.isInteger(r)&&r>=0)for(let t=0;t<e;t++)this.data.push(new Float64Array(r));else throw new TypeError("nColumns must be a positive integer");this.rows=e,this.columns=r}constructor(e,r){if(super(),s.isMatrix(e))this.#t(e.rows,e.columns),s.copy(e,this);else if(Number.isInteger(e)&&e>=0)this.#t(e,r);else if(T(e)){let t=e;if(e=t.length,r=e?t[0].length:0,typeof r!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let n=0;n<e;n++){if(t[n].length!==r)throw new RangeError("Inconsistent array dimensions");if(!oo(t[n]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(t[n]))}this.rows=e,this.columns=r}else throw new TypeError("First argument must be a positive number or an array")}set(e,r,t){return this.data[e][r]=t,this}get(e,r){return this.data[e][r]}removeRow(e){return U(this,e),this.data.splice(e,1),this.rows-=1,this}addRow(e,r){return r===void 0&&(r=e,e=this.rows),U(this,e,!0),r=Float64Array.from(rt(this,r)),this.data.splice(e,0,r),this.rows+=1,this}removeColumn(e){G(this,e);for(let r=0;r<this.rows;r++){let t=new Float64Array(this.columns-1);for(let n=0;n<e;n++)t[n]=this.data[r][n];for(let n=e+1;n<this.columns;n++)t[n-1]=this.data[r][n];this.data[r]=t}return this.columns-=1,this}addColumn(e,r){typeof r>"u"&&(r=e,e=this.columns),G(this,e,!0),r=nt(this,r);for(let t=0;t<this.rows;t++){let n=new Float64Array(this.columns+1),o=0;for(;o<e;o++)n[o]=this.data[t][o];for(n[o++]=r[t];o<this.columns+1;o++)n[o]=this.data[t][o-1];this.data[t]=n}return this.columns+=1,this}};Pe(j,S);var dt=class extends j{constructor(e){super(),this.data=e,this.rows=e.length,this.columns=e[0].length}set(e,r,t){return this.data[e][r]=t,this}get(e,r){return this.data[e][r]}};function ar(s){let e=s.data,r=s.rows;for(let t=0;t<r;t++){let n=e[t];for(let o=t+1;o<r;o++){let i=n[o];n[o]=e[o][t],e[o][t]=i}}return s}function te(s,e){let r=0;return Math.abs(s)>Math.abs(e)?(r=e/s,Math.abs(s)*Math.sqrt(1+r*r)):e!==0?(r=s/e,Math.abs(e)*Math.sqrt(1+r*r)):0}var et=class{constructor(e,r={}){let{assumeSymmetric:t=!1}=r;if(e=dt.checkMatrix(e),!e.isSquare())throw new Error("Matrix is not a square matrix");if(e.isEmpty())throw new Error("Matrix must be non-empty");let n=e.columns,o=new S(n,n),i=new Float64Array(n),a=new Float64Array(n),l=e,u,f,c=!1;if(t?c=!0:c=e.isSymmetric(),c){for(u=0;u<n;u++)for(f=0;f<n;f++)o.set(f,u,l.get(u,f));so(n,a,i,o),io(n,a,i,o),ar(o)}else{let m=new S(n,n),g=new Float64Array(n);for(f=0;f<n;f++)for(u=0;u<n;u++)m.set(u,f,l.get(u,f));ao(n,m,g,o),lo(n,a,i,o,m)}this.n=n,this.e=a,this.d=i,this.V=o}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let e=this.n,r=this.e,t=this.d,n=new S(e,e),o,i;for(o=0;o<e;o++){for(i=0;i<e;i++)n.set(o,i,0);n.set(o,o,t[o]),r[o]>0?n.set(o,o+1,r[o]):r[o]<0&&n.set(o,o-1,r[o])}return n}};function so(s,e,r,t){let n,o,i,a,l,u,f,c;for(l=0;l<s;l++)r[l]=t.get(l,s-1);for(a=s-1;a>0;a--){for(c=0,i=0,u=0;u<a;u++)c=c+Math.abs(r[u]);if(c===0)for(e[a]=r[a-1],l=0;l<a;l++)r[l]=t.get(l,a-1),t.set(l,a,0),t.set(a,l,0);else{for(u=0;u<a;u++)r[u]/=c,i+=r[u]*r[u];for(n=r[a-1],o=Math.sqrt(i),n>0&&(o=-o),e[a]=c*o,i=i-n*o,r[a-1]=n-o,l=0;l<a;l++)e[l]=0;for(l=0;l<a;l++){for(n=r[l],t.set(a,l,n),o=e[l]+t.get(l,l)*n,u=l+1;u<=a-1;u++)o+=t.get(l,u)*r[u],e[u]+=t.get(l,u)*n;e[l]=o}for(n=0,l=0;l<a;l++)e[l]/=i,n+=e[l]*r[l];for(f=n/(i+i),l=0;l<a;l++)e[l]-=f*r[l];for(l=0;l<a;l++){for(n=r[l],o=e[l],u=l;u<=a-1;u++)t.set(l,u,t.get(l,u)-(n*e[u]+o*r[u]));r[l]=t.get(l,a-1),t.set(l,a,0)}}r[a]=i}for(a=0;a<s-1;a++){if(t.set(a,s-1,t.get(a,a)),t.set(a,a,1),i=r[a+1],i!==0){for(u=0;u<=a;u++)r[u]=t.get(a+1,u)/i;for(l=0;l<=a;l++){for(o=0,u=0;u<=a;u++)o+=t.get(a+1,u)*t.get(l,u);for(u=0;u<=a;u++)t.set(l,u,t.get(l,u)-o*r[u])}}for(u=0;u<=a;u++)t.set(a+1,u,0)}for(l=0;l<s;l++)r[l]=t.get(l,s-1),t.set(l,s-1,0);t.set(s-1,s-1,1),e[0]=0}function io(s,e,r,t){let n,o,i,a,l,u,f,c,m,g,p,d,w,h,y,b,M;for(i=1;i<s;i++)e[i-1]=e[i];e[s-1]=0;let F=0,v=0,E=Number.EPSILON;for(u=0;u<s;u++){for(v=Math.max(v,Math.abs(r[u])+Math.abs(e[u])),f=u;f<s&&!(Math.abs(e[f])<=E*v);)f++;if(f>u){M=0;do{for(M=M+1,n=r[u],c=(r[u+1]-n)/(2*e[u]),m=te(c,1),c<0&&(m=-m),r[u]=e[u]/(c+m),r[u+1]=e[u]*(c+m),g=r[u+1],o=n-r[u],i=u+2;i<s;i++)r[i]-=o;for(F=F+o,c=r[f],p=1,d=p,w=p,h=e[u+1],y=0,b=0,i=f-1;i>=u;i--)for(w=d,d=p,b=y,n=p*e[i],o=p*c,m=te(c,e[i]),e[i+1]=y*m,y=e[i]/m,p=c/m,c=p*r[i]-y*n,r[i+1]=o+y*(p*n+y*r[i]),l=0;l<s;l++)o=t.get(i+1,l),t.set(i+1,l,y*t.get(i,l)+p*o),t.set(i,l,p*t.get(i,l)-y*o);c=-y*b*w*h*e[u]/g,e[u]=y*c,r[u]=p*c}while(Math.abs(e[u])>E*v)}r[u]=r[u]+F,e[u]=0}for(i=0;i<s-1;i++){for(l=i,c=r[i],a=i+1;a<s;a++)r[a]<c&&(l=a,c=r[a]);if(l!==i)for(r[l]=r[i],r[i]=c,a=0;a<s;a++)c=t.get(i,a),t.set(i,a,t.get(l,a)),t.set(l,a,c)}}function ao(s,e,r,t){let n=0,o=s-1,i,a,l,u,f,c,m;for(c=n+1;c<=o-1;c++){for(m=0,u=c;u<=o;u++)m=m+Math.abs(e.get(u,c-1));if(m!==0){for(l=0,u=o;u>=c;u--)r[u]=e.get(u,c-1)/m,l+=r[u]*r[u];for(a=Math.sqrt(l),r[c]>0&&(a=-a),l=l-r[c]*a,r[c]=r[c]-a,f=c;f<s;f++){for(i=0,u=o;u>=c;u--)i+=r[u]*e.get(u,f);for(i=i/l,u=c;u<=o;u++)e.set(u,f,e.get(u,f)-i*r[u])}for(u=0;u<=o;u++){for(i=0,f=o;f>=c;f--)i+=r[f]*e.get(u,f);for(i=i/l,f=c;f<=o;f++)e.set(u,f,e.get(u,f)-i*r[f])}r[c]=m*r[c],e.set(c,c-1,m*a)}}for(u=0;u<s;u++)for(f=0;f<s;f++)t.set(u,f,u===f?1:0);for(c=o-1;c>=n+1;c--)if(e.get(c,c-1)!==0){for(u=c+1;u<=o;u++)r[u]=e.get(u,c-1);for(f=c;f<=o;f++){for(a=0,u=c;u<=o;u++)a+=r[u]*t.get(u,f);for(a=a/r[c]/e.get(c,c-1),u=c;u<=o;u++)t.set(u,f,t.get(u,f)+a*r[u])}}}function lo(s,e,r,t,n){let o=s-1,i=0,a=s-1,l=Number.EPSILON,u=0,f=0,c=0,m=0,g=0,p=0,d=0,w=0,h,y,b,M,F,v,E,A,x,R,I,O,N,J,q;for(h=0;h<s;h++)for((h<i||h>a)&&(r[h]=n.get(h,h),e[h]=0),y=Math.max(h-1,0);y<s;y++)f=f+Math.abs(n.get(h,y));for(;o>=i;){for(M=o;M>i&&(p=Math.abs(n.get(M-1,M-1))+Math.abs(n.get(M,M)),p===0&&(p=f),!(Math.abs(n.get(M,M-1))<l*p));)M--;if(M===o)n.set(o,o,n.get(o,o)+u),r[o]=n.get(o,o),e[o]=0,o--,w=0;else if(M===o-1){if(E=n.get(o,o-1)*n.get(o-1,o),c=(n.get(o-1,o-1)-n.get(o,o))/2,m=c*c+E,d=Math.sqrt(Math.abs(m)),n.set(o,o,n.get(o,o)+u),n.set(o-1,o-1,n.get(o-1,o-1)+u),A=n.get(o,o),m>=0){for(d=c>=0?c+d:c-d,r[o-1]=A+d,r[o]=r[o-1],d!==0&&(r[o]=A-E/d),e[o-1]=0,e[o]=0,A=n.get(o,o-1),p=Math.abs(A)+Math.abs(d),c=A/p,m=d/p,g=Math.sqrt(c*c+m*m),c=c/g,m=m/g,y=o-1;y<s;y++)d=n.get(o-1,y),n.set(o-1,y,m*d+c*n.get(o,y)),n.set(o,y,m*n.get(o,y)-c*d);for(h=0;h<=o;h++)d=n.get(h,o-1),n.set(h,o-1,m*d+c*n.get(h,o)),n.set(h,o,m*n.get(h,o)-c*d);for(h=i;h<=a;h++)d=t.get(h,o-1),t.set(h,o-1,m*d+c*t.get(h,o)),t.set(h,o,m*t.get(h,o)-c*d)}else r[o-1]=A+c,r[o]=A+c,e[o-1]=d,e[o]=-d;o=o-2,w=0}else{if(A=n.get(o,o),x=0,E=0,M<o&&(x=n.get(o-1,o-1),E=n.get(o,o-1)*n.get(o-1,o)),w===10){for(u+=A,h=i;h<=o;h++)n.set(h,h,n.get(h,h)-A);p=Math.abs(n.get(o,o-1))+Math.abs(n.get(o-1,o-2)),A=x=.75*p,E=-.4375*p*p}if(w===30&&(p=(x-A)/2,p=p*p+E,p>0)){for(p=Math.sqrt(p),x<A&&(p=-p),p=A-E/((x-A)/2+p),h=i;h<=o;h++)n.set(h,h,n.get(h,h)-p);u+=p,A=x=E=.964}for(w=w+1,F=o-2;F>=M&&(d=n.get(F,F),g=A-d,p=x-d,c=(g*p-E)/n.get(F+1,F)+n.get(F,F+1),m=n.get(F+1,F+1)-d-g-p,g=n.get(F+2,F+1),p=Math.abs(c)+Math.abs(m)+Math.abs(g),c=c/p,m=m/p,g=g/p,!(F===M||Math.abs(n.get(F,F-1))*(Math.abs(m)+Math.abs(g))<l*(Math.abs(c)*(Math.abs(n.get(F-1,F-1))+Math.abs(d)+Math.abs(n.get(F+1,F+1))))));)F--;for(h=F+2;h<=o;h++)n.set(h,h-2,0),h>F+2&&n.set(h,h-3,0);for(b=F;b<=o-1&&(J=b!==o-1,b!==F&&(c=n.get(b,b-1),m=n.get(b+1,b-1),g=J?n.get(b+2,b-1):0,A=Math.abs(c)+Math.abs(m)+Math.abs(g),A!==0&&(c=c/A,m=m/A,g=g/A)),A!==0);b++)if(p=Math.sqrt(c*c+m*m+g*g),c<0&&(p=-p),p!==0){for(b!==F?n.set(b,b-1,-p*A):M!==F&&n.set(b,b-1,-n.get(b,b-1)),c=c+p,A=c/p,x=m/p,d=g/p,m=m/c,g=g/c,y=b;y<s;y++)c=n.get(b,y)+m*n.get(b+1,y),J&&(c=c+g*n.get(b+2,y),n.set(b+2,y,n.get(b+2,y)-c*d)),n.set(b,y,n.get(b,y)-c*A),n.set(b+1,y,n.get(b+1,y)-c*x);for(h=0;h<=Math.min(o,b+3);h++)c=A*n.get(h,b)+x*n.get(h,b+1),J&&(c=c+d*n.get(h,b+2),n.set(h,b+2,n.get(h,b+2)-c*g)),n.set(h,b,n.get(h,b)-c),n.set(h,b+1,n.get(h,b+1)-c*m);for(h=i;h<=a;h++)c=A*t.get(h,b)+x*t.get(h,b+1),J&&(c=c+d*t.get(h,b+2),t.set(h,b+2,t.get(h,b+2)-c*g)),t.set(h,b,t.get(h,b)-c),t.set(h,b+1,t.get(h,b+1)-c*m)}}}if(f!==0){for(o=s-1;o>=0;o--)if(c=r[o],m=e[o],m===0)for(M=o,n.set(o,o,1),h=o-1;h>=0;h--){for(E=n.get(h,h)-c,g=0,y=M;y<=o;y++)g=g+n.get(h,y)*n.get(y,o);if(e[h]<0)d=E,p=g;else if(M=h,e[h]===0?n.set(h,o,E!==0?-g/E:-g/(l*f)):(A=n.get(h,h+1),x=n.get(h+1,h),m=(r[h]-c)*(r[h]-c)+e[h]*e[h],v=(A*p-d*g)/m,n.set(h,o,v),n.set(h+1,o,Math.abs(A)>Math.abs(d)?(-g-E*v)/A:(-p-x*v)/d)),v=Math.abs(n.get(h,o)),l*v*v>1)for(y=h;y<=o;y++)n.set(y,o,n.get(y,o)/v)}else if(m<0)for(M=o-1,Math.abs(n.get(o,o-1))>Math.abs(n.get(o-1,o))?(n.set(o-1,o-1,m/n.get(o,o-1)),n.set(o-1,o,-(n.get(o,o)-c)/n.get(o,o-1))):(q=Bt(0,-n.get(o-1,o),n.get(o-1,o-1)-c,m),n.set(o-1,o-1,q[0]),n.set(o-1,o,q[1])),n.set(o,o-1,0),n.set(o,o,1),h=o-2;h>=0;h--){for(R=0,I=0,y=M;y<=o;y++)R=R+n.get(h,y)*n.get(y,o-1),I=I+n.get(h,y)*n.get(y,o);if(E=n.get(h,h)-c,e[h]<0)d=E,g=R,p=I;else if(M=h,e[h]===0?(q=Bt(-R,-I,E,m),n.set(h,o-1,q[0]),n.set(h,o,q[1])):(A=n.get(h,h+1),x=n.get(h+1,h),O=(r[h]-c)*(r[h]-c)+e[h]*e[h]-m*m,N=(r[h]-c)*2*m,O===0&&N===0&&(O=l*f*(Math.abs(E)+Math.abs(m)+Math.abs(A)+Math.abs(x)+Math.abs(d))),q=Bt(A*g-d*R+m*I,A*p-d*I-m*R,O,N),n.set(h,o-1,q[0]),n.set(h,o,q[1]),Math.abs(A)>Math.abs(d)+Math.abs(m)?(n.set(h+1,o-1,(-R-E*n.get(h,o-1)+m*n.get(h,o))/A),n.set(h+1,o,(-I-E*n.get(h,o)-m*n.get(h,o-1))/A)):(q=Bt(-g-x*n.get(h,o-1),-p-x*n.get(h,o),d,m),n.set(h+1,o-1,q[0]),n.set(h+1,o,q[1]))),v=Math.max(Math.abs(n.get(h,o-1)),Math.abs(n.get(h,o))),l*v*v>1)for(y=h;y<=o;y++)n.set(y,o-1,n.get(y,o-1)/v),n.set(y,o,n.get(y,o)/v)}for(h=0;h<s;h++)if(h<i||h>a)for(y=h;y<s;y++)t.set(h,y,n.get(h,y));for(y=s-1;y>=i;y--)for(h=i;h<=a;h++){for(d=0,b=i;b<=Math.min(y,a);b++)d=d+t.get(h,b)*n.get(b,y);t.set(h,y,d)}}}function Bt(s,e,r,t){let n,o;return Math.abs(r)>Math.abs(t)?(n=t/r,o=r+n*t,[(s+n*e)/o,(e-n*s)/o]):(n=r/t,o=t+n*r,[(n*s+e)/o,(n*e-s)/o])}var uo=1e-9,co=1e-13,fo=1e-6;function lr(s,e,r){let t=vt(s,r);if(!t)throw new Error("mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate");let[n,o]=[0,0];for(let c=0;c<r;c+=1)for(let m=0;m<r;m+=1)n=Math.max(n,Math.abs(e[c*r+m]-e[m*r+c])),o=Math.max(o,Math.abs(e[c*r+m]));if(n>uo*o)return{...re(t,ee(Et(t,e,r),r,!1),r),symmetric:!1};let i=e.map((c,m)=>(c+e[m%r*r+Math.floor(m/r)])/2),a=vt(i,r),l=a&&ee(Et(a,s,r),r,!0),u=l?Math.max(...l.re):0;if(!a||!l||Math.min(...l.re)<=0||1/u<=co*r/Math.min(...l.re))return{...re(t,ee(Et(t,i,r),r,!0),r),symmetric:!0};let f=re(a,{re:l.re.map(c=>1/c),vectors:l.vectors},r);return{squares:f.squares,shapes:f.shapes.map((c,m)=>c*Math.sqrt(f.squares[m%r])),symmetric:!0}}function ee(s,e,r){let t=r?s.map((u,f)=>(u+s[f%e*e+Math.floor(f/e)])/2):s,n=new et(S.from1DArray(e,e,t),{assumeSymmetric:r}),{realEigenvalues:o,imaginaryEigenvalues:i,eigenvectorMatrix:a}=n,l=Float64Array.from(a.to1DArray());if(!r){for(let u=1;u<e;u+=1)if(i[u]<0)for(let f=0;f<e;f+=1)l[f*e+u]=l[f*e+u-1]}for(let u=0;u<e;u+=1){let f=Math.hypot(...Array.from({length:e},(c,m)=>l[m*e+u]));for(let c=0;c<e;c+=1)l[c*e+u]/=f}return{re:Float64Array.from(o),vectors:l}}function re(s,{re:e,vectors:r},t){let n=Array.from(e.keys()).sort((i,a)=>e[i]-e[a]),o=new Float64Array(t*t);return n.forEach((i,a)=>{for(let l=0;l<t;l+=1)o[l*t+a]=r[l*t+i]}),Dt(s,o,t,t),{squares:Float64Array.from(n,i=>e[i]),shapes:o}}function ur(s,e,r,t,n){let o=n.symmetric?n.shapes:ho(s,t),i=d=>$(o,$(d,o,t,t,t),t,t,t,!0),[a,l]=[i(r),i(e)];if(n.symmetric)for(let d=0;d<t*t;d+=1)a[d]=d%(t+1)?0:n.squares[d/(t+1)];let u=Array.from({length:t},(d,w)=>Math.sqrt(Math.abs(a[w*(t+1)]))),f=fo*Math.max(...u)||1,c=u.map(d=>Math.max(d,f)),m=S.zeros(2*t,2*t);for(let d=0;d<t;d+=1){m.set(d,t+d,c[d]);for(let w=0;w<t;w+=1)m.set(t+d,w,-a[d*t+w]/c[w]),m.set(t+d,t+w,-l[d*t+w])}let g=new et(m,{assumeSymmetric:!1}),p={re:Float64Array.from(g.realEigenvalues),im:Float64Array.from(g.imaginaryEigenvalues)};return{count:2*t,values:p,shapes:mo(g.eigenvectorMatrix,p.im,o,c,t)}}function mo(s,e,r,t,n){let o={re:new Float64Array(2*n*n),im:new Float64Array(2*n*n)};for(let i=0;i<2*n;i+=1)for(let a=0;a<n;a+=1)o.re[2*n*a+i]=s.get(a,e[i]<0?i-1:i)/t[a],o.im[2*n*a+i]=(e[i]>0?s.get(a,i+1):e[i]<0?-s.get(a,i):0)/t[a];return{re:$(r,o.re,n,n,2*n),im:$(r,o.im,n,n,2*n)}}function ho(s,e){let r=Float64Array.from({length:e*e},(t,n)=>n%(e+1)?0:1);return Dt(vt(s,e),r,e,e),r}var po=["settling","vibration.residual","vibration.nominal"];function C(s,e=3){return Q(s,e)}function ne(s,e){if(s.length<2)return e[0];let r=0;for(let t=1;t<s.length;t+=1)r+=(e[t]+e[t-1])/2*(s[t]-s[t-1]);return r/(s[s.length-1]-s[0])}function cr(s,e,r){let t={},n=e.deviation?.data;if(n){let o=pt(n),i=n[n.length-1];t["deviation.max"]={value:n[o],note:`at ${C(s[o])} s; ${V(i,"m")} at the end of the run`},t["deviation.rms"]={value:Math.sqrt(ne(s,n.map(a=>a*a))),note:"over the run"}}return{...t,...go(s,r,n!==void 0)}}function go(s,e,r){let t=s[s.length-1];if(e!==null&&e<=t*(1+1e-9))return{};let n="what moves the robot changes up to the end of the run",o=`the run ends at ${C(t,6)} s, the move at ${C(e??0,6)} s`,i=e===null?n:`${o}: simulate longer to see it settle`,a={value:null,note:e===null?n:"the run ends with the move"},l={settling:{value:null,note:`not seen: ${i}`},"vibration.residual":a};return r?{...l,"vibration.nominal":a}:l}function fr(s){let e={},r=po.filter(t=>t!=="vibration.nominal"||"deviation.max"in s);for(let t of r)e[t]={value:null,note:"the run broke off"};for(let[t,{value:n,note:o}]of Object.entries(s))r.includes(t)||(e[t]={value:n,note:`until it broke off: ${o}`});return e}function mr(s,e){if(!s.energy||!s.energy_balance)return{};let{energy:r,work:t}=s,n=r.shape[1],o=Math.max(r.data.reduce((l,u,f)=>Math.max(l,Math.abs(u-r.data[f%n])),0),t.data.reduce((l,u)=>Math.max(l,Math.abs(u)),0)),i=Math.abs(s.energy_balance.data[pt(s.energy_balance.data.subarray(0,e))]),a=o?`worst residual, ${V(i,"J")}, over ${V(o,"J")} moved`:"nothing moved";return{"energy.residual":{value:o?i/o:null,note:a}}}var yo=8,oe=1e-5,wo=Math.SQRT1_2,bo=1e-9;function hr(s,e,r,t){let n=Object.entries(s).flatMap(([a,l])=>l.filter(u=>u.frequency>0).slice(0,yo).map(u=>[a,u])),o=Ao(n,r,t),i=e.flatMap(a=>a.rings&&a.damping<wo?[{at:a.rings,label:a.element}]:[]);return{vibration:{modes:o,marks:i.sort((a,l)=>a.at-l.at)},facts:Fo(s)}}function Fo({controlled:s,locked:e}){if(!s)return{};let r=i=>i.reduce((a,{rings:l,frequency:u})=>l&&u<(a??1/0)?u:a,null),[t,n]=[r(s),r(e??[])],o=t===null?"no vibration under control":n===null?"":`${C(n,4)} Hz with the motors locked`;return{"frequency.first":{value:t,note:o}}}function Ao(s,e,r){let t=e.length,n=new Float64Array((1+4*s.length)*t);n.set(e),s.forEach(([,{re:f,im:c}],m)=>{let g=f.reduce((p,d,w)=>Math.max(p,Math.hypot(d,c[w])),0);for(let p=0;p<t;p+=1){let[d,w]=[oe*f[p]/g,oe*c[p]/g];[d,w,-d,-w].forEach((h,y)=>{n[(1+4*m+y)*t+p]=e[p]+h})}});let{data:o,shape:i}=r(n,1+4*s.length),a=o.length/(1+4*s.length),l=f=>Float64Array.from({length:a},(c,m)=>(o[f*a+m]-o[(f+2)*a+m])/(2*oe)),u=f=>({data:Float32Array.from(f),shape:i.slice(1)});return s.map(([f,c],m)=>{let[g,p]=Mo(l(1+4*m),l(2+4*m));return{case:f,frequency:c.frequency,damping:c.damping,element:c.element,rest:u(o.subarray(0,a)),real:u(g),imaginary:u(p)}})}function Mo(s,e){let[r,t]=[0,0];for(let u=0;u<s.length;u+=3){let f=Math.hypot(...s.subarray(u,u+3),...e.subarray(u,u+3));f>t&&([r,t]=[u,f])}if(!t)return[s,e];let n=[0,1,2].map(u=>Math.hypot(s[r+u],e[r+u])),o=r+n.indexOf(Math.max(...n)),i=Math.hypot(s[o],e[o])*t,[a,l]=[s[o]/i,-e[o]/i];return[s.map((u,f)=>a*u-l*e[f]),s.map((u,f)=>l*u+a*e[f])]}function pr(s,e){let[r,t]=[s.values.re[e],s.values.im[e]],n=Math.hypot(r,t);return{size:n,rings:t>bo*n?t/(2*Math.PI):null,damping:n?-r/n:0}}function gr(s,e,r,t,n){let o=i=>Float64Array.from({length:r},(a,l)=>{let u=0;for(let f=0;f<t;f+=1)u+=n(l,f)*i[f*s.count+e];return u});return{re:o(s.shapes.re),im:o(s.shapes.im)}}function dr(s,e,r,t){let{count:n,shapes:o}=e,i=w=>h=>{if(!t)return w(h);let y=0;for(let b=0;b<r;b+=1)y+=t[h*r+b]*w(b);return y},a=(w,h)=>{let y=0;for(let b=0;b<r;b+=1)y+=w(b)*h(b);return y},l=se(s.shapes,r,r),[u,f]=[se(o.re,r,n),se(o.im,r,n)],c=l.map(w=>Float64Array.from({length:r},(h,y)=>i(b=>w[b])(y))),m=w=>a(h=>w[h],i(h=>w[h])),[g,p]=[l.map(w=>Math.sqrt(m(w))),u.map((w,h)=>Math.sqrt(m(w)+m(f[h])))],d=new Float64Array(r*n);for(let w=0;w<r;w+=1)for(let h=0;h<n;h+=1){let[y,b]=[u,f].map(M=>a(F=>c[w][F],F=>M[h][F]));d[w*n+h]=Math.hypot(y,b)/(g[w]*p[h])}return d}function se(s,e,r){return Array.from({length:r},(t,n)=>Float64Array.from({length:e},(o,i)=>s[i*r+n]))}function So({values:s,count:e}){let r=Array.from({length:e},(t,n)=>Math.hypot(s.re[n],s.im[n]));return{rings:r.map((t,n)=>s.im[n]>1e-9*t),stands:r.map((t,n)=>Math.abs(s.im[n])<=1e-9*t)}}function yr(s,e,r){let{count:t,values:n}=e,{rings:o,stands:i}=So(e),a=new Float64Array(t);Array.from({length:t},(u,f)=>f).sort((u,f)=>n.re[f]-n.re[u]).forEach((u,f)=>{a[u]=f});let l=Float64Array.from(s,(u,f)=>{let c=f%t;return!o[c]&&!i[c]?100:a[c]/(10*t)-u*u-(o[c]?10:0)});return vo(l,r,t)}function vo(s,e,r){let[t,n]=[new Float64Array(e+1),new Float64Array(r+1)],o=new Int32Array(r+1);for(let a=1;a<=e;a+=1){let l=new Float64Array(r+1).fill(1/0),u=new Int32Array(r+1),f=new Uint8Array(r+1);o[0]=a;let c=0;for(;o[c];){f[c]=1;let[m,g]=[1/0,0];for(let p=1;p<=r;p+=1){if(f[p])continue;let d=s[(o[c]-1)*r+p-1]-t[o[c]]-n[p];d<l[p]&&(l[p]=d,u[p]=c),l[p]<m&&(m=l[p],g=p)}for(let p=0;p<=r;p+=1)f[p]?(t[o[p]]+=m,n[p]-=m):l[p]-=m;c=g}for(;c;c=u[c])o[c]=o[u[c]]}let i=new Array(e).fill(-1);for(let a=1;a<=r;a+=1)o[a]&&(i[o[a]-1]=a-1);return i}var Eo=1e-13,ko=1e-13,xo="whole arm, free",Ro="whole arm, in its weight and loads";function Fr(s,e,r,{blocks:t,schedule:n,info:o},i){if(!e.modes)return{vibration:e.noModes,facts:{}};try{let{rest:a,linear:l}=wr(s,e,r,n,L(e.modes.rest)),u=Object.fromEntries(e.modes.cases.map(({name:d,moving:w})=>[d,br(e,t,l,d,w)])),{name:f,moving:c}=e.modes.cases.find(d=>d.name==="controlled"&&d.moving.length)??e.modes.cases.find(d=>d.name==="locked"),m=jo(e,o,n,i),g=m&&wr(s,e,r,n,m,i.times[i.times.length-1]).linear,p=g?br(e,t,g,f,c):[];return hr(u,p,a,(d,w)=>jt(s,e,t,d,w).line)}catch(a){return{vibration:a instanceof Error?a.message:String(a),facts:{}}}}function wr(s,e,r,t,n,o=0){let i=null;return Qt(e,r,"real",n,(a,l)=>(i=Oe(s,e,ut(e.map,a,"real"),t,l,o),i&&i.rest)),i}function jo(s,e,r,t){if(!s.modes.end)return null;let n=L(s.modes.end).slice(),[o,i]=[t.times[t.times.length-1],t.series.q.data.subarray(-n.length)],a=new Map(e.commanded);for(let l=0;l<n.length;l+=1){let u=a.get(l);s.modes.free.includes(l)||(n[l]=u===void 0?i[l]:at(r,u,o))}return n}function br(s,e,r,t,n){let o=Math.sqrt(r.mass.length),i=n.length;if(!i)return[];let a=w=>Float64Array.from({length:i*i},(h,y)=>w[n[Math.floor(y/i)]*o+n[y%i]]),[l,u,f]=[a(r.mass),a(r.damping),a(r.stiffness)],c=t==="controlled";c&&s.modes.servos.forEach(({coordinate:w},h)=>{let y=n.indexOf(w)*(i+1);f[y]+=e.servos[2*h],u[y]+=e.servos[2*h+1]});let m=lr(l,f,i),g=ur(l,u,f,i,m),p=yr(dr(m,g,i,l),g,i),d=ko*i*m.squares.reduce((w,h)=>Math.max(w,Math.abs(h)),0);return Array.from({length:i},(w,h)=>{let y=new Float64Array(o);n.forEach((O,N)=>{y[O]=m.shapes[N*i+h]});let b=Lo(s,e,r.elastic,y,c),M=gr(g,p[h],o,i,(O,N)=>n[N]===O?1:0),F=m.squares[h],v=b.reduce((O,{energy:N})=>O+N,0);if(Math.abs(F)<=d&&v<=d)return{frequency:0,rings:null,damping:0,element:xo,...M};let{size:E,rings:A,damping:x}=pr(g,p[h]),R=(c&&A?E:Math.sqrt(Math.max(F,0)))/(2*Math.PI),I=b.reduce((O,N)=>N.energy>O.energy?N:O,b[0]);return{frequency:R,rings:A,damping:Math.abs(x)>Eo?x:0,element:v>d&&I?I.element:Ro,...M}})}function Lo(s,e,r,t,n){let o=t.length,i=f=>{let c=0;for(let m=0;m<o;m+=1)c+=r[f*o+m]*t[m];return c},{springs:a,servos:l}=s.modes,u=a.map(({element:f,rows:c,gear:m})=>{if(!m)return{element:f,energy:c.reduce((p,d)=>p+t[d]*i(d),0)};let g=r[c[0]*(o+1)];return{element:f,energy:g?i(c[0])**2/g:0}});return n?[...u,...l.map(({coordinate:f,element:c},m)=>({element:c,energy:e.servos[2*m]*t[f]**2}))]:u}var Ar=1e-6,Io=1e-11,Mr=.5,ie=40,Oo=.1,Sr=24;async function vr(s,e,r,t,n,o,i){let{free:a,gross:l}=e.split;if(!a.length)return{};let u=n.length,f=o.q.shape[1],c=h=>Z({matrix:l,constant:{data:new Float64Array(f),shape:[f]}},o[h].data,u),m=Mt(e,r,t,n,o),g={engine:s,blocks:r,free:a,size:f,places:m.length/u,weight:L(e.split.weight),q:o.q.data.slice(),rates:c("v"),gains:c("a"),wrenches:m},p=o.deformation.data,d=null;for(let h=0;h<u;h+=Sr){let y=Array.from({length:Math.min(Sr,u-h)},(b,M)=>h+M);if(h&&Bo(g,p,Z(e.deflections,g.q.subarray((h-1)*f,h*f),1),y),d=No(g,o.q.data,y,d),!d)return{};await i()}let w=Z(e.deflections,g.q,u);return{deformation_stationary:k(w,u,a.length),deformation_oscillatory:k(Rt(p,w),u,a.length)}}function Bo(s,e,r,t){let n=s.free.length;for(let o of t)s.free.forEach((i,a)=>{s.q[o*s.size+i]+=r[a]-e[o*n+a]})}function ue(s,e,r){let{engine:t,blocks:n,free:o,size:i}=s,a={q:e,v:K(s.rates,i,r),a:K(s.gains,i,r),base:s.weight,wrenches:K(s.wrenches,s.places,r)},l=xt(t,n,a,r.length),u=t.sample("elastic",n.chain,a,r.length).forces;return Float64Array.from({length:r.length*o.length},(f,c)=>{let m=Math.floor(c/o.length)*i+o[c%o.length];return l[m]+u[m]})}function le(s,e,r){let{free:t,size:n}=s,o=t.length,i=new Float64Array((o+1)*n);for(let l=0;l<=o;l+=1)i.set(e,l*n);t.forEach((l,u)=>{i[u*n+l]+=Ar});let a=ue(s,i,new Array(o+1).fill(r));return ke(Float64Array.from({length:o*o},(l,u)=>(a[u%o*o+Math.floor(u/o)]-a[o*o+Math.floor(u/o)])/Ar),o)}function No(s,e,r,t){let n=l=>s.q.subarray(l*s.size,(l+1)*s.size),o=l=>le(s,n(l[l.length>>1]),l[l.length>>1]),i=t??o(r);if(!i)return null;let a=ae(s,r,i,ie);a.length&&(i=o(a)??i),a=ae(s,a,i,ie);for(let l of a){let[u,f]=[ie,[l]];for(;f.length&&u;u-=1){let c=le(s,n(l),l);f=c?ae(s,f,c,3):f}f.length&&To(s,e,l)}return i}function ae(s,e,r,t){let{free:n,size:o,q:i}=s,a=n.length,l=[],u=new Map,f=e;for(let c=0;c<t&&f.length;c+=1){let m=ue(s,K(i,o,f),f);f=f.filter((g,p)=>{let d=$(r,m.subarray(p*a,(p+1)*a),a,a,1),w=d.reduce((b,M)=>Math.max(b,Math.abs(M)),0),h=w>Mr?Mr/w:1;if(!Number.isFinite(w))return l.push(g)&&!1;if(n.forEach((b,M)=>{i[g*o+b]-=h*d[M]}),w<Io)return!1;let y=w>Oo*(u.get(g)??1/0);return u.set(g,w),y?l.push(g)&&!1:!0})}return[...l,...f]}function To(s,e,r){let t=e.slice(r*s.size,(r+1)*s.size),n=le(s,t,r);if(s.q.set(t,r*s.size),!n)return;let o=s.free.length,i=$(n,ue(s,t,[r]),o,o,1);s.free.forEach((a,l)=>{s.q[r*s.size+a]-=i[l]})}var qo=50;async function Er(s,e,r,t,n,o){let i=performance.now(),a=async(c=!1)=>{if(!(!c&&performance.now()-i<qo)){if(await new Promise(m=>setTimeout(m,0)),o.cancelled?.())throw new tt("a newer run began");i=performance.now()}};await a(!0);let{vibration:l,facts:u}=Fr(s,e,r,n,t);await a(!0);let f=await vr(s,e,n.blocks,n.schedule,t.times,t.series,a);return{...t,vibration:l,facts:{...t.facts,...u},series:{...t.series,...f}}}function xr(s,e,r,t){let n={...cr(e,r,t),...mr(r,e.length)},o=s.deformations.flatMap((m,g)=>m.endsWith(".gear")?[g]:[]),i=o.filter(m=>s.turning.includes(s.deformations[m].replace(/\\.gear$/,""))),a=i.length?i:o;if(a.length){let m=B(r.deformation.data,s.deformations.length,a),g=a.length<o.length?" (of the gears that turn)":"",{value:p,note:d}=kr(e,m,a.map(w=>s.deformations[w].replace(/\\.gear$/,"")));n["gear.max"]={value:p,note:`${d}${g}`}}let{drives:l}=s.layout,u=D(0,l.length),f=u.filter(m=>s.turning.includes(l[m]));for(let[m,g]of[["gear_torque",f.length?f:u],["voltage",u]]){if(!r[m])continue;let p=kr(e,B(r[m].data,l.length,g),g.map(d=>l[d]));p.value&&(n[`${m}.max`]=p)}let c=r.contact_force_normal?.data;if(c){let[m,g]=[c.reduce((p,d)=>Math.min(p,d)),c.reduce((p,d)=>Math.max(p,d))];n["contact.mean"]={value:ne(e,c),note:`from ${C(m,4)} to ${C(g,4)} N`}}return n}function kr(s,e,r){let t=pt(e),n=`${r[t%r.length]}, at ${C(s[Math.floor(t/r.length)])} s`;return{value:Math.abs(e[t]),note:n}}function Rr(s,{strengths:e,places:r,kept:t},n){let o=[s.every>1?`one sample in ${s.every}`:"",t>r.data.length?`${r.data.length} places along each link`:""],i=o.some(Boolean)?` (looked at: ${o.filter(Boolean).join(", ")})`:"",a=m=>s.links.flatMap(({largest:g})=>g[m]??[]),l=(m,g)=>{let p=ce(g,({value:w})=>w),d=p&&m!=="deflection.max"?` at s = ${C(p.s,2)}`:"";return p?{[m]:{value:p.value,note:`${p.link}${d}, at ${C(n[p.sample])} s${i}`}}:{}},u=ce(a("stress").filter(({link:m})=>m in e),({link:m,value:g})=>g/e[m]),f=u?e[u.link]:1,c=u&&`of ${V(f,"Pa")}, ${u.link}; margin ${C(100*(1-u.value/f))} %${i}`;return{...l("deflection.max",a("deflection")),...l("moment.max",a("moment")),...l("stress.max",a("stress")),...u&&c?{"stress.share":{value:100*u.value/f,note:c}}:{}}}function jr(s,e){let r=ce(s.flatMap(t=>$o(t,e)),({share:t})=>t);return r?{"limits.share":{value:100*r.share,note:r.note}}:{}}function $o({joint:s,coordinate:e,drive:r,unit:t,effortUnit:n,speed:o,effort:i,range:a},l){let u=(c,m,g=0)=>B(l[c].data,l[c].shape[1],[m]).reduce((p,d)=>Math.max(p,Math.abs(d-g)),0),f=(c,m,g,p)=>({share:c/m,note:`${g} of ${s}: ${V(c,p)} of ${V(m,p)}`});return[...o?[f(u("v",e),o,"speed",`${t}/s`)]:[],...i&&r>=0?[f(u("effort",r),i,"effort",n)]:[],...a?[{share:u("q",e,a[0])/a[1],note:`range of ${s}, from its middle`}]:[]]}function ce(s,e){return s.reduce((r,t)=>r===null||e(t)>e(r)?t:r,null)}var Nt=["y","z"],_o=[{id:"deflection",of:"deflection",label:"Deflection",unit:"m",planes:Nt},{id:"slope",of:"slope",label:"Slope",unit:"rad",planes:Nt},{id:"moment",of:"moment",label:"Moment",unit:"N m",planes:["torsion",...Nt]},{id:"shear_force",of:"shear",label:"Shear force",unit:"N",planes:Nt}];function Lr(s,e,r){if(!e.length)return null;let t=s.stations.data,[n,o]=[e.length,t.length],i=Float64Array.from({length:n*o},(a,l)=>e[Math.floor(l/o)].length*t[l%o]);return{links:e.map(a=>a.name),places:{data:i,shape:[n,o]},quantities:_o.map(({id:a,of:l,label:u,unit:f,planes:c})=>{let m=new Float64Array(r*n*o*c.length);return e.forEach((g,p)=>Or(g[l],m,r,p,n,o*c.length)),{id:a,label:u,unit:f,planes:[...c],values:{data:m,shape:[r,n,o,c.length]}}})}}function Ir(s,e,r){let[t,n]=[s.links.length,s.stations.data.length],o=(l,u,f,c)=>{let m=new Float64Array(r*t*n);return s.links.forEach((g,p)=>{let d=g.bends?e.find(h=>h.name===g.name):void 0,w=d&&c(d);w&&Or(w,m,r,p,t,n)}),{id:l,label:u,unit:f,values:{data:m,shape:[r,t,n]}}};if(!e.length)return[];let a=[o("bending_moment","Bending moment","N m",({moment:l})=>Float64Array.from({length:r*n},(u,f)=>Math.sqrt(l[3*f+1]**2+l[3*f+2]**2))),o("torsion","Torsional moment","N m",({moment:l})=>Float64Array.from({length:r*n},(u,f)=>Math.abs(l[3*f]))),o("deflection","Deflection from the root\'s tangent","m",({deflection:l})=>ct(l,2))];return e.some(l=>l.stress)?[...a,o("stress","Largest stress (von Mises)","Pa",({stress:l})=>l&&l.mises),o("strain","Largest strain","1",({stress:l})=>l&&l.strain)]:a}function Or(s,e,r,t,n,o){for(let i=0;i<r;i+=1)e.set(s.subarray(i*o,(i+1)*o),(i*n+t)*o)}var Po=100;function zo(s,e,r,t,n){let o=new Float64Array(1),i={time:o,row:At(t,o),step:new Float64Array(1)};for(let a=0;`${e}.switched`in s.layout.samples&&a<Po;a+=1){let l=n;if(n=s.sample(`${e}.switched`,r.parameters,{...i,state:n},1).state,n.every((u,f)=>u===l[f]))break}return n}async function Br(s,e,r,t,n,o){let{settings:i}=e,a=e.runs[t],l=D(0,a.signals).map(c=>_t(n[`knots.${c}`],n[`coefficients.${c}`])),u=Fe(l.map(c=>Pt(c,i.duration)));l.length||(u.knots[1]=i.duration);let f=await ge(s,{loop:`${t}.${i.method}`,parameters:n.parameters,knots:u.knots,rows:we(u),state:zo(s,t,n,u,Ie(s,e,r,t,u)),times:L(e.times),settings:i},o);return{name:t,info:a,blocks:n,each:l,schedule:u,run:f}}var Y=24;function Nr(s,e,r,t){let n=r.run.times.subarray(0,t),o=r.run.states.subarray(0,t*(r.run.states.length/r.run.times.length)),i=At(r.schedule,n),a={time:n,state:o,row:i,step:new Float64Array(1)},l=s.sample(`${r.name}.observe`,r.blocks.parameters,a,t),{q:u,v:f,a:c}=l,m=L(e.base),{chain:g,rotors:p}=r.blocks,{points:d}=s.sample("inertia",g,{q:u,v:f,a:c,base:m},t),w=new Float64Array(p.length),h=s.sample("inertia",g,{q:u,v:w,a:f,base:m},t),y=s.sample("elastic",g,{q:u,v:f,base:m},t).energies;return{model:l,points:d,energy:Co(e,f,p,h,y,t)}}function Co(s,e,r,t,n,o){let i=r.length,a=n.length/o,l=new Float64Array(4*o);for(let u=0;u<o;u+=1){for(let f=0;f<i;f+=1){let c=e[u*i+f];l[4*u]+=(t.forces[u*i+f]+r[f]*c)*c/2}for(let f=0;f<3;f+=1)l[4*u+1]-=t.moment[3*u+f]*s.gravity.data[f];for(let f=0;f<a;f+=1)l[4*u+2+f%2]+=n[u*a+f]}return l}function Tr(s,e,{model:r,points:t,energy:n},o){let i=r.q.length/o,a=r.gear.length/o,l=t.length/o/Y,u=e.run.states.length/e.run.times.length,f=B(e.run.states.subarray(0,o*u),u,D(...e.info.state.works)),c=h=>k(B(r.drives,4*a,D(0,a).map(y=>4*y+h)),o,a),m=h=>B(t,l*Y,D(0,l).flatMap(y=>D(0,3).map(b=>y*Y+h+b))),g=B(t,l*Y,D(0,l).flatMap(h=>D(h*Y,h*Y+9))),p={q:k(r.q,o,i),v:k(r.v,o,i),a:k(r.a,o,i),deformation:k(Z(s.deflections,r.q,o),o,s.deformations.length),position:k(m(9),o,l,3),velocity:k(m(12),o,l,3),acceleration:k(m(18),o,l,3),rotation:k(g,o,l,3,3),tip:k(B(t,l*Y,[9,10,11]),o,3),tip_velocity:k(B(t,l*Y,[12,13,14]),o,3),energy:k(n,o,4),work:k(f,o,f.length/o),energy_balance:k(Be(n,f,o,3),o)};a&&Object.assign(p,{wanted:c(3),effort:c(0),gear_torque:k(r.gear,o,a)}),a&&s.electric&&Object.assign(p,{voltage:c(1),current:c(2)});let d=D(...e.info.state.controls);if(d.length){let h=B(e.run.states.subarray(0,o*u),u,d);p.controller_states=k(h,o,d.length)}if(s.contactPoint<0)return p;let w=h=>B(r.contact,6,h);return{...p,contact_force:k(w([0,1,2]),o,3),contact_force_normal:k(w([3]),o),penetration:k(w([4]),o)}}function qr(s,e,{blocks:r},t,n,o){let i=n.model.q.length/o,a=n.points.length/o/Y,[l,u]=[t,n].map(({points:c})=>B(c,a*Y,[9,10,11])),f={q_nominal:k(n.model.q,o,i),v_nominal:k(n.model.v,o,i),deformation_nominal:k(Z(e.deflections,n.model.q,o),o,e.deformations.length),gear_torque_nominal:k(n.model.gear,o,n.model.gear.length/o),tip_nominal:k(u,o,3),deviation:k(ct(Rt(l,u),3),o)};if(e.commanded){let c=Z(e.straight,n.model.q,o),[m,g]=[new Float64Array(i),L(e.base)],{points:p}=s.sample("inertia",r.chain,{q:c,v:m,a:m,base:g},o);f.tip_commanded=k(B(p,a*Y,[9,10,11]),o,3)}return e.contactPoint>=0&&(f.contact_force_normal_nominal=k(B(n.model.contact,6,[3]),o)),f}var $r=32,Wo=1e-6;function _r(s,e){let{wanted:r}=e;return r?s.setpoints.map(t=>B(r.data,r.shape[1],[t])):[]}function Pr(s,e,r){let t=s.length-(Do(s)?1:0),n=s[s.length-1],o=e===null?-1:s.findIndex(l=>l>=e*(1+1e-9));if(o>=0&&t-o>=$r)return[s[o],n];let[i,a]=Go(Uo(t,r));return a-i>=$r?[s[i],s[a-1]]:[s[0],n]}function Do(s){let e=s.length;return e>2&&Math.abs((s[e-1]-s[e-2])/(s[1]-s[0])-1)>1e-6}function Uo(s,e){let r=new Array(Math.max(s,0)).fill(!1);if(s<3||!e.length)return r;let t=new Float64Array(s);for(let o of e)for(let i=1;i<s-1;i+=1)t[i]=Math.max(t[i],Math.abs(o[i+1]-2*o[i]+o[i-1]));let n=Wo*Math.max(Number.MIN_VALUE,t.reduce((o,i)=>Math.max(o,i),0));for(let o=1;o<s-1;o+=1)r[o]=t[o]<=n;return r}function Go(s){let[e,r]=[[0,0],-1];for(let t=0;t<=s.length;t+=1)t<s.length&&s[t]?r=r<0?t:r:r>=0&&(t-r>e[1]-e[0]&&(e=[r,t]),r=-1);return e}async function zr(s,e,r,t,n,o=()=>{}){let i=performance.now(),a=e.runs.reference?["reference","real"]:["real"],l=[];for(let[E,A]of a.entries()){let x={...t,progress:O=>t.progress?.((E+O)/a.length)},R=ut(e.map,r,A),I=()=>Br(s,e,r,A,R,x);l.push(await(A==="reference"?n.of(R,I):I()))}let u=l[l.length-1];o(u);let f=(performance.now()-i)/1e3,c=Math.min(...l.map(E=>E.run.times.length)),[m,g]=[u,...l.slice(0,-1)].map(E=>Nr(s,e,E,c)),p=u.run.times.subarray(0,c),d=g?qr(s,e,l[0],m,g,c):{},w={...Tr(e,u,m,c),...d},h=Re(e,c),y=Ae(u.info.moving.map(E=>u.each[E])),b=l.find(E=>E.run.status!=="finished"),M=Ne(s,e,u.blocks,w,p,u.schedule,h),F={...xr(e,p,w,y),...Rr(M,e.carried,p),...jr(e.carried.limits,w)},v=Ir(e,M.links,h.length);return{status:b?b.run.status:"finished",message:b?`${b===u?"actual robot":"nominal run"}: ${b.run.message}`:u.run.message,seconds:f,times:p,series:w,scene:Te(s,e,u.blocks,w,p,h,v),line:Lr(e,M.links,h.length),span:Pr(p,y,_r(e,w)),facts:b?fr(F):F}}async function Cr(s){let e=await wt.open(s.module.data,s.layout),r=new Ft;return{async run(t,n,o=()=>{}){let i=null,a=await zr(e,s,t,n,r,l=>{i=l});return o(a,[a.times,a.series,i]),Er(e,s,t,a,i,n)}}}var st=self,fe=null,Dr=-1,Wr=Promise.resolve();st.onmessage=({data:s})=>{if(s.kind==="open"){Cr(s.bundle).then(t=>{fe=t,st.postMessage({kind:"ready"})},t=>st.postMessage({kind:"failed",message:String(t)}));return}let{id:e,values:r}=s;Dr=e,Wr=Wr.then(()=>Qo(e,r))};async function Qo(s,e){let r=()=>s!==Dr;try{if(!fe)throw new Error("the live model is not open");if(await new Promise(a=>setTimeout(a,0)),r())throw new tt("a newer run began");let t={cancelled:r,progress:a=>st.postMessage({kind:"progress",id:s,share:a})},n=null,o=await fe.run(e,t,(a,l)=>{n=a;let u=new Set(mt(l));st.postMessage({kind:"early",id:s,run:a},mt(a).filter(f=>!u.has(f)))}),i=de(o,n);st.postMessage({kind:"done",id:s,run:i},mt(i))}catch(t){let n=t instanceof Error?t.message:String(t);st.postMessage({kind:"error",id:s,cancelled:t instanceof tt,message:n})}}})();\n';function w0(i){let{settings:t,status:e}=i,{statuses:n,limits:r}=i.layout,s=`t = ${$e(i.time,6)} s`;if(e===n.finished)return["finished",`completed at t = ${$e(t.duration,6)} s`];if(e===n.running)return["stopped",`stopped at ${s} of ${$e(t.duration,6)} s: integration.max_steps = ${t.maxSteps} is used up`];if(e===n.chattering){let o=`more than ${r.most_events} times within ${r.event_time} s`;return["chattering",`stopped at ${s}: the contact started or ended ${o}; give the surface damping, or a lower stiffness`]}return MM(i,s)}function MM({layout:i,status:t,lastStep:e,rates:n},r){let{statuses:s,coordinates:o,limits:a}=i,l=o.length,c=Array.from(n().subarray(l,2*l),y=>Number.isFinite(y)?Math.abs(y):1/0),u=c.indexOf(Math.max(...c)),f=c[u]<a.bound?t===s.not_converged?"not_converged":t===s.step_too_small?"step_too_small":"diverged":"diverged",d=`its acceleration is ${$e(c[u],3)} rad/s^2`,m=f.replaceAll("_"," ");return[f,`${m} at ${r} in coordinate ${o[u]}: ${d}; its last step was of ${$e(e,3)} s`]}var Li=class extends Error{name="EngineError"};function Pa(i,t,e){if(!Object.hasOwn(i,t))throw new Li(`${e}: got ${t}; expected one of ${Object.keys(i).join(", ")}`);return i[t]}function ts(i,t,e){if(t!==e)throw new Li(`${i}: got ${t} numbers; expected ${e}`)}var SM=["rk4","midpoint"],AM=500,Vf=class{constructor(t,e){this.engine=t;this.spec=e;let n=Pa(t.layout.loops,e.loop,"loop");ts(`${e.loop}: parameters`,e.parameters.length,n.parameters),ts(`${e.loop}: state`,e.state.length,n.size),ts(`${e.loop}: rows`,e.rows.length,(e.knots.length-1)*n.row),this.method=n.method,this.memory=new Float64Array(t.layout.cells.length),this.state=e.state.slice(),this.slope=new Float64Array(n.size),this.states=new Float64Array(e.times.length*n.size),this.states.set(e.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(t){return this.memory[this.engine.layout.cells.indexOf(t)]}put(t){for(let[e,n]of Object.entries(t))this.memory[this.engine.layout.cells.indexOf(e)]=n}advance(t){let{layout:e}=this.engine,{settings:n,knots:r,rows:s,times:o,parameters:a}=this.spec,l=Math.max(1,Math.min(t,n.maxSteps-this.tried)),c={step:n.step,rtol:n.relativeTolerance,atol:n.absoluteTolerance,chunk:l,bound:e.limits.bound,watch:0,most_events:e.limits.most_events,event_time:e.limits.event_time,looks:0},u=this.cell("sample"),h=m=>({into:m,range:()=>[u*this.state.length,this.cell("sample")*this.state.length]}),f=m=>({into:m,given:!0}),d={memory:f(this.memory),y:f(this.state),k1:f(this.slope),p:a,knots:r,rows:s,times:o,out:h(this.states),options:Float64Array.from(e.options,m=>c[m]),seen:new Float64Array(1),segments:r.length-1,samples:o.length};this.engine.call(e.loops[this.spec.loop].export,e.arguments.map(m=>d[m]))}result(){let t=this.cell("sample"),e=this.state.length,[n,r]=w0({layout:this.engine.layout,settings:this.spec.settings,status:this.cell("status"),time:this.time,lastStep:this.cell("h"),rates:()=>this.rates()});return{status:n,message:r,times:this.spec.times.slice(0,t),states:this.states.slice(0,t*e),statistics:this.statistics()}}statistics(){let[t,e,n]=[this.cell("steps"),this.cell("smallest"),this.time],r=t?n/t:null,s={steps:t,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:r,smallest_step_s:e>0?e:r};return SM.includes(this.method)&&(s.step=this.cell("h")),this.cell("passes")&&(s.passes=this.cell("passes")),this.cell("events")&&(s.contact_changes=this.cell("events")),s}rates(){let{loop:t,parameters:e,rows:n}=this.spec,{row:r}=this.engine.layout.loops[t],s=Math.min(this.cell("segment"),n.length/r-1),o={time:Float64Array.of(this.time),state:this.state,row:n.slice(s*r,(s+1)*r),step:new Float64Array(1)};return this.engine.sample(`${t.slice(0,t.lastIndexOf("."))}.rate`,e,o,1).rate}},Is=class extends Li{name="Cancelled"};async function M0(i,t,e={}){let n=new Vf(i,t),r=1e3*(e.piece??.05),s=AM,o=performance.now();for(;n.running;){let a=performance.now();n.advance(s);let l=performance.now();if(s=Math.max(1,Math.floor(s*Math.min(4,r/Math.max(l-a,.001)))),!(l-o<r)){if(e.progress?.(n.time/t.settings.duration),await new Promise(c=>setTimeout(c,0)),e.cancelled?.())throw new Is(`the run was given up at t = ${$e(n.time,6)} s`);o=performance.now()}}return n.result()}function S0(i,t){return{...i,...t,series:{...i?.series,...t.series}}}var A0=1,EM=65536,TM={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},oc=class i{constructor(t,e,n,r){this.layout=t;this.functions=e;this.memory=n;this.free=r}layout;functions;memory;free;outputs=new Float64Array;static async open(t,e){if(e.format!==A0)throw new Li(`layout: got format ${e.format}; expected ${A0}`);let{instance:n}=await RM(t,e),{memory:r,heap_base:s,...o}=n.exports,a=s.value;return new i(e,o,r,a)}sample(t,e,n,r){let s=Pa(this.layout.samples,t,"function");ts(`${t}: parameters`,e.length,s.parameters);let o=this.schedule(s,e,[n],r);return Gf(s.outputs,o,r,1)}slopes(t,e,n,r,s){let o=Pa(this.layout.samples,t,"function");if(o.kind!=="slopes")throw new Li(`${t}: got a function without derivatives; expected one with them`);ts(`${t}: parameters`,e.length,o.parameters);let a=Object.fromEntries(Object.entries(o.inputs).map(([u,h])=>[u,new Float64Array(h)])),l=this.schedule(o,e,[n,{...a,...r}],s),c=ac(o.outputs);return{values:Gf(o.outputs,l,s,2),slopes:Gf(o.outputs,l.subarray(c),s,2)}}call(t,e){let n=e.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(n.reduce((a,l)=>a+(l?.byteLength??0),this.free));let r=new Float64Array(this.memory.buffer),s=this.free,o=e.map((a,l)=>{if(typeof a=="number")return BigInt(a);let c=s;return(a instanceof Float64Array||a.given)&&r.set(n[l],c/8),s+=n[l].byteLength,c});this.functions[t](...o),e.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[c,u]=a.range?.()??[0,a.into.length],h=o[l]/8;a.into.set(r.subarray(h+c,h+u),c)})}schedule(t,e,n,r){let s=PM(t.inputs,n,r),o=this.room(r*n.length*ac(t.outputs)),a=new Float64Array(t.workspace);return this.call(t.export,[r,0,e,a,s,{into:o}]),o}room(t){return this.outputs.length<t&&(this.outputs=new Float64Array(t)),this.outputs.subarray(0,t)}reserve(t){let e=t-this.memory.buffer.byteLength;if(!(e<=0))try{this.memory.grow(Math.ceil(e/EM))}catch{throw new Li(`memory: got no room for ${(t/1e6).toFixed(0)} MB; expected a browser that has it. Hint: ask for fewer samples`)}}};async function RM(i,t){try{return await WebAssembly.instantiate(i,{env:TM})}catch(e){let n=t.simd?", with vectors (SIMD)":"";throw new Li(`WebAssembly: got ${String(e)}; expected a browser that allows it${n}`)}}function ac(i){return Object.values(i).reduce((t,e)=>t+e,0)}function CM(i,t,e,n){if(e===void 0)throw new Li(`${i}: got nothing; expected ${t} numbers for each sample`);if(e.length===n*t)return e;ts(i,e.length,t);let r=new Float64Array(n*t);return Hf(e,0,0,r,t,0,t,n),r}function PM(i,t,e){let n=ac(i),r=new Float64Array(e*t.length*n);return t.forEach((s,o)=>{let a=o*n;for(let[l,c]of Object.entries(i)){let u=CM(l,c,s[l],e);Hf(u,c,0,r,t.length*n,a,c,e),a+=c}}),r}function Gf(i,t,e,n){let r=n*ac(i),s={},o=0;for(let[a,l]of Object.entries(i)){let c=new Float64Array(e*l);Hf(t,r,o,c,l,0,l,e),s[a]=c,o+=l}return s}function Hf(i,t,e,n,r,s,o,a){for(let l=0;l<a;l++){let c=l*t+e,u=l*r+s;for(let h=0;h<o;h++)n[u+h]=i[c+h]}}var lc=class{last=null;async of(t,e){if(this.last&&IM(this.last.blocks,t))return this.last.made;this.last=null;let n=await e();return this.last={blocks:t,made:n},n}};function IM(i,t){return Object.entries(i).every(([e,n])=>n.length===t[e].length&&n.every((r,s)=>r===t[e][s]))}function Wf(i,t){return{knots:i,coefficients:t,signals:1,degree:t.length/(i.length-1)-1}}function qf(i,t){let e=i.degree+1,n=i.knots.length-1,r=0;for(;r<n&&i.knots[r]<t;)r+=1;let s=i.knots[n],o=[...i.knots.subarray(0,r)],a=[...i.coefficients.subarray(0,r*e)];return t>s&&(o.push(s),a.push(Xf(i,n-1,0,s),...new Array(i.degree).fill(0))),Wf(Float64Array.from([...o,t]),Float64Array.from(a))}function Xf(i,t,e,n){let r=i.degree+1,s=(t*i.signals+e)*r,o=n-i.knots[t],a=0;for(let l=i.degree;l>=0;l-=1)a=a*o+i.coefficients[s+l];return a}function $f(i,t){let[e,n]=[0,i.length-1];for(;n-e>1;){let r=e+n>>1;i[r]<=t?e=r:n=r}return e}function So(i,t,e){return Xf(i,$f(i.knots,e),t,e)}function E0(i){return T0(i,Array.from({length:i.knots.length-1},(t,e)=>e))}function cc(i,t){return T0(i,Array.from(t,e=>$f(i.knots,e)))}function T0(i,t){let e=i.signals*(i.degree+1),n=new Float64Array(t.length*(e+1));return t.forEach((r,s)=>{n[s*(e+1)]=i.knots[r],n.set(i.coefficients.subarray(r*e,(r+1)*e),s*(e+1)+1)}),n}function R0(i){if(!i.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let t=Math.max(...i.map(o=>o.knots[o.knots.length-1])),e=i.map(o=>o.knots[o.knots.length-1]<t?qf(o,t):o),n=LM(e.flatMap(o=>[...o.knots])),r=Math.max(...e.map(o=>o.degree)),s=new Float64Array((n.length-1)*i.length*(r+1));return e.forEach((o,a)=>{for(let l=0;l<n.length-1;l+=1){let c=(l*i.length+a)*(r+1);FM(o,n,l,s.subarray(c,c+r+1))}}),{knots:n,coefficients:s,signals:i.length,degree:r}}function LM(i){let t=[...new Set(i)].sort((r,s)=>r-s),e=t[t.length-1]-t[0],n=t.filter((r,s)=>s===0||r-t[s-1]>1e-12*e);return n[n.length-1]=t[t.length-1],Float64Array.from(n)}function FM(i,t,e,n){let r=$f(i.knots,(t[e]+t[e+1])/2),s=t[e]-i.knots[r],o=Math.abs(s)<=1e-12*(t[t.length-1]-t[0])?0:s;for(let a=0;a<=i.degree;a+=1){let l=i.coefficients[r*(i.degree+1)+a],c=1;for(let u=a;u>=0;u-=1)n[u]+=c*l*Math.pow(o,a-u),c=c*u/(a-u+1)}}var NM=1e-9,DM=1e-6;function C0(i){let t=i.map(OM);return t.includes(null)?null:Math.max(0,...t)}function OM(i){let{knots:t,coefficients:e,degree:n}=i,r=t.length-1,s=n+1,o=l=>e[l*s],a=Array.from({length:r},(l,c)=>Math.abs(o(c))).reduce((l,c)=>Math.max(l,c),1e-12);for(let l=r-1;l>=0;l-=1){let c=t[l+1]-t[l];for(let u=1;u<s;u+=1)if(!(Math.abs(e[l*s+u])*c**u<=NM*a))return l===r-1?null:t[l+1];if(l&&Math.abs(o(l)-Xf(i,l-1,0,t[l]))>DM*a)return t[l]}return 0}var _i=6;function Yf({follower:i,signal:t},e,n,r,s,o){let a=t<0?1:So(n,t,r);return(i?UM(s,o,e):e).map(l=>a*l)}function UM(i,t,e){return e.map((n,r)=>{let[s,o]=[t+3*(r%3),r<3?0:3];return i[s]*e[o]+i[s+1]*e[o+1]+i[s+2]*e[o+2]})}function uc(i,t,e,n,r){let s=r.position.shape[1],o=new Float64Array(n.length*s*_i);return n.forEach((a,l)=>{if(i.loads.forEach((c,u)=>{let h=l*s+c.point,f=t.loads.subarray(_i*u,_i*(u+1)),d=Yf(c,f,e,a,r.rotation.data,9*h);for(let m=0;m<_i;m+=1)o[_i*h+m]+=d[m]}),!(i.contactPoint<0))for(let c=0;c<3;c+=1)o[_i*(l*s+i.contactPoint)+c]-=r.contact_force.data[3*l+c]}),o}function hc(i,t){let e=t.length;for(let n=0;n<e;n+=1){let r=n;for(let o=n+1;o<e;o+=1)Math.abs(i[o*e+n])>Math.abs(i[r*e+n])&&(r=o);let s=Math.abs(i[r*e+n]);if(!(s>0)||s===1/0)return!1;r!==n&&kM(i,t,n,r);for(let o=n+1;o<e;o+=1){let a=i[o*e+n]/i[n*e+n];if(a!==0){for(let l=n+1;l<e;l+=1)i[o*e+l]-=a*i[n*e+l];t[o]-=a*t[n]}}}for(let n=e-1;n>=0;n-=1){for(let r=n+1;r<e;r+=1)t[n]-=i[n*e+r]*t[r];t[n]/=i[n*e+n]}return!0}function kM(i,t,e,n){let r=t.length;for(let o=0;o<r;o+=1){let a=i[e*r+o];i[e*r+o]=i[n*r+o],i[n*r+o]=a}let s=t[e];t[e]=t[n],t[n]=s}function fc(i,t){let e=new Float64Array(t*t);for(let n=0;n<t;n+=1)for(let r=n;r<t;r+=1){let s=i[r*t+n];for(let o=0;o<n;o+=1)s-=e[r*t+o]*e[n*t+o];if(r===n&&!(s>0))return null;e[r*t+n]=r===n?Math.sqrt(s):s/e[n*t+n]}return e}function I0(i,t,e,n){for(let r=0;r<e;r+=1){for(let s=0;s<r;s+=1)F0(t,r,s,i[r*e+s],n);for(let s=0;s<n;s+=1)t[r*n+s]/=i[r*e+r]}}function jf(i,t,e,n){for(let r=e-1;r>=0;r-=1){for(let s=r+1;s<e;s+=1)F0(t,r,s,i[s*e+r],n);for(let s=0;s<n;s+=1)t[r*n+s]/=i[r*e+r]}}function F0(i,t,e,n,r){for(let s=0;s<r;s+=1)i[t*r+s]-=n*i[e*r+s]}function dc(i,t,e){let n=t.slice();I0(i,n,e,e);let r=L0(n,e);return I0(i,r,e,e),L0(r,e)}function L0(i,t){return i.map((e,n)=>i[n%t*t+Math.floor(n/t)])}function ri(i,t,e,n,r,s=!1){let o=new Float64Array(e*r);for(let a=0;a<e;a+=1)for(let l=0;l<n;l+=1){let c=s?i[l*e+a]:i[a*n+l];if(c)for(let u=0;u<r;u+=1)o[a*r+u]+=c*t[l*r+u]}return o}function N0(i,t){let e=Float64Array.from({length:t*t},(n,r)=>r%(t+1)?0:1);for(let n=0;n<t;n+=1){let r=n;for(let a=n+1;a<t;a+=1)Math.abs(i[a*t+n])>Math.abs(i[r*t+n])&&(r=a);let s=Math.abs(i[r*t+n]);if(!(s>0)||s===1/0)return null;for(let a of[i,e])if(r!==n){let l=a.slice(n*t,(n+1)*t);a.copyWithin(n*t,r*t,(r+1)*t),a.set(l,r*t)}let o=i[n*t+n];for(let a=0;a<t;a+=1)i[n*t+a]/=o,e[n*t+a]/=o;for(let a=0;a<t;a+=1){let l=i[a*t+n];if(!(a===n||l===0)){for(let c=n;c<t;c+=1)i[a*t+c]-=l*i[n*t+c];for(let c=0;c<t;c+=1)e[a*t+c]-=l*e[n*t+c]}}}return e}var pc=24;function D0(i,t,e,n,r,s,o=0){let a=n.length/pc,l={wrenches:new Float64Array(_i*a),mass:new Float64Array(s*s),damping:new Float64Array(s*s),stiffness:new Float64Array(s*s)},c=(u,h)=>Float64Array.from({length:3*s},(f,d)=>r[(d%s*a+u)*pc+h+Math.floor(d/s)]);return i.loads.forEach((u,h)=>{let{point:f,follower:d}=u,m=t.loads.subarray(_i*h,_i*(h+1)),y=Yf(u,m,e,o,n,pc*f);if(Ao(l.wrenches.subarray(_i*f,_i*(f+1)),y,1),!d)return;let g=c(f,21);for(let[p,x]of[[c(f,18),0],[g,3]])Ao(l.stiffness,ri(p,ri(BM(y.subarray(x,x+3)),g,3,3,s),s,3,s,!0),1)}),i.touch&&VM(zM(i.touch,t.surface),t.touch,n,c(i.touch.point,18),l,s),l}function Ao(i,t,e){for(let n=0;n<t.length;n+=1)i[n]+=e*t[n]}function BM([i,t,e]){return Float64Array.of(0,-e,t,e,0,-i,-t,i,0)}function zM(i,t){let[e,n,r,s]=t;if(i.radius)return{...i,axis:[e,n,r],radius:s};let[o,a,l]=i.axis;return{...i,distance:-(o*e+a*n+l*r)}}function VM(i,t,e,n,r,s){let[o,a,l,c]=t,u=pc*i.point+9,{gap:h,normal:f,curvature:d}=GM(i,e.subarray(u,u+3)),m=c-l*h;if(!i.bilateral&&!(h<=0&&m>0))return;for(let p=0;p<3;p+=1)r.wrenches[_i*i.point+p]+=m*f[p];let y=ri(f,n,1,3,s),g=ri(y,y,s,1,s);Ao(r.mass,g,o),Ao(r.damping,g,a),Ao(r.stiffness,g,l),Ao(r.stiffness,ri(n,ri(d,n,3,3,s),s,3,s,!0),-m)}function GM(i,t){let e=l=>l[0]*t[0]+l[1]*t[1]+l[2]*t[2];if(!i.radius)return{gap:e(i.axis)+i.distance,normal:Float64Array.from(i.axis),curvature:new Float64Array(9)};let n=t.map((l,c)=>l-i.axis[c]),r=Math.hypot(...n)||1e-300,s=i.inside?-1:1,o=n.map(l=>l/r),a=Float64Array.from({length:9},(l,c)=>s*((c%4?0:1)-o[Math.floor(c/3)]*o[c%3])/r);return{gap:s*(r-i.radius),normal:o.map(l=>s*l),curvature:a}}function O0(i,t){let e=Array.from(i.frames.data).filter(n=>n<t);return e[e.length-1]!==t-1&&e.push(t-1),e}function sn(i){return i.data instanceof Float64Array?i.data:Float64Array.from(i.data)}function HM(i,t,e){let n=i.knobs.map(s=>s.start),r=i.knobs.map(s=>s.factor);return i.sliders.forEach((s,o)=>{s.real?r[s.knob]=t[o]:n[s.knob]=t[o]}),e==="reference"?n:i.knobs.map((s,o)=>{let a=r[o];return a===null||s.factor===null?n[o]:s.together?s.factor?n[o]*(a/s.factor):n[o]:n[o]*a})}function Eo(i,t,e){let n=i.runs[e],r=WM(n,HM(i,t,e)),s={};for(let[o,a]of Object.entries(n.places)){let l=a.shape.reduce((c,u)=>c*u,1);s[o]=r.slice(a.start,a.start+l)}return s}function WM(i,t){let e=sn(i.base).slice(),n=i.powers.map(l=>U0(l,(c,u)=>Math.pow(t[c]/i.variables[c].start,u))),r=i.powers.map(l=>U0(l,(c,u)=>qM(i.variables[c],u,t[c]))),{products:s,terms:o,coefficients:a}=i;for(let l=0;l<s.data.length;l+=2)e[s.data[l]]*=n[s.data[l+1]];for(let l=0;l<o.data.length;l+=2)e[o.data[l]]+=a.data[l/2]*r[o.data[l+1]];return e}function U0(i,t){return i.reduce((e,[n,r])=>e*t(n,r),1)}function qM(i,t,e){let n=Math.pow(i.start,t);return(Math.pow(e,t)-n)/(Math.pow(i.far,t)-n)}var XM=40,$M=1e-12,YM=.5,k0=1e-6,jM=.5,ZM=.001,JM=1/128;function KM(i,t,e,n,r,s){let[o,a,l]=[n.length+1,e.length,t.rotors.length],c=new Float64Array(o*a);for(let f=0;f<o;f+=1)c.set(e,f*a),f&&(c[f*a+n[f-1]]+=k0);let u={time:new Float64Array(1),state:c,row:t.rest_row,step:new Float64Array(1)},{rate:h}=i.sample("rest.rate",t.rest,u,o);for(let f=0;f<n.length;f+=1){s[f]=h[l+n[f]];for(let d=0;d<n.length;d+=1)r[f*n.length+d]=(h[(d+1)*a+l+n[f]]-s[f])/k0}}function QM(i,t,e,n){let r=i.layout.held,s=n.length,o=Array.from({length:s},(d,m)=>m).filter(d=>!r.includes(d)),a=new Float64Array(t.restSize);a.set(n);let l=new Float64Array(o.length**2),c=new Float64Array(o.length),u=1/0,[h,f]=[0,0];for(let d=0;d<XM&&o.length;d+=1){if(KM(i,e,a,o,l,c),!hc(l,c))return null;let m=Zf(a,o,c);if(!Number.isFinite(m)||(d===0?h=m:f+=m,h>ZM&&f>jM*h))return null;if(Jf(m,u))return a.slice(0,s);u=m}return o.length?null:a.slice(0,s)}function Zf(i,t,e){let n=e.reduce((s,o)=>Math.max(s,Math.abs(o)),0),r=Math.min(1,YM/n);for(let s=0;s<t.length;s+=1)i[t[s]]-=r*e[s];return n}function Jf(i,t){return i<$M||i<1e-9&&i>=t/2}function Kf(i,t,e,n,r){let s=i.sliders.map(u=>u.value),o=u=>u===1?t:t.map((h,f)=>s[f]+(h-s[f])*u),[a,l,c]=[0,1,n];for(;a<1;){let u=Math.min(1,a+l),h=r(o(u),c);if(h)[a,l,c]=[u,2*l,h];else if(l>JM)l/=2;else throw new Error(`${e}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`)}return c}function B0(i,t,e,n,r){let s=t.runs[n],o=sn(s.start).slice(),[a,l]=[s.state.q[0],s.state.v[0]];if(t.atRest){let c=(h,f)=>QM(i,t,Eo(t.map,h,n),f),u=Kf(t,e,n,o.slice(...s.state.q),c);for(let h=0;h<u.length;h+=1)s.info.includes(h)||(o[a+h]=u[h])}for(let[c,u]of s.exact){o[a+c]=So(r,u,0);let h=r.degree;o[l+c]=h?r.coefficients[u*(h+1)+1]:0}return o}var tS=40,Ia=.001;function mc(i,t,e,n){let{samples:r}=i.layout;return i.sample("loaded"in r?"loaded":"inertia",t.chain,e,n).forces}function eS(i,t,e,n,r,s=0){let o=r.length,a=new Float64Array(o),l=Float64Array.from({length:o*o},(A,S)=>S%(o+1)?0:1),c=sn(t.base),u=i.sample("inertia",e.chain,{q:r,v:a,a:l,base:c},o),{points:h}=i.sample("inertia",e.chain,{q:r,v:a,a,base:c},1),f=D0(t,e,n,h,u.points,o,s),d=f.mass;for(let A=0;A<o;A+=1){for(let S=0;S<o;S+=1)d[A*o+S]+=(u.forces[A*o+S]+u.forces[S*o+A])/2;d[A*o+A]+=e.rotors[A]}let m=e.chain.slice();for(let A of t.modes.dry)m[A]=0;let y=i.slopes("elastic.slopes",m,{q:r,v:a,base:c},{q:l},o),g=i.slopes("elastic.slopes",m,{q:r,v:a,base:c},{v:l},o).slopes.forces,p=nS(i,t,e,r,f.wrenches),x=A=>A.map((S,_)=>A[_%o*o+Math.floor(_/o)]),b=x(y.slopes.forces),v=mc(i,e,{q:r,v:a,a,base:sn(t.modes.weight),wrenches:f.wrenches},1);return{mass:d,elastic:b,residual:v.map((A,S)=>A+y.values.forces[S]),damping:x(g).map((A,S)=>A+f.damping[S]),stiffness:b.map((A,S)=>A+p[S]+f.stiffness[S])}}function z0(i,t,e,n,r,s=0){let{free:o}=t.modes,[a,l,c]=[r.slice(),r.length,o.length],[u,h]=[1/0,!c];for(let f=0;f<tS;f+=1){let d=eS(i,t,e,n,a,s);if(h)return{rest:a,linear:d};let m=Float64Array.from({length:c*c},(p,x)=>d.stiffness[o[Math.floor(x/c)]*l+o[x%c]]),y=Float64Array.from(o,p=>d.residual[p]);if(!hc(m,y))return null;let g=Zf(a,o,y);if(!Number.isFinite(g))return null;h=Jf(g,u),u=g}return null}function nS(i,t,e,n,r){let s=n.length,o=[Ia,-Ia,2*Ia,-2*Ia],a=new Float64Array(o.length*s*s);o.forEach((h,f)=>{for(let d=0;d<s;d+=1)a.set(n,(f*s+d)*s),a[(f*s+d)*s+d]+=h});let l=new Float64Array(s),c=mc(i,e,{q:a,v:l,a:l,base:sn(t.modes.weight),wrenches:r},o.length*s),u=(h,f,d)=>c[(h*s+d)*s+f];return Float64Array.from({length:s*s},(h,f)=>{let[d,m]=[Math.floor(f/s),f%s];return(8*(u(0,d,m)-u(1,d,m))-(u(2,d,m)-u(3,d,m)))/(12*Ia)})}function An(i,t,e){let n=i.length/t,r=new Float64Array(n*e.length);for(let s=0;s<n;s+=1)for(let o=0;o<e.length;o+=1)r[s*e.length+o]=i[s*t+e[o]];return r}function Fi(i,t){return Array.from({length:t-i},(e,n)=>i+n)}function $i(i,t,e){let n=new Float64Array(e.length*t);for(let r=0;r<e.length;r+=1)for(let s=0;s<t;s+=1)n[r*t+s]=i[e[r]*t+s];return n}function gc(i,t){return i.map((e,n)=>e-t[n])}function To(i,t){let e=new Float64Array(i.length/t);for(let n=0;n<e.length;n+=1){let r=0;for(let s=0;s<t;s+=1)r+=i[n*t+s]**2;e[n]=Math.sqrt(r)}return e}function V0(i,t,e,n){let r=i.length/e,s=t.length/e,o=new Float64Array(e),a=0;for(let l=0;l<e;l+=1){let c=0;for(let u=0;u<r;u+=1)c+=i[l*r+u];l===0&&(a=c),o[l]=c-a;for(let u=0;u<s;u+=1)o[l]+=(u<n?-1:1)*t[l*s+u]}return o}function La(i){let t=0;for(let e=1;e<i.length;e+=1)Math.abs(i[e])>Math.abs(i[t])&&(t=e);return t}function Ae(i,t,...e){return{data:i,shape:[t,...e]}}var iS=4e5,rS=5e5;function G0(i,t,e,n,r,s,o){let{places:a,lines:l,shown:c}=t.carried,u=a.data.length,h=l.map((x,b)=>sS(x,e.lengths[b],o.length*c.data.length)),f=Math.max(1,Math.ceil(r.length*l.length*u/iS));if(!l.length)return{links:h,every:f};let d=new Map(o.map((x,b)=>[x,b])),m=Array.from(r.keys()).filter(x=>x%f===0||d.has(x)),y={q:n.q.data,v:n.v.data,a:n.a.data};"wrenches"in i.layout.samples.line.inputs&&(y.wrenches=uc(t,e,s,r,n));let g=Object.entries(y).map(([x,b])=>[x,$i(b,b.length/r.length,m)]),p={...Object.fromEntries(g),base:sn(t.split.weight)};return td(i,e,p,m.length,(x,b,v)=>{let A=d.get(m[v]);l.forEach((S,_)=>{let w=ed(x[S.name],b,t,S);oS(h[_],S,w,a.data,m[v]),A!==void 0&&aS(h[_],S,w,A,c.data)})}),{links:h,every:f}}function td(i,t,e,n,r){let{inputs:s,outputs:o}=i.layout.samples.line,a=Math.max(1,Math.floor(rS/Object.values(o).reduce((l,c)=>l+c,1)));for(let l=0;l<n;l+=a){let c=Math.min(a,n-l),u={};for(let[f,d]of Object.entries(s)){let m=e[f]??new Float64Array(d);u[f]=m.length===d?m:m.subarray(l*d,(l+c)*d)}let h=i.sample("line",t.line,u,c);for(let f=0;f<c;f+=1)r(h,f,l+f)}}function ed(i,t,e,n){let r=n?e.carried.places.data.length*n.width:15;return i.subarray(t*r,(t+1)*r)}function sS({name:i,at:t},e,n){let r=s=>new Float64Array(s*n);return{name:i,length:e,deflection:r(2),slope:r(2),moment:r(3),shear:r(2),axial:r(1),stress:t.mises_stress?{strain:r(1),mises:r(1)}:null,largest:{deflection:null,moment:null,stress:null}}}function oS(i,{width:t,at:e},n,r,s){let o=r.length-1,a=o*t+e.deflection[0];Qf(i,"deflection",Math.sqrt(n[a]**2+n[a+1]**2),r[o],s);for(let l=0;l<=o;l+=1){let c=l*t+e.moment[0];Qf(i,"moment",Math.sqrt(n[c+1]**2+n[c+2]**2),r[l],s),i.stress&&Qf(i,"stress",n[l*t+e.mises_stress[0]],r[l],s)}}function Qf({name:i,largest:t},e,n,r,s){let o=t[e];(!o||n>o.value)&&(t[e]={link:i,value:n,s:r,sample:s})}function aS(i,{width:t,at:e},n,r,s){let o=(a,l)=>{let[c,u]=e[a],h=u-c;for(let f=0;f<s.length;f+=1)for(let d=0;d<h;d+=1)l[(r*s.length+f)*h+d]=n[s[f]*t+c+d]};for(let a of["deflection","slope","moment","shear","axial"])o(a,i[a]);i.stress&&(o("strain",i.stress.strain),o("mises_stress",i.stress.mises))}function Fr(i,t,e){let[n,r]=i.matrix.shape,s=new Float64Array(e*n);for(let o=0;o<e;o+=1)for(let a=0;a<n;a+=1){let l=i.constant.data[a];for(let c=0;c<r;c+=1)l+=i.matrix.data[a*r+c]*t[o*r+c];s[o*n+a]=l}return s}function H0(i,t,e,n,r,s,o){let a=p=>$i(n[p].data,n[p].shape.slice(1).reduce((x,b)=>x*b,1),s),l=s.length,c=yc(i,t,e,a("q"),l),u=p=>yc(i,t,e,p,l).line,h=p=>u(Fr(t.straight,p,l)),f=h(a("q")),d=p=>({data:a(p),shape:[l,...n[p].shape.slice(1)]}),m="q_nominal"in n,y=c.line.shape.slice(0,3),g=c.line.data.map((p,x)=>p-f.data[x]);return{times:{data:$i(r,1,s),shape:[l]},line:c.line,rigid:f,roots:c.roots,reference:m?u(a("q_nominal")):null,referenceRigid:m?h(a("q_nominal")):null,colours:[...o,{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:To(g,3),shape:y}}],tip:d("tip"),tipReference:m?d("tip_nominal"):null,contact:t.contactPoint<0?null:{force:d("contact_force"),at:cS(t,n,s),surface:lS(t,e.surface)}}}function lS({surface:i},t){let e=[t[0],t[1],t[2]];return i?.kind==="plane"?{...i,position:e}:i?{...i,center:e,radius:t[3]}:void 0}function cS(i,t,e){let n=t.position.shape[1],r=$i(t.position.data,3*n,e),s=new Float64Array(3*e.length);for(let o=0;o<e.length;o+=1)for(let a=0;a<3;a+=1)s[3*o+a]=r[3*(o*n+i.contactPoint)+a];return{data:s,shape:[e.length,3]}}function yc(i,t,e,n,r){let[s,o]=[t.links.length,t.stations.data.length],a=new Float64Array(n.length/r),l=new Float64Array(r*s*o*3),c=new Float64Array(r*s*4),u=t.links.map(({name:h})=>t.carried.lines.find(f=>f.name===h)??null);return td(i,e,{q:n,v:a,a,base:sn(t.base)},r,(h,f,d)=>{t.links.forEach(({name:m},y)=>{let g=u[y],p=(d*s+y)*4,x=ed(h[m],f,t,g);c.set(hS(g?x.subarray(g.at.rotation[0]):x),p),d&&uS(c,p,4*s);for(let b=0;b<o;b+=1){let v=((d*s+y)*o+b)*3;for(let A=0;A<3;A+=1)l[v+A]=g?x[t.carried.shown.data[b]*g.width+g.at.position[0]+A]:x[9+A]+t.stations.data[b]*(x[12+A]-x[9+A])}})}),{line:{data:l,shape:[r,s,o,3]},roots:{data:c,shape:[r,s,4]}}}function uS(i,t,e){let n=0;for(let r=t;r<t+4;r+=1)n+=i[r]*i[r-e];if(n<0)for(let r=t;r<t+4;r+=1)i[r]*=-1}function hS(i){let t=i[0]+i[4]+i[8];if(t>0){let n=2*Math.sqrt(1+t);return[(i[7]-i[5])/n,(i[2]-i[6])/n,(i[3]-i[1])/n,n/4]}if(i[0]>i[4]&&i[0]>i[8]){let n=2*Math.sqrt(1+i[0]-i[4]-i[8]);return[n/4,(i[1]+i[3])/n,(i[2]+i[6])/n,(i[7]-i[5])/n]}if(i[4]>i[8]){let n=2*Math.sqrt(1+i[4]-i[0]-i[8]);return[(i[1]+i[3])/n,n/4,(i[5]+i[7])/n,(i[2]-i[6])/n]}let e=2*Math.sqrt(1+i[8]-i[0]-i[4]);return[(i[2]+i[6])/e,(i[5]+i[7])/e,e/4,(i[3]-i[1])/e]}var fS=Object.prototype.toString;function Nn(i){let t=fS.call(i);return t.endsWith("Array]")&&!t.includes("Big")}function nd(i,t={}){if(!Nn(i))throw new TypeError("input must be an array");if(i.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=i.length}=t;if(e<0||e>=i.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>i.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let r=i[e];for(let s=e+1;s<n;s++)i[s]>r&&(r=i[s]);return r}function id(i,t={}){if(!Nn(i))throw new TypeError("input must be an array");if(i.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=i.length}=t;if(e<0||e>=i.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>i.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let r=i[e];for(let s=e+1;s<n;s++)i[s]<r&&(r=i[s]);return r}function xc(i,t={}){if(Nn(i)){if(i.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let e;if(t.output!==void 0){if(!Nn(t.output))throw new TypeError("output option must be an array if specified");e=t.output}else e=new Array(i.length);let n=id(i),r=nd(i);if(n===r)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:s=t.autoMinMax?n:0,max:o=t.autoMinMax?r:1}=t;if(s>=o)throw new RangeError("min option must be smaller than max option");let a=(o-s)/(r-n);for(let l=0;l<i.length;l++)e[l]=(i[l]-n)*a+s;return e}var _c=" ".repeat(2),q0=" ".repeat(4);function X0(){return rd(this)}function rd(i,t={}){let{maxRows:e=15,maxColumns:n=10,maxNumSize:r=8,padMinus:s="auto"}=t;return`${i.constructor.name} {
${_c}[
${q0}${dS(i,e,n,r,s)}
${_c}]
${_c}rows: ${i.rows}
${_c}columns: ${i.columns}
}`}function dS(i,t,e,n,r){let{rows:s,columns:o}=i,a=Math.min(s,t),l=Math.min(o,e),c=[];if(r==="auto"){r=!1;t:for(let u=0;u<a;u++)for(let h=0;h<l;h++)if(i.get(u,h)<0){r=!0;break t}}for(let u=0;u<a;u++){let h=[];for(let f=0;f<l;f++)h.push(pS(i.get(u,f),n,r));c.push(`${h.join(" ")}`)}return l!==o&&(c[c.length-1]+=` ... ${o-e} more columns`),a!==s&&c.push(`... ${s-t} more rows`),c.join(`
${q0}`)}function pS(i,t,e){return(i>=0&&e?` ${W0(i,t-1)}`:W0(i,t)).padEnd(t)}function W0(i,t){let e=i.toString();if(e.length<=t)return e;let n=i.toFixed(t);if(n.length>t&&(n=i.toFixed(Math.max(0,t-(n.length-t)))),n.length<=t&&!n.startsWith("0.000")&&!n.startsWith("-0.000"))return n;let r=i.toExponential(t);return r.length>t&&(r=i.toExponential(Math.max(0,t-(r.length-t)))),r.slice(0)}function $0(i,t){i.prototype.add=function(n){return typeof n=="number"?this.addS(n):this.addM(n)},i.prototype.addS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)+n);return this},i.prototype.addM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)+n.get(r,s));return this},i.add=function(n,r){return new t(n).add(r)},i.prototype.sub=function(n){return typeof n=="number"?this.subS(n):this.subM(n)},i.prototype.subS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)-n);return this},i.prototype.subM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)-n.get(r,s));return this},i.sub=function(n,r){return new t(n).sub(r)},i.prototype.subtract=i.prototype.sub,i.prototype.subtractS=i.prototype.subS,i.prototype.subtractM=i.prototype.subM,i.subtract=i.sub,i.prototype.mul=function(n){return typeof n=="number"?this.mulS(n):this.mulM(n)},i.prototype.mulS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)*n);return this},i.prototype.mulM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)*n.get(r,s));return this},i.mul=function(n,r){return new t(n).mul(r)},i.prototype.multiply=i.prototype.mul,i.prototype.multiplyS=i.prototype.mulS,i.prototype.multiplyM=i.prototype.mulM,i.multiply=i.mul,i.prototype.div=function(n){return typeof n=="number"?this.divS(n):this.divM(n)},i.prototype.divS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)/n);return this},i.prototype.divM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)/n.get(r,s));return this},i.div=function(n,r){return new t(n).div(r)},i.prototype.divide=i.prototype.div,i.prototype.divideS=i.prototype.divS,i.prototype.divideM=i.prototype.divM,i.divide=i.div,i.prototype.mod=function(n){return typeof n=="number"?this.modS(n):this.modM(n)},i.prototype.modS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)%n);return this},i.prototype.modM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)%n.get(r,s));return this},i.mod=function(n,r){return new t(n).mod(r)},i.prototype.modulus=i.prototype.mod,i.prototype.modulusS=i.prototype.modS,i.prototype.modulusM=i.prototype.modM,i.modulus=i.mod,i.prototype.and=function(n){return typeof n=="number"?this.andS(n):this.andM(n)},i.prototype.andS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)&n);return this},i.prototype.andM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)&n.get(r,s));return this},i.and=function(n,r){return new t(n).and(r)},i.prototype.or=function(n){return typeof n=="number"?this.orS(n):this.orM(n)},i.prototype.orS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)|n);return this},i.prototype.orM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)|n.get(r,s));return this},i.or=function(n,r){return new t(n).or(r)},i.prototype.xor=function(n){return typeof n=="number"?this.xorS(n):this.xorM(n)},i.prototype.xorS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)^n);return this},i.prototype.xorM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)^n.get(r,s));return this},i.xor=function(n,r){return new t(n).xor(r)},i.prototype.leftShift=function(n){return typeof n=="number"?this.leftShiftS(n):this.leftShiftM(n)},i.prototype.leftShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)<<n);return this},i.prototype.leftShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)<<n.get(r,s));return this},i.leftShift=function(n,r){return new t(n).leftShift(r)},i.prototype.signPropagatingRightShift=function(n){return typeof n=="number"?this.signPropagatingRightShiftS(n):this.signPropagatingRightShiftM(n)},i.prototype.signPropagatingRightShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>n);return this},i.prototype.signPropagatingRightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>n.get(r,s));return this},i.signPropagatingRightShift=function(n,r){return new t(n).signPropagatingRightShift(r)},i.prototype.rightShift=function(n){return typeof n=="number"?this.rightShiftS(n):this.rightShiftM(n)},i.prototype.rightShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>>n);return this},i.prototype.rightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>>n.get(r,s));return this},i.rightShift=function(n,r){return new t(n).rightShift(r)},i.prototype.zeroFillRightShift=i.prototype.rightShift,i.prototype.zeroFillRightShiftS=i.prototype.rightShiftS,i.prototype.zeroFillRightShiftM=i.prototype.rightShiftM,i.zeroFillRightShift=i.rightShift,i.prototype.not=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,~this.get(n,r));return this},i.not=function(n){return new t(n).not()},i.prototype.abs=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.abs(this.get(n,r)));return this},i.abs=function(n){return new t(n).abs()},i.prototype.acos=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.acos(this.get(n,r)));return this},i.acos=function(n){return new t(n).acos()},i.prototype.acosh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.acosh(this.get(n,r)));return this},i.acosh=function(n){return new t(n).acosh()},i.prototype.asin=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.asin(this.get(n,r)));return this},i.asin=function(n){return new t(n).asin()},i.prototype.asinh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.asinh(this.get(n,r)));return this},i.asinh=function(n){return new t(n).asinh()},i.prototype.atan=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.atan(this.get(n,r)));return this},i.atan=function(n){return new t(n).atan()},i.prototype.atanh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.atanh(this.get(n,r)));return this},i.atanh=function(n){return new t(n).atanh()},i.prototype.cbrt=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cbrt(this.get(n,r)));return this},i.cbrt=function(n){return new t(n).cbrt()},i.prototype.ceil=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.ceil(this.get(n,r)));return this},i.ceil=function(n){return new t(n).ceil()},i.prototype.clz32=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.clz32(this.get(n,r)));return this},i.clz32=function(n){return new t(n).clz32()},i.prototype.cos=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cos(this.get(n,r)));return this},i.cos=function(n){return new t(n).cos()},i.prototype.cosh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cosh(this.get(n,r)));return this},i.cosh=function(n){return new t(n).cosh()},i.prototype.exp=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.exp(this.get(n,r)));return this},i.exp=function(n){return new t(n).exp()},i.prototype.expm1=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.expm1(this.get(n,r)));return this},i.expm1=function(n){return new t(n).expm1()},i.prototype.floor=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.floor(this.get(n,r)));return this},i.floor=function(n){return new t(n).floor()},i.prototype.fround=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.fround(this.get(n,r)));return this},i.fround=function(n){return new t(n).fround()},i.prototype.log=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log(this.get(n,r)));return this},i.log=function(n){return new t(n).log()},i.prototype.log1p=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log1p(this.get(n,r)));return this},i.log1p=function(n){return new t(n).log1p()},i.prototype.log10=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log10(this.get(n,r)));return this},i.log10=function(n){return new t(n).log10()},i.prototype.log2=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log2(this.get(n,r)));return this},i.log2=function(n){return new t(n).log2()},i.prototype.round=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.round(this.get(n,r)));return this},i.round=function(n){return new t(n).round()},i.prototype.sign=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sign(this.get(n,r)));return this},i.sign=function(n){return new t(n).sign()},i.prototype.sin=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sin(this.get(n,r)));return this},i.sin=function(n){return new t(n).sin()},i.prototype.sinh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sinh(this.get(n,r)));return this},i.sinh=function(n){return new t(n).sinh()},i.prototype.sqrt=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sqrt(this.get(n,r)));return this},i.sqrt=function(n){return new t(n).sqrt()},i.prototype.tan=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.tan(this.get(n,r)));return this},i.tan=function(n){return new t(n).tan()},i.prototype.tanh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.tanh(this.get(n,r)));return this},i.tanh=function(n){return new t(n).tanh()},i.prototype.trunc=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.trunc(this.get(n,r)));return this},i.trunc=function(n){return new t(n).trunc()},i.pow=function(n,r){return new t(n).pow(r)},i.prototype.pow=function(n){return typeof n=="number"?this.powS(n):this.powM(n)},i.prototype.powS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)**n);return this},i.prototype.powM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)**n.get(r,s));return this}}function Ni(i,t,e){let n=e?i.rows:i.rows-1;if(t<0||t>n)throw new RangeError("Row index out of range")}function Di(i,t,e){let n=e?i.columns:i.columns-1;if(t<0||t>n)throw new RangeError("Column index out of range")}function Ls(i,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==i.columns)throw new RangeError("vector size must be the same as the number of columns");return t}function Fs(i,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==i.rows)throw new RangeError("vector size must be the same as the number of rows");return t}function Y0(i,t){if(!Nn(t))throw new TypeError("row indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=i.rows)throw new RangeError("row indices are out of range")}function j0(i,t){if(!Nn(t))throw new TypeError("column indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=i.columns)throw new RangeError("column indices are out of range")}function sd(i,t,e,n,r){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(vc("startRow",t),vc("endRow",e),vc("startColumn",n),vc("endColumn",r),t>e||n>r||t<0||t>=i.rows||e<0||e>=i.rows||n<0||n>=i.columns||r<0||r>=i.columns)throw new RangeError("Submatrix indices are out of range")}function Fa(i,t=0){let e=[];for(let n=0;n<i;n++)e.push(t);return e}function vc(i,t){if(typeof t!="number")throw new TypeError(`${i} must be a number`)}function Ns(i){if(i.isEmpty())throw new Error("Empty matrix has no elements to index")}function Z0(i){let t=Fa(i.rows);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[e]+=i.get(e,n);return t}function J0(i){let t=Fa(i.columns);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[n]+=i.get(e,n);return t}function K0(i){let t=0;for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)t+=i.get(e,n);return t}function Q0(i){let t=Fa(i.rows,1);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[e]*=i.get(e,n);return t}function ty(i){let t=Fa(i.columns,1);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[n]*=i.get(e,n);return t}function ey(i){let t=1;for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)t*=i.get(e,n);return t}function ny(i,t,e){let n=i.rows,r=i.columns,s=[];for(let o=0;o<n;o++){let a=0,l=0,c=0;for(let u=0;u<r;u++)c=i.get(o,u)-e[o],a+=c,l+=c*c;t?s.push((l-a*a/r)/(r-1)):s.push((l-a*a/r)/r)}return s}function iy(i,t,e){let n=i.rows,r=i.columns,s=[];for(let o=0;o<r;o++){let a=0,l=0,c=0;for(let u=0;u<n;u++)c=i.get(u,o)-e[o],a+=c,l+=c*c;t?s.push((l-a*a/n)/(n-1)):s.push((l-a*a/n)/n)}return s}function ry(i,t,e){let n=i.rows,r=i.columns,s=n*r,o=0,a=0,l=0;for(let c=0;c<n;c++)for(let u=0;u<r;u++)l=i.get(c,u)-e,o+=l,a+=l*l;return t?(a-o*o/s)/(s-1):(a-o*o/s)/s}function sy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t[e])}function oy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t[n])}function ay(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t)}function ly(i){let t=[];for(let e=0;e<i.rows;e++){let n=0;for(let r=0;r<i.columns;r++)n+=i.get(e,r)**2/(i.columns-1);t.push(Math.sqrt(n))}return t}function cy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t[e])}function uy(i){let t=[];for(let e=0;e<i.columns;e++){let n=0;for(let r=0;r<i.rows;r++)n+=i.get(r,e)**2/(i.rows-1);t.push(Math.sqrt(n))}return t}function hy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t[n])}function fy(i){let t=i.size-1,e=0;for(let n=0;n<i.columns;n++)for(let r=0;r<i.rows;r++)e+=i.get(r,n)**2/t;return Math.sqrt(e)}function dy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t)}var Ke=class i{static from1DArray(t,e,n){if(t*e!==n.length)throw new RangeError("data length does not match given dimensions");let s=new $t(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)s.set(o,a,n[o*e+a]);return s}static rowVector(t){let e=new $t(1,t.length);for(let n=0;n<t.length;n++)e.set(0,n,t[n]);return e}static columnVector(t){let e=new $t(t.length,1);for(let n=0;n<t.length;n++)e.set(n,0,t[n]);return e}static zeros(t,e){return new $t(t,e)}static ones(t,e){return new $t(t,e).fill(1)}static rand(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{random:r=Math.random}=n,s=new $t(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)s.set(o,a,r());return s}static randInt(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{min:r=0,max:s=1e3,random:o=Math.random}=n;if(!Number.isInteger(r))throw new TypeError("min must be an integer");if(!Number.isInteger(s))throw new TypeError("max must be an integer");if(r>=s)throw new RangeError("min must be smaller than max");let a=s-r,l=new $t(t,e);for(let c=0;c<t;c++)for(let u=0;u<e;u++){let h=r+Math.round(o()*a);l.set(c,u,h)}return l}static eye(t,e,n){e===void 0&&(e=t),n===void 0&&(n=1);let r=Math.min(t,e),s=this.zeros(t,e);for(let o=0;o<r;o++)s.set(o,o,n);return s}static diag(t,e,n){let r=t.length;e===void 0&&(e=r),n===void 0&&(n=e);let s=Math.min(r,e,n),o=this.zeros(e,n);for(let a=0;a<s;a++)o.set(a,a,t[a]);return o}static min(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,r=t.columns,s=new $t(n,r);for(let o=0;o<n;o++)for(let a=0;a<r;a++)s.set(o,a,Math.min(t.get(o,a),e.get(o,a)));return s}static max(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,r=t.columns,s=new this(n,r);for(let o=0;o<n;o++)for(let a=0;a<r;a++)s.set(o,a,Math.max(t.get(o,a),e.get(o,a)));return s}static checkMatrix(t){return i.isMatrix(t)?t:new $t(t)}static isMatrix(t){return t!=null&&t.klass==="Matrix"}get size(){return this.rows*this.columns}apply(t){if(typeof t!="function")throw new TypeError("callback must be a function");for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.call(this,e,n);return this}applyAlongAxis(t,e){if(typeof t!="function")throw new TypeError("callback must be a function");let n=[];switch(e){case"row":{for(let r=0;r<this.rows;r++)n.push(t.call(this,this.getRow(r),r));break}case"column":{for(let r=0;r<this.columns;r++)n.push(t.call(this,this.getColumn(r),r));break}default:throw new Error(`invalid option: ${e}`)}return n}to1DArray(){let t=[];for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.push(this.get(e,n));return t}to2DArray(){let t=[];for(let e=0;e<this.rows;e++){t.push([]);for(let n=0;n<this.columns;n++)t[e].push(this.get(e,n))}return t}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let t=0;t<this.rows;t++)for(let e=0;e<=t;e++)if(this.get(t,e)!==this.get(e,t))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let t=0;t<this.rows;t++)if(this.get(t,t)!==0)return!1;return!0}isEchelonForm(){let t=0,e=0,n=-1,r=!0,s=!1;for(;t<this.rows&&r;){for(e=0,s=!1;e<this.columns&&s===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(s=!0,n=e):(r=!1,s=!0);t++}return r}isReducedEchelonForm(){let t=0,e=0,n=-1,r=!0,s=!1;for(;t<this.rows&&r;){for(e=0,s=!1;e<this.columns&&s===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(s=!0,n=e):(r=!1,s=!0);for(let o=e+1;o<this.rows;o++)this.get(t,o)!==0&&(r=!1);t++}return r}echelonForm(){let t=this.clone(),e=0,n=0;for(;e<t.rows&&n<t.columns;){let r=e;for(let s=e;s<t.rows;s++)t.get(s,n)>t.get(r,n)&&(r=s);if(t.get(r,n)===0)n++;else{t.swapRows(e,r);let s=t.get(e,n);for(let o=n;o<t.columns;o++)t.set(e,o,t.get(e,o)/s);for(let o=e+1;o<t.rows;o++){let a=t.get(o,n)/t.get(e,n);t.set(o,n,0);for(let l=n+1;l<t.columns;l++)t.set(o,l,t.get(o,l)-t.get(e,l)*a)}e++,n++}}return t}reducedEchelonForm(){let t=this.echelonForm(),e=t.columns,n=t.rows,r=n-1;for(;r>=0;)if(t.maxRow(r)===0)r--;else{let s=0,o=!1;for(;s<n&&o===!1;)t.get(r,s)===1?o=!0:s++;for(let a=0;a<r;a++){let l=t.get(a,s);for(let c=s;c<e;c++){let u=t.get(a,c)-l*t.get(r,c);t.set(a,c,u)}}r--}return t}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{rows:e=1,columns:n=1}=t;if(!Number.isInteger(e)||e<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(n)||n<=0)throw new TypeError("columns must be a positive integer");let r=new $t(this.rows*e,this.columns*n);for(let s=0;s<e;s++)for(let o=0;o<n;o++)r.setSubMatrix(this,this.rows*s,this.columns*o);return r}fill(t){for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,t);return this}neg(){return this.mulS(-1)}getRow(t){Ni(this,t);let e=[];for(let n=0;n<this.columns;n++)e.push(this.get(t,n));return e}getRowVector(t){return $t.rowVector(this.getRow(t))}setRow(t,e){Ni(this,t),e=Ls(this,e);for(let n=0;n<this.columns;n++)this.set(t,n,e[n]);return this}swapRows(t,e){Ni(this,t),Ni(this,e);for(let n=0;n<this.columns;n++){let r=this.get(t,n);this.set(t,n,this.get(e,n)),this.set(e,n,r)}return this}getColumn(t){Di(this,t);let e=[];for(let n=0;n<this.rows;n++)e.push(this.get(n,t));return e}getColumnVector(t){return $t.columnVector(this.getColumn(t))}setColumn(t,e){Di(this,t),e=Fs(this,e);for(let n=0;n<this.rows;n++)this.set(n,t,e[n]);return this}swapColumns(t,e){Di(this,t),Di(this,e);for(let n=0;n<this.rows;n++){let r=this.get(n,t);this.set(n,t,this.get(n,e)),this.set(n,e,r)}return this}addRowVector(t){t=Ls(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[n]);return this}subRowVector(t){t=Ls(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[n]);return this}mulRowVector(t){t=Ls(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[n]);return this}divRowVector(t){t=Ls(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[n]);return this}addColumnVector(t){t=Fs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[e]);return this}subColumnVector(t){t=Fs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[e]);return this}mulColumnVector(t){t=Fs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[e]);return this}divColumnVector(t){t=Fs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[e]);return this}mulRow(t,e){Ni(this,t);for(let n=0;n<this.columns;n++)this.set(t,n,this.get(t,n)*e);return this}mulColumn(t,e){Di(this,t);for(let n=0;n<this.rows;n++)this.set(n,t,this.get(n,t)*e);return this}max(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e[n]&&(e[n]=this.get(n,r));return e}case"column":{let e=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e[r]&&(e[r]=this.get(n,r));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e&&(e=this.get(n,r));return e}default:throw new Error(`invalid option: ${t}`)}}maxIndex(){Ns(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>t&&(t=this.get(n,r),e[0]=n,e[1]=r);return e}min(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e[n]&&(e[n]=this.get(n,r));return e}case"column":{let e=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e[r]&&(e[r]=this.get(n,r));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e&&(e=this.get(n,r));return e}default:throw new Error(`invalid option: ${t}`)}}minIndex(){Ns(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<t&&(t=this.get(n,r),e[0]=n,e[1]=r);return e}maxRow(t){if(Ni(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)>e&&(e=this.get(t,n));return e}maxRowIndex(t){Ni(this,t),Ns(this);let e=this.get(t,0),n=[t,0];for(let r=1;r<this.columns;r++)this.get(t,r)>e&&(e=this.get(t,r),n[1]=r);return n}minRow(t){if(Ni(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)<e&&(e=this.get(t,n));return e}minRowIndex(t){Ni(this,t),Ns(this);let e=this.get(t,0),n=[t,0];for(let r=1;r<this.columns;r++)this.get(t,r)<e&&(e=this.get(t,r),n[1]=r);return n}maxColumn(t){if(Di(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)>e&&(e=this.get(n,t));return e}maxColumnIndex(t){Di(this,t),Ns(this);let e=this.get(0,t),n=[0,t];for(let r=1;r<this.rows;r++)this.get(r,t)>e&&(e=this.get(r,t),n[0]=r);return n}minColumn(t){if(Di(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)<e&&(e=this.get(n,t));return e}minColumnIndex(t){Di(this,t),Ns(this);let e=this.get(0,t),n=[0,t];for(let r=1;r<this.rows;r++)this.get(r,t)<e&&(e=this.get(r,t),n[0]=r);return n}diag(){let t=Math.min(this.rows,this.columns),e=[];for(let n=0;n<t;n++)e.push(this.get(n,n));return e}norm(t="frobenius"){switch(t){case"max":return $t.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${t}`)}}cumulativeSum(){let t=0;for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t+=this.get(e,n),this.set(e,n,t);return this}dot(t){i.isMatrix(t)&&(t=t.to1DArray());let e=this.to1DArray();if(e.length!==t.length)throw new RangeError("vectors do not have the same size");let n=0;for(let r=0;r<e.length;r++)n+=e[r]*t[r];return n}mmul(t){t=$t.checkMatrix(t);let e=this.rows,n=this.columns,r=t.columns,s=new $t(e,r),o=new Float64Array(n);for(let a=0;a<r;a++){for(let l=0;l<n;l++)o[l]=t.get(l,a);for(let l=0;l<e;l++){let c=0;for(let u=0;u<n;u++)c+=this.get(l,u)*o[u];s.set(l,a,c)}}return s}gram(){let t=this.rows,e=this.columns,n=new Float64Array(e*e);for(let s=0;s<t;s++)for(let o=0;o<e;o++){let a=this.get(s,o);if(a===0)continue;let l=o*e;for(let c=o;c<e;c++)n[l+c]+=a*this.get(s,c)}let r=new $t(e,e);for(let s=0;s<e;s++){let o=s*e;for(let a=s;a<e;a++){let l=n[o+a];r.set(s,a,l),r.set(a,s,l)}}return r}transposeMultiply(t){if(t=$t.checkMatrix(t),this.rows!==t.rows)throw new RangeError("the number of rows of the two matrices must be equal");let e=this.columns,n=t.columns,r=new $t(e,n),s=new Float64Array(n);for(let o=0;o<this.rows;o++){for(let a=0;a<n;a++)s[a]=t.get(o,a);for(let a=0;a<e;a++){let l=this.get(o,a);if(l===0)continue;let c=r.data[a];for(let u=0;u<n;u++)c[u]+=l*s[u]}}return r}mmulByTranspose(t){let e=this.rows,n=this.columns;if(t!==void 0&&t.length!==n)throw new RangeError("scale must have one value per column");let r=new $t(e,e),s=new Float64Array(n);for(let o=0;o<e;o++){if(t===void 0)for(let a=0;a<n;a++)s[a]=this.get(o,a);else for(let a=0;a<n;a++)s[a]=t[a]*this.get(o,a);for(let a=o;a<e;a++){let l=0;for(let c=0;c<n;c++)l+=this.get(a,c)*s[c];r.set(a,o,l),r.set(o,a,l)}}return r}mpow(t){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(t)||t<0)throw new RangeError("Exponent must be a non-negative integer");let e=$t.eye(this.rows),n=this;for(let r=t;r>=1;r/=2)(r&1)!==0&&(e=e.mmul(n)),n=n.mmul(n);return e}strassen2x2(t){t=$t.checkMatrix(t);let e=new $t(2,2),n=this.get(0,0),r=t.get(0,0),s=this.get(0,1),o=t.get(0,1),a=this.get(1,0),l=t.get(1,0),c=this.get(1,1),u=t.get(1,1),h=(n+c)*(r+u),f=(a+c)*r,d=n*(o-u),m=c*(l-r),y=(n+s)*u,g=(a-n)*(r+o),p=(s-c)*(l+u),x=h+m-y+p,b=d+y,v=f+m,A=h-f+d+g;return e.set(0,0,x),e.set(0,1,b),e.set(1,0,v),e.set(1,1,A),e}strassen3x3(t){t=$t.checkMatrix(t);let e=new $t(3,3),n=this.get(0,0),r=this.get(0,1),s=this.get(0,2),o=this.get(1,0),a=this.get(1,1),l=this.get(1,2),c=this.get(2,0),u=this.get(2,1),h=this.get(2,2),f=t.get(0,0),d=t.get(0,1),m=t.get(0,2),y=t.get(1,0),g=t.get(1,1),p=t.get(1,2),x=t.get(2,0),b=t.get(2,1),v=t.get(2,2),A=(n+r+s-o-a-u-h)*g,S=(n-o)*(-d+g),_=a*(-f+d+y-g-p-x+v),w=(-n+o+a)*(f-d+g),N=(o+a)*(-f+d),C=n*f,P=(-n+c+u)*(f-m+p),O=(-n+c)*(m-p),B=(c+u)*(-f+m),F=(n+r+s-a-l-c-u)*p,V=u*(-f+m+y-g-p-x+b),q=(-s+u+h)*(g+x-b),G=(s-h)*(g-b),rt=s*x,$=(u+h)*(-x+b),j=(-s+a+l)*(p+x-v),tt=(s-l)*(p-v),ut=(a+l)*(-x+v),ct=r*y,K=l*b,gt=o*m,yt=c*d,Mt=h*v,xt=C+rt+ct,zt=A+w+N+C+q+rt+$,te=C+P+B+F+rt+j+ut,dt=S+_+w+C+rt+j+tt,Wt=S+w+N+C+K,qt=rt+j+tt+ut+gt,Yt=C+P+O+V+q+G+rt,_e=q+G+rt+$+yt,Ne=C+P+O+B+Mt;return e.set(0,0,xt),e.set(0,1,zt),e.set(0,2,te),e.set(1,0,dt),e.set(1,1,Wt),e.set(1,2,qt),e.set(2,0,Yt),e.set(2,1,_e),e.set(2,2,Ne),e}mmulStrassen(t){t=$t.checkMatrix(t);let e=this.clone(),n=e.rows,r=e.columns,s=t.rows,o=t.columns;r!==s&&console.warn(`Multiplying ${n} x ${r} and ${s} x ${o} matrix: dimensions do not match.`);function a(h,f,d){let m=h.rows,y=h.columns;if(m===f&&y===d)return h;{let g=i.zeros(f,d);return g=g.setSubMatrix(h,0,0),g}}let l=Math.max(n,s),c=Math.max(r,o);e=a(e,l,c),t=a(t,l,c);function u(h,f,d,m){if(d<=512||m<=512)return h.mmul(f);d%2===1&&m%2===1?(h=a(h,d+1,m+1),f=a(f,d+1,m+1)):d%2===1?(h=a(h,d+1,m),f=a(f,d+1,m)):m%2===1&&(h=a(h,d,m+1),f=a(f,d,m+1));let y=parseInt(h.rows/2,10),g=parseInt(h.columns/2,10),p=h.subMatrix(0,y-1,0,g-1),x=f.subMatrix(0,y-1,0,g-1),b=h.subMatrix(0,y-1,g,h.columns-1),v=f.subMatrix(0,y-1,g,f.columns-1),A=h.subMatrix(y,h.rows-1,0,g-1),S=f.subMatrix(y,f.rows-1,0,g-1),_=h.subMatrix(y,h.rows-1,g,h.columns-1),w=f.subMatrix(y,f.rows-1,g,f.columns-1),N=u(i.add(p,_),i.add(x,w),y,g),C=u(i.add(A,_),x,y,g),P=u(p,i.sub(v,w),y,g),O=u(_,i.sub(S,x),y,g),B=u(i.add(p,b),w,y,g),F=u(i.sub(A,p),i.add(x,v),y,g),V=u(i.sub(b,_),i.add(S,w),y,g),q=i.add(N,O);q.sub(B),q.add(V);let G=i.add(P,B),rt=i.add(C,O),$=i.sub(N,C);$.add(P),$.add(F);let j=i.zeros(2*q.rows,2*q.columns);return j=j.setSubMatrix(q,0,0),j=j.setSubMatrix(G,q.rows,0),j=j.setSubMatrix(rt,0,q.columns),j=j.setSubMatrix($,q.rows,q.columns),j.subMatrix(0,d-1,0,m-1)}return u(e,t,l,c)}scaleRows(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let r=new $t(this.rows,this.columns);for(let s=0;s<this.rows;s++){let o=this.getRow(s);o.length>0&&xc(o,{min:e,max:n,output:o}),r.setRow(s,o)}return r}scaleColumns(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let r=new $t(this.rows,this.columns);for(let s=0;s<this.columns;s++){let o=this.getColumn(s);o.length&&xc(o,{min:e,max:n,output:o}),r.setColumn(s,o)}return r}flipRows(){let t=Math.ceil(this.columns/2);for(let e=0;e<this.rows;e++)for(let n=0;n<t;n++){let r=this.get(e,n),s=this.get(e,this.columns-1-n);this.set(e,n,s),this.set(e,this.columns-1-n,r)}return this}flipColumns(){let t=Math.ceil(this.rows/2);for(let e=0;e<this.columns;e++)for(let n=0;n<t;n++){let r=this.get(n,e),s=this.get(this.rows-1-n,e);this.set(n,e,s),this.set(this.rows-1-n,e,r)}return this}kroneckerProduct(t){t=$t.checkMatrix(t);let e=this.rows,n=this.columns,r=t.rows,s=t.columns,o=new $t(e*r,n*s);for(let a=0;a<e;a++)for(let l=0;l<n;l++)for(let c=0;c<r;c++)for(let u=0;u<s;u++)o.set(r*a+c,s*l+u,this.get(a,l)*t.get(c,u));return o}kroneckerSum(t){if(t=$t.checkMatrix(t),!this.isSquare()||!t.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let e=this.rows,n=t.rows,r=this.kroneckerProduct($t.eye(n,n)),s=$t.eye(e,e).kroneckerProduct(t);return r.add(s)}transpose(){let t=new $t(this.columns,this.rows);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.set(n,e,this.get(e,n));return t}sortRows(t=py){for(let e=0;e<this.rows;e++)this.setRow(e,this.getRow(e).sort(t));return this}sortColumns(t=py){for(let e=0;e<this.columns;e++)this.setColumn(e,this.getColumn(e).sort(t));return this}subMatrix(t,e,n,r){sd(this,t,e,n,r);let s=new $t(e-t+1,r-n+1);for(let o=t;o<=e;o++)for(let a=n;a<=r;a++)s.set(o-t,a-n,this.get(o,a));return s}subMatrixRow(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.columns-1),e>n||e<0||e>=this.columns||n<0||n>=this.columns)throw new RangeError("Argument out of range");let r=new $t(t.length,n-e+1);for(let s=0;s<t.length;s++)for(let o=e;o<=n;o++){if(t[s]<0||t[s]>=this.rows)throw new RangeError(`Row index out of range: ${t[s]}`);r.set(s,o-e,this.get(t[s],o))}return r}subMatrixColumn(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.rows-1),e>n||e<0||e>=this.rows||n<0||n>=this.rows)throw new RangeError("Argument out of range");let r=new $t(n-e+1,t.length);for(let s=0;s<t.length;s++)for(let o=e;o<=n;o++){if(t[s]<0||t[s]>=this.columns)throw new RangeError(`Column index out of range: ${t[s]}`);r.set(o-e,s,this.get(o,t[s]))}return r}setSubMatrix(t,e,n){if(t=$t.checkMatrix(t),t.isEmpty())return this;let r=e+t.rows-1,s=n+t.columns-1;sd(this,e,r,n,s);for(let o=0;o<t.rows;o++)for(let a=0;a<t.columns;a++)this.set(e+o,n+a,t.get(o,a));return this}concat(t,e="row"){switch(t=$t.checkMatrix(t),e){case"row":{if(this.columns!==t.columns)throw new RangeError("both matrices must have the same number of columns");let n=new $t(this.rows+t.rows,this.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,this.rows,0),n}case"column":{if(this.rows!==t.rows)throw new RangeError("both matrices must have the same number of rows");let n=new $t(this.rows,this.columns+t.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,0,this.columns),n}default:throw new Error(`invalid option: ${e}`)}}selection(t,e){Y0(this,t),j0(this,e);let n=new $t(t.length,e.length);for(let r=0;r<t.length;r++){let s=t[r];for(let o=0;o<e.length;o++){let a=e[o];n.set(r,o,this.get(s,a))}}return n}trace(){let t=Math.min(this.rows,this.columns),e=0;for(let n=0;n<t;n++)e+=this.get(n,n);return e}clone(){return this.constructor.copy(this,new $t(this.rows,this.columns))}static copy(t,e){for(let[n,r,s]of t.entries())e.set(n,r,s);return e}sum(t){switch(t){case"row":return Z0(this);case"column":return J0(this);case void 0:return K0(this);default:throw new Error(`invalid option: ${t}`)}}product(t){switch(t){case"row":return Q0(this);case"column":return ty(this);case void 0:return ey(this);default:throw new Error(`invalid option: ${t}`)}}mean(t){let e=this.sum(t);switch(t){case"row":{for(let n=0;n<this.rows;n++)e[n]/=this.columns;return e}case"column":{for(let n=0;n<this.columns;n++)e[n]/=this.rows;return e}case void 0:return e/this.size;default:throw new Error(`invalid option: ${t}`)}}variance(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{unbiased:n=!0,mean:r=this.mean(t)}=e;if(typeof n!="boolean")throw new TypeError("unbiased must be a boolean");switch(t){case"row":{if(!Nn(r))throw new TypeError("mean must be an array");return ny(this,n,r)}case"column":{if(!Nn(r))throw new TypeError("mean must be an array");return iy(this,n,r)}case void 0:{if(typeof r!="number")throw new TypeError("mean must be a number");return ry(this,n,r)}default:throw new Error(`invalid option: ${t}`)}}standardDeviation(t,e){typeof t=="object"&&(e=t,t=void 0);let n=this.variance(t,e);if(t===void 0)return Math.sqrt(n);for(let r=0;r<n.length;r++)n[r]=Math.sqrt(n[r]);return n}center(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{center:n=this.mean(t)}=e;switch(t){case"row":{if(!Nn(n))throw new TypeError("center must be an array");return sy(this,n),this}case"column":{if(!Nn(n))throw new TypeError("center must be an array");return oy(this,n),this}case void 0:{if(typeof n!="number")throw new TypeError("center must be a number");return ay(this,n),this}default:throw new Error(`invalid option: ${t}`)}}scale(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let n=e.scale;switch(t){case"row":{if(n===void 0)n=ly(this);else if(!Nn(n))throw new TypeError("scale must be an array");return cy(this,n),this}case"column":{if(n===void 0)n=uy(this);else if(!Nn(n))throw new TypeError("scale must be an array");return hy(this,n),this}case void 0:{if(n===void 0)n=fy(this);else if(typeof n!="number")throw new TypeError("scale must be a number");return dy(this,n),this}default:throw new Error(`invalid option: ${t}`)}}toString(t){return rd(this,t)}[Symbol.iterator](){return this.entries()}*entries(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield[t,e,this.get(t,e)]}*values(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield this.get(t,e)}};Ke.prototype.klass="Matrix";typeof Symbol<"u"&&(Ke.prototype[Symbol.for("nodejs.util.inspect.custom")]=X0);function py(i,t){return i-t}function mS(i){return i.every(t=>typeof t=="number")}Ke.random=Ke.rand;Ke.randomInt=Ke.randInt;Ke.diagonal=Ke.diag;Ke.prototype.diagonal=Ke.prototype.diag;Ke.identity=Ke.eye;Ke.prototype.negate=Ke.prototype.neg;Ke.prototype.tensorProduct=Ke.prototype.kroneckerProduct;var $t=class i extends Ke{data;#t(t,e){if(this.data=[],Number.isInteger(e)&&e>=0)for(let n=0;n<t;n++)this.data.push(new Float64Array(e));else throw new TypeError("nColumns must be a positive integer");this.rows=t,this.columns=e}constructor(t,e){if(super(),i.isMatrix(t))this.#t(t.rows,t.columns),i.copy(t,this);else if(Number.isInteger(t)&&t>=0)this.#t(t,e);else if(Nn(t)){let n=t;if(t=n.length,e=t?n[0].length:0,typeof e!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let r=0;r<t;r++){if(n[r].length!==e)throw new RangeError("Inconsistent array dimensions");if(!mS(n[r]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(n[r]))}this.rows=t,this.columns=e}else throw new TypeError("First argument must be a positive number or an array")}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}removeRow(t){return Ni(this,t),this.data.splice(t,1),this.rows-=1,this}addRow(t,e){return e===void 0&&(e=t,t=this.rows),Ni(this,t,!0),e=Float64Array.from(Ls(this,e)),this.data.splice(t,0,e),this.rows+=1,this}removeColumn(t){Di(this,t);for(let e=0;e<this.rows;e++){let n=new Float64Array(this.columns-1);for(let r=0;r<t;r++)n[r]=this.data[e][r];for(let r=t+1;r<this.columns;r++)n[r-1]=this.data[e][r];this.data[e]=n}return this.columns-=1,this}addColumn(t,e){typeof e>"u"&&(e=t,t=this.columns),Di(this,t,!0),e=Fs(this,e);for(let n=0;n<this.rows;n++){let r=new Float64Array(this.columns+1),s=0;for(;s<t;s++)r[s]=this.data[n][s];for(r[s++]=e[n];s<this.columns+1;s++)r[s]=this.data[n][s-1];this.data[n]=r}return this.columns+=1,this}};$0(Ke,$t);var Na=class extends Ke{constructor(t){super(),this.data=t,this.rows=t.length,this.columns=t[0].length}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}};function my(i){let t=i.data,e=i.rows;for(let n=0;n<e;n++){let r=t[n];for(let s=n+1;s<e;s++){let o=r[s];r[s]=t[s][n],t[s][n]=o}}return i}function od(i,t){let e=0;return Math.abs(i)>Math.abs(t)?(e=t/i,Math.abs(i)*Math.sqrt(1+e*e)):t!==0?(e=i/t,Math.abs(t)*Math.sqrt(1+e*e)):0}var es=class{constructor(t,e={}){let{assumeSymmetric:n=!1}=e;if(t=Na.checkMatrix(t),!t.isSquare())throw new Error("Matrix is not a square matrix");if(t.isEmpty())throw new Error("Matrix must be non-empty");let r=t.columns,s=new $t(r,r),o=new Float64Array(r),a=new Float64Array(r),l=t,c,u,h=!1;if(n?h=!0:h=t.isSymmetric(),h){for(c=0;c<r;c++)for(u=0;u<r;u++)s.set(u,c,l.get(c,u));gS(r,a,o,s),yS(r,a,o,s),my(s)}else{let f=new $t(r,r),d=new Float64Array(r);for(u=0;u<r;u++)for(c=0;c<r;c++)f.set(c,u,l.get(c,u));xS(r,f,d,s),_S(r,a,o,s,f)}this.n=r,this.e=a,this.d=o,this.V=s}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let t=this.n,e=this.e,n=this.d,r=new $t(t,t),s,o;for(s=0;s<t;s++){for(o=0;o<t;o++)r.set(s,o,0);r.set(s,s,n[s]),e[s]>0?r.set(s,s+1,e[s]):e[s]<0&&r.set(s,s-1,e[s])}return r}};function gS(i,t,e,n){let r,s,o,a,l,c,u,h;for(l=0;l<i;l++)e[l]=n.get(l,i-1);for(a=i-1;a>0;a--){for(h=0,o=0,c=0;c<a;c++)h=h+Math.abs(e[c]);if(h===0)for(t[a]=e[a-1],l=0;l<a;l++)e[l]=n.get(l,a-1),n.set(l,a,0),n.set(a,l,0);else{for(c=0;c<a;c++)e[c]/=h,o+=e[c]*e[c];for(r=e[a-1],s=Math.sqrt(o),r>0&&(s=-s),t[a]=h*s,o=o-r*s,e[a-1]=r-s,l=0;l<a;l++)t[l]=0;for(l=0;l<a;l++){for(r=e[l],n.set(a,l,r),s=t[l]+n.get(l,l)*r,c=l+1;c<=a-1;c++)s+=n.get(l,c)*e[c],t[c]+=n.get(l,c)*r;t[l]=s}for(r=0,l=0;l<a;l++)t[l]/=o,r+=t[l]*e[l];for(u=r/(o+o),l=0;l<a;l++)t[l]-=u*e[l];for(l=0;l<a;l++){for(r=e[l],s=t[l],c=l;c<=a-1;c++)n.set(l,c,n.get(l,c)-(r*t[c]+s*e[c]));e[l]=n.get(l,a-1),n.set(l,a,0)}}e[a]=o}for(a=0;a<i-1;a++){if(n.set(a,i-1,n.get(a,a)),n.set(a,a,1),o=e[a+1],o!==0){for(c=0;c<=a;c++)e[c]=n.get(a+1,c)/o;for(l=0;l<=a;l++){for(s=0,c=0;c<=a;c++)s+=n.get(a+1,c)*n.get(l,c);for(c=0;c<=a;c++)n.set(l,c,n.get(l,c)-s*e[c])}}for(c=0;c<=a;c++)n.set(a+1,c,0)}for(l=0;l<i;l++)e[l]=n.get(l,i-1),n.set(l,i-1,0);n.set(i-1,i-1,1),t[0]=0}function yS(i,t,e,n){let r,s,o,a,l,c,u,h,f,d,m,y,g,p,x,b,v;for(o=1;o<i;o++)t[o-1]=t[o];t[i-1]=0;let A=0,S=0,_=Number.EPSILON;for(c=0;c<i;c++){for(S=Math.max(S,Math.abs(e[c])+Math.abs(t[c])),u=c;u<i&&!(Math.abs(t[u])<=_*S);)u++;if(u>c){v=0;do{for(v=v+1,r=e[c],h=(e[c+1]-r)/(2*t[c]),f=od(h,1),h<0&&(f=-f),e[c]=t[c]/(h+f),e[c+1]=t[c]*(h+f),d=e[c+1],s=r-e[c],o=c+2;o<i;o++)e[o]-=s;for(A=A+s,h=e[u],m=1,y=m,g=m,p=t[c+1],x=0,b=0,o=u-1;o>=c;o--)for(g=y,y=m,b=x,r=m*t[o],s=m*h,f=od(h,t[o]),t[o+1]=x*f,x=t[o]/f,m=h/f,h=m*e[o]-x*r,e[o+1]=s+x*(m*r+x*e[o]),l=0;l<i;l++)s=n.get(o+1,l),n.set(o+1,l,x*n.get(o,l)+m*s),n.set(o,l,m*n.get(o,l)-x*s);h=-x*b*g*p*t[c]/d,t[c]=x*h,e[c]=m*h}while(Math.abs(t[c])>_*S)}e[c]=e[c]+A,t[c]=0}for(o=0;o<i-1;o++){for(l=o,h=e[o],a=o+1;a<i;a++)e[a]<h&&(l=a,h=e[a]);if(l!==o)for(e[l]=e[o],e[o]=h,a=0;a<i;a++)h=n.get(o,a),n.set(o,a,n.get(l,a)),n.set(l,a,h)}}function xS(i,t,e,n){let r=0,s=i-1,o,a,l,c,u,h,f;for(h=r+1;h<=s-1;h++){for(f=0,c=h;c<=s;c++)f=f+Math.abs(t.get(c,h-1));if(f!==0){for(l=0,c=s;c>=h;c--)e[c]=t.get(c,h-1)/f,l+=e[c]*e[c];for(a=Math.sqrt(l),e[h]>0&&(a=-a),l=l-e[h]*a,e[h]=e[h]-a,u=h;u<i;u++){for(o=0,c=s;c>=h;c--)o+=e[c]*t.get(c,u);for(o=o/l,c=h;c<=s;c++)t.set(c,u,t.get(c,u)-o*e[c])}for(c=0;c<=s;c++){for(o=0,u=s;u>=h;u--)o+=e[u]*t.get(c,u);for(o=o/l,u=h;u<=s;u++)t.set(c,u,t.get(c,u)-o*e[u])}e[h]=f*e[h],t.set(h,h-1,f*a)}}for(c=0;c<i;c++)for(u=0;u<i;u++)n.set(c,u,c===u?1:0);for(h=s-1;h>=r+1;h--)if(t.get(h,h-1)!==0){for(c=h+1;c<=s;c++)e[c]=t.get(c,h-1);for(u=h;u<=s;u++){for(a=0,c=h;c<=s;c++)a+=e[c]*n.get(c,u);for(a=a/e[h]/t.get(h,h-1),c=h;c<=s;c++)n.set(c,u,n.get(c,u)+a*e[c])}}}function _S(i,t,e,n,r){let s=i-1,o=0,a=i-1,l=Number.EPSILON,c=0,u=0,h=0,f=0,d=0,m=0,y=0,g=0,p,x,b,v,A,S,_,w,N,C,P,O,B,F,V;for(p=0;p<i;p++)for((p<o||p>a)&&(e[p]=r.get(p,p),t[p]=0),x=Math.max(p-1,0);x<i;x++)u=u+Math.abs(r.get(p,x));for(;s>=o;){for(v=s;v>o&&(m=Math.abs(r.get(v-1,v-1))+Math.abs(r.get(v,v)),m===0&&(m=u),!(Math.abs(r.get(v,v-1))<l*m));)v--;if(v===s)r.set(s,s,r.get(s,s)+c),e[s]=r.get(s,s),t[s]=0,s--,g=0;else if(v===s-1){if(_=r.get(s,s-1)*r.get(s-1,s),h=(r.get(s-1,s-1)-r.get(s,s))/2,f=h*h+_,y=Math.sqrt(Math.abs(f)),r.set(s,s,r.get(s,s)+c),r.set(s-1,s-1,r.get(s-1,s-1)+c),w=r.get(s,s),f>=0){for(y=h>=0?h+y:h-y,e[s-1]=w+y,e[s]=e[s-1],y!==0&&(e[s]=w-_/y),t[s-1]=0,t[s]=0,w=r.get(s,s-1),m=Math.abs(w)+Math.abs(y),h=w/m,f=y/m,d=Math.sqrt(h*h+f*f),h=h/d,f=f/d,x=s-1;x<i;x++)y=r.get(s-1,x),r.set(s-1,x,f*y+h*r.get(s,x)),r.set(s,x,f*r.get(s,x)-h*y);for(p=0;p<=s;p++)y=r.get(p,s-1),r.set(p,s-1,f*y+h*r.get(p,s)),r.set(p,s,f*r.get(p,s)-h*y);for(p=o;p<=a;p++)y=n.get(p,s-1),n.set(p,s-1,f*y+h*n.get(p,s)),n.set(p,s,f*n.get(p,s)-h*y)}else e[s-1]=w+h,e[s]=w+h,t[s-1]=y,t[s]=-y;s=s-2,g=0}else{if(w=r.get(s,s),N=0,_=0,v<s&&(N=r.get(s-1,s-1),_=r.get(s,s-1)*r.get(s-1,s)),g===10){for(c+=w,p=o;p<=s;p++)r.set(p,p,r.get(p,p)-w);m=Math.abs(r.get(s,s-1))+Math.abs(r.get(s-1,s-2)),w=N=.75*m,_=-.4375*m*m}if(g===30&&(m=(N-w)/2,m=m*m+_,m>0)){for(m=Math.sqrt(m),N<w&&(m=-m),m=w-_/((N-w)/2+m),p=o;p<=s;p++)r.set(p,p,r.get(p,p)-m);c+=m,w=N=_=.964}for(g=g+1,A=s-2;A>=v&&(y=r.get(A,A),d=w-y,m=N-y,h=(d*m-_)/r.get(A+1,A)+r.get(A,A+1),f=r.get(A+1,A+1)-y-d-m,d=r.get(A+2,A+1),m=Math.abs(h)+Math.abs(f)+Math.abs(d),h=h/m,f=f/m,d=d/m,!(A===v||Math.abs(r.get(A,A-1))*(Math.abs(f)+Math.abs(d))<l*(Math.abs(h)*(Math.abs(r.get(A-1,A-1))+Math.abs(y)+Math.abs(r.get(A+1,A+1))))));)A--;for(p=A+2;p<=s;p++)r.set(p,p-2,0),p>A+2&&r.set(p,p-3,0);for(b=A;b<=s-1&&(F=b!==s-1,b!==A&&(h=r.get(b,b-1),f=r.get(b+1,b-1),d=F?r.get(b+2,b-1):0,w=Math.abs(h)+Math.abs(f)+Math.abs(d),w!==0&&(h=h/w,f=f/w,d=d/w)),w!==0);b++)if(m=Math.sqrt(h*h+f*f+d*d),h<0&&(m=-m),m!==0){for(b!==A?r.set(b,b-1,-m*w):v!==A&&r.set(b,b-1,-r.get(b,b-1)),h=h+m,w=h/m,N=f/m,y=d/m,f=f/h,d=d/h,x=b;x<i;x++)h=r.get(b,x)+f*r.get(b+1,x),F&&(h=h+d*r.get(b+2,x),r.set(b+2,x,r.get(b+2,x)-h*y)),r.set(b,x,r.get(b,x)-h*w),r.set(b+1,x,r.get(b+1,x)-h*N);for(p=0;p<=Math.min(s,b+3);p++)h=w*r.get(p,b)+N*r.get(p,b+1),F&&(h=h+y*r.get(p,b+2),r.set(p,b+2,r.get(p,b+2)-h*d)),r.set(p,b,r.get(p,b)-h),r.set(p,b+1,r.get(p,b+1)-h*f);for(p=o;p<=a;p++)h=w*n.get(p,b)+N*n.get(p,b+1),F&&(h=h+y*n.get(p,b+2),n.set(p,b+2,n.get(p,b+2)-h*d)),n.set(p,b,n.get(p,b)-h),n.set(p,b+1,n.get(p,b+1)-h*f)}}}if(u!==0){for(s=i-1;s>=0;s--)if(h=e[s],f=t[s],f===0)for(v=s,r.set(s,s,1),p=s-1;p>=0;p--){for(_=r.get(p,p)-h,d=0,x=v;x<=s;x++)d=d+r.get(p,x)*r.get(x,s);if(t[p]<0)y=_,m=d;else if(v=p,t[p]===0?r.set(p,s,_!==0?-d/_:-d/(l*u)):(w=r.get(p,p+1),N=r.get(p+1,p),f=(e[p]-h)*(e[p]-h)+t[p]*t[p],S=(w*m-y*d)/f,r.set(p,s,S),r.set(p+1,s,Math.abs(w)>Math.abs(y)?(-d-_*S)/w:(-m-N*S)/y)),S=Math.abs(r.get(p,s)),l*S*S>1)for(x=p;x<=s;x++)r.set(x,s,r.get(x,s)/S)}else if(f<0)for(v=s-1,Math.abs(r.get(s,s-1))>Math.abs(r.get(s-1,s))?(r.set(s-1,s-1,f/r.get(s,s-1)),r.set(s-1,s,-(r.get(s,s)-h)/r.get(s,s-1))):(V=bc(0,-r.get(s-1,s),r.get(s-1,s-1)-h,f),r.set(s-1,s-1,V[0]),r.set(s-1,s,V[1])),r.set(s,s-1,0),r.set(s,s,1),p=s-2;p>=0;p--){for(C=0,P=0,x=v;x<=s;x++)C=C+r.get(p,x)*r.get(x,s-1),P=P+r.get(p,x)*r.get(x,s);if(_=r.get(p,p)-h,t[p]<0)y=_,d=C,m=P;else if(v=p,t[p]===0?(V=bc(-C,-P,_,f),r.set(p,s-1,V[0]),r.set(p,s,V[1])):(w=r.get(p,p+1),N=r.get(p+1,p),O=(e[p]-h)*(e[p]-h)+t[p]*t[p]-f*f,B=(e[p]-h)*2*f,O===0&&B===0&&(O=l*u*(Math.abs(_)+Math.abs(f)+Math.abs(w)+Math.abs(N)+Math.abs(y))),V=bc(w*d-y*C+f*P,w*m-y*P-f*C,O,B),r.set(p,s-1,V[0]),r.set(p,s,V[1]),Math.abs(w)>Math.abs(y)+Math.abs(f)?(r.set(p+1,s-1,(-C-_*r.get(p,s-1)+f*r.get(p,s))/w),r.set(p+1,s,(-P-_*r.get(p,s)-f*r.get(p,s-1))/w)):(V=bc(-d-N*r.get(p,s-1),-m-N*r.get(p,s),y,f),r.set(p+1,s-1,V[0]),r.set(p+1,s,V[1]))),S=Math.max(Math.abs(r.get(p,s-1)),Math.abs(r.get(p,s))),l*S*S>1)for(x=p;x<=s;x++)r.set(x,s-1,r.get(x,s-1)/S),r.set(x,s,r.get(x,s)/S)}for(p=0;p<i;p++)if(p<o||p>a)for(x=p;x<i;x++)n.set(p,x,r.get(p,x));for(x=i-1;x>=o;x--)for(p=o;p<=a;p++){for(y=0,b=o;b<=Math.min(x,a);b++)y=y+n.get(p,b)*r.get(b,x);n.set(p,x,y)}}}function bc(i,t,e,n){let r,s;return Math.abs(e)>Math.abs(n)?(r=n/e,s=e+r*n,[(i+r*t)/s,(t-r*i)/s]):(r=e/n,s=n+r*e,[(r*i+t)/s,(r*t-i)/s])}var vS=1e-9,bS=1e-13,wS=1e-6;function gy(i,t,e){let n=fc(i,e);if(!n)throw new Error("mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate");let[r,s]=[0,0];for(let h=0;h<e;h+=1)for(let f=0;f<e;f+=1)r=Math.max(r,Math.abs(t[h*e+f]-t[f*e+h])),s=Math.max(s,Math.abs(t[h*e+f]));if(r>vS*s)return{...ld(n,ad(dc(n,t,e),e,!1),e),symmetric:!1};let o=t.map((h,f)=>(h+t[f%e*e+Math.floor(f/e)])/2),a=fc(o,e),l=a&&ad(dc(a,i,e),e,!0),c=l?Math.max(...l.re):0;if(!a||!l||Math.min(...l.re)<=0||1/c<=bS*e/Math.min(...l.re))return{...ld(n,ad(dc(n,o,e),e,!0),e),symmetric:!0};let u=ld(a,{re:l.re.map(h=>1/h),vectors:l.vectors},e);return{squares:u.squares,shapes:u.shapes.map((h,f)=>h*Math.sqrt(u.squares[f%e])),symmetric:!0}}function ad(i,t,e){let n=e?i.map((c,u)=>(c+i[u%t*t+Math.floor(u/t)])/2):i,r=new es($t.from1DArray(t,t,n),{assumeSymmetric:e}),{realEigenvalues:s,imaginaryEigenvalues:o,eigenvectorMatrix:a}=r,l=Float64Array.from(a.to1DArray());if(!e){for(let c=1;c<t;c+=1)if(o[c]<0)for(let u=0;u<t;u+=1)l[u*t+c]=l[u*t+c-1]}for(let c=0;c<t;c+=1){let u=Math.hypot(...Array.from({length:t},(h,f)=>l[f*t+c]));for(let h=0;h<t;h+=1)l[h*t+c]/=u}return{re:Float64Array.from(s),vectors:l}}function ld(i,{re:t,vectors:e},n){let r=Array.from(t.keys()).sort((o,a)=>t[o]-t[a]),s=new Float64Array(n*n);return r.forEach((o,a)=>{for(let l=0;l<n;l+=1)s[l*n+a]=e[l*n+o]}),jf(i,s,n,n),{squares:Float64Array.from(r,o=>t[o]),shapes:s}}function yy(i,t,e,n,r){let s=r.symmetric?r.shapes:SS(i,n),o=y=>ri(s,ri(y,s,n,n,n),n,n,n,!0),[a,l]=[o(e),o(t)];if(r.symmetric)for(let y=0;y<n*n;y+=1)a[y]=y%(n+1)?0:r.squares[y/(n+1)];let c=Array.from({length:n},(y,g)=>Math.sqrt(Math.abs(a[g*(n+1)]))),u=wS*Math.max(...c)||1,h=c.map(y=>Math.max(y,u)),f=$t.zeros(2*n,2*n);for(let y=0;y<n;y+=1){f.set(y,n+y,h[y]);for(let g=0;g<n;g+=1)f.set(n+y,g,-a[y*n+g]/h[g]),f.set(n+y,n+g,-l[y*n+g])}let d=new es(f,{assumeSymmetric:!1}),m={re:Float64Array.from(d.realEigenvalues),im:Float64Array.from(d.imaginaryEigenvalues)};return{count:2*n,values:m,shapes:MS(d.eigenvectorMatrix,m.im,s,h,n)}}function MS(i,t,e,n,r){let s={re:new Float64Array(2*r*r),im:new Float64Array(2*r*r)};for(let o=0;o<2*r;o+=1)for(let a=0;a<r;a+=1)s.re[2*r*a+o]=i.get(a,t[o]<0?o-1:o)/n[a],s.im[2*r*a+o]=(t[o]>0?i.get(a,o+1):t[o]<0?-i.get(a,o):0)/n[a];return{re:ri(e,s.re,r,r,2*r),im:ri(e,s.im,r,r,2*r)}}function SS(i,t){let e=Float64Array.from({length:t*t},(n,r)=>r%(t+1)?0:1);return jf(fc(i,t),e,t,t),e}var AS=["settling","vibration.residual","vibration.nominal"];function vi(i,t=3){return $e(i,t)}function cd(i,t){if(i.length<2)return t[0];let e=0;for(let n=1;n<i.length;n+=1)e+=(t[n]+t[n-1])/2*(i[n]-i[n-1]);return e/(i[i.length-1]-i[0])}function xy(i,t,e){let n={},r=t.deviation?.data;if(r){let s=La(r),o=r[r.length-1];n["deviation.max"]={value:r[s],note:`at ${vi(i[s])} s; ${$n(o,"m")} at the end of the run`},n["deviation.rms"]={value:Math.sqrt(cd(i,r.map(a=>a*a))),note:"over the run"}}return{...n,...ES(i,e,r!==void 0)}}function ES(i,t,e){let n=i[i.length-1];if(t!==null&&t<=n*(1+1e-9))return{};let r="what moves the robot changes up to the end of the run",s=`the run ends at ${vi(n,6)} s, the move at ${vi(t??0,6)} s`,o=t===null?r:`${s}: simulate longer to see it settle`,a={value:null,note:t===null?r:"the run ends with the move"},l={settling:{value:null,note:`not seen: ${o}`},"vibration.residual":a};return e?{...l,"vibration.nominal":a}:l}function _y(i){let t={},e=AS.filter(n=>n!=="vibration.nominal"||"deviation.max"in i);for(let n of e)t[n]={value:null,note:"the run broke off"};for(let[n,{value:r,note:s}]of Object.entries(i))e.includes(n)||(t[n]={value:r,note:`until it broke off: ${s}`});return t}function vy(i,t){if(!i.energy||!i.energy_balance)return{};let{energy:e,work:n}=i,r=e.shape[1],s=Math.max(e.data.reduce((l,c,u)=>Math.max(l,Math.abs(c-e.data[u%r])),0),n.data.reduce((l,c)=>Math.max(l,Math.abs(c)),0)),o=Math.abs(i.energy_balance.data[La(i.energy_balance.data.subarray(0,t))]),a=s?`worst residual, ${$n(o,"J")}, over ${$n(s,"J")} moved`:"nothing moved";return{"energy.residual":{value:s?o/s:null,note:a}}}var TS=8,ud=1e-5,RS=Math.SQRT1_2,CS=1e-9;function by(i,t,e,n){let r=Object.entries(i).flatMap(([a,l])=>l.filter(c=>c.frequency>0).slice(0,TS).map(c=>[a,c])),s=IS(r,e,n),o=t.flatMap(a=>a.rings&&a.damping<RS?[{at:a.rings,label:a.element}]:[]);return{vibration:{modes:s,marks:o.sort((a,l)=>a.at-l.at)},facts:PS(i)}}function PS({controlled:i,locked:t}){if(!i)return{};let e=o=>o.reduce((a,{rings:l,frequency:c})=>l&&c<(a??1/0)?c:a,null),[n,r]=[e(i),e(t??[])],s=n===null?"no vibration under control":r===null?"":`${vi(r,4)} Hz with the motors locked`;return{"frequency.first":{value:n,note:s}}}function IS(i,t,e){let n=t.length,r=new Float64Array((1+4*i.length)*n);r.set(t),i.forEach(([,{re:u,im:h}],f)=>{let d=u.reduce((m,y,g)=>Math.max(m,Math.hypot(y,h[g])),0);for(let m=0;m<n;m+=1){let[y,g]=[ud*u[m]/d,ud*h[m]/d];[y,g,-y,-g].forEach((p,x)=>{r[(1+4*f+x)*n+m]=t[m]+p})}});let{data:s,shape:o}=e(r,1+4*i.length),a=s.length/(1+4*i.length),l=u=>Float64Array.from({length:a},(h,f)=>(s[u*a+f]-s[(u+2)*a+f])/(2*ud)),c=u=>({data:Float32Array.from(u),shape:o.slice(1)});return i.map(([u,h],f)=>{let[d,m]=LS(l(1+4*f),l(2+4*f));return{case:u,frequency:h.frequency,damping:h.damping,element:h.element,rest:c(s.subarray(0,a)),real:c(d),imaginary:c(m)}})}function LS(i,t){let[e,n]=[0,0];for(let c=0;c<i.length;c+=3){let u=Math.hypot(...i.subarray(c,c+3),...t.subarray(c,c+3));u>n&&([e,n]=[c,u])}if(!n)return[i,t];let r=[0,1,2].map(c=>Math.hypot(i[e+c],t[e+c])),s=e+r.indexOf(Math.max(...r)),o=Math.hypot(i[s],t[s])*n,[a,l]=[i[s]/o,-t[s]/o];return[i.map((c,u)=>a*c-l*t[u]),i.map((c,u)=>l*c+a*t[u])]}function wy(i,t){let[e,n]=[i.values.re[t],i.values.im[t]],r=Math.hypot(e,n);return{size:r,rings:n>CS*r?n/(2*Math.PI):null,damping:r?-e/r:0}}function My(i,t,e,n,r){let s=o=>Float64Array.from({length:e},(a,l)=>{let c=0;for(let u=0;u<n;u+=1)c+=r(l,u)*o[u*i.count+t];return c});return{re:s(i.shapes.re),im:s(i.shapes.im)}}function Sy(i,t,e,n){let{count:r,shapes:s}=t,o=g=>p=>{if(!n)return g(p);let x=0;for(let b=0;b<e;b+=1)x+=n[p*e+b]*g(b);return x},a=(g,p)=>{let x=0;for(let b=0;b<e;b+=1)x+=g(b)*p(b);return x},l=hd(i.shapes,e,e),[c,u]=[hd(s.re,e,r),hd(s.im,e,r)],h=l.map(g=>Float64Array.from({length:e},(p,x)=>o(b=>g[b])(x))),f=g=>a(p=>g[p],o(p=>g[p])),[d,m]=[l.map(g=>Math.sqrt(f(g))),c.map((g,p)=>Math.sqrt(f(g)+f(u[p])))],y=new Float64Array(e*r);for(let g=0;g<e;g+=1)for(let p=0;p<r;p+=1){let[x,b]=[c,u].map(v=>a(A=>h[g][A],A=>v[p][A]));y[g*r+p]=Math.hypot(x,b)/(d[g]*m[p])}return y}function hd(i,t,e){return Array.from({length:e},(n,r)=>Float64Array.from({length:t},(s,o)=>i[o*e+r]))}function FS({values:i,count:t}){let e=Array.from({length:t},(n,r)=>Math.hypot(i.re[r],i.im[r]));return{rings:e.map((n,r)=>i.im[r]>1e-9*n),stands:e.map((n,r)=>Math.abs(i.im[r])<=1e-9*n)}}function Ay(i,t,e){let{count:n,values:r}=t,{rings:s,stands:o}=FS(t),a=new Float64Array(n);Array.from({length:n},(c,u)=>u).sort((c,u)=>r.re[u]-r.re[c]).forEach((c,u)=>{a[c]=u});let l=Float64Array.from(i,(c,u)=>{let h=u%n;return!s[h]&&!o[h]?100:a[h]/(10*n)-c*c-(s[h]?10:0)});return NS(l,e,n)}function NS(i,t,e){let[n,r]=[new Float64Array(t+1),new Float64Array(e+1)],s=new Int32Array(e+1);for(let a=1;a<=t;a+=1){let l=new Float64Array(e+1).fill(1/0),c=new Int32Array(e+1),u=new Uint8Array(e+1);s[0]=a;let h=0;for(;s[h];){u[h]=1;let[f,d]=[1/0,0];for(let m=1;m<=e;m+=1){if(u[m])continue;let y=i[(s[h]-1)*e+m-1]-n[s[h]]-r[m];y<l[m]&&(l[m]=y,c[m]=h),l[m]<f&&(f=l[m],d=m)}for(let m=0;m<=e;m+=1)u[m]?(n[s[m]]+=f,r[m]-=f):l[m]-=f;h=d}for(;h;h=c[h])s[h]=s[c[h]]}let o=new Array(t).fill(-1);for(let a=1;a<=e;a+=1)s[a]&&(o[s[a]-1]=a-1);return o}var DS=1e-13,OS=1e-13,US="whole arm, free",kS="whole arm, in its weight and loads";function Ry(i,t,e,{blocks:n,schedule:r,info:s},o){if(!t.modes)return{vibration:t.noModes,facts:{}};try{let{rest:a,linear:l}=Ey(i,t,e,r,sn(t.modes.rest)),c=Object.fromEntries(t.modes.cases.map(({name:y,moving:g})=>[y,Ty(t,n,l,y,g)])),{name:u,moving:h}=t.modes.cases.find(y=>y.name==="controlled"&&y.moving.length)??t.modes.cases.find(y=>y.name==="locked"),f=BS(t,s,r,o),d=f&&Ey(i,t,e,r,f,o.times[o.times.length-1]).linear,m=d?Ty(t,n,d,u,h):[];return by(c,m,a,(y,g)=>yc(i,t,n,y,g).line)}catch(a){return{vibration:a instanceof Error?a.message:String(a),facts:{}}}}function Ey(i,t,e,n,r,s=0){let o=null;return Kf(t,e,"real",r,(a,l)=>(o=z0(i,t,Eo(t.map,a,"real"),n,l,s),o&&o.rest)),o}function BS(i,t,e,n){if(!i.modes.end)return null;let r=sn(i.modes.end).slice(),[s,o]=[n.times[n.times.length-1],n.series.q.data.subarray(-r.length)],a=new Map(t.commanded);for(let l=0;l<r.length;l+=1){let c=a.get(l);i.modes.free.includes(l)||(r[l]=c===void 0?o[l]:So(e,c,s))}return r}function Ty(i,t,e,n,r){let s=Math.sqrt(e.mass.length),o=r.length;if(!o)return[];let a=g=>Float64Array.from({length:o*o},(p,x)=>g[r[Math.floor(x/o)]*s+r[x%o]]),[l,c,u]=[a(e.mass),a(e.damping),a(e.stiffness)],h=n==="controlled";h&&i.modes.servos.forEach(({coordinate:g},p)=>{let x=r.indexOf(g)*(o+1);u[x]+=t.servos[2*p],c[x]+=t.servos[2*p+1]});let f=gy(l,u,o),d=yy(l,c,u,o,f),m=Ay(Sy(f,d,o,l),d,o),y=OS*o*f.squares.reduce((g,p)=>Math.max(g,Math.abs(p)),0);return Array.from({length:o},(g,p)=>{let x=new Float64Array(s);r.forEach((O,B)=>{x[O]=f.shapes[B*o+p]});let b=zS(i,t,e.elastic,x,h),v=My(d,m[p],s,o,(O,B)=>r[B]===O?1:0),A=f.squares[p],S=b.reduce((O,{energy:B})=>O+B,0);if(Math.abs(A)<=y&&S<=y)return{frequency:0,rings:null,damping:0,element:US,...v};let{size:_,rings:w,damping:N}=wy(d,m[p]),C=(h&&w?_:Math.sqrt(Math.max(A,0)))/(2*Math.PI),P=b.reduce((O,B)=>B.energy>O.energy?B:O,b[0]);return{frequency:C,rings:w,damping:Math.abs(N)>DS?N:0,element:S>y&&P?P.element:kS,...v}})}function zS(i,t,e,n,r){let s=n.length,o=u=>{let h=0;for(let f=0;f<s;f+=1)h+=e[u*s+f]*n[f];return h},{springs:a,servos:l}=i.modes,c=a.map(({element:u,rows:h,gear:f})=>{if(!f)return{element:u,energy:h.reduce((m,y)=>m+n[y]*o(y),0)};let d=e[h[0]*(s+1)];return{element:u,energy:d?o(h[0])**2/d:0}});return r?[...c,...l.map(({coordinate:u,element:h},f)=>({element:h,energy:t.servos[2*f]*n[u]**2}))]:c}var Cy=1e-6,VS=1e-11,Py=.5,fd=40,GS=.1,Iy=24;async function Ly(i,t,e,n,r,s,o){let{free:a,gross:l}=t.split;if(!a.length)return{};let c=r.length,u=s.q.shape[1],h=p=>Fr({matrix:l,constant:{data:new Float64Array(u),shape:[u]}},s[p].data,c),f=uc(t,e,n,r,s),d={engine:i,blocks:e,free:a,size:u,places:f.length/c,weight:sn(t.split.weight),q:s.q.data.slice(),rates:h("v"),gains:h("a"),wrenches:f},m=s.deformation.data,y=null;for(let p=0;p<c;p+=Iy){let x=Array.from({length:Math.min(Iy,c-p)},(b,v)=>p+v);if(p&&HS(d,m,Fr(t.deflections,d.q.subarray((p-1)*u,p*u),1),x),y=WS(d,s.q.data,x,y),!y)return{};await o()}let g=Fr(t.deflections,d.q,c);return{deformation_stationary:Ae(g,c,a.length),deformation_oscillatory:Ae(gc(m,g),c,a.length)}}function HS(i,t,e,n){let r=i.free.length;for(let s of n)i.free.forEach((o,a)=>{i.q[s*i.size+o]+=e[a]-t[s*r+a]})}function md(i,t,e){let{engine:n,blocks:r,free:s,size:o}=i,a={q:t,v:$i(i.rates,o,e),a:$i(i.gains,o,e),base:i.weight,wrenches:$i(i.wrenches,i.places,e)},l=mc(n,r,a,e.length),c=n.sample("elastic",r.chain,a,e.length).forces;return Float64Array.from({length:e.length*s.length},(u,h)=>{let f=Math.floor(h/s.length)*o+s[h%s.length];return l[f]+c[f]})}function pd(i,t,e){let{free:n,size:r}=i,s=n.length,o=new Float64Array((s+1)*r);for(let l=0;l<=s;l+=1)o.set(t,l*r);n.forEach((l,c)=>{o[c*r+l]+=Cy});let a=md(i,o,new Array(s+1).fill(e));return N0(Float64Array.from({length:s*s},(l,c)=>(a[c%s*s+Math.floor(c/s)]-a[s*s+Math.floor(c/s)])/Cy),s)}function WS(i,t,e,n){let r=l=>i.q.subarray(l*i.size,(l+1)*i.size),s=l=>pd(i,r(l[l.length>>1]),l[l.length>>1]),o=n??s(e);if(!o)return null;let a=dd(i,e,o,fd);a.length&&(o=s(a)??o),a=dd(i,a,o,fd);for(let l of a){let[c,u]=[fd,[l]];for(;u.length&&c;c-=1){let h=pd(i,r(l),l);u=h?dd(i,u,h,3):u}u.length&&qS(i,t,l)}return o}function dd(i,t,e,n){let{free:r,size:s,q:o}=i,a=r.length,l=[],c=new Map,u=t;for(let h=0;h<n&&u.length;h+=1){let f=md(i,$i(o,s,u),u);u=u.filter((d,m)=>{let y=ri(e,f.subarray(m*a,(m+1)*a),a,a,1),g=y.reduce((b,v)=>Math.max(b,Math.abs(v)),0),p=g>Py?Py/g:1;if(!Number.isFinite(g))return l.push(d)&&!1;if(r.forEach((b,v)=>{o[d*s+b]-=p*y[v]}),g<VS)return!1;let x=g>GS*(c.get(d)??1/0);return c.set(d,g),x?l.push(d)&&!1:!0})}return[...l,...u]}function qS(i,t,e){let n=t.slice(e*i.size,(e+1)*i.size),r=pd(i,n,e);if(i.q.set(n,e*i.size),!r)return;let s=i.free.length,o=ri(r,md(i,n,[e]),s,s,1);i.free.forEach((a,l)=>{i.q[e*i.size+a]-=o[l]})}var XS=50;async function Fy(i,t,e,n,r,s){let o=performance.now(),a=async(h=!1)=>{if(!(!h&&performance.now()-o<XS)){if(await new Promise(f=>setTimeout(f,0)),s.cancelled?.())throw new Is("a newer run began");o=performance.now()}};await a(!0);let{vibration:l,facts:c}=Ry(i,t,e,r,n);await a(!0);let u=await Ly(i,t,r.blocks,r.schedule,n.times,n.series,a);return{...n,vibration:l,facts:{...n.facts,...c},series:{...n.series,...u}}}function Dy(i,t,e,n){let r={...xy(t,e,n),...vy(e,t.length)},s=i.deformations.flatMap((f,d)=>f.endsWith(".gear")?[d]:[]),o=s.filter(f=>i.turning.includes(i.deformations[f].replace(/\.gear$/,""))),a=o.length?o:s;if(a.length){let f=An(e.deformation.data,i.deformations.length,a),d=a.length<s.length?" (of the gears that turn)":"",{value:m,note:y}=Ny(t,f,a.map(g=>i.deformations[g].replace(/\.gear$/,"")));r["gear.max"]={value:m,note:`${y}${d}`}}let{drives:l}=i.layout,c=Fi(0,l.length),u=c.filter(f=>i.turning.includes(l[f]));for(let[f,d]of[["gear_torque",u.length?u:c],["voltage",c]]){if(!e[f])continue;let m=Ny(t,An(e[f].data,l.length,d),d.map(y=>l[y]));m.value&&(r[`${f}.max`]=m)}let h=e.contact_force_normal?.data;if(h){let[f,d]=[h.reduce((m,y)=>Math.min(m,y)),h.reduce((m,y)=>Math.max(m,y))];r["contact.mean"]={value:cd(t,h),note:`from ${vi(f,4)} to ${vi(d,4)} N`}}return r}function Ny(i,t,e){let n=La(t),r=`${e[n%e.length]}, at ${vi(i[Math.floor(n/e.length)])} s`;return{value:Math.abs(t[n]),note:r}}function Oy(i,{strengths:t,places:e,kept:n},r){let s=[i.every>1?`one sample in ${i.every}`:"",n>e.data.length?`${e.data.length} places along each link`:""],o=s.some(Boolean)?` (looked at: ${s.filter(Boolean).join(", ")})`:"",a=f=>i.links.flatMap(({largest:d})=>d[f]??[]),l=(f,d)=>{let m=gd(d,({value:g})=>g),y=m&&f!=="deflection.max"?` at s = ${vi(m.s,2)}`:"";return m?{[f]:{value:m.value,note:`${m.link}${y}, at ${vi(r[m.sample])} s${o}`}}:{}},c=gd(a("stress").filter(({link:f})=>f in t),({link:f,value:d})=>d/t[f]),u=c?t[c.link]:1,h=c&&`of ${$n(u,"Pa")}, ${c.link}; margin ${vi(100*(1-c.value/u))} %${o}`;return{...l("deflection.max",a("deflection")),...l("moment.max",a("moment")),...l("stress.max",a("stress")),...c&&h?{"stress.share":{value:100*c.value/u,note:h}}:{}}}function Uy(i,t){let e=gd(i.flatMap(n=>$S(n,t)),({share:n})=>n);return e?{"limits.share":{value:100*e.share,note:e.note}}:{}}function $S({joint:i,coordinate:t,drive:e,unit:n,effortUnit:r,speed:s,effort:o,range:a},l){let c=(h,f,d=0)=>An(l[h].data,l[h].shape[1],[f]).reduce((m,y)=>Math.max(m,Math.abs(y-d)),0),u=(h,f,d,m)=>({share:h/f,note:`${d} of ${i}: ${$n(h,m)} of ${$n(f,m)}`});return[...s?[u(c("v",t),s,"speed",`${n}/s`)]:[],...o&&e>=0?[u(c("effort",e),o,"effort",r)]:[],...a?[{share:c("q",t,a[0])/a[1],note:`range of ${i}, from its middle`}]:[]]}function gd(i,t){return i.reduce((e,n)=>e===null||t(n)>t(e)?n:e,null)}var wc=["y","z"],YS=[{id:"deflection",of:"deflection",label:"Deflection",unit:"m",planes:wc},{id:"slope",of:"slope",label:"Slope",unit:"rad",planes:wc},{id:"moment",of:"moment",label:"Moment",unit:"N m",planes:["torsion",...wc]},{id:"shear_force",of:"shear",label:"Shear force",unit:"N",planes:wc}];function ky(i,t,e){if(!t.length)return null;let n=i.stations.data,[r,s]=[t.length,n.length],o=Float64Array.from({length:r*s},(a,l)=>t[Math.floor(l/s)].length*n[l%s]);return{links:t.map(a=>a.name),places:{data:o,shape:[r,s]},quantities:YS.map(({id:a,of:l,label:c,unit:u,planes:h})=>{let f=new Float64Array(e*r*s*h.length);return t.forEach((d,m)=>zy(d[l],f,e,m,r,s*h.length)),{id:a,label:c,unit:u,planes:[...h],values:{data:f,shape:[e,r,s,h.length]}}})}}function By(i,t,e){let[n,r]=[i.links.length,i.stations.data.length],s=(l,c,u,h)=>{let f=new Float64Array(e*n*r);return i.links.forEach((d,m)=>{let y=d.bends?t.find(p=>p.name===d.name):void 0,g=y&&h(y);g&&zy(g,f,e,m,n,r)}),{id:l,label:c,unit:u,values:{data:f,shape:[e,n,r]}}};if(!t.length)return[];let a=[s("bending_moment","Bending moment","N m",({moment:l})=>Float64Array.from({length:e*r},(c,u)=>Math.sqrt(l[3*u+1]**2+l[3*u+2]**2))),s("torsion","Torsional moment","N m",({moment:l})=>Float64Array.from({length:e*r},(c,u)=>Math.abs(l[3*u]))),s("deflection","Deflection from the root's tangent","m",({deflection:l})=>To(l,2))];return t.some(l=>l.stress)?[...a,s("stress","Largest stress (von Mises)","Pa",({stress:l})=>l&&l.mises),s("strain","Largest strain","1",({stress:l})=>l&&l.strain)]:a}function zy(i,t,e,n,r,s){for(let o=0;o<e;o+=1)t.set(i.subarray(o*s,(o+1)*s),(o*r+n)*s)}var jS=100;function ZS(i,t,e,n,r){let s=new Float64Array(1),o={time:s,row:cc(n,s),step:new Float64Array(1)};for(let a=0;`${t}.switched`in i.layout.samples&&a<jS;a+=1){let l=r;if(r=i.sample(`${t}.switched`,e.parameters,{...o,state:r},1).state,r.every((c,u)=>c===l[u]))break}return r}async function Vy(i,t,e,n,r,s){let{settings:o}=t,a=t.runs[n],l=Fi(0,a.signals).map(h=>Wf(r[`knots.${h}`],r[`coefficients.${h}`])),c=R0(l.map(h=>qf(h,o.duration)));l.length||(c.knots[1]=o.duration);let u=await M0(i,{loop:`${n}.${o.method}`,parameters:r.parameters,knots:c.knots,rows:E0(c),state:ZS(i,n,r,c,B0(i,t,e,n,c)),times:sn(t.times),settings:o},s);return{name:n,info:a,blocks:r,each:l,schedule:c,run:u}}var Yi=24;function Gy(i,t,e,n){let r=e.run.times.subarray(0,n),s=e.run.states.subarray(0,n*(e.run.states.length/e.run.times.length)),o=cc(e.schedule,r),a={time:r,state:s,row:o,step:new Float64Array(1)},l=i.sample(`${e.name}.observe`,e.blocks.parameters,a,n),{q:c,v:u,a:h}=l,f=sn(t.base),{chain:d,rotors:m}=e.blocks,{points:y}=i.sample("inertia",d,{q:c,v:u,a:h,base:f},n),g=new Float64Array(m.length),p=i.sample("inertia",d,{q:c,v:g,a:u,base:f},n),x=i.sample("elastic",d,{q:c,v:u,base:f},n).energies;return{model:l,points:y,energy:JS(t,u,m,p,x,n)}}function JS(i,t,e,n,r,s){let o=e.length,a=r.length/s,l=new Float64Array(4*s);for(let c=0;c<s;c+=1){for(let u=0;u<o;u+=1){let h=t[c*o+u];l[4*c]+=(n.forces[c*o+u]+e[u]*h)*h/2}for(let u=0;u<3;u+=1)l[4*c+1]-=n.moment[3*c+u]*i.gravity.data[u];for(let u=0;u<a;u+=1)l[4*c+2+u%2]+=r[c*a+u]}return l}function Hy(i,t,{model:e,points:n,energy:r},s){let o=e.q.length/s,a=e.gear.length/s,l=n.length/s/Yi,c=t.run.states.length/t.run.times.length,u=An(t.run.states.subarray(0,s*c),c,Fi(...t.info.state.works)),h=p=>Ae(An(e.drives,4*a,Fi(0,a).map(x=>4*x+p)),s,a),f=p=>An(n,l*Yi,Fi(0,l).flatMap(x=>Fi(0,3).map(b=>x*Yi+p+b))),d=An(n,l*Yi,Fi(0,l).flatMap(p=>Fi(p*Yi,p*Yi+9))),m={q:Ae(e.q,s,o),v:Ae(e.v,s,o),a:Ae(e.a,s,o),deformation:Ae(Fr(i.deflections,e.q,s),s,i.deformations.length),position:Ae(f(9),s,l,3),velocity:Ae(f(12),s,l,3),acceleration:Ae(f(18),s,l,3),rotation:Ae(d,s,l,3,3),tip:Ae(An(n,l*Yi,[9,10,11]),s,3),tip_velocity:Ae(An(n,l*Yi,[12,13,14]),s,3),energy:Ae(r,s,4),work:Ae(u,s,u.length/s),energy_balance:Ae(V0(r,u,s,3),s)};a&&Object.assign(m,{wanted:h(3),effort:h(0),gear_torque:Ae(e.gear,s,a)}),a&&i.electric&&Object.assign(m,{voltage:h(1),current:h(2)});let y=Fi(...t.info.state.controls);if(y.length){let p=An(t.run.states.subarray(0,s*c),c,y);m.controller_states=Ae(p,s,y.length)}if(i.contactPoint<0)return m;let g=p=>An(e.contact,6,p);return{...m,contact_force:Ae(g([0,1,2]),s,3),contact_force_normal:Ae(g([3]),s),penetration:Ae(g([4]),s)}}function Wy(i,t,{blocks:e},n,r,s){let o=r.model.q.length/s,a=r.points.length/s/Yi,[l,c]=[n,r].map(({points:h})=>An(h,a*Yi,[9,10,11])),u={q_nominal:Ae(r.model.q,s,o),v_nominal:Ae(r.model.v,s,o),deformation_nominal:Ae(Fr(t.deflections,r.model.q,s),s,t.deformations.length),gear_torque_nominal:Ae(r.model.gear,s,r.model.gear.length/s),tip_nominal:Ae(c,s,3),deviation:Ae(To(gc(l,c),3),s)};if(t.commanded){let h=Fr(t.straight,r.model.q,s),[f,d]=[new Float64Array(o),sn(t.base)],{points:m}=i.sample("inertia",e.chain,{q:h,v:f,a:f,base:d},s);u.tip_commanded=Ae(An(m,a*Yi,[9,10,11]),s,3)}return t.contactPoint>=0&&(u.contact_force_normal_nominal=Ae(An(r.model.contact,6,[3]),s)),u}var qy=32,KS=1e-6;function Xy(i,t){let{wanted:e}=t;return e?i.setpoints.map(n=>An(e.data,e.shape[1],[n])):[]}function $y(i,t,e){let n=i.length-(QS(i)?1:0),r=i[i.length-1],s=t===null?-1:i.findIndex(l=>l>=t*(1+1e-9));if(s>=0&&n-s>=qy)return[i[s],r];let[o,a]=e1(t1(n,e));return a-o>=qy?[i[o],i[a-1]]:[i[0],r]}function QS(i){let t=i.length;return t>2&&Math.abs((i[t-1]-i[t-2])/(i[1]-i[0])-1)>1e-6}function t1(i,t){let e=new Array(Math.max(i,0)).fill(!1);if(i<3||!t.length)return e;let n=new Float64Array(i);for(let s of t)for(let o=1;o<i-1;o+=1)n[o]=Math.max(n[o],Math.abs(s[o+1]-2*s[o]+s[o-1]));let r=KS*Math.max(Number.MIN_VALUE,n.reduce((s,o)=>Math.max(s,o),0));for(let s=1;s<i-1;s+=1)e[s]=n[s]<=r;return e}function e1(i){let[t,e]=[[0,0],-1];for(let n=0;n<=i.length;n+=1)n<i.length&&i[n]?e=e<0?n:e:e>=0&&(n-e>t[1]-t[0]&&(t=[e,n]),e=-1);return t}async function Yy(i,t,e,n,r,s=()=>{}){let o=performance.now(),a=t.runs.reference?["reference","real"]:["real"],l=[];for(let[_,w]of a.entries()){let N={...n,progress:O=>n.progress?.((_+O)/a.length)},C=Eo(t.map,e,w),P=()=>Vy(i,t,e,w,C,N);l.push(await(w==="reference"?r.of(C,P):P()))}let c=l[l.length-1];s(c);let u=(performance.now()-o)/1e3,h=Math.min(...l.map(_=>_.run.times.length)),[f,d]=[c,...l.slice(0,-1)].map(_=>Gy(i,t,_,h)),m=c.run.times.subarray(0,h),y=d?Wy(i,t,l[0],f,d,h):{},g={...Hy(t,c,f,h),...y},p=O0(t,h),x=C0(c.info.moving.map(_=>c.each[_])),b=l.find(_=>_.run.status!=="finished"),v=G0(i,t,c.blocks,g,m,c.schedule,p),A={...Dy(t,m,g,x),...Oy(v,t.carried,m),...Uy(t.carried.limits,g)},S=By(t,v.links,p.length);return{status:b?b.run.status:"finished",message:b?`${b===c?"actual robot":"nominal run"}: ${b.run.message}`:c.run.message,seconds:u,times:m,series:g,scene:H0(i,t,c.blocks,g,m,p,S),line:ky(t,v.links,p.length),span:$y(m,x,Xy(t,g)),facts:b?_y(A):A}}async function jy(i){let t=await oc.open(i.module.data,i.layout),e=new lc;return{async run(n,r,s=()=>{}){let o=null,a=await Yy(t,i,n,r,e,l=>{o=l});return s(a,[a.times,a.series,o]),Fy(t,i,n,a,o,r)}}}function Zy(i,t){let e=i.map(r=>typeof r=="object"&&"parts"in r&&n1(r.optional,t)),n=i.some((r,s)=>e[s]&&typeof r=="object"&&"optional"in r&&r.optional>=0);return i.map((r,s)=>typeof r=="string"?r:"header"in r?n?r.header:"":e[s]?r.parts.map(o=>typeof o=="string"?o:i1(o,t)).join(""):"").join("")}function n1(i,t){return i<0||t[i]!==1}function i1(i,t){let e=t[i.slider];return r1(i.base===null?e:i.base*e)}function r1(i){let[t,e]=String(i).split("e"),n=t.includes(".")?t:`${t}.0`;return e===void 0?n:`${n}e${e}`}var Ro=class extends Error{name="Superseded"};async function Jy(i){let t=i,e=await o1(t)??await s1(t),n=r=>{if(r.length!==t.sliders.length||!r.every(Number.isFinite))throw new Error(`values: got ${r.length}; expected ${t.sliders.length} finite numbers, one of each slider`)};return{sliders:t.sliders,async run(r,s=()=>{},o=()=>{}){return n(r),e.run(r,s,o)},sheet(r){return n(r),Zy(t.sheet,r)},close:()=>e.close()}}async function s1(i){let t=await jy(i),e=0,n=Promise.resolve();return{async run(r,s,o){let a=e+=1,l=()=>a!==e,c=n.then(()=>{if(l())throw new Ro("a newer run began");return t.run(r,{cancelled:l,progress:s},o)});n=c.catch(()=>{});try{return await c}catch(u){throw u instanceof Is?new Ro(u.message):u}},close:()=>e+=1}}async function o1(i){if(typeof Worker>"u"||typeof document>"u")return null;let t=URL.createObjectURL(new Blob([b0],{type:"text/javascript"}));try{let e=new Worker(t);if(await a1(e,i))return l1(e);e.terminate()}catch{}finally{URL.revokeObjectURL(t)}return null}function a1(i,t){return new Promise(e=>{i.onmessage=({data:n})=>e(n.kind==="ready"),i.onerror=()=>e(!1),i.postMessage({kind:"open",bundle:t})})}function l1(i){let t=0,e=null,n=null,r=s=>{n?.reject(s),n=null};return i.onerror=s=>r(new Error(s.message)),i.onmessage=({data:s})=>{!("id"in s)||s.id!==t||!n||(s.kind==="progress"?n.progress(s.share):s.kind==="early"?n.early(e=s.run):s.kind==="error"?r(new Error(s.message)):s.kind==="done"&&(n.resolve(S0(e,s.run)),n=null))},{run(s,o,a){return r(new Ro("a newer run began")),t+=1,e=null,i.postMessage({kind:"run",id:t,values:s}),new Promise((l,c)=>n={resolve:l,reject:c,progress:o,early:a})},close(){r(new Ro("the live model was closed")),i.terminate()}}}function Co(i){return i!==null&&i.vibration===void 0}function Mc(i){let t=0;return{begin(){t||=window.setTimeout(i,300)},end(){clearTimeout(t),t=0}}}function Ky(i,t){let e=[];i.append(t.runs.length>1?h1(t,e):c1(t.runs[0].facts,e));let n=null,r=Mc(()=>e.forEach(o=>o(n,!0))),s=o=>{n=o,Co(o)?r.begin():r.end(),e.forEach(a=>a(o,!1))};return s(null),{show:s}}function c1(i,t){return lt("dl",{class:"facts"},...i.map(e=>{let n=lt("strong"),r=lt("span",{class:"was"}),s=lt("dd",{class:"note"}),o=!1;return t.push((a,l)=>{let c=a?.facts[e.id];if(!c&&Co(a)){l&&wn(r,o?"of the setting before":"of the original run"),l&&(r.hidden=!1);return}o=c!==void 0;let u=c?`${u1(e,c.value)} was ${$n(e.value,e.unit)}`:"of the original run";wn(n,$n(c?c.value:e.value,e.unit)),wn(r,a?u:""),wn(s,(c?c.note:e.note)||""),r.hidden=a===null||c!==void 0&&c.value===null&&e.value===null,s.hidden=s.textContent===""}),lt("div",{"data-fact":e.id},lt("dt",{text:e.name}),lt("dd",{},n,r),s)}))}function u1(i,t){if(t===null||i.value===null||i.value===0)return"";let e=100*(t-i.value)/Math.abs(i.value);if(Math.abs(e)<.05)return"";let n=Math.abs(e)>=1e3?"1000 % and more":`${Number(Math.abs(e).toPrecision(2))} %`;return`${e>0?"+":"−"}${n},`}function h1(i,t){let e=new Map;for(let o of i.runs.flatMap(a=>a.facts))e.has(o.id)||e.set(o.id,o);let n=lt("tr",{},lt("td",{}),...i.runs.map(o=>lt("th",{scope:"col",text:o.name}))),r=[...e.values()].map(o=>lt("tr",{"data-fact":o.id},lt("th",{scope:"row",text:o.name}),...i.runs.map((a,l)=>{let c=lt("td",{class:"number"}),u=a.facts.find(h=>h.id===o.id);return t.push(h=>{let f=l===0?h?.facts[o.id]:void 0;l===0&&!f&&Co(h)||(wn(c,$n(f?f.value:u?.value??null,u?.unit??o.unit)),c.title=(f??u)?.note??"")}),c}))),s=lt("table",{},lt("thead",{},n),lt("tbody",{},...r));return lt("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Numbers of the runs"},s)}var tx=150,Qy="12px system-ui, sans-serif";function ex(i,t,e){let n=t.runs[0].line,r=t.runs[0].scene.times.data,s=[],o=!1,a=!1,l="",c=lt("div",{class:"line-grid"}),u=lt("p",{class:"note"});i.append(u,c);function h(){a=!1;let b=n===null?"":f1(n);b===l?s.forEach((v,A)=>v.take(n.quantities[A])):f(),l=b,d()}function f(){s.forEach(({plot:b})=>b.destroy()),c.replaceChildren(),s=n===null?[]:n.quantities.map(b=>m1(c,n,b))}function d(){if(n===null||a||!o)return;let b=p1(r,e.time);u.textContent=`${n.links.join(", ")}: along the links from root to tip, at ${$e(r[b],4)} s. The scales are those of the whole run.`;let v=nx(n);for(let{plot:A,quantity:S,factor:_}of s){let w=S.planes.map((N,C)=>d1(n,S.values,b,C,S.planes.length,_));A.setData([v,...w])}}let m=matchMedia("(prefers-color-scheme: dark)"),y=()=>s.forEach(({plot:b})=>b.redraw());m.addEventListener("change",y);let g=new ResizeObserver(()=>s.forEach(({plot:b})=>{let v=b.root.parentElement?.clientWidth??0;v>0&&v!==b.width&&b.setSize({width:v,height:tx})}));g.observe(c);let p=new IntersectionObserver(b=>{o=b.some(v=>v.isIntersecting),o&&a?h():d()});p.observe(i);let x=e.subscribe(d);return h(),{show(b){n=b?b.line:t.runs[0].line,r=b?b.scene.times.data:t.runs[0].scene.times.data,a=!0,o&&h()},dispose(){x(),g.disconnect(),p.disconnect(),m.removeEventListener("change",y),s.forEach(({plot:b})=>b.destroy()),i.replaceChildren()}}}function f1(i){let{links:t,places:e,quantities:n}=i;return JSON.stringify([t,Array.from(e.data),n.map(({id:r,label:s,unit:o,planes:a})=>[r,s,o,a])])}function nx(i){let t=i.places.shape[1],e=[],n=0;for(let r=0;r<i.links.length;r+=1){for(let s=0;s<t;s+=1)e.push(n+i.places.data[r*t+s]+(s===0&&r>0?1e-9:0));n=e[e.length-1]}return e}function d1(i,t,e,n,r,s){let o=i.links.length*i.places.shape[1],a=e*o*r;return Array.from({length:o},(l,c)=>s*t.data[a+c*r+n])}function p1(i,t){let e=0,n=i.length-1;for(;n-e>1;){let r=e+n>>1;i[r]<=t?e=r:n=r}return Math.abs(i[n]-t)<Math.abs(i[e]-t)?n:e}function m1(i,t,e){let n=[0,1],r=e.planes.map((g,p)=>wa("real",p,!0,1)),s=lt("div",{class:"plot-area",role:"img"}),o=lt("span",{class:"unit"}),a=lt("div",{class:"legend"},...e.planes.map((g,p)=>lt("span",{class:"key"},zl(`var(${r[p].property})`,r[p].dash),lt("span",{text:g})))),l=lt("h4",{text:e.label},o);i.append(lt("figure",{class:"chart"},lt("figcaption",{},l,a),s));let c={stroke:()=>Ci("--grid"),width:1},u={stroke:()=>Ci("--quiet"),font:Qy,grid:c,ticks:{...c,size:4}},h=nx(t),f=t.links.slice(1).map((g,p)=>h[(p+1)*t.places.shape[1]]),m={plot:new yn({width:Math.max(s.clientWidth,120),height:tx,legend:{show:!1},padding:[8,14,0,0],cursor:{show:!1},scales:{x:{time:!1},y:{range:()=>n}},axes:[{...u,label:"along the links [m]",labelSize:18,labelFont:Qy,size:30,values:(g,p)=>p.map(ni)},{...u,size:(g,p)=>16+7*Math.max(2,...(p??[]).map(x=>x.length)),values:(g,p)=>p.map(ni)}],series:[{},...r.map(g=>({stroke:()=>Ci(g.property),dash:g.dash,width:1.6,points:{show:!1}}))],hooks:{draw:[g=>g1(g,f)]}},[h,...r.map(()=>h.map(()=>0))],s),quantity:e,factor:1,take:y};function y(g){let[p,x]=[0,0];for(let A of g.values.data)A<p&&(p=A),A>x&&(x=A);let b=ba(g.unit,Math.max(-p,x)),v=.06*(x-p)||1;n=[(p-v)*b.factor,(x+v)*b.factor],[m.quantity,m.factor]=[g,b.factor],wn(o,` [${b.name||"–"}]`),s.setAttribute("aria-label",`${g.label} along the links, between ${ni(p*b.factor)} and ${ni(x*b.factor)} ${b.name}`)}return y(e),m}function g1(i,t){let{ctx:e,bbox:n}=i;e.save(),e.strokeStyle=Ci("--quiet"),e.setLineDash([3,3]);for(let r of t){let s=i.valToPos(r,"x",!0);e.beginPath(),e.moveTo(s,n.top),e.lineTo(s,n.top+n.height),e.stroke()}e.restore()}function rx(i){let t=["Frequency [Hz]","Damping [%]","Dominant element",""].map(a=>lt(a?"th":"td",a?{scope:"col",text:a}:{})),e=lt("tbody"),n=lt("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Modes"},lt("table",{},lt("thead",{},lt("tr",{},...t)),e)),r=[],s=a=>(r[Math.min(a,r.length-1)]?.button??n).focus();function o(a){for(;r.length<a;){let u=y1(i);r.push(u),e.append(u.element)}let l=r.splice(a),c=l.some(u=>u.button===document.activeElement);for(let u of l)u.element.remove();c&&s(a)}return{element:n,tell(a,l,c){o(a.length),a.forEach((u,h)=>r[h].tell(u,l&&l[h],u===c))},focus:s}}function y1(i){let t=null,[e,n,r]=[ix(),ix(),lt("td")],s=bn("",()=>t&&i(t));return{element:lt("tr",{},e.element,n.element,r,lt("td",{},s)),button:s,tell(o,a,l){t=o;let c=f=>a===null?"":a?f(a):"–",u=f=>$e(100*f.damping,3);e.tell($e(o.frequency),c(f=>$e(f.frequency))),n.tell(u(o),c(u)),wn(r,o.element),wn(s,l?"stop":"show"),s.setAttribute("aria-pressed",String(l));let h=l?"Stop showing the mode":`Show the mode of ${$e(o.frequency)} Hz in 3D`;s.setAttribute("aria-label",h)}}}function ix(){let[i,t]=[lt("span"),lt("span",{class:"was",hidden:!0})];return{element:lt("td",{class:"number"},i,t),tell(e,n){wn(i,e),t.hidden=!n||n===e,wn(t,t.hidden?"":`was ${n}`)}}}var x1={controlled:"under control",locked:"motors held",free:"motors free"},_1=.12;function yd(i,t,e,n){let r=t.runs[0].modes,s=[...new Set(r.map(w=>w.case))],o=r,a=null,l=_1,c=rx(w=>g(w===a?null:w)),u=Pr("case"),h=lt("select",{id:u},...s.map(w=>lt("option",{value:w,text:x1[w]??w})));h.addEventListener("change",()=>v(h.value));let f=lt("input",{type:"range",min:"0.02",max:"0.3",step:"0.01",value:String(l),id:Pr("size")});f.addEventListener("input",()=>{l=Number(f.value),a&&e.showMode(a,l)});let d=bn("back to the motion",()=>{let w=b(a);g(null),c.focus(w)},{hidden:!0}),m=lt("p",{class:"note",hidden:!0,role:"status"}),y=Mc(()=>{A(`These are the modes of the ${o===r?"run as it was":"setting before"}; the new ones are being found.`)});function g(w){w&&n.pause(),p(w)}function p(w){a=w,e.showMode(w,l),d.hidden=w===null,v(h.value)}let x=(w,N)=>w.filter(C=>C.case===N),b=w=>w?x(o,w.case).indexOf(w):-1;function v(w){c.tell(x(o,w),o===r?null:x(r,w),a)}function A(w){wn(m,w),m.hidden=!w}let S=lt("div",{class:"bar"},lt("label",{for:u,text:"Modes"}),h,lt("label",{for:f.id,text:"amplitude"}),f,d);i.append(S,m,c.element),v(s[0]??"");let _=n.subscribe(w=>{w.playing&&a&&g(null)});return{show(w){if(Co(w))return y.begin();y.end();let N=w?.vibration,C=b(a);o=typeof N=="object"?N.modes:r,A(N===void 0?"":v1(N));let P=a&&(x(o,a.case)[C]??null);a&&P!==a?p(P):v(h.value)},dispose(){_(),y.end(),i.replaceChildren()}}}function v1(i){return typeof i=="string"?`These are the modes of the run as it was: ${i}.`:"About the rest with the changed numbers; under each number what it was."}function sx(i,t){for(let e of t.runs){if(!e.sheet)continue;let n=t.runs.length>1?`Save the YAML of ${e.name}`:"Save the YAML of this run";i.append(bn(n,()=>uo(e.sheet,`${xd(e.name)}.yaml`,"application/yaml"),{class:"save-yaml"}))}}function xd(i){return i.replace(/[^\p{L}\p{N}._-]+/gu,"_").replace(/^[._]+/,"").slice(0,80)||"run"}var _d=1e3;function ox(i,t){let e=Pr("slider"),n=rf(i.unit),r=lt("input",{type:"range",id:e,min:"0",max:String(_d),step:"1"}),s=lt("input",{type:"number","aria-label":`${i.label}${n?`, in ${n}`:""}`,step:"any",min:String(i.min),max:String(i.max)}),o=bn("↺",u,{class:"tool","aria-label":`${i.label}: back to ${$e(i.value,6)} ${n}`,title:"back to the run's own"}),a=i.value;function l(d=!1){r.value=String(Math.round(_d*b1(i,a))),r.setAttribute("aria-valuetext",`${$e(a,5)} ${n}`),d||(s.value=String(Number(a.toPrecision(6)))),o.disabled=a===i.value,f.classList.toggle("changed",a!==i.value)}function c(d,m=!1){let y=Math.min(Math.max(d,i.min),i.max);if(y===a)return l(m);a=y,l(m),t()}function u(){c(i.value),r.focus()}r.addEventListener("input",()=>c(Number($e(w1(i,Number(r.value)/_d),4)))),s.addEventListener("input",()=>{s.value!==""&&Number.isFinite(s.valueAsNumber)&&c(s.valueAsNumber,!0)}),s.addEventListener("change",()=>l());let h=lt("label",{for:e},lt("span",{text:i.label}),lt("i",{text:i.symbol?` ${i.symbol}`:""})),f=lt("div",{class:"slider","data-path":i.path},h,lt("div",{class:"slider-row"},r,s,lt("span",{class:"unit",text:n}),o),lt("code",{class:"path",text:i.path,title:"--set PATH=VALUE"}));return l(),{element:f,slider:i,get value(){return a},set value(d){a=d,l()}}}function b1(i,t){let{min:e,max:n}=i;return n<=e?0:i.log&&e>0?Math.log(t/e)/Math.log(n/e):(t-e)/(n-e)}function w1(i,t){let{min:e,max:n}=i;return i.log&&e>0?e*(n/e)**t:e+t*(n-e)}var ax=300;function lx(i,t,e){let n=lt("p",{class:"note",role:"status","aria-live":"polite",text:"starts …"}),r=lt("progress",{max:"1",value:"0",hidden:!0,"aria-label":"Progress of the simulation"}),s=bn("reset all",()=>{v(null),a[0]?.element.querySelector("input")?.focus()},{disabled:!0}),o=bn("Save YAML",()=>l&&uo(l.sheet(g()),`${e.fileName}.yaml`,"application/yaml"),{disabled:!0}),a=t.sliders.map(w=>ox(w,x)),l=null,c=!1,u=0,h=0,f=0,d=!1,m=0,y=!1,g=()=>a.map(w=>w.value),p=()=>a.every(w=>w.value===w.slider.value);function x(){s.disabled=p(),!d||p()?A():h||(h=requestAnimationFrame(b))}function b(){d&&!y&&performance.now()-m<ax?h=requestAnimationFrame(b):A()}function v(w){a.forEach((N,C)=>{N.value=w?w[C]:N.slider.value}),x()}async function A(){if(cancelAnimationFrame(h),h=0,!l)return;let w=u+=1;if(p()){_(),e.show(null),n.textContent="The run as it was.",n.classList.remove("warned"),l.run(g()).catch(()=>{});return}[d,m,y]=[!0,performance.now(),!1],f||(f=window.setTimeout(()=>{r.hidden=!1},ax));try{let N=C=>{w===u&&(r.value=C)};S(await l.run(g(),N,C=>S(C,w)),w)&&_()}catch(N){if(w!==u||c||N instanceof Error&&N.name==="Superseded")return;_(),e.show(null);let C=(N instanceof Error?N.message:String(N)).replace(/\.$/,"");n.textContent=`This could not be simulated: ${C}; shown is the run as it was.`,n.classList.add("warned")}}function S(w,N){if(N!==u||c)return!1;y=!0,e.show(w);let C=w.status==="finished"?"Simulated":`${w.status}: ${w.message}; simulated`;return n.textContent=`${C} in ${$n(w.seconds,"s")}; the run as it was is pale.`,n.classList.toggle("warned",w.status!=="finished"),!0}function _(){d=!1,clearTimeout(f),f=0,r.hidden=!0,r.value=0}return i.append(lt("div",{class:"bar"},lt("h3",{text:"What if"}),s,o),n,r,...M1(a),...S1(t)),e.open(t).then(w=>{if(c)return w.close();l=w,o.disabled=!1,n.textContent="Move a slider to run the simulation again in this page.",p()||x()},w=>{let N=w instanceof Error?w.message:String(w);n.textContent=`Nothing can be changed here, the robot's equations could not be started: ${N}`,a.forEach(C=>C.element.remove()),s.remove()}),{dispose(){c=!0,cancelAnimationFrame(h),_(),l?.close(),i.replaceChildren()}}}function M1(i){return[...new Set(i.map(e=>e.slider.group))].map(e=>lt("fieldset",{},lt("legend",{text:e}),...i.filter(n=>n.slider.group===e).map(n=>n.element)))}function S1(i){let t=i.settings,e=Array.isArray(i.leftOut)?i.leftOut:[];return[...typeof t?.note=="string"&&t.note?[t.note]:[],...e.length?[`Not offered: ${e.map(({path:r,reason:s})=>`${String(r)} (${String(s)})`).join("; ")}.`]:[]].map(r=>lt("p",{class:"note",text:r}))}var A1=[.05,.1,.2,.5,1,2],Sc=1e3,cx=1/200;function ux(i,t){let e=bn("",()=>t.toggle(),{class:"play"}),n=lt("input",{type:"range",min:"0",max:String(Sc),step:"1","aria-label":"Time",class:"scrub"}),[r,s]=[lt("span"),lt("span")],o=lt("output",{class:"time","aria-live":"off"},r,document.createTextNode(" "),s),a=Pr("speed"),l=lt("select",{id:a},...A1.map(d=>lt("option",{value:String(d),text:`${d}×`,selected:d===t.speed})));n.addEventListener("input",()=>t.seek(Number(n.value)/Sc*t.duration)),l.addEventListener("change",()=>{t.speed=Number(l.value)});let c=Math.max(3,Math.ceil(-Math.log10(t.duration||1))+3),u=()=>{let d=t.duration>0?t.time/t.duration:0;(document.activeElement!==n||Number(n.value)!==Math.round(d*Sc))&&(n.value=String(Math.round(d*Sc))),n.setAttribute("aria-valuetext",`${t.time.toFixed(c)} s`),r.textContent=`${t.time.toFixed(c)} s`,s.textContent=`of ${$e(t.duration)} s`;let m=t.playing?"Pause":"Play";e.getAttribute("aria-label")!==m&&(e.setAttribute("aria-label",m),e.title=`${m} (space)`,e.textContent=t.playing?"❚❚":"▶")},h=d=>{if(d.defaultPrevented||d.ctrlKey||d.metaKey||d.altKey||E1(d))return;let y={" ":()=>t.toggle(),ArrowRight:()=>t.seek(t.time+(d.shiftKey?10:1)*cx*t.duration),ArrowLeft:()=>t.seek(t.time-(d.shiftKey?10:1)*cx*t.duration)}[d.key];y&&(d.preventDefault(),y())};document.addEventListener("keydown",h),i.append(e,n,o,lt("label",{for:a,text:"speed"}),l);let f=t.subscribe(u);return u(),{dispose(){f(),document.removeEventListener("keydown",h),i.replaceChildren()}}}function E1(i){let t=i.target;return t instanceof HTMLElement?t.isContentEditable||t.closest("input, select, textarea, canvas, [role=tablist]")?!0:i.key===" "?t.closest("button, a, summary")!==null:t.closest(".scroll")!==null:!1}var ms={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},gs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Gx=0,jd=1,Hx=2;var Hs=1,Wx=2,ia=3,ys=0,ai=1,zi=2,Ws=0,ra=1,Zd=2,Jd=3,Kd=4,qx=5;var qs=100,Xx=101,$x=102,Yx=103,jx=104,Zx=200,Jx=201,Kx=202,Qx=203,Qd=204,tp=205,t_=206,e_=207,n_=208,i_=209,r_=210,s_=211,o_=212,a_=213,l_=214,Zc=0,Jc=1,Kc=2,Xo=3,Qc=4,tu=5,eu=6,nu=7,Cu=0,c_=1,u_=2,xr=0,ep=1,np=2,ip=3,rp=4,sp=5,op=6,ap=7;var lp=300,Xs=301,sa=302,Pu=303,Iu=304,iu=1e3,mr=1001,ru=1002,Un=1003,h_=1004;var yl=1005;var oi=1006,Lu=1007;var Gr=1008;var ui=1009,cp=1010,up=1011,oa=1012,Fu=1013,er=1014,nr=1015,ir=1016,Nu=1017,Du=1018,$s=1020,hp=35902,fp=35899,dp=1021,pp=1022,rr=1023,zr=1026,Hr=1027,mp=1028,Ou=1029,xs=1030,Uu=1031;var ku=1033,xl=33776,_l=33777,vl=33778,bl=33779,Bu=35840,zu=35841,Vu=35842,Gu=35843,Hu=36196,Wu=37492,qu=37496,Xu=37488,$u=37489,wl=37490,Yu=37491,ju=37808,Zu=37809,Ju=37810,Ku=37811,Qu=37812,th=37813,eh=37814,nh=37815,ih=37816,rh=37817,sh=37818,oh=37819,ah=37820,lh=37821,ch=36492,uh=36494,hh=36495,fh=36283,dh=36284,Ml=36285,ph=36286;var Ha=2300,su=2301,Yc=2302,Gd=2303,Hd=2400,Wd=2401,qd=2402;var f_=3200;var Sl=0,d_=1,Wr="",Mi="srgb",Wa="srgb-linear",qa="linear",Re="srgb";var jc=7680;var p_=519,m_=512,g_=513,y_=514,gp=515,x_=516,__=517,yp=518,xp=519,_p=35044,vp=35048;var bp="300 es",Ui=2e3,$o=2001;function T1(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function R1(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Xa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function v_(){let i=Xa("canvas");return i.style.display="block",i}var hx={},Yo=null;function $a(...i){let t="THREE."+i.shift();Yo?Yo("log",t,...i):console.log(t,...i)}function b_(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Zt(...i){i=b_(i);let t="THREE."+i.shift();if(Yo)Yo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function re(...i){i=b_(i);let t="THREE."+i.shift();if(Yo)Yo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function za(...i){let t=i.join(" ");t in hx||(hx[t]=!0,Zt(...i))}function w_(i,t,e){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,e);break;default:n()}}setTimeout(s,e)})}var M_={[Zc]:Zc,[Kc]:eu,[Qc]:Qc,[Xo]:tu,[Jc]:Jc,[eu]:Kc,[nu]:nu,[tu]:Xo},Ki=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let r=n[t];if(r!==void 0){let s=r.indexOf(e);s!==-1&&r.splice(s,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let r=n.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,t);t.target=null}}},Yn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],fx=1234567,Va=Math.PI/180,jo=180/Math.PI;function _s(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Yn[i&255]+Yn[i>>8&255]+Yn[i>>16&255]+Yn[i>>24&255]+"-"+Yn[t&255]+Yn[t>>8&255]+"-"+Yn[t>>16&15|64]+Yn[t>>24&255]+"-"+Yn[e&63|128]+Yn[e>>8&255]+"-"+Yn[e>>16&255]+Yn[e>>24&255]+Yn[n&255]+Yn[n>>8&255]+Yn[n>>16&255]+Yn[n>>24&255]).toLowerCase()}function le(i,t,e){return Math.max(t,Math.min(e,i))}function wp(i,t){return(i%t+t)%t}function C1(i,t,e,n,r){return n+(i-t)*(r-n)/(e-t)}function P1(i,t,e){return i!==t?(e-i)/(t-i):0}function Ga(i,t,e){return(1-e)*i+e*t}function I1(i,t,e,n){return Ga(i,t,1-Math.exp(-e*n))}function L1(i,t=1){return t-Math.abs(wp(i,t*2)-t)}function F1(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function N1(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function D1(i,t){return i+Math.floor(Math.random()*(t-i+1))}function O1(i,t){return i+Math.random()*(t-i)}function U1(i){return i*(.5-Math.random())}function k1(i){i!==void 0&&(fx=i);let t=fx+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function B1(i){return i*Va}function z1(i){return i*jo}function V1(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function G1(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Mp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function H1(i,t,e,n,r){let s=Math.cos,o=Math.sin,a=s(e/2),l=o(e/2),c=s((t+n)/2),u=o((t+n)/2),h=s((t-n)/2),f=o((t-n)/2),d=s((n-t)/2),m=o((n-t)/2);switch(r){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*u,a*c);break;default:Zt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function mh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Sp(i,t){if(t.constructor===Float32Array)return i;let e=mh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Ap(i,t){if(t.constructor===Float32Array)return i;let e=mh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var sr={DEG2RAD:Va,RAD2DEG:jo,generateUUID:_s,clamp:le,euclideanModulo:wp,mapLinear:C1,inverseLerp:P1,lerp:Ga,damp:I1,pingpong:L1,smoothstep:F1,smootherstep:N1,randInt:D1,randFloat:O1,randFloatSpread:U1,seededRandom:k1,degToRad:B1,radToDeg:z1,isPowerOfTwo:V1,ceilPowerOfTwo:G1,floorPowerOfTwo:Mp,setQuaternionFromProperEuler:H1,normalize:Ap,denormalize:Sp},Kt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6],this.y=r[1]*e+r[4]*n+r[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=le(this.x,t.x,e.x),this.y=le(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=le(this.x,t,e),this.y=le(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(le(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(le(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),r=Math.sin(e),s=this.x-t.x,o=this.y-t.y;return this.x=s*n-o*r+t.x,this.y=s*r+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},kn=class{constructor(t=0,e=0,n=0,r=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=r}static slerpFlat(t,e,n,r,s,o,a){let l=n[r+0],c=n[r+1],u=n[r+2],h=n[r+3],f=s[o+0],d=s[o+1],m=s[o+2],y=s[o+3];if(h!==y||l!==f||c!==d||u!==m){let g=l*f+c*d+u*m+h*y;g<0&&(f=-f,d=-d,m=-m,y=-y,g=-g);let p=1-a;if(g<.9995){let x=Math.acos(g),b=Math.sin(x);p=Math.sin(p*x)/b,a=Math.sin(a*x)/b,l=l*p+f*a,c=c*p+d*a,u=u*p+m*a,h=h*p+y*a}else{l=l*p+f*a,c=c*p+d*a,u=u*p+m*a,h=h*p+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,r,s,o){let a=n[r],l=n[r+1],c=n[r+2],u=n[r+3],h=s[o],f=s[o+1],d=s[o+2],m=s[o+3];return t[e]=a*m+u*h+l*d-c*f,t[e+1]=l*m+u*f+c*h-a*d,t[e+2]=c*m+u*d+a*f-l*h,t[e+3]=u*m-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,r){return this._x=t,this._y=e,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,r=t._y,s=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(r/2),h=a(s/2),f=l(n/2),d=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"YXZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"ZXY":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"ZYX":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"YZX":this._x=f*u*h+c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h-f*d*m;break;case"XZY":this._x=f*u*h-c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h+f*d*m;break;default:Zt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,r=Math.sin(n);return this._x=t.x*r,this._y=t.y*r,this._z=t.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],r=e[4],s=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(s-c)*d,this._z=(o-r)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(r+o)/d,this._z=(s+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-n-h);this._w=(s-c)/d,this._x=(r+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-r)/d,this._x=(s+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(le(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let r=Math.min(1,e/n);return this.slerp(t,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,r=t._y,s=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-n*c,this._z=s*u+o*c+n*l-r*a,this._w=o*u-n*a-r*l-s*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,r=t._y,s=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,r=-r,s=-s,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+n*e,this._y=this._y*l+r*e,this._z=this._z*l+s*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+r*e,this._z=this._z*l+s*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(t),r*Math.cos(t),s*Math.sin(e),s*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(dx.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(dx.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,r=this.z,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6]*r,this.y=s[1]*e+s[4]*n+s[7]*r,this.z=s[2]*e+s[5]*n+s[8]*r,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,r=this.z,s=t.elements,o=1/(s[3]*e+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*e+s[4]*n+s[8]*r+s[12])*o,this.y=(s[1]*e+s[5]*n+s[9]*r+s[13])*o,this.z=(s[2]*e+s[6]*n+s[10]*r+s[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,r=this.z,s=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*r-a*n),u=2*(a*e-s*r),h=2*(s*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-s*h,this.z=r+l*h+s*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,r=this.z,s=t.elements;return this.x=s[0]*e+s[4]*n+s[8]*r,this.y=s[1]*e+s[5]*n+s[9]*r,this.z=s[2]*e+s[6]*n+s[10]*r,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=le(this.x,t.x,e.x),this.y=le(this.y,t.y,e.y),this.z=le(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=le(this.x,t,e),this.y=le(this.y,t,e),this.z=le(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(le(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,r=t.y,s=t.z,o=e.x,a=e.y,l=e.z;return this.x=r*l-s*a,this.y=s*o-n*l,this.z=n*a-r*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return vd.copy(this).projectOnVector(t),this.sub(vd)}reflect(t){return this.sub(vd.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(le(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,r=this.z-t.z;return e*e+n*n+r*r}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let r=Math.sin(e)*t;return this.x=r*Math.sin(n),this.y=Math.cos(e)*t,this.z=r*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),r=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=r,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},vd=new z,dx=new kn,se=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,r,s,o,a,l,c)}set(t,e,n,r,s,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=r,u[2]=a,u[3]=e,u[4]=s,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,r=e.elements,s=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],m=n[8],y=r[0],g=r[3],p=r[6],x=r[1],b=r[4],v=r[7],A=r[2],S=r[5],_=r[8];return s[0]=o*y+a*x+l*A,s[3]=o*g+a*b+l*S,s[6]=o*p+a*v+l*_,s[1]=c*y+u*x+h*A,s[4]=c*g+u*b+h*S,s[7]=c*p+u*v+h*_,s[2]=f*y+d*x+m*A,s[5]=f*g+d*b+m*S,s[8]=f*p+d*v+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*s*u+n*a*l+r*s*c-r*o*l}invert(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*s,d=c*s-o*l,m=e*h+n*f+r*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return t[0]=h*y,t[1]=(r*c-u*n)*y,t[2]=(a*n-r*o)*y,t[3]=f*y,t[4]=(u*e-r*l)*y,t[5]=(r*s-a*e)*y,t[6]=d*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*s)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-r*c,r*l,-r*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return za("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(bd.makeScale(t,e)),this}rotate(t){return za("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(bd.makeRotation(-t)),this}translate(t,e){return za("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(bd.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let r=0;r<9;r++)if(e[r]!==n[r])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},bd=new se,px=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),mx=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function W1(){let i={enabled:!0,workingColorSpace:Wa,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Re&&(r.r=Br(r.r),r.g=Br(r.g),r.b=Br(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Re&&(r.r=qo(r.r),r.g=qo(r.g),r.b=qo(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Wr?qa:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Wa]:{primaries:t,whitePoint:n,transfer:qa,toXYZ:px,fromXYZ:mx,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Mi},outputColorSpaceConfig:{drawingBufferColorSpace:Mi}},[Mi]:{primaries:t,whitePoint:n,transfer:Re,toXYZ:px,fromXYZ:mx,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Mi}}}),i}var xe=W1();function Br(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function qo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Po,ou=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Po===void 0&&(Po=Xa("canvas")),Po.width=t.width,Po.height=t.height;let r=Po.getContext("2d");t instanceof ImageData?r.putImageData(t,0,0):r.drawImage(t,0,0,t.width,t.height),n=Po}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Xa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let r=n.getImageData(0,0,t.width,t.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Br(s[o]/255)*255;return n.putImageData(r,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Br(e[n]/255)*255):e[n]=Br(e[n]);return{data:e,width:t.width,height:t.height}}else return Zt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},q1=0,Zo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:q1++}),this.uuid=_s(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(wd(r[o].image)):s.push(wd(r[o]))}else s=wd(r);n.url=s}return e||(t.images[this.uuid]=n),n}};function wd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ou.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Zt("Texture: Unable to serialize Texture."),{})}var X1=0,Md=new z,ci=class i extends Ki{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=mr,r=mr,s=oi,o=Gr,a=rr,l=ui,c=i.DEFAULT_ANISOTROPY,u=Wr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:X1++}),this.uuid=_s(),this.name="",this.source=new Zo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Kt(0,0),this.repeat=new Kt(1,1),this.center=new Kt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Md).x}get height(){return this.source.getSize(Md).y}get depth(){return this.source.getSize(Md).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Zt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let r=this[e];if(r===void 0){Zt(`Texture.setValues(): property '${e}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==lp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case iu:t.x=t.x-Math.floor(t.x);break;case mr:t.x=t.x<0?0:1;break;case ru:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case iu:t.y=t.y-Math.floor(t.y);break;case mr:t.y=t.y<0?0:1;break;case ru:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ci.DEFAULT_IMAGE=null;ci.DEFAULT_MAPPING=lp;ci.DEFAULT_ANISOTROPY=1;var Ce=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,r=1){this.x=t,this.y=e,this.z=n,this.w=r}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,r){return this.x=t,this.y=e,this.z=n,this.w=r,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,r=this.z,s=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*r+o[12]*s,this.y=o[1]*e+o[5]*n+o[9]*r+o[13]*s,this.z=o[2]*e+o[6]*n+o[10]*r+o[14]*s,this.w=o[3]*e+o[7]*n+o[11]*r+o[15]*s,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,r,s,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],m=l[9],y=l[2],g=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(m+g)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,v=(d+1)/2,A=(p+1)/2,S=(u+f)/4,_=(h+y)/4,w=(m+g)/4;return b>v&&b>A?b<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(b),r=S/n,s=_/n):v>A?v<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(v),n=S/r,s=w/r):A<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(A),n=_/s,r=w/s),this.set(n,r,s,e),this}let x=Math.sqrt((g-m)*(g-m)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(g-m)/x,this.y=(h-y)/x,this.z=(f-u)/x,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=le(this.x,t.x,e.x),this.y=le(this.y,t.y,e.y),this.z=le(this.z,t.z,e.z),this.w=le(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=le(this.x,t,e),this.y=le(this.y,t,e),this.z=le(this.z,t,e),this.w=le(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(le(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},au=class extends Ki{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:oi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ce(0,0,t,e),this.scissorTest=!1,this.viewport=new Ce(0,0,t,e),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new ci({width:t,height:e,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:oi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=t,this.textures[r].image.height=e,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let r=Object.assign({},t.textures[e].image);this.textures[e].source=new Zo(r)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ai=class extends au{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},Ya=class extends ci{constructor(t=null,e=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:r},this.magFilter=Un,this.minFilter=Un,this.wrapR=mr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var lu=class extends ci{constructor(t=null,e=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:r},this.magFilter=Un,this.minFilter=Un,this.wrapR=mr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ze=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g)}set(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=m,p[11]=y,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,r=1/Io.setFromMatrixColumn(t,0).length(),s=1/Io.setFromMatrixColumn(t,1).length(),o=1/Io.setFromMatrixColumn(t,2).length();return e[0]=n[0]*r,e[1]=n[1]*r,e[2]=n[2]*r,e[3]=0,e[4]=n[4]*s,e[5]=n[5]*s,e[6]=n[6]*s,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,r=t.y,s=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(t.order==="XYZ"){let f=o*u,d=o*h,m=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+m*c,e[5]=f-y*c,e[9]=-a*l,e[2]=y-f*c,e[6]=m+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,d=l*h,m=c*u,y=c*h;e[0]=f+y*a,e[4]=m*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-m,e[6]=y+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*u,d=l*h,m=c*u,y=c*h;e[0]=f-y*a,e[4]=-o*h,e[8]=m+d*a,e[1]=d+m*a,e[5]=o*u,e[9]=y-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,d=o*h,m=a*u,y=a*h;e[0]=l*u,e[4]=m*c-d,e[8]=f*c+y,e[1]=l*h,e[5]=y*c+f,e[9]=d*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*u,e[4]=y-f*h,e[8]=m*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+m,e[10]=f-y*h}else if(t.order==="XZY"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+y,e[5]=o*u,e[9]=d*h-m,e[2]=m*h-d,e[6]=a*u,e[10]=y*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose($1,t,Y1)}lookAt(t,e,n){let r=this.elements;return bi.subVectors(t,e),bi.lengthSq()===0&&(bi.z=1),bi.normalize(),ns.crossVectors(n,bi),ns.lengthSq()===0&&(Math.abs(n.z)===1?bi.x+=1e-4:bi.z+=1e-4,bi.normalize(),ns.crossVectors(n,bi)),ns.normalize(),Ac.crossVectors(bi,ns),r[0]=ns.x,r[4]=Ac.x,r[8]=bi.x,r[1]=ns.y,r[5]=Ac.y,r[9]=bi.y,r[2]=ns.z,r[6]=Ac.z,r[10]=bi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,r=e.elements,s=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],m=n[2],y=n[6],g=n[10],p=n[14],x=n[3],b=n[7],v=n[11],A=n[15],S=r[0],_=r[4],w=r[8],N=r[12],C=r[1],P=r[5],O=r[9],B=r[13],F=r[2],V=r[6],q=r[10],G=r[14],rt=r[3],$=r[7],j=r[11],tt=r[15];return s[0]=o*S+a*C+l*F+c*rt,s[4]=o*_+a*P+l*V+c*$,s[8]=o*w+a*O+l*q+c*j,s[12]=o*N+a*B+l*G+c*tt,s[1]=u*S+h*C+f*F+d*rt,s[5]=u*_+h*P+f*V+d*$,s[9]=u*w+h*O+f*q+d*j,s[13]=u*N+h*B+f*G+d*tt,s[2]=m*S+y*C+g*F+p*rt,s[6]=m*_+y*P+g*V+p*$,s[10]=m*w+y*O+g*q+p*j,s[14]=m*N+y*B+g*G+p*tt,s[3]=x*S+b*C+v*F+A*rt,s[7]=x*_+b*P+v*V+A*$,s[11]=x*w+b*O+v*q+A*j,s[15]=x*N+b*B+v*G+A*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],r=t[8],s=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],m=t[3],y=t[7],g=t[11],p=t[15],x=l*d-c*f,b=a*d-c*h,v=a*f-l*h,A=o*d-c*u,S=o*f-l*u,_=o*h-a*u;return e*(y*x-g*b+p*v)-n*(m*x-g*A+p*S)+r*(m*b-y*A+p*_)-s*(m*v-y*S+g*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],r=t[8],s=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-n*(s*u-a*l)+r*(s*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let r=this.elements;return t.isVector3?(r[12]=t.x,r[13]=t.y,r[14]=t.z):(r[12]=t,r[13]=e,r[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],m=t[12],y=t[13],g=t[14],p=t[15],x=e*a-n*o,b=e*l-r*o,v=e*c-s*o,A=n*l-r*a,S=n*c-s*a,_=r*c-s*l,w=u*y-h*m,N=u*g-f*m,C=u*p-d*m,P=h*g-f*y,O=h*p-d*y,B=f*p-d*g,F=x*B-b*O+v*P+A*C-S*N+_*w;if(F===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/F;return t[0]=(a*B-l*O+c*P)*V,t[1]=(r*O-n*B-s*P)*V,t[2]=(y*_-g*S+p*A)*V,t[3]=(f*S-h*_-d*A)*V,t[4]=(l*C-o*B-c*N)*V,t[5]=(e*B-r*C+s*N)*V,t[6]=(g*v-m*_-p*b)*V,t[7]=(u*_-f*v+d*b)*V,t[8]=(o*O-a*C+c*w)*V,t[9]=(n*C-e*O-s*w)*V,t[10]=(m*S-y*v+p*x)*V,t[11]=(h*v-u*S-d*x)*V,t[12]=(a*N-o*P-l*w)*V,t[13]=(e*P-n*N+r*w)*V,t[14]=(y*b-m*A-g*x)*V,t[15]=(u*A-h*b+f*x)*V,this}scale(t){let e=this.elements,n=t.x,r=t.y,s=t.z;return e[0]*=n,e[4]*=r,e[8]*=s,e[1]*=n,e[5]*=r,e[9]*=s,e[2]*=n,e[6]*=r,e[10]*=s,e[3]*=n,e[7]*=r,e[11]*=s,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],r=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,r))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),r=Math.sin(e),s=1-n,o=t.x,a=t.y,l=t.z,c=s*o,u=s*a;return this.set(c*o+n,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+n,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,r,s,o){return this.set(1,n,s,0,t,1,o,0,e,r,1,0,0,0,0,1),this}compose(t,e,n){let r=this.elements,s=e._x,o=e._y,a=e._z,l=e._w,c=s+s,u=o+o,h=a+a,f=s*c,d=s*u,m=s*h,y=o*u,g=o*h,p=a*h,x=l*c,b=l*u,v=l*h,A=n.x,S=n.y,_=n.z;return r[0]=(1-(y+p))*A,r[1]=(d+v)*A,r[2]=(m-b)*A,r[3]=0,r[4]=(d-v)*S,r[5]=(1-(f+p))*S,r[6]=(g+x)*S,r[7]=0,r[8]=(m+b)*_,r[9]=(g-x)*_,r[10]=(1-(f+y))*_,r[11]=0,r[12]=t.x,r[13]=t.y,r[14]=t.z,r[15]=1,this}decompose(t,e,n){let r=this.elements;t.x=r[12],t.y=r[13],t.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),e.identity(),this;let o=Io.set(r[0],r[1],r[2]).length(),a=Io.set(r[4],r[5],r[6]).length(),l=Io.set(r[8],r[9],r[10]).length();s<0&&(o=-o),ji.copy(this);let c=1/o,u=1/a,h=1/l;return ji.elements[0]*=c,ji.elements[1]*=c,ji.elements[2]*=c,ji.elements[4]*=u,ji.elements[5]*=u,ji.elements[6]*=u,ji.elements[8]*=h,ji.elements[9]*=h,ji.elements[10]*=h,e.setFromRotationMatrix(ji),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,r,s,o,a=Ui,l=!1){let c=this.elements,u=2*s/(e-t),h=2*s/(n-r),f=(e+t)/(e-t),d=(n+r)/(n-r),m,y;if(l)m=s/(o-s),y=o*s/(o-s);else if(a===Ui)m=-(o+s)/(o-s),y=-2*o*s/(o-s);else if(a===$o)m=-o/(o-s),y=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,r,s,o,a=Ui,l=!1){let c=this.elements,u=2/(e-t),h=2/(n-r),f=-(e+t)/(e-t),d=-(n+r)/(n-r),m,y;if(l)m=1/(o-s),y=o/(o-s);else if(a===Ui)m=-2/(o-s),y=-(o+s)/(o-s);else if(a===$o)m=-1/(o-s),y=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let r=0;r<16;r++)if(e[r]!==n[r])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Io=new z,ji=new ze,$1=new z(0,0,0),Y1=new z(1,1,1),ns=new z,Ac=new z,bi=new z,gx=new ze,yx=new kn,gr=class i{constructor(t=0,e=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=r}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,r=this._order){return this._x=t,this._y=e,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let r=t.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],h=r[2],f=r[6],d=r[10];switch(e){case"XYZ":this._y=Math.asin(le(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-le(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(le(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-le(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(le(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-le(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Zt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return gx.makeRotationFromQuaternion(t),this.setFromRotationMatrix(gx,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return yx.setFromEuler(this),this.setFromQuaternion(yx,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};gr.DEFAULT_ORDER="XYZ";var ja=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},j1=0,xx=new z,Lo=new kn,Nr=new ze,Ec=new z,Da=new z,Z1=new z,J1=new kn,_x=new z(1,0,0),vx=new z(0,1,0),bx=new z(0,0,1),wx={type:"added"},K1={type:"removed"},Fo={type:"childadded",child:null},Sd={type:"childremoved",child:null},Vn=class i extends Ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:j1++}),this.uuid=_s(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new z,e=new gr,n=new kn,r=new z(1,1,1);function s(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new ze},normalMatrix:{value:new se}}),this.matrix=new ze,this.matrixWorld=new ze,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ja,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Lo.setFromAxisAngle(t,e),this.quaternion.multiply(Lo),this}rotateOnWorldAxis(t,e){return Lo.setFromAxisAngle(t,e),this.quaternion.premultiply(Lo),this}rotateX(t){return this.rotateOnAxis(_x,t)}rotateY(t){return this.rotateOnAxis(vx,t)}rotateZ(t){return this.rotateOnAxis(bx,t)}translateOnAxis(t,e){return xx.copy(t).applyQuaternion(this.quaternion),this.position.add(xx.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(_x,t)}translateY(t){return this.translateOnAxis(vx,t)}translateZ(t){return this.translateOnAxis(bx,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Nr.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Ec.copy(t):Ec.set(t,e,n);let r=this.parent;this.updateWorldMatrix(!0,!1),Da.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Nr.lookAt(Da,Ec,this.up):Nr.lookAt(Ec,Da,this.up),this.quaternion.setFromRotationMatrix(Nr),r&&(Nr.extractRotation(r.matrixWorld),Lo.setFromRotationMatrix(Nr),this.quaternion.premultiply(Lo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(wx),Fo.child=t,this.dispatchEvent(Fo),Fo.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(K1),Sd.child=t,this.dispatchEvent(Sd),Sd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Nr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Nr.multiply(t.parent.matrixWorld)),t.applyMatrix4(Nr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(wx),Fo.child=t,this.dispatchEvent(Fo),Fo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,r=this.children.length;n<r;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Da,t,Z1),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Da,J1,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,r=t.z,s=this.matrix.elements;s[12]+=e-s[0]*e-s[4]*n-s[8]*r,s[13]+=n-s[1]*e-s[5]*n-s[9]*r,s[14]+=r-s[2]*e-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let r=this.parent;if(t===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(t),r.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(t.shapes,h)}else s(t.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(t.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(t.materials,this.material[l]));r.material=a}else r.material=s(t.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=r,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let r=t.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vn.DEFAULT_UP=new z(0,1,0);Vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var On=class extends Vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Q1={type:"move"},Jo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new On,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new On,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new On,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let g=e.getJointPose(y,n),p=this._getHandJoint(c,y);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(s=e.getPose(t.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(r=e.getPose(t.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Q1)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new On;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},S_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},is={h:0,s:0,l:0},Tc={h:0,s:0,l:0};function Ad(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var ce=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let r=t;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Mi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,xe.colorSpaceToWorking(this,e),this}setRGB(t,e,n,r=xe.workingColorSpace){return this.r=t,this.g=e,this.b=n,xe.colorSpaceToWorking(this,r),this}setHSL(t,e,n,r=xe.workingColorSpace){if(t=wp(t,1),e=le(e,0,1),n=le(n,0,1),e===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+e):n+e-n*e,o=2*n-s;this.r=Ad(o,s,t+1/3),this.g=Ad(o,s,t),this.b=Ad(o,s,t-1/3)}return xe.colorSpaceToWorking(this,r),this}setStyle(t,e=Mi){function n(s){s!==void 0&&parseFloat(s)<1&&Zt("Color: Alpha component of "+t+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(t)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,e);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,e);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,e);break;default:Zt("Color: Unknown color model "+t)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(t)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(s,16),e);Zt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Mi){let n=S_[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Zt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Br(t.r),this.g=Br(t.g),this.b=Br(t.b),this}copyLinearToSRGB(t){return this.r=qo(t.r),this.g=qo(t.g),this.b=qo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Mi){return xe.workingToColorSpace(jn.copy(this),t),Math.round(le(jn.r*255,0,255))*65536+Math.round(le(jn.g*255,0,255))*256+Math.round(le(jn.b*255,0,255))}getHexString(t=Mi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=xe.workingColorSpace){xe.workingToColorSpace(jn.copy(this),e);let n=jn.r,r=jn.g,s=jn.b,o=Math.max(n,r,s),a=Math.min(n,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(r-s)/h+(r<s?6:0);break;case r:l=(s-n)/h+2;break;case s:l=(n-r)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=xe.workingColorSpace){return xe.workingToColorSpace(jn.copy(this),e),t.r=jn.r,t.g=jn.g,t.b=jn.b,t}getStyle(t=Mi){xe.workingToColorSpace(jn.copy(this),t);let e=jn.r,n=jn.g,r=jn.b;return t!==Mi?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(t,e,n){return this.getHSL(is),this.setHSL(is.h+t,is.s+e,is.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(is),t.getHSL(Tc);let n=Ga(is.h,Tc.h,e),r=Ga(is.s,Tc.s,e),s=Ga(is.l,Tc.l,e);return this.setHSL(n,r,s),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,r=this.b,s=t.elements;return this.r=s[0]*e+s[3]*n+s[6]*r,this.g=s[1]*e+s[4]*n+s[7]*r,this.b=s[2]*e+s[5]*n+s[8]*r,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},jn=new ce;ce.NAMES=S_;var Za=class extends Vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new gr,this.environmentIntensity=1,this.environmentRotation=new gr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Zi=new z,Dr=new z,Ed=new z,Or=new z,No=new z,Do=new z,Mx=new z,Td=new z,Rd=new z,Cd=new z,Pd=new Ce,Id=new Ce,Ld=new Ce,as=class i{constructor(t=new z,e=new z,n=new z){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,r){r.subVectors(n,e),Zi.subVectors(t,e),r.cross(Zi);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(t,e,n,r,s){Zi.subVectors(r,e),Dr.subVectors(n,e),Ed.subVectors(t,e);let o=Zi.dot(Zi),a=Zi.dot(Dr),l=Zi.dot(Ed),c=Dr.dot(Dr),u=Dr.dot(Ed),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,m=(o*u-a*l)*f;return s.set(1-d-m,m,d)}static containsPoint(t,e,n,r){return this.getBarycoord(t,e,n,r,Or)===null?!1:Or.x>=0&&Or.y>=0&&Or.x+Or.y<=1}static getInterpolation(t,e,n,r,s,o,a,l){return this.getBarycoord(t,e,n,r,Or)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Or.x),l.addScaledVector(o,Or.y),l.addScaledVector(a,Or.z),l)}static getInterpolatedAttribute(t,e,n,r,s,o){return Pd.setScalar(0),Id.setScalar(0),Ld.setScalar(0),Pd.fromBufferAttribute(t,e),Id.fromBufferAttribute(t,n),Ld.fromBufferAttribute(t,r),o.setScalar(0),o.addScaledVector(Pd,s.x),o.addScaledVector(Id,s.y),o.addScaledVector(Ld,s.z),o}static isFrontFacing(t,e,n,r){return Zi.subVectors(n,e),Dr.subVectors(t,e),Zi.cross(Dr).dot(r)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,r){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[r]),this}setFromAttributeAndIndices(t,e,n,r){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,r),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Zi.subVectors(this.c,this.b),Dr.subVectors(this.a,this.b),Zi.cross(Dr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,r,s){return i.getInterpolation(t,this.a,this.b,this.c,e,n,r,s)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,r=this.b,s=this.c,o,a;No.subVectors(r,n),Do.subVectors(s,n),Td.subVectors(t,n);let l=No.dot(Td),c=Do.dot(Td);if(l<=0&&c<=0)return e.copy(n);Rd.subVectors(t,r);let u=No.dot(Rd),h=Do.dot(Rd);if(u>=0&&h<=u)return e.copy(r);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(n).addScaledVector(No,o);Cd.subVectors(t,s);let d=No.dot(Cd),m=Do.dot(Cd);if(m>=0&&d<=m)return e.copy(s);let y=d*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(Do,a);let g=u*m-d*h;if(g<=0&&h-u>=0&&d-m>=0)return Mx.subVectors(s,r),a=(h-u)/(h-u+(d-m)),e.copy(r).addScaledVector(Mx,a);let p=1/(g+y+f);return o=y*p,a=f*p,e.copy(n).addScaledVector(No,o).addScaledVector(Do,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Gn=class{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ji.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ji.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ji.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let s=n.getAttribute("position");if(e===!0&&s!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ji):Ji.fromBufferAttribute(s,o),Ji.applyMatrix4(t.matrixWorld),this.expandByPoint(Ji);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Rc.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Rc.copy(n.boundingBox)),Rc.applyMatrix4(t.matrixWorld),this.union(Rc)}let r=t.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ji),Ji.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Oa),Cc.subVectors(this.max,Oa),Oo.subVectors(t.a,Oa),Uo.subVectors(t.b,Oa),ko.subVectors(t.c,Oa),rs.subVectors(Uo,Oo),ss.subVectors(ko,Uo),Ds.subVectors(Oo,ko);let e=[0,-rs.z,rs.y,0,-ss.z,ss.y,0,-Ds.z,Ds.y,rs.z,0,-rs.x,ss.z,0,-ss.x,Ds.z,0,-Ds.x,-rs.y,rs.x,0,-ss.y,ss.x,0,-Ds.y,Ds.x,0];return!Fd(e,Oo,Uo,ko,Cc)||(e=[1,0,0,0,1,0,0,0,1],!Fd(e,Oo,Uo,ko,Cc))?!1:(Pc.crossVectors(rs,ss),e=[Pc.x,Pc.y,Pc.z],Fd(e,Oo,Uo,ko,Cc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ji).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ji).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ur[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ur[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ur[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ur[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ur[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ur[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ur[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ur[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ur),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ur=[new z,new z,new z,new z,new z,new z,new z,new z],Ji=new z,Rc=new Gn,Oo=new z,Uo=new z,ko=new z,rs=new z,ss=new z,Ds=new z,Oa=new z,Cc=new z,Pc=new z,Os=new z;function Fd(i,t,e,n,r){for(let s=0,o=i.length-3;s<=o;s+=3){Os.fromArray(i,s);let a=r.x*Math.abs(Os.x)+r.y*Math.abs(Os.y)+r.z*Math.abs(Os.z),l=t.dot(Os),c=e.dot(Os),u=n.dot(Os);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var xn=new z,Ic=new Kt,tA=0,on=class extends Ki{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:tA++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=_p,this.updateRanges=[],this.gpuType=nr,this.version=0,this._normalizationScale=t!==void 0?mh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[t+r]=e.array[n+r];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ic.fromBufferAttribute(this,e),Ic.applyMatrix3(t),this.setXY(e,Ic.x,Ic.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)xn.fromBufferAttribute(this,e),xn.applyMatrix3(t),this.setXYZ(e,xn.x,xn.y,xn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)xn.fromBufferAttribute(this,e),xn.applyMatrix4(t),this.setXYZ(e,xn.x,xn.y,xn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)xn.fromBufferAttribute(this,e),xn.applyNormalMatrix(t),this.setXYZ(e,xn.x,xn.y,xn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)xn.fromBufferAttribute(this,e),xn.transformDirection(t),this.setXYZ(e,xn.x,xn.y,xn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=r,this}setXYZW(t,e,n,r,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=r,this.array[t+3]=s,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Sp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ap(t,this.array)}};var Ja=class extends on{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Ka=class extends on{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ve=class extends on{constructor(t,e,n){super(new Float32Array(t),e,n)}},eA=new Gn,Ua=new z,Nd=new z,Qi=class{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):eA.setFromPoints(t).getCenter(n);let r=0;for(let s=0,o=t.length;s<o;s++)r=Math.max(r,n.distanceToSquared(t[s]));return this.radius=Math.sqrt(r),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ua.subVectors(t,this.center);let e=Ua.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),r=(n-this.radius)*.5;this.center.addScaledVector(Ua,r/n),this.radius+=r}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Nd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ua.copy(t.center).add(Nd)),this.expandByPoint(Ua.copy(t.center).sub(Nd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},nA=0,Oi=new ze,Dd=new Vn,Bo=new z,wi=new Gn,ka=new Gn,Dn=new z,an=class i extends Ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:nA++}),this.uuid=_s(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(T1(t)?Ka:Ja)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new se().getNormalMatrix(t);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(t),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Oi.makeRotationFromQuaternion(t),this.applyMatrix4(Oi),this}rotateX(t){return Oi.makeRotationX(t),this.applyMatrix4(Oi),this}rotateY(t){return Oi.makeRotationY(t),this.applyMatrix4(Oi),this}rotateZ(t){return Oi.makeRotationZ(t),this.applyMatrix4(Oi),this}translate(t,e,n){return Oi.makeTranslation(t,e,n),this.applyMatrix4(Oi),this}scale(t,e,n){return Oi.makeScale(t,e,n),this.applyMatrix4(Oi),this}lookAt(t){return Dd.lookAt(t),Dd.updateMatrix(),this.applyMatrix4(Dd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Bo).negate(),this.translate(Bo.x,Bo.y,Bo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let r=0,s=t.length;r<s;r++){let o=t[r];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ve(n,3))}else{let n=Math.min(t.length,e.count);for(let r=0;r<n;r++){let s=t[r];e.setXYZ(r,s.x,s.y,s.z||0)}t.length>e.count&&Zt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Gn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,r=e.length;n<r;n++){let s=e[n];wi.setFromBufferAttribute(s),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,wi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,wi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(wi.min),this.boundingBox.expandByPoint(wi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Qi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){let n=this.boundingSphere.center;if(wi.setFromBufferAttribute(t),e)for(let s=0,o=e.length;s<o;s++){let a=e[s];ka.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(wi.min,ka.min),wi.expandByPoint(Dn),Dn.addVectors(wi.max,ka.max),wi.expandByPoint(Dn)):(wi.expandByPoint(ka.min),wi.expandByPoint(ka.max))}wi.getCenter(n);let r=0;for(let s=0,o=t.count;s<o;s++)Dn.fromBufferAttribute(t,s),r=Math.max(r,n.distanceToSquared(Dn));if(e)for(let s=0,o=e.length;s<o;s++){let a=e[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Dn.fromBufferAttribute(a,c),l&&(Bo.fromBufferAttribute(t,c),Dn.add(Bo)),r=Math.max(r,n.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,r=e.normal,s=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new on(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let N=0;N<n.count;N++)a[N]=new z,l[N]=new z;let u=new z,h=new z,f=new z,d=new Kt,m=new Kt,y=new Kt,g=new z,p=new z;function x(N,C,P){c[N]=c[C]=c[P]=1,u.fromBufferAttribute(n,N),h.fromBufferAttribute(n,C),f.fromBufferAttribute(n,P),d.fromBufferAttribute(s,N),m.fromBufferAttribute(s,C),y.fromBufferAttribute(s,P),h.sub(u),f.sub(u),m.sub(d),y.sub(d);let O=1/(m.x*y.y-y.x*m.y);isFinite(O)&&(g.copy(h).multiplyScalar(y.y).addScaledVector(f,-m.y).multiplyScalar(O),p.copy(f).multiplyScalar(m.x).addScaledVector(h,-y.x).multiplyScalar(O),a[N].add(g),a[C].add(g),a[P].add(g),l[N].add(p),l[C].add(p),l[P].add(p))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let N=0,C=b.length;N<C;++N){let P=b[N],O=P.start,B=P.count;for(let F=O,V=O+B;F<V;F+=3)x(t.getX(F+0),t.getX(F+1),t.getX(F+2))}let v=new z,A=new z,S=new z,_=new z;function w(N){S.fromBufferAttribute(r,N),_.copy(S);let C=a[N];v.copy(C),v.sub(S.multiplyScalar(S.dot(C))).normalize(),A.crossVectors(_,C);let O=A.dot(l[N])<0?-1:1;o.setXYZW(N,v.x,v.y,v.z,O)}for(let N=0,C=n.count;N<C;++N)c[N]&&w(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new on(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let r=new z,s=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(t)for(let f=0,d=t.count;f<d;f+=3){let m=t.getX(f+0),y=t.getX(f+1),g=t.getX(f+2);r.fromBufferAttribute(e,m),s.fromBufferAttribute(e,y),o.fromBufferAttribute(e,g),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)r.fromBufferAttribute(e,f+0),s.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Dn.fromBufferAttribute(t,e),Dn.normalize(),t.setXYZ(e,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,m=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let p=0;p<u;p++)f[m++]=c[d++]}return new on(f,u,h)}if(this.index===null)return Zt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=t(l,n);e.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(r[l]=u,s=!0)}s&&(t.data.morphAttributes=r,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let r=t.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(e))}let s=t.morphAttributes;for(let c in s){let u=[],h=s[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Qa=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=_p,this.updateRanges=[],this.version=0,this.uuid=_s()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let r=0,s=this.stride;r<s;r++)this.array[t+r]=e.array[n+r];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Sx(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),r=new this.constructor(n,this.stride);return r.setUsage(this.usage),r}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Sx(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Sx(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=_s()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var si=new z,ki=class i{constructor(t,e,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=r,this._normalizationScale=t!==void 0?mh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)si.fromBufferAttribute(this,e),si.applyMatrix4(t),this.setXYZ(e,si.x,si.y,si.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)si.fromBufferAttribute(this,e),si.applyNormalMatrix(t),this.setXYZ(e,si.x,si.y,si.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)si.fromBufferAttribute(this,e),si.transformDirection(t),this.setXYZ(e,si.x,si.y,si.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=r,this}setXYZW(t,e,n,r,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=r,this.data.array[t+3]=s,this}clone(t){if(t===void 0){$a("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)e.push(this.data.array[r+s])}return new on(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){$a("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)e.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Sp(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ap(t,this.data.array)}},Od=new z,iA=new z,rA=new se,Si=class{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,r){return this.normal.set(t,e,n),this.constant=r,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let r=Od.subVectors(n,e).cross(iA.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(r,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let r=t.delta(Od),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/s;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(r,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||rA.getNormalMatrix(t),r=this.coplanarPoint(Od).applyMatrix4(t),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},sA=0,tr=class extends Ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:sA++}),this.uuid=_s(),this.name="",this.type="Material",this.blending=ra,this.side=ys,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Qd,this.blendDst=tp,this.blendEquation=qs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ce(0,0,0),this.blendAlpha=0,this.depthFunc=Xo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=p_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=jc,this.stencilZFail=jc,this.stencilZPass=jc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Zt(`Material: parameter '${e}' has value of undefined.`);continue}let r=this[e];if(r===void 0){Zt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(e){let s=r(t.textures),o=r(t.images);s.length>0&&(n.textures=s),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ce().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Si().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Kt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Kt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let r=e.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=e[s].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var kr=new z,Ud=new z,Lc=new z,Fc=new z,Bs=class{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,kr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=kr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(kr.copy(this.origin).addScaledVector(this.direction,e),kr.distanceToSquared(t))}distanceSqToSegment(t,e,n,r){Ud.copy(t).add(e).multiplyScalar(.5),Lc.copy(e).sub(t).normalize(),Fc.copy(this.origin).sub(Ud);let s=t.distanceTo(e)*.5,o=-this.direction.dot(Lc),a=Fc.dot(this.direction),l=-Fc.dot(Lc),c=Fc.lengthSq(),u=Math.abs(1-o*o),h,f,d,m;if(u>0)if(h=o*l-a,f=o*a-l,m=s*u,h>=0)if(f>=-m)if(f<=m){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-s,-l),s),d=f*(f+2*l)+c):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(Ud).addScaledVector(Lc,f),d}intersectSphere(t,e){if(t.radius<0)return null;kr.subVectors(t.center,this.origin);let n=kr.dot(this.direction),r=kr.dot(kr)-n*n,s=t.radius*t.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,r=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,r=(t.min.x-f.x)*c),u>=0?(s=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(s=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||s>r||((s>n||isNaN(n))&&(n=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>r)||((a>n||n!==n)&&(n=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(n>=0?n:r,e)}intersectsBox(t){return this.intersectBox(t,kr)!==null}intersectTriangle(t,e,n,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,f=t.y-o.y,d=t.z-o.z,m=e.x-o.x,y=e.y-o.y,g=e.z-o.z,p=n.x-o.x,x=n.y-o.y,b=n.z-o.z,v=Math.abs(l),A=Math.abs(c),S=Math.abs(u),_,w,N,C,P,O,B,F,V,q,G,rt;if(v>=A&&v>=S?(N=l,O=h,V=m,rt=p,l>=0?(_=c,w=u,C=f,P=d,B=y,F=g,q=x,G=b):(_=u,w=c,C=d,P=f,B=g,F=y,q=b,G=x)):A>=S?(N=c,O=f,V=y,rt=x,c>=0?(_=u,w=l,C=d,P=h,B=g,F=m,q=b,G=p):(_=l,w=u,C=h,P=d,B=m,F=g,q=p,G=b)):(N=u,O=d,V=g,rt=b,u>=0?(_=l,w=c,C=h,P=f,B=m,F=y,q=p,G=x):(_=c,w=l,C=f,P=h,B=y,F=m,q=x,G=p)),N===0)return null;let $=_/N,j=w/N,tt=1/N,ut=C-$*O,ct=P-j*O,K=B-$*V,gt=F-j*V,yt=q-$*rt,Mt=G-j*rt,xt=yt*gt-Mt*K,zt=ut*Mt-ct*yt,te=K*ct-gt*ut;if(r){if(xt<0||zt<0||te<0)return null}else if((xt<0||zt<0||te<0)&&(xt>0||zt>0||te>0))return null;let dt=xt+zt+te;if(dt===0)return null;let Wt=tt*(xt*O+zt*V+te*rt);return(dt>0?Wt<0:Wt>0)?null:this.at(Wt/dt,s)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ko=class extends tr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new gr,this.combine=Cu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Ax=new ze,Us=new Bs,Nc=new Qi,Ex=new z,Dc=new z,Oc=new z,Uc=new z,kd=new z,kc=new z,Tx=new z,Bc=new z,Ge=class extends Vn{constructor(t=new an,e=new Ko){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let r=e[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(t,e){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(r,t);let a=this.morphTargetInfluences;if(s&&a){kc.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(kd.fromBufferAttribute(h,t),o?kc.addScaledVector(kd,u):kc.addScaledVector(kd.sub(e),u))}e.add(kc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Nc.copy(n.boundingSphere),Nc.applyMatrix4(s),Us.copy(t.ray).recast(t.near),!(Nc.containsPoint(Us.origin)===!1&&(Us.intersectSphere(Nc,Ex)===null||Us.origin.distanceToSquared(Ex)>(t.far-t.near)**2))&&(Ax.copy(s).invert(),Us.copy(t.ray).applyMatrix4(Ax),!(n.boundingBox!==null&&Us.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Us)))}_computeIntersections(t,e,n){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],x=Math.max(g.start,d.start),b=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let v=x,A=b;v<A;v+=3){let S=a.getX(v),_=a.getX(v+1),w=a.getX(v+2);r=zc(this,p,t,n,c,u,h,S,_,w),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,e.push(r))}}else{let m=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let g=m,p=y;g<p;g+=3){let x=a.getX(g),b=a.getX(g+1),v=a.getX(g+2);r=zc(this,o,t,n,c,u,h,x,b,v),r&&(r.faceIndex=Math.floor(g/3),e.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],x=Math.max(g.start,d.start),b=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let v=x,A=b;v<A;v+=3){let S=v,_=v+1,w=v+2;r=zc(this,p,t,n,c,u,h,S,_,w),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,e.push(r))}}else{let m=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let g=m,p=y;g<p;g+=3){let x=g,b=g+1,v=g+2;r=zc(this,o,t,n,c,u,h,x,b,v),r&&(r.faceIndex=Math.floor(g/3),e.push(r))}}}};function oA(i,t,e,n,r,s,o,a){let l;if(t.side===ai?l=n.intersectTriangle(o,s,r,!0,a):l=n.intersectTriangle(r,s,o,t.side===ys,a),l===null)return null;Bc.copy(a),Bc.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Bc);return c<e.near||c>e.far?null:{distance:c,point:Bc.clone(),object:i}}function zc(i,t,e,n,r,s,o,a,l,c){i.getVertexPosition(a,Dc),i.getVertexPosition(l,Oc),i.getVertexPosition(c,Uc);let u=oA(i,t,e,n,Dc,Oc,Uc,Tx);if(u){let h=new z;as.getBarycoord(Tx,Dc,Oc,Uc,h),r&&(u.uv=as.getInterpolatedAttribute(r,a,l,c,h,new Kt)),s&&(u.uv1=as.getInterpolatedAttribute(s,a,l,c,h,new Kt)),o&&(u.normal=as.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new z,materialIndex:0};as.getNormal(Dc,Oc,Uc,f.normal),u.face=f,u.barycoord=h}return u}var cu=class extends ci{constructor(t=null,e=1,n=1,r,s,o,a,l,c=Un,u=Un,h,f){super(null,o,a,l,c,u,r,s,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ks=new Qi,aA=new Kt(.5,.5),Vc=new z,ls=class{constructor(t=new Si,e=new Si,n=new Si,r=new Si,s=new Si,o=new Si){this.planes=[t,e,n,r,s,o]}set(t,e,n,r,s,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ui,n=!1){let r=this.planes,s=t.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],f=s[6],d=s[7],m=s[8],y=s[9],g=s[10],p=s[11],x=s[12],b=s[13],v=s[14],A=s[15];if(r[0].setComponents(c-o,d-u,p-m,A-x).normalize(),r[1].setComponents(c+o,d+u,p+m,A+x).normalize(),r[2].setComponents(c+a,d+h,p+y,A+b).normalize(),r[3].setComponents(c-a,d-h,p-y,A-b).normalize(),n)r[4].setComponents(l,f,g,v).normalize(),r[5].setComponents(c-l,d-f,p-g,A-v).normalize();else if(r[4].setComponents(c-l,d-f,p-g,A-v).normalize(),e===Ui)r[5].setComponents(c+l,d+f,p+g,A+v).normalize();else if(e===$o)r[5].setComponents(l,f,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ks.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ks.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ks)}intersectsSprite(t){ks.center.set(0,0,0);let e=aA.distanceTo(t.center);return ks.radius=.7071067811865476+e,ks.applyMatrix4(t.matrixWorld),this.intersectsSphere(ks)}intersectsSphere(t){let e=this.planes,n=t.center,r=-t.radius;for(let s=0;s<6;s++)if(e[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let r=e[n];if(Vc.x=r.normal.x>0?t.max.x:t.min.x,Vc.y=r.normal.y>0?t.max.y:t.min.y,Vc.z=r.normal.z>0?t.max.z:t.min.z,r.distanceToPoint(Vc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Rx=new ze,uu=class i{constructor(){this.coordinateSystem=Ui,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let r=0;r<e.length;r++){let s=e[r];Rx.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new ls),n[r].setFromProjectionMatrix(Rx,s.coordinateSystem,s.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let r=0;r<t._count;r++)e[r]===void 0&&(e[r]=new ls),e[r].copy(n[r]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Qo=class extends tr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ce(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},hu=new z,fu=new z,Cx=new ze,Ba=new Bs,Gc=new Qi,Bd=new z,Px=new z,ta=class extends Vn{constructor(t=new an,e=new Qo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let r=1,s=e.count;r<s;r++)hu.fromBufferAttribute(e,r-1),fu.fromBufferAttribute(e,r),n[r]=n[r-1],n[r]+=hu.distanceTo(fu);t.setAttribute("lineDistance",new Ve(n,1))}else Zt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,r=this.matrixWorld,s=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Gc.copy(n.boundingSphere),Gc.applyMatrix4(r),Gc.radius+=s,t.ray.intersectsSphere(Gc)===!1)return;Cx.copy(r).invert(),Ba.copy(t.ray).applyMatrix4(Cx);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=d,g=m-1;y<g;y+=c){let p=u.getX(y),x=u.getX(y+1),b=Hc(this,t,Ba,l,p,x,y);b&&e.push(b)}if(this.isLineLoop){let y=u.getX(m-1),g=u.getX(d),p=Hc(this,t,Ba,l,y,g,m-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=d,g=m-1;y<g;y+=c){let p=Hc(this,t,Ba,l,y,y+1,y);p&&e.push(p)}if(this.isLineLoop){let y=Hc(this,t,Ba,l,m-1,d,m-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let r=e[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function Hc(i,t,e,n,r,s,o){let a=i.geometry.attributes.position;if(hu.fromBufferAttribute(a,r),fu.fromBufferAttribute(a,s),e.distanceSqToSegment(hu,fu,Bd,Px)>n)return;Bd.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Bd);if(!(c<t.near||c>t.far))return{distance:c,point:Px.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Ix=new z,Lx=new z,du=class extends ta{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let r=0,s=e.count;r<s;r+=2)Ix.fromBufferAttribute(e,r),Lx.fromBufferAttribute(e,r+1),n[r]=r===0?0:n[r-1],n[r+1]=n[r]+Ix.distanceTo(Lx);t.setAttribute("lineDistance",new Ve(n,1))}else Zt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var tl=class extends ci{constructor(t=[],e=Xs,n,r,s,o,a,l,c,u){super(t,e,n,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Vr=class extends ci{constructor(t,e,n=er,r,s,o,a=Un,l=Un,c,u=zr,h=1){if(u!==zr&&u!==Hr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,r,s,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Zo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},el=class extends Vr{constructor(t,e=er,n=Xs,r,s,o=Un,a=Un,l,c=zr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,n,r,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},nl=class extends ci{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},cs=class i extends an{constructor(t=1,e=1,n=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;m("z","y","x",-1,-1,n,e,t,o,s,0),m("z","y","x",1,-1,n,e,-t,o,s,1),m("x","z","y",1,1,t,n,e,r,o,2),m("x","z","y",1,-1,t,n,-e,r,o,3),m("x","y","z",1,-1,t,e,n,r,s,4),m("x","y","z",-1,-1,t,e,-n,r,s,5),this.setIndex(l),this.setAttribute("position",new Ve(c,3)),this.setAttribute("normal",new Ve(u,3)),this.setAttribute("uv",new Ve(h,2));function m(y,g,p,x,b,v,A,S,_,w,N){let C=v/_,P=A/w,O=v/2,B=A/2,F=S/2,V=_+1,q=w+1,G=0,rt=0,$=new z;for(let j=0;j<q;j++){let tt=j*P-B;for(let ut=0;ut<V;ut++){let ct=ut*C-O;$[y]=ct*x,$[g]=tt*b,$[p]=F,c.push($.x,$.y,$.z),$[y]=0,$[g]=0,$[p]=S>0?1:-1,u.push($.x,$.y,$.z),h.push(ut/_),h.push(1-j/w),G+=1}}for(let j=0;j<w;j++)for(let tt=0;tt<_;tt++){let ut=f+tt+V*j,ct=f+tt+V*(j+1),K=f+(tt+1)+V*(j+1),gt=f+(tt+1)+V*j;l.push(ut,ct,gt),l.push(ct,K,gt),rt+=6}a.addGroup(d,rt,N),d+=rt,f+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var yr=class i extends an{constructor(t=1,e=1,n=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let u=[],h=[],f=[],d=[],m=0,y=[],g=n/2,p=0;x(),o===!1&&(t>0&&b(!0),e>0&&b(!1)),this.setIndex(u),this.setAttribute("position",new Ve(h,3)),this.setAttribute("normal",new Ve(f,3)),this.setAttribute("uv",new Ve(d,2));function x(){let v=new z,A=new z,S=0,_=(e-t)/n;for(let w=0;w<=s;w++){let N=[],C=w/s,P=C*(e-t)+t;for(let O=0;O<=r;O++){let B=O/r,F=B*l+a,V=Math.sin(F),q=Math.cos(F);A.x=P*V,A.y=-C*n+g,A.z=P*q,h.push(A.x,A.y,A.z),v.set(V,_,q).normalize(),f.push(v.x,v.y,v.z),d.push(B,1-C),N.push(m++)}y.push(N)}for(let w=0;w<r;w++)for(let N=0;N<s;N++){let C=y[N][w],P=y[N+1][w],O=y[N+1][w+1],B=y[N][w+1];(t>0||N!==0)&&(u.push(C,P,B),S+=3),(e>0||N!==s-1)&&(u.push(P,O,B),S+=3)}c.addGroup(p,S,0),p+=S}function b(v){let A=m,S=new Kt,_=new z,w=0,N=v===!0?t:e,C=v===!0?1:-1;for(let O=1;O<=r;O++)h.push(0,g*C,0),f.push(0,C,0),d.push(.5,.5),m++;let P=m;for(let O=0;O<=r;O++){let F=O/r*l+a,V=Math.cos(F),q=Math.sin(F);_.x=N*q,_.y=g*C,_.z=N*V,h.push(_.x,_.y,_.z),f.push(0,C,0),S.x=V*.5+.5,S.y=q*.5*C+.5,d.push(S.x,S.y),m++}for(let O=0;O<r;O++){let B=A+O,F=P+O;v===!0?u.push(F,F+1,B):u.push(F+1,F,B),w+=3}c.addGroup(p,w,v===!0?1:2),p+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},il=class i extends yr{constructor(t=1,e=1,n=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,t,e,n,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var zs=class i extends an{constructor(t=1,e=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:r};let s=t/2,o=e/2,a=Math.floor(n),l=Math.floor(r),c=a+1,u=l+1,h=t/a,f=e/l,d=[],m=[],y=[],g=[];for(let p=0;p<u;p++){let x=p*f-o;for(let b=0;b<c;b++){let v=b*h-s;m.push(v,-x,0),y.push(0,0,1),g.push(b/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let x=0;x<a;x++){let b=x+c*p,v=x+c*(p+1),A=x+1+c*(p+1),S=x+1+c*p;d.push(b,v,S),d.push(v,A,S)}this.setIndex(d),this.setAttribute("position",new Ve(m,3)),this.setAttribute("normal",new Ve(y,3)),this.setAttribute("uv",new Ve(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var ea=class i extends an{constructor(t=1,e=32,n=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new z,f=new z,d=[],m=[],y=[],g=[];for(let p=0;p<=n;p++){let x=[],b=p/n,v=o+b*a,A=t*Math.cos(v),S=Math.sqrt(t*t-A*A),_=0;p===0&&o===0?_=.5/e:p===n&&l===Math.PI&&(_=-.5/e);for(let w=0;w<=e;w++){let N=w/e,C=r+N*s;h.x=-S*Math.cos(C),h.y=A,h.z=S*Math.sin(C),m.push(h.x,h.y,h.z),f.copy(h).normalize(),y.push(f.x,f.y,f.z),g.push(N+_,1-b),x.push(c++)}u.push(x)}for(let p=0;p<n;p++)for(let x=0;x<e;x++){let b=u[p][x+1],v=u[p][x],A=u[p+1][x],S=u[p+1][x+1];(p!==0||o>0)&&d.push(b,v,S),(p!==n-1||l<Math.PI)&&d.push(v,A,S)}this.setIndex(d),this.setAttribute("position",new Ve(m,3)),this.setAttribute("normal",new Ve(y,3)),this.setAttribute("uv",new Ve(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var rl=class extends an{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,r=new z,s=new z;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,d=h.count;for(let m=f,y=f+d;m<y;m+=3)for(let g=0;g<3;g++){let p=a.getX(m+g),x=a.getX(m+(g+1)%3);r.fromBufferAttribute(o,p),s.fromBufferAttribute(o,x),Fx(r,s,n)===!0&&(e.push(r.x,r.y,r.z),e.push(s.x,s.y,s.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;r.fromBufferAttribute(o,u),s.fromBufferAttribute(o,h),Fx(r,s,n)===!0&&(e.push(r.x,r.y,r.z),e.push(s.x,s.y,s.z))}}this.setAttribute("position",new Ve(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Fx(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,r=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(r)===!0?!1:(e.add(n),e.add(r),!0)}var sl=class extends tr{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new ce(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function Ys(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let r=i[e][n];if(Nx(r))r.isRenderTargetTexture?(Zt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=r.clone();else if(Array.isArray(r))if(Nx(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();t[e][n]=s}else t[e][n]=r.slice();else t[e][n]=r}}return t}function Zn(i){let t={};for(let e=0;e<i.length;e++){let n=Ys(i[e]);for(let r in n)t[r]=n[r]}return t}function Nx(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function lA(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Ep(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:xe.workingColorSpace}var Al={clone:Ys,merge:Zn},cA=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,uA=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Bi=class extends tr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=cA,this.fragmentShader=uA,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Ys(t.uniforms),this.uniformsGroups=lA(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?e.uniforms[r]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[r]={type:"m4",value:o.toArray()}:e.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let r=t.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=e[r.value]||null;break;case"c":this.uniforms[n].value=new ce().setHex(r.value);break;case"v2":this.uniforms[n].value=new Kt().fromArray(r.value);break;case"v3":this.uniforms[n].value=new z().fromArray(r.value);break;case"v4":this.uniforms[n].value=new Ce().fromArray(r.value);break;case"m3":this.uniforms[n].value=new se().fromArray(r.value);break;case"m4":this.uniforms[n].value=new ze().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},pu=class extends Bi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},ol=class extends tr{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ce(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Sl,this.normalScale=new Kt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new gr,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Vs=class extends tr{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Sl,this.normalScale=new Kt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new gr,this.combine=Cu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},mu=class extends tr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=f_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},gu=class extends tr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var al=class extends Qo{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function zo(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Wc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var us=class{constructor(t,e,n,r){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,r=e[n],s=e[n-1];t:{e:{let o;n:{i:if(!(t<r)){for(let a=n+2;;){if(r===void 0){if(t<s)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(s=r,r=e[++n],t<r)break e}o=e.length;break n}if(!(t>=s)){let a=e[1];t<a&&(n=2,s=a);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(r=s,s=e[--n-1],t>=s)break e}o=n,n=0;break n}break t}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(r=e[n],s=e[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,t,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=t*r;for(let o=0;o!==r;++o)e[o]=n[s+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},yu=class extends us{constructor(t,e,n,r){super(t,e,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hd,endingEnd:Hd}}intervalChanged_(t,e,n){let r=this.parameterPositions,s=t-2,o=t+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case Wd:s=t,a=2*e-n;break;case qd:s=r.length-2,a=e+r[s]-r[s+1];break;default:s=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Wd:o=t,l=2*n-e;break;case qd:o=1,l=n+r[1]-r[0];break;default:o=t-1,l=e}let c=(n-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(n-e)/(r-e),y=m*m,g=y*m,p=-f*g+2*f*y-f*m,x=(1+f)*g+(-1.5-2*f)*y+(-.5+f)*m+1,b=(-1-d)*g+(1.5+d)*y+.5*m,v=d*g-d*y;for(let A=0;A!==a;++A)s[A]=p*o[u+A]+x*o[c+A]+b*o[l+A]+v*o[h+A];return s}},xu=class extends us{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(n-e)/(r-e),h=1-u;for(let f=0;f!==a;++f)s[f]=o[c+f]*h+o[l+f]*u;return s}},_u=class extends us{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t){return this.copySampleValue_(t-1)}},vu=class extends us{interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(n-e)/(r-e),y=1-m;for(let g=0;g!==a;++g)s[g]=o[c+g]*y+o[l+g]*m;return s}let f=a*2,d=t-1;for(let m=0;m!==a;++m){let y=o[c+m],g=o[l+m],p=d*f+m*2,x=h[p],b=h[p+1],v=t*f+m*2,A=u[v],S=u[v+1],_=fA(n,e,x,A,r);s[m]=A_(_,y,b,S,g)}return s}};function A_(i,t,e,n,r){let s=1-i;return s*s*s*t+3*s*s*i*e+3*s*i*i*n+i*i*i*r}function hA(i,t,e,n,r){let s=1-i;return 3*s*s*(e-t)+6*s*i*(n-e)+3*i*i*(r-n)}function fA(i,t,e,n,r){let s=(i-t)/(r-t);for(let o=0;o<8;o++){let a=A_(s,t,e,n,r)-i;if(Math.abs(a)<1e-10)break;let l=hA(s,t,e,n,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var Ei=class{constructor(t,e,n,r){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=zo(e,this.TimeBufferType),this.values=zo(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:zo(t.times,Array),values:zo(t.values,Array)};let r=t.getInterpolation();r!==t.DefaultInterpolation&&(n.interpolation=r),Wc(t.settings)&&(n.settings={inTangents:zo(t.settings.inTangents,Array),outTangents:zo(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new _u(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new xu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new yu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new vu(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ha:e=this.InterpolantFactoryMethodDiscrete;break;case su:e=this.InterpolantFactoryMethodLinear;break;case Yc:e=this.InterpolantFactoryMethodSmooth;break;case Gd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Zt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ha;case this.InterpolantFactoryMethodLinear:return su;case this.InterpolantFactoryMethodSmooth:return Yc;case this.InterpolantFactoryMethodBezier:return Gd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,r=e.length;n!==r;++n)e[n]+=t;Wc(this.settings)&&(Dx(this.settings.inTangents,t),Dx(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,r=e.length;n!==r;++n)e[n]*=t;Wc(this.settings)&&(Ox(this.settings.inTangents,t),Ox(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,r=n.length,s=0,o=r-1;for(;s!==r&&n[s]<t;)++s;for(;o!==-1&&n[o]>e;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,r=this.values,s=n.length;s===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==s;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){re("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){re("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(r!==void 0&&R1(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){re("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===Yc,s=t.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(r)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let m=0;m!==n;++m){let y=e[h+m];if(y!==e[f+m]||y!==e[d+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[h+d]}++o}}if(s>0){t[o]=t[s];for(let a=s*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,r=new n(this.name,t,e);return r.createInterpolant=this.createInterpolant,Wc(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Dx(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Ox(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}Ei.prototype.ValueTypeName="";Ei.prototype.TimeBufferType=Float32Array;Ei.prototype.ValueBufferType=Float32Array;Ei.prototype.DefaultInterpolation=su;var hs=class extends Ei{constructor(t,e,n){super(t,e,n)}};hs.prototype.ValueTypeName="bool";hs.prototype.ValueBufferType=Array;hs.prototype.DefaultInterpolation=Ha;hs.prototype.InterpolantFactoryMethodLinear=void 0;hs.prototype.InterpolantFactoryMethodSmooth=void 0;var bu=class extends Ei{constructor(t,e,n,r){super(t,e,n,r)}};bu.prototype.ValueTypeName="color";var wu=class extends Ei{constructor(t,e,n,r){super(t,e,n,r)}};wu.prototype.ValueTypeName="number";var Mu=class extends us{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(r-e),c=t*a;for(let u=c+a;c!==u;c+=4)kn.slerpFlat(s,0,o,c-a,o,c,l);return s}},ll=class extends Ei{constructor(t,e,n,r){super(t,e,n,r)}InterpolantFactoryMethodLinear(t){return new Mu(this.times,this.values,this.getValueSize(),t)}};ll.prototype.ValueTypeName="quaternion";ll.prototype.InterpolantFactoryMethodSmooth=void 0;var fs=class extends Ei{constructor(t,e,n){super(t,e,n)}};fs.prototype.ValueTypeName="string";fs.prototype.ValueBufferType=Array;fs.prototype.DefaultInterpolation=Ha;fs.prototype.InterpolantFactoryMethodLinear=void 0;fs.prototype.InterpolantFactoryMethodSmooth=void 0;var Su=class extends Ei{constructor(t,e,n,r){super(t,e,n,r)}};Su.prototype.ValueTypeName="vector";var Au=class{constructor(t,e,n){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],m=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},E_=new Au,Eu=class{constructor(t){this.manager=t!==void 0?t:E_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(r,s){n.load(t,r,e,s)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Eu.DEFAULT_MATERIAL_NAME="__DEFAULT";var cl=class extends Vn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ce(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},ul=class extends cl{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ce(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},zd=new ze,Ux=new z,kx=new z,Tu=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Kt(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new ze,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ls,this._frameExtents=new Kt(1,1),this._viewportCount=1,this._viewports=[new Ce(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Ux.setFromMatrixPosition(t.matrixWorld),e.position.copy(Ux),kx.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(kx),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,r){zd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(zd,t.coordinateSystem,t.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;t.coordinateSystem===$o||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(zd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},qc=new z,Xc=new kn,pr=new z,hl=class extends Vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ze,this.projectionMatrix=new ze,this.projectionMatrixInverse=new ze,this.coordinateSystem=Ui,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(qc,Xc,pr),pr.x===1&&pr.y===1&&pr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(qc,Xc,pr.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(qc,Xc,pr),pr.x===1&&pr.y===1&&pr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(qc,Xc,pr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},os=new z,Bx=new Kt,zx=new Kt,zn=class extends hl{constructor(t=50,e=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=jo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Va*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return jo*2*Math.atan(Math.tan(Va*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){os.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(os.x,os.y).multiplyScalar(-t/os.z),os.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(os.x,os.y).multiplyScalar(-t/os.z)}getViewSize(t,e){return this.getViewBounds(t,Bx,zx),e.subVectors(zx,Bx)}setViewOffset(t,e,n,r,s,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Va*.5*this.fov)/this.zoom,n=2*e,r=this.aspect*n,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,e-=o.offsetY*n/c,r*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(s+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var fl=class extends hl{constructor(t=-1,e=1,n=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-t,o=n+t,a=r+e,l=r-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Xd=class extends Tu{constructor(){super(new fl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},dl=class extends cl{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.target=new Vn,this.shadow=new Xd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var pl=class extends an{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Vo=-90,Go=1,na=class extends Vn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new zn(Vo,Go,t,e);r.layers=this.layers,this.add(r);let s=new zn(Vo,Go,t,e);s.layers=this.layers,this.add(s);let o=new zn(Vo,Go,t,e);o.layers=this.layers,this.add(o);let a=new zn(Vo,Go,t,e);a.layers=this.layers,this.add(a);let l=new zn(Vo,Go,t,e);l.layers=this.layers,this.add(l);let c=new zn(Vo,Go,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,r,s,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ui)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===$o)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,s),t.setRenderTarget(n,1,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Ru=class extends zn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Tp="\\[\\]\\.:\\/",dA=new RegExp("["+Tp+"]","g"),Rp="[^"+Tp+"]",pA="[^"+Tp.replace("\\.","")+"]",mA=/((?:WC+[\/:])*)/.source.replace("WC",Rp),gA=/(WCOD+)?/.source.replace("WCOD",pA),yA=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Rp),xA=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Rp),_A=new RegExp("^"+mA+gA+yA+xA+"$"),vA=["material","materials","bones","map"],$d=class{constructor(t,e,n){let r=n||je.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,r)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},je=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(dA,"")}static parseTrackName(t){let e=_A.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);vA.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},r=n(t.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)t[e++]=n[r]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,r=e.propertyName,s=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Zt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[r];if(o===void 0){let c=e.nodeName;re("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[s]!==void 0&&(s=t.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};je.Composite=$d;je.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};je.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};je.prototype.GetterByBindingType=[je.prototype._getValue_direct,je.prototype._getValue_array,je.prototype._getValue_arrayElement,je.prototype._getValue_toArray];je.prototype.SetterByBindingTypeAndVersioning=[[je.prototype._setValue_direct,je.prototype._setValue_direct_setNeedsUpdate,je.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[je.prototype._setValue_array,je.prototype._setValue_array_setNeedsUpdate,je.prototype._setValue_array_setMatrixWorldNeedsUpdate],[je.prototype._setValue_arrayElement,je.prototype._setValue_arrayElement_setNeedsUpdate,je.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[je.prototype._setValue_fromArray,je.prototype._setValue_fromArray_setNeedsUpdate,je.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var oF=new Float32Array(1);var ds=class extends Qa{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var ps=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=le(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(le(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Yd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,r){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,r){let s=this.elements;return s[0]=t,s[2]=e,s[1]=n,s[3]=r,this}};var Vx=new z,$c=new z,Ho=new z,Wo=new z,Vd=new z,bA=new z,wA=new z,ml=class{constructor(t=new z,e=new z){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){Vx.subVectors(t,this.start),$c.subVectors(this.end,this.start);let n=$c.dot($c);if(n===0)return 0;let s=$c.dot(Vx)/n;return e&&(s=le(s,0,1)),s}closestPointToPoint(t,e,n){let r=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(r).add(this.start)}distanceSqToLine3(t,e=bA,n=wA){let r=10000000000000001e-32,s,o,a=this.start,l=t.start,c=this.end,u=t.end;Ho.subVectors(c,a),Wo.subVectors(u,l),Vd.subVectors(a,l);let h=Ho.dot(Ho),f=Wo.dot(Wo),d=Wo.dot(Vd);if(h<=r&&f<=r)return e.copy(a),n.copy(l),e.distanceToSquared(n);if(h<=r)s=0,o=d/f,o=le(o,0,1);else{let m=Ho.dot(Vd);if(f<=r)o=0,s=le(-m/h,0,1);else{let y=Ho.dot(Wo),g=h*f-y*y;g!==0?s=le((y*d-m*f)/g,0,1):s=0,o=(y*s+d)/f,o<0?(o=0,s=le(-m/h,0,1)):o>1&&(o=1,s=le((y-m)/h,0,1))}}return e.copy(a).addScaledVector(Ho,s),n.copy(l).addScaledVector(Wo,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Gs=class extends du{constructor(t=10,e=10,n=4473924,r=8947848){n=new ce(n),r=new ce(r);let s=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,m=-a;f<=e;f++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let y=f===s?n:r;y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3}let u=new an;u.setAttribute("position",new Ve(l,3)),u.setAttribute("color",new Ve(c,3));let h=new Qo({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var gl=class extends Ki{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Cp(i,t,e,n){let r=MA(n);switch(e){case dp:return i*t;case mp:return i*t/r.components*r.byteLength;case Ou:return i*t/r.components*r.byteLength;case xs:return i*t*2/r.components*r.byteLength;case Uu:return i*t*2/r.components*r.byteLength;case pp:return i*t*3/r.components*r.byteLength;case rr:return i*t*4/r.components*r.byteLength;case ku:return i*t*4/r.components*r.byteLength;case xl:case _l:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case vl:case bl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case zu:case Gu:return Math.max(i,16)*Math.max(t,8)/4;case Bu:case Vu:return Math.max(i,8)*Math.max(t,8)/2;case Hu:case Wu:case Xu:case $u:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case qu:case wl:case Yu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ju:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Zu:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Ju:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Ku:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Qu:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case th:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case eh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case nh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case ih:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case rh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case sh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case oh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case ah:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case lh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case ch:case uh:case hh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case fh:case dh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ml:case ph:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function MA(i){switch(i){case ui:case cp:return{byteLength:1,components:1};case oa:case up:case ir:return{byteLength:2,components:1};case Nu:case Du:return{byteLength:2,components:4};case er:case Fu:case nr:return{byteLength:4,components:1};case hp:case fp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Zt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Y_(){let i=null,t=!1,e=null,n=null;function r(s,o){n=i.requestAnimationFrame(r),e(s,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(r),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(s){e=s},setContext:function(s){i=s}}}function CA(i){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<h.length;d++){let m=h[f],y=h[d];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,m=h.length;d<m;d++){let y=h[d];i.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var PA=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,IA=`#ifdef USE_ALPHAHASH
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
#endif`,LA=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,FA=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,NA=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,DA=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,OA=`#ifdef USE_AOMAP
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
#endif`,UA=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kA=`#ifdef USE_BATCHING
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
#endif`,BA=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,zA=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,VA=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,GA=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,HA=`#ifdef USE_IRIDESCENCE
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
#endif`,WA=`#ifdef USE_BUMPMAP
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
#endif`,qA=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,XA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,$A=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,YA=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,jA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ZA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,JA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,KA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,QA=`#define PI 3.141592653589793
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
} // validated`,tE=`vec3 transformedNormal = objectNormal;
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
#endif`,eE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,nE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,iE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,rE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,sE="gl_FragColor = linearToOutputTexel( gl_FragColor );",oE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,aE=`#ifdef USE_ENVMAP
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
#endif`,lE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,cE=`#ifdef USE_ENVMAP
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
#endif`,uE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,hE=`#ifdef USE_ENVMAP
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
#endif`,fE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,dE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,pE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,mE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,gE=`#ifdef USE_GRADIENTMAP
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
}`,yE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,xE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,_E=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,vE=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,bE=`#ifdef USE_ENVMAP
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
#endif`,wE=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ME=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,SE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,AE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,EE=`PhysicalMaterial material;
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
#endif`,TE=`uniform sampler2D dfgLUT;
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
}`,RE=`
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
#endif`,CE=`#if defined( RE_IndirectDiffuse )
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
#endif`,PE=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,IE=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,LE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,FE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,NE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,DE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,OE=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,UE=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kE=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,BE=`#if defined( USE_POINTS_UV )
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
#endif`,zE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,VE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,GE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,HE=`#if defined( USE_MORPHCOLORS )
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
#endif`,WE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qE=`#ifdef USE_MORPHTARGETS
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
#endif`,XE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$E=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,YE=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,jE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ZE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,JE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,KE=`#ifdef USE_NORMALMAP
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
#endif`,QE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,tT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,eT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,nT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,iT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,rT=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,sT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,oT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,aT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,lT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,cT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uT=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,hT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,fT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,dT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,pT=`float getShadowMask() {
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
}`,mT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,gT=`#ifdef USE_SKINNING
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
#endif`,yT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,xT=`#ifdef USE_SKINNING
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
#endif`,_T=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,vT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,bT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,wT=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,MT=`#ifdef USE_TRANSMISSION
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
#endif`,ST=`#ifdef USE_TRANSMISSION
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
#endif`,AT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ET=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,TT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,RT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,CT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,PT=`uniform sampler2D t2D;
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
}`,IT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,LT=`uniform float backgroundBlurriness;
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
}`,FT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DT=`#include <common>
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
}`,OT=`#if DEPTH_PACKING == 3200
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
}`,UT=`#define DISTANCE
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
}`,kT=`#define DISTANCE
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
}`,BT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,zT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VT=`uniform float scale;
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
}`,GT=`uniform vec3 diffuse;
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
}`,HT=`#include <common>
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
}`,WT=`uniform vec3 diffuse;
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
}`,qT=`#define LAMBERT
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
}`,XT=`#define LAMBERT
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
}`,$T=`#define MATCAP
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
}`,YT=`#define MATCAP
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
}`,jT=`#define NORMAL
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
}`,ZT=`#define NORMAL
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
}`,JT=`#define PHONG
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
}`,KT=`#define PHONG
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
}`,QT=`#define STANDARD
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
}`,tR=`#define STANDARD
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
}`,eR=`#define TOON
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
}`,nR=`#define TOON
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
}`,iR=`uniform float size;
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
}`,rR=`uniform vec3 diffuse;
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
}`,sR=`#include <common>
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
}`,oR=`uniform vec3 color;
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
}`,aR=`uniform float rotation;
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
}`,lR=`uniform vec3 diffuse;
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
}`,fe={alphahash_fragment:PA,alphahash_pars_fragment:IA,alphamap_fragment:LA,alphamap_pars_fragment:FA,alphatest_fragment:NA,alphatest_pars_fragment:DA,aomap_fragment:OA,aomap_pars_fragment:UA,batching_pars_vertex:kA,batching_vertex:BA,begin_vertex:zA,beginnormal_vertex:VA,bsdfs:GA,iridescence_fragment:HA,bumpmap_pars_fragment:WA,clipping_planes_fragment:qA,clipping_planes_pars_fragment:XA,clipping_planes_pars_vertex:$A,clipping_planes_vertex:YA,color_fragment:jA,color_pars_fragment:ZA,color_pars_vertex:JA,color_vertex:KA,common:QA,defaultnormal_vertex:tE,displacementmap_pars_vertex:eE,displacementmap_vertex:nE,emissivemap_fragment:iE,emissivemap_pars_fragment:rE,colorspace_fragment:sE,colorspace_pars_fragment:oE,envmap_fragment:aE,envmap_common_pars_fragment:lE,envmap_pars_fragment:cE,envmap_pars_vertex:uE,envmap_physical_pars_fragment:bE,envmap_vertex:hE,fog_vertex:fE,fog_pars_vertex:dE,fog_fragment:pE,fog_pars_fragment:mE,gradientmap_pars_fragment:gE,lightmap_pars_fragment:yE,lights_lambert_fragment:xE,lights_lambert_pars_fragment:_E,lights_pars_begin:vE,lights_toon_fragment:wE,lights_toon_pars_fragment:ME,lights_phong_fragment:SE,lights_phong_pars_fragment:AE,lights_physical_fragment:EE,lights_physical_pars_fragment:TE,lights_fragment_begin:RE,lights_fragment_maps:CE,lights_fragment_end:PE,lightprobes_pars_fragment:IE,logdepthbuf_fragment:LE,logdepthbuf_pars_fragment:FE,logdepthbuf_pars_vertex:NE,logdepthbuf_vertex:DE,map_fragment:OE,map_pars_fragment:UE,map_particle_fragment:kE,map_particle_pars_fragment:BE,metalnessmap_fragment:zE,metalnessmap_pars_fragment:VE,morphinstance_vertex:GE,morphcolor_vertex:HE,morphnormal_vertex:WE,morphtarget_pars_vertex:qE,morphtarget_vertex:XE,normal_fragment_begin:$E,normal_fragment_maps:YE,normal_pars_fragment:jE,normal_pars_vertex:ZE,normal_vertex:JE,normalmap_pars_fragment:KE,clearcoat_normal_fragment_begin:QE,clearcoat_normal_fragment_maps:tT,clearcoat_pars_fragment:eT,iridescence_pars_fragment:nT,opaque_fragment:iT,packing:rT,premultiplied_alpha_fragment:sT,project_vertex:oT,dithering_fragment:aT,dithering_pars_fragment:lT,roughnessmap_fragment:cT,roughnessmap_pars_fragment:uT,shadowmap_pars_fragment:hT,shadowmap_pars_vertex:fT,shadowmap_vertex:dT,shadowmask_pars_fragment:pT,skinbase_vertex:mT,skinning_pars_vertex:gT,skinning_vertex:yT,skinnormal_vertex:xT,specularmap_fragment:_T,specularmap_pars_fragment:vT,tonemapping_fragment:bT,tonemapping_pars_fragment:wT,transmission_fragment:MT,transmission_pars_fragment:ST,uv_pars_fragment:AT,uv_pars_vertex:ET,uv_vertex:TT,worldpos_vertex:RT,background_vert:CT,background_frag:PT,backgroundCube_vert:IT,backgroundCube_frag:LT,cube_vert:FT,cube_frag:NT,depth_vert:DT,depth_frag:OT,distance_vert:UT,distance_frag:kT,equirect_vert:BT,equirect_frag:zT,linedashed_vert:VT,linedashed_frag:GT,meshbasic_vert:HT,meshbasic_frag:WT,meshlambert_vert:qT,meshlambert_frag:XT,meshmatcap_vert:$T,meshmatcap_frag:YT,meshnormal_vert:jT,meshnormal_frag:ZT,meshphong_vert:JT,meshphong_frag:KT,meshphysical_vert:QT,meshphysical_frag:tR,meshtoon_vert:eR,meshtoon_frag:nR,points_vert:iR,points_frag:rR,shadow_vert:sR,shadow_frag:oR,sprite_vert:aR,sprite_frag:lR},It={common:{diffuse:{value:new ce(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new Kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ce(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ce(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new ce(16777215)},opacity:{value:1},center:{value:new Kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},li={basic:{uniforms:Zn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:Zn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new ce(0)},envMapIntensity:{value:1}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:Zn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new ce(0)},specular:{value:new ce(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:Zn([It.common,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.roughnessmap,It.metalnessmap,It.fog,It.lights,{emissive:{value:new ce(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:Zn([It.common,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.gradientmap,It.fog,It.lights,{emissive:{value:new ce(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:Zn([It.common,It.bumpmap,It.normalmap,It.displacementmap,It.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:Zn([It.points,It.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:Zn([It.common,It.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:Zn([It.common,It.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:Zn([It.common,It.bumpmap,It.normalmap,It.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:Zn([It.sprite,It.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distance:{uniforms:Zn([It.common,It.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distance_vert,fragmentShader:fe.distance_frag},shadow:{uniforms:Zn([It.lights,It.fog,{color:{value:new ce(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};li.physical={uniforms:Zn([li.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new Kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new ce(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new Kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new ce(0)},specularColor:{value:new ce(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new Kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var gh={r:0,b:0,g:0},cR=new ze,j_=new se;j_.set(-1,0,0,0,1,0,0,0,1);function uR(i,t,e,n,r,s){let o=new ce(0),a=r===!0?0:1,l,c,u=null,h=0,f=null;function d(x){let b=x.isScene===!0?x.background:null;if(b&&b.isTexture){let v=x.backgroundBlurriness>0;b=t.get(b,v)}return b}function m(x){let b=!1,v=d(x);v===null?g(o,a):v&&v.isColor&&(g(v,1),b=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,s):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,s),(i.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(x,b){let v=d(b);v&&v.isCubeTexture?(c===void 0&&(c=new Ge(new cs(1,1,1),new Bi({name:"BackgroundCubeMaterial",uniforms:Ys(li.backgroundCube.uniforms),vertexShader:li.backgroundCube.vertexShader,fragmentShader:li.backgroundCube.fragmentShader,side:ai,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,S,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(cR.makeRotationFromEuler(b.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(j_),c.material.toneMapped=xe.getTransfer(v.colorSpace)!==Re,(u!==v||h!==v.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,f=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Ge(new zs(2,2),new Bi({name:"BackgroundMaterial",uniforms:Ys(li.background.uniforms),vertexShader:li.background.vertexShader,fragmentShader:li.background.fragmentShader,side:ys,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=xe.getTransfer(v.colorSpace)!==Re,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,f=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,b){x.getRGB(gh,Ep(i)),e.buffers.color.setClear(gh.r,gh.g,gh.b,b,s)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,b=1){o.set(x),a=b,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:m,addToRenderList:y,dispose:p}}function hR(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=f(null),s=r,o=!1;function a(P,O,B,F,V){let q=!1,G=h(P,F,B,O);s!==G&&(s=G,c(s.object)),q=d(P,F,B,V),q&&m(P,F,B,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,v(P,O,B,F),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(P){return i.bindVertexArray(P)}function u(P){return i.deleteVertexArray(P)}function h(P,O,B,F){let V=F.wireframe===!0,q=n[O.id];q===void 0&&(q={},n[O.id]=q);let G=P.isInstancedMesh===!0?P.id:0,rt=q[G];rt===void 0&&(rt={},q[G]=rt);let $=rt[B.id];$===void 0&&($={},rt[B.id]=$);let j=$[V];return j===void 0&&(j=f(l()),$[V]=j),j}function f(P){let O=[],B=[],F=[];for(let V=0;V<e;V++)O[V]=0,B[V]=0,F[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:B,attributeDivisors:F,object:P,attributes:{},index:null}}function d(P,O,B,F){let V=s.attributes,q=O.attributes,G=0,rt=B.getAttributes();for(let $ in rt)if(rt[$].location>=0){let tt=V[$],ut=q[$];if(ut===void 0&&($==="instanceMatrix"&&P.instanceMatrix&&(ut=P.instanceMatrix),$==="instanceColor"&&P.instanceColor&&(ut=P.instanceColor)),tt===void 0||tt.attribute!==ut||ut&&tt.data!==ut.data)return!0;G++}return s.attributesNum!==G||s.index!==F}function m(P,O,B,F){let V={},q=O.attributes,G=0,rt=B.getAttributes();for(let $ in rt)if(rt[$].location>=0){let tt=q[$];tt===void 0&&($==="instanceMatrix"&&P.instanceMatrix&&(tt=P.instanceMatrix),$==="instanceColor"&&P.instanceColor&&(tt=P.instanceColor));let ut={};ut.attribute=tt,tt&&tt.data&&(ut.data=tt.data),V[$]=ut,G++}s.attributes=V,s.attributesNum=G,s.index=F}function y(){let P=s.newAttributes;for(let O=0,B=P.length;O<B;O++)P[O]=0}function g(P){p(P,0)}function p(P,O){let B=s.newAttributes,F=s.enabledAttributes,V=s.attributeDivisors;B[P]=1,F[P]===0&&(i.enableVertexAttribArray(P),F[P]=1),V[P]!==O&&(i.vertexAttribDivisor(P,O),V[P]=O)}function x(){let P=s.newAttributes,O=s.enabledAttributes;for(let B=0,F=O.length;B<F;B++)O[B]!==P[B]&&(i.disableVertexAttribArray(B),O[B]=0)}function b(P,O,B,F,V,q,G){G===!0?i.vertexAttribIPointer(P,O,B,V,q):i.vertexAttribPointer(P,O,B,F,V,q)}function v(P,O,B,F){y();let V=F.attributes,q=B.getAttributes(),G=O.defaultAttributeValues;for(let rt in q){let $=q[rt];if($.location>=0){let j=V[rt];if(j===void 0&&(rt==="instanceMatrix"&&P.instanceMatrix&&(j=P.instanceMatrix),rt==="instanceColor"&&P.instanceColor&&(j=P.instanceColor)),j!==void 0){let tt=j.normalized,ut=j.itemSize,ct=t.get(j);if(ct===void 0)continue;let K=ct.buffer,gt=ct.type,yt=ct.bytesPerElement,Mt=gt===i.INT||gt===i.UNSIGNED_INT||j.gpuType===Fu;if(j.isInterleavedBufferAttribute){let xt=j.data,zt=xt.isInterleavedBuffer===!0?xt.stride:xt.itemSize,te=j.offset;if(xt.isInstancedInterleavedBuffer||xt.isInstancedBufferAttribute){for(let dt=0;dt<$.locationSize;dt++)p($.location+dt,xt.meshPerAttribute);P.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=xt.meshPerAttribute*xt.count)}else for(let dt=0;dt<$.locationSize;dt++)g($.location+dt);i.bindBuffer(i.ARRAY_BUFFER,K);for(let dt=0;dt<$.locationSize;dt++)b($.location+dt,ut/$.locationSize,gt,tt,zt*yt,(te+ut/$.locationSize*dt)*yt,Mt)}else{if(j.isInstancedBufferAttribute){for(let xt=0;xt<$.locationSize;xt++)p($.location+xt,j.meshPerAttribute);P.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let xt=0;xt<$.locationSize;xt++)g($.location+xt);i.bindBuffer(i.ARRAY_BUFFER,K);for(let xt=0;xt<$.locationSize;xt++)b($.location+xt,ut/$.locationSize,gt,tt,ut*yt,ut/$.locationSize*xt*yt,Mt)}}else if(G!==void 0){let tt=G[rt];if(tt!==void 0)switch(tt.length){case 2:i.vertexAttrib2fv($.location,tt);break;case 3:i.vertexAttrib3fv($.location,tt);break;case 4:i.vertexAttrib4fv($.location,tt);break;default:i.vertexAttrib1fv($.location,tt)}}}}x()}function A(){N();for(let P in n){let O=n[P];for(let B in O){let F=O[B];for(let V in F){let q=F[V];for(let G in q)u(q[G].object),delete q[G];delete F[V]}}delete n[P]}}function S(P){if(n[P.id]===void 0)return;let O=n[P.id];for(let B in O){let F=O[B];for(let V in F){let q=F[V];for(let G in q)u(q[G].object),delete q[G];delete F[V]}}delete n[P.id]}function _(P){for(let O in n){let B=n[O];for(let F in B){let V=B[F];if(V[P.id]===void 0)continue;let q=V[P.id];for(let G in q)u(q[G].object),delete q[G];delete V[P.id]}}}function w(P){for(let O in n){let B=n[O],F=P.isInstancedMesh===!0?P.id:0,V=B[F];if(V!==void 0){for(let q in V){let G=V[q];for(let rt in G)u(G[rt].object),delete G[rt];delete V[q]}delete B[F],Object.keys(B).length===0&&delete n[O]}}}function N(){C(),o=!0,s!==r&&(s=r,c(s.object))}function C(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:N,resetDefaultState:C,dispose:A,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:g,disableUnusedAttributes:x}}function fR(i,t,e){let n;function r(l){n=l}function s(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),e.update(c,n,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];e.update(f,n,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function dR(i,t,e,n){let r;function s(){if(r!==void 0)return r;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");r=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(_){return!(_!==rr&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let w=_===ir&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ui&&_!==nr&&!w&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Zt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&Zt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&Zt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),b=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),A=i.getParameter(i.MAX_SAMPLES),S=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:x,maxVaryings:b,maxFragmentUniforms:v,maxSamples:A,samples:S}}function pR(i){let t=this,e=null,n=0,r=!1,s=!1,o=new Si,a=new se,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||r;return r=f,n=h.length,d},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){let m=h.clippingPlanes,y=h.clipIntersection,g=h.clipShadows,p=i.get(h);if(!r||m===null||m.length===0||s&&!g)s?u(null):c();else{let x=s?0:n,b=x*4,v=p.clippingState||null;l.value=v,v=u(m,f,b,d);for(let A=0;A!==b;++A)v[A]=e[A];p.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,d,m){let y=h!==null?h.length:0,g=null;if(y!==0){if(g=l.value,m!==!0||g===null){let p=d+y*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<p)&&(g=new Float32Array(p));for(let b=0,v=d;b!==y;++b,v+=4)o.copy(h[b]).applyMatrix4(x,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,g}}var Rl=class extends Ai{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},r=[n,n,n,n,n,n];this.texture=new tl(r),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new cs(5,5,5),s=new Bi({name:"CubemapFromEquirect",uniforms:Ys(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ai,blending:Ws});s.uniforms.tEquirect.value=e;let o=new Ge(r,s),a=e.minFilter;return e.minFilter===Gr&&(e.minFilter=oi),new na(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,r=!0){let s=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,r);t.setRenderTarget(s)}},T_=256,mR=3,gR=20,Z_=256,J_=16,yR=3,xR=new z,_R=new ce,xh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new na(1,10,null),this._boxMesh=new Ge(new cs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,r=100,s={}){let{size:o=256,position:a=xR}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(_R));let g=new na(n,r,u);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=m,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=P_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=C_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(T_,Mp(t))}_fromTexture(t,e){t.mapping===Xs||t.mapping===sa?this._setSize(t.image.length===0?T_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=R_(t,!1,!1),n=Math.log2(t)-mR;for(let r=0;r<=n;r++)e.texture.mipmaps.push({width:t>>r,height:t>>r});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=R_(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=t,s.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),s.update(this._renderer,r),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Xs||t.mapping===sa?(this._cubemapMaterial===null&&(this._cubemapMaterial=P_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=C_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=vR(),this._integrationMaterial=bR());let e=this._cubeSize,n=t.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(e/J_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-yR)s.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Z_*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=wR());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(t,0,n),r.envMap.value=t.texture,this._renderCube(s,0,n)}};function R_(i,t,e){return new Rl(i,{minFilter:Gr,generateMipmaps:t,type:ir,colorSpace:Wa,depthBuffer:e})}function Cl(i,t,e){return new Bi({name:i,uniforms:t,vertexShader:fe.cube_vert,fragmentShader:e,side:ai,blending:Ws,depthTest:!1,depthWrite:!1})}function vR(){return Cl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Z_}u

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
	`)}function bR(){return Cl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:J_}},`

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
	`)}function wR(){return Cl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${gR}
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
	`)}function C_(){return Cl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function P_(){return Cl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function MR(i){let t=new WeakMap,e=new WeakMap,n=null;function r(f,d=!1){return f==null?null:d?o(f):s(f)}function s(f){if(f&&f.isTexture){let d=f.mapping;if(d===Pu||d===Iu)if(t.has(f)){let m=t.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let y=new Rl(m.height);return y.fromEquirectangularTexture(i,f),t.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,m=d===Pu||d===Iu,y=d===Xs||d===sa;if(m||y){let g=e.get(f),p=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return n===null&&(n=new xh(i)),g=m?n.fromEquirectangular(f,g):n.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),g.texture;if(g!==void 0)return g.texture;{let x=f.image;return m&&x&&x.height>0||y&&x&&l(x)?(n===null&&(n=new xh(i)),g=m?n.fromEquirectangular(f):n.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===Pu?f.mapping=Xs:d===Iu&&(f.mapping=sa),f}function l(f){let d=0,m=6;for(let y=0;y<m;y++)f[y]!==void 0&&d++;return d===m}function c(f){let d=f.target;d.removeEventListener("dispose",c);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function h(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:h}}function SR(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let r=i.getExtension(n);return t[n]=r,r}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let r=e(n);return r===null&&za("WebGLRenderer: "+n+" extension not supported."),r}}}function AR(i,t,e,n){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let y=s.get(m);y&&(t.remove(y),s.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,y){return r[y.id]!==void 0||(y.addEventListener("dispose",a),r[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(m){let y=m.attributes;for(let g in y)t.update(y[g],i.ARRAY_BUFFER)}function h(m){let y=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let x=y!==null?y.array.length:g.array.length/3-1,b=g.count>=65535?Ka:Ja,v=new b(Math.ceil(x/3)*6,1),A=v.array;if(y!==null){let _=y.array;p=y.version;for(let w=0,N=0;w<x;w+=3){let C=_[w+0],P=_[w+1],O=_[w+2];A[N++]=C,A[N++]=P,A[N++]=P,A[N++]=O,A[N++]=O,A[N++]=C}}else{p=g.version;for(let _=0,w=0;_<x;_+=3){let N=_+0,C=_+1,P=_+2;A[w++]=N,A[w++]=C,A[w++]=C,A[w++]=P,A[w++]=P,A[w++]=N}}v.version=p;let S=s.get(m);S&&t.remove(S),s.set(m,v)}function f(m){let y=s.get(m);if(y){let g=m.index;g!==null&&y.version<g.version&&h(m)}else h(m);return s.get(m)}function d(){for(let m in r){let y=r[m].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function ER(i,t,e){let n;function r(h){n=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,f){i.drawElements(n,f,s,h*o),e.update(f,n,1)}function c(h,f,d){d!==0&&(i.drawElementsInstanced(n,f,s,h*o,d),e.update(f,n,d))}function u(h,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,s,h,0,d);let y=0;for(let g=0;g<d;g++)y+=f[g];e.update(y,n,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function TR(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(s/3);break;case i.LINES:e.lines+=a*(s/2);break;case i.LINE_STRIP:e.lines+=a*(s-1);break;case i.LINE_LOOP:e.lines+=a*s;break;case i.POINTS:e.points+=a*s;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function r(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:r,update:n}}function RR(i,t,e){let n=new WeakMap,r=new Ce;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let N=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",N)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],b=0;d===!0&&(b=1),m===!0&&(b=2),y===!0&&(b=3);let v=a.attributes.position.count*b,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let S=new Float32Array(v*A*4*h),_=new Ya(S,v,A,h);_.type=nr,_.needsUpdate=!0;let w=b*4;for(let C=0;C<h;C++){let P=g[C],O=p[C],B=x[C],F=v*A*4*C;for(let V=0;V<P.count;V++){let q=V*w;d===!0&&(r.fromBufferAttribute(P,V),S[F+q+0]=r.x,S[F+q+1]=r.y,S[F+q+2]=r.z,S[F+q+3]=0),m===!0&&(r.fromBufferAttribute(O,V),S[F+q+4]=r.x,S[F+q+5]=r.y,S[F+q+6]=r.z,S[F+q+7]=0),y===!0&&(r.fromBufferAttribute(B,V),S[F+q+8]=r.x,S[F+q+9]=r.y,S[F+q+10]=r.z,S[F+q+11]=B.itemSize===4?r.w:1)}}f={count:h,texture:_,size:new Kt(v,A)},n.set(a,f),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:s}}function CR(i,t,e,n,r){let s=new WeakMap;function o(c){let u=r.render.frame,h=c.geometry,f=t.get(c,h);if(s.get(f)!==u&&(t.update(f),s.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;s.get(d)!==u&&(d.update(),s.set(d,u))}return f}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var PR={[ep]:"LINEAR_TONE_MAPPING",[np]:"REINHARD_TONE_MAPPING",[ip]:"CINEON_TONE_MAPPING",[rp]:"ACES_FILMIC_TONE_MAPPING",[op]:"AGX_TONE_MAPPING",[ap]:"NEUTRAL_TONE_MAPPING",[sp]:"CUSTOM_TONE_MAPPING"};function IR(i,t,e,n,r,s){let o=new Ai(t,e,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new an;u.setAttribute("position",new Ve([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ve([0,2,0,0,2,0],2));let h=new pu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Ge(u,h),d=new fl(-1,1,1,-1,0,1),m=null,y=null,g=!1,p,x=null,b=[],v=!1;this.setSize=function(A,S){o.setSize(A,S),a!==null&&a.setSize(A,S),l!==null&&l.setSize(A,S);for(let _=0;_<b.length;_++){let w=b[_];w.setSize&&w.setSize(A,S)}},this.setEffects=function(A){b=A,v=b.length>0&&b[0].isRenderPass===!0;let S=o.width,_=o.height;b.length>0&&a===null&&(a=new Ai(S,_,{type:ir,depthBuffer:!1,stencilBuffer:!1}),l=new Ai(S,_,{type:ir,depthBuffer:!1,stencilBuffer:!1}));let w=r===!0&&b.some(N=>N.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Vr(S,_),s===!0&&(c.format=Hr,c.type=$s)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let N=0;N<b.length;N++){let C=b[N];C.setSize&&C.setSize(S,_),w&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(A,S){if(g||A.toneMapping===xr&&b.length===0)return!1;if(x=S,S!==null){let _=S.width,w=S.height;(o.width!==_||o.height!==w)&&this.setSize(_,w)}return v===!1&&A.setRenderTarget(o),p=A.toneMapping,A.toneMapping=xr,!0},this.hasRenderPass=function(){return v},this.end=function(A,S){A.toneMapping=p,g=!0;let _=o,w=a;for(let N=0;N<b.length;N++){let C=b[N];C.enabled!==!1&&(C.render(A,w,_,S),C.needsSwap!==!1&&(_=w,w=w===a?l:a))}if(m!==A.outputColorSpace||y!==A.toneMapping){m=A.outputColorSpace,y=A.toneMapping,h.defines={},xe.getTransfer(m)===Re&&(h.defines.SRGB_TRANSFER="");let N=PR[y];N&&(h.defines[N]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(x),A.render(f,d),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var K_=new ci,Q_=new Vr(1,1),tv=new el(1),ev=new Ya,nv=new lu,iv=new tl,I_=[],L_=[],F_=new Float32Array(16),N_=new Float32Array(9),D_=new Float32Array(4);function la(i,t,e){let n=i[0];if(n<=0||n>0)return i;let r=t*e,s=I_[r];if(s===void 0&&(s=new Float32Array(r),I_[r]=s),t!==0){n.toArray(s,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(s,a)}return s}function En(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Tn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function vh(i,t){let e=L_[t];e===void 0&&(e=new Int32Array(t),L_[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function LR(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function FR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(En(e,t))return;i.uniform2fv(this.addr,t),Tn(e,t)}}function NR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(En(e,t))return;i.uniform3fv(this.addr,t),Tn(e,t)}}function DR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(En(e,t))return;i.uniform4fv(this.addr,t),Tn(e,t)}}function OR(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(En(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Tn(e,t)}else{if(En(e,n))return;D_.set(n),i.uniformMatrix2fv(this.addr,!1,D_),Tn(e,n)}}function UR(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(En(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Tn(e,t)}else{if(En(e,n))return;N_.set(n),i.uniformMatrix3fv(this.addr,!1,N_),Tn(e,n)}}function kR(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(En(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Tn(e,t)}else{if(En(e,n))return;F_.set(n),i.uniformMatrix4fv(this.addr,!1,F_),Tn(e,n)}}function BR(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function zR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(En(e,t))return;i.uniform2iv(this.addr,t),Tn(e,t)}}function VR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(En(e,t))return;i.uniform3iv(this.addr,t),Tn(e,t)}}function GR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(En(e,t))return;i.uniform4iv(this.addr,t),Tn(e,t)}}function HR(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function WR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(En(e,t))return;i.uniform2uiv(this.addr,t),Tn(e,t)}}function qR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(En(e,t))return;i.uniform3uiv(this.addr,t),Tn(e,t)}}function XR(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(En(e,t))return;i.uniform4uiv(this.addr,t),Tn(e,t)}}function bh(i){return i.version===0&&(i.compareFunction=xp,i.needsUpdate=!0),i}function $R(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=bh(Q_):s=K_,e.setTexture2D(t||s,r)}function YR(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),e.setTexture3D(t||nv,r)}function jR(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=bh(tv):s=iv,e.setTextureCube(t||s,r)}function ZR(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),e.setTexture2DArray(t||ev,r)}function JR(i){switch(i){case 5126:return LR;case 35664:return FR;case 35665:return NR;case 35666:return DR;case 35674:return OR;case 35675:return UR;case 35676:return kR;case 5124:case 35670:return BR;case 35667:case 35671:return zR;case 35668:case 35672:return VR;case 35669:case 35673:return GR;case 5125:return HR;case 36294:return WR;case 36295:return qR;case 36296:return XR;case 35678:case 36198:case 36298:case 36306:case 35682:return $R;case 35679:case 36299:case 36307:return YR;case 35680:case 36300:case 36308:case 36293:return jR;case 36289:case 36303:case 36311:case 36292:return ZR}}function KR(i,t){i.uniform1fv(this.addr,t)}function QR(i,t){let e=la(t,this.size,2);i.uniform2fv(this.addr,e)}function tC(i,t){let e=la(t,this.size,3);i.uniform3fv(this.addr,e)}function eC(i,t){let e=la(t,this.size,4);i.uniform4fv(this.addr,e)}function nC(i,t){let e=la(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function iC(i,t){let e=la(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function rC(i,t){let e=la(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function sC(i,t){i.uniform1iv(this.addr,t)}function oC(i,t){i.uniform2iv(this.addr,t)}function aC(i,t){i.uniform3iv(this.addr,t)}function lC(i,t){i.uniform4iv(this.addr,t)}function cC(i,t){i.uniform1uiv(this.addr,t)}function uC(i,t){i.uniform2uiv(this.addr,t)}function hC(i,t){i.uniform3uiv(this.addr,t)}function fC(i,t){i.uniform4uiv(this.addr,t)}function dC(i,t,e){let n=this.cache,r=t.length,s=vh(e,r);En(n,s)||(i.uniform1iv(this.addr,s),Tn(n,s));let o;this.type===i.SAMPLER_2D_SHADOW?o=bh(Q_):o=K_;for(let a=0;a!==r;++a)e.setTexture2D(t[a]||o,s[a])}function pC(i,t,e){let n=this.cache,r=t.length,s=vh(e,r);En(n,s)||(i.uniform1iv(this.addr,s),Tn(n,s));for(let o=0;o!==r;++o)e.setTexture3D(t[o]||nv,s[o])}function mC(i,t,e){let n=this.cache,r=t.length,s=vh(e,r);En(n,s)||(i.uniform1iv(this.addr,s),Tn(n,s));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=bh(tv):o=iv;for(let a=0;a!==r;++a)e.setTextureCube(t[a]||o,s[a])}function gC(i,t,e){let n=this.cache,r=t.length,s=vh(e,r);En(n,s)||(i.uniform1iv(this.addr,s),Tn(n,s));for(let o=0;o!==r;++o)e.setTexture2DArray(t[o]||ev,s[o])}function yC(i){switch(i){case 5126:return KR;case 35664:return QR;case 35665:return tC;case 35666:return eC;case 35674:return nC;case 35675:return iC;case 35676:return rC;case 5124:case 35670:return sC;case 35667:case 35671:return oC;case 35668:case 35672:return aC;case 35669:case 35673:return lC;case 5125:return cC;case 36294:return uC;case 36295:return hC;case 36296:return fC;case 35678:case 36198:case 36298:case 36306:case 35682:return dC;case 35679:case 36299:case 36307:return pC;case 35680:case 36300:case 36308:case 36293:return mC;case 36289:case 36303:case 36311:case 36292:return gC}}var Lp=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=JR(e.type)}},Fp=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=yC(e.type)}},Np=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(t,e[a.id],n)}}},Pp=/(\w+)(\])?(\[|\.)?/g;function O_(i,t){i.seq.push(t),i.map[t.id]=t}function xC(i,t,e){let n=i.name,r=n.length;for(Pp.lastIndex=0;;){let s=Pp.exec(n),o=Pp.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){O_(e,c===void 0?new Lp(a,i,t):new Fp(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new Np(a),O_(e,h)),e=h}}}var aa=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);xC(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(t,e,n,r){let s=this.map[e];s!==void 0&&s.setValue(t,n,r)}setOptional(t,e,n){let r=e[n];r!==void 0&&this.setValue(t,n,r)}static upload(t,e,n,r){for(let s=0,o=e.length;s!==o;++s){let a=e[s],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,r)}}static seqWithValue(t,e){let n=[];for(let r=0,s=t.length;r!==s;++r){let o=t[r];o.id in e&&n.push(o)}return n}};function U_(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var _C=37297,vC=0;function bC(i,t){let e=i.split(`
`),n=[],r=Math.max(t-6,0),s=Math.min(t+6,e.length);for(let o=r;o<s;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var k_=new se;function wC(i){xe._getMatrix(k_,xe.workingColorSpace,i);let t=`mat3( ${k_.elements.map(e=>e.toFixed(4))} )`;switch(xe.getTransfer(i)){case qa:return[t,"LinearTransferOETF"];case Re:return[t,"sRGBTransferOETF"];default:return Zt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function B_(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),s=(i.getShaderInfoLog(t)||"").trim();if(n&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+s+`

`+bC(i.getShaderSource(t),a)}else return s}function MC(i,t){let e=wC(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var SC={[ep]:"Linear",[np]:"Reinhard",[ip]:"Cineon",[rp]:"ACESFilmic",[op]:"AgX",[ap]:"Neutral",[sp]:"Custom"};function AC(i,t){let e=SC[t];return e===void 0?(Zt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var yh=new z;function EC(){xe.getLuminanceCoefficients(yh);let i=yh.x.toFixed(4),t=yh.y.toFixed(4),e=yh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function TC(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Tl).join(`
`)}function RC(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function CC(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(t,r),o=s.name,a=1;s.type===i.FLOAT_MAT2&&(a=2),s.type===i.FLOAT_MAT3&&(a=3),s.type===i.FLOAT_MAT4&&(a=4),e[o]={type:s.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Tl(i){return i!==""}function z_(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function V_(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var PC=/^[ \t]*#include +<([\w\d./]+)>/gm;function Dp(i){return i.replace(PC,IC)}function IC(i,t){let e=fe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Dp(e)}var LC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function G_(i){return i.replace(LC,FC)}function FC(i,t,e,n){let r="";for(let s=parseInt(t);s<parseInt(e);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function H_(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var NC={[Hs]:"SHADOWMAP_TYPE_PCF",[ia]:"SHADOWMAP_TYPE_VSM"};function DC(i){return NC[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var OC={[sa]:"ENVMAP_MODE_REFRACTION"};function UC(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":OC[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kC={[Cu]:"ENVMAP_BLENDING_MULTIPLY",[c_]:"ENVMAP_BLENDING_MIX",[u_]:"ENVMAP_BLENDING_ADD"};function BC(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":kC[i.combine]||"ENVMAP_BLENDING_NONE"}function zC(i,t,e,n){let r=i.getContext(),s=e.defines,o=e.vertexShader,a=e.fragmentShader,l=DC(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=UC(e),h=BC(e),f=TC(e),d=RC(s),m=r.createProgram(),y,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Tl).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Tl).join(`
`),g.length>0&&(g+=`
`)):(y=[H_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Tl).join(`
`),g=[H_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==xr?"#define TONE_MAPPING":"",e.toneMapping!==xr?fe.tonemapping_pars_fragment:"",e.toneMapping!==xr?AC("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,MC("linearToOutputTexel",e.outputColorSpace),EC(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Tl).join(`
`)),o=Dp(o),o=z_(o,e),o=V_(o,e),a=Dp(a),a=z_(a,e),a=V_(a,e),o=G_(o),a=G_(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",e.glslVersion===bp?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===bp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=p+y+o,b=p+g+a,v=U_(r,r.VERTEX_SHADER,x),A=U_(r,r.FRAGMENT_SHADER,b);r.attachShader(m,v),r.attachShader(m,A),e.index0AttributeName!==void 0?r.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function S(C){if(i.debug.checkShaderErrors){let P=r.getProgramInfoLog(m)||"",O=r.getShaderInfoLog(v)||"",B=r.getShaderInfoLog(A)||"",F=P.trim(),V=O.trim(),q=B.trim(),G=!0,rt=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,m,v,A);else{let $=B_(r,v,"vertex"),j=B_(r,A,"fragment");re("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+F+`
`+$+`
`+j)}else F!==""?Zt("WebGLProgram: Program Info Log:",F):(V===""||q==="")&&(rt=!1);rt&&(C.diagnostics={runnable:G,programLog:F,vertexShader:{log:V,prefix:y},fragmentShader:{log:q,prefix:g}})}r.deleteShader(v),r.deleteShader(A),_=new aa(r,m),w=CC(r,m)}let _;this.getUniforms=function(){return _===void 0&&S(this),_};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=r.getProgramParameter(m,_C)),N},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=vC++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=v,this.fragmentShader=A,this}var VC=0,Op=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let r=this._getShaderCacheForMaterial(t);return r.has(e)===!1&&(r.add(e),e.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Up(t),e.set(t,n)),n}},Up=class{constructor(t){this.id=VC++,this.code=t,this.usedTimes=0}};function GC(i){return i===xs||i===wl||i===Ml}function HC(i,t,e,n,r,s){let o=new ja,a=new Op,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,w,N,C,P,O){let B=C.fog,F=P.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?C.environment:null,q=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,G=t.get(_.envMap||V,q),rt=f[_.type],$=n.precision;_.precision!==null&&($=n.getMaxPrecision(_.precision),$!==_.precision&&Zt("WebGLProgram.getParameters:",_.precision,"not supported, using",$,"instead."));let j=F.morphAttributes.position||F.morphAttributes.normal||F.morphAttributes.color,tt=j!==void 0?j.length:0,ut=0;F.morphAttributes.position!==void 0&&(ut=1),F.morphAttributes.normal!==void 0&&(ut=2),F.morphAttributes.color!==void 0&&(ut=3);let ct,K,gt,yt;if(rt){let Ct=li[rt];ct=Ct.vertexShader,K=Ct.fragmentShader}else{ct=_.vertexShader,K=_.fragmentShader;let Ct=a.getVertexShaderStage(_),ue=a.getFragmentShaderStage(_);a.update(_,Ct,ue),gt=Ct.id,yt=ue.id}let Mt=i.getRenderTarget(),xt=i.state.buffers.depth.getReversed(),zt=P.isInstancedMesh===!0,te=P.isBatchedMesh===!0,dt=!!_.map,Wt=!!_.matcap,qt=!!G,Yt=qt&&G.isPMREMTexture===!0,_e=!!_.aoMap,Ne=!!_.lightMap,un=!!_.bumpMap&&_.wireframe===!1,De=!!_.normalMap,Cn=!!_.displacementMap,ve=!!_.emissiveMap,_n=!!_.metalnessMap,Qe=!!_.roughnessMap,hn=_.anisotropy>0,k=_.clearcoat>0,Pt=_.diffuseRoughness>0,Jt=_.dispersion>0,ae=_.retroreflectivity>0,At=_.iridescence>0,Ue=_.sheen>0,Gt=_.transmission>0,jt=hn&&!!_.anisotropyMap,I=k&&!!_.clearcoatMap,E=k&&!!_.clearcoatNormalMap,X=k&&!!_.clearcoatRoughnessMap,ft=Pt&&!!_.diffuseRoughnessMap,ot=At&&!!_.iridescenceMap,vt=At&&!!_.iridescenceThicknessMap,bt=Ue&&!!_.sheenColorMap,et=Ue&&!!_.sheenRoughnessMap,it=!!_.specularMap,mt=!!_.specularColorMap,U=!!_.specularIntensityMap,st=Gt&&!!_.transmissionMap,nt=Gt&&!!_.thicknessMap,Et=!!_.gradientMap,_t=!!_.alphaMap,St=_.alphaTest>0,Ht=!!_.alphaHash,ee=!!_.extensions,ht=xr;_.toneMapped&&(Mt===null||Mt.isXRRenderTarget===!0)&&(ht=i.toneMapping);let kt=Yt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,ne={shaderID:rt,shaderType:_.type,shaderName:_.name,vertexShader:ct,fragmentShader:K,defines:_.defines,customVertexShaderID:gt,customFragmentShaderID:yt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:$,batching:te,batchingColor:te&&P._colorsTexture!==null,instancing:zt,instancingColor:zt&&P.instanceColor!==null,instancingMorph:zt&&P.morphTexture!==null,outputColorSpace:Mt===null?i.outputColorSpace:Mt.isXRRenderTarget===!0?Mt.texture.colorSpace:xe.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:dt,matcap:Wt,envMap:qt,envMapMode:qt&&G.mapping,envMapPMREM:Yt,envMapMaxLod:Yt?kt.length-1:null,envMapSize:Yt?kt[0].width:null,aoMap:_e,lightMap:Ne,bumpMap:un,normalMap:De,displacementMap:Cn,emissiveMap:ve,normalMapObjectSpace:De&&_.normalMapType===d_,normalMapTangentSpace:De&&_.normalMapType===Sl,packedNormalMap:De&&_.normalMapType===Sl&&GC(_.normalMap.format),metalnessMap:_n,roughnessMap:Qe,anisotropy:hn,anisotropyMap:jt,clearcoat:k,clearcoatMap:I,clearcoatNormalMap:E,clearcoatRoughnessMap:X,diffuseRoughness:Pt,diffuseRoughnessMap:ft,dispersion:Jt,retroreflection:ae,iridescence:At,iridescenceMap:ot,iridescenceThicknessMap:vt,sheen:Ue,sheenColorMap:bt,sheenRoughnessMap:et,specularMap:it,specularColorMap:mt,specularIntensityMap:U,transmission:Gt,transmissionMap:st,thicknessMap:nt,gradientMap:Et,opaque:_.transparent===!1&&_.blending===ra&&_.alphaToCoverage===!1,alphaMap:_t,alphaTest:St,alphaHash:Ht,combine:_.combine,mapUv:dt&&d(_.map.channel),aoMapUv:_e&&d(_.aoMap.channel),lightMapUv:Ne&&d(_.lightMap.channel),bumpMapUv:un&&d(_.bumpMap.channel),normalMapUv:De&&d(_.normalMap.channel),displacementMapUv:Cn&&d(_.displacementMap.channel),emissiveMapUv:ve&&d(_.emissiveMap.channel),metalnessMapUv:_n&&d(_.metalnessMap.channel),roughnessMapUv:Qe&&d(_.roughnessMap.channel),anisotropyMapUv:jt&&d(_.anisotropyMap.channel),clearcoatMapUv:I&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:bt&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:et&&d(_.sheenRoughnessMap.channel),specularMapUv:it&&d(_.specularMap.channel),specularColorMapUv:mt&&d(_.specularColorMap.channel),specularIntensityMapUv:U&&d(_.specularIntensityMap.channel),transmissionMapUv:st&&d(_.transmissionMap.channel),thicknessMapUv:nt&&d(_.thicknessMap.channel),alphaMapUv:_t&&d(_.alphaMap.channel),vertexTangents:!!F.attributes.tangent&&(De||hn),vertexNormals:!!F.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!F.attributes.color&&F.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!F.attributes.uv&&(dt||_t),fog:!!B,useFog:_.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||F.attributes.normal===void 0&&De===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:xt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:F.attributes.position!==void 0,morphTargets:F.morphAttributes.position!==void 0,morphNormals:F.morphAttributes.normal!==void 0,morphColors:F.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:ut,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:O.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:ht,decodeVideoTexture:dt&&_.map.isVideoTexture===!0&&xe.getTransfer(_.map.colorSpace)===Re,decodeVideoTextureEmissive:ve&&_.emissiveMap.isVideoTexture===!0&&xe.getTransfer(_.emissiveMap.colorSpace)===Re,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===zi,flipSided:_.side===ai,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ee&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&_.extensions.multiDraw===!0||te)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ne.vertexUv1s=l.has(1),ne.vertexUv2s=l.has(2),ne.vertexUv3s=l.has(3),l.clear(),ne}function y(_){let w=[];if(_.shaderID?w.push(_.shaderID):(w.push(_.customVertexShaderID),w.push(_.customFragmentShaderID)),_.defines!==void 0)for(let N in _.defines)w.push(N),w.push(_.defines[N]);return _.isRawShaderMaterial===!1&&(g(w,_),p(w,_),w.push(i.outputColorSpace)),w.push(_.customProgramCacheKey),w.join()}function g(_,w){_.push(w.precision),_.push(w.outputColorSpace),_.push(w.envMapMode),_.push(w.envMapPMREM),_.push(w.envMapMaxLod),_.push(w.envMapSize),_.push(w.mapUv),_.push(w.alphaMapUv),_.push(w.lightMapUv),_.push(w.aoMapUv),_.push(w.bumpMapUv),_.push(w.normalMapUv),_.push(w.displacementMapUv),_.push(w.emissiveMapUv),_.push(w.metalnessMapUv),_.push(w.roughnessMapUv),_.push(w.anisotropyMapUv),_.push(w.clearcoatMapUv),_.push(w.clearcoatNormalMapUv),_.push(w.clearcoatRoughnessMapUv),_.push(w.diffuseRoughnessMapUv),_.push(w.iridescenceMapUv),_.push(w.iridescenceThicknessMapUv),_.push(w.sheenColorMapUv),_.push(w.sheenRoughnessMapUv),_.push(w.specularMapUv),_.push(w.specularColorMapUv),_.push(w.specularIntensityMapUv),_.push(w.transmissionMapUv),_.push(w.thicknessMapUv),_.push(w.combine),_.push(w.fogExp2),_.push(w.sizeAttenuation),_.push(w.morphTargetsCount),_.push(w.numSunLights),_.push(w.numDirLights),_.push(w.numPointLights),_.push(w.numSpotLights),_.push(w.numSpotLightMaps),_.push(w.numHemiLights),_.push(w.numRectAreaLights),_.push(w.numSunLightShadows),_.push(w.numDirLightShadows),_.push(w.numPointLightShadows),_.push(w.numSpotLightShadows),_.push(w.numSpotLightShadowsWithMaps),_.push(w.numLightProbes),_.push(w.numLightProbeGrids),_.push(w.shadowMapType),_.push(w.toneMapping),_.push(w.numClippingPlanes),_.push(w.numClipIntersection),_.push(w.depthPacking)}function p(_,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let w=f[_.type],N;if(w){let C=li[w];N=Al.clone(C.uniforms)}else N=_.uniforms;return N}function b(_,w){let N=u.get(w);return N!==void 0?++N.usedTimes:(N=new zC(i,w,_,r),c.push(N),u.set(w,N)),N}function v(_){if(--_.usedTimes===0){let w=c.indexOf(_);c[w]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function S(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:x,acquireProgram:b,releaseProgram:v,releaseShaderCache:A,programs:c,dispose:S}}function WC(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function r(o,a,l){i.get(o)[a]=l}function s(){i=new WeakMap}return{has:t,get:e,remove:n,update:r,dispose:s}}function qC(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function W_(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function q_(){let i=[],t=0,e=[],n=[],r=[];function s(){t=0,e.length=0,n.length=0,r.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,m,y,g,p){let x=i[t];return x===void 0?(x={id:f.id,object:f,geometry:d,material:m,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:g,group:p},i[t]=x):(x.id=f.id,x.object=f,x.geometry=d,x.material=m,x.materialVariant=o(f),x.groupOrder=y,x.renderOrder=f.renderOrder,x.z=g,x.group=p),t++,x}function l(f,d,m,y,g,p,x){x.reversedDepth===!0&&(g=-g);let b=a(f,d,m,y,g,p);m.transmission>0?n.push(b):m.transparent===!0?r.push(b):e.push(b)}function c(f,d,m,y,g,p){let x=a(f,d,m,y,g,p);m.transmission>0?n.unshift(x):m.transparent===!0?r.unshift(x):e.unshift(x)}function u(f,d){e.length>1&&e.sort(f||qC),n.length>1&&n.sort(d||W_),r.length>1&&r.sort(d||W_)}function h(){for(let f=t,d=i.length;f<d;f++){let m=i[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:r,init:s,push:l,unshift:c,finish:h,sort:u}}function XC(){let i=new WeakMap;function t(n,r){let s=i.get(n),o;return s===void 0?(o=new q_,i.set(n,[o])):r>=s.length?(o=new q_,s.push(o)):o=s[r],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function $C(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new z,color:new ce};break;case"SpotLight":e={position:new z,direction:new z,color:new ce,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new ce,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new ce,groundColor:new ce};break;case"RectAreaLight":e={color:new ce,position:new z,halfWidth:new z,halfHeight:new z};break}return i[t.id]=e,e}}}function YC(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var jC=0;function ZC(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function JC(i){let t=new $C,e=YC(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new z);let r=new z,s=new ze,o=new ze;function a(c){let u=0,h=0,f=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let d=0,m=0,y=0,g=0,p=0,x=0,b=0,v=0,A=0,S=0,_=0,w=0,N=0,C=0;c.sort(ZC);for(let O=0,B=c.length;O<B;O++){let F=c[O],V=F.color,q=F.intensity,G=F.distance,rt=null;if(F.shadow&&F.shadow.map&&(F.shadow.map.texture.format===xs?rt=F.shadow.map.texture:rt=F.shadow.map.depthTexture||F.shadow.map.texture),F.isAmbientLight)u+=V.r*q,h+=V.g*q,f+=V.b*q;else if(F.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(F.sh.coefficients[$],q);C++}else if(F.isSunLight){let $=t.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let j=F.shadow,tt=e.get(F);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[m]=tt,n.sunShadowMap[m]=rt;let ut=j.getViewportCount();for(let ct=0;ct<ut;ct++)n.sunShadowMatrix[y+ct]=j.getMatrix(ct),n.sunShadowCascade[y+ct]=j._cascadeData[ct];y+=ut,m++}n.sun[d]=$,d++}else if(F.isDirectionalLight){let $=t.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let j=F.shadow,tt=e.get(F);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,n.directionalShadow[g]=tt,n.directionalShadowMap[g]=rt,n.directionalShadowMatrix[g]=F.shadow.matrix,A++}n.directional[g]=$,g++}else if(F.isSpotLight){let $=t.get(F);$.position.setFromMatrixPosition(F.matrixWorld),$.color.copy(V).multiplyScalar(q),$.distance=G,$.coneCos=Math.cos(F.angle),$.penumbraCos=Math.cos(F.angle*(1-F.penumbra)),$.decay=F.decay,n.spot[x]=$;let j=F.shadow;if(F.map&&(n.spotLightMap[w]=F.map,w++,j.updateMatrices(F),F.castShadow&&N++),n.spotLightMatrix[x]=j.matrix,F.castShadow){let tt=e.get(F);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,n.spotShadow[x]=tt,n.spotShadowMap[x]=rt,_++}x++}else if(F.isRectAreaLight){let $=t.get(F);$.color.copy(V).multiplyScalar(q),$.halfWidth.set(F.width*.5,0,0),$.halfHeight.set(0,F.height*.5,0),n.rectArea[b]=$,b++}else if(F.isPointLight){let $=t.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),$.distance=F.distance,$.decay=F.decay,F.castShadow){let j=F.shadow,tt=e.get(F);tt.shadowIntensity=j.intensity,tt.shadowBias=j.bias,tt.shadowNormalBias=j.normalBias,tt.shadowRadius=j.radius,tt.shadowMapSize=j.mapSize,tt.shadowCameraNear=j.camera.near,tt.shadowCameraFar=j.camera.far,n.pointShadow[p]=tt,n.pointShadowMap[p]=rt,n.pointShadowMatrix[p]=F.shadow.matrix,S++}n.point[p]=$,p++}else if(F.isHemisphereLight){let $=t.get(F);$.skyColor.copy(F.color).multiplyScalar(q),$.groundColor.copy(F.groundColor).multiplyScalar(q),n.hemi[v]=$,v++}}b>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=It.LTC_FLOAT_1,n.rectAreaLTC2=It.LTC_FLOAT_2):(n.rectAreaLTC1=It.LTC_HALF_1,n.rectAreaLTC2=It.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let P=n.hash;(P.sunLength!==d||P.directionalLength!==g||P.pointLength!==p||P.spotLength!==x||P.rectAreaLength!==b||P.hemiLength!==v||P.numSunShadows!==m||P.numDirectionalShadows!==A||P.numPointShadows!==S||P.numSpotShadows!==_||P.numSpotMaps!==w||P.numLightProbes!==C)&&(n.sun.length=d,n.directional.length=g,n.spot.length=x,n.rectArea.length=b,n.point.length=p,n.hemi.length=v,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=A,n.directionalShadowMap.length=A,n.directionalShadowMatrix.length=A,n.pointShadow.length=S,n.pointShadowMap.length=S,n.pointShadowMatrix.length=S,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+w-N,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=C,P.sunLength=d,P.directionalLength=g,P.pointLength=p,P.spotLength=x,P.rectAreaLength=b,P.hemiLength=v,P.numSunShadows=m,P.numDirectionalShadows=A,P.numPointShadows=S,P.numSpotShadows=_,P.numSpotMaps=w,P.numLightProbes=C,n.version=jC++)}function l(c,u){let h=0,f=0,d=0,m=0,y=0,g=0,p=u.matrixWorldInverse;for(let x=0,b=c.length;x<b;x++){let v=c[x];if(v.isSunLight){let A=n.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(p),h++}else if(v.isDirectionalLight){let A=n.directional[f];A.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(r),A.direction.transformDirection(p),f++}else if(v.isSpotLight){let A=n.spot[m];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(p),A.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(r),A.direction.transformDirection(p),m++}else if(v.isRectAreaLight){let A=n.rectArea[y];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(p),o.identity(),s.copy(v.matrixWorld),s.premultiply(p),o.extractRotation(s),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let A=n.point[d];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(p),d++}else if(v.isHemisphereLight){let A=n.hemi[g];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:n}}function X_(i){let t=new JC(i),e=[],n=[],r=[];function s(h){u.camera=h,e.length=0,n.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):e.push(h)}function a(h){n.push(h)}function l(){t.setup(e),r.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function KC(i){let t=new WeakMap;function e(r,s=0){let o=t.get(r),a;return o===void 0?(a=new X_(i),t.set(r,[a])):s>=o.length?(a=new X_(i),o.push(a)):a=o[s],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var QC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,t2=`uniform sampler2D shadow_pass;
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
}`,e2=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],n2=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],$_=new ze,El=new z,Ip=new z;function i2(i,t,e){let n=new ls,r=new Kt,s=new Kt,o=new Ce,a=new mu,l=new gu,c={},u=e.maxTextureSize,h={[ys]:ai,[ai]:ys,[zi]:zi},f=new Bi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Kt},radius:{value:4}},vertexShader:QC,fragmentShader:t2}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new an;m.setAttribute("position",new on(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Ge(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Hs;let p=this.type;this.render=function(S,_,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||S.length===0)return;this.type===Wx&&(Zt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Hs);let N=i.getRenderTarget(),C=i.getActiveCubeFace(),P=i.getActiveMipmapLevel(),O=i.state;O.setBlending(Ws),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let B=p!==this.type;B&&_.traverse(function(F){F.material&&(Array.isArray(F.material)?F.material.forEach(V=>V.needsUpdate=!0):F.material.needsUpdate=!0)});for(let F=0,V=S.length;F<V;F++){let q=S[F],G=q.shadow;if(G===void 0){Zt("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;r.copy(G.mapSize);let rt=G.getFrameExtents();r.multiply(rt),s.copy(G.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/rt.x),r.x=s.x*rt.x,G.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/rt.y),r.y=s.y*rt.y,G.mapSize.y=s.y));let $=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=$,G.map===null||B===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===ia){if(q.isPointLight){Zt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Ai(r.x,r.y,{format:xs,type:ir,minFilter:oi,magFilter:oi,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new Vr(r.x,r.y,nr),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=zr,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Un,G.map.depthTexture.magFilter=Un}else q.isPointLight?(G.map=new Rl(r.x),G.map.depthTexture=new el(r.x,er)):(G.map=new Ai(r.x,r.y),G.map.depthTexture=new Vr(r.x,r.y,er)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=zr,this.type===Hs?(G.map.depthTexture.compareFunction=$?yp:gp,G.map.depthTexture.minFilter=oi,G.map.depthTexture.magFilter=oi):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Un,G.map.depthTexture.magFilter=Un);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==r.x||G.map.height!==r.y)&&G.map.setSize(r.x,r.y);let j=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,w);let tt=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let ut=0;ut<j;ut++){let ct=G.getCamera(ut);if(q.isPointLight){let K=G.camera,gt=G.matrix,yt=q.distance||K.far;yt!==K.far&&(K.far=yt,K.updateProjectionMatrix()),El.setFromMatrixPosition(q.matrixWorld),K.position.copy(El),Ip.copy(K.position),Ip.add(e2[ut]),K.up.copy(n2[ut]),K.lookAt(Ip),K.updateMatrixWorld(),gt.makeTranslation(-El.x,-El.y,-El.z),$_.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),G._frustum.setFromProjectionMatrix($_,K.coordinateSystem,K.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,ut),i.clear();else{ut===0&&(i.setRenderTarget(G.map),i.clear());let K=G.getViewport(ut);o.set(s.x*K.x,s.y*K.y,s.x*K.z,s.y*K.w),O.viewport(o)}n=G.getFrustum(ut),v(_,w,ct,q,tt,this.type)}G.isPointLightShadow!==!0&&this.type===ia&&x(G,w),G.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(N,C,P)};function x(S,_){let w=t.update(y);f.defines.VSM_SAMPLES!==S.blurSamples&&(f.defines.VSM_SAMPLES=S.blurSamples,d.defines.VSM_SAMPLES=S.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),S.mapPass===null?S.mapPass=new Ai(r.x,r.y,{format:xs,type:ir}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),f.uniforms.shadow_pass.value=S.map.depthTexture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,i.setRenderTarget(S.mapPass),i.clear(),i.renderBufferDirect(_,null,w,f,y,null),d.uniforms.shadow_pass.value=S.mapPass.texture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,i.setRenderTarget(S.map),i.clear(),i.renderBufferDirect(_,null,w,d,y,null)}function b(S,_,w,N){let C=null,P=w.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(P!==void 0)C=P;else if(C=w.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let O=C.uuid,B=_.uuid,F=c[O];F===void 0&&(F={},c[O]=F);let V=F[B];V===void 0&&(V=C.clone(),F[B]=V,_.addEventListener("dispose",A)),C=V}if(C.visible=_.visible,C.wireframe=_.wireframe,N===ia?C.side=_.shadowSide!==null?_.shadowSide:_.side:C.side=_.shadowSide!==null?_.shadowSide:h[_.side],C.alphaMap=_.alphaMap,C.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,C.map=_.map,C.clipShadows=_.clipShadows,C.clippingPlanes=_.clippingPlanes,C.clipIntersection=_.clipIntersection,C.displacementMap=_.displacementMap,C.displacementScale=_.displacementScale,C.displacementBias=_.displacementBias,C.wireframeLinewidth=_.wireframeLinewidth,C.linewidth=_.linewidth,w.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let O=i.properties.get(C);O.light=w}return C}function v(S,_,w,N,C,P){if(S.visible===!1)return;if(S.layers.test(C)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&P===ia)&&(!S.frustumCulled||S.intersectsFrustum(n))){S.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,S.matrixWorld);let F=t.update(S),V=S.material;if(Array.isArray(V)){let q=F.groups;for(let G=0,rt=q.length;G<rt;G++){let $=q[G],j=V[$.materialIndex];if(j&&j.visible){let tt=b(S,j,N,P);S.onBeforeShadow(i,S,_,w,F,tt,$),i.renderBufferDirect(w,null,F,tt,S,$),S.onAfterShadow(i,S,_,w,F,tt,$)}}}else if(V.visible){let q=b(S,V,N,P);S.onBeforeShadow(i,S,_,w,F,q,null),i.renderBufferDirect(w,null,F,q,S,null),S.onAfterShadow(i,S,_,w,F,q,null)}}let B=S.children;for(let F=0,V=B.length;F<V;F++)v(B[F],_,w,N,C,P)}function A(S){S.target.removeEventListener("dispose",A);for(let w in c){let N=c[w],C=S.target.uuid;C in N&&(N[C].dispose(),delete N[C])}}}function r2(i,t){function e(){let U=!1,st=new Ce,nt=null,Et=new Ce(0,0,0,0);return{setMask:function(_t){nt!==_t&&!U&&(i.colorMask(_t,_t,_t,_t),nt=_t)},setLocked:function(_t){U=_t},setClear:function(_t,St,Ht,ee,ht){ht===!0&&(_t*=ee,St*=ee,Ht*=ee),st.set(_t,St,Ht,ee),Et.equals(st)===!1&&(i.clearColor(_t,St,Ht,ee),Et.copy(st))},reset:function(){U=!1,nt=null,Et.set(-1,0,0,0)}}}function n(){let U=!1,st=!1,nt=null,Et=null,_t=null;return{setReversed:function(St){if(st!==St){let Ht=t.get("EXT_clip_control");St?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),st=St;let ee=_t;_t=null,this.setClear(ee)}},getReversed:function(){return st},setTest:function(St){St?xt(i.DEPTH_TEST):zt(i.DEPTH_TEST)},setMask:function(St){nt!==St&&!U&&(i.depthMask(St),nt=St)},setFunc:function(St){if(st&&(St=M_[St]),Et!==St){switch(St){case Zc:i.depthFunc(i.NEVER);break;case Jc:i.depthFunc(i.ALWAYS);break;case Kc:i.depthFunc(i.LESS);break;case Xo:i.depthFunc(i.LEQUAL);break;case Qc:i.depthFunc(i.EQUAL);break;case tu:i.depthFunc(i.GEQUAL);break;case eu:i.depthFunc(i.GREATER);break;case nu:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Et=St}},setLocked:function(St){U=St},setClear:function(St){_t!==St&&(_t=St,st&&(St=1-St),i.clearDepth(St))},reset:function(){U=!1,nt=null,Et=null,_t=null,st=!1}}}function r(){let U=!1,st=null,nt=null,Et=null,_t=null,St=null,Ht=null,ee=null,ht=null;return{setTest:function(kt){U||(kt?xt(i.STENCIL_TEST):zt(i.STENCIL_TEST))},setMask:function(kt){st!==kt&&!U&&(i.stencilMask(kt),st=kt)},setFunc:function(kt,ne,Ct){(nt!==kt||Et!==ne||_t!==Ct)&&(i.stencilFunc(kt,ne,Ct),nt=kt,Et=ne,_t=Ct)},setOp:function(kt,ne,Ct){(St!==kt||Ht!==ne||ee!==Ct)&&(i.stencilOp(kt,ne,Ct),St=kt,Ht=ne,ee=Ct)},setLocked:function(kt){U=kt},setClear:function(kt){ht!==kt&&(i.clearStencil(kt),ht=kt)},reset:function(){U=!1,st=null,nt=null,Et=null,_t=null,St=null,Ht=null,ee=null,ht=null}}}let s=new e,o=new n,a=new r,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,m=[],y=null,g=!1,p=null,x=null,b=null,v=null,A=null,S=null,_=null,w=new ce(0,0,0),N=0,C=!1,P=null,O=null,B=null,F=null,V=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,rt=0,$=i.getParameter(i.VERSION);$.indexOf("WebGL")!==-1?(rt=parseFloat(/^WebGL (\d)/.exec($)[1]),G=rt>=1):$.indexOf("OpenGL ES")!==-1&&(rt=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),G=rt>=2);let j=null,tt={},ut=i.getParameter(i.SCISSOR_BOX),ct=i.getParameter(i.VIEWPORT),K=new Ce().fromArray(ut),gt=new Ce().fromArray(ct);function yt(U,st,nt,Et){let _t=new Uint8Array(4),St=i.createTexture();i.bindTexture(U,St),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ht=0;Ht<nt;Ht++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(st,0,i.RGBA,1,1,Et,0,i.RGBA,i.UNSIGNED_BYTE,_t):i.texImage2D(st+Ht,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_t);return St}let Mt={};Mt[i.TEXTURE_2D]=yt(i.TEXTURE_2D,i.TEXTURE_2D,1),Mt[i.TEXTURE_CUBE_MAP]=yt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Mt[i.TEXTURE_2D_ARRAY]=yt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Mt[i.TEXTURE_3D]=yt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xt(i.DEPTH_TEST),o.setFunc(Xo),un(!1),De(jd),xt(i.CULL_FACE),_e(Ws);function xt(U){u[U]!==!0&&(i.enable(U),u[U]=!0)}function zt(U){u[U]!==!1&&(i.disable(U),u[U]=!1)}function te(U,st){return f[U]!==st?(i.bindFramebuffer(U,st),f[U]=st,U===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=st),U===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=st),!0):!1}function dt(U,st){let nt=m,Et=!1;if(U){nt=d.get(st),nt===void 0&&(nt=[],d.set(st,nt));let _t=U.textures;if(nt.length!==_t.length||nt[0]!==i.COLOR_ATTACHMENT0){for(let St=0,Ht=_t.length;St<Ht;St++)nt[St]=i.COLOR_ATTACHMENT0+St;nt.length=_t.length,Et=!0}}else nt[0]!==i.BACK&&(nt[0]=i.BACK,Et=!0);Et&&i.drawBuffers(nt)}function Wt(U){return y!==U?(i.useProgram(U),y=U,!0):!1}let qt={[qs]:i.FUNC_ADD,[Xx]:i.FUNC_SUBTRACT,[$x]:i.FUNC_REVERSE_SUBTRACT};qt[Yx]=i.MIN,qt[jx]=i.MAX;let Yt={[Zx]:i.ZERO,[Jx]:i.ONE,[Kx]:i.SRC_COLOR,[Qd]:i.SRC_ALPHA,[r_]:i.SRC_ALPHA_SATURATE,[n_]:i.DST_COLOR,[t_]:i.DST_ALPHA,[Qx]:i.ONE_MINUS_SRC_COLOR,[tp]:i.ONE_MINUS_SRC_ALPHA,[i_]:i.ONE_MINUS_DST_COLOR,[e_]:i.ONE_MINUS_DST_ALPHA,[s_]:i.CONSTANT_COLOR,[o_]:i.ONE_MINUS_CONSTANT_COLOR,[a_]:i.CONSTANT_ALPHA,[l_]:i.ONE_MINUS_CONSTANT_ALPHA};function _e(U,st,nt,Et,_t,St,Ht,ee,ht,kt){if(U===Ws){g===!0&&(zt(i.BLEND),g=!1);return}if(g===!1&&(xt(i.BLEND),g=!0),U!==qx){if(U!==p||kt!==C){if((x!==qs||A!==qs)&&(i.blendEquation(i.FUNC_ADD),x=qs,A=qs),kt)switch(U){case ra:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Zd:i.blendFunc(i.ONE,i.ONE);break;case Jd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Kd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:re("WebGLState: Invalid blending: ",U);break}else switch(U){case ra:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Zd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Jd:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Kd:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",U);break}b=null,v=null,S=null,_=null,w.set(0,0,0),N=0,p=U,C=kt}return}_t=_t||st,St=St||nt,Ht=Ht||Et,(st!==x||_t!==A)&&(i.blendEquationSeparate(qt[st],qt[_t]),x=st,A=_t),(nt!==b||Et!==v||St!==S||Ht!==_)&&(i.blendFuncSeparate(Yt[nt],Yt[Et],Yt[St],Yt[Ht]),b=nt,v=Et,S=St,_=Ht),(ee.equals(w)===!1||ht!==N)&&(i.blendColor(ee.r,ee.g,ee.b,ht),w.copy(ee),N=ht),p=U,C=!1}function Ne(U,st){U.side===zi?zt(i.CULL_FACE):xt(i.CULL_FACE);let nt=U.side===ai;st&&(nt=!nt),un(nt),U.blending===ra&&U.transparent===!1?_e(Ws):_e(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),s.setMask(U.colorWrite);let Et=U.stencilWrite;a.setTest(Et),Et&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),ve(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?xt(i.SAMPLE_ALPHA_TO_COVERAGE):zt(i.SAMPLE_ALPHA_TO_COVERAGE)}function un(U){P!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),P=U)}function De(U){U!==Gx?(xt(i.CULL_FACE),U!==O&&(U===jd?i.cullFace(i.BACK):U===Hx?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):zt(i.CULL_FACE),O=U}function Cn(U){U!==B&&(G&&i.lineWidth(U),B=U)}function ve(U,st,nt){U?(xt(i.POLYGON_OFFSET_FILL),(F!==st||V!==nt)&&(F=st,V=nt,o.getReversed()&&(st=-st,nt=-nt),i.polygonOffset(st,nt))):zt(i.POLYGON_OFFSET_FILL)}function _n(U){U?xt(i.SCISSOR_TEST):zt(i.SCISSOR_TEST)}function Qe(U){U===void 0&&(U=i.TEXTURE0+q-1),j!==U&&(i.activeTexture(U),j=U)}function hn(U,st,nt){nt===void 0&&(j===null?nt=i.TEXTURE0+q-1:nt=j);let Et=tt[nt];Et===void 0&&(Et={type:void 0,texture:void 0},tt[nt]=Et),(Et.type!==U||Et.texture!==st)&&(j!==nt&&(i.activeTexture(nt),j=nt),i.bindTexture(U,st||Mt[U]),Et.type=U,Et.texture=st)}function k(){let U=tt[j];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Pt(){try{i.compressedTexImage2D(...arguments)}catch(U){re("WebGLState:",U)}}function Jt(){try{i.compressedTexImage3D(...arguments)}catch(U){re("WebGLState:",U)}}function ae(){try{i.texSubImage2D(...arguments)}catch(U){re("WebGLState:",U)}}function At(){try{i.texSubImage3D(...arguments)}catch(U){re("WebGLState:",U)}}function Ue(){try{i.compressedTexSubImage2D(...arguments)}catch(U){re("WebGLState:",U)}}function Gt(){try{i.compressedTexSubImage3D(...arguments)}catch(U){re("WebGLState:",U)}}function jt(){try{i.texStorage2D(...arguments)}catch(U){re("WebGLState:",U)}}function I(){try{i.texStorage3D(...arguments)}catch(U){re("WebGLState:",U)}}function E(){try{i.texImage2D(...arguments)}catch(U){re("WebGLState:",U)}}function X(){try{i.texImage3D(...arguments)}catch(U){re("WebGLState:",U)}}function ft(U){return h[U]!==void 0?h[U]:i.getParameter(U)}function ot(U,st){h[U]!==st&&(i.pixelStorei(U,st),h[U]=st)}function vt(U){K.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),K.copy(U))}function bt(U){gt.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),gt.copy(U))}function et(U,st){let nt=c.get(st);nt===void 0&&(nt=new WeakMap,c.set(st,nt));let Et=nt.get(U);Et===void 0&&(Et=i.getUniformBlockIndex(st,U.name),i.uniformBlockBinding(st,Et,Et),nt.set(U,Et))}function it(U,st,nt){let _t=c.get(st).get(U);l[_t]!==nt&&(i.bindBufferBase(i.UNIFORM_BUFFER,_t,nt),l[_t]=nt)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,tt={},f={},l={},d=new WeakMap,m=[],y=null,g=!1,p=null,x=null,b=null,v=null,A=null,S=null,_=null,w=new ce(0,0,0),N=0,C=!1,P=null,O=null,B=null,F=null,V=null,K.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:xt,disable:zt,bindFramebuffer:te,drawBuffers:dt,useProgram:Wt,setBlending:_e,setMaterial:Ne,setFlipSided:un,setCullFace:De,setLineWidth:Cn,setPolygonOffset:ve,setScissorTest:_n,activeTexture:Qe,bindTexture:hn,unbindTexture:k,compressedTexImage2D:Pt,compressedTexImage3D:Jt,texImage2D:E,texImage3D:X,pixelStorei:ot,getParameter:ft,updateUBOMapping:et,uniformBlockBinding:it,texStorage2D:jt,texStorage3D:I,texSubImage2D:ae,texSubImage3D:At,compressedTexSubImage2D:Ue,compressedTexSubImage3D:Gt,scissor:vt,viewport:bt,reset:mt}}function s2(i,t,e,n,r,s,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Kt,u=new WeakMap,h=new Set,f,d=new WeakMap,m=new Set,y=new FinalizationRegistry(I=>m.delete(I)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(I,E){return g?new OffscreenCanvas(I,E):Xa("canvas")}function x(I,E,X){let ft=1,ot=jt(I);if((ot.width>X||ot.height>X)&&(ft=X/Math.max(ot.width,ot.height)),ft<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let vt=Math.floor(ft*ot.width),bt=Math.floor(ft*ot.height);f===void 0&&(f=p(vt,bt));let et=E?p(vt,bt):f;return et.width=vt,et.height=bt,et.getContext("2d").drawImage(I,0,0,vt,bt),Zt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+vt+"x"+bt+")."),et}else return"data"in I&&Zt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),I;return I}function b(I){return I.generateMipmaps}function v(I){i.generateMipmap(I)}function A(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(I,E,X,ft,ot,vt=!1){if(I!==null){if(i[I]!==void 0)return i[I];Zt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let bt;ft&&(bt=t.get("EXT_texture_norm16"),bt||Zt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=E;if(E===i.RED&&(X===i.FLOAT&&(et=i.R32F),X===i.HALF_FLOAT&&(et=i.R16F),X===i.UNSIGNED_BYTE&&(et=i.R8),X===i.UNSIGNED_SHORT&&bt&&(et=bt.R16_EXT),X===i.SHORT&&bt&&(et=bt.R16_SNORM_EXT)),E===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(et=i.R8UI),X===i.UNSIGNED_SHORT&&(et=i.R16UI),X===i.UNSIGNED_INT&&(et=i.R32UI),X===i.BYTE&&(et=i.R8I),X===i.SHORT&&(et=i.R16I),X===i.INT&&(et=i.R32I)),E===i.RG&&(X===i.FLOAT&&(et=i.RG32F),X===i.HALF_FLOAT&&(et=i.RG16F),X===i.UNSIGNED_BYTE&&(et=i.RG8),X===i.UNSIGNED_SHORT&&bt&&(et=bt.RG16_EXT),X===i.SHORT&&bt&&(et=bt.RG16_SNORM_EXT)),E===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(et=i.RG8UI),X===i.UNSIGNED_SHORT&&(et=i.RG16UI),X===i.UNSIGNED_INT&&(et=i.RG32UI),X===i.BYTE&&(et=i.RG8I),X===i.SHORT&&(et=i.RG16I),X===i.INT&&(et=i.RG32I)),E===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(et=i.RGB8UI),X===i.UNSIGNED_SHORT&&(et=i.RGB16UI),X===i.UNSIGNED_INT&&(et=i.RGB32UI),X===i.BYTE&&(et=i.RGB8I),X===i.SHORT&&(et=i.RGB16I),X===i.INT&&(et=i.RGB32I)),E===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),X===i.UNSIGNED_INT&&(et=i.RGBA32UI),X===i.BYTE&&(et=i.RGBA8I),X===i.SHORT&&(et=i.RGBA16I),X===i.INT&&(et=i.RGBA32I)),E===i.RGB&&(X===i.UNSIGNED_SHORT&&bt&&(et=bt.RGB16_EXT),X===i.SHORT&&bt&&(et=bt.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(et=i.R11F_G11F_B10F)),E===i.RGBA){let it=vt?qa:xe.getTransfer(ot);X===i.FLOAT&&(et=i.RGBA32F),X===i.HALF_FLOAT&&(et=i.RGBA16F),X===i.UNSIGNED_BYTE&&(et=it===Re?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&bt&&(et=bt.RGBA16_EXT),X===i.SHORT&&bt&&(et=bt.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function _(I,E){let X;return I?E===null||E===er||E===$s?X=i.DEPTH24_STENCIL8:E===nr?X=i.DEPTH32F_STENCIL8:E===oa&&(X=i.DEPTH24_STENCIL8,Zt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===er||E===$s?X=i.DEPTH_COMPONENT24:E===nr?X=i.DEPTH_COMPONENT32F:E===oa&&(X=i.DEPTH_COMPONENT16),X}function w(I,E){return b(I)===!0||I.isFramebufferTexture&&I.minFilter!==Un&&I.minFilter!==oi?Math.log2(Math.max(E.width,E.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?E.mipmaps.length:1}function N(I){let E=new WeakRef(I);n.get(I).__ref=E,m.add(E),y.register(I,E,E)}function C(I){let E=n.get(I).__ref;E!==void 0&&(m.delete(E),y.unregister(E))}function P(I){B(I.target)}function O(I){F(I.target)}function B(I){I.removeEventListener("dispose",P),C(I),q(I),I.isVideoTexture&&u.delete(I),I.isHTMLTexture&&h.delete(I)}function F(I){I.removeEventListener("dispose",O),C(I),rt(I)}function V(){for(let I of m){let E=I.deref();E!==void 0&&(E.isRenderTarget===!0?F(E):B(E))}m.clear(),h.clear()}function q(I){let E=n.get(I);if(E.__webglInit===void 0)return;let X=I.source,ft=d.get(X);if(ft){let ot=ft[E.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&G(I),Object.keys(ft).length===0&&d.delete(X)}n.remove(I)}function G(I){let E=n.get(I);i.deleteTexture(E.__webglTexture);let X=I.source,ft=d.get(X);delete ft[E.__cacheKey],o.memory.textures--}function rt(I){let E=n.get(I);E.__depthDisposeCallback&&E.__depthDisposeCallback();let X=I.depthTexture;if(X&&X.renderTarget===I&&B(X),I.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(E.__webglFramebuffer[ot]))for(let vt=0;vt<E.__webglFramebuffer[ot].length;vt++)i.deleteFramebuffer(E.__webglFramebuffer[ot][vt]);else i.deleteFramebuffer(E.__webglFramebuffer[ot]);E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer[ot])}else{if(Array.isArray(E.__webglFramebuffer))for(let ot=0;ot<E.__webglFramebuffer.length;ot++)i.deleteFramebuffer(E.__webglFramebuffer[ot]);else i.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&i.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let ot=0;ot<E.__webglColorRenderbuffer.length;ot++)E.__webglColorRenderbuffer[ot]&&i.deleteRenderbuffer(E.__webglColorRenderbuffer[ot]);E.__webglDepthRenderbuffer&&i.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let ft=I.textures;for(let ot=0,vt=ft.length;ot<vt;ot++){let bt=n.get(ft[ot]);bt.__webglTexture&&(i.deleteTexture(bt.__webglTexture),o.memory.textures--),n.remove(ft[ot])}n.remove(I)}let $=0;function j(){$=0}function tt(){return $}function ut(I){$=I}function ct(){let I=$;return I>=r.maxTextures&&Zt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+r.maxTextures),$+=1,I}function K(I){let E=[];return E.push(I.wrapS),E.push(I.wrapT),E.push(I.wrapR||0),E.push(I.magFilter),E.push(I.minFilter),E.push(I.anisotropy),E.push(I.internalFormat),E.push(I.format),E.push(I.type),E.push(I.generateMipmaps),E.push(I.mipmapsAutoUpdate),E.push(I.premultiplyAlpha),E.push(I.flipY),E.push(I.unpackAlignment),E.push(I.colorSpace),E.join()}function gt(I,E){let X=n.get(I);if(I.isVideoTexture&&Ue(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&X.__version!==I.version){let ft=I.image;if(ft===null)Zt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)Zt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ne(X,I,E);return}}else I.isExternalTexture&&(X.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+E)}function yt(I,E){let X=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&X.__version!==I.version){Ne(X,I,E);return}else I.isExternalTexture&&(X.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+E)}function Mt(I,E){let X=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&X.__version!==I.version){Ne(X,I,E);return}e.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+E)}function xt(I,E){let X=n.get(I);if(I.version>0&&X.__version!==I.version){un(X,I,E);return}e.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+E)}let zt={[iu]:i.REPEAT,[mr]:i.CLAMP_TO_EDGE,[ru]:i.MIRRORED_REPEAT},te={[Un]:i.NEAREST,[h_]:i.NEAREST_MIPMAP_NEAREST,[yl]:i.NEAREST_MIPMAP_LINEAR,[oi]:i.LINEAR,[Lu]:i.LINEAR_MIPMAP_NEAREST,[Gr]:i.LINEAR_MIPMAP_LINEAR},dt={[m_]:i.NEVER,[xp]:i.ALWAYS,[g_]:i.LESS,[gp]:i.LEQUAL,[y_]:i.EQUAL,[yp]:i.GEQUAL,[x_]:i.GREATER,[__]:i.NOTEQUAL};function Wt(I,E){if(E.type===nr&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===oi||E.magFilter===Lu||E.magFilter===yl||E.magFilter===Gr||E.minFilter===oi||E.minFilter===Lu||E.minFilter===yl||E.minFilter===Gr)&&Zt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,zt[E.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,zt[E.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,zt[E.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,te[E.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,te[E.minFilter]),E.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,dt[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Un||E.minFilter!==yl&&E.minFilter!==Gr||E.type===nr&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||n.get(E).__currentAnisotropy){let X=t.get("EXT_texture_filter_anisotropic");i.texParameterf(I,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,r.getMaxAnisotropy())),n.get(E).__currentAnisotropy=E.anisotropy}}}function qt(I,E){let X=!1;I.__webglInit===void 0&&(I.__webglInit=!0,E.addEventListener("dispose",P),N(E));let ft=E.source,ot=d.get(ft);ot===void 0&&(ot={},d.set(ft,ot));let vt=K(E);if(vt!==I.__cacheKey){ot[vt]===void 0&&(ot[vt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),ot[vt].usedTimes++;let bt=ot[I.__cacheKey];bt!==void 0&&(ot[I.__cacheKey].usedTimes--,bt.usedTimes===0&&G(E)),I.__cacheKey=vt,I.__webglTexture=ot[vt].texture}return X}function Yt(I,E,X){return Math.floor(Math.floor(I/X)/E)}function _e(I,E,X,ft){let vt=I.updateRanges;if(vt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,E.width,E.height,X,ft,E.data);else{vt.sort((U,st)=>U.start-st.start);let bt=0;for(let U=1;U<vt.length;U++){let st=vt[bt],nt=vt[U],Et=st.start+st.count,_t=Yt(nt.start,E.width,4),St=Yt(st.start,E.width,4);nt.start<=Et+1&&_t===St&&Yt(nt.start+nt.count-1,E.width,4)===_t?st.count=Math.max(st.count,nt.start+nt.count-st.start):(++bt,vt[bt]=nt)}vt.length=bt+1;let et=e.getParameter(i.UNPACK_ROW_LENGTH),it=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,E.width);for(let U=0,st=vt.length;U<st;U++){let nt=vt[U],Et=Math.floor(nt.start/4),_t=Math.ceil(nt.count/4),St=Et%E.width,Ht=Math.floor(Et/E.width),ee=_t,ht=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,St),e.pixelStorei(i.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(i.TEXTURE_2D,0,St,Ht,ee,ht,X,ft,E.data)}I.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,et),e.pixelStorei(i.UNPACK_SKIP_PIXELS,it),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function Ne(I,E,X){let ft=i.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(ft=i.TEXTURE_2D_ARRAY),E.isData3DTexture&&(ft=i.TEXTURE_3D);let ot=qt(I,E),vt=E.source;e.bindTexture(ft,I.__webglTexture,i.TEXTURE0+X);let bt=n.get(vt);if(vt.version!==bt.__version||ot===!0){if(e.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ht=xe.getPrimaries(xe.workingColorSpace),kt=E.colorSpace===Wr?null:xe.getPrimaries(E.colorSpace),ne=E.colorSpace===Wr||ht===kt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne)}e.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment);let it=x(E.image,!1,r.maxTextureSize);it=Gt(E,it);let mt=s.convert(E.format,E.colorSpace),U=s.convert(E.type),st=S(E.internalFormat,mt,U,E.normalized,E.colorSpace,E.isVideoTexture);Wt(ft,E);let nt,Et=E.mipmaps,_t=E.isVideoTexture!==!0,St=bt.__version===void 0||ot===!0,Ht=vt.dataReady,ee=w(E,it);if(E.isDepthTexture)st=_(E.format===Hr,E.type),St&&(_t?e.texStorage2D(i.TEXTURE_2D,1,st,it.width,it.height):e.texImage2D(i.TEXTURE_2D,0,st,it.width,it.height,0,mt,U,null));else if(E.isDataTexture)if(Et.length>0){_t&&St&&e.texStorage2D(i.TEXTURE_2D,ee,st,Et[0].width,Et[0].height);for(let ht=0,kt=Et.length;ht<kt;ht++)nt=Et[ht],_t?Ht&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,U,nt.data):e.texImage2D(i.TEXTURE_2D,ht,st,nt.width,nt.height,0,mt,U,nt.data);E.generateMipmaps=!1}else _t?(St&&e.texStorage2D(i.TEXTURE_2D,ee,st,it.width,it.height),Ht&&_e(E,it,mt,U)):e.texImage2D(i.TEXTURE_2D,0,st,it.width,it.height,0,mt,U,it.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){_t&&St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,st,Et[0].width,Et[0].height,it.depth);for(let ht=0,kt=Et.length;ht<kt;ht++)if(nt=Et[ht],E.format!==rr)if(mt!==null)if(_t){if(Ht)if(E.layerUpdates.size>0){let ne=Cp(nt.width,nt.height,E.format,E.type);for(let Ct of E.layerUpdates){let ue=nt.data.subarray(Ct*ne/nt.data.BYTES_PER_ELEMENT,(Ct+1)*ne/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,Ct,nt.width,nt.height,1,mt,ue)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,it.depth,mt,nt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ht,st,nt.width,nt.height,it.depth,0,nt.data,0,0);else Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Ht&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,it.depth,mt,U,nt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ht,st,nt.width,nt.height,it.depth,0,mt,U,nt.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{_t&&St&&e.texStorage2D(i.TEXTURE_2D,ee,st,Et[0].width,Et[0].height);for(let ht=0,kt=Et.length;ht<kt;ht++)nt=Et[ht],E.format!==rr?mt!==null?_t?Ht&&e.compressedTexSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(i.TEXTURE_2D,ht,st,nt.width,nt.height,0,nt.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Ht&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,U,nt.data):e.texImage2D(i.TEXTURE_2D,ht,st,nt.width,nt.height,0,mt,U,nt.data)}else if(E.isDataArrayTexture)if(_t){if(St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,st,it.width,it.height,it.depth),Ht)if(E.layerUpdates.size>0){let ht=Cp(it.width,it.height,E.format,E.type);for(let kt of E.layerUpdates){let ne=it.data.subarray(kt*ht/it.data.BYTES_PER_ELEMENT,(kt+1)*ht/it.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,kt,it.width,it.height,1,mt,U,ne)}E.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,it.width,it.height,it.depth,mt,U,it.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,st,it.width,it.height,it.depth,0,mt,U,it.data);else if(E.isData3DTexture)_t?(St&&e.texStorage3D(i.TEXTURE_3D,ee,st,it.width,it.height,it.depth),Ht&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,it.width,it.height,it.depth,mt,U,it.data)):e.texImage3D(i.TEXTURE_3D,0,st,it.width,it.height,it.depth,0,mt,U,it.data);else if(E.isFramebufferTexture){if(St)if(_t)e.texStorage2D(i.TEXTURE_2D,ee,st,it.width,it.height);else{let ht=it.width,kt=it.height;for(let ne=0;ne<ee;ne++)e.texImage2D(i.TEXTURE_2D,ne,st,ht,kt,0,mt,U,null),ht>>=1,kt>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in i){let ht=i.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),it.parentNode!==ht){ht.appendChild(it),h.add(E),ht.onpaint=kt=>{let ne=kt.changedElements;for(let Ct of h)ne.includes(Ct.image)&&(Ct.needsUpdate=!0)},ht.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,it);else{let ne=i.RGBA,Ct=i.RGBA,ue=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ne,Ct,ue,it)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Et.length>0){if(_t&&St){let ht=jt(Et[0]);e.texStorage2D(i.TEXTURE_2D,ee,st,ht.width,ht.height)}for(let ht=0,kt=Et.length;ht<kt;ht++)nt=Et[ht],_t?Ht&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,mt,U,nt):e.texImage2D(i.TEXTURE_2D,ht,st,mt,U,nt);E.generateMipmaps=!1}else if(_t){if(St){let ht=jt(it);e.texStorage2D(i.TEXTURE_2D,ee,st,ht.width,ht.height)}Ht&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,U,it)}else e.texImage2D(i.TEXTURE_2D,0,st,mt,U,it);b(E)&&E.mipmapsAutoUpdate===!0&&v(ft),bt.__version=vt.version,E.onUpdate&&E.onUpdate(E)}I.__version=E.version}function un(I,E,X){if(E.image.length!==6)return;let ft=qt(I,E),ot=E.source;e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+X);let vt=n.get(ot);if(ot.version!==vt.__version||ft===!0){e.activeTexture(i.TEXTURE0+X);let bt=xe.getPrimaries(xe.workingColorSpace),et=E.colorSpace===Wr?null:xe.getPrimaries(E.colorSpace),it=E.colorSpace===Wr||bt===et?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,it);let mt=E.isCompressedTexture||E.image[0].isCompressedTexture,U=E.image[0]&&E.image[0].isDataTexture,st=[];for(let Ct=0;Ct<6;Ct++)!mt&&!U?st[Ct]=x(E.image[Ct],!0,r.maxCubemapSize):st[Ct]=U?E.image[Ct].image:E.image[Ct],st[Ct]=Gt(E,st[Ct]);let nt=st[0],Et=s.convert(E.format,E.colorSpace),_t=s.convert(E.type),St=S(E.internalFormat,Et,_t,E.normalized,E.colorSpace),Ht=E.isVideoTexture!==!0,ee=vt.__version===void 0||ft===!0,ht=ot.dataReady,kt=w(E,nt);Wt(i.TEXTURE_CUBE_MAP,E);let ne;if(E.isDepthTexture){if(St=_(E.format===Hr,E.type),ee)if(Ht)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,St,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,nt.width,nt.height,0,Et,_t,null)}else if(mt){Ht&&ee&&e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,St,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){ne=st[Ct].mipmaps;for(let ue=0;ue<ne.length;ue++){let He=ne[ue];E.format!==rr?Et!==null?Ht?ht&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,0,0,He.width,He.height,Et,He.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,St,He.width,He.height,0,He.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,0,0,He.width,He.height,Et,_t,He.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,St,He.width,He.height,0,Et,_t,He.data)}}}else{if(ne=E.mipmaps,Ht&&ee){ne.length>0&&kt++;let Ct=jt(st[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,St,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(U){Ht?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,st[Ct].width,st[Ct].height,Et,_t,st[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,st[Ct].width,st[Ct].height,0,Et,_t,st[Ct].data);for(let ue=0;ue<ne.length;ue++){let Jn=ne[ue].image[Ct].image;Ht?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,0,0,Jn.width,Jn.height,Et,_t,Jn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,St,Jn.width,Jn.height,0,Et,_t,Jn.data)}}else{Ht?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,_t,st[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,Et,_t,st[Ct]);for(let ue=0;ue<ne.length;ue++){let He=ne[ue];Ht?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,0,0,Et,_t,He.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,St,Et,_t,He.image[Ct])}}}b(E)&&E.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),vt.__version=ot.version,E.onUpdate&&E.onUpdate(E)}I.__version=E.version}function De(I,E,X,ft,ot,vt){let bt=s.convert(X.format,X.colorSpace),et=s.convert(X.type),it=S(X.internalFormat,bt,et,X.normalized,X.colorSpace),mt=n.get(E),U=n.get(X);if(U.__renderTarget=E,!mt.__hasExternalTextures){let st=Math.max(1,E.width>>vt),nt=Math.max(1,E.height>>vt);ot===i.TEXTURE_3D||ot===i.TEXTURE_2D_ARRAY?e.texImage3D(ot,vt,it,st,nt,E.depth,0,bt,et,null):e.texImage2D(ot,vt,it,st,nt,0,bt,et,null)}e.bindFramebuffer(i.FRAMEBUFFER,I),At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ft,ot,U.__webglTexture,0,ae(E)):(ot===i.TEXTURE_2D||ot>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ft,ot,U.__webglTexture,vt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(I,E,X){if(i.bindRenderbuffer(i.RENDERBUFFER,I),E.depthBuffer){let ft=E.depthTexture,ot=ft&&ft.isDepthTexture?ft.type:null,vt=_(E.stencilBuffer,ot),bt=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;At(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ae(E),vt,E.width,E.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ae(E),vt,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,vt,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,bt,i.RENDERBUFFER,I)}else{let ft=E.textures;for(let ot=0;ot<ft.length;ot++){let vt=ft[ot],bt=s.convert(vt.format,vt.colorSpace),et=s.convert(vt.type),it=S(vt.internalFormat,bt,et,vt.normalized,vt.colorSpace);At(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ae(E),it,E.width,E.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ae(E),it,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,it,E.width,E.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ve(I,E,X){let ft=E.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,I),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=n.get(E.depthTexture);ot.__renderTarget=E;let vt=ft?E.depthTexture.image[0]:E.depthTexture.image;(!ot.__webglTexture||vt.width!==E.width||vt.height!==E.height)&&(vt.width=E.width,vt.height=E.height,E.depthTexture.needsUpdate=!0),ft?xt(E.depthTexture,0):gt(E.depthTexture,0);let bt=ot.__webglTexture,et=ae(E),it=ft?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,mt=E.depthTexture.format===Hr?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(E.depthTexture.format===zr)At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,it,bt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,mt,it,bt,0);else if(E.depthTexture.format===Hr)At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,it,bt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,mt,it,bt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(I){let E=n.get(I),X=I.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==I.depthTexture){let ft=I.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),ft){let ot=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,ft.removeEventListener("dispose",ot)};ft.addEventListener("dispose",ot),E.__depthDisposeCallback=ot}E.__boundDepthTexture=ft}if(I.depthTexture&&!E.__autoAllocateDepthBuffer)if(X)for(let ft=0;ft<6;ft++)ve(E.__webglFramebuffer[ft],I,ft);else I.texture.mipmaps.length>0?ve(E.__webglFramebuffer[0],I,0):ve(E.__webglFramebuffer,I,0);else if(X){E.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[ft]),E.__webglDepthbuffer[ft]===void 0)E.__webglDepthbuffer[ft]=i.createRenderbuffer(),Cn(E.__webglDepthbuffer[ft],I,!1);else{let ot=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=E.__webglDepthbuffer[ft];i.bindRenderbuffer(i.RENDERBUFFER,vt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,vt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=i.createRenderbuffer(),Cn(E.__webglDepthbuffer,I,!1);else{let ot=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=E.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,vt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,vt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Qe(I,E,X){let ft=n.get(I);E!==void 0&&De(ft.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&_n(I)}function hn(I){let E=I.texture,X=n.get(I),ft=n.get(E);I.addEventListener("dispose",O),N(I);let ot=I.textures,vt=I.isWebGLCubeRenderTarget===!0,bt=ot.length>1;if(bt||(ft.__webglTexture===void 0&&(ft.__webglTexture=i.createTexture()),ft.__version=E.version,o.memory.textures++),vt){X.__webglFramebuffer=[];for(let et=0;et<6;et++)if(E.mipmaps.length>0){X.__webglFramebuffer[et]=[];for(let it=0;it<E.mipmaps.length;it++)X.__webglFramebuffer[et][it]=i.createFramebuffer()}else X.__webglFramebuffer[et]=i.createFramebuffer()}else{if(E.mipmaps.length>0){X.__webglFramebuffer=[];for(let et=0;et<E.mipmaps.length;et++)X.__webglFramebuffer[et]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(bt)for(let et=0,it=ot.length;et<it;et++){let mt=n.get(ot[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&At(I)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let it=ot[et];X.__webglColorRenderbuffer[et]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[et]);let mt=s.convert(it.format,it.colorSpace),U=s.convert(it.type),st=S(it.internalFormat,mt,U,it.normalized,it.colorSpace,I.isXRRenderTarget===!0),nt=ae(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,nt,st,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+et,i.RENDERBUFFER,X.__webglColorRenderbuffer[et])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),Cn(X.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(vt){e.bindTexture(i.TEXTURE_CUBE_MAP,ft.__webglTexture),Wt(i.TEXTURE_CUBE_MAP,E);for(let et=0;et<6;et++)if(E.mipmaps.length>0)for(let it=0;it<E.mipmaps.length;it++)De(X.__webglFramebuffer[et][it],I,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,it);else De(X.__webglFramebuffer[et],I,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);b(E)?v(i.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}else if(bt){for(let et=0,it=ot.length;et<it;et++){let mt=ot[et],U=n.get(mt),st=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(st=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(st,U.__webglTexture),Wt(st,mt),De(X.__webglFramebuffer,I,mt,i.COLOR_ATTACHMENT0+et,st,0),b(mt)&&v(st)}e.unbindTexture()}else{let et=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(et=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(et,ft.__webglTexture),Wt(et,E),E.mipmaps.length>0)for(let it=0;it<E.mipmaps.length;it++)De(X.__webglFramebuffer[it],I,E,i.COLOR_ATTACHMENT0,et,it);else De(X.__webglFramebuffer,I,E,i.COLOR_ATTACHMENT0,et,0);b(E)?v(et):E.mipmaps.length>0&&i.texParameteri(et,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&_n(I)}function k(I){let E=I.textures;for(let X=0,ft=E.length;X<ft;X++){let ot=E[X];if(b(ot)&&ot.mipmapsAutoUpdate===!0){let vt=A(I),bt=n.get(ot).__webglTexture;e.bindTexture(vt,bt),v(vt),e.unbindTexture()}}}let Pt=[];function Jt(I){if(I.samples>0){if(At(I)===!1){let E=I.textures,X=I.width,ft=I.height,ot=i.COLOR_BUFFER_BIT,vt=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,bt=n.get(I),et=E.length>1;if(et)for(let mt=0;mt<E.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,bt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,bt.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,bt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,bt.__webglFramebuffer);for(let mt=0;mt<E.length;mt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ot|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ot|=i.STENCIL_BUFFER_BIT)),et){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,bt.__webglColorRenderbuffer[mt]);let U=n.get(E[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,X,ft,0,0,X,ft,ot,i.NEAREST),l===!0&&(Pt.length=0,Pt.push(i.COLOR_ATTACHMENT0+mt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Pt.push(vt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<E.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,bt.__webglColorRenderbuffer[mt]);let U=n.get(E[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,bt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,U,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,bt.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let E=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[E])}}}function ae(I){return Math.min(r.maxSamples,I.samples)}function At(I){let E=n.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Ue(I){let E=o.render.frame;u.get(I)!==E&&(u.set(I,E),I.update())}function Gt(I,E){let X=I.colorSpace,ft=I.format,ot=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||X!==Wa&&X!==Wr&&(xe.getTransfer(X)===Re?(ft!==rr||ot!==ui)&&Zt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",X)),E}function jt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=ct,this.resetTextureUnits=j,this.getTextureUnits=tt,this.setTextureUnits=ut,this.setTexture2D=gt,this.setTexture2DArray=yt,this.setTexture3D=Mt,this.setTextureCube=xt,this.rebindTextures=Qe,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Jt,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=De,this.useMultisampledRTT=At,this.dispose=V}function o2(i,t){function e(n,r=Wr){let s,o=xe.getTransfer(r);if(n===ui)return i.UNSIGNED_BYTE;if(n===Nu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Du)return i.UNSIGNED_SHORT_5_5_5_1;if(n===hp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===fp)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===cp)return i.BYTE;if(n===up)return i.SHORT;if(n===oa)return i.UNSIGNED_SHORT;if(n===Fu)return i.INT;if(n===er)return i.UNSIGNED_INT;if(n===nr)return i.FLOAT;if(n===ir)return i.HALF_FLOAT;if(n===dp)return i.ALPHA;if(n===pp)return i.RGB;if(n===rr)return i.RGBA;if(n===zr)return i.DEPTH_COMPONENT;if(n===Hr)return i.DEPTH_STENCIL;if(n===mp)return i.RED;if(n===Ou)return i.RED_INTEGER;if(n===xs)return i.RG;if(n===Uu)return i.RG_INTEGER;if(n===ku)return i.RGBA_INTEGER;if(n===xl||n===_l||n===vl||n===bl)if(o===Re)if(s=t.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===xl)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===_l)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===vl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===bl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=t.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===xl)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===_l)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===vl)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===bl)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Bu||n===zu||n===Vu||n===Gu)if(s=t.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===Bu)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===zu)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Vu)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Gu)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Hu||n===Wu||n===qu||n===Xu||n===$u||n===wl||n===Yu)if(s=t.get("WEBGL_compressed_texture_etc"),s!==null){if(n===Hu||n===Wu)return o===Re?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===qu)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===Xu)return s.COMPRESSED_R11_EAC;if(n===$u)return s.COMPRESSED_SIGNED_R11_EAC;if(n===wl)return s.COMPRESSED_RG11_EAC;if(n===Yu)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===ju||n===Zu||n===Ju||n===Ku||n===Qu||n===th||n===eh||n===nh||n===ih||n===rh||n===sh||n===oh||n===ah||n===lh)if(s=t.get("WEBGL_compressed_texture_astc"),s!==null){if(n===ju)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Zu)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ju)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Ku)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Qu)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===th)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===eh)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===nh)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ih)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===rh)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===sh)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===oh)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ah)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===lh)return o===Re?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ch||n===uh||n===hh)if(s=t.get("EXT_texture_compression_bptc"),s!==null){if(n===ch)return o===Re?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===uh)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===hh)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===fh||n===dh||n===Ml||n===ph)if(s=t.get("EXT_texture_compression_rgtc"),s!==null){if(n===fh)return s.COMPRESSED_RED_RGTC1_EXT;if(n===dh)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ml)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ph)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===$s?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var a2=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,l2=`
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

}`,kp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new nl(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Bi({vertexShader:a2,fragmentShader:l2,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ge(new zs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Bp=class extends Ki{constructor(t,e){super();let n=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,m=null,y=typeof XRWebGLBinding<"u",g=new kp,p={},x=e.getContextAttributes(),b=null,v=null,A=[],S=[],_=new Kt,w=null,N=null,C=new zn;C.viewport=new Ce;let P=new zn;P.viewport=new Ce;let O=[C,P],B=new Ru,F=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let gt=A[K];return gt===void 0&&(gt=new Jo,A[K]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(K){let gt=A[K];return gt===void 0&&(gt=new Jo,A[K]=gt),gt.getGripSpace()},this.getHand=function(K){let gt=A[K];return gt===void 0&&(gt=new Jo,A[K]=gt),gt.getHandSpace()};function q(K){let gt=S.indexOf(K.inputSource);if(gt===-1)return;let yt=A[gt];yt!==void 0&&(yt.update(K.inputSource,K.frame,c||o),yt.dispatchEvent({type:K.type,data:K.inputSource}))}function G(){r.removeEventListener("select",q),r.removeEventListener("selectstart",q),r.removeEventListener("selectend",q),r.removeEventListener("squeeze",q),r.removeEventListener("squeezestart",q),r.removeEventListener("squeezeend",q),r.removeEventListener("end",G),r.removeEventListener("inputsourceschange",rt);for(let K=0;K<A.length;K++){let gt=S[K];gt!==null&&(S[K]=null,A[K].disconnect(gt))}F=null,V=null,g.reset();for(let K in p)delete p[K];if(t.setRenderTarget(b),d=null,f=null,h=null,r=null,v=null,ct.stop(),n.isPresenting=!1,t.setPixelRatio(w),t.setSize(_.width,_.height,!1),N!==null){let K=N.camera;K.fov=N.fov,K.zoom=N.zoom,K.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){s=K,n.isPresenting===!0&&Zt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&Zt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(r,e)),h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(K){if(r=K,r!==null){if(b=t.getRenderTarget(),r.addEventListener("select",q),r.addEventListener("selectstart",q),r.addEventListener("selectend",q),r.addEventListener("squeeze",q),r.addEventListener("squeezestart",q),r.addEventListener("squeezeend",q),r.addEventListener("end",G),r.addEventListener("inputsourceschange",rt),x.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,Mt=null,xt=null;x.depth&&(xt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=x.stencil?Hr:zr,Mt=x.stencil?$s:er);let zt={colorFormat:e.RGBA8,depthFormat:xt,scaleFactor:s};h=this.getBinding(),f=h.createProjectionLayer(zt),r.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),v=new Ai(f.textureWidth,f.textureHeight,{format:rr,type:ui,depthTexture:new Vr(f.textureWidth,f.textureHeight,Mt,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let yt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(r,e,yt),r.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),v=new Ai(d.framebufferWidth,d.framebufferHeight,{format:rr,type:ui,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),ct.setContext(r),ct.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function rt(K){for(let gt=0;gt<K.removed.length;gt++){let yt=K.removed[gt],Mt=S.indexOf(yt);Mt>=0&&(S[Mt]=null,A[Mt].disconnect(yt))}for(let gt=0;gt<K.added.length;gt++){let yt=K.added[gt],Mt=S.indexOf(yt);if(Mt===-1){for(let zt=0;zt<A.length;zt++)if(zt>=S.length){S.push(yt),Mt=zt;break}else if(S[zt]===null){S[zt]=yt,Mt=zt;break}if(Mt===-1)break}let xt=A[Mt];xt&&xt.connect(yt)}}function $(K,gt){gt===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(gt.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(r===null)return;let gt=K.near,yt=K.far;g.texture!==null&&(g.depthNear>0&&(gt=g.depthNear),g.depthFar>0&&(yt=g.depthFar)),B.near=P.near=C.near=gt,B.far=P.far=C.far=yt,(F!==B.near||V!==B.far)&&(r.updateRenderState({depthNear:B.near,depthFar:B.far}),F=B.near,V=B.far),B.layers.mask=K.layers.mask|6,C.layers.mask=B.layers.mask&-5,P.layers.mask=B.layers.mask&-3;let Mt=K.parent,xt=B.cameras;$(B,Mt);for(let zt=0;zt<xt.length;zt++)$(xt[zt],Mt);B.projectionMatrix.copy(C.projectionMatrix),B.projectionMatrixInverse.copy(C.projectionMatrixInverse),N===null&&K.isPerspectiveCamera&&(N={camera:K,fov:K.fov,zoom:K.zoom}),j(K,B,Mt)};function j(K,gt,yt){yt===null?K.matrix.copy(gt.matrixWorld):(K.matrix.copy(yt.matrixWorld),K.matrix.invert(),K.matrix.multiply(gt.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(gt.projectionMatrix),K.projectionMatrixInverse.copy(gt.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=jo*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(K){l=K,f!==null&&(f.fixedFoveation=K),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=K)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function(K){return p[K]};let tt=null;function ut(K,gt){if(u=gt.getViewerPose(c||o),m=gt,u!==null){let yt=u.views;d!==null&&(t.setRenderTargetFramebuffer(v,d.framebuffer),t.setRenderTarget(v));let Mt=!1;yt.length!==B.cameras.length&&(B.cameras.length=0,Mt=!0);for(let dt=0;dt<yt.length;dt++){let Wt=yt[dt],qt=null;if(d!==null)qt=d.getViewport(Wt);else{let _e=h.getViewSubImage(f,Wt);qt=_e.viewport,dt===0&&(t.setRenderTargetTextures(v,_e.colorTexture,_e.depthStencilTexture),t.setRenderTarget(v))}let Yt=O[dt];Yt===void 0&&(Yt=new zn,Yt.layers.enable(dt),Yt.viewport=new Ce,O[dt]=Yt),Yt.matrix.fromArray(Wt.transform.matrix),Yt.matrix.decompose(Yt.position,Yt.quaternion,Yt.scale),Yt.projectionMatrix.fromArray(Wt.projectionMatrix),Yt.projectionMatrixInverse.copy(Yt.projectionMatrix).invert(),Yt.viewport.set(qt.x,qt.y,qt.width,qt.height),dt===0&&(B.matrix.copy(Yt.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Mt===!0&&B.cameras.push(Yt)}let xt=r.enabledFeatures;if(xt&&xt.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&y){h=n.getBinding();let dt=h.getDepthInformation(yt[0]);dt&&dt.isValid&&dt.texture&&g.init(dt,r.renderState)}if(xt&&xt.includes("camera-access")&&y){t.state.unbindTexture(),h=n.getBinding();for(let dt=0;dt<yt.length;dt++){let Wt=yt[dt].camera;if(Wt){let qt=p[Wt];qt||(qt=new nl,p[Wt]=qt);let Yt=h.getCameraImage(Wt);qt.sourceTexture=Yt}}}}for(let yt=0;yt<A.length;yt++){let Mt=S[yt],xt=A[yt];Mt!==null&&xt!==void 0&&xt.update(Mt,gt,c||o)}tt&&tt(K,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),m=null}let ct=new Y_;ct.setAnimationLoop(ut),this.setAnimationLoop=function(K){tt=K},this.dispose=function(){}}},c2=new ze,rv=new se;rv.set(-1,0,0,0,1,0,0,0,1);function u2(i,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,Ep(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function r(g,p,x,b,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?s(g,p):p.isMeshLambertMaterial?(s(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(s(g,p),h(g,p)):p.isMeshPhongMaterial?(s(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(s(g,p),f(g,p),p.isMeshPhysicalMaterial&&d(g,p,v)):p.isMeshMatcapMaterial?(s(g,p),m(g,p)):p.isMeshDepthMaterial?s(g,p):p.isMeshDistanceMaterial?(s(g,p),y(g,p)):p.isMeshNormalMaterial?s(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,x,b):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===ai&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===ai&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let x=t.get(p),b=x.envMap,v=x.envMapRotation;b&&(g.envMap.value=b,g.envMapRotation.value.setFromMatrix4(c2.makeRotationFromEuler(v)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(rv),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,x,b){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*x,g.scale.value=b*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function f(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function d(g,p,x){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ai&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function y(g,p){let x=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function h2(i,t,e,n){let r={},s={};function o(x,b){let v=b.program;n.uniformBlockBinding(x,v,r[x.id])}function a(x,b){let v=r[x.id];v===void 0&&(m(x),v=l(x),r[x.id]=v,x.addEventListener("dispose",g));let A=b.program;n.updateUBOMapping(x,A);let S=t.render.frame;s[x.id]!==S&&(c(x),s[x.id]=S)}function l(x){let b=i.createBuffer(),v=x.__size,A=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,b),i.bufferData(i.UNIFORM_BUFFER,v,A),i.bindBuffer(i.UNIFORM_BUFFER,null),b}function c(x){let b=r[x.id],v=x.uniforms,A=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,b);for(let S=0,_=v.length;S<_;S++){let w=v[S];if(Array.isArray(w))for(let N=0,C=w.length;N<C;N++)u(w[N],S,N,A);else u(w,S,0,A)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(x,b,v,A){if(f(x,b,v,A)===!0){let S=x.__offset,_=x.value;if(Array.isArray(_)){let w=0;for(let N=0;N<_.length;N++){let C=_[N],P=y(C,!0);h(C,x.__data,w),w+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,S,x.__data)}}function h(x,b,v){typeof x=="number"||typeof x=="boolean"?b[v]=x:x.isMatrix3?(b[v]=x.elements[0],b[v+1]=x.elements[1],b[v+2]=x.elements[2],b[v+3]=0,b[v+4]=x.elements[3],b[v+5]=x.elements[4],b[v+6]=x.elements[5],b[v+7]=0,b[v+8]=x.elements[6],b[v+9]=x.elements[7],b[v+10]=x.elements[8],b[v+11]=0):ArrayBuffer.isView(x)?b.set(x.subarray(0,b.length-v),v):x.toArray(b,v)}function f(x,b,v,A){let S=x.value,_=b+"_"+v;if(Array.isArray(S)){A[_]===void 0&&(A[_]=[]);let w=A[_],N=!1;for(let C=0;C<S.length;C++)d(S[C],w,C)===!0&&(N=!0);return N}return d(S,A,_)}function d(x,b,v){if(b[v]===void 0)return typeof x=="number"||typeof x=="boolean"?b[v]=x:ArrayBuffer.isView(x)?b[v]=x.slice():b[v]=x.clone(),!0;{let A=b[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return b[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function m(x){let b=x.uniforms,v=0,A=16;for(let _=0,w=b.length;_<w;_++){let N=Array.isArray(b[_])?b[_]:[b[_]];for(let C=0,P=N.length;C<P;C++){let O=N[C],B=Array.isArray(O.value)?O.value:[O.value],F=Array.isArray(b[_])||Array.isArray(O.value),V=v;for(let G=0,rt=B.length;G<rt;G++){let $=B[G],j=y($,F),tt=v%A,ut=tt%j.boundary,ct=tt+ut;v+=ut,ct!==0&&A-ct<j.storage&&(v+=A-ct),G===0&&(V=v),v+=j.storage}let q=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new q((v-V)/Float32Array.BYTES_PER_ELEMENT),O.__offset=V}}let S=v%A;return S>0&&(v+=A-S),x.__size=v,x.__cache={},this}function y(x,b){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?Zt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):Zt("WebGLRenderer: Unsupported uniform value type.",x),b===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(x){let b=x.target;b.removeEventListener("dispose",g),i.deleteBuffer(r[b.id]),delete r[b.id],delete s[b.id]}function p(){for(let x in r)i.deleteBuffer(r[x]);r={},s={}}return{bind:o,update:a,dispose:p}}var f2=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),_r=null;function d2(){return _r===null&&(_r=new cu(f2,16,16,xs,ir),_r.name="DFG_LUT",_r.minFilter=oi,_r.magFilter=oi,_r.wrapS=mr,_r.wrapT=mr,_r.generateMipmaps=!1,_r.needsUpdate=!0),_r}var _h=class{constructor(t={}){let{canvas:e=v_(),context:n=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=ui}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let y=d,g=new Set([ku,Uu,Ou]),p=new Set([ui,er,oa,$s,Nu,Du]),x=new Uint32Array(4),b=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,S=null,_=[],w=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=xr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,P=!1,O=null,B=null,F=null,V=null;this._outputColorSpace=Mi;let q=0,G=0,rt=null,$=-1,j=null,tt=new Ce,ut=new Ce,ct=null,K=new ce(0),gt=0,yt=e.width,Mt=e.height,xt=1,zt=null,te=null,dt=new Ce(0,0,yt,Mt),Wt=new Ce(0,0,yt,Mt),qt=!1,Yt=new ls,_e=new uu,Ne=!1,un=!1,De=new ze,Cn=new z,ve=new Ce,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qe=!1;function hn(){return rt===null?xt:1}let k=n;function Pt(R,H){return e.getContext(R,H)}let Jt,ae,At,Ue,Gt,jt,I,E,X,ft,ot,vt,bt,et,it,mt,U,st,nt,Et,_t,St,Ht;try{let R={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ne,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),k===null){let H="webgl2";if(k=Pt(H,R),k===null)throw Pt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ee()}catch(R){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),re("WebGLRenderer: "+R.message),R}function ee(){Jt=new SR(k),Jt.init(),_t=new o2(k,Jt),ae=new dR(k,Jt,t,_t),At=new r2(k,Jt),ae.reversedDepthBuffer&&f&&At.buffers.depth.setReversed(!0),B=k.createFramebuffer(),F=k.createFramebuffer(),V=k.createFramebuffer(),Ue=new TR(k),Gt=new WC,jt=new s2(k,Jt,At,Gt,ae,_t,Ue),I=new MR(C),E=new CA(k),St=new hR(k,E),X=new AR(k,E,Ue,St),ft=new CR(k,X,E,St,Ue),st=new RR(k,ae,jt),it=new pR(Gt),ot=new HC(C,I,Jt,ae,St,it),vt=new u2(C,Gt),bt=new XC,et=new KC(Jt),U=new uR(C,I,At,ft,m,l),mt=new i2(C,ft,ae),Ht=new h2(k,Ue,ae,At),nt=new fR(k,Jt,Ue),Et=new ER(k,Jt,Ue),Ue.programs=ot.programs,C.capabilities=ae,C.extensions=Jt,C.properties=Gt,C.renderLists=bt,C.shadowMap=mt,C.state=At,C.info=Ue}y!==ui&&(N=new IR(y,e.width,e.height,a,r,s));let ht=new Bp(C,k);this.xr=ht,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=Jt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Jt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return xt},this.setPixelRatio=function(R){R!==void 0&&(xt=R,this.setSize(yt,Mt,!1))},this.getSize=function(R){return R.set(yt,Mt)},this.setSize=function(R,H,Q=!0){if(ht.isPresenting){Zt("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=R,Mt=H,e.width=Math.floor(R*xt),e.height=Math.floor(H*xt),Q===!0&&(e.style.width=R+"px",e.style.height=H+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(yt*xt,Mt*xt).floor()},this.setDrawingBufferSize=function(R,H,Q){yt=R,Mt=H,xt=Q,e.width=Math.floor(R*Q),e.height=Math.floor(H*Q),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(y===ui){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Zt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(tt)},this.getViewport=function(R){return R.copy(dt)},this.setViewport=function(R,H,Q,Y){R.isVector4?dt.set(R.x,R.y,R.z,R.w):dt.set(R,H,Q,Y),At.viewport(tt.copy(dt).multiplyScalar(hn()).round())},this.getScissor=function(R){return R.copy(Wt)},this.setScissor=function(R,H,Q,Y){R.isVector4?Wt.set(R.x,R.y,R.z,R.w):Wt.set(R,H,Q,Y),At.scissor(ut.copy(Wt).multiplyScalar(hn()).round())},this.getScissorTest=function(){return qt},this.setScissorTest=function(R){At.setScissorTest(qt=R)},this.setOpaqueSort=function(R){zt=R},this.setTransparentSort=function(R){te=R},this.getClearColor=function(R){return R.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,Q=!0){let Y=0;if(R){let Z=!1;if(rt!==null){let Tt=rt.texture.format;Z=g.has(Tt)}if(Z){let Tt=rt.texture.type,Lt=p.has(Tt),Rt=U.getClearColor(),Ft=U.getClearAlpha(),Vt=Rt.r,ie=Rt.g,de=Rt.b;Lt?(x[0]=Vt,x[1]=ie,x[2]=de,x[3]=Ft,k.clearBufferuiv(k.COLOR,0,x)):(b[0]=Vt,b[1]=ie,b[2]=de,b[3]=Ft,k.clearBufferiv(k.COLOR,0,b))}else Y|=k.COLOR_BUFFER_BIT}H&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),O=R},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),U.dispose(),bt.dispose(),et.dispose(),jt.dispose(),Gt.dispose(),I.dispose(),ft.dispose(),X.dispose(),St.dispose(),Ht.dispose(),ot.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",Ol),ht.removeEventListener("sessionend",or),Ar.stop()};function kt(R){R.preventDefault(),$a("WebGLRenderer: Context Lost."),P=!0}function ne(){$a("WebGLRenderer: Context Restored."),P=!1;let R=Ue.autoReset,H=mt.enabled,Q=mt.autoUpdate,Y=mt.needsUpdate,Z=mt.type;ee(),Ue.autoReset=R,mt.enabled=H,mt.autoUpdate=Q,mt.needsUpdate=Y,mt.type=Z}function Ct(R){re("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ue(R){let H=R.target;H.removeEventListener("dispose",ue),He(H)}function He(R){Jn(R),Gt.remove(R)}function Jn(R){let H=Gt.get(R).programs;H!==void 0&&(H.forEach(function(Q){ot.releaseProgram(Q)}),R.isShaderMaterial&&ot.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,Q,Y,Z,Tt){H===null&&(H=_n);let Lt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Rt=ga(R,H,Q,Y,Z);At.setMaterial(Y,Lt);let Ft=Q.index,Vt=1;if(Y.wireframe===!0){if(Ft=X.getWireframeAttribute(Q),Ft===void 0)return;Vt=2}let ie=Q.drawRange,de=Q.attributes.position,Bt=ie.start*Vt,pe=(ie.start+ie.count)*Vt;Tt!==null&&(Bt=Math.max(Bt,Tt.start*Vt),pe=Math.min(pe,(Tt.start+Tt.count)*Vt)),Ft!==null?(Bt=Math.max(Bt,0),pe=Math.min(pe,Ft.count)):de!=null&&(Bt=Math.max(Bt,0),pe=Math.min(pe,de.count));let Je=pe-Bt;if(Je<0||Je===1/0)return;St.setup(Z,Y,Rt,Q,Ft);let Pe,Ie=nt;if(Ft!==null&&(Pe=E.get(Ft),Ie=Et,Ie.setIndex(Pe)),Z.isMesh)Y.wireframe===!0?(At.setLineWidth(Y.wireframeLinewidth*hn()),Ie.setMode(k.LINES)):Ie.setMode(k.TRIANGLES);else if(Z.isLine){let vn=Y.linewidth;vn===void 0&&(vn=1),At.setLineWidth(vn*hn()),Z.isLineSegments?Ie.setMode(k.LINES):Z.isLineLoop?Ie.setMode(k.LINE_LOOP):Ie.setMode(k.LINE_STRIP)}else Z.isPoints?Ie.setMode(k.POINTS):Z.isSprite&&Ie.setMode(k.TRIANGLES);if(Z.isBatchedMesh)if(Jt.get("WEBGL_multi_draw"))Ie.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let vn=Z._multiDrawStarts,Ot=Z._multiDrawCounts,fn=Z._multiDrawCount,ge=Ft?E.get(Ft).bytesPerElement:1,Tr=Gt.get(Y).currentProgram.getUniforms();for(let dn=0;dn<fn;dn++)Tr.setValue(k,"_gl_DrawID",dn),Ie.render(vn[dn]/ge,Ot[dn])}else if(Z.isInstancedMesh)Ie.renderInstances(Bt,Je,Z.count);else if(Q.isInstancedBufferGeometry){let vn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ot=Math.min(Q.instanceCount,vn);Ie.renderInstances(Bt,Je,Ot)}else Ie.render(Bt,Je)};function da(R,H,Q,Y){O!==null&&R.isNodeMaterial&&O.setObject(Y,R),Ne===!0&&it.setState(R,Q,!1),R.transparent===!0&&R.side===zi&&R.forceSinglePass===!1?(R.side=ai,R.needsUpdate=!0,ar(R,H,Y),R.side=ys,R.needsUpdate=!0,ar(R,H,Y),R.side=zi):ar(R,H,Y)}this.compile=function(R,H,Q=null){Q===null&&(Q=R),O!==null&&O.renderStart(R,H,Q),S=et.get(Q),S.init(H),w.push(S),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(S.pushLight(Z),Z.castShadow&&S.pushShadow(Z))}),R!==Q&&R.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(S.pushLight(Z),Z.castShadow&&S.pushShadow(Z))}),S.setupLights(),O!==null&&O.updateLights(S.state.lightsArray),un=this.localClippingEnabled,Ne=it.init(this.clippingPlanes,un),Ne===!0&&it.setGlobalState(this.clippingPlanes,H),O!==null&&mt.render(S.state.shadowsArray,Q,H);let Y=new Set;return R.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Tt=Z.material;if(Tt)if(Array.isArray(Tt))for(let Lt=0;Lt<Tt.length;Lt++){let Rt=Tt[Lt];da(Rt,Q,H,Z),Y.add(Rt)}else da(Tt,Q,H,Z),Y.add(Tt)}),S=w.pop(),O!==null&&O.renderEnd(),Y},this.compileAsync=function(R,H,Q=null){let Y=this.compile(R,H,Q);return new Promise(Z=>{function Tt(){if(Y.forEach(function(Lt){let Ft=Gt.get(Lt).currentProgram;(Ft===void 0||Ft.isReady())&&Y.delete(Lt)}),Y.size===0){Z(R);return}setTimeout(Tt,10)}Jt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Qs=null;function $h(R){Qs&&Qs(R)}function Ol(){Ar.stop()}function or(){Ar.start()}let Ar=new Y_;Ar.setAnimationLoop($h),typeof self<"u"&&Ar.setContext(self),this.setAnimationLoop=function(R){Qs=R,ht.setAnimationLoop(R),R===null?Ar.stop():Ar.start()},ht.addEventListener("sessionstart",Ol),ht.addEventListener("sessionend",or),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;O!==null&&O.renderStart(R,H);let Q=ht.enabled===!0&&ht.isPresenting===!0,Y=N!==null&&(rt===null||Q)&&N.begin(C,rt);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(H),H=ht.getCamera()),R.isScene===!0&&R.onBeforeRender(C,R,H,rt),S=et.get(R,w.length),S.init(H),S.state.textureUnits=jt.getTextureUnits(),w.push(S),De.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?_e.setFromArrayCamera(H):Yt.setFromProjectionMatrix(De,Ui,H.reversedDepth),un=this.localClippingEnabled,Ne=it.init(this.clippingPlanes,un),A=bt.get(R,_.length),A.init(),_.push(A),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Lt=C.xr.getDepthSensingMesh();Lt!==null&&Er(Lt,H,-1/0,C.sortObjects)}Er(R,H,0,C.sortObjects),A.finish(),O!==null&&O.updateLights(S.state.lightsArray),C.sortObjects===!0&&A.sort(zt,te),Qe=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,Qe&&U.addToRenderList(A,R),this.info.autoReset===!0&&this.info.reset(),Ne===!0&&it.beginShadows();let Z=S.state.shadowsArray;if(mt.render(Z,R,H),Ne===!0&&it.endShadows(),(Y&&N.hasRenderPass())===!1){let Lt=A.opaque,Rt=A.transmissive;if(S.setupLights(),H.isArrayCamera){let Ft=H.cameras;if(Rt.length>0)for(let Vt=0,ie=Ft.length;Vt<ie;Vt++){let de=Ft[Vt];Vi(Lt,Rt,R,de)}Qe&&U.render(R);for(let Vt=0,ie=Ft.length;Vt<ie;Vt++){let de=Ft[Vt];pa(A,R,de,de.viewport)}}else Rt.length>0&&Vi(Lt,Rt,R,H),Qe&&U.render(R),pa(A,R,H)}rt!==null&&G===0&&(jt.updateMultisampleRenderTarget(rt),jt.updateRenderTargetMipmap(rt)),Y&&N.end(C),R.isScene===!0&&R.onAfterRender(C,R,H),St.resetDefaultState(),$=-1,j=null,w.pop(),w.length>0?(S=w[w.length-1],jt.setTextureUnits(S.state.textureUnits),Ne===!0&&it.setGlobalState(C.clippingPlanes,S.state.camera)):S=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,O!==null&&O.renderEnd()};function Er(R,H,Q,Y){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)Q=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)S.pushLight(R),R.castShadow&&S.pushShadow(R);else if(R.isSprite){let Lt=H.isArrayCamera?_e:Yt;if(!R.frustumCulled||R.intersectsFrustum(Lt)){Y&&ve.setFromMatrixPosition(R.matrixWorld).applyMatrix4(De);let Rt=ft.update(R),Ft=R.material;Ft.visible&&A.push(R,Rt,Ft,Q,ve.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Lt=H.isArrayCamera?_e:Yt;if(!R.frustumCulled||R.intersectsFrustum(Lt)){let Rt=ft.update(R),Ft=R.material;if(Y&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),ve.copy(R.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),ve.copy(Rt.boundingSphere.center)),ve.applyMatrix4(R.matrixWorld).applyMatrix4(De)),Array.isArray(Ft)){let Vt=Rt.groups;for(let ie=0,de=Vt.length;ie<de;ie++){let Bt=Vt[ie],pe=Ft[Bt.materialIndex];pe&&pe.visible&&A.push(R,Rt,pe,Q,ve.z,Bt,H)}}else Ft.visible&&A.push(R,Rt,Ft,Q,ve.z,null,H)}}}let Tt=R.children;for(let Lt=0,Rt=Tt.length;Lt<Rt;Lt++)Er(Tt[Lt],H,Q,Y)}function pa(R,H,Q,Y){let{opaque:Z,transmissive:Tt,transparent:Lt}=R;S.setupLightsView(Q),Ne===!0&&it.setGlobalState(C.clippingPlanes,Q),Y&&At.viewport(tt.copy(Y)),Z.length>0&&tn(Z,H,Q),Tt.length>0&&tn(Tt,H,Q),Lt.length>0&&tn(Lt,H,Q),At.buffers.depth.setTest(!0),At.buffers.depth.setMask(!0),At.buffers.color.setMask(!0),At.setPolygonOffset(!1)}function Vi(R,H,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[Y.id]===void 0){let Bt=Jt.has("EXT_color_buffer_half_float")||Jt.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[Y.id]=new Ai(1,1,{generateMipmaps:!0,type:Bt?ir:ui,minFilter:Gr,samples:Math.max(4,ae.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xe.workingColorSpace})}let Tt=S.state.transmissionRenderTarget[Y.id],Lt=Y.viewport||tt;Tt.setSize(Lt.z*C.transmissionResolutionScale,Lt.w*C.transmissionResolutionScale);let Rt=C.getRenderTarget(),Ft=C.getActiveCubeFace(),Vt=C.getActiveMipmapLevel();C.setRenderTarget(Tt),C.getClearColor(K),gt=C.getClearAlpha(),gt<1&&C.setClearColor(16777215,.5),C.clear(),Qe&&U.render(Q);let ie=C.toneMapping;C.toneMapping=xr;let de=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),S.setupLightsView(Y),Ne===!0&&it.setGlobalState(C.clippingPlanes,Y),tn(R,Q,Y),jt.updateMultisampleRenderTarget(Tt),jt.updateRenderTargetMipmap(Tt),Jt.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let pe=0,Je=H.length;pe<Je;pe++){let Pe=H[pe],{object:Ie,geometry:vn,material:Ot,group:fn}=Pe;if(Ot.side===zi&&Ie.layers.test(Y.layers)){let ge=Ot.side;Ot.side=ai,Ot.needsUpdate=!0,ln(Ie,Q,Y,vn,Ot,fn),Ot.side=ge,Ot.needsUpdate=!0,Bt=!0}}Bt===!0&&(jt.updateMultisampleRenderTarget(Tt),jt.updateRenderTargetMipmap(Tt))}C.setRenderTarget(Rt,Ft,Vt),C.setClearColor(K,gt),de!==void 0&&(Y.viewport=de),C.toneMapping=ie}function tn(R,H,Q){let Y=H.isScene===!0?H.overrideMaterial:null;for(let Z=0,Tt=R.length;Z<Tt;Z++){let Lt=R[Z],{object:Rt,geometry:Ft,group:Vt}=Lt,ie=Lt.material;ie.allowOverride===!0&&Y!==null&&(ie=Y),Rt.layers.test(Q.layers)&&ln(Rt,H,Q,Ft,ie,Vt)}}function ln(R,H,Q,Y,Z,Tt){O!==null&&Z.isNodeMaterial&&O.setObject(R,Z),R.onBeforeRender(C,H,Q,Y,Z,Tt),R.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Z.onBeforeRender(C,H,Q,Y,R,Tt),Z.transparent===!0&&Z.side===zi&&Z.forceSinglePass===!1?(Z.side=ai,Z.needsUpdate=!0,C.renderBufferDirect(Q,H,Y,Z,R,Tt),Z.side=ys,Z.needsUpdate=!0,C.renderBufferDirect(Q,H,Y,Z,R,Tt),Z.side=zi):C.renderBufferDirect(Q,H,Y,Z,R,Tt),R.onAfterRender(C,H,Q,Y,Z,Tt)}function cn(R){let H=0;for(let Q of R)Q.texture!==null&&H++;return H}function ar(R,H,Q){H.isScene!==!0&&(H=_n);let Y=Gt.get(R),Z=S.state.lights,Tt=S.state.shadowsArray,Lt=Z.state.version,Rt=ot.getParameters(R,Z.state,Tt,H,Q,S.state.lightProbeGridArray),Ft=ot.getProgramCacheKey(Rt),Vt=Y.programs;Y.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,Y.fog=H.fog;let ie=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Y.envMap=I.get(R.envMap||Y.environment,ie),Y.envMapRotation=Y.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,Vt===void 0&&(R.addEventListener("dispose",ue),Vt=new Map,Y.programs=Vt,Y.programVariants=new Map);let de=Vt.get(Ft);if(de!==void 0){if(Y.currentProgram===de&&Y.lightsStateVersion===Lt)return ma(R,Rt),de}else Rt.uniforms=ot.getUniforms(R),O!==null&&R.isNodeMaterial&&O.build(R,Q,Rt),R.onBeforeCompile(Rt,C),de=ot.acquireProgram(Rt,Ft),Vt.set(Ft,de),Y.uniforms=Rt.uniforms;let Bt=Y.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Bt.clippingPlanes=it.uniform),ma(R,Rt),Y.needsLights=$r(R),Y.lightsStateVersion=Lt,Y.needsLights&&(Bt.ambientLightColor.value=Z.state.ambient,Bt.lightProbe.value=Z.state.probe,Bt.sunLights.value=Z.state.sun,Bt.sunLightShadows.value=Z.state.sunShadow,Bt.directionalLights.value=Z.state.directional,Bt.directionalLightShadows.value=Z.state.directionalShadow,Bt.spotLights.value=Z.state.spot,Bt.spotLightShadows.value=Z.state.spotShadow,Bt.rectAreaLights.value=Z.state.rectArea,Bt.ltc_1.value=Z.state.rectAreaLTC1,Bt.ltc_2.value=Z.state.rectAreaLTC2,Bt.pointLights.value=Z.state.point,Bt.pointLightShadows.value=Z.state.pointShadow,Bt.hemisphereLights.value=Z.state.hemi,Bt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Bt.sunShadowCascade.value=Z.state.sunShadowCascade,Bt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Bt.spotLightMatrix.value=Z.state.spotLightMatrix,Bt.spotLightMap.value=Z.state.spotLightMap,Bt.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=cn(S.state.lightProbeGridArray),Y.currentProgram=de,Y.uniformsList=null,de}function fi(R,H,Q,Y,Z){let Tt=Gt.get(R),Lt=Tt.currentProgram.id+","+Y+","+Z,Rt=Tt.programVariants.get(Lt);return Rt===void 0?(Rt=ar(R,H,Q),Tt.programVariants.set(Lt,Rt)):(Tt.currentProgram=Rt,Tt.uniformsList=null,Tt.outputColorSpace=Y,Tt.toneMapping=Z),Rt}function Xr(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=aa.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function ma(R,H){let Q=Gt.get(R);Q.outputColorSpace=H.outputColorSpace,Q.batching=H.batching,Q.batchingColor=H.batchingColor,Q.instancing=H.instancing,Q.instancingColor=H.instancingColor,Q.instancingMorph=H.instancingMorph,Q.skinning=H.skinning,Q.morphTargets=H.morphTargets,Q.morphNormals=H.morphNormals,Q.morphColors=H.morphColors,Q.morphTargetsCount=H.morphTargetsCount,Q.numClippingPlanes=H.numClippingPlanes,Q.numIntersection=H.numClipIntersection,Q.vertexAlphas=H.vertexAlphas,Q.vertexTangents=H.vertexTangents,Q.toneMapping=H.toneMapping}function ga(R,H,Q,Y,Z){H.isScene!==!0&&(H=_n),jt.resetTextureUnits();let Tt=H.fog,Lt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?H.environment:null,Rt=rt===null?C.outputColorSpace:rt.isXRRenderTarget===!0?rt.texture.colorSpace:xe.workingColorSpace,Ft=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Vt=I.get(Y.envMap||Lt,Ft),ie=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,de=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Bt=!!Q.morphAttributes.position,pe=!!Q.morphAttributes.normal,Je=!!Q.morphAttributes.color,Pe=xr;Y.toneMapped&&(rt===null||rt.isXRRenderTarget===!0)&&(Pe=C.toneMapping);let Ie=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,vn=Ie!==void 0?Ie.length:0,Ot=Gt.get(Y),fn=S.state.lights;if(Ne===!0&&(un===!0||R!==j)){let Le=R===j&&Y.id===$;it.setState(Y,R,Le)}let ge=!1,Tr=!1;Y.version===Ot.__version?Ot.needsLights&&Ot.lightsStateVersion!==fn.state.version||Z.isBatchedMesh&&Ot.batching===!1||!Z.isBatchedMesh&&Ot.batching===!0||Z.isBatchedMesh&&Ot.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ot.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ot.instancing===!1||!Z.isInstancedMesh&&Ot.instancing===!0||Z.isSkinnedMesh&&Ot.skinning===!1||!Z.isSkinnedMesh&&Ot.skinning===!0||Z.isInstancedMesh&&Ot.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ot.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ot.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ot.instancingMorph===!1&&Z.morphTexture!==null||Ot.envMap!==Vt||Y.fog===!0&&Ot.fog!==Tt||Ot.numClippingPlanes!==void 0&&(Ot.numClippingPlanes!==it.numPlanes||Ot.numIntersection!==it.numIntersection)||Ot.vertexAlphas!==ie||Ot.vertexTangents!==de||Ot.morphTargets!==Bt||Ot.morphNormals!==pe||Ot.morphColors!==Je||Ot.morphTargetsCount!==vn||Ot.numLightProbeGrids!==cn(S.state.lightProbeGridArray)?ge=!0:(Ot.outputColorSpace!==Rt||Ot.toneMapping!==Pe)&&(Tr=!0):(ge=!0,Ot.__version=Y.version);let dn=Ot.currentProgram;(ge===!0||Tr===!0)&&(dn=Tr===!0?fi(Y,H,Z,Rt,Pe):ar(Y,H,Z),O&&Y.isNodeMaterial&&O.onUpdateProgram(Y,dn,Ot));let no=!1,lr=!1,Rr=!1,he=dn.getUniforms(),en=Ot.uniforms;if(At.useProgram(dn.program)&&(no=!0,lr=!0,Rr=!0),Y.id!==$&&($=Y.id,lr=!0),no||j!==R){At.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),he.setValue(k,"projectionMatrix",R.projectionMatrix),he.setValue(k,"viewMatrix",R.matrixWorldInverse);let pn=he.map.cameraPosition;pn!==void 0&&pn.setValue(k,Cn.setFromMatrixPosition(R.matrixWorld)),ae.logarithmicDepthBuffer&&he.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&he.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),j!==R&&(j=R,lr=!0,Rr=!0)}if(Ot.needsLights&&(fn.state.sunShadowMap.length>0&&he.setValue(k,"sunShadowMap",fn.state.sunShadowMap,jt),fn.state.directionalShadowMap.length>0&&he.setValue(k,"directionalShadowMap",fn.state.directionalShadowMap,jt),fn.state.spotShadowMap.length>0&&he.setValue(k,"spotShadowMap",fn.state.spotShadowMap,jt),fn.state.pointShadowMap.length>0&&he.setValue(k,"pointShadowMap",fn.state.pointShadowMap,jt)),Z.isSkinnedMesh){he.setOptional(k,Z,"bindMatrix"),he.setOptional(k,Z,"bindMatrixInverse");let Le=Z.skeleton;Le&&(Le.boneTexture===null&&Le.computeBoneTexture(),he.setValue(k,"boneTexture",Le.boneTexture,jt))}Z.isBatchedMesh&&(he.setOptional(k,Z,"batchingTexture"),he.setValue(k,"batchingTexture",Z._matricesTexture,jt),he.setOptional(k,Z,"batchingIdTexture"),he.setValue(k,"batchingIdTexture",Z._indirectTexture,jt),he.setOptional(k,Z,"batchingColorTexture"),Z._colorsTexture!==null&&he.setValue(k,"batchingColorTexture",Z._colorsTexture,jt));let Kn=Q.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&st.update(Z,Q,dn),(lr||Ot.receiveShadow!==Z.receiveShadow)&&(Ot.receiveShadow=Z.receiveShadow,he.setValue(k,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&H.environment!==null&&(en.envMapIntensity.value=H.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=d2()),lr){if(he.setValue(k,"toneMappingExposure",C.toneMappingExposure),Ot.needsLights&&to(en,Rr),Tt&&Y.fog===!0&&vt.refreshFogUniforms(en,Tt),vt.refreshMaterialUniforms(en,Y,xt,Mt,S.state.transmissionRenderTarget[R.id]),Ot.needsLights&&Ot.numLightProbeGrids>0){let Le=v,pn=0;for(let Xn of S.state.lightProbeGridArray)Xn.texture!==null&&(Le.textures[pn]=Xn.texture,Le.min[pn]=Xn.boundingBox.min,Le.max[pn]=Xn.boundingBox.max,Le.resolution[pn]=Xn.resolution,pn++);for(let Xn in Le)Le[Xn].length=pn;en.probesSH.value=Le.textures,en.probesMin.value=Le.min,en.probesMax.value=Le.max,en.probesResolution.value=Le.resolution}aa.upload(k,Xr(Ot),en,jt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(aa.upload(k,Xr(Ot),en,jt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&he.setValue(k,"center",Z.center),he.setValue(k,"modelViewMatrix",Z.modelViewMatrix),he.setValue(k,"normalMatrix",Z.normalMatrix),he.setValue(k,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Le=Y.uniformsGroups;for(let pn=0,Xn=Le.length;pn<Xn;pn++){let Ul=Le[pn];Ht.update(Ul,dn),Ht.bind(Ul,dn)}}return dn}function to(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function $r(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return rt},this.setRenderTargetTextures=function(R,H,Q){let Y=Gt.get(R);Y.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Gt.get(R.texture).__webglTexture=H,Gt.get(R.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let Q=Gt.get(R);Q.__webglFramebuffer=H,Q.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,Q=0){rt=R,q=H,G=Q;let Y=null,Z=!1,Tt=!1;if(R){let Rt=Gt.get(R);if(Rt.__useDefaultFramebuffer!==void 0){At.bindFramebuffer(k.FRAMEBUFFER,Rt.__webglFramebuffer),tt.copy(R.viewport),ut.copy(R.scissor),ct=R.scissorTest,At.viewport(tt),At.scissor(ut),At.setScissorTest(ct),$=-1;return}else if(Rt.__webglFramebuffer===void 0)jt.setupRenderTarget(R);else if(Rt.__hasExternalTextures)jt.rebindTextures(R,Gt.get(R.texture).__webglTexture,Gt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let ie=R.depthTexture;if(Rt.__boundDepthTexture!==ie){if(ie!==null&&Gt.has(ie)&&(R.width!==ie.image.width||R.height!==ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");jt.setupDepthRenderbuffer(R)}}let Ft=R.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(Tt=!0);let Vt=Gt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Vt[H])?Y=Vt[H][Q]:Y=Vt[H],Z=!0):R.samples>0&&jt.useMultisampledRTT(R)===!1?Y=Gt.get(R).__webglMultisampledFramebuffer:Array.isArray(Vt)?Y=Vt[Q]:Y=Vt,tt.copy(R.viewport),ut.copy(R.scissor),ct=R.scissorTest}else tt.copy(dt).multiplyScalar(xt).floor(),ut.copy(Wt).multiplyScalar(xt).floor(),ct=qt;if(Q!==0&&(Y=B),At.bindFramebuffer(k.FRAMEBUFFER,Y)&&At.drawBuffers(R,Y),At.viewport(tt),At.scissor(ut),At.setScissorTest(ct),Z){let Rt=Gt.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+H,Rt.__webglTexture,Q)}else if(Tt){let Rt=H;for(let Ft=0;Ft<R.textures.length;Ft++){let Vt=Gt.get(R.textures[Ft]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ft,Vt.__webglTexture,Q,Rt)}}else if(R!==null&&Q!==0){let Rt=Gt.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Rt.__webglTexture,Q)}$=-1};function eo(R){let H=Gt.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=ae.textureFormatReadable(R.format),H.__typeReadable=ae.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,Q,Y,Z,Tt,Lt,Rt=0){if(!(R&&R.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Gt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Lt!==void 0&&(Ft=Ft[Lt],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){At.bindFramebuffer(k.FRAMEBUFFER,Ft);try{let Vt=R.textures[Rt],ie=Vt.format,de=Vt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Bt=eo(Vt);if(Bt.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-Y&&Q>=0&&Q<=R.height-Z&&k.readPixels(H,Q,Y,Z,_t.convert(ie),_t.convert(de),Tt)}finally{let Vt=rt!==null?Gt.get(rt).__webglFramebuffer:null;At.bindFramebuffer(k.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(R,H,Q,Y,Z,Tt,Lt,Rt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Gt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Lt!==void 0&&(Ft=Ft[Lt],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(H>=0&&H<=R.width-Y&&Q>=0&&Q<=R.height-Z){At.bindFramebuffer(k.FRAMEBUFFER,Ft);let Vt=R.textures[Rt],ie=Vt.format,de=Vt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Bt=eo(Vt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pe=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,pe),k.bufferData(k.PIXEL_PACK_BUFFER,Tt.byteLength,k.STREAM_READ),k.readPixels(H,Q,Y,Z,_t.convert(ie),_t.convert(de),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let Je=rt!==null?Gt.get(rt).__webglFramebuffer:null;At.bindFramebuffer(k.FRAMEBUFFER,Je);let Pe=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await w_(k,Pe,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,pe),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Tt),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(pe),k.deleteSync(Pe),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,Q=0){let Y=Math.pow(2,-Q),Z=Math.floor(R.image.width*Y),Tt=Math.floor(R.image.height*Y),Lt=H!==null?H.x:0,Rt=H!==null?H.y:0;jt.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,Lt,Rt,Z,Tt),At.unbindTexture()},this.copyTextureToTexture=function(R,H,Q=null,Y=null,Z=0,Tt=0){let Lt,Rt,Ft,Vt,ie,de,Bt,pe,Je,Pe=R.isCompressedTexture?R.mipmaps[Tt]:R.image;if(Q!==null)Lt=Q.max.x-Q.min.x,Rt=Q.max.y-Q.min.y,Ft=Q.isBox3?Q.max.z-Q.min.z:1,Vt=Q.min.x,ie=Q.min.y,de=Q.isBox3?Q.min.z:0;else{let he=Math.pow(2,-Z);Lt=Math.floor(Pe.width*he),Rt=Math.floor(Pe.height*he),R.isDataArrayTexture?Ft=Pe.depth:R.isData3DTexture?Ft=Math.floor(Pe.depth*he):Ft=1,Vt=0,ie=0,de=0}Y!==null?(Bt=Y.x,pe=Y.y,Je=Y.z):(Bt=0,pe=0,Je=0);let Ie=_t.convert(H.format),vn=_t.convert(H.type),Ot;H.isData3DTexture?(jt.setTexture3D(H,0),Ot=k.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(jt.setTexture2DArray(H,0),Ot=k.TEXTURE_2D_ARRAY):(jt.setTexture2D(H,0),Ot=k.TEXTURE_2D),At.activeTexture(k.TEXTURE0),At.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,H.flipY),At.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),At.pixelStorei(k.UNPACK_ALIGNMENT,H.unpackAlignment);let fn=At.getParameter(k.UNPACK_ROW_LENGTH),ge=At.getParameter(k.UNPACK_IMAGE_HEIGHT),Tr=At.getParameter(k.UNPACK_SKIP_PIXELS),dn=At.getParameter(k.UNPACK_SKIP_ROWS),no=At.getParameter(k.UNPACK_SKIP_IMAGES);At.pixelStorei(k.UNPACK_ROW_LENGTH,Pe.width),At.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Pe.height),At.pixelStorei(k.UNPACK_SKIP_PIXELS,Vt),At.pixelStorei(k.UNPACK_SKIP_ROWS,ie),At.pixelStorei(k.UNPACK_SKIP_IMAGES,de);let lr=R.isDataArrayTexture||R.isData3DTexture,Rr=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let he=Gt.get(R),en=Gt.get(H),Kn=Gt.get(he.__renderTarget),Le=Gt.get(en.__renderTarget);At.bindFramebuffer(k.READ_FRAMEBUFFER,Kn.__webglFramebuffer),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,Le.__webglFramebuffer);for(let pn=0;pn<Ft;pn++)lr&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gt.get(R).__webglTexture,Z,de+pn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gt.get(H).__webglTexture,Tt,Je+pn)),k.blitFramebuffer(Vt,ie,Vt+Lt,ie+Rt,Bt,pe,Bt+Lt,pe+Rt,k.DEPTH_BUFFER_BIT,k.NEAREST);At.bindFramebuffer(k.READ_FRAMEBUFFER,null),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Z!==0||R.isRenderTargetTexture||Gt.has(R)){let he=Gt.get(R),en=Gt.get(H);At.bindFramebuffer(k.READ_FRAMEBUFFER,F),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,V);for(let Kn=0;Kn<Ft;Kn++)lr?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,he.__webglTexture,Z,de+Kn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,he.__webglTexture,Z),Rr?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,en.__webglTexture,Tt,Je+Kn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,en.__webglTexture,Tt),Z!==0?k.blitFramebuffer(Vt,ie,Vt+Lt,ie+Rt,Bt,pe,Bt+Lt,pe+Rt,k.COLOR_BUFFER_BIT,k.NEAREST):Rr?k.copyTexSubImage3D(Ot,Tt,Bt,pe,Je+Kn,Vt,ie,Lt,Rt):k.copyTexSubImage2D(Ot,Tt,Bt,pe,Vt,ie,Lt,Rt);At.bindFramebuffer(k.READ_FRAMEBUFFER,null),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Rr?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(Ot,Tt,Bt,pe,Je,Lt,Rt,Ft,Ie,vn,Pe.data):H.isCompressedArrayTexture?k.compressedTexSubImage3D(Ot,Tt,Bt,pe,Je,Lt,Rt,Ft,Ie,Pe.data):k.texSubImage3D(Ot,Tt,Bt,pe,Je,Lt,Rt,Ft,Ie,vn,Pe):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,pe,Lt,Rt,Ie,vn,Pe.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Tt,Bt,pe,Pe.width,Pe.height,Ie,Pe.data):k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,pe,Lt,Rt,Ie,vn,Pe);At.pixelStorei(k.UNPACK_ROW_LENGTH,fn),At.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ge),At.pixelStorei(k.UNPACK_SKIP_PIXELS,Tr),At.pixelStorei(k.UNPACK_SKIP_ROWS,dn),At.pixelStorei(k.UNPACK_SKIP_IMAGES,no),Tt===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&k.generateMipmap(Ot),At.unbindTexture()},this.initRenderTarget=function(R){Gt.get(R).__webglFramebuffer===void 0&&jt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?jt.setTextureCube(R,0):R.isData3DTexture?jt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?jt.setTexture2DArray(R,0):jt.setTexture2D(R,0),At.unbindTexture()},this.resetState=function(){q=0,G=0,rt=null,At.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ui}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=xe._getDrawingBufferColorSpace(t),e.unpackColorSpace=xe._getUnpackColorSpace()}};var sv={type:"change"},Vp={type:"start"},av={type:"end"},wh=new Bs,ov=new Si,p2=Math.cos(70*sr.DEG2RAD),Rn=new z,hi=2*Math.PI,Ee={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},zp=1e-6,Mh=class extends gl{constructor(t,e=null){super(t,e),this.state=Ee.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ms.ROTATE,MIDDLE:ms.DOLLY,RIGHT:ms.PAN},this.touches={ONE:gs.ROTATE,TWO:gs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new kn,this._lastTargetPosition=new z,this._quat=new kn().setFromUnitVectors(t.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ps,this._sphericalDelta=new ps,this._scale=1,this._panOffset=new z,this._rotateStart=new Kt,this._rotateEnd=new Kt,this._rotateDelta=new Kt,this._panStart=new Kt,this._panEnd=new Kt,this._panDelta=new Kt,this._dollyStart=new Kt,this._dollyEnd=new Kt,this._dollyDelta=new Kt,this._dollyDirection=new z,this._mouse=new Kt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=g2.bind(this),this._onPointerDown=m2.bind(this),this._onPointerUp=y2.bind(this),this._onContextMenu=S2.bind(this),this._onMouseWheel=v2.bind(this),this._onKeyDown=b2.bind(this),this._onTouchStart=w2.bind(this),this._onTouchMove=M2.bind(this),this._onMouseDown=x2.bind(this),this._onMouseMove=_2.bind(this),this._interceptControlDown=A2.bind(this),this._interceptControlUp=E2.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ee.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(sv),this.update(),this.state=Ee.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Rn.copy(e).sub(this.target),Rn.applyQuaternion(this._quat),this._spherical.setFromVector3(Rn),this.autoRotate&&this.state===Ee.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(n)&&isFinite(r)&&(n<-Math.PI?n+=hi:n>Math.PI&&(n-=hi),r<-Math.PI?r+=hi:r>Math.PI&&(r-=hi),n<=r?this._spherical.theta=Math.max(n,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+r)/2?Math.max(n,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let s=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),s=o!=this._spherical.radius}if(Rn.setFromSpherical(this._spherical),Rn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Rn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Rn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),s=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),s=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Rn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(wh.origin.copy(this.object.position),wh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(wh.direction))<p2?this.object.lookAt(this.target):(ov.setFromNormalAndCoplanarPoint(this.object.up,this.target),wh.intersectPlane(ov,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),s=!0)}return this._scale=1,this._performCursorZoom=!1,s||this._lastPosition.distanceToSquared(this.object.position)>zp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>zp||this._lastTargetPosition.distanceToSquared(this.target)>zp?(this.dispatchEvent(sv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?hi/60*this.autoRotateSpeed*t:hi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Rn.setFromMatrixColumn(e,0),Rn.multiplyScalar(-t),this._panOffset.add(Rn)}_panUp(t,e){this.screenSpacePanning===!0?Rn.setFromMatrixColumn(e,1):(Rn.setFromMatrixColumn(e,0),Rn.crossVectors(this.object.up,Rn)),Rn.multiplyScalar(t),this._panOffset.add(Rn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;Rn.copy(r).sub(this.target);let s=Rn.length();s*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*s/n.clientHeight,this.object.matrix),this._panUp(2*e*s/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),r=t-n.left,s=e-n.top,o=n.width,a=n.height;this._mouse.x=r/o*2-1,this._mouse.y=-(s/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/e.clientHeight),this._rotateUp(hi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-hi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._rotateStart.set(n,r)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._panStart.set(n,r)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,r=t.pageY-e.y,s=Math.sqrt(n*n+r*r);this._dollyStart.set(0,s)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),r=.5*(t.pageX+n.x),s=.5*(t.pageY+n.y);this._rotateEnd.set(r,s)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(hi*this._rotateDelta.x/e.clientHeight),this._rotateUp(hi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._panEnd.set(n,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,r=t.pageY-e.y,s=Math.sqrt(n*n+r*r);this._dollyEnd.set(0,s),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Kt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function m2(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function g2(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function y2(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(av),this.state=Ee.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function x2(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case ms.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ee.DOLLY;break;case ms.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ee.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ee.ROTATE}break;case ms.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ee.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ee.PAN}break;default:this.state=Ee.NONE}this.state!==Ee.NONE&&this.dispatchEvent(Vp)}function _2(i){switch(this.state){case Ee.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ee.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ee.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function v2(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ee.NONE||(i.preventDefault(),this.dispatchEvent(Vp),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(av))}function b2(i){this.enabled!==!1&&this._handleKeyDown(i)}function w2(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case gs.ROTATE:if(this.enableRotate===!1){this.state=Ee.NONE;break}this._handleTouchStartRotate(i),this.state=Ee.TOUCH_ROTATE;break;case gs.PAN:if(this.enablePan===!1){this.state=Ee.NONE;break}this._handleTouchStartPan(i),this.state=Ee.TOUCH_PAN;break;default:this.state=Ee.NONE}break;case 2:switch(this.touches.TWO){case gs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ee.TOUCH_DOLLY_PAN;break;case gs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ee.TOUCH_DOLLY_ROTATE;break;default:this.state=Ee.NONE}break;default:this.state=Ee.NONE}this.state!==Ee.NONE&&this.dispatchEvent(Vp)}function M2(i){switch(this._trackPointer(i),this.state){case Ee.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ee.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ee.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ee.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ee.NONE}}function S2(i){this.enabled!==!1&&i.preventDefault()}function A2(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function E2(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var lv=["iso","front","side","top","tip"],T2={iso:[.62,-1,.55],front:[1,0,.08],side:[0,-1,.08],top:[0,-.001,1],tip:[.62,-1,.4]},R2=.35,Sh=class{constructor(t,e,n,r){this.camera=t;this.canvas=e;this.reach=n;this.changed=r;this.controls=new Mh(t,e),this.controls.minDistance=.05*n,this.controls.maxDistance=40*n,this.controls.enableZoom=!1,this.controls.addEventListener("change",r),e.addEventListener("keydown",this.key),e.addEventListener("focus",this.zoomable),e.addEventListener("blur",this.zoomable)}camera;canvas;reach;changed;view="iso";box=new Gn;controls;start=new z;end=new z;targetStart=new z;targetEnd=new z;offset=new z;spherical=new ps;began=0;gliding=0;show(t,e,n){this.view=t;let r=this.offset.set(...T2[t]).normalize(),s=t==="tip";s?this.targetEnd.fromArray(e):this.box.getCenter(this.targetEnd);let o=s?.55*this.reach:this.fitting(r,this.targetEnd);if(this.end.copy(this.targetEnd).addScaledVector(r,o),cancelAnimationFrame(this.gliding),!n)return this.place(1);this.start.copy(this.camera.position),this.targetStart.copy(this.controls.target),this.began=performance.now(),this.step(this.began)}take(t){this.view=t.view,this.camera.position.copy(t.camera.position),this.controls.target.copy(t.controls.target),this.controls.update()}follow(t){this.view==="tip"&&(this.offset.copy(this.camera.position).sub(this.controls.target),this.controls.target.fromArray(t),this.camera.position.copy(this.controls.target).add(this.offset),this.camera.lookAt(this.controls.target))}dispose(){cancelAnimationFrame(this.gliding),this.controls.dispose(),this.canvas.removeEventListener("keydown",this.key),this.canvas.removeEventListener("focus",this.zoomable),this.canvas.removeEventListener("blur",this.zoomable)}zoomable=t=>{this.controls.enableZoom=t.type==="focus"};key=t=>{if(t.ctrlKey||t.metaKey||t.altKey)return;let e=sr.degToRad(5),r={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[t.key];if(r&&t.shiftKey)this.pan(.04*r[0],-.04*r[1]);else if(r)this.turn(e*r[0],e*r[1],1);else if(t.key==="+"||t.key==="=")this.turn(0,0,1/1.15);else if(t.key==="-")this.turn(0,0,1.15);else return;t.preventDefault(),t.stopPropagation()};turn(t,e,n){let{camera:r,controls:s,offset:o,spherical:a}=this;o.copy(r.position).sub(s.target),a.setFromCartesianCoords(o.y,o.z,o.x),a.theta+=t,a.phi=sr.clamp(a.phi+e,.001,Math.PI-.001),a.radius=sr.clamp(a.radius*n,s.minDistance,s.maxDistance),o.setFromSpherical(a),r.position.set(o.z,o.x,o.y).add(s.target),s.update(),this.changed()}pan(t,e){let{camera:n,controls:r,offset:s}=this,o=n.position.distanceTo(r.target);for(let[a,l]of[[0,t],[1,e]])s.setFromMatrixColumn(n.matrix,a).multiplyScalar(l*o),n.position.add(s),r.target.add(s);r.update(),this.changed()}fitting(t,e){let{camera:n,box:r}=this,s=Math.tan(sr.degToRad(n.fov/2)),o=new z().crossVectors(n.up,t).normalize(),a=new z().crossVectors(t,o),l=new z,c=.3*this.reach;for(let u=0;u<8;u++){l.set(u&1?r.max.x:r.min.x,u&2?r.max.y:r.min.y,u&4?r.max.z:r.min.z).sub(e);let h=l.dot(t);c=Math.max(c,Math.abs(l.dot(o))/(s*n.aspect)+h,Math.abs(l.dot(a))/s+h)}return 1.18*c}step=t=>{let e=Math.min(1,Math.max(0,(t-this.began)/1e3/R2));this.place(e*e*(3-2*e)),e<1&&(this.gliding=requestAnimationFrame(this.step))};place(t){this.camera.position.lerpVectors(t<1?this.start:this.end,this.end,t),this.controls.target.lerpVectors(t<1?this.targetStart:this.targetEnd,this.targetEnd,t),this.controls.update(),this.changed()}};var cv=[["reference","Nominal (ghost)"],["rigid","Rigid plan (ghost)"],["traces","Paths of the tips"],["force","Contact force"],["surface","Surface"],["floor","Floor"],["apart","Side by side"]];var P2={iso:"Oblique",front:"Front",side:"Side",top:"Top",tip:"Tip (follows)"},uv=100;function Fe(i,t={},...e){let n=document.createElement(i);return Object.assign(n,t),n.append(...e),n}function fv(i,t,e,n,r,s){let o=Fe("div",{className:"scene-bar",role:"toolbar",ariaLabel:"The robot in space"}),a=Gp("Colour",t,i.colour,u=>{i.colour=u,s.changed()});o.append(Fe("label",{},hv("Colour"),a)),n&&o.append(I2(i,s));let l=Gp("View",lv.map(u=>[u,P2[u]]),"iso",u=>s.look(u));o.append(Fe("label",{},hv("View"),l));let c=Fe("button",{type:"button",ariaLabel:"Reset view"},"Reset");return c.addEventListener("click",()=>s.look(l.value)),o.append(c,F2(i,e,r,s)),o}function I2(i,t){let e=Fe("input",{type:"range",min:"0",max:String(uv),step:"1",value:"0",ariaLabel:"Deformation"}),n=Fe("output",{},"×1");return e.dataset.scene="factor",e.addEventListener("input",()=>{i.factor=L2(200**(Number(e.value)/uv)),n.textContent=e.ariaValueText=`×${i.factor}`,t.changed()}),e.title="How many times the displacement of each robot from itself without elasticity is enlarged; double click: to scale",e.addEventListener("dblclick",()=>{e.value="0",e.dispatchEvent(new Event("input"))}),Fe("label",{className:"scene-factor-row"},"Deformation",e,n)}function hv(i){return Fe("span",{className:"scene-name"},i)}function L2(i){return i<10?Math.round(10*i)/10:Math.round(i)}function F2(i,t,e,n){let r=Fe("div",{className:"scene-more"});for(let[o,a]of cv){if(!t.includes(o))continue;let l=Fe("input",{type:"checkbox",checked:i[o]});l.dataset.scene=o,l.addEventListener("change",()=>{i[o]=l.checked,n.changed(),o==="apart"&&n.look("iso")}),r.append(Fe("label",{},l,a))}e&&r.append(Fe("label",{},"Quality",N2(i,n)));let s=Fe("details",{},Fe("summary",{},"Show"),r);return s.addEventListener("keydown",o=>{o.key==="Escape"&&(s.open=!1,s.querySelector("summary")?.focus())}),s}function N2(i,t){return Gp("Quality",[["auto","automatic"],["low","low"],["high","high"],["lines","lines alone"]],i.quality,n=>{i.quality=n,t.quality()})}function Gp(i,t,e,n){let r=Fe("select",{ariaLabel:i},...t.map(([s,o])=>Fe("option",{value:s,textContent:o})));return r.value=e,r.addEventListener("change",()=>n(r.value)),r}function Ah(i,t){return i!=="1"||t===0?ba(i,Math.abs(t)):Math.abs(t)<.01?{factor:1e6,name:"µm/m"}:{factor:100,name:"%"}}function vr(i){if(!Number.isFinite(i))return"–";let t=Math.abs(i);if(t!==0&&(t>=1e5||t<.001))return i.toExponential(2).replace("-","−");let e=t===0?0:Math.max(0,2-Math.floor(Math.log10(t)));return String(Number(i.toFixed(e))).replace("-","−")}function Pl(i){let t=10**Math.floor(Math.log10(i));return t*(i>=5*t?5:i>=2*t?2:1)}function dv(i){let t=new Gn,e=new z,n=.001,r=0;for(let{scene:l}of i.runs){for(let c of[l.line,l.tip])for(let u=0;u+2<c.data.length;u+=3)t.expandByPoint(e.fromArray(c.data,u));n=Math.max(n,D2(l.line.data,l.line.shape));for(let c of l.links)c.section?.sizes.data.forEach(u=>r=Math.max(r,u))}t.isEmpty()&&t.expandByPoint(e.set(0,0,0));let s=Math.max(n,t.getSize(e).length()/2),o=Math.min(Math.max(r,.012*n),.022*n),a=O2(t,i,n);for(let{scene:l}of i.runs)l.line.data.length&&t.expandByPoint(e.fromArray(l.line.data).setZ(a));return{box:t,reach:n,cell:Pl(s/5),usual:o,least:.006*n,floor:a}}function D2(i,[,t,e]){let n=0;for(let r=0;r<t;r++)for(let s=1;s<e;s++){let o=3*(r*e+s);n+=Math.hypot(i[o]-i[o-3],i[o+1]-i[o-2],i[o+2]-i[o-1])}return n}function O2(i,t,e){let n=t.runs[0]?.scene.line.data[2]??0,r=i.max.z-i.min.z>.2*e&&n<e;if(i.min.z>=-.001*e&&r)return 0;let s=Pl(.1*e);return Math.floor((Math.min(i.min.z,n)-.12*e)/s)*s}var pv=new Gn,Eh=new z,ca=class extends pl{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Ve(t,3)),this.setAttribute("uv",new Ve(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new ds(e,6,1);return this.setAttribute("instanceStart",new ki(n,3,0)),this.setAttribute("instanceEnd",new ki(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new ds(e,6,1);return this.setAttribute("instanceColorStart",new ki(n,3,0)),this.setAttribute("instanceColorEnd",new ki(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new rl(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Gn);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),pv.setFromBufferAttribute(e),this.boundingBox.union(pv))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Qi),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let r=0;for(let s=0,o=t.count;s<o;s++)Eh.fromBufferAttribute(t,s),r=Math.max(r,n.distanceToSquared(Eh)),Eh.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(Eh));this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};It.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Kt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};li.line={uniforms:Al.merge([It.common,It.fog,It.line]),vertexShader:`
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
		`};var vs=class extends Bi{constructor(t){super({type:"LineMaterial",uniforms:Al.clone(li.line.uniforms),vertexShader:li.line.vertexShader,fragmentShader:li.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Hp=new Ce,mv=new z,gv=new z,Hn=new Ce,Wn=new Ce,br=new Ce,Wp=new z,qp=new ze,qn=new ml,yv=new z,Th=new Gn,Rh=new Qi,wr=new Ce,Mr,js;function xv(i,t,e){return wr.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),wr.multiplyScalar(1/wr.w),wr.x=js/e.width,wr.y=js/e.height,wr.applyMatrix4(i.projectionMatrixInverse),wr.multiplyScalar(1/wr.w),Math.abs(Math.max(wr.x,wr.y))}function U2(i,t){let e=i.matrixWorld,n=i.geometry,r=n.attributes.instanceStart,s=n.attributes.instanceEnd,o=Math.min(n.instanceCount,r.count);for(let a=0,l=o;a<l;a++){qn.start.fromBufferAttribute(r,a),qn.end.fromBufferAttribute(s,a),qn.applyMatrix4(e);let c=new z,u=new z;Mr.distanceSqToSegment(qn.start,qn.end,u,c),u.distanceTo(c)<js*.5&&t.push({point:u,pointOnLine:c,distance:Mr.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function k2(i,t,e){let n=t.projectionMatrix,s=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-t.near;Mr.at(1,br),br.w=1,br.applyMatrix4(t.matrixWorldInverse),br.applyMatrix4(n),br.multiplyScalar(1/br.w),br.x*=s.x/2,br.y*=s.y/2,br.z=0,Wp.copy(br),qp.multiplyMatrices(t.matrixWorldInverse,o);for(let f=0,d=u;f<d;f++){if(Hn.fromBufferAttribute(l,f),Wn.fromBufferAttribute(c,f),Hn.w=1,Wn.w=1,Hn.applyMatrix4(qp),Wn.applyMatrix4(qp),Hn.z>h&&Wn.z>h)continue;if(Hn.z>h){let b=Hn.z-Wn.z,v=(Hn.z-h)/b;Hn.lerp(Wn,v)}else if(Wn.z>h){let b=Wn.z-Hn.z,v=(Wn.z-h)/b;Wn.lerp(Hn,v)}Hn.applyMatrix4(n),Wn.applyMatrix4(n),Hn.multiplyScalar(1/Hn.w),Wn.multiplyScalar(1/Wn.w),Hn.x*=s.x/2,Hn.y*=s.y/2,Wn.x*=s.x/2,Wn.y*=s.y/2,qn.start.copy(Hn),qn.start.z=0,qn.end.copy(Wn),qn.end.z=0;let y=qn.closestPointToPointParameter(Wp,!0);qn.at(y,yv);let g=sr.lerp(Hn.z,Wn.z,y),p=g>=-1&&g<=1,x=Wp.distanceTo(yv)<js*.5;if(p&&x){qn.start.fromBufferAttribute(l,f),qn.end.fromBufferAttribute(c,f),qn.start.applyMatrix4(o),qn.end.applyMatrix4(o);let b=new z,v=new z;Mr.distanceSqToSegment(qn.start,qn.end,v,b),e.push({point:v,pointOnLine:b,distance:Mr.origin.distanceTo(v),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var Ch=class extends Ge{constructor(t=new ca,e=new vs({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,r=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)mv.fromBufferAttribute(e,o),gv.fromBufferAttribute(n,o),r[a]=a===0?0:r[a-1],r[a+1]=r[a]+mv.distanceTo(gv);let s=new ds(r,2,1);return t.setAttribute("instanceDistanceStart",new ki(s,1,0)),t.setAttribute("instanceDistanceEnd",new ki(s,1,1)),this}raycast(t,e){let n=this.material.worldUnits,r=t.camera;if(r===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let s=t.params.Line2!==void 0&&t.params.Line2.threshold||0;Mr=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;js=l.linewidth+s,a.boundingSphere===null&&a.computeBoundingSphere(),Rh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=js*.5;else{let h=Math.max(r.near,Rh.distanceToPoint(Mr.origin));c=xv(r,h,l.resolution)}if(Rh.radius+=c,Mr.intersectsSphere(Rh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Th.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=js*.5;else{let h=Math.max(r.near,Th.distanceToPoint(Mr.origin));u=xv(r,h,l.resolution)}Th.expandByScalar(u),Mr.intersectsBox(Th)!==!1&&(n?U2(this,e):k2(this,r,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(Hp),this.material.uniforms.resolution.value.set(Hp.z,Hp.w))}};var Zs=class extends ca{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,n=new Float32Array(2*e);for(let r=0;r<e;r+=3)n[2*r]=t[r],n[2*r+1]=t[r+1],n[2*r+2]=t[r+2],n[2*r+3]=t[r+3],n[2*r+4]=t[r+4],n[2*r+5]=t[r+5];return super.setPositions(n),this}setColors(t){let e=t.length-3,n=new Float32Array(2*e);for(let r=0;r<e;r+=3)n[2*r]=t[r],n[2*r+1]=t[r+1],n[2*r+2]=t[r+2],n[2*r+3]=t[r+3],n[2*r+4]=t[r+4],n[2*r+5]=t[r+5];return super.setColors(n),this}setFromPoints(t){let e=t.length-1,n=new Float32Array(6*e);for(let r=0;r<e;r++)n[6*r]=t[r].x,n[6*r+1]=t[r].y,n[6*r+2]=t[r].z||0,n[6*r+3]=t[r+1].x,n[6*r+4]=t[r+1].y,n[6*r+5]=t[r+1].z||0;return super.setPositions(n),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Ph=class extends Ch{constructor(t=new Zs,e=new vs({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var vv=new z(0,1,0),Ih=class{group=new On;past;rest;length=0;constructor(t,e,n){this.past=new Ph(new Zs,new vs({color:e,linewidth:2.5}));let r=new al({color:e,transparent:!0,opacity:.7,dashSize:n,gapSize:n});this.rest=new ta(new an,r),this.past.frustumCulled=this.rest.frustumCulled=!1,this.group.add(this.past,this.rest),this.lay(t)}lay(t){this.length=t.length/3,this.rest.geometry.dispose(),this.past.geometry.dispose(),this.past.geometry=new Zs;let e=new Float32Array(this.length);for(let n=1;n<e.length;n++)e[n]=e[n-1]+Math.hypot(t[3*n]-t[3*n-3],t[3*n+1]-t[3*n-2],t[3*n+2]-t[3*n-1]);this.rest.geometry.setAttribute("position",new on(t,3)),this.rest.geometry.setAttribute("lineDistance",new on(e,1)),this.past.visible=this.length>1,this.past.visible&&this.past.geometry.setPositions(t)}seek(t){this.past.geometry.instanceCount=Math.min(t,this.length-1),this.rest.geometry.setDrawRange(t,this.length-t)}dispose(){[this.past.geometry,this.past.material,this.rest.geometry,this.rest.material].forEach(t=>t.dispose()),this.group.removeFromParent()}},Lh=class{constructor(t,e,n){this.wide=e;this.scale=n;let r=new Ko({color:t}),s=new yr(e,e,1,12).translate(0,.5,0),o=new il(2.6*e,6*e,16).translate(0,-3*e,0);[this.shaft,this.head]=[new Ge(s,r),new Ge(o,r)],this.parts=[r,s,o],this.group.add(this.shaft,this.head)}wide;scale;group=new On;shaft;head;parts;way=new z;turn=new kn;point(t,e){let n=this.way.fromArray(t).length(),r=n*this.scale;this.group.visible=r>.5*this.wide,this.group.visible&&(this.group.position.fromArray(e),this.group.quaternion.copy(this.turn.setFromUnitVectors(vv,this.way.divideScalar(n))),this.shaft.scale.set(1,Math.max(r-5*this.wide,1e-6),1),this.head.position.y=r)}dispose(){this.parts.forEach(t=>t.dispose()),this.group.removeFromParent()}};function bv(i,t,e,n){let r=new Vs({color:n,transparent:!0,opacity:.28,side:zi,depthWrite:!1});return new Ge(Xp(i,t,e),r)}var Il=24;function Xp(i,t,e){let n=[];for(let u=0;u+2<t.length;u+=3)n.push(new z(t[u],t[u+1],t[u+2]));let[r,s,o]=B2(i,n,e),a=n.map(s),[l,c]=[0,1].map(u=>{let h=a.map(f=>f[u]);return[h.reduce((f,d)=>Math.min(f,d),1/0)-o[u],h.reduce((f,d)=>Math.max(f,d),-1/0)+o[u]]});return z2(r,l,c)}function B2(i,t,e){if(i.kind==="plane"){let f=new z(...i.position),[d,m]=_v(new z(...i.normal).normalize());return[(g,p)=>f.clone().addScaledVector(d,g).addScaledVector(m,p),g=>[g.clone().sub(f).dot(d),g.clone().sub(f).dot(m)],[3*e,3*e]]}let n=new z(...i.center),r=i.kind==="cylinder"?new z(...i.axis).normalize():new z(0,0,1),s=t.reduce((f,d)=>f.add(d),new z).divideScalar(Math.max(t.length,1)).sub(n),o=s.addScaledVector(r,-s.dot(r));o.length()<1e-6*i.radius&&o.copy(_v(r)[0]),o.normalize();let a=new z().crossVectors(r,o),{radius:l}=i,c=i.kind==="ball";return[(f,d)=>{let m=c?l*Math.cos(d):l;return n.clone().addScaledVector(o,m*Math.cos(f)).addScaledVector(a,m*Math.sin(f)).addScaledVector(r,c?l*Math.sin(d):d)},f=>{let d=f.clone().sub(n),m=d.dot(r);return[Math.atan2(d.dot(a),d.dot(o)),c?Math.asin(Math.max(-1,Math.min(1,m/(d.length()||1)))):m]},[e/l,c?e/l:e]]}function _v(i){let t=new z().crossVectors(Math.abs(i.z)<.9?new z(0,0,1):vv,i).normalize();return[t,new z().crossVectors(i,t)]}function z2(i,t,e,n=Il){let r=[],s=[];for(let a=0;a<=n;a++)for(let l=0;l<=n;l++){r.push(...i(t[0]+(t[1]-t[0])*a/n,e[0]+(e[1]-e[0])*l/n).toArray());let c=a*(n+1)+l;a<n&&l<n&&s.push(c,c+1,c+n+1,c+1,c+n+2,c+n+1)}let o=new an;return o.setAttribute("position",new on(Float32Array.from(r),3)),o.setIndex(s),o.computeVertexNormals(),o}var qr=4;function wv(i,t,e){let{cell:n,reach:r,floor:s}=t,o=n*Math.ceil(1.6*r/n),{context:a}=i;for(let l of[!1,!0]){a.beginPath();for(let c=-o;c<=o+n/2;c+=n)Math.abs(c)<n/2===l&&(i.piece([c,-o,s],0,[c,o,s],0,!0),i.piece([-o,c,s],0,[o,c,s],0,!0));i.stroke(l?e.gridStrong:e.grid,1)}}function Mv(i,t,e,n){let r=t.length/3;i.path(t,0,Math.min(e+1,r)),i.stroke(n,2.5),i.context.setLineDash([4,4]),i.path(t,3*e,r-e),i.stroke(n,1.2,.8,"butt"),i.context.setLineDash([])}function Sv(i,t,e,n,r){let s=[0,1,2].map(y=>e[y]+n*t[y]),[o,a]=[i.at(e,0),i.at(s,0)];if(o===null||a===null)return;let[l,c]=[a[0]-o[0],a[1]-o[1]],u=Math.hypot(l,c);if(u<3)return;let h=Math.min(12,.5*u),[f,d]=[l/u,c/u],m=[a[0]-h*f,a[1]-h*d];i.context.beginPath(),i.context.moveTo(...o),i.context.lineTo(...m),i.stroke(r,4,1,"butt"),i.fill([a,[m[0]-.45*h*d,m[1]+.45*h*f],[m[0]+.45*h*d,m[1]-.45*h*f]],r)}var Fh=class{constructor(t,e,n){this.color=n;let r=Xp(t.surface,t.at.data,.12*e.reach);this.places=Float32Array.from(r.getAttribute("position").array)}color;places;draw(t){for(let e=0;e<Il;e+=qr)for(let n=0;n<Il;n+=qr)this.square(t,e,n)}square(t,e,n){let r=(o,a)=>t.at(this.places,3*((e+o)*(Il+1)+n+a)),s=[];for(let o=0;o<4*qr;o++){let[a,l]=[Math.floor(o/qr),o%qr],[c,u]=[[0,l],[l,qr],[qr,qr-l],[qr-l,0]][a],h=r(c,u);if(h===null)return;s.push(h)}t.fill(s,this.color,.16),t.context.closePath(),t.stroke(this.color,1,.35)}};var Nh=class{constructor(t){this.camera=t;let e=this.canvas.getContext("2d");if(e===null)throw new Error("This browser draws on no canvas.");this.context=e,e.lineJoin="round"}camera;canvas=document.createElement("canvas");context;aside=0;width=1;height=1;view=new Float64Array(16);from=new Float64Array(3);to=new Float64Array(3);focal=1;near=.001;resize(t,e){if(t<1||e<1)return;let n=Math.min(Math.max(window.devicePixelRatio,1),2);[this.width,this.height]=[t,e],[this.canvas.width,this.canvas.height]=[Math.round(n*t),Math.round(n*e)],this.camera.aspect=t/e,this.camera.updateProjectionMatrix()}begin(t){let{camera:e,canvas:n,context:r}=this;e.updateMatrixWorld(),this.view.set(e.matrixWorldInverse.elements),this.focal=this.height/2/Math.tan(e.fov*Math.PI/360),this.near=.001*t,r.setTransform(n.width/this.width,0,0,n.height/this.height,0,0),r.clearRect(0,0,this.width,this.height),r.lineJoin="round"}depth(t,e){return-this.seen(2,t,e)}perMeter(t){return this.focal/Math.max(t,this.near)}at(t,e){let n=this.depth(t,e);return n<this.near?null:this.pixel(this.seen(0,t,e),this.seen(1,t,e),n)}path(t,e,n){this.context.beginPath();for(let r=1;r<n;r++)this.piece(t,e+3*r-3,t,e+3*r,r===1)}piece(t,e,n,r,s){let{from:o,to:a,near:l,context:c}=this;for(let f=0;f<3;f++)[o[f],a[f]]=[this.seen(f,t,e),this.seen(f,n,r)];let[u,h]=[-o[2]<l,-a[2]<l];if(!(u&&h)){if(u||h){let f=(-l-o[2])/(a[2]-o[2]),d=u?o:a;for(let m=0;m<3;m++)d[m]=this.seen(m,t,e)+f*(this.seen(m,n,r)-this.seen(m,t,e))}(s||u)&&c.moveTo(...this.pixel(o[0],o[1],-o[2])),c.lineTo(...this.pixel(a[0],a[1],-a[2]))}}stroke(t,e,n=1,r="round"){let{context:s}=this;s.globalAlpha=n,s.strokeStyle=t,s.lineWidth=e,s.lineCap=r,s.stroke(),s.globalAlpha=1}dot(t,e,n,r,s,o=2){let a=this.at(t,e);if(a===null)return;let l=Math.max(n*this.perMeter(this.depth(t,e)),o);this.context.beginPath(),this.context.arc(...a,l,0,2*Math.PI),this.context.fillStyle=r,this.context.fill(),this.stroke(s,1)}fill(t,e,n=1){let{context:r}=this;r.beginPath(),t.forEach(s=>r.lineTo(...s)),r.closePath(),r.globalAlpha=n,r.fillStyle=e,r.fill(),r.globalAlpha=1}pixel(t,e,n){let r=this.focal/n;return[this.width/2+r*t,this.height/2-r*e]}seen(t,e,n){let{view:r}=this;return r[t]*e[n]+r[4+t]*(e[n+1]+this.aside)+r[8+t]*e[n+2]+r[12+t]}};var V2={runs:["#0072b2","#d55e00","#00875f","#a2488f","#8c6a00","#2a7fb8"],link:"#9aa5b1",joint:"#4a5562",gear:"#c76a00",base:"#39434e",payload:"#2b333c",grid:"#c3cad1",gridStrong:"#8e99a4",surface:"#009e73",force:"#b3261e",reference:"#d55e00",rigid:"#6b7681",before:"#7a4ea3",real:"#0072b2",sky:"#ffffff",ground:"#b9c0c8"},G2={runs:["#4fb0ea","#ff8f45","#3ecf9b","#e08acb","#d9b13a","#9fd3f5"],link:"#8b96a3",joint:"#a9b4c0",gear:"#e69f00",base:"#6d7986",payload:"#cfd6dd",grid:"#39424c",gridStrong:"#5c6874",surface:"#2fbf95",force:"#ff7b70",reference:"#ff8c42",rigid:"#a3adb7",before:"#c79be8",real:"#56b4e9",sky:"#ffffff",ground:"#5a6570"};function Av(i){return i?G2:V2}var Ev="440154 481a6c 472f7d 414487 39568c 31688e 2a788e 23888e 1f988b 22a884 35b779 54c568 7ad151 a5db36 d2e21b fde725",Ll=256,Sr=H2();function H2(){let i=Ev.split(" ").map(e=>[0,2,4].map(n=>parseInt(e.slice(n,n+2),16)/255)),t=new Float32Array(3*Ll);for(let e=0;e<Ll;e++){let n=e/(Ll-1)*(i.length-1),r=Math.min(Math.floor(n),i.length-2);for(let s=0;s<3;s++)t[3*e+s]=i[r][s]+(n-r)*(i[r+1][s]-i[r][s])}return t}function ua(i){return 3*Math.max(0,Math.min(Ll-1,Math.round(i*(Ll-1))))}function Tv(){return`linear-gradient(to top, ${Ev.split(" ").map(i=>`#${i}`).join(", ")})`}function Rv(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,r=n.count,s;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)s=n.array;else{s=new Float64Array(r*3);for(let v=0;v<r;v++)s[3*v+0]=n.getX(v),s[3*v+1]=n.getY(v),s[3*v+2]=n.getZ(v)}let o=Math.cos(t),a=(1+1e-10)*100,l=r/3,c=new Float64Array(l*3);for(let v=0;v<l;v++){let A=9*v,S=s[A+0],_=s[A+1],w=s[A+2],N=s[A+3],C=s[A+4],P=s[A+5],O=s[A+6],B=s[A+7],F=s[A+8],V=O-N,q=B-C,G=F-P,rt=S-N,$=_-C,j=w-P,tt=q*j-G*$,ut=G*rt-V*j,ct=V*$-q*rt,K=1/(Math.sqrt(tt*tt+ut*ut+ct*ct)||1);c[3*v+0]=tt*K,c[3*v+1]=ut*K,c[3*v+2]=ct*K}let u=new Int32Array(r),h=new Float64Array(r*3),f=1;for(;f<r*2;)f<<=1;let d=f-1,m=new Int32Array(f),y=0;for(let v=0;v<r;v++){let A=3*v,S=Math.trunc(s[A+0]*a),_=Math.trunc(s[A+1]*a),w=Math.trunc(s[A+2]*a),N=(Math.imul(S,73856093)^Math.imul(_,19349663)^Math.imul(w,83492791))&d;for(;;){let C=m[N];if(C===0){let O=3*y;h[O+0]=S,h[O+1]=_,h[O+2]=w,m[N]=y+1,u[v]=y++;break}let P=3*(C-1);if(h[P+0]===S&&h[P+1]===_&&h[P+2]===w){u[v]=C-1;break}N=N+1&d}}let g=new Int32Array(y+1);for(let v=0;v<r;v++)g[u[v]+1]++;for(let v=0;v<y;v++)g[v+1]+=g[v];let p=new Int32Array(r),x=g.slice(0,y);for(let v=0;v<l;v++){let A=3*v;p[x[u[A+0]]++]=v,p[x[u[A+1]]++]=v,p[x[u[A+2]]++]=v}let b=new Float32Array(r*3);for(let v=0;v<l;v++){let A=3*v,S=c[A+0],_=c[A+1],w=c[A+2];for(let N=0;N<3;N++){let C=A+N,P=u[C],O=0,B=0,F=0;for(let q=g[P],G=g[P+1];q<G;q++){let rt=3*p[q],$=c[rt+0],j=c[rt+1],tt=c[rt+2];S*$+_*j+w*tt>o&&(O+=$,B+=j,F+=tt)}let V=1/(Math.sqrt(O*O+B*B+F*F)||1);b[3*C+0]=O*V,b[3*C+1]=B*V,b[3*C+2]=F*V}}return e.setAttribute("normal",new on(b,3,!1)),e}var Cv=[[1,1],[-1,1],[-1,-1],[1,-1]];function W2(i){let t=new Float32Array(2*(i+1));for(let e=0;e<=i;e++)t[2*e]=Math.cos(2*Math.PI*e/i),t[2*e+1]=Math.sin(2*Math.PI*e/i);return{points:t,normals:t}}function q2(){let i=[],t=[];return Cv.forEach((e,n)=>{let r=Cv[(n+1)%4];i.push(...e,...r);for(let s=0;s<2;s++)t.push((e[0]+r[0])/2,(e[1]+r[1])/2)}),{points:Float32Array.from(i),normals:Float32Array.from(t)}}var Dh=class{constructor(t,e,n){this.stations=t;this.section=e;this.outline=e.shape==="round"?W2(n):q2(),this.around=this.outline.points.length/2;let r=(t+2)*this.around;[this.position,this.normal,this.colour]=[0,1,2].map(()=>new Float32Array(3*r)),this.colour.fill(1),["position","normal","color"].forEach((s,o)=>{let a=new on([this.position,this.normal,this.colour][o],3);this.geometry.setAttribute(s,a.setUsage(vp))}),this.geometry.setIndex(this.faces())}stations;section;geometry=new an;outline;around;position;normal;colour;axes=new Float32Array(9);shape(t,e,n,r){let{stations:s,axes:o}=this;$p(o,n,r);for(let a=0;a<s;a++){let l=e+3*Math.max(a-1,0),c=e+3*Math.min(a+1,s-1);Yp(o,t[c]-t[l],t[c+1]-t[l+1],t[c+2]-t[l+2]),this.ring(a,a,t,e+3*a,0),a===0&&this.ring(s,a,t,e,-1),a===s-1&&this.ring(s+1,a,t,e+3*a,1)}this.geometry.attributes.position.needsUpdate=!0,this.geometry.attributes.normal.needsUpdate=!0}paint(t,e,n,r){let{around:s,colour:o,stations:a}=this,l=r>n?r-n:1;for(let c=0;c<a+2;c++){let u=c<a?c:c===a?0:a-1,h=ua((t[e+u]-n)/l);for(let f=3*c*s;f<3*(c+1)*s;f+=3)o[f]=Sr[h],o[f+1]=Sr[h+1],o[f+2]=Sr[h+2]}this.geometry.attributes.color.needsUpdate=!0}dispose(){this.geometry.dispose()}ring(t,e,n,r,s){let{axes:o,around:a,position:l,normal:c,section:u,outline:h}=this,f=u.sizes[2*e],d=u.sizes[2*e+1];for(let m=0;m<a;m++){let y=f*h.points[2*m],g=d*h.points[2*m+1],p=h.normals[2*m],x=h.normals[2*m+1];for(let b=0;b<3;b++){let v=3*(t*a+m)+b;l[v]=n[r+b]+y*o[3+b]+g*o[6+b],c[v]=s===0?p*o[3+b]+x*o[6+b]:s*o[b]}}}faces(){let{around:t,stations:e}=this,n=[];for(let r=0;r<e-1;r++)for(let s=0;s<t-1;s++){let o=r*t+s;n.push(o,o+t,o+1,o+1,o+t,o+t+1)}for(let r=1;r<t-1;r++){let s=e*t,o=s+t;n.push(s,s+r,s+r+1,o,o+r+1,o+r)}for(let r=0;r<n.length;r+=3)[n[r+1],n[r+2]]=[n[r+2],n[r+1]];return n}};function $p(i,t,e){let n=t[e],r=t[e+1],s=t[e+2],o=t[e+3];i[0]=1-2*(r*r+s*s),i[1]=2*(n*r+s*o),i[2]=2*(n*s-r*o),i[3]=2*(n*r-s*o),i[4]=1-2*(n*n+s*s),i[5]=2*(r*s+n*o),i[6]=2*(n*s+r*o),i[7]=2*(r*s-n*o),i[8]=1-2*(n*n+r*r)}function Yp(i,t,e,n){let r=Math.hypot(t,e,n);if(r===0)return;let s=t/r,o=e/r,a=n/r,l=i[1]*a-i[2]*o,c=i[2]*s-i[0]*a,u=i[0]*o-i[1]*s,h=1+i[0]*s+i[1]*o+i[2]*a,f=h>1e-9?1/h:0;for(let d=3;d<9;d+=3){let m=c*i[d+2]-u*i[d+1],y=u*i[d]-l*i[d+2],g=l*i[d+1]-c*i[d];i[d]+=m+f*(c*g-u*y),i[d+1]+=y+f*(u*m-l*g),i[d+2]+=g+f*(l*y-c*m)}i[0]=s,i[1]=o,i[2]=a}var Pv=new z(0,1,0),X2=.6,Js=class{constructor(t,e,n,r){this.look=n;this.widths=r;let s=this.material(n.link,!1),o=n.painted==="none"?s:this.material("#ffffff",!0),a=new Set(t.meshes.map(c=>c.link));if(this.sweeps=t.links.map((c,u)=>{if(u>=e.links||!c.bends&&a.has(u))return null;let h=new Dh(e.stations,Zp(c,e.stations,r),n.fine?24:10);return this.add(new Ge(h.geometry,c.bends||n.painted==="all"?o:s)),h}),t.meshes.filter(({link:c})=>c<e.links).forEach(c=>this.surface(c,t.links)),n.opacity<1)return;t.joints.filter(({link:c})=>c<e.links).forEach(c=>this.housing(c,t.links[c.link],a.has(c.link))),t.links.slice(0,e.links).forEach((c,u)=>this.holder(c,u,e,a));let l=new ea((a.size>0?.5:1.5)*r.usual,24,16);this.payload=this.add(new Ge(this.kept(l),this.material(n.payload,!1)))}look;widths;group=new On;sweeps;placed=[];tinted=[];rods=[];pedestals=[];payload=null;trash=[];from=new z;to=new z;quaternion=new kn;update(t,e,n,r){let{stations:s,roots:o,values:a}=t,l=3*s;this.sweeps.forEach((c,u)=>{c?.shape(e,u*l,o,4*u),this.look.painted!=="none"&&c?.paint(a,u*s,n,r)});for(let{object:c,link:u,turn:h}of this.placed)u<0||(c.position.fromArray(e,u*l),c.quaternion.fromArray(o,4*u),h&&c.quaternion.multiply(h));for(let{material:c,link:u}of this.tinted){let h=ua((a[(u+1)*s-1]-n)/(r-n||1));c.color.setRGB(Sr[h],Sr[h+1],Sr[h+2])}for(let c of this.rods)this.between(c.object,e,c.place,c.link*l);for(let{object:c,link:u}of this.pedestals)this.stand(c,e,u*l);this.payload?.position.copy(this.from.fromArray(t.tip))}dispose(){this.sweeps.forEach(t=>t?.dispose()),this.trash.forEach(t=>t.dispose()),this.group.removeFromParent()}material(t,e){let{opacity:n,fine:r}=this.look,s={polygonOffset:n<1,polygonOffsetFactor:2,polygonOffsetUnits:2},o={transparent:n<1,opacity:n,depthWrite:n>=1,...s},a={color:t,vertexColors:e,...o};return this.kept(r?new ol({...a,roughness:.5,metalness:.1}):new Vs(a))}kept(t){return this.trash.push(t),t}add(t){return t.frustumCulled=!1,t.castShadow=t.receiveShadow=this.look.opacity>=1,this.group.add(t),t}housing(t,e,n){if(e===void 0||n||t.drawing==="none")return;let r=1.5*this.widths.usual,s=t.drawing==="cylinder"?new yr(r,r,2.2*r,this.look.fine?32:14):t.drawing==="ball"?new ea(1.2*r,this.look.fine?32:14,this.look.fine?24:10):new cs(2*r,2.2*r,2*r),o=this.add(new Ge(this.kept(s),this.material(t.elastic?this.look.gear:this.look.joint,!1))),a=new z(...t.axis).normalize();this.placed.push({object:o,link:t.link,turn:new kn().setFromUnitVectors(Pv,a)})}surface(t,e){if(e[t.link]?.bends)return;let n=new an;n.setAttribute("position",new on(Float32Array.from(t.vertices.data),3)),n.setIndex(new on(Uint32Array.from(t.faces.data),1));let r=this.kept(Rv(n,X2)),s=this.material(this.look.opacity<1?this.look.link:t.colour,!1);this.placed.push({object:this.add(new Ge(r,s)),link:t.link,turn:null}),this.look.painted==="all"&&t.link>=0&&this.tinted.push({material:s,link:t.link})}holder(t,e,n,r){if(t.parent<0){if(r.has(-1)||r.has(e))return;let c=new yr(1.8*this.widths.usual,3*this.widths.usual,1,32);this.pedestals.push({object:this.add(new Ge(this.kept(c),this.material(this.look.base,!1))),link:e});return}let{place:s,away:o}=jp(n,t.parent,e);if(o<.5*this.widths.usual||r.has(e)&&r.has(t.parent))return;let a=new yr(.8*this.widths.usual,.8*this.widths.usual,1,16),l=this.add(new Ge(this.kept(a),this.material(this.look.link,!1)));this.rods.push({object:l,link:e,parent:t.parent,place:s})}between(t,e,n,r){this.from.fromArray(e,n),this.to.fromArray(e,r).sub(this.from);let s=this.to.length();t.position.copy(this.from).addScaledVector(this.to,.5),t.scale.set(1,Math.max(s,1e-9),1),s>0&&t.quaternion.copy(this.quaternion.setFromUnitVectors(Pv,this.to.divideScalar(s)))}stand(t,e,n){let r=Math.max(e[n+2]-this.widths.floor,1e-4);t.position.set(e[n],e[n+1],this.widths.floor+r/2),t.scale.set(1,r,1),t.rotation.set(Math.PI/2,0,0)}};function jp({arrays:i,stations:t},e,n){let{data:r}=i.line,s=3*t*n,o={place:0,away:1/0};for(let a=0;a<t;a++){let l=3*(t*e+a),c=Math.hypot(r[l]-r[s],r[l+1]-r[s+1],r[l+2]-r[s+2]);c<o.away&&(o={place:l,away:c})}return o}function Zp(i,t,e){let n=new Float32Array(2*t).fill(e.usual);if(i.section===null)return{shape:"round",sizes:n};let r=i.section.sizes,s=r.shape[0]-1;for(let o=0;o<t;o++)for(let a=0;a<2;a++){let l=Math.round(o/Math.max(t-1,1)*s);n[2*o+a]=Math.max(r.data[2*l+a],e.least)}return{shape:i.section.shape,sizes:n}}var $2=.6,Ks=class{constructor(t,e,n){this.body=t;this.motion=e;this.widths=n;this.sections=t.links.slice(0,e.links).map(r=>Zp(r,e.stations,n)),t.links.slice(0,e.links).forEach(({parent:r},s)=>{if(r<0)return;let{place:o,away:a}=jp(e,r,s);a>=.5*n.usual&&this.rods.push({link:s,place:o})})}body;motion;widths;sections;rods=[];axes=new Float32Array(9);pair=new Float32Array(6);draw(t,e,n,r,s){let{motion:o,widths:a}=this,l=3*o.stations,c=this.body.links.slice(0,o.links).flatMap((h,f)=>[{depth:this.far(t,e,f),draw:()=>this.link(t,e,f,h,n,r,s)},...h.parent<0?[{depth:t.depth(e,f*l)+a.usual,draw:()=>this.stand(t,e,f*l,n)}]:[]]);c.push(...this.rods.map(({link:h,place:f})=>this.rod(t,e,h*l,f,n)));for(let{link:h,drawing:f,elastic:d}of this.body.joints){if(h>=o.links||f==="none")continue;let m=()=>t.dot(e,h*l,1.5*a.usual,d?n.gear:n.joint,n.base);c.push({depth:t.depth(e,h*l)-2*a.usual,draw:m})}let u=()=>t.dot(o.tip,0,1.5*a.usual,n.payload,n.base);c.push({depth:t.depth(o.tip,0)-2*a.usual,draw:u}),c.sort((h,f)=>f.depth-h.depth).forEach(h=>h.draw())}ghost(t,e,n,r){let{motion:s,sections:o}=this,{stations:a}=s;for(let l=0;l<s.links;l++){let c=3*a*l,u=Math.max(...o[l].sizes);t.path(e,c,a),t.stroke(n,Math.max(1.6*u*t.perMeter(t.depth(e,c)),2),r)}}link(t,e,n,r,s,o,a){let{motion:l}=this,{stations:c,values:u}=l,h=3*c*n,f=s.painted==="all"||s.painted==="bending"&&r.bends,d=this.seenWidths(t,e,n,a);for(let g=1;g<c;g++)t.path(e,h+3*g-3,2),t.stroke(s.base,d[g]+2,1,g===1||g===c-1?"round":"butt");let m=o.low,y=o.high-m||1;for(let g=1;g<c;g++){let p=(u[n*c+g-1]+u[n*c+g])/2;this.stretch(t,e,h+3*g),t.stroke(f?j2((p-m)/y):s.link,d[g],1,"butt")}}stretch(t,e,n){let{pair:r}=this,s=Math.hypot(e[n]-e[n-3],e[n+1]-e[n-2],e[n+2]-e[n-1]),o=s>0?$2/t.perMeter(t.depth(e,n))/s:0;for(let a=0;a<3;a++){let l=o*(e[n+a]-e[n-3+a]);r[a]=e[n-3+a]-l,r[3+a]=e[n+a]+l}t.path(r,0,2)}seenWidths(t,e,n,r){let{axes:s,motion:o}=this,{stations:a,roots:l}=o,{shape:c,sizes:u}=this.sections[n],h=new Float32Array(a);$p(s,l,4*n);for(let f=1;f<a;f++){let d=3*(a*n+f);Yp(s,e[d]-e[d-3],e[d+1]-e[d-2],e[d+2]-e[d-1]);let[m,y,g]=Y2(s,r.x-e[d],r.y-e[d+1]-t.aside,r.z-e[d+2]),p=u[2*f]*Math.abs(m*s[3]+y*s[4]+g*s[5]),x=u[2*f+1]*Math.abs(m*s[6]+y*s[7]+g*s[8]),b=c==="round"?Math.hypot(p,x):p+x;h[f]=Math.max(2*Math.max(b,this.widths.least)*t.perMeter(t.depth(e,d)),2.5)}return h}far(t,e,n){let{stations:r}=this.motion;return t.depth(e,3*(r*n+(r>>1)))}rod(t,e,n,r,s){let o=t.depth(e,n)+this.widths.usual;return{depth:o,draw:()=>{t.context.beginPath(),t.piece(e,r,e,n,!0),t.stroke(s.base,1.6*this.widths.usual*t.perMeter(o)+2),t.stroke(s.link,1.6*this.widths.usual*t.perMeter(o))}}}stand(t,e,n,r){let{usual:s,floor:o}=this.widths,a=[e[n],e[n+1],o],[l,c]=[t.at(e,n),t.at(a,0)];if(l===null||c===null)return;let[u,h]=[1.8*s*t.perMeter(t.depth(e,n)),3*s*t.perMeter(t.depth(a,0))],f=Math.hypot(c[0]-l[0],c[1]-l[1]);if(f>1){let[d,m]=[(c[1]-l[1])/f,(l[0]-c[0])/f],y=(g,p)=>[g[0]+p*d,g[1]+p*m];t.fill([y(l,u),y(c,h),y(c,-h),y(l,-u)],r.base)}t.dot(e,n,1.8*s,r.base,r.base)}};function Y2(i,t,e,n){let r=[i[1]*n-i[2]*e,i[2]*t-i[0]*n,i[0]*e-i[1]*t],s=Math.hypot(...r)||1;return[r[0]/s,r[1]/s,r[2]/s]}function j2(i){let t=ua(i);return`rgb(${[0,1,2].map(e=>Math.round(255*Sr[t+e])).join(" ")})`}function Oh(i,t,e,n){for(let r=0;4*r<i.length&&n>1;r++){let s=3*n*r,o=t[s+3]-t[s],a=t[s+4]-t[s+1],l=t[s+5]-t[s+2],c=e[s+3]-e[s],u=e[s+4]-e[s+1],h=e[s+5]-e[s+2],f=Math.hypot(o,a,l)*Math.hypot(c,u,h);f>0&&Z2(i,4*r,a*h-l*u,l*c-o*h,o*u-a*c,f+o*c+a*u+l*h)}}function Z2(i,t,e,n,r,s){let o=Math.hypot(e,n,r,s);if(o===0)return;let a=i[t]/o,l=i[t+1]/o,c=i[t+2]/o,u=i[t+3]/o;i[t]=s*a+e*u+n*c-r*l,i[t+1]=s*l-e*c+n*u+r*a,i[t+2]=s*c+e*l-n*a+r*u,i[t+3]=s*u-e*a-n*l-r*c}var bs=class{constructor(t){this.arrays=t;[this.frames,this.links,this.stations]=t.line.shape;let e=this.links*this.stations*3;this.line=new Float32Array(e),this.once=new Float32Array(e),this.planned=new Float32Array(e),this.rigid=t.rigid?new Float32Array(e):null,this.reference=t.reference?new Float32Array(e):null,this.roots=new Float32Array(this.links*4),this.values=new Float32Array(this.links*this.stations),this.tipPlace=this.nearestEnd()}arrays;links;stations;frames;line;rigid;reference;roots;values;tip=new Float32Array(3);tipReference=new Float32Array(3);force=new Float32Array(3);at=new Float32Array(3);frame=0;share=0;tipPlace;once;planned;seek(t,e,n){this.find(t);let{arrays:r}=this;this.mix(this.line,r.line),this.rigid&&r.rigid&&this.mix(this.rigid,r.rigid),this.reference&&r.reference&&this.mix(this.reference,r.reference),this.turn(),this.mix(this.tip,r.tip),r.tipReference&&this.mix(this.tipReference,r.tipReference),r.contact&&(this.mix(this.force,r.contact.force),this.mix(this.at,r.contact.at)),n&&this.mix(this.values,n),!(e===1||!this.rigid)&&(r.referenceRigid&&this.mix(this.planned,r.referenceRigid),this.enlarge(e,this.rigid,r.referenceRigid?this.planned:this.rigid))}path(t,e){let{arrays:n,frames:r}=this,s=t?n.tipReference:n.tip,o=t?n.reference:n.line,a=t&&n.referenceRigid||n.rigid;if(s===null)return null;let l=Float32Array.from(s.data);if(!a||!o||this.links===0)return l;let c=this.links*this.stations*3;for(let u=0;u<r;u++)for(let h=0;h<3;h++){let f=u*c+this.tipPlace+h;l[3*u+h]+=(e-1)*(o.data[f]-a.data[f])}return l}find(t){let e=this.arrays.times.data,n=0,r=this.frames-1;for(;r-n>1;){let o=n+r>>1;e[o]<=t?n=o:r=o}this.frame=n;let s=r>n?e[r]-e[n]:0;this.share=s>0?Math.min(1,Math.max(0,(t-e[n])/s)):0}mix(t,e){let n=t.length,r=this.frame*n,s=Math.min(this.frame+1,this.frames-1)*n,{data:o}=e;for(let a=0;a<n;a++){let l=o[r+a];t[a]=l+this.share*(o[s+a]-l)}}turn(){let{roots:t}=this;this.mix(t,this.arrays.roots);for(let e=0;e<t.length;e+=4){let n=Math.hypot(t[e],t[e+1],t[e+2],t[e+3])||1;for(let r=0;r<4;r++)t[e+r]/=n}}enlarge(t,e,n){let{line:r,reference:s,tipPlace:o}=this;for(let a=0;a<3&&this.links>0;a++){let l=(t-1)*(r[o+a]-e[o+a]);this.tip[a]+=l,this.at[a]+=l,s&&(this.tipReference[a]+=(t-1)*(s[o+a]-n[o+a]))}this.once.set(r);for(let a=0;a<r.length;a++)r[a]=e[a]+t*(r[a]-e[a]),s&&(s[a]=n[a]+t*(s[a]-n[a]));Oh(this.roots,this.once,r,this.stations)}nearestEnd(){let{line:t,tip:e}=this.arrays,n=0,r=1/0;for(let s=0;s<this.links;s++){let o=(s*this.stations+this.stations-1)*3,a=Math.hypot(...[0,1,2].map(l=>t.data[o+l]-e.data[l]));a<=r&&([n,r]=[o,a])}return n}};var kh=1.6,Fl=class{constructor(t,e,n){this.mode=t;this.size=n;let[r,s]=t.rest.shape,o={data:t.rest.data,shape:[1,r,s,3]},a={data:e.roots.data.slice(0,4*r),shape:[1,r,4]},l=t.rest.data.slice(3*(r*s-1),3*r*s);this.motion=new bs({times:{data:Float64Array.of(0),shape:[1]},line:o,rigid:o,reference:null,roots:a,tip:{data:l,shape:[1,3]},tipReference:null,colours:[],contact:null}),this.motion.seek(0,1,null),this.roots=this.motion.roots.slice()}mode;size;motion;roots;swing(t){let{mode:e,motion:n,size:r}=this,s=r*Math.cos(t),o=r*Math.sin(t),{line:a,values:l}=n;for(let c=0;c<l.length;c++){let u=0;for(let h=3*c;h<3*c+3;h++){let f=s*e.real.data[h]-o*e.imaginary.data[h];a[h]=e.rest.data[h]+f,u+=f*f}l[c]=Math.sqrt(u)/r}for(let c=0;c<3;c++)n.tip[c]=a[a.length-3+c];n.roots.set(this.roots),Oh(n.roots,e.rest.data,a,n.stations)}},Uh=class{group=new On;swinging;robot;rest;constructor(t,e,n,r){let{colours:s,extent:o,fine:a}=r;this.swinging=new Fl(t,e,n*o.reach);let{motion:l}=this.swinging,{link:c,joint:u,gear:h,base:f,payload:d,rigid:m}=s,y={link:c,joint:u,gear:h,base:f,payload:d,opacity:1,painted:"all",fine:a},g={...y,link:m,opacity:.35,painted:"none"};this.robot=new Js(e,l,y,o),this.rest=new Js(e,l,g,{...o,usual:.8*o.usual}),this.group.add(this.robot.group,this.rest.group),this.rest.update(l,l.line,0,1)}swing(t){let{motion:e}=this.swinging;this.swinging.swing(t),this.robot.update(e,e.line,0,1)}dispose(){this.robot.dispose(),this.rest.dispose(),this.group.removeFromParent()}};var ha=class{constructor(t,e,n,r){this.run=t;this.index=e;this.alone=n;this.own=r;this.motion=new bs(t.scene)}run;index;alone;own;motion;showsSurface=!0;aside=0;before=null;get colour(){return this.alone?this.own.real:this.own.runs[this.index%this.own.runs.length]}get referenceColour(){return this.alone?this.own.reference:this.own.rigid}get changed(){return this.before!==null}replace(t){let{scene:e}=this.run,n=new bs(t??e);this.before=t===null?null:this.before??new bs(e),this.motion=n}seek(t,e){let{motion:n}=this,r=n.arrays.colours.find(({id:s})=>s===e.colour)?.values??null;n.seek(t,e.factor,r),this.before?.seek(t,e.factor,null)}widen(t,e){let{arrays:n,links:r,stations:s}=this.motion,o=n.colours.find(l=>l.id===t)?.values.data,a=this.run.scene.links.map(l=>l.bends||Nl(t)==="all");if(o!==void 0)for(let l=0;l<o.length;l++)a[Math.floor(l/s)%r]&&(o[l]<e.low&&(e.low=o[l]),o[l]>e.high&&(e.high=o[l]))}};function Nl(i){return i==="run"?"none":i==="displacement"?"all":"bending"}var J2=10;function Bh(i,t){let e=0;for(let{scene:n}of i){let r=n.contact?.force.data??[];for(let s=0;s+2<r.length;s+=3)e=Math.max(e,Math.hypot(r[s],r[s+1],r[s+2]))}return i.every(({scene:n})=>n.contact===null)?0:Pl(.35*t/(e||J2))}var fa=class{constructor(t,e,n,r){this.canvas=t;this.runs=n;this.given=r;let{page:s,extent:o,ask:a}=r;this.scale=Bh(s.runs,o.reach),this.cameras=new Sh(e,t,o.reach,a),t.tabIndex=0,t.setAttribute("role","img");let l="Arrow keys turn the view, with Shift they move it, + and - zoom.";t.setAttribute("aria-label",`The robot in space: ${s.runs.map(({name:c})=>c).join(", ")}. ${l}`),t.title=`Drag to turn, right button to move, click and wheel to zoom. ${l}`}canvas;runs;given;cameras;scale;range={low:0,high:1};shown=null;replace(t,e){this.runs[t]?.replace(e)}showMode(t,e){this.shown=t}refresh(){let{runs:t}=this,{settings:e,extent:n}=this.given,r={low:1/0,high:-1/0};t.forEach(c=>c.widen(e.colour,r)),this.range=r.low<=r.high?r:{low:0,high:0};let{box:s,reach:o}=n,a=e.apart?Math.max(.4*o,s.max.y-s.min.y+.15*o):0,l=t.map(({run:c})=>JSON.stringify(c.scene.contact?.surface));t.forEach((c,u)=>{c.aside=(u-(t.length-1)/2)*a,c.showsSurface=e.apart||l.indexOf(l[u])===u}),this.cameras.box.copy(s).expandByVector(new z(0,(t.length-1)/2*a,0))}look(t,e){this.cameras.show(t,this.runs[0].motion.tip,e)}takeView(t){this.cameras.take(t.cameras)}tell(t){let{settings:e,extent:n}=this.given,{shown:r}=this,s=this.runs.flatMap(({run:a})=>a.scene.colours).find(({id:a})=>a===e.colour);t.list(r?this.modeEntries(r):this.entries(),!r&&this.forceShown()),r?t.range({label:"Displacement, share of the largest",unit:"",low:0,high:1}):t.range(s?{label:s.label,unit:s.unit,...this.range}:null),t.enlarged(e.factor===1||r?"":`Deformation × ${e.factor}`);let o=n.floor===0?"":`, at z = ${vr(n.floor)} m`;t.flat(""),t.floor(e.floor?`Grid ${vr(n.cell)} m${o}${this.thick()}`:"")}words(){if(!this.forceShown())return"";let t=n=>vr(Math.hypot(...n));return`Contact force ${this.runs.filter(({run:n})=>n.scene.contact).map(({motion:n})=>`${t(n.force)} N`).join(", ")} (arrow: ${vr(.1/this.scale)} N per 0.1 m)`}dispose(){this.cameras.dispose(),this.canvas.remove()}forceShown(){return this.given.settings.force&&this.scale>0}entries(){let{runs:t}=this,{settings:e,colours:n}=this.given,r=t.length===1,s=[];r?e.traces&&s.push({colour:n.real,label:"Path of the tip"}):s.push(...t.map(l=>({colour:l.colour,label:l.run.name})));let o=l=>e[l]&&t.some(({run:c})=>c.scene[l]),a=e.traces&&t.some(({run:l})=>l.scene.tipReference);return o("reference")?s.push({colour:t[0].referenceColour,label:"Nominal"}):a&&s.push({colour:t[0].referenceColour,label:"Path of the nominal tip"}),o("rigid")&&s.push({colour:n.rigid,label:"Without any elasticity"}),t.some(({changed:l})=>l)&&s.push({colour:n.before,label:"The run as it was"}),s}modeEntries(t){let e=`damping ${vr(100*t.damping)} %`,n=`motors ${t.case}; slowed, not to scale`,r=`Mode ${vr(t.frequency)} Hz, ${e}, ${t.element}; ${n}`;return[{colour:this.given.colours.rigid,label:"At rest"},{colour:"transparent",label:r}]}thick(){let{least:t}=this.given.extent,e=this.runs.flatMap(({run:s})=>s.scene.links.map(({section:o})=>o)),n=e.some(s=>s&&Math.min(...s.sizes.data)<t),r=Ah("m",2*t);return n?`; links are drawn at least ${vr(2*t*r.factor)} ${r.name} thick`:e.some(s=>s?.guessed)?"; thickness of links by their stiffness and mass":""}};var zh=.42,Jp=class extends ha{constructor(e,n,r,s,o){super(e,n,r,s);this.colours=s;this.extent=o;this.robot=new Ks(e.scene,this.motion,o),this.surface=this.touched()}colours;extent;robot;was=null;surface;paths=[];traced=0;replace(e){super.replace(e),this.robot=new Ks(this.run.scene,this.motion,this.extent),this.was=this.before&&new Ks(this.run.scene,this.before,this.extent),this.surface=this.touched(),this.traced=0}touched(){let{contact:e}=this.run.scene;if(e===null)return null;let{surface:n,at:r}={...e,...this.motion.arrays.contact};return new Fh({surface:n??e.surface,at:r},this.extent,this.colours.surface)}draw({pen:e,camera:n,scale:r,colours:s},o,a,l){let{motion:c,before:u}=this;e.aside=this.aside,this.seek(o,a),this.trace(a.factor),a.surface&&this.showsSurface&&this.surface?.draw(e),this.was&&u&&this.was.ghost(e,u.line,s.before,zh),a.rigid&&c.rigid&&this.robot.ghost(e,c.rigid,s.rigid,zh),a.reference&&c.reference&&this.robot.ghost(e,c.reference,this.referenceColour,zh),a.traces&&this.paths.forEach(({path:h,color:f})=>Mv(e,h,c.frame,f)),this.robot.draw(e,c.line,this.look(a),l,n.position),a.force&&c.arrays.contact&&Sv(e,c.force,c.at,r,s.force),e.aside=0}look(e){let n=Nl(e.colour);return{...Iv(this.colours,this.alone?null:this.colour,n==="none"?this.colour:this.colours.link),painted:n}}trace(e){if(e===this.traced)return;this.traced=e;let[n,r]=[this.motion.path(!1,e),this.motion.path(!0,e)];this.paths=[],r&&this.paths.push({path:r,color:this.referenceColour}),n&&this.paths.push({path:n,color:this.colour})}};function Iv({joint:i,gear:t,base:e,payload:n},r,s){return{link:s,joint:r??i,gear:r??t,base:e,payload:r??n,opacity:1,painted:"all",fine:!1}}var Vh=class extends fa{constructor(e,n){let{page:r,extent:s,colours:o}=e,a=new zn(32,1,.01*s.reach,100*s.reach);a.up.set(0,0,1);let l=new Nh(a);super(l.canvas,a,r.runs.map((c,u)=>new Jp(c,u,r.runs.length===1,o,s)),e);this.wanted=n;this.sheet={pen:l,camera:a,extent:s,colours:o,scale:this.scale},this.refresh()}wanted;sheet;mode=null;draw(e,n){let{sheet:r,runs:s}=this,{settings:o,extent:a,colours:l}=this.given;this.mode||this.cameras.follow(s[0].motion.tip),r.pen.begin(a.reach),o.floor&&wv(r.pen,a,l),this.mode?this.swing(2*Math.PI*n/kh):this.sorted().forEach(c=>c.draw(r,e,o,this.range))}showMode(e,n){super.showMode(e,n);let{scene:r}=this.runs[0].run,s=e&&new Fl(e,r,n*this.given.extent.reach);this.mode=s&&{swinging:s,robot:new Ks(r,s.motion,this.given.extent)}}resize(e,n){this.sheet.pen.resize(e,n)}tell(e){super.tell(e);let r=this.runs.some(({run:s})=>s.scene.meshes.length>0)?"; the surfaces of the parts (meshes) are left out":"";e.flat(`Drawn in lines${this.wanted?"":", without WebGL"}${r}`)}sorted(){let{pen:e}=this.sheet,n=r=>e.depth([0,r.aside,0],0);return[...this.runs].sort((r,s)=>n(s)-n(r))}swing(e){if(!this.mode)return;let{swinging:n,robot:r}=this.mode,{pen:s,camera:o,colours:a}=this.sheet;r.ghost(s,Float32Array.from(n.motion.arrays.line.data),a.rigid,zh),n.swing(e),r.draw(s,n.motion.line,Iv(a,null,a.link),{low:0,high:1},o.position)}};var Lv=5,Gh=class{legend=Dl("scene-legend");scale=Dl("scene-scale");factor=Dl("scene-factor");grid=Dl("scene-grid");way=Dl("scene-flat");live=Fe("span");shown="";constructor(t){let e=Fe("div",{className:"scene-below"},this.way,this.grid);t.append(this.legend,this.scale,Fe("div",{className:"scene-foot"},e,this.factor))}list(t,e){this.legend.replaceChildren(...t.map(({colour:n,label:r})=>Fe("span",{},Fv(n),r))),e&&this.legend.append(this.live),this.legend.hidden=t.length===0&&!e}tell(t){t!==this.shown&&(this.shown=t,this.live.textContent=t)}range(t){if(this.scale.hidden=t===null,t===null)return;let e=Ah(t.unit,t.high),n=Math.abs(t.low)<1e-6*Math.abs(t.high)?0:t.low,r=Array.from({length:Lv},(l,c)=>t.high+(n-t.high)*c/(Lv-1)),s=Fv(Tv()),o=e.name.replaceAll(" "," "),a=Fe("b",{},o?`${t.label} [${o}]`:t.label);this.scale.replaceChildren(a,Fe("ol",{},...r.map(l=>Fe("li",{},vr(e.factor*l)))),s)}enlarged(t){this.factor.hidden=t==="",this.factor.textContent=t}flat(t){this.way.hidden=t==="",this.way.textContent=t}floor(t){this.grid.hidden=t==="",this.grid.textContent=t}};function Dl(i){return Fe("div",{className:`scene-note ${i}`,hidden:!0})}function Fv(i){let t=Fe("i",{ariaHidden:"true"});return t.style.background=i,t}function Kp(){let i=document.createElement("canvas").getContext("webgl2");if(i===null)return null;let t=i.getExtension("WEBGL_debug_renderer_info"),e=String(i.getParameter(t?t.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)?"low":"high"}var Hh=class{constructor(t,e){this.quality=t;this.extent=e;let n=t==="high";this.renderer=new _h({canvas:this.canvas,antialias:n,alpha:!0,powerPreference:"low-power"}),this.renderer.setPixelRatio(n?Math.min(window.devicePixelRatio,2):.75*Math.min(window.devicePixelRatio,1)),this.renderer.shadowMap.enabled=n,this.renderer.shadowMap.type=Hs,this.camera.up.set(0,0,1),this.camera.near=.01*e.reach,this.camera.far=100*e.reach,this.scene.add(this.floor)}quality;extent;canvas=document.createElement("canvas");scene=new Za;camera=new zn(32,1,.01,100);renderer;floor=new On;light=new dl("#ffffff",2.2);dress(t){let{extent:e,light:n}=this;this.undress();let r=e.cell*2*Math.ceil(1.6*e.reach/e.cell),s=new Gs(r,Math.round(r/e.cell),t.gridStrong,t.grid);s.rotation.x=Math.PI/2,s.position.z=e.floor,this.floor.add(s,new ul(t.sky,t.ground,1.6),n,n.target);let o=e.box.getCenter(n.target.position);n.position.set(o.x-.6*e.reach,o.y-1.1*e.reach,o.z+2.2*e.reach),this.quality==="high"&&this.shadows(r)}get floorShown(){return this.floor.children[0]?.visible??!1}set floorShown(t){this.floor.children.forEach(e=>{(e instanceof Gs||e instanceof Ge)&&(e.visible=t)})}resize(t,e){t<1||e<1||(this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix())}draw(){this.renderer.render(this.scene,this.camera)}dispose(){this.undress(),this.light.dispose(),this.renderer.dispose(),this.renderer.getContext().isContextLost()||this.renderer.forceContextLoss(),this.canvas.remove()}shadows(t){let{light:e,extent:n}=this;e.castShadow=!0,e.shadow.mapSize.set(2048,2048),e.shadow.normalBias=.2*n.usual;let{camera:r}=e.shadow;r.left=r.bottom=-1.4*n.reach,r.right=r.top=1.4*n.reach,r.near=.1*n.reach,r.far=6*n.reach;let s=new Ge(new zs(t,t),new sl({opacity:.22,depthWrite:!1}));s.position.z=n.floor,s.receiveShadow=!0,this.floor.add(s)}undress(){for(let t of[...this.floor.children])t instanceof Gs?t.dispose():t instanceof Ge&&(t.geometry.dispose(),t.material.dispose());this.floor.clear()}};var K2=`
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
`,Wh=null;function Nv(){Wh===null&&(Wh=new CSSStyleSheet,Wh.replaceSync(K2),document.adoptedStyleSheets=[...document.adoptedStyleSheets,Wh])}var qh=class extends ha{constructor(e,n,r,s){super(e,n,r,s.colours);this.shared=s}shared;group=new On;robot;look;ghosts=new Map;traces=[];arrow=null;surface=null;built="";traced="";replace(e){let n=String(this.motion.arrays.line.shape.slice(1));super.replace(e),String(this.motion.arrays.line.shape.slice(1))!==n&&(this.built=""),this.traced="",this.built!==""&&this.placeSurface()}update(e,n,r){let{motion:s}=this;this.build(n),this.seek(e,n),this.robot.update(s,s.line,r.low,r.high),this.haunt("reference",s,n.reference?s.reference:null),this.haunt("rigid",s,n.rigid?s.rigid:null),this.haunt("before",this.before??s,this.before?.line??null),this.draw(n)}dispose(){this.clear(),this.group.removeFromParent()}build(e){let n=Nl(e.colour);if(n===this.built)return;this.clear(),this.built=n;let{scene:r}=this.run,{extent:s,colours:o,fine:a}=this.shared,l=n==="none"?this.colour:o.link,c=this.alone?o.joint:this.colour,u={link:l,joint:c,gear:this.alone?o.gear:c,base:o.base,payload:c,opacity:1,painted:n,fine:a};this.robot=this.added(r,this.motion,u,1),this.look=u,r.contact&&(this.arrow=new Lh(o.force,.006*s.reach,this.shared.scale),this.group.add(this.arrow.group),this.placeSurface())}placeSurface(){let{contact:e}=this.run.scene;if(!e)return;let{extent:n,colours:r}=this.shared,{surface:s,at:o}={...e,...this.motion.arrays.contact};this.dropSurface(),this.surface=bv(s??e.surface,o.data,.12*n.reach,r.surface),this.group.add(this.surface)}dropSurface(){this.surface&&(this.surface.geometry.dispose(),this.surface.material.dispose(),this.surface.removeFromParent(),this.surface=null)}haunt(e,n,r){let s=this.ghosts.get(e);if(s&&(s.group.visible=r!==null),r===null)return;(s??this.ghost(e,n)).update(n,r,0,1)}ghost(e,n){let{colours:r}=this.shared,s={reference:this.referenceColour,rigid:r.rigid,before:r.before}[e],o=this.added(this.run.scene,n,{...this.look,link:s,opacity:.42,painted:"none"},.85);return this.ghosts.set(e,o),o}added(e,n,r,s){let{extent:o}=this.shared,a={usual:s*o.usual,least:s*o.least,floor:o.floor},l=new Js(s<1?Q2(e,s):e,n,r,a);return this.group.add(l.group),l}draw(e){this.trace(e);for(let{trace:n,reference:r}of this.traces)n.group.visible=e.traces&&(!r||this.motion.arrays.tipReference!==null),n.seek(this.motion.frame);this.surface&&(this.surface.visible=e.surface&&this.showsSurface),this.arrow&&(this.arrow.point(this.motion.force,this.motion.at),this.arrow.group.visible&&=e.force&&this.motion.arrays.contact!==null)}trace(e){let n=`${e.factor}`;if(n===this.traced)return;let r=this.traces.length===0;this.traced=n;for(let s of[!1,!0]){let o=this.motion.path(s,e.factor),a=this.traces.find(l=>l.reference===s);if(o!==null){if(a)a.trace.lay(o);else if(r){let l=s?this.referenceColour:this.colour,c=new Ih(o,l,.012*this.shared.extent.reach);this.traces.push({trace:c,reference:s}),this.group.add(c.group)}}}}clear(){this.robot?.dispose(),this.ghosts.forEach(e=>e.dispose()),this.traces.forEach(({trace:e})=>e.dispose()),this.arrow?.dispose(),this.dropSurface(),this.ghosts.clear(),this.traces=[],this.traced=this.built=""}};function Q2(i,t){let e=i.links.map(n=>{if(n.section===null)return n;let{data:r,shape:s}=n.section.sizes;return{...n,section:{...n.section,sizes:{data:Float32Array.from(r,o=>t*o),shape:s}}}});return{...i,links:e}}var Xh=class extends fa{stage;shared;mode=null;constructor(t,e){let{page:n,extent:r,colours:s}=t,o=new Hh(e,r),a={extent:r,colours:s,fine:e==="high",scale:Bh(n.runs,r.reach)},l=n.runs.map((c,u)=>new qh(c,u,n.runs.length===1,a));super(o.canvas,o.camera,l,t),this.stage=o,this.shared=a,o.dress(s),l.forEach(({group:c})=>o.scene.add(c)),this.refresh()}draw(t,e){let{settings:n}=this.given;this.mode?this.mode.swing(2*Math.PI*e/kh):this.runs.forEach(r=>r.update(t,n,this.range)),this.mode||this.cameras.follow(this.runs[0].motion.tip),this.stage.draw()}showMode(t,e){super.showMode(t,e),this.mode?.dispose(),this.mode=t&&new Uh(t,this.runs[0].run.scene,e,this.shared),this.mode&&this.stage.scene.add(this.mode.group),this.runs.forEach(({group:n})=>n.visible=t===null)}refresh(){super.refresh(),this.runs.forEach(({group:t,aside:e})=>t.position.set(0,e,0)),this.stage.floorShown=this.given.settings.floor}resize(t,e){this.stage.resize(t,e)}dispose(){this.mode?.dispose(),this.runs.forEach(t=>t.dispose()),super.dispose(),this.stage.dispose()}};var tP=2e3;function Dv(i,t,e){Nv();let n=Fe("div",{className:"scene"}),r=Fe("div",{className:"scene-view"});return i.append(n),new Qp(n,r,t,e,Kp())}var Qp=class{constructor(t,e,n,r,s){this.frame=t;this.view=e;this.page=n;this.clock=r;this.best=s;let{runs:o}=n,a=o.length>1;this.settings={colour:a?"run":o[0].scene.colours[0]?.id??"run",factor:1,reference:!a,rigid:!1,traces:!0,force:!0,surface:!0,floor:!0,apart:!1,quality:"auto"},this.replaced=o.map(()=>null),this.extent=dv(n),this.notes=new Gh(e),t.append(this.controls(),e),this.world=this.made(),this.ends.push(r.subscribe(this.ask));let l=new ResizeObserver(()=>this.resize());l.observe(e),this.dark.addEventListener("change",this.remake),this.ends.push(()=>l.disconnect(),()=>this.dark.removeEventListener("change",this.remake)),this.resize(),this.refresh(),this.world.look("iso",!1)}frame;view;page;clock;best;settings;notes;replaced;ends=[];dark=window.matchMedia("(prefers-color-scheme: dark)");still=window.matchMedia("(prefers-reduced-motion: reduce)");extent;world;waiting=0;mode=null;asked=0;replace(t,e){this.replaced[t]=e,this.world.replace(t,e),this.refresh()}showMode(t,e){this.mode=t===null?null:{mode:t,amplitude:e},this.world.showMode(t,e),this.refresh()}resize(){this.world.resize(this.view.clientWidth,this.view.clientHeight),this.ask()}dispose(){cancelAnimationFrame(this.asked),window.clearTimeout(this.waiting),this.ends.forEach(t=>t()),this.world.canvas.removeEventListener("webglcontextlost",this.lost),this.world.dispose(),this.frame.remove()}controls(){let{runs:t}=this.page,n=[...new Map(t.flatMap(({scene:a})=>a.colours.map(({id:l,label:c})=>[l,c]))),["run",t.length>1?"each robot its own":"none"]],r=a=>t.some(({scene:l})=>a(l)),o=[["reference",r(a=>a.reference)],["rigid",r(a=>a.rigid)],["traces",!0],["force",r(a=>a.contact)],["surface",r(a=>a.contact)],["floor",!0],["apart",t.length>1]].filter(([,a])=>a).map(([a])=>a);return fv(this.settings,n,o,r(a=>a.rigid),this.best!==null,{changed:()=>this.refresh(),look:a=>this.world.look(a,!this.still.matches),quality:()=>{this.best??=Kp(),this.remake()}})}made(){let{page:t,extent:e,settings:n,ask:r}=this,s={page:t,extent:e,colours:Av(this.dark.matches),settings:n,ask:r},{quality:o}=n,a=o==="lines"?null:this.best&&(o==="auto"?this.best:o),l=(a&&eP(s,a))??new Vh(s,o==="lines");return l.canvas.addEventListener("webglcontextlost",this.lost),l.canvas.addEventListener("webglcontextrestored",this.found),this.view.prepend(l.canvas),l}lost=t=>{t.target===this.world.canvas&&(window.clearTimeout(this.waiting),this.waiting=window.setTimeout(()=>{this.best=null,this.remake()},tP))};found=()=>{window.clearTimeout(this.waiting),this.ask()};remake=()=>{let t=this.world;this.world=this.made(),this.world.takeView(t),t.dispose(),this.replaced.forEach((e,n)=>e&&this.world.replace(n,e)),this.mode&&this.world.showMode(this.mode.mode,this.mode.amplitude),this.resize(),this.refresh()};refresh(){this.world.refresh(),this.world.tell(this.notes),this.ask()}ask=()=>{this.asked===0&&(this.asked=requestAnimationFrame(this.draw))};draw=t=>{this.asked=0,this.world.draw(this.clock.time,this.still.matches?0:t/1e3),this.notes.tell(this.world.words()),this.mode&&!this.still.matches&&this.ask()}};function eP(i,t){try{return new Xh(i,t)}catch{return null}}function Uv(i,t){let e=Math.max(...t.runs.map(S=>S.duration)),n=wm(e),r=lt("div",{class:"scene"}),s=lt("div",{class:"facts-panel",role:"region",tabindex:"0","aria-label":"Numbers that matter"}),o=lt("div",{class:"sliders-panel",role:"region",tabindex:"0","aria-label":"Settings"}),a=lt("div",{class:"side"},o,s),l=lt("div",{class:"transport",role:"group","aria-label":"Time"}),c=lt("section",{class:"charts","aria-label":"Charts"}),u=t.runs.length>1?` of ${t.runs[0].name}`:"",h=Ov(`Elastic line${u}`,t.runs[0].line!==null),f=Ov(`Modes of vibration${u}`,t.runs[0].modes.length>0),d=lt("div",{class:"bar files"});i.classList.add("app"),i.append(lt("div",{class:"stage"},r,a),l,c,lt("div",{class:"lower"},h.element,f.element),d);let m=Dv(r,t,n),y=[m,ux(l,n)],g=Ky(s,t),p=v0(c,t,n),x=t.runs[0].line?ex(h.body,t,n):null,b=t.runs[0].modes.length?yd(f.body,t,m,n):null;sx(d,t),l.hidden=c.hidden=t.runs.every(S=>S.charts.length===0);let v=null;function A(S){n.setDuration(Math.max(S?S.times[S.times.length-1]:0,e)),S?.scene!==v?.scene&&(m.replace(0,S&&S.scene),x?.show(S)),p.show(S),g.show(S),b?.show(S),v=S}return t.live?y.push(lx(o,t.live,{open:Jy,show:A,fileName:`${xd(t.runs[0].name)}_changed`})):t.notLive&&o.append(lt("p",{class:"note",text:`Nothing can be changed in this page: ${t.notLive}.`})),{clock:n,side:o,scene:m,show:A,showModes(S){b?.dispose(),f.body.replaceChildren(),f.element.hidden=S.length===0;let[_,...w]=t.runs;b=S.length?yd(f.body,{...t,runs:[{..._,modes:S},...w]},m,n):null},dispose(){n.pause(),b?.dispose(),[...y,p,...x?[x]:[]].forEach(S=>S.dispose()),i.replaceChildren()}}}function Ov(i,t){let e=lt("div",{});return{element:lt("section",{class:"panel",hidden:!t,"aria-label":i},lt("h3",{text:i}),e),body:e}}function kv(i){let t=document.documentElement,e=[];addEventListener("beforeprint",()=>{t.classList.add("printing");let n=[...document.querySelectorAll(i)].filter(r=>!r.open);for(let r of n)r.open=!0;e=[...e,...n]}),addEventListener("afterprint",()=>{t.classList.remove("printing");for(let n of e)n.open=!1;e=[]})}async function nP(){let i=document.getElementById("tmodes-data"),t=document.getElementById("tmodes-app");if(!(i===null||t===null))try{let e=vm(await bm(i.textContent??""));Uv(t,e),document.documentElement.classList.add("running")}catch(e){let n=e instanceof Error?e.message:String(e);t.replaceChildren(lt("p",{class:"status warning",role:"alert",text:`The interactive part of this page could not start: ${n}. The whole report without it follows.`}))}}kv("details");nP();})();
