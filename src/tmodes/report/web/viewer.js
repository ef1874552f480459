/* tmodes, built from 4ad56cc0c84fab01; BSD-3-Clause */
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
"use strict";(()=>{function rt(i,t={},...e){let n=document.createElement(i);for(let[r,s]of Object.entries(t))r==="text"?n.textContent=String(s):s!==void 0&&s!==!1&&n.setAttribute(r,s===!0?"":s);return n.append(...e.filter(r=>r!==null)),n}function Be(i,t,e={}){let n=rt("button",{type:"button",text:i,...e});return n.addEventListener("click",t),n}function ze(i,t){i.textContent!==t&&(i.textContent=t)}function Ql(i,t,e=2){let n="http://www.w3.org/2000/svg",r=document.createElementNS(n,"svg"),s=document.createElementNS(n,"line"),o={x1:0,y1:5,x2:26,y2:5,"stroke-width":e,"stroke-dasharray":t.join(" ")};for(let[a,l]of Object.entries(o))s.setAttribute(a,String(l));s.style.stroke=i;for(let[a,l]of Object.entries({width:26,height:10,"aria-hidden":"true"}))r.setAttribute(a,String(l));return r.append(s),r}var Wm=0;function Lr(i){return Wm+=1,`tm-${i}-${Wm}`}function tc(i,t){i.toBlob(e=>e&&Fr(e,`${t}.png`,"image/png"),"image/png")}function Fr(i,t,e){let n=URL.createObjectURL(new Blob([i],{type:e}));rt("a",{href:n,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}var Xb="TMPK";function qm(i){if(new TextDecoder().decode(i.subarray(0,4))!==Xb)throw new Error("these bytes are no data of tmodes");let e=new DataView(i.buffer,i.byteOffset,i.byteLength).getUint32(4,!0),n=JSON.parse(new TextDecoder().decode(i.subarray(8,8+e))),r=8*Math.ceil((8+e)/8),s=n.arrays.map(o=>Yb(i,r,o));return ec(n.page,s)}function Yb(i,t,e){let n=e.shape.reduce((o,a)=>o*a,1),r=Number(e.dtype[1]),s=i.slice(t+e.offset,t+e.offset+n*r).buffer;return e.dtype==="f8"?{data:new Float64Array(s),shape:e.shape}:e.dtype==="d4"?{data:Zb(new Uint8Array(s),n,e),shape:e.shape}:e.dtype==="i4"?{data:new Int32Array(s),shape:e.shape}:e.dtype==="u1"?{data:new Uint8Array(s),shape:e.shape}:{data:jb(new Uint8Array(s),n,e),shape:e.shape}}function jb(i,t,{shape:e,scale:n=1,start:r=0}){let s=t/(e[0]||1)||1,o=new Int16Array(t);for(let a=0;a<t;a++)o[a]=(i[a]|i[t+a]<<8)+(a>=s?o[a-s]:0);return Float32Array.from(o,a=>r+n*a)}function Zb(i,t,{shape:e}){let n=t/(e[0]||1)||1,r=new Uint32Array(t);for(let s=0;s<t;s++){let o=i[s]|i[t+s]<<8|i[2*t+s]<<16|i[3*t+s]<<24;r[s]=o+(s>=n?r[s-n]:0)}return new Float32Array(r.buffer)}function ec(i,t){if(Array.isArray(i))return i.map(n=>ec(n,t));if(i===null||typeof i!="object")return i;let e=Object.entries(i);return e.length===1&&e[0][0]==="$array"?t[e[0][1]]:e.length===1&&e[0][0]==="$sum"?Kb(ec(e[0][1],t)):Object.fromEntries(e.map(([n,r])=>[n,ec(r,t)]))}function Kb([i,t]){return{data:Float32Array.from(i.data,(e,n)=>e+t.data[n]),shape:i.shape}}async function $m(i){let t=Uint8Array.from(atob(i.trim()),n=>n.charCodeAt(0)),e=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(e).arrayBuffer())}function Xm(i){let t=new Set,e=0,n=0,r=()=>t.forEach(l=>l(a)),s={time:0,duration:i,playing:!1},o=l=>{let c=Math.min(.25,Math.max(0,(l-n)/1e3));n=l,s.time+=c*a.speed,s.time>=s.duration&&(s.time=a.loop?0:s.duration,s.playing=a.loop),r(),s.playing&&(e=requestAnimationFrame(o))},a={get time(){return s.time},get duration(){return s.duration},get playing(){return s.playing},speed:1,loop:!0,seek(l){s.time=Math.min(Math.max(l,0),s.duration),r()},play(){s.playing||(s.playing=!0,s.time>=s.duration&&(s.time=0),n=performance.now(),e=requestAnimationFrame(o),r())},pause(){s.playing=!1,cancelAnimationFrame(e),r()},toggle(){s.playing?a.pause():a.play()},setDuration(l){s.duration=l,a.seek(s.time)},subscribe(l){return t.add(l),()=>t.delete(l)}};return a}var Jb="uplot",Qb="u-hz",tw="u-vt",ew="u-title",nw="u-wrap",iw="u-under",rw="u-over",sw="u-axis",Ns="u-off",ow="u-select",aw="u-cursor-x",lw="u-cursor-y",cw="u-cursor-pt",uw="u-legend",hw="u-live",fw="u-inline",dw="u-series",pw="u-marker",Ym="u-label",mw="u-value",Ta="width",Ra="height";var jm="bottom",xo="left",bf="right",kf="#000",Zm=kf+"0",wf="mousemove",Km="mousedown",Mf="mouseup",Jm="mouseenter",Qm="mouseleave",tg="dblclick",gw="resize",yw="scroll",eg="change",oc="dppxchange",Bf="--",Ao=typeof window<"u",Rf=Ao?document:null,_o=Ao?window:null,xw=Ao?navigator:null,Te,nc;function Cf(){let i=devicePixelRatio;Te!=i&&(Te=i,nc&&If(eg,nc,Cf),nc=matchMedia(`(min-resolution: ${Te-.001}dppx) and (max-resolution: ${Te+.001}dppx)`),Ds(eg,nc,Cf),_o.dispatchEvent(new CustomEvent(oc)))}function vi(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Pf(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function en(i,t,e){i.style[t]=e+"px"}function $i(i,t,e,n){let r=Rf.createElement(i);return t!=null&&vi(r,t),e?.insertBefore(r,n),r}function Li(i,t){return $i("div",i,t)}var ng=new WeakMap;function pr(i,t,e,n,r){let s="translate("+t+"px,"+e+"px)",o=ng.get(i);s!=o&&(i.style.transform=s,ng.set(i,s),t<0||e<0||t>n||e>r?vi(i,Ns):Pf(i,Ns))}var ig=new WeakMap;function rg(i,t,e){let n=t+e,r=ig.get(i);n!=r&&(ig.set(i,n),i.style.background=t,i.style.borderColor=e)}var sg=new WeakMap;function og(i,t,e,n){let r=t+""+e,s=sg.get(i);r!=s&&(sg.set(i,r),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var zf={passive:!0},vw={...zf,capture:!0};function Ds(i,t,e,n){t.addEventListener(i,e,n?vw:zf)}function If(i,t,e,n){t.removeEventListener(i,e,zf)}Ao&&Cf();function Xi(i,t,e,n){let r;e=e||0,n=n||t.length-1;let s=n<=2147483647;for(;n-e>1;)r=s?e+n>>1:_i((e+n)/2),t[r]<i?e=r:n=r;return i-t[e]<=t[n]-i?e:n}function Ng(i){return(e,n,r)=>{let s=-1,o=-1;for(let a=n;a<=r;a++)if(i(e[a])){s=a;break}for(let a=r;a>=n;a--)if(i(e[a])){o=a;break}return[s,o]}}var Dg=i=>i!=null,Og=i=>i!=null&&i>0,cc=Ng(Dg),_w=Ng(Og);function bw(i,t,e,n=0,r=!1){let s=r?_w:cc,o=r?Og:Dg;[t,e]=s(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??We,l??-We]}function uc(i,t,e,n){let r=cg(i),s=cg(t);i==t&&(r==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Nr:Ug,a=r==1?_i:Fi,l=s==1?Fi:_i,c=a(o(Rn(i))),u=l(o(Rn(t))),h=bo(e,c),f=bo(e,u);return e==10&&(c<0&&(h=qe(h,-c)),u<0&&(f=qe(f,-u))),n||e==2?(i=h*r,t=f*s):(i=Vg(i,h),t=hc(t,f)),[i,t]}function Vf(i,t,e,n){let r=uc(i,t,e,n);return i==0&&(r[0]=0),t==0&&(r[1]=0),r}var Gf=.1,ag={mode:3,pad:Gf},Pa={pad:0,soft:null,mode:0},ww={min:Pa,max:Pa};function ac(i,t,e,n){return fc(e)?lg(i,t,e):(Pa.pad=e,Pa.soft=n?0:null,Pa.mode=n?3:0,lg(i,t,ww))}function Se(i,t){return i??t}function Mw(i,t,e){for(t=Se(t,0),e=Se(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function lg(i,t,e){let n=e.min,r=e.max,s=Se(n.pad,0),o=Se(r.pad,0),a=Se(n.hard,-We),l=Se(r.hard,We),c=Se(n.soft,We),u=Se(r.soft,-We),h=Se(n.mode,0),f=Se(r.mode,0),d=t-i,m=Nr(d),y=ii(Rn(i),Rn(t)),g=Nr(y),p=Rn(g-m);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,h==2&&c!=We&&(s=0),f==2&&u!=-We&&(o=0)));let x=d||y||1e3,_=Nr(x),v=bo(10,_i(_)),M=x*(d==0?i==0?.1:1:s),A=qe(Vg(i-M,v/10),24),b=i>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:We,w=ii(a,A<b&&i>=b?b:Yi(b,A)),N=x*(d==0?t==0?.1:1:o),P=qe(hc(t+N,v/10),24),I=t<=u&&(f==1||f==3&&P>=u||f==2&&P<=u)?u:-We,U=Yi(l,P>I&&t<=I?I:ii(I,P));return w==U&&w==0&&(U=100),[w,U]}var Sw=new Intl.NumberFormat(Ao?xw.language:"en-US"),Hf=i=>Sw.format(i),bi=Math,sc=bi.PI,Rn=bi.abs,_i=bi.floor,Tn=bi.round,Fi=bi.ceil,Yi=bi.min,ii=bi.max,bo=bi.pow,cg=bi.sign,Nr=bi.log10,Ug=bi.log2,Aw=(i,t=1)=>bi.sinh(i)*t,Sf=(i,t=1)=>bi.asinh(i/t),We=1/0;function ug(i){return(Nr((i^i>>31)-(i>>31))|0)+1}function Lf(i,t,e){return Yi(ii(i,t),e)}function kg(i){return typeof i=="function"}function _e(i){return kg(i)?i:()=>i}var Ew=()=>{},Bg=i=>i,zg=(i,t)=>t,Tw=i=>null,hg=i=>!0,fg=(i,t)=>i==t,Rw=/\.\d*?(?=9{6,}|0{6,})/gm,Os=i=>{if(Hg(i)||ns.has(i))return i;let t=`${i}`,e=t.match(Rw);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[r,s]=t.split("e");return+`${Os(r)}e${s}`}return qe(i,n)};function Ls(i,t){return Os(qe(Os(i/t))*t)}function hc(i,t){return Os(Fi(Os(i/t))*t)}function Vg(i,t){return Os(_i(Os(i/t))*t)}function qe(i,t=0){if(Hg(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Tn(n)/e}var ns=new Map;function Gg(i){return((""+i).split(".")[1]||"").length}function La(i,t,e,n){let r=[],s=n.map(Gg);for(let o=t;o<e;o++){let a=Rn(o),l=qe(bo(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=i==10?u:qe(u,h);r.push(f),ns.set(f,h)}}return r}var Ia={},Wf=[],wo=[null,null],es=Array.isArray,Hg=Number.isInteger,Cw=i=>i===void 0;function dg(i){return typeof i=="string"}function fc(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Pw(i){return i!=null&&typeof i=="object"}var Iw=Object.getPrototypeOf(Uint8Array),Wg="__proto__";function Mo(i,t=fc){let e;if(es(i)){let n=i.find(r=>r!=null);if(es(n)||t(n)){e=Array(i.length);for(let r=0;r<i.length;r++)e[r]=Mo(i[r],t)}else e=i.slice()}else if(i instanceof Iw)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Wg&&(e[n]=Mo(i[n],t))}else e=i;return e}function Mn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let r in n)r!=Wg&&(fc(i[r])?Mn(i[r],Mo(n[r])):i[r]=Mo(n[r]))}return i}var Lw=0,Fw=1,Nw=2;function Dw(i,t,e){for(let n=0,r,s=-1;n<t.length;n++){let o=t[n];if(o>s){for(r=o-1;r>=0&&i[r]==null;)i[r--]=null;for(r=o+1;r<e&&i[r]==null;)i[s=r++]=null}}}function Ow(i,t){if(Bw(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return zw(o[0])||(o=kw(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],r=n[0].length,s=new Map;for(let o=0;o<r;o++)s.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(r).fill(void 0),f=t?t[o][c]:Fw,d=[];for(let m=0;m<u.length;m++){let y=u[m],g=s.get(l[m]);y===null?f!=Lw&&(h[g]=y,f==Nw&&d.push(g)):h[g]=y}Dw(h,d,r),n.push(h)}}return n}var Uw=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function kw(i){let t=i[0],e=t.length,n=Array(e);for(let s=0;s<n.length;s++)n[s]=s;n.sort((s,o)=>t[s]-t[o]);let r=[];for(let s=0;s<i.length;s++){let o=i[s],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];r.push(a)}return r}function Bw(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let r=i[n][0];if(r.length!=e)return!1;if(r!=t){for(let s=0;s<e;s++)if(r[s]!=t[s])return!1}}return!0}function zw(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,r=e-1;for(;n<=r&&i[n]==null;)n++;for(;r>=n&&i[r]==null;)r--;if(r<=n)return!0;let s=ii(1,_i((r-n+1)/t));for(let o=i[n],a=n+s;a<=r;a+=s){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var qg=["January","February","March","April","May","June","July","August","September","October","November","December"],$g=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Xg(i){return i.slice(0,3)}var Vw=$g.map(Xg),Gw=qg.map(Xg),Hw={MMMM:qg,MMM:Gw,WWWW:$g,WWW:Vw};function Ea(i){return(i<10?"0":"")+i}function Ww(i){return(i<10?"00":i<100?"0":"")+i}var qw={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Ea(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ea(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Ea(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ea(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ea(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Ww(i.getMilliseconds())};function qf(i,t){t=t||Hw;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=n.exec(i);)e.push(r[0][0]=="{"?qw[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](s,t);return o}}var $w=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Xw(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==$w?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var Yg=i=>i%1==0,lc=[1,2,2.5,5],Yw=La(10,-32,0,lc),jg=La(10,0,32,lc),jw=jg.filter(Yg),Fs=Yw.concat(jg),$f=`
`,Zg="{YYYY}",pg=$f+Zg,Kg="{M}/{D}",Ca=$f+Kg,ic=Ca+"/{YY}",Jg="{aa}",Zw="{h}:{mm}",vo=Zw+Jg,mg=$f+vo,gg=":{ss}",Ce=null;function Qg(i){let t=i*1e3,e=t*60,n=e*60,r=n*24,s=r*30,o=r*365,l=(i==1?La(10,0,3,lc).filter(Yg):La(10,-3,0,lc)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Zg,Ce,Ce,Ce,Ce,Ce,Ce,1],[r*28,"{MMM}",pg,Ce,Ce,Ce,Ce,Ce,1],[r,Kg,pg,Ce,Ce,Ce,Ce,Ce,1],[n,"{h}"+Jg,ic,Ce,Ca,Ce,Ce,Ce,1],[e,vo,ic,Ce,Ca,Ce,Ce,Ce,1],[t,gg,ic+" "+vo,Ce,Ca+" "+vo,Ce,mg,Ce,1],[i,gg+".{fff}",ic+" "+vo,Ce,Ca+" "+vo,Ce,mg,Ce,1]];function u(h){return(f,d,m,y,g,p)=>{let x=[],_=g>=o,v=g>=s&&g<o,M=h(m),A=qe(M*i,3),b=Af(M.getFullYear(),_?0:M.getMonth(),v||_?1:M.getDate()),w=qe(b*i,3);if(v||_){let N=v?g/s:0,P=_?g/o:0,I=A==w?A:qe(Af(b.getFullYear()+P,b.getMonth()+N,1)*i,3),U=new Date(Tn(I/i)),V=U.getFullYear(),C=U.getMonth();for(let D=0;I<=y;D++){let G=Af(V+P*D,C+N*D,1),z=G-h(qe(G*i,3));I=qe((+G+z)*i,3),I<=y&&x.push(I)}}else{let N=g>=r?r:g,P=_i(m)-_i(A),I=w+P+hc(A-w,N);x.push(I);let U=h(I),V=U.getHours()+U.getMinutes()/e+U.getSeconds()/n,C=g/n,D=f.axes[d]._space,G=p/D;for(;I=qe(I+g,i==1?0:3),!(I>y);)if(C>1){let z=_i(qe(V+C,6))%24,X=h(I).getHours()-z;X>1&&(X=-1),I-=X*n,V=(V+C)%24;let tt=x[x.length-1];qe((I-tt)/g,3)*G>=.7&&x.push(I)}else x.push(I)}return x}}return[l,c,u]}var[Kw,Jw,Qw]=Qg(1),[tM,eM,nM]=Qg(.001);La(2,-53,53,[1]);function yg(i,t){return i.map(e=>e.map((n,r)=>r==0||r==8||n==null?n:t(r==1||e[8]==0?n:e[1]+n)))}function xg(i,t){return(e,n,r,s,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,h,f,d;return n.map(m=>{let y=i(m),g=y.getFullYear(),p=y.getMonth(),x=y.getDate(),_=y.getHours(),v=y.getMinutes(),M=y.getSeconds(),A=g!=l&&a[2]||p!=c&&a[3]||x!=u&&a[4]||_!=h&&a[5]||v!=f&&a[6]||M!=d&&a[7]||a[1];return l=g,c=p,u=x,h=_,f=v,d=M,A(y)})}}function iM(i,t){let e=qf(t);return(n,r,s,o,a)=>r.map(l=>e(i(l)))}function Af(i,t,e){return new Date(i,t,e)}function vg(i,t){return t(i)}var rM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function _g(i,t){return(e,n,r,s)=>s==null?Bf:t(i(n))}function sM(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function oM(i,t){return i.series[t].fill(i,t)}var aM={show:!0,live:!0,isolate:!1,mount:Ew,markers:{show:!0,width:2,stroke:sM,fill:oM,dash:"solid"},idx:null,idxs:null,values:[]};function lM(i,t){let e=i.cursor.points,n=Li(),r=e.size(i,t);en(n,Ta,r),en(n,Ra,r);let s=r/-2;en(n,"marginLeft",s),en(n,"marginTop",s);let o=e.width(i,t,r);return o&&en(n,"borderWidth",o),n}function cM(i,t){let e=i.series[t].points;return e._fill||e._stroke}function uM(i,t){let e=i.series[t].points;return e._stroke||e._fill}function hM(i,t){return i.series[t].points.size}var Ef=[0,0];function fM(i,t,e){return Ef[0]=t,Ef[1]=e,Ef}function rc(i,t,e,n=!0){return r=>{r.button==0&&(!n||r.target==t)&&e(r)}}function Tf(i,t,e,n=!0){return r=>{(!n||r.target==t)&&e(r)}}var dM={show:!0,x:!0,y:!0,lock:!1,move:fM,points:{one:!1,show:lM,size:hM,width:0,stroke:uM,fill:cM},bind:{mousedown:rc,mouseup:rc,click:rc,dblclick:rc,mousemove:Tf,mouseleave:Tf,mouseenter:Tf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,r)=>n-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},t0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Xf=Mn({},t0,{filter:zg}),e0=Mn({},Xf,{size:10}),n0=Mn({},t0,{show:!1}),Yf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',i0="bold "+Yf,r0=1.5,bg={show:!0,scale:"x",stroke:kf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:i0,side:2,grid:Xf,ticks:e0,border:n0,font:Yf,lineGap:r0,rotate:0},pM="Value",mM="Time",wg={show:!0,scale:"x",auto:!1,sorted:1,min:We,max:-We,idxs:[]};function gM(i,t,e,n,r){return t.map(s=>s==null?"":Hf(s))}function yM(i,t,e,n,r,s,o){let a=[],l=ns.get(r)||0;e=o?e:qe(hc(e,r),l);for(let c=e;c<=n;c=qe(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function Ff(i,t,e,n,r,s,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Nr:Ug,u=_i(c(e));r=bo(l,u),l==10&&(r=Fs[Xi(r,Fs)]);let h=e,f=r*l;l==10&&(f=Fs[Xi(f,Fs)]);do a.push(h),h=h+r,l==10&&!ns.has(h)&&(h=qe(h,ns.get(r))),h>=f&&(r=h,f=r*l,l==10&&(f=Fs[Xi(f,Fs)]));while(h<=n);return a}function xM(i,t,e,n,r,s,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Ff(i,t,ii(l,e),n,r):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?Ff(i,t,ii(l,-n),-e,r):[l]).reverse().map(f=>-f).concat(u,c)}var s0=/./,vM=/[12357]/,_M=/[125]/,Mg=/1/,Nf=(i,t,e,n)=>i.map((r,s)=>t==4&&r==0||s%n==0&&e.test(r.toExponential()[r<0?1:0])?r:null);function bM(i,t,e,n,r){let s=i.axes[e],o=s.scale,a=i.scales[o],l=i.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?s0:l(7,o)-u>=c?vM:l(5,o)-u>=c?_M:Mg;if(h==Mg){let f=Rn(l(1,o)-u);if(f<c)return Nf(t.slice().reverse(),a.distr,h,Fi(c/f)).reverse()}return Nf(t,a.distr,h,1)}function wM(i,t,e,n,r){let s=i.axes[e],o=s.scale,a=s._space,l=i.valToPos,c=Rn(l(1,o)-l(2,o));return c<a?Nf(t.slice().reverse(),3,s0,Fi(a/c)).reverse():t}function MM(i,t,e,n){return n==null?Bf:t==null?"":Hf(t)}var Sg={show:!0,scale:"y",stroke:kf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:i0,side:3,grid:Xf,ticks:e0,border:n0,font:Yf,lineGap:r0,rotate:0};function SM(i,t){let e=3+(i||1)*2;return qe(e*t,3)}function AM(i,t){let{scale:e,idxs:n}=i.series[0],r=i._data[0],s=i.valToPos(r[n[0]],e,!0),o=i.valToPos(r[n[1]],e,!0),a=Rn(o-s),l=i.series[t],c=a/(l.points.space*Te);return n[1]-n[0]<=c}var Ag={scale:null,auto:!0,sorted:0,min:We,max:-We},o0=(i,t,e,n,r)=>r,Eg={show:!0,auto:!0,sorted:0,gaps:o0,alpha:1,facets:[Mn({},Ag,{scale:"x"}),Mn({},Ag,{scale:"y"})]},Tg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:o0,alpha:1,points:{show:AM,filter:null},values:null,min:We,max:-We,idxs:[],path:null,clip:null};function EM(i,t,e,n,r){return e/10}var a0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},TM=Mn({},a0,{time:!1,ori:1}),Rg={};function l0(i,t){let e=Rg[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(r=>r!=n)},pub(n,r,s,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=r&&e.plots[u].pub(n,r,s,o,a,l,c)}},i!=null&&(Rg[i]=e)),e}var So=1,Df=2;function Us(i,t,e){let n=i.mode,r=i.series[t],s=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=s[0],c=n==2?s[1]:s[t],u=n==2?o[r.facets[0].scale]:o[i.series[0].scale],h=n==2?o[r.facets[1].scale]:o[r.scale],f=a.left,d=a.top,m=a.width,y=a.height,g=i.valToPosH,p=i.valToPosV;return u.ori==0?e(r,l,c,u,h,g,p,f,d,m,y,pc,Eo,gc,u0,f0):e(r,l,c,u,h,p,g,d,f,y,m,mc,To,Kf,h0,d0)}function jf(i,t){let e=0,n=0,r=Se(i.bands,Wf);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function RM(i,t,e,n,r){let s=i.mode,o=i.series[t],a=s==2?o.facets[1].scale:o.scale,l=i.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Dr(i,t,e,n,r,s){return Us(i,t,(o,a,l,c,u,h,f,d,m,y,g)=>{let p=o.pxRound,x=c.dir*(c.ori==0?1:-1),_=c.ori==0?Eo:To,v,M;x==1?(v=e,M=n):(v=n,M=e);let A=p(h(a[v],c,y,d)),b=p(f(l[v],u,g,m)),w=p(h(a[M],c,y,d)),N=p(f(s==1?u.max:u.min,u,g,m)),P=new Path2D(r);return _(P,w,N),_(P,A,N),_(P,A,b),P})}function dc(i,t,e,n,r,s){let o=null;if(i.length>0){o=new Path2D;let a=t==0?gc:Kf,l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+s),l=f[1]}}let c=e+r-l,u=10;c>0&&a(o,l,n-u/2,c,n+s+u)}return o}function CM(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Zf(i,t,e,n,r,s,o){let a=[],l=i.length;for(let c=r==1?e:n;c>=e&&c<=n;c+=r)if(t[c]===null){let h=c,f=c;if(r==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=s(i[h]),m=f==h?d:s(i[f]),y=h-r;d=o<=0&&y>=0&&y<l?s(i[y]):d;let p=f+r;m=o>=0&&p>=0&&p<l?s(i[p]):m,m>=d&&a.push([d,m])}return a}function Cg(i){return i==0?Bg:i==1?Tn:t=>Ls(t,i)}function c0(i){let t=i==0?pc:mc,e=i==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},n=i==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?n(r,s,o,a,l):(c=Yi(c,a/2,l/2),u=Yi(u,a/2,l/2),t(r,s+c,o),e(r,s+a,o,s+a,o+l,c),e(r,s+a,o+l,s,o+l,u),e(r,s,o+l,s,o,u),e(r,s,o,s+a,o,c),r.closePath())}}var pc=(i,t,e)=>{i.moveTo(t,e)},mc=(i,t,e)=>{i.moveTo(e,t)},Eo=(i,t,e)=>{i.lineTo(t,e)},To=(i,t,e)=>{i.lineTo(e,t)},gc=c0(0),Kf=c0(1),u0=(i,t,e,n,r,s)=>{i.arc(t,e,n,r,s)},h0=(i,t,e,n,r,s)=>{i.arc(e,t,n,r,s)},f0=(i,t,e,n,r,s,o)=>{i.bezierCurveTo(t,e,n,r,s,o)},d0=(i,t,e,n,r,s,o)=>{i.bezierCurveTo(e,t,r,n,o,s)};function p0(i){return(t,e,n,r,s)=>Us(t,e,(o,a,l,c,u,h,f,d,m,y,g)=>{let{pxRound:p,points:x}=o,_,v;c.ori==0?(_=pc,v=u0):(_=mc,v=h0);let M=qe(x.width*Te,3),A=(x.size-x.width)/2*Te,b=qe(A*2,3),w=new Path2D,N=new Path2D,{left:P,top:I,width:U,height:V}=t.bbox;gc(N,P-b,I-b,U+b*2,V+b*2);let C=D=>{if(l[D]!=null){let G=p(h(a[D],c,y,d)),z=p(f(l[D],u,g,m));_(w,G+A,z),v(w,G,z,A,0,sc*2)}};if(s)s.forEach(C);else for(let D=n;D<=r;D++)C(D);return{stroke:M>0?w:null,fill:w,clip:N,flags:So|Df}})}function m0(i){return(t,e,n,r,s,o)=>{n!=r&&(s!=n&&o!=n&&i(t,e,n),s!=r&&o!=r&&i(t,e,r),i(t,e,o))}}var PM=m0(Eo),IM=m0(To);function g0(i){let t=Se(i?.alignGaps,0);return(e,n,r,s)=>Us(e,n,(o,a,l,c,u,h,f,d,m,y,g)=>{[r,s]=cc(l,r,s);let p=o.pxRound,x=V=>p(h(V,c,y,d)),_=V=>p(f(V,u,g,m)),v,M;c.ori==0?(v=Eo,M=PM):(v=To,M=IM);let A=c.dir*(c.ori==0?1:-1),b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:So},w=b.stroke,N=!1;if(s-r>=y*4){let V=ct=>e.posToVal(ct,c.key,!0),C=null,D=null,G,z,et,$=x(a[A==1?r:s]),X=x(a[r]),tt=x(a[s]),ht=V(A==1?X+1:tt-1);for(let ct=A==1?r:s;ct>=r&&ct<=s;ct+=A){let J=a[ct],gt=(A==1?J<ht:J>ht)?$:x(J),bt=l[ct];gt==$?bt!=null?(z=bt,C==null?(v(w,gt,_(z)),G=C=D=z):z<C?C=z:z>D&&(D=z)):bt===null&&(N=!0):(C!=null&&M(w,$,_(C),_(D),_(G),_(z)),bt!=null?(z=bt,v(w,gt,_(z)),C=D=G=z):(C=D=null,bt===null&&(N=!0)),$=gt,ht=V($+A))}C!=null&&C!=D&&et!=$&&M(w,$,_(C),_(D),_(G),_(z))}else for(let V=A==1?r:s;V>=r&&V<=s;V+=A){let C=l[V];C===null?N=!0:C!=null&&v(w,x(a[V]),_(C))}let[I,U]=jf(e,n);if(o.fill!=null||I!=0){let V=b.fill=new Path2D(w),C=o.fillTo(e,n,o.min,o.max,I),D=_(C),G=x(a[r]),z=x(a[s]);A==-1&&([z,G]=[G,z]),v(V,z,D),v(V,G,D)}if(!o.spanGaps){let V=[];N&&V.push(...Zf(a,l,r,s,A,x,t)),b.gaps=V=o.gaps(e,n,r,s,V),b.clip=dc(V,c.ori,d,m,y,g)}return U!=0&&(b.band=U==2?[Dr(e,n,r,s,w,-1),Dr(e,n,r,s,w,1)]:Dr(e,n,r,s,w,U)),b})}function LM(i){let t=Se(i.align,1),e=Se(i.ascDesc,!1),n=Se(i.alignGaps,0),r=Se(i.extend,!1);return(s,o,a,l)=>Us(s,o,(c,u,h,f,d,m,y,g,p,x,_)=>{[a,l]=cc(h,a,l);let v=c.pxRound,{left:M,width:A}=s.bbox,b=X=>v(m(X,f,x,g)),w=X=>v(y(X,d,_,p)),N=f.ori==0?Eo:To,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:So},I=P.stroke,U=f.dir*(f.ori==0?1:-1),V=w(h[U==1?a:l]),C=b(u[U==1?a:l]),D=C,G=C;r&&t==-1&&(G=M,N(I,G,V)),N(I,C,V);for(let X=U==1?a:l;X>=a&&X<=l;X+=U){let tt=h[X];if(tt==null)continue;let ht=b(u[X]),ct=w(tt);t==1?N(I,ht,V):N(I,D,ct),N(I,ht,ct),V=ct,D=ht}let z=D;r&&t==1&&(z=M+A,N(I,z,V));let[et,$]=jf(s,o);if(c.fill!=null||et!=0){let X=P.fill=new Path2D(I),tt=c.fillTo(s,o,c.min,c.max,et),ht=w(tt);N(X,z,ht),N(X,G,ht)}if(!c.spanGaps){let X=[];X.push(...Zf(u,h,a,l,U,b,n));let tt=c.width*Te/2,ht=e||t==1?tt:-tt,ct=e||t==-1?-tt:tt;X.forEach(J=>{J[0]+=ht,J[1]+=ct}),P.gaps=X=c.gaps(s,o,a,l,X),P.clip=dc(X,f.ori,g,p,x,_)}return $!=0&&(P.band=$==2?[Dr(s,o,a,l,I,-1),Dr(s,o,a,l,I,1)]:Dr(s,o,a,l,I,$)),P})}function Pg(i,t,e,n,r,s,o=We){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=Rn(i[l]-i[a]);u<c&&(c=u,o=Rn(e(i[l],n,r,s)-e(i[a],n,r,s)))}a=l}}return o}function FM(i){i=i||Ia;let t=Se(i.size,[.6,We,1]),e=i.align||0,n=i.gap||0,r=i.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=_e(r),o=1-t[0],a=Se(t[1],We),l=Se(t[2],1),c=Se(i.disp,Ia),u=Se(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,m,y,g)=>Us(d,m,(p,x,_,v,M,A,b,w,N,P,I)=>{let U=p.pxRound,V=e,C=n*Te,D=a*Te,G=l*Te,z,et;v.ori==0?[z,et]=s(d,m):[et,z]=s(d,m);let $=v.dir*(v.ori==0?1:-1),X=v.ori==0?gc:Kf,tt=v.ori==0?u:(xt,Xt,ce,At,He,Ht,Yt)=>{u(xt,Xt,ce,He,At,Yt,Ht)},ht=Se(d.bands,Wf).find(xt=>xt.series[0]==m),ct=ht!=null?ht.dir:0,J=p.fillTo(d,m,p.min,p.max,ct),dt=U(b(J,M,I,N)),gt,bt,yt,Gt=P,Kt=U(p.width*Te),zt=!1,le=null,oe=null,Jt=null,Fe=null;h!=null&&(Kt==0||f!=null)&&(zt=!0,le=h.values(d,m,y,g),oe=new Map,new Set(le).forEach(xt=>{xt!=null&&oe.set(xt,new Path2D)}),Kt>0&&(Jt=f.values(d,m,y,g),Fe=new Map,new Set(Jt).forEach(xt=>{xt!=null&&Fe.set(xt,new Path2D)})));let{x0:Ae,size:hn}=c;if(Ae!=null&&hn!=null){V=1,x=Ae.values(d,m,y,g),Ae.unit==2&&(x=x.map(ce=>d.posToVal(w+ce*P,v.key,!0)));let xt=hn.values(d,m,y,g);hn.unit==2?bt=xt[0]*P:bt=A(xt[0],v,P,w)-A(0,v,P,w),Gt=Pg(x,_,A,v,P,w,Gt),yt=Gt-bt+C}else Gt=Pg(x,_,A,v,P,w,Gt),yt=Gt*o+C,bt=Gt-yt;yt<1&&(yt=0),Kt>=bt/2&&(Kt=0),yt<5&&(U=Bg);let Ft=yt>0,xe=Gt-yt-(Ft?Kt:0);bt=U(Lf(xe,G,D)),gt=(V==0?bt/2:V==$?0:bt)-V*$*((V==0?C/2:0)+(Ft?Kt/2:0));let te={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},je=zt?null:new Path2D,Ze=null;if(ht!=null)Ze=d.data[ht.series[1]];else{let{y0:xt,y1:Xt}=c;xt!=null&&Xt!=null&&(_=Xt.values(d,m,y,g),Ze=xt.values(d,m,y,g))}let an=z*bt,k=et*bt;for(let xt=$==1?y:g;xt>=y&&xt<=g;xt+=$){let Xt=_[xt];if(Xt==null)continue;if(Ze!=null){let Y=Ze[xt]??0;if(Xt-Y==0)continue;dt=b(Y,M,I,N)}let ce=v.distr!=2||c!=null?x[xt]:xt,At=A(ce,v,P,w),He=b(Se(Xt,J),M,I,N),Ht=U(At-gt),Yt=U(ii(He,dt)),L=U(Yi(He,dt)),E=Yt-L;if(Xt!=null){let Y=Xt<0?k:an,ft=Xt<0?an:k;zt?(Kt>0&&Jt[xt]!=null&&X(Fe.get(Jt[xt]),Ht,L+_i(Kt/2),bt,ii(0,E-Kt),Y,ft),le[xt]!=null&&X(oe.get(le[xt]),Ht,L+_i(Kt/2),bt,ii(0,E-Kt),Y,ft)):X(je,Ht,L+_i(Kt/2),bt,ii(0,E-Kt),Y,ft),tt(d,m,xt,Ht-Kt/2,L,bt+Kt,E)}}return Kt>0?te.stroke=zt?Fe:je:zt||(te._fill=p.width==0?p._fill:p._stroke??p._fill,te.width=0),te.fill=zt?oe:je,te})}function NM(i,t){let e=Se(t?.alignGaps,0);return(n,r,s,o)=>Us(n,r,(a,l,c,u,h,f,d,m,y,g,p)=>{[s,o]=cc(c,s,o);let x=a.pxRound,_=z=>x(f(z,u,g,m)),v=z=>x(d(z,h,p,y)),M,A,b;u.ori==0?(M=pc,b=Eo,A=f0):(M=mc,b=To,A=d0);let w=u.dir*(u.ori==0?1:-1),N=_(l[w==1?s:o]),P=N,I=[],U=[];for(let z=w==1?s:o;z>=s&&z<=o;z+=w)if(c[z]!=null){let $=l[z],X=_($);I.push(P=X),U.push(v(c[z]))}let V={stroke:i(I,U,M,b,A,x),fill:null,clip:null,band:null,gaps:null,flags:So},C=V.stroke,[D,G]=jf(n,r);if(a.fill!=null||D!=0){let z=V.fill=new Path2D(C),et=a.fillTo(n,r,a.min,a.max,D),$=v(et);b(z,P,$),b(z,N,$)}if(!a.spanGaps){let z=[];z.push(...Zf(l,c,s,o,w,_,e)),V.gaps=z=a.gaps(n,r,s,o,z),V.clip=dc(z,u.ori,m,y,g,p)}return G!=0&&(V.band=G==2?[Dr(n,r,s,o,C,-1),Dr(n,r,s,o,C,1)]:Dr(n,r,s,o,C,G)),V})}function DM(i){return NM(OM,i)}function OM(i,t,e,n,r,s){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}return a}var Of=new Set;function Ig(){for(let i of Of)i.syncRect(!0)}Ao&&(Ds(gw,_o,Ig),Ds(yw,_o,Ig,!0),Ds(oc,_o,()=>{cn.pxRatio=Te}));var UM=g0(),kM=p0();function Lg(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((s,o)=>Uf(s,o,t,e))}function BM(i,t){return i.map((e,n)=>n==0?{}:Mn({},t,e))}function Uf(i,t,e,n){return Mn({},t==0?e:n,i)}function y0(i,t,e){return t==null?wo:[t,e]}var zM=y0;function VM(i,t,e){return t==null?wo:ac(t,e,Gf,!0)}function x0(i,t,e,n){return t==null?wo:uc(t,e,i.scales[n].log,!1)}var GM=x0;function v0(i,t,e,n){return t==null?wo:Vf(t,e,i.scales[n].log,!1)}var HM=v0;function WM(i,t,e,n,r){let s=ii(ug(i),ug(t)),o=t-i,a=Xi(r/n*o,e);do{let l=e[a],c=n*l/o;if(c>=r&&s+(l<5?ns.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Fg(i){let t,e;return i=i.replace(/(\d+)px/,(n,r)=>(t=Tn((e=+r)*Te))+"px"),[i,t,e]}function qM(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=qe(t[2]*Te,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function cn(i,t,e){let n={mode:Se(i.mode,1)},r=n.mode;function s(S,T,F,O){let q=T.valToPct(S);return O+F*(T.dir==-1?1-q:q)}function o(S,T,F,O){let q=T.valToPct(S);return O+F*(T.dir==-1?q:1-q)}function a(S,T,F,O){return T.ori==0?s(S,T,F,O):o(S,T,F,O)}n.valToPosH=s,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Li(Jb);if(i.id!=null&&(c.id=i.id),vi(c,i.class),i.title){let S=Li(ew,c);S.textContent=i.title}let u=$i("canvas"),h=n.ctx=u.getContext("2d"),f=Li(nw,c);Ds("click",f,S=>{S.target===m&&(Je!=fo||rn!=po)&&Vn.click(n,S)},!0);let d=n.under=Li(iw,f);f.appendChild(u);let m=n.over=Li(rw,f);i=Mo(i);let y=+Se(i.pxAlign,1),g=Cg(y);(i.plugins||[]).forEach(S=>{S.opts&&(i=S.opts(n,i)||i)});let p=i.ms||.001,x=n.series=r==1?Lg(i.series||[],wg,Tg,!1):BM(i.series||[null],Eg),_=n.axes=Lg(i.axes||[],bg,Sg,!0),v=n.scales={},M=n.bands=i.bands||[];M.forEach(S=>{S.fill=_e(S.fill||null),S.dir=Se(S.dir,-1)});let A=r==2?x[1].facets[0].scale:x[0].scale,b={axes:Pr,series:ge},w=(i.drawOrder||["axes","series"]).map(S=>b[S]);function N(S){let T=S.distr==3?F=>Nr(F>0?F:S.clamp(n,F,S.min,S.max,S.key)):S.distr==4?F=>Sf(F,S.asinh):S.distr==100?F=>S.fwd(F):F=>F;return F=>{let O=T(F),{_min:q,_max:K}=S,lt=K-q;return(O-q)/lt}}function P(S){let T=v[S];if(T==null){let F=(i.scales||Ia)[S]||Ia;if(F.from!=null){P(F.from);let O=Mn({},v[F.from],F,{key:S});O.valToPct=N(O),v[S]=O}else{T=v[S]=Mn({},S==A?a0:TM,F),T.key=S;let O=T.time,q=T.range,K=es(q);if((S!=A||r==2&&!O)&&(K&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?ag:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?ag:{mode:1,hard:q[1],soft:q[1]}},K=!1),!K&&fc(q))){let lt=q;q=(pt,Mt,Nt)=>Mt==null?wo:ac(Mt,Nt,lt)}T.range=_e(q||(O?zM:S==A?T.distr==3?GM:T.distr==4?HM:y0:T.distr==3?x0:T.distr==4?v0:VM)),T.auto=_e(K?!1:T.auto),T.clamp=_e(T.clamp||EM),T._min=T._max=null,T.valToPct=N(T)}}}P("x"),P("y"),r==1&&x.forEach(S=>{P(S.scale)}),_.forEach(S=>{P(S.scale)});for(let S in i.scales)P(S);let I=v[A],U=I.distr,V,C;I.ori==0?(vi(c,Qb),V=s,C=o):(vi(c,tw),V=o,C=s);let D={};for(let S in v){let T=v[S];(T.min!=null||T.max!=null)&&(D[S]={min:T.min,max:T.max},T.min=T.max=null)}let G=i.tzDate||(S=>new Date(Tn(S/p))),z=i.fmtDate||qf,et=p==1?Qw(G):nM(G),$=xg(G,yg(p==1?Jw:eM,z)),X=_g(G,vg(rM,z)),tt=[],ht=n.legend=Mn({},aM,i.legend),ct=n.cursor=Mn({},dM,{drag:{y:r==2}},i.cursor),J=ht.show,dt=ct.show,gt=ht.markers;ht.idxs=tt,gt.width=_e(gt.width),gt.dash=_e(gt.dash),gt.stroke=_e(gt.stroke),gt.fill=_e(gt.fill);let bt,yt,Gt,Kt=[],zt=[],le,oe=!1,Jt={};if(ht.live){let S=x[1]?x[1].values:null;oe=S!=null,le=oe?S(n,1,0):{_:0};for(let T in le)Jt[T]=Bf}if(J)if(bt=$i("table",uw,c),Gt=$i("tbody",null,bt),ht.mount(n,bt),oe){yt=$i("thead",null,bt,Gt);let S=$i("tr",null,yt);$i("th",null,S);for(var Fe in le)$i("th",Ym,S).textContent=Fe}else vi(bt,fw),ht.live&&vi(bt,hw);let Ae={show:!0},hn={show:!1};function Ft(S,T){if(T==0&&(oe||!ht.live||r==2))return wo;let F=[],O=$i("tr",dw,Gt,Gt.childNodes[T]);vi(O,S.class),S.show||vi(O,Ns);let q=$i("th",null,O);if(gt.show){let pt=Li(pw,q);if(T>0){let Mt=gt.width(n,T);Mt&&(pt.style.border=Mt+"px "+gt.dash(n,T)+" "+gt.stroke(n,T)),pt.style.background=gt.fill(n,T)}}let K=Li(Ym,q);S.label instanceof HTMLElement?K.appendChild(S.label):K.textContent=S.label,T>0&&(gt.show||(K.style.color=S.width>0?gt.stroke(n,T):gt.fill(n,T)),te("click",q,pt=>{if(ct._lock)return;ee(pt);let Mt=x.indexOf(S);if((pt.ctrlKey||pt.metaKey)!=ht.isolate){let Nt=x.some((Dt,Ut)=>Ut>0&&Ut!=Mt&&Dt.show);x.forEach((Dt,Ut)=>{Ut>0&&ur(Ut,Nt?Ut==Mt?Ae:hn:Ae,!0,wn.setSeries)})}else ur(Mt,{show:!S.show},!0,wn.setSeries)},!1),ne&&te(Jm,q,pt=>{ct._lock||(ee(pt),ur(x.indexOf(S),go,!0,wn.setSeries))},!1));for(var lt in le){let pt=$i("td",mw,O);pt.textContent="--",F.push(pt)}return[O,F]}let xe=new Map;function te(S,T,F,O=!0){let q=xe.get(T)||{},K=ct.bind[S](n,T,F,O);K&&(Ds(S,T,q[S]=K),xe.set(T,q))}function je(S,T,F){let O=xe.get(T)||{};for(let q in O)(S==null||q==S)&&(If(q,T,O[q]),delete O[q]);S==null&&xe.delete(T)}let Ze=0,an=0,k=0,xt=0,Xt=0,ce=0,At=Xt,He=ce,Ht=k,Yt=xt,L=0,E=0,Y=0,ft=0;n.bbox={};let at=!1,_t=!1,wt=!1,nt=!1,st=!1,mt=!1;function B(S,T,F){(F||S!=n.width||T!=n.height)&&ot(S,T),de(!1),wt=!0,_t=!0,Yn()}function ot(S,T){n.width=Ze=k=S,n.height=an=xt=T,Xt=ce=0,St(),Wt();let F=n.bbox;L=F.left=Ls(Xt*Te,.5),E=F.top=Ls(ce*Te,.5),Y=F.width=Ls(k*Te,.5),ft=F.height=Ls(xt*Te,.5)}let it=3;function Et(){let S=!1,T=0;for(;!S;){T++;let F=co(T),O=cr(T);S=T==it||F&&O,S||(ot(n.width,n.height),_t=!0)}}function vt({width:S,height:T}){B(S,T)}n.setSize=vt;function St(){let S=!1,T=!1,F=!1,O=!1;_.forEach((q,K)=>{if(q.show&&q._show){let{side:lt,_size:pt}=q,Mt=lt%2,Nt=q.label!=null?q.labelSize:0,Dt=pt+Nt;Dt>0&&(Mt?(k-=Dt,lt==3?(Xt+=Dt,O=!0):F=!0):(xt-=Dt,lt==0?(ce+=Dt,S=!0):T=!0))}}),ar[0]=S,ar[1]=F,ar[2]=T,ar[3]=O,k-=Hi[1]+Hi[3],Xt+=Hi[3],xt-=Hi[2]+Hi[0],ce+=Hi[0]}function Wt(){let S=Xt+k,T=ce+xt,F=Xt,O=ce;function q(K,lt){switch(K){case 1:return S+=lt,S-lt;case 2:return T+=lt,T-lt;case 3:return F-=lt,F+lt;case 0:return O-=lt,O+lt}}_.forEach((K,lt)=>{if(K.show&&K._show){let pt=K.side;K._pos=q(pt,K._size),K.label!=null&&(K._lpos=q(pt,K.labelSize))}})}if(ct.dataIdx==null){let S=ct.hover,T=S.skip=new Set(S.skip??[]);T.add(void 0);let F=S.prox=_e(S.prox),O=S.bias??=0;ct.dataIdx=(q,K,lt,pt)=>{if(K==0)return lt;let Mt=lt,Nt=F(q,K,lt,pt)??We,Dt=Nt>=0&&Nt<We,Ut=I.ori==0?k:xt,ae=ct.left,Ee=t[0],Me=t[K];if(T.has(Me[lt])){Mt=null;let ye=null,Qt=null,qt;if(O==0||O==-1)for(qt=lt;ye==null&&qt-- >0;)T.has(Me[qt])||(ye=qt);if(O==0||O==1)for(qt=lt;Qt==null&&qt++<Me.length;)T.has(Me[qt])||(Qt=qt);if(ye!=null||Qt!=null)if(Dt){let tn=ye==null?-1/0:V(Ee[ye],I,Ut,0),pn=Qt==null?1/0:V(Ee[Qt],I,Ut,0),Dn=ae-tn,ke=pn-ae;Dn<=ke?Dn<=Nt&&(Mt=ye):ke<=Nt&&(Mt=Qt)}else Mt=Qt==null?ye:ye==null?Qt:lt-ye<=Qt-lt?ye:Qt}else Dt&&Rn(ae-V(Ee[lt],I,Ut,0))>Nt&&(Mt=null);return Mt}}let ee=S=>{ct.event=S};ct.idxs=tt,ct._lock=!1;let ut=ct.points;ut.show=_e(ut.show),ut.size=_e(ut.size),ut.stroke=_e(ut.stroke),ut.width=_e(ut.width),ut.fill=_e(ut.fill);let kt=n.focus=Mn({},i.focus||{alpha:.3},ct.focus),ne=kt.prox>=0,Ct=ne&&ut.one,fe=[],Ke=[],Jn=[];function xa(S,T){let F=ut.show(n,T);if(F instanceof HTMLElement)return vi(F,cw),vi(F,S.class),pr(F,-10,-10,k,xt),m.insertBefore(F,fe[T]),F}function oo(S,T){if(r==1||T>0){let F=r==1&&v[S.scale].time,O=S.value;S.value=F?dg(O)?_g(G,vg(O,z)):O||X:O||MM,S.label=S.label||(F?mM:pM)}if(Ct||T>0){S.width=S.width==null?1:S.width,S.paths=S.paths||UM||Tw,S.fillTo=_e(S.fillTo||RM),S.pxAlign=+Se(S.pxAlign,y),S.pxRound=Cg(S.pxAlign),S.stroke=_e(S.stroke||null),S.fill=_e(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let F=SM(ii(1,S.width),1),O=S.points=Mn({},{size:F,width:ii(1,F*.2),stroke:S.stroke,space:F*2,paths:kM,_stroke:null,_fill:null},S.points);O.show=_e(O.show),O.filter=_e(O.filter),O.fill=_e(O.fill),O.stroke=_e(O.stroke),O.paths=_e(O.paths),O.pxAlign=S.pxAlign}if(J){let F=Ft(S,T);Kt.splice(T,0,F[0]),zt.splice(T,0,F[1]),ht.values.push(null)}if(dt){tt.splice(T,0,null);let F=null;Ct?T==0&&(F=xa(S,T)):T>0&&(F=xa(S,T)),fe.splice(T,0,F),Ke.splice(T,0,0),Jn.splice(T,0,0)}Nn("addSeries",T)}function hf(S,T){T=T??x.length,S=r==1?Uf(S,T,wg,Tg):Uf(S,T,{},Eg),x.splice(T,0,S),oo(x[T],T)}n.addSeries=hf;function jl(S){if(x.splice(S,1),J){ht.values.splice(S,1),zt.splice(S,1);let T=Kt.splice(S,1)[0];je(null,T.firstChild),T.remove()}dt&&(tt.splice(S,1),fe.splice(S,1)[0].remove(),Ke.splice(S,1),Jn.splice(S,1)),Nn("delSeries",S)}n.delSeries=jl;let ar=[!1,!1,!1,!1];function Tr(S,T){if(S._show=S.show,S.show){let F=S.side%2,O=v[S.scale];O==null&&(S.scale=F?x[1].scale:A,O=v[S.scale]);let q=O.time;S.size=_e(S.size),S.space=_e(S.space),S.rotate=_e(S.rotate),es(S.incrs)&&S.incrs.forEach(lt=>{!ns.has(lt)&&ns.set(lt,Gg(lt))}),S.incrs=_e(S.incrs||(O.distr==2?jw:q?p==1?Kw:tM:Fs)),S.splits=_e(S.splits||(q&&O.distr==1?et:O.distr==3?Ff:O.distr==4?xM:yM)),S.stroke=_e(S.stroke),S.grid.stroke=_e(S.grid.stroke),S.ticks.stroke=_e(S.ticks.stroke),S.border.stroke=_e(S.border.stroke);let K=S.values;S.values=es(K)&&!es(K[0])?_e(K):q?es(K)?xg(G,yg(K,z)):dg(K)?iM(G,K):K||$:K||gM,S.filter=_e(S.filter||(O.distr>=3&&O.log==10?bM:O.distr==3&&O.log==2?wM:zg)),S.font=Fg(S.font),S.labelFont=Fg(S.labelFont),S._size=S.size(n,null,T,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(ar[T]=!0,S._el=Li(sw,f))}}function Rr(S,T,F,O){let[q,K,lt,pt]=F,Mt=T%2,Nt=0;return Mt==0&&(pt||K)&&(Nt=T==0&&!q||T==2&&!lt?Tn(bg.size/3):0),Mt==1&&(q||lt)&&(Nt=T==1&&!K||T==3&&!pt?Tn(Sg.size/2):0),Nt}let va=n.padding=(i.padding||[Rr,Rr,Rr,Rr]).map(S=>_e(Se(S,Rr))),Hi=n._padding=va.map((S,T)=>S(n,T,ar,0)),fn,yn=null,xn=null,lr=r==1?x[0].idxs:null,mi=null,jr=!1;function _a(S,T){if(t=S??[],n.data=n._data=t,r==2){fn=0;for(let F=1;F<x.length;F++)fn+=t[F][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),mi=t[0],fn=mi.length;let F=t;if(U==2){F=t.slice();let O=F[0]=Array(fn);for(let q=0;q<fn;q++)O[q]=q}n._data=t=F}if(de(!0),Nn("setData"),U==2&&(wt=!0),T!==!1){let F=I;F.auto(n,jr)?ba():Jr(A,F.min,F.max),nt=nt||ct.left>=0,mt=!0,Yn()}}n.setData=_a;function ba(){jr=!0;let S,T;r==1&&(fn>0?(yn=lr[0]=0,xn=lr[1]=fn-1,S=t[0][yn],T=t[0][xn],U==2?(S=yn,T=xn):S==T&&(U==3?[S,T]=uc(S,S,I.log,!1):U==4?[S,T]=Vf(S,S,I.log,!1):I.time?T=S+Tn(86400/p):[S,T]=ac(S,T,Gf,!0))):(yn=lr[0]=S=null,xn=lr[1]=T=null)),Jr(A,S,T)}let ao,Zr,lo,R,W,Q,j,Z,Tt,It;function Rt(S,T,F,O,q,K){S??=Zm,F??=Wf,O??="butt",q??=Zm,K??="round",S!=ao&&(h.strokeStyle=ao=S),q!=Zr&&(h.fillStyle=Zr=q),T!=lo&&(h.lineWidth=lo=T),K!=W&&(h.lineJoin=W=K),O!=Q&&(h.lineCap=Q=O),F!=R&&h.setLineDash(R=F)}function Lt(S,T,F,O){T!=Zr&&(h.fillStyle=Zr=T),S!=j&&(h.font=j=S),F!=Z&&(h.textAlign=Z=F),O!=Tt&&(h.textBaseline=Tt=O)}function Vt(S,T,F,O,q=0){if(O.length>0&&S.auto(n,jr)&&(T==null||T.min==null)){let K=Se(yn,0),lt=Se(xn,O.length-1),pt=F.min==null?bw(O,K,lt,q,S.distr==3):[F.min,F.max];S.min=Yi(S.min,F.min=pt[0]),S.max=ii(S.max,F.max=pt[1])}}let ie={min:null,max:null};function me(){for(let O in v){let q=v[O];D[O]==null&&(q.min==null||D[A]!=null&&q.auto(n,jr))&&(D[O]=ie)}for(let O in v){let q=v[O];D[O]==null&&q.from!=null&&D[q.from]!=null&&(D[O]=ie)}D[A]!=null&&de(!0);let S={};for(let O in D){let q=D[O];if(q!=null){let K=S[O]=Mo(v[O],Pw);if(q.min!=null)Mn(K,q);else if(O!=A||r==2)if(fn==0&&K.from==null){let lt=K.range(n,null,null,O);K.min=lt[0],K.max=lt[1]}else K.min=We,K.max=-We}}if(fn>0){x.forEach((O,q)=>{if(r==1){let K=O.scale,lt=D[K];if(lt==null)return;let pt=S[K];if(q==0){let Mt=pt.range(n,pt.min,pt.max,K);pt.min=Mt[0],pt.max=Mt[1],yn=Xi(pt.min,t[0]),xn=Xi(pt.max,t[0]),xn-yn>1&&(t[0][yn]<pt.min&&yn++,t[0][xn]>pt.max&&xn--),O.min=mi[yn],O.max=mi[xn]}else O.show&&O.auto&&Vt(pt,lt,O,t[q],O.sorted);O.idxs[0]=yn,O.idxs[1]=xn}else if(q>0&&O.show&&O.auto){let[K,lt]=O.facets,pt=K.scale,Mt=lt.scale,[Nt,Dt]=t[q],Ut=S[pt],ae=S[Mt];Ut!=null&&Vt(Ut,D[pt],K,Nt,K.sorted),ae!=null&&Vt(ae,D[Mt],lt,Dt,lt.sorted),O.min=lt.min,O.max=lt.max}});for(let O in S){let q=S[O],K=D[O];if(q.from==null&&(K==null||K.min==null)){let lt=q.range(n,q.min==We?null:q.min,q.max==-We?null:q.max,O);q.min=lt[0],q.max=lt[1]}}}for(let O in S){let q=S[O];if(q.from!=null){let K=S[q.from];if(K.min==null)q.min=q.max=null;else{let lt=q.range(n,K.min,K.max,O);q.min=lt[0],q.max=lt[1]}}}let T={},F=!1;for(let O in S){let q=S[O],K=v[O];if(K.min!=q.min||K.max!=q.max){K.min=q.min,K.max=q.max;let lt=K.distr;K._min=lt==3?Nr(K.min):lt==4?Sf(K.min,K.asinh):lt==100?K.fwd(K.min):K.min,K._max=lt==3?Nr(K.max):lt==4?Sf(K.max,K.asinh):lt==100?K.fwd(K.max):K.max,T[O]=F=!0}}if(F){x.forEach((O,q)=>{r==2?q>0&&T.y&&(O._paths=null):T[O.scale]&&(O._paths=null)});for(let O in T)wt=!0,Nn("setScale",O);dt&&ct.left>=0&&(nt=mt=!0)}for(let O in D)D[O]=null}function Bt(S){let T=Lf(yn-1,0,fn-1),F=Lf(xn+1,0,fn-1);for(;S[T]==null&&T>0;)T--;for(;S[F]==null&&F<fn-1;)F++;return[T,F]}function ge(){if(fn>0){let S=x.some(T=>T._focus)&&It!=kt.alpha;S&&(h.globalAlpha=It=kt.alpha),x.forEach((T,F)=>{if(F>0&&T.show&&(ln(F,!1),ln(F,!0),T._paths==null)){let O=It;It!=T.alpha&&(h.globalAlpha=It=T.alpha);let q=r==2?[0,t[F][0].length-1]:Bt(t[F]);T._paths=T.paths(n,F,q[0],q[1]),It!=O&&(h.globalAlpha=It=O)}}),x.forEach((T,F)=>{if(F>0&&T.show){let O=It;It!=T.alpha&&(h.globalAlpha=It=T.alpha),T._paths!=null&&Ne(F,!1);{let q=T._paths!=null?T._paths.gaps:null,K=T.points.show(n,F,yn,xn,q),lt=T.points.filter(n,F,K,q);(K||lt)&&(T.points._paths=T.points.paths(n,F,yn,xn,lt),Ne(F,!0))}It!=O&&(h.globalAlpha=It=O),Nn("drawSeries",F)}}),S&&(h.globalAlpha=It=1)}}function ln(S,T){let F=T?x[S].points:x[S];F._stroke=F.stroke(n,S),F._fill=F.fill(n,S)}function Ne(S,T){let F=T?x[S].points:x[S],{stroke:O,fill:q,clip:K,flags:lt,_stroke:pt=F._stroke,_fill:Mt=F._fill,_width:Nt=F.width}=F._paths;Nt=qe(Nt*Te,3);let Dt=null,Ut=Nt%2/2;T&&Mt==null&&(Mt=Nt>0?"#fff":pt);let ae=F.pxAlign==1&&Ut>0;if(ae&&h.translate(Ut,Ut),!T){let Ee=L-Nt/2,Me=E-Nt/2,ye=Y+Nt,Qt=ft+Nt;Dt=new Path2D,Dt.rect(Ee,Me,ye,Qt)}T?Ot(pt,Nt,F.dash,F.cap,Mt,O,q,lt,K):De(S,pt,Nt,F.dash,F.cap,Mt,O,q,lt,Dt,K),ae&&h.translate(-Ut,-Ut)}function De(S,T,F,O,q,K,lt,pt,Mt,Nt,Dt){let Ut=!1;Mt!=0&&M.forEach((ae,Ee)=>{if(ae.series[0]==S){let Me=x[ae.series[1]],ye=t[ae.series[1]],Qt=(Me._paths||Ia).band;es(Qt)&&(Qt=ae.dir==1?Qt[0]:Qt[1]);let qt,tn=null;Me.show&&Qt&&Mw(ye,yn,xn)?(tn=ae.fill(n,Ee)||K,qt=Me._paths.clip):Qt=null,Ot(T,F,O,q,tn,lt,pt,Mt,Nt,Dt,qt,Qt),Ut=!0}}),Ut||Ot(T,F,O,q,K,lt,pt,Mt,Nt,Dt)}let En=So|Df;function Ot(S,T,F,O,q,K,lt,pt,Mt,Nt,Dt,Ut){Rt(S,T,F,O,q),(Mt||Nt||Ut)&&(h.save(),Mt&&h.clip(Mt),Nt&&h.clip(Nt)),Ut?(pt&En)==En?(h.clip(Ut),Dt&&h.clip(Dt),ve(q,lt),vn(S,K,T)):pt&Df?(ve(q,lt),h.clip(Ut),vn(S,K,T)):pt&So&&(h.save(),h.clip(Ut),Dt&&h.clip(Dt),ve(q,lt),h.restore(),vn(S,K,T)):(ve(q,lt),vn(S,K,T)),(Mt||Nt||Ut)&&h.restore()}function vn(S,T,F){F>0&&(T instanceof Map?T.forEach((O,q)=>{h.strokeStyle=ao=q,h.stroke(O)}):T!=null&&S&&h.stroke(T))}function ve(S,T){T instanceof Map?T.forEach((F,O)=>{h.fillStyle=Zr=O,h.fill(F)}):T!=null&&S&&h.fill(T)}function Cr(S,T,F,O){let q=_[S],K;if(O<=0)K=[0,0];else{let lt=q._space=q.space(n,S,T,F,O),pt=q._incrs=q.incrs(n,S,T,F,O,lt);K=WM(T,F,pt,O,lt)}return q._found=K}function _n(S,T,F,O,q,K,lt,pt,Mt,Nt){let Dt=lt%2/2;y==1&&h.translate(Dt,Dt),Rt(pt,lt,Mt,Nt,pt),h.beginPath();let Ut,ae,Ee,Me,ye=q+(O==0||O==3?-K:K);F==0?(ae=q,Me=ye):(Ut=q,Ee=ye);for(let Qt=0;Qt<S.length;Qt++)T[Qt]!=null&&(F==0?Ut=Ee=S[Qt]:ae=Me=S[Qt],h.moveTo(Ut,ae),h.lineTo(Ee,Me));h.stroke(),y==1&&h.translate(-Dt,-Dt)}function co(S){let T=!0;return _.forEach((F,O)=>{if(!F.show)return;let q=v[F.scale];if(q.min==null){F._show&&(T=!1,F._show=!1,de(!1));return}else F._show||(T=!1,F._show=!0,de(!1));let K=F.side,lt=K%2,{min:pt,max:Mt}=q,[Nt,Dt]=Cr(O,pt,Mt,lt==0?k:xt);if(Dt==0)return;let Ut=q.distr==2,ae=F._splits=F.splits(n,O,pt,Mt,Nt,Dt,Ut),Ee=q.distr==2?ae.map(qt=>mi[qt]):ae,Me=q.distr==2?mi[ae[1]]-mi[ae[0]]:Nt,ye=F._values=F.values(n,F.filter(n,Ee,O,Dt,Me),O,Dt,Me);F._rotate=K==2?F.rotate(n,ye,O,Dt):0;let Qt=F._size;F._size=Fi(F.size(n,ye,O,S)),Qt!=null&&F._size!=Qt&&(T=!1)}),T}function cr(S){let T=!0;return va.forEach((F,O)=>{let q=F(n,O,ar,S);q!=Hi[O]&&(T=!1),Hi[O]=q}),T}function Pr(){for(let S=0;S<_.length;S++){let T=_[S];if(!T.show||!T._show)continue;let F=T.side,O=F%2,q,K,lt=T.stroke(n,S),pt=F==0||F==3?-1:1,[Mt,Nt]=T._found;if(T.label!=null){let ei=T.labelGap*pt,xi=Tn((T._lpos+ei)*Te);Lt(T.labelFont[0],lt,"center",F==2?"top":jm),h.save(),O==1?(q=K=0,h.translate(xi,Tn(E+ft/2)),h.rotate((F==3?-sc:sc)/2)):(q=Tn(L+Y/2),K=xi);let Is=kg(T.label)?T.label(n,S,Mt,Nt):T.label;h.fillText(Is,q,K),h.restore()}if(Nt==0)continue;let Dt=v[T.scale],Ut=O==0?Y:ft,ae=O==0?L:E,Ee=T._splits,Me=Dt.distr==2?Ee.map(ei=>mi[ei]):Ee,ye=Dt.distr==2?mi[Ee[1]]-mi[Ee[0]]:Mt,Qt=T.ticks,qt=T.border,tn=Qt.show?Qt.size:0,pn=Tn(tn*Te),Dn=Tn((T.alignTo==2?T._size-tn-T.gap:T.gap)*Te),ke=T._rotate*-sc/180,mn=g(T._pos*Te),gi=(pn+Dn)*pt,ti=mn+gi;K=O==0?ti:0,q=O==1?ti:0;let Pi=T.font[0],Wi=T.align==1?xo:T.align==2?bf:ke>0?xo:ke<0?bf:O==0?"center":F==3?bf:xo,fr=ke||O==1?"middle":F==2?"top":jm;Lt(Pi,lt,Wi,fr);let yi=T.font[1]*T.lineGap,Ii=Ee.map(ei=>g(a(ei,Dt,Ut,ae))),qi=T._values;for(let ei=0;ei<qi.length;ei++){let xi=qi[ei];if(xi!=null){O==0?q=Ii[ei]:K=Ii[ei],xi=""+xi;let Is=xi.indexOf(`
`)==-1?[xi]:xi.split(/\n/gm);for(let ni=0;ni<Is.length;ni++){let Hm=Is[ni];ke?(h.save(),h.translate(q,K+ni*yi),h.rotate(ke),h.fillText(Hm,0,0),h.restore()):h.fillText(Hm,q,K+ni*yi)}}}Qt.show&&_n(Ii,Qt.filter(n,Me,S,Nt,ye),O,F,mn,pn,qe(Qt.width*Te,3),Qt.stroke(n,S),Qt.dash,Qt.cap);let dr=T.grid;dr.show&&_n(Ii,dr.filter(n,Me,S,Nt,ye),O,O==0?2:1,O==0?E:L,O==0?ft:Y,qe(dr.width*Te,3),dr.stroke(n,S),dr.dash,dr.cap),qt.show&&_n([mn],[1],O==0?1:0,O==0?1:2,O==1?E:L,O==1?ft:Y,qe(qt.width*Te,3),qt.stroke(n,S),qt.dash,qt.cap)}Nn("drawAxes")}function de(S){x.forEach((T,F)=>{F>0&&(T._paths=null,S&&(r==1?(T.min=null,T.max=null):T.facets.forEach(O=>{O.min=null,O.max=null})))})}let dn=!1,Qn=!1,Oe=[];function bn(){Qn=!1;for(let S=0;S<Oe.length;S++)Nn(...Oe[S]);Oe.length=0}function Yn(){dn||(Uw(Am),dn=!0)}function Zl(S,T=!1){dn=!0,Qn=T,S(n),Am(),T&&Oe.length>0&&queueMicrotask(bn)}n.batch=Zl;function Am(){if(at&&(me(),at=!1),wt&&(Et(),wt=!1),_t){if(en(d,xo,Xt),en(d,"top",ce),en(d,Ta,k),en(d,Ra,xt),en(m,xo,Xt),en(m,"top",ce),en(m,Ta,k),en(m,Ra,xt),en(f,Ta,Ze),en(f,Ra,an),u.width=Tn(Ze*Te),u.height=Tn(an*Te),_.forEach(({_el:S,_show:T,_size:F,_pos:O,side:q})=>{if(S!=null)if(T){let K=q===3||q===0?F:0,lt=q%2==1;en(S,lt?"left":"top",O-K),en(S,lt?"width":"height",F),en(S,lt?"top":"left",lt?ce:Xt),en(S,lt?"height":"width",lt?xt:k),Pf(S,Ns)}else vi(S,Ns)}),ao=Zr=lo=W=Q=j=Z=Tt=R=null,It=1,Sa(!0),Xt!=At||ce!=He||k!=Ht||xt!=Yt){de(!1);let S=k/Ht,T=xt/Yt;if(dt&&!nt&&ct.left>=0){ct.left*=S,ct.top*=T,uo&&pr(uo,Tn(ct.left),0,k,xt),ho&&pr(ho,0,Tn(ct.top),k,xt);for(let F=0;F<fe.length;F++){let O=fe[F];O!=null&&(Ke[F]*=S,Jn[F]*=T,pr(O,Fi(Ke[F]),Fi(Jn[F]),k,xt))}}if(Qe.show&&!st&&Qe.left>=0&&Qe.width>0){Qe.left*=S,Qe.width*=S,Qe.top*=T,Qe.height*=T;for(let F in yf)en(mo,F,Qe[F])}At=Xt,He=ce,Ht=k,Yt=xt}Nn("setSize"),_t=!1}Ze>0&&an>0&&(h.clearRect(0,0,u.width,u.height),Nn("drawClear"),w.forEach(S=>S()),Nn("draw")),Qe.show&&st&&(Kl(Qe),st=!1),dt&&nt&&(Ps(null,!0,!1),nt=!1),ht.show&&ht.live&&mt&&(mf(),mt=!1),l||(l=!0,n.status=1,Nn("ready")),jr=!1,dn=!1}n.redraw=(S,T)=>{wt=T||!1,S!==!1?Jr(A,I.min,I.max):Yn()};function ff(S,T){let F=v[S];if(F.from==null){if(fn==0){let O=F.range(n,T.min,T.max,S);T.min=O[0],T.max=O[1]}if(T.min>T.max){let O=T.min;T.min=T.max,T.max=O}if(fn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;S==A&&F.distr==2&&fn>0&&(T.min=Xi(T.min,t[0]),T.max=Xi(T.max,t[0]),T.min==T.max&&T.max++),D[S]=T,at=!0,Yn()}}n.setScale=ff;let df,pf,uo,ho,Em,Tm,fo,po,Rm,Cm,Je,rn,Kr=!1,Vn=ct.drag,Ln=Vn.x,Fn=Vn.y;dt&&(ct.x&&(df=Li(aw,m)),ct.y&&(pf=Li(lw,m)),I.ori==0?(uo=df,ho=pf):(uo=pf,ho=df),Je=ct.left,rn=ct.top);let Qe=n.select=Mn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),mo=Qe.show?Li(ow,Qe.over?m:d):null;function Kl(S,T){if(Qe.show){for(let F in S)Qe[F]=S[F],F in yf&&en(mo,F,S[F]);T!==!1&&Nn("setSelect")}}n.setSelect=Kl;function Db(S){if(x[S].show)J&&Pf(Kt[S],Ns);else if(J&&vi(Kt[S],Ns),dt){let F=Ct?fe[0]:fe[S];F!=null&&pr(F,-10,-10,k,xt)}}function Jr(S,T,F){ff(S,{min:T,max:F})}function ur(S,T,F,O){T.focus!=null&&zb(S),T.show!=null&&x.forEach((q,K)=>{K>0&&(S==K||S==null)&&(q.show=T.show,Db(K),r==2?(Jr(q.facets[0].scale,null,null),Jr(q.facets[1].scale,null,null)):Jr(q.scale,null,null),Yn())}),F!==!1&&Nn("setSeries",S,T),O&&Aa("setSeries",n,S,T)}n.setSeries=ur;function Ob(S,T){Mn(M[S],T)}function Ub(S,T){S.fill=_e(S.fill||null),S.dir=Se(S.dir,-1),T=T??M.length,M.splice(T,0,S)}function kb(S){S==null?M.length=0:M.splice(S,1)}n.addBand=Ub,n.setBand=Ob,n.delBand=kb;function Bb(S,T){x[S].alpha=T,dt&&fe[S]!=null&&(fe[S].style.opacity=T),J&&Kt[S]&&(Kt[S].style.opacity=T)}let Ir,Qr,Cs,go={focus:!0};function zb(S){if(S!=Cs){let T=S==null,F=kt.alpha!=1;x.forEach((O,q)=>{if(r==1||q>0){let K=T||q==0||q==S;O._focus=T?null:K,F&&Bb(q,K?1:kt.alpha)}}),Cs=S,F&&Yn()}}J&&ne&&te(Qm,bt,S=>{ct._lock||(ee(S),Cs!=null&&ur(null,go,!0,wn.setSeries))});function hr(S,T,F){let O=v[T];F&&(S=S/Te-(O.ori==1?ce:Xt));let q=k;O.ori==1&&(q=xt,S=q-S),O.dir==-1&&(S=q-S);let K=O._min,lt=O._max,pt=S/q,Mt=K+(lt-K)*pt,Nt=O.distr;return Nt==3?bo(10,Mt):Nt==4?Aw(Mt,O.asinh):Nt==100?O.bwd(Mt):Mt}function Vb(S,T){let F=hr(S,A,T);return Xi(F,t[0],yn,xn)}n.valToIdx=S=>Xi(S,t[0]),n.posToIdx=Vb,n.posToVal=hr,n.valToPos=(S,T,F)=>v[T].ori==0?s(S,v[T],F?Y:k,F?L:0):o(S,v[T],F?ft:xt,F?E:0),n.setCursor=(S,T,F)=>{Je=S.left,rn=S.top,Ps(null,T,F)};function Pm(S,T){en(mo,xo,Qe.left=S),en(mo,Ta,Qe.width=T)}function Im(S,T){en(mo,"top",Qe.top=S),en(mo,Ra,Qe.height=T)}let wa=I.ori==0?Pm:Im,Ma=I.ori==1?Pm:Im;function Gb(){if(J&&ht.live)for(let S=r==2?1:0;S<x.length;S++){if(S==0&&oe)continue;let T=ht.values[S],F=0;for(let O in T)zt[S][F++].firstChild.nodeValue=T[O]}}function mf(S,T){if(S!=null&&(S.idxs?S.idxs.forEach((F,O)=>{tt[O]=F}):Cw(S.idx)||tt.fill(S.idx),ht.idx=tt[0]),J&&ht.live){for(let F=0;F<x.length;F++)(F>0||r==1&&!oe)&&Hb(F,tt[F]);Gb()}mt=!1,T!==!1&&Nn("setLegend")}n.setLegend=mf;function Hb(S,T){let F=x[S],O=S==0&&U==2?mi:t[S],q;oe?q=F.values(n,S,T)??Jt:(q=F.value(n,T==null?null:O[T],S,T),q=q==null?Jt:{_:q}),ht.values[S]=q}function Ps(S,T,F){Rm=Je,Cm=rn,[Je,rn]=ct.move(n,Je,rn),ct.left=Je,ct.top=rn,dt&&(uo&&pr(uo,Tn(Je),0,k,xt),ho&&pr(ho,0,Tn(rn),k,xt));let O,q=yn>xn;Ir=We,Qr=null;let K=I.ori==0?k:xt,lt=I.ori==1?k:xt;if(Je<0||fn==0||q){O=ct.idx=null;for(let pt=0;pt<x.length;pt++){let Mt=fe[pt];Mt!=null&&pr(Mt,-10,-10,k,xt)}ne&&ur(null,go,!0,S==null&&wn.setSeries),ht.live&&(tt.fill(O),mt=!0)}else{let pt,Mt,Nt;r==1&&(pt=I.ori==0?Je:rn,Mt=hr(pt,A),O=ct.idx=Xi(Mt,t[0],yn,xn),Nt=V(t[0][O],I,K,0));let Dt=-10,Ut=-10,ae=0,Ee=0,Me=!0,ye="",Qt="";for(let qt=r==2?1:0;qt<x.length;qt++){let tn=x[qt],pn=tt[qt],Dn=pn==null?null:r==1?t[qt][pn]:t[qt][1][pn],ke=ct.dataIdx(n,qt,O,Mt),mn=ke==null?null:r==1?t[qt][ke]:t[qt][1][ke];if(mt=mt||mn!=Dn||ke!=pn,tt[qt]=ke,qt>0&&tn.show){let gi=ke==null?-10:ke==O?Nt:V(r==1?t[0][ke]:t[qt][0][ke],I,K,0),ti=mn==null?-10:C(mn,r==1?v[tn.scale]:v[tn.facets[1].scale],lt,0);if(ne&&mn!=null){let Pi=I.ori==1?Je:rn,Wi=Rn(kt.dist(n,qt,ke,ti,Pi));if(Wi<Ir){let fr=kt.bias;if(fr!=0){let yi=hr(Pi,tn.scale),Ii=mn>=0?1:-1,qi=yi>=0?1:-1;qi==Ii&&(qi==1?fr==1?mn>=yi:mn<=yi:fr==1?mn<=yi:mn>=yi)&&(Ir=Wi,Qr=qt)}else Ir=Wi,Qr=qt}}if(mt||Ct){let Pi,Wi;I.ori==0?(Pi=gi,Wi=ti):(Pi=ti,Wi=gi);let fr,yi,Ii,qi,dr,ei,xi=!0,Is=ut.bbox;if(Is!=null){xi=!1;let ni=Is(n,qt);Ii=ni.left,qi=ni.top,fr=ni.width,yi=ni.height}else Ii=Pi,qi=Wi,fr=yi=ut.size(n,qt);if(ei=ut.fill(n,qt),dr=ut.stroke(n,qt),Ct)qt==Qr&&Ir<=kt.prox&&(Dt=Ii,Ut=qi,ae=fr,Ee=yi,Me=xi,ye=ei,Qt=dr);else{let ni=fe[qt];ni!=null&&(Ke[qt]=Ii,Jn[qt]=qi,og(ni,fr,yi,xi),rg(ni,ei,dr),pr(ni,Fi(Ii),Fi(qi),k,xt))}}}}if(Ct){let qt=kt.prox,tn=Cs==null?Ir<=qt:Ir>qt||Qr!=Cs;if(mt||tn){let pn=fe[0];pn!=null&&(Ke[0]=Dt,Jn[0]=Ut,og(pn,ae,Ee,Me),rg(pn,ye,Qt),pr(pn,Fi(Dt),Fi(Ut),k,xt))}}}if(Qe.show&&Kr)if(S!=null){let[pt,Mt]=wn.scales,[Nt,Dt]=wn.match,[Ut,ae]=S.cursor.sync.scales,Ee=S.cursor.drag;if(Ln=Ee._x,Fn=Ee._y,Ln||Fn){let{left:Me,top:ye,width:Qt,height:qt}=S.select,tn=S.scales[Ut].ori,pn=S.posToVal,Dn,ke,mn,gi,ti,Pi=pt!=null&&Nt(pt,Ut),Wi=Mt!=null&&Dt(Mt,ae);Pi&&Ln?(tn==0?(Dn=Me,ke=Qt):(Dn=ye,ke=qt),mn=v[pt],gi=V(pn(Dn,Ut),mn,K,0),ti=V(pn(Dn+ke,Ut),mn,K,0),wa(Yi(gi,ti),Rn(ti-gi))):wa(0,K),Wi&&Fn?(tn==1?(Dn=Me,ke=Qt):(Dn=ye,ke=qt),mn=v[Mt],gi=C(pn(Dn,ae),mn,lt,0),ti=C(pn(Dn+ke,ae),mn,lt,0),Ma(Yi(gi,ti),Rn(ti-gi))):Ma(0,lt)}else xf()}else{let pt=Rn(Rm-Em),Mt=Rn(Cm-Tm);if(I.ori==1){let ae=pt;pt=Mt,Mt=ae}Ln=Vn.x&&pt>=Vn.dist,Fn=Vn.y&&Mt>=Vn.dist;let Nt=Vn.uni;Nt!=null?Ln&&Fn&&(Ln=pt>=Nt,Fn=Mt>=Nt,!Ln&&!Fn&&(Mt>pt?Fn=!0:Ln=!0)):Vn.x&&Vn.y&&(Ln||Fn)&&(Ln=Fn=!0);let Dt,Ut;Ln&&(I.ori==0?(Dt=fo,Ut=Je):(Dt=po,Ut=rn),wa(Yi(Dt,Ut),Rn(Ut-Dt)),Fn||Ma(0,lt)),Fn&&(I.ori==1?(Dt=fo,Ut=Je):(Dt=po,Ut=rn),Ma(Yi(Dt,Ut),Rn(Ut-Dt)),Ln||wa(0,K)),!Ln&&!Fn&&(wa(0,0),Ma(0,0))}if(Vn._x=Ln,Vn._y=Fn,S==null){if(F){if(Gm!=null){let[pt,Mt]=wn.scales;wn.values[0]=pt!=null?hr(I.ori==0?Je:rn,pt):null,wn.values[1]=Mt!=null?hr(I.ori==1?Je:rn,Mt):null}Aa(wf,n,Je,rn,k,xt,O)}if(ne){let pt=F&&wn.setSeries,Mt=kt.prox;Cs==null?Ir<=Mt&&ur(Qr,go,!0,pt):Ir>Mt?ur(null,go,!0,pt):Qr!=Cs&&ur(Qr,go,!0,pt)}}mt&&(ht.idx=O,mf()),T!==!1&&Nn("setCursor")}let ts=null;Object.defineProperty(n,"rect",{get(){return ts==null&&Sa(!1),ts}});function Sa(S=!1){S?ts=null:(ts=m.getBoundingClientRect(),Nn("syncRect",ts))}function Lm(S,T,F,O,q,K,lt){ct._lock||Kr&&S!=null&&S.movementX==0&&S.movementY==0||(gf(S,T,F,O,q,K,lt,!1,S!=null),S!=null?Ps(null,!0,!0):Ps(T,!0,!1))}function gf(S,T,F,O,q,K,lt,pt,Mt){if(ts==null&&Sa(!1),ee(S),S!=null)F=S.clientX-ts.left,O=S.clientY-ts.top;else{if(F<0||O<0){Je=-10,rn=-10;return}let[Nt,Dt]=wn.scales,Ut=T.cursor.sync,[ae,Ee]=Ut.values,[Me,ye]=Ut.scales,[Qt,qt]=wn.match,tn=T.axes[0].side%2==1,pn=I.ori==0?k:xt,Dn=I.ori==1?k:xt,ke=tn?K:q,mn=tn?q:K,gi=tn?O:F,ti=tn?F:O;if(Me!=null?F=Qt(Nt,Me)?a(ae,v[Nt],pn,0):-10:F=pn*(gi/ke),ye!=null?O=qt(Dt,ye)?a(Ee,v[Dt],Dn,0):-10:O=Dn*(ti/mn),I.ori==1){let Pi=F;F=O,O=Pi}}Mt&&(T==null||T.cursor.event.type==wf)&&((F<=1||F>=k-1)&&(F=Ls(F,k)),(O<=1||O>=xt-1)&&(O=Ls(O,xt))),pt?(Em=F,Tm=O,[fo,po]=ct.move(n,F,O)):(Je=F,rn=O)}let yf={width:0,height:0,left:0,top:0};function xf(){Kl(yf,!1)}let Fm,Nm,Dm,Om;function Um(S,T,F,O,q,K,lt){Kr=!0,Ln=Fn=Vn._x=Vn._y=!1,gf(S,T,F,O,q,K,lt,!0,!1),S!=null&&(te(Mf,Rf,km,!1),Aa(Km,n,fo,po,k,xt,null));let{left:pt,top:Mt,width:Nt,height:Dt}=Qe;Fm=pt,Nm=Mt,Dm=Nt,Om=Dt}function km(S,T,F,O,q,K,lt){Kr=Vn._x=Vn._y=!1,gf(S,T,F,O,q,K,lt,!1,!0);let{left:pt,top:Mt,width:Nt,height:Dt}=Qe,Ut=Nt>0||Dt>0,ae=Fm!=pt||Nm!=Mt||Dm!=Nt||Om!=Dt;if(Ut&&ae&&Kl(Qe),Vn.setScale&&Ut&&ae){let Ee=pt,Me=Nt,ye=Mt,Qt=Dt;if(I.ori==1&&(Ee=Mt,Me=Dt,ye=pt,Qt=Nt),Ln&&Jr(A,hr(Ee,A),hr(Ee+Me,A)),Fn)for(let qt in v){let tn=v[qt];qt!=A&&tn.from==null&&tn.min!=We&&Jr(qt,hr(ye+Qt,qt),hr(ye,qt))}xf()}else ct.lock&&(ct._lock=!ct._lock,Ps(T,!0,S!=null));S!=null&&(je(Mf,Rf),Aa(Mf,n,Je,rn,k,xt,null))}function Wb(S,T,F,O,q,K,lt){if(ct._lock)return;ee(S);let pt=Kr;if(Kr){let Mt=!0,Nt=!0,Dt=10,Ut,ae;I.ori==0?(Ut=Ln,ae=Fn):(Ut=Fn,ae=Ln),Ut&&ae&&(Mt=Je<=Dt||Je>=k-Dt,Nt=rn<=Dt||rn>=xt-Dt),Ut&&Mt&&(Je=Je<fo?0:k),ae&&Nt&&(rn=rn<po?0:xt),Ps(null,!0,!0),Kr=!1}Je=-10,rn=-10,tt.fill(null),Ps(null,!0,!0),pt&&(Kr=pt)}function Bm(S,T,F,O,q,K,lt){ct._lock||(ee(S),ba(),xf(),S!=null&&Aa(tg,n,Je,rn,k,xt,null))}function zm(){_.forEach(qM),B(n.width,n.height,!0)}Ds(oc,_o,zm);let yo={};yo.mousedown=Um,yo.mousemove=Lm,yo.mouseup=km,yo.dblclick=Bm,yo.setSeries=(S,T,F,O)=>{let q=wn.match[2];F=q(n,T,F),F!=-1&&ur(F,O,!0,!1)},dt&&(te(Km,m,Um),te(wf,m,Lm),te(Jm,m,S=>{ee(S),Sa(!1)}),te(Qm,m,Wb),te(tg,m,Bm),Of.add(n),n.syncRect=Sa);let Jl=n.hooks=i.hooks||{};function Nn(S,T,F){Qn?Oe.push([S,T,F]):S in Jl&&Jl[S].forEach(O=>{O.call(null,n,T,F)})}(i.plugins||[]).forEach(S=>{for(let T in S.hooks)Jl[T]=(Jl[T]||[]).concat(S.hooks[T])});let Vm=(S,T,F)=>F,wn=Mn({key:null,setSeries:!1,filters:{pub:hg,sub:hg},scales:[A,x[1]?x[1].scale:null],match:[fg,fg,Vm],values:[null,null]},ct.sync);wn.match.length==2&&wn.match.push(Vm),ct.sync=wn;let Gm=wn.key,vf=l0(Gm);function Aa(S,T,F,O,q,K,lt){wn.filters.pub(S,T,F,O,q,K,lt)&&vf.pub(S,T,F,O,q,K,lt)}vf.sub(n);function qb(S,T,F,O,q,K,lt){wn.filters.sub(S,T,F,O,q,K,lt)&&yo[S](null,T,F,O,q,K,lt)}n.pub=qb;function $b(){vf.unsub(n),Of.delete(n),xe.clear(),If(oc,_o,zm),c.remove(),bt?.remove(),Nn("destroy")}n.destroy=$b;function _f(){Nn("init",i,t),_a(t||i.data,!1),D[A]?ff(A,D[A]):ba(),st=Qe.show&&(Qe.width>0||Qe.height>0),nt=mt=!0,B(i.width,i.height)}return x.forEach(oo),_.forEach(Tr),e?e instanceof HTMLElement?(e.appendChild(c),_f()):e(n,_f):_f(),n}cn.assign=Mn;cn.fmtNum=Hf;cn.rangeNum=ac;cn.rangeLog=uc;cn.rangeAsinh=Vf;cn.orient=Us;cn.pxRatio=Te;cn.join=Ow;cn.fmtDate=qf,cn.tzDate=Xw;cn.sync=l0;{cn.addGap=CM,cn.clipGaps=dc;let i=cn.paths={points:p0};i.linear=g0,i.stepped=LM,i.bars=FM,i.spline=DM}var _0=["--blue","--red","--green","--violet","--ochre","--sky"],$M={real:"--blue",reference:"--red",rigid:"--quiet",stationary:"--green",oscillatory:"--violet",limit:"--quiet",other:"--ochre"},b0={real:[],reference:[6,3],rigid:[2,3],stationary:[9,2,2,2],oscillatory:[2,2],limit:[1,3],other:[10,3]},w0=[[],[7,2],[6,2,2,2],[2,2],[9,2,2,2,2,2],[12,4]],is={real:"actual",reference:"nominal",rigid:"rigid",stationary:"quasi-static part",oscillatory:"oscillatory part",limit:"limit",other:"other"};function Fa(i,t,e,n){if(!e)return{property:$M[i],dash:b0[i]};let r=n>1?b0[i]:w0[t%w0.length];return{property:_0[t%_0.length],dash:r}}var Jf=new Map,M0=null,S0=!1;function gn(i){M0??=matchMedia("(prefers-color-scheme: dark)");let t=M0.matches&&!document.documentElement.classList.contains("printing");t!==S0&&Jf.clear(),S0=t;let e=Jf.get(i)??getComputedStyle(document.documentElement).getPropertyValue(i).trim();return Jf.set(i,e),e||"#808080"}function Na({data:i,shape:[,t]},e,n){let[r,s,o]=[0,0,0];for(let c=3*t*e;c<3*t*(e+1);c+=3)r+=i[c],s+=i[c+1],o+=i[c+2];let a=Math.hypot(r,s,o);if(n<0||a===0)return a;let l=3*(t*e+n);return(r*i[l]+s*i[l+1]+o*i[l+2])/a}function A0(i,t,e,n){let[r,s]=n??e.span??[i[0],i[i.length-1]],o=1e-9*Math.max(1,Math.abs(s)),a=XM(i,Array.from(i.keys()).filter(p=>i[p]>=r-o&&i[p]<=s+o)),l=Float64Array.from(a,p=>t[p]),c=l.length;if(c<4)return{x:new Float64Array,y:new Float64Array};let u=(i[a[c-1]]-i[a[0]])/(c-1),h=YM(l),f=2**Math.ceil(Math.log2(4*c)),d=new Float64Array(f),m=new Float64Array(f);d.set(l),jM(d,m);let y=e.at.data[e.at.data.length-1],g=Math.min(f/2,Math.floor(y*f*u)+1);return{x:Float64Array.from({length:g},(p,x)=>x/(f*u)),y:Float64Array.from({length:g},(p,x)=>2*Math.hypot(d[x],m[x])/h)}}function XM(i,t){if(t.length<3)return t;let e=r=>i[t[r]]-i[t[r-1]];return Math.abs(e(t.length-1)/e(1)-1)>1e-6?t.slice(0,-1):t}function YM(i){let t=i.length,e=(t-1)/2,n=i.reduce((a,l)=>a+l,0)/t,r=t*(t*t-1)/12,s=i.reduce((a,l,c)=>a+(c-e)*l,0)/r,o=0;for(let a=0;a<t;a+=1){let l=.5-.5*Math.cos(2*Math.PI*a/t);i[a]=l*(i[a]-n-s*(a-e)),o+=l}return o}function jM(i,t){let e=i.length;for(let r=1,s=0;r<e;r+=1){let o=e>>1;for(;s&o;o>>=1)s^=o;s^=o,r<s&&([i[r],i[s]]=[i[s],i[r]],[t[r],t[s]]=[t[s],t[r]])}let n=ZM(e);for(let r=2;r<=e;r*=2)KM(i,t,r,n)}var Ro=new Float64Array;function ZM(i){if(Ro.length===i)return Ro;Ro=new Float64Array(i);for(let t=0;t<i/2;t+=1)Ro[2*t]=Math.cos(2*Math.PI*t/i),Ro[2*t+1]=-Math.sin(2*Math.PI*t/i);return Ro}function KM(i,t,e,n){let r=e/2,s=2*i.length/e;for(let o=0;o<i.length;o+=e)for(let a=0;a<r;a+=1){let l=o+a,c=l+r,u=n[s*a],h=n[s*a+1],f=i[c]*u-t[c]*h,d=i[c]*h+t[c]*u;i[c]=i[l]-f,t[c]=t[l]-d,i[l]+=f,t[l]+=d}}function R0(i){let t=new Map;return i.runs.forEach((e,n)=>e.charts.forEach(r=>{let s=t.get(r.id);s?s.runs.push({run:n,name:e.name,chart:r}):t.set(r.id,{chart:r,runs:[{run:n,name:e.name,chart:r}],compared:i.runs.length>1})})),[...t.values()]}function Qf(i,t){let e=i.runs.flatMap(({run:s,name:o,chart:a})=>(t&&s===0&&a.stacked?a.curves.slice(-1):a.curves).map(l=>({run:s,runName:o,label:l.label,role:l.role,x:a.at.data,y:l.values.data,shown:l.shown&&(i.runs.length<2||JM(l,a)),ghost:t!==null&&s===0})));if(t===null)return e;let n=i.runs.find(({run:s})=>s===0),r=(n?.chart.curves??[]).flatMap(s=>QM(s,n.chart,n.name,t));return[...e,...r]}function JM(i,t){return i.role==="real"&&i.label===t.curves[0].label}function QM(i,t,e,n){let r=tS(i,n);if(r===null)return[];let s={run:0,runName:e,label:i.label,role:i.role,shown:i.shown,ghost:!1};if(t.abscissa==="time")return[{...s,x:n.times,y:r}];let o=null,a=()=>o??=A0(n.times,r,t,n.span);return[Object.defineProperties(s,{x:{get:()=>a().x},y:{get:()=>a().y}})]}function C0(i,t,e){return i.chart.group==="spectrum"&&t.vibration!==e.vibration?!1:i.runs.flatMap(({chart:r})=>r.curves.flatMap(({source:s})=>s?[s.variable,s.less?.variable??s.variable]:[])).every(r=>t.series[r]===e.series[r])}function tS(i,t){let e=i.source;if(e===null)return null;let n=E0(t,e.variable,e.index,e.along),r=e.less?E0(t,e.less.variable,e.less.index):null;if(n===null||e.less&&r===null)return null;for(let s=0;s<n.length;s+=1)n[s]=e.factor*(n[s]-(r?r[s]:0));return n}function E0(i,t,e,n=!1){let r=i.series[t];if(r===void 0)return null;if(n)return Float64Array.from(i.times,(a,l)=>Na(r,l,e));let s=r.shape.slice(1).reduce((a,l)=>a*l,1);if(e>=s)return null;let o=new Float64Array(r.shape[0]);for(let a=0;a<o.length;a+=1)o[a]=r.data[a*s+e];return o}function yc(i,t){let e=[...new Set(i.map(r=>r.x))],n=e.every(r=>P0(r,e[0]))?e[0]:eS(e);return[n,...i.map(r=>nS(r,n,t))]}function P0(i,t){if(i===t)return!0;if(i.length!==t.length)return!1;for(let e=0;e<i.length;e+=1)if(Math.abs(i[e]-t[e])>1e-6*Math.abs(t[e]))return!1;return!0}function eS(i){let t=i.flatMap(e=>Array.from(e)).sort((e,n)=>e-n);return t.filter((e,n)=>n===0||e>t[n-1])}function nS(i,t,e){let n=o=>e?o===0?null:Math.abs(o):o;if(t===i.x||P0(t,i.x))return e?Array.from(i.y,n):i.y;let s=new Array(t.length).fill(null);for(let o=0,a=0;o<i.x.length;o+=1){for(;a<t.length&&t[a]<i.x[o];)a+=1;a<t.length&&(s[a]=n(i.y[o]))}return s}function I0(i,t){let{x:e,y:n}=i,r=e.length-1;if(r<0||t<e[0]-1e-9||t>e[r]+1e-6*Math.abs(e[r])+1e-9)return null;let s=0,o=r;for(;o-s>1;){let a=s+o>>1;e[a]<=t?s=a:o=a}return o===s||t>=e[o]?n[o]:n[s]+(n[o]-n[s])*(t-e[s])/(e[o]-e[s])}var T0=new WeakMap;function Co(i){let t=T0.get(i);if(t)return t;let[e,n]=[1/0,-1/0];for(let s=0;s<i.length;s+=1){let o=i[s];Number.isFinite(o)&&(o<e&&(e=o),o>n&&(n=o))}let r=e<=n?[e,n]:[0,0];return T0.set(i,r),r}function L0(i,t,e){let[n,...r]=yc(i,!1),s=new Set(i.map(l=>l.run)).size>1,o=i.map(l=>`${[s?l.runName:"",l.label,is[l.role],l.ghost?"original":""].filter(Boolean).join(" ")} [${e||"-"}]`),a=Array.from(n,(l,c)=>[l,...r.map(u=>u[c]??"")].map(iS).join(","));return`${[t,...o].map(rS).join(",")}
${a.join(`
`)}
`}function iS(i){return typeof i=="string"?i:String(Number(i.toPrecision(9)))}function rS(i){return`"${(/^[=+\-@\t\r]/.test(i)?`'${i}`:i).replaceAll('"','""')}"`}var[xc,Po]=[18,12];function F0(i,t,e,n){let r=td(n),s=document.createElement("canvas"),[o,a]=[i.width/t,i.height/t];s.width=i.width,s.height=i.height+t*xc*(r.length+2);let l=s.getContext("2d");return l&&(l.fillStyle=gn("--paper"),l.fillRect(0,0,s.width,s.height),l.drawImage(i,0,t*1.5*xc),l.scale(t,t),l.fillStyle=gn("--ink"),l.font="600 14px system-ui, sans-serif",l.fillText(e,Po,xc,o-2*Po),l.font="12px system-ui, sans-serif",r.forEach(({words:c,look:u},h)=>{let f=a+xc*(h+2);l.strokeStyle=gn(u.property),l.lineWidth=2,l.setLineDash(u.dash),l.beginPath(),l.moveTo(Po,f-4),l.lineTo(Po+26,f-4),l.stroke(),l.fillText(c,Po+34,f,o-Po-40)})),s}function td(i){let t=new Set;return i.filter(([{ghost:e}])=>!e).flatMap(([e,n])=>{let r=e.role==="real"?e.label:`${e.label}, ${is[e.role]}`;return t.size<t.add(r).size?[{words:r,look:n}]:[]})}var[vc,ed,N0]=[18,12,28],sS=2;function D0({plot:i,titled:t,marks:e,looks:n,pieces:r,abscissa:s},o){let[a,l]=[i.width,i.height],c=td(n),u={left:i.bbox.left/o,top:i.bbox.top/o+1.5*vc,width:i.bbox.width/o,height:i.bbox.height/o},[h,f]=[u.left+u.width,u.top+u.height],d=M=>u.left+i.valToPos(M,"x"),m=M=>u.top+i.valToPos(M,"y"),y=l+vc*(c.length+2),g=[Da(ed,vc,t,"--ink",'font-weight="600" font-size="14"')],[p,x]=i.axes.map(oS);for(let[M,A]of p)d(M)<u.left-1||d(M)>h+1||(g.push(Oa(`M${Ve(d(M))} ${Ve(u.top)}V${Ve(f+4)}`,"--grid")),g.push(Da(d(M),f+17,A,"--quiet",'text-anchor="middle"')));for(let[M,A]of x)m(M)<u.top-1||m(M)>f+1||(g.push(Oa(`M${Ve(u.left-4)} ${Ve(m(M))}H${Ve(h)}`,"--grid")),g.push(Da(u.left-7,m(M)+4,A,"--quiet",'text-anchor="end"')));g.push(Da((u.left+h)/2,f+35,s,"--quiet",'text-anchor="middle"'));let _=r.map((M,A)=>aS(i,A+1,d,m,M)),v=e.map(M=>Oa(`M${Ve(d(M.at))} ${Ve(u.top)}V${Ve(f)}`,"--quiet",[3,3]));return g.push(`<svg x="${Ve(u.left)}" y="${Ve(u.top)}" width="${Ve(u.width)}" height="${Ve(u.height)}" viewBox="${[u.left,u.top,u.width,u.height].map(Ve).join(" ")}">${_.join("")}${v.join("")}</svg>`),c.forEach(({words:M,look:A},b)=>{let w=l+vc*(b+2);g.push(Oa(`M${ed} ${w-4}h26`,A.property,A.dash,2)),g.push(Da(ed+34,w,M,"--ink"))}),{width:a,height:y,content:g.join(`
`)}}function O0(i){let t=Math.min(2,i.length),e=Math.max(...i.map(({width:s})=>s))+N0,n=0,r=[];for(let s=0;s<i.length;s+=t){let o=i.slice(s,s+t);o.forEach((a,l)=>r.push(`<g transform="translate(${Ve(l*e)} ${Ve(n)})">${a.content}</g>`)),n+=Math.max(...o.map(({height:a})=>a))+(i.length>t?N0:0)}return`<svg xmlns="http://www.w3.org/2000/svg" width="${Ve(t*e)}" height="${Ve(n)}" viewBox="0 0 ${Ve(t*e)} ${Ve(n)}" font-family="system-ui, sans-serif" font-size="12">
<rect width="100%" height="100%" fill="${gn("--paper")}"/>
${r.join(`
`)}
</svg>
`}function oS(i){let{_splits:t,_values:e}=i;return(t??[]).flatMap((n,r)=>e?.[r]?[[n,e[r]]]:[])}function aS(i,t,e,n,r){let[s,o]=[i.data[0],i.data[t]],{min:a=-1/0,max:l=1/0}=i.scales.x,c=[],[u,h]=[0,0];for(let m=0;m<s.length;m+=1){let y=o[m],g=(s[m+1]??s[m])<a||(s[m-1]??s[m])>l;y==null||g||(h=e(s[m]),c.length||(u=h),c.push(`${Ve(h)} ${Ve(n(y))}`))}if(!c.length)return"";let f=`M${c.join("L")}`,d=r.ghost?' opacity="0.35"':"";return r.filled?`<path d="${f}L${Ve(h)} ${Ve(n(0))}L${Ve(u)} ${Ve(n(0))}Z" fill="${gn(r.property)}"/>`:`<g${d}>${Oa(f,r.property,r.dash,r.width)}</g>`}function Oa(i,t,e=[],n=1){let r=e.length?` stroke-dasharray="${e.join(" ")}"`:"";return`<path d="${i}" fill="none" stroke="${gn(t)}" stroke-width="${n}"${r}/>`}function Da(i,t,e,n,r=""){let s=e.replaceAll("&","&amp;").replaceAll("<","&lt;");return`<text x="${Ve(i)}" y="${Ve(t)}" fill="${gn(n)}" ${r}>${s}</text>`}function Ve(i){return String(Number(i.toFixed(sS)))}function U0(i){let t=(e,n,r)=>Be(e,()=>{let s=i();s&&setTimeout(()=>r(s))},{class:"tool",title:n});return[t("PNG","Save this chart as a picture",({plot:e,titled:n,looks:r,id:s})=>tc(F0(e.ctx.canvas,cn.pxRatio,n,r),s)),t("SVG","Save this chart as a vector graphic",e=>id([nd(e)],e.id)),t("CSV","Save the data of this chart as CSV",({looks:e,abscissa:n,unit:r,id:s})=>Fr(L0(e.map(([o])=>o),n,r),`${s}.csv`,"text/csv"))]}function nd(i){return D0(i,cn.pxRatio)}function id(i,t){i.length&&Fr(O0(i),`${t}.svg`,"image/svg+xml")}var lS=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],cS=["m","rad","s"],uS=["Hz","%","rad/s"],rd={m:[10,1e3,"mm"],rad:[1,1e3,"mrad"],s:[1,1,"s"]},hS="⁰¹²³⁴⁵⁶⁷⁸⁹";function sd(i){let t=i.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(t)?"":t}function Pe(i,t=4){return i===0?"0":String(Number(i.toPrecision(t)))}function k0(i){if(i===0)return"0";let[t,e]=i.toExponential(1).split("e"),n=[...String(Number(e))].map(r=>r==="-"?"⁻":hS[Number(r)]).join("");return`${t} × 10${n}`}function Ua(i,t){let e=sd(i);if(!e||uS.includes(i)||!(t>0))return{factor:1,name:e};let n=rd[i];if(n)return t<n[0]?{factor:n[1],name:n[2]}:{factor:1,name:e};let r=cS.includes(i.split("/")[0]),s=lS.find(([o,a])=>t>=o&&(a>=1||!r));return s?{factor:s[1],name:s[2]+e}:{factor:1,name:e}}function Gn(i,t){if(i===null||!Number.isFinite(i))return"–";let e=Math.abs(i),{factor:n,name:r}=Ua(t,e);return`${e>0&&(n===1||t in rd?e*n<.001:e<1e-11)?k0(t in rd?i*n:i):Pe(i*n)} ${r}`.trimEnd()}function ri(i){let t=Math.abs(i);return t!==0&&(t<.001||t>=1e6)?k0(i):Pe(i)}function _c(i){let t=0,e=window.requestIdleCallback??(s=>window.setTimeout(s)),n=!1,r=()=>window.clearTimeout(t);return{ask(){r(),t=window.setTimeout(()=>e(()=>n||i()),400)},end(){n=!0,r()}}}function od(i,t,e){let n=e.filter(r=>!r.ghost).map(r=>{let[s,o]=Co(r.y);return`${r.label} ${is[r.role]}, from ${ri(s)} to ${ri(o)} ${t}`.trim()});return`${i.title}: ${n.join("; ")||"no curve is shown"}.`}function ad(i){return i.runs.map(t=>t.chart).reduce((t,e)=>bc(e)<bc(t)?e:t)}function bc(i){return i.at.data.length/i.samples}function B0(i){let[t,e]=[i.at.data.length,i.samples].map(n=>n.toLocaleString("en"));return`Drawn by ${t} of ${e} samples; every extreme is kept.`}function ld(i,t){return i.group!=="spectrum"||i.id==="spectrum_tip_nominal"?null:typeof t?.vibration=="object"?t.vibration.marks:null}function z0(i,t){let e=Math.max(0,...t.map(n=>n.x[n.x.length-1]??0));return i.filter(({at:n})=>n<=e)}function V0(i,t,e){let n=i.filter(d=>!d.ghost),r=[d=>String(d.run),d=>d.label,d=>d.role],s=r.map(d=>[...new Set(n.map(d))]),o=r.map((d,m)=>new Set(s[m].filter(y=>!n.some(g=>g.shown&&d(g)===y)))),a=t?0:s[1].length>1?1:2,l=s[2].length,c=d=>{let m=a===0&&s[1].length>1&&l===1?s[1].length:l,y=a===0?d.run:s[a].indexOf(r[a](d)),g=Fa(d.role,y,a<2,m);return a===0&&l===1?{...g,dash:Fa("real",s[1].indexOf(d.label),!0,1).dash}:g},u=rt("div",{class:"legend"}),h=new Map;r.forEach((d,m)=>{if(s[m].length<2&&m!==a)return;let y=rt("div",{class:"legend-row",role:"group","aria-label":["Runs","Curves","Parts"][m]});for(let g of s[m]){let p=n.find(x=>d(x)===g);p&&y.append(f(p,g,m))}u.append(y)});function f(d,m,y){let g=y===0?d.runName:y===2&&l>1?is[d.role]:d.label,p=y===a?c(d):{property:"--quiet",dash:y===2?c(d).dash:[]},x=Ql(`var(${p.property})`,y===a&&a<2&&l>1?[]:p.dash),_=rt("span",{class:"value"}),v=rt("button",{type:"button",class:"toggle","aria-pressed":String(!o[y].has(m))},x,rt("span",{text:g}),_);return y===a&&h.set(m,_),v.addEventListener("click",()=>{o[y].delete(m)||o[y].add(m),v.setAttribute("aria-pressed",String(!o[y].has(m))),e()}),v}return{element:u,look:c,renew(d){n=d.filter(m=>!m.ghost)},shows:d=>r.every((m,y)=>!o[y].has(m(d))),tell(d){for(let[m,y]of h){let g=n.find(x=>r[a](x)===m&&r.every((_,v)=>!o[v].has(_(x)))),p=g?d(g):null;ze(y,p===null?"":ri(p).replace("-","−"))}}}}var G0="12px system-ui, sans-serif",H0=2;function W0(i,t,e,n){let r={stroke:()=>gn("--grid"),width:1},s={stroke:()=>gn("--quiet"),font:G0,grid:r,ticks:{...r,size:4}},o={width:Math.max(i.clientWidth,120),height:n.height,legend:{show:!1},padding:[10,14,0,0],scales:{x:{time:!1},y:n.log?{distr:3,range:(l,c,u)=>dS(c,u,n.decades)}:{range:(l,c,u)=>fS(c,u)}},axes:[{...s,label:n.abscissa,labelSize:18,labelFont:G0,size:30,values:(l,c)=>c.map(ri)},{...s,size:(l,c)=>16+7*Math.max(2,...(c??[]).map(u=>u.length)),values:(l,c)=>c.map(u=>u===null?"":n.log?pS(u):ri(u))}],series:[{},...e.map(l=>({stroke:()=>gn(l.property),width:l.width,dash:l.filled?[]:l.dash,fill:l.filled?()=>gn(l.property):void 0,alpha:l.ghost?.35:1,spanGaps:!0,points:{show:!1}}))],cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!0,dist:H0},bind:{mousedown:(l,c,u)=>h=>h.shiftKey?u(h):null,dblclick:()=>()=>(n.zoomed(null),null)}},hooks:{setSelect:[l=>mS(l,n)],setCursor:[l=>n.hovered(l.cursor.left===void 0||l.cursor.left<0?null:l.posToVal(l.cursor.left,"x"))],draw:[l=>yS(l,n.marks)]}},a=new cn(o,t,i);return gS(a,n),a}function fS(i,t){if(i===null||t===null||!Number.isFinite(i)||!Number.isFinite(t))return[0,1];let e=Math.max(Math.abs(i),Math.abs(t)),n=e>1e-9?.05*e:.05;if(t-i<=1e-9*e||e<=1e-12)return[(i+t)/2-n,(i+t)/2+n];let r=.07*(t-i);return[i-r,t+r]}function dS(i,t,e){if(i===null||t===null||!(t>0))return[.1,1];let n=Math.max(i>0?i:t,t*10**-e);return[10**Math.floor(Math.log10(n)+1e-9),t*1.6]}function pS(i){let t=Math.log10(i);return Math.abs(t-Math.round(t))>1e-6?"":ri(i).replace(/^1\u00a0×\u00a0|^1\.0\u00a0×\u00a0/,"")}function mS(i,t){i.select.width<H0||(t.zoomed([i.posToVal(i.select.left,"x"),i.posToVal(i.select.left+i.select.width,"x")]),i.setSelect({left:0,top:0,width:0,height:0},!1))}function gS(i,t){let e=i.over,n=r=>t.chosen(i.posToVal(r.clientX-e.getBoundingClientRect().left,"x"));e.addEventListener("pointerdown",r=>{r.shiftKey||r.button!==0||(e.setPointerCapture(r.pointerId),n(r))}),e.addEventListener("pointermove",r=>{e.hasPointerCapture(r.pointerId)&&n(r)})}function yS(i,t){let{ctx:e,bbox:n}=i,r=cn.pxRatio,s=-1/0;e.save(),e.fillStyle=gn("--quiet"),e.font=`${11*r}px system-ui, sans-serif`,e.lineJoin="round";for(let{at:o}of t){let a=i.valToPos(o,"x",!0);if(a<n.left||a>n.left+n.width)continue;[e.strokeStyle,e.lineWidth]=[gn("--quiet"),r],e.setLineDash([3*r,3*r]),e.beginPath(),e.moveTo(a,n.top),e.lineTo(a,n.top+n.height),e.stroke(),[e.strokeStyle,e.lineWidth]=[gn("--panel"),4*r],e.setLineDash([]);let l=`${ri(Number(o.toPrecision(3)))} Hz`;if(a>s&&a+e.measureText(l).width<n.left+n.width){let c=[l,a+3*r,n.top+11*r];e.strokeText(...c),e.fillText(...c),s=a+e.measureText(l).width+8*r}}e.restore()}var q0="total",xS=.05;function $0(i,t,e){let n=i.map((s,o)=>({entry:s,values:t[o],filled:!1}));if(!e)return n;let r=[];for(let s of[1,-1]){let o=new Float64Array(t[0]?.length??0);for(let{entry:a,values:l}of n)a.label!==q0&&(o=o.map((c,u)=>c+s*Math.max(0,s*(l[u]??0))),r.unshift({entry:a,values:o,filled:!0}))}return[...r,...n.filter(({entry:s})=>s.label===q0)]}function X0(i,t){let e=i.map(({y:c})=>Co(c)),[n,r]=[Math.min(...e.map(([c])=>c)),Math.max(...e.map(([,c])=>c))],s=Math.max(Math.abs(n),Math.abs(r));if(!(r-n<xS*s)||r-n<=1e-9*s)return"";let[o,a]=[n,r].map(c=>String(Number(c.toPrecision(6)))),l=Number((100*(r-n)/s).toPrecision(2));return`The axis does not start at zero: ${o} to ${a} ${t}, ${l} % apart.`}var Y0={spectrum:5,other:6},vS=190,_S=1e-9,bS=100;function j0(i,t,e){let{chart:n}=i,r=n.abscissa==="time",s=Lr("chart"),o=r?"time [s]":"frequency [Hz]",a=n.unit==="–"?"":n.unit,l=n.log==="first",c=null,u=!0,h=Qf(i,null),f=n.marks,d=0,m=null,y=null,g=null,p=!1,x=!0,_=[],v="",M=0,A=0,b=0,w=_c(dt),N=rt("div",{class:"plot-area",role:"img"}),P=rt("span",{class:"readout"}),I=Be("log",()=>ht(!l),{class:"tool","aria-pressed":String(l),title:"Logarithmic ordinate, of the size of the values",hidden:n.log==="no"}),U=Be("reset zoom",()=>e.set(null),{class:"tool",hidden:!0}),V=rt("div",{class:"tools"},U,I,...U0(oe)),C=`${n.title}${a?` [${a}]`:""}`,D=rt("span",{class:"unit",text:C.slice(n.title.length)}),G=rt("h4",{id:s,text:n.title},D),z=rt("p",{class:"note",hidden:!r||bc(ad(i))>=1,text:B0(ad(i))}),et=rt("p",{class:"note",hidden:!0,text:"The marked frequencies are of the run as it was."}),$=rt("p",{class:"note",hidden:!0}),X=V0(h,i.compared,ct),tt=rt("figure",{class:"chart","aria-labelledby":s,"data-chart":n.id},rt("figcaption",{},G,P,V),N,X.element,$,z,et);function ht(Ft){l=Ft,I.setAttribute("aria-pressed",String(Ft)),ct()}function ct(){x=!0,p?dt():w.ask()}function J(){if(u)return h;u=!0,h=Qf(i,c);let Ft=ld(n,c);return f=Ft?z0(Ft,h):n.marks,X.renew(h),h}function dt(){if(!x||d===0)return;x=!1;let Ft=le(),[xe,...te]=yc(Ft,l),je=$0(Ft,te,n.stacked===!0);_=je.map(({entry:xt,filled:Xt})=>({...X.look(xt),width:Xt?0:xt.ghost?1:xt.role==="real"?1.6:1.3,ghost:xt.ghost,filled:Xt}));let Ze=[xe,...je.map(({values:xt})=>xt)],an=l?"":X0(Ft,a);ze($,an),$.hidden=!an,A=Math.max(0,...Ft.map(xt=>Math.max(...Co(xt.y).map(Math.abs))));let k=JSON.stringify([_,f,l,d,M]);m&&k===v?m.setData(Ze):gt(Ze,_),v=k,N.setAttribute("aria-label",od(n,a,Ft)),r&&bt(e.range),Kt()}function gt(Ft,xe){m?.destroy(),g=null,m=W0(N,Ft,xe,{log:l,decades:n.group==="spectrum"?Y0.spectrum:Y0.other,height:vS,marks:f,abscissa:o,zoomed:te=>r?e.set(te):bt(te),hovered:te=>{g=te,Kt()},chosen:te=>{r&&t.seek(te)}}),y=r?rt("div",{class:"time-line"}):null,y&&m.over.append(y)}function bt(Ft){let xe=m?.data[0];if(U.hidden=Ft===null,!m||!xe?.length)return;let[te,je]=Ft??[xe[0],xe[xe.length-1]];je>te&&m.setScale("x",{min:te,max:je}),queueMicrotask(yt)}function yt(){if(!m||!y)return;let Ft=m.valToPos(t.time,"x"),xe=m.valToPos(m.scales.x.max??0,"x"),te=Ft>=-.5&&Ft<=xe+.5;y.style.display=te?"":"none",y.style.transform=`translateX(${Ft}px)`}function Gt(){yt(),(!t.playing||performance.now()-b>bS)&&Kt()}function Kt(){b=performance.now();let Ft=g??(r?t.time:null);ze(P,g===null?"":r?`at ${g.toFixed(3)} s`:`at ${Gn(g,"Hz")}`),X.tell(xe=>Ft===null?null:zt(I0(xe,Ft)))}function zt(Ft){return Ft!==null&&Math.abs(Ft)<_S*A&&!l?0:Ft}let le=()=>J().filter(Ft=>X.shows(Ft));function oe(){dt();let Ft=le().map(xe=>[xe,X.look(xe)]);return m&&{id:n.id,titled:C,unit:a,abscissa:o,plot:m,marks:f,pieces:_,looks:Ft}}let Jt=new IntersectionObserver(Ft=>{p=Ft.some(xe=>xe.isIntersecting),p&&dt(),p&&Gt()},{rootMargin:"120px"}),Fe=new ResizeObserver(()=>{d=N.clientWidth,d>0&&ct()}),Ae=()=>{M+=1,x=!0,dt()};for(let Ft of["beforeprint","afterprint"])addEventListener(Ft,Ae);Jt.observe(tt),N.setAttribute("aria-label",od(n,a,h.filter(Ft=>X.shows(Ft)))),Fe.observe(N);let hn=[t.subscribe(()=>{p&&r&&Gt()}),e.subscribe(()=>r&&bt(e.range))];return{element:tt,id:n.id,state:oe,show(Ft){c=Ft,u=!1,et.hidden=Ft===null||ld(n,Ft)!==null||n.marks.length===0,ct()},recolour(){M+=1,ct()},dispose(){for(let Ft of["beforeprint","afterprint"])removeEventListener(Ft,Ae);w.end(),Jt.disconnect(),Fe.disconnect(),hn.forEach(Ft=>Ft()),m?.destroy()}}}function Z0(){let i=new Set,t={range:null};return{get range(){return t.range},set(e){e===t.range||e&&t.range&&e.every((r,s)=>r===t.range?.[s])||(t.range=e,i.forEach(r=>r()))},subscribe(e){return i.add(e),()=>i.delete(e)}}}var K0={overview:"Overview",error:"Error",tip:"Tip",contact:"Contact",deformations:"Deformations",motors:"Motors",energy:"Energy",spectrum:"Spectrum",all:"All"};function Q0(i,t,e){let n=R0(t),r=Z0(),s=rt("div",{class:"chart-grid",id:"tm-charts",role:"tabpanel",tabindex:"0"}),o=rt("div",{class:"tabs",role:"tablist","aria-label":"Charts"}),a=rt("p",{class:"note hint",text:"Click or drag: the time. Shift and drag: zoom, double click: back. Keys: space, arrows, and , . by sample."}),l=Object.keys(K0).filter(p=>J0(n,p).length>0),c=[],u=[],h="overview",f=null;for(let p of l){let x=Be(K0[p],()=>d(p),{role:"tab",id:`tm-tab-${p}`,"aria-controls":"tm-charts","data-group":p});o.append(x)}o.addEventListener("keydown",p=>{let x={ArrowRight:1,ArrowLeft:-1}[p.key],_=l.findIndex(v=>`tm-tab-${v}`===p.target.id);x===void 0||_<0||(p.preventDefault(),p.stopPropagation(),d(l[(_+x+l.length)%l.length]),o.querySelector("[aria-selected=true]")?.focus())});function d(p){u.forEach(x=>x.dispose()),h=p,c=J0(n,p),u=c.map(x=>j0(x,e,r)),f&&u.forEach(x=>x.show(f));for(let x of o.querySelectorAll("button")){let _=x.dataset.group===p;x.setAttribute("aria-selected",String(_)),x.tabIndex=_?0:-1}s.setAttribute("aria-labelledby",`tm-tab-${p}`),s.replaceChildren(...u.map(x=>x.element))}let m=Be("Save all of these (SVG)",()=>{let p=u.flatMap(x=>x.state()??[]);setTimeout(()=>id(p.map(nd),`charts_${h}`))},{class:"tool",title:"Save the charts of this tab as one vector graphic"}),y=matchMedia("(prefers-color-scheme: dark)"),g=()=>u.forEach(p=>p.recolour());return y.addEventListener("change",g),i.append(rt("div",{class:"tab-bar"},o),s,m,a),d("overview"),{renew:()=>d(h),show(p){let x=f;f=p,u.forEach((_,v)=>{(!p||!x||!C0(c[v],x,p))&&_.show(p)})},dispose(){y.removeEventListener("change",g),u.forEach(p=>p.dispose()),i.replaceChildren()}}}function J0(i,t){return t==="all"?i:t!=="overview"?i.filter(({chart:e})=>e.group===t):i.filter(({chart:e},n)=>i.findIndex(r=>r.chart.group===e.group)===n)}var ty='"use strict";(()=>{var hn=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],pn=["m","rad","s"],gn=["Hz","%","rad/s"],Tt={m:[10,1e3,"mm"],rad:[1,1e3,"mrad"],s:[1,1,"s"]},dn="⁰¹²³⁴⁵⁶⁷⁸⁹";function yn(s){let e=s.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(e)?"":e}function Q(s,e=4){return s===0?"0":String(Number(s.toPrecision(e)))}function wn(s){if(s===0)return"0";let[e,r]=s.toExponential(1).split("e"),t=[...String(Number(r))].map(n=>n==="-"?"⁻":dn[Number(n)]).join("");return`${e} × 10${t}`}function bn(s,e){let r=yn(s);if(!r||gn.includes(s)||!(e>0))return{factor:1,name:r};let t=Tt[s];if(t)return e<t[0]?{factor:t[1],name:t[2]}:{factor:1,name:r};let n=pn.includes(s.split("/")[0]),o=hn.find(([i,a])=>e>=i&&(a>=1||!n));return o?{factor:o[1],name:o[2]+r}:{factor:1,name:r}}function H(s,e){if(s===null||!Number.isFinite(s))return"–";let r=Math.abs(s),{factor:t,name:n}=bn(e,r);return`${r>0&&(t===1||e in Tt?r*t<.001:r<1e-11)?wn(e in Tt?s*t:s):Q(s*t)} ${n}`.trimEnd()}function ye(s){let{settings:e,status:r}=s,{statuses:t,limits:n}=s.layout,o=`t = ${Q(s.time,6)} s`;if(r===t.finished)return["finished",`completed at t = ${Q(e.duration,6)} s`];if(r===t.running)return["stopped",`stopped at ${o} of ${Q(e.duration,6)} s: integration.max_steps = ${e.maxSteps} is used up`];if(r===t.chattering){let i=`more than ${n.most_events} times within ${n.event_time} s`;return["chattering",`stopped at ${o}: the contact started or ended ${i}; give the surface damping, or a lower stiffness`]}return Fn(s,o)}function Fn({layout:s,status:e,lastStep:r,rates:t},n){let{statuses:o,coordinates:i,limits:a}=s,l=i.length,u=Array.from(t().subarray(l,2*l),d=>Number.isFinite(d)?Math.abs(d):1/0),f=u.indexOf(Math.max(...u)),m=u[f]<a.bound?e===o.not_converged?"not_converged":e===o.step_too_small?"step_too_small":"diverged":"diverged",g=`its acceleration is ${Q(u[f],3)} rad/s^2`,p=m.replaceAll("_"," ");return[m,`${p} at ${n} in coordinate ${i[f]}: ${g}; its last step was of ${Q(r,3)} s`]}var D=class extends Error{name="EngineError"};function mt(s,e,r){if(!Object.hasOwn(s,e))throw new D(`${r}: got ${e}; expected one of ${Object.keys(s).join(", ")}`);return s[e]}function tt(s,e,r){if(e!==r)throw new D(`${s}: got ${e} numbers; expected ${r}`)}var An=["rk4","midpoint"],Sn=500,$t=class{constructor(e,r){this.engine=e;this.spec=r;let t=mt(e.layout.loops,r.loop,"loop");tt(`${r.loop}: parameters`,r.parameters.length,t.parameters),tt(`${r.loop}: state`,r.state.length,t.size),tt(`${r.loop}: rows`,r.rows.length,(r.knots.length-1)*t.row),this.method=t.method,this.memory=new Float64Array(e.layout.cells.length),this.state=r.state.slice(),this.slope=new Float64Array(t.size),this.states=new Float64Array(r.times.length*t.size),this.states.set(r.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(e){return this.memory[this.engine.layout.cells.indexOf(e)]}put(e){for(let[r,t]of Object.entries(e))this.memory[this.engine.layout.cells.indexOf(r)]=t}advance(e){let{layout:r}=this.engine,{settings:t,knots:n,rows:o,times:i,parameters:a}=this.spec,l=Math.max(1,Math.min(e,t.maxSteps-this.tried)),u={step:t.step,rtol:t.relativeTolerance,atol:t.absoluteTolerance,chunk:l,bound:r.limits.bound,watch:0,most_events:r.limits.most_events,event_time:r.limits.event_time,looks:0},f=this.cell("sample"),c=p=>({into:p,range:()=>[f*this.state.length,this.cell("sample")*this.state.length]}),m=p=>({into:p,given:!0}),g={memory:m(this.memory),y:m(this.state),k1:m(this.slope),p:a,knots:n,rows:o,times:i,out:c(this.states),options:Float64Array.from(r.options,p=>u[p]),seen:new Float64Array(1),segments:n.length-1,samples:i.length};this.engine.call(r.loops[this.spec.loop].export,r.arguments.map(p=>g[p]))}result(){let e=this.cell("sample"),r=this.state.length,[t,n]=ye({layout:this.engine.layout,settings:this.spec.settings,status:this.cell("status"),time:this.time,lastStep:this.cell("h"),rates:()=>this.rates()});return{status:t,message:n,times:this.spec.times.slice(0,e),states:this.states.slice(0,e*r),statistics:this.statistics()}}statistics(){let[e,r,t]=[this.cell("steps"),this.cell("smallest"),this.time],n=e?t/e:null,o={steps:e,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:n,smallest_step_s:r>0?r:n};return An.includes(this.method)&&(o.step=this.cell("h")),this.cell("passes")&&(o.passes=this.cell("passes")),this.cell("events")&&(o.contact_changes=this.cell("events")),o}rates(){let{loop:e,parameters:r,rows:t}=this.spec,{row:n}=this.engine.layout.loops[e],o=Math.min(this.cell("segment"),t.length/n-1),i={time:Float64Array.of(this.time),state:this.state,row:t.slice(o*n,(o+1)*n),step:new Float64Array(1)};return this.engine.sample(`${e.slice(0,e.lastIndexOf("."))}.rate`,r,i,1).rate}},Y=class extends D{name="Cancelled"};async function we(s,e,r={}){let t=new $t(s,e),n=1e3*(r.piece??.05),o=Sn,i=performance.now();for(;t.running;){let a=performance.now();t.advance(o);let l=performance.now();if(o=Math.max(1,Math.floor(o*Math.min(4,n/Math.max(l-a,.001)))),!(l-i<n)){if(r.progress?.(t.time/e.settings.duration),await new Promise(u=>setTimeout(u,0)),r.cancelled?.())throw new Y(`the run was given up at t = ${Q(t.time,6)} s`);i=performance.now()}}return t.result()}function qt(s,e){if(!e)return s;let r=(t,n)=>Object.fromEntries(Object.entries(t).filter(([o,i])=>n[o]!==i));return{...r(s,e),series:r(s.series,e.series)}}function ht(s,e=new Set){if(ArrayBuffer.isView(s))s.buffer instanceof ArrayBuffer&&e.add(s.buffer);else if(s!==null&&typeof s=="object")for(let r of Object.values(s))ht(r,e);return[...e]}var be=1,Mn=65536,vn={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},Ft=class s{constructor(e,r,t,n){this.layout=e;this.functions=r;this.memory=t;this.free=n}layout;functions;memory;free;static async open(e,r){if(r.format!==be)throw new D(`layout: got format ${r.format}; expected ${be}`);let{instance:t}=await En(e,r),{memory:n,heap_base:o,...i}=t.exports,a=o.value;return new s(r,i,n,a)}sample(e,r,t,n,o){let i=mt(this.layout.samples,e,"function");tt(`${e}: parameters`,r.length,i.parameters);let a=this.schedule(i,r,[t],n);return _t(i.outputs,a,n,1,o)}slopes(e,r,t,n,o){let i=mt(this.layout.samples,e,"function");if(i.kind!=="slopes")throw new D(`${e}: got a function without derivatives; expected one with them`);tt(`${e}: parameters`,r.length,i.parameters);let a=Object.fromEntries(Object.entries(i.inputs).map(([f,c])=>[f,new Float64Array(c)])),l=this.schedule(i,r,[t,{...a,...n}],o),u=pt(i.outputs);return{values:_t(i.outputs,l,o,2),slopes:_t(i.outputs,l.subarray(u),o,2)}}call(e,r){let t=r.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(t.reduce((a,l)=>a+(l?.byteLength??0),this.free));let n=new Float64Array(this.memory.buffer),o=this.free,i=r.map((a,l)=>{if(typeof a=="number")return BigInt(a);let u=o;return(a instanceof Float64Array||a.given)&&n.set(t[l],u/8),o+=t[l].byteLength,u});this.functions[e](...i),r.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[u,f]=a.range?.()??[0,a.into.length],c=i[l]/8;a.into.set(n.subarray(c+u,c+f),u)})}schedule(e,r,t,n){let o=n*t.length,[i,a]=[pt(e.inputs),pt(e.outputs)],l=this.free+r.byteLength,u=l+8*e.workspace,f=u+8*o*i;this.reserve(f+8*o*a);let c=new Float64Array(this.memory.buffer);return c.set(r,this.free/8),c.fill(0,l/8,u/8),xn(c.subarray(u/8,f/8),e.inputs,t,n),this.functions[e.export](BigInt(n),BigInt(0),this.free,l,u,f),c.subarray(f/8,f/8+o*a)}reserve(e){let r=e-this.memory.buffer.byteLength;if(!(r<=0))try{this.memory.grow(Math.ceil(r/Mn))}catch{throw new D(`memory: got no room for ${(e/1e6).toFixed(0)} MB; expected a browser that has it. Hint: ask for fewer samples`)}}};async function En(s,e){try{return await WebAssembly.instantiate(s,{env:vn})}catch(r){let t=e.simd?", with vectors (SIMD)":"";throw new D(`WebAssembly: got ${String(r)}; expected a browser that allows it${t}`)}}function pt(s){return Object.values(s).reduce((e,r)=>e+r,0)}function kn(s,e,r,t){if(r===void 0)throw new D(`${s}: got nothing; expected ${e} numbers for each sample`);return r.length===t*e?e:(tt(s,r.length,e),0)}function xn(s,e,r,t){let n=pt(e);r.forEach((o,i)=>{let a=i*n;for(let[l,u]of Object.entries(e)){let f=kn(l,u,o[l],t);Fe(o[l],f,0,s,r.length*n,a,u,t),a+=u}})}function _t(s,e,r,t,n=Object.keys(s)){let o=t*pt(s),i={},a=0;for(let[l,u]of Object.entries(s))n.includes(l)&&(i[l]=new Float64Array(r*u),Fe(e,o,a,i[l],u,0,u,r)),a+=u;return i}function Fe(s,e,r,t,n,o,i,a){for(let l=0;l<a;l++){let u=l*e+r,f=l*n+o;for(let c=0;c<i;c++)t[f+c]=s[u+c]}}var At=class{last=null;async of(e,r){if(this.last&&jn(this.last.blocks,e))return this.last.made;this.last=null;let t=await r();return this.last={blocks:e,made:t},t}};function jn(s,e){return Object.entries(s).every(([r,t])=>t.length===e[r].length&&t.every((n,o)=>n===e[r][o]))}function Pt(s,e){return{knots:s,coefficients:e,signals:1,degree:e.length/(s.length-1)-1}}function zt(s,e){let r=s.degree+1,t=s.knots.length-1,n=0;for(;n<t&&s.knots[n]<e;)n+=1;let o=s.knots[t],i=[...s.knots.subarray(0,n)],a=[...s.coefficients.subarray(0,n*r)];return e>o&&(i.push(o),a.push(Ct(s,t-1,0,o),...new Array(s.degree).fill(0))),Pt(Float64Array.from([...i,e]),Float64Array.from(a))}function Ct(s,e,r,t){let n=s.degree+1,o=(e*s.signals+r)*n,i=t-s.knots[e],a=0;for(let l=s.degree;l>=0;l-=1)a=a*i+s.coefficients[o+l];return a}function Wt(s,e){let[r,t]=[0,s.length-1];for(;t-r>1;){let n=r+t>>1;s[n]<=e?r=n:t=n}return r}function et(s,e,r){return Ct(s,Wt(s.knots,r),e,r)}function Ae(s){return Se(s,s.knots.length-1,e=>e)}function St(s,e){return Se(s,e.length,r=>Wt(s.knots,e[r]))}function Se(s,e,r){let t=s.signals*(s.degree+1),n=new Float64Array(e*(t+1));for(let o=0,i=0;o<e;o+=1){let a=r(o);n[i++]=s.knots[a];for(let l=a*t;l<(a+1)*t;l+=1)n[i++]=s.coefficients[l]}return n}function Me(s){if(!s.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let e=Math.max(...s.map(i=>i.knots[i.knots.length-1])),r=s.map(i=>i.knots[i.knots.length-1]<e?zt(i,e):i),t=Rn(r.flatMap(i=>[...i.knots])),n=Math.max(...r.map(i=>i.degree)),o=new Float64Array((t.length-1)*s.length*(n+1));return r.forEach((i,a)=>{for(let l=0;l<t.length-1;l+=1){let u=(l*s.length+a)*(n+1);Ln(i,t,l,o.subarray(u,u+n+1))}}),{knots:t,coefficients:o,signals:s.length,degree:n}}function Rn(s){let e=[...new Set(s)].sort((n,o)=>n-o),r=e[e.length-1]-e[0],t=e.filter((n,o)=>o===0||n-e[o-1]>1e-12*r);return t[t.length-1]=e[e.length-1],Float64Array.from(t)}function Ln(s,e,r,t){let n=Wt(s.knots,(e[r]+e[r+1])/2),o=e[r]-s.knots[n],i=Math.abs(o)<=1e-12*(e[e.length-1]-e[0])?0:o;for(let a=0;a<=s.degree;a+=1){let l=s.coefficients[n*(s.degree+1)+a],u=1;for(let f=a;f>=0;f-=1)t[f]+=u*l*Math.pow(i,a-f),u=u*f/(a-f+1)}}var On=1e-9,In=1e-6;function ve(s){let e=s.map(Bn);return e.includes(null)?null:Math.max(0,...e)}function Bn(s){let{knots:e,coefficients:r,degree:t}=s,n=e.length-1,o=t+1,i=l=>r[l*o],a=Array.from({length:n},(l,u)=>Math.abs(i(u))).reduce((l,u)=>Math.max(l,u),1e-12);for(let l=n-1;l>=0;l-=1){let u=e[l+1]-e[l];for(let f=1;f<o;f+=1)if(!(Math.abs(r[l*o+f])*u**f<=On*a))return l===n-1?null:e[l+1];if(l&&Math.abs(i(l)-Ct(s,l-1,0,e[l]))>In*a)return e[l]}return 0}var C=6;function Dt({follower:s,signal:e},r,t,n,o,i){let a=e<0?1:et(t,e,n);return(s?Nn(o,i,r):r).map(l=>a*l)}function Nn(s,e,r){return r.map((t,n)=>{let[o,i]=[e+3*(n%3),n<3?0:3];return s[o]*r[i]+s[o+1]*r[i+1]+s[o+2]*r[i+2]})}function Mt(s,e,r,t,n){let o=n.position.shape[1],i=new Float64Array(t.length*o*C);return t.forEach((a,l)=>{if(s.loads.forEach((u,f)=>{let c=l*o+u.point,m=e.loads.subarray(C*f,C*(f+1)),g=Dt(u,m,r,a,n.rotation.data,9*c);for(let p=0;p<C;p+=1)i[C*c+p]+=g[p]}),!(s.contactPoint<0))for(let u=0;u<3;u+=1)i[C*(l*o+s.contactPoint)+u]-=n.contact_force.data[3*l+u]}),i}function vt(s,e){let r=e.length;for(let t=0;t<r;t+=1){let n=t;for(let i=t+1;i<r;i+=1)Math.abs(s[i*r+t])>Math.abs(s[n*r+t])&&(n=i);let o=Math.abs(s[n*r+t]);if(!(o>0)||o===1/0)return!1;n!==t&&Tn(s,e,t,n);for(let i=t+1;i<r;i+=1){let a=s[i*r+t]/s[t*r+t];if(a!==0){for(let l=t+1;l<r;l+=1)s[i*r+l]-=a*s[t*r+l];e[i]-=a*e[t]}}}for(let t=r-1;t>=0;t-=1){for(let n=t+1;n<r;n+=1)e[t]-=s[t*r+n]*e[n];e[t]/=s[t*r+t]}return!0}function Tn(s,e,r,t){let n=e.length;for(let i=0;i<n;i+=1){let a=s[r*n+i];s[r*n+i]=s[t*n+i],s[t*n+i]=a}let o=e[r];e[r]=e[t],e[t]=o}function Et(s,e){let r=new Float64Array(e*e);for(let t=0;t<e;t+=1)for(let n=t;n<e;n+=1){let o=s[n*e+t];for(let i=0;i<t;i+=1)o-=r[n*e+i]*r[t*e+i];if(n===t&&!(o>0))return null;r[n*e+t]=n===t?Math.sqrt(o):o/r[t*e+t]}return r}function ke(s,e,r,t){for(let n=0;n<r;n+=1){for(let o=0;o<n;o+=1)je(e,n,o,s[n*r+o],t);for(let o=0;o<t;o+=1)e[n*t+o]/=s[n*r+n]}}function Ut(s,e,r,t){for(let n=r-1;n>=0;n-=1){for(let o=n+1;o<r;o+=1)je(e,n,o,s[o*r+n],t);for(let o=0;o<t;o+=1)e[n*t+o]/=s[n*r+n]}}function je(s,e,r,t,n){for(let o=0;o<n;o+=1)s[e*n+o]-=t*s[r*n+o]}function kt(s,e,r){let t=e.slice();ke(s,t,r,r);let n=xe(t,r);return ke(s,n,r,r),xe(n,r)}function xe(s,e){return s.map((r,t)=>s[t%e*e+Math.floor(t/e)])}function q(s,e,r,t,n,o=!1){let i=new Float64Array(r*n);for(let a=0;a<r;a+=1)for(let l=0;l<t;l+=1){let u=o?s[l*r+a]:s[a*t+l];if(u)for(let f=0;f<n;f+=1)i[a*n+f]+=u*e[l*n+f]}return i}function Re(s,e){let r=Float64Array.from({length:e*e},(t,n)=>n%(e+1)?0:1);for(let t=0;t<e;t+=1){let n=t;for(let a=t+1;a<e;a+=1)Math.abs(s[a*e+t])>Math.abs(s[n*e+t])&&(n=a);let o=Math.abs(s[n*e+t]);if(!(o>0)||o===1/0)return null;for(let a of[s,r])if(n!==t){let l=a.slice(t*e,(t+1)*e);a.copyWithin(t*e,n*e,(n+1)*e),a.set(l,n*e)}let i=s[t*e+t];for(let a=0;a<e;a+=1)s[t*e+a]/=i,r[t*e+a]/=i;for(let a=0;a<e;a+=1){let l=s[a*e+t];if(!(a===t||l===0)){for(let u=t;u<e;u+=1)s[a*e+u]-=l*s[t*e+u];for(let u=0;u<e;u+=1)r[a*e+u]-=l*r[t*e+u]}}}return r}var xt=24;function Le(s,e,r,t,n,o,i=0){let a=t.length/xt,l={wrenches:new Float64Array(C*a),mass:new Float64Array(o*o),damping:new Float64Array(o*o),stiffness:new Float64Array(o*o)},u=(f,c)=>Float64Array.from({length:3*o},(m,g)=>n[(g%o*a+f)*xt+c+Math.floor(g/o)]);return s.loads.forEach((f,c)=>{let{point:m,follower:g}=f,p=e.loads.subarray(C*c,C*(c+1)),d=Dt(f,p,r,i,t,xt*m);if(ct(l.wrenches.subarray(C*m,C*(m+1)),d,1),!g)return;let w=u(m,21);for(let[h,y]of[[u(m,18),0],[w,3]])ct(l.stiffness,q(h,q($n(d.subarray(y,y+3)),w,3,3,o),o,3,o,!0),1)}),s.touch&&_n(qn(s.touch,e.surface),e.touch,t,u(s.touch.point,18),l,o),l}function ct(s,e,r){for(let t=0;t<e.length;t+=1)s[t]+=r*e[t]}function $n([s,e,r]){return Float64Array.of(0,-r,e,r,0,-s,-e,s,0)}function qn(s,e){let[r,t,n,o]=e;if(s.radius)return{...s,axis:[r,t,n],radius:o};let[i,a,l]=s.axis;return{...s,distance:-(i*r+a*t+l*n)}}function _n(s,e,r,t,n,o){let[i,a,l,u]=e,f=xt*s.point+9,{gap:c,normal:m,curvature:g}=Pn(s,r.subarray(f,f+3)),p=u-l*c;if(!s.bilateral&&!(c<=0&&p>0))return;for(let h=0;h<3;h+=1)n.wrenches[C*s.point+h]+=p*m[h];let d=q(m,t,1,3,o),w=q(d,d,o,1,o);ct(n.mass,w,i),ct(n.damping,w,a),ct(n.stiffness,w,l),ct(n.stiffness,q(t,q(g,t,3,3,o),o,3,o,!0),-p)}function Pn(s,e){let r=l=>l[0]*e[0]+l[1]*e[1]+l[2]*e[2];if(!s.radius)return{gap:r(s.axis)+s.distance,normal:Float64Array.from(s.axis),curvature:new Float64Array(9)};let t=e.map((l,u)=>l-s.axis[u]),n=Math.hypot(...t)||1e-300,o=s.inside?-1:1,i=t.map(l=>l/n),a=Float64Array.from({length:9},(l,u)=>o*((u%4?0:1)-i[Math.floor(u/3)]*i[u%3])/n);return{gap:o*(n-s.radius),normal:i.map(l=>o*l),curvature:a}}function Oe(s,e){let r=Array.from(s.frames.data).filter(t=>t<e);return r[r.length-1]!==e-1&&r.push(e-1),r}function j(s){return s.data instanceof Float64Array?s.data:Float64Array.from(s.data)}function zn(s,e,r){let t=s.knobs.map(o=>o.start),n=s.knobs.map(o=>o.factor);return s.sliders.forEach((o,i)=>{o.real?n[o.knob]=e[i]:t[o.knob]=e[i]}),r==="reference"?t:s.knobs.map((o,i)=>{let a=n[i];return a===null||o.factor===null?t[i]:o.together?o.factor?t[i]*(a/o.factor):t[i]:t[i]*a})}function ot(s,e,r){let t=s.runs[r],n=Cn(t,zn(s,e,r)),o={};for(let[i,a]of Object.entries(t.places)){let l=a.shape.reduce((u,f)=>u*f,1);o[i]=n.slice(a.start,a.start+l)}return o}function Cn(s,e){let r=j(s.base).slice(),t=s.powers.map(l=>Ie(l,(u,f)=>Math.pow(e[u]/s.variables[u].start,f))),n=s.powers.map(l=>Ie(l,(u,f)=>Wn(s.variables[u],f,e[u]))),{products:o,terms:i,coefficients:a}=s;for(let l=0;l<o.data.length;l+=2)r[o.data[l]]*=t[o.data[l+1]];for(let l=0;l<i.data.length;l+=2)r[i.data[l]]+=a.data[l/2]*n[i.data[l+1]];return r}function Ie(s,e){return s.reduce((r,[t,n])=>r*e(t,n),1)}function Wn(s,e,r){let t=Math.pow(s.start,e);return(Math.pow(r,e)-t)/(Math.pow(s.far,e)-t)}var Dn=40,Un=1e-12,Gn=.5,Be=1e-6,Qn=.5,Kn=.001,Yn=1/128;function Jn(s,e,r,t,n,o){let[i,a,l]=[t.length+1,r.length,e.rotors.length],u=new Float64Array(i*a);for(let m=0;m<i;m+=1)u.set(r,m*a),m&&(u[m*a+t[m-1]]+=Be);let f={time:new Float64Array(1),state:u,row:e.rest_row,step:new Float64Array(1)},{rate:c}=s.sample("rest.rate",e.rest,f,i);for(let m=0;m<t.length;m+=1){o[m]=c[l+t[m]];for(let g=0;g<t.length;g+=1)n[m*t.length+g]=(c[(g+1)*a+l+t[m]]-o[m])/Be}}function Xn(s,e,r,t){let n=s.layout.held,o=t.length,i=Array.from({length:o},(g,p)=>p).filter(g=>!n.includes(g)),a=new Float64Array(e.restSize);a.set(t);let l=new Float64Array(i.length**2),u=new Float64Array(i.length),f=1/0,[c,m]=[0,0];for(let g=0;g<Dn&&i.length;g+=1){if(Jn(s,r,a,i,l,u),!vt(l,u))return null;let p=Gt(a,i,u);if(!Number.isFinite(p)||(g===0?c=p:m+=p,c>Kn&&m>Qn*c))return null;if(Qt(p,f))return a.slice(0,o);f=p}return i.length?null:a.slice(0,o)}function Gt(s,e,r){let t=r.reduce((o,i)=>Math.max(o,Math.abs(i)),0),n=Math.min(1,Gn/t);for(let o=0;o<e.length;o+=1)s[e[o]]-=n*r[o];return t}function Qt(s,e){return s<Un||s<1e-9&&s>=e/2}function Kt(s,e,r,t,n){let o=s.sliders.map(f=>f.value),i=f=>f===1?e:e.map((c,m)=>o[m]+(c-o[m])*f),[a,l,u]=[0,1,t];for(;a<1;){let f=Math.min(1,a+l),c=n(i(f),u);if(c)[a,l,u]=[f,2*l,c];else if(l>Yn)l/=2;else throw new Error(`${r}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`)}return u}function Ne(s,e,r,t,n){let o=e.runs[t],i=j(o.start).slice(),[a,l]=[o.state.q[0],o.state.v[0]];if(e.atRest){let u=(c,m)=>Xn(s,e,ot(e.map,c,t),m),f=Kt(e,r,t,i.slice(...o.state.q),u);for(let c=0;c<f.length;c+=1)o.info.includes(c)||(i[a+c]=f[c])}for(let[u,f]of o.exact){i[a+u]=et(n,f,0);let c=n.degree;i[l+u]=c?n.coefficients[f*(c+1)+1]:0}return i}var Zn=40,gt=.001;function jt(s,e,r,t){let{samples:n}=s.layout;return s.sample("loaded"in n?"loaded":"inertia",e.chain,r,t).forces}function Vn(s,e,r,t,n,o=0){let i=n.length,a=new Float64Array(i),l=Float64Array.from({length:i*i},(F,M)=>M%(i+1)?0:1),u=j(e.base),f=s.sample("inertia",r.chain,{q:n,v:a,a:l,base:u},i),{points:c}=s.sample("inertia",r.chain,{q:n,v:a,a,base:u},1),m=Le(e,r,t,c,f.points,i,o),g=m.mass;for(let F=0;F<i;F+=1){for(let M=0;M<i;M+=1)g[F*i+M]+=(f.forces[F*i+M]+f.forces[M*i+F])/2;g[F*i+F]+=r.rotors[F]}let p=r.chain.slice();for(let F of e.modes.dry)p[F]=0;let d=s.slopes("elastic.slopes",p,{q:n,v:a,base:u},{q:l},i),w=s.slopes("elastic.slopes",p,{q:n,v:a,base:u},{v:l},i).slopes.forces,h=Hn(s,e,r,n,m.wrenches),y=F=>F.map((M,E)=>F[E%i*i+Math.floor(E/i)]),b=y(d.slopes.forces),A=jt(s,r,{q:n,v:a,a,base:j(e.modes.weight),wrenches:m.wrenches},1);return{mass:g,elastic:b,residual:A.map((F,M)=>F+d.values.forces[M]),damping:y(w).map((F,M)=>F+m.damping[M]),stiffness:b.map((F,M)=>F+h[M]+m.stiffness[M])}}function Te(s,e,r,t,n,o=0){let{free:i}=e.modes,[a,l,u]=[n.slice(),n.length,i.length],[f,c]=[1/0,!u];for(let m=0;m<Zn;m+=1){let g=Vn(s,e,r,t,a,o);if(c)return{rest:a,linear:g};let p=Float64Array.from({length:u*u},(h,y)=>g.stiffness[i[Math.floor(y/u)]*l+i[y%u]]),d=Float64Array.from(i,h=>g.residual[h]);if(!vt(p,d))return null;let w=Gt(a,i,d);if(!Number.isFinite(w))return null;c=Qt(w,f),f=w}return null}function Hn(s,e,r,t,n){let o=t.length,i=[gt,-gt,2*gt,-2*gt],a=new Float64Array(i.length*o*o);i.forEach((c,m)=>{for(let g=0;g<o;g+=1)a.set(t,(m*o+g)*o),a[(m*o+g)*o+g]+=c});let l=new Float64Array(o),u=jt(s,r,{q:a,v:l,a:l,base:j(e.modes.weight),wrenches:n},i.length*o),f=(c,m,g)=>u[(c*o+g)*o+m];return Float64Array.from({length:o*o},(c,m)=>{let[g,p]=[Math.floor(m/o),m%o];return(8*(f(0,g,p)-f(1,g,p))-(f(2,g,p)-f(3,g,p)))/(12*gt)})}function O(s,e,r){let t=s.length/e,n=new Float64Array(t*r.length);for(let o=0;o<t;o+=1)for(let i=0;i<r.length;i+=1)n[o*r.length+i]=s[o*e+r[i]];return n}function _(s,e){return Array.from({length:e-s},(r,t)=>s+t)}function K(s,e,r){let t=new Float64Array(r.length*e);for(let n=0;n<r.length;n+=1)for(let o=0;o<e;o+=1)t[n*e+o]=s[r[n]*e+o];return t}function rt(s,e){return s.map((r,t)=>r-e[t])}function ft(s,e){let r=new Float64Array(s.length/e);for(let t=0;t<r.length;t+=1){let n=0;for(let o=0;o<e;o+=1)n+=s[t*e+o]**2;r[t]=Math.sqrt(n)}return r}function $e(s,e,r,t){let n=s.length/r,o=e.length/r,i=new Float64Array(r),a=0;for(let l=0;l<r;l+=1){let u=0;for(let f=0;f<n;f+=1)u+=s[l*n+f];l===0&&(a=u),i[l]=u-a;for(let f=0;f<o;f+=1)i[l]+=(f<t?-1:1)*e[l*o+f]}return i}function dt(s){let e=0;for(let r=1;r<s.length;r+=1)Math.abs(s[r])>Math.abs(s[e])&&(e=r);return e}function k(s,e,...r){return{data:s,shape:[e,...r]}}var to=4e5,eo=5e5;function qe(s,e,r,t,n,o,i){let{places:a,lines:l,shown:u}=e.carried,f=a.data.length,c=l.map((y,b)=>ro(y,r.lengths[b],i.length*u.data.length)),m=Math.max(1,Math.ceil(n.length*l.length*f/to));if(!l.length)return{links:c,every:m};let g=new Map(i.map((y,b)=>[y,b])),p=Array.from(n.keys()).filter(y=>y%m===0||g.has(y)),d={q:t.q.data,v:t.v.data,a:t.a.data};"wrenches"in s.layout.samples.line.inputs&&(d.wrenches=Mt(e,r,o,n,t));let w=Object.entries(d).map(([y,b])=>[y,K(b,b.length/n.length,p)]),h={...Object.fromEntries(w),base:j(e.split.weight)};return Jt(s,r,h,p.length,(y,b,A)=>{let F=g.get(p[A]);l.forEach((M,E)=>{let S=Xt(y[M.name],b,e,M);no(c[E],M,S,a.data,p[A]),F!==void 0&&oo(c[E],M,S,F,u.data)})}),{links:c,every:m}}function Jt(s,e,r,t,n){let{inputs:o,outputs:i}=s.layout.samples.line,a=Math.max(1,Math.floor(eo/Object.values(i).reduce((l,u)=>l+u,1)));for(let l=0;l<t;l+=a){let u=Math.min(a,t-l),f={};for(let[m,g]of Object.entries(o)){let p=r[m]??new Float64Array(g);f[m]=p.length===g?p:p.subarray(l*g,(l+u)*g)}let c=s.sample("line",e.line,f,u);for(let m=0;m<u;m+=1)n(c,m,l+m)}}function Xt(s,e,r,t){let n=t?r.carried.places.data.length*t.width:15;return s.subarray(e*n,(e+1)*n)}function ro({name:s,at:e},r,t){let n=o=>new Float64Array(o*t);return{name:s,length:r,deflection:n(2),slope:n(2),moment:n(3),shear:n(2),axial:n(1),stress:e.mises_stress?{strain:n(1),mises:n(1)}:null,largest:{deflection:null,moment:null,stress:null}}}function no(s,{width:e,at:r},t,n,o){let i=n.length-1,a=i*e+r.deflection[0];Yt(s,"deflection",Math.sqrt(t[a]**2+t[a+1]**2),n[i],o);for(let l=0;l<=i;l+=1){let u=l*e+r.moment[0];Yt(s,"moment",Math.sqrt(t[u+1]**2+t[u+2]**2),n[l],o),s.stress&&Yt(s,"stress",t[l*e+r.mises_stress[0]],n[l],o)}}function Yt({name:s,largest:e},r,t,n,o){let i=e[r];(!i||t>i.value)&&(e[r]={link:s,value:t,s:n,sample:o})}function oo(s,{width:e,at:r},t,n,o){let i=(a,l)=>{let[u,f]=r[a],c=f-u;for(let m=0;m<o.length;m+=1)for(let g=0;g<c;g+=1)l[(n*o.length+m)*c+g]=t[o[m]*e+u+g]};for(let a of["deflection","slope","moment","shear","axial"])i(a,s[a]);s.stress&&(i("strain",s.stress.strain),i("mises_stress",s.stress.mises))}function J(s,e,r){let[t,n]=s.matrix.shape,o=new Float64Array(r*t);for(let i=0;i<r;i+=1)for(let a=0;a<t;a+=1){let l=s.constant.data[a];for(let u=0;u<n;u+=1)l+=s.matrix.data[a*n+u]*e[i*n+u];o[i*t+a]=l}return o}function _e(s,e,r,t,n,o,i){let a=h=>K(t[h].data,t[h].shape.slice(1).reduce((y,b)=>y*b,1),o),l=o.length,u=Rt(s,e,r,a("q"),l),f=h=>Rt(s,e,r,h,l).line,c=h=>f(J(e.straight,h,l)),m=c(a("q")),g=h=>({data:a(h),shape:[l,...t[h].shape.slice(1)]}),p="q_nominal"in t,d=u.line.shape.slice(0,3),w=u.line.data.map((h,y)=>h-m.data[y]);return{times:{data:K(n,1,o),shape:[l]},line:u.line,rigid:m,roots:u.roots,reference:p?f(a("q_nominal")):null,referenceRigid:p?c(a("q_nominal")):null,colours:[...i,{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:ft(w,3),shape:d}}],tip:g("tip"),tipReference:p?g("tip_nominal"):null,contact:e.contactPoint<0?null:{force:g("contact_force"),at:io(e,t,o),surface:so(e,r.surface)}}}function so({surface:s},e){let r=[e[0],e[1],e[2]];return s?.kind==="plane"?{...s,position:r}:s?{...s,center:r,radius:e[3]}:void 0}function io(s,e,r){let t=e.position.shape[1],n=K(e.position.data,3*t,r),o=new Float64Array(3*r.length);for(let i=0;i<r.length;i+=1)for(let a=0;a<3;a+=1)o[3*i+a]=n[3*(i*t+s.contactPoint)+a];return{data:o,shape:[r.length,3]}}function Rt(s,e,r,t,n){let[o,i]=[e.links.length,e.stations.data.length],a=new Float64Array(t.length/n),l=new Float64Array(n*o*i*3),u=new Float64Array(n*o*4),f=e.links.map(({name:c})=>e.carried.lines.find(m=>m.name===c)??null);return Jt(s,r,{q:t,v:a,a,base:j(e.base)},n,(c,m,g)=>{e.links.forEach(({name:p},d)=>{let w=f[d],h=(g*o+d)*4,y=Xt(c[p],m,e,w);u.set(lo(w?y.subarray(w.at.rotation[0]):y),h),g&&ao(u,h,4*o);for(let b=0;b<i;b+=1){let A=((g*o+d)*i+b)*3;for(let F=0;F<3;F+=1)l[A+F]=w?y[e.carried.shown.data[b]*w.width+w.at.position[0]+F]:y[9+F]+e.stations.data[b]*(y[12+F]-y[9+F])}})}),{line:{data:l,shape:[n,o,i,3]},roots:{data:u,shape:[n,o,4]}}}function ao(s,e,r){let t=0;for(let n=e;n<e+4;n+=1)t+=s[n]*s[n-r];if(t<0)for(let n=e;n<e+4;n+=1)s[n]*=-1}function lo(s){let e=s[0]+s[4]+s[8];if(e>0){let t=2*Math.sqrt(1+e);return[(s[7]-s[5])/t,(s[2]-s[6])/t,(s[3]-s[1])/t,t/4]}if(s[0]>s[4]&&s[0]>s[8]){let t=2*Math.sqrt(1+s[0]-s[4]-s[8]);return[t/4,(s[1]+s[3])/t,(s[2]+s[6])/t,(s[7]-s[5])/t]}if(s[4]>s[8]){let t=2*Math.sqrt(1+s[4]-s[0]-s[8]);return[(s[1]+s[3])/t,t/4,(s[5]+s[7])/t,(s[2]-s[6])/t]}let r=2*Math.sqrt(1+s[8]-s[0]-s[4]);return[(s[2]+s[6])/r,(s[5]+s[7])/r,r/4,(s[3]-s[1])/r]}var uo=Object.prototype.toString;function T(s){let e=uo.call(s);return e.endsWith("Array]")&&!e.includes("Big")}function Zt(s,e={}){if(!T(s))throw new TypeError("input must be an array");if(s.length===0)throw new TypeError("input must not be empty");let{fromIndex:r=0,toIndex:t=s.length}=e;if(r<0||r>=s.length||!Number.isInteger(r))throw new Error("fromIndex must be a positive integer smaller than length");if(t<=r||t>s.length||!Number.isInteger(t))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let n=s[r];for(let o=r+1;o<t;o++)s[o]>n&&(n=s[o]);return n}function Vt(s,e={}){if(!T(s))throw new TypeError("input must be an array");if(s.length===0)throw new TypeError("input must not be empty");let{fromIndex:r=0,toIndex:t=s.length}=e;if(r<0||r>=s.length||!Number.isInteger(r))throw new Error("fromIndex must be a positive integer smaller than length");if(t<=r||t>s.length||!Number.isInteger(t))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let n=s[r];for(let o=r+1;o<t;o++)s[o]<n&&(n=s[o]);return n}function Lt(s,e={}){if(T(s)){if(s.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let r;if(e.output!==void 0){if(!T(e.output))throw new TypeError("output option must be an array if specified");r=e.output}else r=new Array(s.length);let t=Vt(s),n=Zt(s);if(t===n)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:o=e.autoMinMax?t:0,max:i=e.autoMinMax?n:1}=e;if(o>=i)throw new RangeError("min option must be smaller than max option");let a=(i-o)/(n-t);for(let l=0;l<s.length;l++)r[l]=(s[l]-t)*a+o;return r}var Ot=" ".repeat(2),ze=" ".repeat(4);function Ce(){return Ht(this)}function Ht(s,e={}){let{maxRows:r=15,maxColumns:t=10,maxNumSize:n=8,padMinus:o="auto"}=e;return`${s.constructor.name} {\n${Ot}[\n${ze}${co(s,r,t,n,o)}\n${Ot}]\n${Ot}rows: ${s.rows}\n${Ot}columns: ${s.columns}\n}`}function co(s,e,r,t,n){let{rows:o,columns:i}=s,a=Math.min(o,e),l=Math.min(i,r),u=[];if(n==="auto"){n=!1;t:for(let f=0;f<a;f++)for(let c=0;c<l;c++)if(s.get(f,c)<0){n=!0;break t}}for(let f=0;f<a;f++){let c=[];for(let m=0;m<l;m++)c.push(fo(s.get(f,m),t,n));u.push(`${c.join(" ")}`)}return l!==i&&(u[u.length-1]+=` ... ${i-r} more columns`),a!==o&&u.push(`... ${o-e} more rows`),u.join(`\n${ze}`)}function fo(s,e,r){return(s>=0&&r?` ${Pe(s,e-1)}`:Pe(s,e)).padEnd(e)}function Pe(s,e){let r=s.toString();if(r.length<=e)return r;let t=s.toFixed(e);if(t.length>e&&(t=s.toFixed(Math.max(0,e-(t.length-e)))),t.length<=e&&!t.startsWith("0.000")&&!t.startsWith("-0.000"))return t;let n=s.toExponential(e);return n.length>e&&(n=s.toExponential(Math.max(0,e-(n.length-e)))),n.slice(0)}function We(s,e){s.prototype.add=function(t){return typeof t=="number"?this.addS(t):this.addM(t)},s.prototype.addS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)+t);return this},s.prototype.addM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)+t.get(n,o));return this},s.add=function(t,n){return new e(t).add(n)},s.prototype.sub=function(t){return typeof t=="number"?this.subS(t):this.subM(t)},s.prototype.subS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)-t);return this},s.prototype.subM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)-t.get(n,o));return this},s.sub=function(t,n){return new e(t).sub(n)},s.prototype.subtract=s.prototype.sub,s.prototype.subtractS=s.prototype.subS,s.prototype.subtractM=s.prototype.subM,s.subtract=s.sub,s.prototype.mul=function(t){return typeof t=="number"?this.mulS(t):this.mulM(t)},s.prototype.mulS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)*t);return this},s.prototype.mulM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)*t.get(n,o));return this},s.mul=function(t,n){return new e(t).mul(n)},s.prototype.multiply=s.prototype.mul,s.prototype.multiplyS=s.prototype.mulS,s.prototype.multiplyM=s.prototype.mulM,s.multiply=s.mul,s.prototype.div=function(t){return typeof t=="number"?this.divS(t):this.divM(t)},s.prototype.divS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)/t);return this},s.prototype.divM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)/t.get(n,o));return this},s.div=function(t,n){return new e(t).div(n)},s.prototype.divide=s.prototype.div,s.prototype.divideS=s.prototype.divS,s.prototype.divideM=s.prototype.divM,s.divide=s.div,s.prototype.mod=function(t){return typeof t=="number"?this.modS(t):this.modM(t)},s.prototype.modS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)%t);return this},s.prototype.modM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)%t.get(n,o));return this},s.mod=function(t,n){return new e(t).mod(n)},s.prototype.modulus=s.prototype.mod,s.prototype.modulusS=s.prototype.modS,s.prototype.modulusM=s.prototype.modM,s.modulus=s.mod,s.prototype.and=function(t){return typeof t=="number"?this.andS(t):this.andM(t)},s.prototype.andS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)&t);return this},s.prototype.andM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)&t.get(n,o));return this},s.and=function(t,n){return new e(t).and(n)},s.prototype.or=function(t){return typeof t=="number"?this.orS(t):this.orM(t)},s.prototype.orS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)|t);return this},s.prototype.orM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)|t.get(n,o));return this},s.or=function(t,n){return new e(t).or(n)},s.prototype.xor=function(t){return typeof t=="number"?this.xorS(t):this.xorM(t)},s.prototype.xorS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)^t);return this},s.prototype.xorM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)^t.get(n,o));return this},s.xor=function(t,n){return new e(t).xor(n)},s.prototype.leftShift=function(t){return typeof t=="number"?this.leftShiftS(t):this.leftShiftM(t)},s.prototype.leftShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)<<t);return this},s.prototype.leftShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)<<t.get(n,o));return this},s.leftShift=function(t,n){return new e(t).leftShift(n)},s.prototype.signPropagatingRightShift=function(t){return typeof t=="number"?this.signPropagatingRightShiftS(t):this.signPropagatingRightShiftM(t)},s.prototype.signPropagatingRightShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>t);return this},s.prototype.signPropagatingRightShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>t.get(n,o));return this},s.signPropagatingRightShift=function(t,n){return new e(t).signPropagatingRightShift(n)},s.prototype.rightShift=function(t){return typeof t=="number"?this.rightShiftS(t):this.rightShiftM(t)},s.prototype.rightShiftS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>>t);return this},s.prototype.rightShiftM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)>>>t.get(n,o));return this},s.rightShift=function(t,n){return new e(t).rightShift(n)},s.prototype.zeroFillRightShift=s.prototype.rightShift,s.prototype.zeroFillRightShiftS=s.prototype.rightShiftS,s.prototype.zeroFillRightShiftM=s.prototype.rightShiftM,s.zeroFillRightShift=s.rightShift,s.prototype.not=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,~this.get(t,n));return this},s.not=function(t){return new e(t).not()},s.prototype.abs=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.abs(this.get(t,n)));return this},s.abs=function(t){return new e(t).abs()},s.prototype.acos=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.acos(this.get(t,n)));return this},s.acos=function(t){return new e(t).acos()},s.prototype.acosh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.acosh(this.get(t,n)));return this},s.acosh=function(t){return new e(t).acosh()},s.prototype.asin=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.asin(this.get(t,n)));return this},s.asin=function(t){return new e(t).asin()},s.prototype.asinh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.asinh(this.get(t,n)));return this},s.asinh=function(t){return new e(t).asinh()},s.prototype.atan=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.atan(this.get(t,n)));return this},s.atan=function(t){return new e(t).atan()},s.prototype.atanh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.atanh(this.get(t,n)));return this},s.atanh=function(t){return new e(t).atanh()},s.prototype.cbrt=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cbrt(this.get(t,n)));return this},s.cbrt=function(t){return new e(t).cbrt()},s.prototype.ceil=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.ceil(this.get(t,n)));return this},s.ceil=function(t){return new e(t).ceil()},s.prototype.clz32=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.clz32(this.get(t,n)));return this},s.clz32=function(t){return new e(t).clz32()},s.prototype.cos=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cos(this.get(t,n)));return this},s.cos=function(t){return new e(t).cos()},s.prototype.cosh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.cosh(this.get(t,n)));return this},s.cosh=function(t){return new e(t).cosh()},s.prototype.exp=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.exp(this.get(t,n)));return this},s.exp=function(t){return new e(t).exp()},s.prototype.expm1=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.expm1(this.get(t,n)));return this},s.expm1=function(t){return new e(t).expm1()},s.prototype.floor=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.floor(this.get(t,n)));return this},s.floor=function(t){return new e(t).floor()},s.prototype.fround=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.fround(this.get(t,n)));return this},s.fround=function(t){return new e(t).fround()},s.prototype.log=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log(this.get(t,n)));return this},s.log=function(t){return new e(t).log()},s.prototype.log1p=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log1p(this.get(t,n)));return this},s.log1p=function(t){return new e(t).log1p()},s.prototype.log10=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log10(this.get(t,n)));return this},s.log10=function(t){return new e(t).log10()},s.prototype.log2=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.log2(this.get(t,n)));return this},s.log2=function(t){return new e(t).log2()},s.prototype.round=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.round(this.get(t,n)));return this},s.round=function(t){return new e(t).round()},s.prototype.sign=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sign(this.get(t,n)));return this},s.sign=function(t){return new e(t).sign()},s.prototype.sin=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sin(this.get(t,n)));return this},s.sin=function(t){return new e(t).sin()},s.prototype.sinh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sinh(this.get(t,n)));return this},s.sinh=function(t){return new e(t).sinh()},s.prototype.sqrt=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.sqrt(this.get(t,n)));return this},s.sqrt=function(t){return new e(t).sqrt()},s.prototype.tan=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.tan(this.get(t,n)));return this},s.tan=function(t){return new e(t).tan()},s.prototype.tanh=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.tanh(this.get(t,n)));return this},s.tanh=function(t){return new e(t).tanh()},s.prototype.trunc=function(){for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.set(t,n,Math.trunc(this.get(t,n)));return this},s.trunc=function(t){return new e(t).trunc()},s.pow=function(t,n){return new e(t).pow(n)},s.prototype.pow=function(t){return typeof t=="number"?this.powS(t):this.powM(t)},s.prototype.powS=function(t){for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)**t);return this},s.prototype.powM=function(t){if(t=e.checkMatrix(t),this.rows!==t.rows||this.columns!==t.columns)throw new RangeError("Matrices dimensions must be equal");for(let n=0;n<this.rows;n++)for(let o=0;o<this.columns;o++)this.set(n,o,this.get(n,o)**t.get(n,o));return this}}function U(s,e,r){let t=r?s.rows:s.rows-1;if(e<0||e>t)throw new RangeError("Row index out of range")}function G(s,e,r){let t=r?s.columns:s.columns-1;if(e<0||e>t)throw new RangeError("Column index out of range")}function st(s,e){if(e.to1DArray&&(e=e.to1DArray()),e.length!==s.columns)throw new RangeError("vector size must be the same as the number of columns");return e}function it(s,e){if(e.to1DArray&&(e=e.to1DArray()),e.length!==s.rows)throw new RangeError("vector size must be the same as the number of rows");return e}function De(s,e){if(!T(e))throw new TypeError("row indices must be an array");for(let r=0;r<e.length;r++)if(e[r]<0||e[r]>=s.rows)throw new RangeError("row indices are out of range")}function Ue(s,e){if(!T(e))throw new TypeError("column indices must be an array");for(let r=0;r<e.length;r++)if(e[r]<0||e[r]>=s.columns)throw new RangeError("column indices are out of range")}function te(s,e,r,t,n){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(It("startRow",e),It("endRow",r),It("startColumn",t),It("endColumn",n),e>r||t>n||e<0||e>=s.rows||r<0||r>=s.rows||t<0||t>=s.columns||n<0||n>=s.columns)throw new RangeError("Submatrix indices are out of range")}function yt(s,e=0){let r=[];for(let t=0;t<s;t++)r.push(e);return r}function It(s,e){if(typeof e!="number")throw new TypeError(`${s} must be a number`)}function at(s){if(s.isEmpty())throw new Error("Empty matrix has no elements to index")}function Ge(s){let e=yt(s.rows);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[r]+=s.get(r,t);return e}function Qe(s){let e=yt(s.columns);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[t]+=s.get(r,t);return e}function Ke(s){let e=0;for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)e+=s.get(r,t);return e}function Ye(s){let e=yt(s.rows,1);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[r]*=s.get(r,t);return e}function Je(s){let e=yt(s.columns,1);for(let r=0;r<s.rows;++r)for(let t=0;t<s.columns;++t)e[t]*=s.get(r,t);return e}function Xe(s){let e=1;for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)e*=s.get(r,t);return e}function Ze(s,e,r){let t=s.rows,n=s.columns,o=[];for(let i=0;i<t;i++){let a=0,l=0,u=0;for(let f=0;f<n;f++)u=s.get(i,f)-r[i],a+=u,l+=u*u;e?o.push((l-a*a/n)/(n-1)):o.push((l-a*a/n)/n)}return o}function Ve(s,e,r){let t=s.rows,n=s.columns,o=[];for(let i=0;i<n;i++){let a=0,l=0,u=0;for(let f=0;f<t;f++)u=s.get(f,i)-r[i],a+=u,l+=u*u;e?o.push((l-a*a/t)/(t-1)):o.push((l-a*a/t)/t)}return o}function He(s,e,r){let t=s.rows,n=s.columns,o=t*n,i=0,a=0,l=0;for(let u=0;u<t;u++)for(let f=0;f<n;f++)l=s.get(u,f)-r,i+=l,a+=l*l;return e?(a-i*i/o)/(o-1):(a-i*i/o)/o}function tr(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e[r])}function er(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e[t])}function rr(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)-e)}function nr(s){let e=[];for(let r=0;r<s.rows;r++){let t=0;for(let n=0;n<s.columns;n++)t+=s.get(r,n)**2/(s.columns-1);e.push(Math.sqrt(t))}return e}function or(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e[r])}function sr(s){let e=[];for(let r=0;r<s.columns;r++){let t=0;for(let n=0;n<s.rows;n++)t+=s.get(n,r)**2/(s.rows-1);e.push(Math.sqrt(t))}return e}function ir(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e[t])}function ar(s){let e=s.size-1,r=0;for(let t=0;t<s.columns;t++)for(let n=0;n<s.rows;n++)r+=s.get(n,t)**2/e;return Math.sqrt(r)}function lr(s,e){for(let r=0;r<s.rows;r++)for(let t=0;t<s.columns;t++)s.set(r,t,s.get(r,t)/e)}var R=class s{static from1DArray(e,r,t){if(e*r!==t.length)throw new RangeError("data length does not match given dimensions");let o=new v(e,r);for(let i=0;i<e;i++)for(let a=0;a<r;a++)o.set(i,a,t[i*r+a]);return o}static rowVector(e){let r=new v(1,e.length);for(let t=0;t<e.length;t++)r.set(0,t,e[t]);return r}static columnVector(e){let r=new v(e.length,1);for(let t=0;t<e.length;t++)r.set(t,0,e[t]);return r}static zeros(e,r){return new v(e,r)}static ones(e,r){return new v(e,r).fill(1)}static rand(e,r,t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{random:n=Math.random}=t,o=new v(e,r);for(let i=0;i<e;i++)for(let a=0;a<r;a++)o.set(i,a,n());return o}static randInt(e,r,t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:n=0,max:o=1e3,random:i=Math.random}=t;if(!Number.isInteger(n))throw new TypeError("min must be an integer");if(!Number.isInteger(o))throw new TypeError("max must be an integer");if(n>=o)throw new RangeError("min must be smaller than max");let a=o-n,l=new v(e,r);for(let u=0;u<e;u++)for(let f=0;f<r;f++){let c=n+Math.round(i()*a);l.set(u,f,c)}return l}static eye(e,r,t){r===void 0&&(r=e),t===void 0&&(t=1);let n=Math.min(e,r),o=this.zeros(e,r);for(let i=0;i<n;i++)o.set(i,i,t);return o}static diag(e,r,t){let n=e.length;r===void 0&&(r=n),t===void 0&&(t=r);let o=Math.min(n,r,t),i=this.zeros(r,t);for(let a=0;a<o;a++)i.set(a,a,e[a]);return i}static min(e,r){e=this.checkMatrix(e),r=this.checkMatrix(r);let t=e.rows,n=e.columns,o=new v(t,n);for(let i=0;i<t;i++)for(let a=0;a<n;a++)o.set(i,a,Math.min(e.get(i,a),r.get(i,a)));return o}static max(e,r){e=this.checkMatrix(e),r=this.checkMatrix(r);let t=e.rows,n=e.columns,o=new this(t,n);for(let i=0;i<t;i++)for(let a=0;a<n;a++)o.set(i,a,Math.max(e.get(i,a),r.get(i,a)));return o}static checkMatrix(e){return s.isMatrix(e)?e:new v(e)}static isMatrix(e){return e!=null&&e.klass==="Matrix"}get size(){return this.rows*this.columns}apply(e){if(typeof e!="function")throw new TypeError("callback must be a function");for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.call(this,r,t);return this}applyAlongAxis(e,r){if(typeof e!="function")throw new TypeError("callback must be a function");let t=[];switch(r){case"row":{for(let n=0;n<this.rows;n++)t.push(e.call(this,this.getRow(n),n));break}case"column":{for(let n=0;n<this.columns;n++)t.push(e.call(this,this.getColumn(n),n));break}default:throw new Error(`invalid option: ${r}`)}return t}to1DArray(){let e=[];for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.push(this.get(r,t));return e}to2DArray(){let e=[];for(let r=0;r<this.rows;r++){e.push([]);for(let t=0;t<this.columns;t++)e[r].push(this.get(r,t))}return e}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let e=0;e<this.rows;e++)for(let r=0;r<=e;r++)if(this.get(e,r)!==this.get(r,e))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let e=0;e<this.rows;e++)if(this.get(e,e)!==0)return!1;return!0}isEchelonForm(){let e=0,r=0,t=-1,n=!0,o=!1;for(;e<this.rows&&n;){for(r=0,o=!1;r<this.columns&&o===!1;)this.get(e,r)===0?r++:this.get(e,r)===1&&r>t?(o=!0,t=r):(n=!1,o=!0);e++}return n}isReducedEchelonForm(){let e=0,r=0,t=-1,n=!0,o=!1;for(;e<this.rows&&n;){for(r=0,o=!1;r<this.columns&&o===!1;)this.get(e,r)===0?r++:this.get(e,r)===1&&r>t?(o=!0,t=r):(n=!1,o=!0);for(let i=r+1;i<this.rows;i++)this.get(e,i)!==0&&(n=!1);e++}return n}echelonForm(){let e=this.clone(),r=0,t=0;for(;r<e.rows&&t<e.columns;){let n=r;for(let o=r;o<e.rows;o++)e.get(o,t)>e.get(n,t)&&(n=o);if(e.get(n,t)===0)t++;else{e.swapRows(r,n);let o=e.get(r,t);for(let i=t;i<e.columns;i++)e.set(r,i,e.get(r,i)/o);for(let i=r+1;i<e.rows;i++){let a=e.get(i,t)/e.get(r,t);e.set(i,t,0);for(let l=t+1;l<e.columns;l++)e.set(i,l,e.get(i,l)-e.get(r,l)*a)}r++,t++}}return e}reducedEchelonForm(){let e=this.echelonForm(),r=e.columns,t=e.rows,n=t-1;for(;n>=0;)if(e.maxRow(n)===0)n--;else{let o=0,i=!1;for(;o<t&&i===!1;)e.get(n,o)===1?i=!0:o++;for(let a=0;a<n;a++){let l=e.get(a,o);for(let u=o;u<r;u++){let f=e.get(a,u)-l*e.get(n,u);e.set(a,u,f)}}n--}return e}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{rows:r=1,columns:t=1}=e;if(!Number.isInteger(r)||r<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(t)||t<=0)throw new TypeError("columns must be a positive integer");let n=new v(this.rows*r,this.columns*t);for(let o=0;o<r;o++)for(let i=0;i<t;i++)n.setSubMatrix(this,this.rows*o,this.columns*i);return n}fill(e){for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,e);return this}neg(){return this.mulS(-1)}getRow(e){U(this,e);let r=[];for(let t=0;t<this.columns;t++)r.push(this.get(e,t));return r}getRowVector(e){return v.rowVector(this.getRow(e))}setRow(e,r){U(this,e),r=st(this,r);for(let t=0;t<this.columns;t++)this.set(e,t,r[t]);return this}swapRows(e,r){U(this,e),U(this,r);for(let t=0;t<this.columns;t++){let n=this.get(e,t);this.set(e,t,this.get(r,t)),this.set(r,t,n)}return this}getColumn(e){G(this,e);let r=[];for(let t=0;t<this.rows;t++)r.push(this.get(t,e));return r}getColumnVector(e){return v.columnVector(this.getColumn(e))}setColumn(e,r){G(this,e),r=it(this,r);for(let t=0;t<this.rows;t++)this.set(t,e,r[t]);return this}swapColumns(e,r){G(this,e),G(this,r);for(let t=0;t<this.rows;t++){let n=this.get(t,e);this.set(t,e,this.get(t,r)),this.set(t,r,n)}return this}addRowVector(e){e=st(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)+e[t]);return this}subRowVector(e){e=st(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)-e[t]);return this}mulRowVector(e){e=st(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)*e[t]);return this}divRowVector(e){e=st(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)/e[t]);return this}addColumnVector(e){e=it(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)+e[r]);return this}subColumnVector(e){e=it(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)-e[r]);return this}mulColumnVector(e){e=it(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)*e[r]);return this}divColumnVector(e){e=it(this,e);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)this.set(r,t,this.get(r,t)/e[r]);return this}mulRow(e,r){U(this,e);for(let t=0;t<this.columns;t++)this.set(e,t,this.get(e,t)*r);return this}mulColumn(e,r){G(this,e);for(let t=0;t<this.rows;t++)this.set(t,e,this.get(t,e)*r);return this}max(e){if(this.isEmpty())return NaN;switch(e){case"row":{let r=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>r[t]&&(r[t]=this.get(t,n));return r}case"column":{let r=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>r[n]&&(r[n]=this.get(t,n));return r}case void 0:{let r=this.get(0,0);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>r&&(r=this.get(t,n));return r}default:throw new Error(`invalid option: ${e}`)}}maxIndex(){at(this);let e=this.get(0,0),r=[0,0];for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)>e&&(e=this.get(t,n),r[0]=t,r[1]=n);return r}min(e){if(this.isEmpty())return NaN;switch(e){case"row":{let r=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<r[t]&&(r[t]=this.get(t,n));return r}case"column":{let r=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<r[n]&&(r[n]=this.get(t,n));return r}case void 0:{let r=this.get(0,0);for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<r&&(r=this.get(t,n));return r}default:throw new Error(`invalid option: ${e}`)}}minIndex(){at(this);let e=this.get(0,0),r=[0,0];for(let t=0;t<this.rows;t++)for(let n=0;n<this.columns;n++)this.get(t,n)<e&&(e=this.get(t,n),r[0]=t,r[1]=n);return r}maxRow(e){if(U(this,e),this.isEmpty())return NaN;let r=this.get(e,0);for(let t=1;t<this.columns;t++)this.get(e,t)>r&&(r=this.get(e,t));return r}maxRowIndex(e){U(this,e),at(this);let r=this.get(e,0),t=[e,0];for(let n=1;n<this.columns;n++)this.get(e,n)>r&&(r=this.get(e,n),t[1]=n);return t}minRow(e){if(U(this,e),this.isEmpty())return NaN;let r=this.get(e,0);for(let t=1;t<this.columns;t++)this.get(e,t)<r&&(r=this.get(e,t));return r}minRowIndex(e){U(this,e),at(this);let r=this.get(e,0),t=[e,0];for(let n=1;n<this.columns;n++)this.get(e,n)<r&&(r=this.get(e,n),t[1]=n);return t}maxColumn(e){if(G(this,e),this.isEmpty())return NaN;let r=this.get(0,e);for(let t=1;t<this.rows;t++)this.get(t,e)>r&&(r=this.get(t,e));return r}maxColumnIndex(e){G(this,e),at(this);let r=this.get(0,e),t=[0,e];for(let n=1;n<this.rows;n++)this.get(n,e)>r&&(r=this.get(n,e),t[0]=n);return t}minColumn(e){if(G(this,e),this.isEmpty())return NaN;let r=this.get(0,e);for(let t=1;t<this.rows;t++)this.get(t,e)<r&&(r=this.get(t,e));return r}minColumnIndex(e){G(this,e),at(this);let r=this.get(0,e),t=[0,e];for(let n=1;n<this.rows;n++)this.get(n,e)<r&&(r=this.get(n,e),t[0]=n);return t}diag(){let e=Math.min(this.rows,this.columns),r=[];for(let t=0;t<e;t++)r.push(this.get(t,t));return r}norm(e="frobenius"){switch(e){case"max":return v.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${e}`)}}cumulativeSum(){let e=0;for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e+=this.get(r,t),this.set(r,t,e);return this}dot(e){s.isMatrix(e)&&(e=e.to1DArray());let r=this.to1DArray();if(r.length!==e.length)throw new RangeError("vectors do not have the same size");let t=0;for(let n=0;n<r.length;n++)t+=r[n]*e[n];return t}mmul(e){e=v.checkMatrix(e);let r=this.rows,t=this.columns,n=e.columns,o=new v(r,n),i=new Float64Array(t);for(let a=0;a<n;a++){for(let l=0;l<t;l++)i[l]=e.get(l,a);for(let l=0;l<r;l++){let u=0;for(let f=0;f<t;f++)u+=this.get(l,f)*i[f];o.set(l,a,u)}}return o}gram(){let e=this.rows,r=this.columns,t=new Float64Array(r*r);for(let o=0;o<e;o++)for(let i=0;i<r;i++){let a=this.get(o,i);if(a===0)continue;let l=i*r;for(let u=i;u<r;u++)t[l+u]+=a*this.get(o,u)}let n=new v(r,r);for(let o=0;o<r;o++){let i=o*r;for(let a=o;a<r;a++){let l=t[i+a];n.set(o,a,l),n.set(a,o,l)}}return n}transposeMultiply(e){if(e=v.checkMatrix(e),this.rows!==e.rows)throw new RangeError("the number of rows of the two matrices must be equal");let r=this.columns,t=e.columns,n=new v(r,t),o=new Float64Array(t);for(let i=0;i<this.rows;i++){for(let a=0;a<t;a++)o[a]=e.get(i,a);for(let a=0;a<r;a++){let l=this.get(i,a);if(l===0)continue;let u=n.data[a];for(let f=0;f<t;f++)u[f]+=l*o[f]}}return n}mmulByTranspose(e){let r=this.rows,t=this.columns;if(e!==void 0&&e.length!==t)throw new RangeError("scale must have one value per column");let n=new v(r,r),o=new Float64Array(t);for(let i=0;i<r;i++){if(e===void 0)for(let a=0;a<t;a++)o[a]=this.get(i,a);else for(let a=0;a<t;a++)o[a]=e[a]*this.get(i,a);for(let a=i;a<r;a++){let l=0;for(let u=0;u<t;u++)l+=this.get(a,u)*o[u];n.set(a,i,l),n.set(i,a,l)}}return n}mpow(e){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(e)||e<0)throw new RangeError("Exponent must be a non-negative integer");let r=v.eye(this.rows),t=this;for(let n=e;n>=1;n/=2)(n&1)!==0&&(r=r.mmul(t)),t=t.mmul(t);return r}strassen2x2(e){e=v.checkMatrix(e);let r=new v(2,2),t=this.get(0,0),n=e.get(0,0),o=this.get(0,1),i=e.get(0,1),a=this.get(1,0),l=e.get(1,0),u=this.get(1,1),f=e.get(1,1),c=(t+u)*(n+f),m=(a+u)*n,g=t*(i-f),p=u*(l-n),d=(t+o)*f,w=(a-t)*(n+i),h=(o-u)*(l+f),y=c+p-d+h,b=g+d,A=m+p,F=c-m+g+w;return r.set(0,0,y),r.set(0,1,b),r.set(1,0,A),r.set(1,1,F),r}strassen3x3(e){e=v.checkMatrix(e);let r=new v(3,3),t=this.get(0,0),n=this.get(0,1),o=this.get(0,2),i=this.get(1,0),a=this.get(1,1),l=this.get(1,2),u=this.get(2,0),f=this.get(2,1),c=this.get(2,2),m=e.get(0,0),g=e.get(0,1),p=e.get(0,2),d=e.get(1,0),w=e.get(1,1),h=e.get(1,2),y=e.get(2,0),b=e.get(2,1),A=e.get(2,2),F=(t+n+o-i-a-f-c)*w,M=(t-i)*(-g+w),E=a*(-m+g+d-w-h-y+A),S=(-t+i+a)*(m-g+w),x=(i+a)*(-m+g),L=t*m,B=(-t+u+f)*(m-p+h),I=(-t+u)*(p-h),N=(u+f)*(-m+p),Z=(t+n+o-a-l-u-f)*h,$=f*(-m+p+d-w-h-y+b),P=(-o+f+c)*(w+y-b),bt=(o-c)*(w-b),V=o*y,ut=(f+c)*(-y+b),z=(-o+a+l)*(h+y-A),ge=(o-l)*(h-A),de=(a+l)*(-y+A),Vr=n*d,Hr=l*b,tn=i*p,en=u*g,rn=c*A,nn=L+V+Vr,on=F+S+x+L+P+V+ut,sn=L+B+N+Z+V+z+de,an=M+E+S+L+V+z+ge,ln=M+S+x+L+Hr,un=V+z+ge+de+tn,cn=L+B+I+$+P+bt+V,fn=P+bt+V+ut+en,mn=L+B+I+N+rn;return r.set(0,0,nn),r.set(0,1,on),r.set(0,2,sn),r.set(1,0,an),r.set(1,1,ln),r.set(1,2,un),r.set(2,0,cn),r.set(2,1,fn),r.set(2,2,mn),r}mmulStrassen(e){e=v.checkMatrix(e);let r=this.clone(),t=r.rows,n=r.columns,o=e.rows,i=e.columns;n!==o&&console.warn(`Multiplying ${t} x ${n} and ${o} x ${i} matrix: dimensions do not match.`);function a(c,m,g){let p=c.rows,d=c.columns;if(p===m&&d===g)return c;{let w=s.zeros(m,g);return w=w.setSubMatrix(c,0,0),w}}let l=Math.max(t,o),u=Math.max(n,i);r=a(r,l,u),e=a(e,l,u);function f(c,m,g,p){if(g<=512||p<=512)return c.mmul(m);g%2===1&&p%2===1?(c=a(c,g+1,p+1),m=a(m,g+1,p+1)):g%2===1?(c=a(c,g+1,p),m=a(m,g+1,p)):p%2===1&&(c=a(c,g,p+1),m=a(m,g,p+1));let d=parseInt(c.rows/2,10),w=parseInt(c.columns/2,10),h=c.subMatrix(0,d-1,0,w-1),y=m.subMatrix(0,d-1,0,w-1),b=c.subMatrix(0,d-1,w,c.columns-1),A=m.subMatrix(0,d-1,w,m.columns-1),F=c.subMatrix(d,c.rows-1,0,w-1),M=m.subMatrix(d,m.rows-1,0,w-1),E=c.subMatrix(d,c.rows-1,w,c.columns-1),S=m.subMatrix(d,m.rows-1,w,m.columns-1),x=f(s.add(h,E),s.add(y,S),d,w),L=f(s.add(F,E),y,d,w),B=f(h,s.sub(A,S),d,w),I=f(E,s.sub(M,y),d,w),N=f(s.add(h,b),S,d,w),Z=f(s.sub(F,h),s.add(y,A),d,w),$=f(s.sub(b,E),s.add(M,S),d,w),P=s.add(x,I);P.sub(N),P.add($);let bt=s.add(B,N),V=s.add(L,I),ut=s.sub(x,L);ut.add(B),ut.add(Z);let z=s.zeros(2*P.rows,2*P.columns);return z=z.setSubMatrix(P,0,0),z=z.setSubMatrix(bt,P.rows,0),z=z.setSubMatrix(V,0,P.columns),z=z.setSubMatrix(ut,P.rows,P.columns),z.subMatrix(0,g-1,0,p-1)}return f(r,e,l,u)}scaleRows(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{min:r=0,max:t=1}=e;if(!Number.isFinite(r))throw new TypeError("min must be a number");if(!Number.isFinite(t))throw new TypeError("max must be a number");if(r>=t)throw new RangeError("min must be smaller than max");let n=new v(this.rows,this.columns);for(let o=0;o<this.rows;o++){let i=this.getRow(o);i.length>0&&Lt(i,{min:r,max:t,output:i}),n.setRow(o,i)}return n}scaleColumns(e={}){if(typeof e!="object")throw new TypeError("options must be an object");let{min:r=0,max:t=1}=e;if(!Number.isFinite(r))throw new TypeError("min must be a number");if(!Number.isFinite(t))throw new TypeError("max must be a number");if(r>=t)throw new RangeError("min must be smaller than max");let n=new v(this.rows,this.columns);for(let o=0;o<this.columns;o++){let i=this.getColumn(o);i.length&&Lt(i,{min:r,max:t,output:i}),n.setColumn(o,i)}return n}flipRows(){let e=Math.ceil(this.columns/2);for(let r=0;r<this.rows;r++)for(let t=0;t<e;t++){let n=this.get(r,t),o=this.get(r,this.columns-1-t);this.set(r,t,o),this.set(r,this.columns-1-t,n)}return this}flipColumns(){let e=Math.ceil(this.rows/2);for(let r=0;r<this.columns;r++)for(let t=0;t<e;t++){let n=this.get(t,r),o=this.get(this.rows-1-t,r);this.set(t,r,o),this.set(this.rows-1-t,r,n)}return this}kroneckerProduct(e){e=v.checkMatrix(e);let r=this.rows,t=this.columns,n=e.rows,o=e.columns,i=new v(r*n,t*o);for(let a=0;a<r;a++)for(let l=0;l<t;l++)for(let u=0;u<n;u++)for(let f=0;f<o;f++)i.set(n*a+u,o*l+f,this.get(a,l)*e.get(u,f));return i}kroneckerSum(e){if(e=v.checkMatrix(e),!this.isSquare()||!e.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let r=this.rows,t=e.rows,n=this.kroneckerProduct(v.eye(t,t)),o=v.eye(r,r).kroneckerProduct(e);return n.add(o)}transpose(){let e=new v(this.columns,this.rows);for(let r=0;r<this.rows;r++)for(let t=0;t<this.columns;t++)e.set(t,r,this.get(r,t));return e}sortRows(e=ur){for(let r=0;r<this.rows;r++)this.setRow(r,this.getRow(r).sort(e));return this}sortColumns(e=ur){for(let r=0;r<this.columns;r++)this.setColumn(r,this.getColumn(r).sort(e));return this}subMatrix(e,r,t,n){te(this,e,r,t,n);let o=new v(r-e+1,n-t+1);for(let i=e;i<=r;i++)for(let a=t;a<=n;a++)o.set(i-e,a-t,this.get(i,a));return o}subMatrixRow(e,r,t){if(r===void 0&&(r=0),t===void 0&&(t=this.columns-1),r>t||r<0||r>=this.columns||t<0||t>=this.columns)throw new RangeError("Argument out of range");let n=new v(e.length,t-r+1);for(let o=0;o<e.length;o++)for(let i=r;i<=t;i++){if(e[o]<0||e[o]>=this.rows)throw new RangeError(`Row index out of range: ${e[o]}`);n.set(o,i-r,this.get(e[o],i))}return n}subMatrixColumn(e,r,t){if(r===void 0&&(r=0),t===void 0&&(t=this.rows-1),r>t||r<0||r>=this.rows||t<0||t>=this.rows)throw new RangeError("Argument out of range");let n=new v(t-r+1,e.length);for(let o=0;o<e.length;o++)for(let i=r;i<=t;i++){if(e[o]<0||e[o]>=this.columns)throw new RangeError(`Column index out of range: ${e[o]}`);n.set(i-r,o,this.get(i,e[o]))}return n}setSubMatrix(e,r,t){if(e=v.checkMatrix(e),e.isEmpty())return this;let n=r+e.rows-1,o=t+e.columns-1;te(this,r,n,t,o);for(let i=0;i<e.rows;i++)for(let a=0;a<e.columns;a++)this.set(r+i,t+a,e.get(i,a));return this}concat(e,r="row"){switch(e=v.checkMatrix(e),r){case"row":{if(this.columns!==e.columns)throw new RangeError("both matrices must have the same number of columns");let t=new v(this.rows+e.rows,this.columns);return t.setSubMatrix(this,0,0),t.setSubMatrix(e,this.rows,0),t}case"column":{if(this.rows!==e.rows)throw new RangeError("both matrices must have the same number of rows");let t=new v(this.rows,this.columns+e.columns);return t.setSubMatrix(this,0,0),t.setSubMatrix(e,0,this.columns),t}default:throw new Error(`invalid option: ${r}`)}}selection(e,r){De(this,e),Ue(this,r);let t=new v(e.length,r.length);for(let n=0;n<e.length;n++){let o=e[n];for(let i=0;i<r.length;i++){let a=r[i];t.set(n,i,this.get(o,a))}}return t}trace(){let e=Math.min(this.rows,this.columns),r=0;for(let t=0;t<e;t++)r+=this.get(t,t);return r}clone(){return this.constructor.copy(this,new v(this.rows,this.columns))}static copy(e,r){for(let[t,n,o]of e.entries())r.set(t,n,o);return r}sum(e){switch(e){case"row":return Ge(this);case"column":return Qe(this);case void 0:return Ke(this);default:throw new Error(`invalid option: ${e}`)}}product(e){switch(e){case"row":return Ye(this);case"column":return Je(this);case void 0:return Xe(this);default:throw new Error(`invalid option: ${e}`)}}mean(e){let r=this.sum(e);switch(e){case"row":{for(let t=0;t<this.rows;t++)r[t]/=this.columns;return r}case"column":{for(let t=0;t<this.columns;t++)r[t]/=this.rows;return r}case void 0:return r/this.size;default:throw new Error(`invalid option: ${e}`)}}variance(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let{unbiased:t=!0,mean:n=this.mean(e)}=r;if(typeof t!="boolean")throw new TypeError("unbiased must be a boolean");switch(e){case"row":{if(!T(n))throw new TypeError("mean must be an array");return Ze(this,t,n)}case"column":{if(!T(n))throw new TypeError("mean must be an array");return Ve(this,t,n)}case void 0:{if(typeof n!="number")throw new TypeError("mean must be a number");return He(this,t,n)}default:throw new Error(`invalid option: ${e}`)}}standardDeviation(e,r){typeof e=="object"&&(r=e,e=void 0);let t=this.variance(e,r);if(e===void 0)return Math.sqrt(t);for(let n=0;n<t.length;n++)t[n]=Math.sqrt(t[n]);return t}center(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let{center:t=this.mean(e)}=r;switch(e){case"row":{if(!T(t))throw new TypeError("center must be an array");return tr(this,t),this}case"column":{if(!T(t))throw new TypeError("center must be an array");return er(this,t),this}case void 0:{if(typeof t!="number")throw new TypeError("center must be a number");return rr(this,t),this}default:throw new Error(`invalid option: ${e}`)}}scale(e,r={}){if(typeof e=="object"&&(r=e,e=void 0),typeof r!="object")throw new TypeError("options must be an object");let t=r.scale;switch(e){case"row":{if(t===void 0)t=nr(this);else if(!T(t))throw new TypeError("scale must be an array");return or(this,t),this}case"column":{if(t===void 0)t=sr(this);else if(!T(t))throw new TypeError("scale must be an array");return ir(this,t),this}case void 0:{if(t===void 0)t=ar(this);else if(typeof t!="number")throw new TypeError("scale must be a number");return lr(this,t),this}default:throw new Error(`invalid option: ${e}`)}}toString(e){return Ht(this,e)}[Symbol.iterator](){return this.entries()}*entries(){for(let e=0;e<this.rows;e++)for(let r=0;r<this.columns;r++)yield[e,r,this.get(e,r)]}*values(){for(let e=0;e<this.rows;e++)for(let r=0;r<this.columns;r++)yield this.get(e,r)}};R.prototype.klass="Matrix";typeof Symbol<"u"&&(R.prototype[Symbol.for("nodejs.util.inspect.custom")]=Ce);function ur(s,e){return s-e}function mo(s){return s.every(e=>typeof e=="number")}R.random=R.rand;R.randomInt=R.randInt;R.diagonal=R.diag;R.prototype.diagonal=R.prototype.diag;R.identity=R.eye;R.prototype.negate=R.prototype.neg;R.prototype.tensorProduct=R.prototype.kroneckerProduct;var v=class s extends R{data;#t(e,r){if(this.data=[],Number.isInteger(r)&&r>=0)for(let t=0;t<e;t++)this.data.push(new Float64Array(r));else throw new TypeError("nColumns must be a positive integer");this.rows=e,this.columns=r}constructor(e,r){if(super(),s.isMatrix(e))this.#t(e.rows,e.columns),s.copy(e,this);else if(Number.isInteger(e)&&e>=0)this.#t(e,r);else if(T(e)){let t=e;if(e=t.length,r=e?t[0].length:0,typeof r!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let n=0;n<e;n++){if(t[n].length!==r)throw new RangeError("Inconsistent array dimensions");if(!mo(t[n]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(t[n]))}this.rows=e,this.columns=r}else throw new TypeError("First argument must be a positive number or an array")}set(e,r,t){return this.data[e][r]=t,this}get(e,r){return this.data[e][r]}removeRow(e){return U(this,e),this.data.splice(e,1),this.rows-=1,this}addRow(e,r){return r===void 0&&(r=e,e=this.rows),U(this,e,!0),r=Float64Array.from(st(this,r)),this.data.splice(e,0,r),this.rows+=1,this}removeColumn(e){G(this,e);for(let r=0;r<this.rows;r++){let t=new Float64Array(this.columns-1);for(let n=0;n<e;n++)t[n]=this.data[r][n];for(let n=e+1;n<this.columns;n++)t[n-1]=this.data[r][n];this.data[r]=t}return this.columns-=1,this}addColumn(e,r){typeof r>"u"&&(r=e,e=this.columns),G(this,e,!0),r=it(this,r);for(let t=0;t<this.rows;t++){let n=new Float64Array(this.columns+1),o=0;for(;o<e;o++)n[o]=this.data[t][o];for(n[o++]=r[t];o<this.columns+1;o++)n[o]=this.data[t][o-1];this.data[t]=n}return this.columns+=1,this}};We(R,v);var wt=class extends R{constructor(e){super(),this.data=e,this.rows=e.length,this.columns=e[0].length}set(e,r,t){return this.data[e][r]=t,this}get(e,r){return this.data[e][r]}};function cr(s){let e=s.data,r=s.rows;for(let t=0;t<r;t++){let n=e[t];for(let o=t+1;o<r;o++){let i=n[o];n[o]=e[o][t],e[o][t]=i}}return s}function ee(s,e){let r=0;return Math.abs(s)>Math.abs(e)?(r=e/s,Math.abs(s)*Math.sqrt(1+r*r)):e!==0?(r=s/e,Math.abs(e)*Math.sqrt(1+r*r)):0}var nt=class{constructor(e,r={}){let{assumeSymmetric:t=!1}=r;if(e=wt.checkMatrix(e),!e.isSquare())throw new Error("Matrix is not a square matrix");if(e.isEmpty())throw new Error("Matrix must be non-empty");let n=e.columns,o=new v(n,n),i=new Float64Array(n),a=new Float64Array(n),l=e,u,f,c=!1;if(t?c=!0:c=e.isSymmetric(),c){for(u=0;u<n;u++)for(f=0;f<n;f++)o.set(f,u,l.get(u,f));ho(n,a,i,o),po(n,a,i,o),cr(o)}else{let m=new v(n,n),g=new Float64Array(n);for(f=0;f<n;f++)for(u=0;u<n;u++)m.set(u,f,l.get(u,f));go(n,m,g,o),yo(n,a,i,o,m)}this.n=n,this.e=a,this.d=i,this.V=o}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let e=this.n,r=this.e,t=this.d,n=new v(e,e),o,i;for(o=0;o<e;o++){for(i=0;i<e;i++)n.set(o,i,0);n.set(o,o,t[o]),r[o]>0?n.set(o,o+1,r[o]):r[o]<0&&n.set(o,o-1,r[o])}return n}};function ho(s,e,r,t){let n,o,i,a,l,u,f,c;for(l=0;l<s;l++)r[l]=t.get(l,s-1);for(a=s-1;a>0;a--){for(c=0,i=0,u=0;u<a;u++)c=c+Math.abs(r[u]);if(c===0)for(e[a]=r[a-1],l=0;l<a;l++)r[l]=t.get(l,a-1),t.set(l,a,0),t.set(a,l,0);else{for(u=0;u<a;u++)r[u]/=c,i+=r[u]*r[u];for(n=r[a-1],o=Math.sqrt(i),n>0&&(o=-o),e[a]=c*o,i=i-n*o,r[a-1]=n-o,l=0;l<a;l++)e[l]=0;for(l=0;l<a;l++){for(n=r[l],t.set(a,l,n),o=e[l]+t.get(l,l)*n,u=l+1;u<=a-1;u++)o+=t.get(l,u)*r[u],e[u]+=t.get(l,u)*n;e[l]=o}for(n=0,l=0;l<a;l++)e[l]/=i,n+=e[l]*r[l];for(f=n/(i+i),l=0;l<a;l++)e[l]-=f*r[l];for(l=0;l<a;l++){for(n=r[l],o=e[l],u=l;u<=a-1;u++)t.set(l,u,t.get(l,u)-(n*e[u]+o*r[u]));r[l]=t.get(l,a-1),t.set(l,a,0)}}r[a]=i}for(a=0;a<s-1;a++){if(t.set(a,s-1,t.get(a,a)),t.set(a,a,1),i=r[a+1],i!==0){for(u=0;u<=a;u++)r[u]=t.get(a+1,u)/i;for(l=0;l<=a;l++){for(o=0,u=0;u<=a;u++)o+=t.get(a+1,u)*t.get(l,u);for(u=0;u<=a;u++)t.set(l,u,t.get(l,u)-o*r[u])}}for(u=0;u<=a;u++)t.set(a+1,u,0)}for(l=0;l<s;l++)r[l]=t.get(l,s-1),t.set(l,s-1,0);t.set(s-1,s-1,1),e[0]=0}function po(s,e,r,t){let n,o,i,a,l,u,f,c,m,g,p,d,w,h,y,b,A;for(i=1;i<s;i++)e[i-1]=e[i];e[s-1]=0;let F=0,M=0,E=Number.EPSILON;for(u=0;u<s;u++){for(M=Math.max(M,Math.abs(r[u])+Math.abs(e[u])),f=u;f<s&&!(Math.abs(e[f])<=E*M);)f++;if(f>u){A=0;do{for(A=A+1,n=r[u],c=(r[u+1]-n)/(2*e[u]),m=ee(c,1),c<0&&(m=-m),r[u]=e[u]/(c+m),r[u+1]=e[u]*(c+m),g=r[u+1],o=n-r[u],i=u+2;i<s;i++)r[i]-=o;for(F=F+o,c=r[f],p=1,d=p,w=p,h=e[u+1],y=0,b=0,i=f-1;i>=u;i--)for(w=d,d=p,b=y,n=p*e[i],o=p*c,m=ee(c,e[i]),e[i+1]=y*m,y=e[i]/m,p=c/m,c=p*r[i]-y*n,r[i+1]=o+y*(p*n+y*r[i]),l=0;l<s;l++)o=t.get(i+1,l),t.set(i+1,l,y*t.get(i,l)+p*o),t.set(i,l,p*t.get(i,l)-y*o);c=-y*b*w*h*e[u]/g,e[u]=y*c,r[u]=p*c}while(Math.abs(e[u])>E*M)}r[u]=r[u]+F,e[u]=0}for(i=0;i<s-1;i++){for(l=i,c=r[i],a=i+1;a<s;a++)r[a]<c&&(l=a,c=r[a]);if(l!==i)for(r[l]=r[i],r[i]=c,a=0;a<s;a++)c=t.get(i,a),t.set(i,a,t.get(l,a)),t.set(l,a,c)}}function go(s,e,r,t){let n=0,o=s-1,i,a,l,u,f,c,m;for(c=n+1;c<=o-1;c++){for(m=0,u=c;u<=o;u++)m=m+Math.abs(e.get(u,c-1));if(m!==0){for(l=0,u=o;u>=c;u--)r[u]=e.get(u,c-1)/m,l+=r[u]*r[u];for(a=Math.sqrt(l),r[c]>0&&(a=-a),l=l-r[c]*a,r[c]=r[c]-a,f=c;f<s;f++){for(i=0,u=o;u>=c;u--)i+=r[u]*e.get(u,f);for(i=i/l,u=c;u<=o;u++)e.set(u,f,e.get(u,f)-i*r[u])}for(u=0;u<=o;u++){for(i=0,f=o;f>=c;f--)i+=r[f]*e.get(u,f);for(i=i/l,f=c;f<=o;f++)e.set(u,f,e.get(u,f)-i*r[f])}r[c]=m*r[c],e.set(c,c-1,m*a)}}for(u=0;u<s;u++)for(f=0;f<s;f++)t.set(u,f,u===f?1:0);for(c=o-1;c>=n+1;c--)if(e.get(c,c-1)!==0){for(u=c+1;u<=o;u++)r[u]=e.get(u,c-1);for(f=c;f<=o;f++){for(a=0,u=c;u<=o;u++)a+=r[u]*t.get(u,f);for(a=a/r[c]/e.get(c,c-1),u=c;u<=o;u++)t.set(u,f,t.get(u,f)+a*r[u])}}}function yo(s,e,r,t,n){let o=s-1,i=0,a=s-1,l=Number.EPSILON,u=0,f=0,c=0,m=0,g=0,p=0,d=0,w=0,h,y,b,A,F,M,E,S,x,L,B,I,N,Z,$;for(h=0;h<s;h++)for((h<i||h>a)&&(r[h]=n.get(h,h),e[h]=0),y=Math.max(h-1,0);y<s;y++)f=f+Math.abs(n.get(h,y));for(;o>=i;){for(A=o;A>i&&(p=Math.abs(n.get(A-1,A-1))+Math.abs(n.get(A,A)),p===0&&(p=f),!(Math.abs(n.get(A,A-1))<l*p));)A--;if(A===o)n.set(o,o,n.get(o,o)+u),r[o]=n.get(o,o),e[o]=0,o--,w=0;else if(A===o-1){if(E=n.get(o,o-1)*n.get(o-1,o),c=(n.get(o-1,o-1)-n.get(o,o))/2,m=c*c+E,d=Math.sqrt(Math.abs(m)),n.set(o,o,n.get(o,o)+u),n.set(o-1,o-1,n.get(o-1,o-1)+u),S=n.get(o,o),m>=0){for(d=c>=0?c+d:c-d,r[o-1]=S+d,r[o]=r[o-1],d!==0&&(r[o]=S-E/d),e[o-1]=0,e[o]=0,S=n.get(o,o-1),p=Math.abs(S)+Math.abs(d),c=S/p,m=d/p,g=Math.sqrt(c*c+m*m),c=c/g,m=m/g,y=o-1;y<s;y++)d=n.get(o-1,y),n.set(o-1,y,m*d+c*n.get(o,y)),n.set(o,y,m*n.get(o,y)-c*d);for(h=0;h<=o;h++)d=n.get(h,o-1),n.set(h,o-1,m*d+c*n.get(h,o)),n.set(h,o,m*n.get(h,o)-c*d);for(h=i;h<=a;h++)d=t.get(h,o-1),t.set(h,o-1,m*d+c*t.get(h,o)),t.set(h,o,m*t.get(h,o)-c*d)}else r[o-1]=S+c,r[o]=S+c,e[o-1]=d,e[o]=-d;o=o-2,w=0}else{if(S=n.get(o,o),x=0,E=0,A<o&&(x=n.get(o-1,o-1),E=n.get(o,o-1)*n.get(o-1,o)),w===10){for(u+=S,h=i;h<=o;h++)n.set(h,h,n.get(h,h)-S);p=Math.abs(n.get(o,o-1))+Math.abs(n.get(o-1,o-2)),S=x=.75*p,E=-.4375*p*p}if(w===30&&(p=(x-S)/2,p=p*p+E,p>0)){for(p=Math.sqrt(p),x<S&&(p=-p),p=S-E/((x-S)/2+p),h=i;h<=o;h++)n.set(h,h,n.get(h,h)-p);u+=p,S=x=E=.964}for(w=w+1,F=o-2;F>=A&&(d=n.get(F,F),g=S-d,p=x-d,c=(g*p-E)/n.get(F+1,F)+n.get(F,F+1),m=n.get(F+1,F+1)-d-g-p,g=n.get(F+2,F+1),p=Math.abs(c)+Math.abs(m)+Math.abs(g),c=c/p,m=m/p,g=g/p,!(F===A||Math.abs(n.get(F,F-1))*(Math.abs(m)+Math.abs(g))<l*(Math.abs(c)*(Math.abs(n.get(F-1,F-1))+Math.abs(d)+Math.abs(n.get(F+1,F+1))))));)F--;for(h=F+2;h<=o;h++)n.set(h,h-2,0),h>F+2&&n.set(h,h-3,0);for(b=F;b<=o-1&&(Z=b!==o-1,b!==F&&(c=n.get(b,b-1),m=n.get(b+1,b-1),g=Z?n.get(b+2,b-1):0,S=Math.abs(c)+Math.abs(m)+Math.abs(g),S!==0&&(c=c/S,m=m/S,g=g/S)),S!==0);b++)if(p=Math.sqrt(c*c+m*m+g*g),c<0&&(p=-p),p!==0){for(b!==F?n.set(b,b-1,-p*S):A!==F&&n.set(b,b-1,-n.get(b,b-1)),c=c+p,S=c/p,x=m/p,d=g/p,m=m/c,g=g/c,y=b;y<s;y++)c=n.get(b,y)+m*n.get(b+1,y),Z&&(c=c+g*n.get(b+2,y),n.set(b+2,y,n.get(b+2,y)-c*d)),n.set(b,y,n.get(b,y)-c*S),n.set(b+1,y,n.get(b+1,y)-c*x);for(h=0;h<=Math.min(o,b+3);h++)c=S*n.get(h,b)+x*n.get(h,b+1),Z&&(c=c+d*n.get(h,b+2),n.set(h,b+2,n.get(h,b+2)-c*g)),n.set(h,b,n.get(h,b)-c),n.set(h,b+1,n.get(h,b+1)-c*m);for(h=i;h<=a;h++)c=S*t.get(h,b)+x*t.get(h,b+1),Z&&(c=c+d*t.get(h,b+2),t.set(h,b+2,t.get(h,b+2)-c*g)),t.set(h,b,t.get(h,b)-c),t.set(h,b+1,t.get(h,b+1)-c*m)}}}if(f!==0){for(o=s-1;o>=0;o--)if(c=r[o],m=e[o],m===0)for(A=o,n.set(o,o,1),h=o-1;h>=0;h--){for(E=n.get(h,h)-c,g=0,y=A;y<=o;y++)g=g+n.get(h,y)*n.get(y,o);if(e[h]<0)d=E,p=g;else if(A=h,e[h]===0?n.set(h,o,E!==0?-g/E:-g/(l*f)):(S=n.get(h,h+1),x=n.get(h+1,h),m=(r[h]-c)*(r[h]-c)+e[h]*e[h],M=(S*p-d*g)/m,n.set(h,o,M),n.set(h+1,o,Math.abs(S)>Math.abs(d)?(-g-E*M)/S:(-p-x*M)/d)),M=Math.abs(n.get(h,o)),l*M*M>1)for(y=h;y<=o;y++)n.set(y,o,n.get(y,o)/M)}else if(m<0)for(A=o-1,Math.abs(n.get(o,o-1))>Math.abs(n.get(o-1,o))?(n.set(o-1,o-1,m/n.get(o,o-1)),n.set(o-1,o,-(n.get(o,o)-c)/n.get(o,o-1))):($=Bt(0,-n.get(o-1,o),n.get(o-1,o-1)-c,m),n.set(o-1,o-1,$[0]),n.set(o-1,o,$[1])),n.set(o,o-1,0),n.set(o,o,1),h=o-2;h>=0;h--){for(L=0,B=0,y=A;y<=o;y++)L=L+n.get(h,y)*n.get(y,o-1),B=B+n.get(h,y)*n.get(y,o);if(E=n.get(h,h)-c,e[h]<0)d=E,g=L,p=B;else if(A=h,e[h]===0?($=Bt(-L,-B,E,m),n.set(h,o-1,$[0]),n.set(h,o,$[1])):(S=n.get(h,h+1),x=n.get(h+1,h),I=(r[h]-c)*(r[h]-c)+e[h]*e[h]-m*m,N=(r[h]-c)*2*m,I===0&&N===0&&(I=l*f*(Math.abs(E)+Math.abs(m)+Math.abs(S)+Math.abs(x)+Math.abs(d))),$=Bt(S*g-d*L+m*B,S*p-d*B-m*L,I,N),n.set(h,o-1,$[0]),n.set(h,o,$[1]),Math.abs(S)>Math.abs(d)+Math.abs(m)?(n.set(h+1,o-1,(-L-E*n.get(h,o-1)+m*n.get(h,o))/S),n.set(h+1,o,(-B-E*n.get(h,o)-m*n.get(h,o-1))/S)):($=Bt(-g-x*n.get(h,o-1),-p-x*n.get(h,o),d,m),n.set(h+1,o-1,$[0]),n.set(h+1,o,$[1]))),M=Math.max(Math.abs(n.get(h,o-1)),Math.abs(n.get(h,o))),l*M*M>1)for(y=h;y<=o;y++)n.set(y,o-1,n.get(y,o-1)/M),n.set(y,o,n.get(y,o)/M)}for(h=0;h<s;h++)if(h<i||h>a)for(y=h;y<s;y++)t.set(h,y,n.get(h,y));for(y=s-1;y>=i;y--)for(h=i;h<=a;h++){for(d=0,b=i;b<=Math.min(y,a);b++)d=d+t.get(h,b)*n.get(b,y);t.set(h,y,d)}}}function Bt(s,e,r,t){let n,o;return Math.abs(r)>Math.abs(t)?(n=t/r,o=r+n*t,[(s+n*e)/o,(e-n*s)/o]):(n=r/t,o=t+n*r,[(n*s+e)/o,(n*e-s)/o])}var wo=1e-9,bo=1e-13,Fo=1e-6;function fr(s,e,r){let t=Et(s,r);if(!t)throw new Error("mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate");let[n,o]=[0,0];for(let c=0;c<r;c+=1)for(let m=0;m<r;m+=1)n=Math.max(n,Math.abs(e[c*r+m]-e[m*r+c])),o=Math.max(o,Math.abs(e[c*r+m]));if(n>wo*o)return{...ne(t,re(kt(t,e,r),r,!1),r),symmetric:!1};let i=e.map((c,m)=>(c+e[m%r*r+Math.floor(m/r)])/2),a=Et(i,r),l=a&&re(kt(a,s,r),r,!0),u=l?Math.max(...l.re):0;if(!a||!l||Math.min(...l.re)<=0||1/u<=bo*r/Math.min(...l.re))return{...ne(t,re(kt(t,i,r),r,!0),r),symmetric:!0};let f=ne(a,{re:l.re.map(c=>1/c),vectors:l.vectors},r);return{squares:f.squares,shapes:f.shapes.map((c,m)=>c*Math.sqrt(f.squares[m%r])),symmetric:!0}}function re(s,e,r){let t=r?s.map((u,f)=>(u+s[f%e*e+Math.floor(f/e)])/2):s,n=new nt(v.from1DArray(e,e,t),{assumeSymmetric:r}),{realEigenvalues:o,imaginaryEigenvalues:i,eigenvectorMatrix:a}=n,l=Float64Array.from(a.to1DArray());if(!r){for(let u=1;u<e;u+=1)if(i[u]<0)for(let f=0;f<e;f+=1)l[f*e+u]=l[f*e+u-1]}for(let u=0;u<e;u+=1){let f=Math.hypot(...Array.from({length:e},(c,m)=>l[m*e+u]));for(let c=0;c<e;c+=1)l[c*e+u]/=f}return{re:Float64Array.from(o),vectors:l}}function ne(s,{re:e,vectors:r},t){let n=Array.from(e.keys()).sort((i,a)=>e[i]-e[a]),o=new Float64Array(t*t);return n.forEach((i,a)=>{for(let l=0;l<t;l+=1)o[l*t+a]=r[l*t+i]}),Ut(s,o,t,t),{squares:Float64Array.from(n,i=>e[i]),shapes:o}}function mr(s,e,r,t,n){let o=n.symmetric?n.shapes:So(s,t),i=d=>q(o,q(d,o,t,t,t),t,t,t,!0),[a,l]=[i(r),i(e)];if(n.symmetric)for(let d=0;d<t*t;d+=1)a[d]=d%(t+1)?0:n.squares[d/(t+1)];let u=Array.from({length:t},(d,w)=>Math.sqrt(Math.abs(a[w*(t+1)]))),f=Fo*Math.max(...u)||1,c=u.map(d=>Math.max(d,f)),m=v.zeros(2*t,2*t);for(let d=0;d<t;d+=1){m.set(d,t+d,c[d]);for(let w=0;w<t;w+=1)m.set(t+d,w,-a[d*t+w]/c[w]),m.set(t+d,t+w,-l[d*t+w])}let g=new nt(m,{assumeSymmetric:!1}),p={re:Float64Array.from(g.realEigenvalues),im:Float64Array.from(g.imaginaryEigenvalues)};return{count:2*t,values:p,shapes:Ao(g.eigenvectorMatrix,p.im,o,c,t)}}function Ao(s,e,r,t,n){let o={re:new Float64Array(2*n*n),im:new Float64Array(2*n*n)};for(let i=0;i<2*n;i+=1)for(let a=0;a<n;a+=1)o.re[2*n*a+i]=s.get(a,e[i]<0?i-1:i)/t[a],o.im[2*n*a+i]=(e[i]>0?s.get(a,i+1):e[i]<0?-s.get(a,i):0)/t[a];return{re:q(r,o.re,n,n,2*n),im:q(r,o.im,n,n,2*n)}}function So(s,e){let r=Float64Array.from({length:e*e},(t,n)=>n%(e+1)?0:1);return Ut(Et(s,e),r,e,e),r}function oe({data:s,shape:[,e]},r,t){let[n,o,i]=[0,0,0];for(let u=3*e*r;u<3*e*(r+1);u+=3)n+=s[u],o+=s[u+1],i+=s[u+2];let a=Math.hypot(n,o,i);if(t<0||a===0)return a;let l=3*(e*r+t);return(n*s[l]+o*s[l+1]+i*s[l+2])/a}var Mo=["settling","vibration.residual","vibration.nominal"];function W(s,e=3){return Q(s,e)}function se(s,e){if(s.length<2)return e[0];let r=0;for(let t=1;t<s.length;t+=1)r+=(e[t]+e[t-1])/2*(s[t]-s[t-1]);return r/(s[s.length-1]-s[0])}function pr(s,e,r,t){let n={},{tip_error:o}=e;if(o){let a=Float64Array.from(s,(l,u)=>oe(o,u,-1));n["tip_error.commanded"]=hr(s,a,o,t)}let i=e.deviation?.data;return i&&(n["deviation.max"]=hr(s,i,e.tip_error_nominal,t),n["deviation.rms"]={value:Math.sqrt(se(s,i.map(a=>a*a))),note:"over the run"}),{...n,...vo(s,r,i!==void 0)}}function hr(s,e,r,t){let n=dt(e),o=`at ${W(s[n])} s; ${H(e[e.length-1],"m")} at the end of the run`,a=(r?_(0,r.shape[1]).map(l=>[oe(r,n,l),t[l]]):[]).filter(([l])=>l).map(([l,u])=>`${H(l,"m")} ${u??"geometry"}`);return{value:e[n],note:o,time:s[n],more:a.join(", ")}}function vo(s,e,r){let t=s[s.length-1];if(e!==null&&e<=t*(1+1e-9))return{};let n="what moves the robot changes up to the end of the run",o=`the run ends at ${W(t,6)} s, the move at ${W(e??0,6)} s`,i=e===null?n:`${o}: simulate longer to see it settle`,a={value:null,note:e===null?n:"the run ends with the move"},l={settling:{value:null,note:`not seen: ${i}`},"vibration.residual":a};return r?{...l,"vibration.nominal":a}:l}function gr(s){let e={},r=Mo.filter(t=>t!=="vibration.nominal"||"deviation.max"in s);for(let t of r)e[t]={value:null,note:"the run broke off"};for(let[t,n]of Object.entries(s))r.includes(t)||(e[t]={...n,note:`until it broke off: ${n.note}`});return e}function dr(s,e){if(!s.energy||!s.energy_balance)return{};let{energy:r,work:t}=s,n=r.shape[1],o=Math.max(r.data.reduce((l,u,f)=>Math.max(l,Math.abs(u-r.data[f%n])),0),t.data.reduce((l,u)=>Math.max(l,Math.abs(u)),0)),i=Math.abs(s.energy_balance.data[dt(s.energy_balance.data.subarray(0,e))]),a=o?`worst residual, ${H(i,"J")}, over ${H(o,"J")} moved`:"nothing moved";return{"energy.residual":{value:o?i/o:null,note:a}}}var Eo=8,ie=1e-5,ko=Math.SQRT1_2,xo=1e-9;function yr(s,e,r,t){let n=Object.entries(s).flatMap(([a,l])=>l.filter(u=>u.frequency>0).slice(0,Eo).map(u=>[a,u])),o=Ro(n,r,t),i=e.flatMap(a=>a.rings&&a.damping<ko?[{at:a.rings,label:a.element}]:[]);return{vibration:{modes:o,marks:i.sort((a,l)=>a.at-l.at)},facts:jo(s)}}function jo({controlled:s,locked:e}){if(!s)return{};let r=i=>i.reduce((a,{rings:l,frequency:u})=>l&&u<(a??1/0)?u:a,null),[t,n]=[r(s),r(e??[])],o=t===null?"no vibration under control":n===null?"":`${W(n,4)} Hz with the motors locked`;return{"frequency.first":{value:t,note:o}}}function Ro(s,e,r){let t=e.length,n=new Float64Array((1+4*s.length)*t);n.set(e),s.forEach(([,{re:f,im:c}],m)=>{let g=f.reduce((p,d,w)=>Math.max(p,Math.hypot(d,c[w])),0);for(let p=0;p<t;p+=1){let[d,w]=[ie*f[p]/g,ie*c[p]/g];[d,w,-d,-w].forEach((h,y)=>{n[(1+4*m+y)*t+p]=e[p]+h})}});let{data:o,shape:i}=r(n,1+4*s.length),a=o.length/(1+4*s.length),l=f=>Float64Array.from({length:a},(c,m)=>(o[f*a+m]-o[(f+2)*a+m])/(2*ie)),u=f=>({data:Float32Array.from(f),shape:i.slice(1)});return s.map(([f,c],m)=>{let[g,p]=Lo(l(1+4*m),l(2+4*m));return{case:f,frequency:c.frequency,damping:c.damping,element:c.element,rest:u(o.subarray(0,a)),real:u(g),imaginary:u(p)}})}function Lo(s,e){let[r,t]=[0,0];for(let u=0;u<s.length;u+=3){let f=Math.hypot(...s.subarray(u,u+3),...e.subarray(u,u+3));f>t&&([r,t]=[u,f])}if(!t)return[s,e];let n=[0,1,2].map(u=>Math.hypot(s[r+u],e[r+u])),o=r+n.indexOf(Math.max(...n)),i=Math.hypot(s[o],e[o])*t,[a,l]=[s[o]/i,-e[o]/i];return[s.map((u,f)=>a*u-l*e[f]),s.map((u,f)=>l*u+a*e[f])]}function wr(s,e){let[r,t]=[s.values.re[e],s.values.im[e]],n=Math.hypot(r,t);return{size:n,rings:t>xo*n?t/(2*Math.PI):null,damping:n?-r/n:0}}function br(s,e,r,t,n){let o=i=>Float64Array.from({length:r},(a,l)=>{let u=0;for(let f=0;f<t;f+=1)u+=n(l,f)*i[f*s.count+e];return u});return{re:o(s.shapes.re),im:o(s.shapes.im)}}function Fr(s,e,r,t){let{count:n,shapes:o}=e,i=w=>h=>{if(!t)return w(h);let y=0;for(let b=0;b<r;b+=1)y+=t[h*r+b]*w(b);return y},a=(w,h)=>{let y=0;for(let b=0;b<r;b+=1)y+=w(b)*h(b);return y},l=ae(s.shapes,r,r),[u,f]=[ae(o.re,r,n),ae(o.im,r,n)],c=l.map(w=>Float64Array.from({length:r},(h,y)=>i(b=>w[b])(y))),m=w=>a(h=>w[h],i(h=>w[h])),[g,p]=[l.map(w=>Math.sqrt(m(w))),u.map((w,h)=>Math.sqrt(m(w)+m(f[h])))],d=new Float64Array(r*n);for(let w=0;w<r;w+=1)for(let h=0;h<n;h+=1){let[y,b]=[u,f].map(A=>a(F=>c[w][F],F=>A[h][F]));d[w*n+h]=Math.hypot(y,b)/(g[w]*p[h])}return d}function ae(s,e,r){return Array.from({length:r},(t,n)=>Float64Array.from({length:e},(o,i)=>s[i*r+n]))}function Oo({values:s,count:e}){let r=Array.from({length:e},(t,n)=>Math.hypot(s.re[n],s.im[n]));return{rings:r.map((t,n)=>s.im[n]>1e-9*t),stands:r.map((t,n)=>Math.abs(s.im[n])<=1e-9*t)}}function Ar(s,e,r){let{count:t,values:n}=e,{rings:o,stands:i}=Oo(e),a=new Float64Array(t);Array.from({length:t},(u,f)=>f).sort((u,f)=>n.re[f]-n.re[u]).forEach((u,f)=>{a[u]=f});let l=Float64Array.from(s,(u,f)=>{let c=f%t;return!o[c]&&!i[c]?100:a[c]/(10*t)-u*u-(o[c]?10:0)});return Io(l,r,t)}function Io(s,e,r){let[t,n]=[new Float64Array(e+1),new Float64Array(r+1)],o=new Int32Array(r+1);for(let a=1;a<=e;a+=1){let l=new Float64Array(r+1).fill(1/0),u=new Int32Array(r+1),f=new Uint8Array(r+1);o[0]=a;let c=0;for(;o[c];){f[c]=1;let[m,g]=[1/0,0];for(let p=1;p<=r;p+=1){if(f[p])continue;let d=s[(o[c]-1)*r+p-1]-t[o[c]]-n[p];d<l[p]&&(l[p]=d,u[p]=c),l[p]<m&&(m=l[p],g=p)}for(let p=0;p<=r;p+=1)f[p]?(t[o[p]]+=m,n[p]-=m):l[p]-=m;c=g}for(;c;c=u[c])o[c]=o[u[c]]}let i=new Array(e).fill(-1);for(let a=1;a<=r;a+=1)o[a]&&(i[o[a]-1]=a-1);return i}var Bo=1e-13,No=1e-13,To="whole arm, free",$o="whole arm, in its weight and loads";function vr(s,e,r,{blocks:t,schedule:n,info:o},i){if(!e.modes)return{vibration:e.noModes,facts:{}};try{let{rest:a,linear:l}=Sr(s,e,r,n,j(e.modes.rest)),u=Object.fromEntries(e.modes.cases.map(({name:d,moving:w})=>[d,Mr(e,t,l,d,w)])),{name:f,moving:c}=e.modes.cases.find(d=>d.name==="controlled"&&d.moving.length)??e.modes.cases.find(d=>d.name==="locked"),m=qo(e,o,n,i),g=m&&Sr(s,e,r,n,m,i.times[i.times.length-1]).linear,p=g?Mr(e,t,g,f,c):[];return yr(u,p,a,(d,w)=>Rt(s,e,t,d,w).line)}catch(a){return{vibration:a instanceof Error?a.message:String(a),facts:{}}}}function Sr(s,e,r,t,n,o=0){let i=null;return Kt(e,r,"real",n,(a,l)=>(i=Te(s,e,ot(e.map,a,"real"),t,l,o),i&&i.rest)),i}function qo(s,e,r,t){if(!s.modes.end)return null;let n=j(s.modes.end).slice(),[o,i]=[t.times[t.times.length-1],t.series.q.data.subarray(-n.length)],a=new Map(e.commanded);for(let l=0;l<n.length;l+=1){let u=a.get(l);s.modes.free.includes(l)||(n[l]=u===void 0?i[l]:et(r,u,o))}return n}function Mr(s,e,r,t,n){let o=Math.sqrt(r.mass.length),i=n.length;if(!i)return[];let a=w=>Float64Array.from({length:i*i},(h,y)=>w[n[Math.floor(y/i)]*o+n[y%i]]),[l,u,f]=[a(r.mass),a(r.damping),a(r.stiffness)],c=t==="controlled";c&&s.modes.servos.forEach(({coordinate:w},h)=>{let y=n.indexOf(w)*(i+1);f[y]+=e.servos[2*h],u[y]+=e.servos[2*h+1]});let m=fr(l,f,i),g=mr(l,u,f,i,m),p=Ar(Fr(m,g,i,l),g,i),d=No*i*m.squares.reduce((w,h)=>Math.max(w,Math.abs(h)),0);return Array.from({length:i},(w,h)=>{let y=new Float64Array(o);n.forEach((I,N)=>{y[I]=m.shapes[N*i+h]});let b=_o(s,e,r.elastic,y,c),A=br(g,p[h],o,i,(I,N)=>n[N]===I?1:0),F=m.squares[h],M=b.reduce((I,{energy:N})=>I+N,0);if(Math.abs(F)<=d&&M<=d)return{frequency:0,rings:null,damping:0,element:To,...A};let{size:E,rings:S,damping:x}=wr(g,p[h]),L=(c&&S?E:Math.sqrt(Math.max(F,0)))/(2*Math.PI),B=b.reduce((I,N)=>N.energy>I.energy?N:I,b[0]);return{frequency:L,rings:S,damping:Math.abs(x)>Bo?x:0,element:M>d&&B?B.element:$o,...A}})}function _o(s,e,r,t,n){let o=t.length,i=f=>{let c=0;for(let m=0;m<o;m+=1)c+=r[f*o+m]*t[m];return c},{springs:a,servos:l}=s.modes,u=a.map(({element:f,rows:c,gear:m})=>{if(!m)return{element:f,energy:c.reduce((p,d)=>p+t[d]*i(d),0)};let g=r[c[0]*(o+1)];return{element:f,energy:g?i(c[0])**2/g:0}});return n?[...u,...l.map(({coordinate:f,element:c},m)=>({element:c,energy:e.servos[2*m]*t[f]**2}))]:u}var Er=1e-6,Po=1e-11,kr=.5,le=40,zo=.1,xr=24;async function jr(s,e,r,t,n,o,i){let{free:a,gross:l}=e.split;if(!a.length)return{};let u=n.length,f=o.q.shape[1],c=h=>J({matrix:l,constant:{data:new Float64Array(f),shape:[f]}},o[h].data,u),m=Mt(e,r,t,n,o),g={engine:s,blocks:r,free:a,size:f,places:m.length/u,weight:j(e.split.weight),q:o.q.data.slice(),rates:c("v"),gains:c("a"),wrenches:m},p=o.deformation.data,d=null;for(let h=0;h<u;h+=xr){let y=Array.from({length:Math.min(xr,u-h)},(b,A)=>h+A);if(h&&Co(g,p,J(e.deflections,g.q.subarray((h-1)*f,h*f),1),y),d=Wo(g,o.q.data,y,d),!d)return{};await i()}let w=J(e.deflections,g.q,u);return{deformation_stationary:k(w,u,a.length),deformation_oscillatory:k(rt(p,w),u,a.length)}}function Co(s,e,r,t){let n=s.free.length;for(let o of t)s.free.forEach((i,a)=>{s.q[o*s.size+i]+=r[a]-e[o*n+a]})}function fe(s,e,r){let{engine:t,blocks:n,free:o,size:i}=s,a={q:e,v:K(s.rates,i,r),a:K(s.gains,i,r),base:s.weight,wrenches:K(s.wrenches,s.places,r)},l=jt(t,n,a,r.length),u=t.sample("elastic",n.chain,a,r.length).forces;return Float64Array.from({length:r.length*o.length},(f,c)=>{let m=Math.floor(c/o.length)*i+o[c%o.length];return l[m]+u[m]})}function ce(s,e,r){let{free:t,size:n}=s,o=t.length,i=new Float64Array((o+1)*n);for(let l=0;l<=o;l+=1)i.set(e,l*n);t.forEach((l,u)=>{i[u*n+l]+=Er});let a=fe(s,i,new Array(o+1).fill(r));return Re(Float64Array.from({length:o*o},(l,u)=>(a[u%o*o+Math.floor(u/o)]-a[o*o+Math.floor(u/o)])/Er),o)}function Wo(s,e,r,t){let n=l=>s.q.subarray(l*s.size,(l+1)*s.size),o=l=>ce(s,n(l[l.length>>1]),l[l.length>>1]),i=t??o(r);if(!i)return null;let a=ue(s,r,i,le);a.length&&(i=o(a)??i),a=ue(s,a,i,le);for(let l of a){let[u,f]=[le,[l]];for(;f.length&&u;u-=1){let c=ce(s,n(l),l);f=c?ue(s,f,c,3):f}f.length&&Do(s,e,l)}return i}function ue(s,e,r,t){let{free:n,size:o,q:i}=s,a=n.length,l=[],u=new Map,f=e;for(let c=0;c<t&&f.length;c+=1){let m=fe(s,K(i,o,f),f);f=f.filter((g,p)=>{let d=q(r,m.subarray(p*a,(p+1)*a),a,a,1),w=d.reduce((b,A)=>Math.max(b,Math.abs(A)),0),h=w>kr?kr/w:1;if(!Number.isFinite(w))return l.push(g)&&!1;if(n.forEach((b,A)=>{i[g*o+b]-=h*d[A]}),w<Po)return!1;let y=w>zo*(u.get(g)??1/0);return u.set(g,w),y?l.push(g)&&!1:!0})}return[...l,...f]}function Do(s,e,r){let t=e.slice(r*s.size,(r+1)*s.size),n=ce(s,t,r);if(s.q.set(t,r*s.size),!n)return;let o=s.free.length,i=q(n,fe(s,t,[r]),o,o,1);s.free.forEach((a,l)=>{s.q[r*s.size+a]-=i[l]})}var Uo=50;async function Rr(s,e,r,t,n,o){let i=performance.now(),a=async(c=!1)=>{if(!(!c&&performance.now()-i<Uo)){if(await new Promise(m=>setTimeout(m,0)),o.cancelled?.())throw new Y("a newer run began");i=performance.now()}};await a(!0);let{vibration:l,facts:u}=vr(s,e,r,n,t);await a(!0);let f=await jr(s,e,n.blocks,n.schedule,t.times,t.series,a);return{...t,vibration:l,facts:{...t.facts,...u},series:{...t.series,...f}}}function Lr(s,{strengths:e,places:r,kept:t},n){let o=[s.every>1?`one sample in ${s.every}`:"",t>r.data.length?`${r.data.length} places along each link`:""],i=o.some(Boolean)?` (looked at: ${o.filter(Boolean).join(", ")})`:"",a=m=>s.links.flatMap(({largest:g})=>g[m]??[]),l=(m,g)=>{let p=me(g,({value:h})=>h),d=p&&m!=="deflection.max"?` at s = ${W(p.s,2)}`:"",w=p?n[p.sample]:0;return p?{[m]:{value:p.value,note:`${p.link}${d}, at ${W(w)} s${i}`,time:w}}:{}},u=me(a("stress").filter(({link:m})=>m in e),({link:m,value:g})=>g/e[m]),f=u?e[u.link]:1,c=u&&`of ${H(f,"Pa")}, ${u.link}; margin ${W(100*(1-u.value/f))} %${i}`;return{...l("deflection.max",a("deflection")),...l("moment.max",a("moment")),...l("stress.max",a("stress")),...u&&c?{"stress.share":{value:100*u.value/f,note:c}}:{}}}function Or(s,e){let r=me(s.flatMap(t=>Go(t,e)),({share:t})=>t);return r?{"limits.share":{value:100*r.share,note:r.note}}:{}}function Go({joint:s,coordinate:e,drive:r,unit:t,effortUnit:n,speed:o,effort:i,range:a},l){let u=(c,m,g=0)=>O(l[c].data,l[c].shape[1],[m]).reduce((p,d)=>Math.max(p,Math.abs(d-g)),0),f=(c,m,g,p)=>({share:c/m,note:`${g} of ${s}: ${H(c,p)} of ${H(m,p)}`});return[...o?[f(u("v",e),o,"speed",`${t}/s`)]:[],...i&&r>=0?[f(u("effort",r),i,"effort",n)]:[],...a?[{share:u("q",e,a[0])/a[1],note:`range of ${s}, from its middle`}]:[]]}function me(s,e){return s.reduce((r,t)=>r===null||e(t)>e(r)?t:r,null)}var Nt=["y","z"],Qo=[{id:"deflection",of:"deflection",label:"Deflection",unit:"m",planes:Nt},{id:"slope",of:"slope",label:"Slope",unit:"rad",planes:Nt},{id:"moment",of:"moment",label:"Moment",unit:"N m",planes:["torsion",...Nt]},{id:"shear_force",of:"shear",label:"Shear force",unit:"N",planes:Nt}];function Ir(s,e,r){if(!e.length)return null;let t=s.stations.data,[n,o]=[e.length,t.length],i=Float64Array.from({length:n*o},(a,l)=>e[Math.floor(l/o)].length*t[l%o]);return{links:e.map(a=>a.name),places:{data:i,shape:[n,o]},quantities:Qo.map(({id:a,of:l,label:u,unit:f,planes:c})=>{let m=new Float64Array(r*n*o*c.length);return e.forEach((g,p)=>Nr(g[l],m,r,p,n,o*c.length)),{id:a,label:u,unit:f,planes:[...c],values:{data:m,shape:[r,n,o,c.length]}}})}}function Br(s,e,r){let[t,n]=[s.links.length,s.stations.data.length],o=(l,u,f,c)=>{let m=new Float64Array(r*t*n);return s.links.forEach((g,p)=>{let d=g.bends?e.find(h=>h.name===g.name):void 0,w=d&&c(d);w&&Nr(w,m,r,p,t,n)}),{id:l,label:u,unit:f,values:{data:m,shape:[r,t,n]}}};if(!e.length)return[];let a=[o("bending_moment","Bending moment","N m",({moment:l})=>Float64Array.from({length:r*n},(u,f)=>Math.sqrt(l[3*f+1]**2+l[3*f+2]**2))),o("torsion","Torsional moment","N m",({moment:l})=>Float64Array.from({length:r*n},(u,f)=>Math.abs(l[3*f]))),o("deflection","Deflection from the root\'s tangent","m",({deflection:l})=>ft(l,2))];return e.some(l=>l.stress)?[...a,o("stress","Largest stress (von Mises)","Pa",({stress:l})=>l&&l.mises),o("strain","Largest strain","1",({stress:l})=>l&&l.strain)]:a}function Nr(s,e,r,t,n,o){for(let i=0;i<r;i+=1)e.set(s.subarray(i*o,(i+1)*o),(i*n+t)*o)}function Tr(s,e,{run:r,real:t,facts:n,reported:o}){let{times:i,series:a}=r,l=Oe(e,i.length),u=qe(s,e,t.blocks,a,i,t.schedule,l),f=Br(e,u.links,l.length);return{...r,scene:_e(s,e,t.blocks,a,i,l,f),line:Ir(e,u.links,l.length),facts:o({...n,...Lr(u,e.carried,i)})}}var Ko=1e-12;function _r(s,e,[r,t],[n,o],i){if(!e.errorParts||!n||!r)return{};let a=(o??n).model.q.slice(),l=a.length/i;for(let[h,y]of[...r.info.commanded,...r.info.exact])for(let b=0;b<i;b+=1)a[b*l+h]=et(r.schedule,y,r.run.times[b]);let u=qr(s,e,r,n,a,i),f=t&&Pr(t.blocks.chain,r.blocks.chain)?u[0]:void 0,c=o&&t?qr(s,e,t,o,a,i,f):u,m=$r(u),g=rt(u[0],c[0]),p=$r(c);(e.errorParts.length>m.length||g.subarray(0,3).some(h=>Math.abs(h)>Ko))&&(m.push(g),p.push(new Float64Array(g.length)));let d=h=>{let y=new Float64Array(3*i*h.length);return h.forEach((b,A)=>{for(let F=0;F<i;F+=1)for(let M=0;M<3;M+=1)y[3*(F*h.length+A)+M]=b[3*F+M]}),k(y,i,h.length,3)},w={tip_commanded:k(c[0],i,3),tip_error:d(m)};return o&&(w.tip_error_nominal=d(m.map((h,y)=>rt(h,p[y])))),w}function $r(s){return s.slice(1).map((e,r)=>rt(e,s[r]))}function Pr(s,e){return s.every((r,t)=>r===e[t])}function qr(s,e,r,{model:{q:t},points:n},o,i,a){let l=t.length/i,[u,f]=[o.slice(),t.slice()];for(let y=0;y<t.length;y+=l){for(let b of r.info.driven)u[y+b]=t[y+b];for(let b of e.bends)f[y+b]=0}let c=y=>O(y,y.length/i,[9,10,11]),m=new Float64Array(l),[g,p]=[t,c(n)],d=[p],w=y=>J(e.straight,y,i),h=[f,w(u),w(o)];for(let y of h){if(a&&y===h[2])p=a;else if(!Pr(y,g)){let b={q:y,v:m,a:m,base:j(e.base)};p=c(s.sample("inertia",r.blocks.chain,b,i,["points"]).points)}g=y,d.unshift(p)}return d}function Cr(s,e,r,t){let o={...pr(e,r,t,s.errorParts??[]),...dr(r,e.length)},i=s.deformations.flatMap((g,p)=>g.endsWith(".gear")?[p]:[]),a=i.filter(g=>s.turning.includes(s.deformations[g].replace(/\\.gear$/,""))),l=a.length?a:i;if(l.length){let g=O(r.deformation.data,s.deformations.length,l),p=l.length<i.length?" (of the gears that turn)":"",{value:d,note:w}=zr(e,g,l.map(h=>s.deformations[h].replace(/\\.gear$/,"")));o["gear.max"]={value:d,note:`${w}${p}`}}let{drives:u}=s.layout,f=_(0,u.length),c=f.filter(g=>s.turning.includes(u[g]));for(let[g,p]of[["gear_torque",c.length?c:f],["voltage",f]]){if(!r[g])continue;let d=zr(e,O(r[g].data,u.length,p),p.map(w=>u[w]));d.value&&(o[`${g}.max`]=d)}let m=r.contact_force_normal?.data;if(m){let[g,p]=[m.reduce((d,w)=>Math.min(d,w)),m.reduce((d,w)=>Math.max(d,w))];o["contact.mean"]={value:se(e,m),note:`from ${W(g,4)} to ${W(p,4)} N`}}return o}function zr(s,e,r){let t=dt(e),n=`${r[t%r.length]}, at ${W(s[Math.floor(t/r.length)])} s`;return{value:Math.abs(e[t]),note:n,time:s[Math.floor(t/r.length)]}}var Yo=100;function Jo(s,e,r,t,n){let o=new Float64Array(1),i={time:o,row:St(t,o),step:new Float64Array(1)};for(let a=0;`${e}.switched`in s.layout.samples&&a<Yo;a+=1){let l=n;if(n=s.sample(`${e}.switched`,r.parameters,{...i,state:n},1).state,n.every((u,f)=>u===l[f]))break}return n}async function Wr(s,e,r,t,n,o){let{settings:i}=e,a=e.runs[t],l=_(0,a.signals).map(c=>Pt(n[`knots.${c}`],n[`coefficients.${c}`])),u=Me(l.map(c=>zt(c,i.duration)));l.length||(u.knots[1]=i.duration);let f=await we(s,{loop:`${t}.${i.method}`,parameters:n.parameters,knots:u.knots,rows:Ae(u),state:Jo(s,t,n,u,Ne(s,e,r,t,u)),times:j(e.times),settings:i},o);return{name:t,info:a,blocks:n,each:l,schedule:u,run:f}}var X=24;function he(s,e,r,t){let n=r.run.times.subarray(0,t),o=r.run.states.subarray(0,t*(r.run.states.length/r.run.times.length)),i=St(r.schedule,n),a={time:n,state:o,row:i,step:new Float64Array(1)},l=s.sample(`${r.name}.observe`,r.blocks.parameters,a,t),{q:u,v:f,a:c}=l,m=j(e.base),{points:g}=s.sample("inertia",r.blocks.chain,{q:u,v:f,a:c,base:m},t,["points"]);return{regime:r,model:l,points:g}}function Xo(s,e,{regime:r,model:{q:t,v:n}},o){let{chain:i,rotors:a}=r.blocks,l=a.length,u=j(e.base),f=new Float64Array(l),c=s.sample("inertia",i,{q:t,v:f,a:n,base:u},o,["forces","moment"]),m=s.sample("elastic",i,{q:t,v:n,base:u},o,["energies"]).energies,g=m.length/o,p=new Float64Array(4*o);for(let d=0;d<o;d+=1){for(let w=0;w<l;w+=1){let h=n[d*l+w];p[4*d]+=(c.forces[d*l+w]+a[w]*h)*h/2}for(let w=0;w<3;w+=1)p[4*d+1]-=c.moment[3*d+w]*e.gravity.data[w];for(let w=0;w<g;w+=1)p[4*d+2+w%2]+=m[d*g+w]}return p}function Dr(s,e,r,t,n){let{model:o,points:i}=t,a=Xo(s,e,t,n),l=o.q.length/n,u=o.gear.length/n,f=i.length/n/X,c=r.run.states.length/r.run.times.length,m=O(r.run.states.subarray(0,n*c),c,_(...r.info.state.works)),g=b=>k(O(o.drives,4*u,_(0,u).map(A=>4*A+b)),n,u),p=b=>O(i,f*X,_(0,f).flatMap(A=>_(0,3).map(F=>A*X+b+F))),d=O(i,f*X,_(0,f).flatMap(b=>_(b*X,b*X+9))),w={q:k(o.q,n,l),v:k(o.v,n,l),a:k(o.a,n,l),deformation:k(J(e.deflections,o.q,n),n,e.deformations.length),position:k(p(9),n,f,3),velocity:k(p(12),n,f,3),acceleration:k(p(18),n,f,3),rotation:k(d,n,f,3,3),tip:k(O(i,f*X,[9,10,11]),n,3),tip_velocity:k(O(i,f*X,[12,13,14]),n,3),energy:k(a,n,4),work:k(m,n,m.length/n),energy_balance:k($e(a,m,n,3),n)};u&&Object.assign(w,{wanted:g(3),effort:g(0),gear_torque:k(o.gear,n,u)}),u&&e.electric&&Object.assign(w,{voltage:g(1),current:g(2)});let h=_(...r.info.state.controls);if(h.length){let b=O(r.run.states.subarray(0,n*c),c,h);w.controller_states=k(b,n,h.length)}if(e.contactPoint<0)return w;let y=b=>O(o.contact,6,b);return{...w,contact_force:k(y([0,1,2]),n,3),contact_force_normal:k(y([3]),n),penetration:k(y([4]),n)}}function Ur(s,e,r,t){let n=r.model.q.length/t,o=r.points.length/t/X,[i,a]=[e,r].map(({points:u})=>O(u,o*X,[9,10,11])),l={q_nominal:k(r.model.q,t,n),v_nominal:k(r.model.v,t,n),deformation_nominal:k(J(s.deflections,r.model.q,t),t,s.deformations.length),gear_torque_nominal:k(r.model.gear,t,r.model.gear.length/t),tip_nominal:k(a,t,3),deviation:k(ft(rt(i,a),3),t)};return s.contactPoint>=0&&(l.contact_force_normal_nominal=k(O(r.model.contact,6,[3]),t)),l}var Gr=32,Zo=1e-6;function Qr(s,e){let{wanted:r}=e;return r?s.setpoints.map(t=>O(r.data,r.shape[1],[t])):[]}function Kr(s,e,r){let t=s.length-(Vo(s)?1:0),n=s[s.length-1],o=e===null?-1:s.findIndex(l=>l>=e*(1+1e-9));if(o>=0&&t-o>=Gr)return[s[o],n];let[i,a]=ts(Ho(t,r));return a-i>=Gr?[s[i],s[a-1]]:[s[0],n]}function Vo(s){let e=s.length;return e>2&&Math.abs((s[e-1]-s[e-2])/(s[1]-s[0])-1)>1e-6}function Ho(s,e){let r=new Array(Math.max(s,0)).fill(!1);if(s<3||!e.length)return r;let t=new Float64Array(s);for(let o of e)for(let i=1;i<s-1;i+=1)t[i]=Math.max(t[i],Math.abs(o[i+1]-2*o[i]+o[i-1]));let n=Zo*Math.max(Number.MIN_VALUE,t.reduce((o,i)=>Math.max(o,i),0));for(let o=1;o<s-1;o+=1)r[o]=t[o]<=n;return r}function ts(s){let[e,r]=[[0,0],-1];for(let t=0;t<=s.length;t+=1)t<s.length&&s[t]?r=r<0?t:r:r>=0&&(t-r>e[1]-e[0]&&(e=[r,t]),r=-1);return e}async function Yr(s,e,r,t,n){let o=performance.now(),i=e.runs.reference?1/2:1,a=(F,M)=>()=>{let E=S=>t.progress?.(M+i*S);return Wr(s,e,r,F,ot(e.map,r,F),{...t,progress:E})},l=e.runs.reference&&await n.of(ot(e.map,r,"reference"),async()=>({regime:await a("reference",0)(),seen:new Map})),u=await a("real",1-i)(),f=(performance.now()-o)/1e3,c=Math.min(u.run.times.length,l?.regime.run.times.length??1/0),m=he(s,e,u,c),g=l&&es(s,e,l,c),p=u.run.times.subarray(0,c),d={...Dr(s,e,u,m,c),...g?Ur(e,m,g,c):{},..._r(s,e,[u,l?.regime],[m,g],c)},w=ve(u.info.moving.map(F=>u.each[F])),h=[l?.regime,u].find(F=>F&&F.run.status!=="finished"),y={...Cr(e,p,d,w),...Or(e.carried.limits,d)},b=F=>h?gr(F):F;return{run:{status:h?h.run.status:"finished",message:h?`${h===u?"actual robot":"nominal run"}: ${h.run.message}`:u.run.message,seconds:f,times:p,series:d,span:Kr(p,w,Qr(e,d)),facts:b(y)},real:u,facts:y,reported:b}}function es(s,e,{regime:r,seen:t},n){let o=t.get(n)??he(s,e,r,n);return t.clear(),t.set(n,o),o}async function Jr(s){let e=await Ft.open(s.module.data,s.layout),r=new At;return{async run(t,n,o=()=>{}){let i=await Yr(e,s,t,n,r),{real:a,run:{times:l,series:u}}=i,f=[l,u,a];if(o(i.run,f),await new Promise(m=>setTimeout(m,0)),n.cancelled?.())throw new Y("a newer run began");let c=Tr(e,s,i);return o(c,f),Rr(e,s,t,c,a,n)}}}var lt=self,pe=null,Zr=-1,Xr=Promise.resolve();lt.onmessage=({data:s})=>{if(s.kind==="open"){Jr(s.bundle).then(t=>{pe=t,lt.postMessage({kind:"ready"})},t=>lt.postMessage({kind:"failed",message:String(t)}));return}let{id:e,values:r}=s;Zr=e,Xr=Xr.then(()=>rs(e,r))};async function rs(s,e){let r=()=>s!==Zr;try{if(!pe)throw new Error("the live model is not open");if(await new Promise(a=>setTimeout(a,0)),r())throw new Y("a newer run began");let t={cancelled:r,progress:a=>lt.postMessage({kind:"progress",id:s,share:a})},n=null,o=await pe.run(e,t,(a,l)=>{let u=qt(a,n);n=a;let f=new Set(ht(l));lt.postMessage({kind:"early",id:s,run:u},ht(u).filter(c=>!f.has(c)))}),i=qt(o,n);lt.postMessage({kind:"done",id:s,run:i},ht(i))}catch(t){let n=t instanceof Error?t.message:String(t);lt.postMessage({kind:"error",id:s,cancelled:t instanceof Y,message:n})}}})();\n';function ey(i){let{settings:t,status:e}=i,{statuses:n,limits:r}=i.layout,s=`t = ${Pe(i.time,6)} s`;if(e===n.finished)return["finished",`completed at t = ${Pe(t.duration,6)} s`];if(e===n.running)return["stopped",`stopped at ${s} of ${Pe(t.duration,6)} s: integration.max_steps = ${t.maxSteps} is used up`];if(e===n.chattering){let o=`more than ${r.most_events} times within ${r.event_time} s`;return["chattering",`stopped at ${s}: the contact started or ended ${o}; give the surface damping, or a lower stiffness`]}return MS(i,s)}function MS({layout:i,status:t,lastStep:e,rates:n},r){let{statuses:s,coordinates:o,limits:a}=i,l=o.length,c=Array.from(n().subarray(l,2*l),y=>Number.isFinite(y)?Math.abs(y):1/0),u=c.indexOf(Math.max(...c)),f=c[u]<a.bound?t===s.not_converged?"not_converged":t===s.step_too_small?"step_too_small":"diverged":"diverged",d=`its acceleration is ${Pe(c[u],3)} rad/s^2`,m=f.replaceAll("_"," ");return[f,`${m} at ${r} in coordinate ${o[u]}: ${d}; its last step was of ${Pe(e,3)} s`]}var Ni=class extends Error{name="EngineError"};function ka(i,t,e){if(!Object.hasOwn(i,t))throw new Ni(`${e}: got ${t}; expected one of ${Object.keys(i).join(", ")}`);return i[t]}function rs(i,t,e){if(t!==e)throw new Ni(`${i}: got ${t} numbers; expected ${e}`)}var SS=["rk4","midpoint"],AS=500,cd=class{constructor(t,e){this.engine=t;this.spec=e;let n=ka(t.layout.loops,e.loop,"loop");rs(`${e.loop}: parameters`,e.parameters.length,n.parameters),rs(`${e.loop}: state`,e.state.length,n.size),rs(`${e.loop}: rows`,e.rows.length,(e.knots.length-1)*n.row),this.method=n.method,this.memory=new Float64Array(t.layout.cells.length),this.state=e.state.slice(),this.slope=new Float64Array(n.size),this.states=new Float64Array(e.times.length*n.size),this.states.set(e.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(t){return this.memory[this.engine.layout.cells.indexOf(t)]}put(t){for(let[e,n]of Object.entries(t))this.memory[this.engine.layout.cells.indexOf(e)]=n}advance(t){let{layout:e}=this.engine,{settings:n,knots:r,rows:s,times:o,parameters:a}=this.spec,l=Math.max(1,Math.min(t,n.maxSteps-this.tried)),c={step:n.step,rtol:n.relativeTolerance,atol:n.absoluteTolerance,chunk:l,bound:e.limits.bound,watch:0,most_events:e.limits.most_events,event_time:e.limits.event_time,looks:0},u=this.cell("sample"),h=m=>({into:m,range:()=>[u*this.state.length,this.cell("sample")*this.state.length]}),f=m=>({into:m,given:!0}),d={memory:f(this.memory),y:f(this.state),k1:f(this.slope),p:a,knots:r,rows:s,times:o,out:h(this.states),options:Float64Array.from(e.options,m=>c[m]),seen:new Float64Array(1),segments:r.length-1,samples:o.length};this.engine.call(e.loops[this.spec.loop].export,e.arguments.map(m=>d[m]))}result(){let t=this.cell("sample"),e=this.state.length,[n,r]=ey({layout:this.engine.layout,settings:this.spec.settings,status:this.cell("status"),time:this.time,lastStep:this.cell("h"),rates:()=>this.rates()});return{status:n,message:r,times:this.spec.times.slice(0,t),states:this.states.slice(0,t*e),statistics:this.statistics()}}statistics(){let[t,e,n]=[this.cell("steps"),this.cell("smallest"),this.time],r=t?n/t:null,s={steps:t,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:r,smallest_step_s:e>0?e:r};return SS.includes(this.method)&&(s.step=this.cell("h")),this.cell("passes")&&(s.passes=this.cell("passes")),this.cell("events")&&(s.contact_changes=this.cell("events")),s}rates(){let{loop:t,parameters:e,rows:n}=this.spec,{row:r}=this.engine.layout.loops[t],s=Math.min(this.cell("segment"),n.length/r-1),o={time:Float64Array.of(this.time),state:this.state,row:n.slice(s*r,(s+1)*r),step:new Float64Array(1)};return this.engine.sample(`${t.slice(0,t.lastIndexOf("."))}.rate`,e,o,1).rate}},Or=class extends Ni{name="Cancelled"};async function ny(i,t,e={}){let n=new cd(i,t),r=1e3*(e.piece??.05),s=AS,o=performance.now();for(;n.running;){let a=performance.now();n.advance(s);let l=performance.now();if(s=Math.max(1,Math.floor(s*Math.min(4,r/Math.max(l-a,.001)))),!(l-o<r)){if(e.progress?.(n.time/t.settings.duration),await new Promise(c=>setTimeout(c,0)),e.cancelled?.())throw new Or(`the run was given up at t = ${Pe(n.time,6)} s`);o=performance.now()}}return n.result()}function ud(i,t){return{...i,...t,series:{...i?.series,...t.series}}}var iy=1,ES=65536,TS={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},wc=class i{constructor(t,e,n,r){this.layout=t;this.functions=e;this.memory=n;this.free=r}layout;functions;memory;free;static async open(t,e){if(e.format!==iy)throw new Ni(`layout: got format ${e.format}; expected ${iy}`);let{instance:n}=await RS(t,e),{memory:r,heap_base:s,...o}=n.exports,a=s.value;return new i(e,o,r,a)}sample(t,e,n,r,s){let o=ka(this.layout.samples,t,"function");rs(`${t}: parameters`,e.length,o.parameters);let a=this.schedule(o,e,[n],r);return hd(o.outputs,a,r,1,s)}slopes(t,e,n,r,s){let o=ka(this.layout.samples,t,"function");if(o.kind!=="slopes")throw new Ni(`${t}: got a function without derivatives; expected one with them`);rs(`${t}: parameters`,e.length,o.parameters);let a=Object.fromEntries(Object.entries(o.inputs).map(([u,h])=>[u,new Float64Array(h)])),l=this.schedule(o,e,[n,{...a,...r}],s),c=Ba(o.outputs);return{values:hd(o.outputs,l,s,2),slopes:hd(o.outputs,l.subarray(c),s,2)}}call(t,e){let n=e.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(n.reduce((a,l)=>a+(l?.byteLength??0),this.free));let r=new Float64Array(this.memory.buffer),s=this.free,o=e.map((a,l)=>{if(typeof a=="number")return BigInt(a);let c=s;return(a instanceof Float64Array||a.given)&&r.set(n[l],c/8),s+=n[l].byteLength,c});this.functions[t](...o),e.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[c,u]=a.range?.()??[0,a.into.length],h=o[l]/8;a.into.set(r.subarray(h+c,h+u),c)})}schedule(t,e,n,r){let s=r*n.length,[o,a]=[Ba(t.inputs),Ba(t.outputs)],l=this.free+e.byteLength,c=l+8*t.workspace,u=c+8*s*o;this.reserve(u+8*s*a);let h=new Float64Array(this.memory.buffer);return h.set(e,this.free/8),h.fill(0,l/8,c/8),PS(h.subarray(c/8,u/8),t.inputs,n,r),this.functions[t.export](BigInt(r),BigInt(0),this.free,l,c,u),h.subarray(u/8,u/8+s*a)}reserve(t){let e=t-this.memory.buffer.byteLength;if(!(e<=0))try{this.memory.grow(Math.ceil(e/ES))}catch{throw new Ni(`memory: got no room for ${(t/1e6).toFixed(0)} MB; expected a browser that has it. Hint: ask for fewer samples`)}}};async function RS(i,t){try{return await WebAssembly.instantiate(i,{env:TS})}catch(e){let n=t.simd?", with vectors (SIMD)":"";throw new Ni(`WebAssembly: got ${String(e)}; expected a browser that allows it${n}`)}}function Ba(i){return Object.values(i).reduce((t,e)=>t+e,0)}function CS(i,t,e,n){if(e===void 0)throw new Ni(`${i}: got nothing; expected ${t} numbers for each sample`);return e.length===n*t?t:(rs(i,e.length,t),0)}function PS(i,t,e,n){let r=Ba(t);e.forEach((s,o)=>{let a=o*r;for(let[l,c]of Object.entries(t)){let u=CS(l,c,s[l],n);ry(s[l],u,0,i,e.length*r,a,c,n),a+=c}})}function hd(i,t,e,n,r=Object.keys(i)){let s=n*Ba(i),o={},a=0;for(let[l,c]of Object.entries(i))r.includes(l)&&(o[l]=new Float64Array(e*c),ry(t,s,a,o[l],c,0,c,e)),a+=c;return o}function ry(i,t,e,n,r,s,o,a){for(let l=0;l<a;l++){let c=l*t+e,u=l*r+s;for(let h=0;h<o;h++)n[u+h]=i[c+h]}}var Mc=class{last=null;async of(t,e){if(this.last&&IS(this.last.blocks,t))return this.last.made;this.last=null;let n=await e();return this.last={blocks:t,made:n},n}};function IS(i,t){return Object.entries(i).every(([e,n])=>n.length===t[e].length&&n.every((r,s)=>r===t[e][s]))}function fd(i,t){return{knots:i,coefficients:t,signals:1,degree:t.length/(i.length-1)-1}}function dd(i,t){let e=i.degree+1,n=i.knots.length-1,r=0;for(;r<n&&i.knots[r]<t;)r+=1;let s=i.knots[n],o=[...i.knots.subarray(0,r)],a=[...i.coefficients.subarray(0,r*e)];return t>s&&(o.push(s),a.push(pd(i,n-1,0,s),...new Array(i.degree).fill(0))),fd(Float64Array.from([...o,t]),Float64Array.from(a))}function pd(i,t,e,n){let r=i.degree+1,s=(t*i.signals+e)*r,o=n-i.knots[t],a=0;for(let l=i.degree;l>=0;l-=1)a=a*o+i.coefficients[s+l];return a}function md(i,t){let[e,n]=[0,i.length-1];for(;n-e>1;){let r=e+n>>1;i[r]<=t?e=r:n=r}return e}function ss(i,t,e){return pd(i,md(i.knots,e),t,e)}function sy(i){return oy(i,i.knots.length-1,t=>t)}function Sc(i,t){return oy(i,t.length,e=>md(i.knots,t[e]))}function oy(i,t,e){let n=i.signals*(i.degree+1),r=new Float64Array(t*(n+1));for(let s=0,o=0;s<t;s+=1){let a=e(s);r[o++]=i.knots[a];for(let l=a*n;l<(a+1)*n;l+=1)r[o++]=i.coefficients[l]}return r}function ay(i){if(!i.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let t=Math.max(...i.map(o=>o.knots[o.knots.length-1])),e=i.map(o=>o.knots[o.knots.length-1]<t?dd(o,t):o),n=LS(e.flatMap(o=>[...o.knots])),r=Math.max(...e.map(o=>o.degree)),s=new Float64Array((n.length-1)*i.length*(r+1));return e.forEach((o,a)=>{for(let l=0;l<n.length-1;l+=1){let c=(l*i.length+a)*(r+1);FS(o,n,l,s.subarray(c,c+r+1))}}),{knots:n,coefficients:s,signals:i.length,degree:r}}function LS(i){let t=[...new Set(i)].sort((r,s)=>r-s),e=t[t.length-1]-t[0],n=t.filter((r,s)=>s===0||r-t[s-1]>1e-12*e);return n[n.length-1]=t[t.length-1],Float64Array.from(n)}function FS(i,t,e,n){let r=md(i.knots,(t[e]+t[e+1])/2),s=t[e]-i.knots[r],o=Math.abs(s)<=1e-12*(t[t.length-1]-t[0])?0:s;for(let a=0;a<=i.degree;a+=1){let l=i.coefficients[r*(i.degree+1)+a],c=1;for(let u=a;u>=0;u-=1)n[u]+=c*l*Math.pow(o,a-u),c=c*u/(a-u+1)}}var NS=1e-9,DS=1e-6;function ly(i){let t=i.map(OS);return t.includes(null)?null:Math.max(0,...t)}function OS(i){let{knots:t,coefficients:e,degree:n}=i,r=t.length-1,s=n+1,o=l=>e[l*s],a=Array.from({length:r},(l,c)=>Math.abs(o(c))).reduce((l,c)=>Math.max(l,c),1e-12);for(let l=r-1;l>=0;l-=1){let c=t[l+1]-t[l];for(let u=1;u<s;u+=1)if(!(Math.abs(e[l*s+u])*c**u<=NS*a))return l===r-1?null:t[l+1];if(l&&Math.abs(o(l)-pd(i,l-1,0,t[l]))>DS*a)return t[l]}return 0}var wi=6;function gd({follower:i,signal:t},e,n,r,s,o){let a=t<0?1:ss(n,t,r);return(i?US(s,o,e):e).map(l=>a*l)}function US(i,t,e){return e.map((n,r)=>{let[s,o]=[t+3*(r%3),r<3?0:3];return i[s]*e[o]+i[s+1]*e[o+1]+i[s+2]*e[o+2]})}function Ac(i,t,e,n,r){let s=r.position.shape[1],o=new Float64Array(n.length*s*wi);return n.forEach((a,l)=>{if(i.loads.forEach((c,u)=>{let h=l*s+c.point,f=t.loads.subarray(wi*u,wi*(u+1)),d=gd(c,f,e,a,r.rotation.data,9*h);for(let m=0;m<wi;m+=1)o[wi*h+m]+=d[m]}),!(i.contactPoint<0))for(let c=0;c<3;c+=1)o[wi*(l*s+i.contactPoint)+c]-=r.contact_force.data[3*l+c]}),o}function Ec(i,t){let e=t.length;for(let n=0;n<e;n+=1){let r=n;for(let o=n+1;o<e;o+=1)Math.abs(i[o*e+n])>Math.abs(i[r*e+n])&&(r=o);let s=Math.abs(i[r*e+n]);if(!(s>0)||s===1/0)return!1;r!==n&&kS(i,t,n,r);for(let o=n+1;o<e;o+=1){let a=i[o*e+n]/i[n*e+n];if(a!==0){for(let l=n+1;l<e;l+=1)i[o*e+l]-=a*i[n*e+l];t[o]-=a*t[n]}}}for(let n=e-1;n>=0;n-=1){for(let r=n+1;r<e;r+=1)t[n]-=i[n*e+r]*t[r];t[n]/=i[n*e+n]}return!0}function kS(i,t,e,n){let r=t.length;for(let o=0;o<r;o+=1){let a=i[e*r+o];i[e*r+o]=i[n*r+o],i[n*r+o]=a}let s=t[e];t[e]=t[n],t[n]=s}function Tc(i,t){let e=new Float64Array(t*t);for(let n=0;n<t;n+=1)for(let r=n;r<t;r+=1){let s=i[r*t+n];for(let o=0;o<n;o+=1)s-=e[r*t+o]*e[n*t+o];if(r===n&&!(s>0))return null;e[r*t+n]=r===n?Math.sqrt(s):s/e[n*t+n]}return e}function uy(i,t,e,n){for(let r=0;r<e;r+=1){for(let s=0;s<r;s+=1)fy(t,r,s,i[r*e+s],n);for(let s=0;s<n;s+=1)t[r*n+s]/=i[r*e+r]}}function yd(i,t,e,n){for(let r=e-1;r>=0;r-=1){for(let s=r+1;s<e;s+=1)fy(t,r,s,i[s*e+r],n);for(let s=0;s<n;s+=1)t[r*n+s]/=i[r*e+r]}}function fy(i,t,e,n,r){for(let s=0;s<r;s+=1)i[t*r+s]-=n*i[e*r+s]}function Rc(i,t,e){let n=t.slice();uy(i,n,e,e);let r=hy(n,e);return uy(i,r,e,e),hy(r,e)}function hy(i,t){return i.map((e,n)=>i[n%t*t+Math.floor(n/t)])}function si(i,t,e,n,r,s=!1){let o=new Float64Array(e*r);for(let a=0;a<e;a+=1)for(let l=0;l<n;l+=1){let c=s?i[l*e+a]:i[a*n+l];if(c)for(let u=0;u<r;u+=1)o[a*r+u]+=c*t[l*r+u]}return o}function dy(i,t){let e=Float64Array.from({length:t*t},(n,r)=>r%(t+1)?0:1);for(let n=0;n<t;n+=1){let r=n;for(let a=n+1;a<t;a+=1)Math.abs(i[a*t+n])>Math.abs(i[r*t+n])&&(r=a);let s=Math.abs(i[r*t+n]);if(!(s>0)||s===1/0)return null;for(let a of[i,e])if(r!==n){let l=a.slice(n*t,(n+1)*t);a.copyWithin(n*t,r*t,(r+1)*t),a.set(l,r*t)}let o=i[n*t+n];for(let a=0;a<t;a+=1)i[n*t+a]/=o,e[n*t+a]/=o;for(let a=0;a<t;a+=1){let l=i[a*t+n];if(!(a===n||l===0)){for(let c=n;c<t;c+=1)i[a*t+c]-=l*i[n*t+c];for(let c=0;c<t;c+=1)e[a*t+c]-=l*e[n*t+c]}}}return e}var Cc=24;function py(i,t,e,n,r,s,o=0){let a=n.length/Cc,l={wrenches:new Float64Array(wi*a),mass:new Float64Array(s*s),damping:new Float64Array(s*s),stiffness:new Float64Array(s*s)},c=(u,h)=>Float64Array.from({length:3*s},(f,d)=>r[(d%s*a+u)*Cc+h+Math.floor(d/s)]);return i.loads.forEach((u,h)=>{let{point:f,follower:d}=u,m=t.loads.subarray(wi*h,wi*(h+1)),y=gd(u,m,e,o,n,Cc*f);if(Io(l.wrenches.subarray(wi*f,wi*(f+1)),y,1),!d)return;let g=c(f,21);for(let[p,x]of[[c(f,18),0],[g,3]])Io(l.stiffness,si(p,si(BS(y.subarray(x,x+3)),g,3,3,s),s,3,s,!0),1)}),i.touch&&VS(zS(i.touch,t.surface),t.touch,n,c(i.touch.point,18),l,s),l}function Io(i,t,e){for(let n=0;n<t.length;n+=1)i[n]+=e*t[n]}function BS([i,t,e]){return Float64Array.of(0,-e,t,e,0,-i,-t,i,0)}function zS(i,t){let[e,n,r,s]=t;if(i.radius)return{...i,axis:[e,n,r],radius:s};let[o,a,l]=i.axis;return{...i,distance:-(o*e+a*n+l*r)}}function VS(i,t,e,n,r,s){let[o,a,l,c]=t,u=Cc*i.point+9,{gap:h,normal:f,curvature:d}=GS(i,e.subarray(u,u+3)),m=c-l*h;if(!i.bilateral&&!(h<=0&&m>0))return;for(let p=0;p<3;p+=1)r.wrenches[wi*i.point+p]+=m*f[p];let y=si(f,n,1,3,s),g=si(y,y,s,1,s);Io(r.mass,g,o),Io(r.damping,g,a),Io(r.stiffness,g,l),Io(r.stiffness,si(n,si(d,n,3,3,s),s,3,s,!0),-m)}function GS(i,t){let e=l=>l[0]*t[0]+l[1]*t[1]+l[2]*t[2];if(!i.radius)return{gap:e(i.axis)+i.distance,normal:Float64Array.from(i.axis),curvature:new Float64Array(9)};let n=t.map((l,c)=>l-i.axis[c]),r=Math.hypot(...n)||1e-300,s=i.inside?-1:1,o=n.map(l=>l/r),a=Float64Array.from({length:9},(l,c)=>s*((c%4?0:1)-o[Math.floor(c/3)]*o[c%3])/r);return{gap:s*(r-i.radius),normal:o.map(l=>s*l),curvature:a}}function my(i,t){let e=Array.from(i.frames.data).filter(n=>n<t);return e[e.length-1]!==t-1&&e.push(t-1),e}function sn(i){return i.data instanceof Float64Array?i.data:Float64Array.from(i.data)}function HS(i,t,e){let n=i.knobs.map(s=>s.start),r=i.knobs.map(s=>s.factor);return i.sliders.forEach((s,o)=>{s.real?r[s.knob]=t[o]:n[s.knob]=t[o]}),e==="reference"?n:i.knobs.map((s,o)=>{let a=r[o];return a===null||s.factor===null?n[o]:s.together?s.factor?n[o]*(a/s.factor):n[o]:n[o]*a})}function ks(i,t,e){let n=i.runs[e],r=WS(n,HS(i,t,e)),s={};for(let[o,a]of Object.entries(n.places)){let l=a.shape.reduce((c,u)=>c*u,1);s[o]=r.slice(a.start,a.start+l)}return s}function WS(i,t){let e=sn(i.base).slice(),n=i.powers.map(l=>gy(l,(c,u)=>Math.pow(t[c]/i.variables[c].start,u))),r=i.powers.map(l=>gy(l,(c,u)=>qS(i.variables[c],u,t[c]))),{products:s,terms:o,coefficients:a}=i;for(let l=0;l<s.data.length;l+=2)e[s.data[l]]*=n[s.data[l+1]];for(let l=0;l<o.data.length;l+=2)e[o.data[l]]+=a.data[l/2]*r[o.data[l+1]];return e}function gy(i,t){return i.reduce((e,[n,r])=>e*t(n,r),1)}function qS(i,t,e){let n=Math.pow(i.start,t);return(Math.pow(e,t)-n)/(Math.pow(i.far,t)-n)}var $S=40,XS=1e-12,YS=.5,yy=1e-6,jS=.5,ZS=.001,KS=1/128;function JS(i,t,e,n,r,s){let[o,a,l]=[n.length+1,e.length,t.rotors.length],c=new Float64Array(o*a);for(let f=0;f<o;f+=1)c.set(e,f*a),f&&(c[f*a+n[f-1]]+=yy);let u={time:new Float64Array(1),state:c,row:t.rest_row,step:new Float64Array(1)},{rate:h}=i.sample("rest.rate",t.rest,u,o);for(let f=0;f<n.length;f+=1){s[f]=h[l+n[f]];for(let d=0;d<n.length;d+=1)r[f*n.length+d]=(h[(d+1)*a+l+n[f]]-s[f])/yy}}function QS(i,t,e,n){let r=i.layout.held,s=n.length,o=Array.from({length:s},(d,m)=>m).filter(d=>!r.includes(d)),a=new Float64Array(t.restSize);a.set(n);let l=new Float64Array(o.length**2),c=new Float64Array(o.length),u=1/0,[h,f]=[0,0];for(let d=0;d<$S&&o.length;d+=1){if(JS(i,e,a,o,l,c),!Ec(l,c))return null;let m=xd(a,o,c);if(!Number.isFinite(m)||(d===0?h=m:f+=m,h>ZS&&f>jS*h))return null;if(vd(m,u))return a.slice(0,s);u=m}return o.length?null:a.slice(0,s)}function xd(i,t,e){let n=e.reduce((s,o)=>Math.max(s,Math.abs(o)),0),r=Math.min(1,YS/n);for(let s=0;s<t.length;s+=1)i[t[s]]-=r*e[s];return n}function vd(i,t){return i<XS||i<1e-9&&i>=t/2}function _d(i,t,e,n,r){let s=i.sliders.map(u=>u.value),o=u=>u===1?t:t.map((h,f)=>s[f]+(h-s[f])*u),[a,l,c]=[0,1,n];for(;a<1;){let u=Math.min(1,a+l),h=r(o(u),c);if(h)[a,l,c]=[u,2*l,h];else if(l>KS)l/=2;else throw new Error(`${e}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`)}return c}function xy(i,t,e,n,r){let s=t.runs[n],o=sn(s.start).slice(),[a,l]=[s.state.q[0],s.state.v[0]];if(t.atRest){let c=(h,f)=>QS(i,t,ks(t.map,h,n),f),u=_d(t,e,n,o.slice(...s.state.q),c);for(let h=0;h<u.length;h+=1)s.info.includes(h)||(o[a+h]=u[h])}for(let[c,u]of s.exact){o[a+c]=ss(r,u,0);let h=r.degree;o[l+c]=h?r.coefficients[u*(h+1)+1]:0}return o}var t1=40,za=.001;function Pc(i,t,e,n){let{samples:r}=i.layout;return i.sample("loaded"in r?"loaded":"inertia",t.chain,e,n).forces}function e1(i,t,e,n,r,s=0){let o=r.length,a=new Float64Array(o),l=Float64Array.from({length:o*o},(M,A)=>A%(o+1)?0:1),c=sn(t.base),u=i.sample("inertia",e.chain,{q:r,v:a,a:l,base:c},o),{points:h}=i.sample("inertia",e.chain,{q:r,v:a,a,base:c},1),f=py(t,e,n,h,u.points,o,s),d=f.mass;for(let M=0;M<o;M+=1){for(let A=0;A<o;A+=1)d[M*o+A]+=(u.forces[M*o+A]+u.forces[A*o+M])/2;d[M*o+M]+=e.rotors[M]}let m=e.chain.slice();for(let M of t.modes.dry)m[M]=0;let y=i.slopes("elastic.slopes",m,{q:r,v:a,base:c},{q:l},o),g=i.slopes("elastic.slopes",m,{q:r,v:a,base:c},{v:l},o).slopes.forces,p=n1(i,t,e,r,f.wrenches),x=M=>M.map((A,b)=>M[b%o*o+Math.floor(b/o)]),_=x(y.slopes.forces),v=Pc(i,e,{q:r,v:a,a,base:sn(t.modes.weight),wrenches:f.wrenches},1);return{mass:d,elastic:_,residual:v.map((M,A)=>M+y.values.forces[A]),damping:x(g).map((M,A)=>M+f.damping[A]),stiffness:_.map((M,A)=>M+p[A]+f.stiffness[A])}}function vy(i,t,e,n,r,s=0){let{free:o}=t.modes,[a,l,c]=[r.slice(),r.length,o.length],[u,h]=[1/0,!c];for(let f=0;f<t1;f+=1){let d=e1(i,t,e,n,a,s);if(h)return{rest:a,linear:d};let m=Float64Array.from({length:c*c},(p,x)=>d.stiffness[o[Math.floor(x/c)]*l+o[x%c]]),y=Float64Array.from(o,p=>d.residual[p]);if(!Ec(m,y))return null;let g=xd(a,o,y);if(!Number.isFinite(g))return null;h=vd(g,u),u=g}return null}function n1(i,t,e,n,r){let s=n.length,o=[za,-za,2*za,-2*za],a=new Float64Array(o.length*s*s);o.forEach((h,f)=>{for(let d=0;d<s;d+=1)a.set(n,(f*s+d)*s),a[(f*s+d)*s+d]+=h});let l=new Float64Array(s),c=Pc(i,e,{q:a,v:l,a:l,base:sn(t.modes.weight),wrenches:r},o.length*s),u=(h,f,d)=>c[(h*s+d)*s+f];return Float64Array.from({length:s*s},(h,f)=>{let[d,m]=[Math.floor(f/s),f%s];return(8*(u(0,d,m)-u(1,d,m))-(u(2,d,m)-u(3,d,m)))/(12*za)})}function Sn(i,t,e){let n=i.length/t,r=new Float64Array(n*e.length);for(let s=0;s<n;s+=1)for(let o=0;o<e.length;o+=1)r[s*e.length+o]=i[s*t+e[o]];return r}function hi(i,t){return Array.from({length:t-i},(e,n)=>i+n)}function ji(i,t,e){let n=new Float64Array(e.length*t);for(let r=0;r<e.length;r+=1)for(let s=0;s<t;s+=1)n[r*t+s]=i[e[r]*t+s];return n}function os(i,t){return i.map((e,n)=>e-t[n])}function Lo(i,t){let e=new Float64Array(i.length/t);for(let n=0;n<e.length;n+=1){let r=0;for(let s=0;s<t;s+=1)r+=i[n*t+s]**2;e[n]=Math.sqrt(r)}return e}function _y(i,t,e,n){let r=i.length/e,s=t.length/e,o=new Float64Array(e),a=0;for(let l=0;l<e;l+=1){let c=0;for(let u=0;u<r;u+=1)c+=i[l*r+u];l===0&&(a=c),o[l]=c-a;for(let u=0;u<s;u+=1)o[l]+=(u<n?-1:1)*t[l*s+u]}return o}function Va(i){let t=0;for(let e=1;e<i.length;e+=1)Math.abs(i[e])>Math.abs(i[t])&&(t=e);return t}function we(i,t,...e){return{data:i,shape:[t,...e]}}var i1=4e5,r1=5e5;function by(i,t,e,n,r,s,o){let{places:a,lines:l,shown:c}=t.carried,u=a.data.length,h=l.map((x,_)=>s1(x,e.lengths[_],o.length*c.data.length)),f=Math.max(1,Math.ceil(r.length*l.length*u/i1));if(!l.length)return{links:h,every:f};let d=new Map(o.map((x,_)=>[x,_])),m=Array.from(r.keys()).filter(x=>x%f===0||d.has(x)),y={q:n.q.data,v:n.v.data,a:n.a.data};"wrenches"in i.layout.samples.line.inputs&&(y.wrenches=Ac(t,e,s,r,n));let g=Object.entries(y).map(([x,_])=>[x,ji(_,_.length/r.length,m)]),p={...Object.fromEntries(g),base:sn(t.split.weight)};return wd(i,e,p,m.length,(x,_,v)=>{let M=d.get(m[v]);l.forEach((A,b)=>{let w=Md(x[A.name],_,t,A);o1(h[b],A,w,a.data,m[v]),M!==void 0&&a1(h[b],A,w,M,c.data)})}),{links:h,every:f}}function wd(i,t,e,n,r){let{inputs:s,outputs:o}=i.layout.samples.line,a=Math.max(1,Math.floor(r1/Object.values(o).reduce((l,c)=>l+c,1)));for(let l=0;l<n;l+=a){let c=Math.min(a,n-l),u={};for(let[f,d]of Object.entries(s)){let m=e[f]??new Float64Array(d);u[f]=m.length===d?m:m.subarray(l*d,(l+c)*d)}let h=i.sample("line",t.line,u,c);for(let f=0;f<c;f+=1)r(h,f,l+f)}}function Md(i,t,e,n){let r=n?e.carried.places.data.length*n.width:15;return i.subarray(t*r,(t+1)*r)}function s1({name:i,at:t},e,n){let r=s=>new Float64Array(s*n);return{name:i,length:e,deflection:r(2),slope:r(2),moment:r(3),shear:r(2),axial:r(1),stress:t.mises_stress?{strain:r(1),mises:r(1)}:null,largest:{deflection:null,moment:null,stress:null}}}function o1(i,{width:t,at:e},n,r,s){let o=r.length-1,a=o*t+e.deflection[0];bd(i,"deflection",Math.sqrt(n[a]**2+n[a+1]**2),r[o],s);for(let l=0;l<=o;l+=1){let c=l*t+e.moment[0];bd(i,"moment",Math.sqrt(n[c+1]**2+n[c+2]**2),r[l],s),i.stress&&bd(i,"stress",n[l*t+e.mises_stress[0]],r[l],s)}}function bd({name:i,largest:t},e,n,r,s){let o=t[e];(!o||n>o.value)&&(t[e]={link:i,value:n,s:r,sample:s})}function a1(i,{width:t,at:e},n,r,s){let o=(a,l)=>{let[c,u]=e[a],h=u-c;for(let f=0;f<s.length;f+=1)for(let d=0;d<h;d+=1)l[(r*s.length+f)*h+d]=n[s[f]*t+c+d]};for(let a of["deflection","slope","moment","shear","axial"])o(a,i[a]);i.stress&&(o("strain",i.stress.strain),o("mises_stress",i.stress.mises))}function mr(i,t,e){let[n,r]=i.matrix.shape,s=new Float64Array(e*n);for(let o=0;o<e;o+=1)for(let a=0;a<n;a+=1){let l=i.constant.data[a];for(let c=0;c<r;c+=1)l+=i.matrix.data[a*r+c]*t[o*r+c];s[o*n+a]=l}return s}function wy(i,t,e,n,r,s,o){let a=p=>ji(n[p].data,n[p].shape.slice(1).reduce((x,_)=>x*_,1),s),l=s.length,c=Ic(i,t,e,a("q"),l),u=p=>Ic(i,t,e,p,l).line,h=p=>u(mr(t.straight,p,l)),f=h(a("q")),d=p=>({data:a(p),shape:[l,...n[p].shape.slice(1)]}),m="q_nominal"in n,y=c.line.shape.slice(0,3),g=c.line.data.map((p,x)=>p-f.data[x]);return{times:{data:ji(r,1,s),shape:[l]},line:c.line,rigid:f,roots:c.roots,reference:m?u(a("q_nominal")):null,referenceRigid:m?h(a("q_nominal")):null,colours:[...o,{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:Lo(g,3),shape:y}}],tip:d("tip"),tipReference:m?d("tip_nominal"):null,contact:t.contactPoint<0?null:{force:d("contact_force"),at:c1(t,n,s),surface:l1(t,e.surface)}}}function l1({surface:i},t){let e=[t[0],t[1],t[2]];return i?.kind==="plane"?{...i,position:e}:i?{...i,center:e,radius:t[3]}:void 0}function c1(i,t,e){let n=t.position.shape[1],r=ji(t.position.data,3*n,e),s=new Float64Array(3*e.length);for(let o=0;o<e.length;o+=1)for(let a=0;a<3;a+=1)s[3*o+a]=r[3*(o*n+i.contactPoint)+a];return{data:s,shape:[e.length,3]}}function Ic(i,t,e,n,r){let[s,o]=[t.links.length,t.stations.data.length],a=new Float64Array(n.length/r),l=new Float64Array(r*s*o*3),c=new Float64Array(r*s*4),u=t.links.map(({name:h})=>t.carried.lines.find(f=>f.name===h)??null);return wd(i,e,{q:n,v:a,a,base:sn(t.base)},r,(h,f,d)=>{t.links.forEach(({name:m},y)=>{let g=u[y],p=(d*s+y)*4,x=Md(h[m],f,t,g);c.set(h1(g?x.subarray(g.at.rotation[0]):x),p),d&&u1(c,p,4*s);for(let _=0;_<o;_+=1){let v=((d*s+y)*o+_)*3;for(let M=0;M<3;M+=1)l[v+M]=g?x[t.carried.shown.data[_]*g.width+g.at.position[0]+M]:x[9+M]+t.stations.data[_]*(x[12+M]-x[9+M])}})}),{line:{data:l,shape:[r,s,o,3]},roots:{data:c,shape:[r,s,4]}}}function u1(i,t,e){let n=0;for(let r=t;r<t+4;r+=1)n+=i[r]*i[r-e];if(n<0)for(let r=t;r<t+4;r+=1)i[r]*=-1}function h1(i){let t=i[0]+i[4]+i[8];if(t>0){let n=2*Math.sqrt(1+t);return[(i[7]-i[5])/n,(i[2]-i[6])/n,(i[3]-i[1])/n,n/4]}if(i[0]>i[4]&&i[0]>i[8]){let n=2*Math.sqrt(1+i[0]-i[4]-i[8]);return[n/4,(i[1]+i[3])/n,(i[2]+i[6])/n,(i[7]-i[5])/n]}if(i[4]>i[8]){let n=2*Math.sqrt(1+i[4]-i[0]-i[8]);return[(i[1]+i[3])/n,n/4,(i[5]+i[7])/n,(i[2]-i[6])/n]}let e=2*Math.sqrt(1+i[8]-i[0]-i[4]);return[(i[2]+i[6])/e,(i[5]+i[7])/e,e/4,(i[3]-i[1])/e]}var f1=Object.prototype.toString;function On(i){let t=f1.call(i);return t.endsWith("Array]")&&!t.includes("Big")}function Sd(i,t={}){if(!On(i))throw new TypeError("input must be an array");if(i.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=i.length}=t;if(e<0||e>=i.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>i.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let r=i[e];for(let s=e+1;s<n;s++)i[s]>r&&(r=i[s]);return r}function Ad(i,t={}){if(!On(i))throw new TypeError("input must be an array");if(i.length===0)throw new TypeError("input must not be empty");let{fromIndex:e=0,toIndex:n=i.length}=t;if(e<0||e>=i.length||!Number.isInteger(e))throw new Error("fromIndex must be a positive integer smaller than length");if(n<=e||n>i.length||!Number.isInteger(n))throw new Error("toIndex must be an integer greater than fromIndex and at most equal to length");let r=i[e];for(let s=e+1;s<n;s++)i[s]<r&&(r=i[s]);return r}function Lc(i,t={}){if(On(i)){if(i.length===0)throw new TypeError("input must not be empty")}else throw new TypeError("input must be an array");let e;if(t.output!==void 0){if(!On(t.output))throw new TypeError("output option must be an array if specified");e=t.output}else e=new Array(i.length);let n=Ad(i),r=Sd(i);if(n===r)throw new RangeError("minimum and maximum input values are equal. Cannot rescale a constant array");let{min:s=t.autoMinMax?n:0,max:o=t.autoMinMax?r:1}=t;if(s>=o)throw new RangeError("min option must be smaller than max option");let a=(o-s)/(r-n);for(let l=0;l<i.length;l++)e[l]=(i[l]-n)*a+s;return e}var Fc=" ".repeat(2),Sy=" ".repeat(4);function Ay(){return Ed(this)}function Ed(i,t={}){let{maxRows:e=15,maxColumns:n=10,maxNumSize:r=8,padMinus:s="auto"}=t;return`${i.constructor.name} {
${Fc}[
${Sy}${d1(i,e,n,r,s)}
${Fc}]
${Fc}rows: ${i.rows}
${Fc}columns: ${i.columns}
}`}function d1(i,t,e,n,r){let{rows:s,columns:o}=i,a=Math.min(s,t),l=Math.min(o,e),c=[];if(r==="auto"){r=!1;t:for(let u=0;u<a;u++)for(let h=0;h<l;h++)if(i.get(u,h)<0){r=!0;break t}}for(let u=0;u<a;u++){let h=[];for(let f=0;f<l;f++)h.push(p1(i.get(u,f),n,r));c.push(`${h.join(" ")}`)}return l!==o&&(c[c.length-1]+=` ... ${o-e} more columns`),a!==s&&c.push(`... ${s-t} more rows`),c.join(`
${Sy}`)}function p1(i,t,e){return(i>=0&&e?` ${My(i,t-1)}`:My(i,t)).padEnd(t)}function My(i,t){let e=i.toString();if(e.length<=t)return e;let n=i.toFixed(t);if(n.length>t&&(n=i.toFixed(Math.max(0,t-(n.length-t)))),n.length<=t&&!n.startsWith("0.000")&&!n.startsWith("-0.000"))return n;let r=i.toExponential(t);return r.length>t&&(r=i.toExponential(Math.max(0,t-(r.length-t)))),r.slice(0)}function Ey(i,t){i.prototype.add=function(n){return typeof n=="number"?this.addS(n):this.addM(n)},i.prototype.addS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)+n);return this},i.prototype.addM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)+n.get(r,s));return this},i.add=function(n,r){return new t(n).add(r)},i.prototype.sub=function(n){return typeof n=="number"?this.subS(n):this.subM(n)},i.prototype.subS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)-n);return this},i.prototype.subM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)-n.get(r,s));return this},i.sub=function(n,r){return new t(n).sub(r)},i.prototype.subtract=i.prototype.sub,i.prototype.subtractS=i.prototype.subS,i.prototype.subtractM=i.prototype.subM,i.subtract=i.sub,i.prototype.mul=function(n){return typeof n=="number"?this.mulS(n):this.mulM(n)},i.prototype.mulS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)*n);return this},i.prototype.mulM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)*n.get(r,s));return this},i.mul=function(n,r){return new t(n).mul(r)},i.prototype.multiply=i.prototype.mul,i.prototype.multiplyS=i.prototype.mulS,i.prototype.multiplyM=i.prototype.mulM,i.multiply=i.mul,i.prototype.div=function(n){return typeof n=="number"?this.divS(n):this.divM(n)},i.prototype.divS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)/n);return this},i.prototype.divM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)/n.get(r,s));return this},i.div=function(n,r){return new t(n).div(r)},i.prototype.divide=i.prototype.div,i.prototype.divideS=i.prototype.divS,i.prototype.divideM=i.prototype.divM,i.divide=i.div,i.prototype.mod=function(n){return typeof n=="number"?this.modS(n):this.modM(n)},i.prototype.modS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)%n);return this},i.prototype.modM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)%n.get(r,s));return this},i.mod=function(n,r){return new t(n).mod(r)},i.prototype.modulus=i.prototype.mod,i.prototype.modulusS=i.prototype.modS,i.prototype.modulusM=i.prototype.modM,i.modulus=i.mod,i.prototype.and=function(n){return typeof n=="number"?this.andS(n):this.andM(n)},i.prototype.andS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)&n);return this},i.prototype.andM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)&n.get(r,s));return this},i.and=function(n,r){return new t(n).and(r)},i.prototype.or=function(n){return typeof n=="number"?this.orS(n):this.orM(n)},i.prototype.orS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)|n);return this},i.prototype.orM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)|n.get(r,s));return this},i.or=function(n,r){return new t(n).or(r)},i.prototype.xor=function(n){return typeof n=="number"?this.xorS(n):this.xorM(n)},i.prototype.xorS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)^n);return this},i.prototype.xorM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)^n.get(r,s));return this},i.xor=function(n,r){return new t(n).xor(r)},i.prototype.leftShift=function(n){return typeof n=="number"?this.leftShiftS(n):this.leftShiftM(n)},i.prototype.leftShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)<<n);return this},i.prototype.leftShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)<<n.get(r,s));return this},i.leftShift=function(n,r){return new t(n).leftShift(r)},i.prototype.signPropagatingRightShift=function(n){return typeof n=="number"?this.signPropagatingRightShiftS(n):this.signPropagatingRightShiftM(n)},i.prototype.signPropagatingRightShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>n);return this},i.prototype.signPropagatingRightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>n.get(r,s));return this},i.signPropagatingRightShift=function(n,r){return new t(n).signPropagatingRightShift(r)},i.prototype.rightShift=function(n){return typeof n=="number"?this.rightShiftS(n):this.rightShiftM(n)},i.prototype.rightShiftS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>>n);return this},i.prototype.rightShiftM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)>>>n.get(r,s));return this},i.rightShift=function(n,r){return new t(n).rightShift(r)},i.prototype.zeroFillRightShift=i.prototype.rightShift,i.prototype.zeroFillRightShiftS=i.prototype.rightShiftS,i.prototype.zeroFillRightShiftM=i.prototype.rightShiftM,i.zeroFillRightShift=i.rightShift,i.prototype.not=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,~this.get(n,r));return this},i.not=function(n){return new t(n).not()},i.prototype.abs=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.abs(this.get(n,r)));return this},i.abs=function(n){return new t(n).abs()},i.prototype.acos=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.acos(this.get(n,r)));return this},i.acos=function(n){return new t(n).acos()},i.prototype.acosh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.acosh(this.get(n,r)));return this},i.acosh=function(n){return new t(n).acosh()},i.prototype.asin=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.asin(this.get(n,r)));return this},i.asin=function(n){return new t(n).asin()},i.prototype.asinh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.asinh(this.get(n,r)));return this},i.asinh=function(n){return new t(n).asinh()},i.prototype.atan=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.atan(this.get(n,r)));return this},i.atan=function(n){return new t(n).atan()},i.prototype.atanh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.atanh(this.get(n,r)));return this},i.atanh=function(n){return new t(n).atanh()},i.prototype.cbrt=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cbrt(this.get(n,r)));return this},i.cbrt=function(n){return new t(n).cbrt()},i.prototype.ceil=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.ceil(this.get(n,r)));return this},i.ceil=function(n){return new t(n).ceil()},i.prototype.clz32=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.clz32(this.get(n,r)));return this},i.clz32=function(n){return new t(n).clz32()},i.prototype.cos=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cos(this.get(n,r)));return this},i.cos=function(n){return new t(n).cos()},i.prototype.cosh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.cosh(this.get(n,r)));return this},i.cosh=function(n){return new t(n).cosh()},i.prototype.exp=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.exp(this.get(n,r)));return this},i.exp=function(n){return new t(n).exp()},i.prototype.expm1=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.expm1(this.get(n,r)));return this},i.expm1=function(n){return new t(n).expm1()},i.prototype.floor=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.floor(this.get(n,r)));return this},i.floor=function(n){return new t(n).floor()},i.prototype.fround=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.fround(this.get(n,r)));return this},i.fround=function(n){return new t(n).fround()},i.prototype.log=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log(this.get(n,r)));return this},i.log=function(n){return new t(n).log()},i.prototype.log1p=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log1p(this.get(n,r)));return this},i.log1p=function(n){return new t(n).log1p()},i.prototype.log10=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log10(this.get(n,r)));return this},i.log10=function(n){return new t(n).log10()},i.prototype.log2=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.log2(this.get(n,r)));return this},i.log2=function(n){return new t(n).log2()},i.prototype.round=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.round(this.get(n,r)));return this},i.round=function(n){return new t(n).round()},i.prototype.sign=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sign(this.get(n,r)));return this},i.sign=function(n){return new t(n).sign()},i.prototype.sin=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sin(this.get(n,r)));return this},i.sin=function(n){return new t(n).sin()},i.prototype.sinh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sinh(this.get(n,r)));return this},i.sinh=function(n){return new t(n).sinh()},i.prototype.sqrt=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.sqrt(this.get(n,r)));return this},i.sqrt=function(n){return new t(n).sqrt()},i.prototype.tan=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.tan(this.get(n,r)));return this},i.tan=function(n){return new t(n).tan()},i.prototype.tanh=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.tanh(this.get(n,r)));return this},i.tanh=function(n){return new t(n).tanh()},i.prototype.trunc=function(){for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.set(n,r,Math.trunc(this.get(n,r)));return this},i.trunc=function(n){return new t(n).trunc()},i.pow=function(n,r){return new t(n).pow(r)},i.prototype.pow=function(n){return typeof n=="number"?this.powS(n):this.powM(n)},i.prototype.powS=function(n){for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)**n);return this},i.prototype.powM=function(n){if(n=t.checkMatrix(n),this.rows!==n.rows||this.columns!==n.columns)throw new RangeError("Matrices dimensions must be equal");for(let r=0;r<this.rows;r++)for(let s=0;s<this.columns;s++)this.set(r,s,this.get(r,s)**n.get(r,s));return this}}function Di(i,t,e){let n=e?i.rows:i.rows-1;if(t<0||t>n)throw new RangeError("Row index out of range")}function Oi(i,t,e){let n=e?i.columns:i.columns-1;if(t<0||t>n)throw new RangeError("Column index out of range")}function Bs(i,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==i.columns)throw new RangeError("vector size must be the same as the number of columns");return t}function zs(i,t){if(t.to1DArray&&(t=t.to1DArray()),t.length!==i.rows)throw new RangeError("vector size must be the same as the number of rows");return t}function Ty(i,t){if(!On(t))throw new TypeError("row indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=i.rows)throw new RangeError("row indices are out of range")}function Ry(i,t){if(!On(t))throw new TypeError("column indices must be an array");for(let e=0;e<t.length;e++)if(t[e]<0||t[e]>=i.columns)throw new RangeError("column indices are out of range")}function Td(i,t,e,n,r){if(arguments.length!==5)throw new RangeError("expected 4 arguments");if(Nc("startRow",t),Nc("endRow",e),Nc("startColumn",n),Nc("endColumn",r),t>e||n>r||t<0||t>=i.rows||e<0||e>=i.rows||n<0||n>=i.columns||r<0||r>=i.columns)throw new RangeError("Submatrix indices are out of range")}function Ga(i,t=0){let e=[];for(let n=0;n<i;n++)e.push(t);return e}function Nc(i,t){if(typeof t!="number")throw new TypeError(`${i} must be a number`)}function Vs(i){if(i.isEmpty())throw new Error("Empty matrix has no elements to index")}function Cy(i){let t=Ga(i.rows);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[e]+=i.get(e,n);return t}function Py(i){let t=Ga(i.columns);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[n]+=i.get(e,n);return t}function Iy(i){let t=0;for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)t+=i.get(e,n);return t}function Ly(i){let t=Ga(i.rows,1);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[e]*=i.get(e,n);return t}function Fy(i){let t=Ga(i.columns,1);for(let e=0;e<i.rows;++e)for(let n=0;n<i.columns;++n)t[n]*=i.get(e,n);return t}function Ny(i){let t=1;for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)t*=i.get(e,n);return t}function Dy(i,t,e){let n=i.rows,r=i.columns,s=[];for(let o=0;o<n;o++){let a=0,l=0,c=0;for(let u=0;u<r;u++)c=i.get(o,u)-e[o],a+=c,l+=c*c;t?s.push((l-a*a/r)/(r-1)):s.push((l-a*a/r)/r)}return s}function Oy(i,t,e){let n=i.rows,r=i.columns,s=[];for(let o=0;o<r;o++){let a=0,l=0,c=0;for(let u=0;u<n;u++)c=i.get(u,o)-e[o],a+=c,l+=c*c;t?s.push((l-a*a/n)/(n-1)):s.push((l-a*a/n)/n)}return s}function Uy(i,t,e){let n=i.rows,r=i.columns,s=n*r,o=0,a=0,l=0;for(let c=0;c<n;c++)for(let u=0;u<r;u++)l=i.get(c,u)-e,o+=l,a+=l*l;return t?(a-o*o/s)/(s-1):(a-o*o/s)/s}function ky(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t[e])}function By(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t[n])}function zy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)-t)}function Vy(i){let t=[];for(let e=0;e<i.rows;e++){let n=0;for(let r=0;r<i.columns;r++)n+=i.get(e,r)**2/(i.columns-1);t.push(Math.sqrt(n))}return t}function Gy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t[e])}function Hy(i){let t=[];for(let e=0;e<i.columns;e++){let n=0;for(let r=0;r<i.rows;r++)n+=i.get(r,e)**2/(i.rows-1);t.push(Math.sqrt(n))}return t}function Wy(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t[n])}function qy(i){let t=i.size-1,e=0;for(let n=0;n<i.columns;n++)for(let r=0;r<i.rows;r++)e+=i.get(r,n)**2/t;return Math.sqrt(e)}function $y(i,t){for(let e=0;e<i.rows;e++)for(let n=0;n<i.columns;n++)i.set(e,n,i.get(e,n)/t)}var un=class i{static from1DArray(t,e,n){if(t*e!==n.length)throw new RangeError("data length does not match given dimensions");let s=new $t(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)s.set(o,a,n[o*e+a]);return s}static rowVector(t){let e=new $t(1,t.length);for(let n=0;n<t.length;n++)e.set(0,n,t[n]);return e}static columnVector(t){let e=new $t(t.length,1);for(let n=0;n<t.length;n++)e.set(n,0,t[n]);return e}static zeros(t,e){return new $t(t,e)}static ones(t,e){return new $t(t,e).fill(1)}static rand(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{random:r=Math.random}=n,s=new $t(t,e);for(let o=0;o<t;o++)for(let a=0;a<e;a++)s.set(o,a,r());return s}static randInt(t,e,n={}){if(typeof n!="object")throw new TypeError("options must be an object");let{min:r=0,max:s=1e3,random:o=Math.random}=n;if(!Number.isInteger(r))throw new TypeError("min must be an integer");if(!Number.isInteger(s))throw new TypeError("max must be an integer");if(r>=s)throw new RangeError("min must be smaller than max");let a=s-r,l=new $t(t,e);for(let c=0;c<t;c++)for(let u=0;u<e;u++){let h=r+Math.round(o()*a);l.set(c,u,h)}return l}static eye(t,e,n){e===void 0&&(e=t),n===void 0&&(n=1);let r=Math.min(t,e),s=this.zeros(t,e);for(let o=0;o<r;o++)s.set(o,o,n);return s}static diag(t,e,n){let r=t.length;e===void 0&&(e=r),n===void 0&&(n=e);let s=Math.min(r,e,n),o=this.zeros(e,n);for(let a=0;a<s;a++)o.set(a,a,t[a]);return o}static min(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,r=t.columns,s=new $t(n,r);for(let o=0;o<n;o++)for(let a=0;a<r;a++)s.set(o,a,Math.min(t.get(o,a),e.get(o,a)));return s}static max(t,e){t=this.checkMatrix(t),e=this.checkMatrix(e);let n=t.rows,r=t.columns,s=new this(n,r);for(let o=0;o<n;o++)for(let a=0;a<r;a++)s.set(o,a,Math.max(t.get(o,a),e.get(o,a)));return s}static checkMatrix(t){return i.isMatrix(t)?t:new $t(t)}static isMatrix(t){return t!=null&&t.klass==="Matrix"}get size(){return this.rows*this.columns}apply(t){if(typeof t!="function")throw new TypeError("callback must be a function");for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.call(this,e,n);return this}applyAlongAxis(t,e){if(typeof t!="function")throw new TypeError("callback must be a function");let n=[];switch(e){case"row":{for(let r=0;r<this.rows;r++)n.push(t.call(this,this.getRow(r),r));break}case"column":{for(let r=0;r<this.columns;r++)n.push(t.call(this,this.getColumn(r),r));break}default:throw new Error(`invalid option: ${e}`)}return n}to1DArray(){let t=[];for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.push(this.get(e,n));return t}to2DArray(){let t=[];for(let e=0;e<this.rows;e++){t.push([]);for(let n=0;n<this.columns;n++)t[e].push(this.get(e,n))}return t}toJSON(){return this.to2DArray()}isRowVector(){return this.rows===1}isColumnVector(){return this.columns===1}isVector(){return this.rows===1||this.columns===1}isSquare(){return this.rows===this.columns}isEmpty(){return this.rows===0||this.columns===0}isSymmetric(){if(this.isSquare()){for(let t=0;t<this.rows;t++)for(let e=0;e<=t;e++)if(this.get(t,e)!==this.get(e,t))return!1;return!0}return!1}isDistance(){if(!this.isSymmetric())return!1;for(let t=0;t<this.rows;t++)if(this.get(t,t)!==0)return!1;return!0}isEchelonForm(){let t=0,e=0,n=-1,r=!0,s=!1;for(;t<this.rows&&r;){for(e=0,s=!1;e<this.columns&&s===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(s=!0,n=e):(r=!1,s=!0);t++}return r}isReducedEchelonForm(){let t=0,e=0,n=-1,r=!0,s=!1;for(;t<this.rows&&r;){for(e=0,s=!1;e<this.columns&&s===!1;)this.get(t,e)===0?e++:this.get(t,e)===1&&e>n?(s=!0,n=e):(r=!1,s=!0);for(let o=e+1;o<this.rows;o++)this.get(t,o)!==0&&(r=!1);t++}return r}echelonForm(){let t=this.clone(),e=0,n=0;for(;e<t.rows&&n<t.columns;){let r=e;for(let s=e;s<t.rows;s++)t.get(s,n)>t.get(r,n)&&(r=s);if(t.get(r,n)===0)n++;else{t.swapRows(e,r);let s=t.get(e,n);for(let o=n;o<t.columns;o++)t.set(e,o,t.get(e,o)/s);for(let o=e+1;o<t.rows;o++){let a=t.get(o,n)/t.get(e,n);t.set(o,n,0);for(let l=n+1;l<t.columns;l++)t.set(o,l,t.get(o,l)-t.get(e,l)*a)}e++,n++}}return t}reducedEchelonForm(){let t=this.echelonForm(),e=t.columns,n=t.rows,r=n-1;for(;r>=0;)if(t.maxRow(r)===0)r--;else{let s=0,o=!1;for(;s<n&&o===!1;)t.get(r,s)===1?o=!0:s++;for(let a=0;a<r;a++){let l=t.get(a,s);for(let c=s;c<e;c++){let u=t.get(a,c)-l*t.get(r,c);t.set(a,c,u)}}r--}return t}set(){throw new Error("set method is unimplemented")}get(){throw new Error("get method is unimplemented")}repeat(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{rows:e=1,columns:n=1}=t;if(!Number.isInteger(e)||e<=0)throw new TypeError("rows must be a positive integer");if(!Number.isInteger(n)||n<=0)throw new TypeError("columns must be a positive integer");let r=new $t(this.rows*e,this.columns*n);for(let s=0;s<e;s++)for(let o=0;o<n;o++)r.setSubMatrix(this,this.rows*s,this.columns*o);return r}fill(t){for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,t);return this}neg(){return this.mulS(-1)}getRow(t){Di(this,t);let e=[];for(let n=0;n<this.columns;n++)e.push(this.get(t,n));return e}getRowVector(t){return $t.rowVector(this.getRow(t))}setRow(t,e){Di(this,t),e=Bs(this,e);for(let n=0;n<this.columns;n++)this.set(t,n,e[n]);return this}swapRows(t,e){Di(this,t),Di(this,e);for(let n=0;n<this.columns;n++){let r=this.get(t,n);this.set(t,n,this.get(e,n)),this.set(e,n,r)}return this}getColumn(t){Oi(this,t);let e=[];for(let n=0;n<this.rows;n++)e.push(this.get(n,t));return e}getColumnVector(t){return $t.columnVector(this.getColumn(t))}setColumn(t,e){Oi(this,t),e=zs(this,e);for(let n=0;n<this.rows;n++)this.set(n,t,e[n]);return this}swapColumns(t,e){Oi(this,t),Oi(this,e);for(let n=0;n<this.rows;n++){let r=this.get(n,t);this.set(n,t,this.get(n,e)),this.set(n,e,r)}return this}addRowVector(t){t=Bs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[n]);return this}subRowVector(t){t=Bs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[n]);return this}mulRowVector(t){t=Bs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[n]);return this}divRowVector(t){t=Bs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[n]);return this}addColumnVector(t){t=zs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)+t[e]);return this}subColumnVector(t){t=zs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)-t[e]);return this}mulColumnVector(t){t=zs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)*t[e]);return this}divColumnVector(t){t=zs(this,t);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)this.set(e,n,this.get(e,n)/t[e]);return this}mulRow(t,e){Di(this,t);for(let n=0;n<this.columns;n++)this.set(t,n,this.get(t,n)*e);return this}mulColumn(t,e){Oi(this,t);for(let n=0;n<this.rows;n++)this.set(n,t,this.get(n,t)*e);return this}max(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e[n]&&(e[n]=this.get(n,r));return e}case"column":{let e=new Array(this.columns).fill(Number.NEGATIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e[r]&&(e[r]=this.get(n,r));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>e&&(e=this.get(n,r));return e}default:throw new Error(`invalid option: ${t}`)}}maxIndex(){Vs(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)>t&&(t=this.get(n,r),e[0]=n,e[1]=r);return e}min(t){if(this.isEmpty())return NaN;switch(t){case"row":{let e=new Array(this.rows).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e[n]&&(e[n]=this.get(n,r));return e}case"column":{let e=new Array(this.columns).fill(Number.POSITIVE_INFINITY);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e[r]&&(e[r]=this.get(n,r));return e}case void 0:{let e=this.get(0,0);for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<e&&(e=this.get(n,r));return e}default:throw new Error(`invalid option: ${t}`)}}minIndex(){Vs(this);let t=this.get(0,0),e=[0,0];for(let n=0;n<this.rows;n++)for(let r=0;r<this.columns;r++)this.get(n,r)<t&&(t=this.get(n,r),e[0]=n,e[1]=r);return e}maxRow(t){if(Di(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)>e&&(e=this.get(t,n));return e}maxRowIndex(t){Di(this,t),Vs(this);let e=this.get(t,0),n=[t,0];for(let r=1;r<this.columns;r++)this.get(t,r)>e&&(e=this.get(t,r),n[1]=r);return n}minRow(t){if(Di(this,t),this.isEmpty())return NaN;let e=this.get(t,0);for(let n=1;n<this.columns;n++)this.get(t,n)<e&&(e=this.get(t,n));return e}minRowIndex(t){Di(this,t),Vs(this);let e=this.get(t,0),n=[t,0];for(let r=1;r<this.columns;r++)this.get(t,r)<e&&(e=this.get(t,r),n[1]=r);return n}maxColumn(t){if(Oi(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)>e&&(e=this.get(n,t));return e}maxColumnIndex(t){Oi(this,t),Vs(this);let e=this.get(0,t),n=[0,t];for(let r=1;r<this.rows;r++)this.get(r,t)>e&&(e=this.get(r,t),n[0]=r);return n}minColumn(t){if(Oi(this,t),this.isEmpty())return NaN;let e=this.get(0,t);for(let n=1;n<this.rows;n++)this.get(n,t)<e&&(e=this.get(n,t));return e}minColumnIndex(t){Oi(this,t),Vs(this);let e=this.get(0,t),n=[0,t];for(let r=1;r<this.rows;r++)this.get(r,t)<e&&(e=this.get(r,t),n[0]=r);return n}diag(){let t=Math.min(this.rows,this.columns),e=[];for(let n=0;n<t;n++)e.push(this.get(n,n));return e}norm(t="frobenius"){switch(t){case"max":return $t.abs(this).max();case"frobenius":return Math.sqrt(this.dot(this));default:throw new RangeError(`unknown norm type: ${t}`)}}cumulativeSum(){let t=0;for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t+=this.get(e,n),this.set(e,n,t);return this}dot(t){i.isMatrix(t)&&(t=t.to1DArray());let e=this.to1DArray();if(e.length!==t.length)throw new RangeError("vectors do not have the same size");let n=0;for(let r=0;r<e.length;r++)n+=e[r]*t[r];return n}mmul(t){t=$t.checkMatrix(t);let e=this.rows,n=this.columns,r=t.columns,s=new $t(e,r),o=new Float64Array(n);for(let a=0;a<r;a++){for(let l=0;l<n;l++)o[l]=t.get(l,a);for(let l=0;l<e;l++){let c=0;for(let u=0;u<n;u++)c+=this.get(l,u)*o[u];s.set(l,a,c)}}return s}gram(){let t=this.rows,e=this.columns,n=new Float64Array(e*e);for(let s=0;s<t;s++)for(let o=0;o<e;o++){let a=this.get(s,o);if(a===0)continue;let l=o*e;for(let c=o;c<e;c++)n[l+c]+=a*this.get(s,c)}let r=new $t(e,e);for(let s=0;s<e;s++){let o=s*e;for(let a=s;a<e;a++){let l=n[o+a];r.set(s,a,l),r.set(a,s,l)}}return r}transposeMultiply(t){if(t=$t.checkMatrix(t),this.rows!==t.rows)throw new RangeError("the number of rows of the two matrices must be equal");let e=this.columns,n=t.columns,r=new $t(e,n),s=new Float64Array(n);for(let o=0;o<this.rows;o++){for(let a=0;a<n;a++)s[a]=t.get(o,a);for(let a=0;a<e;a++){let l=this.get(o,a);if(l===0)continue;let c=r.data[a];for(let u=0;u<n;u++)c[u]+=l*s[u]}}return r}mmulByTranspose(t){let e=this.rows,n=this.columns;if(t!==void 0&&t.length!==n)throw new RangeError("scale must have one value per column");let r=new $t(e,e),s=new Float64Array(n);for(let o=0;o<e;o++){if(t===void 0)for(let a=0;a<n;a++)s[a]=this.get(o,a);else for(let a=0;a<n;a++)s[a]=t[a]*this.get(o,a);for(let a=o;a<e;a++){let l=0;for(let c=0;c<n;c++)l+=this.get(a,c)*s[c];r.set(a,o,l),r.set(o,a,l)}}return r}mpow(t){if(!this.isSquare())throw new RangeError("Matrix must be square");if(!Number.isInteger(t)||t<0)throw new RangeError("Exponent must be a non-negative integer");let e=$t.eye(this.rows),n=this;for(let r=t;r>=1;r/=2)(r&1)!==0&&(e=e.mmul(n)),n=n.mmul(n);return e}strassen2x2(t){t=$t.checkMatrix(t);let e=new $t(2,2),n=this.get(0,0),r=t.get(0,0),s=this.get(0,1),o=t.get(0,1),a=this.get(1,0),l=t.get(1,0),c=this.get(1,1),u=t.get(1,1),h=(n+c)*(r+u),f=(a+c)*r,d=n*(o-u),m=c*(l-r),y=(n+s)*u,g=(a-n)*(r+o),p=(s-c)*(l+u),x=h+m-y+p,_=d+y,v=f+m,M=h-f+d+g;return e.set(0,0,x),e.set(0,1,_),e.set(1,0,v),e.set(1,1,M),e}strassen3x3(t){t=$t.checkMatrix(t);let e=new $t(3,3),n=this.get(0,0),r=this.get(0,1),s=this.get(0,2),o=this.get(1,0),a=this.get(1,1),l=this.get(1,2),c=this.get(2,0),u=this.get(2,1),h=this.get(2,2),f=t.get(0,0),d=t.get(0,1),m=t.get(0,2),y=t.get(1,0),g=t.get(1,1),p=t.get(1,2),x=t.get(2,0),_=t.get(2,1),v=t.get(2,2),M=(n+r+s-o-a-u-h)*g,A=(n-o)*(-d+g),b=a*(-f+d+y-g-p-x+v),w=(-n+o+a)*(f-d+g),N=(o+a)*(-f+d),P=n*f,I=(-n+c+u)*(f-m+p),U=(-n+c)*(m-p),V=(c+u)*(-f+m),C=(n+r+s-a-l-c-u)*p,D=u*(-f+m+y-g-p-x+_),G=(-s+u+h)*(g+x-_),z=(s-h)*(g-_),et=s*x,$=(u+h)*(-x+_),X=(-s+a+l)*(p+x-v),tt=(s-l)*(p-v),ht=(a+l)*(-x+v),ct=r*y,J=l*_,dt=o*m,gt=c*d,bt=h*v,yt=P+et+ct,Gt=M+w+N+P+G+et+$,Kt=P+I+V+C+et+X+ht,zt=A+b+w+P+et+X+tt,le=A+w+N+P+J,oe=et+X+tt+ht+dt,Jt=P+I+U+D+G+z+et,Fe=G+z+et+$+gt,Ae=P+I+U+V+bt;return e.set(0,0,yt),e.set(0,1,Gt),e.set(0,2,Kt),e.set(1,0,zt),e.set(1,1,le),e.set(1,2,oe),e.set(2,0,Jt),e.set(2,1,Fe),e.set(2,2,Ae),e}mmulStrassen(t){t=$t.checkMatrix(t);let e=this.clone(),n=e.rows,r=e.columns,s=t.rows,o=t.columns;r!==s&&console.warn(`Multiplying ${n} x ${r} and ${s} x ${o} matrix: dimensions do not match.`);function a(h,f,d){let m=h.rows,y=h.columns;if(m===f&&y===d)return h;{let g=i.zeros(f,d);return g=g.setSubMatrix(h,0,0),g}}let l=Math.max(n,s),c=Math.max(r,o);e=a(e,l,c),t=a(t,l,c);function u(h,f,d,m){if(d<=512||m<=512)return h.mmul(f);d%2===1&&m%2===1?(h=a(h,d+1,m+1),f=a(f,d+1,m+1)):d%2===1?(h=a(h,d+1,m),f=a(f,d+1,m)):m%2===1&&(h=a(h,d,m+1),f=a(f,d,m+1));let y=parseInt(h.rows/2,10),g=parseInt(h.columns/2,10),p=h.subMatrix(0,y-1,0,g-1),x=f.subMatrix(0,y-1,0,g-1),_=h.subMatrix(0,y-1,g,h.columns-1),v=f.subMatrix(0,y-1,g,f.columns-1),M=h.subMatrix(y,h.rows-1,0,g-1),A=f.subMatrix(y,f.rows-1,0,g-1),b=h.subMatrix(y,h.rows-1,g,h.columns-1),w=f.subMatrix(y,f.rows-1,g,f.columns-1),N=u(i.add(p,b),i.add(x,w),y,g),P=u(i.add(M,b),x,y,g),I=u(p,i.sub(v,w),y,g),U=u(b,i.sub(A,x),y,g),V=u(i.add(p,_),w,y,g),C=u(i.sub(M,p),i.add(x,v),y,g),D=u(i.sub(_,b),i.add(A,w),y,g),G=i.add(N,U);G.sub(V),G.add(D);let z=i.add(I,V),et=i.add(P,U),$=i.sub(N,P);$.add(I),$.add(C);let X=i.zeros(2*G.rows,2*G.columns);return X=X.setSubMatrix(G,0,0),X=X.setSubMatrix(z,G.rows,0),X=X.setSubMatrix(et,0,G.columns),X=X.setSubMatrix($,G.rows,G.columns),X.subMatrix(0,d-1,0,m-1)}return u(e,t,l,c)}scaleRows(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let r=new $t(this.rows,this.columns);for(let s=0;s<this.rows;s++){let o=this.getRow(s);o.length>0&&Lc(o,{min:e,max:n,output:o}),r.setRow(s,o)}return r}scaleColumns(t={}){if(typeof t!="object")throw new TypeError("options must be an object");let{min:e=0,max:n=1}=t;if(!Number.isFinite(e))throw new TypeError("min must be a number");if(!Number.isFinite(n))throw new TypeError("max must be a number");if(e>=n)throw new RangeError("min must be smaller than max");let r=new $t(this.rows,this.columns);for(let s=0;s<this.columns;s++){let o=this.getColumn(s);o.length&&Lc(o,{min:e,max:n,output:o}),r.setColumn(s,o)}return r}flipRows(){let t=Math.ceil(this.columns/2);for(let e=0;e<this.rows;e++)for(let n=0;n<t;n++){let r=this.get(e,n),s=this.get(e,this.columns-1-n);this.set(e,n,s),this.set(e,this.columns-1-n,r)}return this}flipColumns(){let t=Math.ceil(this.rows/2);for(let e=0;e<this.columns;e++)for(let n=0;n<t;n++){let r=this.get(n,e),s=this.get(this.rows-1-n,e);this.set(n,e,s),this.set(this.rows-1-n,e,r)}return this}kroneckerProduct(t){t=$t.checkMatrix(t);let e=this.rows,n=this.columns,r=t.rows,s=t.columns,o=new $t(e*r,n*s);for(let a=0;a<e;a++)for(let l=0;l<n;l++)for(let c=0;c<r;c++)for(let u=0;u<s;u++)o.set(r*a+c,s*l+u,this.get(a,l)*t.get(c,u));return o}kroneckerSum(t){if(t=$t.checkMatrix(t),!this.isSquare()||!t.isSquare())throw new Error("Kronecker Sum needs two Square Matrices");let e=this.rows,n=t.rows,r=this.kroneckerProduct($t.eye(n,n)),s=$t.eye(e,e).kroneckerProduct(t);return r.add(s)}transpose(){let t=new $t(this.columns,this.rows);for(let e=0;e<this.rows;e++)for(let n=0;n<this.columns;n++)t.set(n,e,this.get(e,n));return t}sortRows(t=Xy){for(let e=0;e<this.rows;e++)this.setRow(e,this.getRow(e).sort(t));return this}sortColumns(t=Xy){for(let e=0;e<this.columns;e++)this.setColumn(e,this.getColumn(e).sort(t));return this}subMatrix(t,e,n,r){Td(this,t,e,n,r);let s=new $t(e-t+1,r-n+1);for(let o=t;o<=e;o++)for(let a=n;a<=r;a++)s.set(o-t,a-n,this.get(o,a));return s}subMatrixRow(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.columns-1),e>n||e<0||e>=this.columns||n<0||n>=this.columns)throw new RangeError("Argument out of range");let r=new $t(t.length,n-e+1);for(let s=0;s<t.length;s++)for(let o=e;o<=n;o++){if(t[s]<0||t[s]>=this.rows)throw new RangeError(`Row index out of range: ${t[s]}`);r.set(s,o-e,this.get(t[s],o))}return r}subMatrixColumn(t,e,n){if(e===void 0&&(e=0),n===void 0&&(n=this.rows-1),e>n||e<0||e>=this.rows||n<0||n>=this.rows)throw new RangeError("Argument out of range");let r=new $t(n-e+1,t.length);for(let s=0;s<t.length;s++)for(let o=e;o<=n;o++){if(t[s]<0||t[s]>=this.columns)throw new RangeError(`Column index out of range: ${t[s]}`);r.set(o-e,s,this.get(o,t[s]))}return r}setSubMatrix(t,e,n){if(t=$t.checkMatrix(t),t.isEmpty())return this;let r=e+t.rows-1,s=n+t.columns-1;Td(this,e,r,n,s);for(let o=0;o<t.rows;o++)for(let a=0;a<t.columns;a++)this.set(e+o,n+a,t.get(o,a));return this}concat(t,e="row"){switch(t=$t.checkMatrix(t),e){case"row":{if(this.columns!==t.columns)throw new RangeError("both matrices must have the same number of columns");let n=new $t(this.rows+t.rows,this.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,this.rows,0),n}case"column":{if(this.rows!==t.rows)throw new RangeError("both matrices must have the same number of rows");let n=new $t(this.rows,this.columns+t.columns);return n.setSubMatrix(this,0,0),n.setSubMatrix(t,0,this.columns),n}default:throw new Error(`invalid option: ${e}`)}}selection(t,e){Ty(this,t),Ry(this,e);let n=new $t(t.length,e.length);for(let r=0;r<t.length;r++){let s=t[r];for(let o=0;o<e.length;o++){let a=e[o];n.set(r,o,this.get(s,a))}}return n}trace(){let t=Math.min(this.rows,this.columns),e=0;for(let n=0;n<t;n++)e+=this.get(n,n);return e}clone(){return this.constructor.copy(this,new $t(this.rows,this.columns))}static copy(t,e){for(let[n,r,s]of t.entries())e.set(n,r,s);return e}sum(t){switch(t){case"row":return Cy(this);case"column":return Py(this);case void 0:return Iy(this);default:throw new Error(`invalid option: ${t}`)}}product(t){switch(t){case"row":return Ly(this);case"column":return Fy(this);case void 0:return Ny(this);default:throw new Error(`invalid option: ${t}`)}}mean(t){let e=this.sum(t);switch(t){case"row":{for(let n=0;n<this.rows;n++)e[n]/=this.columns;return e}case"column":{for(let n=0;n<this.columns;n++)e[n]/=this.rows;return e}case void 0:return e/this.size;default:throw new Error(`invalid option: ${t}`)}}variance(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{unbiased:n=!0,mean:r=this.mean(t)}=e;if(typeof n!="boolean")throw new TypeError("unbiased must be a boolean");switch(t){case"row":{if(!On(r))throw new TypeError("mean must be an array");return Dy(this,n,r)}case"column":{if(!On(r))throw new TypeError("mean must be an array");return Oy(this,n,r)}case void 0:{if(typeof r!="number")throw new TypeError("mean must be a number");return Uy(this,n,r)}default:throw new Error(`invalid option: ${t}`)}}standardDeviation(t,e){typeof t=="object"&&(e=t,t=void 0);let n=this.variance(t,e);if(t===void 0)return Math.sqrt(n);for(let r=0;r<n.length;r++)n[r]=Math.sqrt(n[r]);return n}center(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let{center:n=this.mean(t)}=e;switch(t){case"row":{if(!On(n))throw new TypeError("center must be an array");return ky(this,n),this}case"column":{if(!On(n))throw new TypeError("center must be an array");return By(this,n),this}case void 0:{if(typeof n!="number")throw new TypeError("center must be a number");return zy(this,n),this}default:throw new Error(`invalid option: ${t}`)}}scale(t,e={}){if(typeof t=="object"&&(e=t,t=void 0),typeof e!="object")throw new TypeError("options must be an object");let n=e.scale;switch(t){case"row":{if(n===void 0)n=Vy(this);else if(!On(n))throw new TypeError("scale must be an array");return Gy(this,n),this}case"column":{if(n===void 0)n=Hy(this);else if(!On(n))throw new TypeError("scale must be an array");return Wy(this,n),this}case void 0:{if(n===void 0)n=qy(this);else if(typeof n!="number")throw new TypeError("scale must be a number");return $y(this,n),this}default:throw new Error(`invalid option: ${t}`)}}toString(t){return Ed(this,t)}[Symbol.iterator](){return this.entries()}*entries(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield[t,e,this.get(t,e)]}*values(){for(let t=0;t<this.rows;t++)for(let e=0;e<this.columns;e++)yield this.get(t,e)}};un.prototype.klass="Matrix";typeof Symbol<"u"&&(un.prototype[Symbol.for("nodejs.util.inspect.custom")]=Ay);function Xy(i,t){return i-t}function m1(i){return i.every(t=>typeof t=="number")}un.random=un.rand;un.randomInt=un.randInt;un.diagonal=un.diag;un.prototype.diagonal=un.prototype.diag;un.identity=un.eye;un.prototype.negate=un.prototype.neg;un.prototype.tensorProduct=un.prototype.kroneckerProduct;var $t=class i extends un{data;#t(t,e){if(this.data=[],Number.isInteger(e)&&e>=0)for(let n=0;n<t;n++)this.data.push(new Float64Array(e));else throw new TypeError("nColumns must be a positive integer");this.rows=t,this.columns=e}constructor(t,e){if(super(),i.isMatrix(t))this.#t(t.rows,t.columns),i.copy(t,this);else if(Number.isInteger(t)&&t>=0)this.#t(t,e);else if(On(t)){let n=t;if(t=n.length,e=t?n[0].length:0,typeof e!="number")throw new TypeError("Data must be a 2D array with at least one element");this.data=[];for(let r=0;r<t;r++){if(n[r].length!==e)throw new RangeError("Inconsistent array dimensions");if(!m1(n[r]))throw new TypeError("Input data contains non-numeric values");this.data.push(Float64Array.from(n[r]))}this.rows=t,this.columns=e}else throw new TypeError("First argument must be a positive number or an array")}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}removeRow(t){return Di(this,t),this.data.splice(t,1),this.rows-=1,this}addRow(t,e){return e===void 0&&(e=t,t=this.rows),Di(this,t,!0),e=Float64Array.from(Bs(this,e)),this.data.splice(t,0,e),this.rows+=1,this}removeColumn(t){Oi(this,t);for(let e=0;e<this.rows;e++){let n=new Float64Array(this.columns-1);for(let r=0;r<t;r++)n[r]=this.data[e][r];for(let r=t+1;r<this.columns;r++)n[r-1]=this.data[e][r];this.data[e]=n}return this.columns-=1,this}addColumn(t,e){typeof e>"u"&&(e=t,t=this.columns),Oi(this,t,!0),e=zs(this,e);for(let n=0;n<this.rows;n++){let r=new Float64Array(this.columns+1),s=0;for(;s<t;s++)r[s]=this.data[n][s];for(r[s++]=e[n];s<this.columns+1;s++)r[s]=this.data[n][s-1];this.data[n]=r}return this.columns+=1,this}};Ey(un,$t);var Ha=class extends un{constructor(t){super(),this.data=t,this.rows=t.length,this.columns=t[0].length}set(t,e,n){return this.data[t][e]=n,this}get(t,e){return this.data[t][e]}};function Yy(i){let t=i.data,e=i.rows;for(let n=0;n<e;n++){let r=t[n];for(let s=n+1;s<e;s++){let o=r[s];r[s]=t[s][n],t[s][n]=o}}return i}function Rd(i,t){let e=0;return Math.abs(i)>Math.abs(t)?(e=t/i,Math.abs(i)*Math.sqrt(1+e*e)):t!==0?(e=i/t,Math.abs(t)*Math.sqrt(1+e*e)):0}var as=class{constructor(t,e={}){let{assumeSymmetric:n=!1}=e;if(t=Ha.checkMatrix(t),!t.isSquare())throw new Error("Matrix is not a square matrix");if(t.isEmpty())throw new Error("Matrix must be non-empty");let r=t.columns,s=new $t(r,r),o=new Float64Array(r),a=new Float64Array(r),l=t,c,u,h=!1;if(n?h=!0:h=t.isSymmetric(),h){for(c=0;c<r;c++)for(u=0;u<r;u++)s.set(u,c,l.get(c,u));g1(r,a,o,s),y1(r,a,o,s),Yy(s)}else{let f=new $t(r,r),d=new Float64Array(r);for(u=0;u<r;u++)for(c=0;c<r;c++)f.set(c,u,l.get(c,u));x1(r,f,d,s),v1(r,a,o,s,f)}this.n=r,this.e=a,this.d=o,this.V=s}get realEigenvalues(){return Array.from(this.d)}get imaginaryEigenvalues(){return Array.from(this.e)}get eigenvectorMatrix(){return this.V}get diagonalMatrix(){let t=this.n,e=this.e,n=this.d,r=new $t(t,t),s,o;for(s=0;s<t;s++){for(o=0;o<t;o++)r.set(s,o,0);r.set(s,s,n[s]),e[s]>0?r.set(s,s+1,e[s]):e[s]<0&&r.set(s,s-1,e[s])}return r}};function g1(i,t,e,n){let r,s,o,a,l,c,u,h;for(l=0;l<i;l++)e[l]=n.get(l,i-1);for(a=i-1;a>0;a--){for(h=0,o=0,c=0;c<a;c++)h=h+Math.abs(e[c]);if(h===0)for(t[a]=e[a-1],l=0;l<a;l++)e[l]=n.get(l,a-1),n.set(l,a,0),n.set(a,l,0);else{for(c=0;c<a;c++)e[c]/=h,o+=e[c]*e[c];for(r=e[a-1],s=Math.sqrt(o),r>0&&(s=-s),t[a]=h*s,o=o-r*s,e[a-1]=r-s,l=0;l<a;l++)t[l]=0;for(l=0;l<a;l++){for(r=e[l],n.set(a,l,r),s=t[l]+n.get(l,l)*r,c=l+1;c<=a-1;c++)s+=n.get(l,c)*e[c],t[c]+=n.get(l,c)*r;t[l]=s}for(r=0,l=0;l<a;l++)t[l]/=o,r+=t[l]*e[l];for(u=r/(o+o),l=0;l<a;l++)t[l]-=u*e[l];for(l=0;l<a;l++){for(r=e[l],s=t[l],c=l;c<=a-1;c++)n.set(l,c,n.get(l,c)-(r*t[c]+s*e[c]));e[l]=n.get(l,a-1),n.set(l,a,0)}}e[a]=o}for(a=0;a<i-1;a++){if(n.set(a,i-1,n.get(a,a)),n.set(a,a,1),o=e[a+1],o!==0){for(c=0;c<=a;c++)e[c]=n.get(a+1,c)/o;for(l=0;l<=a;l++){for(s=0,c=0;c<=a;c++)s+=n.get(a+1,c)*n.get(l,c);for(c=0;c<=a;c++)n.set(l,c,n.get(l,c)-s*e[c])}}for(c=0;c<=a;c++)n.set(a+1,c,0)}for(l=0;l<i;l++)e[l]=n.get(l,i-1),n.set(l,i-1,0);n.set(i-1,i-1,1),t[0]=0}function y1(i,t,e,n){let r,s,o,a,l,c,u,h,f,d,m,y,g,p,x,_,v;for(o=1;o<i;o++)t[o-1]=t[o];t[i-1]=0;let M=0,A=0,b=Number.EPSILON;for(c=0;c<i;c++){for(A=Math.max(A,Math.abs(e[c])+Math.abs(t[c])),u=c;u<i&&!(Math.abs(t[u])<=b*A);)u++;if(u>c){v=0;do{for(v=v+1,r=e[c],h=(e[c+1]-r)/(2*t[c]),f=Rd(h,1),h<0&&(f=-f),e[c]=t[c]/(h+f),e[c+1]=t[c]*(h+f),d=e[c+1],s=r-e[c],o=c+2;o<i;o++)e[o]-=s;for(M=M+s,h=e[u],m=1,y=m,g=m,p=t[c+1],x=0,_=0,o=u-1;o>=c;o--)for(g=y,y=m,_=x,r=m*t[o],s=m*h,f=Rd(h,t[o]),t[o+1]=x*f,x=t[o]/f,m=h/f,h=m*e[o]-x*r,e[o+1]=s+x*(m*r+x*e[o]),l=0;l<i;l++)s=n.get(o+1,l),n.set(o+1,l,x*n.get(o,l)+m*s),n.set(o,l,m*n.get(o,l)-x*s);h=-x*_*g*p*t[c]/d,t[c]=x*h,e[c]=m*h}while(Math.abs(t[c])>b*A)}e[c]=e[c]+M,t[c]=0}for(o=0;o<i-1;o++){for(l=o,h=e[o],a=o+1;a<i;a++)e[a]<h&&(l=a,h=e[a]);if(l!==o)for(e[l]=e[o],e[o]=h,a=0;a<i;a++)h=n.get(o,a),n.set(o,a,n.get(l,a)),n.set(l,a,h)}}function x1(i,t,e,n){let r=0,s=i-1,o,a,l,c,u,h,f;for(h=r+1;h<=s-1;h++){for(f=0,c=h;c<=s;c++)f=f+Math.abs(t.get(c,h-1));if(f!==0){for(l=0,c=s;c>=h;c--)e[c]=t.get(c,h-1)/f,l+=e[c]*e[c];for(a=Math.sqrt(l),e[h]>0&&(a=-a),l=l-e[h]*a,e[h]=e[h]-a,u=h;u<i;u++){for(o=0,c=s;c>=h;c--)o+=e[c]*t.get(c,u);for(o=o/l,c=h;c<=s;c++)t.set(c,u,t.get(c,u)-o*e[c])}for(c=0;c<=s;c++){for(o=0,u=s;u>=h;u--)o+=e[u]*t.get(c,u);for(o=o/l,u=h;u<=s;u++)t.set(c,u,t.get(c,u)-o*e[u])}e[h]=f*e[h],t.set(h,h-1,f*a)}}for(c=0;c<i;c++)for(u=0;u<i;u++)n.set(c,u,c===u?1:0);for(h=s-1;h>=r+1;h--)if(t.get(h,h-1)!==0){for(c=h+1;c<=s;c++)e[c]=t.get(c,h-1);for(u=h;u<=s;u++){for(a=0,c=h;c<=s;c++)a+=e[c]*n.get(c,u);for(a=a/e[h]/t.get(h,h-1),c=h;c<=s;c++)n.set(c,u,n.get(c,u)+a*e[c])}}}function v1(i,t,e,n,r){let s=i-1,o=0,a=i-1,l=Number.EPSILON,c=0,u=0,h=0,f=0,d=0,m=0,y=0,g=0,p,x,_,v,M,A,b,w,N,P,I,U,V,C,D;for(p=0;p<i;p++)for((p<o||p>a)&&(e[p]=r.get(p,p),t[p]=0),x=Math.max(p-1,0);x<i;x++)u=u+Math.abs(r.get(p,x));for(;s>=o;){for(v=s;v>o&&(m=Math.abs(r.get(v-1,v-1))+Math.abs(r.get(v,v)),m===0&&(m=u),!(Math.abs(r.get(v,v-1))<l*m));)v--;if(v===s)r.set(s,s,r.get(s,s)+c),e[s]=r.get(s,s),t[s]=0,s--,g=0;else if(v===s-1){if(b=r.get(s,s-1)*r.get(s-1,s),h=(r.get(s-1,s-1)-r.get(s,s))/2,f=h*h+b,y=Math.sqrt(Math.abs(f)),r.set(s,s,r.get(s,s)+c),r.set(s-1,s-1,r.get(s-1,s-1)+c),w=r.get(s,s),f>=0){for(y=h>=0?h+y:h-y,e[s-1]=w+y,e[s]=e[s-1],y!==0&&(e[s]=w-b/y),t[s-1]=0,t[s]=0,w=r.get(s,s-1),m=Math.abs(w)+Math.abs(y),h=w/m,f=y/m,d=Math.sqrt(h*h+f*f),h=h/d,f=f/d,x=s-1;x<i;x++)y=r.get(s-1,x),r.set(s-1,x,f*y+h*r.get(s,x)),r.set(s,x,f*r.get(s,x)-h*y);for(p=0;p<=s;p++)y=r.get(p,s-1),r.set(p,s-1,f*y+h*r.get(p,s)),r.set(p,s,f*r.get(p,s)-h*y);for(p=o;p<=a;p++)y=n.get(p,s-1),n.set(p,s-1,f*y+h*n.get(p,s)),n.set(p,s,f*n.get(p,s)-h*y)}else e[s-1]=w+h,e[s]=w+h,t[s-1]=y,t[s]=-y;s=s-2,g=0}else{if(w=r.get(s,s),N=0,b=0,v<s&&(N=r.get(s-1,s-1),b=r.get(s,s-1)*r.get(s-1,s)),g===10){for(c+=w,p=o;p<=s;p++)r.set(p,p,r.get(p,p)-w);m=Math.abs(r.get(s,s-1))+Math.abs(r.get(s-1,s-2)),w=N=.75*m,b=-.4375*m*m}if(g===30&&(m=(N-w)/2,m=m*m+b,m>0)){for(m=Math.sqrt(m),N<w&&(m=-m),m=w-b/((N-w)/2+m),p=o;p<=s;p++)r.set(p,p,r.get(p,p)-m);c+=m,w=N=b=.964}for(g=g+1,M=s-2;M>=v&&(y=r.get(M,M),d=w-y,m=N-y,h=(d*m-b)/r.get(M+1,M)+r.get(M,M+1),f=r.get(M+1,M+1)-y-d-m,d=r.get(M+2,M+1),m=Math.abs(h)+Math.abs(f)+Math.abs(d),h=h/m,f=f/m,d=d/m,!(M===v||Math.abs(r.get(M,M-1))*(Math.abs(f)+Math.abs(d))<l*(Math.abs(h)*(Math.abs(r.get(M-1,M-1))+Math.abs(y)+Math.abs(r.get(M+1,M+1))))));)M--;for(p=M+2;p<=s;p++)r.set(p,p-2,0),p>M+2&&r.set(p,p-3,0);for(_=M;_<=s-1&&(C=_!==s-1,_!==M&&(h=r.get(_,_-1),f=r.get(_+1,_-1),d=C?r.get(_+2,_-1):0,w=Math.abs(h)+Math.abs(f)+Math.abs(d),w!==0&&(h=h/w,f=f/w,d=d/w)),w!==0);_++)if(m=Math.sqrt(h*h+f*f+d*d),h<0&&(m=-m),m!==0){for(_!==M?r.set(_,_-1,-m*w):v!==M&&r.set(_,_-1,-r.get(_,_-1)),h=h+m,w=h/m,N=f/m,y=d/m,f=f/h,d=d/h,x=_;x<i;x++)h=r.get(_,x)+f*r.get(_+1,x),C&&(h=h+d*r.get(_+2,x),r.set(_+2,x,r.get(_+2,x)-h*y)),r.set(_,x,r.get(_,x)-h*w),r.set(_+1,x,r.get(_+1,x)-h*N);for(p=0;p<=Math.min(s,_+3);p++)h=w*r.get(p,_)+N*r.get(p,_+1),C&&(h=h+y*r.get(p,_+2),r.set(p,_+2,r.get(p,_+2)-h*d)),r.set(p,_,r.get(p,_)-h),r.set(p,_+1,r.get(p,_+1)-h*f);for(p=o;p<=a;p++)h=w*n.get(p,_)+N*n.get(p,_+1),C&&(h=h+y*n.get(p,_+2),n.set(p,_+2,n.get(p,_+2)-h*d)),n.set(p,_,n.get(p,_)-h),n.set(p,_+1,n.get(p,_+1)-h*f)}}}if(u!==0){for(s=i-1;s>=0;s--)if(h=e[s],f=t[s],f===0)for(v=s,r.set(s,s,1),p=s-1;p>=0;p--){for(b=r.get(p,p)-h,d=0,x=v;x<=s;x++)d=d+r.get(p,x)*r.get(x,s);if(t[p]<0)y=b,m=d;else if(v=p,t[p]===0?r.set(p,s,b!==0?-d/b:-d/(l*u)):(w=r.get(p,p+1),N=r.get(p+1,p),f=(e[p]-h)*(e[p]-h)+t[p]*t[p],A=(w*m-y*d)/f,r.set(p,s,A),r.set(p+1,s,Math.abs(w)>Math.abs(y)?(-d-b*A)/w:(-m-N*A)/y)),A=Math.abs(r.get(p,s)),l*A*A>1)for(x=p;x<=s;x++)r.set(x,s,r.get(x,s)/A)}else if(f<0)for(v=s-1,Math.abs(r.get(s,s-1))>Math.abs(r.get(s-1,s))?(r.set(s-1,s-1,f/r.get(s,s-1)),r.set(s-1,s,-(r.get(s,s)-h)/r.get(s,s-1))):(D=Dc(0,-r.get(s-1,s),r.get(s-1,s-1)-h,f),r.set(s-1,s-1,D[0]),r.set(s-1,s,D[1])),r.set(s,s-1,0),r.set(s,s,1),p=s-2;p>=0;p--){for(P=0,I=0,x=v;x<=s;x++)P=P+r.get(p,x)*r.get(x,s-1),I=I+r.get(p,x)*r.get(x,s);if(b=r.get(p,p)-h,t[p]<0)y=b,d=P,m=I;else if(v=p,t[p]===0?(D=Dc(-P,-I,b,f),r.set(p,s-1,D[0]),r.set(p,s,D[1])):(w=r.get(p,p+1),N=r.get(p+1,p),U=(e[p]-h)*(e[p]-h)+t[p]*t[p]-f*f,V=(e[p]-h)*2*f,U===0&&V===0&&(U=l*u*(Math.abs(b)+Math.abs(f)+Math.abs(w)+Math.abs(N)+Math.abs(y))),D=Dc(w*d-y*P+f*I,w*m-y*I-f*P,U,V),r.set(p,s-1,D[0]),r.set(p,s,D[1]),Math.abs(w)>Math.abs(y)+Math.abs(f)?(r.set(p+1,s-1,(-P-b*r.get(p,s-1)+f*r.get(p,s))/w),r.set(p+1,s,(-I-b*r.get(p,s)-f*r.get(p,s-1))/w)):(D=Dc(-d-N*r.get(p,s-1),-m-N*r.get(p,s),y,f),r.set(p+1,s-1,D[0]),r.set(p+1,s,D[1]))),A=Math.max(Math.abs(r.get(p,s-1)),Math.abs(r.get(p,s))),l*A*A>1)for(x=p;x<=s;x++)r.set(x,s-1,r.get(x,s-1)/A),r.set(x,s,r.get(x,s)/A)}for(p=0;p<i;p++)if(p<o||p>a)for(x=p;x<i;x++)n.set(p,x,r.get(p,x));for(x=i-1;x>=o;x--)for(p=o;p<=a;p++){for(y=0,_=o;_<=Math.min(x,a);_++)y=y+n.get(p,_)*r.get(_,x);n.set(p,x,y)}}}function Dc(i,t,e,n){let r,s;return Math.abs(e)>Math.abs(n)?(r=n/e,s=e+r*n,[(i+r*t)/s,(t-r*i)/s]):(r=e/n,s=n+r*e,[(r*i+t)/s,(r*t-i)/s])}var _1=1e-9,b1=1e-13,w1=1e-6;function jy(i,t,e){let n=Tc(i,e);if(!n)throw new Error("mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate");let[r,s]=[0,0];for(let h=0;h<e;h+=1)for(let f=0;f<e;f+=1)r=Math.max(r,Math.abs(t[h*e+f]-t[f*e+h])),s=Math.max(s,Math.abs(t[h*e+f]));if(r>_1*s)return{...Pd(n,Cd(Rc(n,t,e),e,!1),e),symmetric:!1};let o=t.map((h,f)=>(h+t[f%e*e+Math.floor(f/e)])/2),a=Tc(o,e),l=a&&Cd(Rc(a,i,e),e,!0),c=l?Math.max(...l.re):0;if(!a||!l||Math.min(...l.re)<=0||1/c<=b1*e/Math.min(...l.re))return{...Pd(n,Cd(Rc(n,o,e),e,!0),e),symmetric:!0};let u=Pd(a,{re:l.re.map(h=>1/h),vectors:l.vectors},e);return{squares:u.squares,shapes:u.shapes.map((h,f)=>h*Math.sqrt(u.squares[f%e])),symmetric:!0}}function Cd(i,t,e){let n=e?i.map((c,u)=>(c+i[u%t*t+Math.floor(u/t)])/2):i,r=new as($t.from1DArray(t,t,n),{assumeSymmetric:e}),{realEigenvalues:s,imaginaryEigenvalues:o,eigenvectorMatrix:a}=r,l=Float64Array.from(a.to1DArray());if(!e){for(let c=1;c<t;c+=1)if(o[c]<0)for(let u=0;u<t;u+=1)l[u*t+c]=l[u*t+c-1]}for(let c=0;c<t;c+=1){let u=Math.hypot(...Array.from({length:t},(h,f)=>l[f*t+c]));for(let h=0;h<t;h+=1)l[h*t+c]/=u}return{re:Float64Array.from(s),vectors:l}}function Pd(i,{re:t,vectors:e},n){let r=Array.from(t.keys()).sort((o,a)=>t[o]-t[a]),s=new Float64Array(n*n);return r.forEach((o,a)=>{for(let l=0;l<n;l+=1)s[l*n+a]=e[l*n+o]}),yd(i,s,n,n),{squares:Float64Array.from(r,o=>t[o]),shapes:s}}function Zy(i,t,e,n,r){let s=r.symmetric?r.shapes:S1(i,n),o=y=>si(s,si(y,s,n,n,n),n,n,n,!0),[a,l]=[o(e),o(t)];if(r.symmetric)for(let y=0;y<n*n;y+=1)a[y]=y%(n+1)?0:r.squares[y/(n+1)];let c=Array.from({length:n},(y,g)=>Math.sqrt(Math.abs(a[g*(n+1)]))),u=w1*Math.max(...c)||1,h=c.map(y=>Math.max(y,u)),f=$t.zeros(2*n,2*n);for(let y=0;y<n;y+=1){f.set(y,n+y,h[y]);for(let g=0;g<n;g+=1)f.set(n+y,g,-a[y*n+g]/h[g]),f.set(n+y,n+g,-l[y*n+g])}let d=new as(f,{assumeSymmetric:!1}),m={re:Float64Array.from(d.realEigenvalues),im:Float64Array.from(d.imaginaryEigenvalues)};return{count:2*n,values:m,shapes:M1(d.eigenvectorMatrix,m.im,s,h,n)}}function M1(i,t,e,n,r){let s={re:new Float64Array(2*r*r),im:new Float64Array(2*r*r)};for(let o=0;o<2*r;o+=1)for(let a=0;a<r;a+=1)s.re[2*r*a+o]=i.get(a,t[o]<0?o-1:o)/n[a],s.im[2*r*a+o]=(t[o]>0?i.get(a,o+1):t[o]<0?-i.get(a,o):0)/n[a];return{re:si(e,s.re,r,r,2*r),im:si(e,s.im,r,r,2*r)}}function S1(i,t){let e=Float64Array.from({length:t*t},(n,r)=>r%(t+1)?0:1);return yd(Tc(i,t),e,t,t),e}var A1=["settling","vibration.residual","vibration.nominal"];function Mi(i,t=3){return Pe(i,t)}function Id(i,t){if(i.length<2)return t[0];let e=0;for(let n=1;n<i.length;n+=1)e+=(t[n]+t[n-1])/2*(i[n]-i[n-1]);return e/(i[i.length-1]-i[0])}function Jy(i,t,e,n){let r={},{tip_error:s}=t;if(s){let a=Float64Array.from(i,(l,c)=>Na(s,c,-1));r["tip_error.commanded"]=Ky(i,a,s,n)}let o=t.deviation?.data;return o&&(r["deviation.max"]=Ky(i,o,t.tip_error_nominal,n),r["deviation.rms"]={value:Math.sqrt(Id(i,o.map(a=>a*a))),note:"over the run"}),{...r,...E1(i,e,o!==void 0)}}function Ky(i,t,e,n){let r=Va(t),s=`at ${Mi(i[r])} s; ${Gn(t[t.length-1],"m")} at the end of the run`,a=(e?hi(0,e.shape[1]).map(l=>[Na(e,r,l),n[l]]):[]).filter(([l])=>l).map(([l,c])=>`${Gn(l,"m")} ${c??"geometry"}`);return{value:t[r],note:s,time:i[r],more:a.join(", ")}}function E1(i,t,e){let n=i[i.length-1];if(t!==null&&t<=n*(1+1e-9))return{};let r="what moves the robot changes up to the end of the run",s=`the run ends at ${Mi(n,6)} s, the move at ${Mi(t??0,6)} s`,o=t===null?r:`${s}: simulate longer to see it settle`,a={value:null,note:t===null?r:"the run ends with the move"},l={settling:{value:null,note:`not seen: ${o}`},"vibration.residual":a};return e?{...l,"vibration.nominal":a}:l}function Qy(i){let t={},e=A1.filter(n=>n!=="vibration.nominal"||"deviation.max"in i);for(let n of e)t[n]={value:null,note:"the run broke off"};for(let[n,r]of Object.entries(i))e.includes(n)||(t[n]={...r,note:`until it broke off: ${r.note}`});return t}function tx(i,t){if(!i.energy||!i.energy_balance)return{};let{energy:e,work:n}=i,r=e.shape[1],s=Math.max(e.data.reduce((l,c,u)=>Math.max(l,Math.abs(c-e.data[u%r])),0),n.data.reduce((l,c)=>Math.max(l,Math.abs(c)),0)),o=Math.abs(i.energy_balance.data[Va(i.energy_balance.data.subarray(0,t))]),a=s?`worst residual, ${Gn(o,"J")}, over ${Gn(s,"J")} moved`:"nothing moved";return{"energy.residual":{value:s?o/s:null,note:a}}}var T1=8,Ld=1e-5,R1=Math.SQRT1_2,C1=1e-9;function ex(i,t,e,n){let r=Object.entries(i).flatMap(([a,l])=>l.filter(c=>c.frequency>0).slice(0,T1).map(c=>[a,c])),s=I1(r,e,n),o=t.flatMap(a=>a.rings&&a.damping<R1?[{at:a.rings,label:a.element}]:[]);return{vibration:{modes:s,marks:o.sort((a,l)=>a.at-l.at)},facts:P1(i)}}function P1({controlled:i,locked:t}){if(!i)return{};let e=o=>o.reduce((a,{rings:l,frequency:c})=>l&&c<(a??1/0)?c:a,null),[n,r]=[e(i),e(t??[])],s=n===null?"no vibration under control":r===null?"":`${Mi(r,4)} Hz with the motors locked`;return{"frequency.first":{value:n,note:s}}}function I1(i,t,e){let n=t.length,r=new Float64Array((1+4*i.length)*n);r.set(t),i.forEach(([,{re:u,im:h}],f)=>{let d=u.reduce((m,y,g)=>Math.max(m,Math.hypot(y,h[g])),0);for(let m=0;m<n;m+=1){let[y,g]=[Ld*u[m]/d,Ld*h[m]/d];[y,g,-y,-g].forEach((p,x)=>{r[(1+4*f+x)*n+m]=t[m]+p})}});let{data:s,shape:o}=e(r,1+4*i.length),a=s.length/(1+4*i.length),l=u=>Float64Array.from({length:a},(h,f)=>(s[u*a+f]-s[(u+2)*a+f])/(2*Ld)),c=u=>({data:Float32Array.from(u),shape:o.slice(1)});return i.map(([u,h],f)=>{let[d,m]=L1(l(1+4*f),l(2+4*f));return{case:u,frequency:h.frequency,damping:h.damping,element:h.element,rest:c(s.subarray(0,a)),real:c(d),imaginary:c(m)}})}function L1(i,t){let[e,n]=[0,0];for(let c=0;c<i.length;c+=3){let u=Math.hypot(...i.subarray(c,c+3),...t.subarray(c,c+3));u>n&&([e,n]=[c,u])}if(!n)return[i,t];let r=[0,1,2].map(c=>Math.hypot(i[e+c],t[e+c])),s=e+r.indexOf(Math.max(...r)),o=Math.hypot(i[s],t[s])*n,[a,l]=[i[s]/o,-t[s]/o];return[i.map((c,u)=>a*c-l*t[u]),i.map((c,u)=>l*c+a*t[u])]}function nx(i,t){let[e,n]=[i.values.re[t],i.values.im[t]],r=Math.hypot(e,n);return{size:r,rings:n>C1*r?n/(2*Math.PI):null,damping:r?-e/r:0}}function ix(i,t,e,n,r){let s=o=>Float64Array.from({length:e},(a,l)=>{let c=0;for(let u=0;u<n;u+=1)c+=r(l,u)*o[u*i.count+t];return c});return{re:s(i.shapes.re),im:s(i.shapes.im)}}function rx(i,t,e,n){let{count:r,shapes:s}=t,o=g=>p=>{if(!n)return g(p);let x=0;for(let _=0;_<e;_+=1)x+=n[p*e+_]*g(_);return x},a=(g,p)=>{let x=0;for(let _=0;_<e;_+=1)x+=g(_)*p(_);return x},l=Fd(i.shapes,e,e),[c,u]=[Fd(s.re,e,r),Fd(s.im,e,r)],h=l.map(g=>Float64Array.from({length:e},(p,x)=>o(_=>g[_])(x))),f=g=>a(p=>g[p],o(p=>g[p])),[d,m]=[l.map(g=>Math.sqrt(f(g))),c.map((g,p)=>Math.sqrt(f(g)+f(u[p])))],y=new Float64Array(e*r);for(let g=0;g<e;g+=1)for(let p=0;p<r;p+=1){let[x,_]=[c,u].map(v=>a(M=>h[g][M],M=>v[p][M]));y[g*r+p]=Math.hypot(x,_)/(d[g]*m[p])}return y}function Fd(i,t,e){return Array.from({length:e},(n,r)=>Float64Array.from({length:t},(s,o)=>i[o*e+r]))}function F1({values:i,count:t}){let e=Array.from({length:t},(n,r)=>Math.hypot(i.re[r],i.im[r]));return{rings:e.map((n,r)=>i.im[r]>1e-9*n),stands:e.map((n,r)=>Math.abs(i.im[r])<=1e-9*n)}}function sx(i,t,e){let{count:n,values:r}=t,{rings:s,stands:o}=F1(t),a=new Float64Array(n);Array.from({length:n},(c,u)=>u).sort((c,u)=>r.re[u]-r.re[c]).forEach((c,u)=>{a[c]=u});let l=Float64Array.from(i,(c,u)=>{let h=u%n;return!s[h]&&!o[h]?100:a[h]/(10*n)-c*c-(s[h]?10:0)});return N1(l,e,n)}function N1(i,t,e){let[n,r]=[new Float64Array(t+1),new Float64Array(e+1)],s=new Int32Array(e+1);for(let a=1;a<=t;a+=1){let l=new Float64Array(e+1).fill(1/0),c=new Int32Array(e+1),u=new Uint8Array(e+1);s[0]=a;let h=0;for(;s[h];){u[h]=1;let[f,d]=[1/0,0];for(let m=1;m<=e;m+=1){if(u[m])continue;let y=i[(s[h]-1)*e+m-1]-n[s[h]]-r[m];y<l[m]&&(l[m]=y,c[m]=h),l[m]<f&&(f=l[m],d=m)}for(let m=0;m<=e;m+=1)u[m]?(n[s[m]]+=f,r[m]-=f):l[m]-=f;h=d}for(;h;h=c[h])s[h]=s[c[h]]}let o=new Array(t).fill(-1);for(let a=1;a<=e;a+=1)s[a]&&(o[s[a]-1]=a-1);return o}var D1=1e-13,O1=1e-13,U1="whole arm, free",k1="whole arm, in its weight and loads";function lx(i,t,e,{blocks:n,schedule:r,info:s},o){if(!t.modes)return{vibration:t.noModes,facts:{}};try{let{rest:a,linear:l}=ox(i,t,e,r,sn(t.modes.rest)),c=Object.fromEntries(t.modes.cases.map(({name:y,moving:g})=>[y,ax(t,n,l,y,g)])),{name:u,moving:h}=t.modes.cases.find(y=>y.name==="controlled"&&y.moving.length)??t.modes.cases.find(y=>y.name==="locked"),f=B1(t,s,r,o),d=f&&ox(i,t,e,r,f,o.times[o.times.length-1]).linear,m=d?ax(t,n,d,u,h):[];return ex(c,m,a,(y,g)=>Ic(i,t,n,y,g).line)}catch(a){return{vibration:a instanceof Error?a.message:String(a),facts:{}}}}function ox(i,t,e,n,r,s=0){let o=null;return _d(t,e,"real",r,(a,l)=>(o=vy(i,t,ks(t.map,a,"real"),n,l,s),o&&o.rest)),o}function B1(i,t,e,n){if(!i.modes.end)return null;let r=sn(i.modes.end).slice(),[s,o]=[n.times[n.times.length-1],n.series.q.data.subarray(-r.length)],a=new Map(t.commanded);for(let l=0;l<r.length;l+=1){let c=a.get(l);i.modes.free.includes(l)||(r[l]=c===void 0?o[l]:ss(e,c,s))}return r}function ax(i,t,e,n,r){let s=Math.sqrt(e.mass.length),o=r.length;if(!o)return[];let a=g=>Float64Array.from({length:o*o},(p,x)=>g[r[Math.floor(x/o)]*s+r[x%o]]),[l,c,u]=[a(e.mass),a(e.damping),a(e.stiffness)],h=n==="controlled";h&&i.modes.servos.forEach(({coordinate:g},p)=>{let x=r.indexOf(g)*(o+1);u[x]+=t.servos[2*p],c[x]+=t.servos[2*p+1]});let f=jy(l,u,o),d=Zy(l,c,u,o,f),m=sx(rx(f,d,o,l),d,o),y=O1*o*f.squares.reduce((g,p)=>Math.max(g,Math.abs(p)),0);return Array.from({length:o},(g,p)=>{let x=new Float64Array(s);r.forEach((U,V)=>{x[U]=f.shapes[V*o+p]});let _=z1(i,t,e.elastic,x,h),v=ix(d,m[p],s,o,(U,V)=>r[V]===U?1:0),M=f.squares[p],A=_.reduce((U,{energy:V})=>U+V,0);if(Math.abs(M)<=y&&A<=y)return{frequency:0,rings:null,damping:0,element:U1,...v};let{size:b,rings:w,damping:N}=nx(d,m[p]),P=(h&&w?b:Math.sqrt(Math.max(M,0)))/(2*Math.PI),I=_.reduce((U,V)=>V.energy>U.energy?V:U,_[0]);return{frequency:P,rings:w,damping:Math.abs(N)>D1?N:0,element:A>y&&I?I.element:k1,...v}})}function z1(i,t,e,n,r){let s=n.length,o=u=>{let h=0;for(let f=0;f<s;f+=1)h+=e[u*s+f]*n[f];return h},{springs:a,servos:l}=i.modes,c=a.map(({element:u,rows:h,gear:f})=>{if(!f)return{element:u,energy:h.reduce((m,y)=>m+n[y]*o(y),0)};let d=e[h[0]*(s+1)];return{element:u,energy:d?o(h[0])**2/d:0}});return r?[...c,...l.map(({coordinate:u,element:h},f)=>({element:h,energy:t.servos[2*f]*n[u]**2}))]:c}var cx=1e-6,V1=1e-11,ux=.5,Nd=40,G1=.1,hx=24;async function fx(i,t,e,n,r,s,o){let{free:a,gross:l}=t.split;if(!a.length)return{};let c=r.length,u=s.q.shape[1],h=p=>mr({matrix:l,constant:{data:new Float64Array(u),shape:[u]}},s[p].data,c),f=Ac(t,e,n,r,s),d={engine:i,blocks:e,free:a,size:u,places:f.length/c,weight:sn(t.split.weight),q:s.q.data.slice(),rates:h("v"),gains:h("a"),wrenches:f},m=s.deformation.data,y=null;for(let p=0;p<c;p+=hx){let x=Array.from({length:Math.min(hx,c-p)},(_,v)=>p+v);if(p&&H1(d,m,mr(t.deflections,d.q.subarray((p-1)*u,p*u),1),x),y=W1(d,s.q.data,x,y),!y)return{};await o()}let g=mr(t.deflections,d.q,c);return{deformation_stationary:we(g,c,a.length),deformation_oscillatory:we(os(m,g),c,a.length)}}function H1(i,t,e,n){let r=i.free.length;for(let s of n)i.free.forEach((o,a)=>{i.q[s*i.size+o]+=e[a]-t[s*r+a]})}function Ud(i,t,e){let{engine:n,blocks:r,free:s,size:o}=i,a={q:t,v:ji(i.rates,o,e),a:ji(i.gains,o,e),base:i.weight,wrenches:ji(i.wrenches,i.places,e)},l=Pc(n,r,a,e.length),c=n.sample("elastic",r.chain,a,e.length).forces;return Float64Array.from({length:e.length*s.length},(u,h)=>{let f=Math.floor(h/s.length)*o+s[h%s.length];return l[f]+c[f]})}function Od(i,t,e){let{free:n,size:r}=i,s=n.length,o=new Float64Array((s+1)*r);for(let l=0;l<=s;l+=1)o.set(t,l*r);n.forEach((l,c)=>{o[c*r+l]+=cx});let a=Ud(i,o,new Array(s+1).fill(e));return dy(Float64Array.from({length:s*s},(l,c)=>(a[c%s*s+Math.floor(c/s)]-a[s*s+Math.floor(c/s)])/cx),s)}function W1(i,t,e,n){let r=l=>i.q.subarray(l*i.size,(l+1)*i.size),s=l=>Od(i,r(l[l.length>>1]),l[l.length>>1]),o=n??s(e);if(!o)return null;let a=Dd(i,e,o,Nd);a.length&&(o=s(a)??o),a=Dd(i,a,o,Nd);for(let l of a){let[c,u]=[Nd,[l]];for(;u.length&&c;c-=1){let h=Od(i,r(l),l);u=h?Dd(i,u,h,3):u}u.length&&q1(i,t,l)}return o}function Dd(i,t,e,n){let{free:r,size:s,q:o}=i,a=r.length,l=[],c=new Map,u=t;for(let h=0;h<n&&u.length;h+=1){let f=Ud(i,ji(o,s,u),u);u=u.filter((d,m)=>{let y=si(e,f.subarray(m*a,(m+1)*a),a,a,1),g=y.reduce((_,v)=>Math.max(_,Math.abs(v)),0),p=g>ux?ux/g:1;if(!Number.isFinite(g))return l.push(d)&&!1;if(r.forEach((_,v)=>{o[d*s+_]-=p*y[v]}),g<V1)return!1;let x=g>G1*(c.get(d)??1/0);return c.set(d,g),x?l.push(d)&&!1:!0})}return[...l,...u]}function q1(i,t,e){let n=t.slice(e*i.size,(e+1)*i.size),r=Od(i,n,e);if(i.q.set(n,e*i.size),!r)return;let s=i.free.length,o=si(r,Ud(i,n,[e]),s,s,1);i.free.forEach((a,l)=>{i.q[e*i.size+a]-=o[l]})}var $1=50;async function dx(i,t,e,n,r,s){let o=performance.now(),a=async(h=!1)=>{if(!(!h&&performance.now()-o<$1)){if(await new Promise(f=>setTimeout(f,0)),s.cancelled?.())throw new Or("a newer run began");o=performance.now()}};await a(!0);let{vibration:l,facts:c}=lx(i,t,e,r,n);await a(!0);let u=await fx(i,t,r.blocks,r.schedule,n.times,n.series,a);return{...n,vibration:l,facts:{...n.facts,...c},series:{...n.series,...u}}}function px(i,{strengths:t,places:e,kept:n},r){let s=[i.every>1?`one sample in ${i.every}`:"",n>e.data.length?`${e.data.length} places along each link`:""],o=s.some(Boolean)?` (looked at: ${s.filter(Boolean).join(", ")})`:"",a=f=>i.links.flatMap(({largest:d})=>d[f]??[]),l=(f,d)=>{let m=kd(d,({value:p})=>p),y=m&&f!=="deflection.max"?` at s = ${Mi(m.s,2)}`:"",g=m?r[m.sample]:0;return m?{[f]:{value:m.value,note:`${m.link}${y}, at ${Mi(g)} s${o}`,time:g}}:{}},c=kd(a("stress").filter(({link:f})=>f in t),({link:f,value:d})=>d/t[f]),u=c?t[c.link]:1,h=c&&`of ${Gn(u,"Pa")}, ${c.link}; margin ${Mi(100*(1-c.value/u))} %${o}`;return{...l("deflection.max",a("deflection")),...l("moment.max",a("moment")),...l("stress.max",a("stress")),...c&&h?{"stress.share":{value:100*c.value/u,note:h}}:{}}}function mx(i,t){let e=kd(i.flatMap(n=>X1(n,t)),({share:n})=>n);return e?{"limits.share":{value:100*e.share,note:e.note}}:{}}function X1({joint:i,coordinate:t,drive:e,unit:n,effortUnit:r,speed:s,effort:o,range:a},l){let c=(h,f,d=0)=>Sn(l[h].data,l[h].shape[1],[f]).reduce((m,y)=>Math.max(m,Math.abs(y-d)),0),u=(h,f,d,m)=>({share:h/f,note:`${d} of ${i}: ${Gn(h,m)} of ${Gn(f,m)}`});return[...s?[u(c("v",t),s,"speed",`${n}/s`)]:[],...o&&e>=0?[u(c("effort",e),o,"effort",r)]:[],...a?[{share:c("q",t,a[0])/a[1],note:`range of ${i}, from its middle`}]:[]]}function kd(i,t){return i.reduce((e,n)=>e===null||t(n)>t(e)?n:e,null)}var Oc=["y","z"],Y1=[{id:"deflection",of:"deflection",label:"Deflection",unit:"m",planes:Oc},{id:"slope",of:"slope",label:"Slope",unit:"rad",planes:Oc},{id:"moment",of:"moment",label:"Moment",unit:"N m",planes:["torsion",...Oc]},{id:"shear_force",of:"shear",label:"Shear force",unit:"N",planes:Oc}];function gx(i,t,e){if(!t.length)return null;let n=i.stations.data,[r,s]=[t.length,n.length],o=Float64Array.from({length:r*s},(a,l)=>t[Math.floor(l/s)].length*n[l%s]);return{links:t.map(a=>a.name),places:{data:o,shape:[r,s]},quantities:Y1.map(({id:a,of:l,label:c,unit:u,planes:h})=>{let f=new Float64Array(e*r*s*h.length);return t.forEach((d,m)=>xx(d[l],f,e,m,r,s*h.length)),{id:a,label:c,unit:u,planes:[...h],values:{data:f,shape:[e,r,s,h.length]}}})}}function yx(i,t,e){let[n,r]=[i.links.length,i.stations.data.length],s=(l,c,u,h)=>{let f=new Float64Array(e*n*r);return i.links.forEach((d,m)=>{let y=d.bends?t.find(p=>p.name===d.name):void 0,g=y&&h(y);g&&xx(g,f,e,m,n,r)}),{id:l,label:c,unit:u,values:{data:f,shape:[e,n,r]}}};if(!t.length)return[];let a=[s("bending_moment","Bending moment","N m",({moment:l})=>Float64Array.from({length:e*r},(c,u)=>Math.sqrt(l[3*u+1]**2+l[3*u+2]**2))),s("torsion","Torsional moment","N m",({moment:l})=>Float64Array.from({length:e*r},(c,u)=>Math.abs(l[3*u]))),s("deflection","Deflection from the root's tangent","m",({deflection:l})=>Lo(l,2))];return t.some(l=>l.stress)?[...a,s("stress","Largest stress (von Mises)","Pa",({stress:l})=>l&&l.mises),s("strain","Largest strain","1",({stress:l})=>l&&l.strain)]:a}function xx(i,t,e,n,r,s){for(let o=0;o<e;o+=1)t.set(i.subarray(o*s,(o+1)*s),(o*r+n)*s)}function vx(i,t,{run:e,real:n,facts:r,reported:s}){let{times:o,series:a}=e,l=my(t,o.length),c=by(i,t,n.blocks,a,o,n.schedule,l),u=yx(t,c.links,l.length);return{...e,scene:wy(i,t,n.blocks,a,o,l,u),line:gx(t,c.links,l.length),facts:s({...r,...px(c,t.carried,o)})}}var j1=1e-12;function wx(i,t,[e,n],[r,s],o){if(!t.errorParts||!r||!e)return{};let a=(s??r).model.q.slice(),l=a.length/o;for(let[p,x]of[...e.info.commanded,...e.info.exact])for(let _=0;_<o;_+=1)a[_*l+p]=ss(e.schedule,x,e.run.times[_]);let c=bx(i,t,e,r,a,o),u=n&&Mx(n.blocks.chain,e.blocks.chain)?c[0]:void 0,h=s&&n?bx(i,t,n,s,a,o,u):c,f=_x(c),d=os(c[0],h[0]),m=_x(h);(t.errorParts.length>f.length||d.subarray(0,3).some(p=>Math.abs(p)>j1))&&(f.push(d),m.push(new Float64Array(d.length)));let y=p=>{let x=new Float64Array(3*o*p.length);return p.forEach((_,v)=>{for(let M=0;M<o;M+=1)for(let A=0;A<3;A+=1)x[3*(M*p.length+v)+A]=_[3*M+A]}),we(x,o,p.length,3)},g={tip_commanded:we(h[0],o,3),tip_error:y(f)};return s&&(g.tip_error_nominal=y(f.map((p,x)=>os(p,m[x])))),g}function _x(i){return i.slice(1).map((t,e)=>os(t,i[e]))}function Mx(i,t){return i.every((e,n)=>e===t[n])}function bx(i,t,e,{model:{q:n},points:r},s,o,a){let l=n.length/o,[c,u]=[s.slice(),n.slice()];for(let x=0;x<n.length;x+=l){for(let _ of e.info.driven)c[x+_]=n[x+_];for(let _ of t.bends)u[x+_]=0}let h=x=>Sn(x,x.length/o,[9,10,11]),f=new Float64Array(l),[d,m]=[n,h(r)],y=[m],g=x=>mr(t.straight,x,o),p=[u,g(c),g(s)];for(let x of p){if(a&&x===p[2])m=a;else if(!Mx(x,d)){let _={q:x,v:f,a:f,base:sn(t.base)};m=h(i.sample("inertia",e.blocks.chain,_,o,["points"]).points)}d=x,y.unshift(m)}return y}function Ax(i,t,e,n){let s={...Jy(t,e,n,i.errorParts??[]),...tx(e,t.length)},o=i.deformations.flatMap((d,m)=>d.endsWith(".gear")?[m]:[]),a=o.filter(d=>i.turning.includes(i.deformations[d].replace(/\.gear$/,""))),l=a.length?a:o;if(l.length){let d=Sn(e.deformation.data,i.deformations.length,l),m=l.length<o.length?" (of the gears that turn)":"",{value:y,note:g}=Sx(t,d,l.map(p=>i.deformations[p].replace(/\.gear$/,"")));s["gear.max"]={value:y,note:`${g}${m}`}}let{drives:c}=i.layout,u=hi(0,c.length),h=u.filter(d=>i.turning.includes(c[d]));for(let[d,m]of[["gear_torque",h.length?h:u],["voltage",u]]){if(!e[d])continue;let y=Sx(t,Sn(e[d].data,c.length,m),m.map(g=>c[g]));y.value&&(s[`${d}.max`]=y)}let f=e.contact_force_normal?.data;if(f){let[d,m]=[f.reduce((y,g)=>Math.min(y,g)),f.reduce((y,g)=>Math.max(y,g))];s["contact.mean"]={value:Id(t,f),note:`from ${Mi(d,4)} to ${Mi(m,4)} N`}}return s}function Sx(i,t,e){let n=Va(t),r=`${e[n%e.length]}, at ${Mi(i[Math.floor(n/e.length)])} s`;return{value:Math.abs(t[n]),note:r,time:i[Math.floor(n/e.length)]}}var Z1=100;function K1(i,t,e,n,r){let s=new Float64Array(1),o={time:s,row:Sc(n,s),step:new Float64Array(1)};for(let a=0;`${t}.switched`in i.layout.samples&&a<Z1;a+=1){let l=r;if(r=i.sample(`${t}.switched`,e.parameters,{...o,state:r},1).state,r.every((c,u)=>c===l[u]))break}return r}async function Ex(i,t,e,n,r,s){let{settings:o}=t,a=t.runs[n],l=hi(0,a.signals).map(h=>fd(r[`knots.${h}`],r[`coefficients.${h}`])),c=ay(l.map(h=>dd(h,o.duration)));l.length||(c.knots[1]=o.duration);let u=await ny(i,{loop:`${n}.${o.method}`,parameters:r.parameters,knots:c.knots,rows:sy(c),state:K1(i,n,r,c,xy(i,t,e,n,c)),times:sn(t.times),settings:o},s);return{name:n,info:a,blocks:r,each:l,schedule:c,run:u}}var gr=24;function Bd(i,t,e,n){let r=e.run.times.subarray(0,n),s=e.run.states.subarray(0,n*(e.run.states.length/e.run.times.length)),o=Sc(e.schedule,r),a={time:r,state:s,row:o,step:new Float64Array(1)},l=i.sample(`${e.name}.observe`,e.blocks.parameters,a,n),{q:c,v:u,a:h}=l,f=sn(t.base),{points:d}=i.sample("inertia",e.blocks.chain,{q:c,v:u,a:h,base:f},n,["points"]);return{regime:e,model:l,points:d}}function J1(i,t,{regime:e,model:{q:n,v:r}},s){let{chain:o,rotors:a}=e.blocks,l=a.length,c=sn(t.base),u=new Float64Array(l),h=i.sample("inertia",o,{q:n,v:u,a:r,base:c},s,["forces","moment"]),f=i.sample("elastic",o,{q:n,v:r,base:c},s,["energies"]).energies,d=f.length/s,m=new Float64Array(4*s);for(let y=0;y<s;y+=1){for(let g=0;g<l;g+=1){let p=r[y*l+g];m[4*y]+=(h.forces[y*l+g]+a[g]*p)*p/2}for(let g=0;g<3;g+=1)m[4*y+1]-=h.moment[3*y+g]*t.gravity.data[g];for(let g=0;g<d;g+=1)m[4*y+2+g%2]+=f[y*d+g]}return m}function Tx(i,t,e,n,r){let{model:s,points:o}=n,a=J1(i,t,n,r),l=s.q.length/r,c=s.gear.length/r,u=o.length/r/gr,h=e.run.states.length/e.run.times.length,f=Sn(e.run.states.subarray(0,r*h),h,hi(...e.info.state.works)),d=_=>we(Sn(s.drives,4*c,hi(0,c).map(v=>4*v+_)),r,c),m=_=>Sn(o,u*gr,hi(0,u).flatMap(v=>hi(0,3).map(M=>v*gr+_+M))),y=Sn(o,u*gr,hi(0,u).flatMap(_=>hi(_*gr,_*gr+9))),g={q:we(s.q,r,l),v:we(s.v,r,l),a:we(s.a,r,l),deformation:we(mr(t.deflections,s.q,r),r,t.deformations.length),position:we(m(9),r,u,3),velocity:we(m(12),r,u,3),acceleration:we(m(18),r,u,3),rotation:we(y,r,u,3,3),tip:we(Sn(o,u*gr,[9,10,11]),r,3),tip_velocity:we(Sn(o,u*gr,[12,13,14]),r,3),energy:we(a,r,4),work:we(f,r,f.length/r),energy_balance:we(_y(a,f,r,3),r)};c&&Object.assign(g,{wanted:d(3),effort:d(0),gear_torque:we(s.gear,r,c)}),c&&t.electric&&Object.assign(g,{voltage:d(1),current:d(2)});let p=hi(...e.info.state.controls);if(p.length){let _=Sn(e.run.states.subarray(0,r*h),h,p);g.controller_states=we(_,r,p.length)}if(t.contactPoint<0)return g;let x=_=>Sn(s.contact,6,_);return{...g,contact_force:we(x([0,1,2]),r,3),contact_force_normal:we(x([3]),r),penetration:we(x([4]),r)}}function Rx(i,t,e,n){let r=e.model.q.length/n,s=e.points.length/n/gr,[o,a]=[t,e].map(({points:c})=>Sn(c,s*gr,[9,10,11])),l={q_nominal:we(e.model.q,n,r),v_nominal:we(e.model.v,n,r),deformation_nominal:we(mr(i.deflections,e.model.q,n),n,i.deformations.length),gear_torque_nominal:we(e.model.gear,n,e.model.gear.length/n),tip_nominal:we(a,n,3),deviation:we(Lo(os(o,a),3),n)};return i.contactPoint>=0&&(l.contact_force_normal_nominal=we(Sn(e.model.contact,6,[3]),n)),l}var Cx=32,Q1=1e-6;function Px(i,t){let{wanted:e}=t;return e?i.setpoints.map(n=>Sn(e.data,e.shape[1],[n])):[]}function Ix(i,t,e){let n=i.length-(tA(i)?1:0),r=i[i.length-1],s=t===null?-1:i.findIndex(l=>l>=t*(1+1e-9));if(s>=0&&n-s>=Cx)return[i[s],r];let[o,a]=nA(eA(n,e));return a-o>=Cx?[i[o],i[a-1]]:[i[0],r]}function tA(i){let t=i.length;return t>2&&Math.abs((i[t-1]-i[t-2])/(i[1]-i[0])-1)>1e-6}function eA(i,t){let e=new Array(Math.max(i,0)).fill(!1);if(i<3||!t.length)return e;let n=new Float64Array(i);for(let s of t)for(let o=1;o<i-1;o+=1)n[o]=Math.max(n[o],Math.abs(s[o+1]-2*s[o]+s[o-1]));let r=Q1*Math.max(Number.MIN_VALUE,n.reduce((s,o)=>Math.max(s,o),0));for(let s=1;s<i-1;s+=1)e[s]=n[s]<=r;return e}function nA(i){let[t,e]=[[0,0],-1];for(let n=0;n<=i.length;n+=1)n<i.length&&i[n]?e=e<0?n:e:e>=0&&(n-e>t[1]-t[0]&&(t=[e,n]),e=-1);return t}async function Lx(i,t,e,n,r){let s=performance.now(),o=t.runs.reference?1/2:1,a=(M,A)=>()=>{let b=w=>n.progress?.(A+o*w);return Ex(i,t,e,M,ks(t.map,e,M),{...n,progress:b})},l=t.runs.reference&&await r.of(ks(t.map,e,"reference"),async()=>({regime:await a("reference",0)(),seen:new Map})),c=await a("real",1-o)(),u=(performance.now()-s)/1e3,h=Math.min(c.run.times.length,l?.regime.run.times.length??1/0),f=Bd(i,t,c,h),d=l&&iA(i,t,l,h),m=c.run.times.subarray(0,h),y={...Tx(i,t,c,f,h),...d?Rx(t,f,d,h):{},...wx(i,t,[c,l?.regime],[f,d],h)},g=ly(c.info.moving.map(M=>c.each[M])),p=[l?.regime,c].find(M=>M&&M.run.status!=="finished"),x={...Ax(t,m,y,g),...mx(t.carried.limits,y)},_=M=>p?Qy(M):M;return{run:{status:p?p.run.status:"finished",message:p?`${p===c?"actual robot":"nominal run"}: ${p.run.message}`:c.run.message,seconds:u,times:m,series:y,span:Ix(m,g,Px(t,y)),facts:_(x)},real:c,facts:x,reported:_}}function iA(i,t,{regime:e,seen:n},r){let s=n.get(r)??Bd(i,t,e,r);return n.clear(),n.set(r,s),s}async function Fx(i){let t=await wc.open(i.module.data,i.layout),e=new Mc;return{async run(n,r,s=()=>{}){let o=await Lx(t,i,n,r,e),{real:a,run:{times:l,series:c}}=o,u=[l,c,a];if(s(o.run,u),await new Promise(f=>setTimeout(f,0)),r.cancelled?.())throw new Or("a newer run began");let h=vx(t,i,o);return s(h,u),dx(t,i,n,h,a,r)}}}function Nx(i,t){let e=i.map(r=>typeof r=="object"&&"parts"in r&&rA(r.optional,t)),n=i.some((r,s)=>e[s]&&typeof r=="object"&&"optional"in r&&r.optional>=0);return i.map((r,s)=>typeof r=="string"?r:"header"in r?n?r.header:"":e[s]?r.parts.map(o=>typeof o=="string"?o:sA(o,t)).join(""):"").join("")}function rA(i,t){return i<0||t[i]!==1}function sA(i,t){let e=t[i.slider];return oA(i.base===null?e:i.base*e)}function oA(i){let[t,e]=String(i).split("e"),n=t.includes(".")?t:`${t}.0`;return e===void 0?n:`${n}e${e}`}var Fo=class extends Error{name="Superseded"};async function Dx(i){let t=i,e=await lA(t)??await aA(t),n=r=>{if(r.length!==t.sliders.length||!r.every(Number.isFinite))throw new Error(`values: got ${r.length}; expected ${t.sliders.length} finite numbers, one of each slider`)};return{sliders:t.sliders,async run(r,s=()=>{},o=()=>{}){return n(r),e.run(r,s,o)},sheet(r){return n(r),Nx(t.sheet,r)},close:()=>e.close()}}async function aA(i){let t=await Fx(i),e=0,n=Promise.resolve();return{async run(r,s,o){let a=e+=1,l=()=>a!==e,c=n.then(()=>{if(l())throw new Fo("a newer run began");return t.run(r,{cancelled:l,progress:s},o)});n=c.catch(()=>{});try{return await c}catch(u){throw u instanceof Or?new Fo(u.message):u}},close:()=>e+=1}}async function lA(i){if(typeof Worker>"u"||typeof document>"u")return null;let t=URL.createObjectURL(new Blob([ty],{type:"text/javascript"}));try{let e=new Worker(t);if(await cA(e,i))return uA(e);e.terminate()}catch{}finally{URL.revokeObjectURL(t)}return null}function cA(i,t){return new Promise(e=>{i.onmessage=({data:n})=>e(n.kind==="ready"),i.onerror=()=>e(!1),i.postMessage({kind:"open",bundle:t})})}function uA(i){let t=0,e=null,n=null,r=s=>{n?.reject(s),n=null};return i.onerror=s=>r(new Error(s.message)),i.onmessage=({data:s})=>{!("id"in s)||s.id!==t||!n||(s.kind==="progress"?n.progress(s.share):s.kind==="early"?n.early(e=ud(e,s.run)):s.kind==="error"?r(new Error(s.message)):s.kind==="done"&&(n.resolve(ud(e,s.run)),n=null))},{run(s,o,a){return r(new Fo("a newer run began")),t+=1,e=null,i.postMessage({kind:"run",id:t,values:s}),new Promise((l,c)=>n={resolve:l,reject:c,progress:o,early:a})},close(){r(new Fo("the live model was closed")),i.terminate()}}}function No(i){return i!==null&&i.vibration===void 0}function Uc(i){let t=0;return{begin(){t||=window.setTimeout(i,300)},end(){clearTimeout(t),t=0}}}var hA=7;function zd(i,t,e){let n=[];i.hidden=t.runs.every(a=>a.facts.length===0),t.runs.length>1?i.append(rt("h3",{class:"offscreen",text:"Numbers"}),mA(t,n)):i.append(fA(t.runs[0].facts,n,e));let r=null,s=Uc(()=>n.forEach(a=>a(r,!0))),o=a=>{r=a,No(a)?s.begin():s.end(),n.forEach(l=>l(a,!1))};return o(null),{show:o}}function fA(i,t,e){let n=[...i].sort((o,a)=>+(o.value===null)-+(a.value===null)),r=rt("dl",{class:"facts"},...n.map((o,a)=>dA(o,a>=hA,t,e))),s=Be("all, with notes",()=>{s.setAttribute("aria-pressed",String(r.classList.toggle("all")))},{class:"tool","aria-pressed":"false"});return rt("div",{},rt("div",{class:"bar"},rt("h3",{text:"Numbers"}),s),r)}function dA(i,t,e,n){let r=rt("strong"),s=rt("span",{class:"was"}),o=rt("dd",{class:"note"}),a=!1,l=null,c=rt("button",{type:"button",class:"jump"});c.addEventListener("click",()=>l!==null&&n.seek(l));let u=rt("dd",{},r,s);e.push((f,d)=>{let m=f?.facts[i.id];if(!m&&No(f)){d&&ze(s,a?"of the setting before":"of the original run"),d&&(s.hidden=!1);return}a=m!==void 0;let y=m?`${pA(i,m.value)} was ${Gn(i.value,i.unit)}`:"of the original run";ze(r,Gn(m?m.value:i.value,i.unit)),ze(s,f?y:""),ze(o,[(m??i).note,(m??i).more].filter(Boolean).join("; ")),s.hidden=f===null||m!==void 0&&m.value===null&&i.value===null,o.hidden=o.textContent==="",h.title=o.textContent??"",l=(m?m.time:i.time)??null,l===null?c.replaceWith(r):c.contains(r)||(r.replaceWith(c),c.append(r)),c.title=l===null?"":`go to t = ${Pe(l)} s`});let h=rt("div",{"data-fact":i.id,class:t?"rest":void 0},rt("dt",{text:i.name}),u,o);return h}function pA(i,t){if(t===null||i.value===null||i.value===0)return"";let e=100*(t-i.value)/Math.abs(i.value);if(Math.abs(e)<.05)return"";let n=Math.abs(e)>=1e3?"1000 % and more":`${Number(Math.abs(e).toPrecision(2))} %`;return`${e>0?"+":"−"}${n},`}function mA(i,t){let e=new Map;for(let o of i.runs.flatMap(a=>a.facts))e.has(o.id)||e.set(o.id,o);let n=rt("tr",{},rt("td",{}),...i.runs.map(o=>rt("th",{scope:"col",text:o.name}))),r=[...e.values()].map(o=>rt("tr",{"data-fact":o.id},rt("th",{scope:"row",text:o.name}),...i.runs.map((a,l)=>{let c=rt("td",{class:"number"}),u=a.facts.find(h=>h.id===o.id);return t.push(h=>{let f=l===0?h?.facts[o.id]:void 0;l===0&&!f&&No(h)||(ze(c,Gn(f?f.value:u?.value??null,u?.unit??o.unit)),c.title=(f??u)?.note??"")}),c}))),s=rt("table",{},rt("thead",{},n),rt("tbody",{},...r));return rt("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Numbers of the runs"},s)}var Ux=150,Ox="12px system-ui, sans-serif";function kx(i,t,e){let n=t.runs[0].line,r=t.runs[0].scene.times.data,s=[],o=!1,a=!1,l="",c=rt("div",{class:"line-grid"}),u=rt("p",{class:"note"});i.append(u,c);let h=_c(()=>a?f():m(!0));function f(){a=!1;let v=n===null?"":gA(n);v===l?s.forEach((M,A)=>M.take(n.quantities[A])):d(),l=v,m()}function d(){s.forEach(({plot:v})=>v.destroy()),c.replaceChildren(),s=n===null?[]:n.quantities.map(v=>vA(c,n,v))}function m(v=o){if(n===null||a)return;if(!v)return h.ask();let M=xA(r,e.time);u.textContent=`${n.links.join(", ")}: along the links from root to tip, at ${Pe(r[M],4)} s. The scales are those of the whole run.`;let A=Bx(n);for(let{plot:b,quantity:w,factor:N}of s){let P=w.planes.map((I,U)=>yA(n,w.values,M,U,w.planes.length,N));b.setData([A,...P])}}let y=matchMedia("(prefers-color-scheme: dark)"),g=()=>s.forEach(({plot:v})=>v.redraw());y.addEventListener("change",g);let p=new ResizeObserver(()=>s.forEach(({plot:v})=>{let M=v.root.parentElement?.clientWidth??0;M>0&&M!==v.width&&v.setSize({width:M,height:Ux})}));p.observe(c);let x=new IntersectionObserver(v=>{o=v.some(M=>M.isIntersecting),o&&a?f():m()});x.observe(i);let _=e.subscribe(()=>m());return f(),{show(v){n=v?v.line??null:t.runs[0].line,r=(v?.scene??t.runs[0].scene).times.data,a=!0,o?f():h.ask()},dispose(){_(),h.end(),p.disconnect(),x.disconnect(),y.removeEventListener("change",g),s.forEach(({plot:v})=>v.destroy()),i.replaceChildren()}}}function gA(i){let{links:t,places:e,quantities:n}=i;return JSON.stringify([t,Array.from(e.data),n.map(({id:r,label:s,unit:o,planes:a})=>[r,s,o,a])])}function Bx(i){let t=i.places.shape[1],e=[],n=0;for(let r=0;r<i.links.length;r+=1){for(let s=0;s<t;s+=1)e.push(n+i.places.data[r*t+s]+(s===0&&r>0?1e-9:0));n=e[e.length-1]}return e}function yA(i,t,e,n,r,s){let o=i.links.length*i.places.shape[1],a=e*o*r;return Array.from({length:o},(l,c)=>s*t.data[a+c*r+n])}function xA(i,t){let e=0,n=i.length-1;for(;n-e>1;){let r=e+n>>1;i[r]<=t?e=r:n=r}return Math.abs(i[n]-t)<Math.abs(i[e]-t)?n:e}function vA(i,t,e){let n=[0,1],r=e.planes.map((g,p)=>Fa("real",p,!0,1)),s=rt("div",{class:"plot-area",role:"img"}),o=rt("span",{class:"unit"}),a=rt("div",{class:"legend"},...e.planes.map((g,p)=>rt("span",{class:"key"},Ql(`var(${r[p].property})`,r[p].dash),rt("span",{text:g})))),l=rt("h4",{text:e.label},o);i.append(rt("figure",{class:"chart"},rt("figcaption",{},l,a),s));let c={stroke:()=>gn("--grid"),width:1},u={stroke:()=>gn("--quiet"),font:Ox,grid:c,ticks:{...c,size:4}},h=Bx(t),f=t.links.slice(1).map((g,p)=>h[(p+1)*t.places.shape[1]]),m={plot:new cn({width:Math.max(s.clientWidth,120),height:Ux,legend:{show:!1},padding:[8,14,0,0],cursor:{show:!1},scales:{x:{time:!1},y:{range:()=>n}},axes:[{...u,label:"along the links [m]",labelSize:18,labelFont:Ox,size:30,values:(g,p)=>p.map(ri)},{...u,size:(g,p)=>16+7*Math.max(2,...(p??[]).map(x=>x.length)),values:(g,p)=>p.map(ri)}],series:[{},...r.map(g=>({stroke:()=>gn(g.property),dash:g.dash,width:1.6,points:{show:!1}}))],hooks:{draw:[g=>_A(g,f)]}},[h,...r.map(()=>h.map(()=>0))],s),quantity:e,factor:1,take:y};function y(g){let[p,x]=[0,0];for(let M of g.values.data)M<p&&(p=M),M>x&&(x=M);let _=Ua(g.unit,Math.max(-p,x)),v=.06*(x-p)||1;n=[(p-v)*_.factor,(x+v)*_.factor],[m.quantity,m.factor]=[g,_.factor],ze(o,` [${_.name||"–"}]`),s.setAttribute("aria-label",`${g.label} along the links, between ${ri(p*_.factor)} and ${ri(x*_.factor)} ${_.name}`)}return y(e),m}function _A(i,t){let{ctx:e,bbox:n}=i;e.save(),e.strokeStyle=gn("--quiet"),e.setLineDash([3,3]);for(let r of t){let s=i.valToPos(r,"x",!0);e.beginPath(),e.moveTo(s,n.top),e.lineTo(s,n.top+n.height),e.stroke()}e.restore()}function Vx(i){let t=["Frequency [Hz]","Damping [%]","Dominant element",""].map(a=>rt(a?"th":"td",a?{scope:"col",text:a}:{})),e=rt("tbody"),n=rt("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Modes"},rt("table",{},rt("thead",{},rt("tr",{},...t)),e)),r=[],s=a=>(r[Math.min(a,r.length-1)]?.button??n).focus();function o(a){for(;r.length<a;){let u=bA(i);r.push(u),e.append(u.element)}let l=r.splice(a),c=l.some(u=>u.button===document.activeElement);for(let u of l)u.element.remove();c&&s(a)}return{element:n,tell(a,l,c){o(a.length),a.forEach((u,h)=>r[h].tell(u,l&&l[h],u===c))},focus:s}}function bA(i){let t=null,[e,n,r]=[zx(),zx(),rt("td")],s=Be("",()=>t&&i(t));return{element:rt("tr",{},e.element,n.element,r,rt("td",{},s)),button:s,tell(o,a,l){t=o;let c=f=>a===null?"":a?f(a):"–",u=f=>Pe(100*f.damping,3);e.tell(Pe(o.frequency),c(f=>Pe(f.frequency))),n.tell(u(o),c(u)),ze(r,o.element),ze(s,l?"stop":"show"),s.setAttribute("aria-pressed",String(l));let h=l?"Stop showing the mode":`Show the mode of ${Pe(o.frequency)} Hz in 3D`;s.setAttribute("aria-label",h)}}}function zx(){let[i,t]=[rt("span"),rt("span",{class:"was",hidden:!0})];return{element:rt("td",{class:"number"},i,t),tell(e,n){ze(i,e),t.hidden=!n||n===e,ze(t,t.hidden?"":`was ${n}`)}}}var wA={controlled:"under control",locked:"motors held",free:"motors free"},MA=.12;function Vd(i,t,e,n){let r=t.runs[0].modes,s=[...new Set(r.map(w=>w.case))],o=r,a=null,l=MA,c=Vx(w=>g(w===a?null:w)),u=Lr("case"),h=rt("select",{id:u},...s.map(w=>rt("option",{value:w,text:wA[w]??w})));h.addEventListener("change",()=>v(h.value));let f=rt("input",{type:"range",min:"0.02",max:"0.3",step:"0.01",value:String(l),id:Lr("size")});f.addEventListener("input",()=>{l=Number(f.value),a&&e.showMode(a,l)});let d=Be("back to the motion",()=>{let w=_(a);g(null),c.focus(w)},{hidden:!0}),m=rt("p",{class:"note",hidden:!0,role:"status"}),y=Uc(()=>{M(`These are the modes of the ${o===r?"run as it was":"setting before"}; the new ones are being found.`)});function g(w){w&&n.pause(),p(w)}function p(w){a=w,e.showMode(w,l),d.hidden=w===null,v(h.value)}let x=(w,N)=>w.filter(P=>P.case===N),_=w=>w?x(o,w.case).indexOf(w):-1;function v(w){c.tell(x(o,w),o===r?null:x(r,w),a)}function M(w){ze(m,w),m.hidden=!w}let A=rt("div",{class:"bar"},rt("label",{for:u,text:"Modes"}),h,rt("label",{for:f.id,text:"amplitude"}),f,d);i.append(A,m,c.element),v(s[0]??"");let b=n.subscribe(w=>{w.playing&&a&&g(null)});return{show(w){if(No(w))return y.begin();y.end();let N=w?.vibration,P=_(a);o=typeof N=="object"?N.modes:r,M(N===void 0?"":SA(N));let I=a&&(x(o,a.case)[P]??null);a&&I!==a?p(I):v(h.value)},dispose(){b(),y.end(),i.replaceChildren()}}}function SA(i){return typeof i=="string"?`These are the modes of the run as it was: ${i}.`:"About the rest with the changed numbers; under each number what it was."}var Gd=i=>String(Number(i.toPrecision(6)));function Gx(i,t,e){let{pose:n,factor:r}=t.view,s=new URLSearchParams({t:Gd(i.time),camera:n.map(Gd).join(" "),scale:Gd(r)});for(let[o,a]of Object.entries(e?.changed()??{}))s.append("set",`${o}=${a}`);return`#${s.toString()}`}function Hx(i,t,e,n){let r=new URLSearchParams(i.replace(/^#/,"")),s=c=>Number.parseFloat(r.get(c)??"");if(!Number.isFinite(s("t")))return;let o=s("scale"),a=(r.get("camera")??"").split(" ").map(Number);e.view={pose:a,factor:Number.isFinite(o)?o:e.view.factor};let l=r.getAll("set").map(c=>[c.slice(0,c.lastIndexOf("=")),Number(c.slice(c.lastIndexOf("=")+1))]).filter(([,c])=>Number.isFinite(c));n&&l.length&&n.give(Object.fromEntries(l)),t.pause(),t.seek(s("t"))}function Wx(i,t){for(let e of t.runs){if(!e.sheet)continue;let n=t.runs.length>1?`Save the YAML of ${e.name}`:"Save the YAML of this run";i.append(Be(n,()=>Fr(e.sheet,`${Hd(e.name)}.yaml`,"application/yaml"),{class:"save-yaml"}))}}function qx(i,t,e,n){let r=Be("Copy a link to this view",()=>{location.replace(n()),(navigator.clipboard?.writeText(location.href)??Promise.reject(new Error("no clipboard"))).then(()=>ze(r,"Link copied"),()=>ze(r,"The link is in the address bar"))},{class:"copy-link"}),s=Be("Record the run (WebM)",()=>EA(i,t,e,s),{hidden:typeof MediaRecorder>"u"}),o=rt("details",{class:"save-menu"},rt("summary",{text:"Save"}),rt("div",{class:"scene-more"},Be("Save the picture (PNG)",()=>tc(t.picture(),i)),s,r));return o.addEventListener("keydown",a=>{a.key==="Escape"&&(o.open=!1,o.querySelector("summary")?.focus())}),o}var AA=30;function EA(i,t,e,n){if(n.getAttribute("aria-pressed")==="true")return e.pause();let r=n.textContent??"",s=t.picture(),o=new MediaRecorder(s.captureStream(AA),{mimeType:"video/webm"}),a=[],{loop:l}=e;o.ondataavailable=({data:u})=>a.push(u),o.onstop=()=>Fr(new Blob(a),`${i}.webm`,"video/webm"),o.start(),e.pause(),e.loop=!1,e.seek(0),e.play(),n.setAttribute("aria-pressed","true"),ze(n,"Stop recording");let c=e.subscribe(()=>{t.picture(s),!e.playing&&(c(),e.loop=l,n.setAttribute("aria-pressed","false"),ze(n,r),o.stop())})}function Hd(i){return i.replace(/[^\p{L}\p{N}._-]+/gu,"_").replace(/^[._]+/,"").slice(0,80)||"run"}var Xx=["tip_error.commanded","deviation.max","deflection.max","gear.max"],TA=Xx.slice(0,2),Wd=.01,RA=6e3;function Yx(i,t){let e=[...new Set(i.map(r=>r.slider.group))],n=new Map(i.map(r=>{let{group:s}=r.slider,o=i.filter(a=>a.slider.group===s);return[r,o.indexOf(r)*e.length+e.indexOf(s)]}));return[...i].sort((r,s)=>(n.get(r)??0)-(n.get(s)??0)).slice(0,t)}async function jx(i,t,e){let n=t.map(c=>c.slider.value),r=performance.now(),s=await $x(i,n,TA),o=Xx.find(c=>s[c]?.value);if(!o)return"no number of this run tells it";let a=Number(s[o].value);if((performance.now()-r)*t.length>RA)return"to measure it would take long";let l=[];for(let[c,{slider:u}]of t.entries()){if(!e())return null;let h=u.value*(1+Wd),f=h<=u.max&&h>=u.min?Wd:-Wd,d=n.map((y,g)=>g===c?y*(1+f):y),m=u.value===0?a:(await $x(i,d,[o]))[o]?.value??a;l.push(Math.abs(m-a)/Math.abs(a))}return{number:o,shares:l}}async function $x(i,t,e){return new Promise((n,r)=>{let s=o=>{(o.scene||e.some(a=>o.facts[a]?.value))&&n(o.facts)};i.run(t,void 0,s).then(o=>n(o.facts),r)})}function Zx(i,t){return(t.find(e=>e.id===i)?.name??i).toLowerCase()}var qd=1e3;function Kx(i,t){let e=Lr("slider"),n=sd(i.unit),r=rt("input",{type:"range",id:e,min:"0",max:String(qd),step:"1"}),s=rt("input",{type:"number","aria-label":`${i.label}${n?`, in ${n}`:""}`,step:"any",min:String(i.min),max:String(i.max)}),o=Be("↺",h,{class:"tool","aria-label":`${i.label}: back to ${Pe(i.value,6)} ${n}`,title:"back to the run's own"}),a=rt("span",{class:"effect"}),l=i.value;function c(m=!1){r.value=String(Math.round(qd*CA(i,l))),r.setAttribute("aria-valuetext",`${Pe(l,5)} ${n}`),m||(s.value=String(Number(l.toPrecision(6)))),o.disabled=l===i.value,d.classList.toggle("changed",l!==i.value)}function u(m,y=!1){let g=Math.min(Math.max(m,i.min),i.max);if(g===l)return c(y);l=g,c(y),t()}function h(){u(i.value),r.focus()}r.addEventListener("input",()=>u(Number(Pe(PA(i,Number(r.value)/qd),4)))),s.addEventListener("input",()=>{s.value!==""&&Number.isFinite(s.valueAsNumber)&&u(s.valueAsNumber,!0)}),s.addEventListener("change",()=>c());let f=rt("label",{for:e,title:i.path},rt("span",{text:i.label}),rt("i",{text:i.symbol?` ${i.symbol}`:""}),a),d=rt("div",{class:"slider","data-path":i.path},f,rt("div",{class:"slider-row"},r,s,rt("span",{class:"unit",text:n}),o),rt("code",{class:"path",text:i.path,title:"--set PATH=VALUE"}));return c(),{element:d,slider:i,effect:a,get value(){return l},set value(m){l=m,c()}}}function CA(i,t){let{min:e,max:n}=i;return n<=e?0:i.log&&e>0?Math.log(t/e)/Math.log(n/e):(t-e)/(n-e)}function PA(i,t){let{min:e,max:n}=i;return i.log&&e>0?e*(n/e)**t:e+t*(n-e)}var $d=5,Jx=300,IA=250;function Qx(i,t,e){let n=rt("p",{class:"note",role:"status","aria-live":"polite",text:"starts …"}),r=rt("progress",{max:"1",value:"0",hidden:!0,"aria-label":"Progress of the simulation"}),s=Be("reset all",()=>{M(null),a[0]?.element.querySelector("input")?.focus()},{disabled:!0}),o=Be("Save YAML",()=>l&&Fr(l.sheet(p()),`${e.fileName}.yaml`,"application/yaml"),{disabled:!0}),a=t.sliders.map(D=>Kx(D,_)),l=null,c=!1,u=0,h=0,f=0,d=!1,m=0,y=!1,g=0,p=()=>a.map(D=>D.value),x=()=>a.every(D=>D.value===D.slider.value);function _(){s.disabled=x(),!d||x()?A():h||(h=requestAnimationFrame(v))}function v(){d&&!y&&performance.now()-m<Jx?h=requestAnimationFrame(v):A()}function M(D){a.forEach((G,z)=>{G.value=D?D[z]:G.slider.value}),_()}async function A(){if(cancelAnimationFrame(h),h=0,!l)return;let D=u+=1;if(x()){w(),e.show(null),n.textContent="The run as it was.",n.classList.remove("warned"),l.run(p()).catch(()=>{});return}[d,m,y]=[!0,performance.now(),!1],f||(f=window.setTimeout(()=>{r.hidden=!1},Jx));try{let G=z=>{D===u&&(r.value=z)};b(await l.run(p(),G,z=>b(z,D)),D)&&w()}catch(G){if(D!==u||c||G instanceof Error&&G.name==="Superseded")return;w(),e.show(null);let z=(G instanceof Error?G.message:String(G)).replace(/\.$/,"");n.textContent=`This could not be simulated: ${z}; shown is the run as it was.`,n.classList.add("warned")}}function b(D,G){if(G!==u||c)return!1;let z=performance.now();D.scene&&(g=z),y=z-g<IA,e.show(D);let et=D.status==="finished"?"Simulated":`${D.status}: ${D.message}; simulated`;return n.textContent=`${et} in ${Gn(D.seconds,"s")}; the run as it was is pale.`,n.classList.toggle("warned",D.status!=="finished"),!0}function w(){d=!1,clearTimeout(f),f=0,r.hidden=!0,r.value=0}let N=rt("div",{class:"leading"}),P=rt("div"),I=rt("p",{class:"note",hidden:!0}),U=rt("details",{},rt("summary",{text:`All settings (${a.length})`}),I,P);U.hidden=a.length<=$d,U.append(...FA(t));function V(D){N.replaceChildren(...D.map(G=>G.element)),P.replaceChildren(...LA(a.filter(G=>!D.includes(G))))}async function C(D){let G=await jx(D,a,()=>u===0&&!c);if(G===null||u>0||c)return;if(I.hidden=!1,typeof G=="string")return ze(I,`Ordered by kind, not by effect: ${G}.`);let{number:z,shares:et}=G;if(a.forEach((X,tt)=>{X.effect.textContent=et[tt]>0?`${Pe(100*et[tt],2)} %`:"",X.effect.title="change for 1 % of this setting"}),ze(I,`Behind each setting: the change of the ${Zx(z,e.facts)} for 1 % of it.`),i.contains(document.activeElement)||i.matches(":hover"))return;let $=X=>et[a.indexOf(X)];V([...a].sort((X,tt)=>$(tt)-$(X)).slice(0,$d))}return V(Yx(a,$d)),i.append(rt("div",{class:"bar"},rt("h3",{text:"What if"}),s,o),n,r,N,U),e.open(t).then(D=>{if(c)return D.close();l=D,o.disabled=!1,n.textContent="Move a slider to run the simulation again in this page.",x()?C(D).catch(()=>{}):_()},D=>{let G=D instanceof Error?D.message:String(D);n.textContent=`Nothing can be changed here, the robot's equations could not be started: ${G}`,a.forEach(z=>z.element.remove()),s.remove()}),{changed:()=>Object.fromEntries(a.filter(D=>D.value!==D.slider.value).map(D=>[D.slider.path,D.value])),give:D=>M(a.map(({slider:G})=>Math.min(Math.max(D[G.path]??G.value,G.min),G.max))),dispose(){c=!0,cancelAnimationFrame(h),w(),l?.close(),i.replaceChildren()}}}function LA(i){return[...new Set(i.map(e=>e.slider.group))].map(e=>rt("fieldset",{},rt("legend",{text:e}),...i.filter(n=>n.slider.group===e).map(n=>n.element)))}function FA(i){let t=i.settings,e=Array.isArray(i.leftOut)?i.leftOut:[];return[...typeof t?.note=="string"&&t.note?[t.note]:[],...e.length?[`Not offered: ${e.map(({path:r,reason:s})=>`${String(r)} (${String(s)})`).join("; ")}.`]:[]].map(r=>rt("p",{class:"note",text:r}))}var NA=[.05,.1,.2,.5,1,2],kc=1e3,tv=1/200,DA=.012;function ev(i,t){let e=[],n=Be("",()=>t.toggle(),{class:"play"}),r=rt("div",{class:"time-marks"}),s=Be("loop",()=>{t.loop=!t.loop,s.setAttribute("aria-pressed",String(t.loop))},{class:"loop","aria-pressed":"true",title:"start again at the end"}),o=rt("input",{type:"range",min:"0",max:String(kc),step:"1","aria-label":"Time",class:"scrub"}),[a,l]=[rt("span"),rt("span")],c=rt("output",{class:"time","aria-live":"off"},a,document.createTextNode(" "),l),u=Lr("speed"),h=rt("select",{id:u},...NA.map(_=>rt("option",{value:String(_),text:`${_}×`,selected:_===t.speed})));o.addEventListener("input",()=>t.seek(Number(o.value)/kc*t.duration)),h.addEventListener("change",()=>{t.speed=Number(h.value)});let f=Math.max(3,Math.ceil(-Math.log10(t.duration||1))+3),d=()=>{let _=t.duration>0?t.time/t.duration:0;(document.activeElement!==o||Number(o.value)!==Math.round(_*kc))&&(o.value=String(Math.round(_*kc))),o.setAttribute("aria-valuetext",`${t.time.toFixed(f)} s`),a.textContent=`${t.time.toFixed(f)} s`,l.textContent=`of ${Pe(t.duration)} s`;let v=t.playing?"Pause":"Play";n.getAttribute("aria-label")!==v&&(n.setAttribute("aria-label",v),n.title=`${v} (space)`,n.textContent=t.playing?"❚❚":"▶")},m=_=>{if(_.defaultPrevented||_.ctrlKey||_.metaKey||_.altKey||OA(_))return;let v={" ":()=>t.toggle(),ArrowRight:()=>t.seek(t.time+(_.shiftKey?10:1)*tv*t.duration),ArrowLeft:()=>t.seek(t.time-(_.shiftKey?10:1)*tv*t.duration)};(_.key==="."||_.key===",")&&(v[_.key]=()=>y(_.key==="."?1:-1));let M=v[_.key];M&&(_.preventDefault(),M())};function y(_){let v=_>0?0:e.length-1,M=t.time+_*1e-9*(t.duration||1);for(;v>=0&&v<e.length&&_*(e[v]-M)<=0;)v+=_;v>=0&&v<e.length&&t.seek(e[v])}function g(_){let v=(A,b)=>Math.abs(A.time-b.time)<DA*t.duration,M=[];for(let A of _){let b=M.find(w=>v(w[0],A));b?b.push(A):M.push([A])}r.replaceChildren(...M.map(A=>{let b=`${A.map(({label:P})=>P).join("; ")}, t = ${Pe(A[0].time)} s`,N=Be("",()=>t.seek(A[0].time),{class:"time-mark","aria-label":b,title:b});return N.style.left=`${100*A[0].time/(t.duration||1)}%`,N}))}document.addEventListener("keydown",m);let p=rt("label",{for:u,text:"speed"});i.append(n,rt("div",{class:"scrub-box"},r,o),c,s,p,h);let x=t.subscribe(d);return d(),{show(_,v){e=v,g(_)},dispose(){x(),document.removeEventListener("keydown",m),i.replaceChildren()}}}function OA(i){let t=i.target;return t instanceof HTMLElement?t.isContentEditable||t.closest("input, select, textarea, canvas, [role=tablist]")?!0:i.key===" "?t.closest("button, a, summary")!==null:t.closest(".scroll")!==null:!1}function nv(i,t,e,n){let[r,s]=[t.width,t.height].map(c=>2*Math.floor(c/2));(i.width!==r||i.height!==s)&&([i.width,i.height]=[r,s]);let o=i.getContext("2d");if(!o)return i;let a=o.createLinearGradient(0,0,0,s);a.addColorStop(0,e("--sky").trim()||"#ffffff"),a.addColorStop(1,e("--earth").trim()||"#dddddd"),o.fillStyle=a,o.fillRect(0,0,r,s),o.drawImage(t,0,0);let l=Math.max(12,Math.round(s/36));return o.font=`${l}px system-ui, sans-serif`,o.fillStyle=e("--ink").trim()||"#000000",o.fillText(n,l,s-l,r-2*l),i}var bs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ws={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Nv=0,wp=1,Dv=2;var Zs=1,Ov=2,la=3,Ms=0,ci=1,Vi=2,Ks=0,ca=1,Mp=2,Sp=3,Ap=4,Uv=5;var Js=100,kv=101,Bv=102,zv=103,Vv=104,Gv=200,Hv=201,Wv=202,qv=203,Ep=204,Tp=205,$v=206,Xv=207,Yv=208,jv=209,Zv=210,Kv=211,Jv=212,Qv=213,t_=214,uu=0,hu=1,fu=2,Ko=3,du=4,pu=5,mu=6,gu=7,Hu=0,e_=1,n_=2,br=0,Rp=1,Cp=2,Pp=3,Ip=4,Lp=5,Fp=6,Np=7;var Dp=300,Qs=301,ua=302,Wu=303,qu=304,yu=1e3,xr=1001,xu=1002,Bn=1003,i_=1004;var El=1005;var ai=1006,$u=1007;var qr=1008;var di=1009,Op=1010,Up=1011,ha=1012,Xu=1013,nr=1014,ir=1015,rr=1016,Yu=1017,ju=1018,to=1020,kp=35902,Bp=35899,zp=1021,Vp=1022,sr=1023,Hr=1026,$r=1027,Gp=1028,Zu=1029,Ss=1030,Ku=1031;var Ju=1033,Tl=33776,Rl=33777,Cl=33778,Pl=33779,Qu=35840,th=35841,eh=35842,nh=35843,ih=36196,rh=37492,sh=37496,oh=37488,ah=37489,Il=37490,lh=37491,ch=37808,uh=37809,hh=37810,fh=37811,dh=37812,ph=37813,mh=37814,gh=37815,yh=37816,xh=37817,vh=37818,_h=37819,bh=37820,wh=37821,Mh=36492,Sh=36494,Ah=36495,Eh=36283,Th=36284,Ll=36285,Rh=36286;var Ja=2300,vu=2301,lu=2302,mp=2303,gp=2400,yp=2401,xp=2402;var r_=3200;var Fl=0,s_=1,Xr="",Ei="srgb",Qa="srgb-linear",tl="linear",Ie="srgb";var cu=7680;var o_=519,a_=512,l_=513,c_=514,Hp=515,u_=516,h_=517,Wp=518,qp=519,$p=35044,Nl=35048;var Xp="300 es",ki=2e3,Jo=2001;function UA(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function kA(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function el(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function f_(){let i=el("canvas");return i.style.display="block",i}var iv={},Qo=null;function nl(...i){let t="THREE."+i.shift();Qo?Qo("log",t,...i):console.log(t,...i)}function d_(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function jt(...i){i=d_(i);let t="THREE."+i.shift();if(Qo)Qo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function re(...i){i=d_(i);let t="THREE."+i.shift();if(Qo)Qo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function ja(...i){let t=i.join(" ");t in iv||(iv[t]=!0,jt(...i))}function p_(i,t,e){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,e);break;default:n()}}setTimeout(s,e)})}var m_={[uu]:uu,[fu]:mu,[du]:du,[Ko]:pu,[hu]:hu,[mu]:fu,[gu]:gu,[pu]:Ko},Qi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let r=n[t];if(r!==void 0){let s=r.indexOf(e);s!==-1&&r.splice(s,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let r=n.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,t);t.target=null}}},jn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],rv=1234567,Za=Math.PI/180,ta=180/Math.PI;function As(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(jn[i&255]+jn[i>>8&255]+jn[i>>16&255]+jn[i>>24&255]+"-"+jn[t&255]+jn[t>>8&255]+"-"+jn[t>>16&15|64]+jn[t>>24&255]+"-"+jn[e&63|128]+jn[e>>8&255]+"-"+jn[e>>16&255]+jn[e>>24&255]+jn[n&255]+jn[n>>8&255]+jn[n>>16&255]+jn[n>>24&255]).toLowerCase()}function ue(i,t,e){return Math.max(t,Math.min(e,i))}function Yp(i,t){return(i%t+t)%t}function BA(i,t,e,n,r){return n+(i-t)*(r-n)/(e-t)}function zA(i,t,e){return i!==t?(e-i)/(t-i):0}function Ka(i,t,e){return(1-e)*i+e*t}function VA(i,t,e,n){return Ka(i,t,1-Math.exp(-e*n))}function GA(i,t=1){return t-Math.abs(Yp(i,t*2)-t)}function HA(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function WA(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function qA(i,t){return i+Math.floor(Math.random()*(t-i+1))}function $A(i,t){return i+Math.random()*(t-i)}function XA(i){return i*(.5-Math.random())}function YA(i){i!==void 0&&(rv=i);let t=rv+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function jA(i){return i*Za}function ZA(i){return i*ta}function KA(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function JA(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function jp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function QA(i,t,e,n,r){let s=Math.cos,o=Math.sin,a=s(e/2),l=o(e/2),c=s((t+n)/2),u=o((t+n)/2),h=s((t-n)/2),f=o((t-n)/2),d=s((n-t)/2),m=o((n-t)/2);switch(r){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*u,a*c);break;default:jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function Ch(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Zp(i,t){if(t.constructor===Float32Array)return i;let e=Ch(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Kp(i,t){if(t.constructor===Float32Array)return i;let e=Ch(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var or={DEG2RAD:Za,RAD2DEG:ta,generateUUID:As,clamp:ue,euclideanModulo:Yp,mapLinear:BA,inverseLerp:zA,lerp:Ka,damp:VA,pingpong:GA,smoothstep:HA,smootherstep:WA,randInt:qA,randFloat:$A,randFloatSpread:XA,seededRandom:YA,degToRad:jA,radToDeg:ZA,isPowerOfTwo:KA,ceilPowerOfTwo:JA,floorPowerOfTwo:jp,setQuaternionFromProperEuler:QA,normalize:Kp,denormalize:Zp},Zt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6],this.y=r[1]*e+r[4]*n+r[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ue(this.x,t.x,e.x),this.y=ue(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ue(this.x,t,e),this.y=ue(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ue(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ue(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),r=Math.sin(e),s=this.x-t.x,o=this.y-t.y;return this.x=s*n-o*r+t.x,this.y=s*r+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},zn=class{constructor(t=0,e=0,n=0,r=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=r}static slerpFlat(t,e,n,r,s,o,a){let l=n[r+0],c=n[r+1],u=n[r+2],h=n[r+3],f=s[o+0],d=s[o+1],m=s[o+2],y=s[o+3];if(h!==y||l!==f||c!==d||u!==m){let g=l*f+c*d+u*m+h*y;g<0&&(f=-f,d=-d,m=-m,y=-y,g=-g);let p=1-a;if(g<.9995){let x=Math.acos(g),_=Math.sin(x);p=Math.sin(p*x)/_,a=Math.sin(a*x)/_,l=l*p+f*a,c=c*p+d*a,u=u*p+m*a,h=h*p+y*a}else{l=l*p+f*a,c=c*p+d*a,u=u*p+m*a,h=h*p+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,r,s,o){let a=n[r],l=n[r+1],c=n[r+2],u=n[r+3],h=s[o],f=s[o+1],d=s[o+2],m=s[o+3];return t[e]=a*m+u*h+l*d-c*f,t[e+1]=l*m+u*f+c*h-a*d,t[e+2]=c*m+u*d+a*f-l*h,t[e+3]=u*m-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,r){return this._x=t,this._y=e,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,r=t._y,s=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(r/2),h=a(s/2),f=l(n/2),d=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"YXZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"ZXY":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"ZYX":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"YZX":this._x=f*u*h+c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h-f*d*m;break;case"XZY":this._x=f*u*h-c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h+f*d*m;break;default:jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,r=Math.sin(n);return this._x=t.x*r,this._y=t.y*r,this._z=t.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],r=e[4],s=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(s-c)*d,this._z=(o-r)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(r+o)/d,this._z=(s+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-n-h);this._w=(s-c)/d,this._x=(r+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-r)/d,this._x=(s+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ue(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let r=Math.min(1,e/n);return this.slerp(t,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,r=t._y,s=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-n*c,this._z=s*u+o*c+n*l-r*a,this._w=o*u-n*a-r*l-s*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,r=t._y,s=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,r=-r,s=-s,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+n*e,this._y=this._y*l+r*e,this._z=this._z*l+s*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+r*e,this._z=this._z*l+s*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(t),r*Math.cos(t),s*Math.sin(e),s*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(sv.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(sv.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,r=this.z,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6]*r,this.y=s[1]*e+s[4]*n+s[7]*r,this.z=s[2]*e+s[5]*n+s[8]*r,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,r=this.z,s=t.elements,o=1/(s[3]*e+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*e+s[4]*n+s[8]*r+s[12])*o,this.y=(s[1]*e+s[5]*n+s[9]*r+s[13])*o,this.z=(s[2]*e+s[6]*n+s[10]*r+s[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,r=this.z,s=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*r-a*n),u=2*(a*e-s*r),h=2*(s*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-s*h,this.z=r+l*h+s*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,r=this.z,s=t.elements;return this.x=s[0]*e+s[4]*n+s[8]*r,this.y=s[1]*e+s[5]*n+s[9]*r,this.z=s[2]*e+s[6]*n+s[10]*r,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ue(this.x,t.x,e.x),this.y=ue(this.y,t.y,e.y),this.z=ue(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ue(this.x,t,e),this.y=ue(this.y,t,e),this.z=ue(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ue(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,r=t.y,s=t.z,o=e.x,a=e.y,l=e.z;return this.x=r*l-s*a,this.y=s*o-n*l,this.z=n*a-r*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Xd.copy(this).projectOnVector(t),this.sub(Xd)}reflect(t){return this.sub(Xd.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ue(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,r=this.z-t.z;return e*e+n*n+r*r}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let r=Math.sin(e)*t;return this.x=r*Math.sin(n),this.y=Math.cos(e)*t,this.z=r*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),r=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=r,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Xd=new H,sv=new zn,se=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,r,s,o,a,l,c)}set(t,e,n,r,s,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=r,u[2]=a,u[3]=e,u[4]=s,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,r=e.elements,s=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],m=n[8],y=r[0],g=r[3],p=r[6],x=r[1],_=r[4],v=r[7],M=r[2],A=r[5],b=r[8];return s[0]=o*y+a*x+l*M,s[3]=o*g+a*_+l*A,s[6]=o*p+a*v+l*b,s[1]=c*y+u*x+h*M,s[4]=c*g+u*_+h*A,s[7]=c*p+u*v+h*b,s[2]=f*y+d*x+m*M,s[5]=f*g+d*_+m*A,s[8]=f*p+d*v+m*b,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*s*u+n*a*l+r*s*c-r*o*l}invert(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*s,d=c*s-o*l,m=e*h+n*f+r*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return t[0]=h*y,t[1]=(r*c-u*n)*y,t[2]=(a*n-r*o)*y,t[3]=f*y,t[4]=(u*e-r*l)*y,t[5]=(r*s-a*e)*y,t[6]=d*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*s)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-r*c,r*l,-r*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ja("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Yd.makeScale(t,e)),this}rotate(t){return ja("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Yd.makeRotation(-t)),this}translate(t,e){return ja("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Yd.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let r=0;r<9;r++)if(e[r]!==n[r])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Yd=new se,ov=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),av=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function tE(){let i={enabled:!0,workingColorSpace:Qa,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Ie&&(r.r=Gr(r.r),r.g=Gr(r.g),r.b=Gr(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ie&&(r.r=Zo(r.r),r.g=Zo(r.g),r.b=Zo(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Xr?tl:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Qa]:{primaries:t,whitePoint:n,transfer:tl,toXYZ:ov,fromXYZ:av,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ei},outputColorSpaceConfig:{drawingBufferColorSpace:Ei}},[Ei]:{primaries:t,whitePoint:n,transfer:Ie,toXYZ:ov,fromXYZ:av,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ei}}}),i}var be=tE();function Gr(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Zo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Do,_u=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Do===void 0&&(Do=el("canvas")),Do.width=t.width,Do.height=t.height;let r=Do.getContext("2d");t instanceof ImageData?r.putImageData(t,0,0):r.drawImage(t,0,0,t.width,t.height),n=Do}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=el("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let r=n.getImageData(0,0,t.width,t.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Gr(s[o]/255)*255;return n.putImageData(r,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Gr(e[n]/255)*255):e[n]=Gr(e[n]);return{data:e,width:t.width,height:t.height}}else return jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},eE=0,ea=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:eE++}),this.uuid=As(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(jd(r[o].image)):s.push(jd(r[o]))}else s=jd(r);n.url=s}return e||(t.images[this.uuid]=n),n}};function jd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?_u.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(jt("Texture: Unable to serialize Texture."),{})}var nE=0,Zd=new H,fi=class i extends Qi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=xr,r=xr,s=ai,o=qr,a=sr,l=di,c=i.DEFAULT_ANISOTROPY,u=Xr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:nE++}),this.uuid=As(),this.name="",this.source=new ea(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Zd).x}get height(){return this.source.getSize(Zd).y}get depth(){return this.source.getSize(Zd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let r=this[e];if(r===void 0){jt(`Texture.setValues(): property '${e}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Dp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case yu:t.x=t.x-Math.floor(t.x);break;case xr:t.x=t.x<0?0:1;break;case xu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case yu:t.y=t.y-Math.floor(t.y);break;case xr:t.y=t.y<0?0:1;break;case xu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};fi.DEFAULT_IMAGE=null;fi.DEFAULT_MAPPING=Dp;fi.DEFAULT_ANISOTROPY=1;var Le=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,r=1){this.x=t,this.y=e,this.z=n,this.w=r}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,r){return this.x=t,this.y=e,this.z=n,this.w=r,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,r=this.z,s=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*r+o[12]*s,this.y=o[1]*e+o[5]*n+o[9]*r+o[13]*s,this.z=o[2]*e+o[6]*n+o[10]*r+o[14]*s,this.w=o[3]*e+o[7]*n+o[11]*r+o[15]*s,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,r,s,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],m=l[9],y=l[2],g=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(m+g)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let _=(c+1)/2,v=(d+1)/2,M=(p+1)/2,A=(u+f)/4,b=(h+y)/4,w=(m+g)/4;return _>v&&_>M?_<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(_),r=A/n,s=b/n):v>M?v<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(v),n=A/r,s=w/r):M<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(M),n=b/s,r=w/s),this.set(n,r,s,e),this}let x=Math.sqrt((g-m)*(g-m)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(g-m)/x,this.y=(h-y)/x,this.z=(f-u)/x,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ue(this.x,t.x,e.x),this.y=ue(this.y,t.y,e.y),this.z=ue(this.z,t.z,e.z),this.w=ue(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ue(this.x,t,e),this.y=ue(this.y,t,e),this.z=ue(this.z,t,e),this.w=ue(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ue(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},bu=class extends Qi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ai,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Le(0,0,t,e),this.scissorTest=!1,this.viewport=new Le(0,0,t,e),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new fi({width:t,height:e,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ai,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=t,this.textures[r].image.height=e,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let r=Object.assign({},t.textures[e].image);this.textures[e].source=new ea(r)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ri=class extends bu{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},il=class extends fi{constructor(t=null,e=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:r},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=xr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var wu=class extends fi{constructor(t=null,e=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:r},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=xr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var $e=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g)}set(t,e,n,r,s,o,a,l,c,u,h,f,d,m,y,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=m,p[11]=y,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,r=1/Oo.setFromMatrixColumn(t,0).length(),s=1/Oo.setFromMatrixColumn(t,1).length(),o=1/Oo.setFromMatrixColumn(t,2).length();return e[0]=n[0]*r,e[1]=n[1]*r,e[2]=n[2]*r,e[3]=0,e[4]=n[4]*s,e[5]=n[5]*s,e[6]=n[6]*s,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,r=t.y,s=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(t.order==="XYZ"){let f=o*u,d=o*h,m=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+m*c,e[5]=f-y*c,e[9]=-a*l,e[2]=y-f*c,e[6]=m+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,d=l*h,m=c*u,y=c*h;e[0]=f+y*a,e[4]=m*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-m,e[6]=y+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*u,d=l*h,m=c*u,y=c*h;e[0]=f-y*a,e[4]=-o*h,e[8]=m+d*a,e[1]=d+m*a,e[5]=o*u,e[9]=y-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,d=o*h,m=a*u,y=a*h;e[0]=l*u,e[4]=m*c-d,e[8]=f*c+y,e[1]=l*h,e[5]=y*c+f,e[9]=d*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*u,e[4]=y-f*h,e[8]=m*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+m,e[10]=f-y*h}else if(t.order==="XZY"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+y,e[5]=o*u,e[9]=d*h-m,e[2]=m*h-d,e[6]=a*u,e[10]=y*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(iE,t,rE)}lookAt(t,e,n){let r=this.elements;return Si.subVectors(t,e),Si.lengthSq()===0&&(Si.z=1),Si.normalize(),ls.crossVectors(n,Si),ls.lengthSq()===0&&(Math.abs(n.z)===1?Si.x+=1e-4:Si.z+=1e-4,Si.normalize(),ls.crossVectors(n,Si)),ls.normalize(),Bc.crossVectors(Si,ls),r[0]=ls.x,r[4]=Bc.x,r[8]=Si.x,r[1]=ls.y,r[5]=Bc.y,r[9]=Si.y,r[2]=ls.z,r[6]=Bc.z,r[10]=Si.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,r=e.elements,s=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],m=n[2],y=n[6],g=n[10],p=n[14],x=n[3],_=n[7],v=n[11],M=n[15],A=r[0],b=r[4],w=r[8],N=r[12],P=r[1],I=r[5],U=r[9],V=r[13],C=r[2],D=r[6],G=r[10],z=r[14],et=r[3],$=r[7],X=r[11],tt=r[15];return s[0]=o*A+a*P+l*C+c*et,s[4]=o*b+a*I+l*D+c*$,s[8]=o*w+a*U+l*G+c*X,s[12]=o*N+a*V+l*z+c*tt,s[1]=u*A+h*P+f*C+d*et,s[5]=u*b+h*I+f*D+d*$,s[9]=u*w+h*U+f*G+d*X,s[13]=u*N+h*V+f*z+d*tt,s[2]=m*A+y*P+g*C+p*et,s[6]=m*b+y*I+g*D+p*$,s[10]=m*w+y*U+g*G+p*X,s[14]=m*N+y*V+g*z+p*tt,s[3]=x*A+_*P+v*C+M*et,s[7]=x*b+_*I+v*D+M*$,s[11]=x*w+_*U+v*G+M*X,s[15]=x*N+_*V+v*z+M*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],r=t[8],s=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],m=t[3],y=t[7],g=t[11],p=t[15],x=l*d-c*f,_=a*d-c*h,v=a*f-l*h,M=o*d-c*u,A=o*f-l*u,b=o*h-a*u;return e*(y*x-g*_+p*v)-n*(m*x-g*M+p*A)+r*(m*_-y*M+p*b)-s*(m*v-y*A+g*b)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],r=t[8],s=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-n*(s*u-a*l)+r*(s*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let r=this.elements;return t.isVector3?(r[12]=t.x,r[13]=t.y,r[14]=t.z):(r[12]=t,r[13]=e,r[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],r=t[2],s=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],m=t[12],y=t[13],g=t[14],p=t[15],x=e*a-n*o,_=e*l-r*o,v=e*c-s*o,M=n*l-r*a,A=n*c-s*a,b=r*c-s*l,w=u*y-h*m,N=u*g-f*m,P=u*p-d*m,I=h*g-f*y,U=h*p-d*y,V=f*p-d*g,C=x*V-_*U+v*I+M*P-A*N+b*w;if(C===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/C;return t[0]=(a*V-l*U+c*I)*D,t[1]=(r*U-n*V-s*I)*D,t[2]=(y*b-g*A+p*M)*D,t[3]=(f*A-h*b-d*M)*D,t[4]=(l*P-o*V-c*N)*D,t[5]=(e*V-r*P+s*N)*D,t[6]=(g*v-m*b-p*_)*D,t[7]=(u*b-f*v+d*_)*D,t[8]=(o*U-a*P+c*w)*D,t[9]=(n*P-e*U-s*w)*D,t[10]=(m*A-y*v+p*x)*D,t[11]=(h*v-u*A-d*x)*D,t[12]=(a*N-o*I-l*w)*D,t[13]=(e*I-n*N+r*w)*D,t[14]=(y*_-m*M-g*x)*D,t[15]=(u*M-h*_+f*x)*D,this}scale(t){let e=this.elements,n=t.x,r=t.y,s=t.z;return e[0]*=n,e[4]*=r,e[8]*=s,e[1]*=n,e[5]*=r,e[9]*=s,e[2]*=n,e[6]*=r,e[10]*=s,e[3]*=n,e[7]*=r,e[11]*=s,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],r=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,r))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),r=Math.sin(e),s=1-n,o=t.x,a=t.y,l=t.z,c=s*o,u=s*a;return this.set(c*o+n,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+n,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,r,s,o){return this.set(1,n,s,0,t,1,o,0,e,r,1,0,0,0,0,1),this}compose(t,e,n){let r=this.elements,s=e._x,o=e._y,a=e._z,l=e._w,c=s+s,u=o+o,h=a+a,f=s*c,d=s*u,m=s*h,y=o*u,g=o*h,p=a*h,x=l*c,_=l*u,v=l*h,M=n.x,A=n.y,b=n.z;return r[0]=(1-(y+p))*M,r[1]=(d+v)*M,r[2]=(m-_)*M,r[3]=0,r[4]=(d-v)*A,r[5]=(1-(f+p))*A,r[6]=(g+x)*A,r[7]=0,r[8]=(m+_)*b,r[9]=(g-x)*b,r[10]=(1-(f+y))*b,r[11]=0,r[12]=t.x,r[13]=t.y,r[14]=t.z,r[15]=1,this}decompose(t,e,n){let r=this.elements;t.x=r[12],t.y=r[13],t.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),e.identity(),this;let o=Oo.set(r[0],r[1],r[2]).length(),a=Oo.set(r[4],r[5],r[6]).length(),l=Oo.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Zi.copy(this);let c=1/o,u=1/a,h=1/l;return Zi.elements[0]*=c,Zi.elements[1]*=c,Zi.elements[2]*=c,Zi.elements[4]*=u,Zi.elements[5]*=u,Zi.elements[6]*=u,Zi.elements[8]*=h,Zi.elements[9]*=h,Zi.elements[10]*=h,e.setFromRotationMatrix(Zi),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,r,s,o,a=ki,l=!1){let c=this.elements,u=2*s/(e-t),h=2*s/(n-r),f=(e+t)/(e-t),d=(n+r)/(n-r),m,y;if(l)m=s/(o-s),y=o*s/(o-s);else if(a===ki)m=-(o+s)/(o-s),y=-2*o*s/(o-s);else if(a===Jo)m=-o/(o-s),y=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,r,s,o,a=ki,l=!1){let c=this.elements,u=2/(e-t),h=2/(n-r),f=-(e+t)/(e-t),d=-(n+r)/(n-r),m,y;if(l)m=1/(o-s),y=o/(o-s);else if(a===ki)m=-2/(o-s),y=-(o+s)/(o-s);else if(a===Jo)m=-1/(o-s),y=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let r=0;r<16;r++)if(e[r]!==n[r])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Oo=new H,Zi=new $e,iE=new H(0,0,0),rE=new H(1,1,1),ls=new H,Bc=new H,Si=new H,lv=new $e,cv=new zn,vr=class i{constructor(t=0,e=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=r}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,r=this._order){return this._x=t,this._y=e,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let r=t.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],h=r[2],f=r[6],d=r[10];switch(e){case"XYZ":this._y=Math.asin(ue(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ue(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(ue(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-ue(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ue(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ue(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,d),this._y=0);break;default:jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return lv.makeRotationFromQuaternion(t),this.setFromRotationMatrix(lv,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return cv.setFromEuler(this),this.setFromQuaternion(cv,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};vr.DEFAULT_ORDER="XYZ";var rl=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},sE=0,uv=new H,Uo=new zn,Ur=new $e,zc=new H,Wa=new H,oE=new H,aE=new zn,hv=new H(1,0,0),fv=new H(0,1,0),dv=new H(0,0,1),pv={type:"added"},lE={type:"removed"},ko={type:"childadded",child:null},Kd={type:"childremoved",child:null},Wn=class i extends Qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:sE++}),this.uuid=As(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new H,e=new vr,n=new zn,r=new H(1,1,1);function s(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new $e},normalMatrix:{value:new se}}),this.matrix=new $e,this.matrixWorld=new $e,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new rl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Uo.setFromAxisAngle(t,e),this.quaternion.multiply(Uo),this}rotateOnWorldAxis(t,e){return Uo.setFromAxisAngle(t,e),this.quaternion.premultiply(Uo),this}rotateX(t){return this.rotateOnAxis(hv,t)}rotateY(t){return this.rotateOnAxis(fv,t)}rotateZ(t){return this.rotateOnAxis(dv,t)}translateOnAxis(t,e){return uv.copy(t).applyQuaternion(this.quaternion),this.position.add(uv.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(hv,t)}translateY(t){return this.translateOnAxis(fv,t)}translateZ(t){return this.translateOnAxis(dv,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ur.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?zc.copy(t):zc.set(t,e,n);let r=this.parent;this.updateWorldMatrix(!0,!1),Wa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ur.lookAt(Wa,zc,this.up):Ur.lookAt(zc,Wa,this.up),this.quaternion.setFromRotationMatrix(Ur),r&&(Ur.extractRotation(r.matrixWorld),Uo.setFromRotationMatrix(Ur),this.quaternion.premultiply(Uo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(pv),ko.child=t,this.dispatchEvent(ko),ko.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(lE),Kd.child=t,this.dispatchEvent(Kd),Kd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ur.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ur.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ur),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(pv),ko.child=t,this.dispatchEvent(ko),ko.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,r=this.children.length;n<r;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wa,t,oE),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wa,aE,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,r=t.z,s=this.matrix.elements;s[12]+=e-s[0]*e-s[4]*n-s[8]*r,s[13]+=n-s[1]*e-s[5]*n-s[9]*r,s[14]+=r-s[2]*e-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,r=e.length;n<r;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let r=this.parent;if(t===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(t),r.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(t.shapes,h)}else s(t.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(t.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(t.materials,this.material[l]));r.material=a}else r.material=s(t.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=r,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let r=t.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Wn.DEFAULT_UP=new H(0,1,0);Wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},cE={type:"move"},na=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let g=e.getJointPose(y,n),p=this._getHandJoint(c,y);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(s=e.getPose(t.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(r=e.getPose(t.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(cE)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new kn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},g_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},cs={h:0,s:0,l:0},Vc={h:0,s:0,l:0};function Jd(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let r=t;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ei){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,be.colorSpaceToWorking(this,e),this}setRGB(t,e,n,r=be.workingColorSpace){return this.r=t,this.g=e,this.b=n,be.colorSpaceToWorking(this,r),this}setHSL(t,e,n,r=be.workingColorSpace){if(t=Yp(t,1),e=ue(e,0,1),n=ue(n,0,1),e===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+e):n+e-n*e,o=2*n-s;this.r=Jd(o,s,t+1/3),this.g=Jd(o,s,t),this.b=Jd(o,s,t-1/3)}return be.colorSpaceToWorking(this,r),this}setStyle(t,e=Ei){function n(s){s!==void 0&&parseFloat(s)<1&&jt("Color: Alpha component of "+t+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(t)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,e);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,e);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,e);break;default:jt("Color: Unknown color model "+t)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(t)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(s,16),e);jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ei){let n=g_[t.toLowerCase()];return n!==void 0?this.setHex(n,e):jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Gr(t.r),this.g=Gr(t.g),this.b=Gr(t.b),this}copyLinearToSRGB(t){return this.r=Zo(t.r),this.g=Zo(t.g),this.b=Zo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ei){return be.workingToColorSpace(Zn.copy(this),t),Math.round(ue(Zn.r*255,0,255))*65536+Math.round(ue(Zn.g*255,0,255))*256+Math.round(ue(Zn.b*255,0,255))}getHexString(t=Ei){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=be.workingColorSpace){be.workingToColorSpace(Zn.copy(this),e);let n=Zn.r,r=Zn.g,s=Zn.b,o=Math.max(n,r,s),a=Math.min(n,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(r-s)/h+(r<s?6:0);break;case r:l=(s-n)/h+2;break;case s:l=(n-r)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=be.workingColorSpace){return be.workingToColorSpace(Zn.copy(this),e),t.r=Zn.r,t.g=Zn.g,t.b=Zn.b,t}getStyle(t=Ei){be.workingToColorSpace(Zn.copy(this),t);let e=Zn.r,n=Zn.g,r=Zn.b;return t!==Ei?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(t,e,n){return this.getHSL(cs),this.setHSL(cs.h+t,cs.s+e,cs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(cs),t.getHSL(Vc);let n=Ka(cs.h,Vc.h,e),r=Ka(cs.s,Vc.s,e),s=Ka(cs.l,Vc.l,e);return this.setHSL(n,r,s),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,r=this.b,s=t.elements;return this.r=s[0]*e+s[3]*n+s[6]*r,this.g=s[1]*e+s[4]*n+s[7]*r,this.b=s[2]*e+s[5]*n+s[8]*r,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Zn=new he;he.NAMES=g_;var sl=class extends Wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new vr,this.environmentIntensity=1,this.environmentRotation=new vr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ki=new H,kr=new H,Qd=new H,Br=new H,Bo=new H,zo=new H,mv=new H,tp=new H,ep=new H,np=new H,ip=new Le,rp=new Le,sp=new Le,ds=class i{constructor(t=new H,e=new H,n=new H){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,r){r.subVectors(n,e),Ki.subVectors(t,e),r.cross(Ki);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(t,e,n,r,s){Ki.subVectors(r,e),kr.subVectors(n,e),Qd.subVectors(t,e);let o=Ki.dot(Ki),a=Ki.dot(kr),l=Ki.dot(Qd),c=kr.dot(kr),u=kr.dot(Qd),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,m=(o*u-a*l)*f;return s.set(1-d-m,m,d)}static containsPoint(t,e,n,r){return this.getBarycoord(t,e,n,r,Br)===null?!1:Br.x>=0&&Br.y>=0&&Br.x+Br.y<=1}static getInterpolation(t,e,n,r,s,o,a,l){return this.getBarycoord(t,e,n,r,Br)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Br.x),l.addScaledVector(o,Br.y),l.addScaledVector(a,Br.z),l)}static getInterpolatedAttribute(t,e,n,r,s,o){return ip.setScalar(0),rp.setScalar(0),sp.setScalar(0),ip.fromBufferAttribute(t,e),rp.fromBufferAttribute(t,n),sp.fromBufferAttribute(t,r),o.setScalar(0),o.addScaledVector(ip,s.x),o.addScaledVector(rp,s.y),o.addScaledVector(sp,s.z),o}static isFrontFacing(t,e,n,r){return Ki.subVectors(n,e),kr.subVectors(t,e),Ki.cross(kr).dot(r)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,r){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[r]),this}setFromAttributeAndIndices(t,e,n,r){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,r),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ki.subVectors(this.c,this.b),kr.subVectors(this.a,this.b),Ki.cross(kr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,r,s){return i.getInterpolation(t,this.a,this.b,this.c,e,n,r,s)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,r=this.b,s=this.c,o,a;Bo.subVectors(r,n),zo.subVectors(s,n),tp.subVectors(t,n);let l=Bo.dot(tp),c=zo.dot(tp);if(l<=0&&c<=0)return e.copy(n);ep.subVectors(t,r);let u=Bo.dot(ep),h=zo.dot(ep);if(u>=0&&h<=u)return e.copy(r);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(n).addScaledVector(Bo,o);np.subVectors(t,s);let d=Bo.dot(np),m=zo.dot(np);if(m>=0&&d<=m)return e.copy(s);let y=d*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(zo,a);let g=u*m-d*h;if(g<=0&&h-u>=0&&d-m>=0)return mv.subVectors(s,r),a=(h-u)/(h-u+(d-m)),e.copy(r).addScaledVector(mv,a);let p=1/(g+y+f);return o=y*p,a=f*p,e.copy(n).addScaledVector(Bo,o).addScaledVector(zo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},li=class{constructor(t=new H(1/0,1/0,1/0),e=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ji.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ji.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ji.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let s=n.getAttribute("position");if(e===!0&&s!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ji):Ji.fromBufferAttribute(s,o),Ji.applyMatrix4(t.matrixWorld),this.expandByPoint(Ji);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Gc.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Gc.copy(n.boundingBox)),Gc.applyMatrix4(t.matrixWorld),this.union(Gc)}let r=t.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ji),Ji.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(qa),Hc.subVectors(this.max,qa),Vo.subVectors(t.a,qa),Go.subVectors(t.b,qa),Ho.subVectors(t.c,qa),us.subVectors(Go,Vo),hs.subVectors(Ho,Go),Gs.subVectors(Vo,Ho);let e=[0,-us.z,us.y,0,-hs.z,hs.y,0,-Gs.z,Gs.y,us.z,0,-us.x,hs.z,0,-hs.x,Gs.z,0,-Gs.x,-us.y,us.x,0,-hs.y,hs.x,0,-Gs.y,Gs.x,0];return!op(e,Vo,Go,Ho,Hc)||(e=[1,0,0,0,1,0,0,0,1],!op(e,Vo,Go,Ho,Hc))?!1:(Wc.crossVectors(us,hs),e=[Wc.x,Wc.y,Wc.z],op(e,Vo,Go,Ho,Hc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ji).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ji).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(zr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),zr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),zr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),zr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),zr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),zr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),zr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),zr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(zr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},zr=[new H,new H,new H,new H,new H,new H,new H,new H],Ji=new H,Gc=new li,Vo=new H,Go=new H,Ho=new H,us=new H,hs=new H,Gs=new H,qa=new H,Hc=new H,Wc=new H,Hs=new H;function op(i,t,e,n,r){for(let s=0,o=i.length-3;s<=o;s+=3){Hs.fromArray(i,s);let a=r.x*Math.abs(Hs.x)+r.y*Math.abs(Hs.y)+r.z*Math.abs(Hs.z),l=t.dot(Hs),c=e.dot(Hs),u=n.dot(Hs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var An=new H,qc=new Zt,uE=0,Ye=class extends Qi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:uE++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=$p,this.updateRanges=[],this.gpuType=ir,this.version=0,this._normalizationScale=t!==void 0?Ch(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[t+r]=e.array[n+r];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)qc.fromBufferAttribute(this,e),qc.applyMatrix3(t),this.setXY(e,qc.x,qc.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)An.fromBufferAttribute(this,e),An.applyMatrix3(t),this.setXYZ(e,An.x,An.y,An.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)An.fromBufferAttribute(this,e),An.applyMatrix4(t),this.setXYZ(e,An.x,An.y,An.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)An.fromBufferAttribute(this,e),An.applyNormalMatrix(t),this.setXYZ(e,An.x,An.y,An.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)An.fromBufferAttribute(this,e),An.transformDirection(t),this.setXYZ(e,An.x,An.y,An.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=r,this}setXYZW(t,e,n,r,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=r,this.array[t+3]=s,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Zp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Kp(t,this.array)}};var ol=class extends Ye{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var al=class extends Ye{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Xe=class extends Ye{constructor(t,e,n){super(new Float32Array(t),e,n)}},hE=new li,$a=new H,ap=new H,tr=class{constructor(t=new H,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):hE.setFromPoints(t).getCenter(n);let r=0;for(let s=0,o=t.length;s<o;s++)r=Math.max(r,n.distanceToSquared(t[s]));return this.radius=Math.sqrt(r),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;$a.subVectors(t,this.center);let e=$a.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),r=(n-this.radius)*.5;this.center.addScaledVector($a,r/n),this.radius+=r}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ap.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint($a.copy(t.center).add(ap)),this.expandByPoint($a.copy(t.center).sub(ap))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},fE=0,Ui=new $e,lp=new Wn,Wo=new H,Ai=new li,Xa=new li,Un=new H,on=class i extends Qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:fE++}),this.uuid=As(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(UA(t)?al:ol)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new se().getNormalMatrix(t);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(t),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ui.makeRotationFromQuaternion(t),this.applyMatrix4(Ui),this}rotateX(t){return Ui.makeRotationX(t),this.applyMatrix4(Ui),this}rotateY(t){return Ui.makeRotationY(t),this.applyMatrix4(Ui),this}rotateZ(t){return Ui.makeRotationZ(t),this.applyMatrix4(Ui),this}translate(t,e,n){return Ui.makeTranslation(t,e,n),this.applyMatrix4(Ui),this}scale(t,e,n){return Ui.makeScale(t,e,n),this.applyMatrix4(Ui),this}lookAt(t){return lp.lookAt(t),lp.updateMatrix(),this.applyMatrix4(lp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Wo).negate(),this.translate(Wo.x,Wo.y,Wo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let r=0,s=t.length;r<s;r++){let o=t[r];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Xe(n,3))}else{let n=Math.min(t.length,e.count);for(let r=0;r<n;r++){let s=t[r];e.setXYZ(r,s.x,s.y,s.z||0)}t.length>e.count&&jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new li);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,r=e.length;n<r;n++){let s=e[n];Ai.setFromBufferAttribute(s),this.morphTargetsRelative?(Un.addVectors(this.boundingBox.min,Ai.min),this.boundingBox.expandByPoint(Un),Un.addVectors(this.boundingBox.max,Ai.max),this.boundingBox.expandByPoint(Un)):(this.boundingBox.expandByPoint(Ai.min),this.boundingBox.expandByPoint(Ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new tr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(t){let n=this.boundingSphere.center;if(Ai.setFromBufferAttribute(t),e)for(let s=0,o=e.length;s<o;s++){let a=e[s];Xa.setFromBufferAttribute(a),this.morphTargetsRelative?(Un.addVectors(Ai.min,Xa.min),Ai.expandByPoint(Un),Un.addVectors(Ai.max,Xa.max),Ai.expandByPoint(Un)):(Ai.expandByPoint(Xa.min),Ai.expandByPoint(Xa.max))}Ai.getCenter(n);let r=0;for(let s=0,o=t.count;s<o;s++)Un.fromBufferAttribute(t,s),r=Math.max(r,n.distanceToSquared(Un));if(e)for(let s=0,o=e.length;s<o;s++){let a=e[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Un.fromBufferAttribute(a,c),l&&(Wo.fromBufferAttribute(t,c),Un.add(Wo)),r=Math.max(r,n.distanceToSquared(Un))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,r=e.normal,s=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ye(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let N=0;N<n.count;N++)a[N]=new H,l[N]=new H;let u=new H,h=new H,f=new H,d=new Zt,m=new Zt,y=new Zt,g=new H,p=new H;function x(N,P,I){c[N]=c[P]=c[I]=1,u.fromBufferAttribute(n,N),h.fromBufferAttribute(n,P),f.fromBufferAttribute(n,I),d.fromBufferAttribute(s,N),m.fromBufferAttribute(s,P),y.fromBufferAttribute(s,I),h.sub(u),f.sub(u),m.sub(d),y.sub(d);let U=1/(m.x*y.y-y.x*m.y);isFinite(U)&&(g.copy(h).multiplyScalar(y.y).addScaledVector(f,-m.y).multiplyScalar(U),p.copy(f).multiplyScalar(m.x).addScaledVector(h,-y.x).multiplyScalar(U),a[N].add(g),a[P].add(g),a[I].add(g),l[N].add(p),l[P].add(p),l[I].add(p))}let _=this.groups;_.length===0&&(_=[{start:0,count:t.count}]);for(let N=0,P=_.length;N<P;++N){let I=_[N],U=I.start,V=I.count;for(let C=U,D=U+V;C<D;C+=3)x(t.getX(C+0),t.getX(C+1),t.getX(C+2))}let v=new H,M=new H,A=new H,b=new H;function w(N){A.fromBufferAttribute(r,N),b.copy(A);let P=a[N];v.copy(P),v.sub(A.multiplyScalar(A.dot(P))).normalize(),M.crossVectors(b,P);let U=M.dot(l[N])<0?-1:1;o.setXYZW(N,v.x,v.y,v.z,U)}for(let N=0,P=n.count;N<P;++N)c[N]&&w(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Ye(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let r=new H,s=new H,o=new H,a=new H,l=new H,c=new H,u=new H,h=new H;if(t)for(let f=0,d=t.count;f<d;f+=3){let m=t.getX(f+0),y=t.getX(f+1),g=t.getX(f+2);r.fromBufferAttribute(e,m),s.fromBufferAttribute(e,y),o.fromBufferAttribute(e,g),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)r.fromBufferAttribute(e,f+0),s.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Un.fromBufferAttribute(t,e),Un.normalize(),t.setXYZ(e,Un.x,Un.y,Un.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,m=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let p=0;p<u;p++)f[m++]=c[d++]}return new Ye(f,u,h)}if(this.index===null)return jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=t(l,n);e.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(r[l]=u,s=!0)}s&&(t.data.morphAttributes=r,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let r=t.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(e))}let s=t.morphAttributes;for(let c in s){let u=[],h=s[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ll=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=$p,this.updateRanges=[],this.version=0,this.uuid=As()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let r=0,s=this.stride;r<s;r++)this.array[t+r]=e.array[n+r];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=gv(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),r=new this.constructor(n,this.stride);return r.setUsage(this.usage),r}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=gv(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function gv(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=As()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var oi=new H,Bi=class i{constructor(t,e,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=r,this._normalizationScale=t!==void 0?Ch(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)oi.fromBufferAttribute(this,e),oi.applyMatrix4(t),this.setXYZ(e,oi.x,oi.y,oi.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)oi.fromBufferAttribute(this,e),oi.applyNormalMatrix(t),this.setXYZ(e,oi.x,oi.y,oi.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)oi.fromBufferAttribute(this,e),oi.transformDirection(t),this.setXYZ(e,oi.x,oi.y,oi.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=r,this}setXYZW(t,e,n,r,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=r,this.data.array[t+3]=s,this}clone(t){if(t===void 0){nl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)e.push(this.data.array[r+s])}return new Ye(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){nl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)e.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Zp(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Kp(t,this.data.array)}},cp=new H,dE=new H,pE=new se,Ti=class{constructor(t=new H(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,r){return this.normal.set(t,e,n),this.constant=r,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let r=cp.subVectors(n,e).cross(dE.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(r,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let r=t.delta(cp),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/s;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(r,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||pE.getNormalMatrix(t),r=this.coplanarPoint(cp).applyMatrix4(t),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},mE=0,er=class extends Qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:mE++}),this.uuid=As(),this.name="",this.type="Material",this.blending=ca,this.side=Ms,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ep,this.blendDst=Tp,this.blendEquation=Js,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=Ko,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=o_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=cu,this.stencilZFail=cu,this.stencilZPass=cu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){jt(`Material: parameter '${e}' has value of undefined.`);continue}let r=this[e];if(r===void 0){jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(e){let s=r(t.textures),o=r(t.images);s.length>0&&(n.textures=s),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Ti().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Zt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let r=e.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=e[s].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Vr=new H,up=new H,$c=new H,Xc=new H,$s=class{constructor(t=new H,e=new H(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Vr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Vr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Vr.copy(this.origin).addScaledVector(this.direction,e),Vr.distanceToSquared(t))}distanceSqToSegment(t,e,n,r){up.copy(t).add(e).multiplyScalar(.5),$c.copy(e).sub(t).normalize(),Xc.copy(this.origin).sub(up);let s=t.distanceTo(e)*.5,o=-this.direction.dot($c),a=Xc.dot(this.direction),l=-Xc.dot($c),c=Xc.lengthSq(),u=Math.abs(1-o*o),h,f,d,m;if(u>0)if(h=o*l-a,f=o*a-l,m=s*u,h>=0)if(f>=-m)if(f<=m){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-s,-l),s),d=f*(f+2*l)+c):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(up).addScaledVector($c,f),d}intersectSphere(t,e){if(t.radius<0)return null;Vr.subVectors(t.center,this.origin);let n=Vr.dot(this.direction),r=Vr.dot(Vr)-n*n,s=t.radius*t.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,r=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,r=(t.min.x-f.x)*c),u>=0?(s=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(s=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||s>r||((s>n||isNaN(n))&&(n=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>r)||((a>n||n!==n)&&(n=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(n>=0?n:r,e)}intersectsBox(t){return this.intersectBox(t,Vr)!==null}intersectTriangle(t,e,n,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,f=t.y-o.y,d=t.z-o.z,m=e.x-o.x,y=e.y-o.y,g=e.z-o.z,p=n.x-o.x,x=n.y-o.y,_=n.z-o.z,v=Math.abs(l),M=Math.abs(c),A=Math.abs(u),b,w,N,P,I,U,V,C,D,G,z,et;if(v>=M&&v>=A?(N=l,U=h,D=m,et=p,l>=0?(b=c,w=u,P=f,I=d,V=y,C=g,G=x,z=_):(b=u,w=c,P=d,I=f,V=g,C=y,G=_,z=x)):M>=A?(N=c,U=f,D=y,et=x,c>=0?(b=u,w=l,P=d,I=h,V=g,C=m,G=_,z=p):(b=l,w=u,P=h,I=d,V=m,C=g,G=p,z=_)):(N=u,U=d,D=g,et=_,u>=0?(b=l,w=c,P=h,I=f,V=m,C=y,G=p,z=x):(b=c,w=l,P=f,I=h,V=y,C=m,G=x,z=p)),N===0)return null;let $=b/N,X=w/N,tt=1/N,ht=P-$*U,ct=I-X*U,J=V-$*D,dt=C-X*D,gt=G-$*et,bt=z-X*et,yt=gt*dt-bt*J,Gt=ht*bt-ct*gt,Kt=J*ct-dt*ht;if(r){if(yt<0||Gt<0||Kt<0)return null}else if((yt<0||Gt<0||Kt<0)&&(yt>0||Gt>0||Kt>0))return null;let zt=yt+Gt+Kt;if(zt===0)return null;let le=tt*(yt*U+Gt*D+Kt*et);return(zt>0?le<0:le>0)?null:this.at(le/zt,s)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ia=class extends er{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.combine=Hu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},yv=new $e,Ws=new $s,Yc=new tr,xv=new H,jc=new H,Zc=new H,Kc=new H,hp=new H,Jc=new H,vv=new H,Qc=new H,Ge=class extends Wn{constructor(t=new on,e=new ia){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let r=e[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(t,e){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(r,t);let a=this.morphTargetInfluences;if(s&&a){Jc.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(hp.fromBufferAttribute(h,t),o?Jc.addScaledVector(hp,u):Jc.addScaledVector(hp.sub(e),u))}e.add(Jc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Yc.copy(n.boundingSphere),Yc.applyMatrix4(s),Ws.copy(t.ray).recast(t.near),!(Yc.containsPoint(Ws.origin)===!1&&(Ws.intersectSphere(Yc,xv)===null||Ws.origin.distanceToSquared(xv)>(t.far-t.near)**2))&&(yv.copy(s).invert(),Ws.copy(t.ray).applyMatrix4(yv),!(n.boundingBox!==null&&Ws.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Ws)))}_computeIntersections(t,e,n){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],x=Math.max(g.start,d.start),_=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let v=x,M=_;v<M;v+=3){let A=a.getX(v),b=a.getX(v+1),w=a.getX(v+2);r=tu(this,p,t,n,c,u,h,A,b,w),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,e.push(r))}}else{let m=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let g=m,p=y;g<p;g+=3){let x=a.getX(g),_=a.getX(g+1),v=a.getX(g+2);r=tu(this,o,t,n,c,u,h,x,_,v),r&&(r.faceIndex=Math.floor(g/3),e.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],x=Math.max(g.start,d.start),_=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let v=x,M=_;v<M;v+=3){let A=v,b=v+1,w=v+2;r=tu(this,p,t,n,c,u,h,A,b,w),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,e.push(r))}}else{let m=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let g=m,p=y;g<p;g+=3){let x=g,_=g+1,v=g+2;r=tu(this,o,t,n,c,u,h,x,_,v),r&&(r.faceIndex=Math.floor(g/3),e.push(r))}}}};function gE(i,t,e,n,r,s,o,a){let l;if(t.side===ci?l=n.intersectTriangle(o,s,r,!0,a):l=n.intersectTriangle(r,s,o,t.side===Ms,a),l===null)return null;Qc.copy(a),Qc.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Qc);return c<e.near||c>e.far?null:{distance:c,point:Qc.clone(),object:i}}function tu(i,t,e,n,r,s,o,a,l,c){i.getVertexPosition(a,jc),i.getVertexPosition(l,Zc),i.getVertexPosition(c,Kc);let u=gE(i,t,e,n,jc,Zc,Kc,vv);if(u){let h=new H;ds.getBarycoord(vv,jc,Zc,Kc,h),r&&(u.uv=ds.getInterpolatedAttribute(r,a,l,c,h,new Zt)),s&&(u.uv1=ds.getInterpolatedAttribute(s,a,l,c,h,new Zt)),o&&(u.normal=ds.getInterpolatedAttribute(o,a,l,c,h,new H),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new H,materialIndex:0};ds.getNormal(jc,Zc,Kc,f.normal),u.face=f,u.barycoord=h}return u}var Mu=class extends fi{constructor(t=null,e=1,n=1,r,s,o,a,l,c=Bn,u=Bn,h,f){super(null,o,a,l,c,u,r,s,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var qs=new tr,yE=new Zt(.5,.5),eu=new H,ps=class{constructor(t=new Ti,e=new Ti,n=new Ti,r=new Ti,s=new Ti,o=new Ti){this.planes=[t,e,n,r,s,o]}set(t,e,n,r,s,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=ki,n=!1){let r=this.planes,s=t.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],f=s[6],d=s[7],m=s[8],y=s[9],g=s[10],p=s[11],x=s[12],_=s[13],v=s[14],M=s[15];if(r[0].setComponents(c-o,d-u,p-m,M-x).normalize(),r[1].setComponents(c+o,d+u,p+m,M+x).normalize(),r[2].setComponents(c+a,d+h,p+y,M+_).normalize(),r[3].setComponents(c-a,d-h,p-y,M-_).normalize(),n)r[4].setComponents(l,f,g,v).normalize(),r[5].setComponents(c-l,d-f,p-g,M-v).normalize();else if(r[4].setComponents(c-l,d-f,p-g,M-v).normalize(),e===ki)r[5].setComponents(c+l,d+f,p+g,M+v).normalize();else if(e===Jo)r[5].setComponents(l,f,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),qs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),qs.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(qs)}intersectsSprite(t){qs.center.set(0,0,0);let e=yE.distanceTo(t.center);return qs.radius=.7071067811865476+e,qs.applyMatrix4(t.matrixWorld),this.intersectsSphere(qs)}intersectsSphere(t){let e=this.planes,n=t.center,r=-t.radius;for(let s=0;s<6;s++)if(e[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let r=e[n];if(eu.x=r.normal.x>0?t.max.x:t.min.x,eu.y=r.normal.y>0?t.max.y:t.min.y,eu.z=r.normal.z>0?t.max.z:t.min.z,r.distanceToPoint(eu)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},_v=new $e,Su=class i{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let r=0;r<e.length;r++){let s=e[r];_v.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new ps),n[r].setFromProjectionMatrix(_v,s.coordinateSystem,s.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let r=0;r<t._count;r++)e[r]===void 0&&(e[r]=new ps),e[r].copy(n[r]);return this._count=t._count,this}clone(){return new i().copy(this)}};var ra=class extends er{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Au=new H,Eu=new H,bv=new $e,Ya=new $s,nu=new tr,fp=new H,wv=new H,sa=class extends Wn{constructor(t=new on,e=new ra){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let r=1,s=e.count;r<s;r++)Au.fromBufferAttribute(e,r-1),Eu.fromBufferAttribute(e,r),n[r]=n[r-1],n[r]+=Au.distanceTo(Eu);t.setAttribute("lineDistance",new Xe(n,1))}else jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,r=this.matrixWorld,s=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),nu.copy(n.boundingSphere),nu.applyMatrix4(r),nu.radius+=s,t.ray.intersectsSphere(nu)===!1)return;bv.copy(r).invert(),Ya.copy(t.ray).applyMatrix4(bv);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=d,g=m-1;y<g;y+=c){let p=u.getX(y),x=u.getX(y+1),_=iu(this,t,Ya,l,p,x,y);_&&e.push(_)}if(this.isLineLoop){let y=u.getX(m-1),g=u.getX(d),p=iu(this,t,Ya,l,y,g,m-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=d,g=m-1;y<g;y+=c){let p=iu(this,t,Ya,l,y,y+1,y);p&&e.push(p)}if(this.isLineLoop){let y=iu(this,t,Ya,l,m-1,d,m-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let r=e[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function iu(i,t,e,n,r,s,o){let a=i.geometry.attributes.position;if(Au.fromBufferAttribute(a,r),Eu.fromBufferAttribute(a,s),e.distanceSqToSegment(Au,Eu,fp,wv)>n)return;fp.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(fp);if(!(c<t.near||c>t.far))return{distance:c,point:wv.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Mv=new H,Sv=new H,Tu=class extends sa{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let r=0,s=e.count;r<s;r+=2)Mv.fromBufferAttribute(e,r),Sv.fromBufferAttribute(e,r+1),n[r]=r===0?0:n[r-1],n[r+1]=n[r]+Mv.distanceTo(Sv);t.setAttribute("lineDistance",new Xe(n,1))}else jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var cl=class extends fi{constructor(t=[],e=Qs,n,r,s,o,a,l,c,u){super(t,e,n,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Wr=class extends fi{constructor(t,e,n=nr,r,s,o,a=Bn,l=Bn,c,u=Hr,h=1){if(u!==Hr&&u!==$r)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,r,s,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ea(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ul=class extends Wr{constructor(t,e=nr,n=Qs,r,s,o=Bn,a=Bn,l,c=Hr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,n,r,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},hl=class extends fi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ms=class i extends on{constructor(t=1,e=1,n=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;m("z","y","x",-1,-1,n,e,t,o,s,0),m("z","y","x",1,-1,n,e,-t,o,s,1),m("x","z","y",1,1,t,n,e,r,o,2),m("x","z","y",1,-1,t,n,-e,r,o,3),m("x","y","z",1,-1,t,e,n,r,s,4),m("x","y","z",-1,-1,t,e,-n,r,s,5),this.setIndex(l),this.setAttribute("position",new Xe(c,3)),this.setAttribute("normal",new Xe(u,3)),this.setAttribute("uv",new Xe(h,2));function m(y,g,p,x,_,v,M,A,b,w,N){let P=v/b,I=M/w,U=v/2,V=M/2,C=A/2,D=b+1,G=w+1,z=0,et=0,$=new H;for(let X=0;X<G;X++){let tt=X*I-V;for(let ht=0;ht<D;ht++){let ct=ht*P-U;$[y]=ct*x,$[g]=tt*_,$[p]=C,c.push($.x,$.y,$.z),$[y]=0,$[g]=0,$[p]=A>0?1:-1,u.push($.x,$.y,$.z),h.push(ht/b),h.push(1-X/w),z+=1}}for(let X=0;X<w;X++)for(let tt=0;tt<b;tt++){let ht=f+tt+D*X,ct=f+tt+D*(X+1),J=f+(tt+1)+D*(X+1),dt=f+(tt+1)+D*X;l.push(ht,ct,dt),l.push(ct,J,dt),et+=6}a.addGroup(d,et,N),d+=et,f+=z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var _r=class i extends on{constructor(t=1,e=1,n=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let u=[],h=[],f=[],d=[],m=0,y=[],g=n/2,p=0;x(),o===!1&&(t>0&&_(!0),e>0&&_(!1)),this.setIndex(u),this.setAttribute("position",new Xe(h,3)),this.setAttribute("normal",new Xe(f,3)),this.setAttribute("uv",new Xe(d,2));function x(){let v=new H,M=new H,A=0,b=(e-t)/n;for(let w=0;w<=s;w++){let N=[],P=w/s,I=P*(e-t)+t;for(let U=0;U<=r;U++){let V=U/r,C=V*l+a,D=Math.sin(C),G=Math.cos(C);M.x=I*D,M.y=-P*n+g,M.z=I*G,h.push(M.x,M.y,M.z),v.set(D,b,G).normalize(),f.push(v.x,v.y,v.z),d.push(V,1-P),N.push(m++)}y.push(N)}for(let w=0;w<r;w++)for(let N=0;N<s;N++){let P=y[N][w],I=y[N+1][w],U=y[N+1][w+1],V=y[N][w+1];(t>0||N!==0)&&(u.push(P,I,V),A+=3),(e>0||N!==s-1)&&(u.push(I,U,V),A+=3)}c.addGroup(p,A,0),p+=A}function _(v){let M=m,A=new Zt,b=new H,w=0,N=v===!0?t:e,P=v===!0?1:-1;for(let U=1;U<=r;U++)h.push(0,g*P,0),f.push(0,P,0),d.push(.5,.5),m++;let I=m;for(let U=0;U<=r;U++){let C=U/r*l+a,D=Math.cos(C),G=Math.sin(C);b.x=N*G,b.y=g*P,b.z=N*D,h.push(b.x,b.y,b.z),f.push(0,P,0),A.x=D*.5+.5,A.y=G*.5*P+.5,d.push(A.x,A.y),m++}for(let U=0;U<r;U++){let V=M+U,C=I+U;v===!0?u.push(C,C+1,V):u.push(C+1,C,V),w+=3}c.addGroup(p,w,v===!0?1:2),p+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},fl=class i extends _r{constructor(t=1,e=1,n=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,t,e,n,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Xs=class i extends on{constructor(t=1,e=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:r};let s=t/2,o=e/2,a=Math.floor(n),l=Math.floor(r),c=a+1,u=l+1,h=t/a,f=e/l,d=[],m=[],y=[],g=[];for(let p=0;p<u;p++){let x=p*f-o;for(let _=0;_<c;_++){let v=_*h-s;m.push(v,-x,0),y.push(0,0,1),g.push(_/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let x=0;x<a;x++){let _=x+c*p,v=x+c*(p+1),M=x+1+c*(p+1),A=x+1+c*p;d.push(_,v,A),d.push(v,M,A)}this.setIndex(d),this.setAttribute("position",new Xe(m,3)),this.setAttribute("normal",new Xe(y,3)),this.setAttribute("uv",new Xe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var oa=class i extends on{constructor(t=1,e=32,n=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new H,f=new H,d=[],m=[],y=[],g=[];for(let p=0;p<=n;p++){let x=[],_=p/n,v=o+_*a,M=t*Math.cos(v),A=Math.sqrt(t*t-M*M),b=0;p===0&&o===0?b=.5/e:p===n&&l===Math.PI&&(b=-.5/e);for(let w=0;w<=e;w++){let N=w/e,P=r+N*s;h.x=-A*Math.cos(P),h.y=M,h.z=A*Math.sin(P),m.push(h.x,h.y,h.z),f.copy(h).normalize(),y.push(f.x,f.y,f.z),g.push(N+b,1-_),x.push(c++)}u.push(x)}for(let p=0;p<n;p++)for(let x=0;x<e;x++){let _=u[p][x+1],v=u[p][x],M=u[p+1][x],A=u[p+1][x+1];(p!==0||o>0)&&d.push(_,v,A),(p!==n-1||l<Math.PI)&&d.push(v,M,A)}this.setIndex(d),this.setAttribute("position",new Xe(m,3)),this.setAttribute("normal",new Xe(y,3)),this.setAttribute("uv",new Xe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var dl=class extends on{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,r=new H,s=new H;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,d=h.count;for(let m=f,y=f+d;m<y;m+=3)for(let g=0;g<3;g++){let p=a.getX(m+g),x=a.getX(m+(g+1)%3);r.fromBufferAttribute(o,p),s.fromBufferAttribute(o,x),Av(r,s,n)===!0&&(e.push(r.x,r.y,r.z),e.push(s.x,s.y,s.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;r.fromBufferAttribute(o,u),s.fromBufferAttribute(o,h),Av(r,s,n)===!0&&(e.push(r.x,r.y,r.z),e.push(s.x,s.y,s.z))}}this.setAttribute("position",new Xe(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Av(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,r=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(r)===!0?!1:(e.add(n),e.add(r),!0)}var pl=class extends er{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new he(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function eo(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let r=i[e][n];if(Ev(r))r.isRenderTargetTexture?(jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=r.clone();else if(Array.isArray(r))if(Ev(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();t[e][n]=s}else t[e][n]=r.slice();else t[e][n]=r}}return t}function Kn(i){let t={};for(let e=0;e<i.length;e++){let n=eo(i[e]);for(let r in n)t[r]=n[r]}return t}function Ev(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function xE(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Jp(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:be.workingColorSpace}var Dl={clone:eo,merge:Kn},vE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_E=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,zi=class extends er{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=vE,this.fragmentShader=_E,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=eo(t.uniforms),this.uniformsGroups=xE(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?e.uniforms[r]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[r]={type:"m4",value:o.toArray()}:e.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let r=t.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=e[r.value]||null;break;case"c":this.uniforms[n].value=new he().setHex(r.value);break;case"v2":this.uniforms[n].value=new Zt().fromArray(r.value);break;case"v3":this.uniforms[n].value=new H().fromArray(r.value);break;case"v4":this.uniforms[n].value=new Le().fromArray(r.value);break;case"m3":this.uniforms[n].value=new se().fromArray(r.value);break;case"m4":this.uniforms[n].value=new $e().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Ru=class extends zi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},ml=class extends er{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new he(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Fl,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Ys=class extends er{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Fl,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.combine=Hu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Cu=class extends er{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=r_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Pu=class extends er{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var gl=class extends ra{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function qo(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function ru(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var gs=class{constructor(t,e,n,r){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,r=e[n],s=e[n-1];t:{e:{let o;n:{i:if(!(t<r)){for(let a=n+2;;){if(r===void 0){if(t<s)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(s=r,r=e[++n],t<r)break e}o=e.length;break n}if(!(t>=s)){let a=e[1];t<a&&(n=2,s=a);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(r=s,s=e[--n-1],t>=s)break e}o=n,n=0;break n}break t}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(r=e[n],s=e[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,t,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=t*r;for(let o=0;o!==r;++o)e[o]=n[s+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Iu=class extends gs{constructor(t,e,n,r){super(t,e,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:gp,endingEnd:gp}}intervalChanged_(t,e,n){let r=this.parameterPositions,s=t-2,o=t+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case yp:s=t,a=2*e-n;break;case xp:s=r.length-2,a=e+r[s]-r[s+1];break;default:s=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case yp:o=t,l=2*n-e;break;case xp:o=1,l=n+r[1]-r[0];break;default:o=t-1,l=e}let c=(n-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(n-e)/(r-e),y=m*m,g=y*m,p=-f*g+2*f*y-f*m,x=(1+f)*g+(-1.5-2*f)*y+(-.5+f)*m+1,_=(-1-d)*g+(1.5+d)*y+.5*m,v=d*g-d*y;for(let M=0;M!==a;++M)s[M]=p*o[u+M]+x*o[c+M]+_*o[l+M]+v*o[h+M];return s}},Lu=class extends gs{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(n-e)/(r-e),h=1-u;for(let f=0;f!==a;++f)s[f]=o[c+f]*h+o[l+f]*u;return s}},Fu=class extends gs{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t){return this.copySampleValue_(t-1)}},Nu=class extends gs{interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(n-e)/(r-e),y=1-m;for(let g=0;g!==a;++g)s[g]=o[c+g]*y+o[l+g]*m;return s}let f=a*2,d=t-1;for(let m=0;m!==a;++m){let y=o[c+m],g=o[l+m],p=d*f+m*2,x=h[p],_=h[p+1],v=t*f+m*2,M=u[v],A=u[v+1],b=wE(n,e,x,M,r);s[m]=y_(b,y,_,A,g)}return s}};function y_(i,t,e,n,r){let s=1-i;return s*s*s*t+3*s*s*i*e+3*s*i*i*n+i*i*i*r}function bE(i,t,e,n,r){let s=1-i;return 3*s*s*(e-t)+6*s*i*(n-e)+3*i*i*(r-n)}function wE(i,t,e,n,r){let s=(i-t)/(r-t);for(let o=0;o<8;o++){let a=y_(s,t,e,n,r)-i;if(Math.abs(a)<1e-10)break;let l=bE(s,t,e,n,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var Ci=class{constructor(t,e,n,r){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=qo(e,this.TimeBufferType),this.values=qo(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:qo(t.times,Array),values:qo(t.values,Array)};let r=t.getInterpolation();r!==t.DefaultInterpolation&&(n.interpolation=r),ru(t.settings)&&(n.settings={inTangents:qo(t.settings.inTangents,Array),outTangents:qo(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Fu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Lu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Iu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Nu(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ja:e=this.InterpolantFactoryMethodDiscrete;break;case vu:e=this.InterpolantFactoryMethodLinear;break;case lu:e=this.InterpolantFactoryMethodSmooth;break;case mp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return jt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ja;case this.InterpolantFactoryMethodLinear:return vu;case this.InterpolantFactoryMethodSmooth:return lu;case this.InterpolantFactoryMethodBezier:return mp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,r=e.length;n!==r;++n)e[n]+=t;ru(this.settings)&&(Tv(this.settings.inTangents,t),Tv(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,r=e.length;n!==r;++n)e[n]*=t;ru(this.settings)&&(Rv(this.settings.inTangents,t),Rv(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,r=n.length,s=0,o=r-1;for(;s!==r&&n[s]<t;)++s;for(;o!==-1&&n[o]>e;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,r=this.values,s=n.length;s===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==s;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){re("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){re("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(r!==void 0&&kA(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){re("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===lu,s=t.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(r)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let m=0;m!==n;++m){let y=e[h+m];if(y!==e[f+m]||y!==e[d+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[h+d]}++o}}if(s>0){t[o]=t[s];for(let a=s*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,r=new n(this.name,t,e);return r.createInterpolant=this.createInterpolant,ru(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Tv(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Rv(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}Ci.prototype.ValueTypeName="";Ci.prototype.TimeBufferType=Float32Array;Ci.prototype.ValueBufferType=Float32Array;Ci.prototype.DefaultInterpolation=vu;var ys=class extends Ci{constructor(t,e,n){super(t,e,n)}};ys.prototype.ValueTypeName="bool";ys.prototype.ValueBufferType=Array;ys.prototype.DefaultInterpolation=Ja;ys.prototype.InterpolantFactoryMethodLinear=void 0;ys.prototype.InterpolantFactoryMethodSmooth=void 0;var Du=class extends Ci{constructor(t,e,n,r){super(t,e,n,r)}};Du.prototype.ValueTypeName="color";var Ou=class extends Ci{constructor(t,e,n,r){super(t,e,n,r)}};Ou.prototype.ValueTypeName="number";var Uu=class extends gs{constructor(t,e,n,r){super(t,e,n,r)}interpolate_(t,e,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(r-e),c=t*a;for(let u=c+a;c!==u;c+=4)zn.slerpFlat(s,0,o,c-a,o,c,l);return s}},yl=class extends Ci{constructor(t,e,n,r){super(t,e,n,r)}InterpolantFactoryMethodLinear(t){return new Uu(this.times,this.values,this.getValueSize(),t)}};yl.prototype.ValueTypeName="quaternion";yl.prototype.InterpolantFactoryMethodSmooth=void 0;var xs=class extends Ci{constructor(t,e,n){super(t,e,n)}};xs.prototype.ValueTypeName="string";xs.prototype.ValueBufferType=Array;xs.prototype.DefaultInterpolation=Ja;xs.prototype.InterpolantFactoryMethodLinear=void 0;xs.prototype.InterpolantFactoryMethodSmooth=void 0;var ku=class extends Ci{constructor(t,e,n,r){super(t,e,n,r)}};ku.prototype.ValueTypeName="vector";var Bu=class{constructor(t,e,n){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],m=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},x_=new Bu,zu=class{constructor(t){this.manager=t!==void 0?t:x_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(r,s){n.load(t,r,e,s)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};zu.DEFAULT_MATERIAL_NAME="__DEFAULT";var xl=class extends Wn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},vl=class extends xl{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Wn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},dp=new $e,Cv=new H,Pv=new H,Vu=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Zt(512,512),this.mapType=di,this.map=null,this.mapPass=null,this.matrix=new $e,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ps,this._frameExtents=new Zt(1,1),this._viewportCount=1,this._viewports=[new Le(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Cv.setFromMatrixPosition(t.matrixWorld),e.position.copy(Cv),Pv.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Pv),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,r){dp.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(dp,t.coordinateSystem,t.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;t.coordinateSystem===Jo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(dp)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},su=new H,ou=new zn,yr=new H,_l=class extends Wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new $e,this.projectionMatrix=new $e,this.projectionMatrixInverse=new $e,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(su,ou,yr),yr.x===1&&yr.y===1&&yr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(su,ou,yr.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(su,ou,yr),yr.x===1&&yr.y===1&&yr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(su,ou,yr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},fs=new H,Iv=new Zt,Lv=new Zt,Hn=class extends _l{constructor(t=50,e=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ta*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Za*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ta*2*Math.atan(Math.tan(Za*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){fs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(fs.x,fs.y).multiplyScalar(-t/fs.z),fs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(fs.x,fs.y).multiplyScalar(-t/fs.z)}getViewSize(t,e){return this.getViewBounds(t,Iv,Lv),e.subVectors(Lv,Iv)}setViewOffset(t,e,n,r,s,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Za*.5*this.fov)/this.zoom,n=2*e,r=this.aspect*n,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,e-=o.offsetY*n/c,r*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(s+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var bl=class extends _l{constructor(t=-1,e=1,n=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-t,o=n+t,a=r+e,l=r-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},vp=class extends Vu{constructor(){super(new bl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},wl=class extends xl{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Wn.DEFAULT_UP),this.updateMatrix(),this.target=new Wn,this.shadow=new vp}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Ml=class extends on{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var $o=-90,Xo=1,aa=class extends Wn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Hn($o,Xo,t,e);r.layers=this.layers,this.add(r);let s=new Hn($o,Xo,t,e);s.layers=this.layers,this.add(s);let o=new Hn($o,Xo,t,e);o.layers=this.layers,this.add(o);let a=new Hn($o,Xo,t,e);a.layers=this.layers,this.add(a);let l=new Hn($o,Xo,t,e);l.layers=this.layers,this.add(l);let c=new Hn($o,Xo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,r,s,o,a,l]=e;for(let c of e)this.remove(c);if(t===ki)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Jo)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,s),t.setRenderTarget(n,1,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Gu=class extends Hn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Qp="\\[\\]\\.:\\/",ME=new RegExp("["+Qp+"]","g"),tm="[^"+Qp+"]",SE="[^"+Qp.replace("\\.","")+"]",AE=/((?:WC+[\/:])*)/.source.replace("WC",tm),EE=/(WCOD+)?/.source.replace("WCOD",SE),TE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",tm),RE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",tm),CE=new RegExp("^"+AE+EE+TE+RE+"$"),PE=["material","materials","bones","map"],_p=class{constructor(t,e,n){let r=n||nn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,r)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},nn=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(ME,"")}static parseTrackName(t){let e=CE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);PE.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},r=n(t.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)t[e++]=n[r]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,r=e.propertyName,s=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[r];if(o===void 0){let c=e.nodeName;re("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[s]!==void 0&&(s=t.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=_p;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nD=new Float32Array(1);var vs=class extends ll{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var _s=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ue(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ue(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var bp=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,r){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,r){let s=this.elements;return s[0]=t,s[2]=e,s[1]=n,s[3]=r,this}};var Fv=new H,au=new H,Yo=new H,jo=new H,pp=new H,IE=new H,LE=new H,Sl=class{constructor(t=new H,e=new H){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){Fv.subVectors(t,this.start),au.subVectors(this.end,this.start);let n=au.dot(au);if(n===0)return 0;let s=au.dot(Fv)/n;return e&&(s=ue(s,0,1)),s}closestPointToPoint(t,e,n){let r=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(r).add(this.start)}distanceSqToLine3(t,e=IE,n=LE){let r=10000000000000001e-32,s,o,a=this.start,l=t.start,c=this.end,u=t.end;Yo.subVectors(c,a),jo.subVectors(u,l),pp.subVectors(a,l);let h=Yo.dot(Yo),f=jo.dot(jo),d=jo.dot(pp);if(h<=r&&f<=r)return e.copy(a),n.copy(l),e.distanceToSquared(n);if(h<=r)s=0,o=d/f,o=ue(o,0,1);else{let m=Yo.dot(pp);if(f<=r)o=0,s=ue(-m/h,0,1);else{let y=Yo.dot(jo),g=h*f-y*y;g!==0?s=ue((y*d-m*f)/g,0,1):s=0,o=(y*s+d)/f,o<0?(o=0,s=ue(-m/h,0,1)):o>1&&(o=1,s=ue((y-m)/h,0,1))}}return e.copy(a).addScaledVector(Yo,s),n.copy(l).addScaledVector(jo,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var js=class extends Tu{constructor(t=10,e=10,n=4473924,r=8947848){n=new he(n),r=new he(r);let s=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,m=-a;f<=e;f++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let y=f===s?n:r;y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3}let u=new on;u.setAttribute("position",new Xe(l,3)),u.setAttribute("color",new Xe(c,3));let h=new ra({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Al=class extends Qi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function em(i,t,e,n){let r=FE(n);switch(e){case zp:return i*t;case Gp:return i*t/r.components*r.byteLength;case Zu:return i*t/r.components*r.byteLength;case Ss:return i*t*2/r.components*r.byteLength;case Ku:return i*t*2/r.components*r.byteLength;case Vp:return i*t*3/r.components*r.byteLength;case sr:return i*t*4/r.components*r.byteLength;case Ju:return i*t*4/r.components*r.byteLength;case Tl:case Rl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Cl:case Pl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case th:case nh:return Math.max(i,16)*Math.max(t,8)/4;case Qu:case eh:return Math.max(i,8)*Math.max(t,8)/2;case ih:case rh:case oh:case ah:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case sh:case Il:case lh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ch:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case uh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case hh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case fh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case dh:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case ph:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case mh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case gh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case yh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case xh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case vh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case _h:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case bh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case wh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Mh:case Sh:case Ah:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Eh:case Th:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ll:case Rh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function FE(i){switch(i){case di:case Op:return{byteLength:1,components:1};case ha:case Up:case rr:return{byteLength:2,components:1};case Yu:case ju:return{byteLength:2,components:4};case nr:case Xu:case ir:return{byteLength:4,components:1};case kp:case Bp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function z_(){let i=null,t=!1,e=null,n=null;function r(s,o){n=i.requestAnimationFrame(r),e(s,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(r),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(s){e=s},setContext:function(s){i=s}}}function BE(i){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<h.length;d++){let m=h[f],y=h[d];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,m=h.length;d<m;d++){let y=h[d];i.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var zE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,VE=`#ifdef USE_ALPHAHASH
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
#endif`,GE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,HE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,WE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,qE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,$E=`#ifdef USE_AOMAP
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
#endif`,XE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,YE=`#ifdef USE_BATCHING
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
#endif`,jE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ZE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,KE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,JE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,QE=`#ifdef USE_IRIDESCENCE
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
#endif`,tT=`#ifdef USE_BUMPMAP
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
#endif`,eT=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,nT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,iT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,rT=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,sT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,oT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,aT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,lT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,cT=`#define PI 3.141592653589793
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
} // validated`,uT=`vec3 transformedNormal = objectNormal;
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
#endif`,hT=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,fT=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,dT=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,pT=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,mT="gl_FragColor = linearToOutputTexel( gl_FragColor );",gT=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,yT=`#ifdef USE_ENVMAP
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
#endif`,xT=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,vT=`#ifdef USE_ENVMAP
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
#endif`,_T=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,bT=`#ifdef USE_ENVMAP
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
#endif`,wT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,MT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ST=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,AT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ET=`#ifdef USE_GRADIENTMAP
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
}`,TT=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,RT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,CT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,PT=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,IT=`#ifdef USE_ENVMAP
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
#endif`,LT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,FT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,NT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,DT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,OT=`PhysicalMaterial material;
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
#endif`,UT=`uniform sampler2D dfgLUT;
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
}`,kT=`
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
#endif`,BT=`#if defined( RE_IndirectDiffuse )
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
#endif`,zT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,VT=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,GT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,HT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,WT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,$T=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,XT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,YT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,jT=`#if defined( USE_POINTS_UV )
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
#endif`,ZT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,KT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,JT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,QT=`#if defined( USE_MORPHCOLORS )
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
#endif`,tR=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,eR=`#ifdef USE_MORPHTARGETS
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
#endif`,nR=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,iR=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,rR=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,sR=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,oR=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,aR=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,lR=`#ifdef USE_NORMALMAP
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
#endif`,cR=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,uR=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,hR=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,fR=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,dR=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,pR=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,mR=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,gR=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,yR=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,xR=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,vR=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,_R=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,bR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,wR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,MR=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,SR=`float getShadowMask() {
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
}`,AR=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ER=`#ifdef USE_SKINNING
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
#endif`,TR=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,RR=`#ifdef USE_SKINNING
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
#endif`,CR=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,PR=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,IR=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,LR=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,FR=`#ifdef USE_TRANSMISSION
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
#endif`,NR=`#ifdef USE_TRANSMISSION
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
#endif`,DR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,OR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,UR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,kR=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,BR=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,zR=`uniform sampler2D t2D;
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
}`,VR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,GR=`uniform float backgroundBlurriness;
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
}`,HR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,WR=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qR=`#include <common>
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
}`,$R=`#if DEPTH_PACKING == 3200
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
}`,XR=`#define DISTANCE
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
}`,YR=`#define DISTANCE
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
}`,jR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ZR=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,KR=`uniform float scale;
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
}`,JR=`uniform vec3 diffuse;
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
}`,QR=`#include <common>
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
}`,tC=`uniform vec3 diffuse;
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
}`,eC=`#define LAMBERT
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
}`,nC=`#define LAMBERT
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
}`,iC=`#define MATCAP
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
}`,rC=`#define MATCAP
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
}`,sC=`#define NORMAL
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
}`,oC=`#define NORMAL
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
}`,aC=`#define PHONG
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
}`,lC=`#define PHONG
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
}`,cC=`#define STANDARD
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
}`,uC=`#define STANDARD
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
}`,hC=`#define TOON
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
}`,fC=`#define TOON
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
}`,dC=`uniform float size;
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
}`,pC=`uniform vec3 diffuse;
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
}`,mC=`#include <common>
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
}`,gC=`uniform vec3 color;
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
}`,yC=`uniform float rotation;
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
}`,xC=`uniform vec3 diffuse;
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
}`,pe={alphahash_fragment:zE,alphahash_pars_fragment:VE,alphamap_fragment:GE,alphamap_pars_fragment:HE,alphatest_fragment:WE,alphatest_pars_fragment:qE,aomap_fragment:$E,aomap_pars_fragment:XE,batching_pars_vertex:YE,batching_vertex:jE,begin_vertex:ZE,beginnormal_vertex:KE,bsdfs:JE,iridescence_fragment:QE,bumpmap_pars_fragment:tT,clipping_planes_fragment:eT,clipping_planes_pars_fragment:nT,clipping_planes_pars_vertex:iT,clipping_planes_vertex:rT,color_fragment:sT,color_pars_fragment:oT,color_pars_vertex:aT,color_vertex:lT,common:cT,defaultnormal_vertex:uT,displacementmap_pars_vertex:hT,displacementmap_vertex:fT,emissivemap_fragment:dT,emissivemap_pars_fragment:pT,colorspace_fragment:mT,colorspace_pars_fragment:gT,envmap_fragment:yT,envmap_common_pars_fragment:xT,envmap_pars_fragment:vT,envmap_pars_vertex:_T,envmap_physical_pars_fragment:IT,envmap_vertex:bT,fog_vertex:wT,fog_pars_vertex:MT,fog_fragment:ST,fog_pars_fragment:AT,gradientmap_pars_fragment:ET,lightmap_pars_fragment:TT,lights_lambert_fragment:RT,lights_lambert_pars_fragment:CT,lights_pars_begin:PT,lights_toon_fragment:LT,lights_toon_pars_fragment:FT,lights_phong_fragment:NT,lights_phong_pars_fragment:DT,lights_physical_fragment:OT,lights_physical_pars_fragment:UT,lights_fragment_begin:kT,lights_fragment_maps:BT,lights_fragment_end:zT,lightprobes_pars_fragment:VT,logdepthbuf_fragment:GT,logdepthbuf_pars_fragment:HT,logdepthbuf_pars_vertex:WT,logdepthbuf_vertex:qT,map_fragment:$T,map_pars_fragment:XT,map_particle_fragment:YT,map_particle_pars_fragment:jT,metalnessmap_fragment:ZT,metalnessmap_pars_fragment:KT,morphinstance_vertex:JT,morphcolor_vertex:QT,morphnormal_vertex:tR,morphtarget_pars_vertex:eR,morphtarget_vertex:nR,normal_fragment_begin:iR,normal_fragment_maps:rR,normal_pars_fragment:sR,normal_pars_vertex:oR,normal_vertex:aR,normalmap_pars_fragment:lR,clearcoat_normal_fragment_begin:cR,clearcoat_normal_fragment_maps:uR,clearcoat_pars_fragment:hR,iridescence_pars_fragment:fR,opaque_fragment:dR,packing:pR,premultiplied_alpha_fragment:mR,project_vertex:gR,dithering_fragment:yR,dithering_pars_fragment:xR,roughnessmap_fragment:vR,roughnessmap_pars_fragment:_R,shadowmap_pars_fragment:bR,shadowmap_pars_vertex:wR,shadowmap_vertex:MR,shadowmask_pars_fragment:SR,skinbase_vertex:AR,skinning_pars_vertex:ER,skinning_vertex:TR,skinnormal_vertex:RR,specularmap_fragment:CR,specularmap_pars_fragment:PR,tonemapping_fragment:IR,tonemapping_pars_fragment:LR,transmission_fragment:FR,transmission_pars_fragment:NR,uv_pars_fragment:DR,uv_pars_vertex:OR,uv_vertex:UR,worldpos_vertex:kR,background_vert:BR,background_frag:zR,backgroundCube_vert:VR,backgroundCube_frag:GR,cube_vert:HR,cube_frag:WR,depth_vert:qR,depth_frag:$R,distance_vert:XR,distance_frag:YR,equirect_vert:jR,equirect_frag:ZR,linedashed_vert:KR,linedashed_frag:JR,meshbasic_vert:QR,meshbasic_frag:tC,meshlambert_vert:eC,meshlambert_frag:nC,meshmatcap_vert:iC,meshmatcap_frag:rC,meshnormal_vert:sC,meshnormal_frag:oC,meshphong_vert:aC,meshphong_frag:lC,meshphysical_vert:cC,meshphysical_frag:uC,meshtoon_vert:hC,meshtoon_frag:fC,points_vert:dC,points_frag:pC,shadow_vert:mC,shadow_frag:gC,sprite_vert:yC,sprite_frag:xC},Pt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},ui={basic:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.fog]),vertexShader:pe.meshbasic_vert,fragmentShader:pe.meshbasic_frag},lambert:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,Pt.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:pe.meshlambert_vert,fragmentShader:pe.meshlambert_frag},phong:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,Pt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pe.meshphong_vert,fragmentShader:pe.meshphong_frag},standard:{uniforms:Kn([Pt.common,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.roughnessmap,Pt.metalnessmap,Pt.fog,Pt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag},toon:{uniforms:Kn([Pt.common,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.gradientmap,Pt.fog,Pt.lights,{emissive:{value:new he(0)}}]),vertexShader:pe.meshtoon_vert,fragmentShader:pe.meshtoon_frag},matcap:{uniforms:Kn([Pt.common,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,{matcap:{value:null}}]),vertexShader:pe.meshmatcap_vert,fragmentShader:pe.meshmatcap_frag},points:{uniforms:Kn([Pt.points,Pt.fog]),vertexShader:pe.points_vert,fragmentShader:pe.points_frag},dashed:{uniforms:Kn([Pt.common,Pt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pe.linedashed_vert,fragmentShader:pe.linedashed_frag},depth:{uniforms:Kn([Pt.common,Pt.displacementmap]),vertexShader:pe.depth_vert,fragmentShader:pe.depth_frag},normal:{uniforms:Kn([Pt.common,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,{opacity:{value:1}}]),vertexShader:pe.meshnormal_vert,fragmentShader:pe.meshnormal_frag},sprite:{uniforms:Kn([Pt.sprite,Pt.fog]),vertexShader:pe.sprite_vert,fragmentShader:pe.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pe.background_vert,fragmentShader:pe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:pe.backgroundCube_vert,fragmentShader:pe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pe.cube_vert,fragmentShader:pe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pe.equirect_vert,fragmentShader:pe.equirect_frag},distance:{uniforms:Kn([Pt.common,Pt.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pe.distance_vert,fragmentShader:pe.distance_frag},shadow:{uniforms:Kn([Pt.lights,Pt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:pe.shadow_vert,fragmentShader:pe.shadow_frag}};ui.physical={uniforms:Kn([ui.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag};var Ph={r:0,b:0,g:0},vC=new $e,V_=new se;V_.set(-1,0,0,0,1,0,0,0,1);function _C(i,t,e,n,r,s){let o=new he(0),a=r===!0?0:1,l,c,u=null,h=0,f=null;function d(x){let _=x.isScene===!0?x.background:null;if(_&&_.isTexture){let v=x.backgroundBlurriness>0;_=t.get(_,v)}return _}function m(x){let _=!1,v=d(x);v===null?g(o,a):v&&v.isColor&&(g(v,1),_=!0);let M=i.xr.getEnvironmentBlendMode();M==="additive"?e.buffers.color.setClear(0,0,0,1,s):M==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,s),(i.autoClear||_)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(x,_){let v=d(_);v&&v.isCubeTexture?(c===void 0&&(c=new Ge(new ms(1,1,1),new zi({name:"BackgroundCubeMaterial",uniforms:eo(ui.backgroundCube.uniforms),vertexShader:ui.backgroundCube.vertexShader,fragmentShader:ui.backgroundCube.fragmentShader,side:ci,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(M,A,b){this.matrixWorld.copyPosition(b.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(vC.makeRotationFromEuler(_.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(V_),c.material.toneMapped=be.getTransfer(v.colorSpace)!==Ie,(u!==v||h!==v.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,f=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Ge(new Xs(2,2),new zi({name:"BackgroundMaterial",uniforms:eo(ui.background.uniforms),vertexShader:ui.background.vertexShader,fragmentShader:ui.background.fragmentShader,side:Ms,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,l.material.toneMapped=be.getTransfer(v.colorSpace)!==Ie,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,f=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,_){x.getRGB(Ph,Jp(i)),e.buffers.color.setClear(Ph.r,Ph.g,Ph.b,_,s)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,_=1){o.set(x),a=_,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:m,addToRenderList:y,dispose:p}}function bC(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=f(null),s=r,o=!1;function a(I,U,V,C,D){let G=!1,z=h(I,C,V,U);s!==z&&(s=z,c(s.object)),G=d(I,C,V,D),G&&m(I,C,V,D),D!==null&&t.update(D,i.ELEMENT_ARRAY_BUFFER),(G||o)&&(o=!1,v(I,U,V,C),D!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(D).buffer))}function l(){return i.createVertexArray()}function c(I){return i.bindVertexArray(I)}function u(I){return i.deleteVertexArray(I)}function h(I,U,V,C){let D=C.wireframe===!0,G=n[U.id];G===void 0&&(G={},n[U.id]=G);let z=I.isInstancedMesh===!0?I.id:0,et=G[z];et===void 0&&(et={},G[z]=et);let $=et[V.id];$===void 0&&($={},et[V.id]=$);let X=$[D];return X===void 0&&(X=f(l()),$[D]=X),X}function f(I){let U=[],V=[],C=[];for(let D=0;D<e;D++)U[D]=0,V[D]=0,C[D]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:V,attributeDivisors:C,object:I,attributes:{},index:null}}function d(I,U,V,C){let D=s.attributes,G=U.attributes,z=0,et=V.getAttributes();for(let $ in et)if(et[$].location>=0){let tt=D[$],ht=G[$];if(ht===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(ht=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(ht=I.instanceColor)),tt===void 0||tt.attribute!==ht||ht&&tt.data!==ht.data)return!0;z++}return s.attributesNum!==z||s.index!==C}function m(I,U,V,C){let D={},G=U.attributes,z=0,et=V.getAttributes();for(let $ in et)if(et[$].location>=0){let tt=G[$];tt===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(tt=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(tt=I.instanceColor));let ht={};ht.attribute=tt,tt&&tt.data&&(ht.data=tt.data),D[$]=ht,z++}s.attributes=D,s.attributesNum=z,s.index=C}function y(){let I=s.newAttributes;for(let U=0,V=I.length;U<V;U++)I[U]=0}function g(I){p(I,0)}function p(I,U){let V=s.newAttributes,C=s.enabledAttributes,D=s.attributeDivisors;V[I]=1,C[I]===0&&(i.enableVertexAttribArray(I),C[I]=1),D[I]!==U&&(i.vertexAttribDivisor(I,U),D[I]=U)}function x(){let I=s.newAttributes,U=s.enabledAttributes;for(let V=0,C=U.length;V<C;V++)U[V]!==I[V]&&(i.disableVertexAttribArray(V),U[V]=0)}function _(I,U,V,C,D,G,z){z===!0?i.vertexAttribIPointer(I,U,V,D,G):i.vertexAttribPointer(I,U,V,C,D,G)}function v(I,U,V,C){y();let D=C.attributes,G=V.getAttributes(),z=U.defaultAttributeValues;for(let et in G){let $=G[et];if($.location>=0){let X=D[et];if(X===void 0&&(et==="instanceMatrix"&&I.instanceMatrix&&(X=I.instanceMatrix),et==="instanceColor"&&I.instanceColor&&(X=I.instanceColor)),X!==void 0){let tt=X.normalized,ht=X.itemSize,ct=t.get(X);if(ct===void 0)continue;let J=ct.buffer,dt=ct.type,gt=ct.bytesPerElement,bt=dt===i.INT||dt===i.UNSIGNED_INT||X.gpuType===Xu;if(X.isInterleavedBufferAttribute){let yt=X.data,Gt=yt.isInterleavedBuffer===!0?yt.stride:yt.itemSize,Kt=X.offset;if(yt.isInstancedInterleavedBuffer||yt.isInstancedBufferAttribute){for(let zt=0;zt<$.locationSize;zt++)p($.location+zt,yt.meshPerAttribute);I.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=yt.meshPerAttribute*yt.count)}else for(let zt=0;zt<$.locationSize;zt++)g($.location+zt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let zt=0;zt<$.locationSize;zt++)_($.location+zt,ht/$.locationSize,dt,tt,Gt*gt,(Kt+ht/$.locationSize*zt)*gt,bt)}else{if(X.isInstancedBufferAttribute){for(let yt=0;yt<$.locationSize;yt++)p($.location+yt,X.meshPerAttribute);I.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=X.meshPerAttribute*X.count)}else for(let yt=0;yt<$.locationSize;yt++)g($.location+yt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let yt=0;yt<$.locationSize;yt++)_($.location+yt,ht/$.locationSize,dt,tt,ht*gt,ht/$.locationSize*yt*gt,bt)}}else if(z!==void 0){let tt=z[et];if(tt!==void 0)switch(tt.length){case 2:i.vertexAttrib2fv($.location,tt);break;case 3:i.vertexAttrib3fv($.location,tt);break;case 4:i.vertexAttrib4fv($.location,tt);break;default:i.vertexAttrib1fv($.location,tt)}}}}x()}function M(){N();for(let I in n){let U=n[I];for(let V in U){let C=U[V];for(let D in C){let G=C[D];for(let z in G)u(G[z].object),delete G[z];delete C[D]}}delete n[I]}}function A(I){if(n[I.id]===void 0)return;let U=n[I.id];for(let V in U){let C=U[V];for(let D in C){let G=C[D];for(let z in G)u(G[z].object),delete G[z];delete C[D]}}delete n[I.id]}function b(I){for(let U in n){let V=n[U];for(let C in V){let D=V[C];if(D[I.id]===void 0)continue;let G=D[I.id];for(let z in G)u(G[z].object),delete G[z];delete D[I.id]}}}function w(I){for(let U in n){let V=n[U],C=I.isInstancedMesh===!0?I.id:0,D=V[C];if(D!==void 0){for(let G in D){let z=D[G];for(let et in z)u(z[et].object),delete z[et];delete D[G]}delete V[C],Object.keys(V).length===0&&delete n[U]}}}function N(){P(),o=!0,s!==r&&(s=r,c(s.object))}function P(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:N,resetDefaultState:P,dispose:M,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:b,initAttributes:y,enableAttribute:g,disableUnusedAttributes:x}}function wC(i,t,e){let n;function r(l){n=l}function s(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),e.update(c,n,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];e.update(f,n,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function MC(i,t,e,n){let r;function s(){if(r!==void 0)return r;if(t.has("EXT_texture_filter_anisotropic")===!0){let b=t.get("EXT_texture_filter_anisotropic");r=i.getParameter(b.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(b){return!(b!==sr&&n.convert(b)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(b){let w=b===rr&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(b!==di&&b!==ir&&!w&&n.convert(b)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(b){if(b==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";b="mediump"}return b==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(jt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),_=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),M=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:x,maxVaryings:_,maxFragmentUniforms:v,maxSamples:M,samples:A}}function SC(i){let t=this,e=null,n=0,r=!1,s=!1,o=new Ti,a=new se,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||r;return r=f,n=h.length,d},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){let m=h.clippingPlanes,y=h.clipIntersection,g=h.clipShadows,p=i.get(h);if(!r||m===null||m.length===0||s&&!g)s?u(null):c();else{let x=s?0:n,_=x*4,v=p.clippingState||null;l.value=v,v=u(m,f,_,d);for(let M=0;M!==_;++M)v[M]=e[M];p.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,d,m){let y=h!==null?h.length:0,g=null;if(y!==0){if(g=l.value,m!==!0||g===null){let p=d+y*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<p)&&(g=new Float32Array(p));for(let _=0,v=d;_!==y;++_,v+=4)o.copy(h[_]).applyMatrix4(x,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,g}}var kl=class extends Ri{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},r=[n,n,n,n,n,n];this.texture=new cl(r),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new ms(5,5,5),s=new zi({name:"CubemapFromEquirect",uniforms:eo(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ci,blending:Ks});s.uniforms.tEquirect.value=e;let o=new Ge(r,s),a=e.minFilter;return e.minFilter===qr&&(e.minFilter=ai),new aa(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,r=!0){let s=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,r);t.setRenderTarget(s)}},v_=256,AC=3,EC=20,G_=256,H_=16,TC=3,RC=new H,CC=new he,Lh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new aa(1,10,null),this._boxMesh=new Ge(new ms(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,r=100,s={}){let{size:o=256,position:a=RC}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(CC));let g=new aa(n,r,u);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=m,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=w_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=b_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(v_,jp(t))}_fromTexture(t,e){t.mapping===Qs||t.mapping===ua?this._setSize(t.image.length===0?v_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=__(t,!1,!1),n=Math.log2(t)-AC;for(let r=0;r<=n;r++)e.texture.mipmaps.push({width:t>>r,height:t>>r});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=__(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=t,s.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),s.update(this._renderer,r),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Qs||t.mapping===ua?(this._cubemapMaterial===null&&(this._cubemapMaterial=w_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=b_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=PC(),this._integrationMaterial=IC());let e=this._cubeSize,n=t.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(e/H_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-TC)s.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(G_*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=LC());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(t,0,n),r.envMap.value=t.texture,this._renderCube(s,0,n)}};function __(i,t,e){return new kl(i,{minFilter:qr,generateMipmaps:t,type:rr,colorSpace:Qa,depthBuffer:e})}function Bl(i,t,e){return new zi({name:i,uniforms:t,vertexShader:pe.cube_vert,fragmentShader:e,side:ci,blending:Ks,depthTest:!1,depthWrite:!1})}function PC(){return Bl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${G_}u

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
	`)}function IC(){return Bl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:H_}},`

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
	`)}function LC(){return Bl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${EC}
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
	`)}function b_(){return Bl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function w_(){return Bl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function FC(i){let t=new WeakMap,e=new WeakMap,n=null;function r(f,d=!1){return f==null?null:d?o(f):s(f)}function s(f){if(f&&f.isTexture){let d=f.mapping;if(d===Wu||d===qu)if(t.has(f)){let m=t.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let y=new kl(m.height);return y.fromEquirectangularTexture(i,f),t.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,m=d===Wu||d===qu,y=d===Qs||d===ua;if(m||y){let g=e.get(f),p=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return n===null&&(n=new Lh(i)),g=m?n.fromEquirectangular(f,g):n.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),g.texture;if(g!==void 0)return g.texture;{let x=f.image;return m&&x&&x.height>0||y&&x&&l(x)?(n===null&&(n=new Lh(i)),g=m?n.fromEquirectangular(f):n.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===Wu?f.mapping=Qs:d===qu&&(f.mapping=ua),f}function l(f){let d=0,m=6;for(let y=0;y<m;y++)f[y]!==void 0&&d++;return d===m}function c(f){let d=f.target;d.removeEventListener("dispose",c);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function h(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:h}}function NC(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let r=i.getExtension(n);return t[n]=r,r}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let r=e(n);return r===null&&ja("WebGLRenderer: "+n+" extension not supported."),r}}}function DC(i,t,e,n){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let y=s.get(m);y&&(t.remove(y),s.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,y){return r[y.id]!==void 0||(y.addEventListener("dispose",a),r[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(m){let y=m.attributes;for(let g in y)t.update(y[g],i.ARRAY_BUFFER)}function h(m){let y=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let x=y!==null?y.array.length:g.array.length/3-1,_=g.count>=65535?al:ol,v=new _(Math.ceil(x/3)*6,1),M=v.array;if(y!==null){let b=y.array;p=y.version;for(let w=0,N=0;w<x;w+=3){let P=b[w+0],I=b[w+1],U=b[w+2];M[N++]=P,M[N++]=I,M[N++]=I,M[N++]=U,M[N++]=U,M[N++]=P}}else{p=g.version;for(let b=0,w=0;b<x;b+=3){let N=b+0,P=b+1,I=b+2;M[w++]=N,M[w++]=P,M[w++]=P,M[w++]=I,M[w++]=I,M[w++]=N}}v.version=p;let A=s.get(m);A&&t.remove(A),s.set(m,v)}function f(m){let y=s.get(m);if(y){let g=m.index;g!==null&&y.version<g.version&&h(m)}else h(m);return s.get(m)}function d(){for(let m in r){let y=r[m].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function OC(i,t,e){let n;function r(h){n=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,f){i.drawElements(n,f,s,h*o),e.update(f,n,1)}function c(h,f,d){d!==0&&(i.drawElementsInstanced(n,f,s,h*o,d),e.update(f,n,d))}function u(h,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,s,h,0,d);let y=0;for(let g=0;g<d;g++)y+=f[g];e.update(y,n,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function UC(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(s/3);break;case i.LINES:e.lines+=a*(s/2);break;case i.LINE_STRIP:e.lines+=a*(s-1);break;case i.LINE_LOOP:e.lines+=a*s;break;case i.POINTS:e.points+=a*s;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function r(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:r,update:n}}function kC(i,t,e){let n=new WeakMap,r=new Le;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let N=function(){b.dispose(),n.delete(a),a.removeEventListener("dispose",N)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],_=0;d===!0&&(_=1),m===!0&&(_=2),y===!0&&(_=3);let v=a.attributes.position.count*_,M=1;v>t.maxTextureSize&&(M=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let A=new Float32Array(v*M*4*h),b=new il(A,v,M,h);b.type=ir,b.needsUpdate=!0;let w=_*4;for(let P=0;P<h;P++){let I=g[P],U=p[P],V=x[P],C=v*M*4*P;for(let D=0;D<I.count;D++){let G=D*w;d===!0&&(r.fromBufferAttribute(I,D),A[C+G+0]=r.x,A[C+G+1]=r.y,A[C+G+2]=r.z,A[C+G+3]=0),m===!0&&(r.fromBufferAttribute(U,D),A[C+G+4]=r.x,A[C+G+5]=r.y,A[C+G+6]=r.z,A[C+G+7]=0),y===!0&&(r.fromBufferAttribute(V,D),A[C+G+8]=r.x,A[C+G+9]=r.y,A[C+G+10]=r.z,A[C+G+11]=V.itemSize===4?r.w:1)}}f={count:h,texture:b,size:new Zt(v,M)},n.set(a,f),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:s}}function BC(i,t,e,n,r){let s=new WeakMap;function o(c){let u=r.render.frame,h=c.geometry,f=t.get(c,h);if(s.get(f)!==u&&(t.update(f),s.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;s.get(d)!==u&&(d.update(),s.set(d,u))}return f}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var zC={[Rp]:"LINEAR_TONE_MAPPING",[Cp]:"REINHARD_TONE_MAPPING",[Pp]:"CINEON_TONE_MAPPING",[Ip]:"ACES_FILMIC_TONE_MAPPING",[Fp]:"AGX_TONE_MAPPING",[Np]:"NEUTRAL_TONE_MAPPING",[Lp]:"CUSTOM_TONE_MAPPING"};function VC(i,t,e,n,r,s){let o=new Ri(t,e,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new on;u.setAttribute("position",new Xe([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Xe([0,2,0,0,2,0],2));let h=new Ru({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Ge(u,h),d=new bl(-1,1,1,-1,0,1),m=null,y=null,g=!1,p,x=null,_=[],v=!1;this.setSize=function(M,A){o.setSize(M,A),a!==null&&a.setSize(M,A),l!==null&&l.setSize(M,A);for(let b=0;b<_.length;b++){let w=_[b];w.setSize&&w.setSize(M,A)}},this.setEffects=function(M){_=M,v=_.length>0&&_[0].isRenderPass===!0;let A=o.width,b=o.height;_.length>0&&a===null&&(a=new Ri(A,b,{type:rr,depthBuffer:!1,stencilBuffer:!1}),l=new Ri(A,b,{type:rr,depthBuffer:!1,stencilBuffer:!1}));let w=r===!0&&_.some(N=>N.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Wr(A,b),s===!0&&(c.format=$r,c.type=to)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let N=0;N<_.length;N++){let P=_[N];P.setSize&&P.setSize(A,b),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(M,A){if(g||M.toneMapping===br&&_.length===0)return!1;if(x=A,A!==null){let b=A.width,w=A.height;(o.width!==b||o.height!==w)&&this.setSize(b,w)}return v===!1&&M.setRenderTarget(o),p=M.toneMapping,M.toneMapping=br,!0},this.hasRenderPass=function(){return v},this.end=function(M,A){M.toneMapping=p,g=!0;let b=o,w=a;for(let N=0;N<_.length;N++){let P=_[N];P.enabled!==!1&&(P.render(M,w,b,A),P.needsSwap!==!1&&(b=w,w=w===a?l:a))}if(m!==M.outputColorSpace||y!==M.toneMapping){m=M.outputColorSpace,y=M.toneMapping,h.defines={},be.getTransfer(m)===Ie&&(h.defines.SRGB_TRANSFER="");let N=zC[y];N&&(h.defines[N]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=b.texture,M.setRenderTarget(x),M.render(f,d),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var W_=new fi,q_=new Wr(1,1),$_=new ul(1),X_=new il,Y_=new wu,j_=new cl,M_=[],S_=[],A_=new Float32Array(16),E_=new Float32Array(9),T_=new Float32Array(4);function da(i,t,e){let n=i[0];if(n<=0||n>0)return i;let r=t*e,s=M_[r];if(s===void 0&&(s=new Float32Array(r),M_[r]=s),t!==0){n.toArray(s,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(s,a)}return s}function Cn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Pn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Nh(i,t){let e=S_[t];e===void 0&&(e=new Int32Array(t),S_[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function GC(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function HC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2fv(this.addr,t),Pn(e,t)}}function WC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Cn(e,t))return;i.uniform3fv(this.addr,t),Pn(e,t)}}function qC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4fv(this.addr,t),Pn(e,t)}}function $C(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Pn(e,t)}else{if(Cn(e,n))return;T_.set(n),i.uniformMatrix2fv(this.addr,!1,T_),Pn(e,n)}}function XC(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Pn(e,t)}else{if(Cn(e,n))return;E_.set(n),i.uniformMatrix3fv(this.addr,!1,E_),Pn(e,n)}}function YC(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Pn(e,t)}else{if(Cn(e,n))return;A_.set(n),i.uniformMatrix4fv(this.addr,!1,A_),Pn(e,n)}}function jC(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function ZC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2iv(this.addr,t),Pn(e,t)}}function KC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Cn(e,t))return;i.uniform3iv(this.addr,t),Pn(e,t)}}function JC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4iv(this.addr,t),Pn(e,t)}}function QC(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function t2(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2uiv(this.addr,t),Pn(e,t)}}function e2(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Cn(e,t))return;i.uniform3uiv(this.addr,t),Pn(e,t)}}function n2(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4uiv(this.addr,t),Pn(e,t)}}function Dh(i){return i.version===0&&(i.compareFunction=qp,i.needsUpdate=!0),i}function i2(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=Dh(q_):s=W_,e.setTexture2D(t||s,r)}function r2(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),e.setTexture3D(t||Y_,r)}function s2(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=Dh($_):s=j_,e.setTextureCube(t||s,r)}function o2(i,t,e){let n=this.cache,r=e.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),e.setTexture2DArray(t||X_,r)}function a2(i){switch(i){case 5126:return GC;case 35664:return HC;case 35665:return WC;case 35666:return qC;case 35674:return $C;case 35675:return XC;case 35676:return YC;case 5124:case 35670:return jC;case 35667:case 35671:return ZC;case 35668:case 35672:return KC;case 35669:case 35673:return JC;case 5125:return QC;case 36294:return t2;case 36295:return e2;case 36296:return n2;case 35678:case 36198:case 36298:case 36306:case 35682:return i2;case 35679:case 36299:case 36307:return r2;case 35680:case 36300:case 36308:case 36293:return s2;case 36289:case 36303:case 36311:case 36292:return o2}}function l2(i,t){i.uniform1fv(this.addr,t)}function c2(i,t){let e=da(t,this.size,2);i.uniform2fv(this.addr,e)}function u2(i,t){let e=da(t,this.size,3);i.uniform3fv(this.addr,e)}function h2(i,t){let e=da(t,this.size,4);i.uniform4fv(this.addr,e)}function f2(i,t){let e=da(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function d2(i,t){let e=da(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function p2(i,t){let e=da(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function m2(i,t){i.uniform1iv(this.addr,t)}function g2(i,t){i.uniform2iv(this.addr,t)}function y2(i,t){i.uniform3iv(this.addr,t)}function x2(i,t){i.uniform4iv(this.addr,t)}function v2(i,t){i.uniform1uiv(this.addr,t)}function _2(i,t){i.uniform2uiv(this.addr,t)}function b2(i,t){i.uniform3uiv(this.addr,t)}function w2(i,t){i.uniform4uiv(this.addr,t)}function M2(i,t,e){let n=this.cache,r=t.length,s=Nh(e,r);Cn(n,s)||(i.uniform1iv(this.addr,s),Pn(n,s));let o;this.type===i.SAMPLER_2D_SHADOW?o=Dh(q_):o=W_;for(let a=0;a!==r;++a)e.setTexture2D(t[a]||o,s[a])}function S2(i,t,e){let n=this.cache,r=t.length,s=Nh(e,r);Cn(n,s)||(i.uniform1iv(this.addr,s),Pn(n,s));for(let o=0;o!==r;++o)e.setTexture3D(t[o]||Y_,s[o])}function A2(i,t,e){let n=this.cache,r=t.length,s=Nh(e,r);Cn(n,s)||(i.uniform1iv(this.addr,s),Pn(n,s));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Dh($_):o=j_;for(let a=0;a!==r;++a)e.setTextureCube(t[a]||o,s[a])}function E2(i,t,e){let n=this.cache,r=t.length,s=Nh(e,r);Cn(n,s)||(i.uniform1iv(this.addr,s),Pn(n,s));for(let o=0;o!==r;++o)e.setTexture2DArray(t[o]||X_,s[o])}function T2(i){switch(i){case 5126:return l2;case 35664:return c2;case 35665:return u2;case 35666:return h2;case 35674:return f2;case 35675:return d2;case 35676:return p2;case 5124:case 35670:return m2;case 35667:case 35671:return g2;case 35668:case 35672:return y2;case 35669:case 35673:return x2;case 5125:return v2;case 36294:return _2;case 36295:return b2;case 36296:return w2;case 35678:case 36198:case 36298:case 36306:case 35682:return M2;case 35679:case 36299:case 36307:return S2;case 35680:case 36300:case 36308:case 36293:return A2;case 36289:case 36303:case 36311:case 36292:return E2}}var rm=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=a2(e.type)}},sm=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=T2(e.type)}},om=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(t,e[a.id],n)}}},nm=/(\w+)(\])?(\[|\.)?/g;function R_(i,t){i.seq.push(t),i.map[t.id]=t}function R2(i,t,e){let n=i.name,r=n.length;for(nm.lastIndex=0;;){let s=nm.exec(n),o=nm.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){R_(e,c===void 0?new rm(a,i,t):new sm(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new om(a),R_(e,h)),e=h}}}var fa=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);R2(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(t,e,n,r){let s=this.map[e];s!==void 0&&s.setValue(t,n,r)}setOptional(t,e,n){let r=e[n];r!==void 0&&this.setValue(t,n,r)}static upload(t,e,n,r){for(let s=0,o=e.length;s!==o;++s){let a=e[s],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,r)}}static seqWithValue(t,e){let n=[];for(let r=0,s=t.length;r!==s;++r){let o=t[r];o.id in e&&n.push(o)}return n}};function C_(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var C2=37297,P2=0;function I2(i,t){let e=i.split(`
`),n=[],r=Math.max(t-6,0),s=Math.min(t+6,e.length);for(let o=r;o<s;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var P_=new se;function L2(i){be._getMatrix(P_,be.workingColorSpace,i);let t=`mat3( ${P_.elements.map(e=>e.toFixed(4))} )`;switch(be.getTransfer(i)){case tl:return[t,"LinearTransferOETF"];case Ie:return[t,"sRGBTransferOETF"];default:return jt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function I_(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),s=(i.getShaderInfoLog(t)||"").trim();if(n&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+s+`

`+I2(i.getShaderSource(t),a)}else return s}function F2(i,t){let e=L2(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var N2={[Rp]:"Linear",[Cp]:"Reinhard",[Pp]:"Cineon",[Ip]:"ACESFilmic",[Fp]:"AgX",[Np]:"Neutral",[Lp]:"Custom"};function D2(i,t){let e=N2[t];return e===void 0?(jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Ih=new H;function O2(){be.getLuminanceCoefficients(Ih);let i=Ih.x.toFixed(4),t=Ih.y.toFixed(4),e=Ih.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function U2(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ul).join(`
`)}function k2(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function B2(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(t,r),o=s.name,a=1;s.type===i.FLOAT_MAT2&&(a=2),s.type===i.FLOAT_MAT3&&(a=3),s.type===i.FLOAT_MAT4&&(a=4),e[o]={type:s.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ul(i){return i!==""}function L_(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function F_(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var z2=/^[ \t]*#include +<([\w\d./]+)>/gm;function am(i){return i.replace(z2,V2)}function V2(i,t){let e=pe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return am(e)}var G2=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function N_(i){return i.replace(G2,H2)}function H2(i,t,e,n){let r="";for(let s=parseInt(t);s<parseInt(e);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function D_(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var W2={[Zs]:"SHADOWMAP_TYPE_PCF",[la]:"SHADOWMAP_TYPE_VSM"};function q2(i){return W2[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var $2={[ua]:"ENVMAP_MODE_REFRACTION"};function X2(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":$2[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Y2={[Hu]:"ENVMAP_BLENDING_MULTIPLY",[e_]:"ENVMAP_BLENDING_MIX",[n_]:"ENVMAP_BLENDING_ADD"};function j2(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Y2[i.combine]||"ENVMAP_BLENDING_NONE"}function Z2(i,t,e,n){let r=i.getContext(),s=e.defines,o=e.vertexShader,a=e.fragmentShader,l=q2(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=X2(e),h=j2(e),f=U2(e),d=k2(s),m=r.createProgram(),y,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ul).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ul).join(`
`),g.length>0&&(g+=`
`)):(y=[D_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ul).join(`
`),g=[D_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==br?"#define TONE_MAPPING":"",e.toneMapping!==br?pe.tonemapping_pars_fragment:"",e.toneMapping!==br?D2("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",pe.colorspace_pars_fragment,F2("linearToOutputTexel",e.outputColorSpace),O2(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ul).join(`
`)),o=am(o),o=L_(o,e),o=F_(o,e),a=am(a),a=L_(a,e),a=F_(a,e),o=N_(o),a=N_(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",e.glslVersion===Xp?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Xp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=p+y+o,_=p+g+a,v=C_(r,r.VERTEX_SHADER,x),M=C_(r,r.FRAGMENT_SHADER,_);r.attachShader(m,v),r.attachShader(m,M),e.index0AttributeName!==void 0?r.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function A(P){if(i.debug.checkShaderErrors){let I=r.getProgramInfoLog(m)||"",U=r.getShaderInfoLog(v)||"",V=r.getShaderInfoLog(M)||"",C=I.trim(),D=U.trim(),G=V.trim(),z=!0,et=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,m,v,M);else{let $=I_(r,v,"vertex"),X=I_(r,M,"fragment");re("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+C+`
`+$+`
`+X)}else C!==""?jt("WebGLProgram: Program Info Log:",C):(D===""||G==="")&&(et=!1);et&&(P.diagnostics={runnable:z,programLog:C,vertexShader:{log:D,prefix:y},fragmentShader:{log:G,prefix:g}})}r.deleteShader(v),r.deleteShader(M),b=new fa(r,m),w=B2(r,m)}let b;this.getUniforms=function(){return b===void 0&&A(this),b};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=r.getProgramParameter(m,C2)),N},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=P2++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=v,this.fragmentShader=M,this}var K2=0,lm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let r=this._getShaderCacheForMaterial(t);return r.has(e)===!1&&(r.add(e),e.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new cm(t),e.set(t,n)),n}},cm=class{constructor(t){this.id=K2++,this.code=t,this.usedTimes=0}};function J2(i){return i===Ss||i===Il||i===Ll}function Q2(i,t,e,n,r,s){let o=new rl,a=new lm,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(b){return l.add(b),b===0?"uv":`uv${b}`}function m(b,w,N,P,I,U){let V=P.fog,C=I.geometry,D=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?P.environment:null,G=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap,z=t.get(b.envMap||D,G),et=f[b.type],$=n.precision;b.precision!==null&&($=n.getMaxPrecision(b.precision),$!==b.precision&&jt("WebGLProgram.getParameters:",b.precision,"not supported, using",$,"instead."));let X=C.morphAttributes.position||C.morphAttributes.normal||C.morphAttributes.color,tt=X!==void 0?X.length:0,ht=0;C.morphAttributes.position!==void 0&&(ht=1),C.morphAttributes.normal!==void 0&&(ht=2),C.morphAttributes.color!==void 0&&(ht=3);let ct,J,dt,gt;if(et){let Ct=ui[et];ct=Ct.vertexShader,J=Ct.fragmentShader}else{ct=b.vertexShader,J=b.fragmentShader;let Ct=a.getVertexShaderStage(b),fe=a.getFragmentShaderStage(b);a.update(b,Ct,fe),dt=Ct.id,gt=fe.id}let bt=i.getRenderTarget(),yt=i.state.buffers.depth.getReversed(),Gt=I.isInstancedMesh===!0,Kt=I.isBatchedMesh===!0,zt=!!b.map,le=!!b.matcap,oe=!!z,Jt=oe&&z.isPMREMTexture===!0,Fe=!!b.aoMap,Ae=!!b.lightMap,hn=!!b.bumpMap&&b.wireframe===!1,Ft=!!b.normalMap,xe=!!b.displacementMap,te=!!b.emissiveMap,je=!!b.metalnessMap,Ze=!!b.roughnessMap,an=b.anisotropy>0,k=b.clearcoat>0,xt=b.diffuseRoughness>0,Xt=b.dispersion>0,ce=b.retroreflectivity>0,At=b.iridescence>0,He=b.sheen>0,Ht=b.transmission>0,Yt=an&&!!b.anisotropyMap,L=k&&!!b.clearcoatMap,E=k&&!!b.clearcoatNormalMap,Y=k&&!!b.clearcoatRoughnessMap,ft=xt&&!!b.diffuseRoughnessMap,at=At&&!!b.iridescenceMap,_t=At&&!!b.iridescenceThicknessMap,wt=He&&!!b.sheenColorMap,nt=He&&!!b.sheenRoughnessMap,st=!!b.specularMap,mt=!!b.specularColorMap,B=!!b.specularIntensityMap,ot=Ht&&!!b.transmissionMap,it=Ht&&!!b.thicknessMap,Et=!!b.gradientMap,vt=!!b.alphaMap,St=b.alphaTest>0,Wt=!!b.alphaHash,ee=!!b.extensions,ut=br;b.toneMapped&&(bt===null||bt.isXRRenderTarget===!0)&&(ut=i.toneMapping);let kt=Jt?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,ne={shaderID:et,shaderType:b.type,shaderName:b.name,vertexShader:ct,fragmentShader:J,defines:b.defines,customVertexShaderID:dt,customFragmentShaderID:gt,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:$,batching:Kt,batchingColor:Kt&&I._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&I.instanceColor!==null,instancingMorph:Gt&&I.morphTexture!==null,outputColorSpace:bt===null?i.outputColorSpace:bt.isXRRenderTarget===!0?bt.texture.colorSpace:be.workingColorSpace,alphaToCoverage:!!b.alphaToCoverage,map:zt,matcap:le,envMap:oe,envMapMode:oe&&z.mapping,envMapPMREM:Jt,envMapMaxLod:Jt?kt.length-1:null,envMapSize:Jt?kt[0].width:null,aoMap:Fe,lightMap:Ae,bumpMap:hn,normalMap:Ft,displacementMap:xe,emissiveMap:te,normalMapObjectSpace:Ft&&b.normalMapType===s_,normalMapTangentSpace:Ft&&b.normalMapType===Fl,packedNormalMap:Ft&&b.normalMapType===Fl&&J2(b.normalMap.format),metalnessMap:je,roughnessMap:Ze,anisotropy:an,anisotropyMap:Yt,clearcoat:k,clearcoatMap:L,clearcoatNormalMap:E,clearcoatRoughnessMap:Y,diffuseRoughness:xt,diffuseRoughnessMap:ft,dispersion:Xt,retroreflection:ce,iridescence:At,iridescenceMap:at,iridescenceThicknessMap:_t,sheen:He,sheenColorMap:wt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:mt,specularIntensityMap:B,transmission:Ht,transmissionMap:ot,thicknessMap:it,gradientMap:Et,opaque:b.transparent===!1&&b.blending===ca&&b.alphaToCoverage===!1,alphaMap:vt,alphaTest:St,alphaHash:Wt,combine:b.combine,mapUv:zt&&d(b.map.channel),aoMapUv:Fe&&d(b.aoMap.channel),lightMapUv:Ae&&d(b.lightMap.channel),bumpMapUv:hn&&d(b.bumpMap.channel),normalMapUv:Ft&&d(b.normalMap.channel),displacementMapUv:xe&&d(b.displacementMap.channel),emissiveMapUv:te&&d(b.emissiveMap.channel),metalnessMapUv:je&&d(b.metalnessMap.channel),roughnessMapUv:Ze&&d(b.roughnessMap.channel),anisotropyMapUv:Yt&&d(b.anisotropyMap.channel),clearcoatMapUv:L&&d(b.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&d(b.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&d(b.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(b.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&d(b.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&d(b.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(b.sheenRoughnessMap.channel),specularMapUv:st&&d(b.specularMap.channel),specularColorMapUv:mt&&d(b.specularColorMap.channel),specularIntensityMapUv:B&&d(b.specularIntensityMap.channel),transmissionMapUv:ot&&d(b.transmissionMap.channel),thicknessMapUv:it&&d(b.thicknessMap.channel),alphaMapUv:vt&&d(b.alphaMap.channel),vertexTangents:!!C.attributes.tangent&&(Ft||an),vertexNormals:!!C.attributes.normal,vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!C.attributes.color&&C.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!C.attributes.uv&&(zt||vt),fog:!!V,useFog:b.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:b.wireframe===!1&&(b.flatShading===!0||C.attributes.normal===void 0&&Ft===!1&&(b.isMeshLambertMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isMeshPhysicalMaterial)),sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:yt,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:C.attributes.position!==void 0,morphTargets:C.morphAttributes.position!==void 0,morphNormals:C.morphAttributes.normal!==void 0,morphColors:C.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:ht,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:U.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:ut,decodeVideoTexture:zt&&b.map.isVideoTexture===!0&&be.getTransfer(b.map.colorSpace)===Ie,decodeVideoTextureEmissive:te&&b.emissiveMap.isVideoTexture===!0&&be.getTransfer(b.emissiveMap.colorSpace)===Ie,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===Vi,flipSided:b.side===ci,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:ee&&b.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&b.extensions.multiDraw===!0||Kt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return ne.vertexUv1s=l.has(1),ne.vertexUv2s=l.has(2),ne.vertexUv3s=l.has(3),l.clear(),ne}function y(b){let w=[];if(b.shaderID?w.push(b.shaderID):(w.push(b.customVertexShaderID),w.push(b.customFragmentShaderID)),b.defines!==void 0)for(let N in b.defines)w.push(N),w.push(b.defines[N]);return b.isRawShaderMaterial===!1&&(g(w,b),p(w,b),w.push(i.outputColorSpace)),w.push(b.customProgramCacheKey),w.join()}function g(b,w){b.push(w.precision),b.push(w.outputColorSpace),b.push(w.envMapMode),b.push(w.envMapPMREM),b.push(w.envMapMaxLod),b.push(w.envMapSize),b.push(w.mapUv),b.push(w.alphaMapUv),b.push(w.lightMapUv),b.push(w.aoMapUv),b.push(w.bumpMapUv),b.push(w.normalMapUv),b.push(w.displacementMapUv),b.push(w.emissiveMapUv),b.push(w.metalnessMapUv),b.push(w.roughnessMapUv),b.push(w.anisotropyMapUv),b.push(w.clearcoatMapUv),b.push(w.clearcoatNormalMapUv),b.push(w.clearcoatRoughnessMapUv),b.push(w.diffuseRoughnessMapUv),b.push(w.iridescenceMapUv),b.push(w.iridescenceThicknessMapUv),b.push(w.sheenColorMapUv),b.push(w.sheenRoughnessMapUv),b.push(w.specularMapUv),b.push(w.specularColorMapUv),b.push(w.specularIntensityMapUv),b.push(w.transmissionMapUv),b.push(w.thicknessMapUv),b.push(w.combine),b.push(w.fogExp2),b.push(w.sizeAttenuation),b.push(w.morphTargetsCount),b.push(w.numSunLights),b.push(w.numDirLights),b.push(w.numPointLights),b.push(w.numSpotLights),b.push(w.numSpotLightMaps),b.push(w.numHemiLights),b.push(w.numRectAreaLights),b.push(w.numSunLightShadows),b.push(w.numDirLightShadows),b.push(w.numPointLightShadows),b.push(w.numSpotLightShadows),b.push(w.numSpotLightShadowsWithMaps),b.push(w.numLightProbes),b.push(w.numLightProbeGrids),b.push(w.shadowMapType),b.push(w.toneMapping),b.push(w.numClippingPlanes),b.push(w.numClipIntersection),b.push(w.depthPacking)}function p(b,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),b.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),b.push(o.mask)}function x(b){let w=f[b.type],N;if(w){let P=ui[w];N=Dl.clone(P.uniforms)}else N=b.uniforms;return N}function _(b,w){let N=u.get(w);return N!==void 0?++N.usedTimes:(N=new Z2(i,w,b,r),c.push(N),u.set(w,N)),N}function v(b){if(--b.usedTimes===0){let w=c.indexOf(b);c[w]=c[c.length-1],c.pop(),u.delete(b.cacheKey),b.destroy()}}function M(b){a.remove(b)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:x,acquireProgram:_,releaseProgram:v,releaseShaderCache:M,programs:c,dispose:A}}function tP(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function r(o,a,l){i.get(o)[a]=l}function s(){i=new WeakMap}return{has:t,get:e,remove:n,update:r,dispose:s}}function eP(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function O_(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function U_(){let i=[],t=0,e=[],n=[],r=[];function s(){t=0,e.length=0,n.length=0,r.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,m,y,g,p){let x=i[t];return x===void 0?(x={id:f.id,object:f,geometry:d,material:m,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:g,group:p},i[t]=x):(x.id=f.id,x.object=f,x.geometry=d,x.material=m,x.materialVariant=o(f),x.groupOrder=y,x.renderOrder=f.renderOrder,x.z=g,x.group=p),t++,x}function l(f,d,m,y,g,p,x){x.reversedDepth===!0&&(g=-g);let _=a(f,d,m,y,g,p);m.transmission>0?n.push(_):m.transparent===!0?r.push(_):e.push(_)}function c(f,d,m,y,g,p){let x=a(f,d,m,y,g,p);m.transmission>0?n.unshift(x):m.transparent===!0?r.unshift(x):e.unshift(x)}function u(f,d){e.length>1&&e.sort(f||eP),n.length>1&&n.sort(d||O_),r.length>1&&r.sort(d||O_)}function h(){for(let f=t,d=i.length;f<d;f++){let m=i[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:r,init:s,push:l,unshift:c,finish:h,sort:u}}function nP(){let i=new WeakMap;function t(n,r){let s=i.get(n),o;return s===void 0?(o=new U_,i.set(n,[o])):r>=s.length?(o=new U_,s.push(o)):o=s[r],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function iP(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new H,color:new he};break;case"SpotLight":e={position:new H,direction:new H,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new H,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new H,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new H,halfWidth:new H,halfHeight:new H};break}return i[t.id]=e,e}}}function rP(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var sP=0;function oP(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function aP(i){let t=new iP,e=rP(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new H);let r=new H,s=new $e,o=new $e;function a(c){let u=0,h=0,f=0;for(let U=0;U<9;U++)n.probe[U].set(0,0,0);let d=0,m=0,y=0,g=0,p=0,x=0,_=0,v=0,M=0,A=0,b=0,w=0,N=0,P=0;c.sort(oP);for(let U=0,V=c.length;U<V;U++){let C=c[U],D=C.color,G=C.intensity,z=C.distance,et=null;if(C.shadow&&C.shadow.map&&(C.shadow.map.texture.format===Ss?et=C.shadow.map.texture:et=C.shadow.map.depthTexture||C.shadow.map.texture),C.isAmbientLight)u+=D.r*G,h+=D.g*G,f+=D.b*G;else if(C.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(C.sh.coefficients[$],G);P++}else if(C.isSunLight){let $=t.get(C);if($.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let X=C.shadow,tt=e.get(C);tt.shadowIntensity=X.intensity,tt.shadowBias=X.bias,tt.shadowNormalBias=X.normalBias,tt.shadowRadius=X.radius,tt.shadowMapSize.copy(X.mapSize).multiply(X.getFrameExtents()),n.sunShadow[m]=tt,n.sunShadowMap[m]=et;let ht=X.getViewportCount();for(let ct=0;ct<ht;ct++)n.sunShadowMatrix[y+ct]=X.getMatrix(ct),n.sunShadowCascade[y+ct]=X._cascadeData[ct];y+=ht,m++}n.sun[d]=$,d++}else if(C.isDirectionalLight){let $=t.get(C);if($.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let X=C.shadow,tt=e.get(C);tt.shadowIntensity=X.intensity,tt.shadowBias=X.bias,tt.shadowNormalBias=X.normalBias,tt.shadowRadius=X.radius,tt.shadowMapSize=X.mapSize,n.directionalShadow[g]=tt,n.directionalShadowMap[g]=et,n.directionalShadowMatrix[g]=C.shadow.matrix,M++}n.directional[g]=$,g++}else if(C.isSpotLight){let $=t.get(C);$.position.setFromMatrixPosition(C.matrixWorld),$.color.copy(D).multiplyScalar(G),$.distance=z,$.coneCos=Math.cos(C.angle),$.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),$.decay=C.decay,n.spot[x]=$;let X=C.shadow;if(C.map&&(n.spotLightMap[w]=C.map,w++,X.updateMatrices(C),C.castShadow&&N++),n.spotLightMatrix[x]=X.matrix,C.castShadow){let tt=e.get(C);tt.shadowIntensity=X.intensity,tt.shadowBias=X.bias,tt.shadowNormalBias=X.normalBias,tt.shadowRadius=X.radius,tt.shadowMapSize=X.mapSize,n.spotShadow[x]=tt,n.spotShadowMap[x]=et,b++}x++}else if(C.isRectAreaLight){let $=t.get(C);$.color.copy(D).multiplyScalar(G),$.halfWidth.set(C.width*.5,0,0),$.halfHeight.set(0,C.height*.5,0),n.rectArea[_]=$,_++}else if(C.isPointLight){let $=t.get(C);if($.color.copy(C.color).multiplyScalar(C.intensity),$.distance=C.distance,$.decay=C.decay,C.castShadow){let X=C.shadow,tt=e.get(C);tt.shadowIntensity=X.intensity,tt.shadowBias=X.bias,tt.shadowNormalBias=X.normalBias,tt.shadowRadius=X.radius,tt.shadowMapSize=X.mapSize,tt.shadowCameraNear=X.camera.near,tt.shadowCameraFar=X.camera.far,n.pointShadow[p]=tt,n.pointShadowMap[p]=et,n.pointShadowMatrix[p]=C.shadow.matrix,A++}n.point[p]=$,p++}else if(C.isHemisphereLight){let $=t.get(C);$.skyColor.copy(C.color).multiplyScalar(G),$.groundColor.copy(C.groundColor).multiplyScalar(G),n.hemi[v]=$,v++}}_>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Pt.LTC_FLOAT_1,n.rectAreaLTC2=Pt.LTC_FLOAT_2):(n.rectAreaLTC1=Pt.LTC_HALF_1,n.rectAreaLTC2=Pt.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let I=n.hash;(I.sunLength!==d||I.directionalLength!==g||I.pointLength!==p||I.spotLength!==x||I.rectAreaLength!==_||I.hemiLength!==v||I.numSunShadows!==m||I.numDirectionalShadows!==M||I.numPointShadows!==A||I.numSpotShadows!==b||I.numSpotMaps!==w||I.numLightProbes!==P)&&(n.sun.length=d,n.directional.length=g,n.spot.length=x,n.rectArea.length=_,n.point.length=p,n.hemi.length=v,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.directionalShadowMatrix.length=M,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=b,n.spotShadowMap.length=b,n.spotLightMatrix.length=b+w-N,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=P,I.sunLength=d,I.directionalLength=g,I.pointLength=p,I.spotLength=x,I.rectAreaLength=_,I.hemiLength=v,I.numSunShadows=m,I.numDirectionalShadows=M,I.numPointShadows=A,I.numSpotShadows=b,I.numSpotMaps=w,I.numLightProbes=P,n.version=sP++)}function l(c,u){let h=0,f=0,d=0,m=0,y=0,g=0,p=u.matrixWorldInverse;for(let x=0,_=c.length;x<_;x++){let v=c[x];if(v.isSunLight){let M=n.sun[h];M.direction.setFromMatrixPosition(v.matrixWorld),M.direction.transformDirection(p),h++}else if(v.isDirectionalLight){let M=n.directional[f];M.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),M.direction.sub(r),M.direction.transformDirection(p),f++}else if(v.isSpotLight){let M=n.spot[m];M.position.setFromMatrixPosition(v.matrixWorld),M.position.applyMatrix4(p),M.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),M.direction.sub(r),M.direction.transformDirection(p),m++}else if(v.isRectAreaLight){let M=n.rectArea[y];M.position.setFromMatrixPosition(v.matrixWorld),M.position.applyMatrix4(p),o.identity(),s.copy(v.matrixWorld),s.premultiply(p),o.extractRotation(s),M.halfWidth.set(v.width*.5,0,0),M.halfHeight.set(0,v.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let M=n.point[d];M.position.setFromMatrixPosition(v.matrixWorld),M.position.applyMatrix4(p),d++}else if(v.isHemisphereLight){let M=n.hemi[g];M.direction.setFromMatrixPosition(v.matrixWorld),M.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:n}}function k_(i){let t=new aP(i),e=[],n=[],r=[];function s(h){u.camera=h,e.length=0,n.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):e.push(h)}function a(h){n.push(h)}function l(){t.setup(e),r.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function lP(i){let t=new WeakMap;function e(r,s=0){let o=t.get(r),a;return o===void 0?(a=new k_(i),t.set(r,[a])):s>=o.length?(a=new k_(i),o.push(a)):a=o[s],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var cP=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,uP=`uniform sampler2D shadow_pass;
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
}`,hP=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],fP=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],B_=new $e,Ol=new H,im=new H;function dP(i,t,e){let n=new ps,r=new Zt,s=new Zt,o=new Le,a=new Cu,l=new Pu,c={},u=e.maxTextureSize,h={[Ms]:ci,[ci]:Ms,[Vi]:Vi},f=new zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:cP,fragmentShader:uP}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new on;m.setAttribute("position",new Ye(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Ge(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Zs;let p=this.type;this.render=function(A,b,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Ov&&(jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Zs);let N=i.getRenderTarget(),P=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),U=i.state;U.setBlending(Ks),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let V=p!==this.type;V&&b.traverse(function(C){C.material&&(Array.isArray(C.material)?C.material.forEach(D=>D.needsUpdate=!0):C.material.needsUpdate=!0)});for(let C=0,D=A.length;C<D;C++){let G=A[C],z=G.shadow;if(z===void 0){jt("WebGLShadowMap:",G,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;r.copy(z.mapSize);let et=z.getFrameExtents();r.multiply(et),s.copy(z.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/et.x),r.x=s.x*et.x,z.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/et.y),r.y=s.y*et.y,z.mapSize.y=s.y));let $=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=$,z.map===null||V===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===la){if(G.isPointLight){jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new Ri(r.x,r.y,{format:Ss,type:rr,minFilter:ai,magFilter:ai,generateMipmaps:!1}),z.map.texture.name=G.name+".shadowMap",z.map.depthTexture=new Wr(r.x,r.y,ir),z.map.depthTexture.name=G.name+".shadowMapDepth",z.map.depthTexture.format=Hr,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Bn,z.map.depthTexture.magFilter=Bn}else G.isPointLight?(z.map=new kl(r.x),z.map.depthTexture=new ul(r.x,nr)):(z.map=new Ri(r.x,r.y),z.map.depthTexture=new Wr(r.x,r.y,nr)),z.map.depthTexture.name=G.name+".shadowMap",z.map.depthTexture.format=Hr,this.type===Zs?(z.map.depthTexture.compareFunction=$?Wp:Hp,z.map.depthTexture.minFilter=ai,z.map.depthTexture.magFilter=ai):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Bn,z.map.depthTexture.magFilter=Bn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==r.x||z.map.height!==r.y)&&z.map.setSize(r.x,r.y);let X=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();G.isPointLight!==!0&&z.updateMatrices(G,w);let tt=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:w.layers;for(let ht=0;ht<X;ht++){let ct=z.getCamera(ht);if(G.isPointLight){let J=z.camera,dt=z.matrix,gt=G.distance||J.far;gt!==J.far&&(J.far=gt,J.updateProjectionMatrix()),Ol.setFromMatrixPosition(G.matrixWorld),J.position.copy(Ol),im.copy(J.position),im.add(hP[ht]),J.up.copy(fP[ht]),J.lookAt(im),J.updateMatrixWorld(),dt.makeTranslation(-Ol.x,-Ol.y,-Ol.z),B_.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),z._frustum.setFromProjectionMatrix(B_,J.coordinateSystem,J.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,ht),i.clear();else{ht===0&&(i.setRenderTarget(z.map),i.clear());let J=z.getViewport(ht);o.set(s.x*J.x,s.y*J.y,s.x*J.z,s.y*J.w),U.viewport(o)}n=z.getFrustum(ht),v(b,w,ct,G,tt,this.type)}z.isPointLightShadow!==!0&&this.type===la&&x(z,w),z.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(N,P,I)};function x(A,b){let w=t.update(y);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new Ri(r.x,r.y,{format:Ss,type:rr}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(b,null,w,f,y,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(b,null,w,d,y,null)}function _(A,b,w,N){let P=null,I=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)P=I;else if(P=w.isPointLight===!0?l:a,i.localClippingEnabled&&b.clipShadows===!0&&Array.isArray(b.clippingPlanes)&&b.clippingPlanes.length!==0||b.displacementMap&&b.displacementScale!==0||b.alphaMap&&b.alphaTest>0||b.map&&b.alphaTest>0||b.alphaToCoverage===!0){let U=P.uuid,V=b.uuid,C=c[U];C===void 0&&(C={},c[U]=C);let D=C[V];D===void 0&&(D=P.clone(),C[V]=D,b.addEventListener("dispose",M)),P=D}if(P.visible=b.visible,P.wireframe=b.wireframe,N===la?P.side=b.shadowSide!==null?b.shadowSide:b.side:P.side=b.shadowSide!==null?b.shadowSide:h[b.side],P.alphaMap=b.alphaMap,P.alphaTest=b.alphaToCoverage===!0?.5:b.alphaTest,P.map=b.map,P.clipShadows=b.clipShadows,P.clippingPlanes=b.clippingPlanes,P.clipIntersection=b.clipIntersection,P.displacementMap=b.displacementMap,P.displacementScale=b.displacementScale,P.displacementBias=b.displacementBias,P.wireframeLinewidth=b.wireframeLinewidth,P.linewidth=b.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let U=i.properties.get(P);U.light=w}return P}function v(A,b,w,N,P,I){if(A.visible===!1)return;if(A.layers.test(P)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===la)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let C=t.update(A),D=A.material;if(Array.isArray(D)){let G=C.groups;for(let z=0,et=G.length;z<et;z++){let $=G[z],X=D[$.materialIndex];if(X&&X.visible){let tt=_(A,X,N,I);A.onBeforeShadow(i,A,b,w,C,tt,$),i.renderBufferDirect(w,null,C,tt,A,$),A.onAfterShadow(i,A,b,w,C,tt,$)}}}else if(D.visible){let G=_(A,D,N,I);A.onBeforeShadow(i,A,b,w,C,G,null),i.renderBufferDirect(w,null,C,G,A,null),A.onAfterShadow(i,A,b,w,C,G,null)}}let V=A.children;for(let C=0,D=V.length;C<D;C++)v(V[C],b,w,N,P,I)}function M(A){A.target.removeEventListener("dispose",M);for(let w in c){let N=c[w],P=A.target.uuid;P in N&&(N[P].dispose(),delete N[P])}}}function pP(i,t){function e(){let B=!1,ot=new Le,it=null,Et=new Le(0,0,0,0);return{setMask:function(vt){it!==vt&&!B&&(i.colorMask(vt,vt,vt,vt),it=vt)},setLocked:function(vt){B=vt},setClear:function(vt,St,Wt,ee,ut){ut===!0&&(vt*=ee,St*=ee,Wt*=ee),ot.set(vt,St,Wt,ee),Et.equals(ot)===!1&&(i.clearColor(vt,St,Wt,ee),Et.copy(ot))},reset:function(){B=!1,it=null,Et.set(-1,0,0,0)}}}function n(){let B=!1,ot=!1,it=null,Et=null,vt=null;return{setReversed:function(St){if(ot!==St){let Wt=t.get("EXT_clip_control");St?Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.ZERO_TO_ONE_EXT):Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.NEGATIVE_ONE_TO_ONE_EXT),ot=St;let ee=vt;vt=null,this.setClear(ee)}},getReversed:function(){return ot},setTest:function(St){St?yt(i.DEPTH_TEST):Gt(i.DEPTH_TEST)},setMask:function(St){it!==St&&!B&&(i.depthMask(St),it=St)},setFunc:function(St){if(ot&&(St=m_[St]),Et!==St){switch(St){case uu:i.depthFunc(i.NEVER);break;case hu:i.depthFunc(i.ALWAYS);break;case fu:i.depthFunc(i.LESS);break;case Ko:i.depthFunc(i.LEQUAL);break;case du:i.depthFunc(i.EQUAL);break;case pu:i.depthFunc(i.GEQUAL);break;case mu:i.depthFunc(i.GREATER);break;case gu:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Et=St}},setLocked:function(St){B=St},setClear:function(St){vt!==St&&(vt=St,ot&&(St=1-St),i.clearDepth(St))},reset:function(){B=!1,it=null,Et=null,vt=null,ot=!1}}}function r(){let B=!1,ot=null,it=null,Et=null,vt=null,St=null,Wt=null,ee=null,ut=null;return{setTest:function(kt){B||(kt?yt(i.STENCIL_TEST):Gt(i.STENCIL_TEST))},setMask:function(kt){ot!==kt&&!B&&(i.stencilMask(kt),ot=kt)},setFunc:function(kt,ne,Ct){(it!==kt||Et!==ne||vt!==Ct)&&(i.stencilFunc(kt,ne,Ct),it=kt,Et=ne,vt=Ct)},setOp:function(kt,ne,Ct){(St!==kt||Wt!==ne||ee!==Ct)&&(i.stencilOp(kt,ne,Ct),St=kt,Wt=ne,ee=Ct)},setLocked:function(kt){B=kt},setClear:function(kt){ut!==kt&&(i.clearStencil(kt),ut=kt)},reset:function(){B=!1,ot=null,it=null,Et=null,vt=null,St=null,Wt=null,ee=null,ut=null}}}let s=new e,o=new n,a=new r,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,m=[],y=null,g=!1,p=null,x=null,_=null,v=null,M=null,A=null,b=null,w=new he(0,0,0),N=0,P=!1,I=null,U=null,V=null,C=null,D=null,G=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,et=0,$=i.getParameter(i.VERSION);$.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec($)[1]),z=et>=1):$.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),z=et>=2);let X=null,tt={},ht=i.getParameter(i.SCISSOR_BOX),ct=i.getParameter(i.VIEWPORT),J=new Le().fromArray(ht),dt=new Le().fromArray(ct);function gt(B,ot,it,Et){let vt=new Uint8Array(4),St=i.createTexture();i.bindTexture(B,St),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Wt=0;Wt<it;Wt++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(ot,0,i.RGBA,1,1,Et,0,i.RGBA,i.UNSIGNED_BYTE,vt):i.texImage2D(ot+Wt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,vt);return St}let bt={};bt[i.TEXTURE_2D]=gt(i.TEXTURE_2D,i.TEXTURE_2D,1),bt[i.TEXTURE_CUBE_MAP]=gt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),bt[i.TEXTURE_2D_ARRAY]=gt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),bt[i.TEXTURE_3D]=gt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),yt(i.DEPTH_TEST),o.setFunc(Ko),hn(!1),Ft(wp),yt(i.CULL_FACE),Fe(Ks);function yt(B){u[B]!==!0&&(i.enable(B),u[B]=!0)}function Gt(B){u[B]!==!1&&(i.disable(B),u[B]=!1)}function Kt(B,ot){return f[B]!==ot?(i.bindFramebuffer(B,ot),f[B]=ot,B===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ot),B===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ot),!0):!1}function zt(B,ot){let it=m,Et=!1;if(B){it=d.get(ot),it===void 0&&(it=[],d.set(ot,it));let vt=B.textures;if(it.length!==vt.length||it[0]!==i.COLOR_ATTACHMENT0){for(let St=0,Wt=vt.length;St<Wt;St++)it[St]=i.COLOR_ATTACHMENT0+St;it.length=vt.length,Et=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,Et=!0);Et&&i.drawBuffers(it)}function le(B){return y!==B?(i.useProgram(B),y=B,!0):!1}let oe={[Js]:i.FUNC_ADD,[kv]:i.FUNC_SUBTRACT,[Bv]:i.FUNC_REVERSE_SUBTRACT};oe[zv]=i.MIN,oe[Vv]=i.MAX;let Jt={[Gv]:i.ZERO,[Hv]:i.ONE,[Wv]:i.SRC_COLOR,[Ep]:i.SRC_ALPHA,[Zv]:i.SRC_ALPHA_SATURATE,[Yv]:i.DST_COLOR,[$v]:i.DST_ALPHA,[qv]:i.ONE_MINUS_SRC_COLOR,[Tp]:i.ONE_MINUS_SRC_ALPHA,[jv]:i.ONE_MINUS_DST_COLOR,[Xv]:i.ONE_MINUS_DST_ALPHA,[Kv]:i.CONSTANT_COLOR,[Jv]:i.ONE_MINUS_CONSTANT_COLOR,[Qv]:i.CONSTANT_ALPHA,[t_]:i.ONE_MINUS_CONSTANT_ALPHA};function Fe(B,ot,it,Et,vt,St,Wt,ee,ut,kt){if(B===Ks){g===!0&&(Gt(i.BLEND),g=!1);return}if(g===!1&&(yt(i.BLEND),g=!0),B!==Uv){if(B!==p||kt!==P){if((x!==Js||M!==Js)&&(i.blendEquation(i.FUNC_ADD),x=Js,M=Js),kt)switch(B){case ca:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Mp:i.blendFunc(i.ONE,i.ONE);break;case Sp:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Ap:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:re("WebGLState: Invalid blending: ",B);break}else switch(B){case ca:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Mp:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Sp:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ap:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",B);break}_=null,v=null,A=null,b=null,w.set(0,0,0),N=0,p=B,P=kt}return}vt=vt||ot,St=St||it,Wt=Wt||Et,(ot!==x||vt!==M)&&(i.blendEquationSeparate(oe[ot],oe[vt]),x=ot,M=vt),(it!==_||Et!==v||St!==A||Wt!==b)&&(i.blendFuncSeparate(Jt[it],Jt[Et],Jt[St],Jt[Wt]),_=it,v=Et,A=St,b=Wt),(ee.equals(w)===!1||ut!==N)&&(i.blendColor(ee.r,ee.g,ee.b,ut),w.copy(ee),N=ut),p=B,P=!1}function Ae(B,ot){B.side===Vi?Gt(i.CULL_FACE):yt(i.CULL_FACE);let it=B.side===ci;ot&&(it=!it),hn(it),B.blending===ca&&B.transparent===!1?Fe(Ks):Fe(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),s.setMask(B.colorWrite);let Et=B.stencilWrite;a.setTest(Et),Et&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),te(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?yt(i.SAMPLE_ALPHA_TO_COVERAGE):Gt(i.SAMPLE_ALPHA_TO_COVERAGE)}function hn(B){I!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),I=B)}function Ft(B){B!==Nv?(yt(i.CULL_FACE),B!==U&&(B===wp?i.cullFace(i.BACK):B===Dv?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Gt(i.CULL_FACE),U=B}function xe(B){B!==V&&(z&&i.lineWidth(B),V=B)}function te(B,ot,it){B?(yt(i.POLYGON_OFFSET_FILL),(C!==ot||D!==it)&&(C=ot,D=it,o.getReversed()&&(ot=-ot,it=-it),i.polygonOffset(ot,it))):Gt(i.POLYGON_OFFSET_FILL)}function je(B){B?yt(i.SCISSOR_TEST):Gt(i.SCISSOR_TEST)}function Ze(B){B===void 0&&(B=i.TEXTURE0+G-1),X!==B&&(i.activeTexture(B),X=B)}function an(B,ot,it){it===void 0&&(X===null?it=i.TEXTURE0+G-1:it=X);let Et=tt[it];Et===void 0&&(Et={type:void 0,texture:void 0},tt[it]=Et),(Et.type!==B||Et.texture!==ot)&&(X!==it&&(i.activeTexture(it),X=it),i.bindTexture(B,ot||bt[B]),Et.type=B,Et.texture=ot)}function k(){let B=tt[X];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function xt(){try{i.compressedTexImage2D(...arguments)}catch(B){re("WebGLState:",B)}}function Xt(){try{i.compressedTexImage3D(...arguments)}catch(B){re("WebGLState:",B)}}function ce(){try{i.texSubImage2D(...arguments)}catch(B){re("WebGLState:",B)}}function At(){try{i.texSubImage3D(...arguments)}catch(B){re("WebGLState:",B)}}function He(){try{i.compressedTexSubImage2D(...arguments)}catch(B){re("WebGLState:",B)}}function Ht(){try{i.compressedTexSubImage3D(...arguments)}catch(B){re("WebGLState:",B)}}function Yt(){try{i.texStorage2D(...arguments)}catch(B){re("WebGLState:",B)}}function L(){try{i.texStorage3D(...arguments)}catch(B){re("WebGLState:",B)}}function E(){try{i.texImage2D(...arguments)}catch(B){re("WebGLState:",B)}}function Y(){try{i.texImage3D(...arguments)}catch(B){re("WebGLState:",B)}}function ft(B){return h[B]!==void 0?h[B]:i.getParameter(B)}function at(B,ot){h[B]!==ot&&(i.pixelStorei(B,ot),h[B]=ot)}function _t(B){J.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),J.copy(B))}function wt(B){dt.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),dt.copy(B))}function nt(B,ot){let it=c.get(ot);it===void 0&&(it=new WeakMap,c.set(ot,it));let Et=it.get(B);Et===void 0&&(Et=i.getUniformBlockIndex(ot,B.name),i.uniformBlockBinding(ot,Et,Et),it.set(B,Et))}function st(B,ot,it){let vt=c.get(ot).get(B);l[vt]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,vt,it),l[vt]=it)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},X=null,tt={},f={},l={},d=new WeakMap,m=[],y=null,g=!1,p=null,x=null,_=null,v=null,M=null,A=null,b=null,w=new he(0,0,0),N=0,P=!1,I=null,U=null,V=null,C=null,D=null,J.set(0,0,i.canvas.width,i.canvas.height),dt.set(0,0,i.canvas.width,i.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:yt,disable:Gt,bindFramebuffer:Kt,drawBuffers:zt,useProgram:le,setBlending:Fe,setMaterial:Ae,setFlipSided:hn,setCullFace:Ft,setLineWidth:xe,setPolygonOffset:te,setScissorTest:je,activeTexture:Ze,bindTexture:an,unbindTexture:k,compressedTexImage2D:xt,compressedTexImage3D:Xt,texImage2D:E,texImage3D:Y,pixelStorei:at,getParameter:ft,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Yt,texStorage3D:L,texSubImage2D:ce,texSubImage3D:At,compressedTexSubImage2D:He,compressedTexSubImage3D:Ht,scissor:_t,viewport:wt,reset:mt}}function mP(i,t,e,n,r,s,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,u=new WeakMap,h=new Set,f,d=new WeakMap,m=new Set,y=new FinalizationRegistry(L=>m.delete(L)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(L,E){return g?new OffscreenCanvas(L,E):el("canvas")}function x(L,E,Y){let ft=1,at=Yt(L);if((at.width>Y||at.height>Y)&&(ft=Y/Math.max(at.width,at.height)),ft<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let _t=Math.floor(ft*at.width),wt=Math.floor(ft*at.height);f===void 0&&(f=p(_t,wt));let nt=E?p(_t,wt):f;return nt.width=_t,nt.height=wt,nt.getContext("2d").drawImage(L,0,0,_t,wt),jt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+_t+"x"+wt+")."),nt}else return"data"in L&&jt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),L;return L}function _(L){return L.generateMipmaps}function v(L){i.generateMipmap(L)}function M(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(L,E,Y,ft,at,_t=!1){if(L!==null){if(i[L]!==void 0)return i[L];jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let wt;ft&&(wt=t.get("EXT_texture_norm16"),wt||jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=E;if(E===i.RED&&(Y===i.FLOAT&&(nt=i.R32F),Y===i.HALF_FLOAT&&(nt=i.R16F),Y===i.UNSIGNED_BYTE&&(nt=i.R8),Y===i.UNSIGNED_SHORT&&wt&&(nt=wt.R16_EXT),Y===i.SHORT&&wt&&(nt=wt.R16_SNORM_EXT)),E===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.R8UI),Y===i.UNSIGNED_SHORT&&(nt=i.R16UI),Y===i.UNSIGNED_INT&&(nt=i.R32UI),Y===i.BYTE&&(nt=i.R8I),Y===i.SHORT&&(nt=i.R16I),Y===i.INT&&(nt=i.R32I)),E===i.RG&&(Y===i.FLOAT&&(nt=i.RG32F),Y===i.HALF_FLOAT&&(nt=i.RG16F),Y===i.UNSIGNED_BYTE&&(nt=i.RG8),Y===i.UNSIGNED_SHORT&&wt&&(nt=wt.RG16_EXT),Y===i.SHORT&&wt&&(nt=wt.RG16_SNORM_EXT)),E===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RG8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RG16UI),Y===i.UNSIGNED_INT&&(nt=i.RG32UI),Y===i.BYTE&&(nt=i.RG8I),Y===i.SHORT&&(nt=i.RG16I),Y===i.INT&&(nt=i.RG32I)),E===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),Y===i.UNSIGNED_INT&&(nt=i.RGB32UI),Y===i.BYTE&&(nt=i.RGB8I),Y===i.SHORT&&(nt=i.RGB16I),Y===i.INT&&(nt=i.RGB32I)),E===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),Y===i.UNSIGNED_INT&&(nt=i.RGBA32UI),Y===i.BYTE&&(nt=i.RGBA8I),Y===i.SHORT&&(nt=i.RGBA16I),Y===i.INT&&(nt=i.RGBA32I)),E===i.RGB&&(Y===i.UNSIGNED_SHORT&&wt&&(nt=wt.RGB16_EXT),Y===i.SHORT&&wt&&(nt=wt.RGB16_SNORM_EXT),Y===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),Y===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),E===i.RGBA){let st=_t?tl:be.getTransfer(at);Y===i.FLOAT&&(nt=i.RGBA32F),Y===i.HALF_FLOAT&&(nt=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(nt=st===Ie?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT&&wt&&(nt=wt.RGBA16_EXT),Y===i.SHORT&&wt&&(nt=wt.RGBA16_SNORM_EXT),Y===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function b(L,E){let Y;return L?E===null||E===nr||E===to?Y=i.DEPTH24_STENCIL8:E===ir?Y=i.DEPTH32F_STENCIL8:E===ha&&(Y=i.DEPTH24_STENCIL8,jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===nr||E===to?Y=i.DEPTH_COMPONENT24:E===ir?Y=i.DEPTH_COMPONENT32F:E===ha&&(Y=i.DEPTH_COMPONENT16),Y}function w(L,E){return _(L)===!0||L.isFramebufferTexture&&L.minFilter!==Bn&&L.minFilter!==ai?Math.log2(Math.max(E.width,E.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?E.mipmaps.length:1}function N(L){let E=new WeakRef(L);n.get(L).__ref=E,m.add(E),y.register(L,E,E)}function P(L){let E=n.get(L).__ref;E!==void 0&&(m.delete(E),y.unregister(E))}function I(L){V(L.target)}function U(L){C(L.target)}function V(L){L.removeEventListener("dispose",I),P(L),G(L),L.isVideoTexture&&u.delete(L),L.isHTMLTexture&&h.delete(L)}function C(L){L.removeEventListener("dispose",U),P(L),et(L)}function D(){for(let L of m){let E=L.deref();E!==void 0&&(E.isRenderTarget===!0?C(E):V(E))}m.clear(),h.clear()}function G(L){let E=n.get(L);if(E.__webglInit===void 0)return;let Y=L.source,ft=d.get(Y);if(ft){let at=ft[E.__cacheKey];at.usedTimes--,at.usedTimes===0&&z(L),Object.keys(ft).length===0&&d.delete(Y)}n.remove(L)}function z(L){let E=n.get(L);i.deleteTexture(E.__webglTexture);let Y=L.source,ft=d.get(Y);delete ft[E.__cacheKey],o.memory.textures--}function et(L){let E=n.get(L);E.__depthDisposeCallback&&E.__depthDisposeCallback();let Y=L.depthTexture;if(Y&&Y.renderTarget===L&&V(Y),L.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(E.__webglFramebuffer[at]))for(let _t=0;_t<E.__webglFramebuffer[at].length;_t++)i.deleteFramebuffer(E.__webglFramebuffer[at][_t]);else i.deleteFramebuffer(E.__webglFramebuffer[at]);E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer[at])}else{if(Array.isArray(E.__webglFramebuffer))for(let at=0;at<E.__webglFramebuffer.length;at++)i.deleteFramebuffer(E.__webglFramebuffer[at]);else i.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&i.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let at=0;at<E.__webglColorRenderbuffer.length;at++)E.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(E.__webglColorRenderbuffer[at]);E.__webglDepthRenderbuffer&&i.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let ft=L.textures;for(let at=0,_t=ft.length;at<_t;at++){let wt=n.get(ft[at]);wt.__webglTexture&&(i.deleteTexture(wt.__webglTexture),o.memory.textures--),n.remove(ft[at])}n.remove(L)}let $=0;function X(){$=0}function tt(){return $}function ht(L){$=L}function ct(){let L=$;return L>=r.maxTextures&&jt("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+r.maxTextures),$+=1,L}function J(L){let E=[];return E.push(L.wrapS),E.push(L.wrapT),E.push(L.wrapR||0),E.push(L.magFilter),E.push(L.minFilter),E.push(L.anisotropy),E.push(L.internalFormat),E.push(L.format),E.push(L.type),E.push(L.generateMipmaps),E.push(L.mipmapsAutoUpdate),E.push(L.premultiplyAlpha),E.push(L.flipY),E.push(L.unpackAlignment),E.push(L.colorSpace),E.join()}function dt(L,E){let Y=n.get(L);if(L.isVideoTexture&&He(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&Y.__version!==L.version){let ft=L.image;if(ft===null)jt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)jt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ae(Y,L,E);return}}else L.isExternalTexture&&(Y.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+E)}function gt(L,E){let Y=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Y.__version!==L.version){Ae(Y,L,E);return}else L.isExternalTexture&&(Y.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+E)}function bt(L,E){let Y=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Y.__version!==L.version){Ae(Y,L,E);return}e.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+E)}function yt(L,E){let Y=n.get(L);if(L.version>0&&Y.__version!==L.version){hn(Y,L,E);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+E)}let Gt={[yu]:i.REPEAT,[xr]:i.CLAMP_TO_EDGE,[xu]:i.MIRRORED_REPEAT},Kt={[Bn]:i.NEAREST,[i_]:i.NEAREST_MIPMAP_NEAREST,[El]:i.NEAREST_MIPMAP_LINEAR,[ai]:i.LINEAR,[$u]:i.LINEAR_MIPMAP_NEAREST,[qr]:i.LINEAR_MIPMAP_LINEAR},zt={[a_]:i.NEVER,[qp]:i.ALWAYS,[l_]:i.LESS,[Hp]:i.LEQUAL,[c_]:i.EQUAL,[Wp]:i.GEQUAL,[u_]:i.GREATER,[h_]:i.NOTEQUAL};function le(L,E){if(E.type===ir&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===ai||E.magFilter===$u||E.magFilter===El||E.magFilter===qr||E.minFilter===ai||E.minFilter===$u||E.minFilter===El||E.minFilter===qr)&&jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,Gt[E.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,Gt[E.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,Gt[E.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,Kt[E.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,Kt[E.minFilter]),E.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,zt[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Bn||E.minFilter!==El&&E.minFilter!==qr||E.type===ir&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||n.get(E).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");i.texParameterf(L,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,r.getMaxAnisotropy())),n.get(E).__currentAnisotropy=E.anisotropy}}}function oe(L,E){let Y=!1;L.__webglInit===void 0&&(L.__webglInit=!0,E.addEventListener("dispose",I),N(E));let ft=E.source,at=d.get(ft);at===void 0&&(at={},d.set(ft,at));let _t=J(E);if(_t!==L.__cacheKey){at[_t]===void 0&&(at[_t]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),at[_t].usedTimes++;let wt=at[L.__cacheKey];wt!==void 0&&(at[L.__cacheKey].usedTimes--,wt.usedTimes===0&&z(E)),L.__cacheKey=_t,L.__webglTexture=at[_t].texture}return Y}function Jt(L,E,Y){return Math.floor(Math.floor(L/Y)/E)}function Fe(L,E,Y,ft){let _t=L.updateRanges;if(_t.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,E.width,E.height,Y,ft,E.data);else{_t.sort((B,ot)=>B.start-ot.start);let wt=0;for(let B=1;B<_t.length;B++){let ot=_t[wt],it=_t[B],Et=ot.start+ot.count,vt=Jt(it.start,E.width,4),St=Jt(ot.start,E.width,4);it.start<=Et+1&&vt===St&&Jt(it.start+it.count-1,E.width,4)===vt?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++wt,_t[wt]=it)}_t.length=wt+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,E.width);for(let B=0,ot=_t.length;B<ot;B++){let it=_t[B],Et=Math.floor(it.start/4),vt=Math.ceil(it.count/4),St=Et%E.width,Wt=Math.floor(Et/E.width),ee=vt,ut=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,St),e.pixelStorei(i.UNPACK_SKIP_ROWS,Wt),e.texSubImage2D(i.TEXTURE_2D,0,St,Wt,ee,ut,Y,ft,E.data)}L.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function Ae(L,E,Y){let ft=i.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(ft=i.TEXTURE_2D_ARRAY),E.isData3DTexture&&(ft=i.TEXTURE_3D);let at=oe(L,E),_t=E.source;e.bindTexture(ft,L.__webglTexture,i.TEXTURE0+Y);let wt=n.get(_t);if(_t.version!==wt.__version||at===!0){if(e.activeTexture(i.TEXTURE0+Y),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ut=be.getPrimaries(be.workingColorSpace),kt=E.colorSpace===Xr?null:be.getPrimaries(E.colorSpace),ne=E.colorSpace===Xr||ut===kt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne)}e.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment);let st=x(E.image,!1,r.maxTextureSize);st=Ht(E,st);let mt=s.convert(E.format,E.colorSpace),B=s.convert(E.type),ot=A(E.internalFormat,mt,B,E.normalized,E.colorSpace,E.isVideoTexture);le(ft,E);let it,Et=E.mipmaps,vt=E.isVideoTexture!==!0,St=wt.__version===void 0||at===!0,Wt=_t.dataReady,ee=w(E,st);if(E.isDepthTexture)ot=b(E.format===$r,E.type),St&&(vt?e.texStorage2D(i.TEXTURE_2D,1,ot,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,ot,st.width,st.height,0,mt,B,null));else if(E.isDataTexture)if(Et.length>0){vt&&St&&e.texStorage2D(i.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ut=0,kt=Et.length;ut<kt;ut++)it=Et[ut],vt?Wt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,B,it.data):e.texImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,mt,B,it.data);E.generateMipmaps=!1}else vt?(St&&e.texStorage2D(i.TEXTURE_2D,ee,ot,st.width,st.height),Wt&&Fe(E,st,mt,B)):e.texImage2D(i.TEXTURE_2D,0,ot,st.width,st.height,0,mt,B,st.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){vt&&St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,ot,Et[0].width,Et[0].height,st.depth);for(let ut=0,kt=Et.length;ut<kt;ut++)if(it=Et[ut],E.format!==sr)if(mt!==null)if(vt){if(Wt)if(E.layerUpdates.size>0){let ne=em(it.width,it.height,E.format,E.type);for(let Ct of E.layerUpdates){let fe=it.data.subarray(Ct*ne/it.data.BYTES_PER_ELEMENT,(Ct+1)*ne/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,Ct,it.width,it.height,1,mt,fe)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,mt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ut,ot,it.width,it.height,st.depth,0,it.data,0,0);else jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else vt?Wt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,mt,B,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ut,ot,it.width,it.height,st.depth,0,mt,B,it.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{vt&&St&&e.texStorage2D(i.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ut=0,kt=Et.length;ut<kt;ut++)it=Et[ut],E.format!==sr?mt!==null?vt?Wt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,it.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):vt?Wt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,B,it.data):e.texImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,mt,B,it.data)}else if(E.isDataArrayTexture)if(vt){if(St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,ot,st.width,st.height,st.depth),Wt)if(E.layerUpdates.size>0){let ut=em(st.width,st.height,E.format,E.type);for(let kt of E.layerUpdates){let ne=st.data.subarray(kt*ut/st.data.BYTES_PER_ELEMENT,(kt+1)*ut/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,kt,st.width,st.height,1,mt,B,ne)}E.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,ot,st.width,st.height,st.depth,0,mt,B,st.data);else if(E.isData3DTexture)vt?(St&&e.texStorage3D(i.TEXTURE_3D,ee,ot,st.width,st.height,st.depth),Wt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)):e.texImage3D(i.TEXTURE_3D,0,ot,st.width,st.height,st.depth,0,mt,B,st.data);else if(E.isFramebufferTexture){if(St)if(vt)e.texStorage2D(i.TEXTURE_2D,ee,ot,st.width,st.height);else{let ut=st.width,kt=st.height;for(let ne=0;ne<ee;ne++)e.texImage2D(i.TEXTURE_2D,ne,ot,ut,kt,0,mt,B,null),ut>>=1,kt>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in i){let ut=i.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),st.parentNode!==ut){ut.appendChild(st),h.add(E),ut.onpaint=kt=>{let ne=kt.changedElements;for(let Ct of h)ne.includes(Ct.image)&&(Ct.needsUpdate=!0)},ut.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let ne=i.RGBA,Ct=i.RGBA,fe=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ne,Ct,fe,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Et.length>0){if(vt&&St){let ut=Yt(Et[0]);e.texStorage2D(i.TEXTURE_2D,ee,ot,ut.width,ut.height)}for(let ut=0,kt=Et.length;ut<kt;ut++)it=Et[ut],vt?Wt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,mt,B,it):e.texImage2D(i.TEXTURE_2D,ut,ot,mt,B,it);E.generateMipmaps=!1}else if(vt){if(St){let ut=Yt(st);e.texStorage2D(i.TEXTURE_2D,ee,ot,ut.width,ut.height)}Wt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,B,st)}else e.texImage2D(i.TEXTURE_2D,0,ot,mt,B,st);_(E)&&E.mipmapsAutoUpdate===!0&&v(ft),wt.__version=_t.version,E.onUpdate&&E.onUpdate(E)}L.__version=E.version}function hn(L,E,Y){if(E.image.length!==6)return;let ft=oe(L,E),at=E.source;e.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+Y);let _t=n.get(at);if(at.version!==_t.__version||ft===!0){e.activeTexture(i.TEXTURE0+Y);let wt=be.getPrimaries(be.workingColorSpace),nt=E.colorSpace===Xr?null:be.getPrimaries(E.colorSpace),st=E.colorSpace===Xr||wt===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=E.isCompressedTexture||E.image[0].isCompressedTexture,B=E.image[0]&&E.image[0].isDataTexture,ot=[];for(let Ct=0;Ct<6;Ct++)!mt&&!B?ot[Ct]=x(E.image[Ct],!0,r.maxCubemapSize):ot[Ct]=B?E.image[Ct].image:E.image[Ct],ot[Ct]=Ht(E,ot[Ct]);let it=ot[0],Et=s.convert(E.format,E.colorSpace),vt=s.convert(E.type),St=A(E.internalFormat,Et,vt,E.normalized,E.colorSpace),Wt=E.isVideoTexture!==!0,ee=_t.__version===void 0||ft===!0,ut=at.dataReady,kt=w(E,it);le(i.TEXTURE_CUBE_MAP,E);let ne;if(E.isDepthTexture){if(St=b(E.format===$r,E.type),ee)if(Wt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,St,it.width,it.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,it.width,it.height,0,Et,vt,null)}else if(mt){Wt&&ee&&e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,St,it.width,it.height);for(let Ct=0;Ct<6;Ct++){ne=ot[Ct].mipmaps;for(let fe=0;fe<ne.length;fe++){let Ke=ne[fe];E.format!==sr?Et!==null?Wt?ut&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe,0,0,Ke.width,Ke.height,Et,Ke.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe,St,Ke.width,Ke.height,0,Ke.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe,0,0,Ke.width,Ke.height,Et,vt,Ke.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe,St,Ke.width,Ke.height,0,Et,vt,Ke.data)}}}else{if(ne=E.mipmaps,Wt&&ee){ne.length>0&&kt++;let Ct=Yt(ot[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,St,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(B){Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,ot[Ct].width,ot[Ct].height,Et,vt,ot[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,ot[Ct].width,ot[Ct].height,0,Et,vt,ot[Ct].data);for(let fe=0;fe<ne.length;fe++){let Jn=ne[fe].image[Ct].image;Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe+1,0,0,Jn.width,Jn.height,Et,vt,Jn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe+1,St,Jn.width,Jn.height,0,Et,vt,Jn.data)}}else{Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,vt,ot[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,Et,vt,ot[Ct]);for(let fe=0;fe<ne.length;fe++){let Ke=ne[fe];Wt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe+1,0,0,Et,vt,Ke.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,fe+1,St,Et,vt,Ke.image[Ct])}}}_(E)&&E.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),_t.__version=at.version,E.onUpdate&&E.onUpdate(E)}L.__version=E.version}function Ft(L,E,Y,ft,at,_t){let wt=s.convert(Y.format,Y.colorSpace),nt=s.convert(Y.type),st=A(Y.internalFormat,wt,nt,Y.normalized,Y.colorSpace),mt=n.get(E),B=n.get(Y);if(B.__renderTarget=E,!mt.__hasExternalTextures){let ot=Math.max(1,E.width>>_t),it=Math.max(1,E.height>>_t);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,_t,st,ot,it,E.depth,0,wt,nt,null):e.texImage2D(at,_t,st,ot,it,0,wt,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,L),At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ft,at,B.__webglTexture,0,ce(E)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ft,at,B.__webglTexture,_t),e.bindFramebuffer(i.FRAMEBUFFER,null)}function xe(L,E,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,L),E.depthBuffer){let ft=E.depthTexture,at=ft&&ft.isDepthTexture?ft.type:null,_t=b(E.stencilBuffer,at),wt=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;At(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(E),_t,E.width,E.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(E),_t,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,_t,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,wt,i.RENDERBUFFER,L)}else{let ft=E.textures;for(let at=0;at<ft.length;at++){let _t=ft[at],wt=s.convert(_t.format,_t.colorSpace),nt=s.convert(_t.type),st=A(_t.internalFormat,wt,nt,_t.normalized,_t.colorSpace);At(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(E),st,E.width,E.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(E),st,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,st,E.width,E.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function te(L,E,Y){let ft=E.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,L),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(E.depthTexture);at.__renderTarget=E;let _t=ft?E.depthTexture.image[0]:E.depthTexture.image;(!at.__webglTexture||_t.width!==E.width||_t.height!==E.height)&&(_t.width=E.width,_t.height=E.height,E.depthTexture.needsUpdate=!0),ft?yt(E.depthTexture,0):dt(E.depthTexture,0);let wt=at.__webglTexture,nt=ce(E),st=ft?i.TEXTURE_CUBE_MAP_POSITIVE_X+Y:i.TEXTURE_2D,mt=E.depthTexture.format===$r?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(E.depthTexture.format===Hr)At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,wt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,wt,0);else if(E.depthTexture.format===$r)At(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,wt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function je(L){let E=n.get(L),Y=L.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==L.depthTexture){let ft=L.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),ft){let at=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,ft.removeEventListener("dispose",at)};ft.addEventListener("dispose",at),E.__depthDisposeCallback=at}E.__boundDepthTexture=ft}if(L.depthTexture&&!E.__autoAllocateDepthBuffer)if(Y)for(let ft=0;ft<6;ft++)te(E.__webglFramebuffer[ft],L,ft);else L.texture.mipmaps.length>0?te(E.__webglFramebuffer[0],L,0):te(E.__webglFramebuffer,L,0);else if(Y){E.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[ft]),E.__webglDepthbuffer[ft]===void 0)E.__webglDepthbuffer[ft]=i.createRenderbuffer(),xe(E.__webglDepthbuffer[ft],L,!1);else{let at=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=E.__webglDepthbuffer[ft];i.bindRenderbuffer(i.RENDERBUFFER,_t),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,_t)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=i.createRenderbuffer(),xe(E.__webglDepthbuffer,L,!1);else{let at=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=E.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_t),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,_t)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ze(L,E,Y){let ft=n.get(L);E!==void 0&&Ft(ft.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&je(L)}function an(L){let E=L.texture,Y=n.get(L),ft=n.get(E);L.addEventListener("dispose",U),N(L);let at=L.textures,_t=L.isWebGLCubeRenderTarget===!0,wt=at.length>1;if(wt||(ft.__webglTexture===void 0&&(ft.__webglTexture=i.createTexture()),ft.__version=E.version,o.memory.textures++),_t){Y.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(E.mipmaps.length>0){Y.__webglFramebuffer[nt]=[];for(let st=0;st<E.mipmaps.length;st++)Y.__webglFramebuffer[nt][st]=i.createFramebuffer()}else Y.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(E.mipmaps.length>0){Y.__webglFramebuffer=[];for(let nt=0;nt<E.mipmaps.length;nt++)Y.__webglFramebuffer[nt]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(wt)for(let nt=0,st=at.length;nt<st;nt++){let mt=n.get(at[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&At(L)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];Y.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[nt]);let mt=s.convert(st.format,st.colorSpace),B=s.convert(st.type),ot=A(st.internalFormat,mt,B,st.normalized,st.colorSpace,L.isXRRenderTarget===!0),it=ce(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,ot,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,Y.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),xe(Y.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_t){e.bindTexture(i.TEXTURE_CUBE_MAP,ft.__webglTexture),le(i.TEXTURE_CUBE_MAP,E);for(let nt=0;nt<6;nt++)if(E.mipmaps.length>0)for(let st=0;st<E.mipmaps.length;st++)Ft(Y.__webglFramebuffer[nt][st],L,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Ft(Y.__webglFramebuffer[nt],L,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);_(E)?v(i.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let nt=0,st=at.length;nt<st;nt++){let mt=at[nt],B=n.get(mt),ot=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ot=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ot,B.__webglTexture),le(ot,mt),Ft(Y.__webglFramebuffer,L,mt,i.COLOR_ATTACHMENT0+nt,ot,0),_(mt)&&v(ot)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(nt=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,ft.__webglTexture),le(nt,E),E.mipmaps.length>0)for(let st=0;st<E.mipmaps.length;st++)Ft(Y.__webglFramebuffer[st],L,E,i.COLOR_ATTACHMENT0,nt,st);else Ft(Y.__webglFramebuffer,L,E,i.COLOR_ATTACHMENT0,nt,0);_(E)?v(nt):E.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&je(L)}function k(L){let E=L.textures;for(let Y=0,ft=E.length;Y<ft;Y++){let at=E[Y];if(_(at)&&at.mipmapsAutoUpdate===!0){let _t=M(L),wt=n.get(at).__webglTexture;e.bindTexture(_t,wt),v(_t),e.unbindTexture()}}}let xt=[];function Xt(L){if(L.samples>0){if(At(L)===!1){let E=L.textures,Y=L.width,ft=L.height,at=i.COLOR_BUFFER_BIT,_t=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,wt=n.get(L),nt=E.length>1;if(nt)for(let mt=0;mt<E.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,wt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let mt=0;mt<E.length;mt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,wt.__webglColorRenderbuffer[mt]);let B=n.get(E[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,Y,ft,0,0,Y,ft,at,i.NEAREST),l===!0&&(xt.length=0,xt.push(i.COLOR_ATTACHMENT0+mt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&xt.push(_t),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,xt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<E.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,wt.__webglColorRenderbuffer[mt]);let B=n.get(E[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,wt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,B,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let E=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[E])}}}function ce(L){return Math.min(r.maxSamples,L.samples)}function At(L){let E=n.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function He(L){let E=o.render.frame;u.get(L)!==E&&(u.set(L,E),L.update())}function Ht(L,E){let Y=L.colorSpace,ft=L.format,at=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Y!==Qa&&Y!==Xr&&(be.getTransfer(Y)===Ie?(ft!==sr||at!==di)&&jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",Y)),E}function Yt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=ct,this.resetTextureUnits=X,this.getTextureUnits=tt,this.setTextureUnits=ht,this.setTexture2D=dt,this.setTexture2DArray=gt,this.setTexture3D=bt,this.setTextureCube=yt,this.rebindTextures=Ze,this.setupRenderTarget=an,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Xt,this.setupDepthRenderbuffer=je,this.setupFrameBufferTexture=Ft,this.useMultisampledRTT=At,this.dispose=D}function gP(i,t){function e(n,r=Xr){let s,o=be.getTransfer(r);if(n===di)return i.UNSIGNED_BYTE;if(n===Yu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===ju)return i.UNSIGNED_SHORT_5_5_5_1;if(n===kp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Bp)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Op)return i.BYTE;if(n===Up)return i.SHORT;if(n===ha)return i.UNSIGNED_SHORT;if(n===Xu)return i.INT;if(n===nr)return i.UNSIGNED_INT;if(n===ir)return i.FLOAT;if(n===rr)return i.HALF_FLOAT;if(n===zp)return i.ALPHA;if(n===Vp)return i.RGB;if(n===sr)return i.RGBA;if(n===Hr)return i.DEPTH_COMPONENT;if(n===$r)return i.DEPTH_STENCIL;if(n===Gp)return i.RED;if(n===Zu)return i.RED_INTEGER;if(n===Ss)return i.RG;if(n===Ku)return i.RG_INTEGER;if(n===Ju)return i.RGBA_INTEGER;if(n===Tl||n===Rl||n===Cl||n===Pl)if(o===Ie)if(s=t.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===Tl)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Rl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Cl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Pl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=t.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===Tl)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Rl)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Cl)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Pl)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Qu||n===th||n===eh||n===nh)if(s=t.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===Qu)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===th)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===eh)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===nh)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ih||n===rh||n===sh||n===oh||n===ah||n===Il||n===lh)if(s=t.get("WEBGL_compressed_texture_etc"),s!==null){if(n===ih||n===rh)return o===Ie?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===sh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===oh)return s.COMPRESSED_R11_EAC;if(n===ah)return s.COMPRESSED_SIGNED_R11_EAC;if(n===Il)return s.COMPRESSED_RG11_EAC;if(n===lh)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===ch||n===uh||n===hh||n===fh||n===dh||n===ph||n===mh||n===gh||n===yh||n===xh||n===vh||n===_h||n===bh||n===wh)if(s=t.get("WEBGL_compressed_texture_astc"),s!==null){if(n===ch)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===uh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===hh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===fh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===dh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ph)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===mh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===gh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===yh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===xh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===vh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_h)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===bh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===wh)return o===Ie?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Mh||n===Sh||n===Ah)if(s=t.get("EXT_texture_compression_bptc"),s!==null){if(n===Mh)return o===Ie?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Sh)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Ah)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Eh||n===Th||n===Ll||n===Rh)if(s=t.get("EXT_texture_compression_rgtc"),s!==null){if(n===Eh)return s.COMPRESSED_RED_RGTC1_EXT;if(n===Th)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ll)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Rh)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===to?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var yP=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,xP=`
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

}`,um=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new hl(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new zi({vertexShader:yP,fragmentShader:xP,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ge(new Xs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},hm=class extends Qi{constructor(t,e){super();let n=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,m=null,y=typeof XRWebGLBinding<"u",g=new um,p={},x=e.getContextAttributes(),_=null,v=null,M=[],A=[],b=new Zt,w=null,N=null,P=new Hn;P.viewport=new Le;let I=new Hn;I.viewport=new Le;let U=[P,I],V=new Gu,C=null,D=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let dt=M[J];return dt===void 0&&(dt=new na,M[J]=dt),dt.getTargetRaySpace()},this.getControllerGrip=function(J){let dt=M[J];return dt===void 0&&(dt=new na,M[J]=dt),dt.getGripSpace()},this.getHand=function(J){let dt=M[J];return dt===void 0&&(dt=new na,M[J]=dt),dt.getHandSpace()};function G(J){let dt=A.indexOf(J.inputSource);if(dt===-1)return;let gt=M[dt];gt!==void 0&&(gt.update(J.inputSource,J.frame,c||o),gt.dispatchEvent({type:J.type,data:J.inputSource}))}function z(){r.removeEventListener("select",G),r.removeEventListener("selectstart",G),r.removeEventListener("selectend",G),r.removeEventListener("squeeze",G),r.removeEventListener("squeezestart",G),r.removeEventListener("squeezeend",G),r.removeEventListener("end",z),r.removeEventListener("inputsourceschange",et);for(let J=0;J<M.length;J++){let dt=A[J];dt!==null&&(A[J]=null,M[J].disconnect(dt))}C=null,D=null,g.reset();for(let J in p)delete p[J];if(t.setRenderTarget(_),d=null,f=null,h=null,r=null,v=null,ct.stop(),n.isPresenting=!1,t.setPixelRatio(w),t.setSize(b.width,b.height,!1),N!==null){let J=N.camera;J.fov=N.fov,J.zoom=N.zoom,J.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){s=J,n.isPresenting===!0&&jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){a=J,n.isPresenting===!0&&jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(J){c=J},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(r,e)),h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(J){if(r=J,r!==null){if(_=t.getRenderTarget(),r.addEventListener("select",G),r.addEventListener("selectstart",G),r.addEventListener("selectend",G),r.addEventListener("squeeze",G),r.addEventListener("squeezestart",G),r.addEventListener("squeezeend",G),r.addEventListener("end",z),r.addEventListener("inputsourceschange",et),x.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(b),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,bt=null,yt=null;x.depth&&(yt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=x.stencil?$r:Hr,bt=x.stencil?to:nr);let Gt={colorFormat:e.RGBA8,depthFormat:yt,scaleFactor:s};h=this.getBinding(),f=h.createProjectionLayer(Gt),r.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),v=new Ri(f.textureWidth,f.textureHeight,{format:sr,type:di,depthTexture:new Wr(f.textureWidth,f.textureHeight,bt,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let gt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(r,e,gt),r.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),v=new Ri(d.framebufferWidth,d.framebufferHeight,{format:sr,type:di,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),ct.setContext(r),ct.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function et(J){for(let dt=0;dt<J.removed.length;dt++){let gt=J.removed[dt],bt=A.indexOf(gt);bt>=0&&(A[bt]=null,M[bt].disconnect(gt))}for(let dt=0;dt<J.added.length;dt++){let gt=J.added[dt],bt=A.indexOf(gt);if(bt===-1){for(let Gt=0;Gt<M.length;Gt++)if(Gt>=A.length){A.push(gt),bt=Gt;break}else if(A[Gt]===null){A[Gt]=gt,bt=Gt;break}if(bt===-1)break}let yt=M[bt];yt&&yt.connect(gt)}}function $(J,dt){dt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(dt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(r===null)return;let dt=J.near,gt=J.far;g.texture!==null&&(g.depthNear>0&&(dt=g.depthNear),g.depthFar>0&&(gt=g.depthFar)),V.near=I.near=P.near=dt,V.far=I.far=P.far=gt,(C!==V.near||D!==V.far)&&(r.updateRenderState({depthNear:V.near,depthFar:V.far}),C=V.near,D=V.far),V.layers.mask=J.layers.mask|6,P.layers.mask=V.layers.mask&-5,I.layers.mask=V.layers.mask&-3;let bt=J.parent,yt=V.cameras;$(V,bt);for(let Gt=0;Gt<yt.length;Gt++)$(yt[Gt],bt);V.projectionMatrix.copy(P.projectionMatrix),V.projectionMatrixInverse.copy(P.projectionMatrixInverse),N===null&&J.isPerspectiveCamera&&(N={camera:J,fov:J.fov,zoom:J.zoom}),X(J,V,bt)};function X(J,dt,gt){gt===null?J.matrix.copy(dt.matrixWorld):(J.matrix.copy(gt.matrixWorld),J.matrix.invert(),J.matrix.multiply(dt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(dt.projectionMatrix),J.projectionMatrixInverse.copy(dt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=ta*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(J){l=J,f!==null&&(f.fixedFoveation=J),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=J)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(J){return p[J]};let tt=null;function ht(J,dt){if(u=dt.getViewerPose(c||o),m=dt,u!==null){let gt=u.views;d!==null&&(t.setRenderTargetFramebuffer(v,d.framebuffer),t.setRenderTarget(v));let bt=!1;gt.length!==V.cameras.length&&(V.cameras.length=0,bt=!0);for(let zt=0;zt<gt.length;zt++){let le=gt[zt],oe=null;if(d!==null)oe=d.getViewport(le);else{let Fe=h.getViewSubImage(f,le);oe=Fe.viewport,zt===0&&(t.setRenderTargetTextures(v,Fe.colorTexture,Fe.depthStencilTexture),t.setRenderTarget(v))}let Jt=U[zt];Jt===void 0&&(Jt=new Hn,Jt.layers.enable(zt),Jt.viewport=new Le,U[zt]=Jt),Jt.matrix.fromArray(le.transform.matrix),Jt.matrix.decompose(Jt.position,Jt.quaternion,Jt.scale),Jt.projectionMatrix.fromArray(le.projectionMatrix),Jt.projectionMatrixInverse.copy(Jt.projectionMatrix).invert(),Jt.viewport.set(oe.x,oe.y,oe.width,oe.height),zt===0&&(V.matrix.copy(Jt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),bt===!0&&V.cameras.push(Jt)}let yt=r.enabledFeatures;if(yt&&yt.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&y){h=n.getBinding();let zt=h.getDepthInformation(gt[0]);zt&&zt.isValid&&zt.texture&&g.init(zt,r.renderState)}if(yt&&yt.includes("camera-access")&&y){t.state.unbindTexture(),h=n.getBinding();for(let zt=0;zt<gt.length;zt++){let le=gt[zt].camera;if(le){let oe=p[le];oe||(oe=new hl,p[le]=oe);let Jt=h.getCameraImage(le);oe.sourceTexture=Jt}}}}for(let gt=0;gt<M.length;gt++){let bt=A[gt],yt=M[gt];bt!==null&&yt!==void 0&&yt.update(bt,dt,c||o)}tt&&tt(J,dt),dt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:dt}),m=null}let ct=new z_;ct.setAnimationLoop(ht),this.setAnimationLoop=function(J){tt=J},this.dispose=function(){}}},vP=new $e,Z_=new se;Z_.set(-1,0,0,0,1,0,0,0,1);function _P(i,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,Jp(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function r(g,p,x,_,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?s(g,p):p.isMeshLambertMaterial?(s(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(s(g,p),h(g,p)):p.isMeshPhongMaterial?(s(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(s(g,p),f(g,p),p.isMeshPhysicalMaterial&&d(g,p,v)):p.isMeshMatcapMaterial?(s(g,p),m(g,p)):p.isMeshDepthMaterial?s(g,p):p.isMeshDistanceMaterial?(s(g,p),y(g,p)):p.isMeshNormalMaterial?s(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,x,_):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===ci&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===ci&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let x=t.get(p),_=x.envMap,v=x.envMapRotation;_&&(g.envMap.value=_,g.envMapRotation.value.setFromMatrix4(vP.makeRotationFromEuler(v)).transpose(),_.isCubeTexture&&_.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Z_),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,x,_){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*x,g.scale.value=_*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function f(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function d(g,p,x){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ci&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function y(g,p){let x=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function bP(i,t,e,n){let r={},s={};function o(x,_){let v=_.program;n.uniformBlockBinding(x,v,r[x.id])}function a(x,_){let v=r[x.id];v===void 0&&(m(x),v=l(x),r[x.id]=v,x.addEventListener("dispose",g));let M=_.program;n.updateUBOMapping(x,M);let A=t.render.frame;s[x.id]!==A&&(c(x),s[x.id]=A)}function l(x){let _=i.createBuffer(),v=x.__size,M=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,_),i.bufferData(i.UNIFORM_BUFFER,v,M),i.bindBuffer(i.UNIFORM_BUFFER,null),_}function c(x){let _=r[x.id],v=x.uniforms,M=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,_);for(let A=0,b=v.length;A<b;A++){let w=v[A];if(Array.isArray(w))for(let N=0,P=w.length;N<P;N++)u(w[N],A,N,M);else u(w,A,0,M)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(x,_,v,M){if(f(x,_,v,M)===!0){let A=x.__offset,b=x.value;if(Array.isArray(b)){let w=0;for(let N=0;N<b.length;N++){let P=b[N],I=y(P,!0);h(P,x.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(b,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,x.__data)}}function h(x,_,v){typeof x=="number"||typeof x=="boolean"?_[v]=x:x.isMatrix3?(_[v]=x.elements[0],_[v+1]=x.elements[1],_[v+2]=x.elements[2],_[v+3]=0,_[v+4]=x.elements[3],_[v+5]=x.elements[4],_[v+6]=x.elements[5],_[v+7]=0,_[v+8]=x.elements[6],_[v+9]=x.elements[7],_[v+10]=x.elements[8],_[v+11]=0):ArrayBuffer.isView(x)?_.set(x.subarray(0,_.length-v),v):x.toArray(_,v)}function f(x,_,v,M){let A=x.value,b=_+"_"+v;if(Array.isArray(A)){M[b]===void 0&&(M[b]=[]);let w=M[b],N=!1;for(let P=0;P<A.length;P++)d(A[P],w,P)===!0&&(N=!0);return N}return d(A,M,b)}function d(x,_,v){if(_[v]===void 0)return typeof x=="number"||typeof x=="boolean"?_[v]=x:ArrayBuffer.isView(x)?_[v]=x.slice():_[v]=x.clone(),!0;{let M=_[v];if(typeof x=="number"||typeof x=="boolean"){if(M!==x)return _[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(M.equals(x)===!1)return M.copy(x),!0}}return!1}function m(x){let _=x.uniforms,v=0,M=16;for(let b=0,w=_.length;b<w;b++){let N=Array.isArray(_[b])?_[b]:[_[b]];for(let P=0,I=N.length;P<I;P++){let U=N[P],V=Array.isArray(U.value)?U.value:[U.value],C=Array.isArray(_[b])||Array.isArray(U.value),D=v;for(let z=0,et=V.length;z<et;z++){let $=V[z],X=y($,C),tt=v%M,ht=tt%X.boundary,ct=tt+ht;v+=ht,ct!==0&&M-ct<X.storage&&(v+=M-ct),z===0&&(D=v),v+=X.storage}let G=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new G((v-D)/Float32Array.BYTES_PER_ELEMENT),U.__offset=D}}let A=v%M;return A>0&&(v+=M-A),x.__size=v,x.__cache={},this}function y(x,_){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):jt("WebGLRenderer: Unsupported uniform value type.",x),_===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(x){let _=x.target;_.removeEventListener("dispose",g),i.deleteBuffer(r[_.id]),delete r[_.id],delete s[_.id]}function p(){for(let x in r)i.deleteBuffer(r[x]);r={},s={}}return{bind:o,update:a,dispose:p}}var wP=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),wr=null;function MP(){return wr===null&&(wr=new Mu(wP,16,16,Ss,rr),wr.name="DFG_LUT",wr.minFilter=ai,wr.magFilter=ai,wr.wrapS=xr,wr.wrapT=xr,wr.generateMipmaps=!1,wr.needsUpdate=!0),wr}var Fh=class{constructor(t={}){let{canvas:e=f_(),context:n=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=di}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let y=d,g=new Set([Ju,Ku,Zu]),p=new Set([di,nr,ha,to,Yu,ju]),x=new Uint32Array(4),_=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},M=null,A=null,b=[],w=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=br,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,I=!1,U=null,V=null,C=null,D=null;this._outputColorSpace=Ei;let G=0,z=0,et=null,$=-1,X=null,tt=new Le,ht=new Le,ct=null,J=new he(0),dt=0,gt=e.width,bt=e.height,yt=1,Gt=null,Kt=null,zt=new Le(0,0,gt,bt),le=new Le(0,0,gt,bt),oe=!1,Jt=new ps,Fe=new Su,Ae=!1,hn=!1,Ft=new $e,xe=new H,te=new Le,je={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ze=!1;function an(){return et===null?yt:1}let k=n;function xt(R,W){return e.getContext(R,W)}let Xt,ce,At,He,Ht,Yt,L,E,Y,ft,at,_t,wt,nt,st,mt,B,ot,it,Et,vt,St,Wt;try{let R={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ne,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),k===null){let W="webgl2";if(k=xt(W,R),k===null)throw xt(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ee()}catch(R){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),re("WebGLRenderer: "+R.message),R}function ee(){Xt=new NC(k),Xt.init(),vt=new gP(k,Xt),ce=new MC(k,Xt,t,vt),At=new pP(k,Xt),ce.reversedDepthBuffer&&f&&At.buffers.depth.setReversed(!0),V=k.createFramebuffer(),C=k.createFramebuffer(),D=k.createFramebuffer(),He=new UC(k),Ht=new tP,Yt=new mP(k,Xt,At,Ht,ce,vt,He),L=new FC(P),E=new BE(k),St=new bC(k,E),Y=new DC(k,E,He,St),ft=new BC(k,Y,E,St,He),ot=new kC(k,ce,Yt),st=new SC(Ht),at=new Q2(P,L,Xt,ce,St,st),_t=new _P(P,Ht),wt=new nP,nt=new lP(Xt),B=new _C(P,L,At,ft,m,l),mt=new dP(P,ft,ce),Wt=new bP(k,He,ce,At),it=new wC(k,Xt,He),Et=new OC(k,Xt,He),He.programs=at.programs,P.capabilities=ce,P.extensions=Xt,P.properties=Ht,P.renderLists=wt,P.shadowMap=mt,P.state=At,P.info=He}y!==di&&(N=new VC(y,e.width,e.height,a,r,s));let ut=new hm(P,k);this.xr=ut,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=Xt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Xt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return yt},this.setPixelRatio=function(R){R!==void 0&&(yt=R,this.setSize(gt,bt,!1))},this.getSize=function(R){return R.set(gt,bt)},this.setSize=function(R,W,Q=!0){if(ut.isPresenting){jt("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=R,bt=W,e.width=Math.floor(R*yt),e.height=Math.floor(W*yt),Q===!0&&(e.style.width=R+"px",e.style.height=W+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,R,W)},this.getDrawingBufferSize=function(R){return R.set(gt*yt,bt*yt).floor()},this.setDrawingBufferSize=function(R,W,Q){gt=R,bt=W,yt=Q,e.width=Math.floor(R*Q),e.height=Math.floor(W*Q),this.setViewport(0,0,R,W)},this.setEffects=function(R){if(y===di){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let W=0;W<R.length;W++)if(R[W].isOutputPass===!0){jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(tt)},this.getViewport=function(R){return R.copy(zt)},this.setViewport=function(R,W,Q,j){R.isVector4?zt.set(R.x,R.y,R.z,R.w):zt.set(R,W,Q,j),At.viewport(tt.copy(zt).multiplyScalar(an()).round())},this.getScissor=function(R){return R.copy(le)},this.setScissor=function(R,W,Q,j){R.isVector4?le.set(R.x,R.y,R.z,R.w):le.set(R,W,Q,j),At.scissor(ht.copy(le).multiplyScalar(an()).round())},this.getScissorTest=function(){return oe},this.setScissorTest=function(R){At.setScissorTest(oe=R)},this.setOpaqueSort=function(R){Gt=R},this.setTransparentSort=function(R){Kt=R},this.getClearColor=function(R){return R.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(R=!0,W=!0,Q=!0){let j=0;if(R){let Z=!1;if(et!==null){let Tt=et.texture.format;Z=g.has(Tt)}if(Z){let Tt=et.texture.type,It=p.has(Tt),Rt=B.getClearColor(),Lt=B.getClearAlpha(),Vt=Rt.r,ie=Rt.g,me=Rt.b;It?(x[0]=Vt,x[1]=ie,x[2]=me,x[3]=Lt,k.clearBufferuiv(k.COLOR,0,x)):(_[0]=Vt,_[1]=ie,_[2]=me,_[3]=Lt,k.clearBufferiv(k.COLOR,0,_))}else j|=k.COLOR_BUFFER_BIT}W&&(j|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(j|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),j!==0&&k.clear(j)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),U=R},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),B.dispose(),wt.dispose(),nt.dispose(),Yt.dispose(),Ht.dispose(),L.dispose(),ft.dispose(),Y.dispose(),St.dispose(),Wt.dispose(),at.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",jl),ut.removeEventListener("sessionend",ar),Tr.stop()};function kt(R){R.preventDefault(),nl("WebGLRenderer: Context Lost."),I=!0}function ne(){nl("WebGLRenderer: Context Restored."),I=!1;let R=He.autoReset,W=mt.enabled,Q=mt.autoUpdate,j=mt.needsUpdate,Z=mt.type;ee(),He.autoReset=R,mt.enabled=W,mt.autoUpdate=Q,mt.needsUpdate=j,mt.type=Z}function Ct(R){re("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function fe(R){let W=R.target;W.removeEventListener("dispose",fe),Ke(W)}function Ke(R){Jn(R),Ht.remove(R)}function Jn(R){let W=Ht.get(R).programs;W!==void 0&&(W.forEach(function(Q){at.releaseProgram(Q)}),R.isShaderMaterial&&at.releaseShaderCache(R))}this.renderBufferDirect=function(R,W,Q,j,Z,Tt){W===null&&(W=je);let It=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Rt=ba(R,W,Q,j,Z);At.setMaterial(j,It);let Lt=Q.index,Vt=1;if(j.wireframe===!0){if(Lt=Y.getWireframeAttribute(Q),Lt===void 0)return;Vt=2}let ie=Q.drawRange,me=Q.attributes.position,Bt=ie.start*Vt,ge=(ie.start+ie.count)*Vt;Tt!==null&&(Bt=Math.max(Bt,Tt.start*Vt),ge=Math.min(ge,(Tt.start+Tt.count)*Vt)),Lt!==null?(Bt=Math.max(Bt,0),ge=Math.min(ge,Lt.count)):me!=null&&(Bt=Math.max(Bt,0),ge=Math.min(ge,me.count));let ln=ge-Bt;if(ln<0||ln===1/0)return;St.setup(Z,j,Rt,Q,Lt);let Ne,De=it;if(Lt!==null&&(Ne=E.get(Lt),De=Et,De.setIndex(Ne)),Z.isMesh)j.wireframe===!0?(At.setLineWidth(j.wireframeLinewidth*an()),De.setMode(k.LINES)):De.setMode(k.TRIANGLES);else if(Z.isLine){let En=j.linewidth;En===void 0&&(En=1),At.setLineWidth(En*an()),Z.isLineSegments?De.setMode(k.LINES):Z.isLineLoop?De.setMode(k.LINE_LOOP):De.setMode(k.LINE_STRIP)}else Z.isPoints?De.setMode(k.POINTS):Z.isSprite&&De.setMode(k.TRIANGLES);if(Z.isBatchedMesh)if(Xt.get("WEBGL_multi_draw"))De.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let En=Z._multiDrawStarts,Ot=Z._multiDrawCounts,vn=Z._multiDrawCount,ve=Lt?E.get(Lt).bytesPerElement:1,Cr=Ht.get(j).currentProgram.getUniforms();for(let _n=0;_n<vn;_n++)Cr.setValue(k,"_gl_DrawID",_n),De.render(En[_n]/ve,Ot[_n])}else if(Z.isInstancedMesh)De.renderInstances(Bt,ln,Z.count);else if(Q.isInstancedBufferGeometry){let En=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ot=Math.min(Q.instanceCount,En);De.renderInstances(Bt,ln,Ot)}else De.render(Bt,ln)};function xa(R,W,Q,j){U!==null&&R.isNodeMaterial&&U.setObject(j,R),Ae===!0&&st.setState(R,Q,!1),R.transparent===!0&&R.side===Vi&&R.forceSinglePass===!1?(R.side=ci,R.needsUpdate=!0,lr(R,W,j),R.side=Ms,R.needsUpdate=!0,lr(R,W,j),R.side=Vi):lr(R,W,j)}this.compile=function(R,W,Q=null){Q===null&&(Q=R),U!==null&&U.renderStart(R,W,Q),A=nt.get(Q),A.init(W),w.push(A),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(W.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),R!==Q&&R.traverseVisible(function(Z){Z.isLight&&Z.layers.test(W.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),U!==null&&U.updateLights(A.state.lightsArray),hn=this.localClippingEnabled,Ae=st.init(this.clippingPlanes,hn),Ae===!0&&st.setGlobalState(this.clippingPlanes,W),U!==null&&mt.render(A.state.shadowsArray,Q,W);let j=new Set;return R.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Tt=Z.material;if(Tt)if(Array.isArray(Tt))for(let It=0;It<Tt.length;It++){let Rt=Tt[It];xa(Rt,Q,W,Z),j.add(Rt)}else xa(Tt,Q,W,Z),j.add(Tt)}),A=w.pop(),U!==null&&U.renderEnd(),j},this.compileAsync=function(R,W,Q=null){let j=this.compile(R,W,Q);return new Promise(Z=>{function Tt(){if(j.forEach(function(It){let Lt=Ht.get(It).currentProgram;(Lt===void 0||Lt.isReady())&&j.delete(It)}),j.size===0){Z(R);return}setTimeout(Tt,10)}Xt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let oo=null;function hf(R){oo&&oo(R)}function jl(){Tr.stop()}function ar(){Tr.start()}let Tr=new z_;Tr.setAnimationLoop(hf),typeof self<"u"&&Tr.setContext(self),this.setAnimationLoop=function(R){oo=R,ut.setAnimationLoop(R),R===null?Tr.stop():Tr.start()},ut.addEventListener("sessionstart",jl),ut.addEventListener("sessionend",ar),this.render=function(R,W){if(W!==void 0&&W.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;U!==null&&U.renderStart(R,W);let Q=ut.enabled===!0&&ut.isPresenting===!0,j=N!==null&&(et===null||Q)&&N.begin(P,et);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(W),W=ut.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,W,et),A=nt.get(R,w.length),A.init(W),A.state.textureUnits=Yt.getTextureUnits(),w.push(A),Ft.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?Fe.setFromArrayCamera(W):Jt.setFromProjectionMatrix(Ft,ki,W.reversedDepth),hn=this.localClippingEnabled,Ae=st.init(this.clippingPlanes,hn),M=wt.get(R,b.length),M.init(),b.push(M),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let It=P.xr.getDepthSensingMesh();It!==null&&Rr(It,W,-1/0,P.sortObjects)}Rr(R,W,0,P.sortObjects),M.finish(),U!==null&&U.updateLights(A.state.lightsArray),P.sortObjects===!0&&M.sort(Gt,Kt),Ze=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Ze&&B.addToRenderList(M,R),this.info.autoReset===!0&&this.info.reset(),Ae===!0&&st.beginShadows();let Z=A.state.shadowsArray;if(mt.render(Z,R,W),Ae===!0&&st.endShadows(),(j&&N.hasRenderPass())===!1){let It=M.opaque,Rt=M.transmissive;if(A.setupLights(),W.isArrayCamera){let Lt=W.cameras;if(Rt.length>0)for(let Vt=0,ie=Lt.length;Vt<ie;Vt++){let me=Lt[Vt];Hi(It,Rt,R,me)}Ze&&B.render(R);for(let Vt=0,ie=Lt.length;Vt<ie;Vt++){let me=Lt[Vt];va(M,R,me,me.viewport)}}else Rt.length>0&&Hi(It,Rt,R,W),Ze&&B.render(R),va(M,R,W)}et!==null&&z===0&&(Yt.updateMultisampleRenderTarget(et),Yt.updateRenderTargetMipmap(et)),j&&N.end(P),R.isScene===!0&&R.onAfterRender(P,R,W),St.resetDefaultState(),$=-1,X=null,w.pop(),w.length>0?(A=w[w.length-1],Yt.setTextureUnits(A.state.textureUnits),Ae===!0&&st.setGlobalState(P.clippingPlanes,A.state.camera)):A=null,b.pop(),b.length>0?M=b[b.length-1]:M=null,U!==null&&U.renderEnd()};function Rr(R,W,Q,j){if(R.visible===!1)return;if(R.layers.test(W.layers)){if(R.isGroup)Q=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(W);else if(R.isLight)A.pushLight(R),R.castShadow&&A.pushShadow(R);else if(R.isSprite){let It=W.isArrayCamera?Fe:Jt;if(!R.frustumCulled||R.intersectsFrustum(It)){j&&te.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ft);let Rt=ft.update(R),Lt=R.material;Lt.visible&&M.push(R,Rt,Lt,Q,te.z,null,W)}}else if(R.isMesh||R.isLine||R.isPoints){let It=W.isArrayCamera?Fe:Jt;if(!R.frustumCulled||R.intersectsFrustum(It)){let Rt=ft.update(R),Lt=R.material;if(j&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),te.copy(R.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),te.copy(Rt.boundingSphere.center)),te.applyMatrix4(R.matrixWorld).applyMatrix4(Ft)),Array.isArray(Lt)){let Vt=Rt.groups;for(let ie=0,me=Vt.length;ie<me;ie++){let Bt=Vt[ie],ge=Lt[Bt.materialIndex];ge&&ge.visible&&M.push(R,Rt,ge,Q,te.z,Bt,W)}}else Lt.visible&&M.push(R,Rt,Lt,Q,te.z,null,W)}}}let Tt=R.children;for(let It=0,Rt=Tt.length;It<Rt;It++)Rr(Tt[It],W,Q,j)}function va(R,W,Q,j){let{opaque:Z,transmissive:Tt,transparent:It}=R;A.setupLightsView(Q),Ae===!0&&st.setGlobalState(P.clippingPlanes,Q),j&&At.viewport(tt.copy(j)),Z.length>0&&fn(Z,W,Q),Tt.length>0&&fn(Tt,W,Q),It.length>0&&fn(It,W,Q),At.buffers.depth.setTest(!0),At.buffers.depth.setMask(!0),At.buffers.color.setMask(!0),At.setPolygonOffset(!1)}function Hi(R,W,Q,j){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[j.id]===void 0){let Bt=Xt.has("EXT_color_buffer_half_float")||Xt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[j.id]=new Ri(1,1,{generateMipmaps:!0,type:Bt?rr:di,minFilter:qr,samples:Math.max(4,ce.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:be.workingColorSpace})}let Tt=A.state.transmissionRenderTarget[j.id],It=j.viewport||tt;Tt.setSize(It.z*P.transmissionResolutionScale,It.w*P.transmissionResolutionScale);let Rt=P.getRenderTarget(),Lt=P.getActiveCubeFace(),Vt=P.getActiveMipmapLevel();P.setRenderTarget(Tt),P.getClearColor(J),dt=P.getClearAlpha(),dt<1&&P.setClearColor(16777215,.5),P.clear(),Ze&&B.render(Q);let ie=P.toneMapping;P.toneMapping=br;let me=j.viewport;if(j.viewport!==void 0&&(j.viewport=void 0),A.setupLightsView(j),Ae===!0&&st.setGlobalState(P.clippingPlanes,j),fn(R,Q,j),Yt.updateMultisampleRenderTarget(Tt),Yt.updateRenderTargetMipmap(Tt),Xt.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let ge=0,ln=W.length;ge<ln;ge++){let Ne=W[ge],{object:De,geometry:En,material:Ot,group:vn}=Ne;if(Ot.side===Vi&&De.layers.test(j.layers)){let ve=Ot.side;Ot.side=ci,Ot.needsUpdate=!0,yn(De,Q,j,En,Ot,vn),Ot.side=ve,Ot.needsUpdate=!0,Bt=!0}}Bt===!0&&(Yt.updateMultisampleRenderTarget(Tt),Yt.updateRenderTargetMipmap(Tt))}P.setRenderTarget(Rt,Lt,Vt),P.setClearColor(J,dt),me!==void 0&&(j.viewport=me),P.toneMapping=ie}function fn(R,W,Q){let j=W.isScene===!0?W.overrideMaterial:null;for(let Z=0,Tt=R.length;Z<Tt;Z++){let It=R[Z],{object:Rt,geometry:Lt,group:Vt}=It,ie=It.material;ie.allowOverride===!0&&j!==null&&(ie=j),Rt.layers.test(Q.layers)&&yn(Rt,W,Q,Lt,ie,Vt)}}function yn(R,W,Q,j,Z,Tt){U!==null&&Z.isNodeMaterial&&U.setObject(R,Z),R.onBeforeRender(P,W,Q,j,Z,Tt),R.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Z.onBeforeRender(P,W,Q,j,R,Tt),Z.transparent===!0&&Z.side===Vi&&Z.forceSinglePass===!1?(Z.side=ci,Z.needsUpdate=!0,P.renderBufferDirect(Q,W,j,Z,R,Tt),Z.side=Ms,Z.needsUpdate=!0,P.renderBufferDirect(Q,W,j,Z,R,Tt),Z.side=Vi):P.renderBufferDirect(Q,W,j,Z,R,Tt),R.onAfterRender(P,W,Q,j,Z,Tt)}function xn(R){let W=0;for(let Q of R)Q.texture!==null&&W++;return W}function lr(R,W,Q){W.isScene!==!0&&(W=je);let j=Ht.get(R),Z=A.state.lights,Tt=A.state.shadowsArray,It=Z.state.version,Rt=at.getParameters(R,Z.state,Tt,W,Q,A.state.lightProbeGridArray),Lt=at.getProgramCacheKey(Rt),Vt=j.programs;j.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?W.environment:null,j.fog=W.fog;let ie=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;j.envMap=L.get(R.envMap||j.environment,ie),j.envMapRotation=j.environment!==null&&R.envMap===null?W.environmentRotation:R.envMapRotation,Vt===void 0&&(R.addEventListener("dispose",fe),Vt=new Map,j.programs=Vt,j.programVariants=new Map);let me=Vt.get(Lt);if(me!==void 0){if(j.currentProgram===me&&j.lightsStateVersion===It)return _a(R,Rt),me}else Rt.uniforms=at.getUniforms(R),U!==null&&R.isNodeMaterial&&U.build(R,Q,Rt),R.onBeforeCompile(Rt,P),me=at.acquireProgram(Rt,Lt),Vt.set(Lt,me),j.uniforms=Rt.uniforms;let Bt=j.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Bt.clippingPlanes=st.uniform),_a(R,Rt),j.needsLights=Zr(R),j.lightsStateVersion=It,j.needsLights&&(Bt.ambientLightColor.value=Z.state.ambient,Bt.lightProbe.value=Z.state.probe,Bt.sunLights.value=Z.state.sun,Bt.sunLightShadows.value=Z.state.sunShadow,Bt.directionalLights.value=Z.state.directional,Bt.directionalLightShadows.value=Z.state.directionalShadow,Bt.spotLights.value=Z.state.spot,Bt.spotLightShadows.value=Z.state.spotShadow,Bt.rectAreaLights.value=Z.state.rectArea,Bt.ltc_1.value=Z.state.rectAreaLTC1,Bt.ltc_2.value=Z.state.rectAreaLTC2,Bt.pointLights.value=Z.state.point,Bt.pointLightShadows.value=Z.state.pointShadow,Bt.hemisphereLights.value=Z.state.hemi,Bt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Bt.sunShadowCascade.value=Z.state.sunShadowCascade,Bt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Bt.spotLightMatrix.value=Z.state.spotLightMatrix,Bt.spotLightMap.value=Z.state.spotLightMap,Bt.pointShadowMatrix.value=Z.state.pointShadowMatrix),j.numLightProbeGrids=xn(A.state.lightProbeGridArray),j.currentProgram=me,j.uniformsList=null,me}function mi(R,W,Q,j,Z){let Tt=Ht.get(R),It=Tt.currentProgram.id+","+j+","+Z,Rt=Tt.programVariants.get(It);return Rt===void 0?(Rt=lr(R,W,Q),Tt.programVariants.set(It,Rt)):(Tt.currentProgram=Rt,Tt.uniformsList=null,Tt.outputColorSpace=j,Tt.toneMapping=Z),Rt}function jr(R){if(R.uniformsList===null){let W=R.currentProgram.getUniforms();R.uniformsList=fa.seqWithValue(W.seq,R.uniforms)}return R.uniformsList}function _a(R,W){let Q=Ht.get(R);Q.outputColorSpace=W.outputColorSpace,Q.batching=W.batching,Q.batchingColor=W.batchingColor,Q.instancing=W.instancing,Q.instancingColor=W.instancingColor,Q.instancingMorph=W.instancingMorph,Q.skinning=W.skinning,Q.morphTargets=W.morphTargets,Q.morphNormals=W.morphNormals,Q.morphColors=W.morphColors,Q.morphTargetsCount=W.morphTargetsCount,Q.numClippingPlanes=W.numClippingPlanes,Q.numIntersection=W.numClipIntersection,Q.vertexAlphas=W.vertexAlphas,Q.vertexTangents=W.vertexTangents,Q.toneMapping=W.toneMapping}function ba(R,W,Q,j,Z){W.isScene!==!0&&(W=je),Yt.resetTextureUnits();let Tt=W.fog,It=j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial?W.environment:null,Rt=et===null?P.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:be.workingColorSpace,Lt=j.isMeshStandardMaterial||j.isMeshLambertMaterial&&!j.envMap||j.isMeshPhongMaterial&&!j.envMap,Vt=L.get(j.envMap||It,Lt),ie=j.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,me=!!Q.attributes.tangent&&(!!j.normalMap||j.anisotropy>0),Bt=!!Q.morphAttributes.position,ge=!!Q.morphAttributes.normal,ln=!!Q.morphAttributes.color,Ne=br;j.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(Ne=P.toneMapping);let De=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,En=De!==void 0?De.length:0,Ot=Ht.get(j),vn=A.state.lights;if(Ae===!0&&(hn===!0||R!==X)){let Oe=R===X&&j.id===$;st.setState(j,R,Oe)}let ve=!1,Cr=!1;j.version===Ot.__version?Ot.needsLights&&Ot.lightsStateVersion!==vn.state.version||Z.isBatchedMesh&&Ot.batching===!1||!Z.isBatchedMesh&&Ot.batching===!0||Z.isBatchedMesh&&Ot.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ot.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ot.instancing===!1||!Z.isInstancedMesh&&Ot.instancing===!0||Z.isSkinnedMesh&&Ot.skinning===!1||!Z.isSkinnedMesh&&Ot.skinning===!0||Z.isInstancedMesh&&Ot.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ot.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ot.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ot.instancingMorph===!1&&Z.morphTexture!==null||Ot.envMap!==Vt||j.fog===!0&&Ot.fog!==Tt||Ot.numClippingPlanes!==void 0&&(Ot.numClippingPlanes!==st.numPlanes||Ot.numIntersection!==st.numIntersection)||Ot.vertexAlphas!==ie||Ot.vertexTangents!==me||Ot.morphTargets!==Bt||Ot.morphNormals!==ge||Ot.morphColors!==ln||Ot.morphTargetsCount!==En||Ot.numLightProbeGrids!==xn(A.state.lightProbeGridArray)?ve=!0:(Ot.outputColorSpace!==Rt||Ot.toneMapping!==Ne)&&(Cr=!0):(ve=!0,Ot.__version=j.version);let _n=Ot.currentProgram;(ve===!0||Cr===!0)&&(_n=Cr===!0?mi(j,W,Z,Rt,Ne):lr(j,W,Z),U&&j.isNodeMaterial&&U.onUpdateProgram(j,_n,Ot));let co=!1,cr=!1,Pr=!1,de=_n.getUniforms(),dn=Ot.uniforms;if(At.useProgram(_n.program)&&(co=!0,cr=!0,Pr=!0),j.id!==$&&($=j.id,cr=!0),co||X!==R){At.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),de.setValue(k,"projectionMatrix",R.projectionMatrix),de.setValue(k,"viewMatrix",R.matrixWorldInverse);let bn=de.map.cameraPosition;bn!==void 0&&bn.setValue(k,xe.setFromMatrixPosition(R.matrixWorld)),ce.logarithmicDepthBuffer&&de.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(j.isMeshPhongMaterial||j.isMeshToonMaterial||j.isMeshLambertMaterial||j.isMeshBasicMaterial||j.isMeshStandardMaterial||j.isShaderMaterial)&&de.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),X!==R&&(X=R,cr=!0,Pr=!0)}if(Ot.needsLights&&(vn.state.sunShadowMap.length>0&&de.setValue(k,"sunShadowMap",vn.state.sunShadowMap,Yt),vn.state.directionalShadowMap.length>0&&de.setValue(k,"directionalShadowMap",vn.state.directionalShadowMap,Yt),vn.state.spotShadowMap.length>0&&de.setValue(k,"spotShadowMap",vn.state.spotShadowMap,Yt),vn.state.pointShadowMap.length>0&&de.setValue(k,"pointShadowMap",vn.state.pointShadowMap,Yt)),Z.isSkinnedMesh){de.setOptional(k,Z,"bindMatrix"),de.setOptional(k,Z,"bindMatrixInverse");let Oe=Z.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),de.setValue(k,"boneTexture",Oe.boneTexture,Yt))}Z.isBatchedMesh&&(de.setOptional(k,Z,"batchingTexture"),de.setValue(k,"batchingTexture",Z._matricesTexture,Yt),de.setOptional(k,Z,"batchingIdTexture"),de.setValue(k,"batchingIdTexture",Z._indirectTexture,Yt),de.setOptional(k,Z,"batchingColorTexture"),Z._colorsTexture!==null&&de.setValue(k,"batchingColorTexture",Z._colorsTexture,Yt));let Qn=Q.morphAttributes;if((Qn.position!==void 0||Qn.normal!==void 0||Qn.color!==void 0)&&ot.update(Z,Q,_n),(cr||Ot.receiveShadow!==Z.receiveShadow)&&(Ot.receiveShadow=Z.receiveShadow,de.setValue(k,"receiveShadow",Z.receiveShadow)),(j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial)&&j.envMap===null&&W.environment!==null&&(dn.envMapIntensity.value=W.environmentIntensity),dn.dfgLUT!==void 0&&(dn.dfgLUT.value=MP()),cr){if(de.setValue(k,"toneMappingExposure",P.toneMappingExposure),Ot.needsLights&&ao(dn,Pr),Tt&&j.fog===!0&&_t.refreshFogUniforms(dn,Tt),_t.refreshMaterialUniforms(dn,j,yt,bt,A.state.transmissionRenderTarget[R.id]),Ot.needsLights&&Ot.numLightProbeGrids>0){let Oe=v,bn=0;for(let Yn of A.state.lightProbeGridArray)Yn.texture!==null&&(Oe.textures[bn]=Yn.texture,Oe.min[bn]=Yn.boundingBox.min,Oe.max[bn]=Yn.boundingBox.max,Oe.resolution[bn]=Yn.resolution,bn++);for(let Yn in Oe)Oe[Yn].length=bn;dn.probesSH.value=Oe.textures,dn.probesMin.value=Oe.min,dn.probesMax.value=Oe.max,dn.probesResolution.value=Oe.resolution}fa.upload(k,jr(Ot),dn,Yt)}if(j.isShaderMaterial&&j.uniformsNeedUpdate===!0&&(fa.upload(k,jr(Ot),dn,Yt),j.uniformsNeedUpdate=!1),j.isSpriteMaterial&&de.setValue(k,"center",Z.center),de.setValue(k,"modelViewMatrix",Z.modelViewMatrix),de.setValue(k,"normalMatrix",Z.normalMatrix),de.setValue(k,"modelMatrix",Z.matrixWorld),j.uniformsGroups!==void 0){let Oe=j.uniformsGroups;for(let bn=0,Yn=Oe.length;bn<Yn;bn++){let Zl=Oe[bn];Wt.update(Zl,_n),Wt.bind(Zl,_n)}}return _n}function ao(R,W){R.ambientLightColor.needsUpdate=W,R.lightProbe.needsUpdate=W,R.sunLights.needsUpdate=W,R.sunLightShadows.needsUpdate=W,R.directionalLights.needsUpdate=W,R.directionalLightShadows.needsUpdate=W,R.pointLights.needsUpdate=W,R.pointLightShadows.needsUpdate=W,R.spotLights.needsUpdate=W,R.spotLightShadows.needsUpdate=W,R.rectAreaLights.needsUpdate=W,R.hemisphereLights.needsUpdate=W}function Zr(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(R,W,Q){let j=Ht.get(R);j.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,j.__autoAllocateDepthBuffer===!1&&(j.__useRenderToTexture=!1),Ht.get(R.texture).__webglTexture=W,Ht.get(R.depthTexture).__webglTexture=j.__autoAllocateDepthBuffer?void 0:Q,j.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,W){let Q=Ht.get(R);Q.__webglFramebuffer=W,Q.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(R,W=0,Q=0){et=R,G=W,z=Q;let j=null,Z=!1,Tt=!1;if(R){let Rt=Ht.get(R);if(Rt.__useDefaultFramebuffer!==void 0){At.bindFramebuffer(k.FRAMEBUFFER,Rt.__webglFramebuffer),tt.copy(R.viewport),ht.copy(R.scissor),ct=R.scissorTest,At.viewport(tt),At.scissor(ht),At.setScissorTest(ct),$=-1;return}else if(Rt.__webglFramebuffer===void 0)Yt.setupRenderTarget(R);else if(Rt.__hasExternalTextures)Yt.rebindTextures(R,Ht.get(R.texture).__webglTexture,Ht.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let ie=R.depthTexture;if(Rt.__boundDepthTexture!==ie){if(ie!==null&&Ht.has(ie)&&(R.width!==ie.image.width||R.height!==ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Yt.setupDepthRenderbuffer(R)}}let Lt=R.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Tt=!0);let Vt=Ht.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Vt[W])?j=Vt[W][Q]:j=Vt[W],Z=!0):R.samples>0&&Yt.useMultisampledRTT(R)===!1?j=Ht.get(R).__webglMultisampledFramebuffer:Array.isArray(Vt)?j=Vt[Q]:j=Vt,tt.copy(R.viewport),ht.copy(R.scissor),ct=R.scissorTest}else tt.copy(zt).multiplyScalar(yt).floor(),ht.copy(le).multiplyScalar(yt).floor(),ct=oe;if(Q!==0&&(j=V),At.bindFramebuffer(k.FRAMEBUFFER,j)&&At.drawBuffers(R,j),At.viewport(tt),At.scissor(ht),At.setScissorTest(ct),Z){let Rt=Ht.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+W,Rt.__webglTexture,Q)}else if(Tt){let Rt=W;for(let Lt=0;Lt<R.textures.length;Lt++){let Vt=Ht.get(R.textures[Lt]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Lt,Vt.__webglTexture,Q,Rt)}}else if(R!==null&&Q!==0){let Rt=Ht.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Rt.__webglTexture,Q)}$=-1};function lo(R){let W=Ht.get(R);return(W.__readFormat!==R.format||W.__readType!==R.type)&&(W.__readFormat=R.format,W.__readType=R.type,W.__formatReadable=ce.textureFormatReadable(R.format),W.__typeReadable=ce.textureTypeReadable(R.type)),W}this.readRenderTargetPixels=function(R,W,Q,j,Z,Tt,It,Rt=0){if(!(R&&R.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Ht.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){At.bindFramebuffer(k.FRAMEBUFFER,Lt);try{let Vt=R.textures[Rt],ie=Vt.format,me=Vt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Bt=lo(Vt);if(Bt.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=R.width-j&&Q>=0&&Q<=R.height-Z&&k.readPixels(W,Q,j,Z,vt.convert(ie),vt.convert(me),Tt)}finally{let Vt=et!==null?Ht.get(et).__webglFramebuffer:null;At.bindFramebuffer(k.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(R,W,Q,j,Z,Tt,It,Rt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Ht.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(W>=0&&W<=R.width-j&&Q>=0&&Q<=R.height-Z){At.bindFramebuffer(k.FRAMEBUFFER,Lt);let Vt=R.textures[Rt],ie=Vt.format,me=Vt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Bt=lo(Vt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ge=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ge),k.bufferData(k.PIXEL_PACK_BUFFER,Tt.byteLength,k.STREAM_READ),k.readPixels(W,Q,j,Z,vt.convert(ie),vt.convert(me),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let ln=et!==null?Ht.get(et).__webglFramebuffer:null;At.bindFramebuffer(k.FRAMEBUFFER,ln);let Ne=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await p_(k,Ne,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ge),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Tt),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(ge),k.deleteSync(Ne),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,W=null,Q=0){let j=Math.pow(2,-Q),Z=Math.floor(R.image.width*j),Tt=Math.floor(R.image.height*j),It=W!==null?W.x:0,Rt=W!==null?W.y:0;Yt.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,It,Rt,Z,Tt),At.unbindTexture()},this.copyTextureToTexture=function(R,W,Q=null,j=null,Z=0,Tt=0){let It,Rt,Lt,Vt,ie,me,Bt,ge,ln,Ne=R.isCompressedTexture?R.mipmaps[Tt]:R.image;if(Q!==null)It=Q.max.x-Q.min.x,Rt=Q.max.y-Q.min.y,Lt=Q.isBox3?Q.max.z-Q.min.z:1,Vt=Q.min.x,ie=Q.min.y,me=Q.isBox3?Q.min.z:0;else{let de=Math.pow(2,-Z);It=Math.floor(Ne.width*de),Rt=Math.floor(Ne.height*de),R.isDataArrayTexture?Lt=Ne.depth:R.isData3DTexture?Lt=Math.floor(Ne.depth*de):Lt=1,Vt=0,ie=0,me=0}j!==null?(Bt=j.x,ge=j.y,ln=j.z):(Bt=0,ge=0,ln=0);let De=vt.convert(W.format),En=vt.convert(W.type),Ot;W.isData3DTexture?(Yt.setTexture3D(W,0),Ot=k.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Yt.setTexture2DArray(W,0),Ot=k.TEXTURE_2D_ARRAY):(Yt.setTexture2D(W,0),Ot=k.TEXTURE_2D),At.activeTexture(k.TEXTURE0),At.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,W.flipY),At.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),At.pixelStorei(k.UNPACK_ALIGNMENT,W.unpackAlignment);let vn=At.getParameter(k.UNPACK_ROW_LENGTH),ve=At.getParameter(k.UNPACK_IMAGE_HEIGHT),Cr=At.getParameter(k.UNPACK_SKIP_PIXELS),_n=At.getParameter(k.UNPACK_SKIP_ROWS),co=At.getParameter(k.UNPACK_SKIP_IMAGES);At.pixelStorei(k.UNPACK_ROW_LENGTH,Ne.width),At.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ne.height),At.pixelStorei(k.UNPACK_SKIP_PIXELS,Vt),At.pixelStorei(k.UNPACK_SKIP_ROWS,ie),At.pixelStorei(k.UNPACK_SKIP_IMAGES,me);let cr=R.isDataArrayTexture||R.isData3DTexture,Pr=W.isDataArrayTexture||W.isData3DTexture;if(R.isDepthTexture){let de=Ht.get(R),dn=Ht.get(W),Qn=Ht.get(de.__renderTarget),Oe=Ht.get(dn.__renderTarget);At.bindFramebuffer(k.READ_FRAMEBUFFER,Qn.__webglFramebuffer),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let bn=0;bn<Lt;bn++)cr&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ht.get(R).__webglTexture,Z,me+bn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ht.get(W).__webglTexture,Tt,ln+bn)),k.blitFramebuffer(Vt,ie,Vt+It,ie+Rt,Bt,ge,Bt+It,ge+Rt,k.DEPTH_BUFFER_BIT,k.NEAREST);At.bindFramebuffer(k.READ_FRAMEBUFFER,null),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Z!==0||R.isRenderTargetTexture||Ht.has(R)){let de=Ht.get(R),dn=Ht.get(W);At.bindFramebuffer(k.READ_FRAMEBUFFER,C),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,D);for(let Qn=0;Qn<Lt;Qn++)cr?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,de.__webglTexture,Z,me+Qn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,de.__webglTexture,Z),Pr?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,dn.__webglTexture,Tt,ln+Qn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,dn.__webglTexture,Tt),Z!==0?k.blitFramebuffer(Vt,ie,Vt+It,ie+Rt,Bt,ge,Bt+It,ge+Rt,k.COLOR_BUFFER_BIT,k.NEAREST):Pr?k.copyTexSubImage3D(Ot,Tt,Bt,ge,ln+Qn,Vt,ie,It,Rt):k.copyTexSubImage2D(Ot,Tt,Bt,ge,Vt,ie,It,Rt);At.bindFramebuffer(k.READ_FRAMEBUFFER,null),At.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Pr?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(Ot,Tt,Bt,ge,ln,It,Rt,Lt,De,En,Ne.data):W.isCompressedArrayTexture?k.compressedTexSubImage3D(Ot,Tt,Bt,ge,ln,It,Rt,Lt,De,Ne.data):k.texSubImage3D(Ot,Tt,Bt,ge,ln,It,Rt,Lt,De,En,Ne):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,ge,It,Rt,De,En,Ne.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Tt,Bt,ge,Ne.width,Ne.height,De,Ne.data):k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,ge,It,Rt,De,En,Ne);At.pixelStorei(k.UNPACK_ROW_LENGTH,vn),At.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ve),At.pixelStorei(k.UNPACK_SKIP_PIXELS,Cr),At.pixelStorei(k.UNPACK_SKIP_ROWS,_n),At.pixelStorei(k.UNPACK_SKIP_IMAGES,co),Tt===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&k.generateMipmap(Ot),At.unbindTexture()},this.initRenderTarget=function(R){Ht.get(R).__webglFramebuffer===void 0&&Yt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Yt.setTextureCube(R,0):R.isData3DTexture?Yt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Yt.setTexture2DArray(R,0):Yt.setTexture2D(R,0),At.unbindTexture()},this.resetState=function(){G=0,z=0,et=null,At.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=be._getDrawingBufferColorSpace(t),e.unpackColorSpace=be._getUnpackColorSpace()}};var K_={type:"change"},dm={type:"start"},Q_={type:"end"},Oh=new $s,J_=new Ti,SP=Math.cos(70*or.DEG2RAD),In=new H,pi=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},fm=1e-6,Uh=class extends Al{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new H,this.cursor=new H,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:bs.ROTATE,MIDDLE:bs.DOLLY,RIGHT:bs.PAN},this.touches={ONE:ws.ROTATE,TWO:ws.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new H,this._lastQuaternion=new zn,this._lastTargetPosition=new H,this._quat=new zn().setFromUnitVectors(t.up,new H(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new _s,this._sphericalDelta=new _s,this._scale=1,this._panOffset=new H,this._rotateStart=new Zt,this._rotateEnd=new Zt,this._rotateDelta=new Zt,this._panStart=new Zt,this._panEnd=new Zt,this._panDelta=new Zt,this._dollyStart=new Zt,this._dollyEnd=new Zt,this._dollyDelta=new Zt,this._dollyDirection=new H,this._mouse=new Zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=EP.bind(this),this._onPointerDown=AP.bind(this),this._onPointerUp=TP.bind(this),this._onContextMenu=NP.bind(this),this._onMouseWheel=PP.bind(this),this._onKeyDown=IP.bind(this),this._onTouchStart=LP.bind(this),this._onTouchMove=FP.bind(this),this._onMouseDown=RP.bind(this),this._onMouseMove=CP.bind(this),this._interceptControlDown=DP.bind(this),this._interceptControlUp=OP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(K_),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;In.copy(e).sub(this.target),In.applyQuaternion(this._quat),this._spherical.setFromVector3(In),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(n)&&isFinite(r)&&(n<-Math.PI?n+=pi:n>Math.PI&&(n-=pi),r<-Math.PI?r+=pi:r>Math.PI&&(r-=pi),n<=r?this._spherical.theta=Math.max(n,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+r)/2?Math.max(n,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let s=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),s=o!=this._spherical.radius}if(In.setFromSpherical(this._spherical),In.applyQuaternion(this._quatInverse),e.copy(this.target).add(In),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=In.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),s=!!l}else if(this.object.isOrthographicCamera){let a=new H(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),s=l!==this.object.zoom;let c=new H(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=In.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Oh.origin.copy(this.object.position),Oh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Oh.direction))<SP?this.object.lookAt(this.target):(J_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Oh.intersectPlane(J_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),s=!0)}return this._scale=1,this._performCursorZoom=!1,s||this._lastPosition.distanceToSquared(this.object.position)>fm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>fm||this._lastTargetPosition.distanceToSquared(this.target)>fm?(this.dispatchEvent(K_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?pi/60*this.autoRotateSpeed*t:pi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){In.setFromMatrixColumn(e,0),In.multiplyScalar(-t),this._panOffset.add(In)}_panUp(t,e){this.screenSpacePanning===!0?In.setFromMatrixColumn(e,1):(In.setFromMatrixColumn(e,0),In.crossVectors(this.object.up,In)),In.multiplyScalar(t),this._panOffset.add(In)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;In.copy(r).sub(this.target);let s=In.length();s*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*s/n.clientHeight,this.object.matrix),this._panUp(2*e*s/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),r=t-n.left,s=e-n.top,o=n.width,a=n.height;this._mouse.x=r/o*2-1,this._mouse.y=-(s/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._rotateStart.set(n,r)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._panStart.set(n,r)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,r=t.pageY-e.y,s=Math.sqrt(n*n+r*r);this._dollyStart.set(0,s)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),r=.5*(t.pageX+n.x),s=.5*(t.pageY+n.y);this._rotateEnd.set(r,s)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),r=.5*(t.pageY+e.y);this._panEnd.set(n,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,r=t.pageY-e.y,s=Math.sqrt(n*n+r*r);this._dollyEnd.set(0,s),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function AP(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function EP(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function TP(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Q_),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function RP(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case bs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case bs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case bs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(dm)}function CP(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function PP(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent(dm),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Q_))}function IP(i){this.enabled!==!1&&this._handleKeyDown(i)}function LP(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case ws.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case ws.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case ws.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case ws.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(dm)}function FP(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function NP(i){this.enabled!==!1&&i.preventDefault()}function DP(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function OP(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var zl=class{distance;first;last;low;high;constructor(t,e,n,r,s){let[o,a]=[1/0,-1/0];[this.low,this.high]=[n*r,n*s],t.forEach((l,c)=>{o=Math.min(o,l+this.low*e[c]),a=Math.max(a,l+this.high*e[c])}),[this.first,this.last]=[o,a],this.distance=(a-o)/(this.high-this.low)}from(t){return(this.first+this.last-(this.low+this.high)*t)/2}};var kh=[-.91,.91,-.91,.91];function tb(i,t,e,n){if(i.width===0||i.height===0)return[kh];let r=y=>2*(y-i.left)/i.width-1,s=y=>1-2*(y-i.top)/i.height,o=y=>y.height>0,a=[o(t)?r(t.right):-1,o(e)?r(e.left):1,o(n)?s(n.top):-1],l=[t,e].map(y=>o(y)?s(y.bottom):1),[c,u,h]=a,m=[[-1,1,h,Math.min(...l)],[-1,u,h,l[0]],[c,1,h,l[1]],[c,u,h,1]].map(([y,g,p,x])=>[y+.09,g-.09,p+.09,x-.09]).filter(([y,g,p,x])=>g-y>.7&&x-p>.7);return m.length?m:[kh]}var eb=["iso","front","side","top","tip"],UP={front:[1,0,.08],side:[0,-1,.08],top:[0,-.001,1],tip:[.62,-1,.4]},kP=.35,Bh=class{constructor(t,e,n,r,s){this.camera=t;this.canvas=e;this.reach=n;this.oblique=r;this.changed=s;this.controls=new Uh(t,e),this.controls.minDistance=.05*n,this.controls.maxDistance=40*n,this.controls.enableZoom=!1,this.controls.addEventListener("change",s),this.controls.addEventListener("start",this.turned),e.addEventListener("keydown",this.key),e.addEventListener("focus",this.zoomable),e.addEventListener("blur",this.zoomable)}camera;canvas;reach;oblique;changed;view="iso";places=[0,0,0];rooms=()=>[kh];preset=!1;controls;start=new H;end=new H;targetStart=new H;targetEnd=new H;offset=new H;spherical=new _s;began=0;gliding=0;show(t,e,n){this.view=t,this.preset=!0;let r=this.side(t);if(t==="tip"?this.end.copy(this.targetEnd.fromArray(e)).addScaledVector(r,.55*this.reach):this.fit(r),cancelAnimationFrame(this.gliding),!n)return this.place(1);this.start.copy(this.camera.position),this.targetStart.copy(this.controls.target),this.began=performance.now(),this.step(this.began)}refit(){if(this.view==="tip")return;let{camera:t,controls:e,offset:n}=this;this.fit(this.preset?this.side(this.view):n.copy(t.position).sub(e.target).normalize()),cancelAnimationFrame(this.gliding),this.place(1)}side(t){return this.offset.set(...t==="iso"?this.oblique:UP[t]).normalize()}get pose(){return[...this.camera.position.toArray(),...this.controls.target.toArray()]}set pose(t){this.preset=!1,cancelAnimationFrame(this.gliding),this.end.fromArray(t),this.targetEnd.fromArray(t,3),this.place(1)}take(t){this.view=t.view,this.preset=t.preset,this.camera.position.copy(t.camera.position),this.controls.target.copy(t.controls.target),this.controls.update()}follow(t){this.view==="tip"&&(this.offset.copy(this.camera.position).sub(this.controls.target),this.controls.target.fromArray(t),this.camera.position.copy(this.controls.target).add(this.offset),this.camera.lookAt(this.controls.target))}dispose(){cancelAnimationFrame(this.gliding),this.controls.dispose(),this.canvas.removeEventListener("keydown",this.key),this.canvas.removeEventListener("focus",this.zoomable),this.canvas.removeEventListener("blur",this.zoomable)}turned=()=>{this.preset=!1};zoomable=t=>{this.controls.enableZoom=t.type==="focus"};key=t=>{if(t.ctrlKey||t.metaKey||t.altKey)return;let e=or.degToRad(5),r={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[t.key];if(r&&t.shiftKey)this.pan(.04*r[0],-.04*r[1]);else if(r)this.turn(e*r[0],e*r[1],1);else if(t.key==="+"||t.key==="=")this.turn(0,0,1/1.15);else if(t.key==="-")this.turn(0,0,1.15);else return;this.turned(),t.preventDefault(),t.stopPropagation()};turn(t,e,n){let{camera:r,controls:s,offset:o,spherical:a}=this;o.copy(r.position).sub(s.target),a.setFromCartesianCoords(o.y,o.z,o.x),a.theta+=t,a.phi=or.clamp(a.phi+e,.001,Math.PI-.001),a.radius=or.clamp(a.radius*n,s.minDistance,s.maxDistance),o.setFromSpherical(a),r.position.set(o.z,o.x,o.y).add(s.target),s.update(),this.changed()}pan(t,e){let{camera:n,controls:r,offset:s}=this,o=n.position.distanceTo(r.target);for(let[a,l]of[[0,t],[1,e]])s.setFromMatrixColumn(n.matrix,a).multiplyScalar(l*o),n.position.add(s),r.target.add(s);r.update(),this.changed()}fit(t){let{camera:e,places:n,targetEnd:r}=this,s=Math.tan(or.degToRad(e.fov/2)),o=new H().crossVectors(e.up,t).normalize(),a=[o,new H().crossVectors(t,o),t],l=new H,c=a.map(x=>{let _=new Float64Array(n.length/3);for(let v=0;v<_.length;v++)_[v]=l.fromArray(n,3*v).dot(x);return _}),[u,h]=[Math.min,Math.max].map(x=>c[2].reduce((_,v)=>x(_,v))),f=Math.max(.3*this.reach,.6*(h-u)),d=(u+h)/2,m=c[2].map(x=>x-d),y=this.rooms().map(([x,_,v,M])=>{let A=[new zl(c[0],m,s*e.aspect,x,_),new zl(c[1],m,s,v,M)];return{aims:A,distance:Math.max(f,...A.map(b=>b.distance))}}),{aims:g,distance:p}=y.reduce((x,_)=>_.distance<x.distance?_:x);r.copy(t).multiplyScalar(d),g.forEach((x,_)=>r.addScaledVector(a[_],x.from(p))),this.end.copy(r).addScaledVector(t,p)}step=t=>{let e=Math.min(1,Math.max(0,(t-this.began)/1e3/kP));this.place(e*e*(3-2*e)),e<1&&(this.gliding=requestAnimationFrame(this.step))};place(t){this.camera.position.lerpVectors(t<1?this.start:this.end,this.end,t),this.controls.target.lerpVectors(t<1?this.targetStart:this.targetEnd,this.targetEnd,t),this.controls.update(),this.changed()}};var nb=[["reference","Nominal (ghost)"],["rigid","Undeformed (ghost)"],["traces","Paths of the tips"],["force","Contact force"],["surface","Surface"],["floor","Floor"],["apart","Side by side"]];var BP={iso:"Oblique",front:"Front",side:"Side",top:"Top",tip:"Tip (follows)"},pm=100;function Ue(i,t={},...e){let n=document.createElement(i);return Object.assign(n,t),n.append(...e),n}function rb(i,t,e,n,r,s){let o=Ue("div",{className:"scene-bar",role:"toolbar",ariaLabel:"The robot in space"}),a=mm("Colour",t,i.colour,u=>{i.colour=u,s.changed()});o.append(Ue("label",{},ib("Colour"),a)),n>1&&o.append(zP(i,n,s));let l=mm("View",eb.map(u=>[u,BP[u]]),"iso",u=>s.look(u));o.append(Ue("label",{},ib("View"),l));let c=Ue("button",{type:"button",ariaLabel:"Reset view"},"Reset");return c.addEventListener("click",()=>s.look(l.value)),o.append(c,GP(i,e,r,s)),o}function zP(i,t,e){let n=Ue("input",{type:"range",min:"0",max:String(pm),step:"1",value:String(Math.round(pm*Math.log(i.factor)/Math.log(t))),ariaLabel:"Deformation"}),r=Ue("output",{},`×${i.factor}`);return n.dataset.scene="factor",n.addEventListener("input",()=>{i.factor=VP(t**(Number(n.value)/pm)),r.textContent=n.ariaValueText=`×${i.factor}`,e.changed()}),n.title="How many times the displacement of each robot from itself without elasticity is enlarged; double click: to scale",n.addEventListener("dblclick",()=>{n.value="0",n.dispatchEvent(new Event("input"))}),Ue("label",{className:"scene-factor-row"},"Deformation",n,r)}function ib(i){return Ue("span",{className:"scene-name"},i)}function VP(i){return i<10?Math.round(10*i)/10:Math.round(i)}function GP(i,t,e,n){let r=Ue("div",{className:"scene-more"});for(let[o,a]of nb){if(!t.includes(o))continue;let l=Ue("input",{type:"checkbox",checked:i[o]});l.dataset.scene=o,l.addEventListener("change",()=>{i[o]=l.checked,n.changed(),o==="apart"&&n.look("iso")}),r.append(Ue("label",{},l,a))}e&&r.append(Ue("label",{},"Quality",HP(i,n)));let s=Ue("details",{},Ue("summary",{},"Show"),r);return s.addEventListener("keydown",o=>{o.key==="Escape"&&(s.open=!1,s.querySelector("summary")?.focus())}),s}function HP(i,t){return mm("Quality",[["auto","automatic"],["low","low"],["high","high"],["lines","lines alone"]],i.quality,n=>{i.quality=n,t.quality()})}function mm(i,t,e,n){let r=Ue("select",{ariaLabel:i},...t.map(([s,o])=>Ue("option",{value:s,textContent:o})));return r.value=e,r.addEventListener("change",()=>n(r.value)),r}var zh=[.62,-1,.55];function sb(i,t){let e=i.runs.map(({scene:a})=>WP(a)),n=Math.max(...e.map(a=>a.size)),r=a=>Math.min(1e3,Math.max(1,a*t/n)),s=n>1e-6*t,o=e[0];return{time:o.size>1e-6*t?i.runs[0].scene.times.data[o.frame]:0,factor:s?Number(r(.1).toPrecision(1)):1,most:s?Number(r(.3).toPrecision(2)):1,direction:s?qP(i.runs[0].scene,o.frame):zh}}function WP({line:i,rigid:t}){let[e,n]=[0,0];for(let s=0;t&&s<i.data.length;s+=3){let o=Math.hypot(...[0,1,2].map(a=>i.data[s+a]-t.data[s+a]));o>e&&([e,n]=[o,s])}let[,...r]=i.shape;return{size:e,frame:Math.floor(n/(r.reduce((s,o)=>s*o,1)||1))}}function qP({line:i,rigid:t},e){let n=i.data.length/i.shape[0],[r,s]=[[],[]];for(let c=e*n;c<(e+1)*n;c+=3){let u=(h,f=c)=>i.data[f+h];r.push([0,1,2].map(h=>u(h)-(t?.data[c+h]??u(h)))),c>e*n&&s.push([0,1,2].map(h=>u(h)-u(h,c-3)))}let o=(c,u)=>{let h=c.reduce((d,m)=>d+Math.hypot(...m),0)||1,f=d=>d.reduce((m,y,g)=>m+y*u[g],0);return c.reduce((d,m)=>d+Math.sqrt(Math.max(0,Math.hypot(...m)**2-f(m)**2)),0)/h},[a,l]=[zh,0];for(let c of[.55,.25,1.4])for(let u=0;u<8;u++){let h=Math.atan2(zh[1],zh[0])+u*Math.PI/4,f=[1.18*Math.cos(h),1.18*Math.sin(h),c],d=Math.hypot(...f),m=f.map(g=>g/d),y=o(r,m)+.7*o(s,m)+(u?0:.05);y>l+.02&&([a,l]=[f,y])}return a}function Vh(i,t,e,n){for(let r=0;4*r<i.length&&n>1;r++){let s=3*n*r,o=t[s+3]-t[s],a=t[s+4]-t[s+1],l=t[s+5]-t[s+2],c=e[s+3]-e[s],u=e[s+4]-e[s+1],h=e[s+5]-e[s+2],f=Math.hypot(o,a,l)*Math.hypot(c,u,h);f>0&&$P(i,4*r,a*h-l*u,l*c-o*h,o*u-a*c,f+o*c+a*u+l*h)}}function $P(i,t,e,n,r,s){let o=Math.hypot(e,n,r,s);if(o===0)return;let a=i[t]/o,l=i[t+1]/o,c=i[t+2]/o,u=i[t+3]/o;i[t]=s*a+e*u+n*c-r*l,i[t+1]=s*l-e*c+n*u+r*a,i[t+2]=s*c+e*l-n*a+r*u,i[t+3]=s*u-e*a-n*l-r*c}var Es=class{constructor(t){this.arrays=t;[this.frames,this.links,this.stations]=t.line.shape;let e=this.links*this.stations*3;this.line=new Float32Array(e),this.once=new Float32Array(e),this.planned=new Float32Array(e),this.rigid=t.rigid?new Float32Array(e):null,this.reference=t.reference?new Float32Array(e):null,this.roots=new Float32Array(this.links*4),this.values=new Float32Array(this.links*this.stations),this.tipPlace=this.nearestEnd()}arrays;links;stations;frames;line;rigid;reference;roots;values;tip=new Float32Array(3);tipReference=new Float32Array(3);force=new Float32Array(3);at=new Float32Array(3);frame=0;share=0;tipPlace;once;planned;seek(t,e,n){this.find(t);let{arrays:r}=this;this.mix(this.line,r.line),this.rigid&&r.rigid&&this.mix(this.rigid,r.rigid),this.reference&&r.reference&&this.mix(this.reference,r.reference),this.turn(),this.mix(this.tip,r.tip),r.tipReference&&this.mix(this.tipReference,r.tipReference),r.contact&&(this.mix(this.force,r.contact.force),this.mix(this.at,r.contact.at)),n&&this.mix(this.values,n),!(e===1||!this.rigid)&&(r.referenceRigid&&this.mix(this.planned,r.referenceRigid),this.enlarge(e,this.rigid,r.referenceRigid?this.planned:this.rigid))}path(t,e){let{arrays:n,frames:r}=this,s=t?n.tipReference:n.tip,o=t?n.reference:n.line,a=t&&n.referenceRigid||n.rigid;if(s===null)return null;let l=Float32Array.from(s.data);if(!a||!o||this.links===0)return l;let c=this.links*this.stations*3;for(let u=0;u<r;u++)for(let h=0;h<3;h++){let f=u*c+this.tipPlace+h;l[3*u+h]+=(e-1)*(o.data[f]-a.data[f])}return l}find(t){let e=this.arrays.times.data,n=0,r=this.frames-1;for(;r-n>1;){let o=n+r>>1;e[o]<=t?n=o:r=o}this.frame=n;let s=r>n?e[r]-e[n]:0;this.share=s>0?Math.min(1,Math.max(0,(t-e[n])/s)):0}mix(t,e){let n=t.length,r=this.frame*n,s=Math.min(this.frame+1,this.frames-1)*n,{data:o}=e;for(let a=0;a<n;a++){let l=o[r+a];t[a]=l+this.share*(o[s+a]-l)}}turn(){let{roots:t}=this;this.mix(t,this.arrays.roots);for(let e=0;e<t.length;e+=4){let n=Math.hypot(t[e],t[e+1],t[e+2],t[e+3])||1;for(let r=0;r<4;r++)t[e+r]/=n}}enlarge(t,e,n){let{line:r,reference:s,tipPlace:o}=this;for(let a=0;a<3&&this.links>0;a++){let l=(t-1)*(r[o+a]-e[o+a]);this.tip[a]+=l,this.at[a]+=l,s&&(this.tipReference[a]+=(t-1)*(s[o+a]-n[o+a]))}this.once.set(r);for(let a=0;a<r.length;a++)r[a]=e[a]+t*(r[a]-e[a]),s&&(s[a]=n[a]+t*(s[a]-n[a]));Vh(this.roots,this.once,r,this.stations)}nearestEnd(){let{line:t,tip:e}=this.arrays,n=0,r=1/0;for(let s=0;s<this.links;s++){let o=(s*this.stations+this.stations-1)*3,a=Math.hypot(...[0,1,2].map(l=>t.data[o+l]-e.data[l]));a<=r&&([n,r]=[o,a])}return n}};function Gh(i,t){return i!=="1"||t===0?Ua(i,Math.abs(t)):Math.abs(t)<.01?{factor:1e6,name:"µm/m"}:{factor:100,name:"%"}}function Mr(i){if(!Number.isFinite(i))return"–";let t=Math.abs(i);if(t!==0&&(t>=1e5||t<.001))return i.toExponential(2).replace("-","−");let e=t===0?0:Math.max(0,2-Math.floor(Math.log10(t)));return String(Number(i.toFixed(e))).replace("-","−")}function Vl(i){let t=10**Math.floor(Math.log10(i));return t*(i>=5*t?5:i>=2*t?2:1)}var pa=class{constructor(t,e,n,r){this.run=t;this.index=e;this.alone=n;this.own=r;this.motion=new Es(t.scene)}run;index;alone;own;motion;showsSurface=!0;aside=0;before=null;get colour(){return this.alone?this.own.real:this.own.runs[this.index%this.own.runs.length]}get referenceColour(){return this.alone?this.own.reference:this.own.rigid}get changed(){return this.before!==null}replace(t){let{scene:e}=this.run,n=new Es(t??e);this.before=t===null?null:this.before??new Es(e),this.motion=n}seek(t,e){let{motion:n}=this,r=n.arrays.colours.find(({id:s})=>s===e.colour)?.values??null;n.seek(t,e.factor,r),this.before?.seek(t,e.factor,null)}widen(t,e){let{arrays:n,links:r,stations:s}=this.motion,o=n.colours.find(l=>l.id===t)?.values.data,a=this.run.scene.links.map(l=>l.bends||Gl(t)==="all");if(o!==void 0)for(let l=0;l<o.length;l++)a[Math.floor(l/s)%r]&&(o[l]<e.low&&(e.low=o[l]),o[l]>e.high&&(e.high=o[l]))}};function Gl(i){return i==="run"?"none":i==="displacement"?"all":"bending"}var XP=10;function ma(i,t){let e=0;for(let{scene:n}of i){let r=n.contact?.force.data??[];for(let s=0;s+2<r.length;s+=3)e=Math.max(e,Math.hypot(r[s],r[s+1],r[s+2]))}return i.every(({scene:n})=>n.contact===null)?0:Vl(.35*t/(e||XP))}var YP=60;function ob(i,t,{reach:e,floor:n}){let r=ma(i.runs,e),s=[];for(let{scene:o}of i.runs){let{line:a,rigid:l,contact:c}=o,[u,h,f]=a.shape,d=Math.max(1,Math.ceil(u/YP));a.data.length&&s.push(a.data[0],a.data[1],n);for(let m=0;m<u;m+=d){for(let y=0;y<h*f;y+=Math.max(1,f>>1))for(let g=0,p=3*(m*h*f+y);g<3;g++,p++){let x=l?.data[p]??a.data[p];s.push(x+t*(a.data[p]-x))}for(let y=0,g=3*m;y<3;y++,g++)s.push(c?c.at.data[g]+r*c.force.data[g]:o.tip.data[g])}}return s}function ab(i){let t=new li,e=new H,n=.001,r=0;for(let{scene:l}of i.runs){for(let c of[l.line,l.tip])for(let u=0;u+2<c.data.length;u+=3)t.expandByPoint(e.fromArray(c.data,u));n=Math.max(n,jP(l.line.data,l.line.shape));for(let c of l.links)c.section?.sizes.data.forEach(u=>r=Math.max(r,u))}t.isEmpty()&&t.expandByPoint(e.set(0,0,0));let s=Math.max(n,t.getSize(e).length()/2),o=Math.min(Math.max(r,.012*n),.022*n),a=ZP(t,i,n);for(let{scene:l}of i.runs)l.line.data.length&&t.expandByPoint(e.fromArray(l.line.data).setZ(a));return{box:t,reach:n,cell:Vl(s/5),usual:o,least:.006*n,floor:a,opening:sb(i,n)}}function jP(i,[,t,e]){let n=0;for(let r=0;r<t;r++)for(let s=1;s<e;s++){let o=3*(r*e+s);n+=Math.hypot(i[o]-i[o-3],i[o+1]-i[o-2],i[o+2]-i[o-1])}return n}function ZP(i,t,e){let n=t.runs[0]?.scene.line.data[2]??0,r=i.max.z-i.min.z>.2*e&&n<e;if(i.min.z>=-.001*e&&r)return 0;let s=Vl(.1*e);return Math.floor((Math.min(i.min.z,n)-.12*e)/s)*s}var lb=new li,Hh=new H,ga=class extends Ml{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Xe(t,3)),this.setAttribute("uv",new Xe(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new vs(e,6,1);return this.setAttribute("instanceStart",new Bi(n,3,0)),this.setAttribute("instanceEnd",new Bi(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new vs(e,6,1);return this.setAttribute("instanceColorStart",new Bi(n,3,0)),this.setAttribute("instanceColorEnd",new Bi(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new dl(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new li);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),lb.setFromBufferAttribute(e),this.boundingBox.union(lb))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new tr),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let r=0;for(let s=0,o=t.count;s<o;s++)Hh.fromBufferAttribute(t,s),r=Math.max(r,n.distanceToSquared(Hh)),Hh.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(Hh));this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Pt.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Zt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ui.line={uniforms:Dl.merge([Pt.common,Pt.fog,Pt.line]),vertexShader:`
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
		`};var Ts=class extends zi{constructor(t){super({type:"LineMaterial",uniforms:Dl.clone(ui.line.uniforms),vertexShader:ui.line.vertexShader,fragmentShader:ui.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var gm=new Le,cb=new H,ub=new H,qn=new Le,$n=new Le,Sr=new Le,ym=new H,xm=new $e,Xn=new Sl,hb=new H,Wh=new li,qh=new tr,Ar=new Le,Er,no;function fb(i,t,e){return Ar.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),Ar.multiplyScalar(1/Ar.w),Ar.x=no/e.width,Ar.y=no/e.height,Ar.applyMatrix4(i.projectionMatrixInverse),Ar.multiplyScalar(1/Ar.w),Math.abs(Math.max(Ar.x,Ar.y))}function KP(i,t){let e=i.matrixWorld,n=i.geometry,r=n.attributes.instanceStart,s=n.attributes.instanceEnd,o=Math.min(n.instanceCount,r.count);for(let a=0,l=o;a<l;a++){Xn.start.fromBufferAttribute(r,a),Xn.end.fromBufferAttribute(s,a),Xn.applyMatrix4(e);let c=new H,u=new H;Er.distanceSqToSegment(Xn.start,Xn.end,u,c),u.distanceTo(c)<no*.5&&t.push({point:u,pointOnLine:c,distance:Er.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function JP(i,t,e){let n=t.projectionMatrix,s=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-t.near;Er.at(1,Sr),Sr.w=1,Sr.applyMatrix4(t.matrixWorldInverse),Sr.applyMatrix4(n),Sr.multiplyScalar(1/Sr.w),Sr.x*=s.x/2,Sr.y*=s.y/2,Sr.z=0,ym.copy(Sr),xm.multiplyMatrices(t.matrixWorldInverse,o);for(let f=0,d=u;f<d;f++){if(qn.fromBufferAttribute(l,f),$n.fromBufferAttribute(c,f),qn.w=1,$n.w=1,qn.applyMatrix4(xm),$n.applyMatrix4(xm),qn.z>h&&$n.z>h)continue;if(qn.z>h){let _=qn.z-$n.z,v=(qn.z-h)/_;qn.lerp($n,v)}else if($n.z>h){let _=$n.z-qn.z,v=($n.z-h)/_;$n.lerp(qn,v)}qn.applyMatrix4(n),$n.applyMatrix4(n),qn.multiplyScalar(1/qn.w),$n.multiplyScalar(1/$n.w),qn.x*=s.x/2,qn.y*=s.y/2,$n.x*=s.x/2,$n.y*=s.y/2,Xn.start.copy(qn),Xn.start.z=0,Xn.end.copy($n),Xn.end.z=0;let y=Xn.closestPointToPointParameter(ym,!0);Xn.at(y,hb);let g=or.lerp(qn.z,$n.z,y),p=g>=-1&&g<=1,x=ym.distanceTo(hb)<no*.5;if(p&&x){Xn.start.fromBufferAttribute(l,f),Xn.end.fromBufferAttribute(c,f),Xn.start.applyMatrix4(o),Xn.end.applyMatrix4(o);let _=new H,v=new H;Er.distanceSqToSegment(Xn.start,Xn.end,v,_),e.push({point:v,pointOnLine:_,distance:Er.origin.distanceTo(v),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var $h=class extends Ge{constructor(t=new ga,e=new Ts({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,r=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)cb.fromBufferAttribute(e,o),ub.fromBufferAttribute(n,o),r[a]=a===0?0:r[a-1],r[a+1]=r[a]+cb.distanceTo(ub);let s=new vs(r,2,1);return t.setAttribute("instanceDistanceStart",new Bi(s,1,0)),t.setAttribute("instanceDistanceEnd",new Bi(s,1,1)),this}raycast(t,e){let n=this.material.worldUnits,r=t.camera;if(r===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let s=t.params.Line2!==void 0&&t.params.Line2.threshold||0;Er=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;no=l.linewidth+s,a.boundingSphere===null&&a.computeBoundingSphere(),qh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=no*.5;else{let h=Math.max(r.near,qh.distanceToPoint(Er.origin));c=fb(r,h,l.resolution)}if(qh.radius+=c,Er.intersectsSphere(qh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Wh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=no*.5;else{let h=Math.max(r.near,Wh.distanceToPoint(Er.origin));u=fb(r,h,l.resolution)}Wh.expandByScalar(u),Er.intersectsBox(Wh)!==!1&&(n?KP(this,e):JP(this,r,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(gm),this.material.uniforms.resolution.value.set(gm.z,gm.w))}};var io=class extends ga{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,n=new Float32Array(2*e);for(let r=0;r<e;r+=3)n[2*r]=t[r],n[2*r+1]=t[r+1],n[2*r+2]=t[r+2],n[2*r+3]=t[r+3],n[2*r+4]=t[r+4],n[2*r+5]=t[r+5];return super.setPositions(n),this}setColors(t){let e=t.length-3,n=new Float32Array(2*e);for(let r=0;r<e;r+=3)n[2*r]=t[r],n[2*r+1]=t[r+1],n[2*r+2]=t[r+2],n[2*r+3]=t[r+3],n[2*r+4]=t[r+4],n[2*r+5]=t[r+5];return super.setColors(n),this}setFromPoints(t){let e=t.length-1,n=new Float32Array(6*e);for(let r=0;r<e;r++)n[6*r]=t[r].x,n[6*r+1]=t[r].y,n[6*r+2]=t[r].z||0,n[6*r+3]=t[r+1].x,n[6*r+4]=t[r+1].y,n[6*r+5]=t[r+1].z||0;return super.setPositions(n),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Xh=class extends $h{constructor(t=new io,e=new Ts({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var pb=new H(0,1,0),Yh=class{group=new kn;past;rest;length=0;constructor(t,e,n){this.past=new Xh(new io,new Ts({color:e,linewidth:2.5}));let r=new gl({color:e,transparent:!0,opacity:.7,dashSize:n,gapSize:n});this.rest=new sa(new on,r),this.past.frustumCulled=this.rest.frustumCulled=!1,this.group.add(this.past,this.rest),this.lay(t)}lay(t){this.length=t.length/3,this.rest.geometry.dispose(),this.past.geometry.dispose(),this.past.geometry=new io;let e=new Float32Array(this.length);for(let n=1;n<e.length;n++)e[n]=e[n-1]+Math.hypot(t[3*n]-t[3*n-3],t[3*n+1]-t[3*n-2],t[3*n+2]-t[3*n-1]);this.rest.geometry.setAttribute("position",new Ye(t,3)),this.rest.geometry.setAttribute("lineDistance",new Ye(e,1)),this.past.visible=this.length>1,this.past.visible&&this.past.geometry.setPositions(t)}seek(t){this.past.geometry.instanceCount=Math.min(t,this.length-1),this.rest.geometry.setDrawRange(t,this.length-t)}dispose(){[this.past.geometry,this.past.material,this.rest.geometry,this.rest.material].forEach(t=>t.dispose()),this.group.removeFromParent()}},jh=class{constructor(t,e,n){this.wide=e;this.scale=n;let r=new ia({color:t}),s=new _r(e,e,1,12).translate(0,.5,0),o=new fl(2.6*e,6*e,16).translate(0,-3*e,0);[this.shaft,this.head]=[new Ge(s,r),new Ge(o,r)],this.parts=[r,s,o],this.group.add(this.shaft,this.head)}wide;scale;group=new kn;shaft;head;parts;way=new H;turn=new zn;point(t,e){let n=this.way.fromArray(t).length(),r=n*this.scale;this.group.visible=r>.5*this.wide,this.group.visible&&(this.group.position.fromArray(e),this.group.quaternion.copy(this.turn.setFromUnitVectors(pb,this.way.divideScalar(n))),this.shaft.scale.set(1,Math.max(r-5*this.wide,1e-6),1),this.head.position.y=r)}dispose(){this.parts.forEach(t=>t.dispose()),this.group.removeFromParent()}};function mb(i,t,e,n){let r=new Ys({color:n,transparent:!0,opacity:.28,side:Vi,depthWrite:!1});return new Ge(vm(i,t,e),r)}var Hl=24;function vm(i,t,e){let n=[];for(let u=0;u+2<t.length;u+=3)n.push(new H(t[u],t[u+1],t[u+2]));let[r,s,o]=QP(i,n,e),a=n.map(s),[l,c]=[0,1].map(u=>{let h=a.map(f=>f[u]);return[h.reduce((f,d)=>Math.min(f,d),1/0)-o[u],h.reduce((f,d)=>Math.max(f,d),-1/0)+o[u]]});return t3(r,l,c)}function QP(i,t,e){if(i.kind==="plane"){let f=new H(...i.position),[d,m]=db(new H(...i.normal).normalize());return[(g,p)=>f.clone().addScaledVector(d,g).addScaledVector(m,p),g=>[g.clone().sub(f).dot(d),g.clone().sub(f).dot(m)],[3*e,3*e]]}let n=new H(...i.center),r=i.kind==="cylinder"?new H(...i.axis).normalize():new H(0,0,1),s=t.reduce((f,d)=>f.add(d),new H).divideScalar(Math.max(t.length,1)).sub(n),o=s.addScaledVector(r,-s.dot(r));o.length()<1e-6*i.radius&&o.copy(db(r)[0]),o.normalize();let a=new H().crossVectors(r,o),{radius:l}=i,c=i.kind==="ball";return[(f,d)=>{let m=c?l*Math.cos(d):l;return n.clone().addScaledVector(o,m*Math.cos(f)).addScaledVector(a,m*Math.sin(f)).addScaledVector(r,c?l*Math.sin(d):d)},f=>{let d=f.clone().sub(n),m=d.dot(r);return[Math.atan2(d.dot(a),d.dot(o)),c?Math.asin(Math.max(-1,Math.min(1,m/(d.length()||1)))):m]},[e/l,c?e/l:e]]}function db(i){let t=new H().crossVectors(Math.abs(i.z)<.9?new H(0,0,1):pb,i).normalize();return[t,new H().crossVectors(i,t)]}function t3(i,t,e,n=Hl){let r=[],s=[];for(let a=0;a<=n;a++)for(let l=0;l<=n;l++){r.push(...i(t[0]+(t[1]-t[0])*a/n,e[0]+(e[1]-e[0])*l/n).toArray());let c=a*(n+1)+l;a<n&&l<n&&s.push(c,c+1,c+n+1,c+1,c+n+2,c+n+1)}let o=new on;return o.setAttribute("position",new Ye(Float32Array.from(r),3)),o.setIndex(s),o.computeVertexNormals(),o}var Yr=4;function gb(i,t,e){let{cell:n,reach:r,floor:s}=t,o=n*Math.ceil(1.6*r/n),{context:a}=i;for(let l of[!1,!0]){a.beginPath();for(let c=-o;c<=o+n/2;c+=n)Math.abs(c)<n/2===l&&(i.piece([c,-o,s],0,[c,o,s],0,!0),i.piece([-o,c,s],0,[o,c,s],0,!0));i.stroke(l?e.gridStrong:e.grid,1)}}function yb(i,t,e,n){let r=t.length/3;i.path(t,0,Math.min(e+1,r)),i.stroke(n,2.5),i.context.setLineDash([4,4]),i.path(t,3*e,r-e),i.stroke(n,1.2,.8,"butt"),i.context.setLineDash([])}function xb(i,t,e,n,r){let s=[0,1,2].map(y=>e[y]+n*t[y]),[o,a]=[i.at(e,0),i.at(s,0)];if(o===null||a===null)return;let[l,c]=[a[0]-o[0],a[1]-o[1]],u=Math.hypot(l,c);if(u<3)return;let h=Math.min(12,.5*u),[f,d]=[l/u,c/u],m=[a[0]-h*f,a[1]-h*d];i.context.beginPath(),i.context.moveTo(...o),i.context.lineTo(...m),i.stroke(r,4,1,"butt"),i.fill([a,[m[0]-.45*h*d,m[1]+.45*h*f],[m[0]+.45*h*d,m[1]-.45*h*f]],r)}var Zh=class{constructor(t,e,n){this.color=n;let r=vm(t.surface,t.at.data,.12*e.reach);this.places=Float32Array.from(r.getAttribute("position").array)}color;places;draw(t){for(let e=0;e<Hl;e+=Yr)for(let n=0;n<Hl;n+=Yr)this.square(t,e,n)}square(t,e,n){let r=(o,a)=>t.at(this.places,3*((e+o)*(Hl+1)+n+a)),s=[];for(let o=0;o<4*Yr;o++){let[a,l]=[Math.floor(o/Yr),o%Yr],[c,u]=[[0,l],[l,Yr],[Yr,Yr-l],[Yr-l,0]][a],h=r(c,u);if(h===null)return;s.push(h)}t.fill(s,this.color,.16),t.context.closePath(),t.stroke(this.color,1,.35)}};var Kh=class{constructor(t){this.camera=t;let e=this.canvas.getContext("2d");if(e===null)throw new Error("This browser draws on no canvas.");this.context=e,e.lineJoin="round"}camera;canvas=document.createElement("canvas");context;aside=0;width=1;height=1;view=new Float64Array(16);from=new Float64Array(3);to=new Float64Array(3);focal=1;near=.001;resize(t,e){if(t<1||e<1)return;let n=Math.min(Math.max(window.devicePixelRatio,1),2);[this.width,this.height]=[t,e],[this.canvas.width,this.canvas.height]=[Math.round(n*t),Math.round(n*e)],this.camera.aspect=t/e,this.camera.updateProjectionMatrix()}begin(t){let{camera:e,canvas:n,context:r}=this;e.updateMatrixWorld(),this.view.set(e.matrixWorldInverse.elements),this.focal=this.height/2/Math.tan(e.fov*Math.PI/360),this.near=.001*t,r.setTransform(n.width/this.width,0,0,n.height/this.height,0,0),r.clearRect(0,0,this.width,this.height),r.lineJoin="round"}depth(t,e){return-this.seen(2,t,e)}perMeter(t){return this.focal/Math.max(t,this.near)}at(t,e){let n=this.depth(t,e);return n<this.near?null:this.pixel(this.seen(0,t,e),this.seen(1,t,e),n)}path(t,e,n){this.context.beginPath();for(let r=1;r<n;r++)this.piece(t,e+3*r-3,t,e+3*r,r===1)}piece(t,e,n,r,s){let{from:o,to:a,near:l,context:c}=this;for(let f=0;f<3;f++)[o[f],a[f]]=[this.seen(f,t,e),this.seen(f,n,r)];let[u,h]=[-o[2]<l,-a[2]<l];if(!(u&&h)){if(u||h){let f=(-l-o[2])/(a[2]-o[2]),d=u?o:a;for(let m=0;m<3;m++)d[m]=this.seen(m,t,e)+f*(this.seen(m,n,r)-this.seen(m,t,e))}(s||u)&&c.moveTo(...this.pixel(o[0],o[1],-o[2])),c.lineTo(...this.pixel(a[0],a[1],-a[2]))}}stroke(t,e,n=1,r="round"){let{context:s}=this;s.globalAlpha=n,s.strokeStyle=t,s.lineWidth=e,s.lineCap=r,s.stroke(),s.globalAlpha=1}dot(t,e,n,r,s,o=2){let a=this.at(t,e);if(a===null)return;let l=Math.max(n*this.perMeter(this.depth(t,e)),o);this.context.beginPath(),this.context.arc(...a,l,0,2*Math.PI),this.context.fillStyle=r,this.context.fill(),this.stroke(s,1)}fill(t,e,n=1){let{context:r}=this;r.beginPath(),t.forEach(s=>r.lineTo(...s)),r.closePath(),r.globalAlpha=n,r.fillStyle=e,r.fill(),r.globalAlpha=1}pixel(t,e,n){let r=this.focal/n;return[this.width/2+r*t,this.height/2-r*e]}seen(t,e,n){let{view:r}=this;return r[t]*e[n]+r[4+t]*(e[n+1]+this.aside)+r[8+t]*e[n+2]+r[12+t]}};var e3={runs:["#0072b2","#d55e00","#00875f","#a2488f","#8c6a00","#2a7fb8"],link:"#9aa5b1",joint:"#4a5562",gear:"#c76a00",base:"#39434e",payload:"#2b333c",grid:"#c3cad1",gridStrong:"#8e99a4",surface:"#009e73",force:"#b3261e",reference:"#d55e00",rigid:"#6b7681",before:"#7a4ea3",real:"#0072b2",sky:"#ffffff",ground:"#b9c0c8"},n3={runs:["#4fb0ea","#ff8f45","#3ecf9b","#e08acb","#d9b13a","#9fd3f5"],link:"#8b96a3",joint:"#a9b4c0",gear:"#e69f00",base:"#6d7986",payload:"#cfd6dd",grid:"#39424c",gridStrong:"#5c6874",surface:"#2fbf95",force:"#ff7b70",reference:"#ff8c42",rigid:"#a3adb7",before:"#c79be8",real:"#56b4e9",sky:"#ffffff",ground:"#5a6570"};function vb(i){return i?n3:e3}var _b="440154 481a6c 472f7d 414487 39568c 31688e 2a788e 23888e 1f988b 22a884 35b779 54c568 7ad151 a5db36 d2e21b fde725",Wl=256,Gi=i3();function i3(){let i=_b.split(" ").map(e=>[0,2,4].map(n=>parseInt(e.slice(n,n+2),16)/255)),t=new Float32Array(3*Wl);for(let e=0;e<Wl;e++){let n=e/(Wl-1)*(i.length-1),r=Math.min(Math.floor(n),i.length-2);for(let s=0;s<3;s++)t[3*e+s]=i[r][s]+(n-r)*(i[r+1][s]-i[r][s])}return t}function Rs(i){return 3*Math.max(0,Math.min(Wl-1,Math.round(i*(Wl-1))))}function bb(){return`linear-gradient(to right, ${_b.split(" ").map(i=>`#${i}`).join(", ")})`}function Jh(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,r=n.count,s;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)s=n.array;else{s=new Float64Array(r*3);for(let v=0;v<r;v++)s[3*v+0]=n.getX(v),s[3*v+1]=n.getY(v),s[3*v+2]=n.getZ(v)}let o=Math.cos(t),a=(1+1e-10)*100,l=r/3,c=new Float64Array(l*3);for(let v=0;v<l;v++){let M=9*v,A=s[M+0],b=s[M+1],w=s[M+2],N=s[M+3],P=s[M+4],I=s[M+5],U=s[M+6],V=s[M+7],C=s[M+8],D=U-N,G=V-P,z=C-I,et=A-N,$=b-P,X=w-I,tt=G*X-z*$,ht=z*et-D*X,ct=D*$-G*et,J=1/(Math.sqrt(tt*tt+ht*ht+ct*ct)||1);c[3*v+0]=tt*J,c[3*v+1]=ht*J,c[3*v+2]=ct*J}let u=new Int32Array(r),h=new Float64Array(r*3),f=1;for(;f<r*2;)f<<=1;let d=f-1,m=new Int32Array(f),y=0;for(let v=0;v<r;v++){let M=3*v,A=Math.trunc(s[M+0]*a),b=Math.trunc(s[M+1]*a),w=Math.trunc(s[M+2]*a),N=(Math.imul(A,73856093)^Math.imul(b,19349663)^Math.imul(w,83492791))&d;for(;;){let P=m[N];if(P===0){let U=3*y;h[U+0]=A,h[U+1]=b,h[U+2]=w,m[N]=y+1,u[v]=y++;break}let I=3*(P-1);if(h[I+0]===A&&h[I+1]===b&&h[I+2]===w){u[v]=P-1;break}N=N+1&d}}let g=new Int32Array(y+1);for(let v=0;v<r;v++)g[u[v]+1]++;for(let v=0;v<y;v++)g[v+1]+=g[v];let p=new Int32Array(r),x=g.slice(0,y);for(let v=0;v<l;v++){let M=3*v;p[x[u[M+0]]++]=v,p[x[u[M+1]]++]=v,p[x[u[M+2]]++]=v}let _=new Float32Array(r*3);for(let v=0;v<l;v++){let M=3*v,A=c[M+0],b=c[M+1],w=c[M+2];for(let N=0;N<3;N++){let P=M+N,I=u[P],U=0,V=0,C=0;for(let G=g[I],z=g[I+1];G<z;G++){let et=3*p[G],$=c[et+0],X=c[et+1],tt=c[et+2];A*$+b*X+w*tt>o&&(U+=$,V+=X,C+=tt)}let D=1/(Math.sqrt(U*U+V*V+C*C)||1);_[3*P+0]=U*D,_[3*P+1]=V*D,_[3*P+2]=C*D}}return e.setAttribute("normal",new Ye(_,3,!1)),e}function wb({vertices:i,faces:t},e){let n=Array.from(i),r=Array.from(t);for(let s=0;s<12&&r.length<3*6e4;s++){let o=new Map,a=(c,u)=>{if(!(Math.abs(n[3*c]-n[3*u])>e))return null;let h=c<u?`${c},${u}`:`${u},${c}`,f=o.get(h);if(f!==void 0)return f;let d=n.length/3;for(let m=0;m<3;m++)n.push((n[3*c+m]+n[3*u+m])/2);return o.set(h,d),d},l=[];for(let c=0;c<r.length;c+=3){let[u,h,f]=r.slice(c,c+3);r3(l,[u,h,f],[a(u,h),a(h,f),a(f,u)])}if(r=l,o.size===0)break}return{vertices:Float32Array.from(n),faces:Uint32Array.from(r)}}function r3(i,t,e){let n=e.filter(h=>h!==null).length;if(n===0)return void i.push(...t);let r=[0,1,2].find(h=>e[h]!==null&&(n!==2||e[(h+1)%3]!==null))??0,[s,o,a]=[0,1,2].map(h=>t[(r+h)%3]),[l,c,u]=[0,1,2].map(h=>e[(r+h)%3]??-1);n===1?i.push(s,l,a,l,o,a):n===2?i.push(l,o,c,s,l,c,s,c,a):i.push(s,l,u,l,o,c,u,c,a,l,c,u)}var Mb=[[1,1],[-1,1],[-1,-1],[1,-1]];function s3(i){let t=new Float32Array(2*(i+1));for(let e=0;e<=i;e++)t[2*e]=Math.cos(2*Math.PI*e/i),t[2*e+1]=Math.sin(2*Math.PI*e/i);return{points:t,normals:t}}function o3(){let i=[],t=[];return Mb.forEach((e,n)=>{let r=Mb[(n+1)%4];i.push(...e,...r);for(let s=0;s<2;s++)t.push((e[0]+r[0])/2,(e[1]+r[1])/2)}),{points:Float32Array.from(i),normals:Float32Array.from(t)}}var Qh=class{constructor(t,e,n){this.stations=t;this.section=e;this.outline=e.shape==="round"?s3(n):o3(),this.around=this.outline.points.length/2;let r=(t+2)*this.around;[this.position,this.normal,this.colour]=[0,1,2].map(()=>new Float32Array(3*r)),this.colour.fill(1),["position","normal","color"].forEach((s,o)=>{let a=new Ye([this.position,this.normal,this.colour][o],3);this.geometry.setAttribute(s,a.setUsage(Nl))}),this.geometry.setIndex(this.faces())}stations;section;geometry=new on;outline;around;position;normal;colour;axes=new Float32Array(9);shape(t,e,n,r){let{stations:s,axes:o}=this;ql(o,n,r);for(let a=0;a<s;a++){let l=e+3*Math.max(a-1,0),c=e+3*Math.min(a+1,s-1);$l(o,t[c]-t[l],t[c+1]-t[l+1],t[c+2]-t[l+2]),this.ring(a,a,t,e+3*a,0),a===0&&this.ring(s,a,t,e,-1),a===s-1&&this.ring(s+1,a,t,e+3*a,1)}this.geometry.attributes.position.needsUpdate=!0,this.geometry.attributes.normal.needsUpdate=!0}paint(t,e,n,r){let{around:s,colour:o,stations:a}=this,l=r>n?r-n:1;for(let c=0;c<a+2;c++){let u=c<a?c:c===a?0:a-1,h=Rs((t[e+u]-n)/l);for(let f=3*c*s;f<3*(c+1)*s;f+=3)o[f]=Gi[h],o[f+1]=Gi[h+1],o[f+2]=Gi[h+2]}this.geometry.attributes.color.needsUpdate=!0}dispose(){this.geometry.dispose()}ring(t,e,n,r,s){let{axes:o,around:a,position:l,normal:c,section:u,outline:h}=this,f=u.sizes[2*e],d=u.sizes[2*e+1];for(let m=0;m<a;m++){let y=f*h.points[2*m],g=d*h.points[2*m+1],p=h.normals[2*m],x=h.normals[2*m+1];for(let _=0;_<3;_++){let v=3*(t*a+m)+_;l[v]=n[r+_]+y*o[3+_]+g*o[6+_],c[v]=s===0?p*o[3+_]+x*o[6+_]:s*o[_]}}}faces(){let{around:t,stations:e}=this,n=[];for(let r=0;r<e-1;r++)for(let s=0;s<t-1;s++){let o=r*t+s;n.push(o,o+t,o+1,o+1,o+t,o+t+1)}for(let r=1;r<t-1;r++){let s=e*t,o=s+t;n.push(s,s+r,s+r+1,o,o+r+1,o+r)}for(let r=0;r<n.length;r+=3)[n[r+1],n[r+2]]=[n[r+2],n[r+1]];return n}};function ql(i,t,e){let n=t[e],r=t[e+1],s=t[e+2],o=t[e+3];i[0]=1-2*(r*r+s*s),i[1]=2*(n*r+s*o),i[2]=2*(n*s-r*o),i[3]=2*(n*r-s*o),i[4]=1-2*(n*n+s*s),i[5]=2*(r*s+n*o),i[6]=2*(n*s+r*o),i[7]=2*(r*s-n*o),i[8]=1-2*(n*n+r*r)}function $l(i,t,e,n){let r=Math.hypot(t,e,n);if(r===0)return;let s=t/r,o=e/r,a=n/r,l=i[1]*a-i[2]*o,c=i[2]*s-i[0]*a,u=i[0]*o-i[1]*s,h=1+i[0]*s+i[1]*o+i[2]*a,f=h>1e-9?1/h:0;for(let d=3;d<9;d+=3){let m=c*i[d+2]-u*i[d+1],y=u*i[d]-l*i[d+2],g=l*i[d+1]-c*i[d];i[d]+=m+f*(c*g-u*y),i[d+1]+=y+f*(u*m-l*g),i[d+2]+=g+f*(l*y-c*m)}i[0]=s,i[1]=o,i[2]=a}var a3=24;function Sb(i,t,e){let n=new Float32Array(t*e.length),r=0;return e.forEach((s,o)=>{for(let a=0;a<t;a++){let l=3*(t*s+a);a>0&&(r+=Math.hypot(i[l]-i[l-3],i[l+1]-i[l-2],i[l+2]-i[l-1])),n[o*t+a]=r}}),n}var tf=class{constructor(t,e,n,r,s){this.links=e;this.stations=n;let{vertices:o,faces:a}=wb(t,r[r.length-1]/a3),l=new on;l.setAttribute("position",new Ye(o,3)),l.setIndex(new Ye(a,1)),this.geometry=Jh(l,s);let{position:c,normal:u}=this.geometry.attributes;[this.rest,this.facing]=[c,u].map(({array:f})=>Float32Array.from(f));for(let f of[c,u])f.setUsage(Nl);let h=this.rest.length/3;this.geometry.setAttribute("color",new Ye(new Float32Array(3*h).fill(1),3)),this.station=new Uint16Array(h),[this.share,this.beyond]=[new Float32Array(h),new Float32Array(h)],this.frames=new Float32Array(9*r.length);for(let f=0;f<h;f++)this.place(f,r)}links;stations;geometry;rest;facing;station;share;beyond;frames;axes=new Float32Array(9);place(t,e){let n=this.rest[3*t],r=Math.min(Math.max(n,0),e[e.length-1]),s=0;for(;s<e.length-2&&e[s+1]<r;)s++;let o=e[s+1]-e[s];this.station[t]=s,this.share[t]=o>0?(r-e[s])/o:0,this.beyond[t]=n-r}shape(t,e){this.turn(t,e);let{rest:n,facing:r,station:s,share:o,beyond:a,frames:l}=this,{position:c,normal:u}=this.geometry.attributes,[h,f]=[c.array,u.array];for(let d=0;d<s.length;d++){let[m,y,g]=[s[d],o[d],a[d]],[p,x]=[this.placeOf(m),this.placeOf(m+1)],[_,v]=[n[3*d+1],n[3*d+2]];for(let M=0;M<3;M++){let A=9*m+M,[b,w,N]=[0,3,6].map(P=>l[A+P]+y*(l[A+P+9]-l[A+P]));h[3*d+M]=t[p+M]+y*(t[x+M]-t[p+M])+g*b+_*w+v*N,f[3*d+M]=r[3*d]*b+r[3*d+1]*w+r[3*d+2]*N}}c.needsUpdate=u.needsUpdate=!0}paint(t,e,n){let{color:r}=this.geometry.attributes;for(let s=0;s<this.station.length;s++){let o=this.station[s]+Math.round(this.share[s]),a=Rs((t[this.placeOf(o)/3]-e)/(n-e||1));for(let l=0;l<3;l++)r.array[3*s+l]=Gi[a+l]}r.needsUpdate=!0}placeOf(t){let{links:e,stations:n}=this;return 3*(e[Math.floor(t/n)]*n+t%n)}turn(t,e){let{axes:n,frames:r,links:s,stations:o}=this;s.forEach((a,l)=>{ql(n,e,4*a);for(let c=0;c<o;c++){let u=3*(a*o+Math.max(c-1,0)),h=3*(a*o+Math.min(c+1,o-1));$l(n,t[h]-t[u],t[h+1]-t[u+1],t[h+2]-t[u+2]),r.set(n,9*(l*o+c))}})}};var Ab=new H(0,1,0),Eb=.6,ro=class{constructor(t,e,n,r){this.look=n;this.widths=r;let s=this.material(n.link,!1),o=n.painted==="none"?s:this.material("#ffffff",!0),a=new Set(t.meshes.flatMap(c=>c.along??[c.link]));if(this.sweeps=t.links.map((c,u)=>{if(u>=e.links||a.has(u))return null;let h=new Qh(e.stations,bm(c,e.stations,r),n.fine?24:10);return this.add(new Ge(h.geometry,c.bends||n.painted==="all"?o:s)),h}),t.meshes.filter(({link:c})=>c<e.links).forEach(c=>c.along?this.bend(c,c.along,e,o):this.surface(c)),n.opacity<1)return;t.joints.filter(({link:c})=>c<e.links).forEach(c=>this.housing(c,t.links[c.link],a.has(c.link))),t.links.slice(0,e.links).forEach((c,u)=>this.holder(c,u,e,a));let l=new oa((a.size>0?.5:1.5)*r.usual,24,16);this.payload=this.add(new Ge(this.kept(l),this.material(n.payload,!1)))}look;widths;group=new kn;sweeps;bents=[];placed=[];tinted=[];rods=[];pedestals=[];payload=null;trash=[];from=new H;to=new H;quaternion=new zn;update(t,e,n,r){let{stations:s,roots:o,values:a}=t,l=3*s;this.sweeps.forEach((c,u)=>{c?.shape(e,u*l,o,4*u),this.look.painted!=="none"&&c?.paint(a,u*s,n,r)});for(let c of this.bents)c.shape(e,o),this.look.painted!=="none"&&c.paint(a,n,r);for(let{object:c,link:u,turn:h}of this.placed)u<0||(c.position.fromArray(e,u*l),c.quaternion.fromArray(o,4*u),h&&c.quaternion.multiply(h));for(let{material:c,link:u}of this.tinted){let h=Rs((a[(u+1)*s-1]-n)/(r-n||1));c.color.setRGB(Gi[h],Gi[h+1],Gi[h+2])}for(let c of this.rods)this.between(c.object,e,c.place,c.link*l);for(let{object:c,link:u}of this.pedestals)this.stand(c,e,u*l);this.payload?.position.copy(this.from.fromArray(t.tip))}dispose(){this.sweeps.forEach(t=>t?.dispose()),this.trash.forEach(t=>t.dispose()),this.group.removeFromParent()}material(t,e){let{opacity:n,fine:r,layer:s=0}=this.look,o=s+(n<1?2:0),a={polygonOffset:o>0,polygonOffsetFactor:o,polygonOffsetUnits:4*o},l={transparent:n<1,opacity:n,depthWrite:n>=1,...a},c={color:t,vertexColors:e,...l};return this.kept(r?new ml({...c,roughness:.5,metalness:.1}):new Ys(c))}kept(t){return this.trash.push(t),t}add(t){return t.frustumCulled=!1,t.castShadow=t.receiveShadow=this.look.opacity>=1,this.group.add(t),t}housing(t,e,n){if(e===void 0||n||t.drawing==="none")return;let r=1.5*this.widths.usual,s=t.drawing==="cylinder"?new _r(r,r,2.2*r,this.look.fine?32:14):t.drawing==="ball"?new oa(1.2*r,this.look.fine?32:14,this.look.fine?24:10):new ms(2*r,2.2*r,2*r),o=this.add(new Ge(this.kept(s),this.material(t.elastic?this.look.gear:this.look.joint,!1))),a=new H(...t.axis).normalize();this.placed.push({object:o,link:t.link,turn:new zn().setFromUnitVectors(Ab,a)})}bend(t,e,n,r){let s={vertices:Float32Array.from(t.vertices.data),faces:Uint32Array.from(t.faces.data)},o=Sb(Float32Array.from(n.arrays.line.data),n.stations,e),a=new tf(s,e,n.stations,o,Eb);this.kept(a.geometry),this.bents.push(a);let l=this.look.painted==="none"&&this.look.opacity>=1;this.add(new Ge(a.geometry,l?this.material(t.colour,!1):r))}surface(t){let e=new on;e.setAttribute("position",new Ye(Float32Array.from(t.vertices.data),3)),e.setIndex(new Ye(Uint32Array.from(t.faces.data),1));let n=this.kept(Jh(e,Eb)),r=this.material(this.look.opacity<1?this.look.link:t.colour,!1);this.placed.push({object:this.add(new Ge(n,r)),link:t.link,turn:null}),this.look.painted==="all"&&t.link>=0&&this.tinted.push({material:r,link:t.link})}holder(t,e,n,r){if(t.parent<0){if(r.has(-1)||r.has(e))return;let c=new _r(1.8*this.widths.usual,3*this.widths.usual,1,32);this.pedestals.push({object:this.add(new Ge(this.kept(c),this.material(this.look.base,!1))),link:e});return}let{place:s,away:o}=_m(n,t.parent,e);if(o<.5*this.widths.usual||r.has(e)&&r.has(t.parent))return;let a=new _r(.8*this.widths.usual,.8*this.widths.usual,1,16),l=this.add(new Ge(this.kept(a),this.material(this.look.link,!1)));this.rods.push({object:l,link:e,parent:t.parent,place:s})}between(t,e,n,r){this.from.fromArray(e,n),this.to.fromArray(e,r).sub(this.from);let s=this.to.length();t.position.copy(this.from).addScaledVector(this.to,.5),t.scale.set(1,Math.max(s,1e-9),1),s>0&&t.quaternion.copy(this.quaternion.setFromUnitVectors(Ab,this.to.divideScalar(s)))}stand(t,e,n){let r=Math.max(e[n+2]-this.widths.floor,1e-4);t.position.set(e[n],e[n+1],this.widths.floor+r/2),t.scale.set(1,r,1),t.rotation.set(Math.PI/2,0,0)}};function _m({arrays:i,stations:t},e,n){let{data:r}=i.line,s=3*t*n,o={place:0,away:1/0};for(let a=0;a<t;a++){let l=3*(t*e+a),c=Math.hypot(r[l]-r[s],r[l+1]-r[s+1],r[l+2]-r[s+2]);c<o.away&&(o={place:l,away:c})}return o}function bm(i,t,e){let n=new Float32Array(2*t).fill(e.usual);if(i.section===null)return{shape:"round",sizes:n};let r=i.section.sizes,s=r.shape[0]-1;for(let o=0;o<t;o++)for(let a=0;a<2;a++){let l=Math.round(o/Math.max(t-1,1)*s);n[2*o+a]=Math.max(r.data[2*l+a],e.least)}return{shape:i.section.shape,sizes:n}}var l3=.6,so=class{constructor(t,e,n){this.body=t;this.motion=e;this.widths=n;this.sections=t.links.slice(0,e.links).map(r=>bm(r,e.stations,n)),t.links.slice(0,e.links).forEach(({parent:r},s)=>{if(r<0)return;let{place:o,away:a}=_m(e,r,s);a>=.5*n.usual&&this.rods.push({link:s,place:o})})}body;motion;widths;sections;rods=[];axes=new Float32Array(9);pair=new Float32Array(6);draw(t,e,n,r,s){let{motion:o,widths:a}=this,l=3*o.stations,c=this.body.links.slice(0,o.links).flatMap((h,f)=>[{depth:this.far(t,e,f),draw:()=>this.link(t,e,f,h,n,r,s)},...h.parent<0?[{depth:t.depth(e,f*l)+a.usual,draw:()=>this.stand(t,e,f*l,n)}]:[]]);c.push(...this.rods.map(({link:h,place:f})=>this.rod(t,e,h*l,f,n)));for(let{link:h,drawing:f,elastic:d}of this.body.joints){if(h>=o.links||f==="none")continue;let m=()=>t.dot(e,h*l,1.5*a.usual,d?n.gear:n.joint,n.base);c.push({depth:t.depth(e,h*l)-2*a.usual,draw:m})}let u=()=>t.dot(o.tip,0,1.5*a.usual,n.payload,n.base);c.push({depth:t.depth(o.tip,0)-2*a.usual,draw:u}),c.sort((h,f)=>f.depth-h.depth).forEach(h=>h.draw())}ghost(t,e,n,r){let{motion:s,sections:o}=this,{stations:a}=s;for(let l=0;l<s.links;l++){let c=3*a*l,u=Math.max(...o[l].sizes);t.path(e,c,a),t.stroke(n,Math.max(1.6*u*t.perMeter(t.depth(e,c)),2),r)}}link(t,e,n,r,s,o,a){let{motion:l}=this,{stations:c,values:u}=l,h=3*c*n,f=s.painted==="all"||s.painted==="bending"&&r.bends,d=this.seenWidths(t,e,n,a);for(let g=1;g<c;g++)t.path(e,h+3*g-3,2),t.stroke(s.base,d[g]+2,1,g===1||g===c-1?"round":"butt");let m=o.low,y=o.high-m||1;for(let g=1;g<c;g++){let p=(u[n*c+g-1]+u[n*c+g])/2;this.stretch(t,e,h+3*g),t.stroke(f?u3((p-m)/y):s.link,d[g],1,"butt")}}stretch(t,e,n){let{pair:r}=this,s=Math.hypot(e[n]-e[n-3],e[n+1]-e[n-2],e[n+2]-e[n-1]),o=s>0?l3/t.perMeter(t.depth(e,n))/s:0;for(let a=0;a<3;a++){let l=o*(e[n+a]-e[n-3+a]);r[a]=e[n-3+a]-l,r[3+a]=e[n+a]+l}t.path(r,0,2)}seenWidths(t,e,n,r){let{axes:s,motion:o}=this,{stations:a,roots:l}=o,{shape:c,sizes:u}=this.sections[n],h=new Float32Array(a);ql(s,l,4*n);for(let f=1;f<a;f++){let d=3*(a*n+f);$l(s,e[d]-e[d-3],e[d+1]-e[d-2],e[d+2]-e[d-1]);let[m,y,g]=c3(s,r.x-e[d],r.y-e[d+1]-t.aside,r.z-e[d+2]),p=u[2*f]*Math.abs(m*s[3]+y*s[4]+g*s[5]),x=u[2*f+1]*Math.abs(m*s[6]+y*s[7]+g*s[8]),_=c==="round"?Math.hypot(p,x):p+x;h[f]=Math.max(2*Math.max(_,this.widths.least)*t.perMeter(t.depth(e,d)),2.5)}return h}far(t,e,n){let{stations:r}=this.motion;return t.depth(e,3*(r*n+(r>>1)))}rod(t,e,n,r,s){let o=t.depth(e,n)+this.widths.usual;return{depth:o,draw:()=>{t.context.beginPath(),t.piece(e,r,e,n,!0),t.stroke(s.base,1.6*this.widths.usual*t.perMeter(o)+2),t.stroke(s.link,1.6*this.widths.usual*t.perMeter(o))}}}stand(t,e,n,r){let{usual:s,floor:o}=this.widths,a=[e[n],e[n+1],o],[l,c]=[t.at(e,n),t.at(a,0)];if(l===null||c===null)return;let[u,h]=[1.8*s*t.perMeter(t.depth(e,n)),3*s*t.perMeter(t.depth(a,0))],f=Math.hypot(c[0]-l[0],c[1]-l[1]);if(f>1){let[d,m]=[(c[1]-l[1])/f,(l[0]-c[0])/f],y=(g,p)=>[g[0]+p*d,g[1]+p*m];t.fill([y(l,u),y(c,h),y(c,-h),y(l,-u)],r.base)}t.dot(e,n,1.8*s,r.base,r.base)}};function c3(i,t,e,n){let r=[i[1]*n-i[2]*e,i[2]*t-i[0]*n,i[0]*e-i[1]*t],s=Math.hypot(...r)||1;return[r[0]/s,r[1]/s,r[2]/s]}function u3(i){let t=Rs(i);return`rgb(${[0,1,2].map(e=>Math.round(255*Gi[t+e])).join(" ")})`}var nf=1.6,Xl=class{constructor(t,e,n){this.mode=t;this.size=n;let[r,s]=t.rest.shape,o={data:t.rest.data,shape:[1,r,s,3]},a={data:e.roots.data.slice(0,4*r),shape:[1,r,4]},l=t.rest.data.slice(3*(r*s-1),3*r*s);this.motion=new Es({times:{data:Float64Array.of(0),shape:[1]},line:o,rigid:o,reference:null,roots:a,tip:{data:l,shape:[1,3]},tipReference:null,colours:[],contact:null}),this.motion.seek(0,1,null),this.roots=this.motion.roots.slice()}mode;size;motion;roots;swing(t){let{mode:e,motion:n,size:r}=this,s=r*Math.cos(t),o=r*Math.sin(t),{line:a,values:l}=n;for(let c=0;c<l.length;c++){let u=0;for(let h=3*c;h<3*c+3;h++){let f=s*e.real.data[h]-o*e.imaginary.data[h];a[h]=e.rest.data[h]+f,u+=f*f}l[c]=Math.sqrt(u)/r}for(let c=0;c<3;c++)n.tip[c]=a[a.length-3+c];n.roots.set(this.roots),Vh(n.roots,e.rest.data,a,n.stations)}},ef=class{group=new kn;swinging;robot;rest;constructor(t,e,n,r){let{colours:s,extent:o,fine:a}=r;this.swinging=new Xl(t,e,n*o.reach);let{motion:l}=this.swinging,{link:c,joint:u,gear:h,base:f,payload:d,rigid:m}=s,y={link:c,joint:u,gear:h,base:f,payload:d,opacity:1,painted:"all",fine:a},g={...y,link:m,opacity:.35,painted:"none"};this.robot=new ro(e,l,y,o),this.rest=new ro(e,l,g,{...o,usual:.8*o.usual}),this.group.add(this.robot.group,this.rest.group),this.rest.update(l,l.line,0,1)}swing(t){let{motion:e}=this.swinging;this.swinging.swing(t),this.robot.update(e,e.line,0,1)}dispose(){this.robot.dispose(),this.rest.dispose(),this.group.removeFromParent()}};var h3=1e-12,ya=class{constructor(t,e,n,r){this.canvas=t;this.runs=n;this.given=r;let{page:s,extent:o,ask:a}=r;this.scale=ma(s.runs,o.reach),this.cameras=new Bh(e,t,o.reach,o.opening.direction,a),t.tabIndex=0,t.setAttribute("role","img");let l="Arrow keys turn the view, with Shift they move it, + and - zoom.";t.setAttribute("aria-label",`The robot in space: ${s.runs.map(({name:c})=>c).join(", ")}. ${l}`),t.title=`Drag to turn, right button to move, click and wheel to zoom. ${l}`}canvas;runs;given;cameras;scale;range={low:0,high:1};shown=null;replace(t,e){this.runs[t]?.replace(e)}showMode(t,e){this.shown=t}refresh(){let{runs:t}=this,{settings:e,extent:n}=this.given,r={low:1/0,high:-1/0};t.forEach(f=>f.widen(e.colour,r)),this.range=r.low<=r.high?r:{low:0,high:0};let{box:s,reach:o}=n,a=e.apart?Math.max(.4*o,s.max.y-s.min.y+.15*o):0,l=t.map(({run:f})=>JSON.stringify(f.scene.contact?.surface));t.forEach((f,d)=>{f.aside=(d-(t.length-1)/2)*a,f.showsSurface=e.apart||l.indexOf(l[d])===d});let c=ob(this.given.page,e.factor,n),u=s.min.toArray().map((f,d)=>f-(d===1?(t.length-1)/2*a:0)),h=s.max.toArray().map((f,d)=>f+(d===1?(t.length-1)/2*a:0));this.cameras.places=a?[...c,...u,...h]:c}look(t,e){this.cameras.show(t,this.runs[0].motion.tip,e)}takeView(t){this.cameras.take(t.cameras)}tell(t){let{settings:e,extent:n}=this.given,{shown:r}=this,s=this.runs.flatMap(({run:a})=>a.scene.colours).find(({id:a})=>a===e.colour);t.list(r?this.modeEntries(r):this.entries(),!r&&this.forceShown()),r?t.range({label:"Displacement, share of the largest",unit:"",low:0,high:1}):t.range(s&&this.range.high>h3?{label:s.label,unit:s.unit,...this.range}:null),t.enlarged(e.factor===1||r?"":`Deformation × ${e.factor}, not to scale`);let o=n.floor===0?"":`, at z = ${Mr(n.floor)} m`;t.flat(""),t.floor(e.floor?`Grid ${Mr(n.cell)} m${o}${this.thick()}`:"")}words(){if(!this.forceShown())return"";let t=n=>Mr(Math.hypot(...n));return`Contact force ${this.runs.filter(({run:n})=>n.scene.contact).map(({motion:n})=>`${t(n.force)} N`).join(", ")} (arrow: ${Mr(.1/this.scale)} N per 0.1 m)`}dispose(){this.cameras.dispose(),this.canvas.remove()}forceShown(){return this.given.settings.force&&this.scale>0}entries(){let{runs:t}=this,{settings:e,colours:n}=this.given,r=t.length===1,s=[];r?e.traces&&this.moves()&&s.push({colour:n.real,label:"Path of the tip"}):s.push(...t.map(l=>({colour:l.colour,label:l.run.name})));let o=l=>e[l]&&t.some(({run:c})=>c.scene[l]),a=e.traces&&this.moves()&&t.some(({run:l})=>l.scene.tipReference);return o("reference")?s.push({colour:t[0].referenceColour,label:"Nominal"}):a&&s.push({colour:t[0].referenceColour,label:"Path of the nominal tip"}),o("rigid")&&s.push({colour:n.rigid,label:"Undeformed"}),t.some(({changed:l})=>l)&&s.push({colour:n.before,label:"The run as it was"}),s}moves(){return this.runs.some(({run:t})=>t.charts.length>0)}modeEntries(t){let e=`damping ${Mr(100*t.damping)} %`,n=`motors ${t.case}; slowed, not to scale`,r=`Mode ${Mr(t.frequency)} Hz, ${e}, ${t.element}; ${n}`;return[{colour:this.given.colours.rigid,label:"At rest"},{colour:"transparent",label:r}]}thick(){let{least:t}=this.given.extent,e=this.runs.flatMap(({run:s})=>s.scene.links.map(({section:o})=>o)),n=e.some(s=>s&&Math.min(...s.sizes.data)<t),r=Gh("m",2*t);return n?`; links are drawn at least ${Mr(2*t*r.factor)} ${r.name} thick`:e.some(s=>s?.guessed)?"; thickness of links by their stiffness and mass":""}};var rf=.42,wm=class extends pa{constructor(e,n,r,s,o){super(e,n,r,s);this.colours=s;this.extent=o;this.robot=new so(e.scene,this.motion,o),this.surface=this.touched()}colours;extent;robot;was=null;surface;paths=[];traced=0;replace(e){super.replace(e),this.robot=new so(this.run.scene,this.motion,this.extent),this.was=this.before&&new so(this.run.scene,this.before,this.extent),this.surface=this.touched(),this.traced=0}touched(){let{contact:e}=this.run.scene;if(e===null)return null;let{surface:n,at:r}={...e,...this.motion.arrays.contact};return new Zh({surface:n??e.surface,at:r},this.extent,this.colours.surface)}draw({pen:e,camera:n,scale:r,colours:s},o,a,l){let{motion:c,before:u}=this;e.aside=this.aside,this.seek(o,a),this.trace(a.factor),a.surface&&this.showsSurface&&this.surface?.draw(e),this.was&&u&&this.was.ghost(e,u.line,s.before,rf),a.rigid&&c.rigid&&this.robot.ghost(e,c.rigid,s.rigid,rf),a.reference&&c.reference&&this.robot.ghost(e,c.reference,this.referenceColour,rf),a.traces&&this.paths.forEach(({path:h,color:f})=>yb(e,h,c.frame,f)),this.robot.draw(e,c.line,this.look(a),l,n.position),a.force&&c.arrays.contact&&xb(e,c.force,c.at,r,s.force),e.aside=0}look(e){let n=Gl(e.colour);return{...Tb(this.colours,this.alone?null:this.colour,n==="none"?this.colour:this.colours.link),painted:n}}trace(e){if(e===this.traced)return;this.traced=e;let[n,r]=[this.motion.path(!1,e),this.motion.path(!0,e)];this.paths=[],r&&this.paths.push({path:r,color:this.referenceColour}),n&&this.paths.push({path:n,color:this.colour})}};function Tb({joint:i,gear:t,base:e,payload:n},r,s){return{link:s,joint:r??i,gear:r??t,base:e,payload:r??n,opacity:1,painted:"all",fine:!1}}var sf=class extends ya{constructor(e,n){let{page:r,extent:s,colours:o}=e,a=new Hn(32,1,.01*s.reach,100*s.reach);a.up.set(0,0,1);let l=new Kh(a);super(l.canvas,a,r.runs.map((c,u)=>new wm(c,u,r.runs.length===1,o,s)),e);this.wanted=n;this.sheet={pen:l,camera:a,extent:s,colours:o,scale:this.scale},this.refresh()}wanted;sheet;mode=null;draw(e,n){let{sheet:r,runs:s}=this,{settings:o,extent:a,colours:l}=this.given;this.mode||this.cameras.follow(s[0].motion.tip),r.pen.begin(a.reach),o.floor&&gb(r.pen,a,l),this.mode?this.swing(2*Math.PI*n/nf):this.sorted().forEach(c=>c.draw(r,e,o,this.range))}showMode(e,n){super.showMode(e,n);let{scene:r}=this.runs[0].run,s=e&&new Xl(e,r,n*this.given.extent.reach);this.mode=s&&{swinging:s,robot:new so(r,s.motion,this.given.extent)}}resize(e,n){this.sheet.pen.resize(e,n)}tell(e){super.tell(e);let r=this.runs.some(({run:s})=>s.scene.meshes.length>0)?"; the surfaces of the parts (meshes) are left out":"";e.flat(`Drawn in lines${this.wanted?"":", without WebGL"}${r}`)}sorted(){let{pen:e}=this.sheet,n=r=>e.depth([0,r.aside,0],0);return[...this.runs].sort((r,s)=>n(s)-n(r))}swing(e){if(!this.mode)return;let{swinging:n,robot:r}=this.mode,{pen:s,camera:o,colours:a}=this.sheet;r.ghost(s,Float32Array.from(n.motion.arrays.line.data),a.rigid,rf),n.swing(e),r.draw(s,n.motion.line,Tb(a,null,a.link),{low:0,high:1},o.position)}};var Rb=5,of=class{constructor(t){this.place=t;let e=Ue("div",{className:"scene-below"},this.way,this.grid);this.foot=Ue("div",{className:"scene-foot"},e,this.factor),t.append(this.legend,this.scale,this.foot)}place;legend=Yl("scene-legend");scale=Yl("scene-scale");factor=Yl("scene-factor");grid=Yl("scene-grid");way=Yl("scene-flat");live=Ue("span");shown="";foot;rooms(){this.live.textContent=this.shown.replace(/[\d.]+(?= N[, ])/g,"88.8");let[t,e,n,r]=[this.place,this.legend,this.scale,this.foot].map(s=>s.getBoundingClientRect());return this.live.textContent=this.shown,tb(t,e,n,r)}get kinds(){let t=this.legend.textContent.slice(0,this.legend.textContent.length-this.live.textContent.length),e=[this.live.isConnected,this.scale.hidden,this.scale.firstChild?.textContent,this.factor.hidden];return[t,...e,this.way.textContent,this.grid.textContent].join("|")}list(t,e){this.legend.replaceChildren(...t.map(({colour:n,label:r})=>Ue("span",{},Cb(n),r))),e&&this.legend.append(this.live),this.legend.hidden=t.length===0&&!e}tell(t){t!==this.shown&&(this.shown=t,this.live.textContent=t)}range(t){if(this.scale.hidden=t===null,t===null)return;let e=Gh(t.unit,t.high),n=Math.abs(t.low)<1e-6*Math.abs(t.high)?0:t.low,r=Array.from({length:Rb},(l,c)=>n+(t.high-n)*c/(Rb-1)),s=Cb(bb()),o=e.name.replaceAll(" "," "),a=Ue("b",{},o?`${t.label} [${o}]`:t.label);this.scale.replaceChildren(a,s,Ue("ol",{},...r.map(l=>Ue("li",{},Mr(e.factor*l)))))}enlarged(t){this.factor.hidden=t==="",this.factor.textContent=t}flat(t){this.way.hidden=t==="",this.way.textContent=t}floor(t){this.grid.hidden=t==="",this.grid.textContent=t}};function Yl(i){return Ue("div",{className:`scene-note ${i}`,hidden:!0})}function Cb(i){let t=Ue("i",{ariaHidden:"true"});return t.style.background=i,t}function Mm(){let i=document.createElement("canvas").getContext("webgl2");if(i===null)return null;let t=i.getExtension("WEBGL_debug_renderer_info"),e=String(i.getParameter(t?t.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)?"low":"high"}var af=class{constructor(t,e){this.quality=t;this.extent=e;let n=t==="high";this.renderer=new Fh({canvas:this.canvas,antialias:n,alpha:!0,powerPreference:"low-power"}),this.renderer.setPixelRatio(n?Math.min(window.devicePixelRatio,2):.75*Math.min(window.devicePixelRatio,1)),this.renderer.shadowMap.enabled=n,this.renderer.shadowMap.type=Zs,this.camera.up.set(0,0,1),this.camera.near=.01*e.reach,this.camera.far=100*e.reach,this.scene.add(this.floor)}quality;extent;canvas=document.createElement("canvas");scene=new sl;camera=new Hn(32,1,.01,100);renderer;floor=new kn;light=new wl("#ffffff",2.2);dress(t){let{extent:e,light:n}=this;this.undress();let r=e.cell*2*Math.ceil(1.6*e.reach/e.cell),s=new js(r,Math.round(r/e.cell),t.gridStrong,t.grid);s.rotation.x=Math.PI/2,s.position.z=e.floor,this.floor.add(s,new vl(t.sky,t.ground,1.6),n,n.target);let o=e.box.getCenter(n.target.position);n.position.set(o.x-.6*e.reach,o.y-1.1*e.reach,o.z+2.2*e.reach),this.quality==="high"&&this.shadows(r)}get floorShown(){return this.floor.children[0]?.visible??!1}set floorShown(t){this.floor.children.forEach(e=>{(e instanceof js||e instanceof Ge)&&(e.visible=t)})}resize(t,e){t<1||e<1||(this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix())}draw(){this.renderer.render(this.scene,this.camera)}dispose(){this.undress(),this.light.dispose(),this.renderer.dispose(),this.renderer.getContext().isContextLost()||this.renderer.forceContextLoss(),this.canvas.remove()}shadows(t){let{light:e,extent:n}=this;e.castShadow=!0,e.shadow.mapSize.set(2048,2048),e.shadow.normalBias=.2*n.usual;let{camera:r}=e.shadow;r.left=r.bottom=-1.4*n.reach,r.right=r.top=1.4*n.reach,r.near=.1*n.reach,r.far=6*n.reach;let s=new Ge(new Xs(t,t),new pl({opacity:.22,depthWrite:!1}));s.position.z=n.floor,s.receiveShadow=!0,this.floor.add(s)}undress(){for(let t of[...this.floor.children])t instanceof js?t.dispose():t instanceof Ge&&(t.geometry.dispose(),t.material.dispose());this.floor.clear()}};var f3=`
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
`,lf=null;function Pb(){lf===null&&(lf=new CSSStyleSheet,lf.replaceSync(f3),document.adoptedStyleSheets=[...document.adoptedStyleSheets,lf])}var cf=class extends pa{constructor(e,n,r,s){super(e,n,r,s.colours);this.shared=s}shared;group=new kn;robot;look;ghosts=new Map;traces=[];arrow=null;surface=null;built="";traced="";replace(e){let n=String(this.motion.arrays.line.shape.slice(1));super.replace(e),String(this.motion.arrays.line.shape.slice(1))!==n&&(this.built=""),this.traced="",this.built!==""&&this.placeSurface()}update(e,n,r){let{motion:s}=this;this.build(n),this.seek(e,n),this.robot.update(s,s.line,r.low,r.high),this.haunt("reference",s,n.reference?s.reference:null),this.haunt("rigid",s,n.rigid?s.rigid:null),this.haunt("before",this.before??s,this.before?.line??null),this.draw(n)}dispose(){this.clear(),this.group.removeFromParent()}build(e){let n=Gl(e.colour);if(n===this.built)return;this.clear(),this.built=n;let{scene:r}=this.run,{extent:s,colours:o,fine:a}=this.shared,l=n==="none"?this.colour:o.link,c=this.alone?o.joint:this.colour,u={link:l,joint:c,gear:this.alone?o.gear:c,base:o.base,payload:c,opacity:1,painted:n,fine:a,layer:this.index};this.robot=this.added(r,this.motion,u,1),this.look=u,r.contact&&(this.arrow=new jh(o.force,.006*s.reach,this.shared.scale),this.group.add(this.arrow.group),this.placeSurface())}placeSurface(){let{contact:e}=this.run.scene;if(!e)return;let{extent:n,colours:r}=this.shared,{surface:s,at:o}={...e,...this.motion.arrays.contact},a=mb(s??e.surface,o.data,.12*n.reach,r.surface);if(!this.surface){this.group.add(this.surface=a);return}this.surface.geometry.dispose(),this.surface.geometry=a.geometry,a.material.dispose()}dropSurface(){this.surface&&(this.surface.geometry.dispose(),this.surface.material.dispose(),this.surface.removeFromParent(),this.surface=null)}haunt(e,n,r){let s=this.ghosts.get(e);if(s&&(s.group.visible=r!==null),r===null)return;(s??this.ghost(e,n)).update(n,r,0,1)}ghost(e,n){let{colours:r}=this.shared,s={reference:this.referenceColour,rigid:r.rigid,before:r.before}[e],o=this.added(this.run.scene,n,{...this.look,link:s,opacity:.42,painted:"none"},.85);return this.ghosts.set(e,o),o}added(e,n,r,s){let{extent:o}=this.shared,a={usual:s*o.usual,least:s*o.least,floor:o.floor},l=new ro(s<1?d3(e,s):e,n,r,a);return this.group.add(l.group),l}draw(e){this.trace(e);for(let{trace:n,reference:r}of this.traces)n.group.visible=e.traces&&(!r||this.motion.arrays.tipReference!==null),n.seek(this.motion.frame);this.surface&&(this.surface.visible=e.surface&&this.showsSurface),this.arrow&&(this.arrow.point(this.motion.force,this.motion.at),this.arrow.group.visible&&=e.force&&this.motion.arrays.contact!==null)}trace(e){let n=`${e.factor}`;if(n===this.traced)return;let r=this.traces.length===0;this.traced=n;for(let s of[!1,!0]){let o=this.motion.path(s,e.factor),a=this.traces.find(l=>l.reference===s);if(o!==null){if(a)a.trace.lay(o);else if(r){let l=s?this.referenceColour:this.colour,c=new Yh(o,l,.012*this.shared.extent.reach);this.traces.push({trace:c,reference:s}),this.group.add(c.group)}}}}clear(){this.robot?.dispose(),this.ghosts.forEach(e=>e.dispose()),this.traces.forEach(({trace:e})=>e.dispose()),this.arrow?.dispose(),this.dropSurface(),this.ghosts.clear(),this.traces=[],this.traced=this.built=""}};function d3(i,t){let e=i.links.map(n=>{if(n.section===null)return n;let{data:r,shape:s}=n.section.sizes;return{...n,section:{...n.section,sizes:{data:Float32Array.from(r,o=>t*o),shape:s}}}});return{...i,links:e}}var uf=class extends ya{stage;shared;mode=null;constructor(t,e){let{page:n,extent:r,colours:s}=t,o=new af(e,r),a={extent:r,colours:s,fine:e==="high",scale:ma(n.runs,r.reach)},l=n.runs.map((c,u)=>new cf(c,u,n.runs.length===1,a));super(o.canvas,o.camera,l,t),this.stage=o,this.shared=a,o.dress(s),l.forEach(({group:c})=>o.scene.add(c)),this.refresh()}draw(t,e){let{settings:n}=this.given;this.mode?this.mode.swing(2*Math.PI*e/nf):this.runs.forEach(r=>r.update(t,n,this.range)),this.mode||this.cameras.follow(this.runs[0].motion.tip),this.stage.draw()}showMode(t,e){super.showMode(t,e),this.mode?.dispose(),this.mode=t&&new ef(t,this.runs[0].run.scene,e,this.shared),this.mode&&this.stage.scene.add(this.mode.group),this.runs.forEach(({group:n})=>n.visible=t===null)}refresh(){super.refresh(),this.runs.forEach(({group:t,aside:e})=>t.position.set(0,e,0)),this.stage.floorShown=this.given.settings.floor}resize(t,e){this.stage.resize(t,e)}dispose(){this.mode?.dispose(),this.runs.forEach(t=>t.dispose()),super.dispose(),this.stage.dispose()}};var p3=2e3;function Ib(i,t,e,n=!1){Pb();let r=Ue("div",{className:"scene"}),s=Ue("div",{className:"scene-view"});return i.append(r),new Sm(r,s,t,e,Mm(),n)}var Sm=class{constructor(t,e,n,r,s,o){this.frame=t;this.place=e;this.page=n;this.clock=r;this.best=s;let{runs:a}=n,l=a.length>1;this.extent=ab(n);let c=o&&this.extent.opening.most>1;this.settings={colour:l?"run":a[0].scene.colours[0]?.id??"run",factor:c?this.extent.opening.factor:1,reference:!l&&!c&&a[0].charts.length>0,rigid:c&&!l,traces:!0,force:!0,surface:!0,floor:!0,apart:!1,quality:"auto"},this.replaced=a.map(()=>null),this.notes=new of(e),t.append(this.controls(),e),this.world=this.made(),this.ends.push(r.subscribe(this.ask));let u=new ResizeObserver(()=>this.resize());u.observe(e),this.dark.addEventListener("change",this.remake),this.ends.push(()=>u.disconnect(),()=>this.dark.removeEventListener("change",this.remake)),this.resize(),this.refresh(),this.world.look("iso",!1)}frame;place;page;clock;best;settings;notes;replaced;ends=[];dark=window.matchMedia("(prefers-color-scheme: dark)");still=window.matchMedia("(prefers-reduced-motion: reduce)");extent;world;waiting=0;mode=null;asked=0;drawn=1;replace(t,e){this.replaced[t]=e,this.world.replace(t,e),this.refresh()}showMode(t,e){t&&this.mode?.mode!==t&&this.frame.scrollIntoView({block:"nearest"}),this.mode=t===null?null:{mode:t,amplitude:e},this.world.showMode(t,e),this.refresh()}get opensAt(){return this.extent.opening.time}get view(){return{pose:this.world.cameras.pose,factor:this.settings.factor}}set view({pose:t,factor:e}){let n=this.frame.querySelector("[data-scene=factor]"),{most:r}=this.extent.opening;n&&e!==this.settings.factor&&(n.value=String(100*Math.log(Math.min(Math.max(e,1),r))/Math.log(r)),n.dispatchEvent(new Event("input"))),t.length===6&&t.every(Number.isFinite)&&(this.world.cameras.pose=t)}picture(t=document.createElement("canvas")){this.world.draw(this.clock.time,this.still.matches?0:performance.now()/1e3);let e=getComputedStyle(this.frame),n=this.settings.factor===1?"":`, deformation × ${this.settings.factor}`,r=this.mode?"":`, t = ${this.clock.time.toFixed(3)} s${n}`;return nv(t,this.world.canvas,s=>e.getPropertyValue(s),this.page.title+r)}resize(){this.world.resize(this.place.clientWidth,this.place.clientHeight),this.world.cameras.preset&&this.world.cameras.refit(),this.ask()}dispose(){cancelAnimationFrame(this.asked),window.clearTimeout(this.waiting),this.ends.forEach(t=>t()),this.world.canvas.removeEventListener("webglcontextlost",this.lost),this.world.dispose(),this.frame.remove()}controls(){let{runs:t}=this.page,n=[...new Map(t.flatMap(({scene:a})=>a.colours.map(({id:l,label:c})=>[l,c]))),["run",t.length>1?"each robot its own":"none"]],r=a=>t.some(({scene:l})=>a(l)),o=[["reference",r(a=>a.reference)],["rigid",r(a=>a.rigid)],["traces",!0],["force",r(a=>a.contact)],["surface",r(a=>a.contact)],["floor",!0],["apart",t.length>1]].filter(([,a])=>a).map(([a])=>a);return rb(this.settings,n,o,this.extent.opening.most,this.best!==null,{changed:()=>{let a=this.drawn;this.refresh(),a!==this.settings.factor&&this.world.cameras.refit()},look:a=>this.world.look(a,!this.still.matches),quality:()=>{this.best??=Mm(),this.remake()}})}made(){let{page:t,extent:e,settings:n,ask:r}=this,s={page:t,extent:e,colours:vb(this.dark.matches),settings:n,ask:r},{quality:o}=n,a=o==="lines"?null:this.best&&(o==="auto"?this.best:o),l=(a&&m3(s,a))??new sf(s,o==="lines");return l.cameras.rooms=()=>this.notes.rooms(),l.canvas.addEventListener("webglcontextlost",this.lost),l.canvas.addEventListener("webglcontextrestored",this.found),this.place.prepend(l.canvas),l}lost=t=>{t.target===this.world.canvas&&(window.clearTimeout(this.waiting),this.waiting=window.setTimeout(()=>{this.best=null,this.remake()},p3))};found=()=>{window.clearTimeout(this.waiting),this.ask()};remake=()=>{let t=this.world;this.world=this.made(),this.world.takeView(t),t.dispose(),this.replaced.forEach((e,n)=>e&&this.world.replace(n,e)),this.mode&&this.world.showMode(this.mode.mode,this.mode.amplitude),this.resize(),this.refresh()};refresh(){this.drawn=this.settings.factor,this.world.refresh();let t=this.notes.kinds;this.world.tell(this.notes),this.notes.tell(this.world.words()),t!==this.notes.kinds&&this.world.cameras.preset&&this.world.cameras.refit(),this.ask()}ask=()=>{this.asked===0&&(this.asked=requestAnimationFrame(this.draw))};draw=t=>{this.asked=0,this.world.draw(this.clock.time,this.still.matches?0:t/1e3),this.notes.tell(this.world.words()),this.mode&&!this.still.matches&&this.ask()}};function m3(i,t){try{return new uf(i,t)}catch{return null}}var g3=["tip_error.commanded","deviation.max","deflection.max","gear.max"];function Fb(i,t){let e=Math.max(...t.runs.map(C=>C.duration)),n=Xm(e),r=rt("div",{class:"scene"}),s=rt("div",{class:"facts-panel",role:"region",tabindex:"0","aria-label":"Numbers that matter"}),o=rt("div",{class:"sliders-panel",role:"region",tabindex:"0","aria-label":"Settings"}),a=rt("div",{class:"side"},s,o),l=rt("div",{class:"transport",role:"group","aria-label":"Time"}),c=rt("section",{class:"charts","aria-label":"Charts"}),u=t.runs.length>1?` of ${t.runs[0].name}`:"",h=Lb(`Elastic line${u}`,t.runs[0].line!==null),f=Lb(`Modes of vibration${u}`,t.runs[0].modes.length>0),d=rt("div",{class:"bar files"});i.classList.add("app"),i.append(rt("div",{class:"stage"},r),l,rt("div",{class:"desk"},a,c,rt("div",{class:"lower"},h.element,f.element)),d);let m=Ib(r,t,n,!0);n.seek(m.opensAt);let y=ev(l,n),g=[m,y],p=zd(s,t,n),x=Q0(c,t,n),_=t.runs[0].line?kx(h.body,t,n):null,v=t.runs[0].modes.length?Vd(f.body,t,m,n):null;Wx(d,t),l.hidden=c.hidden=t.runs.every(C=>C.charts.length===0);let M=t.runs[0].charts.find(C=>C.abscissa==="time")?.at.data??[],A=C=>{let D=C?C.times:M,G=t.runs[0].facts.flatMap(({id:z,name:et})=>{let $=C?.facts[z]?.time;return $!==void 0&&g3.includes(z)?[{time:$,label:`largest: ${et.toLowerCase()}`}]:[]});y.show(C?G.sort((z,et)=>z.time-et.time):t.runs[0].events,D)};A(null);let b=null;function w(C){n.setDuration(Math.max(C?C.times[C.times.length-1]:0,e)),(!C||C.scene)&&b!==(C?.scene??null)&&(b=C?.scene??null,m.replace(0,b),_?.show(C)),x.show(C),p.show(C),v?.show(C),A(C),document.querySelector("main > .status.good")?.classList.toggle("before",C!==null)}let N=Hd(t.runs[0].name),P=t.live&&Qx(o,t.live,{open:Dx,show:w,fileName:`${N}_changed`,facts:t.runs[0].facts});P?g.push(P):t.notLive&&o.append(rt("p",{class:"note",text:`Nothing can be changed in this page: ${t.notLive}.`}));let I=qx(N,m,n,()=>Gx(n,m,P));r.querySelector(".scene-bar")?.append(I);let U=()=>Hx(location.hash,n,m,P);addEventListener("hashchange",U),U();function V(C){v?.dispose(),f.body.replaceChildren(),f.element.hidden=C.length===0;let[D,...G]=t.runs;v=C.length?Vd(f.body,{...t,runs:[{...D,modes:C},...G]},m,n):null}return{clock:n,side:o,scene:m,show:w,showModes:V,complete(C){let[D]=t.runs;[D.facts,D.modes]=[C.facts,C.modes];for(let G of D.charts)G.marks=C.charts.find(({id:z})=>z===G.id)?.marks??[];s.replaceChildren(),p=zd(s,t,n),x.renew(),V(C.modes)},dispose(){n.pause(),removeEventListener("hashchange",U),v?.dispose(),[...g,x,..._?[_]:[]].forEach(C=>C.dispose()),i.replaceChildren()}}}function Lb(i,t){let e=rt("div",{});return{element:rt("section",{class:"panel",hidden:!t,"aria-label":i},rt("h3",{text:i}),e),body:e}}function Nb(i){let t=document.documentElement,e=[];addEventListener("beforeprint",()=>{t.classList.add("printing");let n=[...document.querySelectorAll(i)].filter(r=>!r.open);for(let r of n)r.open=!0;e=[...e,...n]}),addEventListener("afterprint",()=>{t.classList.remove("printing");for(let n of e)n.open=!1;e=[]})}async function y3(){let i=document.getElementById("tmodes-data"),t=document.getElementById("tmodes-app");if(!(i===null||t===null))try{let e=qm(await $m(i.textContent??""));Fb(t,e),document.documentElement.classList.add("running")}catch(e){let n=e instanceof Error?e.message:String(e);t.replaceChildren(rt("p",{class:"status warning",role:"alert",text:`The interactive part of this page could not start: ${n}. The whole report without it follows.`}))}}Nb("details");y3();})();
