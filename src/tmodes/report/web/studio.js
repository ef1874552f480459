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
"use strict";(()=>{function X(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))s==="text"?n.textContent=String(r):r!==void 0&&r!==!1&&n.setAttribute(s,r===!0?"":r);return n.append(...t.filter(s=>s!==null)),n}function yt(i,e,t={}){let n=X("button",{type:"button",text:i,...t});return n.addEventListener("click",e),n}function Cl(i,e,t=2){let n="http://www.w3.org/2000/svg",s=document.createElementNS(n,"svg"),r=document.createElementNS(n,"line"),o={x1:0,y1:5,x2:26,y2:5,"stroke-width":t,"stroke-dasharray":e.join(" ")};for(let[a,l]of Object.entries(o))r.setAttribute(a,String(l));r.style.stroke=i;for(let[a,l]of Object.entries({width:26,height:10,"aria-hidden":"true"}))s.setAttribute(a,String(l));return s.append(r),s}var Fp=0;function jt(i){return Fp+=1,`tm-${i}-${Fp}`}function Ys(i,e,t){let n=URL.createObjectURL(new Blob([i],{type:t}));X("a",{href:n,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}var vx="TMPK";function Np(i){if(new TextDecoder().decode(i.subarray(0,4))!==vx)throw new Error("these bytes are no data of tmodes");let t=new DataView(i.buffer,i.byteOffset,i.byteLength).getUint32(4,!0),n=JSON.parse(new TextDecoder().decode(i.subarray(8,8+t))),s=8*Math.ceil((8+t)/8),r=n.arrays.map(o=>bx(i,s,o));return Pl(n.page,r)}function bx(i,e,t){let n=t.shape.reduce((o,a)=>o*a,1),s=Number(t.dtype[1]),r=i.slice(e+t.offset,e+t.offset+n*s).buffer;return t.dtype==="f8"?{data:new Float64Array(r),shape:t.shape}:t.dtype==="d4"?{data:Mx(new Uint8Array(r),n,t),shape:t.shape}:t.dtype==="i4"?{data:new Int32Array(r),shape:t.shape}:t.dtype==="u1"?{data:new Uint8Array(r),shape:t.shape}:{data:Sx(new Uint8Array(r),n,t),shape:t.shape}}function Sx(i,e,{shape:t,scale:n=1,start:s=0}){let r=e/(t[0]||1)||1,o=new Int16Array(e);for(let a=0;a<e;a++)o[a]=(i[a]|i[e+a]<<8)+(a>=r?o[a-r]:0);return Float32Array.from(o,a=>s+n*a)}function Mx(i,e,{shape:t}){let n=e/(t[0]||1)||1,s=new Uint32Array(e);for(let r=0;r<e;r++){let o=i[r]|i[e+r]<<8|i[2*e+r]<<16|i[3*e+r]<<24;s[r]=o+(r>=n?s[r-n]:0)}return new Float32Array(s.buffer)}function Pl(i,e){if(Array.isArray(i))return i.map(n=>Pl(n,e));if(i===null||typeof i!="object")return i;let t=Object.entries(i);return t.length===1&&t[0][0]==="$array"?e[t[0][1]]:t.length===1&&t[0][0]==="$sum"?wx(Pl(t[0][1],e)):Object.fromEntries(t.map(([n,s])=>[n,Pl(s,e)]))}function wx([i,e]){return{data:Float32Array.from(i.data,(t,n)=>t+e.data[n]),shape:i.shape}}var Bi=class extends Error{constructor(t,n){super(t.map(s=>s.message).join("; "));this.errors=t;this.status=n}errors;status};async function Op(i,e="GET",t){let n;try{n=await fetch(i,{method:e,credentials:"same-origin",...t===void 0?{}:{headers:{"Content-Type":"application/json"},body:JSON.stringify(t)}})}catch{throw new Bi([Up("The studio does not answer: it was stopped, or this machine slept. Start it again.")],0)}if(n.ok)return n;let s=await n.json().catch(()=>null);throw new Bi(s?.errors??[Up(`The studio answered ${n.status}.`)],n.status)}function Up(i){return{path:"",message:i,got:"",expected:"",mend:"",where:"",steps:null}}async function Ei(i,e="GET",t){return await(await Op(i,e,t)).json()}var wr=encodeURIComponent,Kt={robots:()=>Ei("api/robots"),robot:i=>Ei(`api/robots/${wr(i)}`),schema:i=>Ei(`api/schemas/${wr(i)}`),check:i=>Ei("api/check","POST",{sheet:i}),yaml:i=>Ei("api/yaml","POST",{sheet:i}),studies:()=>Ei("api/studies"),study:i=>Ei(`api/studies/${wr(i)}`),save:(i,e,t)=>Ei(`api/studies/${wr(i)}`,"PUT",{sheet:e,overwrite:t}),upload:i=>Ei("api/upload","POST",{files:i}),begin:(i,e,t)=>Ei("api/jobs","POST",{product:i,sheet:e,client:t}),look:(i,e)=>Ei(`api/jobs/${wr(i)}?wait=${e}`),cancel:i=>Ei(`api/jobs/${wr(i)}`,"DELETE"),bytes:async i=>new Uint8Array(await(await Op(`api/jobs/${wr(i)}/content`)).arrayBuffer()),page:async i=>Np(await Kt.bytes(i))};var Bp=16*1024*1024,Ax=".yaml,.yml,.urdf,.xacro,.xml,.stl,.obj,.dae";function kp(i){let e=jt("upload"),t=X("input",{id:e,type:"file",multiple:!0,accept:Ax,class:"upload"}),n=async s=>{if(!s?.length)return;let r=[...s].reduce((o,a)=>o+a.size,0);if(r>Bp){let[o,a,l]=[`${(r/1e6).toFixed(0)} MB`,`at most ${(Bp/1e6).toFixed(0)} MB`,"leave out what is not needed"];i.wrong([{path:"files",message:`files: got ${o}; expected ${a}. Mend: ${l}`,got:o,expected:a,mend:l,where:"",steps:null}]);return}i.say(`Reading ${s.length===1?s[0].name:`${s.length} files`} …`),await cs(i,async()=>i.load(await Kt.upload(await Promise.all([...s].map(Ex))),[...s].map(o=>o.name).join(", "))),t.value=""};return t.addEventListener("change",()=>{n(t.files)}),document.addEventListener("dragover",s=>s.preventDefault()),document.addEventListener("drop",s=>{s.preventDefault(),n(s.dataTransfer?.files??null)}),X("span",{class:"pick"},X("label",{for:e,text:"Upload",class:"button",title:"A data sheet, or a URDF with its elasticity file (.yaml) and meshes; files can be dropped here too"}),t)}async function Ex(i){let e=new Uint8Array(await i.arrayBuffer()),t="";for(let n=0;n<e.length;n+=32768)t+=String.fromCharCode(...e.subarray(n,n+32768));return{name:i.name,content:btoa(t)}}function zp(i){let[e,t]=[jt("studies"),jt("study")],n=X("select",{id:e}),s=X("input",{id:t,type:"text",size:"14",spellcheck:"false",placeholder:"study.yaml"}),r=yt("Replace",()=>{a(!0)},{hidden:!0,class:"warn"}),o=()=>cs(i,async()=>{let l=await Kt.studies();n.replaceChildren(X("option",{value:"",text:`open from ${l.folder}/ …`}),...l.studies.map(c=>X("option",{value:c,text:c})))}),a=l=>cs(i,async()=>{let c=i.sheet();if(!c)return;let u=s.value.trim()||`${i.name().replace(/[^\w.-]+/g,"_")}.yaml`,h=/\.ya?ml$/i.test(u)?u:`${u}.yaml`;s.value=h;try{let d=await Kt.save(h,c,l);i.say(`Saved as ${d.saved}.`),r.hidden=!0}catch(d){throw r.hidden=!(d instanceof Bi&&d.status===409),d}await o()});return s.addEventListener("input",()=>{r.hidden=!0}),s.addEventListener("keydown",l=>{l.key==="Enter"&&a(!1)}),n.addEventListener("change",()=>{cs(i,async()=>{let l=n.value;l!==""&&(i.load(await Kt.study(l),l),s.value=/\.ya?ml$/i.test(l)?l:"",n.value="")})}),o(),X("span",{class:"pick"},X("label",{for:e,class:"hidden",text:"Open a study"}),n,X("label",{for:t,class:"hidden",text:"Name of the study"}),s,yt("Save",()=>{a(!1)},{title:"Save the study as YAML into the working folder"}),r)}function Vp(i){let e=()=>i.name().replace(/[^\w.-]+/g,"_")||"robot",t=(n,s,r)=>cs(i,async()=>{let o=i.sheet();if(!o)return;i.say(`Making the ${n} …`);let a=await i.runner.file(n,o,l=>i.say(`Making the ${n}: ${l.stage||l.state} …`));Tx(a,`${e()}${s}`,r),i.say(`The ${n} is among your downloads.`)});return X("span",{class:"pick",role:"group","aria-label":"Export"},yt("Report",()=>{t("report",".html","text/html")},{title:"This run as one page that needs no network"}),yt("Data",()=>{t("data",".nc","application/x-netcdf")},{title:"All series of this run as NetCDF (result.nc)"}),yt("YAML",()=>{cs(i,async()=>{let n=i.sheet();n&&Ys((await Kt.yaml(n)).yaml,`${e()}.yaml`,"application/yaml")})},{title:"The study as a data sheet"}))}function Tx(i,e,t){let n=URL.createObjectURL(new Blob([i],{type:t}));X("a",{href:n,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}async function cs(i,e){try{await e()}catch(t){if(!(t instanceof Bi))throw t;i.wrong(t.errors)}}var Rx=[[1e10,1e-9,"G"],[1e7,1e-6,"M"],[1e4,.001,"k"],[.1,1,""],[1e-4,1e3,"m"],[1e-7,1e6,"µ"],[1e-11,1e9,"n"]],Cx=["m","rad","s"],Px=["Hz","%","rad/s"],Lx="⁰¹²³⁴⁵⁶⁷⁸⁹";function Ar(i){let e=i.trim().replace(/[* ]/g,"·").replace("^2","²").replace("^3","³").replace("ohm","Ω");return["-","1","–"].includes(e)?"":e}function Un(i,e=4){return i===0?"0":String(Number(i.toPrecision(e)))}function Gp(i){if(i===0)return"0";let[e,t]=i.toExponential(1).split("e"),n=[...String(Number(t))].map(s=>s==="-"?"⁻":Lx[Number(s)]).join("");return`${e} × 10${n}`}function Hh(i,e){let t=Ar(i);if(!t||Px.includes(i)||!(e>0))return{factor:1,name:t};let n=Cx.includes(i.split("/")[0]),s=Rx.find(([r,o])=>e>=r&&(o>=1||!n));return s?{factor:s[1],name:s[2]+t}:{factor:1,name:t}}function Zs(i,e){if(i===null||!Number.isFinite(i))return"–";let t=Math.abs(i),{factor:n,name:s}=Hh(e,t);return`${t>0&&(n===1?t<.001:t<1e-11)?Gp(i):Un(i*n)} ${s}`.trimEnd()}function ei(i){let e=Math.abs(i);return e!==0&&(e<.001||e>=1e6)?Gp(i):Un(i)}function lo(i){if(i.includes("."))return i;let e=i.replaceAll("_"," ");return e.charAt(0).toUpperCase()+e.slice(1)}function Hp(i,e){return(e??i.unit??"").split("|").map(Ar).join(" or ")}function Ll(i){let e=[i.exclusiveMinimum===void 0?"":`greater than ${i.exclusiveMinimum}`,i.minimum===void 0?"":`at least ${i.minimum}`,i.maximum===void 0?"":`at most ${i.maximum}`,i.rigid_when_infinite?".inf: rigid":""].filter(Boolean).join(", ");return[(i.description??"").split(`
`)[0].replace(/ \[[^\]]*\]$/,""),i.symbol&&i.symbol!=="-"?`symbol ${i.symbol}`:"",e].filter(Boolean).join("; ")}function Wp(i,e,t,n,s){switch(e.kind){case"yes":return Nx(i,e.schema,s);case"word":return Fx(i,e.schema,e.words,s);case"number":return Ix(i,e.schema,t,n,s);default:return Dx(i,e.schema,n,s)}}function Il(i,e,t,n=null){let s=jt("field");t.id=s;let r=Ll(e),o=X("label",{for:s,title:r},document.createTextNode(lo(i)));return e.symbol&&e.symbol!=="-"&&o.append(X("span",{class:"symbol",text:` ${e.symbol}`})),t.title=r,X("div",{class:"field"},o,X("span",{class:"entry"},t,n))}function Ix(i,e,t,n,s){let r=X("input",{type:"text",inputmode:"decimal",autocomplete:"off",spellcheck:"false",class:"number",placeholder:n?"not set":Wh(e.default)});return r.addEventListener("change",()=>s(Xh(r.value))),{element:Il(i,e,r,X("span",{class:"unit",text:t})),input:r,set:o=>{r.value=Wh(o)}}}function Xh(i){let e=i.trim();if(e==="")return;let t=Number(e);return Number.isFinite(t)?t:e}function Wh(i){return i==null?"":typeof i=="number"?String(i):typeof i=="string"?i:JSON.stringify(i)}function Dx(i,e,t,n){let s=X("input",{type:"text",maxlength:e.maxLength===void 0?void 0:String(e.maxLength),placeholder:t?"not set":void 0});return s.addEventListener("change",()=>n(s.value===""&&(t||e.default!==void 0)?void 0:s.value)),{element:Il(i,e,s),input:s,set:r=>{s.value=Wh(r)}}}function Fx(i,e,t,n){let s=X("select",{},...t.map(r=>X("option",{value:r,text:r.replaceAll("_"," ")})));return s.addEventListener("change",()=>n(s.value)),{element:Il(i,e,s),input:s,set:r=>{s.value=String(r??e.default??t[0])}}}function Nx(i,e,t){let n=X("input",{type:"checkbox"});return n.addEventListener("change",()=>t(n.checked)),{element:Il(i,e,n),input:n,set:s=>{n.checked=!!(s??e.default)}}}function Rs(i){return typeof i=="object"&&i!==null&&!Array.isArray(i)}function Er(i,e){let t=i;for(let n of e)if(Array.isArray(t))t=t[Number(n)];else if(Rs(t))t=Object.hasOwn(t,n)?t[n]:void 0;else return;return t}function Dl(i,e,t){let n=i;e.slice(0,-1).forEach((s,r)=>{let o=Er(n,[s]);o==null&&(o=typeof e[r+1]=="number"?[]:{},Xp(n,s,o)),n=o}),Xp(n,e[e.length-1],t)}function Xp(i,e,t){Array.isArray(i)?t===void 0?i.splice(Number(e),1):i[Number(e)]=t:Rs(i)&&(t===void 0?delete i[e]:i[e]=t)}function qh(i){return JSON.parse(JSON.stringify(i))}function ua(i){return i.join("\0")}var Ux=new Set(["format","kind"]),Fl=class{constructor(e,t,n,s,r){this.element=e;this.forms=t;this.sheet=n;this.units=s;this.changed=r;this.build()}element;forms;sheet;units;changed;fields=new Map;groups=new Map;opened=new Set;marked=[];build(){this.fields.clear(),this.groups.clear();let e=Object.entries(this.forms.root.properties??{}).filter(([t])=>!Ux.has(t));this.element.replaceChildren(...e.map(([t,n])=>this.part(t,n,[t],!this.forms.root.required?.includes(t))))}refresh(){for(let{field:e,steps:t}of this.fields.values())document.activeElement!==e.input&&e.set(Er(this.sheet,t))}mark(e){this.marked.forEach(t=>t()),this.marked=[];for(let t of e){let n=t.steps?this.find(t.steps):null;if(!n)continue;let s=jt("wrong"),r=X("p",{class:"wrong",id:s,text:`${t.message}. ${t.mend}`});(n.closest(".field")??n).after(r),n.setAttribute("aria-invalid","true"),n.setAttribute("aria-describedby",s),this.marked.push(()=>{r.remove(),n.removeAttribute("aria-invalid"),n.removeAttribute("aria-describedby")})}}focus(e){let t=this.find(e);t?.scrollIntoView({block:"center"}),(t?.matches("details")?t.querySelector("summary"):t)?.focus()}find(e){let t=null;for(let n=1;n<=e.length;n+=1){let s=ua(e.slice(0,n)),r=this.groups.get(s);r?.open(),t=this.fields.get(s)?.field.input??r?.element??t}return t}part(e,t,n,s){let r=Er(this.sheet,n),o=this.forms.shape(t,r),a=s&&this.forms.optional(t);if(o.kind==="fixed")return X("div",{hidden:!0});if(o.kind==="group"||o.kind==="map"||o.kind==="choice"||o.kind==="list"&&!this.short(o,r))return this.group(e,t,o,n,a);if(o.kind==="list")return this.inline(e,o,n);let l=Hp({...this.forms.resolved(t),unit:o.schema.unit??this.forms.resolved(t).unit},this.units[n.join(".")]),c={...o.schema,...Ox(this.forms.resolved(t))},u=Wp(e,{...o,schema:c},l,s,h=>this.set(n,h===void 0&&typeof n[n.length-1]=="number"?null:h));return u.set(r),this.fields.set(ua(n),{field:u,steps:n}),u.element}short(e,t){let n=this.forms.shape(e.item(0),void 0);return(n.kind==="number"||n.kind==="text")&&e.least===e.most&&e.least<=4&&(t==null||Array.isArray(t))}inline(e,t,n){let s=X("div",{class:"vector",role:"group","aria-label":lo(e)},X("span",{class:"vector-name",text:lo(e),title:Ll(t.schema)}));for(let r=0;r<t.least;r+=1)s.append(this.part(String(r+1),t.item(r),[...n,r],!1));return s}group(e,t,n,s,r){let o=ua(s),a=this.forms.resolved(t),l=X("summary",{title:Ll(a),tabindex:"0"},X("span",{text:lo(e)})),c=X("div",{class:"group"}),u=X("details",{"data-path":s.join(".")},l,c),h=()=>{c.childElementCount===0&&c.append(...this.inside(t,n,s,r))},d=()=>{h(),u.open=!0};return u.addEventListener("toggle",()=>{u.open&&h(),u.open?this.opened.add(o):this.opened.delete(o)}),this.groups.set(o,{element:u,open:d}),this.opened.has(o)&&d(),u}inside(e,t,n,s){let r=Er(this.sheet,n);if(r==null&&(s||t.kind==="choice"))return[yt("Add",()=>this.set(n,this.forms.fresh(e),!0),{class:"add"})];let a=s?[yt("Remove",()=>this.set(n,void 0,!0),{class:"remove"})]:[];return t.kind==="choice"?[...this.alternatives(t,n,r),...a]:t.kind==="group"?[...t.fields.map(([l,c])=>this.part(l,c,[...n,l],!t.required.has(l))),...a]:t.kind==="map"?[...this.entries(t.item,n,r),...a]:t.kind==="list"?[...this.items(t,n,r),...a]:a}alternatives(e,t,n){let s=this.forms.chosen(e.choices,e.key,n),r=jt("choice"),o=X("select",{id:r},...e.choices.map(c=>X("option",{value:c.name,text:c.name.replaceAll("_"," "),selected:c===s})));o.addEventListener("change",()=>{let c=e.choices.find(u=>u.name===o.value);c&&this.set(t,this.forms.fresh(c.schema,n),!0)});let a=X("div",{class:"field"},X("label",{for:r,text:lo(e.key||"kind")}),X("span",{class:"entry"},o));if(!s)return[a];let l=this.forms.shape(s.schema,n);return l.kind==="group"?[a,...l.fields.filter(([c])=>c!==e.key).map(([c,u])=>this.part(c,u,[...t,c],!l.required.has(c)))]:[a,this.part("value",s.schema,t,!1)]}items(e,t,n){let s=Array.isArray(n)?n:[],r=s.map((a,l)=>{let c=this.part(qp(a,l),e.item(l),[...t,l],!1),u=s.length>e.least?yt("Remove",()=>this.set([...t,l],void 0,!0),{class:"remove","aria-label":`Remove ${qp(a,l)}`}):null;return X("div",{class:"item"},c,u)}),o=()=>this.set([...t,s.length],this.forms.fresh(e.item(s.length),s.at(-1)??null),!0);return s.length<e.most?[...r,yt("Add",o,{class:"add"})]:r}entries(e,t,n){let r=(Rs(n)?Object.keys(n):[]).map(c=>X("div",{class:"item"},this.part(c,e,[...t,c],!1),yt("Remove",()=>this.set([...t,c],void 0,!0),{class:"remove","aria-label":`Remove ${c}`}))),o=jt("name"),a=X("input",{id:o,type:"text",spellcheck:"false",autocomplete:"off",placeholder:"gear.stiffness"}),l=yt("Add",()=>{a.value.trim()&&this.set([...t,a.value.trim()],1,!0)},{class:"add"});return[...r,X("div",{class:"field"},X("label",{for:o,text:"Another name"}),X("span",{class:"entry"},a,l))]}set(e,t,n=!1){Dl(this.sheet,e,t),n&&(e.forEach((s,r)=>this.opened.add(ua(e.slice(0,r+1)))),this.build()),this.changed(n)}};function qp(i,e){if(Rs(i)){for(let t of["name","joint","point","type"])if(typeof i[t]=="string")return i[t]}return String(e+1)}function Ox(i){let e={};for(let t of["description","symbol","default","rigid_when_infinite"])i[t]!==void 0&&Object.assign(e,{[t]:i[t]});return e}function $p(){let i=X("p",{class:"line",role:"status","aria-live":"polite"}),e=X("progress",{max:"1","aria-label":"Progress of the run",hidden:!0}),t=X("div",{class:"errors",role:"alert",hidden:!0}),n=X("div",{class:"doubts",hidden:!0}),s=X("div",{class:"messages"},X("div",{class:"now"},e,i),t,n),r=null,o=l=>{e.hidden=!l,r&&(r.hidden=!l)},a=l=>{o(!1),i.textContent!==l&&(i.textContent=l)};return{element:s,say:a,cancel:l=>{r=l},loaded(l,c){a(`${l}: loaded.`),t.hidden=!0,n.hidden=c.length===0,n.replaceChildren(...c.map(u=>X("p",{text:`Looks odd: ${u}`})))},progress(l,c){o(!0),e.value=c,i.textContent=`${l||"starting"}: ${Math.round(100*c)} %`},done(l,c,u){t.hidden=!0;let h=l.runs[0],f=Object.entries(c.told.seconds??{}).filter(([_])=>_!=="loops").reduce((_,[,g])=>_+g,0),m=h.warnings.length?` ${h.warnings.length===1?"One warning":`${h.warnings.length} warnings`}: ${h.warnings.join(" ")}`:"";a(`${h.success?"":`${h.status}: ${h.message} `}New curves after ${Math.round(u)} ms, of which the server took ${Math.round(1e3*f)} ms.${m}`)},wrong(l,c){a(""),t.hidden=!1,t.replaceChildren(...l.map(u=>{let h=[u.where,u.path].filter(Boolean).join(" · "),d=u.steps?yt(h,()=>c(u),{class:"place",title:"Go to the field"}):X("strong",{text:h}),f=u.mend&&!u.message.includes(u.mend)?X("span",{class:"mend",text:` ${u.mend}`}):null;return X("p",{},d,X("span",{text:` ${u.message}${f?".":""}`}),f)}))}}}var $h=300,Yp=.25,Bx=500,Nl=class{constructor(e){this.listener=e}listener;client=crypto.randomUUID();wanted=null;calm=0;running=null;want(e){clearTimeout(this.calm),this.wanted=qh(e),this.running===null?this.next():performance.now()-this.running.since>$h?this.end():setTimeout(()=>this.wanted&&this.running&&performance.now()-this.running.since>$h&&this.end(),$h+10)}async cancel(){this.wanted=null,this.end()}end(){this.running===null||this.running.unwanted||(this.running.unwanted=!0,this.running.job!==null&&Kt.cancel(this.running.job).catch(()=>{}))}async next(){for(;this.wanted!==null;){let e=this.wanted;this.wanted=null;let t=performance.now();this.running={job:null,since:t,unwanted:!1};try{await this.run(e,t)}catch(n){this.listener.wrong(n instanceof Bi?n.errors:[{path:"",message:String(n),got:"",expected:"",mend:"",where:"",steps:null}])}this.running=null}}async run(e,t){this.listener.begun();let n=await Kt.begin("curves",e,this.client);for(this.running&&(this.running.job=n.job),this.running?.unwanted&&await Kt.cancel(n.job);n.state==="waiting"||n.state==="running";)n=await Kt.look(n.job,Yp),n.state==="running"&&this.listener.progress(n,performance.now()-t);if(n.state==="error")this.listener.wrong(n.errors);else if(n.state==="cancelled")this.wanted===null&&this.listener.cancelled();else{let s=await Kt.page(n.job);this.listener.done(s,n,performance.now()-t),this.calm=window.setTimeout(()=>{this.modes(e)},Bx)}}async modes(e){let t=this.calm;try{let n=await this.over("page",e,()=>{});if(n.state!=="done")return;let s=await Kt.page(n.job);this.calm===t&&this.running===null&&this.wanted===null&&this.listener.whole(s)}catch(n){if(!(n instanceof Bi))throw n}}async over(e,t,n){let s=await Kt.begin(e,t,this.client);for(;s.state==="waiting"||s.state==="running";)s=await Kt.look(s.job,Yp),n(s);return s}async file(e,t,n){let s=await this.over(e,qh(t),n);if(s.state!=="done")throw new Bi(s.errors,422);return Kt.bytes(s.job)}};var Ul=class{constructor(e){this.root=e}root;resolved(e){if(e.$ref===void 0)return e;let{$ref:t,...n}=e;return{...this.resolved(this.root.$defs?.[t.replace("#/$defs/","")]??{}),...n}}optional(e){return(this.resolved(e).anyOf??[]).some(t=>this.resolved(t).type==="null")}shape(e,t){let n=this.resolved(e);if(n.const!==void 0)return{kind:"fixed",schema:n};if(n.enum)return{kind:"word",schema:n,words:n.enum};if(n.oneOf)return this.choice(n,n.oneOf);if(n.anyOf)return this.shape(this.branch(n,n.anyOf,t),t);switch(n.type){case"object":return this.object(n);case"array":return this.list(n);case"number":case"integer":return{kind:"number",schema:n,whole:n.type==="integer"};case"boolean":return{kind:"yes",schema:n};default:return{kind:"text",schema:n}}}object(e){if(e.properties)return{kind:"group",schema:e,fields:Object.entries(e.properties),required:new Set(e.required??[])};let t=e.additionalProperties;return{kind:"map",schema:e,item:typeof t=="object"?{unit:e.unit,...t}:{}}}list(e){let t=e.prefixItems,n={unit:e.unit,symbol:e.symbol};return{kind:"list",schema:e,item:r=>({...n,...t?.[r]??e.items??{}}),least:e.minItems??0,most:e.maxItems??1e3}}branch(e,t,n){let s=t.map(u=>this.resolved(u)).filter(u=>u.type!=="null"),r=u=>u.type==="number"||u.type==="integer"||(u.anyOf??[]).some(r),o=s.filter(u=>!(u.type==="string"&&s.some(h=>h!==u&&(r(h)||h.type==="array")))),a=u=>Array.isArray(n)?u.type==="array":Rs(n)?u.type==="object"||u.oneOf!==void 0:typeof n=="number"||typeof n=="string"?r(u)||u.type==="string"||u.enum!==void 0||u.oneOf!==void 0:!1,{anyOf:l,...c}=e;return{...o.find(a)??o[0]??{},...kx(c)}}choice(e,t){let n=t.map(o=>this.resolved(o)),s=e.discriminator?.propertyName??this.commonConstant(n),r=n.map(o=>({name:this.nameOf(o,s),schema:o}));return{kind:"choice",schema:e,choices:r,key:s}}commonConstant(e){return e.flatMap(n=>Object.entries(n.properties??{}).filter(([,s])=>this.resolved(s).const!==void 0).map(([s])=>s))[0]??""}nameOf(e,t){let n=e.properties?.[t],s=n?this.resolved(n).const:void 0;return typeof s=="string"?s:e.type==="string"?"by name":(e.title??"given").toLowerCase()}chosen(e,t,n){if(typeof n=="string")return e.find(o=>o.schema.type==="string");if(!Rs(n))return;let s=n[t];return e.find(o=>s!==void 0&&o.name===s)??e.find(o=>o.schema.type!=="string"&&o.schema.properties?.[t]===void 0)}fresh(e,t){let n=this.resolved(e),s=this.shape(e,t);if(s.kind==="fixed")return n.const??null;if(n.default!==void 0&&n.default!==null)return n.default;if(s.kind==="word")return s.words[0];if(s.kind==="choice")return this.fresh(s.choices[0].schema,t);if(s.kind==="number")return(s.schema.exclusiveMinimum??-1)>=0||(s.schema.minimum??0)>0?1:0;if(s.kind==="yes")return!1;if(s.kind==="text")return"";if(s.kind==="map")return{};if(s.kind==="list")return Array.from({length:s.least},(l,c)=>this.fresh(s.item(c)));if(s.kind!=="group")return null;let r=s,o=Rs(t)?t:{},a=r.fields.filter(([l,c])=>r.required.has(l)||this.resolved(c).const!==void 0||l in o&&this.shape(c,o[l]).kind!=="fixed").map(([l,c])=>[l,l in o&&this.resolved(c).const===void 0?o[l]:this.fresh(c)]);return Object.fromEntries(a)}};function kx(i){let e={};for(let t of["title","description","unit","symbol","default","rigid_when_infinite"])i[t]!==void 0&&Object.assign(e,{[t]:i[t]});return e}function Zp(i){let e=new Set,t=0,n=0,s=()=>e.forEach(l=>l(a)),r={time:0,duration:i,playing:!1},o=l=>{let c=Math.min(.25,(l-n)/1e3);n=l,r.time+=c*a.speed,r.time>=r.duration&&(r.time=0),s(),r.playing&&(t=requestAnimationFrame(o))},a={get time(){return r.time},get duration(){return r.duration},get playing(){return r.playing},speed:1,seek(l){r.time=Math.min(Math.max(l,0),r.duration),s()},play(){r.playing||(r.playing=!0,n=performance.now(),t=requestAnimationFrame(o),s())},pause(){r.playing=!1,cancelAnimationFrame(t),s()},toggle(){r.playing?a.pause():a.play()},setDuration(l){r.duration=l,a.seek(r.time)},subscribe(l){return e.add(l),()=>e.delete(l)}};return a}function Jp(i,e,t,n){let[s,r]=n??t.span??[i[0],i[i.length-1]],o=1e-9*Math.max(1,Math.abs(r)),a=zx(i,Array.from(i.keys()).filter(p=>i[p]>=s-o&&i[p]<=r+o)),l=Float64Array.from(a,p=>e[p]),c=l.length;if(c<4)return{x:new Float64Array,y:new Float64Array};let u=(i[a[c-1]]-i[a[0]])/(c-1),h=Vx(l),d=2**Math.ceil(Math.log2(4*c)),f=new Float64Array(d),m=new Float64Array(d);f.set(l),Gx(f,m);let _=t.at.data[t.at.data.length-1],g=Math.min(d/2,Math.floor(_*d*u)+1);return{x:Float64Array.from({length:g},(p,v)=>v/(d*u)),y:Float64Array.from({length:g},(p,v)=>2*Math.hypot(f[v],m[v])/h)}}function zx(i,e){if(e.length<3)return e;let t=s=>i[e[s]]-i[e[s-1]];return Math.abs(t(e.length-1)/t(1)-1)>1e-6?e.slice(0,-1):e}function Vx(i){let e=i.length,t=(e-1)/2,n=i.reduce((a,l)=>a+l,0)/e,s=e*(e*e-1)/12,r=i.reduce((a,l,c)=>a+(c-t)*l,0)/s,o=0;for(let a=0;a<e;a+=1){let l=.5-.5*Math.cos(2*Math.PI*a/e);i[a]=l*(i[a]-n-r*(a-t)),o+=l}return o}function Gx(i,e){let t=i.length;for(let n=1,s=0;n<t;n+=1){let r=t>>1;for(;s&r;r>>=1)s^=r;s^=r,n<s&&([i[n],i[s]]=[i[s],i[n]],[e[n],e[s]]=[e[s],e[n]])}for(let n=2;n<=t;n*=2)Hx(i,e,n)}function Hx(i,e,t){let n=t/2;for(let s=0;s<n;s+=1){let r=-2*Math.PI*s/t,[o,a]=[Math.cos(r),Math.sin(r)];for(let l=s;l<i.length;l+=t){let c=l+n,u=i[c]*o-e[c]*a,h=i[c]*a+e[c]*o;[i[c],e[c]]=[i[l]-u,e[l]-h],[i[l],e[l]]=[i[l]+u,e[l]+h]}}}function Kp(i){let e=new Map;return i.runs.forEach((t,n)=>t.charts.forEach(s=>{let r=e.get(s.id);r?r.runs.push({run:n,name:t.name,chart:s}):e.set(s.id,{chart:s,runs:[{run:n,name:t.name,chart:s}]})})),[...e.values()]}function Yh(i,e){let t=i.runs.flatMap(({run:r,name:o,chart:a})=>a.curves.map(l=>({run:r,runName:o,label:l.label,role:l.role,x:a.at.data,y:l.values.data,shown:l.shown&&(i.runs.length<2||Wx(l,a)),ghost:e!==null&&r===0})));if(e===null)return t;let n=i.runs.find(({run:r})=>r===0),s=(n?.chart.curves??[]).flatMap(r=>Xx(r,n.chart,n.name,e));return[...t,...s]}function Wx(i,e){return i.role==="real"&&i.label===e.curves[0].label}function Xx(i,e,t,n){let s=qx(i,n);if(s===null)return[];let{x:r,y:o}=e.abscissa==="time"?{x:n.times,y:s}:Jp(n.times,s,e,n.span);return[{run:0,runName:t,label:i.label,role:i.role,x:r,y:o,shown:i.shown,ghost:!1}]}function qx(i,e){let t=i.source;if(t===null)return null;let n=jp(e,t.variable,t.index),s=t.less?jp(e,t.less.variable,t.less.index):null;return n===null||t.less&&s===null?null:n.map((r,o)=>t.factor*(r-(s?s[o]:0)))}function jp(i,e,t){let n=i.series[e];if(n===void 0)return null;let s=n.shape.slice(1).reduce((r,o)=>r*o,1);return t>=s?null:Float64Array.from({length:n.shape[0]},(r,o)=>n.data[o*s+t])}function Ol(i,e){let t=[...new Set(i.map(s=>s.x))],n=t.every(s=>Qp(s,t[0]))?t[0]:$x(t);return[n,...i.map(s=>Yx(s,n,e))]}function Qp(i,e){if(i===e)return!0;if(i.length!==e.length)return!1;for(let t=0;t<i.length;t+=1)if(Math.abs(i[t]-e[t])>1e-6*Math.abs(e[t]))return!1;return!0}function $x(i){let e=i.flatMap(t=>Array.from(t)).sort((t,n)=>t-n);return e.filter((t,n)=>n===0||t>e[n-1])}function Yx(i,e,t){let n=r=>t?r===0?null:Math.abs(r):r;if(e===i.x||Qp(e,i.x))return Array.from(i.y,r=>n(r));let s=new Array(e.length).fill(null);for(let r=0,o=0;r<i.x.length;r+=1){for(;o<e.length&&e[o]<i.x[r];)o+=1;o<e.length&&(s[o]=n(i.y[r]))}return s}function em(i,e){let{x:t,y:n}=i,s=t.length-1;if(s<0||e<t[0]-1e-9||e>t[s]+1e-6*Math.abs(t[s])+1e-9)return null;let r=0,o=s;for(;o-r>1;){let a=r+o>>1;t[a]<=e?r=a:o=a}return o===r||e>=t[o]?n[o]:n[r]+(n[o]-n[r])*(e-t[r])/(t[o]-t[r])}function tm(i,e,t){let[n,...s]=Ol(i,!1),r=new Set(i.map(l=>l.run)).size>1,o=i.map(l=>`${[r?l.runName:"",l.label,l.role,l.ghost?"original":""].filter(Boolean).join(" ")} [${t||"-"}]`),a=Array.from(n,(l,c)=>[l,...s.map(u=>u[c]??"")].map(Zx).join(","));return`${[e,...o].map(Jx).join(",")}
${a.join(`
`)}
`}function Zx(i){return typeof i=="string"?i:String(Number(i.toPrecision(9)))}function Jx(i){return`"${(/^[=+\-@\t\r]/.test(i)?`'${i}`:i).replaceAll('"','""')}"`}var nm=["--blue","--red","--green","--violet","--ochre","--sky"],jx={real:"--blue",reference:"--red",rigid:"--quiet",stationary:"--green",oscillatory:"--violet",limit:"--quiet",other:"--ochre"},im={real:[],reference:[6,3],rigid:[2,3],stationary:[9,2,2,2],oscillatory:[2,2],limit:[1,3],other:[10,3]},sm=[[],[7,2],[6,2,2,2],[2,2],[9,2,2,2,2,2],[12,4]],rm={real:"real",reference:"reference",rigid:"rigid",stationary:"stationary part",oscillatory:"oscillatory part",limit:"limit",other:"other"};function ha(i,e,t,n){if(!t)return{property:jx[i],dash:im[i]};let s=n>1?im[i]:sm[e%sm.length];return{property:nm[e%nm.length],dash:s}}function us(i){return getComputedStyle(document.documentElement).getPropertyValue(i).trim()||"#808080"}function om(i,e){let t=i.filter(d=>!d.ghost),n=[d=>String(d.run),d=>d.label,d=>d.role],s=n.map(d=>[...new Set(t.map(d))]),r=n.map((d,f)=>new Set(s[f].filter(m=>!t.some(_=>_.shown&&d(_)===m)))),o=s[0].length>1?0:s[1].length>1?1:2,a=s[2].length,l=d=>{let f=o===0&&s[1].length>1&&a===1?s[1].length:a,m=ha(d.role,s[o].indexOf(n[o](d)),o<2,f);return o===0&&a===1?{...m,dash:ha("real",s[1].indexOf(d.label),!0,1).dash}:m},c=X("div",{class:"legend"}),u=new Map;n.forEach((d,f)=>{if(s[f].length<2&&f!==o)return;let m=X("div",{class:"legend-row",role:"group","aria-label":["Runs","Curves","Parts"][f]});for(let _ of s[f]){let g=t.find(p=>d(p)===_);g&&m.append(h(g,_,f))}c.append(m)});function h(d,f,m){let _=m===0?d.runName:m===2&&a>1?rm[d.role]:d.label,g=m===o?l(d):{property:"--quiet",dash:m===2?l(d).dash:[]},p=Cl(`var(${g.property})`,m===o&&o<2&&a>1?[]:g.dash),v=X("span",{class:"value"}),T=X("button",{type:"button",class:"toggle","aria-pressed":String(!r[m].has(f))},p,X("span",{text:_}),v);return m===o&&u.set(f,v),T.addEventListener("click",()=>{r[m].delete(f)||r[m].add(f),T.setAttribute("aria-pressed",String(!r[m].has(f))),e()}),T}return{element:c,look:l,renew(d){t=d.filter(f=>!f.ghost)},shows:d=>n.every((f,m)=>!r[m].has(f(d))),tell(d){for(let[f,m]of u){let _=t.find(p=>n[o](p)===f&&n.every((v,T)=>!r[T].has(v(p)))),g=_?d(_):null;m.textContent=g===null?"":ei(g).replace("-","−")}}}}var Kx="uplot",Qx="u-hz",ev="u-vt",tv="u-title",nv="u-wrap",iv="u-under",sv="u-over",rv="u-axis",Cr="u-off",ov="u-select",av="u-cursor-x",lv="u-cursor-y",cv="u-cursor-pt",uv="u-legend",hv="u-live",dv="u-inline",fv="u-series",pv="u-marker",am="u-label",mv="u-value",fa="width",pa="height";var lm="bottom",co="left",Zh="right",dd="#000",cm=dd+"0",Jh="mousemove",um="mousedown",jh="mouseup",hm="mouseenter",dm="mouseleave",fm="dblclick",gv="resize",yv="scroll",pm="change",Gl="dppxchange",fd="--",yo=typeof window<"u",nd=yo?document:null,ho=yo?window:null,_v=yo?navigator:null,wt,Bl;function id(){let i=devicePixelRatio;wt!=i&&(wt=i,Bl&&rd(pm,Bl,id),Bl=matchMedia(`(min-resolution: ${wt-.001}dppx) and (max-resolution: ${wt+.001}dppx)`),Pr(pm,Bl,id),ho.dispatchEvent(new CustomEvent(Gl)))}function pi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function sd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function qt(i,e,t){i.style[e]=t+"px"}function ki(i,e,t,n){let s=nd.createElement(i);return e!=null&&pi(s,e),t?.insertBefore(s,n),s}function Ti(i,e){return ki("div",i,e)}var mm=new WeakMap;function hs(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=mm.get(i);r!=o&&(i.style.transform=r,mm.set(i,r),e<0||t<0||e>n||t>s?pi(i,Cr):sd(i,Cr))}var gm=new WeakMap;function ym(i,e,t){let n=e+t,s=gm.get(i);n!=s&&(gm.set(i,n),i.style.background=e,i.style.borderColor=t)}var _m=new WeakMap;function xm(i,e,t,n){let s=e+""+t,r=_m.get(i);s!=r&&(_m.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var pd={passive:!0},xv={...pd,capture:!0};function Pr(i,e,t,n){e.addEventListener(i,t,n?xv:pd)}function rd(i,e,t,n){e.removeEventListener(i,t,pd)}yo&&id();function zi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:mi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function $m(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Ym=i=>i!=null,Zm=i=>i!=null&&i>0,Xl=$m(Ym),vv=$m(Zm);function bv(i,e,t,n=0,s=!1){let r=s?vv:Xl,o=s?Zm:Ym;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Nt,l??-Nt]}function ql(i,e,t,n){let s=Sm(i),r=Sm(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Cs:Jm,a=s==1?mi:Ri,l=r==1?Ri:mi,c=a(o(bn(i))),u=l(o(bn(e))),h=fo(t,c),d=fo(t,u);return t==10&&(c<0&&(h=Ut(h,-c)),u<0&&(d=Ut(d,-u))),n||t==2?(i=h*s,e=d*r):(i=eg(i,h),e=$l(e,d)),[i,e]}function md(i,e,t,n){let s=ql(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var gd=.1,vm={mode:3,pad:gd},ga={pad:0,soft:null,mode:0},Sv={min:ga,max:ga};function Hl(i,e,t,n){return Yl(t)?bm(i,e,t):(ga.pad=t,ga.soft=n?0:null,ga.mode=n?3:0,bm(i,e,Sv))}function St(i,e){return i??e}function Mv(i,e,t){for(e=St(e,0),t=St(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function bm(i,e,t){let n=t.min,s=t.max,r=St(n.pad,0),o=St(s.pad,0),a=St(n.hard,-Nt),l=St(s.hard,Nt),c=St(n.soft,Nt),u=St(s.soft,-Nt),h=St(n.mode,0),d=St(s.mode,0),f=e-i,m=Cs(f),_=ti(bn(i),bn(e)),g=Cs(_),p=bn(g-m);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,h==2&&c!=Nt&&(r=0),d==2&&u!=-Nt&&(o=0)));let v=f||_||1e3,T=Cs(v),x=fo(10,mi(T)),R=v*(f==0?i==0?.1:1:r),w=Ut(eg(i-R,x/10),24),y=i>=c&&(h==1||h==3&&w<=c||h==2&&w>=c)?c:Nt,M=ti(a,w<y&&i>=y?y:Vi(y,w)),N=v*(f==0?e==0?.1:1:o),I=Ut($l(e+N,x/10),24),L=e<=u&&(d==1||d==3&&I>=u||d==2&&I<=u)?u:-Nt,k=Vi(l,I>L&&e<=L?L:ti(L,I));return M==k&&M==0&&(k=100),[M,k]}var wv=new Intl.NumberFormat(yo?_v.language:"en-US"),yd=i=>wv.format(i),gi=Math,Vl=gi.PI,bn=gi.abs,mi=gi.floor,vn=gi.round,Ri=gi.ceil,Vi=gi.min,ti=gi.max,fo=gi.pow,Sm=gi.sign,Cs=gi.log10,Jm=gi.log2,Av=(i,e=1)=>gi.sinh(i)*e,Kh=(i,e=1)=>gi.asinh(i/e),Nt=1/0;function Mm(i){return(Cs((i^i>>31)-(i>>31))|0)+1}function od(i,e,t){return Vi(ti(i,e),t)}function jm(i){return typeof i=="function"}function _t(i){return jm(i)?i:()=>i}var Ev=()=>{},Km=i=>i,Qm=(i,e)=>e,Tv=i=>null,wm=i=>!0,Am=(i,e)=>i==e,Rv=/\.\d*?(?=9{6,}|0{6,})/gm,Lr=i=>{if(ng(i)||js.has(i))return i;let e=`${i}`,t=e.match(Rv);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Lr(s)}e${r}`}return Ut(i,n)};function Tr(i,e){return Lr(Ut(Lr(i/e))*e)}function $l(i,e){return Lr(Ri(Lr(i/e))*e)}function eg(i,e){return Lr(mi(Lr(i/e))*e)}function Ut(i,e=0){if(ng(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return vn(n)/t}var js=new Map;function tg(i){return((""+i).split(".")[1]||"").length}function _a(i,e,t,n){let s=[],r=n.map(tg);for(let o=e;o<t;o++){let a=bn(o),l=Ut(fo(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?u:Ut(u,h);s.push(d),js.set(d,h)}}return s}var ya={},_d=[],po=[null,null],Js=Array.isArray,ng=Number.isInteger,Cv=i=>i===void 0;function Em(i){return typeof i=="string"}function Yl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Pv(i){return i!=null&&typeof i=="object"}var Lv=Object.getPrototypeOf(Uint8Array),ig="__proto__";function mo(i,e=Yl){let t;if(Js(i)){let n=i.find(s=>s!=null);if(Js(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=mo(i[s],e)}else t=i.slice()}else if(i instanceof Lv)t=i.slice();else if(e(i)){t={};for(let n in i)n!=ig&&(t[n]=mo(i[n],e))}else t=i;return t}function mn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=ig&&(Yl(i[s])?mn(i[s],mo(n[s])):i[s]=mo(n[s]))}return i}var Iv=0,Dv=1,Fv=2;function Nv(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Uv(i,e){if(kv(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return zv(o[0])||(o=Bv(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:Dv,f=[];for(let m=0;m<u.length;m++){let _=u[m],g=r.get(l[m]);_===null?d!=Iv&&(h[g]=_,d==Fv&&f.push(g)):h[g]=_}Nv(h,f,s),n.push(h)}}return n}var Ov=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Bv(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function kv(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function zv(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ti(1,mi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var sg=["January","February","March","April","May","June","July","August","September","October","November","December"],rg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function og(i){return i.slice(0,3)}var Vv=rg.map(og),Gv=sg.map(og),Hv={MMMM:sg,MMM:Gv,WWWW:rg,WWW:Vv};function da(i){return(i<10?"0":"")+i}function Wv(i){return(i<10?"00":i<100?"0":"")+i}var Xv={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>da(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>da(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>da(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>da(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>da(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Wv(i.getMilliseconds())};function xd(i,e){e=e||Hv;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Xv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var qv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function $v(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==qv?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var ag=i=>i%1==0,Wl=[1,2,2.5,5],Yv=_a(10,-32,0,Wl),lg=_a(10,0,32,Wl),Zv=lg.filter(ag),Rr=Yv.concat(lg),vd=`
`,cg="{YYYY}",Tm=vd+cg,ug="{M}/{D}",ma=vd+ug,kl=ma+"/{YY}",hg="{aa}",Jv="{h}:{mm}",uo=Jv+hg,Rm=vd+uo,Cm=":{ss}",Et=null;function dg(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?_a(10,0,3,Wl).filter(ag):_a(10,-3,0,Wl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,cg,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",Tm,Et,Et,Et,Et,Et,1],[s,ug,Tm,Et,Et,Et,Et,Et,1],[n,"{h}"+hg,kl,Et,ma,Et,Et,Et,1],[t,uo,kl,Et,ma,Et,Et,Et,1],[e,Cm,kl+" "+uo,Et,ma+" "+uo,Et,Rm,Et,1],[i,Cm+".{fff}",kl+" "+uo,Et,ma+" "+uo,Et,Rm,Et,1]];function u(h){return(d,f,m,_,g,p)=>{let v=[],T=g>=o,x=g>=r&&g<o,R=h(m),w=Ut(R*i,3),y=Qh(R.getFullYear(),T?0:R.getMonth(),x||T?1:R.getDate()),M=Ut(y*i,3);if(x||T){let N=x?g/r:0,I=T?g/o:0,L=w==M?w:Ut(Qh(y.getFullYear()+I,y.getMonth()+N,1)*i,3),k=new Date(vn(L/i)),V=k.getFullYear(),D=k.getMonth();for(let H=0;L<=_;H++){let $=Qh(V+I*H,D+N*H,1),G=$-h(Ut($*i,3));L=Ut((+$+G)*i,3),L<=_&&v.push(L)}}else{let N=g>=s?s:g,I=mi(m)-mi(w),L=M+I+$l(w-M,N);v.push(L);let k=h(L),V=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,D=g/n,H=d.axes[f]._space,$=p/H;for(;L=Ut(L+g,i==1?0:3),!(L>_);)if(D>1){let G=mi(Ut(V+D,6))%24,K=h(L).getHours()-G;K>1&&(K=-1),L-=K*n,V=(V+D)%24;let te=v[v.length-1];Ut((L-te)/g,3)*$>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,u]}var[jv,Kv,Qv]=dg(1),[eb,tb,nb]=dg(.001);_a(2,-53,53,[1]);function Pm(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Lm(i,e){return(t,n,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,d,f;return n.map(m=>{let _=i(m),g=_.getFullYear(),p=_.getMonth(),v=_.getDate(),T=_.getHours(),x=_.getMinutes(),R=_.getSeconds(),w=g!=l&&a[2]||p!=c&&a[3]||v!=u&&a[4]||T!=h&&a[5]||x!=d&&a[6]||R!=f&&a[7]||a[1];return l=g,c=p,u=v,h=T,d=x,f=R,w(_)})}}function ib(i,e){let t=xd(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Qh(i,e,t){return new Date(i,e,t)}function Im(i,e){return e(i)}var sb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Dm(i,e){return(t,n,s,r)=>r==null?fd:e(i(n))}function rb(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function ob(i,e){return i.series[e].fill(i,e)}var ab={show:!0,live:!0,isolate:!1,mount:Ev,markers:{show:!0,width:2,stroke:rb,fill:ob,dash:"solid"},idx:null,idxs:null,values:[]};function lb(i,e){let t=i.cursor.points,n=Ti(),s=t.size(i,e);qt(n,fa,s),qt(n,pa,s);let r=s/-2;qt(n,"marginLeft",r),qt(n,"marginTop",r);let o=t.width(i,e,s);return o&&qt(n,"borderWidth",o),n}function cb(i,e){let t=i.series[e].points;return t._fill||t._stroke}function ub(i,e){let t=i.series[e].points;return t._stroke||t._fill}function hb(i,e){return i.series[e].points.size}var ed=[0,0];function db(i,e,t){return ed[0]=e,ed[1]=t,ed}function zl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function td(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var fb={show:!0,x:!0,y:!0,lock:!1,move:db,points:{one:!1,show:lb,size:hb,width:0,stroke:ub,fill:cb},bind:{mousedown:zl,mouseup:zl,click:zl,dblclick:zl,mousemove:td,mouseleave:td,mouseenter:td},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},fg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},bd=mn({},fg,{filter:Qm}),pg=mn({},bd,{size:10}),mg=mn({},fg,{show:!1}),Sd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',gg="bold "+Sd,yg=1.5,Fm={show:!0,scale:"x",stroke:dd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:gg,side:2,grid:bd,ticks:pg,border:mg,font:Sd,lineGap:yg,rotate:0},pb="Value",mb="Time",Nm={show:!0,scale:"x",auto:!1,sorted:1,min:Nt,max:-Nt,idxs:[]};function gb(i,e,t,n,s){return e.map(r=>r==null?"":yd(r))}function yb(i,e,t,n,s,r,o){let a=[],l=js.get(s)||0;t=o?t:Ut($l(t,s),l);for(let c=t;c<=n;c=Ut(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ad(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Cs:Jm,u=mi(c(t));s=fo(l,u),l==10&&(s=Rr[zi(s,Rr)]);let h=t,d=s*l;l==10&&(d=Rr[zi(d,Rr)]);do a.push(h),h=h+s,l==10&&!js.has(h)&&(h=Ut(h,js.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Rr[zi(d,Rr)]));while(h<=n);return a}function _b(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?ad(i,e,ti(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?ad(i,e,ti(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var _g=/./,xb=/[12357]/,vb=/[125]/,Um=/1/,ld=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function bb(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?_g:l(7,o)-u>=c?xb:l(5,o)-u>=c?vb:Um;if(h==Um){let d=bn(l(1,o)-u);if(d<c)return ld(e.slice().reverse(),a.distr,h,Ri(c/d)).reverse()}return ld(e,a.distr,h,1)}function Sb(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=bn(l(1,o)-l(2,o));return c<a?ld(e.slice().reverse(),3,_g,Ri(a/c)).reverse():e}function Mb(i,e,t,n){return n==null?fd:e==null?"":yd(e)}var Om={show:!0,scale:"y",stroke:dd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:gg,side:3,grid:bd,ticks:pg,border:mg,font:Sd,lineGap:yg,rotate:0};function wb(i,e){let t=3+(i||1)*2;return Ut(t*e,3)}function Ab(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=bn(o-r),l=i.series[e],c=a/(l.points.space*wt);return n[1]-n[0]<=c}var Bm={scale:null,auto:!0,sorted:0,min:Nt,max:-Nt},xg=(i,e,t,n,s)=>s,km={show:!0,auto:!0,sorted:0,gaps:xg,alpha:1,facets:[mn({},Bm,{scale:"x"}),mn({},Bm,{scale:"y"})]},zm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:xg,alpha:1,points:{show:Ab,filter:null},values:null,min:Nt,max:-Nt,idxs:[],path:null,clip:null};function Eb(i,e,t,n,s){return t/10}var vg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Tb=mn({},vg,{time:!1,ori:1}),Vm={};function bg(i,e){let t=Vm[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(Vm[i]=t)),t}var go=1,cd=2;function Ir(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,_=a.height,g=i.valToPosH,p=i.valToPosV;return u.ori==0?t(s,l,c,u,h,g,p,d,f,m,_,Jl,_o,Kl,Mg,Ag):t(s,l,c,u,h,p,g,f,d,_,m,jl,xo,Ad,wg,Eg)}function Md(i,e){let t=0,n=0,s=St(i.bands,_d);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Rb(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ps(i,e,t,n,s,r){return Ir(i,e,(o,a,l,c,u,h,d,f,m,_,g)=>{let p=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?_o:xo,x,R;v==1?(x=t,R=n):(x=n,R=t);let w=p(h(a[x],c,_,f)),y=p(d(l[x],u,g,m)),M=p(h(a[R],c,_,f)),N=p(d(r==1?u.max:u.min,u,g,m)),I=new Path2D(s);return T(I,M,N),T(I,w,N),T(I,w,y),I})}function Zl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Kl:Ad,l=t;for(let h=0;h<i.length;h++){let d=i[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function Cb(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function wd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[h]),m=d==h?f:r(i[d]),_=h-s;f=o<=0&&_>=0&&_<l?r(i[_]):f;let p=d+s;m=o>=0&&p>=0&&p<l?r(i[p]):m,m>=f&&a.push([f,m])}return a}function Gm(i){return i==0?Km:i==1?vn:e=>Tr(e,i)}function Sg(i){let e=i==0?Jl:jl,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=Vi(c,a/2,l/2),u=Vi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Jl=(i,e,t)=>{i.moveTo(e,t)},jl=(i,e,t)=>{i.moveTo(t,e)},_o=(i,e,t)=>{i.lineTo(e,t)},xo=(i,e,t)=>{i.lineTo(t,e)},Kl=Sg(0),Ad=Sg(1),Mg=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},wg=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Ag=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Eg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Tg(i){return(e,t,n,s,r)=>Ir(e,t,(o,a,l,c,u,h,d,f,m,_,g)=>{let{pxRound:p,points:v}=o,T,x;c.ori==0?(T=Jl,x=Mg):(T=jl,x=wg);let R=Ut(v.width*wt,3),w=(v.size-v.width)/2*wt,y=Ut(w*2,3),M=new Path2D,N=new Path2D,{left:I,top:L,width:k,height:V}=e.bbox;Kl(N,I-y,L-y,k+y*2,V+y*2);let D=H=>{if(l[H]!=null){let $=p(h(a[H],c,_,f)),G=p(d(l[H],u,g,m));T(M,$+w,G),x(M,$,G,w,0,Vl*2)}};if(r)r.forEach(D);else for(let H=n;H<=s;H++)D(H);return{stroke:R>0?M:null,fill:M,clip:N,flags:go|cd}})}function Rg(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Pb=Rg(_o),Lb=Rg(xo);function Cg(i){let e=St(i?.alignGaps,0);return(t,n,s,r)=>Ir(t,n,(o,a,l,c,u,h,d,f,m,_,g)=>{[s,r]=Xl(l,s,r);let p=o.pxRound,v=V=>p(h(V,c,_,f)),T=V=>p(d(V,u,g,m)),x,R;c.ori==0?(x=_o,R=Pb):(x=xo,R=Lb);let w=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:go},M=y.stroke,N=!1;if(r-s>=_*4){let V=ue=>t.posToVal(ue,c.key,!0),D=null,H=null,$,G,le,Y=v(a[w==1?s:r]),K=v(a[s]),te=v(a[r]),fe=V(w==1?K+1:te-1);for(let ue=w==1?s:r;ue>=s&&ue<=r;ue+=w){let Q=a[ue],re=(w==1?Q<fe:Q>fe)?Y:v(Q),me=l[ue];re==Y?me!=null?(G=me,D==null?(x(M,re,T(G)),$=D=H=G):G<D?D=G:G>H&&(H=G)):me===null&&(N=!0):(D!=null&&R(M,Y,T(D),T(H),T($),T(G)),me!=null?(G=me,x(M,re,T(G)),D=H=$=G):(D=H=null,me===null&&(N=!0)),Y=re,fe=V(Y+w))}D!=null&&D!=H&&le!=Y&&R(M,Y,T(D),T(H),T($),T(G))}else for(let V=w==1?s:r;V>=s&&V<=r;V+=w){let D=l[V];D===null?N=!0:D!=null&&x(M,v(a[V]),T(D))}let[L,k]=Md(t,n);if(o.fill!=null||L!=0){let V=y.fill=new Path2D(M),D=o.fillTo(t,n,o.min,o.max,L),H=T(D),$=v(a[s]),G=v(a[r]);w==-1&&([G,$]=[$,G]),x(V,G,H),x(V,$,H)}if(!o.spanGaps){let V=[];N&&V.push(...wd(a,l,s,r,w,v,e)),y.gaps=V=o.gaps(t,n,s,r,V),y.clip=Zl(V,c.ori,f,m,_,g)}return k!=0&&(y.band=k==2?[Ps(t,n,s,r,M,-1),Ps(t,n,s,r,M,1)]:Ps(t,n,s,r,M,k)),y})}function Ib(i){let e=St(i.align,1),t=St(i.ascDesc,!1),n=St(i.alignGaps,0),s=St(i.extend,!1);return(r,o,a,l)=>Ir(r,o,(c,u,h,d,f,m,_,g,p,v,T)=>{[a,l]=Xl(h,a,l);let x=c.pxRound,{left:R,width:w}=r.bbox,y=K=>x(m(K,d,v,g)),M=K=>x(_(K,f,T,p)),N=d.ori==0?_o:xo,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:go},L=I.stroke,k=d.dir*(d.ori==0?1:-1),V=M(h[k==1?a:l]),D=y(u[k==1?a:l]),H=D,$=D;s&&e==-1&&($=R,N(L,$,V)),N(L,D,V);for(let K=k==1?a:l;K>=a&&K<=l;K+=k){let te=h[K];if(te==null)continue;let fe=y(u[K]),ue=M(te);e==1?N(L,fe,V):N(L,H,ue),N(L,fe,ue),V=ue,H=fe}let G=H;s&&e==1&&(G=R+w,N(L,G,V));let[le,Y]=Md(r,o);if(c.fill!=null||le!=0){let K=I.fill=new Path2D(L),te=c.fillTo(r,o,c.min,c.max,le),fe=M(te);N(K,G,fe),N(K,$,fe)}if(!c.spanGaps){let K=[];K.push(...wd(u,h,a,l,k,y,n));let te=c.width*wt/2,fe=t||e==1?te:-te,ue=t||e==-1?-te:te;K.forEach(Q=>{Q[0]+=fe,Q[1]+=ue}),I.gaps=K=c.gaps(r,o,a,l,K),I.clip=Zl(K,d.ori,g,p,v,T)}return Y!=0&&(I.band=Y==2?[Ps(r,o,a,l,L,-1),Ps(r,o,a,l,L,1)]:Ps(r,o,a,l,L,Y)),I})}function Hm(i,e,t,n,s,r,o=Nt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=bn(i[l]-i[a]);u<c&&(c=u,o=bn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function Db(i){i=i||ya;let e=St(i.size,[.6,Nt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_t(s),o=1-e[0],a=St(e[1],Nt),l=St(e[2],1),c=St(i.disp,ya),u=St(i.each,f=>{}),{fill:h,stroke:d}=c;return(f,m,_,g)=>Ir(f,m,(p,v,T,x,R,w,y,M,N,I,L)=>{let k=p.pxRound,V=t,D=n*wt,H=a*wt,$=l*wt,G,le;x.ori==0?[G,le]=r(f,m):[le,G]=r(f,m);let Y=x.dir*(x.ori==0?1:-1),K=x.ori==0?Kl:Ad,te=x.ori==0?u:(Ce,Ye,rt,we,Ft,Ve,qe)=>{u(Ce,Ye,rt,Ft,we,qe,Ve)},fe=St(f.bands,_d).find(Ce=>Ce.series[0]==m),ue=fe!=null?fe.dir:0,Q=p.fillTo(f,m,p.min,p.max,ue),_e=k(y(Q,R,L,N)),re,me,pe,Oe=I,Xe=k(p.width*wt),Ge=!1,dt=null,ct=null,it=null,Yt=null;h!=null&&(Xe==0||d!=null)&&(Ge=!0,dt=h.values(f,m,_,g),ct=new Map,new Set(dt).forEach(Ce=>{Ce!=null&&ct.set(Ce,new Path2D)}),Xe>0&&(it=d.values(f,m,_,g),Yt=new Map,new Set(it).forEach(Ce=>{Ce!=null&&Yt.set(Ce,new Path2D)})));let{x0:Vt,size:cn}=c;if(Vt!=null&&cn!=null){V=1,v=Vt.values(f,m,_,g),Vt.unit==2&&(v=v.map(rt=>f.posToVal(M+rt*I,x.key,!0)));let Ce=cn.values(f,m,_,g);cn.unit==2?me=Ce[0]*I:me=w(Ce[0],x,I,M)-w(0,x,I,M),Oe=Hm(v,T,w,x,I,M,Oe),pe=Oe-me+D}else Oe=Hm(v,T,w,x,I,M,Oe),pe=Oe*o+D,me=Oe-pe;pe<1&&(pe=0),Xe>=me/2&&(Xe=0),pe<5&&(k=Km);let It=pe>0,An=Oe-pe-(It?Xe:0);me=k(od(An,$,H)),re=(V==0?me/2:V==Y?0:me)-V*Y*((V==0?D/2:0)+(It?Xe/2:0));let vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},_n=Ge?null:new Path2D,Qt=null;if(fe!=null)Qt=f.data[fe.series[1]];else{let{y0:Ce,y1:Ye}=c;Ce!=null&&Ye!=null&&(T=Ye.values(f,m,_,g),Qt=Ce.values(f,m,_,g))}let un=G*me,O=le*me;for(let Ce=Y==1?_:g;Ce>=_&&Ce<=g;Ce+=Y){let Ye=T[Ce];if(Ye==null)continue;if(Qt!=null){let q=Qt[Ce]??0;if(Ye-q==0)continue;_e=y(q,R,L,N)}let rt=x.distr!=2||c!=null?v[Ce]:Ce,we=w(rt,x,I,M),Ft=y(St(Ye,Q),R,L,N),Ve=k(we-re),qe=k(ti(Ft,_e)),C=k(Vi(Ft,_e)),S=qe-C;if(Ye!=null){let q=Ye<0?O:un,de=Ye<0?un:O;Ge?(Xe>0&&it[Ce]!=null&&K(Yt.get(it[Ce]),Ve,C+mi(Xe/2),me,ti(0,S-Xe),q,de),dt[Ce]!=null&&K(ct.get(dt[Ce]),Ve,C+mi(Xe/2),me,ti(0,S-Xe),q,de)):K(_n,Ve,C+mi(Xe/2),me,ti(0,S-Xe),q,de),te(f,m,Ce,Ve-Xe/2,C,me+Xe,S)}}return Xe>0?vt.stroke=Ge?Yt:_n:Ge||(vt._fill=p.width==0?p._fill:p._stroke??p._fill,vt.width=0),vt.fill=Ge?ct:_n,vt})}function Fb(i,e){let t=St(e?.alignGaps,0);return(n,s,r,o)=>Ir(n,s,(a,l,c,u,h,d,f,m,_,g,p)=>{[r,o]=Xl(c,r,o);let v=a.pxRound,T=G=>v(d(G,u,g,m)),x=G=>v(f(G,h,p,_)),R,w,y;u.ori==0?(R=Jl,y=_o,w=Ag):(R=jl,y=xo,w=Eg);let M=u.dir*(u.ori==0?1:-1),N=T(l[M==1?r:o]),I=N,L=[],k=[];for(let G=M==1?r:o;G>=r&&G<=o;G+=M)if(c[G]!=null){let Y=l[G],K=T(Y);L.push(I=K),k.push(x(c[G]))}let V={stroke:i(L,k,R,y,w,v),fill:null,clip:null,band:null,gaps:null,flags:go},D=V.stroke,[H,$]=Md(n,s);if(a.fill!=null||H!=0){let G=V.fill=new Path2D(D),le=a.fillTo(n,s,a.min,a.max,H),Y=x(le);y(G,I,Y),y(G,N,Y)}if(!a.spanGaps){let G=[];G.push(...wd(l,c,r,o,M,T,t)),V.gaps=G=a.gaps(n,s,r,o,G),V.clip=Zl(G,u.ori,m,_,g,p)}return $!=0&&(V.band=$==2?[Ps(n,s,r,o,D,-1),Ps(n,s,r,o,D,1)]:Ps(n,s,r,o,D,$)),V})}function Nb(i){return Fb(Ub,i)}function Ub(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=i[d+1]-i[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+h[d]/3,e[d]+l[d]*h[d]/3,i[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,i[d+1],e[d+1])}return a}var ud=new Set;function Wm(){for(let i of ud)i.syncRect(!0)}yo&&(Pr(gv,ho,Wm),Pr(yv,ho,Wm,!0),Pr(Gl,ho,()=>{gn.pxRatio=wt}));var Ob=Cg(),Bb=Tg();function Xm(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>hd(r,o,e,t))}function kb(i,e){return i.map((t,n)=>n==0?{}:mn({},e,t))}function hd(i,e,t,n){return mn({},e==0?t:n,i)}function Pg(i,e,t){return e==null?po:[e,t]}var zb=Pg;function Vb(i,e,t){return e==null?po:Hl(e,t,gd,!0)}function Lg(i,e,t,n){return e==null?po:ql(e,t,i.scales[n].log,!1)}var Gb=Lg;function Ig(i,e,t,n){return e==null?po:md(e,t,i.scales[n].log,!1)}var Hb=Ig;function Wb(i,e,t,n,s){let r=ti(Mm(i),Mm(e)),o=e-i,a=zi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?js.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function qm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=vn((t=+s)*wt))+"px"),[i,e,t]}function Xb(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ut(e[2]*wt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function gn(i,e,t){let n={mode:St(i.mode,1)},s=n.mode;function r(b,A,P,F){let W=A.valToPct(b);return F+P*(A.dir==-1?1-W:W)}function o(b,A,P,F){let W=A.valToPct(b);return F+P*(A.dir==-1?W:1-W)}function a(b,A,P,F){return A.ori==0?r(b,A,P,F):o(b,A,P,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Ti(Kx);if(i.id!=null&&(c.id=i.id),pi(c,i.class),i.title){let b=Ti(tv,c);b.textContent=i.title}let u=ki("canvas"),h=n.ctx=u.getContext("2d"),d=Ti(nv,c);Pr("click",d,b=>{b.target===m&&(Ht!=io||Zt!=so)&&Nn.click(n,b)},!0);let f=n.under=Ti(iv,d);d.appendChild(u);let m=n.over=Ti(sv,d);i=mo(i);let _=+St(i.pxAlign,1),g=Gm(_);(i.plugins||[]).forEach(b=>{b.opts&&(i=b.opts(n,i)||i)});let p=i.ms||.001,v=n.series=s==1?Xm(i.series||[],Nm,zm,!1):kb(i.series||[null],km),T=n.axes=Xm(i.axes||[],Fm,Om,!0),x=n.scales={},R=n.bands=i.bands||[];R.forEach(b=>{b.fill=_t(b.fill||null),b.dir=St(b.dir,-1)});let w=s==2?v[1].facets[0].scale:v[0].scale,y={axes:Es,series:pt},M=(i.drawOrder||["axes","series"]).map(b=>y[b]);function N(b){let A=b.distr==3?P=>Cs(P>0?P:b.clamp(n,P,b.min,b.max,b.key)):b.distr==4?P=>Kh(P,b.asinh):b.distr==100?P=>b.fwd(P):P=>P;return P=>{let F=A(P),{_min:W,_max:j}=b,ce=j-W;return(F-W)/ce}}function I(b){let A=x[b];if(A==null){let P=(i.scales||ya)[b]||ya;if(P.from!=null){I(P.from);let F=mn({},x[P.from],P,{key:b});F.valToPct=N(F),x[b]=F}else{A=x[b]=mn({},b==w?vg:Tb,P),A.key=b;let F=A.time,W=A.range,j=Js(W);if((b!=w||s==2&&!F)&&(j&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?vm:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?vm:{mode:1,hard:W[1],soft:W[1]}},j=!1),!j&&Yl(W))){let ce=W;W=(ge,Se,De)=>Se==null?po:Hl(Se,De,ce)}A.range=_t(W||(F?zb:b==w?A.distr==3?Gb:A.distr==4?Hb:Pg:A.distr==3?Lg:A.distr==4?Ig:Vb)),A.auto=_t(j?!1:A.auto),A.clamp=_t(A.clamp||Eb),A._min=A._max=null,A.valToPct=N(A)}}}I("x"),I("y"),s==1&&v.forEach(b=>{I(b.scale)}),T.forEach(b=>{I(b.scale)});for(let b in i.scales)I(b);let L=x[w],k=L.distr,V,D;L.ori==0?(pi(c,Qx),V=r,D=o):(pi(c,ev),V=o,D=r);let H={};for(let b in x){let A=x[b];(A.min!=null||A.max!=null)&&(H[b]={min:A.min,max:A.max},A.min=A.max=null)}let $=i.tzDate||(b=>new Date(vn(b/p))),G=i.fmtDate||xd,le=p==1?Qv($):nb($),Y=Lm($,Pm(p==1?Kv:tb,G)),K=Dm($,Im(sb,G)),te=[],fe=n.legend=mn({},ab,i.legend),ue=n.cursor=mn({},fb,{drag:{y:s==2}},i.cursor),Q=fe.show,_e=ue.show,re=fe.markers;fe.idxs=te,re.width=_t(re.width),re.dash=_t(re.dash),re.stroke=_t(re.stroke),re.fill=_t(re.fill);let me,pe,Oe,Xe=[],Ge=[],dt,ct=!1,it={};if(fe.live){let b=v[1]?v[1].values:null;ct=b!=null,dt=ct?b(n,1,0):{_:0};for(let A in dt)it[A]=fd}if(Q)if(me=ki("table",uv,c),Oe=ki("tbody",null,me),fe.mount(n,me),ct){pe=ki("thead",null,me,Oe);let b=ki("tr",null,pe);ki("th",null,b);for(var Yt in dt)ki("th",am,b).textContent=Yt}else pi(me,dv),fe.live&&pi(me,hv);let Vt={show:!0},cn={show:!1};function It(b,A){if(A==0&&(ct||!fe.live||s==2))return po;let P=[],F=ki("tr",fv,Oe,Oe.childNodes[A]);pi(F,b.class),b.show||pi(F,Cr);let W=ki("th",null,F);if(re.show){let ge=Ti(pv,W);if(A>0){let Se=re.width(n,A);Se&&(ge.style.border=Se+"px "+re.dash(n,A)+" "+re.stroke(n,A)),ge.style.background=re.fill(n,A)}}let j=Ti(am,W);b.label instanceof HTMLElement?j.appendChild(b.label):j.textContent=b.label,A>0&&(re.show||(j.style.color=b.width>0?re.stroke(n,A):re.fill(n,A)),vt("click",W,ge=>{if(ue._lock)return;Ke(ge);let Se=v.indexOf(b);if((ge.ctrlKey||ge.metaKey)!=fe.isolate){let De=v.some((Fe,Ue)=>Ue>0&&Ue!=Se&&Fe.show);v.forEach((Fe,Ue)=>{Ue>0&&rs(Ue,De?Ue==Se?Vt:cn:Vt,!0,pn.setSeries)})}else rs(Se,{show:!b.show},!0,pn.setSeries)},!1),Qe&&vt(hm,W,ge=>{ue._lock||(Ke(ge),rs(v.indexOf(b),oo,!0,pn.setSeries))},!1));for(var ce in dt){let ge=ki("td",mv,F);ge.textContent="--",P.push(ge)}return[F,P]}let An=new Map;function vt(b,A,P,F=!0){let W=An.get(A)||{},j=ue.bind[b](n,A,P,F);j&&(Pr(b,A,W[b]=j),An.set(A,W))}function _n(b,A,P){let F=An.get(A)||{};for(let W in F)(b==null||W==b)&&(rd(W,A,F[W]),delete F[W]);b==null&&An.delete(A)}let Qt=0,un=0,O=0,Ce=0,Ye=0,rt=0,we=Ye,Ft=rt,Ve=O,qe=Ce,C=0,S=0,q=0,de=0;n.bbox={};let ae=!1,ve=!1,be=!1,ne=!1,se=!1,ye=!1;function U(b,A,P){(P||b!=n.width||A!=n.height)&&oe(b,A),ut(!1),be=!0,ve=!0,Wn()}function oe(b,A){n.width=Qt=O=b,n.height=un=Ce=A,Ye=rt=0,Me(),He();let P=n.bbox;C=P.left=Tr(Ye*wt,.5),S=P.top=Tr(rt*wt,.5),q=P.width=Tr(O*wt,.5),de=P.height=Tr(Ce*wt,.5)}let ie=3;function Ae(){let b=!1,A=0;for(;!b;){A++;let P=eo(A),F=ss(A);b=A==ie||P&&F,b||(oe(n.width,n.height),ve=!0)}}function xe({width:b,height:A}){U(b,A)}n.setSize=xe;function Me(){let b=!1,A=!1,P=!1,F=!1;T.forEach((W,j)=>{if(W.show&&W._show){let{side:ce,_size:ge}=W,Se=ce%2,De=W.label!=null?W.labelSize:0,Fe=ge+De;Fe>0&&(Se?(O-=Fe,ce==3?(Ye+=Fe,F=!0):P=!0):(Ce-=Fe,ce==0?(rt+=Fe,b=!0):A=!0))}}),ns[0]=b,ns[1]=P,ns[2]=A,ns[3]=F,O-=Ni[1]+Ni[3],Ye+=Ni[3],Ce-=Ni[2]+Ni[0],rt+=Ni[0]}function He(){let b=Ye+O,A=rt+Ce,P=Ye,F=rt;function W(j,ce){switch(j){case 1:return b+=ce,b-ce;case 2:return A+=ce,A-ce;case 3:return P-=ce,P+ce;case 0:return F-=ce,F+ce}}T.forEach((j,ce)=>{if(j.show&&j._show){let ge=j.side;j._pos=W(ge,j._size),j.label!=null&&(j._lpos=W(ge,j.labelSize))}})}if(ue.dataIdx==null){let b=ue.hover,A=b.skip=new Set(b.skip??[]);A.add(void 0);let P=b.prox=_t(b.prox),F=b.bias??=0;ue.dataIdx=(W,j,ce,ge)=>{if(j==0)return ce;let Se=ce,De=P(W,j,ce,ge)??Nt,Fe=De>=0&&De<Nt,Ue=L.ori==0?O:Ce,st=ue.left,Mt=e[0],bt=e[j];if(A.has(bt[ce])){Se=null;let mt=null,je=null,We;if(F==0||F==-1)for(We=ce;mt==null&&We-- >0;)A.has(bt[We])||(mt=We);if(F==0||F==1)for(We=ce;je==null&&We++<bt.length;)A.has(bt[We])||(je=We);if(mt!=null||je!=null)if(Fe){let Xt=mt==null?-1/0:V(Mt[mt],L,Ue,0),nn=je==null?1/0:V(Mt[je],L,Ue,0),Cn=st-Xt,Dt=nn-st;Cn<=Dt?Cn<=De&&(Se=mt):Dt<=De&&(Se=je)}else Se=je==null?mt:mt==null?je:ce-mt<=je-ce?mt:je}else Fe&&bn(st-V(Mt[ce],L,Ue,0))>De&&(Se=null);return Se}}let Ke=b=>{ue.event=b};ue.idxs=te,ue._lock=!1;let he=ue.points;he.show=_t(he.show),he.size=_t(he.size),he.stroke=_t(he.stroke),he.width=_t(he.width),he.fill=_t(he.fill);let Be=n.focus=mn({},i.focus||{alpha:.3},ue.focus),Qe=Be.prox>=0,Re=Qe&&he.one,lt=[],Gt=[],Zn=[];function na(b,A){let P=he.show(n,A);if(P instanceof HTMLElement)return pi(P,cv),pi(P,b.class),hs(P,-10,-10,O,Ce),m.insertBefore(P,lt[A]),P}function jr(b,A){if(s==1||A>0){let P=s==1&&x[b.scale].time,F=b.value;b.value=P?Em(F)?Dm($,Im(F,G)):F||K:F||Mb,b.label=b.label||(P?mb:pb)}if(Re||A>0){b.width=b.width==null?1:b.width,b.paths=b.paths||Ob||Tv,b.fillTo=_t(b.fillTo||Rb),b.pxAlign=+St(b.pxAlign,_),b.pxRound=Gm(b.pxAlign),b.stroke=_t(b.stroke||null),b.fill=_t(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let P=wb(ti(1,b.width),1),F=b.points=mn({},{size:P,width:ti(1,P*.2),stroke:b.stroke,space:P*2,paths:Bb,_stroke:null,_fill:null},b.points);F.show=_t(F.show),F.filter=_t(F.filter),F.fill=_t(F.fill),F.stroke=_t(F.stroke),F.paths=_t(F.paths),F.pxAlign=b.pxAlign}if(Q){let P=It(b,A);Xe.splice(A,0,P[0]),Ge.splice(A,0,P[1]),fe.values.push(null)}if(_e){te.splice(A,0,null);let P=null;Re?A==0&&(P=na(b,A)):A>0&&(P=na(b,A)),lt.splice(A,0,P),Gt.splice(A,0,0),Zn.splice(A,0,0)}Rn("addSeries",A)}function Dh(b,A){A=A??v.length,b=s==1?hd(b,A,Nm,zm):hd(b,A,{},km),v.splice(A,0,b),jr(v[A],A)}n.addSeries=Dh;function Al(b){if(v.splice(b,1),Q){fe.values.splice(b,1),Ge.splice(b,1);let A=Xe.splice(b,1)[0];_n(null,A.firstChild),A.remove()}_e&&(te.splice(b,1),lt.splice(b,1)[0].remove(),Gt.splice(b,1),Zn.splice(b,1)),Rn("delSeries",b)}n.delSeries=Al;let ns=[!1,!1,!1,!1];function Ms(b,A){if(b._show=b.show,b.show){let P=b.side%2,F=x[b.scale];F==null&&(b.scale=P?v[1].scale:w,F=x[b.scale]);let W=F.time;b.size=_t(b.size),b.space=_t(b.space),b.rotate=_t(b.rotate),Js(b.incrs)&&b.incrs.forEach(ce=>{!js.has(ce)&&js.set(ce,tg(ce))}),b.incrs=_t(b.incrs||(F.distr==2?Zv:W?p==1?jv:eb:Rr)),b.splits=_t(b.splits||(W&&F.distr==1?le:F.distr==3?ad:F.distr==4?_b:yb)),b.stroke=_t(b.stroke),b.grid.stroke=_t(b.grid.stroke),b.ticks.stroke=_t(b.ticks.stroke),b.border.stroke=_t(b.border.stroke);let j=b.values;b.values=Js(j)&&!Js(j[0])?_t(j):W?Js(j)?Lm($,Pm(j,G)):Em(j)?ib($,j):j||Y:j||gb,b.filter=_t(b.filter||(F.distr>=3&&F.log==10?bb:F.distr==3&&F.log==2?Sb:Qm)),b.font=qm(b.font),b.labelFont=qm(b.labelFont),b._size=b.size(n,null,A,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(ns[A]=!0,b._el=Ti(rv,d))}}function ws(b,A,P,F){let[W,j,ce,ge]=P,Se=A%2,De=0;return Se==0&&(ge||j)&&(De=A==0&&!W||A==2&&!ce?vn(Fm.size/3):0),Se==1&&(W||ce)&&(De=A==1&&!j||A==3&&!ge?vn(Om.size/2):0),De}let ia=n.padding=(i.padding||[ws,ws,ws,ws]).map(b=>_t(St(b,ws))),Ni=n._padding=ia.map((b,A)=>b(n,A,ns,0)),en,an=null,ln=null,is=s==1?v[0].idxs:null,ui=null,Gs=!1;function sa(b,A){if(e=b??[],n.data=n._data=e,s==2){en=0;for(let P=1;P<v.length;P++)en+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ui=e[0],en=ui.length;let P=e;if(k==2){P=e.slice();let F=P[0]=Array(en);for(let W=0;W<en;W++)F[W]=W}n._data=e=P}if(ut(!0),Rn("setData"),k==2&&(be=!0),A!==!1){let P=L;P.auto(n,Gs)?ra():Xs(w,P.min,P.max),ne=ne||ue.left>=0,ye=!0,Wn()}}n.setData=sa;function ra(){Gs=!0;let b,A;s==1&&(en>0?(an=is[0]=0,ln=is[1]=en-1,b=e[0][an],A=e[0][ln],k==2?(b=an,A=ln):b==A&&(k==3?[b,A]=ql(b,b,L.log,!1):k==4?[b,A]=md(b,b,L.log,!1):L.time?A=b+vn(86400/p):[b,A]=Hl(b,A,gd,!0))):(an=is[0]=b=null,ln=is[1]=A=null)),Xs(w,b,A)}let Kr,Hs,Qr,E,z,ee,Z,J,Ee,Le;function Te(b,A,P,F,W,j){b??=cm,P??=_d,F??="butt",W??=cm,j??="round",b!=Kr&&(h.strokeStyle=Kr=b),W!=Hs&&(h.fillStyle=Hs=W),A!=Qr&&(h.lineWidth=Qr=A),j!=z&&(h.lineJoin=z=j),F!=ee&&(h.lineCap=ee=F),P!=E&&h.setLineDash(E=P)}function Ie(b,A,P,F){A!=Hs&&(h.fillStyle=Hs=A),b!=Z&&(h.font=Z=b),P!=J&&(h.textAlign=J=P),F!=Ee&&(h.textBaseline=Ee=F)}function ze(b,A,P,F,W=0){if(F.length>0&&b.auto(n,Gs)&&(A==null||A.min==null)){let j=St(an,0),ce=St(ln,F.length-1),ge=P.min==null?bv(F,j,ce,W,b.distr==3):[P.min,P.max];b.min=Vi(b.min,P.min=ge[0]),b.max=ti(b.max,P.max=ge[1])}}let et={min:null,max:null};function ft(){for(let F in x){let W=x[F];H[F]==null&&(W.min==null||H[w]!=null&&W.auto(n,Gs))&&(H[F]=et)}for(let F in x){let W=x[F];H[F]==null&&W.from!=null&&H[W.from]!=null&&(H[F]=et)}H[w]!=null&&ut(!0);let b={};for(let F in H){let W=H[F];if(W!=null){let j=b[F]=mo(x[F],Pv);if(W.min!=null)mn(j,W);else if(F!=w||s==2)if(en==0&&j.from==null){let ce=j.range(n,null,null,F);j.min=ce[0],j.max=ce[1]}else j.min=Nt,j.max=-Nt}}if(en>0){v.forEach((F,W)=>{if(s==1){let j=F.scale,ce=H[j];if(ce==null)return;let ge=b[j];if(W==0){let Se=ge.range(n,ge.min,ge.max,j);ge.min=Se[0],ge.max=Se[1],an=zi(ge.min,e[0]),ln=zi(ge.max,e[0]),ln-an>1&&(e[0][an]<ge.min&&an++,e[0][ln]>ge.max&&ln--),F.min=ui[an],F.max=ui[ln]}else F.show&&F.auto&&ze(ge,ce,F,e[W],F.sorted);F.idxs[0]=an,F.idxs[1]=ln}else if(W>0&&F.show&&F.auto){let[j,ce]=F.facets,ge=j.scale,Se=ce.scale,[De,Fe]=e[W],Ue=b[ge],st=b[Se];Ue!=null&&ze(Ue,H[ge],j,De,j.sorted),st!=null&&ze(st,H[Se],ce,Fe,ce.sorted),F.min=ce.min,F.max=ce.max}});for(let F in b){let W=b[F],j=H[F];if(W.from==null&&(j==null||j.min==null)){let ce=W.range(n,W.min==Nt?null:W.min,W.max==-Nt?null:W.max,F);W.min=ce[0],W.max=ce[1]}}}for(let F in b){let W=b[F];if(W.from!=null){let j=b[W.from];if(j.min==null)W.min=W.max=null;else{let ce=W.range(n,j.min,j.max,F);W.min=ce[0],W.max=ce[1]}}}let A={},P=!1;for(let F in b){let W=b[F],j=x[F];if(j.min!=W.min||j.max!=W.max){j.min=W.min,j.max=W.max;let ce=j.distr;j._min=ce==3?Cs(j.min):ce==4?Kh(j.min,j.asinh):ce==100?j.fwd(j.min):j.min,j._max=ce==3?Cs(j.max):ce==4?Kh(j.max,j.asinh):ce==100?j.fwd(j.max):j.max,A[F]=P=!0}}if(P){v.forEach((F,W)=>{s==2?W>0&&A.y&&(F._paths=null):A[F.scale]&&(F._paths=null)});for(let F in A)be=!0,Rn("setScale",F);_e&&ue.left>=0&&(ne=ye=!0)}for(let F in H)H[F]=null}function ke(b){let A=od(an-1,0,en-1),P=od(ln+1,0,en-1);for(;b[A]==null&&A>0;)A--;for(;b[P]==null&&P<en-1;)P++;return[A,P]}function pt(){if(en>0){let b=v.some(A=>A._focus)&&Le!=Be.alpha;b&&(h.globalAlpha=Le=Be.alpha),v.forEach((A,P)=>{if(P>0&&A.show&&(Jt(P,!1),Jt(P,!0),A._paths==null)){let F=Le;Le!=A.alpha&&(h.globalAlpha=Le=A.alpha);let W=s==2?[0,e[P][0].length-1]:ke(e[P]);A._paths=A.paths(n,P,W[0],W[1]),Le!=F&&(h.globalAlpha=Le=F)}}),v.forEach((A,P)=>{if(P>0&&A.show){let F=Le;Le!=A.alpha&&(h.globalAlpha=Le=A.alpha),A._paths!=null&&Ct(P,!1);{let W=A._paths!=null?A._paths.gaps:null,j=A.points.show(n,P,an,ln,W),ce=A.points.filter(n,P,j,W);(j||ce)&&(A.points._paths=A.points.paths(n,P,an,ln,ce),Ct(P,!0))}Le!=F&&(h.globalAlpha=Le=F),Rn("drawSeries",P)}}),b&&(h.globalAlpha=Le=1)}}function Jt(b,A){let P=A?v[b].points:v[b];P._stroke=P.stroke(n,b),P._fill=P.fill(n,b)}function Ct(b,A){let P=A?v[b].points:v[b],{stroke:F,fill:W,clip:j,flags:ce,_stroke:ge=P._stroke,_fill:Se=P._fill,_width:De=P.width}=P._paths;De=Ut(De*wt,3);let Fe=null,Ue=De%2/2;A&&Se==null&&(Se=De>0?"#fff":ge);let st=P.pxAlign==1&&Ue>0;if(st&&h.translate(Ue,Ue),!A){let Mt=C-De/2,bt=S-De/2,mt=q+De,je=de+De;Fe=new Path2D,Fe.rect(Mt,bt,mt,je)}A?Ne(ge,De,P.dash,P.cap,Se,F,W,ce,j):Pt(b,ge,De,P.dash,P.cap,Se,F,W,ce,Fe,j),st&&h.translate(-Ue,-Ue)}function Pt(b,A,P,F,W,j,ce,ge,Se,De,Fe){let Ue=!1;Se!=0&&R.forEach((st,Mt)=>{if(st.series[0]==b){let bt=v[st.series[1]],mt=e[st.series[1]],je=(bt._paths||ya).band;Js(je)&&(je=st.dir==1?je[0]:je[1]);let We,Xt=null;bt.show&&je&&Mv(mt,an,ln)?(Xt=st.fill(n,Mt)||j,We=bt._paths.clip):je=null,Ne(A,P,F,W,Xt,ce,ge,Se,De,Fe,We,je),Ue=!0}}),Ue||Ne(A,P,F,W,j,ce,ge,Se,De,Fe)}let xn=go|cd;function Ne(b,A,P,F,W,j,ce,ge,Se,De,Fe,Ue){Te(b,A,P,F,W),(Se||De||Ue)&&(h.save(),Se&&h.clip(Se),De&&h.clip(De)),Ue?(ge&xn)==xn?(h.clip(Ue),Fe&&h.clip(Fe),gt(W,ce),hn(b,j,A)):ge&cd?(gt(W,ce),h.clip(Ue),hn(b,j,A)):ge&go&&(h.save(),h.clip(Ue),Fe&&h.clip(Fe),gt(W,ce),h.restore(),hn(b,j,A)):(gt(W,ce),hn(b,j,A)),(Se||De||Ue)&&h.restore()}function hn(b,A,P){P>0&&(A instanceof Map?A.forEach((F,W)=>{h.strokeStyle=Kr=W,h.stroke(F)}):A!=null&&b&&h.stroke(A))}function gt(b,A){A instanceof Map?A.forEach((P,F)=>{h.fillStyle=Hs=F,h.fill(P)}):A!=null&&b&&h.fill(A)}function As(b,A,P,F){let W=T[b],j;if(F<=0)j=[0,0];else{let ce=W._space=W.space(n,b,A,P,F),ge=W._incrs=W.incrs(n,b,A,P,F,ce);j=Wb(A,P,ge,F,ce)}return W._found=j}function dn(b,A,P,F,W,j,ce,ge,Se,De){let Fe=ce%2/2;_==1&&h.translate(Fe,Fe),Te(ge,ce,Se,De,ge),h.beginPath();let Ue,st,Mt,bt,mt=W+(F==0||F==3?-j:j);P==0?(st=W,bt=mt):(Ue=W,Mt=mt);for(let je=0;je<b.length;je++)A[je]!=null&&(P==0?Ue=Mt=b[je]:st=bt=b[je],h.moveTo(Ue,st),h.lineTo(Mt,bt));h.stroke(),_==1&&h.translate(-Fe,-Fe)}function eo(b){let A=!0;return T.forEach((P,F)=>{if(!P.show)return;let W=x[P.scale];if(W.min==null){P._show&&(A=!1,P._show=!1,ut(!1));return}else P._show||(A=!1,P._show=!0,ut(!1));let j=P.side,ce=j%2,{min:ge,max:Se}=W,[De,Fe]=As(F,ge,Se,ce==0?O:Ce);if(Fe==0)return;let Ue=W.distr==2,st=P._splits=P.splits(n,F,ge,Se,De,Fe,Ue),Mt=W.distr==2?st.map(We=>ui[We]):st,bt=W.distr==2?ui[st[1]]-ui[st[0]]:De,mt=P._values=P.values(n,P.filter(n,Mt,F,Fe,bt),F,Fe,bt);P._rotate=j==2?P.rotate(n,mt,F,Fe):0;let je=P._size;P._size=Ri(P.size(n,mt,F,b)),je!=null&&P._size!=je&&(A=!1)}),A}function ss(b){let A=!0;return ia.forEach((P,F)=>{let W=P(n,F,ns,b);W!=Ni[F]&&(A=!1),Ni[F]=W}),A}function Es(){for(let b=0;b<T.length;b++){let A=T[b];if(!A.show||!A._show)continue;let P=A.side,F=P%2,W,j,ce=A.stroke(n,b),ge=P==0||P==3?-1:1,[Se,De]=A._found;if(A.label!=null){let Kn=A.labelGap*ge,fi=vn((A._lpos+Kn)*wt);Ie(A.labelFont[0],ce,"center",P==2?"top":lm),h.save(),F==1?(W=j=0,h.translate(fi,vn(S+de/2)),h.rotate((P==3?-Vl:Vl)/2)):(W=vn(C+q/2),j=fi);let Mr=jm(A.label)?A.label(n,b,Se,De):A.label;h.fillText(Mr,W,j),h.restore()}if(De==0)continue;let Fe=x[A.scale],Ue=F==0?q:de,st=F==0?C:S,Mt=A._splits,bt=Fe.distr==2?Mt.map(Kn=>ui[Kn]):Mt,mt=Fe.distr==2?ui[Mt[1]]-ui[Mt[0]]:Se,je=A.ticks,We=A.border,Xt=je.show?je.size:0,nn=vn(Xt*wt),Cn=vn((A.alignTo==2?A._size-Xt-A.gap:A.gap)*wt),Dt=A._rotate*-Vl/180,sn=g(A._pos*wt),hi=(nn+Cn)*ge,jn=sn+hi;j=F==0?jn:0,W=F==1?jn:0;let wi=A.font[0],Ui=A.align==1?co:A.align==2?Zh:Dt>0?co:Dt<0?Zh:F==0?"center":P==3?Zh:co,as=Dt||F==1?"middle":P==2?"top":lm;Ie(wi,ce,Ui,as);let di=A.font[1]*A.lineGap,Ai=Mt.map(Kn=>g(a(Kn,Fe,Ue,st))),Oi=A._values;for(let Kn=0;Kn<Oi.length;Kn++){let fi=Oi[Kn];if(fi!=null){F==0?W=Ai[Kn]:j=Ai[Kn],fi=""+fi;let Mr=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let Qn=0;Qn<Mr.length;Qn++){let Dp=Mr[Qn];Dt?(h.save(),h.translate(W,j+Qn*di),h.rotate(Dt),h.fillText(Dp,0,0),h.restore()):h.fillText(Dp,W,j+Qn*di)}}}je.show&&dn(Ai,je.filter(n,bt,b,De,mt),F,P,sn,nn,Ut(je.width*wt,3),je.stroke(n,b),je.dash,je.cap);let ls=A.grid;ls.show&&dn(Ai,ls.filter(n,bt,b,De,mt),F,F==0?2:1,F==0?S:C,F==0?de:q,Ut(ls.width*wt,3),ls.stroke(n,b),ls.dash,ls.cap),We.show&&dn([sn],[1],F==0?1:0,F==0?1:2,F==1?S:C,F==1?de:q,Ut(We.width*wt,3),We.stroke(n,b),We.dash,We.cap)}Rn("drawAxes")}function ut(b){v.forEach((A,P)=>{P>0&&(A._paths=null,b&&(s==1?(A.min=null,A.max=null):A.facets.forEach(F=>{F.min=null,F.max=null})))})}let tn=!1,Jn=!1,Lt=[];function fn(){Jn=!1;for(let b=0;b<Lt.length;b++)Rn(...Lt[b]);Lt.length=0}function Wn(){tn||(Ov(mp),tn=!0)}function El(b,A=!1){tn=!0,Jn=A,b(n),mp(),A&&Lt.length>0&&queueMicrotask(fn)}n.batch=El;function mp(){if(ae&&(ft(),ae=!1),be&&(Ae(),be=!1),ve){if(qt(f,co,Ye),qt(f,"top",rt),qt(f,fa,O),qt(f,pa,Ce),qt(m,co,Ye),qt(m,"top",rt),qt(m,fa,O),qt(m,pa,Ce),qt(d,fa,Qt),qt(d,pa,un),u.width=vn(Qt*wt),u.height=vn(un*wt),T.forEach(({_el:b,_show:A,_size:P,_pos:F,side:W})=>{if(b!=null)if(A){let j=W===3||W===0?P:0,ce=W%2==1;qt(b,ce?"left":"top",F-j),qt(b,ce?"width":"height",P),qt(b,ce?"top":"left",ce?rt:Ye),qt(b,ce?"height":"width",ce?Ce:O),sd(b,Cr)}else pi(b,Cr)}),Kr=Hs=Qr=z=ee=Z=J=Ee=E=null,Le=1,la(!0),Ye!=we||rt!=Ft||O!=Ve||Ce!=qe){ut(!1);let b=O/Ve,A=Ce/qe;if(_e&&!ne&&ue.left>=0){ue.left*=b,ue.top*=A,to&&hs(to,vn(ue.left),0,O,Ce),no&&hs(no,0,vn(ue.top),O,Ce);for(let P=0;P<lt.length;P++){let F=lt[P];F!=null&&(Gt[P]*=b,Zn[P]*=A,hs(F,Ri(Gt[P]),Ri(Zn[P]),O,Ce))}}if(Wt.show&&!se&&Wt.left>=0&&Wt.width>0){Wt.left*=b,Wt.width*=b,Wt.top*=A,Wt.height*=A;for(let P in kh)qt(ro,P,Wt[P])}we=Ye,Ft=rt,Ve=O,qe=Ce}Rn("setSize"),ve=!1}Qt>0&&un>0&&(h.clearRect(0,0,u.width,u.height),Rn("drawClear"),M.forEach(b=>b()),Rn("draw")),Wt.show&&se&&(Tl(Wt),se=!1),_e&&ne&&(Sr(null,!0,!1),ne=!1),fe.show&&fe.live&&ye&&(Oh(),ye=!1),l||(l=!0,n.status=1,Rn("ready")),Gs=!1,tn=!1}n.redraw=(b,A)=>{be=A||!1,b!==!1?Xs(w,L.min,L.max):Wn()};function Fh(b,A){let P=x[b];if(P.from==null){if(en==0){let F=P.range(n,A.min,A.max,b);A.min=F[0],A.max=F[1]}if(A.min>A.max){let F=A.min;A.min=A.max,A.max=F}if(en>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;b==w&&P.distr==2&&en>0&&(A.min=zi(A.min,e[0]),A.max=zi(A.max,e[0]),A.min==A.max&&A.max++),H[b]=A,ae=!0,Wn()}}n.setScale=Fh;let Nh,Uh,to,no,gp,yp,io,so,_p,xp,Ht,Zt,Ws=!1,Nn=ue.drag,En=Nn.x,Tn=Nn.y;_e&&(ue.x&&(Nh=Ti(av,m)),ue.y&&(Uh=Ti(lv,m)),L.ori==0?(to=Nh,no=Uh):(to=Uh,no=Nh),Ht=ue.left,Zt=ue.top);let Wt=n.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),ro=Wt.show?Ti(ov,Wt.over?m:f):null;function Tl(b,A){if(Wt.show){for(let P in b)Wt[P]=b[P],P in kh&&qt(ro,P,b[P]);A!==!1&&Rn("setSelect")}}n.setSelect=Tl;function lx(b){if(v[b].show)Q&&sd(Xe[b],Cr);else if(Q&&pi(Xe[b],Cr),_e){let P=Re?lt[0]:lt[b];P!=null&&hs(P,-10,-10,O,Ce)}}function Xs(b,A,P){Fh(b,{min:A,max:P})}function rs(b,A,P,F){A.focus!=null&&fx(b),A.show!=null&&v.forEach((W,j)=>{j>0&&(b==j||b==null)&&(W.show=A.show,lx(j),s==2?(Xs(W.facets[0].scale,null,null),Xs(W.facets[1].scale,null,null)):Xs(W.scale,null,null),Wn())}),P!==!1&&Rn("setSeries",b,A),F&&ca("setSeries",n,b,A)}n.setSeries=rs;function cx(b,A){mn(R[b],A)}function ux(b,A){b.fill=_t(b.fill||null),b.dir=St(b.dir,-1),A=A??R.length,R.splice(A,0,b)}function hx(b){b==null?R.length=0:R.splice(b,1)}n.addBand=ux,n.setBand=cx,n.delBand=hx;function dx(b,A){v[b].alpha=A,_e&&lt[b]!=null&&(lt[b].style.opacity=A),Q&&Xe[b]&&(Xe[b].style.opacity=A)}let Ts,qs,br,oo={focus:!0};function fx(b){if(b!=br){let A=b==null,P=Be.alpha!=1;v.forEach((F,W)=>{if(s==1||W>0){let j=A||W==0||W==b;F._focus=A?null:j,P&&dx(W,j?1:Be.alpha)}}),br=b,P&&Wn()}}Q&&Qe&&vt(dm,me,b=>{ue._lock||(Ke(b),br!=null&&rs(null,oo,!0,pn.setSeries))});function os(b,A,P){let F=x[A];P&&(b=b/wt-(F.ori==1?rt:Ye));let W=O;F.ori==1&&(W=Ce,b=W-b),F.dir==-1&&(b=W-b);let j=F._min,ce=F._max,ge=b/W,Se=j+(ce-j)*ge,De=F.distr;return De==3?fo(10,Se):De==4?Av(Se,F.asinh):De==100?F.bwd(Se):Se}function px(b,A){let P=os(b,w,A);return zi(P,e[0],an,ln)}n.valToIdx=b=>zi(b,e[0]),n.posToIdx=px,n.posToVal=os,n.valToPos=(b,A,P)=>x[A].ori==0?r(b,x[A],P?q:O,P?C:0):o(b,x[A],P?de:Ce,P?S:0),n.setCursor=(b,A,P)=>{Ht=b.left,Zt=b.top,Sr(null,A,P)};function vp(b,A){qt(ro,co,Wt.left=b),qt(ro,fa,Wt.width=A)}function bp(b,A){qt(ro,"top",Wt.top=b),qt(ro,pa,Wt.height=A)}let oa=L.ori==0?vp:bp,aa=L.ori==1?vp:bp;function mx(){if(Q&&fe.live)for(let b=s==2?1:0;b<v.length;b++){if(b==0&&ct)continue;let A=fe.values[b],P=0;for(let F in A)Ge[b][P++].firstChild.nodeValue=A[F]}}function Oh(b,A){if(b!=null&&(b.idxs?b.idxs.forEach((P,F)=>{te[F]=P}):Cv(b.idx)||te.fill(b.idx),fe.idx=te[0]),Q&&fe.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ct)&&gx(P,te[P]);mx()}ye=!1,A!==!1&&Rn("setLegend")}n.setLegend=Oh;function gx(b,A){let P=v[b],F=b==0&&k==2?ui:e[b],W;ct?W=P.values(n,b,A)??it:(W=P.value(n,A==null?null:F[A],b,A),W=W==null?it:{_:W}),fe.values[b]=W}function Sr(b,A,P){_p=Ht,xp=Zt,[Ht,Zt]=ue.move(n,Ht,Zt),ue.left=Ht,ue.top=Zt,_e&&(to&&hs(to,vn(Ht),0,O,Ce),no&&hs(no,0,vn(Zt),O,Ce));let F,W=an>ln;Ts=Nt,qs=null;let j=L.ori==0?O:Ce,ce=L.ori==1?O:Ce;if(Ht<0||en==0||W){F=ue.idx=null;for(let ge=0;ge<v.length;ge++){let Se=lt[ge];Se!=null&&hs(Se,-10,-10,O,Ce)}Qe&&rs(null,oo,!0,b==null&&pn.setSeries),fe.live&&(te.fill(F),ye=!0)}else{let ge,Se,De;s==1&&(ge=L.ori==0?Ht:Zt,Se=os(ge,w),F=ue.idx=zi(Se,e[0],an,ln),De=V(e[0][F],L,j,0));let Fe=-10,Ue=-10,st=0,Mt=0,bt=!0,mt="",je="";for(let We=s==2?1:0;We<v.length;We++){let Xt=v[We],nn=te[We],Cn=nn==null?null:s==1?e[We][nn]:e[We][1][nn],Dt=ue.dataIdx(n,We,F,Se),sn=Dt==null?null:s==1?e[We][Dt]:e[We][1][Dt];if(ye=ye||sn!=Cn||Dt!=nn,te[We]=Dt,We>0&&Xt.show){let hi=Dt==null?-10:Dt==F?De:V(s==1?e[0][Dt]:e[We][0][Dt],L,j,0),jn=sn==null?-10:D(sn,s==1?x[Xt.scale]:x[Xt.facets[1].scale],ce,0);if(Qe&&sn!=null){let wi=L.ori==1?Ht:Zt,Ui=bn(Be.dist(n,We,Dt,jn,wi));if(Ui<Ts){let as=Be.bias;if(as!=0){let di=os(wi,Xt.scale),Ai=sn>=0?1:-1,Oi=di>=0?1:-1;Oi==Ai&&(Oi==1?as==1?sn>=di:sn<=di:as==1?sn<=di:sn>=di)&&(Ts=Ui,qs=We)}else Ts=Ui,qs=We}}if(ye||Re){let wi,Ui;L.ori==0?(wi=hi,Ui=jn):(wi=jn,Ui=hi);let as,di,Ai,Oi,ls,Kn,fi=!0,Mr=he.bbox;if(Mr!=null){fi=!1;let Qn=Mr(n,We);Ai=Qn.left,Oi=Qn.top,as=Qn.width,di=Qn.height}else Ai=wi,Oi=Ui,as=di=he.size(n,We);if(Kn=he.fill(n,We),ls=he.stroke(n,We),Re)We==qs&&Ts<=Be.prox&&(Fe=Ai,Ue=Oi,st=as,Mt=di,bt=fi,mt=Kn,je=ls);else{let Qn=lt[We];Qn!=null&&(Gt[We]=Ai,Zn[We]=Oi,xm(Qn,as,di,fi),ym(Qn,Kn,ls),hs(Qn,Ri(Ai),Ri(Oi),O,Ce))}}}}if(Re){let We=Be.prox,Xt=br==null?Ts<=We:Ts>We||qs!=br;if(ye||Xt){let nn=lt[0];nn!=null&&(Gt[0]=Fe,Zn[0]=Ue,xm(nn,st,Mt,bt),ym(nn,mt,je),hs(nn,Ri(Fe),Ri(Ue),O,Ce))}}}if(Wt.show&&Ws)if(b!=null){let[ge,Se]=pn.scales,[De,Fe]=pn.match,[Ue,st]=b.cursor.sync.scales,Mt=b.cursor.drag;if(En=Mt._x,Tn=Mt._y,En||Tn){let{left:bt,top:mt,width:je,height:We}=b.select,Xt=b.scales[Ue].ori,nn=b.posToVal,Cn,Dt,sn,hi,jn,wi=ge!=null&&De(ge,Ue),Ui=Se!=null&&Fe(Se,st);wi&&En?(Xt==0?(Cn=bt,Dt=je):(Cn=mt,Dt=We),sn=x[ge],hi=V(nn(Cn,Ue),sn,j,0),jn=V(nn(Cn+Dt,Ue),sn,j,0),oa(Vi(hi,jn),bn(jn-hi))):oa(0,j),Ui&&Tn?(Xt==1?(Cn=bt,Dt=je):(Cn=mt,Dt=We),sn=x[Se],hi=D(nn(Cn,st),sn,ce,0),jn=D(nn(Cn+Dt,st),sn,ce,0),aa(Vi(hi,jn),bn(jn-hi))):aa(0,ce)}else zh()}else{let ge=bn(_p-gp),Se=bn(xp-yp);if(L.ori==1){let st=ge;ge=Se,Se=st}En=Nn.x&&ge>=Nn.dist,Tn=Nn.y&&Se>=Nn.dist;let De=Nn.uni;De!=null?En&&Tn&&(En=ge>=De,Tn=Se>=De,!En&&!Tn&&(Se>ge?Tn=!0:En=!0)):Nn.x&&Nn.y&&(En||Tn)&&(En=Tn=!0);let Fe,Ue;En&&(L.ori==0?(Fe=io,Ue=Ht):(Fe=so,Ue=Zt),oa(Vi(Fe,Ue),bn(Ue-Fe)),Tn||aa(0,ce)),Tn&&(L.ori==1?(Fe=io,Ue=Ht):(Fe=so,Ue=Zt),aa(Vi(Fe,Ue),bn(Ue-Fe)),En||oa(0,j)),!En&&!Tn&&(oa(0,0),aa(0,0))}if(Nn._x=En,Nn._y=Tn,b==null){if(P){if(Ip!=null){let[ge,Se]=pn.scales;pn.values[0]=ge!=null?os(L.ori==0?Ht:Zt,ge):null,pn.values[1]=Se!=null?os(L.ori==1?Ht:Zt,Se):null}ca(Jh,n,Ht,Zt,O,Ce,F)}if(Qe){let ge=P&&pn.setSeries,Se=Be.prox;br==null?Ts<=Se&&rs(qs,oo,!0,ge):Ts>Se?rs(null,oo,!0,ge):qs!=br&&rs(qs,oo,!0,ge)}}ye&&(fe.idx=F,Oh()),A!==!1&&Rn("setCursor")}let $s=null;Object.defineProperty(n,"rect",{get(){return $s==null&&la(!1),$s}});function la(b=!1){b?$s=null:($s=m.getBoundingClientRect(),Rn("syncRect",$s))}function Sp(b,A,P,F,W,j,ce){ue._lock||Ws&&b!=null&&b.movementX==0&&b.movementY==0||(Bh(b,A,P,F,W,j,ce,!1,b!=null),b!=null?Sr(null,!0,!0):Sr(A,!0,!1))}function Bh(b,A,P,F,W,j,ce,ge,Se){if($s==null&&la(!1),Ke(b),b!=null)P=b.clientX-$s.left,F=b.clientY-$s.top;else{if(P<0||F<0){Ht=-10,Zt=-10;return}let[De,Fe]=pn.scales,Ue=A.cursor.sync,[st,Mt]=Ue.values,[bt,mt]=Ue.scales,[je,We]=pn.match,Xt=A.axes[0].side%2==1,nn=L.ori==0?O:Ce,Cn=L.ori==1?O:Ce,Dt=Xt?j:W,sn=Xt?W:j,hi=Xt?F:P,jn=Xt?P:F;if(bt!=null?P=je(De,bt)?a(st,x[De],nn,0):-10:P=nn*(hi/Dt),mt!=null?F=We(Fe,mt)?a(Mt,x[Fe],Cn,0):-10:F=Cn*(jn/sn),L.ori==1){let wi=P;P=F,F=wi}}Se&&(A==null||A.cursor.event.type==Jh)&&((P<=1||P>=O-1)&&(P=Tr(P,O)),(F<=1||F>=Ce-1)&&(F=Tr(F,Ce))),ge?(gp=P,yp=F,[io,so]=ue.move(n,P,F)):(Ht=P,Zt=F)}let kh={width:0,height:0,left:0,top:0};function zh(){Tl(kh,!1)}let Mp,wp,Ap,Ep;function Tp(b,A,P,F,W,j,ce){Ws=!0,En=Tn=Nn._x=Nn._y=!1,Bh(b,A,P,F,W,j,ce,!0,!1),b!=null&&(vt(jh,nd,Rp,!1),ca(um,n,io,so,O,Ce,null));let{left:ge,top:Se,width:De,height:Fe}=Wt;Mp=ge,wp=Se,Ap=De,Ep=Fe}function Rp(b,A,P,F,W,j,ce){Ws=Nn._x=Nn._y=!1,Bh(b,A,P,F,W,j,ce,!1,!0);let{left:ge,top:Se,width:De,height:Fe}=Wt,Ue=De>0||Fe>0,st=Mp!=ge||wp!=Se||Ap!=De||Ep!=Fe;if(Ue&&st&&Tl(Wt),Nn.setScale&&Ue&&st){let Mt=ge,bt=De,mt=Se,je=Fe;if(L.ori==1&&(Mt=Se,bt=Fe,mt=ge,je=De),En&&Xs(w,os(Mt,w),os(Mt+bt,w)),Tn)for(let We in x){let Xt=x[We];We!=w&&Xt.from==null&&Xt.min!=Nt&&Xs(We,os(mt+je,We),os(mt,We))}zh()}else ue.lock&&(ue._lock=!ue._lock,Sr(A,!0,b!=null));b!=null&&(_n(jh,nd),ca(jh,n,Ht,Zt,O,Ce,null))}function yx(b,A,P,F,W,j,ce){if(ue._lock)return;Ke(b);let ge=Ws;if(Ws){let Se=!0,De=!0,Fe=10,Ue,st;L.ori==0?(Ue=En,st=Tn):(Ue=Tn,st=En),Ue&&st&&(Se=Ht<=Fe||Ht>=O-Fe,De=Zt<=Fe||Zt>=Ce-Fe),Ue&&Se&&(Ht=Ht<io?0:O),st&&De&&(Zt=Zt<so?0:Ce),Sr(null,!0,!0),Ws=!1}Ht=-10,Zt=-10,te.fill(null),Sr(null,!0,!0),ge&&(Ws=ge)}function Cp(b,A,P,F,W,j,ce){ue._lock||(Ke(b),ra(),zh(),b!=null&&ca(fm,n,Ht,Zt,O,Ce,null))}function Pp(){T.forEach(Xb),U(n.width,n.height,!0)}Pr(Gl,ho,Pp);let ao={};ao.mousedown=Tp,ao.mousemove=Sp,ao.mouseup=Rp,ao.dblclick=Cp,ao.setSeries=(b,A,P,F)=>{let W=pn.match[2];P=W(n,A,P),P!=-1&&rs(P,F,!0,!1)},_e&&(vt(um,m,Tp),vt(Jh,m,Sp),vt(hm,m,b=>{Ke(b),la(!1)}),vt(dm,m,yx),vt(fm,m,Cp),ud.add(n),n.syncRect=la);let Rl=n.hooks=i.hooks||{};function Rn(b,A,P){Jn?Lt.push([b,A,P]):b in Rl&&Rl[b].forEach(F=>{F.call(null,n,A,P)})}(i.plugins||[]).forEach(b=>{for(let A in b.hooks)Rl[A]=(Rl[A]||[]).concat(b.hooks[A])});let Lp=(b,A,P)=>P,pn=mn({key:null,setSeries:!1,filters:{pub:wm,sub:wm},scales:[w,v[1]?v[1].scale:null],match:[Am,Am,Lp],values:[null,null]},ue.sync);pn.match.length==2&&pn.match.push(Lp),ue.sync=pn;let Ip=pn.key,Vh=bg(Ip);function ca(b,A,P,F,W,j,ce){pn.filters.pub(b,A,P,F,W,j,ce)&&Vh.pub(b,A,P,F,W,j,ce)}Vh.sub(n);function _x(b,A,P,F,W,j,ce){pn.filters.sub(b,A,P,F,W,j,ce)&&ao[b](null,A,P,F,W,j,ce)}n.pub=_x;function xx(){Vh.unsub(n),ud.delete(n),An.clear(),rd(Gl,ho,Pp),c.remove(),me?.remove(),Rn("destroy")}n.destroy=xx;function Gh(){Rn("init",i,e),sa(e||i.data,!1),H[w]?Fh(w,H[w]):ra(),se=Wt.show&&(Wt.width>0||Wt.height>0),ne=ye=!0,U(i.width,i.height)}return v.forEach(jr),T.forEach(Ms),t?t instanceof HTMLElement?(t.appendChild(c),Gh()):t(n,Gh):Gh(),n}gn.assign=mn;gn.fmtNum=yd;gn.rangeNum=Hl;gn.rangeLog=ql;gn.rangeAsinh=md;gn.orient=Ir;gn.pxRatio=wt;gn.join=Uv;gn.fmtDate=xd,gn.tzDate=$v;gn.sync=bg;{gn.addGap=Cb,gn.clipGaps=Zl;let i=gn.paths={points:Tg};i.linear=Cg,i.stepped=Ib,i.bars=Db,i.spline=Nb}var Dg="12px system-ui, sans-serif",Fg=2;function Ng(i,e,t,n){let s={stroke:()=>us("--grid"),width:1},r={stroke:()=>us("--quiet"),font:Dg,grid:s,ticks:{...s,size:4}},o={width:Math.max(i.clientWidth,120),height:n.height,legend:{show:!1},padding:[10,14,0,0],scales:{x:{time:!1},y:n.log?{distr:3,range:(l,c,u)=>$b(c,u,n.decades)}:{range:(l,c,u)=>qb(c,u)}},axes:[{...r,label:n.abscissa,labelSize:18,labelFont:Dg,size:30,values:(l,c)=>c.map(ei)},{...r,size:(l,c)=>16+7*Math.max(2,...(c??[]).map(u=>u.length)),values:(l,c)=>c.map(u=>u===null?"":n.log?Yb(u):ei(u))}],series:[{},...t.map(l=>({stroke:()=>us(l.property),width:l.width,dash:l.dash,alpha:l.ghost?.35:1,spanGaps:!0,points:{show:!1}}))],cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!0,dist:Fg},bind:{mousedown:(l,c,u)=>h=>h.shiftKey?u(h):null,dblclick:()=>()=>(n.zoomed(null),null)}},hooks:{setSelect:[l=>Zb(l,n)],setCursor:[l=>n.hovered(l.cursor.left===void 0||l.cursor.left<0?null:l.posToVal(l.cursor.left,"x"))],draw:[l=>jb(l,n.marks)]}},a=new gn(o,e,i);return Jb(a,n),a}function qb(i,e){if(i===null||e===null||!Number.isFinite(i)||!Number.isFinite(e))return[0,1];let t=Math.max(Math.abs(i),Math.abs(e)),n=t>1e-9?.05*t:.05;if(e-i<=1e-9*t||t<=1e-12)return[(i+e)/2-n,(i+e)/2+n];let s=.07*(e-i);return[i-s,e+s]}function $b(i,e,t){if(i===null||e===null||!(e>0))return[.1,1];let n=Math.max(i>0?i:e,e*10**-t);return[10**Math.floor(Math.log10(n)+1e-9),e*1.6]}function Yb(i){let e=Math.log10(i);return Math.abs(e-Math.round(e))>1e-6?"":ei(i).replace(/^1\u00a0×\u00a0|^1\.0\u00a0×\u00a0/,"")}function Zb(i,e){i.select.width<Fg||(e.zoomed([i.posToVal(i.select.left,"x"),i.posToVal(i.select.left+i.select.width,"x")]),i.setSelect({left:0,top:0,width:0,height:0},!1))}function Jb(i,e){let t=i.over,n=s=>e.chosen(i.posToVal(s.clientX-t.getBoundingClientRect().left,"x"));t.addEventListener("pointerdown",s=>{s.shiftKey||s.button!==0||(t.setPointerCapture(s.pointerId),n(s))}),t.addEventListener("pointermove",s=>{t.hasPointerCapture(s.pointerId)&&n(s)})}function jb(i,e){let{ctx:t,bbox:n}=i,s=gn.pxRatio,r=-1/0;t.save(),t.strokeStyle=t.fillStyle=us("--quiet"),t.font=`${11*s}px system-ui, sans-serif`,t.setLineDash([3*s,3*s]);for(let{at:o}of e){let a=i.valToPos(o,"x",!0);if(a<n.left||a>n.left+n.width)continue;t.beginPath(),t.moveTo(a,n.top),t.lineTo(a,n.top+n.height),t.stroke();let l=`${ei(Number(o.toPrecision(3)))} Hz`;a>r&&a+t.measureText(l).width<n.left+n.width&&(t.fillText(l,a+3*s,n.top+11*s),r=a+t.measureText(l).width+8*s)}t.restore()}var Ug={spectrum:5,other:6},Kb=190,Qb=1e-9,eS=100;function kg(i,e,t){let{chart:n}=i,s=n.abscissa==="time",r=jt("chart"),o=n.unit==="–"?"":n.unit,a=n.log==="first",l=Yh(i,null),c=null,u=null,h=null,d=!1,f=!0,m="",_=0,g=0,p=0,v=X("div",{class:"plot-area",role:"img"}),T=X("span",{class:"readout"}),x=yt("log",()=>k(!a),{class:"tool","aria-pressed":String(a),title:"Logarithmic ordinate, of the size of the values",hidden:n.log==="no"}),R=yt("reset zoom",()=>t.set(null),{class:"tool",hidden:!0}),w=X("div",{class:"tools"},R,x,yt("CSV",fe,{class:"tool",title:"Save the data of this chart as CSV"})),y=X("h4",{id:r,text:n.title},X("span",{class:"unit",text:o?` [${o}]`:""})),M=X("p",{class:"note",hidden:!s||Ed(Og(i))>=1,text:tS(Og(i))}),N=X("p",{class:"note",hidden:!0,text:"The marked frequencies are of the run as it was."}),I=om(l,V),L=X("figure",{class:"chart","aria-labelledby":r,"data-chart":n.id},X("figcaption",{},y,T,w),v,I.element,M,N);function k(re){a=re,x.setAttribute("aria-pressed",String(re)),V()}function V(){f=!0,d&&D()}function D(){if(!f||v.clientWidth===0)return;f=!1;let re=l.filter(Xe=>I.shows(Xe)),me=re.map(Xe=>({...I.look(Xe),width:Xe.ghost?1:Xe.role==="real"?1.6:1.3,ghost:Xe.ghost})),pe=Ol(re,a);g=Math.max(0,...re.map(Xe=>Math.max(...Bg(Xe).map(Math.abs))));let Oe=JSON.stringify([me,a,v.clientWidth,_]);c&&Oe===m?c.setData(pe):H(pe,me),m=Oe,v.setAttribute("aria-label",te(re)),s&&$(t.range),Y()}function H(re,me){c?.destroy(),h=null,c=Ng(v,re,me,{log:a,decades:n.group==="spectrum"?Ug.spectrum:Ug.other,height:Kb,marks:n.marks,abscissa:s?"time [s]":"frequency [Hz]",zoomed:pe=>s?t.set(pe):$(pe),hovered:pe=>{h=pe,Y()},chosen:pe=>{s&&e.seek(pe)}}),u=s?X("div",{class:"time-line"}):null,u&&c.over.append(u)}function $(re){let me=c?.data[0];if(R.hidden=re===null,!c||!me?.length)return;let[pe,Oe]=re??[me[0],me[me.length-1]];Oe>pe&&c.setScale("x",{min:pe,max:Oe}),queueMicrotask(G)}function G(){if(!c||!u)return;let re=c.valToPos(e.time,"x"),me=re>=-.5&&re<=c.over.clientWidth+.5;u.style.display=me?"":"none",u.style.transform=`translateX(${re}px)`}function le(){G(),(!e.playing||performance.now()-p>eS)&&Y()}function Y(){p=performance.now();let re=h??(s?e.time:null);T.textContent=h===null?"":s?`at ${h.toFixed(3)} s`:`at ${Zs(h,"Hz")}`,I.tell(me=>re===null?null:K(em(me,re)))}function K(re){return re!==null&&Math.abs(re)<Qb*g&&!a?0:re}function te(re){let me=re.filter(pe=>!pe.ghost).map(pe=>{let[Oe,Xe]=Bg(pe);return`${pe.label} ${pe.role}, from ${ei(Oe)} to ${ei(Xe)} ${o}`.trim()});return`${n.title}: ${me.join("; ")||"no curve is shown"}.`}function fe(){Ys(tm(l.filter(re=>I.shows(re)),s?"time [s]":"frequency [Hz]",o),`${n.id}.csv`,"text/csv")}let ue=new IntersectionObserver(re=>{d=re.some(me=>me.isIntersecting),d&&D(),d&&Y()},{rootMargin:"120px"}),Q=new ResizeObserver(()=>{d&&v.clientWidth>0&&V()});ue.observe(L),v.setAttribute("aria-label",te(l.filter(re=>I.shows(re)))),Q.observe(v);let _e=[e.subscribe(()=>{d&&s&&le()}),t.subscribe(()=>s&&$(t.range))];return{element:L,id:n.id,show(re){l=Yh(i,re),I.renew(l),N.hidden=re===null||n.marks.length===0,V()},recolour(){_+=1,V()},dispose(){ue.disconnect(),Q.disconnect(),_e.forEach(re=>re()),c?.destroy()}}}function Og(i){return i.runs.map(e=>e.chart).reduce((e,t)=>Ed(t)<Ed(e)?t:e)}function Ed(i){return i.at.data.length/i.samples}function tS(i){return`Drawn by ${i.at.data.length.toLocaleString("en")} of ${i.samples.toLocaleString("en")} samples; every extreme is kept.`}function Bg(i){let[e,t]=[1/0,-1/0];for(let n=0;n<i.y.length;n+=1)Number.isFinite(i.y[n])&&(e=Math.min(e,i.y[n]),t=Math.max(t,i.y[n]));return e<=t?[e,t]:[0,0]}function zg(){let i=new Set,e={range:null};return{get range(){return e.range},set(t){t===e.range||t&&e.range&&t.every((s,r)=>s===e.range?.[r])||(e.range=t,i.forEach(s=>s()))},subscribe(t){return i.add(t),()=>i.delete(t)}}}var Vg={overview:"Overview",tip:"Tip",contact:"Contact",deformations:"Deformations",motors:"Motors",energy:"Energy",spectrum:"Spectrum",all:"All"};function Hg(i,e,t){let n=Kp(e),s=zg(),r=X("div",{class:"chart-grid",id:"tm-charts",role:"tabpanel",tabindex:"0"}),o=X("div",{class:"tabs",role:"tablist","aria-label":"Charts"}),a=X("p",{class:"note hint",text:"Click or drag: choose the time. Shift and drag: zoom, double click: back."}),l=Object.keys(Vg).filter(m=>Gg(n,m).length>0),c=[],u=null;for(let m of l){let _=yt(Vg[m],()=>h(m),{role:"tab",id:`tm-tab-${m}`,"aria-controls":"tm-charts","data-group":m});o.append(_)}o.addEventListener("keydown",m=>{let _={ArrowRight:1,ArrowLeft:-1}[m.key],g=l.findIndex(p=>`tm-tab-${p}`===m.target.id);_===void 0||g<0||(m.preventDefault(),m.stopPropagation(),h(l[(g+_+l.length)%l.length]),o.querySelector("[aria-selected=true]")?.focus())});function h(m){c.forEach(_=>_.dispose()),c=Gg(n,m).map(_=>kg(_,t,s)),u&&c.forEach(_=>_.show(u));for(let _ of o.querySelectorAll("button")){let g=_.dataset.group===m;_.setAttribute("aria-selected",String(g)),_.tabIndex=g?0:-1}r.setAttribute("aria-labelledby",`tm-tab-${m}`),r.replaceChildren(...c.map(_=>_.element))}let d=matchMedia("(prefers-color-scheme: dark)"),f=()=>c.forEach(m=>m.recolour());return d.addEventListener("change",f),i.append(X("div",{class:"tab-bar"},o,a),r),h("overview"),{show(m){u=m,c.forEach(_=>_.show(m))},dispose(){d.removeEventListener("change",f),c.forEach(m=>m.dispose()),i.replaceChildren()}}}function Gg(i,e){return e==="all"?i:e!=="overview"?i.filter(({chart:t})=>t.group===e):i.filter(({chart:t},n)=>i.findIndex(s=>s.chart.group===t.group)===n)}var Wg='"use strict";(()=>{var O=class extends Error{name="EngineError"},Se=1,nt=65536,ot={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},Q=class e{constructor(r,n,t,o){this.layout=r;this.functions=n;this.memory=t;this.free=o}layout;functions;memory;free;static async open(r,n){if(n.format!==Se)throw new O(`layout: got format ${n.format}; expected ${Se}`);let{instance:t}=await st(r,n),{memory:o,heap_base:s,...a}=t.exports,i=s.value;return new e(n,a,o,i)}sample(r,n,t,o){let s=X(this.layout.samples,r,"function");j(`${r}: parameters`,n.length,s.parameters);let a=s.kind==="program"?this.program(s,n,t,o):this.schedule(s,n,[t],o);return fe(s.outputs,a,o,1)}slopes(r,n,t,o,s){let a=X(this.layout.samples,r,"function");if(a.kind!=="slopes")throw new O(`${r}: got a function without derivatives; expected one with them`);j(`${r}: parameters`,n.length,a.parameters);let i=Object.fromEntries(Object.entries(a.inputs).map(([m,u])=>[m,new Float64Array(u)])),l=this.schedule(a,n,[t,{...i,...o}],s),c=C(a.outputs);return{values:fe(a.outputs,l,s,2),slopes:fe(a.outputs,l.subarray(c),s,2)}}call(r,n){let t=n.map(i=>typeof i=="number"?null:i instanceof Float64Array?i:i.into);this.reserve(t.reduce((i,l)=>i+(l?.byteLength??0),this.free));let o=new Float64Array(this.memory.buffer),s=this.free,a=n.map((i,l)=>{if(typeof i=="number")return BigInt(i);let c=s;return(i instanceof Float64Array||i.given)&&o.set(t[l],c/8),s+=t[l].byteLength,c});this.functions[r](...a),n.forEach((i,l)=>{if(typeof i=="number"||i instanceof Float64Array)return;let[c,m]=i.range?.()??[0,i.into.length],u=a[l]/8;i.into.set(o.subarray(u+c,u+m),c)})}program(r,n,t,o){let s=Object.entries(r.inputs).map(([i,l])=>Re(i,l,t[i],o)),a=new Float64Array(o*C(r.outputs));return this.call(r.export,[o,n,...s,{into:a}]),a}schedule(r,n,t,o){let s=at(r.inputs,t,o),a=new Float64Array(o*t.length*C(r.outputs)),i=new Float64Array(r.workspace);return this.call(r.export,[o,0,n,i,s,{into:a}]),a}reserve(r){let n=r-this.memory.buffer.byteLength;if(!(n<=0))try{this.memory.grow(Math.ceil(n/nt))}catch{throw new O(`memory: got no room for ${(r/1e6).toFixed(0)} MB; expected a browser that has it. Mend: ask for fewer samples`)}}};async function st(e,r){try{return await WebAssembly.instantiate(e,{env:ot})}catch(n){let t=r.simd?", with vectors (SIMD)":"";throw new O(`WebAssembly: got ${String(n)}; expected a browser that allows it${t}`)}}function X(e,r,n){if(!Object.hasOwn(e,r))throw new O(`${n}: got ${r}; expected one of ${Object.keys(e).join(", ")}`);return e[r]}function j(e,r,n){if(r!==n)throw new O(`${e}: got ${r} numbers; expected ${n}`)}function C(e){return Object.values(e).reduce((r,n)=>r+n,0)}function Re(e,r,n,t){if(n===void 0)throw new O(`${e}: got nothing; expected ${r} numbers for each sample`);if(n.length===t*r)return n;j(e,n.length,r);let o=new Float64Array(t*r);return pe(n,0,0,o,r,0,r,t),o}function at(e,r,n){let t=C(e),o=new Float64Array(n*r.length*t);return r.forEach((s,a)=>{let i=a*t;for(let[l,c]of Object.entries(e)){let m=Re(l,c,s[l],n);pe(m,c,0,o,r.length*t,i,c,n),i+=c}}),o}function fe(e,r,n,t){let o=t*C(e),s={},a=0;for(let[i,l]of Object.entries(e)){let c=new Float64Array(n*l);pe(r,o,a,c,l,0,l,n),s[i]=c,a+=l}return s}function pe(e,r,n,t,o,s,a,i){for(let l=0;l<i;l++){let c=l*r+n,m=l*o+s;for(let u=0;u<a;u++)t[m+u]=e[c+u]}}var it=["rk4","midpoint"],lt=500,ge=class{constructor(r,n){this.engine=r;this.spec=n;let t=X(r.layout.loops,n.loop,"loop");j(`${n.loop}: parameters`,n.parameters.length,t.parameters),j(`${n.loop}: state`,n.state.length,t.size),j(`${n.loop}: rows`,n.rows.length,(n.knots.length-1)*t.row),this.method=t.method,this.memory=new Float64Array(r.layout.cells.length),this.state=n.state.slice(),this.slope=new Float64Array(t.size),this.sums=new Float64Array(t.size),this.states=new Float64Array(n.times.length*t.size),this.sumsAtSamples=new Float64Array(n.times.length*t.size),this.states.set(n.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;sums;sumsAtSamples;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(r){return this.memory[this.engine.layout.cells.indexOf(r)]}put(r){for(let[n,t]of Object.entries(r))this.memory[this.engine.layout.cells.indexOf(n)]=t}advance(r){let{layout:n}=this.engine,{settings:t,knots:o,rows:s,times:a,parameters:i}=this.spec,l=Math.max(1,Math.min(r,t.maxSteps-this.tried)),c={step:t.step,rtol:t.relativeTolerance,atol:t.absoluteTolerance,chunk:l,bound:n.limits.bound,watch:0,most_events:n.limits.most_events,event_time:n.limits.event_time,looks:0},m=this.cell("sample"),u=p=>({into:p,range:()=>[m*this.state.length,this.cell("sample")*this.state.length]}),f=p=>({into:p,given:!0}),g={memory:f(this.memory),y:f(this.state),k1:f(this.slope),p:i,knots:o,rows:s,times:a,out:u(this.states),options:Float64Array.from(n.options,p=>c[p]),errors:f(this.sums),errors_out:u(this.sumsAtSamples),seen:new Float64Array(1),segments:o.length-1,samples:a.length};this.engine.call(n.loops[this.spec.loop].export,n.arguments.map(p=>g[p]))}result(){let r=this.cell("sample"),n=this.state.length,[t,o]=this.ending();return{status:t,message:o,times:this.spec.times.slice(0,r),states:this.states.slice(0,r*n),errors:this.sumsAtSamples.slice(0,r*n),statistics:this.statistics()}}statistics(){let[r,n,t]=[this.cell("steps"),this.cell("smallest"),this.time],o=r?t/r:null,s={steps:r,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:o,smallest_step_s:n>0?n:o};return it.includes(this.method)&&(s.step=this.cell("h")),this.cell("passes")&&(s.passes=this.cell("passes")),this.cell("events")&&(s.contact_changes=this.cell("events")),s}ending(){let{statuses:r,limits:n}=this.engine.layout,{settings:t}=this.spec,[o,s]=[this.cell("status"),`t = ${I(this.time,6)} s`];if(o===r.finished)return["finished",`reached the end, t = ${I(t.duration,6)} s`];if(o===r.running)return["stopped",`stopped at ${s} of ${I(t.duration,6)} s: integration.max_steps = ${t.maxSteps} is used up`];if(o===r.chattering){let a=`more than ${n.most_events} times within ${n.event_time} s`;return["chattering",`stopped at ${s}: the contact set in or ended ${a}; give the surface damping, or a lower stiffness`]}return this.lost(o,s)}lost(r,n){let{statuses:t,coordinates:o,limits:s}=this.engine.layout,a=o.length,i=Array.from(this.rates().subarray(a,2*a),g=>Number.isFinite(g)?Math.abs(g):1/0),l=i.indexOf(Math.max(...i)),m=i[l]<s.bound?r===t.not_converged?"not_converged":r===t.step_too_small?"step_too_small":"diverged":"diverged",u=`its acceleration is ${I(i[l],3)} rad/s^2`,f=m.replaceAll("_"," ");return[m,`${f} at ${n} in coordinate ${o[l]}: ${u}; its last step was of ${I(this.cell("h"),3)} s`]}rates(){let{loop:r,parameters:n,rows:t}=this.spec,{row:o}=this.engine.layout.loops[r],s=Math.min(this.cell("segment"),t.length/o-1),a={time:Float64Array.of(this.time),state:this.state,row:t.slice(s*o,(s+1)*o),step:new Float64Array(1)};return this.engine.sample(`${r.slice(0,r.lastIndexOf("."))}.rate`,n,a,1).rate}},W=class extends O{name="Cancelled"};async function Y(e,r,n={}){let t=new ge(e,r),o=1e3*(n.piece??.05),s=lt,a=performance.now();for(;t.running;){let i=performance.now();t.advance(s);let l=performance.now();if(s=Math.max(1,Math.floor(s*Math.min(4,o/Math.max(l-i,.001)))),!(l-a<o)){if(n.progress?.(t.time/r.settings.duration),await new Promise(c=>setTimeout(c,0)),n.cancelled?.())throw new W(`the run was given up at t = ${I(t.time,6)} s`);a=performance.now()}}return t.result()}function I(e,r){return String(Number(e.toPrecision(r)))}function he(e,r=new Set){if(ArrayBuffer.isView(e))e.buffer instanceof ArrayBuffer&&r.add(e.buffer);else if(e!==null&&typeof e=="object")for(let n of Object.values(e))he(n,r);return[...r]}function Z(e,r){let n=Array.from(e.frames.data).filter(t=>t<r);return n[n.length-1]!==r-1&&n.push(r-1),n}function R(e){return e.data instanceof Float64Array?e.data:Float64Array.from(e.data)}function ee(e,r){let n=r.length;for(let t=0;t<n;t+=1){let o=t;for(let a=t+1;a<n;a+=1)Math.abs(e[a*n+t])>Math.abs(e[o*n+t])&&(o=a);let s=Math.abs(e[o*n+t]);if(!(s>0)||s===1/0)return!1;o!==t&&ct(e,r,t,o);for(let a=t+1;a<n;a+=1){let i=e[a*n+t]/e[t*n+t];if(i!==0){for(let l=t+1;l<n;l+=1)e[a*n+l]-=i*e[t*n+l];r[a]-=i*r[t]}}}for(let t=n-1;t>=0;t-=1){for(let o=t+1;o<n;o+=1)r[t]-=e[t*n+o]*r[o];r[t]/=e[t*n+t]}return!0}function ct(e,r,n,t){let o=r.length;for(let a=0;a<o;a+=1){let i=e[n*o+a];e[n*o+a]=e[t*o+a],e[t*o+a]=i}let s=r[n];r[n]=r[t],r[t]=s}function mt(e,r,n){let t=e.knobs.map(s=>s.start),o=e.knobs.map(s=>s.factor);return e.sliders.forEach((s,a)=>{s.real?o[s.knob]=r[a]:t[s.knob]=r[a]}),n==="reference"?t:e.knobs.map((s,a)=>{let i=o[a];return i===null||s.factor===null?t[a]:s.together?s.factor?t[a]*(i/s.factor):t[a]:t[a]*i})}function z(e,r,n){let t=e.runs[n],o=ut(t,mt(e,r,n)),s={};for(let[a,i]of Object.entries(t.places)){let l=i.shape.reduce((c,m)=>c*m,1);s[a]=o.slice(i.start,i.start+l)}return s}function ut(e,r){let n=R(e.base).slice(),t=e.powers.map(l=>_e(l,(c,m)=>Math.pow(r[c]/e.variables[c].start,m))),o=e.powers.map(l=>_e(l,(c,m)=>ft(e.variables[c],m,r[c]))),{products:s,terms:a,coefficients:i}=e;for(let l=0;l<s.data.length;l+=2)n[s.data[l]]*=t[s.data[l+1]];for(let l=0;l<a.data.length;l+=2)n[a.data[l]]+=i.data[l/2]*o[a.data[l+1]];return n}function _e(e,r){return e.reduce((n,[t,o])=>n*r(t,o),1)}function ft(e,r,n){let t=Math.pow(e.start,r);return(Math.pow(n,r)-t)/(Math.pow(e.far,r)-t)}function G(e,r){return{knots:e,coefficients:r,signals:1,degree:r.length/(e.length-1)-1}}function K(e,r){let n=e.degree+1,t=e.knots.length-1,o=0;for(;o<t&&e.knots[o]<r;)o+=1;let s=e.knots[t],a=[...e.knots.subarray(0,o)],i=[...e.coefficients.subarray(0,o*n)];return r>s&&(a.push(s),i.push(Me(e,t-1,0,s),...new Array(e.degree).fill(0))),G(Float64Array.from([...a,r]),Float64Array.from(i))}function Me(e,r,n,t){let o=e.degree+1,s=(r*e.signals+n)*o,a=t-e.knots[r],i=0;for(let l=e.degree;l>=0;l-=1)i=i*a+e.coefficients[s+l];return i}function de(e,r){let[n,t]=[0,e.length-1];for(;t-n>1;){let o=n+t>>1;e[o]<=r?n=o:t=o}return n}function te(e,r,n){return Me(e,de(e.knots,n),r,n)}function re(e){return Oe(e,Array.from({length:e.knots.length-1},(r,n)=>n))}function ne(e,r){return Oe(e,Array.from(r,n=>de(e.knots,n)))}function Oe(e,r){let n=e.signals*(e.degree+1),t=new Float64Array(r.length*(n+1));return r.forEach((o,s)=>{t[s*(n+1)]=e.knots[o],t.set(e.coefficients.subarray(o*n,(o+1)*n),s*(n+1)+1)}),t}function $e(e){if(!e.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let r=Math.max(...e.map(a=>a.knots[a.knots.length-1])),n=e.map(a=>a.knots[a.knots.length-1]<r?K(a,r):a),t=pt(n.flatMap(a=>[...a.knots])),o=Math.max(...n.map(a=>a.degree)),s=new Float64Array((t.length-1)*e.length*(o+1));return n.forEach((a,i)=>{for(let l=0;l<t.length-1;l+=1){let c=(l*e.length+i)*(o+1);gt(a,t,l,s.subarray(c,c+o+1))}}),{knots:t,coefficients:s,signals:e.length,degree:o}}function pt(e){let r=[...new Set(e)].sort((o,s)=>o-s),n=r[r.length-1]-r[0],t=r.filter((o,s)=>s===0||o-r[s-1]>1e-12*n);return t[t.length-1]=r[r.length-1],Float64Array.from(t)}function gt(e,r,n,t){let o=de(e.knots,(r[n]+r[n+1])/2),s=r[n]-e.knots[o],a=Math.abs(s)<=1e-12*(r[r.length-1]-r[0])?0:s;for(let i=0;i<=e.degree;i+=1){let l=e.coefficients[o*(e.degree+1)+i],c=1;for(let m=i;m>=0;m-=1)t[m]+=c*l*Math.pow(a,i-m),c=c*m/(i-m+1)}}var ht=40,dt=1e-12,yt=.5,Ee=1e-6,Te=8;function bt(e,r,n,t,o,s){let[a,i,l]=[t.length+1,n.length,r.rotors.length],c=new Float64Array(a*i);for(let f=0;f<a;f+=1)c.set(n,f*i),f&&(c[f*i+t[f-1]]+=Ee);let m={time:new Float64Array(1),state:c,row:r.rest_row,step:new Float64Array(1)},{rate:u}=e.sample("rest.rate",r.rest,m,a);for(let f=0;f<t.length;f+=1){s[f]=u[l+t[f]];for(let g=0;g<t.length;g+=1)o[f*t.length+g]=(u[(g+1)*i+l+t[f]]-s[f])/Ee}}function At(e,r,n,t){let o=e.layout.held,s=t.length,a=Array.from({length:s},(u,f)=>f).filter(u=>!o.includes(u)),i=new Float64Array(r.restSize);i.set(t);let l=new Float64Array(a.length**2),c=new Float64Array(a.length),m=1/0;for(let u=0;u<ht&&a.length;u+=1){if(bt(e,n,i,a,l,c),!ee(l,c))return null;let f=c.reduce((p,b)=>Math.max(p,Math.abs(b)),0);if(!Number.isFinite(f))return null;let g=Math.min(1,yt/f);for(let p=0;p<a.length;p+=1)i[a[p]]-=g*c[p];if(f<dt||f<1e-9&&f>=m/2)return i.slice(0,s);m=f}return a.length?null:i.slice(0,s)}function Ft(e,r,n,t,o){let s=(c,m)=>At(e,r,z(r.map,c,t),m),a=s(n,o);if(a)return a;let i=r.sliders.map(c=>c.value),l=o;for(let c=1;c<=Te&&l;c+=1)l=s(n.map((m,u)=>i[u]+(m-i[u])*(c/Te)),l);if(!l)throw new Error(`${t}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`);return l}function Le(e,r,n,t,o){let s=r.runs[t],a=R(s.start).slice(),[i,l]=[s.state.q[0],s.state.v[0]];if(r.atRest){let c=Ft(e,r,n,t,a.slice(...s.state.q));for(let m=0;m<c.length;m+=1)s.told.includes(m)||(a[i+m]=c[m])}for(let[c,m]of s.exact){a[i+c]=te(o,m,0);let u=o.degree;a[l+c]=u?o.coefficients[m*(u+1)+1]:0}return a}function w(e,r,n){let t=e.length/r,o=new Float64Array(t*n.length);for(let s=0;s<t;s+=1)for(let a=0;a<n.length;a+=1)o[s*n.length+a]=e[s*r+n[a]];return o}function S(e,r){return Array.from({length:r-e},(n,t)=>e+t)}function N(e,r,n){let t=new Float64Array(n.length*r);for(let o=0;o<n.length;o+=1)for(let s=0;s<r;s+=1)t[o*r+s]=e[n[o]*r+s];return t}function ye(e,...r){let n=r.map(a=>a.length/e),t=n.reduce((a,i)=>a+i,0),o=new Float64Array(e*t),s=0;return r.forEach((a,i)=>{for(let l=0;l<e;l+=1)for(let c=0;c<n[i];c+=1)o[l*t+s+c]=a[l*n[i]+c];s+=n[i]}),o}function H(e,r){return e.map((n,t)=>n-r[t])}function $(e,r){let n=new Float64Array(e.length/r);for(let t=0;t<n.length;t+=1){let o=0;for(let s=0;s<r;s+=1)o+=e[t*r+s]**2;n[t]=Math.sqrt(o)}return n}function oe(e,r,n,t){let o=e.length/n,s=r.length/n,a=new Float64Array(n),i=0;for(let l=0;l<n;l+=1){let c=0;for(let m=0;m<o;m+=1)c+=e[l*o+m];l===0&&(i=c),a[l]=c-i;for(let m=0;m<s;m+=1)a[l]+=(m<t?-1:1)*r[l*s+m]}return a}function B(e){let r=0;for(let n=1;n<e.length;n+=1)Math.abs(e[n])>Math.abs(e[r])&&(r=n);return r}function d(e,r,...n){return{data:e,shape:[r,...n]}}var se=24,wt=5e5,vt=2e4;function ae(e,r,n){let[t,o]=e.matrix.shape,s=new Float64Array(n*t);for(let a=0;a<n;a+=1)for(let i=0;i<t;i+=1){let l=e.constant.data[i];for(let c=0;c<o;c+=1)l+=e.matrix.data[i*o+c]*r[a*o+c];s[a*t+i]=l}return s}function Ne(e,r,n,t,o,s){let a=h=>N(t[h].data,t[h].shape.slice(1).reduce((y,A)=>y*A,1),s),i=s.length,l=be(e,r,n,a("q"),i),c=h=>be(e,r,n,h,i).line,m=h=>c(ae(r.straight,h,i)),u=m(a("q")),f=h=>({data:a(h),shape:[i,...t[h].shape.slice(1)]}),g="q_reference"in t,p=l.line.shape.slice(0,3),b=l.line.data.map((h,y)=>h-u.data[y]);return{times:{data:N(o,1,s),shape:[i]},line:l.line,rigid:u,roots:l.roots,reference:g?c(a("q_reference")):null,referenceRigid:g?m(a("q_reference")):null,colours:[{id:"deflection",label:"Deflection from the root\'s tangent",unit:"m",values:{data:l.bent,shape:p}},{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:$(b,3),shape:p}}],tip:f("tip"),tipReference:g?f("tip_reference"):null,contact:r.contactPoint<0?null:{force:f("contact_force"),at:kt(r,t,s)}}}function Pe(e,r,n,t,o){let[s,a]=[r.links.length,r.stations.data.length];if(!r.links.some(m=>m.bends)||o*s*a>wt)return null;let[i,l]=[t.length/o,Math.max(1,Math.floor(vt/(s*a)))],c={link:"",value:-1,sample:0};for(let m=0;m<o;m+=l){let u=Math.min(l,o-m),{bent:f}=be(e,r,n,t.subarray(m*i,(m+u)*i),u);for(let g=0;g<u;g+=1)r.links.forEach((p,b)=>{let h=f[(g*s+b+1)*a-1];p.bends&&h>c.value&&(c={link:p.name,value:h,sample:m+g})})}return c}function kt(e,r,n){let t=r.position.shape[1],o=N(r.position.data,3*t,n),s=new Float64Array(3*n.length);for(let a=0;a<n.length;a+=1)for(let i=0;i<3;i+=1)s[3*a+i]=o[3*(a*t+e.contactPoint)+i];return{data:s,shape:[n.length,3]}}function be(e,r,n,t,o){let s=new Float64Array(t.length/o),{points:a}=e.sample("pose",n,{q:t,v:s,a:s,base:R(r.base)},o),[i,l]=[r.links.length,r.stations.data.length],c=a.length/o/se,m=new Float64Array(o*i*l*3),u=new Float64Array(o*i*4),f=new Float64Array(o*i*l);for(let g=0;g<o;g+=1)r.links.forEach((p,b)=>{let h=a.subarray((g*c+p.point)*se,(g*c+p.point+1)*se);u.set(_t(h),(g*i+b)*4),g&&xt(u,(g*i+b)*4,4*i);for(let y=0;y<l;y+=1){let A=((g*i+b)*l+y)*3,F=(g*c+p.point+y)*se+9;for(let v=0;v<3;v+=1)m[A+v]=p.bends?a[F+v]:St(h,R(p.end),v,r.stations.data[y]);p.bends&&(f[A/3]=Rt(h,m,A))}});return{line:{data:m,shape:[o,i,l,3]},roots:{data:u,shape:[o,i,4]},bent:f}}function xt(e,r,n){let t=0;for(let o=r;o<r+4;o+=1)t+=e[o]*e[o-n];if(t<0)for(let o=r;o<r+4;o+=1)e[o]*=-1}function St(e,r,n,t){return e[9+n]+t*(e[3*n]*r[0]+e[3*n+1]*r[1]+e[3*n+2]*r[2])}function Rt(e,r,n){let t=[0,1,2].map(s=>r[n+s]-e[9+s]),o=[1,2].map(s=>e[s]*t[0]+e[3+s]*t[1]+e[6+s]*t[2]);return Math.hypot(o[0],o[1])}function _t(e){let r=e[0]+e[4]+e[8];if(r>0){let t=2*Math.sqrt(1+r);return[(e[7]-e[5])/t,(e[2]-e[6])/t,(e[3]-e[1])/t,t/4]}if(e[0]>e[4]&&e[0]>e[8]){let t=2*Math.sqrt(1+e[0]-e[4]-e[8]);return[t/4,(e[1]+e[3])/t,(e[2]+e[6])/t,(e[7]-e[5])/t]}if(e[4]>e[8]){let t=2*Math.sqrt(1+e[4]-e[0]-e[8]);return[(e[1]+e[3])/t,t/4,(e[5]+e[7])/t,(e[2]-e[6])/t]}let n=2*Math.sqrt(1+e[8]-e[0]-e[4]);return[(e[2]+e[6])/n,(e[5]+e[7])/n,n/4,(e[3]-e[1])/n]}var qe=.05,Mt=8,Ot=["settling","vibration.residual"];function k(e,r=3){return String(Number(e.toPrecision(r)))}function U(e,r){if(e.length<2)return r[0];let n=0;for(let t=1;t<e.length;t+=1)n+=(r[t]+r[t-1])/2*(e[t]-e[t-1]);return n/(e[e.length-1]-e[0])}function ie(e,r,n,t=0){let o={},s=r.deviation?.data;if(s){let a=B(s),i=s[s.length-1];o["deviation.max"]={value:s[a],note:`at ${k(e[a])} s; ${k(i)} m at the end of the run`},o["deviation.rms"]={value:Math.sqrt(U(e,s.map(l=>l*l))),note:"over the run"},o.settling=$t(e,s,n,t)}return o["vibration.residual"]=Bt(e,r,n),o}function $t(e,r,n,t){if(n===null)return{value:null,note:"not seen: what moves the robot changes up to the end of the run"};if(e[e.length-1]<=n*(1+1e-9))return{value:null,note:"not seen here: the run ends with the move"};let s=qe*r[B(r)],a=-1;for(let c=0;c<e.length;c+=1)e[c]>n&&r[c]>s&&(a=c);if(a===e.length-1)return{value:null,note:"not seen: it swings to the end of the run"};let i=e.length-e.findIndex(c=>c>n);if(e.length-1-a<t*i)return{value:null,note:"not seen: the run ends too soon after the move"};let l=`until the tip stays within ${k(s)} m, ${100*qe} % of its largest deviation`;return{value:a<0?0:e[a]-n,note:l}}function le(e){let r={};for(let[n,{value:t,note:o}]of Object.entries(e))Ot.includes(n)?r[n]={value:null,note:"the run broke off"}:r[n]={value:t,note:`until it broke off: ${o}`};return r}function Bt(e,r,n){if(n===null)return{value:null,note:"what moves the robot changes up to the end of the run"};let t=e.findIndex(l=>l>n*(1+1e-9));if(t<0||e.length-t<Mt)return{value:null,note:"the run ends with the move"};let o=r.tip_reference?.data,s=r.tip.data.map((l,c)=>l-(o?o[c]:0)).subarray(3*t),a=[0,1,2].map(l=>s.reduce((c,m,u)=>u%3===l?c+m:c,0)/(s.length/3)),i=$(s.map((l,c)=>l-a[c%3]),3);return{value:i[B(i)],note:`about its mean place, from ${k(e[t])} s on`}}function ce(e,r){if(!e.energy||!e.energy_balance)return{};let{energy:n,work:t}=e,o=n.shape[1],s=Math.max(n.data.reduce((l,c,m)=>Math.max(l,Math.abs(c-n.data[m%o])),0),t.data.reduce((l,c)=>Math.max(l,Math.abs(c)),0)),a=Math.abs(e.energy_balance.data[B(e.energy_balance.data.subarray(0,r))]),i=s?`worst residual, ${k(a)} J, over ${k(s)} J moved`:"nothing moved";return{"energy.residual":{value:s?a/s:null,note:i}}}function Ae(e,r,n=1){let t=B(r);return{value:Math.abs(r[t]),note:`at ${k(e[Math.floor(t/n)])} s`}}var T=24,Et=32;async function je(e,r,n,t,o){let s=performance.now(),a=r.runs.reference?["reference","real"]:["real"],i=[];for(let[F,v]of a.entries()){let E={...t,progress:me=>t.progress?.((F+me)/a.length)},q=z(r.map,n,v),_=()=>Nt(e,r,n,v,q,E);i.push(await(v==="reference"?o.of(q,_):_()))}let l=i[i.length-1],c=(performance.now()-s)/1e3,m=Math.min(...i.map(F=>F.run.times.length)),[u,f]=[l,...i.slice(0,-1)].map(F=>Pt(e,r,F,m)),g=l.run.times.subarray(0,m),p={...jt(r,l,u,m),...f?It(r,u,f,m):{}},b=Z(r,m),h=Wt(l.schedule),y=i.find(F=>F.run.status!=="finished"),A={...zt(r,g,p,h),...Lt(Pe(e,r,l.blocks.pose,u.model.q,m),g)};return{status:y?y.run.status:"finished",message:y?`${y===l?"real arm":"reference"}: ${y.run.message}`:l.run.message,seconds:c,times:g,series:p,scene:Ne(e,r,l.blocks.pose,p,g,b),line:null,span:Tt(g,h),facts:y?le(A):A}}function Tt(e,r){let n=e[e.length-1],t=r===null?-1:e.findIndex(o=>o>=r*(1+1e-9));return[t>=0&&e.length-t>=Et?e[t]:e[0],n]}function Lt(e,r){return e?{"deflection.max":{value:e.value,note:`${e.link}, at ${k(r[e.sample])} s`}}:{}}async function Nt(e,r,n,t,o,s){let{settings:a}=r,i=r.runs[t],l=S(0,i.signals).map(u=>K(G(o[`knots.${u}`],o[`coefficients.${u}`]),a.duration)),c=$e(l);l.length||(c.knots[1]=a.duration);let m=await Y(e,{loop:`${t}.${a.method}`,parameters:o.parameters,knots:c.knots,rows:re(c),state:Le(e,r,n,t,c),times:R(r.times),settings:a},s);return{name:t,told:i,blocks:o,schedule:c,run:m}}function Pt(e,r,n,t){let o=n.run.times.subarray(0,t),s=n.run.states.subarray(0,t*(n.run.states.length/n.run.times.length)),a=ne(n.schedule,o),i={time:o,state:s,row:a,step:new Float64Array(1)},l=e.sample(`${n.name}.observe`,n.blocks.parameters,i,t),{q:c,v:m,a:u}=l,f=R(r.base),{chain:g,rotors:p}=n.blocks,{points:b}=e.sample("inertia",g,{q:c,v:m,a:u,base:f},t),h=new Float64Array(p.length),y=e.sample("inertia",g,{q:c,v:h,a:m,base:f},t),A=e.sample("elastic",g,{q:c,v:m,base:f},t).energies;return{model:l,points:b,energy:qt(r,m,p,y,A,t)}}function qt(e,r,n,t,o,s){let a=n.length,i=o.length/s,l=new Float64Array(4*s);for(let c=0;c<s;c+=1){for(let m=0;m<a;m+=1){let u=r[c*a+m];l[4*c]+=(t.forces[c*a+m]+n[m]*u)*u/2}for(let m=0;m<3;m+=1)l[4*c+1]-=t.moment[3*c+m]*e.gravity.data[m];for(let m=0;m<i;m+=1)l[4*c+2+m%2]+=o[c*i+m]}return l}function jt(e,r,{model:n,points:t,energy:o},s){let a=n.q.length/s,i=n.gear.length/s,l=t.length/s/T,c=r.run.states.length/r.run.times.length,m=w(r.run.states.subarray(0,s*c),c,S(...r.told.state.works)),u=h=>d(w(n.drives,4*i,S(0,i).map(y=>4*y+h)),s,i),f=h=>w(t,l*T,S(0,l).flatMap(y=>S(0,3).map(A=>y*T+h+A))),g=w(t,l*T,S(0,l).flatMap(h=>S(h*T,h*T+9))),p={q:d(n.q,s,a),v:d(n.v,s,a),a:d(n.a,s,a),deformation:d(ae(e.deflections,n.q,s),s,e.deformations.length),position:d(f(9),s,l,3),velocity:d(f(12),s,l,3),acceleration:d(f(18),s,l,3),rotation:d(g,s,l,3,3),tip:d(w(t,l*T,[9,10,11]),s,3),tip_velocity:d(w(t,l*T,[12,13,14]),s,3),energy:d(o,s,4),work:d(m,s,m.length/s),energy_balance:d(oe(o,m,s,3),s)};if(i&&Object.assign(p,{wanted:u(3),effort:u(0),gear_torque:d(n.gear,s,i)}),i&&e.electric&&Object.assign(p,{voltage:u(1),current:u(2)}),e.contactPoint<0)return p;let b=h=>w(n.contact,6,h);return{...p,contact_force:d(b([0,1,2]),s,3),contact_force_normal:d(b([3]),s),penetration:d(b([4]),s)}}function It(e,r,n,t){let o=n.model.q.length/t,s=n.points.length/t/T,[a,i]=[r,n].map(({points:c})=>w(c,s*T,[9,10,11])),l={q_reference:d(n.model.q,t,o),v_reference:d(n.model.v,t,o),deformation_reference:d(ae(e.deflections,n.model.q,t),t,e.deformations.length),gear_torque_reference:d(n.model.gear,t,n.model.gear.length/t),tip_reference:d(i,t,3),deviation:d($(H(a,i),3),t)};return e.contactPoint>=0&&(l.contact_force_normal_reference=d(w(n.model.contact,6,[3]),t)),l}function Wt(e){let r=e.knots.length-1,n=e.degree+1;for(let t=r-1;t>=0;t-=1)for(let o=0;o<e.signals;o+=1){let s=e.coefficients.subarray((t*e.signals+o)*n,(t*e.signals+o+1)*n),a=e.knots[t+1]-e.knots[t],i=Math.max(...S(0,r).map(m=>Math.abs(e.coefficients[(m*e.signals+o)*n])),1e-12);if(s.some((m,u)=>u>0&&Math.abs(m)*a**u>1e-9*i))return t===r-1?null:e.knots[t+1];let c=t&&te(e,o,e.knots[t]-1e-9*a);if(t&&Math.abs(s[0]-c)>1e-6*i)return e.knots[t]}return 0}function zt(e,r,n,t){let o={...ie(r,n,t),...ce(n,r.length)},s=e.deformations.flatMap((c,m)=>c.endsWith(".gear")?[m]:[]),a=s.filter(c=>e.turning.includes(e.deformations[c].replace(/\\.gear$/,""))),i=a.length?a:s;if(i.length){let c=w(n.deformation.data,e.deformations.length,i),m=B(c),u=e.deformations[i[m%i.length]].replace(/\\.gear$/,"");o["gear.max"]={value:Math.abs(c[m]),note:`${u}, at ${k(r[Math.floor(m/i.length)])} s`}}let l=n.contact_force_normal?.data;if(l){let[c,m]=[l.reduce((u,f)=>Math.min(u,f)),l.reduce((u,f)=>Math.max(u,f))];o["contact.mean"]={value:U(r,l),note:`from ${k(c,4)} to ${k(m,4)} N`}}return o}var V=class{last=null;async of(r,n){if(this.last&&Dt(this.last.blocks,r))return this.last.made;this.last=null;let t=await n();return this.last={blocks:r,made:t},t}};function Dt(e,r){return Object.entries(e).every(([n,t])=>t.length===r[n].length&&t.every((o,s)=>o===r[n][s]))}var P=21;function Fe(e,r,n,t){let[o,s]=[n.length/P,t.length],a=new Float64Array(o*s),i=new Float64Array(o*s*P);for(let m=0;m<o;m+=1)for(let u=0;u<s;u+=1){let f=m*s+u;a[f]=t[u];for(let g=0;g<P;g+=1)i[f*P+g]=n[m*P+g]}let l={station:a,motion:i},c=[1,2].map(m=>e.sample(`real.line${m}`,r,l,o*s));return{stations:t,motion:n,parts:c}}function We(e){let r=e.length/6,n=new Float64Array(r*P);for(let t=0;t<r;t+=1)n.set(e.subarray(6*t,6*t+6),P*t);return n}function J(e,r){let[n,t]=[e.motion.length/P,e.stations.length],o=e.parts[0][r].length/(n*t),s=new Float64Array(n*2*t*o);return e.parts.forEach((a,i)=>{for(let l=0;l<n;l+=1)s.set(a[r].subarray(l*t*o,(l+1)*t*o),(2*l+i)*t*o)}),{data:s,shape:[n,2,t,o]}}function ze(e,r,n){let t=r.shape.slice(0,3),o=r.data.map((a,i)=>a-n.data[i]),s=a=>$(J(e,a).data,2);return[{id:"bending_moment",label:"Bending moment",unit:"N m",values:{data:s("bending_moment"),shape:t}},{id:"deflection",label:"Deflection from the root\'s tangent",unit:"m",values:{data:s("deflection"),shape:t}},{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:$(o,3),shape:t}}]}function De(e){let r=e.length/6,n=new Float64Array(r*8);for(let t=0;t<r;t+=1){let[o,,s,a]=e.subarray(6*t,6*t+6);n.set(Ie(s,0),8*t),n.set(Ie(o+(o-s)/2,a+a/2),8*t+4)}return{data:n,shape:[r,2,4]}}function Ie(e,r){let[n,t]=[Math.cos(e/2),Math.sin(e/2)],[o,s]=[Math.cos(r/2),Math.sin(r/2)];return[t*s,-n*s,t*o,n*o]}var Ce=["mode 1, horizontal","mode 2, horizontal","mode 1, vertical","mode 2, vertical","gear"],Ct=.2;function Ke(e,r,n,t){let o=r.deformation.data,s=B(o),a={...ie(e,r,t,Ct),"moment.max":n,"deformation.max":{value:Math.abs(o[s]),note:Ce[s%Ce.length]},"gear_torque.max":Ae(e,r.gear_torque.data),"voltage.max":Ae(e,r.voltage.data),...ce(r,e.length)},i=r.contact_force_radial?.data;if(i){let[l,c]=[i.reduce((m,u)=>Math.min(m,u)),i.reduce((m,u)=>Math.max(m,u))];a["contact.mean"]={value:U(e,i),note:`from ${k(l,4)} to ${k(c,4)} N`}}return a}function He(e,r,n){let t=Ge(r),o=Float64Array.from(t.s===0?[0]:[0,t.s]),{value:s,mode:a,s:i,plane:l,sample:c}=Ge(n(o)),m=i===0?"at the root":`at ${k(100*i)} % of its length`,u=`mode ${a+1}, ${m}, ${l?"vertical":"horizontal"} plane, at ${k(e[c])} s`;return{value:s,note:u}}function Ge(e){let r=e.stations.length,n=e.parts.map((t,o)=>{let s=B(t.bending_moment);return{value:Math.abs(t.bending_moment[s]),mode:o,s:e.stations[Math.floor(s/2)%r],plane:s%2,sample:Math.floor(s/(2*r))}});return n[1].value>n[0].value?n[1]:n[0]}var Gt=30,x=5;function we(e,r,n,t,o,s,a){let{free:i}=r,l=[0,1,2,3,4].filter(p=>!i.includes(p)),c=s.slice();for(let p=0;p<a;p+=1)for(let b of l)c[p*x+b]=0;let m=c.slice(),u=new Array(a).fill(!1),f=new Float64Array(a).fill(1/0),g=Array.from({length:a},(p,b)=>b);for(let p=0;p<Gt&&g.length;p+=1){let b=Kt(e,n,t,o,c,g,i);for(let h=0;h<g.length;h+=1){let y=g[h],[A,F]=[0,0];for(let E=0;E<x;E+=1){let q=b[h*x+E],_=c[y*x+E]-=q;p===0&&(m[y*x+E]=_),A=Math.max(A,Math.abs(q)),F=Math.max(F,Math.abs(_))}let v=A<=1e-14+1e-12*F||A<=1e-9*F&&A>=f[y]/2;u[y]=v&&F<Math.PI,f[y]=v?-1:A}g=g.filter(h=>f[h]>=0)}for(let p=0;p<a;p+=1)u[p]||c.set(m.subarray(p*x,(p+1)*x),p*x);return{angles:c,found:u}}function Kt(e,r,n,t,o,s,a){let[,[i,l]]=Object.entries(e.layout.samples[r].inputs),c={angles:Ue(o,x,s),[i]:Ue(t,l,s)},{residual:m,slope:u}=e.sample(r,n,c,s.length),f=a.length,[g,p]=[new Float64Array(f*f),new Float64Array(f)],b=new Float64Array(s.length*x);for(let h=0;h<s.length;h+=1){for(let y=0;y<f;y+=1){p[y]=m[h*x+a[y]];for(let A=0;A<f;A+=1)g[y*f+A]=u[h*x*x+a[A]*x+a[y]]}if(ee(g,p))for(let y=0;y<f;y+=1)b[h*x+a[y]]=p[y];else b.fill(1,h*x,(h+1)*x)}return b}function Ue(e,r,n){let t=new Float64Array(n.length*r);for(let o=0;o<n.length;o+=1)for(let s=0;s<r;s+=1)t[o*r+s]=e[n[o]*r+s];return t}var M=17,Ye=[1,0,1,0,0,1],Ht=[{id:"deflection",label:"Deflection",unit:"m"},{id:"slope",label:"Slope",unit:"rad"},{id:"bending_moment",label:"Bending moment",unit:"N m"},{id:"shear_force",label:"Shear force",unit:"N"}];async function Ze(e,r,n,t,o){let s=performance.now(),a=L=>({...t,progress:ue=>t.progress?.(L+ue/2)}),i=L=>z(r.map,n,L),l=i("reference"),c=await o.of(l,()=>Ve(e,r,l,"reference",a(0))),m=await Ve(e,r,i("real"),"real",a(.5)),u=Math.min(c.run.times.length,m.run.times.length),f=(performance.now()-s)/1e3,[g,p]=[Je(e,m,u),Je(e,c,u)],b=m.run.times.subarray(0,u),h=Vt(e,r,m,c,g,p,u),y=m.run.states.subarray(0,u*M),A=ye(u,w(y,M,S(0,12)),g.acceleration,g.contact_force),F=Z(r,u),v=(L,ue)=>Fe(e,m.numbers.parameters,L,ue),E=v(N(A,21,F),R(r.stations)),q=He(b,E,L=>v(A,L)),_=[c,m].find(L=>L.run.status!=="finished"),me=_===c?"reference":"real robot",ke=Ke(b,h,q,m.numbers.end[0]),xe=l.end[0];return{status:_?_.run.status:"finished",message:_?`${me}: ${_.run.message}`:m.run.message,seconds:f,times:b,series:h,...Jt(e,r,m,E,h,F),span:[r.steady[0]*xe,r.steady[1]*xe],facts:_?le(ke):ke}}async function Ve(e,r,n,t,o){let{settings:s}=r,a=K(G(n.knots,n.coefficients),s.duration),i=await Y(e,{loop:`${t}.${s.method}`,parameters:n.parameters,knots:a.knots,rows:re(a),state:Ut(e,r,t,n),times:R(r.times),settings:s},o);return{name:t,numbers:n,schedule:a,run:i}}function Ut(e,r,n,t){let{angles:o,found:s}=we(e,r,`${n}.rest`,t.parameters,t.start,new Float64Array(5),1);if(!s[0])throw new Error(`${n}: no static equilibrium; expected a link that carries its own load: raise a stiffness or lower a load`);let a=new Float64Array(M);for(let i=0;i<6;i+=1){a[i]=t.start[0]*Ye[i];for(let l=0;l<5;l+=1)a[i]+=r.basis.data[5*i+l]*o[l]}return a}function Je(e,r,n){let t=r.run.times.subarray(0,n),o=r.run.states.subarray(0,n*M),s=ne(r.schedule,t);return e.sample(`${r.name}.observe`,r.numbers.parameters,{time:t,state:o,row:s},n)}function Qe(e){return Float64Array.from({length:e.length},(r,n)=>e[6*Math.floor(n/6)+5]*Ye[n%6])}function Xe(e){let r=e.length/M,n=new Float64Array(r*5);for(let t=0;t<r;t+=1){let[o,s,a,i,l,c]=e.subarray(t*M,t*M+6);n.set([o-a,s-(o-a)/2,i,l-i/2,a-c],5*t)}return n}function Vt(e,r,n,t,o,s,a){let[i,l]=[n,t].map(h=>h.run.states.subarray(0,a*M)),[c,m,u]=[S(0,6),S(6,12),S(12,17)].map(h=>w(i,M,h)),f=Xe(i),g=ye(a,w(i,M,[5,11]),w(o.acceleration,6,[5]),o.contact_force),p=we(e,r,"real.quasistatic",n.numbers.parameters,g,f,a).angles,b={q:d(c,a,6),v:d(m,a,6),q_reference:d(w(l,M,S(0,6)),a,6),v_reference:d(w(l,M,S(6,12)),a,6),theta_wanted:d(o.wanted,a),voltage:d(o.voltage,a),current:d(o.current,a),tip:d(o.tip,a,3),tip_velocity:d(o.tip_velocity,a,3),tip_reference:d(s.tip,a,3),deviation:d($(H(o.tip,s.tip),3),a),deformation:d(f,a,5),deformation_reference:d(Xe(l),a,5),deformation_stationary:d(p,a,5),deformation_oscillatory:d(H(f,p),a,5),gear_torque:d(o.gear_torque,a),gear_torque_reference:d(s.gear_torque,a),energy:d(o.energy,a,4),work:d(u,a,5),energy_balance:d(oe(o.energy,u,a,1),a)};return r.contact?{...b,contact_force:d(o.contact_force,a,3),contact_force_radial:d(o.radial_force,a),contact_force_radial_reference:d(s.radial_force,a)}:b}function Jt(e,r,n,t,o,s){let{parameters:a}=n.numbers,i=A=>N(o[A].data,o[A].shape.slice(1).reduce((F,v)=>F*v,1),s),l=t.stations.length,c=i("q"),m=i("q_reference"),u=J(t,"line"),[f,g,p]=[Qe(c),m,Qe(m)].map(A=>J(Fe(e,a,We(A),t.stations),"line")),b=A=>({data:i(A),shape:[s.length,...o[A].shape.slice(1)]}),h={data:Float64Array.from({length:2*l},(A,F)=>r.lengths[Math.floor(F/l)]*t.stations[F%l]),shape:[2,l]},y={links:["Mode 1","Mode 2"],places:h,quantities:Ht.map(A=>({...A,planes:["horizontal","vertical"],values:J(t,A.id)}))};return{scene:{times:{data:N(n.run.times,1,s),shape:[s.length]},line:u,rigid:f,reference:g,referenceRigid:p,roots:De(c),tip:b("tip"),tipReference:b("tip_reference"),colours:ze(t,u,f),contact:r.contact?{force:b("contact_force"),at:b("tip")}:null},line:y}}async function et(e){let r=await Q.open(e.module.data,e.layout);if(e.kind==="arm"){let t=new V;return{run:(o,s)=>je(r,e,o,s,t)}}let n=new V;return{run:(t,o)=>Ze(r,e,t,o,n)}}var D=self,ve=null,rt=-1,tt=Promise.resolve();D.onmessage=({data:e})=>{if(e.kind==="open"){et(e.bundle).then(t=>{ve=t,D.postMessage({kind:"ready"})},t=>D.postMessage({kind:"failed",message:String(t)}));return}let{id:r,values:n}=e;rt=r,tt=tt.then(()=>Qt(r,n))};async function Qt(e,r){let n=()=>e!==rt;try{if(!ve)throw new Error("the live model is not open");if(await new Promise(o=>setTimeout(o,0)),n())throw new W("a newer run began");let t=await ve.run(r,{cancelled:n,progress:o=>D.postMessage({kind:"progress",id:e,share:o})});D.postMessage({kind:"done",id:e,run:t},he(t))}catch(t){let o=t instanceof Error?t.message:String(t);D.postMessage({kind:"error",id:e,cancelled:t instanceof W,message:o})}}})();\n';var Gi=class extends Error{name="EngineError"},Xg=1,iS=65536,sS={tmodes_far_sin:Math.sin,tmodes_far_cos:Math.cos,tmodes_pow:Math.pow},Ql=class i{constructor(e,t,n,s){this.layout=e;this.functions=t;this.memory=n;this.free=s}layout;functions;memory;free;static async open(e,t){if(t.format!==Xg)throw new Gi(`layout: got format ${t.format}; expected ${Xg}`);let{instance:n}=await rS(e,t),{memory:s,heap_base:r,...o}=n.exports,a=r.value;return new i(t,o,s,a)}sample(e,t,n,s){let r=ec(this.layout.samples,e,"function");Dr(`${e}: parameters`,t.length,r.parameters);let o=r.kind==="program"?this.program(r,t,n,s):this.schedule(r,t,[n],s);return Td(r.outputs,o,s,1)}slopes(e,t,n,s,r){let o=ec(this.layout.samples,e,"function");if(o.kind!=="slopes")throw new Gi(`${e}: got a function without derivatives; expected one with them`);Dr(`${e}: parameters`,t.length,o.parameters);let a=Object.fromEntries(Object.entries(o.inputs).map(([u,h])=>[u,new Float64Array(h)])),l=this.schedule(o,t,[n,{...a,...s}],r),c=xa(o.outputs);return{values:Td(o.outputs,l,r,2),slopes:Td(o.outputs,l.subarray(c),r,2)}}call(e,t){let n=t.map(a=>typeof a=="number"?null:a instanceof Float64Array?a:a.into);this.reserve(n.reduce((a,l)=>a+(l?.byteLength??0),this.free));let s=new Float64Array(this.memory.buffer),r=this.free,o=t.map((a,l)=>{if(typeof a=="number")return BigInt(a);let c=r;return(a instanceof Float64Array||a.given)&&s.set(n[l],c/8),r+=n[l].byteLength,c});this.functions[e](...o),t.forEach((a,l)=>{if(typeof a=="number"||a instanceof Float64Array)return;let[c,u]=a.range?.()??[0,a.into.length],h=o[l]/8;a.into.set(s.subarray(h+c,h+u),c)})}program(e,t,n,s){let r=Object.entries(e.inputs).map(([a,l])=>qg(a,l,n[a],s)),o=new Float64Array(s*xa(e.outputs));return this.call(e.export,[s,t,...r,{into:o}]),o}schedule(e,t,n,s){let r=oS(e.inputs,n,s),o=new Float64Array(s*n.length*xa(e.outputs)),a=new Float64Array(e.workspace);return this.call(e.export,[s,0,t,a,r,{into:o}]),o}reserve(e){let t=e-this.memory.buffer.byteLength;if(!(t<=0))try{this.memory.grow(Math.ceil(t/iS))}catch{throw new Gi(`memory: got no room for ${(e/1e6).toFixed(0)} MB; expected a browser that has it. Mend: ask for fewer samples`)}}};async function rS(i,e){try{return await WebAssembly.instantiate(i,{env:sS})}catch(t){let n=e.simd?", with vectors (SIMD)":"";throw new Gi(`WebAssembly: got ${String(t)}; expected a browser that allows it${n}`)}}function ec(i,e,t){if(!Object.hasOwn(i,e))throw new Gi(`${t}: got ${e}; expected one of ${Object.keys(i).join(", ")}`);return i[e]}function Dr(i,e,t){if(e!==t)throw new Gi(`${i}: got ${e} numbers; expected ${t}`)}function xa(i){return Object.values(i).reduce((e,t)=>e+t,0)}function qg(i,e,t,n){if(t===void 0)throw new Gi(`${i}: got nothing; expected ${e} numbers for each sample`);if(t.length===n*e)return t;Dr(i,t.length,e);let s=new Float64Array(n*e);return Rd(t,0,0,s,e,0,e,n),s}function oS(i,e,t){let n=xa(i),s=new Float64Array(t*e.length*n);return e.forEach((r,o)=>{let a=o*n;for(let[l,c]of Object.entries(i)){let u=qg(l,c,r[l],t);Rd(u,c,0,s,e.length*n,a,c,t),a+=c}}),s}function Td(i,e,t,n){let s=n*xa(i),r={},o=0;for(let[a,l]of Object.entries(i)){let c=new Float64Array(t*l);Rd(e,s,o,c,l,0,l,t),r[a]=c,o+=l}return r}function Rd(i,e,t,n,s,r,o,a){for(let l=0;l<a;l++){let c=l*e+t,u=l*s+r;for(let h=0;h<o;h++)n[u+h]=i[c+h]}}var aS=["rk4","midpoint"],lS=500,Cd=class{constructor(e,t){this.engine=e;this.spec=t;let n=ec(e.layout.loops,t.loop,"loop");Dr(`${t.loop}: parameters`,t.parameters.length,n.parameters),Dr(`${t.loop}: state`,t.state.length,n.size),Dr(`${t.loop}: rows`,t.rows.length,(t.knots.length-1)*n.row),this.method=n.method,this.memory=new Float64Array(e.layout.cells.length),this.state=t.state.slice(),this.slope=new Float64Array(n.size),this.sums=new Float64Array(n.size),this.states=new Float64Array(t.times.length*n.size),this.sumsAtSamples=new Float64Array(t.times.length*n.size),this.states.set(t.state),this.put({sample:1,fresh:1,old_error:1e-4})}engine;spec;method;memory;state;slope;states;sums;sumsAtSamples;get time(){return this.cell("t")}get running(){return this.cell("status")===this.engine.layout.statuses.running&&this.tried<this.spec.settings.maxSteps}get tried(){return this.cell("steps")+this.cell("rejected")}cell(e){return this.memory[this.engine.layout.cells.indexOf(e)]}put(e){for(let[t,n]of Object.entries(e))this.memory[this.engine.layout.cells.indexOf(t)]=n}advance(e){let{layout:t}=this.engine,{settings:n,knots:s,rows:r,times:o,parameters:a}=this.spec,l=Math.max(1,Math.min(e,n.maxSteps-this.tried)),c={step:n.step,rtol:n.relativeTolerance,atol:n.absoluteTolerance,chunk:l,bound:t.limits.bound,watch:0,most_events:t.limits.most_events,event_time:t.limits.event_time,looks:0},u=this.cell("sample"),h=m=>({into:m,range:()=>[u*this.state.length,this.cell("sample")*this.state.length]}),d=m=>({into:m,given:!0}),f={memory:d(this.memory),y:d(this.state),k1:d(this.slope),p:a,knots:s,rows:r,times:o,out:h(this.states),options:Float64Array.from(t.options,m=>c[m]),errors:d(this.sums),errors_out:h(this.sumsAtSamples),seen:new Float64Array(1),segments:s.length-1,samples:o.length};this.engine.call(t.loops[this.spec.loop].export,t.arguments.map(m=>f[m]))}result(){let e=this.cell("sample"),t=this.state.length,[n,s]=this.ending();return{status:n,message:s,times:this.spec.times.slice(0,e),states:this.states.slice(0,e*t),errors:this.sumsAtSamples.slice(0,e*t),statistics:this.statistics()}}statistics(){let[e,t,n]=[this.cell("steps"),this.cell("smallest"),this.time],s=e?n/e:null,r={steps:e,rejected:this.cell("rejected"),evaluations:this.cell("evaluations"),method:this.method,mean_step_s:s,smallest_step_s:t>0?t:s};return aS.includes(this.method)&&(r.step=this.cell("h")),this.cell("passes")&&(r.passes=this.cell("passes")),this.cell("events")&&(r.contact_changes=this.cell("events")),r}ending(){let{statuses:e,limits:t}=this.engine.layout,{settings:n}=this.spec,[s,r]=[this.cell("status"),`t = ${vo(this.time,6)} s`];if(s===e.finished)return["finished",`reached the end, t = ${vo(n.duration,6)} s`];if(s===e.running)return["stopped",`stopped at ${r} of ${vo(n.duration,6)} s: integration.max_steps = ${n.maxSteps} is used up`];if(s===e.chattering){let o=`more than ${t.most_events} times within ${t.event_time} s`;return["chattering",`stopped at ${r}: the contact set in or ended ${o}; give the surface damping, or a lower stiffness`]}return this.lost(s,r)}lost(e,t){let{statuses:n,coordinates:s,limits:r}=this.engine.layout,o=s.length,a=Array.from(this.rates().subarray(o,2*o),f=>Number.isFinite(f)?Math.abs(f):1/0),l=a.indexOf(Math.max(...a)),u=a[l]<r.bound?e===n.not_converged?"not_converged":e===n.step_too_small?"step_too_small":"diverged":"diverged",h=`its acceleration is ${vo(a[l],3)} rad/s^2`,d=u.replaceAll("_"," ");return[u,`${d} at ${t} in coordinate ${s[l]}: ${h}; its last step was of ${vo(this.cell("h"),3)} s`]}rates(){let{loop:e,parameters:t,rows:n}=this.spec,{row:s}=this.engine.layout.loops[e],r=Math.min(this.cell("segment"),n.length/s-1),o={time:Float64Array.of(this.time),state:this.state,row:n.slice(r*s,(r+1)*s),step:new Float64Array(1)};return this.engine.sample(`${e.slice(0,e.lastIndexOf("."))}.rate`,t,o,1).rate}},va=class extends Gi{name="Cancelled"};async function tc(i,e,t={}){let n=new Cd(i,e),s=1e3*(t.piece??.05),r=lS,o=performance.now();for(;n.running;){let a=performance.now();n.advance(r);let l=performance.now();if(r=Math.max(1,Math.floor(r*Math.min(4,s/Math.max(l-a,.001)))),!(l-o<s)){if(t.progress?.(n.time/e.settings.duration),await new Promise(c=>setTimeout(c,0)),t.cancelled?.())throw new va(`the run was given up at t = ${vo(n.time,6)} s`);o=performance.now()}}return n.result()}function vo(i,e){return String(Number(i.toPrecision(e)))}function nc(i,e){let t=Array.from(i.frames.data).filter(n=>n<e);return t[t.length-1]!==e-1&&t.push(e-1),t}function yi(i){return i.data instanceof Float64Array?i.data:Float64Array.from(i.data)}function ic(i,e){let t=e.length;for(let n=0;n<t;n+=1){let s=n;for(let o=n+1;o<t;o+=1)Math.abs(i[o*t+n])>Math.abs(i[s*t+n])&&(s=o);let r=Math.abs(i[s*t+n]);if(!(r>0)||r===1/0)return!1;s!==n&&cS(i,e,n,s);for(let o=n+1;o<t;o+=1){let a=i[o*t+n]/i[n*t+n];if(a!==0){for(let l=n+1;l<t;l+=1)i[o*t+l]-=a*i[n*t+l];e[o]-=a*e[n]}}}for(let n=t-1;n>=0;n-=1){for(let s=n+1;s<t;s+=1)e[n]-=i[n*t+s]*e[s];e[n]/=i[n*t+n]}return!0}function cS(i,e,t,n){let s=e.length;for(let o=0;o<s;o+=1){let a=i[t*s+o];i[t*s+o]=i[n*s+o],i[n*s+o]=a}let r=e[t];e[t]=e[n],e[n]=r}function uS(i,e,t){let n=i.knobs.map(r=>r.start),s=i.knobs.map(r=>r.factor);return i.sliders.forEach((r,o)=>{r.real?s[r.knob]=e[o]:n[r.knob]=e[o]}),t==="reference"?n:i.knobs.map((r,o)=>{let a=s[o];return a===null||r.factor===null?n[o]:r.together?r.factor?n[o]*(a/r.factor):n[o]:n[o]*a})}function bo(i,e,t){let n=i.runs[t],s=hS(n,uS(i,e,t)),r={};for(let[o,a]of Object.entries(n.places)){let l=a.shape.reduce((c,u)=>c*u,1);r[o]=s.slice(a.start,a.start+l)}return r}function hS(i,e){let t=yi(i.base).slice(),n=i.powers.map(l=>$g(l,(c,u)=>Math.pow(e[c]/i.variables[c].start,u))),s=i.powers.map(l=>$g(l,(c,u)=>dS(i.variables[c],u,e[c]))),{products:r,terms:o,coefficients:a}=i;for(let l=0;l<r.data.length;l+=2)t[r.data[l]]*=n[r.data[l+1]];for(let l=0;l<o.data.length;l+=2)t[o.data[l]]+=a.data[l/2]*s[o.data[l+1]];return t}function $g(i,e){return i.reduce((t,[n,s])=>t*e(n,s),1)}function dS(i,e,t){let n=Math.pow(i.start,e);return(Math.pow(t,e)-n)/(Math.pow(i.far,e)-n)}function ba(i,e){return{knots:i,coefficients:e,signals:1,degree:e.length/(i.length-1)-1}}function Sa(i,e){let t=i.degree+1,n=i.knots.length-1,s=0;for(;s<n&&i.knots[s]<e;)s+=1;let r=i.knots[n],o=[...i.knots.subarray(0,s)],a=[...i.coefficients.subarray(0,s*t)];return e>r&&(o.push(r),a.push(Yg(i,n-1,0,r),...new Array(i.degree).fill(0))),ba(Float64Array.from([...o,e]),Float64Array.from(a))}function Yg(i,e,t,n){let s=i.degree+1,r=(e*i.signals+t)*s,o=n-i.knots[e],a=0;for(let l=i.degree;l>=0;l-=1)a=a*o+i.coefficients[r+l];return a}function Pd(i,e){let[t,n]=[0,i.length-1];for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return t}function sc(i,e,t){return Yg(i,Pd(i.knots,t),e,t)}function rc(i){return Zg(i,Array.from({length:i.knots.length-1},(e,t)=>t))}function oc(i,e){return Zg(i,Array.from(e,t=>Pd(i.knots,t)))}function Zg(i,e){let t=i.signals*(i.degree+1),n=new Float64Array(e.length*(t+1));return e.forEach((s,r)=>{n[r*(t+1)]=i.knots[s],n.set(i.coefficients.subarray(s*t,(s+1)*t),r*(t+1)+1)}),n}function Jg(i){if(!i.length)return{knots:Float64Array.of(0,1),coefficients:new Float64Array(0),signals:0,degree:0};let e=Math.max(...i.map(o=>o.knots[o.knots.length-1])),t=i.map(o=>o.knots[o.knots.length-1]<e?Sa(o,e):o),n=fS(t.flatMap(o=>[...o.knots])),s=Math.max(...t.map(o=>o.degree)),r=new Float64Array((n.length-1)*i.length*(s+1));return t.forEach((o,a)=>{for(let l=0;l<n.length-1;l+=1){let c=(l*i.length+a)*(s+1);pS(o,n,l,r.subarray(c,c+s+1))}}),{knots:n,coefficients:r,signals:i.length,degree:s}}function fS(i){let e=[...new Set(i)].sort((s,r)=>s-r),t=e[e.length-1]-e[0],n=e.filter((s,r)=>r===0||s-e[r-1]>1e-12*t);return n[n.length-1]=e[e.length-1],Float64Array.from(n)}function pS(i,e,t,n){let s=Pd(i.knots,(e[t]+e[t+1])/2),r=e[t]-i.knots[s],o=Math.abs(r)<=1e-12*(e[e.length-1]-e[0])?0:r;for(let a=0;a<=i.degree;a+=1){let l=i.coefficients[s*(i.degree+1)+a],c=1;for(let u=a;u>=0;u-=1)n[u]+=c*l*Math.pow(o,a-u),c=c*u/(a-u+1)}}var mS=40,gS=1e-12,yS=.5,Kg=1e-6,Qg=8;function _S(i,e,t,n,s,r){let[o,a,l]=[n.length+1,t.length,e.rotors.length],c=new Float64Array(o*a);for(let d=0;d<o;d+=1)c.set(t,d*a),d&&(c[d*a+n[d-1]]+=Kg);let u={time:new Float64Array(1),state:c,row:e.rest_row,step:new Float64Array(1)},{rate:h}=i.sample("rest.rate",e.rest,u,o);for(let d=0;d<n.length;d+=1){r[d]=h[l+n[d]];for(let f=0;f<n.length;f+=1)s[d*n.length+f]=(h[(f+1)*a+l+n[d]]-r[d])/Kg}}function xS(i,e,t,n){let s=i.layout.held,r=n.length,o=Array.from({length:r},(h,d)=>d).filter(h=>!s.includes(h)),a=new Float64Array(e.restSize);a.set(n);let l=new Float64Array(o.length**2),c=new Float64Array(o.length),u=1/0;for(let h=0;h<mS&&o.length;h+=1){if(_S(i,t,a,o,l,c),!ic(l,c))return null;let d=c.reduce((m,_)=>Math.max(m,Math.abs(_)),0);if(!Number.isFinite(d))return null;let f=Math.min(1,yS/d);for(let m=0;m<o.length;m+=1)a[o[m]]-=f*c[m];if(d<gS||d<1e-9&&d>=u/2)return a.slice(0,r);u=d}return o.length?null:a.slice(0,r)}function vS(i,e,t,n,s){let r=(c,u)=>xS(i,e,bo(e.map,c,n),u),o=r(t,s);if(o)return o;let a=e.sliders.map(c=>c.value),l=s;for(let c=1;c<=Qg&&l;c+=1)l=r(t.map((u,h)=>a[h]+(u-a[h])*(c/Qg)),l);if(!l)throw new Error(`${n}: no static equilibrium; expected links and gears that carry their loads: raise a stiffness or lower a load`);return l}function e0(i,e,t,n,s){let r=e.runs[n],o=yi(r.start).slice(),[a,l]=[r.state.q[0],r.state.v[0]];if(e.atRest){let c=vS(i,e,t,n,o.slice(...r.state.q));for(let u=0;u<c.length;u+=1)r.told.includes(u)||(o[a+u]=c[u])}for(let[c,u]of r.exact){o[a+c]=sc(s,u,0);let h=s.degree;o[l+c]=h?s.coefficients[u*(h+1)+1]:0}return o}function Pn(i,e,t){let n=i.length/e,s=new Float64Array(n*t.length);for(let r=0;r<n;r+=1)for(let o=0;o<t.length;o+=1)s[r*t.length+o]=i[r*e+t[o]];return s}function Xn(i,e){return Array.from({length:e-i},(t,n)=>i+n)}function Ks(i,e,t){let n=new Float64Array(t.length*e);for(let s=0;s<t.length;s+=1)for(let r=0;r<e;r+=1)n[s*e+r]=i[t[s]*e+r];return n}function Ld(i,...e){let t=e.map(o=>o.length/i),n=t.reduce((o,a)=>o+a,0),s=new Float64Array(i*n),r=0;return e.forEach((o,a)=>{for(let l=0;l<i;l+=1)for(let c=0;c<t[a];c+=1)s[l*n+r+c]=o[l*t[a]+c];r+=t[a]}),s}function Ma(i,e){return i.map((t,n)=>t-e[n])}function Hi(i,e){let t=new Float64Array(i.length/e);for(let n=0;n<t.length;n+=1){let s=0;for(let r=0;r<e;r+=1)s+=i[n*e+r]**2;t[n]=Math.sqrt(s)}return t}function ac(i,e,t,n){let s=i.length/t,r=e.length/t,o=new Float64Array(t),a=0;for(let l=0;l<t;l+=1){let c=0;for(let u=0;u<s;u+=1)c+=i[l*s+u];l===0&&(a=c),o[l]=c-a;for(let u=0;u<r;u+=1)o[l]+=(u<n?-1:1)*e[l*r+u]}return o}function Wi(i){let e=0;for(let t=1;t<i.length;t+=1)Math.abs(i[t])>Math.abs(i[e])&&(e=t);return e}function Je(i,e,...t){return{data:i,shape:[e,...t]}}var lc=24,bS=5e5,SS=2e4;function cc(i,e,t){let[n,s]=i.matrix.shape,r=new Float64Array(t*n);for(let o=0;o<t;o+=1)for(let a=0;a<n;a+=1){let l=i.constant.data[a];for(let c=0;c<s;c+=1)l+=i.matrix.data[a*s+c]*e[o*s+c];r[o*n+a]=l}return r}function t0(i,e,t,n,s,r){let o=g=>Ks(n[g].data,n[g].shape.slice(1).reduce((p,v)=>p*v,1),r),a=r.length,l=Id(i,e,t,o("q"),a),c=g=>Id(i,e,t,g,a).line,u=g=>c(cc(e.straight,g,a)),h=u(o("q")),d=g=>({data:o(g),shape:[a,...n[g].shape.slice(1)]}),f="q_reference"in n,m=l.line.shape.slice(0,3),_=l.line.data.map((g,p)=>g-h.data[p]);return{times:{data:Ks(s,1,r),shape:[a]},line:l.line,rigid:h,roots:l.roots,reference:f?c(o("q_reference")):null,referenceRigid:f?u(o("q_reference")):null,colours:[{id:"deflection",label:"Deflection from the root's tangent",unit:"m",values:{data:l.bent,shape:m}},{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:Hi(_,3),shape:m}}],tip:d("tip"),tipReference:f?d("tip_reference"):null,contact:e.contactPoint<0?null:{force:d("contact_force"),at:MS(e,n,r)}}}function n0(i,e,t,n,s){let[r,o]=[e.links.length,e.stations.data.length];if(!e.links.some(u=>u.bends)||s*r*o>bS)return null;let[a,l]=[n.length/s,Math.max(1,Math.floor(SS/(r*o)))],c={link:"",value:-1,sample:0};for(let u=0;u<s;u+=l){let h=Math.min(l,s-u),{bent:d}=Id(i,e,t,n.subarray(u*a,(u+h)*a),h);for(let f=0;f<h;f+=1)e.links.forEach((m,_)=>{let g=d[(f*r+_+1)*o-1];m.bends&&g>c.value&&(c={link:m.name,value:g,sample:u+f})})}return c}function MS(i,e,t){let n=e.position.shape[1],s=Ks(e.position.data,3*n,t),r=new Float64Array(3*t.length);for(let o=0;o<t.length;o+=1)for(let a=0;a<3;a+=1)r[3*o+a]=s[3*(o*n+i.contactPoint)+a];return{data:r,shape:[t.length,3]}}function Id(i,e,t,n,s){let r=new Float64Array(n.length/s),{points:o}=i.sample("pose",t,{q:n,v:r,a:r,base:yi(e.base)},s),[a,l]=[e.links.length,e.stations.data.length],c=o.length/s/lc,u=new Float64Array(s*a*l*3),h=new Float64Array(s*a*4),d=new Float64Array(s*a*l);for(let f=0;f<s;f+=1)e.links.forEach((m,_)=>{let g=o.subarray((f*c+m.point)*lc,(f*c+m.point+1)*lc);h.set(TS(g),(f*a+_)*4),f&&wS(h,(f*a+_)*4,4*a);for(let p=0;p<l;p+=1){let v=((f*a+_)*l+p)*3,T=(f*c+m.point+p)*lc+9;for(let x=0;x<3;x+=1)u[v+x]=m.bends?o[T+x]:AS(g,yi(m.end),x,e.stations.data[p]);m.bends&&(d[v/3]=ES(g,u,v))}});return{line:{data:u,shape:[s,a,l,3]},roots:{data:h,shape:[s,a,4]},bent:d}}function wS(i,e,t){let n=0;for(let s=e;s<e+4;s+=1)n+=i[s]*i[s-t];if(n<0)for(let s=e;s<e+4;s+=1)i[s]*=-1}function AS(i,e,t,n){return i[9+t]+n*(i[3*t]*e[0]+i[3*t+1]*e[1]+i[3*t+2]*e[2])}function ES(i,e,t){let n=[0,1,2].map(r=>e[t+r]-i[9+r]),s=[1,2].map(r=>i[r]*n[0]+i[3+r]*n[1]+i[6+r]*n[2]);return Math.hypot(s[0],s[1])}function TS(i){let e=i[0]+i[4]+i[8];if(e>0){let n=2*Math.sqrt(1+e);return[(i[7]-i[5])/n,(i[2]-i[6])/n,(i[3]-i[1])/n,n/4]}if(i[0]>i[4]&&i[0]>i[8]){let n=2*Math.sqrt(1+i[0]-i[4]-i[8]);return[n/4,(i[1]+i[3])/n,(i[2]+i[6])/n,(i[7]-i[5])/n]}if(i[4]>i[8]){let n=2*Math.sqrt(1+i[4]-i[0]-i[8]);return[(i[1]+i[3])/n,n/4,(i[5]+i[7])/n,(i[2]-i[6])/n]}let t=2*Math.sqrt(1+i[8]-i[0]-i[4]);return[(i[2]+i[6])/t,(i[5]+i[7])/t,t/4,(i[3]-i[1])/t]}var i0=.05,RS=8,CS=["settling","vibration.residual"];function On(i,e=3){return String(Number(i.toPrecision(e)))}function wa(i,e){if(i.length<2)return e[0];let t=0;for(let n=1;n<i.length;n+=1)t+=(e[n]+e[n-1])/2*(i[n]-i[n-1]);return t/(i[i.length-1]-i[0])}function uc(i,e,t,n=0){let s={},r=e.deviation?.data;if(r){let o=Wi(r),a=r[r.length-1];s["deviation.max"]={value:r[o],note:`at ${On(i[o])} s; ${On(a)} m at the end of the run`},s["deviation.rms"]={value:Math.sqrt(wa(i,r.map(l=>l*l))),note:"over the run"},s.settling=PS(i,r,t,n)}return s["vibration.residual"]=LS(i,e,t),s}function PS(i,e,t,n){if(t===null)return{value:null,note:"not seen: what moves the robot changes up to the end of the run"};if(i[i.length-1]<=t*(1+1e-9))return{value:null,note:"not seen here: the run ends with the move"};let r=i0*e[Wi(e)],o=-1;for(let c=0;c<i.length;c+=1)i[c]>t&&e[c]>r&&(o=c);if(o===i.length-1)return{value:null,note:"not seen: it swings to the end of the run"};let a=i.length-i.findIndex(c=>c>t);if(i.length-1-o<n*a)return{value:null,note:"not seen: the run ends too soon after the move"};let l=`until the tip stays within ${On(r)} m, ${100*i0} % of its largest deviation`;return{value:o<0?0:i[o]-t,note:l}}function hc(i){let e={};for(let[t,{value:n,note:s}]of Object.entries(i))CS.includes(t)?e[t]={value:null,note:"the run broke off"}:e[t]={value:n,note:`until it broke off: ${s}`};return e}function LS(i,e,t){if(t===null)return{value:null,note:"what moves the robot changes up to the end of the run"};let n=i.findIndex(l=>l>t*(1+1e-9));if(n<0||i.length-n<RS)return{value:null,note:"the run ends with the move"};let s=e.tip_reference?.data,r=e.tip.data.map((l,c)=>l-(s?s[c]:0)).subarray(3*n),o=[0,1,2].map(l=>r.reduce((c,u,h)=>h%3===l?c+u:c,0)/(r.length/3)),a=Hi(r.map((l,c)=>l-o[c%3]),3);return{value:a[Wi(a)],note:`about its mean place, from ${On(i[n])} s on`}}function dc(i,e){if(!i.energy||!i.energy_balance)return{};let{energy:t,work:n}=i,s=t.shape[1],r=Math.max(t.data.reduce((l,c,u)=>Math.max(l,Math.abs(c-t.data[u%s])),0),n.data.reduce((l,c)=>Math.max(l,Math.abs(c)),0)),o=Math.abs(i.energy_balance.data[Wi(i.energy_balance.data.subarray(0,e))]),a=r?`worst residual, ${On(o)} J, over ${On(r)} J moved`:"nothing moved";return{"energy.residual":{value:r?o/r:null,note:a}}}function Dd(i,e,t=1){let n=Wi(e);return{value:Math.abs(e[n]),note:`at ${On(i[Math.floor(n/t)])} s`}}var ds=24,IS=32;async function s0(i,e,t,n,s){let r=performance.now(),o=e.runs.reference?["reference","real"]:["real"],a=[];for(let[T,x]of o.entries()){let R={...n,progress:M=>n.progress?.((T+M)/o.length)},w=bo(e.map,t,x),y=()=>NS(i,e,t,x,w,R);a.push(await(x==="reference"?s.of(w,y):y()))}let l=a[a.length-1],c=(performance.now()-r)/1e3,u=Math.min(...a.map(T=>T.run.times.length)),[h,d]=[l,...a.slice(0,-1)].map(T=>US(i,e,T,u)),f=l.run.times.subarray(0,u),m={...BS(e,l,h,u),...d?kS(e,h,d,u):{}},_=nc(e,u),g=zS(l.schedule),p=a.find(T=>T.run.status!=="finished"),v={...VS(e,f,m,g),...FS(n0(i,e,l.blocks.pose,h.model.q,u),f)};return{status:p?p.run.status:"finished",message:p?`${p===l?"real arm":"reference"}: ${p.run.message}`:l.run.message,seconds:c,times:f,series:m,scene:t0(i,e,l.blocks.pose,m,f,_),line:null,span:DS(f,g),facts:p?hc(v):v}}function DS(i,e){let t=i[i.length-1],n=e===null?-1:i.findIndex(s=>s>=e*(1+1e-9));return[n>=0&&i.length-n>=IS?i[n]:i[0],t]}function FS(i,e){return i?{"deflection.max":{value:i.value,note:`${i.link}, at ${On(e[i.sample])} s`}}:{}}async function NS(i,e,t,n,s,r){let{settings:o}=e,a=e.runs[n],l=Xn(0,a.signals).map(h=>Sa(ba(s[`knots.${h}`],s[`coefficients.${h}`]),o.duration)),c=Jg(l);l.length||(c.knots[1]=o.duration);let u=await tc(i,{loop:`${n}.${o.method}`,parameters:s.parameters,knots:c.knots,rows:rc(c),state:e0(i,e,t,n,c),times:yi(e.times),settings:o},r);return{name:n,told:a,blocks:s,schedule:c,run:u}}function US(i,e,t,n){let s=t.run.times.subarray(0,n),r=t.run.states.subarray(0,n*(t.run.states.length/t.run.times.length)),o=oc(t.schedule,s),a={time:s,state:r,row:o,step:new Float64Array(1)},l=i.sample(`${t.name}.observe`,t.blocks.parameters,a,n),{q:c,v:u,a:h}=l,d=yi(e.base),{chain:f,rotors:m}=t.blocks,{points:_}=i.sample("inertia",f,{q:c,v:u,a:h,base:d},n),g=new Float64Array(m.length),p=i.sample("inertia",f,{q:c,v:g,a:u,base:d},n),v=i.sample("elastic",f,{q:c,v:u,base:d},n).energies;return{model:l,points:_,energy:OS(e,u,m,p,v,n)}}function OS(i,e,t,n,s,r){let o=t.length,a=s.length/r,l=new Float64Array(4*r);for(let c=0;c<r;c+=1){for(let u=0;u<o;u+=1){let h=e[c*o+u];l[4*c]+=(n.forces[c*o+u]+t[u]*h)*h/2}for(let u=0;u<3;u+=1)l[4*c+1]-=n.moment[3*c+u]*i.gravity.data[u];for(let u=0;u<a;u+=1)l[4*c+2+u%2]+=s[c*a+u]}return l}function BS(i,e,{model:t,points:n,energy:s},r){let o=t.q.length/r,a=t.gear.length/r,l=n.length/r/ds,c=e.run.states.length/e.run.times.length,u=Pn(e.run.states.subarray(0,r*c),c,Xn(...e.told.state.works)),h=g=>Je(Pn(t.drives,4*a,Xn(0,a).map(p=>4*p+g)),r,a),d=g=>Pn(n,l*ds,Xn(0,l).flatMap(p=>Xn(0,3).map(v=>p*ds+g+v))),f=Pn(n,l*ds,Xn(0,l).flatMap(g=>Xn(g*ds,g*ds+9))),m={q:Je(t.q,r,o),v:Je(t.v,r,o),a:Je(t.a,r,o),deformation:Je(cc(i.deflections,t.q,r),r,i.deformations.length),position:Je(d(9),r,l,3),velocity:Je(d(12),r,l,3),acceleration:Je(d(18),r,l,3),rotation:Je(f,r,l,3,3),tip:Je(Pn(n,l*ds,[9,10,11]),r,3),tip_velocity:Je(Pn(n,l*ds,[12,13,14]),r,3),energy:Je(s,r,4),work:Je(u,r,u.length/r),energy_balance:Je(ac(s,u,r,3),r)};if(a&&Object.assign(m,{wanted:h(3),effort:h(0),gear_torque:Je(t.gear,r,a)}),a&&i.electric&&Object.assign(m,{voltage:h(1),current:h(2)}),i.contactPoint<0)return m;let _=g=>Pn(t.contact,6,g);return{...m,contact_force:Je(_([0,1,2]),r,3),contact_force_normal:Je(_([3]),r),penetration:Je(_([4]),r)}}function kS(i,e,t,n){let s=t.model.q.length/n,r=t.points.length/n/ds,[o,a]=[e,t].map(({points:c})=>Pn(c,r*ds,[9,10,11])),l={q_reference:Je(t.model.q,n,s),v_reference:Je(t.model.v,n,s),deformation_reference:Je(cc(i.deflections,t.model.q,n),n,i.deformations.length),gear_torque_reference:Je(t.model.gear,n,t.model.gear.length/n),tip_reference:Je(a,n,3),deviation:Je(Hi(Ma(o,a),3),n)};return i.contactPoint>=0&&(l.contact_force_normal_reference=Je(Pn(t.model.contact,6,[3]),n)),l}function zS(i){let e=i.knots.length-1,t=i.degree+1;for(let n=e-1;n>=0;n-=1)for(let s=0;s<i.signals;s+=1){let r=i.coefficients.subarray((n*i.signals+s)*t,(n*i.signals+s+1)*t),o=i.knots[n+1]-i.knots[n],a=Math.max(...Xn(0,e).map(u=>Math.abs(i.coefficients[(u*i.signals+s)*t])),1e-12);if(r.some((u,h)=>h>0&&Math.abs(u)*o**h>1e-9*a))return n===e-1?null:i.knots[n+1];let c=n&&sc(i,s,i.knots[n]-1e-9*o);if(n&&Math.abs(r[0]-c)>1e-6*a)return i.knots[n]}return 0}function VS(i,e,t,n){let s={...uc(e,t,n),...dc(t,e.length)},r=i.deformations.flatMap((c,u)=>c.endsWith(".gear")?[u]:[]),o=r.filter(c=>i.turning.includes(i.deformations[c].replace(/\.gear$/,""))),a=o.length?o:r;if(a.length){let c=Pn(t.deformation.data,i.deformations.length,a),u=Wi(c),h=i.deformations[a[u%a.length]].replace(/\.gear$/,"");s["gear.max"]={value:Math.abs(c[u]),note:`${h}, at ${On(e[Math.floor(u/a.length)])} s`}}let l=t.contact_force_normal?.data;if(l){let[c,u]=[l.reduce((h,d)=>Math.min(h,d)),l.reduce((h,d)=>Math.max(h,d))];s["contact.mean"]={value:wa(e,l),note:`from ${On(c,4)} to ${On(u,4)} N`}}return s}var Aa=class{last=null;async of(e,t){if(this.last&&GS(this.last.blocks,e))return this.last.made;this.last=null;let n=await t();return this.last={blocks:e,made:n},n}};function GS(i,e){return Object.entries(i).every(([t,n])=>n.length===e[t].length&&n.every((s,r)=>s===e[t][r]))}var Qs=21;function Fd(i,e,t,n){let[s,r]=[t.length/Qs,n.length],o=new Float64Array(s*r),a=new Float64Array(s*r*Qs);for(let u=0;u<s;u+=1)for(let h=0;h<r;h+=1){let d=u*r+h;o[d]=n[h];for(let f=0;f<Qs;f+=1)a[d*Qs+f]=t[u*Qs+f]}let l={station:o,motion:a},c=[1,2].map(u=>i.sample(`real.line${u}`,e,l,s*r));return{stations:n,motion:t,parts:c}}function o0(i){let e=i.length/6,t=new Float64Array(e*Qs);for(let n=0;n<e;n+=1)t.set(i.subarray(6*n,6*n+6),Qs*n);return t}function Ea(i,e){let[t,n]=[i.motion.length/Qs,i.stations.length],s=i.parts[0][e].length/(t*n),r=new Float64Array(t*2*n*s);return i.parts.forEach((o,a)=>{for(let l=0;l<t;l+=1)r.set(o[e].subarray(l*n*s,(l+1)*n*s),(2*l+a)*n*s)}),{data:r,shape:[t,2,n,s]}}function a0(i,e,t){let n=e.shape.slice(0,3),s=e.data.map((o,a)=>o-t.data[a]),r=o=>Hi(Ea(i,o).data,2);return[{id:"bending_moment",label:"Bending moment",unit:"N m",values:{data:r("bending_moment"),shape:n}},{id:"deflection",label:"Deflection from the root's tangent",unit:"m",values:{data:r("deflection"),shape:n}},{id:"displacement",label:"Displacement by all elasticity",unit:"m",values:{data:Hi(s,3),shape:n}}]}function l0(i){let e=i.length/6,t=new Float64Array(e*8);for(let n=0;n<e;n+=1){let[s,,r,o]=i.subarray(6*n,6*n+6);t.set(r0(r,0),8*n),t.set(r0(s+(s-r)/2,o+o/2),8*n+4)}return{data:t,shape:[e,2,4]}}function r0(i,e){let[t,n]=[Math.cos(i/2),Math.sin(i/2)],[s,r]=[Math.cos(e/2),Math.sin(e/2)];return[n*r,-t*r,n*s,t*s]}var c0=["mode 1, horizontal","mode 2, horizontal","mode 1, vertical","mode 2, vertical","gear"],HS=.2;function h0(i,e,t,n){let s=e.deformation.data,r=Wi(s),o={...uc(i,e,n,HS),"moment.max":t,"deformation.max":{value:Math.abs(s[r]),note:c0[r%c0.length]},"gear_torque.max":Dd(i,e.gear_torque.data),"voltage.max":Dd(i,e.voltage.data),...dc(e,i.length)},a=e.contact_force_radial?.data;if(a){let[l,c]=[a.reduce((u,h)=>Math.min(u,h)),a.reduce((u,h)=>Math.max(u,h))];o["contact.mean"]={value:wa(i,a),note:`from ${On(l,4)} to ${On(c,4)} N`}}return o}function d0(i,e,t){let n=u0(e),s=Float64Array.from(n.s===0?[0]:[0,n.s]),{value:r,mode:o,s:a,plane:l,sample:c}=u0(t(s)),u=a===0?"at the root":`at ${On(100*a)} % of its length`,h=`mode ${o+1}, ${u}, ${l?"vertical":"horizontal"} plane, at ${On(i[c])} s`;return{value:r,note:h}}function u0(i){let e=i.stations.length,t=i.parts.map((n,s)=>{let r=Wi(n.bending_moment);return{value:Math.abs(n.bending_moment[r]),mode:s,s:i.stations[Math.floor(r/2)%e],plane:r%2,sample:Math.floor(r/(2*e))}});return t[1].value>t[0].value?t[1]:t[0]}var WS=30,Bn=5;function Nd(i,e,t,n,s,r,o){let{free:a}=e,l=[0,1,2,3,4].filter(m=>!a.includes(m)),c=r.slice();for(let m=0;m<o;m+=1)for(let _ of l)c[m*Bn+_]=0;let u=c.slice(),h=new Array(o).fill(!1),d=new Float64Array(o).fill(1/0),f=Array.from({length:o},(m,_)=>_);for(let m=0;m<WS&&f.length;m+=1){let _=XS(i,t,n,s,c,f,a);for(let g=0;g<f.length;g+=1){let p=f[g],[v,T]=[0,0];for(let R=0;R<Bn;R+=1){let w=_[g*Bn+R],y=c[p*Bn+R]-=w;m===0&&(u[p*Bn+R]=y),v=Math.max(v,Math.abs(w)),T=Math.max(T,Math.abs(y))}let x=v<=1e-14+1e-12*T||v<=1e-9*T&&v>=d[p]/2;h[p]=x&&T<Math.PI,d[p]=x?-1:v}f=f.filter(g=>d[g]>=0)}for(let m=0;m<o;m+=1)h[m]||c.set(u.subarray(m*Bn,(m+1)*Bn),m*Bn);return{angles:c,found:h}}function XS(i,e,t,n,s,r,o){let[,[a,l]]=Object.entries(i.layout.samples[e].inputs),c={angles:f0(s,Bn,r),[a]:f0(n,l,r)},{residual:u,slope:h}=i.sample(e,t,c,r.length),d=o.length,[f,m]=[new Float64Array(d*d),new Float64Array(d)],_=new Float64Array(r.length*Bn);for(let g=0;g<r.length;g+=1){for(let p=0;p<d;p+=1){m[p]=u[g*Bn+o[p]];for(let v=0;v<d;v+=1)f[p*d+v]=h[g*Bn*Bn+o[v]*Bn+o[p]]}if(ic(f,m))for(let p=0;p<d;p+=1)_[g*Bn+o[p]]=m[p];else _.fill(1,g*Bn,(g+1)*Bn)}return _}function f0(i,e,t){let n=new Float64Array(t.length*e);for(let s=0;s<t.length;s+=1)for(let r=0;r<e;r+=1)n[s*e+r]=i[t[s]*e+r];return n}var Ci=17,_0=[1,0,1,0,0,1],qS=[{id:"deflection",label:"Deflection",unit:"m"},{id:"slope",label:"Slope",unit:"rad"},{id:"bending_moment",label:"Bending moment",unit:"N m"},{id:"shear_force",label:"Shear force",unit:"N"}];async function x0(i,e,t,n,s){let r=performance.now(),o=L=>({...n,progress:k=>n.progress?.(L+k/2)}),a=L=>bo(e.map,t,L),l=a("reference"),c=await s.of(l,()=>p0(i,e,l,"reference",o(0))),u=await p0(i,e,a("real"),"real",o(.5)),h=Math.min(c.run.times.length,u.run.times.length),d=(performance.now()-r)/1e3,[f,m]=[m0(i,u,h),m0(i,c,h)],_=u.run.times.subarray(0,h),g=YS(i,e,u,c,f,m,h),p=u.run.states.subarray(0,h*Ci),v=Ld(h,Pn(p,Ci,Xn(0,12)),f.acceleration,f.contact_force),T=nc(e,h),x=(L,k)=>Fd(i,u.numbers.parameters,L,k),R=x(Ks(v,21,T),yi(e.stations)),w=d0(_,R,L=>x(v,L)),y=[c,u].find(L=>L.run.status!=="finished"),M=y===c?"reference":"real robot",N=h0(_,g,w,u.numbers.end[0]),I=l.end[0];return{status:y?y.run.status:"finished",message:y?`${M}: ${y.run.message}`:u.run.message,seconds:d,times:_,series:g,...ZS(i,e,u,R,g,T),span:[e.steady[0]*I,e.steady[1]*I],facts:y?hc(N):N}}async function p0(i,e,t,n,s){let{settings:r}=e,o=Sa(ba(t.knots,t.coefficients),r.duration),a=await tc(i,{loop:`${n}.${r.method}`,parameters:t.parameters,knots:o.knots,rows:rc(o),state:$S(i,e,n,t),times:yi(e.times),settings:r},s);return{name:n,numbers:t,schedule:o,run:a}}function $S(i,e,t,n){let{angles:s,found:r}=Nd(i,e,`${t}.rest`,n.parameters,n.start,new Float64Array(5),1);if(!r[0])throw new Error(`${t}: no static equilibrium; expected a link that carries its own load: raise a stiffness or lower a load`);let o=new Float64Array(Ci);for(let a=0;a<6;a+=1){o[a]=n.start[0]*_0[a];for(let l=0;l<5;l+=1)o[a]+=e.basis.data[5*a+l]*s[l]}return o}function m0(i,e,t){let n=e.run.times.subarray(0,t),s=e.run.states.subarray(0,t*Ci),r=oc(e.schedule,n);return i.sample(`${e.name}.observe`,e.numbers.parameters,{time:n,state:s,row:r},t)}function g0(i){return Float64Array.from({length:i.length},(e,t)=>i[6*Math.floor(t/6)+5]*_0[t%6])}function y0(i){let e=i.length/Ci,t=new Float64Array(e*5);for(let n=0;n<e;n+=1){let[s,r,o,a,l,c]=i.subarray(n*Ci,n*Ci+6);t.set([s-o,r-(s-o)/2,a,l-a/2,o-c],5*n)}return t}function YS(i,e,t,n,s,r,o){let[a,l]=[t,n].map(g=>g.run.states.subarray(0,o*Ci)),[c,u,h]=[Xn(0,6),Xn(6,12),Xn(12,17)].map(g=>Pn(a,Ci,g)),d=y0(a),f=Ld(o,Pn(a,Ci,[5,11]),Pn(s.acceleration,6,[5]),s.contact_force),m=Nd(i,e,"real.quasistatic",t.numbers.parameters,f,d,o).angles,_={q:Je(c,o,6),v:Je(u,o,6),q_reference:Je(Pn(l,Ci,Xn(0,6)),o,6),v_reference:Je(Pn(l,Ci,Xn(6,12)),o,6),theta_wanted:Je(s.wanted,o),voltage:Je(s.voltage,o),current:Je(s.current,o),tip:Je(s.tip,o,3),tip_velocity:Je(s.tip_velocity,o,3),tip_reference:Je(r.tip,o,3),deviation:Je(Hi(Ma(s.tip,r.tip),3),o),deformation:Je(d,o,5),deformation_reference:Je(y0(l),o,5),deformation_stationary:Je(m,o,5),deformation_oscillatory:Je(Ma(d,m),o,5),gear_torque:Je(s.gear_torque,o),gear_torque_reference:Je(r.gear_torque,o),energy:Je(s.energy,o,4),work:Je(h,o,5),energy_balance:Je(ac(s.energy,h,o,1),o)};return e.contact?{..._,contact_force:Je(s.contact_force,o,3),contact_force_radial:Je(s.radial_force,o),contact_force_radial_reference:Je(r.radial_force,o)}:_}function ZS(i,e,t,n,s,r){let{parameters:o}=t.numbers,a=v=>Ks(s[v].data,s[v].shape.slice(1).reduce((T,x)=>T*x,1),r),l=n.stations.length,c=a("q"),u=a("q_reference"),h=Ea(n,"line"),[d,f,m]=[g0(c),u,g0(u)].map(v=>Ea(Fd(i,o,o0(v),n.stations),"line")),_=v=>({data:a(v),shape:[r.length,...s[v].shape.slice(1)]}),g={data:Float64Array.from({length:2*l},(v,T)=>e.lengths[Math.floor(T/l)]*n.stations[T%l]),shape:[2,l]},p={links:["Mode 1","Mode 2"],places:g,quantities:qS.map(v=>({...v,planes:["horizontal","vertical"],values:Ea(n,v.id)}))};return{scene:{times:{data:Ks(t.run.times,1,r),shape:[r.length]},line:h,rigid:d,reference:f,referenceRigid:m,roots:l0(c),tip:_("tip"),tipReference:_("tip_reference"),colours:a0(n,h,d),contact:e.contact?{force:_("contact_force"),at:_("tip")}:null},line:p}}async function v0(i){let e=await Ql.open(i.module.data,i.layout);if(i.kind==="arm"){let n=new Aa;return{run:(s,r)=>s0(e,i,s,r,n)}}let t=new Aa;return{run:(n,s)=>x0(e,i,n,s,t)}}function b0(i,e){let t=i.map(s=>typeof s=="object"&&"parts"in s&&JS(s.optional,e)),n=i.some((s,r)=>t[r]&&typeof s=="object"&&"optional"in s&&s.optional>=0);return i.map((s,r)=>typeof s=="string"?s:"header"in s?n?s.header:"":t[r]?s.parts.map(o=>typeof o=="string"?o:jS(o,e)).join(""):"").join("")}function JS(i,e){return i<0||e[i]!==1}function jS(i,e){let t=e[i.slider];return KS(i.base===null?t:i.base*t)}function KS(i){let[e,t]=String(i).split("e"),n=e.includes(".")?e:`${e}.0`;return t===void 0?n:`${n}e${t}`}var So=class extends Error{name="Superseded"};async function S0(i){let e=i,t=await eM(e)??await QS(e),n=s=>{if(s.length!==e.sliders.length||!s.every(Number.isFinite))throw new Error(`values: got ${s.length}; expected ${e.sliders.length} finite numbers, one of each slider`)};return{sliders:e.sliders,async run(s,r=()=>{}){return n(s),t.run(s,r)},sheet(s){return n(s),b0(e.sheet,s)},close:()=>t.close()}}async function QS(i){let e=await v0(i),t=0,n=Promise.resolve();return{async run(s,r){let o=t+=1,a=()=>o!==t,l=n.then(()=>{if(a())throw new So("a newer run began");return e.run(s,{cancelled:a,progress:r})});n=l.catch(()=>{});try{return await l}catch(c){throw c instanceof va?new So(c.message):c}},close:()=>t+=1}}async function eM(i){if(typeof Worker>"u"||typeof document>"u")return null;let e=URL.createObjectURL(new Blob([Wg],{type:"text/javascript"}));try{let t=new Worker(e);if(await tM(t,i))return nM(t);t.terminate()}catch{}finally{URL.revokeObjectURL(e)}return null}function tM(i,e){return new Promise(t=>{i.onmessage=({data:n})=>t(n.kind==="ready"),i.onerror=()=>t(!1),i.postMessage({kind:"open",bundle:e})})}function nM(i){let e=0,t=null,n=s=>{t?.reject(s),t=null};return i.onerror=s=>n(new Error(s.message)),i.onmessage=({data:s})=>{!("id"in s)||s.id!==e||!t||(s.kind==="progress"?t.progress(s.share):s.kind==="error"?n(new Error(s.message)):s.kind==="done"&&(t.resolve(s.run),t=null))},{run(s,r){return n(new So("a newer run began")),e+=1,i.postMessage({kind:"run",id:e,values:s}),new Promise((o,a)=>t={resolve:o,reject:a,progress:r})},close(){n(new So("the live model was closed")),i.terminate()}}}function M0(i,e){let t=n=>{i.replaceChildren(e.runs.length>1?rM(e,n):iM(e.runs[0].facts,n))};return t(null),{show:t}}function iM(i,e){return X("dl",{class:"facts"},...i.map(t=>{let n=e?.facts[t.id],s=X("dd",{},X("strong",{text:Zs(n?n.value:t.value,t.unit)}));n?s.append(X("span",{class:"was",text:`${sM(t,n.value)} was ${Zs(t.value,t.unit)}`})):e&&s.append(X("span",{class:"was",text:"of the original run"}));let r=(n?n.note:t.note)||"";return X("div",{"data-fact":t.id},X("dt",{text:t.name}),s,r?X("dd",{class:"note",text:r}):null)}))}function sM(i,e){if(e===null||i.value===null||i.value===0)return"";let t=100*(e-i.value)/Math.abs(i.value);return Math.abs(t)<.05?"":`${t>0?"+":"−"}${Math.abs(t)>=1e3?"1000 % and more":`${Number(Math.abs(t).toPrecision(2))} %`},`}function rM(i,e){let t=new Map;for(let o of i.runs.flatMap(a=>a.facts))t.has(o.id)||t.set(o.id,o);let n=X("tr",{},X("td",{}),...i.runs.map(o=>X("th",{scope:"col",text:o.name}))),s=[...t.values()].map(o=>X("tr",{"data-fact":o.id},X("th",{scope:"row",text:o.name}),...i.runs.map((a,l)=>{let c=a.facts.find(d=>d.id===o.id),u=l===0?e?.facts[o.id]:void 0,h=u?u.value:c?.value??null;return X("td",{class:"number",text:Zs(h,c?.unit??o.unit),title:(u??c)?.note||void 0})}))),r=X("table",{},X("thead",{},n),X("tbody",{},...s));return X("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Numbers of the runs"},r)}var A0=150,oM="The changed run's elastic line is not computed here; reset the sliders to see the original one.",w0="12px system-ui, sans-serif";function E0(i,e,t){let n=e.runs[0].line,s=e.runs[0].scene.times.data,r=[],o=!1,a=!1,l=X("div",{class:"line-grid"}),c=X("p",{class:"note"});i.append(c,l);function u(){a=!1,r.forEach(({plot:p})=>p.destroy()),l.replaceChildren(),r=n===null?[]:n.quantities.map(p=>cM(l,n,p)),n===null&&(c.textContent=oM),h()}function h(){if(n===null||a||!o)return;let p=lM(s,t.time);c.textContent=`${n.links.join(", ")}: along the links from root to tip, at ${Un(s[p],4)} s. The scales are those of the whole run.`;let v=T0(n);for(let{plot:T,quantity:x,factor:R}of r){let w=x.planes.map((y,M)=>aM(n,x.values,p,M,x.planes.length,R));T.setData([v,...w],!1)}}let d=matchMedia("(prefers-color-scheme: dark)"),f=()=>r.forEach(({plot:p})=>p.redraw());d.addEventListener("change",f);let m=new ResizeObserver(()=>r.forEach(({plot:p})=>{let v=p.root.parentElement?.clientWidth??0;v>0&&v!==p.width&&p.setSize({width:v,height:A0})}));m.observe(l);let _=new IntersectionObserver(p=>{o=p.some(v=>v.isIntersecting),o&&a?u():h()});_.observe(i);let g=t.subscribe(h);return u(),{show(p){n=p?p.line:e.runs[0].line,s=p?p.scene.times.data:e.runs[0].scene.times.data,a=!0,o&&u()},dispose(){g(),m.disconnect(),_.disconnect(),d.removeEventListener("change",f),r.forEach(({plot:p})=>p.destroy()),i.replaceChildren()}}}function T0(i){let e=i.places.shape[1],t=[],n=0;for(let s=0;s<i.links.length;s+=1){for(let r=0;r<e;r+=1)t.push(n+i.places.data[s*e+r]+(r===0&&s>0?1e-9:0));n=t[t.length-1]}return t}function aM(i,e,t,n,s,r){let o=i.links.length*i.places.shape[1],a=t*o*s;return Array.from({length:o},(l,c)=>r*e.data[a+c*s+n])}function lM(i,e){let t=0,n=i.length-1;for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return Math.abs(i[n]-e)<Math.abs(i[t]-e)?n:t}function cM(i,e,t){let[n,s]=[0,0];for(let g of t.values.data)[n,s]=[Math.min(n,g),Math.max(s,g)];let r=Hh(t.unit,Math.max(-n,s)),o=t.planes.map((g,p)=>ha("real",p,!0,1)),a=X("div",{class:"plot-area",role:"img","aria-label":`${t.label} along the links, between ${ei(n*r.factor)} and ${ei(s*r.factor)} ${r.name}`}),l=X("div",{class:"legend"},...t.planes.map((g,p)=>X("span",{class:"key"},Cl(`var(${o[p].property})`,o[p].dash),X("span",{text:g})))),c=X("h4",{text:t.label},X("span",{class:"unit",text:` [${r.name||"–"}]`}));i.append(X("figure",{class:"chart"},X("figcaption",{},c,l),a));let u=.06*(s-n)||1,h={stroke:()=>us("--grid"),width:1},d={stroke:()=>us("--quiet"),font:w0,grid:h,ticks:{...h,size:4}},f=T0(e),m=e.links.slice(1).map((g,p)=>f[(p+1)*e.places.shape[1]]);return{plot:new gn({width:Math.max(a.clientWidth,120),height:A0,legend:{show:!1},padding:[8,14,0,0],cursor:{show:!1},scales:{x:{time:!1},y:{range:[(n-u)*r.factor,(s+u)*r.factor]}},axes:[{...d,label:"along the links [m]",labelSize:18,labelFont:w0,size:30,values:(g,p)=>p.map(ei)},{...d,size:(g,p)=>16+7*Math.max(2,...(p??[]).map(v=>v.length)),values:(g,p)=>p.map(ei)}],series:[{},...o.map(g=>({stroke:()=>us(g.property),dash:g.dash,width:1.6,points:{show:!1}}))],hooks:{draw:[g=>uM(g,m)]}},[f,...o.map(()=>f.map(()=>0))],a),quantity:t,factor:r.factor}}function uM(i,e){let{ctx:t,bbox:n}=i;t.save(),t.strokeStyle=us("--quiet"),t.setLineDash([3,3]);for(let s of e){let r=i.valToPos(s,"x",!0);t.beginPath(),t.moveTo(r,n.top),t.lineTo(r,n.top+n.height),t.stroke()}t.restore()}var hM={controlled:"under control",locked:"motors held",free:"motors free"},dM=.12;function Ud(i,e,t,n){let s=e.runs[0].modes,r=[...new Set(s.map(p=>p.case))],o=null,a=dM,l=X("div",{class:"scroll",tabindex:"0",role:"region","aria-label":"Modes"}),c=jt("case"),u=X("select",{id:c},...r.map(p=>X("option",{value:p,text:hM[p]??p})));u.addEventListener("change",()=>m(u.value));let h=X("input",{type:"range",min:"0.02",max:"0.3",step:"0.01",value:String(a),id:jt("size")});h.addEventListener("input",()=>{a=Number(h.value),o&&t.showMode(o,a)});let d=yt("back to the motion",()=>f(null),{hidden:!0});function f(p){o=p,p&&n.pause(),t.showMode(p,a),d.hidden=p===null,m(u.value)}function m(p){let v=["Frequency [Hz]","Damping [%]","Lives in",""].map(x=>X(x?"th":"td",x?{scope:"col",text:x}:{})),T=s.filter(x=>x.case===p).map(x=>{let R=`Show the mode of ${Un(x.frequency)} Hz in 3D`,w=yt(x===o?"stop":"show",()=>f(x===o?null:x),{"aria-pressed":String(x===o),"aria-label":x===o?"Stop showing the mode":R});return X("tr",{},X("td",{class:"number",text:Un(x.frequency)}),X("td",{class:"number",text:Un(100*x.damping,3)}),X("td",{text:x.livesIn}),X("td",{},w))});l.replaceChildren(X("table",{},X("thead",{},X("tr",{},...v)),X("tbody",{},...T)))}let _=X("div",{class:"bar"},X("label",{for:c,text:"Modes"}),u,X("label",{for:h.id,text:"amplitude"}),h,d);i.append(_,l),m(r[0]??"");let g=n.subscribe(p=>{p.playing&&o&&f(null)});return{dispose(){g(),i.replaceChildren()}}}function R0(i,e){for(let t of e.runs){if(!t.sheet)continue;let n=e.runs.length>1?`Save the YAML of ${t.name}`:"Save the YAML of this run";i.append(yt(n,()=>Ys(t.sheet,`${Od(t.name)}.yaml`,"application/yaml"),{class:"save-yaml"}))}}function Od(i){return i.replace(/[^\p{L}\p{N}._-]+/gu,"_").replace(/^[._]+/,"").slice(0,80)||"run"}var Bd=1e3;function C0(i,e){let t=jt("slider"),n=Ar(i.unit),s=X("input",{type:"range",id:t,min:"0",max:String(Bd),step:"1"}),r=X("input",{type:"number","aria-label":`${i.label}${n?`, in ${n}`:""}`,step:"any",min:String(i.min),max:String(i.max)}),o=yt("↺",u,{class:"tool","aria-label":`${i.label}: back to ${Un(i.value,6)} ${n}`,title:"back to the run's own"}),a=i.value;function l(f=!1){s.value=String(Math.round(Bd*fM(i,a))),s.setAttribute("aria-valuetext",`${Un(a,5)} ${n}`),f||(r.value=String(Number(a.toPrecision(6)))),o.disabled=a===i.value,d.classList.toggle("changed",a!==i.value)}function c(f,m=!1){let _=Math.min(Math.max(f,i.min),i.max);if(_===a)return l(m);a=_,l(m),e()}function u(){c(i.value),s.focus()}s.addEventListener("input",()=>c(Number(Un(pM(i,Number(s.value)/Bd),4)))),r.addEventListener("input",()=>{r.value!==""&&Number.isFinite(r.valueAsNumber)&&c(r.valueAsNumber,!0)}),r.addEventListener("change",()=>l());let h=X("label",{for:t},X("span",{text:i.label}),X("i",{text:i.symbol?` ${i.symbol}`:""})),d=X("div",{class:"slider","data-path":i.path},h,X("div",{class:"slider-row"},s,r,X("span",{class:"unit",text:n}),o));return l(),{element:d,slider:i,get value(){return a},set value(f){a=f,l()}}}function fM(i,e){let{min:t,max:n}=i;return n<=t?0:i.log&&t>0?Math.log(e/t)/Math.log(n/t):(e-t)/(n-t)}function pM(i,e){let{min:t,max:n}=i;return i.log&&t>0?t*(n/t)**e:t+e*(n-t)}var mM=300;function P0(i,e,t){let n=X("p",{class:"note",role:"status","aria-live":"polite",text:"starts …"}),s=X("progress",{max:"1",value:"0",hidden:!0,"aria-label":"Progress of the simulation"}),r=yt("reset all",()=>{p(null),a[0]?.element.querySelector("input")?.focus()},{disabled:!0}),o=yt("Save YAML",()=>l&&Ys(l.sheet(m()),`${t.fileName}.yaml`,"application/yaml"),{disabled:!0}),a=e.sliders.map(x=>C0(x,g)),l=null,c=!1,u=0,h=0,d=0,f=!1,m=()=>a.map(x=>x.value),_=()=>a.every(x=>x.value===x.slider.value);function g(){r.disabled=_(),f?h||(h=requestAnimationFrame(()=>{v()})):v()}function p(x){a.forEach((R,w)=>{R.value=x?x[w]:R.slider.value}),g()}async function v(){if(h=0,!l)return;let x=u+=1;if(_()){T(),t.show(null),n.textContent="The run as it was.",n.classList.remove("warned"),l.run(m()).catch(()=>{});return}f=!0,d||(d=window.setTimeout(()=>{s.hidden=!1},mM));try{let R=await l.run(m(),y=>{x===u&&(s.value=y)});if(x!==u||c)return;t.show(R);let w=R.status==="finished"?"Simulated":`${R.status}: ${R.message}; simulated`;n.textContent=`${w} in ${Zs(R.seconds,"s")}; the run as it was is pale.`,n.classList.toggle("warned",R.status!=="finished"),T()}catch(R){if(x!==u||c||R instanceof Error&&R.name==="Superseded")return;T(),t.show(null);let w=(R instanceof Error?R.message:String(R)).replace(/\.$/,"");n.textContent=`This could not be simulated: ${w}; shown is the run as it was.`,n.classList.add("warned")}}function T(){f=!1,clearTimeout(d),d=0,s.hidden=!0,s.value=0}return i.append(X("div",{class:"bar"},X("h3",{text:"What if"}),r,o),n,s,...gM(a),...yM(e)),t.open(e).then(x=>{if(c)return x.close();l=x,o.disabled=!1,n.textContent="Move a slider: the robot is simulated anew, here in the page.",_()||g()},x=>{n.textContent=`Nothing can be changed here, the robot's equations could not be started: ${x instanceof Error?x.message:String(x)}`,a.forEach(R=>R.element.remove()),r.remove()}),{dispose(){c=!0,cancelAnimationFrame(h),T(),l?.close(),i.replaceChildren()}}}function gM(i){return[...new Set(i.map(t=>t.slider.group))].map(t=>X("fieldset",{},X("legend",{text:t}),...i.filter(n=>n.slider.group===t).map(n=>n.element)))}function yM(i){let e=i.settings,t=Array.isArray(i.leftOut)?i.leftOut:[];return[...typeof e?.note=="string"&&e.note?[e.note]:[],...t.length?[`Not offered: ${t.map(({path:s,reason:r})=>`${String(s)} (${String(r)})`).join("; ")}.`]:[]].map(s=>X("p",{class:"note",text:s}))}var _M=[.05,.1,.2,.5,1,2],fc=1e3,L0=1/200;function I0(i,e){let t=yt("",()=>e.toggle(),{class:"play"}),n=X("input",{type:"range",min:"0",max:String(fc),step:"1","aria-label":"Time",class:"scrub"}),s=X("output",{class:"time","aria-live":"off"}),r=jt("speed"),o=X("select",{id:r},..._M.map(h=>X("option",{value:String(h),text:`${h}×`,selected:h===e.speed})));n.addEventListener("input",()=>e.seek(Number(n.value)/fc*e.duration)),o.addEventListener("change",()=>{e.speed=Number(o.value)});let a=Math.max(3,Math.ceil(-Math.log10(e.duration||1))+3),l=()=>{let h=e.duration>0?e.time/e.duration:0;(document.activeElement!==n||Number(n.value)!==Math.round(h*fc))&&(n.value=String(Math.round(h*fc))),n.setAttribute("aria-valuetext",`${e.time.toFixed(a)} s`),s.textContent=`${e.time.toFixed(a)} s of ${Un(e.duration)} s`;let d=e.playing?"Pause":"Play";t.getAttribute("aria-label")!==d&&(t.setAttribute("aria-label",d),t.title=`${d} (space)`,t.textContent=e.playing?"❚❚":"▶")},c=h=>{if(h.defaultPrevented||h.ctrlKey||h.metaKey||h.altKey||xM(h))return;let f={" ":()=>e.toggle(),ArrowRight:()=>e.seek(e.time+(h.shiftKey?10:1)*L0*e.duration),ArrowLeft:()=>e.seek(e.time-(h.shiftKey?10:1)*L0*e.duration)}[h.key];f&&(h.preventDefault(),f())};document.addEventListener("keydown",c),i.append(t,n,s,X("label",{for:r,text:"speed"}),o);let u=e.subscribe(l);return l(),{dispose(){u(),document.removeEventListener("keydown",c),i.replaceChildren()}}}function xM(i){let e=i.target;return e instanceof HTMLElement?e.isContentEditable||e.closest("input, select, textarea, canvas, [role=tablist]")?!0:i.key===" "?e.closest("button, a, summary")!==null:e.closest(".scroll")!==null:!1}var fr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},pr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},uy=0,mf=1,hy=2;var Gr=1,dy=2,Zo=3,mr=0,ri=1,Fi=2,Hr=0,Jo=1,gf=2,yf=3,_f=4,fy=5;var Wr=100,py=101,my=102,gy=103,yy=104,_y=200,xy=201,vy=202,by=203,xf=204,vf=205,Sy=206,My=207,wy=208,Ay=209,Ey=210,Ty=211,Ry=212,Cy=213,Py=214,kc=0,zc=1,Vc=2,ko=3,Gc=4,Hc=5,Wc=6,Xc=7,_u=0,Ly=1,Iy=2,ys=0,bf=1,Sf=2,Mf=3,wf=4,Af=5,Ef=6,Tf=7;var Rf=300,Xr=301,jo=302,xu=303,vu=304,qc=1e3,ps=1001,$c=1002,Dn=1003,Dy=1004;var ul=1005;var si=1006,bu=1007;var ks=1008;var li=1009,Cf=1010,Pf=1011,Ko=1012,Su=1013,ji=1014,Ki=1015,Qi=1016,Mu=1017,wu=1018,qr=1020,Lf=35902,If=35899,Df=1021,Ff=1022,es=1023,Os=1026,zs=1027,Nf=1028,Au=1029,gr=1030,Eu=1031;var Tu=1033,hl=33776,dl=33777,fl=33778,pl=33779,Ru=35840,Cu=35841,Pu=35842,Lu=35843,Iu=36196,Du=37492,Fu=37496,Nu=37488,Uu=37489,ml=37490,Ou=37491,Bu=37808,ku=37809,zu=37810,Vu=37811,Gu=37812,Hu=37813,Wu=37814,Xu=37815,qu=37816,$u=37817,Yu=37818,Zu=37819,Ju=37820,ju=37821,Ku=36492,Qu=36494,eh=36495,th=36283,nh=36284,gl=36285,ih=36286;var Na=2300,Yc=2301,Oc=2302,lf=2303,cf=2400,uf=2401,hf=2402;var Fy=3200;var yl=0,Ny=1,Vs="",vi="srgb",Ua="srgb-linear",Oa="linear",Tt="srgb";var Bc=7680;var Uy=519,Oy=512,By=513,ky=514,Uf=515,zy=516,Vy=517,Of=518,Bf=519,kf=35044,zf=35048;var Vf="300 es",Li=2e3,zo=2001;function vM(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function bM(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ba(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Gy(){let i=Ba("canvas");return i.style.display="block",i}var D0={},Vo=null;function ka(...i){let e="THREE."+i.shift();Vo?Vo("log",e,...i):console.log(e,...i)}function Hy(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function $e(...i){i=Hy(i);let e="THREE."+i.shift();if(Vo)Vo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function tt(...i){i=Hy(i);let e="THREE."+i.shift();if(Vo)Vo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ia(...i){let e=i.join(" ");e in D0||(D0[e]=!0,$e(...i))}function Wy(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Xy={[kc]:kc,[Vc]:Wc,[Gc]:Gc,[ko]:Hc,[zc]:zc,[Wc]:Vc,[Xc]:Xc,[Hc]:ko},Yi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],F0=1234567,Da=Math.PI/180,Go=180/Math.PI;function yr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]).toLowerCase()}function ot(i,e,t){return Math.max(e,Math.min(t,i))}function Gf(i,e){return(i%e+e)%e}function SM(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function MM(i,e,t){return i!==e?(t-i)/(e-i):0}function Fa(i,e,t){return(1-t)*i+t*e}function wM(i,e,t,n){return Fa(i,e,1-Math.exp(-t*n))}function AM(i,e=1){return e-Math.abs(Gf(i,e*2)-e)}function EM(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function TM(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function RM(i,e){return i+Math.floor(Math.random()*(e-i+1))}function CM(i,e){return i+Math.random()*(e-i)}function PM(i){return i*(.5-Math.random())}function LM(i){i!==void 0&&(F0=i);let e=F0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function IM(i){return i*Da}function DM(i){return i*Go}function FM(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function NM(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Hf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function UM(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),m=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*d,a*c);break;case"YZY":i.set(l*d,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*d,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*f,a*c);break;case"YXY":i.set(l*f,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*f,a*u,a*c);break;default:$e("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function sh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Wf(i,e){if(e.constructor===Float32Array)return i;let t=sh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Xf(i,e){if(e.constructor===Float32Array)return i;let t=sh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var ts={DEG2RAD:Da,RAD2DEG:Go,generateUUID:yr,clamp:ot,euclideanModulo:Gf,mapLinear:SM,inverseLerp:MM,lerp:Fa,damp:wM,pingpong:AM,smoothstep:EM,smootherstep:TM,randInt:RM,randFloat:CM,randFloatSpread:PM,seededRandom:LM,degToRad:IM,radToDeg:DM,isPowerOfTwo:FM,ceilPowerOfTwo:NM,floorPowerOfTwo:Hf,setQuaternionFromProperEuler:UM,normalize:Xf,denormalize:Wf},Ze=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ot(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Fn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],d=r[o+0],f=r[o+1],m=r[o+2],_=r[o+3];if(h!==_||l!==d||c!==f||u!==m){let g=l*d+c*f+u*m+h*_;g<0&&(d=-d,f=-f,m=-m,_=-_,g=-g);let p=1-a;if(g<.9995){let v=Math.acos(g),T=Math.sin(v);p=Math.sin(p*v)/T,a=Math.sin(a*v)/T,l=l*p+d*a,c=c*p+f*a,u=u*p+m*a,h=h*p+_*a}else{l=l*p+d*a,c=c*p+f*a,u=u*p+m*a,h=h*p+_*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return e[t]=a*m+u*h+l*f-c*d,e[t+1]=l*m+u*d+c*h-a*f,e[t+2]=c*m+u*f+a*d-l*h,e[t+3]=u*m-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),d=l(n/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"YXZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"ZXY":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"ZYX":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"YZX":this._x=d*u*h+c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h-d*f*m;break;case"XZY":this._x=d*u*h-c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h+d*f*m;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=n+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>h){let f=2*Math.sqrt(1+n-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-n-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ot(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(N0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(N0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this.z=ot(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this.z=ot(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return kd.copy(this).projectOnVector(e),this.sub(kd)}reflect(e){return this.sub(kd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ot(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},kd=new B,N0=new Fn,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],d=n[2],f=n[5],m=n[8],_=s[0],g=s[3],p=s[6],v=s[1],T=s[4],x=s[7],R=s[2],w=s[5],y=s[8];return r[0]=o*_+a*v+l*R,r[3]=o*g+a*T+l*w,r[6]=o*p+a*x+l*y,r[1]=c*_+u*v+h*R,r[4]=c*g+u*T+h*w,r[7]=c*p+u*x+h*y,r[2]=d*_+f*v+m*R,r[5]=d*g+f*T+m*w,r[8]=d*p+f*x+m*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,m=t*h+n*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return e[0]=h*_,e[1]=(s*c-u*n)*_,e[2]=(a*n-s*o)*_,e[3]=d*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=f*_,e[7]=(n*l-c*t)*_,e[8]=(o*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ia("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(zd.makeScale(e,t)),this}rotate(e){return Ia("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(zd.makeRotation(-e)),this}translate(e,t){return Ia("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(zd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},zd=new nt,U0=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),O0=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function OM(){let i={enabled:!0,workingColorSpace:Ua,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Tt&&(s.r=Us(s.r),s.g=Us(s.g),s.b=Us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Tt&&(s.r=Bo(s.r),s.g=Bo(s.g),s.b=Bo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Vs?Oa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ua]:{primaries:e,whitePoint:n,transfer:Oa,toXYZ:U0,fromXYZ:O0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:vi},outputColorSpaceConfig:{drawingBufferColorSpace:vi}},[vi]:{primaries:e,whitePoint:n,transfer:Tt,toXYZ:U0,fromXYZ:O0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:vi}}}),i}var xt=OM();function Us(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Bo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Mo,Zc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Mo===void 0&&(Mo=Ba("canvas")),Mo.width=e.width,Mo.height=e.height;let s=Mo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Mo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ba("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Us(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Us(t[n]/255)*255):t[n]=Us(t[n]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},BM=0,Ho=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:BM++}),this.uuid=yr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Vd(s[o].image)):r.push(Vd(s[o]))}else r=Vd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Vd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Zc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var kM=0,Gd=new B,ai=class i extends Yi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ps,s=ps,r=si,o=ks,a=es,l=li,c=i.DEFAULT_ANISOTROPY,u=Vs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:kM++}),this.uuid=yr(),this.name="",this.source=new Ho(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ze(0,0),this.repeat=new Ze(1,1),this.center=new Ze(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Gd).x}get height(){return this.source.getSize(Gd).y}get depth(){return this.source.getSize(Gd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Rf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case qc:e.x=e.x-Math.floor(e.x);break;case ps:e.x=e.x<0?0:1;break;case $c:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case qc:e.y=e.y-Math.floor(e.y);break;case ps:e.y=e.y<0?0:1;break;case $c:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ai.DEFAULT_IMAGE=null;ai.DEFAULT_MAPPING=Rf;ai.DEFAULT_ANISOTROPY=1;var Rt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],m=l[9],_=l[2],g=l[6],p=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-_)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+_)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,x=(f+1)/2,R=(p+1)/2,w=(u+d)/4,y=(h+_)/4,M=(m+g)/4;return T>x&&T>R?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=w/n,r=y/n):x>R?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=w/s,r=M/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=y/r,s=M/r),this.set(n,s,r,t),this}let v=Math.sqrt((g-m)*(g-m)+(h-_)*(h-_)+(d-u)*(d-u));return Math.abs(v)<.001&&(v=1),this.x=(g-m)/v,this.y=(h-_)/v,this.z=(d-u)/v,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this.z=ot(this.z,e.z,t.z),this.w=ot(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this.z=ot(this.z,e,t),this.w=ot(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Jc=class extends Yi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:si,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Rt(0,0,e,t),this.scissorTest=!1,this.viewport=new Rt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ai({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:si,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Ho(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Si=class extends Jc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},za=class extends ai{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var jc=class extends ai{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ot=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,u,h,d,f,m,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,d,f,m,_,g)}set(e,t,n,s,r,o,a,l,c,u,h,d,f,m,_,g){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=d,p[3]=f,p[7]=m,p[11]=_,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/wo.setFromMatrixColumn(e,0).length(),r=1/wo.setFromMatrixColumn(e,1).length(),o=1/wo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,m=a*u,_=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+m*c,t[5]=d-_*c,t[9]=-a*l,t[2]=_-d*c,t[6]=m+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,m=c*u,_=c*h;t[0]=d+_*a,t[4]=m*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-m,t[6]=_+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,m=c*u,_=c*h;t[0]=d-_*a,t[4]=-o*h,t[8]=m+f*a,t[1]=f+m*a,t[5]=o*u,t[9]=_-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,m=a*u,_=a*h;t[0]=l*u,t[4]=m*c-f,t[8]=d*c+_,t[1]=l*h,t[5]=_*c+d,t[9]=f*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,m=a*l,_=a*c;t[0]=l*u,t[4]=_-d*h,t[8]=m*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+m,t[10]=d-_*h}else if(e.order==="XZY"){let d=o*l,f=o*c,m=a*l,_=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+_,t[5]=o*u,t[9]=f*h-m,t[2]=m*h-f,t[6]=a*u,t[10]=_*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(zM,e,VM)}lookAt(e,t,n){let s=this.elements;return _i.subVectors(e,t),_i.lengthSq()===0&&(_i.z=1),_i.normalize(),er.crossVectors(n,_i),er.lengthSq()===0&&(Math.abs(n.z)===1?_i.x+=1e-4:_i.z+=1e-4,_i.normalize(),er.crossVectors(n,_i)),er.normalize(),pc.crossVectors(_i,er),s[0]=er.x,s[4]=pc.x,s[8]=_i.x,s[1]=er.y,s[5]=pc.y,s[9]=_i.y,s[2]=er.z,s[6]=pc.z,s[10]=_i.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],d=n[9],f=n[13],m=n[2],_=n[6],g=n[10],p=n[14],v=n[3],T=n[7],x=n[11],R=n[15],w=s[0],y=s[4],M=s[8],N=s[12],I=s[1],L=s[5],k=s[9],V=s[13],D=s[2],H=s[6],$=s[10],G=s[14],le=s[3],Y=s[7],K=s[11],te=s[15];return r[0]=o*w+a*I+l*D+c*le,r[4]=o*y+a*L+l*H+c*Y,r[8]=o*M+a*k+l*$+c*K,r[12]=o*N+a*V+l*G+c*te,r[1]=u*w+h*I+d*D+f*le,r[5]=u*y+h*L+d*H+f*Y,r[9]=u*M+h*k+d*$+f*K,r[13]=u*N+h*V+d*G+f*te,r[2]=m*w+_*I+g*D+p*le,r[6]=m*y+_*L+g*H+p*Y,r[10]=m*M+_*k+g*$+p*K,r[14]=m*N+_*V+g*G+p*te,r[3]=v*w+T*I+x*D+R*le,r[7]=v*y+T*L+x*H+R*Y,r[11]=v*M+T*k+x*$+R*K,r[15]=v*N+T*V+x*G+R*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],m=e[3],_=e[7],g=e[11],p=e[15],v=l*f-c*d,T=a*f-c*h,x=a*d-l*h,R=o*f-c*u,w=o*d-l*u,y=o*h-a*u;return t*(_*v-g*T+p*x)-n*(m*v-g*R+p*w)+s*(m*T-_*R+p*y)-r*(m*x-_*w+g*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],m=e[12],_=e[13],g=e[14],p=e[15],v=t*a-n*o,T=t*l-s*o,x=t*c-r*o,R=n*l-s*a,w=n*c-r*a,y=s*c-r*l,M=u*_-h*m,N=u*g-d*m,I=u*p-f*m,L=h*g-d*_,k=h*p-f*_,V=d*p-f*g,D=v*V-T*k+x*L+R*I-w*N+y*M;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/D;return e[0]=(a*V-l*k+c*L)*H,e[1]=(s*k-n*V-r*L)*H,e[2]=(_*y-g*w+p*R)*H,e[3]=(d*w-h*y-f*R)*H,e[4]=(l*I-o*V-c*N)*H,e[5]=(t*V-s*I+r*N)*H,e[6]=(g*x-m*y-p*T)*H,e[7]=(u*y-d*x+f*T)*H,e[8]=(o*k-a*I+c*M)*H,e[9]=(n*I-t*k-r*M)*H,e[10]=(m*w-_*x+p*v)*H,e[11]=(h*x-u*w-f*v)*H,e[12]=(a*N-o*L-l*M)*H,e[13]=(t*L-n*N+s*M)*H,e[14]=(_*T-m*R-g*v)*H,e[15]=(u*R-h*T+d*v)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,m=r*h,_=o*u,g=o*h,p=a*h,v=l*c,T=l*u,x=l*h,R=n.x,w=n.y,y=n.z;return s[0]=(1-(_+p))*R,s[1]=(f+x)*R,s[2]=(m-T)*R,s[3]=0,s[4]=(f-x)*w,s[5]=(1-(d+p))*w,s[6]=(g+v)*w,s[7]=0,s[8]=(m+T)*y,s[9]=(g-v)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=wo.set(s[0],s[1],s[2]).length(),a=wo.set(s[4],s[5],s[6]).length(),l=wo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Xi.copy(this);let c=1/o,u=1/a,h=1/l;return Xi.elements[0]*=c,Xi.elements[1]*=c,Xi.elements[2]*=c,Xi.elements[4]*=u,Xi.elements[5]*=u,Xi.elements[6]*=u,Xi.elements[8]*=h,Xi.elements[9]*=h,Xi.elements[10]*=h,t.setFromRotationMatrix(Xi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Li,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===Li)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===zo)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Li,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===Li)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===zo)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},wo=new B,Xi=new Ot,zM=new B(0,0,0),VM=new B(1,1,1),er=new B,pc=new B,_i=new B,B0=new Ot,k0=new Fn,ms=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ot(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ot(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ot(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ot(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ot(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ot(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return B0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(B0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return k0.setFromEuler(this),this.setFromQuaternion(k0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ms.DEFAULT_ORDER="XYZ";var Va=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},GM=0,z0=new B,Ao=new Fn,Ls=new Ot,mc=new B,Ta=new B,HM=new B,WM=new Fn,V0=new B(1,0,0),G0=new B(0,1,0),H0=new B(0,0,1),W0={type:"added"},XM={type:"removed"},Eo={type:"childadded",child:null},Hd={type:"childremoved",child:null},kn=class i extends Yi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:GM++}),this.uuid=yr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new B,t=new ms,n=new Fn,s=new B(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ot},normalMatrix:{value:new nt}}),this.matrix=new Ot,this.matrixWorld=new Ot,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Va,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ao.setFromAxisAngle(e,t),this.quaternion.multiply(Ao),this}rotateOnWorldAxis(e,t){return Ao.setFromAxisAngle(e,t),this.quaternion.premultiply(Ao),this}rotateX(e){return this.rotateOnAxis(V0,e)}rotateY(e){return this.rotateOnAxis(G0,e)}rotateZ(e){return this.rotateOnAxis(H0,e)}translateOnAxis(e,t){return z0.copy(e).applyQuaternion(this.quaternion),this.position.add(z0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(V0,e)}translateY(e){return this.translateOnAxis(G0,e)}translateZ(e){return this.translateOnAxis(H0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ls.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?mc.copy(e):mc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ta.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ls.lookAt(Ta,mc,this.up):Ls.lookAt(mc,Ta,this.up),this.quaternion.setFromRotationMatrix(Ls),s&&(Ls.extractRotation(s.matrixWorld),Ao.setFromRotationMatrix(Ls),this.quaternion.premultiply(Ao.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(W0),Eo.child=e,this.dispatchEvent(Eo),Eo.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(XM),Hd.child=e,this.dispatchEvent(Hd),Hd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ls.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ls.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ls),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(W0),Eo.child=e,this.dispatchEvent(Eo),Eo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ta,e,HM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ta,WM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),m=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};kn.DEFAULT_UP=new B(0,1,0);kn.DEFAULT_MATRIX_AUTO_UPDATE=!0;kn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var In=class extends kn{constructor(){super(),this.isGroup=!0,this.type="Group"}},qM={type:"move"},Wo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new In,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new In,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new In,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let g=t.getJointPose(_,n),p=this._getHandJoint(c,_);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(qM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new In;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},qy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},tr={h:0,s:0,l:0},gc={h:0,s:0,l:0};function Wd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var at=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=vi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=n,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=xt.workingColorSpace){if(e=Gf(e,1),t=ot(t,0,1),n=ot(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Wd(o,r,e+1/3),this.g=Wd(o,r,e),this.b=Wd(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=vi){function n(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=vi){let n=qy[e.toLowerCase()];return n!==void 0?this.setHex(n,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Us(e.r),this.g=Us(e.g),this.b=Us(e.b),this}copyLinearToSRGB(e){return this.r=Bo(e.r),this.g=Bo(e.g),this.b=Bo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=vi){return xt.workingToColorSpace($n.copy(this),e),Math.round(ot($n.r*255,0,255))*65536+Math.round(ot($n.g*255,0,255))*256+Math.round(ot($n.b*255,0,255))}getHexString(e=vi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace($n.copy(this),t);let n=$n.r,s=$n.g,r=$n.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace($n.copy(this),t),e.r=$n.r,e.g=$n.g,e.b=$n.b,e}getStyle(e=vi){xt.workingToColorSpace($n.copy(this),e);let t=$n.r,n=$n.g,s=$n.b;return e!==vi?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(tr),this.setHSL(tr.h+e,tr.s+t,tr.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(tr),e.getHSL(gc);let n=Fa(tr.h,gc.h,t),s=Fa(tr.s,gc.s,t),r=Fa(tr.l,gc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},$n=new at;at.NAMES=qy;var Ga=class extends kn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ms,this.environmentIntensity=1,this.environmentRotation=new ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},qi=new B,Is=new B,Xd=new B,Ds=new B,To=new B,Ro=new B,X0=new B,qd=new B,$d=new B,Yd=new B,Zd=new Rt,Jd=new Rt,jd=new Rt,rr=class i{constructor(e=new B,t=new B,n=new B){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),qi.subVectors(e,t),s.cross(qi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){qi.subVectors(s,t),Is.subVectors(n,t),Xd.subVectors(e,t);let o=qi.dot(qi),a=qi.dot(Is),l=qi.dot(Xd),c=Is.dot(Is),u=Is.dot(Xd),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,m=(o*u-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ds)===null?!1:Ds.x>=0&&Ds.y>=0&&Ds.x+Ds.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ds.x),l.addScaledVector(o,Ds.y),l.addScaledVector(a,Ds.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Zd.setScalar(0),Jd.setScalar(0),jd.setScalar(0),Zd.fromBufferAttribute(e,t),Jd.fromBufferAttribute(e,n),jd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Zd,r.x),o.addScaledVector(Jd,r.y),o.addScaledVector(jd,r.z),o}static isFrontFacing(e,t,n,s){return qi.subVectors(n,t),Is.subVectors(e,t),qi.cross(Is).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return qi.subVectors(this.c,this.b),Is.subVectors(this.a,this.b),qi.cross(Is).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;To.subVectors(s,n),Ro.subVectors(r,n),qd.subVectors(e,n);let l=To.dot(qd),c=Ro.dot(qd);if(l<=0&&c<=0)return t.copy(n);$d.subVectors(e,s);let u=To.dot($d),h=Ro.dot($d);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(To,o);Yd.subVectors(e,r);let f=To.dot(Yd),m=Ro.dot(Yd);if(m>=0&&f<=m)return t.copy(r);let _=f*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(n).addScaledVector(Ro,a);let g=u*m-f*h;if(g<=0&&h-u>=0&&f-m>=0)return X0.subVectors(r,s),a=(h-u)/(h-u+(f-m)),t.copy(s).addScaledVector(X0,a);let p=1/(g+_+d);return o=_*p,a=d*p,t.copy(n).addScaledVector(To,o).addScaledVector(Ro,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},zn=class{constructor(e=new B(1/0,1/0,1/0),t=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint($i.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint($i.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=$i.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,$i):$i.fromBufferAttribute(r,o),$i.applyMatrix4(e.matrixWorld),this.expandByPoint($i);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),yc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),yc.copy(n.boundingBox)),yc.applyMatrix4(e.matrixWorld),this.union(yc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$i),$i.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ra),_c.subVectors(this.max,Ra),Co.subVectors(e.a,Ra),Po.subVectors(e.b,Ra),Lo.subVectors(e.c,Ra),nr.subVectors(Po,Co),ir.subVectors(Lo,Po),Fr.subVectors(Co,Lo);let t=[0,-nr.z,nr.y,0,-ir.z,ir.y,0,-Fr.z,Fr.y,nr.z,0,-nr.x,ir.z,0,-ir.x,Fr.z,0,-Fr.x,-nr.y,nr.x,0,-ir.y,ir.x,0,-Fr.y,Fr.x,0];return!Kd(t,Co,Po,Lo,_c)||(t=[1,0,0,0,1,0,0,0,1],!Kd(t,Co,Po,Lo,_c))?!1:(xc.crossVectors(nr,ir),t=[xc.x,xc.y,xc.z],Kd(t,Co,Po,Lo,_c))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$i).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($i).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Fs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Fs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Fs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Fs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Fs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Fs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Fs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Fs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Fs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Fs=[new B,new B,new B,new B,new B,new B,new B,new B],$i=new B,yc=new zn,Co=new B,Po=new B,Lo=new B,nr=new B,ir=new B,Fr=new B,Ra=new B,_c=new B,xc=new B,Nr=new B;function Kd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Nr.fromArray(i,r);let a=s.x*Math.abs(Nr.x)+s.y*Math.abs(Nr.y)+s.z*Math.abs(Nr.z),l=e.dot(Nr),c=t.dot(Nr),u=n.dot(Nr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var yn=new B,vc=new Ze,$M=0,rn=class extends Yi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:$M++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=kf,this.updateRanges=[],this.gpuType=Ki,this.version=0,this._normalizationScale=e!==void 0?sh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)vc.fromBufferAttribute(this,t),vc.applyMatrix3(e),this.setXY(t,vc.x,vc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix3(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix4(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyNormalMatrix(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.transformDirection(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Wf(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Xf(e,this.array)}};var Ha=class extends rn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Wa=class extends rn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Bt=class extends rn{constructor(e,t,n){super(new Float32Array(e),t,n)}},YM=new zn,Ca=new B,Qd=new B,Zi=class{constructor(e=new B,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):YM.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ca.subVectors(e,this.center);let t=Ca.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Ca,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Qd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ca.copy(e.center).add(Qd)),this.expandByPoint(Ca.copy(e.center).sub(Qd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},ZM=0,Pi=new Ot,ef=new kn,Io=new B,xi=new zn,Pa=new zn,Ln=new B,on=class i extends Yi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ZM++}),this.uuid=yr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(vM(e)?Wa:Ha)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new nt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Pi.makeRotationFromQuaternion(e),this.applyMatrix4(Pi),this}rotateX(e){return Pi.makeRotationX(e),this.applyMatrix4(Pi),this}rotateY(e){return Pi.makeRotationY(e),this.applyMatrix4(Pi),this}rotateZ(e){return Pi.makeRotationZ(e),this.applyMatrix4(Pi),this}translate(e,t,n){return Pi.makeTranslation(e,t,n),this.applyMatrix4(Pi),this}scale(e,t,n){return Pi.makeScale(e,t,n),this.applyMatrix4(Pi),this}lookAt(e){return ef.lookAt(e),ef.updateMatrix(),this.applyMatrix4(ef.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Io).negate(),this.translate(Io.x,Io.y,Io.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Bt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];xi.setFromBufferAttribute(r),this.morphTargetsRelative?(Ln.addVectors(this.boundingBox.min,xi.min),this.boundingBox.expandByPoint(Ln),Ln.addVectors(this.boundingBox.max,xi.max),this.boundingBox.expandByPoint(Ln)):(this.boundingBox.expandByPoint(xi.min),this.boundingBox.expandByPoint(xi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Zi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(e){let n=this.boundingSphere.center;if(xi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Pa.setFromBufferAttribute(a),this.morphTargetsRelative?(Ln.addVectors(xi.min,Pa.min),xi.expandByPoint(Ln),Ln.addVectors(xi.max,Pa.max),xi.expandByPoint(Ln)):(xi.expandByPoint(Pa.min),xi.expandByPoint(Pa.max))}xi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Ln.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Ln));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Ln.fromBufferAttribute(a,c),l&&(Io.fromBufferAttribute(e,c),Ln.add(Io)),s=Math.max(s,n.distanceToSquared(Ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new rn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let N=0;N<n.count;N++)a[N]=new B,l[N]=new B;let u=new B,h=new B,d=new B,f=new Ze,m=new Ze,_=new Ze,g=new B,p=new B;function v(N,I,L){c[N]=c[I]=c[L]=1,u.fromBufferAttribute(n,N),h.fromBufferAttribute(n,I),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,N),m.fromBufferAttribute(r,I),_.fromBufferAttribute(r,L),h.sub(u),d.sub(u),m.sub(f),_.sub(f);let k=1/(m.x*_.y-_.x*m.y);isFinite(k)&&(g.copy(h).multiplyScalar(_.y).addScaledVector(d,-m.y).multiplyScalar(k),p.copy(d).multiplyScalar(m.x).addScaledVector(h,-_.x).multiplyScalar(k),a[N].add(g),a[I].add(g),a[L].add(g),l[N].add(p),l[I].add(p),l[L].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let N=0,I=T.length;N<I;++N){let L=T[N],k=L.start,V=L.count;for(let D=k,H=k+V;D<H;D+=3)v(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let x=new B,R=new B,w=new B,y=new B;function M(N){w.fromBufferAttribute(s,N),y.copy(w);let I=a[N];x.copy(I),x.sub(w.multiplyScalar(w.dot(I))).normalize(),R.crossVectors(y,I);let k=R.dot(l[N])<0?-1:1;o.setXYZW(N,x.x,x.y,x.z,k)}for(let N=0,I=n.count;N<I;++N)c[N]&&M(N);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new rn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,u=new B,h=new B;if(e)for(let d=0,f=e.count;d<f;d+=3){let m=e.getX(d+0),_=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Ln.fromBufferAttribute(e,t),Ln.normalize(),e.setXYZ(t,Ln.x,Ln.y,Ln.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,m=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*u;for(let p=0;p<u;p++)d[m++]=c[f++]}return new rn(d,u,h)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Xa=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=kf,this.updateRanges=[],this.version=0,this.uuid=yr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=q0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=q0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function q0(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=yr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var ni=new B,Ii=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?sh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)ni.fromBufferAttribute(this,t),ni.applyMatrix4(e),this.setXYZ(t,ni.x,ni.y,ni.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ni.fromBufferAttribute(this,t),ni.applyNormalMatrix(e),this.setXYZ(t,ni.x,ni.y,ni.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ni.fromBufferAttribute(this,t),ni.transformDirection(e),this.setXYZ(t,ni.x,ni.y,ni.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){ka("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new rn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){ka("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Wf(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Xf(e,this.data.array)}},tf=new B,JM=new B,jM=new nt,bi=class{constructor(e=new B(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=tf.subVectors(n,t).cross(JM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(tf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||jM.getNormalMatrix(e),s=this.coplanarPoint(tf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},KM=0,Ji=class extends Yi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:KM++}),this.uuid=yr(),this.name="",this.type="Material",this.blending=Jo,this.side=mr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=xf,this.blendDst=vf,this.blendEquation=Wr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=ko,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Uy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Bc,this.stencilZFail=Bc,this.stencilZPass=Bc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new at().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new bi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ze().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ze().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ns=new B,nf=new B,bc=new B,Sc=new B,Br=class{constructor(e=new B,t=new B(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ns)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ns.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ns.copy(this.origin).addScaledVector(this.direction,t),Ns.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){nf.copy(e).add(t).multiplyScalar(.5),bc.copy(t).sub(e).normalize(),Sc.copy(this.origin).sub(nf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(bc),a=Sc.dot(this.direction),l=-Sc.dot(bc),c=Sc.lengthSq(),u=Math.abs(1-o*o),h,d,f,m;if(u>0)if(h=o*l-a,d=o*a-l,m=r*u,h>=0)if(d>=-m)if(d<=m){let _=1/u;h*=_,d*=_,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-m?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=m?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(nf).addScaledVector(bc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Ns.subVectors(e.center,this.origin);let n=Ns.dot(this.direction),s=Ns.dot(Ns)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ns)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,m=t.x-o.x,_=t.y-o.y,g=t.z-o.z,p=n.x-o.x,v=n.y-o.y,T=n.z-o.z,x=Math.abs(l),R=Math.abs(c),w=Math.abs(u),y,M,N,I,L,k,V,D,H,$,G,le;if(x>=R&&x>=w?(N=l,k=h,H=m,le=p,l>=0?(y=c,M=u,I=d,L=f,V=_,D=g,$=v,G=T):(y=u,M=c,I=f,L=d,V=g,D=_,$=T,G=v)):R>=w?(N=c,k=d,H=_,le=v,c>=0?(y=u,M=l,I=f,L=h,V=g,D=m,$=T,G=p):(y=l,M=u,I=h,L=f,V=m,D=g,$=p,G=T)):(N=u,k=f,H=g,le=T,u>=0?(y=l,M=c,I=h,L=d,V=m,D=_,$=p,G=v):(y=c,M=l,I=d,L=h,V=_,D=m,$=v,G=p)),N===0)return null;let Y=y/N,K=M/N,te=1/N,fe=I-Y*k,ue=L-K*k,Q=V-Y*H,_e=D-K*H,re=$-Y*le,me=G-K*le,pe=re*_e-me*Q,Oe=fe*me-ue*re,Xe=Q*ue-_e*fe;if(s){if(pe<0||Oe<0||Xe<0)return null}else if((pe<0||Oe<0||Xe<0)&&(pe>0||Oe>0||Xe>0))return null;let Ge=pe+Oe+Xe;if(Ge===0)return null;let dt=te*(pe*k+Oe*H+Xe*le);return(Ge>0?dt<0:dt>0)?null:this.at(dt/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Xo=class extends Ji{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.combine=_u,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},$0=new Ot,Ur=new Br,Mc=new Zi,Y0=new B,wc=new B,Ac=new B,Ec=new B,sf=new B,Tc=new B,Z0=new B,Rc=new B,kt=class extends kn{constructor(e=new on,t=new Xo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Tc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(sf.fromBufferAttribute(h,e),o?Tc.addScaledVector(sf,u):Tc.addScaledVector(sf.sub(t),u))}t.add(Tc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Mc.copy(n.boundingSphere),Mc.applyMatrix4(r),Ur.copy(e.ray).recast(e.near),!(Mc.containsPoint(Ur.origin)===!1&&(Ur.intersectSphere(Mc,Y0)===null||Ur.origin.distanceToSquared(Y0)>(e.far-e.near)**2))&&($0.copy(r).invert(),Ur.copy(e.ray).applyMatrix4($0),!(n.boundingBox!==null&&Ur.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ur)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=d.length;m<_;m++){let g=d[m],p=o[g.materialIndex],v=Math.max(g.start,f.start),T=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let x=v,R=T;x<R;x+=3){let w=a.getX(x),y=a.getX(x+1),M=a.getX(x+2);s=Cc(this,p,e,n,c,u,h,w,y,M),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let g=m,p=_;g<p;g+=3){let v=a.getX(g),T=a.getX(g+1),x=a.getX(g+2);s=Cc(this,o,e,n,c,u,h,v,T,x),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=d.length;m<_;m++){let g=d[m],p=o[g.materialIndex],v=Math.max(g.start,f.start),T=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let x=v,R=T;x<R;x+=3){let w=x,y=x+1,M=x+2;s=Cc(this,p,e,n,c,u,h,w,y,M),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let g=m,p=_;g<p;g+=3){let v=g,T=g+1,x=g+2;s=Cc(this,o,e,n,c,u,h,v,T,x),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function QM(i,e,t,n,s,r,o,a){let l;if(e.side===ri?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===mr,a),l===null)return null;Rc.copy(a),Rc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Rc);return c<t.near||c>t.far?null:{distance:c,point:Rc.clone(),object:i}}function Cc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,wc),i.getVertexPosition(l,Ac),i.getVertexPosition(c,Ec);let u=QM(i,e,t,n,wc,Ac,Ec,Z0);if(u){let h=new B;rr.getBarycoord(Z0,wc,Ac,Ec,h),s&&(u.uv=rr.getInterpolatedAttribute(s,a,l,c,h,new Ze)),r&&(u.uv1=rr.getInterpolatedAttribute(r,a,l,c,h,new Ze)),o&&(u.normal=rr.getInterpolatedAttribute(o,a,l,c,h,new B),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new B,materialIndex:0};rr.getNormal(wc,Ac,Ec,d.normal),u.face=d,u.barycoord=h}return u}var Kc=class extends ai{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Dn,u=Dn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Or=new Zi,ew=new Ze(.5,.5),Pc=new B,or=class{constructor(e=new bi,t=new bi,n=new bi,s=new bi,r=new bi,o=new bi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Li,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],m=r[8],_=r[9],g=r[10],p=r[11],v=r[12],T=r[13],x=r[14],R=r[15];if(s[0].setComponents(c-o,f-u,p-m,R-v).normalize(),s[1].setComponents(c+o,f+u,p+m,R+v).normalize(),s[2].setComponents(c+a,f+h,p+_,R+T).normalize(),s[3].setComponents(c-a,f-h,p-_,R-T).normalize(),n)s[4].setComponents(l,d,g,x).normalize(),s[5].setComponents(c-l,f-d,p-g,R-x).normalize();else if(s[4].setComponents(c-l,f-d,p-g,R-x).normalize(),t===Li)s[5].setComponents(c+l,f+d,p+g,R+x).normalize();else if(t===zo)s[5].setComponents(l,d,g,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Or.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Or.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Or)}intersectsSprite(e){Or.center.set(0,0,0);let t=ew.distanceTo(e.center);return Or.radius=.7071067811865476+t,Or.applyMatrix4(e.matrixWorld),this.intersectsSphere(Or)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Pc.x=s.normal.x>0?e.max.x:e.min.x,Pc.y=s.normal.y>0?e.max.y:e.min.y,Pc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Pc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},J0=new Ot,Qc=class i{constructor(){this.coordinateSystem=Li,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];J0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new or),n[s].setFromProjectionMatrix(J0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new or),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var qo=class extends Ji{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},eu=new B,tu=new B,j0=new Ot,La=new Br,Lc=new Zi,rf=new B,K0=new B,$o=class extends kn{constructor(e=new on,t=new qo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)eu.fromBufferAttribute(t,s-1),tu.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=eu.distanceTo(tu);e.setAttribute("lineDistance",new Bt(n,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Lc.copy(n.boundingSphere),Lc.applyMatrix4(s),Lc.radius+=r,e.ray.intersectsSphere(Lc)===!1)return;j0.copy(s).invert(),La.copy(e.ray).applyMatrix4(j0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,d=n.attributes.position;if(u!==null){let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let _=f,g=m-1;_<g;_+=c){let p=u.getX(_),v=u.getX(_+1),T=Ic(this,e,La,l,p,v,_);T&&t.push(T)}if(this.isLineLoop){let _=u.getX(m-1),g=u.getX(f),p=Ic(this,e,La,l,_,g,m-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let _=f,g=m-1;_<g;_+=c){let p=Ic(this,e,La,l,_,_+1,_);p&&t.push(p)}if(this.isLineLoop){let _=Ic(this,e,La,l,m-1,f,m-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ic(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(eu.fromBufferAttribute(a,s),tu.fromBufferAttribute(a,r),t.distanceSqToSegment(eu,tu,rf,K0)>n)return;rf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(rf);if(!(c<e.near||c>e.far))return{distance:c,point:K0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Q0=new B,ey=new B,nu=class extends $o{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Q0.fromBufferAttribute(t,s),ey.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Q0.distanceTo(ey);e.setAttribute("lineDistance",new Bt(n,1))}else $e("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var qa=class extends ai{constructor(e=[],t=Xr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Bs=class extends ai{constructor(e,t,n=ji,s,r,o,a=Dn,l=Dn,c,u=Os,h=1){if(u!==Os&&u!==zs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ho(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},$a=class extends Bs{constructor(e,t=ji,n=Xr,s,r,o=Dn,a=Dn,l,c=Os){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ya=class extends ai{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ar=class i extends on{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;m("z","y","x",-1,-1,n,t,e,o,r,0),m("z","y","x",1,-1,n,t,-e,o,r,1),m("x","z","y",1,1,e,n,t,s,o,2),m("x","z","y",1,-1,e,n,-t,s,o,3),m("x","y","z",1,-1,e,t,n,s,r,4),m("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Bt(c,3)),this.setAttribute("normal",new Bt(u,3)),this.setAttribute("uv",new Bt(h,2));function m(_,g,p,v,T,x,R,w,y,M,N){let I=x/y,L=R/M,k=x/2,V=R/2,D=w/2,H=y+1,$=M+1,G=0,le=0,Y=new B;for(let K=0;K<$;K++){let te=K*L-V;for(let fe=0;fe<H;fe++){let ue=fe*I-k;Y[_]=ue*v,Y[g]=te*T,Y[p]=D,c.push(Y.x,Y.y,Y.z),Y[_]=0,Y[g]=0,Y[p]=w>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(fe/y),h.push(1-K/M),G+=1}}for(let K=0;K<M;K++)for(let te=0;te<y;te++){let fe=d+te+H*K,ue=d+te+H*(K+1),Q=d+(te+1)+H*(K+1),_e=d+(te+1)+H*K;l.push(fe,ue,_e),l.push(ue,Q,_e),le+=6}a.addGroup(f,le,N),f+=le,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var gs=class i extends on{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],m=0,_=[],g=n/2,p=0;v(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Bt(h,3)),this.setAttribute("normal",new Bt(d,3)),this.setAttribute("uv",new Bt(f,2));function v(){let x=new B,R=new B,w=0,y=(t-e)/n;for(let M=0;M<=r;M++){let N=[],I=M/r,L=I*(t-e)+e;for(let k=0;k<=s;k++){let V=k/s,D=V*l+a,H=Math.sin(D),$=Math.cos(D);R.x=L*H,R.y=-I*n+g,R.z=L*$,h.push(R.x,R.y,R.z),x.set(H,y,$).normalize(),d.push(x.x,x.y,x.z),f.push(V,1-I),N.push(m++)}_.push(N)}for(let M=0;M<s;M++)for(let N=0;N<r;N++){let I=_[N][M],L=_[N+1][M],k=_[N+1][M+1],V=_[N][M+1];(e>0||N!==0)&&(u.push(I,L,V),w+=3),(t>0||N!==r-1)&&(u.push(L,k,V),w+=3)}c.addGroup(p,w,0),p+=w}function T(x){let R=m,w=new Ze,y=new B,M=0,N=x===!0?e:t,I=x===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,g*I,0),d.push(0,I,0),f.push(.5,.5),m++;let L=m;for(let k=0;k<=s;k++){let D=k/s*l+a,H=Math.cos(D),$=Math.sin(D);y.x=N*$,y.y=g*I,y.z=N*H,h.push(y.x,y.y,y.z),d.push(0,I,0),w.x=H*.5+.5,w.y=$*.5*I+.5,f.push(w.x,w.y),m++}for(let k=0;k<s;k++){let V=R+k,D=L+k;x===!0?u.push(D,D+1,V):u.push(D+1,D,V),M+=3}c.addGroup(p,M,x===!0?1:2),p+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Za=class i extends gs{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var kr=class i extends on{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],m=[],_=[],g=[];for(let p=0;p<u;p++){let v=p*d-o;for(let T=0;T<c;T++){let x=T*h-r;m.push(x,-v,0),_.push(0,0,1),g.push(T/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let T=v+c*p,x=v+c*(p+1),R=v+1+c*(p+1),w=v+1+c*p;f.push(T,x,w),f.push(x,R,w)}this.setIndex(f),this.setAttribute("position",new Bt(m,3)),this.setAttribute("normal",new Bt(_,3)),this.setAttribute("uv",new Bt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ja=class i extends on{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new B,d=new B,f=[],m=[],_=[],g=[];for(let p=0;p<=n;p++){let v=[],T=p/n,x=o+T*a,R=e*Math.cos(x),w=Math.sqrt(e*e-R*R),y=0;p===0&&o===0?y=.5/t:p===n&&l===Math.PI&&(y=-.5/t);for(let M=0;M<=t;M++){let N=M/t,I=s+N*r;h.x=-w*Math.cos(I),h.y=R,h.z=w*Math.sin(I),m.push(h.x,h.y,h.z),d.copy(h).normalize(),_.push(d.x,d.y,d.z),g.push(N+y,1-T),v.push(c++)}u.push(v)}for(let p=0;p<n;p++)for(let v=0;v<t;v++){let T=u[p][v+1],x=u[p][v],R=u[p+1][v],w=u[p+1][v+1];(p!==0||o>0)&&f.push(T,x,w),(p!==n-1||l<Math.PI)&&f.push(x,R,w)}this.setIndex(f),this.setAttribute("position",new Bt(m,3)),this.setAttribute("normal",new Bt(_,3)),this.setAttribute("uv",new Bt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var ja=class extends on{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new B,r=new B;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],d=h.start,f=h.count;for(let m=d,_=d+f;m<_;m+=3)for(let g=0;g<3;g++){let p=a.getX(m+g),v=a.getX(m+(g+1)%3);s.fromBufferAttribute(o,p),r.fromBufferAttribute(o,v),ty(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),ty(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Bt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function ty(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var Ka=class extends Ji{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new at(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function $r(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(ny(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(ny(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Yn(i){let e={};for(let t=0;t<i.length;t++){let n=$r(i[t]);for(let s in n)e[s]=n[s]}return e}function ny(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function tw(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function qf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var _l={clone:$r,merge:Yn},nw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,iw=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Di=class extends Ji{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=nw,this.fragmentShader=iw,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=$r(e.uniforms),this.uniformsGroups=tw(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new at().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ze().fromArray(s.value);break;case"v3":this.uniforms[n].value=new B().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Rt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ot().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},iu=class extends Di{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Qa=class extends Ji{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new at(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=yl,this.normalScale=new Ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var zr=class extends Ji{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=yl,this.normalScale=new Ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.combine=_u,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},su=class extends Ji{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Fy,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ru=class extends Ji{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var el=class extends qo{constructor(e){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(e)}copy(e){return super.copy(e),this.scale=e.scale,this.dashSize=e.dashSize,this.gapSize=e.gapSize,this}};function Do(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Dc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var lr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ou=class extends lr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:cf,endingEnd:cf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case uf:r=e,a=2*t-n;break;case hf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case uf:o=e,l=2*n-t;break;case hf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(n-t)/(s-t),_=m*m,g=_*m,p=-d*g+2*d*_-d*m,v=(1+d)*g+(-1.5-2*d)*_+(-.5+d)*m+1,T=(-1-f)*g+(1.5+f)*_+.5*m,x=f*g-f*_;for(let R=0;R!==a;++R)r[R]=p*o[u+R]+v*o[c+R]+T*o[l+R]+x*o[h+R];return r}},au=class extends lr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},lu=class extends lr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},cu=class extends lr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(n-t)/(s-t),_=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*m;return r}let d=a*2,f=e-1;for(let m=0;m!==a;++m){let _=o[c+m],g=o[l+m],p=f*d+m*2,v=h[p],T=h[p+1],x=e*d+m*2,R=u[x],w=u[x+1],y=rw(n,t,v,R,s);r[m]=$y(y,_,T,w,g)}return r}};function $y(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function sw(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function rw(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=$y(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=sw(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Mi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Do(t,this.TimeBufferType),this.values=Do(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Do(e.times,Array),values:Do(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Dc(e.settings)&&(n.settings={inTangents:Do(e.settings.inTangents,Array),outTangents:Do(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new lu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new au(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new ou(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new cu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Na:t=this.InterpolantFactoryMethodDiscrete;break;case Yc:t=this.InterpolantFactoryMethodLinear;break;case Oc:t=this.InterpolantFactoryMethodSmooth;break;case lf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return $e("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Na;case this.InterpolantFactoryMethodLinear:return Yc;case this.InterpolantFactoryMethodSmooth:return Oc;case this.InterpolantFactoryMethodBezier:return lf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Dc(this.settings)&&(iy(this.settings.inTangents,e),iy(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Dc(this.settings)&&(sy(this.settings.inTangents,e),sy(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&bM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Oc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,d=h-n,f=h+n;for(let m=0;m!==n;++m){let _=t[h+m];if(_!==t[d+m]||_!==t[f+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Dc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function iy(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function sy(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Mi.prototype.ValueTypeName="";Mi.prototype.TimeBufferType=Float32Array;Mi.prototype.ValueBufferType=Float32Array;Mi.prototype.DefaultInterpolation=Yc;var cr=class extends Mi{constructor(e,t,n){super(e,t,n)}};cr.prototype.ValueTypeName="bool";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Na;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var uu=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};uu.prototype.ValueTypeName="color";var hu=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};hu.prototype.ValueTypeName="number";var du=class extends lr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Fn.slerpFlat(r,0,o,c-a,o,c,l);return r}},tl=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new du(this.times,this.values,this.getValueSize(),e)}};tl.prototype.ValueTypeName="quaternion";tl.prototype.InterpolantFactoryMethodSmooth=void 0;var ur=class extends Mi{constructor(e,t,n){super(e,t,n)}};ur.prototype.ValueTypeName="string";ur.prototype.ValueBufferType=Array;ur.prototype.DefaultInterpolation=Na;ur.prototype.InterpolantFactoryMethodLinear=void 0;ur.prototype.InterpolantFactoryMethodSmooth=void 0;var fu=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};fu.prototype.ValueTypeName="vector";var pu=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Yy=new pu,mu=class{constructor(e){this.manager=e!==void 0?e:Yy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};mu.DEFAULT_MATERIAL_NAME="__DEFAULT";var nl=class extends kn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new at(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},il=class extends nl{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(kn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new at(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},of=new Ot,ry=new B,oy=new B,gu=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ze(512,512),this.mapType=li,this.map=null,this.mapPass=null,this.matrix=new Ot,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new or,this._frameExtents=new Ze(1,1),this._viewportCount=1,this._viewports=[new Rt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;ry.setFromMatrixPosition(e.matrixWorld),t.position.copy(ry),oy.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(oy),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){of.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(of,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===zo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(of)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Fc=new B,Nc=new Fn,fs=new B,sl=class extends kn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ot,this.projectionMatrix=new Ot,this.projectionMatrixInverse=new Ot,this.coordinateSystem=Li,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Fc,Nc,fs),fs.x===1&&fs.y===1&&fs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Nc,fs.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Fc,Nc,fs),fs.x===1&&fs.y===1&&fs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Nc,fs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},sr=new B,ay=new Ze,ly=new Ze,ii=class extends sl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Go*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Da*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Go*2*Math.atan(Math.tan(Da*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){sr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(sr.x,sr.y).multiplyScalar(-e/sr.z),sr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(sr.x,sr.y).multiplyScalar(-e/sr.z)}getViewSize(e,t){return this.getViewBounds(e,ay,ly),t.subVectors(ly,ay)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Da*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var rl=class extends sl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},df=class extends gu{constructor(){super(new rl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ol=class extends nl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(kn.DEFAULT_UP),this.updateMatrix(),this.target=new kn,this.shadow=new df}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var al=class extends on{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Fo=-90,No=1,Yo=class extends kn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ii(Fo,No,e,t);s.layers=this.layers,this.add(s);let r=new ii(Fo,No,e,t);r.layers=this.layers,this.add(r);let o=new ii(Fo,No,e,t);o.layers=this.layers,this.add(o);let a=new ii(Fo,No,e,t);a.layers=this.layers,this.add(a);let l=new ii(Fo,No,e,t);l.layers=this.layers,this.add(l);let c=new ii(Fo,No,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Li)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===zo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=_,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},yu=class extends ii{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var $f="\\[\\]\\.:\\/",ow=new RegExp("["+$f+"]","g"),Yf="[^"+$f+"]",aw="[^"+$f.replace("\\.","")+"]",lw=/((?:WC+[\/:])*)/.source.replace("WC",Yf),cw=/(WCOD+)?/.source.replace("WCOD",aw),uw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Yf),hw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Yf),dw=new RegExp("^"+lw+cw+uw+hw+"$"),fw=["material","materials","bones","map"],ff=class{constructor(e,t,n){let s=n||$t.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},$t=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ow,"")}static parseTrackName(e){let t=dw.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);fw.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$t.Composite=ff;$t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$t.prototype.GetterByBindingType=[$t.prototype._getValue_direct,$t.prototype._getValue_array,$t.prototype._getValue_arrayElement,$t.prototype._getValue_toArray];$t.prototype.SetterByBindingTypeAndVersioning=[[$t.prototype._setValue_direct,$t.prototype._setValue_direct_setNeedsUpdate,$t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_array,$t.prototype._setValue_array_setNeedsUpdate,$t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_arrayElement,$t.prototype._setValue_arrayElement_setNeedsUpdate,$t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_fromArray,$t.prototype._setValue_fromArray_setNeedsUpdate,$t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var A3=new Float32Array(1);var hr=class extends Xa{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var dr=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ot(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(ot(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var pf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var cy=new B,Uc=new B,Uo=new B,Oo=new B,af=new B,pw=new B,mw=new B,ll=class{constructor(e=new B,t=new B){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){cy.subVectors(e,this.start),Uc.subVectors(this.end,this.start);let n=Uc.dot(Uc);if(n===0)return 0;let r=Uc.dot(cy)/n;return t&&(r=ot(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=pw,n=mw){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;Uo.subVectors(c,a),Oo.subVectors(u,l),af.subVectors(a,l);let h=Uo.dot(Uo),d=Oo.dot(Oo),f=Oo.dot(af);if(h<=s&&d<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(h<=s)r=0,o=f/d,o=ot(o,0,1);else{let m=Uo.dot(af);if(d<=s)o=0,r=ot(-m/h,0,1);else{let _=Uo.dot(Oo),g=h*d-_*_;g!==0?r=ot((_*f-m*d)/g,0,1):r=0,o=(_*r+f)/d,o<0?(o=0,r=ot(-m/h,0,1)):o>1&&(o=1,r=ot((_-m)/h,0,1))}}return t.copy(a).addScaledVector(Uo,r),n.copy(l).addScaledVector(Oo,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Vr=class extends nu{constructor(e=10,t=10,n=4473924,s=8947848){n=new at(n),s=new at(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,m=-a;d<=t;d++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let _=d===r?n:s;_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3}let u=new on;u.setAttribute("position",new Bt(l,3)),u.setAttribute("color",new Bt(c,3));let h=new qo({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var cl=class extends Yi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Zf(i,e,t,n){let s=gw(n);switch(t){case Df:return i*e;case Nf:return i*e/s.components*s.byteLength;case Au:return i*e/s.components*s.byteLength;case gr:return i*e*2/s.components*s.byteLength;case Eu:return i*e*2/s.components*s.byteLength;case Ff:return i*e*3/s.components*s.byteLength;case es:return i*e*4/s.components*s.byteLength;case Tu:return i*e*4/s.components*s.byteLength;case hl:case dl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case fl:case pl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Cu:case Lu:return Math.max(i,16)*Math.max(e,8)/4;case Ru:case Pu:return Math.max(i,8)*Math.max(e,8)/2;case Iu:case Du:case Nu:case Uu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Fu:case ml:case Ou:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Bu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ku:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case zu:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Vu:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Gu:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Hu:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Wu:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Xu:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case qu:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case $u:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Yu:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Zu:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Ju:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case ju:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Ku:case Qu:case eh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case th:case nh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case gl:case ih:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function gw(i){switch(i){case li:case Cf:return{byteLength:1,components:1};case Ko:case Pf:case Qi:return{byteLength:2,components:1};case Mu:case wu:return{byteLength:2,components:4};case ji:case Su:case Ki:return{byteLength:4,components:1};case Lf:case If:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function g_(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Sw(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<h.length;f++){let m=h[d],_=h[f];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++d,h[d]=_)}h.length=d+1;for(let f=0,m=h.length;f<m;f++){let _=h[f];i.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Mw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ww=`#ifdef USE_ALPHAHASH
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
#endif`,Aw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ew=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Tw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Rw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Cw=`#ifdef USE_AOMAP
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
#endif`,Pw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Lw=`#ifdef USE_BATCHING
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
#endif`,Iw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Dw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Fw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Nw=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Uw=`#ifdef USE_IRIDESCENCE
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
#endif`,Ow=`#ifdef USE_BUMPMAP
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
#endif`,Bw=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,kw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,zw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Vw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Gw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Hw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Ww=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Xw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,qw=`#define PI 3.141592653589793
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
} // validated`,$w=`vec3 transformedNormal = objectNormal;
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
#endif`,Yw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Zw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Jw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,jw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Kw="gl_FragColor = linearToOutputTexel( gl_FragColor );",Qw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,e1=`#ifdef USE_ENVMAP
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
#endif`,t1=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,n1=`#ifdef USE_ENVMAP
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
#endif`,i1=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,s1=`#ifdef USE_ENVMAP
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
#endif`,r1=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,o1=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,a1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,l1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,c1=`#ifdef USE_GRADIENTMAP
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
}`,u1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,h1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,d1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,f1=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,p1=`#ifdef USE_ENVMAP
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
#endif`,m1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,g1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,y1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,_1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,x1=`PhysicalMaterial material;
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
#endif`,v1=`uniform sampler2D dfgLUT;
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
}`,b1=`
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
#endif`,S1=`#if defined( RE_IndirectDiffuse )
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
#endif`,M1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,w1=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,A1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,E1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,T1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,R1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,C1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,P1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,L1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,I1=`#if defined( USE_POINTS_UV )
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
#endif`,D1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,F1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,N1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,U1=`#if defined( USE_MORPHCOLORS )
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
#endif`,O1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,B1=`#ifdef USE_MORPHTARGETS
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
#endif`,k1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,z1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,V1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,G1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,H1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,W1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,X1=`#ifdef USE_NORMALMAP
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
#endif`,q1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,$1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Y1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Z1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,J1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,j1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,K1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Q1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,eA=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,tA=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,nA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,iA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,sA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,rA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,oA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,aA=`float getShadowMask() {
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
}`,lA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,cA=`#ifdef USE_SKINNING
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
#endif`,uA=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,hA=`#ifdef USE_SKINNING
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
#endif`,dA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,fA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,pA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,mA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,gA=`#ifdef USE_TRANSMISSION
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
#endif`,yA=`#ifdef USE_TRANSMISSION
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
#endif`,_A=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,xA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,vA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,bA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,SA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,MA=`uniform sampler2D t2D;
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
}`,wA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,AA=`uniform float backgroundBlurriness;
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
}`,EA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,TA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RA=`#include <common>
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
}`,CA=`#if DEPTH_PACKING == 3200
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
}`,PA=`#define DISTANCE
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
}`,LA=`#define DISTANCE
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
}`,IA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,DA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,FA=`uniform float scale;
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
}`,NA=`uniform vec3 diffuse;
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
}`,UA=`#include <common>
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
}`,OA=`uniform vec3 diffuse;
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
}`,BA=`#define LAMBERT
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
}`,kA=`#define LAMBERT
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
}`,zA=`#define MATCAP
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
}`,VA=`#define MATCAP
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
}`,GA=`#define NORMAL
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
}`,HA=`#define NORMAL
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
}`,WA=`#define PHONG
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
}`,XA=`#define PHONG
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
}`,qA=`#define STANDARD
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
}`,$A=`#define STANDARD
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
}`,YA=`#define TOON
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
}`,ZA=`#define TOON
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
}`,JA=`uniform float size;
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
}`,jA=`uniform vec3 diffuse;
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
}`,KA=`#include <common>
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
}`,QA=`uniform vec3 color;
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
}`,eE=`uniform float rotation;
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
}`,tE=`uniform vec3 diffuse;
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
}`,ht={alphahash_fragment:Mw,alphahash_pars_fragment:ww,alphamap_fragment:Aw,alphamap_pars_fragment:Ew,alphatest_fragment:Tw,alphatest_pars_fragment:Rw,aomap_fragment:Cw,aomap_pars_fragment:Pw,batching_pars_vertex:Lw,batching_vertex:Iw,begin_vertex:Dw,beginnormal_vertex:Fw,bsdfs:Nw,iridescence_fragment:Uw,bumpmap_pars_fragment:Ow,clipping_planes_fragment:Bw,clipping_planes_pars_fragment:kw,clipping_planes_pars_vertex:zw,clipping_planes_vertex:Vw,color_fragment:Gw,color_pars_fragment:Hw,color_pars_vertex:Ww,color_vertex:Xw,common:qw,defaultnormal_vertex:$w,displacementmap_pars_vertex:Yw,displacementmap_vertex:Zw,emissivemap_fragment:Jw,emissivemap_pars_fragment:jw,colorspace_fragment:Kw,colorspace_pars_fragment:Qw,envmap_fragment:e1,envmap_common_pars_fragment:t1,envmap_pars_fragment:n1,envmap_pars_vertex:i1,envmap_physical_pars_fragment:p1,envmap_vertex:s1,fog_vertex:r1,fog_pars_vertex:o1,fog_fragment:a1,fog_pars_fragment:l1,gradientmap_pars_fragment:c1,lightmap_pars_fragment:u1,lights_lambert_fragment:h1,lights_lambert_pars_fragment:d1,lights_pars_begin:f1,lights_toon_fragment:m1,lights_toon_pars_fragment:g1,lights_phong_fragment:y1,lights_phong_pars_fragment:_1,lights_physical_fragment:x1,lights_physical_pars_fragment:v1,lights_fragment_begin:b1,lights_fragment_maps:S1,lights_fragment_end:M1,lightprobes_pars_fragment:w1,logdepthbuf_fragment:A1,logdepthbuf_pars_fragment:E1,logdepthbuf_pars_vertex:T1,logdepthbuf_vertex:R1,map_fragment:C1,map_pars_fragment:P1,map_particle_fragment:L1,map_particle_pars_fragment:I1,metalnessmap_fragment:D1,metalnessmap_pars_fragment:F1,morphinstance_vertex:N1,morphcolor_vertex:U1,morphnormal_vertex:O1,morphtarget_pars_vertex:B1,morphtarget_vertex:k1,normal_fragment_begin:z1,normal_fragment_maps:V1,normal_pars_fragment:G1,normal_pars_vertex:H1,normal_vertex:W1,normalmap_pars_fragment:X1,clearcoat_normal_fragment_begin:q1,clearcoat_normal_fragment_maps:$1,clearcoat_pars_fragment:Y1,iridescence_pars_fragment:Z1,opaque_fragment:J1,packing:j1,premultiplied_alpha_fragment:K1,project_vertex:Q1,dithering_fragment:eA,dithering_pars_fragment:tA,roughnessmap_fragment:nA,roughnessmap_pars_fragment:iA,shadowmap_pars_fragment:sA,shadowmap_pars_vertex:rA,shadowmap_vertex:oA,shadowmask_pars_fragment:aA,skinbase_vertex:lA,skinning_pars_vertex:cA,skinning_vertex:uA,skinnormal_vertex:hA,specularmap_fragment:dA,specularmap_pars_fragment:fA,tonemapping_fragment:pA,tonemapping_pars_fragment:mA,transmission_fragment:gA,transmission_pars_fragment:yA,uv_pars_fragment:_A,uv_pars_vertex:xA,uv_vertex:vA,worldpos_vertex:bA,background_vert:SA,background_frag:MA,backgroundCube_vert:wA,backgroundCube_frag:AA,cube_vert:EA,cube_frag:TA,depth_vert:RA,depth_frag:CA,distance_vert:PA,distance_frag:LA,equirect_vert:IA,equirect_frag:DA,linedashed_vert:FA,linedashed_frag:NA,meshbasic_vert:UA,meshbasic_frag:OA,meshlambert_vert:BA,meshlambert_frag:kA,meshmatcap_vert:zA,meshmatcap_frag:VA,meshnormal_vert:GA,meshnormal_frag:HA,meshphong_vert:WA,meshphong_frag:XA,meshphysical_vert:qA,meshphysical_frag:$A,meshtoon_vert:YA,meshtoon_frag:ZA,points_vert:JA,points_frag:jA,shadow_vert:KA,shadow_frag:QA,sprite_vert:eE,sprite_frag:tE},Pe={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new Ze(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new Ze(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},oi={basic:{uniforms:Yn([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Yn([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new at(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Yn([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Yn([Pe.common,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.roughnessmap,Pe.metalnessmap,Pe.fog,Pe.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Yn([Pe.common,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.gradientmap,Pe.fog,Pe.lights,{emissive:{value:new at(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Yn([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Yn([Pe.points,Pe.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Yn([Pe.common,Pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Yn([Pe.common,Pe.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Yn([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Yn([Pe.sprite,Pe.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Yn([Pe.common,Pe.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Yn([Pe.lights,Pe.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};oi.physical={uniforms:Yn([oi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new Ze(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new Ze},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new Ze},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var rh={r:0,b:0,g:0},nE=new Ot,y_=new nt;y_.set(-1,0,0,0,1,0,0,0,1);function iE(i,e,t,n,s,r){let o=new at(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let x=v.backgroundBlurriness>0;T=e.get(T,x)}return T}function m(v){let T=!1,x=f(v);x===null?g(o,a):x&&x.isColor&&(g(x,1),T=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(v,T){let x=f(T);x&&x.isCubeTexture?(c===void 0&&(c=new kt(new ar(1,1,1),new Di({name:"BackgroundCubeMaterial",uniforms:$r(oi.backgroundCube.uniforms),vertexShader:oi.backgroundCube.vertexShader,fragmentShader:oi.backgroundCube.fragmentShader,side:ri,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,w,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=x,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(nE.makeRotationFromEuler(T.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(y_),c.material.toneMapped=xt.getTransfer(x.colorSpace)!==Tt,(u!==x||h!==x.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,u=x,h=x.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new kt(new kr(2,2),new Di({name:"BackgroundMaterial",uniforms:$r(oi.background.uniforms),vertexShader:oi.background.vertexShader,fragmentShader:oi.background.fragmentShader,side:mr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=xt.getTransfer(x.colorSpace)!==Tt,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(u!==x||h!==x.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=x,h=x.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,T){v.getRGB(rh,qf(i)),t.buffers.color.setClear(rh.r,rh.g,rh.b,T,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:m,addToRenderList:_,dispose:p}}function sE(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,k,V,D,H){let $=!1,G=h(L,D,V,k);r!==G&&(r=G,c(r.object)),$=f(L,D,V,H),$&&m(L,D,V,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,x(L,k,V,D),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function u(L){return i.deleteVertexArray(L)}function h(L,k,V,D){let H=D.wireframe===!0,$=n[k.id];$===void 0&&($={},n[k.id]=$);let G=L.isInstancedMesh===!0?L.id:0,le=$[G];le===void 0&&(le={},$[G]=le);let Y=le[V.id];Y===void 0&&(Y={},le[V.id]=Y);let K=Y[H];return K===void 0&&(K=d(l()),Y[H]=K),K}function d(L){let k=[],V=[],D=[];for(let H=0;H<t;H++)k[H]=0,V[H]=0,D[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:V,attributeDivisors:D,object:L,attributes:{},index:null}}function f(L,k,V,D){let H=r.attributes,$=k.attributes,G=0,le=V.getAttributes();for(let Y in le)if(le[Y].location>=0){let te=H[Y],fe=$[Y];if(fe===void 0&&(Y==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),Y==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),te===void 0||te.attribute!==fe||fe&&te.data!==fe.data)return!0;G++}return r.attributesNum!==G||r.index!==D}function m(L,k,V,D){let H={},$=k.attributes,G=0,le=V.getAttributes();for(let Y in le)if(le[Y].location>=0){let te=$[Y];te===void 0&&(Y==="instanceMatrix"&&L.instanceMatrix&&(te=L.instanceMatrix),Y==="instanceColor"&&L.instanceColor&&(te=L.instanceColor));let fe={};fe.attribute=te,te&&te.data&&(fe.data=te.data),H[Y]=fe,G++}r.attributes=H,r.attributesNum=G,r.index=D}function _(){let L=r.newAttributes;for(let k=0,V=L.length;k<V;k++)L[k]=0}function g(L){p(L,0)}function p(L,k){let V=r.newAttributes,D=r.enabledAttributes,H=r.attributeDivisors;V[L]=1,D[L]===0&&(i.enableVertexAttribArray(L),D[L]=1),H[L]!==k&&(i.vertexAttribDivisor(L,k),H[L]=k)}function v(){let L=r.newAttributes,k=r.enabledAttributes;for(let V=0,D=k.length;V<D;V++)k[V]!==L[V]&&(i.disableVertexAttribArray(V),k[V]=0)}function T(L,k,V,D,H,$,G){G===!0?i.vertexAttribIPointer(L,k,V,H,$):i.vertexAttribPointer(L,k,V,D,H,$)}function x(L,k,V,D){_();let H=D.attributes,$=V.getAttributes(),G=k.defaultAttributeValues;for(let le in $){let Y=$[le];if(Y.location>=0){let K=H[le];if(K===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(K=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(K=L.instanceColor)),K!==void 0){let te=K.normalized,fe=K.itemSize,ue=e.get(K);if(ue===void 0)continue;let Q=ue.buffer,_e=ue.type,re=ue.bytesPerElement,me=_e===i.INT||_e===i.UNSIGNED_INT||K.gpuType===Su;if(K.isInterleavedBufferAttribute){let pe=K.data,Oe=pe.isInterleavedBuffer===!0?pe.stride:pe.itemSize,Xe=K.offset;if(pe.isInstancedInterleavedBuffer||pe.isInstancedBufferAttribute){for(let Ge=0;Ge<Y.locationSize;Ge++)p(Y.location+Ge,pe.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=pe.meshPerAttribute*pe.count)}else for(let Ge=0;Ge<Y.locationSize;Ge++)g(Y.location+Ge);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Ge=0;Ge<Y.locationSize;Ge++)T(Y.location+Ge,fe/Y.locationSize,_e,te,Oe*re,(Xe+fe/Y.locationSize*Ge)*re,me)}else{if(K.isInstancedBufferAttribute){for(let pe=0;pe<Y.locationSize;pe++)p(Y.location+pe,K.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let pe=0;pe<Y.locationSize;pe++)g(Y.location+pe);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let pe=0;pe<Y.locationSize;pe++)T(Y.location+pe,fe/Y.locationSize,_e,te,fe*re,fe/Y.locationSize*pe*re,me)}}else if(G!==void 0){let te=G[le];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(Y.location,te);break;case 3:i.vertexAttrib3fv(Y.location,te);break;case 4:i.vertexAttrib4fv(Y.location,te);break;default:i.vertexAttrib1fv(Y.location,te)}}}}v()}function R(){N();for(let L in n){let k=n[L];for(let V in k){let D=k[V];for(let H in D){let $=D[H];for(let G in $)u($[G].object),delete $[G];delete D[H]}}delete n[L]}}function w(L){if(n[L.id]===void 0)return;let k=n[L.id];for(let V in k){let D=k[V];for(let H in D){let $=D[H];for(let G in $)u($[G].object),delete $[G];delete D[H]}}delete n[L.id]}function y(L){for(let k in n){let V=n[k];for(let D in V){let H=V[D];if(H[L.id]===void 0)continue;let $=H[L.id];for(let G in $)u($[G].object),delete $[G];delete H[L.id]}}}function M(L){for(let k in n){let V=n[k],D=L.isInstancedMesh===!0?L.id:0,H=V[D];if(H!==void 0){for(let $ in H){let G=H[$];for(let le in G)u(G[le].object),delete G[le];delete H[$]}delete V[D],Object.keys(V).length===0&&delete n[k]}}}function N(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:I,dispose:R,releaseStatesOfGeometry:w,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:g,disableUnusedAttributes:v}}function rE(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function oE(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==es&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===Qi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==li&&y!==Ki&&!M&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:x,maxSamples:R,samples:w}}function aE(i){let e=this,t=null,n=0,s=!1,r=!1,o=new bi,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||n!==0||s;return s=d,n=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let m=h.clippingPlanes,_=h.clipIntersection,g=h.clipShadows,p=i.get(h);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let v=r?0:n,T=v*4,x=p.clippingState||null;l.value=x,x=u(m,d,T,f);for(let R=0;R!==T;++R)x[R]=t[R];p.clippingState=x,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,d,f,m){let _=h!==null?h.length:0,g=null;if(_!==0){if(g=l.value,m!==!0||g===null){let p=f+_*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<p)&&(g=new Float32Array(p));for(let T=0,x=f;T!==_;++T,x+=4)o.copy(h[T]).applyMatrix4(v,a),o.normal.toArray(g,x),g[x+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,g}}var bl=class extends Si{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new qa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ar(5,5,5),r=new Di({name:"CubemapFromEquirect",uniforms:$r(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ri,blending:Hr});r.uniforms.tEquirect.value=t;let o=new kt(s,r),a=t.minFilter;return t.minFilter===ks&&(t.minFilter=si),new Yo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Zy=256,lE=3,cE=20,__=256,x_=16,uE=3,hE=new B,dE=new at,ah=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Yo(1,10,null),this._boxMesh=new kt(new ar(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=hE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(dE));let g=new Yo(n,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ky(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=jy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Zy,Hf(e))}_fromTexture(e,t){e.mapping===Xr||e.mapping===jo?this._setSize(e.image.length===0?Zy:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Jy(e,!1,!1),n=Math.log2(e)-lE;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Jy(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Xr||e.mapping===jo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ky()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=jy()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=fE(),this._integrationMaterial=pE());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/x_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-uE)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(__*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=mE());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Jy(i,e,t){return new bl(i,{minFilter:ks,generateMipmaps:e,type:Qi,colorSpace:Ua,depthBuffer:t})}function Sl(i,e,t){return new Di({name:i,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:ri,blending:Hr,depthTest:!1,depthWrite:!1})}function fE(){return Sl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${__}u

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
	`)}function pE(){return Sl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:x_}},`

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
	`)}function mE(){return Sl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${cE}
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
	`)}function jy(){return Sl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Ky(){return Sl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function gE(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===xu||f===vu)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let _=new bl(m.height);return _.fromEquirectangularTexture(i,d),e.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===xu||f===vu,_=f===Xr||f===jo;if(m||_){let g=t.get(d),p=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return n===null&&(n=new ah(i)),g=m?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let v=d.image;return m&&v&&v.height>0||_&&v&&l(v)?(n===null&&(n=new ah(i)),g=m?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===xu?d.mapping=Xr:f===vu&&(d.mapping=jo),d}function l(d){let f=0,m=6;for(let _=0;_<m;_++)d[_]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function yE(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ia("WebGLRenderer: "+n+" extension not supported."),s}}}function _E(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let _=r.get(m);_&&(e.remove(_),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function u(m){let _=m.attributes;for(let g in _)e.update(_[g],i.ARRAY_BUFFER)}function h(m){let _=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let v=_!==null?_.array.length:g.array.length/3-1,T=g.count>=65535?Wa:Ha,x=new T(Math.ceil(v/3)*6,1),R=x.array;if(_!==null){let y=_.array;p=_.version;for(let M=0,N=0;M<v;M+=3){let I=y[M+0],L=y[M+1],k=y[M+2];R[N++]=I,R[N++]=L,R[N++]=L,R[N++]=k,R[N++]=k,R[N++]=I}}else{p=g.version;for(let y=0,M=0;y<v;y+=3){let N=y+0,I=y+1,L=y+2;R[M++]=N,R[M++]=I,R[M++]=I,R[M++]=L,R[M++]=L,R[M++]=N}}x.version=p;let w=r.get(m);w&&e.remove(w),r.set(m,x)}function d(m){let _=r.get(m);if(_){let g=m.index;g!==null&&_.version<g.version&&h(m)}else h(m);return r.get(m)}function f(){for(let m in s){let _=s[m].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function xE(i,e,t){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){i.drawElements(n,d,r,h*o),t.update(d,n,1)}function c(h,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,h*o,f),t.update(d,n,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,h,0,f);let _=0;for(let g=0;g<f;g++)_+=d[g];t.update(_,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function vE(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function bE(i,e,t){let n=new WeakMap,s=new Rt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=n.get(a);if(d===void 0||d.count!==h){let N=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;f===!0&&(T=1),m===!0&&(T=2),_===!0&&(T=3);let x=a.attributes.position.count*T,R=1;x>e.maxTextureSize&&(R=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let w=new Float32Array(x*R*4*h),y=new za(w,x,R,h);y.type=Ki,y.needsUpdate=!0;let M=T*4;for(let I=0;I<h;I++){let L=g[I],k=p[I],V=v[I],D=x*R*4*I;for(let H=0;H<L.count;H++){let $=H*M;f===!0&&(s.fromBufferAttribute(L,H),w[D+$+0]=s.x,w[D+$+1]=s.y,w[D+$+2]=s.z,w[D+$+3]=0),m===!0&&(s.fromBufferAttribute(k,H),w[D+$+4]=s.x,w[D+$+5]=s.y,w[D+$+6]=s.z,w[D+$+7]=0),_===!0&&(s.fromBufferAttribute(V,H),w[D+$+8]=s.x,w[D+$+9]=s.y,w[D+$+10]=s.z,w[D+$+11]=V.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Ze(x,R)},n.set(a,d),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function SE(i,e,t,n,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var ME={[bf]:"LINEAR_TONE_MAPPING",[Sf]:"REINHARD_TONE_MAPPING",[Mf]:"CINEON_TONE_MAPPING",[wf]:"ACES_FILMIC_TONE_MAPPING",[Ef]:"AGX_TONE_MAPPING",[Tf]:"NEUTRAL_TONE_MAPPING",[Af]:"CUSTOM_TONE_MAPPING"};function wE(i,e,t,n,s,r){let o=new Si(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new on;u.setAttribute("position",new Bt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Bt([0,2,0,0,2,0],2));let h=new iu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new kt(u,h),f=new rl(-1,1,1,-1,0,1),m=null,_=null,g=!1,p,v=null,T=[],x=!1;this.setSize=function(R,w){o.setSize(R,w),a!==null&&a.setSize(R,w),l!==null&&l.setSize(R,w);for(let y=0;y<T.length;y++){let M=T[y];M.setSize&&M.setSize(R,w)}},this.setEffects=function(R){T=R,x=T.length>0&&T[0].isRenderPass===!0;let w=o.width,y=o.height;T.length>0&&a===null&&(a=new Si(w,y,{type:Qi,depthBuffer:!1,stencilBuffer:!1}),l=new Si(w,y,{type:Qi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&T.some(N=>N.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Bs(w,y),r===!0&&(c.format=zs,c.type=qr)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let N=0;N<T.length;N++){let I=T[N];I.setSize&&I.setSize(w,y),M&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(R,w){if(g||R.toneMapping===ys&&T.length===0)return!1;if(v=w,w!==null){let y=w.width,M=w.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return x===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=ys,!0},this.hasRenderPass=function(){return x},this.end=function(R,w){R.toneMapping=p,g=!0;let y=o,M=a;for(let N=0;N<T.length;N++){let I=T[N];I.enabled!==!1&&(I.render(R,M,y,w),I.needsSwap!==!1&&(y=M,M=M===a?l:a))}if(m!==R.outputColorSpace||_!==R.toneMapping){m=R.outputColorSpace,_=R.toneMapping,h.defines={},xt.getTransfer(m)===Tt&&(h.defines.SRGB_TRANSFER="");let N=ME[_];N&&(h.defines[N]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(v),R.render(d,f),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var v_=new ai,b_=new Bs(1,1),S_=new $a(1),M_=new za,w_=new jc,A_=new qa,Qy=[],e_=[],t_=new Float32Array(16),n_=new Float32Array(9),i_=new Float32Array(4);function ea(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Qy[s];if(r===void 0&&(r=new Float32Array(s),Qy[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Sn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Mn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function ch(i,e){let t=e_[e];t===void 0&&(t=new Int32Array(e),e_[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function AE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function EE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2fv(this.addr,e),Mn(t,e)}}function TE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;i.uniform3fv(this.addr,e),Mn(t,e)}}function RE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4fv(this.addr,e),Mn(t,e)}}function CE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;i_.set(n),i.uniformMatrix2fv(this.addr,!1,i_),Mn(t,n)}}function PE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;n_.set(n),i.uniformMatrix3fv(this.addr,!1,n_),Mn(t,n)}}function LE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;t_.set(n),i.uniformMatrix4fv(this.addr,!1,t_),Mn(t,n)}}function IE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function DE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2iv(this.addr,e),Mn(t,e)}}function FE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;i.uniform3iv(this.addr,e),Mn(t,e)}}function NE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4iv(this.addr,e),Mn(t,e)}}function UE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function OE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2uiv(this.addr,e),Mn(t,e)}}function BE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;i.uniform3uiv(this.addr,e),Mn(t,e)}}function kE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4uiv(this.addr,e),Mn(t,e)}}function uh(i){return i.version===0&&(i.compareFunction=Bf,i.needsUpdate=!0),i}function zE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=uh(b_):r=v_,t.setTexture2D(e||r,s)}function VE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||w_,s)}function GE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=uh(S_):r=A_,t.setTextureCube(e||r,s)}function HE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||M_,s)}function WE(i){switch(i){case 5126:return AE;case 35664:return EE;case 35665:return TE;case 35666:return RE;case 35674:return CE;case 35675:return PE;case 35676:return LE;case 5124:case 35670:return IE;case 35667:case 35671:return DE;case 35668:case 35672:return FE;case 35669:case 35673:return NE;case 5125:return UE;case 36294:return OE;case 36295:return BE;case 36296:return kE;case 35678:case 36198:case 36298:case 36306:case 35682:return zE;case 35679:case 36299:case 36307:return VE;case 35680:case 36300:case 36308:case 36293:return GE;case 36289:case 36303:case 36311:case 36292:return HE}}function XE(i,e){i.uniform1fv(this.addr,e)}function qE(i,e){let t=ea(e,this.size,2);i.uniform2fv(this.addr,t)}function $E(i,e){let t=ea(e,this.size,3);i.uniform3fv(this.addr,t)}function YE(i,e){let t=ea(e,this.size,4);i.uniform4fv(this.addr,t)}function ZE(i,e){let t=ea(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function JE(i,e){let t=ea(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function jE(i,e){let t=ea(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function KE(i,e){i.uniform1iv(this.addr,e)}function QE(i,e){i.uniform2iv(this.addr,e)}function eT(i,e){i.uniform3iv(this.addr,e)}function tT(i,e){i.uniform4iv(this.addr,e)}function nT(i,e){i.uniform1uiv(this.addr,e)}function iT(i,e){i.uniform2uiv(this.addr,e)}function sT(i,e){i.uniform3uiv(this.addr,e)}function rT(i,e){i.uniform4uiv(this.addr,e)}function oT(i,e,t){let n=this.cache,s=e.length,r=ch(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=uh(b_):o=v_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function aT(i,e,t){let n=this.cache,s=e.length,r=ch(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||w_,r[o])}function lT(i,e,t){let n=this.cache,s=e.length,r=ch(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=uh(S_):o=A_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function cT(i,e,t){let n=this.cache,s=e.length,r=ch(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||M_,r[o])}function uT(i){switch(i){case 5126:return XE;case 35664:return qE;case 35665:return $E;case 35666:return YE;case 35674:return ZE;case 35675:return JE;case 35676:return jE;case 5124:case 35670:return KE;case 35667:case 35671:return QE;case 35668:case 35672:return eT;case 35669:case 35673:return tT;case 5125:return nT;case 36294:return iT;case 36295:return sT;case 36296:return rT;case 35678:case 36198:case 36298:case 36306:case 35682:return oT;case 35679:case 36299:case 36307:return aT;case 35680:case 36300:case 36308:case 36293:return lT;case 36289:case 36303:case 36311:case 36292:return cT}}var Kf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=WE(t.type)}},Qf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=uT(t.type)}},ep=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Jf=/(\w+)(\])?(\[|\.)?/g;function s_(i,e){i.seq.push(e),i.map[e.id]=e}function hT(i,e,t){let n=i.name,s=n.length;for(Jf.lastIndex=0;;){let r=Jf.exec(n),o=Jf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){s_(t,c===void 0?new Kf(a,i,e):new Qf(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new ep(a),s_(t,h)),t=h}}}var Qo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);hT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function r_(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var dT=37297,fT=0;function pT(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var o_=new nt;function mT(i){xt._getMatrix(o_,xt.workingColorSpace,i);let e=`mat3( ${o_.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(i)){case Oa:return[e,"LinearTransferOETF"];case Tt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function a_(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+pT(i.getShaderSource(e),a)}else return r}function gT(i,e){let t=mT(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var yT={[bf]:"Linear",[Sf]:"Reinhard",[Mf]:"Cineon",[wf]:"ACESFilmic",[Ef]:"AgX",[Tf]:"Neutral",[Af]:"Custom"};function _T(i,e){let t=yT[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var oh=new B;function xT(){xt.getLuminanceCoefficients(oh);let i=oh.x.toFixed(4),e=oh.y.toFixed(4),t=oh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function vT(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(vl).join(`
`)}function bT(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function ST(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function vl(i){return i!==""}function l_(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function c_(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var MT=/^[ \t]*#include +<([\w\d./]+)>/gm;function tp(i){return i.replace(MT,wT)}function wT(i,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return tp(t)}var AT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function u_(i){return i.replace(AT,ET)}function ET(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function h_(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var TT={[Gr]:"SHADOWMAP_TYPE_PCF",[Zo]:"SHADOWMAP_TYPE_VSM"};function RT(i){return TT[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var CT={[jo]:"ENVMAP_MODE_REFRACTION"};function PT(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":CT[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var LT={[_u]:"ENVMAP_BLENDING_MULTIPLY",[Ly]:"ENVMAP_BLENDING_MIX",[Iy]:"ENVMAP_BLENDING_ADD"};function IT(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":LT[i.combine]||"ENVMAP_BLENDING_NONE"}function DT(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=RT(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=PT(t),h=IT(t),d=vT(t),f=bT(r),m=s.createProgram(),_,g,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(vl).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(vl).join(`
`),g.length>0&&(g+=`
`)):(_=[h_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(vl).join(`
`),g=[h_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ys?"#define TONE_MAPPING":"",t.toneMapping!==ys?ht.tonemapping_pars_fragment:"",t.toneMapping!==ys?_T("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,gT("linearToOutputTexel",t.outputColorSpace),xT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(vl).join(`
`)),o=tp(o),o=l_(o,t),o=c_(o,t),a=tp(a),a=l_(a,t),a=c_(a,t),o=u_(o),a=u_(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",t.glslVersion===Vf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Vf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=p+_+o,T=p+g+a,x=r_(s,s.VERTEX_SHADER,v),R=r_(s,s.FRAGMENT_SHADER,T);s.attachShader(m,x),s.attachShader(m,R),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function w(I){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(m)||"",k=s.getShaderInfoLog(x)||"",V=s.getShaderInfoLog(R)||"",D=L.trim(),H=k.trim(),$=V.trim(),G=!0,le=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,x,R);else{let Y=a_(s,x,"vertex"),K=a_(s,R,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+D+`
`+Y+`
`+K)}else D!==""?$e("WebGLProgram: Program Info Log:",D):(H===""||$==="")&&(le=!1);le&&(I.diagnostics={runnable:G,programLog:D,vertexShader:{log:H,prefix:_},fragmentShader:{log:$,prefix:g}})}s.deleteShader(x),s.deleteShader(R),y=new Qo(s,m),M=ST(s,m)}let y;this.getUniforms=function(){return y===void 0&&w(this),y};let M;this.getAttributes=function(){return M===void 0&&w(this),M};let N=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(m,dT)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=fT++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=x,this.fragmentShader=R,this}var FT=0,np=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new ip(e),t.set(e,n)),n}},ip=class{constructor(e){this.id=FT++,this.code=e,this.usedTimes=0}};function NT(i){return i===gr||i===ml||i===gl}function UT(i,e,t,n,s,r){let o=new Va,a=new np,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,M,N,I,L,k){let V=I.fog,D=L.geometry,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?I.environment:null,$=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,G=e.get(y.envMap||H,$),le=d[y.type],Y=n.precision;y.precision!==null&&(Y=n.getMaxPrecision(y.precision),Y!==y.precision&&$e("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let K=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,te=K!==void 0?K.length:0,fe=0;D.morphAttributes.position!==void 0&&(fe=1),D.morphAttributes.normal!==void 0&&(fe=2),D.morphAttributes.color!==void 0&&(fe=3);let ue,Q,_e,re;if(le){let Re=oi[le];ue=Re.vertexShader,Q=Re.fragmentShader}else{ue=y.vertexShader,Q=y.fragmentShader;let Re=a.getVertexShaderStage(y),lt=a.getFragmentShaderStage(y);a.update(y,Re,lt),_e=Re.id,re=lt.id}let me=i.getRenderTarget(),pe=i.state.buffers.depth.getReversed(),Oe=L.isInstancedMesh===!0,Xe=L.isBatchedMesh===!0,Ge=!!y.map,dt=!!y.matcap,ct=!!G,it=ct&&G.isPMREMTexture===!0,Yt=!!y.aoMap,Vt=!!y.lightMap,cn=!!y.bumpMap&&y.wireframe===!1,It=!!y.normalMap,An=!!y.displacementMap,vt=!!y.emissiveMap,_n=!!y.metalnessMap,Qt=!!y.roughnessMap,un=y.anisotropy>0,O=y.clearcoat>0,Ce=y.diffuseRoughness>0,Ye=y.dispersion>0,rt=y.retroreflectivity>0,we=y.iridescence>0,Ft=y.sheen>0,Ve=y.transmission>0,qe=un&&!!y.anisotropyMap,C=O&&!!y.clearcoatMap,S=O&&!!y.clearcoatNormalMap,q=O&&!!y.clearcoatRoughnessMap,de=Ce&&!!y.diffuseRoughnessMap,ae=we&&!!y.iridescenceMap,ve=we&&!!y.iridescenceThicknessMap,be=Ft&&!!y.sheenColorMap,ne=Ft&&!!y.sheenRoughnessMap,se=!!y.specularMap,ye=!!y.specularColorMap,U=!!y.specularIntensityMap,oe=Ve&&!!y.transmissionMap,ie=Ve&&!!y.thicknessMap,Ae=!!y.gradientMap,xe=!!y.alphaMap,Me=y.alphaTest>0,He=!!y.alphaHash,Ke=!!y.extensions,he=ys;y.toneMapped&&(me===null||me.isXRRenderTarget===!0)&&(he=i.toneMapping);let Be=it?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Qe={shaderID:le,shaderType:y.type,shaderName:y.name,vertexShader:ue,fragmentShader:Q,defines:y.defines,customVertexShaderID:_e,customFragmentShaderID:re,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:Xe,batchingColor:Xe&&L._colorsTexture!==null,instancing:Oe,instancingColor:Oe&&L.instanceColor!==null,instancingMorph:Oe&&L.morphTexture!==null,outputColorSpace:me===null?i.outputColorSpace:me.isXRRenderTarget===!0?me.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ge,matcap:dt,envMap:ct,envMapMode:ct&&G.mapping,envMapPMREM:it,envMapMaxLod:it?Be.length-1:null,envMapSize:it?Be[0].width:null,aoMap:Yt,lightMap:Vt,bumpMap:cn,normalMap:It,displacementMap:An,emissiveMap:vt,normalMapObjectSpace:It&&y.normalMapType===Ny,normalMapTangentSpace:It&&y.normalMapType===yl,packedNormalMap:It&&y.normalMapType===yl&&NT(y.normalMap.format),metalnessMap:_n,roughnessMap:Qt,anisotropy:un,anisotropyMap:qe,clearcoat:O,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Ce,diffuseRoughnessMap:de,dispersion:Ye,retroreflection:rt,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:ve,sheen:Ft,sheenColorMap:be,sheenRoughnessMap:ne,specularMap:se,specularColorMap:ye,specularIntensityMap:U,transmission:Ve,transmissionMap:oe,thicknessMap:ie,gradientMap:Ae,opaque:y.transparent===!1&&y.blending===Jo&&y.alphaToCoverage===!1,alphaMap:xe,alphaTest:Me,alphaHash:He,combine:y.combine,mapUv:Ge&&f(y.map.channel),aoMapUv:Yt&&f(y.aoMap.channel),lightMapUv:Vt&&f(y.lightMap.channel),bumpMapUv:cn&&f(y.bumpMap.channel),normalMapUv:It&&f(y.normalMap.channel),displacementMapUv:An&&f(y.displacementMap.channel),emissiveMapUv:vt&&f(y.emissiveMap.channel),metalnessMapUv:_n&&f(y.metalnessMap.channel),roughnessMapUv:Qt&&f(y.roughnessMap.channel),anisotropyMapUv:qe&&f(y.anisotropyMap.channel),clearcoatMapUv:C&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:be&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(y.sheenRoughnessMap.channel),specularMapUv:se&&f(y.specularMap.channel),specularColorMapUv:ye&&f(y.specularColorMap.channel),specularIntensityMapUv:U&&f(y.specularIntensityMap.channel),transmissionMapUv:oe&&f(y.transmissionMap.channel),thicknessMapUv:ie&&f(y.thicknessMap.channel),alphaMapUv:xe&&f(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(It||un),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(Ge||xe),fog:!!V,useFog:y.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&It===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:pe,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:fe,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:k.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:Ge&&y.map.isVideoTexture===!0&&xt.getTransfer(y.map.colorSpace)===Tt,decodeVideoTextureEmissive:vt&&y.emissiveMap.isVideoTexture===!0&&xt.getTransfer(y.emissiveMap.colorSpace)===Tt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Fi,flipSided:y.side===ri,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Ke&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&y.extensions.multiDraw===!0||Xe)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function _(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let N in y.defines)M.push(N),M.push(y.defines[N]);return y.isRawShaderMaterial===!1&&(g(M,y),p(M,y),M.push(i.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function g(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function p(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function v(y){let M=d[y.type],N;if(M){let I=oi[M];N=_l.clone(I.uniforms)}else N=y.uniforms;return N}function T(y,M){let N=u.get(M);return N!==void 0?++N.usedTimes:(N=new DT(i,M,y,s),c.push(N),u.set(M,N)),N}function x(y){if(--y.usedTimes===0){let M=c.indexOf(y);c[M]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function R(y){a.remove(y)}function w(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:v,acquireProgram:T,releaseProgram:x,releaseShaderCache:R,programs:c,dispose:w}}function OT(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function BT(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function d_(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function f_(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,_,g,p){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:g,group:p},i[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=m,v.materialVariant=o(d),v.groupOrder=_,v.renderOrder=d.renderOrder,v.z=g,v.group=p),e++,v}function l(d,f,m,_,g,p,v){v.reversedDepth===!0&&(g=-g);let T=a(d,f,m,_,g,p);m.transmission>0?n.push(T):m.transparent===!0?s.push(T):t.push(T)}function c(d,f,m,_,g,p){let v=a(d,f,m,_,g,p);m.transmission>0?n.unshift(v):m.transparent===!0?s.unshift(v):t.unshift(v)}function u(d,f){t.length>1&&t.sort(d||BT),n.length>1&&n.sort(f||d_),s.length>1&&s.sort(f||d_)}function h(){for(let d=e,f=i.length;d<f;d++){let m=i[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function kT(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new f_,i.set(n,[o])):s>=r.length?(o=new f_,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function zT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new B,color:new at};break;case"SpotLight":t={position:new B,direction:new B,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new B,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new B,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new B,halfWidth:new B,halfHeight:new B};break}return i[e.id]=t,t}}}function VT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var GT=0;function HT(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function WT(i){let e=new zT,t=VT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new B);let s=new B,r=new Ot,o=new Ot;function a(c){let u=0,h=0,d=0;for(let k=0;k<9;k++)n.probe[k].set(0,0,0);let f=0,m=0,_=0,g=0,p=0,v=0,T=0,x=0,R=0,w=0,y=0,M=0,N=0,I=0;c.sort(HT);for(let k=0,V=c.length;k<V;k++){let D=c[k],H=D.color,$=D.intensity,G=D.distance,le=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===gr?le=D.shadow.map.texture:le=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=H.r*$,h+=H.g*$,d+=H.b*$;else if(D.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(D.sh.coefficients[Y],$);I++}else if(D.isSunLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,te=t.get(D);te.shadowIntensity=K.intensity,te.shadowBias=K.bias,te.shadowNormalBias=K.normalBias,te.shadowRadius=K.radius,te.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),n.sunShadow[m]=te,n.sunShadowMap[m]=le;let fe=K.getViewportCount();for(let ue=0;ue<fe;ue++)n.sunShadowMatrix[_+ue]=K.getMatrix(ue),n.sunShadowCascade[_+ue]=K._cascadeData[ue];_+=fe,m++}n.sun[f]=Y,f++}else if(D.isDirectionalLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,te=t.get(D);te.shadowIntensity=K.intensity,te.shadowBias=K.bias,te.shadowNormalBias=K.normalBias,te.shadowRadius=K.radius,te.shadowMapSize=K.mapSize,n.directionalShadow[g]=te,n.directionalShadowMap[g]=le,n.directionalShadowMatrix[g]=D.shadow.matrix,R++}n.directional[g]=Y,g++}else if(D.isSpotLight){let Y=e.get(D);Y.position.setFromMatrixPosition(D.matrixWorld),Y.color.copy(H).multiplyScalar($),Y.distance=G,Y.coneCos=Math.cos(D.angle),Y.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Y.decay=D.decay,n.spot[v]=Y;let K=D.shadow;if(D.map&&(n.spotLightMap[M]=D.map,M++,K.updateMatrices(D),D.castShadow&&N++),n.spotLightMatrix[v]=K.matrix,D.castShadow){let te=t.get(D);te.shadowIntensity=K.intensity,te.shadowBias=K.bias,te.shadowNormalBias=K.normalBias,te.shadowRadius=K.radius,te.shadowMapSize=K.mapSize,n.spotShadow[v]=te,n.spotShadowMap[v]=le,y++}v++}else if(D.isRectAreaLight){let Y=e.get(D);Y.color.copy(H).multiplyScalar($),Y.halfWidth.set(D.width*.5,0,0),Y.halfHeight.set(0,D.height*.5,0),n.rectArea[T]=Y,T++}else if(D.isPointLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),Y.distance=D.distance,Y.decay=D.decay,D.castShadow){let K=D.shadow,te=t.get(D);te.shadowIntensity=K.intensity,te.shadowBias=K.bias,te.shadowNormalBias=K.normalBias,te.shadowRadius=K.radius,te.shadowMapSize=K.mapSize,te.shadowCameraNear=K.camera.near,te.shadowCameraFar=K.camera.far,n.pointShadow[p]=te,n.pointShadowMap[p]=le,n.pointShadowMatrix[p]=D.shadow.matrix,w++}n.point[p]=Y,p++}else if(D.isHemisphereLight){let Y=e.get(D);Y.skyColor.copy(D.color).multiplyScalar($),Y.groundColor.copy(D.groundColor).multiplyScalar($),n.hemi[x]=Y,x++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Pe.LTC_FLOAT_1,n.rectAreaLTC2=Pe.LTC_FLOAT_2):(n.rectAreaLTC1=Pe.LTC_HALF_1,n.rectAreaLTC2=Pe.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==g||L.pointLength!==p||L.spotLength!==v||L.rectAreaLength!==T||L.hemiLength!==x||L.numSunShadows!==m||L.numDirectionalShadows!==R||L.numPointShadows!==w||L.numSpotShadows!==y||L.numSpotMaps!==M||L.numLightProbes!==I)&&(n.sun.length=f,n.directional.length=g,n.spot.length=v,n.rectArea.length=T,n.point.length=p,n.hemi.length=x,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+M-N,n.spotLightMap.length=M,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=I,L.sunLength=f,L.directionalLength=g,L.pointLength=p,L.spotLength=v,L.rectAreaLength=T,L.hemiLength=x,L.numSunShadows=m,L.numDirectionalShadows=R,L.numPointShadows=w,L.numSpotShadows=y,L.numSpotMaps=M,L.numLightProbes=I,n.version=GT++)}function l(c,u){let h=0,d=0,f=0,m=0,_=0,g=0,p=u.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let x=c[v];if(x.isSunLight){let R=n.sun[h];R.direction.setFromMatrixPosition(x.matrixWorld),R.direction.transformDirection(p),h++}else if(x.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),d++}else if(x.isSpotLight){let R=n.spot[m];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),m++}else if(x.isRectAreaLight){let R=n.rectArea[_];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(x.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(x.width*.5,0,0),R.halfHeight.set(0,x.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),_++}else if(x.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(p),f++}else if(x.isHemisphereLight){let R=n.hemi[g];R.direction.setFromMatrixPosition(x.matrixWorld),R.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:n}}function p_(i){let e=new WT(i),t=[],n=[],s=[];function r(h){u.camera=h,t.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){n.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function XT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new p_(i),e.set(s,[a])):r>=o.length?(a=new p_(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var qT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$T=`uniform sampler2D shadow_pass;
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
}`,YT=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],ZT=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],m_=new Ot,xl=new B,jf=new B;function JT(i,e,t){let n=new or,s=new Ze,r=new Ze,o=new Rt,a=new su,l=new ru,c={},u=t.maxTextureSize,h={[mr]:ri,[ri]:mr,[Fi]:Fi},d=new Di({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ze},radius:{value:4}},vertexShader:qT,fragmentShader:$T}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new on;m.setAttribute("position",new rn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new kt(m,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Gr;let p=this.type;this.render=function(w,y,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||w.length===0)return;this.type===dy&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Gr);let N=i.getRenderTarget(),I=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),k=i.state;k.setBlending(Hr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let V=p!==this.type;V&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(H=>H.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,H=w.length;D<H;D++){let $=w[D],G=$.shadow;if(G===void 0){$e("WebGLShadowMap:",$,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let le=G.getFrameExtents();s.multiply(le),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,G.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Y,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Zo){if($.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Si(s.x,s.y,{format:gr,type:Qi,minFilter:si,magFilter:si,generateMipmaps:!1}),G.map.texture.name=$.name+".shadowMap",G.map.depthTexture=new Bs(s.x,s.y,Ki),G.map.depthTexture.name=$.name+".shadowMapDepth",G.map.depthTexture.format=Os,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Dn,G.map.depthTexture.magFilter=Dn}else $.isPointLight?(G.map=new bl(s.x),G.map.depthTexture=new $a(s.x,ji)):(G.map=new Si(s.x,s.y),G.map.depthTexture=new Bs(s.x,s.y,ji)),G.map.depthTexture.name=$.name+".shadowMap",G.map.depthTexture.format=Os,this.type===Gr?(G.map.depthTexture.compareFunction=Y?Of:Uf,G.map.depthTexture.minFilter=si,G.map.depthTexture.magFilter=si):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Dn,G.map.depthTexture.magFilter=Dn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let K=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();$.isPointLight!==!0&&G.updateMatrices($,M);let te=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:M.layers;for(let fe=0;fe<K;fe++){let ue=G.getCamera(fe);if($.isPointLight){let Q=G.camera,_e=G.matrix,re=$.distance||Q.far;re!==Q.far&&(Q.far=re,Q.updateProjectionMatrix()),xl.setFromMatrixPosition($.matrixWorld),Q.position.copy(xl),jf.copy(Q.position),jf.add(YT[fe]),Q.up.copy(ZT[fe]),Q.lookAt(jf),Q.updateMatrixWorld(),_e.makeTranslation(-xl.x,-xl.y,-xl.z),m_.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),G._frustum.setFromProjectionMatrix(m_,Q.coordinateSystem,Q.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,fe),i.clear();else{fe===0&&(i.setRenderTarget(G.map),i.clear());let Q=G.getViewport(fe);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),k.viewport(o)}n=G.getFrustum(fe),x(y,M,ue,$,te,this.type)}G.isPointLightShadow!==!0&&this.type===Zo&&v(G,M),G.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(N,I,L)};function v(w,y){let M=e.update(_);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new Si(s.x,s.y,{format:gr,type:Qi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(y,null,M,d,_,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(y,null,M,f,_,null)}function T(w,y,M,N){let I=null,L=M.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(L!==void 0)I=L;else if(I=M.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let k=I.uuid,V=y.uuid,D=c[k];D===void 0&&(D={},c[k]=D);let H=D[V];H===void 0&&(H=I.clone(),D[V]=H,y.addEventListener("dispose",R)),I=H}if(I.visible=y.visible,I.wireframe=y.wireframe,N===Zo?I.side=y.shadowSide!==null?y.shadowSide:y.side:I.side=y.shadowSide!==null?y.shadowSide:h[y.side],I.alphaMap=y.alphaMap,I.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,I.map=y.map,I.clipShadows=y.clipShadows,I.clippingPlanes=y.clippingPlanes,I.clipIntersection=y.clipIntersection,I.displacementMap=y.displacementMap,I.displacementScale=y.displacementScale,I.displacementBias=y.displacementBias,I.wireframeLinewidth=y.wireframeLinewidth,I.linewidth=y.linewidth,M.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let k=i.properties.get(I);k.light=M}return I}function x(w,y,M,N,I,L){if(w.visible===!1)return;if(w.layers.test(I)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&L===Zo)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,w.matrixWorld);let D=e.update(w),H=w.material;if(Array.isArray(H)){let $=D.groups;for(let G=0,le=$.length;G<le;G++){let Y=$[G],K=H[Y.materialIndex];if(K&&K.visible){let te=T(w,K,N,L);w.onBeforeShadow(i,w,y,M,D,te,Y),i.renderBufferDirect(M,null,D,te,w,Y),w.onAfterShadow(i,w,y,M,D,te,Y)}}}else if(H.visible){let $=T(w,H,N,L);w.onBeforeShadow(i,w,y,M,D,$,null),i.renderBufferDirect(M,null,D,$,w,null),w.onAfterShadow(i,w,y,M,D,$,null)}}let V=w.children;for(let D=0,H=V.length;D<H;D++)x(V[D],y,M,N,I,L)}function R(w){w.target.removeEventListener("dispose",R);for(let M in c){let N=c[M],I=w.target.uuid;I in N&&(N[I].dispose(),delete N[I])}}}function jT(i,e){function t(){let U=!1,oe=new Rt,ie=null,Ae=new Rt(0,0,0,0);return{setMask:function(xe){ie!==xe&&!U&&(i.colorMask(xe,xe,xe,xe),ie=xe)},setLocked:function(xe){U=xe},setClear:function(xe,Me,He,Ke,he){he===!0&&(xe*=Ke,Me*=Ke,He*=Ke),oe.set(xe,Me,He,Ke),Ae.equals(oe)===!1&&(i.clearColor(xe,Me,He,Ke),Ae.copy(oe))},reset:function(){U=!1,ie=null,Ae.set(-1,0,0,0)}}}function n(){let U=!1,oe=!1,ie=null,Ae=null,xe=null;return{setReversed:function(Me){if(oe!==Me){let He=e.get("EXT_clip_control");Me?He.clipControlEXT(He.LOWER_LEFT_EXT,He.ZERO_TO_ONE_EXT):He.clipControlEXT(He.LOWER_LEFT_EXT,He.NEGATIVE_ONE_TO_ONE_EXT),oe=Me;let Ke=xe;xe=null,this.setClear(Ke)}},getReversed:function(){return oe},setTest:function(Me){Me?pe(i.DEPTH_TEST):Oe(i.DEPTH_TEST)},setMask:function(Me){ie!==Me&&!U&&(i.depthMask(Me),ie=Me)},setFunc:function(Me){if(oe&&(Me=Xy[Me]),Ae!==Me){switch(Me){case kc:i.depthFunc(i.NEVER);break;case zc:i.depthFunc(i.ALWAYS);break;case Vc:i.depthFunc(i.LESS);break;case ko:i.depthFunc(i.LEQUAL);break;case Gc:i.depthFunc(i.EQUAL);break;case Hc:i.depthFunc(i.GEQUAL);break;case Wc:i.depthFunc(i.GREATER);break;case Xc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ae=Me}},setLocked:function(Me){U=Me},setClear:function(Me){xe!==Me&&(xe=Me,oe&&(Me=1-Me),i.clearDepth(Me))},reset:function(){U=!1,ie=null,Ae=null,xe=null,oe=!1}}}function s(){let U=!1,oe=null,ie=null,Ae=null,xe=null,Me=null,He=null,Ke=null,he=null;return{setTest:function(Be){U||(Be?pe(i.STENCIL_TEST):Oe(i.STENCIL_TEST))},setMask:function(Be){oe!==Be&&!U&&(i.stencilMask(Be),oe=Be)},setFunc:function(Be,Qe,Re){(ie!==Be||Ae!==Qe||xe!==Re)&&(i.stencilFunc(Be,Qe,Re),ie=Be,Ae=Qe,xe=Re)},setOp:function(Be,Qe,Re){(Me!==Be||He!==Qe||Ke!==Re)&&(i.stencilOp(Be,Qe,Re),Me=Be,He=Qe,Ke=Re)},setLocked:function(Be){U=Be},setClear:function(Be){he!==Be&&(i.clearStencil(Be),he=Be)},reset:function(){U=!1,oe=null,ie=null,Ae=null,xe=null,Me=null,He=null,Ke=null,he=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,m=[],_=null,g=!1,p=null,v=null,T=null,x=null,R=null,w=null,y=null,M=new at(0,0,0),N=0,I=!1,L=null,k=null,V=null,D=null,H=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,le=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Y)[1]),G=le>=1):Y.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),G=le>=2);let K=null,te={},fe=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),Q=new Rt().fromArray(fe),_e=new Rt().fromArray(ue);function re(U,oe,ie,Ae){let xe=new Uint8Array(4),Me=i.createTexture();i.bindTexture(U,Me),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let He=0;He<ie;He++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(oe,0,i.RGBA,1,1,Ae,0,i.RGBA,i.UNSIGNED_BYTE,xe):i.texImage2D(oe+He,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xe);return Me}let me={};me[i.TEXTURE_2D]=re(i.TEXTURE_2D,i.TEXTURE_2D,1),me[i.TEXTURE_CUBE_MAP]=re(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),me[i.TEXTURE_2D_ARRAY]=re(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),me[i.TEXTURE_3D]=re(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),pe(i.DEPTH_TEST),o.setFunc(ko),cn(!1),It(mf),pe(i.CULL_FACE),Yt(Hr);function pe(U){u[U]!==!0&&(i.enable(U),u[U]=!0)}function Oe(U){u[U]!==!1&&(i.disable(U),u[U]=!1)}function Xe(U,oe){return d[U]!==oe?(i.bindFramebuffer(U,oe),d[U]=oe,U===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=oe),U===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=oe),!0):!1}function Ge(U,oe){let ie=m,Ae=!1;if(U){ie=f.get(oe),ie===void 0&&(ie=[],f.set(oe,ie));let xe=U.textures;if(ie.length!==xe.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let Me=0,He=xe.length;Me<He;Me++)ie[Me]=i.COLOR_ATTACHMENT0+Me;ie.length=xe.length,Ae=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,Ae=!0);Ae&&i.drawBuffers(ie)}function dt(U){return _!==U?(i.useProgram(U),_=U,!0):!1}let ct={[Wr]:i.FUNC_ADD,[py]:i.FUNC_SUBTRACT,[my]:i.FUNC_REVERSE_SUBTRACT};ct[gy]=i.MIN,ct[yy]=i.MAX;let it={[_y]:i.ZERO,[xy]:i.ONE,[vy]:i.SRC_COLOR,[xf]:i.SRC_ALPHA,[Ey]:i.SRC_ALPHA_SATURATE,[wy]:i.DST_COLOR,[Sy]:i.DST_ALPHA,[by]:i.ONE_MINUS_SRC_COLOR,[vf]:i.ONE_MINUS_SRC_ALPHA,[Ay]:i.ONE_MINUS_DST_COLOR,[My]:i.ONE_MINUS_DST_ALPHA,[Ty]:i.CONSTANT_COLOR,[Ry]:i.ONE_MINUS_CONSTANT_COLOR,[Cy]:i.CONSTANT_ALPHA,[Py]:i.ONE_MINUS_CONSTANT_ALPHA};function Yt(U,oe,ie,Ae,xe,Me,He,Ke,he,Be){if(U===Hr){g===!0&&(Oe(i.BLEND),g=!1);return}if(g===!1&&(pe(i.BLEND),g=!0),U!==fy){if(U!==p||Be!==I){if((v!==Wr||R!==Wr)&&(i.blendEquation(i.FUNC_ADD),v=Wr,R=Wr),Be)switch(U){case Jo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case gf:i.blendFunc(i.ONE,i.ONE);break;case yf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case _f:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:tt("WebGLState: Invalid blending: ",U);break}else switch(U){case Jo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case gf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case yf:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case _f:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",U);break}T=null,x=null,w=null,y=null,M.set(0,0,0),N=0,p=U,I=Be}return}xe=xe||oe,Me=Me||ie,He=He||Ae,(oe!==v||xe!==R)&&(i.blendEquationSeparate(ct[oe],ct[xe]),v=oe,R=xe),(ie!==T||Ae!==x||Me!==w||He!==y)&&(i.blendFuncSeparate(it[ie],it[Ae],it[Me],it[He]),T=ie,x=Ae,w=Me,y=He),(Ke.equals(M)===!1||he!==N)&&(i.blendColor(Ke.r,Ke.g,Ke.b,he),M.copy(Ke),N=he),p=U,I=!1}function Vt(U,oe){U.side===Fi?Oe(i.CULL_FACE):pe(i.CULL_FACE);let ie=U.side===ri;oe&&(ie=!ie),cn(ie),U.blending===Jo&&U.transparent===!1?Yt(Hr):Yt(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let Ae=U.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),vt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?pe(i.SAMPLE_ALPHA_TO_COVERAGE):Oe(i.SAMPLE_ALPHA_TO_COVERAGE)}function cn(U){L!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),L=U)}function It(U){U!==uy?(pe(i.CULL_FACE),U!==k&&(U===mf?i.cullFace(i.BACK):U===hy?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Oe(i.CULL_FACE),k=U}function An(U){U!==V&&(G&&i.lineWidth(U),V=U)}function vt(U,oe,ie){U?(pe(i.POLYGON_OFFSET_FILL),(D!==oe||H!==ie)&&(D=oe,H=ie,o.getReversed()&&(oe=-oe,ie=-ie),i.polygonOffset(oe,ie))):Oe(i.POLYGON_OFFSET_FILL)}function _n(U){U?pe(i.SCISSOR_TEST):Oe(i.SCISSOR_TEST)}function Qt(U){U===void 0&&(U=i.TEXTURE0+$-1),K!==U&&(i.activeTexture(U),K=U)}function un(U,oe,ie){ie===void 0&&(K===null?ie=i.TEXTURE0+$-1:ie=K);let Ae=te[ie];Ae===void 0&&(Ae={type:void 0,texture:void 0},te[ie]=Ae),(Ae.type!==U||Ae.texture!==oe)&&(K!==ie&&(i.activeTexture(ie),K=ie),i.bindTexture(U,oe||me[U]),Ae.type=U,Ae.texture=oe)}function O(){let U=te[K];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Ce(){try{i.compressedTexImage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function Ye(){try{i.compressedTexImage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function rt(){try{i.texSubImage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function we(){try{i.texSubImage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function Ft(){try{i.compressedTexSubImage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function qe(){try{i.texStorage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function C(){try{i.texStorage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function S(){try{i.texImage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function q(){try{i.texImage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function de(U){return h[U]!==void 0?h[U]:i.getParameter(U)}function ae(U,oe){h[U]!==oe&&(i.pixelStorei(U,oe),h[U]=oe)}function ve(U){Q.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),Q.copy(U))}function be(U){_e.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),_e.copy(U))}function ne(U,oe){let ie=c.get(oe);ie===void 0&&(ie=new WeakMap,c.set(oe,ie));let Ae=ie.get(U);Ae===void 0&&(Ae=i.getUniformBlockIndex(oe,U.name),i.uniformBlockBinding(oe,Ae,Ae),ie.set(U,Ae))}function se(U,oe,ie){let xe=c.get(oe).get(U);l[xe]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,xe,ie),l[xe]=ie)}function ye(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},K=null,te={},d={},l={},f=new WeakMap,m=[],_=null,g=!1,p=null,v=null,T=null,x=null,R=null,w=null,y=null,M=new at(0,0,0),N=0,I=!1,L=null,k=null,V=null,D=null,H=null,Q.set(0,0,i.canvas.width,i.canvas.height),_e.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:pe,disable:Oe,bindFramebuffer:Xe,drawBuffers:Ge,useProgram:dt,setBlending:Yt,setMaterial:Vt,setFlipSided:cn,setCullFace:It,setLineWidth:An,setPolygonOffset:vt,setScissorTest:_n,activeTexture:Qt,bindTexture:un,unbindTexture:O,compressedTexImage2D:Ce,compressedTexImage3D:Ye,texImage2D:S,texImage3D:q,pixelStorei:ae,getParameter:de,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:qe,texStorage3D:C,texSubImage2D:rt,texSubImage3D:we,compressedTexSubImage2D:Ft,compressedTexSubImage3D:Ve,scissor:ve,viewport:be,reset:ye}}function KT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ze,u=new WeakMap,h=new Set,d,f=new WeakMap,m=new Set,_=new FinalizationRegistry(C=>m.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,S){return g?new OffscreenCanvas(C,S):Ba("canvas")}function v(C,S,q){let de=1,ae=qe(C);if((ae.width>q||ae.height>q)&&(de=q/Math.max(ae.width,ae.height)),de<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ve=Math.floor(de*ae.width),be=Math.floor(de*ae.height);d===void 0&&(d=p(ve,be));let ne=S?p(ve,be):d;return ne.width=ve,ne.height=be,ne.getContext("2d").drawImage(C,0,0,ve,be),$e("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ve+"x"+be+")."),ne}else return"data"in C&&$e("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),C;return C}function T(C){return C.generateMipmaps}function x(C){i.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(C,S,q,de,ae,ve=!1){if(C!==null){if(i[C]!==void 0)return i[C];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let be;de&&(be=e.get("EXT_texture_norm16"),be||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=S;if(S===i.RED&&(q===i.FLOAT&&(ne=i.R32F),q===i.HALF_FLOAT&&(ne=i.R16F),q===i.UNSIGNED_BYTE&&(ne=i.R8),q===i.UNSIGNED_SHORT&&be&&(ne=be.R16_EXT),q===i.SHORT&&be&&(ne=be.R16_SNORM_EXT)),S===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(ne=i.R8UI),q===i.UNSIGNED_SHORT&&(ne=i.R16UI),q===i.UNSIGNED_INT&&(ne=i.R32UI),q===i.BYTE&&(ne=i.R8I),q===i.SHORT&&(ne=i.R16I),q===i.INT&&(ne=i.R32I)),S===i.RG&&(q===i.FLOAT&&(ne=i.RG32F),q===i.HALF_FLOAT&&(ne=i.RG16F),q===i.UNSIGNED_BYTE&&(ne=i.RG8),q===i.UNSIGNED_SHORT&&be&&(ne=be.RG16_EXT),q===i.SHORT&&be&&(ne=be.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(ne=i.RG8UI),q===i.UNSIGNED_SHORT&&(ne=i.RG16UI),q===i.UNSIGNED_INT&&(ne=i.RG32UI),q===i.BYTE&&(ne=i.RG8I),q===i.SHORT&&(ne=i.RG16I),q===i.INT&&(ne=i.RG32I)),S===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),q===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),q===i.UNSIGNED_INT&&(ne=i.RGB32UI),q===i.BYTE&&(ne=i.RGB8I),q===i.SHORT&&(ne=i.RGB16I),q===i.INT&&(ne=i.RGB32I)),S===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),q===i.UNSIGNED_INT&&(ne=i.RGBA32UI),q===i.BYTE&&(ne=i.RGBA8I),q===i.SHORT&&(ne=i.RGBA16I),q===i.INT&&(ne=i.RGBA32I)),S===i.RGB&&(q===i.UNSIGNED_SHORT&&be&&(ne=be.RGB16_EXT),q===i.SHORT&&be&&(ne=be.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),S===i.RGBA){let se=ve?Oa:xt.getTransfer(ae);q===i.FLOAT&&(ne=i.RGBA32F),q===i.HALF_FLOAT&&(ne=i.RGBA16F),q===i.UNSIGNED_BYTE&&(ne=se===Tt?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&be&&(ne=be.RGBA16_EXT),q===i.SHORT&&be&&(ne=be.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function y(C,S){let q;return C?S===null||S===ji||S===qr?q=i.DEPTH24_STENCIL8:S===Ki?q=i.DEPTH32F_STENCIL8:S===Ko&&(q=i.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===ji||S===qr?q=i.DEPTH_COMPONENT24:S===Ki?q=i.DEPTH_COMPONENT32F:S===Ko&&(q=i.DEPTH_COMPONENT16),q}function M(C,S){return T(C)===!0||C.isFramebufferTexture&&C.minFilter!==Dn&&C.minFilter!==si?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function N(C){let S=new WeakRef(C);n.get(C).__ref=S,m.add(S),_.register(C,S,S)}function I(C){let S=n.get(C).__ref;S!==void 0&&(m.delete(S),_.unregister(S))}function L(C){V(C.target)}function k(C){D(C.target)}function V(C){C.removeEventListener("dispose",L),I(C),$(C),C.isVideoTexture&&u.delete(C),C.isHTMLTexture&&h.delete(C)}function D(C){C.removeEventListener("dispose",k),I(C),le(C)}function H(){for(let C of m){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?D(S):V(S))}m.clear(),h.clear()}function $(C){let S=n.get(C);if(S.__webglInit===void 0)return;let q=C.source,de=f.get(q);if(de){let ae=de[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&G(C),Object.keys(de).length===0&&f.delete(q)}n.remove(C)}function G(C){let S=n.get(C);i.deleteTexture(S.__webglTexture);let q=C.source,de=f.get(q);delete de[S.__cacheKey],o.memory.textures--}function le(C){let S=n.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=C.depthTexture;if(q&&q.renderTarget===C&&V(q),C.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let ve=0;ve<S.__webglFramebuffer[ae].length;ve++)i.deleteFramebuffer(S.__webglFramebuffer[ae][ve]);else i.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)i.deleteFramebuffer(S.__webglFramebuffer[ae]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let de=C.textures;for(let ae=0,ve=de.length;ae<ve;ae++){let be=n.get(de[ae]);be.__webglTexture&&(i.deleteTexture(be.__webglTexture),o.memory.textures--),n.remove(de[ae])}n.remove(C)}let Y=0;function K(){Y=0}function te(){return Y}function fe(C){Y=C}function ue(){let C=Y;return C>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,C}function Q(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function _e(C,S){let q=n.get(C);if(C.isVideoTexture&&Ft(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&q.__version!==C.version){let de=C.image;if(de===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt(q,C,S);return}}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+S)}function re(C,S){let q=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Vt(q,C,S);return}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+S)}function me(C,S){let q=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Vt(q,C,S);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+S)}function pe(C,S){let q=n.get(C);if(C.version>0&&q.__version!==C.version){cn(q,C,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+S)}let Oe={[qc]:i.REPEAT,[ps]:i.CLAMP_TO_EDGE,[$c]:i.MIRRORED_REPEAT},Xe={[Dn]:i.NEAREST,[Dy]:i.NEAREST_MIPMAP_NEAREST,[ul]:i.NEAREST_MIPMAP_LINEAR,[si]:i.LINEAR,[bu]:i.LINEAR_MIPMAP_NEAREST,[ks]:i.LINEAR_MIPMAP_LINEAR},Ge={[Oy]:i.NEVER,[Bf]:i.ALWAYS,[By]:i.LESS,[Uf]:i.LEQUAL,[ky]:i.EQUAL,[Of]:i.GEQUAL,[zy]:i.GREATER,[Vy]:i.NOTEQUAL};function dt(C,S){if(S.type===Ki&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===si||S.magFilter===bu||S.magFilter===ul||S.magFilter===ks||S.minFilter===si||S.minFilter===bu||S.minFilter===ul||S.minFilter===ks)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,Oe[S.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Oe[S.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Oe[S.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,Xe[S.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,Xe[S.minFilter]),S.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Ge[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Dn||S.minFilter!==ul&&S.minFilter!==ks||S.type===Ki&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ct(C,S){let q=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",L),N(S));let de=S.source,ae=f.get(de);ae===void 0&&(ae={},f.set(de,ae));let ve=Q(S);if(ve!==C.__cacheKey){ae[ve]===void 0&&(ae[ve]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[ve].usedTimes++;let be=ae[C.__cacheKey];be!==void 0&&(ae[C.__cacheKey].usedTimes--,be.usedTimes===0&&G(S)),C.__cacheKey=ve,C.__webglTexture=ae[ve].texture}return q}function it(C,S,q){return Math.floor(Math.floor(C/q)/S)}function Yt(C,S,q,de){let ve=C.updateRanges;if(ve.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,q,de,S.data);else{ve.sort((U,oe)=>U.start-oe.start);let be=0;for(let U=1;U<ve.length;U++){let oe=ve[be],ie=ve[U],Ae=oe.start+oe.count,xe=it(ie.start,S.width,4),Me=it(oe.start,S.width,4);ie.start<=Ae+1&&xe===Me&&it(ie.start+ie.count-1,S.width,4)===xe?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++be,ve[be]=ie)}ve.length=be+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),ye=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let U=0,oe=ve.length;U<oe;U++){let ie=ve[U],Ae=Math.floor(ie.start/4),xe=Math.ceil(ie.count/4),Me=Ae%S.width,He=Math.floor(Ae/S.width),Ke=xe,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(i.UNPACK_SKIP_ROWS,He),t.texSubImage2D(i.TEXTURE_2D,0,Me,He,Ke,he,q,de,S.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,ye)}}function Vt(C,S,q){let de=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(de=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(de=i.TEXTURE_3D);let ae=ct(C,S),ve=S.source;t.bindTexture(de,C.__webglTexture,i.TEXTURE0+q);let be=n.get(ve);if(ve.version!==be.__version||ae===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let he=xt.getPrimaries(xt.workingColorSpace),Be=S.colorSpace===Vs?null:xt.getPrimaries(S.colorSpace),Qe=S.colorSpace===Vs||he===Be?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let se=v(S.image,!1,s.maxTextureSize);se=Ve(S,se);let ye=r.convert(S.format,S.colorSpace),U=r.convert(S.type),oe=w(S.internalFormat,ye,U,S.normalized,S.colorSpace,S.isVideoTexture);dt(de,S);let ie,Ae=S.mipmaps,xe=S.isVideoTexture!==!0,Me=be.__version===void 0||ae===!0,He=ve.dataReady,Ke=M(S,se);if(S.isDepthTexture)oe=y(S.format===zs,S.type),Me&&(xe?t.texStorage2D(i.TEXTURE_2D,1,oe,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,ye,U,null));else if(S.isDataTexture)if(Ae.length>0){xe&&Me&&t.texStorage2D(i.TEXTURE_2D,Ke,oe,Ae[0].width,Ae[0].height);for(let he=0,Be=Ae.length;he<Be;he++)ie=Ae[he],xe?He&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,ye,U,ie.data):t.texImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,ye,U,ie.data);S.generateMipmaps=!1}else xe?(Me&&t.texStorage2D(i.TEXTURE_2D,Ke,oe,se.width,se.height),He&&Yt(S,se,ye,U)):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,ye,U,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){xe&&Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,oe,Ae[0].width,Ae[0].height,se.depth);for(let he=0,Be=Ae.length;he<Be;he++)if(ie=Ae[he],S.format!==es)if(ye!==null)if(xe){if(He)if(S.layerUpdates.size>0){let Qe=Zf(ie.width,ie.height,S.format,S.type);for(let Re of S.layerUpdates){let lt=ie.data.subarray(Re*Qe/ie.data.BYTES_PER_ELEMENT,(Re+1)*Qe/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Re,ie.width,ie.height,1,ye,lt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,se.depth,ye,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,oe,ie.width,ie.height,se.depth,0,ie.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?He&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,se.depth,ye,U,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,oe,ie.width,ie.height,se.depth,0,ye,U,ie.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{xe&&Me&&t.texStorage2D(i.TEXTURE_2D,Ke,oe,Ae[0].width,Ae[0].height);for(let he=0,Be=Ae.length;he<Be;he++)ie=Ae[he],S.format!==es?ye!==null?xe?He&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,ye,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,ie.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?He&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,ye,U,ie.data):t.texImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,ye,U,ie.data)}else if(S.isDataArrayTexture)if(xe){if(Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,oe,se.width,se.height,se.depth),He)if(S.layerUpdates.size>0){let he=Zf(se.width,se.height,S.format,S.type);for(let Be of S.layerUpdates){let Qe=se.data.subarray(Be*he/se.data.BYTES_PER_ELEMENT,(Be+1)*he/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,ye,U,Qe)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,ye,U,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,oe,se.width,se.height,se.depth,0,ye,U,se.data);else if(S.isData3DTexture)xe?(Me&&t.texStorage3D(i.TEXTURE_3D,Ke,oe,se.width,se.height,se.depth),He&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,ye,U,se.data)):t.texImage3D(i.TEXTURE_3D,0,oe,se.width,se.height,se.depth,0,ye,U,se.data);else if(S.isFramebufferTexture){if(Me)if(xe)t.texStorage2D(i.TEXTURE_2D,Ke,oe,se.width,se.height);else{let he=se.width,Be=se.height;for(let Qe=0;Qe<Ke;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,oe,he,Be,0,ye,U,null),he>>=1,Be>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),se.parentNode!==he){he.appendChild(se),h.add(S),he.onpaint=Be=>{let Qe=Be.changedElements;for(let Re of h)Qe.includes(Re.image)&&(Re.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Qe=i.RGBA,Re=i.RGBA,lt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,Re,lt,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(xe&&Me){let he=qe(Ae[0]);t.texStorage2D(i.TEXTURE_2D,Ke,oe,he.width,he.height)}for(let he=0,Be=Ae.length;he<Be;he++)ie=Ae[he],xe?He&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ye,U,ie):t.texImage2D(i.TEXTURE_2D,he,oe,ye,U,ie);S.generateMipmaps=!1}else if(xe){if(Me){let he=qe(se);t.texStorage2D(i.TEXTURE_2D,Ke,oe,he.width,he.height)}He&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ye,U,se)}else t.texImage2D(i.TEXTURE_2D,0,oe,ye,U,se);T(S)&&S.mipmapsAutoUpdate===!0&&x(de),be.__version=ve.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function cn(C,S,q){if(S.image.length!==6)return;let de=ct(C,S),ae=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+q);let ve=n.get(ae);if(ae.version!==ve.__version||de===!0){t.activeTexture(i.TEXTURE0+q);let be=xt.getPrimaries(xt.workingColorSpace),ne=S.colorSpace===Vs?null:xt.getPrimaries(S.colorSpace),se=S.colorSpace===Vs||be===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let ye=S.isCompressedTexture||S.image[0].isCompressedTexture,U=S.image[0]&&S.image[0].isDataTexture,oe=[];for(let Re=0;Re<6;Re++)!ye&&!U?oe[Re]=v(S.image[Re],!0,s.maxCubemapSize):oe[Re]=U?S.image[Re].image:S.image[Re],oe[Re]=Ve(S,oe[Re]);let ie=oe[0],Ae=r.convert(S.format,S.colorSpace),xe=r.convert(S.type),Me=w(S.internalFormat,Ae,xe,S.normalized,S.colorSpace),He=S.isVideoTexture!==!0,Ke=ve.__version===void 0||de===!0,he=ae.dataReady,Be=M(S,ie);dt(i.TEXTURE_CUBE_MAP,S);let Qe;if(S.isDepthTexture){if(Me=y(S.format===zs,S.type),Ke)if(He)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Me,ie.width,ie.height);else for(let Re=0;Re<6;Re++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,ie.width,ie.height,0,Ae,xe,null)}else if(ye){He&&Ke&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Me,ie.width,ie.height);for(let Re=0;Re<6;Re++){Qe=oe[Re].mipmaps;for(let lt=0;lt<Qe.length;lt++){let Gt=Qe[lt];S.format!==es?Ae!==null?He?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Gt.width,Gt.height,Ae,Gt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Me,Gt.width,Gt.height,0,Gt.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Gt.width,Gt.height,Ae,xe,Gt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Me,Gt.width,Gt.height,0,Ae,xe,Gt.data)}}}else{if(Qe=S.mipmaps,He&&Ke){Qe.length>0&&Be++;let Re=qe(oe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Me,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(U){He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,oe[Re].width,oe[Re].height,Ae,xe,oe[Re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,oe[Re].width,oe[Re].height,0,Ae,xe,oe[Re].data);for(let lt=0;lt<Qe.length;lt++){let Zn=Qe[lt].image[Re].image;He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Zn.width,Zn.height,Ae,xe,Zn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Me,Zn.width,Zn.height,0,Ae,xe,Zn.data)}}else{He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ae,xe,oe[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,Ae,xe,oe[Re]);for(let lt=0;lt<Qe.length;lt++){let Gt=Qe[lt];He?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Ae,xe,Gt.image[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Me,Ae,xe,Gt.image[Re])}}}T(S)&&S.mipmapsAutoUpdate===!0&&x(i.TEXTURE_CUBE_MAP),ve.__version=ae.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function It(C,S,q,de,ae,ve){let be=r.convert(q.format,q.colorSpace),ne=r.convert(q.type),se=w(q.internalFormat,be,ne,q.normalized,q.colorSpace),ye=n.get(S),U=n.get(q);if(U.__renderTarget=S,!ye.__hasExternalTextures){let oe=Math.max(1,S.width>>ve),ie=Math.max(1,S.height>>ve);ae===i.TEXTURE_3D||ae===i.TEXTURE_2D_ARRAY?t.texImage3D(ae,ve,se,oe,ie,S.depth,0,be,ne,null):t.texImage2D(ae,ve,se,oe,ie,0,be,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,de,ae,U.__webglTexture,0,rt(S)):(ae===i.TEXTURE_2D||ae>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,de,ae,U.__webglTexture,ve),t.bindFramebuffer(i.FRAMEBUFFER,null)}function An(C,S,q){if(i.bindRenderbuffer(i.RENDERBUFFER,C),S.depthBuffer){let de=S.depthTexture,ae=de&&de.isDepthTexture?de.type:null,ve=y(S.stencilBuffer,ae),be=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,rt(S),ve,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,rt(S),ve,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ve,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,be,i.RENDERBUFFER,C)}else{let de=S.textures;for(let ae=0;ae<de.length;ae++){let ve=de[ae],be=r.convert(ve.format,ve.colorSpace),ne=r.convert(ve.type),se=w(ve.internalFormat,be,ne,ve.normalized,ve.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,rt(S),se,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,rt(S),se,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,se,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function vt(C,S,q){let de=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=n.get(S.depthTexture);ae.__renderTarget=S;let ve=de?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||ve.width!==S.width||ve.height!==S.height)&&(ve.width=S.width,ve.height=S.height,S.depthTexture.needsUpdate=!0),de?pe(S.depthTexture,0):_e(S.depthTexture,0);let be=ae.__webglTexture,ne=rt(S),se=de?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,ye=S.depthTexture.format===zs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Os)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ye,se,be,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,ye,se,be,0);else if(S.depthTexture.format===zs)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ye,se,be,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,ye,se,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(C){let S=n.get(C),q=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let de=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),de){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,de.removeEventListener("dispose",ae)};de.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=de}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let de=0;de<6;de++)vt(S.__webglFramebuffer[de],C,de);else C.texture.mipmaps.length>0?vt(S.__webglFramebuffer[0],C,0):vt(S.__webglFramebuffer,C,0);else if(q){S.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[de]),S.__webglDepthbuffer[de]===void 0)S.__webglDepthbuffer[de]=i.createRenderbuffer(),An(S.__webglDepthbuffer[de],C,!1);else{let ae=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer[de];i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,ve)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),An(S.__webglDepthbuffer,C,!1);else{let ae=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,ve)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Qt(C,S,q){let de=n.get(C);S!==void 0&&It(de.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&_n(C)}function un(C){let S=C.texture,q=n.get(C),de=n.get(S);C.addEventListener("dispose",k),N(C);let ae=C.textures,ve=C.isWebGLCubeRenderTarget===!0,be=ae.length>1;if(be||(de.__webglTexture===void 0&&(de.__webglTexture=i.createTexture()),de.__version=S.version,o.memory.textures++),ve){q.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0){q.__webglFramebuffer[ne]=[];for(let se=0;se<S.mipmaps.length;se++)q.__webglFramebuffer[ne][se]=i.createFramebuffer()}else q.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let ne=0;ne<S.mipmaps.length;ne++)q.__webglFramebuffer[ne]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(be)for(let ne=0,se=ae.length;ne<se;ne++){let ye=n.get(ae[ne]);ye.__webglTexture===void 0&&(ye.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&we(C)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let se=ae[ne];q.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[ne]);let ye=r.convert(se.format,se.colorSpace),U=r.convert(se.type),oe=w(se.internalFormat,ye,U,se.normalized,se.colorSpace,C.isXRRenderTarget===!0),ie=rt(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,oe,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,q.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),An(q.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ve){t.bindTexture(i.TEXTURE_CUBE_MAP,de.__webglTexture),dt(i.TEXTURE_CUBE_MAP,S);for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)It(q.__webglFramebuffer[ne][se],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else It(q.__webglFramebuffer[ne],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);T(S)?x(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(be){for(let ne=0,se=ae.length;ne<se;ne++){let ye=ae[ne],U=n.get(ye),oe=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(oe=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(oe,U.__webglTexture),dt(oe,ye),It(q.__webglFramebuffer,C,ye,i.COLOR_ATTACHMENT0+ne,oe,0),T(ye)&&x(oe)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ne=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,de.__webglTexture),dt(ne,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)It(q.__webglFramebuffer[se],C,S,i.COLOR_ATTACHMENT0,ne,se);else It(q.__webglFramebuffer,C,S,i.COLOR_ATTACHMENT0,ne,0);T(S)?x(ne):S.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&_n(C)}function O(C){let S=C.textures;for(let q=0,de=S.length;q<de;q++){let ae=S[q];if(T(ae)&&ae.mipmapsAutoUpdate===!0){let ve=R(C),be=n.get(ae).__webglTexture;t.bindTexture(ve,be),x(ve),t.unbindTexture()}}}let Ce=[];function Ye(C){if(C.samples>0){if(we(C)===!1){let S=C.textures,q=C.width,de=C.height,ae=i.COLOR_BUFFER_BIT,ve=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=n.get(C),ne=S.length>1;if(ne)for(let ye=0;ye<S.length;ye++)t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let ye=0;ye<S.length;ye++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(ae|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(ae|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,be.__webglColorRenderbuffer[ye]);let U=n.get(S[ye]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,q,de,0,0,q,de,ae,i.NEAREST),l===!0&&(Ce.length=0,Ce.push(i.COLOR_ATTACHMENT0+ye),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(ve),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let ye=0;ye<S.length;ye++){t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.RENDERBUFFER,be.__webglColorRenderbuffer[ye]);let U=n.get(S[ye]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.TEXTURE_2D,U,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let S=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function rt(C){return Math.min(s.maxSamples,C.samples)}function we(C){let S=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Ft(C){let S=o.render.frame;u.get(C)!==S&&(u.set(C,S),C.update())}function Ve(C,S){let q=C.colorSpace,de=C.format,ae=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||q!==Ua&&q!==Vs&&(xt.getTransfer(q)===Tt?(de!==es||ae!==li)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",q)),S}function qe(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=K,this.getTextureUnits=te,this.setTextureUnits=fe,this.setTexture2D=_e,this.setTexture2DArray=re,this.setTexture3D=me,this.setTextureCube=pe,this.rebindTextures=Qt,this.setupRenderTarget=un,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=It,this.useMultisampledRTT=we,this.dispose=H}function QT(i,e){function t(n,s=Vs){let r,o=xt.getTransfer(s);if(n===li)return i.UNSIGNED_BYTE;if(n===Mu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===wu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Lf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===If)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Cf)return i.BYTE;if(n===Pf)return i.SHORT;if(n===Ko)return i.UNSIGNED_SHORT;if(n===Su)return i.INT;if(n===ji)return i.UNSIGNED_INT;if(n===Ki)return i.FLOAT;if(n===Qi)return i.HALF_FLOAT;if(n===Df)return i.ALPHA;if(n===Ff)return i.RGB;if(n===es)return i.RGBA;if(n===Os)return i.DEPTH_COMPONENT;if(n===zs)return i.DEPTH_STENCIL;if(n===Nf)return i.RED;if(n===Au)return i.RED_INTEGER;if(n===gr)return i.RG;if(n===Eu)return i.RG_INTEGER;if(n===Tu)return i.RGBA_INTEGER;if(n===hl||n===dl||n===fl||n===pl)if(o===Tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===hl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===hl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===dl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===fl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===pl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ru||n===Cu||n===Pu||n===Lu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Ru)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Cu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Pu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Lu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Iu||n===Du||n===Fu||n===Nu||n===Uu||n===ml||n===Ou)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Iu||n===Du)return o===Tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Fu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Nu)return r.COMPRESSED_R11_EAC;if(n===Uu)return r.COMPRESSED_SIGNED_R11_EAC;if(n===ml)return r.COMPRESSED_RG11_EAC;if(n===Ou)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Bu||n===ku||n===zu||n===Vu||n===Gu||n===Hu||n===Wu||n===Xu||n===qu||n===$u||n===Yu||n===Zu||n===Ju||n===ju)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Bu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ku)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===zu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Vu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Gu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Hu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Wu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Xu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===qu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===$u)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Yu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Zu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ju)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ju)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ku||n===Qu||n===eh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Ku)return o===Tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Qu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===eh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===th||n===nh||n===gl||n===ih)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===th)return r.COMPRESSED_RED_RGTC1_EXT;if(n===nh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===gl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ih)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===qr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var eR=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,tR=`
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

}`,sp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ya(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Di({vertexShader:eR,fragmentShader:tR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new kt(new kr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},rp=class extends Yi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,m=null,_=typeof XRWebGLBinding<"u",g=new sp,p={},v=t.getContextAttributes(),T=null,x=null,R=[],w=[],y=new Ze,M=null,N=null,I=new ii;I.viewport=new Rt;let L=new ii;L.viewport=new Rt;let k=[I,L],V=new yu,D=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let _e=R[Q];return _e===void 0&&(_e=new Wo,R[Q]=_e),_e.getTargetRaySpace()},this.getControllerGrip=function(Q){let _e=R[Q];return _e===void 0&&(_e=new Wo,R[Q]=_e),_e.getGripSpace()},this.getHand=function(Q){let _e=R[Q];return _e===void 0&&(_e=new Wo,R[Q]=_e),_e.getHandSpace()};function $(Q){let _e=w.indexOf(Q.inputSource);if(_e===-1)return;let re=R[_e];re!==void 0&&(re.update(Q.inputSource,Q.frame,c||o),re.dispatchEvent({type:Q.type,data:Q.inputSource}))}function G(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",le);for(let Q=0;Q<R.length;Q++){let _e=w[Q];_e!==null&&(w[Q]=null,R[Q].disconnect(_e))}D=null,H=null,g.reset();for(let Q in p)delete p[Q];if(e.setRenderTarget(T),f=null,d=null,h=null,s=null,x=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(M),e.setSize(y.width,y.height,!1),N!==null){let Q=N.camera;Q.fov=N.fov,Q.zoom=N.zoom,Q.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",G),s.addEventListener("inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let re=null,me=null,pe=null;v.depth&&(pe=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,re=v.stencil?zs:Os,me=v.stencil?qr:ji);let Oe={colorFormat:t.RGBA8,depthFormat:pe,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Oe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),x=new Si(d.textureWidth,d.textureHeight,{format:es,type:li,depthTexture:new Bs(d.textureWidth,d.textureHeight,me,void 0,void 0,void 0,void 0,void 0,void 0,re),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let re={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,re),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),x=new Si(f.framebufferWidth,f.framebufferHeight,{format:es,type:li,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function le(Q){for(let _e=0;_e<Q.removed.length;_e++){let re=Q.removed[_e],me=w.indexOf(re);me>=0&&(w[me]=null,R[me].disconnect(re))}for(let _e=0;_e<Q.added.length;_e++){let re=Q.added[_e],me=w.indexOf(re);if(me===-1){for(let Oe=0;Oe<R.length;Oe++)if(Oe>=w.length){w.push(re),me=Oe;break}else if(w[Oe]===null){w[Oe]=re,me=Oe;break}if(me===-1)break}let pe=R[me];pe&&pe.connect(re)}}function Y(Q,_e){_e===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(_e.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let _e=Q.near,re=Q.far;g.texture!==null&&(g.depthNear>0&&(_e=g.depthNear),g.depthFar>0&&(re=g.depthFar)),V.near=L.near=I.near=_e,V.far=L.far=I.far=re,(D!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),D=V.near,H=V.far),V.layers.mask=Q.layers.mask|6,I.layers.mask=V.layers.mask&-5,L.layers.mask=V.layers.mask&-3;let me=Q.parent,pe=V.cameras;Y(V,me);for(let Oe=0;Oe<pe.length;Oe++)Y(pe[Oe],me);V.projectionMatrix.copy(I.projectionMatrix),V.projectionMatrixInverse.copy(I.projectionMatrixInverse),N===null&&Q.isPerspectiveCamera&&(N={camera:Q,fov:Q.fov,zoom:Q.zoom}),K(Q,V,me)};function K(Q,_e,re){re===null?Q.matrix.copy(_e.matrixWorld):(Q.matrix.copy(re.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(_e.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(_e.projectionMatrix),Q.projectionMatrixInverse.copy(_e.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Go*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(Q){return p[Q]};let te=null;function fe(Q,_e){if(u=_e.getViewerPose(c||o),m=_e,u!==null){let re=u.views;f!==null&&(e.setRenderTargetFramebuffer(x,f.framebuffer),e.setRenderTarget(x));let me=!1;re.length!==V.cameras.length&&(V.cameras.length=0,me=!0);for(let Ge=0;Ge<re.length;Ge++){let dt=re[Ge],ct=null;if(f!==null)ct=f.getViewport(dt);else{let Yt=h.getViewSubImage(d,dt);ct=Yt.viewport,Ge===0&&(e.setRenderTargetTextures(x,Yt.colorTexture,Yt.depthStencilTexture),e.setRenderTarget(x))}let it=k[Ge];it===void 0&&(it=new ii,it.layers.enable(Ge),it.viewport=new Rt,k[Ge]=it),it.matrix.fromArray(dt.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(dt.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ct.x,ct.y,ct.width,ct.height),Ge===0&&(V.matrix.copy(it.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),me===!0&&V.cameras.push(it)}let pe=s.enabledFeatures;if(pe&&pe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=n.getBinding();let Ge=h.getDepthInformation(re[0]);Ge&&Ge.isValid&&Ge.texture&&g.init(Ge,s.renderState)}if(pe&&pe.includes("camera-access")&&_){e.state.unbindTexture(),h=n.getBinding();for(let Ge=0;Ge<re.length;Ge++){let dt=re[Ge].camera;if(dt){let ct=p[dt];ct||(ct=new Ya,p[dt]=ct);let it=h.getCameraImage(dt);ct.sourceTexture=it}}}}for(let re=0;re<R.length;re++){let me=w[re],pe=R[re];me!==null&&pe!==void 0&&pe.update(me,_e,c||o)}te&&te(Q,_e),_e.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:_e}),m=null}let ue=new g_;ue.setAnimationLoop(fe),this.setAnimationLoop=function(Q){te=Q},this.dispose=function(){}}},nR=new Ot,E_=new nt;E_.set(-1,0,0,0,1,0,0,0,1);function iR(i,e){function t(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,qf(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,v,T,x){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),h(g,p)):p.isMeshPhongMaterial?(r(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),d(g,p),p.isMeshPhysicalMaterial&&f(g,p,x)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),_(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,v,T):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,t(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===ri&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,t(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===ri&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,t(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,t(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let v=e.get(p),T=v.envMap,x=v.envMapRotation;T&&(g.envMap.value=T,g.envMapRotation.value.setFromMatrix4(nR.makeRotationFromEuler(x)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(E_),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,v,T){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*v,g.scale.value=T*.5,p.map&&(g.map.value=p.map,t(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function d(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function f(g,p,v){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ri&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function _(g,p){let v=e.get(p).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function sR(i,e,t,n){let s={},r={};function o(v,T){let x=T.program;n.uniformBlockBinding(v,x,s[v.id])}function a(v,T){let x=s[v.id];x===void 0&&(m(v),x=l(v),s[v.id]=x,v.addEventListener("dispose",g));let R=T.program;n.updateUBOMapping(v,R);let w=e.render.frame;r[v.id]!==w&&(c(v),r[v.id]=w)}function l(v){let T=i.createBuffer(),x=v.__size,R=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,x,R),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],x=v.uniforms,R=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let w=0,y=x.length;w<y;w++){let M=x[w];if(Array.isArray(M))for(let N=0,I=M.length;N<I;N++)u(M[N],w,N,R);else u(M,w,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(v,T,x,R){if(d(v,T,x,R)===!0){let w=v.__offset,y=v.value;if(Array.isArray(y)){let M=0;for(let N=0;N<y.length;N++){let I=y[N],L=_(I,!0);h(I,v.__data,M),M+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,v.__data)}}function h(v,T,x){typeof v=="number"||typeof v=="boolean"?T[x]=v:v.isMatrix3?(T[x]=v.elements[0],T[x+1]=v.elements[1],T[x+2]=v.elements[2],T[x+3]=0,T[x+4]=v.elements[3],T[x+5]=v.elements[4],T[x+6]=v.elements[5],T[x+7]=0,T[x+8]=v.elements[6],T[x+9]=v.elements[7],T[x+10]=v.elements[8],T[x+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-x),x):v.toArray(T,x)}function d(v,T,x,R){let w=v.value,y=T+"_"+x;if(Array.isArray(w)){R[y]===void 0&&(R[y]=[]);let M=R[y],N=!1;for(let I=0;I<w.length;I++)f(w[I],M,I)===!0&&(N=!0);return N}return f(w,R,y)}function f(v,T,x){if(T[x]===void 0)return typeof v=="number"||typeof v=="boolean"?T[x]=v:ArrayBuffer.isView(v)?T[x]=v.slice():T[x]=v.clone(),!0;{let R=T[x];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return T[x]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function m(v){let T=v.uniforms,x=0,R=16;for(let y=0,M=T.length;y<M;y++){let N=Array.isArray(T[y])?T[y]:[T[y]];for(let I=0,L=N.length;I<L;I++){let k=N[I],V=Array.isArray(k.value)?k.value:[k.value],D=Array.isArray(T[y])||Array.isArray(k.value),H=x;for(let G=0,le=V.length;G<le;G++){let Y=V[G],K=_(Y,D),te=x%R,fe=te%K.boundary,ue=te+fe;x+=fe,ue!==0&&R-ue<K.storage&&(x+=R-ue),G===0&&(H=x),x+=K.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((x-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let w=x%R;return w>0&&(x+=R-w),v.__size=x,v.__cache={},this}function _(v,T){let x={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(x.boundary=4,x.storage=4):v.isVector2?(x.boundary=8,x.storage=8):v.isVector3||v.isColor?(x.boundary=16,x.storage=12):v.isVector4?(x.boundary=16,x.storage=16):v.isMatrix3?(x.boundary=16,x.storage=48):v.isMatrix4?(x.boundary=16,x.storage=64):v.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(x.boundary=16,x.storage=v.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}function g(v){let T=v.target;T.removeEventListener("dispose",g),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var rR=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),_s=null;function oR(){return _s===null&&(_s=new Kc(rR,16,16,gr,Qi),_s.name="DFG_LUT",_s.minFilter=si,_s.magFilter=si,_s.wrapS=ps,_s.wrapT=ps,_s.generateMipmaps=!1,_s.needsUpdate=!0),_s}var lh=class{constructor(e={}){let{canvas:t=Gy(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=li}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let _=f,g=new Set([Tu,Eu,Au]),p=new Set([li,ji,Ko,qr,Mu,wu]),v=new Uint32Array(4),T=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},R=null,w=null,y=[],M=[],N=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ys,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,L=!1,k=null,V=null,D=null,H=null;this._outputColorSpace=vi;let $=0,G=0,le=null,Y=-1,K=null,te=new Rt,fe=new Rt,ue=null,Q=new at(0),_e=0,re=t.width,me=t.height,pe=1,Oe=null,Xe=null,Ge=new Rt(0,0,re,me),dt=new Rt(0,0,re,me),ct=!1,it=new or,Yt=new Qc,Vt=!1,cn=!1,It=new Ot,An=new B,vt=new Rt,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function un(){return le===null?pe:1}let O=n;function Ce(E,z){return t.getContext(E,z)}let Ye,rt,we,Ft,Ve,qe,C,S,q,de,ae,ve,be,ne,se,ye,U,oe,ie,Ae,xe,Me,He;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Re,!1),O===null){let z="webgl2";if(O=Ce(z,E),O===null)throw Ce(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(E){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),tt("WebGLRenderer: "+E.message),E}function Ke(){Ye=new yE(O),Ye.init(),xe=new QT(O,Ye),rt=new oE(O,Ye,e,xe),we=new jT(O,Ye),rt.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),V=O.createFramebuffer(),D=O.createFramebuffer(),H=O.createFramebuffer(),Ft=new vE(O),Ve=new OT,qe=new KT(O,Ye,we,Ve,rt,xe,Ft),C=new gE(I),S=new Sw(O),Me=new sE(O,S),q=new _E(O,S,Ft,Me),de=new SE(O,q,S,Me,Ft),oe=new bE(O,rt,qe),se=new aE(Ve),ae=new UT(I,C,Ye,rt,Me,se),ve=new iR(I,Ve),be=new kT,ne=new XT(Ye),U=new iE(I,C,we,de,m,l),ye=new JT(I,de,rt),He=new sR(O,Ft,rt,we),ie=new rE(O,Ye,Ft),Ae=new xE(O,Ye,Ft),Ft.programs=ae.programs,I.capabilities=rt,I.extensions=Ye,I.properties=Ve,I.renderLists=be,I.shadowMap=ye,I.state=we,I.info=Ft}_!==li&&(N=new wE(_,t.width,t.height,a,s,r));let he=new rp(I,O);this.xr=he,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let E=Ye.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Ye.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return pe},this.setPixelRatio=function(E){E!==void 0&&(pe=E,this.setSize(re,me,!1))},this.getSize=function(E){return E.set(re,me)},this.setSize=function(E,z,ee=!0){if(he.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}re=E,me=z,t.width=Math.floor(E*pe),t.height=Math.floor(z*pe),ee===!0&&(t.style.width=E+"px",t.style.height=z+"px"),N!==null&&N.setSize(t.width,t.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(re*pe,me*pe).floor()},this.setDrawingBufferSize=function(E,z,ee){re=E,me=z,pe=ee,t.width=Math.floor(E*ee),t.height=Math.floor(z*ee),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(_===li){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(te)},this.getViewport=function(E){return E.copy(Ge)},this.setViewport=function(E,z,ee,Z){E.isVector4?Ge.set(E.x,E.y,E.z,E.w):Ge.set(E,z,ee,Z),we.viewport(te.copy(Ge).multiplyScalar(un()).round())},this.getScissor=function(E){return E.copy(dt)},this.setScissor=function(E,z,ee,Z){E.isVector4?dt.set(E.x,E.y,E.z,E.w):dt.set(E,z,ee,Z),we.scissor(fe.copy(dt).multiplyScalar(un()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(E){we.setScissorTest(ct=E)},this.setOpaqueSort=function(E){Oe=E},this.setTransparentSort=function(E){Xe=E},this.getClearColor=function(E){return E.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,ee=!0){let Z=0;if(E){let J=!1;if(le!==null){let Ee=le.texture.format;J=g.has(Ee)}if(J){let Ee=le.texture.type,Le=p.has(Ee),Te=U.getClearColor(),Ie=U.getClearAlpha(),ze=Te.r,et=Te.g,ft=Te.b;Le?(v[0]=ze,v[1]=et,v[2]=ft,v[3]=Ie,O.clearBufferuiv(O.COLOR,0,v)):(T[0]=ze,T[1]=et,T[2]=ft,T[3]=Ie,O.clearBufferiv(O.COLOR,0,T))}else Z|=O.COLOR_BUFFER_BIT}z&&(Z|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ee&&(Z|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&O.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),k=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),U.dispose(),be.dispose(),ne.dispose(),qe.dispose(),Ve.dispose(),C.dispose(),de.dispose(),q.dispose(),Me.dispose(),He.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",Al),he.removeEventListener("sessionend",ns),Ms.stop()};function Be(E){E.preventDefault(),ka("WebGLRenderer: Context Lost."),L=!0}function Qe(){ka("WebGLRenderer: Context Restored."),L=!1;let E=Ft.autoReset,z=ye.enabled,ee=ye.autoUpdate,Z=ye.needsUpdate,J=ye.type;Ke(),Ft.autoReset=E,ye.enabled=z,ye.autoUpdate=ee,ye.needsUpdate=Z,ye.type=J}function Re(E){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function lt(E){let z=E.target;z.removeEventListener("dispose",lt),Gt(z)}function Gt(E){Zn(E),Ve.remove(E)}function Zn(E){let z=Ve.get(E).programs;z!==void 0&&(z.forEach(function(ee){ae.releaseProgram(ee)}),E.isShaderMaterial&&ae.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,ee,Z,J,Ee){z===null&&(z=_n);let Le=J.isMesh&&J.matrixWorld.determinantAffine()<0,Te=ra(E,z,ee,Z,J);we.setMaterial(Z,Le);let Ie=ee.index,ze=1;if(Z.wireframe===!0){if(Ie=q.getWireframeAttribute(ee),Ie===void 0)return;ze=2}let et=ee.drawRange,ft=ee.attributes.position,ke=et.start*ze,pt=(et.start+et.count)*ze;Ee!==null&&(ke=Math.max(ke,Ee.start*ze),pt=Math.min(pt,(Ee.start+Ee.count)*ze)),Ie!==null?(ke=Math.max(ke,0),pt=Math.min(pt,Ie.count)):ft!=null&&(ke=Math.max(ke,0),pt=Math.min(pt,ft.count));let Jt=pt-ke;if(Jt<0||Jt===1/0)return;Me.setup(J,Z,Te,ee,Ie);let Ct,Pt=ie;if(Ie!==null&&(Ct=S.get(Ie),Pt=Ae,Pt.setIndex(Ct)),J.isMesh)Z.wireframe===!0?(we.setLineWidth(Z.wireframeLinewidth*un()),Pt.setMode(O.LINES)):Pt.setMode(O.TRIANGLES);else if(J.isLine){let xn=Z.linewidth;xn===void 0&&(xn=1),we.setLineWidth(xn*un()),J.isLineSegments?Pt.setMode(O.LINES):J.isLineLoop?Pt.setMode(O.LINE_LOOP):Pt.setMode(O.LINE_STRIP)}else J.isPoints?Pt.setMode(O.POINTS):J.isSprite&&Pt.setMode(O.TRIANGLES);if(J.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))Pt.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let xn=J._multiDrawStarts,Ne=J._multiDrawCounts,hn=J._multiDrawCount,gt=Ie?S.get(Ie).bytesPerElement:1,As=Ve.get(Z).currentProgram.getUniforms();for(let dn=0;dn<hn;dn++)As.setValue(O,"_gl_DrawID",dn),Pt.render(xn[dn]/gt,Ne[dn])}else if(J.isInstancedMesh)Pt.renderInstances(ke,Jt,J.count);else if(ee.isInstancedBufferGeometry){let xn=ee._maxInstanceCount!==void 0?ee._maxInstanceCount:1/0,Ne=Math.min(ee.instanceCount,xn);Pt.renderInstances(ke,Jt,Ne)}else Pt.render(ke,Jt)};function na(E,z,ee,Z){k!==null&&E.isNodeMaterial&&k.setObject(Z,E),Vt===!0&&se.setState(E,ee,!1),E.transparent===!0&&E.side===Fi&&E.forceSinglePass===!1?(E.side=ri,E.needsUpdate=!0,is(E,z,Z),E.side=mr,E.needsUpdate=!0,is(E,z,Z),E.side=Fi):is(E,z,Z)}this.compile=function(E,z,ee=null){ee===null&&(ee=E),k!==null&&k.renderStart(E,z,ee),w=ne.get(ee),w.init(z),M.push(w),ee.traverseVisible(function(J){J.isLight&&J.layers.test(z.layers)&&(w.pushLight(J),J.castShadow&&w.pushShadow(J))}),E!==ee&&E.traverseVisible(function(J){J.isLight&&J.layers.test(z.layers)&&(w.pushLight(J),J.castShadow&&w.pushShadow(J))}),w.setupLights(),k!==null&&k.updateLights(w.state.lightsArray),cn=this.localClippingEnabled,Vt=se.init(this.clippingPlanes,cn),Vt===!0&&se.setGlobalState(this.clippingPlanes,z),k!==null&&ye.render(w.state.shadowsArray,ee,z);let Z=new Set;return E.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Ee=J.material;if(Ee)if(Array.isArray(Ee))for(let Le=0;Le<Ee.length;Le++){let Te=Ee[Le];na(Te,ee,z,J),Z.add(Te)}else na(Ee,ee,z,J),Z.add(Ee)}),w=M.pop(),k!==null&&k.renderEnd(),Z},this.compileAsync=function(E,z,ee=null){let Z=this.compile(E,z,ee);return new Promise(J=>{function Ee(){if(Z.forEach(function(Le){let Ie=Ve.get(Le).currentProgram;(Ie===void 0||Ie.isReady())&&Z.delete(Le)}),Z.size===0){J(E);return}setTimeout(Ee,10)}Ye.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let jr=null;function Dh(E){jr&&jr(E)}function Al(){Ms.stop()}function ns(){Ms.start()}let Ms=new g_;Ms.setAnimationLoop(Dh),typeof self<"u"&&Ms.setContext(self),this.setAnimationLoop=function(E){jr=E,he.setAnimationLoop(E),E===null?Ms.stop():Ms.start()},he.addEventListener("sessionstart",Al),he.addEventListener("sessionend",ns),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;k!==null&&k.renderStart(E,z);let ee=he.enabled===!0&&he.isPresenting===!0,Z=N!==null&&(le===null||ee)&&N.begin(I,le);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(z),z=he.getCamera()),E.isScene===!0&&E.onBeforeRender(I,E,z,le),w=ne.get(E,M.length),w.init(z),w.state.textureUnits=qe.getTextureUnits(),M.push(w),It.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Yt.setFromArrayCamera(z):it.setFromProjectionMatrix(It,Li,z.reversedDepth),cn=this.localClippingEnabled,Vt=se.init(this.clippingPlanes,cn),R=be.get(E,y.length),R.init(),y.push(R),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Le=I.xr.getDepthSensingMesh();Le!==null&&ws(Le,z,-1/0,I.sortObjects)}ws(E,z,0,I.sortObjects),R.finish(),k!==null&&k.updateLights(w.state.lightsArray),I.sortObjects===!0&&R.sort(Oe,Xe),Qt=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,Qt&&U.addToRenderList(R,E),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&se.beginShadows();let J=w.state.shadowsArray;if(ye.render(J,E,z),Vt===!0&&se.endShadows(),(Z&&N.hasRenderPass())===!1){let Le=R.opaque,Te=R.transmissive;if(w.setupLights(),z.isArrayCamera){let Ie=z.cameras;if(Te.length>0)for(let ze=0,et=Ie.length;ze<et;ze++){let ft=Ie[ze];Ni(Le,Te,E,ft)}Qt&&U.render(E);for(let ze=0,et=Ie.length;ze<et;ze++){let ft=Ie[ze];ia(R,E,ft,ft.viewport)}}else Te.length>0&&Ni(Le,Te,E,z),Qt&&U.render(E),ia(R,E,z)}le!==null&&G===0&&(qe.updateMultisampleRenderTarget(le),qe.updateRenderTargetMipmap(le)),Z&&N.end(I),E.isScene===!0&&E.onAfterRender(I,E,z),Me.resetDefaultState(),Y=-1,K=null,M.pop(),M.length>0?(w=M[M.length-1],qe.setTextureUnits(w.state.textureUnits),Vt===!0&&se.setGlobalState(I.clippingPlanes,w.state.camera)):w=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,k!==null&&k.renderEnd()};function ws(E,z,ee,Z){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)ee=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)w.pushLight(E),E.castShadow&&w.pushShadow(E);else if(E.isSprite){let Le=z.isArrayCamera?Yt:it;if(!E.frustumCulled||E.intersectsFrustum(Le)){Z&&vt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(It);let Te=de.update(E),Ie=E.material;Ie.visible&&R.push(E,Te,Ie,ee,vt.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Le=z.isArrayCamera?Yt:it;if(!E.frustumCulled||E.intersectsFrustum(Le)){let Te=de.update(E),Ie=E.material;if(Z&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),vt.copy(E.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),vt.copy(Te.boundingSphere.center)),vt.applyMatrix4(E.matrixWorld).applyMatrix4(It)),Array.isArray(Ie)){let ze=Te.groups;for(let et=0,ft=ze.length;et<ft;et++){let ke=ze[et],pt=Ie[ke.materialIndex];pt&&pt.visible&&R.push(E,Te,pt,ee,vt.z,ke,z)}}else Ie.visible&&R.push(E,Te,Ie,ee,vt.z,null,z)}}}let Ee=E.children;for(let Le=0,Te=Ee.length;Le<Te;Le++)ws(Ee[Le],z,ee,Z)}function ia(E,z,ee,Z){let{opaque:J,transmissive:Ee,transparent:Le}=E;w.setupLightsView(ee),Vt===!0&&se.setGlobalState(I.clippingPlanes,ee),Z&&we.viewport(te.copy(Z)),J.length>0&&en(J,z,ee),Ee.length>0&&en(Ee,z,ee),Le.length>0&&en(Le,z,ee),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Ni(E,z,ee,Z){if((ee.isScene===!0?ee.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[Z.id]===void 0){let ke=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[Z.id]=new Si(1,1,{generateMipmaps:!0,type:ke?Qi:li,minFilter:ks,samples:Math.max(4,rt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Ee=w.state.transmissionRenderTarget[Z.id],Le=Z.viewport||te;Ee.setSize(Le.z*I.transmissionResolutionScale,Le.w*I.transmissionResolutionScale);let Te=I.getRenderTarget(),Ie=I.getActiveCubeFace(),ze=I.getActiveMipmapLevel();I.setRenderTarget(Ee),I.getClearColor(Q),_e=I.getClearAlpha(),_e<1&&I.setClearColor(16777215,.5),I.clear(),Qt&&U.render(ee);let et=I.toneMapping;I.toneMapping=ys;let ft=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),w.setupLightsView(Z),Vt===!0&&se.setGlobalState(I.clippingPlanes,Z),en(E,ee,Z),qe.updateMultisampleRenderTarget(Ee),qe.updateRenderTargetMipmap(Ee),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let pt=0,Jt=z.length;pt<Jt;pt++){let Ct=z[pt],{object:Pt,geometry:xn,material:Ne,group:hn}=Ct;if(Ne.side===Fi&&Pt.layers.test(Z.layers)){let gt=Ne.side;Ne.side=ri,Ne.needsUpdate=!0,an(Pt,ee,Z,xn,Ne,hn),Ne.side=gt,Ne.needsUpdate=!0,ke=!0}}ke===!0&&(qe.updateMultisampleRenderTarget(Ee),qe.updateRenderTargetMipmap(Ee))}I.setRenderTarget(Te,Ie,ze),I.setClearColor(Q,_e),ft!==void 0&&(Z.viewport=ft),I.toneMapping=et}function en(E,z,ee){let Z=z.isScene===!0?z.overrideMaterial:null;for(let J=0,Ee=E.length;J<Ee;J++){let Le=E[J],{object:Te,geometry:Ie,group:ze}=Le,et=Le.material;et.allowOverride===!0&&Z!==null&&(et=Z),Te.layers.test(ee.layers)&&an(Te,z,ee,Ie,et,ze)}}function an(E,z,ee,Z,J,Ee){k!==null&&J.isNodeMaterial&&k.setObject(E,J),E.onBeforeRender(I,z,ee,Z,J,Ee),E.modelViewMatrix.multiplyMatrices(ee.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),J.onBeforeRender(I,z,ee,Z,E,Ee),J.transparent===!0&&J.side===Fi&&J.forceSinglePass===!1?(J.side=ri,J.needsUpdate=!0,I.renderBufferDirect(ee,z,Z,J,E,Ee),J.side=mr,J.needsUpdate=!0,I.renderBufferDirect(ee,z,Z,J,E,Ee),J.side=Fi):I.renderBufferDirect(ee,z,Z,J,E,Ee),E.onAfterRender(I,z,ee,Z,J,Ee)}function ln(E){let z=0;for(let ee of E)ee.texture!==null&&z++;return z}function is(E,z,ee){z.isScene!==!0&&(z=_n);let Z=Ve.get(E),J=w.state.lights,Ee=w.state.shadowsArray,Le=J.state.version,Te=ae.getParameters(E,J.state,Ee,z,ee,w.state.lightProbeGridArray),Ie=ae.getProgramCacheKey(Te),ze=Z.programs;Z.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,Z.fog=z.fog;let et=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;Z.envMap=C.get(E.envMap||Z.environment,et),Z.envMapRotation=Z.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,ze===void 0&&(E.addEventListener("dispose",lt),ze=new Map,Z.programs=ze,Z.programVariants=new Map);let ft=ze.get(Ie);if(ft!==void 0){if(Z.currentProgram===ft&&Z.lightsStateVersion===Le)return sa(E,Te),ft}else Te.uniforms=ae.getUniforms(E),k!==null&&E.isNodeMaterial&&k.build(E,ee,Te),E.onBeforeCompile(Te,I),ft=ae.acquireProgram(Te,Ie),ze.set(Ie,ft),Z.uniforms=Te.uniforms;let ke=Z.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(ke.clippingPlanes=se.uniform),sa(E,Te),Z.needsLights=Hs(E),Z.lightsStateVersion=Le,Z.needsLights&&(ke.ambientLightColor.value=J.state.ambient,ke.lightProbe.value=J.state.probe,ke.sunLights.value=J.state.sun,ke.sunLightShadows.value=J.state.sunShadow,ke.directionalLights.value=J.state.directional,ke.directionalLightShadows.value=J.state.directionalShadow,ke.spotLights.value=J.state.spot,ke.spotLightShadows.value=J.state.spotShadow,ke.rectAreaLights.value=J.state.rectArea,ke.ltc_1.value=J.state.rectAreaLTC1,ke.ltc_2.value=J.state.rectAreaLTC2,ke.pointLights.value=J.state.point,ke.pointLightShadows.value=J.state.pointShadow,ke.hemisphereLights.value=J.state.hemi,ke.sunShadowMatrix.value=J.state.sunShadowMatrix,ke.sunShadowCascade.value=J.state.sunShadowCascade,ke.directionalShadowMatrix.value=J.state.directionalShadowMatrix,ke.spotLightMatrix.value=J.state.spotLightMatrix,ke.spotLightMap.value=J.state.spotLightMap,ke.pointShadowMatrix.value=J.state.pointShadowMatrix),Z.numLightProbeGrids=ln(w.state.lightProbeGridArray),Z.currentProgram=ft,Z.uniformsList=null,ft}function ui(E,z,ee,Z,J){let Ee=Ve.get(E),Le=Ee.currentProgram.id+","+Z+","+J,Te=Ee.programVariants.get(Le);return Te===void 0?(Te=is(E,z,ee),Ee.programVariants.set(Le,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=Z,Ee.toneMapping=J),Te}function Gs(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=Qo.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function sa(E,z){let ee=Ve.get(E);ee.outputColorSpace=z.outputColorSpace,ee.batching=z.batching,ee.batchingColor=z.batchingColor,ee.instancing=z.instancing,ee.instancingColor=z.instancingColor,ee.instancingMorph=z.instancingMorph,ee.skinning=z.skinning,ee.morphTargets=z.morphTargets,ee.morphNormals=z.morphNormals,ee.morphColors=z.morphColors,ee.morphTargetsCount=z.morphTargetsCount,ee.numClippingPlanes=z.numClippingPlanes,ee.numIntersection=z.numClipIntersection,ee.vertexAlphas=z.vertexAlphas,ee.vertexTangents=z.vertexTangents,ee.toneMapping=z.toneMapping}function ra(E,z,ee,Z,J){z.isScene!==!0&&(z=_n),qe.resetTextureUnits();let Ee=z.fog,Le=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?z.environment:null,Te=le===null?I.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:xt.workingColorSpace,Ie=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,ze=C.get(Z.envMap||Le,Ie),et=Z.vertexColors===!0&&!!ee.attributes.color&&ee.attributes.color.itemSize===4,ft=!!ee.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),ke=!!ee.morphAttributes.position,pt=!!ee.morphAttributes.normal,Jt=!!ee.morphAttributes.color,Ct=ys;Z.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Ct=I.toneMapping);let Pt=ee.morphAttributes.position||ee.morphAttributes.normal||ee.morphAttributes.color,xn=Pt!==void 0?Pt.length:0,Ne=Ve.get(Z),hn=w.state.lights;if(Vt===!0&&(cn===!0||E!==K)){let Lt=E===K&&Z.id===Y;se.setState(Z,E,Lt)}let gt=!1,As=!1;Z.version===Ne.__version?Ne.needsLights&&Ne.lightsStateVersion!==hn.state.version||J.isBatchedMesh&&Ne.batching===!1||!J.isBatchedMesh&&Ne.batching===!0||J.isBatchedMesh&&Ne.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ne.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ne.instancing===!1||!J.isInstancedMesh&&Ne.instancing===!0||J.isSkinnedMesh&&Ne.skinning===!1||!J.isSkinnedMesh&&Ne.skinning===!0||J.isInstancedMesh&&Ne.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ne.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ne.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ne.instancingMorph===!1&&J.morphTexture!==null||Ne.envMap!==ze||Z.fog===!0&&Ne.fog!==Ee||Ne.numClippingPlanes!==void 0&&(Ne.numClippingPlanes!==se.numPlanes||Ne.numIntersection!==se.numIntersection)||Ne.vertexAlphas!==et||Ne.vertexTangents!==ft||Ne.morphTargets!==ke||Ne.morphNormals!==pt||Ne.morphColors!==Jt||Ne.morphTargetsCount!==xn||Ne.numLightProbeGrids!==ln(w.state.lightProbeGridArray)?gt=!0:(Ne.outputColorSpace!==Te||Ne.toneMapping!==Ct)&&(As=!0):(gt=!0,Ne.__version=Z.version);let dn=Ne.currentProgram;(gt===!0||As===!0)&&(dn=As===!0?ui(Z,z,J,Te,Ct):is(Z,z,J),k&&Z.isNodeMaterial&&k.onUpdateProgram(Z,dn,Ne));let eo=!1,ss=!1,Es=!1,ut=dn.getUniforms(),tn=Ne.uniforms;if(we.useProgram(dn.program)&&(eo=!0,ss=!0,Es=!0),Z.id!==Y&&(Y=Z.id,ss=!0),eo||K!==E){we.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ut.setValue(O,"projectionMatrix",E.projectionMatrix),ut.setValue(O,"viewMatrix",E.matrixWorldInverse);let fn=ut.map.cameraPosition;fn!==void 0&&fn.setValue(O,An.setFromMatrixPosition(E.matrixWorld)),rt.logarithmicDepthBuffer&&ut.setValue(O,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ut.setValue(O,"isOrthographic",E.isOrthographicCamera===!0),K!==E&&(K=E,ss=!0,Es=!0)}if(Ne.needsLights&&(hn.state.sunShadowMap.length>0&&ut.setValue(O,"sunShadowMap",hn.state.sunShadowMap,qe),hn.state.directionalShadowMap.length>0&&ut.setValue(O,"directionalShadowMap",hn.state.directionalShadowMap,qe),hn.state.spotShadowMap.length>0&&ut.setValue(O,"spotShadowMap",hn.state.spotShadowMap,qe),hn.state.pointShadowMap.length>0&&ut.setValue(O,"pointShadowMap",hn.state.pointShadowMap,qe)),J.isSkinnedMesh){ut.setOptional(O,J,"bindMatrix"),ut.setOptional(O,J,"bindMatrixInverse");let Lt=J.skeleton;Lt&&(Lt.boneTexture===null&&Lt.computeBoneTexture(),ut.setValue(O,"boneTexture",Lt.boneTexture,qe))}J.isBatchedMesh&&(ut.setOptional(O,J,"batchingTexture"),ut.setValue(O,"batchingTexture",J._matricesTexture,qe),ut.setOptional(O,J,"batchingIdTexture"),ut.setValue(O,"batchingIdTexture",J._indirectTexture,qe),ut.setOptional(O,J,"batchingColorTexture"),J._colorsTexture!==null&&ut.setValue(O,"batchingColorTexture",J._colorsTexture,qe));let Jn=ee.morphAttributes;if((Jn.position!==void 0||Jn.normal!==void 0||Jn.color!==void 0)&&oe.update(J,ee,dn),(ss||Ne.receiveShadow!==J.receiveShadow)&&(Ne.receiveShadow=J.receiveShadow,ut.setValue(O,"receiveShadow",J.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&z.environment!==null&&(tn.envMapIntensity.value=z.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=oR()),ss){if(ut.setValue(O,"toneMappingExposure",I.toneMappingExposure),Ne.needsLights&&Kr(tn,Es),Ee&&Z.fog===!0&&ve.refreshFogUniforms(tn,Ee),ve.refreshMaterialUniforms(tn,Z,pe,me,w.state.transmissionRenderTarget[E.id]),Ne.needsLights&&Ne.numLightProbeGrids>0){let Lt=x,fn=0;for(let Wn of w.state.lightProbeGridArray)Wn.texture!==null&&(Lt.textures[fn]=Wn.texture,Lt.min[fn]=Wn.boundingBox.min,Lt.max[fn]=Wn.boundingBox.max,Lt.resolution[fn]=Wn.resolution,fn++);for(let Wn in Lt)Lt[Wn].length=fn;tn.probesSH.value=Lt.textures,tn.probesMin.value=Lt.min,tn.probesMax.value=Lt.max,tn.probesResolution.value=Lt.resolution}Qo.upload(O,Gs(Ne),tn,qe)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Qo.upload(O,Gs(Ne),tn,qe),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ut.setValue(O,"center",J.center),ut.setValue(O,"modelViewMatrix",J.modelViewMatrix),ut.setValue(O,"normalMatrix",J.normalMatrix),ut.setValue(O,"modelMatrix",J.matrixWorld),Z.uniformsGroups!==void 0){let Lt=Z.uniformsGroups;for(let fn=0,Wn=Lt.length;fn<Wn;fn++){let El=Lt[fn];He.update(El,dn),He.bind(El,dn)}}return dn}function Kr(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function Hs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(E,z,ee){let Z=Ve.get(E);Z.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Ve.get(E.texture).__webglTexture=z,Ve.get(E.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:ee,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let ee=Ve.get(E);ee.__webglFramebuffer=z,ee.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,ee=0){le=E,$=z,G=ee;let Z=null,J=!1,Ee=!1;if(E){let Te=Ve.get(E);if(Te.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(O.FRAMEBUFFER,Te.__webglFramebuffer),te.copy(E.viewport),fe.copy(E.scissor),ue=E.scissorTest,we.viewport(te),we.scissor(fe),we.setScissorTest(ue),Y=-1;return}else if(Te.__webglFramebuffer===void 0)qe.setupRenderTarget(E);else if(Te.__hasExternalTextures)qe.rebindTextures(E,Ve.get(E.texture).__webglTexture,Ve.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let et=E.depthTexture;if(Te.__boundDepthTexture!==et){if(et!==null&&Ve.has(et)&&(E.width!==et.image.width||E.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(E)}}let Ie=E.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Ee=!0);let ze=Ve.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?Z=ze[z][ee]:Z=ze[z],J=!0):E.samples>0&&qe.useMultisampledRTT(E)===!1?Z=Ve.get(E).__webglMultisampledFramebuffer:Array.isArray(ze)?Z=ze[ee]:Z=ze,te.copy(E.viewport),fe.copy(E.scissor),ue=E.scissorTest}else te.copy(Ge).multiplyScalar(pe).floor(),fe.copy(dt).multiplyScalar(pe).floor(),ue=ct;if(ee!==0&&(Z=V),we.bindFramebuffer(O.FRAMEBUFFER,Z)&&we.drawBuffers(E,Z),we.viewport(te),we.scissor(fe),we.setScissorTest(ue),J){let Te=Ve.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+z,Te.__webglTexture,ee)}else if(Ee){let Te=z;for(let Ie=0;Ie<E.textures.length;Ie++){let ze=Ve.get(E.textures[Ie]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,ee,Te)}}else if(E!==null&&ee!==0){let Te=Ve.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Te.__webglTexture,ee)}Y=-1};function Qr(E){let z=Ve.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=rt.textureFormatReadable(E.format),z.__typeReadable=rt.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,ee,Z,J,Ee,Le,Te=0){if(!(E&&E.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ve.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(Ie=Ie[Le],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(O.FRAMEBUFFER,Ie);try{let ze=E.textures[Te],et=ze.format,ft=ze.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Te);let ke=Qr(ze);if(ke.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-Z&&ee>=0&&ee<=E.height-J&&O.readPixels(z,ee,Z,J,xe.convert(et),xe.convert(ft),Ee)}finally{let ze=le!==null?Ve.get(le).__webglFramebuffer:null;we.bindFramebuffer(O.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(E,z,ee,Z,J,Ee,Le,Te=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ve.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(Ie=Ie[Le],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(z>=0&&z<=E.width-Z&&ee>=0&&ee<=E.height-J){we.bindFramebuffer(O.FRAMEBUFFER,Ie);let ze=E.textures[Te],et=ze.format,ft=ze.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Te);let ke=Qr(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.bufferData(O.PIXEL_PACK_BUFFER,Ee.byteLength,O.STREAM_READ),O.readPixels(z,ee,Z,J,xe.convert(et),xe.convert(ft),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Jt=le!==null?Ve.get(le).__webglFramebuffer:null;we.bindFramebuffer(O.FRAMEBUFFER,Jt);let Ct=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await Wy(O,Ct,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Ee),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(pt),O.deleteSync(Ct),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,ee=0){let Z=Math.pow(2,-ee),J=Math.floor(E.image.width*Z),Ee=Math.floor(E.image.height*Z),Le=z!==null?z.x:0,Te=z!==null?z.y:0;qe.setTexture2D(E,0),O.copyTexSubImage2D(O.TEXTURE_2D,ee,0,0,Le,Te,J,Ee),we.unbindTexture()},this.copyTextureToTexture=function(E,z,ee=null,Z=null,J=0,Ee=0){let Le,Te,Ie,ze,et,ft,ke,pt,Jt,Ct=E.isCompressedTexture?E.mipmaps[Ee]:E.image;if(ee!==null)Le=ee.max.x-ee.min.x,Te=ee.max.y-ee.min.y,Ie=ee.isBox3?ee.max.z-ee.min.z:1,ze=ee.min.x,et=ee.min.y,ft=ee.isBox3?ee.min.z:0;else{let ut=Math.pow(2,-J);Le=Math.floor(Ct.width*ut),Te=Math.floor(Ct.height*ut),E.isDataArrayTexture?Ie=Ct.depth:E.isData3DTexture?Ie=Math.floor(Ct.depth*ut):Ie=1,ze=0,et=0,ft=0}Z!==null?(ke=Z.x,pt=Z.y,Jt=Z.z):(ke=0,pt=0,Jt=0);let Pt=xe.convert(z.format),xn=xe.convert(z.type),Ne;z.isData3DTexture?(qe.setTexture3D(z,0),Ne=O.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(qe.setTexture2DArray(z,0),Ne=O.TEXTURE_2D_ARRAY):(qe.setTexture2D(z,0),Ne=O.TEXTURE_2D),we.activeTexture(O.TEXTURE0),we.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,z.flipY),we.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),we.pixelStorei(O.UNPACK_ALIGNMENT,z.unpackAlignment);let hn=we.getParameter(O.UNPACK_ROW_LENGTH),gt=we.getParameter(O.UNPACK_IMAGE_HEIGHT),As=we.getParameter(O.UNPACK_SKIP_PIXELS),dn=we.getParameter(O.UNPACK_SKIP_ROWS),eo=we.getParameter(O.UNPACK_SKIP_IMAGES);we.pixelStorei(O.UNPACK_ROW_LENGTH,Ct.width),we.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Ct.height),we.pixelStorei(O.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(O.UNPACK_SKIP_ROWS,et),we.pixelStorei(O.UNPACK_SKIP_IMAGES,ft);let ss=E.isDataArrayTexture||E.isData3DTexture,Es=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let ut=Ve.get(E),tn=Ve.get(z),Jn=Ve.get(ut.__renderTarget),Lt=Ve.get(tn.__renderTarget);we.bindFramebuffer(O.READ_FRAMEBUFFER,Jn.__webglFramebuffer),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,Lt.__webglFramebuffer);for(let fn=0;fn<Ie;fn++)ss&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(E).__webglTexture,J,ft+fn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(z).__webglTexture,Ee,Jt+fn)),O.blitFramebuffer(ze,et,ze+Le,et+Te,ke,pt,ke+Le,pt+Te,O.DEPTH_BUFFER_BIT,O.NEAREST);we.bindFramebuffer(O.READ_FRAMEBUFFER,null),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(J!==0||E.isRenderTargetTexture||Ve.has(E)){let ut=Ve.get(E),tn=Ve.get(z);we.bindFramebuffer(O.READ_FRAMEBUFFER,D),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let Jn=0;Jn<Ie;Jn++)ss?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ut.__webglTexture,J,ft+Jn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ut.__webglTexture,J),Es?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,tn.__webglTexture,Ee,Jt+Jn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,tn.__webglTexture,Ee),J!==0?O.blitFramebuffer(ze,et,ze+Le,et+Te,ke,pt,ke+Le,pt+Te,O.COLOR_BUFFER_BIT,O.NEAREST):Es?O.copyTexSubImage3D(Ne,Ee,ke,pt,Jt+Jn,ze,et,Le,Te):O.copyTexSubImage2D(Ne,Ee,ke,pt,ze,et,Le,Te);we.bindFramebuffer(O.READ_FRAMEBUFFER,null),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Es?E.isDataTexture||E.isData3DTexture?O.texSubImage3D(Ne,Ee,ke,pt,Jt,Le,Te,Ie,Pt,xn,Ct.data):z.isCompressedArrayTexture?O.compressedTexSubImage3D(Ne,Ee,ke,pt,Jt,Le,Te,Ie,Pt,Ct.data):O.texSubImage3D(Ne,Ee,ke,pt,Jt,Le,Te,Ie,Pt,xn,Ct):E.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Ee,ke,pt,Le,Te,Pt,xn,Ct.data):E.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Ee,ke,pt,Ct.width,Ct.height,Pt,Ct.data):O.texSubImage2D(O.TEXTURE_2D,Ee,ke,pt,Le,Te,Pt,xn,Ct);we.pixelStorei(O.UNPACK_ROW_LENGTH,hn),we.pixelStorei(O.UNPACK_IMAGE_HEIGHT,gt),we.pixelStorei(O.UNPACK_SKIP_PIXELS,As),we.pixelStorei(O.UNPACK_SKIP_ROWS,dn),we.pixelStorei(O.UNPACK_SKIP_IMAGES,eo),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&O.generateMipmap(Ne),we.unbindTexture()},this.initRenderTarget=function(E){Ve.get(E).__webglFramebuffer===void 0&&qe.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?qe.setTextureCube(E,0):E.isData3DTexture?qe.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?qe.setTexture2DArray(E,0):qe.setTexture2D(E,0),we.unbindTexture()},this.resetState=function(){$=0,G=0,le=null,we.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Li}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};var T_={type:"change"},ap={type:"start"},C_={type:"end"},hh=new Br,R_=new bi,aR=Math.cos(70*ts.DEG2RAD),wn=new B,ci=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},op=1e-6,dh=class extends cl{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new B,this.cursor=new B,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:fr.ROTATE,MIDDLE:fr.DOLLY,RIGHT:fr.PAN},this.touches={ONE:pr.ROTATE,TWO:pr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new B,this._lastQuaternion=new Fn,this._lastTargetPosition=new B,this._quat=new Fn().setFromUnitVectors(e.up,new B(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new dr,this._sphericalDelta=new dr,this._scale=1,this._panOffset=new B,this._rotateStart=new Ze,this._rotateEnd=new Ze,this._rotateDelta=new Ze,this._panStart=new Ze,this._panEnd=new Ze,this._panDelta=new Ze,this._dollyStart=new Ze,this._dollyEnd=new Ze,this._dollyDelta=new Ze,this._dollyDirection=new B,this._mouse=new Ze,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=cR.bind(this),this._onPointerDown=lR.bind(this),this._onPointerUp=uR.bind(this),this._onContextMenu=yR.bind(this),this._onMouseWheel=fR.bind(this),this._onKeyDown=pR.bind(this),this._onTouchStart=mR.bind(this),this._onTouchMove=gR.bind(this),this._onMouseDown=hR.bind(this),this._onMouseMove=dR.bind(this),this._interceptControlDown=_R.bind(this),this._interceptControlUp=xR.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(T_),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;wn.copy(t).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ci:n>Math.PI&&(n-=ci),s<-Math.PI?s+=ci:s>Math.PI&&(s-=ci),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),t.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new B(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new B(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(hh.origin.copy(this.object.position),hh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(hh.direction))<aR?this.object.lookAt(this.target):(R_.setFromNormalAndCoplanarPoint(this.object.up,this.target),hh.intersectPlane(R_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>op||8*(1-this._lastQuaternion.dot(this.object.quaternion))>op||this._lastTargetPosition.distanceToSquared(this.target)>op?(this.dispatchEvent(T_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ci/60*this.autoRotateSpeed*e:ci/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){wn.setFromMatrixColumn(t,0),wn.multiplyScalar(-e),this._panOffset.add(wn)}_panUp(e,t){this.screenSpacePanning===!0?wn.setFromMatrixColumn(t,1):(wn.setFromMatrixColumn(t,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(e),this._panOffset.add(wn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ci*this._rotateDelta.x/t.clientHeight),this._rotateUp(ci*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ci*this._rotateDelta.x/t.clientHeight),this._rotateUp(ci*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ze,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function lR(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function cR(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function uR(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(C_),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function hR(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case fr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=At.DOLLY;break;case fr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}break;case fr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(ap)}function dR(i){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function fR(i){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(i.preventDefault(),this.dispatchEvent(ap),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(C_))}function pR(i){this.enabled!==!1&&this._handleKeyDown(i)}function mR(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case pr.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(i),this.state=At.TOUCH_ROTATE;break;case pr.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(i),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case pr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=At.TOUCH_DOLLY_PAN;break;case pr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(ap)}function gR(i){switch(this._trackPointer(i),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=At.NONE}}function yR(i){this.enabled!==!1&&i.preventDefault()}function _R(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function xR(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var P_=["iso","front","side","top","tip"],vR={iso:[.62,-1,.55],front:[1,0,.08],side:[0,-1,.08],top:[0,-.001,1],tip:[.62,-1,.4]},bR=.35,fh=class{constructor(e,t,n,s){this.camera=e;this.canvas=t;this.reach=n;this.changed=s;this.controls=new dh(e,t),this.controls.minDistance=.05*n,this.controls.maxDistance=40*n,this.controls.enableZoom=!1,this.controls.addEventListener("change",s),t.addEventListener("keydown",this.key),t.addEventListener("focus",this.zoomable),t.addEventListener("blur",this.zoomable)}camera;canvas;reach;changed;view="iso";box=new zn;controls;start=new B;end=new B;targetStart=new B;targetEnd=new B;offset=new B;spherical=new dr;began=0;gliding=0;show(e,t,n){this.view=e;let s=this.offset.set(...vR[e]).normalize(),r=e==="tip";r?this.targetEnd.fromArray(t):this.box.getCenter(this.targetEnd);let o=r?.55*this.reach:this.fitting(s,this.targetEnd);if(this.end.copy(this.targetEnd).addScaledVector(s,o),cancelAnimationFrame(this.gliding),!n)return this.place(1);this.start.copy(this.camera.position),this.targetStart.copy(this.controls.target),this.began=performance.now(),this.step(this.began)}take(e){this.view=e.view,this.camera.position.copy(e.camera.position),this.controls.target.copy(e.controls.target),this.controls.update()}follow(e){this.view==="tip"&&(this.offset.copy(this.camera.position).sub(this.controls.target),this.controls.target.fromArray(e),this.camera.position.copy(this.controls.target).add(this.offset),this.camera.lookAt(this.controls.target))}dispose(){cancelAnimationFrame(this.gliding),this.controls.dispose(),this.canvas.removeEventListener("keydown",this.key),this.canvas.removeEventListener("focus",this.zoomable),this.canvas.removeEventListener("blur",this.zoomable)}zoomable=e=>{this.controls.enableZoom=e.type==="focus"};key=e=>{if(e.ctrlKey||e.metaKey||e.altKey)return;let t=ts.degToRad(5),s={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[e.key];if(s&&e.shiftKey)this.pan(.04*s[0],-.04*s[1]);else if(s)this.turn(t*s[0],t*s[1],1);else if(e.key==="+"||e.key==="=")this.turn(0,0,1/1.15);else if(e.key==="-")this.turn(0,0,1.15);else return;e.preventDefault(),e.stopPropagation()};turn(e,t,n){let{camera:s,controls:r,offset:o,spherical:a}=this;o.copy(s.position).sub(r.target),a.setFromCartesianCoords(o.y,o.z,o.x),a.theta+=e,a.phi=ts.clamp(a.phi+t,.001,Math.PI-.001),a.radius=ts.clamp(a.radius*n,r.minDistance,r.maxDistance),o.setFromSpherical(a),s.position.set(o.z,o.x,o.y).add(r.target),r.update(),this.changed()}pan(e,t){let{camera:n,controls:s,offset:r}=this,o=n.position.distanceTo(s.target);for(let[a,l]of[[0,e],[1,t]])r.setFromMatrixColumn(n.matrix,a).multiplyScalar(l*o),n.position.add(r),s.target.add(r);s.update(),this.changed()}fitting(e,t){let{camera:n,box:s}=this,r=Math.tan(ts.degToRad(n.fov/2)),o=new B().crossVectors(n.up,e).normalize(),a=new B().crossVectors(e,o),l=new B,c=.3*this.reach;for(let u=0;u<8;u++){l.set(u&1?s.max.x:s.min.x,u&2?s.max.y:s.min.y,u&4?s.max.z:s.min.z).sub(t);let h=l.dot(e);c=Math.max(c,Math.abs(l.dot(o))/(r*n.aspect)+h,Math.abs(l.dot(a))/r+h)}return 1.18*c}step=e=>{let t=Math.min(1,Math.max(0,(e-this.began)/1e3/bR));this.place(t*t*(3-2*t)),t<1&&(this.gliding=requestAnimationFrame(this.step))};place(e){this.camera.position.lerpVectors(e<1?this.start:this.end,this.end,e),this.controls.target.lerpVectors(e<1?this.targetStart:this.targetEnd,this.targetEnd,e),this.controls.update(),this.changed()}};var L_=[["reference","Reference (ghost)"],["rigid","Rigid plan (ghost)"],["traces","Paths of the tips"],["force","Contact force"],["surface","Surface"],["floor","Floor"],["apart","Side by side"]];var MR={iso:"Oblique",front:"Front",side:"Side",top:"Top",tip:"Tip (follows)"},I_=100;function zt(i,e={},...t){let n=document.createElement(i);return Object.assign(n,e),n.append(...t),n}function D_(i,e,t,n,s){let r=zt("div",{className:"scene-bar",role:"toolbar",ariaLabel:"The robot in space"}),o=lp("Colour",e,i.colour,c=>{i.colour=c,s.changed()});r.append(zt("label",{},"Colour",o)),n&&r.append(wR(i,s));let a=lp("View",P_.map(c=>[c,MR[c]]),"iso",c=>s.look(c));r.append(zt("label",{},"View",a));let l=zt("button",{type:"button",ariaLabel:"Reset view"},"Reset");return l.addEventListener("click",()=>s.look(a.value)),r.append(l,ER(i,t,s)),r}function wR(i,e){let t=zt("input",{type:"range",min:"0",max:String(I_),step:"1",value:"0",ariaLabel:"Deformation"}),n=zt("output",{},"×1");return t.dataset.scene="factor",t.addEventListener("input",()=>{i.factor=AR(200**(Number(t.value)/I_)),n.textContent=t.ariaValueText=`×${i.factor}`,e.changed()}),t.title="How many times the displacement of each robot from itself without elasticity is enlarged; double click: to scale",t.addEventListener("dblclick",()=>{t.value="0",t.dispatchEvent(new Event("input"))}),zt("label",{},"Deformation",t,n)}function AR(i){return i<10?Math.round(10*i)/10:Math.round(i)}function ER(i,e,t){let n=zt("div",{className:"scene-more"});for(let[o,a]of L_){if(!e.includes(o))continue;let l=zt("input",{type:"checkbox",checked:i[o]});l.dataset.scene=o,l.addEventListener("change",()=>{i[o]=l.checked,t.changed(),o==="apart"&&t.look("iso")}),n.append(zt("label",{},l,a))}let s=lp("Quality",[["auto","automatic"],["low","low"],["high","high"]],i.quality,o=>{i.quality=o,t.quality()});n.append(zt("label",{},"Quality",s));let r=zt("details",{},zt("summary",{},"Show"),n);return r.addEventListener("keydown",o=>{o.key==="Escape"&&(r.open=!1,r.querySelector("summary")?.focus())}),r}function lp(i,e,t,n){let s=zt("select",{ariaLabel:i},...e.map(([r,o])=>zt("option",{value:r,textContent:o})));return s.value=t,s.addEventListener("change",()=>n(s.value)),s}var TR={m:[[1e-4,1e6,"µm"],[.5,1e3,"mm"]],Pa:[[1e3,1,"Pa"],[1e6,.001,"kPa"],[1/0,1e-6,"MPa"]],rad:[[.1,1e3,"mrad"]],"N m":[[.1,1e3,"mN m"],[1e4,1,"N m"],[1/0,.001,"kN m"]],N:[[.1,1e3,"mN"],[1e4,1,"N"],[1/0,.001,"kN"]],1:[[.01,1e6,"µm/m"],[1/0,100,"%"]]};function ph(i,e){let t=(TR[i]??[]).find(([n])=>Math.abs(e)<n);return t===void 0||e===0?{factor:1,name:i==="1"?"":i}:{factor:t[1],name:t[2]}}function xs(i){if(!Number.isFinite(i))return"–";let e=Math.abs(i);if(e!==0&&(e>=1e5||e<.001))return i.toExponential(2).replace("-","−");let t=e===0?0:Math.max(0,2-Math.floor(Math.log10(e)));return String(Number(i.toFixed(t))).replace("-","−")}function Ml(i){let e=10**Math.floor(Math.log10(i));return e*(i>=5*e?5:i>=2*e?2:1)}function F_(i){let e=new zn,t=new B,n=.001,s=0;for(let{scene:l}of i.runs){for(let c of[l.line,l.tip])for(let u=0;u+2<c.data.length;u+=3)e.expandByPoint(t.fromArray(c.data,u));n=Math.max(n,RR(l.line.data,l.line.shape));for(let c of l.links)c.section?.sizes.data.forEach(u=>s=Math.max(s,u))}e.isEmpty()&&e.expandByPoint(t.set(0,0,0));let r=Math.max(n,e.getSize(t).length()/2),o=Math.min(Math.max(s,.012*n),.022*n),a=CR(e,i,n);for(let{scene:l}of i.runs)l.line.data.length&&e.expandByPoint(t.fromArray(l.line.data).setZ(a));return{box:e,reach:n,cell:Ml(r/5),usual:o,least:.006*n,floor:a}}function RR(i,[,e,t]){let n=0;for(let s=0;s<e;s++)for(let r=1;r<t;r++){let o=3*(s*t+r);n+=Math.hypot(i[o]-i[o-3],i[o+1]-i[o-2],i[o+2]-i[o-1])}return n}function CR(i,e,t){let n=e.runs[0]?.scene.line.data[2]??0,s=i.max.z-i.min.z>.2*t&&n<t;if(i.min.z>=-.001*t&&s)return 0;let r=Ml(.1*t);return Math.floor((Math.min(i.min.z,n)-.12*t)/r)*r}var cp=["#0072b2","#d55e00","#009e73","#cc79a7","#e69f00","#56b4e9"],PR={link:"#9aa5b1",joint:"#4a5562",gear:"#c76a00",base:"#39434e",payload:"#2b333c",grid:"#c3cad1",gridStrong:"#8e99a4",surface:"#009e73",force:"#b3261e",reference:"#d55e00",rigid:"#6b7681",before:"#7a4ea3",real:"#0072b2",sky:"#ffffff",ground:"#b9c0c8"},LR={link:"#8b96a3",joint:"#a9b4c0",gear:"#e69f00",base:"#6d7986",payload:"#cfd6dd",grid:"#39424c",gridStrong:"#5c6874",surface:"#2fbf95",force:"#ff7b70",reference:"#ff8c42",rigid:"#a3adb7",before:"#c79be8",real:"#56b4e9",sky:"#ffffff",ground:"#5a6570"};function N_(i){return i?LR:PR}var U_="440154 481a6c 472f7d 414487 39568c 31688e 2a788e 23888e 1f988b 22a884 35b779 54c568 7ad151 a5db36 d2e21b fde725",wl=256,_r=IR();function IR(){let i=U_.split(" ").map(t=>[0,2,4].map(n=>parseInt(t.slice(n,n+2),16)/255)),e=new Float32Array(3*wl);for(let t=0;t<wl;t++){let n=t/(wl-1)*(i.length-1),s=Math.min(Math.floor(n),i.length-2);for(let r=0;r<3;r++)e[3*t+r]=i[s][r]+(n-s)*(i[s+1][r]-i[s][r])}return e}function mh(i){return 3*Math.max(0,Math.min(wl-1,Math.round(i*(wl-1))))}function O_(){return`linear-gradient(to top, ${U_.split(" ").map(i=>`#${i}`).join(", ")})`}var B_=5,yh=class{legend=gh("scene-legend");scale=gh("scene-scale");factor=gh("scene-factor");grid=gh("scene-grid");live=zt("span");shown="";constructor(e){e.append(this.legend,this.scale,this.factor,this.grid)}list(e,t){this.legend.replaceChildren(...e.map(({colour:n,label:s})=>zt("span",{},k_(n),s))),t&&this.legend.append(this.live),this.legend.hidden=e.length===0&&!t}tell(e){e!==this.shown&&(this.shown=e,this.live.textContent=e)}range(e){if(this.scale.hidden=e===null,e===null)return;let t=ph(e.unit,e.high),n=Math.abs(e.low)<1e-6*Math.abs(e.high)?0:e.low,s=Array.from({length:B_},(l,c)=>e.high+(n-e.high)*c/(B_-1)),r=k_(O_()),o=t.name.replaceAll(" "," "),a=zt("b",{},o?`${e.label} [${o}]`:e.label);this.scale.replaceChildren(a,zt("ol",{},...s.map(l=>zt("li",{},xs(t.factor*l)))),r)}enlarged(e){this.factor.hidden=e==="",this.factor.textContent=e}floor(e){this.grid.hidden=e==="",this.grid.textContent=e}};function gh(i){return zt("div",{className:`scene-note ${i}`,hidden:!0})}function k_(i){let e=zt("i",{ariaHidden:"true"});return e.style.background=i,e}function z_(){let i=document.createElement("canvas").getContext("webgl2");if(i===null)return null;let e=i.getExtension("WEBGL_debug_renderer_info"),t=String(i.getParameter(e?e.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)?"low":"high"}var _h=class{constructor(e,t){this.quality=e;this.extent=t;let n=e==="high";this.renderer=new lh({canvas:this.canvas,antialias:n,alpha:!0,powerPreference:"low-power"}),this.renderer.setPixelRatio(n?Math.min(window.devicePixelRatio,2):.75*Math.min(window.devicePixelRatio,1)),this.renderer.shadowMap.enabled=n,this.renderer.shadowMap.type=Gr,this.camera.up.set(0,0,1),this.camera.near=.01*t.reach,this.camera.far=100*t.reach,this.scene.add(this.floor)}quality;extent;canvas=document.createElement("canvas");scene=new Ga;camera=new ii(32,1,.01,100);renderer;floor=new In;light=new ol("#ffffff",2.2);dress(e){let{extent:t,light:n}=this;this.undress();let s=t.cell*2*Math.ceil(1.6*t.reach/t.cell),r=new Vr(s,Math.round(s/t.cell),e.gridStrong,e.grid);r.rotation.x=Math.PI/2,r.position.z=t.floor,this.floor.add(r,new il(e.sky,e.ground,1.6),n,n.target);let o=t.box.getCenter(n.target.position);n.position.set(o.x-.6*t.reach,o.y-1.1*t.reach,o.z+2.2*t.reach),this.quality==="high"&&this.shadows(s)}get floorShown(){return this.floor.children[0]?.visible??!1}set floorShown(e){this.floor.children.forEach(t=>{(t instanceof Vr||t instanceof kt)&&(t.visible=e)})}resize(e,t){e<1||t<1||(this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix())}draw(){this.renderer.render(this.scene,this.camera)}dispose(){this.undress(),this.light.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss(),this.canvas.remove()}shadows(e){let{light:t,extent:n}=this;t.castShadow=!0,t.shadow.mapSize.set(2048,2048),t.shadow.normalBias=.2*n.usual;let{camera:s}=t.shadow;s.left=s.bottom=-1.4*n.reach,s.right=s.top=1.4*n.reach,s.near=.1*n.reach,s.far=6*n.reach;let r=new kt(new kr(e,e),new Ka({opacity:.22,depthWrite:!1}));r.position.z=n.floor,r.receiveShadow=!0,this.floor.add(r)}undress(){for(let e of[...this.floor.children])e instanceof Vr?e.dispose():e instanceof kt&&(e.geometry.dispose(),e.material.dispose());this.floor.clear()}};var DR=`
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
`,xh=null;function V_(){xh===null&&(xh=new CSSStyleSheet,xh.replaceSync(DR),document.adoptedStyleSheets=[...document.adoptedStyleSheets,xh])}function vh(i,e,t,n){for(let s=0;4*s<i.length&&n>1;s++){let r=3*n*s,o=e[r+3]-e[r],a=e[r+4]-e[r+1],l=e[r+5]-e[r+2],c=t[r+3]-t[r],u=t[r+4]-t[r+1],h=t[r+5]-t[r+2],d=Math.hypot(o,a,l)*Math.hypot(c,u,h);d>0&&FR(i,4*s,a*h-l*u,l*c-o*h,o*u-a*c,d+o*c+a*u+l*h)}}function FR(i,e,t,n,s,r){let o=Math.hypot(t,n,s,r);if(o===0)return;let a=i[e]/o,l=i[e+1]/o,c=i[e+2]/o,u=i[e+3]/o;i[e]=r*a+t*u+n*c-s*l,i[e+1]=r*l-t*c+n*u+s*a,i[e+2]=r*c+t*l-n*a+s*u,i[e+3]=r*u-t*a-n*l-s*c}var xr=class{constructor(e){this.arrays=e;[this.frames,this.links,this.stations]=e.line.shape;let t=this.links*this.stations*3;this.line=new Float32Array(t),this.once=new Float32Array(t),this.planned=new Float32Array(t),this.rigid=e.rigid?new Float32Array(t):null,this.reference=e.reference?new Float32Array(t):null,this.roots=new Float32Array(this.links*4),this.values=new Float32Array(this.links*this.stations),this.tipPlace=this.nearestEnd()}arrays;links;stations;frames;line;rigid;reference;roots;values;tip=new Float32Array(3);tipReference=new Float32Array(3);force=new Float32Array(3);at=new Float32Array(3);frame=0;share=0;tipPlace;once;planned;seek(e,t,n){this.find(e);let{arrays:s}=this;this.mix(this.line,s.line),this.rigid&&s.rigid&&this.mix(this.rigid,s.rigid),this.reference&&s.reference&&this.mix(this.reference,s.reference),this.turn(),this.mix(this.tip,s.tip),s.tipReference&&this.mix(this.tipReference,s.tipReference),s.contact&&(this.mix(this.force,s.contact.force),this.mix(this.at,s.contact.at)),n&&this.mix(this.values,n),!(t===1||!this.rigid)&&(s.referenceRigid&&this.mix(this.planned,s.referenceRigid),this.enlarge(t,this.rigid,s.referenceRigid?this.planned:this.rigid))}path(e,t){let{arrays:n,frames:s}=this,r=e?n.tipReference:n.tip,o=e?n.reference:n.line,a=e&&n.referenceRigid||n.rigid;if(r===null)return null;let l=Float32Array.from(r.data);if(!a||!o||this.links===0)return l;let c=this.links*this.stations*3;for(let u=0;u<s;u++)for(let h=0;h<3;h++){let d=u*c+this.tipPlace+h;l[3*u+h]+=(t-1)*(o.data[d]-a.data[d])}return l}find(e){let t=this.arrays.times.data,n=0,s=this.frames-1;for(;s-n>1;){let o=n+s>>1;t[o]<=e?n=o:s=o}this.frame=n;let r=s>n?t[s]-t[n]:0;this.share=r>0?Math.min(1,Math.max(0,(e-t[n])/r)):0}mix(e,t){let n=e.length,s=this.frame*n,r=Math.min(this.frame+1,this.frames-1)*n,{data:o}=t;for(let a=0;a<n;a++){let l=o[s+a];e[a]=l+this.share*(o[r+a]-l)}}turn(){let{roots:e}=this;this.mix(e,this.arrays.roots);for(let t=0;t<e.length;t+=4){let n=Math.hypot(e[t],e[t+1],e[t+2],e[t+3])||1;for(let s=0;s<4;s++)e[t+s]/=n}}enlarge(e,t,n){let{line:s,reference:r,tipPlace:o}=this;for(let a=0;a<3&&this.links>0;a++){let l=(e-1)*(s[o+a]-t[o+a]);this.tip[a]+=l,this.at[a]+=l,r&&(this.tipReference[a]+=(e-1)*(r[o+a]-n[o+a]))}this.once.set(s);for(let a=0;a<s.length;a++)s[a]=t[a]+e*(s[a]-t[a]),r&&(r[a]=n[a]+e*(r[a]-n[a]));vh(this.roots,this.once,s,this.stations)}nearestEnd(){let{line:e,tip:t}=this.arrays,n=0,s=1/0;for(let r=0;r<this.links;r++){let o=(r*this.stations+this.stations-1)*3,a=Math.hypot(...[0,1,2].map(l=>e.data[o+l]-t.data[l]));a<=s&&([n,s]=[o,a])}return n}};function G_(i,e=Math.PI/3){let t=i.index?i.toNonIndexed():i,n=t.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let x=0;x<s;x++)r[3*x+0]=n.getX(x),r[3*x+1]=n.getY(x),r[3*x+2]=n.getZ(x)}let o=Math.cos(e),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let x=0;x<l;x++){let R=9*x,w=r[R+0],y=r[R+1],M=r[R+2],N=r[R+3],I=r[R+4],L=r[R+5],k=r[R+6],V=r[R+7],D=r[R+8],H=k-N,$=V-I,G=D-L,le=w-N,Y=y-I,K=M-L,te=$*K-G*Y,fe=G*le-H*K,ue=H*Y-$*le,Q=1/(Math.sqrt(te*te+fe*fe+ue*ue)||1);c[3*x+0]=te*Q,c[3*x+1]=fe*Q,c[3*x+2]=ue*Q}let u=new Int32Array(s),h=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,m=new Int32Array(d),_=0;for(let x=0;x<s;x++){let R=3*x,w=Math.trunc(r[R+0]*a),y=Math.trunc(r[R+1]*a),M=Math.trunc(r[R+2]*a),N=(Math.imul(w,73856093)^Math.imul(y,19349663)^Math.imul(M,83492791))&f;for(;;){let I=m[N];if(I===0){let k=3*_;h[k+0]=w,h[k+1]=y,h[k+2]=M,m[N]=_+1,u[x]=_++;break}let L=3*(I-1);if(h[L+0]===w&&h[L+1]===y&&h[L+2]===M){u[x]=I-1;break}N=N+1&f}}let g=new Int32Array(_+1);for(let x=0;x<s;x++)g[u[x]+1]++;for(let x=0;x<_;x++)g[x+1]+=g[x];let p=new Int32Array(s),v=g.slice(0,_);for(let x=0;x<l;x++){let R=3*x;p[v[u[R+0]]++]=x,p[v[u[R+1]]++]=x,p[v[u[R+2]]++]=x}let T=new Float32Array(s*3);for(let x=0;x<l;x++){let R=3*x,w=c[R+0],y=c[R+1],M=c[R+2];for(let N=0;N<3;N++){let I=R+N,L=u[I],k=0,V=0,D=0;for(let $=g[L],G=g[L+1];$<G;$++){let le=3*p[$],Y=c[le+0],K=c[le+1],te=c[le+2];w*Y+y*K+M*te>o&&(k+=Y,V+=K,D+=te)}let H=1/(Math.sqrt(k*k+V*V+D*D)||1);T[3*I+0]=k*H,T[3*I+1]=V*H,T[3*I+2]=D*H}}return t.setAttribute("normal",new rn(T,3,!1)),t}var H_=[[1,1],[-1,1],[-1,-1],[1,-1]];function NR(i){let e=new Float32Array(2*(i+1));for(let t=0;t<=i;t++)e[2*t]=Math.cos(2*Math.PI*t/i),e[2*t+1]=Math.sin(2*Math.PI*t/i);return{points:e,normals:e}}function UR(){let i=[],e=[];return H_.forEach((t,n)=>{let s=H_[(n+1)%4];i.push(...t,...s);for(let r=0;r<2;r++)e.push((t[0]+s[0])/2,(t[1]+s[1])/2)}),{points:Float32Array.from(i),normals:Float32Array.from(e)}}var bh=class{constructor(e,t,n){this.stations=e;this.section=t;this.outline=t.shape==="round"?NR(n):UR(),this.around=this.outline.points.length/2;let s=(e+2)*this.around;[this.position,this.normal,this.colour]=[0,1,2].map(()=>new Float32Array(3*s)),this.colour.fill(1),["position","normal","color"].forEach((r,o)=>{let a=new rn([this.position,this.normal,this.colour][o],3);this.geometry.setAttribute(r,a.setUsage(zf))}),this.geometry.setIndex(this.faces())}stations;section;geometry=new on;outline;around;position;normal;colour;axes=new Float32Array(9);shape(e,t,n,s){let{stations:r,axes:o}=this;OR(o,n,s);for(let a=0;a<r;a++){let l=t+3*Math.max(a-1,0),c=t+3*Math.min(a+1,r-1);BR(o,e[c]-e[l],e[c+1]-e[l+1],e[c+2]-e[l+2]),this.ring(a,a,e,t+3*a,0),a===0&&this.ring(r,a,e,t,-1),a===r-1&&this.ring(r+1,a,e,t+3*a,1)}this.geometry.attributes.position.needsUpdate=!0,this.geometry.attributes.normal.needsUpdate=!0}paint(e,t,n,s){let{around:r,colour:o,stations:a}=this,l=s>n?s-n:1;for(let c=0;c<a+2;c++){let u=c<a?c:c===a?0:a-1,h=mh((e[t+u]-n)/l);for(let d=3*c*r;d<3*(c+1)*r;d+=3)o[d]=_r[h],o[d+1]=_r[h+1],o[d+2]=_r[h+2]}this.geometry.attributes.color.needsUpdate=!0}dispose(){this.geometry.dispose()}ring(e,t,n,s,r){let{axes:o,around:a,position:l,normal:c,section:u,outline:h}=this,d=u.sizes[2*t],f=u.sizes[2*t+1];for(let m=0;m<a;m++){let _=d*h.points[2*m],g=f*h.points[2*m+1],p=h.normals[2*m],v=h.normals[2*m+1];for(let T=0;T<3;T++){let x=3*(e*a+m)+T;l[x]=n[s+T]+_*o[3+T]+g*o[6+T],c[x]=r===0?p*o[3+T]+v*o[6+T]:r*o[T]}}}faces(){let{around:e,stations:t}=this,n=[];for(let s=0;s<t-1;s++)for(let r=0;r<e-1;r++){let o=s*e+r;n.push(o,o+e,o+1,o+1,o+e,o+e+1)}for(let s=1;s<e-1;s++){let r=t*e,o=r+e;n.push(r,r+s,r+s+1,o,o+s+1,o+s)}for(let s=0;s<n.length;s+=3)[n[s+1],n[s+2]]=[n[s+2],n[s+1]];return n}};function OR(i,e,t){let n=e[t],s=e[t+1],r=e[t+2],o=e[t+3];i[0]=1-2*(s*s+r*r),i[1]=2*(n*s+r*o),i[2]=2*(n*r-s*o),i[3]=2*(n*s-r*o),i[4]=1-2*(n*n+r*r),i[5]=2*(s*r+n*o),i[6]=2*(n*r+s*o),i[7]=2*(s*r-n*o),i[8]=1-2*(n*n+s*s)}function BR(i,e,t,n){let s=Math.hypot(e,t,n);if(s===0)return;let r=e/s,o=t/s,a=n/s,l=i[1]*a-i[2]*o,c=i[2]*r-i[0]*a,u=i[0]*o-i[1]*r,h=1+i[0]*r+i[1]*o+i[2]*a,d=h>1e-9?1/h:0;for(let f=3;f<9;f+=3){let m=c*i[f+2]-u*i[f+1],_=u*i[f]-l*i[f+2],g=l*i[f+1]-c*i[f];i[f]+=m+d*(c*g-u*_),i[f+1]+=_+d*(u*m-l*g),i[f+2]+=g+d*(l*_-c*m)}i[0]=r,i[1]=o,i[2]=a}var W_=new B(0,1,0),kR=.6,Yr=class{constructor(e,t,n,s){this.look=n;this.widths=s;let r=this.material(n.link,!1),o=n.painted==="none"?r:this.material("#ffffff",!0),a=new Set(e.meshes.map(c=>c.link));if(this.sweeps=e.links.map((c,u)=>{if(u>=t.links||!c.bends&&a.has(u))return null;let h=new bh(t.stations,zR(c,t.stations,s),n.fine?24:10);return this.add(new kt(h.geometry,c.bends||n.painted==="all"?o:r)),h}),e.meshes.filter(({link:c})=>c<t.links).forEach(c=>this.surface(c,e.links)),n.opacity<1)return;e.joints.filter(({link:c})=>c<t.links).forEach(c=>this.housing(c,e.links[c.link],a.has(c.link))),e.links.slice(0,t.links).forEach((c,u)=>this.holder(c,u,t,a));let l=new Ja((a.size>0?.5:1.5)*s.usual,24,16);this.payload=this.add(new kt(this.kept(l),this.material(n.payload,!1)))}look;widths;group=new In;sweeps;placed=[];tinted=[];rods=[];pedestals=[];payload=null;trash=[];from=new B;to=new B;quaternion=new Fn;update(e,t,n,s){let{stations:r,roots:o,values:a}=e,l=3*r;this.sweeps.forEach((c,u)=>{c?.shape(t,u*l,o,4*u),this.look.painted!=="none"&&c?.paint(a,u*r,n,s)});for(let{object:c,link:u,turn:h}of this.placed)u<0||(c.position.fromArray(t,u*l),c.quaternion.fromArray(o,4*u),h&&c.quaternion.multiply(h));for(let{material:c,link:u}of this.tinted){let h=mh((a[(u+1)*r-1]-n)/(s-n||1));c.color.setRGB(_r[h],_r[h+1],_r[h+2])}for(let c of this.rods)this.between(c.object,t,c.place,c.link*l);for(let{object:c,link:u}of this.pedestals)this.stand(c,t,u*l);this.payload?.position.copy(this.from.fromArray(e.tip))}dispose(){this.sweeps.forEach(e=>e?.dispose()),this.trash.forEach(e=>e.dispose()),this.group.removeFromParent()}material(e,t){let{opacity:n,fine:s}=this.look,r={polygonOffset:n<1,polygonOffsetFactor:2,polygonOffsetUnits:2},o={transparent:n<1,opacity:n,depthWrite:n>=1,...r},a={color:e,vertexColors:t,...o};return this.kept(s?new Qa({...a,roughness:.5,metalness:.1}):new zr(a))}kept(e){return this.trash.push(e),e}add(e){return e.frustumCulled=!1,e.castShadow=e.receiveShadow=this.look.opacity>=1,this.group.add(e),e}housing(e,t,n){if(t===void 0||n||e.kind==="fixed")return;let s=1.5*this.widths.usual,r=e.kind==="revolute"?new gs(s,s,2.2*s,this.look.fine?32:14):new ar(2*s,2.2*s,2*s),o=this.add(new kt(this.kept(r),this.material(e.elastic?this.look.gear:this.look.joint,!1))),a=new B(...e.axis).normalize();this.placed.push({object:o,link:e.link,turn:new Fn().setFromUnitVectors(W_,a)})}surface(e,t){if(t[e.link]?.bends)return;let n=new on;n.setAttribute("position",new rn(Float32Array.from(e.vertices.data),3)),n.setIndex(new rn(Uint32Array.from(e.faces.data),1));let s=this.kept(G_(n,kR)),r=this.material(this.look.opacity<1?this.look.link:e.colour,!1);this.placed.push({object:this.add(new kt(s,r)),link:e.link,turn:null}),this.look.painted==="all"&&e.link>=0&&this.tinted.push({material:r,link:e.link})}holder(e,t,n,s){let{arrays:r,stations:o}=n,a=3*o*t;if(e.parent<0){if(s.has(-1)||s.has(t))return;let d=new gs(1.8*this.widths.usual,3*this.widths.usual,1,32);this.pedestals.push({object:this.add(new kt(this.kept(d),this.material(this.look.base,!1))),link:t});return}let l=0,c=1/0;for(let d=0;d<o;d++){let f=3*(o*e.parent+d),m=Math.hypot(...[0,1,2].map(_=>r.line.data[f+_]-r.line.data[a+_]));m<c&&([l,c]=[f,m])}if(c<.5*this.widths.usual||s.has(t)&&s.has(e.parent))return;let u=new gs(.8*this.widths.usual,.8*this.widths.usual,1,16),h=this.add(new kt(this.kept(u),this.material(this.look.link,!1)));this.rods.push({object:h,link:t,parent:e.parent,place:l})}between(e,t,n,s){this.from.fromArray(t,n),this.to.fromArray(t,s).sub(this.from);let r=this.to.length();e.position.copy(this.from).addScaledVector(this.to,.5),e.scale.set(1,Math.max(r,1e-9),1),r>0&&e.quaternion.copy(this.quaternion.setFromUnitVectors(W_,this.to.divideScalar(r)))}stand(e,t,n){let s=Math.max(t[n+2]-this.widths.floor,1e-4);e.position.set(t[n],t[n+1],this.widths.floor+s/2),e.scale.set(1,s,1),e.rotation.set(Math.PI/2,0,0)}};function zR(i,e,t){let n=new Float32Array(2*e).fill(t.usual);if(i.section===null)return{shape:"round",sizes:n};let s=i.section.sizes,r=s.shape[0]-1;for(let o=0;o<e;o++)for(let a=0;a<2;a++){let l=Math.round(o/Math.max(e-1,1)*r);n[2*o+a]=Math.max(s.data[2*l+a],t.least)}return{shape:i.section.shape,sizes:n}}var X_=1.6,Sh=class{constructor(e,t,n,s){this.mode=e;let[r,o]=e.rest.shape,a={data:e.rest.data,shape:[1,r,o,3]},l={data:t.roots.data.slice(0,4*r),shape:[1,r,4]},c=e.rest.data.slice(3*(r*o-1),3*r*o);this.motion=new xr({times:{data:Float64Array.of(0),shape:[1]},line:a,rigid:a,reference:null,roots:l,tip:{data:c,shape:[1,3]},tipReference:null,colours:[],contact:null}),this.motion.seek(0,1,null),this.roots=this.motion.roots.slice(),this.size=n*s.extent.reach;let{colours:u,extent:h,fine:d}=s,f={link:u.link,joint:u.joint,gear:u.gear,base:u.base,payload:u.payload,opacity:1,painted:"all",fine:d};this.robot=new Yr(t,this.motion,f,h),this.rest=new Yr(t,this.motion,{...f,link:u.rigid,opacity:.35,painted:"none"},{...h,usual:.8*h.usual}),this.group.add(this.robot.group,this.rest.group),this.rest.update(this.motion,this.motion.line,0,1)}mode;group=new In;motion;robot;rest;size;roots;swing(e){let{mode:t,motion:n,size:s}=this,r=s*Math.cos(e),o=s*Math.sin(e),{line:a,values:l}=n;for(let c=0;c<l.length;c++){let u=0;for(let h=3*c;h<3*c+3;h++){let d=r*t.real.data[h]-o*t.imaginary.data[h];a[h]=t.rest.data[h]+d,u+=d*d}l[c]=Math.sqrt(u)/s}for(let c=0;c<3;c++)n.tip[c]=a[a.length-3+c];n.roots.set(this.roots),vh(n.roots,t.rest.data,a,n.stations),this.robot.update(n,a,0,1)}dispose(){this.robot.dispose(),this.rest.dispose(),this.group.removeFromParent()}};var q_=new zn,Mh=new B,ta=class extends al{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Bt(e,3)),this.setAttribute("uv",new Bt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new hr(t,6,1);return this.setAttribute("instanceStart",new Ii(n,3,0)),this.setAttribute("instanceEnd",new Ii(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new hr(t,6,1);return this.setAttribute("instanceColorStart",new Ii(n,3,0)),this.setAttribute("instanceColorEnd",new Ii(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new ja(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zn);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),q_.setFromBufferAttribute(t),this.boundingBox.union(q_))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Zi),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Mh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Mh)),Mh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Mh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Pe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ze},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};oi.line={uniforms:_l.merge([Pe.common,Pe.fog,Pe.line]),vertexShader:`
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
		`};var vr=class extends Di{constructor(e){super({type:"LineMaterial",uniforms:_l.clone(oi.line.uniforms),vertexShader:oi.line.vertexShader,fragmentShader:oi.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var up=new Rt,$_=new B,Y_=new B,Vn=new Rt,Gn=new Rt,vs=new Rt,hp=new B,dp=new Ot,Hn=new ll,Z_=new B,wh=new zn,Ah=new Zi,bs=new Rt,Ss,Zr;function J_(i,e,t){return bs.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),bs.multiplyScalar(1/bs.w),bs.x=Zr/t.width,bs.y=Zr/t.height,bs.applyMatrix4(i.projectionMatrixInverse),bs.multiplyScalar(1/bs.w),Math.abs(Math.max(bs.x,bs.y))}function VR(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Hn.start.fromBufferAttribute(s,a),Hn.end.fromBufferAttribute(r,a),Hn.applyMatrix4(t);let c=new B,u=new B;Ss.distanceSqToSegment(Hn.start,Hn.end,u,c),u.distanceTo(c)<Zr*.5&&e.push({point:u,pointOnLine:c,distance:Ss.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function GR(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;Ss.at(1,vs),vs.w=1,vs.applyMatrix4(e.matrixWorldInverse),vs.applyMatrix4(n),vs.multiplyScalar(1/vs.w),vs.x*=r.x/2,vs.y*=r.y/2,vs.z=0,hp.copy(vs),dp.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,f=u;d<f;d++){if(Vn.fromBufferAttribute(l,d),Gn.fromBufferAttribute(c,d),Vn.w=1,Gn.w=1,Vn.applyMatrix4(dp),Gn.applyMatrix4(dp),Vn.z>h&&Gn.z>h)continue;if(Vn.z>h){let T=Vn.z-Gn.z,x=(Vn.z-h)/T;Vn.lerp(Gn,x)}else if(Gn.z>h){let T=Gn.z-Vn.z,x=(Gn.z-h)/T;Gn.lerp(Vn,x)}Vn.applyMatrix4(n),Gn.applyMatrix4(n),Vn.multiplyScalar(1/Vn.w),Gn.multiplyScalar(1/Gn.w),Vn.x*=r.x/2,Vn.y*=r.y/2,Gn.x*=r.x/2,Gn.y*=r.y/2,Hn.start.copy(Vn),Hn.start.z=0,Hn.end.copy(Gn),Hn.end.z=0;let _=Hn.closestPointToPointParameter(hp,!0);Hn.at(_,Z_);let g=ts.lerp(Vn.z,Gn.z,_),p=g>=-1&&g<=1,v=hp.distanceTo(Z_)<Zr*.5;if(p&&v){Hn.start.fromBufferAttribute(l,d),Hn.end.fromBufferAttribute(c,d),Hn.start.applyMatrix4(o),Hn.end.applyMatrix4(o);let T=new B,x=new B;Ss.distanceSqToSegment(Hn.start,Hn.end,x,T),t.push({point:x,pointOnLine:T,distance:Ss.origin.distanceTo(x),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var Eh=class extends kt{constructor(e=new ta,t=new vr({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)$_.fromBufferAttribute(t,o),Y_.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+$_.distanceTo(Y_);let r=new hr(s,2,1);return e.setAttribute("instanceDistanceStart",new Ii(r,1,0)),e.setAttribute("instanceDistanceEnd",new Ii(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Ss=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Zr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Ah.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Zr*.5;else{let h=Math.max(s.near,Ah.distanceToPoint(Ss.origin));c=J_(s,h,l.resolution)}if(Ah.radius+=c,Ss.intersectsSphere(Ah)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),wh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Zr*.5;else{let h=Math.max(s.near,wh.distanceToPoint(Ss.origin));u=J_(s,h,l.resolution)}wh.expandByScalar(u),Ss.intersectsBox(wh)!==!1&&(n?VR(this,t):GR(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(up),this.material.uniforms.resolution.value.set(up.z,up.w))}};var Jr=class extends ta{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setPositions(n),this}setColors(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setColors(n),this}setFromPoints(e){let t=e.length-1,n=new Float32Array(6*t);for(let s=0;s<t;s++)n[6*s]=e[s].x,n[6*s+1]=e[s].y,n[6*s+2]=e[s].z||0,n[6*s+3]=e[s+1].x,n[6*s+4]=e[s+1].y,n[6*s+5]=e[s+1].z||0;return super.setPositions(n),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var Th=class extends Eh{constructor(e=new Jr,t=new vr({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};var K_=new B(0,1,0),Rh=class{group=new In;past;rest;length=0;constructor(e,t,n){this.past=new Th(new Jr,new vr({color:t,linewidth:2.5}));let s=new el({color:t,transparent:!0,opacity:.7,dashSize:n,gapSize:n});this.rest=new $o(new on,s),this.past.frustumCulled=this.rest.frustumCulled=!1,this.group.add(this.past,this.rest),this.lay(e)}lay(e){this.length=e.length/3,this.rest.geometry.dispose(),this.past.geometry.dispose(),this.past.geometry=new Jr;let t=new Float32Array(this.length);for(let n=1;n<t.length;n++)t[n]=t[n-1]+Math.hypot(e[3*n]-e[3*n-3],e[3*n+1]-e[3*n-2],e[3*n+2]-e[3*n-1]);this.rest.geometry.setAttribute("position",new rn(e,3)),this.rest.geometry.setAttribute("lineDistance",new rn(t,1)),this.past.visible=this.length>1,this.past.visible&&this.past.geometry.setPositions(e)}seek(e){this.past.geometry.instanceCount=Math.min(e,this.length-1),this.rest.geometry.setDrawRange(e,this.length-e)}dispose(){[this.past.geometry,this.past.material,this.rest.geometry,this.rest.material].forEach(e=>e.dispose()),this.group.removeFromParent()}},Ch=class{constructor(e,t,n){this.wide=t;this.scale=n;let s=new Xo({color:e}),r=new gs(t,t,1,12).translate(0,.5,0),o=new Za(2.6*t,6*t,16).translate(0,-3*t,0);[this.shaft,this.head]=[new kt(r,s),new kt(o,s)],this.parts=[s,r,o],this.group.add(this.shaft,this.head)}wide;scale;group=new In;shaft;head;parts;way=new B;turn=new Fn;point(e,t){let n=this.way.fromArray(e).length(),s=n*this.scale;this.group.visible=s>.5*this.wide,this.group.visible&&(this.group.position.fromArray(t),this.group.quaternion.copy(this.turn.setFromUnitVectors(K_,this.way.divideScalar(n))),this.shaft.scale.set(1,Math.max(s-5*this.wide,1e-6),1),this.head.position.y=s)}dispose(){this.parts.forEach(e=>e.dispose()),this.group.removeFromParent()}};function Q_(i,e,t,n){let s=new zr({color:n,transparent:!0,opacity:.28,side:Fi,depthWrite:!1});return new kt(HR(i,e,t),s)}function HR(i,e,t){let n=[];for(let u=0;u+2<e.length;u+=3)n.push(new B(e[u],e[u+1],e[u+2]));let[s,r,o]=WR(i,n,t),a=n.map(r),[l,c]=[0,1].map(u=>{let h=a.map(d=>d[u]);return[h.reduce((d,f)=>Math.min(d,f),1/0)-o[u],h.reduce((d,f)=>Math.max(d,f),-1/0)+o[u]]});return XR(s,l,c)}function WR(i,e,t){if(i.kind==="plane"){let d=new B(...i.position),[f,m]=j_(new B(...i.normal).normalize());return[(g,p)=>d.clone().addScaledVector(f,g).addScaledVector(m,p),g=>[g.clone().sub(d).dot(f),g.clone().sub(d).dot(m)],[3*t,3*t]]}let n=new B(...i.center),s=i.kind==="cylinder"?new B(...i.axis).normalize():new B(0,0,1),r=e.reduce((d,f)=>d.add(f),new B).divideScalar(Math.max(e.length,1)).sub(n),o=r.addScaledVector(s,-r.dot(s));o.length()<1e-6*i.radius&&o.copy(j_(s)[0]),o.normalize();let a=new B().crossVectors(s,o),{radius:l}=i,c=i.kind==="ball";return[(d,f)=>{let m=c?l*Math.cos(f):l;return n.clone().addScaledVector(o,m*Math.cos(d)).addScaledVector(a,m*Math.sin(d)).addScaledVector(s,c?l*Math.sin(f):f)},d=>{let f=d.clone().sub(n),m=f.dot(s);return[Math.atan2(f.dot(a),f.dot(o)),c?Math.asin(Math.max(-1,Math.min(1,m/(f.length()||1)))):m]},[t/l,c?t/l:t]]}function j_(i){let e=new B().crossVectors(Math.abs(i.z)<.9?new B(0,0,1):K_,i).normalize();return[e,new B().crossVectors(i,e)]}function XR(i,e,t,n=24){let s=[],r=[];for(let a=0;a<=n;a++)for(let l=0;l<=n;l++){s.push(...i(e[0]+(e[1]-e[0])*a/n,t[0]+(t[1]-t[0])*l/n).toArray());let c=a*(n+1)+l;a<n&&l<n&&r.push(c,c+1,c+n+1,c+1,c+n+2,c+n+1)}let o=new on;return o.setAttribute("position",new rn(Float32Array.from(s),3)),o.setIndex(r),o.computeVertexNormals(),o}var Ph=class{constructor(e,t,n,s){this.run=e;this.index=t;this.alone=n;this.shared=s;this.motion=new xr(e.scene)}run;index;alone;shared;group=new In;motion;showsSurface=!0;before=null;robot;ghosts=[];traces=[];arrow=null;surface=null;built="";traced="";get colour(){return this.alone?this.shared.colours.real:cp[this.index%cp.length]}get referenceColour(){return this.alone?this.shared.colours.reference:this.shared.colours.rigid}get changed(){return this.before!==null}replace(e){let{scene:t}=this.run,n=this.motion.arrays.line.shape,s=new xr(e??t);(String(s.arrays.line.shape.slice(1))!==String(n.slice(1))||e!==null!==this.changed)&&(this.built=""),this.before=e===null?null:this.before??new xr(t),this.motion=s,this.traced=""}update(e,t,n){let{motion:s}=this;this.build(t);let r=s.arrays.colours.find(({id:o})=>o===t.colour)?.values??null;s.seek(e,t.factor,r),this.robot.update(s,s.line,n.low,n.high),this.before?.seek(e,t.factor,null);for(let{view:o,of:a}of this.ghosts){let l=a==="before"?this.before?.line:s[a];o.group.visible=a==="before"?l!==void 0:t[a]&&l!==null,o.group.visible&&l&&o.update(a==="before"&&this.before?this.before:s,l,0,1)}this.draw(t)}widen(e,t){let{arrays:n,links:s,stations:r}=this.motion,o=n.colours.find(l=>l.id===e)?.values.data,a=this.run.scene.links.map(l=>l.bends||ex(e)==="all");if(o!==void 0)for(let l=0;l<o.length;l++)a[Math.floor(l/r)%s]&&(o[l]<t.low&&(t.low=o[l]),o[l]>t.high&&(t.high=o[l]))}dispose(){this.clear(),this.group.removeFromParent()}build(e){let t=ex(e.colour);if(t===this.built)return;this.clear(),this.built=t;let{scene:n}=this.run,{extent:s,colours:r,fine:o}=this.shared,a=t==="none"?this.colour:r.link,l=this.alone?r.joint:this.colour,c={link:a,joint:l,gear:this.alone?r.gear:l,base:r.base,payload:l,opacity:1,painted:t,fine:o};this.robot=this.added(n,this.motion,c,1);let u={reference:this.referenceColour,rigid:r.rigid,before:r.before};for(let h of["reference","rigid","before"]){if(h==="before"?!this.before:!n[h])continue;let d={...c,link:u[h],opacity:.42,painted:"none"};this.ghosts.push({view:this.added(n,h==="before"&&this.before?this.before:this.motion,d,.85),of:h})}n.contact&&(this.arrow=new Ch(r.force,.006*s.reach,this.shared.scale),this.surface=Q_(n.contact.surface,n.contact.at.data,.12*s.reach,r.surface),this.group.add(this.arrow.group,this.surface))}added(e,t,n,s){let{extent:r}=this.shared,o={usual:s*r.usual,least:s*r.least,floor:r.floor},a=new Yr(s<1?qR(e,s):e,t,n,o);return this.group.add(a.group),a}draw(e){this.trace(e);for(let{trace:t,reference:n}of this.traces)t.group.visible=e.traces&&(!n||this.motion.arrays.tipReference!==null),t.seek(this.motion.frame);this.surface&&(this.surface.visible=e.surface&&this.showsSurface),this.arrow&&(this.arrow.point(this.motion.force,this.motion.at),this.arrow.group.visible&&=e.force&&this.motion.arrays.contact!==null)}trace(e){let t=`${e.factor}`;if(t===this.traced)return;let n=this.traces.length===0;this.traced=t;for(let s of[!1,!0]){let r=this.motion.path(s,e.factor),o=this.traces.find(a=>a.reference===s);if(r!==null){if(o)o.trace.lay(r);else if(n){let a=s?this.referenceColour:this.colour,l=new Rh(r,a,.012*this.shared.extent.reach);this.traces.push({trace:l,reference:s}),this.group.add(l.group)}}}}clear(){this.robot?.dispose(),this.ghosts.forEach(({view:e})=>e.dispose()),this.traces.forEach(({trace:e})=>e.dispose()),this.arrow?.dispose(),this.surface&&(this.surface.geometry.dispose(),this.surface.material.dispose(),this.surface.removeFromParent()),this.ghosts=[],this.traces=[],this.traced=this.built=""}};function ex(i){return i==="run"?"none":i==="displacement"?"all":"bending"}function qR(i,e){let t=i.links.map(n=>{if(n.section===null)return n;let{data:s,shape:r}=n.section.sizes;return{...n,section:{...n.section,sizes:{data:Float32Array.from(s,o=>e*o),shape:r}}}});return{...i,links:t}}var $R=10;function tx(i,e){let t=0;for(let{scene:n}of i){let s=n.contact?.force.data??[];for(let r=0;r+2<s.length;r+=3)t=Math.max(t,Math.hypot(s[r],s[r+1],s[r+2]))}return i.every(({scene:n})=>n.contact===null)?0:Ml(.35*e/(t||$R))}var Lh=class{constructor(e,t,n,s,r,o){this.extent=t;this.settings=r;this.colours=N_(s),this.stage=new _h(n,t),this.stage.dress(this.colours),this.shared={extent:t,colours:this.colours,fine:n==="high",scale:tx(e.runs,t.reach)},this.runs=e.runs.map((l,c)=>new Ph(l,c,e.runs.length===1,this.shared)),this.runs.forEach(({group:l})=>this.stage.scene.add(l)),this.cameras=new fh(this.stage.camera,this.canvas,t.reach,o),this.canvas.tabIndex=0,this.canvas.setAttribute("role","img");let a="Arrow keys turn the view, with Shift they move it, + and - zoom.";this.canvas.setAttribute("aria-label",`The robot in space: ${e.runs.map(({name:l})=>l).join(", ")}. ${a}`),this.canvas.title=`Drag to turn, right button to move, click and wheel to zoom. ${a}`,this.refresh()}extent;settings;stage;cameras;colours;runs;shared;range={low:0,high:1};mode=null;shown=null;get canvas(){return this.stage.canvas}draw(e,t){this.mode?this.mode.swing(2*Math.PI*t/X_):this.runs.forEach(n=>n.update(e,this.settings,this.range)),this.mode||this.cameras.follow(this.runs[0].motion.tip),this.stage.draw()}replace(e,t){this.runs[e]?.replace(t)}showMode(e,t){this.mode?.dispose(),this.mode=e&&new Sh(e,this.runs[0].run.scene,t,this.shared),this.shown=e,this.mode&&this.stage.scene.add(this.mode.group),this.runs.forEach(({group:n})=>n.visible=e===null)}refresh(){let{settings:e,runs:t}=this,n={low:1/0,high:-1/0};t.forEach(l=>l.widen(e.colour,n)),this.range=n.low<=n.high?n:{low:0,high:0};let{box:s,reach:r}=this.extent,o=e.apart?Math.max(.4*r,s.max.y-s.min.y+.15*r):0,a=t.map(({run:l})=>JSON.stringify(l.scene.contact?.surface));t.forEach((l,c)=>{l.group.position.set(0,(c-(t.length-1)/2)*o,0),l.showsSurface=e.apart||a.indexOf(a[c])===c}),this.cameras.box.copy(s).expandByVector(new B(0,(t.length-1)/2*o,0)),this.stage.floorShown=e.floor}look(e,t){this.cameras.show(e,this.runs[0].motion.tip,t)}takeView(e){this.cameras.take(e.cameras)}resize(e,t){this.stage.resize(e,t)}tell(e){let{settings:t,extent:n,shown:s}=this,r=this.runs.flatMap(({run:a})=>a.scene.colours).find(({id:a})=>a===t.colour);e.list(s?this.modeEntries(s):this.entries(),!s&&this.forceShown()),s?e.range({label:"Displacement, share of the largest",unit:"",low:0,high:1}):e.range(r?{label:r.label,unit:r.unit,...this.range}:null),e.enlarged(t.factor===1||s?"":`Deformation × ${t.factor}`);let o=n.floor===0?"":`, at z = ${xs(n.floor)} m`;e.floor(t.floor?`Grid ${xs(n.cell)} m${o}${this.thick()}`:"")}words(){if(!this.forceShown())return"";let e=n=>xs(Math.hypot(...n));return`Contact force ${this.runs.filter(({run:n})=>n.scene.contact).map(({motion:n})=>`${e(n.force)} N`).join(", ")} (arrow: ${xs(.1/this.shared.scale)} N per 0.1 m)`}dispose(){this.mode?.dispose(),this.runs.forEach(e=>e.dispose()),this.cameras.dispose(),this.stage.dispose()}forceShown(){return this.settings.force&&this.shared.scale>0}entries(){let{settings:e,runs:t,colours:n}=this,s=t.length===1,r=[];s?e.traces&&r.push({colour:n.real,label:"Path of the tip"}):r.push(...t.map(a=>({colour:a.colour,label:a.run.name})));let o=a=>e[a]&&t.some(({run:l})=>l.scene[a]);return o("reference")?r.push({colour:t[0].referenceColour,label:"Reference"}):e.traces&&t.some(({run:a})=>a.scene.tipReference)&&r.push({colour:t[0].referenceColour,label:"Path of the reference"}),o("rigid")&&r.push({colour:n.rigid,label:"Without any elasticity"}),t.some(({changed:a})=>a)&&r.push({colour:n.before,label:"The run as it was"}),r}modeEntries(e){let t=`damping ${xs(100*e.damping)} %`,n=`Mode ${xs(e.frequency)} Hz, ${t}, ${e.livesIn}; motors ${e.case}; slowed, not to scale`;return[{colour:this.colours.rigid,label:"At rest"},{colour:"transparent",label:n}]}thick(){let e=this.runs.flatMap(({run:s})=>s.scene.links.map(({section:r})=>r)),t=e.some(s=>s&&Math.min(...s.sizes.data)<this.extent.least),n=ph("m",2*this.extent.least);return t?`; links are drawn at least ${xs(2*this.extent.least*n.factor)} ${n.name} thick`:e.some(s=>s?.guessed)?"; thickness of links by their stiffness and mass":""}};var YR="This browser draws nothing in 3D (WebGL is missing or switched off), so the robot is not shown here. All curves and numbers of the page are complete without it.";function nx(i,e,t){V_();let n=zt("div",{className:"scene"}),s=zt("div",{className:"scene-view"});i.append(n);let r=e.runs.length>0?z_():null;return r===null?(n.append(s),s.append(zt("p",{className:"scene-message",role:"note"},YR)),{replace:()=>{},showMode:()=>{},resize:()=>{},dispose:()=>n.remove()}):new fp(n,s,e,t,r)}var fp=class{constructor(e,t,n,s,r){this.frame=e;this.view=t;this.page=n;this.clock=s;this.best=r;let{runs:o}=n,a=o.length>1;this.settings={colour:a?"run":o[0].scene.colours[0]?.id??"run",factor:1,reference:!a,rigid:!1,traces:!0,force:!0,surface:!0,floor:!0,apart:!1,quality:"auto"},this.replaced=o.map(()=>null),this.extent=F_(n),this.notes=new yh(t),e.append(this.controls(),t),this.world=this.made(),this.ends.push(s.subscribe(this.ask));let l=new ResizeObserver(()=>this.resize());l.observe(t),this.dark.addEventListener("change",this.remake),this.ends.push(()=>l.disconnect(),()=>this.dark.removeEventListener("change",this.remake)),this.resize(),this.refresh(),this.world.look("iso",!1)}frame;view;page;clock;best;settings;notes;replaced;ends=[];dark=window.matchMedia("(prefers-color-scheme: dark)");still=window.matchMedia("(prefers-reduced-motion: reduce)");extent;world;mode=null;asked=0;replace(e,t){this.replaced[e]=t,this.world.replace(e,t),this.refresh()}showMode(e,t){this.mode=e===null?null:{mode:e,amplitude:t},this.world.showMode(e,t),this.refresh()}resize(){this.world.resize(this.view.clientWidth,this.view.clientHeight),this.ask()}dispose(){cancelAnimationFrame(this.asked),this.ends.forEach(e=>e()),this.world.dispose(),this.frame.remove()}controls(){let{runs:e}=this.page,n=[...new Map(e.flatMap(({scene:a})=>a.colours.map(({id:l,label:c})=>[l,c]))),["run",e.length>1?"each robot its own":"none"]],s=a=>e.some(({scene:l})=>a(l)),o=[["reference",s(a=>a.reference)],["rigid",s(a=>a.rigid)],["traces",!0],["force",s(a=>a.contact)],["surface",s(a=>a.contact)],["floor",!0],["apart",e.length>1]].filter(([,a])=>a).map(([a])=>a);return D_(this.settings,n,o,s(a=>a.rigid),{changed:()=>this.refresh(),look:a=>this.world.look(a,!this.still.matches),quality:this.remake})}made(){let{quality:e}=this.settings,t=new Lh(this.page,this.extent,e==="auto"?this.best:e,this.dark.matches,this.settings,this.ask);return this.view.prepend(t.canvas),t}remake=()=>{let e=this.world;this.world=this.made(),this.world.takeView(e),e.dispose(),this.replaced.forEach((t,n)=>t&&this.world.replace(n,t)),this.mode&&this.world.showMode(this.mode.mode,this.mode.amplitude),this.resize(),this.refresh()};refresh(){this.world.refresh(),this.world.tell(this.notes),this.ask()}ask=()=>{this.asked===0&&(this.asked=requestAnimationFrame(this.draw))};draw=e=>{this.asked=0,this.world.draw(this.clock.time,this.still.matches?0:e/1e3),this.notes.tell(this.world.words()),this.mode&&!this.still.matches&&this.ask()}};function sx(i,e){let t=Math.max(...e.runs.map(w=>w.duration)),n=Zp(t),s=X("div",{class:"scene"}),r=X("div",{class:"facts-panel",role:"region",tabindex:"0","aria-label":"Numbers that matter"}),o=X("div",{class:"sliders-panel",role:"region",tabindex:"0","aria-label":"Settings"}),a=X("div",{class:"side"},o,r),l=X("div",{class:"transport",role:"group","aria-label":"Time"}),c=X("section",{class:"charts","aria-label":"Charts"}),u=e.runs.length>1?` of ${e.runs[0].name}`:"",h=ix(`Elastic line${u}`,e.runs[0].line!==null),d=ix(`Modes of vibration${u}`,e.runs[0].modes.length>0),f=X("p",{class:"note",hidden:!0,text:"These are the modes of the run as it was."});d.body.before(f);let m=X("div",{class:"bar files"});i.classList.add("app"),i.append(X("div",{class:"stage"},s,a),l,c,X("div",{class:"lower"},h.element,d.element),m);let _=nx(s,e,n),g=[_,I0(l,n)],p=M0(r,e),v=Hg(c,e,n),T=e.runs[0].line?E0(h.body,e,n):null,x=e.runs[0].modes.length?Ud(d.body,e,_,n):null;R0(m,e),l.hidden=c.hidden=e.runs.every(w=>w.charts.length===0);function R(w){n.setDuration(Math.max(w?w.times[w.times.length-1]:0,t)),_.replace(0,w?w.scene:null),v.show(w),T?.show(w),p.show(w),f.hidden=w===null}return e.live?g.push(P0(o,e.live,{open:S0,show:R,fileName:`${Od(e.runs[0].name)}_changed`})):e.notLive&&o.append(X("p",{class:"note",text:`Nothing can be changed in this page: ${e.notLive}.`})),{clock:n,side:o,scene:_,show:R,showModes(w){x?.dispose(),d.body.replaceChildren(),f.hidden=!0,d.element.hidden=w.length===0;let[y,...M]=e.runs;x=w.length?Ud(d.body,{...e,runs:[{...y,modes:w},...M]},_,n):null},dispose(){n.pause(),x?.dispose(),[...g,v,...T?[T]:[]].forEach(w=>w.dispose()),i.replaceChildren()}}}function ix(i,e){let t=X("div",{});return{element:X("section",{class:"panel",hidden:!e,"aria-label":i},X("h3",{text:i}),t),body:t}}var Ih=class{constructor(e){this.element=e}element;view=null;base=null;last=null;show(e,t){this.last=e,this.view&&this.base&&ZR(this.base,e)?(this.view.show(JR(e,t)),this.view.showModes([])):this.mount(e)}complete(e){this.last&&(this.last.runs[0].modes=e.runs[0].modes,this.view?.showModes(e.runs[0].modes))}keep(){this.last&&this.mount(this.last)}forget(){this.base=null}mount(e){let t=this.view?.clock,[n,s,r]=[t?.time??0,t?.playing??!1,t?.speed??1];this.view?.dispose(),this.base=e,this.view=sx(this.element,e),this.view.clock.speed=r,this.view.clock.seek(n),s&&this.view.clock.play()}};function ZR(i,e){let[t,n]=[i.runs[0],e.runs[0]],s=o=>o.charts.map(a=>`${a.id}:${a.curves.map(l=>l.label).join()}`).join(";"),r=o=>`${o.scene.line.shape.slice(1).join()}:${o.scene.links.map(a=>a.name).join()}:${o.scene.contact===null}`;return t.name===n.name&&s(t)===s(n)&&r(t)===r(n)&&t.line===null==(n.line===null)}function JR(i,e){let t=i.runs[0],n=Object.entries(i.series).map(([s,r])=>[s,{data:Float64Array.from(r.data),shape:[...r.shape]}]);return{status:t.status,message:t.message,seconds:e.told.seconds?.simulate??0,times:Float64Array.from(i.times.data),series:Object.fromEntries(n),scene:t.scene,line:t.line,facts:Object.fromEntries(t.facts.map(s=>[s.id,{value:s.value,note:s.note}]))}}var pp=1e3;function ox(i,e,t,n){let s=e.map(r=>jR(r,t,n));return i.replaceChildren(...s.map(r=>r.element)),i.hidden=s.length===0,{refresh:()=>s.forEach(r=>r.refresh())}}function jR(i,e,t){let n=jt("slider"),s=X("input",{id:n,type:"range",min:"0",max:String(pp),step:"1"}),r=X("input",{type:"text",inputmode:"decimal",class:"number","aria-label":`${i.label}, typed`,autocomplete:"off"}),o=Ar(i.unit),a=X("label",{for:n},document.createTextNode(i.label));i.symbol&&i.symbol!=="-"&&a.append(X("span",{class:"symbol",text:` ${i.symbol}`}));let l=X("span",{class:"unit",text:i.together?"×":o==="–"?"":o}),c=()=>{let u=KR(i,e);document.activeElement!==r&&(r.value=u===null?"":Un(u)),u!==null&&(s.value=String(Math.round(pp*QR(i,u)))),s.disabled=u===null,s.setAttribute("aria-valuetext",u===null?"not a number":`${Un(u)} ${o}`)};return s.addEventListener("input",()=>{rx(i,e,eC(i,Number(s.value)/pp)),c(),t()}),r.addEventListener("change",()=>{let u=Xh(r.value);typeof u=="number"&&(rx(i,e,u),t()),c()}),c(),{element:X("div",{class:"slider","data-slider":i.targets[0].steps.join(".")},a,s,r,l),refresh:c}}function KR(i,e){let[t]=i.targets,n=Er(e,t.steps)??(t.steps[0]==="real"?1:null);return typeof n!="number"?null:i.together?n/t.base:n}function rx(i,e,t){for(let n of i.targets)Dl(e,n.steps,i.together?n.base*t:t)}function QR(i,e){let t=i.log?Math.log(e/i.min)/Math.log(i.max/i.min):(e-i.min)/(i.max-i.min);return Math.min(Math.max(Number.isFinite(t)?t:0,0),1)}function eC(i,e){let t=i.log?i.min*(i.max/i.min)**e:i.min+(i.max-i.min)*e;return Number(t.toPrecision(4))}var ax=300;async function tC(){location.search&&history.replaceState(null,"",location.pathname);let i=X("form",{class:"sheet","aria-label":"Data sheet"}),e=X("div",{class:"sliders",role:"group","aria-label":"Sliders"}),t=X("main",{class:"view",id:"main"}),n=X("select",{id:jt("robots")}),s=$p(),r=null,o=null,a=null,l=0;i.addEventListener("submit",y=>y.preventDefault());let c=new Ih(t),u=new Nl({begun(){clearTimeout(l),l=window.setTimeout(()=>s.progress("waiting",0),ax)},progress:(y,M)=>{M>ax&&s.progress(y.stage,y.share)},done(y,M,N){clearTimeout(l),s.done(y,M,N),o?.mark([]),c.show(y,M),t.classList.remove("stale")},whole:y=>c.complete(y),wrong:h,cancelled(){clearTimeout(l),s.say("Cancelled: what is shown is the run before."),t.classList.add("stale")}});function h(y){clearTimeout(l),s.wrong(y,M=>{M.steps&&o?.focus(M.steps)}),o?.mark(y),t.classList.add("stale")}function d(y){r&&(a?.refresh(),y&&f(r),u.want(r.sheet))}async function f(y){let M=await Kt.check(y.sheet).catch(()=>null);!M||r!==y||(y.units=M.units,a=m({...M,sheet:y.sheet}))}function m(y){return ox(e,y.sliders,y.sheet,()=>{o?.refresh(),u.want(y.sheet)})}async function _(y,M){let N=await Kt.schema(y.kind);r=y,c.forget(),o=new Fl(i,new Ul(N),y.sheet,y.units,d),a=m(y),document.title=`${y.name} – tmodes studio`,s.loaded(M,y.warnings),u.want(y.sheet)}let g={sheet:()=>r?.sheet??null,name:()=>r?.name??"robot",runner:u,load:(y,M)=>{cs(g,()=>_(y,M))},wrong:h,say:s.say},p=0,v=y=>cs(g,async()=>{let M=++p,N=y.startsWith("./")?await Kt.study(y.slice(2)):await Kt.robot(y);M===p&&await _(N,y.replace("./",""))});n.addEventListener("change",()=>{n.value&&v(n.value)});let T=yt("Cancel",()=>{u.cancel()},{class:"warn",hidden:!0});s.cancel(T);let x=X("header",{class:"bar top"},X("strong",{text:"tmodes studio",class:"brand"}),X("span",{class:"pick"},X("label",{for:n.id,text:"Robot"}),n),kp(g),zp(g),Vp(g),yt("Keep as ghost",()=>c.keep(),{title:"Compare the runs to come with the one that is shown"}),T),R=X("a",{href:"#main",class:"skip",text:"Skip to the view"});document.body.append(R,x,s.element,X("div",{class:"studio"},X("aside",{class:"controls","aria-label":"Numbers"},X("h2",{text:"Drag"}),e,X("h2",{text:"Data sheet"}),i),t));let w=document.body.dataset.first??"";await cs(g,async()=>{let y=(await Kt.robots()).robots;n.replaceChildren(...w.startsWith("./")?[X("option",{value:w,text:w.slice(2)})]:[],...y.map(N=>X("option",{value:N.name,text:N.name,title:N.title})));let M=w||(y.find(N=>N.kind==="robot")??y[0]).name;n.value=M,await v(M)})}tC();})();
