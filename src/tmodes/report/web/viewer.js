/* tmodes, built from d478a7c45873f417; BSD-3-Clause */
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
"use strict";(()=>{function rt(i,t={},...e){let n=document.createElement(i);for(let[r,s]of Object.entries(t))r==="text"?n.textContent=String(s):s!==void 0&&s!==!1&&n.setAttribute(r,s===!0?"":s);return n.append(...e.filter(r=>r!==null)),n}function Be(i,t,e={}){let n=rt("button",{type:"button",text:i,...e});return n.addEventListener("click",t),n}function ze(i,t){i.textContent!==t&&(i.textContent=t)}function Jl(i,t,e=2){let n="http://www.w3.org/2000/svg",r=document.createElementNS(n,"svg"),s=document.createElementNS(n,"line"),o={x1:0,y1:5,x2:26,y2:5,"stroke-width":e,"stroke-dasharray":t.join(" ")};for(let[a,l]of Object.entries(o))s.setAttribute(a,String(l));s.style.stroke=i;for(let[a,l]of Object.entries({width:26,height:10,"aria-hidden":"true"}))r.setAttribute(a,String(l));return r.append(s),r}var Gm=0;function Lr(i){return Gm+=1,`tm-${i}-${Gm}`}function Ql(i,t){i.toBlob(e=>e&&Fr(e,`${t}.png`,"image/png"),"image/png")}function Fr(i,t,e){let n=URL.createObjectURL(new Blob([i],{type:e}));rt("a",{href:n,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}var Hb="TMPK";function Hm(i){if(new TextDecoder().decode(i.subarray(0,4))!==Hb)throw new Error("these bytes are no data of tmodes");let e=new DataView(i.buffer,i.byteOffset,i.byteLength).getUint32(4,!0),n=JSON.parse(new TextDecoder().decode(i.subarray(8,8+e))),r=8*Math.ceil((8+e)/8),s=n.arrays.map(o=>Wb(i,r,o));return tc(n.page,s)}function Wb(i,t,e){let n=e.shape.reduce((o,a)=>o*a,1),r=Number(e.dtype[1]),s=i.slice(t+e.offset,t+e.offset+n*r).buffer;return e.dtype==="f8"?{data:new Float64Array(s),shape:e.shape}:e.dtype==="d4"?{data:$b(new Uint8Array(s),n,e),shape:e.shape}:e.dtype==="i4"?{data:new Int32Array(s),shape:e.shape}:e.dtype==="u1"?{data:new Uint8Array(s),shape:e.shape}:{data:qb(new Uint8Array(s),n,e),shape:e.shape}}function qb(i,t,{shape:e,scale:n=1,start:r=0}){let s=t/(e[0]||1)||1,o=new Int16Array(t);for(let a=0;a<t;a++)o[a]=(i[a]|i[t+a]<<8)+(a>=s?o[a-s]:0);return Float32Array.from(o,a=>r+n*a)}function $b(i,t,{shape:e}){let n=t/(e[0]||1)||1,r=new Uint32Array(t);for(let s=0;s<t;s++){let o=i[s]|i[t+s]<<8|i[2*t+s]<<16|i[3*t+s]<<24;r[s]=o+(s>=n?r[s-n]:0)}return new Float32Array(r.buffer)}function tc(i,t){if(Array.isArray(i))return i.map(n=>tc(n,t));if(i===null||typeof i!="object")return i;let e=Object.entries(i);return e.length===1&&e[0][0]==="$array"?t[e[0][1]]:e.length===1&&e[0][0]==="$sum"?Xb(tc(e[0][1],t)):Object.fromEntries(e.map(([n,r])=>[n,tc(r,t)]))}function Xb([i,t]){return{data:Float32Array.from(i.data,(e,n)=>e+t.data[n]),shape:i.shape}}async function Wm(i){let t=Uint8Array.from(atob(i.trim()),n=>n.charCodeAt(0)),e=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(e).arrayBuffer())}function qm(i){let t=new Set,e=0,n=0,r=()=>t.forEach(l=>l(a)),s={time:0,duration:i,playing:!1},o=l=>{let c=Math.min(.25,Math.max(0,(l-n)/1e3));n=l,s.time+=c*a.speed,s.time>=s.duration&&(s.time=a.loop?0:s.duration,s.playing=a.loop),r(),s.playing&&(e=requestAnimationFrame(o))},a={get time(){return s.time},get duration(){return s.duration},get playing(){return s.playing},speed:1,loop:!0,seek(l){s.time=Math.min(Math.max(l,0),s.duration),r()},play(){s.playing||(s.playing=!0,s.time>=s.duration&&(s.time=0),n=performance.now(),e=requestAnimationFrame(o),r())},pause(){s.playing=!1,cancelAnimationFrame(e),r()},toggle(){s.playing?a.pause():a.play()},setDuration(l){s.duration=l,a.seek(s.time)},subscribe(l){return t.add(l),()=>t.delete(l)}};return a}var jb="uplot",Yb="u-hz",Zb="u-vt",Kb="u-title",Jb="u-wrap",Qb="u-under",tw="u-over",ew="u-axis",Fs="u-off",nw="u-select",iw="u-cursor-x",rw="u-cursor-y",sw="u-cursor-pt",ow="u-legend",aw="u-live",lw="u-inline",cw="u-series",uw="u-marker",$m="u-label",hw="u-value",Ta="width",Ra="height";var Xm="bottom",yo="left",bf="right",kf="#000",jm=kf+"0",wf="mousemove",Ym="mousedown",Mf="mouseup",Zm="mouseenter",Km="mouseleave",Jm="dblclick",fw="resize",dw="scroll",Qm="change",sc="dppxchange",Bf="--",So=typeof window<"u",Rf=So?document:null,vo=So?window:null,pw=So?navigator:null,Te,ec;function Cf(){let i=devicePixelRatio;Te!=i&&(Te=i,ec&&If(Qm,ec,Cf),ec=matchMedia(`(min-resolution: ${Te-.001}dppx) and (max-resolution: ${Te+.001}dppx)`),Ns(Qm,ec,Cf),vo.dispatchEvent(new CustomEvent(sc)))}function vi(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Pf(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function en(i,t,e){i.style[t]=e+"px"}function $i(i,t,e,n){let r=Rf.createElement(i);return t!=null&&vi(r,t),e?.insertBefore(r,n),r}function Li(i,t){return $i("div",i,t)}var tg=new WeakMap;function pr(i,t,e,n,r){let s="translate("+t+"px,"+e+"px)",o=tg.get(i);s!=o&&(i.style.transform=s,tg.set(i,s),t<0||e<0||t>n||e>r?vi(i,Fs):Pf(i,Fs))}var eg=new WeakMap;function ng(i,t,e){let n=t+e,r=eg.get(i);n!=r&&(eg.set(i,n),i.style.background=t,i.style.borderColor=e)}var ig=new WeakMap;function rg(i,t,e,n){let r=t+""+e,s=ig.get(i);r!=s&&(ig.set(i,r),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var zf={passive:!0},mw={...zf,capture:!0};function Ns(i,t,e,n){t.addEventListener(i,e,n?mw:zf)}function If(i,t,e,n){t.removeEventListener(i,e,zf)}So&&Cf();function Xi(i,t,e,n){let r;e=e||0,n=n||t.length-1;let s=n<=2147483647;for(;n-e>1;)r=s?e+n>>1:_i((e+n)/2),t[r]<i?e=r:n=r;return i-t[e]<=t[n]-i?e:n}function Lg(i){return(e,n,r)=>{let s=-1,o=-1;for(let a=n;a<=r;a++)if(i(e[a])){s=a;break}for(let a=r;a>=n;a--)if(i(e[a])){o=a;break}return[s,o]}}var Fg=i=>i!=null,Ng=i=>i!=null&&i>0,lc=Lg(Fg),gw=Lg(Ng);function yw(i,t,e,n=0,r=!1){let s=r?gw:lc,o=r?Ng:Fg;[t,e]=s(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??We,l??-We]}function cc(i,t,e,n){let r=ag(i),s=ag(t);i==t&&(r==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Nr:Dg,a=r==1?_i:Fi,l=s==1?Fi:_i,c=a(o(Rn(i))),u=l(o(Rn(t))),h=_o(e,c),f=_o(e,u);return e==10&&(c<0&&(h=qe(h,-c)),u<0&&(f=qe(f,-u))),n||e==2?(i=h*r,t=f*s):(i=Bg(i,h),t=uc(t,f)),[i,t]}function Vf(i,t,e,n){let r=cc(i,t,e,n);return i==0&&(r[0]=0),t==0&&(r[1]=0),r}var Gf=.1,sg={mode:3,pad:Gf},Pa={pad:0,soft:null,mode:0},xw={min:Pa,max:Pa};function oc(i,t,e,n){return hc(e)?og(i,t,e):(Pa.pad=e,Pa.soft=n?0:null,Pa.mode=n?3:0,og(i,t,xw))}function Se(i,t){return i??t}function vw(i,t,e){for(t=Se(t,0),e=Se(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function og(i,t,e){let n=e.min,r=e.max,s=Se(n.pad,0),o=Se(r.pad,0),a=Se(n.hard,-We),l=Se(r.hard,We),c=Se(n.soft,We),u=Se(r.soft,-We),h=Se(n.mode,0),f=Se(r.mode,0),d=t-i,m=Nr(d),y=ii(Rn(i),Rn(t)),g=Nr(y),p=Rn(g-m);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,h==2&&c!=We&&(s=0),f==2&&u!=-We&&(o=0)));let x=d||y||1e3,b=Nr(x),v=_o(10,_i(b)),S=x*(d==0?i==0?.1:1:s),A=qe(Bg(i-S,v/10),24),_=i>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:We,w=ii(a,A<_&&i>=_?_:ji(_,A)),N=x*(d==0?t==0?.1:1:o),P=qe(uc(t+N,v/10),24),I=t<=u&&(f==1||f==3&&P>=u||f==2&&P<=u)?u:-We,U=ji(l,P>I&&t<=I?I:ii(I,P));return w==U&&w==0&&(U=100),[w,U]}var _w=new Intl.NumberFormat(So?pw.language:"en-US"),Hf=i=>_w.format(i),bi=Math,rc=bi.PI,Rn=bi.abs,_i=bi.floor,Tn=bi.round,Fi=bi.ceil,ji=bi.min,ii=bi.max,_o=bi.pow,ag=bi.sign,Nr=bi.log10,Dg=bi.log2,bw=(i,t=1)=>bi.sinh(i)*t,Sf=(i,t=1)=>bi.asinh(i/t),We=1/0;function lg(i){return(Nr((i^i>>31)-(i>>31))|0)+1}function Lf(i,t,e){return ji(ii(i,t),e)}function Og(i){return typeof i=="function"}function _e(i){return Og(i)?i:()=>i}var ww=()=>{},Ug=i=>i,kg=(i,t)=>t,Mw=i=>null,cg=i=>!0,ug=(i,t)=>i==t,Sw=/\.\d*?(?=9{6,}|0{6,})/gm,Ds=i=>{if(Vg(i)||es.has(i))return i;let t=`${i}`,e=t.match(Sw);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[r,s]=t.split("e");return+`${Ds(r)}e${s}`}return qe(i,n)};function Is(i,t){return Ds(qe(Ds(i/t))*t)}function uc(i,t){return Ds(Fi(Ds(i/t))*t)}function Bg(i,t){return Ds(_i(Ds(i/t))*t)}function qe(i,t=0){if(Vg(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Tn(n)/e}var es=new Map;function zg(i){return((""+i).split(".")[1]||"").length}function La(i,t,e,n){let r=[],s=n.map(zg);for(let o=t;o<e;o++){let a=Rn(o),l=qe(_o(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=i==10?u:qe(u,h);r.push(f),es.set(f,h)}}return r}var Ia={},Wf=[],bo=[null,null],ts=Array.isArray,Vg=Number.isInteger,Aw=i=>i===void 0;function hg(i){return typeof i=="string"}function hc(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Ew(i){return i!=null&&typeof i=="object"}var Tw=Object.getPrototypeOf(Uint8Array),Gg="__proto__";function wo(i,t=hc){let e;if(ts(i)){let n=i.find(r=>r!=null);if(ts(n)||t(n)){e=Array(i.length);for(let r=0;r<i.length;r++)e[r]=wo(i[r],t)}else e=i.slice()}else if(i instanceof Tw)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Gg&&(e[n]=wo(i[n],t))}else e=i;return e}function Mn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let r in n)r!=Gg&&(hc(i[r])?Mn(i[r],wo(n[r])):i[r]=wo(n[r]))}return i}var Rw=0,Cw=1,Pw=2;function Iw(i,t,e){for(let n=0,r,s=-1;n<t.length;n++){let o=t[n];if(o>s){for(r=o-1;r>=0&&i[r]==null;)i[r--]=null;for(r=o+1;r<e&&i[r]==null;)i[s=r++]=null}}}function Lw(i,t){if(Dw(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Ow(o[0])||(o=Nw(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],r=n[0].length,s=new Map;for(let o=0;o<r;o++)s.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(r).fill(void 0),f=t?t[o][c]:Cw,d=[];for(let m=0;m<u.length;m++){let y=u[m],g=s.get(l[m]);y===null?f!=Rw&&(h[g]=y,f==Pw&&d.push(g)):h[g]=y}Iw(h,d,r),n.push(h)}}return n}var Fw=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Nw(i){let t=i[0],e=t.length,n=Array(e);for(let s=0;s<n.length;s++)n[s]=s;n.sort((s,o)=>t[s]-t[o]);let r=[];for(let s=0;s<i.length;s++){let o=i[s],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];r.push(a)}return r}function Dw(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let r=i[n][0];if(r.length!=e)return!1;if(r!=t){for(let s=0;s<e;s++)if(r[s]!=t[s])return!1}}return!0}function Ow(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,r=e-1;for(;n<=r&&i[n]==null;)n++;for(;r>=n&&i[r]==null;)r--;if(r<=n)return!0;let s=ii(1,_i((r-n+1)/t));for(let o=i[n],a=n+s;a<=r;a+=s){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Hg=["January","February","March","April","May","June","July","August","September","October","November","December"],Wg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function qg(i){return i.slice(0,3)}var Uw=Wg.map(qg),kw=Hg.map(qg),Bw={MMMM:Hg,MMM:kw,WWWW:Wg,WWW:Uw};function Ea(i){return(i<10?"0":"")+i}function zw(i){return(i<10?"00":i<100?"0":"")+i}var Vw={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Ea(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ea(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Ea(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ea(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ea(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>zw(i.getMilliseconds())};function qf(i,t){t=t||Bw;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=n.exec(i);)e.push(r[0][0]=="{"?Vw[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](s,t);return o}}var Gw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Hw(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Gw?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var $g=i=>i%1==0,ac=[1,2,2.5,5],Ww=La(10,-32,0,ac),Xg=La(10,0,32,ac),qw=Xg.filter($g),Ls=Ww.concat(Xg),$f=`
`,jg="{YYYY}",fg=$f+jg,Yg="{M}/{D}",Ca=$f+Yg,nc=Ca+"/{YY}",Zg="{aa}",$w="{h}:{mm}",xo=$w+Zg,dg=$f+xo,pg=":{ss}",Ce=null;function Kg(i){let t=i*1e3,e=t*60,n=e*60,r=n*24,s=r*30,o=r*365,l=(i==1?La(10,0,3,ac).filter($g):La(10,-3,0,ac)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,jg,Ce,Ce,Ce,Ce,Ce,Ce,1],[r*28,"{MMM}",fg,Ce,Ce,Ce,Ce,Ce,1],[r,Yg,fg,Ce,Ce,Ce,Ce,Ce,1],[n,"{h}"+Zg,nc,Ce,Ca,Ce,Ce,Ce,1],[e,xo,nc,Ce,Ca,Ce,Ce,Ce,1],[t,pg,nc+" "+xo,Ce,Ca+" "+xo,Ce,dg,Ce,1],[i,pg+".{fff}",nc+" "+xo,Ce,Ca+" "+xo,Ce,dg,Ce,1]];function u(h){return(f,d,m,y,g,p)=>{let x=[],b=g>=o,v=g>=s&&g<o,S=h(m),A=qe(S*i,3),_=Af(S.getFullYear(),b?0:S.getMonth(),v||b?1:S.getDate()),w=qe(_*i,3);if(v||b){let N=v?g/s:0,P=b?g/o:0,I=A==w?A:qe(Af(_.getFullYear()+P,_.getMonth()+N,1)*i,3),U=new Date(Tn(I/i)),z=U.getFullYear(),C=U.getMonth();for(let O=0;I<=y;O++){let W=Af(z+P*O,C+N*O,1),G=W-h(qe(W*i,3));I=qe((+W+G)*i,3),I<=y&&x.push(I)}}else{let N=g>=r?r:g,P=_i(m)-_i(A),I=w+P+uc(A-w,N);x.push(I);let U=h(I),z=U.getHours()+U.getMinutes()/e+U.getSeconds()/n,C=g/n,O=f.axes[d]._space,W=p/O;for(;I=qe(I+g,i==1?0:3),!(I>y);)if(C>1){let G=_i(qe(z+C,6))%24,X=h(I).getHours()-G;X>1&&(X=-1),I-=X*n,z=(z+C)%24;let tt=x[x.length-1];qe((I-tt)/g,3)*W>=.7&&x.push(I)}else x.push(I)}return x}}return[l,c,u]}var[Xw,jw,Yw]=Kg(1),[Zw,Kw,Jw]=Kg(.001);La(2,-53,53,[1]);function mg(i,t){return i.map(e=>e.map((n,r)=>r==0||r==8||n==null?n:t(r==1||e[8]==0?n:e[1]+n)))}function gg(i,t){return(e,n,r,s,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,h,f,d;return n.map(m=>{let y=i(m),g=y.getFullYear(),p=y.getMonth(),x=y.getDate(),b=y.getHours(),v=y.getMinutes(),S=y.getSeconds(),A=g!=l&&a[2]||p!=c&&a[3]||x!=u&&a[4]||b!=h&&a[5]||v!=f&&a[6]||S!=d&&a[7]||a[1];return l=g,c=p,u=x,h=b,f=v,d=S,A(y)})}}function Qw(i,t){let e=qf(t);return(n,r,s,o,a)=>r.map(l=>e(i(l)))}function Af(i,t,e){return new Date(i,t,e)}function yg(i,t){return t(i)}var tM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function xg(i,t){return(e,n,r,s)=>s==null?Bf:t(i(n))}function eM(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function nM(i,t){return i.series[t].fill(i,t)}var iM={show:!0,live:!0,isolate:!1,mount:ww,markers:{show:!0,width:2,stroke:eM,fill:nM,dash:"solid"},idx:null,idxs:null,values:[]};function rM(i,t){let e=i.cursor.points,n=Li(),r=e.size(i,t);en(n,Ta,r),en(n,Ra,r);let s=r/-2;en(n,"marginLeft",s),en(n,"marginTop",s);let o=e.width(i,t,r);return o&&en(n,"borderWidth",o),n}function sM(i,t){let e=i.series[t].points;return e._fill||e._stroke}function oM(i,t){let e=i.series[t].points;return e._stroke||e._fill}function aM(i,t){return i.series[t].points.size}var Ef=[0,0];function lM(i,t,e){return Ef[0]=t,Ef[1]=e,Ef}function ic(i,t,e,n=!0){return r=>{r.button==0&&(!n||r.target==t)&&e(r)}}function Tf(i,t,e,n=!0){return r=>{(!n||r.target==t)&&e(r)}}var cM={show:!0,x:!0,y:!0,lock:!1,move:lM,points:{one:!1,show:rM,size:aM,width:0,stroke:oM,fill:sM},bind:{mousedown:ic,mouseup:ic,click:ic,dblclick:ic,mousemove:Tf,mouseleave:Tf,mouseenter:Tf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,r)=>n-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Jg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Xf=Mn({},Jg,{filter:kg}),Qg=Mn({},Xf,{size:10}),t0=Mn({},Jg,{show:!1}),jf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',e0="bold "+jf,n0=1.5,vg={show:!0,scale:"x",stroke:kf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:e0,side:2,grid:Xf,ticks:Qg,border:t0,font:jf,lineGap:n0,rotate:0},uM="Value",hM="Time",_g={show:!0,scale:"x",auto:!1,sorted:1,min:We,max:-We,idxs:[]};function fM(i,t,e,n,r){return t.map(s=>s==null?"":Hf(s))}function dM(i,t,e,n,r,s,o){let a=[],l=es.get(r)||0;e=o?e:qe(uc(e,r),l);for(let c=e;c<=n;c=qe(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function Ff(i,t,e,n,r,s,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Nr:Dg,u=_i(c(e));r=_o(l,u),l==10&&(r=Ls[Xi(r,Ls)]);let h=e,f=r*l;l==10&&(f=Ls[Xi(f,Ls)]);do a.push(h),h=h+r,l==10&&!es.has(h)&&(h=qe(h,es.get(r))),h>=f&&(r=h,f=r*l,l==10&&(f=Ls[Xi(f,Ls)]));while(h<=n);return a}function pM(i,t,e,n,r,s,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Ff(i,t,ii(l,e),n,r):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?Ff(i,t,ii(l,-n),-e,r):[l]).reverse().map(f=>-f).concat(u,c)}var i0=/./,mM=/[12357]/,gM=/[125]/,bg=/1/,Nf=(i,t,e,n)=>i.map((r,s)=>t==4&&r==0||s%n==0&&e.test(r.toExponential()[r<0?1:0])?r:null);function yM(i,t,e,n,r){let s=i.axes[e],o=s.scale,a=i.scales[o],l=i.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?i0:l(7,o)-u>=c?mM:l(5,o)-u>=c?gM:bg;if(h==bg){let f=Rn(l(1,o)-u);if(f<c)return Nf(t.slice().reverse(),a.distr,h,Fi(c/f)).reverse()}return Nf(t,a.distr,h,1)}function xM(i,t,e,n,r){let s=i.axes[e],o=s.scale,a=s._space,l=i.valToPos,c=Rn(l(1,o)-l(2,o));return c<a?Nf(t.slice().reverse(),3,i0,Fi(a/c)).reverse():t}function vM(i,t,e,n){return n==null?Bf:t==null?"":Hf(t)}var wg={show:!0,scale:"y",stroke:kf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:e0,side:3,grid:Xf,ticks:Qg,border:t0,font:jf,lineGap:n0,rotate:0};function _M(i,t){let e=3+(i||1)*2;return qe(e*t,3)}function bM(i,t){let{scale:e,idxs:n}=i.series[0],r=i._data[0],s=i.valToPos(r[n[0]],e,!0),o=i.valToPos(r[n[1]],e,!0),a=Rn(o-s),l=i.series[t],c=a/(l.points.space*Te);return n[1]-n[0]<=c}var Mg={scale:null,auto:!0,sorted:0,min:We,max:-We},r0=(i,t,e,n,r)=>r,Sg={show:!0,auto:!0,sorted:0,gaps:r0,alpha:1,facets:[Mn({},Mg,{scale:"x"}),Mn({},Mg,{scale:"y"})]},Ag={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:r0,alpha:1,points:{show:bM,filter:null},values:null,min:We,max:-We,idxs:[],path:null,clip:null};function wM(i,t,e,n,r){return e/10}var s0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},MM=Mn({},s0,{time:!1,ori:1}),Eg={};function o0(i,t){let e=Eg[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(r=>r!=n)},pub(n,r,s,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=r&&e.plots[u].pub(n,r,s,o,a,l,c)}},i!=null&&(Eg[i]=e)),e}var Mo=1,Df=2;function Os(i,t,e){let n=i.mode,r=i.series[t],s=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=s[0],c=n==2?s[1]:s[t],u=n==2?o[r.facets[0].scale]:o[i.series[0].scale],h=n==2?o[r.facets[1].scale]:o[r.scale],f=a.left,d=a.top,m=a.width,y=a.height,g=i.valToPosH,p=i.valToPosV;return u.ori==0?e(r,l,c,u,h,g,p,f,d,m,y,dc,Ao,mc,l0,u0):e(r,l,c,u,h,p,g,d,f,y,m,pc,Eo,Kf,c0,h0)}function Yf(i,t){let e=0,n=0,r=Se(i.bands,Wf);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function SM(i,t,e,n,r){let s=i.mode,o=i.series[t],a=s==2?o.facets[1].scale:o.scale,l=i.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Dr(i,t,e,n,r,s){return Os(i,t,(o,a,l,c,u,h,f,d,m,y,g)=>{let p=o.pxRound,x=c.dir*(c.ori==0?1:-1),b=c.ori==0?Ao:Eo,v,S;x==1?(v=e,S=n):(v=n,S=e);let A=p(h(a[v],c,y,d)),_=p(f(l[v],u,g,m)),w=p(h(a[S],c,y,d)),N=p(f(s==1?u.max:u.min,u,g,m)),P=new Path2D(r);return b(P,w,N),b(P,A,N),b(P,A,_),P})}function fc(i,t,e,n,r,s){let o=null;if(i.length>0){o=new Path2D;let a=t==0?mc:Kf,l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+s),l=f[1]}}let c=e+r-l,u=10;c>0&&a(o,l,n-u/2,c,n+s+u)}return o}function AM(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Zf(i,t,e,n,r,s,o){let a=[],l=i.length;for(let c=r==1?e:n;c>=e&&c<=n;c+=r)if(t[c]===null){let h=c,f=c;if(r==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=s(i[h]),m=f==h?d:s(i[f]),y=h-r;d=o<=0&&y>=0&&y<l?s(i[y]):d;let p=f+r;m=o>=0&&p>=0&&p<l?s(i[p]):m,m>=d&&a.push([d,m])}return a}function Tg(i){return i==0?Ug:i==1?Tn:t=>Is(t,i)}function a0(i){let t=i==0?dc:pc,e=i==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},n=i==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?n(r,s,o,a,l):(c=ji(c,a/2,l/2),u=ji(u,a/2,l/2),t(r,s+c,o),e(r,s+a,o,s+a,o+l,c),e(r,s+a,o+l,s,o+l,u),e(r,s,o+l,s,o,u),e(r,s,o,s+a,o,c),r.closePath())}}var dc=(i,t,e)=>{i.moveTo(t,e)},pc=(i,t,e)=>{i.moveTo(e,t)},Ao=(i,t,e)=>{i.lineTo(t,e)},Eo=(i,t,e)=>{i.lineTo(e,t)},mc=a0(0),Kf=a0(1),l0=(i,t,e,n,r,s)=>{i.arc(t,e,n,r,s)},c0=(i,t,e,n,r,s)=>{i.arc(e,t,n,r,s)},u0=(i,t,e,n,r,s,o)=>{i.bezierCurveTo(t,e,n,r,s,o)},h0=(i,t,e,n,r,s,o)=>{i.bezierCurveTo(e,t,r,n,o,s)};function f0(i){return(t,e,n,r,s)=>Os(t,e,(o,a,l,c,u,h,f,d,m,y,g)=>{let{pxRound:p,points:x}=o,b,v;c.ori==0?(b=dc,v=l0):(b=pc,v=c0);let S=qe(x.width*Te,3),A=(x.size-x.width)/2*Te,_=qe(A*2,3),w=new Path2D,N=new Path2D,{left:P,top:I,width:U,height:z}=t.bbox;mc(N,P-_,I-_,U+_*2,z+_*2);let C=O=>{if(l[O]!=null){let W=p(h(a[O],c,y,d)),G=p(f(l[O],u,g,m));b(w,W+A,G),v(w,W,G,A,0,rc*2)}};if(s)s.forEach(C);else for(let O=n;O<=r;O++)C(O);return{stroke:S>0?w:null,fill:w,clip:N,flags:Mo|Df}})}function d0(i){return(t,e,n,r,s,o)=>{n!=r&&(s!=n&&o!=n&&i(t,e,n),s!=r&&o!=r&&i(t,e,r),i(t,e,o))}}var EM=d0(Ao),TM=d0(Eo);function p0(i){let t=Se(i?.alignGaps,0);return(e,n,r,s)=>Os(e,n,(o,a,l,c,u,h,f,d,m,y,g)=>{[r,s]=lc(l,r,s);let p=o.pxRound,x=z=>p(h(z,c,y,d)),b=z=>p(f(z,u,g,m)),v,S;c.ori==0?(v=Ao,S=EM):(v=Eo,S=TM);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Mo},w=_.stroke,N=!1;if(s-r>=y*4){let z=ct=>e.posToVal(ct,c.key,!0),C=null,O=null,W,G,et,$=x(a[A==1?r:s]),X=x(a[r]),tt=x(a[s]),ht=z(A==1?X+1:tt-1);for(let ct=A==1?r:s;ct>=r&&ct<=s;ct+=A){let J=a[ct],gt=(A==1?J<ht:J>ht)?$:x(J),bt=l[ct];gt==$?bt!=null?(G=bt,C==null?(v(w,gt,b(G)),W=C=O=G):G<C?C=G:G>O&&(O=G)):bt===null&&(N=!0):(C!=null&&S(w,$,b(C),b(O),b(W),b(G)),bt!=null?(G=bt,v(w,gt,b(G)),C=O=W=G):(C=O=null,bt===null&&(N=!0)),$=gt,ht=z($+A))}C!=null&&C!=O&&et!=$&&S(w,$,b(C),b(O),b(W),b(G))}else for(let z=A==1?r:s;z>=r&&z<=s;z+=A){let C=l[z];C===null?N=!0:C!=null&&v(w,x(a[z]),b(C))}let[I,U]=Yf(e,n);if(o.fill!=null||I!=0){let z=_.fill=new Path2D(w),C=o.fillTo(e,n,o.min,o.max,I),O=b(C),W=x(a[r]),G=x(a[s]);A==-1&&([G,W]=[W,G]),v(z,G,O),v(z,W,O)}if(!o.spanGaps){let z=[];N&&z.push(...Zf(a,l,r,s,A,x,t)),_.gaps=z=o.gaps(e,n,r,s,z),_.clip=fc(z,c.ori,d,m,y,g)}return U!=0&&(_.band=U==2?[Dr(e,n,r,s,w,-1),Dr(e,n,r,s,w,1)]:Dr(e,n,r,s,w,U)),_})}function RM(i){let t=Se(i.align,1),e=Se(i.ascDesc,!1),n=Se(i.alignGaps,0),r=Se(i.extend,!1);return(s,o,a,l)=>Os(s,o,(c,u,h,f,d,m,y,g,p,x,b)=>{[a,l]=lc(h,a,l);let v=c.pxRound,{left:S,width:A}=s.bbox,_=X=>v(m(X,f,x,g)),w=X=>v(y(X,d,b,p)),N=f.ori==0?Ao:Eo,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Mo},I=P.stroke,U=f.dir*(f.ori==0?1:-1),z=w(h[U==1?a:l]),C=_(u[U==1?a:l]),O=C,W=C;r&&t==-1&&(W=S,N(I,W,z)),N(I,C,z);for(let X=U==1?a:l;X>=a&&X<=l;X+=U){let tt=h[X];if(tt==null)continue;let ht=_(u[X]),ct=w(tt);t==1?N(I,ht,z):N(I,O,ct),N(I,ht,ct),z=ct,O=ht}let G=O;r&&t==1&&(G=S+A,N(I,G,z));let[et,$]=Yf(s,o);if(c.fill!=null||et!=0){let X=P.fill=new Path2D(I),tt=c.fillTo(s,o,c.min,c.max,et),ht=w(tt);N(X,G,ht),N(X,W,ht)}if(!c.spanGaps){let X=[];X.push(...Zf(u,h,a,l,U,_,n));let tt=c.width*Te/2,ht=e||t==1?tt:-tt,ct=e||t==-1?-tt:tt;X.forEach(J=>{J[0]+=ht,J[1]+=ct}),P.gaps=X=c.gaps(s,o,a,l,X),P.clip=fc(X,f.ori,g,p,x,b)}return $!=0&&(P.band=$==2?[Dr(s,o,a,l,I,-1),Dr(s,o,a,l,I,1)]:Dr(s,o,a,l,I,$)),P})}function Rg(i,t,e,n,r,s,o=We){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=Rn(i[l]-i[a]);u<c&&(c=u,o=Rn(e(i[l],n,r,s)-e(i[a],n,r,s)))}a=l}}return o}function CM(i){i=i||Ia;let t=Se(i.size,[.6,We,1]),e=i.align||0,n=i.gap||0,r=i.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=_e(r),o=1-t[0],a=Se(t[1],We),l=Se(t[2],1),c=Se(i.disp,Ia),u=Se(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,m,y,g)=>Os(d,m,(p,x,b,v,S,A,_,w,N,P,I)=>{let U=p.pxRound,z=e,C=n*Te,O=a*Te,W=l*Te,G,et;v.ori==0?[G,et]=s(d,m):[et,G]=s(d,m);let $=v.dir*(v.ori==0?1:-1),X=v.ori==0?mc:Kf,tt=v.ori==0?u:(xt,Xt,ce,At,He,Ht,jt)=>{u(xt,Xt,ce,He,At,jt,Ht)},ht=Se(d.bands,Wf).find(xt=>xt.series[0]==m),ct=ht!=null?ht.dir:0,J=p.fillTo(d,m,p.min,p.max,ct),dt=U(_(J,S,I,N)),gt,bt,yt,Gt=P,Kt=U(p.width*Te),zt=!1,le=null,oe=null,Jt=null,Fe=null;h!=null&&(Kt==0||f!=null)&&(zt=!0,le=h.values(d,m,y,g),oe=new Map,new Set(le).forEach(xt=>{xt!=null&&oe.set(xt,new Path2D)}),Kt>0&&(Jt=f.values(d,m,y,g),Fe=new Map,new Set(Jt).forEach(xt=>{xt!=null&&Fe.set(xt,new Path2D)})));let{x0:Ae,size:hn}=c;if(Ae!=null&&hn!=null){z=1,x=Ae.values(d,m,y,g),Ae.unit==2&&(x=x.map(ce=>d.posToVal(w+ce*P,v.key,!0)));let xt=hn.values(d,m,y,g);hn.unit==2?bt=xt[0]*P:bt=A(xt[0],v,P,w)-A(0,v,P,w),Gt=Rg(x,b,A,v,P,w,Gt),yt=Gt-bt+C}else Gt=Rg(x,b,A,v,P,w,Gt),yt=Gt*o+C,bt=Gt-yt;yt<1&&(yt=0),Kt>=bt/2&&(Kt=0),yt<5&&(U=Ug);let Ft=yt>0,xe=Gt-yt-(Ft?Kt:0);bt=U(Lf(xe,W,O)),gt=(z==0?bt/2:z==$?0:bt)-z*$*((z==0?C/2:0)+(Ft?Kt/2:0));let te={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Ye=zt?null:new Path2D,Ze=null;if(ht!=null)Ze=d.data[ht.series[1]];else{let{y0:xt,y1:Xt}=c;xt!=null&&Xt!=null&&(b=Xt.values(d,m,y,g),Ze=xt.values(d,m,y,g))}let on=G*bt,k=et*bt;for(let xt=$==1?y:g;xt>=y&&xt<=g;xt+=$){let Xt=b[xt];if(Xt==null)continue;if(Ze!=null){let j=Ze[xt]??0;if(Xt-j==0)continue;dt=_(j,S,I,N)}let ce=v.distr!=2||c!=null?x[xt]:xt,At=A(ce,v,P,w),He=_(Se(Xt,J),S,I,N),Ht=U(At-gt),jt=U(ii(He,dt)),L=U(ji(He,dt)),E=jt-L;if(Xt!=null){let j=Xt<0?k:on,ft=Xt<0?on:k;zt?(Kt>0&&Jt[xt]!=null&&X(Fe.get(Jt[xt]),Ht,L+_i(Kt/2),bt,ii(0,E-Kt),j,ft),le[xt]!=null&&X(oe.get(le[xt]),Ht,L+_i(Kt/2),bt,ii(0,E-Kt),j,ft)):X(Ye,Ht,L+_i(Kt/2),bt,ii(0,E-Kt),j,ft),tt(d,m,xt,Ht-Kt/2,L,bt+Kt,E)}}return Kt>0?te.stroke=zt?Fe:Ye:zt||(te._fill=p.width==0?p._fill:p._stroke??p._fill,te.width=0),te.fill=zt?oe:Ye,te})}function PM(i,t){let e=Se(t?.alignGaps,0);return(n,r,s,o)=>Os(n,r,(a,l,c,u,h,f,d,m,y,g,p)=>{[s,o]=lc(c,s,o);let x=a.pxRound,b=G=>x(f(G,u,g,m)),v=G=>x(d(G,h,p,y)),S,A,_;u.ori==0?(S=dc,_=Ao,A=u0):(S=pc,_=Eo,A=h0);let w=u.dir*(u.ori==0?1:-1),N=b(l[w==1?s:o]),P=N,I=[],U=[];for(let G=w==1?s:o;G>=s&&G<=o;G+=w)if(c[G]!=null){let $=l[G],X=b($);I.push(P=X),U.push(v(c[G]))}let z={stroke:i(I,U,S,_,A,x),fill:null,clip:null,band:null,gaps:null,flags:Mo},C=z.stroke,[O,W]=Yf(n,r);if(a.fill!=null||O!=0){let G=z.fill=new Path2D(C),et=a.fillTo(n,r,a.min,a.max,O),$=v(et);_(G,P,$),_(G,N,$)}if(!a.spanGaps){let G=[];G.push(...Zf(l,c,s,o,w,b,e)),z.gaps=G=a.gaps(n,r,s,o,G),z.clip=fc(G,u.ori,m,y,g,p)}return W!=0&&(z.band=W==2?[Dr(n,r,s,o,C,-1),Dr(n,r,s,o,C,1)]:Dr(n,r,s,o,C,W)),z})}function IM(i){return PM(LM,i)}function LM(i,t,e,n,r,s){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}return a}var Of=new Set;function Cg(){for(let i of Of)i.syncRect(!0)}So&&(Ns(fw,vo,Cg),Ns(dw,vo,Cg,!0),Ns(sc,vo,()=>{ln.pxRatio=Te}));var FM=p0(),NM=f0();function Pg(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((s,o)=>Uf(s,o,t,e))}function DM(i,t){return i.map((e,n)=>n==0?{}:Mn({},t,e))}function Uf(i,t,e,n){return Mn({},t==0?e:n,i)}function m0(i,t,e){return t==null?bo:[t,e]}var OM=m0;function UM(i,t,e){return t==null?bo:oc(t,e,Gf,!0)}function g0(i,t,e,n){return t==null?bo:cc(t,e,i.scales[n].log,!1)}var kM=g0;function y0(i,t,e,n){return t==null?bo:Vf(t,e,i.scales[n].log,!1)}var BM=y0;function zM(i,t,e,n,r){let s=ii(lg(i),lg(t)),o=t-i,a=Xi(r/n*o,e);do{let l=e[a],c=n*l/o;if(c>=r&&s+(l<5?es.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Ig(i){let t,e;return i=i.replace(/(\d+)px/,(n,r)=>(t=Tn((e=+r)*Te))+"px"),[i,t,e]}function VM(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=qe(t[2]*Te,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ln(i,t,e){let n={mode:Se(i.mode,1)},r=n.mode;function s(M,T,F,D){let q=T.valToPct(M);return D+F*(T.dir==-1?1-q:q)}function o(M,T,F,D){let q=T.valToPct(M);return D+F*(T.dir==-1?q:1-q)}function a(M,T,F,D){return T.ori==0?s(M,T,F,D):o(M,T,F,D)}n.valToPosH=s,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Li(jb);if(i.id!=null&&(c.id=i.id),vi(c,i.class),i.title){let M=Li(Kb,c);M.textContent=i.title}let u=$i("canvas"),h=n.ctx=u.getContext("2d"),f=Li(Jb,c);Ns("click",f,M=>{M.target===m&&(Je!=ho||rn!=fo)&&Vn.click(n,M)},!0);let d=n.under=Li(Qb,f);f.appendChild(u);let m=n.over=Li(tw,f);i=wo(i);let y=+Se(i.pxAlign,1),g=Tg(y);(i.plugins||[]).forEach(M=>{M.opts&&(i=M.opts(n,i)||i)});let p=i.ms||.001,x=n.series=r==1?Pg(i.series||[],_g,Ag,!1):DM(i.series||[null],Sg),b=n.axes=Pg(i.axes||[],vg,wg,!0),v=n.scales={},S=n.bands=i.bands||[];S.forEach(M=>{M.fill=_e(M.fill||null),M.dir=Se(M.dir,-1)});let A=r==2?x[1].facets[0].scale:x[0].scale,_={axes:Pr,series:ge},w=(i.drawOrder||["axes","series"]).map(M=>_[M]);function N(M){let T=M.distr==3?F=>Nr(F>0?F:M.clamp(n,F,M.min,M.max,M.key)):M.distr==4?F=>Sf(F,M.asinh):M.distr==100?F=>M.fwd(F):F=>F;return F=>{let D=T(F),{_min:q,_max:K}=M,lt=K-q;return(D-q)/lt}}function P(M){let T=v[M];if(T==null){let F=(i.scales||Ia)[M]||Ia;if(F.from!=null){P(F.from);let D=Mn({},v[F.from],F,{key:M});D.valToPct=N(D),v[M]=D}else{T=v[M]=Mn({},M==A?s0:MM,F),T.key=M;let D=T.time,q=T.range,K=ts(q);if((M!=A||r==2&&!D)&&(K&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?sg:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?sg:{mode:1,hard:q[1],soft:q[1]}},K=!1),!K&&hc(q))){let lt=q;q=(pt,Mt,Nt)=>Mt==null?bo:oc(Mt,Nt,lt)}T.range=_e(q||(D?OM:M==A?T.distr==3?kM:T.distr==4?BM:m0:T.distr==3?g0:T.distr==4?y0:UM)),T.auto=_e(K?!1:T.auto),T.clamp=_e(T.clamp||wM),T._min=T._max=null,T.valToPct=N(T)}}}P("x"),P("y"),r==1&&x.forEach(M=>{P(M.scale)}),b.forEach(M=>{P(M.scale)});for(let M in i.scales)P(M);let I=v[A],U=I.distr,z,C;I.ori==0?(vi(c,Yb),z=s,C=o):(vi(c,Zb),z=o,C=s);let O={};for(let M in v){let T=v[M];(T.min!=null||T.max!=null)&&(O[M]={min:T.min,max:T.max},T.min=T.max=null)}let W=i.tzDate||(M=>new Date(Tn(M/p))),G=i.fmtDate||qf,et=p==1?Yw(W):Jw(W),$=gg(W,mg(p==1?jw:Kw,G)),X=xg(W,yg(tM,G)),tt=[],ht=n.legend=Mn({},iM,i.legend),ct=n.cursor=Mn({},cM,{drag:{y:r==2}},i.cursor),J=ht.show,dt=ct.show,gt=ht.markers;ht.idxs=tt,gt.width=_e(gt.width),gt.dash=_e(gt.dash),gt.stroke=_e(gt.stroke),gt.fill=_e(gt.fill);let bt,yt,Gt,Kt=[],zt=[],le,oe=!1,Jt={};if(ht.live){let M=x[1]?x[1].values:null;oe=M!=null,le=oe?M(n,1,0):{_:0};for(let T in le)Jt[T]=Bf}if(J)if(bt=$i("table",ow,c),Gt=$i("tbody",null,bt),ht.mount(n,bt),oe){yt=$i("thead",null,bt,Gt);let M=$i("tr",null,yt);$i("th",null,M);for(var Fe in le)$i("th",$m,M).textContent=Fe}else vi(bt,lw),ht.live&&vi(bt,aw);let Ae={show:!0},hn={show:!1};function Ft(M,T){if(T==0&&(oe||!ht.live||r==2))return bo;let F=[],D=$i("tr",cw,Gt,Gt.childNodes[T]);vi(D,M.class),M.show||vi(D,Fs);let q=$i("th",null,D);if(gt.show){let pt=Li(uw,q);if(T>0){let Mt=gt.width(n,T);Mt&&(pt.style.border=Mt+"px "+gt.dash(n,T)+" "+gt.stroke(n,T)),pt.style.background=gt.fill(n,T)}}let K=Li($m,q);M.label instanceof HTMLElement?K.appendChild(M.label):K.textContent=M.label,T>0&&(gt.show||(K.style.color=M.width>0?gt.stroke(n,T):gt.fill(n,T)),te("click",q,pt=>{if(ct._lock)return;ee(pt);let Mt=x.indexOf(M);if((pt.ctrlKey||pt.metaKey)!=ht.isolate){let Nt=x.some((Dt,Ut)=>Ut>0&&Ut!=Mt&&Dt.show);x.forEach((Dt,Ut)=>{Ut>0&&ur(Ut,Nt?Ut==Mt?Ae:hn:Ae,!0,wn.setSeries)})}else ur(Mt,{show:!M.show},!0,wn.setSeries)},!1),ne&&te(Zm,q,pt=>{ct._lock||(ee(pt),ur(x.indexOf(M),mo,!0,wn.setSeries))},!1));for(var lt in le){let pt=$i("td",hw,D);pt.textContent="--",F.push(pt)}return[D,F]}let xe=new Map;function te(M,T,F,D=!0){let q=xe.get(T)||{},K=ct.bind[M](n,T,F,D);K&&(Ns(M,T,q[M]=K),xe.set(T,q))}function Ye(M,T,F){let D=xe.get(T)||{};for(let q in D)(M==null||q==M)&&(If(q,T,D[q]),delete D[q]);M==null&&xe.delete(T)}let Ze=0,on=0,k=0,xt=0,Xt=0,ce=0,At=Xt,He=ce,Ht=k,jt=xt,L=0,E=0,j=0,ft=0;n.bbox={};let at=!1,_t=!1,wt=!1,nt=!1,st=!1,mt=!1;function B(M,T,F){(F||M!=n.width||T!=n.height)&&ot(M,T),de(!1),wt=!0,_t=!0,jn()}function ot(M,T){n.width=Ze=k=M,n.height=on=xt=T,Xt=ce=0,St(),Wt();let F=n.bbox;L=F.left=Is(Xt*Te,.5),E=F.top=Is(ce*Te,.5),j=F.width=Is(k*Te,.5),ft=F.height=Is(xt*Te,.5)}let it=3;function Et(){let M=!1,T=0;for(;!M;){T++;let F=lo(T),D=cr(T);M=T==it||F&&D,M||(ot(n.width,n.height),_t=!0)}}function vt({width:M,height:T}){B(M,T)}n.setSize=vt;function St(){let M=!1,T=!1,F=!1,D=!1;b.forEach((q,K)=>{if(q.show&&q._show){let{side:lt,_size:pt}=q,Mt=lt%2,Nt=q.label!=null?q.labelSize:0,Dt=pt+Nt;Dt>0&&(Mt?(k-=Dt,lt==3?(Xt+=Dt,D=!0):F=!0):(xt-=Dt,lt==0?(ce+=Dt,M=!0):T=!0))}}),ar[0]=M,ar[1]=F,ar[2]=T,ar[3]=D,k-=Hi[1]+Hi[3],Xt+=Hi[3],xt-=Hi[2]+Hi[0],ce+=Hi[0]}function Wt(){let M=Xt+k,T=ce+xt,F=Xt,D=ce;function q(K,lt){switch(K){case 1:return M+=lt,M-lt;case 2:return T+=lt,T-lt;case 3:return F-=lt,F+lt;case 0:return D-=lt,D+lt}}b.forEach((K,lt)=>{if(K.show&&K._show){let pt=K.side;K._pos=q(pt,K._size),K.label!=null&&(K._lpos=q(pt,K.labelSize))}})}if(ct.dataIdx==null){let M=ct.hover,T=M.skip=new Set(M.skip??[]);T.add(void 0);let F=M.prox=_e(M.prox),D=M.bias??=0;ct.dataIdx=(q,K,lt,pt)=>{if(K==0)return lt;let Mt=lt,Nt=F(q,K,lt,pt)??We,Dt=Nt>=0&&Nt<We,Ut=I.ori==0?k:xt,ae=ct.left,Ee=t[0],Me=t[K];if(T.has(Me[lt])){Mt=null;let ye=null,Qt=null,qt;if(D==0||D==-1)for(qt=lt;ye==null&&qt-- >0;)T.has(Me[qt])||(ye=qt);if(D==0||D==1)for(qt=lt;Qt==null&&qt++<Me.length;)T.has(Me[qt])||(Qt=qt);if(ye!=null||Qt!=null)if(Dt){let tn=ye==null?-1/0:z(Ee[ye],I,Ut,0),pn=Qt==null?1/0:z(Ee[Qt],I,Ut,0),Dn=ae-tn,ke=pn-ae;Dn<=ke?Dn<=Nt&&(Mt=ye):ke<=Nt&&(Mt=Qt)}else Mt=Qt==null?ye:ye==null?Qt:lt-ye<=Qt-lt?ye:Qt}else Dt&&Rn(ae-z(Ee[lt],I,Ut,0))>Nt&&(Mt=null);return Mt}}let ee=M=>{ct.event=M};ct.idxs=tt,ct._lock=!1;let ut=ct.points;ut.show=_e(ut.show),ut.size=_e(ut.size),ut.stroke=_e(ut.stroke),ut.width=_e(ut.width),ut.fill=_e(ut.fill);let kt=n.focus=Mn({},i.focus||{alpha:.3},ct.focus),ne=kt.prox>=0,Ct=ne&&ut.one,fe=[],Ke=[],Jn=[];function xa(M,T){let F=ut.show(n,T);if(F instanceof HTMLElement)return vi(F,sw),vi(F,M.class),pr(F,-10,-10,k,xt),m.insertBefore(F,fe[T]),F}function so(M,T){if(r==1||T>0){let F=r==1&&v[M.scale].time,D=M.value;M.value=F?hg(D)?xg(W,yg(D,G)):D||X:D||vM,M.label=M.label||(F?hM:uM)}if(Ct||T>0){M.width=M.width==null?1:M.width,M.paths=M.paths||FM||Mw,M.fillTo=_e(M.fillTo||SM),M.pxAlign=+Se(M.pxAlign,y),M.pxRound=Tg(M.pxAlign),M.stroke=_e(M.stroke||null),M.fill=_e(M.fill||null),M._stroke=M._fill=M._paths=M._focus=null;let F=_M(ii(1,M.width),1),D=M.points=Mn({},{size:F,width:ii(1,F*.2),stroke:M.stroke,space:F*2,paths:NM,_stroke:null,_fill:null},M.points);D.show=_e(D.show),D.filter=_e(D.filter),D.fill=_e(D.fill),D.stroke=_e(D.stroke),D.paths=_e(D.paths),D.pxAlign=M.pxAlign}if(J){let F=Ft(M,T);Kt.splice(T,0,F[0]),zt.splice(T,0,F[1]),ht.values.push(null)}if(dt){tt.splice(T,0,null);let F=null;Ct?T==0&&(F=xa(M,T)):T>0&&(F=xa(M,T)),fe.splice(T,0,F),Ke.splice(T,0,0),Jn.splice(T,0,0)}Nn("addSeries",T)}function hf(M,T){T=T??x.length,M=r==1?Uf(M,T,_g,Ag):Uf(M,T,{},Sg),x.splice(T,0,M),so(x[T],T)}n.addSeries=hf;function jl(M){if(x.splice(M,1),J){ht.values.splice(M,1),zt.splice(M,1);let T=Kt.splice(M,1)[0];Ye(null,T.firstChild),T.remove()}dt&&(tt.splice(M,1),fe.splice(M,1)[0].remove(),Ke.splice(M,1),Jn.splice(M,1)),Nn("delSeries",M)}n.delSeries=jl;let ar=[!1,!1,!1,!1];function Tr(M,T){if(M._show=M.show,M.show){let F=M.side%2,D=v[M.scale];D==null&&(M.scale=F?x[1].scale:A,D=v[M.scale]);let q=D.time;M.size=_e(M.size),M.space=_e(M.space),M.rotate=_e(M.rotate),ts(M.incrs)&&M.incrs.forEach(lt=>{!es.has(lt)&&es.set(lt,zg(lt))}),M.incrs=_e(M.incrs||(D.distr==2?qw:q?p==1?Xw:Zw:Ls)),M.splits=_e(M.splits||(q&&D.distr==1?et:D.distr==3?Ff:D.distr==4?pM:dM)),M.stroke=_e(M.stroke),M.grid.stroke=_e(M.grid.stroke),M.ticks.stroke=_e(M.ticks.stroke),M.border.stroke=_e(M.border.stroke);let K=M.values;M.values=ts(K)&&!ts(K[0])?_e(K):q?ts(K)?gg(W,mg(K,G)):hg(K)?Qw(W,K):K||$:K||fM,M.filter=_e(M.filter||(D.distr>=3&&D.log==10?yM:D.distr==3&&D.log==2?xM:kg)),M.font=Ig(M.font),M.labelFont=Ig(M.labelFont),M._size=M.size(n,null,T,0),M._space=M._rotate=M._incrs=M._found=M._splits=M._values=null,M._size>0&&(ar[T]=!0,M._el=Li(ew,f))}}function Rr(M,T,F,D){let[q,K,lt,pt]=F,Mt=T%2,Nt=0;return Mt==0&&(pt||K)&&(Nt=T==0&&!q||T==2&&!lt?Tn(vg.size/3):0),Mt==1&&(q||lt)&&(Nt=T==1&&!K||T==3&&!pt?Tn(wg.size/2):0),Nt}let va=n.padding=(i.padding||[Rr,Rr,Rr,Rr]).map(M=>_e(Se(M,Rr))),Hi=n._padding=va.map((M,T)=>M(n,T,ar,0)),fn,yn=null,xn=null,lr=r==1?x[0].idxs:null,mi=null,jr=!1;function _a(M,T){if(t=M??[],n.data=n._data=t,r==2){fn=0;for(let F=1;F<x.length;F++)fn+=t[F][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),mi=t[0],fn=mi.length;let F=t;if(U==2){F=t.slice();let D=F[0]=Array(fn);for(let q=0;q<fn;q++)D[q]=q}n._data=t=F}if(de(!0),Nn("setData"),U==2&&(wt=!0),T!==!1){let F=I;F.auto(n,jr)?ba():Kr(A,F.min,F.max),nt=nt||ct.left>=0,mt=!0,jn()}}n.setData=_a;function ba(){jr=!0;let M,T;r==1&&(fn>0?(yn=lr[0]=0,xn=lr[1]=fn-1,M=t[0][yn],T=t[0][xn],U==2?(M=yn,T=xn):M==T&&(U==3?[M,T]=cc(M,M,I.log,!1):U==4?[M,T]=Vf(M,M,I.log,!1):I.time?T=M+Tn(86400/p):[M,T]=oc(M,T,Gf,!0))):(yn=lr[0]=M=null,xn=lr[1]=T=null)),Kr(A,M,T)}let oo,Yr,ao,R,H,Q,Y,Z,Tt,It;function Rt(M,T,F,D,q,K){M??=jm,F??=Wf,D??="butt",q??=jm,K??="round",M!=oo&&(h.strokeStyle=oo=M),q!=Yr&&(h.fillStyle=Yr=q),T!=ao&&(h.lineWidth=ao=T),K!=H&&(h.lineJoin=H=K),D!=Q&&(h.lineCap=Q=D),F!=R&&h.setLineDash(R=F)}function Lt(M,T,F,D){T!=Yr&&(h.fillStyle=Yr=T),M!=Y&&(h.font=Y=M),F!=Z&&(h.textAlign=Z=F),D!=Tt&&(h.textBaseline=Tt=D)}function Vt(M,T,F,D,q=0){if(D.length>0&&M.auto(n,jr)&&(T==null||T.min==null)){let K=Se(yn,0),lt=Se(xn,D.length-1),pt=F.min==null?yw(D,K,lt,q,M.distr==3):[F.min,F.max];M.min=ji(M.min,F.min=pt[0]),M.max=ii(M.max,F.max=pt[1])}}let ie={min:null,max:null};function me(){for(let D in v){let q=v[D];O[D]==null&&(q.min==null||O[A]!=null&&q.auto(n,jr))&&(O[D]=ie)}for(let D in v){let q=v[D];O[D]==null&&q.from!=null&&O[q.from]!=null&&(O[D]=ie)}O[A]!=null&&de(!0);let M={};for(let D in O){let q=O[D];if(q!=null){let K=M[D]=wo(v[D],Ew);if(q.min!=null)Mn(K,q);else if(D!=A||r==2)if(fn==0&&K.from==null){let lt=K.range(n,null,null,D);K.min=lt[0],K.max=lt[1]}else K.min=We,K.max=-We}}if(fn>0){x.forEach((D,q)=>{if(r==1){let K=D.scale,lt=O[K];if(lt==null)return;let pt=M[K];if(q==0){let Mt=pt.range(n,pt.min,pt.max,K);pt.min=Mt[0],pt.max=Mt[1],yn=Xi(pt.min,t[0]),xn=Xi(pt.max,t[0]),xn-yn>1&&(t[0][yn]<pt.min&&yn++,t[0][xn]>pt.max&&xn--),D.min=mi[yn],D.max=mi[xn]}else D.show&&D.auto&&Vt(pt,lt,D,t[q],D.sorted);D.idxs[0]=yn,D.idxs[1]=xn}else if(q>0&&D.show&&D.auto){let[K,lt]=D.facets,pt=K.scale,Mt=lt.scale,[Nt,Dt]=t[q],Ut=M[pt],ae=M[Mt];Ut!=null&&Vt(Ut,O[pt],K,Nt,K.sorted),ae!=null&&Vt(ae,O[Mt],lt,Dt,lt.sorted),D.min=lt.min,D.max=lt.max}});for(let D in M){let q=M[D],K=O[D];if(q.from==null&&(K==null||K.min==null)){let lt=q.range(n,q.min==We?null:q.min,q.max==-We?null:q.max,D);q.min=lt[0],q.max=lt[1]}}}for(let D in M){let q=M[D];if(q.from!=null){let K=M[q.from];if(K.min==null)q.min=q.max=null;else{let lt=q.range(n,K.min,K.max,D);q.min=lt[0],q.max=lt[1]}}}let T={},F=!1;for(let D in M){let q=M[D],K=v[D];if(K.min!=q.min||K.max!=q.max){K.min=q.min,K.max=q.max;let lt=K.distr;K._min=lt==3?Nr(K.min):lt==4?Sf(K.min,K.asinh):lt==100?K.fwd(K.min):K.min,K._max=lt==3?Nr(K.max):lt==4?Sf(K.max,K.asinh):lt==100?K.fwd(K.max):K.max,T[D]=F=!0}}if(F){x.forEach((D,q)=>{r==2?q>0&&T.y&&(D._paths=null):T[D.scale]&&(D._paths=null)});for(let D in T)wt=!0,Nn("setScale",D);dt&&ct.left>=0&&(nt=mt=!0)}for(let D in O)O[D]=null}function Bt(M){let T=Lf(yn-1,0,fn-1),F=Lf(xn+1,0,fn-1);for(;M[T]==null&&T>0;)T--;for(;M[F]==null&&F<fn-1;)F++;return[T,F]}function ge(){if(fn>0){let M=x.some(T=>T._focus)&&It!=kt.alpha;M&&(h.globalAlpha=It=kt.alpha),x.forEach((T,F)=>{if(F>0&&T.show&&(an(F,!1),an(F,!0),T._paths==null)){let D=It;It!=T.alpha&&(h.globalAlpha=It=T.alpha);let q=r==2?[0,t[F][0].length-1]:Bt(t[F]);T._paths=T.paths(n,F,q[0],q[1]),It!=D&&(h.globalAlpha=It=D)}}),x.forEach((T,F)=>{if(F>0&&T.show){let D=It;It!=T.alpha&&(h.globalAlpha=It=T.alpha),T._paths!=null&&Ne(F,!1);{let q=T._paths!=null?T._paths.gaps:null,K=T.points.show(n,F,yn,xn,q),lt=T.points.filter(n,F,K,q);(K||lt)&&(T.points._paths=T.points.paths(n,F,yn,xn,lt),Ne(F,!0))}It!=D&&(h.globalAlpha=It=D),Nn("drawSeries",F)}}),M&&(h.globalAlpha=It=1)}}function an(M,T){let F=T?x[M].points:x[M];F._stroke=F.stroke(n,M),F._fill=F.fill(n,M)}function Ne(M,T){let F=T?x[M].points:x[M],{stroke:D,fill:q,clip:K,flags:lt,_stroke:pt=F._stroke,_fill:Mt=F._fill,_width:Nt=F.width}=F._paths;Nt=qe(Nt*Te,3);let Dt=null,Ut=Nt%2/2;T&&Mt==null&&(Mt=Nt>0?"#fff":pt);let ae=F.pxAlign==1&&Ut>0;if(ae&&h.translate(Ut,Ut),!T){let Ee=L-Nt/2,Me=E-Nt/2,ye=j+Nt,Qt=ft+Nt;Dt=new Path2D,Dt.rect(Ee,Me,ye,Qt)}T?Ot(pt,Nt,F.dash,F.cap,Mt,D,q,lt,K):De(M,pt,Nt,F.dash,F.cap,Mt,D,q,lt,Dt,K),ae&&h.translate(-Ut,-Ut)}function De(M,T,F,D,q,K,lt,pt,Mt,Nt,Dt){let Ut=!1;Mt!=0&&S.forEach((ae,Ee)=>{if(ae.series[0]==M){let Me=x[ae.series[1]],ye=t[ae.series[1]],Qt=(Me._paths||Ia).band;ts(Qt)&&(Qt=ae.dir==1?Qt[0]:Qt[1]);let qt,tn=null;Me.show&&Qt&&vw(ye,yn,xn)?(tn=ae.fill(n,Ee)||K,qt=Me._paths.clip):Qt=null,Ot(T,F,D,q,tn,lt,pt,Mt,Nt,Dt,qt,Qt),Ut=!0}}),Ut||Ot(T,F,D,q,K,lt,pt,Mt,Nt,Dt)}let En=Mo|Df;function Ot(M,T,F,D,q,K,lt,pt,Mt,Nt,Dt,Ut){Rt(M,T,F,D,q),(Mt||Nt||Ut)&&(h.save(),Mt&&h.clip(Mt),Nt&&h.clip(Nt)),Ut?(pt&En)==En?(h.clip(Ut),Dt&&h.clip(Dt),ve(q,lt),vn(M,K,T)):pt&Df?(ve(q,lt),h.clip(Ut),vn(M,K,T)):pt&Mo&&(h.save(),h.clip(Ut),Dt&&h.clip(Dt),ve(q,lt),h.restore(),vn(M,K,T)):(ve(q,lt),vn(M,K,T)),(Mt||Nt||Ut)&&h.restore()}function vn(M,T,F){F>0&&(T instanceof Map?T.forEach((D,q)=>{h.strokeStyle=oo=q,h.stroke(D)}):T!=null&&M&&h.stroke(T))}function ve(M,T){T instanceof Map?T.forEach((F,D)=>{h.fillStyle=Yr=D,h.fill(F)}):T!=null&&M&&h.fill(T)}function Cr(M,T,F,D){let q=b[M],K;if(D<=0)K=[0,0];else{let lt=q._space=q.space(n,M,T,F,D),pt=q._incrs=q.incrs(n,M,T,F,D,lt);K=zM(T,F,pt,D,lt)}return q._found=K}function _n(M,T,F,D,q,K,lt,pt,Mt,Nt){let Dt=lt%2/2;y==1&&h.translate(Dt,Dt),Rt(pt,lt,Mt,Nt,pt),h.beginPath();let Ut,ae,Ee,Me,ye=q+(D==0||D==3?-K:K);F==0?(ae=q,Me=ye):(Ut=q,Ee=ye);for(let Qt=0;Qt<M.length;Qt++)T[Qt]!=null&&(F==0?Ut=Ee=M[Qt]:ae=Me=M[Qt],h.moveTo(Ut,ae),h.lineTo(Ee,Me));h.stroke(),y==1&&h.translate(-Dt,-Dt)}function lo(M){let T=!0;return b.forEach((F,D)=>{if(!F.show)return;let q=v[F.scale];if(q.min==null){F._show&&(T=!1,F._show=!1,de(!1));return}else F._show||(T=!1,F._show=!0,de(!1));let K=F.side,lt=K%2,{min:pt,max:Mt}=q,[Nt,Dt]=Cr(D,pt,Mt,lt==0?k:xt);if(Dt==0)return;let Ut=q.distr==2,ae=F._splits=F.splits(n,D,pt,Mt,Nt,Dt,Ut),Ee=q.distr==2?ae.map(qt=>mi[qt]):ae,Me=q.distr==2?mi[ae[1]]-mi[ae[0]]:Nt,ye=F._values=F.values(n,F.filter(n,Ee,D,Dt,Me),D,Dt,Me);F._rotate=K==2?F.rotate(n,ye,D,Dt):0;let Qt=F._size;F._size=Fi(F.size(n,ye,D,M)),Qt!=null&&F._size!=Qt&&(T=!1)}),T}function cr(M){let T=!0;return va.forEach((F,D)=>{let q=F(n,D,ar,M);q!=Hi[D]&&(T=!1),Hi[D]=q}),T}function Pr(){for(let M=0;M<b.length;M++){let T=b[M];if(!T.show||!T._show)continue;let F=T.side,D=F%2,q,K,lt=T.stroke(n,M),pt=F==0||F==3?-1:1,[Mt,Nt]=T._found;if(T.label!=null){let ei=T.labelGap*pt,xi=Tn((T._lpos+ei)*Te);Lt(T.labelFont[0],lt,"center",F==2?"top":Xm),h.save(),D==1?(q=K=0,h.translate(xi,Tn(E+ft/2)),h.rotate((F==3?-rc:rc)/2)):(q=Tn(L+j/2),K=xi);let Ps=Og(T.label)?T.label(n,M,Mt,Nt):T.label;h.fillText(Ps,q,K),h.restore()}if(Nt==0)continue;let Dt=v[T.scale],Ut=D==0?j:ft,ae=D==0?L:E,Ee=T._splits,Me=Dt.distr==2?Ee.map(ei=>mi[ei]):Ee,ye=Dt.distr==2?mi[Ee[1]]-mi[Ee[0]]:Mt,Qt=T.ticks,qt=T.border,tn=Qt.show?Qt.size:0,pn=Tn(tn*Te),Dn=Tn((T.alignTo==2?T._size-tn-T.gap:T.gap)*Te),ke=T._rotate*-rc/180,mn=g(T._pos*Te),gi=(pn+Dn)*pt,ti=mn+gi;K=D==0?ti:0,q=D==1?ti:0;let Pi=T.font[0],Wi=T.align==1?yo:T.align==2?bf:ke>0?yo:ke<0?bf:D==0?"center":F==3?bf:yo,fr=ke||D==1?"middle":F==2?"top":Xm;Lt(Pi,lt,Wi,fr);let yi=T.font[1]*T.lineGap,Ii=Ee.map(ei=>g(a(ei,Dt,Ut,ae))),qi=T._values;for(let ei=0;ei<qi.length;ei++){let xi=qi[ei];if(xi!=null){D==0?q=Ii[ei]:K=Ii[ei],xi=""+xi;let Ps=xi.indexOf(`
`)==-1?[xi]:xi.split(/\n/gm);for(let ni=0;ni<Ps.length;ni++){let Vm=Ps[ni];ke?(h.save(),h.translate(q,K+ni*yi),h.rotate(ke),h.fillText(Vm,0,0),h.restore()):h.fillText(Vm,q,K+ni*yi)}}}Qt.show&&_n(Ii,Qt.filter(n,Me,M,Nt,ye),D,F,mn,pn,qe(Qt.width*Te,3),Qt.stroke(n,M),Qt.dash,Qt.cap);let dr=T.grid;dr.show&&_n(Ii,dr.filter(n,Me,M,Nt,ye),D,D==0?2:1,D==0?E:L,D==0?ft:j,qe(dr.width*Te,3),dr.stroke(n,M),dr.dash,dr.cap),qt.show&&_n([mn],[1],D==0?1:0,D==0?1:2,D==1?E:L,D==1?ft:j,qe(qt.width*Te,3),qt.stroke(n,M),qt.dash,qt.cap)}Nn("drawAxes")}function de(M){x.forEach((T,F)=>{F>0&&(T._paths=null,M&&(r==1?(T.min=null,T.max=null):T.facets.forEach(D=>{D.min=null,D.max=null})))})}let dn=!1,Qn=!1,Oe=[];function bn(){Qn=!1;for(let M=0;M<Oe.length;M++)Nn(...Oe[M]);Oe.length=0}function jn(){dn||(Fw(Mm),dn=!0)}function Yl(M,T=!1){dn=!0,Qn=T,M(n),Mm(),T&&Oe.length>0&&queueMicrotask(bn)}n.batch=Yl;function Mm(){if(at&&(me(),at=!1),wt&&(Et(),wt=!1),_t){if(en(d,yo,Xt),en(d,"top",ce),en(d,Ta,k),en(d,Ra,xt),en(m,yo,Xt),en(m,"top",ce),en(m,Ta,k),en(m,Ra,xt),en(f,Ta,Ze),en(f,Ra,on),u.width=Tn(Ze*Te),u.height=Tn(on*Te),b.forEach(({_el:M,_show:T,_size:F,_pos:D,side:q})=>{if(M!=null)if(T){let K=q===3||q===0?F:0,lt=q%2==1;en(M,lt?"left":"top",D-K),en(M,lt?"width":"height",F),en(M,lt?"top":"left",lt?ce:Xt),en(M,lt?"height":"width",lt?xt:k),Pf(M,Fs)}else vi(M,Fs)}),oo=Yr=ao=H=Q=Y=Z=Tt=R=null,It=1,Sa(!0),Xt!=At||ce!=He||k!=Ht||xt!=jt){de(!1);let M=k/Ht,T=xt/jt;if(dt&&!nt&&ct.left>=0){ct.left*=M,ct.top*=T,co&&pr(co,Tn(ct.left),0,k,xt),uo&&pr(uo,0,Tn(ct.top),k,xt);for(let F=0;F<fe.length;F++){let D=fe[F];D!=null&&(Ke[F]*=M,Jn[F]*=T,pr(D,Fi(Ke[F]),Fi(Jn[F]),k,xt))}}if(Qe.show&&!st&&Qe.left>=0&&Qe.width>0){Qe.left*=M,Qe.width*=M,Qe.top*=T,Qe.height*=T;for(let F in yf)en(po,F,Qe[F])}At=Xt,He=ce,Ht=k,jt=xt}Nn("setSize"),_t=!1}Ze>0&&on>0&&(h.clearRect(0,0,u.width,u.height),Nn("drawClear"),w.forEach(M=>M()),Nn("draw")),Qe.show&&st&&(Zl(Qe),st=!1),dt&&nt&&(Cs(null,!0,!1),nt=!1),ht.show&&ht.live&&mt&&(mf(),mt=!1),l||(l=!0,n.status=1,Nn("ready")),jr=!1,dn=!1}n.redraw=(M,T)=>{wt=T||!1,M!==!1?Kr(A,I.min,I.max):jn()};function ff(M,T){let F=v[M];if(F.from==null){if(fn==0){let D=F.range(n,T.min,T.max,M);T.min=D[0],T.max=D[1]}if(T.min>T.max){let D=T.min;T.min=T.max,T.max=D}if(fn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;M==A&&F.distr==2&&fn>0&&(T.min=Xi(T.min,t[0]),T.max=Xi(T.max,t[0]),T.min==T.max&&T.max++),O[M]=T,at=!0,jn()}}n.setScale=ff;let df,pf,co,uo,Sm,Am,ho,fo,Em,Tm,Je,rn,Zr=!1,Vn=ct.drag,Ln=Vn.x,Fn=Vn.y;dt&&(ct.x&&(df=Li(iw,m)),ct.y&&(pf=Li(rw,m)),I.ori==0?(co=df,uo=pf):(co=pf,uo=df),Je=ct.left,rn=ct.top);let Qe=n.select=Mn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),po=Qe.show?Li(nw,Qe.over?m:d):null;function Zl(M,T){if(Qe.show){for(let F in M)Qe[F]=M[F],F in yf&&en(po,F,M[F]);T!==!1&&Nn("setSelect")}}n.setSelect=Zl;function Ib(M){if(x[M].show)J&&Pf(Kt[M],Fs);else if(J&&vi(Kt[M],Fs),dt){let F=Ct?fe[0]:fe[M];F!=null&&pr(F,-10,-10,k,xt)}}function Kr(M,T,F){ff(M,{min:T,max:F})}function ur(M,T,F,D){T.focus!=null&&Ob(M),T.show!=null&&x.forEach((q,K)=>{K>0&&(M==K||M==null)&&(q.show=T.show,Ib(K),r==2?(Kr(q.facets[0].scale,null,null),Kr(q.facets[1].scale,null,null)):Kr(q.scale,null,null),jn())}),F!==!1&&Nn("setSeries",M,T),D&&Aa("setSeries",n,M,T)}n.setSeries=ur;function Lb(M,T){Mn(S[M],T)}function Fb(M,T){M.fill=_e(M.fill||null),M.dir=Se(M.dir,-1),T=T??S.length,S.splice(T,0,M)}function Nb(M){M==null?S.length=0:S.splice(M,1)}n.addBand=Fb,n.setBand=Lb,n.delBand=Nb;function Db(M,T){x[M].alpha=T,dt&&fe[M]!=null&&(fe[M].style.opacity=T),J&&Kt[M]&&(Kt[M].style.opacity=T)}let Ir,Jr,Rs,mo={focus:!0};function Ob(M){if(M!=Rs){let T=M==null,F=kt.alpha!=1;x.forEach((D,q)=>{if(r==1||q>0){let K=T||q==0||q==M;D._focus=T?null:K,F&&Db(q,K?1:kt.alpha)}}),Rs=M,F&&jn()}}J&&ne&&te(Km,bt,M=>{ct._lock||(ee(M),Rs!=null&&ur(null,mo,!0,wn.setSeries))});function hr(M,T,F){let D=v[T];F&&(M=M/Te-(D.ori==1?ce:Xt));let q=k;D.ori==1&&(q=xt,M=q-M),D.dir==-1&&(M=q-M);let K=D._min,lt=D._max,pt=M/q,Mt=K+(lt-K)*pt,Nt=D.distr;return Nt==3?_o(10,Mt):Nt==4?bw(Mt,D.asinh):Nt==100?D.bwd(Mt):Mt}function Ub(M,T){let F=hr(M,A,T);return Xi(F,t[0],yn,xn)}n.valToIdx=M=>Xi(M,t[0]),n.posToIdx=Ub,n.posToVal=hr,n.valToPos=(M,T,F)=>v[T].ori==0?s(M,v[T],F?j:k,F?L:0):o(M,v[T],F?ft:xt,F?E:0),n.setCursor=(M,T,F)=>{Je=M.left,rn=M.top,Cs(null,T,F)};function Rm(M,T){en(po,yo,Qe.left=M),en(po,Ta,Qe.width=T)}function Cm(M,T){en(po,"top",Qe.top=M),en(po,Ra,Qe.height=T)}let wa=I.ori==0?Rm:Cm,Ma=I.ori==1?Rm:Cm;function kb(){if(J&&ht.live)for(let M=r==2?1:0;M<x.length;M++){if(M==0&&oe)continue;let T=ht.values[M],F=0;for(let D in T)zt[M][F++].firstChild.nodeValue=T[D]}}function mf(M,T){if(M!=null&&(M.idxs?M.idxs.forEach((F,D)=>{tt[D]=F}):Aw(M.idx)||tt.fill(M.idx),ht.idx=tt[0]),J&&ht.live){for(let F=0;F<x.length;F++)(F>0||r==1&&!oe)&&Bb(F,tt[F]);kb()}mt=!1,T!==!1&&Nn("setLegend")}n.setLegend=mf;function Bb(M,T){let F=x[M],D=M==0&&U==2?mi:t[M],q;oe?q=F.values(n,M,T)??Jt:(q=F.value(n,T==null?null:D[T],M,T),q=q==null?Jt:{_:q}),ht.values[M]=q}function Cs(M,T,F){Em=Je,Tm=rn,[Je,rn]=ct.move(n,Je,rn),ct.left=Je,ct.top=rn,dt&&(co&&pr(co,Tn(Je),0,k,xt),uo&&pr(uo,0,Tn(rn),k,xt));let D,q=yn>xn;Ir=We,Jr=null;let K=I.ori==0?k:xt,lt=I.ori==1?k:xt;if(Je<0||fn==0||q){D=ct.idx=null;for(let pt=0;pt<x.length;pt++){let Mt=fe[pt];Mt!=null&&pr(Mt,-10,-10,k,xt)}ne&&ur(null,mo,!0,M==null&&wn.setSeries),ht.live&&(tt.fill(D),mt=!0)}else{let pt,Mt,Nt;r==1&&(pt=I.ori==0?Je:rn,Mt=hr(pt,A),D=ct.idx=Xi(Mt,t[0],yn,xn),Nt=z(t[0][D],I,K,0));let Dt=-10,Ut=-10,ae=0,Ee=0,Me=!0,ye="",Qt="";for(let qt=r==2?1:0;qt<x.length;qt++){let tn=x[qt],pn=tt[qt],Dn=pn==null?null:r==1?t[qt][pn]:t[qt][1][pn],ke=ct.dataIdx(n,qt,D,Mt),mn=ke==null?null:r==1?t[qt][ke]:t[qt][1][ke];if(mt=mt||mn!=Dn||ke!=pn,tt[qt]=ke,qt>0&&tn.show){let gi=ke==null?-10:ke==D?Nt:z(r==1?t[0][ke]:t[qt][0][ke],I,K,0),ti=mn==null?-10:C(mn,r==1?v[tn.scale]:v[tn.facets[1].scale],lt,0);if(ne&&mn!=null){let Pi=I.ori==1?Je:rn,Wi=Rn(kt.dist(n,qt,ke,ti,Pi));if(Wi<Ir){let fr=kt.bias;if(fr!=0){let yi=hr(Pi,tn.scale),Ii=mn>=0?1:-1,qi=yi>=0?1:-1;qi==Ii&&(qi==1?fr==1?mn>=yi:mn<=yi:fr==1?mn<=yi:mn>=yi)&&(Ir=Wi,Jr=qt)}else Ir=Wi,Jr=qt}}if(mt||Ct){let Pi,Wi;I.ori==0?(Pi=gi,Wi=ti):(Pi=ti,Wi=gi);let fr,yi,Ii,qi,dr,ei,xi=!0,Ps=ut.bbox;if(Ps!=null){xi=!1;let ni=Ps(n,qt);Ii=ni.left,qi=ni.top,fr=ni.width,yi=ni.height}else Ii=Pi,qi=Wi,fr=yi=ut.size(n,qt);if(ei=ut.fill(n,qt),dr=ut.stroke(n,qt),Ct)qt==Jr&&Ir<=kt.prox&&(Dt=Ii,Ut=qi,ae=fr,Ee=yi,Me=xi,ye=ei,Qt=dr);else{let ni=fe[qt];ni!=null&&(Ke[qt]=Ii,Jn[qt]=qi,rg(ni,fr,yi,xi),ng(ni,ei,dr),pr(ni,Fi(Ii),Fi(qi),k,xt))}}}}if(Ct){let qt=kt.prox,tn=Rs==null?Ir<=qt:Ir>qt||Jr!=Rs;if(mt||tn){let pn=fe[0];pn!=null&&(Ke[0]=Dt,Jn[0]=Ut,rg(pn,ae,Ee,Me),ng(pn,ye,Qt),pr(pn,Fi(Dt),Fi(Ut),k,xt))}}}if(Qe.show&&Zr)if(M!=null){let[pt,Mt]=wn.scales,[Nt,Dt]=wn.match,[Ut,ae]=M.cursor.sync.scales,Ee=M.cursor.drag;if(Ln=Ee._x,Fn=Ee._y,Ln||Fn){let{left:Me,top:ye,width:Qt,height:qt}=M.select,tn=M.scales[Ut].ori,pn=M.posToVal,Dn,ke,mn,gi,ti,Pi=pt!=null&&Nt(pt,Ut),Wi=Mt!=null&&Dt(Mt,ae);Pi&&Ln?(tn==0?(Dn=Me,ke=Qt):(Dn=ye,ke=qt),mn=v[pt],gi=z(pn(Dn,Ut),mn,K,0),ti=z(pn(Dn+ke,Ut),mn,K,0),wa(ji(gi,ti),Rn(ti-gi))):wa(0,K),Wi&&Fn?(tn==1?(Dn=Me,ke=Qt):(Dn=ye,ke=qt),mn=v[Mt],gi=C(pn(Dn,ae),mn,lt,0),ti=C(pn(Dn+ke,ae),mn,lt,0),Ma(ji(gi,ti),Rn(ti-gi))):Ma(0,lt)}else xf()}else{let pt=Rn(Em-Sm),Mt=Rn(Tm-Am);if(I.ori==1){let ae=pt;pt=Mt,Mt=ae}Ln=Vn.x&&pt>=Vn.dist,Fn=Vn.y&&Mt>=Vn.dist;let Nt=Vn.uni;Nt!=null?Ln&&Fn&&(Ln=pt>=Nt,Fn=Mt>=Nt,!Ln&&!Fn&&(Mt>pt?Fn=!0:Ln=!0)):Vn.x&&Vn.y&&(Ln||Fn)&&(Ln=Fn=!0);let Dt,Ut;Ln&&(I.ori==0?(Dt=ho,Ut=Je):(Dt=fo,Ut=rn),wa(ji(Dt,Ut),Rn(Ut-Dt)),Fn||Ma(0,lt)),Fn&&(I.ori==1?(Dt=ho,Ut=Je):(Dt=fo,Ut=rn),Ma(ji(Dt,Ut),Rn(Ut-Dt)),Ln||wa(0,K)),!Ln&&!Fn&&(wa(0,0),Ma(0,0))}if(Vn._x=Ln,Vn._y=Fn,M==null){if(F){if(zm!=null){let[pt,Mt]=wn.scales;wn.values[0]=pt!=null?hr(I.ori==0?Je:rn,pt):null,wn.values[1]=Mt!=null?hr(I.ori==1?Je:rn,Mt):null}Aa(wf,n,Je,rn,k,xt,D)}if(ne){let pt=F&&wn.setSeries,Mt=kt.prox;Rs==null?Ir<=Mt&&ur(Jr,mo,!0,pt):Ir>Mt?ur(null,mo,!0,pt):Jr!=Rs&&ur(Jr,mo,!0,pt)}}mt&&(ht.idx=D,mf()),T!==!1&&Nn("setCursor")}let Qr=null;Object.defineProperty(n,"rect",{get(){return Qr==null&&Sa(!1),Qr}});function Sa(M=!1){M?Qr=null:(Qr=m.getBoundingClientRect(),Nn("syncRect",Qr))}function Pm(M,T,F,D,q,K,lt){ct._lock||Zr&&M!=null&&M.movementX==0&&M.movementY==0||(gf(M,T,F,D,q,K,lt,!1,M!=null),M!=null?Cs(null,!0,!0):Cs(T,!0,!1))}function gf(M,T,F,D,q,K,lt,pt,Mt){if(Qr==null&&Sa(!1),ee(M),M!=null)F=M.clientX-Qr.left,D=M.clientY-Qr.top;else{if(F<0||D<0){Je=-10,rn=-10;return}let[Nt,Dt]=wn.scales,Ut=T.cursor.sync,[ae,Ee]=Ut.values,[Me,ye]=Ut.scales,[Qt,qt]=wn.match,tn=T.axes[0].side%2==1,pn=I.ori==0?k:xt,Dn=I.ori==1?k:xt,ke=tn?K:q,mn=tn?q:K,gi=tn?D:F,ti=tn?F:D;if(Me!=null?F=Qt(Nt,Me)?a(ae,v[Nt],pn,0):-10:F=pn*(gi/ke),ye!=null?D=qt(Dt,ye)?a(Ee,v[Dt],Dn,0):-10:D=Dn*(ti/mn),I.ori==1){let Pi=F;F=D,D=Pi}}Mt&&(T==null||T.cursor.event.type==wf)&&((F<=1||F>=k-1)&&(F=Is(F,k)),(D<=1||D>=xt-1)&&(D=Is(D,xt))),pt?(Sm=F,Am=D,[ho,fo]=ct.move(n,F,D)):(Je=F,rn=D)}let yf={width:0,height:0,left:0,top:0};function xf(){Zl(yf,!1)}let Im,Lm,Fm,Nm;function Dm(M,T,F,D,q,K,lt){Zr=!0,Ln=Fn=Vn._x=Vn._y=!1,gf(M,T,F,D,q,K,lt,!0,!1),M!=null&&(te(Mf,Rf,Om,!1),Aa(Ym,n,ho,fo,k,xt,null));let{left:pt,top:Mt,width:Nt,height:Dt}=Qe;Im=pt,Lm=Mt,Fm=Nt,Nm=Dt}function Om(M,T,F,D,q,K,lt){Zr=Vn._x=Vn._y=!1,gf(M,T,F,D,q,K,lt,!1,!0);let{left:pt,top:Mt,width:Nt,height:Dt}=Qe,Ut=Nt>0||Dt>0,ae=Im!=pt||Lm!=Mt||Fm!=Nt||Nm!=Dt;if(Ut&&ae&&Zl(Qe),Vn.setScale&&Ut&&ae){let Ee=pt,Me=Nt,ye=Mt,Qt=Dt;if(I.ori==1&&(Ee=Mt,Me=Dt,ye=pt,Qt=Nt),Ln&&Kr(A,hr(Ee,A),hr(Ee+Me,A)),Fn)for(let qt in v){let tn=v[qt];qt!=A&&tn.from==null&&tn.min!=We&&Kr(qt,hr(ye+Qt,qt),hr(ye,qt))}xf()}else ct.lock&&(ct._lock=!ct._lock,Cs(T,!0,M!=null));M!=null&&(Ye(Mf,Rf),Aa(Mf,n,Je,rn,k,xt,null))}function zb(M,T,F,D,q,K,lt){if(ct._lock)return;ee(M);let pt=Zr;if(Zr){let Mt=!0,Nt=!0,Dt=10,Ut,ae;I.ori==0?(Ut=Ln,ae=Fn):(Ut=Fn,ae=Ln),Ut&&ae&&(Mt=Je<=Dt||Je>=k-Dt,Nt=rn<=Dt||rn>=xt-Dt),Ut&&Mt&&(Je=Je<ho?0:k),ae&&Nt&&(rn=rn<fo?0:xt),Cs(null,!0,!0),Zr=!1}Je=-10,rn=-10,tt.fill(null),Cs(null,!0,!0),pt&&(Zr=pt)}function Um(M,T,F,D,q,K,lt){ct._lock||(ee(M),ba(),xf(),M!=null&&Aa(Jm,n,Je,rn,k,xt,null))}function km(){b.forEach(VM),B(n.width,n.height,!0)}Ns(sc,vo,km);let go={};go.mousedown=Dm,go.mousemove=Pm,go.mouseup=Om,go.dblclick=Um,go.setSeries=(M,T,F,D)=>{let q=wn.match[2];F=q(n,T,F),F!=-1&&ur(F,D,!0,!1)},dt&&(te(Ym,m,Dm),te(wf,m,Pm),te(Zm,m,M=>{ee(M),Sa(!1)}),te(Km,m,zb),te(Jm,m,Um),Of.add(n),n.syncRect=Sa);let Kl=n.hooks=i.hooks||{};function Nn(M,T,F){Qn?Oe.push([M,T,F]):M in Kl&&Kl[M].forEach(D=>{D.call(null,n,T,F)})}(i.plugins||[]).forEach(M=>{for(let T in M.hooks)Kl[T]=(Kl[T]||[]).concat(M.hooks[T])});let Bm=(M,T,F)=>F,wn=Mn({key:null,setSeries:!1,filters:{pub:cg,sub:cg},scales:[A,x[1]?x[1].scale:null],match:[ug,ug,Bm],values:[null,null]},ct.sync);wn.match.length==2&&wn.match.push(Bm),ct.sync=wn;let zm=wn.key,vf=o0(zm);function Aa(M,T,F,D,q,K,lt){wn.filters.pub(M,T,F,D,q,K,lt)&&vf.pub(M,T,F,D,q,K,lt)}vf.sub(n);function Vb(M,T,F,D,q,K,lt){wn.filters.sub(M,T,F,D,q,K,lt)&&go[M](null,T,F,D,q,K,lt)}n.pub=Vb;function Gb(){vf.unsub(n),Of.delete(n),xe.clear(),If(sc,vo,km),c.remove(),bt?.remove(),Nn("destroy")}n.destroy=Gb;function _f(){Nn("init",i,t),_a(t||i.data,!1),O[A]?ff(A,O[A]):ba(),st=Qe.show&&(Qe.width>0||Qe.height>0),nt=mt=!0,B(i.width,i.height)}return x.forEach(so),b.forEach(Tr),e?e instanceof HTMLElement?(e.appendChild(c),_f()):e(n,_f):_f(),n}ln.assign=Mn;ln.fmtNum=Hf;ln.rangeNum=oc;ln.rangeLog=cc;ln.rangeAsinh=Vf;ln.orient=Os;ln.pxRatio=Te;ln.join=Lw;ln.fmtDate=qf,ln.tzDate=Hw;ln.sync=o0;{ln.addGap=AM,ln.clipGaps=fc;let i=ln.paths={points:f0};i.linear=p0,i.stepped=RM,i.bars=CM,i.spline=IM}var x0=["--blue","--red","--green","--violet","--ochre","--sky"],GM={real:"--blue",reference:"--red",rigid:"--quiet",stationary:"--green",oscillatory:"--violet",limit:"--quiet",other:"--ochre"},v0={real:[],reference:[6,3],rigid:[2,3],stationary:[9,2,2,2],oscillatory:[2,2],limit:[1,3],other:[10,3]},_0=[[],[7,2],[6,2,2,2],[2,2],[9,2,2,2,2,2],[12,4]],ns={real:"actual",reference:"nominal",rigid:"rigid",stationary:"quasi-static part",oscillatory:"oscillatory part",limit:"limit",other:"other"};function Fa(i,t,e,n){if(!e)return{property:GM[i],dash:v0[i]};let r=n>1?v0[i]:_0[t%_0.length];return{property:x0[t%x0.length],dash:r}}var Jf=new Map,b0=null,w0=!1;function gn(i){b0??=matchMedia("(prefers-color-scheme: dark)");let t=b0.matches&&!document.documentElement.classList.contains("printing");t!==w0&&Jf.clear(),w0=t;let e=Jf.get(i)??getComputedStyle(document.documentElement).getPropertyValue(i).trim();return Jf.set(i,e),e||"#808080"}function Na({data:i,shape:[,t]},e,n){let r=[0,0,0];for(let o=0;o<3*t;o+=1)r[o%3]+=i[3*t*e+o];let s=Math.hypot(...r);return n<0||s===0?s:r.reduce((o,a,l)=>o+a*i[3*(t*e+n)+l],0)/s}function M0(i,t,e,n){let[r,s]=n??e.span??[i[0],i[i.length-1]],o=1e-9*Math.max(1,Math.abs(s)),a=HM(i,Array.from(i.keys()).filter(p=>i[p]>=r-o&&i[p]<=s+o)),l=Float64Array.from(a,p=>t[p]),c=l.length;if(c<4)return{x:new Float64Array,y:new Float64Array};let u=(i[a[c-1]]-i[a[0]])/(c-1),h=WM(l),f=2**Math.ceil(Math.log2(4*c)),d=new Float64Array(f),m=new Float64Array(f);d.set(l),qM(d,m);let y=e.at.data[e.at.data.length-1],g=Math.min(f/2,Math.floor(y*f*u)+1);return{x:Float64Array.from({length:g},(p,x)=>x/(f*u)),y:Float64Array.from({length:g},(p,x)=>2*Math.hypot(d[x],m[x])/h)}}function HM(i,t){if(t.length<3)return t;let e=r=>i[t[r]]-i[t[r-1]];return Math.abs(e(t.length-1)/e(1)-1)>1e-6?t.slice(0,-1):t}function WM(i){let t=i.length,e=(t-1)/2,n=i.reduce((a,l)=>a+l,0)/t,r=t*(t*t-1)/12,s=i.reduce((a,l,c)=>a+(c-e)*l,0)/r,o=0;for(let a=0;a<t;a+=1){let l=.5-.5*Math.cos(2*Math.PI*a/t);i[a]=l*(i[a]-n-s*(a-e)),o+=l}return o}function qM(i,t){let e=i.length;for(let r=1,s=0;r<e;r+=1){let o=e>>1;for(;s&o;o>>=1)s^=o;s^=o,r<s&&([i[r],i[s]]=[i[s],i[r]],[t[r],t[s]]=[t[s],t[r]])}let n=$M(e);for(let r=2;r<=e;r*=2)XM(i,t,r,n)}var To=new Float64Array;function $M(i){if(To.length===i)return To;To=new Float64Array(i);for(let t=0;t<i/2;t+=1)To[2*t]=Math.cos(2*Math.PI*t/i),To[2*t+1]=-Math.sin(2*Math.PI*t/i);return To}function XM(i,t,e,n){let r=e/2,s=2*i.length/e;for(let o=0;o<i.length;o+=e)for(let a=0;a<r;a+=1){let l=o+a,c=l+r,u=n[s*a],h=n[s*a+1],f=i[c]*u-t[c]*h,d=i[c]*h+t[c]*u;i[c]=i[l]-f,t[c]=t[l]-d,i[l]+=f,t[l]+=d}}function E0(i){let t=new Map;return i.runs.forEach((e,n)=>e.charts.forEach(r=>{let s=t.get(r.id);s?s.runs.push({run:n,name:e.name,chart:r}):t.set(r.id,{chart:r,runs:[{run:n,name:e.name,chart:r}],compared:i.runs.length>1})})),[...t.values()]}function Qf(i,t){let e=i.runs.flatMap(({run:s,name:o,chart:a})=>(t&&s===0&&a.stacked?a.curves.slice(-1):a.curves).map(l=>({run:s,runName:o,label:l.label,role:l.role,x:a.at.data,y:l.values.data,shown:l.shown&&(i.runs.length<2||jM(l,a)),ghost:t!==null&&s===0})));if(t===null)return e;let n=i.runs.find(({run:s})=>s===0),r=(n?.chart.curves??[]).flatMap(s=>YM(s,n.chart,n.name,t));return[...e,...r]}function jM(i,t){return i.role==="real"&&i.label===t.curves[0].label}function YM(i,t,e,n){let r=ZM(i,n);if(r===null)return[];let s={run:0,runName:e,label:i.label,role:i.role,shown:i.shown,ghost:!1};if(t.abscissa==="time")return[{...s,x:n.times,y:r}];let o=null,a=()=>o??=M0(n.times,r,t,n.span);return[Object.defineProperties(s,{x:{get:()=>a().x},y:{get:()=>a().y}})]}function T0(i,t,e){return i.chart.group==="spectrum"&&t.vibration!==e.vibration?!1:i.runs.flatMap(({chart:r})=>r.curves.flatMap(({source:s})=>s?[s.variable,s.less?.variable??s.variable]:[])).every(r=>t.series[r]===e.series[r])}function ZM(i,t){let e=i.source;if(e===null)return null;let n=S0(t,e.variable,e.index,e.along),r=e.less?S0(t,e.less.variable,e.less.index):null;if(n===null||e.less&&r===null)return null;for(let s=0;s<n.length;s+=1)n[s]=e.factor*(n[s]-(r?r[s]:0));return n}function S0(i,t,e,n=!1){let r=i.series[t];if(r===void 0)return null;if(n)return Float64Array.from(i.times,(a,l)=>Na(r,l,e));let s=r.shape.slice(1).reduce((a,l)=>a*l,1);if(e>=s)return null;let o=new Float64Array(r.shape[0]);for(let a=0;a<o.length;a+=1)o[a]=r.data[a*s+e];return o}function gc(i,t){let e=[...new Set(i.map(r=>r.x))],n=e.every(r=>R0(r,e[0]))?e[0]:KM(e);return[n,...i.map(r=>JM(r,n,t))]}function R0(i,t){if(i===t)return!0;if(i.length!==t.length)return!1;for(let e=0;e<i.length;e+=1)if(Math.abs(i[e]-t[e])>1e-6*Math.abs(t[e]))return!1;return!0}function KM(i){let t=i.flatMap(e=>Array.from(e)).sort((e,n)=>e-n);return t.filter((e,n)=>n===0||e>t[n-1])}function JM(i,t,e){let n=o=>e?o===0?null:Math.abs(o):o;if(t===i.x||R0(t,i.x))return e?Array.from(i.y,n):i.y;let s=new Array(t.length).fill(null);for(let o=0,a=0;o<i.x.length;o+=1){for(;a<t.length&&t[a]<i.x[o];)a+=1;a<t.length&&(s[a]=n(i.y[o]))}return s}function C0(i,t){let{x:e,y:n}=i,r=e.length-1;if(r<0||t<e[0]-1e-9||t>e[r]+1e-6*Math.abs(e[r])+1e-9)return null;let s=0,o=r;for(;o-s>1;){let a=s+o>>1;e[a]<=t?s=a:o=a}return o===s||t>=e[o]?n[o]:n[s]+(n[o]-n[s])*(t-e[s])/(e[o]-e[s])}var A0=new WeakMap;function Ro(i){let t=A0.get(i);if(t)return t;let[e,n]=[1/0,-1/0];for(let s=0;s<i.length;s+=1){let o=i[s];Number.isFinite(o)&&(o<e&&(e=o),o>n&&(n=o))}let r=e<=n?[e,n]:[0,0];return A0.set(i,r),r}function P0(i,t,e){let[n,...r]=gc(i,!1),s=new Set(i.map(l=>l.run)).size>1,o=i.map(l=>`${[s?l.runName:"",l.label,ns[l.role],l.ghost?"original":""].filter(Boolean).join(" ")} [${e||"-"}]`),a=Array.from(n,(l,c)=>[l,...r.map(u=>u[c]??"")].map(QM).join(","));return`${[t,...o].map(tS).join(",")}
${a.join(`
`)}
`}function QM(i){return typeof i=="string"?i:String(Number(i.toPrecision(9)))}function tS(i){return`"${(/^[=+\-@\t\r]/.test(i)?`'${i}`:i).replaceAll('"','""')}"`}var[yc,Co]=[18,12];function I0(i,t,e,n){let r=td(n),s=document.createElement("canvas"),[o,a]=[i.width/t,i.height/t];s.width=i.width,s.height=i.height+t*yc*(r.length+2);let l=s.getContext("2d");return l&&(l.fillStyle=gn("--paper"),l.fillRect(0,0,s.width,s.height),l.drawImage(i,0,t*1.5*yc),l.scale(t,t),l.fillStyle=gn("--ink"),l.font="600 14px system-ui, sans-serif",l.fillText(e,Co,yc,o-2*Co),l.font="12px system-ui, sans-serif",r.forEach(({words:c,look:u},h)=>{let f=a+yc*(h+2);l.strokeStyle=gn(u.property),l.lineWidth=2,l.setLineDash(u.dash),l.beginPath(),l.moveTo(Co,f-4),l.lineTo(Co+26,f-4),l.stroke(),l.fillText(c,Co+34,f,o-Co-40)})),s}function td(i){let t=new Set;return i.filter(([{ghost:e}])=>!e).flatMap(([e,n])=>{let r=e.role==="real"?e.label:`${e.label}, ${ns[e.role]}`;return t.size<t.add(r).size?[{words:r,look:n}]:[]})}var[xc,ed,L0]=[18,12,28],eS=2;function F0({plot:i,titled:t,marks:e,looks:n,pieces:r,abscissa:s},o){let[a,l]=[i.width,i.height],c=td(n),u={left:i.bbox.left/o,top:i.bbox.top/o+1.5*xc,width:i.bbox.width/o,height:i.bbox.height/o},[h,f]=[u.left+u.width,u.top+u.height],d=S=>u.left+i.valToPos(S,"x"),m=S=>u.top+i.valToPos(S,"y"),y=l+xc*(c.length+2),g=[Da(ed,xc,t,"--ink",'font-weight="600" font-size="14"')],[p,x]=i.axes.map(nS);for(let[S,A]of p)d(S)<u.left-1||d(S)>h+1||(g.push(Oa(`M${Ve(d(S))} ${Ve(u.top)}V${Ve(f+4)}`,"--grid")),g.push(Da(d(S),f+17,A,"--quiet",'text-anchor="middle"')));for(let[S,A]of x)m(S)<u.top-1||m(S)>f+1||(g.push(Oa(`M${Ve(u.left-4)} ${Ve(m(S))}H${Ve(h)}`,"--grid")),g.push(Da(u.left-7,m(S)+4,A,"--quiet",'text-anchor="end"')));g.push(Da((u.left+h)/2,f+35,s,"--quiet",'text-anchor="middle"'));let b=r.map((S,A)=>iS(i,A+1,d,m,S)),v=e.map(S=>Oa(`M${Ve(d(S.at))} ${Ve(u.top)}V${Ve(f)}`,"--quiet",[3,3]));return g.push(`<svg x="${Ve(u.left)}" y="${Ve(u.top)}" width="${Ve(u.width)}" height="${Ve(u.height)}" viewBox="${[u.left,u.top,u.width,u.height].map(Ve).join(" ")}">${b.join("")}${v.join("")}</svg>`),c.forEach(({words:S,look:A},_)=>{let w=l+xc*(_+2);g.push(Oa(`M${ed} ${w-4}h26`,A.property,A.dash,2)),g.push(Da(ed+34,w,S,"--ink"))}),{width:a,height:y,content:g.join(`
`)}}function N0(i){let t=Math.min(2,i.length),e=Math.max(...i.map(({width:s})=>s))+L0,n=0,r=[];for(let s=0;s<i.length;s+=t){let o=i.slice(s,s+t);o.forEach((a,l)=>r.push(`<g transform="translate(${Ve(l*e)} ${Ve(n)})">${a.content}</g>`)),n+=Math.max(...o.map(({height:a})=>a))+(i.length>t?L0:0)}return`<svg xmlns="http://www.w3.org/2000/svg" width="${Ve(t*e)}" height="${Ve(n)}" viewBox="0 0 ${Ve(t*e)} ${Ve(n)}" font-family="system-ui, sans-serif" font-size="12">
<rect width="100%" height="100%" fill="${gn("--paper")}"/>
${r.join(`
`)}
</svg>
`}function nS(i){let{_splits:t,_values:e}=i;return(t??[]).flatMap((n,r)=>e?.[r]?[[n,e[r]]]:[])}function iS(i,t,e,n,r){let[s,o]=[i.data[0],i.data[t]],{min:a=-1/0,max:l=1/0}=i.scales.x,c=[],[u,h]=[0,0];for(let m=0;m<s.length;m+=1){let y=o[m],g=(s[m+1]??s[m])<a||(s[m-1]??s[m])>l;y==null||g||(h=e(s[m]),c.length||(u=h),c.push(`${Ve(h)} ${Ve(n(y))}`))}if(!c.length)return"";let f=`M${c.join("L")}`,d=r.ghost?' opacity="0.35"':"";return r.filled?`<path d="${f}L${Ve(h)} ${Ve(n(0))}L${Ve(u)} ${Ve(n(0))}Z" fill="${gn(r.property)}"/>`:`<g${d}>${Oa(f,r.property,r.dash,r.width)}</g>`}function Oa(i,t,e=[],n=1){let r=e.length?` stroke-dasharray="${e.join(" ")}"`:"";return`<path d="${i}" fill="none" stroke="${gn(t)}" stroke-width="${n}"${r}/>`}function Da(i,t,e,n,r=""){let s=e.replaceAll("&","&amp;").replaceAll("<","&lt;");return`<text x="${Ve(i)}" y="${Ve(t)}" fill="${gn(n)}" ${r}>${s}</text>`}function Ve(i){return String(Number(i.toFixed(eS)))}function D0(i){let t=(e,n,r)=>Be(e,()=>{let s=i();s&&setTimeout(()=>r(s))},{class:"tool",title:n});return[t("PNG","Save this chart as a picture",({plot:e,titled:n,looks:r,id:s})=>Ql(I0(e.ctx.canvas,ln.pxRatio,n,r),s)),t("SVG","Save this chart as a vector graphic",e=>id([nd(e)],e.id)),t("CSV","Save the data of this chart as CSV",({looks:e,abscissa:n,unit:r,id:s})=>Fr(P0(e.map(([o])=>o),n,r),`${s}.csv`,"text/csv"))]}function nd(i){return F0(i,ln.pxRatio)}function id(i,t){i.length&&Fr(N0(i),`${t}.svg`,"image/svg+xml")}var rS=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],sS=["m","rad","s"],oS=["Hz","%","rad/s"],rd={m:[10,1e3,"mm"],rad:[1,1e3,"mrad"],s:[1,1,"s"]},aS="⁰¹²³⁴⁵⁶⁷⁸⁹";function sd(i){let t=i.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(t)?"":t}function Pe(i,t=4){return i===0?"0":String(Number(i.toPrecision(t)))}function O0(i){if(i===0)return"0";let[t,e]=i.toExponential(1).split("e"),n=[...String(Number(e))].map(r=>r==="-"?"⁻":aS[Number(r)]).join("");return`${t} × 10${n}`}function Ua(i,t){let e=sd(i);if(!e||oS.includes(i)||!(t>0))return{factor:1,name:e};let n=rd[i];if(n)return t<n[0]?{factor:n[1],name:n[2]}:{factor:1,name:e};let r=sS.includes(i.split("/")[0]),s=rS.find(([o,a])=>t>=o&&(a>=1||!r));return s?{factor:s[1],name:s[2]+e}:{factor:1,name:e}}function Gn(i,t){if(i===null||!Number.isFinite(i))return"–";let e=Math.abs(i),{factor:n,name:r}=Ua(t,e);return`${e>0&&(n===1||t in rd?e*n<.001:e<1e-11)?O0(t in rd?i*n:i):Pe(i*n)} ${r}`.trimEnd()}function ri(i){let t=Math.abs(i);return t!==0&&(t<.001||t>=1e6)?O0(i):Pe(i)}function vc(i){let t=0,e=window.requestIdleCallback??(s=>window.setTimeout(s)),n=!1,r=()=>window.clearTimeout(t);return{ask(){r(),t=window.setTimeout(()=>e(()=>n||i()),400)},end(){n=!0,r()}}}function od(i,t,e){let n=e.filter(r=>!r.ghost).map(r=>{let[s,o]=Ro(r.y);return`${r.label} ${ns[r.role]}, from ${ri(s)} to ${ri(o)} ${t}`.trim()});return`${i.title}: ${n.join("; ")||"no curve is shown"}.`}function ad(i){return i.runs.map(t=>t.chart).reduce((t,e)=>_c(e)<_c(t)?e:t)}function _c(i){return i.at.data.length/i.samples}function U0(i){let[t,e]=[i.at.data.length,i.samples].map(n=>n.toLocaleString("en"));return`Drawn by ${t} of ${e} samples; every extreme is kept.`}function ld(i,t){return i.group!=="spectrum"||i.id==="spectrum_tip_nominal"?null:typeof t?.vibration=="object"?t.vibration.marks:null}function k0(i,t){let e=Math.max(0,...t.map(n=>n.x[n.x.length-1]??0));return i.filter(({at:n})=>n<=e)}function B0(i,t,e){let n=i.filter(d=>!d.ghost),r=[d=>String(d.run),d=>d.label,d=>d.role],s=r.map(d=>[...new Set(n.map(d))]),o=r.map((d,m)=>new Set(s[m].filter(y=>!n.some(g=>g.shown&&d(g)===y)))),a=t?0:s[1].length>1?1:2,l=s[2].length,c=d=>{let m=a===0&&s[1].length>1&&l===1?s[1].length:l,y=a===0?d.run:s[a].indexOf(r[a](d)),g=Fa(d.role,y,a<2,m);return a===0&&l===1?{...g,dash:Fa("real",s[1].indexOf(d.label),!0,1).dash}:g},u=rt("div",{class:"legend"}),h=new Map;r.forEach((d,m)=>{if(s[m].length<2&&m!==a)return;let y=rt("div",{class:"legend-row",role:"group","aria-label":["Runs","Curves","Parts"][m]});for(let g of s[m]){let p=n.find(x=>d(x)===g);p&&y.append(f(p,g,m))}u.append(y)});function f(d,m,y){let g=y===0?d.runName:y===2&&l>1?ns[d.role]:d.label,p=y===a?c(d):{property:"--quiet",dash:y===2?c(d).dash:[]},x=Jl(`var(${p.property})`,y===a&&a<2&&l>1?[]:p.dash),b=rt("span",{class:"value"}),v=rt("button",{type:"button",class:"toggle","aria-pressed":String(!o[y].has(m))},x,rt("span",{text:g}),b);return y===a&&h.set(m,b),v.addEventListener("click",()=>{o[y].delete(m)||o[y].add(m),v.setAttribute("aria-pressed",String(!o[y].has(m))),e()}),v}return{element:u,look:c,renew(d){n=d.filter(m=>!m.ghost)},shows:d=>r.every((m,y)=>!o[y].has(m(d))),tell(d){for(let[m,y]of h){let g=n.find(x=>r[a](x)===m&&r.every((b,v)=>!o[v].has(b(x)))),p=g?d(g):null;ze(y,p===null?"":ri(p).replace("-","−"))}}}}var z0="12px system-ui, sans-serif",V0=2;function G0(i,t,e,n){let r={stroke:()=>gn("--grid"),width:1},s={stroke:()=>gn("--quiet"),font:z0,grid:r,ticks:{...r,size:4}},o={width:Math.max(i.clientWidth,120),height:n.height,legend:{show:!1},padding:[10,14,0,0],scales:{x:{time:!1},y:n.log?{distr:3,range:(l,c,u)=>cS(c,u,n.decades)}:{range:(l,c,u)=>lS(c,u)}},axes:[{...s,label:n.abscissa,labelSize:18,labelFont:z0,size:30,values:(l,c)=>c.map(ri)},{...s,size:(l,c)=>16+7*Math.max(2,...(c??[]).map(u=>u.length)),values:(l,c)=>c.map(u=>u===null?"":n.log?uS(u):ri(u))}],series:[{},...e.map(l=>({stroke:()=>gn(l.property),width:l.width,dash:l.filled?[]:l.dash,fill:l.filled?()=>gn(l.property):void 0,alpha:l.ghost?.35:1,spanGaps:!0,points:{show:!1}}))],cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!0,dist:V0},bind:{mousedown:(l,c,u)=>h=>h.shiftKey?u(h):null,dblclick:()=>()=>(n.zoomed(null),null)}},hooks:{setSelect:[l=>hS(l,n)],setCursor:[l=>n.hovered(l.cursor.left===void 0||l.cursor.left<0?null:l.posToVal(l.cursor.left,"x"))],draw:[l=>dS(l,n.marks)]}},a=new ln(o,t,i);return fS(a,n),a}function lS(i,t){if(i===null||t===null||!Number.isFinite(i)||!Number.isFinite(t))return[0,1];let e=Math.max(Math.abs(i),Math.abs(t)),n=e>1e-9?.05*e:.05;if(t-i<=1e-9*e||e<=1e-12)return[(i+t)/2-n,(i+t)/2+n];let r=.07*(t-i);return[i-r,t+r]}function cS(i,t,e){if(i===null||t===null||!(t>0))return[.1,1];let n=Math.max(i>0?i:t,t*10**-e);return[10**Math.floor(Math.log10(n)+1e-9),t*1.6]}function uS(i){let t=Math.log10(i);return Math.abs(t-Math.round(t))>1e-6?"":ri(i).replace(/^1\u00a0×\u00a0|^1\.0\u00a0×\u00a0/,"")}function hS(i,t){i.select.width<V0||(t.zoomed([i.posToVal(i.select.left,"x"),i.posToVal(i.select.left+i.select.width,"x")]),i.setSelect({left:0,top:0,width:0,height:0},!1))}function fS(i,t){let e=i.over,n=r=>t.chosen(i.posToVal(r.clientX-e.getBoundingClientRect().left,"x"));e.addEventListener("pointerdown",r=>{r.shiftKey||r.button!==0||(e.setPointerCapture(r.pointerId),n(r))}),e.addEventListener("pointermove",r=>{e.hasPointerCapture(r.pointerId)&&n(r)})}function dS(i,t){let{ctx:e,bbox:n}=i,r=ln.pxRatio,s=-1/0;e.save(),e.fillStyle=gn("--quiet"),e.font=`${11*r}px system-ui, sans-serif`,e.lineJoin="round";for(let{at:o}of t){let a=i.valToPos(o,"x",!0);if(a<n.left||a>n.left+n.width)continue;[e.strokeStyle,e.lineWidth]=[gn("--quiet"),r],e.setLineDash([3*r,3*r]),e.beginPath(),e.moveTo(a,n.top),e.lineTo(a,n.top+n.height),e.stroke(),[e.strokeStyle,e.lineWidth]=[gn("--panel"),4*r],e.setLineDash([]);let l=`${ri(Number(o.toPrecision(3)))} Hz`;if(a>s&&a+e.measureText(l).width<n.left+n.width){let c=[l,a+3*r,n.top+11*r];e.strokeText(...c),e.fillText(...c),s=a+e.measureText(l).width+8*r}}e.restore()}var H0="total",pS=.05;function W0(i,t,e){let n=i.map((s,o)=>({entry:s,values:t[o],filled:!1}));if(!e)return n;let r=[];for(let s of[1,-1]){let o=new Float64Array(t[0]?.length??0);for(let{entry:a,values:l}of n)a.label!==H0&&(o=o.map((c,u)=>c+s*Math.max(0,s*(l[u]??0))),r.unshift({entry:a,values:o,filled:!0}))}return[...r,...n.filter(({entry:s})=>s.label===H0)]}function q0(i,t){let e=i.map(({y:c})=>Ro(c)),[n,r]=[Math.min(...e.map(([c])=>c)),Math.max(...e.map(([,c])=>c))],s=Math.max(Math.abs(n),Math.abs(r));if(!(r-n<pS*s)||r-n<=1e-9*s)return"";let[o,a]=[n,r].map(c=>String(Number(c.toPrecision(6)))),l=Number((100*(r-n)/s).toPrecision(2));return`The axis does not start at zero: ${o} to ${a} ${t}, ${l} % apart.`}var $0={spectrum:5,other:6},mS=190,gS=1e-9,yS=100;function X0(i,t,e){let{chart:n}=i,r=n.abscissa==="time",s=Lr("chart"),o=r?"time [s]":"frequency [Hz]",a=n.unit==="–"?"":n.unit,l=n.log==="first",c=null,u=!0,h=Qf(i,null),f=n.marks,d=0,m=null,y=null,g=null,p=!1,x=!0,b=[],v="",S=0,A=0,_=0,w=vc(dt),N=rt("div",{class:"plot-area",role:"img"}),P=rt("span",{class:"readout"}),I=Be("log",()=>ht(!l),{class:"tool","aria-pressed":String(l),title:"Logarithmic ordinate, of the size of the values",hidden:n.log==="no"}),U=Be("reset zoom",()=>e.set(null),{class:"tool",hidden:!0}),z=rt("div",{class:"tools"},U,I,...D0(oe)),C=`${n.title}${a?` [${a}]`:""}`,O=rt("span",{class:"unit",text:C.slice(n.title.length)}),W=rt("h4",{id:s,text:n.title},O),G=rt("p",{class:"note",hidden:!r||_c(ad(i))>=1,text:U0(ad(i))}),et=rt("p",{class:"note",hidden:!0,text:"The marked frequencies are of the run as it was."}),$=rt("p",{class:"note",hidden:!0}),X=B0(h,i.compared,ct),tt=rt("figure",{class:"chart","aria-labelledby":s,"data-chart":n.id},rt("figcaption",{},W,P,z),N,X.element,$,G,et);function ht(Ft){l=Ft,I.setAttribute("aria-pressed",String(Ft)),ct()}function ct(){x=!0,p?dt():w.ask()}function J(){if(u)return h;u=!0,h=Qf(i,c);let Ft=ld(n,c);return f=Ft?k0(Ft,h):n.marks,X.renew(h),h}function dt(){if(!x||d===0)return;x=!1;let Ft=le(),[xe,...te]=gc(Ft,l),Ye=W0(Ft,te,n.stacked===!0);b=Ye.map(({entry:xt,filled:Xt})=>({...X.look(xt),width:Xt?0:xt.ghost?1:xt.role==="real"?1.6:1.3,ghost:xt.ghost,filled:Xt}));let Ze=[xe,...Ye.map(({values:xt})=>xt)],on=l?"":q0(Ft,a);ze($,on),$.hidden=!on,A=Math.max(0,...Ft.map(xt=>Math.max(...Ro(xt.y).map(Math.abs))));let k=JSON.stringify([b,f,l,d,S]);m&&k===v?m.setData(Ze):gt(Ze,b),v=k,N.setAttribute("aria-label",od(n,a,Ft)),r&&bt(e.range),Kt()}function gt(Ft,xe){m?.destroy(),g=null,m=G0(N,Ft,xe,{log:l,decades:n.group==="spectrum"?$0.spectrum:$0.other,height:mS,marks:f,abscissa:o,zoomed:te=>r?e.set(te):bt(te),hovered:te=>{g=te,Kt()},chosen:te=>{r&&t.seek(te)}}),y=r?rt("div",{class:"time-line"}):null,y&&m.over.append(y)}function bt(Ft){let xe=m?.data[0];if(U.hidden=Ft===null,!m||!xe?.length)return;let[te,Ye]=Ft??[xe[0],xe[xe.length-1]];Ye>te&&m.setScale("x",{min:te,max:Ye}),queueMicrotask(yt)}function yt(){if(!m||!y)return;let Ft=m.valToPos(t.time,"x"),xe=m.valToPos(m.scales.x.max??0,"x"),te=Ft>=-.5&&Ft<=xe+.5;y.style.display=te?"":"none",y.style.transform=`translateX(${Ft}px)`}function Gt(){yt(),(!t.playing||performance.now()-_>yS)&&Kt()}function Kt(){_=performance.now();let Ft=g??(r?t.time:null);ze(P,g===null?"":r?`at ${g.toFixed(3)} s`:`at ${Gn(g,"Hz")}`),X.tell(xe=>Ft===null?null:zt(C0(xe,Ft)))}function zt(Ft){return Ft!==null&&Math.abs(Ft)<gS*A&&!l?0:Ft}let le=()=>J().filter(Ft=>X.shows(Ft));function oe(){dt();let Ft=le().map(xe=>[xe,X.look(xe)]);return m&&{id:n.id,titled:C,unit:a,abscissa:o,plot:m,marks:f,pieces:b,looks:Ft}}let Jt=new IntersectionObserver(Ft=>{p=Ft.some(xe=>xe.isIntersecting),p&&dt(),p&&Gt()},{rootMargin:"120px"}),Fe=new ResizeObserver(()=>{d=N.clientWidth,d>0&&ct()}),Ae=()=>{S+=1,x=!0,dt()};for(let Ft of["beforeprint","afterprint"])addEventListener(Ft,Ae);Jt.observe(tt),N.setAttribute("aria-label",od(n,a,h.filter(Ft=>X.shows(Ft)))),Fe.observe(N);let hn=[t.subscribe(()=>{p&&r&&Gt()}),e.subscribe(()=>r&&bt(e.range))];return{element:tt,id:n.id,state:oe,show(Ft){c=Ft,u=!1,et.hidden=Ft===null||ld(n,Ft)!==null||n.marks.length===0,ct()},recolour(){S+=1,ct()},dispose(){for(let Ft of["beforeprint","afterprint"])removeEventListener(Ft,Ae);w.end(),Jt.disconnect(),Fe.disconnect(),hn.forEach(Ft=>Ft()),m?.destroy()}}}function j0(){let i=new Set,t={range:null};return{get range(){return t.range},set(e){e===t.range||e&&t.range&&e.every((r,s)=>r===t.range?.[s])||(t.range=e,i.forEach(r=>r()))},subscribe(e){return i.add(e),()=>i.delete(e)}}}var Y0={overview:"Overview",error:"Error",tip:"Tip",contact:"Contact",deformations:"Deformations",motors:"Motors",energy:"Energy",spectrum:"Spectrum",all:"All"};function K0(i,t,e){let n=E0(t),r=j0(),s=rt("div",{class:"chart-grid",id:"tm-charts",role:"tabpanel",tabindex:"0"}),o=rt("div",{class:"tabs",role:"tablist","aria-label":"Charts"}),a=rt("p",{class:"note hint",text:"Click or drag: the time. Shift and drag: zoom, double click: back. Keys: space, arrows, and , . by sample."}),l=Object.keys(Y0).filter(p=>Z0(n,p).length>0),c=[],u=[],h="overview",f=null;for(let p of l){let x=Be(Y0[p],()=>d(p),{role:"tab",id:`tm-tab-${p}`,"aria-controls":"tm-charts","data-group":p});o.append(x)}o.addEventListener("keydown",p=>{let x={ArrowRight:1,ArrowLeft:-1}[p.key],b=l.findIndex(v=>`tm-tab-${v}`===p.target.id);x===void 0||b<0||(p.preventDefault(),p.stopPropagation(),d(l[(b+x+l.length)%l.length]),o.querySelector("[aria-selected=true]")?.focus())});function d(p){u.forEach(x=>x.dispose()),h=p,c=Z0(n,p),u=c.map(x=>X0(x,e,r)),f&&u.forEach(x=>x.show(f));for(let x of o.querySelectorAll("button")){let b=x.dataset.group===p;x.setAttribute("aria-selected",String(b)),x.tabIndex=b?0:-1}s.setAttribute("aria-labelledby",`tm-tab-${p}`),s.replaceChildren(...u.map(x=>x.element))}let m=Be("Save all of these (SVG)",()=>{let p=u.flatMap(x=>x.state()??[]);setTimeout(()=>id(p.map(nd),`charts_${h}`))},{class:"tool",title:"Save the charts of this tab as one vector graphic"}),y=matchMedia("(prefers-color-scheme: dark)"),g=()=>u.forEach(p=>p.recolour());return y.addEventListener("change",g),i.append(rt("div",{class:"tab-bar"},o),s,m,a),d("overview"),{renew:()=>d(h),show(p){let x=f;f=p,u.forEach((b,v)=>{(!p||!x||!T0(c[v],x,p))&&b.show(p)})},dispose(){y.removeEventListener("change",g),u.forEach(p=>p.dispose()),i.replaceChildren()}}}function Z0(i,t){return t==="all"?i:t!=="overview"?i.filter(({chart:e})=>e.group===t):i.filter(({chart:e},n)=>i.findIndex(r=>r.chart.group===e.group)===n)}var J0='"use strict";(()=>{var co=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],fo=["m","rad","s"],mo=["Hz","%","rad/s"],Tt={m:[10,1e3,"mm"],rad:[1,1e3,"mrad"],s:[1,1,"s"]},ho="⁰¹²³⁴⁵⁶⁷⁸⁹";function po(s){let e=s.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(e)?"":e}function K(s,e=4){return s===0?"0":String(Number(s.toPrecision(e)))}function go(s){if(s===0)return"0";let[e,r]=s.toExponential(1).split("e"),t=[...String(Number(r))].map(o=>o==="-"?"⁻":ho[Number(o)]).join("");return`${e} × 10${t}`}function yo(s,e){let r=po(s);if(!r||mo.includes(s)||!(e>0))return{factor:1,name:r};let t=Tt[s];if(t)return e<t[0]?{factor:t[1],name:t[2]}:{factor:1,name:r};let o=fo.includes(s.split("/")[0]),n=co.find(([i,a])=>e>=i&&(a>=1||!o));return n?{factor:n[1],name:n[2]+r}:{factor:1,name:r}}function V(s,e){if(s===null||!Number.isFinite(s))return"–";let r=Math.abs(s),{factor:t,name:o}=yo(e,r);return`${r>0&&(t===1||e in Tt?r*t<.001:r<1e-11)?go(e in Tt?s*t:s):K(s*t)} ${o}`.trimEnd()}function de(s){let{settings:e,status:r}=s,{statuses:t,limits:o}=s.layout,n=`t = ${K(s.time,6)} s`;if(r===t.finished)return["finished",`completed at t = ${K(e.duration,6)} s`];if(r===t.running)return["stopped",`stopped at ${n} of ${K(e.duration,6)} s: integration.max_steps = ${e.maxSteps} is used up`];if(r===t.chattering){let i=`more than ${o.most_events} times within ${o.event_time} s`;return["chattering",`stopped at ${n}: the contact started or ended ${i}; give the surface damping, or a lower stiffness`]}return wo(s,n)}function wo({layout:s,status:e,lastStep:r,rates:t},o){let{statuses:n,coordinates:i,limits:a}=s,l=i.length,u=Array.from(t().subarray(l,2*l),d=>Number.isFinite(d)?Math.abs(d):1/0),c=u.indexOf(Math.max(...u)),m=u[c]<a.bound?e===n.not_converged?"not_converged":e===n.step_too_small?"step_too_small":"diverged":"diverged",g=`its acceleration is ${K(u[c],3)} rad/s^2`,p=m.replaceAll("_"," ");return[m,`${p} at ${o} in coordinate ${i[c]}: ${g}; its last step was of ${K(r,3)} s`]}var U=class extends Error{name="EngineError"};function mt(s,e,r){if(!Object.hasOwn(s,e))throw new U(`${r}: got ${e}; expected one of ${Object.keys(s).join(", ")}`);return s[e]}function H(s,e,r){if(e!==r)throw new U(`${s}: got ${e} numbers; expected ${r}`)}var bo=["rk4","midpoint"],Fo=500,$t=class{constructor(e,r){this.engine=e;this.spec=r;let t=mt(e.layout.loops,r.loop,"loop");H(`${r.loop}: parameters`,r.parameters.length,t.parameters),H(`${r.loop}: state`,r.state.length,t.size),H(`${r.loop}: rows`,r.rows.length,(r.knots.length-1)*t.row),this.method=t.method,this.memory=new Float64Array(e.layout.cells.length),this.state=r.state.slice(),this.slope=new Float64Array(t.size),this.states=new Float64Array(r.times.length*t.size),this.states.set(r.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(e){return this.memory[this.engine.layout.cells.indexOf(e)]}put(e){for(let[r,t]of Object.entries(e))this.memory[this.engine.layout.cells.indexOf(r)]=t}advance(e){let{layout:r}=this.engine,{settings:t,knots:o,rows:n,times:i,parameters:a}=this.spec,l=Math.max(1,Math.min(e,t.maxSteps-this.tried)),u={step:t.step,rtol:t.relativeTolerance,atol:t.absoluteTolerance,chunk:l,bound:r.limits.bound,watch:0,most_events:r.limits.most_events,event_time:r.limits.event_time,looks:0},c=this.cell("sample"),f=p=>({into:p,range:()=>[c*this.state.length,this.cell("sample")*this.state.length]}),m=p=>({into:p,given:!0}),g={memory:m(this.memory),y:m(this.state),k1:m(this.slope),p:a,knots:o,rows:n,times:i,out:f(this.states),options:Float64Array.from(r.options,p=>u[p]),seen:new Float64Array(1),segments:o.length-1,samples:i.length};this.engine.call(r.loops[this.spec.loop].export,r.arguments.map(p=>g[p]))}result(){let e=this.cell("sample"),r=this.state.length,[t,o]=de({layout:this.engine.layout,settings:this.spec.settings,status:this.cell("status"),time:this.time,lastStep:this.cell("h"),rates:()=>this.rates()});return{status:t,message:o,times:this.spec.times.slice(0,e),states:this.states.slice(0,e*r),statistics:this.statistics()}}statistics(){let[e,r,t]=[this.cell("steps"),this.cell("smallest"),this.time],o=e?t/e:null,n={steps:e,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:o,smallest_step_s:r>0?r:o};return bo.includes(this.method)&&(n.step=this.cell("h")),this.cell("passes")&&(n.passes=this.cell("passes")),this.cell("events")&&(n.contact_changes=this.cell("events")),n}rates(){let{loop:e,parameters:r,rows:t}=this.spec,{row:o}=this.engine.layout.loops[e],n=Math.min(this.cell("segment"),t.length/o-1),i={time:Float64Array.of(this.time),state:this.state,row:t.slice(n*o,(n+1)*o),step:new Float64Array(1)};return this.engine.sample(`${e.slice(0,e.lastIndexOf("."))}.rate`,r,i,1).rate}},tt=class extends U{name="Cancelled"};async function ye(s,e,r={}){let t=new $t(s,e),o=1e3*(r.piece??.05),n=Fo,i=performance.now();for(;t.running;){let a=performance.now();t.advance(n);let l=performance.now();if(n=Math.max(1,Math.floor(n*Math.min(4,o/Math.max(l-a,.001)))),!(l-i<o)){if(r.progress?.(t.time/e.settings.duration),await new Promise(u=>setTimeout(u,0)),r.cancelled?.())throw new tt(`the run was given up at t = ${K(t.time,6)} s`);i=performance.now()}}return t.result()}function we(s,e){if(!e)return s;let r=(t,o)=>Object.fromEntries(Object.entries(t).filter(([n,i])=>o[n]!==i));return{...r(s,e),series:r(s.series,e.series)}}function ht(s,e=new Set){if(ArrayBuffer.isView(s))s.buffer instanceof ArrayBuffer&&e.add(s.buffer);else if(s!==null&&typeof s=="object")for(let r of Object.values(s))ht(r,e);return[...e]}var be=1,Ao=65536,Mo={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},bt=class s{constructor(e,r,t,o){this.layout=e;this.functions=r;this.memory=t;this.free=o}layout;functions;memory;free;outputs=new Float64Array;static async open(e,r){if(r.format!==be)throw new U(`layout: got format ${r.format}; expected ${be}`);let{instance:t}=await So(e,r),{memory:o,heap_base:n,...i}=t.exports,a=n.value;return new s(r,i,o,a)}sample(e,r,t,o){let n=mt(this.layout.samples,e,"function");H(`${e}: parameters`,r.length,n.parameters);let i=this.schedule(n,r,[t],o);return qt(n.outputs,i,o,1)}slopes(e,r,t,o,n){let i=mt(this.layout.samples,e,"function");if(i.kind!=="slopes")throw new U(`${e}: got a function without derivatives; expected one with them`);H(`${e}: parameters`,r.length,i.parameters);let a=Object.fromEntries(Object.entries(i.inputs).map(([c,f])=>[c,new Float64Array(f)])),l=this.schedule(i,r,[t,{...a,...o}],n),u=Ft(i.outputs);return{values:qt(i.outputs,l,n,2),slopes:qt(i.outputs,l.subarray(u),n,2)}}call(e,r){let t=r.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(t.reduce((a,l)=>a+(l?.byteLength??0),this.free));let o=new Float64Array(this.memory.buffer),n=this.free,i=r.map((a,l)=>{if(typeof a=="number")return BigInt(a);let u=n;return(a instanceof Float64Array||a.given)&&o.set(t[l],u/8),n+=t[l].byteLength,u});this.functions[e](...i),r.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[u,c]=a.range?.()??[0,a.into.length],f=i[l]/8;a.into.set(o.subarray(f+u,f+c),u)})}schedule(e,r,t,o){let n=Eo(e.inputs,t,o),i=this.room(o*t.length*Ft(e.outputs)),a=new Float64Array(e.workspace);return this.call(e.export,[o,0,r,a,n,{into:i}]),i}room(e){return this.outputs.length<e&&(this.outputs=new Float64Array(e)),this.outputs.subarray(0,e)}reserve(e){let r=e-this.memory.buffer.byteLength;if(!(r<=0))try{this.memory.grow(Math.ceil(r/Ao))}catch{throw new U(`memory: got no room for ${(e/1e6).toFixed(0)} MB; expected a browser that has it. Hint: ask for fewer samples`)}}};async function So(s,e){try{return await WebAssembly.instantiate(s,{env:Mo})}catch(r){let t=e.simd?", with vectors (SIMD)":"";throw new U(`WebAssembly: got ${String(r)}; expected a browser that allows it${t}`)}}function Ft(s){return Object.values(s).reduce((e,r)=>e+r,0)}function vo(s,e,r,t){if(r===void 0)throw new U(`${s}: got nothing; expected ${e} numbers for each sample`);if(r.length===t*e)return r;H(s,r.length,e);let o=new Float64Array(t*e);return _t(r,0,0,o,e,0,e,t),o}function Eo(s,e,r){let t=Ft(s),o=new Float64Array(r*e.length*t);return e.forEach((n,i)=>{let a=i*t;for(let[l,u]of Object.entries(s)){let c=vo(l,u,n[l],r);_t(c,u,0,o,e.length*t,a,u,r),a+=u}}),o}function qt(s,e,r,t){let o=t*Ft(s),n={},i=0;for(let[a,l]of Object.entries(s)){let u=new Float64Array(r*l);_t(e,o,i,u,l,0,l,r),n[a]=u,i+=l}return n}function _t(s,e,r,t,o,n,i,a){for(let l=0;l<a;l++){let u=l*e+r,c=l*o+n;for(let f=0;f<i;f++)t[c+f]=s[u+f]}}var At=class{last=null;async of(e,r){if(this.last&&ko(this.last.blocks,e))return this.last.made;this.last=null;let t=await r();return this.last={blocks:e,made:t},t}};function ko(s,e){return Object.entries(s).every(([r,t])=>t.length===e[r].length&&t.every((o,n)=>o===e[r][n]))}function Pt(s,e){return{knots:s,coefficients:e,signals:1,degree:e.length/(s.length-1)-1}}function zt(s,e){let r=s.degree+1,t=s.knots.length-1,o=0;for(;o<t&&s.knots[o]<e;)o+=1;let n=s.knots[t],i=[...s.knots.subarray(0,o)],a=[...s.coefficients.subarray(0,o*r)];return e>n&&(i.push(n),a.push(Ct(s,t-1,0,n),...new Array(s.degree).fill(0))),Pt(Float64Array.from([...i,e]),Float64Array.from(a))}function Ct(s,e,r,t){let o=s.degree+1,n=(e*s.signals+r)*o,i=t-s.knots[e],a=0;for(let l=s.degree;l>=0;l-=1)a=a*i+s.coefficients[n+l];return a}function Wt(s,e){let[r,t]=[0,s.length-1];for(;t-r>1;){let o=r+t>>1;s[o]<=e?r=o:t=o}return r}function et(s,e,r){return Ct(s,Wt(s.knots,r),e,r)}function Fe(s){return Ae(s,Array.from({length:s.knots.length-1},(e,r)=>r))}function Mt(s,e){return Ae(s,Array.from(e,r=>Wt(s.knots,r)))}function Ae(s,e){let r=s.signals*(s.degree+1),t=new Float64Array(e.length*(r+1));return e.forEach((o,n)=>{t[n*(r+1)]=s.knots[o],t.set(s.coefficients.subarray(o*r,(o+1)*r),n*(r+1)+1)}),t}function Me(s){if(!s.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let e=Math.max(...s.map(i=>i.knots[i.knots.length-1])),r=s.map(i=>i.knots[i.knots.length-1]<e?zt(i,e):i),t=xo(r.flatMap(i=>[...i.knots])),o=Math.max(...r.map(i=>i.degree)),n=new Float64Array((t.length-1)*s.length*(o+1));return r.forEach((i,a)=>{for(let l=0;l<t.length-1;l+=1){let u=(l*s.length+a)*(o+1);jo(i,t,l,n.subarray(u,u+o+1))}}),{knots:t,coefficients:n,signals:s.length,degree:o}}function xo(s){let e=[...new Set(s)].sort((o,n)=>o-n),r=e[e.length-1]-e[0],t=e.filter((o,n)=>n===0||o-e[n-1]>1e-12*r);return t[t.length-1]=e[e.length-1],Float64Array.from(t)}function jo(s,e,r,t){let o=Wt(s.knots,(e[r]+e[r+1])/2),n=e[r]-s.knots[o],i=Math.abs(n)<=1e-12*(e[e.length-1]-e[0])?0:n;for(let a=0;a<=s.degree;a+=1){let l=s.coefficients[o*(s.degree+1)+a],u=1;for(let c=a;c>=0;c-=1)t[c]+=u*l*Math.pow(i,a-c),u=u*c/(a-c+1)}}var Ro=1e-9,Lo=1e-6;function Se(s){let e=s.map(Oo);return e.includes(null)?null:Math.max(0,...e)}function Oo(s){let{knots:e,coefficients:r,degree:t}=s,o=e.length-1,n=t+1,i=l=>r[l*n],a=Array.from({length:o},(l,u)=>Math.abs(i(u))).reduce((l,u)=>Math.max(l,u),1e-12);for(let l=o-1;l>=0;l-=1){let u=e[l+1]-e[l];for(let c=1;c<n;c+=1)if(!(Math.abs(r[l*n+c])*u**c<=Ro*a))return l===o-1?null:e[l+1];if(l&&Math.abs(i(l)-Ct(s,l-1,0,e[l]))>Lo*a)return e[l]}return 0}var C=6;function Dt({follower:s,signal:e},r,t,o,n,i){let a=e<0?1:et(t,e,o);return(s?Io(n,i,r):r).map(l=>a*l)}function Io(s,e,r){return r.map((t,o)=>{let[n,i]=[e+3*(o%3),o<3?0:3];return s[n]*r[i]+s[n+1]*r[i+1]+s[n+2]*r[i+2]})}function St(s,e,r,t,o){let n=o.position.shape[1],i=new Float64Array(t.length*n*C);return t.forEach((a,l)=>{if(s.loads.forEach((u,c)=>{let f=l*n+u.point,m=e.loads.subarray(C*c,C*(c+1)),g=Dt(u,m,r,a,o.rotation.data,9*f);for(let p=0;p<C;p+=1)i[C*f+p]+=g[p]}),!(s.contactPoint<0))for(let u=0;u<3;u+=1)i[C*(l*n+s.contactPoint)+u]-=o.contact_force.data[3*l+u]}),i}function vt(s,e){let r=e.length;for(let t=0;t<r;t+=1){let o=t;for(let i=t+1;i<r;i+=1)Math.abs(s[i*r+t])>Math.abs(s[o*r+t])&&(o=i);let n=Math.abs(s[o*r+t]);if(!(n>0)||n===1/0)return!1;o!==t&&Bo(s,e,t,o);for(let i=t+1;i<r;i+=1){let a=s[i*r+t]/s[t*r+t];if(a!==0){for(let l=t+1;l<r;l+=1)s[i*r+l]-=a*s[t*r+l];e[i]-=a*e[t]}}}for(let t=r-1;t>=0;t-=1){for(let o=t+1;o<r;o+=1)e[t]-=s[t*r+o]*e[o];e[t]/=s[t*r+t]}return!0}function Bo(s,e,r,t){let o=e.length;for(let i=0;i<o;i+=1){let a=s[r*o+i];s[r*o+i]=s[t*o+i],s[t*o+i]=a}let n=e[r];e[r]=e[t],e[t]=n}function Et(s,e){let r=new Float64Array(e*e);for(let t=0;t<e;t+=1)for(let o=t;o<e;o+=1){let n=s[o*e+t];for(let i=0;i<t;i+=1)n-=r[o*e+i]*r[t*e+i];if(o===t&&!(n>0))return null;r[o*e+t]=o===t?Math.sqrt(n):n/r[t*e+t]}return r}function Ee(s,e,r,t){for(let o=0;o<r;o+=1){for(let n=0;n<o;n+=1)xe(e,o,n,s[o*r+n],t);for(let n=0;n<t;n+=1)e[o*t+n]/=s[o*r+o]}}function Ut(s,e,r,t){for(let o=r-1;o>=0;o-=1){for(let n=o+1;n<r;n+=1)xe(e,o,n,s[n*r+o],t);for(let n=0;n<t;n+=1)e[o*t+n]/=s[o*r+o]}}function xe(s,e,r,t,o){for(let n=0;n<o;n+=1)s[e*o+n]-=t*s[r*o+n]}function kt(s,e,r){let t=e.slice();Ee(s,t,r,r);let o=ke(t,r);return Ee(s,o,r,r),ke(o,r)}function ke(s,e){return s.map((r,t)=>s[t%e*e+Math.floor(t/e)])}function q(s,e,r,t,o,n=!1){let i=new Float64Array(r*o);for(let a=0;a<r;a+=1)for(let l=0;l<t;l+=1){let u=n?s[l*r+a]:s[a*t+l];if(u)for(let c=0;c<o;c+=1)i[a*o+c]+=u*e[l*o+c]}return i}function je(s,e){let r=Float64Array.from({length:e*e},(t,o)=>o%(e+1)?0:1);for(let t=0;t<e;t+=1){let o=t;for(let a=t+1;a<e;a+=1)Math.abs(s[a*e+t])>Math.abs(s[o*e+t])&&(o=a);let n=Math.abs(s[o*e+t]);if(!(n>0)||n===1/0)return null;for(let a of[s,r])if(o!==t){let l=a.slice(t*e,(t+1)*e);a.copyWithin(t*e,o*e,(o+1)*e),a.set(l,o*e)}let i=s[t*e+t];for(let a=0;a<e;a+=1)s[t*e+a]/=i,r[t*e+a]/=i;for(let a=0;a<e;a+=1){let l=s[a*e+t];if(!(a===t||l===0)){for(let u=t;u<e;u+=1)s[a*e+u]-=l*s[t*e+u];for(let u=0;u<e;u+=1)r[a*e+u]-=l*r[t*e+u]}}}return r}var xt=24;function Re(s,e,r,t,o,n,i=0){let a=t.length/xt,l={wrenches:new Float64Array(C*a),mass:new Float64Array(n*n),damping:new Float64Array(n*n),stiffness:new Float64Array(n*n)},u=(c,f)=>Float64Array.from({length:3*n},(m,g)=>o[(g%n*a+c)*xt+f+Math.floor(g/n)]);return s.loads.forEach((c,f)=>{let{point:m,follower:g}=c,p=e.loads.subarray(C*f,C*(f+1)),d=Dt(c,p,r,i,t,xt*m);if(ut(l.wrenches.subarray(C*m,C*(m+1)),d,1),!g)return;let y=u(m,21);for(let[h,w]of[[u(m,18),0],[y,3]])ut(l.stiffness,q(h,q(No(d.subarray(w,w+3)),y,3,3,n),n,3,n,!0),1)}),s.touch&&$o(To(s.touch,e.surface),e.touch,t,u(s.touch.point,18),l,n),l}function ut(s,e,r){for(let t=0;t<e.length;t+=1)s[t]+=r*e[t]}function No([s,e,r]){return Float64Array.of(0,-r,e,r,0,-s,-e,s,0)}function To(s,e){let[r,t,o,n]=e;if(s.radius)return{...s,axis:[r,t,o],radius:n};let[i,a,l]=s.axis;return{...s,distance:-(i*r+a*t+l*o)}}function $o(s,e,r,t,o,n){let[i,a,l,u]=e,c=xt*s.point+9,{gap:f,normal:m,curvature:g}=qo(s,r.subarray(c,c+3)),p=u-l*f;if(!s.bilateral&&!(f<=0&&p>0))return;for(let h=0;h<3;h+=1)o.wrenches[C*s.point+h]+=p*m[h];let d=q(m,t,1,3,n),y=q(d,d,n,1,n);ut(o.mass,y,i),ut(o.damping,y,a),ut(o.stiffness,y,l),ut(o.stiffness,q(t,q(g,t,3,3,n),n,3,n,!0),-p)}function qo(s,e){let r=l=>l[0]*e[0]+l[1]*e[1]+l[2]*e[2];if(!s.radius)return{gap:r(s.axis)+s.distance,normal:Float64Array.from(s.axis),curvature:new Float64Array(9)};let t=e.map((l,u)=>l-s.axis[u]),o=Math.hypot(...t)||1e-300,n=s.inside?-1:1,i=t.map(l=>l/o),a=Float64Array.from({length:9},(l,u)=>n*((u%4?0:1)-i[Math.floor(u/3)]*i[u%3])/o);return{gap:n*(o-s.radius),normal:i.map(l=>n*l),curvature:a}}function Le(s,e){let r=Array.from(s.frames.data).filter(t=>t<e);return r[r.length-1]!==e-1&&r.push(e-1),r}function R(s){return s.data instanceof Float64Array?s.data:Float64Array.from(s.data)}function _o(s,e,r){let t=s.knobs.map(n=>n.start),o=s.knobs.map(n=>n.factor);return s.sliders.forEach((n,i)=>{n.real?o[n.knob]=e[i]:t[n.knob]=e[i]}),r==="reference"?t:s.knobs.map((n,i)=>{let a=o[i];return a===null||n.factor===null?t[i]:n.together?n.factor?t[i]*(a/n.factor):t[i]:t[i]*a})}function ct(s,e,r){let t=s.runs[r],o=Po(t,_o(s,e,r)),n={};for(let[i,a]of Object.entries(t.places)){let l=a.shape.reduce((u,c)=>u*c,1);n[i]=o.slice(a.start,a.start+l)}return n}function Po(s,e){let r=R(s.base).slice(),t=s.powers.map(l=>Oe(l,(u,c)=>Math.pow(e[u]/s.variables[u].start,c))),o=s.powers.map(l=>Oe(l,(u,c)=>zo(s.variables[u],c,e[u]))),{products:n,terms:i,coefficients:a}=s;for(let l=0;l<n.data.length;l+=2)r[n.data[l]]*=t[n.data[l+1]];for(let l=0;l<i.data.length;l+=2)r[i.data[l]]+=a.data[l/2]*o[i.data[l+1]];return r}function Oe(s,e){return s.reduce((r,[t,o])=>r*e(t,o),1)}function zo(s,e,r){let t=Math.pow(s.start,e);return(Math.pow(r,e)-t)/(Math.pow(s.far,e)-t)}var Co=40,Wo=1e-12,Do=.5,Ie=1e-6,Uo=.5,Go=.001,Qo=1/128;function Ko(s,e,r,t,o,n){let[i,a,l]=[t.length+1,r.length,e.rotors.length],u=new Float64Array(i*a);for(let m=0;m<i;m+=1)u.set(r,m*a),m&&(u[m*a+t[m-1]]+=Ie);let c={time:new Float64Array(1),state:u,row:e.rest_row,step:new Float64Array(1)},{rate:f}=s.sample("rest.rate",e.rest,c,i);for(let m=0;m<t.length;m+=1){n[m]=f[l+t[m]];for(let g=0;g<t.length;g+=1)o[m*t.length+g]=(f[(g+1)*a+l+t[m]]-n[m])/Ie}}function Yo(s,e,r,t){let o=s.layout.held,n=t.length,i=Array.from({length:n},(g,p)=>p).filter(g=>!o.includes(g)),a=new Float64Array(e.restSize);a.set(t);let l=new Float64Array(i.length**2),u=new Float64Array(i.length),c=1/0,[f,m]=[0,0];for(let g=0;g<Co&&i.length;g+=1){if(Ko(s,r,a,i,l,u),!vt(l,u))return null;let p=Gt(a,i,u);if(!Number.isFinite(p)||(g===0?f=p:m+=p,f>Go&&m>Uo*f))return null;if(Qt(p,c))return a.slice(0,n);c=p}return i.length?null:a.slice(0,n)}function Gt(s,e,r){let t=r.reduce((n,i)=>Math.max(n,Math.abs(i)),0),o=Math.min(1,Do/t);for(let n=0;n<e.length;n+=1)s[e[n]]-=o*r[n];return t}function Qt(s,e){return s<Wo||s<1e-9&&s>=e/2}function Kt(s,e,r,t,o){let n=s.sliders.map(c=>c.value),i=c=>c===1?e:e.map((f,m)=>n[m]+(f-n[m])*c),[a,l,u]=[0,1,t];for(;a<1;){let c=Math.min(1,a+l),f=o(i(c),u);if(f)[a,l,u]=[c,2*l,f];else if(l>Qo)l/=2;else throw new Error(`${r}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`)}return u}function Be(s,e,r,t,o){let n=e.runs[t],i=R(n.start).slice(),[a,l]=[n.state.q[0],n.state.v[0]];if(e.atRest){let u=(f,m)=>Yo(s,e,ct(e.map,f,t),m),c=Kt(e,r,t,i.slice(...n.state.q),u);for(let f=0;f<c.length;f+=1)n.info.includes(f)||(i[a+f]=c[f])}for(let[u,c]of n.exact){i[a+u]=et(o,c,0);let f=o.degree;i[l+u]=f?o.coefficients[c*(f+1)+1]:0}return i}var Jo=40,pt=.001;function jt(s,e,r,t){let{samples:o}=s.layout;return s.sample("loaded"in o?"loaded":"inertia",e.chain,r,t).forces}function Xo(s,e,r,t,o,n=0){let i=o.length,a=new Float64Array(i),l=Float64Array.from({length:i*i},(F,S)=>S%(i+1)?0:1),u=R(e.base),c=s.sample("inertia",r.chain,{q:o,v:a,a:l,base:u},i),{points:f}=s.sample("inertia",r.chain,{q:o,v:a,a,base:u},1),m=Re(e,r,t,f,c.points,i,n),g=m.mass;for(let F=0;F<i;F+=1){for(let S=0;S<i;S+=1)g[F*i+S]+=(c.forces[F*i+S]+c.forces[S*i+F])/2;g[F*i+F]+=r.rotors[F]}let p=r.chain.slice();for(let F of e.modes.dry)p[F]=0;let d=s.slopes("elastic.slopes",p,{q:o,v:a,base:u},{q:l},i),y=s.slopes("elastic.slopes",p,{q:o,v:a,base:u},{v:l},i).slopes.forces,h=Zo(s,e,r,o,m.wrenches),w=F=>F.map((S,E)=>F[E%i*i+Math.floor(E/i)]),b=w(d.slopes.forces),A=jt(s,r,{q:o,v:a,a,base:R(e.modes.weight),wrenches:m.wrenches},1);return{mass:g,elastic:b,residual:A.map((F,S)=>F+d.values.forces[S]),damping:w(y).map((F,S)=>F+m.damping[S]),stiffness:b.map((F,S)=>F+h[S]+m.stiffness[S])}}function Ne(s,e,r,t,o,n=0){let{free:i}=e.modes,[a,l,u]=[o.slice(),o.length,i.length],[c,f]=[1/0,!u];for(let m=0;m<Jo;m+=1){let g=Xo(s,e,r,t,a,n);if(f)return{rest:a,linear:g};let p=Float64Array.from({length:u*u},(h,w)=>g.stiffness[i[Math.floor(w/u)]*l+i[w%u]]),d=Float64Array.from(i,h=>g.residual[h]);if(!vt(p,d))return null;let y=Gt(a,i,d);if(!Number.isFinite(y))return null;f=Qt(y,c),c=y}return null}function Zo(s,e,r,t,o){let n=t.length,i=[pt,-pt,2*pt,-2*pt],a=new Float64Array(i.length*n*n);i.forEach((f,m)=>{for(let g=0;g<n;g+=1)a.set(t,(m*n+g)*n),a[(m*n+g)*n+g]+=f});let l=new Float64Array(n),u=jt(s,r,{q:a,v:l,a:l,base:R(e.modes.weight),wrenches:o},i.length*n),c=(f,m,g)=>u[(f*n+g)*n+m];return Float64Array.from({length:n*n},(f,m)=>{let[g,p]=[Math.floor(m/n),m%n];return(8*(c(0,g,p)-c(1,g,p))-(c(2,g,p)-c(3,g,p)))/(12*pt)})}function N(s,e,r){let t=s.length/e,o=new Float64Array(t*r.length);for(let n=0;n<t;n+=1)for(let i=0;i<r.length;i+=1)o[n*r.length+i]=s[n*e+r[i]];return o}function _(s,e){return Array.from({length:e-s},(r,t)=>s+t)}function Y(s,e,r){let t=new Float64Array(r.length*e);for(let o=0;o<r.length;o+=1)for(let n=0;n<e;n+=1)t[o*e+n]=s[r[o]*e+n];return t}function rt(s,e){return s.map((r,t)=>r-e[t])}function ft(s,e){let r=new Float64Array(s.length/e);for(let t=0;t<r.length;t+=1){let o=0;for(let n=0;n<e;n+=1)o+=s[t*e+n]**2;r[t]=Math.sqrt(o)}return r}function Te(s,e,r,t){let o=s.length/r,n=e.length/r,i=new Float64Array(r),a=0;for(let l=0;l<r;l+=1){let u=0;for(let c=0;c<o;c+=1)u+=s[l*o+c];l===0&&(a=u),i[l]=u-a;for(let c=0;c<n;c+=1)i[l]+=(c<t?-1:1)*e[l*n+c]}return i}function gt(s){let e=0;for(let r=1;r<s.length;r+=1)Math.abs(s[r])>Math.abs(s[e])&&(e=r);return e}function k(s,e,...r){return{data:s,shape:[e,...r]}}var Vo=4e5,Ho=5e5;function $e(s,e,r,t,o,n,i){let{places:a,lines:l,shown:u}=e.carried,c=a.data.length,f=l.map((w,b)=>tn(w,r.lengths[b],i.length*u.data.length)),m=Math.max(1,Math.ceil(o.length*l.length*c/Vo));if(!l.length)return{links:f,every:m};let g=new Map(i.map((w,b)=>[w,b])),p=Array.from(o.keys()).filter(w=>w%m===0||g.has(w)),d={q:t.q.data,v:t.v.data,a:t.a.data};"wrenches"in s.layout.samples.line.inputs&&(d.wrenches=St(e,r,n,o,t));let y=Object.entries(d).map(([w,b])=>[w,Y(b,b.length/o.length,p)]),h={...Object.fromEntries(y),base:R(e.split.weight)};return Jt(s,r,h,p.length,(w,b,A)=>{let F=g.get(p[A]);l.forEach((S,E)=>{let M=Xt(w[S.name],b,e,S);en(f[E],S,M,a.data,p[A]),F!==void 0&&rn(f[E],S,M,F,u.data)})}),{links:f,every:m}}function Jt(s,e,r,t,o){let{inputs:n,outputs:i}=s.layout.samples.line,a=Math.max(1,Math.floor(Ho/Object.values(i).reduce((l,u)=>l+u,1)));for(let l=0;l<t;l+=a){let u=Math.min(a,t-l),c={};for(let[m,g]of Object.entries(n)){let p=r[m]??new Float64Array(g);c[m]=p.length===g?p:p.subarray(l*g,(l+u)*g)}let f=s.sample("line",e.line,c,u);for(let m=0;m<u;m+=1)o(f,m,l+m)}}function Xt(s,e,r,t){let o=t?r.carried.places.data.length*t.width:15;return s.subarray(e*o,(e+1)*o)}function tn({name:s,at:e},r,t){let o=n=>new Float64Array(n*t);return{name:s,length:r,deflection:o(2),slope:o(2),moment:o(3),shear:o(2),axial:o(1),stress:e.mises_stress?{strain:o(1),mises:o(1)}:null,largest:{deflection:null,moment:null,stress:null}}}function en(s,{width:e,at:r},t,o,n){let i=o.length-1,a=i*e+r.deflection[0];Yt(s,"deflection",Math.sqrt(t[a]**2+t[a+1]**2),o[i],n);for(let l=0;l<=i;l+=1){let u=l*e+r.moment[0];Yt(s,"moment",Math.sqrt(t[u+1]**2+t[u+2]**2),o[l],n),s.stress&&Yt(s,"stress",t[l*e+r.mises_stress[0]],o[l],n)}}function Yt({name:s,largest:e},r,t,o,n){let i=e[r];(!i||t>i.value)&&(e[r]={link:s,value:t,s:o,sample:n})}function rn(s,{width:e,at:r},t,o,n){let i=(a,l)=>{let[u,c]=r[a],f=c-u;for(let m=0;m<n.length;m+=1)for(let g=0;g<f;g+=1)l[(o*n.length+m)*f+g]=t[n[m]*e+u+g]};for(let a of["deflection","slope","moment","shear","axial"])i(a,s[a]);s.stress&&(i("strain",s.stress.strain),i("mises_stress",s.stress.mises))}function J(s,e,r){let[t,o]=s.matrix.shape,n=new Float64Array(r*t);for(let i=0;i<r;i+=1)for(let a=0;a<t;a+=1){let l=s.constant.data[a];for(let u=0;u<o;u+=1)l+=s.matrix.data[a*o+u]*e[i*o+u];n[i*t+a]=l}return n}function qe(s,e,r,t,o,n,i){let a=h=>Y(t[h].data,t[h].shape.slice(1).reduce((w,b)=>w*b,1),n),l=n.length,u=Rt(s,e,r,a("q"),l),c=h=>Rt(s,e,r,h,l).line,f=h=>c(J(e.straight,h,l)),m=f(a("q")),g=h=>({data:a(h),shape:[l,...t[h].shape.slice(1)]}),p="q_nominal"in t,d=u.line.shape.slice(0,3),y=u.line.data.map((h,w)=>h-m.data[w]);return{times:{data:Y(o,1,n),shape:[l]},line:u.line,rigid:m,roots:u.roots,reference:p?c(a("q_nominal")):null,referenceRigid:p?f(a("q_nominal")):null,colours:[...i,{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:ft(y,3),shape:d}}],tip:g("tip"),tipReference:p?g("tip_nominal"):null,contact:e.contactPoint<0?null:{force:g("contact_force"),at:nn(e,t,n),surface:on(e,r.surface)}}}function on({surface:s},e){let r=[e[0],e[1],e[2]];return s?.kind==="plane"?{...s,position:r}:s?{...s,center:r,radius:e[3]}:void 0}function nn(s,e,r){let t=e.position.shape[1],o=Y(e.position.data,3*t,r),n=new Float64Array(3*r.length);for(let i=0;i<r.length;i+=1)for(let a=0;a<3;a+=1)n[3*i+a]=o[3*(i*t+s.contactPoint)+a];return{data:n,shape:[r.length,3]}}function Rt(s,e,r,t,o){let[n,i]=[e.links.length,e.stations.data.length],a=new Float64Array(t.length/o),l=new Float64Array(o*n*i*3),u=new Float64Array(o*n*4),c=e.links.map(({name:f})=>e.carried.lines.find(m=>m.name===f)??null);return Jt(s,r,{q:t,v:a,a,base:R(e.base)},o,(f,m,g)=>{e.links.forEach(({name:p},d)=>{let y=c[d],h=(g*n+d)*4,w=Xt(f[p],m,e,y);u.set(an(y?w.subarray(y.at.rotation[0]):w),h),g&&sn(u,h,4*n);for(let b=0;b<i;b+=1){let A=((g*n+d)*i+b)*3;for(let F=0;F<3;F+=1)l[A+F]=y?w[e.carried.shown.data[b]*y.width+y.at.position[0]+F]:w[9+F]+e.stations.data[b]*(w[12+F]-w[9+F])}})}),{line:{data:l,shape:[o,n,i,3]},roots:{data:u,shape:[o,n,4]}}}function sn(s,e,r){let t=0;for(let o=e;o<e+4;o+=1)t+=s[o]*s[o-r];if(t<0)for(let o=e;o<e+4;o+=1)s[o]*=-1}function an(s){let e=s[0]+s[4]+s[8];if(e>0){let t=2*Math.sqrt(1+e);return[(s[7]-s[5])/t,(s[2]-s[6])/t,(s[3]-s[1])/t,t/4]}if(s[0]>s[4]&&s[0]>s[8]){let t=2*Math.sqrt(1+s[0]-s[4]-s[8]);return[t/4,(s[1]+s[3])/t,(s[2]+s[6])/t,(s[7]-s[5])/t]}if(s[4]>s[8]){let t=2*Math.sqrt(1+s[4]-s[0]-s[8]);return[(s[1]+s[3])/t,t/4,(s[5]+s[7])/t,(s[2]-s[6])/t]}let r=2*Math.sqrt(1+s[8]-s[0]-s[4]);return[(s[2]+s[6])/r,(s[5]+s[7])/r,r/4,(s[3]-s[1])/r]}var ln=Object.prototype.toString;function $(s){let e=ln.call(s);return e.endsWith("Array]")&&!e.includes("Big")}function Zt(s,e={}){if(!$(s))throw new TypeError("input must be an array");if(s.length===0)throw new TypeError("input must not be empty");let{fromIndex:r=0,toIndex:t=s.length}=e;if(r<0||r>=s.length||!Number.isInteger(r))throw new Error("fromIndex must be a positive integer smaller than length");if(t<=r||t>s.length||!Number.isInteger(t))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let o=s[r];for(let n=r+1;n<t;n++)s[n]>o&&(o=s[n]);return o}function Vt(s,e={}){if(!$(s))throw new TypeError("input must be an array");if(s.length===0)throw new TypeError("input must not be empty");let{fromIndex:r=0,toIndex:t=s.length}=e;if(r<0||r>=s.length||!Number.isInteger(r))throw new Error("fromIndex must be a positive integer smaller than length");if(t<=r||t>s.length||!Number.isInteger(t))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let o=s[r];for(let n=r+1;n<t;n++)s[n]<o&&(o=s[n]);return o}function Lt(s,e={}){if($(s)){if(s.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let r;if(e.output!==void 0){if(!$(e.output))throw new TypeError("output option must be an array if specified");r=e.output}else r=new Array(s.length);let t=Vt(s),o=Zt(s);if(t===o)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:n=e.autoMinMax?t:0,max:i=e.autoMinMax?o:1}=e;if(n>=i)throw new RangeError("min option must be smaller than max option");let a=(i-n)/(o-t);for(let l=0;l<s.length;l++)r[l]=(s[l]-t)*a+n;return r}var Ot=" ".repeat(2),Pe=" ".repeat(4);function ze(){return Ht(this)}function Ht(s,e={}){let{maxRows:r=15,maxColumns:t=10,maxNumSize:o=8,padMinus:n="auto"}=e;return`${s.constructor.name} {\n${Ot}[\n${Pe}${un(s,r,t,o,n)}\n${Ot}]\n${Ot}rows: ${s.rows}\n${Ot}columns: ${s.columns}\n}`}function un(s,e,r,t,o){let{rows:n,columns:i}=s,a=Math.min(n,e),l=Math.min(i,r),u=[];if(o==="auto"){o=!1;t:for(let c=0;c<a;c++)for(let f=0;f<l;f++)if(s.get(c,f)<0){o=!0;break t}}for(let c=0;c<a;c++){let f=[];for(let m=0;m<l;m++)f.push(cn(s.get(c,m),t,o));u.push(`${f.join(" ")}`)}return l!==i&&(u[u.length-1]+=` ... ${i-r} more columns`),a!==n&&u.push(`... ${n-e} more rows`),u.join(`\n${Pe}`)}function cn(s,e,r){return(s>=0&&r?` ${_e(s,e-1)}`:_e(s,e)).padEnd(e)}function _e(s,e){let r=s.toString();if(r.length<=e)return r;let t=s.toFixed(e);if(t.length>e&&(t=s.toFixed(Math.max(0,e-(t.length-e)))),t.length<=e&&!t.startsWith("0.000")&&!t.startsWith("-0.000"))return t;let o=s.toExponential(e);return o.length>e&&(o=s.toExponential(Math.max(0,e-(o.length-e)))),o.slice(0)}function Ce(s,e){s.prototype.add=function(t){return typeof t=="number"?this.addS(t):this.addM(t)},s.prototype.addS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)+t);return this},s.prototype.addM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)+t.get(o,n));return this},s.add=function(t,o){return new e(t).add(o)},s.prototype.sub=function(t){return typeof t=="number"?this.subS(t):this.subM(t)},s.prototype.subS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)-t);return this},s.prototype.subM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)-t.get(o,n));return this},s.sub=function(t,o){return new e(t).sub(o)},s.prototype.subtract=s.prototype.sub,s.prototype.subtractS=s.prototype.subS,s.prototype.subtractM=s.prototype.subM,s.subtract=s.sub,s.prototype.mul=function(t){return typeof t=="number"?this.mulS(t):this.mulM(t)},s.prototype.mulS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)*t);return this},s.prototype.mulM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)*t.get(o,n));return this},s.mul=function(t,o){return new e(t).mul(o)},s.prototype.multiply=s.prototype.mul,s.prototype.multiplyS=s.prototype.mulS,s.prototype.multiplyM=s.prototype.mulM,s.multiply=s.mul,s.prototype.div=function(t){return typeof t=="number"?this.divS(t):this.divM(t)},s.prototype.divS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)/t);return this},s.prototype.divM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)/t.get(o,n));return this},s.div=function(t,o){return new e(t).div(o)},s.prototype.divide=s.prototype.div,s.prototype.divideS=s.prototype.divS,s.prototype.divideM=s.prototype.divM,s.divide=s.div,s.prototype.mod=function(t){return typeof t=="number"?this.modS(t):this.modM(t)},s.prototype.modS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)%t);return this},s.prototype.modM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)%t.get(o,n));return this},s.mod=function(t,o){return new e(t).mod(o)},s.prototype.modulus=s.prototype.mod,s.prototype.modulusS=s.prototype.modS,s.prototype.modulusM=s.prototype.modM,s.modulus=s.mod,s.prototype.and=function(t){return typeof t=="number"?this.andS(t):this.andM(t)},s.prototype.andS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)&t);return this},s.prototype.andM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)&t.get(o,n));return this},s.and=function(t,o){return new e(t).and(o)},s.prototype.or=function(t){return typeof t=="number"?this.orS(t):this.orM(t)},s.prototype.orS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)|t);return this},s.prototype.orM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)|t.get(o,n));return this},s.or=function(t,o){return new e(t).or(o)},s.prototype.xor=function(t){return typeof t=="number"?this.xorS(t):this.xorM(t)},s.prototype.xorS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)^t);return this},s.prototype.xorM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)^t.get(o,n));return this},s.xor=function(t,o){return new e(t).xor(o)},s.prototype.leftShift=function(t){return typeof t=="number"?this.leftShiftS(t):this.leftShiftM(t)},s.prototype.leftShiftS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)<<t);return this},s.prototype.leftShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)<<t.get(o,n));return this},s.leftShift=function(t,o){return new e(t).leftShift(o)},s.prototype.signPropagatingRightShift=function(t){return typeof t=="number"?this.signPropagatingRightShiftS(t):this.signPropagatingRightShiftM(t)},s.prototype.signPropagatingRightShiftS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)>>t);return this},s.prototype.signPropagatingRightShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)>>t.get(o,n));return this},s.signPropagatingRightShift=function(t,o){return new e(t).signPropagatingRightShift(o)},s.prototype.rightShift=function(t){return typeof t=="number"?this.rightShiftS(t):this.rightShiftM(t)},s.prototype.rightShiftS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)>>>t);return this},s.prototype.rightShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)>>>t.get(o,n));return this},s.rightShift=function(t,o){return new e(t).rightShift(o)},s.prototype.zeroFillRightShift=s.prototype.rightShift,s.prototype.zeroFillRightShiftS=s.prototype.rightShiftS,s.prototype.zeroFillRightShiftM=s.prototype.rightShiftM,s.zeroFillRightShift=s.rightShift,s.prototype.not=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,~this.get(t,o));return this},s.not=function(t){return new e(t).not()},s.prototype.abs=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.abs(this.get(t,o)));return this},s.abs=function(t){return new e(t).abs()},s.prototype.acos=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.acos(this.get(t,o)));return this},s.acos=function(t){return new e(t).acos()},s.prototype.acosh=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.acosh(this.get(t,o)));return this},s.acosh=function(t){return new e(t).acosh()},s.prototype.asin=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.asin(this.get(t,o)));return this},s.asin=function(t){return new e(t).asin()},s.prototype.asinh=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.asinh(this.get(t,o)));return this},s.asinh=function(t){return new e(t).asinh()},s.prototype.atan=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.atan(this.get(t,o)));return this},s.atan=function(t){return new e(t).atan()},s.prototype.atanh=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.atanh(this.get(t,o)));return this},s.atanh=function(t){return new e(t).atanh()},s.prototype.cbrt=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.cbrt(this.get(t,o)));return this},s.cbrt=function(t){return new e(t).cbrt()},s.prototype.ceil=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.ceil(this.get(t,o)));return this},s.ceil=function(t){return new e(t).ceil()},s.prototype.clz32=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.clz32(this.get(t,o)));return this},s.clz32=function(t){return new e(t).clz32()},s.prototype.cos=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.cos(this.get(t,o)));return this},s.cos=function(t){return new e(t).cos()},s.prototype.cosh=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.cosh(this.get(t,o)));return this},s.cosh=function(t){return new e(t).cosh()},s.prototype.exp=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.exp(this.get(t,o)));return this},s.exp=function(t){return new e(t).exp()},s.prototype.expm1=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.expm1(this.get(t,o)));return this},s.expm1=function(t){return new e(t).expm1()},s.prototype.floor=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.floor(this.get(t,o)));return this},s.floor=function(t){return new e(t).floor()},s.prototype.fround=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.fround(this.get(t,o)));return this},s.fround=function(t){return new e(t).fround()},s.prototype.log=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.log(this.get(t,o)));return this},s.log=function(t){return new e(t).log()},s.prototype.log1p=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.log1p(this.get(t,o)));return this},s.log1p=function(t){return new e(t).log1p()},s.prototype.log10=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.log10(this.get(t,o)));return this},s.log10=function(t){return new e(t).log10()},s.prototype.log2=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.log2(this.get(t,o)));return this},s.log2=function(t){return new e(t).log2()},s.prototype.round=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.round(this.get(t,o)));return this},s.round=function(t){return new e(t).round()},s.prototype.sign=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.sign(this.get(t,o)));return this},s.sign=function(t){return new e(t).sign()},s.prototype.sin=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.sin(this.get(t,o)));return this},s.sin=function(t){return new e(t).sin()},s.prototype.sinh=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.sinh(this.get(t,o)));return this},s.sinh=function(t){return new e(t).sinh()},s.prototype.sqrt=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.sqrt(this.get(t,o)));return this},s.sqrt=function(t){return new e(t).sqrt()},s.prototype.tan=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.tan(this.get(t,o)));return this},s.tan=function(t){return new e(t).tan()},s.prototype.tanh=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.tanh(this.get(t,o)));return this},s.tanh=function(t){return new e(t).tanh()},s.prototype.trunc=function(){for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.set(t,o,Math.trunc(this.get(t,o)));return this},s.trunc=function(t){return new e(t).trunc()},s.pow=function(t,o){return new e(t).pow(o)},s.prototype.pow=function(t){return typeof t=="number"?this.powS(t):this.powM(t)},s.prototype.powS=function(t){for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)**t);return this},s.prototype.powM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let o=0;o<this.rows;o++)for(let n=0;n<this.columns;n++)this.set(o,n,this.get(o,n)**t.get(o,n));return this}}function G(s,e,r){let t=r?s.rows:s.rows-1;if(e<0||e>t)throw new RangeError("Row index out of range")}function Q(s,e,r){let t=r?s.columns:s.columns-1;if(e<0||e>t)throw new RangeError("Column index out of range")}function nt(s,e){if(e.to1DArray&&(e=e.to1DArray()),e.length!==s.columns)throw new RangeError("vector size must be the same as the number of columns");return e}function st(s,e){if(e.to1DArray&&(e=e.to1DArray()),e.length!==s.rows)throw new RangeError("vector size must be the same as the number of rows");return e}function We(s,e){if(!$(e))throw new TypeError("row indices must be an array");for(let r=0;r<e.length;r++)if(e[r]<0||e[r]>=s.rows)throw new RangeError("row indices are out of range")}function De(s,e){if(!$(e))throw new TypeError("column indices must be an array");for(let r=0;r<e.length;r++)if(e[r]<0||e[r]>=s.columns)throw new RangeError("column indices are out of range")}function te(s,e,r,t,o){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(It("startRow",e),It("endRow",r),It("startColumn",t),It("endColumn",o),e>r||t>o||e<0||e>=s.rows||r<0||r>=s.rows||t<0||t>=s.columns||o<0||o>=s.columns)throw new RangeError("Submatrix indices are out of range")}function dt(s,e=0){let r=[];for(let t=0;t<s;t++)r.push(e);return r}function It(s,e){if(typeof e!="number")throw new TypeError(`${s} must be a number`)}function it(s){if(s.isEmpty())throw new Error("Empty matrix has no elements to index")}function Ue(s){let e=dt(s.rows);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[r]+=s.get(r,t);return e}function Ge(s){let e=dt(s.columns);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[t]+=s.get(r,t);return e}function Qe(s){let e=0;for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)e+=s.get(r,t);return e}function Ke(s){let e=dt(s.rows,1);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[r]*=s.get(r,t);return e}function Ye(s){let e=dt(s.columns,1);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[t]*=s.get(r,t);return e}function Je(s){let e=1;for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)e*=s.get(r,t);return e}function Xe(s,e,r){let t=s.rows,o=s.columns,n=[];for(let i=0;i<t;i++){let a=0,l=0,u=0;for(let c=0;c<o;c++)u=s.get(i,c)-r[i],a+=u,l+=u*u;e?n.push((l-a*a/o)/(o-1)):n.push((l-a*a/o)/o)}return n}function Ze(s,e,r){let t=s.rows,o=s.columns,n=[];for(let i=0;i<o;i++){let a=0,l=0,u=0;for(let c=0;c<t;c++)u=s.get(c,i)-r[i],a+=u,l+=u*u;e?n.push((l-a*a/t)/(t-1)):n.push((l-a*a/t)/t)}return n}function Ve(s,e,r){let t=s.rows,o=s.columns,n=t*o,i=0,a=0,l=0;for(let u=0;u<t;u++)for(let c=0;c<o;c++)l=s.get(u,c)-r,i+=l,a+=l*l;return e?(a-i*i/n)/(n-1):(a-i*i/n)/n}function He(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e[r])}function tr(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e[t])}function er(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e)}function rr(s){let e=[];for(let r=0;r<s.rows;r++){let t=0;for(let o=0;o<s.columns;o++)t+=s.get(r,o)**2/(s.columns-1);e.push(Math.sqrt(t))}return e}function or(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e[r])}function nr(s){let e=[];for(let r=0;r<s.columns;r++){let t=0;for(let o=0;o<s.rows;o++)t+=s.get(o,r)**2/(s.rows-1);e.push(Math.sqrt(t))}return e}function sr(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e[t])}function ir(s){let e=s.size-1,r=0;for(let t=0;t<s.columns;t++)for(let o=0;o<s.rows;o++)r+=s.get(o,t)**2/e;return Math.sqrt(r)}function ar(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e)}var L=class s{static from1DArray(e,r,t){if(e*r!==t.length)throw new RangeError("data length does not match given dimensions");let n=new v(e,r);for(let i=0;i<e;i++)for(let a=0;a<r;a++)n.set(i,a,t[i*r+a]);return n}static rowVector(e){let r=new v(1,e.length);for(let t=0;t<e.length;t++)r.set(0,t,e[t]);return r}static columnVector(e){let r=new v(e.length,1);for(let t=0;t<e.length;t++)r.set(t,0,e[t]);return r}static zeros(e,r){return new v(e,r)}static ones(e,r){return new v(e,r).fill(1)}static rand(e,r,t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{random:o=Math.random}=t,n=new v(e,r);for(let i=0;i<e;i++)for(let a=0;a<r;a++)n.set(i,a,o());return n}static randInt(e,r,t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:o=0,max:n=1e3,random:i=Math.random}=t;if(!Number.isInteger(o))throw new TypeError("min must be an integer");if(!Number.isInteger(n))throw new TypeError("max must be an integer");if(o>=n)throw new RangeError("min must be smaller than max");let a=n-o,l=new v(e,r);for(let u=0;u<e;u++)for(let c=0;c<r;c++){let f=o+Math.round(i()*a);l.set(u,c,f)}return l}static eye(e,r,t){r===void 0&&(r=e),t===void 0&&(t=1);let o=Math.min(e,r),n=this.zeros(e,r);for(let i=0;i<o;i++)n.set(i,i,t);return n}static diag(e,r,t){let o=e.length;r===void 0&&(r=o),t===void 0&&(t=r);let n=Math.min(o,r,t),i=this.zeros(r,t);for(let a=0;a<n;a++)i.set(a,a,e[a]);return i}static min(e,r){e=this.checkMatrix(e),r=this.checkMatrix(r);let t=e.rows,o=e.columns,n=new v(t,o);for(let i=0;i<t;i++)for(let a=0;a<o;a++)n.set(i,a,Math.min(e.get(i,a),r.get(i,a)));return n}static max(e,r){e=this.checkMatrix(e),r=this.checkMatrix(r);let t=e.rows,o=e.columns,n=new this(t,o);for(let i=0;i<t;i++)for(let a=0;a<o;a++)n.set(i,a,Math.max(e.get(i,a),r.get(i,a)));return n}static checkMatrix(e){return s.isMatrix(e)?e:new v(e)}static isMatrix(e){return e!=null&&e.klass==="Matrix"}get size(){return this.rows*this.columns}apply(e){if(typeof e!="function")throw new TypeError("callback must be a function");for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.call(this,r,t);return this}applyAlongAxis(e,r){if(typeof e!="function")throw new TypeError("callback must be a function");let t=[];switch(r){case"row":{for(let o=0;o<this.rows;o++)t.push(e.call(this,this.getRow(o),o));break}case"column":{for(let o=0;o<this.columns;o++)t.push(e.call(this,this.getColumn(o),o));break}default:throw new Error(`invalid option: ${r}`)}return t}to1DArray(){let e=[];for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.push(this.get(r,t));return e}to2DArray(){let e=[];for(let r=0;r<this.rows;r++){e.push([]);for(let t=0;t<this.columns;t++)e[r].push(this.get(r,t))}return e}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let e=0;e<this.rows;e++)for(let r=0;r<=e;r++)if(this.get(e,r)!==this.get(r,e))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let e=0;e<this.rows;e++)if(this.get(e,e)!==0)return!1;return!0}isEchelonForm(){let e=0,r=0,t=-1,o=!0,n=!1;for(;e<this.rows&&o;){for(r=0,n=!1;r<this.columns&&n===!1;)this.get(e,r)===0?r++:this.get(e,r)===1&&r>t?(n=!0,t=r):(o=!1,n=!0);e++}return o}isReducedEchelonForm(){let e=0,r=0,t=-1,o=!0,n=!1;for(;e<this.rows&&o;){for(r=0,n=!1;r<this.columns&&n===!1;)this.get(e,r)===0?r++:this.get(e,r)===1&&r>t?(n=!0,t=r):(o=!1,n=!0);for(let i=r+1;i<this.rows;i++)this.get(e,i)!==0&&(o=!1);e++}return o}echelonForm(){let e=this.clone(),r=0,t=0;for(;r<e.rows&&t<e.columns;){let o=r;for(let n=r;n<e.rows;n++)e.get(n,t)>e.get(o,t)&&(o=n);if(e.get(o,t)===0)t++;else{e.swapRows(r,o);let n=e.get(r,t);for(let i=t;i<e.columns;i++)e.set(r,i,e.get(r,i)/n);for(let i=r+1;i<e.rows;i++){let a=e.get(i,t)/e.get(r,t);e.set(i,t,0);for(let l=t+1;l<e.columns;l++)e.set(i,l,e.get(i,l)-e.get(r,l)*a)}r++,t++}}return e}reducedEchelonForm(){let e=this.echelonForm(),r=e.columns,t=e.rows,o=t-1;for(;o>=0;)if(e.maxRow(o)===0)o--;else{let n=0,i=!1;for(;n<t&&i===!1;)e.get(o,n)===1?i=!0:n++;for(let a=0;a<o;a++){let l=e.get(a,n);for(let u=n;u<r;u++){let c=e.get(a,u)-l*e.get(o,u);e.set(a,u,c)}}o--}return e}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{rows:r=1,columns:t=1}=e;if(!Number.isInteger(r)||r<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(t)||t<=0)throw new TypeError("columns must be a positive integer");let o=new v(this.rows*r,this.columns*t);for(let n=0;n<r;n++)for(let i=0;i<t;i++)o.setSubMatrix(this,this.rows*n,this.columns*i);return o}fill(e){for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,e);return this}neg(){return this.mulS(-1)}getRow(e){G(this,e);let r=[];for(let t=0;t<this.columns;t++)r.push(this.get(e,t));return r}getRowVector(e){return v.rowVector(this.getRow(e))}setRow(e,r){G(this,e),r=nt(this,r);for(let t=0;t<this.columns;t++)this.set(e,t,r[t]);return this}swapRows(e,r){G(this,e),G(this,r);for(let t=0;t<this.columns;t++){let o=this.get(e,t);this.set(e,t,this.get(r,t)),this.set(r,t,o)}return this}getColumn(e){Q(this,e);let r=[];for(let t=0;t<this.rows;t++)r.push(this.get(t,e));return r}getColumnVector(e){return v.columnVector(this.getColumn(e))}setColumn(e,r){Q(this,e),r=st(this,r);for(let t=0;t<this.rows;t++)this.set(t,e,r[t]);return this}swapColumns(e,r){Q(this,e),Q(this,r);for(let t=0;t<this.rows;t++){let o=this.get(t,e);this.set(t,e,this.get(t,r)),this.set(t,r,o)}return this}addRowVector(e){e=nt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)+e[t]);return this}subRowVector(e){e=nt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)-e[t]);return this}mulRowVector(e){e=nt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)*e[t]);return this}divRowVector(e){e=nt(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)/e[t]);return this}addColumnVector(e){e=st(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)+e[r]);return this}subColumnVector(e){e=st(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)-e[r]);return this}mulColumnVector(e){e=st(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)*e[r]);return this}divColumnVector(e){e=st(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)/e[r]);return this}mulRow(e,r){G(this,e);for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)*r);return this}mulColumn(e,r){Q(this,e);for(let t=0;t<this.rows;t++)this.set(t,e,this.get(t,e)*r);return this}max(e){if(this.isEmpty())return NaN;switch(e){case"row":{let r=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.get(t,o)>r[t]&&(r[t]=this.get(t,o));return r}case"column":{let r=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.get(t,o)>r[o]&&(r[o]=this.get(t,o));return r}case void 0:{let r=this.get(0,0);for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.get(t,o)>r&&(r=this.get(t,o));return r}default:throw new Error(`invalid option: ${e}`)}}maxIndex(){it(this);let e=this.get(0,0),r=[0,0];for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.get(t,o)>e&&(e=this.get(t,o),r[0]=t,r[1]=o);return r}min(e){if(this.isEmpty())return NaN;switch(e){case"row":{let r=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.get(t,o)<r[t]&&(r[t]=this.get(t,o));return r}case"column":{let r=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.get(t,o)<r[o]&&(r[o]=this.get(t,o));return r}case void 0:{let r=this.get(0,0);for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.get(t,o)<r&&(r=this.get(t,o));return r}default:throw new Error(`invalid option: ${e}`)}}minIndex(){it(this);let e=this.get(0,0),r=[0,0];for(let t=0;t<this.rows;t++)for(let o=0;o<this.columns;o++)this.get(t,o)<e&&(e=this.get(t,o),r[0]=t,r[1]=o);return r}maxRow(e){if(G(this,e),this.isEmpty())return NaN;let r=this.get(e,0);for(let t=1;t<this.columns;t++)this.get(e,t)>r&&(r=this.get(e,t));return r}maxRowIndex(e){G(this,e),it(this);let r=this.get(e,0),t=[e,0];for(let o=1;o<this.columns;o++)this.get(e,o)>r&&(r=this.get(e,o),t[1]=o);return t}minRow(e){if(G(this,e),this.isEmpty())return NaN;let r=this.get(e,0);for(let t=1;t<this.columns;t++)this.get(e,t)<r&&(r=this.get(e,t));return r}minRowIndex(e){G(this,e),it(this);let r=this.get(e,0),t=[e,0];for(let o=1;o<this.columns;o++)this.get(e,o)<r&&(r=this.get(e,o),t[1]=o);return t}maxColumn(e){if(Q(this,e),this.isEmpty())return NaN;let r=this.get(0,e);for(let t=1;t<this.rows;t++)this.get(t,e)>r&&(r=this.get(t,e));return r}maxColumnIndex(e){Q(this,e),it(this);let r=this.get(0,e),t=[0,e];for(let o=1;o<this.rows;o++)this.get(o,e)>r&&(r=this.get(o,e),t[0]=o);return t}minColumn(e){if(Q(this,e),this.isEmpty())return NaN;let r=this.get(0,e);for(let t=1;t<this.rows;t++)this.get(t,e)<r&&(r=this.get(t,e));return r}minColumnIndex(e){Q(this,e),it(this);let r=this.get(0,e),t=[0,e];for(let o=1;o<this.rows;o++)this.get(o,e)<r&&(r=this.get(o,e),t[0]=o);return t}diag(){let e=Math.min(this.rows,this.columns),r=[];for(let t=0;t<e;t++)r.push(this.get(t,t));return r}norm(e="frobenius"){switch(e){case"max":return v.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${e}`)}}cumulativeSum(){let e=0;for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e+=this.get(r,t),this.set(r,t,e);return this}dot(e){s.isMatrix(e)&&(e=e.to1DArray());let r=this.to1DArray();if(r.length!==e.length)throw new RangeError("vectors do not have the same size");let t=0;for(let o=0;o<r.length;o++)t+=r[o]*e[o];return t}mmul(e){e=v.checkMatrix(e);let r=this.rows,t=this.columns,o=e.columns,n=new v(r,o),i=new Float64Array(t);for(let a=0;a<o;a++){for(let l=0;l<t;l++)i[l]=e.get(l,a);for(let l=0;l<r;l++){let u=0;for(let c=0;c<t;c++)u+=this.get(l,c)*i[c];n.set(l,a,u)}}return n}gram(){let e=this.rows,r=this.columns,t=new Float64Array(r*r);for(let n=0;n<e;n++)for(let i=0;i<r;i++){let a=this.get(n,i);if(a===0)continue;let l=i*r;for(let u=i;u<r;u++)t[l+u]+=a*this.get(n,u)}let o=new v(r,r);for(let n=0;n<r;n++){let i=n*r;for(let a=n;a<r;a++){let l=t[i+a];o.set(n,a,l),o.set(a,n,l)}}return o}transposeMultiply(e){if(e=v.checkMatrix(e),this.rows!==e.rows)throw new RangeError("the number of rows of the two matrices must be equal");let r=this.columns,t=e.columns,o=new v(r,t),n=new Float64Array(t);for(let i=0;i<this.rows;i++){for(let a=0;a<t;a++)n[a]=e.get(i,a);for(let a=0;a<r;a++){let l=this.get(i,a);if(l===0)continue;let u=o.data[a];for(let c=0;c<t;c++)u[c]+=l*n[c]}}return o}mmulByTranspose(e){let r=this.rows,t=this.columns;if(e!==void 0&&e.length!==t)throw new RangeError("scale must have one value per column");let o=new v(r,r),n=new Float64Array(t);for(let i=0;i<r;i++){if(e===void 0)for(let a=0;a<t;a++)n[a]=this.get(i,a);else for(let a=0;a<t;a++)n[a]=e[a]*this.get(i,a);for(let a=i;a<r;a++){let l=0;for(let u=0;u<t;u++)l+=this.get(a,u)*n[u];o.set(a,i,l),o.set(i,a,l)}}return o}mpow(e){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(e)||e<0)throw new RangeError("Exponent must be a non-negative integer");let r=v.eye(this.rows),t=this;for(let o=e;o>=1;o/=2)(o&1)!==0&&(r=r.mmul(t)),t=t.mmul(t);return r}strassen2x2(e){e=v.checkMatrix(e);let r=new v(2,2),t=this.get(0,0),o=e.get(0,0),n=this.get(0,1),i=e.get(0,1),a=this.get(1,0),l=e.get(1,0),u=this.get(1,1),c=e.get(1,1),f=(t+u)*(o+c),m=(a+u)*o,g=t*(i-c),p=u*(l-o),d=(t+n)*c,y=(a-t)*(o+i),h=(n-u)*(l+c),w=f+p-d+h,b=g+d,A=m+p,F=f-m+g+y;return r.set(0,0,w),r.set(0,1,b),r.set(1,0,A),r.set(1,1,F),r}strassen3x3(e){e=v.checkMatrix(e);let r=new v(3,3),t=this.get(0,0),o=this.get(0,1),n=this.get(0,2),i=this.get(1,0),a=this.get(1,1),l=this.get(1,2),u=this.get(2,0),c=this.get(2,1),f=this.get(2,2),m=e.get(0,0),g=e.get(0,1),p=e.get(0,2),d=e.get(1,0),y=e.get(1,1),h=e.get(1,2),w=e.get(2,0),b=e.get(2,1),A=e.get(2,2),F=(t+o+n-i-a-c-f)*y,S=(t-i)*(-g+y),E=a*(-m+g+d-y-h-w+A),M=(-t+i+a)*(m-g+y),j=(i+a)*(-m+g),x=t*m,O=(-t+u+c)*(m-p+h),I=(-t+u)*(p-h),B=(u+c)*(-m+p),D=(t+o+n-a-l-u-c)*h,T=c*(-m+p+d-y-h-w+b),P=(-n+c+f)*(y+w-b),wt=(n-f)*(y-b),Z=n*w,lt=(c+f)*(-w+b),z=(-n+a+l)*(h+w-A),pe=(n-l)*(h-A),ge=(a+l)*(-w+A),Xr=o*d,Zr=l*b,Vr=i*p,Hr=u*g,to=f*A,eo=x+Z+Xr,ro=F+M+j+x+P+Z+lt,oo=x+O+B+D+Z+z+ge,no=S+E+M+x+Z+z+pe,so=S+M+j+x+Zr,io=Z+z+pe+ge+Vr,ao=x+O+I+T+P+wt+Z,lo=P+wt+Z+lt+Hr,uo=x+O+I+B+to;return r.set(0,0,eo),r.set(0,1,ro),r.set(0,2,oo),r.set(1,0,no),r.set(1,1,so),r.set(1,2,io),r.set(2,0,ao),r.set(2,1,lo),r.set(2,2,uo),r}mmulStrassen(e){e=v.checkMatrix(e);let r=this.clone(),t=r.rows,o=r.columns,n=e.rows,i=e.columns;o!==n&&console.warn(`Multiplying ${t} x ${o} and ${n} x ${i} matrix: dimensions do not match.`);function a(f,m,g){let p=f.rows,d=f.columns;if(p===m&&d===g)return f;{let y=s.zeros(m,g);return y=y.setSubMatrix(f,0,0),y}}let l=Math.max(t,n),u=Math.max(o,i);r=a(r,l,u),e=a(e,l,u);function c(f,m,g,p){if(g<=512||p<=512)return f.mmul(m);g%2===1&&p%2===1?(f=a(f,g+1,p+1),m=a(m,g+1,p+1)):g%2===1?(f=a(f,g+1,p),m=a(m,g+1,p)):p%2===1&&(f=a(f,g,p+1),m=a(m,g,p+1));let d=parseInt(f.rows/2,10),y=parseInt(f.columns/2,10),h=f.subMatrix(0,d-1,0,y-1),w=m.subMatrix(0,d-1,0,y-1),b=f.subMatrix(0,d-1,y,f.columns-1),A=m.subMatrix(0,d-1,y,m.columns-1),F=f.subMatrix(d,f.rows-1,0,y-1),S=m.subMatrix(d,m.rows-1,0,y-1),E=f.subMatrix(d,f.rows-1,y,f.columns-1),M=m.subMatrix(d,m.rows-1,y,m.columns-1),j=c(s.add(h,E),s.add(w,M),d,y),x=c(s.add(F,E),w,d,y),O=c(h,s.sub(A,M),d,y),I=c(E,s.sub(S,w),d,y),B=c(s.add(h,b),M,d,y),D=c(s.sub(F,h),s.add(w,A),d,y),T=c(s.sub(b,E),s.add(S,M),d,y),P=s.add(j,I);P.sub(B),P.add(T);let wt=s.add(O,B),Z=s.add(x,I),lt=s.sub(j,x);lt.add(O),lt.add(D);let z=s.zeros(2*P.rows,2*P.columns);return z=z.setSubMatrix(P,0,0),z=z.setSubMatrix(wt,P.rows,0),z=z.setSubMatrix(Z,0,P.columns),z=z.setSubMatrix(lt,P.rows,P.columns),z.subMatrix(0,g-1,0,p-1)}return c(r,e,l,u)}scaleRows(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{min:r=0,max:t=1}=e;if(!Number.isFinite(r))throw new TypeError("min must be a number");if(!Number.isFinite(t))throw new TypeError("max must be a number");if(r>=t)throw new RangeError("min must be smaller than max");let o=new v(this.rows,this.columns);for(let n=0;n<this.rows;n++){let i=this.getRow(n);i.length>0&&Lt(i,{min:r,max:t,output:i}),o.setRow(n,i)}return o}scaleColumns(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{min:r=0,max:t=1}=e;if(!Number.isFinite(r))throw new TypeError("min must be a number");if(!Number.isFinite(t))throw new TypeError("max must be a number");if(r>=t)throw new RangeError("min must be smaller than max");let o=new v(this.rows,this.columns);for(let n=0;n<this.columns;n++){let i=this.getColumn(n);i.length&&Lt(i,{min:r,max:t,output:i}),o.setColumn(n,i)}return o}flipRows(){let e=Math.ceil(this.columns/2);for(let r=0;r<this.rows;r++)for(let t=0;t<e;t++){let o=this.get(r,t),n=this.get(r,this.columns-1-t);this.set(r,t,n),this.set(r,this.columns-1-t,o)}return this}flipColumns(){let e=Math.ceil(this.rows/2);for(let r=0;r<this.columns;r++)for(let t=0;t<e;t++){let o=this.get(t,r),n=this.get(this.rows-1-t,r);this.set(t,r,n),this.set(this.rows-1-t,r,o)}return this}kroneckerProduct(e){e=v.checkMatrix(e);let r=this.rows,t=this.columns,o=e.rows,n=e.columns,i=new v(r*o,t*n);for(let a=0;a<r;a++)for(let l=0;l<t;l++)for(let u=0;u<o;u++)for(let c=0;c<n;c++)i.set(o*a+u,n*l+c,this.get(a,l)*e.get(u,c));return i}kroneckerSum(e){if(e=v.checkMatrix(e),!this.isSquare()||!e.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let r=this.rows,t=e.rows,o=this.kroneckerProduct(v.eye(t,t)),n=v.eye(r,r).kroneckerProduct(e);return o.add(n)}transpose(){let e=new v(this.columns,this.rows);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.set(t,r,this.get(r,t));return e}sortRows(e=lr){for(let r=0;r<this.rows;r++)this.setRow(r,this.getRow(r).sort(e));return this}sortColumns(e=lr){for(let r=0;r<this.columns;r++)this.setColumn(r,this.getColumn(r).sort(e));return this}subMatrix(e,r,t,o){te(this,e,r,t,o);let n=new v(r-e+1,o-t+1);for(let i=e;i<=r;i++)for(let a=t;a<=o;a++)n.set(i-e,a-t,this.get(i,a));return n}subMatrixRow(e,r,t){if(r===void 0&&(r=0),t===void 0&&(t=this.columns-1),r>t||r<0||r>=this.columns||t<0||t>=this.columns)throw new RangeError("Argument out of range");let o=new v(e.length,t-r+1);for(let n=0;n<e.length;n++)for(let i=r;i<=t;i++){if(e[n]<0||e[n]>=this.rows)throw new RangeError(`Row index out of range: ${e[n]}`);o.set(n,i-r,this.get(e[n],i))}return o}subMatrixColumn(e,r,t){if(r===void 0&&(r=0),t===void 0&&(t=this.rows-1),r>t||r<0||r>=this.rows||t<0||t>=this.rows)throw new RangeError("Argument out of range");let o=new v(t-r+1,e.length);for(let n=0;n<e.length;n++)for(let i=r;i<=t;i++){if(e[n]<0||e[n]>=this.columns)throw new RangeError(`Column index out of range: ${e[n]}`);o.set(i-r,n,this.get(i,e[n]))}return o}setSubMatrix(e,r,t){if(e=v.checkMatrix(e),e.isEmpty())return this;let o=r+e.rows-1,n=t+e.columns-1;te(this,r,o,t,n);for(let i=0;i<e.rows;i++)for(let a=0;a<e.columns;a++)this.set(r+i,t+a,e.get(i,a));return this}concat(e,r="row"){switch(e=v.checkMatrix(e),r){case"row":{if(this.columns!==e.columns)throw new RangeError("both matrices must have the same number of columns");let t=new v(this.rows+e.rows,this.columns);return t.setSubMatrix(this,0,0),t.setSubMatrix(e,this.rows,0),t}case"column":{if(this.rows!==e.rows)throw new RangeError("both matrices must have the same number of rows");let t=new v(this.rows,this.columns+e.columns);return t.setSubMatrix(this,0,0),t.setSubMatrix(e,0,this.columns),t}default:throw new Error(`invalid option: ${r}`)}}selection(e,r){We(this,e),De(this,r);let t=new v(e.length,r.length);for(let o=0;o<e.length;o++){let n=e[o];for(let i=0;i<r.length;i++){let a=r[i];t.set(o,i,this.get(n,a))}}return t}trace(){let e=Math.min(this.rows,this.columns),r=0;for(let t=0;t<e;t++)r+=this.get(t,t);return r}clone(){return this.constructor.copy(this,new v(this.rows,this.columns))}static copy(e,r){for(let[t,o,n]of e.entries())r.set(t,o,n);return r}sum(e){switch(e){case"row":return Ue(this);case"column":return Ge(this);case void 0:return Qe(this);default:throw new Error(`invalid option: ${e}`)}}product(e){switch(e){case"row":return Ke(this);case"column":return Ye(this);case void 0:return Je(this);default:throw new Error(`invalid option: ${e}`)}}mean(e){let r=this.sum(e);switch(e){case"row":{for(let t=0;t<this.rows;t++)r[t]/=this.columns;return r}case"column":{for(let t=0;t<this.columns;t++)r[t]/=this.rows;return r}case void 0:return r/this.size;default:throw new Error(`invalid option: ${e}`)}}variance(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let{unbiased:t=!0,mean:o=this.mean(e)}=r;if(typeof t!="boolean")throw new TypeError("unbiased must be a boolean");switch(e){case"row":{if(!$(o))throw new TypeError("mean must be an array");return Xe(this,t,o)}case"column":{if(!$(o))throw new TypeError("mean must be an array");return Ze(this,t,o)}case void 0:{if(typeof o!="number")throw new TypeError("mean must be a number");return Ve(this,t,o)}default:throw new Error(`invalid option: ${e}`)}}standardDeviation(e,r){typeof e=="object"&&(r=e,e=void 0);let t=this.variance(e,r);if(e===void 0)return Math.sqrt(t);for(let o=0;o<t.length;o++)t[o]=Math.sqrt(t[o]);return t}center(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let{center:t=this.mean(e)}=r;switch(e){case"row":{if(!$(t))throw new TypeError("center must be an array");return He(this,t),this}case"column":{if(!$(t))throw new TypeError("center must be an array");return tr(this,t),this}case void 0:{if(typeof t!="number")throw new TypeError("center must be a number");return er(this,t),this}default:throw new Error(`invalid option: ${e}`)}}scale(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let t=r.scale;switch(e){case"row":{if(t===void 0)t=rr(this);else if(!$(t))throw new TypeError("scale must be an array");return or(this,t),this}case"column":{if(t===void 0)t=nr(this);else if(!$(t))throw new TypeError("scale must be an array");return sr(this,t),this}case void 0:{if(t===void 0)t=ir(this);else if(typeof t!="number")throw new TypeError("scale must be a number");return ar(this,t),this}default:throw new Error(`invalid option: ${e}`)}}toString(e){return Ht(this,e)}[Symbol.iterator](){return this.entries()}*entries(){for(let e=0;e<this.rows;e++)for(let r=0;r<this.columns;r++)yield[e,r,this.get(e,r)]}*values(){for(let e=0;e<this.rows;e++)for(let r=0;r<this.columns;r++)yield this.get(e,r)}};L.prototype.klass="Matrix";typeof Symbol<"u"&&(L.prototype[Symbol.for("nodejs.util.inspect.custom")]=ze);function lr(s,e){return s-e}function fn(s){return s.every(e=>typeof e=="number")}L.random=L.rand;L.randomInt=L.randInt;L.diagonal=L.diag;L.prototype.diagonal=L.prototype.diag;L.identity=L.eye;L.prototype.negate=L.prototype.neg;L.prototype.tensorProduct=L.prototype.kroneckerProduct;var v=class s extends L{data;#t(e,r){if(this.data=[],Number.isInteger(r)&&r>=0)for(let t=0;t<e;t++)this.data.push(new Float64Array(r));else throw new TypeError("nColumns must be a positive integer");this.rows=e,this.columns=r}constructor(e,r){if(super(),s.isMatrix(e))this.#t(e.rows,e.columns),s.copy(e,this);else if(Number.isInteger(e)&&e>=0)this.#t(e,r);else if($(e)){let t=e;if(e=t.length,r=e?t[0].length:0,typeof r!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let o=0;o<e;o++){if(t[o].length!==r)throw new RangeError("Inconsistent array dimensions");if(!fn(t[o]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(t[o]))}this.rows=e,this.columns=r}else throw new TypeError("First argument must be a positive number or an array")}set(e,r,t){return this.data[e][r]=t,this}get(e,r){return this.data[e][r]}removeRow(e){return G(this,e),this.data.splice(e,1),this.rows-=1,this}addRow(e,r){return r===void 0&&(r=e,e=this.rows),G(this,e,!0),r=Float64Array.from(nt(this,r)),this.data.splice(e,0,r),this.rows+=1,this}removeColumn(e){Q(this,e);for(let r=0;r<this.rows;r++){let t=new Float64Array(this.columns-1);for(let o=0;o<e;o++)t[o]=this.data[r][o];for(let o=e+1;o<this.columns;o++)t[o-1]=this.data[r][o];this.data[r]=t}return this.columns-=1,this}addColumn(e,r){typeof r>"u"&&(r=e,e=this.columns),Q(this,e,!0),r=st(this,r);for(let t=0;t<this.rows;t++){let o=new Float64Array(this.columns+1),n=0;for(;n<e;n++)o[n]=this.data[t][n];for(o[n++]=r[t];n<this.columns+1;n++)o[n]=this.data[t][n-1];this.data[t]=o}return this.columns+=1,this}};Ce(L,v);var yt=class extends L{constructor(e){super(),this.data=e,this.rows=e.length,this.columns=e[0].length}set(e,r,t){return this.data[e][r]=t,this}get(e,r){return this.data[e][r]}};function ur(s){let e=s.data,r=s.rows;for(let t=0;t<r;t++){let o=e[t];for(let n=t+1;n<r;n++){let i=o[n];o[n]=e[n][t],e[n][t]=i}}return s}function ee(s,e){let r=0;return Math.abs(s)>Math.abs(e)?(r=e/s,Math.abs(s)*Math.sqrt(1+r*r)):e!==0?(r=s/e,Math.abs(e)*Math.sqrt(1+r*r)):0}var ot=class{constructor(e,r={}){let{assumeSymmetric:t=!1}=r;if(e=yt.checkMatrix(e),!e.isSquare())throw new Error("Matrix is not a square matrix");if(e.isEmpty())throw new Error("Matrix must be non-empty");let o=e.columns,n=new v(o,o),i=new Float64Array(o),a=new Float64Array(o),l=e,u,c,f=!1;if(t?f=!0:f=e.isSymmetric(),f){for(u=0;u<o;u++)for(c=0;c<o;c++)n.set(c,u,l.get(u,c));mn(o,a,i,n),hn(o,a,i,n),ur(n)}else{let m=new v(o,o),g=new Float64Array(o);for(c=0;c<o;c++)for(u=0;u<o;u++)m.set(u,c,l.get(u,c));pn(o,m,g,n),gn(o,a,i,n,m)}this.n=o,this.e=a,this.d=i,this.V=n}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let e=this.n,r=this.e,t=this.d,o=new v(e,e),n,i;for(n=0;n<e;n++){for(i=0;i<e;i++)o.set(n,i,0);o.set(n,n,t[n]),r[n]>0?o.set(n,n+1,r[n]):r[n]<0&&o.set(n,n-1,r[n])}return o}};function mn(s,e,r,t){let o,n,i,a,l,u,c,f;for(l=0;l<s;l++)r[l]=t.get(l,s-1);for(a=s-1;a>0;a--){for(f=0,i=0,u=0;u<a;u++)f=f+Math.abs(r[u]);if(f===0)for(e[a]=r[a-1],l=0;l<a;l++)r[l]=t.get(l,a-1),t.set(l,a,0),t.set(a,l,0);else{for(u=0;u<a;u++)r[u]/=f,i+=r[u]*r[u];for(o=r[a-1],n=Math.sqrt(i),o>0&&(n=-n),e[a]=f*n,i=i-o*n,r[a-1]=o-n,l=0;l<a;l++)e[l]=0;for(l=0;l<a;l++){for(o=r[l],t.set(a,l,o),n=e[l]+t.get(l,l)*o,u=l+1;u<=a-1;u++)n+=t.get(l,u)*r[u],e[u]+=t.get(l,u)*o;e[l]=n}for(o=0,l=0;l<a;l++)e[l]/=i,o+=e[l]*r[l];for(c=o/(i+i),l=0;l<a;l++)e[l]-=c*r[l];for(l=0;l<a;l++){for(o=r[l],n=e[l],u=l;u<=a-1;u++)t.set(l,u,t.get(l,u)-(o*e[u]+n*r[u]));r[l]=t.get(l,a-1),t.set(l,a,0)}}r[a]=i}for(a=0;a<s-1;a++){if(t.set(a,s-1,t.get(a,a)),t.set(a,a,1),i=r[a+1],i!==0){for(u=0;u<=a;u++)r[u]=t.get(a+1,u)/i;for(l=0;l<=a;l++){for(n=0,u=0;u<=a;u++)n+=t.get(a+1,u)*t.get(l,u);for(u=0;u<=a;u++)t.set(l,u,t.get(l,u)-n*r[u])}}for(u=0;u<=a;u++)t.set(a+1,u,0)}for(l=0;l<s;l++)r[l]=t.get(l,s-1),t.set(l,s-1,0);t.set(s-1,s-1,1),e[0]=0}function hn(s,e,r,t){let o,n,i,a,l,u,c,f,m,g,p,d,y,h,w,b,A;for(i=1;i<s;i++)e[i-1]=e[i];e[s-1]=0;let F=0,S=0,E=Number.EPSILON;for(u=0;u<s;u++){for(S=Math.max(S,Math.abs(r[u])+Math.abs(e[u])),c=u;c<s&&!(Math.abs(e[c])<=E*S);)c++;if(c>u){A=0;do{for(A=A+1,o=r[u],f=(r[u+1]-o)/(2*e[u]),m=ee(f,1),f<0&&(m=-m),r[u]=e[u]/(f+m),r[u+1]=e[u]*(f+m),g=r[u+1],n=o-r[u],i=u+2;i<s;i++)r[i]-=n;for(F=F+n,f=r[c],p=1,d=p,y=p,h=e[u+1],w=0,b=0,i=c-1;i>=u;i--)for(y=d,d=p,b=w,o=p*e[i],n=p*f,m=ee(f,e[i]),e[i+1]=w*m,w=e[i]/m,p=f/m,f=p*r[i]-w*o,r[i+1]=n+w*(p*o+w*r[i]),l=0;l<s;l++)n=t.get(i+1,l),t.set(i+1,l,w*t.get(i,l)+p*n),t.set(i,l,p*t.get(i,l)-w*n);f=-w*b*y*h*e[u]/g,e[u]=w*f,r[u]=p*f}while(Math.abs(e[u])>E*S)}r[u]=r[u]+F,e[u]=0}for(i=0;i<s-1;i++){for(l=i,f=r[i],a=i+1;a<s;a++)r[a]<f&&(l=a,f=r[a]);if(l!==i)for(r[l]=r[i],r[i]=f,a=0;a<s;a++)f=t.get(i,a),t.set(i,a,t.get(l,a)),t.set(l,a,f)}}function pn(s,e,r,t){let o=0,n=s-1,i,a,l,u,c,f,m;for(f=o+1;f<=n-1;f++){for(m=0,u=f;u<=n;u++)m=m+Math.abs(e.get(u,f-1));if(m!==0){for(l=0,u=n;u>=f;u--)r[u]=e.get(u,f-1)/m,l+=r[u]*r[u];for(a=Math.sqrt(l),r[f]>0&&(a=-a),l=l-r[f]*a,r[f]=r[f]-a,c=f;c<s;c++){for(i=0,u=n;u>=f;u--)i+=r[u]*e.get(u,c);for(i=i/l,u=f;u<=n;u++)e.set(u,c,e.get(u,c)-i*r[u])}for(u=0;u<=n;u++){for(i=0,c=n;c>=f;c--)i+=r[c]*e.get(u,c);for(i=i/l,c=f;c<=n;c++)e.set(u,c,e.get(u,c)-i*r[c])}r[f]=m*r[f],e.set(f,f-1,m*a)}}for(u=0;u<s;u++)for(c=0;c<s;c++)t.set(u,c,u===c?1:0);for(f=n-1;f>=o+1;f--)if(e.get(f,f-1)!==0){for(u=f+1;u<=n;u++)r[u]=e.get(u,f-1);for(c=f;c<=n;c++){for(a=0,u=f;u<=n;u++)a+=r[u]*t.get(u,c);for(a=a/r[f]/e.get(f,f-1),u=f;u<=n;u++)t.set(u,c,t.get(u,c)+a*r[u])}}}function gn(s,e,r,t,o){let n=s-1,i=0,a=s-1,l=Number.EPSILON,u=0,c=0,f=0,m=0,g=0,p=0,d=0,y=0,h,w,b,A,F,S,E,M,j,x,O,I,B,D,T;for(h=0;h<s;h++)for((h<i||h>a)&&(r[h]=o.get(h,h),e[h]=0),w=Math.max(h-1,0);w<s;w++)c=c+Math.abs(o.get(h,w));for(;n>=i;){for(A=n;A>i&&(p=Math.abs(o.get(A-1,A-1))+Math.abs(o.get(A,A)),p===0&&(p=c),!(Math.abs(o.get(A,A-1))<l*p));)A--;if(A===n)o.set(n,n,o.get(n,n)+u),r[n]=o.get(n,n),e[n]=0,n--,y=0;else if(A===n-1){if(E=o.get(n,n-1)*o.get(n-1,n),f=(o.get(n-1,n-1)-o.get(n,n))/2,m=f*f+E,d=Math.sqrt(Math.abs(m)),o.set(n,n,o.get(n,n)+u),o.set(n-1,n-1,o.get(n-1,n-1)+u),M=o.get(n,n),m>=0){for(d=f>=0?f+d:f-d,r[n-1]=M+d,r[n]=r[n-1],d!==0&&(r[n]=M-E/d),e[n-1]=0,e[n]=0,M=o.get(n,n-1),p=Math.abs(M)+Math.abs(d),f=M/p,m=d/p,g=Math.sqrt(f*f+m*m),f=f/g,m=m/g,w=n-1;w<s;w++)d=o.get(n-1,w),o.set(n-1,w,m*d+f*o.get(n,w)),o.set(n,w,m*o.get(n,w)-f*d);for(h=0;h<=n;h++)d=o.get(h,n-1),o.set(h,n-1,m*d+f*o.get(h,n)),o.set(h,n,m*o.get(h,n)-f*d);for(h=i;h<=a;h++)d=t.get(h,n-1),t.set(h,n-1,m*d+f*t.get(h,n)),t.set(h,n,m*t.get(h,n)-f*d)}else r[n-1]=M+f,r[n]=M+f,e[n-1]=d,e[n]=-d;n=n-2,y=0}else{if(M=o.get(n,n),j=0,E=0,A<n&&(j=o.get(n-1,n-1),E=o.get(n,n-1)*o.get(n-1,n)),y===10){for(u+=M,h=i;h<=n;h++)o.set(h,h,o.get(h,h)-M);p=Math.abs(o.get(n,n-1))+Math.abs(o.get(n-1,n-2)),M=j=.75*p,E=-.4375*p*p}if(y===30&&(p=(j-M)/2,p=p*p+E,p>0)){for(p=Math.sqrt(p),j<M&&(p=-p),p=M-E/((j-M)/2+p),h=i;h<=n;h++)o.set(h,h,o.get(h,h)-p);u+=p,M=j=E=.964}for(y=y+1,F=n-2;F>=A&&(d=o.get(F,F),g=M-d,p=j-d,f=(g*p-E)/o.get(F+1,F)+o.get(F,F+1),m=o.get(F+1,F+1)-d-g-p,g=o.get(F+2,F+1),p=Math.abs(f)+Math.abs(m)+Math.abs(g),f=f/p,m=m/p,g=g/p,!(F===A||Math.abs(o.get(F,F-1))*(Math.abs(m)+Math.abs(g))<l*(Math.abs(f)*(Math.abs(o.get(F-1,F-1))+Math.abs(d)+Math.abs(o.get(F+1,F+1))))));)F--;for(h=F+2;h<=n;h++)o.set(h,h-2,0),h>F+2&&o.set(h,h-3,0);for(b=F;b<=n-1&&(D=b!==n-1,b!==F&&(f=o.get(b,b-1),m=o.get(b+1,b-1),g=D?o.get(b+2,b-1):0,M=Math.abs(f)+Math.abs(m)+Math.abs(g),M!==0&&(f=f/M,m=m/M,g=g/M)),M!==0);b++)if(p=Math.sqrt(f*f+m*m+g*g),f<0&&(p=-p),p!==0){for(b!==F?o.set(b,b-1,-p*M):A!==F&&o.set(b,b-1,-o.get(b,b-1)),f=f+p,M=f/p,j=m/p,d=g/p,m=m/f,g=g/f,w=b;w<s;w++)f=o.get(b,w)+m*o.get(b+1,w),D&&(f=f+g*o.get(b+2,w),o.set(b+2,w,o.get(b+2,w)-f*d)),o.set(b,w,o.get(b,w)-f*M),o.set(b+1,w,o.get(b+1,w)-f*j);for(h=0;h<=Math.min(n,b+3);h++)f=M*o.get(h,b)+j*o.get(h,b+1),D&&(f=f+d*o.get(h,b+2),o.set(h,b+2,o.get(h,b+2)-f*g)),o.set(h,b,o.get(h,b)-f),o.set(h,b+1,o.get(h,b+1)-f*m);for(h=i;h<=a;h++)f=M*t.get(h,b)+j*t.get(h,b+1),D&&(f=f+d*t.get(h,b+2),t.set(h,b+2,t.get(h,b+2)-f*g)),t.set(h,b,t.get(h,b)-f),t.set(h,b+1,t.get(h,b+1)-f*m)}}}if(c!==0){for(n=s-1;n>=0;n--)if(f=r[n],m=e[n],m===0)for(A=n,o.set(n,n,1),h=n-1;h>=0;h--){for(E=o.get(h,h)-f,g=0,w=A;w<=n;w++)g=g+o.get(h,w)*o.get(w,n);if(e[h]<0)d=E,p=g;else if(A=h,e[h]===0?o.set(h,n,E!==0?-g/E:-g/(l*c)):(M=o.get(h,h+1),j=o.get(h+1,h),m=(r[h]-f)*(r[h]-f)+e[h]*e[h],S=(M*p-d*g)/m,o.set(h,n,S),o.set(h+1,n,Math.abs(M)>Math.abs(d)?(-g-E*S)/M:(-p-j*S)/d)),S=Math.abs(o.get(h,n)),l*S*S>1)for(w=h;w<=n;w++)o.set(w,n,o.get(w,n)/S)}else if(m<0)for(A=n-1,Math.abs(o.get(n,n-1))>Math.abs(o.get(n-1,n))?(o.set(n-1,n-1,m/o.get(n,n-1)),o.set(n-1,n,-(o.get(n,n)-f)/o.get(n,n-1))):(T=Bt(0,-o.get(n-1,n),o.get(n-1,n-1)-f,m),o.set(n-1,n-1,T[0]),o.set(n-1,n,T[1])),o.set(n,n-1,0),o.set(n,n,1),h=n-2;h>=0;h--){for(x=0,O=0,w=A;w<=n;w++)x=x+o.get(h,w)*o.get(w,n-1),O=O+o.get(h,w)*o.get(w,n);if(E=o.get(h,h)-f,e[h]<0)d=E,g=x,p=O;else if(A=h,e[h]===0?(T=Bt(-x,-O,E,m),o.set(h,n-1,T[0]),o.set(h,n,T[1])):(M=o.get(h,h+1),j=o.get(h+1,h),I=(r[h]-f)*(r[h]-f)+e[h]*e[h]-m*m,B=(r[h]-f)*2*m,I===0&&B===0&&(I=l*c*(Math.abs(E)+Math.abs(m)+Math.abs(M)+Math.abs(j)+Math.abs(d))),T=Bt(M*g-d*x+m*O,M*p-d*O-m*x,I,B),o.set(h,n-1,T[0]),o.set(h,n,T[1]),Math.abs(M)>Math.abs(d)+Math.abs(m)?(o.set(h+1,n-1,(-x-E*o.get(h,n-1)+m*o.get(h,n))/M),o.set(h+1,n,(-O-E*o.get(h,n)-m*o.get(h,n-1))/M)):(T=Bt(-g-j*o.get(h,n-1),-p-j*o.get(h,n),d,m),o.set(h+1,n-1,T[0]),o.set(h+1,n,T[1]))),S=Math.max(Math.abs(o.get(h,n-1)),Math.abs(o.get(h,n))),l*S*S>1)for(w=h;w<=n;w++)o.set(w,n-1,o.get(w,n-1)/S),o.set(w,n,o.get(w,n)/S)}for(h=0;h<s;h++)if(h<i||h>a)for(w=h;w<s;w++)t.set(h,w,o.get(h,w));for(w=s-1;w>=i;w--)for(h=i;h<=a;h++){for(d=0,b=i;b<=Math.min(w,a);b++)d=d+t.get(h,b)*o.get(b,w);t.set(h,w,d)}}}function Bt(s,e,r,t){let o,n;return Math.abs(r)>Math.abs(t)?(o=t/r,n=r+o*t,[(s+o*e)/n,(e-o*s)/n]):(o=r/t,n=t+o*r,[(o*s+e)/n,(o*e-s)/n])}var dn=1e-9,yn=1e-13,wn=1e-6;function cr(s,e,r){let t=Et(s,r);if(!t)throw new Error("mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate");let[o,n]=[0,0];for(let f=0;f<r;f+=1)for(let m=0;m<r;m+=1)o=Math.max(o,Math.abs(e[f*r+m]-e[m*r+f])),n=Math.max(n,Math.abs(e[f*r+m]));if(o>dn*n)return{...oe(t,re(kt(t,e,r),r,!1),r),symmetric:!1};let i=e.map((f,m)=>(f+e[m%r*r+Math.floor(m/r)])/2),a=Et(i,r),l=a&&re(kt(a,s,r),r,!0),u=l?Math.max(...l.re):0;if(!a||!l||Math.min(...l.re)<=0||1/u<=yn*r/Math.min(...l.re))return{...oe(t,re(kt(t,i,r),r,!0),r),symmetric:!0};let c=oe(a,{re:l.re.map(f=>1/f),vectors:l.vectors},r);return{squares:c.squares,shapes:c.shapes.map((f,m)=>f*Math.sqrt(c.squares[m%r])),symmetric:!0}}function re(s,e,r){let t=r?s.map((u,c)=>(u+s[c%e*e+Math.floor(c/e)])/2):s,o=new ot(v.from1DArray(e,e,t),{assumeSymmetric:r}),{realEigenvalues:n,imaginaryEigenvalues:i,eigenvectorMatrix:a}=o,l=Float64Array.from(a.to1DArray());if(!r){for(let u=1;u<e;u+=1)if(i[u]<0)for(let c=0;c<e;c+=1)l[c*e+u]=l[c*e+u-1]}for(let u=0;u<e;u+=1){let c=Math.hypot(...Array.from({length:e},(f,m)=>l[m*e+u]));for(let f=0;f<e;f+=1)l[f*e+u]/=c}return{re:Float64Array.from(n),vectors:l}}function oe(s,{re:e,vectors:r},t){let o=Array.from(e.keys()).sort((i,a)=>e[i]-e[a]),n=new Float64Array(t*t);return o.forEach((i,a)=>{for(let l=0;l<t;l+=1)n[l*t+a]=r[l*t+i]}),Ut(s,n,t,t),{squares:Float64Array.from(o,i=>e[i]),shapes:n}}function fr(s,e,r,t,o){let n=o.symmetric?o.shapes:Fn(s,t),i=d=>q(n,q(d,n,t,t,t),t,t,t,!0),[a,l]=[i(r),i(e)];if(o.symmetric)for(let d=0;d<t*t;d+=1)a[d]=d%(t+1)?0:o.squares[d/(t+1)];let u=Array.from({length:t},(d,y)=>Math.sqrt(Math.abs(a[y*(t+1)]))),c=wn*Math.max(...u)||1,f=u.map(d=>Math.max(d,c)),m=v.zeros(2*t,2*t);for(let d=0;d<t;d+=1){m.set(d,t+d,f[d]);for(let y=0;y<t;y+=1)m.set(t+d,y,-a[d*t+y]/f[y]),m.set(t+d,t+y,-l[d*t+y])}let g=new ot(m,{assumeSymmetric:!1}),p={re:Float64Array.from(g.realEigenvalues),im:Float64Array.from(g.imaginaryEigenvalues)};return{count:2*t,values:p,shapes:bn(g.eigenvectorMatrix,p.im,n,f,t)}}function bn(s,e,r,t,o){let n={re:new Float64Array(2*o*o),im:new Float64Array(2*o*o)};for(let i=0;i<2*o;i+=1)for(let a=0;a<o;a+=1)n.re[2*o*a+i]=s.get(a,e[i]<0?i-1:i)/t[a],n.im[2*o*a+i]=(e[i]>0?s.get(a,i+1):e[i]<0?-s.get(a,i):0)/t[a];return{re:q(r,n.re,o,o,2*o),im:q(r,n.im,o,o,2*o)}}function Fn(s,e){let r=Float64Array.from({length:e*e},(t,o)=>o%(e+1)?0:1);return Ut(Et(s,e),r,e,e),r}function ne({data:s,shape:[,e]},r,t){let o=[0,0,0];for(let i=0;i<3*e;i+=1)o[i%3]+=s[3*e*r+i];let n=Math.hypot(...o);return t<0||n===0?n:o.reduce((i,a,l)=>i+a*s[3*(e*r+t)+l],0)/n}var An=["settling","vibration.residual","vibration.nominal"];function W(s,e=3){return K(s,e)}function se(s,e){if(s.length<2)return e[0];let r=0;for(let t=1;t<s.length;t+=1)r+=(e[t]+e[t-1])/2*(s[t]-s[t-1]);return r/(s[s.length-1]-s[0])}function hr(s,e,r,t){let o={},{tip_error:n}=e;if(n){let a=Float64Array.from(s,(l,u)=>ne(n,u,-1));o["tip_error.commanded"]=mr(s,a,n,t)}let i=e.deviation?.data;return i&&(o["deviation.max"]=mr(s,i,e.tip_error_nominal,t),o["deviation.rms"]={value:Math.sqrt(se(s,i.map(a=>a*a))),note:"over the run"}),{...o,...Mn(s,r,i!==void 0)}}function mr(s,e,r,t){let o=gt(e),n=`at ${W(s[o])} s; ${V(e[e.length-1],"m")} at the end of the run`,a=(r?_(0,r.shape[1]).map(l=>[ne(r,o,l),t[l]]):[]).filter(([l])=>l).map(([l,u])=>`${V(l,"m")} ${u??"geometry"}`);return{value:e[o],note:n,time:s[o],more:a.join(", ")}}function Mn(s,e,r){let t=s[s.length-1];if(e!==null&&e<=t*(1+1e-9))return{};let o="what moves the robot changes up to the end of the run",n=`the run ends at ${W(t,6)} s, the move at ${W(e??0,6)} s`,i=e===null?o:`${n}: simulate longer to see it settle`,a={value:null,note:e===null?o:"the run ends with the move"},l={settling:{value:null,note:`not seen: ${i}`},"vibration.residual":a};return r?{...l,"vibration.nominal":a}:l}function pr(s){let e={},r=An.filter(t=>t!=="vibration.nominal"||"deviation.max"in s);for(let t of r)e[t]={value:null,note:"the run broke off"};for(let[t,o]of Object.entries(s))r.includes(t)||(e[t]={...o,note:`until it broke off: ${o.note}`});return e}function gr(s,e){if(!s.energy||!s.energy_balance)return{};let{energy:r,work:t}=s,o=r.shape[1],n=Math.max(r.data.reduce((l,u,c)=>Math.max(l,Math.abs(u-r.data[c%o])),0),t.data.reduce((l,u)=>Math.max(l,Math.abs(u)),0)),i=Math.abs(s.energy_balance.data[gt(s.energy_balance.data.subarray(0,e))]),a=n?`worst residual, ${V(i,"J")}, over ${V(n,"J")} moved`:"nothing moved";return{"energy.residual":{value:n?i/n:null,note:a}}}var Sn=8,ie=1e-5,vn=Math.SQRT1_2,En=1e-9;function dr(s,e,r,t){let o=Object.entries(s).flatMap(([a,l])=>l.filter(u=>u.frequency>0).slice(0,Sn).map(u=>[a,u])),n=xn(o,r,t),i=e.flatMap(a=>a.rings&&a.damping<vn?[{at:a.rings,label:a.element}]:[]);return{vibration:{modes:n,marks:i.sort((a,l)=>a.at-l.at)},facts:kn(s)}}function kn({controlled:s,locked:e}){if(!s)return{};let r=i=>i.reduce((a,{rings:l,frequency:u})=>l&&u<(a??1/0)?u:a,null),[t,o]=[r(s),r(e??[])],n=t===null?"no vibration under control":o===null?"":`${W(o,4)} Hz with the motors locked`;return{"frequency.first":{value:t,note:n}}}function xn(s,e,r){let t=e.length,o=new Float64Array((1+4*s.length)*t);o.set(e),s.forEach(([,{re:c,im:f}],m)=>{let g=c.reduce((p,d,y)=>Math.max(p,Math.hypot(d,f[y])),0);for(let p=0;p<t;p+=1){let[d,y]=[ie*c[p]/g,ie*f[p]/g];[d,y,-d,-y].forEach((h,w)=>{o[(1+4*m+w)*t+p]=e[p]+h})}});let{data:n,shape:i}=r(o,1+4*s.length),a=n.length/(1+4*s.length),l=c=>Float64Array.from({length:a},(f,m)=>(n[c*a+m]-n[(c+2)*a+m])/(2*ie)),u=c=>({data:Float32Array.from(c),shape:i.slice(1)});return s.map(([c,f],m)=>{let[g,p]=jn(l(1+4*m),l(2+4*m));return{case:c,frequency:f.frequency,damping:f.damping,element:f.element,rest:u(n.subarray(0,a)),real:u(g),imaginary:u(p)}})}function jn(s,e){let[r,t]=[0,0];for(let u=0;u<s.length;u+=3){let c=Math.hypot(...s.subarray(u,u+3),...e.subarray(u,u+3));c>t&&([r,t]=[u,c])}if(!t)return[s,e];let o=[0,1,2].map(u=>Math.hypot(s[r+u],e[r+u])),n=r+o.indexOf(Math.max(...o)),i=Math.hypot(s[n],e[n])*t,[a,l]=[s[n]/i,-e[n]/i];return[s.map((u,c)=>a*u-l*e[c]),s.map((u,c)=>l*u+a*e[c])]}function yr(s,e){let[r,t]=[s.values.re[e],s.values.im[e]],o=Math.hypot(r,t);return{size:o,rings:t>En*o?t/(2*Math.PI):null,damping:o?-r/o:0}}function wr(s,e,r,t,o){let n=i=>Float64Array.from({length:r},(a,l)=>{let u=0;for(let c=0;c<t;c+=1)u+=o(l,c)*i[c*s.count+e];return u});return{re:n(s.shapes.re),im:n(s.shapes.im)}}function br(s,e,r,t){let{count:o,shapes:n}=e,i=y=>h=>{if(!t)return y(h);let w=0;for(let b=0;b<r;b+=1)w+=t[h*r+b]*y(b);return w},a=(y,h)=>{let w=0;for(let b=0;b<r;b+=1)w+=y(b)*h(b);return w},l=ae(s.shapes,r,r),[u,c]=[ae(n.re,r,o),ae(n.im,r,o)],f=l.map(y=>Float64Array.from({length:r},(h,w)=>i(b=>y[b])(w))),m=y=>a(h=>y[h],i(h=>y[h])),[g,p]=[l.map(y=>Math.sqrt(m(y))),u.map((y,h)=>Math.sqrt(m(y)+m(c[h])))],d=new Float64Array(r*o);for(let y=0;y<r;y+=1)for(let h=0;h<o;h+=1){let[w,b]=[u,c].map(A=>a(F=>f[y][F],F=>A[h][F]));d[y*o+h]=Math.hypot(w,b)/(g[y]*p[h])}return d}function ae(s,e,r){return Array.from({length:r},(t,o)=>Float64Array.from({length:e},(n,i)=>s[i*r+o]))}function Rn({values:s,count:e}){let r=Array.from({length:e},(t,o)=>Math.hypot(s.re[o],s.im[o]));return{rings:r.map((t,o)=>s.im[o]>1e-9*t),stands:r.map((t,o)=>Math.abs(s.im[o])<=1e-9*t)}}function Fr(s,e,r){let{count:t,values:o}=e,{rings:n,stands:i}=Rn(e),a=new Float64Array(t);Array.from({length:t},(u,c)=>c).sort((u,c)=>o.re[c]-o.re[u]).forEach((u,c)=>{a[u]=c});let l=Float64Array.from(s,(u,c)=>{let f=c%t;return!n[f]&&!i[f]?100:a[f]/(10*t)-u*u-(n[f]?10:0)});return Ln(l,r,t)}function Ln(s,e,r){let[t,o]=[new Float64Array(e+1),new Float64Array(r+1)],n=new Int32Array(r+1);for(let a=1;a<=e;a+=1){let l=new Float64Array(r+1).fill(1/0),u=new Int32Array(r+1),c=new Uint8Array(r+1);n[0]=a;let f=0;for(;n[f];){c[f]=1;let[m,g]=[1/0,0];for(let p=1;p<=r;p+=1){if(c[p])continue;let d=s[(n[f]-1)*r+p-1]-t[n[f]]-o[p];d<l[p]&&(l[p]=d,u[p]=f),l[p]<m&&(m=l[p],g=p)}for(let p=0;p<=r;p+=1)c[p]?(t[n[p]]+=m,o[p]-=m):l[p]-=m;f=g}for(;f;f=u[f])n[f]=n[u[f]]}let i=new Array(e).fill(-1);for(let a=1;a<=r;a+=1)n[a]&&(i[n[a]-1]=a-1);return i}var On=1e-13,In=1e-13,Bn="whole arm, free",Nn="whole arm, in its weight and loads";function Sr(s,e,r,{blocks:t,schedule:o,info:n},i){if(!e.modes)return{vibration:e.noModes,facts:{}};try{let{rest:a,linear:l}=Ar(s,e,r,o,R(e.modes.rest)),u=Object.fromEntries(e.modes.cases.map(({name:d,moving:y})=>[d,Mr(e,t,l,d,y)])),{name:c,moving:f}=e.modes.cases.find(d=>d.name==="controlled"&&d.moving.length)??e.modes.cases.find(d=>d.name==="locked"),m=Tn(e,n,o,i),g=m&&Ar(s,e,r,o,m,i.times[i.times.length-1]).linear,p=g?Mr(e,t,g,c,f):[];return dr(u,p,a,(d,y)=>Rt(s,e,t,d,y).line)}catch(a){return{vibration:a instanceof Error?a.message:String(a),facts:{}}}}function Ar(s,e,r,t,o,n=0){let i=null;return Kt(e,r,"real",o,(a,l)=>(i=Ne(s,e,ct(e.map,a,"real"),t,l,n),i&&i.rest)),i}function Tn(s,e,r,t){if(!s.modes.end)return null;let o=R(s.modes.end).slice(),[n,i]=[t.times[t.times.length-1],t.series.q.data.subarray(-o.length)],a=new Map(e.commanded);for(let l=0;l<o.length;l+=1){let u=a.get(l);s.modes.free.includes(l)||(o[l]=u===void 0?i[l]:et(r,u,n))}return o}function Mr(s,e,r,t,o){let n=Math.sqrt(r.mass.length),i=o.length;if(!i)return[];let a=y=>Float64Array.from({length:i*i},(h,w)=>y[o[Math.floor(w/i)]*n+o[w%i]]),[l,u,c]=[a(r.mass),a(r.damping),a(r.stiffness)],f=t==="controlled";f&&s.modes.servos.forEach(({coordinate:y},h)=>{let w=o.indexOf(y)*(i+1);c[w]+=e.servos[2*h],u[w]+=e.servos[2*h+1]});let m=cr(l,c,i),g=fr(l,u,c,i,m),p=Fr(br(m,g,i,l),g,i),d=In*i*m.squares.reduce((y,h)=>Math.max(y,Math.abs(h)),0);return Array.from({length:i},(y,h)=>{let w=new Float64Array(n);o.forEach((I,B)=>{w[I]=m.shapes[B*i+h]});let b=$n(s,e,r.elastic,w,f),A=wr(g,p[h],n,i,(I,B)=>o[B]===I?1:0),F=m.squares[h],S=b.reduce((I,{energy:B})=>I+B,0);if(Math.abs(F)<=d&&S<=d)return{frequency:0,rings:null,damping:0,element:Bn,...A};let{size:E,rings:M,damping:j}=yr(g,p[h]),x=(f&&M?E:Math.sqrt(Math.max(F,0)))/(2*Math.PI),O=b.reduce((I,B)=>B.energy>I.energy?B:I,b[0]);return{frequency:x,rings:M,damping:Math.abs(j)>On?j:0,element:S>d&&O?O.element:Nn,...A}})}function $n(s,e,r,t,o){let n=t.length,i=c=>{let f=0;for(let m=0;m<n;m+=1)f+=r[c*n+m]*t[m];return f},{springs:a,servos:l}=s.modes,u=a.map(({element:c,rows:f,gear:m})=>{if(!m)return{element:c,energy:f.reduce((p,d)=>p+t[d]*i(d),0)};let g=r[f[0]*(n+1)];return{element:c,energy:g?i(f[0])**2/g:0}});return o?[...u,...l.map(({coordinate:c,element:f},m)=>({element:f,energy:e.servos[2*m]*t[c]**2}))]:u}var vr=1e-6,qn=1e-11,Er=.5,le=40,_n=.1,kr=24;async function xr(s,e,r,t,o,n,i){let{free:a,gross:l}=e.split;if(!a.length)return{};let u=o.length,c=n.q.shape[1],f=h=>J({matrix:l,constant:{data:new Float64Array(c),shape:[c]}},n[h].data,u),m=St(e,r,t,o,n),g={engine:s,blocks:r,free:a,size:c,places:m.length/u,weight:R(e.split.weight),q:n.q.data.slice(),rates:f("v"),gains:f("a"),wrenches:m},p=n.deformation.data,d=null;for(let h=0;h<u;h+=kr){let w=Array.from({length:Math.min(kr,u-h)},(b,A)=>h+A);if(h&&Pn(g,p,J(e.deflections,g.q.subarray((h-1)*c,h*c),1),w),d=zn(g,n.q.data,w,d),!d)return{};await i()}let y=J(e.deflections,g.q,u);return{deformation_stationary:k(y,u,a.length),deformation_oscillatory:k(rt(p,y),u,a.length)}}function Pn(s,e,r,t){let o=s.free.length;for(let n of t)s.free.forEach((i,a)=>{s.q[n*s.size+i]+=r[a]-e[n*o+a]})}function fe(s,e,r){let{engine:t,blocks:o,free:n,size:i}=s,a={q:e,v:Y(s.rates,i,r),a:Y(s.gains,i,r),base:s.weight,wrenches:Y(s.wrenches,s.places,r)},l=jt(t,o,a,r.length),u=t.sample("elastic",o.chain,a,r.length).forces;return Float64Array.from({length:r.length*n.length},(c,f)=>{let m=Math.floor(f/n.length)*i+n[f%n.length];return l[m]+u[m]})}function ce(s,e,r){let{free:t,size:o}=s,n=t.length,i=new Float64Array((n+1)*o);for(let l=0;l<=n;l+=1)i.set(e,l*o);t.forEach((l,u)=>{i[u*o+l]+=vr});let a=fe(s,i,new Array(n+1).fill(r));return je(Float64Array.from({length:n*n},(l,u)=>(a[u%n*n+Math.floor(u/n)]-a[n*n+Math.floor(u/n)])/vr),n)}function zn(s,e,r,t){let o=l=>s.q.subarray(l*s.size,(l+1)*s.size),n=l=>ce(s,o(l[l.length>>1]),l[l.length>>1]),i=t??n(r);if(!i)return null;let a=ue(s,r,i,le);a.length&&(i=n(a)??i),a=ue(s,a,i,le);for(let l of a){let[u,c]=[le,[l]];for(;c.length&&u;u-=1){let f=ce(s,o(l),l);c=f?ue(s,c,f,3):c}c.length&&Cn(s,e,l)}return i}function ue(s,e,r,t){let{free:o,size:n,q:i}=s,a=o.length,l=[],u=new Map,c=e;for(let f=0;f<t&&c.length;f+=1){let m=fe(s,Y(i,n,c),c);c=c.filter((g,p)=>{let d=q(r,m.subarray(p*a,(p+1)*a),a,a,1),y=d.reduce((b,A)=>Math.max(b,Math.abs(A)),0),h=y>Er?Er/y:1;if(!Number.isFinite(y))return l.push(g)&&!1;if(o.forEach((b,A)=>{i[g*n+b]-=h*d[A]}),y<qn)return!1;let w=y>_n*(u.get(g)??1/0);return u.set(g,y),w?l.push(g)&&!1:!0})}return[...l,...c]}function Cn(s,e,r){let t=e.slice(r*s.size,(r+1)*s.size),o=ce(s,t,r);if(s.q.set(t,r*s.size),!o)return;let n=s.free.length,i=q(o,fe(s,t,[r]),n,n,1);s.free.forEach((a,l)=>{s.q[r*s.size+a]-=i[l]})}var Wn=50;async function jr(s,e,r,t,o,n){let i=performance.now(),a=async(f=!1)=>{if(!(!f&&performance.now()-i<Wn)){if(await new Promise(m=>setTimeout(m,0)),n.cancelled?.())throw new tt("a newer run began");i=performance.now()}};await a(!0);let{vibration:l,facts:u}=Sr(s,e,r,o,t);await a(!0);let c=await xr(s,e,o.blocks,o.schedule,t.times,t.series,a);return{...t,vibration:l,facts:{...t.facts,...u},series:{...t.series,...c}}}var Dn=1e-12;function Or(s,e,[r,t],[o,n],i){if(!e.errorParts||!o)return{};let a=(n??o).model.q.slice(),l=a.length/i;for(let[y,h]of[...r.info.commanded,...r.info.exact])for(let w=0;w<i;w+=1)a[w*l+y]=et(r.schedule,h,r.run.times[w]);let u=Lr(s,e,r,o,a,i),c=n?Lr(s,e,t,n,a,i):u,f=Rr(u),m=rt(u[0],c[0]),g=Rr(c);(e.errorParts.length>f.length||m.subarray(0,3).some(y=>Math.abs(y)>Dn))&&(f.push(m),g.push(new Float64Array(m.length)));let p=y=>{let h=new Float64Array(3*i*y.length);return y.forEach((w,b)=>w.forEach((A,F)=>{h[3*(Math.floor(F/3)*y.length+b)+F%3]=A})),k(h,i,y.length,3)},d={tip_commanded:k(c[0],i,3),tip_error:p(f)};return n&&(d.tip_error_nominal=p(f.map((y,h)=>rt(y,g[h])))),d}function Rr(s){return s.slice(1).map((e,r)=>rt(e,s[r]))}function Lr(s,e,r,{model:{q:t},points:o},n,i){let a=t.length/i,[l,u]=[n.slice(),t.slice()];for(let y=0;y<t.length;y+=a){for(let h of r.info.driven)l[y+h]=t[y+h];for(let h of e.bends)u[y+h]=0}let c=y=>N(y,y.length/i,[9,10,11]),f=new Float64Array(a),[m,g]=[t,c(o)],p=[g],d=y=>J(e.straight,y,i);for(let y of[u,d(l),d(n)]){if(!y.every((h,w)=>h===m[w])){let h={q:y,v:f,a:f,base:R(e.base)};g=c(s.sample("inertia",r.blocks.chain,h,i).points)}m=y,p.unshift(g)}return p}function Br(s,e,r,t){let n={...hr(e,r,t,s.errorParts??[]),...gr(r,e.length)},i=s.deformations.flatMap((g,p)=>g.endsWith(".gear")?[p]:[]),a=i.filter(g=>s.turning.includes(s.deformations[g].replace(/\\.gear$/,""))),l=a.length?a:i;if(l.length){let g=N(r.deformation.data,s.deformations.length,l),p=l.length<i.length?" (of the gears that turn)":"",{value:d,note:y}=Ir(e,g,l.map(h=>s.deformations[h].replace(/\\.gear$/,"")));n["gear.max"]={value:d,note:`${y}${p}`}}let{drives:u}=s.layout,c=_(0,u.length),f=c.filter(g=>s.turning.includes(u[g]));for(let[g,p]of[["gear_torque",f.length?f:c],["voltage",c]]){if(!r[g])continue;let d=Ir(e,N(r[g].data,u.length,p),p.map(y=>u[y]));d.value&&(n[`${g}.max`]=d)}let m=r.contact_force_normal?.data;if(m){let[g,p]=[m.reduce((d,y)=>Math.min(d,y)),m.reduce((d,y)=>Math.max(d,y))];n["contact.mean"]={value:se(e,m),note:`from ${W(g,4)} to ${W(p,4)} N`}}return n}function Ir(s,e,r){let t=gt(e),o=`${r[t%r.length]}, at ${W(s[Math.floor(t/r.length)])} s`;return{value:Math.abs(e[t]),note:o,time:s[Math.floor(t/r.length)]}}function Nr(s,{strengths:e,places:r,kept:t},o){let n=[s.every>1?`one sample in ${s.every}`:"",t>r.data.length?`${r.data.length} places along each link`:""],i=n.some(Boolean)?` (looked at: ${n.filter(Boolean).join(", ")})`:"",a=m=>s.links.flatMap(({largest:g})=>g[m]??[]),l=(m,g)=>{let p=me(g,({value:h})=>h),d=p&&m!=="deflection.max"?` at s = ${W(p.s,2)}`:"",y=p?o[p.sample]:0;return p?{[m]:{value:p.value,note:`${p.link}${d}, at ${W(y)} s${i}`,time:y}}:{}},u=me(a("stress").filter(({link:m})=>m in e),({link:m,value:g})=>g/e[m]),c=u?e[u.link]:1,f=u&&`of ${V(c,"Pa")}, ${u.link}; margin ${W(100*(1-u.value/c))} %${i}`;return{...l("deflection.max",a("deflection")),...l("moment.max",a("moment")),...l("stress.max",a("stress")),...u&&f?{"stress.share":{value:100*u.value/c,note:f}}:{}}}function Tr(s,e){let r=me(s.flatMap(t=>Un(t,e)),({share:t})=>t);return r?{"limits.share":{value:100*r.share,note:r.note}}:{}}function Un({joint:s,coordinate:e,drive:r,unit:t,effortUnit:o,speed:n,effort:i,range:a},l){let u=(f,m,g=0)=>N(l[f].data,l[f].shape[1],[m]).reduce((p,d)=>Math.max(p,Math.abs(d-g)),0),c=(f,m,g,p)=>({share:f/m,note:`${g} of ${s}: ${V(f,p)} of ${V(m,p)}`});return[...n?[c(u("v",e),n,"speed",`${t}/s`)]:[],...i&&r>=0?[c(u("effort",r),i,"effort",o)]:[],...a?[{share:u("q",e,a[0])/a[1],note:`range of ${s}, from its middle`}]:[]]}function me(s,e){return s.reduce((r,t)=>r===null||e(t)>e(r)?t:r,null)}var Nt=["y","z"],Gn=[{id:"deflection",of:"deflection",label:"Deflection",unit:"m",planes:Nt},{id:"slope",of:"slope",label:"Slope",unit:"rad",planes:Nt},{id:"moment",of:"moment",label:"Moment",unit:"N m",planes:["torsion",...Nt]},{id:"shear_force",of:"shear",label:"Shear force",unit:"N",planes:Nt}];function $r(s,e,r){if(!e.length)return null;let t=s.stations.data,[o,n]=[e.length,t.length],i=Float64Array.from({length:o*n},(a,l)=>e[Math.floor(l/n)].length*t[l%n]);return{links:e.map(a=>a.name),places:{data:i,shape:[o,n]},quantities:Gn.map(({id:a,of:l,label:u,unit:c,planes:f})=>{let m=new Float64Array(r*o*n*f.length);return e.forEach((g,p)=>_r(g[l],m,r,p,o,n*f.length)),{id:a,label:u,unit:c,planes:[...f],values:{data:m,shape:[r,o,n,f.length]}}})}}function qr(s,e,r){let[t,o]=[s.links.length,s.stations.data.length],n=(l,u,c,f)=>{let m=new Float64Array(r*t*o);return s.links.forEach((g,p)=>{let d=g.bends?e.find(h=>h.name===g.name):void 0,y=d&&f(d);y&&_r(y,m,r,p,t,o)}),{id:l,label:u,unit:c,values:{data:m,shape:[r,t,o]}}};if(!e.length)return[];let a=[n("bending_moment","Bending moment","N m",({moment:l})=>Float64Array.from({length:r*o},(u,c)=>Math.sqrt(l[3*c+1]**2+l[3*c+2]**2))),n("torsion","Torsional moment","N m",({moment:l})=>Float64Array.from({length:r*o},(u,c)=>Math.abs(l[3*c]))),n("deflection","Deflection from the root\'s tangent","m",({deflection:l})=>ft(l,2))];return e.some(l=>l.stress)?[...a,n("stress","Largest stress (von Mises)","Pa",({stress:l})=>l&&l.mises),n("strain","Largest strain","1",({stress:l})=>l&&l.strain)]:a}function _r(s,e,r,t,o,n){for(let i=0;i<r;i+=1)e.set(s.subarray(i*n,(i+1)*n),(i*o+t)*n)}var Qn=100;function Kn(s,e,r,t,o){let n=new Float64Array(1),i={time:n,row:Mt(t,n),step:new Float64Array(1)};for(let a=0;`${e}.switched`in s.layout.samples&&a<Qn;a+=1){let l=o;if(o=s.sample(`${e}.switched`,r.parameters,{...i,state:o},1).state,o.every((u,c)=>u===l[c]))break}return o}async function Pr(s,e,r,t,o,n){let{settings:i}=e,a=e.runs[t],l=_(0,a.signals).map(f=>Pt(o[`knots.${f}`],o[`coefficients.${f}`])),u=Me(l.map(f=>zt(f,i.duration)));l.length||(u.knots[1]=i.duration);let c=await ye(s,{loop:`${t}.${i.method}`,parameters:o.parameters,knots:u.knots,rows:Fe(u),state:Kn(s,t,o,u,Be(s,e,r,t,u)),times:R(e.times),settings:i},n);return{name:t,info:a,blocks:o,each:l,schedule:u,run:c}}var X=24;function zr(s,e,r,t){let o=r.run.times.subarray(0,t),n=r.run.states.subarray(0,t*(r.run.states.length/r.run.times.length)),i=Mt(r.schedule,o),a={time:o,state:n,row:i,step:new Float64Array(1)},l=s.sample(`${r.name}.observe`,r.blocks.parameters,a,t),{q:u,v:c,a:f}=l,m=R(e.base),{chain:g,rotors:p}=r.blocks,{points:d}=s.sample("inertia",g,{q:u,v:c,a:f,base:m},t),y=new Float64Array(p.length),h=s.sample("inertia",g,{q:u,v:y,a:c,base:m},t),w=s.sample("elastic",g,{q:u,v:c,base:m},t).energies;return{model:l,points:d,energy:Yn(e,c,p,h,w,t)}}function Yn(s,e,r,t,o,n){let i=r.length,a=o.length/n,l=new Float64Array(4*n);for(let u=0;u<n;u+=1){for(let c=0;c<i;c+=1){let f=e[u*i+c];l[4*u]+=(t.forces[u*i+c]+r[c]*f)*f/2}for(let c=0;c<3;c+=1)l[4*u+1]-=t.moment[3*u+c]*s.gravity.data[c];for(let c=0;c<a;c+=1)l[4*u+2+c%2]+=o[u*a+c]}return l}function Cr(s,e,{model:r,points:t,energy:o},n){let i=r.q.length/n,a=r.gear.length/n,l=t.length/n/X,u=e.run.states.length/e.run.times.length,c=N(e.run.states.subarray(0,n*u),u,_(...e.info.state.works)),f=h=>k(N(r.drives,4*a,_(0,a).map(w=>4*w+h)),n,a),m=h=>N(t,l*X,_(0,l).flatMap(w=>_(0,3).map(b=>w*X+h+b))),g=N(t,l*X,_(0,l).flatMap(h=>_(h*X,h*X+9))),p={q:k(r.q,n,i),v:k(r.v,n,i),a:k(r.a,n,i),deformation:k(J(s.deflections,r.q,n),n,s.deformations.length),position:k(m(9),n,l,3),velocity:k(m(12),n,l,3),acceleration:k(m(18),n,l,3),rotation:k(g,n,l,3,3),tip:k(N(t,l*X,[9,10,11]),n,3),tip_velocity:k(N(t,l*X,[12,13,14]),n,3),energy:k(o,n,4),work:k(c,n,c.length/n),energy_balance:k(Te(o,c,n,3),n)};a&&Object.assign(p,{wanted:f(3),effort:f(0),gear_torque:k(r.gear,n,a)}),a&&s.electric&&Object.assign(p,{voltage:f(1),current:f(2)});let d=_(...e.info.state.controls);if(d.length){let h=N(e.run.states.subarray(0,n*u),u,d);p.controller_states=k(h,n,d.length)}if(s.contactPoint<0)return p;let y=h=>N(r.contact,6,h);return{...p,contact_force:k(y([0,1,2]),n,3),contact_force_normal:k(y([3]),n),penetration:k(y([4]),n)}}function Wr(s,e,r,t){let o=r.model.q.length/t,n=r.points.length/t/X,[i,a]=[e,r].map(({points:u})=>N(u,n*X,[9,10,11])),l={q_nominal:k(r.model.q,t,o),v_nominal:k(r.model.v,t,o),deformation_nominal:k(J(s.deflections,r.model.q,t),t,s.deformations.length),gear_torque_nominal:k(r.model.gear,t,r.model.gear.length/t),tip_nominal:k(a,t,3),deviation:k(ft(rt(i,a),3),t)};return s.contactPoint>=0&&(l.contact_force_normal_nominal=k(N(r.model.contact,6,[3]),t)),l}var Dr=32,Jn=1e-6;function Ur(s,e){let{wanted:r}=e;return r?s.setpoints.map(t=>N(r.data,r.shape[1],[t])):[]}function Gr(s,e,r){let t=s.length-(Xn(s)?1:0),o=s[s.length-1],n=e===null?-1:s.findIndex(l=>l>=e*(1+1e-9));if(n>=0&&t-n>=Dr)return[s[n],o];let[i,a]=Vn(Zn(t,r));return a-i>=Dr?[s[i],s[a-1]]:[s[0],o]}function Xn(s){let e=s.length;return e>2&&Math.abs((s[e-1]-s[e-2])/(s[1]-s[0])-1)>1e-6}function Zn(s,e){let r=new Array(Math.max(s,0)).fill(!1);if(s<3||!e.length)return r;let t=new Float64Array(s);for(let n of e)for(let i=1;i<s-1;i+=1)t[i]=Math.max(t[i],Math.abs(n[i+1]-2*n[i]+n[i-1]));let o=Jn*Math.max(Number.MIN_VALUE,t.reduce((n,i)=>Math.max(n,i),0));for(let n=1;n<s-1;n+=1)r[n]=t[n]<=o;return r}function Vn(s){let[e,r]=[[0,0],-1];for(let t=0;t<=s.length;t+=1)t<s.length&&s[t]?r=r<0?t:r:r>=0&&(t-r>e[1]-e[0]&&(e=[r,t]),r=-1);return e}async function Qr(s,e,r,t,o,n=()=>{}){let i=performance.now(),a=e.runs.reference?["reference","real"]:["real"],l=[];for(let[x,O]of a.entries()){let I={...t,progress:T=>t.progress?.((x+T)/a.length)},B=ct(e.map,r,O),D=()=>Pr(s,e,r,O,B,I);l.push(await(O==="reference"?o.of(B,D):D()))}let u=l[l.length-1];n(u);let c=(performance.now()-i)/1e3,f=Math.min(...l.map(x=>x.run.times.length)),m=[u,...l.slice(0,-1)],g=m.map(x=>zr(s,e,x,f)),[p,d]=g,y=u.run.times.subarray(0,f),h=d?Wr(e,p,d,f):{},w=Or(s,e,m,g,f),b={...Cr(e,u,p,f),...h,...w},A=Le(e,f),F=Se(u.info.moving.map(x=>u.each[x])),S=l.find(x=>x.run.status!=="finished"),E=$e(s,e,u.blocks,b,y,u.schedule,A),M={...Br(e,y,b,F),...Nr(E,e.carried,y),...Tr(e.carried.limits,b)},j=qr(e,E.links,A.length);return{status:S?S.run.status:"finished",message:S?`${S===u?"actual robot":"nominal run"}: ${S.run.message}`:u.run.message,seconds:c,times:y,series:b,scene:qe(s,e,u.blocks,b,y,A,j),line:$r(e,E.links,A.length),span:Gr(y,F,Ur(e,b)),facts:S?pr(M):M}}async function Kr(s){let e=await bt.open(s.module.data,s.layout),r=new At;return{async run(t,o,n=()=>{}){let i=null,a=await Qr(e,s,t,o,r,l=>{i=l});return n(a,[a.times,a.series,i]),jr(e,s,t,a,i,o)}}}var at=self,he=null,Jr=-1,Yr=Promise.resolve();at.onmessage=({data:s})=>{if(s.kind==="open"){Kr(s.bundle).then(t=>{he=t,at.postMessage({kind:"ready"})},t=>at.postMessage({kind:"failed",message:String(t)}));return}let{id:e,values:r}=s;Jr=e,Yr=Yr.then(()=>Hn(e,r))};async function Hn(s,e){let r=()=>s!==Jr;try{if(!he)throw new Error("the live model is not open");if(await new Promise(a=>setTimeout(a,0)),r())throw new tt("a newer run began");let t={cancelled:r,progress:a=>at.postMessage({kind:"progress",id:s,share:a})},o=null,n=await he.run(e,t,(a,l)=>{o=a;let u=new Set(ht(l));at.postMessage({kind:"early",id:s,run:a},ht(a).filter(c=>!u.has(c)))}),i=we(n,o);at.postMessage({kind:"done",id:s,run:i},ht(i))}catch(t){let o=t instanceof Error?t.message:String(t);at.postMessage({kind:"error",id:s,cancelled:t instanceof tt,message:o})}}})();\n';function Q0(i){let{settings:t,status:e}=i,{statuses:n,limits:r}=i.layout,s=`t = ${Pe(i.time,6)} s`;if(e===n.finished)return["finished",`completed at t = ${Pe(t.duration,6)} s`];if(e===n.running)return["stopped",`stopped at ${s} of ${Pe(t.duration,6)} s: integration.max_steps = ${t.maxSteps} is used up`];if(e===n.chattering){let o=`more than ${r.most_events} times within ${r.event_time} s`;return["chattering",`stopped at ${s}: the contact started or ended ${o}; give the surface damping, or a lower stiffness`]}return vS(i,s)}function vS({layout:i,status:t,lastStep:e,rates:n},r){let{statuses:s,coordinates:o,limits:a}=i,l=o.length,c=Array.from(n().subarray(l,2*l),y=>Number.isFinite(y)?Math.abs(y):1/0),u=c.indexOf(Math.max(...c)),f=c[u]<a.bound?t===s.not_converged?"not_converged":t===s.step_too_small?"step_too_small":"diverged":"diverged",d=`its acceleration is ${Pe(c[u],3)} rad/s^2`,m=f.replaceAll("_"," ");return[f,`${m} at ${r} in coordinate ${o[u]}: ${d}; its last step was of ${Pe(e,3)} s`]}var Ni=class extends Error{name="EngineError"};function ka(i,t,e){if(!Object.hasOwn(i,t))throw new Ni(`${e}: got ${t}; expected one of ${Object.keys(i).join(", ")}`);return i[t]}function is(i,t,e){if(t!==e)throw new Ni(`${i}: got ${t} numbers; expected ${e}`)}var _S=["rk4","midpoint"],bS=500,cd=class{constructor(t,e){this.engine=t;this.spec=e;let n=ka(t.layout.loops,e.loop,"loop");is(`${e.loop}: parameters`,e.parameters.length,n.parameters),is(`${e.loop}: state`,e.state.length,n.size),is(`${e.loop}: rows`,e.rows.length,(e.knots.length-1)*n.row),this.method=n.method,this.memory=new Float64Array(t.layout.cells.length),this.state=e.state.slice(),this.slope=new Float64Array(n.size),this.states=new Float64Array(e.times.length*n.size),this.states.set(e.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(t){return this.memory[this.engine.layout.cells.indexOf(t)]}put(t){for(let[e,n]of Object.entries(t))this.memory[this.engine.layout.cells.indexOf(e)]=n}advance(t){let{layout:e}=this.engine,{settings:n,knots:r,rows:s,times:o,parameters:a}=this.spec,l=Math.max(1,Math.min(t,n.maxSteps-this.tried)),c={step:n.step,rtol:n.relativeTolerance,atol:n.absoluteTolerance,chunk:l,bound:e.limits.bound,watch:0,most_events:e.limits.most_events,event_time:e.limits.event_time,looks:0},u=this.cell("sample"),h=m=>({into:m,range:()=>[u*this.state.length,this.cell("sample")*this.state.length]}),f=m=>({into:m,given:!0}),d={memory:f(this.memory),y:f(this.state),k1:f(this.slope),p:a,knots:r,rows:s,times:o,out:h(this.states),options:Float64Array.from(e.options,m=>c[m]),seen:new Float64Array(1),segments:r.length-1,samples:o.length};this.engine.call(e.loops[this.spec.loop].export,e.arguments.map(m=>d[m]))}result(){let t=this.cell("sample"),e=this.state.length,[n,r]=Q0({layout:this.engine.layout,settings:this.spec.settings,status:this.cell("status"),time:this.time,lastStep:this.cell("h"),rates:()=>this.rates()});return{status:n,message:r,times:this.spec.times.slice(0,t),states:this.states.slice(0,t*e),statistics:this.statistics()}}statistics(){let[t,e,n]=[this.cell("steps"),this.cell("smallest"),this.time],r=t?n/t:null,s={steps:t,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:r,smallest_step_s:e>0?e:r};return _S.includes(this.method)&&(s.step=this.cell("h")),this.cell("passes")&&(s.passes=this.cell("passes")),this.cell("events")&&(s.contact_changes=this.cell("events")),s}rates(){let{loop:t,parameters:e,rows:n}=this.spec,{row:r}=this.engine.layout.loops[t],s=Math.min(this.cell("segment"),n.length/r-1),o={time:Float64Array.of(this.time),state:this.state,row:n.slice(s*r,(s+1)*r),step:new Float64Array(1)};return this.engine.sample(`${t.slice(0,t.lastIndexOf("."))}.rate`,e,o,1).rate}},Us=class extends Ni{name="Cancelled"};async function ty(i,t,e={}){let n=new cd(i,t),r=1e3*(e.piece??.05),s=bS,o=performance.now();for(;n.running;){let a=performance.now();n.advance(s);let l=performance.now();if(s=Math.max(1,Math.floor(s*Math.min(4,r/Math.max(l-a,.001)))),!(l-o<r)){if(e.progress?.(n.time/t.settings.duration),await new Promise(c=>setTimeout(c,0)),e.cancelled?.())throw new Us(`the run was given up at t = ${Pe(n.time,6)} s`);o=performance.now()}}return n.result()}function ey(i,t){return{...i,...t,series:{...i?.series,...t.series}}}var ny=1,wS=65536,MS={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},bc=class i{constructor(t,e,n,r){this.layout=t;this.functions=e;this.memory=n;this.free=r}layout;functions;memory;free;outputs=new Float64Array;static async open(t,e){if(e.format!==ny)throw new Ni(`layout: got format ${e.format}; expected ${ny}`);let{instance:n}=await SS(t,e),{memory:r,heap_base:s,...o}=n.exports,a=s.value;return new i(e,o,r,a)}sample(t,e,n,r){let s=ka(this.layout.samples,t,"function");is(`${t}: parameters`,e.length,s.parameters);let o=this.schedule(s,e,[n],r);return ud(s.outputs,o,r,1)}slopes(t,e,n,r,s){let o=ka(this.layout.samples,t,"function");if(o.kind!=="slopes")throw new Ni(`${t}: got a function without derivatives; expected one with them`);is(`${t}: parameters`,e.length,o.parameters);let a=Object.fromEntries(Object.entries(o.inputs).map(([u,h])=>[u,new Float64Array(h)])),l=this.schedule(o,e,[n,{...a,...r}],s),c=wc(o.outputs);return{values:ud(o.outputs,l,s,2),slopes:ud(o.outputs,l.subarray(c),s,2)}}call(t,e){let n=e.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(n.reduce((a,l)=>a+(l?.byteLength??0),this.free));let r=new Float64Array(this.memory.buffer),s=this.free,o=e.map((a,l)=>{if(typeof a=="number")return BigInt(a);let c=s;return(a instanceof Float64Array||a.given)&&r.set(n[l],c/8),s+=n[l].byteLength,c});this.functions[t](...o),e.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[c,u]=a.range?.()??[0,a.into.length],h=o[l]/8;a.into.set(r.subarray(h+c,h+u),c)})}schedule(t,e,n,r){let s=ES(t.inputs,n,r),o=this.room(r*n.length*wc(t.outputs)),a=new Float64Array(t.workspace);return this.call(t.export,[r,0,e,a,s,{into:o}]),o}room(t){return this.outputs.length<t&&(this.outputs=new Float64Array(t)),this.outputs.subarray(0,t)}reserve(t){let e=t-this.memory.buffer.byteLength;if(!(e<=0))try{this.memory.grow(Math.ceil(e/wS))}catch{throw new Ni(`memory: got no room for ${(t/1e6).toFixed(0)} MB; expected a browser that has it. Hint: ask for fewer samples`)}}};async function SS(i,t){try{return await WebAssembly.instantiate(i,{env:MS})}catch(e){let n=t.simd?", with vectors (SIMD)":"";throw new Ni(`WebAssembly: got ${String(e)}; expected a browser that allows it${n}`)}}function wc(i){return Object.values(i).reduce((t,e)=>t+e,0)}function AS(i,t,e,n){if(e===void 0)throw new Ni(`${i}: got nothing; expected ${t} numbers for each sample`);if(e.length===n*t)return e;is(i,e.length,t);let r=new Float64Array(n*t);return hd(e,0,0,r,t,0,t,n),r}function ES(i,t,e){let n=wc(i),r=new Float64Array(e*t.length*n);return t.forEach((s,o)=>{let a=o*n;for(let[l,c]of Object.entries(i)){let u=AS(l,c,s[l],e);hd(u,c,0,r,t.length*n,a,c,e),a+=c}}),r}function ud(i,t,e,n){let r=n*wc(i),s={},o=0;for(let[a,l]of Object.entries(i)){let c=new Float64Array(e*l);hd(t,r,o,c,l,0,l,e),s[a]=c,o+=l}return s}function hd(i,t,e,n,r,s,o,a){for(let l=0;l<a;l++){let c=l*t+e,u=l*r+s;for(let h=0;h<o;h++)n[u+h]=i[c+h]}}var Mc=class{last=null;async of(t,e){if(this.last&&TS(this.last.blocks,t))return this.last.made;this.last=null;let n=await e();return this.last={blocks:t,made:n},n}};function TS(i,t){return Object.entries(i).every(([e,n])=>n.length===t[e].length&&n.every((r,s)=>r===t[e][s]))}function fd(i,t){return{knots:i,coefficients:t,signals:1,degree:t.length/(i.length-1)-1}}function dd(i,t){let e=i.degree+1,n=i.knots.length-1,r=0;for(;r<n&&i.knots[r]<t;)r+=1;let s=i.knots[n],o=[...i.knots.subarray(0,r)],a=[...i.coefficients.subarray(0,r*e)];return t>s&&(o.push(s),a.push(pd(i,n-1,0,s),...new Array(i.degree).fill(0))),fd(Float64Array.from([...o,t]),Float64Array.from(a))}function pd(i,t,e,n){let r=i.degree+1,s=(t*i.signals+e)*r,o=n-i.knots[t],a=0;for(let l=i.degree;l>=0;l-=1)a=a*o+i.coefficients[s+l];return a}function md(i,t){let[e,n]=[0,i.length-1];for(;n-e>1;){let r=e+n>>1;i[r]<=t?e=r:n=r}return e}function rs(i,t,e){return pd(i,md(i.knots,e),t,e)}function iy(i){return ry(i,Array.from({length:i.knots.length-1},(t,e)=>e))}function Sc(i,t){return ry(i,Array.from(t,e=>md(i.knots,e)))}function ry(i,t){let e=i.signals*(i.degree+1),n=new Float64Array(t.length*(e+1));return t.forEach((r,s)=>{n[s*(e+1)]=i.knots[r],n.set(i.coefficients.subarray(r*e,(r+1)*e),s*(e+1)+1)}),n}function sy(i){if(!i.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let t=Math.max(...i.map(o=>o.knots[o.knots.length-1])),e=i.map(o=>o.knots[o.knots.length-1]<t?dd(o,t):o),n=RS(e.flatMap(o=>[...o.knots])),r=Math.max(...e.map(o=>o.degree)),s=new Float64Array((n.length-1)*i.length*(r+1));return e.forEach((o,a)=>{for(let l=0;l<n.length-1;l+=1){let c=(l*i.length+a)*(r+1);CS(o,n,l,s.subarray(c,c+r+1))}}),{knots:n,coefficients:s,signals:i.length,degree:r}}function RS(i){let t=[...new Set(i)].sort((r,s)=>r-s),e=t[t.length-1]-t[0],n=t.filter((r,s)=>s===0||r-t[s-1]>1e-12*e);return n[n.length-1]=t[t.length-1],Float64Array.from(n)}function CS(i,t,e,n){let r=md(i.knots,(t[e]+t[e+1])/2),s=t[e]-i.knots[r],o=Math.abs(s)<=1e-12*(t[t.length-1]-t[0])?0:s;for(let a=0;a<=i.degree;a+=1){let l=i.coefficients[r*(i.degree+1)+a],c=1;for(let u=a;u>=0;u-=1)n[u]+=c*l*Math.pow(o,a-u),c=c*u/(a-u+1)}}var PS=1e-9,IS=1e-6;function oy(i){let t=i.map(LS);return t.includes(null)?null:Math.max(0,...t)}function LS(i){let{knots:t,coefficients:e,degree:n}=i,r=t.length-1,s=n+1,o=l=>e[l*s],a=Array.from({length:r},(l,c)=>Math.abs(o(c))).reduce((l,c)=>Math.max(l,c),1e-12);for(let l=r-1;l>=0;l-=1){let c=t[l+1]-t[l];for(let u=1;u<s;u+=1)if(!(Math.abs(e[l*s+u])*c**u<=PS*a))return l===r-1?null:t[l+1];if(l&&Math.abs(o(l)-pd(i,l-1,0,t[l]))>IS*a)return t[l]}return 0}var wi=6;function gd({follower:i,signal:t},e,n,r,s,o){let a=t<0?1:rs(n,t,r);return(i?FS(s,o,e):e).map(l=>a*l)}function FS(i,t,e){return e.map((n,r)=>{let[s,o]=[t+3*(r%3),r<3?0:3];return i[s]*e[o]+i[s+1]*e[o+1]+i[s+2]*e[o+2]})}function Ac(i,t,e,n,r){let s=r.position.shape[1],o=new Float64Array(n.length*s*wi);return n.forEach((a,l)=>{if(i.loads.forEach((c,u)=>{let h=l*s+c.point,f=t.loads.subarray(wi*u,wi*(u+1)),d=gd(c,f,e,a,r.rotation.data,9*h);for(let m=0;m<wi;m+=1)o[wi*h+m]+=d[m]}),!(i.contactPoint<0))for(let c=0;c<3;c+=1)o[wi*(l*s+i.contactPoint)+c]-=r.contact_force.data[3*l+c]}),o}function Ec(i,t){let e=t.length;for(let n=0;n<e;n+=1){let r=n;for(let o=n+1;o<e;o+=1)Math.abs(i[o*e+n])>Math.abs(i[r*e+n])&&(r=o);let s=Math.abs(i[r*e+n]);if(!(s>0)||s===1/0)return!1;r!==n&&NS(i,t,n,r);for(let o=n+1;o<e;o+=1){let a=i[o*e+n]/i[n*e+n];if(a!==0){for(let l=n+1;l<e;l+=1)i[o*e+l]-=a*i[n*e+l];t[o]-=a*t[n]}}}for(let n=e-1;n>=0;n-=1){for(let r=n+1;r<e;r+=1)t[n]-=i[n*e+r]*t[r];t[n]/=i[n*e+n]}return!0}function NS(i,t,e,n){let r=t.length;for(let o=0;o<r;o+=1){let a=i[e*r+o];i[e*r+o]=i[n*r+o],i[n*r+o]=a}let s=t[e];t[e]=t[n],t[n]=s}function Tc(i,t){let e=new Float64Array(t*t);for(let n=0;n<t;n+=1)for(let r=n;r<t;r+=1){let s=i[r*t+n];for(let o=0;o<n;o+=1)s-=e[r*t+o]*e[n*t+o];if(r===n&&!(s>0))return null;e[r*t+n]=r===n?Math.sqrt(s):s/e[n*t+n]}return e}function ly(i,t,e,n){for(let r=0;r<e;r+=1){for(let s=0;s<r;s+=1)uy(t,r,s,i[r*e+s],n);for(let s=0;s<n;s+=1)t[r*n+s]/=i[r*e+r]}}function yd(i,t,e,n){for(let r=e-1;r>=0;r-=1){for(let s=r+1;s<e;s+=1)uy(t,r,s,i[s*e+r],n);for(let s=0;s<n;s+=1)t[r*n+s]/=i[r*e+r]}}function uy(i,t,e,n,r){for(let s=0;s<r;s+=1)i[t*r+s]-=n*i[e*r+s]}function Rc(i,t,e){let n=t.slice();ly(i,n,e,e);let r=cy(n,e);return ly(i,r,e,e),cy(r,e)}function cy(i,t){return i.map((e,n)=>i[n%t*t+Math.floor(n/t)])}function si(i,t,e,n,r,s=!1){let o=new Float64Array(e*r);for(let a=0;a<e;a+=1)for(let l=0;l<n;l+=1){let c=s?i[l*e+a]:i[a*n+l];if(c)for(let u=0;u<r;u+=1)o[a*r+u]+=c*t[l*r+u]}return o}function hy(i,t){let e=Float64Array.from({length:t*t},(n,r)=>r%(t+1)?0:1);for(let n=0;n<t;n+=1){let r=n;for(let a=n+1;a<t;a+=1)Math.abs(i[a*t+n])>Math.abs(i[r*t+n])&&(r=a);let s=Math.abs(i[r*t+n]);if(!(s>0)||s===1/0)return null;for(let a of[i,e])if(r!==n){let l=a.slice(n*t,(n+1)*t);a.copyWithin(n*t,r*t,(r+1)*t),a.set(l,r*t)}let o=i[n*t+n];for(let a=0;a<t;a+=1)i[n*t+a]/=o,e[n*t+a]/=o;for(let a=0;a<t;a+=1){let l=i[a*t+n];if(!(a===n||l===0)){for(let c=n;c<t;c+=1)i[a*t+c]-=l*i[n*t+c];for(let c=0;c<t;c+=1)e[a*t+c]-=l*e[n*t+c]}}}return e}var Cc=24;function fy(i,t,e,n,r,s,o=0){let a=n.length/Cc,l={wrenches:new Float64Array(wi*a),mass:new Float64Array(s*s),damping:new Float64Array(s*s),stiffness:new Float64Array(s*s)},c=(u,h)=>Float64Array.from({length:3*s},(f,d)=>r[(d%s*a+u)*Cc+h+Math.floor(d/s)]);return i.loads.forEach((u,h)=>{let{point:f,follower:d}=u,m=t.loads.subarray(wi*h,wi*(h+1)),y=gd(u,m,e,o,n,Cc*f);if(Po(l.wrenches.subarray(wi*f,wi*(f+1)),y,1),!d)return;let g=c(f,21);for(let[p,x]of[[c(f,18),0],[g,3]])Po(l.stiffness,si(p,si(DS(y.subarray(x,x+3)),g,3,3,s),s,3,s,!0),1)}),i.touch&&US(OS(i.touch,t.surface),t.touch,n,c(i.touch.point,18),l,s),l}function Po(i,t,e){for(let n=0;n<t.length;n+=1)i[n]+=e*t[n]}function DS([i,t,e]){return Float64Array.of(0,-e,t,e,0,-i,-t,i,0)}function OS(i,t){let[e,n,r,s]=t;if(i.radius)return{...i,axis:[e,n,r],radius:s};let[o,a,l]=i.axis;return{...i,distance:-(o*e+a*n+l*r)}}function US(i,t,e,n,r,s){let[o,a,l,c]=t,u=Cc*i.point+9,{gap:h,normal:f,curvature:d}=kS(i,e.subarray(u,u+3)),m=c-l*h;if(!i.bilateral&&!(h<=0&&m>0))return;for(let p=0;p<3;p+=1)r.wrenches[wi*i.point+p]+=m*f[p];let y=si(f,n,1,3,s),g=si(y,y,s,1,s);Po(r.mass,g,o),Po(r.damping,g,a),Po(r.stiffness,g,l),Po(r.stiffness,si(n,si(d,n,3,3,s),s,3,s,!0),-m)}function kS(i,t){let e=l=>l[0]*t[0]+l[1]*t[1]+l[2]*t[2];if(!i.radius)return{gap:e(i.axis)+i.distance,normal:Float64Array.from(i.axis),curvature:new Float64Array(9)};let n=t.map((l,c)=>l-i.axis[c]),r=Math.hypot(...n)||1e-300,s=i.inside?-1:1,o=n.map(l=>l/r),a=Float64Array.from({length:9},(l,c)=>s*((c%4?0:1)-o[Math.floor(c/3)]*o[c%3])/r);return{gap:s*(r-i.radius),normal:o.map(l=>s*l),curvature:a}}function dy(i,t){let e=Array.from(i.frames.data).filter(n=>n<t);return e[e.length-1]!==t-1&&e.push(t-1),e}function cn(i){return i.data instanceof Float64Array?i.data:Float64Array.from(i.data)}function BS(i,t,e){let n=i.knobs.map(s=>s.start),r=i.knobs.map(s=>s.factor);return i.sliders.forEach((s,o)=>{s.real?r[s.knob]=t[o]:n[s.knob]=t[o]}),e==="reference"?n:i.knobs.map((s,o)=>{let a=r[o];return a===null||s.factor===null?n[o]:s.together?s.factor?n[o]*(a/s.factor):n[o]:n[o]*a})}function Io(i,t,e){let n=i.runs[e],r=zS(n,BS(i,t,e)),s={};for(let[o,a]of Object.entries(n.places)){let l=a.shape.reduce((c,u)=>c*u,1);s[o]=r.slice(a.start,a.start+l)}return s}function zS(i,t){let e=cn(i.base).slice(),n=i.powers.map(l=>py(l,(c,u)=>Math.pow(t[c]/i.variables[c].start,u))),r=i.powers.map(l=>py(l,(c,u)=>VS(i.variables[c],u,t[c]))),{products:s,terms:o,coefficients:a}=i;for(let l=0;l<s.data.length;l+=2)e[s.data[l]]*=n[s.data[l+1]];for(let l=0;l<o.data.length;l+=2)e[o.data[l]]+=a.data[l/2]*r[o.data[l+1]];return e}function py(i,t){return i.reduce((e,[n,r])=>e*t(n,r),1)}function VS(i,t,e){let n=Math.pow(i.start,t);return(Math.pow(e,t)-n)/(Math.pow(i.far,t)-n)}var GS=40,HS=1e-12,WS=.5,my=1e-6,qS=.5,$S=.001,XS=1/128;function jS(i,t,e,n,r,s){let[o,a,l]=[n.length+1,e.length,t.rotors.length],c=new Float64Array(o*a);for(let f=0;f<o;f+=1)c.set(e,f*a),f&&(c[f*a+n[f-1]]+=my);let u={time:new Float64Array(1),state:c,row:t.rest_row,step:new Float64Array(1)},{rate:h}=i.sample("rest.rate",t.rest,u,o);for(let f=0;f<n.length;f+=1){s[f]=h[l+n[f]];for(let d=0;d<n.length;d+=1)r[f*n.length+d]=(h[(d+1)*a+l+n[f]]-s[f])/my}}function YS(i,t,e,n){let r=i.layout.held,s=n.length,o=Array.from({length:s},(d,m)=>m).filter(d=>!r.includes(d)),a=new Float64Array(t.restSize);a.set(n);let l=new Float64Array(o.length**2),c=new Float64Array(o.length),u=1/0,[h,f]=[0,0];for(let d=0;d<GS&&o.length;d+=1){if(jS(i,e,a,o,l,c),!Ec(l,c))return null;let m=xd(a,o,c);if(!Number.isFinite(m)||(d===0?h=m:f+=m,h>$S&&f>qS*h))return null;if(vd(m,u))return a.slice(0,s);u=m}return o.length?null:a.slice(0,s)}function xd(i,t,e){let n=e.reduce((s,o)=>Math.max(s,Math.abs(o)),0),r=Math.min(1,WS/n);for(let s=0;s<t.length;s+=1)i[t[s]]-=r*e[s];return n}function vd(i,t){return i<HS||i<1e-9&&i>=t/2}function _d(i,t,e,n,r){let s=i.sliders.map(u=>u.value),o=u=>u===1?t:t.map((h,f)=>s[f]+(h-s[f])*u),[a,l,c]=[0,1,n];for(;a<1;){let u=Math.min(1,a+l),h=r(o(u),c);if(h)[a,l,c]=[u,2*l,h];else if(l>XS)l/=2;else throw new Error(`${e}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`)}return c}function gy(i,t,e,n,r){let s=t.runs[n],o=cn(s.start).slice(),[a,l]=[s.state.q[0],s.state.v[0]];if(t.atRest){let c=(h,f)=>YS(i,t,Io(t.map,h,n),f),u=_d(t,e,n,o.slice(...s.state.q),c);for(let h=0;h<u.length;h+=1)s.info.includes(h)||(o[a+h]=u[h])}for(let[c,u]of s.exact){o[a+c]=rs(r,u,0);let h=r.degree;o[l+c]=h?r.coefficients[u*(h+1)+1]:0}return o}var ZS=40,Ba=.001;function Pc(i,t,e,n){let{samples:r}=i.layout;return i.sample("loaded"in r?"loaded":"inertia",t.chain,e,n).forces}function KS(i,t,e,n,r,s=0){let o=r.length,a=new Float64Array(o),l=Float64Array.from({length:o*o},(S,A)=>A%(o+1)?0:1),c=cn(t.base),u=i.sample("inertia",e.chain,{q:r,v:a,a:l,base:c},o),{points:h}=i.sample("inertia",e.chain,{q:r,v:a,a,base:c},1),f=fy(t,e,n,h,u.points,o,s),d=f.mass;for(let S=0;S<o;S+=1){for(let A=0;A<o;A+=1)d[S*o+A]+=(u.forces[S*o+A]+u.forces[A*o+S])/2;d[S*o+S]+=e.rotors[S]}let m=e.chain.slice();for(let S of t.modes.dry)m[S]=0;let y=i.slopes("elastic.slopes",m,{q:r,v:a,base:c},{q:l},o),g=i.slopes("elastic.slopes",m,{q:r,v:a,base:c},{v:l},o).slopes.forces,p=JS(i,t,e,r,f.wrenches),x=S=>S.map((A,_)=>S[_%o*o+Math.floor(_/o)]),b=x(y.slopes.forces),v=Pc(i,e,{q:r,v:a,a,base:cn(t.modes.weight),wrenches:f.wrenches},1);return{mass:d,elastic:b,residual:v.map((S,A)=>S+y.values.forces[A]),damping:x(g).map((S,A)=>S+f.damping[A]),stiffness:b.map((S,A)=>S+p[A]+f.stiffness[A])}}function yy(i,t,e,n,r,s=0){let{free:o}=t.modes,[a,l,c]=[r.slice(),r.length,o.length],[u,h]=[1/0,!c];for(let f=0;f<ZS;f+=1){let d=KS(i,t,e,n,a,s);if(h)return{rest:a,linear:d};let m=Float64Array.from({length:c*c},(p,x)=>d.stiffness[o[Math.floor(x/c)]*l+o[x%c]]),y=Float64Array.from(o,p=>d.residual[p]);if(!Ec(m,y))return null;let g=xd(a,o,y);if(!Number.isFinite(g))return null;h=vd(g,u),u=g}return null}function JS(i,t,e,n,r){let s=n.length,o=[Ba,-Ba,2*Ba,-2*Ba],a=new Float64Array(o.length*s*s);o.forEach((h,f)=>{for(let d=0;d<s;d+=1)a.set(n,(f*s+d)*s),a[(f*s+d)*s+d]+=h});let l=new Float64Array(s),c=Pc(i,e,{q:a,v:l,a:l,base:cn(t.modes.weight),wrenches:r},o.length*s),u=(h,f,d)=>c[(h*s+d)*s+f];return Float64Array.from({length:s*s},(h,f)=>{let[d,m]=[Math.floor(f/s),f%s];return(8*(u(0,d,m)-u(1,d,m))-(u(2,d,m)-u(3,d,m)))/(12*Ba)})}function Sn(i,t,e){let n=i.length/t,r=new Float64Array(n*e.length);for(let s=0;s<n;s+=1)for(let o=0;o<e.length;o+=1)r[s*e.length+o]=i[s*t+e[o]];return r}function hi(i,t){return Array.from({length:t-i},(e,n)=>i+n)}function Yi(i,t,e){let n=new Float64Array(e.length*t);for(let r=0;r<e.length;r+=1)for(let s=0;s<t;s+=1)n[r*t+s]=i[e[r]*t+s];return n}function ss(i,t){return i.map((e,n)=>e-t[n])}function Lo(i,t){let e=new Float64Array(i.length/t);for(let n=0;n<e.length;n+=1){let r=0;for(let s=0;s<t;s+=1)r+=i[n*t+s]**2;e[n]=Math.sqrt(r)}return e}function xy(i,t,e,n){let r=i.length/e,s=t.length/e,o=new Float64Array(e),a=0;for(let l=0;l<e;l+=1){let c=0;for(let u=0;u<r;u+=1)c+=i[l*r+u];l===0&&(a=c),o[l]=c-a;for(let u=0;u<s;u+=1)o[l]+=(u<n?-1:1)*t[l*s+u]}return o}function za(i){let t=0;for(let e=1;e<i.length;e+=1)Math.abs(i[e])>Math.abs(i[t])&&(t=e);return t}function we(i,t,...e){return{data:i,shape:[t,...e]}}var QS=4e5,t1=5e5;function vy(i,t,e,n,r,s,o){let{places:a,lines:l,shown:c}=t.carried,u=a.data.length,h=l.map((x,b)=>e1(x,e.lengths[b],o.length*c.data.length)),f=Math.max(1,Math.ceil(r.length*l.length*u/QS));if(!l.length)return{links:h,every:f};let d=new Map(o.map((x,b)=>[x,b])),m=Array.from(r.keys()).filter(x=>x%f===0||d.has(x)),y={q:n.q.data,v:n.v.data,a:n.a.data};"wrenches"in i.layout.samples.line.inputs&&(y.wrenches=Ac(t,e,s,r,n));let g=Object.entries(y).map(([x,b])=>[x,Yi(b,b.length/r.length,m)]),p={...Object.fromEntries(g),base:cn(t.split.weight)};return wd(i,e,p,m.length,(x,b,v)=>{let S=d.get(m[v]);l.forEach((A,_)=>{let w=Md(x[A.name],b,t,A);n1(h[_],A,w,a.data,m[v]),S!==void 0&&i1(h[_],A,w,S,c.data)})}),{links:h,every:f}}function wd(i,t,e,n,r){let{inputs:s,outputs:o}=i.layout.samples.line,a=Math.max(1,Math.floor(t1/Object.values(o).reduce((l,c)=>l+c,1)));for(let l=0;l<n;l+=a){let c=Math.min(a,n-l),u={};for(let[f,d]of Object.entries(s)){let m=e[f]??new Float64Array(d);u[f]=m.length===d?m:m.subarray(l*d,(l+c)*d)}let h=i.sample("line",t.line,u,c);for(let f=0;f<c;f+=1)r(h,f,l+f)}}function Md(i,t,e,n){let r=n?e.carried.places.data.length*n.width:15;return i.subarray(t*r,(t+1)*r)}function e1({name:i,at:t},e,n){let r=s=>new Float64Array(s*n);return{name:i,length:e,deflection:r(2),slope:r(2),moment:r(3),shear:r(2),axial:r(1),stress:t.mises_stress?{strain:r(1),mises:r(1)}:null,largest:{deflection:null,moment:null,stress:null}}}function n1(i,{width:t,at:e},n,r,s){let o=r.length-1,a=o*t+e.deflection[0];bd(i,"deflection",Math.sqrt(n[a]**2+n[a+1]**2),r[o],s);for(let l=0;l<=o;l+=1){let c=l*t+e.moment[0];bd(i,"moment",Math.sqrt(n[c+1]**2+n[c+2]**2),r[l],s),i.stress&&bd(i,"stress",n[l*t+e.mises_stress[0]],r[l],s)}}function bd({name:i,largest:t},e,n,r,s){let o=t[e];(!o||n>o.value)&&(t[e]={link:i,value:n,s:r,sample:s})}function i1(i,{width:t,at:e},n,r,s){let o=(a,l)=>{let[c,u]=e[a],h=u-c;for(let f=0;f<s.length;f+=1)for(let d=0;d<h;d+=1)l[(r*s.length+f)*h+d]=n[s[f]*t+c+d]};for(let a of["deflection","slope","moment","shear","axial"])o(a,i[a]);i.stress&&(o("strain",i.stress.strain),o("mises_stress",i.stress.mises))}function mr(i,t,e){let[n,r]=i.matrix.shape,s=new Float64Array(e*n);for(let o=0;o<e;o+=1)for(let a=0;a<n;a+=1){let l=i.constant.data[a];for(let c=0;c<r;c+=1)l+=i.matrix.data[a*r+c]*t[o*r+c];s[o*n+a]=l}return s}function _y(i,t,e,n,r,s,o){let a=p=>Yi(n[p].data,n[p].shape.slice(1).reduce((x,b)=>x*b,1),s),l=s.length,c=Ic(i,t,e,a("q"),l),u=p=>Ic(i,t,e,p,l).line,h=p=>u(mr(t.straight,p,l)),f=h(a("q")),d=p=>({data:a(p),shape:[l,...n[p].shape.slice(1)]}),m="q_nominal"in n,y=c.line.shape.slice(0,3),g=c.line.data.map((p,x)=>p-f.data[x]);return{times:{data:Yi(r,1,s),shape:[l]},line:c.line,rigid:f,roots:c.roots,reference:m?u(a("q_nominal")):null,referenceRigid:m?h(a("q_nominal")):null,colours:[...o,{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:Lo(g,3),shape:y}}],tip:d("tip"),tipReference:m?d("tip_nominal"):null,contact:t.contactPoint<0?null:{force:d("contact_force"),at:s1(t,n,s),surface:r1(t,e.surface)}}}function r1({surface:i},t){let e=[t[0],t[1],t[2]];return i?.kind==="plane"?{...i,position:e}:i?{...i,center:e,radius:t[3]}:void 0}function s1(i,t,e){let n=t.position.shape[1],r=Yi(t.position.data,3*n,e),s=new Float64Array(3*e.length);for(let o=0;o<e.length;o+=1)for(let a=0;a<3;a+=1)s[3*o+a]=r[3*(o*n+i.contactPoint)+a];return{data:s,shape:[e.length,3]}}function Ic(i,t,e,n,r){let[s,o]=[t.links.length,t.stations.data.length],a=new Float64Array(n.length/r),l=new Float64Array(r*s*o*3),c=new Float64Array(r*s*4),u=t.links.map(({name:h})=>t.carried.lines.find(f=>f.name===h)??null);return wd(i,e,{q:n,v:a,a,base:cn(t.base)},r,(h,f,d)=>{t.links.forEach(({name:m},y)=>{let g=u[y],p=(d*s+y)*4,x=Md(h[m],f,t,g);c.set(a1(g?x.subarray(g.at.rotation[0]):x),p),d&&o1(c,p,4*s);for(let b=0;b<o;b+=1){let v=((d*s+y)*o+b)*3;for(let S=0;S<3;S+=1)l[v+S]=g?x[t.carried.shown.data[b]*g.width+g.at.position[0]+S]:x[9+S]+t.stations.data[b]*(x[12+S]-x[9+S])}})}),{line:{data:l,shape:[r,s,o,3]},roots:{data:c,shape:[r,s,4]}}}function o1(i,t,e){let n=0;for(let r=t;r<t+4;r+=1)n+=i[r]*i[r-e];if(n<0)for(let r=t;r<t+4;r+=1)i[r]*=-1}function a1(i){let t=i[0]+i[4]+i[8];if(t>0){let n=2*Math.sqrt(1+t);return[(i[7]-i[5])/n,(i[2]-i[6])/n,(i[3]-i[1])/n,n/4]}if(i[0]>i[4]&&i[0]>i[8]){let n=2*Math.sqrt(1+i[0]-i[4]-i[8]);return[n/4,(i[1]+i[3])/n,(i[2]+i[6])/n,(i[7]-i[5])/n]}if(i[4]>i[8]){let n=2*Math.sqrt(1+i[4]-i[0]-i[8]);return[(i[1]+i[3])/n,n/4,(i[5]+i[7])/n,(i[2]-i[6])/n]}let e=2*Math.sqrt(1+i[8]-i[0]-i[4]);return[(i[2]+i[6])/e,(i[5]+i[7])/e,e/4,(i[3]-i[1])/e]}var l1=Object.prototype.toString;function On(i){let t=l1.call(i);return t.endsWith("Array]")&&!t.includes("Big")}function Sd(i,t={}){if(!On(i))throw new TypeError("input must be an array");if(i.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=i.length}=t;if(e<0||e>=i.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>i.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let r=i[e];for(let s=e+1;s<n;s++)i[s]>r&&(r=i[s]);return r}function Ad(i,t={}){if(!On(i))throw new TypeError("input must be an array");if(i.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=i.length}=t;if(e<0||e>=i.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>i.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let r=i[e];for(let s=e+1;s<n;s++)i[s]<r&&(r=i[s]);return r}function Lc(i,t={}){if(On(i)){if(i.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let e;if(t.output!==void 0){if(!On(t.output))throw new TypeError("output option must be an array if specified");e=t.output}else e=new Array(i.length);let n=Ad(i),r=Sd(i);if(n===r)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:s=t.autoMinMax?n:0,max:o=t.autoMinMax?r:1}=t;if(s>=o)throw new RangeError("min option must be smaller than max option");let a=(o-s)/(r-n);for(let l=0;l<i.length;l++)e[l]=(i[l]-n)*a+s;return e}var Fc=" ".repeat(2),wy=" ".repeat(4);function My(){return Ed(this)}function Ed(i,t={}){let{maxRows:e=15,maxColumns:n=10,maxNumSize:r=8,padMinus:s="auto"}=t;return`${i.constructor.name} {
${Fc}[
${wy}${c1(i,e,n,r,s)}
${Fc}]
${Fc}rows: ${i.rows}
${Fc}columns: ${i.columns}
}`}function c1(i,t,e,n,r){let{rows:s,columns:o}=i,a=Math.min(s,t),l=Math.min(o,e),c=[];if(r==="auto"){r=!1;t:for(let u=0;u<a;u++)for(let h=0;h<l;h++)if(i.get(u,h)<0){r=!0;break t}}for(let u=0;u<a;u++){let h=[];for(let f=0;f<l;f++)h.push(u1(i.get(u,f),n,r));c.push(`${h.join(" ")}`)}return l!==o&&(c[c.length-1]+=` ... ${o-e} more columns`),a!==s&&c.push(`... ${s-t} more rows`),c.join(`
${wy}`)}function u1(i,t,e){return(i>=0&&e?` ${by(i,t-1)}`:by(i,t)).padEnd(t)}function by(i,t){let e=i.toString();if(e.length<=t)return e;let n=i.toFixed(t);if(n.length>t&&(n=i.toFixed(Math.max(0,t-(n.length-t)))),n.length<=t&&!n.startsWith("0.000")&&!n.startsWith("-0.000"))return n;let r=i.toExponential(t);return r.length>t&&(r=i.toExponential(Math.max(0,t-(r.length-t)))),r.slice(0)}function Sy(i,t){i.prototype.add=function(n){return typeof n=="number"?this.addS(n):this.addM(n)},i.prototype.addS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)+n);return this},i.prototype.addM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)+n.get(r,s));return this},i.add=function(n,r){return new t(n).add(r)},i.prototype.sub=function(n){return typeof n=="number"?this.subS(n):this.subM(n)},i.prototype.subS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)-n);return this},i.prototype.subM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)-n.get(r,s));return this},i.sub=function(n,r){return new t(n).sub(r)},i.prototype.subtract=i.prototype.sub,i.prototype.subtractS=i.prototype.subS,i.prototype.subtractM=i.prototype.subM,i.subtract=i.sub,i.prototype.mul=function(n){return typeof n=="number"?this.mulS(n):this.mulM(n)},i.prototype.mulS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)*n);return this},i.prototype.mulM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)*n.get(r,s));return this},i.mul=function(n,r){return new t(n).mul(r)},i.prototype.multiply=i.prototype.mul,i.prototype.multiplyS=i.prototype.mulS,i.prototype.multiplyM=i.prototype.mulM,i.multiply=i.mul,i.prototype.div=function(n){return typeof n=="number"?this.divS(n):this.divM(n)},i.prototype.divS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)/n);return this},i.prototype.divM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)/n.get(r,s));return this},i.div=function(n,r){return new t(n).div(r)},i.prototype.divide=i.prototype.div,i.prototype.divideS=i.prototype.divS,i.prototype.divideM=i.prototype.divM,i.divide=i.div,i.prototype.mod=function(n){return typeof n=="number"?this.modS(n):this.modM(n)},i.prototype.modS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)%n);return this},i.prototype.modM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)%n.get(r,s));return this},i.mod=function(n,r){return new t(n).mod(r)},i.prototype.modulus=i.prototype.mod,i.prototype.modulusS=i.prototype.modS,i.prototype.modulusM=i.prototype.modM,i.modulus=i.mod,i.prototype.and=function(n){return typeof n=="number"?this.andS(n):this.andM(n)},i.prototype.andS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)&n);return this},i.prototype.andM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)&n.get(r,s));return this},i.and=function(n,r){return new t(n).and(r)},i.prototype.or=function(n){return typeof n=="number"?this.orS(n):this.orM(n)},i.prototype.orS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)|n);return this},i.prototype.orM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)|n.get(r,s));return this},i.or=function(n,r){return new t(n).or(r)},i.prototype.xor=function(n){return typeof n=="number"?this.xorS(n):this.xorM(n)},i.prototype.xorS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)^n);return this},i.prototype.xorM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)^n.get(r,s));return this},i.xor=function(n,r){return new t(n).xor(r)},i.prototype.leftShift=function(n){return typeof n=="number"?this.leftShiftS(n):this.leftShiftM(n)},i.prototype.leftShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)<<n);return this},i.prototype.leftShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)<<n.get(r,s));return this},i.leftShift=function(n,r){return new t(n).leftShift(r)},i.prototype.signPropagatingRightShift=function(n){return typeof n=="number"?this.signPropagatingRightShiftS(n):this.signPropagatingRightShiftM(n)},i.prototype.signPropagatingRightShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>n);return this},i.prototype.signPropagatingRightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>n.get(r,s));return this},i.signPropagatingRightShift=function(n,r){return new t(n).signPropagatingRightShift(r)},i.prototype.rightShift=function(n){return typeof n=="number"?this.rightShiftS(n):this.rightShiftM(n)},i.prototype.rightShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>>n);return this},i.prototype.rightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>>n.get(r,s));return this},i.rightShift=function(n,r){return new t(n).rightShift(r)},i.prototype.zeroFillRightShift=i.prototype.rightShift,i.prototype.zeroFillRightShiftS=i.prototype.rightShiftS,i.prototype.zeroFillRightShiftM=i.prototype.rightShiftM,i.zeroFillRightShift=i.rightShift,i.prototype.not=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,~this.get(n,r));return this},i.not=function(n){return new t(n).not()},i.prototype.abs=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.abs(this.get(n,r)));return this},i.abs=function(n){return new t(n).abs()},i.prototype.acos=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.acos(this.get(n,r)));return this},i.acos=function(n){return new t(n).acos()},i.prototype.acosh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.acosh(this.get(n,r)));return this},i.acosh=function(n){return new t(n).acosh()},i.prototype.asin=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.asin(this.get(n,r)));return this},i.asin=function(n){return new t(n).asin()},i.prototype.asinh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.asinh(this.get(n,r)));return this},i.asinh=function(n){return new t(n).asinh()},i.prototype.atan=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.atan(this.get(n,r)));return this},i.atan=function(n){return new t(n).atan()},i.prototype.atanh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.atanh(this.get(n,r)));return this},i.atanh=function(n){return new t(n).atanh()},i.prototype.cbrt=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cbrt(this.get(n,r)));return this},i.cbrt=function(n){return new t(n).cbrt()},i.prototype.ceil=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.ceil(this.get(n,r)));return this},i.ceil=function(n){return new t(n).ceil()},i.prototype.clz32=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.clz32(this.get(n,r)));return this},i.clz32=function(n){return new t(n).clz32()},i.prototype.cos=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cos(this.get(n,r)));return this},i.cos=function(n){return new t(n).cos()},i.prototype.cosh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cosh(this.get(n,r)));return this},i.cosh=function(n){return new t(n).cosh()},i.prototype.exp=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.exp(this.get(n,r)));return this},i.exp=function(n){return new t(n).exp()},i.prototype.expm1=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.expm1(this.get(n,r)));return this},i.expm1=function(n){return new t(n).expm1()},i.prototype.floor=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.floor(this.get(n,r)));return this},i.floor=function(n){return new t(n).floor()},i.prototype.fround=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.fround(this.get(n,r)));return this},i.fround=function(n){return new t(n).fround()},i.prototype.log=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log(this.get(n,r)));return this},i.log=function(n){return new t(n).log()},i.prototype.log1p=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log1p(this.get(n,r)));return this},i.log1p=function(n){return new t(n).log1p()},i.prototype.log10=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log10(this.get(n,r)));return this},i.log10=function(n){return new t(n).log10()},i.prototype.log2=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log2(this.get(n,r)));return this},i.log2=function(n){return new t(n).log2()},i.prototype.round=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.round(this.get(n,r)));return this},i.round=function(n){return new t(n).round()},i.prototype.sign=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sign(this.get(n,r)));return this},i.sign=function(n){return new t(n).sign()},i.prototype.sin=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sin(this.get(n,r)));return this},i.sin=function(n){return new t(n).sin()},i.prototype.sinh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sinh(this.get(n,r)));return this},i.sinh=function(n){return new t(n).sinh()},i.prototype.sqrt=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sqrt(this.get(n,r)));return this},i.sqrt=function(n){return new t(n).sqrt()},i.prototype.tan=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.tan(this.get(n,r)));return this},i.tan=function(n){return new t(n).tan()},i.prototype.tanh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.tanh(this.get(n,r)));return this},i.tanh=function(n){return new t(n).tanh()},i.prototype.trunc=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.trunc(this.get(n,r)));return this},i.trunc=function(n){return new t(n).trunc()},i.pow=function(n,r){return new t(n).pow(r)},i.prototype.pow=function(n){return typeof n=="number"?this.powS(n):this.powM(n)},i.prototype.powS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)**n);return this},i.prototype.powM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)**n.get(r,s));return this}}function Di(i,t,e){let n=e?i.rows:i.rows-1;if(t<0||t>n)throw new RangeError("Row index out of range")}function Oi(i,t,e){let n=e?i.columns:i.columns-1;if(t<0||t>n)throw new RangeError("Column index out of range")}function ks(i,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==i.columns)throw new RangeError("vector size must be the same as the number of columns");return t}function Bs(i,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==i.rows)throw new RangeError("vector size must be the same as the number of rows");return t}function Ay(i,t){if(!On(t))throw new TypeError("row indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=i.rows)throw new RangeError("row indices are out of range")}function Ey(i,t){if(!On(t))throw new TypeError("column indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=i.columns)throw new RangeError("column indices are out of range")}function Td(i,t,e,n,r){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(Nc("startRow",t),Nc("endRow",e),Nc("startColumn",n),Nc("endColumn",r),t>e||n>r||t<0||t>=i.rows||e<0||e>=i.rows||n<0||n>=i.columns||r<0||r>=i.columns)throw new RangeError("Submatrix indices are out of range")}function Va(i,t=0){let e=[];for(let n=0;n<i;n++)e.push(t);return e}function Nc(i,t){if(typeof t!="number")throw new TypeError(`${i} must be a number`)}function zs(i){if(i.isEmpty())throw new Error("Empty matrix has no elements to index")}function Ty(i){let t=Va(i.rows);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[e]+=i.get(e,n);return t}function Ry(i){let t=Va(i.columns);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[n]+=i.get(e,n);return t}function Cy(i){let t=0;for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)t+=i.get(e,n);return t}function Py(i){let t=Va(i.rows,1);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[e]*=i.get(e,n);return t}function Iy(i){let t=Va(i.columns,1);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[n]*=i.get(e,n);return t}function Ly(i){let t=1;for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)t*=i.get(e,n);return t}function Fy(i,t,e){let n=i.rows,r=i.columns,s=[];for(let o=0;o<n;o++){let a=0,l=0,c=0;for(let u=0;u<r;u++)c=i.get(o,u)-e[o],a+=c,l+=c*c;t?s.push((l-a*a/r)/(r-1)):s.push((l-a*a/r)/r)}return s}function Ny(i,t,e){let n=i.rows,r=i.columns,s=[];for(let o=0;o<r;o++){let a=0,l=0,c=0;for(let u=0;u<n;u++)c=i.get(u,o)-e[o],a+=c,l+=c*c;t?s.push((l-a*a/n)/(n-1)):s.push((l-a*a/n)/n)}return s}function Dy(i,t,e){let n=i.rows,r=i.columns,s=n*r,o=0,a=0,l=0;for(let c=0;c<n;c++)for(let u=0;u<r;u++)l=i.get(c,u)-e,o+=l,a+=l*l;return t?(a-o*o/s)/(s-1):(a-o*o/s)/s}function Oy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t[e])}function Uy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t[n])}function ky(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t)}function By(i){let t=[];for(let e=0;e<i.rows;e++){let n=0;for(let r=0;r<i.columns;r++)n+=i.get(e,r)**2/(i.columns-1);t.push(Math.sqrt(n))}return t}function zy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t[e])}function Vy(i){let t=[];for(let e=0;e<i.columns;e++){let n=0;for(let r=0;r<i.rows;r++)n+=i.get(r,e)**2/(i.rows-1);t.push(Math.sqrt(n))}return t}function Gy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t[n])}function Hy(i){let t=i.size-1,e=0;for(let n=0;n<i.columns;n++)for(let r=0;r<i.rows;r++)e+=i.get(r,n)**2/t;return Math.sqrt(e)}function Wy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t)}var un=class i{static from1DArray(t,e,n){if(t*e!==n.length)throw new RangeError("data length does not match given dimensions");let s=new $t(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)s.set(o,a,n[o*e+a]);return s}static rowVector(t){let e=new $t(1,t.length);for(let n=0;n<t.length;n++)e.set(0,n,t[n]);return e}static columnVector(t){let e=new $t(t.length,1);for(let n=0;n<t.length;n++)e.set(n,0,t[n]);return e}static zeros(t,e){return new $t(t,e)}static ones(t,e){return new $t(t,e).fill(1)}static rand(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{random:r=Math.random}=n,s=new $t(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)s.set(o,a,r());return s}static randInt(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{min:r=0,max:s=1e3,random:o=Math.random}=n;if(!Number.isInteger(r))throw new TypeError("min must be an integer");if(!Number.isInteger(s))throw new TypeError("max must be an integer");if(r>=s)throw new RangeError("min must be smaller than max");let a=s-r,l=new $t(t,e);for(let c=0;c<t;c++)for(let u=0;u<e;u++){let h=r+Math.round(o()*a);l.set(c,u,h)}return l}static eye(t,e,n){e===void 0&&(e=t),n===void 0&&(n=1);let r=Math.min(t,e),s=this.zeros(t,e);for(let o=0;o<r;o++)s.set(o,o,n);return s}static diag(t,e,n){let r=t.length;e===void 0&&(e=r),n===void 0&&(n=e);let s=Math.min(r,e,n),o=this.zeros(e,n);for(let a=0;a<s;a++)o.set(a,a,t[a]);return o}static min(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,r=t.columns,s=new $t(n,r);for(let o=0;o<n;o++)for(let a=0;a<r;a++)s.set(o,a,Math.min(t.get(o,a),e.get(o,a)));return s}static max(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,r=t.columns,s=new this(n,r);for(let o=0;o<n;o++)for(let a=0;a<r;a++)s.set(o,a,Math.max(t.get(o,a),e.get(o,a)));return s}static checkMatrix(t){return i.isMatrix(t)?t:new $t(t)}static isMatrix(t){return t!=null&&t.klass==="Matrix"}get size(){return this.rows*this.columns}apply(t){if(typeof t!="function")throw new TypeError("callback must be a function");for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.call(this,e,n);return this}applyAlongAxis(t,e){if(typeof t!="function")throw new TypeError("callback must be a function");let n=[];switch(e){case"row":{for(let r=0;r<this.rows;r++)n.push(t.call(this,this.getRow(r),r));break}case"column":{for(let r=0;r<this.columns;r++)n.push(t.call(this,this.getColumn(r),r));break}default:throw new Error(`invalid option: ${e}`)}return n}to1DArray(){let t=[];for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.push(this.get(e,n));return t}to2DArray(){let t=[];for(let e=0;e<this.rows;e++){t.push([]);for(let n=0;n<this.columns;n++)t[e].push(this.get(e,n))}return t}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let t=0;t<this.rows;t++)for(let e=0;e<=t;e++)if(this.get(t,e)!==this.get(e,t))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let t=0;t<this.rows;t++)if(this.get(t,t)!==0)return!1;return!0}isEchelonForm(){let t=0,e=0,n=-1,r=!0,s=!1;for(;t<this.rows&&r;){for(e=0,s=!1;e<this.columns&&s===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(s=!0,n=e):(r=!1,s=!0);t++}return r}isReducedEchelonForm(){let t=0,e=0,n=-1,r=!0,s=!1;for(;t<this.rows&&r;){for(e=0,s=!1;e<this.columns&&s===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(s=!0,n=e):(r=!1,s=!0);for(let o=e+1;o<this.rows;o++)this.get(t,o)!==0&&(r=!1);t++}return r}echelonForm(){let t=this.clone(),e=0,n=0;for(;e<t.rows&&n<t.columns;){let r=e;for(let s=e;s<t.rows;s++)t.get(s,n)>t.get(r,n)&&(r=s);if(t.get(r,n)===0)n++;else{t.swapRows(e,r);let s=t.get(e,n);for(let o=n;o<t.columns;o++)t.set(e,o,t.get(e,o)/s);for(let o=e+1;o<t.rows;o++){let a=t.get(o,n)/t.get(e,n);t.set(o,n,0);for(let l=n+1;l<t.columns;l++)t.set(o,l,t.get(o,l)-t.get(e,l)*a)}e++,n++}}return t}reducedEchelonForm(){let t=this.echelonForm(),e=t.columns,n=t.rows,r=n-1;for(;r>=0;)if(t.maxRow(r)===0)r--;else{let s=0,o=!1;for(;s<n&&o===!1;)t.get(r,s)===1?o=!0:s++;for(let a=0;a<r;a++){let l=t.get(a,s);for(let c=s;c<e;c++){let u=t.get(a,c)-l*t.get(r,c);t.set(a,c,u)}}r--}return t}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{rows:e=1,columns:n=1}=t;if(!Number.isInteger(e)||e<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(n)||n<=0)throw new TypeError("columns must be a positive integer");let r=new $t(this.rows*e,this.columns*n);for(let s=0;s<e;s++)for(let o=0;o<n;o++)r.setSubMatrix(this,this.rows*s,this.columns*o);return r}fill(t){for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,t);return this}neg(){return this.mulS(-1)}getRow(t){Di(this,t);let e=[];for(let n=0;n<this.columns;n++)e.push(this.get(t,n));return e}getRowVector(t){return $t.rowVector(this.getRow(t))}setRow(t,e){Di(this,t),e=ks(this,e);for(let n=0;n<this.columns;n++)this.set(t,n,e[n]);return this}swapRows(t,e){Di(this,t),Di(this,e);for(let n=0;n<this.columns;n++){let r=this.get(t,n);this.set(t,n,this.get(e,n)),this.set(e,n,r)}return this}getColumn(t){Oi(this,t);let e=[];for(let n=0;n<this.rows;n++)e.push(this.get(n,t));return e}getColumnVector(t){return $t.columnVector(this.getColumn(t))}setColumn(t,e){Oi(this,t),e=Bs(this,e);for(let n=0;n<this.rows;n++)this.set(n,t,e[n]);return this}swapColumns(t,e){Oi(this,t),Oi(this,e);for(let n=0;n<this.rows;n++){let r=this.get(n,t);this.set(n,t,this.get(n,e)),this.set(n,e,r)}return this}addRowVector(t){t=ks(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[n]);return this}subRowVector(t){t=ks(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[n]);return this}mulRowVector(t){t=ks(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[n]);return this}divRowVector(t){t=ks(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[n]);return this}addColumnVector(t){t=Bs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[e]);return this}subColumnVector(t){t=Bs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[e]);return this}mulColumnVector(t){t=Bs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[e]);return this}divColumnVector(t){t=Bs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[e]);return this}mulRow(t,e){Di(this,t);for(let n=0;n<this.columns;n++)this.set(t,n,this.get(t,n)*e);return this}mulColumn(t,e){Oi(this,t);for(let n=0;n<this.rows;n++)this.set(n,t,this.get(n,t)*e);return this}max(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e[n]&&(e[n]=this.get(n,r));return e}case"column":{let e=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e[r]&&(e[r]=this.get(n,r));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e&&(e=this.get(n,r));return e}default:throw new Error(`invalid option: ${t}`)}}maxIndex(){zs(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>t&&(t=this.get(n,r),e[0]=n,e[1]=r);return e}min(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e[n]&&(e[n]=this.get(n,r));return e}case"column":{let e=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e[r]&&(e[r]=this.get(n,r));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e&&(e=this.get(n,r));return e}default:throw new Error(`invalid option: ${t}`)}}minIndex(){zs(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<t&&(t=this.get(n,r),e[0]=n,e[1]=r);return e}maxRow(t){if(Di(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)>e&&(e=this.get(t,n));return e}maxRowIndex(t){Di(this,t),zs(this);let e=this.get(t,0),n=[t,0];for(let r=1;r<this.columns;r++)this.get(t,r)>e&&(e=this.get(t,r),n[1]=r);return n}minRow(t){if(Di(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)<e&&(e=this.get(t,n));return e}minRowIndex(t){Di(this,t),zs(this);let e=this.get(t,0),n=[t,0];for(let r=1;r<this.columns;r++)this.get(t,r)<e&&(e=this.get(t,r),n[1]=r);return n}maxColumn(t){if(Oi(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)>e&&(e=this.get(n,t));return e}maxColumnIndex(t){Oi(this,t),zs(this);let e=this.get(0,t),n=[0,t];for(let r=1;r<this.rows;r++)this.get(r,t)>e&&(e=this.get(r,t),n[0]=r);return n}minColumn(t){if(Oi(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)<e&&(e=this.get(n,t));return e}minColumnIndex(t){Oi(this,t),zs(this);let e=this.get(0,t),n=[0,t];for(let r=1;r<this.rows;r++)this.get(r,t)<e&&(e=this.get(r,t),n[0]=r);return n}diag(){let t=Math.min(this.rows,this.columns),e=[];for(let n=0;n<t;n++)e.push(this.get(n,n));return e}norm(t="frobenius"){switch(t){case"max":return $t.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${t}`)}}cumulativeSum(){let t=0;for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t+=this.get(e,n),this.set(e,n,t);return this}dot(t){i.isMatrix(t)&&(t=t.to1DArray());let e=this.to1DArray();if(e.length!==t.length)throw new RangeError("vectors do not have the same size");let n=0;for(let r=0;r<e.length;r++)n+=e[r]*t[r];return n}mmul(t){t=$t.checkMatrix(t);let e=this.rows,n=this.columns,r=t.columns,s=new $t(e,r),o=new Float64Array(n);for(let a=0;a<r;a++){for(let l=0;l<n;l++)o[l]=t.get(l,a);for(let l=0;l<e;l++){let c=0;for(let u=0;u<n;u++)c+=this.get(l,u)*o[u];s.set(l,a,c)}}return s}gram(){let t=this.rows,e=this.columns,n=new Float64Array(e*e);for(let s=0;s<t;s++)for(let o=0;o<e;o++){let a=this.get(s,o);if(a===0)continue;let l=o*e;for(let c=o;c<e;c++)n[l+c]+=a*this.get(s,c)}let r=new $t(e,e);for(let s=0;s<e;s++){let o=s*e;for(let a=s;a<e;a++){let l=n[o+a];r.set(s,a,l),r.set(a,s,l)}}return r}transposeMultiply(t){if(t=$t.checkMatrix(t),this.rows!==t.rows)throw new RangeError("the number of rows of the two matrices must be equal");let e=this.columns,n=t.columns,r=new $t(e,n),s=new Float64Array(n);for(let o=0;o<this.rows;o++){for(let a=0;a<n;a++)s[a]=t.get(o,a);for(let a=0;a<e;a++){let l=this.get(o,a);if(l===0)continue;let c=r.data[a];for(let u=0;u<n;u++)c[u]+=l*s[u]}}return r}mmulByTranspose(t){let e=this.rows,n=this.columns;if(t!==void 0&&t.length!==n)throw new RangeError("scale must have one value per column");let r=new $t(e,e),s=new Float64Array(n);for(let o=0;o<e;o++){if(t===void 0)for(let a=0;a<n;a++)s[a]=this.get(o,a);else for(let a=0;a<n;a++)s[a]=t[a]*this.get(o,a);for(let a=o;a<e;a++){let l=0;for(let c=0;c<n;c++)l+=this.get(a,c)*s[c];r.set(a,o,l),r.set(o,a,l)}}return r}mpow(t){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(t)||t<0)throw new RangeError("Exponent must be a non-negative integer");let e=$t.eye(this.rows),n=this;for(let r=t;r>=1;r/=2)(r&1)!==0&&(e=e.mmul(n)),n=n.mmul(n);return e}strassen2x2(t){t=$t.checkMatrix(t);let e=new $t(2,2),n=this.get(0,0),r=t.get(0,0),s=this.get(0,1),o=t.get(0,1),a=this.get(1,0),l=t.get(1,0),c=this.get(1,1),u=t.get(1,1),h=(n+c)*(r+u),f=(a+c)*r,d=n*(o-u),m=c*(l-r),y=(n+s)*u,g=(a-n)*(r+o),p=(s-c)*(l+u),x=h+m-y+p,b=d+y,v=f+m,S=h-f+d+g;return e.set(0,0,x),e.set(0,1,b),e.set(1,0,v),e.set(1,1,S),e}strassen3x3(t){t=$t.checkMatrix(t);let e=new $t(3,3),n=this.get(0,0),r=this.get(0,1),s=this.get(0,2),o=this.get(1,0),a=this.get(1,1),l=this.get(1,2),c=this.get(2,0),u=this.get(2,1),h=this.get(2,2),f=t.get(0,0),d=t.get(0,1),m=t.get(0,2),y=t.get(1,0),g=t.get(1,1),p=t.get(1,2),x=t.get(2,0),b=t.get(2,1),v=t.get(2,2),S=(n+r+s-o-a-u-h)*g,A=(n-o)*(-d+g),_=a*(-f+d+y-g-p-x+v),w=(-n+o+a)*(f-d+g),N=(o+a)*(-f+d),P=n*f,I=(-n+c+u)*(f-m+p),U=(-n+c)*(m-p),z=(c+u)*(-f+m),C=(n+r+s-a-l-c-u)*p,O=u*(-f+m+y-g-p-x+b),W=(-s+u+h)*(g+x-b),G=(s-h)*(g-b),et=s*x,$=(u+h)*(-x+b),X=(-s+a+l)*(p+x-v),tt=(s-l)*(p-v),ht=(a+l)*(-x+v),ct=r*y,J=l*b,dt=o*m,gt=c*d,bt=h*v,yt=P+et+ct,Gt=S+w+N+P+W+et+$,Kt=P+I+z+C+et+X+ht,zt=A+_+w+P+et+X+tt,le=A+w+N+P+J,oe=et+X+tt+ht+dt,Jt=P+I+U+O+W+G+et,Fe=W+G+et+$+gt,Ae=P+I+U+z+bt;return e.set(0,0,yt),e.set(0,1,Gt),e.set(0,2,Kt),e.set(1,0,zt),e.set(1,1,le),e.set(1,2,oe),e.set(2,0,Jt),e.set(2,1,Fe),e.set(2,2,Ae),e}mmulStrassen(t){t=$t.checkMatrix(t);let e=this.clone(),n=e.rows,r=e.columns,s=t.rows,o=t.columns;r!==s&&console.warn(`Multiplying ${n} x ${r} and ${s} x ${o} matrix: dimensions do not match.`);function a(h,f,d){let m=h.rows,y=h.columns;if(m===f&&y===d)return h;{let g=i.zeros(f,d);return g=g.setSubMatrix(h,0,0),g}}let l=Math.max(n,s),c=Math.max(r,o);e=a(e,l,c),t=a(t,l,c);function u(h,f,d,m){if(d<=512||m<=512)return h.mmul(f);d%2===1&&m%2===1?(h=a(h,d+1,m+1),f=a(f,d+1,m+1)):d%2===1?(h=a(h,d+1,m),f=a(f,d+1,m)):m%2===1&&(h=a(h,d,m+1),f=a(f,d,m+1));let y=parseInt(h.rows/2,10),g=parseInt(h.columns/2,10),p=h.subMatrix(0,y-1,0,g-1),x=f.subMatrix(0,y-1,0,g-1),b=h.subMatrix(0,y-1,g,h.columns-1),v=f.subMatrix(0,y-1,g,f.columns-1),S=h.subMatrix(y,h.rows-1,0,g-1),A=f.subMatrix(y,f.rows-1,0,g-1),_=h.subMatrix(y,h.rows-1,g,h.columns-1),w=f.subMatrix(y,f.rows-1,g,f.columns-1),N=u(i.add(p,_),i.add(x,w),y,g),P=u(i.add(S,_),x,y,g),I=u(p,i.sub(v,w),y,g),U=u(_,i.sub(A,x),y,g),z=u(i.add(p,b),w,y,g),C=u(i.sub(S,p),i.add(x,v),y,g),O=u(i.sub(b,_),i.add(A,w),y,g),W=i.add(N,U);W.sub(z),W.add(O);let G=i.add(I,z),et=i.add(P,U),$=i.sub(N,P);$.add(I),$.add(C);let X=i.zeros(2*W.rows,2*W.columns);return X=X.setSubMatrix(W,0,0),X=X.setSubMatrix(G,W.rows,0),X=X.setSubMatrix(et,0,W.columns),X=X.setSubMatrix($,W.rows,W.columns),X.subMatrix(0,d-1,0,m-1)}return u(e,t,l,c)}scaleRows(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let r=new $t(this.rows,this.columns);for(let s=0;s<this.rows;s++){let o=this.getRow(s);o.length>0&&Lc(o,{min:e,max:n,output:o}),r.setRow(s,o)}return r}scaleColumns(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let r=new $t(this.rows,this.columns);for(let s=0;s<this.columns;s++){let o=this.getColumn(s);o.length&&Lc(o,{min:e,max:n,output:o}),r.setColumn(s,o)}return r}flipRows(){let t=Math.ceil(this.columns/2);for(let e=0;e<this.rows;e++)for(let n=0;n<t;n++){let r=this.get(e,n),s=this.get(e,this.columns-1-n);this.set(e,n,s),this.set(e,this.columns-1-n,r)}return this}flipColumns(){let t=Math.ceil(this.rows/2);for(let e=0;e<this.columns;e++)for(let n=0;n<t;n++){let r=this.get(n,e),s=this.get(this.rows-1-n,e);this.set(n,e,s),this.set(this.rows-1-n,e,r)}return this}kroneckerProduct(t){t=$t.checkMatrix(t);let e=this.rows,n=this.columns,r=t.rows,s=t.columns,o=new $t(e*r,n*s);for(let a=0;a<e;a++)for(let l=0;l<n;l++)for(let c=0;c<r;c++)for(let u=0;u<s;u++)o.set(r*a+c,s*l+u,this.get(a,l)*t.get(c,u));return o}kroneckerSum(t){if(t=$t.checkMatrix(t),!this.isSquare()||!t.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let e=this.rows,n=t.rows,r=this.kroneckerProduct($t.eye(n,n)),s=$t.eye(e,e).kroneckerProduct(t);return r.add(s)}transpose(){let t=new $t(this.columns,this.rows);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.set(n,e,this.get(e,n));return t}sortRows(t=qy){for(let e=0;e<this.rows;e++)this.setRow(e,this.getRow(e).sort(t));return this}sortColumns(t=qy){for(let e=0;e<this.columns;e++)this.setColumn(e,this.getColumn(e).sort(t));return this}subMatrix(t,e,n,r){Td(this,t,e,n,r);let s=new $t(e-t+1,r-n+1);for(let o=t;o<=e;o++)for(let a=n;a<=r;a++)s.set(o-t,a-n,this.get(o,a));return s}subMatrixRow(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.columns-1),e>n||e<0||e>=this.columns||n<0||n>=this.columns)throw new RangeError("Argument out of range");let r=new $t(t.length,n-e+1);for(let s=0;s<t.length;s++)for(let o=e;o<=n;o++){if(t[s]<0||t[s]>=this.rows)throw new RangeError(`Row index out of range: ${t[s]}`);r.set(s,o-e,this.get(t[s],o))}return r}subMatrixColumn(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.rows-1),e>n||e<0||e>=this.rows||n<0||n>=this.rows)throw new RangeError("Argument out of range");let r=new $t(n-e+1,t.length);for(let s=0;s<t.length;s++)for(let o=e;o<=n;o++){if(t[s]<0||t[s]>=this.columns)throw new RangeError(`Column index out of range: ${t[s]}`);r.set(o-e,s,this.get(o,t[s]))}return r}setSubMatrix(t,e,n){if(t=$t.checkMatrix(t),t.isEmpty())return this;let r=e+t.rows-1,s=n+t.columns-1;Td(this,e,r,n,s);for(let o=0;o<t.rows;o++)for(let a=0;a<t.columns;a++)this.set(e+o,n+a,t.get(o,a));return this}concat(t,e="row"){switch(t=$t.checkMatrix(t),e){case"row":{if(this.columns!==t.columns)throw new RangeError("both matrices must have the same number of columns");let n=new $t(this.rows+t.rows,this.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,this.rows,0),n}case"column":{if(this.rows!==t.rows)throw new RangeError("both matrices must have the same number of rows");let n=new $t(this.rows,this.columns+t.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,0,this.columns),n}default:throw new Error(`invalid option: ${e}`)}}selection(t,e){Ay(this,t),Ey(this,e);let n=new $t(t.length,e.length);for(let r=0;r<t.length;r++){let s=t[r];for(let o=0;o<e.length;o++){let a=e[o];n.set(r,o,this.get(s,a))}}return n}trace(){let t=Math.min(this.rows,this.columns),e=0;for(let n=0;n<t;n++)e+=this.get(n,n);return e}clone(){return this.constructor.copy(this,new $t(this.rows,this.columns))}static copy(t,e){for(let[n,r,s]of t.entries())e.set(n,r,s);return e}sum(t){switch(t){case"row":return Ty(this);case"column":return Ry(this);case void 0:return Cy(this);default:throw new Error(`invalid option: ${t}`)}}product(t){switch(t){case"row":return Py(this);case"column":return Iy(this);case void 0:return Ly(this);default:throw new Error(`invalid option: ${t}`)}}mean(t){let e=this.sum(t);switch(t){case"row":{for(let n=0;n<this.rows;n++)e[n]/=this.columns;return e}case"column":{for(let n=0;n<this.columns;n++)e[n]/=this.rows;return e}case void 0:return e/this.size;default:throw new Error(`invalid option: ${t}`)}}variance(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{unbiased:n=!0,mean:r=this.mean(t)}=e;if(typeof n!="boolean")throw new TypeError("unbiased must be a boolean");switch(t){case"row":{if(!On(r))throw new TypeError("mean must be an array");return Fy(this,n,r)}case"column":{if(!On(r))throw new TypeError("mean must be an array");return Ny(this,n,r)}case void 0:{if(typeof r!="number")throw new TypeError("mean must be a number");return Dy(this,n,r)}default:throw new Error(`invalid option: ${t}`)}}standardDeviation(t,e){typeof t=="object"&&(e=t,t=void 0);let n=this.variance(t,e);if(t===void 0)return Math.sqrt(n);for(let r=0;r<n.length;r++)n[r]=Math.sqrt(n[r]);return n}center(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{center:n=this.mean(t)}=e;switch(t){case"row":{if(!On(n))throw new TypeError("center must be an array");return Oy(this,n),this}case"column":{if(!On(n))throw new TypeError("center must be an array");return Uy(this,n),this}case void 0:{if(typeof n!="number")throw new TypeError("center must be a number");return ky(this,n),this}default:throw new Error(`invalid option: ${t}`)}}scale(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let n=e.scale;switch(t){case"row":{if(n===void 0)n=By(this);else if(!On(n))throw new TypeError("scale must be an array");return zy(this,n),this}case"column":{if(n===void 0)n=Vy(this);else if(!On(n))throw new TypeError("scale must be an array");return Gy(this,n),this}case void 0:{if(n===void 0)n=Hy(this);else if(typeof n!="number")throw new TypeError("scale must be a number");return Wy(this,n),this}default:throw new Error(`invalid option: ${t}`)}}toString(t){return Ed(this,t)}[Symbol.iterator](){return this.entries()}*entries(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield[t,e,this.get(t,e)]}*values(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield this.get(t,e)}};un.prototype.klass="Matrix";typeof Symbol<"u"&&(un.prototype[Symbol.for("nodejs.util.inspect.custom")]=My);function qy(i,t){return i-t}function h1(i){return i.every(t=>typeof t=="number")}un.random=un.rand;un.randomInt=un.randInt;un.diagonal=un.diag;un.prototype.diagonal=un.prototype.diag;un.identity=un.eye;un.prototype.negate=un.prototype.neg;un.prototype.tensorProduct=un.prototype.kroneckerProduct;var $t=class i extends un{data;#t(t,e){if(this.data=[],Number.isInteger(e)&&e>=0)for(let n=0;n<t;n++)this.data.push(new Float64Array(e));else throw new TypeError("nColumns must be a positive integer");this.rows=t,this.columns=e}constructor(t,e){if(super(),i.isMatrix(t))this.#t(t.rows,t.columns),i.copy(t,this);else if(Number.isInteger(t)&&t>=0)this.#t(t,e);else if(On(t)){let n=t;if(t=n.length,e=t?n[0].length:0,typeof e!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let r=0;r<t;r++){if(n[r].length!==e)throw new RangeError("Inconsistent array dimensions");if(!h1(n[r]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(n[r]))}this.rows=t,this.columns=e}else throw new TypeError("First argument must be a positive number or an array")}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}removeRow(t){return Di(this,t),this.data.splice(t,1),this.rows-=1,this}addRow(t,e){return e===void 0&&(e=t,t=this.rows),Di(this,t,!0),e=Float64Array.from(ks(this,e)),this.data.splice(t,0,e),this.rows+=1,this}removeColumn(t){Oi(this,t);for(let e=0;e<this.rows;e++){let n=new Float64Array(this.columns-1);for(let r=0;r<t;r++)n[r]=this.data[e][r];for(let r=t+1;r<this.columns;r++)n[r-1]=this.data[e][r];this.data[e]=n}return this.columns-=1,this}addColumn(t,e){typeof e>"u"&&(e=t,t=this.columns),Oi(this,t,!0),e=Bs(this,e);for(let n=0;n<this.rows;n++){let r=new Float64Array(this.columns+1),s=0;for(;s<t;s++)r[s]=this.data[n][s];for(r[s++]=e[n];s<this.columns+1;s++)r[s]=this.data[n][s-1];this.data[n]=r}return this.columns+=1,this}};Sy(un,$t);var Ga=class extends un{constructor(t){super(),this.data=t,this.rows=t.length,this.columns=t[0].length}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}};function $y(i){let t=i.data,e=i.rows;for(let n=0;n<e;n++){let r=t[n];for(let s=n+1;s<e;s++){let o=r[s];r[s]=t[s][n],t[s][n]=o}}return i}function Rd(i,t){let e=0;return Math.abs(i)>Math.abs(t)?(e=t/i,Math.abs(i)*Math.sqrt(1+e*e)):t!==0?(e=i/t,Math.abs(t)*Math.sqrt(1+e*e)):0}var os=class{constructor(t,e={}){let{assumeSymmetric:n=!1}=e;if(t=Ga.checkMatrix(t),!t.isSquare())throw new Error("Matrix is not a square matrix");if(t.isEmpty())throw new Error("Matrix must be non-empty");let r=t.columns,s=new $t(r,r),o=new Float64Array(r),a=new Float64Array(r),l=t,c,u,h=!1;if(n?h=!0:h=t.isSymmetric(),h){for(c=0;c<r;c++)for(u=0;u<r;u++)s.set(u,c,l.get(c,u));f1(r,a,o,s),d1(r,a,o,s),$y(s)}else{let f=new $t(r,r),d=new Float64Array(r);for(u=0;u<r;u++)for(c=0;c<r;c++)f.set(c,u,l.get(c,u));p1(r,f,d,s),m1(r,a,o,s,f)}this.n=r,this.e=a,this.d=o,this.V=s}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let t=this.n,e=this.e,n=this.d,r=new $t(t,t),s,o;for(s=0;s<t;s++){for(o=0;o<t;o++)r.set(s,o,0);r.set(s,s,n[s]),e[s]>0?r.set(s,s+1,e[s]):e[s]<0&&r.set(s,s-1,e[s])}return r}};function f1(i,t,e,n){let r,s,o,a,l,c,u,h;for(l=0;l<i;l++)e[l]=n.get(l,i-1);for(a=i-1;a>0;a--){for(h=0,o=0,c=0;c<a;c++)h=h+Math.abs(e[c]);if(h===0)for(t[a]=e[a-1],l=0;l<a;l++)e[l]=n.get(l,a-1),n.set(l,a,0),n.set(a,l,0);else{for(c=0;c<a;c++)e[c]/=h,o+=e[c]*e[c];for(r=e[a-1],s=Math.sqrt(o),r>0&&(s=-s),t[a]=h*s,o=o-r*s,e[a-1]=r-s,l=0;l<a;l++)t[l]=0;for(l=0;l<a;l++){for(r=e[l],n.set(a,l,r),s=t[l]+n.get(l,l)*r,c=l+1;c<=a-1;c++)s+=n.get(l,c)*e[c],t[c]+=n.get(l,c)*r;t[l]=s}for(r=0,l=0;l<a;l++)t[l]/=o,r+=t[l]*e[l];for(u=r/(o+o),l=0;l<a;l++)t[l]-=u*e[l];for(l=0;l<a;l++){for(r=e[l],s=t[l],c=l;c<=a-1;c++)n.set(l,c,n.get(l,c)-(r*t[c]+s*e[c]));e[l]=n.get(l,a-1),n.set(l,a,0)}}e[a]=o}for(a=0;a<i-1;a++){if(n.set(a,i-1,n.get(a,a)),n.set(a,a,1),o=e[a+1],o!==0){for(c=0;c<=a;c++)e[c]=n.get(a+1,c)/o;for(l=0;l<=a;l++){for(s=0,c=0;c<=a;c++)s+=n.get(a+1,c)*n.get(l,c);for(c=0;c<=a;c++)n.set(l,c,n.get(l,c)-s*e[c])}}for(c=0;c<=a;c++)n.set(a+1,c,0)}for(l=0;l<i;l++)e[l]=n.get(l,i-1),n.set(l,i-1,0);n.set(i-1,i-1,1),t[0]=0}function d1(i,t,e,n){let r,s,o,a,l,c,u,h,f,d,m,y,g,p,x,b,v;for(o=1;o<i;o++)t[o-1]=t[o];t[i-1]=0;let S=0,A=0,_=Number.EPSILON;for(c=0;c<i;c++){for(A=Math.max(A,Math.abs(e[c])+Math.abs(t[c])),u=c;u<i&&!(Math.abs(t[u])<=_*A);)u++;if(u>c){v=0;do{for(v=v+1,r=e[c],h=(e[c+1]-r)/(2*t[c]),f=Rd(h,1),h<0&&(f=-f),e[c]=t[c]/(h+f),e[c+1]=t[c]*(h+f),d=e[c+1],s=r-e[c],o=c+2;o<i;o++)e[o]-=s;for(S=S+s,h=e[u],m=1,y=m,g=m,p=t[c+1],x=0,b=0,o=u-1;o>=c;o--)for(g=y,y=m,b=x,r=m*t[o],s=m*h,f=Rd(h,t[o]),t[o+1]=x*f,x=t[o]/f,m=h/f,h=m*e[o]-x*r,e[o+1]=s+x*(m*r+x*e[o]),l=0;l<i;l++)s=n.get(o+1,l),n.set(o+1,l,x*n.get(o,l)+m*s),n.set(o,l,m*n.get(o,l)-x*s);h=-x*b*g*p*t[c]/d,t[c]=x*h,e[c]=m*h}while(Math.abs(t[c])>_*A)}e[c]=e[c]+S,t[c]=0}for(o=0;o<i-1;o++){for(l=o,h=e[o],a=o+1;a<i;a++)e[a]<h&&(l=a,h=e[a]);if(l!==o)for(e[l]=e[o],e[o]=h,a=0;a<i;a++)h=n.get(o,a),n.set(o,a,n.get(l,a)),n.set(l,a,h)}}function p1(i,t,e,n){let r=0,s=i-1,o,a,l,c,u,h,f;for(h=r+1;h<=s-1;h++){for(f=0,c=h;c<=s;c++)f=f+Math.abs(t.get(c,h-1));if(f!==0){for(l=0,c=s;c>=h;c--)e[c]=t.get(c,h-1)/f,l+=e[c]*e[c];for(a=Math.sqrt(l),e[h]>0&&(a=-a),l=l-e[h]*a,e[h]=e[h]-a,u=h;u<i;u++){for(o=0,c=s;c>=h;c--)o+=e[c]*t.get(c,u);for(o=o/l,c=h;c<=s;c++)t.set(c,u,t.get(c,u)-o*e[c])}for(c=0;c<=s;c++){for(o=0,u=s;u>=h;u--)o+=e[u]*t.get(c,u);for(o=o/l,u=h;u<=s;u++)t.set(c,u,t.get(c,u)-o*e[u])}e[h]=f*e[h],t.set(h,h-1,f*a)}}for(c=0;c<i;c++)for(u=0;u<i;u++)n.set(c,u,c===u?1:0);for(h=s-1;h>=r+1;h--)if(t.get(h,h-1)!==0){for(c=h+1;c<=s;c++)e[c]=t.get(c,h-1);for(u=h;u<=s;u++){for(a=0,c=h;c<=s;c++)a+=e[c]*n.get(c,u);for(a=a/e[h]/t.get(h,h-1),c=h;c<=s;c++)n.set(c,u,n.get(c,u)+a*e[c])}}}function m1(i,t,e,n,r){let s=i-1,o=0,a=i-1,l=Number.EPSILON,c=0,u=0,h=0,f=0,d=0,m=0,y=0,g=0,p,x,b,v,S,A,_,w,N,P,I,U,z,C,O;for(p=0;p<i;p++)for((p<o||p>a)&&(e[p]=r.get(p,p),t[p]=0),x=Math.max(p-1,0);x<i;x++)u=u+Math.abs(r.get(p,x));for(;s>=o;){for(v=s;v>o&&(m=Math.abs(r.get(v-1,v-1))+Math.abs(r.get(v,v)),m===0&&(m=u),!(Math.abs(r.get(v,v-1))<l*m));)v--;if(v===s)r.set(s,s,r.get(s,s)+c),e[s]=r.get(s,s),t[s]=0,s--,g=0;else if(v===s-1){if(_=r.get(s,s-1)*r.get(s-1,s),h=(r.get(s-1,s-1)-r.get(s,s))/2,f=h*h+_,y=Math.sqrt(Math.abs(f)),r.set(s,s,r.get(s,s)+c),r.set(s-1,s-1,r.get(s-1,s-1)+c),w=r.get(s,s),f>=0){for(y=h>=0?h+y:h-y,e[s-1]=w+y,e[s]=e[s-1],y!==0&&(e[s]=w-_/y),t[s-1]=0,t[s]=0,w=r.get(s,s-1),m=Math.abs(w)+Math.abs(y),h=w/m,f=y/m,d=Math.sqrt(h*h+f*f),h=h/d,f=f/d,x=s-1;x<i;x++)y=r.get(s-1,x),r.set(s-1,x,f*y+h*r.get(s,x)),r.set(s,x,f*r.get(s,x)-h*y);for(p=0;p<=s;p++)y=r.get(p,s-1),r.set(p,s-1,f*y+h*r.get(p,s)),r.set(p,s,f*r.get(p,s)-h*y);for(p=o;p<=a;p++)y=n.get(p,s-1),n.set(p,s-1,f*y+h*n.get(p,s)),n.set(p,s,f*n.get(p,s)-h*y)}else e[s-1]=w+h,e[s]=w+h,t[s-1]=y,t[s]=-y;s=s-2,g=0}else{if(w=r.get(s,s),N=0,_=0,v<s&&(N=r.get(s-1,s-1),_=r.get(s,s-1)*r.get(s-1,s)),g===10){for(c+=w,p=o;p<=s;p++)r.set(p,p,r.get(p,p)-w);m=Math.abs(r.get(s,s-1))+Math.abs(r.get(s-1,s-2)),w=N=.75*m,_=-.4375*m*m}if(g===30&&(m=(N-w)/2,m=m*m+_,m>0)){for(m=Math.sqrt(m),N<w&&(m=-m),m=w-_/((N-w)/2+m),p=o;p<=s;p++)r.set(p,p,r.get(p,p)-m);c+=m,w=N=_=.964}for(g=g+1,S=s-2;S>=v&&(y=r.get(S,S),d=w-y,m=N-y,h=(d*m-_)/r.get(S+1,S)+r.get(S,S+1),f=r.get(S+1,S+1)-y-d-m,d=r.get(S+2,S+1),m=Math.abs(h)+Math.abs(f)+Math.abs(d),h=h/m,f=f/m,d=d/m,!(S===v||Math.abs(r.get(S,S-1))*(Math.abs(f)+Math.abs(d))<l*(Math.abs(h)*(Math.abs(r.get(S-1,S-1))+Math.abs(y)+Math.abs(r.get(S+1,S+1))))));)S--;for(p=S+2;p<=s;p++)r.set(p,p-2,0),p>S+2&&r.set(p,p-3,0);for(b=S;b<=s-1&&(C=b!==s-1,b!==S&&(h=r.get(b,b-1),f=r.get(b+1,b-1),d=C?r.get(b+2,b-1):0,w=Math.abs(h)+Math.abs(f)+Math.abs(d),w!==0&&(h=h/w,f=f/w,d=d/w)),w!==0);b++)if(m=Math.sqrt(h*h+f*f+d*d),h<0&&(m=-m),m!==0){for(b!==S?r.set(b,b-1,-m*w):v!==S&&r.set(b,b-1,-r.get(b,b-1)),h=h+m,w=h/m,N=f/m,y=d/m,f=f/h,d=d/h,x=b;x<i;x++)h=r.get(b,x)+f*r.get(b+1,x),C&&(h=h+d*r.get(b+2,x),r.set(b+2,x,r.get(b+2,x)-h*y)),r.set(b,x,r.get(b,x)-h*w),r.set(b+1,x,r.get(b+1,x)-h*N);for(p=0;p<=Math.min(s,b+3);p++)h=w*r.get(p,b)+N*r.get(p,b+1),C&&(h=h+y*r.get(p,b+2),r.set(p,b+2,r.get(p,b+2)-h*d)),r.set(p,b,r.get(p,b)-h),r.set(p,b+1,r.get(p,b+1)-h*f);for(p=o;p<=a;p++)h=w*n.get(p,b)+N*n.get(p,b+1),C&&(h=h+y*n.get(p,b+2),n.set(p,b+2,n.get(p,b+2)-h*d)),n.set(p,b,n.get(p,b)-h),n.set(p,b+1,n.get(p,b+1)-h*f)}}}if(u!==0){for(s=i-1;s>=0;s--)if(h=e[s],f=t[s],f===0)for(v=s,r.set(s,s,1),p=s-1;p>=0;p--){for(_=r.get(p,p)-h,d=0,x=v;x<=s;x++)d=d+r.get(p,x)*r.get(x,s);if(t[p]<0)y=_,m=d;else if(v=p,t[p]===0?r.set(p,s,_!==0?-d/_:-d/(l*u)):(w=r.get(p,p+1),N=r.get(p+1,p),f=(e[p]-h)*(e[p]-h)+t[p]*t[p],A=(w*m-y*d)/f,r.set(p,s,A),r.set(p+1,s,Math.abs(w)>Math.abs(y)?(-d-_*A)/w:(-m-N*A)/y)),A=Math.abs(r.get(p,s)),l*A*A>1)for(x=p;x<=s;x++)r.set(x,s,r.get(x,s)/A)}else if(f<0)for(v=s-1,Math.abs(r.get(s,s-1))>Math.abs(r.get(s-1,s))?(r.set(s-1,s-1,f/r.get(s,s-1)),r.set(s-1,s,-(r.get(s,s)-h)/r.get(s,s-1))):(O=Dc(0,-r.get(s-1,s),r.get(s-1,s-1)-h,f),r.set(s-1,s-1,O[0]),r.set(s-1,s,O[1])),r.set(s,s-1,0),r.set(s,s,1),p=s-2;p>=0;p--){for(P=0,I=0,x=v;x<=s;x++)P=P+r.get(p,x)*r.get(x,s-1),I=I+r.get(p,x)*r.get(x,s);if(_=r.get(p,p)-h,t[p]<0)y=_,d=P,m=I;else if(v=p,t[p]===0?(O=Dc(-P,-I,_,f),r.set(p,s-1,O[0]),r.set(p,s,O[1])):(w=r.get(p,p+1),N=r.get(p+1,p),U=(e[p]-h)*(e[p]-h)+t[p]*t[p]-f*f,z=(e[p]-h)*2*f,U===0&&z===0&&(U=l*u*(Math.abs(_)+Math.abs(f)+Math.abs(w)+Math.abs(N)+Math.abs(y))),O=Dc(w*d-y*P+f*I,w*m-y*I-f*P,U,z),r.set(p,s-1,O[0]),r.set(p,s,O[1]),Math.abs(w)>Math.abs(y)+Math.abs(f)?(r.set(p+1,s-1,(-P-_*r.get(p,s-1)+f*r.get(p,s))/w),r.set(p+1,s,(-I-_*r.get(p,s)-f*r.get(p,s-1))/w)):(O=Dc(-d-N*r.get(p,s-1),-m-N*r.get(p,s),y,f),r.set(p+1,s-1,O[0]),r.set(p+1,s,O[1]))),A=Math.max(Math.abs(r.get(p,s-1)),Math.abs(r.get(p,s))),l*A*A>1)for(x=p;x<=s;x++)r.set(x,s-1,r.get(x,s-1)/A),r.set(x,s,r.get(x,s)/A)}for(p=0;p<i;p++)if(p<o||p>a)for(x=p;x<i;x++)n.set(p,x,r.get(p,x));for(x=i-1;x>=o;x--)for(p=o;p<=a;p++){for(y=0,b=o;b<=Math.min(x,a);b++)y=y+n.get(p,b)*r.get(b,x);n.set(p,x,y)}}}function Dc(i,t,e,n){let r,s;return Math.abs(e)>Math.abs(n)?(r=n/e,s=e+r*n,[(i+r*t)/s,(t-r*i)/s]):(r=e/n,s=n+r*e,[(r*i+t)/s,(r*t-i)/s])}var g1=1e-9,y1=1e-13,x1=1e-6;function Xy(i,t,e){let n=Tc(i,e);if(!n)throw new Error("mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate");let[r,s]=[0,0];for(let h=0;h<e;h+=1)for(let f=0;f<e;f+=1)r=Math.max(r,Math.abs(t[h*e+f]-t[f*e+h])),s=Math.max(s,Math.abs(t[h*e+f]));if(r>g1*s)return{...Pd(n,Cd(Rc(n,t,e),e,!1),e),symmetric:!1};let o=t.map((h,f)=>(h+t[f%e*e+Math.floor(f/e)])/2),a=Tc(o,e),l=a&&Cd(Rc(a,i,e),e,!0),c=l?Math.max(...l.re):0;if(!a||!l||Math.min(...l.re)<=0||1/c<=y1*e/Math.min(...l.re))return{...Pd(n,Cd(Rc(n,o,e),e,!0),e),symmetric:!0};let u=Pd(a,{re:l.re.map(h=>1/h),vectors:l.vectors},e);return{squares:u.squares,shapes:u.shapes.map((h,f)=>h*Math.sqrt(u.squares[f%e])),symmetric:!0}}function Cd(i,t,e){let n=e?i.map((c,u)=>(c+i[u%t*t+Math.floor(u/t)])/2):i,r=new os($t.from1DArray(t,t,n),{assumeSymmetric:e}),{realEigenvalues:s,imaginaryEigenvalues:o,eigenvectorMatrix:a}=r,l=Float64Array.from(a.to1DArray());if(!e){for(let c=1;c<t;c+=1)if(o[c]<0)for(let u=0;u<t;u+=1)l[u*t+c]=l[u*t+c-1]}for(let c=0;c<t;c+=1){let u=Math.hypot(...Array.from({length:t},(h,f)=>l[f*t+c]));for(let h=0;h<t;h+=1)l[h*t+c]/=u}return{re:Float64Array.from(s),vectors:l}}function Pd(i,{re:t,vectors:e},n){let r=Array.from(t.keys()).sort((o,a)=>t[o]-t[a]),s=new Float64Array(n*n);return r.forEach((o,a)=>{for(let l=0;l<n;l+=1)s[l*n+a]=e[l*n+o]}),yd(i,s,n,n),{squares:Float64Array.from(r,o=>t[o]),shapes:s}}function jy(i,t,e,n,r){let s=r.symmetric?r.shapes:_1(i,n),o=y=>si(s,si(y,s,n,n,n),n,n,n,!0),[a,l]=[o(e),o(t)];if(r.symmetric)for(let y=0;y<n*n;y+=1)a[y]=y%(n+1)?0:r.squares[y/(n+1)];let c=Array.from({length:n},(y,g)=>Math.sqrt(Math.abs(a[g*(n+1)]))),u=x1*Math.max(...c)||1,h=c.map(y=>Math.max(y,u)),f=$t.zeros(2*n,2*n);for(let y=0;y<n;y+=1){f.set(y,n+y,h[y]);for(let g=0;g<n;g+=1)f.set(n+y,g,-a[y*n+g]/h[g]),f.set(n+y,n+g,-l[y*n+g])}let d=new os(f,{assumeSymmetric:!1}),m={re:Float64Array.from(d.realEigenvalues),im:Float64Array.from(d.imaginaryEigenvalues)};return{count:2*n,values:m,shapes:v1(d.eigenvectorMatrix,m.im,s,h,n)}}function v1(i,t,e,n,r){let s={re:new Float64Array(2*r*r),im:new Float64Array(2*r*r)};for(let o=0;o<2*r;o+=1)for(let a=0;a<r;a+=1)s.re[2*r*a+o]=i.get(a,t[o]<0?o-1:o)/n[a],s.im[2*r*a+o]=(t[o]>0?i.get(a,o+1):t[o]<0?-i.get(a,o):0)/n[a];return{re:si(e,s.re,r,r,2*r),im:si(e,s.im,r,r,2*r)}}function _1(i,t){let e=Float64Array.from({length:t*t},(n,r)=>r%(t+1)?0:1);return yd(Tc(i,t),e,t,t),e}var b1=["settling","vibration.residual","vibration.nominal"];function Mi(i,t=3){return Pe(i,t)}function Id(i,t){if(i.length<2)return t[0];let e=0;for(let n=1;n<i.length;n+=1)e+=(t[n]+t[n-1])/2*(i[n]-i[n-1]);return e/(i[i.length-1]-i[0])}function Zy(i,t,e,n){let r={},{tip_error:s}=t;if(s){let a=Float64Array.from(i,(l,c)=>Na(s,c,-1));r["tip_error.commanded"]=Yy(i,a,s,n)}let o=t.deviation?.data;return o&&(r["deviation.max"]=Yy(i,o,t.tip_error_nominal,n),r["deviation.rms"]={value:Math.sqrt(Id(i,o.map(a=>a*a))),note:"over the run"}),{...r,...w1(i,e,o!==void 0)}}function Yy(i,t,e,n){let r=za(t),s=`at ${Mi(i[r])} s; ${Gn(t[t.length-1],"m")} at the end of the run`,a=(e?hi(0,e.shape[1]).map(l=>[Na(e,r,l),n[l]]):[]).filter(([l])=>l).map(([l,c])=>`${Gn(l,"m")} ${c??"geometry"}`);return{value:t[r],note:s,time:i[r],more:a.join(", ")}}function w1(i,t,e){let n=i[i.length-1];if(t!==null&&t<=n*(1+1e-9))return{};let r="what moves the robot changes up to the end of the run",s=`the run ends at ${Mi(n,6)} s, the move at ${Mi(t??0,6)} s`,o=t===null?r:`${s}: simulate longer to see it settle`,a={value:null,note:t===null?r:"the run ends with the move"},l={settling:{value:null,note:`not seen: ${o}`},"vibration.residual":a};return e?{...l,"vibration.nominal":a}:l}function Ky(i){let t={},e=b1.filter(n=>n!=="vibration.nominal"||"deviation.max"in i);for(let n of e)t[n]={value:null,note:"the run broke off"};for(let[n,r]of Object.entries(i))e.includes(n)||(t[n]={...r,note:`until it broke off: ${r.note}`});return t}function Jy(i,t){if(!i.energy||!i.energy_balance)return{};let{energy:e,work:n}=i,r=e.shape[1],s=Math.max(e.data.reduce((l,c,u)=>Math.max(l,Math.abs(c-e.data[u%r])),0),n.data.reduce((l,c)=>Math.max(l,Math.abs(c)),0)),o=Math.abs(i.energy_balance.data[za(i.energy_balance.data.subarray(0,t))]),a=s?`worst residual, ${Gn(o,"J")}, over ${Gn(s,"J")} moved`:"nothing moved";return{"energy.residual":{value:s?o/s:null,note:a}}}var M1=8,Ld=1e-5,S1=Math.SQRT1_2,A1=1e-9;function Qy(i,t,e,n){let r=Object.entries(i).flatMap(([a,l])=>l.filter(c=>c.frequency>0).slice(0,M1).map(c=>[a,c])),s=T1(r,e,n),o=t.flatMap(a=>a.rings&&a.damping<S1?[{at:a.rings,label:a.element}]:[]);return{vibration:{modes:s,marks:o.sort((a,l)=>a.at-l.at)},facts:E1(i)}}function E1({controlled:i,locked:t}){if(!i)return{};let e=o=>o.reduce((a,{rings:l,frequency:c})=>l&&c<(a??1/0)?c:a,null),[n,r]=[e(i),e(t??[])],s=n===null?"no vibration under control":r===null?"":`${Mi(r,4)} Hz with the motors locked`;return{"frequency.first":{value:n,note:s}}}function T1(i,t,e){let n=t.length,r=new Float64Array((1+4*i.length)*n);r.set(t),i.forEach(([,{re:u,im:h}],f)=>{let d=u.reduce((m,y,g)=>Math.max(m,Math.hypot(y,h[g])),0);for(let m=0;m<n;m+=1){let[y,g]=[Ld*u[m]/d,Ld*h[m]/d];[y,g,-y,-g].forEach((p,x)=>{r[(1+4*f+x)*n+m]=t[m]+p})}});let{data:s,shape:o}=e(r,1+4*i.length),a=s.length/(1+4*i.length),l=u=>Float64Array.from({length:a},(h,f)=>(s[u*a+f]-s[(u+2)*a+f])/(2*Ld)),c=u=>({data:Float32Array.from(u),shape:o.slice(1)});return i.map(([u,h],f)=>{let[d,m]=R1(l(1+4*f),l(2+4*f));return{case:u,frequency:h.frequency,damping:h.damping,element:h.element,rest:c(s.subarray(0,a)),real:c(d),imaginary:c(m)}})}function R1(i,t){let[e,n]=[0,0];for(let c=0;c<i.length;c+=3){let u=Math.hypot(...i.subarray(c,c+3),...t.subarray(c,c+3));u>n&&([e,n]=[c,u])}if(!n)return[i,t];let r=[0,1,2].map(c=>Math.hypot(i[e+c],t[e+c])),s=e+r.indexOf(Math.max(...r)),o=Math.hypot(i[s],t[s])*n,[a,l]=[i[s]/o,-t[s]/o];return[i.map((c,u)=>a*c-l*t[u]),i.map((c,u)=>l*c+a*t[u])]}function tx(i,t){let[e,n]=[i.values.re[t],i.values.im[t]],r=Math.hypot(e,n);return{size:r,rings:n>A1*r?n/(2*Math.PI):null,damping:r?-e/r:0}}function ex(i,t,e,n,r){let s=o=>Float64Array.from({length:e},(a,l)=>{let c=0;for(let u=0;u<n;u+=1)c+=r(l,u)*o[u*i.count+t];return c});return{re:s(i.shapes.re),im:s(i.shapes.im)}}function nx(i,t,e,n){let{count:r,shapes:s}=t,o=g=>p=>{if(!n)return g(p);let x=0;for(let b=0;b<e;b+=1)x+=n[p*e+b]*g(b);return x},a=(g,p)=>{let x=0;for(let b=0;b<e;b+=1)x+=g(b)*p(b);return x},l=Fd(i.shapes,e,e),[c,u]=[Fd(s.re,e,r),Fd(s.im,e,r)],h=l.map(g=>Float64Array.from({length:e},(p,x)=>o(b=>g[b])(x))),f=g=>a(p=>g[p],o(p=>g[p])),[d,m]=[l.map(g=>Math.sqrt(f(g))),c.map((g,p)=>Math.sqrt(f(g)+f(u[p])))],y=new Float64Array(e*r);for(let g=0;g<e;g+=1)for(let p=0;p<r;p+=1){let[x,b]=[c,u].map(v=>a(S=>h[g][S],S=>v[p][S]));y[g*r+p]=Math.hypot(x,b)/(d[g]*m[p])}return y}function Fd(i,t,e){return Array.from({length:e},(n,r)=>Float64Array.from({length:t},(s,o)=>i[o*e+r]))}function C1({values:i,count:t}){let e=Array.from({length:t},(n,r)=>Math.hypot(i.re[r],i.im[r]));return{rings:e.map((n,r)=>i.im[r]>1e-9*n),stands:e.map((n,r)=>Math.abs(i.im[r])<=1e-9*n)}}function ix(i,t,e){let{count:n,values:r}=t,{rings:s,stands:o}=C1(t),a=new Float64Array(n);Array.from({length:n},(c,u)=>u).sort((c,u)=>r.re[u]-r.re[c]).forEach((c,u)=>{a[c]=u});let l=Float64Array.from(i,(c,u)=>{let h=u%n;return!s[h]&&!o[h]?100:a[h]/(10*n)-c*c-(s[h]?10:0)});return P1(l,e,n)}function P1(i,t,e){let[n,r]=[new Float64Array(t+1),new Float64Array(e+1)],s=new Int32Array(e+1);for(let a=1;a<=t;a+=1){let l=new Float64Array(e+1).fill(1/0),c=new Int32Array(e+1),u=new Uint8Array(e+1);s[0]=a;let h=0;for(;s[h];){u[h]=1;let[f,d]=[1/0,0];for(let m=1;m<=e;m+=1){if(u[m])continue;let y=i[(s[h]-1)*e+m-1]-n[s[h]]-r[m];y<l[m]&&(l[m]=y,c[m]=h),l[m]<f&&(f=l[m],d=m)}for(let m=0;m<=e;m+=1)u[m]?(n[s[m]]+=f,r[m]-=f):l[m]-=f;h=d}for(;h;h=c[h])s[h]=s[c[h]]}let o=new Array(t).fill(-1);for(let a=1;a<=e;a+=1)s[a]&&(o[s[a]-1]=a-1);return o}var I1=1e-13,L1=1e-13,F1="whole arm, free",N1="whole arm, in its weight and loads";function ox(i,t,e,{blocks:n,schedule:r,info:s},o){if(!t.modes)return{vibration:t.noModes,facts:{}};try{let{rest:a,linear:l}=rx(i,t,e,r,cn(t.modes.rest)),c=Object.fromEntries(t.modes.cases.map(({name:y,moving:g})=>[y,sx(t,n,l,y,g)])),{name:u,moving:h}=t.modes.cases.find(y=>y.name==="controlled"&&y.moving.length)??t.modes.cases.find(y=>y.name==="locked"),f=D1(t,s,r,o),d=f&&rx(i,t,e,r,f,o.times[o.times.length-1]).linear,m=d?sx(t,n,d,u,h):[];return Qy(c,m,a,(y,g)=>Ic(i,t,n,y,g).line)}catch(a){return{vibration:a instanceof Error?a.message:String(a),facts:{}}}}function rx(i,t,e,n,r,s=0){let o=null;return _d(t,e,"real",r,(a,l)=>(o=yy(i,t,Io(t.map,a,"real"),n,l,s),o&&o.rest)),o}function D1(i,t,e,n){if(!i.modes.end)return null;let r=cn(i.modes.end).slice(),[s,o]=[n.times[n.times.length-1],n.series.q.data.subarray(-r.length)],a=new Map(t.commanded);for(let l=0;l<r.length;l+=1){let c=a.get(l);i.modes.free.includes(l)||(r[l]=c===void 0?o[l]:rs(e,c,s))}return r}function sx(i,t,e,n,r){let s=Math.sqrt(e.mass.length),o=r.length;if(!o)return[];let a=g=>Float64Array.from({length:o*o},(p,x)=>g[r[Math.floor(x/o)]*s+r[x%o]]),[l,c,u]=[a(e.mass),a(e.damping),a(e.stiffness)],h=n==="controlled";h&&i.modes.servos.forEach(({coordinate:g},p)=>{let x=r.indexOf(g)*(o+1);u[x]+=t.servos[2*p],c[x]+=t.servos[2*p+1]});let f=Xy(l,u,o),d=jy(l,c,u,o,f),m=ix(nx(f,d,o,l),d,o),y=L1*o*f.squares.reduce((g,p)=>Math.max(g,Math.abs(p)),0);return Array.from({length:o},(g,p)=>{let x=new Float64Array(s);r.forEach((U,z)=>{x[U]=f.shapes[z*o+p]});let b=O1(i,t,e.elastic,x,h),v=ex(d,m[p],s,o,(U,z)=>r[z]===U?1:0),S=f.squares[p],A=b.reduce((U,{energy:z})=>U+z,0);if(Math.abs(S)<=y&&A<=y)return{frequency:0,rings:null,damping:0,element:F1,...v};let{size:_,rings:w,damping:N}=tx(d,m[p]),P=(h&&w?_:Math.sqrt(Math.max(S,0)))/(2*Math.PI),I=b.reduce((U,z)=>z.energy>U.energy?z:U,b[0]);return{frequency:P,rings:w,damping:Math.abs(N)>I1?N:0,element:A>y&&I?I.element:N1,...v}})}function O1(i,t,e,n,r){let s=n.length,o=u=>{let h=0;for(let f=0;f<s;f+=1)h+=e[u*s+f]*n[f];return h},{springs:a,servos:l}=i.modes,c=a.map(({element:u,rows:h,gear:f})=>{if(!f)return{element:u,energy:h.reduce((m,y)=>m+n[y]*o(y),0)};let d=e[h[0]*(s+1)];return{element:u,energy:d?o(h[0])**2/d:0}});return r?[...c,...l.map(({coordinate:u,element:h},f)=>({element:h,energy:t.servos[2*f]*n[u]**2}))]:c}var ax=1e-6,U1=1e-11,lx=.5,Nd=40,k1=.1,cx=24;async function ux(i,t,e,n,r,s,o){let{free:a,gross:l}=t.split;if(!a.length)return{};let c=r.length,u=s.q.shape[1],h=p=>mr({matrix:l,constant:{data:new Float64Array(u),shape:[u]}},s[p].data,c),f=Ac(t,e,n,r,s),d={engine:i,blocks:e,free:a,size:u,places:f.length/c,weight:cn(t.split.weight),q:s.q.data.slice(),rates:h("v"),gains:h("a"),wrenches:f},m=s.deformation.data,y=null;for(let p=0;p<c;p+=cx){let x=Array.from({length:Math.min(cx,c-p)},(b,v)=>p+v);if(p&&B1(d,m,mr(t.deflections,d.q.subarray((p-1)*u,p*u),1),x),y=z1(d,s.q.data,x,y),!y)return{};await o()}let g=mr(t.deflections,d.q,c);return{deformation_stationary:we(g,c,a.length),deformation_oscillatory:we(ss(m,g),c,a.length)}}function B1(i,t,e,n){let r=i.free.length;for(let s of n)i.free.forEach((o,a)=>{i.q[s*i.size+o]+=e[a]-t[s*r+a]})}function Ud(i,t,e){let{engine:n,blocks:r,free:s,size:o}=i,a={q:t,v:Yi(i.rates,o,e),a:Yi(i.gains,o,e),base:i.weight,wrenches:Yi(i.wrenches,i.places,e)},l=Pc(n,r,a,e.length),c=n.sample("elastic",r.chain,a,e.length).forces;return Float64Array.from({length:e.length*s.length},(u,h)=>{let f=Math.floor(h/s.length)*o+s[h%s.length];return l[f]+c[f]})}function Od(i,t,e){let{free:n,size:r}=i,s=n.length,o=new Float64Array((s+1)*r);for(let l=0;l<=s;l+=1)o.set(t,l*r);n.forEach((l,c)=>{o[c*r+l]+=ax});let a=Ud(i,o,new Array(s+1).fill(e));return hy(Float64Array.from({length:s*s},(l,c)=>(a[c%s*s+Math.floor(c/s)]-a[s*s+Math.floor(c/s)])/ax),s)}function z1(i,t,e,n){let r=l=>i.q.subarray(l*i.size,(l+1)*i.size),s=l=>Od(i,r(l[l.length>>1]),l[l.length>>1]),o=n??s(e);if(!o)return null;let a=Dd(i,e,o,Nd);a.length&&(o=s(a)??o),a=Dd(i,a,o,Nd);for(let l of a){let[c,u]=[Nd,[l]];for(;u.length&&c;c-=1){let h=Od(i,r(l),l);u=h?Dd(i,u,h,3):u}u.length&&V1(i,t,l)}return o}function Dd(i,t,e,n){let{free:r,size:s,q:o}=i,a=r.length,l=[],c=new Map,u=t;for(let h=0;h<n&&u.length;h+=1){let f=Ud(i,Yi(o,s,u),u);u=u.filter((d,m)=>{let y=si(e,f.subarray(m*a,(m+1)*a),a,a,1),g=y.reduce((b,v)=>Math.max(b,Math.abs(v)),0),p=g>lx?lx/g:1;if(!Number.isFinite(g))return l.push(d)&&!1;if(r.forEach((b,v)=>{o[d*s+b]-=p*y[v]}),g<U1)return!1;let x=g>k1*(c.get(d)??1/0);return c.set(d,g),x?l.push(d)&&!1:!0})}return[...l,...u]}function V1(i,t,e){let n=t.slice(e*i.size,(e+1)*i.size),r=Od(i,n,e);if(i.q.set(n,e*i.size),!r)return;let s=i.free.length,o=si(r,Ud(i,n,[e]),s,s,1);i.free.forEach((a,l)=>{i.q[e*i.size+a]-=o[l]})}var G1=50;async function hx(i,t,e,n,r,s){let o=performance.now(),a=async(h=!1)=>{if(!(!h&&performance.now()-o<G1)){if(await new Promise(f=>setTimeout(f,0)),s.cancelled?.())throw new Us("a newer run began");o=performance.now()}};await a(!0);let{vibration:l,facts:c}=ox(i,t,e,r,n);await a(!0);let u=await ux(i,t,r.blocks,r.schedule,n.times,n.series,a);return{...n,vibration:l,facts:{...n.facts,...c},series:{...n.series,...u}}}var H1=1e-12;function px(i,t,[e,n],[r,s],o){if(!t.errorParts||!r)return{};let a=(s??r).model.q.slice(),l=a.length/o;for(let[g,p]of[...e.info.commanded,...e.info.exact])for(let x=0;x<o;x+=1)a[x*l+g]=rs(e.schedule,p,e.run.times[x]);let c=dx(i,t,e,r,a,o),u=s?dx(i,t,n,s,a,o):c,h=fx(c),f=ss(c[0],u[0]),d=fx(u);(t.errorParts.length>h.length||f.subarray(0,3).some(g=>Math.abs(g)>H1))&&(h.push(f),d.push(new Float64Array(f.length)));let m=g=>{let p=new Float64Array(3*o*g.length);return g.forEach((x,b)=>x.forEach((v,S)=>{p[3*(Math.floor(S/3)*g.length+b)+S%3]=v})),we(p,o,g.length,3)},y={tip_commanded:we(u[0],o,3),tip_error:m(h)};return s&&(y.tip_error_nominal=m(h.map((g,p)=>ss(g,d[p])))),y}function fx(i){return i.slice(1).map((t,e)=>ss(t,i[e]))}function dx(i,t,e,{model:{q:n},points:r},s,o){let a=n.length/o,[l,c]=[s.slice(),n.slice()];for(let g=0;g<n.length;g+=a){for(let p of e.info.driven)l[g+p]=n[g+p];for(let p of t.bends)c[g+p]=0}let u=g=>Sn(g,g.length/o,[9,10,11]),h=new Float64Array(a),[f,d]=[n,u(r)],m=[d],y=g=>mr(t.straight,g,o);for(let g of[c,y(l),y(s)]){if(!g.every((p,x)=>p===f[x])){let p={q:g,v:h,a:h,base:cn(t.base)};d=u(i.sample("inertia",e.blocks.chain,p,o).points)}f=g,m.unshift(d)}return m}function gx(i,t,e,n){let s={...Zy(t,e,n,i.errorParts??[]),...Jy(e,t.length)},o=i.deformations.flatMap((d,m)=>d.endsWith(".gear")?[m]:[]),a=o.filter(d=>i.turning.includes(i.deformations[d].replace(/\.gear$/,""))),l=a.length?a:o;if(l.length){let d=Sn(e.deformation.data,i.deformations.length,l),m=l.length<o.length?" (of the gears that turn)":"",{value:y,note:g}=mx(t,d,l.map(p=>i.deformations[p].replace(/\.gear$/,"")));s["gear.max"]={value:y,note:`${g}${m}`}}let{drives:c}=i.layout,u=hi(0,c.length),h=u.filter(d=>i.turning.includes(c[d]));for(let[d,m]of[["gear_torque",h.length?h:u],["voltage",u]]){if(!e[d])continue;let y=mx(t,Sn(e[d].data,c.length,m),m.map(g=>c[g]));y.value&&(s[`${d}.max`]=y)}let f=e.contact_force_normal?.data;if(f){let[d,m]=[f.reduce((y,g)=>Math.min(y,g)),f.reduce((y,g)=>Math.max(y,g))];s["contact.mean"]={value:Id(t,f),note:`from ${Mi(d,4)} to ${Mi(m,4)} N`}}return s}function mx(i,t,e){let n=za(t),r=`${e[n%e.length]}, at ${Mi(i[Math.floor(n/e.length)])} s`;return{value:Math.abs(t[n]),note:r,time:i[Math.floor(n/e.length)]}}function yx(i,{strengths:t,places:e,kept:n},r){let s=[i.every>1?`one sample in ${i.every}`:"",n>e.data.length?`${e.data.length} places along each link`:""],o=s.some(Boolean)?` (looked at: ${s.filter(Boolean).join(", ")})`:"",a=f=>i.links.flatMap(({largest:d})=>d[f]??[]),l=(f,d)=>{let m=kd(d,({value:p})=>p),y=m&&f!=="deflection.max"?` at s = ${Mi(m.s,2)}`:"",g=m?r[m.sample]:0;return m?{[f]:{value:m.value,note:`${m.link}${y}, at ${Mi(g)} s${o}`,time:g}}:{}},c=kd(a("stress").filter(({link:f})=>f in t),({link:f,value:d})=>d/t[f]),u=c?t[c.link]:1,h=c&&`of ${Gn(u,"Pa")}, ${c.link}; margin ${Mi(100*(1-c.value/u))} %${o}`;return{...l("deflection.max",a("deflection")),...l("moment.max",a("moment")),...l("stress.max",a("stress")),...c&&h?{"stress.share":{value:100*c.value/u,note:h}}:{}}}function xx(i,t){let e=kd(i.flatMap(n=>W1(n,t)),({share:n})=>n);return e?{"limits.share":{value:100*e.share,note:e.note}}:{}}function W1({joint:i,coordinate:t,drive:e,unit:n,effortUnit:r,speed:s,effort:o,range:a},l){let c=(h,f,d=0)=>Sn(l[h].data,l[h].shape[1],[f]).reduce((m,y)=>Math.max(m,Math.abs(y-d)),0),u=(h,f,d,m)=>({share:h/f,note:`${d} of ${i}: ${Gn(h,m)} of ${Gn(f,m)}`});return[...s?[u(c("v",t),s,"speed",`${n}/s`)]:[],...o&&e>=0?[u(c("effort",e),o,"effort",r)]:[],...a?[{share:c("q",t,a[0])/a[1],note:`range of ${i}, from its middle`}]:[]]}function kd(i,t){return i.reduce((e,n)=>e===null||t(n)>t(e)?n:e,null)}var Oc=["y","z"],q1=[{id:"deflection",of:"deflection",label:"Deflection",unit:"m",planes:Oc},{id:"slope",of:"slope",label:"Slope",unit:"rad",planes:Oc},{id:"moment",of:"moment",label:"Moment",unit:"N m",planes:["torsion",...Oc]},{id:"shear_force",of:"shear",label:"Shear force",unit:"N",planes:Oc}];function vx(i,t,e){if(!t.length)return null;let n=i.stations.data,[r,s]=[t.length,n.length],o=Float64Array.from({length:r*s},(a,l)=>t[Math.floor(l/s)].length*n[l%s]);return{links:t.map(a=>a.name),places:{data:o,shape:[r,s]},quantities:q1.map(({id:a,of:l,label:c,unit:u,planes:h})=>{let f=new Float64Array(e*r*s*h.length);return t.forEach((d,m)=>bx(d[l],f,e,m,r,s*h.length)),{id:a,label:c,unit:u,planes:[...h],values:{data:f,shape:[e,r,s,h.length]}}})}}function _x(i,t,e){let[n,r]=[i.links.length,i.stations.data.length],s=(l,c,u,h)=>{let f=new Float64Array(e*n*r);return i.links.forEach((d,m)=>{let y=d.bends?t.find(p=>p.name===d.name):void 0,g=y&&h(y);g&&bx(g,f,e,m,n,r)}),{id:l,label:c,unit:u,values:{data:f,shape:[e,n,r]}}};if(!t.length)return[];let a=[s("bending_moment","Bending moment","N m",({moment:l})=>Float64Array.from({length:e*r},(c,u)=>Math.sqrt(l[3*u+1]**2+l[3*u+2]**2))),s("torsion","Torsional moment","N m",({moment:l})=>Float64Array.from({length:e*r},(c,u)=>Math.abs(l[3*u]))),s("deflection","Deflection from the root's tangent","m",({deflection:l})=>Lo(l,2))];return t.some(l=>l.stress)?[...a,s("stress","Largest stress (von Mises)","Pa",({stress:l})=>l&&l.mises),s("strain","Largest strain","1",({stress:l})=>l&&l.strain)]:a}function bx(i,t,e,n,r,s){for(let o=0;o<e;o+=1)t.set(i.subarray(o*s,(o+1)*s),(o*r+n)*s)}var $1=100;function X1(i,t,e,n,r){let s=new Float64Array(1),o={time:s,row:Sc(n,s),step:new Float64Array(1)};for(let a=0;`${t}.switched`in i.layout.samples&&a<$1;a+=1){let l=r;if(r=i.sample(`${t}.switched`,e.parameters,{...o,state:r},1).state,r.every((c,u)=>c===l[u]))break}return r}async function wx(i,t,e,n,r,s){let{settings:o}=t,a=t.runs[n],l=hi(0,a.signals).map(h=>fd(r[`knots.${h}`],r[`coefficients.${h}`])),c=sy(l.map(h=>dd(h,o.duration)));l.length||(c.knots[1]=o.duration);let u=await ty(i,{loop:`${n}.${o.method}`,parameters:r.parameters,knots:c.knots,rows:iy(c),state:X1(i,n,r,c,gy(i,t,e,n,c)),times:cn(t.times),settings:o},s);return{name:n,info:a,blocks:r,each:l,schedule:c,run:u}}var gr=24;function Mx(i,t,e,n){let r=e.run.times.subarray(0,n),s=e.run.states.subarray(0,n*(e.run.states.length/e.run.times.length)),o=Sc(e.schedule,r),a={time:r,state:s,row:o,step:new Float64Array(1)},l=i.sample(`${e.name}.observe`,e.blocks.parameters,a,n),{q:c,v:u,a:h}=l,f=cn(t.base),{chain:d,rotors:m}=e.blocks,{points:y}=i.sample("inertia",d,{q:c,v:u,a:h,base:f},n),g=new Float64Array(m.length),p=i.sample("inertia",d,{q:c,v:g,a:u,base:f},n),x=i.sample("elastic",d,{q:c,v:u,base:f},n).energies;return{model:l,points:y,energy:j1(t,u,m,p,x,n)}}function j1(i,t,e,n,r,s){let o=e.length,a=r.length/s,l=new Float64Array(4*s);for(let c=0;c<s;c+=1){for(let u=0;u<o;u+=1){let h=t[c*o+u];l[4*c]+=(n.forces[c*o+u]+e[u]*h)*h/2}for(let u=0;u<3;u+=1)l[4*c+1]-=n.moment[3*c+u]*i.gravity.data[u];for(let u=0;u<a;u+=1)l[4*c+2+u%2]+=r[c*a+u]}return l}function Sx(i,t,{model:e,points:n,energy:r},s){let o=e.q.length/s,a=e.gear.length/s,l=n.length/s/gr,c=t.run.states.length/t.run.times.length,u=Sn(t.run.states.subarray(0,s*c),c,hi(...t.info.state.works)),h=p=>we(Sn(e.drives,4*a,hi(0,a).map(x=>4*x+p)),s,a),f=p=>Sn(n,l*gr,hi(0,l).flatMap(x=>hi(0,3).map(b=>x*gr+p+b))),d=Sn(n,l*gr,hi(0,l).flatMap(p=>hi(p*gr,p*gr+9))),m={q:we(e.q,s,o),v:we(e.v,s,o),a:we(e.a,s,o),deformation:we(mr(i.deflections,e.q,s),s,i.deformations.length),position:we(f(9),s,l,3),velocity:we(f(12),s,l,3),acceleration:we(f(18),s,l,3),rotation:we(d,s,l,3,3),tip:we(Sn(n,l*gr,[9,10,11]),s,3),tip_velocity:we(Sn(n,l*gr,[12,13,14]),s,3),energy:we(r,s,4),work:we(u,s,u.length/s),energy_balance:we(xy(r,u,s,3),s)};a&&Object.assign(m,{wanted:h(3),effort:h(0),gear_torque:we(e.gear,s,a)}),a&&i.electric&&Object.assign(m,{voltage:h(1),current:h(2)});let y=hi(...t.info.state.controls);if(y.length){let p=Sn(t.run.states.subarray(0,s*c),c,y);m.controller_states=we(p,s,y.length)}if(i.contactPoint<0)return m;let g=p=>Sn(e.contact,6,p);return{...m,contact_force:we(g([0,1,2]),s,3),contact_force_normal:we(g([3]),s),penetration:we(g([4]),s)}}function Ax(i,t,e,n){let r=e.model.q.length/n,s=e.points.length/n/gr,[o,a]=[t,e].map(({points:c})=>Sn(c,s*gr,[9,10,11])),l={q_nominal:we(e.model.q,n,r),v_nominal:we(e.model.v,n,r),deformation_nominal:we(mr(i.deflections,e.model.q,n),n,i.deformations.length),gear_torque_nominal:we(e.model.gear,n,e.model.gear.length/n),tip_nominal:we(a,n,3),deviation:we(Lo(ss(o,a),3),n)};return i.contactPoint>=0&&(l.contact_force_normal_nominal=we(Sn(e.model.contact,6,[3]),n)),l}var Ex=32,Y1=1e-6;function Tx(i,t){let{wanted:e}=t;return e?i.setpoints.map(n=>Sn(e.data,e.shape[1],[n])):[]}function Rx(i,t,e){let n=i.length-(Z1(i)?1:0),r=i[i.length-1],s=t===null?-1:i.findIndex(l=>l>=t*(1+1e-9));if(s>=0&&n-s>=Ex)return[i[s],r];let[o,a]=J1(K1(n,e));return a-o>=Ex?[i[o],i[a-1]]:[i[0],r]}function Z1(i){let t=i.length;return t>2&&Math.abs((i[t-1]-i[t-2])/(i[1]-i[0])-1)>1e-6}function K1(i,t){let e=new Array(Math.max(i,0)).fill(!1);if(i<3||!t.length)return e;let n=new Float64Array(i);for(let s of t)for(let o=1;o<i-1;o+=1)n[o]=Math.max(n[o],Math.abs(s[o+1]-2*s[o]+s[o-1]));let r=Y1*Math.max(Number.MIN_VALUE,n.reduce((s,o)=>Math.max(s,o),0));for(let s=1;s<i-1;s+=1)e[s]=n[s]<=r;return e}function J1(i){let[t,e]=[[0,0],-1];for(let n=0;n<=i.length;n+=1)n<i.length&&i[n]?e=e<0?n:e:e>=0&&(n-e>t[1]-t[0]&&(t=[e,n]),e=-1);return t}async function Cx(i,t,e,n,r,s=()=>{}){let o=performance.now(),a=t.runs.reference?["reference","real"]:["real"],l=[];for(let[P,I]of a.entries()){let U={...n,progress:O=>n.progress?.((P+O)/a.length)},z=Io(t.map,e,I),C=()=>wx(i,t,e,I,z,U);l.push(await(I==="reference"?r.of(z,C):C()))}let c=l[l.length-1];s(c);let u=(performance.now()-o)/1e3,h=Math.min(...l.map(P=>P.run.times.length)),f=[c,...l.slice(0,-1)],d=f.map(P=>Mx(i,t,P,h)),[m,y]=d,g=c.run.times.subarray(0,h),p=y?Ax(t,m,y,h):{},x=px(i,t,f,d,h),b={...Sx(t,c,m,h),...p,...x},v=dy(t,h),S=oy(c.info.moving.map(P=>c.each[P])),A=l.find(P=>P.run.status!=="finished"),_=vy(i,t,c.blocks,b,g,c.schedule,v),w={...gx(t,g,b,S),...yx(_,t.carried,g),...xx(t.carried.limits,b)},N=_x(t,_.links,v.length);return{status:A?A.run.status:"finished",message:A?`${A===c?"actual robot":"nominal run"}: ${A.run.message}`:c.run.message,seconds:u,times:g,series:b,scene:_y(i,t,c.blocks,b,g,v,N),line:vx(t,_.links,v.length),span:Rx(g,S,Tx(t,b)),facts:A?Ky(w):w}}async function Px(i){let t=await bc.open(i.module.data,i.layout),e=new Mc;return{async run(n,r,s=()=>{}){let o=null,a=await Cx(t,i,n,r,e,l=>{o=l});return s(a,[a.times,a.series,o]),hx(t,i,n,a,o,r)}}}function Ix(i,t){let e=i.map(r=>typeof r=="object"&&"parts"in r&&Q1(r.optional,t)),n=i.some((r,s)=>e[s]&&typeof r=="object"&&"optional"in r&&r.optional>=0);return i.map((r,s)=>typeof r=="string"?r:"header"in r?n?r.header:"":e[s]?r.parts.map(o=>typeof o=="string"?o:tA(o,t)).join(""):"").join("")}function Q1(i,t){return i<0||t[i]!==1}function tA(i,t){let e=t[i.slider];return eA(i.base===null?e:i.base*e)}function eA(i){let[t,e]=String(i).split("e"),n=t.includes(".")?t:`${t}.0`;return e===void 0?n:`${n}e${e}`}var Fo=class extends Error{name="Superseded"};async function Lx(i){let t=i,e=await iA(t)??await nA(t),n=r=>{if(r.length!==t.sliders.length||!r.every(Number.isFinite))throw new Error(`values: got ${r.length}; expected ${t.sliders.length} finite numbers, one of each slider`)};return{sliders:t.sliders,async run(r,s=()=>{},o=()=>{}){return n(r),e.run(r,s,o)},sheet(r){return n(r),Ix(t.sheet,r)},close:()=>e.close()}}async function nA(i){let t=await Px(i),e=0,n=Promise.resolve();return{async run(r,s,o){let a=e+=1,l=()=>a!==e,c=n.then(()=>{if(l())throw new Fo("a newer run began");return t.run(r,{cancelled:l,progress:s},o)});n=c.catch(()=>{});try{return await c}catch(u){throw u instanceof Us?new Fo(u.message):u}},close:()=>e+=1}}async function iA(i){if(typeof Worker>"u"||typeof document>"u")return null;let t=URL.createObjectURL(new Blob([J0],{type:"text/javascript"}));try{let e=new Worker(t);if(await rA(e,i))return sA(e);e.terminate()}catch{}finally{URL.revokeObjectURL(t)}return null}function rA(i,t){return new Promise(e=>{i.onmessage=({data:n})=>e(n.kind==="ready"),i.onerror=()=>e(!1),i.postMessage({kind:"open",bundle:t})})}function sA(i){let t=0,e=null,n=null,r=s=>{n?.reject(s),n=null};return i.onerror=s=>r(new Error(s.message)),i.onmessage=({data:s})=>{!("id"in s)||s.id!==t||!n||(s.kind==="progress"?n.progress(s.share):s.kind==="early"?n.early(e=s.run):s.kind==="error"?r(new Error(s.message)):s.kind==="done"&&(n.resolve(ey(e,s.run)),n=null))},{run(s,o,a){return r(new Fo("a newer run began")),t+=1,e=null,i.postMessage({kind:"run",id:t,values:s}),new Promise((l,c)=>n={resolve:l,reject:c,progress:o,early:a})},close(){r(new Fo("the live model was closed")),i.terminate()}}}function No(i){return i!==null&&i.vibration===void 0}function Uc(i){let t=0;return{begin(){t||=window.setTimeout(i,300)},end(){clearTimeout(t),t=0}}}var oA=7;function Bd(i,t,e){let n=[];i.hidden=t.runs.every(a=>a.facts.length===0),t.runs.length>1?i.append(rt("h3",{class:"offscreen",text:"Numbers"}),uA(t,n)):i.append(aA(t.runs[0].facts,n,e));let r=null,s=Uc(()=>n.forEach(a=>a(r,!0))),o=a=>{r=a,No(a)?s.begin():s.end(),n.forEach(l=>l(a,!1))};return o(null),{show:o}}function aA(i,t,e){let n=[...i].sort((o,a)=>+(o.value===null)-+(a.value===null)),r=rt("dl",{class:"facts"},...n.map((o,a)=>lA(o,a>=oA,t,e))),s=Be("all, with notes",()=>{s.setAttribute("aria-pressed",String(r.classList.toggle("all")))},{class:"tool","aria-pressed":"false"});return rt("div",{},rt("div",{class:"bar"},rt("h3",{text:"Numbers"}),s),r)}function lA(i,t,e,n){let r=rt("strong"),s=rt("span",{class:"was"}),o=rt("dd",{class:"note"}),a=!1,l=null,c=rt("button",{type:"button",class:"jump"});c.addEventListener("click",()=>l!==null&&n.seek(l));let u=rt("dd",{},r,s);e.push((f,d)=>{let m=f?.facts[i.id];if(!m&&No(f)){d&&ze(s,a?"of the setting before":"of the original run"),d&&(s.hidden=!1);return}a=m!==void 0;let y=m?`${cA(i,m.value)} was ${Gn(i.value,i.unit)}`:"of the original run";ze(r,Gn(m?m.value:i.value,i.unit)),ze(s,f?y:""),ze(o,[(m??i).note,(m??i).more].filter(Boolean).join("; ")),s.hidden=f===null||m!==void 0&&m.value===null&&i.value===null,o.hidden=o.textContent==="",h.title=o.textContent??"",l=(m?m.time:i.time)??null,l===null?c.replaceWith(r):c.contains(r)||(r.replaceWith(c),c.append(r)),c.title=l===null?"":`go to t = ${Pe(l)} s`});let h=rt("div",{"data-fact":i.id,class:t?"rest":void 0},rt("dt",{text:i.name}),u,o);return h}function cA(i,t){if(t===null||i.value===null||i.value===0)return"";let e=100*(t-i.value)/Math.abs(i.value);if(Math.abs(e)<.05)return"";let n=Math.abs(e)>=1e3?"1000 % and more":`${Number(Math.abs(e).toPrecision(2))} %`;return`${e>0?"+":"−"}${n},`}function uA(i,t){let e=new Map;for(let o of i.runs.flatMap(a=>a.facts))e.has(o.id)||e.set(o.id,o);let n=rt("tr",{},rt("td",{}),...i.runs.map(o=>rt("th",{scope:"col",text:o.name}))),r=[...e.values()].map(o=>rt("tr",{"data-fact":o.id},rt("th",{scope:"row",text:o.name}),...i.runs.map((a,l)=>{let c=rt("td",{class:"number"}),u=a.facts.find(h=>h.id===o.id);return t.push(h=>{let f=l===0?h?.facts[o.id]:void 0;l===0&&!f&&No(h)||(ze(c,Gn(f?f.value:u?.value??null,u?.unit??o.unit)),c.title=(f??u)?.note??"")}),c}))),s=rt("table",{},rt("thead",{},n),rt("tbody",{},...r));return rt("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Numbers of the runs"},s)}var Nx=150,Fx="12px system-ui, sans-serif";function Dx(i,t,e){let n=t.runs[0].line,r=t.runs[0].scene.times.data,s=[],o=!1,a=!1,l="",c=rt("div",{class:"line-grid"}),u=rt("p",{class:"note"});i.append(u,c);let h=vc(()=>a?f():m(!0));function f(){a=!1;let v=n===null?"":hA(n);v===l?s.forEach((S,A)=>S.take(n.quantities[A])):d(),l=v,m()}function d(){s.forEach(({plot:v})=>v.destroy()),c.replaceChildren(),s=n===null?[]:n.quantities.map(v=>pA(c,n,v))}function m(v=o){if(n===null||a)return;if(!v)return h.ask();let S=dA(r,e.time);u.textContent=`${n.links.join(", ")}: along the links from root to tip, at ${Pe(r[S],4)} s. The scales are those of the whole run.`;let A=Ox(n);for(let{plot:_,quantity:w,factor:N}of s){let P=w.planes.map((I,U)=>fA(n,w.values,S,U,w.planes.length,N));_.setData([A,...P])}}let y=matchMedia("(prefers-color-scheme: dark)"),g=()=>s.forEach(({plot:v})=>v.redraw());y.addEventListener("change",g);let p=new ResizeObserver(()=>s.forEach(({plot:v})=>{let S=v.root.parentElement?.clientWidth??0;S>0&&S!==v.width&&v.setSize({width:S,height:Nx})}));p.observe(c);let x=new IntersectionObserver(v=>{o=v.some(S=>S.isIntersecting),o&&a?f():m()});x.observe(i);let b=e.subscribe(()=>m());return f(),{show(v){n=v?v.line:t.runs[0].line,r=v?v.scene.times.data:t.runs[0].scene.times.data,a=!0,o?f():h.ask()},dispose(){b(),h.end(),p.disconnect(),x.disconnect(),y.removeEventListener("change",g),s.forEach(({plot:v})=>v.destroy()),i.replaceChildren()}}}function hA(i){let{links:t,places:e,quantities:n}=i;return JSON.stringify([t,Array.from(e.data),n.map(({id:r,label:s,unit:o,planes:a})=>[r,s,o,a])])}function Ox(i){let t=i.places.shape[1],e=[],n=0;for(let r=0;r<i.links.length;r+=1){for(let s=0;s<t;s+=1)e.push(n+i.places.data[r*t+s]+(s===0&&r>0?1e-9:0));n=e[e.length-1]}return e}function fA(i,t,e,n,r,s){let o=i.links.length*i.places.shape[1],a=e*o*r;return Array.from({length:o},(l,c)=>s*t.data[a+c*r+n])}function dA(i,t){let e=0,n=i.length-1;for(;n-e>1;){let r=e+n>>1;i[r]<=t?e=r:n=r}return Math.abs(i[n]-t)<Math.abs(i[e]-t)?n:e}function pA(i,t,e){let n=[0,1],r=e.planes.map((g,p)=>Fa("real",p,!0,1)),s=rt("div",{class:"plot-area",role:"img"}),o=rt("span",{class:"unit"}),a=rt("div",{class:"legend"},...e.planes.map((g,p)=>rt("span",{class:"key"},Jl(`var(${r[p].property})`,r[p].dash),rt("span",{text:g})))),l=rt("h4",{text:e.label},o);i.append(rt("figure",{class:"chart"},rt("figcaption",{},l,a),s));let c={stroke:()=>gn("--grid"),width:1},u={stroke:()=>gn("--quiet"),font:Fx,grid:c,ticks:{...c,size:4}},h=Ox(t),f=t.links.slice(1).map((g,p)=>h[(p+1)*t.places.shape[1]]),m={plot:new ln({width:Math.max(s.clientWidth,120),height:Nx,legend:{show:!1},padding:[8,14,0,0],cursor:{show:!1},scales:{x:{time:!1},y:{range:()=>n}},axes:[{...u,label:"along the links [m]",labelSize:18,labelFont:Fx,size:30,values:(g,p)=>p.map(ri)},{...u,size:(g,p)=>16+7*Math.max(2,...(p??[]).map(x=>x.length)),values:(g,p)=>p.map(ri)}],series:[{},...r.map(g=>({stroke:()=>gn(g.property),dash:g.dash,width:1.6,points:{show:!1}}))],hooks:{draw:[g=>mA(g,f)]}},[h,...r.map(()=>h.map(()=>0))],s),quantity:e,factor:1,take:y};function y(g){let[p,x]=[0,0];for(let S of g.values.data)S<p&&(p=S),S>x&&(x=S);let b=Ua(g.unit,Math.max(-p,x)),v=.06*(x-p)||1;n=[(p-v)*b.factor,(x+v)*b.factor],[m.quantity,m.factor]=[g,b.factor],ze(o,` [${b.name||"–"}]`),s.setAttribute("aria-label",`${g.label} along the links, between ${ri(p*b.factor)} and ${ri(x*b.factor)} ${b.name}`)}return y(e),m}function mA(i,t){let{ctx:e,bbox:n}=i;e.save(),e.strokeStyle=gn("--quiet"),e.setLineDash([3,3]);for(let r of t){let s=i.valToPos(r,"x",!0);e.beginPath(),e.moveTo(s,n.top),e.lineTo(s,n.top+n.height),e.stroke()}e.restore()}function kx(i){let t=["Frequency [Hz]","Damping [%]","Dominant element",""].map(a=>rt(a?"th":"td",a?{scope:"col",text:a}:{})),e=rt("tbody"),n=rt("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Modes"},rt("table",{},rt("thead",{},rt("tr",{},...t)),e)),r=[],s=a=>(r[Math.min(a,r.length-1)]?.button??n).focus();function o(a){for(;r.length<a;){let u=gA(i);r.push(u),e.append(u.element)}let l=r.splice(a),c=l.some(u=>u.button===document.activeElement);for(let u of l)u.element.remove();c&&s(a)}return{element:n,tell(a,l,c){o(a.length),a.forEach((u,h)=>r[h].tell(u,l&&l[h],u===c))},focus:s}}function gA(i){let t=null,[e,n,r]=[Ux(),Ux(),rt("td")],s=Be("",()=>t&&i(t));return{element:rt("tr",{},e.element,n.element,r,rt("td",{},s)),button:s,tell(o,a,l){t=o;let c=f=>a===null?"":a?f(a):"–",u=f=>Pe(100*f.damping,3);e.tell(Pe(o.frequency),c(f=>Pe(f.frequency))),n.tell(u(o),c(u)),ze(r,o.element),ze(s,l?"stop":"show"),s.setAttribute("aria-pressed",String(l));let h=l?"Stop showing the mode":`Show the mode of ${Pe(o.frequency)} Hz in 3D`;s.setAttribute("aria-label",h)}}}function Ux(){let[i,t]=[rt("span"),rt("span",{class:"was",hidden:!0})];return{element:rt("td",{class:"number"},i,t),tell(e,n){ze(i,e),t.hidden=!n||n===e,ze(t,t.hidden?"":`was ${n}`)}}}var yA={controlled:"under control",locked:"motors held",free:"motors free"},xA=.12;function zd(i,t,e,n){let r=t.runs[0].modes,s=[...new Set(r.map(w=>w.case))],o=r,a=null,l=xA,c=kx(w=>g(w===a?null:w)),u=Lr("case"),h=rt("select",{id:u},...s.map(w=>rt("option",{value:w,text:yA[w]??w})));h.addEventListener("change",()=>v(h.value));let f=rt("input",{type:"range",min:"0.02",max:"0.3",step:"0.01",value:String(l),id:Lr("size")});f.addEventListener("input",()=>{l=Number(f.value),a&&e.showMode(a,l)});let d=Be("back to the motion",()=>{let w=b(a);g(null),c.focus(w)},{hidden:!0}),m=rt("p",{class:"note",hidden:!0,role:"status"}),y=Uc(()=>{S(`These are the modes of the ${o===r?"run as it was":"setting before"}; the new ones are being found.`)});function g(w){w&&n.pause(),p(w)}function p(w){a=w,e.showMode(w,l),d.hidden=w===null,v(h.value)}let x=(w,N)=>w.filter(P=>P.case===N),b=w=>w?x(o,w.case).indexOf(w):-1;function v(w){c.tell(x(o,w),o===r?null:x(r,w),a)}function S(w){ze(m,w),m.hidden=!w}let A=rt("div",{class:"bar"},rt("label",{for:u,text:"Modes"}),h,rt("label",{for:f.id,text:"amplitude"}),f,d);i.append(A,m,c.element),v(s[0]??"");let _=n.subscribe(w=>{w.playing&&a&&g(null)});return{show(w){if(No(w))return y.begin();y.end();let N=w?.vibration,P=b(a);o=typeof N=="object"?N.modes:r,S(N===void 0?"":vA(N));let I=a&&(x(o,a.case)[P]??null);a&&I!==a?p(I):v(h.value)},dispose(){_(),y.end(),i.replaceChildren()}}}function vA(i){return typeof i=="string"?`These are the modes of the run as it was: ${i}.`:"About the rest with the changed numbers; under each number what it was."}var Vd=i=>String(Number(i.toPrecision(6)));function Bx(i,t,e){let{pose:n,factor:r}=t.view,s=new URLSearchParams({t:Vd(i.time),camera:n.map(Vd).join(" "),scale:Vd(r)});for(let[o,a]of Object.entries(e?.changed()??{}))s.append("set",`${o}=${a}`);return`#${s.toString()}`}function zx(i,t,e,n){let r=new URLSearchParams(i.replace(/^#/,"")),s=c=>Number.parseFloat(r.get(c)??"");if(!Number.isFinite(s("t")))return;let o=s("scale"),a=(r.get("camera")??"").split(" ").map(Number);e.view={pose:a,factor:Number.isFinite(o)?o:e.view.factor};let l=r.getAll("set").map(c=>[c.slice(0,c.lastIndexOf("=")),Number(c.slice(c.lastIndexOf("=")+1))]).filter(([,c])=>Number.isFinite(c));n&&l.length&&n.give(Object.fromEntries(l)),t.pause(),t.seek(s("t"))}function Vx(i,t){for(let e of t.runs){if(!e.sheet)continue;let n=t.runs.length>1?`Save the YAML of ${e.name}`:"Save the YAML of this run";i.append(Be(n,()=>Fr(e.sheet,`${Gd(e.name)}.yaml`,"application/yaml"),{class:"save-yaml"}))}}function Gx(i,t,e,n){let r=Be("Copy a link to this view",()=>{location.replace(n()),(navigator.clipboard?.writeText(location.href)??Promise.reject(new Error("no clipboard"))).then(()=>ze(r,"Link copied"),()=>ze(r,"The link is in the address bar"))},{class:"copy-link"}),s=Be("Record the run (WebM)",()=>bA(i,t,e,s),{hidden:typeof MediaRecorder>"u"}),o=rt("details",{class:"save-menu"},rt("summary",{text:"Save"}),rt("div",{class:"scene-more"},Be("Save the picture (PNG)",()=>Ql(t.picture(),i)),s,r));return o.addEventListener("keydown",a=>{a.key==="Escape"&&(o.open=!1,o.querySelector("summary")?.focus())}),o}var _A=30;function bA(i,t,e,n){if(n.getAttribute("aria-pressed")==="true")return e.pause();let r=n.textContent??"",s=t.picture(),o=new MediaRecorder(s.captureStream(_A),{mimeType:"video/webm"}),a=[],{loop:l}=e;o.ondataavailable=({data:u})=>a.push(u),o.onstop=()=>Fr(new Blob(a),`${i}.webm`,"video/webm"),o.start(),e.pause(),e.loop=!1,e.seek(0),e.play(),n.setAttribute("aria-pressed","true"),ze(n,"Stop recording");let c=e.subscribe(()=>{t.picture(s),!e.playing&&(c(),e.loop=l,n.setAttribute("aria-pressed","false"),ze(n,r),o.stop())})}function Gd(i){return i.replace(/[^\p{L}\p{N}._-]+/gu,"_").replace(/^[._]+/,"").slice(0,80)||"run"}var wA=["tip_error.commanded","deviation.max","deflection.max","gear.max"];function Wx(i,t){let e=[...new Set(i.map(r=>r.slider.group))],n=new Map(i.map(r=>{let{group:s}=r.slider,o=i.filter(a=>a.slider.group===s);return[r,o.indexOf(r)*e.length+e.indexOf(s)]}));return[...i].sort((r,s)=>(n.get(r)??0)-(n.get(s)??0)).slice(0,t)}async function qx(i,t,e){let n=t.map(c=>c.slider.value),r=performance.now(),s=await Hx(i,n),o=wA.find(c=>s[c]?.value);if(!o)return"no number of this run tells it";let a=Number(s[o].value);if((performance.now()-r)*t.length>6e3)return"to measure it would take long";let l=[];for(let[c,{slider:u}]of t.entries()){if(!e())return null;let h=u.value*(1+.01),f=h<=u.max&&h>=u.min?.01:-.01,d=n.map((y,g)=>g===c?y*(1+f):y),m=u.value===0?a:(await Hx(i,d))[o]?.value??a;l.push(Math.abs(m-a)/Math.abs(a))}return{number:o,shares:l}}async function Hx(i,t){return new Promise((e,n)=>{i.run(t,void 0,r=>e(r.facts)).then(r=>e(r.facts),n)})}function $x(i,t){return(t.find(e=>e.id===i)?.name??i).toLowerCase()}var Hd=1e3;function Xx(i,t){let e=Lr("slider"),n=sd(i.unit),r=rt("input",{type:"range",id:e,min:"0",max:String(Hd),step:"1"}),s=rt("input",{type:"number","aria-label":`${i.label}${n?`, in ${n}`:""}`,step:"any",min:String(i.min),max:String(i.max)}),o=Be("↺",h,{class:"tool","aria-label":`${i.label}: back to ${Pe(i.value,6)} ${n}`,title:"back to the run's own"}),a=rt("span",{class:"effect"}),l=i.value;function c(m=!1){r.value=String(Math.round(Hd*MA(i,l))),r.setAttribute("aria-valuetext",`${Pe(l,5)} ${n}`),m||(s.value=String(Number(l.toPrecision(6)))),o.disabled=l===i.value,d.classList.toggle("changed",l!==i.value)}function u(m,y=!1){let g=Math.min(Math.max(m,i.min),i.max);if(g===l)return c(y);l=g,c(y),t()}function h(){u(i.value),r.focus()}r.addEventListener("input",()=>u(Number(Pe(SA(i,Number(r.value)/Hd),4)))),s.addEventListener("input",()=>{s.value!==""&&Number.isFinite(s.valueAsNumber)&&u(s.valueAsNumber,!0)}),s.addEventListener("change",()=>c());let f=rt("label",{for:e,title:i.path},rt("span",{text:i.label}),rt("i",{text:i.symbol?` ${i.symbol}`:""}),a),d=rt("div",{class:"slider","data-path":i.path},f,rt("div",{class:"slider-row"},r,s,rt("span",{class:"unit",text:n}),o),rt("code",{class:"path",text:i.path,title:"--set PATH=VALUE"}));return c(),{element:d,slider:i,effect:a,get value(){return l},set value(m){l=m,c()}}}function MA(i,t){let{min:e,max:n}=i;return n<=e?0:i.log&&e>0?Math.log(t/e)/Math.log(n/e):(t-e)/(n-e)}function SA(i,t){let{min:e,max:n}=i;return i.log&&e>0?e*(n/e)**t:e+t*(n-e)}var Wd=5,jx=300;function Yx(i,t,e){let n=rt("p",{class:"note",role:"status","aria-live":"polite",text:"starts …"}),r=rt("progress",{max:"1",value:"0",hidden:!0,"aria-label":"Progress of the simulation"}),s=Be("reset all",()=>{v(null),a[0]?.element.querySelector("input")?.focus()},{disabled:!0}),o=Be("Save YAML",()=>l&&Fr(l.sheet(g()),`${e.fileName}.yaml`,"application/yaml"),{disabled:!0}),a=t.sliders.map(C=>Xx(C,x)),l=null,c=!1,u=0,h=0,f=0,d=!1,m=0,y=!1,g=()=>a.map(C=>C.value),p=()=>a.every(C=>C.value===C.slider.value);function x(){s.disabled=p(),!d||p()?S():h||(h=requestAnimationFrame(b))}function b(){d&&!y&&performance.now()-m<jx?h=requestAnimationFrame(b):S()}function v(C){a.forEach((O,W)=>{O.value=C?C[W]:O.slider.value}),x()}async function S(){if(cancelAnimationFrame(h),h=0,!l)return;let C=u+=1;if(p()){_(),e.show(null),n.textContent="The run as it was.",n.classList.remove("warned"),l.run(g()).catch(()=>{});return}[d,m,y]=[!0,performance.now(),!1],f||(f=window.setTimeout(()=>{r.hidden=!1},jx));try{let O=W=>{C===u&&(r.value=W)};A(await l.run(g(),O,W=>A(W,C)),C)&&_()}catch(O){if(C!==u||c||O instanceof Error&&O.name==="Superseded")return;_(),e.show(null);let W=(O instanceof Error?O.message:String(O)).replace(/\.$/,"");n.textContent=`This could not be simulated: ${W}; shown is the run as it was.`,n.classList.add("warned")}}function A(C,O){if(O!==u||c)return!1;y=!0,e.show(C);let W=C.status==="finished"?"Simulated":`${C.status}: ${C.message}; simulated`;return n.textContent=`${W} in ${Gn(C.seconds,"s")}; the run as it was is pale.`,n.classList.toggle("warned",C.status!=="finished"),!0}function _(){d=!1,clearTimeout(f),f=0,r.hidden=!0,r.value=0}let w=rt("div",{class:"leading"}),N=rt("div"),P=rt("p",{class:"note",hidden:!0}),I=rt("details",{},rt("summary",{text:`All settings (${a.length})`}),P,N);I.hidden=a.length<=Wd,I.append(...EA(t));function U(C){w.replaceChildren(...C.map(O=>O.element)),N.replaceChildren(...AA(a.filter(O=>!C.includes(O))))}async function z(C){let O=await qx(C,a,()=>u===0&&!c);if(O===null||u>0||c)return;if(P.hidden=!1,typeof O=="string")return ze(P,`Ordered by kind, not by effect: ${O}.`);let{number:W,shares:G}=O;if(a.forEach(($,X)=>{$.effect.textContent=G[X]>0?`${Pe(100*G[X],2)} %`:"",$.effect.title="change for 1 % of this setting"}),ze(P,`Behind each setting: the change of the ${$x(W,e.facts)} for 1 % of it.`),i.contains(document.activeElement)||i.matches(":hover"))return;let et=$=>G[a.indexOf($)];U([...a].sort(($,X)=>et(X)-et($)).slice(0,Wd))}return U(Wx(a,Wd)),i.append(rt("div",{class:"bar"},rt("h3",{text:"What if"}),s,o),n,r,w,I),e.open(t).then(C=>{if(c)return C.close();l=C,o.disabled=!1,n.textContent="Move a slider to run the simulation again in this page.",p()?z(C).catch(()=>{}):x()},C=>{let O=C instanceof Error?C.message:String(C);n.textContent=`Nothing can be changed here, the robot's equations could not be started: ${O}`,a.forEach(W=>W.element.remove()),s.remove()}),{changed:()=>Object.fromEntries(a.filter(C=>C.value!==C.slider.value).map(C=>[C.slider.path,C.value])),give:C=>v(a.map(({slider:O})=>Math.min(Math.max(C[O.path]??O.value,O.min),O.max))),dispose(){c=!0,cancelAnimationFrame(h),_(),l?.close(),i.replaceChildren()}}}function AA(i){return[...new Set(i.map(e=>e.slider.group))].map(e=>rt("fieldset",{},rt("legend",{text:e}),...i.filter(n=>n.slider.group===e).map(n=>n.element)))}function EA(i){let t=i.settings,e=Array.isArray(i.leftOut)?i.leftOut:[];return[...typeof t?.note=="string"&&t.note?[t.note]:[],...e.length?[`Not offered: ${e.map(({path:r,reason:s})=>`${String(r)} (${String(s)})`).join("; ")}.`]:[]].map(r=>rt("p",{class:"note",text:r}))}var TA=[.05,.1,.2,.5,1,2],kc=1e3,Zx=1/200,RA=.012;function Kx(i,t){let e=[],n=Be("",()=>t.toggle(),{class:"play"}),r=rt("div",{class:"time-marks"}),s=Be("loop",()=>{t.loop=!t.loop,s.setAttribute("aria-pressed",String(t.loop))},{class:"loop","aria-pressed":"true",title:"start again at the end"}),o=rt("input",{type:"range",min:"0",max:String(kc),step:"1","aria-label":"Time",class:"scrub"}),[a,l]=[rt("span"),rt("span")],c=rt("output",{class:"time","aria-live":"off"},a,document.createTextNode(" "),l),u=Lr("speed"),h=rt("select",{id:u},...TA.map(b=>rt("option",{value:String(b),text:`${b}×`,selected:b===t.speed})));o.addEventListener("input",()=>t.seek(Number(o.value)/kc*t.duration)),h.addEventListener("change",()=>{t.speed=Number(h.value)});let f=Math.max(3,Math.ceil(-Math.log10(t.duration||1))+3),d=()=>{let b=t.duration>0?t.time/t.duration:0;(document.activeElement!==o||Number(o.value)!==Math.round(b*kc))&&(o.value=String(Math.round(b*kc))),o.setAttribute("aria-valuetext",`${t.time.toFixed(f)} s`),a.textContent=`${t.time.toFixed(f)} s`,l.textContent=`of ${Pe(t.duration)} s`;let v=t.playing?"Pause":"Play";n.getAttribute("aria-label")!==v&&(n.setAttribute("aria-label",v),n.title=`${v} (space)`,n.textContent=t.playing?"❚❚":"▶")},m=b=>{if(b.defaultPrevented||b.ctrlKey||b.metaKey||b.altKey||CA(b))return;let v={" ":()=>t.toggle(),ArrowRight:()=>t.seek(t.time+(b.shiftKey?10:1)*Zx*t.duration),ArrowLeft:()=>t.seek(t.time-(b.shiftKey?10:1)*Zx*t.duration)};(b.key==="."||b.key===",")&&(v[b.key]=()=>y(b.key==="."?1:-1));let S=v[b.key];S&&(b.preventDefault(),S())};function y(b){let v=b>0?0:e.length-1,S=t.time+b*1e-9*(t.duration||1);for(;v>=0&&v<e.length&&b*(e[v]-S)<=0;)v+=b;v>=0&&v<e.length&&t.seek(e[v])}function g(b){let v=(A,_)=>Math.abs(A.time-_.time)<RA*t.duration,S=[];for(let A of b){let _=S.find(w=>v(w[0],A));_?_.push(A):S.push([A])}r.replaceChildren(...S.map(A=>{let _=`${A.map(({label:P})=>P).join("; ")}, t = ${Pe(A[0].time)} s`,N=Be("",()=>t.seek(A[0].time),{class:"time-mark","aria-label":_,title:_});return N.style.left=`${100*A[0].time/(t.duration||1)}%`,N}))}document.addEventListener("keydown",m);let p=rt("label",{for:u,text:"speed"});i.append(n,rt("div",{class:"scrub-box"},r,o),c,s,p,h);let x=t.subscribe(d);return d(),{show(b,v){e=v,g(b)},dispose(){x(),document.removeEventListener("keydown",m),i.replaceChildren()}}}function CA(i){let t=i.target;return t instanceof HTMLElement?t.isContentEditable||t.closest("input, select, textarea, canvas, [role=tablist]")?!0:i.key===" "?t.closest("button, a, summary")!==null:t.closest(".scroll")!==null:!1}function Jx(i,t,e,n){let[r,s]=[t.width,t.height].map(c=>2*Math.floor(c/2));(i.width!==r||i.height!==s)&&([i.width,i.height]=[r,s]);let o=i.getContext("2d");if(!o)return i;let a=o.createLinearGradient(0,0,0,s);a.addColorStop(0,e("--sky").trim()||"#ffffff"),a.addColorStop(1,e("--earth").trim()||"#dddddd"),o.fillStyle=a,o.fillRect(0,0,r,s),o.drawImage(t,0,0);let l=Math.max(12,Math.round(s/36));return o.font=`${l}px system-ui, sans-serif`,o.fillStyle=e("--ink").trim()||"#000000",o.fillText(n,l,s-l,r-2*l),i}var _s={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},bs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Pv=0,_p=1,Iv=2;var Ys=1,Lv=2,la=3,ws=0,ci=1,Vi=2,Zs=0,ca=1,bp=2,wp=3,Mp=4,Fv=5;var Ks=100,Nv=101,Dv=102,Ov=103,Uv=104,kv=200,Bv=201,zv=202,Vv=203,Sp=204,Ap=205,Gv=206,Hv=207,Wv=208,qv=209,$v=210,Xv=211,jv=212,Yv=213,Zv=214,uu=0,hu=1,fu=2,Ko=3,du=4,pu=5,mu=6,gu=7,Hu=0,Kv=1,Jv=2,br=0,Ep=1,Tp=2,Rp=3,Cp=4,Pp=5,Ip=6,Lp=7;var Fp=300,Js=301,ua=302,Wu=303,qu=304,yu=1e3,xr=1001,xu=1002,Bn=1003,Qv=1004;var Al=1005;var ai=1006,$u=1007;var Wr=1008;var di=1009,Np=1010,Dp=1011,ha=1012,Xu=1013,nr=1014,ir=1015,rr=1016,ju=1017,Yu=1018,Qs=1020,Op=35902,Up=35899,kp=1021,Bp=1022,sr=1023,Gr=1026,qr=1027,zp=1028,Zu=1029,Ms=1030,Ku=1031;var Ju=1033,El=33776,Tl=33777,Rl=33778,Cl=33779,Qu=35840,th=35841,eh=35842,nh=35843,ih=36196,rh=37492,sh=37496,oh=37488,ah=37489,Pl=37490,lh=37491,ch=37808,uh=37809,hh=37810,fh=37811,dh=37812,ph=37813,mh=37814,gh=37815,yh=37816,xh=37817,vh=37818,_h=37819,bh=37820,wh=37821,Mh=36492,Sh=36494,Ah=36495,Eh=36283,Th=36284,Il=36285,Rh=36286;var Ka=2300,vu=2301,lu=2302,dp=2303,pp=2400,mp=2401,gp=2402;var t_=3200;var Ll=0,e_=1,$r="",Ei="srgb",Ja="srgb-linear",Qa="linear",Ie="srgb";var cu=7680;var n_=519,i_=512,r_=513,s_=514,Vp=515,o_=516,a_=517,Gp=518,Hp=519,Wp=35044,Fl=35048;var qp="300 es",ki=2e3,Jo=2001;function PA(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function IA(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function tl(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function l_(){let i=tl("canvas");return i.style.display="block",i}var Qx={},Qo=null;function el(...i){let t="THREE."+i.shift();Qo?Qo("log",t,...i):console.log(t,...i)}function c_(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Yt(...i){i=c_(i);let t="THREE."+i.shift();if(Qo)Qo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function re(...i){i=c_(i);let t="THREE."+i.shift();if(Qo)Qo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function ja(...i){let t=i.join(" ");t in Qx||(Qx[t]=!0,Yt(...i))}function u_(i,t,e){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,e);break;default:n()}}setTimeout(s,e)})}var h_={[uu]:uu,[fu]:mu,[du]:du,[Ko]:pu,[hu]:hu,[mu]:fu,[gu]:gu,[pu]:Ko},Qi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let r=n[t];if(r!==void 0){let s=r.indexOf(e);s!==-1&&r.splice(s,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let r=n.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,t);t.target=null}}},Yn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],tv=1234567,Ya=Math.PI/180,ta=180/Math.PI;function Ss(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Yn[i&255]+Yn[i>>8&255]+Yn[i>>16&255]+Yn[i>>24&255]+"-"+Yn[t&255]+Yn[t>>8&255]+"-"+Yn[t>>16&15|64]+Yn[t>>24&255]+"-"+Yn[e&63|128]+Yn[e>>8&255]+"-"+Yn[e>>16&255]+Yn[e>>24&255]+Yn[n&255]+Yn[n>>8&255]+Yn[n>>16&255]+Yn[n>>24&255]).toLowerCase()}function ue(i,t,e){return Math.max(t,Math.min(e,i))}function $p(i,t){return(i%t+t)%t}function LA(i,t,e,n,r){return n+(i-t)*(r-n)/(e-t)}function FA(i,t,e){return i!==t?(e-i)/(t-i):0}function Za(i,t,e){return(1-e)*i+e*t}function NA(i,t,e,n){return Za(i,t,1-Math.exp(-e*n))}function DA(i,t=1){return t-Math.abs($p(i,t*2)-t)}function OA(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function UA(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function kA(i,t){return i+Math.floor(Math.random()*(t-i+1))}function BA(i,t){return i+Math.random()*(t-i)}function zA(i){return i*(.5-Math.random())}function VA(i){i!==void 0&&(tv=i);let t=tv+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function GA(i){return i*Ya}function HA(i){return i*ta}function WA(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function qA(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Xp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function $A(i,t,e,n,r){let s=Math.cos,o=Math.sin,a=s(e/2),l=o(e/2),c=s((t+n)/2),u=o((t+n)/2),h=s((t-n)/2),f=o((t-n)/2),d=s((n-t)/2),m=o((n-t)/2);switch(r){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*u,a*c);break;default:Yt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function Ch(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function jp(i,t){if(t.constructor===Float32Array)return i;let e=Ch(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Yp(i,t){if(t.constructor===Float32Array)return i;let e=Ch(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var or={DEG2RAD:Ya,RAD2DEG:ta,generateUUID:Ss,clamp:ue,euclideanModulo:$p,mapLinear:LA,inverseLerp:FA,lerp:Za,damp:NA,pingpong:DA,smoothstep:OA,smootherstep:UA,randInt:kA,randFloat:BA,randFloatSpread:zA,seededRandom:VA,degToRad:GA,radToDeg:HA,isPowerOfTwo:WA,ceilPowerOfTwo:qA,floorPowerOfTwo:Xp,setQuaternionFromProperEuler:$A,normalize:Yp,denormalize:jp},Zt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6],this.y=r[1]*e+r[4]*n+r[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ue(this.x,t.x,e.x),this.y=ue(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ue(this.x,t,e),this.y=ue(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ue(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ue(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),r=Math.sin(e),s=this.x-t.x,o=this.y-t.y;return this.x=s*n-o*r+t.x,this.y=s*r+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},zn=class{constructor(t=0,e=0,n=0,r=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=r}static slerpFlat(t,e,n,r,s,o,a){let l=n[r+0],c=n[r+1],u=n[r+2],h=n[r+3],f=s[o+0],d=s[o+1],m=s[o+2],y=s[o+3];if(h!==y||l!==f||c!==d||u!==m){let g=l*f+c*d+u*m+h*y;g<0&&(f=-f,d=-d,m=-m,y=-y,g=-g);let p=1-a;if(g<.9995){let x=Math.acos(g),b=Math.sin(x);p=Math.sin(p*x)/b,a=Math.sin(a*x)/b,l=l*p+f*a,c=c*p+d*a,u=u*p+m*a,h=h*p+y*a}else{l=l*p+f*a,c=c*p+d*a,u=u*p+m*a,h=h*p+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,r,s,o){let a=n[r],l=n[r+1],c=n[r+2],u=n[r+3],h=s[o],f=s[o+1],d=s[o+2],m=s[o+3];return t[e]=a*m+u*h+l*d-c*f,t[e+1]=l*m+u*f+c*h-a*d,t[e+2]=c*m+u*d+a*f-l*h,t[e+3]=u*m-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,r){return this._x=t,this._y=e,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,r=t._y,s=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(r/2),h=a(s/2),f=l(n/2),d=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"YXZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"ZXY":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"ZYX":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"YZX":this._x=f*u*h+c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h-f*d*m;break;case"XZY":this._x=f*u*h-c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h+f*d*m;break;default:Yt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,r=Math.sin(n);return this._x=t.x*r,this._y=t.y*r,this._z=t.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],r=e[4],s=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(s-c)*d,this._z=(o-r)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(r+o)/d,this._z=(s+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-n-h);this._w=(s-c)/d,this._x=(r+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-r)/d,this._x=(s+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ue(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let r=Math.min(1,e/n);return this.slerp(t,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,r=t._y,s=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-n*c,this._z=s*u+o*c+n*l-r*a,this._w=o*u-n*a-r*l-s*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,r=t._y,s=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,r=-r,s=-s,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+n*e,this._y=this._y*l+r*e,this._z=this._z*l+s*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+r*e,this._z=this._z*l+s*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(t),r*Math.cos(t),s*Math.sin(e),s*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(ev.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(ev.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,r=this.z,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6]*r,this.y=s[1]*e+s[4]*n+s[7]*r,this.z=s[2]*e+s[5]*n+s[8]*r,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,r=this.z,s=t.elements,o=1/(s[3]*e+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*e+s[4]*n+s[8]*r+s[12])*o,this.y=(s[1]*e+s[5]*n+s[9]*r+s[13])*o,this.z=(s[2]*e+s[6]*n+s[10]*r+s[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,r=this.z,s=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*r-a*n),u=2*(a*e-s*r),h=2*(s*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-s*h,this.z=r+l*h+s*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,r=this.z,s=t.elements;return this.x=s[0]*e+s[4]*n+s[8]*r,this.y=s[1]*e+s[5]*n+s[9]*r,this.z=s[2]*e+s[6]*n+s[10]*r,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ue(this.x,t.x,e.x),this.y=ue(this.y,t.y,e.y),this.z=ue(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ue(this.x,t,e),this.y=ue(this.y,t,e),this.z=ue(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ue(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,r=t.y,s=t.z,o=e.x,a=e.y,l=e.z;return this.x=r*l-s*a,this.y=s*o-n*l,this.z=n*a-r*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return qd.copy(this).projectOnVector(t),this.sub(qd)}reflect(t){return this.sub(qd.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ue(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,r=this.z-t.z;return e*e+n*n+r*r}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let r=Math.sin(e)*t;return this.x=r*Math.sin(n),this.y=Math.cos(e)*t,this.z=r*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),r=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=r,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},qd=new V,ev=new zn,se=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,r,s,o,a,l,c)}set(t,e,n,r,s,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=r,u[2]=a,u[3]=e,u[4]=s,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,r=e.elements,s=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],m=n[8],y=r[0],g=r[3],p=r[6],x=r[1],b=r[4],v=r[7],S=r[2],A=r[5],_=r[8];return s[0]=o*y+a*x+l*S,s[3]=o*g+a*b+l*A,s[6]=o*p+a*v+l*_,s[1]=c*y+u*x+h*S,s[4]=c*g+u*b+h*A,s[7]=c*p+u*v+h*_,s[2]=f*y+d*x+m*S,s[5]=f*g+d*b+m*A,s[8]=f*p+d*v+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*s*u+n*a*l+r*s*c-r*o*l}invert(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*s,d=c*s-o*l,m=e*h+n*f+r*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return t[0]=h*y,t[1]=(r*c-u*n)*y,t[2]=(a*n-r*o)*y,t[3]=f*y,t[4]=(u*e-r*l)*y,t[5]=(r*s-a*e)*y,t[6]=d*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*s)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-r*c,r*l,-r*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ja("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply($d.makeScale(t,e)),this}rotate(t){return ja("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply($d.makeRotation(-t)),this}translate(t,e){return ja("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply($d.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let r=0;r<9;r++)if(e[r]!==n[r])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},$d=new se,nv=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),iv=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function XA(){let i={enabled:!0,workingColorSpace:Ja,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Ie&&(r.r=Vr(r.r),r.g=Vr(r.g),r.b=Vr(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ie&&(r.r=Zo(r.r),r.g=Zo(r.g),r.b=Zo(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===$r?Qa:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ja]:{primaries:t,whitePoint:n,transfer:Qa,toXYZ:nv,fromXYZ:iv,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ei},outputColorSpaceConfig:{drawingBufferColorSpace:Ei}},[Ei]:{primaries:t,whitePoint:n,transfer:Ie,toXYZ:nv,fromXYZ:iv,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ei}}}),i}var be=XA();function Vr(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Zo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Do,_u=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Do===void 0&&(Do=tl("canvas")),Do.width=t.width,Do.height=t.height;let r=Do.getContext("2d");t instanceof ImageData?r.putImageData(t,0,0):r.drawImage(t,0,0,t.width,t.height),n=Do}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=tl("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let r=n.getImageData(0,0,t.width,t.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Vr(s[o]/255)*255;return n.putImageData(r,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Vr(e[n]/255)*255):e[n]=Vr(e[n]);return{data:e,width:t.width,height:t.height}}else return Yt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},jA=0,ea=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:jA++}),this.uuid=Ss(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Xd(r[o].image)):s.push(Xd(r[o]))}else s=Xd(r);n.url=s}return e||(t.images[this.uuid]=n),n}};function Xd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?_u.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Yt("Texture: Unable to serialize Texture."),{})}var YA=0,jd=new V,fi=class i extends Qi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=xr,r=xr,s=ai,o=Wr,a=sr,l=di,c=i.DEFAULT_ANISOTROPY,u=$r){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:YA++}),this.uuid=Ss(),this.name="",this.source=new ea(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(jd).x}get height(){return this.source.getSize(jd).y}get depth(){return this.source.getSize(jd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Yt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let r=this[e];if(r===void 0){Yt(`Texture.setValues(): property '${e}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Fp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case yu:t.x=t.x-Math.floor(t.x);break;case xr:t.x=t.x<0?0:1;break;case xu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case yu:t.y=t.y-Math.floor(t.y);break;case xr:t.y=t.y<0?0:1;break;case xu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};fi.DEFAULT_IMAGE=null;fi.DEFAULT_MAPPING=Fp;fi.DEFAULT_ANISOTROPY=1;var Le=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,r=1){this.x=t,this.y=e,this.z=n,this.w=r}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,r){return this.x=t,this.y=e,this.z=n,this.w=r,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,r=this.z,s=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*r+o[12]*s,this.y=o[1]*e+o[5]*n+o[9]*r+o[13]*s,this.z=o[2]*e+o[6]*n+o[10]*r+o[14]*s,this.w=o[3]*e+o[7]*n+o[11]*r+o[15]*s,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,r,s,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],m=l[9],y=l[2],g=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(m+g)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,v=(d+1)/2,S=(p+1)/2,A=(u+f)/4,_=(h+y)/4,w=(m+g)/4;return b>v&&b>S?b<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(b),r=A/n,s=_/n):v>S?v<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(v),n=A/r,s=w/r):S<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(S),n=_/s,r=w/s),this.set(n,r,s,e),this}let x=Math.sqrt((g-m)*(g-m)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(g-m)/x,this.y=(h-y)/x,this.z=(f-u)/x,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ue(this.x,t.x,e.x),this.y=ue(this.y,t.y,e.y),this.z=ue(this.z,t.z,e.z),this.w=ue(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ue(this.x,t,e),this.y=ue(this.y,t,e),this.z=ue(this.z,t,e),this.w=ue(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ue(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},bu=class extends Qi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ai,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Le(0,0,t,e),this.scissorTest=!1,this.viewport=new Le(0,0,t,e),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new fi({width:t,height:e,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ai,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=t,this.textures[r].image.height=e,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let r=Object.assign({},t.textures[e].image);this.textures[e].source=new ea(r)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ri=class extends bu{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},nl=class extends fi{constructor(t=null,e=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:r},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=xr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var wu=class extends fi{constructor(t=null,e=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:r},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=xr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var $e=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g)}set(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=m,p[11]=y,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,r=1/Oo.setFromMatrixColumn(t,0).length(),s=1/Oo.setFromMatrixColumn(t,1).length(),o=1/Oo.setFromMatrixColumn(t,2).length();return e[0]=n[0]*r,e[1]=n[1]*r,e[2]=n[2]*r,e[3]=0,e[4]=n[4]*s,e[5]=n[5]*s,e[6]=n[6]*s,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,r=t.y,s=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(t.order==="XYZ"){let f=o*u,d=o*h,m=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+m*c,e[5]=f-y*c,e[9]=-a*l,e[2]=y-f*c,e[6]=m+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,d=l*h,m=c*u,y=c*h;e[0]=f+y*a,e[4]=m*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-m,e[6]=y+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*u,d=l*h,m=c*u,y=c*h;e[0]=f-y*a,e[4]=-o*h,e[8]=m+d*a,e[1]=d+m*a,e[5]=o*u,e[9]=y-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,d=o*h,m=a*u,y=a*h;e[0]=l*u,e[4]=m*c-d,e[8]=f*c+y,e[1]=l*h,e[5]=y*c+f,e[9]=d*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*u,e[4]=y-f*h,e[8]=m*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+m,e[10]=f-y*h}else if(t.order==="XZY"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+y,e[5]=o*u,e[9]=d*h-m,e[2]=m*h-d,e[6]=a*u,e[10]=y*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(ZA,t,KA)}lookAt(t,e,n){let r=this.elements;return Si.subVectors(t,e),Si.lengthSq()===0&&(Si.z=1),Si.normalize(),as.crossVectors(n,Si),as.lengthSq()===0&&(Math.abs(n.z)===1?Si.x+=1e-4:Si.z+=1e-4,Si.normalize(),as.crossVectors(n,Si)),as.normalize(),Bc.crossVectors(Si,as),r[0]=as.x,r[4]=Bc.x,r[8]=Si.x,r[1]=as.y,r[5]=Bc.y,r[9]=Si.y,r[2]=as.z,r[6]=Bc.z,r[10]=Si.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,r=e.elements,s=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],m=n[2],y=n[6],g=n[10],p=n[14],x=n[3],b=n[7],v=n[11],S=n[15],A=r[0],_=r[4],w=r[8],N=r[12],P=r[1],I=r[5],U=r[9],z=r[13],C=r[2],O=r[6],W=r[10],G=r[14],et=r[3],$=r[7],X=r[11],tt=r[15];return s[0]=o*A+a*P+l*C+c*et,s[4]=o*_+a*I+l*O+c*$,s[8]=o*w+a*U+l*W+c*X,s[12]=o*N+a*z+l*G+c*tt,s[1]=u*A+h*P+f*C+d*et,s[5]=u*_+h*I+f*O+d*$,s[9]=u*w+h*U+f*W+d*X,s[13]=u*N+h*z+f*G+d*tt,s[2]=m*A+y*P+g*C+p*et,s[6]=m*_+y*I+g*O+p*$,s[10]=m*w+y*U+g*W+p*X,s[14]=m*N+y*z+g*G+p*tt,s[3]=x*A+b*P+v*C+S*et,s[7]=x*_+b*I+v*O+S*$,s[11]=x*w+b*U+v*W+S*X,s[15]=x*N+b*z+v*G+S*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],r=t[8],s=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],m=t[3],y=t[7],g=t[11],p=t[15],x=l*d-c*f,b=a*d-c*h,v=a*f-l*h,S=o*d-c*u,A=o*f-l*u,_=o*h-a*u;return e*(y*x-g*b+p*v)-n*(m*x-g*S+p*A)+r*(m*b-y*S+p*_)-s*(m*v-y*A+g*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],r=t[8],s=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-n*(s*u-a*l)+r*(s*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let r=this.elements;return t.isVector3?(r[12]=t.x,r[13]=t.y,r[14]=t.z):(r[12]=t,r[13]=e,r[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],m=t[12],y=t[13],g=t[14],p=t[15],x=e*a-n*o,b=e*l-r*o,v=e*c-s*o,S=n*l-r*a,A=n*c-s*a,_=r*c-s*l,w=u*y-h*m,N=u*g-f*m,P=u*p-d*m,I=h*g-f*y,U=h*p-d*y,z=f*p-d*g,C=x*z-b*U+v*I+S*P-A*N+_*w;if(C===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/C;return t[0]=(a*z-l*U+c*I)*O,t[1]=(r*U-n*z-s*I)*O,t[2]=(y*_-g*A+p*S)*O,t[3]=(f*A-h*_-d*S)*O,t[4]=(l*P-o*z-c*N)*O,t[5]=(e*z-r*P+s*N)*O,t[6]=(g*v-m*_-p*b)*O,t[7]=(u*_-f*v+d*b)*O,t[8]=(o*U-a*P+c*w)*O,t[9]=(n*P-e*U-s*w)*O,t[10]=(m*A-y*v+p*x)*O,t[11]=(h*v-u*A-d*x)*O,t[12]=(a*N-o*I-l*w)*O,t[13]=(e*I-n*N+r*w)*O,t[14]=(y*b-m*S-g*x)*O,t[15]=(u*S-h*b+f*x)*O,this}scale(t){let e=this.elements,n=t.x,r=t.y,s=t.z;return e[0]*=n,e[4]*=r,e[8]*=s,e[1]*=n,e[5]*=r,e[9]*=s,e[2]*=n,e[6]*=r,e[10]*=s,e[3]*=n,e[7]*=r,e[11]*=s,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],r=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,r))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),r=Math.sin(e),s=1-n,o=t.x,a=t.y,l=t.z,c=s*o,u=s*a;return this.set(c*o+n,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+n,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,r,s,o){return this.set(1,n,s,0,t,1,o,0,e,r,1,0,0,0,0,1),this}compose(t,e,n){let r=this.elements,s=e._x,o=e._y,a=e._z,l=e._w,c=s+s,u=o+o,h=a+a,f=s*c,d=s*u,m=s*h,y=o*u,g=o*h,p=a*h,x=l*c,b=l*u,v=l*h,S=n.x,A=n.y,_=n.z;return r[0]=(1-(y+p))*S,r[1]=(d+v)*S,r[2]=(m-b)*S,r[3]=0,r[4]=(d-v)*A,r[5]=(1-(f+p))*A,r[6]=(g+x)*A,r[7]=0,r[8]=(m+b)*_,r[9]=(g-x)*_,r[10]=(1-(f+y))*_,r[11]=0,r[12]=t.x,r[13]=t.y,r[14]=t.z,r[15]=1,this}decompose(t,e,n){let r=this.elements;t.x=r[12],t.y=r[13],t.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),e.identity(),this;let o=Oo.set(r[0],r[1],r[2]).length(),a=Oo.set(r[4],r[5],r[6]).length(),l=Oo.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Zi.copy(this);let c=1/o,u=1/a,h=1/l;return Zi.elements[0]*=c,Zi.elements[1]*=c,Zi.elements[2]*=c,Zi.elements[4]*=u,Zi.elements[5]*=u,Zi.elements[6]*=u,Zi.elements[8]*=h,Zi.elements[9]*=h,Zi.elements[10]*=h,e.setFromRotationMatrix(Zi),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,r,s,o,a=ki,l=!1){let c=this.elements,u=2*s/(e-t),h=2*s/(n-r),f=(e+t)/(e-t),d=(n+r)/(n-r),m,y;if(l)m=s/(o-s),y=o*s/(o-s);else if(a===ki)m=-(o+s)/(o-s),y=-2*o*s/(o-s);else if(a===Jo)m=-o/(o-s),y=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,r,s,o,a=ki,l=!1){let c=this.elements,u=2/(e-t),h=2/(n-r),f=-(e+t)/(e-t),d=-(n+r)/(n-r),m,y;if(l)m=1/(o-s),y=o/(o-s);else if(a===ki)m=-2/(o-s),y=-(o+s)/(o-s);else if(a===Jo)m=-1/(o-s),y=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let r=0;r<16;r++)if(e[r]!==n[r])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Oo=new V,Zi=new $e,ZA=new V(0,0,0),KA=new V(1,1,1),as=new V,Bc=new V,Si=new V,rv=new $e,sv=new zn,vr=class i{constructor(t=0,e=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=r}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,r=this._order){return this._x=t,this._y=e,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let r=t.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],h=r[2],f=r[6],d=r[10];switch(e){case"XYZ":this._y=Math.asin(ue(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ue(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(ue(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-ue(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ue(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ue(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Yt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return rv.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rv,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return sv.setFromEuler(this),this.setFromQuaternion(sv,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};vr.DEFAULT_ORDER="XYZ";var il=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},JA=0,ov=new V,Uo=new zn,Or=new $e,zc=new V,Ha=new V,QA=new V,tE=new zn,av=new V(1,0,0),lv=new V(0,1,0),cv=new V(0,0,1),uv={type:"added"},eE={type:"removed"},ko={type:"childadded",child:null},Yd={type:"childremoved",child:null},Wn=class i extends Qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:JA++}),this.uuid=Ss(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new V,e=new vr,n=new zn,r=new V(1,1,1);function s(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new $e},normalMatrix:{value:new se}}),this.matrix=new $e,this.matrixWorld=new $e,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new il,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Uo.setFromAxisAngle(t,e),this.quaternion.multiply(Uo),this}rotateOnWorldAxis(t,e){return Uo.setFromAxisAngle(t,e),this.quaternion.premultiply(Uo),this}rotateX(t){return this.rotateOnAxis(av,t)}rotateY(t){return this.rotateOnAxis(lv,t)}rotateZ(t){return this.rotateOnAxis(cv,t)}translateOnAxis(t,e){return ov.copy(t).applyQuaternion(this.quaternion),this.position.add(ov.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(av,t)}translateY(t){return this.translateOnAxis(lv,t)}translateZ(t){return this.translateOnAxis(cv,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Or.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?zc.copy(t):zc.set(t,e,n);let r=this.parent;this.updateWorldMatrix(!0,!1),Ha.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Or.lookAt(Ha,zc,this.up):Or.lookAt(zc,Ha,this.up),this.quaternion.setFromRotationMatrix(Or),r&&(Or.extractRotation(r.matrixWorld),Uo.setFromRotationMatrix(Or),this.quaternion.premultiply(Uo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(uv),ko.child=t,this.dispatchEvent(ko),ko.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(eE),Yd.child=t,this.dispatchEvent(Yd),Yd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Or.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Or.multiply(t.parent.matrixWorld)),t.applyMatrix4(Or),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(uv),ko.child=t,this.dispatchEvent(ko),ko.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,r=this.children.length;n<r;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ha,t,QA),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ha,tE,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,r=t.z,s=this.matrix.elements;s[12]+=e-s[0]*e-s[4]*n-s[8]*r,s[13]+=n-s[1]*e-s[5]*n-s[9]*r,s[14]+=r-s[2]*e-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let r=this.parent;if(t===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(t),r.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(t.shapes,h)}else s(t.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(t.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(t.materials,this.material[l]));r.material=a}else r.material=s(t.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=r,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let r=t.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Wn.DEFAULT_UP=new V(0,1,0);Wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},nE={type:"move"},na=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let g=e.getJointPose(y,n),p=this._getHandJoint(c,y);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(s=e.getPose(t.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(r=e.getPose(t.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(nE)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new kn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},f_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ls={h:0,s:0,l:0},Vc={h:0,s:0,l:0};function Zd(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let r=t;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ei){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,be.colorSpaceToWorking(this,e),this}setRGB(t,e,n,r=be.workingColorSpace){return this.r=t,this.g=e,this.b=n,be.colorSpaceToWorking(this,r),this}setHSL(t,e,n,r=be.workingColorSpace){if(t=$p(t,1),e=ue(e,0,1),n=ue(n,0,1),e===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+e):n+e-n*e,o=2*n-s;this.r=Zd(o,s,t+1/3),this.g=Zd(o,s,t),this.b=Zd(o,s,t-1/3)}return be.colorSpaceToWorking(this,r),this}setStyle(t,e=Ei){function n(s){s!==void 0&&parseFloat(s)<1&&Yt("Color: Alpha component of "+t+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(t)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,e);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,e);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,e);break;default:Yt("Color: Unknown color model "+t)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(t)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(s,16),e);Yt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ei){let n=f_[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Yt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Vr(t.r),this.g=Vr(t.g),this.b=Vr(t.b),this}copyLinearToSRGB(t){return this.r=Zo(t.r),this.g=Zo(t.g),this.b=Zo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ei){return be.workingToColorSpace(Zn.copy(this),t),Math.round(ue(Zn.r*255,0,255))*65536+Math.round(ue(Zn.g*255,0,255))*256+Math.round(ue(Zn.b*255,0,255))}getHexString(t=Ei){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=be.workingColorSpace){be.workingToColorSpace(Zn.copy(this),e);let n=Zn.r,r=Zn.g,s=Zn.b,o=Math.max(n,r,s),a=Math.min(n,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(r-s)/h+(r<s?6:0);break;case r:l=(s-n)/h+2;break;case s:l=(n-r)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=be.workingColorSpace){return be.workingToColorSpace(Zn.copy(this),e),t.r=Zn.r,t.g=Zn.g,t.b=Zn.b,t}getStyle(t=Ei){be.workingToColorSpace(Zn.copy(this),t);let e=Zn.r,n=Zn.g,r=Zn.b;return t!==Ei?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(t,e,n){return this.getHSL(ls),this.setHSL(ls.h+t,ls.s+e,ls.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(ls),t.getHSL(Vc);let n=Za(ls.h,Vc.h,e),r=Za(ls.s,Vc.s,e),s=Za(ls.l,Vc.l,e);return this.setHSL(n,r,s),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,r=this.b,s=t.elements;return this.r=s[0]*e+s[3]*n+s[6]*r,this.g=s[1]*e+s[4]*n+s[7]*r,this.b=s[2]*e+s[5]*n+s[8]*r,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Zn=new he;he.NAMES=f_;var rl=class extends Wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new vr,this.environmentIntensity=1,this.environmentRotation=new vr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ki=new V,Ur=new V,Kd=new V,kr=new V,Bo=new V,zo=new V,hv=new V,Jd=new V,Qd=new V,tp=new V,ep=new Le,np=new Le,ip=new Le,fs=class i{constructor(t=new V,e=new V,n=new V){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,r){r.subVectors(n,e),Ki.subVectors(t,e),r.cross(Ki);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(t,e,n,r,s){Ki.subVectors(r,e),Ur.subVectors(n,e),Kd.subVectors(t,e);let o=Ki.dot(Ki),a=Ki.dot(Ur),l=Ki.dot(Kd),c=Ur.dot(Ur),u=Ur.dot(Kd),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,m=(o*u-a*l)*f;return s.set(1-d-m,m,d)}static containsPoint(t,e,n,r){return this.getBarycoord(t,e,n,r,kr)===null?!1:kr.x>=0&&kr.y>=0&&kr.x+kr.y<=1}static getInterpolation(t,e,n,r,s,o,a,l){return this.getBarycoord(t,e,n,r,kr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,kr.x),l.addScaledVector(o,kr.y),l.addScaledVector(a,kr.z),l)}static getInterpolatedAttribute(t,e,n,r,s,o){return ep.setScalar(0),np.setScalar(0),ip.setScalar(0),ep.fromBufferAttribute(t,e),np.fromBufferAttribute(t,n),ip.fromBufferAttribute(t,r),o.setScalar(0),o.addScaledVector(ep,s.x),o.addScaledVector(np,s.y),o.addScaledVector(ip,s.z),o}static isFrontFacing(t,e,n,r){return Ki.subVectors(n,e),Ur.subVectors(t,e),Ki.cross(Ur).dot(r)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,r){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[r]),this}setFromAttributeAndIndices(t,e,n,r){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,r),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ki.subVectors(this.c,this.b),Ur.subVectors(this.a,this.b),Ki.cross(Ur).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,r,s){return i.getInterpolation(t,this.a,this.b,this.c,e,n,r,s)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,r=this.b,s=this.c,o,a;Bo.subVectors(r,n),zo.subVectors(s,n),Jd.subVectors(t,n);let l=Bo.dot(Jd),c=zo.dot(Jd);if(l<=0&&c<=0)return e.copy(n);Qd.subVectors(t,r);let u=Bo.dot(Qd),h=zo.dot(Qd);if(u>=0&&h<=u)return e.copy(r);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(n).addScaledVector(Bo,o);tp.subVectors(t,s);let d=Bo.dot(tp),m=zo.dot(tp);if(m>=0&&d<=m)return e.copy(s);let y=d*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(zo,a);let g=u*m-d*h;if(g<=0&&h-u>=0&&d-m>=0)return hv.subVectors(s,r),a=(h-u)/(h-u+(d-m)),e.copy(r).addScaledVector(hv,a);let p=1/(g+y+f);return o=y*p,a=f*p,e.copy(n).addScaledVector(Bo,o).addScaledVector(zo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},li=class{constructor(t=new V(1/0,1/0,1/0),e=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ji.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ji.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ji.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let s=n.getAttribute("position");if(e===!0&&s!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ji):Ji.fromBufferAttribute(s,o),Ji.applyMatrix4(t.matrixWorld),this.expandByPoint(Ji);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Gc.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Gc.copy(n.boundingBox)),Gc.applyMatrix4(t.matrixWorld),this.union(Gc)}let r=t.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ji),Ji.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Wa),Hc.subVectors(this.max,Wa),Vo.subVectors(t.a,Wa),Go.subVectors(t.b,Wa),Ho.subVectors(t.c,Wa),cs.subVectors(Go,Vo),us.subVectors(Ho,Go),Vs.subVectors(Vo,Ho);let e=[0,-cs.z,cs.y,0,-us.z,us.y,0,-Vs.z,Vs.y,cs.z,0,-cs.x,us.z,0,-us.x,Vs.z,0,-Vs.x,-cs.y,cs.x,0,-us.y,us.x,0,-Vs.y,Vs.x,0];return!rp(e,Vo,Go,Ho,Hc)||(e=[1,0,0,0,1,0,0,0,1],!rp(e,Vo,Go,Ho,Hc))?!1:(Wc.crossVectors(cs,us),e=[Wc.x,Wc.y,Wc.z],rp(e,Vo,Go,Ho,Hc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ji).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ji).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Br[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Br[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Br[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Br[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Br[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Br[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Br[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Br[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Br),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Br=[new V,new V,new V,new V,new V,new V,new V,new V],Ji=new V,Gc=new li,Vo=new V,Go=new V,Ho=new V,cs=new V,us=new V,Vs=new V,Wa=new V,Hc=new V,Wc=new V,Gs=new V;function rp(i,t,e,n,r){for(let s=0,o=i.length-3;s<=o;s+=3){Gs.fromArray(i,s);let a=r.x*Math.abs(Gs.x)+r.y*Math.abs(Gs.y)+r.z*Math.abs(Gs.z),l=t.dot(Gs),c=e.dot(Gs),u=n.dot(Gs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var An=new V,qc=new Zt,iE=0,je=class extends Qi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:iE++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Wp,this.updateRanges=[],this.gpuType=ir,this.version=0,this._normalizationScale=t!==void 0?Ch(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[t+r]=e.array[n+r];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)qc.fromBufferAttribute(this,e),qc.applyMatrix3(t),this.setXY(e,qc.x,qc.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)An.fromBufferAttribute(this,e),An.applyMatrix3(t),this.setXYZ(e,An.x,An.y,An.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)An.fromBufferAttribute(this,e),An.applyMatrix4(t),this.setXYZ(e,An.x,An.y,An.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)An.fromBufferAttribute(this,e),An.applyNormalMatrix(t),this.setXYZ(e,An.x,An.y,An.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)An.fromBufferAttribute(this,e),An.transformDirection(t),this.setXYZ(e,An.x,An.y,An.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=r,this}setXYZW(t,e,n,r,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=r,this.array[t+3]=s,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):jp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Yp(t,this.array)}};var sl=class extends je{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ol=class extends je{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Xe=class extends je{constructor(t,e,n){super(new Float32Array(t),e,n)}},rE=new li,qa=new V,sp=new V,tr=class{constructor(t=new V,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):rE.setFromPoints(t).getCenter(n);let r=0;for(let s=0,o=t.length;s<o;s++)r=Math.max(r,n.distanceToSquared(t[s]));return this.radius=Math.sqrt(r),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;qa.subVectors(t,this.center);let e=qa.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),r=(n-this.radius)*.5;this.center.addScaledVector(qa,r/n),this.radius+=r}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(sp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(qa.copy(t.center).add(sp)),this.expandByPoint(qa.copy(t.center).sub(sp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},sE=0,Ui=new $e,op=new Wn,Wo=new V,Ai=new li,$a=new li,Un=new V,sn=class i extends Qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:sE++}),this.uuid=Ss(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(PA(t)?ol:sl)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new se().getNormalMatrix(t);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(t),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ui.makeRotationFromQuaternion(t),this.applyMatrix4(Ui),this}rotateX(t){return Ui.makeRotationX(t),this.applyMatrix4(Ui),this}rotateY(t){return Ui.makeRotationY(t),this.applyMatrix4(Ui),this}rotateZ(t){return Ui.makeRotationZ(t),this.applyMatrix4(Ui),this}translate(t,e,n){return Ui.makeTranslation(t,e,n),this.applyMatrix4(Ui),this}scale(t,e,n){return Ui.makeScale(t,e,n),this.applyMatrix4(Ui),this}lookAt(t){return op.lookAt(t),op.updateMatrix(),this.applyMatrix4(op.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Wo).negate(),this.translate(Wo.x,Wo.y,Wo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let r=0,s=t.length;r<s;r++){let o=t[r];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Xe(n,3))}else{let n=Math.min(t.length,e.count);for(let r=0;r<n;r++){let s=t[r];e.setXYZ(r,s.x,s.y,s.z||0)}t.length>e.count&&Yt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new li);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,r=e.length;n<r;n++){let s=e[n];Ai.setFromBufferAttribute(s),this.morphTargetsRelative?(Un.addVectors(this.boundingBox.min,Ai.min),this.boundingBox.expandByPoint(Un),Un.addVectors(this.boundingBox.max,Ai.max),this.boundingBox.expandByPoint(Un)):(this.boundingBox.expandByPoint(Ai.min),this.boundingBox.expandByPoint(Ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new tr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(t){let n=this.boundingSphere.center;if(Ai.setFromBufferAttribute(t),e)for(let s=0,o=e.length;s<o;s++){let a=e[s];$a.setFromBufferAttribute(a),this.morphTargetsRelative?(Un.addVectors(Ai.min,$a.min),Ai.expandByPoint(Un),Un.addVectors(Ai.max,$a.max),Ai.expandByPoint(Un)):(Ai.expandByPoint($a.min),Ai.expandByPoint($a.max))}Ai.getCenter(n);let r=0;for(let s=0,o=t.count;s<o;s++)Un.fromBufferAttribute(t,s),r=Math.max(r,n.distanceToSquared(Un));if(e)for(let s=0,o=e.length;s<o;s++){let a=e[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Un.fromBufferAttribute(a,c),l&&(Wo.fromBufferAttribute(t,c),Un.add(Wo)),r=Math.max(r,n.distanceToSquared(Un))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,r=e.normal,s=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new je(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let N=0;N<n.count;N++)a[N]=new V,l[N]=new V;let u=new V,h=new V,f=new V,d=new Zt,m=new Zt,y=new Zt,g=new V,p=new V;function x(N,P,I){c[N]=c[P]=c[I]=1,u.fromBufferAttribute(n,N),h.fromBufferAttribute(n,P),f.fromBufferAttribute(n,I),d.fromBufferAttribute(s,N),m.fromBufferAttribute(s,P),y.fromBufferAttribute(s,I),h.sub(u),f.sub(u),m.sub(d),y.sub(d);let U=1/(m.x*y.y-y.x*m.y);isFinite(U)&&(g.copy(h).multiplyScalar(y.y).addScaledVector(f,-m.y).multiplyScalar(U),p.copy(f).multiplyScalar(m.x).addScaledVector(h,-y.x).multiplyScalar(U),a[N].add(g),a[P].add(g),a[I].add(g),l[N].add(p),l[P].add(p),l[I].add(p))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let N=0,P=b.length;N<P;++N){let I=b[N],U=I.start,z=I.count;for(let C=U,O=U+z;C<O;C+=3)x(t.getX(C+0),t.getX(C+1),t.getX(C+2))}let v=new V,S=new V,A=new V,_=new V;function w(N){A.fromBufferAttribute(r,N),_.copy(A);let P=a[N];v.copy(P),v.sub(A.multiplyScalar(A.dot(P))).normalize(),S.crossVectors(_,P);let U=S.dot(l[N])<0?-1:1;o.setXYZW(N,v.x,v.y,v.z,U)}for(let N=0,P=n.count;N<P;++N)c[N]&&w(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new je(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let r=new V,s=new V,o=new V,a=new V,l=new V,c=new V,u=new V,h=new V;if(t)for(let f=0,d=t.count;f<d;f+=3){let m=t.getX(f+0),y=t.getX(f+1),g=t.getX(f+2);r.fromBufferAttribute(e,m),s.fromBufferAttribute(e,y),o.fromBufferAttribute(e,g),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)r.fromBufferAttribute(e,f+0),s.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Un.fromBufferAttribute(t,e),Un.normalize(),t.setXYZ(e,Un.x,Un.y,Un.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,m=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let p=0;p<u;p++)f[m++]=c[d++]}return new je(f,u,h)}if(this.index===null)return Yt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=t(l,n);e.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(r[l]=u,s=!0)}s&&(t.data.morphAttributes=r,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let r=t.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(e))}let s=t.morphAttributes;for(let c in s){let u=[],h=s[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},al=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Wp,this.updateRanges=[],this.version=0,this.uuid=Ss()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let r=0,s=this.stride;r<s;r++)this.array[t+r]=e.array[n+r];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=fv(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),r=new this.constructor(n,this.stride);return r.setUsage(this.usage),r}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=fv(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function fv(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Ss()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var oi=new V,Bi=class i{constructor(t,e,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=r,this._normalizationScale=t!==void 0?Ch(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)oi.fromBufferAttribute(this,e),oi.applyMatrix4(t),this.setXYZ(e,oi.x,oi.y,oi.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)oi.fromBufferAttribute(this,e),oi.applyNormalMatrix(t),this.setXYZ(e,oi.x,oi.y,oi.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)oi.fromBufferAttribute(this,e),oi.transformDirection(t),this.setXYZ(e,oi.x,oi.y,oi.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=r,this}setXYZW(t,e,n,r,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=r,this.data.array[t+3]=s,this}clone(t){if(t===void 0){el("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)e.push(this.data.array[r+s])}return new je(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){el("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)e.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):jp(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Yp(t,this.data.array)}},ap=new V,oE=new V,aE=new se,Ti=class{constructor(t=new V(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,r){return this.normal.set(t,e,n),this.constant=r,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let r=ap.subVectors(n,e).cross(oE.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(r,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let r=t.delta(ap),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/s;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(r,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||aE.getNormalMatrix(t),r=this.coplanarPoint(ap).applyMatrix4(t),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},lE=0,er=class extends Qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:lE++}),this.uuid=Ss(),this.name="",this.type="Material",this.blending=ca,this.side=ws,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Sp,this.blendDst=Ap,this.blendEquation=Ks,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=Ko,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=n_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=cu,this.stencilZFail=cu,this.stencilZPass=cu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Yt(`Material: parameter '${e}' has value of undefined.`);continue}let r=this[e];if(r===void 0){Yt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(e){let s=r(t.textures),o=r(t.images);s.length>0&&(n.textures=s),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Ti().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Zt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let r=e.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=e[s].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var zr=new V,lp=new V,$c=new V,Xc=new V,qs=class{constructor(t=new V,e=new V(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,zr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=zr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(zr.copy(this.origin).addScaledVector(this.direction,e),zr.distanceToSquared(t))}distanceSqToSegment(t,e,n,r){lp.copy(t).add(e).multiplyScalar(.5),$c.copy(e).sub(t).normalize(),Xc.copy(this.origin).sub(lp);let s=t.distanceTo(e)*.5,o=-this.direction.dot($c),a=Xc.dot(this.direction),l=-Xc.dot($c),c=Xc.lengthSq(),u=Math.abs(1-o*o),h,f,d,m;if(u>0)if(h=o*l-a,f=o*a-l,m=s*u,h>=0)if(f>=-m)if(f<=m){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-s,-l),s),d=f*(f+2*l)+c):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(lp).addScaledVector($c,f),d}intersectSphere(t,e){if(t.radius<0)return null;zr.subVectors(t.center,this.origin);let n=zr.dot(this.direction),r=zr.dot(zr)-n*n,s=t.radius*t.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,r=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,r=(t.min.x-f.x)*c),u>=0?(s=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(s=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||s>r||((s>n||isNaN(n))&&(n=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>r)||((a>n||n!==n)&&(n=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(n>=0?n:r,e)}intersectsBox(t){return this.intersectBox(t,zr)!==null}intersectTriangle(t,e,n,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,f=t.y-o.y,d=t.z-o.z,m=e.x-o.x,y=e.y-o.y,g=e.z-o.z,p=n.x-o.x,x=n.y-o.y,b=n.z-o.z,v=Math.abs(l),S=Math.abs(c),A=Math.abs(u),_,w,N,P,I,U,z,C,O,W,G,et;if(v>=S&&v>=A?(N=l,U=h,O=m,et=p,l>=0?(_=c,w=u,P=f,I=d,z=y,C=g,W=x,G=b):(_=u,w=c,P=d,I=f,z=g,C=y,W=b,G=x)):S>=A?(N=c,U=f,O=y,et=x,c>=0?(_=u,w=l,P=d,I=h,z=g,C=m,W=b,G=p):(_=l,w=u,P=h,I=d,z=m,C=g,W=p,G=b)):(N=u,U=d,O=g,et=b,u>=0?(_=l,w=c,P=h,I=f,z=m,C=y,W=p,G=x):(_=c,w=l,P=f,I=h,z=y,C=m,W=x,G=p)),N===0)return null;let $=_/N,X=w/N,tt=1/N,ht=P-$*U,ct=I-X*U,J=z-$*O,dt=C-X*O,gt=W-$*et,bt=G-X*et,yt=gt*dt-bt*J,Gt=ht*bt-ct*gt,Kt=J*ct-dt*ht;if(r){if(yt<0||Gt<0||Kt<0)return null}else if((yt<0||Gt<0||Kt<0)&&(yt>0||Gt>0||Kt>0))return null;let zt=yt+Gt+Kt;if(zt===0)return null;let le=tt*(yt*U+Gt*O+Kt*et);return(zt>0?le<0:le>0)?null:this.at(le/zt,s)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ia=class extends er{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.combine=Hu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},dv=new $e,Hs=new qs,jc=new tr,pv=new V,Yc=new V,Zc=new V,Kc=new V,cp=new V,Jc=new V,mv=new V,Qc=new V,Ge=class extends Wn{constructor(t=new sn,e=new ia){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let r=e[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(t,e){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(r,t);let a=this.morphTargetInfluences;if(s&&a){Jc.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(cp.fromBufferAttribute(h,t),o?Jc.addScaledVector(cp,u):Jc.addScaledVector(cp.sub(e),u))}e.add(Jc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),jc.copy(n.boundingSphere),jc.applyMatrix4(s),Hs.copy(t.ray).recast(t.near),!(jc.containsPoint(Hs.origin)===!1&&(Hs.intersectSphere(jc,pv)===null||Hs.origin.distanceToSquared(pv)>(t.far-t.near)**2))&&(dv.copy(s).invert(),Hs.copy(t.ray).applyMatrix4(dv),!(n.boundingBox!==null&&Hs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Hs)))}_computeIntersections(t,e,n){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],x=Math.max(g.start,d.start),b=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let v=x,S=b;v<S;v+=3){let A=a.getX(v),_=a.getX(v+1),w=a.getX(v+2);r=tu(this,p,t,n,c,u,h,A,_,w),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,e.push(r))}}else{let m=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let g=m,p=y;g<p;g+=3){let x=a.getX(g),b=a.getX(g+1),v=a.getX(g+2);r=tu(this,o,t,n,c,u,h,x,b,v),r&&(r.faceIndex=Math.floor(g/3),e.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],x=Math.max(g.start,d.start),b=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let v=x,S=b;v<S;v+=3){let A=v,_=v+1,w=v+2;r=tu(this,p,t,n,c,u,h,A,_,w),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,e.push(r))}}else{let m=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let g=m,p=y;g<p;g+=3){let x=g,b=g+1,v=g+2;r=tu(this,o,t,n,c,u,h,x,b,v),r&&(r.faceIndex=Math.floor(g/3),e.push(r))}}}};function cE(i,t,e,n,r,s,o,a){let l;if(t.side===ci?l=n.intersectTriangle(o,s,r,!0,a):l=n.intersectTriangle(r,s,o,t.side===ws,a),l===null)return null;Qc.copy(a),Qc.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Qc);return c<e.near||c>e.far?null:{distance:c,point:Qc.clone(),object:i}}function tu(i,t,e,n,r,s,o,a,l,c){i.getVertexPosition(a,Yc),i.getVertexPosition(l,Zc),i.getVertexPosition(c,Kc);let u=cE(i,t,e,n,Yc,Zc,Kc,mv);if(u){let h=new V;fs.getBarycoord(mv,Yc,Zc,Kc,h),r&&(u.uv=fs.getInterpolatedAttribute(r,a,l,c,h,new Zt)),s&&(u.uv1=fs.getInterpolatedAttribute(s,a,l,c,h,new Zt)),o&&(u.normal=fs.getInterpolatedAttribute(o,a,l,c,h,new V),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new V,materialIndex:0};fs.getNormal(Yc,Zc,Kc,f.normal),u.face=f,u.barycoord=h}return u}var Mu=class extends fi{constructor(t=null,e=1,n=1,r,s,o,a,l,c=Bn,u=Bn,h,f){super(null,o,a,l,c,u,r,s,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ws=new tr,uE=new Zt(.5,.5),eu=new V,ds=class{constructor(t=new Ti,e=new Ti,n=new Ti,r=new Ti,s=new Ti,o=new Ti){this.planes=[t,e,n,r,s,o]}set(t,e,n,r,s,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=ki,n=!1){let r=this.planes,s=t.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],f=s[6],d=s[7],m=s[8],y=s[9],g=s[10],p=s[11],x=s[12],b=s[13],v=s[14],S=s[15];if(r[0].setComponents(c-o,d-u,p-m,S-x).normalize(),r[1].setComponents(c+o,d+u,p+m,S+x).normalize(),r[2].setComponents(c+a,d+h,p+y,S+b).normalize(),r[3].setComponents(c-a,d-h,p-y,S-b).normalize(),n)r[4].setComponents(l,f,g,v).normalize(),r[5].setComponents(c-l,d-f,p-g,S-v).normalize();else if(r[4].setComponents(c-l,d-f,p-g,S-v).normalize(),e===ki)r[5].setComponents(c+l,d+f,p+g,S+v).normalize();else if(e===Jo)r[5].setComponents(l,f,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ws.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ws.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ws)}intersectsSprite(t){Ws.center.set(0,0,0);let e=uE.distanceTo(t.center);return Ws.radius=.7071067811865476+e,Ws.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ws)}intersectsSphere(t){let e=this.planes,n=t.center,r=-t.radius;for(let s=0;s<6;s++)if(e[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let r=e[n];if(eu.x=r.normal.x>0?t.max.x:t.min.x,eu.y=r.normal.y>0?t.max.y:t.min.y,eu.z=r.normal.z>0?t.max.z:t.min.z,r.distanceToPoint(eu)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},gv=new $e,Su=class i{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let r=0;r<e.length;r++){let s=e[r];gv.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new ds),n[r].setFromProjectionMatrix(gv,s.coordinateSystem,s.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let r=0;r<t._count;r++)e[r]===void 0&&(e[r]=new ds),e[r].copy(n[r]);return this._count=t._count,this}clone(){return new i().copy(this)}};var ra=class extends er{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Au=new V,Eu=new V,yv=new $e,Xa=new qs,nu=new tr,up=new V,xv=new V,sa=class extends Wn{constructor(t=new sn,e=new ra){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let r=1,s=e.count;r<s;r++)Au.fromBufferAttribute(e,r-1),Eu.fromBufferAttribute(e,r),n[r]=n[r-1],n[r]+=Au.distanceTo(Eu);t.setAttribute("lineDistance",new Xe(n,1))}else Yt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,r=this.matrixWorld,s=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),nu.copy(n.boundingSphere),nu.applyMatrix4(r),nu.radius+=s,t.ray.intersectsSphere(nu)===!1)return;yv.copy(r).invert(),Xa.copy(t.ray).applyMatrix4(yv);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=d,g=m-1;y<g;y+=c){let p=u.getX(y),x=u.getX(y+1),b=iu(this,t,Xa,l,p,x,y);b&&e.push(b)}if(this.isLineLoop){let y=u.getX(m-1),g=u.getX(d),p=iu(this,t,Xa,l,y,g,m-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=d,g=m-1;y<g;y+=c){let p=iu(this,t,Xa,l,y,y+1,y);p&&e.push(p)}if(this.isLineLoop){let y=iu(this,t,Xa,l,m-1,d,m-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let r=e[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function iu(i,t,e,n,r,s,o){let a=i.geometry.attributes.position;if(Au.fromBufferAttribute(a,r),Eu.fromBufferAttribute(a,s),e.distanceSqToSegment(Au,Eu,up,xv)>n)return;up.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(up);if(!(c<t.near||c>t.far))return{distance:c,point:xv.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var vv=new V,_v=new V,Tu=class extends sa{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let r=0,s=e.count;r<s;r+=2)vv.fromBufferAttribute(e,r),_v.fromBufferAttribute(e,r+1),n[r]=r===0?0:n[r-1],n[r+1]=n[r]+vv.distanceTo(_v);t.setAttribute("lineDistance",new Xe(n,1))}else Yt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ll=class extends fi{constructor(t=[],e=Js,n,r,s,o,a,l,c,u){super(t,e,n,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Hr=class extends fi{constructor(t,e,n=nr,r,s,o,a=Bn,l=Bn,c,u=Gr,h=1){if(u!==Gr&&u!==qr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,r,s,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ea(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},cl=class extends Hr{constructor(t,e=nr,n=Js,r,s,o=Bn,a=Bn,l,c=Gr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,n,r,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ul=class extends fi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ps=class i extends sn{constructor(t=1,e=1,n=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;m("z","y","x",-1,-1,n,e,t,o,s,0),m("z","y","x",1,-1,n,e,-t,o,s,1),m("x","z","y",1,1,t,n,e,r,o,2),m("x","z","y",1,-1,t,n,-e,r,o,3),m("x","y","z",1,-1,t,e,n,r,s,4),m("x","y","z",-1,-1,t,e,-n,r,s,5),this.setIndex(l),this.setAttribute("position",new Xe(c,3)),this.setAttribute("normal",new Xe(u,3)),this.setAttribute("uv",new Xe(h,2));function m(y,g,p,x,b,v,S,A,_,w,N){let P=v/_,I=S/w,U=v/2,z=S/2,C=A/2,O=_+1,W=w+1,G=0,et=0,$=new V;for(let X=0;X<W;X++){let tt=X*I-z;for(let ht=0;ht<O;ht++){let ct=ht*P-U;$[y]=ct*x,$[g]=tt*b,$[p]=C,c.push($.x,$.y,$.z),$[y]=0,$[g]=0,$[p]=A>0?1:-1,u.push($.x,$.y,$.z),h.push(ht/_),h.push(1-X/w),G+=1}}for(let X=0;X<w;X++)for(let tt=0;tt<_;tt++){let ht=f+tt+O*X,ct=f+tt+O*(X+1),J=f+(tt+1)+O*(X+1),dt=f+(tt+1)+O*X;l.push(ht,ct,dt),l.push(ct,J,dt),et+=6}a.addGroup(d,et,N),d+=et,f+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var _r=class i extends sn{constructor(t=1,e=1,n=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let u=[],h=[],f=[],d=[],m=0,y=[],g=n/2,p=0;x(),o===!1&&(t>0&&b(!0),e>0&&b(!1)),this.setIndex(u),this.setAttribute("position",new Xe(h,3)),this.setAttribute("normal",new Xe(f,3)),this.setAttribute("uv",new Xe(d,2));function x(){let v=new V,S=new V,A=0,_=(e-t)/n;for(let w=0;w<=s;w++){let N=[],P=w/s,I=P*(e-t)+t;for(let U=0;U<=r;U++){let z=U/r,C=z*l+a,O=Math.sin(C),W=Math.cos(C);S.x=I*O,S.y=-P*n+g,S.z=I*W,h.push(S.x,S.y,S.z),v.set(O,_,W).normalize(),f.push(v.x,v.y,v.z),d.push(z,1-P),N.push(m++)}y.push(N)}for(let w=0;w<r;w++)for(let N=0;N<s;N++){let P=y[N][w],I=y[N+1][w],U=y[N+1][w+1],z=y[N][w+1];(t>0||N!==0)&&(u.push(P,I,z),A+=3),(e>0||N!==s-1)&&(u.push(I,U,z),A+=3)}c.addGroup(p,A,0),p+=A}function b(v){let S=m,A=new Zt,_=new V,w=0,N=v===!0?t:e,P=v===!0?1:-1;for(let U=1;U<=r;U++)h.push(0,g*P,0),f.push(0,P,0),d.push(.5,.5),m++;let I=m;for(let U=0;U<=r;U++){let C=U/r*l+a,O=Math.cos(C),W=Math.sin(C);_.x=N*W,_.y=g*P,_.z=N*O,h.push(_.x,_.y,_.z),f.push(0,P,0),A.x=O*.5+.5,A.y=W*.5*P+.5,d.push(A.x,A.y),m++}for(let U=0;U<r;U++){let z=S+U,C=I+U;v===!0?u.push(C,C+1,z):u.push(C+1,C,z),w+=3}c.addGroup(p,w,v===!0?1:2),p+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},hl=class i extends _r{constructor(t=1,e=1,n=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,t,e,n,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var $s=class i extends sn{constructor(t=1,e=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:r};let s=t/2,o=e/2,a=Math.floor(n),l=Math.floor(r),c=a+1,u=l+1,h=t/a,f=e/l,d=[],m=[],y=[],g=[];for(let p=0;p<u;p++){let x=p*f-o;for(let b=0;b<c;b++){let v=b*h-s;m.push(v,-x,0),y.push(0,0,1),g.push(b/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let x=0;x<a;x++){let b=x+c*p,v=x+c*(p+1),S=x+1+c*(p+1),A=x+1+c*p;d.push(b,v,A),d.push(v,S,A)}this.setIndex(d),this.setAttribute("position",new Xe(m,3)),this.setAttribute("normal",new Xe(y,3)),this.setAttribute("uv",new Xe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var oa=class i extends sn{constructor(t=1,e=32,n=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new V,f=new V,d=[],m=[],y=[],g=[];for(let p=0;p<=n;p++){let x=[],b=p/n,v=o+b*a,S=t*Math.cos(v),A=Math.sqrt(t*t-S*S),_=0;p===0&&o===0?_=.5/e:p===n&&l===Math.PI&&(_=-.5/e);for(let w=0;w<=e;w++){let N=w/e,P=r+N*s;h.x=-A*Math.cos(P),h.y=S,h.z=A*Math.sin(P),m.push(h.x,h.y,h.z),f.copy(h).normalize(),y.push(f.x,f.y,f.z),g.push(N+_,1-b),x.push(c++)}u.push(x)}for(let p=0;p<n;p++)for(let x=0;x<e;x++){let b=u[p][x+1],v=u[p][x],S=u[p+1][x],A=u[p+1][x+1];(p!==0||o>0)&&d.push(b,v,A),(p!==n-1||l<Math.PI)&&d.push(v,S,A)}this.setIndex(d),this.setAttribute("position",new Xe(m,3)),this.setAttribute("normal",new Xe(y,3)),this.setAttribute("uv",new Xe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var fl=class extends sn{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,r=new V,s=new V;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,d=h.count;for(let m=f,y=f+d;m<y;m+=3)for(let g=0;g<3;g++){let p=a.getX(m+g),x=a.getX(m+(g+1)%3);r.fromBufferAttribute(o,p),s.fromBufferAttribute(o,x),bv(r,s,n)===!0&&(e.push(r.x,r.y,r.z),e.push(s.x,s.y,s.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;r.fromBufferAttribute(o,u),s.fromBufferAttribute(o,h),bv(r,s,n)===!0&&(e.push(r.x,r.y,r.z),e.push(s.x,s.y,s.z))}}this.setAttribute("position",new Xe(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function bv(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,r=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(r)===!0?!1:(e.add(n),e.add(r),!0)}var dl=class extends er{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new he(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function to(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let r=i[e][n];if(wv(r))r.isRenderTargetTexture?(Yt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=r.clone();else if(Array.isArray(r))if(wv(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();t[e][n]=s}else t[e][n]=r.slice();else t[e][n]=r}}return t}function Kn(i){let t={};for(let e=0;e<i.length;e++){let n=to(i[e]);for(let r in n)t[r]=n[r]}return t}function wv(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function hE(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Zp(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:be.workingColorSpace}var Nl={clone:to,merge:Kn},fE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,dE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,zi=class extends er{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=fE,this.fragmentShader=dE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=to(t.uniforms),this.uniformsGroups=hE(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?e.uniforms[r]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[r]={type:"m4",value:o.toArray()}:e.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let r=t.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=e[r.value]||null;break;case"c":this.uniforms[n].value=new he().setHex(r.value);break;case"v2":this.uniforms[n].value=new Zt().fromArray(r.value);break;case"v3":this.uniforms[n].value=new V().fromArray(r.value);break;case"v4":this.uniforms[n].value=new Le().fromArray(r.value);break;case"m3":this.uniforms[n].value=new se().fromArray(r.value);break;case"m4":this.uniforms[n].value=new $e().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Ru=class extends zi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},pl=class extends er{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new he(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ll,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Xs=class extends er{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ll,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.combine=Hu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Cu=class extends er{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=t_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Pu=class extends er{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var ml=class extends ra{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function qo(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function ru(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ms=class{constructor(t,e,n,r){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,r=e[n],s=e[n-1];t:{e:{let o;n:{i:if(!(t<r)){for(let a=n+2;;){if(r===void 0){if(t<s)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(s=r,r=e[++n],t<r)break e}o=e.length;break n}if(!(t>=s)){let a=e[1];t<a&&(n=2,s=a);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(r=s,s=e[--n-1],t>=s)break e}o=n,n=0;break n}break t}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(r=e[n],s=e[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,t,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=t*r;for(let o=0;o!==r;++o)e[o]=n[s+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Iu=class extends ms{constructor(t,e,n,r){super(t,e,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:pp,endingEnd:pp}}intervalChanged_(t,e,n){let r=this.parameterPositions,s=t-2,o=t+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case mp:s=t,a=2*e-n;break;case gp:s=r.length-2,a=e+r[s]-r[s+1];break;default:s=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case mp:o=t,l=2*n-e;break;case gp:o=1,l=n+r[1]-r[0];break;default:o=t-1,l=e}let c=(n-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(n-e)/(r-e),y=m*m,g=y*m,p=-f*g+2*f*y-f*m,x=(1+f)*g+(-1.5-2*f)*y+(-.5+f)*m+1,b=(-1-d)*g+(1.5+d)*y+.5*m,v=d*g-d*y;for(let S=0;S!==a;++S)s[S]=p*o[u+S]+x*o[c+S]+b*o[l+S]+v*o[h+S];return s}},Lu=class extends ms{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(n-e)/(r-e),h=1-u;for(let f=0;f!==a;++f)s[f]=o[c+f]*h+o[l+f]*u;return s}},Fu=class extends ms{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t){return this.copySampleValue_(t-1)}},Nu=class extends ms{interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(n-e)/(r-e),y=1-m;for(let g=0;g!==a;++g)s[g]=o[c+g]*y+o[l+g]*m;return s}let f=a*2,d=t-1;for(let m=0;m!==a;++m){let y=o[c+m],g=o[l+m],p=d*f+m*2,x=h[p],b=h[p+1],v=t*f+m*2,S=u[v],A=u[v+1],_=mE(n,e,x,S,r);s[m]=d_(_,y,b,A,g)}return s}};function d_(i,t,e,n,r){let s=1-i;return s*s*s*t+3*s*s*i*e+3*s*i*i*n+i*i*i*r}function pE(i,t,e,n,r){let s=1-i;return 3*s*s*(e-t)+6*s*i*(n-e)+3*i*i*(r-n)}function mE(i,t,e,n,r){let s=(i-t)/(r-t);for(let o=0;o<8;o++){let a=d_(s,t,e,n,r)-i;if(Math.abs(a)<1e-10)break;let l=pE(s,t,e,n,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var Ci=class{constructor(t,e,n,r){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=qo(e,this.TimeBufferType),this.values=qo(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:qo(t.times,Array),values:qo(t.values,Array)};let r=t.getInterpolation();r!==t.DefaultInterpolation&&(n.interpolation=r),ru(t.settings)&&(n.settings={inTangents:qo(t.settings.inTangents,Array),outTangents:qo(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Fu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Lu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Iu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Nu(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ka:e=this.InterpolantFactoryMethodDiscrete;break;case vu:e=this.InterpolantFactoryMethodLinear;break;case lu:e=this.InterpolantFactoryMethodSmooth;break;case dp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Yt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ka;case this.InterpolantFactoryMethodLinear:return vu;case this.InterpolantFactoryMethodSmooth:return lu;case this.InterpolantFactoryMethodBezier:return dp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,r=e.length;n!==r;++n)e[n]+=t;ru(this.settings)&&(Mv(this.settings.inTangents,t),Mv(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,r=e.length;n!==r;++n)e[n]*=t;ru(this.settings)&&(Sv(this.settings.inTangents,t),Sv(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,r=n.length,s=0,o=r-1;for(;s!==r&&n[s]<t;)++s;for(;o!==-1&&n[o]>e;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,r=this.values,s=n.length;s===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==s;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){re("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){re("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(r!==void 0&&IA(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){re("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===lu,s=t.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(r)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let m=0;m!==n;++m){let y=e[h+m];if(y!==e[f+m]||y!==e[d+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[h+d]}++o}}if(s>0){t[o]=t[s];for(let a=s*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,r=new n(this.name,t,e);return r.createInterpolant=this.createInterpolant,ru(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Mv(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Sv(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}Ci.prototype.ValueTypeName="";Ci.prototype.TimeBufferType=Float32Array;Ci.prototype.ValueBufferType=Float32Array;Ci.prototype.DefaultInterpolation=vu;var gs=class extends Ci{constructor(t,e,n){super(t,e,n)}};gs.prototype.ValueTypeName="bool";gs.prototype.ValueBufferType=Array;gs.prototype.DefaultInterpolation=Ka;gs.prototype.InterpolantFactoryMethodLinear=void 0;gs.prototype.InterpolantFactoryMethodSmooth=void 0;var Du=class extends Ci{constructor(t,e,n,r){super(t,e,n,r)}};Du.prototype.ValueTypeName="color";var Ou=class extends Ci{constructor(t,e,n,r){super(t,e,n,r)}};Ou.prototype.ValueTypeName="number";var Uu=class extends ms{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(r-e),c=t*a;for(let u=c+a;c!==u;c+=4)zn.slerpFlat(s,0,o,c-a,o,c,l);return s}},gl=class extends Ci{constructor(t,e,n,r){super(t,e,n,r)}InterpolantFactoryMethodLinear(t){return new Uu(this.times,this.values,this.getValueSize(),t)}};gl.prototype.ValueTypeName="quaternion";gl.prototype.InterpolantFactoryMethodSmooth=void 0;var ys=class extends Ci{constructor(t,e,n){super(t,e,n)}};ys.prototype.ValueTypeName="string";ys.prototype.ValueBufferType=Array;ys.prototype.DefaultInterpolation=Ka;ys.prototype.InterpolantFactoryMethodLinear=void 0;ys.prototype.InterpolantFactoryMethodSmooth=void 0;var ku=class extends Ci{constructor(t,e,n,r){super(t,e,n,r)}};ku.prototype.ValueTypeName="vector";var Bu=class{constructor(t,e,n){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],m=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},p_=new Bu,zu=class{constructor(t){this.manager=t!==void 0?t:p_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(r,s){n.load(t,r,e,s)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};zu.DEFAULT_MATERIAL_NAME="__DEFAULT";var yl=class extends Wn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},xl=class extends yl{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Wn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},hp=new $e,Av=new V,Ev=new V,Vu=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Zt(512,512),this.mapType=di,this.map=null,this.mapPass=null,this.matrix=new $e,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ds,this._frameExtents=new Zt(1,1),this._viewportCount=1,this._viewports=[new Le(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Av.setFromMatrixPosition(t.matrixWorld),e.position.copy(Av),Ev.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Ev),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,r){hp.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(hp,t.coordinateSystem,t.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;t.coordinateSystem===Jo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(hp)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},su=new V,ou=new zn,yr=new V,vl=class extends Wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new $e,this.projectionMatrix=new $e,this.projectionMatrixInverse=new $e,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(su,ou,yr),yr.x===1&&yr.y===1&&yr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(su,ou,yr.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(su,ou,yr),yr.x===1&&yr.y===1&&yr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(su,ou,yr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},hs=new V,Tv=new Zt,Rv=new Zt,Hn=class extends vl{constructor(t=50,e=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ta*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Ya*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ta*2*Math.atan(Math.tan(Ya*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){hs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(hs.x,hs.y).multiplyScalar(-t/hs.z),hs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(hs.x,hs.y).multiplyScalar(-t/hs.z)}getViewSize(t,e){return this.getViewBounds(t,Tv,Rv),e.subVectors(Rv,Tv)}setViewOffset(t,e,n,r,s,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Ya*.5*this.fov)/this.zoom,n=2*e,r=this.aspect*n,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,e-=o.offsetY*n/c,r*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(s+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var _l=class extends vl{constructor(t=-1,e=1,n=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-t,o=n+t,a=r+e,l=r-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},yp=class extends Vu{constructor(){super(new _l(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},bl=class extends yl{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Wn.DEFAULT_UP),this.updateMatrix(),this.target=new Wn,this.shadow=new yp}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var wl=class extends sn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var $o=-90,Xo=1,aa=class extends Wn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Hn($o,Xo,t,e);r.layers=this.layers,this.add(r);let s=new Hn($o,Xo,t,e);s.layers=this.layers,this.add(s);let o=new Hn($o,Xo,t,e);o.layers=this.layers,this.add(o);let a=new Hn($o,Xo,t,e);a.layers=this.layers,this.add(a);let l=new Hn($o,Xo,t,e);l.layers=this.layers,this.add(l);let c=new Hn($o,Xo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,r,s,o,a,l]=e;for(let c of e)this.remove(c);if(t===ki)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Jo)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,s),t.setRenderTarget(n,1,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Gu=class extends Hn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Kp="\\[\\]\\.:\\/",gE=new RegExp("["+Kp+"]","g"),Jp="[^"+Kp+"]",yE="[^"+Kp.replace("\\.","")+"]",xE=/((?:WC+[\/:])*)/.source.replace("WC",Jp),vE=/(WCOD+)?/.source.replace("WCOD",yE),_E=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Jp),bE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Jp),wE=new RegExp("^"+xE+vE+_E+bE+"$"),ME=["material","materials","bones","map"],xp=class{constructor(t,e,n){let r=n||nn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,r)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},nn=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(gE,"")}static parseTrackName(t){let e=wE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);ME.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},r=n(t.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)t[e++]=n[r]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,r=e.propertyName,s=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Yt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[r];if(o===void 0){let c=e.nodeName;re("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[s]!==void 0&&(s=t.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=xp;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var qN=new Float32Array(1);var xs=class extends al{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var vs=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ue(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ue(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var vp=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,r){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,r){let s=this.elements;return s[0]=t,s[2]=e,s[1]=n,s[3]=r,this}};var Cv=new V,au=new V,jo=new V,Yo=new V,fp=new V,SE=new V,AE=new V,Ml=class{constructor(t=new V,e=new V){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){Cv.subVectors(t,this.start),au.subVectors(this.end,this.start);let n=au.dot(au);if(n===0)return 0;let s=au.dot(Cv)/n;return e&&(s=ue(s,0,1)),s}closestPointToPoint(t,e,n){let r=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(r).add(this.start)}distanceSqToLine3(t,e=SE,n=AE){let r=10000000000000001e-32,s,o,a=this.start,l=t.start,c=this.end,u=t.end;jo.subVectors(c,a),Yo.subVectors(u,l),fp.subVectors(a,l);let h=jo.dot(jo),f=Yo.dot(Yo),d=Yo.dot(fp);if(h<=r&&f<=r)return e.copy(a),n.copy(l),e.distanceToSquared(n);if(h<=r)s=0,o=d/f,o=ue(o,0,1);else{let m=jo.dot(fp);if(f<=r)o=0,s=ue(-m/h,0,1);else{let y=jo.dot(Yo),g=h*f-y*y;g!==0?s=ue((y*d-m*f)/g,0,1):s=0,o=(y*s+d)/f,o<0?(o=0,s=ue(-m/h,0,1)):o>1&&(o=1,s=ue((y-m)/h,0,1))}}return e.copy(a).addScaledVector(jo,s),n.copy(l).addScaledVector(Yo,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var js=class extends Tu{constructor(t=10,e=10,n=4473924,r=8947848){n=new he(n),r=new he(r);let s=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,m=-a;f<=e;f++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let y=f===s?n:r;y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3}let u=new sn;u.setAttribute("position",new Xe(l,3)),u.setAttribute("color",new Xe(c,3));let h=new ra({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Sl=class extends Qi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Qp(i,t,e,n){let r=EE(n);switch(e){case kp:return i*t;case zp:return i*t/r.components*r.byteLength;case Zu:return i*t/r.components*r.byteLength;case Ms:return i*t*2/r.components*r.byteLength;case Ku:return i*t*2/r.components*r.byteLength;case Bp:return i*t*3/r.components*r.byteLength;case sr:return i*t*4/r.components*r.byteLength;case Ju:return i*t*4/r.components*r.byteLength;case El:case Tl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Rl:case Cl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case th:case nh:return Math.max(i,16)*Math.max(t,8)/4;case Qu:case eh:return Math.max(i,8)*Math.max(t,8)/2;case ih:case rh:case oh:case ah:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case sh:case Pl:case lh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ch:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case uh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case hh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case fh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case dh:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case ph:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case mh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case gh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case yh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case xh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case vh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case _h:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case bh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case wh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Mh:case Sh:case Ah:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Eh:case Th:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Il:case Rh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function EE(i){switch(i){case di:case Np:return{byteLength:1,components:1};case ha:case Dp:case rr:return{byteLength:2,components:1};case ju:case Yu:return{byteLength:2,components:4};case nr:case Xu:case ir:return{byteLength:4,components:1};case Op:case Up:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Yt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function O_(){let i=null,t=!1,e=null,n=null;function r(s,o){n=i.requestAnimationFrame(r),e(s,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(r),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(s){e=s},setContext:function(s){i=s}}}function LE(i){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<h.length;d++){let m=h[f],y=h[d];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,m=h.length;d<m;d++){let y=h[d];i.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var FE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,NE=`#ifdef USE_ALPHAHASH
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
#endif`,DE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,OE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,UE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,kE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,BE=`#ifdef USE_AOMAP
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
#endif`,zE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,VE=`#ifdef USE_BATCHING
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
#endif`,GE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,HE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,WE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,qE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,$E=`#ifdef USE_IRIDESCENCE
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
#endif`,XE=`#ifdef USE_BUMPMAP
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
#endif`,jE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,YE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,ZE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,KE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,JE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,QE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,tT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,eT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,nT=`#define PI 3.141592653589793
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
} // validated`,iT=`vec3 transformedNormal = objectNormal;
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
#endif`,rT=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,sT=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,oT=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,aT=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,lT="gl_FragColor = linearToOutputTexel( gl_FragColor );",cT=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,uT=`#ifdef USE_ENVMAP
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
#endif`,hT=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,fT=`#ifdef USE_ENVMAP
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
#endif`,dT=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,pT=`#ifdef USE_ENVMAP
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
#endif`,mT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,gT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,yT=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,xT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,vT=`#ifdef USE_GRADIENTMAP
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
}`,_T=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,bT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,wT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,MT=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,ST=`#ifdef USE_ENVMAP
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
#endif`,AT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ET=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,TT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,RT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,CT=`PhysicalMaterial material;
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
#endif`,PT=`uniform sampler2D dfgLUT;
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
}`,IT=`
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
#endif`,LT=`#if defined( RE_IndirectDiffuse )
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
#endif`,FT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,NT=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,DT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,OT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,UT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,BT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,zT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,VT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,GT=`#if defined( USE_POINTS_UV )
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
#endif`,HT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,WT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,qT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,$T=`#if defined( USE_MORPHCOLORS )
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
#endif`,XT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jT=`#ifdef USE_MORPHTARGETS
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
#endif`,YT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ZT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,KT=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,JT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,QT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,tR=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,eR=`#ifdef USE_NORMALMAP
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
#endif`,nR=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,iR=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,rR=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,sR=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,oR=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,aR=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,lR=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,cR=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,uR=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,hR=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,fR=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,dR=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,pR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,mR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,gR=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,yR=`float getShadowMask() {
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
}`,xR=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,vR=`#ifdef USE_SKINNING
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
#endif`,_R=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,bR=`#ifdef USE_SKINNING
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
#endif`,wR=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,MR=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,SR=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,AR=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ER=`#ifdef USE_TRANSMISSION
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
#endif`,TR=`#ifdef USE_TRANSMISSION
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
#endif`,RR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,CR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,PR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,IR=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,LR=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,FR=`uniform sampler2D t2D;
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
}`,NR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,DR=`uniform float backgroundBlurriness;
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
}`,OR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,UR=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kR=`#include <common>
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
}`,BR=`#if DEPTH_PACKING == 3200
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
}`,zR=`#define DISTANCE
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
}`,VR=`#define DISTANCE
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
}`,GR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,HR=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,WR=`uniform float scale;
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
}`,qR=`uniform vec3 diffuse;
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
}`,$R=`#include <common>
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
}`,XR=`uniform vec3 diffuse;
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
}`,jR=`#define LAMBERT
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
}`,YR=`#define LAMBERT
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
}`,ZR=`#define MATCAP
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
}`,KR=`#define MATCAP
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
}`,JR=`#define NORMAL
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
}`,QR=`#define NORMAL
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
}`,tC=`#define PHONG
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
}`,eC=`#define PHONG
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
}`,nC=`#define STANDARD
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
}`,iC=`#define STANDARD
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
}`,rC=`#define TOON
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
}`,sC=`#define TOON
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
}`,oC=`uniform float size;
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
}`,aC=`uniform vec3 diffuse;
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
}`,lC=`#include <common>
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
}`,cC=`uniform vec3 color;
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
}`,uC=`uniform float rotation;
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
}`,hC=`uniform vec3 diffuse;
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
}`,pe={alphahash_fragment:FE,alphahash_pars_fragment:NE,alphamap_fragment:DE,alphamap_pars_fragment:OE,alphatest_fragment:UE,alphatest_pars_fragment:kE,aomap_fragment:BE,aomap_pars_fragment:zE,batching_pars_vertex:VE,batching_vertex:GE,begin_vertex:HE,beginnormal_vertex:WE,bsdfs:qE,iridescence_fragment:$E,bumpmap_pars_fragment:XE,clipping_planes_fragment:jE,clipping_planes_pars_fragment:YE,clipping_planes_pars_vertex:ZE,clipping_planes_vertex:KE,color_fragment:JE,color_pars_fragment:QE,color_pars_vertex:tT,color_vertex:eT,common:nT,defaultnormal_vertex:iT,displacementmap_pars_vertex:rT,displacementmap_vertex:sT,emissivemap_fragment:oT,emissivemap_pars_fragment:aT,colorspace_fragment:lT,colorspace_pars_fragment:cT,envmap_fragment:uT,envmap_common_pars_fragment:hT,envmap_pars_fragment:fT,envmap_pars_vertex:dT,envmap_physical_pars_fragment:ST,envmap_vertex:pT,fog_vertex:mT,fog_pars_vertex:gT,fog_fragment:yT,fog_pars_fragment:xT,gradientmap_pars_fragment:vT,lightmap_pars_fragment:_T,lights_lambert_fragment:bT,lights_lambert_pars_fragment:wT,lights_pars_begin:MT,lights_toon_fragment:AT,lights_toon_pars_fragment:ET,lights_phong_fragment:TT,lights_phong_pars_fragment:RT,lights_physical_fragment:CT,lights_physical_pars_fragment:PT,lights_fragment_begin:IT,lights_fragment_maps:LT,lights_fragment_end:FT,lightprobes_pars_fragment:NT,logdepthbuf_fragment:DT,logdepthbuf_pars_fragment:OT,logdepthbuf_pars_vertex:UT,logdepthbuf_vertex:kT,map_fragment:BT,map_pars_fragment:zT,map_particle_fragment:VT,map_particle_pars_fragment:GT,metalnessmap_fragment:HT,metalnessmap_pars_fragment:WT,morphinstance_vertex:qT,morphcolor_vertex:$T,morphnormal_vertex:XT,morphtarget_pars_vertex:jT,morphtarget_vertex:YT,normal_fragment_begin:ZT,normal_fragment_maps:KT,normal_pars_fragment:JT,normal_pars_vertex:QT,normal_vertex:tR,normalmap_pars_fragment:eR,clearcoat_normal_fragment_begin:nR,clearcoat_normal_fragment_maps:iR,clearcoat_pars_fragment:rR,iridescence_pars_fragment:sR,opaque_fragment:oR,packing:aR,premultiplied_alpha_fragment:lR,project_vertex:cR,dithering_fragment:uR,dithering_pars_fragment:hR,roughnessmap_fragment:fR,roughnessmap_pars_fragment:dR,shadowmap_pars_fragment:pR,shadowmap_pars_vertex:mR,shadowmap_vertex:gR,shadowmask_pars_fragment:yR,skinbase_vertex:xR,skinning_pars_vertex:vR,skinning_vertex:_R,skinnormal_vertex:bR,specularmap_fragment:wR,specularmap_pars_fragment:MR,tonemapping_fragment:SR,tonemapping_pars_fragment:AR,transmission_fragment:ER,transmission_pars_fragment:TR,uv_pars_fragment:RR,uv_pars_vertex:CR,uv_vertex:PR,worldpos_vertex:IR,background_vert:LR,background_frag:FR,backgroundCube_vert:NR,backgroundCube_frag:DR,cube_vert:OR,cube_frag:UR,depth_vert:kR,depth_frag:BR,distance_vert:zR,distance_frag:VR,equirect_vert:GR,equirect_frag:HR,linedashed_vert:WR,linedashed_frag:qR,meshbasic_vert:$R,meshbasic_frag:XR,meshlambert_vert:jR,meshlambert_frag:YR,meshmatcap_vert:ZR,meshmatcap_frag:KR,meshnormal_vert:JR,meshnormal_frag:QR,meshphong_vert:tC,meshphong_frag:eC,meshphysical_vert:nC,meshphysical_frag:iC,meshtoon_vert:rC,meshtoon_frag:sC,points_vert:oC,points_frag:aC,shadow_vert:lC,shadow_frag:cC,sprite_vert:uC,sprite_frag:hC},Pt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},ui={basic:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.fog]),vertexShader:pe.meshbasic_vert,fragmentShader:pe.meshbasic_frag},lambert:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,Pt.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:pe.meshlambert_vert,fragmentShader:pe.meshlambert_frag},phong:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,Pt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pe.meshphong_vert,fragmentShader:pe.meshphong_frag},standard:{uniforms:Kn([Pt.common,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.roughnessmap,Pt.metalnessmap,Pt.fog,Pt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag},toon:{uniforms:Kn([Pt.common,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.gradientmap,Pt.fog,Pt.lights,{emissive:{value:new he(0)}}]),vertexShader:pe.meshtoon_vert,fragmentShader:pe.meshtoon_frag},matcap:{uniforms:Kn([Pt.common,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,{matcap:{value:null}}]),vertexShader:pe.meshmatcap_vert,fragmentShader:pe.meshmatcap_frag},points:{uniforms:Kn([Pt.points,Pt.fog]),vertexShader:pe.points_vert,fragmentShader:pe.points_frag},dashed:{uniforms:Kn([Pt.common,Pt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pe.linedashed_vert,fragmentShader:pe.linedashed_frag},depth:{uniforms:Kn([Pt.common,Pt.displacementmap]),vertexShader:pe.depth_vert,fragmentShader:pe.depth_frag},normal:{uniforms:Kn([Pt.common,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,{opacity:{value:1}}]),vertexShader:pe.meshnormal_vert,fragmentShader:pe.meshnormal_frag},sprite:{uniforms:Kn([Pt.sprite,Pt.fog]),vertexShader:pe.sprite_vert,fragmentShader:pe.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pe.background_vert,fragmentShader:pe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:pe.backgroundCube_vert,fragmentShader:pe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pe.cube_vert,fragmentShader:pe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pe.equirect_vert,fragmentShader:pe.equirect_frag},distance:{uniforms:Kn([Pt.common,Pt.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pe.distance_vert,fragmentShader:pe.distance_frag},shadow:{uniforms:Kn([Pt.lights,Pt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:pe.shadow_vert,fragmentShader:pe.shadow_frag}};ui.physical={uniforms:Kn([ui.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag};var Ph={r:0,b:0,g:0},fC=new $e,U_=new se;U_.set(-1,0,0,0,1,0,0,0,1);function dC(i,t,e,n,r,s){let o=new he(0),a=r===!0?0:1,l,c,u=null,h=0,f=null;function d(x){let b=x.isScene===!0?x.background:null;if(b&&b.isTexture){let v=x.backgroundBlurriness>0;b=t.get(b,v)}return b}function m(x){let b=!1,v=d(x);v===null?g(o,a):v&&v.isColor&&(g(v,1),b=!0);let S=i.xr.getEnvironmentBlendMode();S==="additive"?e.buffers.color.setClear(0,0,0,1,s):S==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,s),(i.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(x,b){let v=d(b);v&&v.isCubeTexture?(c===void 0&&(c=new Ge(new ps(1,1,1),new zi({name:"BackgroundCubeMaterial",uniforms:to(ui.backgroundCube.uniforms),vertexShader:ui.backgroundCube.vertexShader,fragmentShader:ui.backgroundCube.fragmentShader,side:ci,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(S,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(fC.makeRotationFromEuler(b.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(U_),c.material.toneMapped=be.getTransfer(v.colorSpace)!==Ie,(u!==v||h!==v.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,f=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Ge(new $s(2,2),new zi({name:"BackgroundMaterial",uniforms:to(ui.background.uniforms),vertexShader:ui.background.vertexShader,fragmentShader:ui.background.fragmentShader,side:ws,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=be.getTransfer(v.colorSpace)!==Ie,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,f=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,b){x.getRGB(Ph,Zp(i)),e.buffers.color.setClear(Ph.r,Ph.g,Ph.b,b,s)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,b=1){o.set(x),a=b,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:m,addToRenderList:y,dispose:p}}function pC(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=f(null),s=r,o=!1;function a(I,U,z,C,O){let W=!1,G=h(I,C,z,U);s!==G&&(s=G,c(s.object)),W=d(I,C,z,O),W&&m(I,C,z,O),O!==null&&t.update(O,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,v(I,U,z,C),O!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(O).buffer))}function l(){return i.createVertexArray()}function c(I){return i.bindVertexArray(I)}function u(I){return i.deleteVertexArray(I)}function h(I,U,z,C){let O=C.wireframe===!0,W=n[U.id];W===void 0&&(W={},n[U.id]=W);let G=I.isInstancedMesh===!0?I.id:0,et=W[G];et===void 0&&(et={},W[G]=et);let $=et[z.id];$===void 0&&($={},et[z.id]=$);let X=$[O];return X===void 0&&(X=f(l()),$[O]=X),X}function f(I){let U=[],z=[],C=[];for(let O=0;O<e;O++)U[O]=0,z[O]=0,C[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:z,attributeDivisors:C,object:I,attributes:{},index:null}}function d(I,U,z,C){let O=s.attributes,W=U.attributes,G=0,et=z.getAttributes();for(let $ in et)if(et[$].location>=0){let tt=O[$],ht=W[$];if(ht===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(ht=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(ht=I.instanceColor)),tt===void 0||tt.attribute!==ht||ht&&tt.data!==ht.data)return!0;G++}return s.attributesNum!==G||s.index!==C}function m(I,U,z,C){let O={},W=U.attributes,G=0,et=z.getAttributes();for(let $ in et)if(et[$].location>=0){let tt=W[$];tt===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(tt=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(tt=I.instanceColor));let ht={};ht.attribute=tt,tt&&tt.data&&(ht.data=tt.data),O[$]=ht,G++}s.attributes=O,s.attributesNum=G,s.index=C}function y(){let I=s.newAttributes;for(let U=0,z=I.length;U<z;U++)I[U]=0}function g(I){p(I,0)}function p(I,U){let z=s.newAttributes,C=s.enabledAttributes,O=s.attributeDivisors;z[I]=1,C[I]===0&&(i.enableVertexAttribArray(I),C[I]=1),O[I]!==U&&(i.vertexAttribDivisor(I,U),O[I]=U)}function x(){let I=s.newAttributes,U=s.enabledAttributes;for(let z=0,C=U.length;z<C;z++)U[z]!==I[z]&&(i.disableVertexAttribArray(z),U[z]=0)}function b(I,U,z,C,O,W,G){G===!0?i.vertexAttribIPointer(I,U,z,O,W):i.vertexAttribPointer(I,U,z,C,O,W)}function v(I,U,z,C){y();let O=C.attributes,W=z.getAttributes(),G=U.defaultAttributeValues;for(let et in W){let $=W[et];if($.location>=0){let X=O[et];if(X===void 0&&(et==="instanceMatrix"&&I.instanceMatrix&&(X=I.instanceMatrix),et==="instanceColor"&&I.instanceColor&&(X=I.instanceColor)),X!==void 0){let tt=X.normalized,ht=X.itemSize,ct=t.get(X);if(ct===void 0)continue;let J=ct.buffer,dt=ct.type,gt=ct.bytesPerElement,bt=dt===i.INT||dt===i.UNSIGNED_INT||X.gpuType===Xu;if(X.isInterleavedBufferAttribute){let yt=X.data,Gt=yt.isInterleavedBuffer===!0?yt.stride:yt.itemSize,Kt=X.offset;if(yt.isInstancedInterleavedBuffer||yt.isInstancedBufferAttribute){for(let zt=0;zt<$.locationSize;zt++)p($.location+zt,yt.meshPerAttribute);I.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=yt.meshPerAttribute*yt.count)}else for(let zt=0;zt<$.locationSize;zt++)g($.location+zt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let zt=0;zt<$.locationSize;zt++)b($.location+zt,ht/$.locationSize,dt,tt,Gt*gt,(Kt+ht/$.locationSize*zt)*gt,bt)}else{if(X.isInstancedBufferAttribute){for(let yt=0;yt<$.locationSize;yt++)p($.location+yt,X.meshPerAttribute);I.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=X.meshPerAttribute*X.count)}else for(let yt=0;yt<$.locationSize;yt++)g($.location+yt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let yt=0;yt<$.locationSize;yt++)b($.location+yt,ht/$.locationSize,dt,tt,ht*gt,ht/$.locationSize*yt*gt,bt)}}else if(G!==void 0){let tt=G[et];if(tt!==void 0)switch(tt.length){case 2:i.vertexAttrib2fv($.location,tt);break;case 3:i.vertexAttrib3fv($.location,tt);break;case 4:i.vertexAttrib4fv($.location,tt);break;default:i.vertexAttrib1fv($.location,tt)}}}}x()}function S(){N();for(let I in n){let U=n[I];for(let z in U){let C=U[z];for(let O in C){let W=C[O];for(let G in W)u(W[G].object),delete W[G];delete C[O]}}delete n[I]}}function A(I){if(n[I.id]===void 0)return;let U=n[I.id];for(let z in U){let C=U[z];for(let O in C){let W=C[O];for(let G in W)u(W[G].object),delete W[G];delete C[O]}}delete n[I.id]}function _(I){for(let U in n){let z=n[U];for(let C in z){let O=z[C];if(O[I.id]===void 0)continue;let W=O[I.id];for(let G in W)u(W[G].object),delete W[G];delete O[I.id]}}}function w(I){for(let U in n){let z=n[U],C=I.isInstancedMesh===!0?I.id:0,O=z[C];if(O!==void 0){for(let W in O){let G=O[W];for(let et in G)u(G[et].object),delete G[et];delete O[W]}delete z[C],Object.keys(z).length===0&&delete n[U]}}}function N(){P(),o=!0,s!==r&&(s=r,c(s.object))}function P(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:N,resetDefaultState:P,dispose:S,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:g,disableUnusedAttributes:x}}function mC(i,t,e){let n;function r(l){n=l}function s(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),e.update(c,n,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];e.update(f,n,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function gC(i,t,e,n){let r;function s(){if(r!==void 0)return r;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");r=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(_){return!(_!==sr&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let w=_===rr&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==di&&_!==ir&&!w&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Yt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&Yt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&Yt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),b=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),S=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:x,maxVaryings:b,maxFragmentUniforms:v,maxSamples:S,samples:A}}function yC(i){let t=this,e=null,n=0,r=!1,s=!1,o=new Ti,a=new se,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||r;return r=f,n=h.length,d},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){let m=h.clippingPlanes,y=h.clipIntersection,g=h.clipShadows,p=i.get(h);if(!r||m===null||m.length===0||s&&!g)s?u(null):c();else{let x=s?0:n,b=x*4,v=p.clippingState||null;l.value=v,v=u(m,f,b,d);for(let S=0;S!==b;++S)v[S]=e[S];p.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,d,m){let y=h!==null?h.length:0,g=null;if(y!==0){if(g=l.value,m!==!0||g===null){let p=d+y*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<p)&&(g=new Float32Array(p));for(let b=0,v=d;b!==y;++b,v+=4)o.copy(h[b]).applyMatrix4(x,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,g}}var Ul=class extends Ri{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},r=[n,n,n,n,n,n];this.texture=new ll(r),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new ps(5,5,5),s=new zi({name:"CubemapFromEquirect",uniforms:to(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ci,blending:Zs});s.uniforms.tEquirect.value=e;let o=new Ge(r,s),a=e.minFilter;return e.minFilter===Wr&&(e.minFilter=ai),new aa(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,r=!0){let s=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,r);t.setRenderTarget(s)}},m_=256,xC=3,vC=20,k_=256,B_=16,_C=3,bC=new V,wC=new he,Lh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new aa(1,10,null),this._boxMesh=new Ge(new ps(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,r=100,s={}){let{size:o=256,position:a=bC}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(wC));let g=new aa(n,r,u);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=m,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=x_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=y_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(m_,Xp(t))}_fromTexture(t,e){t.mapping===Js||t.mapping===ua?this._setSize(t.image.length===0?m_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=g_(t,!1,!1),n=Math.log2(t)-xC;for(let r=0;r<=n;r++)e.texture.mipmaps.push({width:t>>r,height:t>>r});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=g_(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=t,s.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),s.update(this._renderer,r),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Js||t.mapping===ua?(this._cubemapMaterial===null&&(this._cubemapMaterial=x_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=y_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=MC(),this._integrationMaterial=SC());let e=this._cubeSize,n=t.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(e/B_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-_C)s.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(k_*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=AC());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(t,0,n),r.envMap.value=t.texture,this._renderCube(s,0,n)}};function g_(i,t,e){return new Ul(i,{minFilter:Wr,generateMipmaps:t,type:rr,colorSpace:Ja,depthBuffer:e})}function kl(i,t,e){return new zi({name:i,uniforms:t,vertexShader:pe.cube_vert,fragmentShader:e,side:ci,blending:Zs,depthTest:!1,depthWrite:!1})}function MC(){return kl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${k_}u

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
	`)}function SC(){return kl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:B_}},`

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
	`)}function AC(){return kl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${vC}
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
	`)}function y_(){return kl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function x_(){return kl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function EC(i){let t=new WeakMap,e=new WeakMap,n=null;function r(f,d=!1){return f==null?null:d?o(f):s(f)}function s(f){if(f&&f.isTexture){let d=f.mapping;if(d===Wu||d===qu)if(t.has(f)){let m=t.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let y=new Ul(m.height);return y.fromEquirectangularTexture(i,f),t.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,m=d===Wu||d===qu,y=d===Js||d===ua;if(m||y){let g=e.get(f),p=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return n===null&&(n=new Lh(i)),g=m?n.fromEquirectangular(f,g):n.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),g.texture;if(g!==void 0)return g.texture;{let x=f.image;return m&&x&&x.height>0||y&&x&&l(x)?(n===null&&(n=new Lh(i)),g=m?n.fromEquirectangular(f):n.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===Wu?f.mapping=Js:d===qu&&(f.mapping=ua),f}function l(f){let d=0,m=6;for(let y=0;y<m;y++)f[y]!==void 0&&d++;return d===m}function c(f){let d=f.target;d.removeEventListener("dispose",c);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function h(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:h}}function TC(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let r=i.getExtension(n);return t[n]=r,r}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let r=e(n);return r===null&&ja("WebGLRenderer: "+n+" extension not supported."),r}}}function RC(i,t,e,n){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let y=s.get(m);y&&(t.remove(y),s.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,y){return r[y.id]!==void 0||(y.addEventListener("dispose",a),r[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(m){let y=m.attributes;for(let g in y)t.update(y[g],i.ARRAY_BUFFER)}function h(m){let y=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let x=y!==null?y.array.length:g.array.length/3-1,b=g.count>=65535?ol:sl,v=new b(Math.ceil(x/3)*6,1),S=v.array;if(y!==null){let _=y.array;p=y.version;for(let w=0,N=0;w<x;w+=3){let P=_[w+0],I=_[w+1],U=_[w+2];S[N++]=P,S[N++]=I,S[N++]=I,S[N++]=U,S[N++]=U,S[N++]=P}}else{p=g.version;for(let _=0,w=0;_<x;_+=3){let N=_+0,P=_+1,I=_+2;S[w++]=N,S[w++]=P,S[w++]=P,S[w++]=I,S[w++]=I,S[w++]=N}}v.version=p;let A=s.get(m);A&&t.remove(A),s.set(m,v)}function f(m){let y=s.get(m);if(y){let g=m.index;g!==null&&y.version<g.version&&h(m)}else h(m);return s.get(m)}function d(){for(let m in r){let y=r[m].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function CC(i,t,e){let n;function r(h){n=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,f){i.drawElements(n,f,s,h*o),e.update(f,n,1)}function c(h,f,d){d!==0&&(i.drawElementsInstanced(n,f,s,h*o,d),e.update(f,n,d))}function u(h,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,s,h,0,d);let y=0;for(let g=0;g<d;g++)y+=f[g];e.update(y,n,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function PC(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(s/3);break;case i.LINES:e.lines+=a*(s/2);break;case i.LINE_STRIP:e.lines+=a*(s-1);break;case i.LINE_LOOP:e.lines+=a*s;break;case i.POINTS:e.points+=a*s;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function r(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:r,update:n}}function IC(i,t,e){let n=new WeakMap,r=new Le;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let N=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",N)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],b=0;d===!0&&(b=1),m===!0&&(b=2),y===!0&&(b=3);let v=a.attributes.position.count*b,S=1;v>t.maxTextureSize&&(S=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let A=new Float32Array(v*S*4*h),_=new nl(A,v,S,h);_.type=ir,_.needsUpdate=!0;let w=b*4;for(let P=0;P<h;P++){let I=g[P],U=p[P],z=x[P],C=v*S*4*P;for(let O=0;O<I.count;O++){let W=O*w;d===!0&&(r.fromBufferAttribute(I,O),A[C+W+0]=r.x,A[C+W+1]=r.y,A[C+W+2]=r.z,A[C+W+3]=0),m===!0&&(r.fromBufferAttribute(U,O),A[C+W+4]=r.x,A[C+W+5]=r.y,A[C+W+6]=r.z,A[C+W+7]=0),y===!0&&(r.fromBufferAttribute(z,O),A[C+W+8]=r.x,A[C+W+9]=r.y,A[C+W+10]=r.z,A[C+W+11]=z.itemSize===4?r.w:1)}}f={count:h,texture:_,size:new Zt(v,S)},n.set(a,f),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:s}}function LC(i,t,e,n,r){let s=new WeakMap;function o(c){let u=r.render.frame,h=c.geometry,f=t.get(c,h);if(s.get(f)!==u&&(t.update(f),s.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;s.get(d)!==u&&(d.update(),s.set(d,u))}return f}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var FC={[Ep]:"LINEAR_TONE_MAPPING",[Tp]:"REINHARD_TONE_MAPPING",[Rp]:"CINEON_TONE_MAPPING",[Cp]:"ACES_FILMIC_TONE_MAPPING",[Ip]:"AGX_TONE_MAPPING",[Lp]:"NEUTRAL_TONE_MAPPING",[Pp]:"CUSTOM_TONE_MAPPING"};function NC(i,t,e,n,r,s){let o=new Ri(t,e,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new sn;u.setAttribute("position",new Xe([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Xe([0,2,0,0,2,0],2));let h=new Ru({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Ge(u,h),d=new _l(-1,1,1,-1,0,1),m=null,y=null,g=!1,p,x=null,b=[],v=!1;this.setSize=function(S,A){o.setSize(S,A),a!==null&&a.setSize(S,A),l!==null&&l.setSize(S,A);for(let _=0;_<b.length;_++){let w=b[_];w.setSize&&w.setSize(S,A)}},this.setEffects=function(S){b=S,v=b.length>0&&b[0].isRenderPass===!0;let A=o.width,_=o.height;b.length>0&&a===null&&(a=new Ri(A,_,{type:rr,depthBuffer:!1,stencilBuffer:!1}),l=new Ri(A,_,{type:rr,depthBuffer:!1,stencilBuffer:!1}));let w=r===!0&&b.some(N=>N.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Hr(A,_),s===!0&&(c.format=qr,c.type=Qs)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let N=0;N<b.length;N++){let P=b[N];P.setSize&&P.setSize(A,_),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(S,A){if(g||S.toneMapping===br&&b.length===0)return!1;if(x=A,A!==null){let _=A.width,w=A.height;(o.width!==_||o.height!==w)&&this.setSize(_,w)}return v===!1&&S.setRenderTarget(o),p=S.toneMapping,S.toneMapping=br,!0},this.hasRenderPass=function(){return v},this.end=function(S,A){S.toneMapping=p,g=!0;let _=o,w=a;for(let N=0;N<b.length;N++){let P=b[N];P.enabled!==!1&&(P.render(S,w,_,A),P.needsSwap!==!1&&(_=w,w=w===a?l:a))}if(m!==S.outputColorSpace||y!==S.toneMapping){m=S.outputColorSpace,y=S.toneMapping,h.defines={},be.getTransfer(m)===Ie&&(h.defines.SRGB_TRANSFER="");let N=FC[y];N&&(h.defines[N]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,S.setRenderTarget(x),S.render(f,d),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var z_=new fi,V_=new Hr(1,1),G_=new cl(1),H_=new nl,W_=new wu,q_=new ll,v_=[],__=[],b_=new Float32Array(16),w_=new Float32Array(9),M_=new Float32Array(4);function da(i,t,e){let n=i[0];if(n<=0||n>0)return i;let r=t*e,s=v_[r];if(s===void 0&&(s=new Float32Array(r),v_[r]=s),t!==0){n.toArray(s,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(s,a)}return s}function Cn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Pn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Nh(i,t){let e=__[t];e===void 0&&(e=new Int32Array(t),__[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function DC(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function OC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2fv(this.addr,t),Pn(e,t)}}function UC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Cn(e,t))return;i.uniform3fv(this.addr,t),Pn(e,t)}}function kC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4fv(this.addr,t),Pn(e,t)}}function BC(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Pn(e,t)}else{if(Cn(e,n))return;M_.set(n),i.uniformMatrix2fv(this.addr,!1,M_),Pn(e,n)}}function zC(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Pn(e,t)}else{if(Cn(e,n))return;w_.set(n),i.uniformMatrix3fv(this.addr,!1,w_),Pn(e,n)}}function VC(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Pn(e,t)}else{if(Cn(e,n))return;b_.set(n),i.uniformMatrix4fv(this.addr,!1,b_),Pn(e,n)}}function GC(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function HC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2iv(this.addr,t),Pn(e,t)}}function WC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Cn(e,t))return;i.uniform3iv(this.addr,t),Pn(e,t)}}function qC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4iv(this.addr,t),Pn(e,t)}}function $C(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function XC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2uiv(this.addr,t),Pn(e,t)}}function jC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Cn(e,t))return;i.uniform3uiv(this.addr,t),Pn(e,t)}}function YC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4uiv(this.addr,t),Pn(e,t)}}function Dh(i){return i.version===0&&(i.compareFunction=Hp,i.needsUpdate=!0),i}function ZC(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=Dh(V_):s=z_,e.setTexture2D(t||s,r)}function KC(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),e.setTexture3D(t||W_,r)}function JC(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=Dh(G_):s=q_,e.setTextureCube(t||s,r)}function QC(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),e.setTexture2DArray(t||H_,r)}function t2(i){switch(i){case 5126:return DC;case 35664:return OC;case 35665:return UC;case 35666:return kC;case 35674:return BC;case 35675:return zC;case 35676:return VC;case 5124:case 35670:return GC;case 35667:case 35671:return HC;case 35668:case 35672:return WC;case 35669:case 35673:return qC;case 5125:return $C;case 36294:return XC;case 36295:return jC;case 36296:return YC;case 35678:case 36198:case 36298:case 36306:case 35682:return ZC;case 35679:case 36299:case 36307:return KC;case 35680:case 36300:case 36308:case 36293:return JC;case 36289:case 36303:case 36311:case 36292:return QC}}function e2(i,t){i.uniform1fv(this.addr,t)}function n2(i,t){let e=da(t,this.size,2);i.uniform2fv(this.addr,e)}function i2(i,t){let e=da(t,this.size,3);i.uniform3fv(this.addr,e)}function r2(i,t){let e=da(t,this.size,4);i.uniform4fv(this.addr,e)}function s2(i,t){let e=da(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function o2(i,t){let e=da(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function a2(i,t){let e=da(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function l2(i,t){i.uniform1iv(this.addr,t)}function c2(i,t){i.uniform2iv(this.addr,t)}function u2(i,t){i.uniform3iv(this.addr,t)}function h2(i,t){i.uniform4iv(this.addr,t)}function f2(i,t){i.uniform1uiv(this.addr,t)}function d2(i,t){i.uniform2uiv(this.addr,t)}function p2(i,t){i.uniform3uiv(this.addr,t)}function m2(i,t){i.uniform4uiv(this.addr,t)}function g2(i,t,e){let n=this.cache,r=t.length,s=Nh(e,r);Cn(n,s)||(i.uniform1iv(this.addr,s),Pn(n,s));let o;this.type===i.SAMPLER_2D_SHADOW?o=Dh(V_):o=z_;for(let a=0;a!==r;++a)e.setTexture2D(t[a]||o,s[a])}function y2(i,t,e){let n=this.cache,r=t.length,s=Nh(e,r);Cn(n,s)||(i.uniform1iv(this.addr,s),Pn(n,s));for(let o=0;o!==r;++o)e.setTexture3D(t[o]||W_,s[o])}function x2(i,t,e){let n=this.cache,r=t.length,s=Nh(e,r);Cn(n,s)||(i.uniform1iv(this.addr,s),Pn(n,s));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Dh(G_):o=q_;for(let a=0;a!==r;++a)e.setTextureCube(t[a]||o,s[a])}function v2(i,t,e){let n=this.cache,r=t.length,s=Nh(e,r);Cn(n,s)||(i.uniform1iv(this.addr,s),Pn(n,s));for(let o=0;o!==r;++o)e.setTexture2DArray(t[o]||H_,s[o])}function _2(i){switch(i){case 5126:return e2;case 35664:return n2;case 35665:return i2;case 35666:return r2;case 35674:return s2;case 35675:return o2;case 35676:return a2;case 5124:case 35670:return l2;case 35667:case 35671:return c2;case 35668:case 35672:return u2;case 35669:case 35673:return h2;case 5125:return f2;case 36294:return d2;case 36295:return p2;case 36296:return m2;case 35678:case 36198:case 36298:case 36306:case 35682:return g2;case 35679:case 36299:case 36307:return y2;case 35680:case 36300:case 36308:case 36293:return x2;case 36289:case 36303:case 36311:case 36292:return v2}}var nm=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=t2(e.type)}},im=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=_2(e.type)}},rm=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(t,e[a.id],n)}}},tm=/(\w+)(\])?(\[|\.)?/g;function S_(i,t){i.seq.push(t),i.map[t.id]=t}function b2(i,t,e){let n=i.name,r=n.length;for(tm.lastIndex=0;;){let s=tm.exec(n),o=tm.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){S_(e,c===void 0?new nm(a,i,t):new im(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new rm(a),S_(e,h)),e=h}}}var fa=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);b2(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(t,e,n,r){let s=this.map[e];s!==void 0&&s.setValue(t,n,r)}setOptional(t,e,n){let r=e[n];r!==void 0&&this.setValue(t,n,r)}static upload(t,e,n,r){for(let s=0,o=e.length;s!==o;++s){let a=e[s],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,r)}}static seqWithValue(t,e){let n=[];for(let r=0,s=t.length;r!==s;++r){let o=t[r];o.id in e&&n.push(o)}return n}};function A_(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var w2=37297,M2=0;function S2(i,t){let e=i.split(`
`),n=[],r=Math.max(t-6,0),s=Math.min(t+6,e.length);for(let o=r;o<s;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var E_=new se;function A2(i){be._getMatrix(E_,be.workingColorSpace,i);let t=`mat3( ${E_.elements.map(e=>e.toFixed(4))} )`;switch(be.getTransfer(i)){case Qa:return[t,"LinearTransferOETF"];case Ie:return[t,"sRGBTransferOETF"];default:return Yt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function T_(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),s=(i.getShaderInfoLog(t)||"").trim();if(n&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+s+`

`+S2(i.getShaderSource(t),a)}else return s}function E2(i,t){let e=A2(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var T2={[Ep]:"Linear",[Tp]:"Reinhard",[Rp]:"Cineon",[Cp]:"ACESFilmic",[Ip]:"AgX",[Lp]:"Neutral",[Pp]:"Custom"};function R2(i,t){let e=T2[t];return e===void 0?(Yt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Ih=new V;function C2(){be.getLuminanceCoefficients(Ih);let i=Ih.x.toFixed(4),t=Ih.y.toFixed(4),e=Ih.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function P2(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ol).join(`
`)}function I2(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function L2(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(t,r),o=s.name,a=1;s.type===i.FLOAT_MAT2&&(a=2),s.type===i.FLOAT_MAT3&&(a=3),s.type===i.FLOAT_MAT4&&(a=4),e[o]={type:s.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ol(i){return i!==""}function R_(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function C_(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var F2=/^[ \t]*#include +<([\w\d./]+)>/gm;function sm(i){return i.replace(F2,N2)}function N2(i,t){let e=pe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return sm(e)}var D2=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function P_(i){return i.replace(D2,O2)}function O2(i,t,e,n){let r="";for(let s=parseInt(t);s<parseInt(e);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function I_(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var U2={[Ys]:"SHADOWMAP_TYPE_PCF",[la]:"SHADOWMAP_TYPE_VSM"};function k2(i){return U2[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var B2={[ua]:"ENVMAP_MODE_REFRACTION"};function z2(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":B2[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var V2={[Hu]:"ENVMAP_BLENDING_MULTIPLY",[Kv]:"ENVMAP_BLENDING_MIX",[Jv]:"ENVMAP_BLENDING_ADD"};function G2(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":V2[i.combine]||"ENVMAP_BLENDING_NONE"}function H2(i,t,e,n){let r=i.getContext(),s=e.defines,o=e.vertexShader,a=e.fragmentShader,l=k2(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=z2(e),h=G2(e),f=P2(e),d=I2(s),m=r.createProgram(),y,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ol).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ol).join(`
`),g.length>0&&(g+=`
`)):(y=[I_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ol).join(`
`),g=[I_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==br?"#define TONE_MAPPING":"",e.toneMapping!==br?pe.tonemapping_pars_fragment:"",e.toneMapping!==br?R2("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",pe.colorspace_pars_fragment,E2("linearToOutputTexel",e.outputColorSpace),C2(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ol).join(`
`)),o=sm(o),o=R_(o,e),o=C_(o,e),a=sm(a),a=R_(a,e),a=C_(a,e),o=P_(o),a=P_(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",e.glslVersion===qp?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===qp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=p+y+o,b=p+g+a,v=A_(r,r.VERTEX_SHADER,x),S=A_(r,r.FRAGMENT_SHADER,b);r.attachShader(m,v),r.attachShader(m,S),e.index0AttributeName!==void 0?r.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function A(P){if(i.debug.checkShaderErrors){let I=r.getProgramInfoLog(m)||"",U=r.getShaderInfoLog(v)||"",z=r.getShaderInfoLog(S)||"",C=I.trim(),O=U.trim(),W=z.trim(),G=!0,et=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,m,v,S);else{let $=T_(r,v,"vertex"),X=T_(r,S,"fragment");re("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+C+`
`+$+`
`+X)}else C!==""?Yt("WebGLProgram: Program Info Log:",C):(O===""||W==="")&&(et=!1);et&&(P.diagnostics={runnable:G,programLog:C,vertexShader:{log:O,prefix:y},fragmentShader:{log:W,prefix:g}})}r.deleteShader(v),r.deleteShader(S),_=new fa(r,m),w=L2(r,m)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=r.getProgramParameter(m,w2)),N},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=M2++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=v,this.fragmentShader=S,this}var W2=0,om=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let r=this._getShaderCacheForMaterial(t);return r.has(e)===!1&&(r.add(e),e.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new am(t),e.set(t,n)),n}},am=class{constructor(t){this.id=W2++,this.code=t,this.usedTimes=0}};function q2(i){return i===Ms||i===Pl||i===Il}function $2(i,t,e,n,r,s){let o=new il,a=new om,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,w,N,P,I,U){let z=P.fog,C=I.geometry,O=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,G=t.get(_.envMap||O,W),et=f[_.type],$=n.precision;_.precision!==null&&($=n.getMaxPrecision(_.precision),$!==_.precision&&Yt("WebGLProgram.getParameters:",_.precision,"not supported, using",$,"instead."));let X=C.morphAttributes.position||C.morphAttributes.normal||C.morphAttributes.color,tt=X!==void 0?X.length:0,ht=0;C.morphAttributes.position!==void 0&&(ht=1),C.morphAttributes.normal!==void 0&&(ht=2),C.morphAttributes.color!==void 0&&(ht=3);let ct,J,dt,gt;if(et){let Ct=ui[et];ct=Ct.vertexShader,J=Ct.fragmentShader}else{ct=_.vertexShader,J=_.fragmentShader;let Ct=a.getVertexShaderStage(_),fe=a.getFragmentShaderStage(_);a.update(_,Ct,fe),dt=Ct.id,gt=fe.id}let bt=i.getRenderTarget(),yt=i.state.buffers.depth.getReversed(),Gt=I.isInstancedMesh===!0,Kt=I.isBatchedMesh===!0,zt=!!_.map,le=!!_.matcap,oe=!!G,Jt=oe&&G.isPMREMTexture===!0,Fe=!!_.aoMap,Ae=!!_.lightMap,hn=!!_.bumpMap&&_.wireframe===!1,Ft=!!_.normalMap,xe=!!_.displacementMap,te=!!_.emissiveMap,Ye=!!_.metalnessMap,Ze=!!_.roughnessMap,on=_.anisotropy>0,k=_.clearcoat>0,xt=_.diffuseRoughness>0,Xt=_.dispersion>0,ce=_.retroreflectivity>0,At=_.iridescence>0,He=_.sheen>0,Ht=_.transmission>0,jt=on&&!!_.anisotropyMap,L=k&&!!_.clearcoatMap,E=k&&!!_.clearcoatNormalMap,j=k&&!!_.clearcoatRoughnessMap,ft=xt&&!!_.diffuseRoughnessMap,at=At&&!!_.iridescenceMap,_t=At&&!!_.iridescenceThicknessMap,wt=He&&!!_.sheenColorMap,nt=He&&!!_.sheenRoughnessMap,st=!!_.specularMap,mt=!!_.specularColorMap,B=!!_.specularIntensityMap,ot=Ht&&!!_.transmissionMap,it=Ht&&!!_.thicknessMap,Et=!!_.gradientMap,vt=!!_.alphaMap,St=_.alphaTest>0,Wt=!!_.alphaHash,ee=!!_.extensions,ut=br;_.toneMapped&&(bt===null||bt.isXRRenderTarget===!0)&&(ut=i.toneMapping);let kt=Jt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,ne={shaderID:et,shaderType:_.type,shaderName:_.name,vertexShader:ct,fragmentShader:J,defines:_.defines,customVertexShaderID:dt,customFragmentShaderID:gt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:$,batching:Kt,batchingColor:Kt&&I._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&I.instanceColor!==null,instancingMorph:Gt&&I.morphTexture!==null,outputColorSpace:bt===null?i.outputColorSpace:bt.isXRRenderTarget===!0?bt.texture.colorSpace:be.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:zt,matcap:le,envMap:oe,envMapMode:oe&&G.mapping,envMapPMREM:Jt,envMapMaxLod:Jt?kt.length-1:null,envMapSize:Jt?kt[0].width:null,aoMap:Fe,lightMap:Ae,bumpMap:hn,normalMap:Ft,displacementMap:xe,emissiveMap:te,normalMapObjectSpace:Ft&&_.normalMapType===e_,normalMapTangentSpace:Ft&&_.normalMapType===Ll,packedNormalMap:Ft&&_.normalMapType===Ll&&q2(_.normalMap.format),metalnessMap:Ye,roughnessMap:Ze,anisotropy:on,anisotropyMap:jt,clearcoat:k,clearcoatMap:L,clearcoatNormalMap:E,clearcoatRoughnessMap:j,diffuseRoughness:xt,diffuseRoughnessMap:ft,dispersion:Xt,retroreflection:ce,iridescence:At,iridescenceMap:at,iridescenceThicknessMap:_t,sheen:He,sheenColorMap:wt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:mt,specularIntensityMap:B,transmission:Ht,transmissionMap:ot,thicknessMap:it,gradientMap:Et,opaque:_.transparent===!1&&_.blending===ca&&_.alphaToCoverage===!1,alphaMap:vt,alphaTest:St,alphaHash:Wt,combine:_.combine,mapUv:zt&&d(_.map.channel),aoMapUv:Fe&&d(_.aoMap.channel),lightMapUv:Ae&&d(_.lightMap.channel),bumpMapUv:hn&&d(_.bumpMap.channel),normalMapUv:Ft&&d(_.normalMap.channel),displacementMapUv:xe&&d(_.displacementMap.channel),emissiveMapUv:te&&d(_.emissiveMap.channel),metalnessMapUv:Ye&&d(_.metalnessMap.channel),roughnessMapUv:Ze&&d(_.roughnessMap.channel),anisotropyMapUv:jt&&d(_.anisotropyMap.channel),clearcoatMapUv:L&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(_.sheenRoughnessMap.channel),specularMapUv:st&&d(_.specularMap.channel),specularColorMapUv:mt&&d(_.specularColorMap.channel),specularIntensityMapUv:B&&d(_.specularIntensityMap.channel),transmissionMapUv:ot&&d(_.transmissionMap.channel),thicknessMapUv:it&&d(_.thicknessMap.channel),alphaMapUv:vt&&d(_.alphaMap.channel),vertexTangents:!!C.attributes.tangent&&(Ft||on),vertexNormals:!!C.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!C.attributes.color&&C.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!C.attributes.uv&&(zt||vt),fog:!!z,useFog:_.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||C.attributes.normal===void 0&&Ft===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:yt,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:C.attributes.position!==void 0,morphTargets:C.morphAttributes.position!==void 0,morphNormals:C.morphAttributes.normal!==void 0,morphColors:C.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:ht,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:U.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:ut,decodeVideoTexture:zt&&_.map.isVideoTexture===!0&&be.getTransfer(_.map.colorSpace)===Ie,decodeVideoTextureEmissive:te&&_.emissiveMap.isVideoTexture===!0&&be.getTransfer(_.emissiveMap.colorSpace)===Ie,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Vi,flipSided:_.side===ci,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ee&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&_.extensions.multiDraw===!0||Kt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ne.vertexUv1s=l.has(1),ne.vertexUv2s=l.has(2),ne.vertexUv3s=l.has(3),l.clear(),ne}function y(_){let w=[];if(_.shaderID?w.push(_.shaderID):(w.push(_.customVertexShaderID),w.push(_.customFragmentShaderID)),_.defines!==void 0)for(let N in _.defines)w.push(N),w.push(_.defines[N]);return _.isRawShaderMaterial===!1&&(g(w,_),p(w,_),w.push(i.outputColorSpace)),w.push(_.customProgramCacheKey),w.join()}function g(_,w){_.push(w.precision),_.push(w.outputColorSpace),_.push(w.envMapMode),_.push(w.envMapPMREM),_.push(w.envMapMaxLod),_.push(w.envMapSize),_.push(w.mapUv),_.push(w.alphaMapUv),_.push(w.lightMapUv),_.push(w.aoMapUv),_.push(w.bumpMapUv),_.push(w.normalMapUv),_.push(w.displacementMapUv),_.push(w.emissiveMapUv),_.push(w.metalnessMapUv),_.push(w.roughnessMapUv),_.push(w.anisotropyMapUv),_.push(w.clearcoatMapUv),_.push(w.clearcoatNormalMapUv),_.push(w.clearcoatRoughnessMapUv),_.push(w.diffuseRoughnessMapUv),_.push(w.iridescenceMapUv),_.push(w.iridescenceThicknessMapUv),_.push(w.sheenColorMapUv),_.push(w.sheenRoughnessMapUv),_.push(w.specularMapUv),_.push(w.specularColorMapUv),_.push(w.specularIntensityMapUv),_.push(w.transmissionMapUv),_.push(w.thicknessMapUv),_.push(w.combine),_.push(w.fogExp2),_.push(w.sizeAttenuation),_.push(w.morphTargetsCount),_.push(w.numSunLights),_.push(w.numDirLights),_.push(w.numPointLights),_.push(w.numSpotLights),_.push(w.numSpotLightMaps),_.push(w.numHemiLights),_.push(w.numRectAreaLights),_.push(w.numSunLightShadows),_.push(w.numDirLightShadows),_.push(w.numPointLightShadows),_.push(w.numSpotLightShadows),_.push(w.numSpotLightShadowsWithMaps),_.push(w.numLightProbes),_.push(w.numLightProbeGrids),_.push(w.shadowMapType),_.push(w.toneMapping),_.push(w.numClippingPlanes),_.push(w.numClipIntersection),_.push(w.depthPacking)}function p(_,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let w=f[_.type],N;if(w){let P=ui[w];N=Nl.clone(P.uniforms)}else N=_.uniforms;return N}function b(_,w){let N=u.get(w);return N!==void 0?++N.usedTimes:(N=new H2(i,w,_,r),c.push(N),u.set(w,N)),N}function v(_){if(--_.usedTimes===0){let w=c.indexOf(_);c[w]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function S(_){a.remove(_)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:x,acquireProgram:b,releaseProgram:v,releaseShaderCache:S,programs:c,dispose:A}}function X2(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function r(o,a,l){i.get(o)[a]=l}function s(){i=new WeakMap}return{has:t,get:e,remove:n,update:r,dispose:s}}function j2(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function L_(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function F_(){let i=[],t=0,e=[],n=[],r=[];function s(){t=0,e.length=0,n.length=0,r.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,m,y,g,p){let x=i[t];return x===void 0?(x={id:f.id,object:f,geometry:d,material:m,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:g,group:p},i[t]=x):(x.id=f.id,x.object=f,x.geometry=d,x.material=m,x.materialVariant=o(f),x.groupOrder=y,x.renderOrder=f.renderOrder,x.z=g,x.group=p),t++,x}function l(f,d,m,y,g,p,x){x.reversedDepth===!0&&(g=-g);let b=a(f,d,m,y,g,p);m.transmission>0?n.push(b):m.transparent===!0?r.push(b):e.push(b)}function c(f,d,m,y,g,p){let x=a(f,d,m,y,g,p);m.transmission>0?n.unshift(x):m.transparent===!0?r.unshift(x):e.unshift(x)}function u(f,d){e.length>1&&e.sort(f||j2),n.length>1&&n.sort(d||L_),r.length>1&&r.sort(d||L_)}function h(){for(let f=t,d=i.length;f<d;f++){let m=i[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:r,init:s,push:l,unshift:c,finish:h,sort:u}}function Y2(){let i=new WeakMap;function t(n,r){let s=i.get(n),o;return s===void 0?(o=new F_,i.set(n,[o])):r>=s.length?(o=new F_,s.push(o)):o=s[r],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function Z2(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new V,color:new he};break;case"SpotLight":e={position:new V,direction:new V,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new V,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new V,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new V,halfWidth:new V,halfHeight:new V};break}return i[t.id]=e,e}}}function K2(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var J2=0;function Q2(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function tP(i){let t=new Z2,e=K2(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new V);let r=new V,s=new $e,o=new $e;function a(c){let u=0,h=0,f=0;for(let U=0;U<9;U++)n.probe[U].set(0,0,0);let d=0,m=0,y=0,g=0,p=0,x=0,b=0,v=0,S=0,A=0,_=0,w=0,N=0,P=0;c.sort(Q2);for(let U=0,z=c.length;U<z;U++){let C=c[U],O=C.color,W=C.intensity,G=C.distance,et=null;if(C.shadow&&C.shadow.map&&(C.shadow.map.texture.format===Ms?et=C.shadow.map.texture:et=C.shadow.map.depthTexture||C.shadow.map.texture),C.isAmbientLight)u+=O.r*W,h+=O.g*W,f+=O.b*W;else if(C.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(C.sh.coefficients[$],W);P++}else if(C.isSunLight){let $=t.get(C);if($.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let X=C.shadow,tt=e.get(C);tt.shadowIntensity=X.intensity,tt.shadowBias=X.bias,tt.shadowNormalBias=X.normalBias,tt.shadowRadius=X.radius,tt.shadowMapSize.copy(X.mapSize).multiply(X.getFrameExtents()),n.sunShadow[m]=tt,n.sunShadowMap[m]=et;let ht=X.getViewportCount();for(let ct=0;ct<ht;ct++)n.sunShadowMatrix[y+ct]=X.getMatrix(ct),n.sunShadowCascade[y+ct]=X._cascadeData[ct];y+=ht,m++}n.sun[d]=$,d++}else if(C.isDirectionalLight){let $=t.get(C);if($.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let X=C.shadow,tt=e.get(C);tt.shadowIntensity=X.intensity,tt.shadowBias=X.bias,tt.shadowNormalBias=X.normalBias,tt.shadowRadius=X.radius,tt.shadowMapSize=X.mapSize,n.directionalShadow[g]=tt,n.directionalShadowMap[g]=et,n.directionalShadowMatrix[g]=C.shadow.matrix,S++}n.directional[g]=$,g++}else if(C.isSpotLight){let $=t.get(C);$.position.setFromMatrixPosition(C.matrixWorld),$.color.copy(O).multiplyScalar(W),$.distance=G,$.coneCos=Math.cos(C.angle),$.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),$.decay=C.decay,n.spot[x]=$;let X=C.shadow;if(C.map&&(n.spotLightMap[w]=C.map,w++,X.updateMatrices(C),C.castShadow&&N++),n.spotLightMatrix[x]=X.matrix,C.castShadow){let tt=e.get(C);tt.shadowIntensity=X.intensity,tt.shadowBias=X.bias,tt.shadowNormalBias=X.normalBias,tt.shadowRadius=X.radius,tt.shadowMapSize=X.mapSize,n.spotShadow[x]=tt,n.spotShadowMap[x]=et,_++}x++}else if(C.isRectAreaLight){let $=t.get(C);$.color.copy(O).multiplyScalar(W),$.halfWidth.set(C.width*.5,0,0),$.halfHeight.set(0,C.height*.5,0),n.rectArea[b]=$,b++}else if(C.isPointLight){let $=t.get(C);if($.color.copy(C.color).multiplyScalar(C.intensity),$.distance=C.distance,$.decay=C.decay,C.castShadow){let X=C.shadow,tt=e.get(C);tt.shadowIntensity=X.intensity,tt.shadowBias=X.bias,tt.shadowNormalBias=X.normalBias,tt.shadowRadius=X.radius,tt.shadowMapSize=X.mapSize,tt.shadowCameraNear=X.camera.near,tt.shadowCameraFar=X.camera.far,n.pointShadow[p]=tt,n.pointShadowMap[p]=et,n.pointShadowMatrix[p]=C.shadow.matrix,A++}n.point[p]=$,p++}else if(C.isHemisphereLight){let $=t.get(C);$.skyColor.copy(C.color).multiplyScalar(W),$.groundColor.copy(C.groundColor).multiplyScalar(W),n.hemi[v]=$,v++}}b>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Pt.LTC_FLOAT_1,n.rectAreaLTC2=Pt.LTC_FLOAT_2):(n.rectAreaLTC1=Pt.LTC_HALF_1,n.rectAreaLTC2=Pt.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let I=n.hash;(I.sunLength!==d||I.directionalLength!==g||I.pointLength!==p||I.spotLength!==x||I.rectAreaLength!==b||I.hemiLength!==v||I.numSunShadows!==m||I.numDirectionalShadows!==S||I.numPointShadows!==A||I.numSpotShadows!==_||I.numSpotMaps!==w||I.numLightProbes!==P)&&(n.sun.length=d,n.directional.length=g,n.spot.length=x,n.rectArea.length=b,n.point.length=p,n.hemi.length=v,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=S,n.directionalShadowMap.length=S,n.directionalShadowMatrix.length=S,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+w-N,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=P,I.sunLength=d,I.directionalLength=g,I.pointLength=p,I.spotLength=x,I.rectAreaLength=b,I.hemiLength=v,I.numSunShadows=m,I.numDirectionalShadows=S,I.numPointShadows=A,I.numSpotShadows=_,I.numSpotMaps=w,I.numLightProbes=P,n.version=J2++)}function l(c,u){let h=0,f=0,d=0,m=0,y=0,g=0,p=u.matrixWorldInverse;for(let x=0,b=c.length;x<b;x++){let v=c[x];if(v.isSunLight){let S=n.sun[h];S.direction.setFromMatrixPosition(v.matrixWorld),S.direction.transformDirection(p),h++}else if(v.isDirectionalLight){let S=n.directional[f];S.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),S.direction.sub(r),S.direction.transformDirection(p),f++}else if(v.isSpotLight){let S=n.spot[m];S.position.setFromMatrixPosition(v.matrixWorld),S.position.applyMatrix4(p),S.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),S.direction.sub(r),S.direction.transformDirection(p),m++}else if(v.isRectAreaLight){let S=n.rectArea[y];S.position.setFromMatrixPosition(v.matrixWorld),S.position.applyMatrix4(p),o.identity(),s.copy(v.matrixWorld),s.premultiply(p),o.extractRotation(s),S.halfWidth.set(v.width*.5,0,0),S.halfHeight.set(0,v.height*.5,0),S.halfWidth.applyMatrix4(o),S.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let S=n.point[d];S.position.setFromMatrixPosition(v.matrixWorld),S.position.applyMatrix4(p),d++}else if(v.isHemisphereLight){let S=n.hemi[g];S.direction.setFromMatrixPosition(v.matrixWorld),S.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:n}}function N_(i){let t=new tP(i),e=[],n=[],r=[];function s(h){u.camera=h,e.length=0,n.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):e.push(h)}function a(h){n.push(h)}function l(){t.setup(e),r.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function eP(i){let t=new WeakMap;function e(r,s=0){let o=t.get(r),a;return o===void 0?(a=new N_(i),t.set(r,[a])):s>=o.length?(a=new N_(i),o.push(a)):a=o[s],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var nP=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,iP=`uniform sampler2D shadow_pass;
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
}`,rP=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],sP=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],D_=new $e,Dl=new V,em=new V;function oP(i,t,e){let n=new ds,r=new Zt,s=new Zt,o=new Le,a=new Cu,l=new Pu,c={},u=e.maxTextureSize,h={[ws]:ci,[ci]:ws,[Vi]:Vi},f=new zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:nP,fragmentShader:iP}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new sn;m.setAttribute("position",new je(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Ge(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ys;let p=this.type;this.render=function(A,_,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Lv&&(Yt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ys);let N=i.getRenderTarget(),P=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),U=i.state;U.setBlending(Zs),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let z=p!==this.type;z&&_.traverse(function(C){C.material&&(Array.isArray(C.material)?C.material.forEach(O=>O.needsUpdate=!0):C.material.needsUpdate=!0)});for(let C=0,O=A.length;C<O;C++){let W=A[C],G=W.shadow;if(G===void 0){Yt("WebGLShadowMap:",W,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;r.copy(G.mapSize);let et=G.getFrameExtents();r.multiply(et),s.copy(G.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/et.x),r.x=s.x*et.x,G.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/et.y),r.y=s.y*et.y,G.mapSize.y=s.y));let $=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=$,G.map===null||z===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===la){if(W.isPointLight){Yt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Ri(r.x,r.y,{format:Ms,type:rr,minFilter:ai,magFilter:ai,generateMipmaps:!1}),G.map.texture.name=W.name+".shadowMap",G.map.depthTexture=new Hr(r.x,r.y,ir),G.map.depthTexture.name=W.name+".shadowMapDepth",G.map.depthTexture.format=Gr,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Bn,G.map.depthTexture.magFilter=Bn}else W.isPointLight?(G.map=new Ul(r.x),G.map.depthTexture=new cl(r.x,nr)):(G.map=new Ri(r.x,r.y),G.map.depthTexture=new Hr(r.x,r.y,nr)),G.map.depthTexture.name=W.name+".shadowMap",G.map.depthTexture.format=Gr,this.type===Ys?(G.map.depthTexture.compareFunction=$?Gp:Vp,G.map.depthTexture.minFilter=ai,G.map.depthTexture.magFilter=ai):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Bn,G.map.depthTexture.magFilter=Bn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==r.x||G.map.height!==r.y)&&G.map.setSize(r.x,r.y);let X=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();W.isPointLight!==!0&&G.updateMatrices(W,w);let tt=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let ht=0;ht<X;ht++){let ct=G.getCamera(ht);if(W.isPointLight){let J=G.camera,dt=G.matrix,gt=W.distance||J.far;gt!==J.far&&(J.far=gt,J.updateProjectionMatrix()),Dl.setFromMatrixPosition(W.matrixWorld),J.position.copy(Dl),em.copy(J.position),em.add(rP[ht]),J.up.copy(sP[ht]),J.lookAt(em),J.updateMatrixWorld(),dt.makeTranslation(-Dl.x,-Dl.y,-Dl.z),D_.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),G._frustum.setFromProjectionMatrix(D_,J.coordinateSystem,J.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,ht),i.clear();else{ht===0&&(i.setRenderTarget(G.map),i.clear());let J=G.getViewport(ht);o.set(s.x*J.x,s.y*J.y,s.x*J.z,s.y*J.w),U.viewport(o)}n=G.getFrustum(ht),v(_,w,ct,W,tt,this.type)}G.isPointLightShadow!==!0&&this.type===la&&x(G,w),G.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(N,P,I)};function x(A,_){let w=t.update(y);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new Ri(r.x,r.y,{format:Ms,type:rr}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(_,null,w,f,y,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(_,null,w,d,y,null)}function b(A,_,w,N){let P=null,I=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)P=I;else if(P=w.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let U=P.uuid,z=_.uuid,C=c[U];C===void 0&&(C={},c[U]=C);let O=C[z];O===void 0&&(O=P.clone(),C[z]=O,_.addEventListener("dispose",S)),P=O}if(P.visible=_.visible,P.wireframe=_.wireframe,N===la?P.side=_.shadowSide!==null?_.shadowSide:_.side:P.side=_.shadowSide!==null?_.shadowSide:h[_.side],P.alphaMap=_.alphaMap,P.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,P.map=_.map,P.clipShadows=_.clipShadows,P.clippingPlanes=_.clippingPlanes,P.clipIntersection=_.clipIntersection,P.displacementMap=_.displacementMap,P.displacementScale=_.displacementScale,P.displacementBias=_.displacementBias,P.wireframeLinewidth=_.wireframeLinewidth,P.linewidth=_.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let U=i.properties.get(P);U.light=w}return P}function v(A,_,w,N,P,I){if(A.visible===!1)return;if(A.layers.test(P)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===la)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let C=t.update(A),O=A.material;if(Array.isArray(O)){let W=C.groups;for(let G=0,et=W.length;G<et;G++){let $=W[G],X=O[$.materialIndex];if(X&&X.visible){let tt=b(A,X,N,I);A.onBeforeShadow(i,A,_,w,C,tt,$),i.renderBufferDirect(w,null,C,tt,A,$),A.onAfterShadow(i,A,_,w,C,tt,$)}}}else if(O.visible){let W=b(A,O,N,I);A.onBeforeShadow(i,A,_,w,C,W,null),i.renderBufferDirect(w,null,C,W,A,null),A.onAfterShadow(i,A,_,w,C,W,null)}}let z=A.children;for(let C=0,O=z.length;C<O;C++)v(z[C],_,w,N,P,I)}function S(A){A.target.removeEventListener("dispose",S);for(let w in c){let N=c[w],P=A.target.uuid;P in N&&(N[P].dispose(),delete N[P])}}}function aP(i,t){function e(){let B=!1,ot=new Le,it=null,Et=new Le(0,0,0,0);return{setMask:function(vt){it!==vt&&!B&&(i.colorMask(vt,vt,vt,vt),it=vt)},setLocked:function(vt){B=vt},setClear:function(vt,St,Wt,ee,ut){ut===!0&&(vt*=ee,St*=ee,Wt*=ee),ot.set(vt,St,Wt,ee),Et.equals(ot)===!1&&(i.clearColor(vt,St,Wt,ee),Et.copy(ot))},reset:function(){B=!1,it=null,Et.set(-1,0,0,0)}}}function n(){let B=!1,ot=!1,it=null,Et=null,vt=null;return{setReversed:function(St){if(ot!==St){let Wt=t.get("EXT_clip_control");St?Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.ZERO_TO_ONE_EXT):Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.NEGATIVE_ONE_TO_ONE_EXT),ot=St;let ee=vt;vt=null,this.setClear(ee)}},getReversed:function(){return ot},setTest:function(St){St?yt(i.DEPTH_TEST):Gt(i.DEPTH_TEST)},setMask:function(St){it!==St&&!B&&(i.depthMask(St),it=St)},setFunc:function(St){if(ot&&(St=h_[St]),Et!==St){switch(St){case uu:i.depthFunc(i.NEVER);break;case hu:i.depthFunc(i.ALWAYS);break;case fu:i.depthFunc(i.LESS);break;case Ko:i.depthFunc(i.LEQUAL);break;case du:i.depthFunc(i.EQUAL);break;case pu:i.depthFunc(i.GEQUAL);break;case mu:i.depthFunc(i.GREATER);break;case gu:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Et=St}},setLocked:function(St){B=St},setClear:function(St){vt!==St&&(vt=St,ot&&(St=1-St),i.clearDepth(St))},reset:function(){B=!1,it=null,Et=null,vt=null,ot=!1}}}function r(){let B=!1,ot=null,it=null,Et=null,vt=null,St=null,Wt=null,ee=null,ut=null;return{setTest:function(kt){B||(kt?yt(i.STENCIL_TEST):Gt(i.STENCIL_TEST))},setMask:function(kt){ot!==kt&&!B&&(i.stencilMask(kt),ot=kt)},setFunc:function(kt,ne,Ct){(it!==kt||Et!==ne||vt!==Ct)&&(i.stencilFunc(kt,ne,Ct),it=kt,Et=ne,vt=Ct)},setOp:function(kt,ne,Ct){(St!==kt||Wt!==ne||ee!==Ct)&&(i.stencilOp(kt,ne,Ct),St=kt,Wt=ne,ee=Ct)},setLocked:function(kt){B=kt},setClear:function(kt){ut!==kt&&(i.clearStencil(kt),ut=kt)},reset:function(){B=!1,ot=null,it=null,Et=null,vt=null,St=null,Wt=null,ee=null,ut=null}}}let s=new e,o=new n,a=new r,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,m=[],y=null,g=!1,p=null,x=null,b=null,v=null,S=null,A=null,_=null,w=new he(0,0,0),N=0,P=!1,I=null,U=null,z=null,C=null,O=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,et=0,$=i.getParameter(i.VERSION);$.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec($)[1]),G=et>=1):$.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),G=et>=2);let X=null,tt={},ht=i.getParameter(i.SCISSOR_BOX),ct=i.getParameter(i.VIEWPORT),J=new Le().fromArray(ht),dt=new Le().fromArray(ct);function gt(B,ot,it,Et){let vt=new Uint8Array(4),St=i.createTexture();i.bindTexture(B,St),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Wt=0;Wt<it;Wt++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(ot,0,i.RGBA,1,1,Et,0,i.RGBA,i.UNSIGNED_BYTE,vt):i.texImage2D(ot+Wt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,vt);return St}let bt={};bt[i.TEXTURE_2D]=gt(i.TEXTURE_2D,i.TEXTURE_2D,1),bt[i.TEXTURE_CUBE_MAP]=gt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),bt[i.TEXTURE_2D_ARRAY]=gt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),bt[i.TEXTURE_3D]=gt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),yt(i.DEPTH_TEST),o.setFunc(Ko),hn(!1),Ft(_p),yt(i.CULL_FACE),Fe(Zs);function yt(B){u[B]!==!0&&(i.enable(B),u[B]=!0)}function Gt(B){u[B]!==!1&&(i.disable(B),u[B]=!1)}function Kt(B,ot){return f[B]!==ot?(i.bindFramebuffer(B,ot),f[B]=ot,B===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ot),B===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ot),!0):!1}function zt(B,ot){let it=m,Et=!1;if(B){it=d.get(ot),it===void 0&&(it=[],d.set(ot,it));let vt=B.textures;if(it.length!==vt.length||it[0]!==i.COLOR_ATTACHMENT0){for(let St=0,Wt=vt.length;St<Wt;St++)it[St]=i.COLOR_ATTACHMENT0+St;it.length=vt.length,Et=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,Et=!0);Et&&i.drawBuffers(it)}function le(B){return y!==B?(i.useProgram(B),y=B,!0):!1}let oe={[Ks]:i.FUNC_ADD,[Nv]:i.FUNC_SUBTRACT,[Dv]:i.FUNC_REVERSE_SUBTRACT};oe[Ov]=i.MIN,oe[Uv]=i.MAX;let Jt={[kv]:i.ZERO,[Bv]:i.ONE,[zv]:i.SRC_COLOR,[Sp]:i.SRC_ALPHA,[$v]:i.SRC_ALPHA_SATURATE,[Wv]:i.DST_COLOR,[Gv]:i.DST_ALPHA,[Vv]:i.ONE_MINUS_SRC_COLOR,[Ap]:i.ONE_MINUS_SRC_ALPHA,[qv]:i.ONE_MINUS_DST_COLOR,[Hv]:i.ONE_MINUS_DST_ALPHA,[Xv]:i.CONSTANT_COLOR,[jv]:i.ONE_MINUS_CONSTANT_COLOR,[Yv]:i.CONSTANT_ALPHA,[Zv]:i.ONE_MINUS_CONSTANT_ALPHA};function Fe(B,ot,it,Et,vt,St,Wt,ee,ut,kt){if(B===Zs){g===!0&&(Gt(i.BLEND),g=!1);return}if(g===!1&&(yt(i.BLEND),g=!0),B!==Fv){if(B!==p||kt!==P){if((x!==Ks||S!==Ks)&&(i.blendEquation(i.FUNC_ADD),x=Ks,S=Ks),kt)switch(B){case ca:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case bp:i.blendFunc(i.ONE,i.ONE);break;case wp:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Mp:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:re("WebGLState: Invalid blending: ",B);break}else switch(B){case ca:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case bp:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case wp:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Mp:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",B);break}b=null,v=null,A=null,_=null,w.set(0,0,0),N=0,p=B,P=kt}return}vt=vt||ot,St=St||it,Wt=Wt||Et,(ot!==x||vt!==S)&&(i.blendEquationSeparate(oe[ot],oe[vt]),x=ot,S=vt),(it!==b||Et!==v||St!==A||Wt!==_)&&(i.blendFuncSeparate(Jt[it],Jt[Et],Jt[St],Jt[Wt]),b=it,v=Et,A=St,_=Wt),(ee.equals(w)===!1||ut!==N)&&(i.blendColor(ee.r,ee.g,ee.b,ut),w.copy(ee),N=ut),p=B,P=!1}function Ae(B,ot){B.side===Vi?Gt(i.CULL_FACE):yt(i.CULL_FACE);let it=B.side===ci;ot&&(it=!it),hn(it),B.blending===ca&&B.transparent===!1?Fe(Zs):Fe(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),s.setMask(B.colorWrite);let Et=B.stencilWrite;a.setTest(Et),Et&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),te(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?yt(i.SAMPLE_ALPHA_TO_COVERAGE):Gt(i.SAMPLE_ALPHA_TO_COVERAGE)}function hn(B){I!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),I=B)}function Ft(B){B!==Pv?(yt(i.CULL_FACE),B!==U&&(B===_p?i.cullFace(i.BACK):B===Iv?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Gt(i.CULL_FACE),U=B}function xe(B){B!==z&&(G&&i.lineWidth(B),z=B)}function te(B,ot,it){B?(yt(i.POLYGON_OFFSET_FILL),(C!==ot||O!==it)&&(C=ot,O=it,o.getReversed()&&(ot=-ot,it=-it),i.polygonOffset(ot,it))):Gt(i.POLYGON_OFFSET_FILL)}function Ye(B){B?yt(i.SCISSOR_TEST):Gt(i.SCISSOR_TEST)}function Ze(B){B===void 0&&(B=i.TEXTURE0+W-1),X!==B&&(i.activeTexture(B),X=B)}function on(B,ot,it){it===void 0&&(X===null?it=i.TEXTURE0+W-1:it=X);let Et=tt[it];Et===void 0&&(Et={type:void 0,texture:void 0},tt[it]=Et),(Et.type!==B||Et.texture!==ot)&&(X!==it&&(i.activeTexture(it),X=it),i.bindTexture(B,ot||bt[B]),Et.type=B,Et.texture=ot)}function k(){let B=tt[X];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function xt(){try{i.compressedTexImage2D(...arguments)}catch(B){re("WebGLState:",B)}}function Xt(){try{i.compressedTexImage3D(...arguments)}catch(B){re("WebGLState:",B)}}function ce(){try{i.texSubImage2D(...arguments)}catch(B){re("WebGLState:",B)}}function At(){try{i.texSubImage3D(...arguments)}catch(B){re("WebGLState:",B)}}function He(){try{i.compressedTexSubImage2D(...arguments)}catch(B){re("WebGLState:",B)}}function Ht(){try{i.compressedTexSubImage3D(...arguments)}catch(B){re("WebGLState:",B)}}function jt(){try{i.texStorage2D(...arguments)}catch(B){re("WebGLState:",B)}}function L(){try{i.texStorage3D(...arguments)}catch(B){re("WebGLState:",B)}}function E(){try{i.texImage2D(...arguments)}catch(B){re("WebGLState:",B)}}function j(){try{i.texImage3D(...arguments)}catch(B){re("WebGLState:",B)}}function ft(B){return h[B]!==void 0?h[B]:i.getParameter(B)}function at(B,ot){h[B]!==ot&&(i.pixelStorei(B,ot),h[B]=ot)}function _t(B){J.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),J.copy(B))}function wt(B){dt.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),dt.copy(B))}function nt(B,ot){let it=c.get(ot);it===void 0&&(it=new WeakMap,c.set(ot,it));let Et=it.get(B);Et===void 0&&(Et=i.getUniformBlockIndex(ot,B.name),i.uniformBlockBinding(ot,Et,Et),it.set(B,Et))}function st(B,ot,it){let vt=c.get(ot).get(B);l[vt]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,vt,it),l[vt]=it)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},X=null,tt={},f={},l={},d=new WeakMap,m=[],y=null,g=!1,p=null,x=null,b=null,v=null,S=null,A=null,_=null,w=new he(0,0,0),N=0,P=!1,I=null,U=null,z=null,C=null,O=null,J.set(0,0,i.canvas.width,i.canvas.height),dt.set(0,0,i.canvas.width,i.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:yt,disable:Gt,bindFramebuffer:Kt,drawBuffers:zt,useProgram:le,setBlending:Fe,setMaterial:Ae,setFlipSided:hn,setCullFace:Ft,setLineWidth:xe,setPolygonOffset:te,setScissorTest:Ye,activeTexture:Ze,bindTexture:on,unbindTexture:k,compressedTexImage2D:xt,compressedTexImage3D:Xt,texImage2D:E,texImage3D:j,pixelStorei:at,getParameter:ft,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:jt,texStorage3D:L,texSubImage2D:ce,texSubImage3D:At,compressedTexSubImage2D:He,compressedTexSubImage3D:Ht,scissor:_t,viewport:wt,reset:mt}}function lP(i,t,e,n,r,s,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,u=new WeakMap,h=new Set,f,d=new WeakMap,m=new Set,y=new FinalizationRegistry(L=>m.delete(L)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(L,E){return g?new OffscreenCanvas(L,E):tl("canvas")}function x(L,E,j){let ft=1,at=jt(L);if((at.width>j||at.height>j)&&(ft=j/Math.max(at.width,at.height)),ft<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let _t=Math.floor(ft*at.width),wt=Math.floor(ft*at.height);f===void 0&&(f=p(_t,wt));let nt=E?p(_t,wt):f;return nt.width=_t,nt.height=wt,nt.getContext("2d").drawImage(L,0,0,_t,wt),Yt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+_t+"x"+wt+")."),nt}else return"data"in L&&Yt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),L;return L}function b(L){return L.generateMipmaps}function v(L){i.generateMipmap(L)}function S(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(L,E,j,ft,at,_t=!1){if(L!==null){if(i[L]!==void 0)return i[L];Yt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let wt;ft&&(wt=t.get("EXT_texture_norm16"),wt||Yt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=E;if(E===i.RED&&(j===i.FLOAT&&(nt=i.R32F),j===i.HALF_FLOAT&&(nt=i.R16F),j===i.UNSIGNED_BYTE&&(nt=i.R8),j===i.UNSIGNED_SHORT&&wt&&(nt=wt.R16_EXT),j===i.SHORT&&wt&&(nt=wt.R16_SNORM_EXT)),E===i.RED_INTEGER&&(j===i.UNSIGNED_BYTE&&(nt=i.R8UI),j===i.UNSIGNED_SHORT&&(nt=i.R16UI),j===i.UNSIGNED_INT&&(nt=i.R32UI),j===i.BYTE&&(nt=i.R8I),j===i.SHORT&&(nt=i.R16I),j===i.INT&&(nt=i.R32I)),E===i.RG&&(j===i.FLOAT&&(nt=i.RG32F),j===i.HALF_FLOAT&&(nt=i.RG16F),j===i.UNSIGNED_BYTE&&(nt=i.RG8),j===i.UNSIGNED_SHORT&&wt&&(nt=wt.RG16_EXT),j===i.SHORT&&wt&&(nt=wt.RG16_SNORM_EXT)),E===i.RG_INTEGER&&(j===i.UNSIGNED_BYTE&&(nt=i.RG8UI),j===i.UNSIGNED_SHORT&&(nt=i.RG16UI),j===i.UNSIGNED_INT&&(nt=i.RG32UI),j===i.BYTE&&(nt=i.RG8I),j===i.SHORT&&(nt=i.RG16I),j===i.INT&&(nt=i.RG32I)),E===i.RGB_INTEGER&&(j===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),j===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),j===i.UNSIGNED_INT&&(nt=i.RGB32UI),j===i.BYTE&&(nt=i.RGB8I),j===i.SHORT&&(nt=i.RGB16I),j===i.INT&&(nt=i.RGB32I)),E===i.RGBA_INTEGER&&(j===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),j===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),j===i.UNSIGNED_INT&&(nt=i.RGBA32UI),j===i.BYTE&&(nt=i.RGBA8I),j===i.SHORT&&(nt=i.RGBA16I),j===i.INT&&(nt=i.RGBA32I)),E===i.RGB&&(j===i.UNSIGNED_SHORT&&wt&&(nt=wt.RGB16_EXT),j===i.SHORT&&wt&&(nt=wt.RGB16_SNORM_EXT),j===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),j===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),E===i.RGBA){let st=_t?Qa:be.getTransfer(at);j===i.FLOAT&&(nt=i.RGBA32F),j===i.HALF_FLOAT&&(nt=i.RGBA16F),j===i.UNSIGNED_BYTE&&(nt=st===Ie?i.SRGB8_ALPHA8:i.RGBA8),j===i.UNSIGNED_SHORT&&wt&&(nt=wt.RGBA16_EXT),j===i.SHORT&&wt&&(nt=wt.RGBA16_SNORM_EXT),j===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),j===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function _(L,E){let j;return L?E===null||E===nr||E===Qs?j=i.DEPTH24_STENCIL8:E===ir?j=i.DEPTH32F_STENCIL8:E===ha&&(j=i.DEPTH24_STENCIL8,Yt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===nr||E===Qs?j=i.DEPTH_COMPONENT24:E===ir?j=i.DEPTH_COMPONENT32F:E===ha&&(j=i.DEPTH_COMPONENT16),j}function w(L,E){return b(L)===!0||L.isFramebufferTexture&&L.minFilter!==Bn&&L.minFilter!==ai?Math.log2(Math.max(E.width,E.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?E.mipmaps.length:1}function N(L){let E=new WeakRef(L);n.get(L).__ref=E,m.add(E),y.register(L,E,E)}function P(L){let E=n.get(L).__ref;E!==void 0&&(m.delete(E),y.unregister(E))}function I(L){z(L.target)}function U(L){C(L.target)}function z(L){L.removeEventListener("dispose",I),P(L),W(L),L.isVideoTexture&&u.delete(L),L.isHTMLTexture&&h.delete(L)}function C(L){L.removeEventListener("dispose",U),P(L),et(L)}function O(){for(let L of m){let E=L.deref();E!==void 0&&(E.isRenderTarget===!0?C(E):z(E))}m.clear(),h.clear()}function W(L){let E=n.get(L);if(E.__webglInit===void 0)return;let j=L.source,ft=d.get(j);if(ft){let at=ft[E.__cacheKey];at.usedTimes--,at.usedTimes===0&&G(L),Object.keys(ft).length===0&&d.delete(j)}n.remove(L)}function G(L){let E=n.get(L);i.deleteTexture(E.__webglTexture);let j=L.source,ft=d.get(j);delete ft[E.__cacheKey],o.memory.textures--}function et(L){let E=n.get(L);E.__depthDisposeCallback&&E.__depthDisposeCallback();let j=L.depthTexture;if(j&&j.renderTarget===L&&z(j),L.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(E.__webglFramebuffer[at]))for(let _t=0;_t<E.__webglFramebuffer[at].length;_t++)i.deleteFramebuffer(E.__webglFramebuffer[at][_t]);else i.deleteFramebuffer(E.__webglFramebuffer[at]);E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer[at])}else{if(Array.isArray(E.__webglFramebuffer))for(let at=0;at<E.__webglFramebuffer.length;at++)i.deleteFramebuffer(E.__webglFramebuffer[at]);else i.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&i.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let at=0;at<E.__webglColorRenderbuffer.length;at++)E.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(E.__webglColorRenderbuffer[at]);E.__webglDepthRenderbuffer&&i.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let ft=L.textures;for(let at=0,_t=ft.length;at<_t;at++){let wt=n.get(ft[at]);wt.__webglTexture&&(i.deleteTexture(wt.__webglTexture),o.memory.textures--),n.remove(ft[at])}n.remove(L)}let $=0;function X(){$=0}function tt(){return $}function ht(L){$=L}function ct(){let L=$;return L>=r.maxTextures&&Yt("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+r.maxTextures),$+=1,L}function J(L){let E=[];return E.push(L.wrapS),E.push(L.wrapT),E.push(L.wrapR||0),E.push(L.magFilter),E.push(L.minFilter),E.push(L.anisotropy),E.push(L.internalFormat),E.push(L.format),E.push(L.type),E.push(L.generateMipmaps),E.push(L.mipmapsAutoUpdate),E.push(L.premultiplyAlpha),E.push(L.flipY),E.push(L.unpackAlignment),E.push(L.colorSpace),E.join()}function dt(L,E){let j=n.get(L);if(L.isVideoTexture&&He(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&j.__version!==L.version){let ft=L.image;if(ft===null)Yt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)Yt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ae(j,L,E);return}}else L.isExternalTexture&&(j.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,j.__webglTexture,i.TEXTURE0+E)}function gt(L,E){let j=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&j.__version!==L.version){Ae(j,L,E);return}else L.isExternalTexture&&(j.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,j.__webglTexture,i.TEXTURE0+E)}function bt(L,E){let j=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&j.__version!==L.version){Ae(j,L,E);return}e.bindTexture(i.TEXTURE_3D,j.__webglTexture,i.TEXTURE0+E)}function yt(L,E){let j=n.get(L);if(L.version>0&&j.__version!==L.version){hn(j,L,E);return}e.bindTexture(i.TEXTURE_CUBE_MAP,j.__webglTexture,i.TEXTURE0+E)}let Gt={[yu]:i.REPEAT,[xr]:i.CLAMP_TO_EDGE,[xu]:i.MIRRORED_REPEAT},Kt={[Bn]:i.NEAREST,[Qv]:i.NEAREST_MIPMAP_NEAREST,[Al]:i.NEAREST_MIPMAP_LINEAR,[ai]:i.LINEAR,[$u]:i.LINEAR_MIPMAP_NEAREST,[Wr]:i.LINEAR_MIPMAP_LINEAR},zt={[i_]:i.NEVER,[Hp]:i.ALWAYS,[r_]:i.LESS,[Vp]:i.LEQUAL,[s_]:i.EQUAL,[Gp]:i.GEQUAL,[o_]:i.GREATER,[a_]:i.NOTEQUAL};function le(L,E){if(E.type===ir&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===ai||E.magFilter===$u||E.magFilter===Al||E.magFilter===Wr||E.minFilter===ai||E.minFilter===$u||E.minFilter===Al||E.minFilter===Wr)&&Yt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,Gt[E.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,Gt[E.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,Gt[E.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,Kt[E.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,Kt[E.minFilter]),E.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,zt[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Bn||E.minFilter!==Al&&E.minFilter!==Wr||E.type===ir&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||n.get(E).__currentAnisotropy){let j=t.get("EXT_texture_filter_anisotropic");i.texParameterf(L,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,r.getMaxAnisotropy())),n.get(E).__currentAnisotropy=E.anisotropy}}}function oe(L,E){let j=!1;L.__webglInit===void 0&&(L.__webglInit=!0,E.addEventListener("dispose",I),N(E));let ft=E.source,at=d.get(ft);at===void 0&&(at={},d.set(ft,at));let _t=J(E);if(_t!==L.__cacheKey){at[_t]===void 0&&(at[_t]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,j=!0),at[_t].usedTimes++;let wt=at[L.__cacheKey];wt!==void 0&&(at[L.__cacheKey].usedTimes--,wt.usedTimes===0&&G(E)),L.__cacheKey=_t,L.__webglTexture=at[_t].texture}return j}function Jt(L,E,j){return Math.floor(Math.floor(L/j)/E)}function Fe(L,E,j,ft){let _t=L.updateRanges;if(_t.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,E.width,E.height,j,ft,E.data);else{_t.sort((B,ot)=>B.start-ot.start);let wt=0;for(let B=1;B<_t.length;B++){let ot=_t[wt],it=_t[B],Et=ot.start+ot.count,vt=Jt(it.start,E.width,4),St=Jt(ot.start,E.width,4);it.start<=Et+1&&vt===St&&Jt(it.start+it.count-1,E.width,4)===vt?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++wt,_t[wt]=it)}_t.length=wt+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,E.width);for(let B=0,ot=_t.length;B<ot;B++){let it=_t[B],Et=Math.floor(it.start/4),vt=Math.ceil(it.count/4),St=Et%E.width,Wt=Math.floor(Et/E.width),ee=vt,ut=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,St),e.pixelStorei(i.UNPACK_SKIP_ROWS,Wt),e.texSubImage2D(i.TEXTURE_2D,0,St,Wt,ee,ut,j,ft,E.data)}L.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function Ae(L,E,j){let ft=i.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(ft=i.TEXTURE_2D_ARRAY),E.isData3DTexture&&(ft=i.TEXTURE_3D);let at=oe(L,E),_t=E.source;e.bindTexture(ft,L.__webglTexture,i.TEXTURE0+j);let wt=n.get(_t);if(_t.version!==wt.__version||at===!0){if(e.activeTexture(i.TEXTURE0+j),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ut=be.getPrimaries(be.workingColorSpace),kt=E.colorSpace===$r?null:be.getPrimaries(E.colorSpace),ne=E.colorSpace===$r||ut===kt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne)}e.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment);let st=x(E.image,!1,r.maxTextureSize);st=Ht(E,st);let mt=s.convert(E.format,E.colorSpace),B=s.convert(E.type),ot=A(E.internalFormat,mt,B,E.normalized,E.colorSpace,E.isVideoTexture);le(ft,E);let it,Et=E.mipmaps,vt=E.isVideoTexture!==!0,St=wt.__version===void 0||at===!0,Wt=_t.dataReady,ee=w(E,st);if(E.isDepthTexture)ot=_(E.format===qr,E.type),St&&(vt?e.texStorage2D(i.TEXTURE_2D,1,ot,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,ot,st.width,st.height,0,mt,B,null));else if(E.isDataTexture)if(Et.length>0){vt&&St&&e.texStorage2D(i.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ut=0,kt=Et.length;ut<kt;ut++)it=Et[ut],vt?Wt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,B,it.data):e.texImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,mt,B,it.data);E.generateMipmaps=!1}else vt?(St&&e.texStorage2D(i.TEXTURE_2D,ee,ot,st.width,st.height),Wt&&Fe(E,st,mt,B)):e.texImage2D(i.TEXTURE_2D,0,ot,st.width,st.height,0,mt,B,st.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){vt&&St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,ot,Et[0].width,Et[0].height,st.depth);for(let ut=0,kt=Et.length;ut<kt;ut++)if(it=Et[ut],E.format!==sr)if(mt!==null)if(vt){if(Wt)if(E.layerUpdates.size>0){let ne=Qp(it.width,it.height,E.format,E.type);for(let Ct of E.layerUpdates){let fe=it.data.subarray(Ct*ne/it.data.BYTES_PER_ELEMENT,(Ct+1)*ne/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,Ct,it.width,it.height,1,mt,fe)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,mt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ut,ot,it.width,it.height,st.depth,0,it.data,0,0);else Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else vt?Wt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,mt,B,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ut,ot,it.width,it.height,st.depth,0,mt,B,it.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{vt&&St&&e.texStorage2D(i.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ut=0,kt=Et.length;ut<kt;ut++)it=Et[ut],E.format!==sr?mt!==null?vt?Wt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,it.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):vt?Wt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,B,it.data):e.texImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,mt,B,it.data)}else if(E.isDataArrayTexture)if(vt){if(St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,ot,st.width,st.height,st.depth),Wt)if(E.layerUpdates.size>0){let ut=Qp(st.width,st.height,E.format,E.type);for(let kt of E.layerUpdates){let ne=st.data.subarray(kt*ut/st.data.BYTES_PER_ELEMENT,(kt+1)*ut/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,kt,st.width,st.height,1,mt,B,ne)}E.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,ot,st.width,st.height,st.depth,0,mt,B,st.data);else if(E.isData3DTexture)vt?(St&&e.texStorage3D(i.TEXTURE_3D,ee,ot,st.width,st.height,st.depth),Wt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)):e.texImage3D(i.TEXTURE_3D,0,ot,st.width,st.height,st.depth,0,mt,B,st.data);else if(E.isFramebufferTexture){if(St)if(vt)e.texStorage2D(i.TEXTURE_2D,ee,ot,st.width,st.height);else{let ut=st.width,kt=st.height;for(let ne=0;ne<ee;ne++)e.texImage2D(i.TEXTURE_2D,ne,ot,ut,kt,0,mt,B,null),ut>>=1,kt>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in i){let ut=i.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),st.parentNode!==ut){ut.appendChild(st),h.add(E),ut.onpaint=kt=>{let ne=kt.changedElements;for(let Ct of h)ne.includes(Ct.image)&&(Ct.needsUpdate=!0)},ut.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let ne=i.RGBA,Ct=i.RGBA,fe=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ne,Ct,fe,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Et.length>0){if(vt&&St){let ut=jt(Et[0]);e.texStorage2D(i.TEXTURE_2D,ee,ot,ut.width,ut.height)}for(let ut=0,kt=Et.length;ut<kt;ut++)it=Et[ut],vt?Wt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,mt,B,it):e.texImage2D(i.TEXTURE_2D,ut,ot,mt,B,it);E.generateMipmaps=!1}else if(vt){if(St){let ut=jt(st);e.texStorage2D(i.TEXTURE_2D,ee,ot,ut.width,ut.height)}Wt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,B,st)}else e.texImage2D(i.TEXTURE_2D,0,ot,mt,B,st);b(E)&&E.mipmapsAutoUpdate===!0&&v(ft),wt.__version=_t.version,E.onUpdate&&E.onUpdate(E)}L.__version=E.version}function hn(L,E,j){if(E.image.length!==6)return;let ft=oe(L,E),at=E.source;e.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+j);let _t=n.get(at);if(at.version!==_t.__version||ft===!0){e.activeTexture(i.TEXTURE0+j);let wt=be.getPrimaries(be.workingColorSpace),nt=E.colorSpace===$r?null:be.getPrimaries(E.colorSpace),st=E.colorSpace===$r||wt===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=E.isCompressedTexture||E.image[0].isCompressedTexture,B=E.image[0]&&E.image[0].isDataTexture,ot=[];for(let Ct=0;Ct<6;Ct++)!mt&&!B?ot[Ct]=x(E.image[Ct],!0,r.maxCubemapSize):ot[Ct]=B?E.image[Ct].image:E.image[Ct],ot[Ct]=Ht(E,ot[Ct]);let it=ot[0],Et=s.convert(E.format,E.colorSpace),vt=s.convert(E.type),St=A(E.internalFormat,Et,vt,E.normalized,E.colorSpace),Wt=E.isVideoTexture!==!0,ee=_t.__version===void 0||ft===!0,ut=at.dataReady,kt=w(E,it);le(i.TEXTURE_CUBE_MAP,E);let ne;if(E.isDepthTexture){if(St=_(E.format===qr,E.type),ee)if(Wt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,St,it.width,it.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,it.width,it.height,0,Et,vt,null)}else if(mt){Wt&&ee&&e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,St,it.width,it.height);for(let Ct=0;Ct<6;Ct++){ne=ot[Ct].mipmaps;for(let fe=0;fe<ne.length;fe++){let Ke=ne[fe];E.format!==sr?Et!==null?Wt?ut&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe,0,0,Ke.width,Ke.height,Et,Ke.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe,St,Ke.width,Ke.height,0,Ke.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe,0,0,Ke.width,Ke.height,Et,vt,Ke.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe,St,Ke.width,Ke.height,0,Et,vt,Ke.data)}}}else{if(ne=E.mipmaps,Wt&&ee){ne.length>0&&kt++;let Ct=jt(ot[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,St,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(B){Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,ot[Ct].width,ot[Ct].height,Et,vt,ot[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,ot[Ct].width,ot[Ct].height,0,Et,vt,ot[Ct].data);for(let fe=0;fe<ne.length;fe++){let Jn=ne[fe].image[Ct].image;Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe+1,0,0,Jn.width,Jn.height,Et,vt,Jn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe+1,St,Jn.width,Jn.height,0,Et,vt,Jn.data)}}else{Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,vt,ot[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,Et,vt,ot[Ct]);for(let fe=0;fe<ne.length;fe++){let Ke=ne[fe];Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe+1,0,0,Et,vt,Ke.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe+1,St,Et,vt,Ke.image[Ct])}}}b(E)&&E.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),_t.__version=at.version,E.onUpdate&&E.onUpdate(E)}L.__version=E.version}function Ft(L,E,j,ft,at,_t){let wt=s.convert(j.format,j.colorSpace),nt=s.convert(j.type),st=A(j.internalFormat,wt,nt,j.normalized,j.colorSpace),mt=n.get(E),B=n.get(j);if(B.__renderTarget=E,!mt.__hasExternalTextures){let ot=Math.max(1,E.width>>_t),it=Math.max(1,E.height>>_t);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,_t,st,ot,it,E.depth,0,wt,nt,null):e.texImage2D(at,_t,st,ot,it,0,wt,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,L),At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ft,at,B.__webglTexture,0,ce(E)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ft,at,B.__webglTexture,_t),e.bindFramebuffer(i.FRAMEBUFFER,null)}function xe(L,E,j){if(i.bindRenderbuffer(i.RENDERBUFFER,L),E.depthBuffer){let ft=E.depthTexture,at=ft&&ft.isDepthTexture?ft.type:null,_t=_(E.stencilBuffer,at),wt=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;At(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(E),_t,E.width,E.height):j?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(E),_t,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,_t,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,wt,i.RENDERBUFFER,L)}else{let ft=E.textures;for(let at=0;at<ft.length;at++){let _t=ft[at],wt=s.convert(_t.format,_t.colorSpace),nt=s.convert(_t.type),st=A(_t.internalFormat,wt,nt,_t.normalized,_t.colorSpace);At(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(E),st,E.width,E.height):j?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(E),st,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,st,E.width,E.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function te(L,E,j){let ft=E.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,L),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(E.depthTexture);at.__renderTarget=E;let _t=ft?E.depthTexture.image[0]:E.depthTexture.image;(!at.__webglTexture||_t.width!==E.width||_t.height!==E.height)&&(_t.width=E.width,_t.height=E.height,E.depthTexture.needsUpdate=!0),ft?yt(E.depthTexture,0):dt(E.depthTexture,0);let wt=at.__webglTexture,nt=ce(E),st=ft?i.TEXTURE_CUBE_MAP_POSITIVE_X+j:i.TEXTURE_2D,mt=E.depthTexture.format===qr?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(E.depthTexture.format===Gr)At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,wt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,wt,0);else if(E.depthTexture.format===qr)At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,wt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ye(L){let E=n.get(L),j=L.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==L.depthTexture){let ft=L.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),ft){let at=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,ft.removeEventListener("dispose",at)};ft.addEventListener("dispose",at),E.__depthDisposeCallback=at}E.__boundDepthTexture=ft}if(L.depthTexture&&!E.__autoAllocateDepthBuffer)if(j)for(let ft=0;ft<6;ft++)te(E.__webglFramebuffer[ft],L,ft);else L.texture.mipmaps.length>0?te(E.__webglFramebuffer[0],L,0):te(E.__webglFramebuffer,L,0);else if(j){E.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[ft]),E.__webglDepthbuffer[ft]===void 0)E.__webglDepthbuffer[ft]=i.createRenderbuffer(),xe(E.__webglDepthbuffer[ft],L,!1);else{let at=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=E.__webglDepthbuffer[ft];i.bindRenderbuffer(i.RENDERBUFFER,_t),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,_t)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=i.createRenderbuffer(),xe(E.__webglDepthbuffer,L,!1);else{let at=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=E.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_t),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,_t)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ze(L,E,j){let ft=n.get(L);E!==void 0&&Ft(ft.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),j!==void 0&&Ye(L)}function on(L){let E=L.texture,j=n.get(L),ft=n.get(E);L.addEventListener("dispose",U),N(L);let at=L.textures,_t=L.isWebGLCubeRenderTarget===!0,wt=at.length>1;if(wt||(ft.__webglTexture===void 0&&(ft.__webglTexture=i.createTexture()),ft.__version=E.version,o.memory.textures++),_t){j.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(E.mipmaps.length>0){j.__webglFramebuffer[nt]=[];for(let st=0;st<E.mipmaps.length;st++)j.__webglFramebuffer[nt][st]=i.createFramebuffer()}else j.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(E.mipmaps.length>0){j.__webglFramebuffer=[];for(let nt=0;nt<E.mipmaps.length;nt++)j.__webglFramebuffer[nt]=i.createFramebuffer()}else j.__webglFramebuffer=i.createFramebuffer();if(wt)for(let nt=0,st=at.length;nt<st;nt++){let mt=n.get(at[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&At(L)===!1){j.__webglMultisampledFramebuffer=i.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];j.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,j.__webglColorRenderbuffer[nt]);let mt=s.convert(st.format,st.colorSpace),B=s.convert(st.type),ot=A(st.internalFormat,mt,B,st.normalized,st.colorSpace,L.isXRRenderTarget===!0),it=ce(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,ot,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,j.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(j.__webglDepthRenderbuffer=i.createRenderbuffer(),xe(j.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_t){e.bindTexture(i.TEXTURE_CUBE_MAP,ft.__webglTexture),le(i.TEXTURE_CUBE_MAP,E);for(let nt=0;nt<6;nt++)if(E.mipmaps.length>0)for(let st=0;st<E.mipmaps.length;st++)Ft(j.__webglFramebuffer[nt][st],L,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Ft(j.__webglFramebuffer[nt],L,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);b(E)?v(i.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let nt=0,st=at.length;nt<st;nt++){let mt=at[nt],B=n.get(mt),ot=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ot=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ot,B.__webglTexture),le(ot,mt),Ft(j.__webglFramebuffer,L,mt,i.COLOR_ATTACHMENT0+nt,ot,0),b(mt)&&v(ot)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(nt=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,ft.__webglTexture),le(nt,E),E.mipmaps.length>0)for(let st=0;st<E.mipmaps.length;st++)Ft(j.__webglFramebuffer[st],L,E,i.COLOR_ATTACHMENT0,nt,st);else Ft(j.__webglFramebuffer,L,E,i.COLOR_ATTACHMENT0,nt,0);b(E)?v(nt):E.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&Ye(L)}function k(L){let E=L.textures;for(let j=0,ft=E.length;j<ft;j++){let at=E[j];if(b(at)&&at.mipmapsAutoUpdate===!0){let _t=S(L),wt=n.get(at).__webglTexture;e.bindTexture(_t,wt),v(_t),e.unbindTexture()}}}let xt=[];function Xt(L){if(L.samples>0){if(At(L)===!1){let E=L.textures,j=L.width,ft=L.height,at=i.COLOR_BUFFER_BIT,_t=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,wt=n.get(L),nt=E.length>1;if(nt)for(let mt=0;mt<E.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,wt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let mt=0;mt<E.length;mt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,wt.__webglColorRenderbuffer[mt]);let B=n.get(E[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,j,ft,0,0,j,ft,at,i.NEAREST),l===!0&&(xt.length=0,xt.push(i.COLOR_ATTACHMENT0+mt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&xt.push(_t),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,xt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<E.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,wt.__webglColorRenderbuffer[mt]);let B=n.get(E[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,wt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,B,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let E=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[E])}}}function ce(L){return Math.min(r.maxSamples,L.samples)}function At(L){let E=n.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function He(L){let E=o.render.frame;u.get(L)!==E&&(u.set(L,E),L.update())}function Ht(L,E){let j=L.colorSpace,ft=L.format,at=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||j!==Ja&&j!==$r&&(be.getTransfer(j)===Ie?(ft!==sr||at!==di)&&Yt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",j)),E}function jt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=ct,this.resetTextureUnits=X,this.getTextureUnits=tt,this.setTextureUnits=ht,this.setTexture2D=dt,this.setTexture2DArray=gt,this.setTexture3D=bt,this.setTextureCube=yt,this.rebindTextures=Ze,this.setupRenderTarget=on,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Xt,this.setupDepthRenderbuffer=Ye,this.setupFrameBufferTexture=Ft,this.useMultisampledRTT=At,this.dispose=O}function cP(i,t){function e(n,r=$r){let s,o=be.getTransfer(r);if(n===di)return i.UNSIGNED_BYTE;if(n===ju)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Yu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Op)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Up)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Np)return i.BYTE;if(n===Dp)return i.SHORT;if(n===ha)return i.UNSIGNED_SHORT;if(n===Xu)return i.INT;if(n===nr)return i.UNSIGNED_INT;if(n===ir)return i.FLOAT;if(n===rr)return i.HALF_FLOAT;if(n===kp)return i.ALPHA;if(n===Bp)return i.RGB;if(n===sr)return i.RGBA;if(n===Gr)return i.DEPTH_COMPONENT;if(n===qr)return i.DEPTH_STENCIL;if(n===zp)return i.RED;if(n===Zu)return i.RED_INTEGER;if(n===Ms)return i.RG;if(n===Ku)return i.RG_INTEGER;if(n===Ju)return i.RGBA_INTEGER;if(n===El||n===Tl||n===Rl||n===Cl)if(o===Ie)if(s=t.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===El)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Tl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Rl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Cl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=t.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===El)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Tl)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Rl)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Cl)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Qu||n===th||n===eh||n===nh)if(s=t.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===Qu)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===th)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===eh)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===nh)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ih||n===rh||n===sh||n===oh||n===ah||n===Pl||n===lh)if(s=t.get("WEBGL_compressed_texture_etc"),s!==null){if(n===ih||n===rh)return o===Ie?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===sh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===oh)return s.COMPRESSED_R11_EAC;if(n===ah)return s.COMPRESSED_SIGNED_R11_EAC;if(n===Pl)return s.COMPRESSED_RG11_EAC;if(n===lh)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===ch||n===uh||n===hh||n===fh||n===dh||n===ph||n===mh||n===gh||n===yh||n===xh||n===vh||n===_h||n===bh||n===wh)if(s=t.get("WEBGL_compressed_texture_astc"),s!==null){if(n===ch)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===uh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===hh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===fh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===dh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ph)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===mh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===gh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===yh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===xh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===vh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_h)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===bh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===wh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Mh||n===Sh||n===Ah)if(s=t.get("EXT_texture_compression_bptc"),s!==null){if(n===Mh)return o===Ie?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Sh)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Ah)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Eh||n===Th||n===Il||n===Rh)if(s=t.get("EXT_texture_compression_rgtc"),s!==null){if(n===Eh)return s.COMPRESSED_RED_RGTC1_EXT;if(n===Th)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Il)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Rh)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Qs?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var uP=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,hP=`
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

}`,lm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ul(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new zi({vertexShader:uP,fragmentShader:hP,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ge(new $s(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},cm=class extends Qi{constructor(t,e){super();let n=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,m=null,y=typeof XRWebGLBinding<"u",g=new lm,p={},x=e.getContextAttributes(),b=null,v=null,S=[],A=[],_=new Zt,w=null,N=null,P=new Hn;P.viewport=new Le;let I=new Hn;I.viewport=new Le;let U=[P,I],z=new Gu,C=null,O=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let dt=S[J];return dt===void 0&&(dt=new na,S[J]=dt),dt.getTargetRaySpace()},this.getControllerGrip=function(J){let dt=S[J];return dt===void 0&&(dt=new na,S[J]=dt),dt.getGripSpace()},this.getHand=function(J){let dt=S[J];return dt===void 0&&(dt=new na,S[J]=dt),dt.getHandSpace()};function W(J){let dt=A.indexOf(J.inputSource);if(dt===-1)return;let gt=S[dt];gt!==void 0&&(gt.update(J.inputSource,J.frame,c||o),gt.dispatchEvent({type:J.type,data:J.inputSource}))}function G(){r.removeEventListener("select",W),r.removeEventListener("selectstart",W),r.removeEventListener("selectend",W),r.removeEventListener("squeeze",W),r.removeEventListener("squeezestart",W),r.removeEventListener("squeezeend",W),r.removeEventListener("end",G),r.removeEventListener("inputsourceschange",et);for(let J=0;J<S.length;J++){let dt=A[J];dt!==null&&(A[J]=null,S[J].disconnect(dt))}C=null,O=null,g.reset();for(let J in p)delete p[J];if(t.setRenderTarget(b),d=null,f=null,h=null,r=null,v=null,ct.stop(),n.isPresenting=!1,t.setPixelRatio(w),t.setSize(_.width,_.height,!1),N!==null){let J=N.camera;J.fov=N.fov,J.zoom=N.zoom,J.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){s=J,n.isPresenting===!0&&Yt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){a=J,n.isPresenting===!0&&Yt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(J){c=J},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(r,e)),h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(J){if(r=J,r!==null){if(b=t.getRenderTarget(),r.addEventListener("select",W),r.addEventListener("selectstart",W),r.addEventListener("selectend",W),r.addEventListener("squeeze",W),r.addEventListener("squeezestart",W),r.addEventListener("squeezeend",W),r.addEventListener("end",G),r.addEventListener("inputsourceschange",et),x.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,bt=null,yt=null;x.depth&&(yt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=x.stencil?qr:Gr,bt=x.stencil?Qs:nr);let Gt={colorFormat:e.RGBA8,depthFormat:yt,scaleFactor:s};h=this.getBinding(),f=h.createProjectionLayer(Gt),r.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),v=new Ri(f.textureWidth,f.textureHeight,{format:sr,type:di,depthTexture:new Hr(f.textureWidth,f.textureHeight,bt,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let gt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(r,e,gt),r.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),v=new Ri(d.framebufferWidth,d.framebufferHeight,{format:sr,type:di,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),ct.setContext(r),ct.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function et(J){for(let dt=0;dt<J.removed.length;dt++){let gt=J.removed[dt],bt=A.indexOf(gt);bt>=0&&(A[bt]=null,S[bt].disconnect(gt))}for(let dt=0;dt<J.added.length;dt++){let gt=J.added[dt],bt=A.indexOf(gt);if(bt===-1){for(let Gt=0;Gt<S.length;Gt++)if(Gt>=A.length){A.push(gt),bt=Gt;break}else if(A[Gt]===null){A[Gt]=gt,bt=Gt;break}if(bt===-1)break}let yt=S[bt];yt&&yt.connect(gt)}}function $(J,dt){dt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(dt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(r===null)return;let dt=J.near,gt=J.far;g.texture!==null&&(g.depthNear>0&&(dt=g.depthNear),g.depthFar>0&&(gt=g.depthFar)),z.near=I.near=P.near=dt,z.far=I.far=P.far=gt,(C!==z.near||O!==z.far)&&(r.updateRenderState({depthNear:z.near,depthFar:z.far}),C=z.near,O=z.far),z.layers.mask=J.layers.mask|6,P.layers.mask=z.layers.mask&-5,I.layers.mask=z.layers.mask&-3;let bt=J.parent,yt=z.cameras;$(z,bt);for(let Gt=0;Gt<yt.length;Gt++)$(yt[Gt],bt);z.projectionMatrix.copy(P.projectionMatrix),z.projectionMatrixInverse.copy(P.projectionMatrixInverse),N===null&&J.isPerspectiveCamera&&(N={camera:J,fov:J.fov,zoom:J.zoom}),X(J,z,bt)};function X(J,dt,gt){gt===null?J.matrix.copy(dt.matrixWorld):(J.matrix.copy(gt.matrixWorld),J.matrix.invert(),J.matrix.multiply(dt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(dt.projectionMatrix),J.projectionMatrixInverse.copy(dt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=ta*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(J){l=J,f!==null&&(f.fixedFoveation=J),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=J)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(z)},this.getCameraTexture=function(J){return p[J]};let tt=null;function ht(J,dt){if(u=dt.getViewerPose(c||o),m=dt,u!==null){let gt=u.views;d!==null&&(t.setRenderTargetFramebuffer(v,d.framebuffer),t.setRenderTarget(v));let bt=!1;gt.length!==z.cameras.length&&(z.cameras.length=0,bt=!0);for(let zt=0;zt<gt.length;zt++){let le=gt[zt],oe=null;if(d!==null)oe=d.getViewport(le);else{let Fe=h.getViewSubImage(f,le);oe=Fe.viewport,zt===0&&(t.setRenderTargetTextures(v,Fe.colorTexture,Fe.depthStencilTexture),t.setRenderTarget(v))}let Jt=U[zt];Jt===void 0&&(Jt=new Hn,Jt.layers.enable(zt),Jt.viewport=new Le,U[zt]=Jt),Jt.matrix.fromArray(le.transform.matrix),Jt.matrix.decompose(Jt.position,Jt.quaternion,Jt.scale),Jt.projectionMatrix.fromArray(le.projectionMatrix),Jt.projectionMatrixInverse.copy(Jt.projectionMatrix).invert(),Jt.viewport.set(oe.x,oe.y,oe.width,oe.height),zt===0&&(z.matrix.copy(Jt.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),bt===!0&&z.cameras.push(Jt)}let yt=r.enabledFeatures;if(yt&&yt.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&y){h=n.getBinding();let zt=h.getDepthInformation(gt[0]);zt&&zt.isValid&&zt.texture&&g.init(zt,r.renderState)}if(yt&&yt.includes("camera-access")&&y){t.state.unbindTexture(),h=n.getBinding();for(let zt=0;zt<gt.length;zt++){let le=gt[zt].camera;if(le){let oe=p[le];oe||(oe=new ul,p[le]=oe);let Jt=h.getCameraImage(le);oe.sourceTexture=Jt}}}}for(let gt=0;gt<S.length;gt++){let bt=A[gt],yt=S[gt];bt!==null&&yt!==void 0&&yt.update(bt,dt,c||o)}tt&&tt(J,dt),dt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:dt}),m=null}let ct=new O_;ct.setAnimationLoop(ht),this.setAnimationLoop=function(J){tt=J},this.dispose=function(){}}},fP=new $e,$_=new se;$_.set(-1,0,0,0,1,0,0,0,1);function dP(i,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,Zp(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function r(g,p,x,b,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?s(g,p):p.isMeshLambertMaterial?(s(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(s(g,p),h(g,p)):p.isMeshPhongMaterial?(s(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(s(g,p),f(g,p),p.isMeshPhysicalMaterial&&d(g,p,v)):p.isMeshMatcapMaterial?(s(g,p),m(g,p)):p.isMeshDepthMaterial?s(g,p):p.isMeshDistanceMaterial?(s(g,p),y(g,p)):p.isMeshNormalMaterial?s(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,x,b):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===ci&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===ci&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let x=t.get(p),b=x.envMap,v=x.envMapRotation;b&&(g.envMap.value=b,g.envMapRotation.value.setFromMatrix4(fP.makeRotationFromEuler(v)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply($_),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,x,b){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*x,g.scale.value=b*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function f(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function d(g,p,x){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ci&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function y(g,p){let x=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function pP(i,t,e,n){let r={},s={};function o(x,b){let v=b.program;n.uniformBlockBinding(x,v,r[x.id])}function a(x,b){let v=r[x.id];v===void 0&&(m(x),v=l(x),r[x.id]=v,x.addEventListener("dispose",g));let S=b.program;n.updateUBOMapping(x,S);let A=t.render.frame;s[x.id]!==A&&(c(x),s[x.id]=A)}function l(x){let b=i.createBuffer(),v=x.__size,S=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,b),i.bufferData(i.UNIFORM_BUFFER,v,S),i.bindBuffer(i.UNIFORM_BUFFER,null),b}function c(x){let b=r[x.id],v=x.uniforms,S=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,b);for(let A=0,_=v.length;A<_;A++){let w=v[A];if(Array.isArray(w))for(let N=0,P=w.length;N<P;N++)u(w[N],A,N,S);else u(w,A,0,S)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(x,b,v,S){if(f(x,b,v,S)===!0){let A=x.__offset,_=x.value;if(Array.isArray(_)){let w=0;for(let N=0;N<_.length;N++){let P=_[N],I=y(P,!0);h(P,x.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,x.__data)}}function h(x,b,v){typeof x=="number"||typeof x=="boolean"?b[v]=x:x.isMatrix3?(b[v]=x.elements[0],b[v+1]=x.elements[1],b[v+2]=x.elements[2],b[v+3]=0,b[v+4]=x.elements[3],b[v+5]=x.elements[4],b[v+6]=x.elements[5],b[v+7]=0,b[v+8]=x.elements[6],b[v+9]=x.elements[7],b[v+10]=x.elements[8],b[v+11]=0):ArrayBuffer.isView(x)?b.set(x.subarray(0,b.length-v),v):x.toArray(b,v)}function f(x,b,v,S){let A=x.value,_=b+"_"+v;if(Array.isArray(A)){S[_]===void 0&&(S[_]=[]);let w=S[_],N=!1;for(let P=0;P<A.length;P++)d(A[P],w,P)===!0&&(N=!0);return N}return d(A,S,_)}function d(x,b,v){if(b[v]===void 0)return typeof x=="number"||typeof x=="boolean"?b[v]=x:ArrayBuffer.isView(x)?b[v]=x.slice():b[v]=x.clone(),!0;{let S=b[v];if(typeof x=="number"||typeof x=="boolean"){if(S!==x)return b[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(S.equals(x)===!1)return S.copy(x),!0}}return!1}function m(x){let b=x.uniforms,v=0,S=16;for(let _=0,w=b.length;_<w;_++){let N=Array.isArray(b[_])?b[_]:[b[_]];for(let P=0,I=N.length;P<I;P++){let U=N[P],z=Array.isArray(U.value)?U.value:[U.value],C=Array.isArray(b[_])||Array.isArray(U.value),O=v;for(let G=0,et=z.length;G<et;G++){let $=z[G],X=y($,C),tt=v%S,ht=tt%X.boundary,ct=tt+ht;v+=ht,ct!==0&&S-ct<X.storage&&(v+=S-ct),G===0&&(O=v),v+=X.storage}let W=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new W((v-O)/Float32Array.BYTES_PER_ELEMENT),U.__offset=O}}let A=v%S;return A>0&&(v+=S-A),x.__size=v,x.__cache={},this}function y(x,b){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?Yt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):Yt("WebGLRenderer: Unsupported uniform value type.",x),b===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(x){let b=x.target;b.removeEventListener("dispose",g),i.deleteBuffer(r[b.id]),delete r[b.id],delete s[b.id]}function p(){for(let x in r)i.deleteBuffer(r[x]);r={},s={}}return{bind:o,update:a,dispose:p}}var mP=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),wr=null;function gP(){return wr===null&&(wr=new Mu(mP,16,16,Ms,rr),wr.name="DFG_LUT",wr.minFilter=ai,wr.magFilter=ai,wr.wrapS=xr,wr.wrapT=xr,wr.generateMipmaps=!1,wr.needsUpdate=!0),wr}var Fh=class{constructor(t={}){let{canvas:e=l_(),context:n=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=di}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let y=d,g=new Set([Ju,Ku,Zu]),p=new Set([di,nr,ha,Qs,ju,Yu]),x=new Uint32Array(4),b=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},S=null,A=null,_=[],w=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=br,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,I=!1,U=null,z=null,C=null,O=null;this._outputColorSpace=Ei;let W=0,G=0,et=null,$=-1,X=null,tt=new Le,ht=new Le,ct=null,J=new he(0),dt=0,gt=e.width,bt=e.height,yt=1,Gt=null,Kt=null,zt=new Le(0,0,gt,bt),le=new Le(0,0,gt,bt),oe=!1,Jt=new ds,Fe=new Su,Ae=!1,hn=!1,Ft=new $e,xe=new V,te=new Le,Ye={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ze=!1;function on(){return et===null?yt:1}let k=n;function xt(R,H){return e.getContext(R,H)}let Xt,ce,At,He,Ht,jt,L,E,j,ft,at,_t,wt,nt,st,mt,B,ot,it,Et,vt,St,Wt;try{let R={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ne,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),k===null){let H="webgl2";if(k=xt(H,R),k===null)throw xt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ee()}catch(R){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),re("WebGLRenderer: "+R.message),R}function ee(){Xt=new TC(k),Xt.init(),vt=new cP(k,Xt),ce=new gC(k,Xt,t,vt),At=new aP(k,Xt),ce.reversedDepthBuffer&&f&&At.buffers.depth.setReversed(!0),z=k.createFramebuffer(),C=k.createFramebuffer(),O=k.createFramebuffer(),He=new PC(k),Ht=new X2,jt=new lP(k,Xt,At,Ht,ce,vt,He),L=new EC(P),E=new LE(k),St=new pC(k,E),j=new RC(k,E,He,St),ft=new LC(k,j,E,St,He),ot=new IC(k,ce,jt),st=new yC(Ht),at=new $2(P,L,Xt,ce,St,st),_t=new dP(P,Ht),wt=new Y2,nt=new eP(Xt),B=new dC(P,L,At,ft,m,l),mt=new oP(P,ft,ce),Wt=new pP(k,He,ce,At),it=new mC(k,Xt,He),Et=new CC(k,Xt,He),He.programs=at.programs,P.capabilities=ce,P.extensions=Xt,P.properties=Ht,P.renderLists=wt,P.shadowMap=mt,P.state=At,P.info=He}y!==di&&(N=new NC(y,e.width,e.height,a,r,s));let ut=new cm(P,k);this.xr=ut,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=Xt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Xt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return yt},this.setPixelRatio=function(R){R!==void 0&&(yt=R,this.setSize(gt,bt,!1))},this.getSize=function(R){return R.set(gt,bt)},this.setSize=function(R,H,Q=!0){if(ut.isPresenting){Yt("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=R,bt=H,e.width=Math.floor(R*yt),e.height=Math.floor(H*yt),Q===!0&&(e.style.width=R+"px",e.style.height=H+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(gt*yt,bt*yt).floor()},this.setDrawingBufferSize=function(R,H,Q){gt=R,bt=H,yt=Q,e.width=Math.floor(R*Q),e.height=Math.floor(H*Q),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(y===di){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Yt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(tt)},this.getViewport=function(R){return R.copy(zt)},this.setViewport=function(R,H,Q,Y){R.isVector4?zt.set(R.x,R.y,R.z,R.w):zt.set(R,H,Q,Y),At.viewport(tt.copy(zt).multiplyScalar(on()).round())},this.getScissor=function(R){return R.copy(le)},this.setScissor=function(R,H,Q,Y){R.isVector4?le.set(R.x,R.y,R.z,R.w):le.set(R,H,Q,Y),At.scissor(ht.copy(le).multiplyScalar(on()).round())},this.getScissorTest=function(){return oe},this.setScissorTest=function(R){At.setScissorTest(oe=R)},this.setOpaqueSort=function(R){Gt=R},this.setTransparentSort=function(R){Kt=R},this.getClearColor=function(R){return R.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,Q=!0){let Y=0;if(R){let Z=!1;if(et!==null){let Tt=et.texture.format;Z=g.has(Tt)}if(Z){let Tt=et.texture.type,It=p.has(Tt),Rt=B.getClearColor(),Lt=B.getClearAlpha(),Vt=Rt.r,ie=Rt.g,me=Rt.b;It?(x[0]=Vt,x[1]=ie,x[2]=me,x[3]=Lt,k.clearBufferuiv(k.COLOR,0,x)):(b[0]=Vt,b[1]=ie,b[2]=me,b[3]=Lt,k.clearBufferiv(k.COLOR,0,b))}else Y|=k.COLOR_BUFFER_BIT}H&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),U=R},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),B.dispose(),wt.dispose(),nt.dispose(),jt.dispose(),Ht.dispose(),L.dispose(),ft.dispose(),j.dispose(),St.dispose(),Wt.dispose(),at.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",jl),ut.removeEventListener("sessionend",ar),Tr.stop()};function kt(R){R.preventDefault(),el("WebGLRenderer: Context Lost."),I=!0}function ne(){el("WebGLRenderer: Context Restored."),I=!1;let R=He.autoReset,H=mt.enabled,Q=mt.autoUpdate,Y=mt.needsUpdate,Z=mt.type;ee(),He.autoReset=R,mt.enabled=H,mt.autoUpdate=Q,mt.needsUpdate=Y,mt.type=Z}function Ct(R){re("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function fe(R){let H=R.target;H.removeEventListener("dispose",fe),Ke(H)}function Ke(R){Jn(R),Ht.remove(R)}function Jn(R){let H=Ht.get(R).programs;H!==void 0&&(H.forEach(function(Q){at.releaseProgram(Q)}),R.isShaderMaterial&&at.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,Q,Y,Z,Tt){H===null&&(H=Ye);let It=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Rt=ba(R,H,Q,Y,Z);At.setMaterial(Y,It);let Lt=Q.index,Vt=1;if(Y.wireframe===!0){if(Lt=j.getWireframeAttribute(Q),Lt===void 0)return;Vt=2}let ie=Q.drawRange,me=Q.attributes.position,Bt=ie.start*Vt,ge=(ie.start+ie.count)*Vt;Tt!==null&&(Bt=Math.max(Bt,Tt.start*Vt),ge=Math.min(ge,(Tt.start+Tt.count)*Vt)),Lt!==null?(Bt=Math.max(Bt,0),ge=Math.min(ge,Lt.count)):me!=null&&(Bt=Math.max(Bt,0),ge=Math.min(ge,me.count));let an=ge-Bt;if(an<0||an===1/0)return;St.setup(Z,Y,Rt,Q,Lt);let Ne,De=it;if(Lt!==null&&(Ne=E.get(Lt),De=Et,De.setIndex(Ne)),Z.isMesh)Y.wireframe===!0?(At.setLineWidth(Y.wireframeLinewidth*on()),De.setMode(k.LINES)):De.setMode(k.TRIANGLES);else if(Z.isLine){let En=Y.linewidth;En===void 0&&(En=1),At.setLineWidth(En*on()),Z.isLineSegments?De.setMode(k.LINES):Z.isLineLoop?De.setMode(k.LINE_LOOP):De.setMode(k.LINE_STRIP)}else Z.isPoints?De.setMode(k.POINTS):Z.isSprite&&De.setMode(k.TRIANGLES);if(Z.isBatchedMesh)if(Xt.get("WEBGL_multi_draw"))De.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let En=Z._multiDrawStarts,Ot=Z._multiDrawCounts,vn=Z._multiDrawCount,ve=Lt?E.get(Lt).bytesPerElement:1,Cr=Ht.get(Y).currentProgram.getUniforms();for(let _n=0;_n<vn;_n++)Cr.setValue(k,"_gl_DrawID",_n),De.render(En[_n]/ve,Ot[_n])}else if(Z.isInstancedMesh)De.renderInstances(Bt,an,Z.count);else if(Q.isInstancedBufferGeometry){let En=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ot=Math.min(Q.instanceCount,En);De.renderInstances(Bt,an,Ot)}else De.render(Bt,an)};function xa(R,H,Q,Y){U!==null&&R.isNodeMaterial&&U.setObject(Y,R),Ae===!0&&st.setState(R,Q,!1),R.transparent===!0&&R.side===Vi&&R.forceSinglePass===!1?(R.side=ci,R.needsUpdate=!0,lr(R,H,Y),R.side=ws,R.needsUpdate=!0,lr(R,H,Y),R.side=Vi):lr(R,H,Y)}this.compile=function(R,H,Q=null){Q===null&&(Q=R),U!==null&&U.renderStart(R,H,Q),A=nt.get(Q),A.init(H),w.push(A),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),R!==Q&&R.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),U!==null&&U.updateLights(A.state.lightsArray),hn=this.localClippingEnabled,Ae=st.init(this.clippingPlanes,hn),Ae===!0&&st.setGlobalState(this.clippingPlanes,H),U!==null&&mt.render(A.state.shadowsArray,Q,H);let Y=new Set;return R.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Tt=Z.material;if(Tt)if(Array.isArray(Tt))for(let It=0;It<Tt.length;It++){let Rt=Tt[It];xa(Rt,Q,H,Z),Y.add(Rt)}else xa(Tt,Q,H,Z),Y.add(Tt)}),A=w.pop(),U!==null&&U.renderEnd(),Y},this.compileAsync=function(R,H,Q=null){let Y=this.compile(R,H,Q);return new Promise(Z=>{function Tt(){if(Y.forEach(function(It){let Lt=Ht.get(It).currentProgram;(Lt===void 0||Lt.isReady())&&Y.delete(It)}),Y.size===0){Z(R);return}setTimeout(Tt,10)}Xt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let so=null;function hf(R){so&&so(R)}function jl(){Tr.stop()}function ar(){Tr.start()}let Tr=new O_;Tr.setAnimationLoop(hf),typeof self<"u"&&Tr.setContext(self),this.setAnimationLoop=function(R){so=R,ut.setAnimationLoop(R),R===null?Tr.stop():Tr.start()},ut.addEventListener("sessionstart",jl),ut.addEventListener("sessionend",ar),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;U!==null&&U.renderStart(R,H);let Q=ut.enabled===!0&&ut.isPresenting===!0,Y=N!==null&&(et===null||Q)&&N.begin(P,et);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(H),H=ut.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,H,et),A=nt.get(R,w.length),A.init(H),A.state.textureUnits=jt.getTextureUnits(),w.push(A),Ft.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?Fe.setFromArrayCamera(H):Jt.setFromProjectionMatrix(Ft,ki,H.reversedDepth),hn=this.localClippingEnabled,Ae=st.init(this.clippingPlanes,hn),S=wt.get(R,_.length),S.init(),_.push(S),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let It=P.xr.getDepthSensingMesh();It!==null&&Rr(It,H,-1/0,P.sortObjects)}Rr(R,H,0,P.sortObjects),S.finish(),U!==null&&U.updateLights(A.state.lightsArray),P.sortObjects===!0&&S.sort(Gt,Kt),Ze=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Ze&&B.addToRenderList(S,R),this.info.autoReset===!0&&this.info.reset(),Ae===!0&&st.beginShadows();let Z=A.state.shadowsArray;if(mt.render(Z,R,H),Ae===!0&&st.endShadows(),(Y&&N.hasRenderPass())===!1){let It=S.opaque,Rt=S.transmissive;if(A.setupLights(),H.isArrayCamera){let Lt=H.cameras;if(Rt.length>0)for(let Vt=0,ie=Lt.length;Vt<ie;Vt++){let me=Lt[Vt];Hi(It,Rt,R,me)}Ze&&B.render(R);for(let Vt=0,ie=Lt.length;Vt<ie;Vt++){let me=Lt[Vt];va(S,R,me,me.viewport)}}else Rt.length>0&&Hi(It,Rt,R,H),Ze&&B.render(R),va(S,R,H)}et!==null&&G===0&&(jt.updateMultisampleRenderTarget(et),jt.updateRenderTargetMipmap(et)),Y&&N.end(P),R.isScene===!0&&R.onAfterRender(P,R,H),St.resetDefaultState(),$=-1,X=null,w.pop(),w.length>0?(A=w[w.length-1],jt.setTextureUnits(A.state.textureUnits),Ae===!0&&st.setGlobalState(P.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?S=_[_.length-1]:S=null,U!==null&&U.renderEnd()};function Rr(R,H,Q,Y){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)Q=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)A.pushLight(R),R.castShadow&&A.pushShadow(R);else if(R.isSprite){let It=H.isArrayCamera?Fe:Jt;if(!R.frustumCulled||R.intersectsFrustum(It)){Y&&te.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ft);let Rt=ft.update(R),Lt=R.material;Lt.visible&&S.push(R,Rt,Lt,Q,te.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let It=H.isArrayCamera?Fe:Jt;if(!R.frustumCulled||R.intersectsFrustum(It)){let Rt=ft.update(R),Lt=R.material;if(Y&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),te.copy(R.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),te.copy(Rt.boundingSphere.center)),te.applyMatrix4(R.matrixWorld).applyMatrix4(Ft)),Array.isArray(Lt)){let Vt=Rt.groups;for(let ie=0,me=Vt.length;ie<me;ie++){let Bt=Vt[ie],ge=Lt[Bt.materialIndex];ge&&ge.visible&&S.push(R,Rt,ge,Q,te.z,Bt,H)}}else Lt.visible&&S.push(R,Rt,Lt,Q,te.z,null,H)}}}let Tt=R.children;for(let It=0,Rt=Tt.length;It<Rt;It++)Rr(Tt[It],H,Q,Y)}function va(R,H,Q,Y){let{opaque:Z,transmissive:Tt,transparent:It}=R;A.setupLightsView(Q),Ae===!0&&st.setGlobalState(P.clippingPlanes,Q),Y&&At.viewport(tt.copy(Y)),Z.length>0&&fn(Z,H,Q),Tt.length>0&&fn(Tt,H,Q),It.length>0&&fn(It,H,Q),At.buffers.depth.setTest(!0),At.buffers.depth.setMask(!0),At.buffers.color.setMask(!0),At.setPolygonOffset(!1)}function Hi(R,H,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let Bt=Xt.has("EXT_color_buffer_half_float")||Xt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new Ri(1,1,{generateMipmaps:!0,type:Bt?rr:di,minFilter:Wr,samples:Math.max(4,ce.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:be.workingColorSpace})}let Tt=A.state.transmissionRenderTarget[Y.id],It=Y.viewport||tt;Tt.setSize(It.z*P.transmissionResolutionScale,It.w*P.transmissionResolutionScale);let Rt=P.getRenderTarget(),Lt=P.getActiveCubeFace(),Vt=P.getActiveMipmapLevel();P.setRenderTarget(Tt),P.getClearColor(J),dt=P.getClearAlpha(),dt<1&&P.setClearColor(16777215,.5),P.clear(),Ze&&B.render(Q);let ie=P.toneMapping;P.toneMapping=br;let me=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),Ae===!0&&st.setGlobalState(P.clippingPlanes,Y),fn(R,Q,Y),jt.updateMultisampleRenderTarget(Tt),jt.updateRenderTargetMipmap(Tt),Xt.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let ge=0,an=H.length;ge<an;ge++){let Ne=H[ge],{object:De,geometry:En,material:Ot,group:vn}=Ne;if(Ot.side===Vi&&De.layers.test(Y.layers)){let ve=Ot.side;Ot.side=ci,Ot.needsUpdate=!0,yn(De,Q,Y,En,Ot,vn),Ot.side=ve,Ot.needsUpdate=!0,Bt=!0}}Bt===!0&&(jt.updateMultisampleRenderTarget(Tt),jt.updateRenderTargetMipmap(Tt))}P.setRenderTarget(Rt,Lt,Vt),P.setClearColor(J,dt),me!==void 0&&(Y.viewport=me),P.toneMapping=ie}function fn(R,H,Q){let Y=H.isScene===!0?H.overrideMaterial:null;for(let Z=0,Tt=R.length;Z<Tt;Z++){let It=R[Z],{object:Rt,geometry:Lt,group:Vt}=It,ie=It.material;ie.allowOverride===!0&&Y!==null&&(ie=Y),Rt.layers.test(Q.layers)&&yn(Rt,H,Q,Lt,ie,Vt)}}function yn(R,H,Q,Y,Z,Tt){U!==null&&Z.isNodeMaterial&&U.setObject(R,Z),R.onBeforeRender(P,H,Q,Y,Z,Tt),R.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Z.onBeforeRender(P,H,Q,Y,R,Tt),Z.transparent===!0&&Z.side===Vi&&Z.forceSinglePass===!1?(Z.side=ci,Z.needsUpdate=!0,P.renderBufferDirect(Q,H,Y,Z,R,Tt),Z.side=ws,Z.needsUpdate=!0,P.renderBufferDirect(Q,H,Y,Z,R,Tt),Z.side=Vi):P.renderBufferDirect(Q,H,Y,Z,R,Tt),R.onAfterRender(P,H,Q,Y,Z,Tt)}function xn(R){let H=0;for(let Q of R)Q.texture!==null&&H++;return H}function lr(R,H,Q){H.isScene!==!0&&(H=Ye);let Y=Ht.get(R),Z=A.state.lights,Tt=A.state.shadowsArray,It=Z.state.version,Rt=at.getParameters(R,Z.state,Tt,H,Q,A.state.lightProbeGridArray),Lt=at.getProgramCacheKey(Rt),Vt=Y.programs;Y.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,Y.fog=H.fog;let ie=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Y.envMap=L.get(R.envMap||Y.environment,ie),Y.envMapRotation=Y.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,Vt===void 0&&(R.addEventListener("dispose",fe),Vt=new Map,Y.programs=Vt,Y.programVariants=new Map);let me=Vt.get(Lt);if(me!==void 0){if(Y.currentProgram===me&&Y.lightsStateVersion===It)return _a(R,Rt),me}else Rt.uniforms=at.getUniforms(R),U!==null&&R.isNodeMaterial&&U.build(R,Q,Rt),R.onBeforeCompile(Rt,P),me=at.acquireProgram(Rt,Lt),Vt.set(Lt,me),Y.uniforms=Rt.uniforms;let Bt=Y.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Bt.clippingPlanes=st.uniform),_a(R,Rt),Y.needsLights=Yr(R),Y.lightsStateVersion=It,Y.needsLights&&(Bt.ambientLightColor.value=Z.state.ambient,Bt.lightProbe.value=Z.state.probe,Bt.sunLights.value=Z.state.sun,Bt.sunLightShadows.value=Z.state.sunShadow,Bt.directionalLights.value=Z.state.directional,Bt.directionalLightShadows.value=Z.state.directionalShadow,Bt.spotLights.value=Z.state.spot,Bt.spotLightShadows.value=Z.state.spotShadow,Bt.rectAreaLights.value=Z.state.rectArea,Bt.ltc_1.value=Z.state.rectAreaLTC1,Bt.ltc_2.value=Z.state.rectAreaLTC2,Bt.pointLights.value=Z.state.point,Bt.pointLightShadows.value=Z.state.pointShadow,Bt.hemisphereLights.value=Z.state.hemi,Bt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Bt.sunShadowCascade.value=Z.state.sunShadowCascade,Bt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Bt.spotLightMatrix.value=Z.state.spotLightMatrix,Bt.spotLightMap.value=Z.state.spotLightMap,Bt.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=xn(A.state.lightProbeGridArray),Y.currentProgram=me,Y.uniformsList=null,me}function mi(R,H,Q,Y,Z){let Tt=Ht.get(R),It=Tt.currentProgram.id+","+Y+","+Z,Rt=Tt.programVariants.get(It);return Rt===void 0?(Rt=lr(R,H,Q),Tt.programVariants.set(It,Rt)):(Tt.currentProgram=Rt,Tt.uniformsList=null,Tt.outputColorSpace=Y,Tt.toneMapping=Z),Rt}function jr(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=fa.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function _a(R,H){let Q=Ht.get(R);Q.outputColorSpace=H.outputColorSpace,Q.batching=H.batching,Q.batchingColor=H.batchingColor,Q.instancing=H.instancing,Q.instancingColor=H.instancingColor,Q.instancingMorph=H.instancingMorph,Q.skinning=H.skinning,Q.morphTargets=H.morphTargets,Q.morphNormals=H.morphNormals,Q.morphColors=H.morphColors,Q.morphTargetsCount=H.morphTargetsCount,Q.numClippingPlanes=H.numClippingPlanes,Q.numIntersection=H.numClipIntersection,Q.vertexAlphas=H.vertexAlphas,Q.vertexTangents=H.vertexTangents,Q.toneMapping=H.toneMapping}function ba(R,H,Q,Y,Z){H.isScene!==!0&&(H=Ye),jt.resetTextureUnits();let Tt=H.fog,It=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?H.environment:null,Rt=et===null?P.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:be.workingColorSpace,Lt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Vt=L.get(Y.envMap||It,Lt),ie=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,me=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Bt=!!Q.morphAttributes.position,ge=!!Q.morphAttributes.normal,an=!!Q.morphAttributes.color,Ne=br;Y.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(Ne=P.toneMapping);let De=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,En=De!==void 0?De.length:0,Ot=Ht.get(Y),vn=A.state.lights;if(Ae===!0&&(hn===!0||R!==X)){let Oe=R===X&&Y.id===$;st.setState(Y,R,Oe)}let ve=!1,Cr=!1;Y.version===Ot.__version?Ot.needsLights&&Ot.lightsStateVersion!==vn.state.version||Z.isBatchedMesh&&Ot.batching===!1||!Z.isBatchedMesh&&Ot.batching===!0||Z.isBatchedMesh&&Ot.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ot.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ot.instancing===!1||!Z.isInstancedMesh&&Ot.instancing===!0||Z.isSkinnedMesh&&Ot.skinning===!1||!Z.isSkinnedMesh&&Ot.skinning===!0||Z.isInstancedMesh&&Ot.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ot.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ot.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ot.instancingMorph===!1&&Z.morphTexture!==null||Ot.envMap!==Vt||Y.fog===!0&&Ot.fog!==Tt||Ot.numClippingPlanes!==void 0&&(Ot.numClippingPlanes!==st.numPlanes||Ot.numIntersection!==st.numIntersection)||Ot.vertexAlphas!==ie||Ot.vertexTangents!==me||Ot.morphTargets!==Bt||Ot.morphNormals!==ge||Ot.morphColors!==an||Ot.morphTargetsCount!==En||Ot.numLightProbeGrids!==xn(A.state.lightProbeGridArray)?ve=!0:(Ot.outputColorSpace!==Rt||Ot.toneMapping!==Ne)&&(Cr=!0):(ve=!0,Ot.__version=Y.version);let _n=Ot.currentProgram;(ve===!0||Cr===!0)&&(_n=Cr===!0?mi(Y,H,Z,Rt,Ne):lr(Y,H,Z),U&&Y.isNodeMaterial&&U.onUpdateProgram(Y,_n,Ot));let lo=!1,cr=!1,Pr=!1,de=_n.getUniforms(),dn=Ot.uniforms;if(At.useProgram(_n.program)&&(lo=!0,cr=!0,Pr=!0),Y.id!==$&&($=Y.id,cr=!0),lo||X!==R){At.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),de.setValue(k,"projectionMatrix",R.projectionMatrix),de.setValue(k,"viewMatrix",R.matrixWorldInverse);let bn=de.map.cameraPosition;bn!==void 0&&bn.setValue(k,xe.setFromMatrixPosition(R.matrixWorld)),ce.logarithmicDepthBuffer&&de.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&de.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),X!==R&&(X=R,cr=!0,Pr=!0)}if(Ot.needsLights&&(vn.state.sunShadowMap.length>0&&de.setValue(k,"sunShadowMap",vn.state.sunShadowMap,jt),vn.state.directionalShadowMap.length>0&&de.setValue(k,"directionalShadowMap",vn.state.directionalShadowMap,jt),vn.state.spotShadowMap.length>0&&de.setValue(k,"spotShadowMap",vn.state.spotShadowMap,jt),vn.state.pointShadowMap.length>0&&de.setValue(k,"pointShadowMap",vn.state.pointShadowMap,jt)),Z.isSkinnedMesh){de.setOptional(k,Z,"bindMatrix"),de.setOptional(k,Z,"bindMatrixInverse");let Oe=Z.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),de.setValue(k,"boneTexture",Oe.boneTexture,jt))}Z.isBatchedMesh&&(de.setOptional(k,Z,"batchingTexture"),de.setValue(k,"batchingTexture",Z._matricesTexture,jt),de.setOptional(k,Z,"batchingIdTexture"),de.setValue(k,"batchingIdTexture",Z._indirectTexture,jt),de.setOptional(k,Z,"batchingColorTexture"),Z._colorsTexture!==null&&de.setValue(k,"batchingColorTexture",Z._colorsTexture,jt));let Qn=Q.morphAttributes;if((Qn.position!==void 0||Qn.normal!==void 0||Qn.color!==void 0)&&ot.update(Z,Q,_n),(cr||Ot.receiveShadow!==Z.receiveShadow)&&(Ot.receiveShadow=Z.receiveShadow,de.setValue(k,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&H.environment!==null&&(dn.envMapIntensity.value=H.environmentIntensity),dn.dfgLUT!==void 0&&(dn.dfgLUT.value=gP()),cr){if(de.setValue(k,"toneMappingExposure",P.toneMappingExposure),Ot.needsLights&&oo(dn,Pr),Tt&&Y.fog===!0&&_t.refreshFogUniforms(dn,Tt),_t.refreshMaterialUniforms(dn,Y,yt,bt,A.state.transmissionRenderTarget[R.id]),Ot.needsLights&&Ot.numLightProbeGrids>0){let Oe=v,bn=0;for(let jn of A.state.lightProbeGridArray)jn.texture!==null&&(Oe.textures[bn]=jn.texture,Oe.min[bn]=jn.boundingBox.min,Oe.max[bn]=jn.boundingBox.max,Oe.resolution[bn]=jn.resolution,bn++);for(let jn in Oe)Oe[jn].length=bn;dn.probesSH.value=Oe.textures,dn.probesMin.value=Oe.min,dn.probesMax.value=Oe.max,dn.probesResolution.value=Oe.resolution}fa.upload(k,jr(Ot),dn,jt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(fa.upload(k,jr(Ot),dn,jt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&de.setValue(k,"center",Z.center),de.setValue(k,"modelViewMatrix",Z.modelViewMatrix),de.setValue(k,"normalMatrix",Z.normalMatrix),de.setValue(k,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Oe=Y.uniformsGroups;for(let bn=0,jn=Oe.length;bn<jn;bn++){let Yl=Oe[bn];Wt.update(Yl,_n),Wt.bind(Yl,_n)}}return _n}function oo(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function Yr(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(R,H,Q){let Y=Ht.get(R);Y.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ht.get(R.texture).__webglTexture=H,Ht.get(R.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let Q=Ht.get(R);Q.__webglFramebuffer=H,Q.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,Q=0){et=R,W=H,G=Q;let Y=null,Z=!1,Tt=!1;if(R){let Rt=Ht.get(R);if(Rt.__useDefaultFramebuffer!==void 0){At.bindFramebuffer(k.FRAMEBUFFER,Rt.__webglFramebuffer),tt.copy(R.viewport),ht.copy(R.scissor),ct=R.scissorTest,At.viewport(tt),At.scissor(ht),At.setScissorTest(ct),$=-1;return}else if(Rt.__webglFramebuffer===void 0)jt.setupRenderTarget(R);else if(Rt.__hasExternalTextures)jt.rebindTextures(R,Ht.get(R.texture).__webglTexture,Ht.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let ie=R.depthTexture;if(Rt.__boundDepthTexture!==ie){if(ie!==null&&Ht.has(ie)&&(R.width!==ie.image.width||R.height!==ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");jt.setupDepthRenderbuffer(R)}}let Lt=R.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Tt=!0);let Vt=Ht.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Vt[H])?Y=Vt[H][Q]:Y=Vt[H],Z=!0):R.samples>0&&jt.useMultisampledRTT(R)===!1?Y=Ht.get(R).__webglMultisampledFramebuffer:Array.isArray(Vt)?Y=Vt[Q]:Y=Vt,tt.copy(R.viewport),ht.copy(R.scissor),ct=R.scissorTest}else tt.copy(zt).multiplyScalar(yt).floor(),ht.copy(le).multiplyScalar(yt).floor(),ct=oe;if(Q!==0&&(Y=z),At.bindFramebuffer(k.FRAMEBUFFER,Y)&&At.drawBuffers(R,Y),At.viewport(tt),At.scissor(ht),At.setScissorTest(ct),Z){let Rt=Ht.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+H,Rt.__webglTexture,Q)}else if(Tt){let Rt=H;for(let Lt=0;Lt<R.textures.length;Lt++){let Vt=Ht.get(R.textures[Lt]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Lt,Vt.__webglTexture,Q,Rt)}}else if(R!==null&&Q!==0){let Rt=Ht.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Rt.__webglTexture,Q)}$=-1};function ao(R){let H=Ht.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=ce.textureFormatReadable(R.format),H.__typeReadable=ce.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,Q,Y,Z,Tt,It,Rt=0){if(!(R&&R.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Ht.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){At.bindFramebuffer(k.FRAMEBUFFER,Lt);try{let Vt=R.textures[Rt],ie=Vt.format,me=Vt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Bt=ao(Vt);if(Bt.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-Y&&Q>=0&&Q<=R.height-Z&&k.readPixels(H,Q,Y,Z,vt.convert(ie),vt.convert(me),Tt)}finally{let Vt=et!==null?Ht.get(et).__webglFramebuffer:null;At.bindFramebuffer(k.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(R,H,Q,Y,Z,Tt,It,Rt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Ht.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(H>=0&&H<=R.width-Y&&Q>=0&&Q<=R.height-Z){At.bindFramebuffer(k.FRAMEBUFFER,Lt);let Vt=R.textures[Rt],ie=Vt.format,me=Vt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Bt=ao(Vt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ge=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ge),k.bufferData(k.PIXEL_PACK_BUFFER,Tt.byteLength,k.STREAM_READ),k.readPixels(H,Q,Y,Z,vt.convert(ie),vt.convert(me),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let an=et!==null?Ht.get(et).__webglFramebuffer:null;At.bindFramebuffer(k.FRAMEBUFFER,an);let Ne=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await u_(k,Ne,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ge),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Tt),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(ge),k.deleteSync(Ne),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,Q=0){let Y=Math.pow(2,-Q),Z=Math.floor(R.image.width*Y),Tt=Math.floor(R.image.height*Y),It=H!==null?H.x:0,Rt=H!==null?H.y:0;jt.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,It,Rt,Z,Tt),At.unbindTexture()},this.copyTextureToTexture=function(R,H,Q=null,Y=null,Z=0,Tt=0){let It,Rt,Lt,Vt,ie,me,Bt,ge,an,Ne=R.isCompressedTexture?R.mipmaps[Tt]:R.image;if(Q!==null)It=Q.max.x-Q.min.x,Rt=Q.max.y-Q.min.y,Lt=Q.isBox3?Q.max.z-Q.min.z:1,Vt=Q.min.x,ie=Q.min.y,me=Q.isBox3?Q.min.z:0;else{let de=Math.pow(2,-Z);It=Math.floor(Ne.width*de),Rt=Math.floor(Ne.height*de),R.isDataArrayTexture?Lt=Ne.depth:R.isData3DTexture?Lt=Math.floor(Ne.depth*de):Lt=1,Vt=0,ie=0,me=0}Y!==null?(Bt=Y.x,ge=Y.y,an=Y.z):(Bt=0,ge=0,an=0);let De=vt.convert(H.format),En=vt.convert(H.type),Ot;H.isData3DTexture?(jt.setTexture3D(H,0),Ot=k.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(jt.setTexture2DArray(H,0),Ot=k.TEXTURE_2D_ARRAY):(jt.setTexture2D(H,0),Ot=k.TEXTURE_2D),At.activeTexture(k.TEXTURE0),At.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,H.flipY),At.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),At.pixelStorei(k.UNPACK_ALIGNMENT,H.unpackAlignment);let vn=At.getParameter(k.UNPACK_ROW_LENGTH),ve=At.getParameter(k.UNPACK_IMAGE_HEIGHT),Cr=At.getParameter(k.UNPACK_SKIP_PIXELS),_n=At.getParameter(k.UNPACK_SKIP_ROWS),lo=At.getParameter(k.UNPACK_SKIP_IMAGES);At.pixelStorei(k.UNPACK_ROW_LENGTH,Ne.width),At.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ne.height),At.pixelStorei(k.UNPACK_SKIP_PIXELS,Vt),At.pixelStorei(k.UNPACK_SKIP_ROWS,ie),At.pixelStorei(k.UNPACK_SKIP_IMAGES,me);let cr=R.isDataArrayTexture||R.isData3DTexture,Pr=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let de=Ht.get(R),dn=Ht.get(H),Qn=Ht.get(de.__renderTarget),Oe=Ht.get(dn.__renderTarget);At.bindFramebuffer(k.READ_FRAMEBUFFER,Qn.__webglFramebuffer),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let bn=0;bn<Lt;bn++)cr&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ht.get(R).__webglTexture,Z,me+bn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ht.get(H).__webglTexture,Tt,an+bn)),k.blitFramebuffer(Vt,ie,Vt+It,ie+Rt,Bt,ge,Bt+It,ge+Rt,k.DEPTH_BUFFER_BIT,k.NEAREST);At.bindFramebuffer(k.READ_FRAMEBUFFER,null),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Z!==0||R.isRenderTargetTexture||Ht.has(R)){let de=Ht.get(R),dn=Ht.get(H);At.bindFramebuffer(k.READ_FRAMEBUFFER,C),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,O);for(let Qn=0;Qn<Lt;Qn++)cr?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,de.__webglTexture,Z,me+Qn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,de.__webglTexture,Z),Pr?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,dn.__webglTexture,Tt,an+Qn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,dn.__webglTexture,Tt),Z!==0?k.blitFramebuffer(Vt,ie,Vt+It,ie+Rt,Bt,ge,Bt+It,ge+Rt,k.COLOR_BUFFER_BIT,k.NEAREST):Pr?k.copyTexSubImage3D(Ot,Tt,Bt,ge,an+Qn,Vt,ie,It,Rt):k.copyTexSubImage2D(Ot,Tt,Bt,ge,Vt,ie,It,Rt);At.bindFramebuffer(k.READ_FRAMEBUFFER,null),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Pr?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(Ot,Tt,Bt,ge,an,It,Rt,Lt,De,En,Ne.data):H.isCompressedArrayTexture?k.compressedTexSubImage3D(Ot,Tt,Bt,ge,an,It,Rt,Lt,De,Ne.data):k.texSubImage3D(Ot,Tt,Bt,ge,an,It,Rt,Lt,De,En,Ne):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,ge,It,Rt,De,En,Ne.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Tt,Bt,ge,Ne.width,Ne.height,De,Ne.data):k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,ge,It,Rt,De,En,Ne);At.pixelStorei(k.UNPACK_ROW_LENGTH,vn),At.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ve),At.pixelStorei(k.UNPACK_SKIP_PIXELS,Cr),At.pixelStorei(k.UNPACK_SKIP_ROWS,_n),At.pixelStorei(k.UNPACK_SKIP_IMAGES,lo),Tt===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&k.generateMipmap(Ot),At.unbindTexture()},this.initRenderTarget=function(R){Ht.get(R).__webglFramebuffer===void 0&&jt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?jt.setTextureCube(R,0):R.isData3DTexture?jt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?jt.setTexture2DArray(R,0):jt.setTexture2D(R,0),At.unbindTexture()},this.resetState=function(){W=0,G=0,et=null,At.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=be._getDrawingBufferColorSpace(t),e.unpackColorSpace=be._getUnpackColorSpace()}};var X_={type:"change"},hm={type:"start"},Y_={type:"end"},Oh=new qs,j_=new Ti,yP=Math.cos(70*or.DEG2RAD),In=new V,pi=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},um=1e-6,Uh=class extends Sl{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:_s.ROTATE,MIDDLE:_s.DOLLY,RIGHT:_s.PAN},this.touches={ONE:bs.ROTATE,TWO:bs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new zn,this._lastTargetPosition=new V,this._quat=new zn().setFromUnitVectors(t.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new vs,this._sphericalDelta=new vs,this._scale=1,this._panOffset=new V,this._rotateStart=new Zt,this._rotateEnd=new Zt,this._rotateDelta=new Zt,this._panStart=new Zt,this._panEnd=new Zt,this._panDelta=new Zt,this._dollyStart=new Zt,this._dollyEnd=new Zt,this._dollyDelta=new Zt,this._dollyDirection=new V,this._mouse=new Zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=vP.bind(this),this._onPointerDown=xP.bind(this),this._onPointerUp=_P.bind(this),this._onContextMenu=TP.bind(this),this._onMouseWheel=MP.bind(this),this._onKeyDown=SP.bind(this),this._onTouchStart=AP.bind(this),this._onTouchMove=EP.bind(this),this._onMouseDown=bP.bind(this),this._onMouseMove=wP.bind(this),this._interceptControlDown=RP.bind(this),this._interceptControlUp=CP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(X_),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;In.copy(e).sub(this.target),In.applyQuaternion(this._quat),this._spherical.setFromVector3(In),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(n)&&isFinite(r)&&(n<-Math.PI?n+=pi:n>Math.PI&&(n-=pi),r<-Math.PI?r+=pi:r>Math.PI&&(r-=pi),n<=r?this._spherical.theta=Math.max(n,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+r)/2?Math.max(n,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let s=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),s=o!=this._spherical.radius}if(In.setFromSpherical(this._spherical),In.applyQuaternion(this._quatInverse),e.copy(this.target).add(In),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=In.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),s=!!l}else if(this.object.isOrthographicCamera){let a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),s=l!==this.object.zoom;let c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=In.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Oh.origin.copy(this.object.position),Oh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Oh.direction))<yP?this.object.lookAt(this.target):(j_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Oh.intersectPlane(j_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),s=!0)}return this._scale=1,this._performCursorZoom=!1,s||this._lastPosition.distanceToSquared(this.object.position)>um||8*(1-this._lastQuaternion.dot(this.object.quaternion))>um||this._lastTargetPosition.distanceToSquared(this.target)>um?(this.dispatchEvent(X_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?pi/60*this.autoRotateSpeed*t:pi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){In.setFromMatrixColumn(e,0),In.multiplyScalar(-t),this._panOffset.add(In)}_panUp(t,e){this.screenSpacePanning===!0?In.setFromMatrixColumn(e,1):(In.setFromMatrixColumn(e,0),In.crossVectors(this.object.up,In)),In.multiplyScalar(t),this._panOffset.add(In)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;In.copy(r).sub(this.target);let s=In.length();s*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*s/n.clientHeight,this.object.matrix),this._panUp(2*e*s/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),r=t-n.left,s=e-n.top,o=n.width,a=n.height;this._mouse.x=r/o*2-1,this._mouse.y=-(s/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._rotateStart.set(n,r)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._panStart.set(n,r)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,r=t.pageY-e.y,s=Math.sqrt(n*n+r*r);this._dollyStart.set(0,s)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),r=.5*(t.pageX+n.x),s=.5*(t.pageY+n.y);this._rotateEnd.set(r,s)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._panEnd.set(n,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,r=t.pageY-e.y,s=Math.sqrt(n*n+r*r);this._dollyEnd.set(0,s),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function xP(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function vP(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function _P(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Y_),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function bP(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case _s.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case _s.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case _s.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(hm)}function wP(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function MP(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent(hm),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Y_))}function SP(i){this.enabled!==!1&&this._handleKeyDown(i)}function AP(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case bs.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case bs.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case bs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case bs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(hm)}function EP(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function TP(i){this.enabled!==!1&&i.preventDefault()}function RP(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function CP(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Bl=class{distance;first;last;low;high;constructor(t,e,n,r,s){let[o,a]=[1/0,-1/0];[this.low,this.high]=[n*r,n*s],t.forEach((l,c)=>{o=Math.min(o,l+this.low*e[c]),a=Math.max(a,l+this.high*e[c])}),[this.first,this.last]=[o,a],this.distance=(a-o)/(this.high-this.low)}from(t){return(this.first+this.last-(this.low+this.high)*t)/2}};var kh=[-.91,.91,-.91,.91];function Z_(i,t,e,n){if(i.width===0||i.height===0)return[kh];let r=y=>2*(y-i.left)/i.width-1,s=y=>1-2*(y-i.top)/i.height,o=y=>y.height>0,a=[o(t)?r(t.right):-1,o(e)?r(e.left):1,o(n)?s(n.top):-1],l=[t,e].map(y=>o(y)?s(y.bottom):1),[c,u,h]=a,m=[[-1,1,h,Math.min(...l)],[-1,u,h,l[0]],[c,1,h,l[1]],[c,u,h,1]].map(([y,g,p,x])=>[y+.09,g-.09,p+.09,x-.09]).filter(([y,g,p,x])=>g-y>.7&&x-p>.7);return m.length?m:[kh]}var K_=["iso","front","side","top","tip"],PP={front:[1,0,.08],side:[0,-1,.08],top:[0,-.001,1],tip:[.62,-1,.4]},IP=.35,Bh=class{constructor(t,e,n,r,s){this.camera=t;this.canvas=e;this.reach=n;this.oblique=r;this.changed=s;this.controls=new Uh(t,e),this.controls.minDistance=.05*n,this.controls.maxDistance=40*n,this.controls.enableZoom=!1,this.controls.addEventListener("change",s),this.controls.addEventListener("start",this.turned),e.addEventListener("keydown",this.key),e.addEventListener("focus",this.zoomable),e.addEventListener("blur",this.zoomable)}camera;canvas;reach;oblique;changed;view="iso";places=[0,0,0];rooms=()=>[kh];preset=!1;controls;start=new V;end=new V;targetStart=new V;targetEnd=new V;offset=new V;spherical=new vs;began=0;gliding=0;show(t,e,n){this.view=t,this.preset=!0;let r=this.offset.set(...t==="iso"?this.oblique:PP[t]).normalize();if(t==="tip"?this.end.copy(this.targetEnd.fromArray(e)).addScaledVector(r,.55*this.reach):this.fit(r),cancelAnimationFrame(this.gliding),!n)return this.place(1);this.start.copy(this.camera.position),this.targetStart.copy(this.controls.target),this.began=performance.now(),this.step(this.began)}refit(){this.view!=="tip"&&(this.fit(this.offset.copy(this.camera.position).sub(this.controls.target).normalize()),cancelAnimationFrame(this.gliding),this.place(1))}get pose(){return[...this.camera.position.toArray(),...this.controls.target.toArray()]}set pose(t){this.preset=!1,cancelAnimationFrame(this.gliding),this.end.fromArray(t),this.targetEnd.fromArray(t,3),this.place(1)}take(t){this.view=t.view,this.preset=t.preset,this.camera.position.copy(t.camera.position),this.controls.target.copy(t.controls.target),this.controls.update()}follow(t){this.view==="tip"&&(this.offset.copy(this.camera.position).sub(this.controls.target),this.controls.target.fromArray(t),this.camera.position.copy(this.controls.target).add(this.offset),this.camera.lookAt(this.controls.target))}dispose(){cancelAnimationFrame(this.gliding),this.controls.dispose(),this.canvas.removeEventListener("keydown",this.key),this.canvas.removeEventListener("focus",this.zoomable),this.canvas.removeEventListener("blur",this.zoomable)}turned=()=>{this.preset=!1};zoomable=t=>{this.controls.enableZoom=t.type==="focus"};key=t=>{if(t.ctrlKey||t.metaKey||t.altKey)return;let e=or.degToRad(5),r={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[t.key];if(r&&t.shiftKey)this.pan(.04*r[0],-.04*r[1]);else if(r)this.turn(e*r[0],e*r[1],1);else if(t.key==="+"||t.key==="=")this.turn(0,0,1/1.15);else if(t.key==="-")this.turn(0,0,1.15);else return;this.turned(),t.preventDefault(),t.stopPropagation()};turn(t,e,n){let{camera:r,controls:s,offset:o,spherical:a}=this;o.copy(r.position).sub(s.target),a.setFromCartesianCoords(o.y,o.z,o.x),a.theta+=t,a.phi=or.clamp(a.phi+e,.001,Math.PI-.001),a.radius=or.clamp(a.radius*n,s.minDistance,s.maxDistance),o.setFromSpherical(a),r.position.set(o.z,o.x,o.y).add(s.target),s.update(),this.changed()}pan(t,e){let{camera:n,controls:r,offset:s}=this,o=n.position.distanceTo(r.target);for(let[a,l]of[[0,t],[1,e]])s.setFromMatrixColumn(n.matrix,a).multiplyScalar(l*o),n.position.add(s),r.target.add(s);r.update(),this.changed()}fit(t){let{camera:e,places:n,targetEnd:r}=this,s=Math.tan(or.degToRad(e.fov/2)),o=new V().crossVectors(e.up,t).normalize(),a=[o,new V().crossVectors(t,o),t],l=new V,c=a.map(x=>{let b=new Float64Array(n.length/3);for(let v=0;v<b.length;v++)b[v]=l.fromArray(n,3*v).dot(x);return b}),[u,h]=[Math.min,Math.max].map(x=>c[2].reduce((b,v)=>x(b,v))),f=Math.max(.3*this.reach,.6*(h-u)),d=(u+h)/2,m=c[2].map(x=>x-d),y=this.rooms().map(([x,b,v,S])=>{let A=[new Bl(c[0],m,s*e.aspect,x,b),new Bl(c[1],m,s,v,S)];return{aims:A,distance:Math.max(f,...A.map(_=>_.distance))}}),{aims:g,distance:p}=y.reduce((x,b)=>b.distance<x.distance?b:x);r.copy(t).multiplyScalar(d),g.forEach((x,b)=>r.addScaledVector(a[b],x.from(p))),this.end.copy(r).addScaledVector(t,p)}step=t=>{let e=Math.min(1,Math.max(0,(t-this.began)/1e3/IP));this.place(e*e*(3-2*e)),e<1&&(this.gliding=requestAnimationFrame(this.step))};place(t){this.camera.position.lerpVectors(t<1?this.start:this.end,this.end,t),this.controls.target.lerpVectors(t<1?this.targetStart:this.targetEnd,this.targetEnd,t),this.controls.update(),this.changed()}};var J_=[["reference","Nominal (ghost)"],["rigid","Undeformed (ghost)"],["traces","Paths of the tips"],["force","Contact force"],["surface","Surface"],["floor","Floor"],["apart","Side by side"]];var LP={iso:"Oblique",front:"Front",side:"Side",top:"Top",tip:"Tip (follows)"},fm=100;function Ue(i,t={},...e){let n=document.createElement(i);return Object.assign(n,t),n.append(...e),n}function tb(i,t,e,n,r,s){let o=Ue("div",{className:"scene-bar",role:"toolbar",ariaLabel:"The robot in space"}),a=dm("Colour",t,i.colour,u=>{i.colour=u,s.changed()});o.append(Ue("label",{},Q_("Colour"),a)),n>1&&o.append(FP(i,n,s));let l=dm("View",K_.map(u=>[u,LP[u]]),"iso",u=>s.look(u));o.append(Ue("label",{},Q_("View"),l));let c=Ue("button",{type:"button",ariaLabel:"Reset view"},"Reset");return c.addEventListener("click",()=>s.look(l.value)),o.append(c,DP(i,e,r,s)),o}function FP(i,t,e){let n=Ue("input",{type:"range",min:"0",max:String(fm),step:"1",value:String(Math.round(fm*Math.log(i.factor)/Math.log(t))),ariaLabel:"Deformation"}),r=Ue("output",{},`×${i.factor}`);return n.dataset.scene="factor",n.addEventListener("input",()=>{i.factor=NP(t**(Number(n.value)/fm)),r.textContent=n.ariaValueText=`×${i.factor}`,e.changed()}),n.title="How many times the displacement of each robot from itself without elasticity is enlarged; double click: to scale",n.addEventListener("dblclick",()=>{n.value="0",n.dispatchEvent(new Event("input"))}),Ue("label",{className:"scene-factor-row"},"Deformation",n,r)}function Q_(i){return Ue("span",{className:"scene-name"},i)}function NP(i){return i<10?Math.round(10*i)/10:Math.round(i)}function DP(i,t,e,n){let r=Ue("div",{className:"scene-more"});for(let[o,a]of J_){if(!t.includes(o))continue;let l=Ue("input",{type:"checkbox",checked:i[o]});l.dataset.scene=o,l.addEventListener("change",()=>{i[o]=l.checked,n.changed(),o==="apart"&&n.look("iso")}),r.append(Ue("label",{},l,a))}e&&r.append(Ue("label",{},"Quality",OP(i,n)));let s=Ue("details",{},Ue("summary",{},"Show"),r);return s.addEventListener("keydown",o=>{o.key==="Escape"&&(s.open=!1,s.querySelector("summary")?.focus())}),s}function OP(i,t){return dm("Quality",[["auto","automatic"],["low","low"],["high","high"],["lines","lines alone"]],i.quality,n=>{i.quality=n,t.quality()})}function dm(i,t,e,n){let r=Ue("select",{ariaLabel:i},...t.map(([s,o])=>Ue("option",{value:s,textContent:o})));return r.value=e,r.addEventListener("change",()=>n(r.value)),r}var zh=[.62,-1,.55];function eb(i,t){let e=i.runs.map(({scene:a})=>UP(a)),n=Math.max(...e.map(a=>a.size)),r=a=>Math.min(1e3,Math.max(1,a*t/n)),s=n>1e-6*t,o=e[0];return{time:o.size>1e-6*t?i.runs[0].scene.times.data[o.frame]:0,factor:s?Number(r(.1).toPrecision(1)):1,most:s?Number(r(.3).toPrecision(2)):1,direction:s?kP(i.runs[0].scene,o.frame):zh}}function UP({line:i,rigid:t}){let[e,n]=[0,0];for(let s=0;t&&s<i.data.length;s+=3){let o=Math.hypot(...[0,1,2].map(a=>i.data[s+a]-t.data[s+a]));o>e&&([e,n]=[o,s])}let[,...r]=i.shape;return{size:e,frame:Math.floor(n/(r.reduce((s,o)=>s*o,1)||1))}}function kP({line:i,rigid:t},e){let n=i.data.length/i.shape[0],[r,s]=[[],[]];for(let c=e*n;c<(e+1)*n;c+=3){let u=(h,f=c)=>i.data[f+h];r.push([0,1,2].map(h=>u(h)-(t?.data[c+h]??u(h)))),c>e*n&&s.push([0,1,2].map(h=>u(h)-u(h,c-3)))}let o=(c,u)=>{let h=c.reduce((d,m)=>d+Math.hypot(...m),0)||1,f=d=>d.reduce((m,y,g)=>m+y*u[g],0);return c.reduce((d,m)=>d+Math.sqrt(Math.max(0,Math.hypot(...m)**2-f(m)**2)),0)/h},[a,l]=[zh,0];for(let c of[.55,.25,1.4])for(let u=0;u<8;u++){let h=Math.atan2(zh[1],zh[0])+u*Math.PI/4,f=[1.18*Math.cos(h),1.18*Math.sin(h),c],d=Math.hypot(...f),m=f.map(g=>g/d),y=o(r,m)+.7*o(s,m)+(u?0:.05);y>l+.02&&([a,l]=[f,y])}return a}function Vh(i,t,e,n){for(let r=0;4*r<i.length&&n>1;r++){let s=3*n*r,o=t[s+3]-t[s],a=t[s+4]-t[s+1],l=t[s+5]-t[s+2],c=e[s+3]-e[s],u=e[s+4]-e[s+1],h=e[s+5]-e[s+2],f=Math.hypot(o,a,l)*Math.hypot(c,u,h);f>0&&BP(i,4*r,a*h-l*u,l*c-o*h,o*u-a*c,f+o*c+a*u+l*h)}}function BP(i,t,e,n,r,s){let o=Math.hypot(e,n,r,s);if(o===0)return;let a=i[t]/o,l=i[t+1]/o,c=i[t+2]/o,u=i[t+3]/o;i[t]=s*a+e*u+n*c-r*l,i[t+1]=s*l-e*c+n*u+r*a,i[t+2]=s*c+e*l-n*a+r*u,i[t+3]=s*u-e*a-n*l-r*c}var As=class{constructor(t){this.arrays=t;[this.frames,this.links,this.stations]=t.line.shape;let e=this.links*this.stations*3;this.line=new Float32Array(e),this.once=new Float32Array(e),this.planned=new Float32Array(e),this.rigid=t.rigid?new Float32Array(e):null,this.reference=t.reference?new Float32Array(e):null,this.roots=new Float32Array(this.links*4),this.values=new Float32Array(this.links*this.stations),this.tipPlace=this.nearestEnd()}arrays;links;stations;frames;line;rigid;reference;roots;values;tip=new Float32Array(3);tipReference=new Float32Array(3);force=new Float32Array(3);at=new Float32Array(3);frame=0;share=0;tipPlace;once;planned;seek(t,e,n){this.find(t);let{arrays:r}=this;this.mix(this.line,r.line),this.rigid&&r.rigid&&this.mix(this.rigid,r.rigid),this.reference&&r.reference&&this.mix(this.reference,r.reference),this.turn(),this.mix(this.tip,r.tip),r.tipReference&&this.mix(this.tipReference,r.tipReference),r.contact&&(this.mix(this.force,r.contact.force),this.mix(this.at,r.contact.at)),n&&this.mix(this.values,n),!(e===1||!this.rigid)&&(r.referenceRigid&&this.mix(this.planned,r.referenceRigid),this.enlarge(e,this.rigid,r.referenceRigid?this.planned:this.rigid))}path(t,e){let{arrays:n,frames:r}=this,s=t?n.tipReference:n.tip,o=t?n.reference:n.line,a=t&&n.referenceRigid||n.rigid;if(s===null)return null;let l=Float32Array.from(s.data);if(!a||!o||this.links===0)return l;let c=this.links*this.stations*3;for(let u=0;u<r;u++)for(let h=0;h<3;h++){let f=u*c+this.tipPlace+h;l[3*u+h]+=(e-1)*(o.data[f]-a.data[f])}return l}find(t){let e=this.arrays.times.data,n=0,r=this.frames-1;for(;r-n>1;){let o=n+r>>1;e[o]<=t?n=o:r=o}this.frame=n;let s=r>n?e[r]-e[n]:0;this.share=s>0?Math.min(1,Math.max(0,(t-e[n])/s)):0}mix(t,e){let n=t.length,r=this.frame*n,s=Math.min(this.frame+1,this.frames-1)*n,{data:o}=e;for(let a=0;a<n;a++){let l=o[r+a];t[a]=l+this.share*(o[s+a]-l)}}turn(){let{roots:t}=this;this.mix(t,this.arrays.roots);for(let e=0;e<t.length;e+=4){let n=Math.hypot(t[e],t[e+1],t[e+2],t[e+3])||1;for(let r=0;r<4;r++)t[e+r]/=n}}enlarge(t,e,n){let{line:r,reference:s,tipPlace:o}=this;for(let a=0;a<3&&this.links>0;a++){let l=(t-1)*(r[o+a]-e[o+a]);this.tip[a]+=l,this.at[a]+=l,s&&(this.tipReference[a]+=(t-1)*(s[o+a]-n[o+a]))}this.once.set(r);for(let a=0;a<r.length;a++)r[a]=e[a]+t*(r[a]-e[a]),s&&(s[a]=n[a]+t*(s[a]-n[a]));Vh(this.roots,this.once,r,this.stations)}nearestEnd(){let{line:t,tip:e}=this.arrays,n=0,r=1/0;for(let s=0;s<this.links;s++){let o=(s*this.stations+this.stations-1)*3,a=Math.hypot(...[0,1,2].map(l=>t.data[o+l]-e.data[l]));a<=r&&([n,r]=[o,a])}return n}};function Gh(i,t){return i!=="1"||t===0?Ua(i,Math.abs(t)):Math.abs(t)<.01?{factor:1e6,name:"µm/m"}:{factor:100,name:"%"}}function Mr(i){if(!Number.isFinite(i))return"–";let t=Math.abs(i);if(t!==0&&(t>=1e5||t<.001))return i.toExponential(2).replace("-","−");let e=t===0?0:Math.max(0,2-Math.floor(Math.log10(t)));return String(Number(i.toFixed(e))).replace("-","−")}function zl(i){let t=10**Math.floor(Math.log10(i));return t*(i>=5*t?5:i>=2*t?2:1)}var pa=class{constructor(t,e,n,r){this.run=t;this.index=e;this.alone=n;this.own=r;this.motion=new As(t.scene)}run;index;alone;own;motion;showsSurface=!0;aside=0;before=null;get colour(){return this.alone?this.own.real:this.own.runs[this.index%this.own.runs.length]}get referenceColour(){return this.alone?this.own.reference:this.own.rigid}get changed(){return this.before!==null}replace(t){let{scene:e}=this.run,n=new As(t??e);this.before=t===null?null:this.before??new As(e),this.motion=n}seek(t,e){let{motion:n}=this,r=n.arrays.colours.find(({id:s})=>s===e.colour)?.values??null;n.seek(t,e.factor,r),this.before?.seek(t,e.factor,null)}widen(t,e){let{arrays:n,links:r,stations:s}=this.motion,o=n.colours.find(l=>l.id===t)?.values.data,a=this.run.scene.links.map(l=>l.bends||Vl(t)==="all");if(o!==void 0)for(let l=0;l<o.length;l++)a[Math.floor(l/s)%r]&&(o[l]<e.low&&(e.low=o[l]),o[l]>e.high&&(e.high=o[l]))}};function Vl(i){return i==="run"?"none":i==="displacement"?"all":"bending"}var zP=10;function ma(i,t){let e=0;for(let{scene:n}of i){let r=n.contact?.force.data??[];for(let s=0;s+2<r.length;s+=3)e=Math.max(e,Math.hypot(r[s],r[s+1],r[s+2]))}return i.every(({scene:n})=>n.contact===null)?0:zl(.35*t/(e||zP))}var VP=60;function nb(i,t,{reach:e,floor:n}){let r=ma(i.runs,e),s=[];for(let{scene:o}of i.runs){let{line:a,rigid:l,contact:c}=o,[u,h,f]=a.shape,d=Math.max(1,Math.ceil(u/VP));a.data.length&&s.push(a.data[0],a.data[1],n);for(let m=0;m<u;m+=d){for(let y=0;y<h*f;y+=Math.max(1,f>>1))for(let g=0,p=3*(m*h*f+y);g<3;g++,p++){let x=l?.data[p]??a.data[p];s.push(x+t*(a.data[p]-x))}for(let y=0,g=3*m;y<3;y++,g++)s.push(c?c.at.data[g]+r*c.force.data[g]:o.tip.data[g])}}return s}function ib(i){let t=new li,e=new V,n=.001,r=0;for(let{scene:l}of i.runs){for(let c of[l.line,l.tip])for(let u=0;u+2<c.data.length;u+=3)t.expandByPoint(e.fromArray(c.data,u));n=Math.max(n,GP(l.line.data,l.line.shape));for(let c of l.links)c.section?.sizes.data.forEach(u=>r=Math.max(r,u))}t.isEmpty()&&t.expandByPoint(e.set(0,0,0));let s=Math.max(n,t.getSize(e).length()/2),o=Math.min(Math.max(r,.012*n),.022*n),a=HP(t,i,n);for(let{scene:l}of i.runs)l.line.data.length&&t.expandByPoint(e.fromArray(l.line.data).setZ(a));return{box:t,reach:n,cell:zl(s/5),usual:o,least:.006*n,floor:a,opening:eb(i,n)}}function GP(i,[,t,e]){let n=0;for(let r=0;r<t;r++)for(let s=1;s<e;s++){let o=3*(r*e+s);n+=Math.hypot(i[o]-i[o-3],i[o+1]-i[o-2],i[o+2]-i[o-1])}return n}function HP(i,t,e){let n=t.runs[0]?.scene.line.data[2]??0,r=i.max.z-i.min.z>.2*e&&n<e;if(i.min.z>=-.001*e&&r)return 0;let s=zl(.1*e);return Math.floor((Math.min(i.min.z,n)-.12*e)/s)*s}var rb=new li,Hh=new V,ga=class extends wl{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Xe(t,3)),this.setAttribute("uv",new Xe(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new xs(e,6,1);return this.setAttribute("instanceStart",new Bi(n,3,0)),this.setAttribute("instanceEnd",new Bi(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new xs(e,6,1);return this.setAttribute("instanceColorStart",new Bi(n,3,0)),this.setAttribute("instanceColorEnd",new Bi(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new fl(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new li);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),rb.setFromBufferAttribute(e),this.boundingBox.union(rb))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new tr),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let r=0;for(let s=0,o=t.count;s<o;s++)Hh.fromBufferAttribute(t,s),r=Math.max(r,n.distanceToSquared(Hh)),Hh.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(Hh));this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Pt.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Zt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ui.line={uniforms:Nl.merge([Pt.common,Pt.fog,Pt.line]),vertexShader:`
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
		`};var Es=class extends zi{constructor(t){super({type:"LineMaterial",uniforms:Nl.clone(ui.line.uniforms),vertexShader:ui.line.vertexShader,fragmentShader:ui.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var pm=new Le,sb=new V,ob=new V,qn=new Le,$n=new Le,Sr=new Le,mm=new V,gm=new $e,Xn=new Ml,ab=new V,Wh=new li,qh=new tr,Ar=new Le,Er,eo;function lb(i,t,e){return Ar.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),Ar.multiplyScalar(1/Ar.w),Ar.x=eo/e.width,Ar.y=eo/e.height,Ar.applyMatrix4(i.projectionMatrixInverse),Ar.multiplyScalar(1/Ar.w),Math.abs(Math.max(Ar.x,Ar.y))}function WP(i,t){let e=i.matrixWorld,n=i.geometry,r=n.attributes.instanceStart,s=n.attributes.instanceEnd,o=Math.min(n.instanceCount,r.count);for(let a=0,l=o;a<l;a++){Xn.start.fromBufferAttribute(r,a),Xn.end.fromBufferAttribute(s,a),Xn.applyMatrix4(e);let c=new V,u=new V;Er.distanceSqToSegment(Xn.start,Xn.end,u,c),u.distanceTo(c)<eo*.5&&t.push({point:u,pointOnLine:c,distance:Er.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function qP(i,t,e){let n=t.projectionMatrix,s=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-t.near;Er.at(1,Sr),Sr.w=1,Sr.applyMatrix4(t.matrixWorldInverse),Sr.applyMatrix4(n),Sr.multiplyScalar(1/Sr.w),Sr.x*=s.x/2,Sr.y*=s.y/2,Sr.z=0,mm.copy(Sr),gm.multiplyMatrices(t.matrixWorldInverse,o);for(let f=0,d=u;f<d;f++){if(qn.fromBufferAttribute(l,f),$n.fromBufferAttribute(c,f),qn.w=1,$n.w=1,qn.applyMatrix4(gm),$n.applyMatrix4(gm),qn.z>h&&$n.z>h)continue;if(qn.z>h){let b=qn.z-$n.z,v=(qn.z-h)/b;qn.lerp($n,v)}else if($n.z>h){let b=$n.z-qn.z,v=($n.z-h)/b;$n.lerp(qn,v)}qn.applyMatrix4(n),$n.applyMatrix4(n),qn.multiplyScalar(1/qn.w),$n.multiplyScalar(1/$n.w),qn.x*=s.x/2,qn.y*=s.y/2,$n.x*=s.x/2,$n.y*=s.y/2,Xn.start.copy(qn),Xn.start.z=0,Xn.end.copy($n),Xn.end.z=0;let y=Xn.closestPointToPointParameter(mm,!0);Xn.at(y,ab);let g=or.lerp(qn.z,$n.z,y),p=g>=-1&&g<=1,x=mm.distanceTo(ab)<eo*.5;if(p&&x){Xn.start.fromBufferAttribute(l,f),Xn.end.fromBufferAttribute(c,f),Xn.start.applyMatrix4(o),Xn.end.applyMatrix4(o);let b=new V,v=new V;Er.distanceSqToSegment(Xn.start,Xn.end,v,b),e.push({point:v,pointOnLine:b,distance:Er.origin.distanceTo(v),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var $h=class extends Ge{constructor(t=new ga,e=new Es({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,r=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)sb.fromBufferAttribute(e,o),ob.fromBufferAttribute(n,o),r[a]=a===0?0:r[a-1],r[a+1]=r[a]+sb.distanceTo(ob);let s=new xs(r,2,1);return t.setAttribute("instanceDistanceStart",new Bi(s,1,0)),t.setAttribute("instanceDistanceEnd",new Bi(s,1,1)),this}raycast(t,e){let n=this.material.worldUnits,r=t.camera;if(r===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let s=t.params.Line2!==void 0&&t.params.Line2.threshold||0;Er=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;eo=l.linewidth+s,a.boundingSphere===null&&a.computeBoundingSphere(),qh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=eo*.5;else{let h=Math.max(r.near,qh.distanceToPoint(Er.origin));c=lb(r,h,l.resolution)}if(qh.radius+=c,Er.intersectsSphere(qh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Wh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=eo*.5;else{let h=Math.max(r.near,Wh.distanceToPoint(Er.origin));u=lb(r,h,l.resolution)}Wh.expandByScalar(u),Er.intersectsBox(Wh)!==!1&&(n?WP(this,e):qP(this,r,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(pm),this.material.uniforms.resolution.value.set(pm.z,pm.w))}};var no=class extends ga{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,n=new Float32Array(2*e);for(let r=0;r<e;r+=3)n[2*r]=t[r],n[2*r+1]=t[r+1],n[2*r+2]=t[r+2],n[2*r+3]=t[r+3],n[2*r+4]=t[r+4],n[2*r+5]=t[r+5];return super.setPositions(n),this}setColors(t){let e=t.length-3,n=new Float32Array(2*e);for(let r=0;r<e;r+=3)n[2*r]=t[r],n[2*r+1]=t[r+1],n[2*r+2]=t[r+2],n[2*r+3]=t[r+3],n[2*r+4]=t[r+4],n[2*r+5]=t[r+5];return super.setColors(n),this}setFromPoints(t){let e=t.length-1,n=new Float32Array(6*e);for(let r=0;r<e;r++)n[6*r]=t[r].x,n[6*r+1]=t[r].y,n[6*r+2]=t[r].z||0,n[6*r+3]=t[r+1].x,n[6*r+4]=t[r+1].y,n[6*r+5]=t[r+1].z||0;return super.setPositions(n),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Xh=class extends $h{constructor(t=new no,e=new Es({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var ub=new V(0,1,0),jh=class{group=new kn;past;rest;length=0;constructor(t,e,n){this.past=new Xh(new no,new Es({color:e,linewidth:2.5}));let r=new ml({color:e,transparent:!0,opacity:.7,dashSize:n,gapSize:n});this.rest=new sa(new sn,r),this.past.frustumCulled=this.rest.frustumCulled=!1,this.group.add(this.past,this.rest),this.lay(t)}lay(t){this.length=t.length/3,this.rest.geometry.dispose(),this.past.geometry.dispose(),this.past.geometry=new no;let e=new Float32Array(this.length);for(let n=1;n<e.length;n++)e[n]=e[n-1]+Math.hypot(t[3*n]-t[3*n-3],t[3*n+1]-t[3*n-2],t[3*n+2]-t[3*n-1]);this.rest.geometry.setAttribute("position",new je(t,3)),this.rest.geometry.setAttribute("lineDistance",new je(e,1)),this.past.visible=this.length>1,this.past.visible&&this.past.geometry.setPositions(t)}seek(t){this.past.geometry.instanceCount=Math.min(t,this.length-1),this.rest.geometry.setDrawRange(t,this.length-t)}dispose(){[this.past.geometry,this.past.material,this.rest.geometry,this.rest.material].forEach(t=>t.dispose()),this.group.removeFromParent()}},Yh=class{constructor(t,e,n){this.wide=e;this.scale=n;let r=new ia({color:t}),s=new _r(e,e,1,12).translate(0,.5,0),o=new hl(2.6*e,6*e,16).translate(0,-3*e,0);[this.shaft,this.head]=[new Ge(s,r),new Ge(o,r)],this.parts=[r,s,o],this.group.add(this.shaft,this.head)}wide;scale;group=new kn;shaft;head;parts;way=new V;turn=new zn;point(t,e){let n=this.way.fromArray(t).length(),r=n*this.scale;this.group.visible=r>.5*this.wide,this.group.visible&&(this.group.position.fromArray(e),this.group.quaternion.copy(this.turn.setFromUnitVectors(ub,this.way.divideScalar(n))),this.shaft.scale.set(1,Math.max(r-5*this.wide,1e-6),1),this.head.position.y=r)}dispose(){this.parts.forEach(t=>t.dispose()),this.group.removeFromParent()}};function hb(i,t,e,n){let r=new Xs({color:n,transparent:!0,opacity:.28,side:Vi,depthWrite:!1});return new Ge(ym(i,t,e),r)}var Gl=24;function ym(i,t,e){let n=[];for(let u=0;u+2<t.length;u+=3)n.push(new V(t[u],t[u+1],t[u+2]));let[r,s,o]=$P(i,n,e),a=n.map(s),[l,c]=[0,1].map(u=>{let h=a.map(f=>f[u]);return[h.reduce((f,d)=>Math.min(f,d),1/0)-o[u],h.reduce((f,d)=>Math.max(f,d),-1/0)+o[u]]});return XP(r,l,c)}function $P(i,t,e){if(i.kind==="plane"){let f=new V(...i.position),[d,m]=cb(new V(...i.normal).normalize());return[(g,p)=>f.clone().addScaledVector(d,g).addScaledVector(m,p),g=>[g.clone().sub(f).dot(d),g.clone().sub(f).dot(m)],[3*e,3*e]]}let n=new V(...i.center),r=i.kind==="cylinder"?new V(...i.axis).normalize():new V(0,0,1),s=t.reduce((f,d)=>f.add(d),new V).divideScalar(Math.max(t.length,1)).sub(n),o=s.addScaledVector(r,-s.dot(r));o.length()<1e-6*i.radius&&o.copy(cb(r)[0]),o.normalize();let a=new V().crossVectors(r,o),{radius:l}=i,c=i.kind==="ball";return[(f,d)=>{let m=c?l*Math.cos(d):l;return n.clone().addScaledVector(o,m*Math.cos(f)).addScaledVector(a,m*Math.sin(f)).addScaledVector(r,c?l*Math.sin(d):d)},f=>{let d=f.clone().sub(n),m=d.dot(r);return[Math.atan2(d.dot(a),d.dot(o)),c?Math.asin(Math.max(-1,Math.min(1,m/(d.length()||1)))):m]},[e/l,c?e/l:e]]}function cb(i){let t=new V().crossVectors(Math.abs(i.z)<.9?new V(0,0,1):ub,i).normalize();return[t,new V().crossVectors(i,t)]}function XP(i,t,e,n=Gl){let r=[],s=[];for(let a=0;a<=n;a++)for(let l=0;l<=n;l++){r.push(...i(t[0]+(t[1]-t[0])*a/n,e[0]+(e[1]-e[0])*l/n).toArray());let c=a*(n+1)+l;a<n&&l<n&&s.push(c,c+1,c+n+1,c+1,c+n+2,c+n+1)}let o=new sn;return o.setAttribute("position",new je(Float32Array.from(r),3)),o.setIndex(s),o.computeVertexNormals(),o}var Xr=4;function fb(i,t,e){let{cell:n,reach:r,floor:s}=t,o=n*Math.ceil(1.6*r/n),{context:a}=i;for(let l of[!1,!0]){a.beginPath();for(let c=-o;c<=o+n/2;c+=n)Math.abs(c)<n/2===l&&(i.piece([c,-o,s],0,[c,o,s],0,!0),i.piece([-o,c,s],0,[o,c,s],0,!0));i.stroke(l?e.gridStrong:e.grid,1)}}function db(i,t,e,n){let r=t.length/3;i.path(t,0,Math.min(e+1,r)),i.stroke(n,2.5),i.context.setLineDash([4,4]),i.path(t,3*e,r-e),i.stroke(n,1.2,.8,"butt"),i.context.setLineDash([])}function pb(i,t,e,n,r){let s=[0,1,2].map(y=>e[y]+n*t[y]),[o,a]=[i.at(e,0),i.at(s,0)];if(o===null||a===null)return;let[l,c]=[a[0]-o[0],a[1]-o[1]],u=Math.hypot(l,c);if(u<3)return;let h=Math.min(12,.5*u),[f,d]=[l/u,c/u],m=[a[0]-h*f,a[1]-h*d];i.context.beginPath(),i.context.moveTo(...o),i.context.lineTo(...m),i.stroke(r,4,1,"butt"),i.fill([a,[m[0]-.45*h*d,m[1]+.45*h*f],[m[0]+.45*h*d,m[1]-.45*h*f]],r)}var Zh=class{constructor(t,e,n){this.color=n;let r=ym(t.surface,t.at.data,.12*e.reach);this.places=Float32Array.from(r.getAttribute("position").array)}color;places;draw(t){for(let e=0;e<Gl;e+=Xr)for(let n=0;n<Gl;n+=Xr)this.square(t,e,n)}square(t,e,n){let r=(o,a)=>t.at(this.places,3*((e+o)*(Gl+1)+n+a)),s=[];for(let o=0;o<4*Xr;o++){let[a,l]=[Math.floor(o/Xr),o%Xr],[c,u]=[[0,l],[l,Xr],[Xr,Xr-l],[Xr-l,0]][a],h=r(c,u);if(h===null)return;s.push(h)}t.fill(s,this.color,.16),t.context.closePath(),t.stroke(this.color,1,.35)}};var Kh=class{constructor(t){this.camera=t;let e=this.canvas.getContext("2d");if(e===null)throw new Error("This browser draws on no canvas.");this.context=e,e.lineJoin="round"}camera;canvas=document.createElement("canvas");context;aside=0;width=1;height=1;view=new Float64Array(16);from=new Float64Array(3);to=new Float64Array(3);focal=1;near=.001;resize(t,e){if(t<1||e<1)return;let n=Math.min(Math.max(window.devicePixelRatio,1),2);[this.width,this.height]=[t,e],[this.canvas.width,this.canvas.height]=[Math.round(n*t),Math.round(n*e)],this.camera.aspect=t/e,this.camera.updateProjectionMatrix()}begin(t){let{camera:e,canvas:n,context:r}=this;e.updateMatrixWorld(),this.view.set(e.matrixWorldInverse.elements),this.focal=this.height/2/Math.tan(e.fov*Math.PI/360),this.near=.001*t,r.setTransform(n.width/this.width,0,0,n.height/this.height,0,0),r.clearRect(0,0,this.width,this.height),r.lineJoin="round"}depth(t,e){return-this.seen(2,t,e)}perMeter(t){return this.focal/Math.max(t,this.near)}at(t,e){let n=this.depth(t,e);return n<this.near?null:this.pixel(this.seen(0,t,e),this.seen(1,t,e),n)}path(t,e,n){this.context.beginPath();for(let r=1;r<n;r++)this.piece(t,e+3*r-3,t,e+3*r,r===1)}piece(t,e,n,r,s){let{from:o,to:a,near:l,context:c}=this;for(let f=0;f<3;f++)[o[f],a[f]]=[this.seen(f,t,e),this.seen(f,n,r)];let[u,h]=[-o[2]<l,-a[2]<l];if(!(u&&h)){if(u||h){let f=(-l-o[2])/(a[2]-o[2]),d=u?o:a;for(let m=0;m<3;m++)d[m]=this.seen(m,t,e)+f*(this.seen(m,n,r)-this.seen(m,t,e))}(s||u)&&c.moveTo(...this.pixel(o[0],o[1],-o[2])),c.lineTo(...this.pixel(a[0],a[1],-a[2]))}}stroke(t,e,n=1,r="round"){let{context:s}=this;s.globalAlpha=n,s.strokeStyle=t,s.lineWidth=e,s.lineCap=r,s.stroke(),s.globalAlpha=1}dot(t,e,n,r,s,o=2){let a=this.at(t,e);if(a===null)return;let l=Math.max(n*this.perMeter(this.depth(t,e)),o);this.context.beginPath(),this.context.arc(...a,l,0,2*Math.PI),this.context.fillStyle=r,this.context.fill(),this.stroke(s,1)}fill(t,e,n=1){let{context:r}=this;r.beginPath(),t.forEach(s=>r.lineTo(...s)),r.closePath(),r.globalAlpha=n,r.fillStyle=e,r.fill(),r.globalAlpha=1}pixel(t,e,n){let r=this.focal/n;return[this.width/2+r*t,this.height/2-r*e]}seen(t,e,n){let{view:r}=this;return r[t]*e[n]+r[4+t]*(e[n+1]+this.aside)+r[8+t]*e[n+2]+r[12+t]}};var jP={runs:["#0072b2","#d55e00","#00875f","#a2488f","#8c6a00","#2a7fb8"],link:"#9aa5b1",joint:"#4a5562",gear:"#c76a00",base:"#39434e",payload:"#2b333c",grid:"#c3cad1",gridStrong:"#8e99a4",surface:"#009e73",force:"#b3261e",reference:"#d55e00",rigid:"#6b7681",before:"#7a4ea3",real:"#0072b2",sky:"#ffffff",ground:"#b9c0c8"},YP={runs:["#4fb0ea","#ff8f45","#3ecf9b","#e08acb","#d9b13a","#9fd3f5"],link:"#8b96a3",joint:"#a9b4c0",gear:"#e69f00",base:"#6d7986",payload:"#cfd6dd",grid:"#39424c",gridStrong:"#5c6874",surface:"#2fbf95",force:"#ff7b70",reference:"#ff8c42",rigid:"#a3adb7",before:"#c79be8",real:"#56b4e9",sky:"#ffffff",ground:"#5a6570"};function mb(i){return i?YP:jP}var gb="440154 481a6c 472f7d 414487 39568c 31688e 2a788e 23888e 1f988b 22a884 35b779 54c568 7ad151 a5db36 d2e21b fde725",Hl=256,Gi=ZP();function ZP(){let i=gb.split(" ").map(e=>[0,2,4].map(n=>parseInt(e.slice(n,n+2),16)/255)),t=new Float32Array(3*Hl);for(let e=0;e<Hl;e++){let n=e/(Hl-1)*(i.length-1),r=Math.min(Math.floor(n),i.length-2);for(let s=0;s<3;s++)t[3*e+s]=i[r][s]+(n-r)*(i[r+1][s]-i[r][s])}return t}function Ts(i){return 3*Math.max(0,Math.min(Hl-1,Math.round(i*(Hl-1))))}function yb(){return`linear-gradient(to right, ${gb.split(" ").map(i=>`#${i}`).join(", ")})`}function Jh(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,r=n.count,s;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)s=n.array;else{s=new Float64Array(r*3);for(let v=0;v<r;v++)s[3*v+0]=n.getX(v),s[3*v+1]=n.getY(v),s[3*v+2]=n.getZ(v)}let o=Math.cos(t),a=(1+1e-10)*100,l=r/3,c=new Float64Array(l*3);for(let v=0;v<l;v++){let S=9*v,A=s[S+0],_=s[S+1],w=s[S+2],N=s[S+3],P=s[S+4],I=s[S+5],U=s[S+6],z=s[S+7],C=s[S+8],O=U-N,W=z-P,G=C-I,et=A-N,$=_-P,X=w-I,tt=W*X-G*$,ht=G*et-O*X,ct=O*$-W*et,J=1/(Math.sqrt(tt*tt+ht*ht+ct*ct)||1);c[3*v+0]=tt*J,c[3*v+1]=ht*J,c[3*v+2]=ct*J}let u=new Int32Array(r),h=new Float64Array(r*3),f=1;for(;f<r*2;)f<<=1;let d=f-1,m=new Int32Array(f),y=0;for(let v=0;v<r;v++){let S=3*v,A=Math.trunc(s[S+0]*a),_=Math.trunc(s[S+1]*a),w=Math.trunc(s[S+2]*a),N=(Math.imul(A,73856093)^Math.imul(_,19349663)^Math.imul(w,83492791))&d;for(;;){let P=m[N];if(P===0){let U=3*y;h[U+0]=A,h[U+1]=_,h[U+2]=w,m[N]=y+1,u[v]=y++;break}let I=3*(P-1);if(h[I+0]===A&&h[I+1]===_&&h[I+2]===w){u[v]=P-1;break}N=N+1&d}}let g=new Int32Array(y+1);for(let v=0;v<r;v++)g[u[v]+1]++;for(let v=0;v<y;v++)g[v+1]+=g[v];let p=new Int32Array(r),x=g.slice(0,y);for(let v=0;v<l;v++){let S=3*v;p[x[u[S+0]]++]=v,p[x[u[S+1]]++]=v,p[x[u[S+2]]++]=v}let b=new Float32Array(r*3);for(let v=0;v<l;v++){let S=3*v,A=c[S+0],_=c[S+1],w=c[S+2];for(let N=0;N<3;N++){let P=S+N,I=u[P],U=0,z=0,C=0;for(let W=g[I],G=g[I+1];W<G;W++){let et=3*p[W],$=c[et+0],X=c[et+1],tt=c[et+2];A*$+_*X+w*tt>o&&(U+=$,z+=X,C+=tt)}let O=1/(Math.sqrt(U*U+z*z+C*C)||1);b[3*P+0]=U*O,b[3*P+1]=z*O,b[3*P+2]=C*O}}return e.setAttribute("normal",new je(b,3,!1)),e}function xb({vertices:i,faces:t},e){let n=Array.from(i),r=Array.from(t);for(let s=0;s<12&&r.length<3*6e4;s++){let o=new Map,a=(c,u)=>{if(!(Math.abs(n[3*c]-n[3*u])>e))return null;let h=c<u?`${c},${u}`:`${u},${c}`,f=o.get(h);if(f!==void 0)return f;let d=n.length/3;for(let m=0;m<3;m++)n.push((n[3*c+m]+n[3*u+m])/2);return o.set(h,d),d},l=[];for(let c=0;c<r.length;c+=3){let[u,h,f]=r.slice(c,c+3);KP(l,[u,h,f],[a(u,h),a(h,f),a(f,u)])}if(r=l,o.size===0)break}return{vertices:Float32Array.from(n),faces:Uint32Array.from(r)}}function KP(i,t,e){let n=e.filter(h=>h!==null).length;if(n===0)return void i.push(...t);let r=[0,1,2].find(h=>e[h]!==null&&(n!==2||e[(h+1)%3]!==null))??0,[s,o,a]=[0,1,2].map(h=>t[(r+h)%3]),[l,c,u]=[0,1,2].map(h=>e[(r+h)%3]??-1);n===1?i.push(s,l,a,l,o,a):n===2?i.push(l,o,c,s,l,c,s,c,a):i.push(s,l,u,l,o,c,u,c,a,l,c,u)}var vb=[[1,1],[-1,1],[-1,-1],[1,-1]];function JP(i){let t=new Float32Array(2*(i+1));for(let e=0;e<=i;e++)t[2*e]=Math.cos(2*Math.PI*e/i),t[2*e+1]=Math.sin(2*Math.PI*e/i);return{points:t,normals:t}}function QP(){let i=[],t=[];return vb.forEach((e,n)=>{let r=vb[(n+1)%4];i.push(...e,...r);for(let s=0;s<2;s++)t.push((e[0]+r[0])/2,(e[1]+r[1])/2)}),{points:Float32Array.from(i),normals:Float32Array.from(t)}}var Qh=class{constructor(t,e,n){this.stations=t;this.section=e;this.outline=e.shape==="round"?JP(n):QP(),this.around=this.outline.points.length/2;let r=(t+2)*this.around;[this.position,this.normal,this.colour]=[0,1,2].map(()=>new Float32Array(3*r)),this.colour.fill(1),["position","normal","color"].forEach((s,o)=>{let a=new je([this.position,this.normal,this.colour][o],3);this.geometry.setAttribute(s,a.setUsage(Fl))}),this.geometry.setIndex(this.faces())}stations;section;geometry=new sn;outline;around;position;normal;colour;axes=new Float32Array(9);shape(t,e,n,r){let{stations:s,axes:o}=this;Wl(o,n,r);for(let a=0;a<s;a++){let l=e+3*Math.max(a-1,0),c=e+3*Math.min(a+1,s-1);ql(o,t[c]-t[l],t[c+1]-t[l+1],t[c+2]-t[l+2]),this.ring(a,a,t,e+3*a,0),a===0&&this.ring(s,a,t,e,-1),a===s-1&&this.ring(s+1,a,t,e+3*a,1)}this.geometry.attributes.position.needsUpdate=!0,this.geometry.attributes.normal.needsUpdate=!0}paint(t,e,n,r){let{around:s,colour:o,stations:a}=this,l=r>n?r-n:1;for(let c=0;c<a+2;c++){let u=c<a?c:c===a?0:a-1,h=Ts((t[e+u]-n)/l);for(let f=3*c*s;f<3*(c+1)*s;f+=3)o[f]=Gi[h],o[f+1]=Gi[h+1],o[f+2]=Gi[h+2]}this.geometry.attributes.color.needsUpdate=!0}dispose(){this.geometry.dispose()}ring(t,e,n,r,s){let{axes:o,around:a,position:l,normal:c,section:u,outline:h}=this,f=u.sizes[2*e],d=u.sizes[2*e+1];for(let m=0;m<a;m++){let y=f*h.points[2*m],g=d*h.points[2*m+1],p=h.normals[2*m],x=h.normals[2*m+1];for(let b=0;b<3;b++){let v=3*(t*a+m)+b;l[v]=n[r+b]+y*o[3+b]+g*o[6+b],c[v]=s===0?p*o[3+b]+x*o[6+b]:s*o[b]}}}faces(){let{around:t,stations:e}=this,n=[];for(let r=0;r<e-1;r++)for(let s=0;s<t-1;s++){let o=r*t+s;n.push(o,o+t,o+1,o+1,o+t,o+t+1)}for(let r=1;r<t-1;r++){let s=e*t,o=s+t;n.push(s,s+r,s+r+1,o,o+r+1,o+r)}for(let r=0;r<n.length;r+=3)[n[r+1],n[r+2]]=[n[r+2],n[r+1]];return n}};function Wl(i,t,e){let n=t[e],r=t[e+1],s=t[e+2],o=t[e+3];i[0]=1-2*(r*r+s*s),i[1]=2*(n*r+s*o),i[2]=2*(n*s-r*o),i[3]=2*(n*r-s*o),i[4]=1-2*(n*n+s*s),i[5]=2*(r*s+n*o),i[6]=2*(n*s+r*o),i[7]=2*(r*s-n*o),i[8]=1-2*(n*n+r*r)}function ql(i,t,e,n){let r=Math.hypot(t,e,n);if(r===0)return;let s=t/r,o=e/r,a=n/r,l=i[1]*a-i[2]*o,c=i[2]*s-i[0]*a,u=i[0]*o-i[1]*s,h=1+i[0]*s+i[1]*o+i[2]*a,f=h>1e-9?1/h:0;for(let d=3;d<9;d+=3){let m=c*i[d+2]-u*i[d+1],y=u*i[d]-l*i[d+2],g=l*i[d+1]-c*i[d];i[d]+=m+f*(c*g-u*y),i[d+1]+=y+f*(u*m-l*g),i[d+2]+=g+f*(l*y-c*m)}i[0]=s,i[1]=o,i[2]=a}var t3=24;function _b(i,t,e){let n=new Float32Array(t*e.length),r=0;return e.forEach((s,o)=>{for(let a=0;a<t;a++){let l=3*(t*s+a);a>0&&(r+=Math.hypot(i[l]-i[l-3],i[l+1]-i[l-2],i[l+2]-i[l-1])),n[o*t+a]=r}}),n}var tf=class{constructor(t,e,n,r,s){this.links=e;this.stations=n;let{vertices:o,faces:a}=xb(t,r[r.length-1]/t3),l=new sn;l.setAttribute("position",new je(o,3)),l.setIndex(new je(a,1)),this.geometry=Jh(l,s);let{position:c,normal:u}=this.geometry.attributes;[this.rest,this.facing]=[c,u].map(({array:f})=>Float32Array.from(f));for(let f of[c,u])f.setUsage(Fl);let h=this.rest.length/3;this.geometry.setAttribute("color",new je(new Float32Array(3*h).fill(1),3)),this.station=new Uint16Array(h),[this.share,this.beyond]=[new Float32Array(h),new Float32Array(h)],this.frames=new Float32Array(9*r.length);for(let f=0;f<h;f++)this.place(f,r)}links;stations;geometry;rest;facing;station;share;beyond;frames;axes=new Float32Array(9);place(t,e){let n=this.rest[3*t],r=Math.min(Math.max(n,0),e[e.length-1]),s=0;for(;s<e.length-2&&e[s+1]<r;)s++;let o=e[s+1]-e[s];this.station[t]=s,this.share[t]=o>0?(r-e[s])/o:0,this.beyond[t]=n-r}shape(t,e){this.turn(t,e);let{rest:n,facing:r,station:s,share:o,beyond:a,frames:l}=this,{position:c,normal:u}=this.geometry.attributes,[h,f]=[c.array,u.array];for(let d=0;d<s.length;d++){let[m,y,g]=[s[d],o[d],a[d]],[p,x]=[this.placeOf(m),this.placeOf(m+1)],[b,v]=[n[3*d+1],n[3*d+2]];for(let S=0;S<3;S++){let A=9*m+S,[_,w,N]=[0,3,6].map(P=>l[A+P]+y*(l[A+P+9]-l[A+P]));h[3*d+S]=t[p+S]+y*(t[x+S]-t[p+S])+g*_+b*w+v*N,f[3*d+S]=r[3*d]*_+r[3*d+1]*w+r[3*d+2]*N}}c.needsUpdate=u.needsUpdate=!0}paint(t,e,n){let{color:r}=this.geometry.attributes;for(let s=0;s<this.station.length;s++){let o=this.station[s]+Math.round(this.share[s]),a=Ts((t[this.placeOf(o)/3]-e)/(n-e||1));for(let l=0;l<3;l++)r.array[3*s+l]=Gi[a+l]}r.needsUpdate=!0}placeOf(t){let{links:e,stations:n}=this;return 3*(e[Math.floor(t/n)]*n+t%n)}turn(t,e){let{axes:n,frames:r,links:s,stations:o}=this;s.forEach((a,l)=>{Wl(n,e,4*a);for(let c=0;c<o;c++){let u=3*(a*o+Math.max(c-1,0)),h=3*(a*o+Math.min(c+1,o-1));ql(n,t[h]-t[u],t[h+1]-t[u+1],t[h+2]-t[u+2]),r.set(n,9*(l*o+c))}})}};var bb=new V(0,1,0),wb=.6,io=class{constructor(t,e,n,r){this.look=n;this.widths=r;let s=this.material(n.link,!1),o=n.painted==="none"?s:this.material("#ffffff",!0),a=new Set(t.meshes.flatMap(c=>c.along??[c.link]));if(this.sweeps=t.links.map((c,u)=>{if(u>=e.links||a.has(u))return null;let h=new Qh(e.stations,vm(c,e.stations,r),n.fine?24:10);return this.add(new Ge(h.geometry,c.bends||n.painted==="all"?o:s)),h}),t.meshes.filter(({link:c})=>c<e.links).forEach(c=>c.along?this.bend(c,c.along,e,o):this.surface(c)),n.opacity<1)return;t.joints.filter(({link:c})=>c<e.links).forEach(c=>this.housing(c,t.links[c.link],a.has(c.link))),t.links.slice(0,e.links).forEach((c,u)=>this.holder(c,u,e,a));let l=new oa((a.size>0?.5:1.5)*r.usual,24,16);this.payload=this.add(new Ge(this.kept(l),this.material(n.payload,!1)))}look;widths;group=new kn;sweeps;bents=[];placed=[];tinted=[];rods=[];pedestals=[];payload=null;trash=[];from=new V;to=new V;quaternion=new zn;update(t,e,n,r){let{stations:s,roots:o,values:a}=t,l=3*s;this.sweeps.forEach((c,u)=>{c?.shape(e,u*l,o,4*u),this.look.painted!=="none"&&c?.paint(a,u*s,n,r)});for(let c of this.bents)c.shape(e,o),this.look.painted!=="none"&&c.paint(a,n,r);for(let{object:c,link:u,turn:h}of this.placed)u<0||(c.position.fromArray(e,u*l),c.quaternion.fromArray(o,4*u),h&&c.quaternion.multiply(h));for(let{material:c,link:u}of this.tinted){let h=Ts((a[(u+1)*s-1]-n)/(r-n||1));c.color.setRGB(Gi[h],Gi[h+1],Gi[h+2])}for(let c of this.rods)this.between(c.object,e,c.place,c.link*l);for(let{object:c,link:u}of this.pedestals)this.stand(c,e,u*l);this.payload?.position.copy(this.from.fromArray(t.tip))}dispose(){this.sweeps.forEach(t=>t?.dispose()),this.trash.forEach(t=>t.dispose()),this.group.removeFromParent()}material(t,e){let{opacity:n,fine:r,layer:s=0}=this.look,o=s+(n<1?2:0),a={polygonOffset:o>0,polygonOffsetFactor:o,polygonOffsetUnits:4*o},l={transparent:n<1,opacity:n,depthWrite:n>=1,...a},c={color:t,vertexColors:e,...l};return this.kept(r?new pl({...c,roughness:.5,metalness:.1}):new Xs(c))}kept(t){return this.trash.push(t),t}add(t){return t.frustumCulled=!1,t.castShadow=t.receiveShadow=this.look.opacity>=1,this.group.add(t),t}housing(t,e,n){if(e===void 0||n||t.drawing==="none")return;let r=1.5*this.widths.usual,s=t.drawing==="cylinder"?new _r(r,r,2.2*r,this.look.fine?32:14):t.drawing==="ball"?new oa(1.2*r,this.look.fine?32:14,this.look.fine?24:10):new ps(2*r,2.2*r,2*r),o=this.add(new Ge(this.kept(s),this.material(t.elastic?this.look.gear:this.look.joint,!1))),a=new V(...t.axis).normalize();this.placed.push({object:o,link:t.link,turn:new zn().setFromUnitVectors(bb,a)})}bend(t,e,n,r){let s={vertices:Float32Array.from(t.vertices.data),faces:Uint32Array.from(t.faces.data)},o=_b(Float32Array.from(n.arrays.line.data),n.stations,e),a=new tf(s,e,n.stations,o,wb);this.kept(a.geometry),this.bents.push(a);let l=this.look.painted==="none"&&this.look.opacity>=1;this.add(new Ge(a.geometry,l?this.material(t.colour,!1):r))}surface(t){let e=new sn;e.setAttribute("position",new je(Float32Array.from(t.vertices.data),3)),e.setIndex(new je(Uint32Array.from(t.faces.data),1));let n=this.kept(Jh(e,wb)),r=this.material(this.look.opacity<1?this.look.link:t.colour,!1);this.placed.push({object:this.add(new Ge(n,r)),link:t.link,turn:null}),this.look.painted==="all"&&t.link>=0&&this.tinted.push({material:r,link:t.link})}holder(t,e,n,r){if(t.parent<0){if(r.has(-1)||r.has(e))return;let c=new _r(1.8*this.widths.usual,3*this.widths.usual,1,32);this.pedestals.push({object:this.add(new Ge(this.kept(c),this.material(this.look.base,!1))),link:e});return}let{place:s,away:o}=xm(n,t.parent,e);if(o<.5*this.widths.usual||r.has(e)&&r.has(t.parent))return;let a=new _r(.8*this.widths.usual,.8*this.widths.usual,1,16),l=this.add(new Ge(this.kept(a),this.material(this.look.link,!1)));this.rods.push({object:l,link:e,parent:t.parent,place:s})}between(t,e,n,r){this.from.fromArray(e,n),this.to.fromArray(e,r).sub(this.from);let s=this.to.length();t.position.copy(this.from).addScaledVector(this.to,.5),t.scale.set(1,Math.max(s,1e-9),1),s>0&&t.quaternion.copy(this.quaternion.setFromUnitVectors(bb,this.to.divideScalar(s)))}stand(t,e,n){let r=Math.max(e[n+2]-this.widths.floor,1e-4);t.position.set(e[n],e[n+1],this.widths.floor+r/2),t.scale.set(1,r,1),t.rotation.set(Math.PI/2,0,0)}};function xm({arrays:i,stations:t},e,n){let{data:r}=i.line,s=3*t*n,o={place:0,away:1/0};for(let a=0;a<t;a++){let l=3*(t*e+a),c=Math.hypot(r[l]-r[s],r[l+1]-r[s+1],r[l+2]-r[s+2]);c<o.away&&(o={place:l,away:c})}return o}function vm(i,t,e){let n=new Float32Array(2*t).fill(e.usual);if(i.section===null)return{shape:"round",sizes:n};let r=i.section.sizes,s=r.shape[0]-1;for(let o=0;o<t;o++)for(let a=0;a<2;a++){let l=Math.round(o/Math.max(t-1,1)*s);n[2*o+a]=Math.max(r.data[2*l+a],e.least)}return{shape:i.section.shape,sizes:n}}var e3=.6,ro=class{constructor(t,e,n){this.body=t;this.motion=e;this.widths=n;this.sections=t.links.slice(0,e.links).map(r=>vm(r,e.stations,n)),t.links.slice(0,e.links).forEach(({parent:r},s)=>{if(r<0)return;let{place:o,away:a}=xm(e,r,s);a>=.5*n.usual&&this.rods.push({link:s,place:o})})}body;motion;widths;sections;rods=[];axes=new Float32Array(9);pair=new Float32Array(6);draw(t,e,n,r,s){let{motion:o,widths:a}=this,l=3*o.stations,c=this.body.links.slice(0,o.links).flatMap((h,f)=>[{depth:this.far(t,e,f),draw:()=>this.link(t,e,f,h,n,r,s)},...h.parent<0?[{depth:t.depth(e,f*l)+a.usual,draw:()=>this.stand(t,e,f*l,n)}]:[]]);c.push(...this.rods.map(({link:h,place:f})=>this.rod(t,e,h*l,f,n)));for(let{link:h,drawing:f,elastic:d}of this.body.joints){if(h>=o.links||f==="none")continue;let m=()=>t.dot(e,h*l,1.5*a.usual,d?n.gear:n.joint,n.base);c.push({depth:t.depth(e,h*l)-2*a.usual,draw:m})}let u=()=>t.dot(o.tip,0,1.5*a.usual,n.payload,n.base);c.push({depth:t.depth(o.tip,0)-2*a.usual,draw:u}),c.sort((h,f)=>f.depth-h.depth).forEach(h=>h.draw())}ghost(t,e,n,r){let{motion:s,sections:o}=this,{stations:a}=s;for(let l=0;l<s.links;l++){let c=3*a*l,u=Math.max(...o[l].sizes);t.path(e,c,a),t.stroke(n,Math.max(1.6*u*t.perMeter(t.depth(e,c)),2),r)}}link(t,e,n,r,s,o,a){let{motion:l}=this,{stations:c,values:u}=l,h=3*c*n,f=s.painted==="all"||s.painted==="bending"&&r.bends,d=this.seenWidths(t,e,n,a);for(let g=1;g<c;g++)t.path(e,h+3*g-3,2),t.stroke(s.base,d[g]+2,1,g===1||g===c-1?"round":"butt");let m=o.low,y=o.high-m||1;for(let g=1;g<c;g++){let p=(u[n*c+g-1]+u[n*c+g])/2;this.stretch(t,e,h+3*g),t.stroke(f?i3((p-m)/y):s.link,d[g],1,"butt")}}stretch(t,e,n){let{pair:r}=this,s=Math.hypot(e[n]-e[n-3],e[n+1]-e[n-2],e[n+2]-e[n-1]),o=s>0?e3/t.perMeter(t.depth(e,n))/s:0;for(let a=0;a<3;a++){let l=o*(e[n+a]-e[n-3+a]);r[a]=e[n-3+a]-l,r[3+a]=e[n+a]+l}t.path(r,0,2)}seenWidths(t,e,n,r){let{axes:s,motion:o}=this,{stations:a,roots:l}=o,{shape:c,sizes:u}=this.sections[n],h=new Float32Array(a);Wl(s,l,4*n);for(let f=1;f<a;f++){let d=3*(a*n+f);ql(s,e[d]-e[d-3],e[d+1]-e[d-2],e[d+2]-e[d-1]);let[m,y,g]=n3(s,r.x-e[d],r.y-e[d+1]-t.aside,r.z-e[d+2]),p=u[2*f]*Math.abs(m*s[3]+y*s[4]+g*s[5]),x=u[2*f+1]*Math.abs(m*s[6]+y*s[7]+g*s[8]),b=c==="round"?Math.hypot(p,x):p+x;h[f]=Math.max(2*Math.max(b,this.widths.least)*t.perMeter(t.depth(e,d)),2.5)}return h}far(t,e,n){let{stations:r}=this.motion;return t.depth(e,3*(r*n+(r>>1)))}rod(t,e,n,r,s){let o=t.depth(e,n)+this.widths.usual;return{depth:o,draw:()=>{t.context.beginPath(),t.piece(e,r,e,n,!0),t.stroke(s.base,1.6*this.widths.usual*t.perMeter(o)+2),t.stroke(s.link,1.6*this.widths.usual*t.perMeter(o))}}}stand(t,e,n,r){let{usual:s,floor:o}=this.widths,a=[e[n],e[n+1],o],[l,c]=[t.at(e,n),t.at(a,0)];if(l===null||c===null)return;let[u,h]=[1.8*s*t.perMeter(t.depth(e,n)),3*s*t.perMeter(t.depth(a,0))],f=Math.hypot(c[0]-l[0],c[1]-l[1]);if(f>1){let[d,m]=[(c[1]-l[1])/f,(l[0]-c[0])/f],y=(g,p)=>[g[0]+p*d,g[1]+p*m];t.fill([y(l,u),y(c,h),y(c,-h),y(l,-u)],r.base)}t.dot(e,n,1.8*s,r.base,r.base)}};function n3(i,t,e,n){let r=[i[1]*n-i[2]*e,i[2]*t-i[0]*n,i[0]*e-i[1]*t],s=Math.hypot(...r)||1;return[r[0]/s,r[1]/s,r[2]/s]}function i3(i){let t=Ts(i);return`rgb(${[0,1,2].map(e=>Math.round(255*Gi[t+e])).join(" ")})`}var nf=1.6,$l=class{constructor(t,e,n){this.mode=t;this.size=n;let[r,s]=t.rest.shape,o={data:t.rest.data,shape:[1,r,s,3]},a={data:e.roots.data.slice(0,4*r),shape:[1,r,4]},l=t.rest.data.slice(3*(r*s-1),3*r*s);this.motion=new As({times:{data:Float64Array.of(0),shape:[1]},line:o,rigid:o,reference:null,roots:a,tip:{data:l,shape:[1,3]},tipReference:null,colours:[],contact:null}),this.motion.seek(0,1,null),this.roots=this.motion.roots.slice()}mode;size;motion;roots;swing(t){let{mode:e,motion:n,size:r}=this,s=r*Math.cos(t),o=r*Math.sin(t),{line:a,values:l}=n;for(let c=0;c<l.length;c++){let u=0;for(let h=3*c;h<3*c+3;h++){let f=s*e.real.data[h]-o*e.imaginary.data[h];a[h]=e.rest.data[h]+f,u+=f*f}l[c]=Math.sqrt(u)/r}for(let c=0;c<3;c++)n.tip[c]=a[a.length-3+c];n.roots.set(this.roots),Vh(n.roots,e.rest.data,a,n.stations)}},ef=class{group=new kn;swinging;robot;rest;constructor(t,e,n,r){let{colours:s,extent:o,fine:a}=r;this.swinging=new $l(t,e,n*o.reach);let{motion:l}=this.swinging,{link:c,joint:u,gear:h,base:f,payload:d,rigid:m}=s,y={link:c,joint:u,gear:h,base:f,payload:d,opacity:1,painted:"all",fine:a},g={...y,link:m,opacity:.35,painted:"none"};this.robot=new io(e,l,y,o),this.rest=new io(e,l,g,{...o,usual:.8*o.usual}),this.group.add(this.robot.group,this.rest.group),this.rest.update(l,l.line,0,1)}swing(t){let{motion:e}=this.swinging;this.swinging.swing(t),this.robot.update(e,e.line,0,1)}dispose(){this.robot.dispose(),this.rest.dispose(),this.group.removeFromParent()}};var r3=1e-12,ya=class{constructor(t,e,n,r){this.canvas=t;this.runs=n;this.given=r;let{page:s,extent:o,ask:a}=r;this.scale=ma(s.runs,o.reach),this.cameras=new Bh(e,t,o.reach,o.opening.direction,a),t.tabIndex=0,t.setAttribute("role","img");let l="Arrow keys turn the view, with Shift they move it, + and - zoom.";t.setAttribute("aria-label",`The robot in space: ${s.runs.map(({name:c})=>c).join(", ")}. ${l}`),t.title=`Drag to turn, right button to move, click and wheel to zoom. ${l}`}canvas;runs;given;cameras;scale;range={low:0,high:1};shown=null;replace(t,e){this.runs[t]?.replace(e)}showMode(t,e){this.shown=t}refresh(){let{runs:t}=this,{settings:e,extent:n}=this.given,r={low:1/0,high:-1/0};t.forEach(f=>f.widen(e.colour,r)),this.range=r.low<=r.high?r:{low:0,high:0};let{box:s,reach:o}=n,a=e.apart?Math.max(.4*o,s.max.y-s.min.y+.15*o):0,l=t.map(({run:f})=>JSON.stringify(f.scene.contact?.surface));t.forEach((f,d)=>{f.aside=(d-(t.length-1)/2)*a,f.showsSurface=e.apart||l.indexOf(l[d])===d});let c=nb(this.given.page,e.factor,n),u=s.min.toArray().map((f,d)=>f-(d===1?(t.length-1)/2*a:0)),h=s.max.toArray().map((f,d)=>f+(d===1?(t.length-1)/2*a:0));this.cameras.places=a?[...c,...u,...h]:c}look(t,e){this.cameras.show(t,this.runs[0].motion.tip,e)}takeView(t){this.cameras.take(t.cameras)}tell(t){let{settings:e,extent:n}=this.given,{shown:r}=this,s=this.runs.flatMap(({run:a})=>a.scene.colours).find(({id:a})=>a===e.colour);t.list(r?this.modeEntries(r):this.entries(),!r&&this.forceShown()),r?t.range({label:"Displacement, share of the largest",unit:"",low:0,high:1}):t.range(s&&this.range.high>r3?{label:s.label,unit:s.unit,...this.range}:null),t.enlarged(e.factor===1||r?"":`Deformation × ${e.factor}, not to scale`);let o=n.floor===0?"":`, at z = ${Mr(n.floor)} m`;t.flat(""),t.floor(e.floor?`Grid ${Mr(n.cell)} m${o}${this.thick()}`:"")}words(){if(!this.forceShown())return"";let t=n=>Mr(Math.hypot(...n));return`Contact force ${this.runs.filter(({run:n})=>n.scene.contact).map(({motion:n})=>`${t(n.force)} N`).join(", ")} (arrow: ${Mr(.1/this.scale)} N per 0.1 m)`}dispose(){this.cameras.dispose(),this.canvas.remove()}forceShown(){return this.given.settings.force&&this.scale>0}entries(){let{runs:t}=this,{settings:e,colours:n}=this.given,r=t.length===1,s=[];r?e.traces&&this.moves()&&s.push({colour:n.real,label:"Path of the tip"}):s.push(...t.map(l=>({colour:l.colour,label:l.run.name})));let o=l=>e[l]&&t.some(({run:c})=>c.scene[l]),a=e.traces&&this.moves()&&t.some(({run:l})=>l.scene.tipReference);return o("reference")?s.push({colour:t[0].referenceColour,label:"Nominal"}):a&&s.push({colour:t[0].referenceColour,label:"Path of the nominal tip"}),o("rigid")&&s.push({colour:n.rigid,label:"Undeformed"}),t.some(({changed:l})=>l)&&s.push({colour:n.before,label:"The run as it was"}),s}moves(){return this.runs.some(({run:t})=>t.charts.length>0)}modeEntries(t){let e=`damping ${Mr(100*t.damping)} %`,n=`motors ${t.case}; slowed, not to scale`,r=`Mode ${Mr(t.frequency)} Hz, ${e}, ${t.element}; ${n}`;return[{colour:this.given.colours.rigid,label:"At rest"},{colour:"transparent",label:r}]}thick(){let{least:t}=this.given.extent,e=this.runs.flatMap(({run:s})=>s.scene.links.map(({section:o})=>o)),n=e.some(s=>s&&Math.min(...s.sizes.data)<t),r=Gh("m",2*t);return n?`; links are drawn at least ${Mr(2*t*r.factor)} ${r.name} thick`:e.some(s=>s?.guessed)?"; thickness of links by their stiffness and mass":""}};var rf=.42,_m=class extends pa{constructor(e,n,r,s,o){super(e,n,r,s);this.colours=s;this.extent=o;this.robot=new ro(e.scene,this.motion,o),this.surface=this.touched()}colours;extent;robot;was=null;surface;paths=[];traced=0;replace(e){super.replace(e),this.robot=new ro(this.run.scene,this.motion,this.extent),this.was=this.before&&new ro(this.run.scene,this.before,this.extent),this.surface=this.touched(),this.traced=0}touched(){let{contact:e}=this.run.scene;if(e===null)return null;let{surface:n,at:r}={...e,...this.motion.arrays.contact};return new Zh({surface:n??e.surface,at:r},this.extent,this.colours.surface)}draw({pen:e,camera:n,scale:r,colours:s},o,a,l){let{motion:c,before:u}=this;e.aside=this.aside,this.seek(o,a),this.trace(a.factor),a.surface&&this.showsSurface&&this.surface?.draw(e),this.was&&u&&this.was.ghost(e,u.line,s.before,rf),a.rigid&&c.rigid&&this.robot.ghost(e,c.rigid,s.rigid,rf),a.reference&&c.reference&&this.robot.ghost(e,c.reference,this.referenceColour,rf),a.traces&&this.paths.forEach(({path:h,color:f})=>db(e,h,c.frame,f)),this.robot.draw(e,c.line,this.look(a),l,n.position),a.force&&c.arrays.contact&&pb(e,c.force,c.at,r,s.force),e.aside=0}look(e){let n=Vl(e.colour);return{...Mb(this.colours,this.alone?null:this.colour,n==="none"?this.colour:this.colours.link),painted:n}}trace(e){if(e===this.traced)return;this.traced=e;let[n,r]=[this.motion.path(!1,e),this.motion.path(!0,e)];this.paths=[],r&&this.paths.push({path:r,color:this.referenceColour}),n&&this.paths.push({path:n,color:this.colour})}};function Mb({joint:i,gear:t,base:e,payload:n},r,s){return{link:s,joint:r??i,gear:r??t,base:e,payload:r??n,opacity:1,painted:"all",fine:!1}}var sf=class extends ya{constructor(e,n){let{page:r,extent:s,colours:o}=e,a=new Hn(32,1,.01*s.reach,100*s.reach);a.up.set(0,0,1);let l=new Kh(a);super(l.canvas,a,r.runs.map((c,u)=>new _m(c,u,r.runs.length===1,o,s)),e);this.wanted=n;this.sheet={pen:l,camera:a,extent:s,colours:o,scale:this.scale},this.refresh()}wanted;sheet;mode=null;draw(e,n){let{sheet:r,runs:s}=this,{settings:o,extent:a,colours:l}=this.given;this.mode||this.cameras.follow(s[0].motion.tip),r.pen.begin(a.reach),o.floor&&fb(r.pen,a,l),this.mode?this.swing(2*Math.PI*n/nf):this.sorted().forEach(c=>c.draw(r,e,o,this.range))}showMode(e,n){super.showMode(e,n);let{scene:r}=this.runs[0].run,s=e&&new $l(e,r,n*this.given.extent.reach);this.mode=s&&{swinging:s,robot:new ro(r,s.motion,this.given.extent)}}resize(e,n){this.sheet.pen.resize(e,n)}tell(e){super.tell(e);let r=this.runs.some(({run:s})=>s.scene.meshes.length>0)?"; the surfaces of the parts (meshes) are left out":"";e.flat(`Drawn in lines${this.wanted?"":", without WebGL"}${r}`)}sorted(){let{pen:e}=this.sheet,n=r=>e.depth([0,r.aside,0],0);return[...this.runs].sort((r,s)=>n(s)-n(r))}swing(e){if(!this.mode)return;let{swinging:n,robot:r}=this.mode,{pen:s,camera:o,colours:a}=this.sheet;r.ghost(s,Float32Array.from(n.motion.arrays.line.data),a.rigid,rf),n.swing(e),r.draw(s,n.motion.line,Mb(a,null,a.link),{low:0,high:1},o.position)}};var Sb=5,of=class{constructor(t){this.place=t;let e=Ue("div",{className:"scene-below"},this.way,this.grid);this.foot=Ue("div",{className:"scene-foot"},e,this.factor),t.append(this.legend,this.scale,this.foot)}place;legend=Xl("scene-legend");scale=Xl("scene-scale");factor=Xl("scene-factor");grid=Xl("scene-grid");way=Xl("scene-flat");live=Ue("span");shown="";foot;rooms(){let[t,e,n,r]=[this.place,this.legend,this.scale,this.foot].map(s=>s.getBoundingClientRect());return Z_(t,e,n,r)}list(t,e){this.legend.replaceChildren(...t.map(({colour:n,label:r})=>Ue("span",{},Ab(n),r))),e&&this.legend.append(this.live),this.legend.hidden=t.length===0&&!e}tell(t){if(t===this.shown)return!1;let e=t===""!=(this.shown==="");return this.shown=t,this.live.textContent=t,e}range(t){if(this.scale.hidden=t===null,t===null)return;let e=Gh(t.unit,t.high),n=Math.abs(t.low)<1e-6*Math.abs(t.high)?0:t.low,r=Array.from({length:Sb},(l,c)=>n+(t.high-n)*c/(Sb-1)),s=Ab(yb()),o=e.name.replaceAll(" "," "),a=Ue("b",{},o?`${t.label} [${o}]`:t.label);this.scale.replaceChildren(a,s,Ue("ol",{},...r.map(l=>Ue("li",{},Mr(e.factor*l)))))}enlarged(t){this.factor.hidden=t==="",this.factor.textContent=t}flat(t){this.way.hidden=t==="",this.way.textContent=t}floor(t){this.grid.hidden=t==="",this.grid.textContent=t}};function Xl(i){return Ue("div",{className:`scene-note ${i}`,hidden:!0})}function Ab(i){let t=Ue("i",{ariaHidden:"true"});return t.style.background=i,t}function bm(){let i=document.createElement("canvas").getContext("webgl2");if(i===null)return null;let t=i.getExtension("WEBGL_debug_renderer_info"),e=String(i.getParameter(t?t.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)?"low":"high"}var af=class{constructor(t,e){this.quality=t;this.extent=e;let n=t==="high";this.renderer=new Fh({canvas:this.canvas,antialias:n,alpha:!0,powerPreference:"low-power"}),this.renderer.setPixelRatio(n?Math.min(window.devicePixelRatio,2):.75*Math.min(window.devicePixelRatio,1)),this.renderer.shadowMap.enabled=n,this.renderer.shadowMap.type=Ys,this.camera.up.set(0,0,1),this.camera.near=.01*e.reach,this.camera.far=100*e.reach,this.scene.add(this.floor)}quality;extent;canvas=document.createElement("canvas");scene=new rl;camera=new Hn(32,1,.01,100);renderer;floor=new kn;light=new bl("#ffffff",2.2);dress(t){let{extent:e,light:n}=this;this.undress();let r=e.cell*2*Math.ceil(1.6*e.reach/e.cell),s=new js(r,Math.round(r/e.cell),t.gridStrong,t.grid);s.rotation.x=Math.PI/2,s.position.z=e.floor,this.floor.add(s,new xl(t.sky,t.ground,1.6),n,n.target);let o=e.box.getCenter(n.target.position);n.position.set(o.x-.6*e.reach,o.y-1.1*e.reach,o.z+2.2*e.reach),this.quality==="high"&&this.shadows(r)}get floorShown(){return this.floor.children[0]?.visible??!1}set floorShown(t){this.floor.children.forEach(e=>{(e instanceof js||e instanceof Ge)&&(e.visible=t)})}resize(t,e){t<1||e<1||(this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix())}draw(){this.renderer.render(this.scene,this.camera)}dispose(){this.undress(),this.light.dispose(),this.renderer.dispose(),this.renderer.getContext().isContextLost()||this.renderer.forceContextLoss(),this.canvas.remove()}shadows(t){let{light:e,extent:n}=this;e.castShadow=!0,e.shadow.mapSize.set(2048,2048),e.shadow.normalBias=.2*n.usual;let{camera:r}=e.shadow;r.left=r.bottom=-1.4*n.reach,r.right=r.top=1.4*n.reach,r.near=.1*n.reach,r.far=6*n.reach;let s=new Ge(new $s(t,t),new dl({opacity:.22,depthWrite:!1}));s.position.z=n.floor,s.receiveShadow=!0,this.floor.add(s)}undress(){for(let t of[...this.floor.children])t instanceof js?t.dispose():t instanceof Ge&&(t.geometry.dispose(),t.material.dispose());this.floor.clear()}};var s3=`
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
.scene-scale { top: 8px; right: 8px; display: grid; gap: 2px; max-width: 46%; min-width: 11em; }
.scene-scale b { font-weight: 600; }
.scene-scale ol { list-style: none; margin: 0; padding: 0; display: flex; justify-content: space-between; gap: 6px;
  font-variant-numeric: tabular-nums; line-height: 1.2; }
.scene-scale i { height: 8px; border-radius: 2px; }
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
  .scene-view { min-height: 160px; }
  .scene-note { font-size: 11px; padding: 2px 5px; }
  .scene-legend { max-width: 58%; display: flex; flex-wrap: wrap; gap: 1px 8px; }
  .scene-legend i { width: 10px; }
  .scene-scale { max-width: 40%; min-width: 8em; }
  .scene-scale li:nth-child(even) { display: none; }
}
@media (pointer: coarse), (max-width: 40rem) {
  .scene-bar select, .scene-bar button, .scene-bar summary { min-height: 40px; min-width: 40px; }
  .scene-more label { min-height: 40px; }
  .scene-more input { width: 20px; height: 20px; }
}
@media print { .scene-bar { display: none; } }
`,lf=null;function Eb(){lf===null&&(lf=new CSSStyleSheet,lf.replaceSync(s3),document.adoptedStyleSheets=[...document.adoptedStyleSheets,lf])}var cf=class extends pa{constructor(e,n,r,s){super(e,n,r,s.colours);this.shared=s}shared;group=new kn;robot;look;ghosts=new Map;traces=[];arrow=null;surface=null;built="";traced="";replace(e){let n=String(this.motion.arrays.line.shape.slice(1));super.replace(e),String(this.motion.arrays.line.shape.slice(1))!==n&&(this.built=""),this.traced="",this.built!==""&&this.placeSurface()}update(e,n,r){let{motion:s}=this;this.build(n),this.seek(e,n),this.robot.update(s,s.line,r.low,r.high),this.haunt("reference",s,n.reference?s.reference:null),this.haunt("rigid",s,n.rigid?s.rigid:null),this.haunt("before",this.before??s,this.before?.line??null),this.draw(n)}dispose(){this.clear(),this.group.removeFromParent()}build(e){let n=Vl(e.colour);if(n===this.built)return;this.clear(),this.built=n;let{scene:r}=this.run,{extent:s,colours:o,fine:a}=this.shared,l=n==="none"?this.colour:o.link,c=this.alone?o.joint:this.colour,u={link:l,joint:c,gear:this.alone?o.gear:c,base:o.base,payload:c,opacity:1,painted:n,fine:a,layer:this.index};this.robot=this.added(r,this.motion,u,1),this.look=u,r.contact&&(this.arrow=new Yh(o.force,.006*s.reach,this.shared.scale),this.group.add(this.arrow.group),this.placeSurface())}placeSurface(){let{contact:e}=this.run.scene;if(!e)return;let{extent:n,colours:r}=this.shared,{surface:s,at:o}={...e,...this.motion.arrays.contact};this.dropSurface(),this.surface=hb(s??e.surface,o.data,.12*n.reach,r.surface),this.group.add(this.surface)}dropSurface(){this.surface&&(this.surface.geometry.dispose(),this.surface.material.dispose(),this.surface.removeFromParent(),this.surface=null)}haunt(e,n,r){let s=this.ghosts.get(e);if(s&&(s.group.visible=r!==null),r===null)return;(s??this.ghost(e,n)).update(n,r,0,1)}ghost(e,n){let{colours:r}=this.shared,s={reference:this.referenceColour,rigid:r.rigid,before:r.before}[e],o=this.added(this.run.scene,n,{...this.look,link:s,opacity:.42,painted:"none"},.85);return this.ghosts.set(e,o),o}added(e,n,r,s){let{extent:o}=this.shared,a={usual:s*o.usual,least:s*o.least,floor:o.floor},l=new io(s<1?o3(e,s):e,n,r,a);return this.group.add(l.group),l}draw(e){this.trace(e);for(let{trace:n,reference:r}of this.traces)n.group.visible=e.traces&&(!r||this.motion.arrays.tipReference!==null),n.seek(this.motion.frame);this.surface&&(this.surface.visible=e.surface&&this.showsSurface),this.arrow&&(this.arrow.point(this.motion.force,this.motion.at),this.arrow.group.visible&&=e.force&&this.motion.arrays.contact!==null)}trace(e){let n=`${e.factor}`;if(n===this.traced)return;let r=this.traces.length===0;this.traced=n;for(let s of[!1,!0]){let o=this.motion.path(s,e.factor),a=this.traces.find(l=>l.reference===s);if(o!==null){if(a)a.trace.lay(o);else if(r){let l=s?this.referenceColour:this.colour,c=new jh(o,l,.012*this.shared.extent.reach);this.traces.push({trace:c,reference:s}),this.group.add(c.group)}}}}clear(){this.robot?.dispose(),this.ghosts.forEach(e=>e.dispose()),this.traces.forEach(({trace:e})=>e.dispose()),this.arrow?.dispose(),this.dropSurface(),this.ghosts.clear(),this.traces=[],this.traced=this.built=""}};function o3(i,t){let e=i.links.map(n=>{if(n.section===null)return n;let{data:r,shape:s}=n.section.sizes;return{...n,section:{...n.section,sizes:{data:Float32Array.from(r,o=>t*o),shape:s}}}});return{...i,links:e}}var uf=class extends ya{stage;shared;mode=null;constructor(t,e){let{page:n,extent:r,colours:s}=t,o=new af(e,r),a={extent:r,colours:s,fine:e==="high",scale:ma(n.runs,r.reach)},l=n.runs.map((c,u)=>new cf(c,u,n.runs.length===1,a));super(o.canvas,o.camera,l,t),this.stage=o,this.shared=a,o.dress(s),l.forEach(({group:c})=>o.scene.add(c)),this.refresh()}draw(t,e){let{settings:n}=this.given;this.mode?this.mode.swing(2*Math.PI*e/nf):this.runs.forEach(r=>r.update(t,n,this.range)),this.mode||this.cameras.follow(this.runs[0].motion.tip),this.stage.draw()}showMode(t,e){super.showMode(t,e),this.mode?.dispose(),this.mode=t&&new ef(t,this.runs[0].run.scene,e,this.shared),this.mode&&this.stage.scene.add(this.mode.group),this.runs.forEach(({group:n})=>n.visible=t===null)}refresh(){super.refresh(),this.runs.forEach(({group:t,aside:e})=>t.position.set(0,e,0)),this.stage.floorShown=this.given.settings.floor}resize(t,e){this.stage.resize(t,e)}dispose(){this.mode?.dispose(),this.runs.forEach(t=>t.dispose()),super.dispose(),this.stage.dispose()}};var a3=2e3;function Tb(i,t,e,n=!1){Eb();let r=Ue("div",{className:"scene"}),s=Ue("div",{className:"scene-view"});return i.append(r),new wm(r,s,t,e,bm(),n)}var wm=class{constructor(t,e,n,r,s,o){this.frame=t;this.place=e;this.page=n;this.clock=r;this.best=s;let{runs:a}=n,l=a.length>1;this.extent=ib(n);let c=o&&this.extent.opening.most>1;this.settings={colour:l?"run":a[0].scene.colours[0]?.id??"run",factor:c?this.extent.opening.factor:1,reference:!l&&!c&&a[0].charts.length>0,rigid:c&&!l,traces:!0,force:!0,surface:!0,floor:!0,apart:!1,quality:"auto"},this.replaced=a.map(()=>null),this.notes=new of(e),t.append(this.controls(),e),this.world=this.made(),this.ends.push(r.subscribe(this.ask));let u=new ResizeObserver(()=>this.resize());u.observe(e),this.dark.addEventListener("change",this.remake),this.ends.push(()=>u.disconnect(),()=>this.dark.removeEventListener("change",this.remake)),this.resize(),this.refresh(),this.world.look("iso",!1)}frame;place;page;clock;best;settings;notes;replaced;ends=[];dark=window.matchMedia("(prefers-color-scheme: dark)");still=window.matchMedia("(prefers-reduced-motion: reduce)");extent;world;waiting=0;mode=null;asked=0;drawn=1;replace(t,e){this.replaced[t]=e,this.world.replace(t,e),this.refresh()}showMode(t,e){t&&this.mode?.mode!==t&&this.frame.scrollIntoView({block:"nearest"}),this.mode=t===null?null:{mode:t,amplitude:e},this.world.showMode(t,e),this.refresh()}get opensAt(){return this.extent.opening.time}get view(){return{pose:this.world.cameras.pose,factor:this.settings.factor}}set view({pose:t,factor:e}){let n=this.frame.querySelector("[data-scene=factor]"),{most:r}=this.extent.opening;n&&e!==this.settings.factor&&(n.value=String(100*Math.log(Math.min(Math.max(e,1),r))/Math.log(r)),n.dispatchEvent(new Event("input"))),t.length===6&&t.every(Number.isFinite)&&(this.world.cameras.pose=t)}picture(t=document.createElement("canvas")){this.world.draw(this.clock.time,this.still.matches?0:performance.now()/1e3);let e=getComputedStyle(this.frame),n=this.settings.factor===1?"":`, deformation × ${this.settings.factor}`,r=this.mode?"":`, t = ${this.clock.time.toFixed(3)} s${n}`;return Jx(t,this.world.canvas,s=>e.getPropertyValue(s),this.page.title+r)}resize(){this.world.resize(this.place.clientWidth,this.place.clientHeight),this.world.cameras.preset&&this.world.cameras.refit(),this.ask()}dispose(){cancelAnimationFrame(this.asked),window.clearTimeout(this.waiting),this.ends.forEach(t=>t()),this.world.canvas.removeEventListener("webglcontextlost",this.lost),this.world.dispose(),this.frame.remove()}controls(){let{runs:t}=this.page,n=[...new Map(t.flatMap(({scene:a})=>a.colours.map(({id:l,label:c})=>[l,c]))),["run",t.length>1?"each robot its own":"none"]],r=a=>t.some(({scene:l})=>a(l)),o=[["reference",r(a=>a.reference)],["rigid",r(a=>a.rigid)],["traces",!0],["force",r(a=>a.contact)],["surface",r(a=>a.contact)],["floor",!0],["apart",t.length>1]].filter(([,a])=>a).map(([a])=>a);return tb(this.settings,n,o,this.extent.opening.most,this.best!==null,{changed:()=>{let a=this.drawn;this.refresh(),a!==this.settings.factor&&this.world.cameras.refit()},look:a=>this.world.look(a,!this.still.matches),quality:()=>{this.best??=bm(),this.remake()}})}made(){let{page:t,extent:e,settings:n,ask:r}=this,s={page:t,extent:e,colours:mb(this.dark.matches),settings:n,ask:r},{quality:o}=n,a=o==="lines"?null:this.best&&(o==="auto"?this.best:o),l=(a&&l3(s,a))??new sf(s,o==="lines");return l.cameras.rooms=()=>this.notes.rooms(),l.canvas.addEventListener("webglcontextlost",this.lost),l.canvas.addEventListener("webglcontextrestored",this.found),this.place.prepend(l.canvas),l}lost=t=>{t.target===this.world.canvas&&(window.clearTimeout(this.waiting),this.waiting=window.setTimeout(()=>{this.best=null,this.remake()},a3))};found=()=>{window.clearTimeout(this.waiting),this.ask()};remake=()=>{let t=this.world;this.world=this.made(),this.world.takeView(t),t.dispose(),this.replaced.forEach((e,n)=>e&&this.world.replace(n,e)),this.mode&&this.world.showMode(this.mode.mode,this.mode.amplitude),this.resize(),this.refresh()};refresh(){this.drawn=this.settings.factor,this.world.refresh(),this.world.tell(this.notes),this.ask()}ask=()=>{this.asked===0&&(this.asked=requestAnimationFrame(this.draw))};draw=t=>{this.asked=0,this.world.draw(this.clock.time,this.still.matches?0:t/1e3),this.notes.tell(this.world.words())&&this.world.cameras.preset&&this.world.cameras.refit(),this.mode&&!this.still.matches&&this.ask()}};function l3(i,t){try{return new uf(i,t)}catch{return null}}var c3=["tip_error.commanded","deviation.max","deflection.max","gear.max"];function Cb(i,t){let e=Math.max(...t.runs.map(C=>C.duration)),n=qm(e),r=rt("div",{class:"scene"}),s=rt("div",{class:"facts-panel",role:"region",tabindex:"0","aria-label":"Numbers that matter"}),o=rt("div",{class:"sliders-panel",role:"region",tabindex:"0","aria-label":"Settings"}),a=rt("div",{class:"side"},s,o),l=rt("div",{class:"transport",role:"group","aria-label":"Time"}),c=rt("section",{class:"charts","aria-label":"Charts"}),u=t.runs.length>1?` of ${t.runs[0].name}`:"",h=Rb(`Elastic line${u}`,t.runs[0].line!==null),f=Rb(`Modes of vibration${u}`,t.runs[0].modes.length>0),d=rt("div",{class:"bar files"});i.classList.add("app"),i.append(rt("div",{class:"stage"},r),l,rt("div",{class:"desk"},a,c,rt("div",{class:"lower"},h.element,f.element)),d);let m=Tb(r,t,n,!0);n.seek(m.opensAt);let y=Kx(l,n),g=[m,y],p=Bd(s,t,n),x=K0(c,t,n),b=t.runs[0].line?Dx(h.body,t,n):null,v=t.runs[0].modes.length?zd(f.body,t,m,n):null;Vx(d,t),l.hidden=c.hidden=t.runs.every(C=>C.charts.length===0);let S=t.runs[0].charts.find(C=>C.abscissa==="time")?.at.data??[],A=C=>{let O=C?C.times:S,W=t.runs[0].facts.flatMap(({id:G,name:et})=>{let $=C?.facts[G]?.time;return $!==void 0&&c3.includes(G)?[{time:$,label:`largest: ${et.toLowerCase()}`}]:[]});y.show(C?W.sort((G,et)=>G.time-et.time):t.runs[0].events,O)};A(null);let _=null;function w(C){n.setDuration(Math.max(C?C.times[C.times.length-1]:0,e)),C?.scene!==_?.scene&&(m.replace(0,C&&C.scene),b?.show(C)),x.show(C),p.show(C),v?.show(C),A(C),document.querySelector("main > .status.good")?.classList.toggle("before",C!==null),_=C}let N=Gd(t.runs[0].name),P=t.live&&Yx(o,t.live,{open:Lx,show:w,fileName:`${N}_changed`,facts:t.runs[0].facts});P?g.push(P):t.notLive&&o.append(rt("p",{class:"note",text:`Nothing can be changed in this page: ${t.notLive}.`}));let I=Gx(N,m,n,()=>Bx(n,m,P));r.querySelector(".scene-bar")?.append(I);let U=()=>zx(location.hash,n,m,P);addEventListener("hashchange",U),U();function z(C){v?.dispose(),f.body.replaceChildren(),f.element.hidden=C.length===0;let[O,...W]=t.runs;v=C.length?zd(f.body,{...t,runs:[{...O,modes:C},...W]},m,n):null}return{clock:n,side:o,scene:m,show:w,showModes:z,complete(C){let[O]=t.runs;[O.facts,O.modes]=[C.facts,C.modes];for(let W of O.charts)W.marks=C.charts.find(({id:G})=>G===W.id)?.marks??[];s.replaceChildren(),p=Bd(s,t,n),x.renew(),z(C.modes)},dispose(){n.pause(),removeEventListener("hashchange",U),v?.dispose(),[...g,x,...b?[b]:[]].forEach(C=>C.dispose()),i.replaceChildren()}}}function Rb(i,t){let e=rt("div",{});return{element:rt("section",{class:"panel",hidden:!t,"aria-label":i},rt("h3",{text:i}),e),body:e}}function Pb(i){let t=document.documentElement,e=[];addEventListener("beforeprint",()=>{t.classList.add("printing");let n=[...document.querySelectorAll(i)].filter(r=>!r.open);for(let r of n)r.open=!0;e=[...e,...n]}),addEventListener("afterprint",()=>{t.classList.remove("printing");for(let n of e)n.open=!1;e=[]})}async function u3(){let i=document.getElementById("tmodes-data"),t=document.getElementById("tmodes-app");if(!(i===null||t===null))try{let e=Hm(await Wm(i.textContent??""));Cb(t,e),document.documentElement.classList.add("running")}catch(e){let n=e instanceof Error?e.message:String(e);t.replaceChildren(rt("p",{class:"status warning",role:"alert",text:`The interactive part of this page could not start: ${n}. The whole report without it follows.`}))}}Pb("details");u3();})();
