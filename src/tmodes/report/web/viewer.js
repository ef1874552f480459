/* tmodes, built from 94beb40a3f367122; BSD-3-Clause */
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
"use strict";(()=>{function ce(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))s==="text"?n.textContent=String(r):r!==void 0&&r!==!1&&n.setAttribute(s,r===!0?"":r);return n.append(...t.filter(s=>s!==null)),n}function Tn(i,e,t={}){let n=ce("button",{type:"button",text:i,...t});return n.addEventListener("click",e),n}function xl(i,e,t=2){let n="http://www.w3.org/2000/svg",s=document.createElementNS(n,"svg"),r=document.createElementNS(n,"line"),o={x1:0,y1:5,x2:26,y2:5,"stroke-width":t,"stroke-dasharray":e.join(" ")};for(let[a,l]of Object.entries(o))r.setAttribute(a,String(l));r.style.stroke=i;for(let[a,l]of Object.entries({width:26,height:10,"aria-hidden":"true"}))s.setAttribute(a,String(l));return s.append(r),s}var dp=0;function Ms(i){return dp+=1,`tm-${i}-${dp}`}function Qr(i,e,t){let n=URL.createObjectURL(new Blob([i],{type:t}));ce("a",{href:n,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}var ky="TMPK";function pp(i){if(new TextDecoder().decode(i.subarray(0,4))!==ky)throw new Error("these bytes are no data of tmodes");let t=new DataView(i.buffer,i.byteOffset,i.byteLength).getUint32(4,!0),n=JSON.parse(new TextDecoder().decode(i.subarray(8,8+t))),s=8*Math.ceil((8+t)/8),r=n.arrays.map(o=>zy(i,s,o));return vl(n.page,r)}function zy(i,e,t){let n=t.shape.reduce((o,a)=>o*a,1),s=Number(t.dtype[1]),r=i.slice(e+t.offset,e+t.offset+n*s).buffer;return t.dtype==="f8"?{data:new Float64Array(r),shape:t.shape}:t.dtype==="d4"?{data:Gy(new Uint8Array(r),n,t),shape:t.shape}:t.dtype==="i4"?{data:new Int32Array(r),shape:t.shape}:t.dtype==="u1"?{data:new Uint8Array(r),shape:t.shape}:{data:Vy(new Uint8Array(r),n,t),shape:t.shape}}function Vy(i,e,{shape:t,scale:n=1,start:s=0}){let r=e/(t[0]||1)||1,o=new Int16Array(e);for(let a=0;a<e;a++)o[a]=(i[a]|i[e+a]<<8)+(a>=r?o[a-r]:0);return Float32Array.from(o,a=>s+n*a)}function Gy(i,e,{shape:t}){let n=e/(t[0]||1)||1,s=new Uint32Array(e);for(let r=0;r<e;r++){let o=i[r]|i[e+r]<<8|i[2*e+r]<<16|i[3*e+r]<<24;s[r]=o+(r>=n?s[r-n]:0)}return new Float32Array(s.buffer)}function vl(i,e){if(Array.isArray(i))return i.map(n=>vl(n,e));if(i===null||typeof i!="object")return i;let t=Object.entries(i);return t.length===1&&t[0][0]==="$array"?e[t[0][1]]:t.length===1&&t[0][0]==="$sum"?Hy(vl(t[0][1],e)):Object.fromEntries(t.map(([n,s])=>[n,vl(s,e)]))}function Hy([i,e]){return{data:Float32Array.from(i.data,(t,n)=>t+e.data[n]),shape:i.shape}}async function mp(i){let e=Uint8Array.from(atob(i.trim()),n=>n.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(t).arrayBuffer())}function gp(i){let e=new Set,t=0,n=0,s=()=>e.forEach(l=>l(a)),r={time:0,duration:i,playing:!1},o=l=>{let c=Math.min(.25,(l-n)/1e3);n=l,r.time+=c*a.speed,r.time>=r.duration&&(r.time=0),s(),r.playing&&(t=requestAnimationFrame(o))},a={get time(){return r.time},get duration(){return r.duration},get playing(){return r.playing},speed:1,seek(l){r.time=Math.min(Math.max(l,0),r.duration),s()},play(){r.playing||(r.playing=!0,n=performance.now(),t=requestAnimationFrame(o),s())},pause(){r.playing=!1,cancelAnimationFrame(t),s()},toggle(){r.playing?a.pause():a.play()},setDuration(l){r.duration=l,a.seek(r.time)},subscribe(l){return e.add(l),()=>e.delete(l)}};return a}var Wy=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],Xy=["m","rad","s"],qy=["Hz","%","rad/s"],$y="⁰¹²³⁴⁵⁶⁷⁸⁹";function Eh(i){let e=i.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(e)?"":e}function si(i,e=4){return i===0?"0":String(Number(i.toPrecision(e)))}function _p(i){if(i===0)return"0";let[e,t]=i.toExponential(1).split("e"),n=[...String(Number(t))].map(s=>s==="-"?"⁻":$y[Number(s)]).join("");return`${e} × 10${n}`}function Th(i,e){let t=Eh(i);if(!t||qy.includes(i)||!(e>0))return{factor:1,name:t};let n=Xy.includes(i.split("/")[0]),s=Wy.find(([r,o])=>e>=r&&(o>=1||!n));return s?{factor:s[1],name:s[2]+t}:{factor:1,name:t}}function Hs(i,e){if(i===null||!Number.isFinite(i))return"–";let t=Math.abs(i),{factor:n,name:s}=Th(e,t);return`${t>0&&(n===1?t<.001:t<1e-11)?_p(i):si(i*n)} ${s}`.trimEnd()}function Kn(i){let e=Math.abs(i);return e!==0&&(e<.001||e>=1e6)?_p(i):si(i)}function yp(i,e,t,n){let[s,r]=n??t.span??[i[0],i[i.length-1]],o=1e-9*Math.max(1,Math.abs(r)),a=Yy(i,Array.from(i.keys()).filter(p=>i[p]>=s-o&&i[p]<=r+o)),l=Float64Array.from(a,p=>e[p]),c=l.length;if(c<4)return{x:new Float64Array,y:new Float64Array};let u=(i[a[c-1]]-i[a[0]])/(c-1),h=Zy(l),f=2**Math.ceil(Math.log2(4*c)),d=new Float64Array(f),m=new Float64Array(f);d.set(l),Jy(d,m);let _=t.at.data[t.at.data.length-1],g=Math.min(f/2,Math.floor(_*f*u)+1);return{x:Float64Array.from({length:g},(p,b)=>b/(f*u)),y:Float64Array.from({length:g},(p,b)=>2*Math.hypot(d[b],m[b])/h)}}function Yy(i,e){if(e.length<3)return e;let t=s=>i[e[s]]-i[e[s-1]];return Math.abs(t(e.length-1)/t(1)-1)>1e-6?e.slice(0,-1):e}function Zy(i){let e=i.length,t=(e-1)/2,n=i.reduce((a,l)=>a+l,0)/e,s=e*(e*e-1)/12,r=i.reduce((a,l,c)=>a+(c-t)*l,0)/s,o=0;for(let a=0;a<e;a+=1){let l=.5-.5*Math.cos(2*Math.PI*a/e);i[a]=l*(i[a]-n-r*(a-t)),o+=l}return o}function Jy(i,e){let t=i.length;for(let n=1,s=0;n<t;n+=1){let r=t>>1;for(;s&r;r>>=1)s^=r;s^=r,n<s&&([i[n],i[s]]=[i[s],i[n]],[e[n],e[s]]=[e[s],e[n]])}for(let n=2;n<=t;n*=2)Ky(i,e,n)}function Ky(i,e,t){let n=t/2;for(let s=0;s<n;s+=1){let r=-2*Math.PI*s/t,[o,a]=[Math.cos(r),Math.sin(r)];for(let l=s;l<i.length;l+=t){let c=l+n,u=i[c]*o-e[c]*a,h=i[c]*a+e[c]*o;[i[c],e[c]]=[i[l]-u,e[l]-h],[i[l],e[l]]=[i[l]+u,e[l]+h]}}}function vp(i){let e=new Map;return i.runs.forEach((t,n)=>t.charts.forEach(s=>{let r=e.get(s.id);r?r.runs.push({run:n,name:t.name,chart:s}):e.set(s.id,{chart:s,runs:[{run:n,name:t.name,chart:s}]})})),[...e.values()]}function Rh(i,e){let t=i.runs.flatMap(({run:r,name:o,chart:a})=>a.curves.map(l=>({run:r,runName:o,label:l.label,role:l.role,x:a.at.data,y:l.values.data,shown:l.shown&&(i.runs.length<2||jy(l,a)),ghost:e!==null&&r===0})));if(e===null)return t;let n=i.runs.find(({run:r})=>r===0),s=(n?.chart.curves??[]).flatMap(r=>Qy(r,n.chart,n.name,e));return[...t,...s]}function jy(i,e){return i.role==="real"&&i.label===e.curves[0].label}function Qy(i,e,t,n){let s=ex(i,n);if(s===null)return[];let{x:r,y:o}=e.abscissa==="time"?{x:n.times,y:s}:yp(n.times,s,e,n.span);return[{run:0,runName:t,label:i.label,role:i.role,x:r,y:o,shown:i.shown,ghost:!1}]}function ex(i,e){let t=i.source;if(t===null)return null;let n=xp(e,t.variable,t.index),s=t.less?xp(e,t.less.variable,t.less.index):null;return n===null||t.less&&s===null?null:n.map((r,o)=>t.factor*(r-(s?s[o]:0)))}function xp(i,e,t){let n=i.series[e];if(n===void 0)return null;let s=n.shape.slice(1).reduce((r,o)=>r*o,1);return t>=s?null:Float64Array.from({length:n.shape[0]},(r,o)=>n.data[o*s+t])}function bl(i,e){let t=[...new Set(i.map(s=>s.x))],n=t.every(s=>bp(s,t[0]))?t[0]:tx(t);return[n,...i.map(s=>nx(s,n,e))]}function bp(i,e){if(i===e)return!0;if(i.length!==e.length)return!1;for(let t=0;t<i.length;t+=1)if(Math.abs(i[t]-e[t])>1e-6*Math.abs(e[t]))return!1;return!0}function tx(i){let e=i.flatMap(t=>Array.from(t)).sort((t,n)=>t-n);return e.filter((t,n)=>n===0||t>e[n-1])}function nx(i,e,t){let n=r=>t?r===0?null:Math.abs(r):r;if(e===i.x||bp(e,i.x))return Array.from(i.y,r=>n(r));let s=new Array(e.length).fill(null);for(let r=0,o=0;r<i.x.length;r+=1){for(;o<e.length&&e[o]<i.x[r];)o+=1;o<e.length&&(s[o]=n(i.y[r]))}return s}function Sp(i,e){let{x:t,y:n}=i,s=t.length-1;if(s<0||e<t[0]-1e-9||e>t[s]+1e-6*Math.abs(t[s])+1e-9)return null;let r=0,o=s;for(;o-r>1;){let a=r+o>>1;t[a]<=e?r=a:o=a}return o===r||e>=t[o]?n[o]:n[r]+(n[o]-n[r])*(e-t[r])/(t[o]-t[r])}function Mp(i,e,t){let[n,...s]=bl(i,!1),r=new Set(i.map(l=>l.run)).size>1,o=i.map(l=>`${[r?l.runName:"",l.label,l.role,l.ghost?"original":""].filter(Boolean).join(" ")} [${t||"-"}]`),a=Array.from(n,(l,c)=>[l,...s.map(u=>u[c]??"")].map(ix).join(","));return`${[e,...o].map(sx).join(",")}
${a.join(`
`)}
`}function ix(i){return typeof i=="string"?i:String(Number(i.toPrecision(9)))}function sx(i){return`"${(/^[=+\-@\t\r]/.test(i)?`'${i}`:i).replaceAll('"','""')}"`}var wp=["--blue","--red","--green","--violet","--ochre","--sky"],rx={real:"--blue",reference:"--red",rigid:"--quiet",stationary:"--green",oscillatory:"--violet",limit:"--quiet",other:"--ochre"},Ap={real:[],reference:[6,3],rigid:[2,3],stationary:[9,2,2,2],oscillatory:[2,2],limit:[1,3],other:[10,3]},Ep=[[],[7,2],[6,2,2,2],[2,2],[9,2,2,2,2,2],[12,4]],Tp={real:"real",reference:"reference",rigid:"rigid",stationary:"stationary part",oscillatory:"oscillatory part",limit:"limit",other:"other"};function ta(i,e,t,n){if(!t)return{property:rx[i],dash:Ap[i]};let s=n>1?Ap[i]:Ep[e%Ep.length];return{property:wp[e%wp.length],dash:s}}function rs(i){return getComputedStyle(document.documentElement).getPropertyValue(i).trim()||"#808080"}function Rp(i,e){let t=i.filter(f=>!f.ghost),n=[f=>String(f.run),f=>f.label,f=>f.role],s=n.map(f=>[...new Set(t.map(f))]),r=n.map((f,d)=>new Set(s[d].filter(m=>!t.some(_=>_.shown&&f(_)===m)))),o=s[0].length>1?0:s[1].length>1?1:2,a=s[2].length,l=f=>{let d=o===0&&s[1].length>1&&a===1?s[1].length:a,m=ta(f.role,s[o].indexOf(n[o](f)),o<2,d);return o===0&&a===1?{...m,dash:ta("real",s[1].indexOf(f.label),!0,1).dash}:m},c=ce("div",{class:"legend"}),u=new Map;n.forEach((f,d)=>{if(s[d].length<2&&d!==o)return;let m=ce("div",{class:"legend-row",role:"group","aria-label":["Runs","Curves","Parts"][d]});for(let _ of s[d]){let g=t.find(p=>f(p)===_);g&&m.append(h(g,_,d))}c.append(m)});function h(f,d,m){let _=m===0?f.runName:m===2&&a>1?Tp[f.role]:f.label,g=m===o?l(f):{property:"--quiet",dash:m===2?l(f).dash:[]},p=xl(`var(${g.property})`,m===o&&o<2&&a>1?[]:g.dash),b=ce("span",{class:"value"}),T=ce("button",{type:"button",class:"toggle","aria-pressed":String(!r[m].has(d))},p,ce("span",{text:_}),b);return m===o&&u.set(d,b),T.addEventListener("click",()=>{r[m].delete(d)||r[m].add(d),T.setAttribute("aria-pressed",String(!r[m].has(d))),e()}),T}return{element:c,look:l,renew(f){t=f.filter(d=>!d.ghost)},shows:f=>n.every((d,m)=>!r[m].has(d(f))),tell(f){for(let[d,m]of u){let _=t.find(p=>n[o](p)===d&&n.every((b,T)=>!r[T].has(b(p)))),g=_?f(_):null;m.textContent=g===null?"":Kn(g).replace("-","−")}}}}var ox="uplot",ax="u-hz",lx="u-vt",cx="u-title",ux="u-wrap",hx="u-under",fx="u-over",dx="u-axis",vr="u-off",px="u-select",mx="u-cursor-x",gx="u-cursor-y",_x="u-cursor-pt",yx="u-legend",xx="u-live",vx="u-inline",bx="u-series",Sx="u-marker",Cp="u-label",Mx="u-value",ia="width",sa="height";var Pp="bottom",eo="left",Ch="right",qh="#000",Ip=qh+"0",Ph="mousemove",Lp="mousedown",Ih="mouseup",Dp="mouseenter",Fp="mouseleave",Np="dblclick",wx="resize",Ax="scroll",Up="change",El="dppxchange",$h="--",ao=typeof window<"u",Uh=ao?document:null,no=ao?window:null,Ex=ao?navigator:null,Mt,Sl;function Oh(){let i=devicePixelRatio;Mt!=i&&(Mt=i,Sl&&kh(Up,Sl,Oh),Sl=matchMedia(`(min-resolution: ${Mt-.001}dppx) and (max-resolution: ${Mt+.001}dppx)`),br(Up,Sl,Oh),no.dispatchEvent(new CustomEvent(El)))}function fi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Bh(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Xt(i,e,t){i.style[e]=t+"px"}function Ni(i,e,t,n){let s=Uh.createElement(i);return e!=null&&fi(s,e),t?.insertBefore(s,n),s}function wi(i,e){return Ni("div",i,e)}var Op=new WeakMap;function os(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Op.get(i);r!=o&&(i.style.transform=r,Op.set(i,r),e<0||t<0||e>n||t>s?fi(i,vr):Bh(i,vr))}var Bp=new WeakMap;function kp(i,e,t){let n=e+t,s=Bp.get(i);n!=s&&(Bp.set(i,n),i.style.background=e,i.style.borderColor=t)}var zp=new WeakMap;function Vp(i,e,t,n){let s=e+""+t,r=zp.get(i);s!=r&&(zp.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Yh={passive:!0},Tx={...Yh,capture:!0};function br(i,e,t,n){e.addEventListener(i,t,n?Tx:Yh)}function kh(i,e,t,n){e.removeEventListener(i,t,Yh)}ao&&Oh();function Ui(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:di((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function mm(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var gm=i=>i!=null,_m=i=>i!=null&&i>0,Cl=mm(gm),Rx=mm(_m);function Cx(i,e,t,n=0,s=!1){let r=s?Rx:Cl,o=s?_m:gm;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ft,l??-Ft]}function Pl(i,e,t,n){let s=Wp(i),r=Wp(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ws:ym,a=s==1?di:Ai,l=r==1?Ai:di,c=a(o(yn(i))),u=l(o(yn(e))),h=io(t,c),f=io(t,u);return t==10&&(c<0&&(h=Nt(h,-c)),u<0&&(f=Nt(f,-u))),n||t==2?(i=h*s,e=f*r):(i=Sm(i,h),e=Il(e,f)),[i,e]}function Zh(i,e,t,n){let s=Pl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Jh=.1,Gp={mode:3,pad:Jh},oa={pad:0,soft:null,mode:0},Px={min:oa,max:oa};function Tl(i,e,t,n){return Ll(t)?Hp(i,e,t):(oa.pad=t,oa.soft=n?0:null,oa.mode=n?3:0,Hp(i,e,Px))}function bt(i,e){return i??e}function Ix(i,e,t){for(e=bt(e,0),t=bt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Hp(i,e,t){let n=t.min,s=t.max,r=bt(n.pad,0),o=bt(s.pad,0),a=bt(n.hard,-Ft),l=bt(s.hard,Ft),c=bt(n.soft,Ft),u=bt(s.soft,-Ft),h=bt(n.mode,0),f=bt(s.mode,0),d=e-i,m=ws(d),_=jn(yn(i),yn(e)),g=ws(_),p=yn(g-m);(d<1e-24||p>10)&&(d=0,(i==0||e==0)&&(d=1e-24,h==2&&c!=Ft&&(r=0),f==2&&u!=-Ft&&(o=0)));let b=d||_||1e3,T=ws(b),x=io(10,di(T)),R=b*(d==0?i==0?.1:1:r),w=Nt(Sm(i-R,x/10),24),y=i>=c&&(h==1||h==3&&w<=c||h==2&&w>=c)?c:Ft,E=jn(a,w<y&&i>=y?y:Oi(y,w)),O=b*(d==0?e==0?.1:1:o),L=Nt(Il(e+O,x/10),24),I=e<=u&&(f==1||f==3&&L>=u||f==2&&L<=u)?u:-Ft,k=Oi(l,L>I&&e<=I?I:jn(I,L));return E==k&&E==0&&(k=100),[E,k]}var Lx=new Intl.NumberFormat(ao?Ex.language:"en-US"),Kh=i=>Lx.format(i),pi=Math,Al=pi.PI,yn=pi.abs,di=pi.floor,_n=pi.round,Ai=pi.ceil,Oi=pi.min,jn=pi.max,io=pi.pow,Wp=pi.sign,ws=pi.log10,ym=pi.log2,Dx=(i,e=1)=>pi.sinh(i)*e,Lh=(i,e=1)=>pi.asinh(i/e),Ft=1/0;function Xp(i){return(ws((i^i>>31)-(i>>31))|0)+1}function zh(i,e,t){return Oi(jn(i,e),t)}function xm(i){return typeof i=="function"}function _t(i){return xm(i)?i:()=>i}var Fx=()=>{},vm=i=>i,bm=(i,e)=>e,Nx=i=>null,qp=i=>!0,$p=(i,e)=>i==e,Ux=/\.\d*?(?=9{6,}|0{6,})/gm,Sr=i=>{if(wm(i)||Xs.has(i))return i;let e=`${i}`,t=e.match(Ux);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Sr(s)}e${r}`}return Nt(i,n)};function yr(i,e){return Sr(Nt(Sr(i/e))*e)}function Il(i,e){return Sr(Ai(Sr(i/e))*e)}function Sm(i,e){return Sr(di(Sr(i/e))*e)}function Nt(i,e=0){if(wm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return _n(n)/t}var Xs=new Map;function Mm(i){return((""+i).split(".")[1]||"").length}function la(i,e,t,n){let s=[],r=n.map(Mm);for(let o=e;o<t;o++){let a=yn(o),l=Nt(io(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:Nt(u,h);s.push(f),Xs.set(f,h)}}return s}var aa={},jh=[],so=[null,null],Ws=Array.isArray,wm=Number.isInteger,Ox=i=>i===void 0;function Yp(i){return typeof i=="string"}function Ll(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Bx(i){return i!=null&&typeof i=="object"}var kx=Object.getPrototypeOf(Uint8Array),Am="__proto__";function ro(i,e=Ll){let t;if(Ws(i)){let n=i.find(s=>s!=null);if(Ws(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=ro(i[s],e)}else t=i.slice()}else if(i instanceof kx)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Am&&(t[n]=ro(i[n],e))}else t=i;return t}function fn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Am&&(Ll(i[s])?fn(i[s],ro(n[s])):i[s]=ro(n[s]))}return i}var zx=0,Vx=1,Gx=2;function Hx(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Wx(i,e){if($x(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Yx(o[0])||(o=qx(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:Vx,d=[];for(let m=0;m<u.length;m++){let _=u[m],g=r.get(l[m]);_===null?f!=zx&&(h[g]=_,f==Gx&&d.push(g)):h[g]=_}Hx(h,d,s),n.push(h)}}return n}var Xx=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function qx(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function $x(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Yx(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=jn(1,di((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Em=["January","February","March","April","May","June","July","August","September","October","November","December"],Tm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Rm(i){return i.slice(0,3)}var Zx=Tm.map(Rm),Jx=Em.map(Rm),Kx={MMMM:Em,MMM:Jx,WWWW:Tm,WWW:Zx};function na(i){return(i<10?"0":"")+i}function jx(i){return(i<10?"00":i<100?"0":"")+i}var Qx={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>na(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>na(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>na(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>na(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>na(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>jx(i.getMilliseconds())};function Qh(i,e){e=e||Kx;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Qx[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var ev=new Intl.DateTimeFormat().resolvedOptions().timeZone;function tv(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==ev?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Cm=i=>i%1==0,Rl=[1,2,2.5,5],nv=la(10,-32,0,Rl),Pm=la(10,0,32,Rl),iv=Pm.filter(Cm),xr=nv.concat(Pm),ef=`
`,Im="{YYYY}",Zp=ef+Im,Lm="{M}/{D}",ra=ef+Lm,Ml=ra+"/{YY}",Dm="{aa}",sv="{h}:{mm}",to=sv+Dm,Jp=ef+to,Kp=":{ss}",At=null;function Fm(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?la(10,0,3,Rl).filter(Cm):la(10,-3,0,Rl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Im,At,At,At,At,At,At,1],[s*28,"{MMM}",Zp,At,At,At,At,At,1],[s,Lm,Zp,At,At,At,At,At,1],[n,"{h}"+Dm,Ml,At,ra,At,At,At,1],[t,to,Ml,At,ra,At,At,At,1],[e,Kp,Ml+" "+to,At,ra+" "+to,At,Jp,At,1],[i,Kp+".{fff}",Ml+" "+to,At,ra+" "+to,At,Jp,At,1]];function u(h){return(f,d,m,_,g,p)=>{let b=[],T=g>=o,x=g>=r&&g<o,R=h(m),w=Nt(R*i,3),y=Dh(R.getFullYear(),T?0:R.getMonth(),x||T?1:R.getDate()),E=Nt(y*i,3);if(x||T){let O=x?g/r:0,L=T?g/o:0,I=w==E?w:Nt(Dh(y.getFullYear()+L,y.getMonth()+O,1)*i,3),k=new Date(_n(I/i)),V=k.getFullYear(),D=k.getMonth();for(let H=0;I<=_;H++){let q=Dh(V+L*H,D+O*H,1),G=q-h(Nt(q*i,3));I=Nt((+q+G)*i,3),I<=_&&b.push(I)}}else{let O=g>=s?s:g,L=di(m)-di(w),I=E+L+Il(w-E,O);b.push(I);let k=h(I),V=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,D=g/n,H=f.axes[d]._space,q=p/H;for(;I=Nt(I+g,i==1?0:3),!(I>_);)if(D>1){let G=di(Nt(V+D,6))%24,K=h(I).getHours()-G;K>1&&(K=-1),I-=K*n,V=(V+D)%24;let ee=b[b.length-1];Nt((I-ee)/g,3)*q>=.7&&b.push(I)}else b.push(I)}return b}}return[l,c,u]}var[rv,ov,av]=Fm(1),[lv,cv,uv]=Fm(.001);la(2,-53,53,[1]);function jp(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Qp(i,e){return(t,n,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,f,d;return n.map(m=>{let _=i(m),g=_.getFullYear(),p=_.getMonth(),b=_.getDate(),T=_.getHours(),x=_.getMinutes(),R=_.getSeconds(),w=g!=l&&a[2]||p!=c&&a[3]||b!=u&&a[4]||T!=h&&a[5]||x!=f&&a[6]||R!=d&&a[7]||a[1];return l=g,c=p,u=b,h=T,f=x,d=R,w(_)})}}function hv(i,e){let t=Qh(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Dh(i,e,t){return new Date(i,e,t)}function em(i,e){return e(i)}var fv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function tm(i,e){return(t,n,s,r)=>r==null?$h:e(i(n))}function dv(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function pv(i,e){return i.series[e].fill(i,e)}var mv={show:!0,live:!0,isolate:!1,mount:Fx,markers:{show:!0,width:2,stroke:dv,fill:pv,dash:"solid"},idx:null,idxs:null,values:[]};function gv(i,e){let t=i.cursor.points,n=wi(),s=t.size(i,e);Xt(n,ia,s),Xt(n,sa,s);let r=s/-2;Xt(n,"marginLeft",r),Xt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Xt(n,"borderWidth",o),n}function _v(i,e){let t=i.series[e].points;return t._fill||t._stroke}function yv(i,e){let t=i.series[e].points;return t._stroke||t._fill}function xv(i,e){return i.series[e].points.size}var Fh=[0,0];function vv(i,e,t){return Fh[0]=e,Fh[1]=t,Fh}function wl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Nh(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var bv={show:!0,x:!0,y:!0,lock:!1,move:vv,points:{one:!1,show:gv,size:xv,width:0,stroke:yv,fill:_v},bind:{mousedown:wl,mouseup:wl,click:wl,dblclick:wl,mousemove:Nh,mouseleave:Nh,mouseenter:Nh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Nm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},tf=fn({},Nm,{filter:bm}),Um=fn({},tf,{size:10}),Om=fn({},Nm,{show:!1}),nf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Bm="bold "+nf,km=1.5,nm={show:!0,scale:"x",stroke:qh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Bm,side:2,grid:tf,ticks:Um,border:Om,font:nf,lineGap:km,rotate:0},Sv="Value",Mv="Time",im={show:!0,scale:"x",auto:!1,sorted:1,min:Ft,max:-Ft,idxs:[]};function wv(i,e,t,n,s){return e.map(r=>r==null?"":Kh(r))}function Av(i,e,t,n,s,r,o){let a=[],l=Xs.get(s)||0;t=o?t:Nt(Il(t,s),l);for(let c=t;c<=n;c=Nt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Vh(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ws:ym,u=di(c(t));s=io(l,u),l==10&&(s=xr[Ui(s,xr)]);let h=t,f=s*l;l==10&&(f=xr[Ui(f,xr)]);do a.push(h),h=h+s,l==10&&!Xs.has(h)&&(h=Nt(h,Xs.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=xr[Ui(f,xr)]));while(h<=n);return a}function Ev(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Vh(i,e,jn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?Vh(i,e,jn(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var zm=/./,Tv=/[12357]/,Rv=/[125]/,sm=/1/,Gh=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Cv(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?zm:l(7,o)-u>=c?Tv:l(5,o)-u>=c?Rv:sm;if(h==sm){let f=yn(l(1,o)-u);if(f<c)return Gh(e.slice().reverse(),a.distr,h,Ai(c/f)).reverse()}return Gh(e,a.distr,h,1)}function Pv(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=yn(l(1,o)-l(2,o));return c<a?Gh(e.slice().reverse(),3,zm,Ai(a/c)).reverse():e}function Iv(i,e,t,n){return n==null?$h:e==null?"":Kh(e)}var rm={show:!0,scale:"y",stroke:qh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Bm,side:3,grid:tf,ticks:Um,border:Om,font:nf,lineGap:km,rotate:0};function Lv(i,e){let t=3+(i||1)*2;return Nt(t*e,3)}function Dv(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=yn(o-r),l=i.series[e],c=a/(l.points.space*Mt);return n[1]-n[0]<=c}var om={scale:null,auto:!0,sorted:0,min:Ft,max:-Ft},Vm=(i,e,t,n,s)=>s,am={show:!0,auto:!0,sorted:0,gaps:Vm,alpha:1,facets:[fn({},om,{scale:"x"}),fn({},om,{scale:"y"})]},lm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Vm,alpha:1,points:{show:Dv,filter:null},values:null,min:Ft,max:-Ft,idxs:[],path:null,clip:null};function Fv(i,e,t,n,s){return t/10}var Gm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Nv=fn({},Gm,{time:!1,ori:1}),cm={};function Hm(i,e){let t=cm[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(cm[i]=t)),t}var oo=1,Hh=2;function Mr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,m=a.width,_=a.height,g=i.valToPosH,p=i.valToPosV;return u.ori==0?t(s,l,c,u,h,g,p,f,d,m,_,Fl,lo,Ul,Xm,$m):t(s,l,c,u,h,p,g,d,f,_,m,Nl,co,of,qm,Ym)}function sf(i,e){let t=0,n=0,s=bt(i.bands,jh);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Uv(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function As(i,e,t,n,s,r){return Mr(i,e,(o,a,l,c,u,h,f,d,m,_,g)=>{let p=o.pxRound,b=c.dir*(c.ori==0?1:-1),T=c.ori==0?lo:co,x,R;b==1?(x=t,R=n):(x=n,R=t);let w=p(h(a[x],c,_,d)),y=p(f(l[x],u,g,m)),E=p(h(a[R],c,_,d)),O=p(f(r==1?u.max:u.min,u,g,m)),L=new Path2D(s);return T(L,E,O),T(L,w,O),T(L,w,y),L})}function Dl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Ul:of,l=t;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function Ov(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function rf(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(i[h]),m=f==h?d:r(i[f]),_=h-s;d=o<=0&&_>=0&&_<l?r(i[_]):d;let p=f+s;m=o>=0&&p>=0&&p<l?r(i[p]):m,m>=d&&a.push([d,m])}return a}function um(i){return i==0?vm:i==1?_n:e=>yr(e,i)}function Wm(i){let e=i==0?Fl:Nl,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=Oi(c,a/2,l/2),u=Oi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Fl=(i,e,t)=>{i.moveTo(e,t)},Nl=(i,e,t)=>{i.moveTo(t,e)},lo=(i,e,t)=>{i.lineTo(e,t)},co=(i,e,t)=>{i.lineTo(t,e)},Ul=Wm(0),of=Wm(1),Xm=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},qm=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},$m=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Ym=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Zm(i){return(e,t,n,s,r)=>Mr(e,t,(o,a,l,c,u,h,f,d,m,_,g)=>{let{pxRound:p,points:b}=o,T,x;c.ori==0?(T=Fl,x=Xm):(T=Nl,x=qm);let R=Nt(b.width*Mt,3),w=(b.size-b.width)/2*Mt,y=Nt(w*2,3),E=new Path2D,O=new Path2D,{left:L,top:I,width:k,height:V}=e.bbox;Ul(O,L-y,I-y,k+y*2,V+y*2);let D=H=>{if(l[H]!=null){let q=p(h(a[H],c,_,d)),G=p(f(l[H],u,g,m));T(E,q+w,G),x(E,q,G,w,0,Al*2)}};if(r)r.forEach(D);else for(let H=n;H<=s;H++)D(H);return{stroke:R>0?E:null,fill:E,clip:O,flags:oo|Hh}})}function Jm(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Bv=Jm(lo),kv=Jm(co);function Km(i){let e=bt(i?.alignGaps,0);return(t,n,s,r)=>Mr(t,n,(o,a,l,c,u,h,f,d,m,_,g)=>{[s,r]=Cl(l,s,r);let p=o.pxRound,b=V=>p(h(V,c,_,d)),T=V=>p(f(V,u,g,m)),x,R;c.ori==0?(x=lo,R=Bv):(x=co,R=kv);let w=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:oo},E=y.stroke,O=!1;if(r-s>=_*4){let V=ue=>t.posToVal(ue,c.key,!0),D=null,H=null,q,G,ae,$=b(a[w==1?s:r]),K=b(a[s]),ee=b(a[r]),de=V(w==1?K+1:ee-1);for(let ue=w==1?s:r;ue>=s&&ue<=r;ue+=w){let j=a[ue],se=(w==1?j<de:j>de)?$:b(j),me=l[ue];se==$?me!=null?(G=me,D==null?(x(E,se,T(G)),q=D=H=G):G<D?D=G:G>H&&(H=G)):me===null&&(O=!0):(D!=null&&R(E,$,T(D),T(H),T(q),T(G)),me!=null?(G=me,x(E,se,T(G)),D=H=q=G):(D=H=null,me===null&&(O=!0)),$=se,de=V($+w))}D!=null&&D!=H&&ae!=$&&R(E,$,T(D),T(H),T(q),T(G))}else for(let V=w==1?s:r;V>=s&&V<=r;V+=w){let D=l[V];D===null?O=!0:D!=null&&x(E,b(a[V]),T(D))}let[I,k]=sf(t,n);if(o.fill!=null||I!=0){let V=y.fill=new Path2D(E),D=o.fillTo(t,n,o.min,o.max,I),H=T(D),q=b(a[s]),G=b(a[r]);w==-1&&([G,q]=[q,G]),x(V,G,H),x(V,q,H)}if(!o.spanGaps){let V=[];O&&V.push(...rf(a,l,s,r,w,b,e)),y.gaps=V=o.gaps(t,n,s,r,V),y.clip=Dl(V,c.ori,d,m,_,g)}return k!=0&&(y.band=k==2?[As(t,n,s,r,E,-1),As(t,n,s,r,E,1)]:As(t,n,s,r,E,k)),y})}function zv(i){let e=bt(i.align,1),t=bt(i.ascDesc,!1),n=bt(i.alignGaps,0),s=bt(i.extend,!1);return(r,o,a,l)=>Mr(r,o,(c,u,h,f,d,m,_,g,p,b,T)=>{[a,l]=Cl(h,a,l);let x=c.pxRound,{left:R,width:w}=r.bbox,y=K=>x(m(K,f,b,g)),E=K=>x(_(K,d,T,p)),O=f.ori==0?lo:co,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:oo},I=L.stroke,k=f.dir*(f.ori==0?1:-1),V=E(h[k==1?a:l]),D=y(u[k==1?a:l]),H=D,q=D;s&&e==-1&&(q=R,O(I,q,V)),O(I,D,V);for(let K=k==1?a:l;K>=a&&K<=l;K+=k){let ee=h[K];if(ee==null)continue;let de=y(u[K]),ue=E(ee);e==1?O(I,de,V):O(I,H,ue),O(I,de,ue),V=ue,H=de}let G=H;s&&e==1&&(G=R+w,O(I,G,V));let[ae,$]=sf(r,o);if(c.fill!=null||ae!=0){let K=L.fill=new Path2D(I),ee=c.fillTo(r,o,c.min,c.max,ae),de=E(ee);O(K,G,de),O(K,q,de)}if(!c.spanGaps){let K=[];K.push(...rf(u,h,a,l,k,y,n));let ee=c.width*Mt/2,de=t||e==1?ee:-ee,ue=t||e==-1?-ee:ee;K.forEach(j=>{j[0]+=de,j[1]+=ue}),L.gaps=K=c.gaps(r,o,a,l,K),L.clip=Dl(K,f.ori,g,p,b,T)}return $!=0&&(L.band=$==2?[As(r,o,a,l,I,-1),As(r,o,a,l,I,1)]:As(r,o,a,l,I,$)),L})}function hm(i,e,t,n,s,r,o=Ft){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=yn(i[l]-i[a]);u<c&&(c=u,o=yn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function Vv(i){i=i||aa;let e=bt(i.size,[.6,Ft,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_t(s),o=1-e[0],a=bt(e[1],Ft),l=bt(e[2],1),c=bt(i.disp,aa),u=bt(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,m,_,g)=>Mr(d,m,(p,b,T,x,R,w,y,E,O,L,I)=>{let k=p.pxRound,V=t,D=n*Mt,H=a*Mt,q=l*Mt,G,ae;x.ori==0?[G,ae]=r(d,m):[ae,G]=r(d,m);let $=x.dir*(x.ori==0?1:-1),K=x.ori==0?Ul:of,ee=x.ori==0?u:(Ce,Ye,rt,we,Dt,Ve,qe)=>{u(Ce,Ye,rt,Dt,we,qe,Ve)},de=bt(d.bands,jh).find(Ce=>Ce.series[0]==m),ue=de!=null?de.dir:0,j=p.fillTo(d,m,p.min,p.max,ue),ye=k(y(j,R,I,O)),se,me,pe,Oe=L,Xe=k(p.width*Mt),Ge=!1,ft=null,ct=null,it=null,$t=null;h!=null&&(Xe==0||f!=null)&&(Ge=!0,ft=h.values(d,m,_,g),ct=new Map,new Set(ft).forEach(Ce=>{Ce!=null&&ct.set(Ce,new Path2D)}),Xe>0&&(it=f.values(d,m,_,g),$t=new Map,new Set(it).forEach(Ce=>{Ce!=null&&$t.set(Ce,new Path2D)})));let{x0:zt,size:on}=c;if(zt!=null&&on!=null){V=1,b=zt.values(d,m,_,g),zt.unit==2&&(b=b.map(rt=>d.posToVal(E+rt*L,x.key,!0)));let Ce=on.values(d,m,_,g);on.unit==2?me=Ce[0]*L:me=w(Ce[0],x,L,E)-w(0,x,L,E),Oe=hm(b,T,w,x,L,E,Oe),pe=Oe-me+D}else Oe=hm(b,T,w,x,L,E,Oe),pe=Oe*o+D,me=Oe-pe;pe<1&&(pe=0),Xe>=me/2&&(Xe=0),pe<5&&(k=vm);let It=pe>0,Sn=Oe-pe-(It?Xe:0);me=k(zh(Sn,q,H)),se=(V==0?me/2:V==$?0:me)-V*$*((V==0?D/2:0)+(It?Xe/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},mn=Ge?null:new Path2D,Jt=null;if(de!=null)Jt=d.data[de.series[1]];else{let{y0:Ce,y1:Ye}=c;Ce!=null&&Ye!=null&&(T=Ye.values(d,m,_,g),Jt=Ce.values(d,m,_,g))}let an=G*me,U=ae*me;for(let Ce=$==1?_:g;Ce>=_&&Ce<=g;Ce+=$){let Ye=T[Ce];if(Ye==null)continue;if(Jt!=null){let X=Jt[Ce]??0;if(Ye-X==0)continue;ye=y(X,R,I,O)}let rt=x.distr!=2||c!=null?b[Ce]:Ce,we=w(rt,x,L,E),Dt=y(bt(Ye,j),R,I,O),Ve=k(we-se),qe=k(jn(Dt,ye)),C=k(Oi(Dt,ye)),S=qe-C;if(Ye!=null){let X=Ye<0?U:an,fe=Ye<0?an:U;Ge?(Xe>0&&it[Ce]!=null&&K($t.get(it[Ce]),Ve,C+di(Xe/2),me,jn(0,S-Xe),X,fe),ft[Ce]!=null&&K(ct.get(ft[Ce]),Ve,C+di(Xe/2),me,jn(0,S-Xe),X,fe)):K(mn,Ve,C+di(Xe/2),me,jn(0,S-Xe),X,fe),ee(d,m,Ce,Ve-Xe/2,C,me+Xe,S)}}return Xe>0?xt.stroke=Ge?$t:mn:Ge||(xt._fill=p.width==0?p._fill:p._stroke??p._fill,xt.width=0),xt.fill=Ge?ct:mn,xt})}function Gv(i,e){let t=bt(e?.alignGaps,0);return(n,s,r,o)=>Mr(n,s,(a,l,c,u,h,f,d,m,_,g,p)=>{[r,o]=Cl(c,r,o);let b=a.pxRound,T=G=>b(f(G,u,g,m)),x=G=>b(d(G,h,p,_)),R,w,y;u.ori==0?(R=Fl,y=lo,w=$m):(R=Nl,y=co,w=Ym);let E=u.dir*(u.ori==0?1:-1),O=T(l[E==1?r:o]),L=O,I=[],k=[];for(let G=E==1?r:o;G>=r&&G<=o;G+=E)if(c[G]!=null){let $=l[G],K=T($);I.push(L=K),k.push(x(c[G]))}let V={stroke:i(I,k,R,y,w,b),fill:null,clip:null,band:null,gaps:null,flags:oo},D=V.stroke,[H,q]=sf(n,s);if(a.fill!=null||H!=0){let G=V.fill=new Path2D(D),ae=a.fillTo(n,s,a.min,a.max,H),$=x(ae);y(G,L,$),y(G,O,$)}if(!a.spanGaps){let G=[];G.push(...rf(l,c,r,o,E,T,t)),V.gaps=G=a.gaps(n,s,r,o,G),V.clip=Dl(G,u.ori,m,_,g,p)}return q!=0&&(V.band=q==2?[As(n,s,r,o,D,-1),As(n,s,r,o,D,1)]:As(n,s,r,o,D,q)),V})}function Hv(i){return Gv(Wv,i)}function Wv(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,e[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,i[f+1],e[f+1])}return a}var Wh=new Set;function fm(){for(let i of Wh)i.syncRect(!0)}ao&&(br(wx,no,fm),br(Ax,no,fm,!0),br(El,no,()=>{dn.pxRatio=Mt}));var Xv=Km(),qv=Zm();function dm(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Xh(r,o,e,t))}function $v(i,e){return i.map((t,n)=>n==0?{}:fn({},e,t))}function Xh(i,e,t,n){return fn({},e==0?t:n,i)}function jm(i,e,t){return e==null?so:[e,t]}var Yv=jm;function Zv(i,e,t){return e==null?so:Tl(e,t,Jh,!0)}function Qm(i,e,t,n){return e==null?so:Pl(e,t,i.scales[n].log,!1)}var Jv=Qm;function eg(i,e,t,n){return e==null?so:Zh(e,t,i.scales[n].log,!1)}var Kv=eg;function jv(i,e,t,n,s){let r=jn(Xp(i),Xp(e)),o=e-i,a=Ui(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Xs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function pm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=_n((t=+s)*Mt))+"px"),[i,e,t]}function Qv(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Nt(e[2]*Mt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function dn(i,e,t){let n={mode:bt(i.mode,1)},s=n.mode;function r(v,M,P,F){let W=M.valToPct(v);return F+P*(M.dir==-1?1-W:W)}function o(v,M,P,F){let W=M.valToPct(v);return F+P*(M.dir==-1?W:1-W)}function a(v,M,P,F){return M.ori==0?r(v,M,P,F):o(v,M,P,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=wi(ox);if(i.id!=null&&(c.id=i.id),fi(c,i.class),i.title){let v=wi(cx,c);v.textContent=i.title}let u=Ni("canvas"),h=n.ctx=u.getContext("2d"),f=wi(ux,c);br("click",f,v=>{v.target===m&&(Gt!=Yr||Yt!=Zr)&&Dn.click(n,v)},!0);let d=n.under=wi(hx,f);f.appendChild(u);let m=n.over=wi(fx,f);i=ro(i);let _=+bt(i.pxAlign,1),g=um(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let p=i.ms||.001,b=n.series=s==1?dm(i.series||[],im,lm,!1):$v(i.series||[null],am),T=n.axes=dm(i.axes||[],nm,rm,!0),x=n.scales={},R=n.bands=i.bands||[];R.forEach(v=>{v.fill=_t(v.fill||null),v.dir=bt(v.dir,-1)});let w=s==2?b[1].facets[0].scale:b[0].scale,y={axes:bs,series:pt},E=(i.drawOrder||["axes","series"]).map(v=>y[v]);function O(v){let M=v.distr==3?P=>ws(P>0?P:v.clamp(n,P,v.min,v.max,v.key)):v.distr==4?P=>Lh(P,v.asinh):v.distr==100?P=>v.fwd(P):P=>P;return P=>{let F=M(P),{_min:W,_max:J}=v,le=J-W;return(F-W)/le}}function L(v){let M=x[v];if(M==null){let P=(i.scales||aa)[v]||aa;if(P.from!=null){L(P.from);let F=fn({},x[P.from],P,{key:v});F.valToPct=O(F),x[v]=F}else{M=x[v]=fn({},v==w?Gm:Nv,P),M.key=v;let F=M.time,W=M.range,J=Ws(W);if((v!=w||s==2&&!F)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Gp:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Gp:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&Ll(W))){let le=W;W=(ge,Se,De)=>Se==null?so:Tl(Se,De,le)}M.range=_t(W||(F?Yv:v==w?M.distr==3?Jv:M.distr==4?Kv:jm:M.distr==3?Qm:M.distr==4?eg:Zv)),M.auto=_t(J?!1:M.auto),M.clamp=_t(M.clamp||Fv),M._min=M._max=null,M.valToPct=O(M)}}}L("x"),L("y"),s==1&&b.forEach(v=>{L(v.scale)}),T.forEach(v=>{L(v.scale)});for(let v in i.scales)L(v);let I=x[w],k=I.distr,V,D;I.ori==0?(fi(c,ax),V=r,D=o):(fi(c,lx),V=o,D=r);let H={};for(let v in x){let M=x[v];(M.min!=null||M.max!=null)&&(H[v]={min:M.min,max:M.max},M.min=M.max=null)}let q=i.tzDate||(v=>new Date(_n(v/p))),G=i.fmtDate||Qh,ae=p==1?av(q):uv(q),$=Qp(q,jp(p==1?ov:cv,G)),K=tm(q,em(fv,G)),ee=[],de=n.legend=fn({},mv,i.legend),ue=n.cursor=fn({},bv,{drag:{y:s==2}},i.cursor),j=de.show,ye=ue.show,se=de.markers;de.idxs=ee,se.width=_t(se.width),se.dash=_t(se.dash),se.stroke=_t(se.stroke),se.fill=_t(se.fill);let me,pe,Oe,Xe=[],Ge=[],ft,ct=!1,it={};if(de.live){let v=b[1]?b[1].values:null;ct=v!=null,ft=ct?v(n,1,0):{_:0};for(let M in ft)it[M]=$h}if(j)if(me=Ni("table",yx,c),Oe=Ni("tbody",null,me),de.mount(n,me),ct){pe=Ni("thead",null,me,Oe);let v=Ni("tr",null,pe);Ni("th",null,v);for(var $t in ft)Ni("th",Cp,v).textContent=$t}else fi(me,vx),de.live&&fi(me,xx);let zt={show:!0},on={show:!1};function It(v,M){if(M==0&&(ct||!de.live||s==2))return so;let P=[],F=Ni("tr",bx,Oe,Oe.childNodes[M]);fi(F,v.class),v.show||fi(F,vr);let W=Ni("th",null,F);if(se.show){let ge=wi(Sx,W);if(M>0){let Se=se.width(n,M);Se&&(ge.style.border=Se+"px "+se.dash(n,M)+" "+se.stroke(n,M)),ge.style.background=se.fill(n,M)}}let J=wi(Cp,W);v.label instanceof HTMLElement?J.appendChild(v.label):J.textContent=v.label,M>0&&(se.show||(J.style.color=v.width>0?se.stroke(n,M):se.fill(n,M)),xt("click",W,ge=>{if(ue._lock)return;je(ge);let Se=b.indexOf(v);if((ge.ctrlKey||ge.metaKey)!=de.isolate){let De=b.some((Fe,Ue)=>Ue>0&&Ue!=Se&&Fe.show);b.forEach((Fe,Ue)=>{Ue>0&&ts(Ue,De?Ue==Se?zt:on:zt,!0,hn.setSeries)})}else ts(Se,{show:!v.show},!0,hn.setSeries)},!1),Qe&&xt(Dp,W,ge=>{ue._lock||(je(ge),ts(b.indexOf(v),Kr,!0,hn.setSeries))},!1));for(var le in ft){let ge=Ni("td",Mx,F);ge.textContent="--",P.push(ge)}return[F,P]}let Sn=new Map;function xt(v,M,P,F=!0){let W=Sn.get(M)||{},J=ue.bind[v](n,M,P,F);J&&(br(v,M,W[v]=J),Sn.set(M,W))}function mn(v,M,P){let F=Sn.get(M)||{};for(let W in F)(v==null||W==v)&&(kh(W,M,F[W]),delete F[W]);v==null&&Sn.delete(M)}let Jt=0,an=0,U=0,Ce=0,Ye=0,rt=0,we=Ye,Dt=rt,Ve=U,qe=Ce,C=0,S=0,X=0,fe=0;n.bbox={};let oe=!1,ve=!1,be=!1,te=!1,ie=!1,_e=!1;function N(v,M,P){(P||v!=n.width||M!=n.height)&&re(v,M),ut(!1),be=!0,ve=!0,Vn()}function re(v,M){n.width=Jt=U=v,n.height=an=Ce=M,Ye=rt=0,Me(),He();let P=n.bbox;C=P.left=yr(Ye*Mt,.5),S=P.top=yr(rt*Mt,.5),X=P.width=yr(U*Mt,.5),fe=P.height=yr(Ce*Mt,.5)}let ne=3;function Ae(){let v=!1,M=0;for(;!v;){M++;let P=Xr(M),F=es(M);v=M==ne||P&&F,v||(re(n.width,n.height),ve=!0)}}function xe({width:v,height:M}){N(v,M)}n.setSize=xe;function Me(){let v=!1,M=!1,P=!1,F=!1;T.forEach((W,J)=>{if(W.show&&W._show){let{side:le,_size:ge}=W,Se=le%2,De=W.label!=null?W.labelSize:0,Fe=ge+De;Fe>0&&(Se?(U-=Fe,le==3?(Ye+=Fe,F=!0):P=!0):(Ce-=Fe,le==0?(rt+=Fe,v=!0):M=!0))}}),ji[0]=v,ji[1]=P,ji[2]=M,ji[3]=F,U-=Li[1]+Li[3],Ye+=Li[3],Ce-=Li[2]+Li[0],rt+=Li[0]}function He(){let v=Ye+U,M=rt+Ce,P=Ye,F=rt;function W(J,le){switch(J){case 1:return v+=le,v-le;case 2:return M+=le,M-le;case 3:return P-=le,P+le;case 0:return F-=le,F+le}}T.forEach((J,le)=>{if(J.show&&J._show){let ge=J.side;J._pos=W(ge,J._size),J.label!=null&&(J._lpos=W(ge,J.labelSize))}})}if(ue.dataIdx==null){let v=ue.hover,M=v.skip=new Set(v.skip??[]);M.add(void 0);let P=v.prox=_t(v.prox),F=v.bias??=0;ue.dataIdx=(W,J,le,ge)=>{if(J==0)return le;let Se=le,De=P(W,J,le,ge)??Ft,Fe=De>=0&&De<Ft,Ue=I.ori==0?U:Ce,st=ue.left,St=e[0],vt=e[J];if(M.has(vt[le])){Se=null;let mt=null,Ke=null,We;if(F==0||F==-1)for(We=le;mt==null&&We-- >0;)M.has(vt[We])||(mt=We);if(F==0||F==1)for(We=le;Ke==null&&We++<vt.length;)M.has(vt[We])||(Ke=We);if(mt!=null||Ke!=null)if(Fe){let Wt=mt==null?-1/0:V(St[mt],I,Ue,0),Qt=Ke==null?1/0:V(St[Ke],I,Ue,0),En=st-Wt,Lt=Qt-st;En<=Lt?En<=De&&(Se=mt):Lt<=De&&(Se=Ke)}else Se=Ke==null?mt:mt==null?Ke:le-mt<=Ke-le?mt:Ke}else Fe&&yn(st-V(St[le],I,Ue,0))>De&&(Se=null);return Se}}let je=v=>{ue.event=v};ue.idxs=ee,ue._lock=!1;let he=ue.points;he.show=_t(he.show),he.size=_t(he.size),he.stroke=_t(he.stroke),he.width=_t(he.width),he.fill=_t(he.fill);let Be=n.focus=fn({},i.focus||{alpha:.3},ue.focus),Qe=Be.prox>=0,Re=Qe&&he.one,lt=[],Vt=[],qn=[];function $o(v,M){let P=he.show(n,M);if(P instanceof HTMLElement)return fi(P,_x),fi(P,v.class),os(P,-10,-10,U,Ce),m.insertBefore(P,lt[M]),P}function Gr(v,M){if(s==1||M>0){let P=s==1&&x[v.scale].time,F=v.value;v.value=P?Yp(F)?tm(q,em(F,G)):F||K:F||Iv,v.label=v.label||(P?Mv:Sv)}if(Re||M>0){v.width=v.width==null?1:v.width,v.paths=v.paths||Xv||Nx,v.fillTo=_t(v.fillTo||Uv),v.pxAlign=+bt(v.pxAlign,_),v.pxRound=um(v.pxAlign),v.stroke=_t(v.stroke||null),v.fill=_t(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let P=Lv(jn(1,v.width),1),F=v.points=fn({},{size:P,width:jn(1,P*.2),stroke:v.stroke,space:P*2,paths:qv,_stroke:null,_fill:null},v.points);F.show=_t(F.show),F.filter=_t(F.filter),F.fill=_t(F.fill),F.stroke=_t(F.stroke),F.paths=_t(F.paths),F.pxAlign=v.pxAlign}if(j){let P=It(v,M);Xe.splice(M,0,P[0]),Ge.splice(M,0,P[1]),de.values.push(null)}if(ye){ee.splice(M,0,null);let P=null;Re?M==0&&(P=$o(v,M)):M>0&&(P=$o(v,M)),lt.splice(M,0,P),Vt.splice(M,0,0),qn.splice(M,0,0)}An("addSeries",M)}function gh(v,M){M=M??b.length,v=s==1?Xh(v,M,im,lm):Xh(v,M,{},am),b.splice(M,0,v),Gr(b[M],M)}n.addSeries=gh;function ml(v){if(b.splice(v,1),j){de.values.splice(v,1),Ge.splice(v,1);let M=Xe.splice(v,1)[0];mn(null,M.firstChild),M.remove()}ye&&(ee.splice(v,1),lt.splice(v,1)[0].remove(),Vt.splice(v,1),qn.splice(v,1)),An("delSeries",v)}n.delSeries=ml;let ji=[!1,!1,!1,!1];function ys(v,M){if(v._show=v.show,v.show){let P=v.side%2,F=x[v.scale];F==null&&(v.scale=P?b[1].scale:w,F=x[v.scale]);let W=F.time;v.size=_t(v.size),v.space=_t(v.space),v.rotate=_t(v.rotate),Ws(v.incrs)&&v.incrs.forEach(le=>{!Xs.has(le)&&Xs.set(le,Mm(le))}),v.incrs=_t(v.incrs||(F.distr==2?iv:W?p==1?rv:lv:xr)),v.splits=_t(v.splits||(W&&F.distr==1?ae:F.distr==3?Vh:F.distr==4?Ev:Av)),v.stroke=_t(v.stroke),v.grid.stroke=_t(v.grid.stroke),v.ticks.stroke=_t(v.ticks.stroke),v.border.stroke=_t(v.border.stroke);let J=v.values;v.values=Ws(J)&&!Ws(J[0])?_t(J):W?Ws(J)?Qp(q,jp(J,G)):Yp(J)?hv(q,J):J||$:J||wv,v.filter=_t(v.filter||(F.distr>=3&&F.log==10?Cv:F.distr==3&&F.log==2?Pv:bm)),v.font=pm(v.font),v.labelFont=pm(v.labelFont),v._size=v.size(n,null,M,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(ji[M]=!0,v._el=wi(dx,f))}}function xs(v,M,P,F){let[W,J,le,ge]=P,Se=M%2,De=0;return Se==0&&(ge||J)&&(De=M==0&&!W||M==2&&!le?_n(nm.size/3):0),Se==1&&(W||le)&&(De=M==1&&!J||M==3&&!ge?_n(rm.size/2):0),De}let Yo=n.padding=(i.padding||[xs,xs,xs,xs]).map(v=>_t(bt(v,xs))),Li=n._padding=Yo.map((v,M)=>v(n,M,ji,0)),Kt,sn=null,rn=null,Qi=s==1?b[0].idxs:null,li=null,Os=!1;function Zo(v,M){if(e=v??[],n.data=n._data=e,s==2){Kt=0;for(let P=1;P<b.length;P++)Kt+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),li=e[0],Kt=li.length;let P=e;if(k==2){P=e.slice();let F=P[0]=Array(Kt);for(let W=0;W<Kt;W++)F[W]=W}n._data=e=P}if(ut(!0),An("setData"),k==2&&(be=!0),M!==!1){let P=I;P.auto(n,Os)?Jo():zs(w,P.min,P.max),te=te||ue.left>=0,_e=!0,Vn()}}n.setData=Zo;function Jo(){Os=!0;let v,M;s==1&&(Kt>0?(sn=Qi[0]=0,rn=Qi[1]=Kt-1,v=e[0][sn],M=e[0][rn],k==2?(v=sn,M=rn):v==M&&(k==3?[v,M]=Pl(v,v,I.log,!1):k==4?[v,M]=Zh(v,v,I.log,!1):I.time?M=v+_n(86400/p):[v,M]=Tl(v,M,Jh,!0))):(sn=Qi[0]=v=null,rn=Qi[1]=M=null)),zs(w,v,M)}let Hr,Bs,Wr,A,z,Q,Y,Z,Ee,Ie;function Te(v,M,P,F,W,J){v??=Ip,P??=jh,F??="butt",W??=Ip,J??="round",v!=Hr&&(h.strokeStyle=Hr=v),W!=Bs&&(h.fillStyle=Bs=W),M!=Wr&&(h.lineWidth=Wr=M),J!=z&&(h.lineJoin=z=J),F!=Q&&(h.lineCap=Q=F),P!=A&&h.setLineDash(A=P)}function Le(v,M,P,F){M!=Bs&&(h.fillStyle=Bs=M),v!=Y&&(h.font=Y=v),P!=Z&&(h.textAlign=Z=P),F!=Ee&&(h.textBaseline=Ee=F)}function ze(v,M,P,F,W=0){if(F.length>0&&v.auto(n,Os)&&(M==null||M.min==null)){let J=bt(sn,0),le=bt(rn,F.length-1),ge=P.min==null?Cx(F,J,le,W,v.distr==3):[P.min,P.max];v.min=Oi(v.min,P.min=ge[0]),v.max=jn(v.max,P.max=ge[1])}}let et={min:null,max:null};function dt(){for(let F in x){let W=x[F];H[F]==null&&(W.min==null||H[w]!=null&&W.auto(n,Os))&&(H[F]=et)}for(let F in x){let W=x[F];H[F]==null&&W.from!=null&&H[W.from]!=null&&(H[F]=et)}H[w]!=null&&ut(!0);let v={};for(let F in H){let W=H[F];if(W!=null){let J=v[F]=ro(x[F],Bx);if(W.min!=null)fn(J,W);else if(F!=w||s==2)if(Kt==0&&J.from==null){let le=J.range(n,null,null,F);J.min=le[0],J.max=le[1]}else J.min=Ft,J.max=-Ft}}if(Kt>0){b.forEach((F,W)=>{if(s==1){let J=F.scale,le=H[J];if(le==null)return;let ge=v[J];if(W==0){let Se=ge.range(n,ge.min,ge.max,J);ge.min=Se[0],ge.max=Se[1],sn=Ui(ge.min,e[0]),rn=Ui(ge.max,e[0]),rn-sn>1&&(e[0][sn]<ge.min&&sn++,e[0][rn]>ge.max&&rn--),F.min=li[sn],F.max=li[rn]}else F.show&&F.auto&&ze(ge,le,F,e[W],F.sorted);F.idxs[0]=sn,F.idxs[1]=rn}else if(W>0&&F.show&&F.auto){let[J,le]=F.facets,ge=J.scale,Se=le.scale,[De,Fe]=e[W],Ue=v[ge],st=v[Se];Ue!=null&&ze(Ue,H[ge],J,De,J.sorted),st!=null&&ze(st,H[Se],le,Fe,le.sorted),F.min=le.min,F.max=le.max}});for(let F in v){let W=v[F],J=H[F];if(W.from==null&&(J==null||J.min==null)){let le=W.range(n,W.min==Ft?null:W.min,W.max==-Ft?null:W.max,F);W.min=le[0],W.max=le[1]}}}for(let F in v){let W=v[F];if(W.from!=null){let J=v[W.from];if(J.min==null)W.min=W.max=null;else{let le=W.range(n,J.min,J.max,F);W.min=le[0],W.max=le[1]}}}let M={},P=!1;for(let F in v){let W=v[F],J=x[F];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let le=J.distr;J._min=le==3?ws(J.min):le==4?Lh(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?ws(J.max):le==4?Lh(J.max,J.asinh):le==100?J.fwd(J.max):J.max,M[F]=P=!0}}if(P){b.forEach((F,W)=>{s==2?W>0&&M.y&&(F._paths=null):M[F.scale]&&(F._paths=null)});for(let F in M)be=!0,An("setScale",F);ye&&ue.left>=0&&(te=_e=!0)}for(let F in H)H[F]=null}function ke(v){let M=zh(sn-1,0,Kt-1),P=zh(rn+1,0,Kt-1);for(;v[M]==null&&M>0;)M--;for(;v[P]==null&&P<Kt-1;)P++;return[M,P]}function pt(){if(Kt>0){let v=b.some(M=>M._focus)&&Ie!=Be.alpha;v&&(h.globalAlpha=Ie=Be.alpha),b.forEach((M,P)=>{if(P>0&&M.show&&(Zt(P,!1),Zt(P,!0),M._paths==null)){let F=Ie;Ie!=M.alpha&&(h.globalAlpha=Ie=M.alpha);let W=s==2?[0,e[P][0].length-1]:ke(e[P]);M._paths=M.paths(n,P,W[0],W[1]),Ie!=F&&(h.globalAlpha=Ie=F)}}),b.forEach((M,P)=>{if(P>0&&M.show){let F=Ie;Ie!=M.alpha&&(h.globalAlpha=Ie=M.alpha),M._paths!=null&&Rt(P,!1);{let W=M._paths!=null?M._paths.gaps:null,J=M.points.show(n,P,sn,rn,W),le=M.points.filter(n,P,J,W);(J||le)&&(M.points._paths=M.points.paths(n,P,sn,rn,le),Rt(P,!0))}Ie!=F&&(h.globalAlpha=Ie=F),An("drawSeries",P)}}),v&&(h.globalAlpha=Ie=1)}}function Zt(v,M){let P=M?b[v].points:b[v];P._stroke=P.stroke(n,v),P._fill=P.fill(n,v)}function Rt(v,M){let P=M?b[v].points:b[v],{stroke:F,fill:W,clip:J,flags:le,_stroke:ge=P._stroke,_fill:Se=P._fill,_width:De=P.width}=P._paths;De=Nt(De*Mt,3);let Fe=null,Ue=De%2/2;M&&Se==null&&(Se=De>0?"#fff":ge);let st=P.pxAlign==1&&Ue>0;if(st&&h.translate(Ue,Ue),!M){let St=C-De/2,vt=S-De/2,mt=X+De,Ke=fe+De;Fe=new Path2D,Fe.rect(St,vt,mt,Ke)}M?Ne(ge,De,P.dash,P.cap,Se,F,W,le,J):Ct(v,ge,De,P.dash,P.cap,Se,F,W,le,Fe,J),st&&h.translate(-Ue,-Ue)}function Ct(v,M,P,F,W,J,le,ge,Se,De,Fe){let Ue=!1;Se!=0&&R.forEach((st,St)=>{if(st.series[0]==v){let vt=b[st.series[1]],mt=e[st.series[1]],Ke=(vt._paths||aa).band;Ws(Ke)&&(Ke=st.dir==1?Ke[0]:Ke[1]);let We,Wt=null;vt.show&&Ke&&Ix(mt,sn,rn)?(Wt=st.fill(n,St)||J,We=vt._paths.clip):Ke=null,Ne(M,P,F,W,Wt,le,ge,Se,De,Fe,We,Ke),Ue=!0}}),Ue||Ne(M,P,F,W,J,le,ge,Se,De,Fe)}let gn=oo|Hh;function Ne(v,M,P,F,W,J,le,ge,Se,De,Fe,Ue){Te(v,M,P,F,W),(Se||De||Ue)&&(h.save(),Se&&h.clip(Se),De&&h.clip(De)),Ue?(ge&gn)==gn?(h.clip(Ue),Fe&&h.clip(Fe),gt(W,le),ln(v,J,M)):ge&Hh?(gt(W,le),h.clip(Ue),ln(v,J,M)):ge&oo&&(h.save(),h.clip(Ue),Fe&&h.clip(Fe),gt(W,le),h.restore(),ln(v,J,M)):(gt(W,le),ln(v,J,M)),(Se||De||Ue)&&h.restore()}function ln(v,M,P){P>0&&(M instanceof Map?M.forEach((F,W)=>{h.strokeStyle=Hr=W,h.stroke(F)}):M!=null&&v&&h.stroke(M))}function gt(v,M){M instanceof Map?M.forEach((P,F)=>{h.fillStyle=Bs=F,h.fill(P)}):M!=null&&v&&h.fill(M)}function vs(v,M,P,F){let W=T[v],J;if(F<=0)J=[0,0];else{let le=W._space=W.space(n,v,M,P,F),ge=W._incrs=W.incrs(n,v,M,P,F,le);J=jv(M,P,ge,F,le)}return W._found=J}function cn(v,M,P,F,W,J,le,ge,Se,De){let Fe=le%2/2;_==1&&h.translate(Fe,Fe),Te(ge,le,Se,De,ge),h.beginPath();let Ue,st,St,vt,mt=W+(F==0||F==3?-J:J);P==0?(st=W,vt=mt):(Ue=W,St=mt);for(let Ke=0;Ke<v.length;Ke++)M[Ke]!=null&&(P==0?Ue=St=v[Ke]:st=vt=v[Ke],h.moveTo(Ue,st),h.lineTo(St,vt));h.stroke(),_==1&&h.translate(-Fe,-Fe)}function Xr(v){let M=!0;return T.forEach((P,F)=>{if(!P.show)return;let W=x[P.scale];if(W.min==null){P._show&&(M=!1,P._show=!1,ut(!1));return}else P._show||(M=!1,P._show=!0,ut(!1));let J=P.side,le=J%2,{min:ge,max:Se}=W,[De,Fe]=vs(F,ge,Se,le==0?U:Ce);if(Fe==0)return;let Ue=W.distr==2,st=P._splits=P.splits(n,F,ge,Se,De,Fe,Ue),St=W.distr==2?st.map(We=>li[We]):st,vt=W.distr==2?li[st[1]]-li[st[0]]:De,mt=P._values=P.values(n,P.filter(n,St,F,Fe,vt),F,Fe,vt);P._rotate=J==2?P.rotate(n,mt,F,Fe):0;let Ke=P._size;P._size=Ai(P.size(n,mt,F,v)),Ke!=null&&P._size!=Ke&&(M=!1)}),M}function es(v){let M=!0;return Yo.forEach((P,F)=>{let W=P(n,F,ji,v);W!=Li[F]&&(M=!1),Li[F]=W}),M}function bs(){for(let v=0;v<T.length;v++){let M=T[v];if(!M.show||!M._show)continue;let P=M.side,F=P%2,W,J,le=M.stroke(n,v),ge=P==0||P==3?-1:1,[Se,De]=M._found;if(M.label!=null){let Zn=M.labelGap*ge,hi=_n((M._lpos+Zn)*Mt);Le(M.labelFont[0],le,"center",P==2?"top":Pp),h.save(),F==1?(W=J=0,h.translate(hi,_n(S+fe/2)),h.rotate((P==3?-Al:Al)/2)):(W=_n(C+X/2),J=hi);let _r=xm(M.label)?M.label(n,v,Se,De):M.label;h.fillText(_r,W,J),h.restore()}if(De==0)continue;let Fe=x[M.scale],Ue=F==0?X:fe,st=F==0?C:S,St=M._splits,vt=Fe.distr==2?St.map(Zn=>li[Zn]):St,mt=Fe.distr==2?li[St[1]]-li[St[0]]:Se,Ke=M.ticks,We=M.border,Wt=Ke.show?Ke.size:0,Qt=_n(Wt*Mt),En=_n((M.alignTo==2?M._size-Wt-M.gap:M.gap)*Mt),Lt=M._rotate*-Al/180,en=g(M._pos*Mt),ci=(Qt+En)*ge,Yn=en+ci;J=F==0?Yn:0,W=F==1?Yn:0;let Si=M.font[0],Di=M.align==1?eo:M.align==2?Ch:Lt>0?eo:Lt<0?Ch:F==0?"center":P==3?Ch:eo,is=Lt||F==1?"middle":P==2?"top":Pp;Le(Si,le,Di,is);let ui=M.font[1]*M.lineGap,Mi=St.map(Zn=>g(a(Zn,Fe,Ue,st))),Fi=M._values;for(let Zn=0;Zn<Fi.length;Zn++){let hi=Fi[Zn];if(hi!=null){F==0?W=Mi[Zn]:J=Mi[Zn],hi=""+hi;let _r=hi.indexOf(`
`)==-1?[hi]:hi.split(/\n/gm);for(let Jn=0;Jn<_r.length;Jn++){let fp=_r[Jn];Lt?(h.save(),h.translate(W,J+Jn*ui),h.rotate(Lt),h.fillText(fp,0,0),h.restore()):h.fillText(fp,W,J+Jn*ui)}}}Ke.show&&cn(Mi,Ke.filter(n,vt,v,De,mt),F,P,en,Qt,Nt(Ke.width*Mt,3),Ke.stroke(n,v),Ke.dash,Ke.cap);let ss=M.grid;ss.show&&cn(Mi,ss.filter(n,vt,v,De,mt),F,F==0?2:1,F==0?S:C,F==0?fe:X,Nt(ss.width*Mt,3),ss.stroke(n,v),ss.dash,ss.cap),We.show&&cn([en],[1],F==0?1:0,F==0?1:2,F==1?S:C,F==1?fe:X,Nt(We.width*Mt,3),We.stroke(n,v),We.dash,We.cap)}An("drawAxes")}function ut(v){b.forEach((M,P)=>{P>0&&(M._paths=null,v&&(s==1?(M.min=null,M.max=null):M.facets.forEach(F=>{F.min=null,F.max=null})))})}let jt=!1,$n=!1,Pt=[];function un(){$n=!1;for(let v=0;v<Pt.length;v++)An(...Pt[v]);Pt.length=0}function Vn(){jt||(Xx(Yd),jt=!0)}function gl(v,M=!1){jt=!0,$n=M,v(n),Yd(),M&&Pt.length>0&&queueMicrotask(un)}n.batch=gl;function Yd(){if(oe&&(dt(),oe=!1),be&&(Ae(),be=!1),ve){if(Xt(d,eo,Ye),Xt(d,"top",rt),Xt(d,ia,U),Xt(d,sa,Ce),Xt(m,eo,Ye),Xt(m,"top",rt),Xt(m,ia,U),Xt(m,sa,Ce),Xt(f,ia,Jt),Xt(f,sa,an),u.width=_n(Jt*Mt),u.height=_n(an*Mt),T.forEach(({_el:v,_show:M,_size:P,_pos:F,side:W})=>{if(v!=null)if(M){let J=W===3||W===0?P:0,le=W%2==1;Xt(v,le?"left":"top",F-J),Xt(v,le?"width":"height",P),Xt(v,le?"top":"left",le?rt:Ye),Xt(v,le?"height":"width",le?Ce:U),Bh(v,vr)}else fi(v,vr)}),Hr=Bs=Wr=z=Q=Y=Z=Ee=A=null,Ie=1,Qo(!0),Ye!=we||rt!=Dt||U!=Ve||Ce!=qe){ut(!1);let v=U/Ve,M=Ce/qe;if(ye&&!te&&ue.left>=0){ue.left*=v,ue.top*=M,qr&&os(qr,_n(ue.left),0,U,Ce),$r&&os($r,0,_n(ue.top),U,Ce);for(let P=0;P<lt.length;P++){let F=lt[P];F!=null&&(Vt[P]*=v,qn[P]*=M,os(F,Ai(Vt[P]),Ai(qn[P]),U,Ce))}}if(Ht.show&&!ie&&Ht.left>=0&&Ht.width>0){Ht.left*=v,Ht.width*=v,Ht.top*=M,Ht.height*=M;for(let P in Sh)Xt(Jr,P,Ht[P])}we=Ye,Dt=rt,Ve=U,qe=Ce}An("setSize"),ve=!1}Jt>0&&an>0&&(h.clearRect(0,0,u.width,u.height),An("drawClear"),E.forEach(v=>v()),An("draw")),Ht.show&&ie&&(_l(Ht),ie=!1),ye&&te&&(gr(null,!0,!1),te=!1),de.show&&de.live&&_e&&(vh(),_e=!1),l||(l=!0,n.status=1,An("ready")),Os=!1,jt=!1}n.redraw=(v,M)=>{be=M||!1,v!==!1?zs(w,I.min,I.max):Vn()};function _h(v,M){let P=x[v];if(P.from==null){if(Kt==0){let F=P.range(n,M.min,M.max,v);M.min=F[0],M.max=F[1]}if(M.min>M.max){let F=M.min;M.min=M.max,M.max=F}if(Kt>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;v==w&&P.distr==2&&Kt>0&&(M.min=Ui(M.min,e[0]),M.max=Ui(M.max,e[0]),M.min==M.max&&M.max++),H[v]=M,oe=!0,Vn()}}n.setScale=_h;let yh,xh,qr,$r,Zd,Jd,Yr,Zr,Kd,jd,Gt,Yt,ks=!1,Dn=ue.drag,Mn=Dn.x,wn=Dn.y;ye&&(ue.x&&(yh=wi(mx,m)),ue.y&&(xh=wi(gx,m)),I.ori==0?(qr=yh,$r=xh):(qr=xh,$r=yh),Gt=ue.left,Yt=ue.top);let Ht=n.select=fn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Jr=Ht.show?wi(px,Ht.over?m:d):null;function _l(v,M){if(Ht.show){for(let P in v)Ht[P]=v[P],P in Sh&&Xt(Jr,P,v[P]);M!==!1&&An("setSelect")}}n.setSelect=_l;function Ty(v){if(b[v].show)j&&Bh(Xe[v],vr);else if(j&&fi(Xe[v],vr),ye){let P=Re?lt[0]:lt[v];P!=null&&os(P,-10,-10,U,Ce)}}function zs(v,M,P){_h(v,{min:M,max:P})}function ts(v,M,P,F){M.focus!=null&&Ly(v),M.show!=null&&b.forEach((W,J)=>{J>0&&(v==J||v==null)&&(W.show=M.show,Ty(J),s==2?(zs(W.facets[0].scale,null,null),zs(W.facets[1].scale,null,null)):zs(W.scale,null,null),Vn())}),P!==!1&&An("setSeries",v,M),F&&ea("setSeries",n,v,M)}n.setSeries=ts;function Ry(v,M){fn(R[v],M)}function Cy(v,M){v.fill=_t(v.fill||null),v.dir=bt(v.dir,-1),M=M??R.length,R.splice(M,0,v)}function Py(v){v==null?R.length=0:R.splice(v,1)}n.addBand=Cy,n.setBand=Ry,n.delBand=Py;function Iy(v,M){b[v].alpha=M,ye&&lt[v]!=null&&(lt[v].style.opacity=M),j&&Xe[v]&&(Xe[v].style.opacity=M)}let Ss,Vs,mr,Kr={focus:!0};function Ly(v){if(v!=mr){let M=v==null,P=Be.alpha!=1;b.forEach((F,W)=>{if(s==1||W>0){let J=M||W==0||W==v;F._focus=M?null:J,P&&Iy(W,J?1:Be.alpha)}}),mr=v,P&&Vn()}}j&&Qe&&xt(Fp,me,v=>{ue._lock||(je(v),mr!=null&&ts(null,Kr,!0,hn.setSeries))});function ns(v,M,P){let F=x[M];P&&(v=v/Mt-(F.ori==1?rt:Ye));let W=U;F.ori==1&&(W=Ce,v=W-v),F.dir==-1&&(v=W-v);let J=F._min,le=F._max,ge=v/W,Se=J+(le-J)*ge,De=F.distr;return De==3?io(10,Se):De==4?Dx(Se,F.asinh):De==100?F.bwd(Se):Se}function Dy(v,M){let P=ns(v,w,M);return Ui(P,e[0],sn,rn)}n.valToIdx=v=>Ui(v,e[0]),n.posToIdx=Dy,n.posToVal=ns,n.valToPos=(v,M,P)=>x[M].ori==0?r(v,x[M],P?X:U,P?C:0):o(v,x[M],P?fe:Ce,P?S:0),n.setCursor=(v,M,P)=>{Gt=v.left,Yt=v.top,gr(null,M,P)};function Qd(v,M){Xt(Jr,eo,Ht.left=v),Xt(Jr,ia,Ht.width=M)}function ep(v,M){Xt(Jr,"top",Ht.top=v),Xt(Jr,sa,Ht.height=M)}let Ko=I.ori==0?Qd:ep,jo=I.ori==1?Qd:ep;function Fy(){if(j&&de.live)for(let v=s==2?1:0;v<b.length;v++){if(v==0&&ct)continue;let M=de.values[v],P=0;for(let F in M)Ge[v][P++].firstChild.nodeValue=M[F]}}function vh(v,M){if(v!=null&&(v.idxs?v.idxs.forEach((P,F)=>{ee[F]=P}):Ox(v.idx)||ee.fill(v.idx),de.idx=ee[0]),j&&de.live){for(let P=0;P<b.length;P++)(P>0||s==1&&!ct)&&Ny(P,ee[P]);Fy()}_e=!1,M!==!1&&An("setLegend")}n.setLegend=vh;function Ny(v,M){let P=b[v],F=v==0&&k==2?li:e[v],W;ct?W=P.values(n,v,M)??it:(W=P.value(n,M==null?null:F[M],v,M),W=W==null?it:{_:W}),de.values[v]=W}function gr(v,M,P){Kd=Gt,jd=Yt,[Gt,Yt]=ue.move(n,Gt,Yt),ue.left=Gt,ue.top=Yt,ye&&(qr&&os(qr,_n(Gt),0,U,Ce),$r&&os($r,0,_n(Yt),U,Ce));let F,W=sn>rn;Ss=Ft,Vs=null;let J=I.ori==0?U:Ce,le=I.ori==1?U:Ce;if(Gt<0||Kt==0||W){F=ue.idx=null;for(let ge=0;ge<b.length;ge++){let Se=lt[ge];Se!=null&&os(Se,-10,-10,U,Ce)}Qe&&ts(null,Kr,!0,v==null&&hn.setSeries),de.live&&(ee.fill(F),_e=!0)}else{let ge,Se,De;s==1&&(ge=I.ori==0?Gt:Yt,Se=ns(ge,w),F=ue.idx=Ui(Se,e[0],sn,rn),De=V(e[0][F],I,J,0));let Fe=-10,Ue=-10,st=0,St=0,vt=!0,mt="",Ke="";for(let We=s==2?1:0;We<b.length;We++){let Wt=b[We],Qt=ee[We],En=Qt==null?null:s==1?e[We][Qt]:e[We][1][Qt],Lt=ue.dataIdx(n,We,F,Se),en=Lt==null?null:s==1?e[We][Lt]:e[We][1][Lt];if(_e=_e||en!=En||Lt!=Qt,ee[We]=Lt,We>0&&Wt.show){let ci=Lt==null?-10:Lt==F?De:V(s==1?e[0][Lt]:e[We][0][Lt],I,J,0),Yn=en==null?-10:D(en,s==1?x[Wt.scale]:x[Wt.facets[1].scale],le,0);if(Qe&&en!=null){let Si=I.ori==1?Gt:Yt,Di=yn(Be.dist(n,We,Lt,Yn,Si));if(Di<Ss){let is=Be.bias;if(is!=0){let ui=ns(Si,Wt.scale),Mi=en>=0?1:-1,Fi=ui>=0?1:-1;Fi==Mi&&(Fi==1?is==1?en>=ui:en<=ui:is==1?en<=ui:en>=ui)&&(Ss=Di,Vs=We)}else Ss=Di,Vs=We}}if(_e||Re){let Si,Di;I.ori==0?(Si=ci,Di=Yn):(Si=Yn,Di=ci);let is,ui,Mi,Fi,ss,Zn,hi=!0,_r=he.bbox;if(_r!=null){hi=!1;let Jn=_r(n,We);Mi=Jn.left,Fi=Jn.top,is=Jn.width,ui=Jn.height}else Mi=Si,Fi=Di,is=ui=he.size(n,We);if(Zn=he.fill(n,We),ss=he.stroke(n,We),Re)We==Vs&&Ss<=Be.prox&&(Fe=Mi,Ue=Fi,st=is,St=ui,vt=hi,mt=Zn,Ke=ss);else{let Jn=lt[We];Jn!=null&&(Vt[We]=Mi,qn[We]=Fi,Vp(Jn,is,ui,hi),kp(Jn,Zn,ss),os(Jn,Ai(Mi),Ai(Fi),U,Ce))}}}}if(Re){let We=Be.prox,Wt=mr==null?Ss<=We:Ss>We||Vs!=mr;if(_e||Wt){let Qt=lt[0];Qt!=null&&(Vt[0]=Fe,qn[0]=Ue,Vp(Qt,st,St,vt),kp(Qt,mt,Ke),os(Qt,Ai(Fe),Ai(Ue),U,Ce))}}}if(Ht.show&&ks)if(v!=null){let[ge,Se]=hn.scales,[De,Fe]=hn.match,[Ue,st]=v.cursor.sync.scales,St=v.cursor.drag;if(Mn=St._x,wn=St._y,Mn||wn){let{left:vt,top:mt,width:Ke,height:We}=v.select,Wt=v.scales[Ue].ori,Qt=v.posToVal,En,Lt,en,ci,Yn,Si=ge!=null&&De(ge,Ue),Di=Se!=null&&Fe(Se,st);Si&&Mn?(Wt==0?(En=vt,Lt=Ke):(En=mt,Lt=We),en=x[ge],ci=V(Qt(En,Ue),en,J,0),Yn=V(Qt(En+Lt,Ue),en,J,0),Ko(Oi(ci,Yn),yn(Yn-ci))):Ko(0,J),Di&&wn?(Wt==1?(En=vt,Lt=Ke):(En=mt,Lt=We),en=x[Se],ci=D(Qt(En,st),en,le,0),Yn=D(Qt(En+Lt,st),en,le,0),jo(Oi(ci,Yn),yn(Yn-ci))):jo(0,le)}else Mh()}else{let ge=yn(Kd-Zd),Se=yn(jd-Jd);if(I.ori==1){let st=ge;ge=Se,Se=st}Mn=Dn.x&&ge>=Dn.dist,wn=Dn.y&&Se>=Dn.dist;let De=Dn.uni;De!=null?Mn&&wn&&(Mn=ge>=De,wn=Se>=De,!Mn&&!wn&&(Se>ge?wn=!0:Mn=!0)):Dn.x&&Dn.y&&(Mn||wn)&&(Mn=wn=!0);let Fe,Ue;Mn&&(I.ori==0?(Fe=Yr,Ue=Gt):(Fe=Zr,Ue=Yt),Ko(Oi(Fe,Ue),yn(Ue-Fe)),wn||jo(0,le)),wn&&(I.ori==1?(Fe=Yr,Ue=Gt):(Fe=Zr,Ue=Yt),jo(Oi(Fe,Ue),yn(Ue-Fe)),Mn||Ko(0,J)),!Mn&&!wn&&(Ko(0,0),jo(0,0))}if(Dn._x=Mn,Dn._y=wn,v==null){if(P){if(hp!=null){let[ge,Se]=hn.scales;hn.values[0]=ge!=null?ns(I.ori==0?Gt:Yt,ge):null,hn.values[1]=Se!=null?ns(I.ori==1?Gt:Yt,Se):null}ea(Ph,n,Gt,Yt,U,Ce,F)}if(Qe){let ge=P&&hn.setSeries,Se=Be.prox;mr==null?Ss<=Se&&ts(Vs,Kr,!0,ge):Ss>Se?ts(null,Kr,!0,ge):Vs!=mr&&ts(Vs,Kr,!0,ge)}}_e&&(de.idx=F,vh()),M!==!1&&An("setCursor")}let Gs=null;Object.defineProperty(n,"rect",{get(){return Gs==null&&Qo(!1),Gs}});function Qo(v=!1){v?Gs=null:(Gs=m.getBoundingClientRect(),An("syncRect",Gs))}function tp(v,M,P,F,W,J,le){ue._lock||ks&&v!=null&&v.movementX==0&&v.movementY==0||(bh(v,M,P,F,W,J,le,!1,v!=null),v!=null?gr(null,!0,!0):gr(M,!0,!1))}function bh(v,M,P,F,W,J,le,ge,Se){if(Gs==null&&Qo(!1),je(v),v!=null)P=v.clientX-Gs.left,F=v.clientY-Gs.top;else{if(P<0||F<0){Gt=-10,Yt=-10;return}let[De,Fe]=hn.scales,Ue=M.cursor.sync,[st,St]=Ue.values,[vt,mt]=Ue.scales,[Ke,We]=hn.match,Wt=M.axes[0].side%2==1,Qt=I.ori==0?U:Ce,En=I.ori==1?U:Ce,Lt=Wt?J:W,en=Wt?W:J,ci=Wt?F:P,Yn=Wt?P:F;if(vt!=null?P=Ke(De,vt)?a(st,x[De],Qt,0):-10:P=Qt*(ci/Lt),mt!=null?F=We(Fe,mt)?a(St,x[Fe],En,0):-10:F=En*(Yn/en),I.ori==1){let Si=P;P=F,F=Si}}Se&&(M==null||M.cursor.event.type==Ph)&&((P<=1||P>=U-1)&&(P=yr(P,U)),(F<=1||F>=Ce-1)&&(F=yr(F,Ce))),ge?(Zd=P,Jd=F,[Yr,Zr]=ue.move(n,P,F)):(Gt=P,Yt=F)}let Sh={width:0,height:0,left:0,top:0};function Mh(){_l(Sh,!1)}let np,ip,sp,rp;function op(v,M,P,F,W,J,le){ks=!0,Mn=wn=Dn._x=Dn._y=!1,bh(v,M,P,F,W,J,le,!0,!1),v!=null&&(xt(Ih,Uh,ap,!1),ea(Lp,n,Yr,Zr,U,Ce,null));let{left:ge,top:Se,width:De,height:Fe}=Ht;np=ge,ip=Se,sp=De,rp=Fe}function ap(v,M,P,F,W,J,le){ks=Dn._x=Dn._y=!1,bh(v,M,P,F,W,J,le,!1,!0);let{left:ge,top:Se,width:De,height:Fe}=Ht,Ue=De>0||Fe>0,st=np!=ge||ip!=Se||sp!=De||rp!=Fe;if(Ue&&st&&_l(Ht),Dn.setScale&&Ue&&st){let St=ge,vt=De,mt=Se,Ke=Fe;if(I.ori==1&&(St=Se,vt=Fe,mt=ge,Ke=De),Mn&&zs(w,ns(St,w),ns(St+vt,w)),wn)for(let We in x){let Wt=x[We];We!=w&&Wt.from==null&&Wt.min!=Ft&&zs(We,ns(mt+Ke,We),ns(mt,We))}Mh()}else ue.lock&&(ue._lock=!ue._lock,gr(M,!0,v!=null));v!=null&&(mn(Ih,Uh),ea(Ih,n,Gt,Yt,U,Ce,null))}function Uy(v,M,P,F,W,J,le){if(ue._lock)return;je(v);let ge=ks;if(ks){let Se=!0,De=!0,Fe=10,Ue,st;I.ori==0?(Ue=Mn,st=wn):(Ue=wn,st=Mn),Ue&&st&&(Se=Gt<=Fe||Gt>=U-Fe,De=Yt<=Fe||Yt>=Ce-Fe),Ue&&Se&&(Gt=Gt<Yr?0:U),st&&De&&(Yt=Yt<Zr?0:Ce),gr(null,!0,!0),ks=!1}Gt=-10,Yt=-10,ee.fill(null),gr(null,!0,!0),ge&&(ks=ge)}function lp(v,M,P,F,W,J,le){ue._lock||(je(v),Jo(),Mh(),v!=null&&ea(Np,n,Gt,Yt,U,Ce,null))}function cp(){T.forEach(Qv),N(n.width,n.height,!0)}br(El,no,cp);let jr={};jr.mousedown=op,jr.mousemove=tp,jr.mouseup=ap,jr.dblclick=lp,jr.setSeries=(v,M,P,F)=>{let W=hn.match[2];P=W(n,M,P),P!=-1&&ts(P,F,!0,!1)},ye&&(xt(Lp,m,op),xt(Ph,m,tp),xt(Dp,m,v=>{je(v),Qo(!1)}),xt(Fp,m,Uy),xt(Np,m,lp),Wh.add(n),n.syncRect=Qo);let yl=n.hooks=i.hooks||{};function An(v,M,P){$n?Pt.push([v,M,P]):v in yl&&yl[v].forEach(F=>{F.call(null,n,M,P)})}(i.plugins||[]).forEach(v=>{for(let M in v.hooks)yl[M]=(yl[M]||[]).concat(v.hooks[M])});let up=(v,M,P)=>P,hn=fn({key:null,setSeries:!1,filters:{pub:qp,sub:qp},scales:[w,b[1]?b[1].scale:null],match:[$p,$p,up],values:[null,null]},ue.sync);hn.match.length==2&&hn.match.push(up),ue.sync=hn;let hp=hn.key,wh=Hm(hp);function ea(v,M,P,F,W,J,le){hn.filters.pub(v,M,P,F,W,J,le)&&wh.pub(v,M,P,F,W,J,le)}wh.sub(n);function Oy(v,M,P,F,W,J,le){hn.filters.sub(v,M,P,F,W,J,le)&&jr[v](null,M,P,F,W,J,le)}n.pub=Oy;function By(){wh.unsub(n),Wh.delete(n),Sn.clear(),kh(El,no,cp),c.remove(),me?.remove(),An("destroy")}n.destroy=By;function Ah(){An("init",i,e),Zo(e||i.data,!1),H[w]?_h(w,H[w]):Jo(),ie=Ht.show&&(Ht.width>0||Ht.height>0),te=_e=!0,N(i.width,i.height)}return b.forEach(Gr),T.forEach(ys),t?t instanceof HTMLElement?(t.appendChild(c),Ah()):t(n,Ah):Ah(),n}dn.assign=fn;dn.fmtNum=Kh;dn.rangeNum=Tl;dn.rangeLog=Pl;dn.rangeAsinh=Zh;dn.orient=Mr;dn.pxRatio=Mt;dn.join=Wx;dn.fmtDate=Qh,dn.tzDate=tv;dn.sync=Hm;{dn.addGap=Ov,dn.clipGaps=Dl;let i=dn.paths={points:Zm};i.linear=Km,i.stepped=zv,i.bars=Vv,i.spline=Hv}var tg="12px system-ui, sans-serif",ng=2;function ig(i,e,t,n){let s={stroke:()=>rs("--grid"),width:1},r={stroke:()=>rs("--quiet"),font:tg,grid:s,ticks:{...s,size:4}},o={width:Math.max(i.clientWidth,120),height:n.height,legend:{show:!1},padding:[10,14,0,0],scales:{x:{time:!1},y:n.log?{distr:3,range:(l,c,u)=>tb(c,u,n.decades)}:{range:(l,c,u)=>eb(c,u)}},axes:[{...r,label:n.abscissa,labelSize:18,labelFont:tg,size:30,values:(l,c)=>c.map(Kn)},{...r,size:(l,c)=>16+7*Math.max(2,...(c??[]).map(u=>u.length)),values:(l,c)=>c.map(u=>u===null?"":n.log?nb(u):Kn(u))}],series:[{},...t.map(l=>({stroke:()=>rs(l.property),width:l.width,dash:l.dash,alpha:l.ghost?.35:1,spanGaps:!0,points:{show:!1}}))],cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!0,dist:ng},bind:{mousedown:(l,c,u)=>h=>h.shiftKey?u(h):null,dblclick:()=>()=>(n.zoomed(null),null)}},hooks:{setSelect:[l=>ib(l,n)],setCursor:[l=>n.hovered(l.cursor.left===void 0||l.cursor.left<0?null:l.posToVal(l.cursor.left,"x"))],draw:[l=>rb(l,n.marks)]}},a=new dn(o,e,i);return sb(a,n),a}function eb(i,e){if(i===null||e===null||!Number.isFinite(i)||!Number.isFinite(e))return[0,1];let t=Math.max(Math.abs(i),Math.abs(e)),n=t>1e-9?.05*t:.05;if(e-i<=1e-9*t||t<=1e-12)return[(i+e)/2-n,(i+e)/2+n];let s=.07*(e-i);return[i-s,e+s]}function tb(i,e,t){if(i===null||e===null||!(e>0))return[.1,1];let n=Math.max(i>0?i:e,e*10**-t);return[10**Math.floor(Math.log10(n)+1e-9),e*1.6]}function nb(i){let e=Math.log10(i);return Math.abs(e-Math.round(e))>1e-6?"":Kn(i).replace(/^1\u00a0×\u00a0|^1\.0\u00a0×\u00a0/,"")}function ib(i,e){i.select.width<ng||(e.zoomed([i.posToVal(i.select.left,"x"),i.posToVal(i.select.left+i.select.width,"x")]),i.setSelect({left:0,top:0,width:0,height:0},!1))}function sb(i,e){let t=i.over,n=s=>e.chosen(i.posToVal(s.clientX-t.getBoundingClientRect().left,"x"));t.addEventListener("pointerdown",s=>{s.shiftKey||s.button!==0||(t.setPointerCapture(s.pointerId),n(s))}),t.addEventListener("pointermove",s=>{t.hasPointerCapture(s.pointerId)&&n(s)})}function rb(i,e){let{ctx:t,bbox:n}=i,s=dn.pxRatio,r=-1/0;t.save(),t.strokeStyle=t.fillStyle=rs("--quiet"),t.font=`${11*s}px system-ui, sans-serif`,t.setLineDash([3*s,3*s]);for(let{at:o}of e){let a=i.valToPos(o,"x",!0);if(a<n.left||a>n.left+n.width)continue;t.beginPath(),t.moveTo(a,n.top),t.lineTo(a,n.top+n.height),t.stroke();let l=`${Kn(Number(o.toPrecision(3)))} Hz`;a>r&&a+t.measureText(l).width<n.left+n.width&&(t.fillText(l,a+3*s,n.top+11*s),r=a+t.measureText(l).width+8*s)}t.restore()}var sg={spectrum:5,other:6},ob=190,ab=1e-9,lb=100;function ag(i,e,t){let{chart:n}=i,s=n.abscissa==="time",r=Ms("chart"),o=n.unit==="–"?"":n.unit,a=n.log==="first",l=Rh(i,null),c=null,u=null,h=null,f=!1,d=!0,m="",_=0,g=0,p=0,b=ce("div",{class:"plot-area",role:"img"}),T=ce("span",{class:"readout"}),x=Tn("log",()=>k(!a),{class:"tool","aria-pressed":String(a),title:"Logarithmic ordinate, of the size of the values",hidden:n.log==="no"}),R=Tn("reset zoom",()=>t.set(null),{class:"tool",hidden:!0}),w=ce("div",{class:"tools"},R,x,Tn("CSV",de,{class:"tool",title:"Save the data of this chart as CSV"})),y=ce("h4",{id:r,text:n.title},ce("span",{class:"unit",text:o?` [${o}]`:""})),E=ce("p",{class:"note",hidden:!s||af(rg(i))>=1,text:cb(rg(i))}),O=ce("p",{class:"note",hidden:!0,text:"The marked frequencies are of the run as it was."}),L=Rp(l,V),I=ce("figure",{class:"chart","aria-labelledby":r,"data-chart":n.id},ce("figcaption",{},y,T,w),b,L.element,E,O);function k(se){a=se,x.setAttribute("aria-pressed",String(se)),V()}function V(){d=!0,f&&D()}function D(){if(!d||b.clientWidth===0)return;d=!1;let se=l.filter(Xe=>L.shows(Xe)),me=se.map(Xe=>({...L.look(Xe),width:Xe.ghost?1:Xe.role==="real"?1.6:1.3,ghost:Xe.ghost})),pe=bl(se,a);g=Math.max(0,...se.map(Xe=>Math.max(...og(Xe).map(Math.abs))));let Oe=JSON.stringify([me,a,b.clientWidth,_]);c&&Oe===m?c.setData(pe):H(pe,me),m=Oe,b.setAttribute("aria-label",ee(se)),s&&q(t.range),$()}function H(se,me){c?.destroy(),h=null,c=ig(b,se,me,{log:a,decades:n.group==="spectrum"?sg.spectrum:sg.other,height:ob,marks:n.marks,abscissa:s?"time [s]":"frequency [Hz]",zoomed:pe=>s?t.set(pe):q(pe),hovered:pe=>{h=pe,$()},chosen:pe=>{s&&e.seek(pe)}}),u=s?ce("div",{class:"time-line"}):null,u&&c.over.append(u)}function q(se){let me=c?.data[0];if(R.hidden=se===null,!c||!me?.length)return;let[pe,Oe]=se??[me[0],me[me.length-1]];Oe>pe&&c.setScale("x",{min:pe,max:Oe}),queueMicrotask(G)}function G(){if(!c||!u)return;let se=c.valToPos(e.time,"x"),me=se>=-.5&&se<=c.over.clientWidth+.5;u.style.display=me?"":"none",u.style.transform=`translateX(${se}px)`}function ae(){G(),(!e.playing||performance.now()-p>lb)&&$()}function $(){p=performance.now();let se=h??(s?e.time:null);T.textContent=h===null?"":s?`at ${h.toFixed(3)} s`:`at ${Hs(h,"Hz")}`,L.tell(me=>se===null?null:K(Sp(me,se)))}function K(se){return se!==null&&Math.abs(se)<ab*g&&!a?0:se}function ee(se){let me=se.filter(pe=>!pe.ghost).map(pe=>{let[Oe,Xe]=og(pe);return`${pe.label} ${pe.role}, from ${Kn(Oe)} to ${Kn(Xe)} ${o}`.trim()});return`${n.title}: ${me.join("; ")||"no curve is shown"}.`}function de(){Qr(Mp(l.filter(se=>L.shows(se)),s?"time [s]":"frequency [Hz]",o),`${n.id}.csv`,"text/csv")}let ue=new IntersectionObserver(se=>{f=se.some(me=>me.isIntersecting),f&&D(),f&&$()},{rootMargin:"120px"}),j=new ResizeObserver(()=>{f&&b.clientWidth>0&&V()});ue.observe(I),b.setAttribute("aria-label",ee(l.filter(se=>L.shows(se)))),j.observe(b);let ye=[e.subscribe(()=>{f&&s&&ae()}),t.subscribe(()=>s&&q(t.range))];return{element:I,id:n.id,show(se){l=Rh(i,se),L.renew(l),O.hidden=se===null||n.marks.length===0,V()},recolour(){_+=1,V()},dispose(){ue.disconnect(),j.disconnect(),ye.forEach(se=>se()),c?.destroy()}}}function rg(i){return i.runs.map(e=>e.chart).reduce((e,t)=>af(t)<af(e)?t:e)}function af(i){return i.at.data.length/i.samples}function cb(i){return`Drawn by ${i.at.data.length.toLocaleString("en")} of ${i.samples.toLocaleString("en")} samples; every extreme is kept.`}function og(i){let[e,t]=[1/0,-1/0];for(let n=0;n<i.y.length;n+=1)Number.isFinite(i.y[n])&&(e=Math.min(e,i.y[n]),t=Math.max(t,i.y[n]));return e<=t?[e,t]:[0,0]}function lg(){let i=new Set,e={range:null};return{get range(){return e.range},set(t){t===e.range||t&&e.range&&t.every((s,r)=>s===e.range?.[r])||(e.range=t,i.forEach(s=>s()))},subscribe(t){return i.add(t),()=>i.delete(t)}}}var cg={overview:"Overview",tip:"Tip",contact:"Contact",deformations:"Deformations",motors:"Motors",energy:"Energy",spectrum:"Spectrum",all:"All"};function hg(i,e,t){let n=vp(e),s=lg(),r=ce("div",{class:"chart-grid",id:"tm-charts",role:"tabpanel",tabindex:"0"}),o=ce("div",{class:"tabs",role:"tablist","aria-label":"Charts"}),a=ce("p",{class:"note hint",text:"Click or drag: choose the time. Shift and drag: zoom, double click: back."}),l=Object.keys(cg).filter(m=>ug(n,m).length>0),c=[],u=null;for(let m of l){let _=Tn(cg[m],()=>h(m),{role:"tab",id:`tm-tab-${m}`,"aria-controls":"tm-charts","data-group":m});o.append(_)}o.addEventListener("keydown",m=>{let _={ArrowRight:1,ArrowLeft:-1}[m.key],g=l.findIndex(p=>`tm-tab-${p}`===m.target.id);_===void 0||g<0||(m.preventDefault(),m.stopPropagation(),h(l[(g+_+l.length)%l.length]),o.querySelector("[aria-selected=true]")?.focus())});function h(m){c.forEach(_=>_.dispose()),c=ug(n,m).map(_=>ag(_,t,s)),u&&c.forEach(_=>_.show(u));for(let _ of o.querySelectorAll("button")){let g=_.dataset.group===m;_.setAttribute("aria-selected",String(g)),_.tabIndex=g?0:-1}r.setAttribute("aria-labelledby",`tm-tab-${m}`),r.replaceChildren(...c.map(_=>_.element))}let f=matchMedia("(prefers-color-scheme: dark)"),d=()=>c.forEach(m=>m.recolour());return f.addEventListener("change",d),i.append(ce("div",{class:"tab-bar"},o,a),r),h("overview"),{show(m){u=m,c.forEach(_=>_.show(m))},dispose(){f.removeEventListener("change",d),c.forEach(m=>m.dispose()),i.replaceChildren()}}}function ug(i,e){return e==="all"?i:e!=="overview"?i.filter(({chart:t})=>t.group===e):i.filter(({chart:t},n)=>i.findIndex(s=>s.chart.group===t.group)===n)}var fg='"use strict";(()=>{var O=class extends Error{name="EngineError"},Se=1,nt=65536,ot={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},Q=class e{constructor(r,n,t,o){this.layout=r;this.functions=n;this.memory=t;this.free=o}layout;functions;memory;free;static async open(r,n){if(n.format!==Se)throw new O(`layout: got format ${n.format}; expected ${Se}`);let{instance:t}=await st(r,n),{memory:o,heap_base:s,...a}=t.exports,i=s.value;return new e(n,a,o,i)}sample(r,n,t,o){let s=X(this.layout.samples,r,"function");j(`${r}: parameters`,n.length,s.parameters);let a=s.kind==="program"?this.program(s,n,t,o):this.schedule(s,n,[t],o);return fe(s.outputs,a,o,1)}slopes(r,n,t,o,s){let a=X(this.layout.samples,r,"function");if(a.kind!=="slopes")throw new O(`${r}: got a function without derivatives; expected one with them`);j(`${r}: parameters`,n.length,a.parameters);let i=Object.fromEntries(Object.entries(a.inputs).map(([m,u])=>[m,new Float64Array(u)])),l=this.schedule(a,n,[t,{...i,...o}],s),c=C(a.outputs);return{values:fe(a.outputs,l,s,2),slopes:fe(a.outputs,l.subarray(c),s,2)}}call(r,n){let t=n.map(i=>typeof i=="number"?null:i instanceof Float64Array?i:i.into);this.reserve(t.reduce((i,l)=>i+(l?.byteLength??0),this.free));let o=new Float64Array(this.memory.buffer),s=this.free,a=n.map((i,l)=>{if(typeof i=="number")return BigInt(i);let c=s;return(i instanceof Float64Array||i.given)&&o.set(t[l],c/8),s+=t[l].byteLength,c});this.functions[r](...a),n.forEach((i,l)=>{if(typeof i=="number"||i instanceof Float64Array)return;let[c,m]=i.range?.()??[0,i.into.length],u=a[l]/8;i.into.set(o.subarray(u+c,u+m),c)})}program(r,n,t,o){let s=Object.entries(r.inputs).map(([i,l])=>Re(i,l,t[i],o)),a=new Float64Array(o*C(r.outputs));return this.call(r.export,[o,n,...s,{into:a}]),a}schedule(r,n,t,o){let s=at(r.inputs,t,o),a=new Float64Array(o*t.length*C(r.outputs)),i=new Float64Array(r.workspace);return this.call(r.export,[o,0,n,i,s,{into:a}]),a}reserve(r){let n=r-this.memory.buffer.byteLength;if(!(n<=0))try{this.memory.grow(Math.ceil(n/nt))}catch{throw new O(`memory: got no room for ${(r/1e6).toFixed(0)} MB; expected a browser that has it. Mend: ask for fewer samples`)}}};async function st(e,r){try{return await WebAssembly.instantiate(e,{env:ot})}catch(n){let t=r.simd?", with vectors (SIMD)":"";throw new O(`WebAssembly: got ${String(n)}; expected a browser that allows it${t}`)}}function X(e,r,n){if(!Object.hasOwn(e,r))throw new O(`${n}: got ${r}; expected one of ${Object.keys(e).join(", ")}`);return e[r]}function j(e,r,n){if(r!==n)throw new O(`${e}: got ${r} numbers; expected ${n}`)}function C(e){return Object.values(e).reduce((r,n)=>r+n,0)}function Re(e,r,n,t){if(n===void 0)throw new O(`${e}: got nothing; expected ${r} numbers for each sample`);if(n.length===t*r)return n;j(e,n.length,r);let o=new Float64Array(t*r);return pe(n,0,0,o,r,0,r,t),o}function at(e,r,n){let t=C(e),o=new Float64Array(n*r.length*t);return r.forEach((s,a)=>{let i=a*t;for(let[l,c]of Object.entries(e)){let m=Re(l,c,s[l],n);pe(m,c,0,o,r.length*t,i,c,n),i+=c}}),o}function fe(e,r,n,t){let o=t*C(e),s={},a=0;for(let[i,l]of Object.entries(e)){let c=new Float64Array(n*l);pe(r,o,a,c,l,0,l,n),s[i]=c,a+=l}return s}function pe(e,r,n,t,o,s,a,i){for(let l=0;l<i;l++){let c=l*r+n,m=l*o+s;for(let u=0;u<a;u++)t[m+u]=e[c+u]}}var it=["rk4","midpoint"],lt=500,ge=class{constructor(r,n){this.engine=r;this.spec=n;let t=X(r.layout.loops,n.loop,"loop");j(`${n.loop}: parameters`,n.parameters.length,t.parameters),j(`${n.loop}: state`,n.state.length,t.size),j(`${n.loop}: rows`,n.rows.length,(n.knots.length-1)*t.row),this.method=t.method,this.memory=new Float64Array(r.layout.cells.length),this.state=n.state.slice(),this.slope=new Float64Array(t.size),this.sums=new Float64Array(t.size),this.states=new Float64Array(n.times.length*t.size),this.sumsAtSamples=new Float64Array(n.times.length*t.size),this.states.set(n.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;sums;sumsAtSamples;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(r){return this.memory[this.engine.layout.cells.indexOf(r)]}put(r){for(let[n,t]of Object.entries(r))this.memory[this.engine.layout.cells.indexOf(n)]=t}advance(r){let{layout:n}=this.engine,{settings:t,knots:o,rows:s,times:a,parameters:i}=this.spec,l=Math.max(1,Math.min(r,t.maxSteps-this.tried)),c={step:t.step,rtol:t.relativeTolerance,atol:t.absoluteTolerance,chunk:l,bound:n.limits.bound,watch:0,most_events:n.limits.most_events,event_time:n.limits.event_time,looks:0},m=this.cell("sample"),u=p=>({into:p,range:()=>[m*this.state.length,this.cell("sample")*this.state.length]}),f=p=>({into:p,given:!0}),g={memory:f(this.memory),y:f(this.state),k1:f(this.slope),p:i,knots:o,rows:s,times:a,out:u(this.states),options:Float64Array.from(n.options,p=>c[p]),errors:f(this.sums),errors_out:u(this.sumsAtSamples),seen:new Float64Array(1),segments:o.length-1,samples:a.length};this.engine.call(n.loops[this.spec.loop].export,n.arguments.map(p=>g[p]))}result(){let r=this.cell("sample"),n=this.state.length,[t,o]=this.ending();return{status:t,message:o,times:this.spec.times.slice(0,r),states:this.states.slice(0,r*n),errors:this.sumsAtSamples.slice(0,r*n),statistics:this.statistics()}}statistics(){let[r,n,t]=[this.cell("steps"),this.cell("smallest"),this.time],o=r?t/r:null,s={steps:r,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:o,smallest_step_s:n>0?n:o};return it.includes(this.method)&&(s.step=this.cell("h")),this.cell("passes")&&(s.passes=this.cell("passes")),this.cell("events")&&(s.contact_changes=this.cell("events")),s}ending(){let{statuses:r,limits:n}=this.engine.layout,{settings:t}=this.spec,[o,s]=[this.cell("status"),`t = ${I(this.time,6)} s`];if(o===r.finished)return["finished",`reached the end, t = ${I(t.duration,6)} s`];if(o===r.running)return["stopped",`stopped at ${s} of ${I(t.duration,6)} s: integration.max_steps = ${t.maxSteps} is used up`];if(o===r.chattering){let a=`more than ${n.most_events} times within ${n.event_time} s`;return["chattering",`stopped at ${s}: the contact set in or ended ${a}; give the surface damping, or a lower stiffness`]}return this.lost(o,s)}lost(r,n){let{statuses:t,coordinates:o,limits:s}=this.engine.layout,a=o.length,i=Array.from(this.rates().subarray(a,2*a),g=>Number.isFinite(g)?Math.abs(g):1/0),l=i.indexOf(Math.max(...i)),m=i[l]<s.bound?r===t.not_converged?"not_converged":r===t.step_too_small?"step_too_small":"diverged":"diverged",u=`its acceleration is ${I(i[l],3)} rad/s^2`,f=m.replaceAll("_"," ");return[m,`${f} at ${n} in coordinate ${o[l]}: ${u}; its last step was of ${I(this.cell("h"),3)} s`]}rates(){let{loop:r,parameters:n,rows:t}=this.spec,{row:o}=this.engine.layout.loops[r],s=Math.min(this.cell("segment"),t.length/o-1),a={time:Float64Array.of(this.time),state:this.state,row:t.slice(s*o,(s+1)*o),step:new Float64Array(1)};return this.engine.sample(`${r.slice(0,r.lastIndexOf("."))}.rate`,n,a,1).rate}},W=class extends O{name="Cancelled"};async function Y(e,r,n={}){let t=new ge(e,r),o=1e3*(n.piece??.05),s=lt,a=performance.now();for(;t.running;){let i=performance.now();t.advance(s);let l=performance.now();if(s=Math.max(1,Math.floor(s*Math.min(4,o/Math.max(l-i,.001)))),!(l-a<o)){if(n.progress?.(t.time/r.settings.duration),await new Promise(c=>setTimeout(c,0)),n.cancelled?.())throw new W(`the run was given up at t = ${I(t.time,6)} s`);a=performance.now()}}return t.result()}function I(e,r){return String(Number(e.toPrecision(r)))}function he(e,r=new Set){if(ArrayBuffer.isView(e))e.buffer instanceof ArrayBuffer&&r.add(e.buffer);else if(e!==null&&typeof e=="object")for(let n of Object.values(e))he(n,r);return[...r]}function Z(e,r){let n=Array.from(e.frames.data).filter(t=>t<r);return n[n.length-1]!==r-1&&n.push(r-1),n}function R(e){return e.data instanceof Float64Array?e.data:Float64Array.from(e.data)}function ee(e,r){let n=r.length;for(let t=0;t<n;t+=1){let o=t;for(let a=t+1;a<n;a+=1)Math.abs(e[a*n+t])>Math.abs(e[o*n+t])&&(o=a);let s=Math.abs(e[o*n+t]);if(!(s>0)||s===1/0)return!1;o!==t&&ct(e,r,t,o);for(let a=t+1;a<n;a+=1){let i=e[a*n+t]/e[t*n+t];if(i!==0){for(let l=t+1;l<n;l+=1)e[a*n+l]-=i*e[t*n+l];r[a]-=i*r[t]}}}for(let t=n-1;t>=0;t-=1){for(let o=t+1;o<n;o+=1)r[t]-=e[t*n+o]*r[o];r[t]/=e[t*n+t]}return!0}function ct(e,r,n,t){let o=r.length;for(let a=0;a<o;a+=1){let i=e[n*o+a];e[n*o+a]=e[t*o+a],e[t*o+a]=i}let s=r[n];r[n]=r[t],r[t]=s}function mt(e,r,n){let t=e.knobs.map(s=>s.start),o=e.knobs.map(s=>s.factor);return e.sliders.forEach((s,a)=>{s.real?o[s.knob]=r[a]:t[s.knob]=r[a]}),n==="reference"?t:e.knobs.map((s,a)=>{let i=o[a];return i===null||s.factor===null?t[a]:s.together?s.factor?t[a]*(i/s.factor):t[a]:t[a]*i})}function z(e,r,n){let t=e.runs[n],o=ut(t,mt(e,r,n)),s={};for(let[a,i]of Object.entries(t.places)){let l=i.shape.reduce((c,m)=>c*m,1);s[a]=o.slice(i.start,i.start+l)}return s}function ut(e,r){let n=R(e.base).slice(),t=e.powers.map(l=>_e(l,(c,m)=>Math.pow(r[c]/e.variables[c].start,m))),o=e.powers.map(l=>_e(l,(c,m)=>ft(e.variables[c],m,r[c]))),{products:s,terms:a,coefficients:i}=e;for(let l=0;l<s.data.length;l+=2)n[s.data[l]]*=t[s.data[l+1]];for(let l=0;l<a.data.length;l+=2)n[a.data[l]]+=i.data[l/2]*o[a.data[l+1]];return n}function _e(e,r){return e.reduce((n,[t,o])=>n*r(t,o),1)}function ft(e,r,n){let t=Math.pow(e.start,r);return(Math.pow(n,r)-t)/(Math.pow(e.far,r)-t)}function G(e,r){return{knots:e,coefficients:r,signals:1,degree:r.length/(e.length-1)-1}}function K(e,r){let n=e.degree+1,t=e.knots.length-1,o=0;for(;o<t&&e.knots[o]<r;)o+=1;let s=e.knots[t],a=[...e.knots.subarray(0,o)],i=[...e.coefficients.subarray(0,o*n)];return r>s&&(a.push(s),i.push(Me(e,t-1,0,s),...new Array(e.degree).fill(0))),G(Float64Array.from([...a,r]),Float64Array.from(i))}function Me(e,r,n,t){let o=e.degree+1,s=(r*e.signals+n)*o,a=t-e.knots[r],i=0;for(let l=e.degree;l>=0;l-=1)i=i*a+e.coefficients[s+l];return i}function de(e,r){let[n,t]=[0,e.length-1];for(;t-n>1;){let o=n+t>>1;e[o]<=r?n=o:t=o}return n}function te(e,r,n){return Me(e,de(e.knots,n),r,n)}function re(e){return Oe(e,Array.from({length:e.knots.length-1},(r,n)=>n))}function ne(e,r){return Oe(e,Array.from(r,n=>de(e.knots,n)))}function Oe(e,r){let n=e.signals*(e.degree+1),t=new Float64Array(r.length*(n+1));return r.forEach((o,s)=>{t[s*(n+1)]=e.knots[o],t.set(e.coefficients.subarray(o*n,(o+1)*n),s*(n+1)+1)}),t}function $e(e){if(!e.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let r=Math.max(...e.map(a=>a.knots[a.knots.length-1])),n=e.map(a=>a.knots[a.knots.length-1]<r?K(a,r):a),t=pt(n.flatMap(a=>[...a.knots])),o=Math.max(...n.map(a=>a.degree)),s=new Float64Array((t.length-1)*e.length*(o+1));return n.forEach((a,i)=>{for(let l=0;l<t.length-1;l+=1){let c=(l*e.length+i)*(o+1);gt(a,t,l,s.subarray(c,c+o+1))}}),{knots:t,coefficients:s,signals:e.length,degree:o}}function pt(e){let r=[...new Set(e)].sort((o,s)=>o-s),n=r[r.length-1]-r[0],t=r.filter((o,s)=>s===0||o-r[s-1]>1e-12*n);return t[t.length-1]=r[r.length-1],Float64Array.from(t)}function gt(e,r,n,t){let o=de(e.knots,(r[n]+r[n+1])/2),s=r[n]-e.knots[o],a=Math.abs(s)<=1e-12*(r[r.length-1]-r[0])?0:s;for(let i=0;i<=e.degree;i+=1){let l=e.coefficients[o*(e.degree+1)+i],c=1;for(let m=i;m>=0;m-=1)t[m]+=c*l*Math.pow(a,i-m),c=c*m/(i-m+1)}}var ht=40,dt=1e-12,yt=.5,Ee=1e-6,Te=8;function bt(e,r,n,t,o,s){let[a,i,l]=[t.length+1,n.length,r.rotors.length],c=new Float64Array(a*i);for(let f=0;f<a;f+=1)c.set(n,f*i),f&&(c[f*i+t[f-1]]+=Ee);let m={time:new Float64Array(1),state:c,row:r.rest_row,step:new Float64Array(1)},{rate:u}=e.sample("rest.rate",r.rest,m,a);for(let f=0;f<t.length;f+=1){s[f]=u[l+t[f]];for(let g=0;g<t.length;g+=1)o[f*t.length+g]=(u[(g+1)*i+l+t[f]]-s[f])/Ee}}function At(e,r,n,t){let o=e.layout.held,s=t.length,a=Array.from({length:s},(u,f)=>f).filter(u=>!o.includes(u)),i=new Float64Array(r.restSize);i.set(t);let l=new Float64Array(a.length**2),c=new Float64Array(a.length),m=1/0;for(let u=0;u<ht&&a.length;u+=1){if(bt(e,n,i,a,l,c),!ee(l,c))return null;let f=c.reduce((p,b)=>Math.max(p,Math.abs(b)),0);if(!Number.isFinite(f))return null;let g=Math.min(1,yt/f);for(let p=0;p<a.length;p+=1)i[a[p]]-=g*c[p];if(f<dt||f<1e-9&&f>=m/2)return i.slice(0,s);m=f}return a.length?null:i.slice(0,s)}function Ft(e,r,n,t,o){let s=(c,m)=>At(e,r,z(r.map,c,t),m),a=s(n,o);if(a)return a;let i=r.sliders.map(c=>c.value),l=o;for(let c=1;c<=Te&&l;c+=1)l=s(n.map((m,u)=>i[u]+(m-i[u])*(c/Te)),l);if(!l)throw new Error(`${t}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`);return l}function Le(e,r,n,t,o){let s=r.runs[t],a=R(s.start).slice(),[i,l]=[s.state.q[0],s.state.v[0]];if(r.atRest){let c=Ft(e,r,n,t,a.slice(...s.state.q));for(let m=0;m<c.length;m+=1)s.told.includes(m)||(a[i+m]=c[m])}for(let[c,m]of s.exact){a[i+c]=te(o,m,0);let u=o.degree;a[l+c]=u?o.coefficients[m*(u+1)+1]:0}return a}function w(e,r,n){let t=e.length/r,o=new Float64Array(t*n.length);for(let s=0;s<t;s+=1)for(let a=0;a<n.length;a+=1)o[s*n.length+a]=e[s*r+n[a]];return o}function S(e,r){return Array.from({length:r-e},(n,t)=>e+t)}function N(e,r,n){let t=new Float64Array(n.length*r);for(let o=0;o<n.length;o+=1)for(let s=0;s<r;s+=1)t[o*r+s]=e[n[o]*r+s];return t}function ye(e,...r){let n=r.map(a=>a.length/e),t=n.reduce((a,i)=>a+i,0),o=new Float64Array(e*t),s=0;return r.forEach((a,i)=>{for(let l=0;l<e;l+=1)for(let c=0;c<n[i];c+=1)o[l*t+s+c]=a[l*n[i]+c];s+=n[i]}),o}function H(e,r){return e.map((n,t)=>n-r[t])}function $(e,r){let n=new Float64Array(e.length/r);for(let t=0;t<n.length;t+=1){let o=0;for(let s=0;s<r;s+=1)o+=e[t*r+s]**2;n[t]=Math.sqrt(o)}return n}function oe(e,r,n,t){let o=e.length/n,s=r.length/n,a=new Float64Array(n),i=0;for(let l=0;l<n;l+=1){let c=0;for(let m=0;m<o;m+=1)c+=e[l*o+m];l===0&&(i=c),a[l]=c-i;for(let m=0;m<s;m+=1)a[l]+=(m<t?-1:1)*r[l*s+m]}return a}function B(e){let r=0;for(let n=1;n<e.length;n+=1)Math.abs(e[n])>Math.abs(e[r])&&(r=n);return r}function d(e,r,...n){return{data:e,shape:[r,...n]}}var se=24,wt=5e5,vt=2e4;function ae(e,r,n){let[t,o]=e.matrix.shape,s=new Float64Array(n*t);for(let a=0;a<n;a+=1)for(let i=0;i<t;i+=1){let l=e.constant.data[i];for(let c=0;c<o;c+=1)l+=e.matrix.data[i*o+c]*r[a*o+c];s[a*t+i]=l}return s}function Ne(e,r,n,t,o,s){let a=h=>N(t[h].data,t[h].shape.slice(1).reduce((y,A)=>y*A,1),s),i=s.length,l=be(e,r,n,a("q"),i),c=h=>be(e,r,n,h,i).line,m=h=>c(ae(r.straight,h,i)),u=m(a("q")),f=h=>({data:a(h),shape:[i,...t[h].shape.slice(1)]}),g="q_reference"in t,p=l.line.shape.slice(0,3),b=l.line.data.map((h,y)=>h-u.data[y]);return{times:{data:N(o,1,s),shape:[i]},line:l.line,rigid:u,roots:l.roots,reference:g?c(a("q_reference")):null,referenceRigid:g?m(a("q_reference")):null,colours:[{id:"deflection",label:"Deflection from the root\'s tangent",unit:"m",values:{data:l.bent,shape:p}},{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:$(b,3),shape:p}}],tip:f("tip"),tipReference:g?f("tip_reference"):null,contact:r.contactPoint<0?null:{force:f("contact_force"),at:kt(r,t,s)}}}function Pe(e,r,n,t,o){let[s,a]=[r.links.length,r.stations.data.length];if(!r.links.some(m=>m.bends)||o*s*a>wt)return null;let[i,l]=[t.length/o,Math.max(1,Math.floor(vt/(s*a)))],c={link:"",value:-1,sample:0};for(let m=0;m<o;m+=l){let u=Math.min(l,o-m),{bent:f}=be(e,r,n,t.subarray(m*i,(m+u)*i),u);for(let g=0;g<u;g+=1)r.links.forEach((p,b)=>{let h=f[(g*s+b+1)*a-1];p.bends&&h>c.value&&(c={link:p.name,value:h,sample:m+g})})}return c}function kt(e,r,n){let t=r.position.shape[1],o=N(r.position.data,3*t,n),s=new Float64Array(3*n.length);for(let a=0;a<n.length;a+=1)for(let i=0;i<3;i+=1)s[3*a+i]=o[3*(a*t+e.contactPoint)+i];return{data:s,shape:[n.length,3]}}function be(e,r,n,t,o){let s=new Float64Array(t.length/o),{points:a}=e.sample("pose",n,{q:t,v:s,a:s,base:R(r.base)},o),[i,l]=[r.links.length,r.stations.data.length],c=a.length/o/se,m=new Float64Array(o*i*l*3),u=new Float64Array(o*i*4),f=new Float64Array(o*i*l);for(let g=0;g<o;g+=1)r.links.forEach((p,b)=>{let h=a.subarray((g*c+p.point)*se,(g*c+p.point+1)*se);u.set(_t(h),(g*i+b)*4),g&&xt(u,(g*i+b)*4,4*i);for(let y=0;y<l;y+=1){let A=((g*i+b)*l+y)*3,F=(g*c+p.point+y)*se+9;for(let v=0;v<3;v+=1)m[A+v]=p.bends?a[F+v]:St(h,R(p.end),v,r.stations.data[y]);p.bends&&(f[A/3]=Rt(h,m,A))}});return{line:{data:m,shape:[o,i,l,3]},roots:{data:u,shape:[o,i,4]},bent:f}}function xt(e,r,n){let t=0;for(let o=r;o<r+4;o+=1)t+=e[o]*e[o-n];if(t<0)for(let o=r;o<r+4;o+=1)e[o]*=-1}function St(e,r,n,t){return e[9+n]+t*(e[3*n]*r[0]+e[3*n+1]*r[1]+e[3*n+2]*r[2])}function Rt(e,r,n){let t=[0,1,2].map(s=>r[n+s]-e[9+s]),o=[1,2].map(s=>e[s]*t[0]+e[3+s]*t[1]+e[6+s]*t[2]);return Math.hypot(o[0],o[1])}function _t(e){let r=e[0]+e[4]+e[8];if(r>0){let t=2*Math.sqrt(1+r);return[(e[7]-e[5])/t,(e[2]-e[6])/t,(e[3]-e[1])/t,t/4]}if(e[0]>e[4]&&e[0]>e[8]){let t=2*Math.sqrt(1+e[0]-e[4]-e[8]);return[t/4,(e[1]+e[3])/t,(e[2]+e[6])/t,(e[7]-e[5])/t]}if(e[4]>e[8]){let t=2*Math.sqrt(1+e[4]-e[0]-e[8]);return[(e[1]+e[3])/t,t/4,(e[5]+e[7])/t,(e[2]-e[6])/t]}let n=2*Math.sqrt(1+e[8]-e[0]-e[4]);return[(e[2]+e[6])/n,(e[5]+e[7])/n,n/4,(e[3]-e[1])/n]}var qe=.05,Mt=8,Ot=["settling","vibration.residual"];function k(e,r=3){return String(Number(e.toPrecision(r)))}function U(e,r){if(e.length<2)return r[0];let n=0;for(let t=1;t<e.length;t+=1)n+=(r[t]+r[t-1])/2*(e[t]-e[t-1]);return n/(e[e.length-1]-e[0])}function ie(e,r,n,t=0){let o={},s=r.deviation?.data;if(s){let a=B(s),i=s[s.length-1];o["deviation.max"]={value:s[a],note:`at ${k(e[a])} s; ${k(i)} m at the end of the run`},o["deviation.rms"]={value:Math.sqrt(U(e,s.map(l=>l*l))),note:"over the run"},o.settling=$t(e,s,n,t)}return o["vibration.residual"]=Bt(e,r,n),o}function $t(e,r,n,t){if(n===null)return{value:null,note:"not seen: what moves the robot changes up to the end of the run"};if(e[e.length-1]<=n*(1+1e-9))return{value:null,note:"not seen here: the run ends with the move"};let s=qe*r[B(r)],a=-1;for(let c=0;c<e.length;c+=1)e[c]>n&&r[c]>s&&(a=c);if(a===e.length-1)return{value:null,note:"not seen: it swings to the end of the run"};let i=e.length-e.findIndex(c=>c>n);if(e.length-1-a<t*i)return{value:null,note:"not seen: the run ends too soon after the move"};let l=`until the tip stays within ${k(s)} m, ${100*qe} % of its largest deviation`;return{value:a<0?0:e[a]-n,note:l}}function le(e){let r={};for(let[n,{value:t,note:o}]of Object.entries(e))Ot.includes(n)?r[n]={value:null,note:"the run broke off"}:r[n]={value:t,note:`until it broke off: ${o}`};return r}function Bt(e,r,n){if(n===null)return{value:null,note:"what moves the robot changes up to the end of the run"};let t=e.findIndex(l=>l>n*(1+1e-9));if(t<0||e.length-t<Mt)return{value:null,note:"the run ends with the move"};let o=r.tip_reference?.data,s=r.tip.data.map((l,c)=>l-(o?o[c]:0)).subarray(3*t),a=[0,1,2].map(l=>s.reduce((c,m,u)=>u%3===l?c+m:c,0)/(s.length/3)),i=$(s.map((l,c)=>l-a[c%3]),3);return{value:i[B(i)],note:`about its mean place, from ${k(e[t])} s on`}}function ce(e,r){if(!e.energy||!e.energy_balance)return{};let{energy:n,work:t}=e,o=n.shape[1],s=Math.max(n.data.reduce((l,c,m)=>Math.max(l,Math.abs(c-n.data[m%o])),0),t.data.reduce((l,c)=>Math.max(l,Math.abs(c)),0)),a=Math.abs(e.energy_balance.data[B(e.energy_balance.data.subarray(0,r))]),i=s?`worst residual, ${k(a)} J, over ${k(s)} J moved`:"nothing moved";return{"energy.residual":{value:s?a/s:null,note:i}}}function Ae(e,r,n=1){let t=B(r);return{value:Math.abs(r[t]),note:`at ${k(e[Math.floor(t/n)])} s`}}var T=24,Et=32;async function je(e,r,n,t,o){let s=performance.now(),a=r.runs.reference?["reference","real"]:["real"],i=[];for(let[F,v]of a.entries()){let E={...t,progress:me=>t.progress?.((F+me)/a.length)},q=z(r.map,n,v),_=()=>Nt(e,r,n,v,q,E);i.push(await(v==="reference"?o.of(q,_):_()))}let l=i[i.length-1],c=(performance.now()-s)/1e3,m=Math.min(...i.map(F=>F.run.times.length)),[u,f]=[l,...i.slice(0,-1)].map(F=>Pt(e,r,F,m)),g=l.run.times.subarray(0,m),p={...jt(r,l,u,m),...f?It(r,u,f,m):{}},b=Z(r,m),h=Wt(l.schedule),y=i.find(F=>F.run.status!=="finished"),A={...zt(r,g,p,h),...Lt(Pe(e,r,l.blocks.pose,u.model.q,m),g)};return{status:y?y.run.status:"finished",message:y?`${y===l?"real arm":"reference"}: ${y.run.message}`:l.run.message,seconds:c,times:g,series:p,scene:Ne(e,r,l.blocks.pose,p,g,b),line:null,span:Tt(g,h),facts:y?le(A):A}}function Tt(e,r){let n=e[e.length-1],t=r===null?-1:e.findIndex(o=>o>=r*(1+1e-9));return[t>=0&&e.length-t>=Et?e[t]:e[0],n]}function Lt(e,r){return e?{"deflection.max":{value:e.value,note:`${e.link}, at ${k(r[e.sample])} s`}}:{}}async function Nt(e,r,n,t,o,s){let{settings:a}=r,i=r.runs[t],l=S(0,i.signals).map(u=>K(G(o[`knots.${u}`],o[`coefficients.${u}`]),a.duration)),c=$e(l);l.length||(c.knots[1]=a.duration);let m=await Y(e,{loop:`${t}.${a.method}`,parameters:o.parameters,knots:c.knots,rows:re(c),state:Le(e,r,n,t,c),times:R(r.times),settings:a},s);return{name:t,told:i,blocks:o,schedule:c,run:m}}function Pt(e,r,n,t){let o=n.run.times.subarray(0,t),s=n.run.states.subarray(0,t*(n.run.states.length/n.run.times.length)),a=ne(n.schedule,o),i={time:o,state:s,row:a,step:new Float64Array(1)},l=e.sample(`${n.name}.observe`,n.blocks.parameters,i,t),{q:c,v:m,a:u}=l,f=R(r.base),{chain:g,rotors:p}=n.blocks,{points:b}=e.sample("inertia",g,{q:c,v:m,a:u,base:f},t),h=new Float64Array(p.length),y=e.sample("inertia",g,{q:c,v:h,a:m,base:f},t),A=e.sample("elastic",g,{q:c,v:m,base:f},t).energies;return{model:l,points:b,energy:qt(r,m,p,y,A,t)}}function qt(e,r,n,t,o,s){let a=n.length,i=o.length/s,l=new Float64Array(4*s);for(let c=0;c<s;c+=1){for(let m=0;m<a;m+=1){let u=r[c*a+m];l[4*c]+=(t.forces[c*a+m]+n[m]*u)*u/2}for(let m=0;m<3;m+=1)l[4*c+1]-=t.moment[3*c+m]*e.gravity.data[m];for(let m=0;m<i;m+=1)l[4*c+2+m%2]+=o[c*i+m]}return l}function jt(e,r,{model:n,points:t,energy:o},s){let a=n.q.length/s,i=n.gear.length/s,l=t.length/s/T,c=r.run.states.length/r.run.times.length,m=w(r.run.states.subarray(0,s*c),c,S(...r.told.state.works)),u=h=>d(w(n.drives,4*i,S(0,i).map(y=>4*y+h)),s,i),f=h=>w(t,l*T,S(0,l).flatMap(y=>S(0,3).map(A=>y*T+h+A))),g=w(t,l*T,S(0,l).flatMap(h=>S(h*T,h*T+9))),p={q:d(n.q,s,a),v:d(n.v,s,a),a:d(n.a,s,a),deformation:d(ae(e.deflections,n.q,s),s,e.deformations.length),position:d(f(9),s,l,3),velocity:d(f(12),s,l,3),acceleration:d(f(18),s,l,3),rotation:d(g,s,l,3,3),tip:d(w(t,l*T,[9,10,11]),s,3),tip_velocity:d(w(t,l*T,[12,13,14]),s,3),energy:d(o,s,4),work:d(m,s,m.length/s),energy_balance:d(oe(o,m,s,3),s)};if(i&&Object.assign(p,{wanted:u(3),effort:u(0),gear_torque:d(n.gear,s,i)}),i&&e.electric&&Object.assign(p,{voltage:u(1),current:u(2)}),e.contactPoint<0)return p;let b=h=>w(n.contact,6,h);return{...p,contact_force:d(b([0,1,2]),s,3),contact_force_normal:d(b([3]),s),penetration:d(b([4]),s)}}function It(e,r,n,t){let o=n.model.q.length/t,s=n.points.length/t/T,[a,i]=[r,n].map(({points:c})=>w(c,s*T,[9,10,11])),l={q_reference:d(n.model.q,t,o),v_reference:d(n.model.v,t,o),deformation_reference:d(ae(e.deflections,n.model.q,t),t,e.deformations.length),gear_torque_reference:d(n.model.gear,t,n.model.gear.length/t),tip_reference:d(i,t,3),deviation:d($(H(a,i),3),t)};return e.contactPoint>=0&&(l.contact_force_normal_reference=d(w(n.model.contact,6,[3]),t)),l}function Wt(e){let r=e.knots.length-1,n=e.degree+1;for(let t=r-1;t>=0;t-=1)for(let o=0;o<e.signals;o+=1){let s=e.coefficients.subarray((t*e.signals+o)*n,(t*e.signals+o+1)*n),a=e.knots[t+1]-e.knots[t],i=Math.max(...S(0,r).map(m=>Math.abs(e.coefficients[(m*e.signals+o)*n])),1e-12);if(s.some((m,u)=>u>0&&Math.abs(m)*a**u>1e-9*i))return t===r-1?null:e.knots[t+1];let c=t&&te(e,o,e.knots[t]-1e-9*a);if(t&&Math.abs(s[0]-c)>1e-6*i)return e.knots[t]}return 0}function zt(e,r,n,t){let o={...ie(r,n,t),...ce(n,r.length)},s=e.deformations.flatMap((c,m)=>c.endsWith(".gear")?[m]:[]),a=s.filter(c=>e.turning.includes(e.deformations[c].replace(/\\.gear$/,""))),i=a.length?a:s;if(i.length){let c=w(n.deformation.data,e.deformations.length,i),m=B(c),u=e.deformations[i[m%i.length]].replace(/\\.gear$/,"");o["gear.max"]={value:Math.abs(c[m]),note:`${u}, at ${k(r[Math.floor(m/i.length)])} s`}}let l=n.contact_force_normal?.data;if(l){let[c,m]=[l.reduce((u,f)=>Math.min(u,f)),l.reduce((u,f)=>Math.max(u,f))];o["contact.mean"]={value:U(r,l),note:`from ${k(c,4)} to ${k(m,4)} N`}}return o}var V=class{last=null;async of(r,n){if(this.last&&Dt(this.last.blocks,r))return this.last.made;this.last=null;let t=await n();return this.last={blocks:r,made:t},t}};function Dt(e,r){return Object.entries(e).every(([n,t])=>t.length===r[n].length&&t.every((o,s)=>o===r[n][s]))}var P=21;function Fe(e,r,n,t){let[o,s]=[n.length/P,t.length],a=new Float64Array(o*s),i=new Float64Array(o*s*P);for(let m=0;m<o;m+=1)for(let u=0;u<s;u+=1){let f=m*s+u;a[f]=t[u];for(let g=0;g<P;g+=1)i[f*P+g]=n[m*P+g]}let l={station:a,motion:i},c=[1,2].map(m=>e.sample(`real.line${m}`,r,l,o*s));return{stations:t,motion:n,parts:c}}function We(e){let r=e.length/6,n=new Float64Array(r*P);for(let t=0;t<r;t+=1)n.set(e.subarray(6*t,6*t+6),P*t);return n}function J(e,r){let[n,t]=[e.motion.length/P,e.stations.length],o=e.parts[0][r].length/(n*t),s=new Float64Array(n*2*t*o);return e.parts.forEach((a,i)=>{for(let l=0;l<n;l+=1)s.set(a[r].subarray(l*t*o,(l+1)*t*o),(2*l+i)*t*o)}),{data:s,shape:[n,2,t,o]}}function ze(e,r,n){let t=r.shape.slice(0,3),o=r.data.map((a,i)=>a-n.data[i]),s=a=>$(J(e,a).data,2);return[{id:"bending_moment",label:"Bending moment",unit:"N m",values:{data:s("bending_moment"),shape:t}},{id:"deflection",label:"Deflection from the root\'s tangent",unit:"m",values:{data:s("deflection"),shape:t}},{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:$(o,3),shape:t}}]}function De(e){let r=e.length/6,n=new Float64Array(r*8);for(let t=0;t<r;t+=1){let[o,,s,a]=e.subarray(6*t,6*t+6);n.set(Ie(s,0),8*t),n.set(Ie(o+(o-s)/2,a+a/2),8*t+4)}return{data:n,shape:[r,2,4]}}function Ie(e,r){let[n,t]=[Math.cos(e/2),Math.sin(e/2)],[o,s]=[Math.cos(r/2),Math.sin(r/2)];return[t*s,-n*s,t*o,n*o]}var Ce=["mode 1, horizontal","mode 2, horizontal","mode 1, vertical","mode 2, vertical","gear"],Ct=.2;function Ke(e,r,n,t){let o=r.deformation.data,s=B(o),a={...ie(e,r,t,Ct),"moment.max":n,"deformation.max":{value:Math.abs(o[s]),note:Ce[s%Ce.length]},"gear_torque.max":Ae(e,r.gear_torque.data),"voltage.max":Ae(e,r.voltage.data),...ce(r,e.length)},i=r.contact_force_radial?.data;if(i){let[l,c]=[i.reduce((m,u)=>Math.min(m,u)),i.reduce((m,u)=>Math.max(m,u))];a["contact.mean"]={value:U(e,i),note:`from ${k(l,4)} to ${k(c,4)} N`}}return a}function He(e,r,n){let t=Ge(r),o=Float64Array.from(t.s===0?[0]:[0,t.s]),{value:s,mode:a,s:i,plane:l,sample:c}=Ge(n(o)),m=i===0?"at the root":`at ${k(100*i)} % of its length`,u=`mode ${a+1}, ${m}, ${l?"vertical":"horizontal"} plane, at ${k(e[c])} s`;return{value:s,note:u}}function Ge(e){let r=e.stations.length,n=e.parts.map((t,o)=>{let s=B(t.bending_moment);return{value:Math.abs(t.bending_moment[s]),mode:o,s:e.stations[Math.floor(s/2)%r],plane:s%2,sample:Math.floor(s/(2*r))}});return n[1].value>n[0].value?n[1]:n[0]}var Gt=30,x=5;function we(e,r,n,t,o,s,a){let{free:i}=r,l=[0,1,2,3,4].filter(p=>!i.includes(p)),c=s.slice();for(let p=0;p<a;p+=1)for(let b of l)c[p*x+b]=0;let m=c.slice(),u=new Array(a).fill(!1),f=new Float64Array(a).fill(1/0),g=Array.from({length:a},(p,b)=>b);for(let p=0;p<Gt&&g.length;p+=1){let b=Kt(e,n,t,o,c,g,i);for(let h=0;h<g.length;h+=1){let y=g[h],[A,F]=[0,0];for(let E=0;E<x;E+=1){let q=b[h*x+E],_=c[y*x+E]-=q;p===0&&(m[y*x+E]=_),A=Math.max(A,Math.abs(q)),F=Math.max(F,Math.abs(_))}let v=A<=1e-14+1e-12*F||A<=1e-9*F&&A>=f[y]/2;u[y]=v&&F<Math.PI,f[y]=v?-1:A}g=g.filter(h=>f[h]>=0)}for(let p=0;p<a;p+=1)u[p]||c.set(m.subarray(p*x,(p+1)*x),p*x);return{angles:c,found:u}}function Kt(e,r,n,t,o,s,a){let[,[i,l]]=Object.entries(e.layout.samples[r].inputs),c={angles:Ue(o,x,s),[i]:Ue(t,l,s)},{residual:m,slope:u}=e.sample(r,n,c,s.length),f=a.length,[g,p]=[new Float64Array(f*f),new Float64Array(f)],b=new Float64Array(s.length*x);for(let h=0;h<s.length;h+=1){for(let y=0;y<f;y+=1){p[y]=m[h*x+a[y]];for(let A=0;A<f;A+=1)g[y*f+A]=u[h*x*x+a[A]*x+a[y]]}if(ee(g,p))for(let y=0;y<f;y+=1)b[h*x+a[y]]=p[y];else b.fill(1,h*x,(h+1)*x)}return b}function Ue(e,r,n){let t=new Float64Array(n.length*r);for(let o=0;o<n.length;o+=1)for(let s=0;s<r;s+=1)t[o*r+s]=e[n[o]*r+s];return t}var M=17,Ye=[1,0,1,0,0,1],Ht=[{id:"deflection",label:"Deflection",unit:"m"},{id:"slope",label:"Slope",unit:"rad"},{id:"bending_moment",label:"Bending moment",unit:"N m"},{id:"shear_force",label:"Shear force",unit:"N"}];async function Ze(e,r,n,t,o){let s=performance.now(),a=L=>({...t,progress:ue=>t.progress?.(L+ue/2)}),i=L=>z(r.map,n,L),l=i("reference"),c=await o.of(l,()=>Ve(e,r,l,"reference",a(0))),m=await Ve(e,r,i("real"),"real",a(.5)),u=Math.min(c.run.times.length,m.run.times.length),f=(performance.now()-s)/1e3,[g,p]=[Je(e,m,u),Je(e,c,u)],b=m.run.times.subarray(0,u),h=Vt(e,r,m,c,g,p,u),y=m.run.states.subarray(0,u*M),A=ye(u,w(y,M,S(0,12)),g.acceleration,g.contact_force),F=Z(r,u),v=(L,ue)=>Fe(e,m.numbers.parameters,L,ue),E=v(N(A,21,F),R(r.stations)),q=He(b,E,L=>v(A,L)),_=[c,m].find(L=>L.run.status!=="finished"),me=_===c?"reference":"real robot",ke=Ke(b,h,q,m.numbers.end[0]),xe=l.end[0];return{status:_?_.run.status:"finished",message:_?`${me}: ${_.run.message}`:m.run.message,seconds:f,times:b,series:h,...Jt(e,r,m,E,h,F),span:[r.steady[0]*xe,r.steady[1]*xe],facts:_?le(ke):ke}}async function Ve(e,r,n,t,o){let{settings:s}=r,a=K(G(n.knots,n.coefficients),s.duration),i=await Y(e,{loop:`${t}.${s.method}`,parameters:n.parameters,knots:a.knots,rows:re(a),state:Ut(e,r,t,n),times:R(r.times),settings:s},o);return{name:t,numbers:n,schedule:a,run:i}}function Ut(e,r,n,t){let{angles:o,found:s}=we(e,r,`${n}.rest`,t.parameters,t.start,new Float64Array(5),1);if(!s[0])throw new Error(`${n}: no static equilibrium; expected a link that carries its own load: raise a stiffness or lower a load`);let a=new Float64Array(M);for(let i=0;i<6;i+=1){a[i]=t.start[0]*Ye[i];for(let l=0;l<5;l+=1)a[i]+=r.basis.data[5*i+l]*o[l]}return a}function Je(e,r,n){let t=r.run.times.subarray(0,n),o=r.run.states.subarray(0,n*M),s=ne(r.schedule,t);return e.sample(`${r.name}.observe`,r.numbers.parameters,{time:t,state:o,row:s},n)}function Qe(e){return Float64Array.from({length:e.length},(r,n)=>e[6*Math.floor(n/6)+5]*Ye[n%6])}function Xe(e){let r=e.length/M,n=new Float64Array(r*5);for(let t=0;t<r;t+=1){let[o,s,a,i,l,c]=e.subarray(t*M,t*M+6);n.set([o-a,s-(o-a)/2,i,l-i/2,a-c],5*t)}return n}function Vt(e,r,n,t,o,s,a){let[i,l]=[n,t].map(h=>h.run.states.subarray(0,a*M)),[c,m,u]=[S(0,6),S(6,12),S(12,17)].map(h=>w(i,M,h)),f=Xe(i),g=ye(a,w(i,M,[5,11]),w(o.acceleration,6,[5]),o.contact_force),p=we(e,r,"real.quasistatic",n.numbers.parameters,g,f,a).angles,b={q:d(c,a,6),v:d(m,a,6),q_reference:d(w(l,M,S(0,6)),a,6),v_reference:d(w(l,M,S(6,12)),a,6),theta_wanted:d(o.wanted,a),voltage:d(o.voltage,a),current:d(o.current,a),tip:d(o.tip,a,3),tip_velocity:d(o.tip_velocity,a,3),tip_reference:d(s.tip,a,3),deviation:d($(H(o.tip,s.tip),3),a),deformation:d(f,a,5),deformation_reference:d(Xe(l),a,5),deformation_stationary:d(p,a,5),deformation_oscillatory:d(H(f,p),a,5),gear_torque:d(o.gear_torque,a),gear_torque_reference:d(s.gear_torque,a),energy:d(o.energy,a,4),work:d(u,a,5),energy_balance:d(oe(o.energy,u,a,1),a)};return r.contact?{...b,contact_force:d(o.contact_force,a,3),contact_force_radial:d(o.radial_force,a),contact_force_radial_reference:d(s.radial_force,a)}:b}function Jt(e,r,n,t,o,s){let{parameters:a}=n.numbers,i=A=>N(o[A].data,o[A].shape.slice(1).reduce((F,v)=>F*v,1),s),l=t.stations.length,c=i("q"),m=i("q_reference"),u=J(t,"line"),[f,g,p]=[Qe(c),m,Qe(m)].map(A=>J(Fe(e,a,We(A),t.stations),"line")),b=A=>({data:i(A),shape:[s.length,...o[A].shape.slice(1)]}),h={data:Float64Array.from({length:2*l},(A,F)=>r.lengths[Math.floor(F/l)]*t.stations[F%l]),shape:[2,l]},y={links:["Mode 1","Mode 2"],places:h,quantities:Ht.map(A=>({...A,planes:["horizontal","vertical"],values:J(t,A.id)}))};return{scene:{times:{data:N(n.run.times,1,s),shape:[s.length]},line:u,rigid:f,reference:g,referenceRigid:p,roots:De(c),tip:b("tip"),tipReference:b("tip_reference"),colours:ze(t,u,f),contact:r.contact?{force:b("contact_force"),at:b("tip")}:null},line:y}}async function et(e){let r=await Q.open(e.module.data,e.layout);if(e.kind==="arm"){let t=new V;return{run:(o,s)=>je(r,e,o,s,t)}}let n=new V;return{run:(t,o)=>Ze(r,e,t,o,n)}}var D=self,ve=null,rt=-1,tt=Promise.resolve();D.onmessage=({data:e})=>{if(e.kind==="open"){et(e.bundle).then(t=>{ve=t,D.postMessage({kind:"ready"})},t=>D.postMessage({kind:"failed",message:String(t)}));return}let{id:r,values:n}=e;rt=r,tt=tt.then(()=>Qt(r,n))};async function Qt(e,r){let n=()=>e!==rt;try{if(!ve)throw new Error("the live model is not open");if(await new Promise(o=>setTimeout(o,0)),n())throw new W("a newer run began");let t=await ve.run(r,{cancelled:n,progress:o=>D.postMessage({kind:"progress",id:e,share:o})});D.postMessage({kind:"done",id:e,run:t},he(t))}catch(t){let o=t instanceof Error?t.message:String(t);D.postMessage({kind:"error",id:e,cancelled:t instanceof W,message:o})}}})();\n';var Bi=class extends Error{name="EngineError"},dg=1,hb=65536,fb={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},Ol=class i{constructor(e,t,n,s){this.layout=e;this.functions=t;this.memory=n;this.free=s}layout;functions;memory;free;static async open(e,t){if(t.format!==dg)throw new Bi(`layout: got format ${t.format}; expected ${dg}`);let{instance:n}=await db(e,t),{memory:s,heap_base:r,...o}=n.exports,a=r.value;return new i(t,o,s,a)}sample(e,t,n,s){let r=Bl(this.layout.samples,e,"function");wr(`${e}: parameters`,t.length,r.parameters);let o=r.kind==="program"?this.program(r,t,n,s):this.schedule(r,t,[n],s);return lf(r.outputs,o,s,1)}slopes(e,t,n,s,r){let o=Bl(this.layout.samples,e,"function");if(o.kind!=="slopes")throw new Bi(`${e}: got a function without derivatives; expected one with them`);wr(`${e}: parameters`,t.length,o.parameters);let a=Object.fromEntries(Object.entries(o.inputs).map(([u,h])=>[u,new Float64Array(h)])),l=this.schedule(o,t,[n,{...a,...s}],r),c=ca(o.outputs);return{values:lf(o.outputs,l,r,2),slopes:lf(o.outputs,l.subarray(c),r,2)}}call(e,t){let n=t.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(n.reduce((a,l)=>a+(l?.byteLength??0),this.free));let s=new Float64Array(this.memory.buffer),r=this.free,o=t.map((a,l)=>{if(typeof a=="number")return BigInt(a);let c=r;return(a instanceof Float64Array||a.given)&&s.set(n[l],c/8),r+=n[l].byteLength,c});this.functions[e](...o),t.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[c,u]=a.range?.()??[0,a.into.length],h=o[l]/8;a.into.set(s.subarray(h+c,h+u),c)})}program(e,t,n,s){let r=Object.entries(e.inputs).map(([a,l])=>pg(a,l,n[a],s)),o=new Float64Array(s*ca(e.outputs));return this.call(e.export,[s,t,...r,{into:o}]),o}schedule(e,t,n,s){let r=pb(e.inputs,n,s),o=new Float64Array(s*n.length*ca(e.outputs)),a=new Float64Array(e.workspace);return this.call(e.export,[s,0,t,a,r,{into:o}]),o}reserve(e){let t=e-this.memory.buffer.byteLength;if(!(t<=0))try{this.memory.grow(Math.ceil(t/hb))}catch{throw new Bi(`memory: got no room for ${(e/1e6).toFixed(0)} MB; expected a browser that has it. Mend: ask for fewer samples`)}}};async function db(i,e){try{return await WebAssembly.instantiate(i,{env:fb})}catch(t){let n=e.simd?", with vectors (SIMD)":"";throw new Bi(`WebAssembly: got ${String(t)}; expected a browser that allows it${n}`)}}function Bl(i,e,t){if(!Object.hasOwn(i,e))throw new Bi(`${t}: got ${e}; expected one of ${Object.keys(i).join(", ")}`);return i[e]}function wr(i,e,t){if(e!==t)throw new Bi(`${i}: got ${e} numbers; expected ${t}`)}function ca(i){return Object.values(i).reduce((e,t)=>e+t,0)}function pg(i,e,t,n){if(t===void 0)throw new Bi(`${i}: got nothing; expected ${e} numbers for each sample`);if(t.length===n*e)return t;wr(i,t.length,e);let s=new Float64Array(n*e);return cf(t,0,0,s,e,0,e,n),s}function pb(i,e,t){let n=ca(i),s=new Float64Array(t*e.length*n);return e.forEach((r,o)=>{let a=o*n;for(let[l,c]of Object.entries(i)){let u=pg(l,c,r[l],t);cf(u,c,0,s,e.length*n,a,c,t),a+=c}}),s}function lf(i,e,t,n){let s=n*ca(i),r={},o=0;for(let[a,l]of Object.entries(i)){let c=new Float64Array(t*l);cf(e,s,o,c,l,0,l,t),r[a]=c,o+=l}return r}function cf(i,e,t,n,s,r,o,a){for(let l=0;l<a;l++){let c=l*e+t,u=l*s+r;for(let h=0;h<o;h++)n[u+h]=i[c+h]}}var mb=["rk4","midpoint"],gb=500,uf=class{constructor(e,t){this.engine=e;this.spec=t;let n=Bl(e.layout.loops,t.loop,"loop");wr(`${t.loop}: parameters`,t.parameters.length,n.parameters),wr(`${t.loop}: state`,t.state.length,n.size),wr(`${t.loop}: rows`,t.rows.length,(t.knots.length-1)*n.row),this.method=n.method,this.memory=new Float64Array(e.layout.cells.length),this.state=t.state.slice(),this.slope=new Float64Array(n.size),this.sums=new Float64Array(n.size),this.states=new Float64Array(t.times.length*n.size),this.sumsAtSamples=new Float64Array(t.times.length*n.size),this.states.set(t.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;sums;sumsAtSamples;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(e){return this.memory[this.engine.layout.cells.indexOf(e)]}put(e){for(let[t,n]of Object.entries(e))this.memory[this.engine.layout.cells.indexOf(t)]=n}advance(e){let{layout:t}=this.engine,{settings:n,knots:s,rows:r,times:o,parameters:a}=this.spec,l=Math.max(1,Math.min(e,n.maxSteps-this.tried)),c={step:n.step,rtol:n.relativeTolerance,atol:n.absoluteTolerance,chunk:l,bound:t.limits.bound,watch:0,most_events:t.limits.most_events,event_time:t.limits.event_time,looks:0},u=this.cell("sample"),h=m=>({into:m,range:()=>[u*this.state.length,this.cell("sample")*this.state.length]}),f=m=>({into:m,given:!0}),d={memory:f(this.memory),y:f(this.state),k1:f(this.slope),p:a,knots:s,rows:r,times:o,out:h(this.states),options:Float64Array.from(t.options,m=>c[m]),errors:f(this.sums),errors_out:h(this.sumsAtSamples),seen:new Float64Array(1),segments:s.length-1,samples:o.length};this.engine.call(t.loops[this.spec.loop].export,t.arguments.map(m=>d[m]))}result(){let e=this.cell("sample"),t=this.state.length,[n,s]=this.ending();return{status:n,message:s,times:this.spec.times.slice(0,e),states:this.states.slice(0,e*t),errors:this.sumsAtSamples.slice(0,e*t),statistics:this.statistics()}}statistics(){let[e,t,n]=[this.cell("steps"),this.cell("smallest"),this.time],s=e?n/e:null,r={steps:e,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:s,smallest_step_s:t>0?t:s};return mb.includes(this.method)&&(r.step=this.cell("h")),this.cell("passes")&&(r.passes=this.cell("passes")),this.cell("events")&&(r.contact_changes=this.cell("events")),r}ending(){let{statuses:e,limits:t}=this.engine.layout,{settings:n}=this.spec,[s,r]=[this.cell("status"),`t = ${uo(this.time,6)} s`];if(s===e.finished)return["finished",`reached the end, t = ${uo(n.duration,6)} s`];if(s===e.running)return["stopped",`stopped at ${r} of ${uo(n.duration,6)} s: integration.max_steps = ${n.maxSteps} is used up`];if(s===e.chattering){let o=`more than ${t.most_events} times within ${t.event_time} s`;return["chattering",`stopped at ${r}: the contact set in or ended ${o}; give the surface damping, or a lower stiffness`]}return this.lost(s,r)}lost(e,t){let{statuses:n,coordinates:s,limits:r}=this.engine.layout,o=s.length,a=Array.from(this.rates().subarray(o,2*o),d=>Number.isFinite(d)?Math.abs(d):1/0),l=a.indexOf(Math.max(...a)),u=a[l]<r.bound?e===n.not_converged?"not_converged":e===n.step_too_small?"step_too_small":"diverged":"diverged",h=`its acceleration is ${uo(a[l],3)} rad/s^2`,f=u.replaceAll("_"," ");return[u,`${f} at ${t} in coordinate ${s[l]}: ${h}; its last step was of ${uo(this.cell("h"),3)} s`]}rates(){let{loop:e,parameters:t,rows:n}=this.spec,{row:s}=this.engine.layout.loops[e],r=Math.min(this.cell("segment"),n.length/s-1),o={time:Float64Array.of(this.time),state:this.state,row:n.slice(r*s,(r+1)*s),step:new Float64Array(1)};return this.engine.sample(`${e.slice(0,e.lastIndexOf("."))}.rate`,t,o,1).rate}},ua=class extends Bi{name="Cancelled"};async function kl(i,e,t={}){let n=new uf(i,e),s=1e3*(t.piece??.05),r=gb,o=performance.now();for(;n.running;){let a=performance.now();n.advance(r);let l=performance.now();if(r=Math.max(1,Math.floor(r*Math.min(4,s/Math.max(l-a,.001)))),!(l-o<s)){if(t.progress?.(n.time/e.settings.duration),await new Promise(c=>setTimeout(c,0)),t.cancelled?.())throw new ua(`the run was given up at t = ${uo(n.time,6)} s`);o=performance.now()}}return n.result()}function uo(i,e){return String(Number(i.toPrecision(e)))}function zl(i,e){let t=Array.from(i.frames.data).filter(n=>n<e);return t[t.length-1]!==e-1&&t.push(e-1),t}function mi(i){return i.data instanceof Float64Array?i.data:Float64Array.from(i.data)}function Vl(i,e){let t=e.length;for(let n=0;n<t;n+=1){let s=n;for(let o=n+1;o<t;o+=1)Math.abs(i[o*t+n])>Math.abs(i[s*t+n])&&(s=o);let r=Math.abs(i[s*t+n]);if(!(r>0)||r===1/0)return!1;s!==n&&_b(i,e,n,s);for(let o=n+1;o<t;o+=1){let a=i[o*t+n]/i[n*t+n];if(a!==0){for(let l=n+1;l<t;l+=1)i[o*t+l]-=a*i[n*t+l];e[o]-=a*e[n]}}}for(let n=t-1;n>=0;n-=1){for(let s=n+1;s<t;s+=1)e[n]-=i[n*t+s]*e[s];e[n]/=i[n*t+n]}return!0}function _b(i,e,t,n){let s=e.length;for(let o=0;o<s;o+=1){let a=i[t*s+o];i[t*s+o]=i[n*s+o],i[n*s+o]=a}let r=e[t];e[t]=e[n],e[n]=r}function yb(i,e,t){let n=i.knobs.map(r=>r.start),s=i.knobs.map(r=>r.factor);return i.sliders.forEach((r,o)=>{r.real?s[r.knob]=e[o]:n[r.knob]=e[o]}),t==="reference"?n:i.knobs.map((r,o)=>{let a=s[o];return a===null||r.factor===null?n[o]:r.together?r.factor?n[o]*(a/r.factor):n[o]:n[o]*a})}function ho(i,e,t){let n=i.runs[t],s=xb(n,yb(i,e,t)),r={};for(let[o,a]of Object.entries(n.places)){let l=a.shape.reduce((c,u)=>c*u,1);r[o]=s.slice(a.start,a.start+l)}return r}function xb(i,e){let t=mi(i.base).slice(),n=i.powers.map(l=>mg(l,(c,u)=>Math.pow(e[c]/i.variables[c].start,u))),s=i.powers.map(l=>mg(l,(c,u)=>vb(i.variables[c],u,e[c]))),{products:r,terms:o,coefficients:a}=i;for(let l=0;l<r.data.length;l+=2)t[r.data[l]]*=n[r.data[l+1]];for(let l=0;l<o.data.length;l+=2)t[o.data[l]]+=a.data[l/2]*s[o.data[l+1]];return t}function mg(i,e){return i.reduce((t,[n,s])=>t*e(n,s),1)}function vb(i,e,t){let n=Math.pow(i.start,e);return(Math.pow(t,e)-n)/(Math.pow(i.far,e)-n)}function ha(i,e){return{knots:i,coefficients:e,signals:1,degree:e.length/(i.length-1)-1}}function fa(i,e){let t=i.degree+1,n=i.knots.length-1,s=0;for(;s<n&&i.knots[s]<e;)s+=1;let r=i.knots[n],o=[...i.knots.subarray(0,s)],a=[...i.coefficients.subarray(0,s*t)];return e>r&&(o.push(r),a.push(gg(i,n-1,0,r),...new Array(i.degree).fill(0))),ha(Float64Array.from([...o,e]),Float64Array.from(a))}function gg(i,e,t,n){let s=i.degree+1,r=(e*i.signals+t)*s,o=n-i.knots[e],a=0;for(let l=i.degree;l>=0;l-=1)a=a*o+i.coefficients[r+l];return a}function hf(i,e){let[t,n]=[0,i.length-1];for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return t}function Gl(i,e,t){return gg(i,hf(i.knots,t),e,t)}function Hl(i){return _g(i,Array.from({length:i.knots.length-1},(e,t)=>t))}function Wl(i,e){return _g(i,Array.from(e,t=>hf(i.knots,t)))}function _g(i,e){let t=i.signals*(i.degree+1),n=new Float64Array(e.length*(t+1));return e.forEach((s,r)=>{n[r*(t+1)]=i.knots[s],n.set(i.coefficients.subarray(s*t,(s+1)*t),r*(t+1)+1)}),n}function yg(i){if(!i.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let e=Math.max(...i.map(o=>o.knots[o.knots.length-1])),t=i.map(o=>o.knots[o.knots.length-1]<e?fa(o,e):o),n=bb(t.flatMap(o=>[...o.knots])),s=Math.max(...t.map(o=>o.degree)),r=new Float64Array((n.length-1)*i.length*(s+1));return t.forEach((o,a)=>{for(let l=0;l<n.length-1;l+=1){let c=(l*i.length+a)*(s+1);Sb(o,n,l,r.subarray(c,c+s+1))}}),{knots:n,coefficients:r,signals:i.length,degree:s}}function bb(i){let e=[...new Set(i)].sort((s,r)=>s-r),t=e[e.length-1]-e[0],n=e.filter((s,r)=>r===0||s-e[r-1]>1e-12*t);return n[n.length-1]=e[e.length-1],Float64Array.from(n)}function Sb(i,e,t,n){let s=hf(i.knots,(e[t]+e[t+1])/2),r=e[t]-i.knots[s],o=Math.abs(r)<=1e-12*(e[e.length-1]-e[0])?0:r;for(let a=0;a<=i.degree;a+=1){let l=i.coefficients[s*(i.degree+1)+a],c=1;for(let u=a;u>=0;u-=1)n[u]+=c*l*Math.pow(o,a-u),c=c*u/(a-u+1)}}var Mb=40,wb=1e-12,Ab=.5,vg=1e-6,bg=8;function Eb(i,e,t,n,s,r){let[o,a,l]=[n.length+1,t.length,e.rotors.length],c=new Float64Array(o*a);for(let f=0;f<o;f+=1)c.set(t,f*a),f&&(c[f*a+n[f-1]]+=vg);let u={time:new Float64Array(1),state:c,row:e.rest_row,step:new Float64Array(1)},{rate:h}=i.sample("rest.rate",e.rest,u,o);for(let f=0;f<n.length;f+=1){r[f]=h[l+n[f]];for(let d=0;d<n.length;d+=1)s[f*n.length+d]=(h[(d+1)*a+l+n[f]]-r[f])/vg}}function Tb(i,e,t,n){let s=i.layout.held,r=n.length,o=Array.from({length:r},(h,f)=>f).filter(h=>!s.includes(h)),a=new Float64Array(e.restSize);a.set(n);let l=new Float64Array(o.length**2),c=new Float64Array(o.length),u=1/0;for(let h=0;h<Mb&&o.length;h+=1){if(Eb(i,t,a,o,l,c),!Vl(l,c))return null;let f=c.reduce((m,_)=>Math.max(m,Math.abs(_)),0);if(!Number.isFinite(f))return null;let d=Math.min(1,Ab/f);for(let m=0;m<o.length;m+=1)a[o[m]]-=d*c[m];if(f<wb||f<1e-9&&f>=u/2)return a.slice(0,r);u=f}return o.length?null:a.slice(0,r)}function Rb(i,e,t,n,s){let r=(c,u)=>Tb(i,e,ho(e.map,c,n),u),o=r(t,s);if(o)return o;let a=e.sliders.map(c=>c.value),l=s;for(let c=1;c<=bg&&l;c+=1)l=r(t.map((u,h)=>a[h]+(u-a[h])*(c/bg)),l);if(!l)throw new Error(`${n}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`);return l}function Sg(i,e,t,n,s){let r=e.runs[n],o=mi(r.start).slice(),[a,l]=[r.state.q[0],r.state.v[0]];if(e.atRest){let c=Rb(i,e,t,n,o.slice(...r.state.q));for(let u=0;u<c.length;u+=1)r.told.includes(u)||(o[a+u]=c[u])}for(let[c,u]of r.exact){o[a+c]=Gl(s,u,0);let h=s.degree;o[l+c]=h?s.coefficients[u*(h+1)+1]:0}return o}function Rn(i,e,t){let n=i.length/e,s=new Float64Array(n*t.length);for(let r=0;r<n;r+=1)for(let o=0;o<t.length;o+=1)s[r*t.length+o]=i[r*e+t[o]];return s}function Gn(i,e){return Array.from({length:e-i},(t,n)=>i+n)}function qs(i,e,t){let n=new Float64Array(t.length*e);for(let s=0;s<t.length;s+=1)for(let r=0;r<e;r+=1)n[s*e+r]=i[t[s]*e+r];return n}function ff(i,...e){let t=e.map(o=>o.length/i),n=t.reduce((o,a)=>o+a,0),s=new Float64Array(i*n),r=0;return e.forEach((o,a)=>{for(let l=0;l<i;l+=1)for(let c=0;c<t[a];c+=1)s[l*n+r+c]=o[l*t[a]+c];r+=t[a]}),s}function da(i,e){return i.map((t,n)=>t-e[n])}function ki(i,e){let t=new Float64Array(i.length/e);for(let n=0;n<t.length;n+=1){let s=0;for(let r=0;r<e;r+=1)s+=i[n*e+r]**2;t[n]=Math.sqrt(s)}return t}function Xl(i,e,t,n){let s=i.length/t,r=e.length/t,o=new Float64Array(t),a=0;for(let l=0;l<t;l+=1){let c=0;for(let u=0;u<s;u+=1)c+=i[l*s+u];l===0&&(a=c),o[l]=c-a;for(let u=0;u<r;u+=1)o[l]+=(u<n?-1:1)*e[l*r+u]}return o}function zi(i){let e=0;for(let t=1;t<i.length;t+=1)Math.abs(i[t])>Math.abs(i[e])&&(e=t);return e}function Je(i,e,...t){return{data:i,shape:[e,...t]}}var ql=24,Cb=5e5,Pb=2e4;function $l(i,e,t){let[n,s]=i.matrix.shape,r=new Float64Array(t*n);for(let o=0;o<t;o+=1)for(let a=0;a<n;a+=1){let l=i.constant.data[a];for(let c=0;c<s;c+=1)l+=i.matrix.data[a*s+c]*e[o*s+c];r[o*n+a]=l}return r}function Mg(i,e,t,n,s,r){let o=g=>qs(n[g].data,n[g].shape.slice(1).reduce((p,b)=>p*b,1),r),a=r.length,l=df(i,e,t,o("q"),a),c=g=>df(i,e,t,g,a).line,u=g=>c($l(e.straight,g,a)),h=u(o("q")),f=g=>({data:o(g),shape:[a,...n[g].shape.slice(1)]}),d="q_reference"in n,m=l.line.shape.slice(0,3),_=l.line.data.map((g,p)=>g-h.data[p]);return{times:{data:qs(s,1,r),shape:[a]},line:l.line,rigid:h,roots:l.roots,reference:d?c(o("q_reference")):null,referenceRigid:d?u(o("q_reference")):null,colours:[{id:"deflection",label:"Deflection from the root's tangent",unit:"m",values:{data:l.bent,shape:m}},{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:ki(_,3),shape:m}}],tip:f("tip"),tipReference:d?f("tip_reference"):null,contact:e.contactPoint<0?null:{force:f("contact_force"),at:Ib(e,n,r)}}}function wg(i,e,t,n,s){let[r,o]=[e.links.length,e.stations.data.length];if(!e.links.some(u=>u.bends)||s*r*o>Cb)return null;let[a,l]=[n.length/s,Math.max(1,Math.floor(Pb/(r*o)))],c={link:"",value:-1,sample:0};for(let u=0;u<s;u+=l){let h=Math.min(l,s-u),{bent:f}=df(i,e,t,n.subarray(u*a,(u+h)*a),h);for(let d=0;d<h;d+=1)e.links.forEach((m,_)=>{let g=f[(d*r+_+1)*o-1];m.bends&&g>c.value&&(c={link:m.name,value:g,sample:u+d})})}return c}function Ib(i,e,t){let n=e.position.shape[1],s=qs(e.position.data,3*n,t),r=new Float64Array(3*t.length);for(let o=0;o<t.length;o+=1)for(let a=0;a<3;a+=1)r[3*o+a]=s[3*(o*n+i.contactPoint)+a];return{data:r,shape:[t.length,3]}}function df(i,e,t,n,s){let r=new Float64Array(n.length/s),{points:o}=i.sample("pose",t,{q:n,v:r,a:r,base:mi(e.base)},s),[a,l]=[e.links.length,e.stations.data.length],c=o.length/s/ql,u=new Float64Array(s*a*l*3),h=new Float64Array(s*a*4),f=new Float64Array(s*a*l);for(let d=0;d<s;d+=1)e.links.forEach((m,_)=>{let g=o.subarray((d*c+m.point)*ql,(d*c+m.point+1)*ql);h.set(Nb(g),(d*a+_)*4),d&&Lb(h,(d*a+_)*4,4*a);for(let p=0;p<l;p+=1){let b=((d*a+_)*l+p)*3,T=(d*c+m.point+p)*ql+9;for(let x=0;x<3;x+=1)u[b+x]=m.bends?o[T+x]:Db(g,mi(m.end),x,e.stations.data[p]);m.bends&&(f[b/3]=Fb(g,u,b))}});return{line:{data:u,shape:[s,a,l,3]},roots:{data:h,shape:[s,a,4]},bent:f}}function Lb(i,e,t){let n=0;for(let s=e;s<e+4;s+=1)n+=i[s]*i[s-t];if(n<0)for(let s=e;s<e+4;s+=1)i[s]*=-1}function Db(i,e,t,n){return i[9+t]+n*(i[3*t]*e[0]+i[3*t+1]*e[1]+i[3*t+2]*e[2])}function Fb(i,e,t){let n=[0,1,2].map(r=>e[t+r]-i[9+r]),s=[1,2].map(r=>i[r]*n[0]+i[3+r]*n[1]+i[6+r]*n[2]);return Math.hypot(s[0],s[1])}function Nb(i){let e=i[0]+i[4]+i[8];if(e>0){let n=2*Math.sqrt(1+e);return[(i[7]-i[5])/n,(i[2]-i[6])/n,(i[3]-i[1])/n,n/4]}if(i[0]>i[4]&&i[0]>i[8]){let n=2*Math.sqrt(1+i[0]-i[4]-i[8]);return[n/4,(i[1]+i[3])/n,(i[2]+i[6])/n,(i[7]-i[5])/n]}if(i[4]>i[8]){let n=2*Math.sqrt(1+i[4]-i[0]-i[8]);return[(i[1]+i[3])/n,n/4,(i[5]+i[7])/n,(i[2]-i[6])/n]}let t=2*Math.sqrt(1+i[8]-i[0]-i[4]);return[(i[2]+i[6])/t,(i[5]+i[7])/t,t/4,(i[3]-i[1])/t]}var Ag=.05,Ub=8,Ob=["settling","vibration.residual"];function Fn(i,e=3){return String(Number(i.toPrecision(e)))}function pa(i,e){if(i.length<2)return e[0];let t=0;for(let n=1;n<i.length;n+=1)t+=(e[n]+e[n-1])/2*(i[n]-i[n-1]);return t/(i[i.length-1]-i[0])}function Yl(i,e,t,n=0){let s={},r=e.deviation?.data;if(r){let o=zi(r),a=r[r.length-1];s["deviation.max"]={value:r[o],note:`at ${Fn(i[o])} s; ${Fn(a)} m at the end of the run`},s["deviation.rms"]={value:Math.sqrt(pa(i,r.map(l=>l*l))),note:"over the run"},s.settling=Bb(i,r,t,n)}return s["vibration.residual"]=kb(i,e,t),s}function Bb(i,e,t,n){if(t===null)return{value:null,note:"not seen: what moves the robot changes up to the end of the run"};if(i[i.length-1]<=t*(1+1e-9))return{value:null,note:"not seen here: the run ends with the move"};let r=Ag*e[zi(e)],o=-1;for(let c=0;c<i.length;c+=1)i[c]>t&&e[c]>r&&(o=c);if(o===i.length-1)return{value:null,note:"not seen: it swings to the end of the run"};let a=i.length-i.findIndex(c=>c>t);if(i.length-1-o<n*a)return{value:null,note:"not seen: the run ends too soon after the move"};let l=`until the tip stays within ${Fn(r)} m, ${100*Ag} % of its largest deviation`;return{value:o<0?0:i[o]-t,note:l}}function Zl(i){let e={};for(let[t,{value:n,note:s}]of Object.entries(i))Ob.includes(t)?e[t]={value:null,note:"the run broke off"}:e[t]={value:n,note:`until it broke off: ${s}`};return e}function kb(i,e,t){if(t===null)return{value:null,note:"what moves the robot changes up to the end of the run"};let n=i.findIndex(l=>l>t*(1+1e-9));if(n<0||i.length-n<Ub)return{value:null,note:"the run ends with the move"};let s=e.tip_reference?.data,r=e.tip.data.map((l,c)=>l-(s?s[c]:0)).subarray(3*n),o=[0,1,2].map(l=>r.reduce((c,u,h)=>h%3===l?c+u:c,0)/(r.length/3)),a=ki(r.map((l,c)=>l-o[c%3]),3);return{value:a[zi(a)],note:`about its mean place, from ${Fn(i[n])} s on`}}function Jl(i,e){if(!i.energy||!i.energy_balance)return{};let{energy:t,work:n}=i,s=t.shape[1],r=Math.max(t.data.reduce((l,c,u)=>Math.max(l,Math.abs(c-t.data[u%s])),0),n.data.reduce((l,c)=>Math.max(l,Math.abs(c)),0)),o=Math.abs(i.energy_balance.data[zi(i.energy_balance.data.subarray(0,e))]),a=r?`worst residual, ${Fn(o)} J, over ${Fn(r)} J moved`:"nothing moved";return{"energy.residual":{value:r?o/r:null,note:a}}}function pf(i,e,t=1){let n=zi(e);return{value:Math.abs(e[n]),note:`at ${Fn(i[Math.floor(n/t)])} s`}}var as=24,zb=32;async function Eg(i,e,t,n,s){let r=performance.now(),o=e.runs.reference?["reference","real"]:["real"],a=[];for(let[T,x]of o.entries()){let R={...n,progress:E=>n.progress?.((T+E)/o.length)},w=ho(e.map,t,x),y=()=>Hb(i,e,t,x,w,R);a.push(await(x==="reference"?s.of(w,y):y()))}let l=a[a.length-1],c=(performance.now()-r)/1e3,u=Math.min(...a.map(T=>T.run.times.length)),[h,f]=[l,...a.slice(0,-1)].map(T=>Wb(i,e,T,u)),d=l.run.times.subarray(0,u),m={...qb(e,l,h,u),...f?$b(e,h,f,u):{}},_=zl(e,u),g=Yb(l.schedule),p=a.find(T=>T.run.status!=="finished"),b={...Zb(e,d,m,g),...Gb(wg(i,e,l.blocks.pose,h.model.q,u),d)};return{status:p?p.run.status:"finished",message:p?`${p===l?"real arm":"reference"}: ${p.run.message}`:l.run.message,seconds:c,times:d,series:m,scene:Mg(i,e,l.blocks.pose,m,d,_),line:null,span:Vb(d,g),facts:p?Zl(b):b}}function Vb(i,e){let t=i[i.length-1],n=e===null?-1:i.findIndex(s=>s>=e*(1+1e-9));return[n>=0&&i.length-n>=zb?i[n]:i[0],t]}function Gb(i,e){return i?{"deflection.max":{value:i.value,note:`${i.link}, at ${Fn(e[i.sample])} s`}}:{}}async function Hb(i,e,t,n,s,r){let{settings:o}=e,a=e.runs[n],l=Gn(0,a.signals).map(h=>fa(ha(s[`knots.${h}`],s[`coefficients.${h}`]),o.duration)),c=yg(l);l.length||(c.knots[1]=o.duration);let u=await kl(i,{loop:`${n}.${o.method}`,parameters:s.parameters,knots:c.knots,rows:Hl(c),state:Sg(i,e,t,n,c),times:mi(e.times),settings:o},r);return{name:n,told:a,blocks:s,schedule:c,run:u}}function Wb(i,e,t,n){let s=t.run.times.subarray(0,n),r=t.run.states.subarray(0,n*(t.run.states.length/t.run.times.length)),o=Wl(t.schedule,s),a={time:s,state:r,row:o,step:new Float64Array(1)},l=i.sample(`${t.name}.observe`,t.blocks.parameters,a,n),{q:c,v:u,a:h}=l,f=mi(e.base),{chain:d,rotors:m}=t.blocks,{points:_}=i.sample("inertia",d,{q:c,v:u,a:h,base:f},n),g=new Float64Array(m.length),p=i.sample("inertia",d,{q:c,v:g,a:u,base:f},n),b=i.sample("elastic",d,{q:c,v:u,base:f},n).energies;return{model:l,points:_,energy:Xb(e,u,m,p,b,n)}}function Xb(i,e,t,n,s,r){let o=t.length,a=s.length/r,l=new Float64Array(4*r);for(let c=0;c<r;c+=1){for(let u=0;u<o;u+=1){let h=e[c*o+u];l[4*c]+=(n.forces[c*o+u]+t[u]*h)*h/2}for(let u=0;u<3;u+=1)l[4*c+1]-=n.moment[3*c+u]*i.gravity.data[u];for(let u=0;u<a;u+=1)l[4*c+2+u%2]+=s[c*a+u]}return l}function qb(i,e,{model:t,points:n,energy:s},r){let o=t.q.length/r,a=t.gear.length/r,l=n.length/r/as,c=e.run.states.length/e.run.times.length,u=Rn(e.run.states.subarray(0,r*c),c,Gn(...e.told.state.works)),h=g=>Je(Rn(t.drives,4*a,Gn(0,a).map(p=>4*p+g)),r,a),f=g=>Rn(n,l*as,Gn(0,l).flatMap(p=>Gn(0,3).map(b=>p*as+g+b))),d=Rn(n,l*as,Gn(0,l).flatMap(g=>Gn(g*as,g*as+9))),m={q:Je(t.q,r,o),v:Je(t.v,r,o),a:Je(t.a,r,o),deformation:Je($l(i.deflections,t.q,r),r,i.deformations.length),position:Je(f(9),r,l,3),velocity:Je(f(12),r,l,3),acceleration:Je(f(18),r,l,3),rotation:Je(d,r,l,3,3),tip:Je(Rn(n,l*as,[9,10,11]),r,3),tip_velocity:Je(Rn(n,l*as,[12,13,14]),r,3),energy:Je(s,r,4),work:Je(u,r,u.length/r),energy_balance:Je(Xl(s,u,r,3),r)};if(a&&Object.assign(m,{wanted:h(3),effort:h(0),gear_torque:Je(t.gear,r,a)}),a&&i.electric&&Object.assign(m,{voltage:h(1),current:h(2)}),i.contactPoint<0)return m;let _=g=>Rn(t.contact,6,g);return{...m,contact_force:Je(_([0,1,2]),r,3),contact_force_normal:Je(_([3]),r),penetration:Je(_([4]),r)}}function $b(i,e,t,n){let s=t.model.q.length/n,r=t.points.length/n/as,[o,a]=[e,t].map(({points:c})=>Rn(c,r*as,[9,10,11])),l={q_reference:Je(t.model.q,n,s),v_reference:Je(t.model.v,n,s),deformation_reference:Je($l(i.deflections,t.model.q,n),n,i.deformations.length),gear_torque_reference:Je(t.model.gear,n,t.model.gear.length/n),tip_reference:Je(a,n,3),deviation:Je(ki(da(o,a),3),n)};return i.contactPoint>=0&&(l.contact_force_normal_reference=Je(Rn(t.model.contact,6,[3]),n)),l}function Yb(i){let e=i.knots.length-1,t=i.degree+1;for(let n=e-1;n>=0;n-=1)for(let s=0;s<i.signals;s+=1){let r=i.coefficients.subarray((n*i.signals+s)*t,(n*i.signals+s+1)*t),o=i.knots[n+1]-i.knots[n],a=Math.max(...Gn(0,e).map(u=>Math.abs(i.coefficients[(u*i.signals+s)*t])),1e-12);if(r.some((u,h)=>h>0&&Math.abs(u)*o**h>1e-9*a))return n===e-1?null:i.knots[n+1];let c=n&&Gl(i,s,i.knots[n]-1e-9*o);if(n&&Math.abs(r[0]-c)>1e-6*a)return i.knots[n]}return 0}function Zb(i,e,t,n){let s={...Yl(e,t,n),...Jl(t,e.length)},r=i.deformations.flatMap((c,u)=>c.endsWith(".gear")?[u]:[]),o=r.filter(c=>i.turning.includes(i.deformations[c].replace(/\.gear$/,""))),a=o.length?o:r;if(a.length){let c=Rn(t.deformation.data,i.deformations.length,a),u=zi(c),h=i.deformations[a[u%a.length]].replace(/\.gear$/,"");s["gear.max"]={value:Math.abs(c[u]),note:`${h}, at ${Fn(e[Math.floor(u/a.length)])} s`}}let l=t.contact_force_normal?.data;if(l){let[c,u]=[l.reduce((h,f)=>Math.min(h,f)),l.reduce((h,f)=>Math.max(h,f))];s["contact.mean"]={value:pa(e,l),note:`from ${Fn(c,4)} to ${Fn(u,4)} N`}}return s}var ma=class{last=null;async of(e,t){if(this.last&&Jb(this.last.blocks,e))return this.last.made;this.last=null;let n=await t();return this.last={blocks:e,made:n},n}};function Jb(i,e){return Object.entries(i).every(([t,n])=>n.length===e[t].length&&n.every((s,r)=>s===e[t][r]))}var $s=21;function mf(i,e,t,n){let[s,r]=[t.length/$s,n.length],o=new Float64Array(s*r),a=new Float64Array(s*r*$s);for(let u=0;u<s;u+=1)for(let h=0;h<r;h+=1){let f=u*r+h;o[f]=n[h];for(let d=0;d<$s;d+=1)a[f*$s+d]=t[u*$s+d]}let l={station:o,motion:a},c=[1,2].map(u=>i.sample(`real.line${u}`,e,l,s*r));return{stations:n,motion:t,parts:c}}function Rg(i){let e=i.length/6,t=new Float64Array(e*$s);for(let n=0;n<e;n+=1)t.set(i.subarray(6*n,6*n+6),$s*n);return t}function ga(i,e){let[t,n]=[i.motion.length/$s,i.stations.length],s=i.parts[0][e].length/(t*n),r=new Float64Array(t*2*n*s);return i.parts.forEach((o,a)=>{for(let l=0;l<t;l+=1)r.set(o[e].subarray(l*n*s,(l+1)*n*s),(2*l+a)*n*s)}),{data:r,shape:[t,2,n,s]}}function Cg(i,e,t){let n=e.shape.slice(0,3),s=e.data.map((o,a)=>o-t.data[a]),r=o=>ki(ga(i,o).data,2);return[{id:"bending_moment",label:"Bending moment",unit:"N m",values:{data:r("bending_moment"),shape:n}},{id:"deflection",label:"Deflection from the root's tangent",unit:"m",values:{data:r("deflection"),shape:n}},{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:ki(s,3),shape:n}}]}function Pg(i){let e=i.length/6,t=new Float64Array(e*8);for(let n=0;n<e;n+=1){let[s,,r,o]=i.subarray(6*n,6*n+6);t.set(Tg(r,0),8*n),t.set(Tg(s+(s-r)/2,o+o/2),8*n+4)}return{data:t,shape:[e,2,4]}}function Tg(i,e){let[t,n]=[Math.cos(i/2),Math.sin(i/2)],[s,r]=[Math.cos(e/2),Math.sin(e/2)];return[n*r,-t*r,n*s,t*s]}var Ig=["mode 1, horizontal","mode 2, horizontal","mode 1, vertical","mode 2, vertical","gear"],Kb=.2;function Dg(i,e,t,n){let s=e.deformation.data,r=zi(s),o={...Yl(i,e,n,Kb),"moment.max":t,"deformation.max":{value:Math.abs(s[r]),note:Ig[r%Ig.length]},"gear_torque.max":pf(i,e.gear_torque.data),"voltage.max":pf(i,e.voltage.data),...Jl(e,i.length)},a=e.contact_force_radial?.data;if(a){let[l,c]=[a.reduce((u,h)=>Math.min(u,h)),a.reduce((u,h)=>Math.max(u,h))];o["contact.mean"]={value:pa(i,a),note:`from ${Fn(l,4)} to ${Fn(c,4)} N`}}return o}function Fg(i,e,t){let n=Lg(e),s=Float64Array.from(n.s===0?[0]:[0,n.s]),{value:r,mode:o,s:a,plane:l,sample:c}=Lg(t(s)),u=a===0?"at the root":`at ${Fn(100*a)} % of its length`,h=`mode ${o+1}, ${u}, ${l?"vertical":"horizontal"} plane, at ${Fn(i[c])} s`;return{value:r,note:h}}function Lg(i){let e=i.stations.length,t=i.parts.map((n,s)=>{let r=zi(n.bending_moment);return{value:Math.abs(n.bending_moment[r]),mode:s,s:i.stations[Math.floor(r/2)%e],plane:r%2,sample:Math.floor(r/(2*e))}});return t[1].value>t[0].value?t[1]:t[0]}var jb=30,Nn=5;function gf(i,e,t,n,s,r,o){let{free:a}=e,l=[0,1,2,3,4].filter(m=>!a.includes(m)),c=r.slice();for(let m=0;m<o;m+=1)for(let _ of l)c[m*Nn+_]=0;let u=c.slice(),h=new Array(o).fill(!1),f=new Float64Array(o).fill(1/0),d=Array.from({length:o},(m,_)=>_);for(let m=0;m<jb&&d.length;m+=1){let _=Qb(i,t,n,s,c,d,a);for(let g=0;g<d.length;g+=1){let p=d[g],[b,T]=[0,0];for(let R=0;R<Nn;R+=1){let w=_[g*Nn+R],y=c[p*Nn+R]-=w;m===0&&(u[p*Nn+R]=y),b=Math.max(b,Math.abs(w)),T=Math.max(T,Math.abs(y))}let x=b<=1e-14+1e-12*T||b<=1e-9*T&&b>=f[p]/2;h[p]=x&&T<Math.PI,f[p]=x?-1:b}d=d.filter(g=>f[g]>=0)}for(let m=0;m<o;m+=1)h[m]||c.set(u.subarray(m*Nn,(m+1)*Nn),m*Nn);return{angles:c,found:h}}function Qb(i,e,t,n,s,r,o){let[,[a,l]]=Object.entries(i.layout.samples[e].inputs),c={angles:Ng(s,Nn,r),[a]:Ng(n,l,r)},{residual:u,slope:h}=i.sample(e,t,c,r.length),f=o.length,[d,m]=[new Float64Array(f*f),new Float64Array(f)],_=new Float64Array(r.length*Nn);for(let g=0;g<r.length;g+=1){for(let p=0;p<f;p+=1){m[p]=u[g*Nn+o[p]];for(let b=0;b<f;b+=1)d[p*f+b]=h[g*Nn*Nn+o[b]*Nn+o[p]]}if(Vl(d,m))for(let p=0;p<f;p+=1)_[g*Nn+o[p]]=m[p];else _.fill(1,g*Nn,(g+1)*Nn)}return _}function Ng(i,e,t){let n=new Float64Array(t.length*e);for(let s=0;s<t.length;s+=1)for(let r=0;r<e;r+=1)n[s*e+r]=i[t[s]*e+r];return n}var Ei=17,zg=[1,0,1,0,0,1],eS=[{id:"deflection",label:"Deflection",unit:"m"},{id:"slope",label:"Slope",unit:"rad"},{id:"bending_moment",label:"Bending moment",unit:"N m"},{id:"shear_force",label:"Shear force",unit:"N"}];async function Vg(i,e,t,n,s){let r=performance.now(),o=I=>({...n,progress:k=>n.progress?.(I+k/2)}),a=I=>ho(e.map,t,I),l=a("reference"),c=await s.of(l,()=>Ug(i,e,l,"reference",o(0))),u=await Ug(i,e,a("real"),"real",o(.5)),h=Math.min(c.run.times.length,u.run.times.length),f=(performance.now()-r)/1e3,[d,m]=[Og(i,u,h),Og(i,c,h)],_=u.run.times.subarray(0,h),g=nS(i,e,u,c,d,m,h),p=u.run.states.subarray(0,h*Ei),b=ff(h,Rn(p,Ei,Gn(0,12)),d.acceleration,d.contact_force),T=zl(e,h),x=(I,k)=>mf(i,u.numbers.parameters,I,k),R=x(qs(b,21,T),mi(e.stations)),w=Fg(_,R,I=>x(b,I)),y=[c,u].find(I=>I.run.status!=="finished"),E=y===c?"reference":"real robot",O=Dg(_,g,w,u.numbers.end[0]),L=l.end[0];return{status:y?y.run.status:"finished",message:y?`${E}: ${y.run.message}`:u.run.message,seconds:f,times:_,series:g,...iS(i,e,u,R,g,T),span:[e.steady[0]*L,e.steady[1]*L],facts:y?Zl(O):O}}async function Ug(i,e,t,n,s){let{settings:r}=e,o=fa(ha(t.knots,t.coefficients),r.duration),a=await kl(i,{loop:`${n}.${r.method}`,parameters:t.parameters,knots:o.knots,rows:Hl(o),state:tS(i,e,n,t),times:mi(e.times),settings:r},s);return{name:n,numbers:t,schedule:o,run:a}}function tS(i,e,t,n){let{angles:s,found:r}=gf(i,e,`${t}.rest`,n.parameters,n.start,new Float64Array(5),1);if(!r[0])throw new Error(`${t}: no static equilibrium; expected a link that carries its own load: raise a stiffness or lower a load`);let o=new Float64Array(Ei);for(let a=0;a<6;a+=1){o[a]=n.start[0]*zg[a];for(let l=0;l<5;l+=1)o[a]+=e.basis.data[5*a+l]*s[l]}return o}function Og(i,e,t){let n=e.run.times.subarray(0,t),s=e.run.states.subarray(0,t*Ei),r=Wl(e.schedule,n);return i.sample(`${e.name}.observe`,e.numbers.parameters,{time:n,state:s,row:r},t)}function Bg(i){return Float64Array.from({length:i.length},(e,t)=>i[6*Math.floor(t/6)+5]*zg[t%6])}function kg(i){let e=i.length/Ei,t=new Float64Array(e*5);for(let n=0;n<e;n+=1){let[s,r,o,a,l,c]=i.subarray(n*Ei,n*Ei+6);t.set([s-o,r-(s-o)/2,a,l-a/2,o-c],5*n)}return t}function nS(i,e,t,n,s,r,o){let[a,l]=[t,n].map(g=>g.run.states.subarray(0,o*Ei)),[c,u,h]=[Gn(0,6),Gn(6,12),Gn(12,17)].map(g=>Rn(a,Ei,g)),f=kg(a),d=ff(o,Rn(a,Ei,[5,11]),Rn(s.acceleration,6,[5]),s.contact_force),m=gf(i,e,"real.quasistatic",t.numbers.parameters,d,f,o).angles,_={q:Je(c,o,6),v:Je(u,o,6),q_reference:Je(Rn(l,Ei,Gn(0,6)),o,6),v_reference:Je(Rn(l,Ei,Gn(6,12)),o,6),theta_wanted:Je(s.wanted,o),voltage:Je(s.voltage,o),current:Je(s.current,o),tip:Je(s.tip,o,3),tip_velocity:Je(s.tip_velocity,o,3),tip_reference:Je(r.tip,o,3),deviation:Je(ki(da(s.tip,r.tip),3),o),deformation:Je(f,o,5),deformation_reference:Je(kg(l),o,5),deformation_stationary:Je(m,o,5),deformation_oscillatory:Je(da(f,m),o,5),gear_torque:Je(s.gear_torque,o),gear_torque_reference:Je(r.gear_torque,o),energy:Je(s.energy,o,4),work:Je(h,o,5),energy_balance:Je(Xl(s.energy,h,o,1),o)};return e.contact?{..._,contact_force:Je(s.contact_force,o,3),contact_force_radial:Je(s.radial_force,o),contact_force_radial_reference:Je(r.radial_force,o)}:_}function iS(i,e,t,n,s,r){let{parameters:o}=t.numbers,a=b=>qs(s[b].data,s[b].shape.slice(1).reduce((T,x)=>T*x,1),r),l=n.stations.length,c=a("q"),u=a("q_reference"),h=ga(n,"line"),[f,d,m]=[Bg(c),u,Bg(u)].map(b=>ga(mf(i,o,Rg(b),n.stations),"line")),_=b=>({data:a(b),shape:[r.length,...s[b].shape.slice(1)]}),g={data:Float64Array.from({length:2*l},(b,T)=>e.lengths[Math.floor(T/l)]*n.stations[T%l]),shape:[2,l]},p={links:["Mode 1","Mode 2"],places:g,quantities:eS.map(b=>({...b,planes:["horizontal","vertical"],values:ga(n,b.id)}))};return{scene:{times:{data:qs(t.run.times,1,r),shape:[r.length]},line:h,rigid:f,reference:d,referenceRigid:m,roots:Pg(c),tip:_("tip"),tipReference:_("tip_reference"),colours:Cg(n,h,f),contact:e.contact?{force:_("contact_force"),at:_("tip")}:null},line:p}}async function Gg(i){let e=await Ol.open(i.module.data,i.layout);if(i.kind==="arm"){let n=new ma;return{run:(s,r)=>Eg(e,i,s,r,n)}}let t=new ma;return{run:(n,s)=>Vg(e,i,n,s,t)}}function Hg(i,e){let t=i.map(s=>typeof s=="object"&&"parts"in s&&sS(s.optional,e)),n=i.some((s,r)=>t[r]&&typeof s=="object"&&"optional"in s&&s.optional>=0);return i.map((s,r)=>typeof s=="string"?s:"header"in s?n?s.header:"":t[r]?s.parts.map(o=>typeof o=="string"?o:rS(o,e)).join(""):"").join("")}function sS(i,e){return i<0||e[i]!==1}function rS(i,e){let t=e[i.slider];return oS(i.base===null?t:i.base*t)}function oS(i){let[e,t]=String(i).split("e"),n=e.includes(".")?e:`${e}.0`;return t===void 0?n:`${n}e${t}`}var fo=class extends Error{name="Superseded"};async function Wg(i){let e=i,t=await lS(e)??await aS(e),n=s=>{if(s.length!==e.sliders.length||!s.every(Number.isFinite))throw new Error(`values: got ${s.length}; expected ${e.sliders.length} finite numbers, one of each slider`)};return{sliders:e.sliders,async run(s,r=()=>{}){return n(s),t.run(s,r)},sheet(s){return n(s),Hg(e.sheet,s)},close:()=>t.close()}}async function aS(i){let e=await Gg(i),t=0,n=Promise.resolve();return{async run(s,r){let o=t+=1,a=()=>o!==t,l=n.then(()=>{if(a())throw new fo("a newer run began");return e.run(s,{cancelled:a,progress:r})});n=l.catch(()=>{});try{return await l}catch(c){throw c instanceof ua?new fo(c.message):c}},close:()=>t+=1}}async function lS(i){if(typeof Worker>"u"||typeof document>"u")return null;let e=URL.createObjectURL(new Blob([fg],{type:"text/javascript"}));try{let t=new Worker(e);if(await cS(t,i))return uS(t);t.terminate()}catch{}finally{URL.revokeObjectURL(e)}return null}function cS(i,e){return new Promise(t=>{i.onmessage=({data:n})=>t(n.kind==="ready"),i.onerror=()=>t(!1),i.postMessage({kind:"open",bundle:e})})}function uS(i){let e=0,t=null,n=s=>{t?.reject(s),t=null};return i.onerror=s=>n(new Error(s.message)),i.onmessage=({data:s})=>{!("id"in s)||s.id!==e||!t||(s.kind==="progress"?t.progress(s.share):s.kind==="error"?n(new Error(s.message)):s.kind==="done"&&(t.resolve(s.run),t=null))},{run(s,r){return n(new fo("a newer run began")),e+=1,i.postMessage({kind:"run",id:e,values:s}),new Promise((o,a)=>t={resolve:o,reject:a,progress:r})},close(){n(new fo("the live model was closed")),i.terminate()}}}function Xg(i,e){let t=n=>{i.replaceChildren(e.runs.length>1?dS(e,n):hS(e.runs[0].facts,n))};return t(null),{show:t}}function hS(i,e){return ce("dl",{class:"facts"},...i.map(t=>{let n=e?.facts[t.id],s=ce("dd",{},ce("strong",{text:Hs(n?n.value:t.value,t.unit)}));n?s.append(ce("span",{class:"was",text:`${fS(t,n.value)} was ${Hs(t.value,t.unit)}`})):e&&s.append(ce("span",{class:"was",text:"of the original run"}));let r=(n?n.note:t.note)||"";return ce("div",{"data-fact":t.id},ce("dt",{text:t.name}),s,r?ce("dd",{class:"note",text:r}):null)}))}function fS(i,e){if(e===null||i.value===null||i.value===0)return"";let t=100*(e-i.value)/Math.abs(i.value);return Math.abs(t)<.05?"":`${t>0?"+":"−"}${Math.abs(t)>=1e3?"1000 % and more":`${Number(Math.abs(t).toPrecision(2))} %`},`}function dS(i,e){let t=new Map;for(let o of i.runs.flatMap(a=>a.facts))t.has(o.id)||t.set(o.id,o);let n=ce("tr",{},ce("td",{}),...i.runs.map(o=>ce("th",{scope:"col",text:o.name}))),s=[...t.values()].map(o=>ce("tr",{"data-fact":o.id},ce("th",{scope:"row",text:o.name}),...i.runs.map((a,l)=>{let c=a.facts.find(f=>f.id===o.id),u=l===0?e?.facts[o.id]:void 0,h=u?u.value:c?.value??null;return ce("td",{class:"number",text:Hs(h,c?.unit??o.unit),title:(u??c)?.note||void 0})}))),r=ce("table",{},ce("thead",{},n),ce("tbody",{},...s));return ce("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Numbers of the runs"},r)}var $g=150,pS="The changed run's elastic line is not computed here; reset the sliders to see the original one.",qg="12px system-ui, sans-serif";function Yg(i,e,t){let n=e.runs[0].line,s=e.runs[0].scene.times.data,r=[],o=!1,a=!1,l=ce("div",{class:"line-grid"}),c=ce("p",{class:"note"});i.append(c,l);function u(){a=!1,r.forEach(({plot:p})=>p.destroy()),l.replaceChildren(),r=n===null?[]:n.quantities.map(p=>_S(l,n,p)),n===null&&(c.textContent=pS),h()}function h(){if(n===null||a||!o)return;let p=gS(s,t.time);c.textContent=`${n.links.join(", ")}: along the links from root to tip, at ${si(s[p],4)} s. The scales are those of the whole run.`;let b=Zg(n);for(let{plot:T,quantity:x,factor:R}of r){let w=x.planes.map((y,E)=>mS(n,x.values,p,E,x.planes.length,R));T.setData([b,...w],!1)}}let f=matchMedia("(prefers-color-scheme: dark)"),d=()=>r.forEach(({plot:p})=>p.redraw());f.addEventListener("change",d);let m=new ResizeObserver(()=>r.forEach(({plot:p})=>{let b=p.root.parentElement?.clientWidth??0;b>0&&b!==p.width&&p.setSize({width:b,height:$g})}));m.observe(l);let _=new IntersectionObserver(p=>{o=p.some(b=>b.isIntersecting),o&&a?u():h()});_.observe(i);let g=t.subscribe(h);return u(),{show(p){n=p?p.line:e.runs[0].line,s=p?p.scene.times.data:e.runs[0].scene.times.data,a=!0,o&&u()},dispose(){g(),m.disconnect(),_.disconnect(),f.removeEventListener("change",d),r.forEach(({plot:p})=>p.destroy()),i.replaceChildren()}}}function Zg(i){let e=i.places.shape[1],t=[],n=0;for(let s=0;s<i.links.length;s+=1){for(let r=0;r<e;r+=1)t.push(n+i.places.data[s*e+r]+(r===0&&s>0?1e-9:0));n=t[t.length-1]}return t}function mS(i,e,t,n,s,r){let o=i.links.length*i.places.shape[1],a=t*o*s;return Array.from({length:o},(l,c)=>r*e.data[a+c*s+n])}function gS(i,e){let t=0,n=i.length-1;for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return Math.abs(i[n]-e)<Math.abs(i[t]-e)?n:t}function _S(i,e,t){let[n,s]=[0,0];for(let g of t.values.data)[n,s]=[Math.min(n,g),Math.max(s,g)];let r=Th(t.unit,Math.max(-n,s)),o=t.planes.map((g,p)=>ta("real",p,!0,1)),a=ce("div",{class:"plot-area",role:"img","aria-label":`${t.label} along the links, between ${Kn(n*r.factor)} and ${Kn(s*r.factor)} ${r.name}`}),l=ce("div",{class:"legend"},...t.planes.map((g,p)=>ce("span",{class:"key"},xl(`var(${o[p].property})`,o[p].dash),ce("span",{text:g})))),c=ce("h4",{text:t.label},ce("span",{class:"unit",text:` [${r.name||"–"}]`}));i.append(ce("figure",{class:"chart"},ce("figcaption",{},c,l),a));let u=.06*(s-n)||1,h={stroke:()=>rs("--grid"),width:1},f={stroke:()=>rs("--quiet"),font:qg,grid:h,ticks:{...h,size:4}},d=Zg(e),m=e.links.slice(1).map((g,p)=>d[(p+1)*e.places.shape[1]]);return{plot:new dn({width:Math.max(a.clientWidth,120),height:$g,legend:{show:!1},padding:[8,14,0,0],cursor:{show:!1},scales:{x:{time:!1},y:{range:[(n-u)*r.factor,(s+u)*r.factor]}},axes:[{...f,label:"along the links [m]",labelSize:18,labelFont:qg,size:30,values:(g,p)=>p.map(Kn)},{...f,size:(g,p)=>16+7*Math.max(2,...(p??[]).map(b=>b.length)),values:(g,p)=>p.map(Kn)}],series:[{},...o.map(g=>({stroke:()=>rs(g.property),dash:g.dash,width:1.6,points:{show:!1}}))],hooks:{draw:[g=>yS(g,m)]}},[d,...o.map(()=>d.map(()=>0))],a),quantity:t,factor:r.factor}}function yS(i,e){let{ctx:t,bbox:n}=i;t.save(),t.strokeStyle=rs("--quiet"),t.setLineDash([3,3]);for(let s of e){let r=i.valToPos(s,"x",!0);t.beginPath(),t.moveTo(r,n.top),t.lineTo(r,n.top+n.height),t.stroke()}t.restore()}var xS={controlled:"under control",locked:"motors held",free:"motors free"},vS=.12;function _f(i,e,t,n){let s=e.runs[0].modes,r=[...new Set(s.map(p=>p.case))],o=null,a=vS,l=ce("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Modes"}),c=Ms("case"),u=ce("select",{id:c},...r.map(p=>ce("option",{value:p,text:xS[p]??p})));u.addEventListener("change",()=>m(u.value));let h=ce("input",{type:"range",min:"0.02",max:"0.3",step:"0.01",value:String(a),id:Ms("size")});h.addEventListener("input",()=>{a=Number(h.value),o&&t.showMode(o,a)});let f=Tn("back to the motion",()=>d(null),{hidden:!0});function d(p){o=p,p&&n.pause(),t.showMode(p,a),f.hidden=p===null,m(u.value)}function m(p){let b=["Frequency [Hz]","Damping [%]","Lives in",""].map(x=>ce(x?"th":"td",x?{scope:"col",text:x}:{})),T=s.filter(x=>x.case===p).map(x=>{let R=`Show the mode of ${si(x.frequency)} Hz in 3D`,w=Tn(x===o?"stop":"show",()=>d(x===o?null:x),{"aria-pressed":String(x===o),"aria-label":x===o?"Stop showing the mode":R});return ce("tr",{},ce("td",{class:"number",text:si(x.frequency)}),ce("td",{class:"number",text:si(100*x.damping,3)}),ce("td",{text:x.livesIn}),ce("td",{},w))});l.replaceChildren(ce("table",{},ce("thead",{},ce("tr",{},...b)),ce("tbody",{},...T)))}let _=ce("div",{class:"bar"},ce("label",{for:c,text:"Modes"}),u,ce("label",{for:h.id,text:"amplitude"}),h,f);i.append(_,l),m(r[0]??"");let g=n.subscribe(p=>{p.playing&&o&&d(null)});return{dispose(){g(),i.replaceChildren()}}}function Jg(i,e){for(let t of e.runs){if(!t.sheet)continue;let n=e.runs.length>1?`Save the YAML of ${t.name}`:"Save the YAML of this run";i.append(Tn(n,()=>Qr(t.sheet,`${yf(t.name)}.yaml`,"application/yaml"),{class:"save-yaml"}))}}function yf(i){return i.replace(/[^\p{L}\p{N}._-]+/gu,"_").replace(/^[._]+/,"").slice(0,80)||"run"}var xf=1e3;function Kg(i,e){let t=Ms("slider"),n=Eh(i.unit),s=ce("input",{type:"range",id:t,min:"0",max:String(xf),step:"1"}),r=ce("input",{type:"number","aria-label":`${i.label}${n?`, in ${n}`:""}`,step:"any",min:String(i.min),max:String(i.max)}),o=Tn("↺",u,{class:"tool","aria-label":`${i.label}: back to ${si(i.value,6)} ${n}`,title:"back to the run's own"}),a=i.value;function l(d=!1){s.value=String(Math.round(xf*bS(i,a))),s.setAttribute("aria-valuetext",`${si(a,5)} ${n}`),d||(r.value=String(Number(a.toPrecision(6)))),o.disabled=a===i.value,f.classList.toggle("changed",a!==i.value)}function c(d,m=!1){let _=Math.min(Math.max(d,i.min),i.max);if(_===a)return l(m);a=_,l(m),e()}function u(){c(i.value),s.focus()}s.addEventListener("input",()=>c(Number(si(SS(i,Number(s.value)/xf),4)))),r.addEventListener("input",()=>{r.value!==""&&Number.isFinite(r.valueAsNumber)&&c(r.valueAsNumber,!0)}),r.addEventListener("change",()=>l());let h=ce("label",{for:t},ce("span",{text:i.label}),ce("i",{text:i.symbol?` ${i.symbol}`:""})),f=ce("div",{class:"slider","data-path":i.path},h,ce("div",{class:"slider-row"},s,r,ce("span",{class:"unit",text:n}),o));return l(),{element:f,slider:i,get value(){return a},set value(d){a=d,l()}}}function bS(i,e){let{min:t,max:n}=i;return n<=t?0:i.log&&t>0?Math.log(e/t)/Math.log(n/t):(e-t)/(n-t)}function SS(i,e){let{min:t,max:n}=i;return i.log&&t>0?t*(n/t)**e:t+e*(n-t)}var MS=300;function jg(i,e,t){let n=ce("p",{class:"note",role:"status","aria-live":"polite",text:"starts …"}),s=ce("progress",{max:"1",value:"0",hidden:!0,"aria-label":"Progress of the simulation"}),r=Tn("reset all",()=>{p(null),a[0]?.element.querySelector("input")?.focus()},{disabled:!0}),o=Tn("Save YAML",()=>l&&Qr(l.sheet(m()),`${t.fileName}.yaml`,"application/yaml"),{disabled:!0}),a=e.sliders.map(x=>Kg(x,g)),l=null,c=!1,u=0,h=0,f=0,d=!1,m=()=>a.map(x=>x.value),_=()=>a.every(x=>x.value===x.slider.value);function g(){r.disabled=_(),d?h||(h=requestAnimationFrame(()=>{b()})):b()}function p(x){a.forEach((R,w)=>{R.value=x?x[w]:R.slider.value}),g()}async function b(){if(h=0,!l)return;let x=u+=1;if(_()){T(),t.show(null),n.textContent="The run as it was.",n.classList.remove("warned"),l.run(m()).catch(()=>{});return}d=!0,f||(f=window.setTimeout(()=>{s.hidden=!1},MS));try{let R=await l.run(m(),y=>{x===u&&(s.value=y)});if(x!==u||c)return;t.show(R);let w=R.status==="finished"?"Simulated":`${R.status}: ${R.message}; simulated`;n.textContent=`${w} in ${Hs(R.seconds,"s")}; the run as it was is pale.`,n.classList.toggle("warned",R.status!=="finished"),T()}catch(R){if(x!==u||c||R instanceof Error&&R.name==="Superseded")return;T(),t.show(null);let w=(R instanceof Error?R.message:String(R)).replace(/\.$/,"");n.textContent=`This could not be simulated: ${w}; shown is the run as it was.`,n.classList.add("warned")}}function T(){d=!1,clearTimeout(f),f=0,s.hidden=!0,s.value=0}return i.append(ce("div",{class:"bar"},ce("h3",{text:"What if"}),r,o),n,s,...wS(a),...AS(e)),t.open(e).then(x=>{if(c)return x.close();l=x,o.disabled=!1,n.textContent="Move a slider: the robot is simulated anew, here in the page.",_()||g()},x=>{n.textContent=`Nothing can be changed here, the robot's equations could not be started: ${x instanceof Error?x.message:String(x)}`,a.forEach(R=>R.element.remove()),r.remove()}),{dispose(){c=!0,cancelAnimationFrame(h),T(),l?.close(),i.replaceChildren()}}}function wS(i){return[...new Set(i.map(t=>t.slider.group))].map(t=>ce("fieldset",{},ce("legend",{text:t}),...i.filter(n=>n.slider.group===t).map(n=>n.element)))}function AS(i){let e=i.settings,t=Array.isArray(i.leftOut)?i.leftOut:[];return[...typeof e?.note=="string"&&e.note?[e.note]:[],...t.length?[`Not offered: ${t.map(({path:s,reason:r})=>`${String(s)} (${String(r)})`).join("; ")}.`]:[]].map(s=>ce("p",{class:"note",text:s}))}var ES=[.05,.1,.2,.5,1,2],Kl=1e3,Qg=1/200;function e0(i,e){let t=Tn("",()=>e.toggle(),{class:"play"}),n=ce("input",{type:"range",min:"0",max:String(Kl),step:"1","aria-label":"Time",class:"scrub"}),s=ce("output",{class:"time","aria-live":"off"}),r=Ms("speed"),o=ce("select",{id:r},...ES.map(h=>ce("option",{value:String(h),text:`${h}×`,selected:h===e.speed})));n.addEventListener("input",()=>e.seek(Number(n.value)/Kl*e.duration)),o.addEventListener("change",()=>{e.speed=Number(o.value)});let a=Math.max(3,Math.ceil(-Math.log10(e.duration||1))+3),l=()=>{let h=e.duration>0?e.time/e.duration:0;(document.activeElement!==n||Number(n.value)!==Math.round(h*Kl))&&(n.value=String(Math.round(h*Kl))),n.setAttribute("aria-valuetext",`${e.time.toFixed(a)} s`),s.textContent=`${e.time.toFixed(a)} s of ${si(e.duration)} s`;let f=e.playing?"Pause":"Play";t.getAttribute("aria-label")!==f&&(t.setAttribute("aria-label",f),t.title=`${f} (space)`,t.textContent=e.playing?"❚❚":"▶")},c=h=>{if(h.defaultPrevented||h.ctrlKey||h.metaKey||h.altKey||TS(h))return;let d={" ":()=>e.toggle(),ArrowRight:()=>e.seek(e.time+(h.shiftKey?10:1)*Qg*e.duration),ArrowLeft:()=>e.seek(e.time-(h.shiftKey?10:1)*Qg*e.duration)}[h.key];d&&(h.preventDefault(),d())};document.addEventListener("keydown",c),i.append(t,n,s,ce("label",{for:r,text:"speed"}),o);let u=e.subscribe(l);return l(),{dispose(){u(),document.removeEventListener("keydown",c),i.replaceChildren()}}}function TS(i){let e=i.target;return e instanceof HTMLElement?e.isContentEditable||e.closest("input, select, textarea, canvas, [role=tablist]")?!0:i.key===" "?e.closest("button, a, summary")!==null:e.closest(".scroll")!==null:!1}var ar={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},lr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},L0=0,Zf=1,D0=2;var Dr=1,F0=2,zo=3,cr=0,ni=1,Ii=2,Fr=0,Vo=1,Jf=2,Kf=3,jf=4,N0=5;var Nr=100,U0=101,O0=102,B0=103,k0=104,z0=200,V0=201,G0=202,H0=203,Qf=204,ed=205,W0=206,X0=207,q0=208,$0=209,Y0=210,Z0=211,J0=212,K0=213,j0=214,Mc=0,wc=1,Ac=2,Po=3,Ec=4,Tc=5,Rc=6,Cc=7,nu=0,Q0=1,e_=2,fs=0,td=1,nd=2,id=3,sd=4,rd=5,od=6,ad=7;var ld=300,Ur=301,Go=302,iu=303,su=304,Pc=1e3,cs=1001,Ic=1002,In=1003,t_=1004;var el=1005;var ti=1006,ru=1007;var Fs=1008;var oi=1009,cd=1010,ud=1011,Ho=1012,ou=1013,$i=1014,Yi=1015,Zi=1016,au=1017,lu=1018,Or=1020,hd=35902,fd=35899,dd=1021,pd=1022,Ji=1023,Ls=1026,Ns=1027,md=1028,cu=1029,ur=1030,uu=1031;var hu=1033,tl=33776,nl=33777,il=33778,sl=33779,fu=35840,du=35841,pu=35842,mu=35843,gu=36196,_u=37492,yu=37496,xu=37488,vu=37489,rl=37490,bu=37491,Su=37808,Mu=37809,wu=37810,Au=37811,Eu=37812,Tu=37813,Ru=37814,Cu=37815,Pu=37816,Iu=37817,Lu=37818,Du=37819,Fu=37820,Nu=37821,Uu=36492,Ou=36494,Bu=36495,ku=36283,zu=36284,ol=36285,Vu=36286;var Aa=2300,Lc=2301,bc=2302,Gf=2303,Hf=2400,Wf=2401,Xf=2402;var n_=3200;var al=0,i_=1,Us="",yi="srgb",Ea="srgb-linear",Ta="linear",Et="srgb";var Sc=7680;var s_=519,r_=512,o_=513,a_=514,gd=515,l_=516,c_=517,_d=518,yd=519,xd=35044,vd=35048;var bd="300 es",Ri=2e3,Io=2001;function RS(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function CS(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ra(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function u_(){let i=Ra("canvas");return i.style.display="block",i}var t0={},Lo=null;function Ca(...i){let e="THREE."+i.shift();Lo?Lo("log",e,...i):console.log(e,...i)}function h_(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function $e(...i){i=h_(i);let e="THREE."+i.shift();if(Lo)Lo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function tt(...i){i=h_(i);let e="THREE."+i.shift();if(Lo)Lo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Sa(...i){let e=i.join(" ");e in t0||(t0[e]=!0,$e(...i))}function f_(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var d_={[Mc]:Mc,[Ac]:Rc,[Ec]:Ec,[Po]:Tc,[wc]:wc,[Rc]:Ac,[Cc]:Cc,[Tc]:Po},Wi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Hn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],n0=1234567,Ma=Math.PI/180,Do=180/Math.PI;function hr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Hn[i&255]+Hn[i>>8&255]+Hn[i>>16&255]+Hn[i>>24&255]+"-"+Hn[e&255]+Hn[e>>8&255]+"-"+Hn[e>>16&15|64]+Hn[e>>24&255]+"-"+Hn[t&63|128]+Hn[t>>8&255]+"-"+Hn[t>>16&255]+Hn[t>>24&255]+Hn[n&255]+Hn[n>>8&255]+Hn[n>>16&255]+Hn[n>>24&255]).toLowerCase()}function ot(i,e,t){return Math.max(e,Math.min(t,i))}function Sd(i,e){return(i%e+e)%e}function PS(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function IS(i,e,t){return i!==e?(t-i)/(e-i):0}function wa(i,e,t){return(1-t)*i+t*e}function LS(i,e,t,n){return wa(i,e,1-Math.exp(-t*n))}function DS(i,e=1){return e-Math.abs(Sd(i,e*2)-e)}function FS(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function NS(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function US(i,e){return i+Math.floor(Math.random()*(e-i+1))}function OS(i,e){return i+Math.random()*(e-i)}function BS(i){return i*(.5-Math.random())}function kS(i){i!==void 0&&(n0=i);let e=n0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function zS(i){return i*Ma}function VS(i){return i*Do}function GS(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function HS(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Md(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function WS(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),f=o((e-n)/2),d=r((n-e)/2),m=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*u,a*c);break;default:$e("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Gu(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function wd(i,e){if(e.constructor===Float32Array)return i;let t=Gu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Ad(i,e){if(e.constructor===Float32Array)return i;let t=Gu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Ki={DEG2RAD:Ma,RAD2DEG:Do,generateUUID:hr,clamp:ot,euclideanModulo:Sd,mapLinear:PS,inverseLerp:IS,lerp:wa,damp:LS,pingpong:DS,smoothstep:FS,smootherstep:NS,randInt:US,randFloat:OS,randFloatSpread:BS,seededRandom:kS,degToRad:zS,radToDeg:VS,isPowerOfTwo:GS,ceilPowerOfTwo:HS,floorPowerOfTwo:Md,setQuaternionFromProperEuler:WS,normalize:Ad,denormalize:wd},Ze=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ot(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ln=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],d=r[o+1],m=r[o+2],_=r[o+3];if(h!==_||l!==f||c!==d||u!==m){let g=l*f+c*d+u*m+h*_;g<0&&(f=-f,d=-d,m=-m,_=-_,g=-g);let p=1-a;if(g<.9995){let b=Math.acos(g),T=Math.sin(b);p=Math.sin(p*b)/T,a=Math.sin(a*b)/T,l=l*p+f*a,c=c*p+d*a,u=u*p+m*a,h=h*p+_*a}else{l=l*p+f*a,c=c*p+d*a,u=u*p+m*a,h=h*p+_*a;let b=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=b,c*=b,u*=b,h*=b}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],d=r[o+2],m=r[o+3];return e[t]=a*m+u*h+l*d-c*f,e[t+1]=l*m+u*f+c*h-a*d,e[t+2]=c*m+u*d+a*f-l*h,e[t+3]=u*m-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),d=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"YXZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"ZXY":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"ZYX":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"YZX":this._x=f*u*h+c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h-f*d*m;break;case"XZY":this._x=f*u*h-c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h+f*d*m;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-n-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ot(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(i0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(i0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this.z=ot(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this.z=ot(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return vf.copy(this).projectOnVector(e),this.sub(vf)}reflect(e){return this.sub(vf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ot(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},vf=new B,i0=new Ln,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],m=n[8],_=s[0],g=s[3],p=s[6],b=s[1],T=s[4],x=s[7],R=s[2],w=s[5],y=s[8];return r[0]=o*_+a*b+l*R,r[3]=o*g+a*T+l*w,r[6]=o*p+a*x+l*y,r[1]=c*_+u*b+h*R,r[4]=c*g+u*T+h*w,r[7]=c*p+u*x+h*y,r[2]=f*_+d*b+m*R,r[5]=f*g+d*T+m*w,r[8]=f*p+d*x+m*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,m=t*h+n*f+s*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return e[0]=h*_,e[1]=(s*c-u*n)*_,e[2]=(a*n-s*o)*_,e[3]=f*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=d*_,e[7]=(n*l-c*t)*_,e[8]=(o*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Sa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(bf.makeScale(e,t)),this}rotate(e){return Sa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(bf.makeRotation(-e)),this}translate(e,t){return Sa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(bf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},bf=new nt,s0=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),r0=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function XS(){let i={enabled:!0,workingColorSpace:Ea,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Et&&(s.r=Is(s.r),s.g=Is(s.g),s.b=Is(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Et&&(s.r=Co(s.r),s.g=Co(s.g),s.b=Co(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Us?Ta:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ea]:{primaries:e,whitePoint:n,transfer:Ta,toXYZ:s0,fromXYZ:r0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:yi},outputColorSpaceConfig:{drawingBufferColorSpace:yi}},[yi]:{primaries:e,whitePoint:n,transfer:Et,toXYZ:s0,fromXYZ:r0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:yi}}}),i}var yt=XS();function Is(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Co(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var po,Dc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{po===void 0&&(po=Ra("canvas")),po.width=e.width,po.height=e.height;let s=po.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=po}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ra("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Is(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Is(t[n]/255)*255):t[n]=Is(t[n]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},qS=0,Fo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:qS++}),this.uuid=hr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Sf(s[o].image)):r.push(Sf(s[o]))}else r=Sf(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Sf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Dc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var $S=0,Mf=new B,ri=class i extends Wi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=cs,s=cs,r=ti,o=Fs,a=Ji,l=oi,c=i.DEFAULT_ANISOTROPY,u=Us){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:$S++}),this.uuid=hr(),this.name="",this.source=new Fo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ze(0,0),this.repeat=new Ze(1,1),this.center=new Ze(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Mf).x}get height(){return this.source.getSize(Mf).y}get depth(){return this.source.getSize(Mf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ld)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Pc:e.x=e.x-Math.floor(e.x);break;case cs:e.x=e.x<0?0:1;break;case Ic:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Pc:e.y=e.y-Math.floor(e.y);break;case cs:e.y=e.y<0?0:1;break;case Ic:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ri.DEFAULT_IMAGE=null;ri.DEFAULT_MAPPING=ld;ri.DEFAULT_ANISOTROPY=1;var Tt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],m=l[9],_=l[2],g=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-_)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+_)<.1&&Math.abs(m+g)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,x=(d+1)/2,R=(p+1)/2,w=(u+f)/4,y=(h+_)/4,E=(m+g)/4;return T>x&&T>R?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=w/n,r=y/n):x>R?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=w/s,r=E/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=y/r,s=E/r),this.set(n,s,r,t),this}let b=Math.sqrt((g-m)*(g-m)+(h-_)*(h-_)+(f-u)*(f-u));return Math.abs(b)<.001&&(b=1),this.x=(g-m)/b,this.y=(h-_)/b,this.z=(f-u)/b,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this.z=ot(this.z,e.z,t.z),this.w=ot(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this.z=ot(this.z,e,t),this.w=ot(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Fc=class extends Wi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ti,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Tt(0,0,e,t),this.scissorTest=!1,this.viewport=new Tt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ri({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ti,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Fo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},vi=class extends Fc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Pa=class extends ri{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Nc=class extends ri{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ut=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,u,h,f,d,m,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,f,d,m,_,g)}set(e,t,n,s,r,o,a,l,c,u,h,f,d,m,_,g){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=m,p[11]=_,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/mo.setFromMatrixColumn(e,0).length(),r=1/mo.setFromMatrixColumn(e,1).length(),o=1/mo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,m=a*u,_=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+m*c,t[5]=f-_*c,t[9]=-a*l,t[2]=_-f*c,t[6]=m+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,m=c*u,_=c*h;t[0]=f+_*a,t[4]=m*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-m,t[6]=_+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,m=c*u,_=c*h;t[0]=f-_*a,t[4]=-o*h,t[8]=m+d*a,t[1]=d+m*a,t[5]=o*u,t[9]=_-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,m=a*u,_=a*h;t[0]=l*u,t[4]=m*c-d,t[8]=f*c+_,t[1]=l*h,t[5]=_*c+f,t[9]=d*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,m=a*l,_=a*c;t[0]=l*u,t[4]=_-f*h,t[8]=m*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+m,t[10]=f-_*h}else if(e.order==="XZY"){let f=o*l,d=o*c,m=a*l,_=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+_,t[5]=o*u,t[9]=d*h-m,t[2]=m*h-d,t[6]=a*u,t[10]=_*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(YS,e,ZS)}lookAt(e,t,n){let s=this.elements;return gi.subVectors(e,t),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),Ys.crossVectors(n,gi),Ys.lengthSq()===0&&(Math.abs(n.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),Ys.crossVectors(n,gi)),Ys.normalize(),jl.crossVectors(gi,Ys),s[0]=Ys.x,s[4]=jl.x,s[8]=gi.x,s[1]=Ys.y,s[5]=jl.y,s[9]=gi.y,s[2]=Ys.z,s[6]=jl.z,s[10]=gi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],m=n[2],_=n[6],g=n[10],p=n[14],b=n[3],T=n[7],x=n[11],R=n[15],w=s[0],y=s[4],E=s[8],O=s[12],L=s[1],I=s[5],k=s[9],V=s[13],D=s[2],H=s[6],q=s[10],G=s[14],ae=s[3],$=s[7],K=s[11],ee=s[15];return r[0]=o*w+a*L+l*D+c*ae,r[4]=o*y+a*I+l*H+c*$,r[8]=o*E+a*k+l*q+c*K,r[12]=o*O+a*V+l*G+c*ee,r[1]=u*w+h*L+f*D+d*ae,r[5]=u*y+h*I+f*H+d*$,r[9]=u*E+h*k+f*q+d*K,r[13]=u*O+h*V+f*G+d*ee,r[2]=m*w+_*L+g*D+p*ae,r[6]=m*y+_*I+g*H+p*$,r[10]=m*E+_*k+g*q+p*K,r[14]=m*O+_*V+g*G+p*ee,r[3]=b*w+T*L+x*D+R*ae,r[7]=b*y+T*I+x*H+R*$,r[11]=b*E+T*k+x*q+R*K,r[15]=b*O+T*V+x*G+R*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],m=e[3],_=e[7],g=e[11],p=e[15],b=l*d-c*f,T=a*d-c*h,x=a*f-l*h,R=o*d-c*u,w=o*f-l*u,y=o*h-a*u;return t*(_*b-g*T+p*x)-n*(m*b-g*R+p*w)+s*(m*T-_*R+p*y)-r*(m*x-_*w+g*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],m=e[12],_=e[13],g=e[14],p=e[15],b=t*a-n*o,T=t*l-s*o,x=t*c-r*o,R=n*l-s*a,w=n*c-r*a,y=s*c-r*l,E=u*_-h*m,O=u*g-f*m,L=u*p-d*m,I=h*g-f*_,k=h*p-d*_,V=f*p-d*g,D=b*V-T*k+x*I+R*L-w*O+y*E;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/D;return e[0]=(a*V-l*k+c*I)*H,e[1]=(s*k-n*V-r*I)*H,e[2]=(_*y-g*w+p*R)*H,e[3]=(f*w-h*y-d*R)*H,e[4]=(l*L-o*V-c*O)*H,e[5]=(t*V-s*L+r*O)*H,e[6]=(g*x-m*y-p*T)*H,e[7]=(u*y-f*x+d*T)*H,e[8]=(o*k-a*L+c*E)*H,e[9]=(n*L-t*k-r*E)*H,e[10]=(m*w-_*x+p*b)*H,e[11]=(h*x-u*w-d*b)*H,e[12]=(a*O-o*I-l*E)*H,e[13]=(t*I-n*O+s*E)*H,e[14]=(_*T-m*R-g*b)*H,e[15]=(u*R-h*T+f*b)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,m=r*h,_=o*u,g=o*h,p=a*h,b=l*c,T=l*u,x=l*h,R=n.x,w=n.y,y=n.z;return s[0]=(1-(_+p))*R,s[1]=(d+x)*R,s[2]=(m-T)*R,s[3]=0,s[4]=(d-x)*w,s[5]=(1-(f+p))*w,s[6]=(g+b)*w,s[7]=0,s[8]=(m+T)*y,s[9]=(g-b)*y,s[10]=(1-(f+_))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=mo.set(s[0],s[1],s[2]).length(),a=mo.set(s[4],s[5],s[6]).length(),l=mo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Vi.copy(this);let c=1/o,u=1/a,h=1/l;return Vi.elements[0]*=c,Vi.elements[1]*=c,Vi.elements[2]*=c,Vi.elements[4]*=u,Vi.elements[5]*=u,Vi.elements[6]*=u,Vi.elements[8]*=h,Vi.elements[9]*=h,Vi.elements[10]*=h,t.setFromRotationMatrix(Vi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Ri,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),f=(t+e)/(t-e),d=(n+s)/(n-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===Ri)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Io)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ri,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),f=-(t+e)/(t-e),d=-(n+s)/(n-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===Ri)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===Io)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},mo=new B,Vi=new Ut,YS=new B(0,0,0),ZS=new B(1,1,1),Ys=new B,jl=new B,gi=new B,o0=new Ut,a0=new Ln,us=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ot(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ot(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ot(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ot(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ot(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ot(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return o0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(o0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return a0.setFromEuler(this),this.setFromQuaternion(a0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};us.DEFAULT_ORDER="XYZ";var Ia=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},JS=0,l0=new B,go=new Ln,Es=new Ut,Ql=new B,_a=new B,KS=new B,jS=new Ln,c0=new B(1,0,0),u0=new B(0,1,0),h0=new B(0,0,1),f0={type:"added"},QS={type:"removed"},_o={type:"childadded",child:null},wf={type:"childremoved",child:null},Un=class i extends Wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:JS++}),this.uuid=hr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new B,t=new us,n=new Ln,s=new B(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ut},normalMatrix:{value:new nt}}),this.matrix=new Ut,this.matrixWorld=new Ut,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ia,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return go.setFromAxisAngle(e,t),this.quaternion.multiply(go),this}rotateOnWorldAxis(e,t){return go.setFromAxisAngle(e,t),this.quaternion.premultiply(go),this}rotateX(e){return this.rotateOnAxis(c0,e)}rotateY(e){return this.rotateOnAxis(u0,e)}rotateZ(e){return this.rotateOnAxis(h0,e)}translateOnAxis(e,t){return l0.copy(e).applyQuaternion(this.quaternion),this.position.add(l0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(c0,e)}translateY(e){return this.translateOnAxis(u0,e)}translateZ(e){return this.translateOnAxis(h0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Es.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ql.copy(e):Ql.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),_a.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Es.lookAt(_a,Ql,this.up):Es.lookAt(Ql,_a,this.up),this.quaternion.setFromRotationMatrix(Es),s&&(Es.extractRotation(s.matrixWorld),go.setFromRotationMatrix(Es),this.quaternion.premultiply(go.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(f0),_o.child=e,this.dispatchEvent(_o),_o.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(QS),wf.child=e,this.dispatchEvent(wf),wf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Es.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Es.multiply(e.parent.matrixWorld)),e.applyMatrix4(Es),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(f0),_o.child=e,this.dispatchEvent(_o),_o.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_a,e,KS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_a,jS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),m=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Un.DEFAULT_UP=new B(0,1,0);Un.DEFAULT_MATRIX_AUTO_UPDATE=!0;Un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Pn=class extends Un{constructor(){super(),this.isGroup=!0,this.type="Group"}},eM={type:"move"},No=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Pn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Pn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Pn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let g=t.getJointPose(_,n),p=this._getHandJoint(c,_);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(eM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Pn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},p_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Zs={h:0,s:0,l:0},ec={h:0,s:0,l:0};function Af(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var at=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=yi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,yt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=yt.workingColorSpace){return this.r=e,this.g=t,this.b=n,yt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=yt.workingColorSpace){if(e=Sd(e,1),t=ot(t,0,1),n=ot(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Af(o,r,e+1/3),this.g=Af(o,r,e),this.b=Af(o,r,e-1/3)}return yt.colorSpaceToWorking(this,s),this}setStyle(e,t=yi){function n(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=yi){let n=p_[e.toLowerCase()];return n!==void 0?this.setHex(n,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Is(e.r),this.g=Is(e.g),this.b=Is(e.b),this}copyLinearToSRGB(e){return this.r=Co(e.r),this.g=Co(e.g),this.b=Co(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=yi){return yt.workingToColorSpace(Wn.copy(this),e),Math.round(ot(Wn.r*255,0,255))*65536+Math.round(ot(Wn.g*255,0,255))*256+Math.round(ot(Wn.b*255,0,255))}getHexString(e=yi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=yt.workingColorSpace){yt.workingToColorSpace(Wn.copy(this),t);let n=Wn.r,s=Wn.g,r=Wn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=yt.workingColorSpace){return yt.workingToColorSpace(Wn.copy(this),t),e.r=Wn.r,e.g=Wn.g,e.b=Wn.b,e}getStyle(e=yi){yt.workingToColorSpace(Wn.copy(this),e);let t=Wn.r,n=Wn.g,s=Wn.b;return e!==yi?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Zs),this.setHSL(Zs.h+e,Zs.s+t,Zs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Zs),e.getHSL(ec);let n=wa(Zs.h,ec.h,t),s=wa(Zs.s,ec.s,t),r=wa(Zs.l,ec.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Wn=new at;at.NAMES=p_;var La=class extends Un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new us,this.environmentIntensity=1,this.environmentRotation=new us,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Gi=new B,Ts=new B,Ef=new B,Rs=new B,yo=new B,xo=new B,d0=new B,Tf=new B,Rf=new B,Cf=new B,Pf=new Tt,If=new Tt,Lf=new Tt,Qs=class i{constructor(e=new B,t=new B,n=new B){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Gi.subVectors(e,t),s.cross(Gi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Gi.subVectors(s,t),Ts.subVectors(n,t),Ef.subVectors(e,t);let o=Gi.dot(Gi),a=Gi.dot(Ts),l=Gi.dot(Ef),c=Ts.dot(Ts),u=Ts.dot(Ef),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,m=(o*u-a*l)*f;return r.set(1-d-m,m,d)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Rs)===null?!1:Rs.x>=0&&Rs.y>=0&&Rs.x+Rs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Rs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Rs.x),l.addScaledVector(o,Rs.y),l.addScaledVector(a,Rs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Pf.setScalar(0),If.setScalar(0),Lf.setScalar(0),Pf.fromBufferAttribute(e,t),If.fromBufferAttribute(e,n),Lf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Pf,r.x),o.addScaledVector(If,r.y),o.addScaledVector(Lf,r.z),o}static isFrontFacing(e,t,n,s){return Gi.subVectors(n,t),Ts.subVectors(e,t),Gi.cross(Ts).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Gi.subVectors(this.c,this.b),Ts.subVectors(this.a,this.b),Gi.cross(Ts).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;yo.subVectors(s,n),xo.subVectors(r,n),Tf.subVectors(e,n);let l=yo.dot(Tf),c=xo.dot(Tf);if(l<=0&&c<=0)return t.copy(n);Rf.subVectors(e,s);let u=yo.dot(Rf),h=xo.dot(Rf);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(yo,o);Cf.subVectors(e,r);let d=yo.dot(Cf),m=xo.dot(Cf);if(m>=0&&d<=m)return t.copy(r);let _=d*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(n).addScaledVector(xo,a);let g=u*m-d*h;if(g<=0&&h-u>=0&&d-m>=0)return d0.subVectors(r,s),a=(h-u)/(h-u+(d-m)),t.copy(s).addScaledVector(d0,a);let p=1/(g+_+f);return o=_*p,a=f*p,t.copy(n).addScaledVector(yo,o).addScaledVector(xo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},On=class{constructor(e=new B(1/0,1/0,1/0),t=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Hi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Hi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Hi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Hi):Hi.fromBufferAttribute(r,o),Hi.applyMatrix4(e.matrixWorld),this.expandByPoint(Hi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),tc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),tc.copy(n.boundingBox)),tc.applyMatrix4(e.matrixWorld),this.union(tc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Hi),Hi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ya),nc.subVectors(this.max,ya),vo.subVectors(e.a,ya),bo.subVectors(e.b,ya),So.subVectors(e.c,ya),Js.subVectors(bo,vo),Ks.subVectors(So,bo),Ar.subVectors(vo,So);let t=[0,-Js.z,Js.y,0,-Ks.z,Ks.y,0,-Ar.z,Ar.y,Js.z,0,-Js.x,Ks.z,0,-Ks.x,Ar.z,0,-Ar.x,-Js.y,Js.x,0,-Ks.y,Ks.x,0,-Ar.y,Ar.x,0];return!Df(t,vo,bo,So,nc)||(t=[1,0,0,0,1,0,0,0,1],!Df(t,vo,bo,So,nc))?!1:(ic.crossVectors(Js,Ks),t=[ic.x,ic.y,ic.z],Df(t,vo,bo,So,nc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Hi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Hi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Cs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Cs=[new B,new B,new B,new B,new B,new B,new B,new B],Hi=new B,tc=new On,vo=new B,bo=new B,So=new B,Js=new B,Ks=new B,Ar=new B,ya=new B,nc=new B,ic=new B,Er=new B;function Df(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Er.fromArray(i,r);let a=s.x*Math.abs(Er.x)+s.y*Math.abs(Er.y)+s.z*Math.abs(Er.z),l=e.dot(Er),c=t.dot(Er),u=n.dot(Er);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var pn=new B,sc=new Ze,tM=0,tn=class extends Wi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:tM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=xd,this.updateRanges=[],this.gpuType=Yi,this.version=0,this._normalizationScale=e!==void 0?Gu(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)sc.fromBufferAttribute(this,t),sc.applyMatrix3(e),this.setXY(t,sc.x,sc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix3(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix4(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyNormalMatrix(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.transformDirection(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):wd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ad(e,this.array)}};var Da=class extends tn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Fa=class extends tn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Ot=class extends tn{constructor(e,t,n){super(new Float32Array(e),t,n)}},nM=new On,xa=new B,Ff=new B,Xi=class{constructor(e=new B,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):nM.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;xa.subVectors(e,this.center);let t=xa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(xa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ff.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(xa.copy(e.center).add(Ff)),this.expandByPoint(xa.copy(e.center).sub(Ff))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},iM=0,Ti=new Ut,Nf=new Un,Mo=new B,_i=new On,va=new On,Cn=new B,nn=class i extends Wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:iM++}),this.uuid=hr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(RS(e)?Fa:Da)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new nt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ti.makeRotationFromQuaternion(e),this.applyMatrix4(Ti),this}rotateX(e){return Ti.makeRotationX(e),this.applyMatrix4(Ti),this}rotateY(e){return Ti.makeRotationY(e),this.applyMatrix4(Ti),this}rotateZ(e){return Ti.makeRotationZ(e),this.applyMatrix4(Ti),this}translate(e,t,n){return Ti.makeTranslation(e,t,n),this.applyMatrix4(Ti),this}scale(e,t,n){return Ti.makeScale(e,t,n),this.applyMatrix4(Ti),this}lookAt(e){return Nf.lookAt(e),Nf.updateMatrix(),this.applyMatrix4(Nf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Mo).negate(),this.translate(Mo.x,Mo.y,Mo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ot(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new On);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Xi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(e){let n=this.boundingSphere.center;if(_i.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];va.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(_i.min,va.min),_i.expandByPoint(Cn),Cn.addVectors(_i.max,va.max),_i.expandByPoint(Cn)):(_i.expandByPoint(va.min),_i.expandByPoint(va.max))}_i.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Cn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Cn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Cn.fromBufferAttribute(a,c),l&&(Mo.fromBufferAttribute(e,c),Cn.add(Mo)),s=Math.max(s,n.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new tn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new B,l[O]=new B;let u=new B,h=new B,f=new B,d=new Ze,m=new Ze,_=new Ze,g=new B,p=new B;function b(O,L,I){c[O]=c[L]=c[I]=1,u.fromBufferAttribute(n,O),h.fromBufferAttribute(n,L),f.fromBufferAttribute(n,I),d.fromBufferAttribute(r,O),m.fromBufferAttribute(r,L),_.fromBufferAttribute(r,I),h.sub(u),f.sub(u),m.sub(d),_.sub(d);let k=1/(m.x*_.y-_.x*m.y);isFinite(k)&&(g.copy(h).multiplyScalar(_.y).addScaledVector(f,-m.y).multiplyScalar(k),p.copy(f).multiplyScalar(m.x).addScaledVector(h,-_.x).multiplyScalar(k),a[O].add(g),a[L].add(g),a[I].add(g),l[O].add(p),l[L].add(p),l[I].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let O=0,L=T.length;O<L;++O){let I=T[O],k=I.start,V=I.count;for(let D=k,H=k+V;D<H;D+=3)b(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let x=new B,R=new B,w=new B,y=new B;function E(O){w.fromBufferAttribute(s,O),y.copy(w);let L=a[O];x.copy(L),x.sub(w.multiplyScalar(w.dot(L))).normalize(),R.crossVectors(y,L);let k=R.dot(l[O])<0?-1:1;o.setXYZW(O,x.x,x.y,x.z,k)}for(let O=0,L=n.count;O<L;++O)c[O]&&E(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new tn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,u=new B,h=new B;if(e)for(let f=0,d=e.count;f<d;f+=3){let m=e.getX(f+0),_=e.getX(f+1),g=e.getX(f+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Cn.fromBufferAttribute(e,t),Cn.normalize(),e.setXYZ(t,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,m=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?d=l[_]*a.data.stride+a.offset:d=l[_]*u;for(let p=0;p<u;p++)f[m++]=c[d++]}return new tn(f,u,h)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,n);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Na=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=xd,this.updateRanges=[],this.version=0,this.uuid=hr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=p0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=p0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function p0(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=hr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Qn=new B,Ci=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Gu(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Qn.fromBufferAttribute(this,t),Qn.applyMatrix4(e),this.setXYZ(t,Qn.x,Qn.y,Qn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Qn.fromBufferAttribute(this,t),Qn.applyNormalMatrix(e),this.setXYZ(t,Qn.x,Qn.y,Qn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Qn.fromBufferAttribute(this,t),Qn.transformDirection(e),this.setXYZ(t,Qn.x,Qn.y,Qn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Ca("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new tn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Ca("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):wd(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ad(e,this.data.array)}},Uf=new B,sM=new B,rM=new nt,xi=class{constructor(e=new B(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Uf.subVectors(n,t).cross(sM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Uf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||rM.getNormalMatrix(e),s=this.coplanarPoint(Uf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},oM=0,qi=class extends Wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:oM++}),this.uuid=hr(),this.name="",this.type="Material",this.blending=Vo,this.side=cr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Qf,this.blendDst=ed,this.blendEquation=Nr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=Po,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=s_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Sc,this.stencilZFail=Sc,this.stencilZPass=Sc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new at().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new xi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ze().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ze().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ps=new B,Of=new B,rc=new B,oc=new B,Cr=class{constructor(e=new B,t=new B(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ps)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ps.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ps.copy(this.origin).addScaledVector(this.direction,t),Ps.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Of.copy(e).add(t).multiplyScalar(.5),rc.copy(t).sub(e).normalize(),oc.copy(this.origin).sub(Of);let r=e.distanceTo(t)*.5,o=-this.direction.dot(rc),a=oc.dot(this.direction),l=-oc.dot(rc),c=oc.lengthSq(),u=Math.abs(1-o*o),h,f,d,m;if(u>0)if(h=o*l-a,f=o*a-l,m=r*u,h>=0)if(f>=-m)if(f<=m){let _=1/u;h*=_,f*=_,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Of).addScaledVector(rc,f),d}intersectSphere(e,t){if(e.radius<0)return null;Ps.subVectors(e.center,this.origin);let n=Ps.dot(this.direction),s=Ps.dot(Ps)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ps)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,m=t.x-o.x,_=t.y-o.y,g=t.z-o.z,p=n.x-o.x,b=n.y-o.y,T=n.z-o.z,x=Math.abs(l),R=Math.abs(c),w=Math.abs(u),y,E,O,L,I,k,V,D,H,q,G,ae;if(x>=R&&x>=w?(O=l,k=h,H=m,ae=p,l>=0?(y=c,E=u,L=f,I=d,V=_,D=g,q=b,G=T):(y=u,E=c,L=d,I=f,V=g,D=_,q=T,G=b)):R>=w?(O=c,k=f,H=_,ae=b,c>=0?(y=u,E=l,L=d,I=h,V=g,D=m,q=T,G=p):(y=l,E=u,L=h,I=d,V=m,D=g,q=p,G=T)):(O=u,k=d,H=g,ae=T,u>=0?(y=l,E=c,L=h,I=f,V=m,D=_,q=p,G=b):(y=c,E=l,L=f,I=h,V=_,D=m,q=b,G=p)),O===0)return null;let $=y/O,K=E/O,ee=1/O,de=L-$*k,ue=I-K*k,j=V-$*H,ye=D-K*H,se=q-$*ae,me=G-K*ae,pe=se*ye-me*j,Oe=de*me-ue*se,Xe=j*ue-ye*de;if(s){if(pe<0||Oe<0||Xe<0)return null}else if((pe<0||Oe<0||Xe<0)&&(pe>0||Oe>0||Xe>0))return null;let Ge=pe+Oe+Xe;if(Ge===0)return null;let ft=ee*(pe*k+Oe*H+Xe*ae);return(Ge>0?ft<0:ft>0)?null:this.at(ft/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Uo=class extends qi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new us,this.combine=nu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},m0=new Ut,Tr=new Cr,ac=new Xi,g0=new B,lc=new B,cc=new B,uc=new B,Bf=new B,hc=new B,_0=new B,fc=new B,Bt=class extends Un{constructor(e=new nn,t=new Uo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){hc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Bf.fromBufferAttribute(h,e),o?hc.addScaledVector(Bf,u):hc.addScaledVector(Bf.sub(t),u))}t.add(hc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ac.copy(n.boundingSphere),ac.applyMatrix4(r),Tr.copy(e.ray).recast(e.near),!(ac.containsPoint(Tr.origin)===!1&&(Tr.intersectSphere(ac,g0)===null||Tr.origin.distanceToSquared(g0)>(e.far-e.near)**2))&&(m0.copy(r).invert(),Tr.copy(e.ray).applyMatrix4(m0),!(n.boundingBox!==null&&Tr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Tr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=f.length;m<_;m++){let g=f[m],p=o[g.materialIndex],b=Math.max(g.start,d.start),T=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let x=b,R=T;x<R;x+=3){let w=a.getX(x),y=a.getX(x+1),E=a.getX(x+2);s=dc(this,p,e,n,c,u,h,w,y,E),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let g=m,p=_;g<p;g+=3){let b=a.getX(g),T=a.getX(g+1),x=a.getX(g+2);s=dc(this,o,e,n,c,u,h,b,T,x),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=f.length;m<_;m++){let g=f[m],p=o[g.materialIndex],b=Math.max(g.start,d.start),T=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let x=b,R=T;x<R;x+=3){let w=x,y=x+1,E=x+2;s=dc(this,p,e,n,c,u,h,w,y,E),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,d.start),_=Math.min(l.count,d.start+d.count);for(let g=m,p=_;g<p;g+=3){let b=g,T=g+1,x=g+2;s=dc(this,o,e,n,c,u,h,b,T,x),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function aM(i,e,t,n,s,r,o,a){let l;if(e.side===ni?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===cr,a),l===null)return null;fc.copy(a),fc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(fc);return c<t.near||c>t.far?null:{distance:c,point:fc.clone(),object:i}}function dc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,lc),i.getVertexPosition(l,cc),i.getVertexPosition(c,uc);let u=aM(i,e,t,n,lc,cc,uc,_0);if(u){let h=new B;Qs.getBarycoord(_0,lc,cc,uc,h),s&&(u.uv=Qs.getInterpolatedAttribute(s,a,l,c,h,new Ze)),r&&(u.uv1=Qs.getInterpolatedAttribute(r,a,l,c,h,new Ze)),o&&(u.normal=Qs.getInterpolatedAttribute(o,a,l,c,h,new B),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new B,materialIndex:0};Qs.getNormal(lc,cc,uc,f.normal),u.face=f,u.barycoord=h}return u}var Uc=class extends ri{constructor(e=null,t=1,n=1,s,r,o,a,l,c=In,u=In,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Rr=new Xi,lM=new Ze(.5,.5),pc=new B,er=class{constructor(e=new xi,t=new xi,n=new xi,s=new xi,r=new xi,o=new xi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ri,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],m=r[8],_=r[9],g=r[10],p=r[11],b=r[12],T=r[13],x=r[14],R=r[15];if(s[0].setComponents(c-o,d-u,p-m,R-b).normalize(),s[1].setComponents(c+o,d+u,p+m,R+b).normalize(),s[2].setComponents(c+a,d+h,p+_,R+T).normalize(),s[3].setComponents(c-a,d-h,p-_,R-T).normalize(),n)s[4].setComponents(l,f,g,x).normalize(),s[5].setComponents(c-l,d-f,p-g,R-x).normalize();else if(s[4].setComponents(c-l,d-f,p-g,R-x).normalize(),t===Ri)s[5].setComponents(c+l,d+f,p+g,R+x).normalize();else if(t===Io)s[5].setComponents(l,f,g,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Rr)}intersectsSprite(e){Rr.center.set(0,0,0);let t=lM.distanceTo(e.center);return Rr.radius=.7071067811865476+t,Rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Rr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(pc.x=s.normal.x>0?e.max.x:e.min.x,pc.y=s.normal.y>0?e.max.y:e.min.y,pc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(pc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},y0=new Ut,Oc=class i{constructor(){this.coordinateSystem=Ri,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];y0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new er),n[s].setFromProjectionMatrix(y0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new er),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Oo=class extends qi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Bc=new B,kc=new B,x0=new Ut,ba=new Cr,mc=new Xi,kf=new B,v0=new B,Bo=class extends Un{constructor(e=new nn,t=new Oo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Bc.fromBufferAttribute(t,s-1),kc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Bc.distanceTo(kc);e.setAttribute("lineDistance",new Ot(n,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),mc.copy(n.boundingSphere),mc.applyMatrix4(s),mc.radius+=r,e.ray.intersectsSphere(mc)===!1)return;x0.copy(s).invert(),ba.copy(e.ray).applyMatrix4(x0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let _=d,g=m-1;_<g;_+=c){let p=u.getX(_),b=u.getX(_+1),T=gc(this,e,ba,l,p,b,_);T&&t.push(T)}if(this.isLineLoop){let _=u.getX(m-1),g=u.getX(d),p=gc(this,e,ba,l,_,g,m-1);p&&t.push(p)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let _=d,g=m-1;_<g;_+=c){let p=gc(this,e,ba,l,_,_+1,_);p&&t.push(p)}if(this.isLineLoop){let _=gc(this,e,ba,l,m-1,d,m-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function gc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Bc.fromBufferAttribute(a,s),kc.fromBufferAttribute(a,r),t.distanceSqToSegment(Bc,kc,kf,v0)>n)return;kf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(kf);if(!(c<e.near||c>e.far))return{distance:c,point:v0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var b0=new B,S0=new B,zc=class extends Bo{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)b0.fromBufferAttribute(t,s),S0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+b0.distanceTo(S0);e.setAttribute("lineDistance",new Ot(n,1))}else $e("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ua=class extends ri{constructor(e=[],t=Ur,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ds=class extends ri{constructor(e,t,n=$i,s,r,o,a=In,l=In,c,u=Ls,h=1){if(u!==Ls&&u!==Ns)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Fo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Oa=class extends Ds{constructor(e,t=$i,n=Ur,s,r,o=In,a=In,l,c=Ls){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ba=class extends ri{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},tr=class i extends nn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;m("z","y","x",-1,-1,n,t,e,o,r,0),m("z","y","x",1,-1,n,t,-e,o,r,1),m("x","z","y",1,1,e,n,t,s,o,2),m("x","z","y",1,-1,e,n,-t,s,o,3),m("x","y","z",1,-1,e,t,n,s,r,4),m("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ot(c,3)),this.setAttribute("normal",new Ot(u,3)),this.setAttribute("uv",new Ot(h,2));function m(_,g,p,b,T,x,R,w,y,E,O){let L=x/y,I=R/E,k=x/2,V=R/2,D=w/2,H=y+1,q=E+1,G=0,ae=0,$=new B;for(let K=0;K<q;K++){let ee=K*I-V;for(let de=0;de<H;de++){let ue=de*L-k;$[_]=ue*b,$[g]=ee*T,$[p]=D,c.push($.x,$.y,$.z),$[_]=0,$[g]=0,$[p]=w>0?1:-1,u.push($.x,$.y,$.z),h.push(de/y),h.push(1-K/E),G+=1}}for(let K=0;K<E;K++)for(let ee=0;ee<y;ee++){let de=f+ee+H*K,ue=f+ee+H*(K+1),j=f+(ee+1)+H*(K+1),ye=f+(ee+1)+H*K;l.push(de,ue,ye),l.push(ue,j,ye),ae+=6}a.addGroup(d,ae,O),d+=ae,f+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var hs=class i extends nn{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],d=[],m=0,_=[],g=n/2,p=0;b(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Ot(h,3)),this.setAttribute("normal",new Ot(f,3)),this.setAttribute("uv",new Ot(d,2));function b(){let x=new B,R=new B,w=0,y=(t-e)/n;for(let E=0;E<=r;E++){let O=[],L=E/r,I=L*(t-e)+e;for(let k=0;k<=s;k++){let V=k/s,D=V*l+a,H=Math.sin(D),q=Math.cos(D);R.x=I*H,R.y=-L*n+g,R.z=I*q,h.push(R.x,R.y,R.z),x.set(H,y,q).normalize(),f.push(x.x,x.y,x.z),d.push(V,1-L),O.push(m++)}_.push(O)}for(let E=0;E<s;E++)for(let O=0;O<r;O++){let L=_[O][E],I=_[O+1][E],k=_[O+1][E+1],V=_[O][E+1];(e>0||O!==0)&&(u.push(L,I,V),w+=3),(t>0||O!==r-1)&&(u.push(I,k,V),w+=3)}c.addGroup(p,w,0),p+=w}function T(x){let R=m,w=new Ze,y=new B,E=0,O=x===!0?e:t,L=x===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,g*L,0),f.push(0,L,0),d.push(.5,.5),m++;let I=m;for(let k=0;k<=s;k++){let D=k/s*l+a,H=Math.cos(D),q=Math.sin(D);y.x=O*q,y.y=g*L,y.z=O*H,h.push(y.x,y.y,y.z),f.push(0,L,0),w.x=H*.5+.5,w.y=q*.5*L+.5,d.push(w.x,w.y),m++}for(let k=0;k<s;k++){let V=R+k,D=I+k;x===!0?u.push(D,D+1,V):u.push(D+1,D,V),E+=3}c.addGroup(p,E,x===!0?1:2),p+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},ka=class i extends hs{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Pr=class i extends nn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],m=[],_=[],g=[];for(let p=0;p<u;p++){let b=p*f-o;for(let T=0;T<c;T++){let x=T*h-r;m.push(x,-b,0),_.push(0,0,1),g.push(T/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let b=0;b<a;b++){let T=b+c*p,x=b+c*(p+1),R=b+1+c*(p+1),w=b+1+c*p;d.push(T,x,w),d.push(x,R,w)}this.setIndex(d),this.setAttribute("position",new Ot(m,3)),this.setAttribute("normal",new Ot(_,3)),this.setAttribute("uv",new Ot(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var za=class i extends nn{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new B,f=new B,d=[],m=[],_=[],g=[];for(let p=0;p<=n;p++){let b=[],T=p/n,x=o+T*a,R=e*Math.cos(x),w=Math.sqrt(e*e-R*R),y=0;p===0&&o===0?y=.5/t:p===n&&l===Math.PI&&(y=-.5/t);for(let E=0;E<=t;E++){let O=E/t,L=s+O*r;h.x=-w*Math.cos(L),h.y=R,h.z=w*Math.sin(L),m.push(h.x,h.y,h.z),f.copy(h).normalize(),_.push(f.x,f.y,f.z),g.push(O+y,1-T),b.push(c++)}u.push(b)}for(let p=0;p<n;p++)for(let b=0;b<t;b++){let T=u[p][b+1],x=u[p][b],R=u[p+1][b],w=u[p+1][b+1];(p!==0||o>0)&&d.push(T,x,w),(p!==n-1||l<Math.PI)&&d.push(x,R,w)}this.setIndex(d),this.setAttribute("position",new Ot(m,3)),this.setAttribute("normal",new Ot(_,3)),this.setAttribute("uv",new Ot(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Va=class extends nn{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new B,r=new B;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,d=h.count;for(let m=f,_=f+d;m<_;m+=3)for(let g=0;g<3;g++){let p=a.getX(m+g),b=a.getX(m+(g+1)%3);s.fromBufferAttribute(o,p),r.fromBufferAttribute(o,b),M0(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),M0(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Ot(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function M0(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var Ga=class extends qi{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new at(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function Br(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(w0(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(w0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Xn(i){let e={};for(let t=0;t<i.length;t++){let n=Br(i[t]);for(let s in n)e[s]=n[s]}return e}function w0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function cM(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Ed(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:yt.workingColorSpace}var ll={clone:Br,merge:Xn},uM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,hM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Pi=class extends qi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=uM,this.fragmentShader=hM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Br(e.uniforms),this.uniformsGroups=cM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new at().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ze().fromArray(s.value);break;case"v3":this.uniforms[n].value=new B().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Tt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ut().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Vc=class extends Pi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ha=class extends qi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new at(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=al,this.normalScale=new Ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new us,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Ir=class extends qi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=al,this.normalScale=new Ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new us,this.combine=nu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Gc=class extends qi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=n_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Hc=class extends qi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Wa=class extends Oo{constructor(e){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(e)}copy(e){return super.copy(e),this.scale=e.scale,this.dashSize=e.dashSize,this.gapSize=e.gapSize,this}};function wo(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function _c(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var nr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Wc=class extends nr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hf,endingEnd:Hf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Wf:r=e,a=2*t-n;break;case Xf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Wf:o=e,l=2*n-t;break;case Xf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(n-t)/(s-t),_=m*m,g=_*m,p=-f*g+2*f*_-f*m,b=(1+f)*g+(-1.5-2*f)*_+(-.5+f)*m+1,T=(-1-d)*g+(1.5+d)*_+.5*m,x=d*g-d*_;for(let R=0;R!==a;++R)r[R]=p*o[u+R]+b*o[c+R]+T*o[l+R]+x*o[h+R];return r}},Xc=class extends nr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},qc=class extends nr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},$c=class extends nr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(n-t)/(s-t),_=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*m;return r}let f=a*2,d=e-1;for(let m=0;m!==a;++m){let _=o[c+m],g=o[l+m],p=d*f+m*2,b=h[p],T=h[p+1],x=e*f+m*2,R=u[x],w=u[x+1],y=dM(n,t,b,R,s);r[m]=m_(y,_,T,w,g)}return r}};function m_(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function fM(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function dM(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=m_(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=fM(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var bi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=wo(t,this.TimeBufferType),this.values=wo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:wo(e.times,Array),values:wo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),_c(e.settings)&&(n.settings={inTangents:wo(e.settings.inTangents,Array),outTangents:wo(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new qc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Xc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Wc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new $c(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Aa:t=this.InterpolantFactoryMethodDiscrete;break;case Lc:t=this.InterpolantFactoryMethodLinear;break;case bc:t=this.InterpolantFactoryMethodSmooth;break;case Gf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return $e("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Aa;case this.InterpolantFactoryMethodLinear:return Lc;case this.InterpolantFactoryMethodSmooth:return bc;case this.InterpolantFactoryMethodBezier:return Gf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;_c(this.settings)&&(A0(this.settings.inTangents,e),A0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;_c(this.settings)&&(E0(this.settings.inTangents,e),E0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&CS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===bc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let m=0;m!==n;++m){let _=t[h+m];if(_!==t[f+m]||_!==t[d+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,_c(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function A0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function E0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}bi.prototype.ValueTypeName="";bi.prototype.TimeBufferType=Float32Array;bi.prototype.ValueBufferType=Float32Array;bi.prototype.DefaultInterpolation=Lc;var ir=class extends bi{constructor(e,t,n){super(e,t,n)}};ir.prototype.ValueTypeName="bool";ir.prototype.ValueBufferType=Array;ir.prototype.DefaultInterpolation=Aa;ir.prototype.InterpolantFactoryMethodLinear=void 0;ir.prototype.InterpolantFactoryMethodSmooth=void 0;var Yc=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};Yc.prototype.ValueTypeName="color";var Zc=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};Zc.prototype.ValueTypeName="number";var Jc=class extends nr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Ln.slerpFlat(r,0,o,c-a,o,c,l);return r}},Xa=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Jc(this.times,this.values,this.getValueSize(),e)}};Xa.prototype.ValueTypeName="quaternion";Xa.prototype.InterpolantFactoryMethodSmooth=void 0;var sr=class extends bi{constructor(e,t,n){super(e,t,n)}};sr.prototype.ValueTypeName="string";sr.prototype.ValueBufferType=Array;sr.prototype.DefaultInterpolation=Aa;sr.prototype.InterpolantFactoryMethodLinear=void 0;sr.prototype.InterpolantFactoryMethodSmooth=void 0;var Kc=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};Kc.prototype.ValueTypeName="vector";var jc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],m=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},g_=new jc,Qc=class{constructor(e){this.manager=e!==void 0?e:g_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Qc.DEFAULT_MATERIAL_NAME="__DEFAULT";var qa=class extends Un{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new at(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},$a=class extends qa{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.groundColor=new at(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},zf=new Ut,T0=new B,R0=new B,eu=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ze(512,512),this.mapType=oi,this.map=null,this.mapPass=null,this.matrix=new Ut,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new er,this._frameExtents=new Ze(1,1),this._viewportCount=1,this._viewports=[new Tt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;T0.setFromMatrixPosition(e.matrixWorld),t.position.copy(T0),R0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(R0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){zf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(zf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Io||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(zf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},yc=new B,xc=new Ln,ls=new B,Ya=class extends Un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ut,this.projectionMatrix=new Ut,this.projectionMatrixInverse=new Ut,this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(yc,xc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(yc,xc,ls.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(yc,xc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(yc,xc,ls.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},js=new B,C0=new Ze,P0=new Ze,ei=class extends Ya{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Do*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ma*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Do*2*Math.atan(Math.tan(Ma*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){js.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(js.x,js.y).multiplyScalar(-e/js.z),js.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(js.x,js.y).multiplyScalar(-e/js.z)}getViewSize(e,t){return this.getViewBounds(e,C0,P0),t.subVectors(P0,C0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ma*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Za=class extends Ya{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},qf=class extends eu{constructor(){super(new Za(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ja=class extends qa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.target=new Un,this.shadow=new qf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Ka=class extends nn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Ao=-90,Eo=1,ko=class extends Un{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ei(Ao,Eo,e,t);s.layers=this.layers,this.add(s);let r=new ei(Ao,Eo,e,t);r.layers=this.layers,this.add(r);let o=new ei(Ao,Eo,e,t);o.layers=this.layers,this.add(o);let a=new ei(Ao,Eo,e,t);a.layers=this.layers,this.add(a);let l=new ei(Ao,Eo,e,t);l.layers=this.layers,this.add(l);let c=new ei(Ao,Eo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ri)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Io)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=_,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},tu=class extends ei{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Td="\\[\\]\\.:\\/",pM=new RegExp("["+Td+"]","g"),Rd="[^"+Td+"]",mM="[^"+Td.replace("\\.","")+"]",gM=/((?:WC+[\/:])*)/.source.replace("WC",Rd),_M=/(WCOD+)?/.source.replace("WCOD",mM),yM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Rd),xM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Rd),vM=new RegExp("^"+gM+_M+yM+xM+"$"),bM=["material","materials","bones","map"],$f=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(pM,"")}static parseTrackName(e){let t=vM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);bM.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=$f;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var aP=new Float32Array(1);var rr=class extends Na{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var or=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ot(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(ot(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Yf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var I0=new B,vc=new B,To=new B,Ro=new B,Vf=new B,SM=new B,MM=new B,ja=class{constructor(e=new B,t=new B){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){I0.subVectors(e,this.start),vc.subVectors(this.end,this.start);let n=vc.dot(vc);if(n===0)return 0;let r=vc.dot(I0)/n;return t&&(r=ot(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=SM,n=MM){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;To.subVectors(c,a),Ro.subVectors(u,l),Vf.subVectors(a,l);let h=To.dot(To),f=Ro.dot(Ro),d=Ro.dot(Vf);if(h<=s&&f<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(h<=s)r=0,o=d/f,o=ot(o,0,1);else{let m=To.dot(Vf);if(f<=s)o=0,r=ot(-m/h,0,1);else{let _=To.dot(Ro),g=h*f-_*_;g!==0?r=ot((_*d-m*f)/g,0,1):r=0,o=(_*r+d)/f,o<0?(o=0,r=ot(-m/h,0,1)):o>1&&(o=1,r=ot((_-m)/h,0,1))}}return t.copy(a).addScaledVector(To,r),n.copy(l).addScaledVector(Ro,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Lr=class extends zc{constructor(e=10,t=10,n=4473924,s=8947848){n=new at(n),s=new at(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let f=0,d=0,m=-a;f<=t;f++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let _=f===r?n:s;_.toArray(c,d),d+=3,_.toArray(c,d),d+=3,_.toArray(c,d),d+=3,_.toArray(c,d),d+=3}let u=new nn;u.setAttribute("position",new Ot(l,3)),u.setAttribute("color",new Ot(c,3));let h=new Oo({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Qa=class extends Wi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Cd(i,e,t,n){let s=wM(n);switch(t){case dd:return i*e;case md:return i*e/s.components*s.byteLength;case cu:return i*e/s.components*s.byteLength;case ur:return i*e*2/s.components*s.byteLength;case uu:return i*e*2/s.components*s.byteLength;case pd:return i*e*3/s.components*s.byteLength;case Ji:return i*e*4/s.components*s.byteLength;case hu:return i*e*4/s.components*s.byteLength;case tl:case nl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case il:case sl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case du:case mu:return Math.max(i,16)*Math.max(e,8)/4;case fu:case pu:return Math.max(i,8)*Math.max(e,8)/2;case gu:case _u:case xu:case vu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case yu:case rl:case bu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Su:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Mu:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case wu:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Au:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Eu:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Tu:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Ru:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Cu:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Pu:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Iu:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Lu:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Du:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Fu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Nu:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Uu:case Ou:case Bu:return Math.ceil(i/4)*Math.ceil(e/4)*16;case ku:case zu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ol:case Vu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function wM(i){switch(i){case oi:case cd:return{byteLength:1,components:1};case Ho:case ud:case Zi:return{byteLength:2,components:1};case au:case lu:return{byteLength:2,components:4};case $i:case ou:case Yi:return{byteLength:4,components:1};case hd:case fd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function B_(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function PM(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<h.length;d++){let m=h[f],_=h[d];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++f,h[f]=_)}h.length=f+1;for(let d=0,m=h.length;d<m;d++){let _=h[d];i.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var IM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,LM=`#ifdef USE_ALPHAHASH
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
#endif`,DM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,FM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,NM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,UM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,OM=`#ifdef USE_AOMAP
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
#endif`,BM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kM=`#ifdef USE_BATCHING
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
#endif`,zM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,VM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,GM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,HM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,WM=`#ifdef USE_IRIDESCENCE
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
#endif`,XM=`#ifdef USE_BUMPMAP
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
#endif`,qM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,$M=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,YM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ZM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,JM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,KM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,jM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,QM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,ew=`#define PI 3.141592653589793
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
} // validated`,tw=`vec3 transformedNormal = objectNormal;
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
#endif`,nw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,iw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,sw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,rw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ow="gl_FragColor = linearToOutputTexel( gl_FragColor );",aw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,lw=`#ifdef USE_ENVMAP
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
#endif`,cw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,uw=`#ifdef USE_ENVMAP
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
#endif`,hw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fw=`#ifdef USE_ENVMAP
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
#endif`,dw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,pw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,mw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,gw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_w=`#ifdef USE_GRADIENTMAP
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
}`,yw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,xw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,vw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,bw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Sw=`#ifdef USE_ENVMAP
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
#endif`,Mw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ww=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Aw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Ew=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Tw=`PhysicalMaterial material;
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
#endif`,Rw=`uniform sampler2D dfgLUT;
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
}`,Cw=`
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
#endif`,Pw=`#if defined( RE_IndirectDiffuse )
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
#endif`,Iw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Lw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Dw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Fw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Nw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Uw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ow=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Bw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,zw=`#if defined( USE_POINTS_UV )
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
#endif`,Vw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Gw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Hw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ww=`#if defined( USE_MORPHCOLORS )
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
#endif`,Xw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qw=`#ifdef USE_MORPHTARGETS
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
#endif`,$w=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Yw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Zw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Jw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Kw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Qw=`#ifdef USE_NORMALMAP
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
#endif`,e1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,t1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,n1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,i1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,s1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,r1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,o1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,a1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,l1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,c1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,u1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,h1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,f1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,d1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,p1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,m1=`float getShadowMask() {
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
}`,g1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_1=`#ifdef USE_SKINNING
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
#endif`,y1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,x1=`#ifdef USE_SKINNING
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
#endif`,v1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,b1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,S1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,M1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,w1=`#ifdef USE_TRANSMISSION
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
#endif`,A1=`#ifdef USE_TRANSMISSION
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
#endif`,E1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,T1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,R1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,C1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,P1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,I1=`uniform sampler2D t2D;
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
}`,L1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,D1=`uniform float backgroundBlurriness;
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
}`,F1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,N1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,U1=`#include <common>
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
}`,O1=`#if DEPTH_PACKING == 3200
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
}`,B1=`#define DISTANCE
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
}`,k1=`#define DISTANCE
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
}`,z1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,V1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,G1=`uniform float scale;
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
}`,H1=`uniform vec3 diffuse;
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
}`,W1=`#include <common>
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
}`,X1=`uniform vec3 diffuse;
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
}`,q1=`#define LAMBERT
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
}`,$1=`#define LAMBERT
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
}`,Y1=`#define MATCAP
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
}`,Z1=`#define MATCAP
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
}`,J1=`#define NORMAL
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
}`,K1=`#define NORMAL
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
}`,j1=`#define PHONG
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
}`,Q1=`#define PHONG
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
}`,eA=`#define STANDARD
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
}`,tA=`#define STANDARD
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
}`,nA=`#define TOON
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
}`,iA=`#define TOON
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
}`,sA=`uniform float size;
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
}`,rA=`uniform vec3 diffuse;
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
}`,oA=`#include <common>
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
}`,aA=`uniform vec3 color;
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
}`,lA=`uniform float rotation;
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
}`,cA=`uniform vec3 diffuse;
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
}`,ht={alphahash_fragment:IM,alphahash_pars_fragment:LM,alphamap_fragment:DM,alphamap_pars_fragment:FM,alphatest_fragment:NM,alphatest_pars_fragment:UM,aomap_fragment:OM,aomap_pars_fragment:BM,batching_pars_vertex:kM,batching_vertex:zM,begin_vertex:VM,beginnormal_vertex:GM,bsdfs:HM,iridescence_fragment:WM,bumpmap_pars_fragment:XM,clipping_planes_fragment:qM,clipping_planes_pars_fragment:$M,clipping_planes_pars_vertex:YM,clipping_planes_vertex:ZM,color_fragment:JM,color_pars_fragment:KM,color_pars_vertex:jM,color_vertex:QM,common:ew,defaultnormal_vertex:tw,displacementmap_pars_vertex:nw,displacementmap_vertex:iw,emissivemap_fragment:sw,emissivemap_pars_fragment:rw,colorspace_fragment:ow,colorspace_pars_fragment:aw,envmap_fragment:lw,envmap_common_pars_fragment:cw,envmap_pars_fragment:uw,envmap_pars_vertex:hw,envmap_physical_pars_fragment:Sw,envmap_vertex:fw,fog_vertex:dw,fog_pars_vertex:pw,fog_fragment:mw,fog_pars_fragment:gw,gradientmap_pars_fragment:_w,lightmap_pars_fragment:yw,lights_lambert_fragment:xw,lights_lambert_pars_fragment:vw,lights_pars_begin:bw,lights_toon_fragment:Mw,lights_toon_pars_fragment:ww,lights_phong_fragment:Aw,lights_phong_pars_fragment:Ew,lights_physical_fragment:Tw,lights_physical_pars_fragment:Rw,lights_fragment_begin:Cw,lights_fragment_maps:Pw,lights_fragment_end:Iw,lightprobes_pars_fragment:Lw,logdepthbuf_fragment:Dw,logdepthbuf_pars_fragment:Fw,logdepthbuf_pars_vertex:Nw,logdepthbuf_vertex:Uw,map_fragment:Ow,map_pars_fragment:Bw,map_particle_fragment:kw,map_particle_pars_fragment:zw,metalnessmap_fragment:Vw,metalnessmap_pars_fragment:Gw,morphinstance_vertex:Hw,morphcolor_vertex:Ww,morphnormal_vertex:Xw,morphtarget_pars_vertex:qw,morphtarget_vertex:$w,normal_fragment_begin:Yw,normal_fragment_maps:Zw,normal_pars_fragment:Jw,normal_pars_vertex:Kw,normal_vertex:jw,normalmap_pars_fragment:Qw,clearcoat_normal_fragment_begin:e1,clearcoat_normal_fragment_maps:t1,clearcoat_pars_fragment:n1,iridescence_pars_fragment:i1,opaque_fragment:s1,packing:r1,premultiplied_alpha_fragment:o1,project_vertex:a1,dithering_fragment:l1,dithering_pars_fragment:c1,roughnessmap_fragment:u1,roughnessmap_pars_fragment:h1,shadowmap_pars_fragment:f1,shadowmap_pars_vertex:d1,shadowmap_vertex:p1,shadowmask_pars_fragment:m1,skinbase_vertex:g1,skinning_pars_vertex:_1,skinning_vertex:y1,skinnormal_vertex:x1,specularmap_fragment:v1,specularmap_pars_fragment:b1,tonemapping_fragment:S1,tonemapping_pars_fragment:M1,transmission_fragment:w1,transmission_pars_fragment:A1,uv_pars_fragment:E1,uv_pars_vertex:T1,uv_vertex:R1,worldpos_vertex:C1,background_vert:P1,background_frag:I1,backgroundCube_vert:L1,backgroundCube_frag:D1,cube_vert:F1,cube_frag:N1,depth_vert:U1,depth_frag:O1,distance_vert:B1,distance_frag:k1,equirect_vert:z1,equirect_frag:V1,linedashed_vert:G1,linedashed_frag:H1,meshbasic_vert:W1,meshbasic_frag:X1,meshlambert_vert:q1,meshlambert_frag:$1,meshmatcap_vert:Y1,meshmatcap_frag:Z1,meshnormal_vert:J1,meshnormal_frag:K1,meshphong_vert:j1,meshphong_frag:Q1,meshphysical_vert:eA,meshphysical_frag:tA,meshtoon_vert:nA,meshtoon_frag:iA,points_vert:sA,points_frag:rA,shadow_vert:oA,shadow_frag:aA,sprite_vert:lA,sprite_frag:cA},Pe={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new Ze(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new Ze(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},ii={basic:{uniforms:Xn([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Xn([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new at(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Xn([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Xn([Pe.common,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.roughnessmap,Pe.metalnessmap,Pe.fog,Pe.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Xn([Pe.common,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.gradientmap,Pe.fog,Pe.lights,{emissive:{value:new at(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Xn([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Xn([Pe.points,Pe.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Xn([Pe.common,Pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Xn([Pe.common,Pe.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Xn([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Xn([Pe.sprite,Pe.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Xn([Pe.common,Pe.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Xn([Pe.lights,Pe.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};ii.physical={uniforms:Xn([ii.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new Ze(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new Ze},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new Ze},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Hu={r:0,b:0,g:0},uA=new Ut,k_=new nt;k_.set(-1,0,0,0,1,0,0,0,1);function hA(i,e,t,n,s,r){let o=new at(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(b){let T=b.isScene===!0?b.background:null;if(T&&T.isTexture){let x=b.backgroundBlurriness>0;T=e.get(T,x)}return T}function m(b){let T=!1,x=d(b);x===null?g(o,a):x&&x.isColor&&(g(x,1),T=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(b,T){let x=d(T);x&&x.isCubeTexture?(c===void 0&&(c=new Bt(new tr(1,1,1),new Pi({name:"BackgroundCubeMaterial",uniforms:Br(ii.backgroundCube.uniforms),vertexShader:ii.backgroundCube.vertexShader,fragmentShader:ii.backgroundCube.fragmentShader,side:ni,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,w,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=x,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(uA.makeRotationFromEuler(T.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(k_),c.material.toneMapped=yt.getTransfer(x.colorSpace)!==Et,(u!==x||h!==x.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=x,h=x.version,f=i.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new Bt(new Pr(2,2),new Pi({name:"BackgroundMaterial",uniforms:Br(ii.background.uniforms),vertexShader:ii.background.vertexShader,fragmentShader:ii.background.fragmentShader,side:cr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=yt.getTransfer(x.colorSpace)!==Et,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(u!==x||h!==x.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,u=x,h=x.version,f=i.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function g(b,T){b.getRGB(Hu,Ed(i)),t.buffers.color.setClear(Hu.r,Hu.g,Hu.b,T,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,T=1){o.set(b),a=T,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,g(o,a)},render:m,addToRenderList:_,dispose:p}}function fA(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(I,k,V,D,H){let q=!1,G=h(I,D,V,k);r!==G&&(r=G,c(r.object)),q=d(I,D,V,H),q&&m(I,D,V,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,x(I,k,V,D),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(I){return i.bindVertexArray(I)}function u(I){return i.deleteVertexArray(I)}function h(I,k,V,D){let H=D.wireframe===!0,q=n[k.id];q===void 0&&(q={},n[k.id]=q);let G=I.isInstancedMesh===!0?I.id:0,ae=q[G];ae===void 0&&(ae={},q[G]=ae);let $=ae[V.id];$===void 0&&($={},ae[V.id]=$);let K=$[H];return K===void 0&&(K=f(l()),$[H]=K),K}function f(I){let k=[],V=[],D=[];for(let H=0;H<t;H++)k[H]=0,V[H]=0,D[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:V,attributeDivisors:D,object:I,attributes:{},index:null}}function d(I,k,V,D){let H=r.attributes,q=k.attributes,G=0,ae=V.getAttributes();for(let $ in ae)if(ae[$].location>=0){let ee=H[$],de=q[$];if(de===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(de=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(de=I.instanceColor)),ee===void 0||ee.attribute!==de||de&&ee.data!==de.data)return!0;G++}return r.attributesNum!==G||r.index!==D}function m(I,k,V,D){let H={},q=k.attributes,G=0,ae=V.getAttributes();for(let $ in ae)if(ae[$].location>=0){let ee=q[$];ee===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(ee=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(ee=I.instanceColor));let de={};de.attribute=ee,ee&&ee.data&&(de.data=ee.data),H[$]=de,G++}r.attributes=H,r.attributesNum=G,r.index=D}function _(){let I=r.newAttributes;for(let k=0,V=I.length;k<V;k++)I[k]=0}function g(I){p(I,0)}function p(I,k){let V=r.newAttributes,D=r.enabledAttributes,H=r.attributeDivisors;V[I]=1,D[I]===0&&(i.enableVertexAttribArray(I),D[I]=1),H[I]!==k&&(i.vertexAttribDivisor(I,k),H[I]=k)}function b(){let I=r.newAttributes,k=r.enabledAttributes;for(let V=0,D=k.length;V<D;V++)k[V]!==I[V]&&(i.disableVertexAttribArray(V),k[V]=0)}function T(I,k,V,D,H,q,G){G===!0?i.vertexAttribIPointer(I,k,V,H,q):i.vertexAttribPointer(I,k,V,D,H,q)}function x(I,k,V,D){_();let H=D.attributes,q=V.getAttributes(),G=k.defaultAttributeValues;for(let ae in q){let $=q[ae];if($.location>=0){let K=H[ae];if(K===void 0&&(ae==="instanceMatrix"&&I.instanceMatrix&&(K=I.instanceMatrix),ae==="instanceColor"&&I.instanceColor&&(K=I.instanceColor)),K!==void 0){let ee=K.normalized,de=K.itemSize,ue=e.get(K);if(ue===void 0)continue;let j=ue.buffer,ye=ue.type,se=ue.bytesPerElement,me=ye===i.INT||ye===i.UNSIGNED_INT||K.gpuType===ou;if(K.isInterleavedBufferAttribute){let pe=K.data,Oe=pe.isInterleavedBuffer===!0?pe.stride:pe.itemSize,Xe=K.offset;if(pe.isInstancedInterleavedBuffer||pe.isInstancedBufferAttribute){for(let Ge=0;Ge<$.locationSize;Ge++)p($.location+Ge,pe.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=pe.meshPerAttribute*pe.count)}else for(let Ge=0;Ge<$.locationSize;Ge++)g($.location+Ge);i.bindBuffer(i.ARRAY_BUFFER,j);for(let Ge=0;Ge<$.locationSize;Ge++)T($.location+Ge,de/$.locationSize,ye,ee,Oe*se,(Xe+de/$.locationSize*Ge)*se,me)}else{if(K.isInstancedBufferAttribute){for(let pe=0;pe<$.locationSize;pe++)p($.location+pe,K.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let pe=0;pe<$.locationSize;pe++)g($.location+pe);i.bindBuffer(i.ARRAY_BUFFER,j);for(let pe=0;pe<$.locationSize;pe++)T($.location+pe,de/$.locationSize,ye,ee,de*se,de/$.locationSize*pe*se,me)}}else if(G!==void 0){let ee=G[ae];if(ee!==void 0)switch(ee.length){case 2:i.vertexAttrib2fv($.location,ee);break;case 3:i.vertexAttrib3fv($.location,ee);break;case 4:i.vertexAttrib4fv($.location,ee);break;default:i.vertexAttrib1fv($.location,ee)}}}}b()}function R(){O();for(let I in n){let k=n[I];for(let V in k){let D=k[V];for(let H in D){let q=D[H];for(let G in q)u(q[G].object),delete q[G];delete D[H]}}delete n[I]}}function w(I){if(n[I.id]===void 0)return;let k=n[I.id];for(let V in k){let D=k[V];for(let H in D){let q=D[H];for(let G in q)u(q[G].object),delete q[G];delete D[H]}}delete n[I.id]}function y(I){for(let k in n){let V=n[k];for(let D in V){let H=V[D];if(H[I.id]===void 0)continue;let q=H[I.id];for(let G in q)u(q[G].object),delete q[G];delete H[I.id]}}}function E(I){for(let k in n){let V=n[k],D=I.isInstancedMesh===!0?I.id:0,H=V[D];if(H!==void 0){for(let q in H){let G=H[q];for(let ae in G)u(G[ae].object),delete G[ae];delete H[q]}delete V[D],Object.keys(V).length===0&&delete n[k]}}}function O(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:L,dispose:R,releaseStatesOfGeometry:w,releaseStatesOfObject:E,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:g,disableUnusedAttributes:b}}function dA(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];t.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function pA(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ji&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let E=y===Zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==oi&&y!==Yi&&!E&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:b,maxVaryings:T,maxFragmentUniforms:x,maxSamples:R,samples:w}}function mA(i){let e=this,t=null,n=0,s=!1,r=!1,o=new xi,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||s;return s=f,n=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let m=h.clippingPlanes,_=h.clipIntersection,g=h.clipShadows,p=i.get(h);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let b=r?0:n,T=b*4,x=p.clippingState||null;l.value=x,x=u(m,f,T,d);for(let R=0;R!==T;++R)x[R]=t[R];p.clippingState=x,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,f,d,m){let _=h!==null?h.length:0,g=null;if(_!==0){if(g=l.value,m!==!0||g===null){let p=d+_*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(g===null||g.length<p)&&(g=new Float32Array(p));for(let T=0,x=d;T!==_;++T,x+=4)o.copy(h[T]).applyMatrix4(b,a),o.normal.toArray(g,x),g[x+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,g}}var hl=class extends vi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Ua(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new tr(5,5,5),r=new Pi({name:"CubemapFromEquirect",uniforms:Br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ni,blending:Fr});r.uniforms.tEquirect.value=t;let o=new Bt(s,r),a=t.minFilter;return t.minFilter===Fs&&(t.minFilter=ti),new ko(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},__=256,gA=3,_A=20,z_=256,V_=16,yA=3,xA=new B,vA=new at,Xu=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ko(1,10,null),this._boxMesh=new Bt(new tr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=xA}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(vA));let g=new ko(n,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=m,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=v_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=x_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(__,Md(e))}_fromTexture(e,t){e.mapping===Ur||e.mapping===Go?this._setSize(e.image.length===0?__:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=y_(e,!1,!1),n=Math.log2(e)-gA;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=y_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ur||e.mapping===Go?(this._cubemapMaterial===null&&(this._cubemapMaterial=v_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=x_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=bA(),this._integrationMaterial=SA());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/V_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-yA)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(z_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=MA());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function y_(i,e,t){return new hl(i,{minFilter:Fs,generateMipmaps:e,type:Zi,colorSpace:Ea,depthBuffer:t})}function fl(i,e,t){return new Pi({name:i,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:ni,blending:Fr,depthTest:!1,depthWrite:!1})}function bA(){return fl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${z_}u

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
	`)}function SA(){return fl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:V_}},`

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
	`)}function MA(){return fl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${_A}
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
	`)}function x_(){return fl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function v_(){return fl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function wA(i){let e=new WeakMap,t=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===iu||d===su)if(e.has(f)){let m=e.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let _=new hl(m.height);return _.fromEquirectangularTexture(i,f),e.set(f,_),f.addEventListener("dispose",c),a(_.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,m=d===iu||d===su,_=d===Ur||d===Go;if(m||_){let g=t.get(f),p=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return n===null&&(n=new Xu(i)),g=m?n.fromEquirectangular(f,g):n.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),g.texture;if(g!==void 0)return g.texture;{let b=f.image;return m&&b&&b.height>0||_&&b&&l(b)?(n===null&&(n=new Xu(i)),g=m?n.fromEquirectangular(f):n.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===iu?f.mapping=Ur:d===su&&(f.mapping=Go),f}function l(f){let d=0,m=6;for(let _=0;_<m;_++)f[_]!==void 0&&d++;return d===m}function c(f){let d=f.target;d.removeEventListener("dispose",c);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function AA(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Sa("WebGLRenderer: "+n+" extension not supported."),s}}}function EA(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let _=r.get(m);_&&(e.remove(_),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function u(m){let _=m.attributes;for(let g in _)e.update(_[g],i.ARRAY_BUFFER)}function h(m){let _=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let b=_!==null?_.array.length:g.array.length/3-1,T=g.count>=65535?Fa:Da,x=new T(Math.ceil(b/3)*6,1),R=x.array;if(_!==null){let y=_.array;p=_.version;for(let E=0,O=0;E<b;E+=3){let L=y[E+0],I=y[E+1],k=y[E+2];R[O++]=L,R[O++]=I,R[O++]=I,R[O++]=k,R[O++]=k,R[O++]=L}}else{p=g.version;for(let y=0,E=0;y<b;y+=3){let O=y+0,L=y+1,I=y+2;R[E++]=O,R[E++]=L,R[E++]=L,R[E++]=I,R[E++]=I,R[E++]=O}}x.version=p;let w=r.get(m);w&&e.remove(w),r.set(m,x)}function f(m){let _=r.get(m);if(_){let g=m.index;g!==null&&_.version<g.version&&h(m)}else h(m);return r.get(m)}function d(){for(let m in s){let _=s[m].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function TA(i,e,t){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){i.drawElements(n,f,r,h*o),t.update(f,n,1)}function c(h,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,h*o,d),t.update(f,n,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,h,0,d);let _=0;for(let g=0;g<d;g++)_+=f[g];t.update(_,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function RA(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function CA(i,e,t){let n=new WeakMap,s=new Tt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let O=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",O)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],T=0;d===!0&&(T=1),m===!0&&(T=2),_===!0&&(T=3);let x=a.attributes.position.count*T,R=1;x>e.maxTextureSize&&(R=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let w=new Float32Array(x*R*4*h),y=new Pa(w,x,R,h);y.type=Yi,y.needsUpdate=!0;let E=T*4;for(let L=0;L<h;L++){let I=g[L],k=p[L],V=b[L],D=x*R*4*L;for(let H=0;H<I.count;H++){let q=H*E;d===!0&&(s.fromBufferAttribute(I,H),w[D+q+0]=s.x,w[D+q+1]=s.y,w[D+q+2]=s.z,w[D+q+3]=0),m===!0&&(s.fromBufferAttribute(k,H),w[D+q+4]=s.x,w[D+q+5]=s.y,w[D+q+6]=s.z,w[D+q+7]=0),_===!0&&(s.fromBufferAttribute(V,H),w[D+q+8]=s.x,w[D+q+9]=s.y,w[D+q+10]=s.z,w[D+q+11]=V.itemSize===4?s.w:1)}}f={count:h,texture:y,size:new Ze(x,R)},n.set(a,f),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let d=0;for(let _=0;_<c.length;_++)d+=c[_];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function PA(i,e,t,n,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var IA={[td]:"LINEAR_TONE_MAPPING",[nd]:"REINHARD_TONE_MAPPING",[id]:"CINEON_TONE_MAPPING",[sd]:"ACES_FILMIC_TONE_MAPPING",[od]:"AGX_TONE_MAPPING",[ad]:"NEUTRAL_TONE_MAPPING",[rd]:"CUSTOM_TONE_MAPPING"};function LA(i,e,t,n,s,r){let o=new vi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new nn;u.setAttribute("position",new Ot([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ot([0,2,0,0,2,0],2));let h=new Vc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Bt(u,h),d=new Za(-1,1,1,-1,0,1),m=null,_=null,g=!1,p,b=null,T=[],x=!1;this.setSize=function(R,w){o.setSize(R,w),a!==null&&a.setSize(R,w),l!==null&&l.setSize(R,w);for(let y=0;y<T.length;y++){let E=T[y];E.setSize&&E.setSize(R,w)}},this.setEffects=function(R){T=R,x=T.length>0&&T[0].isRenderPass===!0;let w=o.width,y=o.height;T.length>0&&a===null&&(a=new vi(w,y,{type:Zi,depthBuffer:!1,stencilBuffer:!1}),l=new vi(w,y,{type:Zi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&T.some(O=>O.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Ds(w,y),r===!0&&(c.format=Ns,c.type=Or)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let O=0;O<T.length;O++){let L=T[O];L.setSize&&L.setSize(w,y),E&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(R,w){if(g||R.toneMapping===fs&&T.length===0)return!1;if(b=w,w!==null){let y=w.width,E=w.height;(o.width!==y||o.height!==E)&&this.setSize(y,E)}return x===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=fs,!0},this.hasRenderPass=function(){return x},this.end=function(R,w){R.toneMapping=p,g=!0;let y=o,E=a;for(let O=0;O<T.length;O++){let L=T[O];L.enabled!==!1&&(L.render(R,E,y,w),L.needsSwap!==!1&&(y=E,E=E===a?l:a))}if(m!==R.outputColorSpace||_!==R.toneMapping){m=R.outputColorSpace,_=R.toneMapping,h.defines={},yt.getTransfer(m)===Et&&(h.defines.SRGB_TRANSFER="");let O=IA[_];O&&(h.defines[O]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(b),R.render(f,d),b=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var G_=new ri,H_=new Ds(1,1),W_=new Oa(1),X_=new Pa,q_=new Nc,$_=new Ua,b_=[],S_=[],M_=new Float32Array(16),w_=new Float32Array(9),A_=new Float32Array(4);function Xo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=b_[s];if(r===void 0&&(r=new Float32Array(s),b_[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function xn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function vn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function $u(i,e){let t=S_[e];t===void 0&&(t=new Int32Array(e),S_[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function DA(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function FA(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(xn(t,e))return;i.uniform2fv(this.addr,e),vn(t,e)}}function NA(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(xn(t,e))return;i.uniform3fv(this.addr,e),vn(t,e)}}function UA(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(xn(t,e))return;i.uniform4fv(this.addr,e),vn(t,e)}}function OA(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(xn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),vn(t,e)}else{if(xn(t,n))return;A_.set(n),i.uniformMatrix2fv(this.addr,!1,A_),vn(t,n)}}function BA(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(xn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),vn(t,e)}else{if(xn(t,n))return;w_.set(n),i.uniformMatrix3fv(this.addr,!1,w_),vn(t,n)}}function kA(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(xn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),vn(t,e)}else{if(xn(t,n))return;M_.set(n),i.uniformMatrix4fv(this.addr,!1,M_),vn(t,n)}}function zA(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function VA(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(xn(t,e))return;i.uniform2iv(this.addr,e),vn(t,e)}}function GA(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(xn(t,e))return;i.uniform3iv(this.addr,e),vn(t,e)}}function HA(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(xn(t,e))return;i.uniform4iv(this.addr,e),vn(t,e)}}function WA(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function XA(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(xn(t,e))return;i.uniform2uiv(this.addr,e),vn(t,e)}}function qA(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(xn(t,e))return;i.uniform3uiv(this.addr,e),vn(t,e)}}function $A(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(xn(t,e))return;i.uniform4uiv(this.addr,e),vn(t,e)}}function Yu(i){return i.version===0&&(i.compareFunction=yd,i.needsUpdate=!0),i}function YA(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Yu(H_):r=G_,t.setTexture2D(e||r,s)}function ZA(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||q_,s)}function JA(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Yu(W_):r=$_,t.setTextureCube(e||r,s)}function KA(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||X_,s)}function jA(i){switch(i){case 5126:return DA;case 35664:return FA;case 35665:return NA;case 35666:return UA;case 35674:return OA;case 35675:return BA;case 35676:return kA;case 5124:case 35670:return zA;case 35667:case 35671:return VA;case 35668:case 35672:return GA;case 35669:case 35673:return HA;case 5125:return WA;case 36294:return XA;case 36295:return qA;case 36296:return $A;case 35678:case 36198:case 36298:case 36306:case 35682:return YA;case 35679:case 36299:case 36307:return ZA;case 35680:case 36300:case 36308:case 36293:return JA;case 36289:case 36303:case 36311:case 36292:return KA}}function QA(i,e){i.uniform1fv(this.addr,e)}function eE(i,e){let t=Xo(e,this.size,2);i.uniform2fv(this.addr,t)}function tE(i,e){let t=Xo(e,this.size,3);i.uniform3fv(this.addr,t)}function nE(i,e){let t=Xo(e,this.size,4);i.uniform4fv(this.addr,t)}function iE(i,e){let t=Xo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function sE(i,e){let t=Xo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function rE(i,e){let t=Xo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function oE(i,e){i.uniform1iv(this.addr,e)}function aE(i,e){i.uniform2iv(this.addr,e)}function lE(i,e){i.uniform3iv(this.addr,e)}function cE(i,e){i.uniform4iv(this.addr,e)}function uE(i,e){i.uniform1uiv(this.addr,e)}function hE(i,e){i.uniform2uiv(this.addr,e)}function fE(i,e){i.uniform3uiv(this.addr,e)}function dE(i,e){i.uniform4uiv(this.addr,e)}function pE(i,e,t){let n=this.cache,s=e.length,r=$u(t,s);xn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Yu(H_):o=G_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function mE(i,e,t){let n=this.cache,s=e.length,r=$u(t,s);xn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||q_,r[o])}function gE(i,e,t){let n=this.cache,s=e.length,r=$u(t,s);xn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Yu(W_):o=$_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function _E(i,e,t){let n=this.cache,s=e.length,r=$u(t,s);xn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||X_,r[o])}function yE(i){switch(i){case 5126:return QA;case 35664:return eE;case 35665:return tE;case 35666:return nE;case 35674:return iE;case 35675:return sE;case 35676:return rE;case 5124:case 35670:return oE;case 35667:case 35671:return aE;case 35668:case 35672:return lE;case 35669:case 35673:return cE;case 5125:return uE;case 36294:return hE;case 36295:return fE;case 36296:return dE;case 35678:case 36198:case 36298:case 36306:case 35682:return pE;case 35679:case 36299:case 36307:return mE;case 35680:case 36300:case 36308:case 36293:return gE;case 36289:case 36303:case 36311:case 36292:return _E}}var Ld=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=jA(t.type)}},Dd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=yE(t.type)}},Fd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Pd=/(\w+)(\])?(\[|\.)?/g;function E_(i,e){i.seq.push(e),i.map[e.id]=e}function xE(i,e,t){let n=i.name,s=n.length;for(Pd.lastIndex=0;;){let r=Pd.exec(n),o=Pd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){E_(t,c===void 0?new Ld(a,i,e):new Dd(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new Fd(a),E_(t,h)),t=h}}}var Wo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);xE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function T_(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var vE=37297,bE=0;function SE(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var R_=new nt;function ME(i){yt._getMatrix(R_,yt.workingColorSpace,i);let e=`mat3( ${R_.elements.map(t=>t.toFixed(4))} )`;switch(yt.getTransfer(i)){case Ta:return[e,"LinearTransferOETF"];case Et:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function C_(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+SE(i.getShaderSource(e),a)}else return r}function wE(i,e){let t=ME(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var AE={[td]:"Linear",[nd]:"Reinhard",[id]:"Cineon",[sd]:"ACESFilmic",[od]:"AgX",[ad]:"Neutral",[rd]:"Custom"};function EE(i,e){let t=AE[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Wu=new B;function TE(){yt.getLuminanceCoefficients(Wu);let i=Wu.x.toFixed(4),e=Wu.y.toFixed(4),t=Wu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function RE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ul).join(`
`)}function CE(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function PE(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function ul(i){return i!==""}function P_(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function I_(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var IE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Nd(i){return i.replace(IE,LE)}function LE(i,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Nd(t)}var DE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function L_(i){return i.replace(DE,FE)}function FE(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function D_(i){let e=`precision ${i.precision} float;
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
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var NE={[Dr]:"SHADOWMAP_TYPE_PCF",[zo]:"SHADOWMAP_TYPE_VSM"};function UE(i){return NE[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var OE={[Go]:"ENVMAP_MODE_REFRACTION"};function BE(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":OE[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kE={[nu]:"ENVMAP_BLENDING_MULTIPLY",[Q0]:"ENVMAP_BLENDING_MIX",[e_]:"ENVMAP_BLENDING_ADD"};function zE(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":kE[i.combine]||"ENVMAP_BLENDING_NONE"}function VE(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=UE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=BE(t),h=zE(t),f=RE(t),d=CE(r),m=s.createProgram(),_,g,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ul).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ul).join(`
`),g.length>0&&(g+=`
`)):(_=[D_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ul).join(`
`),g=[D_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==fs?"#define TONE_MAPPING":"",t.toneMapping!==fs?ht.tonemapping_pars_fragment:"",t.toneMapping!==fs?EE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,wE("linearToOutputTexel",t.outputColorSpace),TE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ul).join(`
`)),o=Nd(o),o=P_(o,t),o=I_(o,t),a=Nd(a),a=P_(a,t),a=I_(a,t),o=L_(o),a=L_(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,_=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",t.glslVersion===bd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===bd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let b=p+_+o,T=p+g+a,x=T_(s,s.VERTEX_SHADER,b),R=T_(s,s.FRAGMENT_SHADER,T);s.attachShader(m,x),s.attachShader(m,R),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function w(L){if(i.debug.checkShaderErrors){let I=s.getProgramInfoLog(m)||"",k=s.getShaderInfoLog(x)||"",V=s.getShaderInfoLog(R)||"",D=I.trim(),H=k.trim(),q=V.trim(),G=!0,ae=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,x,R);else{let $=C_(s,x,"vertex"),K=C_(s,R,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+D+`
`+$+`
`+K)}else D!==""?$e("WebGLProgram: Program Info Log:",D):(H===""||q==="")&&(ae=!1);ae&&(L.diagnostics={runnable:G,programLog:D,vertexShader:{log:H,prefix:_},fragmentShader:{log:q,prefix:g}})}s.deleteShader(x),s.deleteShader(R),y=new Wo(s,m),E=PE(s,m)}let y;this.getUniforms=function(){return y===void 0&&w(this),y};let E;this.getAttributes=function(){return E===void 0&&w(this),E};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(m,vE)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=bE++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=x,this.fragmentShader=R,this}var GE=0,Ud=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Od(e),t.set(e,n)),n}},Od=class{constructor(e){this.id=GE++,this.code=e,this.usedTimes=0}};function HE(i){return i===ur||i===rl||i===ol}function WE(i,e,t,n,s,r){let o=new Ia,a=new Ud,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,E,O,L,I,k){let V=L.fog,D=I.geometry,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,G=e.get(y.envMap||H,q),ae=f[y.type],$=n.precision;y.precision!==null&&($=n.getMaxPrecision(y.precision),$!==y.precision&&$e("WebGLProgram.getParameters:",y.precision,"not supported, using",$,"instead."));let K=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ee=K!==void 0?K.length:0,de=0;D.morphAttributes.position!==void 0&&(de=1),D.morphAttributes.normal!==void 0&&(de=2),D.morphAttributes.color!==void 0&&(de=3);let ue,j,ye,se;if(ae){let Re=ii[ae];ue=Re.vertexShader,j=Re.fragmentShader}else{ue=y.vertexShader,j=y.fragmentShader;let Re=a.getVertexShaderStage(y),lt=a.getFragmentShaderStage(y);a.update(y,Re,lt),ye=Re.id,se=lt.id}let me=i.getRenderTarget(),pe=i.state.buffers.depth.getReversed(),Oe=I.isInstancedMesh===!0,Xe=I.isBatchedMesh===!0,Ge=!!y.map,ft=!!y.matcap,ct=!!G,it=ct&&G.isPMREMTexture===!0,$t=!!y.aoMap,zt=!!y.lightMap,on=!!y.bumpMap&&y.wireframe===!1,It=!!y.normalMap,Sn=!!y.displacementMap,xt=!!y.emissiveMap,mn=!!y.metalnessMap,Jt=!!y.roughnessMap,an=y.anisotropy>0,U=y.clearcoat>0,Ce=y.diffuseRoughness>0,Ye=y.dispersion>0,rt=y.retroreflectivity>0,we=y.iridescence>0,Dt=y.sheen>0,Ve=y.transmission>0,qe=an&&!!y.anisotropyMap,C=U&&!!y.clearcoatMap,S=U&&!!y.clearcoatNormalMap,X=U&&!!y.clearcoatRoughnessMap,fe=Ce&&!!y.diffuseRoughnessMap,oe=we&&!!y.iridescenceMap,ve=we&&!!y.iridescenceThicknessMap,be=Dt&&!!y.sheenColorMap,te=Dt&&!!y.sheenRoughnessMap,ie=!!y.specularMap,_e=!!y.specularColorMap,N=!!y.specularIntensityMap,re=Ve&&!!y.transmissionMap,ne=Ve&&!!y.thicknessMap,Ae=!!y.gradientMap,xe=!!y.alphaMap,Me=y.alphaTest>0,He=!!y.alphaHash,je=!!y.extensions,he=fs;y.toneMapped&&(me===null||me.isXRRenderTarget===!0)&&(he=i.toneMapping);let Be=it?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Qe={shaderID:ae,shaderType:y.type,shaderName:y.name,vertexShader:ue,fragmentShader:j,defines:y.defines,customVertexShaderID:ye,customFragmentShaderID:se,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:$,batching:Xe,batchingColor:Xe&&I._colorsTexture!==null,instancing:Oe,instancingColor:Oe&&I.instanceColor!==null,instancingMorph:Oe&&I.morphTexture!==null,outputColorSpace:me===null?i.outputColorSpace:me.isXRRenderTarget===!0?me.texture.colorSpace:yt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ge,matcap:ft,envMap:ct,envMapMode:ct&&G.mapping,envMapPMREM:it,envMapMaxLod:it?Be.length-1:null,envMapSize:it?Be[0].width:null,aoMap:$t,lightMap:zt,bumpMap:on,normalMap:It,displacementMap:Sn,emissiveMap:xt,normalMapObjectSpace:It&&y.normalMapType===i_,normalMapTangentSpace:It&&y.normalMapType===al,packedNormalMap:It&&y.normalMapType===al&&HE(y.normalMap.format),metalnessMap:mn,roughnessMap:Jt,anisotropy:an,anisotropyMap:qe,clearcoat:U,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:X,diffuseRoughness:Ce,diffuseRoughnessMap:fe,dispersion:Ye,retroreflection:rt,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:ve,sheen:Dt,sheenColorMap:be,sheenRoughnessMap:te,specularMap:ie,specularColorMap:_e,specularIntensityMap:N,transmission:Ve,transmissionMap:re,thicknessMap:ne,gradientMap:Ae,opaque:y.transparent===!1&&y.blending===Vo&&y.alphaToCoverage===!1,alphaMap:xe,alphaTest:Me,alphaHash:He,combine:y.combine,mapUv:Ge&&d(y.map.channel),aoMapUv:$t&&d(y.aoMap.channel),lightMapUv:zt&&d(y.lightMap.channel),bumpMapUv:on&&d(y.bumpMap.channel),normalMapUv:It&&d(y.normalMap.channel),displacementMapUv:Sn&&d(y.displacementMap.channel),emissiveMapUv:xt&&d(y.emissiveMap.channel),metalnessMapUv:mn&&d(y.metalnessMap.channel),roughnessMapUv:Jt&&d(y.roughnessMap.channel),anisotropyMapUv:qe&&d(y.anisotropyMap.channel),clearcoatMapUv:C&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:fe&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:be&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(y.sheenRoughnessMap.channel),specularMapUv:ie&&d(y.specularMap.channel),specularColorMapUv:_e&&d(y.specularColorMap.channel),specularIntensityMapUv:N&&d(y.specularIntensityMap.channel),transmissionMapUv:re&&d(y.transmissionMap.channel),thicknessMapUv:ne&&d(y.thicknessMap.channel),alphaMapUv:xe&&d(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(It||an),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!D.attributes.uv&&(Ge||xe),fog:!!V,useFog:y.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&It===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:pe,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:de,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:k.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:Ge&&y.map.isVideoTexture===!0&&yt.getTransfer(y.map.colorSpace)===Et,decodeVideoTextureEmissive:xt&&y.emissiveMap.isVideoTexture===!0&&yt.getTransfer(y.emissiveMap.colorSpace)===Et,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Ii,flipSided:y.side===ni,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:je&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&y.extensions.multiDraw===!0||Xe)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function _(y){let E=[];if(y.shaderID?E.push(y.shaderID):(E.push(y.customVertexShaderID),E.push(y.customFragmentShaderID)),y.defines!==void 0)for(let O in y.defines)E.push(O),E.push(y.defines[O]);return y.isRawShaderMaterial===!1&&(g(E,y),p(E,y),E.push(i.outputColorSpace)),E.push(y.customProgramCacheKey),E.join()}function g(y,E){y.push(E.precision),y.push(E.outputColorSpace),y.push(E.envMapMode),y.push(E.envMapPMREM),y.push(E.envMapMaxLod),y.push(E.envMapSize),y.push(E.mapUv),y.push(E.alphaMapUv),y.push(E.lightMapUv),y.push(E.aoMapUv),y.push(E.bumpMapUv),y.push(E.normalMapUv),y.push(E.displacementMapUv),y.push(E.emissiveMapUv),y.push(E.metalnessMapUv),y.push(E.roughnessMapUv),y.push(E.anisotropyMapUv),y.push(E.clearcoatMapUv),y.push(E.clearcoatNormalMapUv),y.push(E.clearcoatRoughnessMapUv),y.push(E.diffuseRoughnessMapUv),y.push(E.iridescenceMapUv),y.push(E.iridescenceThicknessMapUv),y.push(E.sheenColorMapUv),y.push(E.sheenRoughnessMapUv),y.push(E.specularMapUv),y.push(E.specularColorMapUv),y.push(E.specularIntensityMapUv),y.push(E.transmissionMapUv),y.push(E.thicknessMapUv),y.push(E.combine),y.push(E.fogExp2),y.push(E.sizeAttenuation),y.push(E.morphTargetsCount),y.push(E.numSunLights),y.push(E.numDirLights),y.push(E.numPointLights),y.push(E.numSpotLights),y.push(E.numSpotLightMaps),y.push(E.numHemiLights),y.push(E.numRectAreaLights),y.push(E.numSunLightShadows),y.push(E.numDirLightShadows),y.push(E.numPointLightShadows),y.push(E.numSpotLightShadows),y.push(E.numSpotLightShadowsWithMaps),y.push(E.numLightProbes),y.push(E.numLightProbeGrids),y.push(E.shadowMapType),y.push(E.toneMapping),y.push(E.numClippingPlanes),y.push(E.numClipIntersection),y.push(E.depthPacking)}function p(y,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function b(y){let E=f[y.type],O;if(E){let L=ii[E];O=ll.clone(L.uniforms)}else O=y.uniforms;return O}function T(y,E){let O=u.get(E);return O!==void 0?++O.usedTimes:(O=new VE(i,E,y,s),c.push(O),u.set(E,O)),O}function x(y){if(--y.usedTimes===0){let E=c.indexOf(y);c[E]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function R(y){a.remove(y)}function w(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:b,acquireProgram:T,releaseProgram:x,releaseShaderCache:R,programs:c,dispose:w}}function XE(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function qE(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function F_(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function N_(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,m,_,g,p){let b=i[e];return b===void 0?(b={id:f.id,object:f,geometry:d,material:m,materialVariant:o(f),groupOrder:_,renderOrder:f.renderOrder,z:g,group:p},i[e]=b):(b.id=f.id,b.object=f,b.geometry=d,b.material=m,b.materialVariant=o(f),b.groupOrder=_,b.renderOrder=f.renderOrder,b.z=g,b.group=p),e++,b}function l(f,d,m,_,g,p,b){b.reversedDepth===!0&&(g=-g);let T=a(f,d,m,_,g,p);m.transmission>0?n.push(T):m.transparent===!0?s.push(T):t.push(T)}function c(f,d,m,_,g,p){let b=a(f,d,m,_,g,p);m.transmission>0?n.unshift(b):m.transparent===!0?s.unshift(b):t.unshift(b)}function u(f,d){t.length>1&&t.sort(f||qE),n.length>1&&n.sort(d||F_),s.length>1&&s.sort(d||F_)}function h(){for(let f=e,d=i.length;f<d;f++){let m=i[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function $E(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new N_,i.set(n,[o])):s>=r.length?(o=new N_,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function YE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new B,color:new at};break;case"SpotLight":t={position:new B,direction:new B,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new B,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new B,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new B,halfWidth:new B,halfHeight:new B};break}return i[e.id]=t,t}}}function ZE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var JE=0;function KE(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function jE(i){let e=new YE,t=ZE(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new B);let s=new B,r=new Ut,o=new Ut;function a(c){let u=0,h=0,f=0;for(let k=0;k<9;k++)n.probe[k].set(0,0,0);let d=0,m=0,_=0,g=0,p=0,b=0,T=0,x=0,R=0,w=0,y=0,E=0,O=0,L=0;c.sort(KE);for(let k=0,V=c.length;k<V;k++){let D=c[k],H=D.color,q=D.intensity,G=D.distance,ae=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===ur?ae=D.shadow.map.texture:ae=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=H.r*q,h+=H.g*q,f+=H.b*q;else if(D.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(D.sh.coefficients[$],q);L++}else if(D.isSunLight){let $=e.get(D);if($.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,ee=t.get(D);ee.shadowIntensity=K.intensity,ee.shadowBias=K.bias,ee.shadowNormalBias=K.normalBias,ee.shadowRadius=K.radius,ee.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),n.sunShadow[m]=ee,n.sunShadowMap[m]=ae;let de=K.getViewportCount();for(let ue=0;ue<de;ue++)n.sunShadowMatrix[_+ue]=K.getMatrix(ue),n.sunShadowCascade[_+ue]=K._cascadeData[ue];_+=de,m++}n.sun[d]=$,d++}else if(D.isDirectionalLight){let $=e.get(D);if($.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,ee=t.get(D);ee.shadowIntensity=K.intensity,ee.shadowBias=K.bias,ee.shadowNormalBias=K.normalBias,ee.shadowRadius=K.radius,ee.shadowMapSize=K.mapSize,n.directionalShadow[g]=ee,n.directionalShadowMap[g]=ae,n.directionalShadowMatrix[g]=D.shadow.matrix,R++}n.directional[g]=$,g++}else if(D.isSpotLight){let $=e.get(D);$.position.setFromMatrixPosition(D.matrixWorld),$.color.copy(H).multiplyScalar(q),$.distance=G,$.coneCos=Math.cos(D.angle),$.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),$.decay=D.decay,n.spot[b]=$;let K=D.shadow;if(D.map&&(n.spotLightMap[E]=D.map,E++,K.updateMatrices(D),D.castShadow&&O++),n.spotLightMatrix[b]=K.matrix,D.castShadow){let ee=t.get(D);ee.shadowIntensity=K.intensity,ee.shadowBias=K.bias,ee.shadowNormalBias=K.normalBias,ee.shadowRadius=K.radius,ee.shadowMapSize=K.mapSize,n.spotShadow[b]=ee,n.spotShadowMap[b]=ae,y++}b++}else if(D.isRectAreaLight){let $=e.get(D);$.color.copy(H).multiplyScalar(q),$.halfWidth.set(D.width*.5,0,0),$.halfHeight.set(0,D.height*.5,0),n.rectArea[T]=$,T++}else if(D.isPointLight){let $=e.get(D);if($.color.copy(D.color).multiplyScalar(D.intensity),$.distance=D.distance,$.decay=D.decay,D.castShadow){let K=D.shadow,ee=t.get(D);ee.shadowIntensity=K.intensity,ee.shadowBias=K.bias,ee.shadowNormalBias=K.normalBias,ee.shadowRadius=K.radius,ee.shadowMapSize=K.mapSize,ee.shadowCameraNear=K.camera.near,ee.shadowCameraFar=K.camera.far,n.pointShadow[p]=ee,n.pointShadowMap[p]=ae,n.pointShadowMatrix[p]=D.shadow.matrix,w++}n.point[p]=$,p++}else if(D.isHemisphereLight){let $=e.get(D);$.skyColor.copy(D.color).multiplyScalar(q),$.groundColor.copy(D.groundColor).multiplyScalar(q),n.hemi[x]=$,x++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Pe.LTC_FLOAT_1,n.rectAreaLTC2=Pe.LTC_FLOAT_2):(n.rectAreaLTC1=Pe.LTC_HALF_1,n.rectAreaLTC2=Pe.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let I=n.hash;(I.sunLength!==d||I.directionalLength!==g||I.pointLength!==p||I.spotLength!==b||I.rectAreaLength!==T||I.hemiLength!==x||I.numSunShadows!==m||I.numDirectionalShadows!==R||I.numPointShadows!==w||I.numSpotShadows!==y||I.numSpotMaps!==E||I.numLightProbes!==L)&&(n.sun.length=d,n.directional.length=g,n.spot.length=b,n.rectArea.length=T,n.point.length=p,n.hemi.length=x,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+E-O,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=L,I.sunLength=d,I.directionalLength=g,I.pointLength=p,I.spotLength=b,I.rectAreaLength=T,I.hemiLength=x,I.numSunShadows=m,I.numDirectionalShadows=R,I.numPointShadows=w,I.numSpotShadows=y,I.numSpotMaps=E,I.numLightProbes=L,n.version=JE++)}function l(c,u){let h=0,f=0,d=0,m=0,_=0,g=0,p=u.matrixWorldInverse;for(let b=0,T=c.length;b<T;b++){let x=c[b];if(x.isSunLight){let R=n.sun[h];R.direction.setFromMatrixPosition(x.matrixWorld),R.direction.transformDirection(p),h++}else if(x.isDirectionalLight){let R=n.directional[f];R.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),f++}else if(x.isSpotLight){let R=n.spot[m];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),m++}else if(x.isRectAreaLight){let R=n.rectArea[_];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(x.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(x.width*.5,0,0),R.halfHeight.set(0,x.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),_++}else if(x.isPointLight){let R=n.point[d];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(p),d++}else if(x.isHemisphereLight){let R=n.hemi[g];R.direction.setFromMatrixPosition(x.matrixWorld),R.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:n}}function U_(i){let e=new jE(i),t=[],n=[],s=[];function r(h){u.camera=h,t.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){n.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function QE(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new U_(i),e.set(s,[a])):r>=o.length?(a=new U_(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var eT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,tT=`uniform sampler2D shadow_pass;
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
}`,nT=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],iT=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],O_=new Ut,cl=new B,Id=new B;function sT(i,e,t){let n=new er,s=new Ze,r=new Ze,o=new Tt,a=new Gc,l=new Hc,c={},u=t.maxTextureSize,h={[cr]:ni,[ni]:cr,[Ii]:Ii},f=new Pi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ze},radius:{value:4}},vertexShader:eT,fragmentShader:tT}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new nn;m.setAttribute("position",new tn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Bt(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Dr;let p=this.type;this.render=function(w,y,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||w.length===0)return;this.type===F0&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Dr);let O=i.getRenderTarget(),L=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),k=i.state;k.setBlending(Fr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let V=p!==this.type;V&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(H=>H.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,H=w.length;D<H;D++){let q=w[D],G=q.shadow;if(G===void 0){$e("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ae=G.getFrameExtents();s.multiply(ae),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,G.mapSize.y=r.y));let $=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=$,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===zo){if(q.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new vi(s.x,s.y,{format:ur,type:Zi,minFilter:ti,magFilter:ti,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new Ds(s.x,s.y,Yi),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=Ls,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=In,G.map.depthTexture.magFilter=In}else q.isPointLight?(G.map=new hl(s.x),G.map.depthTexture=new Oa(s.x,$i)):(G.map=new vi(s.x,s.y),G.map.depthTexture=new Ds(s.x,s.y,$i)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=Ls,this.type===Dr?(G.map.depthTexture.compareFunction=$?_d:gd,G.map.depthTexture.minFilter=ti,G.map.depthTexture.magFilter=ti):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=In,G.map.depthTexture.magFilter=In);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let K=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,E);let ee=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:E.layers;for(let de=0;de<K;de++){let ue=G.getCamera(de);if(q.isPointLight){let j=G.camera,ye=G.matrix,se=q.distance||j.far;se!==j.far&&(j.far=se,j.updateProjectionMatrix()),cl.setFromMatrixPosition(q.matrixWorld),j.position.copy(cl),Id.copy(j.position),Id.add(nT[de]),j.up.copy(iT[de]),j.lookAt(Id),j.updateMatrixWorld(),ye.makeTranslation(-cl.x,-cl.y,-cl.z),O_.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),G._frustum.setFromProjectionMatrix(O_,j.coordinateSystem,j.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,de),i.clear();else{de===0&&(i.setRenderTarget(G.map),i.clear());let j=G.getViewport(de);o.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),k.viewport(o)}n=G.getFrustum(de),x(y,E,ue,q,ee,this.type)}G.isPointLightShadow!==!0&&this.type===zo&&b(G,E),G.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(O,L,I)};function b(w,y){let E=e.update(_);f.defines.VSM_SAMPLES!==w.blurSamples&&(f.defines.VSM_SAMPLES=w.blurSamples,d.defines.VSM_SAMPLES=w.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),w.mapPass===null?w.mapPass=new vi(s.x,s.y,{format:ur,type:Zi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),f.uniforms.shadow_pass.value=w.map.depthTexture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(y,null,E,f,_,null),d.uniforms.shadow_pass.value=w.mapPass.texture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(y,null,E,d,_,null)}function T(w,y,E,O){let L=null,I=E.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(I!==void 0)L=I;else if(L=E.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let k=L.uuid,V=y.uuid,D=c[k];D===void 0&&(D={},c[k]=D);let H=D[V];H===void 0&&(H=L.clone(),D[V]=H,y.addEventListener("dispose",R)),L=H}if(L.visible=y.visible,L.wireframe=y.wireframe,O===zo?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,E.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=i.properties.get(L);k.light=E}return L}function x(w,y,E,O,L,I){if(w.visible===!1)return;if(w.layers.test(L)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&I===zo)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,w.matrixWorld);let D=e.update(w),H=w.material;if(Array.isArray(H)){let q=D.groups;for(let G=0,ae=q.length;G<ae;G++){let $=q[G],K=H[$.materialIndex];if(K&&K.visible){let ee=T(w,K,O,I);w.onBeforeShadow(i,w,y,E,D,ee,$),i.renderBufferDirect(E,null,D,ee,w,$),w.onAfterShadow(i,w,y,E,D,ee,$)}}}else if(H.visible){let q=T(w,H,O,I);w.onBeforeShadow(i,w,y,E,D,q,null),i.renderBufferDirect(E,null,D,q,w,null),w.onAfterShadow(i,w,y,E,D,q,null)}}let V=w.children;for(let D=0,H=V.length;D<H;D++)x(V[D],y,E,O,L,I)}function R(w){w.target.removeEventListener("dispose",R);for(let E in c){let O=c[E],L=w.target.uuid;L in O&&(O[L].dispose(),delete O[L])}}}function rT(i,e){function t(){let N=!1,re=new Tt,ne=null,Ae=new Tt(0,0,0,0);return{setMask:function(xe){ne!==xe&&!N&&(i.colorMask(xe,xe,xe,xe),ne=xe)},setLocked:function(xe){N=xe},setClear:function(xe,Me,He,je,he){he===!0&&(xe*=je,Me*=je,He*=je),re.set(xe,Me,He,je),Ae.equals(re)===!1&&(i.clearColor(xe,Me,He,je),Ae.copy(re))},reset:function(){N=!1,ne=null,Ae.set(-1,0,0,0)}}}function n(){let N=!1,re=!1,ne=null,Ae=null,xe=null;return{setReversed:function(Me){if(re!==Me){let He=e.get("EXT_clip_control");Me?He.clipControlEXT(He.LOWER_LEFT_EXT,He.ZERO_TO_ONE_EXT):He.clipControlEXT(He.LOWER_LEFT_EXT,He.NEGATIVE_ONE_TO_ONE_EXT),re=Me;let je=xe;xe=null,this.setClear(je)}},getReversed:function(){return re},setTest:function(Me){Me?pe(i.DEPTH_TEST):Oe(i.DEPTH_TEST)},setMask:function(Me){ne!==Me&&!N&&(i.depthMask(Me),ne=Me)},setFunc:function(Me){if(re&&(Me=d_[Me]),Ae!==Me){switch(Me){case Mc:i.depthFunc(i.NEVER);break;case wc:i.depthFunc(i.ALWAYS);break;case Ac:i.depthFunc(i.LESS);break;case Po:i.depthFunc(i.LEQUAL);break;case Ec:i.depthFunc(i.EQUAL);break;case Tc:i.depthFunc(i.GEQUAL);break;case Rc:i.depthFunc(i.GREATER);break;case Cc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ae=Me}},setLocked:function(Me){N=Me},setClear:function(Me){xe!==Me&&(xe=Me,re&&(Me=1-Me),i.clearDepth(Me))},reset:function(){N=!1,ne=null,Ae=null,xe=null,re=!1}}}function s(){let N=!1,re=null,ne=null,Ae=null,xe=null,Me=null,He=null,je=null,he=null;return{setTest:function(Be){N||(Be?pe(i.STENCIL_TEST):Oe(i.STENCIL_TEST))},setMask:function(Be){re!==Be&&!N&&(i.stencilMask(Be),re=Be)},setFunc:function(Be,Qe,Re){(ne!==Be||Ae!==Qe||xe!==Re)&&(i.stencilFunc(Be,Qe,Re),ne=Be,Ae=Qe,xe=Re)},setOp:function(Be,Qe,Re){(Me!==Be||He!==Qe||je!==Re)&&(i.stencilOp(Be,Qe,Re),Me=Be,He=Qe,je=Re)},setLocked:function(Be){N=Be},setClear:function(Be){he!==Be&&(i.clearStencil(Be),he=Be)},reset:function(){N=!1,re=null,ne=null,Ae=null,xe=null,Me=null,He=null,je=null,he=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,m=[],_=null,g=!1,p=null,b=null,T=null,x=null,R=null,w=null,y=null,E=new at(0,0,0),O=0,L=!1,I=null,k=null,V=null,D=null,H=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ae=0,$=i.getParameter(i.VERSION);$.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec($)[1]),G=ae>=1):$.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),G=ae>=2);let K=null,ee={},de=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),j=new Tt().fromArray(de),ye=new Tt().fromArray(ue);function se(N,re,ne,Ae){let xe=new Uint8Array(4),Me=i.createTexture();i.bindTexture(N,Me),i.texParameteri(N,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(N,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let He=0;He<ne;He++)N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Ae,0,i.RGBA,i.UNSIGNED_BYTE,xe):i.texImage2D(re+He,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xe);return Me}let me={};me[i.TEXTURE_2D]=se(i.TEXTURE_2D,i.TEXTURE_2D,1),me[i.TEXTURE_CUBE_MAP]=se(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),me[i.TEXTURE_2D_ARRAY]=se(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),me[i.TEXTURE_3D]=se(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),pe(i.DEPTH_TEST),o.setFunc(Po),on(!1),It(Zf),pe(i.CULL_FACE),$t(Fr);function pe(N){u[N]!==!0&&(i.enable(N),u[N]=!0)}function Oe(N){u[N]!==!1&&(i.disable(N),u[N]=!1)}function Xe(N,re){return f[N]!==re?(i.bindFramebuffer(N,re),f[N]=re,N===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=re),N===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Ge(N,re){let ne=m,Ae=!1;if(N){ne=d.get(re),ne===void 0&&(ne=[],d.set(re,ne));let xe=N.textures;if(ne.length!==xe.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Me=0,He=xe.length;Me<He;Me++)ne[Me]=i.COLOR_ATTACHMENT0+Me;ne.length=xe.length,Ae=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Ae=!0);Ae&&i.drawBuffers(ne)}function ft(N){return _!==N?(i.useProgram(N),_=N,!0):!1}let ct={[Nr]:i.FUNC_ADD,[U0]:i.FUNC_SUBTRACT,[O0]:i.FUNC_REVERSE_SUBTRACT};ct[B0]=i.MIN,ct[k0]=i.MAX;let it={[z0]:i.ZERO,[V0]:i.ONE,[G0]:i.SRC_COLOR,[Qf]:i.SRC_ALPHA,[Y0]:i.SRC_ALPHA_SATURATE,[q0]:i.DST_COLOR,[W0]:i.DST_ALPHA,[H0]:i.ONE_MINUS_SRC_COLOR,[ed]:i.ONE_MINUS_SRC_ALPHA,[$0]:i.ONE_MINUS_DST_COLOR,[X0]:i.ONE_MINUS_DST_ALPHA,[Z0]:i.CONSTANT_COLOR,[J0]:i.ONE_MINUS_CONSTANT_COLOR,[K0]:i.CONSTANT_ALPHA,[j0]:i.ONE_MINUS_CONSTANT_ALPHA};function $t(N,re,ne,Ae,xe,Me,He,je,he,Be){if(N===Fr){g===!0&&(Oe(i.BLEND),g=!1);return}if(g===!1&&(pe(i.BLEND),g=!0),N!==N0){if(N!==p||Be!==L){if((b!==Nr||R!==Nr)&&(i.blendEquation(i.FUNC_ADD),b=Nr,R=Nr),Be)switch(N){case Vo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Jf:i.blendFunc(i.ONE,i.ONE);break;case Kf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case jf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:tt("WebGLState: Invalid blending: ",N);break}else switch(N){case Vo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Jf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Kf:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case jf:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",N);break}T=null,x=null,w=null,y=null,E.set(0,0,0),O=0,p=N,L=Be}return}xe=xe||re,Me=Me||ne,He=He||Ae,(re!==b||xe!==R)&&(i.blendEquationSeparate(ct[re],ct[xe]),b=re,R=xe),(ne!==T||Ae!==x||Me!==w||He!==y)&&(i.blendFuncSeparate(it[ne],it[Ae],it[Me],it[He]),T=ne,x=Ae,w=Me,y=He),(je.equals(E)===!1||he!==O)&&(i.blendColor(je.r,je.g,je.b,he),E.copy(je),O=he),p=N,L=!1}function zt(N,re){N.side===Ii?Oe(i.CULL_FACE):pe(i.CULL_FACE);let ne=N.side===ni;re&&(ne=!ne),on(ne),N.blending===Vo&&N.transparent===!1?$t(Fr):$t(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),r.setMask(N.colorWrite);let Ae=N.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),xt(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?pe(i.SAMPLE_ALPHA_TO_COVERAGE):Oe(i.SAMPLE_ALPHA_TO_COVERAGE)}function on(N){I!==N&&(N?i.frontFace(i.CW):i.frontFace(i.CCW),I=N)}function It(N){N!==L0?(pe(i.CULL_FACE),N!==k&&(N===Zf?i.cullFace(i.BACK):N===D0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Oe(i.CULL_FACE),k=N}function Sn(N){N!==V&&(G&&i.lineWidth(N),V=N)}function xt(N,re,ne){N?(pe(i.POLYGON_OFFSET_FILL),(D!==re||H!==ne)&&(D=re,H=ne,o.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):Oe(i.POLYGON_OFFSET_FILL)}function mn(N){N?pe(i.SCISSOR_TEST):Oe(i.SCISSOR_TEST)}function Jt(N){N===void 0&&(N=i.TEXTURE0+q-1),K!==N&&(i.activeTexture(N),K=N)}function an(N,re,ne){ne===void 0&&(K===null?ne=i.TEXTURE0+q-1:ne=K);let Ae=ee[ne];Ae===void 0&&(Ae={type:void 0,texture:void 0},ee[ne]=Ae),(Ae.type!==N||Ae.texture!==re)&&(K!==ne&&(i.activeTexture(ne),K=ne),i.bindTexture(N,re||me[N]),Ae.type=N,Ae.texture=re)}function U(){let N=ee[K];N!==void 0&&N.type!==void 0&&(i.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function Ce(){try{i.compressedTexImage2D(...arguments)}catch(N){tt("WebGLState:",N)}}function Ye(){try{i.compressedTexImage3D(...arguments)}catch(N){tt("WebGLState:",N)}}function rt(){try{i.texSubImage2D(...arguments)}catch(N){tt("WebGLState:",N)}}function we(){try{i.texSubImage3D(...arguments)}catch(N){tt("WebGLState:",N)}}function Dt(){try{i.compressedTexSubImage2D(...arguments)}catch(N){tt("WebGLState:",N)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(N){tt("WebGLState:",N)}}function qe(){try{i.texStorage2D(...arguments)}catch(N){tt("WebGLState:",N)}}function C(){try{i.texStorage3D(...arguments)}catch(N){tt("WebGLState:",N)}}function S(){try{i.texImage2D(...arguments)}catch(N){tt("WebGLState:",N)}}function X(){try{i.texImage3D(...arguments)}catch(N){tt("WebGLState:",N)}}function fe(N){return h[N]!==void 0?h[N]:i.getParameter(N)}function oe(N,re){h[N]!==re&&(i.pixelStorei(N,re),h[N]=re)}function ve(N){j.equals(N)===!1&&(i.scissor(N.x,N.y,N.z,N.w),j.copy(N))}function be(N){ye.equals(N)===!1&&(i.viewport(N.x,N.y,N.z,N.w),ye.copy(N))}function te(N,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Ae=ne.get(N);Ae===void 0&&(Ae=i.getUniformBlockIndex(re,N.name),i.uniformBlockBinding(re,Ae,Ae),ne.set(N,Ae))}function ie(N,re,ne){let xe=c.get(re).get(N);l[xe]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,xe,ne),l[xe]=ne)}function _e(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},K=null,ee={},f={},l={},d=new WeakMap,m=[],_=null,g=!1,p=null,b=null,T=null,x=null,R=null,w=null,y=null,E=new at(0,0,0),O=0,L=!1,I=null,k=null,V=null,D=null,H=null,j.set(0,0,i.canvas.width,i.canvas.height),ye.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:pe,disable:Oe,bindFramebuffer:Xe,drawBuffers:Ge,useProgram:ft,setBlending:$t,setMaterial:zt,setFlipSided:on,setCullFace:It,setLineWidth:Sn,setPolygonOffset:xt,setScissorTest:mn,activeTexture:Jt,bindTexture:an,unbindTexture:U,compressedTexImage2D:Ce,compressedTexImage3D:Ye,texImage2D:S,texImage3D:X,pixelStorei:oe,getParameter:fe,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:qe,texStorage3D:C,texSubImage2D:rt,texSubImage3D:we,compressedTexSubImage2D:Dt,compressedTexSubImage3D:Ve,scissor:ve,viewport:be,reset:_e}}function oT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ze,u=new WeakMap,h=new Set,f,d=new WeakMap,m=new Set,_=new FinalizationRegistry(C=>m.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,S){return g?new OffscreenCanvas(C,S):Ra("canvas")}function b(C,S,X){let fe=1,oe=qe(C);if((oe.width>X||oe.height>X)&&(fe=X/Math.max(oe.width,oe.height)),fe<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ve=Math.floor(fe*oe.width),be=Math.floor(fe*oe.height);f===void 0&&(f=p(ve,be));let te=S?p(ve,be):f;return te.width=ve,te.height=be,te.getContext("2d").drawImage(C,0,0,ve,be),$e("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ve+"x"+be+")."),te}else return"data"in C&&$e("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),C;return C}function T(C){return C.generateMipmaps}function x(C){i.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(C,S,X,fe,oe,ve=!1){if(C!==null){if(i[C]!==void 0)return i[C];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let be;fe&&(be=e.get("EXT_texture_norm16"),be||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===i.RED&&(X===i.FLOAT&&(te=i.R32F),X===i.HALF_FLOAT&&(te=i.R16F),X===i.UNSIGNED_BYTE&&(te=i.R8),X===i.UNSIGNED_SHORT&&be&&(te=be.R16_EXT),X===i.SHORT&&be&&(te=be.R16_SNORM_EXT)),S===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.R8UI),X===i.UNSIGNED_SHORT&&(te=i.R16UI),X===i.UNSIGNED_INT&&(te=i.R32UI),X===i.BYTE&&(te=i.R8I),X===i.SHORT&&(te=i.R16I),X===i.INT&&(te=i.R32I)),S===i.RG&&(X===i.FLOAT&&(te=i.RG32F),X===i.HALF_FLOAT&&(te=i.RG16F),X===i.UNSIGNED_BYTE&&(te=i.RG8),X===i.UNSIGNED_SHORT&&be&&(te=be.RG16_EXT),X===i.SHORT&&be&&(te=be.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RG8UI),X===i.UNSIGNED_SHORT&&(te=i.RG16UI),X===i.UNSIGNED_INT&&(te=i.RG32UI),X===i.BYTE&&(te=i.RG8I),X===i.SHORT&&(te=i.RG16I),X===i.INT&&(te=i.RG32I)),S===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGB8UI),X===i.UNSIGNED_SHORT&&(te=i.RGB16UI),X===i.UNSIGNED_INT&&(te=i.RGB32UI),X===i.BYTE&&(te=i.RGB8I),X===i.SHORT&&(te=i.RGB16I),X===i.INT&&(te=i.RGB32I)),S===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),X===i.UNSIGNED_INT&&(te=i.RGBA32UI),X===i.BYTE&&(te=i.RGBA8I),X===i.SHORT&&(te=i.RGBA16I),X===i.INT&&(te=i.RGBA32I)),S===i.RGB&&(X===i.UNSIGNED_SHORT&&be&&(te=be.RGB16_EXT),X===i.SHORT&&be&&(te=be.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),S===i.RGBA){let ie=ve?Ta:yt.getTransfer(oe);X===i.FLOAT&&(te=i.RGBA32F),X===i.HALF_FLOAT&&(te=i.RGBA16F),X===i.UNSIGNED_BYTE&&(te=ie===Et?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&be&&(te=be.RGBA16_EXT),X===i.SHORT&&be&&(te=be.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function y(C,S){let X;return C?S===null||S===$i||S===Or?X=i.DEPTH24_STENCIL8:S===Yi?X=i.DEPTH32F_STENCIL8:S===Ho&&(X=i.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===$i||S===Or?X=i.DEPTH_COMPONENT24:S===Yi?X=i.DEPTH_COMPONENT32F:S===Ho&&(X=i.DEPTH_COMPONENT16),X}function E(C,S){return T(C)===!0||C.isFramebufferTexture&&C.minFilter!==In&&C.minFilter!==ti?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function O(C){let S=new WeakRef(C);n.get(C).__ref=S,m.add(S),_.register(C,S,S)}function L(C){let S=n.get(C).__ref;S!==void 0&&(m.delete(S),_.unregister(S))}function I(C){V(C.target)}function k(C){D(C.target)}function V(C){C.removeEventListener("dispose",I),L(C),q(C),C.isVideoTexture&&u.delete(C),C.isHTMLTexture&&h.delete(C)}function D(C){C.removeEventListener("dispose",k),L(C),ae(C)}function H(){for(let C of m){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?D(S):V(S))}m.clear(),h.clear()}function q(C){let S=n.get(C);if(S.__webglInit===void 0)return;let X=C.source,fe=d.get(X);if(fe){let oe=fe[S.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&G(C),Object.keys(fe).length===0&&d.delete(X)}n.remove(C)}function G(C){let S=n.get(C);i.deleteTexture(S.__webglTexture);let X=C.source,fe=d.get(X);delete fe[S.__cacheKey],o.memory.textures--}function ae(C){let S=n.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let X=C.depthTexture;if(X&&X.renderTarget===C&&V(X),C.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(S.__webglFramebuffer[oe]))for(let ve=0;ve<S.__webglFramebuffer[oe].length;ve++)i.deleteFramebuffer(S.__webglFramebuffer[oe][ve]);else i.deleteFramebuffer(S.__webglFramebuffer[oe]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[oe])}else{if(Array.isArray(S.__webglFramebuffer))for(let oe=0;oe<S.__webglFramebuffer.length;oe++)i.deleteFramebuffer(S.__webglFramebuffer[oe]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let oe=0;oe<S.__webglColorRenderbuffer.length;oe++)S.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[oe]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let fe=C.textures;for(let oe=0,ve=fe.length;oe<ve;oe++){let be=n.get(fe[oe]);be.__webglTexture&&(i.deleteTexture(be.__webglTexture),o.memory.textures--),n.remove(fe[oe])}n.remove(C)}let $=0;function K(){$=0}function ee(){return $}function de(C){$=C}function ue(){let C=$;return C>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,C}function j(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function ye(C,S){let X=n.get(C);if(C.isVideoTexture&&Dt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&X.__version!==C.version){let fe=C.image;if(fe===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(fe.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{zt(X,C,S);return}}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+S)}function se(C,S){let X=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){zt(X,C,S);return}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+S)}function me(C,S){let X=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){zt(X,C,S);return}t.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+S)}function pe(C,S){let X=n.get(C);if(C.version>0&&X.__version!==C.version){on(X,C,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+S)}let Oe={[Pc]:i.REPEAT,[cs]:i.CLAMP_TO_EDGE,[Ic]:i.MIRRORED_REPEAT},Xe={[In]:i.NEAREST,[t_]:i.NEAREST_MIPMAP_NEAREST,[el]:i.NEAREST_MIPMAP_LINEAR,[ti]:i.LINEAR,[ru]:i.LINEAR_MIPMAP_NEAREST,[Fs]:i.LINEAR_MIPMAP_LINEAR},Ge={[r_]:i.NEVER,[yd]:i.ALWAYS,[o_]:i.LESS,[gd]:i.LEQUAL,[a_]:i.EQUAL,[_d]:i.GEQUAL,[l_]:i.GREATER,[c_]:i.NOTEQUAL};function ft(C,S){if(S.type===Yi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===ti||S.magFilter===ru||S.magFilter===el||S.magFilter===Fs||S.minFilter===ti||S.minFilter===ru||S.minFilter===el||S.minFilter===Fs)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,Oe[S.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Oe[S.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Oe[S.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,Xe[S.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,Xe[S.minFilter]),S.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Ge[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===In||S.minFilter!==el&&S.minFilter!==Fs||S.type===Yi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ct(C,S){let X=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",I),O(S));let fe=S.source,oe=d.get(fe);oe===void 0&&(oe={},d.set(fe,oe));let ve=j(S);if(ve!==C.__cacheKey){oe[ve]===void 0&&(oe[ve]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[ve].usedTimes++;let be=oe[C.__cacheKey];be!==void 0&&(oe[C.__cacheKey].usedTimes--,be.usedTimes===0&&G(S)),C.__cacheKey=ve,C.__webglTexture=oe[ve].texture}return X}function it(C,S,X){return Math.floor(Math.floor(C/X)/S)}function $t(C,S,X,fe){let ve=C.updateRanges;if(ve.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,X,fe,S.data);else{ve.sort((N,re)=>N.start-re.start);let be=0;for(let N=1;N<ve.length;N++){let re=ve[be],ne=ve[N],Ae=re.start+re.count,xe=it(ne.start,S.width,4),Me=it(re.start,S.width,4);ne.start<=Ae+1&&xe===Me&&it(ne.start+ne.count-1,S.width,4)===xe?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++be,ve[be]=ne)}ve.length=be+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),ie=t.getParameter(i.UNPACK_SKIP_PIXELS),_e=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let N=0,re=ve.length;N<re;N++){let ne=ve[N],Ae=Math.floor(ne.start/4),xe=Math.ceil(ne.count/4),Me=Ae%S.width,He=Math.floor(Ae/S.width),je=xe,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(i.UNPACK_SKIP_ROWS,He),t.texSubImage2D(i.TEXTURE_2D,0,Me,He,je,he,X,fe,S.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(i.UNPACK_SKIP_ROWS,_e)}}function zt(C,S,X){let fe=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(fe=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(fe=i.TEXTURE_3D);let oe=ct(C,S),ve=S.source;t.bindTexture(fe,C.__webglTexture,i.TEXTURE0+X);let be=n.get(ve);if(ve.version!==be.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let he=yt.getPrimaries(yt.workingColorSpace),Be=S.colorSpace===Us?null:yt.getPrimaries(S.colorSpace),Qe=S.colorSpace===Us||he===Be?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let ie=b(S.image,!1,s.maxTextureSize);ie=Ve(S,ie);let _e=r.convert(S.format,S.colorSpace),N=r.convert(S.type),re=w(S.internalFormat,_e,N,S.normalized,S.colorSpace,S.isVideoTexture);ft(fe,S);let ne,Ae=S.mipmaps,xe=S.isVideoTexture!==!0,Me=be.__version===void 0||oe===!0,He=ve.dataReady,je=E(S,ie);if(S.isDepthTexture)re=y(S.format===Ns,S.type),Me&&(xe?t.texStorage2D(i.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(i.TEXTURE_2D,0,re,ie.width,ie.height,0,_e,N,null));else if(S.isDataTexture)if(Ae.length>0){xe&&Me&&t.texStorage2D(i.TEXTURE_2D,je,re,Ae[0].width,Ae[0].height);for(let he=0,Be=Ae.length;he<Be;he++)ne=Ae[he],xe?He&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,_e,N,ne.data):t.texImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,_e,N,ne.data);S.generateMipmaps=!1}else xe?(Me&&t.texStorage2D(i.TEXTURE_2D,je,re,ie.width,ie.height),He&&$t(S,ie,_e,N)):t.texImage2D(i.TEXTURE_2D,0,re,ie.width,ie.height,0,_e,N,ie.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){xe&&Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,re,Ae[0].width,Ae[0].height,ie.depth);for(let he=0,Be=Ae.length;he<Be;he++)if(ne=Ae[he],S.format!==Ji)if(_e!==null)if(xe){if(He)if(S.layerUpdates.size>0){let Qe=Cd(ne.width,ne.height,S.format,S.type);for(let Re of S.layerUpdates){let lt=ne.data.subarray(Re*Qe/ne.data.BYTES_PER_ELEMENT,(Re+1)*Qe/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Re,ne.width,ne.height,1,_e,lt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,ie.depth,_e,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?He&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,ie.depth,_e,N,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,re,ne.width,ne.height,ie.depth,0,_e,N,ne.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{xe&&Me&&t.texStorage2D(i.TEXTURE_2D,je,re,Ae[0].width,Ae[0].height);for(let he=0,Be=Ae.length;he<Be;he++)ne=Ae[he],S.format!==Ji?_e!==null?xe?He&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,_e,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,ne.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?He&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,_e,N,ne.data):t.texImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,_e,N,ne.data)}else if(S.isDataArrayTexture)if(xe){if(Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,re,ie.width,ie.height,ie.depth),He)if(S.layerUpdates.size>0){let he=Cd(ie.width,ie.height,S.format,S.type);for(let Be of S.layerUpdates){let Qe=ie.data.subarray(Be*he/ie.data.BYTES_PER_ELEMENT,(Be+1)*he/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Be,ie.width,ie.height,1,_e,N,Qe)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,_e,N,ie.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,_e,N,ie.data);else if(S.isData3DTexture)xe?(Me&&t.texStorage3D(i.TEXTURE_3D,je,re,ie.width,ie.height,ie.depth),He&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,_e,N,ie.data)):t.texImage3D(i.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,_e,N,ie.data);else if(S.isFramebufferTexture){if(Me)if(xe)t.texStorage2D(i.TEXTURE_2D,je,re,ie.width,ie.height);else{let he=ie.width,Be=ie.height;for(let Qe=0;Qe<je;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,re,he,Be,0,_e,N,null),he>>=1,Be>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),ie.parentNode!==he){he.appendChild(ie),h.add(S),he.onpaint=Be=>{let Qe=Be.changedElements;for(let Re of h)Qe.includes(Re.image)&&(Re.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ie);else{let Qe=i.RGBA,Re=i.RGBA,lt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,Re,lt,ie)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(xe&&Me){let he=qe(Ae[0]);t.texStorage2D(i.TEXTURE_2D,je,re,he.width,he.height)}for(let he=0,Be=Ae.length;he<Be;he++)ne=Ae[he],xe?He&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,_e,N,ne):t.texImage2D(i.TEXTURE_2D,he,re,_e,N,ne);S.generateMipmaps=!1}else if(xe){if(Me){let he=qe(ie);t.texStorage2D(i.TEXTURE_2D,je,re,he.width,he.height)}He&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,_e,N,ie)}else t.texImage2D(i.TEXTURE_2D,0,re,_e,N,ie);T(S)&&S.mipmapsAutoUpdate===!0&&x(fe),be.__version=ve.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function on(C,S,X){if(S.image.length!==6)return;let fe=ct(C,S),oe=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+X);let ve=n.get(oe);if(oe.version!==ve.__version||fe===!0){t.activeTexture(i.TEXTURE0+X);let be=yt.getPrimaries(yt.workingColorSpace),te=S.colorSpace===Us?null:yt.getPrimaries(S.colorSpace),ie=S.colorSpace===Us||be===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let _e=S.isCompressedTexture||S.image[0].isCompressedTexture,N=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Re=0;Re<6;Re++)!_e&&!N?re[Re]=b(S.image[Re],!0,s.maxCubemapSize):re[Re]=N?S.image[Re].image:S.image[Re],re[Re]=Ve(S,re[Re]);let ne=re[0],Ae=r.convert(S.format,S.colorSpace),xe=r.convert(S.type),Me=w(S.internalFormat,Ae,xe,S.normalized,S.colorSpace),He=S.isVideoTexture!==!0,je=ve.__version===void 0||fe===!0,he=oe.dataReady,Be=E(S,ne);ft(i.TEXTURE_CUBE_MAP,S);let Qe;if(S.isDepthTexture){if(Me=y(S.format===Ns,S.type),je)if(He)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Me,ne.width,ne.height);else for(let Re=0;Re<6;Re++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,ne.width,ne.height,0,Ae,xe,null)}else if(_e){He&&je&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Me,ne.width,ne.height);for(let Re=0;Re<6;Re++){Qe=re[Re].mipmaps;for(let lt=0;lt<Qe.length;lt++){let Vt=Qe[lt];S.format!==Ji?Ae!==null?He?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Vt.width,Vt.height,Ae,Vt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Me,Vt.width,Vt.height,0,Vt.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Vt.width,Vt.height,Ae,xe,Vt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Me,Vt.width,Vt.height,0,Ae,xe,Vt.data)}}}else{if(Qe=S.mipmaps,He&&je){Qe.length>0&&Be++;let Re=qe(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Me,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(N){He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,re[Re].width,re[Re].height,Ae,xe,re[Re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,re[Re].width,re[Re].height,0,Ae,xe,re[Re].data);for(let lt=0;lt<Qe.length;lt++){let qn=Qe[lt].image[Re].image;He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,qn.width,qn.height,Ae,xe,qn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Me,qn.width,qn.height,0,Ae,xe,qn.data)}}else{He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ae,xe,re[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,Ae,xe,re[Re]);for(let lt=0;lt<Qe.length;lt++){let Vt=Qe[lt];He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Ae,xe,Vt.image[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Me,Ae,xe,Vt.image[Re])}}}T(S)&&S.mipmapsAutoUpdate===!0&&x(i.TEXTURE_CUBE_MAP),ve.__version=oe.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function It(C,S,X,fe,oe,ve){let be=r.convert(X.format,X.colorSpace),te=r.convert(X.type),ie=w(X.internalFormat,be,te,X.normalized,X.colorSpace),_e=n.get(S),N=n.get(X);if(N.__renderTarget=S,!_e.__hasExternalTextures){let re=Math.max(1,S.width>>ve),ne=Math.max(1,S.height>>ve);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,ve,ie,re,ne,S.depth,0,be,te,null):t.texImage2D(oe,ve,ie,re,ne,0,be,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,fe,oe,N.__webglTexture,0,rt(S)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,fe,oe,N.__webglTexture,ve),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Sn(C,S,X){if(i.bindRenderbuffer(i.RENDERBUFFER,C),S.depthBuffer){let fe=S.depthTexture,oe=fe&&fe.isDepthTexture?fe.type:null,ve=y(S.stencilBuffer,oe),be=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,rt(S),ve,S.width,S.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,rt(S),ve,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ve,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,be,i.RENDERBUFFER,C)}else{let fe=S.textures;for(let oe=0;oe<fe.length;oe++){let ve=fe[oe],be=r.convert(ve.format,ve.colorSpace),te=r.convert(ve.type),ie=w(ve.internalFormat,be,te,ve.normalized,ve.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,rt(S),ie,S.width,S.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,rt(S),ie,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ie,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xt(C,S,X){let fe=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(S.depthTexture);oe.__renderTarget=S;let ve=fe?S.depthTexture.image[0]:S.depthTexture.image;(!oe.__webglTexture||ve.width!==S.width||ve.height!==S.height)&&(ve.width=S.width,ve.height=S.height,S.depthTexture.needsUpdate=!0),fe?pe(S.depthTexture,0):ye(S.depthTexture,0);let be=oe.__webglTexture,te=rt(S),ie=fe?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,_e=S.depthTexture.format===Ns?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Ls)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,ie,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,_e,ie,be,0);else if(S.depthTexture.format===Ns)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,ie,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,_e,ie,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function mn(C){let S=n.get(C),X=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let fe=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),fe){let oe=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,fe.removeEventListener("dispose",oe)};fe.addEventListener("dispose",oe),S.__depthDisposeCallback=oe}S.__boundDepthTexture=fe}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(X)for(let fe=0;fe<6;fe++)xt(S.__webglFramebuffer[fe],C,fe);else C.texture.mipmaps.length>0?xt(S.__webglFramebuffer[0],C,0):xt(S.__webglFramebuffer,C,0);else if(X){S.__webglDepthbuffer=[];for(let fe=0;fe<6;fe++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[fe]),S.__webglDepthbuffer[fe]===void 0)S.__webglDepthbuffer[fe]=i.createRenderbuffer(),Sn(S.__webglDepthbuffer[fe],C,!1);else{let oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer[fe];i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),Sn(S.__webglDepthbuffer,C,!1);else{let oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Jt(C,S,X){let fe=n.get(C);S!==void 0&&It(fe.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&mn(C)}function an(C){let S=C.texture,X=n.get(C),fe=n.get(S);C.addEventListener("dispose",k),O(C);let oe=C.textures,ve=C.isWebGLCubeRenderTarget===!0,be=oe.length>1;if(be||(fe.__webglTexture===void 0&&(fe.__webglTexture=i.createTexture()),fe.__version=S.version,o.memory.textures++),ve){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ie=0;ie<S.mipmaps.length;ie++)X.__webglFramebuffer[te][ie]=i.createFramebuffer()}else X.__webglFramebuffer[te]=i.createFramebuffer()}else{if(S.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)X.__webglFramebuffer[te]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(be)for(let te=0,ie=oe.length;te<ie;te++){let _e=n.get(oe[te]);_e.__webglTexture===void 0&&(_e.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&we(C)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];X.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let _e=r.convert(ie.format,ie.colorSpace),N=r.convert(ie.type),re=w(ie.internalFormat,_e,N,ie.normalized,ie.colorSpace,C.isXRRenderTarget===!0),ne=rt(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,X.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),Sn(X.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ve){t.bindTexture(i.TEXTURE_CUBE_MAP,fe.__webglTexture),ft(i.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let ie=0;ie<S.mipmaps.length;ie++)It(X.__webglFramebuffer[te][ie],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else It(X.__webglFramebuffer[te],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);T(S)?x(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(be){for(let te=0,ie=oe.length;te<ie;te++){let _e=oe[te],N=n.get(_e),re=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(re=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,N.__webglTexture),ft(re,_e),It(X.__webglFramebuffer,C,_e,i.COLOR_ATTACHMENT0+te,re,0),T(_e)&&x(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(te=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,fe.__webglTexture),ft(te,S),S.mipmaps.length>0)for(let ie=0;ie<S.mipmaps.length;ie++)It(X.__webglFramebuffer[ie],C,S,i.COLOR_ATTACHMENT0,te,ie);else It(X.__webglFramebuffer,C,S,i.COLOR_ATTACHMENT0,te,0);T(S)?x(te):S.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&mn(C)}function U(C){let S=C.textures;for(let X=0,fe=S.length;X<fe;X++){let oe=S[X];if(T(oe)&&oe.mipmapsAutoUpdate===!0){let ve=R(C),be=n.get(oe).__webglTexture;t.bindTexture(ve,be),x(ve),t.unbindTexture()}}}let Ce=[];function Ye(C){if(C.samples>0){if(we(C)===!1){let S=C.textures,X=C.width,fe=C.height,oe=i.COLOR_BUFFER_BIT,ve=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=n.get(C),te=S.length>1;if(te)for(let _e=0;_e<S.length;_e++)t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let _e=0;_e<S.length;_e++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,be.__webglColorRenderbuffer[_e]);let N=n.get(S[_e]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,N,0)}i.blitFramebuffer(0,0,X,fe,0,0,X,fe,oe,i.NEAREST),l===!0&&(Ce.length=0,Ce.push(i.COLOR_ATTACHMENT0+_e),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(ve),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let _e=0;_e<S.length;_e++){t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,be.__webglColorRenderbuffer[_e]);let N=n.get(S[_e]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.TEXTURE_2D,N,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let S=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function rt(C){return Math.min(s.maxSamples,C.samples)}function we(C){let S=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Dt(C){let S=o.render.frame;u.get(C)!==S&&(u.set(C,S),C.update())}function Ve(C,S){let X=C.colorSpace,fe=C.format,oe=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||X!==Ea&&X!==Us&&(yt.getTransfer(X)===Et?(fe!==Ji||oe!==oi)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",X)),S}function qe(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=K,this.getTextureUnits=ee,this.setTextureUnits=de,this.setTexture2D=ye,this.setTexture2DArray=se,this.setTexture3D=me,this.setTextureCube=pe,this.rebindTextures=Jt,this.setupRenderTarget=an,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=mn,this.setupFrameBufferTexture=It,this.useMultisampledRTT=we,this.dispose=H}function aT(i,e){function t(n,s=Us){let r,o=yt.getTransfer(s);if(n===oi)return i.UNSIGNED_BYTE;if(n===au)return i.UNSIGNED_SHORT_4_4_4_4;if(n===lu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===hd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===fd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===cd)return i.BYTE;if(n===ud)return i.SHORT;if(n===Ho)return i.UNSIGNED_SHORT;if(n===ou)return i.INT;if(n===$i)return i.UNSIGNED_INT;if(n===Yi)return i.FLOAT;if(n===Zi)return i.HALF_FLOAT;if(n===dd)return i.ALPHA;if(n===pd)return i.RGB;if(n===Ji)return i.RGBA;if(n===Ls)return i.DEPTH_COMPONENT;if(n===Ns)return i.DEPTH_STENCIL;if(n===md)return i.RED;if(n===cu)return i.RED_INTEGER;if(n===ur)return i.RG;if(n===uu)return i.RG_INTEGER;if(n===hu)return i.RGBA_INTEGER;if(n===tl||n===nl||n===il||n===sl)if(o===Et)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===tl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===nl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===il)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===sl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===tl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===nl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===il)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===sl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===fu||n===du||n===pu||n===mu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===fu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===du)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===pu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===mu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===gu||n===_u||n===yu||n===xu||n===vu||n===rl||n===bu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===gu||n===_u)return o===Et?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===yu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===xu)return r.COMPRESSED_R11_EAC;if(n===vu)return r.COMPRESSED_SIGNED_R11_EAC;if(n===rl)return r.COMPRESSED_RG11_EAC;if(n===bu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Su||n===Mu||n===wu||n===Au||n===Eu||n===Tu||n===Ru||n===Cu||n===Pu||n===Iu||n===Lu||n===Du||n===Fu||n===Nu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Su)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Mu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===wu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Au)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Eu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Tu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ru)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Cu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Pu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Iu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Lu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Du)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Fu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Nu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Uu||n===Ou||n===Bu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Uu)return o===Et?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ou)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Bu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===ku||n===zu||n===ol||n===Vu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===ku)return r.COMPRESSED_RED_RGTC1_EXT;if(n===zu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ol)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Vu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Or?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var lT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cT=`
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

}`,Bd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ba(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Pi({vertexShader:lT,fragmentShader:cT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Bt(new Pr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},kd=class extends Wi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,m=null,_=typeof XRWebGLBinding<"u",g=new Bd,p={},b=t.getContextAttributes(),T=null,x=null,R=[],w=[],y=new Ze,E=null,O=null,L=new ei;L.viewport=new Tt;let I=new ei;I.viewport=new Tt;let k=[L,I],V=new tu,D=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let ye=R[j];return ye===void 0&&(ye=new No,R[j]=ye),ye.getTargetRaySpace()},this.getControllerGrip=function(j){let ye=R[j];return ye===void 0&&(ye=new No,R[j]=ye),ye.getGripSpace()},this.getHand=function(j){let ye=R[j];return ye===void 0&&(ye=new No,R[j]=ye),ye.getHandSpace()};function q(j){let ye=w.indexOf(j.inputSource);if(ye===-1)return;let se=R[ye];se!==void 0&&(se.update(j.inputSource,j.frame,c||o),se.dispatchEvent({type:j.type,data:j.inputSource}))}function G(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ae);for(let j=0;j<R.length;j++){let ye=w[j];ye!==null&&(w[j]=null,R[j].disconnect(ye))}D=null,H=null,g.reset();for(let j in p)delete p[j];if(e.setRenderTarget(T),d=null,f=null,h=null,s=null,x=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(E),e.setSize(y.width,y.height,!1),O!==null){let j=O.camera;j.fov=O.fov,j.zoom=O.zoom,j.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,n.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,n.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ae),b.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let se=null,me=null,pe=null;b.depth&&(pe=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,se=b.stencil?Ns:Ls,me=b.stencil?Or:$i);let Oe={colorFormat:t.RGBA8,depthFormat:pe,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Oe),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),x=new vi(f.textureWidth,f.textureHeight,{format:Ji,type:oi,depthTexture:new Ds(f.textureWidth,f.textureHeight,me,void 0,void 0,void 0,void 0,void 0,void 0,se),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let se={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,se),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),x=new vi(d.framebufferWidth,d.framebufferHeight,{format:Ji,type:oi,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ae(j){for(let ye=0;ye<j.removed.length;ye++){let se=j.removed[ye],me=w.indexOf(se);me>=0&&(w[me]=null,R[me].disconnect(se))}for(let ye=0;ye<j.added.length;ye++){let se=j.added[ye],me=w.indexOf(se);if(me===-1){for(let Oe=0;Oe<R.length;Oe++)if(Oe>=w.length){w.push(se),me=Oe;break}else if(w[Oe]===null){w[Oe]=se,me=Oe;break}if(me===-1)break}let pe=R[me];pe&&pe.connect(se)}}function $(j,ye){ye===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(ye.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let ye=j.near,se=j.far;g.texture!==null&&(g.depthNear>0&&(ye=g.depthNear),g.depthFar>0&&(se=g.depthFar)),V.near=I.near=L.near=ye,V.far=I.far=L.far=se,(D!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),D=V.near,H=V.far),V.layers.mask=j.layers.mask|6,L.layers.mask=V.layers.mask&-5,I.layers.mask=V.layers.mask&-3;let me=j.parent,pe=V.cameras;$(V,me);for(let Oe=0;Oe<pe.length;Oe++)$(pe[Oe],me);V.projectionMatrix.copy(L.projectionMatrix),V.projectionMatrixInverse.copy(L.projectionMatrixInverse),O===null&&j.isPerspectiveCamera&&(O={camera:j,fov:j.fov,zoom:j.zoom}),K(j,V,me)};function K(j,ye,se){se===null?j.matrix.copy(ye.matrixWorld):(j.matrix.copy(se.matrixWorld),j.matrix.invert(),j.matrix.multiply(ye.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(ye.projectionMatrix),j.projectionMatrixInverse.copy(ye.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=Do*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(j){l=j,f!==null&&(f.fixedFoveation=j),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=j)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(j){return p[j]};let ee=null;function de(j,ye){if(u=ye.getViewerPose(c||o),m=ye,u!==null){let se=u.views;d!==null&&(e.setRenderTargetFramebuffer(x,d.framebuffer),e.setRenderTarget(x));let me=!1;se.length!==V.cameras.length&&(V.cameras.length=0,me=!0);for(let Ge=0;Ge<se.length;Ge++){let ft=se[Ge],ct=null;if(d!==null)ct=d.getViewport(ft);else{let $t=h.getViewSubImage(f,ft);ct=$t.viewport,Ge===0&&(e.setRenderTargetTextures(x,$t.colorTexture,$t.depthStencilTexture),e.setRenderTarget(x))}let it=k[Ge];it===void 0&&(it=new ei,it.layers.enable(Ge),it.viewport=new Tt,k[Ge]=it),it.matrix.fromArray(ft.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ft.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ct.x,ct.y,ct.width,ct.height),Ge===0&&(V.matrix.copy(it.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),me===!0&&V.cameras.push(it)}let pe=s.enabledFeatures;if(pe&&pe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=n.getBinding();let Ge=h.getDepthInformation(se[0]);Ge&&Ge.isValid&&Ge.texture&&g.init(Ge,s.renderState)}if(pe&&pe.includes("camera-access")&&_){e.state.unbindTexture(),h=n.getBinding();for(let Ge=0;Ge<se.length;Ge++){let ft=se[Ge].camera;if(ft){let ct=p[ft];ct||(ct=new Ba,p[ft]=ct);let it=h.getCameraImage(ft);ct.sourceTexture=it}}}}for(let se=0;se<R.length;se++){let me=w[se],pe=R[se];me!==null&&pe!==void 0&&pe.update(me,ye,c||o)}ee&&ee(j,ye),ye.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ye}),m=null}let ue=new B_;ue.setAnimationLoop(de),this.setAnimationLoop=function(j){ee=j},this.dispose=function(){}}},uT=new Ut,Y_=new nt;Y_.set(-1,0,0,0,1,0,0,0,1);function hT(i,e){function t(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,Ed(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,b,T,x){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),h(g,p)):p.isMeshPhongMaterial?(r(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),f(g,p),p.isMeshPhysicalMaterial&&d(g,p,x)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),_(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,b,T):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,t(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===ni&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,t(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===ni&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,t(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,t(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let b=e.get(p),T=b.envMap,x=b.envMapRotation;T&&(g.envMap.value=T,g.envMapRotation.value.setFromMatrix4(uT.makeRotationFromEuler(x)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Y_),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,b,T){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*b,g.scale.value=T*.5,p.map&&(g.map.value=p.map,t(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function f(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function d(g,p,b){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ni&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=b.texture,g.transmissionSamplerSize.value.set(b.width,b.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function _(g,p){let b=e.get(p).light;g.referencePosition.value.setFromMatrixPosition(b.matrixWorld),g.nearDistance.value=b.shadow.camera.near,g.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function fT(i,e,t,n){let s={},r={};function o(b,T){let x=T.program;n.uniformBlockBinding(b,x,s[b.id])}function a(b,T){let x=s[b.id];x===void 0&&(m(b),x=l(b),s[b.id]=x,b.addEventListener("dispose",g));let R=T.program;n.updateUBOMapping(b,R);let w=e.render.frame;r[b.id]!==w&&(c(b),r[b.id]=w)}function l(b){let T=i.createBuffer(),x=b.__size,R=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,x,R),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(b){let T=s[b.id],x=b.uniforms,R=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let w=0,y=x.length;w<y;w++){let E=x[w];if(Array.isArray(E))for(let O=0,L=E.length;O<L;O++)u(E[O],w,O,R);else u(E,w,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(b,T,x,R){if(f(b,T,x,R)===!0){let w=b.__offset,y=b.value;if(Array.isArray(y)){let E=0;for(let O=0;O<y.length;O++){let L=y[O],I=_(L,!0);h(L,b.__data,E),E+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,b.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,b.__data)}}function h(b,T,x){typeof b=="number"||typeof b=="boolean"?T[x]=b:b.isMatrix3?(T[x]=b.elements[0],T[x+1]=b.elements[1],T[x+2]=b.elements[2],T[x+3]=0,T[x+4]=b.elements[3],T[x+5]=b.elements[4],T[x+6]=b.elements[5],T[x+7]=0,T[x+8]=b.elements[6],T[x+9]=b.elements[7],T[x+10]=b.elements[8],T[x+11]=0):ArrayBuffer.isView(b)?T.set(b.subarray(0,T.length-x),x):b.toArray(T,x)}function f(b,T,x,R){let w=b.value,y=T+"_"+x;if(Array.isArray(w)){R[y]===void 0&&(R[y]=[]);let E=R[y],O=!1;for(let L=0;L<w.length;L++)d(w[L],E,L)===!0&&(O=!0);return O}return d(w,R,y)}function d(b,T,x){if(T[x]===void 0)return typeof b=="number"||typeof b=="boolean"?T[x]=b:ArrayBuffer.isView(b)?T[x]=b.slice():T[x]=b.clone(),!0;{let R=T[x];if(typeof b=="number"||typeof b=="boolean"){if(R!==b)return T[x]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(R.equals(b)===!1)return R.copy(b),!0}}return!1}function m(b){let T=b.uniforms,x=0,R=16;for(let y=0,E=T.length;y<E;y++){let O=Array.isArray(T[y])?T[y]:[T[y]];for(let L=0,I=O.length;L<I;L++){let k=O[L],V=Array.isArray(k.value)?k.value:[k.value],D=Array.isArray(T[y])||Array.isArray(k.value),H=x;for(let G=0,ae=V.length;G<ae;G++){let $=V[G],K=_($,D),ee=x%R,de=ee%K.boundary,ue=ee+de;x+=de,ue!==0&&R-ue<K.storage&&(x+=R-ue),G===0&&(H=x),x+=K.storage}let q=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new q((x-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let w=x%R;return w>0&&(x+=R-w),b.__size=x,b.__cache={},this}function _(b,T){let x={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(x.boundary=4,x.storage=4):b.isVector2?(x.boundary=8,x.storage=8):b.isVector3||b.isColor?(x.boundary=16,x.storage=12):b.isVector4?(x.boundary=16,x.storage=16):b.isMatrix3?(x.boundary=16,x.storage=48):b.isMatrix4?(x.boundary=16,x.storage=64):b.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(x.boundary=16,x.storage=b.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",b),T===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}function g(b){let T=b.target;T.removeEventListener("dispose",g),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(let b in s)i.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:p}}var dT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ds=null;function pT(){return ds===null&&(ds=new Uc(dT,16,16,ur,Zi),ds.name="DFG_LUT",ds.minFilter=ti,ds.magFilter=ti,ds.wrapS=cs,ds.wrapT=cs,ds.generateMipmaps=!1,ds.needsUpdate=!0),ds}var qu=class{constructor(e={}){let{canvas:t=u_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=oi}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let _=d,g=new Set([hu,uu,cu]),p=new Set([oi,$i,Ho,Or,au,lu]),b=new Uint32Array(4),T=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},R=null,w=null,y=[],E=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,k=null,V=null,D=null,H=null;this._outputColorSpace=yi;let q=0,G=0,ae=null,$=-1,K=null,ee=new Tt,de=new Tt,ue=null,j=new at(0),ye=0,se=t.width,me=t.height,pe=1,Oe=null,Xe=null,Ge=new Tt(0,0,se,me),ft=new Tt(0,0,se,me),ct=!1,it=new er,$t=new Oc,zt=!1,on=!1,It=new Ut,Sn=new B,xt=new Tt,mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Jt=!1;function an(){return ae===null?pe:1}let U=n;function Ce(A,z){return t.getContext(A,z)}let Ye,rt,we,Dt,Ve,qe,C,S,X,fe,oe,ve,be,te,ie,_e,N,re,ne,Ae,xe,Me,He;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Re,!1),U===null){let z="webgl2";if(U=Ce(z,A),U===null)throw Ce(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(A){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),tt("WebGLRenderer: "+A.message),A}function je(){Ye=new AA(U),Ye.init(),xe=new aT(U,Ye),rt=new pA(U,Ye,e,xe),we=new rT(U,Ye),rt.reversedDepthBuffer&&f&&we.buffers.depth.setReversed(!0),V=U.createFramebuffer(),D=U.createFramebuffer(),H=U.createFramebuffer(),Dt=new RA(U),Ve=new XE,qe=new oT(U,Ye,we,Ve,rt,xe,Dt),C=new wA(L),S=new PM(U),Me=new fA(U,S),X=new EA(U,S,Dt,Me),fe=new PA(U,X,S,Me,Dt),re=new CA(U,rt,qe),ie=new mA(Ve),oe=new WE(L,C,Ye,rt,Me,ie),ve=new hT(L,Ve),be=new $E,te=new QE(Ye),N=new hA(L,C,we,fe,m,l),_e=new sT(L,fe,rt),He=new fT(U,Dt,rt,we),ne=new dA(U,Ye,Dt),Ae=new TA(U,Ye,Dt),Dt.programs=oe.programs,L.capabilities=rt,L.extensions=Ye,L.properties=Ve,L.renderLists=be,L.shadowMap=_e,L.state=we,L.info=Dt}_!==oi&&(O=new LA(_,t.width,t.height,a,s,r));let he=new kd(L,U);this.xr=he,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let A=Ye.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Ye.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return pe},this.setPixelRatio=function(A){A!==void 0&&(pe=A,this.setSize(se,me,!1))},this.getSize=function(A){return A.set(se,me)},this.setSize=function(A,z,Q=!0){if(he.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}se=A,me=z,t.width=Math.floor(A*pe),t.height=Math.floor(z*pe),Q===!0&&(t.style.width=A+"px",t.style.height=z+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,A,z)},this.getDrawingBufferSize=function(A){return A.set(se*pe,me*pe).floor()},this.setDrawingBufferSize=function(A,z,Q){se=A,me=z,pe=Q,t.width=Math.floor(A*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,A,z)},this.setEffects=function(A){if(_===oi){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let z=0;z<A.length;z++)if(A[z].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ee)},this.getViewport=function(A){return A.copy(Ge)},this.setViewport=function(A,z,Q,Y){A.isVector4?Ge.set(A.x,A.y,A.z,A.w):Ge.set(A,z,Q,Y),we.viewport(ee.copy(Ge).multiplyScalar(an()).round())},this.getScissor=function(A){return A.copy(ft)},this.setScissor=function(A,z,Q,Y){A.isVector4?ft.set(A.x,A.y,A.z,A.w):ft.set(A,z,Q,Y),we.scissor(de.copy(ft).multiplyScalar(an()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(A){we.setScissorTest(ct=A)},this.setOpaqueSort=function(A){Oe=A},this.setTransparentSort=function(A){Xe=A},this.getClearColor=function(A){return A.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(A=!0,z=!0,Q=!0){let Y=0;if(A){let Z=!1;if(ae!==null){let Ee=ae.texture.format;Z=g.has(Ee)}if(Z){let Ee=ae.texture.type,Ie=p.has(Ee),Te=N.getClearColor(),Le=N.getClearAlpha(),ze=Te.r,et=Te.g,dt=Te.b;Ie?(b[0]=ze,b[1]=et,b[2]=dt,b[3]=Le,U.clearBufferuiv(U.COLOR,0,b)):(T[0]=ze,T[1]=et,T[2]=dt,T[3]=Le,U.clearBufferiv(U.COLOR,0,T))}else Y|=U.COLOR_BUFFER_BIT}z&&(Y|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&U.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),k=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),N.dispose(),be.dispose(),te.dispose(),qe.dispose(),Ve.dispose(),C.dispose(),fe.dispose(),X.dispose(),Me.dispose(),He.dispose(),oe.dispose(),he.dispose(),he.removeEventListener("sessionstart",ml),he.removeEventListener("sessionend",ji),ys.stop()};function Be(A){A.preventDefault(),Ca("WebGLRenderer: Context Lost."),I=!0}function Qe(){Ca("WebGLRenderer: Context Restored."),I=!1;let A=Dt.autoReset,z=_e.enabled,Q=_e.autoUpdate,Y=_e.needsUpdate,Z=_e.type;je(),Dt.autoReset=A,_e.enabled=z,_e.autoUpdate=Q,_e.needsUpdate=Y,_e.type=Z}function Re(A){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function lt(A){let z=A.target;z.removeEventListener("dispose",lt),Vt(z)}function Vt(A){qn(A),Ve.remove(A)}function qn(A){let z=Ve.get(A).programs;z!==void 0&&(z.forEach(function(Q){oe.releaseProgram(Q)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,z,Q,Y,Z,Ee){z===null&&(z=mn);let Ie=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Te=Jo(A,z,Q,Y,Z);we.setMaterial(Y,Ie);let Le=Q.index,ze=1;if(Y.wireframe===!0){if(Le=X.getWireframeAttribute(Q),Le===void 0)return;ze=2}let et=Q.drawRange,dt=Q.attributes.position,ke=et.start*ze,pt=(et.start+et.count)*ze;Ee!==null&&(ke=Math.max(ke,Ee.start*ze),pt=Math.min(pt,(Ee.start+Ee.count)*ze)),Le!==null?(ke=Math.max(ke,0),pt=Math.min(pt,Le.count)):dt!=null&&(ke=Math.max(ke,0),pt=Math.min(pt,dt.count));let Zt=pt-ke;if(Zt<0||Zt===1/0)return;Me.setup(Z,Y,Te,Q,Le);let Rt,Ct=ne;if(Le!==null&&(Rt=S.get(Le),Ct=Ae,Ct.setIndex(Rt)),Z.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*an()),Ct.setMode(U.LINES)):Ct.setMode(U.TRIANGLES);else if(Z.isLine){let gn=Y.linewidth;gn===void 0&&(gn=1),we.setLineWidth(gn*an()),Z.isLineSegments?Ct.setMode(U.LINES):Z.isLineLoop?Ct.setMode(U.LINE_LOOP):Ct.setMode(U.LINE_STRIP)}else Z.isPoints?Ct.setMode(U.POINTS):Z.isSprite&&Ct.setMode(U.TRIANGLES);if(Z.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))Ct.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let gn=Z._multiDrawStarts,Ne=Z._multiDrawCounts,ln=Z._multiDrawCount,gt=Le?S.get(Le).bytesPerElement:1,vs=Ve.get(Y).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)vs.setValue(U,"_gl_DrawID",cn),Ct.render(gn[cn]/gt,Ne[cn])}else if(Z.isInstancedMesh)Ct.renderInstances(ke,Zt,Z.count);else if(Q.isInstancedBufferGeometry){let gn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ne=Math.min(Q.instanceCount,gn);Ct.renderInstances(ke,Zt,Ne)}else Ct.render(ke,Zt)};function $o(A,z,Q,Y){k!==null&&A.isNodeMaterial&&k.setObject(Y,A),zt===!0&&ie.setState(A,Q,!1),A.transparent===!0&&A.side===Ii&&A.forceSinglePass===!1?(A.side=ni,A.needsUpdate=!0,Qi(A,z,Y),A.side=cr,A.needsUpdate=!0,Qi(A,z,Y),A.side=Ii):Qi(A,z,Y)}this.compile=function(A,z,Q=null){Q===null&&(Q=A),k!==null&&k.renderStart(A,z,Q),w=te.get(Q),w.init(z),E.push(w),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(w.pushLight(Z),Z.castShadow&&w.pushShadow(Z))}),A!==Q&&A.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(w.pushLight(Z),Z.castShadow&&w.pushShadow(Z))}),w.setupLights(),k!==null&&k.updateLights(w.state.lightsArray),on=this.localClippingEnabled,zt=ie.init(this.clippingPlanes,on),zt===!0&&ie.setGlobalState(this.clippingPlanes,z),k!==null&&_e.render(w.state.shadowsArray,Q,z);let Y=new Set;return A.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ee=Z.material;if(Ee)if(Array.isArray(Ee))for(let Ie=0;Ie<Ee.length;Ie++){let Te=Ee[Ie];$o(Te,Q,z,Z),Y.add(Te)}else $o(Ee,Q,z,Z),Y.add(Ee)}),w=E.pop(),k!==null&&k.renderEnd(),Y},this.compileAsync=function(A,z,Q=null){let Y=this.compile(A,z,Q);return new Promise(Z=>{function Ee(){if(Y.forEach(function(Ie){let Le=Ve.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&Y.delete(Ie)}),Y.size===0){Z(A);return}setTimeout(Ee,10)}Ye.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Gr=null;function gh(A){Gr&&Gr(A)}function ml(){ys.stop()}function ji(){ys.start()}let ys=new B_;ys.setAnimationLoop(gh),typeof self<"u"&&ys.setContext(self),this.setAnimationLoop=function(A){Gr=A,he.setAnimationLoop(A),A===null?ys.stop():ys.start()},he.addEventListener("sessionstart",ml),he.addEventListener("sessionend",ji),this.render=function(A,z){if(z!==void 0&&z.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;k!==null&&k.renderStart(A,z);let Q=he.enabled===!0&&he.isPresenting===!0,Y=O!==null&&(ae===null||Q)&&O.begin(L,ae);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(z),z=he.getCamera()),A.isScene===!0&&A.onBeforeRender(L,A,z,ae),w=te.get(A,E.length),w.init(z),w.state.textureUnits=qe.getTextureUnits(),E.push(w),It.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?$t.setFromArrayCamera(z):it.setFromProjectionMatrix(It,Ri,z.reversedDepth),on=this.localClippingEnabled,zt=ie.init(this.clippingPlanes,on),R=be.get(A,y.length),R.init(),y.push(R),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Ie=L.xr.getDepthSensingMesh();Ie!==null&&xs(Ie,z,-1/0,L.sortObjects)}xs(A,z,0,L.sortObjects),R.finish(),k!==null&&k.updateLights(w.state.lightsArray),L.sortObjects===!0&&R.sort(Oe,Xe),Jt=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,Jt&&N.addToRenderList(R,A),this.info.autoReset===!0&&this.info.reset(),zt===!0&&ie.beginShadows();let Z=w.state.shadowsArray;if(_e.render(Z,A,z),zt===!0&&ie.endShadows(),(Y&&O.hasRenderPass())===!1){let Ie=R.opaque,Te=R.transmissive;if(w.setupLights(),z.isArrayCamera){let Le=z.cameras;if(Te.length>0)for(let ze=0,et=Le.length;ze<et;ze++){let dt=Le[ze];Li(Ie,Te,A,dt)}Jt&&N.render(A);for(let ze=0,et=Le.length;ze<et;ze++){let dt=Le[ze];Yo(R,A,dt,dt.viewport)}}else Te.length>0&&Li(Ie,Te,A,z),Jt&&N.render(A),Yo(R,A,z)}ae!==null&&G===0&&(qe.updateMultisampleRenderTarget(ae),qe.updateRenderTargetMipmap(ae)),Y&&O.end(L),A.isScene===!0&&A.onAfterRender(L,A,z),Me.resetDefaultState(),$=-1,K=null,E.pop(),E.length>0?(w=E[E.length-1],qe.setTextureUnits(w.state.textureUnits),zt===!0&&ie.setGlobalState(L.clippingPlanes,w.state.camera)):w=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,k!==null&&k.renderEnd()};function xs(A,z,Q,Y){if(A.visible===!1)return;if(A.layers.test(z.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(z);else if(A.isLight)w.pushLight(A),A.castShadow&&w.pushShadow(A);else if(A.isSprite){let Ie=z.isArrayCamera?$t:it;if(!A.frustumCulled||A.intersectsFrustum(Ie)){Y&&xt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(It);let Te=fe.update(A),Le=A.material;Le.visible&&R.push(A,Te,Le,Q,xt.z,null,z)}}else if(A.isMesh||A.isLine||A.isPoints){let Ie=z.isArrayCamera?$t:it;if(!A.frustumCulled||A.intersectsFrustum(Ie)){let Te=fe.update(A),Le=A.material;if(Y&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),xt.copy(A.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),xt.copy(Te.boundingSphere.center)),xt.applyMatrix4(A.matrixWorld).applyMatrix4(It)),Array.isArray(Le)){let ze=Te.groups;for(let et=0,dt=ze.length;et<dt;et++){let ke=ze[et],pt=Le[ke.materialIndex];pt&&pt.visible&&R.push(A,Te,pt,Q,xt.z,ke,z)}}else Le.visible&&R.push(A,Te,Le,Q,xt.z,null,z)}}}let Ee=A.children;for(let Ie=0,Te=Ee.length;Ie<Te;Ie++)xs(Ee[Ie],z,Q,Y)}function Yo(A,z,Q,Y){let{opaque:Z,transmissive:Ee,transparent:Ie}=A;w.setupLightsView(Q),zt===!0&&ie.setGlobalState(L.clippingPlanes,Q),Y&&we.viewport(ee.copy(Y)),Z.length>0&&Kt(Z,z,Q),Ee.length>0&&Kt(Ee,z,Q),Ie.length>0&&Kt(Ie,z,Q),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Li(A,z,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[Y.id]===void 0){let ke=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[Y.id]=new vi(1,1,{generateMipmaps:!0,type:ke?Zi:oi,minFilter:Fs,samples:Math.max(4,rt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:yt.workingColorSpace})}let Ee=w.state.transmissionRenderTarget[Y.id],Ie=Y.viewport||ee;Ee.setSize(Ie.z*L.transmissionResolutionScale,Ie.w*L.transmissionResolutionScale);let Te=L.getRenderTarget(),Le=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(Ee),L.getClearColor(j),ye=L.getClearAlpha(),ye<1&&L.setClearColor(16777215,.5),L.clear(),Jt&&N.render(Q);let et=L.toneMapping;L.toneMapping=fs;let dt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),w.setupLightsView(Y),zt===!0&&ie.setGlobalState(L.clippingPlanes,Y),Kt(A,Q,Y),qe.updateMultisampleRenderTarget(Ee),qe.updateRenderTargetMipmap(Ee),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let pt=0,Zt=z.length;pt<Zt;pt++){let Rt=z[pt],{object:Ct,geometry:gn,material:Ne,group:ln}=Rt;if(Ne.side===Ii&&Ct.layers.test(Y.layers)){let gt=Ne.side;Ne.side=ni,Ne.needsUpdate=!0,sn(Ct,Q,Y,gn,Ne,ln),Ne.side=gt,Ne.needsUpdate=!0,ke=!0}}ke===!0&&(qe.updateMultisampleRenderTarget(Ee),qe.updateRenderTargetMipmap(Ee))}L.setRenderTarget(Te,Le,ze),L.setClearColor(j,ye),dt!==void 0&&(Y.viewport=dt),L.toneMapping=et}function Kt(A,z,Q){let Y=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,Ee=A.length;Z<Ee;Z++){let Ie=A[Z],{object:Te,geometry:Le,group:ze}=Ie,et=Ie.material;et.allowOverride===!0&&Y!==null&&(et=Y),Te.layers.test(Q.layers)&&sn(Te,z,Q,Le,et,ze)}}function sn(A,z,Q,Y,Z,Ee){k!==null&&Z.isNodeMaterial&&k.setObject(A,Z),A.onBeforeRender(L,z,Q,Y,Z,Ee),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Z.onBeforeRender(L,z,Q,Y,A,Ee),Z.transparent===!0&&Z.side===Ii&&Z.forceSinglePass===!1?(Z.side=ni,Z.needsUpdate=!0,L.renderBufferDirect(Q,z,Y,Z,A,Ee),Z.side=cr,Z.needsUpdate=!0,L.renderBufferDirect(Q,z,Y,Z,A,Ee),Z.side=Ii):L.renderBufferDirect(Q,z,Y,Z,A,Ee),A.onAfterRender(L,z,Q,Y,Z,Ee)}function rn(A){let z=0;for(let Q of A)Q.texture!==null&&z++;return z}function Qi(A,z,Q){z.isScene!==!0&&(z=mn);let Y=Ve.get(A),Z=w.state.lights,Ee=w.state.shadowsArray,Ie=Z.state.version,Te=oe.getParameters(A,Z.state,Ee,z,Q,w.state.lightProbeGridArray),Le=oe.getProgramCacheKey(Te),ze=Y.programs;Y.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?z.environment:null,Y.fog=z.fog;let et=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Y.envMap=C.get(A.envMap||Y.environment,et),Y.envMapRotation=Y.environment!==null&&A.envMap===null?z.environmentRotation:A.envMapRotation,ze===void 0&&(A.addEventListener("dispose",lt),ze=new Map,Y.programs=ze,Y.programVariants=new Map);let dt=ze.get(Le);if(dt!==void 0){if(Y.currentProgram===dt&&Y.lightsStateVersion===Ie)return Zo(A,Te),dt}else Te.uniforms=oe.getUniforms(A),k!==null&&A.isNodeMaterial&&k.build(A,Q,Te),A.onBeforeCompile(Te,L),dt=oe.acquireProgram(Te,Le),ze.set(Le,dt),Y.uniforms=Te.uniforms;let ke=Y.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(ke.clippingPlanes=ie.uniform),Zo(A,Te),Y.needsLights=Bs(A),Y.lightsStateVersion=Ie,Y.needsLights&&(ke.ambientLightColor.value=Z.state.ambient,ke.lightProbe.value=Z.state.probe,ke.sunLights.value=Z.state.sun,ke.sunLightShadows.value=Z.state.sunShadow,ke.directionalLights.value=Z.state.directional,ke.directionalLightShadows.value=Z.state.directionalShadow,ke.spotLights.value=Z.state.spot,ke.spotLightShadows.value=Z.state.spotShadow,ke.rectAreaLights.value=Z.state.rectArea,ke.ltc_1.value=Z.state.rectAreaLTC1,ke.ltc_2.value=Z.state.rectAreaLTC2,ke.pointLights.value=Z.state.point,ke.pointLightShadows.value=Z.state.pointShadow,ke.hemisphereLights.value=Z.state.hemi,ke.sunShadowMatrix.value=Z.state.sunShadowMatrix,ke.sunShadowCascade.value=Z.state.sunShadowCascade,ke.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ke.spotLightMatrix.value=Z.state.spotLightMatrix,ke.spotLightMap.value=Z.state.spotLightMap,ke.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=rn(w.state.lightProbeGridArray),Y.currentProgram=dt,Y.uniformsList=null,dt}function li(A,z,Q,Y,Z){let Ee=Ve.get(A),Ie=Ee.currentProgram.id+","+Y+","+Z,Te=Ee.programVariants.get(Ie);return Te===void 0?(Te=Qi(A,z,Q),Ee.programVariants.set(Ie,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=Y,Ee.toneMapping=Z),Te}function Os(A){if(A.uniformsList===null){let z=A.currentProgram.getUniforms();A.uniformsList=Wo.seqWithValue(z.seq,A.uniforms)}return A.uniformsList}function Zo(A,z){let Q=Ve.get(A);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function Jo(A,z,Q,Y,Z){z.isScene!==!0&&(z=mn),qe.resetTextureUnits();let Ee=z.fog,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?z.environment:null,Te=ae===null?L.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:yt.workingColorSpace,Le=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,ze=C.get(Y.envMap||Ie,Le),et=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,dt=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ke=!!Q.morphAttributes.position,pt=!!Q.morphAttributes.normal,Zt=!!Q.morphAttributes.color,Rt=fs;Y.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(Rt=L.toneMapping);let Ct=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,gn=Ct!==void 0?Ct.length:0,Ne=Ve.get(Y),ln=w.state.lights;if(zt===!0&&(on===!0||A!==K)){let Pt=A===K&&Y.id===$;ie.setState(Y,A,Pt)}let gt=!1,vs=!1;Y.version===Ne.__version?Ne.needsLights&&Ne.lightsStateVersion!==ln.state.version||Z.isBatchedMesh&&Ne.batching===!1||!Z.isBatchedMesh&&Ne.batching===!0||Z.isBatchedMesh&&Ne.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ne.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ne.instancing===!1||!Z.isInstancedMesh&&Ne.instancing===!0||Z.isSkinnedMesh&&Ne.skinning===!1||!Z.isSkinnedMesh&&Ne.skinning===!0||Z.isInstancedMesh&&Ne.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ne.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ne.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ne.instancingMorph===!1&&Z.morphTexture!==null||Ne.envMap!==ze||Y.fog===!0&&Ne.fog!==Ee||Ne.numClippingPlanes!==void 0&&(Ne.numClippingPlanes!==ie.numPlanes||Ne.numIntersection!==ie.numIntersection)||Ne.vertexAlphas!==et||Ne.vertexTangents!==dt||Ne.morphTargets!==ke||Ne.morphNormals!==pt||Ne.morphColors!==Zt||Ne.morphTargetsCount!==gn||Ne.numLightProbeGrids!==rn(w.state.lightProbeGridArray)?gt=!0:(Ne.outputColorSpace!==Te||Ne.toneMapping!==Rt)&&(vs=!0):(gt=!0,Ne.__version=Y.version);let cn=Ne.currentProgram;(gt===!0||vs===!0)&&(cn=vs===!0?li(Y,z,Z,Te,Rt):Qi(Y,z,Z),k&&Y.isNodeMaterial&&k.onUpdateProgram(Y,cn,Ne));let Xr=!1,es=!1,bs=!1,ut=cn.getUniforms(),jt=Ne.uniforms;if(we.useProgram(cn.program)&&(Xr=!0,es=!0,bs=!0),Y.id!==$&&($=Y.id,es=!0),Xr||K!==A){we.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ut.setValue(U,"projectionMatrix",A.projectionMatrix),ut.setValue(U,"viewMatrix",A.matrixWorldInverse);let un=ut.map.cameraPosition;un!==void 0&&un.setValue(U,Sn.setFromMatrixPosition(A.matrixWorld)),rt.logarithmicDepthBuffer&&ut.setValue(U,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ut.setValue(U,"isOrthographic",A.isOrthographicCamera===!0),K!==A&&(K=A,es=!0,bs=!0)}if(Ne.needsLights&&(ln.state.sunShadowMap.length>0&&ut.setValue(U,"sunShadowMap",ln.state.sunShadowMap,qe),ln.state.directionalShadowMap.length>0&&ut.setValue(U,"directionalShadowMap",ln.state.directionalShadowMap,qe),ln.state.spotShadowMap.length>0&&ut.setValue(U,"spotShadowMap",ln.state.spotShadowMap,qe),ln.state.pointShadowMap.length>0&&ut.setValue(U,"pointShadowMap",ln.state.pointShadowMap,qe)),Z.isSkinnedMesh){ut.setOptional(U,Z,"bindMatrix"),ut.setOptional(U,Z,"bindMatrixInverse");let Pt=Z.skeleton;Pt&&(Pt.boneTexture===null&&Pt.computeBoneTexture(),ut.setValue(U,"boneTexture",Pt.boneTexture,qe))}Z.isBatchedMesh&&(ut.setOptional(U,Z,"batchingTexture"),ut.setValue(U,"batchingTexture",Z._matricesTexture,qe),ut.setOptional(U,Z,"batchingIdTexture"),ut.setValue(U,"batchingIdTexture",Z._indirectTexture,qe),ut.setOptional(U,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ut.setValue(U,"batchingColorTexture",Z._colorsTexture,qe));let $n=Q.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&re.update(Z,Q,cn),(es||Ne.receiveShadow!==Z.receiveShadow)&&(Ne.receiveShadow=Z.receiveShadow,ut.setValue(U,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&z.environment!==null&&(jt.envMapIntensity.value=z.environmentIntensity),jt.dfgLUT!==void 0&&(jt.dfgLUT.value=pT()),es){if(ut.setValue(U,"toneMappingExposure",L.toneMappingExposure),Ne.needsLights&&Hr(jt,bs),Ee&&Y.fog===!0&&ve.refreshFogUniforms(jt,Ee),ve.refreshMaterialUniforms(jt,Y,pe,me,w.state.transmissionRenderTarget[A.id]),Ne.needsLights&&Ne.numLightProbeGrids>0){let Pt=x,un=0;for(let Vn of w.state.lightProbeGridArray)Vn.texture!==null&&(Pt.textures[un]=Vn.texture,Pt.min[un]=Vn.boundingBox.min,Pt.max[un]=Vn.boundingBox.max,Pt.resolution[un]=Vn.resolution,un++);for(let Vn in Pt)Pt[Vn].length=un;jt.probesSH.value=Pt.textures,jt.probesMin.value=Pt.min,jt.probesMax.value=Pt.max,jt.probesResolution.value=Pt.resolution}Wo.upload(U,Os(Ne),jt,qe)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Wo.upload(U,Os(Ne),jt,qe),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ut.setValue(U,"center",Z.center),ut.setValue(U,"modelViewMatrix",Z.modelViewMatrix),ut.setValue(U,"normalMatrix",Z.normalMatrix),ut.setValue(U,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Pt=Y.uniformsGroups;for(let un=0,Vn=Pt.length;un<Vn;un++){let gl=Pt[un];He.update(gl,cn),He.bind(gl,cn)}}return cn}function Hr(A,z){A.ambientLightColor.needsUpdate=z,A.lightProbe.needsUpdate=z,A.sunLights.needsUpdate=z,A.sunLightShadows.needsUpdate=z,A.directionalLights.needsUpdate=z,A.directionalLightShadows.needsUpdate=z,A.pointLights.needsUpdate=z,A.pointLightShadows.needsUpdate=z,A.spotLights.needsUpdate=z,A.spotLightShadows.needsUpdate=z,A.rectAreaLights.needsUpdate=z,A.hemisphereLights.needsUpdate=z}function Bs(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(A,z,Q){let Y=Ve.get(A);Y.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ve.get(A.texture).__webglTexture=z,Ve.get(A.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,z){let Q=Ve.get(A);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(A,z=0,Q=0){ae=A,q=z,G=Q;let Y=null,Z=!1,Ee=!1;if(A){let Te=Ve.get(A);if(Te.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(U.FRAMEBUFFER,Te.__webglFramebuffer),ee.copy(A.viewport),de.copy(A.scissor),ue=A.scissorTest,we.viewport(ee),we.scissor(de),we.setScissorTest(ue),$=-1;return}else if(Te.__webglFramebuffer===void 0)qe.setupRenderTarget(A);else if(Te.__hasExternalTextures)qe.rebindTextures(A,Ve.get(A.texture).__webglTexture,Ve.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let et=A.depthTexture;if(Te.__boundDepthTexture!==et){if(et!==null&&Ve.has(et)&&(A.width!==et.image.width||A.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(A)}}let Le=A.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ee=!0);let ze=Ve.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?Y=ze[z][Q]:Y=ze[z],Z=!0):A.samples>0&&qe.useMultisampledRTT(A)===!1?Y=Ve.get(A).__webglMultisampledFramebuffer:Array.isArray(ze)?Y=ze[Q]:Y=ze,ee.copy(A.viewport),de.copy(A.scissor),ue=A.scissorTest}else ee.copy(Ge).multiplyScalar(pe).floor(),de.copy(ft).multiplyScalar(pe).floor(),ue=ct;if(Q!==0&&(Y=V),we.bindFramebuffer(U.FRAMEBUFFER,Y)&&we.drawBuffers(A,Y),we.viewport(ee),we.scissor(de),we.setScissorTest(ue),Z){let Te=Ve.get(A.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+z,Te.__webglTexture,Q)}else if(Ee){let Te=z;for(let Le=0;Le<A.textures.length;Le++){let ze=Ve.get(A.textures[Le]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Le,ze.__webglTexture,Q,Te)}}else if(A!==null&&Q!==0){let Te=Ve.get(A.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Te.__webglTexture,Q)}$=-1};function Wr(A){let z=Ve.get(A);return(z.__readFormat!==A.format||z.__readType!==A.type)&&(z.__readFormat=A.format,z.__readType=A.type,z.__formatReadable=rt.textureFormatReadable(A.format),z.__typeReadable=rt.textureTypeReadable(A.type)),z}this.readRenderTargetPixels=function(A,z,Q,Y,Z,Ee,Ie,Te=0){if(!(A&&A.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){we.bindFramebuffer(U.FRAMEBUFFER,Le);try{let ze=A.textures[Te],et=ze.format,dt=ze.type;A.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Te);let ke=Wr(ze);if(ke.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=A.width-Y&&Q>=0&&Q<=A.height-Z&&U.readPixels(z,Q,Y,Z,xe.convert(et),xe.convert(dt),Ee)}finally{let ze=ae!==null?Ve.get(ae).__webglFramebuffer:null;we.bindFramebuffer(U.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(A,z,Q,Y,Z,Ee,Ie,Te=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(z>=0&&z<=A.width-Y&&Q>=0&&Q<=A.height-Z){we.bindFramebuffer(U.FRAMEBUFFER,Le);let ze=A.textures[Te],et=ze.format,dt=ze.type;A.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Te);let ke=Wr(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,pt),U.bufferData(U.PIXEL_PACK_BUFFER,Ee.byteLength,U.STREAM_READ),U.readPixels(z,Q,Y,Z,xe.convert(et),xe.convert(dt),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let Zt=ae!==null?Ve.get(ae).__webglFramebuffer:null;we.bindFramebuffer(U.FRAMEBUFFER,Zt);let Rt=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await f_(U,Rt,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,pt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Ee),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(pt),U.deleteSync(Rt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,z=null,Q=0){let Y=Math.pow(2,-Q),Z=Math.floor(A.image.width*Y),Ee=Math.floor(A.image.height*Y),Ie=z!==null?z.x:0,Te=z!==null?z.y:0;qe.setTexture2D(A,0),U.copyTexSubImage2D(U.TEXTURE_2D,Q,0,0,Ie,Te,Z,Ee),we.unbindTexture()},this.copyTextureToTexture=function(A,z,Q=null,Y=null,Z=0,Ee=0){let Ie,Te,Le,ze,et,dt,ke,pt,Zt,Rt=A.isCompressedTexture?A.mipmaps[Ee]:A.image;if(Q!==null)Ie=Q.max.x-Q.min.x,Te=Q.max.y-Q.min.y,Le=Q.isBox3?Q.max.z-Q.min.z:1,ze=Q.min.x,et=Q.min.y,dt=Q.isBox3?Q.min.z:0;else{let ut=Math.pow(2,-Z);Ie=Math.floor(Rt.width*ut),Te=Math.floor(Rt.height*ut),A.isDataArrayTexture?Le=Rt.depth:A.isData3DTexture?Le=Math.floor(Rt.depth*ut):Le=1,ze=0,et=0,dt=0}Y!==null?(ke=Y.x,pt=Y.y,Zt=Y.z):(ke=0,pt=0,Zt=0);let Ct=xe.convert(z.format),gn=xe.convert(z.type),Ne;z.isData3DTexture?(qe.setTexture3D(z,0),Ne=U.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(qe.setTexture2DArray(z,0),Ne=U.TEXTURE_2D_ARRAY):(qe.setTexture2D(z,0),Ne=U.TEXTURE_2D),we.activeTexture(U.TEXTURE0),we.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,z.flipY),we.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),we.pixelStorei(U.UNPACK_ALIGNMENT,z.unpackAlignment);let ln=we.getParameter(U.UNPACK_ROW_LENGTH),gt=we.getParameter(U.UNPACK_IMAGE_HEIGHT),vs=we.getParameter(U.UNPACK_SKIP_PIXELS),cn=we.getParameter(U.UNPACK_SKIP_ROWS),Xr=we.getParameter(U.UNPACK_SKIP_IMAGES);we.pixelStorei(U.UNPACK_ROW_LENGTH,Rt.width),we.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Rt.height),we.pixelStorei(U.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(U.UNPACK_SKIP_ROWS,et),we.pixelStorei(U.UNPACK_SKIP_IMAGES,dt);let es=A.isDataArrayTexture||A.isData3DTexture,bs=z.isDataArrayTexture||z.isData3DTexture;if(A.isDepthTexture){let ut=Ve.get(A),jt=Ve.get(z),$n=Ve.get(ut.__renderTarget),Pt=Ve.get(jt.__renderTarget);we.bindFramebuffer(U.READ_FRAMEBUFFER,$n.__webglFramebuffer),we.bindFramebuffer(U.DRAW_FRAMEBUFFER,Pt.__webglFramebuffer);for(let un=0;un<Le;un++)es&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ve.get(A).__webglTexture,Z,dt+un),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ve.get(z).__webglTexture,Ee,Zt+un)),U.blitFramebuffer(ze,et,ze+Ie,et+Te,ke,pt,ke+Ie,pt+Te,U.DEPTH_BUFFER_BIT,U.NEAREST);we.bindFramebuffer(U.READ_FRAMEBUFFER,null),we.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(Z!==0||A.isRenderTargetTexture||Ve.has(A)){let ut=Ve.get(A),jt=Ve.get(z);we.bindFramebuffer(U.READ_FRAMEBUFFER,D),we.bindFramebuffer(U.DRAW_FRAMEBUFFER,H);for(let $n=0;$n<Le;$n++)es?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ut.__webglTexture,Z,dt+$n):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,ut.__webglTexture,Z),bs?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,jt.__webglTexture,Ee,Zt+$n):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,jt.__webglTexture,Ee),Z!==0?U.blitFramebuffer(ze,et,ze+Ie,et+Te,ke,pt,ke+Ie,pt+Te,U.COLOR_BUFFER_BIT,U.NEAREST):bs?U.copyTexSubImage3D(Ne,Ee,ke,pt,Zt+$n,ze,et,Ie,Te):U.copyTexSubImage2D(Ne,Ee,ke,pt,ze,et,Ie,Te);we.bindFramebuffer(U.READ_FRAMEBUFFER,null),we.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else bs?A.isDataTexture||A.isData3DTexture?U.texSubImage3D(Ne,Ee,ke,pt,Zt,Ie,Te,Le,Ct,gn,Rt.data):z.isCompressedArrayTexture?U.compressedTexSubImage3D(Ne,Ee,ke,pt,Zt,Ie,Te,Le,Ct,Rt.data):U.texSubImage3D(Ne,Ee,ke,pt,Zt,Ie,Te,Le,Ct,gn,Rt):A.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Ee,ke,pt,Ie,Te,Ct,gn,Rt.data):A.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Ee,ke,pt,Rt.width,Rt.height,Ct,Rt.data):U.texSubImage2D(U.TEXTURE_2D,Ee,ke,pt,Ie,Te,Ct,gn,Rt);we.pixelStorei(U.UNPACK_ROW_LENGTH,ln),we.pixelStorei(U.UNPACK_IMAGE_HEIGHT,gt),we.pixelStorei(U.UNPACK_SKIP_PIXELS,vs),we.pixelStorei(U.UNPACK_SKIP_ROWS,cn),we.pixelStorei(U.UNPACK_SKIP_IMAGES,Xr),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&U.generateMipmap(Ne),we.unbindTexture()},this.initRenderTarget=function(A){Ve.get(A).__webglFramebuffer===void 0&&qe.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?qe.setTextureCube(A,0):A.isData3DTexture?qe.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?qe.setTexture2DArray(A,0):qe.setTexture2D(A,0),we.unbindTexture()},this.resetState=function(){q=0,G=0,ae=null,we.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=yt._getDrawingBufferColorSpace(e),t.unpackColorSpace=yt._getUnpackColorSpace()}};var Z_={type:"change"},Vd={type:"start"},K_={type:"end"},Zu=new Cr,J_=new xi,mT=Math.cos(70*Ki.DEG2RAD),bn=new B,ai=2*Math.PI,wt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},zd=1e-6,Ju=class extends Qa{constructor(e,t=null){super(e,t),this.state=wt.NONE,this.target=new B,this.cursor=new B,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ar.ROTATE,MIDDLE:ar.DOLLY,RIGHT:ar.PAN},this.touches={ONE:lr.ROTATE,TWO:lr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new B,this._lastQuaternion=new Ln,this._lastTargetPosition=new B,this._quat=new Ln().setFromUnitVectors(e.up,new B(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new or,this._sphericalDelta=new or,this._scale=1,this._panOffset=new B,this._rotateStart=new Ze,this._rotateEnd=new Ze,this._rotateDelta=new Ze,this._panStart=new Ze,this._panEnd=new Ze,this._panDelta=new Ze,this._dollyStart=new Ze,this._dollyEnd=new Ze,this._dollyDelta=new Ze,this._dollyDirection=new B,this._mouse=new Ze,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=_T.bind(this),this._onPointerDown=gT.bind(this),this._onPointerUp=yT.bind(this),this._onContextMenu=AT.bind(this),this._onMouseWheel=bT.bind(this),this._onKeyDown=ST.bind(this),this._onTouchStart=MT.bind(this),this._onTouchMove=wT.bind(this),this._onMouseDown=xT.bind(this),this._onMouseMove=vT.bind(this),this._interceptControlDown=ET.bind(this),this._interceptControlUp=TT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=wt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Z_),this.update(),this.state=wt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;bn.copy(t).sub(this.target),bn.applyQuaternion(this._quat),this._spherical.setFromVector3(bn),this.autoRotate&&this.state===wt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ai:n>Math.PI&&(n-=ai),s<-Math.PI?s+=ai:s>Math.PI&&(s-=ai),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(bn.setFromSpherical(this._spherical),bn.applyQuaternion(this._quatInverse),t.copy(this.target).add(bn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=bn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new B(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new B(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=bn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Zu.origin.copy(this.object.position),Zu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Zu.direction))<mT?this.object.lookAt(this.target):(J_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Zu.intersectPlane(J_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>zd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>zd||this._lastTargetPosition.distanceToSquared(this.target)>zd?(this.dispatchEvent(Z_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ai/60*this.autoRotateSpeed*e:ai/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){bn.setFromMatrixColumn(t,0),bn.multiplyScalar(-e),this._panOffset.add(bn)}_panUp(e,t){this.screenSpacePanning===!0?bn.setFromMatrixColumn(t,1):(bn.setFromMatrixColumn(t,0),bn.crossVectors(this.object.up,bn)),bn.multiplyScalar(e),this._panOffset.add(bn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;bn.copy(s).sub(this.target);let r=bn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/t.clientHeight),this._rotateUp(ai*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/t.clientHeight),this._rotateUp(ai*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ze,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function gT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function _T(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function yT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(K_),this.state=wt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function xT(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ar.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=wt.DOLLY;break;case ar.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=wt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=wt.ROTATE}break;case ar.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=wt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=wt.PAN}break;default:this.state=wt.NONE}this.state!==wt.NONE&&this.dispatchEvent(Vd)}function vT(i){switch(this.state){case wt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case wt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case wt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function bT(i){this.enabled===!1||this.enableZoom===!1||this.state!==wt.NONE||(i.preventDefault(),this.dispatchEvent(Vd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(K_))}function ST(i){this.enabled!==!1&&this._handleKeyDown(i)}function MT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case lr.ROTATE:if(this.enableRotate===!1){this.state=wt.NONE;break}this._handleTouchStartRotate(i),this.state=wt.TOUCH_ROTATE;break;case lr.PAN:if(this.enablePan===!1){this.state=wt.NONE;break}this._handleTouchStartPan(i),this.state=wt.TOUCH_PAN;break;default:this.state=wt.NONE}break;case 2:switch(this.touches.TWO){case lr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=wt.TOUCH_DOLLY_PAN;break;case lr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=wt.TOUCH_DOLLY_ROTATE;break;default:this.state=wt.NONE}break;default:this.state=wt.NONE}this.state!==wt.NONE&&this.dispatchEvent(Vd)}function wT(i){switch(this._trackPointer(i),this.state){case wt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case wt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case wt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case wt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=wt.NONE}}function AT(i){this.enabled!==!1&&i.preventDefault()}function ET(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function TT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var j_=["iso","front","side","top","tip"],RT={iso:[.62,-1,.55],front:[1,0,.08],side:[0,-1,.08],top:[0,-.001,1],tip:[.62,-1,.4]},CT=.35,Ku=class{constructor(e,t,n,s){this.camera=e;this.canvas=t;this.reach=n;this.changed=s;this.controls=new Ju(e,t),this.controls.minDistance=.05*n,this.controls.maxDistance=40*n,this.controls.enableZoom=!1,this.controls.addEventListener("change",s),t.addEventListener("keydown",this.key),t.addEventListener("focus",this.zoomable),t.addEventListener("blur",this.zoomable)}camera;canvas;reach;changed;view="iso";box=new On;controls;start=new B;end=new B;targetStart=new B;targetEnd=new B;offset=new B;spherical=new or;began=0;gliding=0;show(e,t,n){this.view=e;let s=this.offset.set(...RT[e]).normalize(),r=e==="tip";r?this.targetEnd.fromArray(t):this.box.getCenter(this.targetEnd);let o=r?.55*this.reach:this.fitting(s,this.targetEnd);if(this.end.copy(this.targetEnd).addScaledVector(s,o),cancelAnimationFrame(this.gliding),!n)return this.place(1);this.start.copy(this.camera.position),this.targetStart.copy(this.controls.target),this.began=performance.now(),this.step(this.began)}take(e){this.view=e.view,this.camera.position.copy(e.camera.position),this.controls.target.copy(e.controls.target),this.controls.update()}follow(e){this.view==="tip"&&(this.offset.copy(this.camera.position).sub(this.controls.target),this.controls.target.fromArray(e),this.camera.position.copy(this.controls.target).add(this.offset),this.camera.lookAt(this.controls.target))}dispose(){cancelAnimationFrame(this.gliding),this.controls.dispose(),this.canvas.removeEventListener("keydown",this.key),this.canvas.removeEventListener("focus",this.zoomable),this.canvas.removeEventListener("blur",this.zoomable)}zoomable=e=>{this.controls.enableZoom=e.type==="focus"};key=e=>{if(e.ctrlKey||e.metaKey||e.altKey)return;let t=Ki.degToRad(5),s={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[e.key];if(s&&e.shiftKey)this.pan(.04*s[0],-.04*s[1]);else if(s)this.turn(t*s[0],t*s[1],1);else if(e.key==="+"||e.key==="=")this.turn(0,0,1/1.15);else if(e.key==="-")this.turn(0,0,1.15);else return;e.preventDefault(),e.stopPropagation()};turn(e,t,n){let{camera:s,controls:r,offset:o,spherical:a}=this;o.copy(s.position).sub(r.target),a.setFromCartesianCoords(o.y,o.z,o.x),a.theta+=e,a.phi=Ki.clamp(a.phi+t,.001,Math.PI-.001),a.radius=Ki.clamp(a.radius*n,r.minDistance,r.maxDistance),o.setFromSpherical(a),s.position.set(o.z,o.x,o.y).add(r.target),r.update(),this.changed()}pan(e,t){let{camera:n,controls:s,offset:r}=this,o=n.position.distanceTo(s.target);for(let[a,l]of[[0,e],[1,t]])r.setFromMatrixColumn(n.matrix,a).multiplyScalar(l*o),n.position.add(r),s.target.add(r);s.update(),this.changed()}fitting(e,t){let{camera:n,box:s}=this,r=Math.tan(Ki.degToRad(n.fov/2)),o=new B().crossVectors(n.up,e).normalize(),a=new B().crossVectors(e,o),l=new B,c=.3*this.reach;for(let u=0;u<8;u++){l.set(u&1?s.max.x:s.min.x,u&2?s.max.y:s.min.y,u&4?s.max.z:s.min.z).sub(t);let h=l.dot(e);c=Math.max(c,Math.abs(l.dot(o))/(r*n.aspect)+h,Math.abs(l.dot(a))/r+h)}return 1.18*c}step=e=>{let t=Math.min(1,Math.max(0,(e-this.began)/1e3/CT));this.place(t*t*(3-2*t)),t<1&&(this.gliding=requestAnimationFrame(this.step))};place(e){this.camera.position.lerpVectors(e<1?this.start:this.end,this.end,e),this.controls.target.lerpVectors(e<1?this.targetStart:this.targetEnd,this.targetEnd,e),this.controls.update(),this.changed()}};var Q_=[["reference","Reference (ghost)"],["rigid","Rigid plan (ghost)"],["traces","Paths of the tips"],["force","Contact force"],["surface","Surface"],["floor","Floor"],["apart","Side by side"]];var IT={iso:"Oblique",front:"Front",side:"Side",top:"Top",tip:"Tip (follows)"},ey=100;function kt(i,e={},...t){let n=document.createElement(i);return Object.assign(n,e),n.append(...t),n}function ty(i,e,t,n,s){let r=kt("div",{className:"scene-bar",role:"toolbar",ariaLabel:"The robot in space"}),o=Gd("Colour",e,i.colour,c=>{i.colour=c,s.changed()});r.append(kt("label",{},"Colour",o)),n&&r.append(LT(i,s));let a=Gd("View",j_.map(c=>[c,IT[c]]),"iso",c=>s.look(c));r.append(kt("label",{},"View",a));let l=kt("button",{type:"button",ariaLabel:"Reset view"},"Reset");return l.addEventListener("click",()=>s.look(a.value)),r.append(l,FT(i,t,s)),r}function LT(i,e){let t=kt("input",{type:"range",min:"0",max:String(ey),step:"1",value:"0",ariaLabel:"Deformation"}),n=kt("output",{},"×1");return t.dataset.scene="factor",t.addEventListener("input",()=>{i.factor=DT(200**(Number(t.value)/ey)),n.textContent=t.ariaValueText=`×${i.factor}`,e.changed()}),t.title="How many times the displacement of each robot from itself without elasticity is enlarged; double click: to scale",t.addEventListener("dblclick",()=>{t.value="0",t.dispatchEvent(new Event("input"))}),kt("label",{},"Deformation",t,n)}function DT(i){return i<10?Math.round(10*i)/10:Math.round(i)}function FT(i,e,t){let n=kt("div",{className:"scene-more"});for(let[o,a]of Q_){if(!e.includes(o))continue;let l=kt("input",{type:"checkbox",checked:i[o]});l.dataset.scene=o,l.addEventListener("change",()=>{i[o]=l.checked,t.changed(),o==="apart"&&t.look("iso")}),n.append(kt("label",{},l,a))}let s=Gd("Quality",[["auto","automatic"],["low","low"],["high","high"]],i.quality,o=>{i.quality=o,t.quality()});n.append(kt("label",{},"Quality",s));let r=kt("details",{},kt("summary",{},"Show"),n);return r.addEventListener("keydown",o=>{o.key==="Escape"&&(r.open=!1,r.querySelector("summary")?.focus())}),r}function Gd(i,e,t,n){let s=kt("select",{ariaLabel:i},...e.map(([r,o])=>kt("option",{value:r,textContent:o})));return s.value=t,s.addEventListener("change",()=>n(s.value)),s}var NT={m:[[1e-4,1e6,"µm"],[.5,1e3,"mm"]],Pa:[[1e3,1,"Pa"],[1e6,.001,"kPa"],[1/0,1e-6,"MPa"]],rad:[[.1,1e3,"mrad"]],"N m":[[.1,1e3,"mN m"],[1e4,1,"N m"],[1/0,.001,"kN m"]],N:[[.1,1e3,"mN"],[1e4,1,"N"],[1/0,.001,"kN"]],1:[[.01,1e6,"µm/m"],[1/0,100,"%"]]};function ju(i,e){let t=(NT[i]??[]).find(([n])=>Math.abs(e)<n);return t===void 0||e===0?{factor:1,name:i==="1"?"":i}:{factor:t[1],name:t[2]}}function ps(i){if(!Number.isFinite(i))return"–";let e=Math.abs(i);if(e!==0&&(e>=1e5||e<.001))return i.toExponential(2).replace("-","−");let t=e===0?0:Math.max(0,2-Math.floor(Math.log10(e)));return String(Number(i.toFixed(t))).replace("-","−")}function dl(i){let e=10**Math.floor(Math.log10(i));return e*(i>=5*e?5:i>=2*e?2:1)}function ny(i){let e=new On,t=new B,n=.001,s=0;for(let{scene:l}of i.runs){for(let c of[l.line,l.tip])for(let u=0;u+2<c.data.length;u+=3)e.expandByPoint(t.fromArray(c.data,u));n=Math.max(n,UT(l.line.data,l.line.shape));for(let c of l.links)c.section?.sizes.data.forEach(u=>s=Math.max(s,u))}e.isEmpty()&&e.expandByPoint(t.set(0,0,0));let r=Math.max(n,e.getSize(t).length()/2),o=Math.min(Math.max(s,.012*n),.022*n),a=OT(e,i,n);for(let{scene:l}of i.runs)l.line.data.length&&e.expandByPoint(t.fromArray(l.line.data).setZ(a));return{box:e,reach:n,cell:dl(r/5),usual:o,least:.006*n,floor:a}}function UT(i,[,e,t]){let n=0;for(let s=0;s<e;s++)for(let r=1;r<t;r++){let o=3*(s*t+r);n+=Math.hypot(i[o]-i[o-3],i[o+1]-i[o-2],i[o+2]-i[o-1])}return n}function OT(i,e,t){let n=e.runs[0]?.scene.line.data[2]??0,s=i.max.z-i.min.z>.2*t&&n<t;if(i.min.z>=-.001*t&&s)return 0;let r=dl(.1*t);return Math.floor((Math.min(i.min.z,n)-.12*t)/r)*r}var Hd=["#0072b2","#d55e00","#009e73","#cc79a7","#e69f00","#56b4e9"],BT={link:"#9aa5b1",joint:"#4a5562",gear:"#c76a00",base:"#39434e",payload:"#2b333c",grid:"#c3cad1",gridStrong:"#8e99a4",surface:"#009e73",force:"#b3261e",reference:"#d55e00",rigid:"#6b7681",before:"#7a4ea3",real:"#0072b2",sky:"#ffffff",ground:"#b9c0c8"},kT={link:"#8b96a3",joint:"#a9b4c0",gear:"#e69f00",base:"#6d7986",payload:"#cfd6dd",grid:"#39424c",gridStrong:"#5c6874",surface:"#2fbf95",force:"#ff7b70",reference:"#ff8c42",rigid:"#a3adb7",before:"#c79be8",real:"#56b4e9",sky:"#ffffff",ground:"#5a6570"};function iy(i){return i?kT:BT}var sy="440154 481a6c 472f7d 414487 39568c 31688e 2a788e 23888e 1f988b 22a884 35b779 54c568 7ad151 a5db36 d2e21b fde725",pl=256,fr=zT();function zT(){let i=sy.split(" ").map(t=>[0,2,4].map(n=>parseInt(t.slice(n,n+2),16)/255)),e=new Float32Array(3*pl);for(let t=0;t<pl;t++){let n=t/(pl-1)*(i.length-1),s=Math.min(Math.floor(n),i.length-2);for(let r=0;r<3;r++)e[3*t+r]=i[s][r]+(n-s)*(i[s+1][r]-i[s][r])}return e}function Qu(i){return 3*Math.max(0,Math.min(pl-1,Math.round(i*(pl-1))))}function ry(){return`linear-gradient(to top, ${sy.split(" ").map(i=>`#${i}`).join(", ")})`}var oy=5,th=class{legend=eh("scene-legend");scale=eh("scene-scale");factor=eh("scene-factor");grid=eh("scene-grid");live=kt("span");shown="";constructor(e){e.append(this.legend,this.scale,this.factor,this.grid)}list(e,t){this.legend.replaceChildren(...e.map(({colour:n,label:s})=>kt("span",{},ay(n),s))),t&&this.legend.append(this.live),this.legend.hidden=e.length===0&&!t}tell(e){e!==this.shown&&(this.shown=e,this.live.textContent=e)}range(e){if(this.scale.hidden=e===null,e===null)return;let t=ju(e.unit,e.high),n=Math.abs(e.low)<1e-6*Math.abs(e.high)?0:e.low,s=Array.from({length:oy},(l,c)=>e.high+(n-e.high)*c/(oy-1)),r=ay(ry()),o=t.name.replaceAll(" "," "),a=kt("b",{},o?`${e.label} [${o}]`:e.label);this.scale.replaceChildren(a,kt("ol",{},...s.map(l=>kt("li",{},ps(t.factor*l)))),r)}enlarged(e){this.factor.hidden=e==="",this.factor.textContent=e}floor(e){this.grid.hidden=e==="",this.grid.textContent=e}};function eh(i){return kt("div",{className:`scene-note ${i}`,hidden:!0})}function ay(i){let e=kt("i",{ariaHidden:"true"});return e.style.background=i,e}function ly(){let i=document.createElement("canvas").getContext("webgl2");if(i===null)return null;let e=i.getExtension("WEBGL_debug_renderer_info"),t=String(i.getParameter(e?e.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)?"low":"high"}var nh=class{constructor(e,t){this.quality=e;this.extent=t;let n=e==="high";this.renderer=new qu({canvas:this.canvas,antialias:n,alpha:!0,powerPreference:"low-power"}),this.renderer.setPixelRatio(n?Math.min(window.devicePixelRatio,2):.75*Math.min(window.devicePixelRatio,1)),this.renderer.shadowMap.enabled=n,this.renderer.shadowMap.type=Dr,this.camera.up.set(0,0,1),this.camera.near=.01*t.reach,this.camera.far=100*t.reach,this.scene.add(this.floor)}quality;extent;canvas=document.createElement("canvas");scene=new La;camera=new ei(32,1,.01,100);renderer;floor=new Pn;light=new Ja("#ffffff",2.2);dress(e){let{extent:t,light:n}=this;this.undress();let s=t.cell*2*Math.ceil(1.6*t.reach/t.cell),r=new Lr(s,Math.round(s/t.cell),e.gridStrong,e.grid);r.rotation.x=Math.PI/2,r.position.z=t.floor,this.floor.add(r,new $a(e.sky,e.ground,1.6),n,n.target);let o=t.box.getCenter(n.target.position);n.position.set(o.x-.6*t.reach,o.y-1.1*t.reach,o.z+2.2*t.reach),this.quality==="high"&&this.shadows(s)}get floorShown(){return this.floor.children[0]?.visible??!1}set floorShown(e){this.floor.children.forEach(t=>{(t instanceof Lr||t instanceof Bt)&&(t.visible=e)})}resize(e,t){e<1||t<1||(this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix())}draw(){this.renderer.render(this.scene,this.camera)}dispose(){this.undress(),this.light.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss(),this.canvas.remove()}shadows(e){let{light:t,extent:n}=this;t.castShadow=!0,t.shadow.mapSize.set(2048,2048),t.shadow.normalBias=.2*n.usual;let{camera:s}=t.shadow;s.left=s.bottom=-1.4*n.reach,s.right=s.top=1.4*n.reach,s.near=.1*n.reach,s.far=6*n.reach;let r=new Bt(new Pr(e,e),new Ga({opacity:.22,depthWrite:!1}));r.position.z=n.floor,r.receiveShadow=!0,this.floor.add(r)}undress(){for(let e of[...this.floor.children])e instanceof Lr?e.dispose():e instanceof Bt&&(e.geometry.dispose(),e.material.dispose());this.floor.clear()}};var VT=`
.scene { --ink: #1d2329; --soft: #4d5863; --chip: rgba(255, 255, 255, 0.82); --line: #c6ccd3; --field: #ffffff;
  --sky: #f4f7fa; --earth: #e3e8ed; --strong: #005a8f;
  container-type: inline-size; display: flex; flex-direction: column; min-width: 0; min-height: 0; height: 100%; color: var(--ink);
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
.scene-more { position: absolute; z-index: 3; top: calc(100% + 4px); right: 0; display: grid; gap: 4px; padding: 8px 10px;
  background: var(--field); border: 1px solid var(--line); border-radius: 6px; box-shadow: 0 4px 14px rgba(0, 0, 0, 0.2); }
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
.scene-scale ol { list-style: none; margin: 0; padding: 0; display: flex; flex-direction: column; justify-content: space-between;
  height: 110px; text-align: right; font-variant-numeric: tabular-nums; line-height: 1; }
.scene-scale i { border-radius: 2px; }
.scene-factor { bottom: 8px; right: 8px; font-weight: 600; }
.scene-grid { bottom: 8px; left: 8px; color: var(--soft); }
.scene-message { position: absolute; inset: 0; display: grid; place-content: center; padding: 2em; text-align: center; }
@container (max-width: 520px) {
  .scene-bar { gap: 4px 8px; }
  .scene-bar label { gap: 4px; }
  .scene-bar select { max-width: 11.5em; padding: 3px 4px; }
  .scene-bar input[type=range] { width: 64px; }
  .scene-view { min-height: 300px; }
  .scene-note { font-size: 11px; padding: 2px 5px; }
  .scene-legend { max-width: 58%; }
  .scene-legend i { width: 10px; }
  .scene-scale b { max-width: 9em; }
  .scene-scale ol { height: 64px; }
  .scene-scale li:nth-child(even) { display: none; }
  .scene-grid { max-width: 64%; }
}
@media print { .scene-bar { display: none; } }
`,ih=null;function cy(){ih===null&&(ih=new CSSStyleSheet,ih.replaceSync(VT),document.adoptedStyleSheets=[...document.adoptedStyleSheets,ih])}function sh(i,e,t,n){for(let s=0;4*s<i.length&&n>1;s++){let r=3*n*s,o=e[r+3]-e[r],a=e[r+4]-e[r+1],l=e[r+5]-e[r+2],c=t[r+3]-t[r],u=t[r+4]-t[r+1],h=t[r+5]-t[r+2],f=Math.hypot(o,a,l)*Math.hypot(c,u,h);f>0&&GT(i,4*s,a*h-l*u,l*c-o*h,o*u-a*c,f+o*c+a*u+l*h)}}function GT(i,e,t,n,s,r){let o=Math.hypot(t,n,s,r);if(o===0)return;let a=i[e]/o,l=i[e+1]/o,c=i[e+2]/o,u=i[e+3]/o;i[e]=r*a+t*u+n*c-s*l,i[e+1]=r*l-t*c+n*u+s*a,i[e+2]=r*c+t*l-n*a+s*u,i[e+3]=r*u-t*a-n*l-s*c}var dr=class{constructor(e){this.arrays=e;[this.frames,this.links,this.stations]=e.line.shape;let t=this.links*this.stations*3;this.line=new Float32Array(t),this.once=new Float32Array(t),this.planned=new Float32Array(t),this.rigid=e.rigid?new Float32Array(t):null,this.reference=e.reference?new Float32Array(t):null,this.roots=new Float32Array(this.links*4),this.values=new Float32Array(this.links*this.stations),this.tipPlace=this.nearestEnd()}arrays;links;stations;frames;line;rigid;reference;roots;values;tip=new Float32Array(3);tipReference=new Float32Array(3);force=new Float32Array(3);at=new Float32Array(3);frame=0;share=0;tipPlace;once;planned;seek(e,t,n){this.find(e);let{arrays:s}=this;this.mix(this.line,s.line),this.rigid&&s.rigid&&this.mix(this.rigid,s.rigid),this.reference&&s.reference&&this.mix(this.reference,s.reference),this.turn(),this.mix(this.tip,s.tip),s.tipReference&&this.mix(this.tipReference,s.tipReference),s.contact&&(this.mix(this.force,s.contact.force),this.mix(this.at,s.contact.at)),n&&this.mix(this.values,n),!(t===1||!this.rigid)&&(s.referenceRigid&&this.mix(this.planned,s.referenceRigid),this.enlarge(t,this.rigid,s.referenceRigid?this.planned:this.rigid))}path(e,t){let{arrays:n,frames:s}=this,r=e?n.tipReference:n.tip,o=e?n.reference:n.line,a=e&&n.referenceRigid||n.rigid;if(r===null)return null;let l=Float32Array.from(r.data);if(!a||!o||this.links===0)return l;let c=this.links*this.stations*3;for(let u=0;u<s;u++)for(let h=0;h<3;h++){let f=u*c+this.tipPlace+h;l[3*u+h]+=(t-1)*(o.data[f]-a.data[f])}return l}find(e){let t=this.arrays.times.data,n=0,s=this.frames-1;for(;s-n>1;){let o=n+s>>1;t[o]<=e?n=o:s=o}this.frame=n;let r=s>n?t[s]-t[n]:0;this.share=r>0?Math.min(1,Math.max(0,(e-t[n])/r)):0}mix(e,t){let n=e.length,s=this.frame*n,r=Math.min(this.frame+1,this.frames-1)*n,{data:o}=t;for(let a=0;a<n;a++){let l=o[s+a];e[a]=l+this.share*(o[r+a]-l)}}turn(){let{roots:e}=this;this.mix(e,this.arrays.roots);for(let t=0;t<e.length;t+=4){let n=Math.hypot(e[t],e[t+1],e[t+2],e[t+3])||1;for(let s=0;s<4;s++)e[t+s]/=n}}enlarge(e,t,n){let{line:s,reference:r,tipPlace:o}=this;for(let a=0;a<3&&this.links>0;a++){let l=(e-1)*(s[o+a]-t[o+a]);this.tip[a]+=l,this.at[a]+=l,r&&(this.tipReference[a]+=(e-1)*(r[o+a]-n[o+a]))}this.once.set(s);for(let a=0;a<s.length;a++)s[a]=t[a]+e*(s[a]-t[a]),r&&(r[a]=n[a]+e*(r[a]-n[a]));sh(this.roots,this.once,s,this.stations)}nearestEnd(){let{line:e,tip:t}=this.arrays,n=0,s=1/0;for(let r=0;r<this.links;r++){let o=(r*this.stations+this.stations-1)*3,a=Math.hypot(...[0,1,2].map(l=>e.data[o+l]-t.data[l]));a<=s&&([n,s]=[o,a])}return n}};function uy(i,e=Math.PI/3){let t=i.index?i.toNonIndexed():i,n=t.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let x=0;x<s;x++)r[3*x+0]=n.getX(x),r[3*x+1]=n.getY(x),r[3*x+2]=n.getZ(x)}let o=Math.cos(e),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let x=0;x<l;x++){let R=9*x,w=r[R+0],y=r[R+1],E=r[R+2],O=r[R+3],L=r[R+4],I=r[R+5],k=r[R+6],V=r[R+7],D=r[R+8],H=k-O,q=V-L,G=D-I,ae=w-O,$=y-L,K=E-I,ee=q*K-G*$,de=G*ae-H*K,ue=H*$-q*ae,j=1/(Math.sqrt(ee*ee+de*de+ue*ue)||1);c[3*x+0]=ee*j,c[3*x+1]=de*j,c[3*x+2]=ue*j}let u=new Int32Array(s),h=new Float64Array(s*3),f=1;for(;f<s*2;)f<<=1;let d=f-1,m=new Int32Array(f),_=0;for(let x=0;x<s;x++){let R=3*x,w=Math.trunc(r[R+0]*a),y=Math.trunc(r[R+1]*a),E=Math.trunc(r[R+2]*a),O=(Math.imul(w,73856093)^Math.imul(y,19349663)^Math.imul(E,83492791))&d;for(;;){let L=m[O];if(L===0){let k=3*_;h[k+0]=w,h[k+1]=y,h[k+2]=E,m[O]=_+1,u[x]=_++;break}let I=3*(L-1);if(h[I+0]===w&&h[I+1]===y&&h[I+2]===E){u[x]=L-1;break}O=O+1&d}}let g=new Int32Array(_+1);for(let x=0;x<s;x++)g[u[x]+1]++;for(let x=0;x<_;x++)g[x+1]+=g[x];let p=new Int32Array(s),b=g.slice(0,_);for(let x=0;x<l;x++){let R=3*x;p[b[u[R+0]]++]=x,p[b[u[R+1]]++]=x,p[b[u[R+2]]++]=x}let T=new Float32Array(s*3);for(let x=0;x<l;x++){let R=3*x,w=c[R+0],y=c[R+1],E=c[R+2];for(let O=0;O<3;O++){let L=R+O,I=u[L],k=0,V=0,D=0;for(let q=g[I],G=g[I+1];q<G;q++){let ae=3*p[q],$=c[ae+0],K=c[ae+1],ee=c[ae+2];w*$+y*K+E*ee>o&&(k+=$,V+=K,D+=ee)}let H=1/(Math.sqrt(k*k+V*V+D*D)||1);T[3*L+0]=k*H,T[3*L+1]=V*H,T[3*L+2]=D*H}}return t.setAttribute("normal",new tn(T,3,!1)),t}var hy=[[1,1],[-1,1],[-1,-1],[1,-1]];function HT(i){let e=new Float32Array(2*(i+1));for(let t=0;t<=i;t++)e[2*t]=Math.cos(2*Math.PI*t/i),e[2*t+1]=Math.sin(2*Math.PI*t/i);return{points:e,normals:e}}function WT(){let i=[],e=[];return hy.forEach((t,n)=>{let s=hy[(n+1)%4];i.push(...t,...s);for(let r=0;r<2;r++)e.push((t[0]+s[0])/2,(t[1]+s[1])/2)}),{points:Float32Array.from(i),normals:Float32Array.from(e)}}var rh=class{constructor(e,t,n){this.stations=e;this.section=t;this.outline=t.shape==="round"?HT(n):WT(),this.around=this.outline.points.length/2;let s=(e+2)*this.around;[this.position,this.normal,this.colour]=[0,1,2].map(()=>new Float32Array(3*s)),this.colour.fill(1),["position","normal","color"].forEach((r,o)=>{let a=new tn([this.position,this.normal,this.colour][o],3);this.geometry.setAttribute(r,a.setUsage(vd))}),this.geometry.setIndex(this.faces())}stations;section;geometry=new nn;outline;around;position;normal;colour;axes=new Float32Array(9);shape(e,t,n,s){let{stations:r,axes:o}=this;XT(o,n,s);for(let a=0;a<r;a++){let l=t+3*Math.max(a-1,0),c=t+3*Math.min(a+1,r-1);qT(o,e[c]-e[l],e[c+1]-e[l+1],e[c+2]-e[l+2]),this.ring(a,a,e,t+3*a,0),a===0&&this.ring(r,a,e,t,-1),a===r-1&&this.ring(r+1,a,e,t+3*a,1)}this.geometry.attributes.position.needsUpdate=!0,this.geometry.attributes.normal.needsUpdate=!0}paint(e,t,n,s){let{around:r,colour:o,stations:a}=this,l=s>n?s-n:1;for(let c=0;c<a+2;c++){let u=c<a?c:c===a?0:a-1,h=Qu((e[t+u]-n)/l);for(let f=3*c*r;f<3*(c+1)*r;f+=3)o[f]=fr[h],o[f+1]=fr[h+1],o[f+2]=fr[h+2]}this.geometry.attributes.color.needsUpdate=!0}dispose(){this.geometry.dispose()}ring(e,t,n,s,r){let{axes:o,around:a,position:l,normal:c,section:u,outline:h}=this,f=u.sizes[2*t],d=u.sizes[2*t+1];for(let m=0;m<a;m++){let _=f*h.points[2*m],g=d*h.points[2*m+1],p=h.normals[2*m],b=h.normals[2*m+1];for(let T=0;T<3;T++){let x=3*(e*a+m)+T;l[x]=n[s+T]+_*o[3+T]+g*o[6+T],c[x]=r===0?p*o[3+T]+b*o[6+T]:r*o[T]}}}faces(){let{around:e,stations:t}=this,n=[];for(let s=0;s<t-1;s++)for(let r=0;r<e-1;r++){let o=s*e+r;n.push(o,o+e,o+1,o+1,o+e,o+e+1)}for(let s=1;s<e-1;s++){let r=t*e,o=r+e;n.push(r,r+s,r+s+1,o,o+s+1,o+s)}for(let s=0;s<n.length;s+=3)[n[s+1],n[s+2]]=[n[s+2],n[s+1]];return n}};function XT(i,e,t){let n=e[t],s=e[t+1],r=e[t+2],o=e[t+3];i[0]=1-2*(s*s+r*r),i[1]=2*(n*s+r*o),i[2]=2*(n*r-s*o),i[3]=2*(n*s-r*o),i[4]=1-2*(n*n+r*r),i[5]=2*(s*r+n*o),i[6]=2*(n*r+s*o),i[7]=2*(s*r-n*o),i[8]=1-2*(n*n+s*s)}function qT(i,e,t,n){let s=Math.hypot(e,t,n);if(s===0)return;let r=e/s,o=t/s,a=n/s,l=i[1]*a-i[2]*o,c=i[2]*r-i[0]*a,u=i[0]*o-i[1]*r,h=1+i[0]*r+i[1]*o+i[2]*a,f=h>1e-9?1/h:0;for(let d=3;d<9;d+=3){let m=c*i[d+2]-u*i[d+1],_=u*i[d]-l*i[d+2],g=l*i[d+1]-c*i[d];i[d]+=m+f*(c*g-u*_),i[d+1]+=_+f*(u*m-l*g),i[d+2]+=g+f*(l*_-c*m)}i[0]=r,i[1]=o,i[2]=a}var fy=new B(0,1,0),$T=.6,kr=class{constructor(e,t,n,s){this.look=n;this.widths=s;let r=this.material(n.link,!1),o=n.painted==="none"?r:this.material("#ffffff",!0),a=new Set(e.meshes.map(c=>c.link));if(this.sweeps=e.links.map((c,u)=>{if(u>=t.links||!c.bends&&a.has(u))return null;let h=new rh(t.stations,YT(c,t.stations,s),n.fine?24:10);return this.add(new Bt(h.geometry,c.bends||n.painted==="all"?o:r)),h}),e.meshes.filter(({link:c})=>c<t.links).forEach(c=>this.surface(c,e.links)),n.opacity<1)return;e.joints.filter(({link:c})=>c<t.links).forEach(c=>this.housing(c,e.links[c.link],a.has(c.link))),e.links.slice(0,t.links).forEach((c,u)=>this.holder(c,u,t,a));let l=new za((a.size>0?.5:1.5)*s.usual,24,16);this.payload=this.add(new Bt(this.kept(l),this.material(n.payload,!1)))}look;widths;group=new Pn;sweeps;placed=[];tinted=[];rods=[];pedestals=[];payload=null;trash=[];from=new B;to=new B;quaternion=new Ln;update(e,t,n,s){let{stations:r,roots:o,values:a}=e,l=3*r;this.sweeps.forEach((c,u)=>{c?.shape(t,u*l,o,4*u),this.look.painted!=="none"&&c?.paint(a,u*r,n,s)});for(let{object:c,link:u,turn:h}of this.placed)u<0||(c.position.fromArray(t,u*l),c.quaternion.fromArray(o,4*u),h&&c.quaternion.multiply(h));for(let{material:c,link:u}of this.tinted){let h=Qu((a[(u+1)*r-1]-n)/(s-n||1));c.color.setRGB(fr[h],fr[h+1],fr[h+2])}for(let c of this.rods)this.between(c.object,t,c.place,c.link*l);for(let{object:c,link:u}of this.pedestals)this.stand(c,t,u*l);this.payload?.position.copy(this.from.fromArray(e.tip))}dispose(){this.sweeps.forEach(e=>e?.dispose()),this.trash.forEach(e=>e.dispose()),this.group.removeFromParent()}material(e,t){let{opacity:n,fine:s}=this.look,r={polygonOffset:n<1,polygonOffsetFactor:2,polygonOffsetUnits:2},o={transparent:n<1,opacity:n,depthWrite:n>=1,...r},a={color:e,vertexColors:t,...o};return this.kept(s?new Ha({...a,roughness:.5,metalness:.1}):new Ir(a))}kept(e){return this.trash.push(e),e}add(e){return e.frustumCulled=!1,e.castShadow=e.receiveShadow=this.look.opacity>=1,this.group.add(e),e}housing(e,t,n){if(t===void 0||n||e.kind==="fixed")return;let s=1.5*this.widths.usual,r=e.kind==="revolute"?new hs(s,s,2.2*s,this.look.fine?32:14):new tr(2*s,2.2*s,2*s),o=this.add(new Bt(this.kept(r),this.material(e.elastic?this.look.gear:this.look.joint,!1))),a=new B(...e.axis).normalize();this.placed.push({object:o,link:e.link,turn:new Ln().setFromUnitVectors(fy,a)})}surface(e,t){if(t[e.link]?.bends)return;let n=new nn;n.setAttribute("position",new tn(Float32Array.from(e.vertices.data),3)),n.setIndex(new tn(Uint32Array.from(e.faces.data),1));let s=this.kept(uy(n,$T)),r=this.material(this.look.opacity<1?this.look.link:e.colour,!1);this.placed.push({object:this.add(new Bt(s,r)),link:e.link,turn:null}),this.look.painted==="all"&&e.link>=0&&this.tinted.push({material:r,link:e.link})}holder(e,t,n,s){let{arrays:r,stations:o}=n,a=3*o*t;if(e.parent<0){if(s.has(-1)||s.has(t))return;let f=new hs(1.8*this.widths.usual,3*this.widths.usual,1,32);this.pedestals.push({object:this.add(new Bt(this.kept(f),this.material(this.look.base,!1))),link:t});return}let l=0,c=1/0;for(let f=0;f<o;f++){let d=3*(o*e.parent+f),m=Math.hypot(...[0,1,2].map(_=>r.line.data[d+_]-r.line.data[a+_]));m<c&&([l,c]=[d,m])}if(c<.5*this.widths.usual||s.has(t)&&s.has(e.parent))return;let u=new hs(.8*this.widths.usual,.8*this.widths.usual,1,16),h=this.add(new Bt(this.kept(u),this.material(this.look.link,!1)));this.rods.push({object:h,link:t,parent:e.parent,place:l})}between(e,t,n,s){this.from.fromArray(t,n),this.to.fromArray(t,s).sub(this.from);let r=this.to.length();e.position.copy(this.from).addScaledVector(this.to,.5),e.scale.set(1,Math.max(r,1e-9),1),r>0&&e.quaternion.copy(this.quaternion.setFromUnitVectors(fy,this.to.divideScalar(r)))}stand(e,t,n){let s=Math.max(t[n+2]-this.widths.floor,1e-4);e.position.set(t[n],t[n+1],this.widths.floor+s/2),e.scale.set(1,s,1),e.rotation.set(Math.PI/2,0,0)}};function YT(i,e,t){let n=new Float32Array(2*e).fill(t.usual);if(i.section===null)return{shape:"round",sizes:n};let s=i.section.sizes,r=s.shape[0]-1;for(let o=0;o<e;o++)for(let a=0;a<2;a++){let l=Math.round(o/Math.max(e-1,1)*r);n[2*o+a]=Math.max(s.data[2*l+a],t.least)}return{shape:i.section.shape,sizes:n}}var dy=1.6,oh=class{constructor(e,t,n,s){this.mode=e;let[r,o]=e.rest.shape,a={data:e.rest.data,shape:[1,r,o,3]},l={data:t.roots.data.slice(0,4*r),shape:[1,r,4]},c=e.rest.data.slice(3*(r*o-1),3*r*o);this.motion=new dr({times:{data:Float64Array.of(0),shape:[1]},line:a,rigid:a,reference:null,roots:l,tip:{data:c,shape:[1,3]},tipReference:null,colours:[],contact:null}),this.motion.seek(0,1,null),this.roots=this.motion.roots.slice(),this.size=n*s.extent.reach;let{colours:u,extent:h,fine:f}=s,d={link:u.link,joint:u.joint,gear:u.gear,base:u.base,payload:u.payload,opacity:1,painted:"all",fine:f};this.robot=new kr(t,this.motion,d,h),this.rest=new kr(t,this.motion,{...d,link:u.rigid,opacity:.35,painted:"none"},{...h,usual:.8*h.usual}),this.group.add(this.robot.group,this.rest.group),this.rest.update(this.motion,this.motion.line,0,1)}mode;group=new Pn;motion;robot;rest;size;roots;swing(e){let{mode:t,motion:n,size:s}=this,r=s*Math.cos(e),o=s*Math.sin(e),{line:a,values:l}=n;for(let c=0;c<l.length;c++){let u=0;for(let h=3*c;h<3*c+3;h++){let f=r*t.real.data[h]-o*t.imaginary.data[h];a[h]=t.rest.data[h]+f,u+=f*f}l[c]=Math.sqrt(u)/s}for(let c=0;c<3;c++)n.tip[c]=a[a.length-3+c];n.roots.set(this.roots),sh(n.roots,t.rest.data,a,n.stations),this.robot.update(n,a,0,1)}dispose(){this.robot.dispose(),this.rest.dispose(),this.group.removeFromParent()}};var py=new On,ah=new B,qo=class extends Ka{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Ot(e,3)),this.setAttribute("uv",new Ot(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new rr(t,6,1);return this.setAttribute("instanceStart",new Ci(n,3,0)),this.setAttribute("instanceEnd",new Ci(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new rr(t,6,1);return this.setAttribute("instanceColorStart",new Ci(n,3,0)),this.setAttribute("instanceColorEnd",new Ci(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new Va(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new On);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),py.setFromBufferAttribute(t),this.boundingBox.union(py))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Xi),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)ah.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(ah)),ah.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(ah));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Pe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ze},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ii.line={uniforms:ll.merge([Pe.common,Pe.fog,Pe.line]),vertexShader:`
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
		`};var pr=class extends Pi{constructor(e){super({type:"LineMaterial",uniforms:ll.clone(ii.line.uniforms),vertexShader:ii.line.vertexShader,fragmentShader:ii.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Wd=new Tt,my=new B,gy=new B,Bn=new Tt,kn=new Tt,ms=new Tt,Xd=new B,qd=new Ut,zn=new ja,_y=new B,lh=new On,ch=new Xi,gs=new Tt,_s,zr;function yy(i,e,t){return gs.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),gs.multiplyScalar(1/gs.w),gs.x=zr/t.width,gs.y=zr/t.height,gs.applyMatrix4(i.projectionMatrixInverse),gs.multiplyScalar(1/gs.w),Math.abs(Math.max(gs.x,gs.y))}function ZT(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){zn.start.fromBufferAttribute(s,a),zn.end.fromBufferAttribute(r,a),zn.applyMatrix4(t);let c=new B,u=new B;_s.distanceSqToSegment(zn.start,zn.end,u,c),u.distanceTo(c)<zr*.5&&e.push({point:u,pointOnLine:c,distance:_s.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function JT(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;_s.at(1,ms),ms.w=1,ms.applyMatrix4(e.matrixWorldInverse),ms.applyMatrix4(n),ms.multiplyScalar(1/ms.w),ms.x*=r.x/2,ms.y*=r.y/2,ms.z=0,Xd.copy(ms),qd.multiplyMatrices(e.matrixWorldInverse,o);for(let f=0,d=u;f<d;f++){if(Bn.fromBufferAttribute(l,f),kn.fromBufferAttribute(c,f),Bn.w=1,kn.w=1,Bn.applyMatrix4(qd),kn.applyMatrix4(qd),Bn.z>h&&kn.z>h)continue;if(Bn.z>h){let T=Bn.z-kn.z,x=(Bn.z-h)/T;Bn.lerp(kn,x)}else if(kn.z>h){let T=kn.z-Bn.z,x=(kn.z-h)/T;kn.lerp(Bn,x)}Bn.applyMatrix4(n),kn.applyMatrix4(n),Bn.multiplyScalar(1/Bn.w),kn.multiplyScalar(1/kn.w),Bn.x*=r.x/2,Bn.y*=r.y/2,kn.x*=r.x/2,kn.y*=r.y/2,zn.start.copy(Bn),zn.start.z=0,zn.end.copy(kn),zn.end.z=0;let _=zn.closestPointToPointParameter(Xd,!0);zn.at(_,_y);let g=Ki.lerp(Bn.z,kn.z,_),p=g>=-1&&g<=1,b=Xd.distanceTo(_y)<zr*.5;if(p&&b){zn.start.fromBufferAttribute(l,f),zn.end.fromBufferAttribute(c,f),zn.start.applyMatrix4(o),zn.end.applyMatrix4(o);let T=new B,x=new B;_s.distanceSqToSegment(zn.start,zn.end,x,T),t.push({point:x,pointOnLine:T,distance:_s.origin.distanceTo(x),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var uh=class extends Bt{constructor(e=new qo,t=new pr({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)my.fromBufferAttribute(t,o),gy.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+my.distanceTo(gy);let r=new rr(s,2,1);return e.setAttribute("instanceDistanceStart",new Ci(r,1,0)),e.setAttribute("instanceDistanceEnd",new Ci(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;_s=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;zr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),ch.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=zr*.5;else{let h=Math.max(s.near,ch.distanceToPoint(_s.origin));c=yy(s,h,l.resolution)}if(ch.radius+=c,_s.intersectsSphere(ch)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),lh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=zr*.5;else{let h=Math.max(s.near,lh.distanceToPoint(_s.origin));u=yy(s,h,l.resolution)}lh.expandByScalar(u),_s.intersectsBox(lh)!==!1&&(n?ZT(this,t):JT(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Wd),this.material.uniforms.resolution.value.set(Wd.z,Wd.w))}};var Vr=class extends qo{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setPositions(n),this}setColors(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setColors(n),this}setFromPoints(e){let t=e.length-1,n=new Float32Array(6*t);for(let s=0;s<t;s++)n[6*s]=e[s].x,n[6*s+1]=e[s].y,n[6*s+2]=e[s].z||0,n[6*s+3]=e[s+1].x,n[6*s+4]=e[s+1].y,n[6*s+5]=e[s+1].z||0;return super.setPositions(n),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var hh=class extends uh{constructor(e=new Vr,t=new pr({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};var vy=new B(0,1,0),fh=class{group=new Pn;past;rest;length=0;constructor(e,t,n){this.past=new hh(new Vr,new pr({color:t,linewidth:2.5}));let s=new Wa({color:t,transparent:!0,opacity:.7,dashSize:n,gapSize:n});this.rest=new Bo(new nn,s),this.past.frustumCulled=this.rest.frustumCulled=!1,this.group.add(this.past,this.rest),this.lay(e)}lay(e){this.length=e.length/3,this.rest.geometry.dispose(),this.past.geometry.dispose(),this.past.geometry=new Vr;let t=new Float32Array(this.length);for(let n=1;n<t.length;n++)t[n]=t[n-1]+Math.hypot(e[3*n]-e[3*n-3],e[3*n+1]-e[3*n-2],e[3*n+2]-e[3*n-1]);this.rest.geometry.setAttribute("position",new tn(e,3)),this.rest.geometry.setAttribute("lineDistance",new tn(t,1)),this.past.visible=this.length>1,this.past.visible&&this.past.geometry.setPositions(e)}seek(e){this.past.geometry.instanceCount=Math.min(e,this.length-1),this.rest.geometry.setDrawRange(e,this.length-e)}dispose(){[this.past.geometry,this.past.material,this.rest.geometry,this.rest.material].forEach(e=>e.dispose()),this.group.removeFromParent()}},dh=class{constructor(e,t,n){this.wide=t;this.scale=n;let s=new Uo({color:e}),r=new hs(t,t,1,12).translate(0,.5,0),o=new ka(2.6*t,6*t,16).translate(0,-3*t,0);[this.shaft,this.head]=[new Bt(r,s),new Bt(o,s)],this.parts=[s,r,o],this.group.add(this.shaft,this.head)}wide;scale;group=new Pn;shaft;head;parts;way=new B;turn=new Ln;point(e,t){let n=this.way.fromArray(e).length(),s=n*this.scale;this.group.visible=s>.5*this.wide,this.group.visible&&(this.group.position.fromArray(t),this.group.quaternion.copy(this.turn.setFromUnitVectors(vy,this.way.divideScalar(n))),this.shaft.scale.set(1,Math.max(s-5*this.wide,1e-6),1),this.head.position.y=s)}dispose(){this.parts.forEach(e=>e.dispose()),this.group.removeFromParent()}};function by(i,e,t,n){let s=new Ir({color:n,transparent:!0,opacity:.28,side:Ii,depthWrite:!1});return new Bt(KT(i,e,t),s)}function KT(i,e,t){let n=[];for(let u=0;u+2<e.length;u+=3)n.push(new B(e[u],e[u+1],e[u+2]));let[s,r,o]=jT(i,n,t),a=n.map(r),[l,c]=[0,1].map(u=>{let h=a.map(f=>f[u]);return[h.reduce((f,d)=>Math.min(f,d),1/0)-o[u],h.reduce((f,d)=>Math.max(f,d),-1/0)+o[u]]});return QT(s,l,c)}function jT(i,e,t){if(i.kind==="plane"){let f=new B(...i.position),[d,m]=xy(new B(...i.normal).normalize());return[(g,p)=>f.clone().addScaledVector(d,g).addScaledVector(m,p),g=>[g.clone().sub(f).dot(d),g.clone().sub(f).dot(m)],[3*t,3*t]]}let n=new B(...i.center),s=i.kind==="cylinder"?new B(...i.axis).normalize():new B(0,0,1),r=e.reduce((f,d)=>f.add(d),new B).divideScalar(Math.max(e.length,1)).sub(n),o=r.addScaledVector(s,-r.dot(s));o.length()<1e-6*i.radius&&o.copy(xy(s)[0]),o.normalize();let a=new B().crossVectors(s,o),{radius:l}=i,c=i.kind==="ball";return[(f,d)=>{let m=c?l*Math.cos(d):l;return n.clone().addScaledVector(o,m*Math.cos(f)).addScaledVector(a,m*Math.sin(f)).addScaledVector(s,c?l*Math.sin(d):d)},f=>{let d=f.clone().sub(n),m=d.dot(s);return[Math.atan2(d.dot(a),d.dot(o)),c?Math.asin(Math.max(-1,Math.min(1,m/(d.length()||1)))):m]},[t/l,c?t/l:t]]}function xy(i){let e=new B().crossVectors(Math.abs(i.z)<.9?new B(0,0,1):vy,i).normalize();return[e,new B().crossVectors(i,e)]}function QT(i,e,t,n=24){let s=[],r=[];for(let a=0;a<=n;a++)for(let l=0;l<=n;l++){s.push(...i(e[0]+(e[1]-e[0])*a/n,t[0]+(t[1]-t[0])*l/n).toArray());let c=a*(n+1)+l;a<n&&l<n&&r.push(c,c+1,c+n+1,c+1,c+n+2,c+n+1)}let o=new nn;return o.setAttribute("position",new tn(Float32Array.from(s),3)),o.setIndex(r),o.computeVertexNormals(),o}var ph=class{constructor(e,t,n,s){this.run=e;this.index=t;this.alone=n;this.shared=s;this.motion=new dr(e.scene)}run;index;alone;shared;group=new Pn;motion;showsSurface=!0;before=null;robot;ghosts=[];traces=[];arrow=null;surface=null;built="";traced="";get colour(){return this.alone?this.shared.colours.real:Hd[this.index%Hd.length]}get referenceColour(){return this.alone?this.shared.colours.reference:this.shared.colours.rigid}get changed(){return this.before!==null}replace(e){let{scene:t}=this.run,n=this.motion.arrays.line.shape,s=new dr(e??t);(String(s.arrays.line.shape.slice(1))!==String(n.slice(1))||e!==null!==this.changed)&&(this.built=""),this.before=e===null?null:this.before??new dr(t),this.motion=s,this.traced=""}update(e,t,n){let{motion:s}=this;this.build(t);let r=s.arrays.colours.find(({id:o})=>o===t.colour)?.values??null;s.seek(e,t.factor,r),this.robot.update(s,s.line,n.low,n.high),this.before?.seek(e,t.factor,null);for(let{view:o,of:a}of this.ghosts){let l=a==="before"?this.before?.line:s[a];o.group.visible=a==="before"?l!==void 0:t[a]&&l!==null,o.group.visible&&l&&o.update(a==="before"&&this.before?this.before:s,l,0,1)}this.draw(t)}widen(e,t){let{arrays:n,links:s,stations:r}=this.motion,o=n.colours.find(l=>l.id===e)?.values.data,a=this.run.scene.links.map(l=>l.bends||Sy(e)==="all");if(o!==void 0)for(let l=0;l<o.length;l++)a[Math.floor(l/r)%s]&&(o[l]<t.low&&(t.low=o[l]),o[l]>t.high&&(t.high=o[l]))}dispose(){this.clear(),this.group.removeFromParent()}build(e){let t=Sy(e.colour);if(t===this.built)return;this.clear(),this.built=t;let{scene:n}=this.run,{extent:s,colours:r,fine:o}=this.shared,a=t==="none"?this.colour:r.link,l=this.alone?r.joint:this.colour,c={link:a,joint:l,gear:this.alone?r.gear:l,base:r.base,payload:l,opacity:1,painted:t,fine:o};this.robot=this.added(n,this.motion,c,1);let u={reference:this.referenceColour,rigid:r.rigid,before:r.before};for(let h of["reference","rigid","before"]){if(h==="before"?!this.before:!n[h])continue;let f={...c,link:u[h],opacity:.42,painted:"none"};this.ghosts.push({view:this.added(n,h==="before"&&this.before?this.before:this.motion,f,.85),of:h})}n.contact&&(this.arrow=new dh(r.force,.006*s.reach,this.shared.scale),this.surface=by(n.contact.surface,n.contact.at.data,.12*s.reach,r.surface),this.group.add(this.arrow.group,this.surface))}added(e,t,n,s){let{extent:r}=this.shared,o={usual:s*r.usual,least:s*r.least,floor:r.floor},a=new kr(s<1?eR(e,s):e,t,n,o);return this.group.add(a.group),a}draw(e){this.trace(e);for(let{trace:t,reference:n}of this.traces)t.group.visible=e.traces&&(!n||this.motion.arrays.tipReference!==null),t.seek(this.motion.frame);this.surface&&(this.surface.visible=e.surface&&this.showsSurface),this.arrow&&(this.arrow.point(this.motion.force,this.motion.at),this.arrow.group.visible&&=e.force&&this.motion.arrays.contact!==null)}trace(e){let t=`${e.factor}`;if(t===this.traced)return;let n=this.traces.length===0;this.traced=t;for(let s of[!1,!0]){let r=this.motion.path(s,e.factor),o=this.traces.find(a=>a.reference===s);if(r!==null){if(o)o.trace.lay(r);else if(n){let a=s?this.referenceColour:this.colour,l=new fh(r,a,.012*this.shared.extent.reach);this.traces.push({trace:l,reference:s}),this.group.add(l.group)}}}}clear(){this.robot?.dispose(),this.ghosts.forEach(({view:e})=>e.dispose()),this.traces.forEach(({trace:e})=>e.dispose()),this.arrow?.dispose(),this.surface&&(this.surface.geometry.dispose(),this.surface.material.dispose(),this.surface.removeFromParent()),this.ghosts=[],this.traces=[],this.traced=this.built=""}};function Sy(i){return i==="run"?"none":i==="displacement"?"all":"bending"}function eR(i,e){let t=i.links.map(n=>{if(n.section===null)return n;let{data:s,shape:r}=n.section.sizes;return{...n,section:{...n.section,sizes:{data:Float32Array.from(s,o=>e*o),shape:r}}}});return{...i,links:t}}var tR=10;function My(i,e){let t=0;for(let{scene:n}of i){let s=n.contact?.force.data??[];for(let r=0;r+2<s.length;r+=3)t=Math.max(t,Math.hypot(s[r],s[r+1],s[r+2]))}return i.every(({scene:n})=>n.contact===null)?0:dl(.35*e/(t||tR))}var mh=class{constructor(e,t,n,s,r,o){this.extent=t;this.settings=r;this.colours=iy(s),this.stage=new nh(n,t),this.stage.dress(this.colours),this.shared={extent:t,colours:this.colours,fine:n==="high",scale:My(e.runs,t.reach)},this.runs=e.runs.map((l,c)=>new ph(l,c,e.runs.length===1,this.shared)),this.runs.forEach(({group:l})=>this.stage.scene.add(l)),this.cameras=new Ku(this.stage.camera,this.canvas,t.reach,o),this.canvas.tabIndex=0,this.canvas.setAttribute("role","img");let a="Arrow keys turn the view, with Shift they move it, + and - zoom.";this.canvas.setAttribute("aria-label",`The robot in space: ${e.runs.map(({name:l})=>l).join(", ")}. ${a}`),this.canvas.title=`Drag to turn, right button to move, click and wheel to zoom. ${a}`,this.refresh()}extent;settings;stage;cameras;colours;runs;shared;range={low:0,high:1};mode=null;shown=null;get canvas(){return this.stage.canvas}draw(e,t){this.mode?this.mode.swing(2*Math.PI*t/dy):this.runs.forEach(n=>n.update(e,this.settings,this.range)),this.mode||this.cameras.follow(this.runs[0].motion.tip),this.stage.draw()}replace(e,t){this.runs[e]?.replace(t)}showMode(e,t){this.mode?.dispose(),this.mode=e&&new oh(e,this.runs[0].run.scene,t,this.shared),this.shown=e,this.mode&&this.stage.scene.add(this.mode.group),this.runs.forEach(({group:n})=>n.visible=e===null)}refresh(){let{settings:e,runs:t}=this,n={low:1/0,high:-1/0};t.forEach(l=>l.widen(e.colour,n)),this.range=n.low<=n.high?n:{low:0,high:0};let{box:s,reach:r}=this.extent,o=e.apart?Math.max(.4*r,s.max.y-s.min.y+.15*r):0,a=t.map(({run:l})=>JSON.stringify(l.scene.contact?.surface));t.forEach((l,c)=>{l.group.position.set(0,(c-(t.length-1)/2)*o,0),l.showsSurface=e.apart||a.indexOf(a[c])===c}),this.cameras.box.copy(s).expandByVector(new B(0,(t.length-1)/2*o,0)),this.stage.floorShown=e.floor}look(e,t){this.cameras.show(e,this.runs[0].motion.tip,t)}takeView(e){this.cameras.take(e.cameras)}resize(e,t){this.stage.resize(e,t)}tell(e){let{settings:t,extent:n,shown:s}=this,r=this.runs.flatMap(({run:a})=>a.scene.colours).find(({id:a})=>a===t.colour);e.list(s?this.modeEntries(s):this.entries(),!s&&this.forceShown()),s?e.range({label:"Displacement, share of the largest",unit:"",low:0,high:1}):e.range(r?{label:r.label,unit:r.unit,...this.range}:null),e.enlarged(t.factor===1||s?"":`Deformation × ${t.factor}`);let o=n.floor===0?"":`, at z = ${ps(n.floor)} m`;e.floor(t.floor?`Grid ${ps(n.cell)} m${o}${this.thick()}`:"")}words(){if(!this.forceShown())return"";let e=n=>ps(Math.hypot(...n));return`Contact force ${this.runs.filter(({run:n})=>n.scene.contact).map(({motion:n})=>`${e(n.force)} N`).join(", ")} (arrow: ${ps(.1/this.shared.scale)} N per 0.1 m)`}dispose(){this.mode?.dispose(),this.runs.forEach(e=>e.dispose()),this.cameras.dispose(),this.stage.dispose()}forceShown(){return this.settings.force&&this.shared.scale>0}entries(){let{settings:e,runs:t,colours:n}=this,s=t.length===1,r=[];s?e.traces&&r.push({colour:n.real,label:"Path of the tip"}):r.push(...t.map(a=>({colour:a.colour,label:a.run.name})));let o=a=>e[a]&&t.some(({run:l})=>l.scene[a]);return o("reference")?r.push({colour:t[0].referenceColour,label:"Reference"}):e.traces&&t.some(({run:a})=>a.scene.tipReference)&&r.push({colour:t[0].referenceColour,label:"Path of the reference"}),o("rigid")&&r.push({colour:n.rigid,label:"Without any elasticity"}),t.some(({changed:a})=>a)&&r.push({colour:n.before,label:"The run as it was"}),r}modeEntries(e){let t=`damping ${ps(100*e.damping)} %`,n=`Mode ${ps(e.frequency)} Hz, ${t}, ${e.livesIn}; motors ${e.case}; slowed, not to scale`;return[{colour:this.colours.rigid,label:"At rest"},{colour:"transparent",label:n}]}thick(){let e=this.runs.flatMap(({run:s})=>s.scene.links.map(({section:r})=>r)),t=e.some(s=>s&&Math.min(...s.sizes.data)<this.extent.least),n=ju("m",2*this.extent.least);return t?`; links are drawn at least ${ps(2*this.extent.least*n.factor)} ${n.name} thick`:e.some(s=>s?.guessed)?"; thickness of links by their stiffness and mass":""}};var nR="This browser draws nothing in 3D (WebGL is missing or switched off), so the robot is not shown here. All curves and numbers of the page are complete without it.";function wy(i,e,t){cy();let n=kt("div",{className:"scene"}),s=kt("div",{className:"scene-view"});i.append(n);let r=e.runs.length>0?ly():null;return r===null?(n.append(s),s.append(kt("p",{className:"scene-message",role:"note"},nR)),{replace:()=>{},showMode:()=>{},resize:()=>{},dispose:()=>n.remove()}):new $d(n,s,e,t,r)}var $d=class{constructor(e,t,n,s,r){this.frame=e;this.view=t;this.page=n;this.clock=s;this.best=r;let{runs:o}=n,a=o.length>1;this.settings={colour:a?"run":o[0].scene.colours[0]?.id??"run",factor:1,reference:!a,rigid:!1,traces:!0,force:!0,surface:!0,floor:!0,apart:!1,quality:"auto"},this.replaced=o.map(()=>null),this.extent=ny(n),this.notes=new th(t),e.append(this.controls(),t),this.world=this.made(),this.ends.push(s.subscribe(this.ask));let l=new ResizeObserver(()=>this.resize());l.observe(t),this.dark.addEventListener("change",this.remake),this.ends.push(()=>l.disconnect(),()=>this.dark.removeEventListener("change",this.remake)),this.resize(),this.refresh(),this.world.look("iso",!1)}frame;view;page;clock;best;settings;notes;replaced;ends=[];dark=window.matchMedia("(prefers-color-scheme: dark)");still=window.matchMedia("(prefers-reduced-motion: reduce)");extent;world;mode=null;asked=0;replace(e,t){this.replaced[e]=t,this.world.replace(e,t),this.refresh()}showMode(e,t){this.mode=e===null?null:{mode:e,amplitude:t},this.world.showMode(e,t),this.refresh()}resize(){this.world.resize(this.view.clientWidth,this.view.clientHeight),this.ask()}dispose(){cancelAnimationFrame(this.asked),this.ends.forEach(e=>e()),this.world.dispose(),this.frame.remove()}controls(){let{runs:e}=this.page,n=[...new Map(e.flatMap(({scene:a})=>a.colours.map(({id:l,label:c})=>[l,c]))),["run",e.length>1?"each robot its own":"none"]],s=a=>e.some(({scene:l})=>a(l)),o=[["reference",s(a=>a.reference)],["rigid",s(a=>a.rigid)],["traces",!0],["force",s(a=>a.contact)],["surface",s(a=>a.contact)],["floor",!0],["apart",e.length>1]].filter(([,a])=>a).map(([a])=>a);return ty(this.settings,n,o,s(a=>a.rigid),{changed:()=>this.refresh(),look:a=>this.world.look(a,!this.still.matches),quality:this.remake})}made(){let{quality:e}=this.settings,t=new mh(this.page,this.extent,e==="auto"?this.best:e,this.dark.matches,this.settings,this.ask);return this.view.prepend(t.canvas),t}remake=()=>{let e=this.world;this.world=this.made(),this.world.takeView(e),e.dispose(),this.replaced.forEach((t,n)=>t&&this.world.replace(n,t)),this.mode&&this.world.showMode(this.mode.mode,this.mode.amplitude),this.resize(),this.refresh()};refresh(){this.world.refresh(),this.world.tell(this.notes),this.ask()}ask=()=>{this.asked===0&&(this.asked=requestAnimationFrame(this.draw))};draw=e=>{this.asked=0,this.world.draw(this.clock.time,this.still.matches?0:e/1e3),this.notes.tell(this.world.words()),this.mode&&!this.still.matches&&this.ask()}};function Ey(i,e){let t=Math.max(...e.runs.map(w=>w.duration)),n=gp(t),s=ce("div",{class:"scene"}),r=ce("div",{class:"facts-panel",role:"region",tabindex:"0","aria-label":"Numbers that matter"}),o=ce("div",{class:"sliders-panel",role:"region",tabindex:"0","aria-label":"Settings"}),a=ce("div",{class:"side"},o,r),l=ce("div",{class:"transport",role:"group","aria-label":"Time"}),c=ce("section",{class:"charts","aria-label":"Charts"}),u=e.runs.length>1?` of ${e.runs[0].name}`:"",h=Ay(`Elastic line${u}`,e.runs[0].line!==null),f=Ay(`Modes of vibration${u}`,e.runs[0].modes.length>0),d=ce("p",{class:"note",hidden:!0,text:"These are the modes of the run as it was."});f.body.before(d);let m=ce("div",{class:"bar files"});i.classList.add("app"),i.append(ce("div",{class:"stage"},s,a),l,c,ce("div",{class:"lower"},h.element,f.element),m);let _=wy(s,e,n),g=[_,e0(l,n)],p=Xg(r,e),b=hg(c,e,n),T=e.runs[0].line?Yg(h.body,e,n):null,x=e.runs[0].modes.length?_f(f.body,e,_,n):null;Jg(m,e),l.hidden=c.hidden=e.runs.every(w=>w.charts.length===0);function R(w){n.setDuration(Math.max(w?w.times[w.times.length-1]:0,t)),_.replace(0,w?w.scene:null),b.show(w),T?.show(w),p.show(w),d.hidden=w===null}return e.live?g.push(jg(o,e.live,{open:Wg,show:R,fileName:`${yf(e.runs[0].name)}_changed`})):e.notLive&&o.append(ce("p",{class:"note",text:`Nothing can be changed in this page: ${e.notLive}.`})),{clock:n,side:o,scene:_,show:R,showModes(w){x?.dispose(),f.body.replaceChildren(),d.hidden=!0,f.element.hidden=w.length===0;let[y,...E]=e.runs;x=w.length?_f(f.body,{...e,runs:[{...y,modes:w},...E]},_,n):null},dispose(){n.pause(),x?.dispose(),[...g,b,...T?[T]:[]].forEach(w=>w.dispose()),i.replaceChildren()}}}function Ay(i,e){let t=ce("div",{});return{element:ce("section",{class:"panel",hidden:!e,"aria-label":i},ce("h3",{text:i}),t),body:t}}async function iR(){let i=document.getElementById("tmodes-data"),e=document.getElementById("tmodes-app");if(!(i===null||e===null))try{let t=pp(await mp(i.textContent??""));Ey(e,t),document.documentElement.classList.add("running")}catch(t){let n=t instanceof Error?t.message:String(t);e.replaceChildren(ce("p",{class:"status warning",role:"alert",text:`The interactive part of this page could not start: ${n}. What follows is the whole report without it.`}))}}addEventListener("beforeprint",()=>document.querySelectorAll("details").forEach(i=>{i.open=!0}));iR();})();
