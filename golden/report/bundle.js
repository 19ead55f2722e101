(()=>{var Zi='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helveti\
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
.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var Qi=':root { --actual: #1d5fbf; --actual-more: #0f7f83; --expected: #b35309; }\n@media (prefers-color-scheme: dark) { :root { --actual: #7db4ff; --actual-more\
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
 1 100%; font-variant-numeric: tabular-nums; }\n.key { display: inline-flex; align-items: center; gap: .35rem; margin-right: 1rem; white-space: nowrap; }\n.key sv\
g { width: 2.2rem; height: 1rem; }\n.viewer { flex: 0 0 100%; min-width: 0; }\n.viewer .stack, .viewer .controls { max-width: 46rem; }\n.viewer .stack { position: \
relative; border: 1px solid var(--line); }\n.viewer .stack img { display: block; width: 100%; max-width: none; image-rendering: pixelated; }\n.viewer .stack .over\
 { position: absolute; inset: 0; }\n.viewer .stack .edge { position: absolute; top: 0; bottom: 0; width: 2px; margin-left: -1px; background: #fff;\n  box-shadow: \
0 0 0 1px #000; }\n.viewer .tag { position: absolute; top: .4rem; left: .4rem; padding: 0 .5rem; border-radius: .3rem; background: #000b;\n  color: #fff; font-siz\
e: .82rem; }\n.viewer .tag.right { left: auto; right: .4rem; }\n.viewer .stack [hidden] { display: none; }\n';var hr="uplot",mr="u-hz",gr="u-vt",wr="u-title",br="u-wrap",xr="u-under",vr="u-over",Sr="u-axis",Qt="u-off",_r="u-select",yr="u-cursor-x",kr="u-cursor-y",Tr="u-\
cursor-pt",Mr="u-legend",Er="u-live",Ar="u-inline",Pr="u-series",Dr="u-marker",Xi="u-label",Lr="u-value",Wl="width",Gl="height";var eo="bottom",Sl="left",Gn="right",ii="#000",to=ii+"0",In="mousemove",lo="mousedown",Bn="mouseup",no="mouseenter",io="mouseleave",oo="dblclick",Cr="resize",zr="\
scroll",so="change",rn="dppxchange",oi="--",Al=typeof window<"u",Kn=Al?document:null,yl=Al?window:null,Nr=Al?navigator:null,oe,ln;function qn(){let e=devicePixelRatio;
oe!=e&&(oe=e,ln&&Zn(so,ln,qn),ln=matchMedia("(min-resolution: ".concat(oe-.001,"dppx) and (max-resolution: ").concat(oe+.001,"dppx)")),Xt(so,ln,qn),yl.dispatchEvent(
new CustomEvent(rn)))}function et(e,l){if(l!=null){let o=e.classList;!o.contains(l)&&o.add(l)}}function Jn(e,l){let o=e.classList;o.contains(l)&&o.remove(l)}function ge(e,l,o){
e.style[l]=o+"px"}function gt(e,l,o,n){let s=Kn.createElement(e);return l!=null&&et(s,l),o?.insertBefore(s,n),s}function ct(e,l){return gt("div",e,l)}var ro=new WeakMap;
function Mt(e,l,o,n,s){let a="translate("+l+"px,"+o+"px)",c=ro.get(e);a!=c&&(e.style.transform=a,ro.set(e,a),l<0||o<0||l>n||o>s?et(e,Qt):Jn(e,Qt))}var uo=new WeakMap;
function co(e,l,o){let n=l+o,s=uo.get(e);n!=s&&(uo.set(e,n),e.style.background=l,e.style.borderColor=o)}var ao=new WeakMap;function fo(e,l,o,n){let s=l+""+o,a=ao.
get(e);s!=a&&(ao.set(e,s),e.style.height=o+"px",e.style.width=l+"px",e.style.marginLeft=n?-l/2+"px":0,e.style.marginTop=n?-o/2+"px":0)}var si={passive:!0},Rr={...si,
capture:!0};function Xt(e,l,o,n){l.addEventListener(e,o,n?Rr:si)}function Zn(e,l,o,n){l.removeEventListener(e,o,si)}Al&&qn();function wt(e,l,o,n){let s;o=o||0,n=
n||l.length-1;let a=n<=2147483647;for(;n-o>1;)s=a?o+n>>1:tt((o+n)/2),l[s]<e?o=s:n=s;return e-l[o]<=l[n]-e?o:n}function Wo(e){return(o,n,s)=>{let a=-1,c=-1;for(let p=n;p<=
s;p++)if(e(o[p])){a=p;break}for(let p=s;p>=n;p--)if(e(o[p])){c=p;break}return[a,c]}}var Go=e=>e!=null,Io=e=>e!=null&&e>0,an=Wo(Go),Vr=Wo(Io);function Fr(e,l,o,n=0,s=!1){
let a=s?Vr:an,c=s?Io:Go;[l,o]=a(e,l,o);let p=e[l],d=e[l];if(l>-1)if(n==1)p=e[l],d=e[o];else if(n==-1)p=e[o],d=e[l];else for(let h=l;h<=o;h++){let x=e[h];c(x)&&(x<
p?p=x:x>d&&(d=x))}return[p??ae,d??-ae]}function fn(e,l,o,n){let s=mo(e),a=mo(l);e==l&&(s==-1?(e*=o,l/=o):(e/=o,l*=o));let c=o==10?Dt:Bo,p=s==1?tt:at,d=a==1?at:tt,
h=p(c(Ae(e))),x=d(c(Ae(l))),g=kl(o,h),w=kl(o,x);return o==10&&(h<0&&(g=fe(g,-h)),x<0&&(w=fe(w,-x))),n||o==2?(e=g*s,l=w*a):(e=jo(e,g),l=pn(l,w)),[e,l]}function ri(e,l,o,n){
let s=fn(e,l,o,n);return e==0&&(s[0]=0),l==0&&(s[1]=0),s}var ui=.1,po={mode:3,pad:ui},Bl={pad:0,soft:null,mode:0},Or={min:Bl,max:Bl};function un(e,l,o,n){return dn(
o)?ho(e,l,o):(Bl.pad=o,Bl.soft=n?0:null,Bl.mode=n?3:0,ho(e,l,Or))}function ne(e,l){return e??l}function Hr(e,l,o){for(l=ne(l,0),o=ne(o,e.length-1);l<=o;){if(e[l]!=
null)return!0;l++}return!1}function ho(e,l,o){let n=o.min,s=o.max,a=ne(n.pad,0),c=ne(s.pad,0),p=ne(n.hard,-ae),d=ne(s.hard,ae),h=ne(n.soft,ae),x=ne(s.soft,-ae),
g=ne(n.mode,0),w=ne(s.mode,0),D=l-e,M=Dt(D),z=Ue(Ae(e),Ae(l)),O=Dt(z),W=Ae(O-M);(D<1e-24||W>10)&&(D=0,(e==0||l==0)&&(D=1e-24,g==2&&h!=ae&&(a=0),w==2&&x!=-ae&&(c=
0)));let _=D||z||1e3,A=Dt(_),y=kl(10,tt(A)),K=_*(D==0?e==0?.1:1:a),C=fe(jo(e-K,y/10),24),q=e>=h&&(g==1||g==3&&C<=h||g==2&&C>=h)?h:ae,U=Ue(p,C<q&&e>=q?q:bt(q,C)),
Q=_*(D==0?l==0?.1:1:c),Y=fe(pn(l+Q,y/10),24),k=l<=x&&(w==1||w==3&&Y>=x||w==2&&Y<=x)?x:-ae,j=bt(d,Y>k&&l<=k?k:Ue(k,Y));return U==j&&U==0&&(j=100),[U,j]}var Wr=new Intl.
NumberFormat(Al?Nr.language:"en-US"),ci=e=>Wr.format(e),lt=Math,sn=lt.PI,Ae=lt.abs,tt=lt.floor,Ee=lt.round,at=lt.ceil,bt=lt.min,Ue=lt.max,kl=lt.pow,mo=lt.sign,Dt=lt.
log10,Bo=lt.log2,Gr=(e,l=1)=>lt.sinh(e)*l,Yn=(e,l=1)=>lt.asinh(e/l),ae=1/0;function go(e){return(Dt((e^e>>31)-(e>>31))|0)+1}function Qn(e,l,o){return bt(Ue(e,l),
o)}function Yo(e){return typeof e=="function"}function X(e){return Yo(e)?e:()=>e}var Ir=()=>{},Uo=e=>e,$o=(e,l)=>l,Br=e=>null,wo=e=>!0,bo=(e,l)=>e==l,Yr=/\.\d*?(?=9{6,}|0{6,})/gm,
el=e=>{if(qo(e)||Ht.has(e))return e;let l="".concat(e),o=l.match(Yr);if(o==null)return e;let n=o[0].length-1;if(l.indexOf("e-")!=-1){let[s,a]=l.split("e");return+"".
concat(el(s),"e").concat(a)}return fe(e,n)};function Jt(e,l){return el(fe(el(e/l))*l)}function pn(e,l){return el(at(el(e/l))*l)}function jo(e,l){return el(tt(el(
e/l))*l)}function fe(e,l=0){if(qo(e))return e;let o=10**l,n=e*o*(1+Number.EPSILON);return Ee(n)/o}var Ht=new Map;function Ko(e){return((""+e).split(".")[1]||"").
length}function Ul(e,l,o,n){let s=[],a=n.map(Ko);for(let c=l;c<o;c++){let p=Ae(c),d=fe(kl(e,c),p);for(let h=0;h<n.length;h++){let x=e==10?+"".concat(n[h],"e").concat(
c):n[h]*d,g=(c>=0?0:p)+(c>=a[h]?0:a[h]),w=e==10?x:fe(x,g);s.push(w),Ht.set(w,g)}}return s}var Yl={},ai=[],Tl=[null,null],Ot=Array.isArray,qo=Number.isInteger,Ur=e=>e===
void 0;function xo(e){return typeof e=="string"}function dn(e){let l=!1;if(e!=null){let o=e.constructor;l=o==null||o==Object}return l}function $r(e){return e!=null&&
typeof e=="object"}var jr=Object.getPrototypeOf(Uint8Array),Jo="__proto__";function Ml(e,l=dn){let o;if(Ot(e)){let n=e.find(s=>s!=null);if(Ot(n)||l(n)){o=Array(
e.length);for(let s=0;s<e.length;s++)o[s]=Ml(e[s],l)}else o=e.slice()}else if(e instanceof jr)o=e.slice();else if(l(e)){o={};for(let n in e)n!=Jo&&(o[n]=Ml(e[n],
l))}else o=e;return o}function ke(e){let l=arguments;for(let o=1;o<l.length;o++){let n=l[o];for(let s in n)s!=Jo&&(dn(e[s])?ke(e[s],Ml(n[s])):e[s]=Ml(n[s]))}return e}
var Kr=0,qr=1,Jr=2;function Zr(e,l,o){for(let n=0,s,a=-1;n<l.length;n++){let c=l[n];if(c>a){for(s=c-1;s>=0&&e[s]==null;)e[s--]=null;for(s=c+1;s<o&&e[s]==null;)e[a=
s++]=null}}}function Qr(e,l){if(tu(e)){let c=e[0].slice();for(let p=1;p<e.length;p++)c.push(...e[p].slice(1));return lu(c[0])||(c=eu(c)),c}let o=new Set;for(let c=0;c<
e.length;c++){let d=e[c][0],h=d.length;for(let x=0;x<h;x++)o.add(d[x])}let n=[Array.from(o).sort((c,p)=>c-p)],s=n[0].length,a=new Map;for(let c=0;c<s;c++)a.set(
n[0][c],c);for(let c=0;c<e.length;c++){let p=e[c],d=p[0];for(let h=1;h<p.length;h++){let x=p[h],g=Array(s).fill(void 0),w=l?l[c][h]:qr,D=[];for(let M=0;M<x.length;M++){
let z=x[M],O=a.get(d[M]);z===null?w!=Kr&&(g[O]=z,w==Jr&&D.push(O)):g[O]=z}Zr(g,D,s),n.push(g)}}return n}var Xr=typeof queueMicrotask>"u"?e=>Promise.resolve().then(
e):queueMicrotask;function eu(e){let l=e[0],o=l.length,n=Array(o);for(let a=0;a<n.length;a++)n[a]=a;n.sort((a,c)=>l[a]-l[c]);let s=[];for(let a=0;a<e.length;a++){
let c=e[a],p=Array(o);for(let d=0;d<o;d++)p[d]=c[n[d]];s.push(p)}return s}function tu(e){let l=e[0][0],o=l.length;for(let n=1;n<e.length;n++){let s=e[n][0];if(s.
length!=o)return!1;if(s!=l){for(let a=0;a<o;a++)if(s[a]!=l[a])return!1}}return!0}function lu(e,l=100){let o=e.length;if(o<=1)return!0;let n=0,s=o-1;for(;n<=s&&e[n]==
null;)n++;for(;s>=n&&e[s]==null;)s--;if(s<=n)return!0;let a=Ue(1,tt((s-n+1)/l));for(let c=e[n],p=n+a;p<=s;p+=a){let d=e[p];if(d!=null){if(d<=c)return!1;c=d}}return!0}
var Zo=["January","February","March","April","May","June","July","August","September","October","November","December"],Qo=["Sunday","Monday","Tuesday","Wednesda\
y","Thursday","Friday","Saturday"];function Xo(e){return e.slice(0,3)}var nu=Qo.map(Xo),iu=Zo.map(Xo),ou={MMMM:Zo,MMM:iu,WWWW:Qo,WWW:nu};function Hl(e){return(e<
10?"0":"")+e}function su(e){return(e<10?"00":e<100?"0":"")+e}var ru={YYYY:e=>e.getFullYear(),YY:e=>(e.getFullYear()+"").slice(2),MMMM:(e,l)=>l.MMMM[e.getMonth()],
MMM:(e,l)=>l.MMM[e.getMonth()],MM:e=>Hl(e.getMonth()+1),M:e=>e.getMonth()+1,DD:e=>Hl(e.getDate()),D:e=>e.getDate(),WWWW:(e,l)=>l.WWWW[e.getDay()],WWW:(e,l)=>l.WWW[e.
getDay()],HH:e=>Hl(e.getHours()),H:e=>e.getHours(),h:e=>{let l=e.getHours();return l==0?12:l>12?l-12:l},AA:e=>e.getHours()>=12?"PM":"AM",aa:e=>e.getHours()>=12?
"pm":"am",a:e=>e.getHours()>=12?"p":"a",mm:e=>Hl(e.getMinutes()),m:e=>e.getMinutes(),ss:e=>Hl(e.getSeconds()),s:e=>e.getSeconds(),fff:e=>su(e.getMilliseconds())};
function fi(e,l){l=l||ou;let o=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(e);)o.push(s[0][0]=="{"?ru[s[1]]:s[0]);return a=>{let c="";for(let p=0;p<o.length;p++)
c+=typeof o[p]=="string"?o[p]:o[p](a,l);return c}}var uu=new Intl.DateTimeFormat().resolvedOptions().timeZone;function cu(e,l){let o;return l=="UTC"||l=="Etc/UT\
C"?o=new Date(+e+e.getTimezoneOffset()*6e4):l==uu?o=e:(o=new Date(e.toLocaleString("en-US",{timeZone:l})),o.setMilliseconds(e.getMilliseconds())),o}var es=e=>e%
1==0,cn=[1,2,2.5,5],au=Ul(10,-32,0,cn),ts=Ul(10,0,32,cn),fu=ts.filter(es),Zt=au.concat(ts),pi="\n",ls="{YYYY}",vo=pi+ls,ns="{M}/{D}",Il=pi+ns,nn=Il+"/{YY}",is="\
{aa}",pu="{h}:{mm}",_l=pu+is,So=pi+_l,_o=":{ss}",re=null;function os(e){let l=e*1e3,o=l*60,n=o*60,s=n*24,a=s*30,c=s*365,d=(e==1?Ul(10,0,3,cn).filter(es):Ul(10,-3,
0,cn)).concat([l,l*5,l*10,l*15,l*30,o,o*5,o*10,o*15,o*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,a,a*2,a*3,a*4,a*6,c,c*2,c*5,c*10,
c*25,c*50,c*100]),h=[[c,ls,re,re,re,re,re,re,1],[s*28,"{MMM}",vo,re,re,re,re,re,1],[s,ns,vo,re,re,re,re,re,1],[n,"{h}"+is,nn,re,Il,re,re,re,1],[o,_l,nn,re,Il,re,
re,re,1],[l,_o,nn+" "+_l,re,Il+" "+_l,re,So,re,1],[e,_o+".{fff}",nn+" "+_l,re,Il+" "+_l,re,So,re,1]];function x(g){return(w,D,M,z,O,W)=>{let _=[],A=O>=c,y=O>=a&&
O<c,K=g(M),C=fe(K*e,3),q=Un(K.getFullYear(),A?0:K.getMonth(),y||A?1:K.getDate()),U=fe(q*e,3);if(y||A){let Q=y?O/a:0,Y=A?O/c:0,k=C==U?C:fe(Un(q.getFullYear()+Y,q.
getMonth()+Q,1)*e,3),j=new Date(Ee(k/e)),N=j.getFullYear(),I=j.getMonth();for(let H=0;k<=z;H++){let ee=Un(N+Y*H,I+Q*H,1),F=ee-g(fe(ee*e,3));k=fe((+ee+F)*e,3),k<=
z&&_.push(k)}}else{let Q=O>=s?s:O,Y=tt(M)-tt(C),k=U+Y+pn(C-U,Q);_.push(k);let j=g(k),N=j.getHours()+j.getMinutes()/o+j.getSeconds()/n,I=O/n,H=w.axes[D]._space,ee=W/
H;for(;k=fe(k+O,e==1?0:3),!(k>z);)if(I>1){let F=tt(fe(N+I,6))%24,te=g(k).getHours()-F;te>1&&(te=-1),k-=te*n,N=(N+I)%24;let ue=_[_.length-1];fe((k-ue)/O,3)*ee>=.7&&
_.push(k)}else _.push(k)}return _}}return[d,h,x]}var[du,hu,mu]=os(1),[gu,wu,bu]=os(.001);Ul(2,-53,53,[1]);function yo(e,l){return e.map(o=>o.map((n,s)=>s==0||s==
8||n==null?n:l(s==1||o[8]==0?n:o[1]+n)))}function ko(e,l){return(o,n,s,a,c)=>{let p=l.find(M=>c>=M[0])||l[l.length-1],d,h,x,g,w,D;return n.map(M=>{let z=e(M),O=z.
getFullYear(),W=z.getMonth(),_=z.getDate(),A=z.getHours(),y=z.getMinutes(),K=z.getSeconds(),C=O!=d&&p[2]||W!=h&&p[3]||_!=x&&p[4]||A!=g&&p[5]||y!=w&&p[6]||K!=D&&
p[7]||p[1];return d=O,h=W,x=_,g=A,w=y,D=K,C(z)})}}function xu(e,l){let o=fi(l);return(n,s,a,c,p)=>s.map(d=>o(e(d)))}function Un(e,l,o){return new Date(e,l,o)}function To(e,l){
return l(e)}var vu="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Mo(e,l){return(o,n,s,a)=>a==null?oi:l(e(n))}function Su(e,l){let o=e.series[l];return o.width?o.stroke(
e,l):o.points.width?o.points.stroke(e,l):null}function _u(e,l){return e.series[l].fill(e,l)}var yu={show:!0,live:!0,isolate:!1,mount:Ir,markers:{show:!0,width:2,
stroke:Su,fill:_u,dash:"solid"},idx:null,idxs:null,values:[]};function ku(e,l){let o=e.cursor.points,n=ct(),s=o.size(e,l);ge(n,Wl,s),ge(n,Gl,s);let a=s/-2;ge(n,
"marginLeft",a),ge(n,"marginTop",a);let c=o.width(e,l,s);return c&&ge(n,"borderWidth",c),n}function Tu(e,l){let o=e.series[l].points;return o._fill||o._stroke}function Mu(e,l){
let o=e.series[l].points;return o._stroke||o._fill}function Eu(e,l){return e.series[l].points.size}var $n=[0,0];function Au(e,l,o){return $n[0]=l,$n[1]=o,$n}function on(e,l,o,n=!0){
return s=>{s.button==0&&(!n||s.target==l)&&o(s)}}function jn(e,l,o,n=!0){return s=>{(!n||s.target==l)&&o(s)}}var Pu={show:!0,x:!0,y:!0,lock:!1,move:Au,points:{one:!1,
show:ku,size:Eu,width:0,stroke:Mu,fill:Tu},bind:{mousedown:on,mouseup:on,click:on,dblclick:on,mousemove:jn,mouseleave:jn,mouseenter:jn},drag:{setScale:!0,x:!0,y:!1,
dist:0,uni:null,click:(e,l)=>{l.stopPropagation(),l.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(e,l,o,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,
bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ss={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},di=ke({},ss,{filter:$o}),rs=ke({},di,{size:10}),
us=ke({},ss,{show:!1}),hi='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI E\
moji", "Segoe UI Symbol", "Noto Color Emoji"',cs="bold "+hi,as=1.5,Eo={show:!0,scale:"x",stroke:ii,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:cs,
side:2,grid:di,ticks:rs,border:us,font:hi,lineGap:as,rotate:0},Du="Value",Lu="Time",Ao={show:!0,scale:"x",auto:!1,sorted:1,min:ae,max:-ae,idxs:[]};function Cu(e,l,o,n,s){
return l.map(a=>a==null?"":ci(a))}function zu(e,l,o,n,s,a,c){let p=[],d=Ht.get(s)||0;o=c?o:fe(pn(o,s),d);for(let h=o;h<=n;h=fe(h+s,d))p.push(Object.is(h,-0)?0:h);
return p}function Xn(e,l,o,n,s,a,c){let p=[],d=e.scales[e.axes[l].scale].log,h=d==10?Dt:Bo,x=tt(h(o));s=kl(d,x),d==10&&(s=Zt[wt(s,Zt)]);let g=o,w=s*d;d==10&&(w=
Zt[wt(w,Zt)]);do p.push(g),g=g+s,d==10&&!Ht.has(g)&&(g=fe(g,Ht.get(s))),g>=w&&(s=g,w=s*d,d==10&&(w=Zt[wt(w,Zt)]));while(g<=n);return p}function Nu(e,l,o,n,s,a,c){
let d=e.scales[e.axes[l].scale].asinh,h=n>d?Xn(e,l,Ue(d,o),n,s):[d],x=n>=0&&o<=0?[0]:[];return(o<-d?Xn(e,l,Ue(d,-n),-o,s):[d]).reverse().map(w=>-w).concat(x,h)}
var fs=/./,Ru=/[12357]/,Vu=/[125]/,Po=/1/,ei=(e,l,o,n)=>e.map((s,a)=>l==4&&s==0||a%n==0&&o.test(s.toExponential()[s<0?1:0])?s:null);function Fu(e,l,o,n,s){let a=e.
axes[o],c=a.scale,p=e.scales[c],d=e.valToPos,h=a._space,x=d(10,c),g=d(9,c)-x>=h?fs:d(7,c)-x>=h?Ru:d(5,c)-x>=h?Vu:Po;if(g==Po){let w=Ae(d(1,c)-x);if(w<h)return ei(
l.slice().reverse(),p.distr,g,at(h/w)).reverse()}return ei(l,p.distr,g,1)}function Ou(e,l,o,n,s){let a=e.axes[o],c=a.scale,p=a._space,d=e.valToPos,h=Ae(d(1,c)-d(
2,c));return h<p?ei(l.slice().reverse(),3,fs,at(p/h)).reverse():l}function Hu(e,l,o,n){return n==null?oi:l==null?"":ci(l)}var Do={show:!0,scale:"y",stroke:ii,space:30,
gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:cs,side:3,grid:di,ticks:rs,border:us,font:hi,lineGap:as,rotate:0};function Wu(e,l){let o=3+(e||1)*2;return fe(
o*l,3)}function Gu(e,l){let{scale:o,idxs:n}=e.series[0],s=e._data[0],a=e.valToPos(s[n[0]],o,!0),c=e.valToPos(s[n[1]],o,!0),p=Ae(c-a),d=e.series[l],h=p/(d.points.
space*oe);return n[1]-n[0]<=h}var Lo={scale:null,auto:!0,sorted:0,min:ae,max:-ae},ps=(e,l,o,n,s)=>s,Co={show:!0,auto:!0,sorted:0,gaps:ps,alpha:1,facets:[ke({},Lo,
{scale:"x"}),ke({},Lo,{scale:"y"})]},zo={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:ps,alpha:1,points:{show:Gu,filter:null},values:null,min:ae,max:-ae,
idxs:[],path:null,clip:null};function Iu(e,l,o,n,s){return o/10}var ds={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Bu=ke({},ds,{time:!1,
ori:1}),No={};function hs(e,l){let o=No[e];return o||(o={key:e,plots:[],sub(n){o.plots.push(n)},unsub(n){o.plots=o.plots.filter(s=>s!=n)},pub(n,s,a,c,p,d,h){for(let x=0;x<
o.plots.length;x++)o.plots[x]!=s&&o.plots[x].pub(n,s,a,c,p,d,h)}},e!=null&&(No[e]=o)),o}var El=1,ti=2;function tl(e,l,o){let n=e.mode,s=e.series[l],a=n==2?e._data[l]:
e._data,c=e.scales,p=e.bbox,d=a[0],h=n==2?a[1]:a[l],x=n==2?c[s.facets[0].scale]:c[e.series[0].scale],g=n==2?c[s.facets[1].scale]:c[s.scale],w=p.left,D=p.top,M=p.
width,z=p.height,O=e.valToPosH,W=e.valToPosV;return x.ori==0?o(s,d,h,x,g,O,W,w,D,M,z,mn,Pl,wn,gs,bs):o(s,d,h,x,g,W,O,D,w,z,M,gn,Dl,wi,ws,xs)}function mi(e,l){let o=0,
n=0,s=ne(e.bands,ai);for(let a=0;a<s.length;a++){let c=s[a];c.series[0]==l?o=c.dir:c.series[1]==l&&(c.dir==1?n|=1:n|=2)}return[o,n==1?-1:n==2?1:n==3?2:0]}function Yu(e,l,o,n,s){
let a=e.mode,c=e.series[l],p=a==2?c.facets[1].scale:c.scale,d=e.scales[p];return s==-1?d.min:s==1?d.max:d.distr==3?d.dir==1?d.min:d.max:0}function Lt(e,l,o,n,s,a){
return tl(e,l,(c,p,d,h,x,g,w,D,M,z,O)=>{let W=c.pxRound,_=h.dir*(h.ori==0?1:-1),A=h.ori==0?Pl:Dl,y,K;_==1?(y=o,K=n):(y=n,K=o);let C=W(g(p[y],h,z,D)),q=W(w(d[y],
x,O,M)),U=W(g(p[K],h,z,D)),Q=W(w(a==1?x.max:x.min,x,O,M)),Y=new Path2D(s);return A(Y,U,Q),A(Y,C,Q),A(Y,C,q),Y})}function hn(e,l,o,n,s,a){let c=null;if(e.length>
0){c=new Path2D;let p=l==0?wn:wi,d=o;for(let g=0;g<e.length;g++){let w=e[g];if(w[1]>w[0]){let D=w[0]-d;D>0&&p(c,d,n,D,n+a),d=w[1]}}let h=o+s-d,x=10;h>0&&p(c,d,n-
x/2,h,n+a+x)}return c}function Uu(e,l,o){let n=e[e.length-1];n&&n[0]==l?n[1]=o:e.push([l,o])}function gi(e,l,o,n,s,a,c){let p=[],d=e.length;for(let h=s==1?o:n;h>=
o&&h<=n;h+=s)if(l[h]===null){let g=h,w=h;if(s==1)for(;++h<=n&&l[h]===null;)w=h;else for(;--h>=o&&l[h]===null;)w=h;let D=a(e[g]),M=w==g?D:a(e[w]),z=g-s;D=c<=0&&z>=
0&&z<d?a(e[z]):D;let W=w+s;M=c>=0&&W>=0&&W<d?a(e[W]):M,M>=D&&p.push([D,M])}return p}function Ro(e){return e==0?Uo:e==1?Ee:l=>Jt(l,e)}function ms(e){let l=e==0?mn:
gn,o=e==0?(s,a,c,p,d,h)=>{s.arcTo(a,c,p,d,h)}:(s,a,c,p,d,h)=>{s.arcTo(c,a,d,p,h)},n=e==0?(s,a,c,p,d)=>{s.rect(a,c,p,d)}:(s,a,c,p,d)=>{s.rect(c,a,d,p)};return(s,a,c,p,d,h=0,x=0)=>{
h==0&&x==0?n(s,a,c,p,d):(h=bt(h,p/2,d/2),x=bt(x,p/2,d/2),l(s,a+h,c),o(s,a+p,c,a+p,c+d,h),o(s,a+p,c+d,a,c+d,x),o(s,a,c+d,a,c,x),o(s,a,c,a+p,c,h),s.closePath())}}
var mn=(e,l,o)=>{e.moveTo(l,o)},gn=(e,l,o)=>{e.moveTo(o,l)},Pl=(e,l,o)=>{e.lineTo(l,o)},Dl=(e,l,o)=>{e.lineTo(o,l)},wn=ms(0),wi=ms(1),gs=(e,l,o,n,s,a)=>{e.arc(l,
o,n,s,a)},ws=(e,l,o,n,s,a)=>{e.arc(o,l,n,s,a)},bs=(e,l,o,n,s,a,c)=>{e.bezierCurveTo(l,o,n,s,a,c)},xs=(e,l,o,n,s,a,c)=>{e.bezierCurveTo(o,l,s,n,c,a)};function vs(e){
return(l,o,n,s,a)=>tl(l,o,(c,p,d,h,x,g,w,D,M,z,O)=>{let{pxRound:W,points:_}=c,A,y;h.ori==0?(A=mn,y=gs):(A=gn,y=ws);let K=fe(_.width*oe,3),C=(_.size-_.width)/2*oe,
q=fe(C*2,3),U=new Path2D,Q=new Path2D,{left:Y,top:k,width:j,height:N}=l.bbox;wn(Q,Y-q,k-q,j+q*2,N+q*2);let I=H=>{if(d[H]!=null){let ee=W(g(p[H],h,z,D)),F=W(w(d[H],
x,O,M));A(U,ee+C,F),y(U,ee,F,C,0,sn*2)}};if(a)a.forEach(I);else for(let H=n;H<=s;H++)I(H);return{stroke:K>0?U:null,fill:U,clip:Q,flags:El|ti}})}function Ss(e){return(l,o,n,s,a,c)=>{
n!=s&&(a!=n&&c!=n&&e(l,o,n),a!=s&&c!=s&&e(l,o,s),e(l,o,c))}}var $u=Ss(Pl),ju=Ss(Dl);function _s(e){let l=ne(e?.alignGaps,0);return(o,n,s,a)=>tl(o,n,(c,p,d,h,x,g,w,D,M,z,O)=>{
[s,a]=an(d,s,a);let W=c.pxRound,_=N=>W(g(N,h,z,D)),A=N=>W(w(N,x,O,M)),y,K;h.ori==0?(y=Pl,K=$u):(y=Dl,K=ju);let C=h.dir*(h.ori==0?1:-1),q={stroke:new Path2D,fill:null,
clip:null,band:null,gaps:null,flags:El},U=q.stroke,Q=!1;if(a-s>=z*4){let N=R=>o.posToVal(R,h.key,!0),I=null,H=null,ee,F,$e,we=_(p[C==1?s:a]),te=_(p[s]),ue=_(p[a]),
J=N(C==1?te+1:ue-1);for(let R=C==1?s:a;R>=s&&R<=a;R+=C){let Te=p[R],be=(C==1?Te<J:Te>J)?we:_(Te),se=d[R];be==we?se!=null?(F=se,I==null?(y(U,be,A(F)),ee=I=H=F):F<
I?I=F:F>H&&(H=F)):se===null&&(Q=!0):(I!=null&&K(U,we,A(I),A(H),A(ee),A(F)),se!=null?(F=se,y(U,be,A(F)),I=H=ee=F):(I=H=null,se===null&&(Q=!0)),we=be,J=N(we+C))}I!=
null&&I!=H&&$e!=we&&K(U,we,A(I),A(H),A(ee),A(F))}else for(let N=C==1?s:a;N>=s&&N<=a;N+=C){let I=d[N];I===null?Q=!0:I!=null&&y(U,_(p[N]),A(I))}let[k,j]=mi(o,n);if(c.
fill!=null||k!=0){let N=q.fill=new Path2D(U),I=c.fillTo(o,n,c.min,c.max,k),H=A(I),ee=_(p[s]),F=_(p[a]);C==-1&&([F,ee]=[ee,F]),y(N,F,H),y(N,ee,H)}if(!c.spanGaps){
let N=[];Q&&N.push(...gi(p,d,s,a,C,_,l)),q.gaps=N=c.gaps(o,n,s,a,N),q.clip=hn(N,h.ori,D,M,z,O)}return j!=0&&(q.band=j==2?[Lt(o,n,s,a,U,-1),Lt(o,n,s,a,U,1)]:Lt(o,
n,s,a,U,j)),q})}function Ku(e){let l=ne(e.align,1),o=ne(e.ascDesc,!1),n=ne(e.alignGaps,0),s=ne(e.extend,!1);return(a,c,p,d)=>tl(a,c,(h,x,g,w,D,M,z,O,W,_,A)=>{[p,
d]=an(g,p,d);let y=h.pxRound,{left:K,width:C}=a.bbox,q=te=>y(M(te,w,_,O)),U=te=>y(z(te,D,A,W)),Q=w.ori==0?Pl:Dl,Y={stroke:new Path2D,fill:null,clip:null,band:null,
gaps:null,flags:El},k=Y.stroke,j=w.dir*(w.ori==0?1:-1),N=U(g[j==1?p:d]),I=q(x[j==1?p:d]),H=I,ee=I;s&&l==-1&&(ee=K,Q(k,ee,N)),Q(k,I,N);for(let te=j==1?p:d;te>=p&&
te<=d;te+=j){let ue=g[te];if(ue==null)continue;let J=q(x[te]),R=U(ue);l==1?Q(k,J,N):Q(k,H,R),Q(k,J,R),N=R,H=J}let F=H;s&&l==1&&(F=K+C,Q(k,F,N));let[$e,we]=mi(a,
c);if(h.fill!=null||$e!=0){let te=Y.fill=new Path2D(k),ue=h.fillTo(a,c,h.min,h.max,$e),J=U(ue);Q(te,F,J),Q(te,ee,J)}if(!h.spanGaps){let te=[];te.push(...gi(x,g,
p,d,j,q,n));let ue=h.width*oe/2,J=o||l==1?ue:-ue,R=o||l==-1?-ue:ue;te.forEach(Te=>{Te[0]+=J,Te[1]+=R}),Y.gaps=te=h.gaps(a,c,p,d,te),Y.clip=hn(te,w.ori,O,W,_,A)}
return we!=0&&(Y.band=we==2?[Lt(a,c,p,d,k,-1),Lt(a,c,p,d,k,1)]:Lt(a,c,p,d,k,we)),Y})}function Vo(e,l,o,n,s,a,c=ae){if(e.length>1){let p=null;for(let d=0,h=1/0;d<
e.length;d++)if(l[d]!==void 0){if(p!=null){let x=Ae(e[d]-e[p]);x<h&&(h=x,c=Ae(o(e[d],n,s,a)-o(e[p],n,s,a)))}p=d}}return c}function qu(e){e=e||Yl;let l=ne(e.size,
[.6,ae,1]),o=e.align||0,n=e.gap||0,s=e.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let a=X(s),c=1-l[0],p=ne(l[1],ae),d=ne(l[2],1),h=ne(e.disp,Yl),x=ne(e.each,
D=>{}),{fill:g,stroke:w}=h;return(D,M,z,O)=>tl(D,M,(W,_,A,y,K,C,q,U,Q,Y,k)=>{let j=W.pxRound,N=o,I=n*oe,H=p*oe,ee=d*oe,F,$e;y.ori==0?[F,$e]=a(D,M):[$e,F]=a(D,M);
let we=y.dir*(y.ori==0?1:-1),te=y.ori==0?wn:wi,ue=y.ori==0?x:(P,pe,Me,ol,It,vt,Bt)=>{x(P,pe,Me,It,ol,Bt,vt)},J=ne(D.bands,ai).find(P=>P.series[0]==M),R=J!=null?
J.dir:0,Te=W.fillTo(D,M,W.min,W.max,R),We=j(q(Te,K,k,Q)),be,se,ft,qe=Y,ve=j(W.width*oe),xt=!1,Et=null,nt=null,Ct=null,ll=null;g!=null&&(ve==0||w!=null)&&(xt=!0,
Et=g.values(D,M,z,O),nt=new Map,new Set(Et).forEach(P=>{P!=null&&nt.set(P,new Path2D)}),ve>0&&(Ct=w.values(D,M,z,O),ll=new Map,new Set(Ct).forEach(P=>{P!=null&&
ll.set(P,new Path2D)})));let{x0:nl,size:Ll}=h;if(nl!=null&&Ll!=null){N=1,_=nl.values(D,M,z,O),nl.unit==2&&(_=_.map(Me=>D.posToVal(U+Me*Y,y.key,!0)));let P=Ll.values(
D,M,z,O);Ll.unit==2?se=P[0]*Y:se=C(P[0],y,Y,U)-C(0,y,Y,U),qe=Vo(_,A,C,y,Y,U,qe),ft=qe-se+I}else qe=Vo(_,A,C,y,Y,U,qe),ft=qe*c+I,se=qe-ft;ft<1&&(ft=0),ve>=se/2&&
(ve=0),ft<5&&(j=Uo);let $l=ft>0,Wt=qe-ft-($l?ve:0);se=j(Qn(Wt,ee,H)),be=(N==0?se/2:N==we?0:se)-N*we*((N==0?I/2:0)+($l?ve/2:0));let Ge={stroke:null,fill:null,clip:null,
band:null,gaps:null,flags:0},il=xt?null:new Path2D,At=null;if(J!=null)At=D.data[J.series[1]];else{let{y0:P,y1:pe}=h;P!=null&&pe!=null&&(A=pe.values(D,M,z,O),At=
P.values(D,M,z,O))}let Gt=F*se,$=$e*se;for(let P=we==1?z:O;P>=z&&P<=O;P+=we){let pe=A[P];if(pe==null)continue;if(At!=null){let je=At[P]??0;if(pe-je==0)continue;
We=q(je,K,k,Q)}let Me=y.distr!=2||h!=null?_[P]:P,ol=C(Me,y,Y,U),It=q(ne(pe,Te),K,k,Q),vt=j(ol-be),Bt=j(Ue(It,We)),Je=j(bt(It,We)),it=Bt-Je;if(pe!=null){let je=pe<
0?$:Gt,pt=pe<0?Gt:$;xt?(ve>0&&Ct[P]!=null&&te(ll.get(Ct[P]),vt,Je+tt(ve/2),se,Ue(0,it-ve),je,pt),Et[P]!=null&&te(nt.get(Et[P]),vt,Je+tt(ve/2),se,Ue(0,it-ve),je,
pt)):te(il,vt,Je+tt(ve/2),se,Ue(0,it-ve),je,pt),ue(D,M,P,vt-ve/2,Je,se+ve,it)}}return ve>0?Ge.stroke=xt?ll:il:xt||(Ge._fill=W.width==0?W._fill:W._stroke??W._fill,
Ge.width=0),Ge.fill=xt?nt:il,Ge})}function Ju(e,l){let o=ne(l?.alignGaps,0);return(n,s,a,c)=>tl(n,s,(p,d,h,x,g,w,D,M,z,O,W)=>{[a,c]=an(h,a,c);let _=p.pxRound,A=F=>_(
w(F,x,O,M)),y=F=>_(D(F,g,W,z)),K,C,q;x.ori==0?(K=mn,q=Pl,C=bs):(K=gn,q=Dl,C=xs);let U=x.dir*(x.ori==0?1:-1),Q=A(d[U==1?a:c]),Y=Q,k=[],j=[];for(let F=U==1?a:c;F>=
a&&F<=c;F+=U)if(h[F]!=null){let we=d[F],te=A(we);k.push(Y=te),j.push(y(h[F]))}let N={stroke:e(k,j,K,q,C,_),fill:null,clip:null,band:null,gaps:null,flags:El},I=N.
stroke,[H,ee]=mi(n,s);if(p.fill!=null||H!=0){let F=N.fill=new Path2D(I),$e=p.fillTo(n,s,p.min,p.max,H),we=y($e);q(F,Y,we),q(F,Q,we)}if(!p.spanGaps){let F=[];F.push(
...gi(d,h,a,c,U,A,o)),N.gaps=F=p.gaps(n,s,a,c,F),N.clip=hn(F,x.ori,M,z,O,W)}return ee!=0&&(N.band=ee==2?[Lt(n,s,a,c,I,-1),Lt(n,s,a,c,I,1)]:Lt(n,s,a,c,I,ee)),N})}
function Zu(e){return Ju(Qu,e)}function Qu(e,l,o,n,s,a){let c=e.length;if(c<2)return null;let p=new Path2D;if(o(p,e[0],l[0]),c==2)n(p,e[1],l[1]);else{let d=Array(
c),h=Array(c-1),x=Array(c-1),g=Array(c-1);for(let w=0;w<c-1;w++)x[w]=l[w+1]-l[w],g[w]=e[w+1]-e[w],h[w]=x[w]/g[w];d[0]=h[0];for(let w=1;w<c-1;w++)h[w]===0||h[w-1]===
0||h[w-1]>0!=h[w]>0?d[w]=0:(d[w]=3*(g[w-1]+g[w])/((2*g[w]+g[w-1])/h[w-1]+(g[w]+2*g[w-1])/h[w]),isFinite(d[w])||(d[w]=0));d[c-1]=h[c-2];for(let w=0;w<c-1;w++)s(p,
e[w]+g[w]/3,l[w]+d[w]*g[w]/3,e[w+1]-g[w]/3,l[w+1]-d[w+1]*g[w]/3,e[w+1],l[w+1])}return p}var li=new Set;function Fo(){for(let e of li)e.syncRect(!0)}Al&&(Xt(Cr,yl,
Fo),Xt(zr,yl,Fo,!0),Xt(rn,yl,()=>{Pe.pxRatio=oe}));var Xu=_s(),ec=vs();function Oo(e,l,o,n){return(n?[e[0],e[1]].concat(e.slice(2)):[e[0]].concat(e.slice(1))).map(
(a,c)=>ni(a,c,l,o))}function tc(e,l){return e.map((o,n)=>n==0?{}:ke({},l,o))}function ni(e,l,o,n){return ke({},l==0?o:n,e)}function ys(e,l,o){return l==null?Tl:
[l,o]}var lc=ys;function nc(e,l,o){return l==null?Tl:un(l,o,ui,!0)}function ks(e,l,o,n){return l==null?Tl:fn(l,o,e.scales[n].log,!1)}var ic=ks;function Ts(e,l,o,n){
return l==null?Tl:ri(l,o,e.scales[n].log,!1)}var oc=Ts;function sc(e,l,o,n,s){let a=Ue(go(e),go(l)),c=l-e,p=wt(s/n*c,o);do{let d=o[p],h=n*d/c;if(h>=s&&a+(d<5?Ht.
get(d):0)<=17)return[d,h]}while(++p<o.length);return[0,0]}function Ho(e){let l,o;return e=e.replace(/(\d+)px/,(n,s)=>(l=Ee((o=+s)*oe))+"px"),[e,l,o]}function rc(e){
e.show&&[e.font,e.labelFont].forEach(l=>{let o=fe(l[2]*oe,1);l[0]=l[0].replace(/[0-9.]+px/,o+"px"),l[1]=o})}function Pe(e,l,o){let n={mode:ne(e.mode,1)},s=n.mode;
function a(t,i,r,u){let f=i.valToPct(t);return u+r*(i.dir==-1?1-f:f)}function c(t,i,r,u){let f=i.valToPct(t);return u+r*(i.dir==-1?f:1-f)}function p(t,i,r,u){return i.
ori==0?a(t,i,r,u):c(t,i,r,u)}n.valToPosH=a,n.valToPosV=c;let d=!1;n.status=0;let h=n.root=ct(hr);if(e.id!=null&&(h.id=e.id),et(h,e.class),e.title){let t=ct(wr,h);
t.textContent=e.title}let x=gt("canvas"),g=n.ctx=x.getContext("2d"),w=ct(br,h);Xt("click",w,t=>{t.target===M&&(de!=gl||xe!=wl)&&Oe.click(n,t)},!0);let D=n.under=
ct(xr,w);w.appendChild(x);let M=n.over=ct(vr,w);e=Ml(e);let z=+ne(e.pxAlign,1),O=Ro(z);(e.plugins||[]).forEach(t=>{t.opts&&(e=t.opts(n,e)||e)});let W=e.ms||.001,
_=n.series=s==1?Oo(e.series||[],Ao,zo,!1):tc(e.series||[null],Co),A=n.axes=Oo(e.axes||[],Eo,Do,!0),y=n.scales={},K=n.bands=e.bands||[];K.forEach(t=>{t.fill=X(t.
fill||null),t.dir=ne(t.dir,-1)});let C=s==2?_[1].facets[0].scale:_[0].scale,q={axes:Zs,series:$s},U=(e.drawOrder||["axes","series"]).map(t=>q[t]);function Q(t){
let i=t.distr==3?r=>Dt(r>0?r:t.clamp(n,r,t.min,t.max,t.key)):t.distr==4?r=>Yn(r,t.asinh):t.distr==100?r=>t.fwd(r):r=>r;return r=>{let u=i(r),{_min:f,_max:m}=t,b=m-
f;return(u-f)/b}}function Y(t){let i=y[t];if(i==null){let r=(e.scales||Yl)[t]||Yl;if(r.from!=null){Y(r.from);let u=ke({},y[r.from],r,{key:t});u.valToPct=Q(u),y[t]=
u}else{i=y[t]=ke({},t==C?ds:Bu,r),i.key=t;let u=i.time,f=i.range,m=Ot(f);if((t!=C||s==2&&!u)&&(m&&(f[0]==null||f[1]==null)&&(f={min:f[0]==null?po:{mode:1,hard:f[0],
soft:f[0]},max:f[1]==null?po:{mode:1,hard:f[1],soft:f[1]}},m=!1),!m&&dn(f))){let b=f;f=(v,S,T)=>S==null?Tl:un(S,T,b)}i.range=X(f||(u?lc:t==C?i.distr==3?ic:i.distr==
4?oc:ys:i.distr==3?ks:i.distr==4?Ts:nc)),i.auto=X(m?!1:i.auto),i.clamp=X(i.clamp||Iu),i._min=i._max=null,i.valToPct=Q(i)}}}Y("x"),Y("y"),s==1&&_.forEach(t=>{Y(t.
scale)}),A.forEach(t=>{Y(t.scale)});for(let t in e.scales)Y(t);let k=y[C],j=k.distr,N,I;k.ori==0?(et(h,mr),N=a,I=c):(et(h,gr),N=c,I=a);let H={};for(let t in y){
let i=y[t];(i.min!=null||i.max!=null)&&(H[t]={min:i.min,max:i.max},i.min=i.max=null)}let ee=e.tzDate||(t=>new Date(Ee(t/W))),F=e.fmtDate||fi,$e=W==1?mu(ee):bu(ee),
we=ko(ee,yo(W==1?hu:wu,F)),te=Mo(ee,To(vu,F)),ue=[],J=n.legend=ke({},yu,e.legend),R=n.cursor=ke({},Pu,{drag:{y:s==2}},e.cursor),Te=J.show,We=R.show,be=J.markers;
J.idxs=ue,be.width=X(be.width),be.dash=X(be.dash),be.stroke=X(be.stroke),be.fill=X(be.fill);let se,ft,qe,ve=[],xt=[],Et,nt=!1,Ct={};if(J.live){let t=_[1]?_[1].values:
null;nt=t!=null,Et=nt?t(n,1,0):{_:0};for(let i in Et)Ct[i]=oi}if(Te)if(se=gt("table",Mr,h),qe=gt("tbody",null,se),J.mount(n,se),nt){ft=gt("thead",null,se,qe);let t=gt(
"tr",null,ft);gt("th",null,t);for(var ll in Et)gt("th",Xi,t).textContent=ll}else et(se,Ar),J.live&&et(se,Er);let nl={show:!0},Ll={show:!1};function $l(t,i){if(i==
0&&(nt||!J.live||s==2))return Tl;let r=[],u=gt("tr",Pr,qe,qe.childNodes[i]);et(u,t.class),t.show||et(u,Qt);let f=gt("th",null,u);if(be.show){let v=ct(Dr,f);if(i>
0){let S=be.width(n,i);S&&(v.style.border=S+"px "+be.dash(n,i)+" "+be.stroke(n,i)),v.style.background=be.fill(n,i)}}let m=ct(Xi,f);t.label instanceof HTMLElement?
m.appendChild(t.label):m.textContent=t.label,i>0&&(be.show||(m.style.color=t.width>0?be.stroke(n,i):be.fill(n,i)),Ge("click",f,v=>{if(R._lock)return;Ut(v);let S=_.
indexOf(t);if((v.ctrlKey||v.metaKey)!=J.isolate){let T=_.some((E,L)=>L>0&&L!=S&&E.show);_.forEach((E,L)=>{L>0&&_t(L,T?L==S?nl:Ll:nl,!0,ye.setSeries)})}else _t(S,
{show:!t.show},!0,ye.setSeries)},!1),rl&&Ge(no,f,v=>{R._lock||(Ut(v),_t(_.indexOf(t),xl,!0,ye.setSeries))},!1));for(var b in Et){let v=gt("td",Lr,u);v.textContent=
"--",r.push(v)}return[u,r]}let Wt=new Map;function Ge(t,i,r,u=!0){let f=Wt.get(i)||{},m=R.bind[t](n,i,r,u);m&&(Xt(t,i,f[t]=m),Wt.set(i,f))}function il(t,i,r){let u=Wt.
get(i)||{};for(let f in u)(t==null||f==t)&&(Zn(f,i,u[f]),delete u[f]);t==null&&Wt.delete(i)}let At=0,Gt=0,$=0,P=0,pe=0,Me=0,ol=pe,It=Me,vt=$,Bt=P,Je=0,it=0,je=0,
pt=0;n.bbox={};let bn=!1,jl=!1,sl=!1,Yt=!1,Kl=!1,ot=!1;function xn(t,i,r){(r||t!=n.width||i!=n.height)&&Si(t,i),pl(!1),sl=!0,jl=!0,dl()}function Si(t,i){n.width=
At=$=t,n.height=Gt=P=i,pe=Me=0,Hs(),Ws();let r=n.bbox;Je=r.left=Jt(pe*oe,.5),it=r.top=Jt(Me*oe,.5),je=r.width=Jt($*oe,.5),pt=r.height=Jt(P*oe,.5)}let Vs=3;function Fs(){
let t=!1,i=0;for(;!t;){i++;let r=qs(i),u=Js(i);t=i==Vs||r&&u,t||(Si(n.width,n.height),jl=!0)}}function Os({width:t,height:i}){xn(t,i)}n.setSize=Os;function Hs(){
let t=!1,i=!1,r=!1,u=!1;A.forEach((f,m)=>{if(f.show&&f._show){let{side:b,_size:v}=f,S=b%2,T=f.label!=null?f.labelSize:0,E=v+T;E>0&&(S?($-=E,b==3?(pe+=E,u=!0):r=
!0):(P-=E,b==0?(Me+=E,t=!0):i=!0))}}),$t[0]=t,$t[1]=r,$t[2]=i,$t[3]=u,$-=zt[1]+zt[3],pe+=zt[3],P-=zt[2]+zt[0],Me+=zt[0]}function Ws(){let t=pe+$,i=Me+P,r=pe,u=Me;
function f(m,b){switch(m){case 1:return t+=b,t-b;case 2:return i+=b,i-b;case 3:return r-=b,r+b;case 0:return u-=b,u+b}}A.forEach((m,b)=>{if(m.show&&m._show){let v=m.
side;m._pos=f(v,m._size),m.label!=null&&(m._lpos=f(v,m.labelSize))}})}if(R.dataIdx==null){let t=R.hover,i=t.skip=new Set(t.skip??[]);i.add(void 0);let r=t.prox=
X(t.prox),u=t.bias??=0;R.dataIdx=(f,m,b,v)=>{if(m==0)return b;let S=b,T=r(f,m,b,v)??ae,E=T>=0&&T<ae,L=k.ori==0?$:P,B=R.left,ie=l[0],le=l[m];if(i.has(le[b])){S=null;
let Z=null,G=null,V;if(u==0||u==-1)for(V=b;Z==null&&V-- >0;)i.has(le[V])||(Z=V);if(u==0||u==1)for(V=b;G==null&&V++<le.length;)i.has(le[V])||(G=V);if(Z!=null||G!=
null)if(E){let me=Z==null?-1/0:N(ie[Z],k,L,0),Se=G==null?1/0:N(ie[G],k,L,0),Ve=B-me,ce=Se-B;Ve<=ce?Ve<=T&&(S=Z):ce<=T&&(S=G)}else S=G==null?Z:Z==null?G:b-Z<=G-b?
Z:G}else E&&Ae(B-N(ie[b],k,L,0))>T&&(S=null);return S}}let Ut=t=>{R.event=t};R.idxs=ue,R._lock=!1;let He=R.points;He.show=X(He.show),He.size=X(He.size),He.stroke=
X(He.stroke),He.width=X(He.width),He.fill=X(He.fill);let St=n.focus=ke({},e.focus||{alpha:.3},R.focus),rl=St.prox>=0,ul=rl&&He.one,st=[],cl=[],al=[];function _i(t,i){
let r=He.show(n,i);if(r instanceof HTMLElement)return et(r,Tr),et(r,t.class),Mt(r,-10,-10,$,P),M.insertBefore(r,st[i]),r}function yi(t,i){if(s==1||i>0){let r=s==
1&&y[t.scale].time,u=t.value;t.value=r?xo(u)?Mo(ee,To(u,F)):u||te:u||Hu,t.label=t.label||(r?Lu:Du)}if(ul||i>0){t.width=t.width==null?1:t.width,t.paths=t.paths||
Xu||Br,t.fillTo=X(t.fillTo||Yu),t.pxAlign=+ne(t.pxAlign,z),t.pxRound=Ro(t.pxAlign),t.stroke=X(t.stroke||null),t.fill=X(t.fill||null),t._stroke=t._fill=t._paths=
t._focus=null;let r=Wu(Ue(1,t.width),1),u=t.points=ke({},{size:r,width:Ue(1,r*.2),stroke:t.stroke,space:r*2,paths:ec,_stroke:null,_fill:null},t.points);u.show=X(
u.show),u.filter=X(u.filter),u.fill=X(u.fill),u.stroke=X(u.stroke),u.paths=X(u.paths),u.pxAlign=t.pxAlign}if(Te){let r=$l(t,i);ve.splice(i,0,r[0]),xt.splice(i,0,
r[1]),J.values.push(null)}if(We){ue.splice(i,0,null);let r=null;ul?i==0&&(r=_i(t,i)):i>0&&(r=_i(t,i)),st.splice(i,0,r),cl.splice(i,0,0),al.splice(i,0,0)}Re("add\
Series",i)}function Gs(t,i){i=i??_.length,t=s==1?ni(t,i,Ao,zo):ni(t,i,{},Co),_.splice(i,0,t),yi(_[i],i)}n.addSeries=Gs;function Is(t){if(_.splice(t,1),Te){J.values.
splice(t,1),xt.splice(t,1);let i=ve.splice(t,1)[0];il(null,i.firstChild),i.remove()}We&&(ue.splice(t,1),st.splice(t,1)[0].remove(),cl.splice(t,1),al.splice(t,1)),
Re("delSeries",t)}n.delSeries=Is;let $t=[!1,!1,!1,!1];function Bs(t,i){if(t._show=t.show,t.show){let r=t.side%2,u=y[t.scale];u==null&&(t.scale=r?_[1].scale:C,u=
y[t.scale]);let f=u.time;t.size=X(t.size),t.space=X(t.space),t.rotate=X(t.rotate),Ot(t.incrs)&&t.incrs.forEach(b=>{!Ht.has(b)&&Ht.set(b,Ko(b))}),t.incrs=X(t.incrs||
(u.distr==2?fu:f?W==1?du:gu:Zt)),t.splits=X(t.splits||(f&&u.distr==1?$e:u.distr==3?Xn:u.distr==4?Nu:zu)),t.stroke=X(t.stroke),t.grid.stroke=X(t.grid.stroke),t.ticks.
stroke=X(t.ticks.stroke),t.border.stroke=X(t.border.stroke);let m=t.values;t.values=Ot(m)&&!Ot(m[0])?X(m):f?Ot(m)?ko(ee,yo(m,F)):xo(m)?xu(ee,m):m||we:m||Cu,t.filter=
X(t.filter||(u.distr>=3&&u.log==10?Fu:u.distr==3&&u.log==2?Ou:$o)),t.font=Ho(t.font),t.labelFont=Ho(t.labelFont),t._size=t.size(n,null,i,0),t._space=t._rotate=t.
_incrs=t._found=t._splits=t._values=null,t._size>0&&($t[i]=!0,t._el=ct(Sr,w))}}function Cl(t,i,r,u){let[f,m,b,v]=r,S=i%2,T=0;return S==0&&(v||m)&&(T=i==0&&!f||i==
2&&!b?Ee(Eo.size/3):0),S==1&&(f||b)&&(T=i==1&&!m||i==3&&!v?Ee(Do.size/2):0),T}let ki=n.padding=(e.padding||[Cl,Cl,Cl,Cl]).map(t=>X(ne(t,Cl))),zt=n._padding=ki.map(
(t,i)=>t(n,i,$t,0)),Fe,Le=null,Ce=null,ql=s==1?_[0].idxs:null,dt=null,zl=!1;function Ti(t,i){if(l=t??[],n.data=n._data=l,s==2){Fe=0;for(let r=1;r<_.length;r++)Fe+=
l[r][0].length}else{l.length==0&&(n.data=n._data=l=[[]]),dt=l[0],Fe=dt.length;let r=l;if(j==2){r=l.slice();let u=r[0]=Array(Fe);for(let f=0;f<Fe;f++)u[f]=f}n._data=
l=r}if(pl(!0),Re("setData"),j==2&&(sl=!0),i!==!1){let r=k;r.auto(n,zl)?vn():Rt(C,r.min,r.max),Yt=Yt||R.left>=0,ot=!0,dl()}}n.setData=Ti;function vn(){zl=!0;let t,
i;s==1&&(Fe>0?(Le=ql[0]=0,Ce=ql[1]=Fe-1,t=l[0][Le],i=l[0][Ce],j==2?(t=Le,i=Ce):t==i&&(j==3?[t,i]=fn(t,t,k.log,!1):j==4?[t,i]=ri(t,t,k.log,!1):k.time?i=t+Ee(86400/
W):[t,i]=un(t,i,ui,!0))):(Le=ql[0]=t=null,Ce=ql[1]=i=null)),Rt(C,t,i)}let Jl,fl,Sn,_n,yn,kn,Tn,Mn,En,Ke;function Mi(t,i,r,u,f,m){t??=to,r??=ai,u??="butt",f??=to,
m??="round",t!=Jl&&(g.strokeStyle=Jl=t),f!=fl&&(g.fillStyle=fl=f),i!=Sn&&(g.lineWidth=Sn=i),m!=yn&&(g.lineJoin=yn=m),u!=kn&&(g.lineCap=kn=u),r!=_n&&g.setLineDash(
_n=r)}function Ei(t,i,r,u){i!=fl&&(g.fillStyle=fl=i),t!=Tn&&(g.font=Tn=t),r!=Mn&&(g.textAlign=Mn=r),u!=En&&(g.textBaseline=En=u)}function An(t,i,r,u,f=0){if(u.length>
0&&t.auto(n,zl)&&(i==null||i.min==null)){let m=ne(Le,0),b=ne(Ce,u.length-1),v=r.min==null?Fr(u,m,b,f,t.distr==3):[r.min,r.max];t.min=bt(t.min,r.min=v[0]),t.max=
Ue(t.max,r.max=v[1])}}let Ai={min:null,max:null};function Ys(){for(let u in y){let f=y[u];H[u]==null&&(f.min==null||H[C]!=null&&f.auto(n,zl))&&(H[u]=Ai)}for(let u in y){
let f=y[u];H[u]==null&&f.from!=null&&H[f.from]!=null&&(H[u]=Ai)}H[C]!=null&&pl(!0);let t={};for(let u in H){let f=H[u];if(f!=null){let m=t[u]=Ml(y[u],$r);if(f.min!=
null)ke(m,f);else if(u!=C||s==2)if(Fe==0&&m.from==null){let b=m.range(n,null,null,u);m.min=b[0],m.max=b[1]}else m.min=ae,m.max=-ae}}if(Fe>0){_.forEach((u,f)=>{if(s==
1){let m=u.scale,b=H[m];if(b==null)return;let v=t[m];if(f==0){let S=v.range(n,v.min,v.max,m);v.min=S[0],v.max=S[1],Le=wt(v.min,l[0]),Ce=wt(v.max,l[0]),Ce-Le>1&&
(l[0][Le]<v.min&&Le++,l[0][Ce]>v.max&&Ce--),u.min=dt[Le],u.max=dt[Ce]}else u.show&&u.auto&&An(v,b,u,l[f],u.sorted);u.idxs[0]=Le,u.idxs[1]=Ce}else if(f>0&&u.show&&
u.auto){let[m,b]=u.facets,v=m.scale,S=b.scale,[T,E]=l[f],L=t[v],B=t[S];L!=null&&An(L,H[v],m,T,m.sorted),B!=null&&An(B,H[S],b,E,b.sorted),u.min=b.min,u.max=b.max}});
for(let u in t){let f=t[u],m=H[u];if(f.from==null&&(m==null||m.min==null)){let b=f.range(n,f.min==ae?null:f.min,f.max==-ae?null:f.max,u);f.min=b[0],f.max=b[1]}}}
for(let u in t){let f=t[u];if(f.from!=null){let m=t[f.from];if(m.min==null)f.min=f.max=null;else{let b=f.range(n,m.min,m.max,u);f.min=b[0],f.max=b[1]}}}let i={},
r=!1;for(let u in t){let f=t[u],m=y[u];if(m.min!=f.min||m.max!=f.max){m.min=f.min,m.max=f.max;let b=m.distr;m._min=b==3?Dt(m.min):b==4?Yn(m.min,m.asinh):b==100?
m.fwd(m.min):m.min,m._max=b==3?Dt(m.max):b==4?Yn(m.max,m.asinh):b==100?m.fwd(m.max):m.max,i[u]=r=!0}}if(r){_.forEach((u,f)=>{s==2?f>0&&i.y&&(u._paths=null):i[u.
scale]&&(u._paths=null)});for(let u in i)sl=!0,Re("setScale",u);We&&R.left>=0&&(Yt=ot=!0)}for(let u in H)H[u]=null}function Us(t){let i=Qn(Le-1,0,Fe-1),r=Qn(Ce+
1,0,Fe-1);for(;t[i]==null&&i>0;)i--;for(;t[r]==null&&r<Fe-1;)r++;return[i,r]}function $s(){if(Fe>0){let t=_.some(i=>i._focus)&&Ke!=St.alpha;t&&(g.globalAlpha=Ke=
St.alpha),_.forEach((i,r)=>{if(r>0&&i.show&&(Pi(r,!1),Pi(r,!0),i._paths==null)){let u=Ke;Ke!=i.alpha&&(g.globalAlpha=Ke=i.alpha);let f=s==2?[0,l[r][0].length-1]:
Us(l[r]);i._paths=i.paths(n,r,f[0],f[1]),Ke!=u&&(g.globalAlpha=Ke=u)}}),_.forEach((i,r)=>{if(r>0&&i.show){let u=Ke;Ke!=i.alpha&&(g.globalAlpha=Ke=i.alpha),i._paths!=
null&&Di(r,!1);{let f=i._paths!=null?i._paths.gaps:null,m=i.points.show(n,r,Le,Ce,f),b=i.points.filter(n,r,m,f);(m||b)&&(i.points._paths=i.points.paths(n,r,Le,Ce,
b),Di(r,!0))}Ke!=u&&(g.globalAlpha=Ke=u),Re("drawSeries",r)}}),t&&(g.globalAlpha=Ke=1)}}function Pi(t,i){let r=i?_[t].points:_[t];r._stroke=r.stroke(n,t),r._fill=
r.fill(n,t)}function Di(t,i){let r=i?_[t].points:_[t],{stroke:u,fill:f,clip:m,flags:b,_stroke:v=r._stroke,_fill:S=r._fill,_width:T=r.width}=r._paths;T=fe(T*oe,3);
let E=null,L=T%2/2;i&&S==null&&(S=T>0?"#fff":v);let B=r.pxAlign==1&&L>0;if(B&&g.translate(L,L),!i){let ie=Je-T/2,le=it-T/2,Z=je+T,G=pt+T;E=new Path2D,E.rect(ie,
le,Z,G)}i?Pn(v,T,r.dash,r.cap,S,u,f,b,m):js(t,v,T,r.dash,r.cap,S,u,f,b,E,m),B&&g.translate(-L,-L)}function js(t,i,r,u,f,m,b,v,S,T,E){let L=!1;S!=0&&K.forEach((B,ie)=>{
if(B.series[0]==t){let le=_[B.series[1]],Z=l[B.series[1]],G=(le._paths||Yl).band;Ot(G)&&(G=B.dir==1?G[0]:G[1]);let V,me=null;le.show&&G&&Hr(Z,Le,Ce)?(me=B.fill(
n,ie)||m,V=le._paths.clip):G=null,Pn(i,r,u,f,me,b,v,S,T,E,V,G),L=!0}}),L||Pn(i,r,u,f,m,b,v,S,T,E)}let Li=El|ti;function Pn(t,i,r,u,f,m,b,v,S,T,E,L){Mi(t,i,r,u,f),
(S||T||L)&&(g.save(),S&&g.clip(S),T&&g.clip(T)),L?(v&Li)==Li?(g.clip(L),E&&g.clip(E),Ql(f,b),Zl(t,m,i)):v&ti?(Ql(f,b),g.clip(L),Zl(t,m,i)):v&El&&(g.save(),g.clip(
L),E&&g.clip(E),Ql(f,b),g.restore(),Zl(t,m,i)):(Ql(f,b),Zl(t,m,i)),(S||T||L)&&g.restore()}function Zl(t,i,r){r>0&&(i instanceof Map?i.forEach((u,f)=>{g.strokeStyle=
Jl=f,g.stroke(u)}):i!=null&&t&&g.stroke(i))}function Ql(t,i){i instanceof Map?i.forEach((r,u)=>{g.fillStyle=fl=u,g.fill(r)}):i!=null&&t&&g.fill(i)}function Ks(t,i,r,u){
let f=A[t],m;if(u<=0)m=[0,0];else{let b=f._space=f.space(n,t,i,r,u),v=f._incrs=f.incrs(n,t,i,r,u,b);m=sc(i,r,v,u,b)}return f._found=m}function Dn(t,i,r,u,f,m,b,v,S,T){
let E=b%2/2;z==1&&g.translate(E,E),Mi(v,b,S,T,v),g.beginPath();let L,B,ie,le,Z=f+(u==0||u==3?-m:m);r==0?(B=f,le=Z):(L=f,ie=Z);for(let G=0;G<t.length;G++)i[G]!=null&&
(r==0?L=ie=t[G]:B=le=t[G],g.moveTo(L,B),g.lineTo(ie,le));g.stroke(),z==1&&g.translate(-E,-E)}function qs(t){let i=!0;return A.forEach((r,u)=>{if(!r.show)return;
let f=y[r.scale];if(f.min==null){r._show&&(i=!1,r._show=!1,pl(!1));return}else r._show||(i=!1,r._show=!0,pl(!1));let m=r.side,b=m%2,{min:v,max:S}=f,[T,E]=Ks(u,v,
S,b==0?$:P);if(E==0)return;let L=f.distr==2,B=r._splits=r.splits(n,u,v,S,T,E,L),ie=f.distr==2?B.map(V=>dt[V]):B,le=f.distr==2?dt[B[1]]-dt[B[0]]:T,Z=r._values=r.
values(n,r.filter(n,ie,u,E,le),u,E,le);r._rotate=m==2?r.rotate(n,Z,u,E):0;let G=r._size;r._size=at(r.size(n,Z,u,t)),G!=null&&r._size!=G&&(i=!1)}),i}function Js(t){
let i=!0;return ki.forEach((r,u)=>{let f=r(n,u,$t,t);f!=zt[u]&&(i=!1),zt[u]=f}),i}function Zs(){for(let t=0;t<A.length;t++){let i=A[t];if(!i.show||!i._show)continue;
let r=i.side,u=r%2,f,m,b=i.stroke(n,t),v=r==0||r==3?-1:1,[S,T]=i._found;if(i.label!=null){let Be=i.labelGap*v,Xe=Ee((i._lpos+Be)*oe);Ei(i.labelFont[0],b,"center",
r==2?"top":eo),g.save(),u==1?(f=m=0,g.translate(Xe,Ee(it+pt/2)),g.rotate((r==3?-sn:sn)/2)):(f=Ee(Je+je/2),m=Xe);let qt=Yo(i.label)?i.label(n,t,S,T):i.label;g.fillText(
qt,f,m),g.restore()}if(T==0)continue;let E=y[i.scale],L=u==0?je:pt,B=u==0?Je:it,ie=i._splits,le=E.distr==2?ie.map(Be=>dt[Be]):ie,Z=E.distr==2?dt[ie[1]]-dt[ie[0]]:
S,G=i.ticks,V=i.border,me=G.show?G.size:0,Se=Ee(me*oe),Ve=Ee((i.alignTo==2?i._size-me-i.gap:i.gap)*oe),ce=i._rotate*-sn/180,_e=O(i._pos*oe),Ze=(Se+Ve)*v,Ie=_e+Ze;
m=u==0?Ie:0,f=u==1?Ie:0;let rt=i.font[0],ht=i.align==1?Sl:i.align==2?Gn:ce>0?Sl:ce<0?Gn:u==0?"center":r==3?Gn:Sl,kt=ce||u==1?"middle":r==2?"top":eo;Ei(rt,b,ht,kt);
let Qe=i.font[1]*i.lineGap,ut=ie.map(Be=>O(p(Be,E,L,B))),mt=i._values;for(let Be=0;Be<mt.length;Be++){let Xe=mt[Be];if(Xe!=null){u==0?f=ut[Be]:m=ut[Be],Xe=""+Xe;
let qt=Xe.indexOf("\n")==-1?[Xe]:Xe.split(/\n/gm);for(let Ye=0;Ye<qt.length;Ye++){let Ji=qt[Ye];ce?(g.save(),g.translate(f,m+Ye*Qe),g.rotate(ce),g.fillText(Ji,0,
0),g.restore()):g.fillText(Ji,f,m+Ye*Qe)}}}G.show&&Dn(ut,G.filter(n,le,t,T,Z),u,r,_e,Se,fe(G.width*oe,3),G.stroke(n,t),G.dash,G.cap);let Tt=i.grid;Tt.show&&Dn(ut,
Tt.filter(n,le,t,T,Z),u,u==0?2:1,u==0?it:Je,u==0?pt:je,fe(Tt.width*oe,3),Tt.stroke(n,t),Tt.dash,Tt.cap),V.show&&Dn([_e],[1],u==0?1:0,u==0?1:2,u==1?it:Je,u==1?pt:
je,fe(V.width*oe,3),V.stroke(n,t),V.dash,V.cap)}Re("drawAxes")}function pl(t){_.forEach((i,r)=>{r>0&&(i._paths=null,t&&(s==1?(i.min=null,i.max=null):i.facets.forEach(
u=>{u.min=null,u.max=null})))})}let Xl=!1,Ln=!1,Nl=[];function Qs(){Ln=!1;for(let t=0;t<Nl.length;t++)Re(...Nl[t]);Nl.length=0}function dl(){Xl||(Xr(Ci),Xl=!0)}
function Xs(t,i=!1){Xl=!0,Ln=i,t(n),Ci(),i&&Nl.length>0&&queueMicrotask(Qs)}n.batch=Xs;function Ci(){if(bn&&(Ys(),bn=!1),sl&&(Fs(),sl=!1),jl){if(ge(D,Sl,pe),ge(
D,"top",Me),ge(D,Wl,$),ge(D,Gl,P),ge(M,Sl,pe),ge(M,"top",Me),ge(M,Wl,$),ge(M,Gl,P),ge(w,Wl,At),ge(w,Gl,Gt),x.width=Ee(At*oe),x.height=Ee(Gt*oe),A.forEach(({_el:t,
_show:i,_size:r,_pos:u,side:f})=>{if(t!=null)if(i){let m=f===3||f===0?r:0,b=f%2==1;ge(t,b?"left":"top",u-m),ge(t,b?"width":"height",r),ge(t,b?"top":"left",b?Me:
pe),ge(t,b?"height":"width",b?P:$),Jn(t,Qt)}else et(t,Qt)}),Jl=fl=Sn=yn=kn=Tn=Mn=En=_n=null,Ke=1,Fl(!0),pe!=ol||Me!=It||$!=vt||P!=Bt){pl(!1);let t=$/vt,i=P/Bt;if(We&&
!Yt&&R.left>=0){R.left*=t,R.top*=i,hl&&Mt(hl,Ee(R.left),0,$,P),ml&&Mt(ml,0,Ee(R.top),$,P);for(let r=0;r<st.length;r++){let u=st[r];u!=null&&(cl[r]*=t,al[r]*=i,Mt(
u,at(cl[r]),at(al[r]),$,P))}}if(he.show&&!Kl&&he.left>=0&&he.width>0){he.left*=t,he.width*=t,he.top*=i,he.height*=i;for(let r in Fn)ge(bl,r,he[r])}ol=pe,It=Me,vt=
$,Bt=P}Re("setSize"),jl=!1}At>0&&Gt>0&&(g.clearRect(0,0,x.width,x.height),Re("drawClear"),U.forEach(t=>t()),Re("draw")),he.show&&Kl&&(en(he),Kl=!1),We&&Yt&&(Kt(
null,!0,!1),Yt=!1),J.show&&J.live&&ot&&(Rn(),ot=!1),d||(d=!0,n.status=1,Re("ready")),zl=!1,Xl=!1}n.redraw=(t,i)=>{sl=i||!1,t!==!1?Rt(C,k.min,k.max):dl()};function Cn(t,i){
let r=y[t];if(r.from==null){if(Fe==0){let u=r.range(n,i.min,i.max,t);i.min=u[0],i.max=u[1]}if(i.min>i.max){let u=i.min;i.min=i.max,i.max=u}if(Fe>1&&i.min!=null&&
i.max!=null&&i.max-i.min<1e-16)return;t==C&&r.distr==2&&Fe>0&&(i.min=wt(i.min,l[0]),i.max=wt(i.max,l[0]),i.min==i.max&&i.max++),H[t]=i,bn=!0,dl()}}n.setScale=Cn;
let zn,Nn,hl,ml,zi,Ni,gl,wl,Ri,Vi,de,xe,Nt=!1,Oe=R.drag,ze=Oe.x,Ne=Oe.y;We&&(R.x&&(zn=ct(yr,M)),R.y&&(Nn=ct(kr,M)),k.ori==0?(hl=zn,ml=Nn):(hl=Nn,ml=zn),de=R.left,
xe=R.top);let he=n.select=ke({show:!0,over:!0,left:0,width:0,top:0,height:0},e.select),bl=he.show?ct(_r,he.over?M:D):null;function en(t,i){if(he.show){for(let r in t)
he[r]=t[r],r in Fn&&ge(bl,r,t[r]);i!==!1&&Re("setSelect")}}n.setSelect=en;function er(t){if(_[t].show)Te&&Jn(ve[t],Qt);else if(Te&&et(ve[t],Qt),We){let r=ul?st[0]:
st[t];r!=null&&Mt(r,-10,-10,$,P)}}function Rt(t,i,r){Cn(t,{min:i,max:r})}function _t(t,i,r,u){i.focus!=null&&or(t),i.show!=null&&_.forEach((f,m)=>{m>0&&(t==m||t==
null)&&(f.show=i.show,er(m),s==2?(Rt(f.facets[0].scale,null,null),Rt(f.facets[1].scale,null,null)):Rt(f.scale,null,null),dl())}),r!==!1&&Re("setSeries",t,i),u&&
Ol("setSeries",n,t,i)}n.setSeries=_t;function tr(t,i){ke(K[t],i)}function lr(t,i){t.fill=X(t.fill||null),t.dir=ne(t.dir,-1),i=i??K.length,K.splice(i,0,t)}function nr(t){
t==null?K.length=0:K.splice(t,1)}n.addBand=lr,n.setBand=tr,n.delBand=nr;function ir(t,i){_[t].alpha=i,We&&st[t]!=null&&(st[t].style.opacity=i),Te&&ve[t]&&(ve[t].
style.opacity=i)}let Pt,Vt,jt,xl={focus:!0};function or(t){if(t!=jt){let i=t==null,r=St.alpha!=1;_.forEach((u,f)=>{if(s==1||f>0){let m=i||f==0||f==t;u._focus=i?
null:m,r&&ir(f,m?1:St.alpha)}}),jt=t,r&&dl()}}Te&&rl&&Ge(io,se,t=>{R._lock||(Ut(t),jt!=null&&_t(null,xl,!0,ye.setSeries))});function yt(t,i,r){let u=y[i];r&&(t=
t/oe-(u.ori==1?Me:pe));let f=$;u.ori==1&&(f=P,t=f-t),u.dir==-1&&(t=f-t);let m=u._min,b=u._max,v=t/f,S=m+(b-m)*v,T=u.distr;return T==3?kl(10,S):T==4?Gr(S,u.asinh):
T==100?u.bwd(S):S}function sr(t,i){let r=yt(t,C,i);return wt(r,l[0],Le,Ce)}n.valToIdx=t=>wt(t,l[0]),n.posToIdx=sr,n.posToVal=yt,n.valToPos=(t,i,r)=>y[i].ori==0?
a(t,y[i],r?je:$,r?Je:0):c(t,y[i],r?pt:P,r?it:0),n.setCursor=(t,i,r)=>{de=t.left,xe=t.top,Kt(null,i,r)};function Fi(t,i){ge(bl,Sl,he.left=t),ge(bl,Wl,he.width=i)}
function Oi(t,i){ge(bl,"top",he.top=t),ge(bl,Gl,he.height=i)}let Rl=k.ori==0?Fi:Oi,Vl=k.ori==1?Fi:Oi;function rr(){if(Te&&J.live)for(let t=s==2?1:0;t<_.length;t++){
if(t==0&&nt)continue;let i=J.values[t],r=0;for(let u in i)xt[t][r++].firstChild.nodeValue=i[u]}}function Rn(t,i){if(t!=null&&(t.idxs?t.idxs.forEach((r,u)=>{ue[u]=
r}):Ur(t.idx)||ue.fill(t.idx),J.idx=ue[0]),Te&&J.live){for(let r=0;r<_.length;r++)(r>0||s==1&&!nt)&&ur(r,ue[r]);rr()}ot=!1,i!==!1&&Re("setLegend")}n.setLegend=Rn;
function ur(t,i){let r=_[t],u=t==0&&j==2?dt:l[t],f;nt?f=r.values(n,t,i)??Ct:(f=r.value(n,i==null?null:u[i],t,i),f=f==null?Ct:{_:f}),J.values[t]=f}function Kt(t,i,r){
Ri=de,Vi=xe,[de,xe]=R.move(n,de,xe),R.left=de,R.top=xe,We&&(hl&&Mt(hl,Ee(de),0,$,P),ml&&Mt(ml,0,Ee(xe),$,P));let u,f=Le>Ce;Pt=ae,Vt=null;let m=k.ori==0?$:P,b=k.
ori==1?$:P;if(de<0||Fe==0||f){u=R.idx=null;for(let v=0;v<_.length;v++){let S=st[v];S!=null&&Mt(S,-10,-10,$,P)}rl&&_t(null,xl,!0,t==null&&ye.setSeries),J.live&&(ue.
fill(u),ot=!0)}else{let v,S,T;s==1&&(v=k.ori==0?de:xe,S=yt(v,C),u=R.idx=wt(S,l[0],Le,Ce),T=N(l[0][u],k,m,0));let E=-10,L=-10,B=0,ie=0,le=!0,Z="",G="";for(let V=s==
2?1:0;V<_.length;V++){let me=_[V],Se=ue[V],Ve=Se==null?null:s==1?l[V][Se]:l[V][1][Se],ce=R.dataIdx(n,V,u,S),_e=ce==null?null:s==1?l[V][ce]:l[V][1][ce];if(ot=ot||
_e!=Ve||ce!=Se,ue[V]=ce,V>0&&me.show){let Ze=ce==null?-10:ce==u?T:N(s==1?l[0][ce]:l[V][0][ce],k,m,0),Ie=_e==null?-10:I(_e,s==1?y[me.scale]:y[me.facets[1].scale],
b,0);if(rl&&_e!=null){let rt=k.ori==1?de:xe,ht=Ae(St.dist(n,V,ce,Ie,rt));if(ht<Pt){let kt=St.bias;if(kt!=0){let Qe=yt(rt,me.scale),ut=_e>=0?1:-1,mt=Qe>=0?1:-1;mt==
ut&&(mt==1?kt==1?_e>=Qe:_e<=Qe:kt==1?_e<=Qe:_e>=Qe)&&(Pt=ht,Vt=V)}else Pt=ht,Vt=V}}if(ot||ul){let rt,ht;k.ori==0?(rt=Ze,ht=Ie):(rt=Ie,ht=Ze);let kt,Qe,ut,mt,Tt,
Be,Xe=!0,qt=He.bbox;if(qt!=null){Xe=!1;let Ye=qt(n,V);ut=Ye.left,mt=Ye.top,kt=Ye.width,Qe=Ye.height}else ut=rt,mt=ht,kt=Qe=He.size(n,V);if(Be=He.fill(n,V),Tt=He.
stroke(n,V),ul)V==Vt&&Pt<=St.prox&&(E=ut,L=mt,B=kt,ie=Qe,le=Xe,Z=Be,G=Tt);else{let Ye=st[V];Ye!=null&&(cl[V]=ut,al[V]=mt,fo(Ye,kt,Qe,Xe),co(Ye,Be,Tt),Mt(Ye,at(ut),
at(mt),$,P))}}}}if(ul){let V=St.prox,me=jt==null?Pt<=V:Pt>V||Vt!=jt;if(ot||me){let Se=st[0];Se!=null&&(cl[0]=E,al[0]=L,fo(Se,B,ie,le),co(Se,Z,G),Mt(Se,at(E),at(
L),$,P))}}}if(he.show&&Nt)if(t!=null){let[v,S]=ye.scales,[T,E]=ye.match,[L,B]=t.cursor.sync.scales,ie=t.cursor.drag;if(ze=ie._x,Ne=ie._y,ze||Ne){let{left:le,top:Z,
width:G,height:V}=t.select,me=t.scales[L].ori,Se=t.posToVal,Ve,ce,_e,Ze,Ie,rt=v!=null&&T(v,L),ht=S!=null&&E(S,B);rt&&ze?(me==0?(Ve=le,ce=G):(Ve=Z,ce=V),_e=y[v],
Ze=N(Se(Ve,L),_e,m,0),Ie=N(Se(Ve+ce,L),_e,m,0),Rl(bt(Ze,Ie),Ae(Ie-Ze))):Rl(0,m),ht&&Ne?(me==1?(Ve=le,ce=G):(Ve=Z,ce=V),_e=y[S],Ze=I(Se(Ve,B),_e,b,0),Ie=I(Se(Ve+
ce,B),_e,b,0),Vl(bt(Ze,Ie),Ae(Ie-Ze))):Vl(0,b)}else On()}else{let v=Ae(Ri-zi),S=Ae(Vi-Ni);if(k.ori==1){let B=v;v=S,S=B}ze=Oe.x&&v>=Oe.dist,Ne=Oe.y&&S>=Oe.dist;let T=Oe.
uni;T!=null?ze&&Ne&&(ze=v>=T,Ne=S>=T,!ze&&!Ne&&(S>v?Ne=!0:ze=!0)):Oe.x&&Oe.y&&(ze||Ne)&&(ze=Ne=!0);let E,L;ze&&(k.ori==0?(E=gl,L=de):(E=wl,L=xe),Rl(bt(E,L),Ae(L-
E)),Ne||Vl(0,b)),Ne&&(k.ori==1?(E=gl,L=de):(E=wl,L=xe),Vl(bt(E,L),Ae(L-E)),ze||Rl(0,m)),!ze&&!Ne&&(Rl(0,0),Vl(0,0))}if(Oe._x=ze,Oe._y=Ne,t==null){if(r){if(qi!=null){
let[v,S]=ye.scales;ye.values[0]=v!=null?yt(k.ori==0?de:xe,v):null,ye.values[1]=S!=null?yt(k.ori==1?de:xe,S):null}Ol(In,n,de,xe,$,P,u)}if(rl){let v=r&&ye.setSeries,
S=St.prox;jt==null?Pt<=S&&_t(Vt,xl,!0,v):Pt>S?_t(null,xl,!0,v):Vt!=jt&&_t(Vt,xl,!0,v)}}ot&&(J.idx=u,Rn()),i!==!1&&Re("setCursor")}let Ft=null;Object.defineProperty(
n,"rect",{get(){return Ft==null&&Fl(!1),Ft}});function Fl(t=!1){t?Ft=null:(Ft=M.getBoundingClientRect(),Re("syncRect",Ft))}function Hi(t,i,r,u,f,m,b){R._lock||Nt&&
t!=null&&t.movementX==0&&t.movementY==0||(Vn(t,i,r,u,f,m,b,!1,t!=null),t!=null?Kt(null,!0,!0):Kt(i,!0,!1))}function Vn(t,i,r,u,f,m,b,v,S){if(Ft==null&&Fl(!1),Ut(
t),t!=null)r=t.clientX-Ft.left,u=t.clientY-Ft.top;else{if(r<0||u<0){de=-10,xe=-10;return}let[T,E]=ye.scales,L=i.cursor.sync,[B,ie]=L.values,[le,Z]=L.scales,[G,V]=ye.
match,me=i.axes[0].side%2==1,Se=k.ori==0?$:P,Ve=k.ori==1?$:P,ce=me?m:f,_e=me?f:m,Ze=me?u:r,Ie=me?r:u;if(le!=null?r=G(T,le)?p(B,y[T],Se,0):-10:r=Se*(Ze/ce),Z!=null?
u=V(E,Z)?p(ie,y[E],Ve,0):-10:u=Ve*(Ie/_e),k.ori==1){let rt=r;r=u,u=rt}}S&&(i==null||i.cursor.event.type==In)&&((r<=1||r>=$-1)&&(r=Jt(r,$)),(u<=1||u>=P-1)&&(u=Jt(
u,P))),v?(zi=r,Ni=u,[gl,wl]=R.move(n,r,u)):(de=r,xe=u)}let Fn={width:0,height:0,left:0,top:0};function On(){en(Fn,!1)}let Wi,Gi,Ii,Bi;function Yi(t,i,r,u,f,m,b){
Nt=!0,ze=Ne=Oe._x=Oe._y=!1,Vn(t,i,r,u,f,m,b,!0,!1),t!=null&&(Ge(Bn,Kn,Ui,!1),Ol(lo,n,gl,wl,$,P,null));let{left:v,top:S,width:T,height:E}=he;Wi=v,Gi=S,Ii=T,Bi=E}
function Ui(t,i,r,u,f,m,b){Nt=Oe._x=Oe._y=!1,Vn(t,i,r,u,f,m,b,!1,!0);let{left:v,top:S,width:T,height:E}=he,L=T>0||E>0,B=Wi!=v||Gi!=S||Ii!=T||Bi!=E;if(L&&B&&en(he),
Oe.setScale&&L&&B){let ie=v,le=T,Z=S,G=E;if(k.ori==1&&(ie=S,le=E,Z=v,G=T),ze&&Rt(C,yt(ie,C),yt(ie+le,C)),Ne)for(let V in y){let me=y[V];V!=C&&me.from==null&&me.
min!=ae&&Rt(V,yt(Z+G,V),yt(Z,V))}On()}else R.lock&&(R._lock=!R._lock,Kt(i,!0,t!=null));t!=null&&(il(Bn,Kn),Ol(Bn,n,de,xe,$,P,null))}function cr(t,i,r,u,f,m,b){if(R.
_lock)return;Ut(t);let v=Nt;if(Nt){let S=!0,T=!0,E=10,L,B;k.ori==0?(L=ze,B=Ne):(L=Ne,B=ze),L&&B&&(S=de<=E||de>=$-E,T=xe<=E||xe>=P-E),L&&S&&(de=de<gl?0:$),B&&T&&
(xe=xe<wl?0:P),Kt(null,!0,!0),Nt=!1}de=-10,xe=-10,ue.fill(null),Kt(null,!0,!0),v&&(Nt=v)}function $i(t,i,r,u,f,m,b){R._lock||(Ut(t),vn(),On(),t!=null&&Ol(oo,n,de,
xe,$,P,null))}function ji(){A.forEach(rc),xn(n.width,n.height,!0)}Xt(rn,yl,ji);let vl={};vl.mousedown=Yi,vl.mousemove=Hi,vl.mouseup=Ui,vl.dblclick=$i,vl.setSeries=
(t,i,r,u)=>{let f=ye.match[2];r=f(n,i,r),r!=-1&&_t(r,u,!0,!1)},We&&(Ge(lo,M,Yi),Ge(In,M,Hi),Ge(no,M,t=>{Ut(t),Fl(!1)}),Ge(io,M,cr),Ge(oo,M,$i),li.add(n),n.syncRect=
Fl);let tn=n.hooks=e.hooks||{};function Re(t,i,r){Ln?Nl.push([t,i,r]):t in tn&&tn[t].forEach(u=>{u.call(null,n,i,r)})}(e.plugins||[]).forEach(t=>{for(let i in t.
hooks)tn[i]=(tn[i]||[]).concat(t.hooks[i])});let Ki=(t,i,r)=>r,ye=ke({key:null,setSeries:!1,filters:{pub:wo,sub:wo},scales:[C,_[1]?_[1].scale:null],match:[bo,bo,
Ki],values:[null,null]},R.sync);ye.match.length==2&&ye.match.push(Ki),R.sync=ye;let qi=ye.key,Hn=hs(qi);function Ol(t,i,r,u,f,m,b){ye.filters.pub(t,i,r,u,f,m,b)&&
Hn.pub(t,i,r,u,f,m,b)}Hn.sub(n);function ar(t,i,r,u,f,m,b){ye.filters.sub(t,i,r,u,f,m,b)&&vl[t](null,i,r,u,f,m,b)}n.pub=ar;function fr(){Hn.unsub(n),li.delete(n),
Wt.clear(),Zn(rn,yl,ji),h.remove(),se?.remove(),Re("destroy")}n.destroy=fr;function Wn(){Re("init",e,l),Ti(l||e.data,!1),H[C]?Cn(C,H[C]):vn(),Kl=he.show&&(he.width>
0||he.height>0),Yt=ot=!0,xn(e.width,e.height)}return _.forEach(yi),A.forEach(Bs),o?o instanceof HTMLElement?(o.appendChild(h),Wn()):o(n,Wn):Wn(),n}Pe.assign=ke;
Pe.fmtNum=ci;Pe.rangeNum=un;Pe.rangeLog=fn;Pe.rangeAsinh=ri;Pe.orient=tl;Pe.pxRatio=oe;Pe.join=Qr;Pe.fmtDate=fi,Pe.tzDate=cu;Pe.sync=hs;{Pe.addGap=Uu,Pe.clipGaps=
hn;let e=Pe.paths={points:vs};e.linear=_s,e.stepped=Ku,e.bars=qu,e.spline=Zu}function Ms(){let e=getComputedStyle(document.documentElement),l=o=>e.getPropertyValue(o).trim();return{paper:l("--paper"),ink:l("--ink"),soft:l("--soft"),line:l(
"--line"),bad:l("--bad"),actual:l("--actual"),actual_more:l("--actual-more"),expected:l("--expected")}}function Es(e){matchMedia("(prefers-color-scheme: dark)").
addEventListener("change",e)}function De(e,l={},...o){let n=Object.assign(document.createElement(e),l);return n.append(...o),n}function bi(e){if(e==null)return"\
\u2013";let l=Math.abs(e);return l===0||l>=.1?"".concat(Number(e.toPrecision(4))," m"):l>=.001?"".concat(Number((e*1e3).toPrecision(4))," mm"):l>=1e-6?"".concat(
Number((e*1e6).toPrecision(4))," \xB5m"):"".concat(e.toExponential(2)," m")}function As(e){return e==null?"\u2013":"".concat(Number(e.toPrecision(5))," J")}var Ds=210,Ps=[{title:"Energy",unit:As,lines:[{label:"total",column:"total",source:"states"},{label:"potential",column:"potential",source:"track",dash:[7,4]},{label:"\
kinetic",column:"kinetic",source:"states",dash:[2,3]}]},{title:"Symmetry",unit:bi,lines:[{label:"lateral error",column:"lateral_max",source:"track"},{label:"col\
umn spread",column:"column_spread",source:"track",dash:[7,4]}]},{title:"Heights",unit:bi,lines:[{label:"highest",column:"height_max",source:"track"},{label:"mea\
n",column:"height_mean",source:"track",dash:[7,4]}]}],xi=e=>e===void 0||e.every(l=>l===null);function uc(e,l){let o=e.lines.filter(a=>!xi(l.actual?.[a.column])),
n=o.length>0?[[l.actual.step,...o.map(a=>l.actual[a.column])]]:[],s=[];for(let a of o){let c=l.expected[a.source];!c||xi(c[a.column])||(n.push([c.step,c[a.column]]),
s.push(a))}return{lines:o,rings:s,table:n.length>0?Pe.join(n):null}}function cc(e,l,o,n){let s=(p,d)=>e.unit(d),a=[n.actual,n.actual_more,n.soft],c=p=>a[l.indexOf(
p)];return[{label:"step"},...l.map(p=>({label:p.label,value:s,stroke:c(p),width:1.75,dash:p.dash,spanGaps:!0,points:{show:!1}})),...o.map(p=>({label:"".concat(p.
label,", expected"),value:s,stroke:n.expected,width:1.5,class:"ring",paths:()=>null,points:{show:!0,size:8,width:1.5,stroke:n.expected,fill:"transparent"}}))]}function ac(e,l,o){
return l===null||o===null?[0,1]:l===o?l===0?[-.001,.001]:[l-Math.abs(l)/10,o+Math.abs(o)/10]:Pe.rangeNum(l,o,.1,!0)}function fc(e,l){return o=>{if(e===null)return;
let n=Math.round(o.valToPos(e,"x",!0)),{top:s,height:a}=o.bbox,c=o.ctx;c.save(),c.strokeStyle=l.bad,c.lineWidth=devicePixelRatio,c.setLineDash([3*devicePixelRatio,
3*devicePixelRatio]),c.beginPath(),c.moveTo(n,s),c.lineTo(n,s+a),c.stroke(),c.restore()}}function pc(e,l){let o={stroke:l.soft,grid:{stroke:l.line,width:1},ticks:{
stroke:l.line,width:1}},n=(s,a)=>a.map(c=>c===null?"":e.unit(c));return[{...o,label:"step",labelSize:20,size:36},{...o,values:n,size:82}]}function dc(e,l,o,n){let{
lines:s,rings:a,table:c}=uc(e,o);if(c===null)return null;let p=Ms(),d={width:l.clientWidth,height:Ds,scales:{x:{time:!1},y:{range:ac}},legend:{markers:{width:2,
dash:(h,x)=>h.series[x].dash?"dashed":"solid"}},axes:pc(e,p),series:cc(e,s,a,p),hooks:{draw:[fc(n,p)]},cursor:{y:!1,drag:{x:!0,y:!1}}};return new Pe(d,c,l)}function hc(e,l){
let o=e.lines.filter(n=>!xi(l.actual?.[n.column])).map(n=>{let s=l.actual[n.column].at(-1),a=l.expected[n.source]?.[n.column]?.at(-1);return"".concat(n.label," \
at the end ").concat(e.unit(s),", expected ").concat(e.unit(a))});return"".concat(e.title," over steps: ").concat(o.join("; "))}function Ls(e,l,o){let n="Lines:\
 this run. Rings: expected, where the golden keeps it (positions to the millimetre)."+(o===null?"":" Dashed upright line: first difference, step ".concat(o,"."))+
" Drag across a plot to zoom, double-click to zoom out.",s=De("div",{className:"plots"}),a=Ps.map(d=>{let h=De("div",{className:"plot"});return h.setAttribute("\
role","img"),h.setAttribute("aria-label",hc(d,l)),s.append(De("figure",{},De("figcaption",{textContent:d.title}),h)),h});e.append(De("h3",{textContent:"Over the\
 steps"}),De("p",{className:"soft",textContent:n}),s);let c=[],p=()=>{for(let d of c)d?.destroy();c=Ps.map((d,h)=>dc(d,a[h],l,o)),c.forEach((d,h)=>{a[h].parentElement.
hidden=d===null})};return p(),{redraw:p,resize(){c.forEach((d,h)=>{let x=a[h].clientWidth;d!==null&&x>0&&x!==d.width&&d.setSize({width:x,height:Ds})})},show_step(d){
for(let h of c)h?.setCursor({left:h.valToPos(d,"x"),top:0})}}}var mc=700,vi=(e,l)=>De("img",{src:e.querySelector("img").src,alt:"".concat(l," picture")});function Cs(e){let l=A=>e.querySelector('figure[data-kind="'.concat(
A,'"]'));if(!l("expected")||!l("actual"))return;let o=vi(l("expected"),"expected"),n=vi(l("actual"),"actual"),s=l("difference")?vi(l("difference"),"difference"):
null;n.className="over";let a=De("div",{className:"edge"}),c=De("span",{className:"tag",textContent:"expected"}),p=De("span",{className:"tag right",textContent:"\
actual"}),d=De("div",{className:"stack"},o,n,a,c,p),h=De("input",{type:"range",min:0,max:100,value:50,className:"picture-slider"});h.setAttribute("aria-label","\
step ".concat(e.dataset.step,": expected to the left of the edge, actual to the right"));let x=De("output"),g=De("button",{type:"button",textContent:"Blink",className:"\
picture-blink"}),w=De("button",{type:"button",textContent:"Difference"});s&&(s.className="over",d.append(s));let D=null,M=!1,z=A=>{n.style.clipPath="inset(0 0 0\
 ".concat(A,"%)"),a.style.left="".concat(A,"%"),a.hidden=A<=0||A>=100||M,c.hidden=A<=0||M,p.hidden=A>=100||M,s&&(s.hidden=!M),M?x.value="difference: the brighte\
r, the further apart":A>=100?x.value="expected":A<=0?x.value="actual":x.value="left of the edge expected, right of it actual"},O=()=>{clearInterval(D),D=null,g.
setAttribute("aria-pressed","false")},W=A=>{M=A,w.setAttribute("aria-pressed",String(A))};h.addEventListener("input",()=>{O(),W(!1),z(Number(h.value))}),g.addEventListener(
"click",()=>{let A=D!==null;if(O(),W(!1),A)return z(Number(h.value));let y=!0;g.setAttribute("aria-pressed","true"),z(100),D=setInterval(()=>{y=!y,z(y?100:0)},mc)}),
w.addEventListener("click",()=>{O(),W(!M),z(Number(h.value))}),O(),W(!1),z(50);let _=De("div",{className:"controls"},h,g,...s?[w]:[],x);e.prepend(De("div",{className:"\
viewer"},d,_))}function zs(){return null}function gc(e){let l=JSON.parse(e.querySelector("script").textContent);e.replaceChildren();let o=e.dataset.first===void 0?null:Number(e.dataset.first),n=Ls(e,l,
o),s=zs(e,l,n.show_step);Es(()=>{n.redraw(),s?.redraw()}),new ResizeObserver(()=>{n.resize(),s?.resize()}).observe(e)}function wc(e,l){let o=new IntersectionObserver(
n=>{n.some(s=>s.isIntersecting)&&(o.disconnect(),l(e))},{rootMargin:"200px"});o.observe(e)}function Ns(e){return l=>{try{e(l)}catch(o){let n=document.createElement(
"p");throw n.textContent="This cannot be drawn: ".concat(o.message),l.append(n),o}}}var Rs=document.createElement("style");Rs.textContent=Zi+Qi;document.head.append(
Rs);for(let e of document.querySelectorAll(".drawing"))wc(e,Ns(gc));for(let e of document.querySelectorAll(".pictures"))Ns(Cs)(e);})();
