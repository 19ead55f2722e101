(()=>{var Kh='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helveti\
ca Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-t\
itle {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {over\
flow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;te\
xt-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th \
> * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inl\
ine.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: po\
inter;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: \
absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz \
.u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 soli\
d;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}\
.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var Qh=':root { --actual: #1d5fbf; --actual-more: #0f7f83; --expected: #b35309; }\n@media (prefers-color-scheme: dark) { :root { --actual: #7db4ff; --actual-more\
: #5fd0c5; --expected: #ffb45c; } }\n.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 20rem), 1fr)); gap: 1rem; }\n.plots figure {\
 min-width: 0; margin: 0; }\n.plots figcaption { font-weight: 600; }\n.plot { min-width: 0; }\n.u-legend { font-size: .82rem; text-align: left; }\n.uplot .u-legend \
tr, .uplot .u-legend td, .uplot .u-legend th { padding: 0 .3rem; border: 0; }\n.uplot .u-legend tr { display: inline-block; padding: 0 .4rem 0 0; }\n.uplot .u-leg\
end th { display: inline-flex; align-items: center; font-weight: 400; }\n.uplot .u-legend td { display: inline-block; font-variant-numeric: tabular-nums; }\n.uplo\
t .u-legend tbody { display: block; }\n.uplot .u-legend .ring .u-marker { border-radius: 50%; }\n.u-inline.u-live th::after { color: var(--soft); }\n.uplot .u-curs\
or-x { border-right: 1px dashed var(--soft); }\n.uplot .u-select { background: color-mix(in srgb, var(--actual) 20%, transparent); }\n.view3d { position: relative\
; height: 22rem; border: 1px solid var(--line); border-radius: .4rem; background: var(--panel);\n  overflow: hidden; }\n.view3d canvas { display: block; width: 10\
0%; height: 100%; cursor: grab; touch-action: pan-y; }\n.controls { display: flex; flex-wrap: wrap; align-items: center; gap: .5rem .9rem; margin: .5rem 0; }\n.co\
ntrols input[type="range"] { flex: 1 1 12rem; min-width: 0; accent-color: var(--actual); }\n.controls button { padding: .25rem .8rem; border: 1px solid var(--sof\
t); border-radius: .4rem; background: var(--panel);\n  color: var(--ink); font: inherit; cursor: pointer; }\n.controls button[aria-pressed="true"] { border-width:\
 2px; font-weight: 600; }\n.controls :focus-visible, .view3d canvas:focus-visible { outline: 3px solid #3b82f6; outline-offset: 2px; }\n.controls output { flex: 1\
 1 100%; font-variant-numeric: tabular-nums; }\n.key { display: inline-flex; align-items: center; gap: .35rem; margin-right: 1rem; }\n.key svg { flex: none; width\
: 2.2rem; height: 1rem; }\n.viewer { flex: 0 0 100%; min-width: 0; }\n.viewer .stack, .viewer .controls { max-width: 46rem; }\n.viewer .stack { position: relative;\
 border: 1px solid var(--line); }\n.viewer .stack img { display: block; width: 100%; max-width: none; image-rendering: pixelated; }\n.viewer .stack .over { positi\
on: absolute; inset: 0; }\n.viewer .stack .edge { position: absolute; top: 0; bottom: 0; width: 2px; margin-left: -1px; background: #fff;\n  box-shadow: 0 0 0 1px\
 #000; }\n.viewer .tag { position: absolute; top: .4rem; left: .4rem; padding: 0 .5rem; border-radius: .3rem; background: #000b;\n  color: #fff; font-size: .82rem\
; }\n.viewer .tag.right { left: auto; right: .4rem; }\n.viewer .stack [hidden] { display: none; }\n';var Km="uplot",Qm="u-hz",jm="u-vt",eg="u-title",tg="u-wrap",ng="u-under",ig="u-over",sg="u-axis",Ls="u-off",rg="u-select",og="u-cursor-x",ag="u-cursor-y",lg="u-\
cursor-pt",cg="u-legend",ug="u-live",hg="u-inline",fg="u-series",dg="u-marker",jh="u-label",pg="u-value",jr="width",eo="height";var ef="bottom",ir="left",Ic="right",Zc="#000",tf=Zc+"0",Lc="mousemove",nf="mousedown",Dc="mouseup",sf="mouseenter",rf="mouseleave",of="dblclick",mg="resize",gg="\
scroll",af="change",la="dppxchange",Jc="--",ur=typeof window<"u",Bc=ur?document:null,rr=ur?window:null,_g=ur?navigator:null,Mt,sa;function zc(){let i=devicePixelRatio;
Mt!=i&&(Mt=i,sa&&Vc(af,sa,zc),sa=matchMedia("(min-resolution: ".concat(Mt-.001,"dppx) and (max-resolution: ").concat(Mt+.001,"dppx)")),Ds(af,sa,zc),rr.dispatchEvent(
new CustomEvent(la)))}function Hn(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function kc(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function zt(i,e,t){
i.style[e]=t+"px"}function ui(i,e,t,n){let s=Bc.createElement(i);return e!=null&&Hn(s,e),t?.insertBefore(s,n),s}function ti(i,e){return ui("div",i,e)}var lf=new WeakMap;
function Ci(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=lf.get(i);r!=o&&(i.style.transform=r,lf.set(i,r),e<0||t<0||e>n||t>s?Hn(i,Ls):kc(i,Ls))}var cf=new WeakMap;
function uf(i,e,t){let n=e+t,s=cf.get(i);n!=s&&(cf.set(i,n),i.style.background=e,i.style.borderColor=t)}var hf=new WeakMap;function ff(i,e,t,n){let s=e+""+t,r=hf.
get(i);s!=r&&(hf.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var $c={passive:!0},xg={...$c,
capture:!0};function Ds(i,e,t,n){e.addEventListener(i,t,n?xg:$c)}function Vc(i,e,t,n){e.removeEventListener(i,t,$c)}ur&&zc();function hi(i,e,t,n){let s;t=t||0,n=
n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Wn((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function kf(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=
s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Vf=i=>i!=null,Gf=i=>i!=null&&i>0,ha=kf(Vf),vg=kf(Gf);function yg(i,e,t,n=0,s=!1){
let r=s?vg:ha,o=s?Gf:Vf;[e,t]=r(i,e,t);let a=i[e],c=i[e];if(e>-1)if(n==1)a=i[e],c=i[t];else if(n==-1)a=i[t],c=i[e];else for(let l=e;l<=t;l++){let u=i[l];o(u)&&(u<
a?a=u:u>c&&(c=u))}return[a??Lt,c??-Lt]}function fa(i,e,t,n){let s=mf(i),r=mf(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Hi:Hf,a=s==1?Wn:ni,c=r==1?ni:Wn,
l=a(o(un(i))),u=c(o(un(e))),f=or(t,l),h=or(t,u);return t==10&&(l<0&&(f=Dt(f,-l)),u<0&&(h=Dt(h,-u))),n||t==2?(i=f*s,e=h*r):(i=Yf(i,f),e=da(e,h)),[i,e]}function Kc(i,e,t,n){
let s=fa(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Qc=.1,df={mode:3,pad:Qc},no={pad:0,soft:null,mode:0},Sg={min:no,max:no};function ca(i,e,t,n){return pa(
t)?pf(i,e,t):(no.pad=t,no.soft=n?0:null,no.mode=n?3:0,pf(i,e,Sg))}function yt(i,e){return i??e}function Mg(i,e,t){for(e=yt(e,0),t=yt(t,i.length-1);e<=t;){if(i[e]!=
null)return!0;e++}return!1}function pf(i,e,t){let n=t.min,s=t.max,r=yt(n.pad,0),o=yt(s.pad,0),a=yt(n.hard,-Lt),c=yt(s.hard,Lt),l=yt(n.soft,Lt),u=yt(s.soft,-Lt),
f=yt(n.mode,0),h=yt(s.mode,0),d=e-i,x=Hi(d),S=Dn(un(i),un(e)),p=Hi(S),m=un(p-x);(d<1e-24||m>10)&&(d=0,(i==0||e==0)&&(d=1e-24,f==2&&l!=Lt&&(r=0),h==2&&u!=-Lt&&(o=
0)));let v=d||S||1e3,A=Hi(v),M=or(10,Wn(A)),P=v*(d==0?i==0?.1:1:r),E=Dt(Yf(i-P,M/10),24),_=i>=l&&(f==1||f==3&&E<=l||f==2&&E>=l)?l:Lt,T=Dn(a,E<_&&i>=_?_:fi(_,E)),
O=v*(d==0?e==0?.1:1:o),D=Dt(da(e+O,M/10),24),L=e<=u&&(h==1||h==3&&D>=u||h==2&&D<=u)?u:-Lt,V=fi(c,D>L&&e<=L?L:Dn(L,D));return T==V&&T==0&&(V=100),[T,V]}var bg=new Intl.
NumberFormat(ur?_g.language:"en-US"),jc=i=>bg.format(i),Xn=Math,aa=Xn.PI,un=Xn.abs,Wn=Xn.floor,cn=Xn.round,ni=Xn.ceil,fi=Xn.min,Dn=Xn.max,or=Xn.pow,mf=Xn.sign,Hi=Xn.
log10,Hf=Xn.log2,wg=(i,e=1)=>Xn.sinh(i)*e,Nc=(i,e=1)=>Xn.asinh(i/e),Lt=1/0;function gf(i){return(Hi((i^i>>31)-(i>>31))|0)+1}function Gc(i,e,t){return fi(Dn(i,e),
t)}function Wf(i){return typeof i=="function"}function mt(i){return Wf(i)?i:()=>i}var Tg=()=>{},Xf=i=>i,qf=(i,e)=>e,Ag=i=>null,_f=i=>!0,xf=(i,e)=>i==e,Eg=/\.\d*?(?=9{6,}|0{6,})/gm,
Ns=i=>{if(Jf(i)||ds.has(i))return i;let e="".concat(i),t=e.match(Eg);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+"".
concat(Ns(s),"e").concat(r)}return Dt(i,n)};function Ps(i,e){return Ns(Dt(Ns(i/e))*e)}function da(i,e){return Ns(ni(Ns(i/e))*e)}function Yf(i,e){return Ns(Wn(Ns(
i/e))*e)}function Dt(i,e=0){if(Jf(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return cn(n)/t}var ds=new Map;function Zf(i){return((""+i).split(".")[1]||"").
length}function so(i,e,t,n){let s=[],r=n.map(Zf);for(let o=e;o<t;o++){let a=un(o),c=Dt(or(i,o),a);for(let l=0;l<n.length;l++){let u=i==10?+"".concat(n[l],"e").concat(
o):n[l]*c,f=(o>=0?0:a)+(o>=r[l]?0:r[l]),h=i==10?u:Dt(u,f);s.push(h),ds.set(h,f)}}return s}var io={},eu=[],ar=[null,null],fs=Array.isArray,Jf=Number.isInteger,Cg=i=>i===
void 0;function vf(i){return typeof i=="string"}function pa(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Rg(i){return i!=null&&
typeof i=="object"}var Pg=Object.getPrototypeOf(Uint8Array),$f="__proto__";function lr(i,e=pa){let t;if(fs(i)){let n=i.find(s=>s!=null);if(fs(n)||e(n)){t=Array(
i.length);for(let s=0;s<i.length;s++)t[s]=lr(i[s],e)}else t=i.slice()}else if(i instanceof Pg)t=i.slice();else if(e(i)){t={};for(let n in i)n!=$f&&(t[n]=lr(i[n],
e))}else t=i;return t}function rn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=$f&&(pa(i[s])?rn(i[s],lr(n[s])):i[s]=lr(n[s]))}return i}
var Ig=0,Lg=1,Dg=2;function Ng(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=
s++]=null}}}function Ug(i,e){if(Bg(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return zg(o[0])||(o=Og(o)),o}let t=new Set;for(let o=0;o<
i.length;o++){let c=i[o][0],l=c.length;for(let u=0;u<l;u++)t.add(c[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(
n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],f=Array(s).fill(void 0),h=e?e[o][l]:Lg,d=[];for(let x=0;x<u.length;x++){
let S=u[x],p=r.get(c[x]);S===null?h!=Ig&&(f[p]=S,h==Dg&&d.push(p)):f[p]=S}Ng(f,d,s),n.push(f)}}return n}var Fg=typeof queueMicrotask>"u"?i=>Promise.resolve().then(
i):queueMicrotask;function Og(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){
let o=i[r],a=Array(t);for(let c=0;c<t;c++)a[c]=o[n[c]];s.push(a)}return s}function Bg(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.
length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function zg(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==
null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Dn(1,Wn((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}
var Kf=["January","February","March","April","May","June","July","August","September","October","November","December"],Qf=["Sunday","Monday","Tuesday","Wednesda\
y","Thursday","Friday","Saturday"];function jf(i){return i.slice(0,3)}var kg=Qf.map(jf),Vg=Kf.map(jf),Gg={MMMM:Kf,MMM:Vg,WWWW:Qf,WWW:kg};function Qr(i){return(i<
10?"0":"")+i}function Hg(i){return(i<10?"00":i<100?"0":"")+i}var Wg={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],
MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Qr(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Qr(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.
getDay()],HH:i=>Qr(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?
"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Qr(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Qr(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Hg(i.getMilliseconds())};
function tu(i,e){e=e||Gg;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Wg[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)
o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Xg=new Intl.DateTimeFormat().resolvedOptions().timeZone;function qg(i,e){let t;return e=="UTC"||e=="Etc/UT\
C"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==Xg?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var ed=i=>i%
1==0,ua=[1,2,2.5,5],Yg=so(10,-32,0,ua),td=so(10,0,32,ua),Zg=td.filter(ed),Is=Yg.concat(td),nu="\n",nd="{YYYY}",yf=nu+nd,id="{M}/{D}",to=nu+id,ra=to+"/{YY}",sd="\
{aa}",Jg="{h}:{mm}",sr=Jg+sd,Sf=nu+sr,Mf=":{ss}",wt=null;function rd(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,c=(i==1?so(10,0,3,ua).filter(ed):so(10,-3,
0,ua)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,
o*25,o*50,o*100]),l=[[o,nd,wt,wt,wt,wt,wt,wt,1],[s*28,"{MMM}",yf,wt,wt,wt,wt,wt,1],[s,id,yf,wt,wt,wt,wt,wt,1],[n,"{h}"+sd,ra,wt,to,wt,wt,wt,1],[t,sr,ra,wt,to,wt,
wt,wt,1],[e,Mf,ra+" "+sr,wt,to+" "+sr,wt,Sf,wt,1],[i,Mf+".{fff}",ra+" "+sr,wt,to+" "+sr,wt,Sf,wt,1]];function u(f){return(h,d,x,S,p,m)=>{let v=[],A=p>=o,M=p>=r&&
p<o,P=f(x),E=Dt(P*i,3),_=Uc(P.getFullYear(),A?0:P.getMonth(),M||A?1:P.getDate()),T=Dt(_*i,3);if(M||A){let O=M?p/r:0,D=A?p/o:0,L=E==T?E:Dt(Uc(_.getFullYear()+D,_.
getMonth()+O,1)*i,3),V=new Date(cn(L/i)),H=V.getFullYear(),N=V.getMonth();for(let G=0;L<=S;G++){let J=Uc(H+D*G,N+O*G,1),k=J-f(Dt(J*i,3));L=Dt((+J+k)*i,3),L<=S&&
v.push(L)}}else{let O=p>=s?s:p,D=Wn(x)-Wn(E),L=T+D+da(E-T,O);v.push(L);let V=f(L),H=V.getHours()+V.getMinutes()/t+V.getSeconds()/n,N=p/n,G=h.axes[d]._space,J=m/
G;for(;L=Dt(L+p,i==1?0:3),!(L>S);)if(N>1){let k=Wn(Dt(H+N,6))%24,Q=f(L).getHours()-k;Q>1&&(Q=-1),L-=Q*n,H=(H+N)%24;let ie=v[v.length-1];Dt((L-ie)/p,3)*J>=.7&&v.
push(L)}else v.push(L)}return v}}return[c,l,u]}var[$g,Kg,Qg]=rd(1),[jg,e0,t0]=rd(.001);so(2,-53,53,[1]);function bf(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||
n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function wf(i,e){return(t,n,s,r,o)=>{let a=e.find(x=>o>=x[0])||e[e.length-1],c,l,u,f,h,d;return n.map(x=>{let S=i(x),p=S.getFullYear(),
m=S.getMonth(),v=S.getDate(),A=S.getHours(),M=S.getMinutes(),P=S.getSeconds(),E=p!=c&&a[2]||m!=l&&a[3]||v!=u&&a[4]||A!=f&&a[5]||M!=h&&a[6]||P!=d&&a[7]||a[1];return c=
p,l=m,u=v,f=A,h=M,d=P,E(S)})}}function n0(i,e){let t=tu(e);return(n,s,r,o,a)=>s.map(c=>t(i(c)))}function Uc(i,e,t){return new Date(i,e,t)}function Tf(i,e){return e(
i)}var i0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Af(i,e){return(t,n,s,r)=>r==null?Jc:e(i(n))}function s0(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.
points.width?t.points.stroke(i,e):null}function r0(i,e){return i.series[e].fill(i,e)}var o0={show:!0,live:!0,isolate:!1,mount:Tg,markers:{show:!0,width:2,stroke:s0,
fill:r0,dash:"solid"},idx:null,idxs:null,values:[]};function a0(i,e){let t=i.cursor.points,n=ti(),s=t.size(i,e);zt(n,jr,s),zt(n,eo,s);let r=s/-2;zt(n,"marginLef\
t",r),zt(n,"marginTop",r);let o=t.width(i,e,s);return o&&zt(n,"borderWidth",o),n}function l0(i,e){let t=i.series[e].points;return t._fill||t._stroke}function c0(i,e){
let t=i.series[e].points;return t._stroke||t._fill}function u0(i,e){return i.series[e].points.size}var Fc=[0,0];function h0(i,e,t){return Fc[0]=e,Fc[1]=t,Fc}function oa(i,e,t,n=!0){
return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Oc(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var f0={show:!0,x:!0,y:!0,lock:!1,move:h0,points:{one:!1,
show:a0,size:u0,width:0,stroke:c0,fill:l0},bind:{mousedown:oa,mouseup:oa,click:oa,dblclick:oa,mousemove:Oc,mouseleave:Oc,mouseenter:Oc},drag:{setScale:!0,x:!0,y:!1,
dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,
bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},od={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},iu=rn({},od,{filter:qf}),ad=rn({},iu,{size:10}),
ld=rn({},od,{show:!1}),su='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI E\
moji", "Segoe UI Symbol", "Noto Color Emoji"',cd="bold "+su,ud=1.5,Ef={show:!0,scale:"x",stroke:Zc,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:cd,
side:2,grid:iu,ticks:ad,border:ld,font:su,lineGap:ud,rotate:0},d0="Value",p0="Time",Cf={show:!0,scale:"x",auto:!1,sorted:1,min:Lt,max:-Lt,idxs:[]};function m0(i,e,t,n,s){
return e.map(r=>r==null?"":jc(r))}function g0(i,e,t,n,s,r,o){let a=[],c=ds.get(s)||0;t=o?t:Dt(da(t,s),c);for(let l=t;l<=n;l=Dt(l+s,c))a.push(Object.is(l,-0)?0:l);
return a}function Hc(i,e,t,n,s,r,o){let a=[],c=i.scales[i.axes[e].scale].log,l=c==10?Hi:Hf,u=Wn(l(t));s=or(c,u),c==10&&(s=Is[hi(s,Is)]);let f=t,h=s*c;c==10&&(h=
Is[hi(h,Is)]);do a.push(f),f=f+s,c==10&&!ds.has(f)&&(f=Dt(f,ds.get(s))),f>=h&&(s=f,h=s*c,c==10&&(h=Is[hi(h,Is)]));while(f<=n);return a}function _0(i,e,t,n,s,r,o){
let c=i.scales[i.axes[e].scale].asinh,l=n>c?Hc(i,e,Dn(c,t),n,s):[c],u=n>=0&&t<=0?[0]:[];return(t<-c?Hc(i,e,Dn(c,-n),-t,s):[c]).reverse().map(h=>-h).concat(u,l)}
var hd=/./,x0=/[12357]/,v0=/[125]/,Rf=/1/,Wc=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function y0(i,e,t,n,s){let r=i.
axes[t],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,u=c(10,o),f=c(9,o)-u>=l?hd:c(7,o)-u>=l?x0:c(5,o)-u>=l?v0:Rf;if(f==Rf){let h=un(c(1,o)-u);if(h<l)return Wc(
e.slice().reverse(),a.distr,f,ni(l/h)).reverse()}return Wc(e,a.distr,f,1)}function S0(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,c=i.valToPos,l=un(c(1,o)-c(
2,o));return l<a?Wc(e.slice().reverse(),3,hd,ni(a/l)).reverse():e}function M0(i,e,t,n){return n==null?Jc:e==null?"":jc(e)}var Pf={show:!0,scale:"y",stroke:Zc,space:30,
gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:cd,side:3,grid:iu,ticks:ad,border:ld,font:su,lineGap:ud,rotate:0};function b0(i,e){let t=3+(i||1)*2;return Dt(
t*e,3)}function w0(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=un(o-r),c=i.series[e],l=a/(c.points.
space*Mt);return n[1]-n[0]<=l}var If={scale:null,auto:!0,sorted:0,min:Lt,max:-Lt},fd=(i,e,t,n,s)=>s,Lf={show:!0,auto:!0,sorted:0,gaps:fd,alpha:1,facets:[rn({},If,
{scale:"x"}),rn({},If,{scale:"y"})]},Df={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:fd,alpha:1,points:{show:w0,filter:null},values:null,min:Lt,max:-Lt,
idxs:[],path:null,clip:null};function T0(i,e,t,n,s){return t/10}var dd={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},A0=rn({},dd,{time:!1,
ori:1}),Nf={};function pd(i,e){let t=Nf[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let u=0;u<
t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,c,l)}},i!=null&&(Nf[i]=t)),t}var cr=1,Xc=2;function Us(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:
i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],f=n==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,x=a.
width,S=a.height,p=i.valToPosH,m=i.valToPosV;return u.ori==0?t(s,c,l,u,f,p,m,h,d,x,S,ga,hr,xa,gd,xd):t(s,c,l,u,f,m,p,d,h,S,x,_a,fr,au,_d,vd)}function ru(i,e){let t=0,
n=0,s=yt(i.bands,eu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function E0(i,e,t,n,s){
let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Wi(i,e,t,n,s,r){
return Us(i,e,(o,a,c,l,u,f,h,d,x,S,p)=>{let m=o.pxRound,v=l.dir*(l.ori==0?1:-1),A=l.ori==0?hr:fr,M,P;v==1?(M=t,P=n):(M=n,P=t);let E=m(f(a[M],l,S,d)),_=m(h(c[M],
u,p,x)),T=m(f(a[P],l,S,d)),O=m(h(r==1?u.max:u.min,u,p,x)),D=new Path2D(s);return A(D,T,O),A(D,E,O),A(D,E,_),D})}function ma(i,e,t,n,s,r){let o=null;if(i.length>
0){o=new Path2D;let a=e==0?xa:au,c=t;for(let f=0;f<i.length;f++){let h=i[f];if(h[1]>h[0]){let d=h[0]-c;d>0&&a(o,c,n,d,n+r),c=h[1]}}let l=t+s-c,u=10;l>0&&a(o,c,n-
u/2,l,n+r+u)}return o}function C0(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function ou(i,e,t,n,s,r,o){let a=[],c=i.length;for(let l=s==1?t:n;l>=
t&&l<=n;l+=s)if(e[l]===null){let f=l,h=l;if(s==1)for(;++l<=n&&e[l]===null;)h=l;else for(;--l>=t&&e[l]===null;)h=l;let d=r(i[f]),x=h==f?d:r(i[h]),S=f-s;d=o<=0&&S>=
0&&S<c?r(i[S]):d;let m=h+s;x=o>=0&&m>=0&&m<c?r(i[m]):x,x>=d&&a.push([d,x])}return a}function Uf(i){return i==0?Xf:i==1?cn:e=>Ps(e,i)}function md(i){let e=i==0?ga:
_a,t=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{
l==0&&u==0?n(s,r,o,a,c):(l=fi(l,a/2,c/2),u=fi(u,a/2,c/2),e(s,r+l,o),t(s,r+a,o,r+a,o+c,l),t(s,r+a,o+c,r,o+c,u),t(s,r,o+c,r,o,u),t(s,r,o,r+a,o,l),s.closePath())}}
var ga=(i,e,t)=>{i.moveTo(e,t)},_a=(i,e,t)=>{i.moveTo(t,e)},hr=(i,e,t)=>{i.lineTo(e,t)},fr=(i,e,t)=>{i.lineTo(t,e)},xa=md(0),au=md(1),gd=(i,e,t,n,s,r)=>{i.arc(e,
t,n,s,r)},_d=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},xd=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},vd=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function yd(i){
return(e,t,n,s,r)=>Us(e,t,(o,a,c,l,u,f,h,d,x,S,p)=>{let{pxRound:m,points:v}=o,A,M;l.ori==0?(A=ga,M=gd):(A=_a,M=_d);let P=Dt(v.width*Mt,3),E=(v.size-v.width)/2*Mt,
_=Dt(E*2,3),T=new Path2D,O=new Path2D,{left:D,top:L,width:V,height:H}=e.bbox;xa(O,D-_,L-_,V+_*2,H+_*2);let N=G=>{if(c[G]!=null){let J=m(f(a[G],l,S,d)),k=m(h(c[G],
u,p,x));A(T,J+E,k),M(T,J,k,E,0,aa*2)}};if(r)r.forEach(N);else for(let G=n;G<=s;G++)N(G);return{stroke:P>0?T:null,fill:T,clip:O,flags:cr|Xc}})}function Sd(i){return(e,t,n,s,r,o)=>{
n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var R0=Sd(hr),P0=Sd(fr);function Md(i){let e=yt(i?.alignGaps,0);return(t,n,s,r)=>Us(t,n,(o,a,c,l,u,f,h,d,x,S,p)=>{
[s,r]=ha(c,s,r);let m=o.pxRound,v=H=>m(f(H,l,S,d)),A=H=>m(h(H,u,p,x)),M,P;l.ori==0?(M=hr,P=R0):(M=fr,P=P0);let E=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,
clip:null,band:null,gaps:null,flags:cr},T=_.stroke,O=!1;if(r-s>=S*4){let H=ue=>t.posToVal(ue,l.key,!0),N=null,G=null,J,k,le,$=v(a[E==1?s:r]),Q=v(a[s]),ie=v(a[r]),
he=H(E==1?Q+1:ie-1);for(let ue=E==1?s:r;ue>=s&&ue<=r;ue+=E){let j=a[ue],_e=(E==1?j<he:j>he)?$:v(j),Ae=c[ue];_e==$?Ae!=null?(k=Ae,N==null?(M(T,_e,A(k)),J=N=G=k):
k<N?N=k:k>G&&(G=k)):Ae===null&&(O=!0):(N!=null&&P(T,$,A(N),A(G),A(J),A(k)),Ae!=null?(k=Ae,M(T,_e,A(k)),N=G=J=k):(N=G=null,Ae===null&&(O=!0)),$=_e,he=H($+E))}N!=
null&&N!=G&&le!=$&&P(T,$,A(N),A(G),A(J),A(k))}else for(let H=E==1?s:r;H>=s&&H<=r;H+=E){let N=c[H];N===null?O=!0:N!=null&&M(T,v(a[H]),A(N))}let[L,V]=ru(t,n);if(o.
fill!=null||L!=0){let H=_.fill=new Path2D(T),N=o.fillTo(t,n,o.min,o.max,L),G=A(N),J=v(a[s]),k=v(a[r]);E==-1&&([k,J]=[J,k]),M(H,k,G),M(H,J,G)}if(!o.spanGaps){let H=[];
O&&H.push(...ou(a,c,s,r,E,v,e)),_.gaps=H=o.gaps(t,n,s,r,H),_.clip=ma(H,l.ori,d,x,S,p)}return V!=0&&(_.band=V==2?[Wi(t,n,s,r,T,-1),Wi(t,n,s,r,T,1)]:Wi(t,n,s,r,T,
V)),_})}function I0(i){let e=yt(i.align,1),t=yt(i.ascDesc,!1),n=yt(i.alignGaps,0),s=yt(i.extend,!1);return(r,o,a,c)=>Us(r,o,(l,u,f,h,d,x,S,p,m,v,A)=>{[a,c]=ha(f,
a,c);let M=l.pxRound,{left:P,width:E}=r.bbox,_=Q=>M(x(Q,h,v,p)),T=Q=>M(S(Q,d,A,m)),O=h.ori==0?hr:fr,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,
flags:cr},L=D.stroke,V=h.dir*(h.ori==0?1:-1),H=T(f[V==1?a:c]),N=_(u[V==1?a:c]),G=N,J=N;s&&e==-1&&(J=P,O(L,J,H)),O(L,N,H);for(let Q=V==1?a:c;Q>=a&&Q<=c;Q+=V){let ie=f[Q];
if(ie==null)continue;let he=_(u[Q]),ue=T(ie);e==1?O(L,he,H):O(L,G,ue),O(L,he,ue),H=ue,G=he}let k=G;s&&e==1&&(k=P+E,O(L,k,H));let[le,$]=ru(r,o);if(l.fill!=null||
le!=0){let Q=D.fill=new Path2D(L),ie=l.fillTo(r,o,l.min,l.max,le),he=T(ie);O(Q,k,he),O(Q,J,he)}if(!l.spanGaps){let Q=[];Q.push(...ou(u,f,a,c,V,_,n));let ie=l.width*
Mt/2,he=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;Q.forEach(j=>{j[0]+=he,j[1]+=ue}),D.gaps=Q=l.gaps(r,o,a,c,Q),D.clip=ma(Q,h.ori,p,m,v,A)}return $!=0&&(D.band=$==2?[Wi(
r,o,a,c,L,-1),Wi(r,o,a,c,L,1)]:Wi(r,o,a,c,L,$)),D})}function Ff(i,e,t,n,s,r,o=Lt){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(e[c]!==void 0){if(a!=
null){let u=un(i[c]-i[a]);u<l&&(l=u,o=un(t(i[c],n,s,r)-t(i[a],n,s,r)))}a=c}}return o}function L0(i){i=i||io;let e=yt(i.size,[.6,Lt,1]),t=i.align||0,n=i.gap||0,s=i.
radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=mt(s),o=1-e[0],a=yt(e[1],Lt),c=yt(e[2],1),l=yt(i.disp,io),u=yt(i.each,d=>{}),{fill:f,stroke:h}=l;return(d,x,S,p)=>Us(
d,x,(m,v,A,M,P,E,_,T,O,D,L)=>{let V=m.pxRound,H=t,N=n*Mt,G=a*Mt,J=c*Mt,k,le;M.ori==0?[k,le]=r(d,x):[le,k]=r(d,x);let $=M.dir*(M.ori==0?1:-1),Q=M.ori==0?xa:au,ie=M.
ori==0?u:(Ce,Xe,nt,Me,It,ze,We)=>{u(Ce,Xe,nt,It,Me,We,ze)},he=yt(d.bands,eu).find(Ce=>Ce.series[0]==x),ue=he!=null?he.dir:0,j=m.fillTo(d,x,m.min,m.max,ue),pe=V(
_(j,P,L,O)),_e,Ae,Se,Ge=D,tt=V(m.width*Mt),ke=!1,ct=null,rt=null,je=null,Vt=null;f!=null&&(tt==0||h!=null)&&(ke=!0,ct=f.values(d,x,S,p),rt=new Map,new Set(ct).forEach(
Ce=>{Ce!=null&&rt.set(Ce,new Path2D)}),tt>0&&(je=h.values(d,x,S,p),Vt=new Map,new Set(je).forEach(Ce=>{Ce!=null&&Vt.set(Ce,new Path2D)})));let{x0:Nt,size:Qt}=l;
if(Nt!=null&&Qt!=null){H=1,v=Nt.values(d,x,S,p),Nt.unit==2&&(v=v.map(nt=>d.posToVal(T+nt*D,M.key,!0)));let Ce=Qt.values(d,x,S,p);Qt.unit==2?Ae=Ce[0]*D:Ae=E(Ce[0],
M,D,T)-E(0,M,D,T),Ge=Ff(v,A,E,M,D,T,Ge),Se=Ge-Ae+N}else Ge=Ff(v,A,E,M,D,T,Ge),Se=Ge*o+N,Ae=Ge-Se;Se<1&&(Se=0),tt>=Ae/2&&(tt=0),Se<5&&(V=Xf);let Rt=Se>0,mn=Ge-Se-
(Rt?tt:0);Ae=V(Gc(mn,J,G)),_e=(H==0?Ae/2:H==$?0:Ae)-H*$*((H==0?N/2:0)+(Rt?tt/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},an=ke?null:
new Path2D,Xt=null;if(he!=null)Xt=d.data[he.series[1]];else{let{y0:Ce,y1:Xe}=l;Ce!=null&&Xe!=null&&(A=Xe.values(d,x,S,p),Xt=Ce.values(d,x,S,p))}let jt=k*Ae,F=le*
Ae;for(let Ce=$==1?S:p;Ce>=S&&Ce<=p;Ce+=$){let Xe=A[Ce];if(Xe==null)continue;if(Xt!=null){let W=Xt[Ce]??0;if(Xe-W==0)continue;pe=_(W,P,L,O)}let nt=M.distr!=2||l!=
null?v[Ce]:Ce,Me=E(nt,M,D,T),It=_(yt(Xe,j),P,L,O),ze=V(Me-_e),We=V(Dn(It,pe)),C=V(fi(It,pe)),y=We-C;if(Xe!=null){let W=Xe<0?F:jt,ce=Xe<0?jt:F;ke?(tt>0&&je[Ce]!=
null&&Q(Vt.get(je[Ce]),ze,C+Wn(tt/2),Ae,Dn(0,y-tt),W,ce),ct[Ce]!=null&&Q(rt.get(ct[Ce]),ze,C+Wn(tt/2),Ae,Dn(0,y-tt),W,ce)):Q(an,ze,C+Wn(tt/2),Ae,Dn(0,y-tt),W,ce),
ie(d,x,Ce,ze-tt/2,C,Ae+tt,y)}}return tt>0?xt.stroke=ke?Vt:an:ke||(xt._fill=m.width==0?m._fill:m._stroke??m._fill,xt.width=0),xt.fill=ke?rt:an,xt})}function D0(i,e){
let t=yt(e?.alignGaps,0);return(n,s,r,o)=>Us(n,s,(a,c,l,u,f,h,d,x,S,p,m)=>{[r,o]=ha(l,r,o);let v=a.pxRound,A=k=>v(h(k,u,p,x)),M=k=>v(d(k,f,m,S)),P,E,_;u.ori==0?
(P=ga,_=hr,E=xd):(P=_a,_=fr,E=vd);let T=u.dir*(u.ori==0?1:-1),O=A(c[T==1?r:o]),D=O,L=[],V=[];for(let k=T==1?r:o;k>=r&&k<=o;k+=T)if(l[k]!=null){let $=c[k],Q=A($);
L.push(D=Q),V.push(M(l[k]))}let H={stroke:i(L,V,P,_,E,v),fill:null,clip:null,band:null,gaps:null,flags:cr},N=H.stroke,[G,J]=ru(n,s);if(a.fill!=null||G!=0){let k=H.
fill=new Path2D(N),le=a.fillTo(n,s,a.min,a.max,G),$=M(le);_(k,D,$),_(k,O,$)}if(!a.spanGaps){let k=[];k.push(...ou(c,l,r,o,T,A,t)),H.gaps=k=a.gaps(n,s,r,o,k),H.clip=
ma(k,u.ori,x,S,p,m)}return J!=0&&(H.band=J==2?[Wi(n,s,r,o,N,-1),Wi(n,s,r,o,N,1)]:Wi(n,s,r,o,N,J)),H})}function N0(i){return D0(U0,i)}function U0(i,e,t,n,s,r){let o=i.
length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)
u[h]=e[h+1]-e[h],f[h]=i[h+1]-i[h],l[h]=u[h]/f[h];c[0]=l[0];for(let h=1;h<o-1;h++)l[h]===0||l[h-1]===0||l[h-1]>0!=l[h]>0?c[h]=0:(c[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-
1])/l[h-1]+(f[h]+2*f[h-1])/l[h]),isFinite(c[h])||(c[h]=0));c[o-1]=l[o-2];for(let h=0;h<o-1;h++)s(a,i[h]+f[h]/3,e[h]+c[h]*f[h]/3,i[h+1]-f[h]/3,e[h+1]-c[h+1]*f[h]/
3,i[h+1],e[h+1])}return a}var qc=new Set;function Of(){for(let i of qc)i.syncRect(!0)}ur&&(Ds(mg,rr,Of),Ds(gg,rr,Of,!0),Ds(la,rr,()=>{hn.pxRatio=Mt}));var F0=Md(),
O0=yd();function Bf(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Yc(r,o,e,t))}function B0(i,e){return i.map((t,n)=>n==
0?{}:rn({},e,t))}function Yc(i,e,t,n){return rn({},e==0?t:n,i)}function bd(i,e,t){return e==null?ar:[e,t]}var z0=bd;function k0(i,e,t){return e==null?ar:ca(e,t,
Qc,!0)}function wd(i,e,t,n){return e==null?ar:fa(e,t,i.scales[n].log,!1)}var V0=wd;function Td(i,e,t,n){return e==null?ar:Kc(e,t,i.scales[n].log,!1)}var G0=Td;function H0(i,e,t,n,s){
let r=Dn(gf(i),gf(e)),o=e-i,a=hi(s/n*o,t);do{let c=t[a],l=n*c/o;if(l>=s&&r+(c<5?ds.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function zf(i){let e,
t;return i=i.replace(/(\d+)px/,(n,s)=>(e=cn((t=+s)*Mt))+"px"),[i,e,t]}function W0(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Dt(e[2]*Mt,1);e[0]=e[0].replace(
/[0-9.]+px/,t+"px"),e[1]=t})}function hn(i,e,t){let n={mode:yt(i.mode,1)},s=n.mode;function r(g,b,R,I){let z=b.valToPct(g);return I+R*(b.dir==-1?1-z:z)}function o(g,b,R,I){
let z=b.valToPct(g);return I+R*(b.dir==-1?z:1-z)}function a(g,b,R,I){return b.ori==0?r(g,b,R,I):o(g,b,R,I)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.
root=ti(Km);if(i.id!=null&&(l.id=i.id),Hn(l,i.class),i.title){let g=ti(eg,l);g.textContent=i.title}let u=ui("canvas"),f=n.ctx=u.getContext("2d"),h=ti(tg,l);Ds("\
click",h,g=>{g.target===x&&(Ft!=Qs||Gt!=js)&&Mn.click(n,g)},!0);let d=n.under=ti(ng,h);h.appendChild(u);let x=n.over=ti(ig,h);i=lr(i);let S=+yt(i.pxAlign,1),p=Uf(
S);(i.plugins||[]).forEach(g=>{g.opts&&(i=g.opts(n,i)||i)});let m=i.ms||.001,v=n.series=s==1?Bf(i.series||[],Cf,Df,!1):B0(i.series||[null],Lf),A=n.axes=Bf(i.axes||
[],Ef,Pf,!0),M=n.scales={},P=n.bands=i.bands||[];P.forEach(g=>{g.fill=mt(g.fill||null),g.dir=yt(g.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,_={axes:Vi,
series:ht},T=(i.drawOrder||["axes","series"]).map(g=>_[g]);function O(g){let b=g.distr==3?R=>Hi(R>0?R:g.clamp(n,R,g.min,g.max,g.key)):g.distr==4?R=>Nc(R,g.asinh):
g.distr==100?R=>g.fwd(R):R=>R;return R=>{let I=b(R),{_min:z,_max:Z}=g,oe=Z-z;return(I-z)/oe}}function D(g){let b=M[g];if(b==null){let R=(i.scales||io)[g]||io;if(R.
from!=null){D(R.from);let I=rn({},M[R.from],R,{key:g});I.valToPct=O(I),M[g]=I}else{b=M[g]=rn({},g==E?dd:A0,R),b.key=g;let I=b.time,z=b.range,Z=fs(z);if((g!=E||s==
2&&!I)&&(Z&&(z[0]==null||z[1]==null)&&(z={min:z[0]==null?df:{mode:1,hard:z[0],soft:z[0]},max:z[1]==null?df:{mode:1,hard:z[1],soft:z[1]}},Z=!1),!Z&&pa(z))){let oe=z;
z=(fe,ve,Le)=>ve==null?ar:ca(ve,Le,oe)}b.range=mt(z||(I?z0:g==E?b.distr==3?V0:b.distr==4?G0:bd:b.distr==3?wd:b.distr==4?Td:k0)),b.auto=mt(Z?!1:b.auto),b.clamp=mt(
b.clamp||T0),b._min=b._max=null,b.valToPct=O(b)}}}D("x"),D("y"),s==1&&v.forEach(g=>{D(g.scale)}),A.forEach(g=>{D(g.scale)});for(let g in i.scales)D(g);let L=M[E],
V=L.distr,H,N;L.ori==0?(Hn(l,Qm),H=r,N=o):(Hn(l,jm),H=o,N=r);let G={};for(let g in M){let b=M[g];(b.min!=null||b.max!=null)&&(G[g]={min:b.min,max:b.max},b.min=b.
max=null)}let J=i.tzDate||(g=>new Date(cn(g/m))),k=i.fmtDate||tu,le=m==1?Qg(J):t0(J),$=wf(J,bf(m==1?Kg:e0,k)),Q=Af(J,Tf(i0,k)),ie=[],he=n.legend=rn({},o0,i.legend),
ue=n.cursor=rn({},f0,{drag:{y:s==2}},i.cursor),j=he.show,pe=ue.show,_e=he.markers;he.idxs=ie,_e.width=mt(_e.width),_e.dash=mt(_e.dash),_e.stroke=mt(_e.stroke),_e.
fill=mt(_e.fill);let Ae,Se,Ge,tt=[],ke=[],ct,rt=!1,je={};if(he.live){let g=v[1]?v[1].values:null;rt=g!=null,ct=rt?g(n,1,0):{_:0};for(let b in ct)je[b]=Jc}if(j)if(Ae=
ui("table",cg,l),Ge=ui("tbody",null,Ae),he.mount(n,Ae),rt){Se=ui("thead",null,Ae,Ge);let g=ui("tr",null,Se);ui("th",null,g);for(var Vt in ct)ui("th",jh,g).textContent=
Vt}else Hn(Ae,hg),he.live&&Hn(Ae,ug);let Nt={show:!0},Qt={show:!1};function Rt(g,b){if(b==0&&(rt||!he.live||s==2))return ar;let R=[],I=ui("tr",fg,Ge,Ge.childNodes[b]);
Hn(I,g.class),g.show||Hn(I,Ls);let z=ui("th",null,I);if(_e.show){let fe=ti(dg,z);if(b>0){let ve=_e.width(n,b);ve&&(fe.style.border=ve+"px "+_e.dash(n,b)+" "+_e.
stroke(n,b)),fe.style.background=_e.fill(n,b)}}let Z=ti(jh,z);g.label instanceof HTMLElement?Z.appendChild(g.label):Z.textContent=g.label,b>0&&(_e.show||(Z.style.
color=g.width>0?_e.stroke(n,b):_e.fill(n,b)),xt("click",z,fe=>{if(ue._lock)return;Ze(fe);let ve=v.indexOf(g);if((fe.ctrlKey||fe.metaKey)!=he.isolate){let Le=v.some(
(De,Ue)=>Ue>0&&Ue!=ve&&De.show);v.forEach((De,Ue)=>{Ue>0&&wi(Ue,Le?Ue==ve?Nt:Qt:Nt,!0,sn.setSeries)})}else wi(ve,{show:!g.show},!0,sn.setSeries)},!1),Je&&xt(sf,
z,fe=>{ue._lock||(Ze(fe),wi(v.indexOf(g),tr,!0,sn.setSeries))},!1));for(var oe in ct){let fe=ui("td",pg,I);fe.textContent="--",R.push(fe)}return[I,R]}let mn=new Map;
function xt(g,b,R,I=!0){let z=mn.get(b)||{},Z=ue.bind[g](n,b,R,I);Z&&(Ds(g,b,z[g]=Z),mn.set(b,z))}function an(g,b,R){let I=mn.get(b)||{};for(let z in I)(g==null||
z==g)&&(Vc(z,b,I[z]),delete I[z]);g==null&&mn.delete(b)}let Xt=0,jt=0,F=0,Ce=0,Xe=0,nt=0,Me=Xe,It=nt,ze=F,We=Ce,C=0,y=0,W=0,ce=0;n.bbox={};let re=!1,ge=!1,xe=!1,
ee=!1,ne=!1,de=!1;function U(g,b,R){(R||g!=n.width||b!=n.height)&&se(g,b),ot(!1),xe=!0,ge=!0,bn()}function se(g,b){n.width=Xt=F=g,n.height=jt=Ce=b,Xe=nt=0,ye(),
Ve();let R=n.bbox;C=R.left=Ps(Xe*Mt,.5),y=R.top=Ps(nt*Mt,.5),W=R.width=Ps(F*Mt,.5),ce=R.height=Ps(Ce*Mt,.5)}let te=3;function be(){let g=!1,b=0;for(;!g;){b++;let R=Js(
b),I=bi(b);g=b==te||R&&I,g||(se(n.width,n.height),ge=!0)}}function me({width:g,height:b}){U(g,b)}n.setSize=me;function ye(){let g=!1,b=!1,R=!1,I=!1;A.forEach((z,Z)=>{
if(z.show&&z._show){let{side:oe,_size:fe}=z,ve=oe%2,Le=z.label!=null?z.labelSize:0,De=fe+Le;De>0&&(ve?(F-=De,oe==3?(Xe+=De,I=!0):R=!0):(Ce-=De,oe==0?(nt+=De,g=!0):
b=!0))}}),Si[0]=g,Si[1]=R,Si[2]=b,Si[3]=I,F-=ai[1]+ai[3],Xe+=ai[3],Ce-=ai[2]+ai[0],nt+=ai[0]}function Ve(){let g=Xe+F,b=nt+Ce,R=Xe,I=nt;function z(Z,oe){switch(Z){case 1:
return g+=oe,g-oe;case 2:return b+=oe,b-oe;case 3:return R-=oe,R+oe;case 0:return I-=oe,I+oe}}A.forEach((Z,oe)=>{if(Z.show&&Z._show){let fe=Z.side;Z._pos=z(fe,Z.
_size),Z.label!=null&&(Z._lpos=z(fe,Z.labelSize))}})}if(ue.dataIdx==null){let g=ue.hover,b=g.skip=new Set(g.skip??[]);b.add(void 0);let R=g.prox=mt(g.prox),I=g.
bias??=0;ue.dataIdx=(z,Z,oe,fe)=>{if(Z==0)return oe;let ve=oe,Le=R(z,Z,oe,fe)??Lt,De=Le>=0&&Le<Lt,Ue=L.ori==0?F:Ce,et=ue.left,St=e[0],vt=e[Z];if(b.has(vt[oe])){
ve=null;let dt=null,Ye=null,He;if(I==0||I==-1)for(He=oe;dt==null&&He-- >0;)b.has(vt[He])||(dt=He);if(I==0||I==1)for(He=oe;Ye==null&&He++<vt.length;)b.has(vt[He])||
(Ye=He);if(dt!=null||Ye!=null)if(De){let Bt=dt==null?-1/0:H(St[dt],L,Ue,0),Zt=Ye==null?1/0:H(St[Ye],L,Ue,0),vn=et-Bt,Pt=Zt-et;vn<=Pt?vn<=Le&&(ve=dt):Pt<=Le&&(ve=
Ye)}else ve=Ye==null?dt:dt==null?Ye:oe-dt<=Ye-oe?dt:Ye}else De&&un(et-H(St[oe],L,Ue,0))>Le&&(ve=null);return ve}}let Ze=g=>{ue.event=g};ue.idxs=ie,ue._lock=!1;let ae=ue.
points;ae.show=mt(ae.show),ae.size=mt(ae.size),ae.stroke=mt(ae.stroke),ae.width=mt(ae.width),ae.fill=mt(ae.fill);let Fe=n.focus=rn({},i.focus||{alpha:.3},ue.focus),
Je=Fe.prox>=0,Ee=Je&&ae.one,it=[],Ut=[],Cn=[];function Wr(g,b){let R=ae.show(n,b);if(R instanceof HTMLElement)return Hn(R,lg),Hn(R,g.class),Ci(R,-10,-10,F,Ce),x.
insertBefore(R,it[b]),R}function qs(g,b){if(s==1||b>0){let R=s==1&&M[g.scale].time,I=g.value;g.value=R?vf(I)?Af(J,Tf(I,k)):I||Q:I||M0,g.label=g.label||(R?p0:d0)}
if(Ee||b>0){g.width=g.width==null?1:g.width,g.paths=g.paths||F0||Ag,g.fillTo=mt(g.fillTo||E0),g.pxAlign=+yt(g.pxAlign,S),g.pxRound=Uf(g.pxAlign),g.stroke=mt(g.stroke||
null),g.fill=mt(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let R=b0(Dn(1,g.width),1),I=g.points=rn({},{size:R,width:Dn(1,R*.2),stroke:g.stroke,space:R*
2,paths:O0,_stroke:null,_fill:null},g.points);I.show=mt(I.show),I.filter=mt(I.filter),I.fill=mt(I.fill),I.stroke=mt(I.stroke),I.paths=mt(I.paths),I.pxAlign=g.pxAlign}
if(j){let R=Rt(g,b);tt.splice(b,0,R[0]),ke.splice(b,0,R[1]),he.values.push(null)}if(pe){ie.splice(b,0,null);let R=null;Ee?b==0&&(R=Wr(g,b)):b>0&&(R=Wr(g,b)),it.
splice(b,0,R),Ut.splice(b,0,0),Cn.splice(b,0,0)}xn("addSeries",b)}function Sc(g,b){b=b??v.length,g=s==1?Yc(g,b,Cf,Df):Yc(g,b,{},Lf),v.splice(b,0,g),qs(v[b],b)}n.
addSeries=Sc;function ea(g){if(v.splice(g,1),j){he.values.splice(g,1),ke.splice(g,1);let b=tt.splice(g,1)[0];an(null,b.firstChild),b.remove()}pe&&(ie.splice(g,1),
it.splice(g,1)[0].remove(),Ut.splice(g,1),Cn.splice(g,1)),xn("delSeries",g)}n.delSeries=ea;let Si=[!1,!1,!1,!1];function Bi(g,b){if(g._show=g.show,g.show){let R=g.
side%2,I=M[g.scale];I==null&&(g.scale=R?v[1].scale:E,I=M[g.scale]);let z=I.time;g.size=mt(g.size),g.space=mt(g.space),g.rotate=mt(g.rotate),fs(g.incrs)&&g.incrs.
forEach(oe=>{!ds.has(oe)&&ds.set(oe,Zf(oe))}),g.incrs=mt(g.incrs||(I.distr==2?Zg:z?m==1?$g:jg:Is)),g.splits=mt(g.splits||(z&&I.distr==1?le:I.distr==3?Hc:I.distr==
4?_0:g0)),g.stroke=mt(g.stroke),g.grid.stroke=mt(g.grid.stroke),g.ticks.stroke=mt(g.ticks.stroke),g.border.stroke=mt(g.border.stroke);let Z=g.values;g.values=fs(
Z)&&!fs(Z[0])?mt(Z):z?fs(Z)?wf(J,bf(Z,k)):vf(Z)?n0(J,Z):Z||$:Z||m0,g.filter=mt(g.filter||(I.distr>=3&&I.log==10?y0:I.distr==3&&I.log==2?S0:qf)),g.font=zf(g.font),
g.labelFont=zf(g.labelFont),g._size=g.size(n,null,b,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(Si[b]=!0,g._el=ti(sg,h))}}function zi(g,b,R,I){
let[z,Z,oe,fe]=R,ve=b%2,Le=0;return ve==0&&(fe||Z)&&(Le=b==0&&!z||b==2&&!oe?cn(Ef.size/3):0),ve==1&&(z||oe)&&(Le=b==1&&!Z||b==3&&!fe?cn(Pf.size/2):0),Le}let Xr=n.
padding=(i.padding||[zi,zi,zi,zi]).map(g=>mt(yt(g,zi))),ai=n._padding=Xr.map((g,b)=>g(n,b,Si,0)),qt,$t=null,Kt=null,Mi=s==1?v[0].idxs:null,zn=null,os=!1;function qr(g,b){
if(e=g??[],n.data=n._data=e,s==2){qt=0;for(let R=1;R<v.length;R++)qt+=e[R][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),zn=e[0],qt=zn.length;let R=e;if(V==
2){R=e.slice();let I=R[0]=Array(qt);for(let z=0;z<qt;z++)I[z]=z}n._data=e=R}if(ot(!0),xn("setData"),V==2&&(xe=!0),b!==!1){let R=L;R.auto(n,os)?Yr():cs(E,R.min,R.
max),ee=ee||ue.left>=0,de=!0,bn()}}n.setData=qr;function Yr(){os=!0;let g,b;s==1&&(qt>0?($t=Mi[0]=0,Kt=Mi[1]=qt-1,g=e[0][$t],b=e[0][Kt],V==2?(g=$t,b=Kt):g==b&&(V==
3?[g,b]=fa(g,g,L.log,!1):V==4?[g,b]=Kc(g,g,L.log,!1):L.time?b=g+cn(86400/m):[g,b]=ca(g,b,Qc,!0))):($t=Mi[0]=g=null,Kt=Mi[1]=b=null)),cs(E,g,b)}let Ys,as,Zs,w,B,
K,X,Y,we,Re;function Te(g,b,R,I,z,Z){g??=tf,R??=eu,I??="butt",z??=tf,Z??="round",g!=Ys&&(f.strokeStyle=Ys=g),z!=as&&(f.fillStyle=as=z),b!=Zs&&(f.lineWidth=Zs=b),
Z!=B&&(f.lineJoin=B=Z),I!=K&&(f.lineCap=K=I),R!=w&&f.setLineDash(w=R)}function Pe(g,b,R,I){b!=as&&(f.fillStyle=as=b),g!=X&&(f.font=X=g),R!=Y&&(f.textAlign=Y=R),
I!=we&&(f.textBaseline=we=I)}function Be(g,b,R,I,z=0){if(I.length>0&&g.auto(n,os)&&(b==null||b.min==null)){let Z=yt($t,0),oe=yt(Kt,I.length-1),fe=R.min==null?yg(
I,Z,oe,z,g.distr==3):[R.min,R.max];g.min=fi(g.min,R.min=fe[0]),g.max=Dn(g.max,R.max=fe[1])}}let $e={min:null,max:null};function ut(){for(let I in M){let z=M[I];
G[I]==null&&(z.min==null||G[E]!=null&&z.auto(n,os))&&(G[I]=$e)}for(let I in M){let z=M[I];G[I]==null&&z.from!=null&&G[z.from]!=null&&(G[I]=$e)}G[E]!=null&&ot(!0);
let g={};for(let I in G){let z=G[I];if(z!=null){let Z=g[I]=lr(M[I],Rg);if(z.min!=null)rn(Z,z);else if(I!=E||s==2)if(qt==0&&Z.from==null){let oe=Z.range(n,null,null,
I);Z.min=oe[0],Z.max=oe[1]}else Z.min=Lt,Z.max=-Lt}}if(qt>0){v.forEach((I,z)=>{if(s==1){let Z=I.scale,oe=G[Z];if(oe==null)return;let fe=g[Z];if(z==0){let ve=fe.
range(n,fe.min,fe.max,Z);fe.min=ve[0],fe.max=ve[1],$t=hi(fe.min,e[0]),Kt=hi(fe.max,e[0]),Kt-$t>1&&(e[0][$t]<fe.min&&$t++,e[0][Kt]>fe.max&&Kt--),I.min=zn[$t],I.max=
zn[Kt]}else I.show&&I.auto&&Be(fe,oe,I,e[z],I.sorted);I.idxs[0]=$t,I.idxs[1]=Kt}else if(z>0&&I.show&&I.auto){let[Z,oe]=I.facets,fe=Z.scale,ve=oe.scale,[Le,De]=e[z],
Ue=g[fe],et=g[ve];Ue!=null&&Be(Ue,G[fe],Z,Le,Z.sorted),et!=null&&Be(et,G[ve],oe,De,oe.sorted),I.min=oe.min,I.max=oe.max}});for(let I in g){let z=g[I],Z=G[I];if(z.
from==null&&(Z==null||Z.min==null)){let oe=z.range(n,z.min==Lt?null:z.min,z.max==-Lt?null:z.max,I);z.min=oe[0],z.max=oe[1]}}}for(let I in g){let z=g[I];if(z.from!=
null){let Z=g[z.from];if(Z.min==null)z.min=z.max=null;else{let oe=z.range(n,Z.min,Z.max,I);z.min=oe[0],z.max=oe[1]}}}let b={},R=!1;for(let I in g){let z=g[I],Z=M[I];
if(Z.min!=z.min||Z.max!=z.max){Z.min=z.min,Z.max=z.max;let oe=Z.distr;Z._min=oe==3?Hi(Z.min):oe==4?Nc(Z.min,Z.asinh):oe==100?Z.fwd(Z.min):Z.min,Z._max=oe==3?Hi(
Z.max):oe==4?Nc(Z.max,Z.asinh):oe==100?Z.fwd(Z.max):Z.max,b[I]=R=!0}}if(R){v.forEach((I,z)=>{s==2?z>0&&b.y&&(I._paths=null):b[I.scale]&&(I._paths=null)});for(let I in b)
xe=!0,xn("setScale",I);pe&&ue.left>=0&&(ee=de=!0)}for(let I in G)G[I]=null}function Oe(g){let b=Gc($t-1,0,qt-1),R=Gc(Kt+1,0,qt-1);for(;g[b]==null&&b>0;)b--;for(;g[R]==
null&&R<qt-1;)R++;return[b,R]}function ht(){if(qt>0){let g=v.some(b=>b._focus)&&Re!=Fe.alpha;g&&(f.globalAlpha=Re=Fe.alpha),v.forEach((b,R)=>{if(R>0&&b.show&&(Wt(
R,!1),Wt(R,!0),b._paths==null)){let I=Re;Re!=b.alpha&&(f.globalAlpha=Re=b.alpha);let z=s==2?[0,e[R][0].length-1]:Oe(e[R]);b._paths=b.paths(n,R,z[0],z[1]),Re!=I&&
(f.globalAlpha=Re=I)}}),v.forEach((b,R)=>{if(R>0&&b.show){let I=Re;Re!=b.alpha&&(f.globalAlpha=Re=b.alpha),b._paths!=null&&At(R,!1);{let z=b._paths!=null?b._paths.
gaps:null,Z=b.points.show(n,R,$t,Kt,z),oe=b.points.filter(n,R,Z,z);(Z||oe)&&(b.points._paths=b.points.paths(n,R,$t,Kt,oe),At(R,!0))}Re!=I&&(f.globalAlpha=Re=I),
xn("drawSeries",R)}}),g&&(f.globalAlpha=Re=1)}}function Wt(g,b){let R=b?v[g].points:v[g];R._stroke=R.stroke(n,g),R._fill=R.fill(n,g)}function At(g,b){let R=b?v[g].
points:v[g],{stroke:I,fill:z,clip:Z,flags:oe,_stroke:fe=R._stroke,_fill:ve=R._fill,_width:Le=R.width}=R._paths;Le=Dt(Le*Mt,3);let De=null,Ue=Le%2/2;b&&ve==null&&
(ve=Le>0?"#fff":fe);let et=R.pxAlign==1&&Ue>0;if(et&&f.translate(Ue,Ue),!b){let St=C-Le/2,vt=y-Le/2,dt=W+Le,Ye=ce+Le;De=new Path2D,De.rect(St,vt,dt,Ye)}b?Ne(fe,
Le,R.dash,R.cap,ve,I,z,oe,Z):Et(g,fe,Le,R.dash,R.cap,ve,I,z,oe,De,Z),et&&f.translate(-Ue,-Ue)}function Et(g,b,R,I,z,Z,oe,fe,ve,Le,De){let Ue=!1;ve!=0&&P.forEach(
(et,St)=>{if(et.series[0]==g){let vt=v[et.series[1]],dt=e[et.series[1]],Ye=(vt._paths||io).band;fs(Ye)&&(Ye=et.dir==1?Ye[0]:Ye[1]);let He,Bt=null;vt.show&&Ye&&Mg(
dt,$t,Kt)?(Bt=et.fill(n,St)||Z,He=vt._paths.clip):Ye=null,Ne(b,R,I,z,Bt,oe,fe,ve,Le,De,He,Ye),Ue=!0}}),Ue||Ne(b,R,I,z,Z,oe,fe,ve,Le,De)}let ln=cr|Xc;function Ne(g,b,R,I,z,Z,oe,fe,ve,Le,De,Ue){
Te(g,b,R,I,z),(ve||Le||Ue)&&(f.save(),ve&&f.clip(ve),Le&&f.clip(Le)),Ue?(fe&ln)==ln?(f.clip(Ue),De&&f.clip(De),pt(z,oe),en(g,Z,b)):fe&Xc?(pt(z,oe),f.clip(Ue),en(
g,Z,b)):fe&cr&&(f.save(),f.clip(Ue),De&&f.clip(De),pt(z,oe),f.restore(),en(g,Z,b)):(pt(z,oe),en(g,Z,b)),(ve||Le||Ue)&&f.restore()}function en(g,b,R){R>0&&(b instanceof
Map?b.forEach((I,z)=>{f.strokeStyle=Ys=z,f.stroke(I)}):b!=null&&g&&f.stroke(b))}function pt(g,b){b instanceof Map?b.forEach((R,I)=>{f.fillStyle=as=I,f.fill(R)}):
b!=null&&g&&f.fill(b)}function ki(g,b,R,I){let z=A[g],Z;if(I<=0)Z=[0,0];else{let oe=z._space=z.space(n,g,b,R,I),fe=z._incrs=z.incrs(n,g,b,R,I,oe);Z=H0(b,R,fe,I,
oe)}return z._found=Z}function tn(g,b,R,I,z,Z,oe,fe,ve,Le){let De=oe%2/2;S==1&&f.translate(De,De),Te(fe,oe,ve,Le,fe),f.beginPath();let Ue,et,St,vt,dt=z+(I==0||I==
3?-Z:Z);R==0?(et=z,vt=dt):(Ue=z,St=dt);for(let Ye=0;Ye<g.length;Ye++)b[Ye]!=null&&(R==0?Ue=St=g[Ye]:et=vt=g[Ye],f.moveTo(Ue,et),f.lineTo(St,vt));f.stroke(),S==1&&
f.translate(-De,-De)}function Js(g){let b=!0;return A.forEach((R,I)=>{if(!R.show)return;let z=M[R.scale];if(z.min==null){R._show&&(b=!1,R._show=!1,ot(!1));return}else
R._show||(b=!1,R._show=!0,ot(!1));let Z=R.side,oe=Z%2,{min:fe,max:ve}=z,[Le,De]=ki(I,fe,ve,oe==0?F:Ce);if(De==0)return;let Ue=z.distr==2,et=R._splits=R.splits(n,
I,fe,ve,Le,De,Ue),St=z.distr==2?et.map(He=>zn[He]):et,vt=z.distr==2?zn[et[1]]-zn[et[0]]:Le,dt=R._values=R.values(n,R.filter(n,St,I,De,vt),I,De,vt);R._rotate=Z==
2?R.rotate(n,dt,I,De):0;let Ye=R._size;R._size=ni(R.size(n,dt,I,g)),Ye!=null&&R._size!=Ye&&(b=!1)}),b}function bi(g){let b=!0;return Xr.forEach((R,I)=>{let z=R(
n,I,Si,g);z!=ai[I]&&(b=!1),ai[I]=z}),b}function Vi(){for(let g=0;g<A.length;g++){let b=A[g];if(!b.show||!b._show)continue;let R=b.side,I=R%2,z,Z,oe=b.stroke(n,g),
fe=R==0||R==3?-1:1,[ve,Le]=b._found;if(b.label!=null){let In=b.labelGap*fe,Gn=cn((b._lpos+In)*Mt);Pe(b.labelFont[0],oe,"center",R==2?"top":ef),f.save(),I==1?(z=
Z=0,f.translate(Gn,cn(y+ce/2)),f.rotate((R==3?-aa:aa)/2)):(z=cn(C+W/2),Z=Gn);let Rs=Wf(b.label)?b.label(n,g,ve,Le):b.label;f.fillText(Rs,z,Z),f.restore()}if(Le==
0)continue;let De=M[b.scale],Ue=I==0?W:ce,et=I==0?C:y,St=b._splits,vt=De.distr==2?St.map(In=>zn[In]):St,dt=De.distr==2?zn[St[1]]-zn[St[0]]:ve,Ye=b.ticks,He=b.border,
Bt=Ye.show?Ye.size:0,Zt=cn(Bt*Mt),vn=cn((b.alignTo==2?b._size-Bt-b.gap:b.gap)*Mt),Pt=b._rotate*-aa/180,Jt=p(b._pos*Mt),kn=(Zt+vn)*fe,Pn=Jt+kn;Z=I==0?Pn:0,z=I==1?
Pn:0;let jn=b.font[0],li=b.align==1?ir:b.align==2?Ic:Pt>0?ir:Pt<0?Ic:I==0?"center":R==3?Ic:ir,Ai=Pt||I==1?"middle":R==2?"top":ef;Pe(jn,oe,li,Ai);let Vn=b.font[1]*
b.lineGap,ei=St.map(In=>p(a(In,De,Ue,et))),ci=b._values;for(let In=0;In<ci.length;In++){let Gn=ci[In];if(Gn!=null){I==0?z=ei[In]:Z=ei[In],Gn=""+Gn;let Rs=Gn.indexOf(
"\n")==-1?[Gn]:Gn.split(/\n/gm);for(let Ln=0;Ln<Rs.length;Ln++){let $h=Rs[Ln];Pt?(f.save(),f.translate(z,Z+Ln*Vn),f.rotate(Pt),f.fillText($h,0,0),f.restore()):f.
fillText($h,z,Z+Ln*Vn)}}}Ye.show&&tn(ei,Ye.filter(n,vt,g,Le,dt),I,R,Jt,Zt,Dt(Ye.width*Mt,3),Ye.stroke(n,g),Ye.dash,Ye.cap);let Ei=b.grid;Ei.show&&tn(ei,Ei.filter(
n,vt,g,Le,dt),I,I==0?2:1,I==0?y:C,I==0?ce:W,Dt(Ei.width*Mt,3),Ei.stroke(n,g),Ei.dash,Ei.cap),He.show&&tn([Jt],[1],I==0?1:0,I==0?1:2,I==1?y:C,I==1?ce:W,Dt(He.width*
Mt,3),He.stroke(n,g),He.dash,He.cap)}xn("drawAxes")}function ot(g){v.forEach((b,R)=>{R>0&&(b._paths=null,g&&(s==1?(b.min=null,b.max=null):b.facets.forEach(I=>{I.
min=null,I.max=null})))})}let Yt=!1,Rn=!1,Ct=[];function nn(){Rn=!1;for(let g=0;g<Ct.length;g++)xn(...Ct[g]);Ct.length=0}function bn(){Yt||(Fg(Lh),Yt=!0)}function ta(g,b=!1){
Yt=!0,Rn=b,g(n),Lh(),b&&Ct.length>0&&queueMicrotask(nn)}n.batch=ta;function Lh(){if(re&&(ut(),re=!1),xe&&(be(),xe=!1),ge){if(zt(d,ir,Xe),zt(d,"top",nt),zt(d,jr,
F),zt(d,eo,Ce),zt(x,ir,Xe),zt(x,"top",nt),zt(x,jr,F),zt(x,eo,Ce),zt(h,jr,Xt),zt(h,eo,jt),u.width=cn(Xt*Mt),u.height=cn(jt*Mt),A.forEach(({_el:g,_show:b,_size:R,
_pos:I,side:z})=>{if(g!=null)if(b){let Z=z===3||z===0?R:0,oe=z%2==1;zt(g,oe?"left":"top",I-Z),zt(g,oe?"width":"height",R),zt(g,oe?"top":"left",oe?nt:Xe),zt(g,oe?
"height":"width",oe?Ce:F),kc(g,Ls)}else Hn(g,Ls)}),Ys=as=Zs=B=K=X=Y=we=w=null,Re=1,$r(!0),Xe!=Me||nt!=It||F!=ze||Ce!=We){ot(!1);let g=F/ze,b=Ce/We;if(pe&&!ee&&ue.
left>=0){ue.left*=g,ue.top*=b,$s&&Ci($s,cn(ue.left),0,F,Ce),Ks&&Ci(Ks,0,cn(ue.top),F,Ce);for(let R=0;R<it.length;R++){let I=it[R];I!=null&&(Ut[R]*=g,Cn[R]*=b,Ci(
I,ni(Ut[R]),ni(Cn[R]),F,Ce))}}if(Ot.show&&!ne&&Ot.left>=0&&Ot.width>0){Ot.left*=g,Ot.width*=g,Ot.top*=b,Ot.height*=b;for(let R in Ec)zt(er,R,Ot[R])}Me=Xe,It=nt,
ze=F,We=Ce}xn("setSize"),ge=!1}Xt>0&&jt>0&&(f.clearRect(0,0,u.width,u.height),xn("drawClear"),T.forEach(g=>g()),xn("draw")),Ot.show&&ne&&(na(Ot),ne=!1),pe&&ee&&
(Cs(null,!0,!1),ee=!1),he.show&&he.live&&de&&(Tc(),de=!1),c||(c=!0,n.status=1,xn("ready")),os=!1,Yt=!1}n.redraw=(g,b)=>{xe=b||!1,g!==!1?cs(E,L.min,L.max):bn()};
function Mc(g,b){let R=M[g];if(R.from==null){if(qt==0){let I=R.range(n,b.min,b.max,g);b.min=I[0],b.max=I[1]}if(b.min>b.max){let I=b.min;b.min=b.max,b.max=I}if(qt>
1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;g==E&&R.distr==2&&qt>0&&(b.min=hi(b.min,e[0]),b.max=hi(b.max,e[0]),b.min==b.max&&b.max++),G[g]=b,re=!0,bn()}}
n.setScale=Mc;let bc,wc,$s,Ks,Dh,Nh,Qs,js,Uh,Fh,Ft,Gt,ls=!1,Mn=ue.drag,gn=Mn.x,_n=Mn.y;pe&&(ue.x&&(bc=ti(og,x)),ue.y&&(wc=ti(ag,x)),L.ori==0?($s=bc,Ks=wc):($s=wc,
Ks=bc),Ft=ue.left,Gt=ue.top);let Ot=n.select=rn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),er=Ot.show?ti(rg,Ot.over?x:d):null;function na(g,b){if(Ot.
show){for(let R in g)Ot[R]=g[R],R in Ec&&zt(er,R,g[R]);b!==!1&&xn("setSelect")}}n.setSelect=na;function Om(g){if(v[g].show)j&&kc(tt[g],Ls);else if(j&&Hn(tt[g],Ls),
pe){let R=Ee?it[0]:it[g];R!=null&&Ci(R,-10,-10,F,Ce)}}function cs(g,b,R){Mc(g,{min:b,max:R})}function wi(g,b,R,I){b.focus!=null&&Gm(g),b.show!=null&&v.forEach((z,Z)=>{
Z>0&&(g==Z||g==null)&&(z.show=b.show,Om(Z),s==2?(cs(z.facets[0].scale,null,null),cs(z.facets[1].scale,null,null)):cs(z.scale,null,null),bn())}),R!==!1&&xn("setS\
eries",g,b),I&&Kr("setSeries",n,g,b)}n.setSeries=wi;function Bm(g,b){rn(P[g],b)}function zm(g,b){g.fill=mt(g.fill||null),g.dir=yt(g.dir,-1),b=b??P.length,P.splice(
b,0,g)}function km(g){g==null?P.length=0:P.splice(g,1)}n.addBand=zm,n.setBand=Bm,n.delBand=km;function Vm(g,b){v[g].alpha=b,pe&&it[g]!=null&&(it[g].style.opacity=
b),j&&tt[g]&&(tt[g].style.opacity=b)}let Gi,us,Es,tr={focus:!0};function Gm(g){if(g!=Es){let b=g==null,R=Fe.alpha!=1;v.forEach((I,z)=>{if(s==1||z>0){let Z=b||z==
0||z==g;I._focus=b?null:Z,R&&Vm(z,Z?1:Fe.alpha)}}),Es=g,R&&bn()}}j&&Je&&xt(rf,Ae,g=>{ue._lock||(Ze(g),Es!=null&&wi(null,tr,!0,sn.setSeries))});function Ti(g,b,R){
let I=M[b];R&&(g=g/Mt-(I.ori==1?nt:Xe));let z=F;I.ori==1&&(z=Ce,g=z-g),I.dir==-1&&(g=z-g);let Z=I._min,oe=I._max,fe=g/z,ve=Z+(oe-Z)*fe,Le=I.distr;return Le==3?or(
10,ve):Le==4?wg(ve,I.asinh):Le==100?I.bwd(ve):ve}function Hm(g,b){let R=Ti(g,E,b);return hi(R,e[0],$t,Kt)}n.valToIdx=g=>hi(g,e[0]),n.posToIdx=Hm,n.posToVal=Ti,n.
valToPos=(g,b,R)=>M[b].ori==0?r(g,M[b],R?W:F,R?C:0):o(g,M[b],R?ce:Ce,R?y:0),n.setCursor=(g,b,R)=>{Ft=g.left,Gt=g.top,Cs(null,b,R)};function Oh(g,b){zt(er,ir,Ot.
left=g),zt(er,jr,Ot.width=b)}function Bh(g,b){zt(er,"top",Ot.top=g),zt(er,eo,Ot.height=b)}let Zr=L.ori==0?Oh:Bh,Jr=L.ori==1?Oh:Bh;function Wm(){if(j&&he.live)for(let g=s==
2?1:0;g<v.length;g++){if(g==0&&rt)continue;let b=he.values[g],R=0;for(let I in b)ke[g][R++].firstChild.nodeValue=b[I]}}function Tc(g,b){if(g!=null&&(g.idxs?g.idxs.
forEach((R,I)=>{ie[I]=R}):Cg(g.idx)||ie.fill(g.idx),he.idx=ie[0]),j&&he.live){for(let R=0;R<v.length;R++)(R>0||s==1&&!rt)&&Xm(R,ie[R]);Wm()}de=!1,b!==!1&&xn("se\
tLegend")}n.setLegend=Tc;function Xm(g,b){let R=v[g],I=g==0&&V==2?zn:e[g],z;rt?z=R.values(n,g,b)??je:(z=R.value(n,b==null?null:I[b],g,b),z=z==null?je:{_:z}),he.
values[g]=z}function Cs(g,b,R){Uh=Ft,Fh=Gt,[Ft,Gt]=ue.move(n,Ft,Gt),ue.left=Ft,ue.top=Gt,pe&&($s&&Ci($s,cn(Ft),0,F,Ce),Ks&&Ci(Ks,0,cn(Gt),F,Ce));let I,z=$t>Kt;Gi=
Lt,us=null;let Z=L.ori==0?F:Ce,oe=L.ori==1?F:Ce;if(Ft<0||qt==0||z){I=ue.idx=null;for(let fe=0;fe<v.length;fe++){let ve=it[fe];ve!=null&&Ci(ve,-10,-10,F,Ce)}Je&&
wi(null,tr,!0,g==null&&sn.setSeries),he.live&&(ie.fill(I),de=!0)}else{let fe,ve,Le;s==1&&(fe=L.ori==0?Ft:Gt,ve=Ti(fe,E),I=ue.idx=hi(ve,e[0],$t,Kt),Le=H(e[0][I],
L,Z,0));let De=-10,Ue=-10,et=0,St=0,vt=!0,dt="",Ye="";for(let He=s==2?1:0;He<v.length;He++){let Bt=v[He],Zt=ie[He],vn=Zt==null?null:s==1?e[He][Zt]:e[He][1][Zt],
Pt=ue.dataIdx(n,He,I,ve),Jt=Pt==null?null:s==1?e[He][Pt]:e[He][1][Pt];if(de=de||Jt!=vn||Pt!=Zt,ie[He]=Pt,He>0&&Bt.show){let kn=Pt==null?-10:Pt==I?Le:H(s==1?e[0][Pt]:
e[He][0][Pt],L,Z,0),Pn=Jt==null?-10:N(Jt,s==1?M[Bt.scale]:M[Bt.facets[1].scale],oe,0);if(Je&&Jt!=null){let jn=L.ori==1?Ft:Gt,li=un(Fe.dist(n,He,Pt,Pn,jn));if(li<
Gi){let Ai=Fe.bias;if(Ai!=0){let Vn=Ti(jn,Bt.scale),ei=Jt>=0?1:-1,ci=Vn>=0?1:-1;ci==ei&&(ci==1?Ai==1?Jt>=Vn:Jt<=Vn:Ai==1?Jt<=Vn:Jt>=Vn)&&(Gi=li,us=He)}else Gi=li,
us=He}}if(de||Ee){let jn,li;L.ori==0?(jn=kn,li=Pn):(jn=Pn,li=kn);let Ai,Vn,ei,ci,Ei,In,Gn=!0,Rs=ae.bbox;if(Rs!=null){Gn=!1;let Ln=Rs(n,He);ei=Ln.left,ci=Ln.top,
Ai=Ln.width,Vn=Ln.height}else ei=jn,ci=li,Ai=Vn=ae.size(n,He);if(In=ae.fill(n,He),Ei=ae.stroke(n,He),Ee)He==us&&Gi<=Fe.prox&&(De=ei,Ue=ci,et=Ai,St=Vn,vt=Gn,dt=In,
Ye=Ei);else{let Ln=it[He];Ln!=null&&(Ut[He]=ei,Cn[He]=ci,ff(Ln,Ai,Vn,Gn),uf(Ln,In,Ei),Ci(Ln,ni(ei),ni(ci),F,Ce))}}}}if(Ee){let He=Fe.prox,Bt=Es==null?Gi<=He:Gi>
He||us!=Es;if(de||Bt){let Zt=it[0];Zt!=null&&(Ut[0]=De,Cn[0]=Ue,ff(Zt,et,St,vt),uf(Zt,dt,Ye),Ci(Zt,ni(De),ni(Ue),F,Ce))}}}if(Ot.show&&ls)if(g!=null){let[fe,ve]=sn.
scales,[Le,De]=sn.match,[Ue,et]=g.cursor.sync.scales,St=g.cursor.drag;if(gn=St._x,_n=St._y,gn||_n){let{left:vt,top:dt,width:Ye,height:He}=g.select,Bt=g.scales[Ue].
ori,Zt=g.posToVal,vn,Pt,Jt,kn,Pn,jn=fe!=null&&Le(fe,Ue),li=ve!=null&&De(ve,et);jn&&gn?(Bt==0?(vn=vt,Pt=Ye):(vn=dt,Pt=He),Jt=M[fe],kn=H(Zt(vn,Ue),Jt,Z,0),Pn=H(Zt(
vn+Pt,Ue),Jt,Z,0),Zr(fi(kn,Pn),un(Pn-kn))):Zr(0,Z),li&&_n?(Bt==1?(vn=vt,Pt=Ye):(vn=dt,Pt=He),Jt=M[ve],kn=N(Zt(vn,et),Jt,oe,0),Pn=N(Zt(vn+Pt,et),Jt,oe,0),Jr(fi(kn,
Pn),un(Pn-kn))):Jr(0,oe)}else Cc()}else{let fe=un(Uh-Dh),ve=un(Fh-Nh);if(L.ori==1){let et=fe;fe=ve,ve=et}gn=Mn.x&&fe>=Mn.dist,_n=Mn.y&&ve>=Mn.dist;let Le=Mn.uni;
Le!=null?gn&&_n&&(gn=fe>=Le,_n=ve>=Le,!gn&&!_n&&(ve>fe?_n=!0:gn=!0)):Mn.x&&Mn.y&&(gn||_n)&&(gn=_n=!0);let De,Ue;gn&&(L.ori==0?(De=Qs,Ue=Ft):(De=js,Ue=Gt),Zr(fi(
De,Ue),un(Ue-De)),_n||Jr(0,oe)),_n&&(L.ori==1?(De=Qs,Ue=Ft):(De=js,Ue=Gt),Jr(fi(De,Ue),un(Ue-De)),gn||Zr(0,Z)),!gn&&!_n&&(Zr(0,0),Jr(0,0))}if(Mn._x=gn,Mn._y=_n,
g==null){if(R){if(Jh!=null){let[fe,ve]=sn.scales;sn.values[0]=fe!=null?Ti(L.ori==0?Ft:Gt,fe):null,sn.values[1]=ve!=null?Ti(L.ori==1?Ft:Gt,ve):null}Kr(Lc,n,Ft,Gt,
F,Ce,I)}if(Je){let fe=R&&sn.setSeries,ve=Fe.prox;Es==null?Gi<=ve&&wi(us,tr,!0,fe):Gi>ve?wi(null,tr,!0,fe):us!=Es&&wi(us,tr,!0,fe)}}de&&(he.idx=I,Tc()),b!==!1&&xn(
"setCursor")}let hs=null;Object.defineProperty(n,"rect",{get(){return hs==null&&$r(!1),hs}});function $r(g=!1){g?hs=null:(hs=x.getBoundingClientRect(),xn("syncR\
ect",hs))}function zh(g,b,R,I,z,Z,oe){ue._lock||ls&&g!=null&&g.movementX==0&&g.movementY==0||(Ac(g,b,R,I,z,Z,oe,!1,g!=null),g!=null?Cs(null,!0,!0):Cs(b,!0,!1))}
function Ac(g,b,R,I,z,Z,oe,fe,ve){if(hs==null&&$r(!1),Ze(g),g!=null)R=g.clientX-hs.left,I=g.clientY-hs.top;else{if(R<0||I<0){Ft=-10,Gt=-10;return}let[Le,De]=sn.
scales,Ue=b.cursor.sync,[et,St]=Ue.values,[vt,dt]=Ue.scales,[Ye,He]=sn.match,Bt=b.axes[0].side%2==1,Zt=L.ori==0?F:Ce,vn=L.ori==1?F:Ce,Pt=Bt?Z:z,Jt=Bt?z:Z,kn=Bt?
I:R,Pn=Bt?R:I;if(vt!=null?R=Ye(Le,vt)?a(et,M[Le],Zt,0):-10:R=Zt*(kn/Pt),dt!=null?I=He(De,dt)?a(St,M[De],vn,0):-10:I=vn*(Pn/Jt),L.ori==1){let jn=R;R=I,I=jn}}ve&&
(b==null||b.cursor.event.type==Lc)&&((R<=1||R>=F-1)&&(R=Ps(R,F)),(I<=1||I>=Ce-1)&&(I=Ps(I,Ce))),fe?(Dh=R,Nh=I,[Qs,js]=ue.move(n,R,I)):(Ft=R,Gt=I)}let Ec={width:0,
height:0,left:0,top:0};function Cc(){na(Ec,!1)}let kh,Vh,Gh,Hh;function Wh(g,b,R,I,z,Z,oe){ls=!0,gn=_n=Mn._x=Mn._y=!1,Ac(g,b,R,I,z,Z,oe,!0,!1),g!=null&&(xt(Dc,Bc,
Xh,!1),Kr(nf,n,Qs,js,F,Ce,null));let{left:fe,top:ve,width:Le,height:De}=Ot;kh=fe,Vh=ve,Gh=Le,Hh=De}function Xh(g,b,R,I,z,Z,oe){ls=Mn._x=Mn._y=!1,Ac(g,b,R,I,z,Z,
oe,!1,!0);let{left:fe,top:ve,width:Le,height:De}=Ot,Ue=Le>0||De>0,et=kh!=fe||Vh!=ve||Gh!=Le||Hh!=De;if(Ue&&et&&na(Ot),Mn.setScale&&Ue&&et){let St=fe,vt=Le,dt=ve,
Ye=De;if(L.ori==1&&(St=ve,vt=De,dt=fe,Ye=Le),gn&&cs(E,Ti(St,E),Ti(St+vt,E)),_n)for(let He in M){let Bt=M[He];He!=E&&Bt.from==null&&Bt.min!=Lt&&cs(He,Ti(dt+Ye,He),
Ti(dt,He))}Cc()}else ue.lock&&(ue._lock=!ue._lock,Cs(b,!0,g!=null));g!=null&&(an(Dc,Bc),Kr(Dc,n,Ft,Gt,F,Ce,null))}function qm(g,b,R,I,z,Z,oe){if(ue._lock)return;
Ze(g);let fe=ls;if(ls){let ve=!0,Le=!0,De=10,Ue,et;L.ori==0?(Ue=gn,et=_n):(Ue=_n,et=gn),Ue&&et&&(ve=Ft<=De||Ft>=F-De,Le=Gt<=De||Gt>=Ce-De),Ue&&ve&&(Ft=Ft<Qs?0:F),
et&&Le&&(Gt=Gt<js?0:Ce),Cs(null,!0,!0),ls=!1}Ft=-10,Gt=-10,ie.fill(null),Cs(null,!0,!0),fe&&(ls=fe)}function qh(g,b,R,I,z,Z,oe){ue._lock||(Ze(g),Yr(),Cc(),g!=null&&
Kr(of,n,Ft,Gt,F,Ce,null))}function Yh(){A.forEach(W0),U(n.width,n.height,!0)}Ds(la,rr,Yh);let nr={};nr.mousedown=Wh,nr.mousemove=zh,nr.mouseup=Xh,nr.dblclick=qh,
nr.setSeries=(g,b,R,I)=>{let z=sn.match[2];R=z(n,b,R),R!=-1&&wi(R,I,!0,!1)},pe&&(xt(nf,x,Wh),xt(Lc,x,zh),xt(sf,x,g=>{Ze(g),$r(!1)}),xt(rf,x,qm),xt(of,x,qh),qc.add(
n),n.syncRect=$r);let ia=n.hooks=i.hooks||{};function xn(g,b,R){Rn?Ct.push([g,b,R]):g in ia&&ia[g].forEach(I=>{I.call(null,n,b,R)})}(i.plugins||[]).forEach(g=>{
for(let b in g.hooks)ia[b]=(ia[b]||[]).concat(g.hooks[b])});let Zh=(g,b,R)=>R,sn=rn({key:null,setSeries:!1,filters:{pub:_f,sub:_f},scales:[E,v[1]?v[1].scale:null],
match:[xf,xf,Zh],values:[null,null]},ue.sync);sn.match.length==2&&sn.match.push(Zh),ue.sync=sn;let Jh=sn.key,Rc=pd(Jh);function Kr(g,b,R,I,z,Z,oe){sn.filters.pub(
g,b,R,I,z,Z,oe)&&Rc.pub(g,b,R,I,z,Z,oe)}Rc.sub(n);function Ym(g,b,R,I,z,Z,oe){sn.filters.sub(g,b,R,I,z,Z,oe)&&nr[g](null,b,R,I,z,Z,oe)}n.pub=Ym;function Zm(){Rc.
unsub(n),qc.delete(n),mn.clear(),Vc(la,rr,Yh),l.remove(),Ae?.remove(),xn("destroy")}n.destroy=Zm;function Pc(){xn("init",i,e),qr(e||i.data,!1),G[E]?Mc(E,G[E]):Yr(),
ne=Ot.show&&(Ot.width>0||Ot.height>0),ee=de=!0,U(i.width,i.height)}return v.forEach(qs),A.forEach(Bi),t?t instanceof HTMLElement?(t.appendChild(l),Pc()):t(n,Pc):
Pc(),n}hn.assign=rn;hn.fmtNum=jc;hn.rangeNum=ca;hn.rangeLog=fa;hn.rangeAsinh=Kc;hn.orient=Us;hn.pxRatio=Mt;hn.join=Ug;hn.fmtDate=tu,hn.tzDate=qg;hn.sync=pd;{hn.
addGap=C0,hn.clipGaps=ma;let i=hn.paths={points:yd};i.linear=Md,i.stepped=I0,i.bars=L0,i.spline=N0}function va(){let i=getComputedStyle(document.documentElement),e=t=>i.getPropertyValue(t).trim();return{paper:e("--paper"),ink:e("--ink"),soft:e("--soft"),line:e(
"--line"),bad:e("--bad"),actual:e("--actual"),actual_more:e("--actual-more"),expected:e("--expected")}}function Ad(i){matchMedia("(prefers-color-scheme: dark)").
addEventListener("change",i)}function at(i,e={},...t){let n=Object.assign(document.createElement(i),e);return n.append(...t),n}function ro(i){if(i==null)return"\
\u2013";let e=Math.abs(i);return e===0||e>=.1?"".concat(Number(i.toPrecision(4))," m"):e>=.001?"".concat(Number((i*1e3).toPrecision(4))," mm"):e>=1e-6?"".concat(
Number((i*1e6).toPrecision(4))," \xB5m"):"".concat(i.toExponential(2)," m")}function Ed(i){return i==null?"\u2013":"".concat(Number(i.toPrecision(5))," J")}var Cd=210,X0=[{title:"Energy",group:"energy",unit:Ed,lines:[{label:"total",column:"total",source:"states"},{label:"potential",column:"potential",source:"track",
dash:[7,4]},{label:"kinetic",column:"kinetic",source:"states",dash:[2,3]}]},{title:"Symmetry",group:"symmetry",unit:ro,lines:[{label:"lateral error",column:"lat\
eral_max",source:"track"},{label:"column spread",column:"column_spread",source:"track",dash:[7,4]}]},{title:"Heights",group:"stacking",unit:ro,lines:[{label:"hi\
ghest",column:"height_max",source:"track"},{label:"mean",column:"height_mean",source:"track",dash:[7,4]}]}],lu=i=>i===void 0||i.every(e=>e===null);function q0(i,e){
let t=i.lines.filter(r=>!lu(e.actual?.[r.column])),n=t.length>0?[[e.actual.step,...t.map(r=>e.actual[r.column])]]:[],s=[];for(let r of t){let o=e.expected[r.source];
!o||lu(o[r.column])||(n.push([o.step,o[r.column]]),s.push(r))}return{lines:t,rings:s,table:n.length>0?hn.join(n):null}}function Y0(i,e,t,n){let s=(a,c)=>i.unit(
c),r=[n.actual,n.actual_more,n.soft],o=a=>r[e.indexOf(a)];return[{label:"step"},...e.map(a=>({label:a.label,value:s,stroke:o(a),width:1.75,dash:a.dash,spanGaps:!0,
points:{show:!1}})),...t.map(a=>({label:"".concat(a.label,", expected"),value:s,stroke:n.expected,width:1.5,class:"ring",paths:()=>null,points:{show:!0,size:8,width:1.5,
stroke:n.expected,fill:"transparent"}}))]}function Z0(i,e,t){return e===null||t===null?[0,1]:e===t?e===0?[-.001,.001]:[e-Math.abs(e)/10,t+Math.abs(t)/10]:hn.rangeNum(
e,t,.1,!0)}function J0(i,e){return t=>{if(i===null)return;let n=Math.round(t.valToPos(i,"x",!0)),{top:s,height:r}=t.bbox,o=t.ctx;o.save(),o.strokeStyle=e.bad,o.
lineWidth=devicePixelRatio,o.setLineDash([3*devicePixelRatio,3*devicePixelRatio]),o.beginPath(),o.moveTo(n,s),o.lineTo(n,s+r),o.stroke(),o.restore()}}function $0(i,e){
let t={stroke:e.soft,grid:{stroke:e.line,width:1},ticks:{stroke:e.line,width:1}},n=(s,r)=>r.map(o=>o===null?"":i.unit(o));return[{...t,label:"step",labelSize:20,
size:36},{...t,values:n,size:82}]}function K0(i,e,t,n){let{lines:s,rings:r,table:o}=q0(i,t);if(o===null)return null;let a=va(),c={width:e.clientWidth,height:Cd,
scales:{x:{time:!1},y:{range:Z0}},legend:{markers:{width:2,dash:(l,u)=>l.series[u].dash?"dashed":"solid"}},axes:$0(i,a),series:Y0(i,s,r,a),hooks:{draw:[J0(n,a)]},
cursor:{y:!1,drag:{x:!0,y:!1}}};return new hn(c,o,e)}function Q0(i,e){let t=i.lines.filter(n=>!lu(e.actual?.[n.column])).map(n=>{let s=e.actual[n.column].at(-1),
r=e.expected[n.source]?.[n.column]?.at(-1);return"".concat(n.label," at the end ").concat(i.unit(s),", expected ").concat(i.unit(r))});return"".concat(i.title,"\
 over steps: ").concat(t.join("; "))}function Rd(i,e,{first:t,groups:n}){let s=X0.filter(u=>n.includes(u.group)),r="Lines: this run. Rings: expected, where the \
golden keeps it (positions to the millimetre)."+(t===null?"":" Dashed upright line: first difference, step ".concat(t,"."))+" Drag across a plot to zoom, double\
-click to zoom out.",o=at("div",{className:"plots"}),a=s.map(u=>{let f=at("div",{className:"plot"});return f.setAttribute("role","img"),f.setAttribute("aria-lab\
el",Q0(u,e)),o.append(at("figure",{},at("figcaption",{textContent:u.title}),f)),f});s.length>0&&i.append(at("h3",{textContent:"Over the steps"}),at("p",{className:"\
soft",textContent:r}),o);let c=[],l=()=>{for(let u of c)u?.destroy();c=s.map((u,f)=>K0(u,a[f],e,t)),c.forEach((u,f)=>{a[f].parentElement.hidden=u===null})};return l(),
{redraw:l,resize(){c.forEach((u,f)=>{let h=a[f].clientWidth;u!==null&&h>0&&h!==u.width&&u.setSize({width:h,height:Cd})})},show_step(u){for(let f of c)f?.setCursor(
{left:f.valToPos(u,"x"),top:0})}}}var j0=700,cu=(i,e)=>at("img",{src:i.querySelector("img").src,alt:"".concat(e," picture")});function Pd(i){let e=A=>i.querySelector('figure[data-kind="'.concat(
A,'"]'));if(!e("expected")||!e("actual"))return;let t=cu(e("expected"),"expected"),n=cu(e("actual"),"actual"),s=e("difference")?cu(e("difference"),"difference"):
null;n.className="over";let r=at("div",{className:"edge"}),o=at("span",{className:"tag",textContent:"expected"}),a=at("span",{className:"tag right",textContent:"\
actual"}),c=at("div",{className:"stack"},t,n,r,o,a),l=at("input",{type:"range",min:0,max:100,value:50,className:"picture-slider"});l.setAttribute("aria-label","\
step ".concat(i.dataset.step,": expected to the left of the edge, actual to the right"));let u=at("output"),f=at("button",{type:"button",textContent:"Blink",className:"\
picture-blink"}),h=at("button",{type:"button",textContent:"Difference"});s&&(s.className="over",c.append(s));let d=null,x=!1,S=A=>{n.style.clipPath="inset(0 0 0\
 ".concat(A,"%)"),r.style.left="".concat(A,"%"),r.hidden=A<=0||A>=100||x,o.hidden=A<=0||x,a.hidden=A>=100||x,s&&(s.hidden=!x),x?u.value="difference: the brighte\
r, the further apart":A>=100?u.value="expected":A<=0?u.value="actual":u.value="left of the edge expected, right of it actual"},p=()=>{clearInterval(d),d=null,f.
setAttribute("aria-pressed","false")},m=A=>{x=A,h.setAttribute("aria-pressed",String(A))};l.addEventListener("input",()=>{p(),m(!1),S(Number(l.value))}),f.addEventListener(
"click",()=>{let A=d!==null;if(p(),m(!1),A)return S(Number(l.value));let M=!0;f.setAttribute("aria-pressed","true"),S(100),d=setInterval(()=>{M=!M,S(M?100:0)},j0)}),
h.addEventListener("click",()=>{p(),m(!x),S(Number(l.value))}),p(),m(!1),S(50);let v=at("div",{className:"controls"},l,f,...s?[h]:[],u);i.prepend(at("div",{className:"\
viewer"},c,v))}var Dd={failed:"failed",within_bounds:"moved within bounds",unchanged:"unchanged",out_of_bounds:"out of bounds, not required",not_judged:"not judged"},Nd=Object.
keys(Dd),Id={name:i=>i.dataset.name,verdict:i=>Nd.indexOf(i.dataset.verdict),magnitude:i=>-Number(i.dataset.magnitude),category:i=>i.dataset.category},e_=(i,e)=>i<
e?-1:i>e?1:0;function t_(i,e,t){let n=[...i.rows].sort((s,r)=>(t?-1:1)*e_(Id[e](s),Id[e](r)));i.append(...n)}function n_(i){let e=[...i.querySelectorAll("th[dat\
a-sort]")];for(let t of e){let n=at("button",{type:"button",textContent:t.textContent});t.replaceChildren(n),n.addEventListener("click",()=>{let s=t.getAttribute(
"aria-sort")==="ascending";for(let r of e)r.removeAttribute("aria-sort");t.setAttribute("aria-sort",s?"descending":"ascending"),t_(i.tBodies[0],t.dataset.sort,s)})}}
function Ld(i,e,t){let n=at("select",{},at("option",{value:"",textContent:"all"}),...e.map(s=>at("option",{value:s,textContent:t(s)})));return{select:n,place:at(
"label",{},i,n)}}function Ud(i){n_(i);let e=[...i.tBodies[0].rows,...document.querySelectorAll("details[data-verdict]")],t=c=>[...new Set(e.map(l=>l.dataset[c]))],
n=Ld("Verdict",Nd.filter(c=>t("verdict").includes(c)),c=>Dd[c]),s=Ld("Category",t("category").sort(),c=>c),r=at("input",{type:"search"}),o=at("output"),a=()=>{let c=0;
for(let l of e){let u=l instanceof HTMLTableRowElement,f=u?l.dataset.name:l.querySelector("h3").id;l.hidden=n.select.value!==""&&l.dataset.verdict!==n.select.value||
s.select.value!==""&&l.dataset.category!==s.select.value||!f.includes(r.value),u&&!l.hidden&&++c}o.value="".concat(c," of ").concat(i.tBodies[0].rows.length," f\
ailed or moved cases")};for(let c of[n.select,s.select,r])c.addEventListener("input",a);a(),i.parentElement.before(at("div",{className:"filters"},n.place,s.place,
at("label",{},"Name",r),o))}var hp=0,ku=1,fp=2;var Vo=1,dp=2,Or=3,Ts=0,Fn=1,Ni=2,Vs=0,Br=1,Vu=2,Gu=3,Hu=4,pp=5;var Gs=100,mp=101,gp=102,_p=103,xp=104,vp=200,yp=201,Sp=202,Mp=203,Wu=204,Xu=205,bp=206,wp=207,Tp=208,Ap=209,Ep=210,Cp=211,Rp=212,Pp=213,Ip=214,Xa=0,qa=1,Ya=2,Cr=3,
Za=4,Ja=5,$a=6,Ka=7,Tl=0,Lp=1,Dp=2,Ui=0,qu=1,Yu=2,Zu=3,Ju=4,$u=5,Ku=6,Qu=7;var ju=300,Hs=301,zr=302,Al=303,El=304,Qa=1e3,Pi=1001,ja=1002,Sn=1003,Np=1004;var Go=1005;var Un=1006,Cl=1007;var is=1008;var Bn=1009,eh=1010,th=1011,kr=1012,Rl=1013,xi=1014,oi=1015,vi=1016,Pl=1017,Il=1018,Ws=1020,nh=35902,ih=35899,sh=1021,rh=1022,yi=1023,Ki=1026,ss=1027,Ll=1028,Dl=1029,
As=1030,Nl=1031;var Ul=1033,Ho=33776,Wo=33777,Xo=33778,qo=33779,Fl=35840,Ol=35841,Bl=35842,zl=35843,kl=36196,Vl=37492,Gl=37496,Hl=37488,Wl=37489,Yo=37490,Xl=37491,ql=37808,Yl=37809,
Zl=37810,Jl=37811,$l=37812,Kl=37813,Ql=37814,jl=37815,ec=37816,tc=37817,nc=37818,ic=37819,sc=37820,rc=37821,oc=36492,ac=36494,lc=36495,cc=36283,uc=36284,Zo=36285,
hc=36286;var mo=2300,el=2301,Ha=2302,Du=2303,Nu=2400,Uu=2401,Fu=2402;var Up=3200;var fc=0,Fp=1,rs="",Zn="srgb",go="srgb-linear",_o="linear",Tt="srgb";var Wa=7680;var Op=519,Bp=512,zp=513,kp=514,oh=515,Vp=516,Gp=517,ah=518,lh=519,Hp=35044;var ch="300 es",si=2e3,Rr=2001;function i_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function s_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function xo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Wp(){
let i=xo("canvas");return i.style.display="block",i}var Fd={},Pr=null;function uh(...i){let e="THREE."+i.shift();Pr?Pr("log",e,...i):console.log(e,...i)}function Xp(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];
t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function qe(...i){
i=Xp(i);let e="THREE."+i.shift();if(Pr)Pr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Ke(...i){i=
Xp(i);let e="THREE."+i.shift();if(Pr)Pr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function po(...i){
let e=i.join(" ");e in Fd||(Fd[e]=!0,qe(...i))}function qp(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:
setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Yp={[Xa]:Xa,[Ya]:$a,[Za]:Za,[Cr]:Ja,[qa]:qa,[$a]:Ya,[Ka]:Ka,[Ja]:Cr},Ii=class{addEventListener(e,t){this.
_listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;
return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(
t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,
o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},wn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","1\
4","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","3\
4","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","5\
4","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","7\
4","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","9\
4","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b\
4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d\
4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f\
4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var uu=Math.PI/180,tl=180/Math.PI;function Jo(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|
0;return(wn[i&255]+wn[i>>8&255]+wn[i>>16&255]+wn[i>>24&255]+"-"+wn[e&255]+wn[e>>8&255]+"-"+wn[e>>16&15|64]+wn[e>>24&255]+"-"+wn[t&63|128]+wn[t>>8&255]+"-"+wn[t>>
16&255]+wn[t>>24&255]+wn[n&255]+wn[n>>8&255]+wn[n>>16&255]+wn[n>>24&255]).toLowerCase()}function _t(i,e,t){return Math.max(e,Math.min(t,i))}function r_(i,e){return(i%
e+e)%e}function hu(i,e,t){return(1-t)*i+t*e}function Zp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function hh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:
return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function o_(i,e){if(e.constructor===Float32Array)return i;let t=hh(e);if(t===
void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function a_(i,e){if(e.constructor===Float32Array)return i;let t=hh(e);
if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var ft=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.
y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,
this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){
switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.
x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.
x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=
e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.
y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.
x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.
x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),
this.y=_t(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),
this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.
y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.
x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){
return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.
sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(
e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.
normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.
y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.
y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.
x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Jn=class{constructor(e=0,t=0,n=0,s=1){
this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let c=n[s+0],l=n[s+1],u=n[s+2],f=n[s+3],h=r[o+0],d=r[o+1],x=r[o+2],
S=r[o+3];if(f!==S||c!==h||l!==d||u!==x){let p=c*h+l*d+u*x+f*S;p<0&&(h=-h,d=-d,x=-x,S=-S,p=-p);let m=1-a;if(p<.9995){let v=Math.acos(p),A=Math.sin(v);m=Math.sin(
m*v)/A,a=Math.sin(a*v)/A,c=c*m+h*a,l=l*m+d*a,u=u*m+x*a,f=f*m+S*a}else{c=c*m+h*a,l=l*m+d*a,u=u*m+x*a,f=f*m+S*a;let v=1/Math.sqrt(c*c+l*l+u*u+f*f);c*=v,l*=v,u*=v,
f*=v}}e[t]=c,e[t+1]=l,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],u=n[s+3],f=r[o],h=r[o+1],d=r[o+2],x=r[o+3];return e[t]=
a*x+u*f+c*d-l*h,e[t+1]=c*x+u*h+l*f-a*d,e[t+2]=l*x+u*d+a*h-c*f,e[t+3]=u*x-a*f-c*h-l*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){
return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this.
_w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this.
_x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,
r=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(n/2),u=a(s/2),f=a(r/2),h=c(n/2),d=c(s/2),x=c(r/2);switch(o){case"XYZ":this._x=h*u*f+l*d*x,this._y=l*d*f-h*u*x,this._z=
l*u*x+h*d*f,this._w=l*u*f-h*d*x;break;case"YXZ":this._x=h*u*f+l*d*x,this._y=l*d*f-h*u*x,this._z=l*u*x-h*d*f,this._w=l*u*f+h*d*x;break;case"ZXY":this._x=h*u*f-l*
d*x,this._y=l*d*f+h*u*x,this._z=l*u*x+h*d*f,this._w=l*u*f-h*d*x;break;case"ZYX":this._x=h*u*f-l*d*x,this._y=l*d*f+h*u*x,this._z=l*u*x-h*d*f,this._w=l*u*f+h*d*x;
break;case"YZX":this._x=h*u*f+l*d*x,this._y=l*d*f+h*u*x,this._z=l*u*x-h*d*f,this._w=l*u*f-h*d*x;break;case"XZY":this._x=h*u*f-l*d*x,this._y=l*d*f-h*u*x,this._z=
l*u*x+h*d*f,this._w=l*u*f+h*d*x;break;default:qe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){
let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,
n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],c=t[9],l=t[2],u=t[6],f=t[10],h=n+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-c)*d,this._y=(r-l)*d,this._z=(o-
s)*d}else if(n>a&&n>f){let d=2*Math.sqrt(1+n-a-f);this._w=(u-c)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+l)/d}else if(a>f){let d=2*Math.sqrt(1+a-n-f);this._w=
(r-l)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(c+u)/d}else{let d=2*Math.sqrt(1+f-n-a);this._w=(o-s)/d,this._x=(r+l)/d,this._y=(c+u)/d,this._z=.25*d}return this.
_onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):
(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){
return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){
return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this.
_x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this.
_x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=
this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){
return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,c=t._y,l=t._z,u=t._w;return this._x=n*u+o*a+s*l-r*c,this.
_y=s*u+o*c+r*a-n*l,this._z=r*u+o*l+n*c-s*a,this._w=o*u-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=
-n,s=-s,r=-r,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,t=Math.sin(t*l)/u,this._x=this._x*c+n*t,this._y=this._y*c+s*t,this.
_z=this._z*c+r*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this.
normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),
s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===
this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=
this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this.
_onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,
yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===
void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){
return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index\
 is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vecto\
r3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.
x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){
return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){
return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=
e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Od.setFromEuler(e))}applyAxisAngle(e,t){
return this.applyQuaternion(Od.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*
t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.
elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*
o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*s-a*n),u=2*(a*t-r*s),f=2*(r*n-o*t);return this.x=t+c*l+o*f-a*u,this.y=n+
c*u+a*l-r*f,this.z=s+c*f+r*u-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(
e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.
y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(
1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.
max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){
return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(
_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.
ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.
x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.
x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){
return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(
e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.
y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,c=t.z;return this.x=s*c-r*a,this.
y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){
return fu.copy(this).projectOnVector(e),this.sub(fu)}reflect(e){return this.sub(fu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*
e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){
let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){
return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.
z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),
this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.
setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){
return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,
this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],
this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(
t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.
random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},fu=new q,
Od=new Jn,Qe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l)}set(e,t,n,s,r,o,a,c,l){
let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=c,u[6]=n,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.
elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(
this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],
t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.
elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],u=n[4],f=n[7],h=n[2],d=n[5],x=n[8],S=s[0],p=s[3],m=s[6],v=s[1],A=s[4],M=s[7],P=s[2],E=s[5],_=s[8];return r[0]=
o*S+a*v+c*P,r[3]=o*p+a*A+c*E,r[6]=o*m+a*M+c*_,r[1]=l*S+u*v+f*P,r[4]=l*p+u*A+f*E,r[7]=l*m+u*M+f*_,r[2]=h*S+d*v+x*P,r[5]=h*p+d*A+x*E,r[8]=h*m+d*M+x*_,this}multiplyScalar(e){
let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],
o=e[4],a=e[5],c=e[6],l=e[7],u=e[8];return t*o*u-t*a*l-n*r*u+n*a*c+s*r*l-s*o*c}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],
u=e[8],f=u*o-a*l,h=a*c-u*r,d=l*r-o*c,x=t*f+n*h+s*d;if(x===0)return this.set(0,0,0,0,0,0,0,0,0);let S=1/x;return e[0]=f*S,e[1]=(s*l-u*n)*S,e[2]=(a*n-s*o)*S,e[3]=
h*S,e[4]=(u*t-s*c)*S,e[5]=(s*r-a*t)*S,e[6]=d*S,e[7]=(n*c-l*t)*S,e[8]=(o*t-n*r)*S,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=
t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=
t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.
set(n*c,n*l,-n*(c*o+l*a)+o+e,-s*l,s*c,-s*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return po("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(
du.makeScale(e,t)),this}rotate(e){return po("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(du.makeRotation(-e)),this}translate(e,t){
return po("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(du.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?
this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){
return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<
9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+
6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},du=new Qe,Bd=new Qe().set(.4123908,.3575843,.1804808,.212639,
.7151687,.0721923,.0193308,.1191948,.9505322),zd=new Qe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function l_(){
let i={enabled:!0,workingColorSpace:go,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Tt&&(s.r=$i(s.r),s.
g=$i(s.g),s.b=$i(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].
transfer===Tt&&(s.r=Er(s.r),s.g=Er(s.g),s.b=Er(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){
return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===rs?_o:this.spaces[s].
transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){
return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].
fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.
workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define(
{[go]:{primaries:e,whitePoint:n,transfer:_o,toXYZ:Bd,fromXYZ:zd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Zn},outputColorSpaceConfig:{drawingBufferColorSpace:Zn}},
[Zn]:{primaries:e,whitePoint:n,transfer:Tt,toXYZ:Bd,fromXYZ:zd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Zn}}}),i}var gt=l_();function $i(i){
return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Er(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var dr,nl=class{static getDataURL(e,t="\
image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{dr===void 0&&(dr=xo("canvas")),
dr.width=e.width,dr.height=e.height;let s=dr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=dr}return n.toDataURL(
t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<
"u"&&e instanceof ImageBitmap){let t=xo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(
0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=$i(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<
t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor($i(t[n]/255)*255):t[n]=$i(t[n]);return{data:t,width:e.width,height:e.height}}else
return qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},c_=0,Ir=class{constructor(e=null){this.isTextureSource=!0,
Object.defineProperty(this,"id",{value:c_++}),this.uuid=Jo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<
"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==
null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.
uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)
s[o].isDataTexture?r.push(pu(s[o].image)):r.push(pu(s[o]))}else r=pu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function pu(i){return typeof HTMLImageElement<
"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?nl.getDataURL(
i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(qe("Texture: Unable to serialize Texture."),{})}var u_=0,mu=new q,On=class i extends Ii{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Pi,s=Pi,r=Un,o=is,a=yi,c=Bn,l=i.DEFAULT_ANISOTROPY,u=rs){super(),this.
isTexture=!0,Object.defineProperty(this,"id",{value:u_++}),this.uuid=Jo(),this.name="",this.source=new Ir(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.
wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new ft(0,0),this.repeat=
new ft(1,1),this.center=new ft(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=
!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=
!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(mu).x}get height(){
return this.source.getSize(mu).y}get depth(){return this.source.getSize(mu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){
this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.
push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=
e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=
e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(
e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.
generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.
unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,
this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===
void 0){qe("Texture.setValues(): parameter '".concat(t,"' has value of undefined."));continue}let s=this[t];if(s===void 0){qe("Texture.setValues(): property '".
concat(t,"' does not exist."));continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){
let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"T\
exture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[
this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,
type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,
generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.
keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==
ju)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Qa:e.x=e.x-Math.floor(e.x);break;case Pi:e.x=e.x<0?0:1;break;case ja:Math.abs(Math.
floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Qa:e.y=e.y-Math.floor(e.y);break;case Pi:e.y=e.y<
0?0:1;break;case ja:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===
!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};On.DEFAULT_IMAGE=null;On.DEFAULT_MAPPING=ju;On.DEFAULT_ANISOTROPY=
1;var Ht=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=
e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,
this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:
this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){
switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){
return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.
x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,
this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.
y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-
t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,
this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=
o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.
multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.
y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,c=e.elements,l=c[0],u=c[4],f=c[8],h=c[1],d=c[5],x=c[9],S=c[2],p=c[6],m=c[10];if(Math.abs(
u-h)<.01&&Math.abs(f-S)<.01&&Math.abs(x-p)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+S)<.1&&Math.abs(x+p)<.1&&Math.abs(l+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.
PI;let A=(l+1)/2,M=(d+1)/2,P=(m+1)/2,E=(u+h)/4,_=(f+S)/4,T=(x+p)/4;return A>M&&A>P?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=_/n):M>P?M<.01?
(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=E/s,r=T/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=_/r,s=T/r),this.set(n,s,r,t),this}let v=Math.
sqrt((p-x)*(p-x)+(f-S)*(f-S)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(p-x)/v,this.y=(f-S)/v,this.z=(h-u)/v,this.w=Math.acos((l+d+m-1)/2),this}setFromMatrixPosition(e){
let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.
min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(
this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){
return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(
n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){
return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=
Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.
trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.
y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.
z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||
1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.
w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.
x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.
x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){
return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.
w}},il=class extends Ii{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Un,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,
resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,
samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Ht(0,0,
e,t),this.scissorTest=!1,this.viewport=new Ht(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new On({width:e,height:t,depth:n.depth}),
this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,
this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=
n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,
this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){
let t={minFilter:Un,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&
(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==
void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),
e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),
e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){
this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===
null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==
n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].
image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),
this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(
e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].
clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Ir(
s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,
this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,
this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=
null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=
e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},$n=class extends il{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=
!0}},vo=class extends On{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Sn,this.
minFilter=Sn,this.wrapR=Pi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,
this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var sl=class extends On{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Sn,this.
minFilter=Sn,this.wrapR=Pi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var bt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,c,l,u,f,h,d,x,S,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.
set(e,t,n,s,r,o,a,c,l,u,f,h,d,x,S,p)}set(e,t,n,s,r,o,a,c,l,u,f,h,d,x,S,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=
l,m[6]=u,m[10]=f,m[14]=h,m[3]=d,m[7]=x,m[11]=S,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.
elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=
n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],
this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===
0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){
return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,
n=e.elements,s=1/pr.setFromMatrixColumn(e,0).length(),r=1/pr.setFromMatrixColumn(e,1).length(),o=1/pr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=
n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){
let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,x=a*
u,S=a*f;t[0]=c*u,t[4]=-c*f,t[8]=l,t[1]=d+x*l,t[5]=h-S*l,t[9]=-a*c,t[2]=S-h*l,t[6]=x+d*l,t[10]=o*c}else if(e.order==="YXZ"){let h=c*u,d=c*f,x=l*u,S=l*f;t[0]=h+S*
a,t[4]=x*a-d,t[8]=o*l,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-x,t[6]=S+h*a,t[10]=o*c}else if(e.order==="ZXY"){let h=c*u,d=c*f,x=l*u,S=l*f;t[0]=h-S*a,t[4]=-o*f,t[8]=x+
d*a,t[1]=d+x*a,t[5]=o*u,t[9]=S-h*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let h=o*u,d=o*f,x=a*u,S=a*f;t[0]=c*u,t[4]=x*l-d,t[8]=h*l+S,t[1]=c*f,t[5]=
S*l+h,t[9]=d*l-x,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let h=o*c,d=o*l,x=a*c,S=a*l;t[0]=c*u,t[4]=S-h*f,t[8]=x*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-l*
u,t[6]=d*f+x,t[10]=h-S*f}else if(e.order==="XZY"){let h=o*c,d=o*l,x=a*c,S=a*l;t[0]=c*u,t[4]=-f,t[8]=l*u,t[1]=h*f+S,t[5]=o*u,t[9]=d*f-x,t[2]=x*f-d,t[6]=a*u,t[10]=
S*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(h_,e,f_)}lookAt(e,t,n){let s=this.elements;
return qn.subVectors(e,t),qn.lengthSq()===0&&(qn.z=1),qn.normalize(),ps.crossVectors(n,qn),ps.lengthSq()===0&&(Math.abs(n.z)===1?qn.x+=1e-4:qn.z+=1e-4,qn.normalize(),
ps.crossVectors(n,qn)),ps.normalize(),ya.crossVectors(qn,ps),s[0]=ps.x,s[4]=ya.x,s[8]=qn.x,s[1]=ps.y,s[5]=ya.y,s[9]=qn.y,s[2]=ps.z,s[6]=ya.z,s[10]=qn.z,this}multiply(e){
return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],
a=n[4],c=n[8],l=n[12],u=n[1],f=n[5],h=n[9],d=n[13],x=n[2],S=n[6],p=n[10],m=n[14],v=n[3],A=n[7],M=n[11],P=n[15],E=s[0],_=s[4],T=s[8],O=s[12],D=s[1],L=s[5],V=s[9],
H=s[13],N=s[2],G=s[6],J=s[10],k=s[14],le=s[3],$=s[7],Q=s[11],ie=s[15];return r[0]=o*E+a*D+c*N+l*le,r[4]=o*_+a*L+c*G+l*$,r[8]=o*T+a*V+c*J+l*Q,r[12]=o*O+a*H+c*k+l*
ie,r[1]=u*E+f*D+h*N+d*le,r[5]=u*_+f*L+h*G+d*$,r[9]=u*T+f*V+h*J+d*Q,r[13]=u*O+f*H+h*k+d*ie,r[2]=x*E+S*D+p*N+m*le,r[6]=x*_+S*L+p*G+m*$,r[10]=x*T+S*V+p*J+m*Q,r[14]=
x*O+S*H+p*k+m*ie,r[3]=v*E+A*D+M*N+P*le,r[7]=v*_+A*L+M*G+P*$,r[11]=v*T+A*V+M*J+P*Q,r[15]=v*O+A*H+M*k+P*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=
e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,
t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],c=e[9],l=e[13],u=e[2],f=e[6],h=e[10],d=e[14],x=e[3],S=e[7],p=e[11],m=e[15],v=c*d-l*h,A=a*d-l*f,M=a*h-c*f,P=o*d-l*u,E=o*
h-c*u,_=o*f-a*u;return t*(S*v-p*A+m*M)-n*(x*v-p*P+m*E)+s*(x*A-S*P+m*_)-r*(x*M-S*E+p*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],
a=e[9],c=e[2],l=e[6],u=e[10];return t*(o*u-a*l)-n*(r*u-a*c)+s*(r*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,
t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?
(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],f=e[9],
h=e[10],d=e[11],x=e[12],S=e[13],p=e[14],m=e[15],v=t*a-n*o,A=t*c-s*o,M=t*l-r*o,P=n*c-s*a,E=n*l-r*a,_=s*l-r*c,T=u*S-f*x,O=u*p-h*x,D=u*m-d*x,L=f*p-h*S,V=f*m-d*S,H=h*
m-d*p,N=v*H-A*V+M*L+P*D-E*O+_*T;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/N;return e[0]=(a*H-c*V+l*L)*G,e[1]=(s*V-n*H-r*L)*G,e[2]=(S*_-p*
E+m*P)*G,e[3]=(h*E-f*_-d*P)*G,e[4]=(c*D-o*H-l*O)*G,e[5]=(t*H-s*D+r*O)*G,e[6]=(p*M-x*_-m*A)*G,e[7]=(u*_-h*M+d*A)*G,e[8]=(o*V-a*D+l*T)*G,e[9]=(n*D-t*V-r*T)*G,e[10]=
(x*E-S*M+m*v)*G,e[11]=(f*M-u*E-d*v)*G,e[12]=(a*O-o*L-c*T)*G,e[13]=(t*L-n*O+s*T)*G,e[14]=(S*A-x*P-p*v)*G,e[15]=(u*P-f*A+h*v)*G,this}scale(e){let t=this.elements,
n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,
t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.
isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.
set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){
let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,c=e.
z,l=r*o,u=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+n,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,
t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,
c=t._w,l=r+r,u=o+o,f=a+a,h=r*l,d=r*u,x=r*f,S=o*u,p=o*f,m=a*f,v=c*l,A=c*u,M=c*f,P=n.x,E=n.y,_=n.z;return s[0]=(1-(S+m))*P,s[1]=(d+M)*P,s[2]=(x-A)*P,s[3]=0,s[4]=(d-
M)*E,s[5]=(1-(h+m))*E,s[6]=(p+v)*E,s[7]=0,s[8]=(x+A)*_,s[9]=(p-v)*_,s[10]=(1-(h+S))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.
elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=pr.set(s[0],s[1],s[2]).length(),a=pr.
set(s[4],s[5],s[6]).length(),c=pr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),di.copy(this);let l=1/o,u=1/a,f=1/c;return di.elements[0]*=l,di.elements[1]*=l,di.elements[2]*=
l,di.elements[4]*=u,di.elements[5]*=u,di.elements[6]*=u,di.elements[8]*=f,di.elements[9]*=f,di.elements[10]*=f,t.setFromRotationMatrix(di),n.x=o,n.y=a,n.z=c,this}makePerspective(e,t,n,s,r,o,a=si,c=!1){
let l=this.elements,u=2*r/(t-e),f=2*r/(n-s),h=(t+e)/(t-e),d=(n+s)/(n-s),x,S;if(c)x=r/(o-r),S=o*r/(o-r);else if(a===si)x=-(o+r)/(o-r),S=-2*o*r/(o-r);else if(a===
Rr)x=-o/(o-r),S=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=
f,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=x,l[14]=S,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=si,c=!1){let l=this.elements,u=2/(t-e),f=2/(n-
s),h=-(t+e)/(t-e),d=-(n+s)/(n-s),x,S;if(c)x=1/(o-r),S=o/(o-r);else if(a===si)x=-2/(o-r),S=-(o+r)/(o-r);else if(a===Rr)x=-1/(o-r),S=-r/(o-r);else throw new Error(
"THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=h,l[1]=0,l[5]=f,l[9]=0,l[13]=d,l[2]=0,l[6]=0,l[10]=x,l[14]=
S,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<
16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+
6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},pr=new q,di=new bt,h_=new q(
0,0,0),f_=new q(1,1,1),ps=new q,ya=new q,qn=new q,kd=new bt,Vd=new Jn,Qi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,
this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){
return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){
return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){
return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],
o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=
Math.atan2(-o,r)):(this._x=Math.atan2(h,l),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.
atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(_t(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(
-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-_t(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(c,r)):
(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(_t(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-f,r)):(this.
_x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,l),this._y=Math.atan2(a,r)):(this._x=Math.
atan2(-u,d),this._y=0);break;default:qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),
this}setFromQuaternion(e,t,n){return kd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(kd,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,
e.z,t)}reorder(e){return Vd.setFromEuler(this),this.setFromQuaternion(Vd,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){
return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this.
_y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this.
_z,yield this._order}};Qi.DEFAULT_ORDER="XYZ";var yo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.
mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&
(1<<e|0))!==0}},d_=0,Gd=new q,mr=new Jn,Xi=new bt,Sa=new q,oo=new q,p_=new q,m_=new Jn,Hd=new q(1,0,0),Wd=new q(0,1,0),Xd=new q(0,0,1),qd={type:"added"},g_={type:"\
removed"},gr={type:"childadded",child:null},gu={type:"childremoved",child:null},An=class i extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(
this,"id",{value:d_++}),this.uuid=Jo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new q,t=new Qi,n=new Jn,
s=new q(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{
configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,
enumerable:!0,value:s},modelViewMatrix:{value:new bt},normalMatrix:{value:new Qe}}),this.matrix=new bt,this.matrixWorld=new bt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,
this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new yo,this.visible=!0,this.castShadow=!1,this.receiveShadow=
!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},
this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(
e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){
return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(
e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return mr.setFromAxisAngle(
e,t),this.quaternion.multiply(mr),this}rotateOnWorldAxis(e,t){return mr.setFromAxisAngle(e,t),this.quaternion.premultiply(mr),this}rotateX(e){return this.rotateOnAxis(
Hd,e)}rotateY(e){return this.rotateOnAxis(Wd,e)}rotateZ(e){return this.rotateOnAxis(Xd,e)}translateOnAxis(e,t){return Gd.copy(e).applyQuaternion(this.quaternion),
this.position.add(Gd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Hd,e)}translateY(e){return this.translateOnAxis(Wd,e)}translateZ(e){return this.
translateOnAxis(Xd,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),
e.applyMatrix4(Xi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Sa.copy(e):Sa.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),oo.setFromMatrixPosition(
this.matrixWorld),this.isCamera||this.isLight?Xi.lookAt(oo,Sa,this.up):Xi.lookAt(Sa,oo,this.up),this.quaternion.setFromRotationMatrix(Xi),s&&(Xi.extractRotation(
s.matrixWorld),mr.setFromRotationMatrix(Xi),this.quaternion.premultiply(mr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(
arguments[t]);return this}return e===this?(Ke("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=
this,this.children.push(e),e.dispatchEvent(qd),gr.child=e,this.dispatchEvent(gr),gr.child=null):Ke("Object3D.add: object not an instance of THREE.Object3D.",e),
this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.
parent=null,this.children.splice(t,1),e.dispatchEvent(g_),gu.child=e,this.dispatchEvent(gu),gu.child=null),this}removeFromParent(){let e=this.parent;return e!==
null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Xi.copy(this.matrixWorld).invert(),e.parent!==
null&&(e.parent.updateWorldMatrix(!0,!1),Xi.multiply(e.parent.matrixWorld)),e.applyMatrix4(Xi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(
!1,!0),e.dispatchEvent(qd),gr.child=e,this.dispatchEvent(gr),gr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.
getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(
e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(
e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(
!0,!1),this.matrixWorld.decompose(oo,e,p_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(oo,m_,e),e}getWorldDirection(e){this.
updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.
children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)
t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,
this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*
t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===
!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,
e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(
!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(
this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,
a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},
shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.
name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,
s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=
this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.
assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.
type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),
this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=
this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.
toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.
slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,
s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.
toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&
(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.
uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=
this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(
e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){
let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let f=c[l];r(e.shapes,f)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,
s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(
this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(e.materials,this.material[c]));s.material=a}else s.material=r(e.materials,this.material);
if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){
s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),
l=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),x=o(e.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&
(n.textures=l),u.length>0&&(n.images=u),f.length>0&&(n.shapes=f),h.length>0&&(n.skeletons=h),d.length>0&&(n.animations=d),x.length>0&&(n.nodes=x)}return n.object=
s,n;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.
name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.
pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=
e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,
this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.
userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent(
{type:"dispose"})}};An.DEFAULT_UP=new q(0,1,0);An.DEFAULT_MATRIX_AUTO_UPDATE=!0;An.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ks=class extends An{constructor(){super(),
this.isGroup=!0,this.type="Group"}},__={type:"move"},Lr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===
null&&(this._hand=new ks,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){
return this._targetRay===null&&(this._targetRay=new ks,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this.
_targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===
null&&(this._grip=new ks,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=
!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this.
_grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.
values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),
this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,
r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let S of e.hand.values()){
let p=t.getJointPose(S,n),m=this._getHandJoint(l,S);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=
!0,m.jointRadius=p.radius),m.visible=p!==null}let u=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,x=.005;l.inputState.
pinching&&h>d+x?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&h<=d-x&&(l.inputState.
pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(c.matrix.
fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.
copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&
c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.
transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(
s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(
__)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){
let n=new ks;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Jp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,
aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,
chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,
darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,
darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,
deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,
ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,
indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,
lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,
lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,
maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,
mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,
olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,
papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,
royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,
slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,
violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ms={h:0,s:0,l:0},Ma={h:0,s:0,l:0};function _u(i,e,t){return t<
0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var st=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.
set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.
setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Zn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,
this.b=(e&255)/255,gt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=gt.workingColorSpace){return this.r=e,this.g=t,this.b=n,gt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=gt.
workingColorSpace){if(e=r_(e,1),t=_t(t,0,1),n=_t(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=_u(o,r,e+1/3),this.g=_u(o,r,
e),this.b=_u(o,r,e-1/3)}return gt.colorSpaceToWorking(this,s),this}setStyle(e,t=Zn){function n(r){r!==void 0&&parseFloat(r)<1&&qe("Color: Alpha component of "+e+
" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.
exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.
exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"\
hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(
r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.
exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.
setHex(parseInt(r,16),t);qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Zn){let n=Jp[e.toLowerCase()];
return n!==void 0?this.setHex(n,t):qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=
e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=$i(e.r),this.g=$i(e.g),this.b=$i(e.b),this}copyLinearToSRGB(e){return this.r=Er(e.r),this.g=Er(e.g),this.b=
Er(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Zn){return gt.
workingToColorSpace(Tn.copy(this),e),Math.round(_t(Tn.r*255,0,255))*65536+Math.round(_t(Tn.g*255,0,255))*256+Math.round(_t(Tn.b*255,0,255))}getHexString(e=Zn){return("\
000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=gt.workingColorSpace){gt.workingToColorSpace(Tn.copy(this),t);let n=Tn.r,s=Tn.g,r=Tn.b,o=Math.max(n,s,
r),a=Math.min(n,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let f=o-a;switch(l=u<=.5?f/(o+a):f/(2-o-a),o){case n:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-n)/f+2;break;case r:
c=(n-s)/f+4;break}c/=6}return e.h=c,e.s=l,e.l=u,e}getRGB(e,t=gt.workingColorSpace){return gt.workingToColorSpace(Tn.copy(this),t),e.r=Tn.r,e.g=Tn.g,e.b=Tn.b,e}getStyle(e=Zn){
gt.workingToColorSpace(Tn.copy(this),e);let t=Tn.r,n=Tn.g,s=Tn.b;return e!==Zn?"color(".concat(e," ").concat(t.toFixed(3)," ").concat(n.toFixed(3)," ").concat(s.
toFixed(3),")"):"rgb(".concat(Math.round(t*255),",").concat(Math.round(n*255),",").concat(Math.round(s*255),")")}offsetHSL(e,t,n){return this.getHSL(ms),this.setHSL(
ms.h+e,ms.s+t,ms.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){
return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){
return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-
this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(
ms),e.getHSL(Ma);let n=hu(ms.h,Ma.h,t),s=hu(ms.s,Ma.s,t),r=hu(ms.l,Ma.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=
e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,
this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=
this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.
iterator](){yield this.r,yield this.g,yield this.b}},Tn=new st;st.NAMES=Jp;var So=class extends An{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=
0,this.backgroundIntensity=1,this.backgroundRotation=new Qi,this.environmentIntensity=1,this.environmentRotation=new Qi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<
"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.
clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,
this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.
copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){
let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=
this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=
this.environmentRotation.toArray(),t}},pi=new q,qi=new q,xu=new q,Yi=new q,_r=new q,xr=new q,Yd=new q,vu=new q,yu=new q,Su=new q,Mu=new Ht,bu=new Ht,wu=new Ht,vs=class i{constructor(e=new q,t=new q,n=new q){
this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),pi.subVectors(e,t),s.cross(pi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(
r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){pi.subVectors(s,t),qi.subVectors(n,t),xu.subVectors(e,t);let o=pi.dot(pi),a=pi.dot(qi),c=pi.dot(xu),l=qi.dot(qi),
u=qi.dot(xu),f=o*l-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(l*c-a*u)*h,x=(o*u-a*c)*h;return r.set(1-d-x,x,d)}static containsPoint(e,t,n,s){return this.
getBarycoord(e,t,n,s,Yi)===null?!1:Yi.x>=0&&Yi.y>=0&&Yi.x+Yi.y<=1}static getInterpolation(e,t,n,s,r,o,a,c){return this.getBarycoord(e,t,n,s,Yi)===null?(c.x=0,c.
y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Yi.x),c.addScaledVector(o,Yi.y),c.addScaledVector(a,Yi.z),c)}static getInterpolatedAttribute(e,t,n,s,r,o){
return Mu.setScalar(0),bu.setScalar(0),wu.setScalar(0),Mu.fromBufferAttribute(e,t),bu.fromBufferAttribute(e,n),wu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(
Mu,r.x),o.addScaledVector(bu,r.y),o.addScaledVector(wu,r.z),o}static isFrontFacing(e,t,n,s){return pi.subVectors(n,t),qi.subVectors(e,t),pi.cross(qi).dot(s)<0}set(e,t,n){
return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){
return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){
return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return pi.subVectors(this.c,this.b),qi.subVectors(this.a,this.b),pi.cross(qi).length()*
.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.
setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(
e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){
return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;_r.subVectors(s,n),xr.subVectors(r,n),vu.subVectors(e,n);let c=_r.
dot(vu),l=xr.dot(vu);if(c<=0&&l<=0)return t.copy(n);yu.subVectors(e,s);let u=_r.dot(yu),f=xr.dot(yu);if(u>=0&&f<=u)return t.copy(s);let h=c*f-u*l;if(h<=0&&c>=0&&
u<=0&&c-u>0)return o=c/(c-u),t.copy(n).addScaledVector(_r,o);Su.subVectors(e,r);let d=_r.dot(Su),x=xr.dot(Su);if(x>=0&&d<=x)return t.copy(r);let S=d*l-c*x;if(S<=
0&&l>=0&&x<=0)return a=l/(l-x),t.copy(n).addScaledVector(xr,a);let p=u*x-d*f;if(p<=0&&f-u>=0&&d-x>=0)return Yd.subVectors(r,s),a=(f-u)/(f-u+(d-x)),t.copy(s).addScaledVector(
Yd,a);let m=1/(p+S+h);return o=S*m,a=h*m,t.copy(n).addScaledVector(_r,o).addScaledVector(xr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(
this.c)}},Li=class{constructor(e=new q(1/0,1/0,1/0),t=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(
t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(mi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();
for(let t=0,n=e.count;t<n;t++)this.expandByPoint(mi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.
expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=mi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){
return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){
return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<
this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(
this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){
return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute(
"position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,mi):mi.fromBufferAttribute(
r,o),mi.applyMatrix4(e.matrixWorld),this.expandByPoint(mi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ba.copy(e.boundingBox)):(n.
boundingBox===null&&n.computeBoundingBox(),ba.copy(n.boundingBox)),ba.applyMatrix4(e.matrixWorld),this.union(ba)}let s=e.children;for(let r=0,o=s.length;r<o;r++)
this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.
z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){
return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.
max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(
e.center,mi),mi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):
(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.
min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){
if(this.isEmpty())return!1;this.getCenter(ao),wa.subVectors(this.max,ao),vr.subVectors(e.a,ao),yr.subVectors(e.b,ao),Sr.subVectors(e.c,ao),gs.subVectors(yr,vr),
_s.subVectors(Sr,yr),Fs.subVectors(vr,Sr);let t=[0,-gs.z,gs.y,0,-_s.z,_s.y,0,-Fs.z,Fs.y,gs.z,0,-gs.x,_s.z,0,-_s.x,Fs.z,0,-Fs.x,-gs.y,gs.x,0,-_s.y,_s.x,0,-Fs.y,Fs.
x,0];return!Tu(t,vr,yr,Sr,wa)||(t=[1,0,0,0,1,0,0,0,1],!Tu(t,vr,yr,Sr,wa))?!1:(Ta.crossVectors(gs,_s),t=[Ta.x,Ta.y,Ta.z],Tu(t,vr,yr,Sr,wa))}clampPoint(e,t){return t.
copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,mi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(
e.center),e.radius=this.getSize(mi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.
min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Zi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Zi[1].set(this.min.
x,this.min.y,this.max.z).applyMatrix4(e),Zi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Zi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),
Zi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Zi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Zi[6].set(this.max.x,this.max.y,this.min.
z).applyMatrix4(e),Zi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Zi),this)}translate(e){return this.min.add(e),this.max.add(e),
this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.
fromArray(e.min),this.max.fromArray(e.max),this}},Zi=[new q,new q,new q,new q,new q,new q,new q,new q],mi=new q,ba=new Li,vr=new q,yr=new q,Sr=new q,gs=new q,_s=new q,
Fs=new q,ao=new q,wa=new q,Ta=new q,Os=new q;function Tu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Os.fromArray(i,r);let a=s.x*Math.abs(Os.x)+s.y*Math.abs(
Os.y)+s.z*Math.abs(Os.z),c=e.dot(Os),l=t.dot(Os),u=n.dot(Os);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var on=new q,Aa=new ft,x_=0,_i=class extends Ii{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a \
Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:x_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/
t:0,this.normalized=n,this.usage=Hp,this.updateRanges=[],this.gpuType=oi,this.version=0,this._normalizationScale=e!==void 0?hh(e):void 0}onUploadCallback(){}set needsUpdate(e){
e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.
length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.
usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<
r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)
Aa.fromBufferAttribute(this,t),Aa.applyMatrix3(e),this.setXY(t,Aa.x,Aa.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)on.fromBufferAttribute(this,
t),on.applyMatrix3(e),this.setXYZ(t,on.x,on.y,on.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)on.fromBufferAttribute(this,t),on.applyMatrix4(
e),this.setXYZ(t,on.x,on.y,on.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)on.fromBufferAttribute(this,t),on.applyNormalMatrix(e),this.setXYZ(
t,on.x,on.y,on.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)on.fromBufferAttribute(this,t),on.transformDirection(e),this.setXYZ(t,on.x,
on.y,on.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(
n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.
normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.
itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){
let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.
itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(
t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.
array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.
array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),
r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.
constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.
normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;
return t!==void 0?Math.max(e/t,-1):o_(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):a_(e,this.array)}};var Mo=class extends _i{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var bo=class extends _i{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var fn=class extends _i{constructor(e,t,n){super(new Float32Array(e),t,n)}},v_=new Li,lo=new q,Au=new q,ji=class{constructor(e=new q,t=-1){this.isSphere=!0,this.
center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):v_.setFromPoints(e).getCenter(
n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),
this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(
this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.
distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){
let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),
t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.
applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.
copy(e),this.radius=0,this;lo.subVectors(e,this.center);let t=lo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(
lo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.
radius,e.radius):(Au.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(lo.copy(e.center).add(Au)),this.expandByPoint(lo.copy(e.center).sub(
Au))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,
center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},y_=0,ii=new bt,Eu=new An,Mr=new q,Yn=new Li,co=new Li,
yn=new q,Kn=class i extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:y_++}),this.uuid=Jo(),this.name="",this.type=
"BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],
this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){
return Array.isArray(e)?this.index=new(i_(e)?bo:Mo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.
indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){
return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.
start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==
void 0){let r=new Qe().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=
!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return ii.
makeRotationFromQuaternion(e),this.applyMatrix4(ii),this}rotateX(e){return ii.makeRotationX(e),this.applyMatrix4(ii),this}rotateY(e){return ii.makeRotationY(e),
this.applyMatrix4(ii),this}rotateZ(e){return ii.makeRotationZ(e),this.applyMatrix4(ii),this}translate(e,t,n){return ii.makeTranslation(e,t,n),this.applyMatrix4(
ii),this}scale(e,t,n){return ii.makeScale(e,t,n),this.applyMatrix4(ii),this}lookAt(e){return Eu.lookAt(e),Eu.updateMatrix(),this.applyMatrix4(Eu.matrix),this}center(){
return this.computeBoundingBox(),this.boundingBox.getCenter(Mr).negate(),this.translate(Mr.x,Mr.y,Mr.z),this}setFromPoints(e){let t=this.getAttribute("position");
if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new fn(n,3))}else{let n=Math.min(e.length,
t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&qe("BufferGeometry: Buffer size too small for points data. Use .dispose() \
and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Li);let e=this.attributes.position,
t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.
boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){
let r=t[n];Yn.setFromBufferAttribute(r),this.morphTargetsRelative?(yn.addVectors(this.boundingBox.min,Yn.min),this.boundingBox.expandByPoint(yn),yn.addVectors(this.
boundingBox.max,Yn.max),this.boundingBox.expandByPoint(yn)):(this.boundingBox.expandByPoint(Yn.min),this.boundingBox.expandByPoint(Yn.max))}}else this.boundingBox.
makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ke('BufferGeometry.computeBoundingBox(): Computed min\
/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ji);
let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requir\
es a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(e){let n=this.boundingSphere.center;if(Yn.setFromBufferAttribute(e),t)for(let r=0,
o=t.length;r<o;r++){let a=t[r];co.setFromBufferAttribute(a),this.morphTargetsRelative?(yn.addVectors(Yn.min,co.min),Yn.expandByPoint(yn),yn.addVectors(Yn.max,co.
max),Yn.expandByPoint(yn)):(Yn.expandByPoint(co.min),Yn.expandByPoint(co.max))}Yn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)yn.fromBufferAttribute(e,r),
s=Math.max(s,n.distanceToSquared(yn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)yn.fromBufferAttribute(
a,l),c&&(Mr.fromBufferAttribute(e,l),yn.add(Mr)),s=Math.max(s,n.distanceToSquared(yn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&
Ke('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.
index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ke("BufferGeometry: .computeTangents() failed. Missing required attr\
ibutes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new _i(new Float32Array(
4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new q,c[O]=new q;let u=new q,f=new q,h=new q,
d=new ft,x=new ft,S=new ft,p=new q,m=new q;function v(O,D,L){l[O]=l[D]=l[L]=1,u.fromBufferAttribute(n,O),f.fromBufferAttribute(n,D),h.fromBufferAttribute(n,L),d.
fromBufferAttribute(r,O),x.fromBufferAttribute(r,D),S.fromBufferAttribute(r,L),f.sub(u),h.sub(u),x.sub(d),S.sub(d);let V=1/(x.x*S.y-S.x*x.y);isFinite(V)&&(p.copy(
f).multiplyScalar(S.y).addScaledVector(h,-x.y).multiplyScalar(V),m.copy(h).multiplyScalar(x.x).addScaledVector(f,-S.x).multiplyScalar(V),a[O].add(p),a[D].add(p),
a[L].add(p),c[O].add(m),c[D].add(m),c[L].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let O=0,D=A.length;O<D;++O){let L=A[O],V=L.start,
H=L.count;for(let N=V,G=V+H;N<G;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let M=new q,P=new q,E=new q,_=new q;function T(O){E.fromBufferAttribute(s,O),_.copy(
E);let D=a[O];M.copy(D),M.sub(E.multiplyScalar(E.dot(D))).normalize(),P.crossVectors(_,D);let V=P.dot(c[O])<0?-1:1;o.setXYZW(O,M.x,M.y,M.z,V)}for(let O=0,D=n.count;O<
D;++O)l[O]&&T(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===
void 0||n.count!==t.count)n=new _i(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let h=0,d=n.count;h<d;h++)n.setXYZ(h,0,0,0);let s=new q,
r=new q,o=new q,a=new q,c=new q,l=new q,u=new q,f=new q;if(e)for(let h=0,d=e.count;h<d;h+=3){let x=e.getX(h+0),S=e.getX(h+1),p=e.getX(h+2);s.fromBufferAttribute(
t,x),r.fromBufferAttribute(t,S),o.fromBufferAttribute(t,p),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(n,x),c.fromBufferAttribute(n,S),
l.fromBufferAttribute(n,p),a.add(u),c.add(u),l.add(u),n.setXYZ(x,a.x,a.y,a.z),n.setXYZ(S,c.x,c.y,c.z),n.setXYZ(p,l.x,l.y,l.z)}else for(let h=0,d=t.count;h<d;h+=
3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),n.setXYZ(h+0,u.x,u.y,u.z),
n.setXYZ(h+1,u.x,u.y,u.z),n.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<
n;t++)yn.fromBufferAttribute(e,t),yn.normalize(),e.setXYZ(t,yn.x,yn.y,yn.z)}toNonIndexed(){function e(a,c){let l=a.array,u=a.itemSize,f=a.normalized,h=new l.constructor(
c.length*u),d=0,x=0;for(let S=0,p=c.length;S<p;S++){a.isInterleavedBufferAttribute?d=c[S]*a.data.stride+a.offset:d=c[S]*u;for(let m=0;m<u;m++)h[x++]=l[d++]}return new _i(
h,u,f)}if(this.index===null)return qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;
for(let a in s){let c=s[a],l=e(c,n);t.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,f=l.length;u<f;u++){let h=l[u],d=e(
h,n);c.push(d)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.
start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=
this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.
parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==
null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let l=n[c];e.data.attributes[c]=
l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let f=0,h=l.length;f<h;f++){let d=l[f];u.push(d.toJSON(
e.data))}u.length>0&&(s[c]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=
JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){
this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;
n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(t))}let r=e.morphAttributes;for(let l in r){let u=[],
f=r[l];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[l]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,
u=o.length;l<u;l++){let f=o[l];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;
return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=
e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Cu=new q,S_=new q,M_=new Qe,gi=class{constructor(e=new q(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.
constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=
-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Cu.subVectors(n,t).cross(S_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,
e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.
constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.
distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(
Cu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&
(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>
0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(
-this.constant)}applyMatrix4(e,t){let n=t||M_.getNormalMatrix(e),s=this.coplanarPoint(Cu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.
constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){
return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),
this.constant=e.constant,this}},b_=0,es=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:b_++}),this.uuid=Jo(),this.
name="",this.type="Material",this.blending=Br,this.side=Ts,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wu,this.blendDst=
Xu,this.blendEquation=Gs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new st(0,0,0),this.blendAlpha=0,this.depthFunc=
Cr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Op,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Wa,this.stencilZFail=
Wa,this.stencilZPass=Wa,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.
precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.
forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){
this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){
if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){qe("Material: parameter '".concat(t,"' has value of undefined."));continue}let s=this[t];if(s===void 0){
qe("Material: '".concat(t,"' is not a property of THREE.").concat(this.type,"."));continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&
n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,
type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=
this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=
this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,
n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=
this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=
this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=
this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=
this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,
n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),
this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.
getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==
void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&
(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&
(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),
this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=
this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&
this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&
(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.
isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.
toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==
void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=
this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&
this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=
this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.
anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.
map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.
toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.
isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,
n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=
this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.
displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.
metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.
toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.
isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.
toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==
void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.
reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=
this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=
this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.
thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=
this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.
clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.
depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),
this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==
void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),
this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==
void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];
for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){
if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&
(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new st().
setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),
e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==
void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=
e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),
e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=
e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),
e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=
e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==
void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==
void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=
e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),
e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.
opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=
e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),
e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new gi().fromJSON(n))),e.clipIntersection!==
void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),
e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.
blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.
blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=
e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&
(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==
void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),
e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.
wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),
e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&
(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),
e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.
dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=
e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==
void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&
(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&
(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.
alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.
normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&
(n=[n,n]),this.normalScale=new ft().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&
(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=
t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),
e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==
void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==
void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=
e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==
void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||
null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&
(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==
void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ft().fromArray(e.clearcoatNormalScale)),
e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),
e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||
null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==
void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.
constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=
e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,
this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,
this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,
this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;
if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=
e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.
polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=
e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,
this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&
this.version++}};var Ji=new q,Ru=new q,Ea=new q,Ca=new q,wo=class{constructor(e=new q,t=new q(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.
copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){
return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ji)),this}closestPointToPoint(e,t){t.subVectors(e,this.
origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.
distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ji.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ji.copy(this.origin).
addScaledVector(this.direction,t),Ji.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Ru.copy(e).add(t).multiplyScalar(.5),Ea.copy(t).sub(e).normalize(),Ca.copy(
this.origin).sub(Ru);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ea),a=Ca.dot(this.direction),c=-Ca.dot(Ea),l=Ca.lengthSq(),u=Math.abs(1-o*o),f,h,d,x;if(u>0)
if(f=o*c-a,h=o*a-c,x=r*u,f>=0)if(h>=-x)if(h<=x){let S=1/u;f*=S,h*=S,d=f*(f+o*h+2*a)+h*(o*f+h+2*c)+l}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*c)+l;else h=-r,
f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*c)+l;else h<=-x?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-c),r),d=-f*f+h*(h+2*c)+l):h<=x?(f=0,h=Math.min(Math.
max(-r,-c),r),d=h*(h+2*c)+l):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-c),r),d=-f*f+h*(h+2*c)+l);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+
2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Ru).addScaledVector(Ea,h),d}intersectSphere(e,t){if(e.radius<0)return null;Ji.subVectors(
e.center,this.origin);let n=Ji.dot(this.direction),s=Ji.dot(Ji)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?
this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.
direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.
distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){
let n,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return l>=0?(n=(e.min.x-h.x)*l,s=(e.max.x-h.x)*l):(n=(e.max.x-h.x)*
l,s=(e.min.x-h.x)*l),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),f>=
0?(a=(e.min.z-h.z)*f,c=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,c=(e.min.z-h.z)*f),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){
return this.intersectBox(e,Ji)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,x=t.x-o.x,
S=t.y-o.y,p=t.z-o.z,m=n.x-o.x,v=n.y-o.y,A=n.z-o.z,M=Math.abs(c),P=Math.abs(l),E=Math.abs(u),_,T,O,D,L,V,H,N,G,J,k,le;if(M>=P&&M>=E?(O=c,V=f,G=x,le=m,c>=0?(_=l,T=
u,D=h,L=d,H=S,N=p,J=v,k=A):(_=u,T=l,D=d,L=h,H=p,N=S,J=A,k=v)):P>=E?(O=l,V=h,G=S,le=v,l>=0?(_=u,T=c,D=d,L=f,H=p,N=x,J=A,k=m):(_=c,T=u,D=f,L=d,H=x,N=p,J=m,k=A)):(O=
u,V=d,G=p,le=A,u>=0?(_=c,T=l,D=f,L=h,H=x,N=S,J=m,k=v):(_=l,T=c,D=h,L=f,H=S,N=x,J=v,k=m)),O===0)return null;let $=_/O,Q=T/O,ie=1/O,he=D-$*V,ue=L-Q*V,j=H-$*G,pe=N-
Q*G,_e=J-$*le,Ae=k-Q*le,Se=_e*pe-Ae*j,Ge=he*Ae-ue*_e,tt=j*ue-pe*he;if(s){if(Se<0||Ge<0||tt<0)return null}else if((Se<0||Ge<0||tt<0)&&(Se>0||Ge>0||tt>0))return null;
let ke=Se+Ge+tt;if(ke===0)return null;let ct=ie*(Se*V+Ge*G+tt*le);return(ke>0?ct<0:ct>0)?null:this.at(ct/ke,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),
this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().
copy(this)}},Dr=class extends es{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new st(16777215),this.map=null,this.
lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qi,
this.combine=Tl,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="r\
ound",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,
this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.
envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=
e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Zd=new bt,Bs=new wo,Ra=new ji,Jd=new q,
Pa=new q,Ia=new q,La=new q,Pu=new q,Da=new q,$d=new q,Na=new q,ri=class extends An{constructor(e=new Kn,t=new Dr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=
e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.
morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.
morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,
this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=
[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){
let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&
a){Da.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],f=r[c];u!==0&&(Pu.fromBufferAttribute(f,e),o?Da.addScaledVector(Pu,u):Da.addScaledVector(Pu.sub(t),u))}
t.add(Da)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===
null&&n.computeBoundingSphere(),Ra.copy(n.boundingSphere),Ra.applyMatrix4(r),Bs.copy(e.ray).recast(e.near),!(Ra.containsPoint(Bs.origin)===!1&&(Bs.intersectSphere(
Ra,Jd)===null||Bs.origin.distanceToSquared(Jd)>(e.far-e.near)**2))&&(Zd.copy(r).invert(),Bs.copy(e.ray).applyMatrix4(Zd),!(n.boundingBox!==null&&Bs.intersectsBox(
n.boundingBox)===!1)&&this._computeIntersections(e,t,Bs)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,
l=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let x=0,S=h.length;x<S;x++){let p=h[x],m=o[p.
materialIndex],v=Math.max(p.start,d.start),A=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let M=v,P=A;M<P;M+=3){let E=a.getX(M),_=a.getX(M+1),
T=a.getX(M+2);s=Ua(this,m,e,n,l,u,f,E,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let x=Math.max(0,d.start),S=Math.
min(a.count,d.start+d.count);for(let p=x,m=S;p<m;p+=3){let v=a.getX(p),A=a.getX(p+1),M=a.getX(p+2);s=Ua(this,o,e,n,l,u,f,v,A,M),s&&(s.faceIndex=Math.floor(p/3),
t.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let x=0,S=h.length;x<S;x++){let p=h[x],m=o[p.materialIndex],v=Math.max(p.start,d.start),A=Math.min(c.count,
Math.min(p.start+p.count,d.start+d.count));for(let M=v,P=A;M<P;M+=3){let E=M,_=M+1,T=M+2;s=Ua(this,m,e,n,l,u,f,E,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=
p.materialIndex,t.push(s))}}else{let x=Math.max(0,d.start),S=Math.min(c.count,d.start+d.count);for(let p=x,m=S;p<m;p+=3){let v=p,A=p+1,M=p+2;s=Ua(this,o,e,n,l,u,
f,v,A,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function w_(i,e,t,n,s,r,o,a){let c;if(e.side===Fn?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(
s,r,o,e.side===Ts,a),c===null)return null;Na.copy(a),Na.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Na);return l<t.near||l>t.far?null:{distance:l,
point:Na.clone(),object:i}}function Ua(i,e,t,n,s,r,o,a,c,l){i.getVertexPosition(a,Pa),i.getVertexPosition(c,Ia),i.getVertexPosition(l,La);let u=w_(i,e,t,n,Pa,Ia,
La,$d);if(u){let f=new q;vs.getBarycoord($d,Pa,Ia,La,f),s&&(u.uv=vs.getInterpolatedAttribute(s,a,c,l,f,new ft)),r&&(u.uv1=vs.getInterpolatedAttribute(r,a,c,l,f,
new ft)),o&&(u.normal=vs.getInterpolatedAttribute(o,a,c,l,f,new q),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:c,c:l,normal:new q,materialIndex:0};
vs.getNormal(Pa,Ia,La,h.normal),u.face=h,u.barycoord=f}return u}var To=class extends On{constructor(e=null,t=1,n=1,s,r,o,a,c,l=Sn,u=Sn,f,h){super(null,o,a,c,l,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:n},
this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ao=class extends _i{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=
e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},br=new bt,Kd=new bt,Fa=[],
Qd=new Li,T_=new bt,uo=new ri,ho=new ji,Nr=class extends ri{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Ao(new Float32Array(n*
16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,T_)}computeBoundingBox(){
let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Li),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<
t;n++)this.getMatrixAt(n,br),Qd.copy(e.boundingBox).applyMatrix4(br),this.boundingBox.union(Qd)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===
null&&(this.boundingSphere=new ji),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,br),
ho.copy(e.boundingSphere).applyMatrix4(br),this.boundingSphere.union(ho)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=
e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==
null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?
t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,
s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(uo.geometry=
this.geometry,uo.material=this.material,uo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ho.copy(this.boundingSphere),ho.applyMatrix4(
n),e.ray.intersectsSphere(ho)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,br),Kd.multiplyMatrices(n,br),uo.matrixWorld=Kd,uo.raycast(e,Fa);for(let o=0,a=Fa.length;o<
a;o++){let c=Fa[o];c.instanceId=r,c.object=this,t.push(c)}Fa.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Ao(new Float32Array(
this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){
let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new To(new Float32Array(s*this.count),s,this.count,Ll,oi));let r=this.morphTexture.
source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*e;return r[c]=a,r.set(n,c+1),this}updateMorphTargets(){}dispose(){
super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.
morphTexture=null)}},zs=new ji,A_=new ft(.5,.5),Oa=new q,ys=class{constructor(e=new gi,t=new gi,n=new gi,s=new gi,r=new gi,o=new gi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){
let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(
e.planes[n]);return this}setFromProjectionMatrix(e,t=si,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],f=r[5],h=r[6],d=r[7],x=r[8],S=r[9],
p=r[10],m=r[11],v=r[12],A=r[13],M=r[14],P=r[15];if(s[0].setComponents(l-o,d-u,m-x,P-v).normalize(),s[1].setComponents(l+o,d+u,m+x,P+v).normalize(),s[2].setComponents(
l+a,d+f,m+S,P+A).normalize(),s[3].setComponents(l-a,d-f,m-S,P-A).normalize(),n)s[4].setComponents(c,h,p,M).normalize(),s[5].setComponents(l-c,d-h,m-p,P-M).normalize();else if(s[4].
setComponents(l-c,d-h,m-p,P-M).normalize(),t===si)s[5].setComponents(l+c,d+h,m+p,P+M).normalize();else if(t===Rr)s[5].setComponents(c,h,p,M).normalize();else throw new Error(
"THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&
e.computeBoundingSphere(),zs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),zs.copy(
t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(zs)}intersectsSprite(e){zs.center.set(0,0,0);let t=A_.distanceTo(e.center);return zs.
radius=.7071067811865476+t,zs.applyMatrix4(e.matrixWorld),this.intersectsSphere(zs)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)
if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Oa.x=s.normal.x>0?e.max.x:e.min.x,Oa.y=s.normal.
y>0?e.max.y:e.min.y,Oa.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Oa)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(
e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},jd=new bt,rl=class i{constructor(){this.coordinateSystem=si,this._frustums=[],this._count=
0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];jd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===
void 0&&(n[s]=new ys),n[s].setFromProjectionMatrix(jd,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){
let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)
if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){
let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)
if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===
void 0&&(t[s]=new ys),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var ts=class extends es{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new st(16777215),this.map=null,this.linewidth=
1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.
linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},ol=new q,al=new q,ep=new bt,fo=new wo,Ba=new ji,Iu=new q,tp=new q,ll=class extends An{constructor(e=new Kn,t=new ts){
super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){
return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==
void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.
slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.
count;s<r;s++)ol.fromBufferAttribute(t,s-1),al.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=ol.distanceTo(al);e.setAttribute("lineDistance",new fn(n,1))}else qe("\
Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){
let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ba.copy(n.boundingSphere),Ba.
applyMatrix4(s),Ba.radius+=r,e.ray.intersectsSphere(Ba)===!1)return;ep.copy(s).invert(),fo.copy(e.ray).applyMatrix4(ep);let a=r/((this.scale.x+this.scale.y+this.
scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=n.index,h=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),x=Math.min(u.count,o.start+o.count);for(let S=d,
p=x-1;S<p;S+=l){let m=u.getX(S),v=u.getX(S+1),A=za(this,e,fo,c,m,v,S);A&&t.push(A)}if(this.isLineLoop){let S=u.getX(x-1),p=u.getX(d),m=za(this,e,fo,c,S,p,x-1);m&&
t.push(m)}}else{let d=Math.max(0,o.start),x=Math.min(h.count,o.start+o.count);for(let S=d,p=x-1;S<p;S+=l){let m=za(this,e,fo,c,S,S+1,S);m&&t.push(m)}if(this.isLineLoop){
let S=za(this,e,fo,c,x-1,d,x-1);S&&t.push(S)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){
this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=
r}}}}};function za(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(ol.fromBufferAttribute(a,s),al.fromBufferAttribute(a,r),t.distanceSqToSegment(ol,al,Iu,
tp)>n)return;Iu.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(Iu);if(!(l<e.near||l>e.far))return{distance:l,point:tp.clone().applyMatrix4(i.matrixWorld),
index:o,face:null,faceIndex:null,barycoord:null,object:i}}var np=new q,ip=new q,Ur=class extends ll{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type=
"LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)np.fromBufferAttribute(
t,s),ip.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+np.distanceTo(ip);e.setAttribute("lineDistance",new fn(n,1))}else qe("LineSegments.computeLin\
eDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Eo=class extends On{constructor(e=[],t=Hs,n,s,r,o,a,c,l,u){super(e,t,n,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){
this.image=e}};var ns=class extends On{constructor(e,t,n=xi,s,r,o,a=Sn,c=Sn,l,u=Ki,f=1){if(u!==Ki&&u!==ss)throw new Error("THREE.DepthTexture: format must be either THREE.Dept\
hFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,c,u,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.
compareFunction=null}copy(e){return super.copy(e),this.source=new Ir(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.
toJSON(e);return t.compareFunction=this.compareFunction,t}},Co=class extends ns{constructor(e,t=xi,n=Hs,s,r,o=Sn,a=Sn,c,l=Ki){let u={width:e,height:e,depth:1},f=[
u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},
Ro=class extends On{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},
Ss=class i extends Kn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,
depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],f=[],h=0,d=0;x("z","y","x",-1,-1,n,t,e,o,r,0),x("z","y","x",1,-1,
n,t,-e,o,r,1),x("x","z","y",1,1,e,n,t,s,o,2),x("x","z","y",1,-1,e,n,-t,s,o,3),x("x","y","z",1,-1,e,t,n,s,r,4),x("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(c),
this.setAttribute("position",new fn(l,3)),this.setAttribute("normal",new fn(u,3)),this.setAttribute("uv",new fn(f,2));function x(S,p,m,v,A,M,P,E,_,T,O){let D=M/
_,L=P/T,V=M/2,H=P/2,N=E/2,G=_+1,J=T+1,k=0,le=0,$=new q;for(let Q=0;Q<J;Q++){let ie=Q*L-H;for(let he=0;he<G;he++){let ue=he*D-V;$[S]=ue*v,$[p]=ie*A,$[m]=N,l.push(
$.x,$.y,$.z),$[S]=0,$[p]=0,$[m]=E>0?1:-1,u.push($.x,$.y,$.z),f.push(he/_),f.push(1-Q/T),k+=1}}for(let Q=0;Q<T;Q++)for(let ie=0;ie<_;ie++){let he=h+ie+G*Q,ue=h+ie+
G*(Q+1),j=h+(ie+1)+G*(Q+1),pe=h+(ie+1)+G*Q;c.push(he,ue,pe),c.push(ue,j,pe),le+=6}a.addGroup(d,le,O),d+=le,h+=k}}copy(e){return super.copy(e),this.parameters=Object.
assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var cl=class i extends Kn{constructor(e=[],t=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:s};let r=[],
o=[];a(s),l(n),u(),this.setAttribute("position",new fn(r,3)),this.setAttribute("normal",new fn(r.slice(),3)),this.setAttribute("uv",new fn(o,2)),s===0?this.computeVertexNormals():
this.normalizeNormals();function a(v){let A=new q,M=new q,P=new q;for(let E=0;E<t.length;E+=3)d(t[E+0],A),d(t[E+1],M),d(t[E+2],P),c(A,M,P,v)}function c(v,A,M,P){
let E=P+1,_=[];for(let T=0;T<=E;T++){_[T]=[];let O=v.clone().lerp(M,T/E),D=A.clone().lerp(M,T/E),L=E-T;for(let V=0;V<=L;V++)V===0&&T===E?_[T][V]=O:_[T][V]=O.clone().
lerp(D,V/L)}for(let T=0;T<E;T++)for(let O=0;O<2*(E-T)-1;O++){let D=Math.floor(O/2);O%2===0?(h(_[T][D+1]),h(_[T+1][D]),h(_[T][D])):(h(_[T][D+1]),h(_[T+1][D+1]),h(
_[T+1][D]))}}function l(v){let A=new q;for(let M=0;M<r.length;M+=3)A.x=r[M+0],A.y=r[M+1],A.z=r[M+2],A.normalize().multiplyScalar(v),r[M+0]=A.x,r[M+1]=A.y,r[M+2]=
A.z}function u(){let v=new q;for(let A=0;A<r.length;A+=3){v.x=r[A+0],v.y=r[A+1],v.z=r[A+2];let M=p(v)/2/Math.PI+.5,P=m(v)/Math.PI+.5;o.push(M,1-P)}x(),f()}function f(){
for(let v=0;v<o.length;v+=6){let A=o[v+0],M=o[v+2],P=o[v+4],E=Math.max(A,M,P),_=Math.min(A,M,P);E>.9&&_<.1&&(A<.2&&(o[v+0]+=1),M<.2&&(o[v+2]+=1),P<.2&&(o[v+4]+=
1))}}function h(v){r.push(v.x,v.y,v.z)}function d(v,A){let M=v*3;A.x=e[M+0],A.y=e[M+1],A.z=e[M+2]}function x(){let v=new q,A=new q,M=new q,P=new q,E=new ft,_=new ft,
T=new ft;for(let O=0,D=0;O<r.length;O+=9,D+=6){v.set(r[O+0],r[O+1],r[O+2]),A.set(r[O+3],r[O+4],r[O+5]),M.set(r[O+6],r[O+7],r[O+8]),E.set(o[D+0],o[D+1]),_.set(o[D+
2],o[D+3]),T.set(o[D+4],o[D+5]),P.copy(v).add(A).add(M).divideScalar(3);let L=p(P);S(E,D+0,v,L),S(_,D+2,A,L),S(T,D+4,M,L)}}function S(v,A,M,P){P<0&&v.x===1&&(o[A]=
v.x-1),M.x===0&&M.z===0&&(o[A]=P/2/Math.PI+.5)}function p(v){return Math.atan2(v.z,-v.x)}function m(v){return Math.atan2(-v.y,Math.sqrt(v.x*v.x+v.z*v.z))}}copy(e){
return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.vertices,e.indices,e.radius,e.detail)}};var Po=class i extends cl{constructor(e=1,t=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,e,t),
this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}},Io=class i extends Kn{constructor(e=1,t=1,n=1,s=1){
super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),c=Math.floor(s),l=a+1,u=c+
1,f=e/a,h=t/c,d=[],x=[],S=[],p=[];for(let m=0;m<u;m++){let v=m*h-o;for(let A=0;A<l;A++){let M=A*f-r;x.push(M,-v,0),S.push(0,0,1),p.push(A/a),p.push(1-m/c)}}for(let m=0;m<
c;m++)for(let v=0;v<a;v++){let A=v+l*m,M=v+l*(m+1),P=v+1+l*(m+1),E=v+1+l*m;d.push(A,M,E),d.push(M,P,E)}this.setIndex(d),this.setAttribute("position",new fn(x,3)),
this.setAttribute("normal",new fn(S,3)),this.setAttribute("uv",new fn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){
return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function Xs(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(sp(s))s.isRenderTargetTexture?(qe("UniformsUtils: Textures of render targets\
 cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(sp(s[0])){let r=[];for(let o=0,a=s.length;o<
a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function En(i){let e={};for(let t=0;t<i.length;t++){let n=Xs(i[t]);for(let s in n)
e[s]=n[s]}return e}function sp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function E_(i){
let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function fh(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===
!0?e.texture.colorSpace:gt.workingColorSpace}var $p={clone:Xs,merge:En},C_="void main() {\n gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.\
0 );\n}",R_="void main() {\n gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );\n}",Di=class extends es{constructor(e){super(),this.isShaderMaterial=!0,this.type="Shade\
rMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=C_,this.fragmentShader=R_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=
1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,
1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(
e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Xs(e.uniforms),this.uniformsGroups=E_(e.uniformsGroups),this.defines=Object.
assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=
Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.
index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.
uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&
o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.
toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.
keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.
clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(
e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"\
c":this.uniforms[n].value=new st().setHex(s.value);break;case"v2":this.uniforms[n].value=new ft().fromArray(s.value);break;case"v3":this.uniforms[n].value=new q().
fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ht().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Qe().fromArray(s.value);break;case"\
m4":this.uniforms[n].value=new bt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==
void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),
e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=
e.clipping),this}},ul=class extends Di{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Lo=class extends es{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new st(16777215),this.map=null,this.lightMap=
null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new st(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.
bumpScale=1,this.normalMap=null,this.normalMapType=fc,this.normalScale=new ft(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.
specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qi,this.combine=Tl,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=
.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){
return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=
e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=
e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=
e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(
e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=
e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.
flatShading,this.fog=e.fog,this}},hl=class extends es{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Up,this.
map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(
e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=
e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},fl=class extends es{constructor(e){
super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.
displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=
e.displacementScale,this.displacementBias=e.displacementBias,this}};var Do=class extends ts{constructor(e){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(
e)}copy(e){return super.copy(e),this.scale=e.scale,this.dashSize=e.dashSize,this.gapSize=e.gapSize,this}};function wr(i,e){return!i||i.constructor===e?i:typeof e.
BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function ka(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ms=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=
n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+
2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}
if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=t[--n-1],e>=r)break e}
o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)
return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){
return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+
o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},dl=class extends Ms{constructor(e,t,n,s){super(e,
t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Nu,endingEnd:Nu}}intervalChanged_(e,t,n){
let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Uu:r=e,a=2*t-n;break;case Fu:r=s.length-2,a=t+
s[r]-s[r+1];break;default:r=e,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Uu:o=e,c=2*n-t;break;case Fu:o=1,c=n+s[1]-s[0];break;default:o=e-1,c=
t}let l=(n-t)*.5,u=this.valueSize;this._weightPrev=l/(t-a),this._weightNext=l/(c-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,
o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,x=(n-t)/(s-t),S=x*x,p=S*x,m=-h*p+2*
h*S-h*x,v=(1+h)*p+(-1.5-2*h)*S+(-.5+h)*x+1,A=(-1-d)*p+(1.5+d)*S+.5*x,M=d*p-d*S;for(let P=0;P!==a;++P)r[P]=m*o[u+P]+v*o[l+P]+A*o[c+P]+M*o[f+P];return r}},pl=class extends Ms{constructor(e,t,n,s){
super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=(n-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[l+
h]*f+o[c+h]*u;return r}},ml=class extends Ms{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},gl=class extends Ms{interpolate_(e,t,n,s){
let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let x=(n-t)/(s-t),S=1-x;for(let p=0;p!==
a;++p)r[p]=o[l+p]*S+o[c+p]*x;return r}let h=a*2,d=e-1;for(let x=0;x!==a;++x){let S=o[l+x],p=o[c+x],m=d*h+x*2,v=f[m],A=f[m+1],M=e*h+x*2,P=u[M],E=u[M+1],_=I_(n,t,
v,P,s);r[x]=Kp(_,S,A,E,p)}return r}};function Kp(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function P_(i,e,t,n,s){let r=1-i;return 3*r*r*(t-
e)+6*r*i*(n-t)+3*i*i*(s-n)}function I_(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=Kp(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let c=P_(r,e,t,n,s);if(Math.
abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var Qn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is \
undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=wr(t,this.TimeBufferType),
this.values=wr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.
toJSON(e);else{n={name:e.name,times:wr(e.times,Array),values:wr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),ka(e.
settings)&&(n.settings={inTangents:wr(e.settings.inTangents,Array),outTangents:wr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){
return new ml(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new pl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){
return new dl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new gl(this.times,this.values,this.getValueSize(),e);return this.
settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case mo:t=this.InterpolantFactoryMethodDiscrete;
break;case el:t=this.InterpolantFactoryMethodLinear;break;case Ha:t=this.InterpolantFactoryMethodSmooth;break;case Du:t=this.InterpolantFactoryMethodBezier;break}
if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)
this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){
switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return mo;case this.InterpolantFactoryMethodLinear:return el;case this.InterpolantFactoryMethodSmooth:
return Ha;case this.InterpolantFactoryMethodBezier:return Du}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,
s=t.length;n!==s;++n)t[n]+=e;ka(this.settings)&&(rp(this.settings.inTangents,e),rp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;
for(let n=0,s=t.length;n!==s;++n)t[n]*=e;ka(this.settings)&&(op(this.settings.inTangents,e),op(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,
s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.
slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ke("KeyframeTrack: Invalid value s\
ize in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ke("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];
if(typeof c=="number"&&isNaN(c)){Ke("KeyframeTrack: Time is not a valid number.",this,a,c),e=!1;break}if(o!==null&&o>c){Ke("KeyframeTrack: Out of order keys.",this,
a,c,o),e=!1;break}o=c}if(s!==void 0&&s_(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){Ke("KeyframeTrack: Value is not a valid number.",this,a,l),
e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Ha,r=e.length-1,o=1;for(let a=1;a<
r;++a){let c=!1,l=e[a],u=e[a+1];if(l!==u&&(a!==1||l!==e[0]))if(s)c=!0;else{let f=a*n,h=f-n,d=f+n;for(let x=0;x!==n;++x){let S=t[f+x];if(S!==t[h+x]||S!==t[d+x]){
c=!0;break}}}if(c){if(a!==o){e[o]=e[a];let f=a*n,h=o*n;for(let d=0;d!==n;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)t[c+l]=t[a+l];
++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),
n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,ka(this.settings)&&(s.settings={inTangents:this.settings.inTangents.
slice(),outTangents:this.settings.outTangents.slice()}),s}};function rp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function op(i,e){for(let t=0,n=i.length;t!==
n;t+=2)i[t]*=e}Qn.prototype.ValueTypeName="";Qn.prototype.TimeBufferType=Float32Array;Qn.prototype.ValueBufferType=Float32Array;Qn.prototype.DefaultInterpolation=
el;var bs=class extends Qn{constructor(e,t,n){super(e,t,n)}};bs.prototype.ValueTypeName="bool";bs.prototype.ValueBufferType=Array;bs.prototype.DefaultInterpolation=
mo;bs.prototype.InterpolantFactoryMethodLinear=void 0;bs.prototype.InterpolantFactoryMethodSmooth=void 0;var _l=class extends Qn{constructor(e,t,n,s){super(e,t,
n,s)}};_l.prototype.ValueTypeName="color";var xl=class extends Qn{constructor(e,t,n,s){super(e,t,n,s)}};xl.prototype.ValueTypeName="number";var vl=class extends Ms{constructor(e,t,n,s){
super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-t)/(s-t),l=e*a;for(let u=l+a;l!==u;l+=4)Jn.slerpFlat(r,0,
o,l-a,o,l,c);return r}},No=class extends Qn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new vl(this.times,this.values,this.getValueSize(),
e)}};No.prototype.ValueTypeName="quaternion";No.prototype.InterpolantFactoryMethodSmooth=void 0;var ws=class extends Qn{constructor(e,t,n){super(e,t,n)}};ws.prototype.
ValueTypeName="string";ws.prototype.ValueBufferType=Array;ws.prototype.DefaultInterpolation=mo;ws.prototype.InterpolantFactoryMethodLinear=void 0;ws.prototype.InterpolantFactoryMethodSmooth=
void 0;var yl=class extends Qn{constructor(e,t,n,s){super(e,t,n,s)}};yl.prototype.ValueTypeName="vector";var Sl=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.
itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,
s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.
setURLModifier=function(u){return c=u,this},this.addHandler=function(u,f){return l.push(u,f),this},this.removeHandler=function(u){let f=l.indexOf(u);return f!==
-1&&l.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=l.length;f<h;f+=2){let d=l[f],x=l[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return x}return null},
this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=
new AbortController),this._abortController}},Qp=new Sl,Ml=class{constructor(e){this.manager=e!==void 0?e:Qp,this.crossOrigin="anonymous",this.withCredentials=!1,
this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(
new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.
crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){
return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Ml.DEFAULT_MATERIAL_NAME=
"__DEFAULT";var Uo=class extends An{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new st(e),this.
intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.
color.getHex(),t.object.intensity=this.intensity,t}};var Lu=new bt,ap=new q,lp=new q,bl=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=
8,this.mapSize=new ft(512,512),this.mapType=Bn,this.map=null,this.mapPass=null,this.matrix=new bt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ys,this.
_frameExtents=new ft(1,1),this._viewportCount=1,this._viewports=[new Ht(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){
return this._frustum}updateMatrices(e){let t=this.camera;ap.setFromMatrixPosition(e.matrixWorld),t.position.copy(ap),lp.setFromMatrixPosition(e.target.matrixWorld),
t.lookAt(lp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Lu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),
n.setFromProjectionMatrix(Lu,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;e.coordinateSystem===
Rr||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(Lu)}getViewport(e){
return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.
camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=
e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().
copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,
e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Va=new q,Ga=new Jn,Ri=new q,Fo=class extends An{constructor(){
super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new bt,this.projectionMatrix=new bt,this.projectionMatrixInverse=new bt,this.coordinateSystem=
si,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.
projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){
return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Va,Ga,Ri),Ri.x===1&&Ri.y===1&&Ri.z===1?this.
matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Va,Ga,Ri.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(
e,t,n),this.matrixWorld.decompose(Va,Ga,Ri),Ri.x===1&&Ri.y===1&&Ri.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(
Va,Ga,Ri.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},xs=new q,cp=new ft,up=new ft,Nn=class extends Fo{constructor(e=50,t=1,n=.1,s=2e3){
super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.
filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.
focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){
let t=.5*this.getFilmHeight()/e;this.fov=tl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(uu*.5*this.fov);return .5*this.getFilmHeight()/
e}getEffectiveFOV(){return tl*2*Math.atan(Math.tan(uu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.
filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){xs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(xs.x,xs.y).multiplyScalar(-e/xs.z),xs.set(
1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(xs.x,xs.y).multiplyScalar(-e/xs.z)}getViewSize(e,t){return this.getViewBounds(e,cp,up),t.subVectors(up,
cp)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.
enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){
this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(uu*.5*this.fov)/this.zoom,n=2*t,s=this.
aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,t-=o.offsetY*n/l,s*=o.width/c,n*=o.height/
l}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),
this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.
near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.
filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Oo=class extends Fo{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,
this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=
e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){
this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=
t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=
!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.
left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.
top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.
makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){
let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.
near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ou=class extends bl{constructor(){super(new Oo(-5,5,5,-5,
.5,500)),this.isDirectionalLightShadow=!0}},Bo=class extends Uo{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.
copy(An.DEFAULT_UP),this.updateMatrix(),this.target=new An,this.shadow=new Ou}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.
target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.
uuid,t}},zo=class extends Uo{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var Tr=-90,Ar=1,Fr=class extends An{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Nn(
Tr,Ar,e,t);s.layers=this.layers,this.add(s);let r=new Nn(Tr,Ar,e,t);r.layers=this.layers,this.add(r);let o=new Nn(Tr,Ar,e,t);o.layers=this.layers,this.add(o);let a=new Nn(
Tr,Ar,e,t);a.layers=this.layers,this.add(a);let c=new Nn(Tr,Ar,e,t);c.layers=this.layers,this.add(c);let l=new Nn(Tr,Ar,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){
let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,c]=t;for(let l of t)this.remove(l);if(e===si)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(
-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Rr)n.up.set(
0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.
set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){
this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,
this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),x=e.xr.enabled;e.xr.enabled=
!1;let S=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,
e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(
n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,4,s),p&&
e.autoClear===!1&&e.clearDepth(),e.render(t,l),n.texture.mipmapsAutoUpdate=S,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(
f,h,d),e.xr.enabled=x,n.texture.needsPMREMUpdate=!0}},wl=class extends Nn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=
e,this.perCameraFrustumCulled=!1}};var dh="\\[\\]\\.:\\/",L_=new RegExp("["+dh+"]","g"),ph="[^"+dh+"]",D_="[^"+dh.replace("\\.","")+"]",N_=/((?:WC+[\/:])*)/.source.replace("WC",ph),U_=/(WCOD+)?/.
source.replace("WCOD",D_),F_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",ph),O_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",ph),B_=new RegExp("^"+N_+U_+F_+O_+
"$"),z_=["material","materials","bones","map"],Bu=class{constructor(e,t,n){let s=n||kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){
this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.
nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){
let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},kt=class i{constructor(e,t,n){this.path=t,this.parsedPath=
n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){
return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(L_,"")}static parseTrackName(e){
let t=B_.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],
propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);z_.indexOf(r)!==-1&&(n.nodeName=n.nodeName.
substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from track\
Name: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);
if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let c=n(a.children);if(c)return c}
return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){
let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){
this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=
e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=
!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;
for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,
r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){
this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.
propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){
this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.
targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.
node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,
this.setValue=this._setValue_unavailable,!e){qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=t.objectIndex;switch(n){case"\
materials":if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ke("PropertyB\
inding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){
Ke("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===l){l=u;break}
break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.
material.map){Ke("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){
Ke("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(l!==void 0){if(e[l]===void 0){Ke("PropertyBinding: Trying to bind to \
objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let o=e[s];if(o===void 0){let l=t.nodeName;Ke("PropertyBinding: Trying to update property f\
or track: "+l+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===
!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ke("PropertyBinding:\
 Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ke("PropertyBinding: Can not bind to\
 morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}
c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.
resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.
setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};kt.Composite=
Bu;kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};kt.
prototype.GetterByBindingType=[kt.prototype._getValue_direct,kt.prototype._getValue_array,kt.prototype._getValue_arrayElement,kt.prototype._getValue_toArray];kt.
prototype.SetterByBindingTypeAndVersioning=[[kt.prototype._setValue_direct,kt.prototype._setValue_direct_setNeedsUpdate,kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],
[kt.prototype._setValue_array,kt.prototype._setValue_array_setNeedsUpdate,kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_arrayElement,
kt.prototype._setValue_arrayElement_setNeedsUpdate,kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_fromArray,kt.prototype.
_setValue_fromArray_setNeedsUpdate,kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var KM=new Float32Array(1);var zu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){
for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var ko=class extends Ur{constructor(e=10,t=10,n=4473924,s=8947848){n=new st(n),s=new st(s);let r=t/2,o=e/t,a=e/2,c=[],l=[];for(let h=0,d=0,x=-a;h<=t;h++,x+=o){c.
push(-a,0,x,a,0,x),c.push(x,0,-a,x,0,a);let S=h===r?n:s;S.toArray(l,d),d+=3,S.toArray(l,d),d+=3,S.toArray(l,d),d+=3,S.toArray(l,d),d+=3}let u=new Kn;u.setAttribute(
"position",new fn(c,3)),u.setAttribute("color",new fn(l,3));let f=new ts({vertexColors:!0,toneMapped:!1});super(u,f),this.type="GridHelper"}dispose(){super.dispose(),
this.geometry.dispose(),this.material.dispose()}};function mh(i,e,t,n){let s=k_(n);switch(t){case sh:return i*e;case Ll:return i*e/s.components*s.byteLength;case Dl:return i*e/s.components*s.byteLength;case As:
return i*e*2/s.components*s.byteLength;case Nl:return i*e*2/s.components*s.byteLength;case rh:return i*e*3/s.components*s.byteLength;case yi:return i*e*4/s.components*
s.byteLength;case Ul:return i*e*4/s.components*s.byteLength;case Ho:case Wo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Xo:case qo:return Math.floor((i+
3)/4)*Math.floor((e+3)/4)*16;case Ol:case zl:return Math.max(i,16)*Math.max(e,8)/4;case Fl:case Bl:return Math.max(i,8)*Math.max(e,8)/2;case kl:case Vl:case Hl:case Wl:
return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Gl:case Yo:case Xl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ql:return Math.floor((i+3)/4)*Math.
floor((e+3)/4)*16;case Yl:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Zl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Jl:return Math.floor(
(i+5)/6)*Math.floor((e+4)/5)*16;case $l:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Kl:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Ql:return Math.
floor((i+7)/8)*Math.floor((e+5)/6)*16;case jl:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ec:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case tc:
return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case nc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case ic:return Math.floor((i+9)/10)*Math.floor((e+
9)/10)*16;case sc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case rc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case oc:case ac:case lc:return Math.
ceil(i/4)*Math.ceil(e/4)*16;case cc:case uc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Zo:case hc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error("Unab\
le to determine texture byte length for ".concat(t," format."))}function k_(i){switch(i){case Bn:case eh:return{byteLength:1,components:1};case kr:case th:case vi:
return{byteLength:2,components:1};case Pl:case Il:return{byteLength:2,components:4};case xi:case Rl:case oi:return{byteLength:4,components:1};case nh:case ih:return{
byteLength:4,components:3}}throw new Error("THREE.TextureUtils: Unknown texture type ".concat(i,"."))}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qe("\
WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function ym(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(
s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function G_(i){let e=new WeakMap;
function t(a,c){let l=a.array,u=a.usage,f=l.byteLength,h=i.createBuffer();i.bindBuffer(c,h),i.bufferData(c,l,u),a.onUploadCallback();let d;if(l instanceof Float32Array)
d=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)d=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=
i.UNSIGNED_SHORT;else if(l instanceof Int16Array)d=i.SHORT;else if(l instanceof Uint32Array)d=i.UNSIGNED_INT;else if(l instanceof Int32Array)d=i.INT;else if(l instanceof
Int8Array)d=i.BYTE;else if(l instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLA\
ttributes: Unsupported buffer data format: "+l);return{buffer:h,type:d,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:f}}function n(a,c,l){let u=c.array,
f=c.updateRanges;if(i.bindBuffer(l,a),f.length===0)i.bufferSubData(l,0,u);else{f.sort((d,x)=>d.start-x.start);let h=0;for(let d=1;d<f.length;d++){let x=f[h],S=f[d];
S.start<=x.start+x.count+1?x.count=Math.max(x.count,S.start+S.count-x.start):(++h,f[h]=S)}f.length=h+1;for(let d=0,x=f.length;d<x;d++){let S=f[d];i.bufferSubData(
l,S.start*u.BYTES_PER_ELEMENT,u,S.start,S.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(
a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(i.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&
(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});
return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size\
 of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{
get:s,remove:r,update:o}}var H_="#ifdef USE_ALPHAHASH\n if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;\n#endif",W_="#ifdef USE_ALPHAHASH\n c\
onst float ALPHA_HASH_SCALE = 0.05;\n float hash2D( vec2 value ) {\n  return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value\
.y + value.x ) ) ) );\n }\n float hash3D( vec3 value ) {\n  return hash2D( vec2( hash2D( value.xy ), value.z ) );\n }\n float getAlphaHashThreshold( vec3 position ) \
{\n  float maxDeriv = max(\n   length( dFdx( position.xyz ) ),\n   length( dFdy( position.xyz ) )\n  );\n  float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );\n  \
vec2 pixScales = vec2(\n   exp2( floor( log2( pixScale ) ) ),\n   exp2( ceil( log2( pixScale ) ) )\n  );\n  vec2 alpha = vec2(\n   hash3D( floor( pixScales.x * posit\
ion.xyz ) ),\n   hash3D( floor( pixScales.y * position.xyz ) )\n  );\n  float lerpFactor = fract( log2( pixScale ) );\n  float x = ( 1.0 - lerpFactor ) * alpha.x + \
lerpFactor * alpha.y;\n  float a = min( lerpFactor, 1.0 - lerpFactor );\n  vec3 cases = vec3(\n   x * x / ( 2.0 * a * ( 1.0 - a ) ),\n   ( x - 0.5 * a ) / ( 1.0 - a\
 ),\n   1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )\n  );\n  float threshold = ( x < ( 1.0 - a ) )\n   ? ( ( x < a ) ? cases.x : cases.y )\n   : \
cases.z;\n  return clamp( threshold , 1.0e-6, 1.0 );\n }\n#endif",X_="#ifdef USE_ALPHAMAP\n diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;\n#endif",q_="\
#ifdef USE_ALPHAMAP\n uniform sampler2D alphaMap;\n#endif",Y_="#ifdef USE_ALPHATEST\n #ifdef ALPHA_TO_COVERAGE\n diffuseColor.a = smoothstep( alphaTest, alphaTest\
 + fwidth( diffuseColor.a ), diffuseColor.a );\n if ( diffuseColor.a == 0.0 ) discard;\n #else\n if ( diffuseColor.a < alphaTest ) discard;\n #endif\n#endif",Z_="\
#ifdef USE_ALPHATEST\n uniform float alphaTest;\n#endif",J_="#ifdef USE_AOMAP\n float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensit\
y + 1.0;\n reflectedLight.indirectDiffuse *= ambientOcclusion;\n #if defined( USE_CLEARCOAT ) \n  clearcoatSpecularIndirect *= ambientOcclusion;\n #endif\n #if defin\
ed( USE_SHEEN ) \n  sheenSpecularIndirect *= ambientOcclusion;\n #endif\n #if defined( USE_ENVMAP ) && defined( STANDARD )\n  float dotNV = saturate( dot( geometryN\
ormal, geometryViewDir ) );\n  reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );\n #endif\n#endif",$_="\
#ifdef USE_AOMAP\n uniform sampler2D aoMap;\n uniform float aoMapIntensity;\n#endif",K_="#ifdef USE_BATCHING\n #if ! defined( GL_ANGLE_multi_draw )\n #define gl_D\
rawID _gl_DrawID\n uniform int _gl_DrawID;\n #endif\n uniform highp sampler2D batchingTexture;\n uniform highp usampler2D batchingIdTexture;\n mat4 getBatchingMatrix\
( const in float i ) {\n  int size = textureSize( batchingTexture, 0 ).x;\n  int j = int( i ) * 4;\n  int x = j % size;\n  int y = j / size;\n  vec4 v1 = texelFetch(\
 batchingTexture, ivec2( x, y ), 0 );\n  vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );\n  vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y \
), 0 );\n  vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );\n  return mat4( v1, v2, v3, v4 );\n }\n float getIndirectIndex( const in int i ) {\n  int s\
ize = textureSize( batchingIdTexture, 0 ).x;\n  int x = i % size;\n  int y = i / size;\n  return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );\n }\n#\
endif\n#ifdef USE_BATCHING_COLOR\n uniform sampler2D batchingColorTexture;\n vec4 getBatchingColor( const in float i ) {\n  int size = textureSize( batchingColorTex\
ture, 0 ).x;\n  int j = int( i );\n  int x = j % size;\n  int y = j / size;\n  return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );\n }\n#endif",Q_="#if\
def USE_BATCHING\n mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );\n#endif",j_="vec3 transformed = vec3( position );\n#ifdef USE_ALPHAH\
ASH\n vPosition = vec3( position );\n#endif",ex="vec3 objectNormal = vec3( normal );\n#ifdef USE_TANGENT\n vec3 objectTangent = vec3( tangent.xyz );\n#endif",tx="\
float G_BlinnPhong_Implicit( ) {\n return 0.25;\n}\nfloat D_BlinnPhong( const in float shininess, const in float dotNH ) {\n return RECIPROCAL_PI * ( shininess * 0.\
5 + 1.0 ) * pow( dotNH, shininess );\n}\nvec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, c\
onst in float shininess ) {\n vec3 halfDir = normalize( lightDir + viewDir );\n float dotNH = saturate( dot( normal, halfDir ) );\n float dotVH = saturate( dot( vi\
ewDir, halfDir ) );\n vec3 F = F_Schlick( specularColor, 1.0, dotVH );\n float G = G_BlinnPhong_Implicit( );\n float D = D_BlinnPhong( shininess, dotNH );\n return \
F * ( G * D );\n} // validated",nx="#ifdef USE_IRIDESCENCE\n const mat3 XYZ_TO_REC709 = mat3(\n   3.2404542, -0.9692660,  0.0556434,\n  -1.5371385,  1.8760108, -0.\
2040259,\n  -0.4985314,  0.0415560,  1.0572252\n );\n vec3 Fresnel0ToIor( vec3 fresnel0 ) {\n  vec3 sqrtF0 = sqrt( fresnel0 );\n  return ( vec3( 1.0 ) + sqrtF0 ) / (\
 vec3( 1.0 ) - sqrtF0 );\n }\n vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {\n  return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmit\
tedIor + vec3( incidentIor ) ) );\n }\n float IorToFresnel0( float transmittedIor, float incidentIor ) {\n  return pow2( ( transmittedIor - incidentIor ) / ( trans\
mittedIor + incidentIor ));\n }\n vec3 evalSensitivity( float OPD, vec3 shift ) {\n  float phase = 2.0 * PI * OPD * 1.0e-9;\n  vec3 val = vec3( 5.4856e-13, 4.4201e-\
13, 5.2481e-13 );\n  vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );\n  vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );\n  vec3 xyz = val * sqrt( 2.0\
 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );\n  xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shi\
ft[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );\n  xyz /= 1.0685e-7;\n  vec3 rgb = XYZ_TO_REC709 * xyz;\n  return rgb;\n }\n vec3 evalIridescence( float outsideIOR,\
 float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {\n  vec3 I;\n  float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilm\
Thickness ) );\n  float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );\n  float cosTheta2Sq = 1.0 - sinTheta2Sq;\n  if ( cosTheta\
2Sq < 0.0 ) {\n   return vec3( 1.0 );\n  }\n  float cosTheta2 = sqrt( cosTheta2Sq );\n  float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );\n  float R12 = F_Schl\
ick( R0, 1.0, cosTheta1 );\n  float T121 = 1.0 - R12;\n  float phi12 = 0.0;\n  if ( iridescenceIOR < outsideIOR ) phi12 = PI;\n  float phi21 = PI - phi12;\n  vec3 ba\
seIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );  vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );\n  vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );\n  vec3\
 phi23 = vec3( 0.0 );\n  if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;\n  if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;\n  if ( baseIOR[ 2 ] < irid\
escenceIOR ) phi23[ 2 ] = PI;\n  float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;\n  vec3 phi = vec3( phi21 ) + phi23;\n  vec3 R123 = clamp( R12 *\
 R23, 1e-5, 0.9999 );\n  vec3 r123 = sqrt( R123 );\n  vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );\n  vec3 C0 = R12 + Rs;\n  I = C0;\n  vec3 Cm = Rs - T121\
;\n  for ( int m = 1; m <= 2; ++ m ) {\n   Cm *= r123;\n   vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );\n   I += Cm * Sm;\n  }\n  return max\
( I, vec3( 0.0 ) );\n }\n#endif",ix="#ifdef USE_BUMPMAP\n uniform sampler2D bumpMap;\n uniform float bumpScale;\n vec2 dHdxy_fwd() {\n  vec2 dSTdx = dFdx( vBumpMapU\
v );\n  vec2 dSTdy = dFdy( vBumpMapUv );\n  float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;\n  float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv +\
 dSTdx ).x - Hll;\n  float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;\n  return vec2( dBx, dBy );\n }\n vec3 perturbNormalArb( vec3 surf_po\
s, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {\n  vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );\n  vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );\n \
 vec3 vN = surf_norm;\n  vec3 R1 = cross( vSigmaY, vN );\n  vec3 R2 = cross( vN, vSigmaX );\n  float fDet = dot( vSigmaX, R1 ) * faceDirection;\n  vec3 vGrad = sign\
( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );\n  return normalize( abs( fDet ) * surf_norm - vGrad );\n }\n#endif",sx="#if NUM_CLIPPING_PLANES > 0\n vec4 plane;\n #\
ifdef ALPHA_TO_COVERAGE\n  float distanceToPlane, distanceGradient;\n  float clipOpacity = 1.0;\n  #pragma unroll_loop_start\n  for ( int i = 0; i < UNION_CLIPPING_\
PLANES; i ++ ) {\n   plane = clippingPlanes[ i ];\n   distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;\n   distanceGradient = fwidth( distanceToPlane\
 ) / 2.0;\n   clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );\n   if ( clipOpacity == 0.0 ) discard;\n  }\n  #pragma unroll_loop\
_end\n  #if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES\n   float unionClipOpacity = 1.0;\n   #pragma unroll_loop_start\n   for ( int i = UNION_CLIPPING_PLANES; i <\
 NUM_CLIPPING_PLANES; i ++ ) {\n    plane = clippingPlanes[ i ];\n    distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;\n    distanceGradient = fwidth\
( distanceToPlane ) / 2.0;\n    unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );\n   }\n   #pragma unroll_loop_end\n  \
 clipOpacity *= 1.0 - unionClipOpacity;\n  #endif\n  diffuseColor.a *= clipOpacity;\n  if ( diffuseColor.a == 0.0 ) discard;\n #else\n  #pragma unroll_loop_start\n  f\
or ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {\n   plane = clippingPlanes[ i ];\n   if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;\n  }\n  #pragma u\
nroll_loop_end\n  #if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES\n   bool clipped = true;\n   #pragma unroll_loop_start\n   for ( int i = UNION_CLIPPING_PLANES; i \
< NUM_CLIPPING_PLANES; i ++ ) {\n    plane = clippingPlanes[ i ];\n    clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;\n   }\n   #pragma unroll_\
loop_end\n   if ( clipped ) discard;\n  #endif\n #endif\n#endif",rx="#if NUM_CLIPPING_PLANES > 0\n varying vec3 vClipPosition;\n uniform vec4 clippingPlanes[ NUM_\
CLIPPING_PLANES ];\n#endif",ox="#if NUM_CLIPPING_PLANES > 0\n varying vec3 vClipPosition;\n#endif",ax="#if NUM_CLIPPING_PLANES > 0\n vClipPosition = - mvPosition\
.xyz;\n#endif",lx="#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )\n diffuseColor *= vColor;\n#endif",cx="#if defined( USE_COLOR ) || defined( USE_COLOR_\
ALPHA )\n varying vec4 vColor;\n#endif",ux="#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_C\
OLOR )\n varying vec4 vColor;\n#endif",hx="#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_CO\
LOR )\n vColor = vec4( 1.0 );\n#endif\n#ifdef USE_COLOR_ALPHA\n vColor *= color;\n#elif defined( USE_COLOR )\n vColor.rgb *= color;\n#endif\n#ifdef USE_INSTANCING_COLOR\
\n vColor.rgb *= instanceColor.rgb;\n#endif\n#ifdef USE_BATCHING_COLOR\n vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );\n#endif",fx="#define PI 3.\
141592653589793\n#define PI2 6.283185307179586\n#define PI_HALF 1.5707963267948966\n#define RECIPROCAL_PI 0.3183098861837907\n#define RECIPROCAL_PI2 0.1591549430918\
9535\n#define EPSILON 1e-6\n#ifndef saturate\n#define saturate( a ) clamp( a, 0.0, 1.0 )\n#endif\n#define whiteComplement( a ) ( 1.0 - saturate( a ) )\nfloat pow2( co\
nst in float x ) { return x*x; }\nvec3 pow2( const in vec3 x ) { return x*x; }\nfloat pow3( const in float x ) { return x*x*x; }\nfloat pow4( const in float x ) { \
float x2 = x*x; return x2*x2; }\nfloat max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }\nfloat average( const in vec3 v ) { return dot( v, vec3( 0.\
3333333 ) ); }\nhighp float rand( const in vec2 uv ) {\n const highp float a = 12.9898, b = 78.233, c = 43758.5453;\n highp float dt = dot( uv.xy, vec2( a,b ) ), s\
n = mod( dt, PI );\n return fract( sin( sn ) * c );\n}\n#ifdef HIGH_PRECISION\n float precisionSafeLength( vec3 v ) { return length( v ); }\n#else\n float precisionSa\
feLength( vec3 v ) {\n  float maxComponent = max3( abs( v ) );\n  return length( v / maxComponent ) * maxComponent;\n }\n#endif\nstruct IncidentLight {\n vec3 color;\n\
 vec3 direction;\n bool visible;\n};\nstruct ReflectedLight {\n vec3 directDiffuse;\n vec3 directSpecular;\n vec3 indirectDiffuse;\n vec3 indirectSpecular;\n};\n#ifdef U\
SE_ALPHAHASH\n varying vec3 vPosition;\n#endif\nvec3 transformDirection( in vec3 dir, in mat4 matrix ) {\n return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );\n}\n\
#define inverseTransformDirection transformDirectionByInverseViewMatrix\nvec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {\n return \
normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );\n}\nvec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {\n return normalize( ( ve\
c4( dir, 0.0 ) * viewMatrix ).xyz );\n}\nbool isPerspectiveMatrix( mat4 m ) {\n return m[ 2 ][ 3 ] == - 1.0;\n}\nvec2 equirectUv( in vec3 dir ) {\n float u = atan( di\
r.z, dir.x ) * RECIPROCAL_PI2 + 0.5;\n float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;\n return vec2( u, v );\n}\nvec3 BRDF_Lambert( const in ve\
c3 diffuseColor ) {\n return RECIPROCAL_PI * diffuseColor;\n}\nvec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {\n float fresnel = exp2\
( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );\n return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );\n}\nfloat F_Schlick( const in float f0, const in float f90, const\
 in float dotVH ) {\n float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );\n return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );\n} // validated",dx="\
vec3 transformedNormal = objectNormal;\n#ifdef USE_TANGENT\n vec3 transformedTangent = objectTangent;\n#endif\n#ifdef USE_BATCHING\n mat3 bm = mat3( batchingMatrix )\
;\n transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );\n transformedNormal = bm * transformedNormal;\n #ifdef \
USE_TANGENT\n  transformedTangent = bm * transformedTangent;\n #endif\n#endif\n#ifdef USE_INSTANCING\n mat3 im = mat3( instanceMatrix );\n transformedNormal /= vec3( \
dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );\n transformedNormal = im * transformedNormal;\n #ifdef USE_TANGENT\n  transformedTange\
nt = im * transformedTangent;\n #endif\n#endif\ntransformedNormal = normalMatrix * transformedNormal;\n#ifdef FLIP_SIDED\n transformedNormal = - transformedNormal;\n#\
endif\n#ifdef USE_TANGENT\n transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;\n#endif",px="#ifdef USE_DISPLACEMENTMAP\n uniform sam\
pler2D displacementMap;\n uniform float displacementScale;\n uniform float displacementBias;\n#endif",mx="#ifdef USE_DISPLACEMENTMAP\n transformed += normalize( \
objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );\n#endif",gx="#ifdef USE_EMISSIVEMAP\n vec4 emissi\
veColor = texture2D( emissiveMap, vEmissiveMapUv );\n #ifdef DECODE_VIDEO_TEXTURE_EMISSIVE\n  emissiveColor = sRGBTransferEOTF( emissiveColor );\n #endif\n totalEmi\
ssiveRadiance *= emissiveColor.rgb;\n#endif",_x="#ifdef USE_EMISSIVEMAP\n uniform sampler2D emissiveMap;\n#endif",xx="gl_FragColor = linearToOutputTexel( gl_Fra\
gColor );",vx="vec4 LinearTransferOETF( in vec4 value ) {\n return value;\n}\nvec4 sRGBTransferEOTF( in vec4 value ) {\n return vec4( mix( pow( value.rgb * 0.947867\
2986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );\n}\nvec4 sRGBTransferOETF(\
 in vec4 value ) {\n return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031\
308 ) ) ) ), value.a );\n}",yx="#ifdef USE_ENVMAP\n #ifdef ENV_WORLDPOS\n  vec3 cameraToFrag;\n  if ( isOrthographic ) {\n   cameraToFrag = normalize( vec3( - viewM\
atrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );\n  } else {\n   cameraToFrag = normalize( vWorldPosition - cameraPosition );\n  }\n  vec3 world\
Normal = transformNormalByInverseViewMatrix( normal, viewMatrix );\n  #ifdef ENVMAP_MODE_REFLECTION\n   vec3 reflectVec = reflect( cameraToFrag, worldNormal );\n  \
#else\n   vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );\n  #endif\n #else\n  vec3 reflectVec = vReflect;\n #endif\n #ifdef ENVMAP_TYPE_CUBE\
\n  vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );\n  #ifdef ENVMAP_BLENDING_MULTIPLY\n   outgoingLight = mix( outgoingLight, outgoingLight * \
envColor.xyz, specularStrength * reflectivity );\n  #elif defined( ENVMAP_BLENDING_MIX )\n   outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * \
reflectivity );\n  #elif defined( ENVMAP_BLENDING_ADD )\n   outgoingLight += envColor.xyz * specularStrength * reflectivity;\n  #endif\n #endif\n#endif",Sx="#if\
def USE_ENVMAP\n uniform float envMapIntensity;\n uniform mat3 envMapRotation;\n uniform samplerCube envMap;\n #ifdef ENVMAP_TYPE_PMREM\n  float roughnessToMip( cons\
t in float roughness ) {\n   float r = clamp( roughness, 0.0, 1.0 );\n   return ENVMAP_MAX_LOD * r * ( 2.0 - r );\n  }\n #endif\n#endif",Mx="#ifdef USE_ENVMAP\n \
uniform float reflectivity;\n #if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )\n  #define ENV_WORLDPOS\n #endif\n #i\
fdef ENV_WORLDPOS\n  varying vec3 vWorldPosition;\n  uniform float refractionRatio;\n #else\n  varying vec3 vReflect;\n #endif\n#endif",bx="#ifdef USE_ENVMAP\n #\
if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )\n  #define ENV_WORLDPOS\n #endif\n #ifdef ENV_WORLDPOS\n  \n  varying\
 vec3 vWorldPosition;\n #else\n  varying vec3 vReflect;\n  uniform float refractionRatio;\n #endif\n#endif",wx="#ifdef USE_ENVMAP\n #ifdef ENV_WORLDPOS\n  vWorldP\
osition = worldPosition.xyz;\n #else\n  vec3 cameraToVertex;\n  if ( isOrthographic ) {\n   cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ \
1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );\n  } else {\n   cameraToVertex = normalize( worldPosition.xyz - cameraPosition );\n  }\n  vec3 worldNormal = transformNormalBy\
InverseViewMatrix( transformedNormal, viewMatrix );\n  #ifdef ENVMAP_MODE_REFLECTION\n   vReflect = reflect( cameraToVertex, worldNormal );\n  #else\n   vReflect = \
refract( cameraToVertex, worldNormal, refractionRatio );\n  #endif\n #endif\n#endif",Tx="#ifdef USE_FOG\n vFogDepth = - mvPosition.z;\n#endif",Ax="#ifdef USE_FO\
G\n varying float vFogDepth;\n#endif",Ex="#ifdef USE_FOG\n #ifdef FOG_EXP2\n  float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );\n #\
else\n  float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );\n #endif\n gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );\n#endif",Cx="#if\
def USE_FOG\n uniform vec3 fogColor;\n varying float vFogDepth;\n #ifdef FOG_EXP2\n  uniform float fogDensity;\n #else\n  uniform float fogNear;\n  uniform float fogFa\
r;\n #endif\n#endif",Rx="#ifdef USE_GRADIENTMAP\n uniform sampler2D gradientMap;\n#endif\nvec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {\n float d\
otNL = dot( normal, lightDirection );\n vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );\n #ifdef USE_GRADIENTMAP\n  return vec3( texture2D( gradientMap, coord ).r );\n\
 #else\n  vec2 fw = fwidth( coord ) * 0.5;\n  return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );\n #endif\n}",Px="#ifdef USE\
_LIGHTMAP\n uniform sampler2D lightMap;\n uniform float lightMapIntensity;\n#endif",Ix="LambertMaterial material;\nmaterial.diffuseColor = diffuseColor.rgb;\nmate\
rial.specularStrength = specularStrength;",Lx="varying vec3 vViewPosition;\nstruct LambertMaterial {\n vec3 diffuseColor;\n float specularStrength;\n};\nvoid RE_Dire\
ct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geome\
tryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {\n float dotNL = saturate( dot( geometryNormal, directLight.directi\
on ) );\n vec3 irradiance = dotNL * directLight.color;\n reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );\n}\nvoid RE_IndirectDif\
fuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClear\
coatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {\n reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.di\
ffuseColor );\n}\n#define RE_Direct    RE_Direct_Lambert\n#define RE_IndirectDiffuse  RE_IndirectDiffuse_Lambert",Dx="uniform bool receiveShadow;\nuniform vec3 a\
mbientLightColor;\n#if defined( USE_LIGHT_PROBES )\n uniform vec3 lightProbe[ 9 ];\n#endif\nvec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {\n\
 float x = normal.x, y = normal.y, z = normal.z;\n vec3 result = shCoefficients[ 0 ] * 0.886227;\n result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;\n result += \
shCoefficients[ 2 ] * 2.0 * 0.511664 * z;\n result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;\n result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;\n result \
+= shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;\n result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );\n result += shCoefficients[ 7 ] * 2.0 * 0.4290\
43 * x * z;\n result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );\n return result;\n}\nvec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const \
in vec3 normal ) {\n vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );\n vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe )\
;\n return irradiance;\n}\nvec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {\n vec3 irradiance = ambientLightColor;\n return irradiance;\n}\nfloat ge\
tDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {\n float distanceFalloff = 1.0 / max( pow( lig\
htDistance, decayExponent ), 0.01 );\n if ( cutoffDistance > 0.0 ) {\n  distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );\n }\n r\
eturn distanceFalloff;\n}\nfloat getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {\n return smoothstep( \
coneCosine, penumbraCosine, angleCosine );\n}\n#if NUM_SUN_LIGHTS > 0\n struct SunLight {\n  vec3 direction;\n  vec3 color;\n };\n uniform SunLight sunLights[ NUM_SUN_\
LIGHTS ];\n void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {\n  light.color = sunLight.color;\n  light.direction = sunLight.direction;\
\n  light.visible = true;\n }\n#endif\n#if NUM_DIR_LIGHTS > 0\n struct DirectionalLight {\n  vec3 direction;\n  vec3 color;\n };\n uniform DirectionalLight directionalLi\
ghts[ NUM_DIR_LIGHTS ];\n void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {\n  light.color = directionalLight.\
color;\n  light.direction = directionalLight.direction;\n  light.visible = true;\n }\n#endif\n#if NUM_POINT_LIGHTS > 0\n struct PointLight {\n  vec3 position;\n  vec3 c\
olor;\n  float distance;\n  float decay;\n };\n uniform PointLight pointLights[ NUM_POINT_LIGHTS ];\n void getPointLightInfo( const in PointLight pointLight, const i\
n vec3 geometryPosition, out IncidentLight light ) {\n  vec3 lVector = pointLight.position - geometryPosition;\n  light.direction = normalize( lVector );\n  float \
lightDistance = length( lVector );\n  light.color = pointLight.color;\n  light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.dec\
ay );\n  light.visible = ( light.color != vec3( 0.0 ) );\n }\n#endif\n#if NUM_SPOT_LIGHTS > 0\n struct SpotLight {\n  vec3 position;\n  vec3 direction;\n  vec3 color;\n \
 float distance;\n  float decay;\n  float coneCos;\n  float penumbraCos;\n };\n uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];\n void getSpotLightInfo( const in Spo\
tLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {\n  vec3 lVector = spotLight.position - geometryPosition;\n  light.direction = normal\
ize( lVector );\n  float angleCos = dot( light.direction, spotLight.direction );\n  float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penum\
braCos, angleCos );\n  if ( spotAttenuation > 0.0 ) {\n   float lightDistance = length( lVector );\n   light.color = spotLight.color * spotAttenuation;\n   light.co\
lor *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );\n   light.visible = ( light.color != vec3( 0.0 ) );\n  } else {\n   light.colo\
r = vec3( 0.0 );\n   light.visible = false;\n  }\n }\n#endif\n#if NUM_RECT_AREA_LIGHTS > 0\n struct RectAreaLight {\n  vec3 color;\n  vec3 position;\n  vec3 halfWidth;\n \
 vec3 halfHeight;\n };\n uniform sampler2D ltc_1; uniform sampler2D ltc_2;\n uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];\n#endif\n#if NUM_HEMI_LIGH\
TS > 0\n struct HemisphereLight {\n  vec3 direction;\n  vec3 skyColor;\n  vec3 groundColor;\n };\n uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];\n vec3 \
getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {\n  float dotNL = dot( normal, hemiLight.direction );\n  float hemiDiffu\
seWeight = 0.5 * dotNL + 0.5;\n  vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );\n  return irradiance;\n }\n#endif\n#include <\
lightprobes_pars_fragment>",Nx="#ifdef USE_ENVMAP\n vec3 getIBLIrradiance( const in vec3 normal ) {\n  #ifdef ENVMAP_TYPE_PMREM\n   vec3 worldNormal = transformNor\
malByInverseViewMatrix( normal, viewMatrix );\n   vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );\n   return PI * envMapCol\
or.rgb * envMapIntensity;\n  #else\n   return vec3( 0.0 );\n  #endif\n }\n vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness\
 ) {\n  #ifdef ENVMAP_TYPE_PMREM\n   vec3 reflectVec = reflect( - viewDir, normal );\n   reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );\n  \
 reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );\n   vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessT\
oMip( roughness ) );\n   return envMapColor.rgb * envMapIntensity;\n  #else\n   return vec3( 0.0 );\n  #endif\n }\n #ifdef USE_RETROREFLECTION\n  vec3 getIBLRetroRadia\
nce( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {\n   #ifdef ENVMAP_TYPE_PMREM\n    vec3 retroVec = normalize( mix( viewDir, normal, \
pow4( roughness ) ) );\n    retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );\n    vec4 envMapColor = textureLod( envMap, envMapRotation *\
 retroVec, roughnessToMip( roughness ) );\n    return envMapColor.rgb * envMapIntensity;\n   #else\n    return vec3( 0.0 );\n   #endif\n  }\n #endif\n #ifdef USE_ANISO\
TROPY\n  vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy\
 ) {\n   #ifdef ENVMAP_TYPE_PMREM\n    vec3 bentNormal = cross( bitangent, viewDir );\n    bentNormal = normalize( cross( bentNormal, bitangent ) );\n    bentNormal\
 = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );\n    return getIBLRadiance( viewDir, bentNormal, roughness );\n\
   #else\n    return vec3( 0.0 );\n   #endif\n  }\n  #ifdef USE_RETROREFLECTION\n   vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, \
const in float roughness, const in vec3 bitangent, const in float anisotropy ) {\n    #ifdef ENVMAP_TYPE_PMREM\n     vec3 bentNormal = cross( bitangent, viewDir )\
;\n     bentNormal = normalize( cross( bentNormal, bitangent ) );\n     bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - ro\
ughness ) ) ) ) );\n     return getIBLRetroRadiance( viewDir, bentNormal, roughness );\n    #else\n     return vec3( 0.0 );\n    #endif\n   }\n  #endif\n #endif\n#endif",
Ux="ToonMaterial material;\nmaterial.diffuseColor = diffuseColor.rgb;",Fx="varying vec3 vViewPosition;\nstruct ToonMaterial {\n vec3 diffuseColor;\n};\nvoid RE_Dire\
ct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometry\
ClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {\n vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.d\
irection ) * directLight.color;\n reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );\n}\nvoid RE_IndirectDiffuse_Toon( const in ve\
c3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in Toon\
Material material, inout ReflectedLight reflectedLight ) {\n reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );\n}\n#define RE_D\
irect    RE_Direct_Toon\n#define RE_IndirectDiffuse  RE_IndirectDiffuse_Toon",Ox="BlinnPhongMaterial material;\nmaterial.diffuseColor = diffuseColor.rgb;\nmateria\
l.specularColor = specular;\nmaterial.specularShininess = shininess;\nmaterial.specularStrength = specularStrength;",Bx="varying vec3 vViewPosition;\nstruct Blin\
nPhongMaterial {\n vec3 diffuseColor;\n vec3 specularColor;\n float specularShininess;\n float specularStrength;\n};\nvoid RE_Direct_BlinnPhong( const in IncidentLigh\
t directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in Blin\
nPhongMaterial material, inout ReflectedLight reflectedLight ) {\n float dotNL = saturate( dot( geometryNormal, directLight.direction ) );\n vec3 irradiance = dot\
NL * directLight.color;\n reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );\n reflectedLight.directSpecular += irradiance * BRDF\
_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;\n}\nvoid RE\
_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec\
3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {\n reflectedLight.indirectDiffuse += irradiance * BRDF_La\
mbert( material.diffuseColor );\n}\n#define RE_Direct    RE_Direct_BlinnPhong\n#define RE_IndirectDiffuse  RE_IndirectDiffuse_BlinnPhong",zx="PhysicalMaterial m\
aterial;\nmaterial.diffuseColor = diffuseColor.rgb;\nmaterial.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );\nmaterial.metalness = metalnessFa\
ctor;\nvec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );\nfloat geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );\nmater\
ial.roughness = max( roughnessFactor, 0.045 );\nmaterial.roughness += geometryRoughness;\nmaterial.roughness = min( material.roughness, 1.0 );\n#ifdef USE_DIFFUSE_\
ROUGHNESS\n float diffuseRoughnessFactor = diffuseRoughness;\n #ifdef USE_DIFFUSE_ROUGHNESSMAP\n  diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffus\
eRoughnessMapUv ).r;\n #endif\n material.diffuseRoughness = saturate( diffuseRoughnessFactor );\n#endif\n#ifdef IOR\n material.ior = ior;\n #ifdef USE_SPECULAR\n  floa\
t specularIntensityFactor = specularIntensity;\n  vec3 specularColorFactor = specularColor;\n  #ifdef USE_SPECULAR_COLORMAP\n   specularColorFactor *= texture2D( s\
pecularColorMap, vSpecularColorMapUv ).rgb;\n  #endif\n  #ifdef USE_SPECULAR_INTENSITYMAP\n   specularIntensityFactor *= texture2D( specularIntensityMap, vSpecular\
IntensityMapUv ).a;\n  #endif\n  material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );\n #else\n  float specularIntensityFactor = 1.0;\n  vec3\
 specularColorFactor = vec3( 1.0 );\n  material.specularF90 = 1.0;\n #endif\n material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) )\
 * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;\n material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor\
 );\n#else\n material.specularColor = vec3( 0.04 );\n material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );\n material.s\
pecularF90 = 1.0;\n#endif\n#ifdef USE_CLEARCOAT\n material.clearcoat = clearcoat;\n material.clearcoatRoughness = clearcoatRoughness;\n material.clearcoatF0 = vec3( \
0.04 );\n material.clearcoatF90 = 1.0;\n #ifdef USE_CLEARCOATMAP\n  material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;\n #endif\n #ifdef USE_CLEARCO\
AT_ROUGHNESSMAP\n  material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;\n #endif\n material.clearcoat = saturate( materia\
l.clearcoat ); material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );\n material.clearcoatRoughness += geometryRoughness;\n material.clearcoatRo\
ughness = min( material.clearcoatRoughness, 1.0 );\n#endif\n#ifdef USE_DISPERSION\n material.dispersion = dispersion;\n#endif\n#ifdef USE_RETROREFLECTION\n material.r\
etroreflectivity = retroreflectivity;\n#endif\n#ifdef USE_IRIDESCENCE\n material.iridescence = iridescence;\n material.iridescenceIOR = iridescenceIOR;\n #ifdef USE_\
IRIDESCENCEMAP\n  material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;\n #endif\n #ifdef USE_IRIDESCENCE_THICKNESSMAP\n  material.iridescenceTh\
ickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknes\
sMinimum;\n #else\n  material.iridescenceThickness = iridescenceThicknessMaximum;\n #endif\n#endif\n#ifdef USE_SHEEN\n material.sheenColor = sheenColor;\n #ifdef USE_S\
HEEN_COLORMAP\n  material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;\n #endif\n material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 )\
;\n #ifdef USE_SHEEN_ROUGHNESSMAP\n  material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;\n #endif\n#endif\n#ifdef USE_ANISOTROPY\n #ifd\
ef USE_ANISOTROPYMAP\n  mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );\n  vec3 anisotropyPolar = t\
exture2D( anisotropyMap, vAnisotropyMapUv ).rgb;\n  vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;\n \
#else\n  vec2 anisotropyV = anisotropyVector;\n #endif\n material.anisotropy = length( anisotropyV );\n if( material.anisotropy == 0.0 ) {\n  anisotropyV = vec2( 1.0\
, 0.0 );\n } else {\n  anisotropyV /= material.anisotropy;\n  material.anisotropy = saturate( material.anisotropy );\n }\n material.alphaT = mix( pow2( material.roug\
hness ), 1.0, pow2( material.anisotropy ) );\n material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;\n material.anisotropyB = tbn[ 1 ] * ani\
sotropyV.x - tbn[ 0 ] * anisotropyV.y;\n#endif",kx="uniform sampler2D dfgLUT;\nstruct PhysicalMaterial {\n vec3 diffuseColor;\n vec3 diffuseContribution;\n vec3 spe\
cularColor;\n vec3 specularColorBlended;\n float roughness;\n float metalness;\n float specularF90;\n float dispersion;\n vec2 dfg;\n vec3 multiScatteringCompensation;\
\n #ifdef USE_DIFFUSE_ROUGHNESS\n  float diffuseRoughness;\n #endif\n #ifdef USE_RETROREFLECTION\n  float retroreflectivity;\n #endif\n #ifdef USE_CLEARCOAT\n  float cl\
earcoat;\n  float clearcoatRoughness;\n  vec3 clearcoatF0;\n  float clearcoatF90;\n #endif\n #ifdef USE_IRIDESCENCE\n  float iridescence;\n  float iridescenceIOR;\n  fl\
oat iridescenceThickness;\n  vec3 iridescenceFresnel;\n  vec3 iridescenceF0Dielectric;\n  vec3 iridescenceF0Metallic;\n #endif\n #ifdef USE_SHEEN\n  vec3 sheenColor;\n\
  float sheenRoughness;\n #endif\n #ifdef IOR\n  float ior;\n #endif\n #ifdef USE_TRANSMISSION\n  float transmission;\n  float transmissionAlpha;\n  float thickness;\n  \
float attenuationDistance;\n  vec3 attenuationColor;\n #endif\n #ifdef USE_ANISOTROPY\n  float anisotropy;\n  float alphaT;\n  vec3 anisotropyT;\n  vec3 anisotropyB;\n \
#endif\n};\nvec3 clearcoatSpecularDirect = vec3( 0.0 );\nvec3 clearcoatSpecularIndirect = vec3( 0.0 );\nvec3 sheenSpecularDirect = vec3( 0.0 );\nvec3 sheenSpecularIn\
direct = vec3(0.0 );\nvec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {\n    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );\n    float x\
2 = x * x;\n    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );\n    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );\n}\n#ifdef USE_DIFFUSE_ROUGHNESS\n const float EON\
_EPSILON = 1e-7;\n float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {\n  float muComp = 1.0 - mu;\n  float gOverPi = mu\
Comp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );\n  return A * ( 1.0 + roughness * gOverPi );\n }\n vec3 BR\
DF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {\n  vec3 rho = saturate( dif\
fuseColor );\n  if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );\n  float dotNL = saturate( dot( normal, lightDir ) );\n  float dotNV = saturate( dot( n\
ormal, viewDir ) );\n  float s = dot( lightDir, viewDir ) - dotNL * dotNV;\n  float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;\n  floa\
t A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );\n  vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );\n  float averageAl\
bedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );\n  float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );\n  float albedoL = FON_Dir\
ectionalAlbedo( dotNL, roughness, A );\n  vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo \
) );\n  vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI\n   * max( EON_EPSILON, 1.0 - albedoV )\n   * max( EON_EPSILON, 1.0 - albedoL )\n   / max( EON_EPSILON, \
1.0 - averageAlbedo );\n  return singleScatter + multiScatter;\n }\n vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in flo\
at dotNV ) {\n  vec3 rho = saturate( diffuseColor );\n  if ( roughness <= EON_EPSILON ) return rho;\n  float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * rough\
ness );\n  float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );\n  float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * rou\
ghness );\n  vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );\n  return rho * direction\
alAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );\n }\n#endif\nfloat V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotN\
V ) {\n float a2 = pow2( alpha );\n float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );\n float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );\n \
return 0.5 / max( gv + gl, EPSILON );\n}\nfloat D_GGX( const in float alpha, const in float dotNH ) {\n float a2 = pow2( alpha );\n float denom = pow2( dotNH ) * ( \
a2 - 1.0 ) + 1.0;\n return RECIPROCAL_PI * a2 / pow2( denom );\n}\n#ifdef USE_ANISOTROPY\n float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in \
float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {\n  float gv \
= dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );\n  float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );\n  return 0.5 / \
max( gv + gl, EPSILON );\n }\n float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float d\
otBH ) {\n  float a2 = alphaT * alphaB;\n  highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );\n  highp float v2 = dot( v, v );\n  float w2 = a2 / v2\
;\n  return RECIPROCAL_PI * a2 * pow2 ( w2 );\n }\n#endif\n#ifdef USE_CLEARCOAT\n vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in ve\
c3 normal, const in PhysicalMaterial material) {\n  vec3 f0 = material.clearcoatF0;\n  float f90 = material.clearcoatF90;\n  float roughness = max( material.clearc\
oatRoughness, 0.045 );\n  float alpha = pow2( roughness );\n  vec3 halfDir = normalize( lightDir + viewDir );\n  float dotNL = saturate( dot( normal, lightDir ) );\
\n  float dotNV = saturate( dot( normal, viewDir ) );\n  float dotNH = saturate( dot( normal, halfDir ) );\n  float dotVH = saturate( dot( viewDir, halfDir ) );\n  \
vec3 F = F_Schlick( f0, f90, dotVH );\n  float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );\n  float D = D_GGX( alpha, dotNH );\n  return F * ( V * D );\n }\n#e\
ndif\nvec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {\n vec3 f0 = material.specularColo\
rBlended;\n float f90 = material.specularF90;\n float roughness = max( material.roughness, 0.045 );\n float alpha = pow2( roughness );\n vec3 halfDir = normalize( l\
ightDir + viewDir );\n float dotNL = saturate( dot( normal, lightDir ) );\n float dotNV = saturate( dot( normal, viewDir ) );\n float dotNH = saturate( dot( normal\
, halfDir ) );\n float dotVH = saturate( dot( viewDir, halfDir ) );\n vec3 F = F_Schlick( f0, f90, dotVH );\n #ifdef USE_IRIDESCENCE\n  F = mix( F, material.iridesc\
enceFresnel, material.iridescence );\n #endif\n #ifdef USE_ANISOTROPY\n  float dotTL = dot( material.anisotropyT, lightDir );\n  float dotTV = dot( material.anisotr\
opyT, viewDir );\n  float dotTH = dot( material.anisotropyT, halfDir );\n  float dotBL = dot( material.anisotropyB, lightDir );\n  float dotBV = dot( material.anis\
otropyB, viewDir );\n  float dotBH = dot( material.anisotropyB, halfDir );\n  float alphaT = max( material.alphaT, alpha );\n  float V = V_GGX_SmithCorrelated_Anis\
otropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );\n  float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );\n #else\n  float V = V_GG\
X_SmithCorrelated( alpha, dotNL, dotNV );\n  float D = D_GGX( alpha, dotNH );\n #endif\n return F * ( V * D );\n}\nvec2 LTC_Uv( const in vec3 N, const in vec3 V, con\
st in float roughness ) {\n const float LUT_SIZE = 64.0;\n const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;\n const float LUT_BIAS = 0.5 / LUT_SIZE;\n float d\
otNV = saturate( dot( N, V ) );\n vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );\n uv = uv * LUT_SCALE + LUT_BIAS;\n return uv;\n}\nfloat LTC_ClippedSphereFormFac\
tor( const in vec3 f ) {\n float l = length( f );\n return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );\n}\nvec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in \
vec3 v2 ) {\n float x = dot( v1, v2 );\n float y = abs( x );\n float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;\n float b = 3.4175940 + ( 4.1616724 + y ) * \
y;\n float v = a / b;\n float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;\n return cross( v1, v2 ) * theta_sintheta;\n}\nve\
c3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {\n vec3 v1 = rectCoords[ 1 ] - rectCoord\
s[ 0 ];\n vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];\n vec3 lightNormal = cross( v1, v2 );\n if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0\
 );\n vec3 T1, T2;\n T1 = normalize( V - N * dot( V, N ) );\n T2 = - cross( N, T1 );\n mat3 mat = mInv * transpose( mat3( T1, T2, N ) );\n vec3 coords[ 4 ];\n coords[\
 0 ] = mat * ( rectCoords[ 0 ] - P );\n coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );\n coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );\n coords[ 3 ] = mat * ( rectCoo\
rds[ 3 ] - P );\n coords[ 0 ] = normalize( coords[ 0 ] );\n coords[ 1 ] = normalize( coords[ 1 ] );\n coords[ 2 ] = normalize( coords[ 2 ] );\n coords[ 3 ] = normal\
ize( coords[ 3 ] );\n vec3 vectorFormFactor = vec3( 0.0 );\n vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );\n vectorFormFactor += LTC_Ed\
geVectorFormFactor( coords[ 1 ], coords[ 2 ] );\n vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );\n vectorFormFactor += LTC_EdgeVectorFo\
rmFactor( coords[ 3 ], coords[ 0 ] );\n float result = LTC_ClippedSphereFormFactor( vectorFormFactor );\n return vec3( result );\n}\n#if defined( USE_SHEEN )\nfloat \
D_Charlie( float roughness, float dotNH ) {\n float alpha = pow2( roughness );\n float invAlpha = 1.0 / alpha;\n float cos2h = dotNH * dotNH;\n float sin2h = max( 1\
.0 - cos2h, 0.0078125 );\n return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );\n}\nfloat V_Neubelt( float dotNV, float dotNL ) {\n return satur\
ate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );\n}\nvec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColo\
r, const in float sheenRoughness ) {\n vec3 halfDir = normalize( lightDir + viewDir );\n float dotNL = saturate( dot( normal, lightDir ) );\n float dotNV = saturat\
e( dot( normal, viewDir ) );\n float dotNH = saturate( dot( normal, halfDir ) );\n float D = D_Charlie( sheenRoughness, dotNH );\n float V = V_Neubelt( dotNV, dotN\
L );\n return sheenColor * ( D * V );\n}\n#endif\nfloat IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {\n float dotNV = satur\
ate( dot( normal, viewDir ) );\n float r2 = roughness * roughness;\n float rInv = 1.0 / ( roughness + 0.1 );\n float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2\
 - 0.8469 * rInv;\n float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;\n float DG = exp( a * dotNV + b );\n return saturate( DG );\n}\nvec3 Enviro\
nmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {\n float dotNV = sat\
urate( dot( normal, viewDir ) );\n vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;\n return specularColor * fab.x + specularF90 * fab.y;\n}\n#ifdef USE\
_IRIDESCENCE\nvoid computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, con\
st in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {\n#else\nvoid computeMultiscattering( const in vec2 fab, const in vec3 specularColo\
r, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {\n#endif\n #ifdef USE_IRIDESCENCE\n  vec3 Fr = mix( specularColor, iridescenceF\
0, iridescence );\n #else\n  vec3 Fr = specularColor;\n #endif\n vec3 FssEss = Fr * fab.x + specularF90 * fab.y;\n float Ess = fab.x + fab.y;\n float Ems = 1.0 - Ess;\
\n vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619; vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );\n singleScatter += FssEss;\n multiScatter += Fms * Ems;\n}\n#if NUM_REC\
T_AREA_LIGHTS > 0\n void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const i\
n vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {\n  vec3 normal = geome\
tryNormal;\n  vec3 viewDir = geometryViewDir;\n  vec3 position = geometryPosition;\n  vec3 lightPos = rectAreaLight.position;\n  vec3 halfWidth = rectAreaLight.half\
Width;\n  vec3 halfHeight = rectAreaLight.halfHeight;\n  vec3 lightColor = rectAreaLight.color;\n  float roughness = material.roughness;\n  vec3 rectCoords[ 4 ];\n  \
rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;  rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;\n  rectCoords[ 2 ] = lightPos - halfWidth + halfHeight\
;\n  rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;\n  vec2 uv = LTC_Uv( normal, viewDir, roughness );\n  vec4 t1 = texture2D( ltc_1, uv );\n  vec4 t2 = textu\
re2D( ltc_2, uv );\n  mat3 mInv = mat3(\n   vec3( t1.x, 0, t1.y ),\n   vec3(    0, 1,    0 ),\n   vec3( t1.z, 0, t1.w )\n  );\n  vec3 fresnel = ( material.specularCol\
orBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );\n  reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( no\
rmal, viewDir, position, mInv, rectCoords );\n  reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, positi\
on, mat3( 1.0 ), rectCoords );\n  #ifdef USE_CLEARCOAT\n   vec3 Ncc = geometryClearcoatNormal;\n   vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRough\
ness );\n   vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );\n   vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );\n   mat3 mInvClearcoat = mat3(\n    vec3( t1\
Clearcoat.x, 0, t1Clearcoat.y ),\n    vec3(             0, 1,             0 ),\n    vec3( t1Clearcoat.z, 0, t1Clearcoat.w )\n   );\n   vec3 fresnelClearcoat = mater\
ial.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;\n   clearcoatSpecularDirect += lightColor * fresnelClearcoat \
* LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );\n  #endif\n }\n#endif\nvoid RE_Direct_Physical( const in IncidentLight directLight, const in ve\
c3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, ino\
ut ReflectedLight reflectedLight ) {\n float dotNL = saturate( dot( geometryNormal, directLight.direction ) );\n vec3 irradiance = dotNL * directLight.color;\n #if\
def USE_CLEARCOAT\n  float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );\n  vec3 ccIrradiance = dotNLcc * directLight.color;\n  clea\
rcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );\n #endif\n #ifdef USE_SHEEN\
\n \n   sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );\n \n\
   float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );\n   float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLi\
ght.direction, material.sheenRoughness );\n \n   float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );\n \n   irradiance *=\
 sheenEnergyComp;\n \n  #endif\n vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );\n #ifdef USE_RETROREFLECTION\n  ve\
c3 retroViewDir = reflect( - geometryViewDir, geometryNormal );\n  vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, materi\
al );\n  specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );\n #endif\n reflectedLight.directSpecular += irradiance * sp\
ecularBRDF * material.multiScatteringCompensation;\n vec3 halfDir = normalize( directLight.direction + geometryViewDir );\n float dotVH = saturate( dot( geometryV\
iewDir, halfDir ) );\n vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );\n #ifdef USE_RETROREFLECTION\n  vec3 retroHalfDir = normalize( di\
rectLight.direction + retroViewDir );\n  float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );\n  vec3 retroF = F_Schlick( material.specularColor, mat\
erial.specularF90, dotRetroVH );\n  F = mix( F, retroF, saturate( material.retroreflectivity ) );\n #endif\n #ifdef USE_DIFFUSE_ROUGHNESS\n  vec3 diffuseBRDF = BRDF\
_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );\n #else\n  vec3 d\
iffuseBRDF = BRDF_Lambert( material.diffuseContribution );\n #endif\n reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );\n}\nvoid RE_IndirectDi\
ffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryCle\
arcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {\n vec3 singleScattering = vec3( 0.0 );\n vec3 multiScattering = vec3( 0.\
0 );\n #ifdef USE_IRIDESCENCE\n  computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iri\
descenceF0Dielectric, singleScattering, multiScattering );\n #else\n  computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleSc\
attering, multiScattering );\n #endif\n #ifdef USE_DIFFUSE_ROUGHNESS\n  float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );\n  vec3 diffuseAlbedo = EO\
N_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );\n  vec3 diffuse = irradiance * RECIPROCAL_PI * dif\
fuseAlbedo * ( 1.0 - singleScattering - multiScattering );\n #else\n  vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleSca\
ttering - multiScattering );\n #endif\n #ifdef USE_SHEEN\n  float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );\n  sheenSp\
ecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;\n  float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;\n  d\
iffuse *= sheenEnergyComp;\n #endif\n reflectedLight.indirectDiffuse += diffuse;\n}\nvoid RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradi\
ance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearc\
oatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {\n #ifdef USE_CLEARCOAT\n  clearcoatSpecularIndirect += clearcoatRadiance * E\
nvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );\n #endif\n #ifdef USE_SHEEN\n\
  sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;\n  #endif\
\n vec3 singleScatteringDielectric = vec3( 0.0 );\n vec3 multiScatteringDielectric = vec3( 0.0 );\n vec3 singleScatteringMetallic = vec3( 0.0 );\n vec3 multiScatter\
ingMetallic = vec3( 0.0 );\n #ifdef USE_IRIDESCENCE\n  computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iri\
descence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );\n  computeMultiscatteringIridescence( material.dfg, material\
.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );\n #else\n  compute\
Multiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );\n  computeMultiscattering( \
material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );\n #endif\n vec3 singleScattering = mix( singleScat\
teringDielectric, singleScatteringMetallic, material.metalness );\n vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.meta\
lness );\n vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;\n #ifdef USE_DIFFUSE_ROUGHNESS\n  float dotNV = saturate( dot( \
geometryNormal, geometryViewDir ) );\n  vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metaln\
ess ) * ( 1.0 - totalScatteringDielectric );\n #else\n  vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );\n #endif\n vec3 cosineWei\
ghtedIrradiance = irradiance * RECIPROCAL_PI;\n vec3 indirectSpecular = radiance * singleScattering;\n indirectSpecular += multiScattering * cosineWeightedIrradia\
nce;\n vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;\n #ifdef USE_SHEEN\n  float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material\
.sheenRoughness );\n  float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;\n  indirectSpecular *= sheenEnergyComp;\n  indirectDiffuse *= sheenE\
nergyComp;\n #endif\n reflectedLight.indirectSpecular += indirectSpecular;\n reflectedLight.indirectDiffuse += indirectDiffuse;\n}\n#define RE_Direct    RE_Direct_Ph\
ysical\n#define RE_Direct_RectArea  RE_Direct_RectArea_Physical\n#define RE_IndirectDiffuse  RE_IndirectDiffuse_Physical\n#define RE_IndirectSpecular  RE_IndirectS\
pecular_Physical\nfloat computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {\n return saturate( pow( dotN\
V + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );\n}",Vx="\nvec3 geometryPosition = - vViewPosition;\nvec3 geometryNormal = nor\
mal;\nvec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );\nvec3 geometryClearcoatNormal = vec3( 0.0 );\n#ifdef USE_CLEARCOAT\n\
 geometryClearcoatNormal = clearcoatNormal;\n#endif\n#ifdef USE_IRIDESCENCE\n float dotNVi = saturate( dot( normal, geometryViewDir ) );\n if ( material.iridescence\
Thickness == 0.0 ) {\n  material.iridescence = 0.0;\n } else {\n  material.iridescence = saturate( material.iridescence );\n }\n if ( material.iridescence > 0.0 ) {\n\
  vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );\n  vec3 iri\
descenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );\n  material.iridescenceF\
resnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );\n  material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFre\
snelDielectric, 1.0, dotNVi );\n  material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );\n }\n#endif\n#ifdef STANDARD\n float dot\
NVms = saturate( dot( geometryNormal, geometryViewDir ) );\n material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;\n #if ( NUM_SUN_LIGHTS > \
0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )\n  float EssMs = material.dfg.x + material.dfg.y;\n  material.multiScatteringCompensation\
 = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );\n #endif\n#endif\nIncidentLight directLight;\n#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )\n \
PointLight pointLight;\n #if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0\n PointLightShadow pointLightShadow;\n #endif\n #pragma unroll_loop_start\n for \
( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {\n  pointLight = pointLights[ i ];\n  getPointLightInfo( pointLight, geometryPosition, directLight );\n  #if defined( US\
E_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )\n  pointLightShadow = \
pointLightShadows[ i ];\n  directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, p\
ointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLig\
htShadow.shadowCameraFar ) : 1.0;\n  #endif\n  RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, refle\
ctedLight );\n }\n #pragma unroll_loop_end\n#endif\n#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )\n SpotLight spotLight;\n vec4 spotColor;\n vec3 spotLightCoord;\
\n bool inSpotLightMap;\n #if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0\n SpotLightShadow spotLightShadow;\n #endif\n #pragma unroll_loop_start\n for ( i\
nt i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {\n  spotLight = spotLights[ i ];\n  getSpotLightInfo( spotLight, geometryPosition, directLight );\n  #if ( UNROLLED_LOOP_IND\
EX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )\n  #define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX\n  #elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )\n  #define SP\
OT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS\n  #else\n  #define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS \
)\n  #endif\n  #if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )\n   spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;\n   inSpotLightMap = all( \
lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );\n   spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );\n   directLight.\
color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;\n  #endif\n  #undef SPOT_LIGHT_MAP_INDEX\n  #if defined( USE_SHADOWMAP ) && ( UNROL\
LED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )\n  spotLightShadow = spotLightShadows[ i ];\n  directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow\
( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[\
 i ] ) : 1.0;\n  #endif\n  RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );\n }\n #pr\
agma unroll_loop_end\n#endif\n#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )\n SunLight sunLight;\n #if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0\n S\
unLightShadow sunLightShadow;\n #endif\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {\n  sunLight = sunLights[ i ];\n  getSunLightInfo( \
sunLight, directLight );\n  #if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )\n  sunLightShadow = sunLightShadows[ i ];\n  directLigh\
t.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;\n  #endif\n  RE_Direct( direct\
Light, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );\n }\n #pragma unroll_loop_end\n#endif\n#if ( NUM_DIR_\
LIGHTS > 0 ) && defined( RE_Direct )\n DirectionalLight directionalLight;\n #if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0\n DirectionalLightShadow dire\
ctionalLightShadow;\n #endif\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {\n  directionalLight = directionalLights[ i ];\n  getDirectio\
nalLightInfo( directionalLight, directLight );\n  #if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )\n  directionalLightShadow = dire\
ctionalLightShadows[ i ];\n  directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowM\
apSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;\n  \
#endif\n  RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );\n }\n #pragma unroll_loop\
_end\n#endif\n#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )\n RectAreaLight rectAreaLight;\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM\
_RECT_AREA_LIGHTS; i ++ ) {\n  rectAreaLight = rectAreaLights[ i ];\n  RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geome\
tryClearcoatNormal, material, reflectedLight );\n }\n #pragma unroll_loop_end\n#endif\n#if defined( RE_IndirectDiffuse )\n vec3 iblIrradiance = vec3( 0.0 );\n vec3 ir\
radiance = getAmbientLightIrradiance( ambientLightColor );\n #if defined( USE_LIGHT_PROBES )\n  irradiance += getLightProbeIrradiance( lightProbe, geometryNormal \
);\n #endif\n #if ( NUM_HEMI_LIGHTS > 0 )\n  #pragma unroll_loop_start\n  for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {\n   irradiance += getHemisphereLightIrradian\
ce( hemisphereLights[ i ], geometryNormal );\n  }\n  #pragma unroll_loop_end\n #endif\n #if NUM_LIGHT_PROBE_GRIDS > 0\n  vec3 probeWorldPos = ( ( vec4( geometryPosit\
ion, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;\n  vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );\n  int probeGrid =\
 - 1;\n  #pragma unroll_loop_start\n  for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {\n   if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probes\
Min[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;\n  }\n  #pragma unroll_loop_end\n  #pragma unroll_loop_start\n  for ( int i = 0\
; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {\n   if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probe\
sMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );\n  }\n  #pragma unroll_loop_end\n #endif\n#endif\n#if defined( RE_IndirectSpecular )\n vec3 radia\
nce = vec3( 0.0 );\n vec3 clearcoatRadiance = vec3( 0.0 );\n#endif",Gx="#if defined( RE_IndirectDiffuse )\n #ifdef USE_LIGHTMAP\n  vec4 lightMapTexel = texture2D(\
 lightMap, vLightMapUv );\n  vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;\n  irradiance += lightMapIrradiance;\n #endif\n #if defined( USE_ENVMA\
P ) && defined( ENVMAP_TYPE_PMREM )\n  #if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )\n   iblIrradiance += getIBLIrradiance( geometryNormal );\n\
  #endif\n #endif\n#endif\n#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )\n #ifdef USE_ANISOTROPY\n  vec3 iblRadiance = getIBLAnisotropyRadiance( geomet\
ryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );\n #else\n  vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometr\
yNormal, material.roughness );\n #endif\n #ifdef USE_RETROREFLECTION\n  #ifdef USE_ANISOTROPY\n   vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryVie\
wDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );\n  #else\n   vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, \
geometryNormal, material.roughness );\n  #endif\n  iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );\n #endif\n radiance +\
= iblRadiance;\n #ifdef USE_CLEARCOAT\n  clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );\n #endif\n#en\
dif",Hx="#if defined( RE_IndirectDiffuse )\n #if defined( LAMBERT ) || defined( PHONG )\n  irradiance += iblIrradiance;\n #endif\n RE_IndirectDiffuse( irradiance, g\
eometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );\n#endif\n#if defined( RE_IndirectSpecular )\n RE_IndirectSpe\
cular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );\n#endi\
f",Wx="#if NUM_LIGHT_PROBE_GRIDS > 0\nuniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];\nuniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];\nuniform vec3 pr\
obesMax[ NUM_LIGHT_PROBE_GRIDS ];\nuniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];\nbool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 pro\
besMin, vec3 probesMax, vec3 probesResolution ) {\n vec3 spacing = ( probesMax - probesMin ) / probesResolution;\n vec3 samplePos = worldPos + worldNormal * spaci\
ng * 0.5;\n vec3 margin = spacing * 0.01;\n return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin )\
 );\n}\nvec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {\n ve\
c3 res = probesResolution;\n vec3 gridRange = probesMax - probesMin;\n vec3 probeSpacing = gridRange / res;\n vec3 samplePos = worldPos + worldNormal * probeSpacin\
g * 0.5;\n vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );\n float nz          = res.z;\n float paddedSlices = nz + 2.0;\n fl\
oat atlasDepth  = 7.0 * paddedSlices;\n float uvZBase     = uvw.z * nz + 1.0;\n vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atl\
asDepth ) );\n vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );\n vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZB\
ase + 2.0 * paddedSlices   ) / atlasDepth ) );\n vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );\n vec4 s4 = textu\
re( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );\n vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) \
/ atlasDepth ) );\n vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );\n vec3 c0 = s0.xyz;\n vec3 c1 = vec3( s0.w, s1.\
xy );\n vec3 c2 = vec3( s1.zw, s2.x );\n vec3 c3 = s2.yzw;\n vec3 c4 = s3.xyz;\n vec3 c5 = vec3( s3.w, s4.xy );\n vec3 c6 = vec3( s4.zw, s5.x );\n vec3 c7 = s5.yzw;\n \
vec3 c8 = s6.xyz;\n float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;\n vec3 result = c0 * 0.886227;\n result += c1 * 2.0 * 0.511664 * y;\n result += c\
2 * 2.0 * 0.511664 * z;\n result += c3 * 2.0 * 0.511664 * x;\n result += c4 * 2.0 * 0.429043 * x * y;\n result += c5 * 2.0 * 0.429043 * y * z;\n result += c6 * ( 0.\
743125 * z * z - 0.247708 );\n result += c7 * 2.0 * 0.429043 * x * z;\n result += c8 * 0.429043 * ( x * x - y * y );\n return max( result, vec3( 0.0 ) );\n}\n#endif",
Xx="#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )\n gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;\n#endif",qx="\
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )\n uniform float logDepthBufFC;\n varying float vFragDepth;\n varying float vIsPerspective;\n#endif",Yx="#ifdef USE_L\
OGARITHMIC_DEPTH_BUFFER\n varying float vFragDepth;\n varying float vIsPerspective;\n#endif",Zx="#ifdef USE_LOGARITHMIC_DEPTH_BUFFER\n vFragDepth = 1.0 + gl_Posi\
tion.w;\n vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );\n#endif",Jx="#ifdef USE_MAP\n vec4 sampledDiffuseColor = texture2D( map, vMapUv );\n \
#ifdef DECODE_VIDEO_TEXTURE\n  sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );\n #endif\n diffuseColor *= sampledDiffuseColor;\n#endif",$x="#ifde\
f USE_MAP\n uniform sampler2D map;\n#endif",Kx="#if defined( USE_MAP ) || defined( USE_ALPHAMAP )\n #if defined( USE_POINTS_UV )\n  vec2 uv = vUv;\n #else\n  vec2 u\
v = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;\n #endif\n#endif\n#ifdef USE_MAP\n diffuseColor *= texture2D( map, uv );\n#endif\n#ifdef U\
SE_ALPHAMAP\n diffuseColor.a *= texture2D( alphaMap, uv ).g;\n#endif",Qx="#if defined( USE_POINTS_UV )\n varying vec2 vUv;\n#else\n #if defined( USE_MAP ) || defin\
ed( USE_ALPHAMAP )\n  uniform mat3 uvTransform;\n #endif\n#endif\n#ifdef USE_MAP\n uniform sampler2D map;\n#endif\n#ifdef USE_ALPHAMAP\n uniform sampler2D alphaMap;\n#en\
dif",jx="float metalnessFactor = metalness;\n#ifdef USE_METALNESSMAP\n vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );\n metalnessFactor *= texel\
Metalness.b;\n#endif",ev="#ifdef USE_METALNESSMAP\n uniform sampler2D metalnessMap;\n#endif",tv="#ifdef USE_INSTANCING_MORPH\n float morphTargetInfluences[ MORPH\
TARGETS_COUNT ];\n float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;\n for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) \
{\n  morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;\n }\n#endif",nv="#if defined( USE_MORPHCOLORS )\n #if defined( U\
SE_COLOR_ALPHA )\n  vColor *= morphTargetBaseInfluence;\n #elif defined( USE_COLOR )\n  vColor.rgb *= morphTargetBaseInfluence;\n #endif\n for ( int i = 0; i < MORPH\
TARGETS_COUNT; i ++ ) {\n  #if defined( USE_COLOR_ALPHA )\n   if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInflue\
nces[ i ];\n  #elif defined( USE_COLOR )\n   if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ]\
;\n  #endif\n }\n#endif",iv="#ifdef USE_MORPHNORMALS\n objectNormal *= morphTargetBaseInfluence;\n for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {\n  if ( morphT\
argetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];\n }\n#endif",sv="#ifdef USE_MORPHTARGETS\n #ifndef \
USE_INSTANCING_MORPH\n  uniform float morphTargetBaseInfluence;\n  uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];\n #endif\n uniform sampler2DArray morp\
hTargetsTexture;\n uniform ivec2 morphTargetsTextureSize;\n vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {\n  int \
texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;\n  int y = texelIndex / morphTargetsTextureSize.x;\n  int x = texelIndex - y * morphTargetsTextur\
eSize.x;\n  ivec3 morphUV = ivec3( x, y, morphTargetIndex );\n  return texelFetch( morphTargetsTexture, morphUV, 0 );\n }\n#endif",rv="#ifdef USE_MORPHTARGETS\n \
transformed *= morphTargetBaseInfluence;\n for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {\n  if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( \
gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];\n }\n#endif",ov="float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;\n#ifdef FLAT_SHADED\n vec3 fdx = dFdx( \
vViewPosition );\n vec3 fdy = dFdy( vViewPosition );\n vec3 normal = normalize( cross( fdx, fdy ) );\n#else\n vec3 normal = normalize( vNormal );\n #ifdef DOUBLE_SID\
ED\n  normal *= faceDirection;\n #endif\n#endif\n#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )\n #ifde\
f USE_TANGENT\n  mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );\n #else\n  mat3 tbn = getTangentFrame( - vViewPosition, normal,\n  #if d\
efined( USE_NORMALMAP )\n   vNormalMapUv\n  #elif defined( USE_CLEARCOAT_NORMALMAP )\n   vClearcoatNormalMapUv\n  #else\n   vUv\n  #endif\n  );\n #endif\n #ifdef DOUBLE_\
SIDED\n  tbn[0] *= faceDirection;\n  tbn[1] *= faceDirection;\n #endif\n#endif\n#ifdef USE_CLEARCOAT_NORMALMAP\n #ifdef USE_TANGENT\n  mat3 tbn2 = mat3( normalize( vTa\
ngent ), normalize( vBitangent ), normal );\n #else\n  mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );\n #endif\n #ifdef DOUBLE_SIDED\
\n  tbn2[0] *= faceDirection;\n  tbn2[1] *= faceDirection;\n #endif\n#endif\nvec3 nonPerturbedNormal = normal;",av="#ifdef USE_NORMALMAP_OBJECTSPACE\n normal = t\
exture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;\n #ifdef FLIP_SIDED\n  normal = - normal;\n #endif\n #ifdef DOUBLE_SIDED\n  normal = normal * faceDirection;\n #e\
ndif\n normal = normalize( normalMatrix * normal );\n#elif defined( USE_NORMALMAP_TANGENTSPACE )\n vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0\
;\n #if defined( USE_PACKED_NORMALMAP )\n  mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );\n #endif\n mapN.xy *= normalScale;\n normal = n\
ormalize( tbn * mapN );\n#elif defined( USE_BUMPMAP )\n normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );\n#endif",lv="#ifndef F\
LAT_SHADED\n varying vec3 vNormal;\n #ifdef USE_TANGENT\n  varying vec3 vTangent;\n  varying vec3 vBitangent;\n #endif\n#endif",cv="#ifndef FLAT_SHADED\n varying\
 vec3 vNormal;\n #ifdef USE_TANGENT\n  varying vec3 vTangent;\n  varying vec3 vBitangent;\n #endif\n#endif",uv="#ifndef FLAT_SHADED\n vNormal = normalize( transf\
ormedNormal );\n #ifdef USE_TANGENT\n  vTangent = normalize( transformedTangent );\n  vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );\n  #ifdef FL\
IP_SIDED\n   vBitangent = - vBitangent;\n  #endif\n #endif\n#endif",hv="#ifdef USE_NORMALMAP\n uniform sampler2D normalMap;\n uniform vec2 normalScale;\n#endif\n#if\
def USE_NORMALMAP_OBJECTSPACE\n uniform mat3 normalMatrix;\n#endif\n#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEA\
RCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )\n mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {\n  vec3 q0 = dFdx( eye_pos.xyz );\n  vec3 q1 = d\
Fdy( eye_pos.xyz );\n  vec2 st0 = dFdx( uv.st );\n  vec2 st1 = dFdy( uv.st );\n  vec3 N = surf_norm;\n  vec3 q1perp = cross( q1, N );\n  vec3 q0perp = cross( N, q0 )\
;\n  vec3 T = q1perp * st0.x + q0perp * st1.x;\n  vec3 B = q1perp * st0.y + q0perp * st1.y;\n  float det = max( dot( T, T ), dot( B, B ) );\n  float scale = ( det =\
= 0.0 ) ? 0.0 : inversesqrt( det );\n  return mat3( T * scale, B * scale, N );\n }\n#endif",fv="#ifdef USE_CLEARCOAT\n vec3 clearcoatNormal = nonPerturbedNormal;\
\n#endif",dv="#ifdef USE_CLEARCOAT_NORMALMAP\n vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;\n clearcoatMapN.xy *= \
clearcoatNormalScale;\n clearcoatNormal = normalize( tbn2 * clearcoatMapN );\n#endif",pv="#ifdef USE_CLEARCOATMAP\n uniform sampler2D clearcoatMap;\n#endif\n#ifdef\
 USE_CLEARCOAT_NORMALMAP\n uniform sampler2D clearcoatNormalMap;\n uniform vec2 clearcoatNormalScale;\n#endif\n#ifdef USE_CLEARCOAT_ROUGHNESSMAP\n uniform sampler2D \
clearcoatRoughnessMap;\n#endif",mv="#ifdef USE_IRIDESCENCEMAP\n uniform sampler2D iridescenceMap;\n#endif\n#ifdef USE_IRIDESCENCE_THICKNESSMAP\n uniform sampler2D i\
ridescenceThicknessMap;\n#endif",gv="#ifdef OPAQUE\ndiffuseColor.a = 1.0;\n#endif\n#ifdef USE_TRANSMISSION\ndiffuseColor.a *= material.transmissionAlpha;\n#endif\ngl_\
FragColor = vec4( outgoingLight, diffuseColor.a );",_v="vec3 packNormalToRGB( const in vec3 normal ) {\n return normalize( normal ) * 0.5 + 0.5;\n}\nvec3 unpackRGB\
ToNormal( const in vec3 rgb ) {\n return 2.0 * rgb.xyz - 1.0;\n}\nconst float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float Shift\
Right8 = 1. / 256.;\nconst float Inv255 = 1. / 255.;\nconst vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );\nconst vec2 UnpackFactors2\
 = vec2( UnpackDownscale, 1.0 / PackFactors.g );\nconst vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );\nconst vec4 UnpackFac\
tors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );\nvec4 packDepthToRGBA( const in float v ) {\n if( v <= 0.0 )\n  return vec4( 0., 0., 0., 0.\
 );\n if( v >= 1.0 )\n  return vec4( 1., 1., 1., 1. );\n float vuf;\n float af = modf( v * PackFactors.a, vuf );\n float bf = modf( vuf * ShiftRight8, vuf );\n float \
gf = modf( vuf * ShiftRight8, vuf );\n return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );\n}\nvec3 packDepthToRGB( const in float v ) {\n if( v <=\
 0.0 )\n  return vec3( 0., 0., 0. );\n if( v >= 1.0 )\n  return vec3( 1., 1., 1. );\n float vuf;\n float bf = modf( v * PackFactors.b, vuf );\n float gf = modf( vuf *\
 ShiftRight8, vuf );\n return vec3( vuf * Inv255, gf * PackUpscale, bf );\n}\nvec2 packDepthToRG( const in float v ) {\n if( v <= 0.0 )\n  return vec2( 0., 0. );\n if\
( v >= 1.0 )\n  return vec2( 1., 1. );\n float vuf;\n float gf = modf( v * 256., vuf );\n return vec2( vuf * Inv255, gf );\n}\nfloat unpackRGBAToDepth( const in vec4 \
v ) {\n return dot( v, UnpackFactors4 );\n}\nfloat unpackRGBToDepth( const in vec3 v ) {\n return dot( v, UnpackFactors3 );\n}\nfloat unpackRGToDepth( const in vec2 v\
 ) {\n return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;\n}\nvec4 pack2HalfToRGBA( const in vec2 v ) {\n vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract(\
 v.y * 255.0 ) );\n return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );\n}\nvec2 unpackRGBATo2Half( const in vec4 v ) {\n return vec2( v.x + ( v.y / 255.\
0 ), v.z + ( v.w / 255.0 ) );\n}\nfloat viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {\n return ( viewZ + near ) / ( n\
ear - far );\n}\nfloat orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {\n #ifdef USE_REVERSED_DEPTH_BUFFER\n \n  return de\
pth * ( far - near ) - far;\n #else\n  return depth * ( near - far ) - near;\n #endif\n}\nfloat viewZToPerspectiveDepth( const in float viewZ, const in float near, c\
onst in float far ) {\n return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );\n}\nfloat perspectiveDepthToViewZ( const in float depth, const in float nea\
r, const in float far ) {\n \n #ifdef USE_REVERSED_DEPTH_BUFFER\n  return ( near * far ) / ( ( near - far ) * depth - near );\n #else\n  return ( near * far ) / ( ( \
far - near ) * depth - far );\n #endif\n}",xv="#ifdef PREMULTIPLIED_ALPHA\n gl_FragColor.rgb *= gl_FragColor.a;\n#endif",vv="vec4 mvPosition = vec4( transformed\
, 1.0 );\n#ifdef USE_BATCHING\n mvPosition = batchingMatrix * mvPosition;\n#endif\n#ifdef USE_INSTANCING\n mvPosition = instanceMatrix * mvPosition;\n#endif\nmvPositio\
n = modelViewMatrix * mvPosition;\ngl_Position = projectionMatrix * mvPosition;",yv="#ifdef DITHERING\n gl_FragColor.rgb = dithering( gl_FragColor.rgb );\n#endif",
Sv="#ifdef DITHERING\n vec3 dithering( vec3 color ) {\n  float grid_position = rand( gl_FragCoord.xy );\n  vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.\
0, 0.25 / 255.0 );\n  dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );\n  return color + dither_shift_RGB;\n }\n#endif",
Mv="float roughnessFactor = roughness;\n#ifdef USE_ROUGHNESSMAP\n vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );\n roughnessFactor *= texelRough\
ness.g;\n#endif",bv="#ifdef USE_ROUGHNESSMAP\n uniform sampler2D roughnessMap;\n#endif",wv="#if NUM_SPOT_LIGHT_COORDS > 0\n varying vec4 vSpotLightCoord[ NUM_SPO\
T_LIGHT_COORDS ];\n#endif\n#if NUM_SPOT_LIGHT_MAPS > 0\n uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];\n#endif\n#ifdef USE_SHADOWMAP\n #if NUM_SUN_LIGHT_SHAD\
OWS > 0\n  #define SUN_LIGHT_CASCADES 2\n  #if defined( SHADOWMAP_TYPE_PCF )\n   uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];\n  #else\n   uniform \
sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];\n  #endif\n  uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];\n  uniform vec4 sunShadow\
Cascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];\n  varying vec4 vSunShadowWorldPosition;\n  varying vec3 vSunShadowWorldNormal;\n  struct SunLightShadow {\n \
  float shadowIntensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shadowMapSize;\n  };\n  uniform SunLightShadow sunLightSha\
dows[ NUM_SUN_LIGHT_SHADOWS ];\n #endif\n #if NUM_DIR_LIGHT_SHADOWS > 0\n  #if defined( SHADOWMAP_TYPE_PCF )\n   uniform sampler2DShadow directionalShadowMap[ NUM_D\
IR_LIGHT_SHADOWS ];\n  #else\n   uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];\n  #endif\n  varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_S\
HADOWS ];\n  struct DirectionalLightShadow {\n   float shadowIntensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shadowMapSi\
ze;\n  };\n  uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];\n #endif\n #if NUM_SPOT_LIGHT_SHADOWS > 0\n  #if defined( SHADOWMAP_TYP\
E_PCF )\n   uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];\n  #else\n   uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];\n  #endif\n  str\
uct SpotLightShadow {\n   float shadowIntensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shadowMapSize;\n  };\n  uniform Spo\
tLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];\n #endif\n #if NUM_POINT_LIGHT_SHADOWS > 0\n  #if defined( SHADOWMAP_TYPE_PCF )\n   uniform samplerCubeShad\
ow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];\n  #elif defined( SHADOWMAP_TYPE_BASIC )\n   uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];\n  #endif\
\n  varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];\n  struct PointLightShadow {\n   float shadowIntensity;\n   float shadowBias;\n   float shadowNormalBi\
as;\n   float shadowRadius;\n   vec2 shadowMapSize;\n   float shadowCameraNear;\n   float shadowCameraFar;\n  };\n  uniform PointLightShadow pointLightShadows[ NUM_PO\
INT_LIGHT_SHADOWS ];\n #endif\n #if defined( SHADOWMAP_TYPE_PCF )\n  float interleavedGradientNoise( vec2 position ) {\n   return fract( 52.9829189 * fract( dot( po\
sition, vec2( 0.06711056, 0.00583715 ) ) ) );\n  }\n  vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {\n   const float goldenAngle = 2.399963\
229728653;\n   float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );\n   float theta = float( sampleIndex ) * goldenAngle + phi;\n   return vec\
2( cos( theta ), sin( theta ) ) * r;\n  }\n #endif\n #if defined( SHADOWMAP_TYPE_PCF )\n  float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shad\
owIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {\n   float shadow = 1.0;\n   shadowCoord.xyz /= shadowCoord.w;\n   #ifdef USE_REVERSED_DEPTH\
_BUFFER\n    shadowCoord.z -= shadowBias;\n   #else\n    shadowCoord.z += shadowBias;\n   #endif\n   bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 &&\
 shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;\n   bool frustumTest = inFrustum && shadowCoord.z <= 1.0;\n   if ( frustumTest ) {\n    vec2 texelSize = vec2( 1.0 )\
 / shadowMapSize;\n    vec2 radius = shadowRadius * texelSize;\n    float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;\n    shadow = (\n     texture( sh\
adowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +\n     texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5\
, phi ) * radius, shadowCoord.z ) ) +\n     texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +\n     texture( s\
hadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +\n     texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, \
5, phi ) * radius, shadowCoord.z ) )\n    ) * 0.2;\n   }\n   return mix( 1.0, shadow, shadowIntensity );\n  }\n #elif defined( SHADOWMAP_TYPE_VSM )\n  float getShadow\
( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {\n   float shadow = 1.0;\n   shadowCoo\
rd.xyz /= shadowCoord.w;\n   #ifdef USE_REVERSED_DEPTH_BUFFER\n    shadowCoord.z -= shadowBias;\n   #else\n    shadowCoord.z += shadowBias;\n   #endif\n   bool inFrus\
tum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;\n   bool frustumTest = inFrustum && shadowCoord.z <= 1.0;\n   \
if ( frustumTest ) {\n    vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;\n    float mean = distribution.x;\n    float variance = distribution.y * d\
istribution.y;\n    #ifdef USE_REVERSED_DEPTH_BUFFER\n     float hard_shadow = step( mean, shadowCoord.z );\n    #else\n     float hard_shadow = step( shadowCoord.z\
, mean );\n    #endif\n    \n    if ( hard_shadow == 1.0 ) {\n     shadow = 1.0;\n    } else {\n     variance = max( variance, 0.0000001 );\n     float d = shadowCoord\
.z - mean;\n     float p_max = variance / ( variance + d * d );\n     p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );\n     shadow = max( hard_shadow, p_max );\n\
    }\n   }\n   return mix( 1.0, shadow, shadowIntensity );\n  }\n #else\n  float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float sh\
adowBias, float shadowRadius, vec4 shadowCoord ) {\n   float shadow = 1.0;\n   shadowCoord.xyz /= shadowCoord.w;\n   #ifdef USE_REVERSED_DEPTH_BUFFER\n    shadowCoo\
rd.z -= shadowBias;\n   #else\n    shadowCoord.z += shadowBias;\n   #endif\n   bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0\
 && shadowCoord.y <= 1.0;\n   bool frustumTest = inFrustum && shadowCoord.z <= 1.0;\n   if ( frustumTest ) {\n    float depth = texture2D( shadowMap, shadowCoord.x\
y ).r;\n    #ifdef USE_REVERSED_DEPTH_BUFFER\n     shadow = step( depth, shadowCoord.z );\n    #else\n     shadow = step( shadowCoord.z, depth );\n    #endif\n   }\n  \
 return mix( 1.0, shadow, shadowIntensity );\n  }\n #endif\n #if NUM_SUN_LIGHT_SHADOWS > 0\n  float getSunShadow(\n   #if defined( SHADOWMAP_TYPE_PCF )\n    sampler2D\
Shadow shadowMap,\n   #else\n    sampler2D shadowMap,\n   #endif\n   SunLightShadow sunLightShadow,\n   int shadowIndex\n  ) {\n   vec4 shadowWorldPosition = vec4( vSu\
nShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );\n   float viewDepth = vSunShadowWorldPosition.w;\n   int cascadeOffset \
= shadowIndex * SUN_LIGHT_CASCADES;\n   float shadow = 1.0;\n   for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {\n    vec4 cascade = sunShadowCascade[ cascad\
eOffset + i ];\n    if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {\n     float cascadeShadow = getShadow(\n      shadowMap,\n      sunLightShadow.shadowMa\
pSize,\n      sunLightShadow.shadowIntensity,\n      sunLightShadow.shadowBias,\n      sunLightShadow.shadowRadius,\n      sunShadowMatrix[ cascadeOffset + i ] * sh\
adowWorldPosition\n     );\n     shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );\n    }\n   }\n   return shadow;\n  }\n #endif\n #\
if NUM_POINT_LIGHT_SHADOWS > 0\n #if defined( SHADOWMAP_TYPE_PCF )\n float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity,\
 float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {\n  float shadow = 1.0;\n  vec3 lightToPosition = shadow\
Coord.xyz;\n  vec3 bd3D = normalize( lightToPosition );\n  vec3 absVec = abs( lightToPosition );\n  float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );\n\
  if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {\n   float lightDistance = length( lightToPosition );\n   float depthRange =\
 shadowCameraFar - shadowCameraNear;\n   #ifdef USE_REVERSED_DEPTH_BUFFER\n    float depthA = - shadowCameraNear / depthRange - shadowBias;\n    float depthB = sha\
dowCameraNear * shadowCameraFar / ( depthRange * lightDistance );\n   #else\n    float depthA = shadowCameraFar / depthRange + shadowBias;\n    float depthB = - sh\
adowCameraNear * shadowCameraFar / ( depthRange * lightDistance );\n   #endif\n   float texelSize = shadowRadius / shadowMapSize.x;\n   vec3 absDir = abs( bd3D );\n\
   vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );\n   tangent = normalize( cross( bd3D, tangent ) );\n   vec3 bitangent = cro\
ss( bd3D, tangent );\n   float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;\n   shadow = 0.0;\n   for ( int i = 0; i < 5; i ++ ) {\n    vec2 offset = vo\
gelDiskSample( i, 5, phi );\n    vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;\n    vec3 absDirection = abs( direction );\n   \
 float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );\n    shadow += texture( shadowMap, vec4( direction, dp ) );\n   }\n   s\
hadow *= 0.2;\n  }\n  return mix( 1.0, shadow, shadowIntensity );\n }\n #elif defined( SHADOWMAP_TYPE_BASIC )\n float getPointShadow( samplerCube shadowMap, vec2 sha\
dowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {\n  float shadow = 1.\
0;\n  vec3 lightToPosition = shadowCoord.xyz;\n  vec3 absVec = abs( lightToPosition );\n  float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );\n  if ( vie\
wSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {\n   float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpace\
Z * ( shadowCameraFar - shadowCameraNear ) );\n   dp += shadowBias;\n   vec3 bd3D = normalize( lightToPosition );\n   float depth = textureCube( shadowMap, bd3D ).\
r;\n   #ifdef USE_REVERSED_DEPTH_BUFFER\n    depth = 1.0 - depth;\n   #endif\n   shadow = step( dp, depth );\n  }\n  return mix( 1.0, shadow, shadowIntensity );\n }\n #\
endif\n #endif\n#endif",Tv="#if NUM_SPOT_LIGHT_COORDS > 0\n uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];\n varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_\
COORDS ];\n#endif\n#ifdef USE_SHADOWMAP\n #if NUM_SUN_LIGHT_SHADOWS > 0\n  varying vec4 vSunShadowWorldPosition;\n  varying vec3 vSunShadowWorldNormal;\n #endif\n #if \
NUM_DIR_LIGHT_SHADOWS > 0\n  uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];\n  varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];\n  st\
ruct DirectionalLightShadow {\n   float shadowIntensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shadowMapSize;\n  };\n  uni\
form DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];\n #endif\n #if NUM_SPOT_LIGHT_SHADOWS > 0\n  struct SpotLightShadow {\n   float shadow\
Intensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shadowMapSize;\n  };\n  uniform SpotLightShadow spotLightShadows[ NUM_SP\
OT_LIGHT_SHADOWS ];\n #endif\n #if NUM_POINT_LIGHT_SHADOWS > 0\n  uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];\n  varying vec4 vPointShadowCoord[ NUM_\
POINT_LIGHT_SHADOWS ];\n  struct PointLightShadow {\n   float shadowIntensity;\n   float shadowBias;\n   float shadowNormalBias;\n   float shadowRadius;\n   vec2 shad\
owMapSize;\n   float shadowCameraNear;\n   float shadowCameraFar;\n  };\n  uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];\n #endif\n#endif",
Av="#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0\
 )\n #ifdef HAS_NORMAL\n  vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );\n #else\n  vec3 shadowWorldNormal = vec3( 0.\
0 );\n #endif\n vec4 shadowWorldPosition;\n#endif\n#if defined( USE_SHADOWMAP )\n #if NUM_SUN_LIGHT_SHADOWS > 0\n  vSunShadowWorldPosition = vec4( worldPosition.xyz, \
- mvPosition.z );\n  vSunShadowWorldNormal = shadowWorldNormal;\n #endif\n #if NUM_DIR_LIGHT_SHADOWS > 0\n  #pragma unroll_loop_start\n  for ( int i = 0; i < NUM_DIR\
_LIGHT_SHADOWS; i ++ ) {\n   shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );\n   vDirectionalS\
hadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;\n  }\n  #pragma unroll_loop_end\n #endif\n #if NUM_POINT_LIGHT_SHADOWS > 0\n  #pragma unroll_lo\
op_start\n  for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {\n   shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shad\
owNormalBias, 0 );\n   vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;\n  }\n  #pragma unroll_loop_end\n #endif\n#endif\n#if NUM_SPOT_LIGHT_COO\
RDS > 0\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {\n  shadowWorldPosition = worldPosition;\n  #if ( defined( USE_SHADOWMAP )\
 && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )\n   shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;\n  #endif\n  vSpotLig\
htCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;\n }\n #pragma unroll_loop_end\n#endif",Ev="float getShadowMask() {\n float shadow = 1.0;\n #ifdef USE_S\
HADOWMAP\n #if NUM_SUN_LIGHT_SHADOWS > 0\n SunLightShadow sunLight;\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {\n  sunLight = \
sunLightShadows[ i ];\n  shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;\n }\n #pragma unroll_loop_end\n #endif\n #\
if NUM_DIR_LIGHT_SHADOWS > 0\n DirectionalLightShadow directionalLight;\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {\n  direct\
ionalLight = directionalLightShadows[ i ];\n  shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.sh\
adowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;\n }\n #pragma unroll_loop_end\n #endif\n #if NUM_SP\
OT_LIGHT_SHADOWS > 0\n SpotLightShadow spotLight;\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {\n  spotLight = spotLightShadow\
s[ i ];\n  shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRad\
ius, vSpotLightCoord[ i ] ) : 1.0;\n }\n #pragma unroll_loop_end\n #endif\n #if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP\
_TYPE_BASIC ) )\n PointLightShadow pointLight;\n #pragma unroll_loop_start\n for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {\n  pointLight = pointLightShadow\
s[ i ];\n  shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight\
.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;\n }\n #pragma unroll_loop_end\n #endif\n #endif\n return shad\
ow;\n}",Cv="#ifdef USE_SKINNING\n mat4 boneMatX = getBoneMatrix( skinIndex.x );\n mat4 boneMatY = getBoneMatrix( skinIndex.y );\n mat4 boneMatZ = getBoneMatrix( sk\
inIndex.z );\n mat4 boneMatW = getBoneMatrix( skinIndex.w );\n#endif",Rv="#ifdef USE_SKINNING\n uniform mat4 bindMatrix;\n uniform mat4 bindMatrixInverse;\n unifor\
m highp sampler2D boneTexture;\n mat4 getBoneMatrix( const in float i ) {\n  int size = textureSize( boneTexture, 0 ).x;\n  int j = int( i ) * 4;\n  int x = j % siz\
e;\n  int y = j / size;\n  vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );\n  vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );\n  vec4 v3 = texelFe\
tch( boneTexture, ivec2( x + 2, y ), 0 );\n  vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );\n  return mat4( v1, v2, v3, v4 );\n }\n#endif",Pv="#ifde\
f USE_SKINNING\n vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );\n vec4 skinned = vec4( 0.0 );\n skinned += boneMatX * skinVertex * skinWeight.x;\n skinned\
 += boneMatY * skinVertex * skinWeight.y;\n skinned += boneMatZ * skinVertex * skinWeight.z;\n skinned += boneMatW * skinVertex * skinWeight.w;\n transformed = ( b\
indMatrixInverse * skinned ).xyz;\n#endif",Iv="#ifdef USE_SKINNING\n mat4 skinMatrix = mat4( 0.0 );\n skinMatrix += skinWeight.x * boneMatX;\n skinMatrix += skinWe\
ight.y * boneMatY;\n skinMatrix += skinWeight.z * boneMatZ;\n skinMatrix += skinWeight.w * boneMatW;\n skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;\n o\
bjectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;\n #ifdef USE_TANGENT\n  objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;\n #e\
ndif\n#endif",Lv="float specularStrength;\n#ifdef USE_SPECULARMAP\n vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );\n specularStrength = texelSpecul\
ar.r;\n#else\n specularStrength = 1.0;\n#endif",Dv="#ifdef USE_SPECULARMAP\n uniform sampler2D specularMap;\n#endif",Nv="#if defined( TONE_MAPPING )\n gl_FragCol\
or.rgb = toneMapping( gl_FragColor.rgb );\n#endif",Uv="#ifndef saturate\n#define saturate( a ) clamp( a, 0.0, 1.0 )\n#endif\nuniform float toneMappingExposure;\nvec\
3 LinearToneMapping( vec3 color ) {\n return saturate( toneMappingExposure * color );\n}\nvec3 ReinhardToneMapping( vec3 color ) {\n color *= toneMappingExposure;\n \
return saturate( color / ( vec3( 1.0 ) + color ) );\n}\nvec3 CineonToneMapping( vec3 color ) {\n color *= toneMappingExposure;\n color = max( vec3( 0.0 ), color - 0\
.004 );\n return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );\n}\nvec3 RRTAndODTFit( vec3 v ) {\n vec3 a = v * \
( v + 0.0245786 ) - 0.000090537;\n vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;\n return a / b;\n}\nvec3 ACESFilmicToneMapping( vec3 color ) {\n const mat3 \
ACESInputMat = mat3(\n  vec3( 0.59719, 0.07600, 0.02840 ),  vec3( 0.35458, 0.90834, 0.13383 ),\n  vec3( 0.04823, 0.01566, 0.83777 )\n );\n const mat3 ACESOutputMat \
= mat3(\n  vec3(  1.60475, -0.10208, -0.00327 ),  vec3( -0.53108,  1.10813, -0.07276 ),\n  vec3( -0.07367, -0.00605,  1.07602 )\n );\n color *= toneMappingExposure \
/ 0.6;\n color = ACESInputMat * color;\n color = RRTAndODTFit( color );\n color = ACESOutputMat * color;\n return saturate( color );\n}\nconst mat3 LINEAR_REC2020_TO_\
LINEAR_SRGB = mat3(\n vec3( 1.6605, - 0.1246, - 0.0182 ),\n vec3( - 0.5876, 1.1329, - 0.1006 ),\n vec3( - 0.0728, - 0.0083, 1.1187 )\n);\nconst mat3 LINEAR_SRGB_TO_L\
INEAR_REC2020 = mat3(\n vec3( 0.6274, 0.0691, 0.0164 ),\n vec3( 0.3293, 0.9195, 0.0880 ),\n vec3( 0.0433, 0.0113, 0.8956 )\n);\nvec3 agxDefaultContrastApprox( vec3 x\
 ) {\n vec3 x2 = x * x;\n vec3 x4 = x2 * x2;\n return + 15.5 * x4 * x2\n  - 40.14 * x4 * x\n  + 31.96 * x4\n  - 6.868 * x2 * x\n  + 0.4298 * x2\n  + 0.1191 * x\n  - 0.00\
232;\n}\nvec3 AgXToneMapping( vec3 color ) {\n const mat3 AgXInsetMatrix = mat3(\n  vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),\n  vec3( 0.095121\
2405381588, 0.761241990602591, 0.0767994186031903 ),\n  vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )\n );\n const mat3 AgXOutsetMatrix = mat3(\n\
  vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),\n  vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),\n  vec3( - \
0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )\n );\n const float AgxMinEv = - 12.47393; const float AgxMaxEv = 4.026069;\n color *= toneMappin\
gExposure;\n color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;\n color = AgXInsetMatrix * color;\n color = max( color, 1e-10 ); color = log2( color );\n color = ( colo\
r - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );\n color = clamp( color, 0.0, 1.0 );\n color = agxDefaultContrastApprox( color );\n color = AgXOutsetMatrix * color;\n colo\
r = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );\n color = LINEAR_REC2020_TO_LINEAR_SRGB * color;\n color = clamp( color, 0.0, 1.0 );\n return color;\n}\nvec3 Neut\
ralToneMapping( vec3 color ) {\n const float StartCompression = 0.8 - 0.04;\n const float Desaturation = 0.15;\n color *= toneMappingExposure;\n float x = min( colo\
r.r, min( color.g, color.b ) );\n float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;\n color -= offset;\n float peak = max( color.r, max( color.g, color.b ) );\n if\
 ( peak < StartCompression ) return color;\n float d = 1. - StartCompression;\n float newPeak = 1. - d * d / ( peak + d - StartCompression );\n color *= newPeak / \
peak;\n float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );\n return mix( color, vec3( newPeak ), g );\n}\nvec3 CustomToneMapping( vec3 color ) { return\
 color; }",Fv="#ifdef USE_TRANSMISSION\n material.transmission = transmission;\n material.transmissionAlpha = 1.0;\n material.thickness = thickness;\n material.atte\
nuationDistance = attenuationDistance;\n material.attenuationColor = attenuationColor;\n #ifdef USE_TRANSMISSIONMAP\n  material.transmission *= texture2D( transmis\
sionMap, vTransmissionMapUv ).r;\n #endif\n #ifdef USE_THICKNESSMAP\n  material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;\n #endif\n vec3 pos = vWor\
ldPosition;\n vec3 v = normalize( cameraPosition - pos );\n vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );\n vec4 transmitted = getIBLVolumeRef\
raction(\n  n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,\n  pos, modelMatrix, viewMatrix, projecti\
onMatrix, material.dispersion, material.ior, material.thickness,\n  material.attenuationColor, material.attenuationDistance );\n material.transmissionAlpha = mix(\
 material.transmissionAlpha, transmitted.a, material.transmission );\n totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );\n#endif",Ov="\
#ifdef USE_TRANSMISSION\n uniform float transmission;\n uniform float thickness;\n uniform float attenuationDistance;\n uniform vec3 attenuationColor;\n #ifdef USE_T\
RANSMISSIONMAP\n  uniform sampler2D transmissionMap;\n #endif\n #ifdef USE_THICKNESSMAP\n  uniform sampler2D thicknessMap;\n #endif\n uniform vec2 transmissionSampler\
Size;\n uniform sampler2D transmissionSamplerMap;\n uniform mat4 modelMatrix;\n uniform mat4 projectionMatrix;\n varying vec3 vWorldPosition;\n float w0( float a ) {\
\n  return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );\n }\n float w1( float a ) {\n  return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );\n }\
\n float w2( float a ){\n  return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );\n }\n float w3( float a ) {\n  return ( 1.0 / 6.0 ) * ( a * a * a \
);\n }\n float g0( float a ) {\n  return w0( a ) + w1( a );\n }\n float g1( float a ) {\n  return w2( a ) + w3( a );\n }\n float h0( float a ) {\n  return - 1.0 + w1( a \
) / ( w0( a ) + w1( a ) );\n }\n float h1( float a ) {\n  return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );\n }\n vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, f\
loat lod ) {\n  uv = uv * texelSize.zw + 0.5;\n  vec2 iuv = floor( uv );\n  vec2 fuv = fract( uv );\n  float g0x = g0( fuv.x );\n  float g1x = g1( fuv.x );\n  float h\
0x = h0( fuv.x );\n  float h1x = h1( fuv.x );\n  float h0y = h0( fuv.y );\n  float h1y = h1( fuv.y );\n  vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texe\
lSize.xy;\n  vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;\n  vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;\n  vec2 p\
3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;\n  return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +\n\
   g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );\n }\n vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {\n  v\
ec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );\n  vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );\n  vec2 fLodSizeInv = 1.0 / fLodSi\
ze;\n  vec2 cLodSizeInv = 1.0 / cLodSize;\n  vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );\n  vec4 cSample = bicubic( sampler\
, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );\n  return mix( fSample, cSample, fract( lod ) );\n }\n vec3 getVolumeTransmissionRay( const in vec3 n, const in\
 vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {\n  vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );\n  vec3\
 modelScale;\n  modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );\n  modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );\n  modelScale.z = length( vec3( mo\
delMatrix[ 2 ].xyz ) );\n  return normalize( refractionVector ) * thickness * modelScale;\n }\n float applyIorToRoughness( const in float roughness, const in float\
 ior ) {\n  return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );\n }\n vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in fl\
oat ior ) {\n  float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );\n  return textureBicubic( transmissionSamplerMap, fragCoord.\
xy, lod );\n }\n vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {\n  if ( isinf(\
 attenuationDistance ) ) {\n   return vec3( 1.0 );\n  } else {\n   vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;\n   vec3 transmitta\
nce = exp( - attenuationCoefficient * transmissionDistance );   return transmittance;\n  }\n }\n vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, con\
st in float roughness, const in vec3 diffuseColor,\n  const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,\
\n  const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,\n  const in vec3 attenuationColor\
, const in float attenuationDistance ) {\n  vec4 transmittedLight;\n  vec3 transmittance;\n  #ifdef USE_DISPERSION\n   float halfSpread = ( ior - 1.0 ) * 0.025 * di\
spersion;\n   vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );\n   for ( int i = 0; i < 3; i ++ ) {\n    vec3 transmissionRay = getVolumeTransmissionRa\
y( n, v, thickness, iors[ i ], modelMatrix );\n    vec3 refractedRayExit = position + transmissionRay;\n    vec4 ndcPos = projMatrix * viewMatrix * vec4( refracte\
dRayExit, 1.0 );\n    vec2 refractionCoords = ndcPos.xy / ndcPos.w;\n    refractionCoords += 1.0;\n    refractionCoords /= 2.0;\n    vec4 transmissionSample = getTr\
ansmissionSample( refractionCoords, roughness, iors[ i ] );\n    transmittedLight[ i ] = transmissionSample[ i ];\n    transmittedLight.a += transmissionSample.a;\
\n    transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];\n   }\n   transmittedLig\
ht.a /= 3.0;\n  #else\n   vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );\n   vec3 refractedRayExit = position + transmission\
Ray;\n   vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );\n   vec2 refractionCoords = ndcPos.xy / ndcPos.w;\n   refractionCoords += 1.0;\n   r\
efractionCoords /= 2.0;\n   transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );\n   transmittance = diffuseColor * volumeAttenuation( le\
ngth( transmissionRay ), attenuationColor, attenuationDistance );\n  #endif\n  vec3 attenuatedColor = transmittance * transmittedLight.rgb;\n  vec3 F = Environment\
BRDF( n, v, specularColor, specularF90, roughness );\n  float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;\n  return vec4(\
 ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );\n }\n#endif",Bv="#if defined( USE_UV ) || defined( USE_ANISOTROPY )\n\
 varying vec2 vUv;\n#endif\n#ifdef USE_MAP\n varying vec2 vMapUv;\n#endif\n#ifdef USE_ALPHAMAP\n varying vec2 vAlphaMapUv;\n#endif\n#ifdef USE_LIGHTMAP\n varying vec2 vL\
ightMapUv;\n#endif\n#ifdef USE_AOMAP\n varying vec2 vAoMapUv;\n#endif\n#ifdef USE_BUMPMAP\n varying vec2 vBumpMapUv;\n#endif\n#ifdef USE_NORMALMAP\n varying vec2 vNormal\
MapUv;\n#endif\n#ifdef USE_EMISSIVEMAP\n varying vec2 vEmissiveMapUv;\n#endif\n#ifdef USE_METALNESSMAP\n varying vec2 vMetalnessMapUv;\n#endif\n#ifdef USE_ROUGHNESSMAP\n\
 varying vec2 vRoughnessMapUv;\n#endif\n#ifdef USE_DIFFUSE_ROUGHNESSMAP\n varying vec2 vDiffuseRoughnessMapUv;\n#endif\n#ifdef USE_ANISOTROPYMAP\n varying vec2 vAniso\
tropyMapUv;\n#endif\n#ifdef USE_CLEARCOATMAP\n varying vec2 vClearcoatMapUv;\n#endif\n#ifdef USE_CLEARCOAT_NORMALMAP\n varying vec2 vClearcoatNormalMapUv;\n#endif\n#ifd\
ef USE_CLEARCOAT_ROUGHNESSMAP\n varying vec2 vClearcoatRoughnessMapUv;\n#endif\n#ifdef USE_IRIDESCENCEMAP\n varying vec2 vIridescenceMapUv;\n#endif\n#ifdef USE_IRIDES\
CENCE_THICKNESSMAP\n varying vec2 vIridescenceThicknessMapUv;\n#endif\n#ifdef USE_SHEEN_COLORMAP\n varying vec2 vSheenColorMapUv;\n#endif\n#ifdef USE_SHEEN_ROUGHNESSM\
AP\n varying vec2 vSheenRoughnessMapUv;\n#endif\n#ifdef USE_SPECULARMAP\n varying vec2 vSpecularMapUv;\n#endif\n#ifdef USE_SPECULAR_COLORMAP\n varying vec2 vSpecularCo\
lorMapUv;\n#endif\n#ifdef USE_SPECULAR_INTENSITYMAP\n varying vec2 vSpecularIntensityMapUv;\n#endif\n#ifdef USE_TRANSMISSIONMAP\n uniform mat3 transmissionMapTransfor\
m;\n varying vec2 vTransmissionMapUv;\n#endif\n#ifdef USE_THICKNESSMAP\n uniform mat3 thicknessMapTransform;\n varying vec2 vThicknessMapUv;\n#endif",zv="#if de\
fined( USE_UV ) || defined( USE_ANISOTROPY )\n varying vec2 vUv;\n#endif\n#ifdef USE_MAP\n uniform mat3 mapTransform;\n varying vec2 vMapUv;\n#endif\n#ifdef USE_ALPHAM\
AP\n uniform mat3 alphaMapTransform;\n varying vec2 vAlphaMapUv;\n#endif\n#ifdef USE_LIGHTMAP\n uniform mat3 lightMapTransform;\n varying vec2 vLightMapUv;\n#endif\n#if\
def USE_AOMAP\n uniform mat3 aoMapTransform;\n varying vec2 vAoMapUv;\n#endif\n#ifdef USE_BUMPMAP\n uniform mat3 bumpMapTransform;\n varying vec2 vBumpMapUv;\n#endif\n#\
ifdef USE_NORMALMAP\n uniform mat3 normalMapTransform;\n varying vec2 vNormalMapUv;\n#endif\n#ifdef USE_DISPLACEMENTMAP\n uniform mat3 displacementMapTransform;\n var\
ying vec2 vDisplacementMapUv;\n#endif\n#ifdef USE_EMISSIVEMAP\n uniform mat3 emissiveMapTransform;\n varying vec2 vEmissiveMapUv;\n#endif\n#ifdef USE_METALNESSMAP\n un\
iform mat3 metalnessMapTransform;\n varying vec2 vMetalnessMapUv;\n#endif\n#ifdef USE_ROUGHNESSMAP\n uniform mat3 roughnessMapTransform;\n varying vec2 vRoughnessMap\
Uv;\n#endif\n#ifdef USE_DIFFUSE_ROUGHNESSMAP\n uniform mat3 diffuseRoughnessMapTransform;\n varying vec2 vDiffuseRoughnessMapUv;\n#endif\n#ifdef USE_ANISOTROPYMAP\n un\
iform mat3 anisotropyMapTransform;\n varying vec2 vAnisotropyMapUv;\n#endif\n#ifdef USE_CLEARCOATMAP\n uniform mat3 clearcoatMapTransform;\n varying vec2 vClearcoatM\
apUv;\n#endif\n#ifdef USE_CLEARCOAT_NORMALMAP\n uniform mat3 clearcoatNormalMapTransform;\n varying vec2 vClearcoatNormalMapUv;\n#endif\n#ifdef USE_CLEARCOAT_ROUGHNES\
SMAP\n uniform mat3 clearcoatRoughnessMapTransform;\n varying vec2 vClearcoatRoughnessMapUv;\n#endif\n#ifdef USE_SHEEN_COLORMAP\n uniform mat3 sheenColorMapTransform\
;\n varying vec2 vSheenColorMapUv;\n#endif\n#ifdef USE_SHEEN_ROUGHNESSMAP\n uniform mat3 sheenRoughnessMapTransform;\n varying vec2 vSheenRoughnessMapUv;\n#endif\n#ifd\
ef USE_IRIDESCENCEMAP\n uniform mat3 iridescenceMapTransform;\n varying vec2 vIridescenceMapUv;\n#endif\n#ifdef USE_IRIDESCENCE_THICKNESSMAP\n uniform mat3 iridescen\
ceThicknessMapTransform;\n varying vec2 vIridescenceThicknessMapUv;\n#endif\n#ifdef USE_SPECULARMAP\n uniform mat3 specularMapTransform;\n varying vec2 vSpecularMapU\
v;\n#endif\n#ifdef USE_SPECULAR_COLORMAP\n uniform mat3 specularColorMapTransform;\n varying vec2 vSpecularColorMapUv;\n#endif\n#ifdef USE_SPECULAR_INTENSITYMAP\n unif\
orm mat3 specularIntensityMapTransform;\n varying vec2 vSpecularIntensityMapUv;\n#endif\n#ifdef USE_TRANSMISSIONMAP\n uniform mat3 transmissionMapTransform;\n varyin\
g vec2 vTransmissionMapUv;\n#endif\n#ifdef USE_THICKNESSMAP\n uniform mat3 thicknessMapTransform;\n varying vec2 vThicknessMapUv;\n#endif",kv="#if defined( USE_\
UV ) || defined( USE_ANISOTROPY )\n vUv = vec3( uv, 1 ).xy;\n#endif\n#ifdef USE_MAP\n vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_ALPHAMAP\n \
vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_LIGHTMAP\n vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;\n#e\
ndif\n#ifdef USE_AOMAP\n vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_BUMPMAP\n vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 \
) ).xy;\n#endif\n#ifdef USE_NORMALMAP\n vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_DISPLACEMENTMAP\n vDisplacementMapUv =\
 ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_EMISSIVEMAP\n vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV,\
 1 ) ).xy;\n#endif\n#ifdef USE_METALNESSMAP\n vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_ROUGHNESSMAP\n vRoughne\
ssMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_DIFFUSE_ROUGHNESSMAP\n vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTrans\
form * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_ANISOTROPYMAP\n vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;\
\n#endif\n#ifdef USE_CLEARCOATMAP\n vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_CLEARCOAT_NORMALMAP\n vClearcoatN\
ormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_CLEARCOAT_ROUGHNESSMAP\n vClearcoatRoughnessMapUv = ( clea\
rcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_IRIDESCENCEMAP\n vIridescenceMapUv = ( iridescenceMapTransform * vec3( \
IRIDESCENCEMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_IRIDESCENCE_THICKNESSMAP\n vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THI\
CKNESSMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_SHEEN_COLORMAP\n vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_SHE\
EN_ROUGHNESSMAP\n vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_SPECULARMAP\n vSpecularMapUv = ( \
specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_SPECULAR_COLORMAP\n vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_C\
OLORMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_SPECULAR_INTENSITYMAP\n vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) )\
.xy;\n#endif\n#ifdef USE_TRANSMISSIONMAP\n vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;\n#endif\n#ifdef USE_THICKNESSMAP\n vT\
hicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;\n#endif",Vv="#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOW\
MAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0\n vec4 worldPosition = vec4( transformed, 1.0 );\n #ifdef USE_BATCHING\n  worldPosition = batchi\
ngMatrix * worldPosition;\n #endif\n #ifdef USE_INSTANCING\n  worldPosition = instanceMatrix * worldPosition;\n #endif\n worldPosition = modelMatrix * worldPosition;\
\n#endif",Gv="varying vec2 vUv;\nuniform mat3 uvTransform;\nvoid main() {\n vUv = ( uvTransform * vec3( uv, 1 ) ).xy;\n gl_Position = vec4( position.xy, 1.0, 1.0 );\
\n}",Hv="uniform sampler2D t2D;\nuniform float backgroundIntensity;\nvarying vec2 vUv;\nvoid main() {\n vec4 texColor = texture2D( t2D, vUv );\n #ifdef DECODE_VIDEO_\
TEXTURE\n  texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texCol\
or.rgb, vec3( 0.04045 ) ) ) ), texColor.w );\n #endif\n texColor.rgb *= backgroundIntensity;\n gl_FragColor = texColor;\n #include <tonemapping_fragment>\n #include \
<colorspace_fragment>\n}",Wv="varying vec3 vWorldDirection;\n#include <common>\nvoid main() {\n vWorldDirection = transformDirection( position, modelMatrix );\n #in\
clude <begin_vertex>\n #include <project_vertex>\n gl_Position.z = gl_Position.w;\n}",Xv="uniform float backgroundBlurriness;\nuniform float backgroundIntensity;\
\nuniform mat3 backgroundRotation;\nvarying vec3 vWorldDirection;\n#include <envmap_common_pars_fragment>\nvoid main() {\n #ifdef ENVMAP_TYPE_PMREM\n  vec4 texColor =\
 textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );\n #else\n  vec4 texColor = textureCube( envMap, backgroundRot\
ation * vWorldDirection );\n #endif\n texColor.rgb *= backgroundIntensity;\n gl_FragColor = texColor;\n #include <tonemapping_fragment>\n #include <colorspace_fragme\
nt>\n}",qv="varying vec3 vWorldDirection;\n#include <common>\nvoid main() {\n vWorldDirection = transformDirection( position, modelMatrix );\n #include <begin_verte\
x>\n #include <project_vertex>\n gl_Position.z = gl_Position.w;\n}",Yv="uniform samplerCube tCube;\nuniform float tFlip;\nuniform float opacity;\nvarying vec3 vWor\
ldDirection;\nvoid main() {\n vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );\n gl_FragColor = texColor;\n gl_FragColor\
.a *= opacity;\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n}",Zv="#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_ve\
rtex>\n#include <displacementmap_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <cli\
pping_planes_pars_vertex>\nvarying vec2 vHighPrecisionZW;\nvoid main() {\n #include <uv_vertex>\n #include <batching_vertex>\n #include <skinbase_vertex>\n #include <\
morphinstance_vertex>\n #ifdef USE_DISPLACEMENTMAP\n  #include <beginnormal_vertex>\n  #include <morphnormal_vertex>\n  #include <skinnormal_vertex>\n #endif\n #inclu\
de <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #include <logdepthbu\
f_vertex>\n #include <clipping_planes_vertex>\n vHighPrecisionZW = gl_Position.zw;\n}",Jv="#if DEPTH_PACKING == 3200\n uniform float opacity;\n#endif\n#include <co\
mmon>\n#include <packing>\n#include <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include \
<alphahash_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvarying vec2 vHighPrecisionZW;\nvoid main() {\n vec4 diffu\
seColor = vec4( 1.0 );\n #include <clipping_planes_fragment>\n #if DEPTH_PACKING == 3200\n  diffuseColor.a = opacity;\n #endif\n #include <map_fragment>\n #include <a\
lphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n #include <logdepthbuf_fragment>\n #ifdef USE_REVERSED_DEPTH_BUFFER\n  float fragC\
oordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];\n #else\n  float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;\n #endif\n #if DEPTH\
_PACKING == 3200\n  gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );\n #elif DEPTH_PACKING == 3201\n  gl_FragColor = packDepthToRGBA( fragCoordZ );\n #elif\
 DEPTH_PACKING == 3202\n  gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );\n #elif DEPTH_PACKING == 3203\n  gl_FragColor = vec4( packDepthToRG( fragCoordZ\
 ), 0.0, 1.0 );\n #endif\n}",$v="#define DISTANCE\nvarying vec3 vWorldPosition;\n#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#incl\
ude <displacementmap_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #incl\
ude <uv_vertex>\n #include <batching_vertex>\n #include <skinbase_vertex>\n #include <morphinstance_vertex>\n #ifdef USE_DISPLACEMENTMAP\n  #include <beginnormal_ver\
tex>\n  #include <morphnormal_vertex>\n  #include <skinnormal_vertex>\n #endif\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n\
 #include <displacementmap_vertex>\n #include <project_vertex>\n #include <worldpos_vertex>\n #include <clipping_planes_vertex>\n vWorldPosition = worldPosition.xyz\
;\n}",Kv="#define DISTANCE\nuniform vec3 referencePosition;\nuniform float nearDistance;\nuniform float farDistance;\nvarying vec3 vWorldPosition;\n#include <common>\
\n#include <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fragment\
>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( 1.0 );\n #include <clipping_planes_fragment>\n #include <map_fragment>\n #inclu\
de <alphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n float dist = length( vWorldPosition - referencePosition );\n dist = ( dist \
- nearDistance ) / ( farDistance - nearDistance );\n dist = saturate( dist );\n gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );\n}",Qv="varying vec3 vWorldDirection\
;\n#include <common>\nvoid main() {\n vWorldDirection = transformDirection( position, modelMatrix );\n #include <begin_vertex>\n #include <project_vertex>\n}",jv="\
uniform sampler2D tEquirect;\nvarying vec3 vWorldDirection;\n#include <common>\nvoid main() {\n vec3 direction = normalize( vWorldDirection );\n vec2 sampleUV = equi\
rectUv( direction );\n gl_FragColor = texture2D( tEquirect, sampleUV );\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n}",ey="uniform float\
 scale;\nattribute float lineDistance;\nvarying float vLineDistance;\n#include <common>\n#include <uv_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_v\
ertex>\n#include <morphtarget_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n vLineDistance = scale * lineD\
istance;\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <begin_vertex>\n #include <morph\
target_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n #include <fog_vertex>\n}",ty="uniform vec3 diff\
use;\nuniform float opacity;\nuniform float dashSize;\nuniform float totalSize;\nvarying float vLineDistance;\n#include <common>\n#include <color_pars_fragment>\n#incl\
ude <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <fog_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nv\
oid main() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n if ( mod( vLineDistance, totalSize ) > dashSize ) {\n  discard;\
\n }\n vec3 outgoingLight = vec3( 0.0 );\n #include <logdepthbuf_fragment>\n #include <map_fragment>\n #include <color_fragment>\n outgoingLight = diffuseColor.rgb;\n \
#include <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n}",
ny="#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <envmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_ve\
rtex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\
\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <batching_vertex>\n #if defined ( USE_EN\
VMAP ) || defined ( USE_SKINNING )\n  #include <beginnormal_vertex>\n  #include <morphnormal_vertex>\n  #include <skinbase_vertex>\n  #include <skinnormal_vertex>\n \
 #include <defaultnormal_vertex>\n #endif\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <project_vertex>\n #includ\
e <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n #include <worldpos_vertex>\n #include <envmap_vertex>\n #include <fog_vertex>\n}",iy="uniform vec3 \
diffuse;\nuniform float opacity;\n#ifndef FLAT_SHADED\n varying vec3 vNormal;\n#endif\n#include <common>\n#include <dithering_pars_fragment>\n#include <color_pars_frag\
ment>\n#include <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fra\
gment>\n#include <aomap_pars_fragment>\n#include <lightmap_pars_fragment>\n#include <envmap_common_pars_fragment>\n#include <envmap_pars_fragment>\n#include <fog_par\
s_fragment>\n#include <specularmap_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor \
= vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n #include <logdepthbuf_fragment>\n #include <map_fragment>\n #include <color_fragment>\n #include \
<alphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n #include <specularmap_fragment>\n ReflectedLight reflectedLight = ReflectedLig\
ht( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );\n #ifdef USE_LIGHTMAP\n  vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );\n  reflectedLight.indir\
ectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;\n #else\n  reflectedLight.indirectDiffuse += vec3( 1.0 );\n #endif\n #include <aomap_fragment>\n\
 reflectedLight.indirectDiffuse *= diffuseColor.rgb;\n vec3 outgoingLight = reflectedLight.indirectDiffuse;\n #include <envmap_fragment>\n #include <opaque_fragmen\
t>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n #include <dithering_fragm\
ent>\n}",sy="#define LAMBERT\nvarying vec3 vViewPosition;\n#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <displacementmap_p\
ars_vertex>\n#include <envmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_vertex>\n#include <normal_pars_vertex>\n#include <morphtarget_pars_verte\
x>\n#include <skinning_pars_vertex>\n#include <shadowmap_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #in\
clude <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <batching_vertex>\n #include <beginnormal_ver\
tex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <normal_vertex>\n #inclu\
de <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #include <logdepthbu\
f_vertex>\n #include <clipping_planes_vertex>\n vViewPosition = - mvPosition.xyz;\n #include <worldpos_vertex>\n #include <envmap_vertex>\n #include <shadowmap_verte\
x>\n #include <fog_vertex>\n}",ry="#define LAMBERT\nuniform vec3 diffuse;\nuniform vec3 emissive;\nuniform float opacity;\n#include <common>\n#include <dithering_par\
s_fragment>\n#include <color_pars_fragment>\n#include <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_f\
ragment>\n#include <alphahash_pars_fragment>\n#include <aomap_pars_fragment>\n#include <lightmap_pars_fragment>\n#include <emissivemap_pars_fragment>\n#include <envm\
ap_common_pars_fragment>\n#include <envmap_pars_fragment>\n#include <envmap_physical_pars_fragment>\n#include <fog_pars_fragment>\n#include <bsdfs>\n#include <lights\
_pars_begin>\n#include <normal_pars_fragment>\n#include <lights_lambert_pars_fragment>\n#include <shadowmap_pars_fragment>\n#include <bumpmap_pars_fragment>\n#includ\
e <normalmap_pars_fragment>\n#include <specularmap_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n ve\
c4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3\
( 0.0 ), vec3( 0.0 ) );\n vec3 totalEmissiveRadiance = emissive;\n #include <logdepthbuf_fragment>\n #include <map_fragment>\n #include <color_fragment>\n #include <\
alphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n #include <specularmap_fragment>\n #include <normal_fragment_begin>\n #include <n\
ormal_fragment_maps>\n #include <emissivemap_fragment>\n #include <lights_lambert_fragment>\n #include <lights_fragment_begin>\n #include <lights_fragment_maps>\n #i\
nclude <lights_fragment_end>\n #include <aomap_fragment>\n vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadia\
nce;\n #include <envmap_fragment>\n #include <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include\
 <premultiplied_alpha_fragment>\n #include <dithering_fragment>\n}",oy="#define MATCAP\nvarying vec3 vViewPosition;\n#include <common>\n#include <batching_pars_ver\
tex>\n#include <uv_pars_vertex>\n#include <color_pars_vertex>\n#include <displacementmap_pars_vertex>\n#include <fog_pars_vertex>\n#include <normal_pars_vertex>\n#inc\
lude <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #include\
 <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n\
 #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <normal_vertex>\n #include <b\
egin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #include <logdepthbuf_ver\
tex>\n #include <clipping_planes_vertex>\n #include <fog_vertex>\n vViewPosition = - mvPosition.xyz;\n}",ay="#define MATCAP\nuniform vec3 diffuse;\nuniform float \
opacity;\nuniform sampler2D matcap;\nvarying vec3 vViewPosition;\n#include <common>\n#include <dithering_pars_fragment>\n#include <color_pars_fragment>\n#include <uv_\
pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fragment>\n#include <fo\
g_pars_fragment>\n#include <normal_pars_fragment>\n#include <bumpmap_pars_fragment>\n#include <normalmap_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#inclu\
de <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n #include <logdepthbuf_frag\
ment>\n #include <map_fragment>\n #include <color_fragment>\n #include <alphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n #include \
<normal_fragment_begin>\n #include <normal_fragment_maps>\n vec3 viewDir = normalize( vViewPosition );\n vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );\
\n vec3 y = cross( viewDir, x );\n vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;\n #ifdef USE_MATCAP\n  vec4 matcapColor = texture2D( matcap, \
uv );\n #else\n  vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );\n #endif\n vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;\n #include <opaqu\
e_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n #include <dither\
ing_fragment>\n}",ly="#define NORMAL\n#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )\n varying vec3 vViewPosition;\n\
#endif\n#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <displacementmap_pars_vertex>\n#include <normal_pars_vertex>\n#include\
 <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #include <uv\
_vertex>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include <morphinstance_vertex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n\
 #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <normal_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skin\
ning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n#if defined( FLAT_S\
HADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )\n vViewPosition = - mvPosition.xyz;\n#endif\n}",cy="#define NORMAL\nuniform float opac\
ity;\n#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )\n varying vec3 vViewPosition;\n#endif\n#include <uv_pars_fragmen\
t>\n#include <normal_pars_fragment>\n#include <bumpmap_pars_fragment>\n#include <normalmap_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_p\
lanes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );\n #include <clipping_planes_fragment>\n #include <logdepthbuf_fragment>\n #\
include <normal_fragment_begin>\n #include <normal_fragment_maps>\n gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );\n #ifdef OPAQUE\n  gl_Fr\
agColor.a = 1.0;\n #endif\n}",uy="#define PHONG\nvarying vec3 vViewPosition;\n#include <common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include\
 <displacementmap_pars_vertex>\n#include <envmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_vertex>\n#include <normal_pars_vertex>\n#include <mor\
phtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <shadowmap_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\
\nvoid main() {\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphcolor_vertex>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include\
 <morphinstance_vertex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <nor\
mal_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap_vertex>\n #include <project_vertex>\n #\
include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n vViewPosition = - mvPosition.xyz;\n #include <worldpos_vertex>\n #include <envmap_vertex>\n #inclu\
de <shadowmap_vertex>\n #include <fog_vertex>\n}",hy="#define PHONG\nuniform vec3 diffuse;\nuniform vec3 emissive;\nuniform vec3 specular;\nuniform float shininess;\
\nuniform float opacity;\n#include <common>\n#include <dithering_pars_fragment>\n#include <color_pars_fragment>\n#include <uv_pars_fragment>\n#include <map_pars_fragm\
ent>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fragment>\n#include <aomap_pars_fragment>\n#include <lightmap_p\
ars_fragment>\n#include <emissivemap_pars_fragment>\n#include <envmap_common_pars_fragment>\n#include <envmap_pars_fragment>\n#include <envmap_physical_pars_fragmen\
t>\n#include <fog_pars_fragment>\n#include <bsdfs>\n#include <lights_pars_begin>\n#include <normal_pars_fragment>\n#include <lights_phong_pars_fragment>\n#include <sh\
adowmap_pars_fragment>\n#include <bumpmap_pars_fragment>\n#include <normalmap_pars_fragment>\n#include <specularmap_pars_fragment>\n#include <logdepthbuf_pars_fragm\
ent>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n ReflectedLight \
reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );\n vec3 totalEmissiveRadiance = emissive;\n #include <logdepthbuf_fragment>\n\
 #include <map_fragment>\n #include <color_fragment>\n #include <alphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n #include <specu\
larmap_fragment>\n #include <normal_fragment_begin>\n #include <normal_fragment_maps>\n #include <emissivemap_fragment>\n #include <lights_phong_fragment>\n #include\
 <lights_fragment_begin>\n #include <lights_fragment_maps>\n #include <lights_fragment_end>\n #include <aomap_fragment>\n vec3 outgoingLight = reflectedLight.direct\
Diffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;\n #include <envmap_fragment>\n\
 #include <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n \
#include <dithering_fragment>\n}",fy="#define STANDARD\nvarying vec3 vViewPosition;\n#ifdef USE_TRANSMISSION\n varying vec3 vWorldPosition;\n#endif\n#include <common\
>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <displacementmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_vertex>\n#incl\
ude <normal_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <shadowmap_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n\
#include <clipping_planes_pars_vertex>\nvoid main() {\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_verte\
x>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include\
 <defaultnormal_vertex>\n #include <normal_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displacementmap\
_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n vViewPosition = - mvPosition.xyz;\n #include <worldpos_ver\
tex>\n #include <shadowmap_vertex>\n #include <fog_vertex>\n#ifdef USE_TRANSMISSION\n vWorldPosition = worldPosition.xyz;\n#endif\n}",dy="#define STANDARD\n#ifde\
f PHYSICAL\n #define IOR\n #define USE_SPECULAR\n#endif\nuniform vec3 diffuse;\nuniform vec3 emissive;\nuniform float roughness;\nuniform float metalness;\nuniform floa\
t opacity;\n#ifdef IOR\n uniform float ior;\n#endif\n#ifdef USE_SPECULAR\n uniform float specularIntensity;\n uniform vec3 specularColor;\n #ifdef USE_SPECULAR_COLORMA\
P\n  uniform sampler2D specularColorMap;\n #endif\n #ifdef USE_SPECULAR_INTENSITYMAP\n  uniform sampler2D specularIntensityMap;\n #endif\n#endif\n#ifdef USE_CLEARCOAT\n\
 uniform float clearcoat;\n uniform float clearcoatRoughness;\n#endif\n#ifdef USE_DIFFUSE_ROUGHNESS\n uniform float diffuseRoughness;\n #ifdef USE_DIFFUSE_ROUGHNESSM\
AP\n  uniform sampler2D diffuseRoughnessMap;\n #endif\n#endif\n#ifdef USE_DISPERSION\n uniform float dispersion;\n#endif\n#ifdef USE_RETROREFLECTION\n uniform float ret\
roreflectivity;\n#endif\n#ifdef USE_IRIDESCENCE\n uniform float iridescence;\n uniform float iridescenceIOR;\n uniform float iridescenceThicknessMinimum;\n uniform fl\
oat iridescenceThicknessMaximum;\n#endif\n#ifdef USE_SHEEN\n uniform vec3 sheenColor;\n uniform float sheenRoughness;\n #ifdef USE_SHEEN_COLORMAP\n  uniform sampler2D\
 sheenColorMap;\n #endif\n #ifdef USE_SHEEN_ROUGHNESSMAP\n  uniform sampler2D sheenRoughnessMap;\n #endif\n#endif\n#ifdef USE_ANISOTROPY\n uniform vec2 anisotropyVecto\
r;\n #ifdef USE_ANISOTROPYMAP\n  uniform sampler2D anisotropyMap;\n #endif\n#endif\nvarying vec3 vViewPosition;\n#include <common>\n#include <dithering_pars_fragment>\n\
#include <color_pars_fragment>\n#include <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#in\
clude <alphahash_pars_fragment>\n#include <aomap_pars_fragment>\n#include <lightmap_pars_fragment>\n#include <emissivemap_pars_fragment>\n#include <iridescence_frag\
ment>\n#include <envmap_common_pars_fragment>\n#include <envmap_physical_pars_fragment>\n#include <fog_pars_fragment>\n#include <lights_pars_begin>\n#include <normal\
_pars_fragment>\n#include <lights_physical_pars_fragment>\n#include <transmission_pars_fragment>\n#include <shadowmap_pars_fragment>\n#include <bumpmap_pars_fragmen\
t>\n#include <normalmap_pars_fragment>\n#include <clearcoat_pars_fragment>\n#include <iridescence_pars_fragment>\n#include <roughnessmap_pars_fragment>\n#include <me\
talnessmap_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( diffuse, opacit\
y );\n #include <clipping_planes_fragment>\n ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );\n vec3 totalEmis\
siveRadiance = emissive;\n #include <logdepthbuf_fragment>\n #include <map_fragment>\n #include <color_fragment>\n #include <alphamap_fragment>\n #include <alphatest\
_fragment>\n #include <alphahash_fragment>\n #include <roughnessmap_fragment>\n #include <metalnessmap_fragment>\n #include <normal_fragment_begin>\n #include <norma\
l_fragment_maps>\n #include <clearcoat_normal_fragment_begin>\n #include <clearcoat_normal_fragment_maps>\n #include <emissivemap_fragment>\n #include <lights_physi\
cal_fragment>\n #include <lights_fragment_begin>\n #include <lights_fragment_maps>\n #include <lights_fragment_end>\n #include <aomap_fragment>\n vec3 totalDiffuse =\
 reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;\n vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;\n #include\
 <transmission_fragment>\n vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;\n #ifdef USE_SHEEN\n \n  outgoingLight = outgoingLight + sheen\
SpecularDirect + sheenSpecularIndirect;\n \n  #endif\n #ifdef USE_CLEARCOAT\n  float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );\n  vec3 F\
cc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );\n  outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecul\
arDirect + clearcoatSpecularIndirect ) * material.clearcoat;\n #endif\n #include <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment\
>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n #include <dithering_fragment>\n}",py="#define TOON\nvarying vec3 vViewPosition;\n#include \
<common>\n#include <batching_pars_vertex>\n#include <uv_pars_vertex>\n#include <displacementmap_pars_vertex>\n#include <color_pars_vertex>\n#include <fog_pars_vertex\
>\n#include <normal_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <shadowmap_pars_vertex>\n#include <logdepthbuf_pars_v\
ertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #include <uv_vertex>\n #include <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolo\
r_vertex>\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #\
include <defaultnormal_vertex>\n #include <normal_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <skinning_vertex>\n #include <displace\
mentmap_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n vViewPosition = - mvPosition.xyz;\n #include <world\
pos_vertex>\n #include <shadowmap_vertex>\n #include <fog_vertex>\n}",my="#define TOON\nuniform vec3 diffuse;\nuniform vec3 emissive;\nuniform float opacity;\n#incl\
ude <common>\n#include <dithering_pars_fragment>\n#include <color_pars_fragment>\n#include <uv_pars_fragment>\n#include <map_pars_fragment>\n#include <alphamap_pars_\
fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fragment>\n#include <aomap_pars_fragment>\n#include <lightmap_pars_fragment>\n#include <emiss\
ivemap_pars_fragment>\n#include <gradientmap_pars_fragment>\n#include <fog_pars_fragment>\n#include <bsdfs>\n#include <lights_pars_begin>\n#include <normal_pars_frag\
ment>\n#include <lights_toon_pars_fragment>\n#include <shadowmap_pars_fragment>\n#include <bumpmap_pars_fragment>\n#include <normalmap_pars_fragment>\n#include <logd\
epthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment\
>\n ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );\n vec3 totalEmissiveRadiance = emissive;\n #include <logd\
epthbuf_fragment>\n #include <map_fragment>\n #include <color_fragment>\n #include <alphamap_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment\
>\n #include <normal_fragment_begin>\n #include <normal_fragment_maps>\n #include <emissivemap_fragment>\n #include <lights_toon_fragment>\n #include <lights_fragmen\
t_begin>\n #include <lights_fragment_maps>\n #include <lights_fragment_end>\n #include <aomap_fragment>\n vec3 outgoingLight = reflectedLight.directDiffuse + reflec\
tedLight.indirectDiffuse + totalEmissiveRadiance;\n #include <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fr\
agment>\n #include <premultiplied_alpha_fragment>\n #include <dithering_fragment>\n}",gy="uniform float size;\nuniform float scale;\n#include <common>\n#include <c\
olor_pars_vertex>\n#include <fog_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\n#ifdef\
 USE_POINTS_UV\n varying vec2 vUv;\n uniform mat3 uvTransform;\n#endif\nvoid main() {\n #ifdef USE_POINTS_UV\n  vUv = ( uvTransform * vec3( uv, 1 ) ).xy;\n #endif\n #in\
clude <color_vertex>\n #include <morphinstance_vertex>\n #include <morphcolor_vertex>\n #include <begin_vertex>\n #include <morphtarget_vertex>\n #include <project_v\
ertex>\n gl_PointSize = size;\n #ifdef USE_SIZEATTENUATION\n  bool isPerspective = isPerspectiveMatrix( projectionMatrix );\n  if ( isPerspective ) gl_PointSize *= \
( scale / - mvPosition.z );\n #endif\n #include <logdepthbuf_vertex>\n #include <clipping_planes_vertex>\n #include <worldpos_vertex>\n #include <fog_vertex>\n}",
_y="uniform vec3 diffuse;\nuniform float opacity;\n#include <common>\n#include <color_pars_fragment>\n#include <map_particle_pars_fragment>\n#include <alphatest_pars\
_fragment>\n#include <alphahash_pars_fragment>\n#include <fog_pars_fragment>\n#include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvoid ma\
in() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_planes_fragment>\n vec3 outgoingLight = vec3( 0.0 );\n #include <logdepthbuf_fragment>\n \
#include <map_particle_fragment>\n #include <color_fragment>\n #include <alphatest_fragment>\n #include <alphahash_fragment>\n outgoingLight = diffuseColor.rgb;\n #i\
nclude <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragment>\n #include <premultiplied_alpha_fragment>\n}",
xy="#include <common>\n#include <batching_pars_vertex>\n#include <fog_pars_vertex>\n#include <morphtarget_pars_vertex>\n#include <skinning_pars_vertex>\n#include <lo\
gdepthbuf_pars_vertex>\n#include <shadowmap_pars_vertex>\nvoid main() {\n #include <batching_vertex>\n #include <beginnormal_vertex>\n #include <morphinstance_vertex\
>\n #include <morphnormal_vertex>\n #include <skinbase_vertex>\n #include <skinnormal_vertex>\n #include <defaultnormal_vertex>\n #include <begin_vertex>\n #include <\
morphtarget_vertex>\n #include <skinning_vertex>\n #include <project_vertex>\n #include <logdepthbuf_vertex>\n #include <worldpos_vertex>\n #include <shadowmap_verte\
x>\n #include <fog_vertex>\n}",vy="uniform vec3 color;\nuniform float opacity;\n#include <common>\n#include <fog_pars_fragment>\n#include <bsdfs>\n#include <lights_p\
ars_begin>\n#include <logdepthbuf_pars_fragment>\n#include <shadowmap_pars_fragment>\n#include <shadowmask_pars_fragment>\nvoid main() {\n #include <logdepthbuf_frag\
ment>\n gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );\n #include <tonemapping_fragment>\n #include <colorspace_fragment>\n #include <fog_fragme\
nt>\n #include <premultiplied_alpha_fragment>\n}",yy="uniform float rotation;\nuniform vec2 center;\n#include <common>\n#include <uv_pars_vertex>\n#include <fog_par\
s_vertex>\n#include <logdepthbuf_pars_vertex>\n#include <clipping_planes_pars_vertex>\nvoid main() {\n #include <uv_vertex>\n vec4 mvPosition = modelViewMatrix[ 3 ];\
\n vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );\n #ifndef USE_SIZEATTENUATION\n  bool isPerspective = isPerspectiveMatrix( \
projectionMatrix );\n  if ( isPerspective ) scale *= - mvPosition.z;\n #endif\n vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;\n vec2 ro\
tatedPosition;\n rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;\n rotatedPosition.y = sin( rotation ) * alignedPos\
ition.x + cos( rotation ) * alignedPosition.y;\n mvPosition.xy += rotatedPosition;\n gl_Position = projectionMatrix * mvPosition;\n #include <logdepthbuf_vertex>\n \
#include <clipping_planes_vertex>\n #include <fog_vertex>\n}",Sy="uniform vec3 diffuse;\nuniform float opacity;\n#include <common>\n#include <uv_pars_fragment>\n#in\
clude <map_pars_fragment>\n#include <alphamap_pars_fragment>\n#include <alphatest_pars_fragment>\n#include <alphahash_pars_fragment>\n#include <fog_pars_fragment>\n#\
include <logdepthbuf_pars_fragment>\n#include <clipping_planes_pars_fragment>\nvoid main() {\n vec4 diffuseColor = vec4( diffuse, opacity );\n #include <clipping_pl\
anes_fragment>\n vec3 outgoingLight = vec3( 0.0 );\n #include <logdepthbuf_fragment>\n #include <map_fragment>\n #include <alphamap_fragment>\n #include <alphatest_f\
ragment>\n #include <alphahash_fragment>\n outgoingLight = diffuseColor.rgb;\n #include <opaque_fragment>\n #include <tonemapping_fragment>\n #include <colorspace_fr\
agment>\n #include <fog_fragment>\n}",lt={alphahash_fragment:H_,alphahash_pars_fragment:W_,alphamap_fragment:X_,alphamap_pars_fragment:q_,alphatest_fragment:Y_,
alphatest_pars_fragment:Z_,aomap_fragment:J_,aomap_pars_fragment:$_,batching_pars_vertex:K_,batching_vertex:Q_,begin_vertex:j_,beginnormal_vertex:ex,bsdfs:tx,iridescence_fragment:nx,
bumpmap_pars_fragment:ix,clipping_planes_fragment:sx,clipping_planes_pars_fragment:rx,clipping_planes_pars_vertex:ox,clipping_planes_vertex:ax,color_fragment:lx,
color_pars_fragment:cx,color_pars_vertex:ux,color_vertex:hx,common:fx,defaultnormal_vertex:dx,displacementmap_pars_vertex:px,displacementmap_vertex:mx,emissivemap_fragment:gx,
emissivemap_pars_fragment:_x,colorspace_fragment:xx,colorspace_pars_fragment:vx,envmap_fragment:yx,envmap_common_pars_fragment:Sx,envmap_pars_fragment:Mx,envmap_pars_vertex:bx,
envmap_physical_pars_fragment:Nx,envmap_vertex:wx,fog_vertex:Tx,fog_pars_vertex:Ax,fog_fragment:Ex,fog_pars_fragment:Cx,gradientmap_pars_fragment:Rx,lightmap_pars_fragment:Px,
lights_lambert_fragment:Ix,lights_lambert_pars_fragment:Lx,lights_pars_begin:Dx,lights_toon_fragment:Ux,lights_toon_pars_fragment:Fx,lights_phong_fragment:Ox,lights_phong_pars_fragment:Bx,
lights_physical_fragment:zx,lights_physical_pars_fragment:kx,lights_fragment_begin:Vx,lights_fragment_maps:Gx,lights_fragment_end:Hx,lightprobes_pars_fragment:Wx,
logdepthbuf_fragment:Xx,logdepthbuf_pars_fragment:qx,logdepthbuf_pars_vertex:Yx,logdepthbuf_vertex:Zx,map_fragment:Jx,map_pars_fragment:$x,map_particle_fragment:Kx,
map_particle_pars_fragment:Qx,metalnessmap_fragment:jx,metalnessmap_pars_fragment:ev,morphinstance_vertex:tv,morphcolor_vertex:nv,morphnormal_vertex:iv,morphtarget_pars_vertex:sv,
morphtarget_vertex:rv,normal_fragment_begin:ov,normal_fragment_maps:av,normal_pars_fragment:lv,normal_pars_vertex:cv,normal_vertex:uv,normalmap_pars_fragment:hv,
clearcoat_normal_fragment_begin:fv,clearcoat_normal_fragment_maps:dv,clearcoat_pars_fragment:pv,iridescence_pars_fragment:mv,opaque_fragment:gv,packing:_v,premultiplied_alpha_fragment:xv,
project_vertex:vv,dithering_fragment:yv,dithering_pars_fragment:Sv,roughnessmap_fragment:Mv,roughnessmap_pars_fragment:bv,shadowmap_pars_fragment:wv,shadowmap_pars_vertex:Tv,
shadowmap_vertex:Av,shadowmask_pars_fragment:Ev,skinbase_vertex:Cv,skinning_pars_vertex:Rv,skinning_vertex:Pv,skinnormal_vertex:Iv,specularmap_fragment:Lv,specularmap_pars_fragment:Dv,
tonemapping_fragment:Nv,tonemapping_pars_fragment:Uv,transmission_fragment:Fv,transmission_pars_fragment:Ov,uv_pars_fragment:Bv,uv_pars_vertex:zv,uv_vertex:kv,worldpos_vertex:Vv,
background_vert:Gv,background_frag:Hv,backgroundCube_vert:Wv,backgroundCube_frag:Xv,cube_vert:qv,cube_frag:Yv,depth_vert:Zv,depth_frag:Jv,distance_vert:$v,distance_frag:Kv,
equirect_vert:Qv,equirect_frag:jv,linedashed_vert:ey,linedashed_frag:ty,meshbasic_vert:ny,meshbasic_frag:iy,meshlambert_vert:sy,meshlambert_frag:ry,meshmatcap_vert:oy,
meshmatcap_frag:ay,meshnormal_vert:ly,meshnormal_frag:cy,meshphong_vert:uy,meshphong_frag:hy,meshphysical_vert:fy,meshphysical_frag:dy,meshtoon_vert:py,meshtoon_frag:my,
points_vert:gy,points_frag:_y,shadow_vert:xy,shadow_frag:vy,sprite_vert:yy,sprite_frag:Sy},Ie={common:{diffuse:{value:new st(16777215)},opacity:{value:1},map:{value:null},
mapTransform:{value:new Qe},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{
value:new Qe}},envmap:{envMap:{value:null},envMapRotation:{value:new Qe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},
aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{
value:new Qe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qe},
normalScale:{value:new ft(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qe},displacementScale:{value:1},displacementBias:{
value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qe}},
roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},
fogFar:{value:2e3},fogColor:{value:new st(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},
sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{
value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},
shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},
penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{
value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,
shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],
properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},
probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new st(16777215)},opacity:{value:1},size:{value:1},
scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0},uvTransform:{value:new Qe}},sprite:{diffuse:{value:new st(
16777215)},opacity:{value:1},center:{value:new ft(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qe},alphaMap:{value:null},alphaMapTransform:{
value:new Qe},alphaTest:{value:0}}},Oi={basic:{uniforms:En([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.fog]),vertexShader:lt.meshbasic_vert,fragmentShader:lt.
meshbasic_frag},lambert:{uniforms:En([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.
lights,{emissive:{value:new st(0)},envMapIntensity:{value:1}}]),vertexShader:lt.meshlambert_vert,fragmentShader:lt.meshlambert_frag},phong:{uniforms:En([Ie.common,
Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new st(0)},specular:{value:new st(
1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:lt.meshphong_vert,fragmentShader:lt.meshphong_frag},standard:{uniforms:En([Ie.common,Ie.
envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.roughnessmap,Ie.metalnessmap,Ie.fog,Ie.lights,{emissive:{value:new st(0)},
roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag},toon:{uniforms:En([Ie.
common,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.gradientmap,Ie.fog,Ie.lights,{emissive:{value:new st(0)}}]),vertexShader:lt.
meshtoon_vert,fragmentShader:lt.meshtoon_frag},matcap:{uniforms:En([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,{matcap:{value:null}}]),vertexShader:lt.
meshmatcap_vert,fragmentShader:lt.meshmatcap_frag},points:{uniforms:En([Ie.points,Ie.fog]),vertexShader:lt.points_vert,fragmentShader:lt.points_frag},dashed:{uniforms:En(
[Ie.common,Ie.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:lt.linedashed_vert,fragmentShader:lt.linedashed_frag},depth:{uniforms:En(
[Ie.common,Ie.displacementmap]),vertexShader:lt.depth_vert,fragmentShader:lt.depth_frag},normal:{uniforms:En([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,
{opacity:{value:1}}]),vertexShader:lt.meshnormal_vert,fragmentShader:lt.meshnormal_frag},sprite:{uniforms:En([Ie.sprite,Ie.fog]),vertexShader:lt.sprite_vert,fragmentShader:lt.
sprite_frag},background:{uniforms:{uvTransform:{value:new Qe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:lt.background_vert,fragmentShader:lt.
background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qe}},vertexShader:lt.
backgroundCube_vert,fragmentShader:lt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:lt.cube_vert,fragmentShader:lt.
cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:lt.equirect_vert,fragmentShader:lt.equirect_frag},distance:{uniforms:En([Ie.common,Ie.displacementmap,
{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:lt.distance_vert,fragmentShader:lt.distance_frag},shadow:{uniforms:En(
[Ie.lights,Ie.fog,{color:{value:new st(0)},opacity:{value:1}}]),vertexShader:lt.shadow_vert,fragmentShader:lt.shadow_frag}};Oi.physical={uniforms:En([Oi.standard.
uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qe},
clearcoatNormalScale:{value:new ft(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qe},diffuseRoughness:{
value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Qe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{
value:null},iridescenceMapTransform:{value:new Qe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{
value:null},iridescenceThicknessMapTransform:{value:new Qe},sheen:{value:0},sheenColor:{value:new st(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qe},
sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{
value:new Qe},transmissionSamplerSize:{value:new ft},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qe},
attenuationDistance:{value:0},attenuationColor:{value:new st(0)},specularColor:{value:new st(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qe},
specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qe},anisotropyVector:{value:new ft},anisotropyMap:{value:null},
anisotropyMapTransform:{value:new Qe}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag};var dc={r:0,b:0,g:0},My=new bt,Sm=new Qe;Sm.set(
-1,0,0,0,1,0,0,0,1);function by(i,e,t,n,s,r){let o=new st(0),a=s===!0?0:1,c,l,u=null,f=0,h=null;function d(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){
let M=v.backgroundBlurriness>0;A=e.get(A,M)}return A}function x(v){let A=!1,M=d(v);M===null?p(o,a):M&&M.isColor&&(p(M,1),A=!0);let P=i.xr.getEnvironmentBlendMode();
P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.
depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function S(v,A){let M=d(A);M&&M.isCubeTexture?(l===
void 0&&(l=new ri(new Ss(1,1,1),new Di({name:"BackgroundCubeMaterial",uniforms:Xs(Oi.backgroundCube.uniforms),vertexShader:Oi.backgroundCube.vertexShader,fragmentShader:Oi.
backgroundCube.fragmentShader,side:Fn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),
l.onBeforeRender=function(P,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.
value}}),n.update(l)),l.material.uniforms.envMap.value=M,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.
value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(My.makeRotationFromEuler(A.backgroundRotation)).transpose(),M.isRenderTargetTexture===
!1&&l.material.uniforms.backgroundRotation.value.premultiply(Sm),l.material.toneMapped=gt.getTransfer(M.colorSpace)!==Tt,(u!==M||f!==M.version||h!==i.toneMapping)&&
(l.material.needsUpdate=!0,u=M,f=M.version,h=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null)):M&&M.isTexture&&(c===void 0&&(c=new ri(
new Io(2,2),new Di({name:"BackgroundMaterial",uniforms:Xs(Oi.background.uniforms),vertexShader:Oi.background.vertexShader,fragmentShader:Oi.background.fragmentShader,
side:Ts,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.
uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=M,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=gt.
getTransfer(M.colorSpace)!==Tt,M.matrixAutoUpdate===!0&&M.updateMatrix(),c.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||f!==M.version||h!==i.toneMapping)&&
(c.material.needsUpdate=!0,u=M,f=M.version,h=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null))}function p(v,A){v.getRGB(dc,fh(i)),
t.buffers.color.setClear(dc.r,dc.g,dc.b,A,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.
dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){
a=v,p(o,a)},render:x,addToRenderList:S,dispose:m}}function wy(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=h(null),r=s,o=!1;function a(L,V,H,N,G){let J=!1,
k=f(L,N,H,V);r!==k&&(r=k,l(r.object)),J=d(L,N,H,G),J&&x(L,N,H,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(J||o)&&(o=!1,M(L,V,H,N),G!==null&&i.bindBuffer(i.
ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function c(){return i.createVertexArray()}function l(L){return i.bindVertexArray(L)}function u(L){return i.deleteVertexArray(
L)}function f(L,V,H,N){let G=N.wireframe===!0,J=n[V.id];J===void 0&&(J={},n[V.id]=J);let k=L.isInstancedMesh===!0?L.id:0,le=J[k];le===void 0&&(le={},J[k]=le);let $=le[H.
id];$===void 0&&($={},le[H.id]=$);let Q=$[G];return Q===void 0&&(Q=h(c()),$[G]=Q),Q}function h(L){let V=[],H=[],N=[];for(let G=0;G<t;G++)V[G]=0,H[G]=0,N[G]=0;return{
geometry:null,program:null,wireframe:!1,newAttributes:V,enabledAttributes:H,attributeDivisors:N,object:L,attributes:{},index:null}}function d(L,V,H,N){let G=r.attributes,
J=V.attributes,k=0,le=H.getAttributes();for(let $ in le)if(le[$].location>=0){let ie=G[$],he=J[$];if(he===void 0&&($==="instanceMatrix"&&L.instanceMatrix&&(he=L.
instanceMatrix),$==="instanceColor"&&L.instanceColor&&(he=L.instanceColor)),ie===void 0||ie.attribute!==he||he&&ie.data!==he.data)return!0;k++}return r.attributesNum!==
k||r.index!==N}function x(L,V,H,N){let G={},J=V.attributes,k=0,le=H.getAttributes();for(let $ in le)if(le[$].location>=0){let ie=J[$];ie===void 0&&($==="instanc\
eMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),$==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let he={};he.attribute=ie,ie&&ie.data&&(he.data=ie.
data),G[$]=he,k++}r.attributes=G,r.attributesNum=k,r.index=N}function S(){let L=r.newAttributes;for(let V=0,H=L.length;V<H;V++)L[V]=0}function p(L){m(L,0)}function m(L,V){
let H=r.newAttributes,N=r.enabledAttributes,G=r.attributeDivisors;H[L]=1,N[L]===0&&(i.enableVertexAttribArray(L),N[L]=1),G[L]!==V&&(i.vertexAttribDivisor(L,V),G[L]=
V)}function v(){let L=r.newAttributes,V=r.enabledAttributes;for(let H=0,N=V.length;H<N;H++)V[H]!==L[H]&&(i.disableVertexAttribArray(H),V[H]=0)}function A(L,V,H,N,G,J,k){
k===!0?i.vertexAttribIPointer(L,V,H,G,J):i.vertexAttribPointer(L,V,H,N,G,J)}function M(L,V,H,N){S();let G=N.attributes,J=H.getAttributes(),k=V.defaultAttributeValues;
for(let le in J){let $=J[le];if($.location>=0){let Q=G[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.
instanceColor&&(Q=L.instanceColor)),Q!==void 0){let ie=Q.normalized,he=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let j=ue.buffer,pe=ue.type,_e=ue.bytesPerElement,
Ae=pe===i.INT||pe===i.UNSIGNED_INT||Q.gpuType===Rl;if(Q.isInterleavedBufferAttribute){let Se=Q.data,Ge=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,tt=Q.offset;
if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let ke=0;ke<$.locationSize;ke++)m($.location+ke,Se.meshPerAttribute);L.isInstancedMesh!==
!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let ke=0;ke<$.locationSize;ke++)p($.location+ke);i.bindBuffer(i.ARRAY_BUFFER,
j);for(let ke=0;ke<$.locationSize;ke++)A($.location+ke,he/$.locationSize,pe,ie,Ge*_e,(tt+he/$.locationSize*ke)*_e,Ae)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<
$.locationSize;Se++)m($.location+Se,Q.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else
for(let Se=0;Se<$.locationSize;Se++)p($.location+Se);i.bindBuffer(i.ARRAY_BUFFER,j);for(let Se=0;Se<$.locationSize;Se++)A($.location+Se,he/$.locationSize,pe,ie,
he*_e,he/$.locationSize*Se*_e,Ae)}}else if(k!==void 0){let ie=k[le];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv($.location,ie);break;case 3:i.vertexAttrib3fv(
$.location,ie);break;case 4:i.vertexAttrib4fv($.location,ie);break;default:i.vertexAttrib1fv($.location,ie)}}}}v()}function P(){O();for(let L in n){let V=n[L];for(let H in V){
let N=V[H];for(let G in N){let J=N[G];for(let k in J)u(J[k].object),delete J[k];delete N[G]}}delete n[L]}}function E(L){if(n[L.id]===void 0)return;let V=n[L.id];
for(let H in V){let N=V[H];for(let G in N){let J=N[G];for(let k in J)u(J[k].object),delete J[k];delete N[G]}}delete n[L.id]}function _(L){for(let V in n){let H=n[V];
for(let N in H){let G=H[N];if(G[L.id]===void 0)continue;let J=G[L.id];for(let k in J)u(J[k].object),delete J[k];delete G[L.id]}}}function T(L){for(let V in n){let H=n[V],
N=L.isInstancedMesh===!0?L.id:0,G=H[N];if(G!==void 0){for(let J in G){let k=G[J];for(let le in k)u(k[le].object),delete k[le];delete G[J]}delete H[N],Object.keys(
H).length===0&&delete n[V]}}}function O(){D(),o=!0,r!==s&&(r=s,l(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:D,
dispose:P,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:S,enableAttribute:p,disableUnusedAttributes:v}}function Ty(i,e,t){
let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),t.update(l,n,1)}function o(c,l,u){u!==0&&(i.drawArraysInstanced(n,c,l,u),t.update(l,n,u))}function a(c,l,u){
if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,u);let h=0;for(let d=0;d<u;d++)h+=l[d];t.update(h,n,1)}this.setMode=s,this.render=r,this.
renderInstances=o,this.renderMultiDraw=a}function Ay(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.
get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==yi&&n.convert(_)!==i.getParameter(
i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===vi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Bn&&_!==oi&&
!T&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>
0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,
i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"h\
ighp",u=c(l);u!==l&&(qe("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===
!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to def\
ault depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.
getParameter(i.MAX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),
m=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),
P=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,
precision:l,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:x,maxTextureSize:S,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:v,
maxVaryings:A,maxFragmentUniforms:M,maxSamples:P,samples:E}}function Ey(i){let e=this,t=null,n=0,s=!1,r=!1,o=new gi,a=new Qe,c={value:null,needsUpdate:!1};this.
uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||n!==0||s;return s=h,n=f.length,d},this.beginShadows=function(){
r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let x=f.clippingPlanes,S=f.clipIntersection,
p=f.clipShadows,m=i.get(f);if(!s||x===null||x.length===0||r&&!p)r?u(null):l();else{let v=r?0:n,A=v*4,M=m.clippingState||null;c.value=M,M=u(x,h,A,d);for(let P=0;P!==
A;++P)M[P]=t[P];m.clippingState=M,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=v}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=
n,e.numIntersection=0}function u(f,h,d,x){let S=f!==null?f.length:0,p=null;if(S!==0){if(p=c.value,x!==!0||p===null){let m=d+S*4,v=h.matrixWorldInverse;a.getNormalMatrix(
v),(p===null||p.length<m)&&(p=new Float32Array(m));for(let A=0,M=d;A!==S;++A,M+=4)o.copy(f[A]).applyMatrix4(v,a),o.normal.toArray(p,M),p[M+3]=o.constant}c.value=
p,c.needsUpdate=!0}return e.numPlanes=S,e.numIntersection=0,p}}var Qo=class extends $n{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={
width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Eo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){
this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=
t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:"\n\n    varying vec3 vWorldDirection;\n\n    vec3 transformDirection( in vec3 dir, in mat4 matrix\
 ) {\n\n     return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );\n\n    }\n\n    void main() {\n\n     vWorldDirection = transformDirection( position, modelMatrix );\
\n\n     #include <begin_vertex>\n     #include <project_vertex>\n\n    }\n   ",fragmentShader:"\n\n    uniform sampler2D tEquirect;\n\n    varying vec3 vWorldDirec\
tion;\n\n    #include <common>\n\n    void main() {\n\n     vec3 direction = normalize( vWorldDirection );\n\n     vec2 sampleUV = equirectUv( direction );\n\n     gl_Fra\
gColor = texture2D( tEquirect, sampleUV );\n\n    }\n   "},s=new Ss(5,5,5),r=new Di({name:"CubemapFromEquirect",uniforms:Xs(n.uniforms),vertexShader:n.vertexShader,
fragmentShader:n.fragmentShader,side:Fn,blending:Vs});r.uniforms.tEquirect.value=t;let o=new ri(s,r),a=t.minFilter;return t.minFilter===is&&(t.minFilter=Un),new Fr(
1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(
this,o),e.clear(t,n,s);e.setRenderTarget(r)}},jp=256,Cy=3,Ry=20,Mm=256,bm=16,Py=3,Iy=new q,Ly=new st,mc=class i{constructor(e){this._renderer=e,this._cubeSize=0,
this._sourceTarget=null,this._cubeCamera=new Fr(1,10,null),this._boxMesh=new ri(new Ss(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this.
_blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=Iy}=r,c=this._renderer;this.
_setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,h=c.autoClearColor,d=c.autoClearDepth,
x=c.autoClearStencil,S=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,S===null&&(e.background=c.getClearColor(Ly));let p=new Fr(
n,s,u);return p.position.copy(a),p.update(c,e),c.autoClear=f,c.autoClearColor=h,c.autoClearDepth=d,c.autoClearStencil=x,e.background=S,t>0&&(u.texture.mipmapsAutoUpdate=
!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){
this._cubemapMaterial===null&&(this._cubemapMaterial=nm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===
null&&(this._equirectMaterial=tm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==
null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this.
_ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){
return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(jp,Zp(e))}_fromTexture(e,t){e.mapping===Hs||e.mapping===zr?this._setSize(e.image.length===0?
jp:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),
n}_allocateTarget(){let e=this._cubeSize,t=em(e,!1,!1),n=Math.log2(e)-Cy;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.
name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&
(n!==null&&n.dispose(),this._sourceTarget=em(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this.
_cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.
set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Hs||e.mapping===zr?(this._cubemapMaterial===
null&&(this._cubemapMaterial=nm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this.
_equirectMaterial=tm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&
(this._ggxMaterial=Dy(),this._integrationMaterial=Ny());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.
texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/bm);for(let o=0;o<=n;o++){let a=i.lodToRoughness(
o,n);if(o>n-Py)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(Mm*Math.pow(a,4)))+.5:0;s.roughness.
value=a,s.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Uy());let n=this._blurMaterial,s=n.
uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(
r,0,n)}};function em(i,e,t){return new Qo(i,{minFilter:is,generateMipmaps:e,type:vi,colorSpace:go,depthBuffer:t})}function jo(i,e,t){return new Di({name:i,uniforms:e,
vertexShader:lt.cube_vert,fragmentShader:t,side:Fn,blending:Vs,depthTest:!1,depthWrite:!1})}function Dy(){return jo("PMREMGGXConvolution",{envMap:{value:null},roughness:{
value:0},lodBias:{value:0}},"\n\n  #define GGX_SAMPLES ".concat(Mm,"u\n\n  varying vec3 vWorldDirection;\n\n  uniform samplerCube envMap;\n  uniform float roughness;\
\n  uniform float lodBias;\n\n  #include <common>\n\n  // Van der Corput radical inverse\n  float radicalInverse_VdC( uint bits ) {\n\n   bits = ( bits << 16u ) | ( bit\
s >> 16u );\n   bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );\n   bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu )\
 >> 2u );\n   bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );\n   bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >\
> 8u );\n   return float( bits ) * 2.3283064365386963e-10; // / 0x100000000\n\n  }\n\n  // Hammersley sequence\n  vec2 hammersley( uint i, uint N ) {\n\n   return vec2(\
 float( i ) / float( N ), radicalInverse_VdC( i ) );\n\n  }\n\n  void main() {\n\n   vec3 N = normalize( vWorldDirection );\n\n   // For very low roughness, just sample\
 the environment directly\n   if ( roughness < 0.001 ) {\n\n    gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );\n    return;\n\n   }\n\n   float alpha = r\
oughness * roughness;\n   float alpha2 = alpha * alpha;\n\n   // Tangent space basis for VNDF sampling\n   vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : ve\
c3( 1.0, 0.0, 0.0 );\n   vec3 tangent = normalize( cross( up, N ) );\n   vec3 bitangent = cross( N, tangent );\n\n   vec3 prefilteredColor = vec3( 0.0 );\n   float t\
otalWeight = 0.0;\n\n   for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {\n\n    vec2 Xi = hammersley( i, GGX_SAMPLES );\n\n    // With V = N, sample the reflected directi\
on directly.\n    float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );\n    float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;\n\n    if ( NdotL > 0.0 ) {\n\n     flo\
at phi = 2.0 * PI * Xi.y;\n     float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;\n     vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent\
 * sin( phi ) ) * sinTheta;\n\n     // Match the source mip to the sample's solid angle. The terms\n     // independent of the sample are precomputed in lodBias.\n \
    float d = alpha2 * invQ;\n     float lod = max( log2( d ) + lodBias, 0.0 );\n\n     // Weight by NdotL for the split-sum approximation\n     prefilteredColor +=\
 textureLod( envMap, L, lod ).rgb * NdotL;\n     totalWeight += NdotL;\n\n    }\n\n   }\n\n   gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );\n\n  }\n "))}
function Ny(){return jo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:bm}},"\n\n  varying vec3 vWorldDirect\
ion;\n\n  uniform samplerCube envMap;\n  uniform float roughness;\n  uniform float sourceLod;\n  uniform int sourceSize;\n\n  void main() {\n\n   vec3 N = normalize( vWo\
rldDirection );\n\n   float alpha = roughness * roughness;\n   float alpha2 = alpha * alpha;\n\n   float texelSize = 2.0 / float( sourceSize );\n\n   vec3 prefilteredC\
olor = vec3( 0.0 );\n   float totalWeight = 0.0;\n\n   // Pair opposite texels: only the one in N's hemisphere contributes.\n   for ( int face = 0; face < 3; face +\
+ ) {\n\n    for ( int y = 0; y < sourceSize; y ++ ) {\n\n     for ( int x = 0; x < sourceSize; x ++ ) {\n\n      vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;\n\
      vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );\n\n      float invDistance = inversesqrt( 1.0\
 + dot( uv, uv ) );\n      float NdotL = dot( N, texelDirection );\n      texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;\n      NdotL = abs( NdotL ) * invDistance;\n\n\
      // With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors\n      // in the GGX distribution and texel solid angle cancel when normalized.\n      flo\
at d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;\n      float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );\n\n      prefilteredColor += tex\
tureLod( envMap, texelDirection, sourceLod ).rgb * weight;\n      totalWeight += weight;\n\n     }\n\n    }\n\n   }\n\n   gl_FragColor = vec4( prefilteredColor / totalWe\
ight, 1.0 );\n\n  }\n ")}function Uy(){return jo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},"\n\n  #define SAMPLES ".concat(Ry,"\n  #defi\
ne GOLDEN_ANGLE 2.39996322973\n\n  varying vec3 vWorldDirection;\n\n  uniform samplerCube envMap;\n  uniform float sigma;\n\n  #include <common>\n\n  void main() {\n\n   v\
ec3 outputDirection = normalize( vWorldDirection );\n\n   vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );\n   vec3 tang\
ent = normalize( cross( up, outputDirection ) );\n   vec3 bitangent = cross( outputDirection, tangent );\n\n   // Truncate the kernel at three standard deviations \
or at the antipode.\n   float thetaMax = min( 3.0 * sigma, PI );\n   float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );\n\n   vec3 acc\
umColor = vec3( 0.0 );\n   float accumWeight = 0.0;\n\n   for ( int i = 0; i < SAMPLES; i ++ ) {\n\n    // Stratified inverse-CDF sampling of the Gaussian, placed on\
 a golden-angle spiral.\n    float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );\n    float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) )\
;\n    float phi = float( i ) * GOLDEN_ANGLE;\n\n    vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;\n    vec3 sampleDirection = cos( theta ) * outputD\
irection + sin( theta ) * offset;\n\n    // Correct the planar sample density to solid angle.\n    float weight = sin( theta ) / theta;\n\n    accumColor += weight *\
 textureLod( envMap, sampleDirection, 0.0 ).rgb;\n    accumWeight += weight;\n\n   }\n\n   gl_FragColor = vec4( accumColor / accumWeight, 1.0 );\n\n  }\n "))}function tm(){
return jo("PMREMEquirectangularToCubemap",{envMap:{value:null}},"\n\n  varying vec3 vWorldDirection;\n\n  uniform sampler2D envMap;\n\n  #include <common>\n\n  void mai\
n() {\n\n   // Average four subpixel samples to preserve small, bright features.\n   vec3 direction = normalize( vWorldDirection );\n   vec3 dx = dFdx( direction ) \
* 0.25;\n   vec3 dy = dFdy( direction ) * 0.25;\n\n   vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;\n   color += textu\
reLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;\n   color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).\
rgb;\n   color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;\n   gl_FragColor = vec4( color * 0.25, 1.0 );\n\n  }\n ")}function nm(){
return jo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},"\n\n  varying vec3 vWorldDirection;\n\n  uniform samplerCube envMap;\n  uniform float \
flipEnvMap;\n\n  void main() {\n\n   gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );\n\n  }\n ")}
function Fy(i){let e=new WeakMap,t=new WeakMap,n=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===
Al||d===El)if(e.has(h)){let x=e.get(h).texture;return a(x,h.mapping)}else{let x=h.image;if(x&&x.height>0){let S=new Qo(x.height);return S.fromEquirectangularTexture(
i,h),e.set(h,S),h.addEventListener("dispose",l),a(S.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.
mapping,x=d===Al||d===El,S=d===Hs||d===zr;if(x||S){let p=t.get(h),m=p!==void 0?p.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return n===
null&&(n=new mc(i)),p=x?n.fromEquirectangular(h,p):n.fromCubemap(h,p),p.texture.pmremVersion=h.pmremVersion,t.set(h,p),p.texture;if(p!==void 0)return p.texture;
{let v=h.image;return x&&v&&v.height>0||S&&v&&c(v)?(n===null&&(n=new mc(i)),p=x?n.fromEquirectangular(h):n.fromCubemap(h),p.texture.pmremVersion=h.pmremVersion,
t.set(h,p),h.addEventListener("dispose",u),p.texture):null}}}return h}function a(h,d){return d===Al?h.mapping=Hs:d===El&&(h.mapping=zr),h}function c(h){let d=0,
x=6;for(let S=0;S<x;S++)h[S]!==void 0&&d++;return d===x}function l(h){let d=h.target;d.removeEventListener("dispose",l);let x=e.get(d);x!==void 0&&(e.delete(d),
x.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let x=t.get(d);x!==void 0&&(t.delete(d),x.dispose())}function f(){e=new WeakMap,t=new WeakMap,
n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function Oy(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,
s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_colo\
r_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&po("WebGLRenderer\
: "+n+" extension not supported."),s}}}function By(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(x=>delete s[x]);function a(x){c(x.target)}function c(x){
x.index!==null&&e.remove(x.index);for(let p in x.attributes)e.remove(x.attributes[p]);x.removeEventListener("dispose",a),delete s[x.id],o.unregister(x);let S=r.
get(x);S&&(e.remove(S),r.delete(x)),n.releaseStatesOfGeometry(x),x.isInstancedBufferGeometry===!0&&delete x._maxInstanceCount,t.memory.geometries--}function l(x,S){
return s[S.id]!==void 0||(S.addEventListener("dispose",a),s[S.id]=new WeakRef(S),o.register(S,S.id,S),t.memory.geometries++),S}function u(x){let S=x.attributes;
for(let p in S)e.update(S[p],i.ARRAY_BUFFER)}function f(x){let S=x.index,p=x.attributes.position,m=0;if(p===void 0)return;let v=S!==null?S.array.length:p.array.
length/3-1,A=p.count>=65535?bo:Mo,M=new A(Math.ceil(v/3)*6,1),P=M.array;if(S!==null){let _=S.array;m=S.version;for(let T=0,O=0;T<v;T+=3){let D=_[T+0],L=_[T+1],V=_[T+
2];P[O++]=D,P[O++]=L,P[O++]=L,P[O++]=V,P[O++]=V,P[O++]=D}}else{m=p.version;for(let _=0,T=0;_<v;_+=3){let O=_+0,D=_+1,L=_+2;P[T++]=O,P[T++]=D,P[T++]=D,P[T++]=L,P[T++]=
L,P[T++]=O}}M.version=m;let E=r.get(x);E&&e.remove(E),r.set(x,M)}function h(x){let S=r.get(x);if(S){let p=x.index;p!==null&&S.version<p.version&&f(x)}else f(x);
return r.get(x)}function d(){for(let x in s){let S=s[x].deref();S!==void 0&&c(S)}}return{get:l,update:u,getWireframeAttribute:h,dispose:d}}function zy(i,e,t){let n;
function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function c(f,h){i.drawElements(n,h,r,f*o),t.update(h,n,1)}function l(f,h,d){d!==0&&(i.drawElementsInstanced(
n,h,r,f*o,d),t.update(h,n,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,r,f,0,d);let S=0;for(let p=0;p<d;p++)S+=h[p];
t.update(S,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function ky(i){let e={geometries:0,textures:0},t={frame:0,
calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.
LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Ke("WebGLInfo: Unknown draw mode:",o);break}}function s(){
t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Vy(i,e,t){let n=new WeakMap,s=new Ht;
function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=n.get(
a);if(h===void 0||h.count!==f){let O=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",O)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.
position!==void 0,x=a.morphAttributes.normal!==void 0,S=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.
color||[],A=0;d===!0&&(A=1),x===!0&&(A=2),S===!0&&(A=3);let M=a.attributes.position.count*A,P=1;M>e.maxTextureSize&&(P=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);
let E=new Float32Array(M*P*4*f),_=new vo(E,M,P,f);_.type=oi,_.needsUpdate=!0;let T=A*4;for(let D=0;D<f;D++){let L=p[D],V=m[D],H=v[D],N=M*P*4*D;for(let G=0;G<L.count;G++){
let J=G*T;d===!0&&(s.fromBufferAttribute(L,G),E[N+J+0]=s.x,E[N+J+1]=s.y,E[N+J+2]=s.z,E[N+J+3]=0),x===!0&&(s.fromBufferAttribute(V,G),E[N+J+4]=s.x,E[N+J+5]=s.y,E[N+
J+6]=s.z,E[N+J+7]=0),S===!0&&(s.fromBufferAttribute(H,G),E[N+J+8]=s.x,E[N+J+9]=s.y,E[N+J+10]=s.z,E[N+J+11]=H.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new ft(
M,P)},n.set(a,h),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{
let d=0;for(let S=0;S<l.length;S++)d+=l[S];let x=a.morphTargetsRelative?1:1-d;c.getUniforms().setValue(i,"morphTargetBaseInfluence",x),c.getUniforms().setValue(
i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",h.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",h.size)}return{update:r}}
function Gy(i,e,t,n,s){let r=new WeakMap;function o(l){let u=s.render.frame,f=l.geometry,h=e.get(l,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),l.isInstancedMesh&&
(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(
l.instanceColor,i.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){let d=l.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function c(l){
let u=l.target;u.removeEventListener("dispose",c),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{
update:o,dispose:a}}var Hy={[qu]:"LINEAR_TONE_MAPPING",[Yu]:"REINHARD_TONE_MAPPING",[Zu]:"CINEON_TONE_MAPPING",[Ju]:"ACES_FILMIC_TONE_MAPPING",[Ku]:"AGX_TONE_MA\
PPING",[Qu]:"NEUTRAL_TONE_MAPPING",[$u]:"CUSTOM_TONE_MAPPING"};function Wy(i,e,t,n,s,r){let o=new $n(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,
storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new Kn;u.setAttribute("position",new fn([-1,3,0,-1,-1,0,
3,-1,0],3)),u.setAttribute("uv",new fn([0,2,0,0,2,0],2));let f=new ul({uniforms:{tDiffuse:{value:null}},vertexShader:"\n   precision highp float;\n\n   uniform mat\
4 modelViewMatrix;\n   uniform mat4 projectionMatrix;\n\n   attribute vec3 position;\n   attribute vec2 uv;\n\n   varying vec2 vUv;\n\n   void main() {\n    vUv = uv;\n  \
  gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );\n   }",fragmentShader:"\n   precision highp float;\n\n   uniform sampler2D tDiffuse;\n\n \
  varying vec2 vUv;\n\n   #include <tonemapping_pars_fragment>\n   #include <colorspace_pars_fragment>\n\n   void main() {\n    gl_FragColor = texture2D( tDiffuse, vU\
v );\n\n    #ifdef LINEAR_TONE_MAPPING\n     gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );\n    #elif defined( REINHARD_TONE_MAPPING )\n     gl_FragColor\
.rgb = ReinhardToneMapping( gl_FragColor.rgb );\n    #elif defined( CINEON_TONE_MAPPING )\n     gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );\n    #eli\
f defined( ACES_FILMIC_TONE_MAPPING )\n     gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );\n    #elif defined( AGX_TONE_MAPPING )\n     gl_FragColor\
.rgb = AgXToneMapping( gl_FragColor.rgb );\n    #elif defined( NEUTRAL_TONE_MAPPING )\n     gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );\n    #elif d\
efined( CUSTOM_TONE_MAPPING )\n     gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );\n    #endif\n\n    #ifdef SRGB_TRANSFER\n     gl_FragColor = sRGBTransf\
erOETF( gl_FragColor );\n    #endif\n   }",depthTest:!1,depthWrite:!1}),h=new ri(u,f),d=new Oo(-1,1,1,-1,0,1),x=null,S=null,p=!1,m,v=null,A=[],M=!1;this.setSize=
function(P,E){o.setSize(P,E),a!==null&&a.setSize(P,E),c!==null&&c.setSize(P,E);for(let _=0;_<A.length;_++){let T=A[_];T.setSize&&T.setSize(P,E)}},this.setEffects=
function(P){A=P,M=A.length>0&&A[0].isRenderPass===!0;let E=o.width,_=o.height;A.length>0&&a===null&&(a=new $n(E,_,{type:vi,depthBuffer:!1,stencilBuffer:!1}),c=new $n(
E,_,{type:vi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(O=>O.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&l===null&&(l=new ns(E,_),
r===!0&&(l.format=ss,l.type=Ws)),o.dispose(),o.depthTexture=T?l:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let O=0;O<A.length;O++){let D=A[O];
D.setSize&&D.setSize(E,_),T&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(l)}},this.begin=function(P,E){if(p||P.toneMapping===Ui&&A.length===0)
return!1;if(v=E,E!==null){let _=E.width,T=E.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return M===!1&&P.setRenderTarget(o),m=P.toneMapping,P.toneMapping=
Ui,!0},this.hasRenderPass=function(){return M},this.end=function(P,E){P.toneMapping=m,p=!0;let _=o,T=a;for(let O=0;O<A.length;O++){let D=A[O];D.enabled!==!1&&(D.
render(P,T,_,E),D.needsSwap!==!1&&(_=T,T=T===a?c:a))}if(x!==P.outputColorSpace||S!==P.toneMapping){x=P.outputColorSpace,S=P.toneMapping,f.defines={},gt.getTransfer(
x)===Tt&&(f.defines.SRGB_TRANSFER="");let O=Hy[S];O&&(f.defines[O]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,P.setRenderTarget(v),P.render(h,d),v=
null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),f.dispose()}}var wm=new On,
Tm=new ns(1,1),Am=new Co(1),Em=new vo,Cm=new sl,Rm=new Eo,im=[],sm=[],rm=new Float32Array(16),om=new Float32Array(9),am=new Float32Array(4);function Gr(i,e,t){let n=i[0];
if(n<=0||n>0)return i;let s=e*t,r=im[s];if(r===void 0&&(r=new Float32Array(s),im[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}
function dn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function pn(i,e){for(let t=0,n=e.length;t<n;t++)
i[t]=e[t]}function _c(i,e){let t=sm[e];t===void 0&&(t=new Int32Array(e),sm[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Xy(i,e){let t=this.
cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function qy(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=
e.x,t[1]=e.y);else{if(dn(t,e))return;i.uniform2fv(this.addr,e),pn(t,e)}}function Yy(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&
(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=
e.r,t[1]=e.g,t[2]=e.b);else{if(dn(t,e))return;i.uniform3fv(this.addr,e),pn(t,e)}}function Zy(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==
e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(dn(t,e))return;i.uniform4fv(this.addr,e),pn(t,e)}}function Jy(i,e){
let t=this.cache,n=e.elements;if(n===void 0){if(dn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),pn(t,e)}else{if(dn(t,n))return;am.set(n),i.uniformMatrix2fv(this.
addr,!1,am),pn(t,n)}}function $y(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(dn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),pn(t,e)}else{if(dn(t,n))
return;om.set(n),i.uniformMatrix3fv(this.addr,!1,om),pn(t,n)}}function Ky(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(dn(t,e))return;i.uniformMatrix4fv(
this.addr,!1,e),pn(t,e)}else{if(dn(t,n))return;rm.set(n),i.uniformMatrix4fv(this.addr,!1,rm),pn(t,n)}}function Qy(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.
addr,e),t[0]=e)}function jy(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(dn(t,e))return;
i.uniform2iv(this.addr,e),pn(t,e)}}function eS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=
e.x,t[1]=e.y,t[2]=e.z);else{if(dn(t,e))return;i.uniform3iv(this.addr,e),pn(t,e)}}function tS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==
e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(dn(t,e))return;i.uniform4iv(this.addr,e),pn(t,e)}}function nS(i,e){
let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function iS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,
e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(dn(t,e))return;i.uniform2uiv(this.addr,e),pn(t,e)}}function sS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||
t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(dn(t,e))return;i.uniform3uiv(this.addr,e),pn(t,e)}}function rS(i,e){let t=this.
cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(dn(
t,e))return;i.uniform4uiv(this.addr,e),pn(t,e)}}function xc(i){return i.version===0&&(i.compareFunction=lh,i.needsUpdate=!0),i}function oS(i,e,t){let n=this.cache,
s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=xc(Tm):r=wm,t.setTexture2D(e||r,s)}function aS(i,e,t){
let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Cm,s)}function lS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();
n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=xc(Am):r=Rm,t.setTextureCube(e||r,s)}function cS(i,e,t){let n=this.cache,s=t.
allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Em,s)}function uS(i){switch(i){case 5126:return Xy;case 35664:return qy;case 35665:
return Yy;case 35666:return Zy;case 35674:return Jy;case 35675:return $y;case 35676:return Ky;case 5124:case 35670:return Qy;case 35667:case 35671:return jy;case 35668:case 35672:
return eS;case 35669:case 35673:return tS;case 5125:return nS;case 36294:return iS;case 36295:return sS;case 36296:return rS;case 35678:case 36198:case 36298:case 36306:case 35682:
return oS;case 35679:case 36299:case 36307:return aS;case 35680:case 36300:case 36308:case 36293:return lS;case 36289:case 36303:case 36311:case 36292:return cS}}
function hS(i,e){i.uniform1fv(this.addr,e)}function fS(i,e){let t=Gr(e,this.size,2);i.uniform2fv(this.addr,t)}function dS(i,e){let t=Gr(e,this.size,3);i.uniform3fv(
this.addr,t)}function pS(i,e){let t=Gr(e,this.size,4);i.uniform4fv(this.addr,t)}function mS(i,e){let t=Gr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function gS(i,e){
let t=Gr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function _S(i,e){let t=Gr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function xS(i,e){i.uniform1iv(
this.addr,e)}function vS(i,e){i.uniform2iv(this.addr,e)}function yS(i,e){i.uniform3iv(this.addr,e)}function SS(i,e){i.uniform4iv(this.addr,e)}function MS(i,e){i.
uniform1uiv(this.addr,e)}function bS(i,e){i.uniform2uiv(this.addr,e)}function wS(i,e){i.uniform3uiv(this.addr,e)}function TS(i,e){i.uniform4uiv(this.addr,e)}function AS(i,e,t){
let n=this.cache,s=e.length,r=_c(t,s);dn(n,r)||(i.uniform1iv(this.addr,r),pn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=xc(Tm):o=wm;for(let a=0;a!==s;++a)t.setTexture2D(
e[a]||o,r[a])}function ES(i,e,t){let n=this.cache,s=e.length,r=_c(t,s);dn(n,r)||(i.uniform1iv(this.addr,r),pn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Cm,
r[o])}function CS(i,e,t){let n=this.cache,s=e.length,r=_c(t,s);dn(n,r)||(i.uniform1iv(this.addr,r),pn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=xc(Am):o=Rm;
for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function RS(i,e,t){let n=this.cache,s=e.length,r=_c(t,s);dn(n,r)||(i.uniform1iv(this.addr,r),pn(n,r));for(let o=0;o!==
s;++o)t.setTexture2DArray(e[o]||Em,r[o])}function PS(i){switch(i){case 5126:return hS;case 35664:return fS;case 35665:return dS;case 35666:return pS;case 35674:
return mS;case 35675:return gS;case 35676:return _S;case 5124:case 35670:return xS;case 35667:case 35671:return vS;case 35668:case 35672:return yS;case 35669:case 35673:
return SS;case 5125:return MS;case 36294:return bS;case 36295:return wS;case 36296:return TS;case 35678:case 36198:case 36298:case 36306:case 35682:return AS;case 35679:case 36299:case 36307:
return ES;case 35680:case 36300:case 36308:case 36293:return CS;case 36289:case 36303:case 36311:case 36292:return RS}}var xh=class{constructor(e,t,n){this.id=e,
this.addr=n,this.cache=[],this.type=t.type,this.setValue=uS(t.type)}},vh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=
t.size,this.setValue=PS(t.type)}},yh=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];
a.setValue(e,t[a.id],n)}}},gh=/(\w+)(\])?(\[|\.)?/g;function lm(i,e){i.seq.push(e),i.map[e.id]=e}function IS(i,e,t){let n=i.name,s=n.length;for(gh.lastIndex=0;;){
let r=gh.exec(n),o=gh.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){lm(t,l===void 0?new xh(a,i,e):new vh(a,i,e));break}else{let f=t.
map[a];f===void 0&&(f=new yh(a),lm(t,f)),t=f}}}var Vr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<
n;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);IS(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.
SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.
setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],c=n[a.id];c.needsUpdate!==
!1&&a.setValue(e,c.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function cm(i,e,t){let n=i.
createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var LS=37297,DS=0;function NS(i,e){let t=i.split("\n"),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);
for(let o=s;o<r;o++){let a=o+1;n.push("".concat(a===e?">":" "," ").concat(a,": ").concat(t[o]))}return n.join("\n")}var um=new Qe;function US(i){gt._getMatrix(um,
gt.workingColorSpace,i);let e="mat3( ".concat(um.elements.map(t=>t.toFixed(4))," )");switch(gt.getTransfer(i)){case _o:return[e,"LinearTransferOETF"];case Tt:return[
e,"sRGBTransferOETF"];default:return qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function hm(i,e,t){let n=i.getShaderParameter(e,i.
COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+"\n\n"+
r+"\n\n"+NS(i.getShaderSource(e),a)}else return r}function FS(i,e){let t=US(e);return["vec4 ".concat(i,"( vec4 value ) {")," return ".concat(t[1],"( vec4( ").concat(
t[0]," * value.rgb, value.a ) );"),"}"].join("\n")}var OS={[qu]:"Linear",[Yu]:"Reinhard",[Zu]:"Cineon",[Ju]:"ACESFilmic",[Ku]:"AgX",[Qu]:"Neutral",[$u]:"Custom"};
function BS(i,e){let t=OS[e];return t===void 0?(qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):
"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var pc=new q;function zS(){gt.getLuminanceCoefficients(pc);let i=pc.x.toFixed(4),e=pc.y.toFixed(
4),t=pc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {"," const vec3 weights = vec3( ".concat(i,", ").concat(e,", ").concat(t," );")," return dot( \
weights, rgb );","}"].join("\n")}function kS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#\
extension GL_ANGLE_multi_draw : require":""].filter(Ko).join("\n")}function VS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.
join("\n")}function GS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&
(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ko(i){return i!==
""}function fm(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,
e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,
e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).
replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,
e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function dm(i,e){return i.
replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var HS=/^[ \t]*#include +<([\w\d./]+)>/gm;
function Sh(i){return i.replace(HS,WS)}function WS(i,e){let t=lt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Sh(
t)}var XS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function pm(i){
return i.replace(XS,qS)}function qS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,
r);return s}function mm(i){let e="precision ".concat(i.precision," float;\n precision ").concat(i.precision," int;\n precision ").concat(i.precision," sampler2D\
;\n precision ").concat(i.precision," samplerCube;\n precision ").concat(i.precision," sampler3D;\n precision ").concat(i.precision," sampler2DArray;\n precision\
 ").concat(i.precision," sampler2DShadow;\n precision ").concat(i.precision," samplerCubeShadow;\n precision ").concat(i.precision," sampler2DArrayShadow;\n prec\
ision ").concat(i.precision," isampler2D;\n precision ").concat(i.precision," isampler3D;\n precision ").concat(i.precision," isamplerCube;\n precision ").concat(
i.precision," isampler2DArray;\n precision ").concat(i.precision," usampler2D;\n precision ").concat(i.precision," usampler3D;\n precision ").concat(i.precision,
" usamplerCube;\n precision ").concat(i.precision," usampler2DArray;\n ");return i.precision==="highp"?e+="\n#define HIGH_PRECISION":i.precision==="mediump"?e+=
"\n#define MEDIUM_PRECISION":i.precision==="lowp"&&(e+="\n#define LOW_PRECISION"),e}var YS={[Vo]:"SHADOWMAP_TYPE_PCF",[Or]:"SHADOWMAP_TYPE_VSM"};function ZS(i){
return YS[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var JS={[zr]:"ENVMAP_MODE_REFRACTION"};function $S(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":JS[i.envMapMode]||
"ENVMAP_MODE_REFLECTION"}var KS={[Tl]:"ENVMAP_BLENDING_MULTIPLY",[Lp]:"ENVMAP_BLENDING_MIX",[Dp]:"ENVMAP_BLENDING_ADD"};function QS(i){return i.envMap===!1?"ENV\
MAP_BLENDING_NONE":KS[i.combine]||"ENVMAP_BLENDING_NONE"}function jS(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,c=ZS(t),l=t.envMapPMREM===
!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=$S(t),f=QS(t),h=kS(t),d=VS(r),x=s.createProgram(),S,p,m=t.glslVersion?"#version "+t.glslVersion+"\n":"";t.isRawShaderMaterial?
(S=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ko).join("\n"),S.length>0&&(S+="\n"),p=["#define SHADER_TYPE "+t.shaderType,
"#define SHADER_NAME "+t.shaderName,d].filter(Ko).join("\n"),p.length>0&&(p+="\n")):(S=[mm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,
d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"\
#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_\
FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_L\
IGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALM\
AP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE\
_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?
"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.
iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.
specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.
metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":
"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?
"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+
t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:
"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define MET\
ALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:
"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?
"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?
"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?
"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECU\
LARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITY\
MAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:
"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#\
define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS\
_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===
!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",
t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?
"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",
t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uni\
form mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform boo\
l isOrthographic;","#ifdef USE_INSTANCING"," attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR"," attribute vec3 instanceColor;","#endif","#\
ifdef USE_INSTANCING_MORPH"," uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1",
" attribute vec2 uv1;","#endif","#ifdef USE_UV2"," attribute vec2 uv2;","#endif","#ifdef USE_UV3"," attribute vec2 uv3;","#endif","#ifdef USE_TANGENT"," attribu\
te vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )"," attribute vec4 color;","#elif defined( USE_COLOR )"," attribute vec3 color;","#endif","#ifdef USE_\
SKINNING"," attribute vec4 skinIndex;"," attribute vec4 skinWeight;","#endif","\n"].filter(Ko).join("\n"),p=[mm(t),"#define SHADER_TYPE "+t.shaderType,"#define \
SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?
"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",
t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.
aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":
"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",
t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEAR\
COATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#defin\
e USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_\
RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCEN\
CE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULA\
R_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#\
define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?
"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_\
THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?
"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POIN\
TS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SI\
DED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>
0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.
logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","unifor\
m vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ui?"#define TONE_MAPPING":"",t.toneMapping!==Ui?lt.tonemapping_pars_fragment:"",t.toneMapping!==
Ui?BS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",lt.colorspace_pars_fragment,FS("linearToOutputTexel",t.outputColorSpace),
zS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"","\n"].filter(Ko).join("\n")),o=Sh(o),o=fm(o,t),o=dm(o,t),a=Sh(a),a=fm(a,t),a=dm(a,t),o=pm(o),a=
pm(a),t.isRawShaderMaterial!==!0&&(m="#version 300 es\n",S=[h,"#define attribute in","#define varying out","#define texture2D texture"].join("\n")+"\n"+S,p=["#d\
efine varying in",t.glslVersion===ch?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ch?"":"#define gl_FragColor pc_fragColor","#define g\
l_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod",
"#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT texture\
ProjGrad","#define textureCubeGradEXT textureGrad"].join("\n")+"\n"+p);let v=m+S+o,A=m+p+a,M=cm(s,s.VERTEX_SHADER,v),P=cm(s,s.FRAGMENT_SHADER,A);s.attachShader(
x,M),s.attachShader(x,P),t.index0AttributeName!==void 0?s.bindAttribLocation(x,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(x,0,"p\
osition"),s.linkProgram(x);function E(D){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(x)||"",V=s.getShaderInfoLog(M)||"",H=s.getShaderInfoLog(P)||"",
N=L.trim(),G=V.trim(),J=H.trim(),k=!0,le=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if(k=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(
s,x,M,P);else{let $=hm(s,M,"vertex"),Q=hm(s,P,"fragment");Ke("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+
"\n\nMaterial Name: "+D.name+"\nMaterial Type: "+D.type+"\n\nProgram Info Log: "+N+"\n"+$+"\n"+Q)}else N!==""?qe("WebGLProgram: Program Info Log:",N):(G===""||J===
"")&&(le=!1);le&&(D.diagnostics={runnable:k,programLog:N,vertexShader:{log:G,prefix:S},fragmentShader:{log:J,prefix:p}})}s.deleteShader(M),s.deleteShader(P),_=new Vr(
s,x),T=GS(s,x)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let O=t.rendererExtensionParallelShaderCompile===
!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(x,LS)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(x),this.
program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=DS++,this.cacheKey=e,this.usedTimes=1,this.program=x,this.vertexShader=M,this.fragmentShader=
P,this}var eM=0,Mh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===
!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&
this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){
return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,
n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new bh(e),t.set(e,n)),n}},bh=class{constructor(e){
this.id=eM++,this.code=e,this.usedTimes=0}};function tM(i){return i===As||i===Yo||i===Zo}function nM(i,e,t,n,s,r){let o=new yo,a=new Mh,c=new Set,l=[],u=new Map,
f=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"\
lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"\
basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return c.add(_),_===0?"uv":"uv".concat(
_)}function x(_,T,O,D,L,V){let H=D.fog,N=L.geometry,G=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?D.environment:null,J=_.isMeshStandardMaterial||
_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,k=e.get(_.envMap||G,J),le=h[_.type],$=n.precision;_.precision!==null&&($=n.getMaxPrecision(
_.precision),$!==_.precision&&qe("WebGLProgram.getParameters:",_.precision,"not supported, using",$,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.
normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,he=0;N.morphAttributes.position!==void 0&&(he=1),N.morphAttributes.normal!==void 0&&(he=2),N.morphAttributes.
color!==void 0&&(he=3);let ue,j,pe,_e;if(le){let Ee=Oi[le];ue=Ee.vertexShader,j=Ee.fragmentShader}else{ue=_.vertexShader,j=_.fragmentShader;let Ee=a.getVertexShaderStage(
_),it=a.getFragmentShaderStage(_);a.update(_,Ee,it),pe=Ee.id,_e=it.id}let Ae=i.getRenderTarget(),Se=i.state.buffers.depth.getReversed(),Ge=L.isInstancedMesh===!0,
tt=L.isBatchedMesh===!0,ke=!!_.map,ct=!!_.matcap,rt=!!k,je=rt&&k.isPMREMTexture===!0,Vt=!!_.aoMap,Nt=!!_.lightMap,Qt=!!_.bumpMap&&_.wireframe===!1,Rt=!!_.normalMap,
mn=!!_.displacementMap,xt=!!_.emissiveMap,an=!!_.metalnessMap,Xt=!!_.roughnessMap,jt=_.anisotropy>0,F=_.clearcoat>0,Ce=_.diffuseRoughness>0,Xe=_.dispersion>0,nt=_.
retroreflectivity>0,Me=_.iridescence>0,It=_.sheen>0,ze=_.transmission>0,We=jt&&!!_.anisotropyMap,C=F&&!!_.clearcoatMap,y=F&&!!_.clearcoatNormalMap,W=F&&!!_.clearcoatRoughnessMap,
ce=Ce&&!!_.diffuseRoughnessMap,re=Me&&!!_.iridescenceMap,ge=Me&&!!_.iridescenceThicknessMap,xe=It&&!!_.sheenColorMap,ee=It&&!!_.sheenRoughnessMap,ne=!!_.specularMap,
de=!!_.specularColorMap,U=!!_.specularIntensityMap,se=ze&&!!_.transmissionMap,te=ze&&!!_.thicknessMap,be=!!_.gradientMap,me=!!_.alphaMap,ye=_.alphaTest>0,Ve=!!_.
alphaHash,Ze=!!_.extensions,ae=Ui;_.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ae=i.toneMapping);let Fe=je?k.isCompressedCubeTexture?k.image[0].mipmaps:
k.mipmaps:null,Je={shaderID:le,shaderType:_.type,shaderName:_.name,vertexShader:ue,fragmentShader:j,defines:_.defines,customVertexShaderID:pe,customFragmentShaderID:_e,
isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:$,batching:tt,batchingColor:tt&&L._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&
L.instanceColor!==null,instancingMorph:Ge&&L.morphTexture!==null,outputColorSpace:Ae===null?i.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:gt.
workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:ke,matcap:ct,envMap:rt,envMapMode:rt&&k.mapping,envMapPMREM:je,envMapMaxLod:je?Fe.length-1:null,envMapSize:je?
Fe[0].width:null,aoMap:Vt,lightMap:Nt,bumpMap:Qt,normalMap:Rt,displacementMap:mn,emissiveMap:xt,normalMapObjectSpace:Rt&&_.normalMapType===Fp,normalMapTangentSpace:Rt&&
_.normalMapType===fc,packedNormalMap:Rt&&_.normalMapType===fc&&tM(_.normalMap.format),metalnessMap:an,roughnessMap:Xt,anisotropy:jt,anisotropyMap:We,clearcoat:F,
clearcoatMap:C,clearcoatNormalMap:y,clearcoatRoughnessMap:W,diffuseRoughness:Ce,diffuseRoughnessMap:ce,dispersion:Xe,retroreflection:nt,iridescence:Me,iridescenceMap:re,
iridescenceThicknessMap:ge,sheen:It,sheenColorMap:xe,sheenRoughnessMap:ee,specularMap:ne,specularColorMap:de,specularIntensityMap:U,transmission:ze,transmissionMap:se,
thicknessMap:te,gradientMap:be,opaque:_.transparent===!1&&_.blending===Br&&_.alphaToCoverage===!1,alphaMap:me,alphaTest:ye,alphaHash:Ve,combine:_.combine,mapUv:ke&&
d(_.map.channel),aoMapUv:Vt&&d(_.aoMap.channel),lightMapUv:Nt&&d(_.lightMap.channel),bumpMapUv:Qt&&d(_.bumpMap.channel),normalMapUv:Rt&&d(_.normalMap.channel),displacementMapUv:mn&&
d(_.displacementMap.channel),emissiveMapUv:xt&&d(_.emissiveMap.channel),metalnessMapUv:an&&d(_.metalnessMap.channel),roughnessMapUv:Xt&&d(_.roughnessMap.channel),
anisotropyMapUv:We&&d(_.anisotropyMap.channel),clearcoatMapUv:C&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:y&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:W&&
d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ce&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:re&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:ge&&
d(_.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:ee&&d(_.sheenRoughnessMap.channel),specularMapUv:ne&&d(_.
specularMap.channel),specularColorMapUv:de&&d(_.specularColorMap.channel),specularIntensityMapUv:U&&d(_.specularIntensityMap.channel),transmissionMapUv:se&&d(_.
transmissionMap.channel),thicknessMapUv:te&&d(_.thicknessMap.channel),alphaMapUv:me&&d(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Rt||jt),vertexNormals:!!N.
attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&
!!N.attributes.uv&&(ke||me),fog:!!H,useFog:_.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&
Rt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,
reversedDepthBuffer:Se,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.
morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:he,numSunLights:T.sun.length,numDirLights:T.
directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.
hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.
spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:V.filter(Ee=>Ee.texture!==null).
length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.
shadowMap.type,toneMapping:ae,decodeVideoTexture:ke&&_.map.isVideoTexture===!0&&gt.getTransfer(_.map.colorSpace)===Tt,decodeVideoTextureEmissive:xt&&_.emissiveMap.
isVideoTexture===!0&&gt.getTransfer(_.emissiveMap.colorSpace)===Tt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ni,flipSided:_.side===Fn,useDepthPacking:_.
depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Ze&&_.extensions.clipCullDistance===!0&&t.has(
"WEBGL_clip_cull_distance"),extensionMultiDraw:(Ze&&_.extensions.multiDraw===!0||tt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KH\
R_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Je.vertexUv1s=c.has(1),Je.vertexUv2s=c.has(2),Je.vertexUv3s=c.has(3),c.clear(),
Je}function S(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let O in _.defines)
T.push(O),T.push(_.defines[O]);return _.isRawShaderMaterial===!1&&(p(T,_),m(T,_),T.push(i.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function p(_,T){
_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),
_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.
push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),
_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),
_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),
_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),
_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(
T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.
depthPacking)}function m(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&
o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),
T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(
15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&
o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),
T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(
5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&
o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.
enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>
0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let T=h[_.type],O;if(T){let D=Oi[T];O=$p.clone(D.uniforms)}else O=_.uniforms;return O}
function A(_,T){let O=u.get(T);return O!==void 0?++O.usedTimes:(O=new jS(i,T,_,s),l.push(O),u.set(T,O)),O}function M(_){if(--_.usedTimes===0){let T=l.indexOf(_);
l[T]=l[l.length-1],l.pop(),u.delete(_.cacheKey),_.destroy()}}function P(_){a.remove(_)}function E(){a.dispose()}return{getParameters:x,getProgramCacheKey:S,getUniforms:v,
acquireProgram:A,releaseProgram:M,releaseShaderCache:P,programs:l,dispose:E}}function iM(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.
get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,
dispose:r}}function sM(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==
e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function gm(i,e){
return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function _m(){
let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,x,S,p,m){
let v=i[e];return v===void 0?(v={id:h.id,object:h,geometry:d,material:x,materialVariant:o(h),groupOrder:S,renderOrder:h.renderOrder,z:p,group:m},i[e]=v):(v.id=h.
id,v.object=h,v.geometry=d,v.material=x,v.materialVariant=o(h),v.groupOrder=S,v.renderOrder=h.renderOrder,v.z=p,v.group=m),e++,v}function c(h,d,x,S,p,m,v){v.reversedDepth===
!0&&(p=-p);let A=a(h,d,x,S,p,m);x.transmission>0?n.push(A):x.transparent===!0?s.push(A):t.push(A)}function l(h,d,x,S,p,m){let v=a(h,d,x,S,p,m);x.transmission>0?
n.unshift(v):x.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,d){t.length>1&&t.sort(h||sM),n.length>1&&n.sort(d||gm),s.length>1&&s.sort(d||gm)}function f(){
for(let h=e,d=i.length;h<d;h++){let x=i[h];if(x.id===null)break;x.id=null,x.object=null,x.geometry=null,x.material=null,x.group=null}}return{opaque:t,transmissive:n,
transparent:s,init:r,push:c,unshift:l,finish:f,sort:u}}function rM(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new _m,i.set(n,[o])):
s>=r.length?(o=new _m,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function oM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.
id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new q,color:new st};break;case"SpotLight":t={position:new q,direction:new q,color:new st,
distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new q,color:new st,distance:0,decay:0};break;case"HemisphereLight":t={direction:new q,
skyColor:new st,groundColor:new st};break;case"RectAreaLight":t={color:new st,position:new q,halfWidth:new q,halfHeight:new q};break}return i[e.id]=t,t}}}function aM(){
let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,
shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ft};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ft};
break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ft,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.
id]=t,t}}}var lM=0;function cM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function uM(i){let e=new oM,t=aM(),n={version:0,hash:{sunLength:-1,
directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,
numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],
directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,
point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new q);let s=new q,
r=new bt,o=new bt;function a(l){let u=0,f=0,h=0;for(let V=0;V<9;V++)n.probe[V].set(0,0,0);let d=0,x=0,S=0,p=0,m=0,v=0,A=0,M=0,P=0,E=0,_=0,T=0,O=0,D=0;l.sort(cM);
for(let V=0,H=l.length;V<H;V++){let N=l[V],G=N.color,J=N.intensity,k=N.distance,le=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===As?le=N.shadow.
map.texture:le=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=G.r*J,f+=G.g*J,h+=G.b*J;else if(N.isLightProbe){for(let $=0;$<9;$++)n.probe[$].
addScaledVector(N.sh.coefficients[$],J);D++}else if(N.isSunLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,
ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(
Q.getFrameExtents()),n.sunShadow[x]=ie,n.sunShadowMap[x]=le;let he=Q.getViewportCount();for(let ue=0;ue<he;ue++)n.sunShadowMatrix[S+ue]=Q.getMatrix(ue),n.sunShadowCascade[S+
ue]=Q._cascadeData[ue];S+=he,x++}n.sun[d]=$,d++}else if(N.isDirectionalLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){
let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,
n.directionalShadow[p]=ie,n.directionalShadowMap[p]=le,n.directionalShadowMatrix[p]=N.shadow.matrix,P++}n.directional[p]=$,p++}else if(N.isSpotLight){let $=e.get(
N);$.position.setFromMatrixPosition(N.matrixWorld),$.color.copy(G).multiplyScalar(J),$.distance=k,$.coneCos=Math.cos(N.angle),$.penumbraCos=Math.cos(N.angle*(1-
N.penumbra)),$.decay=N.decay,n.spot[v]=$;let Q=N.shadow;if(N.map&&(n.spotLightMap[T]=N.map,T++,Q.updateMatrices(N),N.castShadow&&O++),n.spotLightMatrix[v]=Q.matrix,
N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,
n.spotShadow[v]=ie,n.spotShadowMap[v]=le,_++}v++}else if(N.isRectAreaLight){let $=e.get(N);$.color.copy(G).multiplyScalar(J),$.halfWidth.set(N.width*.5,0,0),$.halfHeight.
set(0,N.height*.5,0),n.rectArea[A]=$,A++}else if(N.isPointLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),$.distance=N.distance,$.decay=
N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.
shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=le,n.pointShadowMatrix[m]=N.shadow.
matrix,E++}n.point[m]=$,m++}else if(N.isHemisphereLight){let $=e.get(N);$.skyColor.copy(N.color).multiplyScalar(J),$.groundColor.copy(N.groundColor).multiplyScalar(
J),n.hemi[M]=$,M++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ie.LTC_FLOAT_1,n.rectAreaLTC2=Ie.LTC_FLOAT_2):(n.rectAreaLTC1=Ie.LTC_HALF_1,n.rectAreaLTC2=
Ie.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=f,n.ambient[2]=h;let L=n.hash;(L.sunLength!==d||L.directionalLength!==p||L.pointLength!==m||L.spotLength!==v||L.rectAreaLength!==
A||L.hemiLength!==M||L.numSunShadows!==x||L.numDirectionalShadows!==P||L.numPointShadows!==E||L.numSpotShadows!==_||L.numSpotMaps!==T||L.numLightProbes!==D)&&(n.
sun.length=d,n.directional.length=p,n.spot.length=v,n.rectArea.length=A,n.point.length=m,n.hemi.length=M,n.sunShadow.length=x,n.sunShadowMap.length=x,n.sunShadowMatrix.
length=S,n.sunShadowCascade.length=S,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=E,n.pointShadowMap.
length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+T-O,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=
O,n.numLightProbes=D,L.sunLength=d,L.directionalLength=p,L.pointLength=m,L.spotLength=v,L.rectAreaLength=A,L.hemiLength=M,L.numSunShadows=x,L.numDirectionalShadows=
P,L.numPointShadows=E,L.numSpotShadows=_,L.numSpotMaps=T,L.numLightProbes=D,n.version=lM++)}function c(l,u){let f=0,h=0,d=0,x=0,S=0,p=0,m=u.matrixWorldInverse;for(let v=0,
A=l.length;v<A;v++){let M=l[v];if(M.isSunLight){let P=n.sun[f];P.direction.setFromMatrixPosition(M.matrixWorld),P.direction.transformDirection(m),f++}else if(M.
isDirectionalLight){let P=n.directional[h];P.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),P.direction.sub(s),P.direction.
transformDirection(m),h++}else if(M.isSpotLight){let P=n.spot[x];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(
M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),x++}else if(M.isRectAreaLight){let P=n.rectArea[S];
P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(m),o.identity(),r.copy(M.matrixWorld),r.premultiply(m),o.extractRotation(r),P.halfWidth.
set(M.width*.5,0,0),P.halfHeight.set(0,M.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),S++}else if(M.isPointLight){let P=n.point[d];P.position.
setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(m),d++}else if(M.isHemisphereLight){let P=n.hemi[p];P.direction.setFromMatrixPosition(M.matrixWorld),
P.direction.transformDirection(m),p++}}}return{setup:a,setupView:c,state:n}}function xm(i){let e=new uM(i),t=[],n=[],s=[];function r(f){u.camera=f,t.length=0,n.
length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){n.push(f)}function c(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.
id-h.id)}function l(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};
return{init:r,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function hM(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?
(a=new xm(i),e.set(s,[a])):r>=o.length?(a=new xm(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var fM="void main() {\n gl_Position = \
vec4( position, 1.0 );\n}",dM="uniform sampler2D shadow_pass;\nuniform vec2 resolution;\nuniform float radius;\nvoid main() {\n const float samples = float( VSM_SAM\
PLES );\n float mean = 0.0;\n float squared_mean = 0.0;\n float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );\n float uvStart = samples <= 1.0 ? 0.0 : \
- 1.0;\n for ( float i = 0.0; i < samples; i ++ ) {\n  float uvOffset = uvStart + i * uvStride;\n  #ifdef HORIZONTAL_PASS\n   vec2 distribution = texture2D( shadow_\
pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;\n   mean += distribution.x;\n   squared_mean += distribution.y * distribution.y + di\
stribution.x * distribution.x;\n  #else\n   float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;\n   mean +\
= depth;\n   squared_mean += depth * depth;\n  #endif\n }\n mean = mean / samples;\n squared_mean = squared_mean / samples;\n float std_dev = sqrt( max( 0.0, squared_\
mean - mean * mean ) );\n gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );\n}",pM=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],
mM=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],vm=new bt,$o=new q,_h=new q;function gM(i,e,t){let n=new ys,s=new ft,r=new ft,
o=new Ht,a=new hl,c=new fl,l={},u=t.maxTextureSize,f={[Ts]:Fn,[Fn]:Ts,[Ni]:Ni},h=new Di({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{
value:new ft},radius:{value:4}},vertexShader:fM,fragmentShader:dM}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let x=new Kn;x.setAttribute("position",new _i(new Float32Array(
[-1,-1,.5,3,-1,.5,-1,3,.5]),3));let S=new ri(x,h),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Vo;let m=this.type;this.render=function(E,_,T){
if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===dp&&(qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFS\
hadowMap instead."),this.type=Vo);let O=i.getRenderTarget(),D=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),V=i.state;V.setBlending(Vs),V.buffers.depth.getReversed()===
!0?V.buffers.color.setClear(0,0,0,0):V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);let H=m!==this.type;H&&_.traverse(function(N){
N.material&&(Array.isArray(N.material)?N.material.forEach(G=>G.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,G=E.length;N<G;N++){let J=E[N],k=J.shadow;
if(k===void 0){qe("WebGLShadowMap:",J,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let le=k.getFrameExtents();
s.multiply(le),r.copy(k.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,k.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,k.mapSize.
y=r.y));let $=i.state.buffers.depth.getReversed();if(k.camera._reversedDepth=$,k.map===null||H===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.
dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===Or){if(J.isPointLight){qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Us\
e PCF or BasicShadowMap instead.");continue}k.map=new $n(s.x,s.y,{format:As,type:vi,minFilter:Un,magFilter:Un,generateMipmaps:!1}),k.map.texture.name=J.name+".s\
hadowMap",k.map.depthTexture=new ns(s.x,s.y,oi),k.map.depthTexture.name=J.name+".shadowMapDepth",k.map.depthTexture.format=Ki,k.map.depthTexture.compareFunction=
null,k.map.depthTexture.minFilter=Sn,k.map.depthTexture.magFilter=Sn}else J.isPointLight?(k.map=new Qo(s.x),k.map.depthTexture=new Co(s.x,xi)):(k.map=new $n(s.x,
s.y),k.map.depthTexture=new ns(s.x,s.y,xi)),k.map.depthTexture.name=J.name+".shadowMap",k.map.depthTexture.format=Ki,this.type===Vo?(k.map.depthTexture.compareFunction=
$?ah:oh,k.map.depthTexture.minFilter=Un,k.map.depthTexture.magFilter=Un):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Sn,k.map.depthTexture.
magFilter=Sn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let Q=k.map.
isWebGLCubeRenderTarget?6:k.getViewportCount();J.isPointLight!==!0&&k.updateMatrices(J,T);let ie=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:T.layers;
for(let he=0;he<Q;he++){let ue=k.getCamera(he);if(J.isPointLight){let j=k.camera,pe=k.matrix,_e=J.distance||j.far;_e!==j.far&&(j.far=_e,j.updateProjectionMatrix()),
$o.setFromMatrixPosition(J.matrixWorld),j.position.copy($o),_h.copy(j.position),_h.add(pM[he]),j.up.copy(mM[he]),j.lookAt(_h),j.updateMatrixWorld(),pe.makeTranslation(
-$o.x,-$o.y,-$o.z),vm.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),k._frustum.setFromProjectionMatrix(vm,j.coordinateSystem,j.reversedDepth)}if(k.map.
isWebGLCubeRenderTarget)i.setRenderTarget(k.map,he),i.clear();else{he===0&&(i.setRenderTarget(k.map),i.clear());let j=k.getViewport(he);o.set(r.x*j.x,r.y*j.y,r.
x*j.z,r.y*j.w),V.viewport(o)}n=k.getFrustum(he),M(_,T,ue,J,ie,this.type)}k.isPointLightShadow!==!0&&this.type===Or&&v(k,T),k.needsUpdate=!1}m=this.type,p.needsUpdate=
!1,i.setRenderTarget(O,D,L)};function v(E,_){let T=e.update(S);h.defines.VSM_SAMPLES!==E.blurSamples&&(h.defines.VSM_SAMPLES=E.blurSamples,d.defines.VSM_SAMPLES=
E.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),E.mapPass===null?E.mapPass=new $n(s.x,s.y,{format:As,type:vi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==
E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),h.uniforms.shadow_pass.value=E.map.depthTexture,h.uniforms.resolution.value.set(E.map.width,E.map.height),
h.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(_,null,T,h,S,null),d.uniforms.shadow_pass.value=E.mapPass.texture,d.
uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(_,null,T,d,S,null)}
function A(E,_,T,O){let D=null,L=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)D=L;else if(D=T.isPointLight===!0?c:a,i.localClippingEnabled&&
_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&
_.alphaTest>0||_.alphaToCoverage===!0){let V=D.uuid,H=_.uuid,N=l[V];N===void 0&&(N={},l[V]=N);let G=N[H];G===void 0&&(G=D.clone(),N[H]=G,_.addEventListener("dis\
pose",P)),D=G}if(D.visible=_.visible,D.wireframe=_.wireframe,O===Or?D.side=_.shadowSide!==null?_.shadowSide:_.side:D.side=_.shadowSide!==null?_.shadowSide:f[_.side],
D.alphaMap=_.alphaMap,D.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,D.map=_.map,D.clipShadows=_.clipShadows,D.clippingPlanes=_.clippingPlanes,D.clipIntersection=
_.clipIntersection,D.displacementMap=_.displacementMap,D.displacementScale=_.displacementScale,D.displacementBias=_.displacementBias,D.wireframeLinewidth=_.wireframeLinewidth,
D.linewidth=_.linewidth,T.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let V=i.properties.get(D);V.light=T}return D}function M(E,_,T,O,D,L){if(E.visible===
!1)return;if(E.layers.test(D)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===Or)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.
multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let N=e.update(E),G=E.material;if(Array.isArray(G)){let J=N.groups;for(let k=0,le=J.length;k<le;k++){let $=J[k],
Q=G[$.materialIndex];if(Q&&Q.visible){let ie=A(E,Q,O,L);E.onBeforeShadow(i,E,_,T,N,ie,$),i.renderBufferDirect(T,null,N,ie,E,$),E.onAfterShadow(i,E,_,T,N,ie,$)}}}else if(G.
visible){let J=A(E,G,O,L);E.onBeforeShadow(i,E,_,T,N,J,null),i.renderBufferDirect(T,null,N,J,E,null),E.onAfterShadow(i,E,_,T,N,J,null)}}let H=E.children;for(let N=0,
G=H.length;N<G;N++)M(H[N],_,T,O,D,L)}function P(E){E.target.removeEventListener("dispose",P);for(let T in l){let O=l[T],D=E.target.uuid;D in O&&(O[D].dispose(),
delete O[D])}}}function _M(i,e){function t(){let U=!1,se=new Ht,te=null,be=new Ht(0,0,0,0);return{setMask:function(me){te!==me&&!U&&(i.colorMask(me,me,me,me),te=
me)},setLocked:function(me){U=me},setClear:function(me,ye,Ve,Ze,ae){ae===!0&&(me*=Ze,ye*=Ze,Ve*=Ze),se.set(me,ye,Ve,Ze),be.equals(se)===!1&&(i.clearColor(me,ye,
Ve,Ze),be.copy(se))},reset:function(){U=!1,te=null,be.set(-1,0,0,0)}}}function n(){let U=!1,se=!1,te=null,be=null,me=null;return{setReversed:function(ye){if(se!==
ye){let Ve=e.get("EXT_clip_control");ye?Ve.clipControlEXT(Ve.LOWER_LEFT_EXT,Ve.ZERO_TO_ONE_EXT):Ve.clipControlEXT(Ve.LOWER_LEFT_EXT,Ve.NEGATIVE_ONE_TO_ONE_EXT),
se=ye;let Ze=me;me=null,this.setClear(Ze)}},getReversed:function(){return se},setTest:function(ye){ye?Se(i.DEPTH_TEST):Ge(i.DEPTH_TEST)},setMask:function(ye){te!==
ye&&!U&&(i.depthMask(ye),te=ye)},setFunc:function(ye){if(se&&(ye=Yp[ye]),be!==ye){switch(ye){case Xa:i.depthFunc(i.NEVER);break;case qa:i.depthFunc(i.ALWAYS);break;case Ya:
i.depthFunc(i.LESS);break;case Cr:i.depthFunc(i.LEQUAL);break;case Za:i.depthFunc(i.EQUAL);break;case Ja:i.depthFunc(i.GEQUAL);break;case $a:i.depthFunc(i.GREATER);
break;case Ka:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}be=ye}},setLocked:function(ye){U=ye},setClear:function(ye){me!==ye&&(me=ye,se&&(ye=1-ye),
i.clearDepth(ye))},reset:function(){U=!1,te=null,be=null,me=null,se=!1}}}function s(){let U=!1,se=null,te=null,be=null,me=null,ye=null,Ve=null,Ze=null,ae=null;return{
setTest:function(Fe){U||(Fe?Se(i.STENCIL_TEST):Ge(i.STENCIL_TEST))},setMask:function(Fe){se!==Fe&&!U&&(i.stencilMask(Fe),se=Fe)},setFunc:function(Fe,Je,Ee){(te!==
Fe||be!==Je||me!==Ee)&&(i.stencilFunc(Fe,Je,Ee),te=Fe,be=Je,me=Ee)},setOp:function(Fe,Je,Ee){(ye!==Fe||Ve!==Je||Ze!==Ee)&&(i.stencilOp(Fe,Je,Ee),ye=Fe,Ve=Je,Ze=
Ee)},setLocked:function(Fe){U=Fe},setClear:function(Fe){ae!==Fe&&(i.clearStencil(Fe),ae=Fe)},reset:function(){U=!1,se=null,te=null,be=null,me=null,ye=null,Ve=null,
Ze=null,ae=null}}}let r=new t,o=new n,a=new s,c={},l=new WeakMap,u={},f={},h={},d=new WeakMap,x=[],S=null,p=!1,m=null,v=null,A=null,M=null,P=null,E=null,_=null,
T=new st(0,0,0),O=0,D=!1,L=null,V=null,H=null,N=null,G=null,J=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,le=0,$=i.getParameter(i.VERSION);$.indexOf(
"WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec($)[1]),k=le>=1):$.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),k=le>=2);let Q=null,ie={},
he=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),j=new Ht().fromArray(he),pe=new Ht().fromArray(ue);function _e(U,se,te,be){let me=new Uint8Array(
4),ye=i.createTexture();i.bindTexture(U,ye),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ve=0;Ve<
te;Ve++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(se,0,i.RGBA,1,1,be,0,i.RGBA,i.UNSIGNED_BYTE,me):i.texImage2D(se+Ve,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,
me);return ye}let Ae={};Ae[i.TEXTURE_2D]=_e(i.TEXTURE_2D,i.TEXTURE_2D,1),Ae[i.TEXTURE_CUBE_MAP]=_e(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[i.TEXTURE_2D_ARRAY]=
_e(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ae[i.TEXTURE_3D]=_e(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(i.DEPTH_TEST),
o.setFunc(Cr),Qt(!1),Rt(ku),Se(i.CULL_FACE),Vt(Vs);function Se(U){u[U]!==!0&&(i.enable(U),u[U]=!0)}function Ge(U){u[U]!==!1&&(i.disable(U),u[U]=!1)}function tt(U,se){
return h[U]!==se?(i.bindFramebuffer(U,se),h[U]=se,U===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=se),U===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=se),!0):!1}function ke(U,se){
let te=x,be=!1;if(U){te=d.get(se),te===void 0&&(te=[],d.set(se,te));let me=U.textures;if(te.length!==me.length||te[0]!==i.COLOR_ATTACHMENT0){for(let ye=0,Ve=me.
length;ye<Ve;ye++)te[ye]=i.COLOR_ATTACHMENT0+ye;te.length=me.length,be=!0}}else te[0]!==i.BACK&&(te[0]=i.BACK,be=!0);be&&i.drawBuffers(te)}function ct(U){return S!==
U?(i.useProgram(U),S=U,!0):!1}let rt={[Gs]:i.FUNC_ADD,[mp]:i.FUNC_SUBTRACT,[gp]:i.FUNC_REVERSE_SUBTRACT};rt[_p]=i.MIN,rt[xp]=i.MAX;let je={[vp]:i.ZERO,[yp]:i.ONE,
[Sp]:i.SRC_COLOR,[Wu]:i.SRC_ALPHA,[Ep]:i.SRC_ALPHA_SATURATE,[Tp]:i.DST_COLOR,[bp]:i.DST_ALPHA,[Mp]:i.ONE_MINUS_SRC_COLOR,[Xu]:i.ONE_MINUS_SRC_ALPHA,[Ap]:i.ONE_MINUS_DST_COLOR,
[wp]:i.ONE_MINUS_DST_ALPHA,[Cp]:i.CONSTANT_COLOR,[Rp]:i.ONE_MINUS_CONSTANT_COLOR,[Pp]:i.CONSTANT_ALPHA,[Ip]:i.ONE_MINUS_CONSTANT_ALPHA};function Vt(U,se,te,be,me,ye,Ve,Ze,ae,Fe){
if(U===Vs){p===!0&&(Ge(i.BLEND),p=!1);return}if(p===!1&&(Se(i.BLEND),p=!0),U!==pp){if(U!==m||Fe!==D){if((v!==Gs||P!==Gs)&&(i.blendEquation(i.FUNC_ADD),v=Gs,P=Gs),
Fe)switch(U){case Br:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vu:i.blendFunc(i.ONE,i.ONE);break;case Gu:i.blendFuncSeparate(
i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Hu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ke("WebGLState: Inval\
id blending: ",U);break}else switch(U){case Br:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vu:i.blendFuncSeparate(
i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Gu:Ke("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Hu:Ke("WebGLState: Mul\
tiplyBlending requires material.premultipliedAlpha = true");break;default:Ke("WebGLState: Invalid blending: ",U);break}A=null,M=null,E=null,_=null,T.set(0,0,0),
O=0,m=U,D=Fe}return}me=me||se,ye=ye||te,Ve=Ve||be,(se!==v||me!==P)&&(i.blendEquationSeparate(rt[se],rt[me]),v=se,P=me),(te!==A||be!==M||ye!==E||Ve!==_)&&(i.blendFuncSeparate(
je[te],je[be],je[ye],je[Ve]),A=te,M=be,E=ye,_=Ve),(Ze.equals(T)===!1||ae!==O)&&(i.blendColor(Ze.r,Ze.g,Ze.b,ae),T.copy(Ze),O=ae),m=U,D=!1}function Nt(U,se){U.side===
Ni?Ge(i.CULL_FACE):Se(i.CULL_FACE);let te=U.side===Fn;se&&(te=!te),Qt(te),U.blending===Br&&U.transparent===!1?Vt(Vs):Vt(U.blending,U.blendEquation,U.blendSrc,U.
blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(
U.depthWrite),r.setMask(U.colorWrite);let be=U.stencilWrite;a.setTest(be),be&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),
a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),xt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?Se(i.SAMPLE_ALPHA_TO_COVERAGE):
Ge(i.SAMPLE_ALPHA_TO_COVERAGE)}function Qt(U){L!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),L=U)}function Rt(U){U!==hp?(Se(i.CULL_FACE),U!==V&&(U===ku?i.cullFace(
i.BACK):U===fp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ge(i.CULL_FACE),V=U}function mn(U){U!==H&&(k&&i.lineWidth(U),H=U)}function xt(U,se,te){U?(Se(i.
POLYGON_OFFSET_FILL),(N!==se||G!==te)&&(N=se,G=te,o.getReversed()&&(se=-se,te=-te),i.polygonOffset(se,te))):Ge(i.POLYGON_OFFSET_FILL)}function an(U){U?Se(i.SCISSOR_TEST):
Ge(i.SCISSOR_TEST)}function Xt(U){U===void 0&&(U=i.TEXTURE0+J-1),Q!==U&&(i.activeTexture(U),Q=U)}function jt(U,se,te){te===void 0&&(Q===null?te=i.TEXTURE0+J-1:te=
Q);let be=ie[te];be===void 0&&(be={type:void 0,texture:void 0},ie[te]=be),(be.type!==U||be.texture!==se)&&(Q!==te&&(i.activeTexture(te),Q=te),i.bindTexture(U,se||
Ae[U]),be.type=U,be.texture=se)}function F(){let U=ie[Q];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Ce(){
try{i.compressedTexImage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function Xe(){try{i.compressedTexImage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function nt(){
try{i.texSubImage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function Me(){try{i.texSubImage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function It(){try{
i.compressedTexSubImage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function ze(){try{i.compressedTexSubImage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function We(){
try{i.texStorage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function C(){try{i.texStorage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function y(){try{i.texImage2D(
...arguments)}catch(U){Ke("WebGLState:",U)}}function W(){try{i.texImage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function ce(U){return f[U]!==void 0?f[U]:i.
getParameter(U)}function re(U,se){f[U]!==se&&(i.pixelStorei(U,se),f[U]=se)}function ge(U){j.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),j.copy(U))}function xe(U){
pe.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),pe.copy(U))}function ee(U,se){let te=l.get(se);te===void 0&&(te=new WeakMap,l.set(se,te));let be=te.get(U);be===
void 0&&(be=i.getUniformBlockIndex(se,U.name),i.uniformBlockBinding(se,be,be),te.set(U,be))}function ne(U,se,te){let me=l.get(se).get(U);c[me]!==te&&(i.bindBufferBase(
i.UNIFORM_BUFFER,me,te),c[me]=te)}function de(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),
i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),
i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),
i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(
i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(
1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,
4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),
i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,
0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,ie={},h={},c={},d=new WeakMap,
x=[],S=null,p=!1,m=null,v=null,A=null,M=null,P=null,E=null,_=null,T=new st(0,0,0),O=0,D=!1,L=null,V=null,H=null,N=null,G=null,j.set(0,0,i.canvas.width,i.canvas.
height),pe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:Ge,bindFramebuffer:tt,
drawBuffers:ke,useProgram:ct,setBlending:Vt,setMaterial:Nt,setFlipSided:Qt,setCullFace:Rt,setLineWidth:mn,setPolygonOffset:xt,setScissorTest:an,activeTexture:Xt,
bindTexture:jt,unbindTexture:F,compressedTexImage2D:Ce,compressedTexImage3D:Xe,texImage2D:y,texImage3D:W,pixelStorei:re,getParameter:ce,updateUBOMapping:ee,uniformBlockBinding:ne,
texStorage2D:We,texStorage3D:C,texSubImage2D:nt,texSubImage3D:Me,compressedTexSubImage2D:It,compressedTexSubImage3D:ze,scissor:ge,viewport:xe,reset:de}}function xM(i,e,t,n,s,r,o){
let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.
userAgent),l=new ft,u=new WeakMap,f=new Set,h,d=new WeakMap,x=new Set,S=new FinalizationRegistry(C=>x.delete(C)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(
1,1).getContext("2d")!==null}catch{}function m(C,y){return p?new OffscreenCanvas(C,y):xo("canvas")}function v(C,y,W){let ce=1,re=We(C);if((re.width>W||re.height>
W)&&(ce=W/Math.max(re.width,re.height)),ce<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||
typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ge=Math.floor(ce*re.width),xe=Math.floor(ce*re.height);h===
void 0&&(h=m(ge,xe));let ee=y?m(ge,xe):h;return ee.width=ge,ee.height=xe,ee.getContext("2d").drawImage(C,0,0,ge,xe),qe("WebGLRenderer: Texture has been resized \
from ("+re.width+"x"+re.height+") to ("+ge+"x"+xe+")."),ee}else return"data"in C&&qe("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+"\
)."),C;return C}function A(C){return C.generateMipmaps}function M(C){i.generateMipmap(C)}function P(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?
i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(C,y,W,ce,re,ge=!1){if(C!==null){if(i[C]!==void 0)
return i[C];qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let xe;ce&&(xe=e.get("EXT_texture_norm16"),xe||qe("WebGLRenderer: Una\
ble to use normalized textures without EXT_texture_norm16 extension"));let ee=y;if(y===i.RED&&(W===i.FLOAT&&(ee=i.R32F),W===i.HALF_FLOAT&&(ee=i.R16F),W===i.UNSIGNED_BYTE&&
(ee=i.R8),W===i.UNSIGNED_SHORT&&xe&&(ee=xe.R16_EXT),W===i.SHORT&&xe&&(ee=xe.R16_SNORM_EXT)),y===i.RED_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.R8UI),W===i.UNSIGNED_SHORT&&
(ee=i.R16UI),W===i.UNSIGNED_INT&&(ee=i.R32UI),W===i.BYTE&&(ee=i.R8I),W===i.SHORT&&(ee=i.R16I),W===i.INT&&(ee=i.R32I)),y===i.RG&&(W===i.FLOAT&&(ee=i.RG32F),W===i.
HALF_FLOAT&&(ee=i.RG16F),W===i.UNSIGNED_BYTE&&(ee=i.RG8),W===i.UNSIGNED_SHORT&&xe&&(ee=xe.RG16_EXT),W===i.SHORT&&xe&&(ee=xe.RG16_SNORM_EXT)),y===i.RG_INTEGER&&(W===
i.UNSIGNED_BYTE&&(ee=i.RG8UI),W===i.UNSIGNED_SHORT&&(ee=i.RG16UI),W===i.UNSIGNED_INT&&(ee=i.RG32UI),W===i.BYTE&&(ee=i.RG8I),W===i.SHORT&&(ee=i.RG16I),W===i.INT&&
(ee=i.RG32I)),y===i.RGB_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.RGB8UI),W===i.UNSIGNED_SHORT&&(ee=i.RGB16UI),W===i.UNSIGNED_INT&&(ee=i.RGB32UI),W===i.BYTE&&(ee=i.RGB8I),
W===i.SHORT&&(ee=i.RGB16I),W===i.INT&&(ee=i.RGB32I)),y===i.RGBA_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.RGBA8UI),W===i.UNSIGNED_SHORT&&(ee=i.RGBA16UI),W===i.UNSIGNED_INT&&
(ee=i.RGBA32UI),W===i.BYTE&&(ee=i.RGBA8I),W===i.SHORT&&(ee=i.RGBA16I),W===i.INT&&(ee=i.RGBA32I)),y===i.RGB&&(W===i.UNSIGNED_SHORT&&xe&&(ee=xe.RGB16_EXT),W===i.SHORT&&
xe&&(ee=xe.RGB16_SNORM_EXT),W===i.UNSIGNED_INT_5_9_9_9_REV&&(ee=i.RGB9_E5),W===i.UNSIGNED_INT_10F_11F_11F_REV&&(ee=i.R11F_G11F_B10F)),y===i.RGBA){let ne=ge?_o:gt.
getTransfer(re);W===i.FLOAT&&(ee=i.RGBA32F),W===i.HALF_FLOAT&&(ee=i.RGBA16F),W===i.UNSIGNED_BYTE&&(ee=ne===Tt?i.SRGB8_ALPHA8:i.RGBA8),W===i.UNSIGNED_SHORT&&xe&&
(ee=xe.RGBA16_EXT),W===i.SHORT&&xe&&(ee=xe.RGBA16_SNORM_EXT),W===i.UNSIGNED_SHORT_4_4_4_4&&(ee=i.RGBA4),W===i.UNSIGNED_SHORT_5_5_5_1&&(ee=i.RGB5_A1)}return(ee===
i.R16F||ee===i.R32F||ee===i.RG16F||ee===i.RG32F||ee===i.RGBA16F||ee===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function _(C,y){let W;return C?y===null||y===
xi||y===Ws?W=i.DEPTH24_STENCIL8:y===oi?W=i.DEPTH32F_STENCIL8:y===kr&&(W=i.DEPTH24_STENCIL8,qe("DepthTexture: 16 bit depth attachment is not supported with stenc\
il. Using 24-bit attachment.")):y===null||y===xi||y===Ws?W=i.DEPTH_COMPONENT24:y===oi?W=i.DEPTH_COMPONENT32F:y===kr&&(W=i.DEPTH_COMPONENT16),W}function T(C,y){return A(
C)===!0||C.isFramebufferTexture&&C.minFilter!==Sn&&C.minFilter!==Un?Math.log2(Math.max(y.width,y.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&
Array.isArray(C.image)?y.mipmaps.length:1}function O(C){let y=new WeakRef(C);n.get(C).__ref=y,x.add(y),S.register(C,y,y)}function D(C){let y=n.get(C).__ref;y!==
void 0&&(x.delete(y),S.unregister(y))}function L(C){H(C.target)}function V(C){N(C.target)}function H(C){C.removeEventListener("dispose",L),D(C),J(C),C.isVideoTexture&&
u.delete(C),C.isHTMLTexture&&f.delete(C)}function N(C){C.removeEventListener("dispose",V),D(C),le(C)}function G(){for(let C of x){let y=C.deref();y!==void 0&&(y.
isRenderTarget===!0?N(y):H(y))}x.clear(),f.clear()}function J(C){let y=n.get(C);if(y.__webglInit===void 0)return;let W=C.source,ce=d.get(W);if(ce){let re=ce[y.__cacheKey];
re.usedTimes--,re.usedTimes===0&&k(C),Object.keys(ce).length===0&&d.delete(W)}n.remove(C)}function k(C){let y=n.get(C);i.deleteTexture(y.__webglTexture);let W=C.
source,ce=d.get(W);delete ce[y.__cacheKey],o.memory.textures--}function le(C){let y=n.get(C);y.__depthDisposeCallback&&y.__depthDisposeCallback();let W=C.depthTexture;
if(W&&W.renderTarget===C&&H(W),C.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(y.__webglFramebuffer[re]))for(let ge=0;ge<y.__webglFramebuffer[re].
length;ge++)i.deleteFramebuffer(y.__webglFramebuffer[re][ge]);else i.deleteFramebuffer(y.__webglFramebuffer[re]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[re])}else{
if(Array.isArray(y.__webglFramebuffer))for(let re=0;re<y.__webglFramebuffer.length;re++)i.deleteFramebuffer(y.__webglFramebuffer[re]);else i.deleteFramebuffer(y.
__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),
y.__webglColorRenderbuffer)for(let re=0;re<y.__webglColorRenderbuffer.length;re++)y.__webglColorRenderbuffer[re]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[re]);
y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let ce=C.textures;for(let re=0,ge=ce.length;re<ge;re++){let xe=n.get(ce[re]);xe.__webglTexture&&
(i.deleteTexture(xe.__webglTexture),o.memory.textures--),n.remove(ce[re])}n.remove(C)}let $=0;function Q(){$=0}function ie(){return $}function he(C){$=C}function ue(){
let C=$;return C>=s.maxTextures&&qe("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,C}function j(C){let y=[];
return y.push(C.wrapS),y.push(C.wrapT),y.push(C.wrapR||0),y.push(C.magFilter),y.push(C.minFilter),y.push(C.anisotropy),y.push(C.internalFormat),y.push(C.format),
y.push(C.type),y.push(C.generateMipmaps),y.push(C.mipmapsAutoUpdate),y.push(C.premultiplyAlpha),y.push(C.flipY),y.push(C.unpackAlignment),y.push(C.colorSpace),y.
join()}function pe(C,y){let W=n.get(C);if(C.isVideoTexture&&It(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&W.__version!==C.version){
let ce=C.image;if(ce===null)qe("WebGLRenderer: Texture marked for update but no image data found.");else if(ce.complete===!1)qe("WebGLRenderer: Texture marked f\
or update but image is incomplete");else{Nt(W,C,y);return}}else C.isExternalTexture&&(W.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,
W.__webglTexture,i.TEXTURE0+y)}function _e(C,y){let W=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&W.__version!==C.version){Nt(W,C,y);return}else C.isExternalTexture&&
(W.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,W.__webglTexture,i.TEXTURE0+y)}function Ae(C,y){let W=n.get(C);if(C.isRenderTargetTexture===
!1&&C.version>0&&W.__version!==C.version){Nt(W,C,y);return}t.bindTexture(i.TEXTURE_3D,W.__webglTexture,i.TEXTURE0+y)}function Se(C,y){let W=n.get(C);if(C.version>
0&&W.__version!==C.version){Qt(W,C,y);return}t.bindTexture(i.TEXTURE_CUBE_MAP,W.__webglTexture,i.TEXTURE0+y)}let Ge={[Qa]:i.REPEAT,[Pi]:i.CLAMP_TO_EDGE,[ja]:i.MIRRORED_REPEAT},
tt={[Sn]:i.NEAREST,[Np]:i.NEAREST_MIPMAP_NEAREST,[Go]:i.NEAREST_MIPMAP_LINEAR,[Un]:i.LINEAR,[Cl]:i.LINEAR_MIPMAP_NEAREST,[is]:i.LINEAR_MIPMAP_LINEAR},ke={[Bp]:i.
NEVER,[lh]:i.ALWAYS,[zp]:i.LESS,[oh]:i.LEQUAL,[kp]:i.EQUAL,[ah]:i.GEQUAL,[Vp]:i.GREATER,[Gp]:i.NOTEQUAL};function ct(C,y){if(y.type===oi&&e.has("OES_texture_flo\
at_linear")===!1&&(y.magFilter===Un||y.magFilter===Cl||y.magFilter===Go||y.magFilter===is||y.minFilter===Un||y.minFilter===Cl||y.minFilter===Go||y.minFilter===is)&&
qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,
Ge[y.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Ge[y.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Ge[y.wrapR]),i.texParameteri(
C,i.TEXTURE_MAG_FILTER,tt[y.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,tt[y.minFilter]),y.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),
i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,ke[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Sn||y.minFilter!==Go&&y.minFilter!==
is||y.type===oi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let W=e.get("EXT_texture_filter_anisotropic");i.
texParameterf(C,W.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function rt(C,y){let W=!1;
C.__webglInit===void 0&&(C.__webglInit=!0,y.addEventListener("dispose",L),O(y));let ce=y.source,re=d.get(ce);re===void 0&&(re={},d.set(ce,re));let ge=j(y);if(ge!==
C.__cacheKey){re[ge]===void 0&&(re[ge]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,W=!0),re[ge].usedTimes++;let xe=re[C.__cacheKey];xe!==void 0&&
(re[C.__cacheKey].usedTimes--,xe.usedTimes===0&&k(y)),C.__cacheKey=ge,C.__webglTexture=re[ge].texture}return W}function je(C,y,W){return Math.floor(Math.floor(C/
W)/y)}function Vt(C,y,W,ce){let ge=C.updateRanges;if(ge.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,W,ce,y.data);else{ge.sort((U,se)=>U.start-
se.start);let xe=0;for(let U=1;U<ge.length;U++){let se=ge[xe],te=ge[U],be=se.start+se.count,me=je(te.start,y.width,4),ye=je(se.start,y.width,4);te.start<=be+1&&
me===ye&&je(te.start+te.count-1,y.width,4)===me?se.count=Math.max(se.count,te.start+te.count-se.start):(++xe,ge[xe]=te)}ge.length=xe+1;let ee=t.getParameter(i.UNPACK_ROW_LENGTH),
ne=t.getParameter(i.UNPACK_SKIP_PIXELS),de=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let U=0,se=ge.length;U<se;U++){let te=ge[U],
be=Math.floor(te.start/4),me=Math.ceil(te.count/4),ye=be%y.width,Ve=Math.floor(be/y.width),Ze=me,ae=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,ye),t.pixelStorei(i.UNPACK_SKIP_ROWS,
Ve),t.texSubImage2D(i.TEXTURE_2D,0,ye,Ve,Ze,ae,W,ce,y.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ee),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ne),t.
pixelStorei(i.UNPACK_SKIP_ROWS,de)}}function Nt(C,y,W){let ce=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(ce=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&
(ce=i.TEXTURE_3D);let re=rt(C,y),ge=y.source;t.bindTexture(ce,C.__webglTexture,i.TEXTURE0+W);let xe=n.get(ge);if(ge.version!==xe.__version||re===!0){if(t.activeTexture(
i.TEXTURE0+W),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let ae=gt.getPrimaries(gt.workingColorSpace),Fe=y.colorSpace===rs?null:gt.getPrimaries(
y.colorSpace),Je=y.colorSpace===rs||ae===Fe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,
y.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment);let ne=v(y.image,!1,s.maxTextureSize);
ne=ze(y,ne);let de=r.convert(y.format,y.colorSpace),U=r.convert(y.type),se=E(y.internalFormat,de,U,y.normalized,y.colorSpace,y.isVideoTexture);ct(ce,y);let te,be=y.
mipmaps,me=y.isVideoTexture!==!0,ye=xe.__version===void 0||re===!0,Ve=ge.dataReady,Ze=T(y,ne);if(y.isDepthTexture)se=_(y.format===ss,y.type),ye&&(me?t.texStorage2D(
i.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,de,U,null));else if(y.isDataTexture)if(be.length>0){me&&ye&&t.texStorage2D(
i.TEXTURE_2D,Ze,se,be[0].width,be[0].height);for(let ae=0,Fe=be.length;ae<Fe;ae++)te=be[ae],me?Ve&&t.texSubImage2D(i.TEXTURE_2D,ae,0,0,te.width,te.height,de,U,te.
data):t.texImage2D(i.TEXTURE_2D,ae,se,te.width,te.height,0,de,U,te.data);y.generateMipmaps=!1}else me?(ye&&t.texStorage2D(i.TEXTURE_2D,Ze,se,ne.width,ne.height),
Ve&&Vt(y,ne,de,U)):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,de,U,ne.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){me&&ye&&t.texStorage3D(
i.TEXTURE_2D_ARRAY,Ze,se,be[0].width,be[0].height,ne.depth);for(let ae=0,Fe=be.length;ae<Fe;ae++)if(te=be[ae],y.format!==yi)if(de!==null)if(me){if(Ve)if(y.layerUpdates.
size>0){let Je=mh(te.width,te.height,y.format,y.type);for(let Ee of y.layerUpdates){let it=te.data.subarray(Ee*Je/te.data.BYTES_PER_ELEMENT,(Ee+1)*Je/te.data.BYTES_PER_ELEMENT);
t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ae,0,0,Ee,te.width,te.height,1,de,it)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ae,0,0,0,te.width,te.height,
ne.depth,de,te.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ae,se,te.width,te.height,ne.depth,0,te.data,0,0);else qe("WebGLRenderer: Attempt to load uns\
upported compressed texture format in .uploadTexture()");else me?Ve&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ae,0,0,0,te.width,te.height,ne.depth,de,U,te.data):t.texImage3D(
i.TEXTURE_2D_ARRAY,ae,se,te.width,te.height,ne.depth,0,de,U,te.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{me&&ye&&t.texStorage2D(i.TEXTURE_2D,Ze,se,
be[0].width,be[0].height);for(let ae=0,Fe=be.length;ae<Fe;ae++)te=be[ae],y.format!==yi?de!==null?me?Ve&&t.compressedTexSubImage2D(i.TEXTURE_2D,ae,0,0,te.width,te.
height,de,te.data):t.compressedTexImage2D(i.TEXTURE_2D,ae,se,te.width,te.height,0,te.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture for\
mat in .uploadTexture()"):me?Ve&&t.texSubImage2D(i.TEXTURE_2D,ae,0,0,te.width,te.height,de,U,te.data):t.texImage2D(i.TEXTURE_2D,ae,se,te.width,te.height,0,de,U,
te.data)}else if(y.isDataArrayTexture)if(me){if(ye&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ze,se,ne.width,ne.height,ne.depth),Ve)if(y.layerUpdates.size>0){let ae=mh(
ne.width,ne.height,y.format,y.type);for(let Fe of y.layerUpdates){let Je=ne.data.subarray(Fe*ae/ne.data.BYTES_PER_ELEMENT,(Fe+1)*ae/ne.data.BYTES_PER_ELEMENT);t.
texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Fe,ne.width,ne.height,1,de,U,Je)}y.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,
ne.depth,de,U,ne.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,de,U,ne.data);else if(y.isData3DTexture)me?(ye&&t.texStorage3D(i.
TEXTURE_3D,Ze,se,ne.width,ne.height,ne.depth),Ve&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,de,U,ne.data)):t.texImage3D(i.TEXTURE_3D,0,se,
ne.width,ne.height,ne.depth,0,de,U,ne.data);else if(y.isFramebufferTexture){if(ye)if(me)t.texStorage2D(i.TEXTURE_2D,Ze,se,ne.width,ne.height);else{let ae=ne.width,
Fe=ne.height;for(let Je=0;Je<Ze;Je++)t.texImage2D(i.TEXTURE_2D,Je,se,ae,Fe,0,de,U,null),ae>>=1,Fe>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in i){let ae=i.
canvas;if(ae.hasAttribute("layoutsubtree")||ae.setAttribute("layoutsubtree","true"),ne.parentNode!==ae){ae.appendChild(ne),f.add(y),ae.onpaint=Fe=>{let Je=Fe.changedElements;
for(let Ee of f)Je.includes(Ee.image)&&(Ee.needsUpdate=!0)},ae.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,
ne);else{let Je=i.RGBA,Ee=i.RGBA,it=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Je,Ee,it,ne)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),
i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(be.length>0){if(me&&ye){let ae=We(
be[0]);t.texStorage2D(i.TEXTURE_2D,Ze,se,ae.width,ae.height)}for(let ae=0,Fe=be.length;ae<Fe;ae++)te=be[ae],me?Ve&&t.texSubImage2D(i.TEXTURE_2D,ae,0,0,de,U,te):
t.texImage2D(i.TEXTURE_2D,ae,se,de,U,te);y.generateMipmaps=!1}else if(me){if(ye){let ae=We(ne);t.texStorage2D(i.TEXTURE_2D,Ze,se,ae.width,ae.height)}Ve&&t.texSubImage2D(
i.TEXTURE_2D,0,0,0,de,U,ne)}else t.texImage2D(i.TEXTURE_2D,0,se,de,U,ne);A(y)&&y.mipmapsAutoUpdate===!0&&M(ce),xe.__version=ge.version,y.onUpdate&&y.onUpdate(y)}
C.__version=y.version}function Qt(C,y,W){if(y.image.length!==6)return;let ce=rt(C,y),re=y.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+W);
let ge=n.get(re);if(re.version!==ge.__version||ce===!0){t.activeTexture(i.TEXTURE0+W);let xe=gt.getPrimaries(gt.workingColorSpace),ee=y.colorSpace===rs?null:gt.
getPrimaries(y.colorSpace),ne=y.colorSpace===rs||xe===ee?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,
y.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let de=y.isCompressedTexture||y.image[0].
isCompressedTexture,U=y.image[0]&&y.image[0].isDataTexture,se=[];for(let Ee=0;Ee<6;Ee++)!de&&!U?se[Ee]=v(y.image[Ee],!0,s.maxCubemapSize):se[Ee]=U?y.image[Ee].image:
y.image[Ee],se[Ee]=ze(y,se[Ee]);let te=se[0],be=r.convert(y.format,y.colorSpace),me=r.convert(y.type),ye=E(y.internalFormat,be,me,y.normalized,y.colorSpace),Ve=y.
isVideoTexture!==!0,Ze=ge.__version===void 0||ce===!0,ae=re.dataReady,Fe=T(y,te);ct(i.TEXTURE_CUBE_MAP,y);let Je;if(y.isDepthTexture){if(ye=_(y.format===ss,y.type),
Ze)if(Ve)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,ye,te.width,te.height);else for(let Ee=0;Ee<6;Ee++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,0,ye,te.width,te.height,
0,be,me,null)}else if(de){Ve&&Ze&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Fe,ye,te.width,te.height);for(let Ee=0;Ee<6;Ee++){Je=se[Ee].mipmaps;for(let it=0;it<Je.length;it++){
let Ut=Je[it];y.format!==yi?be!==null?Ve?ae&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,it,0,0,Ut.width,Ut.height,be,Ut.data):t.compressedTexImage2D(
i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,it,ye,Ut.width,Ut.height,0,Ut.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube\
()"):Ve?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,it,0,0,Ut.width,Ut.height,be,me,Ut.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,it,ye,Ut.width,
Ut.height,0,be,me,Ut.data)}}}else{if(Je=y.mipmaps,Ve&&Ze){Je.length>0&&Fe++;let Ee=We(se[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Fe,ye,Ee.width,Ee.height)}for(let Ee=0;Ee<
6;Ee++)if(U){Ve?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,0,0,0,se[Ee].width,se[Ee].height,be,me,se[Ee].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+
Ee,0,ye,se[Ee].width,se[Ee].height,0,be,me,se[Ee].data);for(let it=0;it<Je.length;it++){let Cn=Je[it].image[Ee].image;Ve?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+
Ee,it+1,0,0,Cn.width,Cn.height,be,me,Cn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,it+1,ye,Cn.width,Cn.height,0,be,me,Cn.data)}}else{Ve?ae&&t.texSubImage2D(
i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,0,0,0,be,me,se[Ee]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,0,ye,be,me,se[Ee]);for(let it=0;it<Je.length;it++){let Ut=Je[it];
Ve?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,it+1,0,0,be,me,Ut.image[Ee]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ee,it+1,ye,be,me,Ut.image[Ee])}}}
A(y)&&y.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),ge.__version=re.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function Rt(C,y,W,ce,re,ge){let xe=r.
convert(W.format,W.colorSpace),ee=r.convert(W.type),ne=E(W.internalFormat,xe,ee,W.normalized,W.colorSpace),de=n.get(y),U=n.get(W);if(U.__renderTarget=y,!de.__hasExternalTextures){
let se=Math.max(1,y.width>>ge),te=Math.max(1,y.height>>ge);re===i.TEXTURE_3D||re===i.TEXTURE_2D_ARRAY?t.texImage3D(re,ge,ne,se,te,y.depth,0,xe,ee,null):t.texImage2D(
re,ge,ne,se,te,0,xe,ee,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),Me(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,re,U.__webglTexture,0,nt(y)):(re===i.
TEXTURE_2D||re>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ce,re,U.__webglTexture,ge),t.bindFramebuffer(
i.FRAMEBUFFER,null)}function mn(C,y,W){if(i.bindRenderbuffer(i.RENDERBUFFER,C),y.depthBuffer){let ce=y.depthTexture,re=ce&&ce.isDepthTexture?ce.type:null,ge=_(y.
stencilBuffer,re),xe=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Me(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,nt(y),ge,y.width,y.height):
W?i.renderbufferStorageMultisample(i.RENDERBUFFER,nt(y),ge,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,ge,y.width,y.height),i.framebufferRenderbuffer(
i.FRAMEBUFFER,xe,i.RENDERBUFFER,C)}else{let ce=y.textures;for(let re=0;re<ce.length;re++){let ge=ce[re],xe=r.convert(ge.format,ge.colorSpace),ee=r.convert(ge.type),
ne=E(ge.internalFormat,xe,ee,ge.normalized,ge.colorSpace);Me(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,nt(y),ne,y.width,y.height):W?i.renderbufferStorageMultisample(
i.RENDERBUFFER,nt(y),ne,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,ne,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xt(C,y,W){
let ce=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTexture\
s: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=n.get(y.depthTexture);re.__renderTarget=y;let ge=ce?y.depthTexture.image[0]:y.depthTexture.
image;(!re.__webglTexture||ge.width!==y.width||ge.height!==y.height)&&(ge.width=y.width,ge.height=y.height,y.depthTexture.needsUpdate=!0),ce?Se(y.depthTexture,0):
pe(y.depthTexture,0);let xe=re.__webglTexture,ee=nt(y),ne=ce?i.TEXTURE_CUBE_MAP_POSITIVE_X+W:i.TEXTURE_2D,de=y.depthTexture.format===ss?i.DEPTH_STENCIL_ATTACHMENT:
i.DEPTH_ATTACHMENT;if(y.depthTexture.format===Ki)Me(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,de,ne,xe,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,de,
ne,xe,0);else if(y.depthTexture.format===ss)Me(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,de,ne,xe,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,de,ne,xe,
0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function an(C){let y=n.get(C),W=C.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==
C.depthTexture){let ce=C.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),ce){let re=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,
ce.removeEventListener("dispose",re)};ce.addEventListener("dispose",re),y.__depthDisposeCallback=re}y.__boundDepthTexture=ce}if(C.depthTexture&&!y.__autoAllocateDepthBuffer)
if(W)for(let ce=0;ce<6;ce++)xt(y.__webglFramebuffer[ce],C,ce);else C.texture.mipmaps.length>0?xt(y.__webglFramebuffer[0],C,0):xt(y.__webglFramebuffer,C,0);else if(W){
y.__webglDepthbuffer=[];for(let ce=0;ce<6;ce++)if(t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[ce]),y.__webglDepthbuffer[ce]===void 0)y.__webglDepthbuffer[ce]=
i.createRenderbuffer(),mn(y.__webglDepthbuffer[ce],C,!1);else{let re=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ge=y.__webglDepthbuffer[ce];i.
bindRenderbuffer(i.RENDERBUFFER,ge),i.framebufferRenderbuffer(i.FRAMEBUFFER,re,i.RENDERBUFFER,ge)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,
y.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),mn(y.__webglDepthbuffer,
C,!1);else{let re=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ge=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ge),i.framebufferRenderbuffer(
i.FRAMEBUFFER,re,i.RENDERBUFFER,ge)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Xt(C,y,W){let ce=n.get(C);y!==void 0&&Rt(ce.__webglFramebuffer,C,C.texture,i.
COLOR_ATTACHMENT0,i.TEXTURE_2D,0),W!==void 0&&an(C)}function jt(C){let y=C.texture,W=n.get(C),ce=n.get(y);C.addEventListener("dispose",V),O(C);let re=C.textures,
ge=C.isWebGLCubeRenderTarget===!0,xe=re.length>1;if(xe||(ce.__webglTexture===void 0&&(ce.__webglTexture=i.createTexture()),ce.__version=y.version,o.memory.textures++),
ge){W.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(y.mipmaps.length>0){W.__webglFramebuffer[ee]=[];for(let ne=0;ne<y.mipmaps.length;ne++)W.__webglFramebuffer[ee][ne]=
i.createFramebuffer()}else W.__webglFramebuffer[ee]=i.createFramebuffer()}else{if(y.mipmaps.length>0){W.__webglFramebuffer=[];for(let ee=0;ee<y.mipmaps.length;ee++)
W.__webglFramebuffer[ee]=i.createFramebuffer()}else W.__webglFramebuffer=i.createFramebuffer();if(xe)for(let ee=0,ne=re.length;ee<ne;ee++){let de=n.get(re[ee]);
de.__webglTexture===void 0&&(de.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&Me(C)===!1){W.__webglMultisampledFramebuffer=i.createFramebuffer(),
W.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,W.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ne=re[ee];W.__webglColorRenderbuffer[ee]=
i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,W.__webglColorRenderbuffer[ee]);let de=r.convert(ne.format,ne.colorSpace),U=r.convert(ne.type),se=E(ne.
internalFormat,de,U,ne.normalized,ne.colorSpace,C.isXRRenderTarget===!0),te=nt(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,te,se,C.width,C.height),i.framebufferRenderbuffer(
i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ee,i.RENDERBUFFER,W.__webglColorRenderbuffer[ee])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(W.__webglDepthRenderbuffer=
i.createRenderbuffer(),mn(W.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ge){t.bindTexture(i.TEXTURE_CUBE_MAP,ce.__webglTexture),ct(
i.TEXTURE_CUBE_MAP,y);for(let ee=0;ee<6;ee++)if(y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Rt(W.__webglFramebuffer[ee][ne],C,y,i.COLOR_ATTACHMENT0,
i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ne);else Rt(W.__webglFramebuffer[ee],C,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);A(y)?M(i.TEXTURE_CUBE_MAP):y.mipmaps.
length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(xe){for(let ee=0,ne=re.length;ee<ne;ee++){let de=re[ee],
U=n.get(de),se=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(se=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(se,
U.__webglTexture),ct(se,de),Rt(W.__webglFramebuffer,C,de,i.COLOR_ATTACHMENT0+ee,se,0),A(de)&&M(se)}t.unbindTexture()}else{let ee=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||
C.isWebGLArrayRenderTarget)&&(ee=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ee,ce.__webglTexture),ct(ee,y),y.mipmaps.length>0)for(let ne=0;ne<
y.mipmaps.length;ne++)Rt(W.__webglFramebuffer[ne],C,y,i.COLOR_ATTACHMENT0,ee,ne);else Rt(W.__webglFramebuffer,C,y,i.COLOR_ATTACHMENT0,ee,0);A(y)?M(ee):y.mipmaps.
length>0&&i.texParameteri(ee,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&an(C)}function F(C){let y=C.textures;for(let W=0,ce=y.length;W<
ce;W++){let re=y[W];if(A(re)&&re.mipmapsAutoUpdate===!0){let ge=P(C),xe=n.get(re).__webglTexture;t.bindTexture(ge,xe),M(ge),t.unbindTexture()}}}let Ce=[];function Xe(C){
if(C.samples>0){if(Me(C)===!1){let y=C.textures,W=C.width,ce=C.height,re=i.COLOR_BUFFER_BIT,ge=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=n.
get(C),ee=y.length>1;if(ee)for(let de=0;de<y.length;de++)t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,
i.COLOR_ATTACHMENT0+de,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+
de,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,xe.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,
xe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let de=0;de<y.length;de++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(re|=
i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(re|=i.STENCIL_BUFFER_BIT)),ee){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.
RENDERBUFFER,xe.__webglColorRenderbuffer[de]);let U=n.get(y[de]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}
i.blitFramebuffer(0,0,W,ce,0,0,W,ce,re,i.NEAREST),c===!0&&(Ce.length=0,Ce.push(i.COLOR_ATTACHMENT0+de),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(
ge),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ee)for(let de=0;de<
y.length;de++){t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+de,i.RENDERBUFFER,
xe.__webglColorRenderbuffer[de]);let U=n.get(y[de]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,
i.COLOR_ATTACHMENT0+de,i.TEXTURE_2D,U,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,xe.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===
!1&&c){let y=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function nt(C){return Math.min(s.maxSamples,
C.samples)}function Me(C){let y=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function It(C){let y=o.
render.frame;u.get(C)!==y&&(u.set(C,y),C.update())}function ze(C,y){let W=C.colorSpace,ce=C.format,re=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===
!0||W!==go&&W!==rs&&(gt.getTransfer(W)===Tt?(ce!==yi||re!==Bn)&&qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ke("WebG\
LTextures: Unsupported texture color space:",W)),y}function We(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(l.width=C.naturalWidth||C.width,
l.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(l.width=C.displayWidth,l.height=C.displayHeight):(l.width=C.width,l.height=C.
height),l}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=he,this.setTexture2D=pe,this.setTexture2DArray=_e,this.
setTexture3D=Ae,this.setTextureCube=Se,this.rebindTextures=Xt,this.setupRenderTarget=jt,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Xe,this.
setupDepthRenderbuffer=an,this.setupFrameBufferTexture=Rt,this.useMultisampledRTT=Me,this.dispose=G}function vM(i,e){function t(n,s=rs){let r,o=gt.getTransfer(s);
if(n===Bn)return i.UNSIGNED_BYTE;if(n===Pl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Il)return i.UNSIGNED_SHORT_5_5_5_1;if(n===nh)return i.UNSIGNED_INT_5_9_9_9_REV;
if(n===ih)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===eh)return i.BYTE;if(n===th)return i.SHORT;if(n===kr)return i.UNSIGNED_SHORT;if(n===Rl)return i.INT;if(n===
xi)return i.UNSIGNED_INT;if(n===oi)return i.FLOAT;if(n===vi)return i.HALF_FLOAT;if(n===sh)return i.ALPHA;if(n===rh)return i.RGB;if(n===yi)return i.RGBA;if(n===Ki)
return i.DEPTH_COMPONENT;if(n===ss)return i.DEPTH_STENCIL;if(n===Ll)return i.RED;if(n===Dl)return i.RED_INTEGER;if(n===As)return i.RG;if(n===Nl)return i.RG_INTEGER;
if(n===Ul)return i.RGBA_INTEGER;if(n===Ho||n===Wo||n===Xo||n===qo)if(o===Tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ho)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;
if(n===Wo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Xo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===qo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else
return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ho)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Wo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;
if(n===Xo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===qo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Fl||n===Ol||n===Bl||n===zl)if(r=e.get(
"WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Fl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ol)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Bl)return r.
COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===zl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===kl||n===Vl||n===Gl||n===Hl||n===Wl||n===Yo||n===Xl)
if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===kl||n===Vl)return o===Tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Gl)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:
r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Hl)return r.COMPRESSED_R11_EAC;if(n===Wl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Yo)return r.COMPRESSED_RG11_EAC;if(n===Xl)
return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===ql||n===Yl||n===Zl||n===Jl||n===$l||n===Kl||n===Ql||n===jl||n===ec||n===tc||n===nc||n===ic||n===sc||
n===rc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===ql)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===
Yl)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Zl)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;
if(n===Jl)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===$l)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;
if(n===Kl)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ql)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;
if(n===jl)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ec)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.
COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===tc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===nc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:
r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ic)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===sc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:
r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===rc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===oc||n===
ac||n===lc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===oc)return o===Tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;
if(n===ac)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===lc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===cc||n===uc||n===Zo||n===
hc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===cc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===uc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Zo)
return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===hc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ws?i.UNSIGNED_INT_24_8:i[n]!==void 0?
i[n]:null}return{convert:t}}var yM="\nvoid main() {\n\n gl_Position = vec4( position, 1.0 );\n\n}",SM="\nuniform sampler2DArray depthColor;\nuniform float depthWi\
dth;\nuniform float depthHeight;\n\nvoid main() {\n\n vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );\n\n if ( coord.x >= 1.0 ) {\n\n  gl\
_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;\n\n } else {\n\n  gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;\n\n }\n\
\n}",wh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ro(e.texture);(e.depthNear!==
t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){
let t=e.cameras[0].viewport,n=new Di({vertexShader:yM,fragmentShader:SM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});
this.mesh=new ri(new Io(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Th=class extends Ii{constructor(e,t){
super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,f=null,h=null,d=null,x=null,S=typeof XRWebGLBinding<"u",p=new wh,m={},v=t.getContextAttributes(),
A=null,M=null,P=[],E=[],_=new ft,T=null,O=null,D=new Nn;D.viewport=new Ht;let L=new Nn;L.viewport=new Ht;let V=[D,L],H=new wl,N=null,G=null;this.cameraAutoUpdate=
!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let pe=P[j];return pe===void 0&&(pe=new Lr,P[j]=pe),pe.getTargetRaySpace()},this.getControllerGrip=
function(j){let pe=P[j];return pe===void 0&&(pe=new Lr,P[j]=pe),pe.getGripSpace()},this.getHand=function(j){let pe=P[j];return pe===void 0&&(pe=new Lr,P[j]=pe),
pe.getHandSpace()};function J(j){let pe=E.indexOf(j.inputSource);if(pe===-1)return;let _e=P[pe];_e!==void 0&&(_e.update(j.inputSource,j.frame,l||o),_e.dispatchEvent(
{type:j.type,data:j.inputSource}))}function k(){s.removeEventListener("select",J),s.removeEventListener("selectstart",J),s.removeEventListener("selectend",J),s.
removeEventListener("squeeze",J),s.removeEventListener("squeezestart",J),s.removeEventListener("squeezeend",J),s.removeEventListener("end",k),s.removeEventListener(
"inputsourceschange",le);for(let j=0;j<P.length;j++){let pe=E[j];pe!==null&&(E[j]=null,P[j].disconnect(pe))}N=null,G=null,p.reset();for(let j in m)delete m[j];if(e.
setRenderTarget(A),d=null,h=null,f=null,s=null,M=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(T),e.setSize(_.width,_.height,!1),O!==null){let j=O.camera;j.fov=
O.fov,j.zoom=O.zoom,j.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,n.isPresenting===!0&&qe(
"WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,n.isPresenting===!0&&qe("WebXRManager: Cannot cha\
nge reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(j){l=j},this.getBaseLayer=function(){
return h!==null?h:d},this.getBinding=function(){return f===null&&S&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return x},this.getSession=function(){
return s},this.setSession=async function(j){if(s=j,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",J),s.addEventListener("selectstart",J),s.addEventListener(
"selectend",J),s.addEventListener("squeeze",J),s.addEventListener("squeezestart",J),s.addEventListener("squeezeend",J),s.addEventListener("end",k),s.addEventListener(
"inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(_),S&&"createProjectionLayer"in XRWebGLBinding.prototype){
let _e=null,Ae=null,Se=null;v.depth&&(Se=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=v.stencil?ss:Ki,Ae=v.stencil?Ws:xi);let Ge={colorFormat:t.RGBA8,depthFormat:Se,
scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Ge),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),
M=new $n(h.textureWidth,h.textureHeight,{format:yi,type:Bn,depthTexture:new ns(h.textureWidth,h.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:v.
stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.
ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let _e={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};
d=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new $n(d.framebufferWidth,
d.framebufferHeight,{format:yi,type:Bn,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.
ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.
setFoveation(c),l=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=
function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function le(j){for(let pe=0;pe<j.removed.length;pe++){
let _e=j.removed[pe],Ae=E.indexOf(_e);Ae>=0&&(E[Ae]=null,P[Ae].disconnect(_e))}for(let pe=0;pe<j.added.length;pe++){let _e=j.added[pe],Ae=E.indexOf(_e);if(Ae===
-1){for(let Ge=0;Ge<P.length;Ge++)if(Ge>=E.length){E.push(_e),Ae=Ge;break}else if(E[Ge]===null){E[Ge]=_e,Ae=Ge;break}if(Ae===-1)break}let Se=P[Ae];Se&&Se.connect(
_e)}}function $(j,pe){pe===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(pe.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}
this.updateCamera=function(j){if(s===null)return;let pe=j.near,_e=j.far;p.texture!==null&&(p.depthNear>0&&(pe=p.depthNear),p.depthFar>0&&(_e=p.depthFar)),H.near=
L.near=D.near=pe,H.far=L.far=D.far=_e,(N!==H.near||G!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),N=H.near,G=H.far),H.layers.mask=j.layers.
mask|6,D.layers.mask=H.layers.mask&-5,L.layers.mask=H.layers.mask&-3;let Ae=j.parent,Se=H.cameras;$(H,Ae);for(let Ge=0;Ge<Se.length;Ge++)$(Se[Ge],Ae);H.projectionMatrix.
copy(D.projectionMatrix),H.projectionMatrixInverse.copy(D.projectionMatrixInverse),O===null&&j.isPerspectiveCamera&&(O={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,H,Ae)};
function Q(j,pe,_e){_e===null?j.matrix.copy(pe.matrixWorld):(j.matrix.copy(_e.matrixWorld),j.matrix.invert(),j.matrix.multiply(pe.matrixWorld)),j.matrix.decompose(
j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(pe.projectionMatrix),j.projectionMatrixInverse.copy(pe.projectionMatrixInverse),
j.isPerspectiveCamera&&(j.fov=tl*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(h===
null&&d===null))return c},this.setFoveation=function(j){c=j,h!==null&&(h.fixedFoveation=j),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=j)},this.hasDepthSensing=
function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(j){return m[j]};let ie=null;function he(j,pe){
if(u=pe.getViewerPose(l||o),x=pe,u!==null){let _e=u.views;d!==null&&(e.setRenderTargetFramebuffer(M,d.framebuffer),e.setRenderTarget(M));let Ae=!1;_e.length!==H.
cameras.length&&(H.cameras.length=0,Ae=!0);for(let ke=0;ke<_e.length;ke++){let ct=_e[ke],rt=null;if(d!==null)rt=d.getViewport(ct);else{let Vt=f.getViewSubImage(
h,ct);rt=Vt.viewport,ke===0&&(e.setRenderTargetTextures(M,Vt.colorTexture,Vt.depthStencilTexture),e.setRenderTarget(M))}let je=V[ke];je===void 0&&(je=new Nn,je.
layers.enable(ke),je.viewport=new Ht,V[ke]=je),je.matrix.fromArray(ct.transform.matrix),je.matrix.decompose(je.position,je.quaternion,je.scale),je.projectionMatrix.
fromArray(ct.projectionMatrix),je.projectionMatrixInverse.copy(je.projectionMatrix).invert(),je.viewport.set(rt.x,rt.y,rt.width,rt.height),ke===0&&(H.matrix.copy(
je.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Ae===!0&&H.cameras.push(je)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage==
"gpu-optimized"&&S){f=n.getBinding();let ke=f.getDepthInformation(_e[0]);ke&&ke.isValid&&ke.texture&&p.init(ke,s.renderState)}if(Se&&Se.includes("camera-access")&&
S){e.state.unbindTexture(),f=n.getBinding();for(let ke=0;ke<_e.length;ke++){let ct=_e[ke].camera;if(ct){let rt=m[ct];rt||(rt=new Ro,m[ct]=rt);let je=f.getCameraImage(
ct);rt.sourceTexture=je}}}}for(let _e=0;_e<P.length;_e++){let Ae=E[_e],Se=P[_e];Ae!==null&&Se!==void 0&&Se.update(Ae,pe,l||o)}ie&&ie(j,pe),pe.detectedPlanes&&n.
dispatchEvent({type:"planesdetected",data:pe}),x=null}let ue=new ym;ue.setAnimationLoop(he),this.setAnimationLoop=function(j){ie=j},this.dispose=function(){}}},
MM=new bt,Pm=new Qe;Pm.set(-1,0,0,0,1,0,0,0,1);function bM(i,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){
m.color.getRGB(p.fogColor.value,fh(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,v,A,M){m.
isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?
(r(p,m),f(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),h(p,m),m.isMeshPhysicalMaterial&&
d(p,m,M)):m.isMeshMatcapMaterial?(r(p,m),x(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),S(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?
(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?c(p,m,v,A):m.isSpriteMaterial?l(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=
m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.
value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,
p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Fn&&(p.bumpScale.value*=-1)),
m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Fn&&p.normalScale.value.negate()),
m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.
value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,
t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let v=e.get(m),A=v.envMap,M=v.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.
value.setFromMatrix4(MM.makeRotationFromEuler(M)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Pm),p.reflectivity.
value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,
t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.
value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.
dashSize+m.gapSize,p.scale.value=m.scale}function c(p,m,v,A){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*v,p.scale.value=A*.5,m.
map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.
alphaTest)}function l(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),
m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(
m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function f(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function h(p,m){p.metalness.value=m.
metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.
value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,v){p.ior.value=m.ior,m.diffuseRoughness>
0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),
m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,
t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),
m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,
p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),
m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.
clearcoatNormalScale),m.side===Fn&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.
value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,
p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),
m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>
0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(p.transmissionMap.
value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.
thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.
value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,
p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=
m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,
p.specularIntensityMapTransform))}function x(p,m){m.matcap&&(p.matcap.value=m.matcap)}function S(p,m){let v=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(
v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function wM(i,e,t,n){
let s={},r={};function o(v,A){let M=A.program;n.uniformBlockBinding(v,M,s[v.id])}function a(v,A){let M=s[v.id];M===void 0&&(x(v),M=c(v),s[v.id]=M,v.addEventListener(
"dispose",p));let P=A.program;n.updateUBOMapping(v,P);let E=e.render.frame;r[v.id]!==E&&(l(v),r[v.id]=E)}function c(v){let A=i.createBuffer(),M=v.__size,P=v.usage;
return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,M,P),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(v){let A=s[v.id],M=v.uniforms,P=v.__cache;
i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,_=M.length;E<_;E++){let T=M[E];if(Array.isArray(T))for(let O=0,D=T.length;O<D;O++)u(T[O],E,O,P);else u(T,E,0,P)}i.bindBuffer(
i.UNIFORM_BUFFER,null)}function u(v,A,M,P){if(h(v,A,M,P)===!0){let E=v.__offset,_=v.value;if(Array.isArray(_)){let T=0;for(let O=0;O<_.length;O++){let D=_[O],L=S(
D,!0);f(D,v.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,v.__data)}}function f(v,A,M){typeof v==
"number"||typeof v=="boolean"?A[M]=v:v.isMatrix3?(A[M]=v.elements[0],A[M+1]=v.elements[1],A[M+2]=v.elements[2],A[M+3]=0,A[M+4]=v.elements[3],A[M+5]=v.elements[4],
A[M+6]=v.elements[5],A[M+7]=0,A[M+8]=v.elements[6],A[M+9]=v.elements[7],A[M+10]=v.elements[8],A[M+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-M),M):
v.toArray(A,M)}function h(v,A,M,P){let E=v.value,_=A+"_"+M;if(Array.isArray(E)){P[_]===void 0&&(P[_]=[]);let T=P[_],O=!1;for(let D=0;D<E.length;D++)d(E[D],T,D)===
!0&&(O=!0);return O}return d(E,P,_)}function d(v,A,M){if(A[M]===void 0)return typeof v=="number"||typeof v=="boolean"?A[M]=v:ArrayBuffer.isView(v)?A[M]=v.slice():
A[M]=v.clone(),!0;{let P=A[M];if(typeof v=="number"||typeof v=="boolean"){if(P!==v)return A[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(P.equals(v)===!1)return P.
copy(v),!0}}return!1}function x(v){let A=v.uniforms,M=0,P=16;for(let _=0,T=A.length;_<T;_++){let O=Array.isArray(A[_])?A[_]:[A[_]];for(let D=0,L=O.length;D<L;D++){
let V=O[D],H=Array.isArray(V.value)?V.value:[V.value],N=Array.isArray(A[_])||Array.isArray(V.value),G=M;for(let k=0,le=H.length;k<le;k++){let $=H[k],Q=S($,N),ie=M%
P,he=ie%Q.boundary,ue=ie+he;M+=he,ue!==0&&P-ue<Q.storage&&(M+=P-ue),k===0&&(G=M),M+=Q.storage}let J=V.type==="int"?Int32Array:V.type==="uint"?Uint32Array:Float32Array;
V.__data=new J((M-G)/Float32Array.BYTES_PER_ELEMENT),V.__offset=G}}let E=M%P;return E>0&&(M+=P-E),v.__size=M,v.__cache={},this}function S(v,A){let M={boundary:0,
storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,
M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?qe("WebGLRe\
nderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):qe("WebGLRenderer: Unsupported uni\
form value type.",v),A===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function p(v){let A=v.target;A.removeEventListener("dispose",p),i.deleteBuffer(
s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var TM=new Uint16Array([12469,
15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,
15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,
11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,
14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,
12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,
12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,
12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,
11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,
8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,
8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,
8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,
8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,
7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,
7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,
6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,
4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,
2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,
479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Fi=null;function AM(){return Fi===null&&(Fi=new To(
TM,16,16,As,vi),Fi.name="DFG_LUT",Fi.minFilter=Un,Fi.magFilter=Un,Fi.wrapS=Pi,Fi.wrapT=Pi,Fi.generateMipmaps=!1,Fi.needsUpdate=!0),Fi}var gc=class{constructor(e={}){
let{canvas:t=Wp(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",
failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=Bn}=e;this.isWebGLRenderer=!0;let x;if(n!==null){if(typeof WebGLRenderingContext<"\
u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");x=n.getContextAttributes().alpha}else x=o;let S=d,
p=new Set([Ul,Nl,Dl]),m=new Set([Bn,xi,kr,Ws,Pl,Il]),v=new Uint32Array(4),A=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},P=null,E=null,_=[],T=[],
O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=
!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ui,this.toneMappingExposure=1,this.transmissionResolutionScale=
1;let D=this,L=!1,V=null,H=null,N=null,G=null;this._outputColorSpace=Zn;let J=0,k=0,le=null,$=-1,Q=null,ie=new Ht,he=new Ht,ue=null,j=new st(0),pe=0,_e=t.width,
Ae=t.height,Se=1,Ge=null,tt=null,ke=new Ht(0,0,_e,Ae),ct=new Ht(0,0,_e,Ae),rt=!1,je=new ys,Vt=new rl,Nt=!1,Qt=!1,Rt=new bt,mn=new q,xt=new Ht,an={background:null,
fog:null,environment:null,overrideMaterial:null,isScene:!0},Xt=!1;function jt(){return le===null?Se:1}let F=n;function Ce(w,B){return t.getContext(w,B)}let Xe,nt,
Me,It,ze,We,C,y,W,ce,re,ge,xe,ee,ne,de,U,se,te,be,me,ye,Ve;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,
failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine","three.js r".concat("187")),t.addEventListener("webglcontextlost",Fe,!1),t.addEventListener(
"webglcontextrestored",Je,!1),t.addEventListener("webglcontextcreationerror",Ee,!1),F===null){let B="webgl2";if(F=Ce(B,w),F===null)throw Ce(B)?new Error("THREE.\
WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ze()}catch(w){throw t.
removeEventListener("webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ee,!1),Ke("W\
ebGLRenderer: "+w.message),w}function Ze(){Xe=new Oy(F),Xe.init(),me=new vM(F,Xe),nt=new Ay(F,Xe,e,me),Me=new _M(F,Xe),nt.reversedDepthBuffer&&h&&Me.buffers.depth.
setReversed(!0),H=F.createFramebuffer(),N=F.createFramebuffer(),G=F.createFramebuffer(),It=new ky(F),ze=new iM,We=new xM(F,Xe,Me,ze,nt,me,It),C=new Fy(D),y=new G_(
F),ye=new wy(F,y),W=new By(F,y,It,ye),ce=new Gy(F,W,y,ye,It),se=new Vy(F,nt,We),ne=new Ey(ze),re=new nM(D,C,Xe,nt,ye,ne),ge=new bM(D,ze),xe=new rM,ee=new hM(Xe),
U=new by(D,C,Me,ce,x,c),de=new gM(D,ce,nt),Ve=new wM(F,It,nt,Me),te=new Ty(F,Xe,It),be=new zy(F,Xe,It),It.programs=re.programs,D.capabilities=nt,D.extensions=Xe,
D.properties=ze,D.renderLists=xe,D.shadowMap=de,D.state=Me,D.info=It}S!==Bn&&(O=new Wy(S,t.width,t.height,a,s,r));let ae=new Th(D,F);this.xr=ae,this.getContext=
function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let w=Xe.get("WEBGL_lose_context");w&&
w.loseContext()},this.forceContextRestore=function(){let w=Xe.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=
function(w){w!==void 0&&(Se=w,this.setSize(_e,Ae,!1))},this.getSize=function(w){return w.set(_e,Ae)},this.setSize=function(w,B,K=!0){if(ae.isPresenting){qe("Web\
GLRenderer: Can't change size while VR device is presenting.");return}_e=w,Ae=B,t.width=Math.floor(w*Se),t.height=Math.floor(B*Se),K===!0&&(t.style.width=w+"px",
t.style.height=B+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,w,B)},this.getDrawingBufferSize=function(w){return w.set(_e*Se,Ae*Se).floor()},
this.setDrawingBufferSize=function(w,B,K){_e=w,Ae=B,Se=K,t.width=Math.floor(w*K),t.height=Math.floor(B*K),this.setViewport(0,0,w,B)},this.setEffects=function(w){
if(S===Bn){Ke("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let B=0;B<w.length;B++)if(w[B].isOutputPass===
!0){qe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(w||[])},
this.getCurrentViewport=function(w){return w.copy(ie)},this.getViewport=function(w){return w.copy(ke)},this.setViewport=function(w,B,K,X){w.isVector4?ke.set(w.x,
w.y,w.z,w.w):ke.set(w,B,K,X),Me.viewport(ie.copy(ke).multiplyScalar(jt()).round())},this.getScissor=function(w){return w.copy(ct)},this.setScissor=function(w,B,K,X){
w.isVector4?ct.set(w.x,w.y,w.z,w.w):ct.set(w,B,K,X),Me.scissor(he.copy(ct).multiplyScalar(jt()).round())},this.getScissorTest=function(){return rt},this.setScissorTest=
function(w){Me.setScissorTest(rt=w)},this.setOpaqueSort=function(w){Ge=w},this.setTransparentSort=function(w){tt=w},this.getClearColor=function(w){return w.copy(
U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){
U.setClearAlpha(...arguments)},this.clear=function(w=!0,B=!0,K=!0){let X=0;if(w){let Y=!1;if(le!==null){let we=le.texture.format;Y=p.has(we)}if(Y){let we=le.texture.
type,Re=m.has(we),Te=U.getClearColor(),Pe=U.getClearAlpha(),Be=Te.r,$e=Te.g,ut=Te.b;Re?(v[0]=Be,v[1]=$e,v[2]=ut,v[3]=Pe,F.clearBufferuiv(F.COLOR,0,v)):(A[0]=Be,
A[1]=$e,A[2]=ut,A[3]=Pe,F.clearBufferiv(F.COLOR,0,A))}else X|=F.COLOR_BUFFER_BIT}B&&(X|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(X|=F.STENCIL_BUFFER_BIT,
this.state.buffers.stencil.setMask(4294967295)),X!==0&&F.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,
!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),V=w},this.dispose=function(){t.removeEventListener(
"webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ee,!1),U.dispose(),xe.dispose(),
ee.dispose(),We.dispose(),ze.dispose(),C.dispose(),ce.dispose(),W.dispose(),ye.dispose(),Ve.dispose(),re.dispose(),ae.dispose(),ae.removeEventListener("sessions\
tart",ea),ae.removeEventListener("sessionend",Si),Bi.stop()};function Fe(w){w.preventDefault(),uh("WebGLRenderer: Context Lost."),L=!0}function Je(){uh("WebGLRe\
nderer: Context Restored."),L=!1;let w=It.autoReset,B=de.enabled,K=de.autoUpdate,X=de.needsUpdate,Y=de.type;Ze(),It.autoReset=w,de.enabled=B,de.autoUpdate=K,de.
needsUpdate=X,de.type=Y}function Ee(w){Ke("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function it(w){let B=w.target;B.removeEventListener(
"dispose",it),Ut(B)}function Ut(w){Cn(w),ze.remove(w)}function Cn(w){let B=ze.get(w).programs;B!==void 0&&(B.forEach(function(K){re.releaseProgram(K)}),w.isShaderMaterial&&
re.releaseShaderCache(w))}this.renderBufferDirect=function(w,B,K,X,Y,we){B===null&&(B=an);let Re=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Te=Yr(w,B,K,X,Y);
Me.setMaterial(X,Re);let Pe=K.index,Be=1;if(X.wireframe===!0){if(Pe=W.getWireframeAttribute(K),Pe===void 0)return;Be=2}let $e=K.drawRange,ut=K.attributes.position,
Oe=$e.start*Be,ht=($e.start+$e.count)*Be;we!==null&&(Oe=Math.max(Oe,we.start*Be),ht=Math.min(ht,(we.start+we.count)*Be)),Pe!==null?(Oe=Math.max(Oe,0),ht=Math.min(
ht,Pe.count)):ut!=null&&(Oe=Math.max(Oe,0),ht=Math.min(ht,ut.count));let Wt=ht-Oe;if(Wt<0||Wt===1/0)return;ye.setup(Y,X,Te,K,Pe);let At,Et=te;if(Pe!==null&&(At=
y.get(Pe),Et=be,Et.setIndex(At)),Y.isMesh)X.wireframe===!0?(Me.setLineWidth(X.wireframeLinewidth*jt()),Et.setMode(F.LINES)):Et.setMode(F.TRIANGLES);else if(Y.isLine){
let ln=X.linewidth;ln===void 0&&(ln=1),Me.setLineWidth(ln*jt()),Y.isLineSegments?Et.setMode(F.LINES):Y.isLineLoop?Et.setMode(F.LINE_LOOP):Et.setMode(F.LINE_STRIP)}else
Y.isPoints?Et.setMode(F.POINTS):Y.isSprite&&Et.setMode(F.TRIANGLES);if(Y.isBatchedMesh)if(Xe.get("WEBGL_multi_draw"))Et.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,
Y._multiDrawCount);else{let ln=Y._multiDrawStarts,Ne=Y._multiDrawCounts,en=Y._multiDrawCount,pt=Pe?y.get(Pe).bytesPerElement:1,ki=ze.get(X).currentProgram.getUniforms();
for(let tn=0;tn<en;tn++)ki.setValue(F,"_gl_DrawID",tn),Et.render(ln[tn]/pt,Ne[tn])}else if(Y.isInstancedMesh)Et.renderInstances(Oe,Wt,Y.count);else if(K.isInstancedBufferGeometry){
let ln=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Ne=Math.min(K.instanceCount,ln);Et.renderInstances(Oe,Wt,Ne)}else Et.render(Oe,Wt)};function Wr(w,B,K,X){
V!==null&&w.isNodeMaterial&&V.setObject(X,w),Nt===!0&&ne.setState(w,K,!1),w.transparent===!0&&w.side===Ni&&w.forceSinglePass===!1?(w.side=Fn,w.needsUpdate=!0,Mi(
w,B,X),w.side=Ts,w.needsUpdate=!0,Mi(w,B,X),w.side=Ni):Mi(w,B,X)}this.compile=function(w,B,K=null){K===null&&(K=w),V!==null&&V.renderStart(w,B,K),E=ee.get(K),E.
init(B),T.push(E),K.traverseVisible(function(Y){Y.isLight&&Y.layers.test(B.layers)&&(E.pushLight(Y),Y.castShadow&&E.pushShadow(Y))}),w!==K&&w.traverseVisible(function(Y){
Y.isLight&&Y.layers.test(B.layers)&&(E.pushLight(Y),Y.castShadow&&E.pushShadow(Y))}),E.setupLights(),V!==null&&V.updateLights(E.state.lightsArray),Qt=this.localClippingEnabled,
Nt=ne.init(this.clippingPlanes,Qt),Nt===!0&&ne.setGlobalState(this.clippingPlanes,B),V!==null&&de.render(E.state.shadowsArray,K,B);let X=new Set;return w.traverse(
function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let we=Y.material;if(we)if(Array.isArray(we))for(let Re=0;Re<we.length;Re++){let Te=we[Re];Wr(
Te,K,B,Y),X.add(Te)}else Wr(we,K,B,Y),X.add(we)}),E=T.pop(),V!==null&&V.renderEnd(),X},this.compileAsync=function(w,B,K=null){let X=this.compile(w,B,K);return new Promise(
Y=>{function we(){if(X.forEach(function(Re){let Pe=ze.get(Re).currentProgram;(Pe===void 0||Pe.isReady())&&X.delete(Re)}),X.size===0){Y(w);return}setTimeout(we,10)}
Xe.get("KHR_parallel_shader_compile")!==null?we():setTimeout(we,10)})};let qs=null;function Sc(w){qs&&qs(w)}function ea(){Bi.stop()}function Si(){Bi.start()}let Bi=new ym;
Bi.setAnimationLoop(Sc),typeof self<"u"&&Bi.setContext(self),this.setAnimationLoop=function(w){qs=w,ae.setAnimationLoop(w),w===null?Bi.stop():Bi.start()},ae.addEventListener(
"sessionstart",ea),ae.addEventListener("sessionend",Si),this.render=function(w,B){if(B!==void 0&&B.isCamera!==!0){Ke("WebGLRenderer.render: camera is not an ins\
tance of THREE.Camera.");return}if(L===!0)return;V!==null&&V.renderStart(w,B);let K=ae.enabled===!0&&ae.isPresenting===!0,X=O!==null&&(le===null||K)&&O.begin(D,
le);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ae.enabled===!0&&ae.isPresenting===
!0&&(O===null||O.isCompositing()===!1)&&(ae.cameraAutoUpdate===!0&&ae.updateCamera(B),B=ae.getCamera()),w.isScene===!0&&w.onBeforeRender(D,w,B,le),E=ee.get(w,T.
length),E.init(B),E.state.textureUnits=We.getTextureUnits(),T.push(E),Rt.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Vt.setFromArrayCamera(
B):je.setFromProjectionMatrix(Rt,si,B.reversedDepth),Qt=this.localClippingEnabled,Nt=ne.init(this.clippingPlanes,Qt),P=xe.get(w,_.length),P.init(),_.push(P),this.
info.render.frame++,ae.enabled===!0&&ae.isPresenting===!0){let Re=D.xr.getDepthSensingMesh();Re!==null&&zi(Re,B,-1/0,D.sortObjects)}zi(w,B,0,D.sortObjects),P.finish(),
V!==null&&V.updateLights(E.state.lightsArray),D.sortObjects===!0&&P.sort(Ge,tt),Xt=ae.enabled===!1||ae.isPresenting===!1||ae.hasDepthSensing()===!1,Xt&&U.addToRenderList(
P,w),this.info.autoReset===!0&&this.info.reset(),Nt===!0&&ne.beginShadows();let Y=E.state.shadowsArray;if(de.render(Y,w,B),Nt===!0&&ne.endShadows(),(X&&O.hasRenderPass())===
!1){let Re=P.opaque,Te=P.transmissive;if(E.setupLights(),B.isArrayCamera){let Pe=B.cameras;if(Te.length>0)for(let Be=0,$e=Pe.length;Be<$e;Be++){let ut=Pe[Be];ai(
Re,Te,w,ut)}Xt&&U.render(w);for(let Be=0,$e=Pe.length;Be<$e;Be++){let ut=Pe[Be];Xr(P,w,ut,ut.viewport)}}else Te.length>0&&ai(Re,Te,w,B),Xt&&U.render(w),Xr(P,w,B)}
le!==null&&k===0&&(We.updateMultisampleRenderTarget(le),We.updateRenderTargetMipmap(le)),X&&O.end(D),w.isScene===!0&&w.onAfterRender(D,w,B),ye.resetDefaultState(),
$=-1,Q=null,T.pop(),T.length>0?(E=T[T.length-1],We.setTextureUnits(E.state.textureUnits),Nt===!0&&ne.setGlobalState(D.clippingPlanes,E.state.camera)):E=null,_.pop(),
_.length>0?P=_[_.length-1]:P=null,V!==null&&V.renderEnd()};function zi(w,B,K,X){if(w.visible===!1)return;if(w.layers.test(B.layers)){if(w.isGroup)K=w.renderOrder;else if(w.
isLOD)w.autoUpdate===!0&&w.update(B);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Re=B.isArrayCamera?Vt:je;if(!w.frustumCulled||
w.intersectsFrustum(Re)){X&&xt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Rt);let Te=ce.update(w),Pe=w.material;Pe.visible&&P.push(w,Te,Pe,K,xt.z,null,B)}}else if(w.
isMesh||w.isLine||w.isPoints){let Re=B.isArrayCamera?Vt:je;if(!w.frustumCulled||w.intersectsFrustum(Re)){let Te=ce.update(w),Pe=w.material;if(X&&(w.boundingSphere!==
void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xt.copy(w.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),xt.copy(Te.boundingSphere.
center)),xt.applyMatrix4(w.matrixWorld).applyMatrix4(Rt)),Array.isArray(Pe)){let Be=Te.groups;for(let $e=0,ut=Be.length;$e<ut;$e++){let Oe=Be[$e],ht=Pe[Oe.materialIndex];
ht&&ht.visible&&P.push(w,Te,ht,K,xt.z,Oe,B)}}else Pe.visible&&P.push(w,Te,Pe,K,xt.z,null,B)}}}let we=w.children;for(let Re=0,Te=we.length;Re<Te;Re++)zi(we[Re],B,
K,X)}function Xr(w,B,K,X){let{opaque:Y,transmissive:we,transparent:Re}=w;E.setupLightsView(K),Nt===!0&&ne.setGlobalState(D.clippingPlanes,K),X&&Me.viewport(ie.copy(
X)),Y.length>0&&qt(Y,B,K),we.length>0&&qt(we,B,K),Re.length>0&&qt(Re,B,K),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),
Me.setPolygonOffset(!1)}function ai(w,B,K,X){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[X.id]===void 0){let Oe=Xe.
has("EXT_color_buffer_half_float")||Xe.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[X.id]=new $n(1,1,{generateMipmaps:!0,type:Oe?vi:Bn,minFilter:is,
samples:Math.max(4,nt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:gt.
workingColorSpace})}let we=E.state.transmissionRenderTarget[X.id],Re=X.viewport||ie;we.setSize(Re.z*D.transmissionResolutionScale,Re.w*D.transmissionResolutionScale);
let Te=D.getRenderTarget(),Pe=D.getActiveCubeFace(),Be=D.getActiveMipmapLevel();D.setRenderTarget(we),D.getClearColor(j),pe=D.getClearAlpha(),pe<1&&D.setClearColor(
16777215,.5),D.clear(),Xt&&U.render(K);let $e=D.toneMapping;D.toneMapping=Ui;let ut=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),E.setupLightsView(X),
Nt===!0&&ne.setGlobalState(D.clippingPlanes,X),qt(w,K,X),We.updateMultisampleRenderTarget(we),We.updateRenderTargetMipmap(we),Xe.has("WEBGL_multisampled_render_\
to_texture")===!1){let Oe=!1;for(let ht=0,Wt=B.length;ht<Wt;ht++){let At=B[ht],{object:Et,geometry:ln,material:Ne,group:en}=At;if(Ne.side===Ni&&Et.layers.test(X.
layers)){let pt=Ne.side;Ne.side=Fn,Ne.needsUpdate=!0,$t(Et,K,X,ln,Ne,en),Ne.side=pt,Ne.needsUpdate=!0,Oe=!0}}Oe===!0&&(We.updateMultisampleRenderTarget(we),We.updateRenderTargetMipmap(
we))}D.setRenderTarget(Te,Pe,Be),D.setClearColor(j,pe),ut!==void 0&&(X.viewport=ut),D.toneMapping=$e}function qt(w,B,K){let X=B.isScene===!0?B.overrideMaterial:
null;for(let Y=0,we=w.length;Y<we;Y++){let Re=w[Y],{object:Te,geometry:Pe,group:Be}=Re,$e=Re.material;$e.allowOverride===!0&&X!==null&&($e=X),Te.layers.test(K.layers)&&
$t(Te,B,K,Pe,$e,Be)}}function $t(w,B,K,X,Y,we){V!==null&&Y.isNodeMaterial&&V.setObject(w,Y),w.onBeforeRender(D,B,K,X,Y,we),w.modelViewMatrix.multiplyMatrices(K.
matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Y.onBeforeRender(D,B,K,X,w,we),Y.transparent===!0&&Y.side===Ni&&Y.forceSinglePass===
!1?(Y.side=Fn,Y.needsUpdate=!0,D.renderBufferDirect(K,B,X,Y,w,we),Y.side=Ts,Y.needsUpdate=!0,D.renderBufferDirect(K,B,X,Y,w,we),Y.side=Ni):D.renderBufferDirect(
K,B,X,Y,w,we),w.onAfterRender(D,B,K,X,Y,we)}function Kt(w){let B=0;for(let K of w)K.texture!==null&&B++;return B}function Mi(w,B,K){B.isScene!==!0&&(B=an);let X=ze.
get(w),Y=E.state.lights,we=E.state.shadowsArray,Re=Y.state.version,Te=re.getParameters(w,Y.state,we,B,K,E.state.lightProbeGridArray),Pe=re.getProgramCacheKey(Te),
Be=X.programs;X.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?B.environment:null,X.fog=B.fog;let $e=w.isMeshStandardMaterial||
w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;X.envMap=C.get(w.envMap||X.environment,$e),X.envMapRotation=X.environment!==null&&w.envMap===
null?B.environmentRotation:w.envMapRotation,Be===void 0&&(w.addEventListener("dispose",it),Be=new Map,X.programs=Be,X.programVariants=new Map);let ut=Be.get(Pe);
if(ut!==void 0){if(X.currentProgram===ut&&X.lightsStateVersion===Re)return qr(w,Te),ut}else Te.uniforms=re.getUniforms(w),V!==null&&w.isNodeMaterial&&V.build(w,
K,Te),w.onBeforeCompile(Te,D),ut=re.acquireProgram(Te,Pe),Be.set(Pe,ut),X.uniforms=Te.uniforms;let Oe=X.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||
w.clipping===!0)&&(Oe.clippingPlanes=ne.uniform),qr(w,Te),X.needsLights=as(w),X.lightsStateVersion=Re,X.needsLights&&(Oe.ambientLightColor.value=Y.state.ambient,
Oe.lightProbe.value=Y.state.probe,Oe.sunLights.value=Y.state.sun,Oe.sunLightShadows.value=Y.state.sunShadow,Oe.directionalLights.value=Y.state.directional,Oe.directionalLightShadows.
value=Y.state.directionalShadow,Oe.spotLights.value=Y.state.spot,Oe.spotLightShadows.value=Y.state.spotShadow,Oe.rectAreaLights.value=Y.state.rectArea,Oe.ltc_1.
value=Y.state.rectAreaLTC1,Oe.ltc_2.value=Y.state.rectAreaLTC2,Oe.pointLights.value=Y.state.point,Oe.pointLightShadows.value=Y.state.pointShadow,Oe.hemisphereLights.
value=Y.state.hemi,Oe.sunShadowMatrix.value=Y.state.sunShadowMatrix,Oe.sunShadowCascade.value=Y.state.sunShadowCascade,Oe.directionalShadowMatrix.value=Y.state.
directionalShadowMatrix,Oe.spotLightMatrix.value=Y.state.spotLightMatrix,Oe.spotLightMap.value=Y.state.spotLightMap,Oe.pointShadowMatrix.value=Y.state.pointShadowMatrix),
X.numLightProbeGrids=Kt(E.state.lightProbeGridArray),X.currentProgram=ut,X.uniformsList=null,ut}function zn(w,B,K,X,Y){let we=ze.get(w),Re=we.currentProgram.id+
","+X+","+Y,Te=we.programVariants.get(Re);return Te===void 0?(Te=Mi(w,B,K),we.programVariants.set(Re,Te)):(we.currentProgram=Te,we.uniformsList=null,we.outputColorSpace=
X,we.toneMapping=Y),Te}function os(w){if(w.uniformsList===null){let B=w.currentProgram.getUniforms();w.uniformsList=Vr.seqWithValue(B.seq,w.uniforms)}return w.uniformsList}
function qr(w,B){let K=ze.get(w);K.outputColorSpace=B.outputColorSpace,K.batching=B.batching,K.batchingColor=B.batchingColor,K.instancing=B.instancing,K.instancingColor=
B.instancingColor,K.instancingMorph=B.instancingMorph,K.skinning=B.skinning,K.morphTargets=B.morphTargets,K.morphNormals=B.morphNormals,K.morphColors=B.morphColors,
K.morphTargetsCount=B.morphTargetsCount,K.numClippingPlanes=B.numClippingPlanes,K.numIntersection=B.numClipIntersection,K.vertexAlphas=B.vertexAlphas,K.vertexTangents=
B.vertexTangents,K.toneMapping=B.toneMapping}function Yr(w,B,K,X,Y){B.isScene!==!0&&(B=an),We.resetTextureUnits();let we=B.fog,Re=X.isMeshStandardMaterial||X.isMeshLambertMaterial||
X.isMeshPhongMaterial?B.environment:null,Te=le===null?D.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:gt.workingColorSpace,Pe=X.isMeshStandardMaterial||
X.isMeshLambertMaterial&&!X.envMap||X.isMeshPhongMaterial&&!X.envMap,Be=C.get(X.envMap||Re,Pe),$e=X.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.
itemSize===4,ut=!!K.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Oe=!!K.morphAttributes.position,ht=!!K.morphAttributes.normal,Wt=!!K.morphAttributes.color,
At=Ui;X.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(At=D.toneMapping);let Et=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,
ln=Et!==void 0?Et.length:0,Ne=ze.get(X),en=E.state.lights;if(Nt===!0&&(Qt===!0||w!==Q)){let Ct=w===Q&&X.id===$;ne.setState(X,w,Ct)}let pt=!1,ki=!1;X.version===Ne.
__version?Ne.needsLights&&Ne.lightsStateVersion!==en.state.version||Y.isBatchedMesh&&Ne.batching===!1||!Y.isBatchedMesh&&Ne.batching===!0||Y.isBatchedMesh&&Ne.batchingColor===
!0&&Y._colorsTexture===null||Y.isBatchedMesh&&Ne.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&Ne.instancing===!1||!Y.isInstancedMesh&&Ne.instancing===
!0||Y.isSkinnedMesh&&Ne.skinning===!1||!Y.isSkinnedMesh&&Ne.skinning===!0||Y.isInstancedMesh&&Ne.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&
Ne.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Ne.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Ne.instancingMorph===!1&&
Y.morphTexture!==null||Ne.envMap!==Be||X.fog===!0&&Ne.fog!==we||Ne.numClippingPlanes!==void 0&&(Ne.numClippingPlanes!==ne.numPlanes||Ne.numIntersection!==ne.numIntersection)||
Ne.vertexAlphas!==$e||Ne.vertexTangents!==ut||Ne.morphTargets!==Oe||Ne.morphNormals!==ht||Ne.morphColors!==Wt||Ne.morphTargetsCount!==ln||Ne.numLightProbeGrids!==
Kt(E.state.lightProbeGridArray)?pt=!0:(Ne.outputColorSpace!==Te||Ne.toneMapping!==At)&&(ki=!0):(pt=!0,Ne.__version=X.version);let tn=Ne.currentProgram;(pt===!0||
ki===!0)&&(tn=ki===!0?zn(X,B,Y,Te,At):Mi(X,B,Y),V&&X.isNodeMaterial&&V.onUpdateProgram(X,tn,Ne));let Js=!1,bi=!1,Vi=!1,ot=tn.getUniforms(),Yt=Ne.uniforms;if(Me.
useProgram(tn.program)&&(Js=!0,bi=!0,Vi=!0),X.id!==$&&($=X.id,bi=!0),Js||Q!==w){Me.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),
ot.setValue(F,"projectionMatrix",w.projectionMatrix),ot.setValue(F,"viewMatrix",w.matrixWorldInverse);let nn=ot.map.cameraPosition;nn!==void 0&&nn.setValue(F,mn.
setFromMatrixPosition(w.matrixWorld)),nt.logarithmicDepthBuffer&&ot.setValue(F,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||
X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&ot.setValue(F,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&
(Q=w,bi=!0,Vi=!0)}if(Ne.needsLights&&(en.state.sunShadowMap.length>0&&ot.setValue(F,"sunShadowMap",en.state.sunShadowMap,We),en.state.directionalShadowMap.length>
0&&ot.setValue(F,"directionalShadowMap",en.state.directionalShadowMap,We),en.state.spotShadowMap.length>0&&ot.setValue(F,"spotShadowMap",en.state.spotShadowMap,
We),en.state.pointShadowMap.length>0&&ot.setValue(F,"pointShadowMap",en.state.pointShadowMap,We)),Y.isSkinnedMesh){ot.setOptional(F,Y,"bindMatrix"),ot.setOptional(
F,Y,"bindMatrixInverse");let Ct=Y.skeleton;Ct&&(Ct.boneTexture===null&&Ct.computeBoneTexture(),ot.setValue(F,"boneTexture",Ct.boneTexture,We))}Y.isBatchedMesh&&
(ot.setOptional(F,Y,"batchingTexture"),ot.setValue(F,"batchingTexture",Y._matricesTexture,We),ot.setOptional(F,Y,"batchingIdTexture"),ot.setValue(F,"batchingIdT\
exture",Y._indirectTexture,We),ot.setOptional(F,Y,"batchingColorTexture"),Y._colorsTexture!==null&&ot.setValue(F,"batchingColorTexture",Y._colorsTexture,We));let Rn=K.
morphAttributes;if((Rn.position!==void 0||Rn.normal!==void 0||Rn.color!==void 0)&&se.update(Y,K,tn),(bi||Ne.receiveShadow!==Y.receiveShadow)&&(Ne.receiveShadow=
Y.receiveShadow,ot.setValue(F,"receiveShadow",Y.receiveShadow)),(X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial)&&X.envMap===null&&B.environment!==
null&&(Yt.envMapIntensity.value=B.environmentIntensity),Yt.dfgLUT!==void 0&&(Yt.dfgLUT.value=AM()),bi){if(ot.setValue(F,"toneMappingExposure",D.toneMappingExposure),
Ne.needsLights&&Ys(Yt,Vi),we&&X.fog===!0&&ge.refreshFogUniforms(Yt,we),ge.refreshMaterialUniforms(Yt,X,Se,Ae,E.state.transmissionRenderTarget[w.id]),Ne.needsLights&&
Ne.numLightProbeGrids>0){let Ct=M,nn=0;for(let bn of E.state.lightProbeGridArray)bn.texture!==null&&(Ct.textures[nn]=bn.texture,Ct.min[nn]=bn.boundingBox.min,Ct.
max[nn]=bn.boundingBox.max,Ct.resolution[nn]=bn.resolution,nn++);for(let bn in Ct)Ct[bn].length=nn;Yt.probesSH.value=Ct.textures,Yt.probesMin.value=Ct.min,Yt.probesMax.
value=Ct.max,Yt.probesResolution.value=Ct.resolution}Vr.upload(F,os(Ne),Yt,We)}if(X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(Vr.upload(F,os(Ne),Yt,We),X.uniformsNeedUpdate=
!1),X.isSpriteMaterial&&ot.setValue(F,"center",Y.center),ot.setValue(F,"modelViewMatrix",Y.modelViewMatrix),ot.setValue(F,"normalMatrix",Y.normalMatrix),ot.setValue(
F,"modelMatrix",Y.matrixWorld),X.uniformsGroups!==void 0){let Ct=X.uniformsGroups;for(let nn=0,bn=Ct.length;nn<bn;nn++){let ta=Ct[nn];Ve.update(ta,tn),Ve.bind(ta,
tn)}}return tn}function Ys(w,B){w.ambientLightColor.needsUpdate=B,w.lightProbe.needsUpdate=B,w.sunLights.needsUpdate=B,w.sunLightShadows.needsUpdate=B,w.directionalLights.
needsUpdate=B,w.directionalLightShadows.needsUpdate=B,w.pointLights.needsUpdate=B,w.pointLightShadows.needsUpdate=B,w.spotLights.needsUpdate=B,w.spotLightShadows.
needsUpdate=B,w.rectAreaLights.needsUpdate=B,w.hemisphereLights.needsUpdate=B}function as(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||
w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return J},this.getActiveMipmapLevel=function(){
return k},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(w,B,K){let X=ze.get(w);X.__autoAllocateDepthBuffer=w.resolveDepthBuffer===
!1,X.__autoAllocateDepthBuffer===!1&&(X.__useRenderToTexture=!1),ze.get(w.texture).__webglTexture=B,ze.get(w.depthTexture).__webglTexture=X.__autoAllocateDepthBuffer?
void 0:K,X.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,B){let K=ze.get(w);K.__webglFramebuffer=B,K.__useDefaultFramebuffer=B===void 0},
this.setRenderTarget=function(w,B=0,K=0){le=w,J=B,k=K;let X=null,Y=!1,we=!1;if(w){let Te=ze.get(w);if(Te.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(F.
FRAMEBUFFER,Te.__webglFramebuffer),ie.copy(w.viewport),he.copy(w.scissor),ue=w.scissorTest,Me.viewport(ie),Me.scissor(he),Me.setScissorTest(ue),$=-1;return}else if(Te.
__webglFramebuffer===void 0)We.setupRenderTarget(w);else if(Te.__hasExternalTextures)We.rebindTextures(w,ze.get(w.texture).__webglTexture,ze.get(w.depthTexture).
__webglTexture);else if(w.depthBuffer){let $e=w.depthTexture;if(Te.__boundDepthTexture!==$e){if($e!==null&&ze.has($e)&&(w.width!==$e.image.width||w.height!==$e.
image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");We.setupDepthRenderbuffer(w)}}let Pe=w.texture;
(Pe.isData3DTexture||Pe.isDataArrayTexture||Pe.isCompressedArrayTexture)&&(we=!0);let Be=ze.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Be[B])?
X=Be[B][K]:X=Be[B],Y=!0):w.samples>0&&We.useMultisampledRTT(w)===!1?X=ze.get(w).__webglMultisampledFramebuffer:Array.isArray(Be)?X=Be[K]:X=Be,ie.copy(w.viewport),
he.copy(w.scissor),ue=w.scissorTest}else ie.copy(ke).multiplyScalar(Se).floor(),he.copy(ct).multiplyScalar(Se).floor(),ue=rt;if(K!==0&&(X=H),Me.bindFramebuffer(
F.FRAMEBUFFER,X)&&Me.drawBuffers(w,X),Me.viewport(ie),Me.scissor(he),Me.setScissorTest(ue),Y){let Te=ze.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,
F.TEXTURE_CUBE_MAP_POSITIVE_X+B,Te.__webglTexture,K)}else if(we){let Te=B;for(let Pe=0;Pe<w.textures.length;Pe++){let Be=ze.get(w.textures[Pe]);F.framebufferTextureLayer(
F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Pe,Be.__webglTexture,K,Te)}}else if(w!==null&&K!==0){let Te=ze.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,
F.TEXTURE_2D,Te.__webglTexture,K)}$=-1};function Zs(w){let B=ze.get(w);return(B.__readFormat!==w.format||B.__readType!==w.type)&&(B.__readFormat=w.format,B.__readType=
w.type,B.__formatReadable=nt.textureFormatReadable(w.format),B.__typeReadable=nt.textureTypeReadable(w.type)),B}this.readRenderTargetPixels=function(w,B,K,X,Y,we,Re,Te=0){
if(!(w&&w.isWebGLRenderTarget)){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Pe=ze.get(w).__webglFramebuffer;
if(w.isWebGLCubeRenderTarget&&Re!==void 0&&(Pe=Pe[Re],Array.isArray(Pe)&&(Pe=Pe[0])),Pe){Me.bindFramebuffer(F.FRAMEBUFFER,Pe);try{let Be=w.textures[Te],$e=Be.format,
ut=Be.type;w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Te);let Oe=Zs(Be);if(Oe.__formatReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: render\
Target is not in RGBA or implementation defined format.");return}if(Oe.__typeReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in Uns\
ignedByteType or implementation defined type.");return}B>=0&&B<=w.width-X&&K>=0&&K<=w.height-Y&&F.readPixels(B,K,X,Y,me.convert($e),me.convert(ut),we)}finally{let Be=le!==
null?ze.get(le).__webglFramebuffer:null;Me.bindFramebuffer(F.FRAMEBUFFER,Be)}}},this.readRenderTargetPixelsAsync=async function(w,B,K,X,Y,we,Re,Te=0){if(!(w&&w.
isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Pe=ze.get(w).__webglFramebuffer;
if(w.isWebGLCubeRenderTarget&&Re!==void 0&&(Pe=Pe[Re],Array.isArray(Pe)&&(Pe=Pe[0])),Pe)if(B>=0&&B<=w.width-X&&K>=0&&K<=w.height-Y){Me.bindFramebuffer(F.FRAMEBUFFER,
Pe);let Be=w.textures[Te],$e=Be.format,ut=Be.type;w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Te);let Oe=Zs(Be);if(Oe.__formatReadable===!1)throw new Error(
"THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Oe.__typeReadable===!1)throw new Error("THR\
EE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ht=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,
ht),F.bufferData(F.PIXEL_PACK_BUFFER,we.byteLength,F.STREAM_READ),F.readPixels(B,K,X,Y,me.convert($e),me.convert(ut),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Wt=le!==
null?ze.get(le).__webglFramebuffer:null;Me.bindFramebuffer(F.FRAMEBUFFER,Wt);let At=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await qp(F,At,4),
F.bindBuffer(F.PIXEL_PACK_BUFFER,ht),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,we),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(ht),F.deleteSync(At),we}else
throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,B=null,K=0){
let X=Math.pow(2,-K),Y=Math.floor(w.image.width*X),we=Math.floor(w.image.height*X),Re=B!==null?B.x:0,Te=B!==null?B.y:0;We.setTexture2D(w,0),F.copyTexSubImage2D(
F.TEXTURE_2D,K,0,0,Re,Te,Y,we),Me.unbindTexture()},this.copyTextureToTexture=function(w,B,K=null,X=null,Y=0,we=0){let Re,Te,Pe,Be,$e,ut,Oe,ht,Wt,At=w.isCompressedTexture?
w.mipmaps[we]:w.image;if(K!==null)Re=K.max.x-K.min.x,Te=K.max.y-K.min.y,Pe=K.isBox3?K.max.z-K.min.z:1,Be=K.min.x,$e=K.min.y,ut=K.isBox3?K.min.z:0;else{let ot=Math.
pow(2,-Y);Re=Math.floor(At.width*ot),Te=Math.floor(At.height*ot),w.isDataArrayTexture?Pe=At.depth:w.isData3DTexture?Pe=Math.floor(At.depth*ot):Pe=1,Be=0,$e=0,ut=
0}X!==null?(Oe=X.x,ht=X.y,Wt=X.z):(Oe=0,ht=0,Wt=0);let Et=me.convert(B.format),ln=me.convert(B.type),Ne;B.isData3DTexture?(We.setTexture3D(B,0),Ne=F.TEXTURE_3D):
B.isDataArrayTexture||B.isCompressedArrayTexture?(We.setTexture2DArray(B,0),Ne=F.TEXTURE_2D_ARRAY):(We.setTexture2D(B,0),Ne=F.TEXTURE_2D),Me.activeTexture(F.TEXTURE0),
Me.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,B.flipY),Me.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),Me.pixelStorei(F.UNPACK_ALIGNMENT,B.unpackAlignment);
let en=Me.getParameter(F.UNPACK_ROW_LENGTH),pt=Me.getParameter(F.UNPACK_IMAGE_HEIGHT),ki=Me.getParameter(F.UNPACK_SKIP_PIXELS),tn=Me.getParameter(F.UNPACK_SKIP_ROWS),
Js=Me.getParameter(F.UNPACK_SKIP_IMAGES);Me.pixelStorei(F.UNPACK_ROW_LENGTH,At.width),Me.pixelStorei(F.UNPACK_IMAGE_HEIGHT,At.height),Me.pixelStorei(F.UNPACK_SKIP_PIXELS,
Be),Me.pixelStorei(F.UNPACK_SKIP_ROWS,$e),Me.pixelStorei(F.UNPACK_SKIP_IMAGES,ut);let bi=w.isDataArrayTexture||w.isData3DTexture,Vi=B.isDataArrayTexture||B.isData3DTexture;
if(w.isDepthTexture){let ot=ze.get(w),Yt=ze.get(B),Rn=ze.get(ot.__renderTarget),Ct=ze.get(Yt.__renderTarget);Me.bindFramebuffer(F.READ_FRAMEBUFFER,Rn.__webglFramebuffer),
Me.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ct.__webglFramebuffer);for(let nn=0;nn<Pe;nn++)bi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ze.get(
w).__webglTexture,Y,ut+nn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ze.get(B).__webglTexture,we,Wt+nn)),F.blitFramebuffer(Be,$e,Be+Re,$e+
Te,Oe,ht,Oe+Re,ht+Te,F.DEPTH_BUFFER_BIT,F.NEAREST);Me.bindFramebuffer(F.READ_FRAMEBUFFER,null),Me.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Y!==0||w.isRenderTargetTexture||
ze.has(w)){let ot=ze.get(w),Yt=ze.get(B);Me.bindFramebuffer(F.READ_FRAMEBUFFER,N),Me.bindFramebuffer(F.DRAW_FRAMEBUFFER,G);for(let Rn=0;Rn<Pe;Rn++)bi?F.framebufferTextureLayer(
F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ot.__webglTexture,Y,ut+Rn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ot.__webglTexture,Y),
Vi?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Yt.__webglTexture,we,Wt+Rn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.
TEXTURE_2D,Yt.__webglTexture,we),Y!==0?F.blitFramebuffer(Be,$e,Be+Re,$e+Te,Oe,ht,Oe+Re,ht+Te,F.COLOR_BUFFER_BIT,F.NEAREST):Vi?F.copyTexSubImage3D(Ne,we,Oe,ht,Wt+
Rn,Be,$e,Re,Te):F.copyTexSubImage2D(Ne,we,Oe,ht,Be,$e,Re,Te);Me.bindFramebuffer(F.READ_FRAMEBUFFER,null),Me.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Vi?w.isDataTexture||
w.isData3DTexture?F.texSubImage3D(Ne,we,Oe,ht,Wt,Re,Te,Pe,Et,ln,At.data):B.isCompressedArrayTexture?F.compressedTexSubImage3D(Ne,we,Oe,ht,Wt,Re,Te,Pe,Et,At.data):
F.texSubImage3D(Ne,we,Oe,ht,Wt,Re,Te,Pe,Et,ln,At):w.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,we,Oe,ht,Re,Te,Et,ln,At.data):w.isCompressedTexture?F.compressedTexSubImage2D(
F.TEXTURE_2D,we,Oe,ht,At.width,At.height,Et,At.data):F.texSubImage2D(F.TEXTURE_2D,we,Oe,ht,Re,Te,Et,ln,At);Me.pixelStorei(F.UNPACK_ROW_LENGTH,en),Me.pixelStorei(
F.UNPACK_IMAGE_HEIGHT,pt),Me.pixelStorei(F.UNPACK_SKIP_PIXELS,ki),Me.pixelStorei(F.UNPACK_SKIP_ROWS,tn),Me.pixelStorei(F.UNPACK_SKIP_IMAGES,Js),we===0&&B.generateMipmaps===
!0&&B.mipmapsAutoUpdate===!0&&F.generateMipmap(Ne),Me.unbindTexture()},this.initRenderTarget=function(w){ze.get(w).__webglFramebuffer===void 0&&We.setupRenderTarget(
w)},this.initTexture=function(w){w.isCubeTexture?We.setTextureCube(w,0):w.isData3DTexture?We.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?
We.setTexture2DArray(w,0):We.setTexture2D(w,0),Me.unbindTexture()},this.resetState=function(){J=0,k=0,le=null,Me.reset(),ye.reset()},typeof __THREE_DEVTOOLS__<"\
u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return si}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){
this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=gt._getDrawingBufferColorSpace(e),t.unpackColorSpace=gt._getUnpackColorSpace()}};var vc=2,EM=.05,CM=40,Im=40,Eh=(i,e)=>{let t=i===null?[null]:i.slice(3*e,3*e+3);return t.includes(null)?null:t},Hr=(i,e)=>{let t=Eh(i,e);return t&&new q(...t).divideScalar(
1e3)};function Ch(i){let{actual_mm:e,expected_mm:t}=i.frames;return e.map((n,s)=>i.bodies.id.map((r,o)=>{let a=Hr(n,o),c=Hr(t[s],o);return a&&c?1e3*a.distanceTo(
c):null}))}function RM(i,e){let t=Math.max(0,...e.flat());return i.bodies.id.map((n,s)=>{let r=1e3*Math.min(...i.bodies.size.slice(3*s,3*s+3));return Math.max(vc,
EM*Math.min(t,r>0?r:t))})}function PM(i){let e=new q,t=new q,n=[...i.frames.actual_mm,...i.frames.expected_mm].filter(r=>r!==null);["x","y","z"].forEach((r,o)=>{
let a=n.flatMap(c=>c.filter((l,u)=>u%3===o&&l!==null)).sort((c,l)=>c-l);a.length!==0&&(e[r]=a[Math.floor(.05*(a.length-1))]/1e3,t[r]=a[Math.ceil(.95*(a.length-1))]/
1e3)});let s=Math.max(...i.bodies.size,.1);return{centre:e.clone().add(t).divideScalar(2),radius:e.distanceTo(t)/2+Math.min(s,4)}}function Ah(i,e){let t=new Kn().
setFromPoints(i),n=new Ur(t,e);return n.frustumCulled=!1,e.isLineDashedMaterial&&n.computeLineDistances(),n}function Lm(i,e,t){let n=i.bodies.id.map((o,a)=>Math.
max(...t.map(c=>c[a]??0))),s=n.map((o,a)=>a).sort((o,a)=>n[a]-n[o]).slice(0,CM),r=[];for(let o of s)for(let a=1;a<e.length;++a){let c=Hr(e[a-1],o),l=Hr(e[a],o);
c&&l&&r.push(c,l)}return r}function IM(i,e,t){let n=e.bodies.id.length,s=new Nr(new Ss,new Lo,n);for(let o=0;o<n;++o)s.setColorAt(o,new st(t.actual).offsetHSL(0,
0,.035*(o%5-2)));let r=new Nr(new Po(.5),new Dr({color:t.expected,wireframe:!0,depthTest:!1}),n);for(let o of[s,r])o.frustumCulled=!1;return r.renderOrder=2,i.add(
s,r),{boxes:s,marks:r}}function Dm(i,e,t){let n=new gc({canvas:i,antialias:!0,alpha:!0});n.setPixelRatio(Math.min(devicePixelRatio,2));let{centre:s,radius:r}=PM(
e),o=new So,a=new Nn(Im,1,r/100,r*100);a.up.set(0,0,1);let c=new Bo("#ffffff",2.4);c.position.set(.4,-.7,1);let l=new ko(4*r,20,t.line,t.line);l.rotation.x=Math.
PI/2,l.position.set(s.x,s.y,0),o.add(new zo("#ffffff",.9),c,l);let u=Ch(e),f=RM(e,u),{boxes:h,marks:d}=IM(o,e,t),x=r/40;o.add(Ah(Lm(e,e.frames.actual_mm,u),new ts(
{color:t.actual})),Ah(Lm(e,e.frames.expected_mm,u),new Do({color:t.expected,dashSize:x,gapSize:.7*x})));let S=Ah(e.bodies.id.flatMap(()=>[new q,new q]),new ts({
color:t.bad,depthTest:!1}));S.renderOrder=1,o.add(S);let p={around:-.9,up:.45,distance:r/Math.sin(Im/2*Math.PI/180)},m=()=>{let v=Math.cos(p.up)*p.distance;a.position.
set(s.x+v*Math.cos(p.around),s.y+v*Math.sin(p.around),s.z+p.distance*Math.sin(p.up)),a.lookAt(s),n.render(o,a)};return{view:p,draw:m,show(v){LM(e,{apart:u[v],limits:f},
v,{boxes:h,marks:d,links:S}),m()},turn(v,A){p.around+=v,p.up=Math.min(1.55,Math.max(-.3,p.up+A)),m()},zoom(v){p.distance=Math.min(20*r,Math.max(r/10,p.distance*
v)),m()},resize(v,A){n.setSize(v,A,!1),a.aspect=v/A,a.updateProjectionMatrix(),m()},dispose(){o.traverse(v=>{v.geometry?.dispose(),v.material?.dispose()}),n.dispose(),
n.forceContextLoss()}}}function LM(i,{apart:e,limits:t},n,{boxes:s,marks:r,links:o}){let{actual_mm:a,actual_turn:c,expected_mm:l}=i.frames,u=o.geometry.getAttribute(
"position"),f=new bt,h=new bt().makeScale(0,0,0),d=new Jn;i.bodies.id.forEach((x,S)=>{let p=new q().fromArray(i.bodies.size,3*S);p.x===0&&p.setScalar(.1);let m=Hr(
a[n],S),v=Hr(l[n],S),[A,M,P,E]=c[n].slice(4*S,4*S+4);s.setMatrixAt(S,m?f.compose(m,new Jn(M,P,E,A),p):h);let _=v&&!(e[S]!==null&&e[S]<=t[S]),T=Math.min(p.x,p.y,
p.z);r.setMatrixAt(S,_?f.compose(v,d,p.setScalar(T)):h);let O=_&&m;u.setXYZ(2*S,...O?m:new q),u.setXYZ(2*S+1,...O?v:new q)});for(let x of[s,r])x.instanceMatrix.
needsUpdate=!0;u.needsUpdate=!0}var DM=150,yc=.12,Nm=.008,Rh=(i,e)=>{let t=at("span",{className:"key"});return t.innerHTML='<svg viewBox="0 0 36 16" aria-hidden="true" fill="none" stroke-width\
="2">'.concat(i,"</svg>"),t.append(e),t};function NM(){return at("p",{},Rh('<path d="M0 8H36" stroke="var(--actual)"/><rect x="12" y="2" width="12" height="12" \
fill="var(--actual)"/>',"this run"),Rh('<path d="M0 8H36" stroke="var(--expected)" stroke-dasharray="5 4"/>\n      <path d="M18 1l7 7-7 7-7-7z" stroke="var(--exp\
ected)"/>',"expected, if to be seen elsewhere"),Rh('<path d="M0 8H36" stroke="var(--bad)"/>',"from one to the other"))}function UM(i,e,t){let n=e[t].map((l,u)=>({
value:l,id:i.bodies.id[u]})).filter(({value:l})=>l!==null),s="step ".concat(i.frames.step[t]),r=i.bodies.id.filter((l,u)=>!Eh(i.frames.actual_mm[t],u)),o=r.length===
0?"":"; body ".concat(r[0]).concat(r.length>1?" and ".concat(r.length-1," more"):""," without a place (gone, or not finite)");if(n.length===0)return"".concat(s,
": nothing to compare here").concat(o);let a=n.reduce((l,u)=>u.value>l.value?u:l),c=n.filter(({value:l})=>l>vc).length;return c===0?"".concat(s,": every body wi\
thin ").concat(vc," mm of where it was expected").concat(o):"".concat(s,": ").concat(c," of ").concat(n.length," bodies elsewhere, the furthest is body ").concat(
a.id,", ")+"".concat(ro(a.value/1e3)," away").concat(o)}function FM(i,e){i.addEventListener("pointerdown",n=>{i.setPointerCapture(n.pointerId),i.focus({preventScroll:!0})}),
i.addEventListener("pointermove",n=>{n.buttons!==0&&e.turn(-Nm*n.movementX,Nm*n.movementY)}),i.addEventListener("wheel",n=>{document.activeElement===i&&(n.preventDefault(),
e.zoom(Math.exp(n.deltaY/800)))},{passive:!1});let t={ArrowLeft:()=>e.turn(-yc,0),ArrowRight:()=>e.turn(yc,0),ArrowUp:()=>e.turn(0,yc),ArrowDown:()=>e.turn(0,-yc),
"+":()=>e.zoom(.85),"=":()=>e.zoom(.85),"-":()=>e.zoom(1/.85)};i.addEventListener("keydown",n=>{n.key in t&&(n.preventDefault(),t[n.key]())})}var Ph=class{constructor(e,t){
this.place=e,this.data=t,this.frame=0,this.scene=null,this.last_view=null,new IntersectionObserver(n=>{n.at(-1).isIntersecting?this.open():this.close()},{rootMargin:"\
100px"}).observe(e)}open(){if(this.scene)return;let e=at("canvas",{tabIndex:0});e.setAttribute("role","img"),e.setAttribute("aria-label","The bodies in three di\
mensions. Arrow keys turn the view, + and - zoom."),this.place.replaceChildren(e);try{this.scene=Dm(e,this.data,va())}catch{this.place.textContent="This browser\
 has no WebGL, so there is no view; the words below say the same.";return}this.last_view&&Object.assign(this.scene.view,this.last_view),FM(e,this.scene),this.resize(),
this.scene.show(this.frame)}close(){this.scene&&(this.last_view={...this.scene.view},this.scene.dispose(),this.scene=null,this.place.replaceChildren())}show(e){
this.frame=e,this.scene?.show(e)}resize(){let{clientWidth:e,clientHeight:t}=this.place;e>0&&this.scene?.resize(e,t)}};function OM(i,e,t){let n=at("button",{type:"\
button",textContent:"Play",className:"play"}),s=null,r=()=>{clearInterval(s),s=null,n.textContent="Play"};return n.addEventListener("click",()=>{if(s!==null)return r();
let o=Number(i.value)>=e?0:Number(i.value);n.textContent="Pause",s=setInterval(()=>{t(o),o++>=e&&r()},DM)}),{button:n,stop:r}}function Um(i,e,t){let n=e.frames.
step.length-1;if(n<0||e.bodies.id.length===0)return null;let s=Ch(e),r=at("div",{className:"view3d"}),o=at("input",{type:"range",min:0,max:n,value:0,className:"\
scrubber"});o.setAttribute("aria-label","step shown");let a=at("output"),c=new Ph(r,e),l=d=>{let x=UM(e,s,d);o.value=d,o.setAttribute("aria-valuetext",x),a.value=
x,c.show(d),t(e.frames.step[d])},{button:u,stop:f}=OM(o,n,l);o.addEventListener("input",()=>{f(),l(Number(o.value))}),i.append(at("h3",{textContent:"Where the b\
odies went"}),NM(),r,at("div",{className:"controls"},u,o,a),at("p",{className:"soft",textContent:"Drag or use the arrow keys to turn, + and - to zoom. Lines: th\
e ways of the bodies that went furthest astray."}));let h=s.map(d=>Math.max(...d.map(x=>x??0)));return l(h.indexOf(Math.max(...h))),{resize:()=>c.resize(),redraw(){
c.close(),c.open()}}}function BM(i){let e=JSON.parse(i.querySelector("script").textContent);i.replaceChildren();let t=i.dataset.first===void 0?null:Number(i.dataset.first),n=(i.dataset.
groups??"").split(" "),s=Rd(i,e,{first:t,groups:n}),r=Um(i,e,s.show_step);Ad(()=>{s.redraw(),r?.redraw()}),new ResizeObserver(()=>{s.resize(),r?.resize()}).observe(
i)}function zM(i,e){let t=new IntersectionObserver(n=>{n.some(s=>s.isIntersecting)&&(t.disconnect(),e(i))},{rootMargin:"200px"});t.observe(i)}function Ih(i){return e=>{
try{i(e)}catch(t){let n=document.createElement("p");throw n.textContent="This cannot be drawn: ".concat(t.message),e.append(n),t}}}var Fm=document.createElement(
"style");Fm.textContent=Kh+Qh;document.head.append(Fm);for(let i of document.querySelectorAll("table.glance"))Ih(Ud)(i);for(let i of document.querySelectorAll("\
.drawing"))zM(i,Ih(BM));for(let i of document.querySelectorAll(".pictures"))Ih(Pd)(i);})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
